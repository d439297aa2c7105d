//! Quotients of polynomials in one variable.

use num_traits::{Signed, Zero};

use crate::exact::Rational;
use crate::exact::univariate::IntegerPolynomial;
use crate::symbolic::{Polynomial, Symbol};

/// The quotient of two polynomials in one variable, in lowest terms.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Quotient {
    /// Coefficients in ascending powers.
    pub numerator: Vec<Rational>,
    /// Coefficients in ascending powers: whole numbers, of which the last is positive.
    pub denominator: Vec<Rational>,
}

impl Quotient {
    /// The quotient of two polynomials; none if the second is zero.
    pub(crate) fn of(numerator: &Polynomial, denominator: &Polynomial, x: Symbol) -> Option<Self> {
        let (above, below) = (coefficients(numerator, x), coefficients(denominator, x));
        let leading = |list: &[Rational]| list.iter().rev().find(|c| !c.is_zero()).cloned();
        let bottom = leading(&below)?;
        let Some(top) = leading(&above) else {
            return Some(Self { numerator: Vec::new(), denominator: vec![Rational::from(1)] });
        };
        let [n, d] = [&above, &below].map(|list| IntegerPolynomial::primitive(Rational::clear_to_integers(list)));
        let common = n.gcd(&d);
        // Both are multiples of their common divisor.
        let [n, d] = [&n, &d].map(|polynomial| polynomial.divide(&common).unwrap_or_else(|| polynomial.clone()));
        let [n, d] = [n, d].map(|polynomial| polynomial.coefficients().iter().cloned().map(Rational::from).collect::<Vec<_>>());
        let (last, own) = (leading(&d)?, leading(&n)?);
        let sign = Rational::from(if last.is_negative() { -1 } else { 1 });
        let factor = top / bottom * &last / own * &sign;
        Some(Self { numerator: n.iter().map(|c| c * &factor).collect(), denominator: d.iter().map(|c| c * &sign).collect() })
    }

    /// The number, if it is constant.
    #[must_use]
    pub fn constant(&self) -> Option<Rational> {
        match (self.numerator.as_slice(), self.denominator.as_slice()) {
            ([], _) => Some(Rational::from(0)),
            ([n], [d]) => Some(n / d),
            _ => None,
        }
    }
}

/// The coefficients of a polynomial in one variable with numbers for coefficients, in ascending powers.
pub(crate) fn coefficients(polynomial: &Polynomial, x: Symbol) -> Vec<Rational> {
    polynomial.coefficients_in(x).iter().filter_map(Polynomial::as_rational).collect()
}
