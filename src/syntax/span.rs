//! Places in a text.

use super::Lines;

/// A range of bytes of the text that was read; `end` is exclusive.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash, Default)]
pub struct Span {
    /// The first byte.
    pub start: usize,
    /// The byte after the last one.
    pub end: usize,
}

impl Span {
    /// The range from `start` up to, not including, `end`.
    #[must_use]
    pub const fn new(start: usize, end: usize) -> Self {
        Self { start, end }
    }

    /// The smallest range that contains both.
    #[must_use]
    pub fn to(self, other: Self) -> Self {
        Self { start: self.start.min(other.start), end: self.end.max(other.end) }
    }

    /// The part of the text in this range; empty if it is not a range of the text.
    #[must_use]
    pub fn text(self, source: &str) -> &str {
        source.get(self.start..self.end).unwrap_or("")
    }

    /// Line and column of the beginning, both from 1; columns count characters.
    /// For many places of one text, see [`Lines`].
    #[must_use]
    pub fn position(self, source: &str) -> (usize, usize) {
        Lines::new(source).position(self.start)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn positions_count_characters() {
        let source = "λ + t,\n½ t";
        let place = |needle| source.find(needle).map(|start| Span::new(start, start + 1).position(source));
        assert_eq!(place("λ"), Some((1, 1)));
        assert_eq!(place("t,"), Some((1, 5)));
        assert_eq!(place("½"), Some((2, 1)));
        assert_eq!(Span::new(source.len(), source.len()).position(source), (2, 4));
        assert_eq!(Span::new(99, 99).position(source), (2, 4));
    }
}
