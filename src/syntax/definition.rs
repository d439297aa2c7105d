//! Definitions such as `F_1(t) = …, F_2(t) = …`.

use super::expression::Expression;
use super::parser::Parser;
use super::token::{Bracket, TokenKind};
use super::{Span, SyntaxError};
use crate::symbolic::Symbol;

pub(crate) struct Definition {
    pub(crate) name: Symbol,
    pub(crate) name_span: Span,
    /// The letters in the brackets behind the name, nested brackets flattened.
    pub(crate) arguments: Option<Vec<(Symbol, Span)>>,
    pub(crate) body: Expression,
}

impl Parser<'_> {
    /// Reads definitions up to the end of the input.
    pub(crate) fn definitions(&mut self) -> Result<Vec<Definition>, SyntaxError> {
        self.set_definitions(true);
        let mut definitions = Vec::new();
        loop {
            definitions.push(self.definition()?);
            let mut separated = self.take(TokenKind::Comma);
            separated |= self.token(0).break_before;
            if self.at_end() && !self.ends_with_comma() {
                return Ok(definitions);
            }
            if !self.at_definition() {
                let help = "a map with several components is written `(…, …)`, or as definitions `F_1(t) = …, F_2(t) = …`";
                return Err(self.expected("an operator, the end of the input or another definition").with_help(help));
            }
            if !separated {
                return Err(self.expected("an operator, or a line end or `,` before the next definition"));
            }
        }
    }

    fn ends_with_comma(&self) -> bool {
        !self.is_latex() && self.source.trim_end().ends_with(',')
    }

    pub(crate) fn definition(&mut self) -> Result<Definition, SyntaxError> {
        let token = self.advance();
        let TokenKind::Symbol(name) = token.kind else {
            return Err(SyntaxError::new(token.span, format!("found {}, expected the name of a map", self.describe(token))));
        };
        let arguments = if self.peek() == TokenKind::Open(Bracket::Round) { Some(self.arguments_of_head()?) } else { None };
        if !self.take(TokenKind::Equals) {
            return Err(self.expected("`=`"));
        }
        let body = self.expression()?;
        Ok(Definition { name, name_span: token.span, arguments, body })
    }

    /// The bracket behind a name: letters and points of letters.
    fn arguments_of_head(&mut self) -> Result<Vec<(Symbol, Span)>, SyntaxError> {
        let mut left = self.bracket_length(0);
        let mut symbols: Vec<(Symbol, Span)> = Vec::new();
        let mut after_symbol = false;
        while left > 0 {
            left -= 1;
            let token = self.token(0);
            match token.kind {
                TokenKind::Symbol(symbol) if !after_symbol => {
                    if symbols.iter().any(|known| known.0 == symbol) {
                        return Err(SyntaxError::new(
                            token.span,
                            format!("found the variable `{symbol}` twice, expected different variables"),
                        ));
                    }
                    symbols.push((symbol, token.span));
                    after_symbol = true;
                }
                TokenKind::Open(Bracket::Round) if !after_symbol => {}
                TokenKind::Close(Bracket::Round) if after_symbol => {}
                TokenKind::Comma | TokenKind::Semicolon if after_symbol => after_symbol = false,
                _ => return Err(self.expected(if after_symbol { "`,` or `)` behind the variable" } else { "a variable" })),
            }
            self.advance();
        }
        Ok(symbols)
    }
}
