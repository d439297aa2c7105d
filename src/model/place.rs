//! Places in files, and what is wrong there.

use std::fmt;

use super::json::excerpt;
use crate::syntax::Lines;

/// A place in a text file.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Place {
    /// The line, from 1.
    pub line: u32,
    /// The column in characters, from 1.
    pub column: u32,
}

impl fmt::Display for Place {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}:{}", self.line, self.column)
    }
}

impl From<(usize, usize)> for Place {
    fn from((line, column): (usize, usize)) -> Self {
        let number = |count: usize| u32::try_from(count).unwrap_or(u32::MAX);
        Self { line: number(line), column: number(column) }
    }
}

/// The places of bytes of a text.
#[derive(Clone, Debug)]
pub struct Places<'a>(Lines<'a>);

impl<'a> Places<'a> {
    /// The places of a text.
    #[must_use]
    pub fn new(text: &'a str) -> Self {
        Self(Lines::new(text))
    }

    /// The place of a byte.
    #[must_use]
    pub fn of(&self, byte: usize) -> Place {
        self.0.position(byte).into()
    }
}

/// Why a file cannot be read as what it should be.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Flaw {
    /// Where, if it is at one place.
    pub place: Option<Place>,
    /// What was found and what was expected.
    pub message: String,
}

impl Flaw {
    /// A flaw at a place.
    #[must_use]
    pub fn at(place: Place, message: impl Into<String>) -> Self {
        Self { place: Some(place), message: message.into() }
    }

    /// Something else was found than was expected.
    #[must_use]
    pub fn expected(place: Place, found: &str, expected: impl fmt::Display) -> Self {
        Self::at(place, format!("found {}, expected {expected}", shown(found)))
    }

    /// A flaw of the whole file.
    #[must_use]
    pub fn of_file(message: impl Into<String>) -> Self {
        Self { place: None, message: message.into() }
    }
}

/// A text in a message: its beginning, without characters that move a cursor.
pub(crate) fn shown(text: &str) -> String {
    if text.is_empty() {
        return "nothing".into();
    }
    let plain = |letter: char| if letter.is_control() { char::REPLACEMENT_CHARACTER } else { letter };
    format!("`{}`", excerpt(text).chars().map(plain).collect::<String>())
}

impl fmt::Display for Flaw {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.message)
    }
}

impl std::error::Error for Flaw {}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn found_texts_are_short_and_plain() {
        assert_eq!(shown("a\u{1b}[2J"), "`a\u{fffd}[2J`");
        assert_eq!(shown(""), "nothing");
        assert!(shown(&"9".repeat(10_000_000)).len() < 100);
    }
}
