//! Operations on curves, for numbers and for symbolic parameters alike.

use crate::blossom::{PolarDefect, check_polar_form};
use crate::error::Error;
use crate::kernel::coefficient::Coefficient;
use crate::piece::Piece;
use crate::reading::Reading;
use crate::value::{Answer, Arguments, Value};

use super::piece;

type Outcome<C> = Result<Answer<C>, Error>;

pub(super) fn polar<C: Coefficient>(arguments: &Arguments<C>) -> Outcome<C> {
    let curve = arguments.curve()?;
    let mut fields = vec![("maps", Value::Polar(curve.polar()))];
    if let Ok(frame) = arguments.frame("frame") {
        fields.push(("points", Value::Net(Piece::Curve(curve.segment(frame)?))));
    }
    Ok(Answer::new(fields))
}

pub(super) fn blossom<C: Coefficient>(arguments: &Arguments<C>) -> Outcome<C> {
    Ok(Answer::new(vec![("value", Value::Point(arguments.curve()?.blossom(arguments.numbers("args")?)?))]))
}

pub(super) fn blossom_homogeneous<C: Coefficient>(arguments: &Arguments<C>) -> Outcome<C> {
    let value = arguments.curve()?.blossom_homogeneous(arguments.polar_arguments("args")?)?;
    Ok(Answer::new(vec![("value", Value::Point(value))]))
}

pub(super) fn check<C: Coefficient>(arguments: &Arguments<C>) -> Outcome<C> {
    let (curve, variable) = (arguments.curve()?, arguments.variable());
    let reading = Reading::Curve(curve.degree());
    let defects = check_polar_form(reading, &curve.polynomials(variable), &[variable], arguments.expressions("claim")?)?;
    Ok(checked(reading, defects))
}

/// The answer to the question whether a claimed polar form is one.
pub(super) fn checked<C: Coefficient>(reading: Reading, defects: Vec<PolarDefect>) -> Answer<C> {
    let holds = defects.is_empty();
    Answer::new(vec![("holds", Value::Truth(holds)), ("defects", Value::Defects(reading, defects))]).that_holds(holds)
}

pub(super) fn eval<C: Coefficient>(arguments: &Arguments<C>) -> Outcome<C> {
    let t = arguments.number("t")?;
    let point = match arguments.get("points") {
        Some(_) => arguments.segment()?.value(t)?,
        None => arguments.curve()?.value(t),
    };
    Ok(Answer::new(vec![("point", Value::Point(point))]))
}

pub(super) fn casteljau<C: Coefficient>(arguments: &Arguments<C>) -> Outcome<C> {
    let scheme = arguments.segment()?.scheme(arguments.number("t")?)?;
    let list = |points: Vec<&[C]>| Value::Points(points.into_iter().map(<[C]>::to_vec).collect());
    let (point, left, right) = (scheme.point().to_vec(), list(scheme.left().collect()), list(scheme.right().collect()));
    let fields = vec![("layers", Value::Scheme(scheme)), ("point", Value::Point(point)), ("left", left), ("right", right)];
    Ok(Answer::new(fields).weighted(arguments.is_weighted()))
}

pub(super) fn split<C: Coefficient>(arguments: &Arguments<C>) -> Outcome<C> {
    let (left, right) = arguments.segment()?.split(arguments.number("t")?)?;
    let fields = vec![("left", Value::Piece(Piece::Curve(left))), ("right", Value::Piece(Piece::Curve(right)))];
    Ok(Answer::new(fields).weighted(arguments.is_weighted()))
}

pub(super) fn subdivide<C: Coefficient>(arguments: &Arguments<C>) -> Outcome<C> {
    if !arguments.flag("polyline") {
        return piece::pieces(arguments);
    }
    let polyline = arguments.segment()?.polyline(arguments.count("depth").copied().unwrap_or(1))?;
    Ok(Answer::new(vec![("polyline", Value::Points(polyline))]))
}

pub(super) fn reduce<C: Coefficient>(arguments: &Arguments<C>) -> Outcome<C> {
    let reduction = arguments.segment()?.reduce()?;
    Ok(Answer::new(vec![
        ("true_degree", Value::Count(reduction.true_degree)),
        ("zero", Value::Truth(reduction.zero)),
        ("points", Value::Net(Piece::Curve(reduction.segment))),
    ])
    .weighted(arguments.is_weighted()))
}

pub(super) fn derivative<C: Coefficient>(arguments: &Arguments<C>) -> Outcome<C> {
    let derivative = arguments.curve()?.derivative(arguments.count("order").copied().unwrap_or(1));
    Ok(Answer::new(vec![match arguments.number("t") {
        Ok(t) => ("value", Value::Point(derivative.value(t))),
        Err(_) => ("derivative", Value::Curve(derivative)),
    }]))
}
