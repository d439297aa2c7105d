//! How large values are, and how large they may be.

use super::quantity::{Point, Quantity};
use crate::symbolic::Polynomial;
use crate::syntax::limits::{MAX_NESTING, MAX_WORK};
use crate::syntax::{Span, SyntaxError};

/// The largest size of a list: terms of polynomials, of which a number has one,
/// and lists; long numbers count by their machine words.
pub const MAX_LIST_SIZE: u64 = 1 << 16;

/// The largest size of all definitions of a worksheet together.
pub const MAX_HELD: u64 = 1 << 19;

/// How much arithmetic all statements of a worksheet may ask for together.
pub const MAX_WORKSHEET_WORK: u64 = 10 * MAX_WORK;

impl Quantity {
    /// The size, as [`MAX_LIST_SIZE`] counts it.
    pub(super) fn size(&self) -> u64 {
        match self {
            Self::Number(value) | Self::Equation(value) => size(value),
            Self::Point(Point { coordinates, weight }) => coordinates.iter().chain(weight).map(size).sum(),
            Self::List(items) => items.iter().map(Self::size).sum::<u64>() + 1,
            Self::Map(map) => map.homogeneous().map(size).sum(),
            Self::Net(net) => net.piece.points().flatten().map(size).sum(),
            Self::Order(_) | Self::Word(_) => 1,
        }
    }

    /// How deep lists are nested in it.
    fn depth(&self) -> usize {
        match self {
            Self::List(items) => items.iter().map(Self::depth).max().unwrap_or(0) + 1,
            _ => 0,
        }
    }
}

/// The size of a polynomial; even 0 takes a place.
fn size(value: &Polynomial) -> u64 {
    let terms = value.terms().map(|(monomial, coefficient)| 1 + monomial.factors().len() as u64 / 4 + coefficient.bits() / 64);
    terms.sum::<u64>().max(1)
}

/// A list that grows within the limits.
#[derive(Default)]
pub(super) struct Growing {
    items: Vec<Quantity>,
    size: u64,
}

impl Growing {
    /// Takes the next entry, which stands at a place.
    pub(super) fn push(&mut self, item: Quantity, span: Span) -> Result<(), SyntaxError> {
        self.size += item.size();
        if self.size > MAX_LIST_SIZE {
            let message = format!("found a list of more than {MAX_LIST_SIZE} numbers and terms, expected at most {MAX_LIST_SIZE}");
            return Err(SyntaxError::new(span, message).with_help("write shorter lists, each with a name or in a claim of its own"));
        }
        if item.depth() >= MAX_NESTING {
            let message = format!("found lists nested more than {MAX_NESTING} deep, expected at most {MAX_NESTING}");
            return Err(SyntaxError::new(span, message).with_help("write one list with all entries, as in `[a, b, c]`"));
        }
        self.items.push(item);
        Ok(())
    }

    /// The list.
    pub(super) fn list(self) -> Quantity {
        Quantity::List(self.items)
    }
}

/// What the statements of a worksheet have used of what it may use.
#[derive(Default)]
pub(super) struct Ledger {
    held: u64,
    work: u64,
}

impl Ledger {
    /// Counts what a definition is going to hold.
    pub(super) fn hold(&mut self, size: u64, span: Span) -> Result<(), SyntaxError> {
        self.held = self.held.saturating_add(size);
        if self.held <= MAX_HELD {
            return Ok(());
        }
        let message = format!("found definitions of more than {MAX_HELD} numbers and terms together, expected at most {MAX_HELD}");
        Err(SyntaxError::new(span, message).with_help("split the worksheet"))
    }

    /// Counts work that was done.
    pub(super) fn worked(&mut self, work: u64) {
        self.work = self.work.saturating_add(work);
    }

    /// Whether the statements took all the work that a worksheet may take.
    pub(super) fn is_spent(&self) -> bool {
        self.work > MAX_WORKSHEET_WORK
    }
}
