//! From expressions to values.

use std::borrow::Cow;

use num_traits::ToPrimitive;

use super::function::{self, Operand, Operands};
use super::quantity::{Map, Net, Point, Quantity};
use super::request::Request;
use super::scope::{Callee, Scope};
use super::size::Growing;
use super::slip::Slip;
use crate::affine::{Parameter, PlaneParameter};
use crate::error::Error;
use crate::piece::Piece;
use crate::symbolic::{Polynomial, Symbol};
use crate::syntax::evaluate::Value as Formula;
use crate::syntax::expression::{Argument, Arguments, Call, Callee as Called, Expression, ExpressionKind, PolarArgument};
use crate::syntax::parser::{Named, Parser};
use crate::syntax::{ArgumentInput, Span, SyntaxError};
use crate::value::{Domain, Value};

type Outcome = Result<Quantity, SyntaxError>;

/// What expressions are evaluated with.
pub(super) struct Evaluator<'w> {
    pub(super) scope: &'w Scope,
    /// Letters that are variables here, whatever they stand for elsewhere.
    pub(super) variables: &'w [Symbol],
    /// The name whose definition this is.
    pub(super) defining: Option<Symbol>,
    /// A usual mistake to make on purpose.
    pub(super) slip: Option<Slip>,
}

/// An error of a computation at the place that asked for it.
pub(super) fn at(span: Span) -> impl Fn(Error) -> SyntaxError {
    move |error| {
        let message = error.to_string();
        match error {
            Error::DegreeTooLow { .. } => {
                SyntaxError::new(span, message).with_help("the polar degree is raised by `degree` behind a definition, never lowered")
            }
            _ => SyntaxError::new(span, message),
        }
    }
}

impl Evaluator<'_> {
    pub(super) fn evaluate(&self, parser: &mut Parser<'_>, expression: &Expression) -> Outcome {
        match &expression.kind {
            ExpressionKind::Call(call) => self.call(parser, call, expression.span),
            ExpressionKind::List(items) => {
                let mut list = Growing::default();
                for item in items {
                    list.push(self.evaluate(parser, item)?, item.span)?;
                }
                Ok(list.list())
            }
            ExpressionKind::Entry(list, numbers) => self.entry(parser, list, numbers),
            ExpressionKind::Weighted(point, weight) => {
                let coordinates = match self.evaluate(parser, point)? {
                    Quantity::Number(value) => vec![value],
                    Quantity::Point(Point { coordinates, weight: None }) => coordinates,
                    other => return Err(SyntaxError::new(point.span, format!("found {} with a weight, expected a point", other.kind()))),
                };
                let weight = self.polynomial(parser, weight)?;
                Ok(Quantity::Point(Point { coordinates, weight: Some(weight) }))
            }
            ExpressionKind::Word(word) if function::is_function(word) => {
                let error = SyntaxError::new(expression.span, format!("found the function `{word}` without its arguments"));
                Err(error.with_help(format!("write `{}`", function::signature(word))))
            }
            ExpressionKind::Word(word) => Ok(Quantity::Word(word)),
            ExpressionKind::Group(inner) => self.evaluate(parser, inner),
            ExpressionKind::Symbol(symbol) => match self.lookup(*symbol, expression.span)? {
                Some(value) => copied(parser, value, expression.span),
                None => Ok(Quantity::Number(Polynomial::from(*symbol))),
            },
            _ => {
                let bound = self.bind(parser, expression)?;
                Ok(match parser.evaluate(&bound)? {
                    Formula::Scalar(value) => Quantity::from(value),
                    Formula::Tuple(values) => Quantity::point(values),
                })
            }
        }
    }

    /// The value of a name; `None` for a letter that is a variable or a symbolic parameter.
    fn lookup(&self, symbol: Symbol, span: Span) -> Result<Option<&Quantity>, SyntaxError> {
        if self.variables.contains(&symbol) {
            return Ok(None);
        }
        if let Some(value) = self.scope.value(symbol) {
            return Ok(Some(value));
        }
        match self.scope.later.get(&symbol) {
            Some(_) => Err(self.too_early(symbol, span)),
            None => Ok(None),
        }
    }

    /// The error that a name is used before its definition.
    pub(super) fn too_early(&self, symbol: Symbol, span: Span) -> SyntaxError {
        let line = self.scope.later.get(&symbol).map_or(0, |later| later.line);
        if let Some(cycle) = self.defining.and_then(|name| self.scope.cycle(name, symbol)) {
            let way: Vec<String> = cycle.iter().map(Symbol::to_string).collect();
            let message = format!("found `{symbol}`, which is defined by itself: {}", way.join(" → "));
            return SyntaxError::new(span, message);
        }
        if self.scope.later.get(&symbol).is_some_and(|later| later.failed) {
            return SyntaxError::new(span, format!("found `{symbol}`, whose definition in line {line} is in error"));
        }
        SyntaxError::new(span, format!("found `{symbol}` before its definition in line {line}")).with_help("move the definition up")
    }

    /// The same expression with every name and call replaced by its value.
    fn bind<'e>(&self, parser: &mut Parser<'_>, expression: &'e Expression) -> Result<Cow<'e, Expression>, SyntaxError> {
        if !self.needs_binding(expression) {
            return Ok(Cow::Borrowed(expression));
        }
        let mut list = |parts: &[(bool, Expression)]| {
            parts.iter().map(|(flag, part)| Ok((*flag, self.bind(parser, part)?.into_owned()))).collect::<Result<Vec<_>, SyntaxError>>()
        };
        let kind = match &expression.kind {
            ExpressionKind::Sum(parts) => ExpressionKind::Sum(list(parts)?),
            ExpressionKind::Product(parts) => ExpressionKind::Product(list(parts)?),
            ExpressionKind::Power(base, exponent) => {
                ExpressionKind::Power(Box::new(self.bind(parser, base)?.into_owned()), Box::new(self.bind(parser, exponent)?.into_owned()))
            }
            ExpressionKind::Root(inner) => ExpressionKind::Root(Box::new(self.bind(parser, inner)?.into_owned())),
            ExpressionKind::Group(inner) => ExpressionKind::Group(Box::new(self.bind(parser, inner)?.into_owned())),
            ExpressionKind::Tuple(items) => ExpressionKind::Tuple(
                items.iter().map(|item| Ok(self.bind(parser, item)?.into_owned())).collect::<Result<_, SyntaxError>>()?,
            ),
            _ => ExpressionKind::Known(match self.evaluate(parser, expression)? {
                Quantity::Number(value) => Formula::Scalar(value),
                Quantity::Point(Point { coordinates, weight: None }) => Formula::Tuple(coordinates),
                Quantity::Map(map) if map.weight.is_none() => match map.components.as_slice() {
                    [only] => Formula::Scalar(only.clone()),
                    _ => Formula::Tuple(map.components),
                },
                other => {
                    let message = format!("found {} in a formula, expected a number, a polynomial or a point", other.kind());
                    return Err(SyntaxError::new(expression.span, message));
                }
            }),
        };
        Ok(Cow::Owned(Expression { kind, span: expression.span }))
    }

    fn needs_binding(&self, expression: &Expression) -> bool {
        match &expression.kind {
            ExpressionKind::Symbol(symbol) => {
                !self.variables.contains(symbol) && (self.scope.get(*symbol).is_some() || self.scope.later.contains_key(symbol))
            }
            ExpressionKind::Call(_) | ExpressionKind::Entry(..) | ExpressionKind::List(_) | ExpressionKind::Word(_) => true,
            _ => expression.parts().into_iter().any(|part| self.needs_binding(part)),
        }
    }

    /// A number or polynomial.
    pub(super) fn polynomial(&self, parser: &mut Parser<'_>, expression: &Expression) -> Result<Polynomial, SyntaxError> {
        match self.evaluate(parser, expression)? {
            Quantity::Number(value) => Ok(value),
            other => Err(SyntaxError::new(expression.span, format!("found {}, expected a number", other.kind()))),
        }
    }

    /// A small whole number.
    pub(super) fn count(&self, parser: &mut Parser<'_>, expression: &Expression) -> Result<usize, SyntaxError> {
        let value = self.polynomial(parser, expression)?;
        count_of(&value).ok_or_else(|| SyntaxError::new(expression.span, "found no small whole number, expected one such as 3"))
    }

    fn entry(&self, parser: &mut Parser<'_>, list: &Expression, numbers: &[Expression]) -> Outcome {
        let named = match list.kind {
            ExpressionKind::Symbol(symbol) => self.lookup(symbol, list.span)?,
            _ => None,
        };
        // Of a list with a name only the entry is copied.
        let mut value = match named {
            Some(value) => Cow::Borrowed(value),
            None => Cow::Owned(self.evaluate(parser, list)?),
        };
        let mut span = list.span;
        for number in numbers {
            let place = self.count(parser, number)?;
            value = match value {
                Cow::Borrowed(Quantity::List(items)) => {
                    Cow::Borrowed(items.get(place).ok_or_else(|| no_entry(place, items.len(), number))?)
                }
                Cow::Borrowed(value) => Cow::Owned(nth(copied(parser, value, span)?, place, span, number)?),
                Cow::Owned(value) => Cow::Owned(nth(value, place, span, number)?),
            };
            let closing = parser.source.get(number.span.end..).and_then(|rest| rest.find(']')).map_or(0, |length| length + 1);
            span = span.to(Span::new(number.span.start, number.span.end + closing));
        }
        match value {
            Cow::Borrowed(value) => copied(parser, value, span),
            Cow::Owned(value) => Ok(value),
        }
    }

    fn call(&self, parser: &mut Parser<'_>, call: &Call, span: Span) -> Outcome {
        match call.callee {
            Called::Function(name) => {
                let Arguments::Plain(arguments) = &call.arguments else {
                    return Err(SyntaxError::new(span, "found polar arguments, expected those of a function"));
                };
                let operands = self.operands(parser, arguments, function::own_words(name))?;
                let value = function::call(self, name, &Operands { list: &operands, name_span: call.name_span, span })?;
                parser.budget.spend(value.size(), span)?;
                Ok(value)
            }
            Called::Name(symbol) => {
                let callee =
                    self.scope.callee(symbol, true).ok_or_else(|| SyntaxError::new(call.name_span, format!("found `{symbol}` called")))?;
                let shape = self.shape(callee, call.name_span)?;
                parser.budget.spend(shape.size(), span)?;
                let value = match (&call.arguments, callee.named) {
                    (Arguments::Plain(arguments), Named::Map) => self.point(parser, &shape, arguments, span),
                    (Arguments::Polar(groups), Named::PolarForm) => self.polar(parser, &shape, groups, span),
                    _ => Err(SyntaxError::new(span, "found arguments of another kind than the name takes")),
                }?;
                parser.budget.spend(value.size(), span)?;
                Ok(value)
            }
        }
    }

    /// The map or net that is called, or one of its components.
    fn shape(&self, callee: Callee, span: Span) -> Outcome {
        let Some(value) = self.scope.value(callee.base) else {
            return Err(self.too_early(callee.base, span));
        };
        let Some(index) = callee.component else { return Ok(value.clone()) };
        let mut map = match value {
            Quantity::Map(map) => map.clone(),
            Quantity::Net(net) => net.map().map_err(at(span))?,
            other => return Err(SyntaxError::new(span, format!("found {} called, expected a map or a net", other.kind()))),
        };
        // The polar degree is that of the whole map.
        map.degrees = map.own_degrees().map_err(at(span))?;
        let component = map.components.get(index as usize - 1).cloned();
        map.components = component.into_iter().collect();
        Ok(Quantity::Map(map))
    }

    pub(super) fn operands(
        &self,
        parser: &mut Parser<'_>,
        arguments: &[Argument],
        words: &[&'static str],
    ) -> Result<Vec<Operand>, SyntaxError> {
        let mut operands = Vec::with_capacity(arguments.len());
        for argument in arguments {
            let span = argument.span();
            let text = span.text(parser.source).trim().to_owned();
            let word = words.iter().find(|word| **word == text);
            operands.push(match argument {
                Argument::Plain(_) if word.is_some() => {
                    Operand::Value { value: Quantity::Word(word.copied().unwrap_or_default()), span, text }
                }
                Argument::Plain(expression) => Operand::Value { value: self.evaluate(parser, expression)?, span, text },
                Argument::Range(from, to) => {
                    let (from, to) = (self.polynomial(parser, from)?, self.polynomial(parser, to)?);
                    Operand::Range { from, to, span }
                }
                Argument::Named(name, expression) => Operand::Named { name: *name, value: self.evaluate(parser, expression)?, span },
            });
        }
        Ok(operands)
    }

    /// The point of a map or net at parameters.
    fn point(&self, parser: &mut Parser<'_>, shape: &Quantity, arguments: &[Argument], span: Span) -> Outcome {
        let mut place = Vec::new();
        for operand in self.operands(parser, arguments, &[])? {
            match operand {
                Operand::Value { value: Quantity::Number(value), .. } => place.push(value),
                Operand::Value { value: Quantity::Point(Point { coordinates, weight: None }), .. } => place.extend(coordinates),
                Operand::Value { value, span, .. } => {
                    return Err(SyntaxError::new(span, format!("found {}, expected a parameter", value.kind())));
                }
                Operand::Range { span, .. } | Operand::Named { span, .. } => {
                    return Err(SyntaxError::new(span, "found something else, expected a parameter"));
                }
            }
        }
        value_at(shape, &place, self.slip).map_err(at(span))
    }

    /// A polar value.
    fn polar(&self, parser: &mut Parser<'_>, shape: &Quantity, groups: &[Vec<PolarArgument>], span: Span) -> Outcome {
        let mut evaluated = Vec::with_capacity(groups.len());
        for group in groups {
            let mut bound = Vec::with_capacity(group.len());
            for argument in group {
                let mut one = |expression: &Expression| Ok::<_, SyntaxError>(self.bind(parser, expression)?.into_owned());
                bound.push(PolarArgument {
                    weight: argument.weight.as_ref().map(&mut one).transpose()?,
                    coordinates: argument.coordinates.iter().map(&mut one).collect::<Result<_, _>>()?,
                    repeated: argument.repeated.as_ref().map(&mut one).transpose()?,
                    span: argument.span,
                });
            }
            evaluated.push(parser.evaluate_arguments(&bound)?);
        }
        polar_value(shape, &evaluated, self.slip).map_err(at(span))
    }
}

/// The value of a name, as work that is counted: a short text may ask for a long value many times.
fn copied(parser: &mut Parser<'_>, value: &Quantity, span: Span) -> Outcome {
    parser.budget.spend(value.size(), span)?;
    Ok(value.clone())
}

/// An entry of a list, a net or a point, which stands at a place.
fn nth(value: Quantity, place: usize, span: Span, number: &Expression) -> Outcome {
    let items = match value {
        Quantity::List(items) => items,
        Quantity::Point(point) => point.coordinates.into_iter().map(Quantity::Number).collect(),
        Quantity::Net(net) => match net.list() {
            Quantity::List(items) => items,
            other => vec![other],
        },
        other => return Err(SyntaxError::new(span, format!("found {}, expected a list, a net or a point", other.kind()))),
    };
    let length = items.len();
    items.into_iter().nth(place).ok_or_else(|| no_entry(place, length, number))
}

fn no_entry(place: usize, length: usize, number: &Expression) -> SyntaxError {
    let message = match length {
        0 => format!("found the entry {place} of an empty list"),
        _ => format!("found the entry {place}, expected one from 0 to {}", length - 1),
    };
    SyntaxError::new(number.span, message)
}

/// A whole number from 0 to a million.
pub(super) fn count_of(value: &Polynomial) -> Option<usize> {
    let number = value.as_rational().filter(|number| number.is_integer())?;
    number.numer().to_usize().filter(|count| *count <= 1_000_000)
}

/// A point that may be homogeneous.
fn seen(values: Quantity, weighted: bool, keep_weight: bool) -> Result<Quantity, Error> {
    if !weighted {
        return Ok(values);
    }
    let coordinates = match values {
        Quantity::Point(point) => point.coordinates,
        Quantity::Number(value) => vec![value],
        other => return Ok(other),
    };
    Ok(match Quantity::homogeneous(&coordinates)? {
        Quantity::Point(point) if !keep_weight => Quantity::point(point.coordinates),
        other => other,
    })
}

/// The point of a map or net at a parameter, or at two.
pub(super) fn value_at(shape: &Quantity, place: &[Polynomial], slip: Option<Slip>) -> Result<Quantity, Error> {
    let shape = slip.map_or_else(|| Ok(Cow::Borrowed(shape)), |slip| slip.on_shape(shape))?;
    let expected = match shape.as_ref() {
        Quantity::Map(map) => map.variables.len(),
        Quantity::Net(Net { piece: Piece::Curve(_), .. }) => 1,
        _ => 2,
    };
    if place.len() != expected {
        return Err(Error::WrongCount { what: "parameters", expected, found: place.len() });
    }
    let (weighted, reply) = match (shape.as_ref(), place) {
        (Quantity::Map(map), [t]) => {
            let request = Request::new("curve.eval", Domain::Curve).with("curve", Value::Curve(map.curve()?));
            (map.weight.is_some(), request.with("t", Value::Number(t.clone())).reply()?)
        }
        (Quantity::Map(map), place) => {
            let request = Request::new("triangle.eval", Domain::Triangle).with("surface", Value::Surface(map.surface(true)?));
            (map.weight.is_some(), request.with("a", Value::Point(place.to_vec())).reply()?)
        }
        (Quantity::Net(net), [t]) => {
            let operation = if net.weighted { "rational.curve" } else { "curve.eval" };
            (false, Request::new(operation, Domain::Curve).with_net(net)?.with("t", Value::Number(t.clone())).reply()?)
        }
        (Quantity::Net(net), [u, v]) => {
            let is_triangle = matches!(net.piece, Piece::Triangle(_));
            let (domain, operation) = match (is_triangle, net.weighted) {
                (true, false) => (Domain::Triangle, "triangle.eval"),
                (true, true) => (Domain::Triangle, "rational.triangle"),
                (false, false) => (Domain::Rectangle, "rectangle.eval"),
                (false, true) => (Domain::Rectangle, "rational.rectangle"),
            };
            let request = Request::new(operation, domain).with_net(net)?;
            let request = if is_triangle {
                request.with("a", Value::Point(vec![u.clone(), v.clone()]))
            } else {
                request.with("u", Value::Number(u.clone())).with("v", Value::Number(v.clone()))
            };
            (false, request.reply()?)
        }
        (other, _) => return Err(Error::WrongShape(format!("found {}, expected a map or a net", other.kind()))),
    };
    seen(reply.take("point")?, weighted, false)
}

/// Distinct letters as the arguments of a polar form, if they are just that.
fn plain_letters(groups: &[Vec<ArgumentInput>]) -> Option<Vec<Symbol>> {
    let mut letters = Vec::new();
    for argument in groups.iter().flatten() {
        for coordinate in &argument.coordinates {
            let mut terms = coordinate.terms();
            let (monomial, number) = terms.next()?;
            let is_letter = num_traits::One::is_one(number) && terms.next().is_none() && !argument.is_homogeneous;
            match (is_letter, monomial.factors()) {
                (true, [(symbol, 1)]) if !letters.contains(symbol) => letters.push(*symbol),
                _ => return None,
            }
        }
    }
    Some(letters)
}

/// The polar value of a map or net.
pub(super) fn polar_value(shape: &Quantity, groups: &[Vec<ArgumentInput>], slip: Option<Slip>) -> Result<Quantity, Error> {
    if let Some(slip) = slip {
        return slip.polar_value(shape, groups);
    }
    let map = match shape {
        Quantity::Map(map) => Cow::Borrowed(map),
        Quantity::Net(net) => Cow::Owned(net.map()?),
        other => return Err(Error::WrongShape(format!("found {}, expected a map or a net", other.kind()))),
    };
    let weighted = map.weight.is_some();
    // Letters for all arguments: the polar form itself.
    if let Some(value) = plain_letters(groups).map(|letters| polar_form(&map, groups, &letters)).transpose()?.flatten() {
        return seen(Quantity::point(value), weighted, true);
    }
    let line = |group: &[ArgumentInput]| -> Result<Value<Polynomial>, Error> {
        let arguments = group.iter().map(|argument| match argument.coordinates.as_slice() {
            [t] => Ok(Parameter::homogeneous(argument.weight.clone(), t.clone())),
            _ => Err(Error::WrongShape("found a point of the plane, expected a parameter of the line".into())),
        });
        Ok(Value::Arguments(arguments.collect::<Result<_, _>>()?))
    };
    let request = match (map.variables.len(), groups) {
        (1, [group]) => {
            Request::new("curve.blossom_homogeneous", Domain::Curve).with("curve", Value::Curve(map.curve()?)).with("args", line(group)?)
        }
        (1, _) => return Err(Error::WrongShape("a semicolon separates the two groups of a surface; a curve has one group".into())),
        (_, [group]) => {
            let arguments = group.iter().map(|argument| match argument.coordinates.as_slice() {
                [u, v] => Ok(PlaneParameter::homogeneous(argument.weight.clone(), u.clone(), v.clone())),
                _ => Err(Error::WrongShape(
                    "found a number, expected a point of the plane; a semicolon separates the arguments of a bidegree form".into(),
                )),
            });
            let arguments = Value::PlaneArguments(arguments.collect::<Result<_, _>>()?);
            Request::new("triangle.blossom_homogeneous", Domain::Triangle)
                .with("surface", Value::Surface(map.surface(true)?))
                .with("args", arguments)
        }
        (_, [us, vs]) => Request::new("rectangle.blossom_homogeneous", Domain::Rectangle)
            .with("surface", Value::Surface(map.surface(false)?))
            .with("us", line(us)?)
            .with("vs", line(vs)?),
        _ => return Err(Error::WrongShape("a polar form has one group of arguments or two".into())),
    };
    seen(request.reply()?.take("value")?, weighted, true)
}

/// The most terms of a polar form that is written out.
pub(super) const MAX_POLAR_TERMS: usize = 200_000;

/// The polar form with letters for its arguments; `None` if their number is wrong.
fn polar_form(map: &Map, groups: &[Vec<ArgumentInput>], letters: &[Symbol]) -> Result<Option<Vec<Polynomial>>, Error> {
    let counts: Vec<usize> = groups.iter().map(Vec::len).collect();
    let coordinates = groups.iter().flatten().next().map_or(1, |argument| argument.coordinates.len());
    let form = match (map.variables.len(), counts.as_slice(), coordinates) {
        (1, [_], 1) => map.curve()?.polar(),
        (2, [_], 2) => map.surface(true)?.polar(),
        (2, [_, _], 1) => map.surface(false)?.polar(),
        _ => return Ok(None),
    };
    let expected: Vec<usize> = form.reading().groups().iter().map(|group| group.0).collect();
    if expected != counts {
        return Ok(None);
    }
    let names: Vec<Symbol> = form.reading().symbols().collect();
    // A letter of the map's parameters might be one of the form's.
    let foreign = map.homogeneous().flat_map(Polynomial::symbols).any(|symbol| names.contains(&symbol) && !map.variables.contains(&symbol));
    if foreign {
        return Ok(None);
    }
    let renaming: Vec<(Symbol, Symbol)> = names.into_iter().zip(letters.iter().copied()).filter(|(from, to)| from != to).collect();
    let expanded = (0..form.dimension()).map(|coordinate| {
        let polynomial = form.expand(coordinate, MAX_POLAR_TERMS)?;
        Ok(if renaming.is_empty() { polynomial } else { polynomial.renamed(&renaming) })
    });
    expanded.collect::<Result<Vec<_>, Error>>().map(Some)
}
