//! The parameters of a point.

use num_traits::Zero;

use crate::algebraic::AlgebraicNumber;
use crate::curve::Curve;
use crate::error::Error;
use crate::exact::Rational;
use crate::exact::univariate::IntegerPolynomial;
use crate::roots::RealRoots;

/// The real parameters of a point of space.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Parameters {
    /// The curve is this one point.
    All,
    /// These, in ascending order; none if the point is not on the curve.
    These(Vec<AlgebraicNumber>),
}

impl Parameters {
    /// Whether there is one.
    #[must_use]
    pub fn exist(&self) -> bool {
        match self {
            Self::All => true,
            Self::These(list) => !list.is_empty(),
        }
    }
}

impl Curve {
    /// The point `[0; F_d]` at infinity, without its weight 0, that a curve of
    /// degree `d` approaches where its parameter grows (CS348a, lecture 6,
    /// section 2.1); `None` for a curve that is one point.
    #[must_use]
    pub fn point_at_infinity(&self) -> Option<&[Rational]> {
        let degree = self.true_degree();
        (degree > 0).then(|| self.vector(degree))
    }

    /// The real parameters of a point: the common roots of `F_i(t) - p_i`.
    ///
    /// ```
    /// use casteljau::{Curve, Parameters, Rational};
    /// // The isolated double point (-1, 0) of (t^2, t^3 + t) is not on the curve, (2, 3 √2) would be.
    /// let q = Rational::from;
    /// let curve = Curve::new(vec![vec![q(0), q(0), q(1)], vec![q(0), q(1), q(0), q(1)]])?;
    /// assert_eq!(curve.parameters_of(&[q(-1), q(0)])?, Parameters::These(vec![]));
    /// assert!(curve.parameters_of(&[q(4), q(10)])?.exist());
    /// # Ok::<(), casteljau::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`Error::WrongCount`] for a point of another dimension; [`Error::TooLarge`] as for [`RealRoots::inside`].
    pub fn parameters_of(&self, point: &[Rational]) -> Result<Parameters, Error> {
        if point.len() != self.dimension() {
            return Err(Error::WrongCount { what: "coordinates", expected: self.dimension(), found: point.len() });
        }
        if self.true_degree() > RealRoots::MAX_DEGREE {
            return Err(Error::TooLarge { what: "degree of a polynomial whose roots are counted", limit: RealRoots::MAX_DEGREE });
        }
        let differences = point.iter().enumerate().map(|(index, value)| {
            let mut list: Vec<Rational> = self.coordinate(index).cloned().collect();
            list[0] -= value;
            IntegerPolynomial::primitive(Rational::clear_to_integers(&list))
        });
        let common = differences.fold(IntegerPolynomial::primitive(Vec::new()), |common, next| common.gcd(&next));
        if common.is_zero() {
            return Ok(Parameters::All);
        }
        let list: Vec<Rational> = common.coefficients().iter().cloned().map(Rational::from).collect();
        debug_assert!(list.iter().any(|c| !c.is_zero()));
        Ok(Parameters::These(AlgebraicNumber::real_roots(&list)?))
    }
}
