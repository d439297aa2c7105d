//! Pieces of every kind: curves, triangles and rectangles over their frames.

use crate::affine::{AffineMap, Frame};
use crate::control::ControlNet;
use crate::curve::Curve;
use crate::error::Error;
use crate::exact::Rational;
use crate::kernel::coefficient::Coefficient;
use crate::rectangular::RectangularPatch;
use crate::segment::Segment;
use crate::surface::Surface;
use crate::triangular::TriangularPatch;

/// A piece of a curve or surface, given by control points over a frame.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Piece<C = Rational> {
    /// A segment of a curve.
    Curve(Segment<C>),
    /// A triangular patch.
    Triangle(TriangularPatch<C>),
    /// A rectangular patch.
    Rectangle(RectangularPatch<C>),
}

/// The equation of a piece.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Equation<C = Rational> {
    /// Of a curve.
    Curve(Curve<C>),
    /// Of a surface.
    Surface(Surface<C>),
}

impl<C: Coefficient> Piece<C> {
    pub(crate) fn net(&self) -> &ControlNet<C> {
        match self {
            Self::Curve(segment) => segment.net(),
            Self::Triangle(patch) => patch.net(),
            Self::Rectangle(patch) => patch.net(),
        }
    }

    /// The number of coordinates.
    #[must_use]
    pub fn dimension(&self) -> usize {
        self.net().dimension()
    }

    /// The control points in order.
    pub fn points(&self) -> impl DoubleEndedIterator<Item = &[C]> + ExactSizeIterator + Clone {
        self.net().points()
    }

    /// The coordinates of all control points, point by point.
    #[must_use]
    pub fn coordinates(&self) -> &[C] {
        &self.net().coordinates
    }

    /// A piece of the same kind and degree over the same frame with other control points, in order.
    ///
    /// # Errors
    /// [`Error::WrongCount`] unless there are as many; [`Error::WrongShape`] if
    /// they are not all of one dimension.
    pub fn with_points(&self, points: Vec<Vec<C>>) -> Result<Self, Error> {
        if points.len() != self.points().len() {
            return Err(Error::WrongCount { what: "control points", expected: self.points().len(), found: points.len() });
        }
        Ok(match self {
            Self::Curve(segment) => Self::Curve(Segment::from_points(points, segment.frame().clone())?),
            Self::Triangle(patch) => Self::Triangle(TriangularPatch::from_points(points, patch.frame().clone())?),
            Self::Rectangle(patch) => Self::Rectangle(RectangularPatch::from_points(patch.degree(), points, patch.frame().clone())?),
        })
    }

    /// The control points row by row; those of a curve are one row.
    #[must_use]
    pub fn rows(&self) -> Vec<Vec<&[C]>> {
        match self {
            Self::Curve(segment) => vec![segment.points().collect()],
            Self::Triangle(patch) => patch.rows().map(Iterator::collect).collect(),
            Self::Rectangle(patch) => patch.rows().map(Iterator::collect).collect(),
        }
    }

    /// The polar labels of the control points in order.
    #[must_use]
    pub fn labels(&self) -> Vec<String> {
        match self {
            Self::Curve(segment) => (0..=segment.degree()).map(|i| segment.label(i)).collect(),
            Self::Triangle(patch) => TriangularPatch::<C>::indices(patch.degree()).into_iter().map(|[i, j, _]| patch.label(i, j)).collect(),
            Self::Rectangle(patch) => {
                let (p, q) = patch.degree();
                (0..=p).flat_map(|i| (0..=q).map(move |j| (i, j))).map(|(i, j)| patch.label(i, j)).collect()
            }
        }
    }

    /// The frame.
    #[must_use]
    pub fn frame(&self) -> Frame<C> {
        match self {
            Self::Curve(segment) => segment.frame().clone().into(),
            Self::Triangle(patch) => patch.frame().clone().into(),
            Self::Rectangle(patch) => patch.frame().clone().into(),
        }
    }

    /// The equation.
    ///
    /// # Errors
    /// [`Error::Unsupported`] if the size of the frame is symbolic.
    pub fn equation(&self) -> Result<Equation<C>, Error> {
        Ok(match self {
            Self::Curve(segment) => Equation::Curve(segment.curve()?),
            Self::Triangle(patch) => Equation::Surface(patch.surface()?),
            Self::Rectangle(patch) => Equation::Surface(patch.surface()?),
        })
    }

    /// The image under an affine map.
    ///
    /// # Errors
    /// [`Error::WrongCount`] if the map takes points of another dimension.
    pub fn transform(&self, map: &AffineMap<C>) -> Result<Self, Error> {
        Ok(match self {
            Self::Curve(segment) => Self::Curve(segment.transform(map)?),
            Self::Triangle(patch) => Self::Triangle(patch.transform(map)?),
            Self::Rectangle(patch) => Self::Rectangle(patch.transform(map)?),
        })
    }

    /// The product with another piece of the same kind over the same frame.
    ///
    /// # Errors
    /// [`Error::WrongShape`] if the kinds or frames differ, or the dimensions do and neither is 1.
    pub fn product(&self, other: &Self) -> Result<Self, Error> {
        Ok(match (self, other) {
            (Self::Curve(a), Self::Curve(b)) => Self::Curve(a.product(b)?),
            (Self::Triangle(a), Self::Triangle(b)) => Self::Triangle(a.product(b)?),
            (Self::Rectangle(a), Self::Rectangle(b)) => Self::Rectangle(a.product(b)?),
            _ => return Err(Error::WrongShape("a product needs two pieces of the same kind".into())),
        })
    }
}

impl<C: Coefficient> Equation<C> {
    /// Whether two equations are the same polynomial map, whatever their
    /// degrees and however they are read.
    #[must_use]
    pub fn same_map(&self, other: &Self) -> bool {
        match (self, other) {
            (Self::Curve(a), Self::Curve(b)) => a.same_map(b),
            (Self::Surface(a), Self::Surface(b)) => a.same_map(b),
            _ => false,
        }
    }
}
