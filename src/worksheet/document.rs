//! Worksheets as files: Markdown with fenced blocks and formulas, or statements alone.

use std::borrow::Cow;
use std::ops::Range;

use pulldown_cmark::{CodeBlockKind, Event, Options, Parser, Tag, TagEnd};

use crate::syntax::{Span, SyntaxError};

/// The most bytes of a worksheet.
pub const MAX_WORKSHEET_BYTES: usize = 16 << 20;

/// The language of fenced blocks with statements.
const LANGUAGE: &str = "casteljau";

/// What kind of file a worksheet is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Format {
    /// Markdown.
    Markdown,
    /// Statements alone.
    Statements,
}

impl Format {
    /// The format of a file by its name: `.cj` is statements, all else Markdown.
    #[must_use]
    pub fn of_path(path: &str) -> Self {
        if path.ends_with(".cj") { Self::Statements } else { Self::Markdown }
    }
}

/// A part of a worksheet that is read.
#[derive(Clone, Debug)]
pub(super) struct Block {
    /// The text, without what Markdown puts before each line.
    pub(super) text: String,
    /// Where parts of the text stand in the file: offset here, offset there.
    pieces: Vec<(usize, usize)>,
    /// Whether the text is one formula in LaTeX.
    pub(super) is_formula: bool,
    /// All of the block in the file, fences included.
    pub(super) range: Range<usize>,
}

impl Block {
    fn new(is_formula: bool, range: Range<usize>) -> Self {
        Self { text: String::new(), pieces: Vec::new(), is_formula, range }
    }

    fn push(&mut self, text: &str, place: usize) {
        self.pieces.push((self.text.len(), place));
        self.text.push_str(text);
    }

    fn place(&self, offset: usize) -> usize {
        let next = self.pieces.partition_point(|piece| piece.0 <= offset);
        match next.checked_sub(1).and_then(|last| self.pieces.get(last)) {
            Some((here, there)) => there + (offset - here),
            None => self.range.start,
        }
    }

    /// A place of the text as a place of the file.
    pub(super) fn in_file(&self, span: Span) -> Span {
        let start = self.place(span.start);
        let end = if span.end > span.start { self.place(span.end - 1) + 1 } else { start };
        Span::new(start, end.max(start))
    }
}

/// A worksheet taken apart.
pub(super) struct Document {
    pub(super) blocks: Vec<Block>,
    /// What is wrong with the file as such.
    pub(super) errors: Vec<SyntaxError>,
    /// Comments without a formula behind them.
    pub(super) warnings: Vec<SyntaxError>,
}

/// What Markdown is read with, here and where it is rendered.
pub(super) fn options() -> Options {
    Options::ENABLE_MATH | Options::ENABLE_TABLES | Options::ENABLE_FOOTNOTES | Options::ENABLE_STRIKETHROUGH
}

/// The text as Markdown is read: a byte order mark as blanks of its length, since
/// a fence may not stand behind one.
pub(super) fn marked_down(source: &str) -> Cow<'_, str> {
    match source.strip_prefix('\u{feff}') {
        Some(rest) => Cow::Owned(format!("{:1$}{rest}", "", '\u{feff}'.len_utf8())),
        None => Cow::Borrowed(source),
    }
}

impl Document {
    pub(super) fn new(source: &str, format: Format) -> Self {
        let mut document = Self { blocks: Vec::new(), errors: Vec::new(), warnings: Vec::new() };
        if source.len() > MAX_WORKSHEET_BYTES {
            let message = format!("found a worksheet of {} bytes, expected at most {MAX_WORKSHEET_BYTES}", source.len());
            document.errors.push(SyntaxError::new(Span::new(0, 0), message));
            return document;
        }
        match format {
            Format::Statements => {
                let mark = if source.starts_with('\u{feff}') { '\u{feff}'.len_utf8() } else { 0 };
                let mut block = Block::new(false, mark..source.len());
                block.push(&source[mark..], mark);
                document.blocks.push(block);
            }
            Format::Markdown => document.read_markdown(&marked_down(source)),
        }
        document
    }

    fn read_markdown(&mut self, source: &str) {
        // The comment that makes the next formula a statement.
        let mut mark: Option<Range<usize>> = None;
        let mut open: Option<Block> = None;
        for (event, range) in Parser::new_ext(source, options()).into_offset_iter() {
            match event {
                Event::Start(Tag::CodeBlock(CodeBlockKind::Fenced(info))) => {
                    let language = info.split([' ', ',', '\t']).next().unwrap_or("");
                    let is_formula = language == "math" && mark.is_some();
                    if is_formula || language == LANGUAGE {
                        open = Some(Block::new(is_formula, range.clone()));
                        if !is_closed(&source[range.clone()]) {
                            let line_end = source[range.start..].find('\n').map_or(source.len(), |length| range.start + length);
                            let error = SyntaxError::new(
                                Span::new(range.start, line_end),
                                "found a fence that is never closed, expected one more below",
                            );
                            self.errors.push(error);
                            open = None;
                        }
                    }
                    if is_formula {
                        mark = None;
                    } else {
                        self.forgotten(&mut mark);
                    }
                }
                Event::Text(text) => {
                    if let Some(block) = &mut open {
                        block.push(&text, range.start);
                    }
                }
                Event::End(TagEnd::CodeBlock) => self.blocks.extend(open.take()),
                Event::DisplayMath(text) if mark.is_some() => {
                    mark = None;
                    let mut block = Block::new(true, range.clone());
                    formula(&mut block, &text, source, range);
                    self.blocks.push(block);
                }
                Event::Html(text) | Event::InlineHtml(text) => {
                    let inside = text.trim().strip_prefix("<!--").and_then(|rest| rest.strip_suffix("-->"));
                    if inside.is_some_and(|inside| inside.trim() == LANGUAGE) {
                        self.forgotten(&mut mark);
                        mark = Some(range);
                    }
                }
                Event::Start(Tag::Heading { .. }) => self.forgotten(&mut mark),
                _ => {}
            }
        }
        self.forgotten(&mut mark);
    }

    fn forgotten(&mut self, mark: &mut Option<Range<usize>>) {
        if let Some(range) = mark.take() {
            let message = "found this comment without a formula below it, expected a `$$ … $$` or a ```math block";
            self.warnings.push(SyntaxError::new(Span::new(range.start, range.end), message));
        }
    }
}

/// Whether the last line of a fenced block closes it.
fn is_closed(block: &str) -> bool {
    let bare = |line: &str| line.trim_matches(|c: char| c.is_whitespace() || c == '>').to_owned();
    let opening = block.lines().next().map(bare).unwrap_or_default();
    let Some(sign) = opening.chars().next() else { return false };
    let length = opening.chars().take_while(|c| *c == sign).count();
    let last = block.trim_end().lines().skip(1).last().map(bare).unwrap_or_default();
    last.chars().count() >= length && last.chars().all(|c| c == sign)
}

/// A formula line by line, as far as its lines are found again in the file.
fn formula(block: &mut Block, text: &str, source: &str, range: Range<usize>) {
    let mut place = range.start + "$$".len();
    for line in text.split_inclusive('\n') {
        let content = line.trim_end_matches(['\n', '\r']);
        let found = source.get(place..range.end).and_then(|rest| rest.find(content));
        place += found.unwrap_or(0);
        block.push(line, place);
        place += content.len();
    }
}

/// The statements of a block of lines, as parts of its text, with comments blanked out.
pub(super) fn statements(text: &str) -> (String, Vec<Range<usize>>) {
    let clean = without_comments(text);
    let mut statements = Vec::new();
    let mut start = 0;
    // Lines that a bracket swallowed are read again, but not too often.
    let mut patience = 16;
    while start < clean.len() {
        let (end, closed) = extent(&clean, start, patience > 0);
        if !closed {
            patience -= i32::from(patience > 0);
        }
        if !clean[start..end].trim().is_empty() {
            statements.push(start..end);
        }
        start = end;
    }
    (clean, statements)
}

/// Where the statement that begins at `start` ends, and whether its brackets are closed there.
fn extent(text: &str, start: usize, across_lines: bool) -> (usize, bool) {
    let mut depth = 0usize;
    let mut first_line = None;
    for (offset, c) in text[start..].char_indices() {
        match c {
            '(' | '[' | '{' => depth += 1,
            ')' | ']' | '}' => depth = depth.saturating_sub(1),
            '\n' => {
                let end = start + offset + 1;
                if depth == 0 || !across_lines {
                    return (end, depth == 0);
                }
                first_line.get_or_insert(end);
                // A definition below tells that a bracket was forgotten above.
                if begins_definition(&text[end..]) {
                    return (first_line.unwrap_or(end), false);
                }
            }
            _ => {}
        }
    }
    match first_line {
        Some(end) if depth > 0 => (end, false),
        _ => (text.len(), depth == 0),
    }
}

/// The comments of a block of lines, with their places.
pub(super) fn comments(text: &str) -> Vec<(usize, &str)> {
    let mut at = 0;
    let mut found = Vec::new();
    for line in text.split_inclusive('\n') {
        if let Some(place) = line.find('#') {
            let comment = line[place..].trim_start_matches('#').trim();
            if !comment.is_empty() {
                found.push((at + place, comment));
            }
        }
        at += line.len();
    }
    found
}

/// Whether a line begins with a name and `=`.
fn begins_definition(text: &str) -> bool {
    let line = text.lines().next().unwrap_or("");
    head(line).is_some()
}

/// The name that a line defines, if it has the form of a definition, and what follows the `=`.
pub(super) fn head(line: &str) -> Option<(crate::symbolic::Symbol, &str)> {
    let line = line.trim_start();
    let letter = line.chars().next().filter(|c| crate::symbolic::Symbol::is_letter(*c))?;
    let mut rest = &line[letter.len_utf8()..];
    rest = rest.strip_prefix('_').unwrap_or(rest);
    rest = rest.strip_prefix('{').unwrap_or(rest);
    let digits = rest.len() - rest.trim_start_matches(|c: char| c.is_ascii_digit()).len();
    let index = rest[..digits].parse().ok();
    rest = &rest[digits..];
    rest = rest.strip_prefix('}').unwrap_or(rest);
    if let Some(inside) = rest.strip_prefix("\\left(").or_else(|| rest.strip_prefix('(')) {
        let (arguments, behind) = inside.split_once(')')?;
        if arguments.chars().any(|c| !(c.is_alphanumeric() || " ,;_{}\\".contains(c))) {
            return None;
        }
        rest = behind;
    }
    let body = rest.trim_start().trim_start_matches('&').trim_start().strip_prefix('=')?;
    if body.starts_with('=') { None } else { Some((crate::symbolic::Symbol::new(letter, index), body)) }
}

/// The same text with blanks in place of comments, so that places stay.
fn without_comments(text: &str) -> String {
    let mut clean = String::with_capacity(text.len());
    let mut comment = false;
    for c in text.chars() {
        comment = match c {
            '#' => true,
            '\n' => false,
            _ => comment,
        };
        if comment {
            clean.extend(std::iter::repeat_n(' ', c.len_utf8()));
        } else {
            clean.push(c);
        }
    }
    clean
}

#[cfg(test)]
mod tests {
    use super::*;

    fn blocks(source: &str) -> Vec<(bool, String)> {
        Document::new(source, Format::Markdown).blocks.into_iter().map(|block| (block.is_formula, block.text)).collect()
    }

    #[test]
    fn fences_and_formulas() {
        let source = "# A\n\n```casteljau\na = 1\n```\n\n```rust\nb = 2\n```\n\n<!-- casteljau -->\n$$F(t) = t^2$$\n\n$$G(t)$$\n\n<!-- casteljau -->\n```math\nc = 3\n```\n";
        let expected = [(false, "a = 1\n"), (true, "F(t) = t^2"), (true, "c = 3\n")];
        assert_eq!(blocks(source), expected.map(|(formula, text)| (formula, text.to_owned())));
    }

    #[test]
    fn places_lead_back_to_the_file() {
        for source in [
            "text\n\n> ```casteljau\n> first\n> needle\n> ```\n",
            "\u{feff}- item\n\n  ```casteljau\n  needle\n  ```\n",
            "\u{feff}```casteljau\nneedle\n```\n",
            "```casteljau\r\nfirst\r\nneedle\r\n```\r\n",
            "<!-- casteljau -->\n$$\na\nneedle\n$$\n",
            "> <!-- casteljau -->\n> $$\n> a\n> needle\n> $$\n",
        ] {
            let document = Document::new(source, Format::Markdown);
            let block = document.blocks.first().expect("a block");
            let at = block.text.find("needle").expect("the text");
            assert_eq!(block.in_file(Span::new(at, at + 6)).text(source), "needle", "{source:?}");
        }
    }

    #[test]
    fn what_is_left_open_is_told() {
        let document = Document::new("a\n\n```casteljau\na = 1\n", Format::Markdown);
        assert_eq!((document.blocks.len(), document.errors.len()), (0, 1));
        assert_eq!(document.errors[0].span.text("a\n\n```casteljau\na = 1\n"), "```casteljau");
        let document = Document::new("<!-- casteljau -->\n\n# B\n\n$$a$$\n", Format::Markdown);
        assert_eq!((document.blocks.len(), document.warnings.len()), (0, 1));
    }

    #[test]
    fn statements_end_with_the_line_outside_brackets() {
        let parts = |text: &str| {
            let (clean, statements) = statements(text);
            statements.into_iter().map(|range| clean[range].trim_end().to_owned()).collect::<Vec<_>>()
        };
        assert_eq!(parts("a = 1 # (\n\nb = (1,\n 2)\nc"), ["a = 1", "b = (1,\n 2)", "c"]);
        // A bracket that is never closed swallows no definition.
        assert_eq!(parts("a == (1\nF(t) = t\nF(1) == 1"), ["a == (1", "F(t) = t", "F(1) == 1"]);
        assert_eq!(parts("a == (1\n2 == 2"), ["a == (1", "2 == 2"]);
    }

    #[test]
    fn heads() {
        let name = |line| head(line).map(|(name, _)| name.to_string());
        assert_eq!(name("F_1(t) = t"), Some("F1".to_owned()));
        assert_eq!(name("  S(u,v) = 1"), Some("S".to_owned()));
        assert_eq!(name("a=1"), Some("a".to_owned()));
        assert_eq!(name("f(1) == 1"), None);
        assert_eq!(name("f(1+t) = 1"), None);
        assert_eq!(name("x == 2"), None);
    }
}
