//! Letters and their indices.

use super::lexer::{Lexer, shorten};
use super::token::TokenKind;
use super::{Span, SyntaxError};
use crate::symbolic::Symbol;

const SUBSCRIPTS: [char; 10] = ['₀', '₁', '₂', '₃', '₄', '₅', '₆', '₇', '₈', '₉'];

impl Lexer<'_> {
    /// A letter that has just been read, and its index.
    pub(crate) fn symbol(&mut self, letter: char, start: usize) -> Result<(), SyntaxError> {
        let rest = self.rest();
        let index_start = self.at;
        let digits = if let Some(braced) = rest.strip_prefix("_{") {
            let Some(length) = braced.find('}') else {
                return Err(SyntaxError::new(Span::new(self.at + 1, self.at + 2), "found `{` without a closing `}`"));
            };
            self.at += length + "_{}".len();
            braced[..length].trim().to_owned()
        } else if rest.starts_with('_') {
            self.at += 1;
            let digits = self.skip(|c| c.is_ascii_digit());
            if self.latex && digits.len() > 1 {
                let first = &digits[..1];
                let message = format!(
                    "found `{letter}_{digits}`, which LaTeX reads as `{letter}_{first}` times {}, expected an index in braces",
                    &digits[1..]
                );
                let help = format!("write `{letter}_{{{digits}}}` or `{letter}_{first} {}`", &digits[1..]);
                return Err(SyntaxError::new(Span::new(start, self.at), message).with_help(help));
            }
            if digits.is_empty() {
                // Takes the letter along, so that the message can quote it.
                self.at += self.peek().map_or(0, char::len_utf8);
            }
            Span::new(index_start + 1, self.at).text(self.source).to_owned()
        } else if rest.starts_with(SUBSCRIPTS) {
            let text = self.skip(|c| SUBSCRIPTS.contains(&c));
            text.chars()
                .filter_map(|c| SUBSCRIPTS.iter().position(|&digit| digit == c))
                .filter_map(|digit| char::from_digit(digit as u32, 10))
                .collect()
        } else {
            self.skip(|c| c.is_ascii_digit()).to_owned()
        };
        let index = if self.at == index_start { None } else { Some(self.index(letter, &digits, index_start)?) };
        self.push(TokenKind::Symbol(Symbol::new(letter, index)), start);
        Ok(())
    }

    fn index(&self, letter: char, digits: &str, start: usize) -> Result<u32, SyntaxError> {
        let span = Span::new(start, self.at);
        if digits.len() > 1 && digits.starts_with('0') && digits.bytes().all(|byte| byte.is_ascii_digit()) {
            let message = format!("found the index `{digits}` of `{letter}`, expected one without leading zeros");
            return Err(SyntaxError::new(span, message));
        }
        let plain = !digits.is_empty() && digits.bytes().all(|byte| byte.is_ascii_digit());
        if digits.is_empty() {
            return Err(SyntaxError::new(span, format!("found no index behind `{letter}_`, expected a whole number")));
        }
        match digits.parse() {
            Ok(index) if plain => Ok(index),
            _ => {
                let shown = shorten(digits);
                Err(SyntaxError::new(span, format!("found the index `{shown}` of `{letter}`, expected a whole number below 2^32")))
            }
        }
    }
}
