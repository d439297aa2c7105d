//! Operations on rational pieces.

use super::rectangle::place;
use crate::error::Error;
use crate::kernel::coefficient::Coefficient;
use crate::value::{Answer, Arguments, Domain, Value};
use crate::weights::projected;

/// The point of a rational curve or patch: homogeneous first, divided last.
pub(super) fn eval<C: Coefficient>(arguments: &Arguments<C>) -> Result<Answer<C>, Error> {
    if !arguments.is_weighted() {
        return Err(Error::WrongShape("`weights` is missing: one for every control point, or `weight` for an equation".into()));
    }
    let homogeneous = match (arguments.domain(), arguments.get("points")) {
        (Domain::Curve, Some(_)) => arguments.segment()?.value(arguments.number("t")?)?,
        (Domain::Curve, None) => arguments.curve()?.value(arguments.number("t")?),
        (Domain::Triangle, Some(_)) => arguments.triangular()?.value(&arguments.parameter_point("a")?)?,
        (Domain::Triangle, None) => arguments.surface()?.value(&arguments.parameter_point("a")?),
        (Domain::Rectangle, Some(_)) => arguments.rectangular()?.value(&place(arguments)?)?,
        (Domain::Rectangle, None) => arguments.surface()?.value(&place(arguments)?),
    };
    if let Some(weight) = homogeneous.last().filter(|weight| weight.as_rational().is_none()) {
        return Err(Error::Unsupported(format!("dividing by the weight {weight} needs a number: give the symbols in it values")));
    }
    let point = projected(&homogeneous).map_or(Value::Nothing, Value::Point);
    Ok(Answer::new(vec![("homogeneous", Value::Point(homogeneous)), ("point", point)]))
}
