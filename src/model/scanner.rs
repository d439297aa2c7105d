//! Numbers and words between blanks: what the plain formats of patches have in common.

use super::decimals::Decimals;
use super::place::{Flaw, Place, Places};
use crate::exact::{ParseNumberError, Rational};
use crate::syntax::limits::MAX_DEGREE;

/// A text, read word by word from the beginning.
#[derive(Debug)]
pub(super) struct Scanner<'a> {
    text: &'a str,
    at: usize,
    places: Places<'a>,
    /// Whether a comma ends a word and stands between words.
    commas: bool,
    pub(super) decimals: Decimals,
}

/// A word of a text.
#[derive(Clone, Copy, Debug)]
pub(super) struct Word<'a> {
    pub(super) text: &'a str,
    /// Its first byte in the file.
    pub(super) at: usize,
    /// Whether it is the first of its line.
    pub(super) starts_line: bool,
}

impl Word<'_> {
    /// A whole number that is not negative; one that no file can reach is the largest there is.
    pub(super) fn whole(self) -> Option<usize> {
        let is_whole = self.text.bytes().all(|byte| byte.is_ascii_digit());
        is_whole.then(|| self.text.parse().unwrap_or(usize::MAX))
    }
}

impl<'a> Scanner<'a> {
    /// A text whose words stand between blanks and line ends.
    pub(super) fn new(text: &'a str) -> Self {
        Self { text, at: 0, places: Places::new(text), commas: false, decimals: Decimals::default() }
    }

    /// A text whose words stand between blanks, line ends and single commas.
    pub(super) fn with_commas(text: &'a str) -> Self {
        Self { commas: true, ..Self::new(text) }
    }

    /// The next word, if there is one.
    pub(super) fn next(&mut self) -> Option<Word<'a>> {
        let bytes = self.text.as_bytes();
        let (mut at, mut starts_line, mut comma) = (self.at, self.at == 0, !self.commas || self.at == 0);
        while let Some(byte) = bytes.get(at) {
            match byte {
                b'\n' => starts_line = true,
                b',' if !comma => comma = true,
                b' ' | b'\t' | b'\r' | b'\x0B' | b'\x0C' => {}
                _ => break,
            }
            at += 1;
        }
        let ends = |byte: &u8| byte.is_ascii_whitespace() || *byte == b'\x0B' || (self.commas && *byte == b',');
        let rest = &bytes[at..];
        // A comma too many is a word of its own, which nothing expects.
        let length = rest.iter().position(ends).unwrap_or(rest.len()).max(usize::from(!rest.is_empty()));
        self.at = at + length;
        // Blanks and commas are ASCII, so the word is cut at characters.
        (length > 0).then(|| Word { text: &self.text[at..at + length], at, starts_line })
    }

    /// The next word, which is left in place.
    pub(super) fn peek(&mut self) -> Option<Word<'a>> {
        let before = self.at;
        let word = self.next();
        self.at = before;
        word
    }

    /// The rest of the line.
    pub(super) fn rest_of_line(&mut self) -> &'a str {
        let rest = &self.text[self.at..];
        let length = rest.find('\n').unwrap_or(rest.len());
        self.at += length;
        &rest[..length]
    }

    /// The bytes that are left to read. Everything takes at least two, with the
    /// blank behind it, so a count in the file can be held against it.
    pub(super) fn left(&self) -> usize {
        self.text.len() - self.at
    }

    /// Goes back, or on, to a byte.
    pub(super) fn go_to(&mut self, at: usize) {
        self.at = at;
    }

    /// The place of a byte.
    pub(super) fn place(&mut self, at: usize) -> Place {
        self.places.of(at)
    }

    /// The place of the next word.
    pub(super) fn here(&mut self) -> Place {
        let at = self.peek().map_or(self.text.len(), |word| word.at);
        self.place(at)
    }

    /// Something else was found than was expected; without a word, the end of the file was.
    pub(super) fn unexpected(&mut self, found: Option<Word<'a>>, expected: impl std::fmt::Display) -> Flaw {
        match found {
            Some(word) => Flaw::expected(self.place(word.at), word.text, expected),
            None => Flaw::at(self.places.of(self.text.trim_end().len()), format!("the file ends here, expected {expected}")),
        }
    }

    /// A coordinate. `1.` is read as the programs that write these formats do.
    pub(super) fn number(&mut self, expected: impl std::fmt::Display) -> Result<Rational, Flaw> {
        let word = self.next();
        self.number_in(word, expected)
    }

    /// A coordinate that is this word.
    pub(super) fn number_in(&mut self, word: Option<Word<'a>>, expected: impl std::fmt::Display) -> Result<Rational, Flaw> {
        let Some(word) = word else { return Err(self.unexpected(None, expected)) };
        match read_scanned(&mut self.decimals, word.text) {
            Ok(number) => Ok(number),
            Err(ParseNumberError::Malformed) => Err(self.unexpected(Some(word), expected)),
            Err(error) => Err(self.unexpected(Some(word), format_args!("{expected}: {error}"))),
        }
    }

    /// The coordinates of so many points, point by point.
    pub(super) fn points(&mut self, count: usize, dimension: usize) -> Result<Vec<Rational>, Flaw> {
        let all = count.saturating_mul(dimension);
        let mut coordinates = Vec::with_capacity(all.min(self.left() / 2 + 1));
        for _ in 0..all {
            coordinates.push(self.number(format_args!("a coordinate, {dimension} for each of {count} points"))?);
        }
        Ok(coordinates)
    }

    /// Copies of numbers that were read, which may be used again and again.
    pub(super) fn copies(&mut self, numbers: &[Rational], at: usize, into: &mut Vec<Rational>) -> Result<(), Flaw> {
        for number in numbers {
            self.decimals.hold(number).map_err(|error| Flaw::at(self.places.of(at), format!("the points are too long: {error}")))?;
            into.push(number.clone());
        }
        Ok(())
    }

    /// A whole number that is not negative.
    pub(super) fn count(&mut self, expected: impl std::fmt::Display) -> Result<usize, Flaw> {
        let word = self.next();
        word.and_then(Word::whole).ok_or_else(|| self.unexpected(word, expected))
    }

    /// A degree within the limit.
    pub(super) fn degree(&mut self, expected: &str) -> Result<usize, Flaw> {
        let word = self.next();
        match word.and_then(Word::whole) {
            Some(degree) if degree <= MAX_DEGREE as usize => Ok(degree),
            _ => Err(self.unexpected(word, format_args!("{expected}, a whole number up to {MAX_DEGREE}"))),
        }
    }

    /// Refuses anything behind the end of the data.
    pub(super) fn finish(&mut self) -> Result<(), Flaw> {
        match self.next() {
            None => Ok(()),
            word => Err(self.unexpected(word, "the end of the file")),
        }
    }
}

/// A number as `scanf` takes it: also with a dot and no digit behind it.
pub(super) fn read_scanned(decimals: &mut Decimals, word: &str) -> Result<Rational, ParseNumberError> {
    decimals.read(word).or_else(|error| match word.find('.') {
        Some(dot) if word[..dot].ends_with(|letter: char| letter.is_ascii_digit()) => {
            let rest = &word[dot + 1..];
            if rest.is_empty() {
                decimals.read(&word[..dot])
            } else if rest.starts_with(['e', 'E']) {
                decimals.read(&word.replacen('.', "", 1))
            } else {
                Err(error)
            }
        }
        _ => Err(error),
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn words_and_their_places() {
        let mut scanner = Scanner::new(" one\ttwo\r\n\nthrée x");
        let words: Vec<(&str, bool, Place)> = std::iter::from_fn(|| {
            let word = scanner.next()?;
            Some((word.text, word.starts_line, scanner.place(word.at)))
        })
        .collect();
        let place = |line, column| Place { line, column };
        assert_eq!(
            words,
            [("one", true, place(1, 2)), ("two", false, place(1, 6)), ("thrée", true, place(3, 1)), ("x", false, place(3, 7))]
        );
    }

    #[test]
    fn one_comma_stands_between_words() {
        let words = |text| {
            let mut scanner = Scanner::with_commas(text);
            std::iter::from_fn(|| scanner.next().map(|word| word.text)).collect::<Vec<_>>()
        };
        assert_eq!(words("1,2 , 3 4"), ["1", "2", "3", "4"]);
        assert_eq!(words("1,,2"), ["1", ",", "2"]);
        assert_eq!(words(",1"), [",", "1"]);
    }

    #[test]
    fn numbers_as_programs_write_them() {
        for (text, value) in [("1.", "1"), ("-2.e3", "-2000"), ("1.5e-05", "3/200000"), ("+.5", "1/2")] {
            assert_eq!(Scanner::new(text).number("a number").map(|number| number.to_string()).as_deref(), Ok(value));
        }
        for text in ["nan", "-inf", ".", "1..", "1.x", "1e", "0x1p3", "\0", "1e999999999", ""] {
            assert!(Scanner::new(text).number("a number").is_err(), "{text}");
        }
    }

    #[test]
    fn counts_beyond_all_files_are_not_believed() {
        assert_eq!(Scanner::new("99999999999999999999999").count("a count"), Ok(usize::MAX));
        let flaw = Scanner::new("\n -3").count("a count").expect_err("negative");
        assert_eq!((flaw.place, flaw.message.as_str()), (Some(Place { line: 2, column: 2 }), "found `-3`, expected a count"));
    }
}
