//! The arguments of one operation, by name.

use super::{Domain, Value};
use crate::affine::{AffineMap, Frame, Interval, Parameter, PlaneParameter, Rectangle, Triangle};
use crate::error::Error;
use crate::exact::Rational;
use crate::kernel::coefficient::Coefficient;
use crate::symbolic::{Polynomial, Symbol};

/// The arguments of one operation. The adaptor that filled them has seen to it
/// that required ones are there and that each has the kind its row asks for.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Arguments<C = Rational> {
    pub(super) domain: Domain,
    pub(super) values: Vec<(&'static str, Value<C>)>,
}

pub(super) fn missing(name: &str) -> Error {
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
    /// No arguments yet, of an operation on a kind of shape.
    #[must_use]
    pub fn new(domain: Domain) -> Self {
        Self { domain, values: Vec::new() }
    }

    /// The kind of shape that the operation is about.
    #[must_use]
    pub fn domain(&self) -> Domain {
        self.domain
    }

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
        /// A frame of any kind.
        any_frame: Frame -> Frame<C>;
        /// Polar arguments on the line.
        polar_arguments: Arguments -> Vec<Parameter<C>>;
        /// Polar arguments in the plane.
        plane_arguments: PlaneArguments -> Vec<PlaneParameter<C>>;
        /// A count.
        count: Count -> usize;
        /// Several counts.
        counts: Counts -> Vec<usize>;
        /// A word.
        word: Word -> &'static str;
        /// An affine map.
        map: Map -> AffineMap<C>;
        /// Polynomials in named variables.
        expressions: Expressions -> Vec<Polynomial>;
    }

    /// A frame of the parameter line.
    ///
    /// # Errors
    /// [`Error::WrongShape`] if it is missing or of another kind.
    pub fn frame(&self, name: &str) -> Result<&Interval<C>, Error> {
        match self.get(name) {
            Some(Value::Frame(Frame::Interval(frame))) => Ok(frame),
            Some(Value::Frame(frame)) => Err(wrong_frame("an interval `r..s`", frame)),
            _ => Err(missing(name)),
        }
    }

    /// A triangle of the parameter plane.
    ///
    /// # Errors
    /// [`Error::WrongShape`] if it is missing or of another kind.
    pub fn triangle(&self, name: &str) -> Result<&Triangle<C>, Error> {
        match self.get(name) {
            Some(Value::Frame(Frame::Triangle(frame))) => Ok(frame),
            Some(Value::Frame(frame)) => Err(wrong_frame("a triangle `(1,0) (0,1) (0,0)`", frame)),
            _ => Err(missing(name)),
        }
    }

    /// A rectangle of the parameter plane.
    ///
    /// # Errors
    /// [`Error::WrongShape`] if it is missing or of another kind.
    pub fn rectangle(&self, name: &str) -> Result<&Rectangle<C>, Error> {
        match self.get(name) {
            Some(Value::Frame(Frame::Rectangle(frame))) => Ok(frame),
            Some(Value::Frame(frame)) => Err(wrong_frame("a rectangle `a..b, c..d`", frame)),
            _ => Err(missing(name)),
        }
    }

    /// A point of the parameter plane.
    ///
    /// # Errors
    /// [`Error::WrongShape`] if it is missing, [`Error::WrongCount`] unless it
    /// has two coordinates.
    pub fn parameter_point(&self, name: &str) -> Result<[C; 2], Error> {
        match self.point(name)?.as_slice() {
            [u, v] => Ok([u.clone(), v.clone()]),
            other => Err(Error::WrongCount { what: "parameters", expected: 2, found: other.len() }),
        }
    }

    /// Two counts.
    ///
    /// # Errors
    /// [`Error::WrongShape`] if they are missing, [`Error::WrongCount`] unless there are two.
    pub fn pair(&self, name: &str) -> Result<(usize, usize), Error> {
        match self.counts(name)?.as_slice() {
            &[first, second] => Ok((first, second)),
            other => Err(Error::WrongCount { what: "whole numbers", expected: 2, found: other.len() }),
        }
    }

    /// Whether a flag is set.
    #[must_use]
    pub fn flag(&self, name: &str) -> bool {
        matches!(self.get(name), Some(Value::Truth(true)))
    }

    /// The letter of the curve's parameter, `t` unless another was chosen.
    #[must_use]
    pub fn variable(&self) -> Symbol {
        match self.get("variables") {
            Some(Value::Variables(symbols)) if symbols.len() == 1 => symbols[0],
            _ => Symbol::new('t', None),
        }
    }

    /// The letters of a surface's parameters, `u` and `v` unless others were chosen.
    #[must_use]
    pub fn variables(&self) -> [Symbol; 2] {
        match self.get("variables") {
            Some(Value::Variables(symbols)) if symbols.len() == 2 => [symbols[0], symbols[1]],
            _ => [Symbol::new('u', None), Symbol::new('v', None)],
        }
    }

    /// The frame if one was given, else the usual one of the kind the operation is about.
    #[must_use]
    pub fn frame_or_default(&self, name: &str) -> Frame<C> {
        self.any_frame(name).cloned().unwrap_or_else(|_| self.domain.default_frame())
    }

    /// Whether the shape has weights, so that its last coordinate is the weight.
    #[must_use]
    pub fn is_weighted(&self) -> bool {
        self.get("weights").is_some() || self.get("weight").is_some()
    }
}

pub(super) fn wrong_frame<C: Coefficient>(expected: &str, found: &Frame<C>) -> Error {
    Error::WrongShape(format!("the frame {found} does not fit: expected {expected}"))
}
