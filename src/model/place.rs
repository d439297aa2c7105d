//! Places in files, and what is wrong there.

use std::fmt;

use super::json::excerpt;

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

/// The places of bytes of a text, quickly for bytes in rising order: what lies
/// before the last one asked for is not looked at again.
#[derive(Clone, Debug)]
pub struct Places<'a> {
    text: &'a [u8],
    byte: usize,
    place: Place,
}

impl<'a> Places<'a> {
    /// The places of a text.
    #[must_use]
    pub fn new(text: &'a str) -> Self {
        Self { text: text.as_bytes(), byte: 0, place: Place { line: 1, column: 1 } }
    }

    /// The place of a byte.
    pub fn of(&mut self, byte: usize) -> Place {
        if byte < self.byte {
            (self.byte, self.place) = (0, Place { line: 1, column: 1 });
        }
        let byte = byte.min(self.text.len());
        for &passed in &self.text[self.byte..byte] {
            if passed == b'\n' {
                self.place = Place { line: self.place.line.saturating_add(1), column: 1 };
            } else if passed & 0xC0 != 0x80 {
                // A column is a character: continuation bytes of UTF-8 do not count.
                self.place.column = self.place.column.saturating_add(1);
            }
        }
        self.byte = byte;
        self.place
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
    fn places_count_characters_from_one() {
        let text = "ab\nπx\r\ny";
        let mut rising = Places::new(text);
        for (byte, line, column) in [(0, 1, 1), (2, 1, 3), (3, 2, 1), (5, 2, 2), (8, 3, 1), (99, 3, 2)] {
            let place = Place { line, column };
            assert_eq!((rising.of(byte), Places::new(text).of(byte)), (place, place), "byte {byte}");
        }
        assert_eq!(rising.of(2), Place { line: 1, column: 3 });
    }

    #[test]
    fn found_texts_are_short_and_plain() {
        assert_eq!(shown("a\u{1b}[2J"), "`a\u{fffd}[2J`");
        assert_eq!(shown(""), "nothing");
        assert!(shown(&"9".repeat(10_000_000)).len() < 100);
    }
}
