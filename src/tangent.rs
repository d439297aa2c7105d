//! Common tangent planes of two patches along an edge.

use num_traits::Zero;

use crate::affine::Interval;
use crate::error::Error;
use crate::exact::Rational;
use crate::exact::univariate::IntegerPolynomial;
use crate::piece::Piece;
use crate::quotient::{Quotient, coefficients};
use crate::roots::{RealRoots, RootPlace};
use crate::segment::Segment;
use crate::side::{Side, Strip};
use crate::symbolic::{Polynomial, Symbol};

/// How two patches join geometrically along a side of each, in whatever
/// parameters: tangent planes along the whole edge. A test that was not reached is none.
///
/// With `a` the derivative along the edge, `p` and `r` those into the first and
/// the second patch, the planes are the same where `r = -λ p + μ a`, and the
/// patches lie on opposite sides of the edge where `λ > 0` (Farin, *Curves and
/// Surfaces for CAGD*, geometric continuity of composite surfaces).
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct TangentPlaneJoin {
    /// Whether the edge curves are the same, run through in one direction or the other.
    pub same_edge: bool,
    /// Whether the side of the second patch runs along that of the first from
    /// its last to its first point.
    pub reversed: bool,
    /// Whether the edge is one point.
    pub collapsed: bool,
    /// Whether the edge's direction and the two directions into the patches are
    /// everywhere in one plane.
    pub coplanar: Option<bool>,
    /// Where on the closed edge, from 0 to 1, the normals of the first and the second patch vanish.
    pub singular: [Vanishing; 2],
    /// Whether the patches lie on opposite sides of the edge, not folded onto each other.
    pub opposite_sides: Option<bool>,
    /// `λ`, where the difference of control points across the side stands for
    /// the derivative, as a function of the edge's parameter from 0 to 1.
    pub ratio: Option<Quotient>,
    /// `μ` likewise.
    pub shear: Option<Quotient>,
}

/// Where something is zero on the closed edge.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Vanishing {
    /// At these parameters; none if the list is empty.
    At(Vec<RootPlace>),
    /// Everywhere.
    Everywhere,
}

impl Vanishing {
    /// Whether it is nowhere zero.
    #[must_use]
    pub fn is_nowhere(&self) -> bool {
        *self == Self::At(Vec::new())
    }
}

impl TangentPlaneJoin {
    /// Whether both normals are different from zero on the closed edge; none if that was not reached.
    #[must_use]
    pub fn regular(&self) -> Option<bool> {
        self.same_edge.then(|| self.singular.iter().all(Vanishing::is_nowhere))
    }

    /// Whether the patches have the same tangent planes along the edge; none
    /// where that is undecided because a normal vanishes.
    #[must_use]
    pub fn g1(&self) -> Option<bool> {
        match (self.coplanar, self.regular(), self.opposite_sides) {
            (Some(true), Some(false), side) if side != Some(false) => None,
            (Some(true), Some(true), Some(true)) => Some(true),
            _ => Some(false),
        }
    }

    /// Whether the patches have the same tangent planes along the edge, for certain.
    #[must_use]
    pub fn is_g1(&self) -> bool {
        self.g1() == Some(true)
    }
}

type Field = [Polynomial; 3];

fn cross(a: &Field, b: &Field) -> Field {
    let entry = |i: usize, j: usize| &(&a[i] * &b[j]) - &(&a[j] * &b[i]);
    [entry(1, 2), entry(2, 0), entry(0, 1)]
}

fn dot(a: &Field, b: &Field) -> Polynomial {
    a.iter().zip(b).fold(Polynomial::default(), |sum, (x, y)| sum + &(x * y))
}

fn scaled(a: &Field, factor: &Polynomial) -> Field {
    a.each_ref().map(|x| x * factor)
}

/// Where a polynomial is zero on the closed unit interval.
fn zeros(polynomial: &Polynomial, x: Symbol) -> Result<Vanishing, Error> {
    if polynomial.is_empty() {
        return Ok(Vanishing::Everywhere);
    }
    let coefficients = coefficients(polynomial, x);
    let (zero, one) = (Rational::from(0), Rational::from(1));
    let mut places = Vec::new();
    if coefficients[0].is_zero() {
        places.push(RootPlace::Exact(zero));
    }
    places.extend(RealRoots::inside(&coefficients, &Interval::unit())?.isolated().into_iter().map(|root| root.place));
    if coefficients.iter().sum::<Rational>().is_zero() {
        places.push(RootPlace::Exact(one));
    }
    Ok(Vanishing::At(places))
}

/// A patch along one of its sides, as polynomials in the side's parameter: the
/// points and the weight; the derivatives along the side and across it, times
/// the square of the weight.
struct Boundary {
    points: Field,
    weight: Polynomial,
    along: Field,
    across: Field,
}

impl Boundary {
    fn of(piece: &Piece, side: Side, reversed: bool, rational: bool, x: Symbol) -> Result<Self, Error> {
        let strip = Strip::of(piece, side, reversed);
        let points: Vec<&[Rational]> = piece.points().collect();
        let polynomials = |list: Vec<Vec<Rational>>| -> Result<Vec<Polynomial>, Error> {
            if list.is_empty() {
                return Ok(vec![Polynomial::default(); piece.dimension()]);
            }
            Ok(Segment::from_points(list, Interval::unit())?.curve()?.polynomials(x))
        };
        let mut on = polynomials(strip.along.iter().map(|&place| points[place].to_vec()).collect())?;
        let difference = |(&inner, &along): (&usize, &usize)| points[inner].iter().zip(points[along]).map(|(a, b)| a - b).collect();
        let mut off = polynomials(strip.inner.iter().zip(&strip.along).map(difference).collect())?;
        let one = Polynomial::from(Rational::from(1));
        let (weight, slope) =
            if rational { (on.pop().unwrap_or_default(), off.pop().unwrap_or_default()) } else { (one, Polynomial::default()) };
        let space = |_| Error::Unsupported("tangent planes need patches in space, with 3 coordinates".into());
        let (points, across) = (Field::try_from(on).map_err(space)?, Field::try_from(off).map_err(space)?);
        // The derivative of X/W is that of X times W without X times that of W, over W².
        let numerator = |derivative: &Field, slope: &Polynomial| -> Field {
            let rest = scaled(&points, slope);
            let main = scaled(derivative, &weight);
            std::array::from_fn(|axis| &main[axis] - &rest[axis])
        };
        let along = numerator(&points.each_ref().map(|point| derivative(point, x)), &derivative(&weight, x));
        let across = numerator(&across, &slope);
        if !zeros(&weight, x)?.is_nowhere() {
            return Err(Error::Unsupported("a weight is 0 on the common edge: the point there is at infinity".into()));
        }
        Ok(Self { points, weight, along, across })
    }

    fn same_points(&self, other: &Self) -> bool {
        scaled(&self.points, &other.weight) == scaled(&other.points, &self.weight)
    }
}

fn derivative(polynomial: &Polynomial, x: Symbol) -> Polynomial {
    let powers = polynomial.coefficients_in(x).into_iter().enumerate().skip(1);
    Polynomial::from_coefficients(x, &powers.map(|(power, c)| &c * &Polynomial::from(Rational::from(power))).collect::<Vec<_>>())
}

/// Whether two patches in space join with a common tangent plane along a side
/// of each, decided along the whole edge: `det(a, p, r)` vanishes identically,
/// neither normal `a × p`, `a × r` does anywhere, and they point away from each
/// other. The patches are triangles or rectangles of any degrees, with their
/// vertices in any order; where the edge is run through in opposite directions
/// that is found. With `rational` the last coordinate is the weight.
///
/// ```
/// use casteljau::{Piece, Rational, Rectangle, RectangularPatch, Side, tangent_plane_join};
/// let patch = |points: [[i64; 3]; 4]| -> Result<Piece, casteljau::Error> {
///     let points = points.map(|point| point.map(Rational::from).to_vec()).to_vec();
///     Ok(Piece::Rectangle(RectangularPatch::from_points((1, 1), points, Rectangle::unit())?))
/// };
/// let floor = patch([[0, 0, 0], [0, 1, 0], [1, 0, 0], [1, 1, 0]])?;
/// let ramp = patch([[1, 1, 0], [1, 0, 0], [4, 1, 0], [4, 0, 0]])?;
/// let join = tangent_plane_join((&floor, Side::U1), (&ramp, Side::U0), false)?;
/// assert!(join.is_g1() && join.reversed);
/// assert_eq!(join.ratio.and_then(|ratio| ratio.constant()), Some(Rational::from(3)));
/// # Ok::<(), casteljau::Error>(())
/// ```
///
/// # Errors
/// [`Error::Unsupported`] for patches that are not in space, and where a weight
/// vanishes on the edge; [`Error::TooLarge`] where the degree is too high for [`RealRoots`].
pub fn tangent_plane_join(first: (&Piece, Side), second: (&Piece, Side), rational: bool) -> Result<TangentPlaneJoin, Error> {
    let x = Symbol::new('x', None);
    let own = Boundary::of(first.0, first.1, false, rational, x)?;
    let mut other = Boundary::of(second.0, second.1, false, rational, x)?;
    let mut join = TangentPlaneJoin {
        same_edge: own.same_points(&other),
        reversed: false,
        collapsed: false,
        coplanar: None,
        singular: [Vanishing::At(Vec::new()), Vanishing::At(Vec::new())],
        opposite_sides: None,
        ratio: None,
        shear: None,
    };
    if !join.same_edge {
        other = Boundary::of(second.0, second.1, true, rational, x)?;
        join.same_edge = own.same_points(&other);
        join.reversed = join.same_edge;
    }
    if !join.same_edge {
        return Ok(join);
    }
    let (a, p, r) = (&own.along, &own.across, &other.across);
    let normals = [cross(a, p), cross(a, r)];
    join.collapsed = a.iter().all(Polynomial::is_empty);
    join.coplanar = Some(dot(&normals[0], r).is_empty());
    join.singular = [zeros(&dot(&normals[0], &normals[0]), x)?, zeros(&dot(&normals[1], &normals[1]), x)?];
    if join.coplanar == Some(false) || join.singular.contains(&Vanishing::Everywhere) {
        return Ok(join);
    }
    // Parallel fields: one coordinate that is not zero tells all. Both are divided by squares of weights.
    let [own_square, other_square] = [&own.weight, &other.weight].map(|weight| weight * weight);
    let part = (0..3).find(|&axis| !normals[0][axis].is_empty()).unwrap_or(0);
    let (above, below) = (-&(&normals[1][part] * &own_square), &normals[0][part] * &other_square);
    join.ratio = Quotient::of(&above, &below, x);
    let part = (0..3).find(|&axis| !a[axis].is_empty()).unwrap_or(0);
    let sum = &(&(&r[part] * &own_square) * &below) + &(&(&p[part] * &other_square) * &above);
    join.shear = Quotient::of(&sum, &(&(&a[part] * &other_square) * &below), x);
    // Between the places where a normal vanishes the sign of the product stays the same.
    let product = dot(&normals[0], &normals[1]);
    join.opposite_sides = Some(sign_on_edge(&product, &join.singular, x) < 0);
    Ok(join)
}

/// The sign of a polynomial on the unit interval: where it changes, at places
/// where one of the normals vanishes, it counts as positive.
fn sign_on_edge(product: &Polynomial, singular: &[Vanishing; 2], x: Symbol) -> i8 {
    let mut stops = vec![Rational::from(0), Rational::from(1)];
    for vanishing in singular {
        let Vanishing::At(places) = vanishing else { continue };
        for place in places {
            match place {
                RootPlace::Exact(t) => stops.push(t.clone()),
                RootPlace::Between(low, high) => stops.extend([low.clone(), high.clone()]),
            }
        }
    }
    stops.sort();
    stops.dedup();
    let polynomial = IntegerPolynomial::primitive(Rational::clear_to_integers(&coefficients(product, x)));
    // Dividing by what the coefficients have in common keeps their signs.
    let middles = stops.windows(2).map(|pair| polynomial.sign_at(&((&pair[0] + &pair[1]) * Rational::new(1, 2))));
    middles.filter(|sign| *sign != 0).max().unwrap_or(1)
}
