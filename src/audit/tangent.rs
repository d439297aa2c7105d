//! Tangent directions and tangent planes at a joint.

use num_bigint::{BigInt, BigUint};
use num_traits::{Signed, Zero};

use super::angle::{self, Enclosure};
use super::field::{Field, Series};
use super::lattice::Whole;
use super::sign;
use crate::exact::Rational;

/// What two pieces have in common at a joint, to first order.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Contact {
    /// One tangent direction, or one tangent plane all along the edge.
    Smooth,
    /// Tangents or tangent planes that differ.
    Kink,
    /// The same tangents or tangent planes, but the pieces lie on one side: a
    /// cusp or a fold.
    Fold,
    /// A curve has no tangent there: its handle is zero.
    ZeroHandle,
    /// A patch has no tangent plane anywhere on the edge.
    NoTangentPlane,
    /// The tangent planes agree, but a normal vanishes at single points of the edge.
    SingularPoints,
    /// The pieces have one coordinate, or do not lie in space: not asked.
    NotAsked,
}

impl Contact {
    /// Whether there is nothing that could be smooth.
    #[must_use]
    pub fn is_degenerate(self) -> bool {
        matches!(self, Self::ZeroHandle | Self::NoTangentPlane | Self::SingularPoints)
    }
}

/// The first-order comparison of two pieces.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Tangency {
    pub(super) contact: Contact,
    /// The constant ratio of the second cross-boundary difference to the first.
    pub(super) ratio: Option<Rational>,
    /// Bounds of the largest squared sine of the angle.
    pub(super) sin2: Option<[Rational; 2]>,
    /// Whether the angle is a right one or larger.
    pub(super) obtuse: bool,
}

impl Tangency {
    fn of(contact: Contact) -> Self {
        let sin2 = matches!(contact, Contact::Smooth | Contact::Fold).then(|| [Rational::from(0), Rational::from(0)]);
        Self { contact, ratio: None, sin2, obtuse: contact == Contact::Fold }
    }
}

/// The number `λ` with `b = -λ a`, if there is one; `a` is not zero.
fn opposite_ratio<W: Whole>(a: &[Series<W>], b: &[Series<W>]) -> Option<Rational> {
    let pairs = || a.iter().flatten().zip(b.iter().flatten());
    let (x, y) = pairs().find(|(x, _)| !x.is_nothing())?;
    let proportional = pairs().all(|(p, r)| {
        let (mut left, mut right) = (p.clone(), r.clone());
        left.multiply(y);
        right.multiply(x);
        left == right
    });
    proportional.then(|| {
        let (x, y): (BigInt, BigInt) = (x.clone().into(), y.clone().into());
        -Rational::from_big(y, x)
    })
}

/// The numbers `λ` and `μ` with `b = -λ p + μ a`, if there are such; `λ` is given.
fn ratio_with_shear<W: Whole>(p: &Field<W>, r: &Field<W>, a: &Field<W>) -> Option<Rational> {
    let degree = p.degree().max(r.degree()).max(a.degree());
    let [p, r, a] =
        [p, r, a].map(|field| field.clone().with_degree(degree).coordinates.into_iter().flatten().map(Into::into).collect::<Vec<BigInt>>());
    let determinant = |x: [&BigInt; 2], y: [&BigInt; 2]| x[0] * y[1] - x[1] * y[0];
    let first = (0..p.len()).find(|&i| !a[i].is_zero())?;
    let second = (0..p.len()).find(|&j| !determinant([&p[first], &p[j]], [&a[first], &a[j]]).is_zero())?;
    let (i, j) = (first, second);
    let whole = determinant([&p[i], &p[j]], [&a[i], &a[j]]);
    let of_p = determinant([&r[i], &r[j]], [&a[i], &a[j]]);
    let of_a = determinant([&p[i], &p[j]], [&r[i], &r[j]]);
    let holds = (0..p.len()).all(|k| &r[k] * &whole == &p[k] * &of_p + &a[k] * &of_a);
    holds.then(|| -Rational::from_big(of_p, whole))
}

/// Two curves at a point: `a` and `b` lead from it into them.
pub(super) fn of_curves<W: Whole>(a: &Field<W>, b: &Field<W>) -> Tangency {
    if a.coordinates.len() < 2 {
        let ratio = opposite_ratio(&a.coordinates, &b.coordinates).filter(Rational::is_positive);
        return Tangency { ratio, sin2: None, ..Tangency::of(Contact::NotAsked) };
    }
    if a.is_zero() || b.is_zero() {
        return Tangency::of(Contact::ZeroHandle);
    }
    if let Some(ratio) = opposite_ratio(&a.coordinates, &b.coordinates) {
        let contact = if ratio.is_positive() { Contact::Smooth } else { Contact::Fold };
        return Tangency { ratio: Some(ratio).filter(Rational::is_positive), ..Tangency::of(contact) };
    }
    let scalar = |x: &Field<W>, y: &Field<W>| -> BigInt { x.dot(y).swap_remove(0).into() };
    let (aa, bb, ab) = (scalar(a, a), scalar(b, b), scalar(a, b));
    let whole = aa * bb;
    let sin2 = Rational::from_big(&whole - &ab * &ab, whole);
    // The tangent runs out of the first curve and into the second.
    Tangency { contact: Contact::Kink, ratio: None, sin2: Some([sin2.clone(), sin2]), obtuse: !ab.is_negative() }
}

/// Two patches along an edge, `along` in its direction, `p` and `r` into them.
/// `sheared` allows the cross-boundary differences of triangles to be compared
/// up to a multiple of the derivative along the edge.
pub(super) fn of_patches<W: Whole>(along: &Field<W>, p: &Field<W>, r: &Field<W>, sheared: bool) -> Tangency {
    let ratio = if p.is_zero() || r.is_zero() {
        None
    } else {
        let degree = p.degree().max(r.degree());
        let raised = |field: &Field<W>| field.clone().with_degree(degree);
        let plain = if p.degree() == r.degree() {
            opposite_ratio(&p.coordinates, &r.coordinates)
        } else {
            opposite_ratio(&raised(p).coordinates, &raised(r).coordinates)
        };
        plain.or_else(|| if sheared { ratio_with_shear(p, r, along) } else { None })
    };
    let ratio = ratio.filter(Rational::is_positive);
    if along.coordinates.len() != 3 {
        return Tangency { ratio, sin2: None, ..Tangency::of(Contact::NotAsked) };
    }
    // Only where a × p is zero all along there is no plane; single points do not matter
    // to a constant ratio, by continuity.
    let (first, second) = (along.cross(p), along.cross(r));
    if first.is_zero() || second.is_zero() {
        return Tangency::of(Contact::NoTangentPlane);
    }
    if ratio.is_some() {
        return Tangency { ratio, ..Tangency::of(Contact::Smooth) };
    }
    let determinant = first.dot(r);
    if determinant.iter().all(W::is_nothing) {
        let [first, second] = [&first, &second].map(Field::widened);
        let side = sign::first_sign(&first.dot(&second));
        let normal = |normal: &Field<BigInt>| sign::is_nowhere_zero(&normal.dot(normal));
        let contact = match (side < 0, normal(&first) && normal(&second)) {
            (false, true) => Contact::Fold,
            (true, true) => Contact::Smooth,
            (_, false) => Contact::SingularPoints,
        };
        return Tangency::of(contact);
    }
    let sin2 = angle::squared_sine(along, [&first, &second], &determinant);
    // Acute all along if the scalar product of the normals is negative everywhere.
    let acute = Enclosure::dot(&first, &second).0.is_negative() || {
        let cosine = first.widened().dot(&second.widened());
        sign::first_sign(&cosine) < 0 && sign::is_nowhere_zero(&cosine)
    };
    Tangency { contact: Contact::Kink, ratio: None, sin2: Some(sin2), obtuse: !acute }
}

/// The squared distance of a quotient of integers, over the square of a scale.
pub(super) fn squared(numer: BigInt, denom: BigInt, scale: &BigUint) -> Rational {
    let scale = BigInt::from(scale.clone());
    Rational::from_big(numer, denom * &scale * &scale)
}
