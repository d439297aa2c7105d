//! Real roots of polynomials in one variable: counted and isolated, never approximated.

use num_bigint::BigInt;
use num_traits::{One, Signed, Zero};

use super::Rational;
use super::gcd::gcd_big;

/// A real root: the number itself where it is rational, else an open interval
/// that holds this root and no other, with rational ends.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum RootPlace {
    /// The root is this number.
    Exact(Rational),
    /// The root is irrational and lies strictly between these two.
    Between(Rational, Rational),
}

/// A real root with its multiplicity.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Root {
    /// Where it is.
    pub place: RootPlace,
    /// How often it counts.
    pub multiplicity: usize,
}

/// A non-zero polynomial in one variable, as the square-free factors of each multiplicity.
#[derive(Clone, Debug)]
pub struct RealRoots {
    factors: Vec<Factor>,
}

#[derive(Clone, Debug)]
struct Factor {
    multiplicity: usize,
    /// Sturm's chain, beginning with the factor itself.
    chain: Vec<Vec<BigInt>>,
}

impl RealRoots {
    /// The roots of the polynomial with these coefficients in ascending
    /// powers, or `None` for the zero polynomial, whose roots are all numbers.
    ///
    /// (Yun's square-free decomposition and Sturm's theorem; Basu, Pollack and
    /// Roy, *Algorithms in Real Algebraic Geometry*, chapter 2.)
    #[must_use]
    pub fn of(coefficients: &[Rational]) -> Option<Self> {
        let whole = primitive(clear(coefficients));
        if whole.is_empty() {
            return None;
        }
        let mut factors = Vec::new();
        let derivative_of_whole = derivative(&whole);
        let mut repeated = gcd(&whole, &derivative_of_whole);
        let mut rest = divide(&whole, &repeated);
        let mut multiplicity = 1;
        while rest.len() > 1 {
            let shared = gcd(&rest, &repeated);
            let factor = divide(&rest, &shared);
            if factor.len() > 1 {
                factors.push(Factor { multiplicity, chain: sturm_chain(factor) });
            }
            repeated = divide(&repeated, &shared);
            rest = shared;
            multiplicity += 1;
        }
        Some(Self { factors })
    }

    /// The number of different roots strictly between two numbers, `a < b`.
    #[must_use]
    pub fn distinct_between(&self, a: &Rational, b: &Rational) -> usize {
        self.factors.iter().map(|factor| factor.count(a, b)).sum()
    }

    /// The number of roots strictly between two numbers, each as often as it counts.
    #[must_use]
    pub fn with_multiplicity_between(&self, a: &Rational, b: &Rational) -> usize {
        self.factors.iter().map(|factor| factor.multiplicity * factor.count(a, b)).sum()
    }

    /// The roots strictly between two numbers, `a < b`, ascending; intervals
    /// around irrational ones are disjoint from each other and from the rational ones.
    #[must_use]
    pub fn between(&self, a: &Rational, b: &Rational) -> Vec<Root> {
        let mut roots: Vec<(Root, usize)> = Vec::new();
        for (index, factor) in self.factors.iter().enumerate() {
            let mut places = Vec::new();
            factor.isolate(a, b, factor.count(a, b), &mut places);
            roots.extend(places.into_iter().map(|place| (Root { place, multiplicity: factor.multiplicity }, index)));
        }
        // Different factors have no root in common, so halving ends.
        loop {
            roots.sort_by(|x, y| bounds(&x.0.place).0.cmp(bounds(&y.0.place).0));
            let Some(position) = (1..roots.len()).find(|&k| bounds(&roots[k - 1].0.place).1 > bounds(&roots[k].0.place).0) else {
                return roots.into_iter().map(|(root, _)| root).collect();
            };
            for (root, index) in &mut roots[position - 1..=position] {
                self.factors[*index].refine(&mut root.place);
            }
        }
    }
}

fn bounds(place: &RootPlace) -> (&Rational, &Rational) {
    match place {
        RootPlace::Exact(value) => (value, value),
        RootPlace::Between(low, high) => (low, high),
    }
}

impl Factor {
    fn polynomial(&self) -> &[BigInt] {
        &self.chain[0]
    }

    fn variations(&self, at: &Rational) -> usize {
        let signs = self.chain.iter().map(|polynomial| sign_at(polynomial, at)).filter(|&sign| sign != 0);
        let mut previous = 0;
        let mut variations = 0;
        for sign in signs {
            variations += usize::from(sign == -previous);
            previous = sign;
        }
        variations
    }

    /// The roots strictly between `a` and `b`. For a square-free polynomial
    /// Sturm's difference counts those in `(a, b]`, wherever `a` is.
    fn count(&self, a: &Rational, b: &Rational) -> usize {
        self.variations(a) - self.variations(b) - usize::from(sign_at(self.polynomial(), b) == 0)
    }

    fn isolate(&self, a: &Rational, b: &Rational, count: usize, places: &mut Vec<RootPlace>) {
        if count == 0 {
            return;
        }
        if count == 1 {
            places.push(self.place(a.clone(), b.clone()));
            return;
        }
        let middle = (a + b) * Rational::new(1, 2);
        let below = self.count(a, &middle);
        let here = usize::from(sign_at(self.polynomial(), &middle) == 0);
        self.isolate(a, &middle, below, places);
        if here == 1 {
            places.push(RootPlace::Exact(middle.clone()));
        }
        self.isolate(&middle, b, count - below - here, places);
    }

    /// The only root strictly between two numbers. A rational root has a
    /// denominator that divides the leading coefficient, and an interval
    /// shorter than the inverse of its square holds at most one such fraction,
    /// which is then the simplest one in it.
    fn place(&self, mut low: Rational, mut high: Rational) -> RootPlace {
        let leading = Rational::from(self.polynomial()[self.polynomial().len() - 1].abs());
        let short = (&leading * &leading).recip().unwrap_or_else(|| Rational::from(1));
        while &high - &low >= short {
            let middle = (&low + &high) * Rational::new(1, 2);
            if sign_at(self.polynomial(), &middle) == 0 {
                return RootPlace::Exact(middle);
            }
            if self.count(&low, &middle) == 1 { high = middle } else { low = middle }
        }
        let simplest = simplest_between(&low, &high);
        if sign_at(self.polynomial(), &simplest) == 0 { RootPlace::Exact(simplest) } else { RootPlace::Between(low, high) }
    }

    fn refine(&self, place: &mut RootPlace) {
        if let RootPlace::Between(low, high) = place {
            let middle = (&*low + &*high) * Rational::new(1, 2);
            if self.count(low, &middle) == 1 { *high = middle } else { *low = middle }
        }
    }
}

/// The fraction with the least denominator strictly between two numbers.
fn simplest_between(low: &Rational, high: &Rational) -> Rational {
    let floor = num_integer::Integer::div_floor(&low.numer(), &low.denom());
    let next = Rational::from(&floor + BigInt::one());
    if next < *high {
        // The integer nearest zero among those between.
        if low.is_negative() && high.is_positive() {
            return Rational::from(0);
        }
        return next;
    }
    // Both lie in [floor, floor + 1]: the answer is floor + 1/x for the simplest x between the inverses.
    let floor = Rational::from(floor);
    let upper = (low - &floor).recip();
    let Some(lower) = (high - &floor).recip() else { return next };
    let x = match upper {
        Some(upper) => simplest_between(&lower, &upper),
        None => Rational::from(num_integer::Integer::div_floor(&lower.numer(), &lower.denom()) + BigInt::one()),
    };
    floor + x.recip().unwrap_or_else(|| Rational::from(0))
}

fn clear(coefficients: &[Rational]) -> Vec<BigInt> {
    let mut common = BigInt::one();
    for coefficient in coefficients {
        let denom = coefficient.denom();
        let shared = BigInt::from(gcd_big(common.magnitude(), denom.magnitude()));
        common *= denom / shared;
    }
    coefficients.iter().map(|coefficient| coefficient.numer() * (&common / coefficient.denom())).collect()
}

/// Without trailing zeros and common factors; the sign stays.
fn primitive(mut polynomial: Vec<BigInt>) -> Vec<BigInt> {
    while polynomial.last().is_some_and(Zero::is_zero) {
        polynomial.pop();
    }
    let content = polynomial.iter().fold(num_bigint::BigUint::ZERO, |content, c| gcd_big(&content, c.magnitude()));
    if !content.is_zero() && !content.is_one() {
        let content = BigInt::from(content);
        polynomial.iter_mut().for_each(|c| *c /= &content);
    }
    polynomial
}

fn derivative(polynomial: &[BigInt]) -> Vec<BigInt> {
    primitive(polynomial.iter().enumerate().skip(1).map(|(power, c)| c * BigInt::from(power)).collect())
}

/// The remainder of a polynomial division, times a positive number.
fn positive_remainder(mut dividend: Vec<BigInt>, divisor: &[BigInt]) -> Vec<BigInt> {
    let Some(leading) = divisor.last() else { return dividend };
    let scale = leading.abs();
    while dividend.len() >= divisor.len() {
        let Some(top) = dividend.pop() else { break };
        let shift = dividend.len() + 1 - divisor.len();
        let factor = if leading.is_negative() { -top } else { top };
        dividend.iter_mut().for_each(|c| *c *= &scale);
        for (c, d) in dividend[shift..].iter_mut().zip(divisor) {
            *c -= &factor * d;
        }
    }
    primitive(dividend)
}

fn gcd(a: &[BigInt], b: &[BigInt]) -> Vec<BigInt> {
    let (mut a, mut b) = (a.to_vec(), b.to_vec());
    while !b.is_empty() {
        let rest = positive_remainder(a, &b);
        a = b;
        b = rest;
    }
    primitive(a)
}

/// The quotient of primitive polynomials where the division has no remainder.
fn divide(dividend: &[BigInt], divisor: &[BigInt]) -> Vec<BigInt> {
    let Some(leading) = divisor.last() else { return dividend.to_vec() };
    let mut rest = dividend.to_vec();
    let mut quotient = vec![BigInt::ZERO; (dividend.len() + 1).saturating_sub(divisor.len())];
    for shift in (0..quotient.len()).rev() {
        // By Gauss's lemma the quotient of primitive polynomials has integer coefficients.
        let factor = &rest[shift + divisor.len() - 1] / leading;
        for (c, d) in rest[shift..].iter_mut().zip(divisor) {
            *c -= &factor * d;
        }
        quotient[shift] = factor;
    }
    quotient
}

fn sturm_chain(polynomial: Vec<BigInt>) -> Vec<Vec<BigInt>> {
    let mut next = derivative(&polynomial);
    let mut chain = vec![polynomial];
    while !next.is_empty() {
        let remainder = positive_remainder(chain[chain.len() - 1].clone(), &next);
        chain.push(next);
        next = remainder.into_iter().map(|c| -c).collect();
    }
    chain
}

fn sign_at(polynomial: &[BigInt], at: &Rational) -> i8 {
    // Horner's scheme on the homogeneous polynomial, so that only integers occur.
    let (numer, denom) = (at.numer(), at.denom());
    let mut power = BigInt::one();
    let mut sum = BigInt::ZERO;
    for c in polynomial.iter().rev() {
        sum = sum * &numer + c * &power;
        power *= &denom;
    }
    i8::from(sum.is_positive()) - i8::from(sum.is_negative())
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn times(a: &[Rational], b: &[Rational]) -> Vec<Rational> {
        let mut product = vec![Rational::from(0); a.len() + b.len() - 1];
        for (i, x) in a.iter().enumerate() {
            for (j, y) in b.iter().enumerate() {
                product[i + j] += x * y;
            }
        }
        product
    }

    fn roots_of(coefficients: &[i64]) -> RealRoots {
        let coefficients: Vec<Rational> = coefficients.iter().map(|&c| Rational::from(c)).collect();
        RealRoots::of(&coefficients).expect("not the zero polynomial")
    }

    #[test]
    fn irrational_roots_are_isolated() {
        // (t^2 - 2)^2 (t - 1)
        let roots = roots_of(&[-4, 4, 4, -4, -1, 1]).between(&Rational::from(-3), &Rational::from(3));
        assert_eq!(roots.iter().map(|root| root.multiplicity).collect::<Vec<_>>(), [2, 1, 2]);
        assert_eq!(roots[1].place, RootPlace::Exact(Rational::from(1)));
        let RootPlace::Between(low, high) = &roots[2].place else { panic!("√2 is irrational") };
        let two = Rational::from(2);
        assert!(low * low < two && two < high * high && *low >= Rational::from(1));
    }

    #[test]
    fn the_ends_do_not_count() {
        let roots = roots_of(&[0, -1, 0, 1]);
        assert_eq!(roots.distinct_between(&Rational::from(-1), &Rational::from(1)), 1);
        assert_eq!(roots.distinct_between(&Rational::from(0), &Rational::from(1)), 0);
        assert!(RealRoots::of(&[Rational::from(0)]).is_none());
        assert_eq!(roots_of(&[5]).between(&Rational::from(-9), &Rational::from(9)), []);
    }

    #[test]
    fn simplest_fractions() {
        let q = Rational::new;
        for (low, high, simplest) in [
            (q(1, 3), q(1, 2), q(2, 5)),
            (q(-1, 2), q(1, 3), q(0, 1)),
            (q(0, 1), q(1, 7), q(1, 8)),
            (q(5, 2), q(9, 2), q(3, 1)),
            (q(-7, 5), q(-1, 1), q(-4, 3)),
        ] {
            assert_eq!(simplest_between(&low, &high), simplest);
        }
    }

    proptest! {
        /// Plant the roots, then ask for them.
        #[test]
        fn planted_roots_are_found(
            planted in prop::collection::btree_map((-12i64..12, 1i64..5), 1usize..4, 0..4),
            quadratic in (1i64..4, -3i64..4, 4i64..9),
            a in -8i64..8,
            length in 1i64..12,
        ) {
            let mut polynomial = vec![Rational::from(quadratic.2), Rational::from(quadratic.1), Rational::from(quadratic.0)];
            let mut expected = std::collections::BTreeMap::new();
            for ((numer, denom), multiplicity) in planted {
                *expected.entry(Rational::new(numer, denom)).or_insert(0) += multiplicity;
            }
            for (root, &multiplicity) in &expected {
                for _ in 0..multiplicity {
                    polynomial = times(&polynomial, &[-root, Rational::from(1)]);
                }
            }
            let (low, high) = (Rational::from(a), Rational::from(a + length));
            let roots = RealRoots::of(&polynomial).expect("not zero");
            let inside: Vec<Root> = expected.into_iter()
                .filter(|(root, _)| low < *root && *root < high)
                .map(|(root, multiplicity)| Root { place: RootPlace::Exact(root), multiplicity })
                .collect();
            // The quadratic factor has no real root: its discriminant is negative.
            prop_assume!(quadratic.1 * quadratic.1 < 4 * quadratic.0 * quadratic.2);
            prop_assert_eq!(roots.distinct_between(&low, &high), inside.len());
            prop_assert_eq!(roots.with_multiplicity_between(&low, &high), inside.iter().map(|root| root.multiplicity).sum::<usize>());
            prop_assert_eq!(roots.between(&low, &high), inside);
        }
    }
}
