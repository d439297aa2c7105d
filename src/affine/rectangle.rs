//! Pairs of frames of the parameter line.

use std::fmt;

use super::{Interval, Place};
use crate::exact::Rational;
use crate::kernel::coefficient::Coefficient;

/// The frames `(r1, s1)` and `(r2, s2)` of the two parameters of a rectangle.
///
/// ```
/// use casteljau::{Interval, Rational, Rectangle};
/// let frame = Rectangle::new(Interval::unit(), Interval::new(Rational::from(-1), Rational::from(2))?);
/// assert_eq!(frame.to_string(), "0..1, -1..2");
/// # Ok::<(), casteljau::Error>(())
/// ```
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Rectangle<C = Rational> {
    u: Interval<C>,
    v: Interval<C>,
}

impl<C: Coefficient> Rectangle<C> {
    /// The rectangle over these two frames.
    #[must_use]
    pub fn new(u: Interval<C>, v: Interval<C>) -> Self {
        Self { u, v }
    }

    /// The unit square.
    #[must_use]
    pub fn unit() -> Self {
        Self { u: Interval::unit(), v: Interval::unit() }
    }

    /// The same frames with their vertices brought into another ring.
    pub(crate) fn map<D: Coefficient, E>(&self, number: &mut impl FnMut(&C) -> Result<D, E>) -> Result<Rectangle<D>, E> {
        Ok(Rectangle { u: self.u.map(number)?, v: self.v.map(number)? })
    }

    /// The frame of the first parameter.
    #[must_use]
    pub fn u(&self) -> &Interval<C> {
        &self.u
    }

    /// The frame of the second parameter.
    #[must_use]
    pub fn v(&self) -> &Interval<C> {
        &self.v
    }
}

impl Rectangle {
    /// Where a point of the parameter plane lies.
    #[must_use]
    pub fn place(&self, [u, v]: &[Rational; 2]) -> Place {
        if !self.u.contains(u) || !self.v.contains(v) {
            return Place::Outside;
        }
        let on_end = |frame: &Interval, t: &Rational| t == frame.r() || t == frame.s();
        match (on_end(&self.u, u), on_end(&self.v, v)) {
            (true, true) => Place::Vertex,
            (false, false) => Place::Inside,
            _ => Place::Edge,
        }
    }
}

impl<C: fmt::Display> fmt::Display for Rectangle<C> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}, {}", self.u, self.v)
    }
}
