//! The arguments of one operation, by name.

use super::Value;
use crate::affine::{AffineMap, Interval, Parameter};
use crate::curve::Curve;
use crate::error::Error;
use crate::exact::Rational;
use crate::kernel::coefficient::Coefficient;
use crate::segment::Segment;
use crate::symbolic::{Polynomial, Symbol};

/// The arguments of one operation. The adaptor that filled them has seen to it
/// that required ones are there and that each has the kind its row asks for.
#[derive(Clone, Debug, PartialEq)]
pub struct Arguments<C = Rational> {
    values: Vec<(&'static str, Value<C>)>,
}

impl<C> Default for Arguments<C> {
    fn default() -> Self {
        Self { values: Vec::new() }
    }
}

fn missing(name: &str) -> Error {
    Error::WrongShape(format!("`{name}` is missing"))
}

macro_rules! getters {
    ($($(#[$doc:meta])* $method:ident: $variant:ident -> $type:ty;)*) => {$(
        $(#[$doc])*
        ///
        /// # Errors
        /// [`Error::WrongShape`] if it is missing.
        pub fn $method(&self, name: &str) -> Result<&$type, Error> {
            match self.get(name) {
                Some(Value::$variant(value)) => Ok(value),
                _ => Err(missing(name)),
            }
        }
    )*};
}

impl<C: Coefficient> Arguments<C> {
    /// Adds an argument.
    pub fn insert(&mut self, name: &'static str, value: Value<C>) {
        self.values.push((name, value));
    }

    /// The argument with this name.
    #[must_use]
    pub fn get(&self, name: &str) -> Option<&Value<C>> {
        self.values.iter().find(|(key, _)| *key == name).map(|(_, value)| value)
    }

    /// All arguments, in the order they were given.
    pub fn iter(&self) -> impl Iterator<Item = (&'static str, &Value<C>)> {
        self.values.iter().map(|(name, value)| (*name, value))
    }

    getters! {
        /// A number.
        number: Number -> C;
        /// A list of numbers.
        numbers: Numbers -> Vec<C>;
        /// A point.
        point: Point -> Vec<C>;
        /// A frame.
        frame: Frame -> Interval<C>;
        /// Polar arguments.
        polar_arguments: Arguments -> Vec<Parameter<C>>;
        /// A count.
        count: Count -> usize;
        /// An affine map.
        map: Map -> AffineMap<C>;
        /// Polynomials in named variables.
        expressions: Expressions -> Vec<Polynomial>;
    }

    /// Whether a flag is set.
    #[must_use]
    pub fn flag(&self, name: &str) -> bool {
        matches!(self.get(name), Some(Value::Truth(true)))
    }

    /// The letter of the curve's parameter, `t` unless another was chosen.
    #[must_use]
    pub fn variable(&self) -> Symbol {
        match self.get("variable") {
            Some(Value::Variable(symbol)) => *symbol,
            _ => Symbol::new('t', None),
        }
    }

    /// The frame if one was given, else `0..1`.
    #[must_use]
    pub fn frame_or_unit(&self, name: &str) -> Interval<C> {
        self.frame(name).cloned().unwrap_or_else(|_| Interval::unit())
    }

    /// The curve, by its equation or by its control points.
    ///
    /// # Errors
    /// [`Error::WrongShape`] if there is neither, and what making it of control points says.
    pub fn curve(&self) -> Result<Curve<C>, Error> {
        match (self.get("curve"), self.get("points")) {
            (Some(Value::Curve(curve)), None) => self.raised(curve.clone()),
            (None, Some(Value::Points(_))) => self.segment()?.curve(),
            _ => Err(missing("curve")),
        }
    }

    /// The segment over `frame`, by control points or by an equation.
    ///
    /// # Errors
    /// [`Error::WrongShape`] if there is neither, and what making it says.
    pub fn segment(&self) -> Result<Segment<C>, Error> {
        self.segment_of("curve", "points", "frame")
    }

    /// The second segment of an operation on two.
    ///
    /// # Errors
    /// As for [`Arguments::segment`].
    pub fn other_segment(&self) -> Result<Segment<C>, Error> {
        self.segment_of("other_curve", "other_points", "other_frame")
    }

    fn segment_of(&self, curve: &str, points: &str, frame: &str) -> Result<Segment<C>, Error> {
        // The second of two shapes is over the frame of the first unless it says otherwise.
        let frame = self.frame(frame).cloned().unwrap_or_else(|_| self.frame_or_unit("frame"));
        match (self.get(curve), self.get(points)) {
            (Some(Value::Curve(curve)), None) => self.raised(curve.clone())?.segment(&frame),
            (None, Some(Value::Points(points))) => Segment::from_points(points.clone(), frame),
            _ => Err(missing(points)),
        }
    }

    fn raised(&self, curve: Curve<C>) -> Result<Curve<C>, Error> {
        match self.get("degree") {
            Some(Value::Count(degree)) => curve.with_degree(*degree),
            _ => Ok(curve),
        }
    }
}

impl Arguments<Polynomial> {
    /// The same arguments as numbers, or the name of a symbolic parameter and
    /// of the argument that contains it.
    ///
    /// # Errors
    /// The symbol and the name of the argument.
    pub fn numeric(&self) -> Result<Arguments<Rational>, (Symbol, &'static str)> {
        let mut numeric = Arguments::default();
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
        Value::Word(word) => Value::Word(word),
        Value::Variable(symbol) => Value::Variable(*symbol),
        Value::Expressions(expressions) => Value::Expressions(expressions.clone()),
        Value::Document(text) => Value::Document(text.clone()),
        Value::Number(value) => Value::Number(number(value)?),
        Value::Numbers(values) => Value::Numbers(list(values)?),
        Value::Point(values) => Value::Point(list(values)?),
        Value::Points(points) => Value::Points(points.iter().map(|point| list(point)).collect::<Result<_, E>>()?),
        Value::Frame(frame) => Value::Frame(frame.map(number)?),
        Value::Arguments(arguments) => Value::Arguments(
            arguments
                .iter()
                .map(|argument| Ok(Parameter::homogeneous(number(&argument.w)?, number(&argument.t)?)))
                .collect::<Result<_, E>>()?,
        ),
        Value::Curve(curve) => Value::Curve(curve.map(number)?),
        Value::Map(map) => Value::Map(map.map(number)?),
        // Only answers hold these.
        Value::Net(_)
        | Value::Piece(_)
        | Value::Pieces(_)
        | Value::Polar(_)
        | Value::Scheme(_)
        | Value::Defects(_)
        | Value::List(_)
        | Value::Record(_)
        | Value::Nothing => Value::Nothing,
    })
}
