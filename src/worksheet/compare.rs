//! Whether two values are equal, and how they differ.

use std::cmp::Ordering;
use std::collections::BTreeMap;

use num_traits::Zero;

use super::quantity::{Map, Order, Point, Quantity};
use crate::continuity::Continuity;
use crate::exact::Rational;
use crate::symbolic::{Monomial, Polynomial, Symbol};
use crate::syntax::printer::Style;
use crate::syntax::token::Comparison;

/// What a comparison found.
pub(super) enum Finding {
    Holds,
    Fails(Box<Difference>),
    /// The values cannot be compared: why.
    Mismatch(String),
}

/// How two values differ.
#[derive(Clone, Debug, Default, PartialEq)]
pub(super) struct Difference {
    /// The left side minus the right one, where that is a value.
    pub(super) value: Option<Quantity>,
    /// The places that differ.
    pub(super) entries: Vec<Entry>,
    /// A sentence where no difference can be computed.
    pub(super) note: Option<String>,
}

/// One number or polynomial that differs.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Entry {
    /// Where, in words; empty for a whole number or polynomial.
    pub(super) place: String,
    pub(super) left: Polynomial,
    pub(super) right: Polynomial,
    /// The symbols by whose powers the terms are told apart.
    pub(super) symbols: Vec<Symbol>,
}

impl Entry {
    /// The terms that differ: the monomial, and its coefficient on each side.
    pub(super) fn terms(&self) -> Vec<(Monomial, Polynomial, Polynomial)> {
        let difference = &self.left - &self.right;
        let split = |monomial: &Monomial| {
            let root = |symbol: Symbol| symbol.radicand().is_some();
            let of = |keep: bool| Monomial::from_factors(monomial.factors().iter().copied().filter(|factor| root(factor.0) == keep));
            (of(false), of(true))
        };
        // One pass over each side, however many terms differ.
        let mut terms: BTreeMap<Monomial, [Vec<(Monomial, Rational)>; 2]> = BTreeMap::new();
        for (monomial, _) in difference.terms() {
            terms.entry(split(monomial).0).or_default();
        }
        for (side, value) in [&self.left, &self.right].into_iter().enumerate() {
            for (monomial, number) in value.terms() {
                let (rest, roots) = split(monomial);
                if let Some(found) = terms.get_mut(&rest) {
                    found[side].push((roots, number.clone()));
                }
            }
        }
        let coefficients = terms.into_iter().rev();
        coefficients
            .map(|(monomial, sides)| {
                let [left, right] = sides.map(Polynomial::from_terms);
                (monomial, left, right)
            })
            .collect()
    }
}

/// Compares two values.
pub(super) fn compare(left: &Quantity, comparison: Comparison, right: &Quantity) -> Finding {
    let (left, right) = unified(left, right);
    match comparison {
        Comparison::Equal => equal(&left, &right),
        Comparison::NotEqual => match equal(&left, &right) {
            Finding::Holds => {
                Finding::Fails(Box::new(Difference { note: Some("both sides are the same".to_owned()), ..Difference::default() }))
            }
            Finding::Fails(_) => Finding::Holds,
            mismatch => mismatch,
        },
        _ => ordered(&left, comparison, &right),
    }
}

/// The two sides as values of one kind, where there is a way.
fn unified(left: &Quantity, right: &Quantity) -> (Quantity, Quantity) {
    let one = |value: &Quantity, other: &Quantity| match (value, other) {
        (Quantity::Number(polynomial), Quantity::Order(_)) => order_of(polynomial).map(Quantity::Order),
        (Quantity::Word("same"), Quantity::Order(_)) => Some(Quantity::Order(Order::Parametric(Continuity::Same))),
        (Quantity::Number(polynomial), Quantity::Equation(_)) => Some(Quantity::Equation(polynomial.clone())),
        (Quantity::Net(net), Quantity::List(other)) => Some(flattened_like(net.list(), other)),
        (Quantity::Map(map), Quantity::Number(_) | Quantity::Point(_)) if map.weight.is_none() => {
            Some(Quantity::point(map.components.clone()))
        }
        _ => None,
    };
    let changed = (one(left, right), one(right, left));
    (changed.0.unwrap_or_else(|| left.clone()), changed.1.unwrap_or_else(|| right.clone()))
}

/// A nested list as a flat one, if the other list is flat.
fn flattened_like(list: Quantity, other: &[Quantity]) -> Quantity {
    let is_flat = !other.iter().any(|item| matches!(item, Quantity::List(_)));
    match list {
        Quantity::List(rows) if is_flat && rows.iter().all(|row| matches!(row, Quantity::List(_))) => {
            let items = rows.into_iter().flat_map(|row| match row {
                Quantity::List(items) => items,
                other => vec![other],
            });
            Quantity::List(items.collect())
        }
        list => list,
    }
}

/// The order of continuity that `C1` or `G2` names.
fn order_of(value: &Polynomial) -> Option<Order> {
    let mut terms = value.terms();
    let (monomial, number) = terms.next()?;
    if terms.next().is_some() || !num_traits::One::is_one(number) {
        return None;
    }
    match monomial.factors() {
        [(symbol, 1)] if symbol.letter() == 'C' => Some(Order::Parametric(Continuity::C(symbol.index()? as usize))),
        [(symbol, 1)] if symbol.letter() == 'G' => Some(Order::Geometric(i64::from(symbol.index()?))),
        _ => None,
    }
}

fn fails(note: String) -> Finding {
    Finding::Fails(Box::new(Difference { note: Some(note), ..Difference::default() }))
}

fn equal(left: &Quantity, right: &Quantity) -> Finding {
    match (left, right) {
        (Quantity::Word(a), Quantity::Word(b)) => {
            if a == b {
                Finding::Holds
            } else {
                fails(format!("the left side is {a}, not {b}"))
            }
        }
        (Quantity::Equation(a), Quantity::Equation(b)) => proportional(a, b),
        (Quantity::Order(a), Quantity::Order(b)) => orders(a, Comparison::Equal, b),
        (Quantity::Map(a), Quantity::Map(b)) => maps(a, b),
        (Quantity::Net(a), Quantity::Net(b)) if std::mem::discriminant(&a.piece) == std::mem::discriminant(&b.piece) => {
            if a.frame() != b.frame() {
                return fails(format!("the nets have different frames: {} and {}", a.frame(), b.frame()));
            }
            equal(&a.list(), &b.list())
        }
        _ => {
            let mut entries = Vec::new();
            match walk(left, right, &mut Vec::new(), &mut entries) {
                Walk::Done if entries.is_empty() => Finding::Holds,
                Walk::Done => Finding::Fails(Box::new(Difference { value: minus(left, right), entries, note: None })),
                Walk::Sizes(note) => fails(note),
                Walk::Kinds(message) => Finding::Mismatch(message),
            }
        }
    }
}

/// What a walk through two values found.
enum Walk {
    Done,
    /// They have different sizes.
    Sizes(String),
    /// They are of different kinds.
    Kinds(String),
}

fn walk(left: &Quantity, right: &Quantity, place: &mut Vec<usize>, entries: &mut Vec<Entry>) -> Walk {
    let whole = |place: &[usize]| if place.is_empty() { String::new() } else { format!(" at {}", indices(place)) };
    match (left, right) {
        (Quantity::Number(a), Quantity::Number(b)) => {
            note(a, b, indices(place), entries);
            Walk::Done
        }
        (Quantity::Point(a), Quantity::Point(b)) => {
            if a.coordinates.len() != b.coordinates.len() {
                return Walk::Sizes(format!(
                    "the points{} have {} and {} coordinates",
                    whole(place),
                    a.coordinates.len(),
                    b.coordinates.len()
                ));
            }
            points(a, b, &indices(place), entries);
            Walk::Done
        }
        (Quantity::List(a), Quantity::List(b)) => {
            if a.len() != b.len() {
                return Walk::Sizes(format!("the lists{} have {} and {} entries", whole(place), a.len(), b.len()));
            }
            for (index, (x, y)) in a.iter().zip(b).enumerate() {
                place.push(index);
                let found = walk(x, y, place, entries);
                place.pop();
                if !matches!(found, Walk::Done) {
                    return found;
                }
            }
            Walk::Done
        }
        (Quantity::Net(net), Quantity::List(list)) => walk(&flattened_like(net.list(), list), right, place, entries),
        (Quantity::List(list), Quantity::Net(net)) => walk(left, &flattened_like(net.list(), list), place, entries),
        (Quantity::Net(a), Quantity::Net(b)) => walk(&a.list(), &b.list(), place, entries),
        (Quantity::Word(a), Quantity::Word(b)) if a == b => Walk::Done,
        (Quantity::Word(a), Quantity::Word(b)) => Walk::Sizes(format!("{a} is not {b}")),
        (left, right) => {
            Walk::Kinds(format!("found {} and {}{}, expected two values of one kind", left.kind(), right.kind(), whole(place)))
        }
    }
}

fn indices(place: &[usize]) -> String {
    place.iter().map(|index| format!("[{index}]")).collect()
}

fn note(left: &Polynomial, right: &Polynomial, place: String, entries: &mut Vec<Entry>) {
    if left != right {
        entries.push(Entry { place, left: left.clone(), right: right.clone(), symbols: Vec::new() });
    }
}

fn points(a: &Point, b: &Point, place: &str, entries: &mut Vec<Entry>) {
    let join = |part: String| if place.is_empty() { part } else { format!("{place}, {part}") };
    for (index, (x, y)) in a.coordinates.iter().zip(&b.coordinates).enumerate() {
        note(x, y, join(format!("coordinate {}", index + 1)), entries);
    }
    let one = <Polynomial as num_traits::One>::one();
    let (v, w) = (a.weight.as_ref().unwrap_or(&one), b.weight.as_ref().unwrap_or(&one));
    note(v, w, join("the weight".to_owned()), entries);
}

/// The difference of two values, where it is a value.
fn minus(left: &Quantity, right: &Quantity) -> Option<Quantity> {
    match (left, right) {
        (Quantity::Number(a), Quantity::Number(b)) => Some(Quantity::from(a - b)),
        (Quantity::Point(a), Quantity::Point(b)) => {
            Some(Quantity::point(a.coordinates.iter().zip(&b.coordinates).map(|(x, y)| x - y).collect()))
        }
        (Quantity::List(a), Quantity::List(b)) => a.iter().zip(b).map(|(x, y)| minus(x, y)).collect::<Option<_>>().map(Quantity::List),
        (Quantity::Net(net), other) => minus(&net.list(), other),
        (other, Quantity::Net(net)) => minus(other, &net.list()),
        _ => None,
    }
}

/// Whether two equations are multiples of each other.
fn proportional(left: &Polynomial, right: &Polynomial) -> Finding {
    let leading = |value: &Polynomial| value.terms().next().map(|(monomial, number)| (monomial.clone(), number.clone()));
    let (Some((_, a)), Some((_, b))) = (leading(left), leading(right)) else {
        return if left.is_zero() == right.is_zero() { Finding::Holds } else { fails("one side is 0".to_owned()) };
    };
    let Some(factor) = a.checked_div(&b) else { return fails("one side is 0".to_owned()) };
    let scaled = right.scale(&factor);
    if *left == scaled {
        return Finding::Holds;
    }
    let mut entries = Vec::new();
    note(left, &scaled, String::new(), &mut entries);
    let value = Some(Quantity::Number(left - &scaled));
    let note = if num_traits::One::is_one(&factor) { None } else { Some(format!("the right side is taken times {factor}")) };
    Finding::Fails(Box::new(Difference { value, entries, note }))
}

/// Whether two maps are the same, whatever their letters.
fn maps(left: &Map, right: &Map) -> Finding {
    if left.variables.len() != right.variables.len() {
        return Finding::Mismatch("found a curve and a surface, expected two maps of one kind".to_owned());
    }
    if left.components.len() != right.components.len() {
        return fails(format!("the maps have {} and {} coordinates", left.components.len(), right.components.len()));
    }
    let right = super::function::with_letters(right.clone(), &left.variables);
    // As quotients: x / w = y / v where x v = y w.
    let one = <Polynomial as num_traits::One>::one();
    let (w, v) = (left.weight.as_ref().unwrap_or(&one), right.weight.as_ref().unwrap_or(&one));
    let mut entries = Vec::new();
    for (index, (x, y)) in left.components.iter().zip(&right.components).enumerate() {
        let place = if left.components.len() == 1 { String::new() } else { format!("coordinate {}", index + 1) };
        let (x, y) = if left.weight.is_none() && right.weight.is_none() { (x.clone(), y.clone()) } else { (x * v, y * w) };
        note(&x.with_simple_roots(), &y.with_simple_roots(), place, &mut entries);
    }
    for entry in &mut entries {
        entry.symbols.clone_from(&left.variables);
    }
    if entries.is_empty() {
        return Finding::Holds;
    }
    let value = left.components.iter().zip(&right.components).map(|(x, y)| x - y).collect();
    let is_polynomial = left.weight.is_none() && right.weight.is_none();
    Finding::Fails(Box::new(Difference { value: is_polynomial.then(|| Quantity::point(value)), entries, note: None }))
}

fn test(ordering: Ordering, comparison: Comparison) -> bool {
    match comparison {
        Comparison::Equal => ordering.is_eq(),
        Comparison::NotEqual => ordering.is_ne(),
        Comparison::Less => ordering.is_lt(),
        Comparison::LessOrEqual => ordering.is_le(),
        Comparison::Greater => ordering.is_gt(),
        Comparison::GreaterOrEqual => ordering.is_ge(),
    }
}

/// The order that was found against the one that is asked for, on either side.
fn orders(left: &Order, comparison: Comparison, right: &Order) -> Finding {
    let ordering = match (left, right) {
        (Order::Found { parametric: a, .. } | Order::Parametric(a), Order::Found { parametric: b, .. } | Order::Parametric(b)) => a.cmp(b),
        (Order::Found { geometric: Ok(found), .. } | Order::Geometric(found), Order::Geometric(wanted)) => found.cmp(wanted),
        (Order::Geometric(wanted), Order::Found { geometric: Ok(found), .. }) => wanted.cmp(found),
        (Order::Found { geometric: Err(why), .. }, _) | (_, Order::Found { geometric: Err(why), .. }) => {
            return Finding::Mismatch(why.clone());
        }
        (left, right) => {
            return Finding::Mismatch(format!("found {} and {}, which are no orders of one kind", left.shown(), right.shown()));
        }
    };
    let found = if matches!(left, Order::Found { .. }) { left } else { right };
    if test(ordering, comparison) { Finding::Holds } else { fails(format!("the join is {}", found.shown())) }
}

fn ordered(left: &Quantity, comparison: Comparison, right: &Quantity) -> Finding {
    match (left, right) {
        (Quantity::Order(a), Quantity::Order(b)) => orders(a, comparison, b),
        (Quantity::Number(a), Quantity::Number(b)) => match a.compare_numbers(b) {
            None => {
                let letter = (a - b).symbols().into_iter().find(|symbol| symbol.radicand().is_none());
                let letter = letter.map_or_else(String::new, |symbol| symbol.to_string());
                Finding::Mismatch(format!(
                    "found the symbolic parameter `{letter}`, expected numbers on both sides of `{}`",
                    comparison.sign()
                ))
            }
            Some(ordering) if test(ordering, comparison) => Finding::Holds,
            Some(_) => {
                let mut entries = Vec::new();
                note(a, b, String::new(), &mut entries);
                Finding::Fails(Box::new(Difference { value: minus(left, right), entries, note: None }))
            }
        },
        _ => Finding::Mismatch(format!(
            "found {} and {}, expected numbers or orders on both sides of `{}`",
            left.kind(),
            right.kind(),
            comparison.sign()
        )),
    }
}

impl Difference {
    /// The difference as a value, in one line.
    pub(super) fn shown(&self) -> Option<String> {
        self.value.as_ref().map(|value| value.shown(Style::Text)).or_else(|| self.note.clone())
    }
}
