//! The lines of a text.

use super::Span;

/// Where the lines of a text begin, found once, so that no place is counted
/// from the start of the text or of a long line.
///
/// A byte order mark at the beginning belongs to no line.
#[derive(Clone, Debug)]
pub struct Lines<'a> {
    text: &'a str,
    /// The first byte of each line.
    starts: Vec<usize>,
    /// How many characters begin before every [`STRIDE`]th byte.
    counts: Vec<usize>,
}

const STRIDE: usize = 256;

/// How many characters begin in these bytes: continuation bytes of UTF-8 do not count.
fn characters(bytes: &[u8]) -> usize {
    bytes.iter().filter(|&&byte| byte & 0xC0 != 0x80).count()
}

impl<'a> Lines<'a> {
    /// The lines of a text.
    #[must_use]
    pub fn new(text: &'a str) -> Self {
        let first = if text.starts_with('\u{feff}') { '\u{feff}'.len_utf8() } else { 0 };
        let starts = std::iter::once(first).chain(text.match_indices('\n').map(|(at, _)| at + 1)).collect();
        let mut before = 0;
        let count = |chunk: &[u8]| {
            let behind = before + characters(chunk);
            std::mem::replace(&mut before, behind)
        };
        let counts = text.as_bytes().chunks(STRIDE).map(count).collect();
        Self { text, starts, counts }
    }

    /// The number of the line that a byte is in, from 1.
    #[must_use]
    pub fn line(&self, byte: usize) -> usize {
        self.starts.partition_point(|start| *start <= byte.min(self.text.len())).max(1)
    }

    /// Line and column of a byte, both from 1; columns count characters. What lies behind the text is at its end.
    #[must_use]
    pub fn position(&self, byte: usize) -> (usize, usize) {
        let line = self.line(byte);
        let column = self.before(byte).saturating_sub(self.before(self.starts[line - 1]));
        (line, column + 1)
    }

    /// The bytes of a line, without its end; `None` if there is no such line.
    #[must_use]
    pub fn span(&self, line: usize) -> Option<Span> {
        let start = *self.starts.get(line.checked_sub(1)?)?;
        let Some(next) = self.starts.get(line) else { return Some(Span::new(start, self.text.len())) };
        let inside = &self.text[start..next - 1];
        Some(Span::new(start, start + inside.strip_suffix('\r').unwrap_or(inside).len()))
    }

    /// The byte at a line and column, at the end of the line if it is shorter; `None` if there is no such line.
    #[must_use]
    pub fn byte(&self, line: usize, column: usize) -> Option<usize> {
        let span = self.span(line)?;
        let wanted = self.before(span.start) + column.saturating_sub(1);
        let chunk = self.counts.partition_point(|count| *count <= wanted).saturating_sub(1);
        let (from, passed) = match chunk * STRIDE {
            from if from > span.start => (from, self.counts[chunk]),
            _ => (span.start, self.before(span.start)),
        };
        let inside = self.text.as_bytes().get(from..span.end).unwrap_or_default();
        let mut beginnings = (from..).zip(inside).filter(|(_, byte)| **byte & 0xC0 != 0x80).map(|(at, _)| at);
        Some(beginnings.nth(wanted - passed).unwrap_or(span.end))
    }

    /// The text.
    #[must_use]
    pub fn text(&self) -> &'a str {
        self.text
    }

    /// How many characters begin before a byte.
    fn before(&self, byte: usize) -> usize {
        let byte = byte.min(self.text.len());
        let chunk = (byte / STRIDE).min(self.counts.len().saturating_sub(1));
        self.counts.get(chunk).map_or(0, |count| count + characters(&self.text.as_bytes()[chunk * STRIDE..byte]))
    }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    #[test]
    fn places_count_characters_from_one() {
        let text = "ab\nπx\r\ny";
        let lines = Lines::new(text);
        for (byte, place) in [(0, (1, 1)), (2, (1, 3)), (3, (2, 1)), (5, (2, 2)), (8, (3, 1)), (99, (3, 2))] {
            assert_eq!(lines.position(byte), place, "byte {byte}");
        }
        let spans: Vec<&str> = (0..5).filter_map(|line| lines.span(line)).map(|span| span.text(text)).collect();
        assert_eq!(spans, ["ab", "πx", "y"]);
        assert_eq!([lines.byte(2, 2), lines.byte(1, 9), lines.byte(4, 1)], [Some(5), Some(2), None]);
        let marked = Lines::new("\u{feff}ab\nc");
        assert_eq!([0, 3, 4, 6].map(|byte| marked.position(byte)), [(1, 1), (1, 1), (1, 2), (2, 1)]);
        assert_eq!(Lines::new("").position(0), (1, 1));
    }

    proptest! {
        /// Against counting from the start, in short lines and in ones beyond a stride.
        #[test]
        fn places_are_those_counted_from_the_start(pieces in prop::collection::vec("[a-c]{0,900}|[πλ½]{0,700}|\n|\r\n", 0..8)) {
            let text = pieces.concat();
            let lines = Lines::new(&text);
            let (mut line, mut column) = (1, 1);
            for (byte, letter) in text.char_indices() {
                prop_assert_eq!(lines.position(byte), (line, column), "byte {}", byte);
                let content = text.lines().nth(line - 1).map(str::len);
                prop_assert_eq!(lines.span(line).map(|span| span.end - span.start), content);
                let is_end = lines.span(line).is_some_and(|span| byte >= span.end);
                prop_assert!(is_end || lines.byte(line, column) == Some(byte), "byte {}", byte);
                (line, column) = if letter == '\n' { (line + 1, 1) } else { (line, column + 1) };
            }
            prop_assert_eq!(lines.position(text.len()), (line, column));
        }
    }
}
