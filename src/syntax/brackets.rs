//! Which bracket closes which.

use super::limits::MAX_NESTING;
use super::token::{Bracket, Token, TokenKind};
use super::{Span, SyntaxError};

fn text(bracket: Bracket, closing: bool) -> &'static str {
    match (bracket, closing) {
        (Bracket::Round, false) => "(",
        (Bracket::Round, true) => ")",
        (Bracket::Square, false) => "[",
        (Bracket::Square, true) => "]",
        (Bracket::Curly, false) => "{",
        (Bracket::Curly, true) => "}",
    }
}

/// For every token the place of its partner, itself if it is no bracket.
///
/// Done before parsing, so that an opening bracket without a partner is
/// reported where it stands and not at the end of the input, and so that the
/// parser never goes deeper than [`MAX_NESTING`].
pub(crate) fn partners(tokens: &[Token]) -> Result<Vec<u32>, SyntaxError> {
    let mut partners: Vec<u32> = (0u32..).take(tokens.len()).collect();
    let mut open: Vec<(Bracket, Span, u32)> = Vec::new();
    for (place, token) in (0u32..).zip(tokens) {
        match token.kind {
            TokenKind::Open(bracket) => {
                if open.len() == MAX_NESTING {
                    return Err(too_deep(token.span));
                }
                open.push((bracket, token.span, place));
            }
            TokenKind::Close(bracket) => match open.pop() {
                Some((opening, _, partner)) if opening == bracket => {
                    partners[place as usize] = partner;
                    partners[partner as usize] = place;
                }
                Some((opening, ..)) => {
                    let message = format!("found `{}`, expected `{}`", text(bracket, true), text(opening, true));
                    let help = format!("the last bracket still open is `{}`", text(opening, false));
                    return Err(SyntaxError::new(token.span, message).with_help(help));
                }
                None => {
                    return Err(SyntaxError::new(token.span, format!("found `{}` without an opening bracket", text(bracket, true))));
                }
            },
            _ => {}
        }
    }
    match open.pop() {
        Some((bracket, span, _)) => {
            let message = format!("found `{}` without a closing `{}`", text(bracket, false), text(bracket, true));
            Err(SyntaxError::new(span, message))
        }
        None => Ok(partners),
    }
}

pub(crate) fn too_deep(span: Span) -> SyntaxError {
    SyntaxError::new(span, format!("found more than {MAX_NESTING} nested brackets, fractions or roots, expected at most {MAX_NESTING}"))
}
