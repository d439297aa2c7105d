//! Polynomials in one variable with integer coefficients: greatest common
//! divisors by way of prime fields, and square-free factors.

use num_bigint::BigInt;
use num_traits::{One, Signed, ToPrimitive, Zero};

use super::Rational;
use super::gcd::gcd_big;

/// A polynomial whose coefficients, in ascending powers, have no common factor
/// and no zero at the end; the zero polynomial has none.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct IntegerPolynomial(Vec<BigInt>);

impl IntegerPolynomial {
    /// The polynomial with these coefficients in ascending powers, divided by what they have in common.
    pub(crate) fn primitive(mut coefficients: Vec<BigInt>) -> Self {
        while coefficients.last().is_some_and(Zero::is_zero) {
            coefficients.pop();
        }
        let content = coefficients.iter().fold(num_bigint::BigUint::ZERO, |content, c| gcd_big(&content, c.magnitude()));
        if !content.is_zero() && !content.is_one() {
            let content = BigInt::from(content);
            coefficients.iter_mut().for_each(|c| *c /= &content);
        }
        Self(coefficients)
    }

    pub(crate) fn is_zero(&self) -> bool {
        self.0.is_empty()
    }

    /// The degree; 0 for the zero polynomial too.
    pub(crate) fn degree(&self) -> usize {
        self.0.len().saturating_sub(1)
    }

    pub(crate) fn coefficients(&self) -> &[BigInt] {
        &self.0
    }

    fn leading(&self) -> BigInt {
        self.0.last().cloned().unwrap_or_default()
    }

    fn derivative(&self) -> Self {
        Self::primitive(self.0.iter().enumerate().skip(1).map(|(power, c)| c * BigInt::from(power)).collect())
    }

    /// The sign of the value at a number.
    pub(crate) fn sign_at(&self, at: &Rational) -> i8 {
        // Horner's scheme on the homogeneous polynomial, so that only integers occur.
        let (numer, denom) = (at.numer(), at.denom());
        let mut power = BigInt::one();
        let mut sum = BigInt::ZERO;
        for c in self.0.iter().rev() {
            sum = sum * &numer + c * &power;
            power *= &denom;
        }
        i8::from(sum.is_positive()) - i8::from(sum.is_negative())
    }

    /// The quotient if the division has no remainder. By Gauss's lemma the
    /// quotient of primitive polynomials has integer coefficients.
    pub(crate) fn divide(&self, divisor: &Self) -> Option<Self> {
        let leading = divisor.0.last()?;
        let mut rest = self.0.clone();
        let mut quotient = vec![BigInt::ZERO; (self.0.len() + 1).saturating_sub(divisor.0.len())];
        for shift in (0..quotient.len()).rev() {
            let top = &rest[shift + divisor.0.len() - 1];
            if top.is_zero() {
                continue;
            }
            let (factor, remainder) = num_integer::Integer::div_rem(top, leading);
            if !remainder.is_zero() {
                return None;
            }
            for (c, d) in rest[shift..].iter_mut().zip(&divisor.0) {
                *c -= &factor * d;
            }
            quotient[shift] = factor;
        }
        rest.iter().all(Zero::is_zero).then(|| Self::primitive(quotient))
    }

    /// The greatest common divisor, up to sign.
    ///
    /// Computed modulo primes and put together by the Chinese remainder theorem
    /// until it divides both (W. S. Brown, "On Euclid's algorithm and the
    /// computation of polynomial greatest common divisors", 1971). Remainder
    /// sequences over the integers would let the coefficients explode.
    pub(crate) fn gcd(&self, other: &Self) -> Self {
        if self.is_zero() || other.is_zero() {
            return if self.is_zero() { other.clone() } else { self.clone() };
        }
        let scale = BigInt::from(gcd_big(self.leading().magnitude(), other.leading().magnitude()));
        let mut modulus = BigInt::one();
        let mut lifted: Vec<BigInt> = Vec::new();
        let mut prime = 1u64 << 31;
        loop {
            prime = previous_prime(prime);
            let field = PrimeField(prime);
            let scale_here = field.reduce(&scale);
            if scale_here == 0 {
                continue;
            }
            let mut image = field.gcd(field.image(&self.0), field.image(&other.0));
            if image.len() == 1 {
                return Self(vec![BigInt::one()]);
            }
            // The true divisor times `scale` has integer coefficients: make the images those of one polynomial.
            image.iter_mut().for_each(|c| *c = *c * scale_here % prime);
            if !lifted.is_empty() && image.len() > lifted.len() {
                // An unlucky prime: the images have a larger divisor than the polynomials.
                continue;
            }
            if lifted.is_empty() || image.len() < lifted.len() {
                lifted = image.into_iter().map(BigInt::from).collect();
                modulus = BigInt::from(prime);
            } else {
                let inverse = field.inverse(field.reduce(&modulus));
                for (value, residue) in lifted.iter_mut().zip(image) {
                    let difference = (residue + prime - field.reduce(value)) % prime;
                    *value += &modulus * BigInt::from(difference * inverse % prime);
                }
                modulus *= prime;
            }
            let half = &modulus >> 1u32;
            let symmetric = lifted.iter().map(|c| if *c > half { c - &modulus } else { c.clone() }).collect();
            let candidate = Self::primitive(symmetric);
            if self.divide(&candidate).is_some() && other.divide(&candidate).is_some() {
                return candidate;
            }
        }
    }

    /// The polynomial with the same roots, each once.
    pub(crate) fn square_free_part(&self) -> Self {
        self.divide(&self.gcd(&self.derivative())).unwrap_or_else(|| self.clone())
    }

    /// The square-free factors with their multiplicities, constants left out
    /// (the common divisor with the derivative holds every root one time less).
    pub(crate) fn square_free_factors(&self) -> Vec<(Self, usize)> {
        let mut factors = Vec::new();
        let mut repeated = self.gcd(&self.derivative());
        let quotient = |a: &Self, b: &Self| a.divide(b).unwrap_or_else(|| a.clone());
        let mut rest = quotient(self, &repeated);
        let mut multiplicity = 1;
        while rest.degree() > 0 {
            let shared = if repeated.degree() == 0 { Self(vec![BigInt::one()]) } else { rest.gcd(&repeated) };
            let factor = quotient(&rest, &shared);
            if factor.degree() > 0 {
                factors.push((factor, multiplicity));
            }
            repeated = quotient(&repeated, &shared);
            rest = shared;
            multiplicity += 1;
        }
        factors
    }
}

/// The largest prime below a number above 2.
pub(crate) fn previous_prime(below: u64) -> u64 {
    let is_prime = |n: &u64| *n % 2 == 1 && (3..).step_by(2).take_while(|d| d * d <= *n).all(|d| !(*n).is_multiple_of(d));
    (2..below).rev().find(is_prime).unwrap_or(2)
}

/// The numbers modulo a prime below `2^31`, so that products fit a word.
pub(crate) struct PrimeField(u64);

impl PrimeField {
    /// The field of a prime below `2^31`.
    pub(crate) fn new(prime: u64) -> Self {
        Self(prime)
    }

    pub(crate) fn prime(&self) -> u64 {
        self.0
    }

    pub(crate) fn reduce(&self, value: &BigInt) -> u64 {
        let rest = (value.magnitude() % self.0).to_u64().unwrap_or(0);
        if value.is_negative() && rest != 0 { self.0 - rest } else { rest }
    }

    fn image(&self, coefficients: &[BigInt]) -> Vec<u64> {
        trimmed(coefficients.iter().map(|c| self.reduce(c)).collect())
    }

    pub(crate) fn inverse(&self, value: u64) -> u64 {
        // Fermat: value^(p-2).
        let (mut result, mut base, mut exponent) = (1, value % self.0, self.0 - 2);
        while exponent > 0 {
            if exponent & 1 == 1 {
                result = result * base % self.0;
            }
            base = base * base % self.0;
            exponent >>= 1;
        }
        result
    }

    /// The greatest common divisor with leading coefficient 1.
    fn gcd(&self, mut a: Vec<u64>, mut b: Vec<u64>) -> Vec<u64> {
        while let Some(&leading) = b.last() {
            let inverse = self.inverse(leading);
            while a.len() >= b.len() {
                let Some(&top) = a.last() else { break };
                let factor = top * inverse % self.0;
                let shift = a.len() - b.len();
                for (c, d) in a[shift..].iter_mut().zip(&b) {
                    *c = (*c + (self.0 - factor) * d) % self.0;
                }
                a = trimmed(a);
            }
            std::mem::swap(&mut a, &mut b);
        }
        let inverse = self.inverse(a.last().copied().unwrap_or(1));
        a.iter_mut().for_each(|c| *c = *c * inverse % self.0);
        a
    }
}

fn trimmed(mut coefficients: Vec<u64>) -> Vec<u64> {
    while coefficients.last() == Some(&0) {
        coefficients.pop();
    }
    coefficients
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn times(a: &IntegerPolynomial, b: &IntegerPolynomial) -> IntegerPolynomial {
        let mut product = vec![BigInt::ZERO; a.0.len() + b.0.len()];
        for (i, x) in a.0.iter().enumerate() {
            for (j, y) in b.0.iter().enumerate() {
                product[i + j] += x * y;
            }
        }
        IntegerPolynomial::primitive(product)
    }

    fn polynomial(max_degree: usize) -> impl Strategy<Value = IntegerPolynomial> {
        let coefficient = prop_oneof![4 => (-9i64..10).prop_map(BigInt::from), 1 => any::<i128>().prop_map(BigInt::from)];
        prop::collection::vec(coefficient, 1..=max_degree + 1)
            .prop_map(IntegerPolynomial::primitive)
            .prop_filter("not zero", |p| !p.is_zero())
    }

    proptest! {
        /// Plant a common factor, then ask for it.
        #[test]
        fn common_factors_are_found(a in polynomial(4), b in polynomial(4), common in polynomial(3)) {
            let rest = a.gcd(&b);
            let found = times(&a, &common).gcd(&times(&b, &common));
            let expected = times(&rest, &common);
            prop_assert!(found.divide(&expected).is_some() && expected.divide(&found).is_some());
            prop_assert!(a.divide(&rest).is_some() && b.divide(&rest).is_some());
        }

        #[test]
        fn square_free_factors_multiply_to_the_whole(a in polynomial(3), b in polynomial(2), c in polynomial(1)) {
            let whole = [&a, &b, &b, &c, &c, &c].into_iter().fold(IntegerPolynomial(vec![BigInt::one()]), |product, factor| times(&product, factor));
            let factors = whole.square_free_factors();
            let mut product = IntegerPolynomial(vec![BigInt::one()]);
            for (factor, multiplicity) in &factors {
                prop_assert_eq!(factor.gcd(&factor.derivative()).degree(), 0);
                for _ in 0..*multiplicity {
                    product = times(&product, factor);
                }
            }
            prop_assert_eq!(product.degree(), whole.degree());
            prop_assert!(whole.divide(&product).is_some());
            // Every planted root counts at least as often as it was planted.
            let least = |power: usize| factors.iter().filter(|(_, m)| *m >= power).map(|(f, _)| f.degree()).sum::<usize>();
            prop_assert!(c.gcd(&c.derivative()).degree() > 0 || least(3) >= c.degree());
        }
    }
}
