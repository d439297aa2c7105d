//! Mistakes in what is written: decimals in the place of fractions, signs.

use num_traits::Signed;

use super::{Case, holds};
use crate::exact::Rational;
use crate::syntax::Span;
use crate::syntax::expression::{Expression, ExpressionKind};
use crate::syntax::parser::Parser;

/// The largest denominator of a fraction that a decimal may stand for.
const MAX_DENOMINATOR: i64 = 1000;
/// How many places are tried.
const MAX_PLACES: usize = 64;

/// The fractions that round to a decimal as it is written, or are cut off to it, the simplest first.
fn fractions(text: &str) -> Vec<Rational> {
    let Some((_, digits)) = text.split_once('.') else { return Vec::new() };
    let (Ok(value), true) = (text.parse::<Rational>(), digits.bytes().all(|byte| byte.is_ascii_digit()) && digits.len() <= 12) else {
        return Vec::new();
    };
    let unit = Rational::new(1, 10).pow(digits.len() as u32);
    let mut found: Vec<Rational> = Vec::new();
    for denominator in 2..=MAX_DENOMINATOR {
        let scaled = &value * &Rational::from(denominator) + Rational::new(1, 2);
        // The nearest numerator: the floor of a positive number and a half.
        let numerator = scaled.numer() / scaled.denom();
        let fraction = Rational::from_big(numerator, denominator.into());
        let beyond = &fraction - &value;
        // Rounded, or cut off.
        let fits = beyond.abs() * Rational::from(2) <= unit || (!beyond.is_negative() && beyond < unit);
        if fraction != value && fits && !found.contains(&fraction) {
            found.push(fraction);
            if found.len() == 3 {
                break;
            }
        }
    }
    found
}

/// The places of an expression that satisfy a condition, outside of calls.
fn places(expression: &Expression, wanted: &dyn Fn(&Expression) -> bool, found: &mut Vec<Span>) {
    if wanted(expression) {
        found.push(expression.span);
    }
    if !matches!(expression.kind, ExpressionKind::Call(_)) {
        expression.parts().into_iter().for_each(|part| places(part, wanted, found));
    }
}

/// A decimal in the place of a fraction.
pub(super) fn decimals(case: &Case<'_>, parser: &mut Parser<'_>) -> Option<String> {
    for (expression, _, other) in case.sides() {
        let mut found = Vec::new();
        let is_decimal = |part: &Expression| matches!(part.kind, ExpressionKind::Number(_)) && part.span.text(case.source).contains('.');
        places(expression, &is_decimal, &mut found);
        if found.is_empty() || found.len() > MAX_PLACES {
            continue;
        }
        let mut attempt = |replace: &dyn Fn(Span) -> Option<Rational>| {
            let changed = expression.rewritten(&mut |part| {
                let number = is_decimal(part).then(|| replace(part.span)).flatten()?;
                Some(Expression { kind: ExpressionKind::Number(number), span: part.span })
            });
            case.value(parser, &changed, None).is_some_and(|value| holds(&value, other))
        };
        for &place in &found {
            let text = place.text(case.source);
            for fraction in fractions(text) {
                if attempt(&|span| (span == place).then(|| fraction.clone())) {
                    return Some(format!(
                        "the decimal {text} stands for the fraction {fraction}, which it is not: decimals are exact here"
                    ));
                }
            }
        }
        if attempt(&|span| fractions(span.text(case.source)).into_iter().next()) {
            let all: Vec<String> = found
                .iter()
                .filter_map(|place| {
                    let text = place.text(case.source);
                    fractions(text).first().map(|fraction| format!("{text} for {fraction}"))
                })
                .collect();
            return Some(format!("decimals stand for fractions, which they are not: {}; decimals are exact here", all.join(", ")));
        }
    }
    None
}

/// A wrong sign before one term.
pub(super) fn signs(case: &Case<'_>, parser: &mut Parser<'_>) -> Option<String> {
    // What is claimed stands on the right, as a rule.
    let [left, right] = case.sides();
    for (expression, _, other) in [right, left] {
        let mut terms = Vec::new();
        terms_of(expression, &mut terms);
        if terms.len() > MAX_PLACES {
            continue;
        }
        for (sum, index) in terms {
            let changed = expression.rewritten(&mut |part| match &part.kind {
                ExpressionKind::Sum(parts) if part.span == sum => {
                    let mut parts = parts.clone();
                    parts[index].0 = !parts[index].0;
                    Some(Expression { kind: ExpressionKind::Sum(parts), span: part.span })
                }
                _ if part.span == sum && !matches!(part.kind, ExpressionKind::Sum(_) | ExpressionKind::Group(_)) => {
                    Some(Expression { kind: ExpressionKind::Sum(vec![(true, part.clone())]), span: part.span })
                }
                _ => None,
            });
            if case.value(parser, &changed, None).is_some_and(|value| holds(&value, other)) {
                let term = term_text(expression, sum, index, case.source);
                return Some(format!("the sign of `{term}` is wrong"));
            }
        }
    }
    None
}

/// The terms of all sums outside of calls, and what stands in points and lists without a sign.
fn terms_of(expression: &Expression, found: &mut Vec<(Span, usize)>) {
    match &expression.kind {
        ExpressionKind::Call(_) => return,
        ExpressionKind::Sum(parts) => found.extend((0..parts.len()).map(|index| (expression.span, index))),
        ExpressionKind::Tuple(items) | ExpressionKind::List(items) => {
            let bare = items.iter().filter(|item| {
                !matches!(item.kind, ExpressionKind::Sum(_) | ExpressionKind::Tuple(_) | ExpressionKind::List(_) | ExpressionKind::Call(_))
            });
            found.extend(bare.map(|item| (item.span, 0)));
        }
        _ => {}
    }
    expression.parts().into_iter().for_each(|part| terms_of(part, found));
}

fn term_text<'s>(expression: &Expression, sum: Span, index: usize, source: &'s str) -> &'s str {
    if expression.span == sum
        && let ExpressionKind::Sum(parts) = &expression.kind
    {
        return parts.get(index).map_or("", |part| part.1.span.text(source));
    }
    let inside = expression.parts().into_iter().find(|part| part.span.start <= sum.start && sum.end <= part.span.end);
    inside.map_or_else(|| sum.text(source), |part| term_text(part, sum, index, source))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn decimals_of_fractions() {
        let simplest = |text| fractions(text).first().map(ToString::to_string);
        assert_eq!(simplest("0.33"), Some("1/3".to_owned()));
        assert_eq!(simplest("0.667"), Some("2/3".to_owned()));
        assert_eq!(simplest("0.66"), Some("2/3".to_owned()));
        assert_eq!(simplest("0.142857"), Some("1/7".to_owned()));
        assert_eq!(simplest("2"), None);
        assert_eq!(simplest("0.4"), Some("3/7".to_owned()));
    }
}
