//! What a check of a worksheet found.

use super::claim::{Claim, Verdict};
use super::quantity::{Net, Quantity};
use crate::exact::Rational;
use crate::symbolic::Symbol;
use crate::syntax::{Span, SyntaxError};

/// What a worksheet amounts to.
#[derive(Clone, Debug, Default)]
pub struct Report {
    /// Every claim, in the order of the file.
    pub claims: Vec<Claim>,
    /// What could not be read or evaluated outside of claims.
    pub errors: Vec<SyntaxError>,
    /// What is allowed and yet hardly meant.
    pub warnings: Vec<Warning>,
    /// The definitions that were made, with their places.
    pub(super) definitions: Vec<(Symbol, Quantity, Span)>,
    /// What every statement was, for those who render the worksheet.
    pub(super) statements: Vec<Rendered>,
}

/// Something that is allowed and yet hardly meant.
#[derive(Clone, Debug)]
pub struct Warning {
    /// The code of its rule, one of [`RULES`](super::RULES).
    pub code: &'static str,
    /// What and where.
    pub error: SyntaxError,
}

/// A statement as it is rendered.
#[derive(Clone, Debug)]
pub(super) struct Rendered {
    pub(super) span: Span,
    pub(super) outcome: Outcome,
    /// The statement in LaTeX, in parts between which a line may end; none if it could not be read.
    pub(super) latex: Vec<String>,
    /// What can be drawn beside it.
    pub(super) picture: Option<Picture>,
}

/// A net to draw.
#[derive(Clone, Debug)]
pub(super) struct Picture {
    pub(super) net: Net,
    /// The parameter whose scheme is drawn too.
    pub(super) at: Option<Rational>,
    pub(super) label: String,
}

/// What a statement was.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Outcome {
    /// The definition with this number.
    Definition(usize),
    /// The claim with this number.
    Claim(usize),
    /// The error with this number.
    Error(usize),
}

impl Report {
    /// How many claims have a verdict.
    #[must_use]
    pub fn count(&self, verdict: Verdict) -> usize {
        self.claims.iter().filter(|claim| claim.verdict == verdict).count()
    }

    /// Whether every claim holds and everything could be read.
    #[must_use]
    pub fn holds(&self) -> bool {
        self.errors.is_empty() && self.claims.iter().all(|claim| claim.verdict == Verdict::Proved)
    }
}
