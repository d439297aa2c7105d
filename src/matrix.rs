//! The doors to `nalgebra`: control points and coefficients as matrices and points.

use nalgebra::{DMatrix, Point};

use crate::affine::Interval;
use crate::blossom::binomials;
use crate::curve::Curve;
use crate::error::Error;
use crate::exact::Rational;
use crate::segment::Segment;

/// The control points as columns, one row a coordinate.
impl From<&Segment> for DMatrix<Rational> {
    fn from(segment: &Segment) -> Self {
        Self::from_column_slice(segment.dimension(), segment.degree() + 1, segment.coordinates())
    }
}

/// The vectors `F_0, …, F_m` as columns, one row a coordinate.
impl From<&Curve> for DMatrix<Rational> {
    fn from(curve: &Curve) -> Self {
        Self::from_fn(curve.dimension(), curve.degree() + 1, |row, power| curve.vector(power)[row].clone())
    }
}

/// The curve whose coefficient vectors `F_0, …, F_m` are the columns.
impl TryFrom<&DMatrix<Rational>> for Curve {
    type Error = Error;

    fn try_from(matrix: &DMatrix<Rational>) -> Result<Self, Error> {
        Self::new(matrix.row_iter().map(|row| row.iter().cloned().collect()).collect())
    }
}

/// The matrix `M` of the Bernstein polynomials over `0..1` in powers of `t`: row
/// `i` holds the coefficients of `B_i`, so that `B(t) = M (1, t, …, t^m)ᵀ`, and a
/// patch `B(u)ᵀ P B(v)` has the coefficients `Mᵀ P M` (MA323, day 25, section 1).
///
/// ```
/// use casteljau::{Rational, bernstein_matrix};
/// let expected = [1, -2, 1, 0, 2, -2, 0, 0, 1].map(Rational::from);
/// assert_eq!(bernstein_matrix(2), nalgebra::DMatrix::from_row_slice(3, 3, &expected));
/// ```
#[must_use]
pub fn bernstein_matrix(degree: usize) -> DMatrix<Rational> {
    let rows: Vec<Vec<Rational>> = (0..=degree).map(binomials).collect();
    DMatrix::from_fn(degree + 1, degree + 1, |i, k| match k.checked_sub(i) {
        // B_i = C(m,i) t^i (1-t)^{m-i}, and C(m,i) C(m-i,k-i) = C(m,k) C(k,i).
        Some(gap) => &rows[degree][k] * &rows[k][i] * Rational::from(if gap % 2 == 0 { 1 } else { -1 }),
        None => Rational::from(0),
    })
}

impl Segment {
    /// The segment whose control points are the columns of a matrix.
    ///
    /// ```
    /// use casteljau::{Interval, Rational, Segment};
    /// use nalgebra::DMatrix;
    /// let columns = DMatrix::from_column_slice(2, 3, &[0, 0, 1, 2, 2, 0].map(Rational::from));
    /// let segment = Segment::from_matrix(&columns, Interval::unit())?;
    /// assert_eq!(segment.point(1), [Rational::from(1), Rational::from(2)]);
    /// assert_eq!(DMatrix::from(&segment), columns);
    /// # Ok::<(), casteljau::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`Error::WrongShape`] for a matrix without rows or columns.
    pub fn from_matrix(matrix: &DMatrix<Rational>, frame: Interval) -> Result<Self, Error> {
        Self::new(matrix.nrows(), matrix.as_slice().to_vec(), frame)
    }

    /// The segment with these control points.
    ///
    /// # Errors
    /// [`Error::WrongShape`] if there is none.
    pub fn from_nalgebra<const D: usize>(points: &[Point<Rational, D>], frame: Interval) -> Result<Self, Error> {
        Self::new(D, points.iter().flat_map(|point| point.coords.iter().cloned()).collect(), frame)
    }

    /// The control points in a space whose dimension is known.
    ///
    /// ```
    /// use casteljau::{Interval, Rational, Segment};
    /// use nalgebra::Point2;
    /// let points = [Point2::new(Rational::from(0), Rational::new(1, 3)), Point2::new(Rational::from(2), Rational::from(5))];
    /// let segment = Segment::from_nalgebra(&points, Interval::unit())?;
    /// assert_eq!(segment.to_nalgebra::<2>()?, points);
    /// # Ok::<(), casteljau::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`Error::WrongCount`] if the points have another number of coordinates.
    pub fn to_nalgebra<const D: usize>(&self) -> Result<Vec<Point<Rational, D>>, Error> {
        if self.dimension() != D {
            return Err(Error::WrongCount { what: "coordinates", expected: D, found: self.dimension() });
        }
        Ok(self.points().map(|point| Point::from(nalgebra::SVector::from_fn(|row, _| point[row].clone()))).collect())
    }
}
