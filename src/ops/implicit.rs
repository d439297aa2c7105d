//! Operations on implicit equations of curves.

use num_traits::Signed;

use crate::algebraic::AlgebraicNumber;
use crate::error::Error;
use crate::exact::Rational;
use crate::implicit::{ImplicitCurve, Parameters};
use crate::quadric::{QUADRIC_MONOMIALS, QuadricSurface};
use crate::value::{Answer, Arguments, Finding, ImplicitFinding, Value};

pub(super) fn implicit(arguments: &Arguments) -> Result<Answer, Error> {
    let curve = arguments.curve()?;
    let implicit = ImplicitCurve::of(&curve)?;
    let poly = implicit
        .terms()
        .iter()
        .map(|(i, j, c)| Value::List(vec![Value::Count(*i), Value::Count(*j), Value::Number(Rational::from(c.clone()))]));
    let mut fields =
        vec![("poly", Value::List(poly.collect())), ("degree", Value::Count(implicit.degree())), ("index", Value::Count(implicit.index()))];
    let conic = implicit.conic_type();
    let mut gauge = None;
    if let Ok(point) = arguments.point("at") {
        let value = implicit.gauge(&planar(point)?);
        let sign = if value.is_positive() {
            "positive"
        } else if value.is_negative() {
            "negative"
        } else {
            "zero"
        };
        fields.push(("gauge", Value::Record(vec![("value", Value::Number(value.clone())), ("sign", Value::Word(sign))])));
        gauge = Some((point.clone(), value));
    }
    let mut membership = None;
    let mut holds = None;
    if let Ok(point) = arguments.point("contains") {
        let zero = num_traits::Zero::is_zero(&implicit.gauge(&planar(point)?));
        let parameters = curve.parameters_of(point)?;
        fields.push(("contains", Value::Truth(parameters.exist())));
        fields.push(("equation_holds", Value::Truth(zero)));
        fields.push(("parameters", parameter_list(&parameters)));
        holds = Some(parameters.exist());
        membership = Some((point.clone(), parameters));
    }
    let frame = arguments.frame("frame").ok().cloned();
    let finding = ImplicitFinding { curve, implicit, conic, gauge, membership, frame };
    let answer = Answer::new(fields).with_finding(Finding::Implicit(Box::new(finding)));
    Ok(match holds {
        Some(holds) => answer.that_holds(holds),
        None => answer,
    })
}

/// The quadric that a surface lies in.
pub(super) fn quadric(arguments: &Arguments) -> Result<Answer, Error> {
    let found = QuadricSurface::of(&arguments.surface()?)?;
    let mut fields = vec![("affine_span_dim", Value::Count(found.affine_span)), ("quadric_space_dim", Value::Count(found.quadrics))];
    if let Some(coefficients) = &found.quadric {
        let present = QUADRIC_MONOMIALS.into_iter().zip(coefficients).filter(|(_, c)| !num_traits::Zero::is_zero(*c));
        let record = present.map(|(name, c)| (name, Value::Number(Rational::from(c.clone())))).collect();
        fields.push(("quadric", Value::Record(record)));
    }
    fields.push(("class", Value::Word(found.class.name())));
    Ok(Answer::new(fields).with_finding(Finding::Quadric(Box::new(found))))
}

fn planar(point: &[Rational]) -> Result<[Rational; 2], Error> {
    match point {
        [x, y] => Ok([x.clone(), y.clone()]),
        _ => Err(Error::WrongCount { what: "coordinates", expected: 2, found: point.len() }),
    }
}

fn parameter_list(parameters: &Parameters) -> Value {
    let Parameters::These(list) = parameters else { return Value::Word("all") };
    let entry = |number: &AlgebraicNumber| match number {
        AlgebraicNumber::Surd(surd) => Value::Surd(surd.clone()),
        AlgebraicNumber::Isolated(root) => {
            let (low, high) = root.interval();
            Value::Record(vec![
                ("polynomial", Value::Numbers(root.polynomial().iter().cloned().map(Rational::from).collect())),
                ("between", Value::Numbers(vec![low.clone(), high.clone()])),
            ])
        }
    };
    Value::List(list.iter().map(entry).collect())
}
