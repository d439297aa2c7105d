//! The invariants of planar cubics.

use num_traits::Zero;

use super::class::{Branch, CubicClass};
use crate::curve::Curve;
use crate::error::Error;
use crate::exact::Rational;
use crate::kernel::coefficient::Coefficient;

/// The determinants `κ_ij = det(F_i, F_j)` of the coefficient vectors of a
/// planar cubic (CS348a, lecture 6, section 2.2).
///
/// Under a map of the plane with determinant `δ` they are multiplied by `δ`;
/// their signs and zeros survive every change of parameter that the
/// classification needs. They are the `d3`, `d1`, `d2` of Loop and Blinn
/// ("Resolution independent curve rendering", 2005), with the inflections at
/// the roots of `κ12 - 3 κ31 t + 3 κ23 t²`.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Invariants<C = Rational> {
    /// `det(F_1, F_2)`
    pub kappa12: C,
    /// `det(F_2, F_3)`
    pub kappa23: C,
    /// `det(F_3, F_1)`
    pub kappa31: C,
}

impl<C: Coefficient> Invariants<C> {
    /// The invariants of a curve with coefficients of any kind.
    ///
    /// # Errors
    /// As for [`Cubic::new`](super::Cubic::new).
    pub fn of(curve: &Curve<C>) -> Result<Self, Error> {
        super::check(curve.dimension(), curve.true_degree())?;
        let entry = |power: usize, index: usize| if power <= curve.degree() { curve.vector(power)[index].clone() } else { C::nothing() };
        let det = |a: usize, b: usize| entry(a, 0).times(&entry(b, 1)).minus(&entry(a, 1).times(&entry(b, 0)));
        Ok(Self { kappa12: det(1, 2), kappa23: det(2, 3), kappa31: det(3, 1) })
    }

    /// The discriminant `D = 3 κ31² - 4 κ12 κ23`.
    #[must_use]
    pub fn discriminant(&self) -> C {
        let (three, four) = (C::from_word(3), C::from_word(4));
        three.times(&self.kappa31.times(&self.kappa31)).minus(&four.times(&self.kappa12.times(&self.kappa23)))
    }
}

impl Invariants {
    /// The branch of the classification tree that these numbers take (CS348a,
    /// lecture 6, figure 6).
    #[must_use]
    pub fn branch(&self) -> Branch {
        Branch::of(
            self.kappa23.is_zero(),
            || self.discriminant().cmp(&Rational::zero()),
            || self.kappa31.is_zero(),
            || self.kappa12.is_zero(),
        )
    }

    /// The class.
    #[must_use]
    pub fn class(&self) -> CubicClass {
        self.branch().class()
    }
}
