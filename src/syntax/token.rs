//! The words of the grammar.

use super::Span;
use crate::symbolic::Symbol;

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Bracket {
    Round,
    Square,
    Curly,
}

/// Comparisons of worksheets; no expression contains one.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(crate) enum Comparison {
    Equal,
    NotEqual,
    Less,
    LessOrEqual,
    Greater,
    GreaterOrEqual,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum TokenKind {
    /// A number without sign; its text is in the source.
    Number,
    /// One letter with its index.
    Symbol(Symbol),
    /// A word of a worksheet: the name of a function, a class, an order.
    Word(&'static str),
    /// A whole exponent in superscript digits; its text is in the source.
    Superscript,
    Plus,
    Minus,
    Times,
    Over,
    Power,
    Open(Bracket),
    Close(Bracket),
    Comma,
    Semicolon,
    Colon,
    /// A dot that belongs to no number; only LaTeX input has it, at the end.
    Dot,
    /// `..`, between the ends of an interval.
    Range,
    Equals,
    Comparison(Comparison),
    /// A root sign; its argument follows.
    Root,
    /// `\frac`; its two arguments follow.
    Fraction,
    End,
}

#[derive(Clone, Copy, Debug)]
pub(crate) struct Token {
    pub(crate) kind: TokenKind,
    pub(crate) span: Span,
    /// Whether a blank, or what LaTeX has for one, stands before the token.
    pub(crate) blank_before: bool,
    /// Whether a line end, `\\`, `\qquad` or the border of a math block does.
    pub(crate) break_before: bool,
}
