//! Curves that run through their points more than once.

use num_traits::Zero;

use crate::exact::Rational;
use crate::exact::univariate::IntegerPolynomial;

/// A polynomial by its coefficients in ascending powers.
type Univariate = Vec<Rational>;

/// A plane curve `F(t) = G(h(t))` as the coordinates of a `G` that runs through
/// its points once in general, and the degree of `h`.
///
/// The numbers `s` with `F(s) = F(t0)` for a fixed `t0` are the roots of
/// `gcd(x(s) - x(t0), y(s) - y(t0))`, among them those of `h(s) - h(t0)`, and
/// for all but finitely many `t0` no others (Sederberg, "Improperly
/// parametrized rational curves", 1986; that `h` is a polynomial is Lüroth's
/// theorem for polynomials). Whether a candidate is right shows when `x` and
/// `y` are expanded in its powers: all digits have to be constants.
pub(super) fn properly_parametrized(coordinates: &[Univariate; 2]) -> ([Univariate; 2], usize) {
    let mut t0 = 0i64;
    loop {
        let at = Rational::from(t0);
        let shifted = coordinates.each_ref().map(|coordinate| {
            let value = coordinate.iter().rev().fold(Rational::zero(), |sum, c| sum * &at + c);
            let mut shifted = coordinate.clone();
            if let Some(constant) = shifted.first_mut() {
                *constant -= value;
            }
            IntegerPolynomial::primitive(Rational::clear_to_integers(&shifted))
        });
        let common = shifted[0].gcd(&shifted[1]);
        if common.degree() <= 1 {
            return (coordinates.clone(), 1);
        }
        let mut inner: Univariate = common.coefficients().iter().cloned().map(Rational::from).collect();
        inner[0] = Rational::zero();
        if let [Some(x), Some(y)] = coordinates.each_ref().map(|coordinate| digits(coordinate, &inner)) {
            return ([x, y], common.degree());
        }
        // Next: 1, -1, 2, -2, …
        t0 = if t0 > 0 { -t0 } else { 1 - t0 };
    }
}

/// The coefficients of a polynomial in powers of another, if they are constants.
fn digits(polynomial: &[Rational], base: &[Rational]) -> Option<Univariate> {
    let degree = base.len() - 1;
    let inverse = base[degree].recip()?;
    let mut rest = polynomial.to_vec();
    let mut digits = Vec::new();
    loop {
        while rest.last().is_some_and(Zero::is_zero) {
            rest.pop();
        }
        if rest.len() <= 1 {
            digits.push(rest.pop().unwrap_or_default());
            return Some(digits);
        }
        if rest.len() <= degree {
            return None;
        }
        let mut quotient = vec![Rational::zero(); rest.len() - degree];
        for shift in (0..quotient.len()).rev() {
            let factor = &rest[shift + degree] * &inverse;
            for (c, b) in rest[shift..].iter_mut().zip(base) {
                *c -= &factor * b;
            }
            quotient[shift] = factor;
        }
        if rest[1..].iter().any(|c| !c.is_zero()) {
            return None;
        }
        digits.push(rest.swap_remove(0));
        rest = quotient;
    }
}
