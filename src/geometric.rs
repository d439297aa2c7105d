//! Geometric continuity of curves, up to order 3.

use num_traits::{Signed, Zero};

use crate::affine::Interval;
use crate::curve::Curve;
use crate::error::Error;
use crate::exact::Rational;
use crate::name::display_by_name;
use crate::segment::Segment;
use crate::side::Side;

/// How two curves join geometrically: with parameters of their own.
///
/// Order `k` means that after a change of one parameter all derivatives up to
/// order `k` agree: `G' = β1 F'`, `G'' = β1² F'' + β2 F'`,
/// `G''' = β1³ F''' + 3 β1 β2 F'' + β3 F'` with `β1 > 0` (Farin, *Curves and
/// Surfaces for CAGD*, geometric continuity).
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct GeometricJoin {
    /// Whether both curves have a tangent vector at the joint.
    pub regular: bool,
    /// The highest order found, at most 3; none if the points differ. It stops
    /// at 0 where a curve is not regular.
    pub order: Option<usize>,
    /// The shape parameters `β1`, `β2`, … that were found.
    pub betas: Vec<Rational>,
    /// Whether the tangents are opposite.
    pub reversed: bool,
    /// What is known where a curve has no tangent vector at the joint and the points agree.
    pub singular: Option<SingularJoint>,
}

/// A joint where a derivative vanishes: the tangent is that of the first one which does not.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct SingularJoint {
    /// The order of the first derivative of each curve that is not zero; none for a point.
    pub orders: [Option<usize>; 2],
    /// How the direction in which the first curve arrives lies to that in which
    /// the second one leaves; none where one of them is a point.
    pub directions: Option<Directions>,
}

/// How two directions lie to each other.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Directions {
    /// The same.
    Same,
    /// Opposite: the curves form a cusp.
    Opposite,
    /// On different lines.
    Different,
}

impl Directions {
    /// The name: "same", "opposite", "different".
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Same => "same",
            Self::Opposite => "opposite",
            Self::Different => "different",
        }
    }
}

display_by_name!(Directions);

/// The number `β` with `vector = β base`, if there is one; `base` is not zero.
fn ratio(vector: &[Rational], base: &[Rational]) -> Option<Rational> {
    let (x, b) = vector.iter().zip(base).find(|(_, b)| !b.is_zero())?;
    let beta = x / b;
    vector.iter().zip(base).all(|(x, b)| *x == b * &beta).then_some(beta)
}

/// How two curves join geometrically at parameters of their own.
///
/// ```
/// use casteljau::{Curve, Rational, geometric_join};
/// let q = |n| Rational::from(n);
/// let line = Curve::new(vec![vec![q(0), q(1)], vec![q(0), q(1)]])?;
/// let faster = Curve::new(vec![vec![q(1), q(2)], vec![q(1), q(2)]])?;
/// let join = geometric_join(&line, &faster, &q(1), &q(0))?;
/// assert_eq!((join.order, join.betas), (Some(3), vec![q(2), q(0), q(0)]));
/// # Ok::<(), casteljau::Error>(())
/// ```
///
/// # Errors
/// [`Error::WrongCount`] if they have different dimensions.
pub fn geometric_join(f: &Curve, g: &Curve, at_f: &Rational, at_g: &Rational) -> Result<GeometricJoin, Error> {
    alike(f, g)?;
    Ok(join_of_derivatives(&derivatives(f, at_f), &derivatives(g, at_g)))
}

/// The same for rational curves, given by homogeneous maps whose last coordinate is the weight.
///
/// # Errors
/// As for [`geometric_join`]; [`Error::Unsupported`] if a weight is 0 at the joint.
pub fn geometric_join_of_rational(f: &Curve, g: &Curve, at_f: &Rational, at_g: &Rational) -> Result<GeometricJoin, Error> {
    alike(f, g)?;
    Ok(join_of_derivatives(&cartesian(&derivatives(f, at_f))?, &cartesian(&derivatives(g, at_g))?))
}

/// How two curves join geometrically where an end of the one is an end of the
/// other, whatever their parameters: run through towards the end of the first
/// and from the end of the second. With `rational` the last coordinate is the weight.
///
/// # Errors
/// As for [`geometric_join_of_rational`]; [`Error::WrongShape`] for sides of patches.
pub fn geometric_join_of_ends(first: (&Segment, Side), second: (&Segment, Side), rational: bool) -> Result<GeometricJoin, Error> {
    let at = |(segment, side): (&Segment, Side), backwards: Side| -> Result<Vec<Vec<Rational>>, Error> {
        // In the unit parameter of its control points.
        let curve = Segment::new(segment.dimension(), segment.coordinates().to_vec(), Interval::unit())?.curve()?;
        let end = match side {
            Side::Start => Rational::from(0),
            Side::End => Rational::from(1),
            other => return Err(Error::WrongShape(format!("a curve has no edge `{other}`; there are start, end"))),
        };
        let mut list = derivatives(&curve, &end);
        if rational {
            list = cartesian(&list)?;
        }
        if side == backwards {
            list.iter_mut().skip(1).step_by(2).for_each(|vector| vector.iter_mut().for_each(|x| *x = -&*x));
        }
        Ok(list)
    };
    if first.0.dimension() != second.0.dimension() {
        return Err(Error::WrongCount { what: "coordinates", expected: first.0.dimension(), found: second.0.dimension() });
    }
    Ok(join_of_derivatives(&at(first, Side::Start)?, &at(second, Side::End)?))
}

fn alike(f: &Curve, g: &Curve) -> Result<(), Error> {
    if f.dimension() == g.dimension() {
        return Ok(());
    }
    Err(Error::WrongCount { what: "coordinates", expected: f.dimension(), found: g.dimension() })
}

/// The derivatives of the orders 0 to 3, and on to the degree.
fn derivatives(curve: &Curve, at: &Rational) -> Vec<Vec<Rational>> {
    (0..=curve.degree().max(3)).map(|order| curve.derivative(order).value(at)).collect()
}

/// The derivatives of a rational curve from those of its homogeneous map: by
/// Leibniz's rule for the product of the curve and its weight.
fn cartesian(homogeneous: &[Vec<Rational>]) -> Result<Vec<Vec<Rational>>, Error> {
    let infinite = || Error::Unsupported("a weight is 0 at the joint: the point there is at infinity".into());
    let weights: Vec<&Rational> = homogeneous.iter().filter_map(|vector| vector.last()).collect();
    let unit = weights.first().and_then(|weight| weight.recip()).ok_or_else(infinite)?;
    let mut found: Vec<Vec<Rational>> = Vec::new();
    for (order, vector) in homogeneous.iter().enumerate() {
        let mut rest = vector[..vector.len() - 1].to_vec();
        let mut binomial = Rational::from(1);
        for k in 1..=order {
            binomial = binomial * Rational::from(order + 1 - k) / Rational::from(k);
            let factor = &binomial * weights[k];
            rest.iter_mut().zip(&found[order - k]).for_each(|(x, y)| *x -= y * &factor);
        }
        rest.iter_mut().for_each(|x| *x *= &unit);
        found.push(rest);
    }
    Ok(found)
}

/// What is known where one of the first derivatives vanishes.
fn singular_joint(f: &[Vec<Rational>], g: &[Vec<Rational>]) -> SingularJoint {
    let first = |list: &[Vec<Rational>]| (1..list.len()).find(|&order| !list[order].iter().all(Zero::is_zero));
    let orders = [first(f), first(g)];
    let directions = match orders {
        [Some(own), Some(other)] => Some(match ratio(&g[other], &f[own]) {
            None => Directions::Different,
            // Where its order is even, the first curve arrives against the direction of its derivative.
            Some(factor) if factor.is_positive() == (own % 2 == 1) => Directions::Same,
            Some(_) => Directions::Opposite,
        }),
        _ => None,
    };
    SingularJoint { orders, directions }
}

fn join_of_derivatives(f: &[Vec<Rational>], g: &[Vec<Rational>]) -> GeometricJoin {
    let vanishes = |vector: &[Rational]| vector.iter().all(Zero::is_zero);
    let regular = !vanishes(&f[1]) && !vanishes(&g[1]);
    let mut join = GeometricJoin { regular, order: (f[0] == g[0]).then_some(0), betas: Vec::new(), reversed: false, singular: None };
    if join.order.is_none() || !regular {
        join.singular = join.order.map(|_| singular_joint(f, g));
        return join;
    }
    let Some(first) = ratio(&g[1], &f[1]) else { return join };
    if first.is_negative() {
        join.reversed = true;
        return join;
    }
    join.order = Some(1);
    join.betas.push(first.clone());
    // What is left of a derivative must be along the tangent.
    let rest = |order: usize, known: &[(&Rational, usize)]| -> Vec<Rational> {
        (0..f[0].len()).map(|axis| known.iter().fold(g[order][axis].clone(), |rest, (factor, k)| rest - &f[*k][axis] * *factor)).collect()
    };
    let square = first.pow(2);
    let Some(second) = ratio(&rest(2, &[(&square, 2)]), &f[1]) else { return join };
    join.order = Some(2);
    join.betas.push(second.clone());
    let (cube, mixed) = (first.pow(3), Rational::from(3) * &first * &second);
    if let Some(third) = ratio(&rest(3, &[(&cube, 3), (&mixed, 2)]), &f[1]) {
        join.order = Some(3);
        join.betas.push(third);
    }
    join
}
