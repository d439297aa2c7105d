//! Polylines that stay within a bound of a curve.

use num_traits::{Signed, Zero};

use crate::error::Error;
use crate::exact::Rational;
use crate::segment::Segment;

/// A polyline near a segment, and how near.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Flattening {
    /// The rounds of splitting in the middle; the polyline has `2^depth` edges.
    pub depth: usize,
    /// For each coordinate, what the polyline is at most away from the curve
    /// at the same parameter.
    pub bound: Vec<Rational>,
    /// The points of the curve at the dyadic parameters of that depth.
    pub polyline: Vec<Vec<Rational>>,
}

impl Segment {
    /// For each coordinate, a bound of the distance between the curve and its
    /// chord at the same part of the frame: `m (m-1)/8` times the largest
    /// second difference of the control points.
    ///
    /// (The second derivative is at most `m (m-1)` times that, and linear
    /// interpolation is off by at most an eighth of the second derivative;
    /// Farin, *Curves and Surfaces for CAGD*.)
    #[must_use]
    pub fn flatness(&self) -> Vec<Rational> {
        let degree = self.degree() as i64;
        let factor = Rational::new(degree * (degree - 1), 8);
        (0..self.dimension())
            .map(|coordinate| {
                let values: Vec<&Rational> = self.points().map(|point| &point[coordinate]).collect();
                let differences = values.windows(3).map(|w| (w[2] - w[1] - (w[1] - w[0])).abs());
                differences.max().unwrap_or_else(Rational::zero) * &factor
            })
            .collect()
    }

    /// The polyline of as few rounds of splitting in the middle as bring the
    /// bound of [`Segment::flatness`] to `tolerance` in every coordinate: each
    /// round divides it by four.
    ///
    /// # Errors
    /// [`Error::WrongShape`] unless the tolerance is positive;
    /// [`Error::TooLarge`] if more rounds than [`Segment::MAX_DEPTH`] would be needed.
    pub fn flatten(&self, tolerance: &Rational) -> Result<Flattening, Error> {
        if !tolerance.is_positive() {
            return Err(Error::WrongShape(format!("a flatness bound must be positive, found {tolerance}")));
        }
        let mut bound = self.flatness();
        let mut depth = 0;
        while bound.iter().any(|distance| distance > tolerance) {
            depth += 1;
            bound.iter_mut().for_each(|distance| *distance *= Rational::new(1, 4));
            if depth > Self::MAX_DEPTH {
                return Err(Error::TooLarge { what: "depth of subdivision", limit: Self::MAX_DEPTH });
            }
        }
        Ok(Flattening { depth, bound, polyline: self.polyline(depth)? })
    }
}
