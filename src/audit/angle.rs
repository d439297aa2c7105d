//! Bounds of the angle between tangent planes along an edge.
//!
//! With `a` along the edge and `p`, `r` into the two patches, the normals are
//! `a × p` and `a × r`, and their vector product is `det(a, p, r) a`. So the
//! squared sine of the angle is `|a|² det² / (|a × p|² |a × r|²)`.

use num_bigint::{BigInt, BigUint};
use num_integer::Integer as _;
use num_traits::{One, Zero};

use super::field::{Series, binomials};
use super::lattice::Whole;
use crate::exact::Rational;

/// How many parts of an edge are looked at for the bounds.
const MAX_PARTS: usize = 48;

/// The bits that coefficients are cut to, outward.
const BITS: u64 = 60;

/// A polynomial over a part of the edge, enclosed: its Bernstein coefficients
/// lie between these integers, times a power of two that all parts share.
#[derive(Clone, Debug)]
struct Enclosure {
    coefficients: Vec<(i64, i64)>,
}

impl Enclosure {
    /// Encloses a series; gives the power of two too.
    fn of<W: Whole>(series: &[W]) -> (Self, u64) {
        let exact: Vec<BigInt> = series.iter().cloned().map(Into::into).collect();
        let shift = exact.iter().map(BigInt::bits).max().unwrap_or(0).saturating_sub(BITS);
        let weights = binomials::<BigInt>(series.len() - 1);
        let enclose = |(number, weight): (&BigInt, &BigInt)| {
            let divisor = weight << shift;
            let (low, high) = (number.div_floor(&divisor), number.div_ceil(&divisor));
            // Cut to fewer than 63 bits above.
            (i64::try_from(low).unwrap_or(i64::MIN), i64::try_from(high).unwrap_or(i64::MAX))
        };
        (Self { coefficients: exact.iter().zip(&weights).map(enclose).collect() }, shift)
    }

    /// The two halves, by de Casteljau's algorithm with outward rounding.
    fn halves(&self) -> [Self; 2] {
        let count = self.coefficients.len();
        let mut row = self.coefficients.clone();
        let (mut left, mut right) = (Vec::with_capacity(count), vec![(0, 0); count]);
        for step in 0..count {
            left.push(row[0]);
            right[count - 1 - step] = row[count - 1 - step];
            for k in 0..count - 1 - step {
                let low = (i128::from(row[k].0) + i128::from(row[k + 1].0)).div_euclid(2);
                let high = (i128::from(row[k].1) + i128::from(row[k + 1].1) + 1).div_euclid(2);
                // Means of words are words.
                row[k] = (low as i64, high as i64);
            }
        }
        [Self { coefficients: left }, Self { coefficients: right }]
    }

    /// The largest absolute value that it can have.
    fn most(&self) -> u64 {
        self.coefficients.iter().map(|(low, high)| low.unsigned_abs().max(high.unsigned_abs())).max().unwrap_or(0)
    }

    /// The smallest value, at least 0, that a polynomial without negative values has.
    fn least(&self) -> u64 {
        u64::try_from(self.coefficients.iter().map(|(low, _)| *low).min().unwrap_or(0)).unwrap_or(0)
    }

    /// The smallest and largest absolute value at the beginning of the part.
    fn at_start(&self) -> (u64, u64) {
        let (low, high) = self.coefficients[0];
        let nearest = if low <= 0 && high >= 0 { 0 } else { low.unsigned_abs().min(high.unsigned_abs()) };
        (nearest, low.unsigned_abs().max(high.unsigned_abs()))
    }
}

/// A bound `numerator / denominator`, without the powers of two that all share.
#[derive(Clone, Debug)]
struct Bound {
    numer: BigUint,
    denom: BigUint,
}

impl Bound {
    fn of(along: u64, determinant: u64, first: u64, second: u64) -> Self {
        let numer = BigUint::from(along) * determinant * determinant;
        Self { numer, denom: BigUint::from(first) * second }
    }

    fn exceeds(&self, other: &Self) -> bool {
        &self.numer * &other.denom > &other.numer * &self.denom
    }
}

/// A part of the edge: `|a|²`, the determinant, `|a × p|²`, `|a × r|²`.
struct Part {
    polynomials: [Enclosure; 4],
    upper: Bound,
}

impl Part {
    fn new(polynomials: [Enclosure; 4]) -> Self {
        let [along, determinant, first, second] = &polynomials;
        let upper = Bound::of(along.most(), determinant.most(), first.least(), second.least());
        Self { polynomials, upper }
    }

    /// A bound from below: the value at the beginning.
    fn lower(&self) -> Option<Bound> {
        let [along, determinant, first, second] = self.polynomials.each_ref().map(Enclosure::at_start);
        let bound = Bound::of(along.0, determinant.0, first.1, second.1);
        (!bound.denom.is_zero()).then_some(bound)
    }
}

/// A lower and an upper bound of the largest squared sine along the edge, both
/// certain; at most 1. The polynomials are `|a|²`, `det(a, p, r)`, `|a × p|²`
/// and `|a × r|²`.
pub(super) fn squared_sine<W: Whole>(polynomials: [&Series<W>; 4]) -> [Rational; 2] {
    let [along, determinant, first, second] = polynomials.map(|series| Enclosure::of(series));
    // The powers of two that were taken out: of |a|² det², and of the divisor.
    let (numer_shift, denom_shift) = (along.1 + 2 * determinant.1, first.1 + second.1);
    let mut parts = vec![Part::new([along.0, determinant.0, first.0, second.0])];
    let mut lower = Bound { numer: BigUint::zero(), denom: BigUint::one() };
    let mut finished: Option<Bound> = None;
    for _ in 0..MAX_PARTS {
        // The part that may hold the largest value.
        let Some(worst) = (0..parts.len()).reduce(|best, k| if parts[k].upper.exceeds(&parts[best].upper) { k } else { best }) else {
            break;
        };
        let part = parts.swap_remove(worst);
        if let Some(bound) = part.lower().filter(|bound| bound.exceeds(&lower)) {
            lower = bound;
        }
        // Good enough: within one in 64.
        let tight = Bound { numer: &lower.numer * 65u32, denom: &lower.denom * 64u32 };
        if !part.upper.exceeds(&tight) {
            finished = Some(part.upper);
            break;
        }
        let [a, b, c, d] = part.polynomials.each_ref().map(Enclosure::halves);
        let [[a0, a1], [b0, b1], [c0, c1], [d0, d1]] = [a, b, c, d];
        parts.push(Part::new([a0, b0, c0, d0]));
        parts.push(Part::new([a1, b1, c1, d1]));
    }
    let upper = parts.into_iter().map(|part| part.upper).chain(finished).reduce(|a, b| if b.exceeds(&a) { b } else { a });
    let value = |bound: Bound, upward: bool| -> Rational {
        if bound.denom.is_zero() {
            return Rational::from(1);
        }
        rounded(bound.numer << numer_shift, &(bound.denom << denom_shift), upward).min(Rational::from(1))
    };
    [value(lower, false), upper.map_or_else(|| Rational::from(1), |bound| value(bound, true))]
}

/// A quotient with six digits, rounded down or up.
pub(super) fn rounded(numer: BigUint, denom: &BigUint, upward: bool) -> Rational {
    if numer.is_zero() {
        return Rational::from(0);
    }
    // The power of ten that brings the quotient above 10^5: log10(2) is a little more than 3/10.
    let places = (6 + (denom.bits() as i64 - numer.bits() as i64) * 30103 / 100_000).max(0) as u32;
    let ten = BigUint::from(10u32).pow(places);
    let scaled = numer * &ten;
    let quotient = if upward { scaled.div_ceil(denom) } else { scaled.div_floor(denom) };
    Rational::from_big(quotient.into(), ten.into())
}

/// Whether `bound |a × p|² |a × r|² - |a|² det²` is nowhere negative on the
/// edge: the angle's squared sine is at most `bound`, decided exactly.
pub(super) fn is_within(bound: &Rational, [along, determinant, first, second]: [&Series<BigInt>; 4]) -> bool {
    use super::field::product;
    let (numer, denom) = (bound.numer(), bound.denom());
    let allowed: Series<BigInt> = product(first, second).into_iter().map(|c| c * &numer).collect();
    let found: Series<BigInt> = product(along, &product(determinant, determinant)).into_iter().map(|c| c * &denom).collect();
    // Both to the same degree.
    let degree = allowed.len().max(found.len());
    let raise = |series: &Series<BigInt>| product(series, &binomials(degree - series.len()));
    let difference: Series<BigInt> = raise(&allowed).into_iter().zip(raise(&found)).map(|(a, b)| a - b).collect();
    super::sign::is_nowhere_negative(&difference)
}

#[cfg(test)]
mod tests {
    use num_traits::Signed;

    use super::*;

    #[test]
    fn rounding_goes_outward() {
        let (numer, denom) = (BigUint::from(2u32), BigUint::from(3_000_000_000u64));
        let (low, high) = (rounded(numer.clone(), &denom, false), rounded(numer, &denom, true));
        let exact = Rational::new(2, 3_000_000_000);
        assert!(low < exact && exact < high);
        assert!((&high - &low) < exact * Rational::new(1, 10_000));
        assert!(!low.is_negative());
    }

    #[test]
    fn a_constant_angle_is_enclosed() {
        // |a|² = 1, det = 3, |a × p|² = 5², |a × r|² = 1: sin² = 9/25.
        let series = [1, 3, 25, 1].map(|c| vec![i128::from(c)]);
        let [low, high] = squared_sine([&series[0], &series[1], &series[2], &series[3]]);
        assert!(low <= Rational::new(9, 25) && Rational::new(9, 25) <= high);
        assert!(&high - &low < Rational::new(1, 100));
    }
}
