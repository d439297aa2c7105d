//! Parametric continuity of two maps along a joint, exactly.
//!
//! Two polynomial maps agree in all derivatives up to order `k` at a point of
//! the line, or along a line of the plane, if and only if their difference is
//! divisible by the power `k + 1` of the linear form that vanishes there. So the
//! order is found, not tried (CS348a, lecture 12, section 5, lists the conditions
//! one by one; Ramshaw, *Blossoming*, 1987).

use std::fmt;

use crate::affine::{AffineMap, Interval, PlaneParameter, Triangle, Weights};
use crate::control::{Data, change_frame};
use crate::curve::Curve;
use crate::error::Error;
use crate::exact::Rational;
use crate::reading::Reading;
use crate::surface::Surface;
use crate::weights::projected;

/// The highest order of continuity.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Continuity {
    /// The maps differ on the joint.
    Broken,
    /// All derivatives up to this order agree, and one of the next order does not.
    C(usize),
    /// The same polynomial map.
    Same,
}

impl Continuity {
    /// The order of a difference whose first vectors of coefficients vanish.
    fn of_difference(first: Option<usize>) -> Self {
        match first {
            None => Self::Same,
            Some(0) => Self::Broken,
            Some(power) => Self::C(power - 1),
        }
    }
}

impl fmt::Display for Continuity {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Broken => f.write_str("not even C0"),
            Self::C(order) => write!(f, "C{order}"),
            Self::Same => f.write_str("the same polynomial map"),
        }
    }
}

fn alike(a: usize, b: usize) -> Result<(), Error> {
    if a == b { Ok(()) } else { Err(Error::WrongCount { what: "coordinates", expected: a, found: b }) }
}

/// How smoothly two curves join where both have this parameter.
///
/// ```
/// use casteljau::{Continuity, Curve, Rational, continuity_of_curves};
/// let q = |n| Rational::from(n);
/// let parabola = Curve::new(vec![vec![q(0), q(1)], vec![q(0), q(0), q(1)]])?;
/// let line = Curve::new(vec![vec![q(0), q(1)], vec![q(-1), q(2)]])?;
/// assert_eq!(continuity_of_curves(&parabola, &line, &q(1))?, Continuity::C(1));
/// # Ok::<(), casteljau::Error>(())
/// ```
///
/// # Errors
/// [`Error::WrongCount`] if they have different dimensions.
pub fn continuity_of_curves(a: &Curve, b: &Curve, at: &Rational) -> Result<Continuity, Error> {
    alike(a.dimension(), b.dimension())?;
    let degree = a.degree().max(b.degree());
    let (a, b) = (a.clone().with_degree(degree)?, b.clone().with_degree(degree)?);
    let difference: Vec<Rational> =
        (0..=degree).flat_map(|power| a.vector(power).iter().zip(b.vector(power)).map(|(x, y)| x - y)).collect();
    // The difference in powers of the distance from the joint.
    let shape = Reading::Curve(degree).shape(a.dimension());
    let mut vertices = Weights::default();
    vertices.push_numbers(std::iter::once(at));
    vertices.push_pair(&Rational::from(0), &Rational::from(1));
    let moved = change_frame(&shape, (Data::Equation, &difference), &[vertices], Data::Equation)?;
    let first = moved.chunks_exact(a.dimension()).position(|vector| vector.iter().any(|c| *c != Rational::from(0)));
    Ok(Continuity::of_difference(first))
}

/// How smoothly two surfaces join along the line of the parameter plane through
/// two points, whatever kinds of patches they come from.
///
/// # Errors
/// [`Error::WrongCount`] if they have different dimensions;
/// [`Error::DegenerateFrame`] if the two points are one.
pub fn continuity_of_surfaces(a: &Surface, b: &Surface, [from, to]: &[[Rational; 2]; 2]) -> Result<Continuity, Error> {
    alike(a.dimension(), b.dimension())?;
    let along = [&to[0] - &from[0], &to[1] - &from[1]];
    if along.iter().all(|part| *part == Rational::from(0)) {
        return Err(Error::DegenerateFrame("the two ends of the common edge are one point".into()));
    }
    let (a, b) = (a.by_total_degree()?, b.by_total_degree()?);
    let degree = [&a, &b].map(|surface| surface.reading().groups()[0].0).into_iter().max().unwrap_or(0);
    let (a, b) = (a.read_as(Reading::Total(degree))?, b.read_as(Reading::Total(degree))?);
    let difference: Vec<Rational> = a.coefficients().iter().zip(b.coefficients()).map(|(x, y)| x - y).collect();
    // In coordinates along the joint and across it, by the smallest power of the second.
    let across = [-along[1].clone(), along[0].clone()];
    let vertices = [PlaneParameter::point(from.clone()), PlaneParameter::vector(along), PlaneParameter::vector(across)];
    let vertices = PlaneParameter::weights(&vertices);
    let reading = Reading::Total(degree);
    let shape = reading.shape(a.dimension());
    let moved = change_frame(&shape, (Data::Equation, &difference), &[vertices], Data::Equation)?;
    let vectors = moved.chunks_exact(a.dimension()).zip(reading.exponents());
    let powers = vectors.filter(|(vector, _)| vector.iter().any(|c| *c != Rational::from(0))).map(|(_, exponents)| exponents[2]);
    Ok(Continuity::of_difference(powers.min()))
}

/// How smoothly two rational maps join: in homogeneous space, there up to a
/// factor, and in the space that they are maps into.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct RationalContinuity {
    /// Of the Cartesian maps.
    pub cartesian: Continuity,
    /// Of the homogeneous maps as they are.
    pub homogeneous: Continuity,
    /// Of the homogeneous maps, the second one multiplied by `scale`.
    pub scaled: Continuity,
    /// The weight of the first over that of the second at the joint (for
    /// surfaces at its first point).
    pub scale: Rational,
}

/// The map without its weight, and the weight.
fn parts(dimension: usize) -> Result<(AffineMap, AffineMap), Error> {
    let row = |axis: usize| (0..dimension).map(|column| Rational::from(i64::from(column == axis))).collect::<Vec<_>>();
    let zeros = |count: usize| vec![Rational::from(0); count];
    let points = AffineMap::new((0..dimension - 1).map(row).collect(), zeros(dimension - 1))?;
    Ok((points, AffineMap::new(vec![row(dimension - 1)], zeros(1))?))
}

fn scale_of(a: &[Rational], b: &[Rational]) -> Result<Rational, Error> {
    let weights = (a.last().cloned().unwrap_or_default(), b.last().cloned().unwrap_or_default());
    let finite = projected(a).is_some() && projected(b).is_some();
    match weights.0.checked_div(&weights.1).filter(|_| finite) {
        Some(scale) => Ok(scale),
        None => Err(Error::Unsupported("a weight is 0 at the joint: the point there is at infinity".into())),
    }
}

/// How smoothly two rational curves join, given by homogeneous maps whose last
/// coordinate is the weight. Cartesian continuity is that of `X_A W_B` and
/// `X_B W_A`.
///
/// # Errors
/// As for [`continuity_of_curves`]; [`Error::Unsupported`] if a weight is 0 at the joint.
pub fn continuity_of_rational_curves(a: &Curve, b: &Curve, at: &Rational) -> Result<RationalContinuity, Error> {
    alike(a.dimension(), b.dimension())?;
    let scale = scale_of(&a.value(at), &b.value(at))?;
    let (points, weight) = parts(a.dimension())?;
    let unit = Interval::unit();
    let product = |a: &Curve, b: &Curve| a.transform(&points)?.segment(&unit)?.product(&b.transform(&weight)?.segment(&unit)?)?.curve();
    let scaling = scaling(a.dimension(), &scale)?;
    Ok(RationalContinuity {
        cartesian: continuity_of_curves(&product(a, b)?, &product(b, a)?, at)?,
        homogeneous: continuity_of_curves(a, b, at)?,
        scaled: continuity_of_curves(a, &b.transform(&scaling)?, at)?,
        scale,
    })
}

/// How smoothly two rational surfaces join along a line; see
/// [`continuity_of_rational_curves`].
///
/// # Errors
/// As for [`continuity_of_surfaces`]; [`Error::Unsupported`] if a weight is 0 at the first point.
pub fn continuity_of_rational_surfaces(a: &Surface, b: &Surface, joint: &[[Rational; 2]; 2]) -> Result<RationalContinuity, Error> {
    alike(a.dimension(), b.dimension())?;
    let scale = scale_of(&a.value(&joint[0]), &b.value(&joint[0]))?;
    let (points, weight) = parts(a.dimension())?;
    let frame = Triangle::standard();
    let product = |a: &Surface, b: &Surface| {
        a.transform(&points)?.over_triangle(&frame)?.product(&b.transform(&weight)?.over_triangle(&frame)?)?.surface()
    };
    let scaling = scaling(a.dimension(), &scale)?;
    Ok(RationalContinuity {
        cartesian: continuity_of_surfaces(&product(a, b)?, &product(b, a)?, joint)?,
        homogeneous: continuity_of_surfaces(a, b, joint)?,
        scaled: continuity_of_surfaces(a, &b.transform(&scaling)?, joint)?,
        scale,
    })
}

/// The multiplication of all coordinates by a number.
fn scaling(dimension: usize, factor: &Rational) -> Result<AffineMap, Error> {
    let entry = |row: usize, column: usize| if row == column { factor.clone() } else { Rational::from(0) };
    AffineMap::new(
        (0..dimension).map(|row| (0..dimension).map(|column| entry(row, column)).collect()).collect(),
        vec![Rational::from(0); dimension],
    )
}
