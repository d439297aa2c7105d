//! Frames of the parameter line.

use std::fmt;

use super::{Parameter, Weights};
use crate::error::Error;
use crate::exact::Rational;
use crate::kernel::coefficient::Coefficient;

/// A frame `(r, s)` of the parameter line, `r ≠ s`; `r > s` is allowed.
///
/// ```
/// use casteljau::{Interval, Rational};
/// let frame = Interval::new(Rational::from(-1), Rational::from(3))?;
/// assert_eq!(frame.to_string(), "-1..3");
/// assert!(frame.contains(&Rational::new(1, 2)));
/// assert!(Interval::new(Rational::from(2), Rational::from(2)).is_err());
/// # Ok::<(), casteljau::Error>(())
/// ```
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Interval<C = Rational> {
    r: C,
    s: C,
}

impl<C: Coefficient> Interval<C> {
    /// The frame with these ends.
    ///
    /// # Errors
    /// [`Error::DegenerateFrame`] if they are equal.
    pub fn new(r: C, s: C) -> Result<Self, Error> {
        if r == s {
            return Err(Error::DegenerateFrame(format!(
                "the frame {r}..{s} is degenerate: its ends must be different (either may be the larger)"
            )));
        }
        Ok(Self { r, s })
    }

    /// The frame `0..1`.
    #[must_use]
    pub fn unit() -> Self {
        Self { r: C::nothing(), s: C::unit() }
    }

    /// The same frame with its vertices brought into another ring.
    pub(crate) fn map<D: Coefficient, E>(&self, number: &mut impl FnMut(&C) -> Result<D, E>) -> Result<Interval<D>, E> {
        Ok(Interval { r: number(&self.r)?, s: number(&self.s)? })
    }

    /// The first vertex.
    #[must_use]
    pub fn r(&self) -> &C {
        &self.r
    }

    /// The second vertex.
    #[must_use]
    pub fn s(&self) -> &C {
        &self.s
    }

    /// The same frame with its vertices exchanged.
    #[must_use]
    pub fn reversed(&self) -> Self {
        Self { r: self.s.clone(), s: self.r.clone() }
    }

    /// The combination of the vertices with weights `1 - part` and `part`.
    #[must_use]
    pub fn at(&self, part: &C) -> C {
        self.r.plus(&self.s.minus(&self.r).times(part))
    }

    /// Arguments as combinations of the vertices.
    ///
    /// # Errors
    /// [`Error::Unsupported`] if the length of the frame is symbolic.
    pub(crate) fn weights(&self, arguments: &[Parameter<C>]) -> Result<Weights<C>, Error> {
        let length = self.s.minus(&self.r);
        let mut weights = Weights::default();
        for Parameter { t, w } in arguments {
            let Some(first) = w.times(&self.s).minus(t).over(&length) else {
                let message = format!("dividing by {length} needs a number: give the frame {}..{} numeric ends", self.r, self.s);
                return Err(Error::Unsupported(message));
            };
            weights.push_pair(&first, &w.minus(&first));
        }
        Ok(weights)
    }

    /// The vertices as arguments.
    pub(crate) fn ends(&self) -> [Parameter<C>; 2] {
        [&self.r, &self.s].map(|end| Parameter::from(end.clone()))
    }

    /// The vertices as integer points of the homogeneous line.
    #[inline]
    pub(crate) fn vertices(&self) -> Weights<C> {
        let mut vertices = Weights::default();
        self.push_vertices(&mut vertices);
        vertices
    }

    /// The same, in place: moving them would be felt on a cubic.
    #[inline]
    pub(crate) fn push_vertices(&self, vertices: &mut Weights<C>) {
        vertices.push_numbers([&self.r, &self.s].into_iter());
    }
}

impl Interval {
    /// Whether `t` lies between the vertices or on one of them.
    #[must_use]
    pub fn contains(&self, t: &Rational) -> bool {
        let (low, high) = if self.r < self.s { (&self.r, &self.s) } else { (&self.s, &self.r) };
        low <= t && t <= high
    }
}

impl<C: fmt::Display> fmt::Display for Interval<C> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}..{}", self.r, self.s)
    }
}
