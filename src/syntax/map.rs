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
        let mut all: Vec<Symbol> = self.components.iter().flat_map(Polynomial::symbols).filter(|symbol| !variables.contains(symbol)).collect();
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
                let message = format!("found other variables behind `{}` than behind `{}`, expected the same", definition.name, sorted[0].name);
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
                let error = SyntaxError::new(sorted[0].name_span, "found `z = …` in one variable, expected the graph of a function of two variables");
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
                    Err(SyntaxError::new(second.name_span, message).with_help(format!("components are named `{letter}_1`, `{letter}_2`, …")))
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
            let message = format!("found a definition of `{}` behind one of `{}`, expected another component of the same map", stranger.name, first.name);
            return Err(SyntaxError::new(stranger.name_span, message));
        }
        sorted.sort_by_key(|definition| place(definition));
        for (definition, wanted) in sorted.iter().zip(1u32..) {
            if place(definition) != Some(wanted) {
                let name = if coordinates { Symbol::new(COORDINATES.get(wanted as usize - 1).copied().unwrap_or('z'), None) } else { Symbol::new(letter, Some(wanted)) };
                let repeated = place(definition).is_some_and(|place| place < wanted && place > 0);
                let message = if repeated {
                    format!("found a second definition of `{}`, expected one", definition.name)
                } else {
                    format!("found a definition of `{}` but none of `{name}`, expected components numbered from 1 without a gap", definition.name)
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
