//! What definitions make.

use super::evaluate::Evaluator;
use super::quantity::{Degrees, Map, Point, Quantity};
use super::scope::{Component, Scope};
use crate::symbolic::Symbol;
use crate::syntax::SyntaxError;
use crate::syntax::parser::Parser;
use crate::syntax::statement::MapDefinition;

/// What a definition makes.
pub(super) enum Made {
    Value(Quantity),
    Component(u32, Component),
}

/// The value of a definition.
pub(super) fn made(scope: &Scope, parser: &mut Parser<'_>, definition: &MapDefinition) -> Result<Made, SyntaxError> {
    let head = &definition.definition;
    let variables: Vec<Symbol> = head.arguments.iter().flatten().map(|entry| entry.0).collect();
    if let Some((symbol, span)) = head.arguments.iter().flatten().find(|(symbol, _)| scope.get(*symbol).is_some()) {
        let error = SyntaxError::new(*span, format!("found the variable `{symbol}`, which is a name already"));
        return Err(error.with_help("take another letter for the variable or for the name"));
    }
    let evaluator = Evaluator { scope, variables: &variables, defining: Some(head.name), slip: None };
    let value = evaluator.evaluate(parser, &head.body)?;
    if head.arguments.is_none() {
        if let Some(extra) = definition.degree.first().or(definition.weight.as_ref()) {
            let message = "found a degree or weight behind a definition without variables, expected one behind `F(t) = …`";
            return Err(SyntaxError::new(extra.span, message));
        }
        return Ok(Made::Value(value));
    }
    if variables.is_empty() || variables.len() > 2 {
        let message = format!("found {} variables, expected one of a curve or two of a surface", variables.len());
        return Err(SyntaxError::new(head.name_span, message));
    }
    let components = match value {
        Quantity::Number(value) => vec![value],
        Quantity::Point(Point { coordinates, weight: None }) => coordinates,
        Quantity::Map(map) if map.weight.is_none() => map.components,
        other => {
            let message = format!("found {} as the body of a map, expected a polynomial or a point of polynomials", other.kind());
            return Err(SyntaxError::new(head.body.span, message));
        }
    };
    let is_component = head.name.index().is_some_and(|index| index > 0)
        && components.len() == 1
        && head.name.letter().is_uppercase()
        && definition.degree.is_empty()
        && definition.weight.is_none();
    if is_component {
        if let Some(first) = scope.component(head.name.letter(), 1).filter(|first| first.variables != variables) {
            let list = |symbols: &[Symbol]| symbols.iter().map(Symbol::to_string).collect::<Vec<_>>().join(",");
            let message = format!("found a component in `{}`, expected one in `{}` as the first", list(&variables), list(&first.variables));
            return Err(SyntaxError::new(head.name_span, message));
        }
        let body = components.into_iter().next().unwrap_or_default();
        return Ok(Made::Component(head.name.index().unwrap_or(1), Component { body, variables, span: head.name_span }));
    }
    let weight = definition.weight.as_ref().map(|weight| evaluator.polynomial(parser, weight)).transpose()?;
    let degrees = definition.degree.iter().map(|degree| evaluator.count(parser, degree)).collect::<Result<Vec<usize>, _>>()?;
    let degrees = match (variables.len(), degrees.as_slice()) {
        (_, []) => Degrees::default(),
        (_, &[degree]) => Degrees { total: Some(degree), pair: None },
        (2, &[p, q]) => Degrees { total: None, pair: Some((p, q)) },
        _ => {
            let span = definition.degree[0].span;
            return Err(SyntaxError::new(span, "found two degrees of a curve, expected `degree` and one number"));
        }
    };
    let map = Map { components, variables, degrees, weight };
    let span = definition.degree.first().map_or(head.body.span, |degree| degree.span);
    // The degree that is asked for must do, and the map must be within the limits.
    map.own_degrees().map_err(super::evaluate::at(span))?;
    Ok(Made::Value(Quantity::Map(map)))
}
