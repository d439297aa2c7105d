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
        [first, second] if first == second => {
            Err(SyntaxError::new(span, format!("found the variable `{first}` twice, expected two different variables")))
        }
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

#[cfg(test)]
mod tests {
    use super::*;

    fn value(source: &str) -> String {
        match parse_scalar(source) {
            Ok(value) => value.to_string(),
            Err(error) => format!("{}:{}: {error}", error.position(source).0, error.position(source).1),
        }
    }

    /// The sentences of the grammar on numbers, letters, products and brackets, one by one.
    #[test]
    fn grammar() {
        for (source, expected) in [
            // Numbers.
            ("3", "3"),
            ("-7/3", "-7/3"),
            ("0.25", "1/4"),
            ("1e-3", "1/1000"),
            ("2.5e2", "250"),
            (".5", "1/2"),
            ("2e t", "2 e t"),
            ("2e-t", "2 e - t"),
            ("2e3t", "2000 t"),
            ("2E3", "2 E3"),
            // Letters and indices.
            ("t1 - t_1", "0"),
            ("t1 - t_{1}", "0"),
            ("t1 - t₁", "0"),
            ("t12 - t_12", "0"),
            ("t₁₂ - t_{12}", "0"),
            ("t0", "t0"),
            (r"\lambda - λ", "0"),
            (r"\lambda_1 - λ_{1}", "0"),
            ("µ - μ", "0"),
            // Roots of squares.
            ("√4 t", "2 t"),
            ("sqrt(1/4)", "1/2"),
            ("2sqrt(9)", "6"),
            (r"\sqrt{\frac{9}{16}}", "3/4"),
            (r"\sqrt4t", "2 t"),
            ("√√16", "2"),
            ("a sqrt", "a q r s t"),
            // Products, leftmost first.
            ("1/2 t", "1/2 t"),
            ("1/2t", "1/2 t"),
            ("1/2/2", "1/4"),
            ("6/2*3", "9"),
            ("2UV + 3UV^2", "3 U V^2 + 2 U V"),
            ("t1 t2", "t1 t2"),
            (r"2 \cdot t · u * v × w", "2 t u v w"),
            ("2 3", "6"),
            ("t 2", "2 t"),
            ("-t^2", "-t^2"),
            ("2 * -3", "-6"),
            ("2 / -4", "-1/2"),
            ("1 - -1", "2"),
            ("--1", "1"),
            ("+t", "t"),
            ("t − 1", "t - 1"),
            // Powers.
            ("t**2", "t^2"),
            ("t²", "t^2"),
            ("t¹⁰", "t^10"),
            ("t^{2}", "t^2"),
            ("t^{12}", "t^12"),
            ("t^10", "t^10"),
            ("t^(1 + 1)", "t^2"),
            ("(t^2)^3", "t^6"),
            ("2^(3^2)", "512"),
            ("t^0", "1"),
            ("t^1/2", "1/2 t"),
            ("1^1000000000", "1"),
            ("(-1)^1000000001", "-1"),
            ("2 3^2", "18"),
            (r"t^2u", "t^2 u"),
            // Division by what has a constant value.
            ("t/(1 + 1)", "1/2 t"),
            ("t/(a - a + 2)", "1/2 t"),
            // Brackets group.
            ("2 (t + 1)", "2 t + 2"),
            ("(t + 1)(t - 1)", "t^2 - 1"),
            ("t(t + 1)", "t^2 + t"),
            // LaTeX.
            (r"\frac{3}{4}t^2 - \frac32 t", "3/4 t^2 - 3/2 t"),
            (r"\frac t2", "1/2 t"),
            (r"\frac{1}2t", "1/2 t"),
            (r"\frac12t", "1/2 t"),
            (r"\frac1{2}", "1/2"),
            (r"1/\frac12", "2"),
            (r"\left( t + 1 \right)\,\cdot\quad 2", "2 t + 2"),
            (r"\left[", "1:6: found `[` without a closing `]`"),
            (r"t_1t_2 \,", "t1 t2"),
            ("$t_1 + t_2.$", "t1 + t2"),
            ("$$4.$$", "4"),
            (r"\[ t + 1, \]", "t + 1"),
            (r"\begin{split} t & + 1 \\ & + 2 \end{split}", "t + 3"),
            (r"{t + 1}^{2} \;", "t^2 + 2 t + 1"),
            // Unicode.
            ("½ t + ¾", "1/2 t + 3/4"),
            ("1⁄2", "1/2"),
            ("\u{a0}t\u{2009}u", "t u"),
        ] {
            assert_eq!(value(source), expected, "{source}");
        }
    }

    /// Place, message and suggestion of every kind of error.
    #[test]
    fn errors() {
        const FACTOR: &str = "a number, a letter or `(`";
        for (source, column, message) in [
            ("", 1, "found nothing, expected a polynomial such as `t^2 + 1`".to_owned()),
            ("  ", 1, "found nothing, expected a polynomial such as `t^2 + 1`".to_owned()),
            ("1.", 2, "found `1.`, expected a digit after the dot".to_owned()),
            ("t.", 2, "found `.`, expected a digit after the dot".to_owned()),
            ("1.2.3", 4, "found `.3` right behind `1.2`, expected an operator or a blank".to_owned()),
            ("t1.5", 3, "found `.5` right behind `t1`, expected an operator or a blank".to_owned()),
            ("0..1", 2, "found `..`, expected an operator or the end of the input".to_owned()),
            ("2^^3", 3, "found `^`, expected a non-negative whole number as exponent".to_owned()),
            ("t^", 3, "found the end of the input, expected a non-negative whole number as exponent".to_owned()),
            ("t^n", 3, "found `n`, expected a non-negative whole number as exponent".to_owned()),
            ("t^1.5", 3, "found `1.5`, expected a non-negative whole number as exponent".to_owned()),
            ("t^-1", 3, "found the exponent `-1`, expected a non-negative whole number as exponent".to_owned()),
            ("t^(-1)", 3, "found the exponent `-1`, expected a non-negative whole number".to_owned()),
            ("t^(1/2)", 3, "found the exponent `1/2`, expected a non-negative whole number".to_owned()),
            ("t^(n)", 3, "found the exponent `n`, expected a non-negative whole number".to_owned()),
            ("t^2^3", 4, "found a second exponent, expected brackets around a tower of powers".to_owned()),
            ("t²³^2", 4, "found a second exponent, expected brackets around a tower of powers".to_owned()),
            ("t/0", 3, "found a division by zero, expected a non-zero number as divisor".to_owned()),
            ("1/(t + 1)", 3, "found a division by `t + 1`, expected a non-zero number as divisor".to_owned()),
            ("1/(1, 2)", 3, "found a point as divisor, expected a non-zero number".to_owned()),
            ("√2", 1, "found √(2), which is not rational, expected rational numbers here".to_owned()),
            ("√(-4)", 2, "found the root of a negative number, expected one that is not negative".to_owned()),
            ("√t", 2, "found the root of `t`, expected the root of a number".to_owned()),
            (r"\sqrt[3]{8}", 6, "found `[`, expected a square root, such as `\\sqrt{2}`".to_owned()),
            ("(t", 1, "found `(` without a closing `)`".to_owned()),
            ("((t)", 1, "found `(` without a closing `)`".to_owned()),
            ("t)", 2, "found `)` without an opening bracket".to_owned()),
            ("(t]", 3, "found `]`, expected `)`".to_owned()),
            ("()", 2, format!("found `)`, expected {FACTOR}")),
            ("(t,)", 4, format!("found `)`, expected {FACTOR}")),
            ("(1, 2)", 1, "found a point with 2 coordinates, expected a single value".to_owned()),
            ("[1]", 1, format!("found `[`, expected {FACTOR}")),
            ("{t}", 1, format!("found `{{`, expected {FACTOR}")),
            ("t +", 4, format!("found the end of the input, expected {FACTOR}")),
            ("t * / 2", 5, format!("found `/`, expected {FACTOR}")),
            ("t = 2", 3, "found `=`, expected an operator or the end of the input".to_owned()),
            ("t == 2", 3, "found `==`, expected an operator or the end of the input".to_owned()),
            ("t, 2", 2, "found `,`, expected an operator or the end of the input".to_owned()),
            ("ñ", 1, "found `ñ` (U+00F1), expected a number, a letter, an operator or a bracket".to_owned()),
            ("λ + \u{7}", 5, "found `\\u{7}` (U+0007), expected a number, a letter, an operator or a bracket".to_owned()),
            ("t # 2", 3, "found `#`, expected a number, a letter, an operator or a bracket".to_owned()),
            ("t_n", 2, "found the index `n` of `t`, expected a whole number below 2^32".to_owned()),
            ("t_", 2, "found no index behind `t_`, expected a whole number".to_owned()),
            ("t99999999999", 2, "found the index `99999999999` of `t`, expected a whole number below 2^32".to_owned()),
            ("t01", 2, "found the index `01` of `t`, expected one without leading zeros".to_owned()),
            ("2½", 1, "found `2½`, which could mean 2 + ½ or 2 times ½".to_owned()),
            (r"t_12\,", 1, "found `t_12`, which LaTeX reads as `t_1` times 2, expected an index in braces".to_owned()),
            (r"t^10\,", 2, "found `^10`, which LaTeX reads as `^1` followed by 0, expected an exponent in braces".to_owned()),
            (
                r"\sin t",
                1,
                "found `\\sin`, expected a LaTeX command for fractions, roots, products, brackets, spaces or Greek letters".to_owned(),
            ),
            (
                r"\begin{pmatrix}",
                1,
                "found the environment `pmatrix`, expected `split`, `aligned` or another that only lays out formulas".to_owned(),
            ),
            ("(1, 2) (3, 4)", 8, "found a product of two points, expected at most one point in a product".to_owned()),
            ("(1, 2) + 1", 10, "found a single value in a sum, expected a point with 2 coordinates".to_owned()),
            ("(1, 2)^2", 1, "found a power of a point, expected a power of a single value".to_owned()),
        ] {
            assert_eq!(value(source), format!("1:{column}: {message}"), "{source}");
        }
        assert_eq!(value("t +\n  $"), "2:4: found the end of the input, expected a number, a letter or `(`");
    }

    #[test]
    fn suggestions() {
        for (source, help) in [
            ("1.", "write `1` or `1.0`"),
            ("9^9^9", "write `(9^9)^…` or `9^(9^…)`"),
            (r"t_12\,", "write `t_{12}` or `t_1 2`"),
            (r"t^10\,", "write `^{10}` or `^1 0`"),
            ("2½", "write `(2 + ½)` or `2 * ½`"),
            ("t – 1", "write `-`"),
            ("t _1", "an index stands right behind its letter, as in `t_1`"),
        ] {
            assert_eq!(parse_scalar(source).err().and_then(|error| error.help).as_deref(), Some(help), "{source}");
        }
    }

    #[test]
    fn numbers() {
        assert_eq!(parse_number("2 (1 + 1/3)"), Ok(Rational::new(8, 3)));
        assert_eq!(parse_number("-1/2"), Ok(Rational::new(-1, 2)));
        let error = |source: &str| parse_number(source).err().map(|error| (error.position(source).1, error.message));
        assert_eq!(error("1 + r t"), Some((5, "found the letter `r`, expected a number".to_owned())));
        assert_eq!(error("1..2"), Some((2, "found `..`, expected an operator or the end of the input".to_owned())));
    }

    #[test]
    fn lists() {
        for (source, expected) in [
            ("", vec![]),
            ("1 2 3", vec!["1", "2", "3"]),
            ("1, 2,3", vec!["1", "2", "3"]),
            ("[0, 0, 1/3, 1]", vec!["0", "0", "1/3", "1"]),
            ("1 -2", vec!["1", "-2"]),
            ("1 - 2", vec!["-1"]),
            ("1-2", vec!["-1"]),
            ("2t (a + b) 3 * 4", vec!["2 t", "a + b", "12"]),
        ] {
            let values = parse_scalars(source).map(|values| values.iter().map(ToString::to_string).collect::<Vec<_>>());
            assert_eq!(values, Ok(expected.into_iter().map(str::to_owned).collect()), "{source}");
        }
        for (source, column) in [("1,", 3), (",1", 1), ("1,,2", 3), ("[1", 1), ("1]", 2), ("(1,2)", 1), ("[1] 2", 5)] {
            assert_eq!(parse_scalars(source).err().map(|error| error.position(source)), Some((1, column)), "{source}");
        }
    }

    #[test]
    fn claimed_polar_forms_of_the_textbook() {
        let source = "$$f_1(t_1, t_2, t_3) = \\frac{1}{4}(t_1t_2 + t_1t_3 + t_2t_3) - \\frac{1}{2}(t_1 + t_2 + t_3) - \\frac{9}{4}$$\n\n\
            $$f_2(t_1, t_2, t_3) = \\frac{3}{4}t_1t_2t_3 - \\frac{1}{2}(t_1t_2 + t_1t_3 + t_2t_3) - \\frac{3}{4}(t_1 + t_2 + t_3).$$";
        let tuple =
            "(1/4 (t1 t2 + t1 t3 + t2 t3) - 1/2 (t1 + t2 + t3) - 9/4, 3/4 t1 t2 t3 - 1/2 (t1 t2 + t1 t3 + t2 t3) - 3/4 (t1 + t2 + t3))";
        assert!(parse_components(source).is_ok());
        assert_eq!(parse_components(source), parse_components(tuple));
        let enneper = r"$$\begin{split} f_1((U_1,V_1),(U_2,V_2),(U_3,V_3)) &= \frac{U_1+U_2+U_3}{3} - \frac{U_1U_2U_3}{3} \\ &\quad + \frac{U_1V_2V_3+U_2V_1V_3+U_3V_1V_2}{3} \\ f_2((U_1,V_1),(U_2,V_2),(U_3,V_3)) &= \frac{V_1+V_2+V_3}{3} - \frac{V_1V_2V_3}{3} \\ &\quad + \frac{U_1U_2V_3+U_1U_3V_2+U_2U_3V_1}{3} \\ f_3((U_1,V_1),(U_2,V_2),(U_3,V_3)) &= \frac{U_1U_2+U_1U_3+U_2U_3}{3} - \frac{V_1V_2+V_1V_3+V_2V_3}{3}. \end{split}$$";
        let components = parse_components(enneper).unwrap_or_default();
        let lengths: Vec<usize> = components.iter().map(Polynomial::len).collect();
        assert_eq!(lengths, [7, 7, 6]);
        assert_eq!(parse_components(r"$$f(t_1, t_2) = at_1t_2 + b(t_1 + t_2)/2 + c.$$"), parse_components("a t1 t2 + b/2 (t1 + t2) + c"));
    }

    #[test]
    fn names_of_variables() {
        assert_eq!(parse_variables("u,v").map(|symbols| format!("{symbols:?}")), Ok("[u, v]".to_owned()));
        assert_eq!(parse_variables("p q").map(|symbols| format!("{symbols:?}")), Ok("[p, q]".to_owned()));
        assert_eq!(parse_symbol(r"\lambda"), Ok(Symbol::new('λ', None)));
        for source in ["", "u,u", "a,b,c", "2", "u,", "t^2"] {
            assert!(parse_variables(source).is_err(), "{source}");
        }
        assert!(parse_symbol("u v").is_err());
    }
}
