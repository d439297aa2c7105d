//! The tree that the parser builds.

use std::collections::BTreeMap;

use super::Span;
use super::evaluate::Value;
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
    /// A list in square brackets. This and the following kinds occur in worksheets only.
    List(Vec<Expression>),
    /// An entry of a list, of a list in it, and so on: the list and the numbers behind it.
    /// One row, so that a long one is no deep one.
    Entry(Box<Expression>, Vec<Expression>),
    /// A point with its weight.
    Weighted(Box<Expression>, Box<Expression>),
    /// The name of a class, an order or another answer.
    Word(&'static str),
    /// A function, a map or a polar form with its arguments.
    Call(Box<Call>),
    /// What has been evaluated already.
    Known(Value),
}

/// A call of a function, of a map or of a polar form.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Call {
    pub(crate) callee: Callee,
    /// The place of the name.
    pub(crate) name_span: Span,
    pub(crate) arguments: Arguments,
}

/// What is called.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Callee {
    /// A function, by its name.
    Function(&'static str),
    /// A map, a net or a polar form.
    Name(Symbol),
}

/// The arguments of a call.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Arguments {
    /// Those of a function or a map.
    Plain(Vec<Argument>),
    /// Those of a polar form: one group, or two where a semicolon separates them.
    Polar(Vec<Vec<PolarArgument>>),
}

/// One argument of a function or a map.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Argument {
    /// A value.
    Plain(Expression),
    /// An interval `r..s`.
    Range(Expression, Expression),
    /// A value by the name of what it is for: `u = 1/2`.
    Named(Symbol, Expression),
}

impl Argument {
    /// Where the argument stands.
    pub(crate) fn span(&self) -> Span {
        match self {
            Self::Plain(expression) | Self::Named(_, expression) => expression.span,
            Self::Range(from, to) => from.span.to(to.span),
        }
    }
}

/// One argument of a polar form before it is evaluated.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct PolarArgument {
    /// The weight of a homogeneous argument `[w; …]`.
    pub(crate) weight: Option<Expression>,
    /// One expression, or the coordinates of a homogeneous argument.
    pub(crate) coordinates: Vec<Expression>,
    /// How often the argument is repeated, unless it is once.
    pub(crate) repeated: Option<Expression>,
    pub(crate) span: Span,
}

impl Expression {
    /// The symbols that are written in the expression, each with its first place.
    pub(crate) fn collect_symbols(&self, into: &mut BTreeMap<Symbol, Span>) {
        if let ExpressionKind::Symbol(symbol) = self.kind {
            into.entry(symbol).or_insert(self.span);
        }
        self.parts().into_iter().for_each(|part| part.collect_symbols(into));
    }

    /// The expressions that this one is made of, in their order.
    pub(crate) fn parts(&self) -> Vec<&Expression> {
        match &self.kind {
            ExpressionKind::Number(_) | ExpressionKind::Symbol(_) | ExpressionKind::Word(_) | ExpressionKind::Known(_) => Vec::new(),
            ExpressionKind::Sum(parts) | ExpressionKind::Product(parts) => parts.iter().map(|(_, part)| part).collect(),
            ExpressionKind::Power(a, b) | ExpressionKind::Weighted(a, b) => vec![a, b],
            ExpressionKind::Entry(list, numbers) => std::iter::once(&**list).chain(numbers).collect(),
            ExpressionKind::Root(part) | ExpressionKind::Group(part) => vec![part],
            ExpressionKind::Tuple(parts) | ExpressionKind::List(parts) => parts.iter().collect(),
            ExpressionKind::Call(call) => match &call.arguments {
                Arguments::Plain(arguments) => {
                    let parts = arguments.iter().flat_map(|argument| match argument {
                        Argument::Plain(part) | Argument::Named(_, part) => vec![part],
                        Argument::Range(a, b) => vec![a, b],
                    });
                    parts.collect()
                }
                Arguments::Polar(groups) => groups
                    .iter()
                    .flatten()
                    .flat_map(|argument| argument.weight.iter().chain(&argument.coordinates).chain(&argument.repeated))
                    .collect(),
            },
        }
    }

    /// The same expression with parts of it replaced, wherever `rule` has something for them.
    pub(crate) fn rewritten(&self, rule: &mut dyn FnMut(&Self) -> Option<Self>) -> Self {
        if let Some(other) = rule(self) {
            return other;
        }
        let mut pairs = |parts: &[(bool, Self)]| parts.iter().map(|(flag, part)| (*flag, part.rewritten(rule))).collect::<Vec<_>>();
        let kind = match &self.kind {
            ExpressionKind::Sum(parts) => ExpressionKind::Sum(pairs(parts)),
            ExpressionKind::Product(parts) => ExpressionKind::Product(pairs(parts)),
            ExpressionKind::Power(a, b) => ExpressionKind::Power(Box::new(a.rewritten(rule)), Box::new(b.rewritten(rule))),
            ExpressionKind::Entry(list, numbers) => {
                let list = Box::new(list.rewritten(rule));
                ExpressionKind::Entry(list, numbers.iter().map(|number| number.rewritten(rule)).collect())
            }
            ExpressionKind::Weighted(a, b) => ExpressionKind::Weighted(Box::new(a.rewritten(rule)), Box::new(b.rewritten(rule))),
            ExpressionKind::Root(part) => ExpressionKind::Root(Box::new(part.rewritten(rule))),
            ExpressionKind::Group(part) => ExpressionKind::Group(Box::new(part.rewritten(rule))),
            ExpressionKind::Tuple(parts) => ExpressionKind::Tuple(parts.iter().map(|part| part.rewritten(rule)).collect()),
            ExpressionKind::List(parts) => ExpressionKind::List(parts.iter().map(|part| part.rewritten(rule)).collect()),
            // What stands in the brackets of a call stays as it is.
            other => other.clone(),
        };
        Self { kind, span: self.span }
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
