//! The choice between an equation and a list of points.

use super::SyntaxError;
use super::map::MapInput;
use super::parser::Parser;
use super::points::PointsInput;
use super::token::{Bracket, TokenKind};
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
        None if combines => {
            error.with_help("more than one point outside brackets makes a list; begin with `F(t) =` if this is an equation")
        }
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::syntax::{parse_components, parse_frame, parse_number, parse_points, parse_polar_arguments, parse_scalars, parse_variables};
    use proptest::prelude::*;
    use std::time::{Duration, Instant};

    #[test]
    fn equation_or_points() {
        for (source, points) in [
            ("(t, t^2)", false),
            ("(t, t^2) * 2", false),
            ("t^{2}", false),
            ("(1 + t)(2 + t)", false),
            ("F(u,v) = (u, v, u v)", false),
            ("z = x y", false),
            ("5", false),
            ("(0,0) (1,2)", true),
            ("(0,0), (1,2)", true),
            ("[1, 3, 5]", true),
            ("[(0,0)]", true),
            ("{{0, 0}, {1, 1}}", true),
            ("(1,1):2", true),
            ("1 2; 3 4", true),
        ] {
            assert_eq!(matches!(parse_input(source, None), Ok(Input::Points(_))), points, "{source}");
            assert!(parse_input(source, None).is_ok(), "{source}");
        }
        let combination = parse_input("(1-t)^2 (0,0) + t^2 (1,1)", None);
        assert!(combination.is_err_and(|error| error.help.is_some_and(|help| help.contains("`F(t) =`"))));
    }

    /// Reads a text in every way there is.
    fn read_all(source: &str) {
        let _ = (parse_input(source, None), parse_points(source), parse_frame(source), parse_polar_arguments(source));
        let _ = (parse_scalars(source), parse_components(source), parse_number(source), parse_variables(source));
        if let Err(error) = parse_input(source, None) {
            let (line, column) = error.position(source);
            assert!(line > 0 && column > 0 && error.span.start <= source.len() && error.span.end >= error.span.start, "{source}");
            assert!(error.message.starts_with("found ") && !error.message.contains('\n'), "{error}");
        }
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(2000))]
        #[test]
        fn nothing_panics(source in "([-+*/^(){}\\[\\],;:.=<>!$&~_ \n0-9tuvexyzFλ½²₁√é\u{7}]|\\\\frac|\\\\\\\\|\\\\sqrt|sqrt\\(|\\\\left|\\\\begin\\{split\\}|1e99|\\^99|\\.\\.){0,24}") {
            read_all(&source);
        }

        #[test]
        fn arbitrary_text_does_not_panic(source in any::<String>()) {
            read_all(&source);
        }
    }

    /// What would take forever is refused before it is begun, and with a message that names the limit.
    #[test]
    fn limits() {
        let deep = |open: &str| open.repeat(100_000);
        for (source, limit) in [
            ("t^1000000000".to_owned(), "4096"),
            ("((t^99)^99)^99".to_owned(), "4096"),
            ("(t^4000)^2 + 1".to_owned(), "4096"),
            ("(t^4000 + 1)(t^97 + 1)".to_owned(), "4096"),
            ("(a+b+c+d+e+f)^300".to_owned(), "1000000 terms"),
            ("(t + u1 + 1)^1000".to_owned(), "too much work"),
            ("((9^999)^999)^999".to_owned(), "10000 digits"),
            ("9^1000000000".to_owned(), "10000 digits"),
            ("(t/3)^4000 (1/997)^3000".to_owned(), "10000 digits"),
            ("1e9999 1e9999".to_owned(), "10000 digits"),
            ("1e100000000000000000000".to_owned(), "10000 digits"),
            ("9".repeat(20_000), "10000 digits"),
            ("2^99999999999999".to_owned(), "4294967295"),
            (deep("("), "128"),
            (deep("["), "128"),
            (deep("{"), "128"),
            (deep("√"), "128"),
            (deep(r"\sqrt"), "128"),
            (deep(r"\frac"), "128"),
            (deep(r"\frac{"), "128"),
            (deep("2^("), "128"),
            ("x".repeat((1 << 20) + 1), "1048576"),
            ((1..9000).map(|k| format!("+1/{k}")).collect(), "too much work"),
            (format!("1/{}{}", "7".repeat(9000), "+1/3".repeat(20_000)), "too much work"),
            ("+1e9999".repeat(20_000), "too much work"),
            ("(t+1)".repeat(20_000), "too much work"),
        ] {
            let start = Instant::now();
            let message = parse_input(&source, None).err().map(|error| error.message).unwrap_or_default();
            let shown: String = source.chars().take(20).collect();
            assert!(message.contains(limit), "{shown}: {message}");
            // Generous: tests run without optimization, on busy machines.
            assert!(start.elapsed() < Duration::from_secs(20), "{shown}: {:?}", start.elapsed());
        }
    }

    /// Time grows with the length of the input, not with its square.
    #[test]
    fn long_inputs() {
        let length = 60_000;
        for (piece, fine) in [
            ("+t", true),
            ("1 ", true),
            ("+t^4096", true),
            ("-", false),
            ("^", false),
            ("(0,0) ", true),
            ("[1],", false),
            ("(0,0);", false),
            ("F=1,", false),
        ] {
            let source = piece.repeat(length / piece.len());
            let start = Instant::now();
            assert_eq!(parse_input(&source, None).is_ok(), fine, "{piece}");
            assert!(start.elapsed() < Duration::from_secs(10), "{piece}: {:?}", start.elapsed());
        }
        let row = |length: usize| (1..=length).map(|k| format!("t{k} ")).collect::<String>();
        assert!(parse_input(&row(4096), None).is_ok());
        assert!(parse_input(&row(4097), None).is_err());
    }
}
