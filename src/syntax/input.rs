//! The choice between an equation and a list of points.

use super::map::MapInput;
use super::parser::Parser;
use super::points::PointsInput;
use super::token::{Bracket, TokenKind};
use super::SyntaxError;
use crate::symbolic::Symbol;

/// What a command takes that accepts an equation as well as points.
#[derive(Clone, Debug, PartialEq)]
pub enum Input {
    /// A polynomial map.
    Map(MapInput),
    /// A control net.
    Points(PointsInput),
}

/// Reads an equation or a list of points.
///
/// A list is what has more than one bracket with a comma in it, a list `[…]` or
/// `{…}`, a weight behind a point, or rows, all outside other brackets; a
/// definition is never one. Anything else is an equation, see
/// [`parse_map`](super::parse_map), to which `vars` belongs.
///
/// # Errors
/// Those of [`parse_map`](super::parse_map) or
/// [`parse_points`](super::parse_points).
pub fn parse_input(text: &str, vars: Option<&[Symbol]>) -> Result<Input, SyntaxError> {
    let mut parser = Parser::new(text)?;
    parser.not_empty("an equation such as `(t, t^2)` or points such as `(0,0) (1,2)`")?;
    if !parser.is_list() {
        return parser.map(vars).map(Input::Map);
    }
    let combines = parser.top_level().any(|(_, token)| matches!(token.kind, TokenKind::Plus | TokenKind::Times | TokenKind::Symbol(_)));
    parser.points().map(Input::Points).map_err(|error| match error.help {
        None if combines => error.with_help("more than one point outside brackets makes a list; begin with `F(t) =` if this is an equation"),
        _ => error,
    })
}

impl Parser<'_> {
    /// Whether the text is a list of points.
    fn is_list(&self) -> bool {
        if self.top_level().any(|(_, token)| token.kind == TokenKind::Equals) {
            return false;
        }
        let mut brackets = 0;
        let mut exponent = false;
        for (ahead, token) in self.top_level() {
            match token.kind {
                TokenKind::Open(Bracket::Round) => brackets += usize::from(self.has_comma(ahead)),
                TokenKind::Open(Bracket::Square) | TokenKind::Semicolon | TokenKind::Colon => return true,
                // `t^{2}` is no list.
                TokenKind::Open(Bracket::Curly) if !self.is_latex() && !exponent => return true,
                _ => {}
            }
            exponent = token.kind == TokenKind::Power;
        }
        brackets > 1
    }
}
