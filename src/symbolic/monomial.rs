//! Products of powers of symbols.

use std::cmp::Ordering;
use std::fmt;
use std::ops::Mul;

use smallvec::SmallVec;

use super::Symbol;

/// A product of powers of symbols, such as `t1 t2^2`; the empty product is 1.
///
/// Canonical form: factors sorted by symbol, every exponent positive. Monomials
/// are ordered by total degree, then by the power of the smallest symbol in
/// which they differ, so `1 < t2 < t1 < t2^2 < t1 t2 < t1^2`. This order agrees
/// with multiplication: `a < b` implies `a c < b c`.
#[derive(Clone, PartialEq, Eq, Hash, Default)]
pub struct Monomial {
    factors: SmallVec<[(Symbol, u32); 3]>,
    degree: u32,
}

/// Exponents are added in one place, so that none can wrap silently.
fn add_exponents(a: u32, b: u32) -> u32 {
    match a.checked_add(b) {
        Some(sum) => sum,
        None => panic!("an exponent exceeds u32::MAX"),
    }
}

impl Monomial {
    /// The empty product, 1.
    #[must_use]
    pub fn one() -> Self {
        Self::default()
    }

    /// A power of one symbol; the exponent 0 gives 1.
    #[must_use]
    pub fn power(symbol: Symbol, exponent: u32) -> Self {
        let mut factors = SmallVec::new();
        if exponent > 0 {
            factors.push((symbol, exponent));
        }
        Self { factors, degree: exponent }
    }

    /// The product of powers given in any order; a symbol may occur repeatedly.
    ///
    /// # Panics
    /// If the total degree exceeds `u32::MAX`.
    #[must_use]
    pub fn from_factors(factors: impl IntoIterator<Item = (Symbol, u32)>) -> Self {
        let mut sorted: SmallVec<[(Symbol, u32); 3]> = factors.into_iter().filter(|&(_, exponent)| exponent > 0).collect();
        sorted.sort_unstable_by_key(|&(symbol, _)| symbol);
        sorted.dedup_by(|next, kept| {
            let same = next.0 == kept.0;
            if same {
                kept.1 = add_exponents(kept.1, next.1);
            }
            same
        });
        let degree = sorted.iter().fold(0, |sum, &(_, exponent)| add_exponents(sum, exponent));
        Self { factors: sorted, degree }
    }

    /// Whether this is the empty product.
    #[must_use]
    pub fn is_one(&self) -> bool {
        self.factors.is_empty()
    }

    /// The sum of the exponents.
    #[must_use]
    pub fn degree(&self) -> u32 {
        self.degree
    }

    /// The exponent of a symbol, 0 if it does not occur.
    #[must_use]
    pub fn degree_in(&self, symbol: Symbol) -> u32 {
        self.factors.iter().find(|factor| factor.0 == symbol).map_or(0, |factor| factor.1)
    }

    /// The symbols with their exponents, sorted by symbol.
    #[must_use]
    pub fn factors(&self) -> &[(Symbol, u32)] {
        &self.factors
    }

    /// The monomial without any power of `symbol`.
    #[must_use]
    pub fn without(&self, symbol: Symbol) -> Self {
        let factors: SmallVec<_> = self.factors.iter().copied().filter(|factor| factor.0 != symbol).collect();
        Self { factors, degree: self.degree - self.degree_in(symbol) }
    }

    /// The monomial to a whole power.
    ///
    /// # Panics
    /// If the total degree exceeds `u32::MAX`.
    #[must_use]
    pub fn pow(&self, exponent: u32) -> Self {
        if exponent == 0 {
            return Self::one();
        }
        let Some(degree) = self.degree.checked_mul(exponent) else { panic!("an exponent exceeds u32::MAX") };
        // No single exponent is larger than the degree.
        Self { factors: self.factors.iter().map(|&(symbol, power)| (symbol, power * exponent)).collect(), degree }
    }
}

impl Mul for &Monomial {
    type Output = Monomial;

    fn mul(self, other: &Monomial) -> Monomial {
        if self.is_one() {
            return other.clone();
        }
        let mut factors = SmallVec::with_capacity(self.factors.len().max(other.factors.len()));
        let (mut a, mut b) = (self.factors.as_slice(), other.factors.as_slice());
        while let (Some(first), Some(second)) = (a.first(), b.first()) {
            match first.0.cmp(&second.0) {
                Ordering::Less => {
                    factors.push(*first);
                    a = &a[1..];
                }
                Ordering::Greater => {
                    factors.push(*second);
                    b = &b[1..];
                }
                Ordering::Equal => {
                    factors.push((first.0, add_exponents(first.1, second.1)));
                    (a, b) = (&a[1..], &b[1..]);
                }
            }
        }
        factors.extend_from_slice(a);
        factors.extend_from_slice(b);
        Monomial { factors, degree: add_exponents(self.degree, other.degree) }
    }
}

impl From<Symbol> for Monomial {
    fn from(symbol: Symbol) -> Self {
        Self::power(symbol, 1)
    }
}

impl Ord for Monomial {
    fn cmp(&self, other: &Self) -> Ordering {
        self.degree.cmp(&other.degree).then_with(|| {
            let differ = self.factors.iter().zip(&other.factors).find(|(a, b)| a != b);
            // Of equal degree, so neither is a proper beginning of the other.
            differ.map_or(Ordering::Equal, |(a, b)| b.0.cmp(&a.0).then(a.1.cmp(&b.1)))
        })
    }
}

impl PartialOrd for Monomial {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl fmt::Display for Monomial {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if self.is_one() {
            return f.write_str("1");
        }
        for (place, &(symbol, exponent)) in self.factors.iter().enumerate() {
            if place > 0 {
                f.write_str(" ")?;
            }
            match exponent {
                1 => write!(f, "{symbol}")?,
                _ => write!(f, "{symbol}^{exponent}")?,
            }
        }
        Ok(())
    }
}

impl fmt::Debug for Monomial {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        fmt::Display::fmt(self, f)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    const T1: Symbol = Symbol::new('t', Some(1));
    const T2: Symbol = Symbol::new('t', Some(2));

    fn monomial() -> impl Strategy<Value = Monomial> {
        proptest::collection::vec((0u32..4, 0u32..3), 0..5)
            .prop_map(|factors| Monomial::from_factors(factors.into_iter().map(|(index, power)| (Symbol::new('t', Some(index)), power))))
    }

    #[test]
    fn order_of_the_documentation() {
        let texts: Vec<String> = {
            let mut all: Vec<Monomial> =
                [(2, 0), (0, 0), (1, 1), (0, 2), (1, 0), (0, 1)].iter().map(|&(a, b)| Monomial::from_factors([(T2, b), (T1, a)])).collect();
            all.sort();
            all.iter().map(ToString::to_string).collect()
        };
        assert_eq!(texts, ["1", "t2", "t1", "t2^2", "t1 t2", "t1^2"]);
    }

    proptest! {
        #[test]
        fn order_agrees_with_multiplication(a in monomial(), b in monomial(), c in monomial()) {
            prop_assert_eq!(a.cmp(&b), (&a * &c).cmp(&(&b * &c)));
            prop_assert_eq!(&a * &b, &b * &a);
            prop_assert_eq!(&(&a * &b) * &c, &a * &(&b * &c));
            prop_assert_eq!(a.pow(3), &(&a * &a) * &a);
        }

        #[test]
        fn products_are_canonical(a in monomial(), b in monomial()) {
            let product = &a * &b;
            prop_assert!(product.factors().windows(2).all(|pair| pair[0].0 < pair[1].0));
            prop_assert!(product.factors().iter().all(|factor| factor.1 > 0));
            prop_assert_eq!(product.degree(), product.factors().iter().map(|factor| factor.1).sum::<u32>());
            prop_assert_eq!(product.without(T1).degree() + product.degree_in(T1), product.degree());
        }
    }
}
