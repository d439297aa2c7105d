//! What went wrong: usual mistakes, each tried, and named only if the claim
//! holds once it is corrected.

mod literal;
mod order;
mod polar;

use num_traits::Zero;

use super::compare::{Finding, compare};
use super::evaluate::Evaluator;
use super::quantity::{Map, Quantity};
use super::scope::Scope;
use super::slip::{Counts, Exponents, Slip};
use crate::blossom::binomials;
use crate::reading::Reading;
use crate::symbolic::{Polynomial, Symbol};
use crate::syntax::expression::{Argument, Arguments, Callee, Expression, ExpressionKind};
use crate::syntax::parser::Parser;
use crate::syntax::token::Comparison;

/// A claim that fails, with all that is known of it.
pub(super) struct Case<'a> {
    pub(super) scope: &'a Scope,
    /// The text that the expressions are parts of.
    pub(super) source: &'a str,
    pub(super) left: (&'a Expression, &'a Quantity),
    pub(super) right: (&'a Expression, &'a Quantity),
}

/// The largest polar degree for which mistakes are looked for.
const MAX_DEGREE: usize = 10;

/// What explains the failure of a claim, if something does.
pub(super) fn diagnose(case: &Case<'_>, parser: &mut Parser<'_>) -> Option<String> {
    let found = literal::decimals(case, parser)
        .or_else(|| order::of_nets(case))
        .or_else(|| slips(case, parser))
        .or_else(|| order::exchanged(case))
        .or_else(|| literal::signs(case, parser))
        .or_else(|| factor(case));
    let defects = polar::defects(case);
    match (found, defects) {
        (Some(found), Some(defects)) => Some(format!("{found}; {defects}")),
        (found, defects) => found.or(defects),
    }
}

impl Case<'_> {
    /// Both sides in either order.
    fn sides(&self) -> [(&Expression, &Quantity, &Quantity); 2] {
        [(self.left.0, self.left.1, self.right.1), (self.right.0, self.right.1, self.left.1)]
    }

    /// Whether an expression has a value, with a mistake or without.
    fn value(&self, parser: &mut Parser<'_>, expression: &Expression, slip: Option<Slip>) -> Option<Quantity> {
        Evaluator { scope: self.scope, variables: &[], defining: None, slip }.evaluate(parser, expression).ok()
    }

    /// The shape whose polar form or points an expression is about, and how it is read.
    fn shape(&self, expression: &Expression) -> Option<(Map, Reading)> {
        let map_of = |symbol: Symbol, several: bool| {
            let callee = self.scope.callee(symbol, several);
            let base = callee.map_or(symbol, |callee| callee.base);
            match &self.scope.get(base)?.value {
                Quantity::Map(map) => Some(map.clone()),
                Quantity::Net(net) => net.map().ok(),
                _ => None,
            }
        };
        let read = |map: Map, by_total: bool| {
            let reading = match map.variables.len() {
                1 => Reading::Curve(map.curve().ok()?.degree()),
                _ => map.surface(by_total).ok()?.reading(),
            };
            Some((map, reading))
        };
        if let ExpressionKind::Call(call) = &expression.kind {
            match (&call.callee, &call.arguments) {
                (Callee::Name(symbol), Arguments::Polar(groups)) => return read(map_of(*symbol, true)?, groups.len() == 1),
                (Callee::Function("points" | "polar"), Arguments::Plain(arguments)) => {
                    let Some(Argument::Plain(Expression { kind: ExpressionKind::Symbol(symbol), .. })) = arguments.first() else {
                        return None;
                    };
                    let intervals = arguments.iter().filter(|argument| matches!(argument, Argument::Range(..))).count();
                    return read(map_of(*symbol, false)?, intervals < 2);
                }
                _ => {}
            }
        }
        expression.parts().into_iter().find_map(|part| self.shape(part))
    }
}

fn holds(left: &Quantity, right: &Quantity) -> bool {
    matches!(compare(left, Comparison::Equal, right), Finding::Holds)
}

/// Mistakes in computing one of the sides.
fn slips(case: &Case<'_>, parser: &mut Parser<'_>) -> Option<String> {
    for (expression, own, other) in case.sides() {
        if !calls_something(expression) {
            continue;
        }
        let shape = case.shape(expression);
        for (slip, text) in candidates(shape.as_ref()) {
            let Some(changed) = case.value(parser, expression, Some(slip)).filter(|changed| changed != own) else { continue };
            if holds(&changed, other) {
                return Some(text);
            }
            if let Some(places) = partly(own, &changed, other).filter(|_| slip.may_be_partial()) {
                return Some(format!("{places}: {text}"));
            }
        }
    }
    None
}

/// The places where a value is as claimed only with a mistake, if elsewhere it is as claimed without.
fn partly(own: &Quantity, changed: &Quantity, other: &Quantity) -> Option<String> {
    const MOST: usize = 3;
    let all = |value: &Quantity| {
        let mut list = Vec::new();
        leaves(value, String::new(), &mut list);
        list
    };
    let (own, changed, other) = (all(own), all(changed), all(other));
    if own.len() != other.len() || changed.len() != other.len() {
        return None;
    }
    let mut places = Vec::new();
    for ((own, changed), other) in own.iter().zip(&changed).zip(&other) {
        if own.1 != other.1 {
            if changed.1 != other.1 {
                return None;
            }
            places.push(own.0.clone());
        }
    }
    let more = if places.len() > MOST { format!(" and {} more", places.len() - MOST) } else { String::new() };
    places.truncate(MOST);
    (!places.is_empty()).then(|| format!("{}{more}", places.join(", ")))
}

/// The numbers and polynomials of a value, with their places.
fn leaves(value: &Quantity, place: String, found: &mut Vec<(String, Polynomial)>) {
    match value {
        Quantity::Number(value) => found.push((place, value.clone())),
        Quantity::Point(point) => {
            let separator = if place.is_empty() { "" } else { ", " };
            let coordinates = point.coordinates.iter().enumerate();
            found.extend(coordinates.map(|(index, value)| (format!("{place}{separator}coordinate {}", index + 1), value.clone())));
            found.extend(point.weight.iter().map(|weight| (format!("{place}{separator}the weight"), weight.clone())));
        }
        Quantity::List(items) => {
            items.iter().enumerate().for_each(|(index, item)| leaves(item, format!("{place}[{index}]"), found));
        }
        Quantity::Net(net) => leaves(&net.list(), place, found),
        _ => {}
    }
}

fn calls_something(expression: &Expression) -> bool {
    matches!(expression.kind, ExpressionKind::Call(_)) || expression.parts().into_iter().any(calls_something)
}

/// The mistakes to try, each with what to say of it.
fn candidates(shape: Option<&(Map, Reading)>) -> Vec<(Slip, String)> {
    let mut list = Vec::new();
    if let Some((map, reading)) = shape {
        forms(map, *reading, &mut list);
    }
    let others = [
        (
            Slip::Exchanged,
            "r and s are exchanged: the claim holds with the two ends of the frame, or the two arguments, the other way around",
        ),
        (Slip::Unweighted, "the weights are forgotten: the claim holds if every weight is 1"),
        (Slip::Homogeneous, "the division by the weight at the end is forgotten"),
        (Slip::Kappa31, "the sign of κ31 is wrong: κ31 = det(F_3, F_1) = x3 y1 - x1 y3"),
        (Slip::Kappa23, "the sign of κ23 is wrong: κ23 = det(F_2, F_3) = x2 y3 - x3 y2"),
    ];
    list.extend(others.map(|(slip, text)| (slip, text.to_owned())));
    list
}

/// The mistakes in polar forms.
fn forms(map: &Map, reading: Reading, list: &mut Vec<(Slip, String)>) {
    let degree: usize = reading.groups().iter().map(|group| group.0).sum();
    if degree > MAX_DEGREE {
        return;
    }
    let present = exponents(map, reading);
    // One missing number before all of them: where only one matters it is the better name.
    for (place, count) in present.iter().filter(|(_, count)| *count > 1) {
        list.push((Slip::UndividedAt(*place), missing(map, reading, *place, *count)));
    }
    let text = "1/C(m,k) is missing everywhere: a power becomes the sum of its products of arguments divided by their number";
    list.push((Slip::Undivided, text.to_owned()));
    let counts: &[(Counts, &str)] = match reading {
        Reading::Curve(_) => &[],
        Reading::Total(_) => &[
            (
                Counts::Bidegree,
                "the coefficients are divided by C(m,h) C(m,k), which belongs to the polar form by the bidegree; by the total degree it is the multinomial m!/(h! k! (m-h-k)!)",
            ),
            (Counts::Sum, "the coefficients are divided by C(m,h+k); by the total degree it is the multinomial m!/(h! k! (m-h-k)!)"),
        ],
        Reading::Bidegree(..) => &[
            (Counts::First, "the coefficients are divided by C(p,h) only, and 1/C(q,k) is missing"),
            (Counts::Second, "the coefficients are divided by C(q,k) only, and 1/C(p,h) is missing"),
            (
                Counts::Total,
                "the coefficients are divided by multinomials, which belong to the polar form by the total degree; by the bidegree it is C(p,h) C(q,k)",
            ),
        ],
    };
    list.extend(counts.iter().map(|(counts, text)| (Slip::Counts(*counts), (*text).to_owned())));
    for last in [false, true] {
        let text = "a coordinate is polarized at its own degree: all coordinates have the polar degree of the whole map";
        list.push((Slip::OwnDegree { last }, text.to_owned()));
    }
    for (place, count) in &present {
        for number in plausible(degree, *place, *count) {
            let text = format!("{} is divided by {number}: it has {count} products of arguments", power(map, *place));
            list.push((Slip::DividedBy(*place, number), text));
        }
    }
}

/// The exponents that occur in a map, each with its number of products of arguments.
fn exponents(map: &Map, reading: Reading) -> Vec<(Exponents, i64)> {
    let mut found = Vec::new();
    for component in &map.components {
        for (monomial, _) in component.terms() {
            let exponent = |index: usize| map.variables.get(index).map_or(0, |symbol| monomial.degree_in(*symbol) as usize);
            let place = (exponent(0), exponent(1));
            if found.iter().any(|(known, _)| *known == place) {
                continue;
            }
            let choose = |n: usize, k: usize| {
                let number = binomials(n).get(k).cloned().unwrap_or_default();
                i64::try_from(number.numer()).unwrap_or(0)
            };
            let count = match reading {
                Reading::Curve(m) => choose(m, place.0),
                Reading::Total(m) => choose(m, place.0) * choose(m - place.0.min(m), place.1),
                Reading::Bidegree(p, q) => choose(p, place.0) * choose(q, place.1),
            };
            found.push((place, count));
        }
    }
    found.sort_unstable();
    found
}

/// Numbers that a coefficient might be divided by in error.
fn plausible(degree: usize, (h, k): Exponents, count: i64) -> Vec<u32> {
    let factorial = |n: usize| (1..=n as i64).product::<i64>();
    let choose = |n: usize, k: usize| factorial(n) / (factorial(k.min(n)) * factorial(n - k.min(n)));
    let sum = h + k;
    let numbers = [
        degree as i64,
        sum as i64,
        factorial(h) * factorial(k),
        factorial(sum),
        choose(degree + 1, sum),
        if degree > sum { choose(degree - 1, sum) } else { 1 },
        choose(degree, h),
        choose(degree, k),
        2,
        3,
        4,
        6,
    ];
    let mut numbers: Vec<u32> =
        numbers.into_iter().filter(|number| *number > 1 && *number != count).filter_map(|number| u32::try_from(number).ok()).collect();
    let mut seen = Vec::new();
    numbers.retain(|number| {
        !seen.contains(number) && {
            seen.push(*number);
            true
        }
    });
    numbers
}

/// A product of powers of the variables.
fn power(map: &Map, (h, k): Exponents) -> String {
    let one = |index: usize, exponent: usize| match (map.variables.get(index), exponent) {
        (None, _) | (_, 0) => None,
        (Some(symbol), 1) => Some(symbol.to_string()),
        (Some(symbol), _) => Some(format!("{symbol}^{exponent}")),
    };
    let parts: Vec<String> = [one(0, h), one(1, k)].into_iter().flatten().collect();
    if parts.is_empty() { "the constant".to_owned() } else { parts.join(" ") }
}

fn missing(map: &Map, reading: Reading, (h, k): Exponents, count: i64) -> String {
    let number = match reading {
        Reading::Curve(m) => format!("1/C({m},{h})"),
        Reading::Total(m) => format!("the multinomial 1/({m}!/({h}! {k}! {}!))", m.saturating_sub(h + k)),
        Reading::Bidegree(p, q) => format!("1/(C({p},{h}) C({q},{k}))"),
    };
    format!("{number} = 1/{count} is missing: {} becomes the sum of {count} products of arguments divided by {count}", power(map, (h, k)))
}

/// One side a multiple of the other.
fn factor(case: &Case<'_>) -> Option<String> {
    let numbers = |value: &Quantity| match value {
        Quantity::Number(value) => Some(vec![value.clone()]),
        Quantity::Point(point) if point.weight.is_none() => Some(point.coordinates.clone()),
        _ => None,
    };
    let (left, right) = (numbers(case.left.1)?, numbers(case.right.1)?);
    let place = left.iter().position(|value| !value.is_zero())?;
    let leading = |value: &Polynomial| value.terms().next().map(|(_, number)| number.clone());
    // A number alone is a multiple of every other.
    let is_number = left.len() == 1 && left[0].as_rational().is_some();
    let factor = leading(right.get(place)?)?.checked_div(&leading(&left[place])?)?;
    let same = left.len() == right.len() && left.iter().zip(&right).all(|(x, y)| x.scale(&factor) == *y);
    if !same || factor.is_zero() || (is_number && factor != crate::exact::Rational::from(-1)) {
        return None;
    }
    Some(if factor == crate::exact::Rational::from(-1) {
        "the whole right side has the wrong sign".to_owned()
    } else {
        format!("the right side is {factor} times the left side")
    })
}
