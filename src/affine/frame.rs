//! Frames of every kind.

use std::fmt;

use super::{Interval, Rectangle, Triangle};
use crate::exact::Rational;
use crate::kernel::coefficient::Coefficient;

/// A frame of the parameter line or plane.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Frame<C = Rational> {
    /// `r..s`, for curves.
    Interval(Interval<C>),
    /// Three vertices, for triangular patches.
    Triangle(Triangle<C>),
    /// Two intervals, for rectangular patches.
    Rectangle(Rectangle<C>),
}

impl<C: Coefficient> Frame<C> {
    /// The same frame with its vertices brought into another ring.
    pub(crate) fn map<D: Coefficient, E>(&self, number: &mut impl FnMut(&C) -> Result<D, E>) -> Result<Frame<D>, E> {
        Ok(match self {
            Self::Interval(frame) => Frame::Interval(frame.map(number)?),
            Self::Triangle(frame) => Frame::Triangle(frame.map(number)?),
            Self::Rectangle(frame) => Frame::Rectangle(frame.map(number)?),
        })
    }

    /// The numbers of its vertices.
    #[must_use]
    pub fn numbers(&self) -> Vec<&C> {
        match self {
            Self::Interval(frame) => vec![frame.r(), frame.s()],
            Self::Triangle(frame) => frame.vertices().iter().flatten().collect(),
            Self::Rectangle(frame) => vec![frame.u().r(), frame.u().s(), frame.v().r(), frame.v().s()],
        }
    }
}

impl<C: fmt::Display> fmt::Display for Frame<C> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Interval(frame) => frame.fmt(f),
            Self::Triangle(frame) => frame.fmt(f),
            Self::Rectangle(frame) => frame.fmt(f),
        }
    }
}

impl<C> From<Interval<C>> for Frame<C> {
    fn from(frame: Interval<C>) -> Self {
        Self::Interval(frame)
    }
}

impl<C> From<Triangle<C>> for Frame<C> {
    fn from(frame: Triangle<C>) -> Self {
        Self::Triangle(frame)
    }
}

impl<C> From<Rectangle<C>> for Frame<C> {
    fn from(frame: Rectangle<C>) -> Self {
        Self::Rectangle(frame)
    }
}
