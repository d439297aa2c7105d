//! Frames: intervals, triangles and rectangles of parameters.

use super::evaluate::Value;
use super::parser::Parser;
use super::token::{Bracket, TokenKind};
use super::{Span, SyntaxError};
use crate::symbolic::Polynomial;

/// A frame as it was written. The entries may contain symbols; whether the
/// frame is degenerate is not checked here.
#[derive(Clone, Debug, PartialEq)]
pub enum FrameInput {
    /// `r..s`.
    Interval(Polynomial, Polynomial),
    /// Three points of the parameter plane.
    Triangle([[Polynomial; 2]; 3]),
    /// `a..b, c..d`: the interval of each parameter.
    Rectangle([(Polynomial, Polynomial); 2]),
}

/// Reads an interval `-1..3`, a triangle `(1,0) (0,1) (0,0)` or a rectangle
/// `0..1, 0..2`.
///
/// # Errors
/// If the text is none of these.
///
/// ```
/// use casteljau::{Polynomial, Rational, syntax};
/// let number = |value: i32| Polynomial::from(Rational::from(value));
/// assert_eq!(syntax::parse_frame("-1..3")?, syntax::FrameInput::Interval(number(-1), number(3)));
/// # Ok::<(), syntax::SyntaxError>(())
/// ```
pub fn parse_frame(text: &str) -> Result<FrameInput, SyntaxError> {
    let mut parser = Parser::spaced(text)?;
    parser.not_empty(FRAME)?;
    parser.frame()
}

const FRAME: &str = "a frame: an interval `0..1`, a rectangle `0..1, 0..1` or a triangle `(1,0) (0,1) (0,0)`";

impl Parser<'_> {
    fn frame(&mut self) -> Result<FrameInput, SyntaxError> {
        if self.peek() == TokenKind::Open(Bracket::Square) {
            return Err(self.expected(FRAME).with_help("an interval is written `r..s`, without brackets"));
        }
        let start = self.token(0).span;
        let first = self.expression()?;
        let value = self.evaluate(&first)?;
        if let Value::Scalar(r) = value {
            let u = self.interval(r)?;
            self.take(TokenKind::Comma);
            if self.at_end() {
                return if self.source.trim_end().ends_with(',') && !self.is_latex() {
                    Err(self.expected("a second interval"))
                } else {
                    Ok(FrameInput::Interval(u.0, u.1))
                };
            }
            let c = self.scalar()?;
            let v = self.interval(c)?;
            self.finish("the end of the rectangle")?;
            return Ok(FrameInput::Rectangle([u, v]));
        }
        let mut vertices: Vec<[Polynomial; 2]> = vec![vertex(value, first.span)?];
        let mut span = start.to(first.span);
        while !self.at_end() {
            self.take(TokenKind::Comma);
            let expression = self.expression()?;
            let value = self.evaluate(&expression)?;
            vertices.push(vertex(value, expression.span)?);
            span = span.to(expression.span);
        }
        <[[Polynomial; 2]; 3]>::try_from(vertices).map(FrameInput::Triangle).map_err(|vertices| {
            SyntaxError::new(span, format!("found {} points, expected the three vertices of a triangle", vertices.len()))
        })
    }

    /// The rest of an interval behind its first end.
    fn interval(&mut self, start: Polynomial) -> Result<(Polynomial, Polynomial), SyntaxError> {
        if !self.take(TokenKind::Range) {
            return Err(self.expected("`..` and the other end of the interval"));
        }
        Ok((start, self.scalar()?))
    }
}

fn vertex(value: Value, span: Span) -> Result<[Polynomial; 2], SyntaxError> {
    let values = match value {
        Value::Scalar(value) => vec![value],
        Value::Tuple(values) => values,
    };
    <[Polynomial; 2]>::try_from(values).map_err(|values| {
        let plural = if values.len() == 1 { "" } else { "s" };
        SyntaxError::new(
            span,
            format!("found a vertex with {} coordinate{plural}, expected a point `(u,v)` of the parameter plane", values.len()),
        )
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn shown(source: &str) -> String {
        match parse_frame(source) {
            Ok(FrameInput::Interval(r, s)) => format!("{r}..{s}"),
            Ok(FrameInput::Rectangle([u, v])) => format!("{}..{} x {}..{}", u.0, u.1, v.0, v.1),
            Ok(FrameInput::Triangle(vertices)) => vertices.map(|[u, v]| format!("<{u},{v}>")).concat(),
            Err(error) => format!("{}: {error}", error.position(source).1),
        }
    }

    #[test]
    fn frames() {
        for (source, expected) in [
            ("-1..3", "-1..3"),
            ("3..-1", "3..-1"),
            ("-1 .. 3", "-1..3"),
            ("0..0.5", "0..1/2"),
            ("1/2..a+1", "1/2..a + 1"),
            ("0..0", "0..0"),
            ("0..1, -1..1", "0..1 x -1..1"),
            ("0..1 -1..1", "0..1 x -1..1"),
            ("(1,0) (0,1) (0,0)", "<1,0><0,1><0,0>"),
            ("(1,0), (0,1), (0,0)", "<1,0><0,1><0,0>"),
            ("(a,0)(0,1)(0,0)", "<a,0><0,1><0,0>"),
        ] {
            assert_eq!(shown(source), expected, "{source}");
        }
        for (source, expected) in [
            ("", format!("1: found nothing, expected {FRAME}")),
            ("[0, 1]", format!("1: found `[`, expected {FRAME}")),
            ("0..", "4: found the end of the input, expected a number, a letter or `(`".to_owned()),
            ("5", "2: found the end of the input, expected `..` and the other end of the interval".to_owned()),
            ("0..1, 2", "8: found the end of the input, expected `..` and the other end of the interval".to_owned()),
            ("0..1, 0..1, 0..1", "11: found `,`, expected the end of the rectangle".to_owned()),
            ("(1,0) (0,1)", "1: found 2 points, expected the three vertices of a triangle".to_owned()),
            ("(1,0) (0,1) 3", "13: found a vertex with 1 coordinate, expected a point `(u,v)` of the parameter plane".to_owned()),
            ("(1,0,0) (0,1) (0,0)", "1: found a vertex with 3 coordinates, expected a point `(u,v)` of the parameter plane".to_owned()),
            ("0..1,", "6: found the end of the input, expected a second interval".to_owned()),
        ] {
            assert_eq!(shown(source), expected, "{source}");
        }
    }
}
