//! Polynomial maps: curves and surfaces given by equations.

use std::collections::BTreeMap;

use super::definition::Definition;
use super::evaluate::Value;
use super::expression::{Expression, ExpressionKind};
use super::parser::Parser;
use super::{Span, SyntaxError};
use crate::symbolic::{Polynomial, Symbol};

/// The variables of a map; every other symbol is a parameter.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Variables {
    /// A curve in one variable.
    Curve(Symbol),
    /// A surface in two variables, first and second.
    Surface(Symbol, Symbol),
}

impl Variables {
    /// The one or two variables in their order.
    #[must_use]
    pub fn symbols(self) -> Vec<Symbol> {
        match self {
            Self::Curve(variable) => vec![variable],
            Self::Surface(first, second) => vec![first, second],
        }
    }
}

/// A polynomial map as it was written.
#[derive(Clone, Debug, PartialEq)]
pub struct MapInput {
    /// One polynomial for each coordinate, at least one.
    pub components: Vec<Polynomial>,
    /// Where each component was written; parallel to `components`.
    pub spans: Vec<Span>,
    /// The variables.
    pub variables: Variables,
    /// Whether the map was written with coordinates: in brackets, as `F_1`,
    /// `F_2`, …, or as a graph. A bare polynomial has one component and `false`.
    pub is_point: bool,
}

impl MapInput {
    /// The parameters: the symbols of the components that are not variables, sorted.
    #[must_use]
    pub fn parameters(&self) -> Vec<Symbol> {
        let variables = self.variables.symbols();
        let mut all: Vec<Symbol> =
            self.components.iter().flat_map(Polynomial::symbols).filter(|symbol| !variables.contains(symbol)).collect();
        all.sort_unstable();
        all.dedup();
        all
    }
}

/// Reads a map: `(x, y)`, a bare polynomial, `F(t) = …`, definitions of
/// components `F_1(t) = …, F_2(t) = …`, or a graph `z = …`.
///
/// The variables are `vars` if given, else the letters in the brackets of a
/// definition, else a pair u,v or U,V or x,y of which a letter occurs, else `t`.
///
/// # Errors
/// If the text is not such a map, if its variables are not clear, or if it
/// exceeds a limit.
///
/// ```
/// use casteljau::{Symbol, syntax};
/// let map = syntax::parse_map("(a t^2 + 1, t/2)", None)?;
/// assert_eq!(map.variables, syntax::Variables::Curve(Symbol::new('t', None)));
/// assert_eq!(map.components[0].to_string(), "a t^2 + 1");
/// # Ok::<(), syntax::SyntaxError>(())
/// ```
pub fn parse_map(text: &str, vars: Option<&[Symbol]>) -> Result<MapInput, SyntaxError> {
    let mut parser = Parser::new(text)?;
    parser.map(vars)
}

/// The pairs of letters that make a map a surface.
const PAIRS: [(char, char); 3] = [('u', 'v'), ('U', 'V'), ('x', 'y')];

impl Parser<'_> {
    pub(crate) fn map(&mut self, vars: Option<&[Symbol]>) -> Result<MapInput, SyntaxError> {
        self.not_empty("a map such as `(t, t^2)`")?;
        if self.at_definition() {
            let definitions = self.definitions()?;
            return self.map_of_definitions(&definitions, vars);
        }
        let body = self.expression()?;
        if !self.at_end() {
            return Err(self.unexpected_behind_map());
        }
        let variables = choose(vars, None, &[&body])?;
        let (components, spans, is_point) = self.components_of(&body)?;
        Ok(MapInput { components, spans, variables, is_point })
    }

    /// What stands behind an expression that could have been the whole map.
    pub(crate) fn unexpected_behind_map(&self) -> SyntaxError {
        let error = self.expected("an operator or the end of the input");
        match self.peek() {
            super::token::TokenKind::Comma => error.with_help("a map with several components is written in brackets: `(…, …)`"),
            super::token::TokenKind::Equals => error.with_help("a definition begins `F(t) =`, `F_1(t) =` or `z =`"),
            _ => error,
        }
    }

    /// The components of a body, with their places, and whether it is a tuple.
    pub(crate) fn components_of(&mut self, body: &Expression) -> Result<(Vec<Polynomial>, Vec<Span>, bool), SyntaxError> {
        match self.evaluate(body)? {
            Value::Scalar(value) => Ok((vec![value], vec![body.span], false)),
            Value::Tuple(values) => {
                let spans = match &body.kind {
                    ExpressionKind::Tuple(items) => items.iter().map(|item| item.span).collect(),
                    _ => vec![body.span; values.len()],
                };
                Ok((values, spans, true))
            }
        }
    }

    fn map_of_definitions(&mut self, definitions: &[Definition], vars: Option<&[Symbol]>) -> Result<MapInput, SyntaxError> {
        let sorted = self.sort_components(definitions)?;
        let head = sorted[0].arguments.as_deref();
        for definition in &sorted[1..] {
            let same = match (head, definition.arguments.as_deref()) {
                (Some(a), Some(b)) => a.iter().map(|entry| entry.0).eq(b.iter().map(|entry| entry.0)),
                (a, b) => a.is_none() && b.is_none(),
            };
            if !same {
                let message =
                    format!("found other variables behind `{}` than behind `{}`, expected the same", definition.name, sorted[0].name);
                return Err(SyntaxError::new(definition.name_span, message));
            }
        }
        let bodies: Vec<&Expression> = sorted.iter().map(|definition| &definition.body).collect();
        let variables = choose(vars, head, &bodies)?;
        let single = sorted.len() == 1 && sorted[0].name.index().is_none();
        if single && sorted[0].name.letter() != 'z' {
            let (components, spans, is_point) = self.components_of(&sorted[0].body)?;
            return Ok(MapInput { components, spans, variables, is_point });
        }
        let mut components = Vec::with_capacity(sorted.len() + 2);
        let mut spans = Vec::with_capacity(sorted.len() + 2);
        if single {
            let Variables::Surface(first, second) = variables else {
                let error = SyntaxError::new(
                    sorted[0].name_span,
                    "found `z = …` in one variable, expected the graph of a function of two variables",
                );
                return Err(error.with_help("name the variables with `--vars x,y`, or write a curve as `(t, …)`"));
            };
            components.extend([Polynomial::from(first), Polynomial::from(second)]);
            spans.extend([sorted[0].name_span; 2]);
        }
        for definition in &sorted {
            components.push(self.evaluate_scalar(&definition.body)?);
            spans.push(definition.body.span);
        }
        Ok(MapInput { components, spans, variables, is_point: true })
    }

    /// The definitions in the order of the coordinates: one map, or `F_1`,
    /// `F_2`, …, or, in LaTeX, `x`, `y`, `z`.
    pub(crate) fn sort_components<'d>(&self, definitions: &'d [Definition]) -> Result<Vec<&'d Definition>, SyntaxError> {
        const COORDINATES: [char; 3] = ['x', 'y', 'z'];
        let mut sorted: Vec<&Definition> = definitions.iter().collect();
        let Some(first) = definitions.first() else {
            return Err(self.expected("a definition"));
        };
        let letter = first.name.letter();
        let is_coordinate = |definition: &Definition| definition.name.index().is_none() && COORDINATES.contains(&definition.name.letter());
        let is_graph = definitions.len() == 1 && letter == 'z' && first.arguments.as_ref().is_none_or(|arguments| arguments.len() == 2);
        if first.name.index().is_none() && !is_coordinate(first) || is_graph && first.name.index().is_none() {
            if !is_graph && first.arguments.is_none() && !letter.is_uppercase() {
                let message = format!("found `{letter} =`, expected `F(t) =`, `F_1(t) =` or `z =`");
                return Err(SyntaxError::new(first.name_span, message).with_help("write a map as `(…, …)` or as `F(t) = (…, …)`"));
            }
            return match definitions.get(1) {
                Some(second) if second.name == first.name => {
                    Err(SyntaxError::new(second.name_span, format!("found a second definition of `{}`, expected one", second.name)))
                }
                Some(second) => {
                    let message = format!("found a definition of `{}` behind one of `{}`, expected a single map", second.name, first.name);
                    Err(SyntaxError::new(second.name_span, message)
                        .with_help(format!("components are named `{letter}_1`, `{letter}_2`, …")))
                }
                None => Ok(sorted),
            };
        }
        let coordinates = is_coordinate(first);
        if coordinates && !self.is_latex() {
            let message = format!("found `{letter} = …` as a component, expected `F(t) = (…, …)`");
            let error = SyntaxError::new(first.name_span, message);
            return Err(error.with_help("only LaTeX input may name components `x(t)`, `y(t)`; write `(…, …)` or `F_1(t) = …, F_2(t) = …`"));
        }
        let place = |definition: &Definition| match (coordinates, definition.name.index()) {
            (true, None) => COORDINATES.iter().position(|&name| name == definition.name.letter()).map(|place| place as u32 + 1),
            (false, Some(index)) if definition.name.letter() == letter => Some(index),
            _ => None,
        };
        if let Some(stranger) = definitions.iter().find(|definition| place(definition).is_none()) {
            let message = format!(
                "found a definition of `{}` behind one of `{}`, expected another component of the same map",
                stranger.name, first.name
            );
            return Err(SyntaxError::new(stranger.name_span, message));
        }
        sorted.sort_by_key(|definition| place(definition));
        for (definition, wanted) in sorted.iter().zip(1u32..) {
            if place(definition) != Some(wanted) {
                let name = if coordinates {
                    Symbol::new(COORDINATES.get(wanted as usize - 1).copied().unwrap_or('z'), None)
                } else {
                    Symbol::new(letter, Some(wanted))
                };
                let repeated = place(definition).is_some_and(|place| place < wanted && place > 0);
                let message = if repeated {
                    format!("found a second definition of `{}`, expected one", definition.name)
                } else {
                    format!(
                        "found a definition of `{}` but none of `{name}`, expected components numbered from 1 without a gap",
                        definition.name
                    )
                };
                return Err(SyntaxError::new(definition.name_span, message));
            }
        }
        Ok(sorted)
    }
}

/// Decides which letters are the variables.
fn choose(vars: Option<&[Symbol]>, head: Option<&[(Symbol, Span)]>, bodies: &[&Expression]) -> Result<Variables, SyntaxError> {
    let start = bodies.first().map_or(Span::default(), |body| body.span);
    if let Some(head) = head {
        let letters: Vec<Symbol> = head.iter().map(|entry| entry.0).collect();
        let span = head.iter().map(|entry| entry.1).reduce(Span::to).unwrap_or(start);
        if let Some(vars) = vars.filter(|vars| *vars != letters.as_slice()) {
            let list = |symbols: &[Symbol]| symbols.iter().map(ToString::to_string).collect::<Vec<_>>().join(",");
            let message = format!("found a definition in `{}`, expected one in `{}` as `--vars` says", list(&letters), list(vars));
            return Err(SyntaxError::new(span, message));
        }
        return from_slice(&letters, span);
    }
    if let Some(vars) = vars {
        return from_slice(vars, start);
    }
    let mut written = BTreeMap::new();
    bodies.iter().for_each(|body| body.collect_symbols(&mut written));
    let t = Symbol::new('t', None);
    // One letter for every set of variables that occurs, with the set.
    let mut sets: Vec<(Span, Symbol, Variables)> = Vec::new();
    if let Some(&span) = written.get(&t) {
        sets.push((span, t, Variables::Curve(t)));
    }
    for (first, second) in PAIRS.map(|(first, second)| (Symbol::new(first, None), Symbol::new(second, None))) {
        let letters = [first, second].into_iter().filter_map(|letter| written.get(&letter).map(|&span| (span, letter)));
        if let Some((span, letter)) = letters.min() {
            sets.push((span, letter, Variables::Surface(first, second)));
        }
    }
    sets.sort_unstable_by_key(|entry| entry.0);
    if let [(_, a, _), (span, b, _), ..] = sets.as_slice() {
        let message = format!("found both `{a}` and `{b}`, expected the variable `t` alone or one of the pairs u,v or U,V or x,y");
        let help = "say which letters are variables, as in `--vars t` or `--vars u,v`; all others are then parameters";
        return Err(SyntaxError::new(*span, message).with_help(help));
    }
    if let [(_, _, variables)] = sets.as_slice() {
        return Ok(*variables);
    }
    let mut others = written.iter().filter(|entry| entry.0.index().is_none());
    match (others.next(), others.next()) {
        (Some((letter, &span)), None) => {
            let message = format!("found only the letter `{letter}`, expected a variable: `t`, or a pair u,v or U,V or x,y");
            let help = format!("write `--vars {letter}` if `{letter}` is the variable, or `--vars t` if it is a parameter");
            Err(SyntaxError::new(span, message).with_help(help))
        }
        _ => Ok(Variables::Curve(t)),
    }
}

fn from_slice(symbols: &[Symbol], span: Span) -> Result<Variables, SyntaxError> {
    match *symbols {
        [variable] => Ok(Variables::Curve(variable)),
        [first, second] if first != second => Ok(Variables::Surface(first, second)),
        _ => Err(SyntaxError::new(span, format!("found {} variables, expected one or two different ones", symbols.len()))),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::syntax::parse_variables;

    fn shown(source: &str, vars: Option<&str>) -> String {
        let vars = vars.map(|vars| parse_variables(vars).unwrap_or_default());
        match parse_map(source, vars.as_deref()) {
            Ok(map) => {
                let components: Vec<String> = map.components.iter().map(ToString::to_string).collect();
                assert_eq!(map.components.len(), map.spans.len(), "{source}");
                format!("{:?} {}{}", map.variables.symbols(), if map.is_point { "" } else { "bare " }, components.join(" | "))
            }
            Err(error) => {
                let (line, column) = error.position(source);
                format!("{line}:{column}: {error}")
            }
        }
    }

    #[test]
    fn curves_and_surfaces() {
        for (source, expected) in [
            ("(t, t^2)", "[t] t | t^2"),
            ("a t^2 + b t + c", "[t] bare a t^2 + b t + c"),
            ("(5, 7)", "[t] 5 | 7"),
            ("(a, b)", "[t] a | b"),
            ("(t1, 2)", "[t] t1 | 2"),
            ("u^2", "[u, v] bare u^2"),
            ("(V, 1)", "[U, V] V | 1"),
            ("(x, y, x y)", "[x, y] x | y | x y"),
            ("(0 u, 1)", "[u, v] 0 | 1"),
            ("F(t) = (t, t^2)", "[t] t | t^2"),
            ("F(t) = t^2", "[t] bare t^2"),
            ("F(r) = (r, t)", "[r] r | t"),
            ("S(u,v) = (u, v, t)", "[u, v] u | v | t"),
            ("S(p,q) = (p, q, u)", "[p, q] p | q | u"),
            ("F = (t, 1)", "[t] t | 1"),
            ("F_1(t) = t, F_2(t) = t^2", "[t] t | t^2"),
            ("F_1(t) = t\nF_2(t) = t^2", "[t] t | t^2"),
            ("F_2(t) = t\nF_1(t) = t^2", "[t] t^2 | t"),
            ("f_1(t) = t,\nf_2(t) = t^2", "[t] t | t^2"),
            (r"F_1(t) = t \qquad F_2(t) = t^2", "[t] t | t^2"),
            (r"F_1(t) = t \\ F_2(t) = t^2", "[t] t | t^2"),
            ("$F_1(t) = t$ $F_2(t) = t^2$", "[t] t | t^2"),
            ("F_1(t) = t\n + 1\nF_2(t) = t^2", "[t] t + 1 | t^2"),
            ("F_1(t) = t", "[t] t"),
            ("F(t) = (1-t)^2 (0,0) + 2t(1-t) (1,2) + t^2 (3,4)/2", "[t] -1/2 t^2 + 2 t | -2 t^2 + 4 t"),
            ("z = x^3 - 3xy^2", "[x, y] x | y | x^3 - 3 x y^2"),
            ("$$z = x^3 - 3xy^2.$$", "[x, y] x | y | x^3 - 3 x y^2"),
            ("z = u v", "[u, v] u | v | u v"),
            ("z(u,v) = 1", "[u, v] u | v | 1"),
            (r"\begin{aligned}x(t) &= x_1t + x_0, \\y(t) &= y_1t + y_0.\end{aligned}", "[t] t x1 + x0 | t y1 + y0"),
        ] {
            assert_eq!(shown(source, None), expected, "{source}");
        }
        for (source, vars, expected) in [
            ("(r, t)", "r", "[r] r | t"),
            ("(t, u)", "t", "[t] t | u"),
            ("(p, q t)", "p,q", "[p, q] p | q t"),
            ("z = p q", "p,q", "[p, q] p | q | p q"),
            ("z = 1", "x,y", "[x, y] x | y | 1"),
            ("F(r) = r", "r", "[r] bare r"),
        ] {
            assert_eq!(shown(source, Some(vars)), expected, "{source}");
        }
    }

    #[test]
    fn the_textbook_cubic_and_surface() {
        let cubic =
            r"$$F_1(t) = \frac{3}{4}t^2 - \frac{3}{2}t - \frac{9}{4}, \qquad F_2(t) = \frac{3}{4}t^3 - \frac{3}{2}t^2 - \frac{9}{4}t.$$";
        assert_eq!(shown(cubic, None), "[t] 3/4 t^2 - 3/2 t - 9/4 | 3/4 t^3 - 3/2 t^2 - 9/4 t");
        let enneper = "$$F_1(U,V) = U - \\frac{U^3}{3} + UV^2$$\n\n$$F_2(U,V) = V - \\frac{V^3}{3} + U^2V$$\n\n$$F_3(U,V) = U^2 - V^2.$$";
        assert_eq!(shown(enneper, None), "[U, V] -1/3 U^3 + U V^2 + U | U^2 V - 1/3 V^3 + V | U^2 - V^2");
    }

    #[test]
    fn errors() {
        const VARIABLES: &str = "expected the variable `t` alone or one of the pairs u,v or U,V or x,y";
        const BEHIND: &str = "expected an operator, the end of the input or another definition";
        for (source, expected) in [
            ("", "1:1: found nothing, expected a map such as `(t, t^2)`".to_owned()),
            ("(t, u)", format!("1:5: found both `t` and `u`, {VARIABLES}")),
            ("(u, x)", format!("1:5: found both `u` and `x`, {VARIABLES}")),
            ("(U, v)", format!("1:5: found both `U` and `v`, {VARIABLES}")),
            ("(r, r^2)", "1:2: found only the letter `r`, expected a variable: `t`, or a pair u,v or U,V or x,y".to_owned()),
            ("t, t^2", "1:2: found `,`, expected an operator or the end of the input".to_owned()),
            ("x = = y", "1:5: found `=`, expected a number, a letter or `(`".to_owned()),
            ("2 = y", "1:3: found `=`, expected an operator or the end of the input".to_owned()),
            ("y = t^2", "1:1: found `y = …` as a component, expected `F(t) = (…, …)`".to_owned()),
            ("x(t) = t\ny(t) = t", "1:1: found `x = …` as a component, expected `F(t) = (…, …)`".to_owned()),
            ("w = t", "1:1: found `w =`, expected `F(t) =`, `F_1(t) =` or `z =`".to_owned()),
            ("z = t", "1:1: found `z = …` in one variable, expected the graph of a function of two variables".to_owned()),
            ("z = (x, y)", "1:5: found a point with 2 coordinates, expected a single value".to_owned()),
            ("F_1(t) = (t, 1)", "1:10: found a point with 2 coordinates, expected a single value".to_owned()),
            ("F(t) = t, t^2", format!("1:11: found `t`, {BEHIND}")),
            ("F(t) = t,", format!("1:10: found the end of the input, {BEHIND}")),
            ("F(t) = t)", "1:9: found `)` without an opening bracket".to_owned()),
            (
                "F_1(t) = t F_2(t) = t",
                "1:12: found `F_2`, expected an operator, or a line end or `,` before the next definition".to_owned(),
            ),
            (
                "F_1(t) = t, F_3(t) = t",
                "1:13: found a definition of `F3` but none of `F2`, expected components numbered from 1 without a gap".to_owned(),
            ),
            ("F_1(t) = t, F_1(t) = t", "1:13: found a second definition of `F1`, expected one".to_owned()),
            (
                "F_1(t) = t, G_2(t) = t",
                "1:13: found a definition of `G2` behind one of `F1`, expected another component of the same map".to_owned(),
            ),
            ("F_1(t) = t, F_2(s) = t", "1:13: found other variables behind `F2` than behind `F1`, expected the same".to_owned()),
            ("F(t) = t, G(t) = t", "1:11: found a definition of `G` behind one of `F`, expected a single map".to_owned()),
            ("F(t) = t, F(t) = t", "1:11: found a second definition of `F`, expected one".to_owned()),
            ("F(t,t) = t", "1:5: found the variable `t` twice, expected different variables".to_owned()),
            ("F(a,b,c) = a", "1:3: found 3 variables, expected one or two different ones".to_owned()),
            ("F() = 1", "1:3: found `)`, expected a variable".to_owned()),
            ("F(2) = 1", "1:3: found `2`, expected a variable".to_owned()),
        ] {
            assert_eq!(shown(source, None), expected, "{source}");
        }
        assert_eq!(shown("F(t) = t", Some("r")), "1:3: found a definition in `t`, expected one in `r` as `--vars` says");
        let help = |source: &str| parse_map(source, None).err().and_then(|error| error.help).unwrap_or_default();
        assert!(help("(r, 1)").contains("`--vars r`"));
        assert!(help("(t, u)").contains("`--vars"));
        assert!(help("z = t").contains("`--vars x,y`"));
        assert!(help("t, t^2").contains("`(…, …)`"));
    }

    #[test]
    fn parameters() {
        let map = parse_map("(a t^2 + b1, λ t)", None);
        assert_eq!(map.map(|map| format!("{:?}", map.parameters())), Ok("[a, b1, λ]".to_owned()));
    }
}
