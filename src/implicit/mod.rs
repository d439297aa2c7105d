//! Implicit equations of plane curves.

mod conic;
mod decomposition;
mod membership;
mod resultant;

pub use conic::ConicType;
pub use membership::Parameters;

use num_bigint::BigInt;
use num_traits::{One, Signed, Zero};

use crate::curve::Curve;
use crate::error::Error;
use crate::exact::Rational;
use crate::exact::univariate::IntegerPolynomial;
use crate::symbolic::{Monomial, Polynomial, Symbol};
use decomposition::properly_parametrized;

/// The implicit equation of a plane curve: the irreducible polynomial `P` that
/// is zero on it, with integer coefficients that have no common factor, where
/// the one of the lexicographically largest exponent is positive.
///
/// The value of `P` at a point is the gauge of the point (CS348a, lecture 6,
/// section 1.1; the lecture writes `H = y - x²` for the parabola, which is
/// `-P`). A point where it is zero need not belong to the real curve: it may be
/// an isolated double point.
///
/// ```
/// use casteljau::{Curve, ImplicitCurve, Rational};
/// let q = Rational::from;
/// let parabola = Curve::new(vec![vec![q(0), q(1)], vec![q(0), q(0), q(1)]])?;
/// let implicit = ImplicitCurve::of(&parabola)?;
/// assert_eq!(implicit.polynomial().to_string(), "x^2 - y");
/// assert_eq!(implicit.gauge(&[q(2), q(1)]), q(3));
/// # Ok::<(), casteljau::Error>(())
/// ```
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ImplicitCurve {
    /// Exponents of x and y, ascending, and non-zero coefficients.
    terms: Vec<(usize, usize, BigInt)>,
    index: usize,
}

impl ImplicitCurve {
    /// The largest true degree of a curve whose equation is computed.
    pub const MAX_DEGREE: usize = 128;
    /// The most work, in multiplications modulo a prime.
    pub const MAX_STEPS: u64 = 1 << 29;

    /// The equation of a curve of the plane that is not a point.
    ///
    /// The curve is first written as `G(h(t))` with `h` of the largest possible
    /// degree, the tracing index; the resultant of `G` is then `P` itself up to
    /// a constant. It is computed from the power sums of the roots, modulo
    /// primes, as many as a bound of its coefficients asks for.
    ///
    /// # Errors
    /// [`Error::Unsupported`] for a curve that is not in the plane, or is one
    /// point; [`Error::TooLarge`] beyond the limits.
    pub fn of(curve: &Curve) -> Result<Self, Error> {
        if curve.dimension() != 2 {
            let remedy = match curve.dimension() {
                1 => "the graph of a function of t is the curve (t, F(t))",
                _ => "`transform` projects a curve into the plane, as with --map '(x, y)'",
            };
            return Err(Error::Unsupported(format!(
                "an implicit equation is that of a curve with two coordinates, this one has {}: {remedy}",
                curve.dimension()
            )));
        }
        let degree = curve.true_degree();
        if degree == 0 {
            let point: Vec<String> = curve.vector(0).iter().map(Rational::to_string).collect();
            return Err(Error::Unsupported(format!("the curve is the point ({}), which no single equation describes", point.join(", "))));
        }
        if degree > Self::MAX_DEGREE {
            return Err(Error::TooLarge { what: "degree of a curve whose implicit equation is computed", limit: Self::MAX_DEGREE });
        }
        // The primitive polynomials of both coordinates: the equation of (a x, b y) is as good.
        let coordinates = [0, 1].map(|index| curve.coordinate(index).cloned().collect::<Vec<Rational>>());
        resultant::check(&coordinates)?;
        let (proper, index) = properly_parametrized(&coordinates);
        let terms = resultant::equation(&proper)?;
        Ok(Self { terms: normalized(terms), index })
    }

    /// The terms, by ascending exponents of `x`, then of `y`.
    #[must_use]
    pub fn terms(&self) -> &[(usize, usize, BigInt)] {
        &self.terms
    }

    /// The total degree.
    #[must_use]
    pub fn degree(&self) -> usize {
        self.terms.iter().map(|(i, j, _)| i + j).max().unwrap_or(0)
    }

    /// How many complex parameters a general point of the curve has.
    #[must_use]
    pub fn index(&self) -> usize {
        self.index
    }

    /// The polynomial in the letters x and y.
    #[must_use]
    pub fn polynomial(&self) -> Polynomial {
        let [x, y] = ['x', 'y'].map(|letter| Symbol::new(letter, None));
        Polynomial::from_terms(self.terms.iter().map(|(i, j, c)| {
            let factors = [(x, *i as u32), (y, *j as u32)].into_iter().filter(|factor| factor.1 > 0);
            (Monomial::from_factors(factors), Rational::from(c.clone()))
        }))
    }

    /// The value at a point: its gauge.
    #[must_use]
    pub fn gauge(&self, [x, y]: &[Rational; 2]) -> Rational {
        self.terms.iter().map(|(i, j, c)| Rational::from(c.clone()) * x.pow(*i as u32) * y.pow(*j as u32)).sum()
    }

    /// Whether the equation holds all along a curve.
    #[must_use]
    pub fn vanishes_on(&self, curve: &Curve) -> bool {
        let t = Symbol::new('t', None);
        let coordinate = |index: usize| {
            let coefficients: Vec<Polynomial> = curve.coordinate(index).cloned().map(Polynomial::from).collect();
            Polynomial::from_coefficients(t, &coefficients)
        };
        let symbols = ['x', 'y'].map(|letter| Symbol::new(letter, None));
        self.polynomial().substitute_all(&[(symbols[0], coordinate(0)), (symbols[1], coordinate(1))]).is_empty()
    }
}

/// Without the zero terms and the common factor, and with the right sign.
fn normalized(mut terms: Vec<(usize, usize, BigInt)>) -> Vec<(usize, usize, BigInt)> {
    terms.retain(|(_, _, c)| !c.is_zero());
    terms.sort_by_key(|(i, j, _)| (*i, *j));
    // Sorted like that, the primitive polynomial of the coefficients is what is asked for, but for the sign.
    let primitive = IntegerPolynomial::primitive(terms.iter().map(|(_, _, c)| c.clone()).collect());
    let is_negative = primitive.coefficients().last().is_some_and(Signed::is_negative);
    let sign = if is_negative { -BigInt::one() } else { BigInt::one() };
    terms.iter().zip(primitive.coefficients()).map(|(&(i, j, _), c)| (i, j, c * &sign)).collect()
}
