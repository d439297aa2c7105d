//! Rational pieces: control points with weights.
//!
//! A rational curve or patch is the central projection of a polynomial one
//! whose last coordinate is the weight: the point `b` with weight `w` is
//! `(w b, w)`. Everything is computed there; only points are divided, at the
//! end (Farin, *Curves and Surfaces for CAGD*, rational curves; Gallier,
//! *Curves and Surfaces in Geometric Modeling*, section 19.4).

use crate::error::Error;
use crate::kernel::coefficient::Coefficient;

/// The homogeneous points `(w b, w)` of control points and their weights.
///
/// ```
/// use casteljau::{Interval, Rational, Segment, homogeneous_points, projected};
/// // The quarter circle: (1,0), (1,1), (0,1) with weights 1, 1, 2.
/// let points = [[1, 0], [1, 1], [0, 1]].map(|point| point.map(Rational::from).to_vec()).to_vec();
/// let weights = [1, 1, 2].map(Rational::from);
/// let arc = Segment::from_points(homogeneous_points(&points, &weights)?, Interval::unit())?;
/// let point = projected(&arc.value(&Rational::new(1, 2))?);
/// assert_eq!(point, Some(vec![Rational::new(3, 5), Rational::new(4, 5)]));
/// # Ok::<(), casteljau::Error>(())
/// ```
///
/// # Errors
/// [`Error::WrongCount`] unless there is a weight for every point.
pub fn homogeneous_points<C: Coefficient>(points: &[Vec<C>], weights: &[C]) -> Result<Vec<Vec<C>>, Error> {
    if points.len() != weights.len() {
        return Err(Error::WrongCount { what: "weights", expected: points.len(), found: weights.len() });
    }
    let lifted = |(point, weight): (&Vec<C>, &C)| point.iter().map(|x| x.times(weight)).chain([weight.clone()]).collect();
    Ok(points.iter().zip(weights).map(lifted).collect())
}

/// The point that a homogeneous point `(w x, …, w)` stands for; none if it is
/// at infinity (weight 0), or its weight is symbolic.
#[must_use]
pub fn projected<C: Coefficient>(homogeneous: &[C]) -> Option<Vec<C>> {
    let (weight, rest) = homogeneous.split_last()?;
    rest.iter().map(|x| x.over(weight)).collect()
}
