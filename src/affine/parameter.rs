//! Homogeneous arguments of polar forms.

use super::Weights;
use crate::exact::Rational;
use crate::kernel::coefficient::Coefficient;

/// An argument of a polar form: the point `t` where the weight is 1, the
/// direction `t` where the weight is 0, in general the homogeneous `[w; t]`.
///
/// The polar form is multilinear in such arguments: a weight of 0 makes an
/// argument a vector, and `f(t, …, t, [0; 1])` is the derivative at `t` over
/// the degree (Ramshaw, *Blossoming*, 1987, on homogenizing; Gallier, *Curves
/// and Surfaces in Geometric Modeling*, chapter 18).
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Parameter<C = Rational> {
    /// The coordinate.
    pub t: C,
    /// The weight.
    pub w: C,
}

impl<C: Coefficient> Parameter<C> {
    /// The homogeneous argument `[w; t]`.
    #[must_use]
    pub fn homogeneous(w: C, t: C) -> Self {
        Self { t, w }
    }

    /// The direction of differentiation, `[0; 1]`.
    #[must_use]
    pub fn direction() -> Self {
        Self { t: C::unit(), w: C::nothing() }
    }

    /// The vertices of equations: the origin and the direction.
    pub(crate) fn line() -> [Self; 2] {
        [Self::from(C::nothing()), Self::direction()]
    }
}

/// The point with coordinate `t`.
impl<C: Coefficient> From<C> for Parameter<C> {
    fn from(t: C) -> Self {
        Self { t, w: C::unit() }
    }
}

/// An argument of the polar form of a surface by its total degree: the point
/// `(u, v)` of the parameter plane where the weight is 1, the direction
/// `(u, v)` where the weight is 0, in general the homogeneous `[w; u, v]`.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct PlaneParameter<C = Rational> {
    /// The first coordinate.
    pub u: C,
    /// The second coordinate.
    pub v: C,
    /// The weight.
    pub w: C,
}

impl<C: Coefficient> PlaneParameter<C> {
    /// The homogeneous argument `[w; u, v]`.
    #[must_use]
    pub fn homogeneous(w: C, u: C, v: C) -> Self {
        Self { u, v, w }
    }

    /// The point `(u, v)`.
    #[must_use]
    pub fn point([u, v]: [C; 2]) -> Self {
        Self { u, v, w: C::unit() }
    }

    /// The vector `(u, v)`, a direction of differentiation.
    #[must_use]
    pub fn vector([u, v]: [C; 2]) -> Self {
        Self { u, v, w: C::nothing() }
    }

    /// The vertices of equations: the origin and the two directions.
    pub(crate) fn plane() -> [Self; 3] {
        let (zero, one) = (C::nothing, C::unit);
        [Self::point([zero(), zero()]), Self::vector([one(), zero()]), Self::vector([zero(), one()])]
    }

    /// Points and vectors as integer points of the homogeneous plane.
    pub(crate) fn weights(arguments: &[Self]) -> Weights<C> {
        let mut weights = Weights::default();
        arguments.iter().for_each(|Self { u, v, w }| weights.push(&[w.clone(), u.clone(), v.clone()]));
        weights
    }
}
