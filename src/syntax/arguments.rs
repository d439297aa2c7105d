//! The arguments of a polar form.

use num_traits::One;

use super::evaluate::Value;
use super::expression::{ExpressionKind, PolarArgument};
use super::lexer::shorten;
use super::limits::MAX_DEGREE;
use super::literal::exponent_value;
use super::parser::Parser;
use super::token::{Bracket, TokenKind};
use super::{Span, SyntaxError};
use crate::symbolic::Polynomial;

/// One argument of a polar form.
#[derive(Clone, Debug, PartialEq)]
pub struct ArgumentInput {
    /// The weight: 1 for a point, what was written for a homogeneous argument
    /// `[w; t]`. Weight 0 makes it a vector.
    pub weight: Polynomial,
    /// One coordinate for curves and for each group of a bidegree form, two for
    /// triangles. Of a homogeneous argument as written, not divided by the weight.
    pub coordinates: Vec<Polynomial>,
    /// Whether the argument was written as `[w; …]`.
    pub is_homogeneous: bool,
    /// Where the argument was written; repeated ones share their place.
    pub span: Span,
}

/// The arguments of a polar form; repetitions such as `r^2` are written out.
#[derive(Clone, Debug, PartialEq)]
pub struct PolarArguments {
    /// One group, or two where a semicolon separates those of a bidegree form.
    /// A group may be empty, for degree 0.
    pub groups: Vec<Vec<ArgumentInput>>,
}

/// Reads polar arguments: `-1, -1, 3`, `r^2 s`, `(1,0) (0,1)`, `[0; 1] 2`, or
/// two groups `1 0 0; 0 1 0`. Empty text is one empty group.
///
/// # Errors
/// If the text is no such list, if arguments have different numbers of
/// coordinates, or if there are more than [`MAX_DEGREE`].
///
/// ```
/// use casteljau::syntax;
/// let arguments = syntax::parse_polar_arguments("r^2 s")?;
/// assert_eq!(arguments.groups[0].len(), 3);
/// # Ok::<(), syntax::SyntaxError>(())
/// ```
pub fn parse_polar_arguments(text: &str) -> Result<PolarArguments, SyntaxError> {
    let mut parser = Parser::spaced(text)?;
    let mut groups = Vec::new();
    loop {
        let group = parser.polar_arguments()?;
        groups.push(parser.evaluate_arguments(&group)?);
        if parser.at_end() {
            break;
        }
        if groups.len() == 2 {
            return Err(parser.expected("at most two groups of arguments"));
        }
        parser.advance();
    }
    check_dimensions(&groups)?;
    Ok(PolarArguments { groups })
}

const ARGUMENT: &str = "an argument: a number, a point `(u,v)` or `[w; t]`";

impl Parser<'_> {
    /// The arguments up to a semicolon, the end, or the bracket that closes
    /// them. Without a comma among them they may be repeated; whether blanks
    /// separate them is a property of the parser.
    pub(crate) fn polar_arguments(&mut self) -> Result<Vec<PolarArgument>, SyntaxError> {
        let repeats = !self.group_has_comma();
        let mut arguments = Vec::new();
        let mut after_comma = false;
        loop {
            match self.peek() {
                TokenKind::End | TokenKind::Semicolon if !after_comma => return Ok(arguments),
                TokenKind::Close(_) if !after_comma && self.is_inside() => return Ok(arguments),
                TokenKind::End | TokenKind::Semicolon | TokenKind::Comma | TokenKind::Close(_) => return Err(self.expected(ARGUMENT)),
                _ => {}
            }
            arguments.push(if self.peek() == TokenKind::Open(Bracket::Square) {
                self.homogeneous(repeats)?
            } else {
                self.argument_of_polar_form(repeats)?
            });
            after_comma = self.take(TokenKind::Comma);
            if !after_comma && !repeats && self.is_inside() && !matches!(self.peek(), TokenKind::Close(_) | TokenKind::Semicolon) {
                return Err(self.expected("an operator, `,` or `)` behind an argument"));
            }
        }
    }

    /// Whether a comma separates the arguments of the group that begins here.
    pub(crate) fn group_has_comma(&self) -> bool {
        self.top_level()
            .take_while(|(_, token)| !matches!(token.kind, TokenKind::Semicolon | TokenKind::Close(_)))
            .any(|(_, token)| token.kind == TokenKind::Comma)
    }

    /// The values of arguments, repeated ones written out.
    pub(crate) fn evaluate_arguments(&mut self, group: &[PolarArgument]) -> Result<Vec<ArgumentInput>, SyntaxError> {
        let mut arguments = Vec::new();
        for PolarArgument { weight, coordinates: written, repeated, span } in group {
            let mut coordinates = Vec::with_capacity(written.len());
            for expression in written {
                match self.evaluate(expression)? {
                    Value::Scalar(value) => coordinates.push(value),
                    Value::Tuple(values) => coordinates.extend(values),
                }
            }
            check_coordinates(&coordinates, *span)?;
            let count = match repeated {
                None => 1,
                Some(exponent) => {
                    let value = self.evaluate_scalar(exponent)?.as_rational();
                    value.and_then(|value| exponent_value(&value)).ok_or_else(|| {
                        SyntaxError::new(exponent.span, "found a number of repetitions that is none, expected a small whole number")
                    })?
                }
            };
            if arguments.len() as u64 + u64::from(count) > u64::from(MAX_DEGREE) {
                let message = format!("found more than {MAX_DEGREE} arguments, expected at most {MAX_DEGREE}");
                return Err(SyntaxError::new(*span, message));
            }
            let is_homogeneous = weight.is_some();
            let weight = match weight {
                Some(weight) => self.evaluate_scalar(weight)?,
                None => Polynomial::one(),
            };
            let argument = ArgumentInput { weight, coordinates, is_homogeneous, span: *span };
            arguments.extend((0..count).map(|_| argument.clone()));
        }
        Ok(arguments)
    }

    /// A number or a point, and how often it is repeated.
    fn argument_of_polar_form(&mut self, repeats: bool) -> Result<PolarArgument, SyntaxError> {
        let expression = self.expression()?;
        let span = expression.span;
        let (base, repeated) = match expression.kind {
            ExpressionKind::Power(base, exponent) if repeats => (*base, Some(*exponent)),
            _ if repeats && expression.has_bare_power() => {
                let shown = shorten(span.text(self.source));
                let message = format!(
                    "found `{shown}` in a list without commas, where `x^k` repeats the argument x, expected a single letter, number or bracket before `^`"
                );
                let help = "put the repeated argument in brackets, as in `(-1)^2`, or separate the arguments by commas to compute powers";
                return Err(SyntaxError::new(span, message).with_help(help));
            }
            _ => (expression, None),
        };
        Ok(PolarArgument { weight: None, coordinates: vec![base], repeated, span })
    }

    /// `[w; t]` or `[w; u,v]`, and how often it is repeated.
    fn homogeneous(&mut self, repeats: bool) -> Result<PolarArgument, SyntaxError> {
        let open = self.advance().span;
        // In worksheets blanks multiply in brackets, on the command line they separate.
        let spaced = self.set_spaced(!self.is_inside());
        let weight = self.expression()?;
        if !self.take(TokenKind::Semicolon) {
            return Err(self.expected("`;` behind the weight of a homogeneous argument `[w; t]`"));
        }
        let mut coordinates = Vec::new();
        loop {
            coordinates.push(self.expression()?);
            let separated = self.take(TokenKind::Comma);
            if !separated && matches!(self.peek(), TokenKind::Close(_)) {
                break;
            }
        }
        self.set_spaced(spaced);
        let mut span = open.to(self.advance().span);
        let mut repeated = None;
        if matches!(self.peek(), TokenKind::Power | TokenKind::Superscript) {
            if !repeats {
                return Err(self.expected("`,`, since arguments repeat only in a list without commas"));
            }
            let exponent = self.exponent()?;
            span = span.to(exponent.span);
            repeated = Some(exponent);
        }
        Ok(PolarArgument { weight: Some(weight), coordinates, repeated, span })
    }
}

fn check_coordinates(coordinates: &[Polynomial], span: Span) -> Result<(), SyntaxError> {
    if coordinates.len() <= 2 {
        return Ok(());
    }
    let error = SyntaxError::new(span, format!("found an argument with {} coordinates, expected 1 or 2", coordinates.len()));
    Err(error.with_help("the arguments of a curve stand without brackets: `1, 2, 3`"))
}

fn check_dimensions(groups: &[Vec<ArgumentInput>]) -> Result<(), SyntaxError> {
    let mut all = groups.iter().flatten();
    let Some(first) = all.next() else { return Ok(()) };
    match all.find(|argument| argument.coordinates.len() != first.coordinates.len()) {
        None => Ok(()),
        Some(odd) => {
            let describe = |argument: &ArgumentInput| if argument.coordinates.len() == 1 { "a number" } else { "a point `(u,v)`" };
            Err(SyntaxError::new(odd.span, format!("found {}, expected {} like the first argument", describe(odd), describe(first))))
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn shown(source: &str) -> String {
        let argument = |argument: &ArgumentInput| {
            let coordinates: Vec<String> = argument.coordinates.iter().map(ToString::to_string).collect();
            let weight = if argument.is_homogeneous { format!("{};", argument.weight) } else { String::new() };
            format!("<{weight}{}>", coordinates.join(","))
        };
        match parse_polar_arguments(source) {
            Ok(arguments) => {
                arguments.groups.iter().map(|group| group.iter().map(argument).collect::<String>()).collect::<Vec<_>>().join("|")
            }
            Err(error) => format!("{}: {error}", error.position(source).1),
        }
    }

    #[test]
    fn grammar() {
        for (source, expected) in [
            ("", ""),
            ("-1,-1,3", "<-1><-1><3>"),
            ("-1 -1 3", "<-1><-1><3>"),
            ("1 - 2", "<-1>"),
            ("1 -2", "<1><-2>"),
            ("1 - 2, -3", "<-1><-3>"),
            ("t1, t2 t3", "<t1><t2><t3>"),
            ("r^2 s", "<r><r><s>"),
            ("r² s", "<r><r><s>"),
            ("2^2 1", "<2><2><1>"),
            ("r^0 s", "<s>"),
            ("(-1)^2 3", "<-1><-1><3>"),
            ("(r + 1)^2", "<r + 1><r + 1>"),
            ("(r^2) s", "<r^2><s>"),
            ("r^2, s", "<r^2><s>"),
            ("1/2 2/3", "<1/2><2/3>"),
            ("(1,0) (0,1)", "<1,0><0,1>"),
            ("(1,0),(0,1)", "<1,0><0,1>"),
            ("(1,0)^2 (0,1)", "<1,0><1,0><0,1>"),
            ("1,0,0; 0,1,0", "<1><0><0>|<0><1><0>"),
            ("u^2; v^1", "<u><u>|<v>"),
            ("r^2; u, v^2", "<r><r>|<u><v^2>"),
            ("; 1 2", "|<1><2>"),
            ("1;", "<1>|"),
            ("[0; 1]", "<0;1>"),
            ("[0; 1]^2 3", "<0;1><0;1><3>"),
            ("[w; t] 2", "<w;t><2>"),
            ("[w; u,v]", "<w;u,v>"),
            ("[0; 1 -1]", "<0;1,-1>"),
            ("[0; (1,-1)]", "<0;1,-1>"),
            ("[0; 1]; [0; 1]", "<0;1>|<0;1>"),
        ] {
            assert_eq!(shown(source), expected, "{source}");
        }
    }

    #[test]
    fn errors() {
        const BARE: &str =
            "in a list without commas, where `x^k` repeats the argument x, expected a single letter, number or bracket before `^`";
        for (source, expected) in [
            ("1,", format!("3: found the end of the input, expected {ARGUMENT}")),
            ("1,,2", format!("3: found `,`, expected {ARGUMENT}")),
            ("1;2;3", "4: found `;`, expected at most two groups of arguments".to_owned()),
            ("-1^2 3", format!("1: found `-1^2` {BARE}")),
            ("2r^2 s", format!("1: found `2r^2` {BARE}")),
            ("1/2^2", format!("1: found `1/2^2` {BARE}")),
            ("r^s", "3: found `s`, expected a non-negative whole number as exponent".to_owned()),
            ("r^(s) 1", "3: found a number of repetitions that is none, expected a small whole number".to_owned()),
            ("r^1000000000", "1: found more than 4096 arguments, expected at most 4096".to_owned()),
            ("1, (1,0)", "4: found a point `(u,v)`, expected a number like the first argument".to_owned()),
            ("(1,0) 1", "7: found a number, expected a point `(u,v)` like the first argument".to_owned()),
            ("(1,0,0)", "1: found an argument with 3 coordinates, expected 1 or 2".to_owned()),
            ("(1,0)^2, (0,1)", "1: found a power of a point, expected a power of a single value".to_owned()),
            ("[1, 2]", "3: found `,`, expected `;` behind the weight of a homogeneous argument `[w; t]`".to_owned()),
            ("[0; 1]^2, 3", "7: found `^`, expected `,`, since arguments repeat only in a list without commas".to_owned()),
            ("[0; ]", "5: found `]`, expected a number, a letter or `(`".to_owned()),
        ] {
            assert_eq!(shown(source), expected, "{source}");
        }
    }
}
