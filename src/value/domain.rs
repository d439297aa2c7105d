//! Kinds of shapes.

use crate::affine::{Frame, Interval, Rectangle, Triangle};
use crate::kernel::coefficient::Coefficient;
use crate::name::display_by_name;

/// What kind of shape an operation is about.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Default)]
pub enum Domain {
    /// Curves, over intervals.
    #[default]
    Curve,
    /// Surfaces by their total degree, over triangles.
    Triangle,
    /// Surfaces by their bidegree, over rectangles.
    Rectangle,
}

impl Domain {
    /// What a shape of this kind is called.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Curve => "curve",
            Self::Triangle => "triangle",
            Self::Rectangle => "rectangle",
        }
    }

    /// The frame that is meant where none is given.
    #[must_use]
    pub fn default_frame<C: Coefficient>(self) -> Frame<C> {
        match self {
            Self::Curve => Interval::unit().into(),
            Self::Triangle => Triangle::standard().into(),
            Self::Rectangle => Rectangle::unit().into(),
        }
    }
}

display_by_name!(Domain);
