//! Square roots of numbers, as symbols with `√p · √p = p`.
//!
//! The root of a prime `p` is the symbol `√` with the index `p`. Products of
//! different such symbols are linearly independent over the rationals (Besicovitch, "On
//! the linear independence of fractional powers of integers", 1940), so two polynomials without
//! squares of these symbols are equal if and only if they are the same
//! polynomial: equality of sums and products of roots is decided, not estimated.

use std::cmp::Ordering;

use num_bigint::{BigInt, Sign};
use num_traits::{One, Signed, ToPrimitive, Zero};

use super::{Monomial, Polynomial, Symbol};
use crate::exact::Rational;

/// The letter of the symbols that are roots. It is no letter of the grammar.
const LETTER: char = '√';

/// Primes below this are found by division; what is left of a radicand below its square is a prime.
const TRIAL: u32 = 1 << 16;

impl Symbol {
    /// The prime whose square root this symbol stands for, if it does.
    #[must_use]
    pub fn radicand(self) -> Option<u32> {
        if self.letter() == LETTER { self.index() } else { None }
    }
}

impl Polynomial {
    /// The square root of a number that is not negative. `None` if a prime
    /// beyond 2^32 or one that could not be found stays under the root.
    pub(crate) fn square_root(value: &Rational) -> Option<Self> {
        if value.is_negative() {
            return None;
        }
        // √(a/b) = √(a b) / b
        let denominator = value.denom();
        let (factor, primes) = factored(value.numer() * &denominator)?;
        let monomial = Monomial::from_factors(primes.into_iter().map(|prime| (Symbol::new(LETTER, Some(prime)), 1)));
        Some(Self::term(monomial, Rational::from_big(factor, denominator)))
    }

    /// The same with every `√p²` replaced by `p`.
    pub(crate) fn with_simple_roots(&self) -> Self {
        let has_square = |monomial: &Monomial| monomial.factors().iter().any(|(symbol, power)| *power > 1 && symbol.radicand().is_some());
        if !self.terms().any(|(monomial, _)| has_square(monomial)) {
            return self.clone();
        }
        Self::from_terms(self.terms().map(|(monomial, coefficient)| {
            let mut number = coefficient.clone();
            let factors = monomial.factors().iter().map(|&(symbol, power)| match symbol.radicand() {
                Some(prime) => {
                    number = &number * &Rational::from(i64::from(prime)).pow(power / 2);
                    (symbol, power % 2)
                }
                None => (symbol, power),
            });
            let factors: Vec<_> = factors.collect();
            (Monomial::from_factors(factors), number)
        }))
    }

    /// Whether the polynomial is a number: whether it has no symbols but roots.
    pub(crate) fn is_number(&self) -> bool {
        self.terms().all(|(monomial, _)| monomial.factors().iter().all(|(symbol, _)| symbol.radicand().is_some()))
    }

    /// Whether a root of a number occurs.
    pub(crate) fn has_roots(&self) -> bool {
        self.terms().any(|(monomial, _)| monomial.factors().iter().any(|(symbol, _)| symbol.radicand().is_some()))
    }

    /// One over a number with roots; `None` for zero and for what contains other symbols.
    pub(crate) fn reciprocal(&self) -> Option<Self> {
        let value = self.with_simple_roots();
        if let Some(number) = value.as_rational() {
            return number.recip().map(Self::from);
        }
        // 1/(a + b √p) = (a - b √p)/(a² - b² p), which has one root less.
        let root = value.symbols().into_iter().find(|symbol| symbol.radicand().is_some())?;
        let conjugate = value.substitute(root, &-Self::from(root));
        let norm = (&value * &conjugate).with_simple_roots();
        Some((&conjugate * &norm.reciprocal()?).with_simple_roots())
    }

    /// The order of two numbers with roots; `None` if another symbol occurs.
    pub(crate) fn compare_numbers(&self, other: &Self) -> Option<Ordering> {
        let difference = (self - other).with_simple_roots();
        if !difference.is_number() {
            return None;
        }
        if difference.is_zero() {
            return Some(Ordering::Equal);
        }
        // It is not zero, so that some enclosure leaves zero out.
        let mut bits = 64u32;
        loop {
            let (low, high) = difference.enclosure(bits);
            if low.is_positive() {
                return Some(Ordering::Greater);
            }
            if high.is_negative() {
                return Some(Ordering::Less);
            }
            bits *= 2;
        }
    }

    /// Rational numbers on both sides of a number with roots.
    fn enclosure(&self, bits: u32) -> (Rational, Rational) {
        let unit = BigInt::one() << bits;
        let mut sum = (Rational::zero(), Rational::zero());
        for (monomial, coefficient) in self.terms() {
            let product: BigInt = monomial.factors().iter().filter_map(|(symbol, _)| symbol.radicand()).map(BigInt::from).product();
            let scaled: BigInt = product << (2 * u64::from(bits));
            let root = BigInt::from_biguint(Sign::Plus, scaled.magnitude().sqrt());
            let (below, above) = (Rational::from_big(root.clone(), unit.clone()), Rational::from_big(root + 1, unit.clone()));
            let (low, high) = if coefficient.is_negative() { (above, below) } else { (below, above) };
            sum = (sum.0 + coefficient * &low, sum.1 + coefficient * &high);
        }
        sum
    }
}

/// A whole number as a square times different primes: the root of the square, and the primes.
fn factored(mut rest: BigInt) -> Option<(BigInt, Vec<u32>)> {
    let mut root = BigInt::one();
    let mut primes = Vec::new();
    if rest.is_zero() {
        return Some((BigInt::zero(), primes));
    }
    let mut divisor = 2u32;
    while divisor < TRIAL {
        if let Some(small) = rest.to_u64() {
            if small == 1 {
                break;
            }
            if u64::from(divisor) * u64::from(divisor) > small {
                primes.push(u32::try_from(small).ok()?);
                return Some((root, primes));
            }
        }
        let mut power = 0u32;
        while (&rest % divisor).is_zero() {
            rest /= divisor;
            power += 1;
        }
        root *= BigInt::from(divisor).pow(power / 2);
        if power % 2 == 1 {
            primes.push(divisor);
        }
        divisor += if divisor == 2 { 1 } else { 2 };
    }
    if rest.is_one() {
        return Some((root, primes));
    }
    let square = rest.sqrt();
    if &square * &square == rest {
        return Some((root * square, primes));
    }
    // Without a divisor below 2^16, a number below 2^32 is a prime.
    primes.push(rest.to_u32()?);
    Some((root, primes))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn root(numer: i64, denom: i64) -> Polynomial {
        match Polynomial::square_root(&Rational::new(numer, denom)) {
            Some(root) => root,
            None => panic!("no root of {numer}/{denom}"),
        }
    }

    #[test]
    fn roots_are_brought_to_primes() {
        for (numer, denom, expected) in [
            (0, 1, "0"),
            (4, 9, "2/3"),
            (2, 1, "√2"),
            (12, 1, "2 √3"),
            (6, 1, "√2 √3"),
            (1, 2, "1/2 √2"),
            (50, 27, "5/9 √2 √3"),
            (4_294_967_291, 1, "√4294967291"),
            (65_521 * 65_521, 1, "65521"),
            (1_000_003 * 1_000_003, 1, "1000003"),
        ] {
            assert_eq!(root(numer, denom).to_string(), expected);
            let square = (&root(numer, denom) * &root(numer, denom)).with_simple_roots();
            assert_eq!(square.as_rational(), Some(Rational::new(numer, denom)));
        }
        assert_eq!(Polynomial::square_root(&Rational::from(-1)), None);
        assert_eq!(Polynomial::square_root(&Rational::from(1_000_003i64 * 1_000_033)), None);
    }

    #[test]
    fn equality_order_and_division_are_exact() {
        // √2 + √3 = √(5 + 2 √6)
        let sum = root(2, 1) + root(3, 1);
        let square = (&sum * &sum).with_simple_roots();
        assert_eq!(square, Polynomial::from(Rational::from(5)) + root(24, 1));
        let inverse = match sum.reciprocal() {
            Some(inverse) => inverse,
            None => panic!("it is not zero"),
        };
        assert_eq!(inverse, root(3, 1) - root(2, 1));
        assert_eq!((&sum * &inverse).with_simple_roots().as_rational(), Some(Rational::one()));
        // √2 + √3 < √10, by 0.016
        assert_eq!(sum.compare_numbers(&root(10, 1)), Some(Ordering::Less));
        assert_eq!(root(8, 1).compare_numbers(&(root(2, 1) + root(2, 1))), Some(Ordering::Equal));
        assert_eq!(Polynomial::zero().reciprocal(), None);
        let t = Polynomial::from(Symbol::new('t', None));
        assert_eq!((t.clone() + root(2, 1)).reciprocal(), None);
        assert_eq!(t.compare_numbers(&sum), None);
    }
}
