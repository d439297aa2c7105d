//! Joins and their repairs as people read about them.

use super::entry::Entry;
use super::formula::Notation;
use super::spline::label_text;
use crate::continuity::Continuity;
use crate::exact::Rational;
use crate::geometric::{Directions, GeometricJoin, SingularJoint};
use crate::joint::{AffineGroup, JoinCondition, Joint};
use crate::meeting::Meeting;
use crate::quotient::Quotient;
use crate::roots::RootPlace;
use crate::symbolic::{Polynomial, Symbol};
use crate::syntax::{Style, printer};
use crate::tangent::{TangentPlaneJoin, Vanishing};
use crate::value::{Contact, JoinFinding, RepairFinding};
use crate::weights::projected;

/// Everything about a join.
pub(super) fn join(found: &JoinFinding, notation: &Notation) -> Vec<Entry> {
    let mut lines = vec![meeting(&found.meeting, notation)];
    if found.overlap {
        lines.push(Entry::remark("", "both pieces lie on one side of the joint and overlap: the orders are those of the maps"));
    }
    if let Some((homogeneous, scaled)) = found.homogeneous {
        lines.push(Entry::remark("in homogeneous space", order(homogeneous)));
        lines.push(Entry::remark("in homogeneous space, up to a factor", order(scaled)));
    }
    lines.extend(found.order.map(|found| Entry::remark("", order(found))));
    lines.extend(found.contact.as_ref().map(|contact| contact_line(contact, found.order, notation)));
    if let Some((word, met)) = found.requirement {
        lines.push(Entry::remark("", requirement(word, met, found)));
    }
    if let Some(repair) = &found.repair {
        lines.extend(repaired(repair, notation));
        return lines;
    }
    lines.extend(found.conditions.iter().map(|found| condition(found, notation)));
    if let Some((weights, list)) = &found.groups {
        lines.extend(groups(weights, list, notation));
    }
    lines
}

fn meeting(meeting: &Meeting, notation: &Notation) -> Entry {
    match meeting {
        Meeting::Joint(Joint::Parameter(at)) => Entry::new("").with(format!("s = {}", notation.number(at))),
        Meeting::Joint(Joint::Edge([s, t])) => {
            Entry::new("").with(format!("s = {}", notation.point(s))).with(format!("t = {}", notation.point(t)))
        }
        Meeting::Sides(own, other) => Entry::remark("", format!("{own} of the first piece and {other} of the second one")),
    }
}

fn order(found: Continuity) -> String {
    match found {
        Continuity::Same => "the same map".to_owned(),
        other => other.to_string(),
    }
}

/// The geometric continuity in one line.
fn contact_line(contact: &Contact, parametric: Option<Continuity>, notation: &Notation) -> Entry {
    let broken = parametric.is_some_and(|found| found == Continuity::Broken);
    match contact {
        Contact::Curves(join) if join.order.is_none() => {
            Entry::remark("", if broken { "not even G0: the points differ" } else { "not even G0" })
        }
        Contact::Curves(join) => curves(join, notation),
        Contact::Patches(join) => patches(join, notation),
    }
}

fn curves(join: &GeometricJoin, notation: &Notation) -> Entry {
    if let Some(singular) = join.singular {
        return Entry::remark("singular", singular_text(singular));
    }
    if join.reversed {
        return Entry::remark("", "G0: the tangents are opposite, the curves turn back");
    }
    let betas = join.betas.iter().enumerate().map(|(k, beta)| {
        let name = match notation.style {
            Style::Latex => format!("\\beta_{}", k + 1),
            _ => format!("β{}", k + 1),
        };
        format!("{name} = {}{}", notation.number(beta), notation.approximately(std::slice::from_ref(beta)))
    });
    match join.order {
        Some(0) | None => Entry::remark("", "G0: the tangents lie on different lines"),
        Some(order) => betas.fold(Entry::new(&format!("G{order}")), Entry::with),
    }
}

fn singular_text(SingularJoint { orders, directions }: SingularJoint) -> String {
    let name = |order: Option<usize>| order.map_or("none, it is a point".to_owned(), |order| format!("of order {order}"));
    let [first, second] = orders.map(name);
    let tangents = match directions {
        Some(Directions::Same) => "; the directions of the tangents are the same",
        Some(Directions::Opposite) => "; the directions of the tangents are opposite: a cusp",
        Some(Directions::Different) => "; the tangents lie on different lines",
        None => "",
    };
    format!("the first derivative of the first curve that is not zero is {first}, that of the second one {second}{tangents}")
}

fn patches(join: &TangentPlaneJoin, notation: &Notation) -> Entry {
    if !join.same_edge {
        return Entry::remark("", "not even G0: the edges differ");
    }
    if join.collapsed {
        return Entry::remark("degenerate", "the edge is one point, so there is no direction along it");
    }
    if join.coplanar == Some(false) {
        return Entry::remark("", "G0: the tangent planes differ");
    }
    let everywhere = |piece: usize| join.singular[piece] == Vanishing::Everywhere;
    if everywhere(0) || everywhere(1) {
        let which = ["first", "second"].into_iter().enumerate().filter(|(piece, _)| everywhere(*piece)).map(|(_, name)| name);
        let which = which.collect::<Vec<_>>().join(" and the ");
        return Entry::remark("singular", format!("the {which} patch has no tangent plane anywhere along the edge"));
    }
    let sides = join.opposite_sides == Some(true);
    let name = match join.g1() {
        Some(true) => "G1",
        None => "singular",
        Some(false) => "G0",
    };
    let mut remark = String::new();
    if join.g1() == Some(false) {
        remark.push_str("the tangent planes are the same, but the patches lie on one side of the edge: a fold");
    }
    if join.regular() == Some(false) {
        let places = |vanishing: &Vanishing| match vanishing {
            Vanishing::At(places) => places.iter().map(|place| root(place, notation)).collect::<Vec<_>>().join(" and "),
            Vanishing::Everywhere => String::new(),
        };
        let parts = ["first", "second"].into_iter().zip(&join.singular).filter(|(_, vanishing)| !vanishing.is_nowhere());
        let parts: Vec<String> = parts.map(|(name, vanishing)| format!("that of the {name} patch at {}", places(vanishing))).collect();
        let elsewhere = if sides { "; elsewhere the tangent planes are the same" } else { "" };
        remark.push_str(&format!("{}a normal vanishes, {}{elsewhere}", if remark.is_empty() { "" } else { "; " }, parts.join(" and ")));
    }
    let mut entry = Entry::new(name);
    let x = Symbol::new('x', None);
    let [lambda, mu] = if notation.style == Style::Latex { ["\\lambda", "\\mu"] } else { ["λ", "μ"] };
    for (letter, quotient) in [(lambda, &join.ratio), (mu, &join.shear)] {
        if let Some(found) = quotient.as_ref().filter(|found| letter == lambda || !found.numerator.is_empty()) {
            entry = entry.with(format!("{letter} = {}", quotient_text(found, x, notation)));
        }
    }
    let depends = [&join.ratio, &join.shear].into_iter().flatten().any(|found| found.constant().is_none());
    if depends {
        remark.push_str(&format!("{}x runs from 0 to 1 along the edge of the first patch", if remark.is_empty() { "" } else { "; " }));
    }
    if remark.is_empty() { entry } else { entry.with_remark(remark) }
}

fn root(place: &RootPlace, notation: &Notation) -> String {
    match place {
        RootPlace::Exact(at) => format!("x = {}", notation.number(at)),
        RootPlace::Between(low, high) => format!("{} < x < {}", notation.number(low), notation.number(high)),
    }
}

fn quotient_text(found: &Quotient, x: Symbol, notation: &Notation) -> String {
    if let Some(number) = found.constant() {
        return notation.number(&number);
    }
    let text = |list: &[Rational]| {
        let coefficients: Vec<Polynomial> = list.iter().cloned().map(Polynomial::from).collect();
        printer::polynomial(&Polynomial::from_coefficients(x, &coefficients), &[x], notation.style)
    };
    match (notation.style, found.denominator.as_slice()) {
        (_, [only]) if *only == Rational::from(1) => text(&found.numerator),
        (Style::Latex, _) => format!("\\frac{{{}}}{{{}}}", text(&found.numerator), text(&found.denominator)),
        _ => format!("({})/({})", text(&found.numerator), text(&found.denominator)),
    }
}

/// What was required, and what holds.
fn requirement(word: &str, met: bool, found: &JoinFinding) -> String {
    if met {
        return format!("{word} is required: it holds");
    }
    let reached = match (word.starts_with('C'), found.order, &found.contact) {
        (true, Some(order), _) => match order {
            Continuity::C(order) => format!("not met, C{order} holds"),
            other => format!("not met, {other}"),
        },
        (_, _, Some(contact)) => match contact.order() {
            None if matches!(contact, Contact::Patches(join) if join.collapsed) => "undecided, the edge is one point".to_owned(),
            None => "undecided, a normal vanishes".to_owned(),
            Some(-1) => "not met, not even G0".to_owned(),
            Some(order) => match contact {
                Contact::Curves(GeometricJoin { singular: Some(joint), .. }) if joint.directions == Some(Directions::Same) => {
                    format!("undecided beyond G{order}, a derivative vanishes")
                }
                Contact::Patches(join) if join.regular() == Some(false) && join.coplanar == Some(true) && join.opposite_sides.is_none() => {
                    format!("undecided beyond G{order}, there is no tangent plane")
                }
                _ => format!("not met, G{order} holds"),
            },
        },
        _ => "not met".to_owned(),
    };
    format!("{word} is required: {reached}")
}

/// A label such as `f(q,s)` as a value of another map.
fn value_of(map: char, label: &str) -> String {
    format!("{map}{}", label.trim_start_matches('f'))
}

fn condition(found: &JoinCondition, notation: &Notation) -> Entry {
    let (a, b) = (value_of('A', &found.label), value_of('B', &found.label));
    let (first, second) = (notation.point(&found.first), notation.point(&found.second));
    let latex = notation.style == Style::Latex;
    let sign = match (found.holds(), latex) {
        (true, _) => "=",
        (false, true) => "\\neq",
        (false, false) => "≠",
    };
    let space = if latex { ":\\;" } else { " " };
    let entry = Entry::new("").with(format!("{a} {sign} {b}{space} {first} {sign} {second}"));
    if found.holds() {
        return entry;
    }
    let defect = found.defect();
    entry.with(format!("{}{}{}", by(latex), notation.point(&defect), notation.approximately(&defect)))
}

fn by(latex: bool) -> &'static str {
    if latex { "\\text{by } " } else { "by " }
}

/// Continuity of order 1 as an affine image of the vertices.
fn groups(weights: &[Rational; 3], list: &[AffineGroup], notation: &Notation) -> Vec<Entry> {
    let symbols = ['p', 's', 't'].map(|letter| Polynomial::from(Symbol::new(letter, None)));
    let letters = ['p', 's', 't'].map(|letter| Symbol::new(letter, None));
    let sum = symbols.iter().zip(weights).fold(Polynomial::default(), |sum, (symbol, weight)| sum + &symbol.scale(weight));
    let mut lines = vec![Entry::new("").with(format!("q = {}", printer::polynomial(&sum, &letters, notation.style)))];
    for group in list {
        let with = |map: char, vertex: char| {
            if group.label.is_empty() { format!("{map}({vertex})") } else { format!("{map}({vertex},{})", group.label) }
        };
        let names = [('A', 'p'), ('A', 's'), ('A', 't'), ('B', 'q')];
        let mut line = Entry::new("");
        for ((map, vertex), point) in names.into_iter().zip(&group.points) {
            line = line.with(format!("{} = {}", with(map, vertex), notation.point(point)));
        }
        lines.push(line.with_remark(if group.holds { "an affine image of p, s, t, q" } else { "no affine image of p, s, t, q" }));
    }
    lines
}

fn repaired(found: &RepairFinding, notation: &Notation) -> Vec<Entry> {
    let latex = notation.style == Style::Latex;
    let arrow = if latex { "\\to" } else { "→" };
    let repair = &found.repair;
    let labels = found.before.labels();
    let (old, new): (Vec<&[Rational]>, Vec<&[Rational]>) = (found.before.points().collect(), repair.piece.points().collect());
    let point = |homogeneous: &[Rational]| {
        if found.rational { projected(homogeneous).unwrap_or_default() } else { homogeneous.to_vec() }
    };
    let mut lines = Vec::new();
    if repair.moved.is_empty() {
        lines.push(Entry::remark("", "nothing has to move"));
        return lines;
    }
    for &place in &repair.moved {
        let (from, to) = (point(old[place]), point(new[place]));
        let step: Vec<Rational> = to.iter().zip(&from).map(|(a, b)| a - b).collect();
        let moved = format!(
            "{}: {} {arrow} {}{}",
            label_text(&labels[place], notation),
            notation.point(&from),
            notation.point(&to),
            notation.approximately(&to)
        );
        lines.push(Entry::new("").with(moved).with(format!("{}{}", by(latex), notation.point(&step))));
    }
    let squares = format!("{}{}", notation.number(&repair.squares), notation.approximately(std::slice::from_ref(&repair.squares)));
    lines.push(Entry::new("sum of squared displacements").with(squares));
    if let Some((ratio, shear)) = &repair.ratio {
        let [lambda, mu] = if latex { ["\\lambda", "\\mu"] } else { ["λ", "μ"] };
        let mut line =
            Entry::new("").with(format!("{lambda} = {}{}", notation.number(ratio), notation.approximately(std::slice::from_ref(ratio))));
        if !shear.is_empty() {
            let quotient = Quotient { numerator: shear.clone(), denominator: vec![Rational::from(1)] };
            line = line.with(format!("{mu} = {}", quotient_text(&quotient, Symbol::new('x', None), notation)));
        }
        lines.push(line);
    }
    lines.push(Entry::remark("after the repair", found.reached.clone()));
    lines
}
