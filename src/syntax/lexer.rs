//! From text to tokens.

use super::latex::{self, Command};
use super::limits::MAX_INPUT_BYTES;
use super::token::{Bracket, Comparison, Token, TokenKind};
use super::{Span, SyntaxError};
use crate::symbolic::Symbol;

const SUPERSCRIPTS: [char; 10] = ['⁰', '¹', '²', '³', '⁴', '⁵', '⁶', '⁷', '⁸', '⁹'];

/// Fractions that are one character, with their values.
pub(crate) const VULGAR_FRACTIONS: [(char, i64, i64); 15] = [
    ('½', 1, 2),
    ('⅓', 1, 3),
    ('⅔', 2, 3),
    ('¼', 1, 4),
    ('¾', 3, 4),
    ('⅕', 1, 5),
    ('⅖', 2, 5),
    ('⅗', 3, 5),
    ('⅘', 4, 5),
    ('⅙', 1, 6),
    ('⅚', 5, 6),
    ('⅛', 1, 8),
    ('⅜', 3, 8),
    ('⅝', 5, 8),
    ('⅞', 7, 8),
];

/// The digits that a text in superscript digits stands for.
pub(crate) fn superscript_digits(text: &str) -> String {
    text.chars()
        .filter_map(|c| SUPERSCRIPTS.iter().position(|&digit| digit == c))
        .filter_map(|digit| char::from_digit(digit as u32, 10))
        .collect()
}

/// Whether a text is LaTeX: it contains a backslash or the sign of a math block.
pub(crate) fn is_latex(source: &str) -> bool {
    source.contains(['\\', '$'])
}

/// How the letters and signs of a text are read.
#[derive(Clone, Copy)]
pub(crate) struct Spelling {
    /// Whether the text is LaTeX.
    pub(crate) latex: bool,
    /// The words that are more than products of their letters.
    pub(crate) word: fn(&str) -> Option<&'static str>,
}

impl Spelling {
    /// The spelling of mathematics without words.
    pub(crate) fn of(source: &str) -> Self {
        Self { latex: is_latex(source), word: |_| None }
    }
}

/// The tokens of a text, ended by one [`TokenKind::End`].
pub(crate) fn tokens(source: &str, spelling: Spelling) -> Result<Vec<Token>, SyntaxError> {
    if source.len() > MAX_INPUT_BYTES {
        let message = format!("found {} bytes of input, expected at most {MAX_INPUT_BYTES}", source.len());
        return Err(SyntaxError::new(Span::new(0, 0), message));
    }
    let Spelling { latex, word } = spelling;
    let mut lexer = Lexer { source, at: 0, latex, word, tokens: Vec::with_capacity(source.len() / 2 + 1), blank: false, line_break: false };
    while lexer.step()? {}
    Ok(lexer.tokens)
}

pub(crate) struct Lexer<'a> {
    pub(crate) source: &'a str,
    pub(crate) at: usize,
    pub(crate) latex: bool,
    word: fn(&str) -> Option<&'static str>,
    tokens: Vec<Token>,
    blank: bool,
    line_break: bool,
}

impl<'a> Lexer<'a> {
    pub(crate) fn rest(&self) -> &'a str {
        self.source.get(self.at..).unwrap_or("")
    }

    pub(crate) fn peek(&self) -> Option<char> {
        self.rest().chars().next()
    }

    pub(crate) fn skip(&mut self, matches: impl Fn(char) -> bool) -> &'a str {
        let rest = self.rest();
        let length = rest.find(|c| !matches(c)).unwrap_or(rest.len());
        self.at += length;
        &rest[..length]
    }

    pub(crate) fn push(&mut self, kind: TokenKind, start: usize) {
        let span = Span::new(start, self.at);
        self.tokens.push(Token { kind, span, blank_before: self.blank, break_before: self.line_break });
        (self.blank, self.line_break) = (false, false);
    }

    /// Reads one token or one piece of layout; false at the end.
    fn step(&mut self) -> Result<bool, SyntaxError> {
        let start = self.at;
        let Some(c) = self.peek() else {
            self.finish();
            return Ok(false);
        };
        self.at += c.len_utf8();
        match c {
            '\n' | '\r' => (self.blank, self.line_break) = (true, true),
            // A mark at the very beginning tells the encoding and is no text.
            '\u{feff}' if start == 0 => self.blank = true,
            _ if c.is_whitespace() => self.blank = true,
            '0'..='9' => self.number(start)?,
            '.' if self.rest().starts_with(|next: char| next.is_ascii_digit()) => self.number(start)?,
            '.' if self.rest().starts_with('.') => {
                self.at += 1;
                // `0...1` may be meant as `0..1` or as `0..0.1`.
                if self.rest().starts_with('.') {
                    let span = Span::new(start, self.at + 1);
                    return Err(SyntaxError::new(span, "found `...`, expected `..`")
                        .with_help("a decimal after `..` begins with a digit: `0..0.1`"));
                }
                self.push(TokenKind::Range, start);
            }
            '.' => self.dot(start)?,
            's' if self.is_root(start) => {
                self.at = start + "sqrt".len();
                self.push(TokenKind::Root, start);
            }
            'µ' => self.symbol('μ', start)?,
            _ if Symbol::is_letter(c) => match self.word_at(start) {
                Some((word, length)) => {
                    self.at = start + length;
                    self.push(TokenKind::Word(word), start);
                }
                None => self.symbol(c, start)?,
            },
            '\\' => self.command(start)?,
            '$' => (self.blank, self.line_break) = (true, true),
            '&' | '~' if self.latex => self.blank = true,
            _ if SUPERSCRIPTS.contains(&c) => {
                self.skip(|c| SUPERSCRIPTS.contains(&c));
                self.push(TokenKind::Superscript, start);
            }
            _ if VULGAR_FRACTIONS.iter().any(|entry| entry.0 == c) => self.vulgar_fraction(start)?,
            _ => match self.operator(c) {
                Some(kind) => self.push(kind, start),
                None => return Err(self.unknown(c, start)),
            },
        }
        Ok(true)
    }

    fn operator(&mut self, c: char) -> Option<TokenKind> {
        let mut followed_by = |next: char| {
            let found = self.source.get(self.at..).is_some_and(|rest| rest.starts_with(next));
            self.at += if found { next.len_utf8() } else { 0 };
            found
        };
        Some(match c {
            '+' => TokenKind::Plus,
            '-' | '−' => TokenKind::Minus,
            '*' if followed_by('*') => TokenKind::Power,
            '*' | '·' | '⋅' | '×' | '∗' => TokenKind::Times,
            '/' | '⁄' | '∕' => TokenKind::Over,
            '^' => TokenKind::Power,
            '√' => TokenKind::Root,
            '(' => TokenKind::Open(Bracket::Round),
            ')' => TokenKind::Close(Bracket::Round),
            '[' => TokenKind::Open(Bracket::Square),
            ']' => TokenKind::Close(Bracket::Square),
            '{' => TokenKind::Open(Bracket::Curly),
            '}' => TokenKind::Close(Bracket::Curly),
            ',' => TokenKind::Comma,
            ';' => TokenKind::Semicolon,
            ':' => TokenKind::Colon,
            '=' if followed_by('=') => TokenKind::Comparison(Comparison::Equal),
            '=' => TokenKind::Equals,
            '!' if followed_by('=') => TokenKind::Comparison(Comparison::NotEqual),
            '≠' => TokenKind::Comparison(Comparison::NotEqual),
            '<' if followed_by('=') => TokenKind::Comparison(Comparison::LessOrEqual),
            '≤' => TokenKind::Comparison(Comparison::LessOrEqual),
            '<' => TokenKind::Comparison(Comparison::Less),
            '>' if followed_by('=') => TokenKind::Comparison(Comparison::GreaterOrEqual),
            '≥' => TokenKind::Comparison(Comparison::GreaterOrEqual),
            '>' => TokenKind::Comparison(Comparison::Greater),
            _ => return None,
        })
    }

    /// A number that begins at `start`, with a digit or with a dot before one.
    fn number(&mut self, start: usize) -> Result<(), SyntaxError> {
        let begins_with_dot = self.source.as_bytes().get(start) == Some(&b'.');
        if begins_with_dot
            && !self.blank
            && self.tokens.last().is_some_and(|last| matches!(last.kind, TokenKind::Number | TokenKind::Symbol(_)))
        {
            let text: &str = self.skip(|c| c.is_ascii_digit());
            let message = format!("found `.{text}` right behind `{}`, expected an operator or a blank", self.last_text());
            return Err(SyntaxError::new(Span::new(start, self.at), message));
        }
        self.skip(|c| c.is_ascii_digit());
        let mut ahead = self.rest().chars();
        if !begins_with_dot && ahead.next() == Some('.') && ahead.next().is_some_and(|c| c.is_ascii_digit()) {
            self.at += 1;
            self.skip(|c| c.is_ascii_digit());
        }
        if let Some(exponent) = self.rest().strip_prefix('e') {
            let sign = usize::from(exponent.starts_with(['+', '-']));
            if exponent[sign..].starts_with(|c: char| c.is_ascii_digit()) {
                self.at += 1 + sign;
                self.skip(|c| c.is_ascii_digit());
            }
        }
        self.push(TokenKind::Number, start);
        Ok(())
    }

    fn last_text(&self) -> &'a str {
        self.tokens.last().map_or("", |token| token.span.text(self.source))
    }

    fn vulgar_fraction(&mut self, start: usize) -> Result<(), SyntaxError> {
        if !self.blank && self.tokens.last().is_some_and(|last| last.kind == TokenKind::Number) {
            let fraction = Span::new(start, self.at).text(self.source);
            let whole = self.last_text();
            let span = self.tokens.last().map_or(Span::new(start, self.at), |last| last.span.to(Span::new(start, self.at)));
            let message = format!("found `{whole}{fraction}`, which could mean {whole} + {fraction} or {whole} times {fraction}");
            return Err(SyntaxError::new(span, message).with_help(format!("write `({whole} + {fraction})` or `{whole} * {fraction}`")));
        }
        self.push(TokenKind::Number, start);
        Ok(())
    }

    /// A dot that no digit follows.
    fn dot(&mut self, start: usize) -> Result<(), SyntaxError> {
        if self.latex {
            self.push(TokenKind::Dot, start);
            return Ok(());
        }
        let glued = !self.blank && self.tokens.last().is_some_and(|last| last.kind == TokenKind::Number);
        Err(if glued {
            let number = self.last_text();
            SyntaxError::new(Span::new(start, self.at), format!("found `{number}.`, expected a digit after the dot"))
                .with_help(format!("write `{number}` or `{number}.0`"))
        } else {
            SyntaxError::new(Span::new(start, self.at), "found `.`, expected a digit after the dot")
        })
    }

    /// Whether `sqrt(` stands at `start` and is not the end of a longer run of letters.
    fn is_root(&self, start: usize) -> bool {
        let before = self.source.get(..start).and_then(|text| text.chars().next_back());
        self.source.get(start..).is_some_and(|text| text.starts_with("sqrt(")) && !before.is_some_and(Symbol::is_letter)
    }

    /// The word that begins at `start`, and how long it is, if the letters there make one.
    fn word_at(&self, start: usize) -> Option<(&'static str, usize)> {
        let before = self.source.get(..start).and_then(|text| text.chars().next_back());
        if before.is_some_and(|c| Symbol::is_letter(c) || c == '_') {
            return None;
        }
        let rest = self.source.get(start..)?;
        let length = rest.find(|c: char| !(c.is_ascii_alphanumeric() || c == '_')).unwrap_or(rest.len());
        (self.word)(&rest[..length]).map(|word| (word, length))
    }

    /// A word in braces, as in `\operatorname{class}`.
    fn braced_word(&mut self, start: usize) -> Result<(), SyntaxError> {
        let braced = self.rest().strip_prefix('{').and_then(|rest| rest.split_once('}')).map(|(text, _)| text);
        if let Some(text) = braced {
            self.at += text.len() + "{}".len();
            if let Some(word) = (self.word)(&text.trim().replace("\\_", "_")) {
                self.push(TokenKind::Word(word), start);
                return Ok(());
            }
        }
        let shown = shorten(braced.unwrap_or(""));
        Err(SyntaxError::new(Span::new(start, self.at), format!("found the words `{shown}`, expected mathematics")))
    }

    /// A LaTeX command; the backslash has been read.
    fn command(&mut self, start: usize) -> Result<(), SyntaxError> {
        let mut name = self.skip(|c| c.is_ascii_alphabetic());
        if name.is_empty() {
            let length = self.peek().map_or(0, char::len_utf8);
            name = self.rest().get(..length).unwrap_or("");
            self.at += length;
        }
        match latex::command(name) {
            Some(Command::Greek(letter)) => return self.symbol(letter, start),
            Some(Command::Fraction) => self.push(TokenKind::Fraction, start),
            Some(Command::Root) => self.push(TokenKind::Root, start),
            Some(Command::Times) => self.push(TokenKind::Times, start),
            Some(Command::Comparison(comparison)) => self.push(TokenKind::Comparison(comparison), start),
            Some(Command::Word) => self.braced_word(start)?,
            Some(Command::Blank) => self.blank = true,
            Some(Command::Break) => {
                (self.blank, self.line_break) = (true, true);
                if name == "\\" {
                    self.skip_row_distance();
                }
            }
            Some(Command::Delimiter) => {
                // `\right.` closes without a bracket.
                if self.rest().starts_with('.') {
                    self.at += 1;
                }
            }
            Some(Command::Environment) => {
                let rest = self.rest();
                let environment = rest.strip_prefix('{').and_then(|rest| rest.split_once('}')).map(|(name, _)| name);
                match environment {
                    Some(environment) if latex::is_layout(environment) => self.at += environment.len() + "{}".len(),
                    _ => {
                        let shown = shorten(environment.unwrap_or(""));
                        let message =
                            format!("found the environment `{shown}`, expected `split`, `aligned` or another that only lays out formulas");
                        return Err(SyntaxError::new(Span::new(start, self.at), message));
                    }
                }
                (self.blank, self.line_break) = (true, true);
            }
            None => {
                let message = format!(
                    "found `\\{}`, expected a LaTeX command for fractions, roots, products, brackets, spaces or Greek letters",
                    shorten(name)
                );
                return Err(SyntaxError::new(Span::new(start, self.at), message));
            }
        }
        Ok(())
    }

    /// The distance in `\\[2pt]`, which would otherwise begin a list.
    fn skip_row_distance(&mut self) {
        let distance = self.rest().strip_prefix('[').and_then(|rest| rest.split_once(']')).map(|(distance, _)| distance);
        if let Some(distance) =
            distance.filter(|text| text.len() < 12 && ["pt", "ex", "em", "mm", "cm"].iter().any(|unit| text.ends_with(unit)))
        {
            self.at += distance.len() + "[]".len();
        }
    }

    fn unknown(&self, c: char, start: usize) -> SyntaxError {
        let span = Span::new(start, self.at);
        let shown = if c.is_control() || !c.is_ascii() { format!("`{}` (U+{:04X})", c.escape_debug(), c as u32) } else { format!("`{c}`") };
        let error = SyntaxError::new(span, format!("found {shown}, expected a number, a letter, an operator or a bracket"));
        match c {
            '_' => error.with_help("an index stands right behind its letter, as in `t_1`"),
            '–' | '—' | '‐' | '‑' => error.with_help("write `-`"),
            '÷' => error.with_help("write `/`"),
            '“' | '”' | '"' | '\'' | '’' => error.with_help("quotes belong around the whole input, not inside it"),
            '⁻' => error.with_help("exponents are non-negative whole numbers"),
            _ => error,
        }
    }

    /// Ends the tokens, without the full stop or comma that LaTeX puts behind a formula.
    fn finish(&mut self) {
        self.push(TokenKind::End, self.at);
        if self.latex {
            let mut kept: Vec<Token> = Vec::with_capacity(self.tokens.len());
            let mut tokens = std::mem::take(&mut self.tokens).into_iter().peekable();
            while let Some(token) = tokens.next() {
                let next = tokens.peek();
                let skipped = match token.kind {
                    TokenKind::Dot => next.is_some_and(|next| next.break_before || next.kind == TokenKind::End),
                    TokenKind::Comma => next.is_some_and(|next| next.kind == TokenKind::End),
                    _ => false,
                };
                if !skipped {
                    kept.push(token);
                }
            }
            self.tokens = kept;
        }
    }
}

/// The beginning of a text, short enough for a message.
pub(crate) fn shorten(text: &str) -> String {
    const LONGEST: usize = 24;
    match text.char_indices().nth(LONGEST) {
        Some((end, _)) => format!("{}…", &text[..end]),
        None => text.to_owned(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn texts(source: &str) -> Vec<String> {
        match tokens(source, Spelling::of(source)) {
            Ok(tokens) => tokens.iter().map(|token| token.span.text(source).to_owned()).collect(),
            Err(error) => vec![error.to_string()],
        }
    }

    #[test]
    fn pieces() {
        for (source, expected) in [
            ("0..1", vec!["0", "..", "1", ""]),
            ("-1.5e-3x", vec!["-", "1.5e-3", "x", ""]),
            ("2e x", vec!["2", "e", "x", ""]),
            ("2e-x", vec!["2", "e", "-", "x", ""]),
            ("t_{12}t₁t_1t12", vec!["t_{12}", "t₁", "t_1", "t12", ""]),
            ("a**b<=c", vec!["a", "**", "b", "<=", "c", ""]),
            ("sqrt(2)", vec!["sqrt", "(", "2", ")", ""]),
            ("asqrt(2)", vec!["a", "s", "q", "r", "t", "(", "2", ")", ""]),
            (r"\lambda_1\,t\\[2pt] u.", vec![r"\lambda_1", "t", "u", ""]),
            ("\u{feff}½t²", vec!["½", "t", "²", ""]),
        ] {
            assert_eq!(texts(source), expected, "{source}");
        }
    }

    #[test]
    fn digits_above() {
        assert_eq!(superscript_digits("¹⁰"), "10");
    }
}
