//! Arguments without symbols.

use super::{Arguments, Value};
use crate::affine::{Parameter, PlaneParameter};
use crate::exact::Rational;
use crate::kernel::coefficient::Coefficient;
use crate::symbolic::{Polynomial, Symbol};

impl Arguments<Polynomial> {
    /// The same arguments as numbers, or the name of a symbolic parameter and
    /// of the argument that contains it.
    ///
    /// # Errors
    /// The symbol and the name of the argument.
    pub fn numeric(&self) -> Result<Arguments<Rational>, (Symbol, &'static str)> {
        let mut numeric = Arguments::new(self.domain);
        for (name, value) in &self.values {
            let converted =
                convert(value, &mut |number| number.as_rational().ok_or_else(|| number.symbols()[0])).map_err(|symbol| (symbol, *name))?;
            numeric.insert(name, converted);
        }
        Ok(numeric)
    }
}

/// Brings the numbers of an argument into another ring.
fn convert<A: Coefficient, B: Coefficient, E>(value: &Value<A>, number: &mut impl FnMut(&A) -> Result<B, E>) -> Result<Value<B>, E> {
    let mut list = |values: &[A]| values.iter().map(&mut *number).collect::<Result<Vec<B>, E>>();
    Ok(match value {
        Value::Truth(truth) => Value::Truth(*truth),
        Value::Count(count) => Value::Count(*count),
        Value::Integer(number) => Value::Integer(*number),
        Value::Counts(counts) => Value::Counts(counts.clone()),
        Value::Word(word) => Value::Word(word),
        Value::Variables(symbols) => Value::Variables(symbols.clone()),
        Value::Expressions(expressions) => Value::Expressions(expressions.clone()),
        Value::Document(text) => Value::Document(text.clone()),
        Value::Number(value) => Value::Number(number(value)?),
        Value::Numbers(values) => Value::Numbers(list(values)?),
        Value::Point(values) => Value::Point(list(values)?),
        Value::Points(points) => Value::Points(points.iter().map(|point| list(point)).collect::<Result<_, E>>()?),
        Value::Rows(rows) => {
            let mut row = |points: &Vec<Vec<A>>| points.iter().map(|point| list(point)).collect::<Result<_, E>>();
            Value::Rows(rows.iter().map(&mut row).collect::<Result<_, E>>()?)
        }
        Value::Frame(frame) => Value::Frame(frame.map(number)?),
        Value::Arguments(arguments) => Value::Arguments(
            arguments
                .iter()
                .map(|argument| Ok(Parameter::homogeneous(number(&argument.w)?, number(&argument.t)?)))
                .collect::<Result<_, E>>()?,
        ),
        Value::PlaneArguments(arguments) => Value::PlaneArguments(
            arguments
                .iter()
                .map(|argument| Ok(PlaneParameter::homogeneous(number(&argument.w)?, number(&argument.u)?, number(&argument.v)?)))
                .collect::<Result<_, E>>()?,
        ),
        Value::Curve(curve) => Value::Curve(curve.map(number)?),
        Value::Surface(surface) => Value::Surface(surface.map(number)?),
        Value::Map(map) => Value::Map(map.map(number)?),
        // Only answers hold these.
        Value::Matrix(_)
        | Value::Net(_)
        | Value::Piece(_)
        | Value::Pieces(_)
        | Value::Surd(_)
        | Value::Surds(_)
        | Value::Polar(_)
        | Value::HomogeneousPolar(_)
        | Value::Homogeneous(_)
        | Value::Scheme(_)
        | Value::Layers(_)
        | Value::Mesh(_)
        | Value::Defects(..)
        | Value::List(_)
        | Value::Record(_)
        | Value::Nothing => Value::Nothing,
    })
}
