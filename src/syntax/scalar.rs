//! Single values: numbers, polynomials, lists of them, and the names of variables.

use super::parser::Parser;
use super::token::{Bracket, TokenKind};
use super::{Span, SyntaxError};
use crate::exact::Rational;
use crate::symbolic::{Polynomial, Symbol};

const OPERATOR: &str = "an operator or the end of the input";

/// Reads one polynomial in any symbols.
///
/// # Errors
/// If the text is not one, or exceeds a limit.
///
/// ```
/// use casteljau::syntax;
/// assert_eq!(syntax::parse_scalar("(t + 1)^2 / 2")?.to_string(), "1/2 t^2 + t + 1/2");
/// # Ok::<(), syntax::SyntaxError>(())
/// ```
pub fn parse_scalar(text: &str) -> Result<Polynomial, SyntaxError> {
    let mut parser = Parser::new(text)?;
    parser.not_empty("a polynomial such as `t^2 + 1`")?;
    let expression = parser.expression()?;
    parser.finish(OPERATOR)?;
    parser.evaluate_scalar(&expression)
}

/// Reads one number, computing what is written: `3/4`, `2 (1 + 1/3)`, `√4`.
///
/// # Errors
/// If the text is not an expression, or contains a letter, which is named.
pub fn parse_number(text: &str) -> Result<Rational, SyntaxError> {
    let mut parser = Parser::new(text)?;
    parser.not_empty("a number such as `3/4`")?;
    let expression = parser.expression()?;
    parser.finish(OPERATOR)?;
    let mut symbols = std::collections::BTreeMap::new();
    expression.collect_symbols(&mut symbols);
    let value = parser.evaluate_scalar(&expression)?;
    value.as_rational().ok_or_else(|| {
        let (symbol, span) = symbols.into_iter().min_by_key(|entry| entry.1).unwrap_or((Symbol::new('?', None), expression.span));
        SyntaxError::new(span, format!("found the letter `{symbol}`, expected a number"))
    })
}

/// Reads polynomials separated by commas or blanks, with or without `[ ]`
/// around them; empty text is the empty list.
///
/// A blank always separates: `2 t` are two, `2t` is one. A sign after a blank
/// and glued to what follows begins the next: `1 -2` are two, `1 - 2` is one.
///
/// # Errors
/// If the text is no such list, or exceeds a limit.
pub fn parse_scalars(text: &str) -> Result<Vec<Polynomial>, SyntaxError> {
    const VALUE: &str = "a number or a polynomial";
    let mut parser = Parser::spaced(text)?;
    let bracketed = parser.take(TokenKind::Open(Bracket::Square));
    let mut values = Vec::new();
    let mut after_comma = false;
    loop {
        match parser.peek() {
            TokenKind::End if !after_comma => return Ok(values),
            TokenKind::Close(Bracket::Square) if bracketed && !after_comma => {
                parser.advance();
                parser.finish("the end of the list")?;
                return Ok(values);
            }
            TokenKind::End | TokenKind::Comma | TokenKind::Close(_) => return Err(parser.expected(VALUE)),
            _ => {}
        }
        values.push(parser.scalar()?);
        after_comma = parser.take(TokenKind::Comma);
    }
}

/// Reads a tuple, a bare polynomial, or definitions `f_1(t_1,t_2) = …,
/// f_2(t_1,t_2) = …`, in any symbols: claimed polar forms and affine maps.
///
/// # Errors
/// If the text is none of these, or exceeds a limit.
///
/// ```
/// use casteljau::syntax;
/// let claim = syntax::parse_components(r"f_1(t_1, t_2) = t_1t_2, \qquad f_2(t_1, t_2) = \frac{t_1 + t_2}{2}.")?;
/// assert_eq!(claim[1].to_string(), "1/2 t1 + 1/2 t2");
/// # Ok::<(), syntax::SyntaxError>(())
/// ```
pub fn parse_components(text: &str) -> Result<Vec<Polynomial>, SyntaxError> {
    let mut parser = Parser::new(text)?;
    parser.not_empty("components such as `(x + 1, 2 y)`")?;
    if !parser.at_definition() {
        let body = parser.expression()?;
        if !parser.at_end() {
            return Err(parser.unexpected_behind_map());
        }
        return parser.components_of(&body).map(|components| components.0);
    }
    let definitions = parser.definitions()?;
    let sorted = parser.sort_components(&definitions)?;
    match sorted.as_slice() {
        [single] if single.name.index().is_none() => parser.components_of(&single.body).map(|components| components.0),
        _ => sorted.into_iter().map(|definition| parser.evaluate_scalar(&definition.body)).collect(),
    }
}

/// Reads one symbol, such as `t`, `t1` or `λ`.
///
/// # Errors
/// If the text is anything else.
pub fn parse_symbol(text: &str) -> Result<Symbol, SyntaxError> {
    match parse_symbols(text)?.as_slice() {
        [symbol] => Ok(*symbol),
        more => Err(SyntaxError::new(Span::new(0, text.len()), format!("found {} letters, expected one", more.len()))),
    }
}

/// Reads the variables of a map: one symbol, or two different ones separated by
/// a comma or a blank.
///
/// # Errors
/// If the text is anything else.
///
/// ```
/// use casteljau::{Symbol, syntax};
/// assert_eq!(syntax::parse_variables("r")?, [Symbol::new('r', None)]);
/// assert_eq!(syntax::parse_variables("p,q")?.len(), 2);
/// # Ok::<(), syntax::SyntaxError>(())
/// ```
pub fn parse_variables(text: &str) -> Result<Vec<Symbol>, SyntaxError> {
    let symbols = parse_symbols(text)?;
    let span = Span::new(0, text.len());
    match symbols.as_slice() {
        [first, second] if first == second => Err(SyntaxError::new(span, format!("found the variable `{first}` twice, expected two different variables"))),
        [_] | [_, _] => Ok(symbols),
        more => Err(SyntaxError::new(span, format!("found {} variables, expected one or two", more.len()))),
    }
}

fn parse_symbols(text: &str) -> Result<Vec<Symbol>, SyntaxError> {
    let mut parser = Parser::new(text)?;
    parser.not_empty("a letter such as `t`")?;
    let mut symbols = Vec::new();
    loop {
        let TokenKind::Symbol(symbol) = parser.peek() else { return Err(parser.expected("a letter such as `t`")) };
        parser.advance();
        symbols.push(symbol);
        if !parser.take(TokenKind::Comma) && parser.at_end() {
            return Ok(symbols);
        }
    }
}
