//! Bounds of the angle between tangent planes along an edge.
//!
//! With `a` along the edge and `p`, `r` into the two patches, the normals are
//! `a × p` and `a × r`, and their vector product is `det(a, p, r) a`. So the
//! squared sine of the angle is `|a|² det² / (|a × p|² |a × r|²)`.

use num_bigint::{BigInt, BigUint};
use num_integer::Integer as _;
use num_traits::{One, Zero};

use super::field::{Field, Series, binomials, product};
use super::lattice::Whole;
use crate::exact::Rational;

/// How many parts of an edge are looked at for the bounds.
const MAX_PARTS: usize = 48;

/// The bits that coefficients are cut to: sums of products of two fit two words.
const BITS: u64 = 56;

/// A polynomial over a part of the edge, enclosed: its Bernstein coefficients
/// lie between these integers, times a power of two that all parts share.
#[derive(Clone, Debug)]
pub(super) struct Enclosure {
    coefficients: Vec<(i64, i64)>,
}

/// Series cut to words, over one power of two; what was cut off is less than 1.
struct Cut {
    series: Vec<Vec<i64>>,
    shift: u64,
}

impl Cut {
    fn of<'a, W: Whole + 'a>(series: impl Iterator<Item = &'a Series<W>> + Clone) -> Self {
        let shift = series.clone().flatten().map(Whole::bits).max().unwrap_or(0).saturating_sub(BITS);
        Self { series: series.map(|series| series.iter().map(|number| number.shifted(shift)).collect()).collect(), shift }
    }
}

impl Enclosure {
    /// Encloses what lies between two series of the same length, coefficients
    /// still times binomial numbers; gives the power of two that was taken out.
    fn between(low: &[i128], high: &[i128]) -> (Self, i64) {
        let bits = low.iter().chain(high).map(Whole::bits).max().unwrap_or(0);
        // Small numbers get as many bits behind the point.
        let shift = bits as i64 - 62;
        let scaled = |number: i128| if shift > 0 { number >> shift } else { number << -shift };
        // Of degrees this high the middle numbers are longer than two words.
        let weights: Vec<Option<i128>> = if low.len() <= 100 {
            binomials::<i128>(low.len() - 1).into_iter().map(Some).collect()
        } else {
            binomials::<BigInt>(low.len() - 1).iter().map(i128::of_big).collect()
        };
        let enclose = |((low, high), weight): ((&i128, &i128), &Option<i128>)| {
            // Outward: first by the power of two, then by the binomial number.
            let down = |number: i128| weight.map_or(-i128::from(number < 0), |weight| scaled(number).div_euclid(weight));
            (down(*low) as i64, -down(-high) as i64)
        };
        (Self { coefficients: low.iter().zip(high).zip(&weights).map(enclose).collect() }, shift)
    }

    /// Encloses a series; gives the power of two too.
    fn of<W: Whole>(series: &Series<W>) -> (Self, i64) {
        let Cut { series, shift } = Cut::of(std::iter::once(series));
        let low: Vec<i128> = series[0].iter().copied().map(i128::from).collect();
        let high: Vec<i128> = low.iter().map(|number| number + i128::from(shift > 0)).collect();
        let (enclosure, more) = Self::between(&low, &high);
        (enclosure, shift as i64 + more)
    }

    /// Encloses the scalar product of two fields; gives the power of two too.
    pub(super) fn dot<W: Whole>(a: &Field<W>, b: &Field<W>) -> (Self, i64) {
        let (a, b) = (Cut::of(a.coordinates.iter()), Cut::of(b.coordinates.iter()));
        let count = a.series[0].len() + b.series[0].len() - 1;
        let (mut low, mut high) = (vec![0i128; count], vec![0i128; count]);
        let (loose_a, loose_b) = (i128::from(a.shift > 0), i128::from(b.shift > 0));
        for (x, y) in a.series.iter().zip(&b.series) {
            for (i, &x) in x.iter().enumerate() {
                for (j, &y) in y.iter().enumerate() {
                    let (x, y) = (i128::from(x), i128::from(y));
                    // (x + δ)(y + ε) with δ, ε from 0 to 1 where something was cut off.
                    low[i + j] += x * y + loose_b * x.min(0) + loose_a * y.min(0);
                    high[i + j] += x * y + loose_b * x.max(0) + loose_a * y.max(0) + loose_a * loose_b;
                }
            }
        }
        let (enclosure, shift) = Self::between(&low, &high);
        (enclosure, (a.shift + b.shift) as i64 + shift)
    }

    /// Whether it is negative all over the edge, for certain.
    pub(super) fn is_negative(&self) -> bool {
        self.coefficients.iter().all(|(_, high)| *high < 0)
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
/// certain; at most 1. Given are `a`, the normals `a × p` and `a × r`, and
/// `det(a, p, r)`.
pub(super) fn squared_sine<W: Whole>(along: &Field<W>, normals: [&Field<W>; 2], determinant: &Series<W>) -> [Rational; 2] {
    let [first, second] = normals.map(|normal| Enclosure::dot(normal, normal));
    let (along, determinant) = (Enclosure::dot(along, along), Enclosure::of(determinant));
    // The powers of two that were taken out: of |a|² det², and of the divisor.
    let shift = along.1 + 2 * determinant.1 - first.1 - second.1;
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
        rounded(bound.numer << shift.max(0), &(bound.denom << (-shift).max(0)), upward).min(Rational::from(1))
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
pub(super) fn is_within(bound: &Rational, along: &Field<BigInt>, into: [&Field<BigInt>; 2]) -> bool {
    let [first, second] = into.map(|into| along.cross(into));
    let determinant = first.dot(into[1]);
    let (along, first, second) = (along.dot(along), first.dot(&first), second.dot(&second));
    let (numer, denom) = (bound.numer(), bound.denom());
    let allowed: Series<BigInt> = product(&first, &second).into_iter().map(|c| c * &numer).collect();
    let found: Series<BigInt> = product(&along, &product(&determinant, &determinant)).into_iter().map(|c| c * &denom).collect();
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

    fn field<W: Whole>(vectors: [[i64; 3]; 3], factor: i64) -> Field<W> {
        let number = |axis: usize, k: usize| W::of_big(&(BigInt::from(vectors[k][axis]) * factor)).expect("it fits");
        Field { coordinates: (0..3).map(|axis| (0..3).map(|k| number(axis, k)).collect()).collect() }
    }

    fn bounds<W: Whole>(a: [[i64; 3]; 3], p: [[i64; 3]; 3], r: [[i64; 3]; 3], factor: i64) -> [Rational; 2] {
        let (a, p, r) = (field::<W>(a, factor), field::<W>(p, factor), field::<W>(r, factor));
        let normals = [&a.cross(&p), &a.cross(&r)];
        squared_sine(&a, normals, &normals[0].dot(&r))
    }

    #[test]
    fn angles_are_enclosed() {
        // a = (1, 0, 0), p = (0, -1, 0), r = (0, 4, 3): sin² = 9/25 all along; degree 2 in other words.
        let constant = |v: [i64; 3]| [v, v.map(|c| 2 * c), v];
        let (a, p, r) = (constant([1, 0, 0]), constant([0, -1, 0]), constant([0, 4, 3]));
        for [low, high] in [bounds::<i128>(a, p, r, 1), bounds::<BigInt>(a, p, r, 1), bounds::<BigInt>(a, p, r, i64::MAX)] {
            assert!(low <= Rational::new(9, 25) && Rational::new(9, 25) <= high, "{low} {high}");
            assert!(&high - &low < Rational::new(1, 100));
        }
    }

    #[test]
    fn wide_and_narrow_integers_agree_up_to_the_cut() {
        let (a, p, r) = ([[3, 1, 0], [7, -2, 5], [4, 0, 1]], [[0, -5, 1], [2, -9, 3], [1, -4, 0]], [[1, 6, 0], [-3, 11, 2], [0, 5, 1]]);
        let plain = bounds::<i128>(a, p, r, 1);
        for factor in [1, 1 << 20, 1 << 40] {
            let [low, high] = bounds::<BigInt>(a, p, r, factor);
            assert!(low <= plain[1] && plain[0] <= high && low <= high);
            assert!((&high - &low) * Rational::from(32) < high, "{low} {high}");
        }
    }

    #[test]
    fn the_largest_angle_is_between_the_bounds() {
        // The exact decision along the whole edge is the twin of the bounds.
        let mut state = 1u64;
        let mut number = || {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            (state >> 33) as i64 % 10
        };
        for _ in 0..60 {
            let [a, p, r] = [0, 1, 2].map(|_| [0, 1, 2].map(|_| [number(), number(), number()]));
            let [low, high] = bounds::<i128>(a, p, r, 1);
            let (a, p, r) = (field::<BigInt>(a, 1), field::<BigInt>(p, 1), field::<BigInt>(r, 1));
            assert!(low <= high && is_within(&high, &a, [&p, &r]), "{high} is exceeded");
            assert!(low.is_zero() || !is_within(&(&low * Rational::new(999, 1000)), &a, [&p, &r]), "{low} is not reached");
        }
    }
}
