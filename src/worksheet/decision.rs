//! Whether claims hold.

use super::claim::Term;
use super::compare::{Finding, compare};
use super::diagnosis::{Case, diagnose};
use super::evaluate::Evaluator;
use super::function::{self, net_of};
use super::quantity::Quantity;
use super::report::Picture;
use super::scope::Scope;
use crate::affine::{Frame, Interval};
use crate::symbolic::Symbol;
use crate::syntax::expression::{Arguments, Callee, Expression, ExpressionKind};
use crate::syntax::parser::Parser;
use crate::syntax::statement;
use crate::syntax::token::Comparison;
use crate::syntax::{Span, SyntaxError};

/// A letter in front of a bracket that may have been meant as a name.
fn called_letter(scope: &Scope, claim: &statement::Claim, source: &str) -> Option<String> {
    let text = claim.span().text(source);
    let mut before = ' ';
    for (at, c) in text.char_indices() {
        let starts = Symbol::is_letter(c) && !Symbol::is_letter(before) && before != '_' && before != '\\';
        before = c;
        if !starts {
            continue;
        }
        let behind = text[at + c.len_utf8()..].trim_start_matches(|digit: char| digit == '_' || digit.is_ascii_digit());
        let symbol = Symbol::new(c, None);
        if !behind.starts_with('(') || scope.callee(symbol, true).is_some() || scope.get(symbol).is_some() {
            continue;
        }
        let capital = c.to_uppercase().next().map(|upper| Symbol::new(upper, None));
        let later = capital.and_then(|capital| scope.later.get(&capital).map(|later| (capital, later.line)));
        if let Some((capital, line)) = later.filter(|(capital, _)| scope.get(*capital).is_none()) {
            return Some(format!("`{c}(` multiplies here, because `{capital}` is defined only in line {line}: move the definition up"));
        }
        if c.is_ascii_uppercase() {
            return Some(format!("`{c}(` multiplies here, because no map or net `{c}` is defined"));
        }
    }
    None
}

/// What became of a claim.
pub(super) enum Decision {
    /// It holds; perhaps because both sides are written alike.
    Holds {
        trivial: Option<Span>,
    },
    Fails(Box<Failure>),
}

/// Why a claim fails.
pub(super) struct Failure {
    pub(super) left: String,
    pub(super) right: String,
    pub(super) difference: Option<String>,
    pub(super) terms: Vec<Term>,
    pub(super) diagnosis: Option<String>,
}

pub(super) fn decide(
    scope: &Scope,
    parser: &mut Parser<'_>,
    claim: &statement::Claim,
    source: &str,
    explains: bool,
) -> Result<Decision, SyntaxError> {
    let evaluator = Evaluator { scope, variables: &[], defining: None, slip: None };
    let values = claim.sides.iter().map(|side| evaluator.evaluate(parser, side)).collect::<Result<Vec<_>, _>>()?;
    let mut trivial = None;
    for (index, comparison) in claim.comparisons.iter().enumerate() {
        let (left, right) = (&values[index], &values[index + 1]);
        match compare(left, *comparison, right) {
            Finding::Holds => {
                let written = |side: &Expression| side.span.text(source).split_whitespace().collect::<String>();
                let (a, b) = (&claim.sides[index], &claim.sides[index + 1]);
                if written(a) == written(b) {
                    trivial = Some(a.span.to(b.span));
                }
            }
            Finding::Mismatch(message) => {
                let span = claim.sides[index].span.to(claim.sides[index + 1].span);
                return Err(SyntaxError::new(span, message));
            }
            Finding::Fails(difference) => {
                return Ok(Decision::Fails(Box::new(Failure {
                    left: left.shown(crate::syntax::Style::Text),
                    right: right.shown(crate::syntax::Style::Text),
                    difference: difference.shown(),
                    terms: Term::of(&difference),
                    diagnosis: (explains && *comparison == Comparison::Equal)
                        .then(|| {
                            let case = Case { scope, source, left: (&claim.sides[index], left), right: (&claim.sides[index + 1], right) };
                            diagnose(&case, parser)
                        })
                        .flatten()
                        .or_else(|| called_letter(scope, claim, source)),
                })));
            }
        }
    }
    Ok(Decision::Holds { trivial })
}

/// What can be drawn beside a claim: a net that it computes, or the scheme of de Casteljau's algorithm.
pub(super) fn picture_of(scope: &Scope, parser: &mut Parser<'_>, claim: &statement::Claim) -> Option<Picture> {
    let evaluator = Evaluator { scope, variables: &[], defining: None, slip: None };
    claim.sides.iter().find_map(|side| {
        let ExpressionKind::Call(call) = &side.kind else { return None };
        let (Callee::Function(name), Arguments::Plain(arguments)) = (call.callee, &call.arguments) else { return None };
        let label = side.span.text(parser.source).split_whitespace().collect::<Vec<_>>().join(" ");
        if name != "casteljau" {
            return match evaluator.evaluate(parser, side).ok()? {
                Quantity::Net(net) => Some(Picture { net, at: None, label }),
                _ => None,
            };
        }
        let operands = evaluator.operands(parser, arguments, &[]).ok()?;
        let (shape, at) = match operands.as_slice() {
            [function::Operand::Value { value: Quantity::Net(net), .. }, at] => (Quantity::Net(net.clone()), at),
            [function::Operand::Value { value: Quantity::Map(map), .. }, function::Operand::Range { from, to, .. }, at] => {
                (net_of(map, &Frame::Interval(Interval::new(from.clone(), to.clone()).ok()?)).ok()?, at)
            }
            _ => return None,
        };
        let at = match at {
            function::Operand::Value { value: Quantity::Number(value), .. } => value.as_rational(),
            _ => None,
        };
        match shape {
            Quantity::Net(net) => Some(Picture { net, at, label }),
            _ => None,
        }
    })
}
