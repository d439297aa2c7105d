//! Signs of polynomials on the closed unit interval, given by their Bernstein
//! coefficients times binomial numbers.

use num_bigint::BigInt;
use num_traits::{Signed, Zero};

use super::field::binomials;
use crate::affine::Interval;
use crate::exact::Rational;
use crate::roots::RealRoots;
use crate::segment::Segment;

/// The real roots inside the interval; none of the zero polynomial.
fn roots(series: &[BigInt]) -> Option<RealRoots> {
    let points = series.iter().zip(binomials::<BigInt>(series.len() - 1)).map(|(c, weight)| Rational::from_big(c.clone(), weight));
    let segment = Segment::new(1, points.collect(), Interval::unit()).ok()?;
    let curve = segment.curve().ok()?;
    let coefficients: Vec<Rational> = curve.coordinate(0).cloned().collect();
    RealRoots::inside(&coefficients, &Interval::unit()).ok()
}

/// Whether a polynomial has no zero on the closed interval.
pub(super) fn is_nowhere_zero(series: &[BigInt]) -> bool {
    let (Some(first), Some(last)) = (series.first(), series.last()) else { return false };
    if first.is_zero() || last.is_zero() {
        return false;
    }
    // All coefficients of one sign: no need to look for roots.
    if series.iter().all(BigInt::is_positive) || series.iter().all(BigInt::is_negative) {
        return true;
    }
    roots(series).is_some_and(|roots| roots.distinct() == 0)
}

/// Whether a polynomial has no negative value on the closed interval.
pub(super) fn is_nowhere_negative(series: &[BigInt]) -> bool {
    if series.iter().all(|c| !c.is_negative()) {
        return true;
    }
    if series[0].is_negative() || series[series.len() - 1].is_negative() {
        return false;
    }
    // A negative value somewhere, and none at the ends: the sign changes inside.
    match roots(series) {
        Some(roots) => {
            let changes = roots.isolated().into_iter().any(|root| root.multiplicity % 2 == 1);
            !changes && first_sign(series) > 0
        }
        None => false,
    }
}

/// The sign of a polynomial a little behind the beginning of the interval; 0 of zero.
pub(super) fn first_sign(series: &[BigInt]) -> i8 {
    match series.iter().find(|c| !c.is_zero()) {
        None => 0,
        Some(c) if c.is_negative() => -1,
        Some(_) => 1,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn series(coefficients: &[i64]) -> Vec<BigInt> {
        coefficients.iter().copied().map(BigInt::from).collect()
    }

    #[test]
    fn signs() {
        // (1 - 2x)² has a double root at 1/2, and touches zero there.
        let square = series(&[1, -2, 1]);
        assert!(is_nowhere_negative(&square) && !is_nowhere_zero(&square));
        // 1 - 2x changes sign, x (1 - x) is zero at the ends only.
        assert!(!is_nowhere_negative(&series(&[1, -1])));
        assert!(is_nowhere_negative(&series(&[0, 1, 0])) && !is_nowhere_zero(&series(&[0, 1, 0])));
        // -x (1 - x) and (1 - x)² - 3 x (1 - x) + x² are negative inside.
        assert!(!is_nowhere_negative(&series(&[0, -1, 0])));
        assert!(!is_nowhere_negative(&series(&[1, -3, 1])));
        // Positive, with a negative coefficient: x² - x + 1 and 1 in other words.
        assert!(is_nowhere_zero(&series(&[2, -2, 2])) && is_nowhere_negative(&series(&[2, -2, 2])));
    }
}
