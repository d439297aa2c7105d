//! The triangular scheme of de Casteljau's algorithm.

use crate::affine::{Interval, Parameter};
use crate::error::Error;
use crate::exact::Rational;
use crate::kernel::coefficient::Coefficient;
use crate::kernel::shape::Factor;
use crate::segment::Segment;

/// All polar values `b_{i,j} = f(t^j r^{m-i-j} s^i)` of a segment at one
/// parameter, `0 ≤ j ≤ m`, `0 ≤ i ≤ m - j`.
///
/// Layer 0 holds the control points, layer `m` the point `F(t)`. The first
/// points of the layers are the control points over `(r, t)`, the last ones
/// those over `(t, s)` in reverse (Gallier, *Curves and Surfaces in Geometric
/// Modeling*, section 18.2; CS348a, lecture 6, figure 8).
///
/// ```
/// use casteljau::{Interval, Rational, Segment};
/// let points = [0, 4, 8].map(|x| vec![Rational::from(x)]).to_vec();
/// let scheme = Segment::from_points(points, Interval::unit())?.scheme(&Rational::new(1, 4))?;
/// assert_eq!(scheme.label(1, 1), "f(s,t)");
/// assert_eq!(scheme.get(1, 1), [Rational::from(5)]);
/// assert_eq!(scheme.point(), [Rational::from(2)]);
/// # Ok::<(), casteljau::Error>(())
/// ```
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Scheme<C = Rational> {
    degree: usize,
    dimension: usize,
    frame: Interval<C>,
    parameter: C,
    coordinates: Vec<C>,
}

impl<C: Coefficient> Scheme<C> {
    pub(crate) fn of(segment: &Segment<C>, t: &C) -> Result<Self, Error> {
        let (degree, dimension) = (segment.degree(), segment.dimension());
        // The scheme of a line is a triangle with vertices r, t, s.
        let coordinates = segment.net().scheme(0, &segment.frame().weights(&[Parameter::from(t.clone())])?).coordinates;
        Ok(Self { degree, dimension, frame: segment.frame().clone(), parameter: t.clone(), coordinates })
    }

    /// The polar degree `m`.
    #[must_use]
    pub fn degree(&self) -> usize {
        self.degree
    }

    /// The frame of the control points.
    #[must_use]
    pub fn frame(&self) -> &Interval<C> {
        &self.frame
    }

    /// The parameter `t`.
    #[must_use]
    pub fn parameter(&self) -> &C {
        &self.parameter
    }

    /// The point `b_{i,j}`: step `j`, position `i`.
    ///
    /// # Panics
    /// If `i + j` is larger than the polar degree.
    #[must_use]
    pub fn get(&self, i: usize, j: usize) -> &[C] {
        remaining(self.degree, [i, j]);
        let index = Factor { dimension: 2, degree: self.degree }.index(&[j, i]);
        &self.coordinates[index * self.dimension..(index + 1) * self.dimension]
    }

    /// The points of step `j`: for `1 ≤ j < m` the shell that the next step
    /// cuts the corners of.
    ///
    /// # Panics
    /// If `j` is larger than the polar degree.
    pub fn layer(&self, j: usize) -> impl DoubleEndedIterator<Item = &[C]> + ExactSizeIterator {
        let count = remaining(self.degree, [j]) + 1;
        let start = Factor { dimension: 2, degree: self.degree }.index(&[j, 0]) * self.dimension;
        self.coordinates[start..start + count * self.dimension].chunks_exact(self.dimension)
    }

    /// The steps in order.
    pub fn layers(&self) -> impl Iterator<Item = impl DoubleEndedIterator<Item = &[C]> + ExactSizeIterator> {
        (0..=self.degree).map(|j| self.layer(j))
    }

    /// The point `F(t)`.
    #[must_use]
    pub fn point(&self) -> &[C] {
        self.get(0, self.degree)
    }

    /// The control points over `(r, t)`; where `t = r` they are one point repeated.
    pub fn left(&self) -> impl ExactSizeIterator<Item = &[C]> {
        (0..self.degree + 1).map(|j| self.get(0, j))
    }

    /// The control points over `(t, s)`; where `t = s` they are one point repeated.
    pub fn right(&self) -> impl ExactSizeIterator<Item = &[C]> {
        (0..self.degree + 1).map(|i| self.get(i, self.degree - i))
    }

    /// The polar label of `b_{i,j}`, such as `f(r,t,s)`: arguments in the order r, s, t.
    ///
    /// # Panics
    /// If `i + j` is larger than the polar degree.
    #[must_use]
    pub fn label(&self, i: usize, j: usize) -> String {
        polar_label(&[("r", remaining(self.degree, [i, j])), ("s", i), ("t", j)])
    }
}

impl Scheme {
    /// Whether every point is a convex combination of its neighbours: `t` lies
    /// in the closed frame, and the shells are nested.
    #[must_use]
    pub fn is_inside(&self) -> bool {
        self.frame.contains(&self.parameter)
    }
}

/// What some exponents leave of a degree.
///
/// # Panics
/// If they add up to more.
#[track_caller]
pub(crate) fn remaining<const N: usize>(degree: usize, exponents: [usize; N]) -> usize {
    let rest = exponents.iter().try_fold(degree, |rest, &exponent| rest.checked_sub(exponent));
    rest.unwrap_or_else(|| panic!("the degree is {degree}: no point has the exponents {exponents:?}"))
}

/// The label of a polar value whose arguments are repeated letters.
#[must_use]
pub fn polar_label(arguments: &[(&str, usize)]) -> String {
    let letters: Vec<&str> = arguments.iter().flat_map(|&(letter, count)| std::iter::repeat_n(letter, count)).collect();
    if letters.len() <= 12 {
        return format!("f({})", letters.join(","));
    }
    let powers: Vec<String> =
        arguments.iter().filter(|&&(_, count)| count > 0).map(|&(letter, count)| format!("{letter}^{count}")).collect();
    format!("f({})", powers.join(" "))
}
