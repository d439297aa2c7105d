//! Claimed polar forms that are none, told apart by the axioms.

use super::Case;
use crate::blossom::{PolarDefect, check_polar_form};
use crate::symbolic::{Polynomial, Symbol};
use crate::syntax::expression::{Arguments, Callee, Expression, ExpressionKind};
use crate::worksheet::quantity::Quantity;

/// What is wrong with a claimed polar form, axiom by axiom.
pub(super) fn defects(case: &Case<'_>) -> Option<String> {
    for (expression, _, claimed) in case.sides() {
        let Some(letters) = letters(expression) else { continue };
        let (map, reading) = case.shape(expression)?;
        let own: Vec<Symbol> = reading.symbols().collect();
        if own.len() != letters.len() || map.weight.is_some() {
            continue;
        }
        let claimed: Vec<Polynomial> = match claimed {
            Quantity::Number(value) => vec![value.clone()],
            Quantity::Point(point) if point.weight.is_none() => point.coordinates.clone(),
            _ => continue,
        };
        // The component, of a claim about one.
        let component = component(case, expression);
        let polynomials: Vec<Polynomial> = match component {
            Some(index) => map.components.get(index as usize - 1).cloned().into_iter().collect(),
            None => map.components.clone(),
        };
        let to_own: Vec<(Symbol, Symbol)> = letters.iter().copied().zip(own.iter().copied()).collect();
        let renamed: Vec<Polynomial> = claimed.iter().map(|value| value.renamed(&to_own)).collect();
        let Ok(defects) = check_polar_form(reading, &polynomials, &map.variables, &renamed) else { continue };
        let written = |symbol: Symbol| to_own.iter().find(|pair| pair.1 == symbol).map_or(symbol, |pair| pair.0);
        let argument = |group: usize, argument: usize| {
            let (_, dimension) = reading.groups()[group];
            let names: Vec<String> = (1..=dimension).map(|axis| written(reading.symbol(group, argument, axis)).to_string()).collect();
            if dimension == 1 { names.concat() } else { format!("({})", names.join(",")) }
        };
        let sentences: Vec<String> = defects
            .iter()
            .map(|defect| {
                let place =
                    |coordinate: &usize| if claimed.len() == 1 { String::new() } else { format!("coordinate {} of ", coordinate + 1) };
                match defect {
                    PolarDefect::NotSymmetric { coordinate, group, arguments, .. } => format!(
                        "{}the claimed form is not symmetric: exchanging {} and {} changes it",
                        place(coordinate),
                        argument(*group, arguments.0),
                        argument(*group, arguments.1)
                    ),
                    PolarDefect::NotAffine { coordinate, group, argument: which, degree } => format!(
                        "{}the claimed form is not affine in {}: its degree in it is {degree}",
                        place(coordinate),
                        argument(*group, *which)
                    ),
                    PolarDefect::WrongDiagonal { coordinate, difference } => format!(
                        "{}the claimed form is wrong on the diagonal: with equal arguments it is off by {difference}",
                        place(coordinate)
                    ),
                }
            })
            .collect();
        if !sentences.is_empty() {
            return Some(sentences.join("; "));
        }
    }
    None
}

/// The different letters that are the arguments of a polar form in a call.
fn letters(expression: &Expression) -> Option<Vec<Symbol>> {
    let ExpressionKind::Call(call) = &expression.kind else { return None };
    let Arguments::Polar(groups) = &call.arguments else { return None };
    let mut letters = Vec::new();
    for argument in groups.iter().flatten() {
        if argument.weight.is_some() || argument.repeated.is_some() {
            return None;
        }
        for coordinate in &argument.coordinates {
            let parts = match &coordinate.kind {
                ExpressionKind::Tuple(items) => items.iter().collect(),
                _ => vec![coordinate],
            };
            for part in parts {
                match part.kind {
                    ExpressionKind::Symbol(symbol) if !letters.contains(&symbol) => letters.push(symbol),
                    _ => return None,
                }
            }
        }
    }
    Some(letters)
}

/// The component whose polar form is called.
fn component(case: &Case<'_>, expression: &Expression) -> Option<u32> {
    let ExpressionKind::Call(call) = &expression.kind else { return None };
    let Callee::Name(symbol) = call.callee else { return None };
    case.scope.callee(symbol, true)?.component
}
