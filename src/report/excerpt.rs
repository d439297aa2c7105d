//! The part of a line that a message is about.

use std::ops::Range;

use crate::syntax::{Lines, Span};

/// How many bytes are shown on either side.
const REACH: usize = 60;

/// The part of a source line that is worth showing.
pub(crate) struct Excerpt {
    /// The line, from 1.
    pub(crate) line: usize,
    /// What is shown of it.
    pub(crate) text: String,
    /// The bytes of the text that the message is about.
    pub(crate) span: Range<usize>,
    /// Whether the beginning of the line is left out.
    pub(crate) is_cut: bool,
}

impl Excerpt {
    /// The surroundings of a place, as far as they are in the line where it begins.
    pub(crate) fn around(lines: &Lines<'_>, place: Span) -> Self {
        let text = lines.text();
        let floor = |mut at: usize| {
            while !text.is_char_boundary(at) {
                at -= 1;
            }
            at
        };
        let line = lines.line(place.start);
        let whole = lines.span(line).unwrap_or_default();
        let start = floor(place.start.clamp(whole.start, whole.end));
        let end = floor(place.end.clamp(start, whole.end));
        let first = floor(start.saturating_sub(REACH).max(whole.start));
        let last = floor((end.min(start + REACH) + REACH).min(whole.end));
        // Control characters would move the caret away from what it points at.
        let clean = |range: Range<usize>| text[range].chars().map(|c| if c.is_control() { ' ' } else { c }).collect::<String>();
        let is_cut = first > whole.start;
        let before = format!("{}{}", if is_cut { "…" } else { "" }, clean(first..start));
        let marked = clean(start..end.min(last));
        let behind = format!("{}{}", clean(end.min(last)..last), if last < whole.end { "…" } else { "" });
        let span = before.len()..before.len() + marked.len();
        Self { line, text: format!("{before}{marked}{}", behind.trim_end()), span, is_cut }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn excerpts_keep_to_their_line_and_are_short() {
        let around = |text: &str, start, end| {
            let excerpt = Excerpt::around(&Lines::new(text), Span::new(start, end));
            (excerpt.line, excerpt.text[excerpt.span.clone()].to_owned(), excerpt.text.chars().count(), excerpt.is_cut)
        };
        assert_eq!(around("a\nb\tcd\r\ne", 3, 9), (2, " cd".into(), 4, false));
        let long = "½".repeat(5000);
        assert_eq!(around(&long, 5000, 5002), (1, "½".into(), 63, true));
        assert_eq!(around(&long, 0, 10_000), (1, "½".repeat(60), 61, false));
        // Inside a character, behind the end, in nothing.
        assert_eq!(around(&long, 1, 3), (1, "½".into(), 32, false));
        assert_eq!(around("ab\n", 99, 99), (2, String::new(), 0, false));
        assert_eq!(around("\u{feff}", 0, 1), (1, String::new(), 0, false));
    }
}
