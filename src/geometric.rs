//! Geometric continuity: of curves up to order 3, of patches across an edge.

use num_traits::{Signed, Zero};

use crate::affine::Interval;
use crate::curve::Curve;
use crate::error::Error;
use crate::exact::Rational;
use crate::roots::RealRoots;
use crate::symbolic::{Polynomial, Symbol};
use crate::triangular::TriangularPatch;

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
}

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
    if f.dimension() != g.dimension() {
        return Err(Error::WrongCount { what: "coordinates", expected: f.dimension(), found: g.dimension() });
    }
    let derivatives = |curve: &Curve, at: &Rational| (0..=3).map(|order| curve.derivative(order).value(at)).collect::<Vec<_>>();
    let (f, g) = (derivatives(f, at_f), derivatives(g, at_g));
    let vanishes = |vector: &[Rational]| vector.iter().all(Zero::is_zero);
    let regular = !vanishes(&f[1]) && !vanishes(&g[1]);
    let mut join = GeometricJoin { regular, order: (f[0] == g[0]).then_some(0), betas: Vec::new(), reversed: false };
    if join.order.is_none() || !regular {
        return Ok(join);
    }
    let Some(first) = ratio(&g[1], &f[1]) else { return Ok(join) };
    if first.is_negative() {
        join.reversed = true;
        return Ok(join);
    }
    join.order = Some(1);
    join.betas.push(first.clone());
    // What is left of a derivative must be along the tangent.
    let rest = |order: usize, known: &[(&Rational, usize)]| -> Vec<Rational> {
        (0..f[0].len()).map(|axis| known.iter().fold(g[order][axis].clone(), |rest, (factor, k)| rest - &f[*k][axis] * *factor)).collect()
    };
    let square = first.pow(2);
    let Some(second) = ratio(&rest(2, &[(&square, 2)]), &f[1]) else { return Ok(join) };
    join.order = Some(2);
    join.betas.push(second.clone());
    let (cube, mixed) = (first.pow(3), Rational::from(3) * &first * &second);
    if let Some(third) = ratio(&rest(3, &[(&cube, 3), (&mixed, 2)]), &f[1]) {
        join.order = Some(3);
        join.betas.push(third);
    }
    Ok(join)
}

/// How two triangular patches join across the edge `st` of their frames, each
/// in a parameter plane of its own, `r` being the inner vertex: tangent planes
/// along the whole edge. A test that was not reached is none.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct TangentPlaneJoin {
    /// Whether the edge curves are the same.
    pub same_edge: bool,
    /// Whether the edge's direction and the two directions into the patches are
    /// everywhere in one plane.
    pub coplanar: Option<bool>,
    /// Whether both normals are different from zero on the closed edge.
    pub regular: Option<bool>,
    /// Whether the patches lie on opposite sides of the edge, not folded onto each other.
    pub opposite_sides: Option<bool>,
}

impl TangentPlaneJoin {
    /// Whether the patches have the same tangent planes along the edge.
    #[must_use]
    pub fn is_g1(&self) -> bool {
        self.opposite_sides == Some(true)
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

/// Whether a polynomial has no zero on the closed unit interval.
fn is_nowhere_zero(polynomial: &Polynomial, x: Symbol) -> Result<bool, Error> {
    let coefficients: Vec<Rational> = polynomial.coefficients_in(x).iter().filter_map(Polynomial::as_rational).collect();
    let at_end: Rational = coefficients.iter().sum();
    if coefficients.first().is_none_or(Zero::is_zero) || at_end.is_zero() {
        return Ok(false);
    }
    Ok(RealRoots::inside(&coefficients, &Interval::unit())?.distinct() == 0)
}

/// Whether two patches in space join with a common tangent plane, decided along
/// the whole edge: `det(a, p, r)` vanishes identically, neither normal `a × p`,
/// `a × r` does anywhere, and they point away from each other (`a` along the
/// edge, `p` and `r` into the patches).
///
/// # Errors
/// [`Error::Unsupported`] for patches that are not in space.
pub fn tangent_plane_join(first: &TriangularPatch, second: &TriangularPatch) -> Result<TangentPlaneJoin, Error> {
    if first.dimension() != 3 || second.dimension() != 3 {
        return Err(Error::Unsupported("tangent planes need patches in space, with 3 coordinates".into()));
    }
    let x = Symbol::new('x', None);
    let mut join = TangentPlaneJoin { same_edge: false, coplanar: None, regular: None, opposite_sides: None };
    let edge = |patch: &TriangularPatch| patch.surface()?.segment(patch.frame().s(), patch.frame().t())?.curve();
    let (edge_a, edge_b) = (edge(first)?, edge(second)?);
    join.same_edge = edge_a.same_map(&edge_b);
    if !join.same_edge {
        return Ok(join);
    }
    // Curves of vectors along the edge, as polynomials in its parameter.
    let field = |curve: &Curve| -> Result<Field, Error> {
        let lists = curve.polynomials(x);
        lists.try_into().map_err(|_| Error::Unsupported("tangent planes need patches in space".into()))
    };
    let into = |patch: &TriangularPatch| -> Result<Field, Error> {
        let [r, s, _] = patch.frame().vertices();
        let derivative = patch.surface()?.derivative(&[&r[0] - &s[0], &r[1] - &s[1]], 1)?;
        field(&derivative.segment(patch.frame().s(), patch.frame().t())?.curve()?)
    };
    let (a, p, r) = (field(&edge_a.derivative(1))?, into(first)?, into(second)?);
    let (normal_p, normal_r) = (cross(&a, &p), cross(&a, &r));
    join.coplanar = Some(dot(&normal_p, &r).is_empty());
    join.regular = Some(is_nowhere_zero(&dot(&normal_p, &normal_p), x)? && is_nowhere_zero(&dot(&normal_r, &normal_r), x)?);
    if join.coplanar == Some(false) || join.regular == Some(false) {
        return Ok(join);
    }
    // They are parallel and nowhere zero, so one place tells.
    let half = Polynomial::from(Rational::new(1, 2));
    let product = dot(&normal_p, &normal_r).substitute(x, &half).as_rational().unwrap_or_default();
    join.opposite_sides = Some(product.is_negative());
    Ok(join)
}
