//! Claims and what became of them.

use super::compare::Difference;
use super::quantity::number;
use crate::symbolic::Monomial;
use crate::syntax::{Span, Style, SyntaxError};

/// What became of a claim.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Verdict {
    /// It holds, for all values of its symbolic parameters.
    Proved,
    /// It does not hold.
    Refuted,
    /// It could not be decided.
    Error,
}

impl Verdict {
    /// The name in machine-readable reports.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Proved => "proved",
            Self::Refuted => "refuted",
            Self::Error => "error",
        }
    }
}

/// A claim of a worksheet.
#[derive(Clone, Debug)]
pub struct Claim {
    /// The line where it begins, from 1.
    pub line: usize,
    /// The column, from 1, in characters.
    pub column: usize,
    /// The place in the file.
    pub span: Span,
    /// Its name, if it has one.
    pub name: Option<String>,
    /// What became of it.
    pub verdict: Verdict,
    /// The value of the left side, of a claim that is refuted.
    pub left: Option<String>,
    /// The value of the right side.
    pub right: Option<String>,
    /// The left side minus the right one, or how else they differ.
    pub difference: Option<String>,
    /// The terms that differ.
    pub terms: Vec<Term>,
    /// The usual mistake that explains the difference exactly.
    pub diagnosis: Option<String>,
    /// Why it could not be decided.
    pub error: Option<SyntaxError>,
}

impl Claim {
    /// A claim that holds, so far.
    pub(super) fn new((line, column): (usize, usize), span: Span, name: Option<&str>) -> Self {
        Self {
            line,
            column,
            span,
            name: name.map(str::to_owned),
            verdict: Verdict::Proved,
            left: None,
            right: None,
            difference: None,
            terms: Vec::new(),
            diagnosis: None,
            error: None,
        }
    }
}

/// A term that differs.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Term {
    /// Where, such as `coordinate 2` or `[1][0]`; empty for a single number or polynomial.
    pub place: String,
    /// The product of symbols; 1 for a number.
    pub monomial: String,
    /// The coefficient on the left side.
    pub left: String,
    /// The coefficient on the right side.
    pub right: String,
}

impl Term {
    /// The terms of a difference.
    pub(super) fn of(difference: &Difference) -> Vec<Self> {
        let mut terms = Vec::new();
        for entry in &difference.entries {
            for (monomial, left, right) in entry.terms() {
                terms.push(Self {
                    place: entry.place.clone(),
                    monomial: shown(&monomial),
                    left: number(&left, Style::Text),
                    right: number(&right, Style::Text),
                });
            }
        }
        terms
    }
}

fn shown(monomial: &Monomial) -> String {
    if monomial.is_one() { "1".to_owned() } else { monomial.to_string() }
}
