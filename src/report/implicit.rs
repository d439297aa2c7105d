//! Implicit equations as people read them.

use super::entry::Entry;
use super::formula::Notation;
use crate::exact::{Rational, Surd};
use crate::implicit::Parameters;
use crate::quadric::{QuadricClass, QuadricSurface};
use crate::symbolic::Symbol;
use crate::syntax::printer;
use crate::value::ImplicitFinding;
use num_traits::{Signed, Zero};

fn point(coordinates: &[Rational], notation: &Notation) -> String {
    let texts: Vec<String> = coordinates.iter().map(|c| printer::rational(c, notation.style)).collect();
    printer::point(&texts, notation.style)
}

/// The equation of a curve, and what was asked about points.
pub(super) fn curve(found: &ImplicitFinding, notation: &Notation) -> Vec<Entry> {
    let letters = ['x', 'y'].map(|letter| Symbol::new(letter, None));
    let implicit = &found.implicit;
    let equation = format!("{} = 0", printer::polynomial(&implicit.polynomial(), &letters, notation.style));
    let mut lines = vec![Entry::new("equation").with(equation)];
    let kind = match (found.conic, implicit.degree()) {
        (Some(conic), _) => format!(", {}", conic.name().replace('_', " ")),
        (None, 1) => ", line".to_owned(),
        (None, _) => String::new(),
    };
    lines.push(Entry::remark("degree", format!("{}{kind}", implicit.degree())));
    let index = implicit.index();
    lines.push(Entry::remark(
        "tracing index",
        if index == 1 { "1".to_owned() } else { format!("{index}: a general point has {index} complex parameters") },
    ));
    if let Some(at_infinity) = found.curve.point_at_infinity() {
        let coordinates: Vec<String> = at_infinity.iter().map(|c| printer::rational(c, notation.style)).collect();
        lines.push(Entry::new("point at infinity").with(format!("[0; {}]", coordinates.join(", "))));
    }
    if let Some((at, value)) = &found.gauge {
        let sign = if value.is_zero() {
            "zero: the equation holds"
        } else if value.is_positive() {
            "positive"
        } else {
            "negative"
        };
        let surd = Surd::from(value);
        let number = format!("{}{}", notation.surd(&surd), notation.decimals_of(&[surd]));
        lines.push(Entry::new("gauge").with(format!("P{} = {number}", point(at, notation))).with_remark(sign));
    }
    if let Some((at, parameters)) = &found.membership {
        lines.extend(membership(found, at, parameters, notation));
    }
    lines
}

fn membership(found: &ImplicitFinding, at: &[Rational], parameters: &Parameters, notation: &Notation) -> Vec<Entry> {
    let name = point(at, notation);
    let Parameters::These(list) = parameters else {
        return vec![Entry::new("contains").with(name).with_remark("yes, at every parameter")];
    };
    if list.is_empty() {
        let holds = match at {
            [x, y] => found.implicit.gauge(&[x.clone(), y.clone()]).is_zero(),
            _ => false,
        };
        // Traced once, every real branch is reached but in isolated points; traced twice, half a branch may be missing.
        let remark = match (holds, found.implicit.index()) {
            (false, _) => "no",
            (true, 1) => "no, although the equation holds: it is an isolated point of it",
            (true, _) => "no, although the equation holds: no real parameter reaches it",
        };
        return vec![Entry::new("contains").with(name).with_remark(remark)];
    }
    let letter = printer::symbol(notation.variable, notation.style);
    let mut lines = vec![Entry::new("contains").with(name).with_remark("yes")];
    for parameter in list {
        lines.push(Entry::new("").with(format!("{letter} = {}", notation.algebraic(parameter, Symbol::new('x', None)))).below());
    }
    lines
}

/// The quadric of a surface.
pub(super) fn quadric(found: &QuadricSurface, notation: &Notation) -> Vec<Entry> {
    let class = match found.class {
        QuadricClass::NotAQuadric => "in no quadric".to_owned(),
        QuadricClass::Plane => "plane (or a part of one)".to_owned(),
        class => class.name().replace('_', " "),
    };
    let mut lines = vec![Entry::remark("class", class)];
    if let Some(polynomial) = found.polynomial() {
        let letters = ['x', 'y', 'z'].map(|letter| Symbol::new(letter, None));
        lines.push(Entry::new("equation").with(format!("{} = 0", printer::polynomial(&polynomial, &letters, notation.style))));
    }
    lines.push(Entry::remark("dimension of the affine span", found.affine_span.to_string()));
    lines.push(Entry::remark("dimension of the space of quadrics", found.quadrics.to_string()));
    lines
}
