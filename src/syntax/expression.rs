//! The tree that the parser builds.

use std::collections::BTreeMap;

use super::Span;
use crate::exact::Rational;
use crate::symbolic::Symbol;

#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Expression {
    pub(crate) kind: ExpressionKind,
    pub(crate) span: Span,
}

#[derive(Clone, Debug, PartialEq)]
pub(crate) enum ExpressionKind {
    Number(Rational),
    Symbol(Symbol),
    /// Terms with `true` for those that are subtracted.
    Sum(Vec<(bool, Expression)>),
    /// Factors with `true` for those that are divided by.
    Product(Vec<(bool, Expression)>),
    Power(Box<Expression>, Box<Expression>),
    Root(Box<Expression>),
    /// An expression in brackets. Kept, because `(r^2)` is one polar argument where `r^2` is two.
    Group(Box<Expression>),
    /// Two or more expressions in brackets.
    Tuple(Vec<Expression>),
}

impl Expression {
    /// The symbols that are written in the expression, each with its first place.
    pub(crate) fn collect_symbols(&self, into: &mut BTreeMap<Symbol, Span>) {
        match &self.kind {
            ExpressionKind::Number(_) => {}
            ExpressionKind::Symbol(symbol) => {
                into.entry(*symbol).or_insert(self.span);
            }
            ExpressionKind::Sum(parts) | ExpressionKind::Product(parts) => parts.iter().for_each(|(_, part)| part.collect_symbols(into)),
            ExpressionKind::Power(a, b) => {
                a.collect_symbols(into);
                b.collect_symbols(into);
            }
            ExpressionKind::Root(part) | ExpressionKind::Group(part) => part.collect_symbols(into),
            ExpressionKind::Tuple(parts) => parts.iter().for_each(|part| part.collect_symbols(into)),
        }
    }

    /// Whether the expression is a sum, product or power with a power outside brackets.
    pub(crate) fn has_bare_power(&self) -> bool {
        match &self.kind {
            ExpressionKind::Power(..) => true,
            ExpressionKind::Sum(parts) | ExpressionKind::Product(parts) => parts.iter().any(|(_, part)| part.has_bare_power()),
            _ => false,
        }
    }
}
