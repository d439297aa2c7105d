//! The names of variables and parameters.

use std::fmt;

/// A variable or parameter: one letter with an optional index, such as `t`,
/// `t1` or `λ`.
///
/// A symbol is a small `Copy` value and is compared by letter, then by index,
/// with the bare letter before its indexed companions. Letters are meant to be
/// Latin or Greek ones: only these can be read back from text.
///
/// ```
/// use casteljau::Symbol;
/// let first = Symbol::new('t', Some(1));
/// assert_eq!(first.to_string(), "t1");
/// assert!(Symbol::new('t', None) < first && first < Symbol::new('u', None));
/// ```
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Symbol {
    letter: char,
    index: Option<u32>,
}

impl Symbol {
    /// The symbol with this letter and index.
    #[must_use]
    pub const fn new(letter: char, index: Option<u32>) -> Self {
        Self { letter, index }
    }

    /// The letter.
    #[must_use]
    pub const fn letter(self) -> char {
        self.letter
    }

    /// The index, if there is one.
    #[must_use]
    pub const fn index(self) -> Option<u32> {
        self.index
    }

    /// The same letter with another index.
    #[must_use]
    pub const fn with_index(self, index: u32) -> Self {
        Self { letter: self.letter, index: Some(index) }
    }

    /// Whether a character can be the letter of a symbol: a Latin or Greek
    /// letter without an accent.
    #[must_use]
    pub const fn is_letter(letter: char) -> bool {
        letter.is_ascii_alphabetic() || matches!(letter, 'α'..='ω' | 'Α'..='Ρ' | 'Σ'..='Ω')
    }
}

impl fmt::Display for Symbol {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.index {
            None => write!(f, "{}", self.letter),
            Some(index) => write!(f, "{}{index}", self.letter),
        }
    }
}

impl fmt::Debug for Symbol {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        fmt::Display::fmt(self, f)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn order_and_text() {
        let mut symbols = [
            Symbol::new('u', None),
            Symbol::new('t', Some(10)),
            Symbol::new('t', Some(2)),
            Symbol::new('t', None),
            Symbol::new('λ', Some(1)),
        ];
        symbols.sort();
        assert_eq!(format!("{symbols:?}"), "[t, t2, t10, u, λ1]");
    }

    #[test]
    fn letters() {
        for letter in ['a', 'Z', 'λ', 'Ω', 'σ'] {
            assert!(Symbol::is_letter(letter), "{letter}");
        }
        for letter in ['é', '1', 'ж', '_', 'ά'] {
            assert!(!Symbol::is_letter(letter), "{letter}");
        }
    }
}
