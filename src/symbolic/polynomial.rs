//! Sparse polynomials in named variables.

use std::collections::BTreeSet;
use std::fmt;
use std::ops::{Add, AddAssign, Mul, MulAssign, Neg, Sub, SubAssign};

use num_traits::{One, Signed, Zero};

use super::{Monomial, Symbol};
use crate::exact::Rational;

/// A polynomial with rational coefficients in any number of named variables.
///
/// Canonical form: terms sorted from the largest [`Monomial`] to the smallest,
/// each monomial once, no coefficient zero; the zero polynomial has no terms.
/// Equal polynomials are equal values.
///
/// ```
/// use casteljau::{Polynomial, Rational, Symbol};
/// let t = Polynomial::from(Symbol::new('t', None));
/// let p = (&t * &t).scale(&Rational::new(3, 4)) - &t;
/// assert_eq!(p.to_string(), "3/4 t^2 - t");
/// assert_eq!(p.substitute(Symbol::new('t', None), &Polynomial::from(Rational::from(4))).as_rational(), Some(Rational::from(8)));
/// ```
#[derive(Clone, PartialEq, Eq, Hash, Default)]
pub struct Polynomial {
    terms: Vec<(Monomial, Rational)>,
}

impl Polynomial {
    /// The polynomial with one term, or zero if the coefficient is zero.
    #[must_use]
    pub fn term(monomial: Monomial, coefficient: Rational) -> Self {
        let terms = if coefficient.is_zero() { Vec::new() } else { vec![(monomial, coefficient)] };
        Self { terms }
    }

    /// The sum of terms given in any order; monomials may repeat. Sorting takes
    /// n log n comparisons.
    #[must_use]
    pub fn from_terms(terms: impl IntoIterator<Item = (Monomial, Rational)>) -> Self {
        let mut sorted: Vec<_> = terms.into_iter().collect();
        sorted.sort_by(|a, b| b.0.cmp(&a.0));
        sorted.dedup_by(|next, kept| {
            let same = next.0 == kept.0;
            if same {
                kept.1 += &next.1;
            }
            same
        });
        sorted.retain(|term| !term.1.is_zero());
        Self { terms: sorted }
    }

    /// The polynomial `Σ coefficients[k] symbol^k`. The coefficients may contain
    /// the symbol themselves.
    #[must_use]
    pub fn from_coefficients(symbol: Symbol, coefficients: &[Self]) -> Self {
        Self::from_terms((0u32..).zip(coefficients).flat_map(|(power, coefficient)| {
            let factor = Monomial::power(symbol, power);
            coefficient.terms.iter().map(move |(monomial, value)| (monomial * &factor, value.clone()))
        }))
    }

    /// The terms, from the largest monomial to the smallest.
    pub fn terms(&self) -> impl ExactSizeIterator<Item = (&Monomial, &Rational)> + DoubleEndedIterator + Clone {
        self.terms.iter().map(|(monomial, coefficient)| (monomial, coefficient))
    }

    /// The number of terms.
    #[must_use]
    pub fn len(&self) -> usize {
        self.terms.len()
    }

    /// Whether there is no term, which makes the polynomial zero.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.terms.is_empty()
    }

    /// The value of a constant polynomial, `None` if a symbol occurs.
    #[must_use]
    pub fn as_rational(&self) -> Option<Rational> {
        match self.terms.as_slice() {
            [] => Some(Rational::zero()),
            [(monomial, coefficient)] if monomial.is_one() => Some(coefficient.clone()),
            _ => None,
        }
    }

    /// The coefficient of one monomial, zero if it does not occur.
    #[must_use]
    pub fn coefficient(&self, monomial: &Monomial) -> Rational {
        match self.terms.binary_search_by(|term| monomial.cmp(&term.0)) {
            Ok(place) => self.terms[place].1.clone(),
            Err(_) => Rational::zero(),
        }
    }

    /// The symbols that occur, sorted.
    #[must_use]
    pub fn symbols(&self) -> Vec<Symbol> {
        let all: BTreeSet<Symbol> = self.terms.iter().flat_map(|term| term.0.factors()).map(|factor| factor.0).collect();
        all.into_iter().collect()
    }

    /// The largest total degree of a term; 0 for constants, zero included.
    #[must_use]
    pub fn total_degree(&self) -> u32 {
        self.terms.first().map_or(0, |term| term.0.degree())
    }

    /// The largest exponent of a symbol; 0 if it does not occur.
    #[must_use]
    pub fn degree_in(&self, symbol: Symbol) -> u32 {
        self.terms.iter().map(|term| term.0.degree_in(symbol)).max().unwrap_or(0)
    }

    /// The coefficients of the powers of a symbol, ascending: degree + 1 of
    /// them, at least one.
    #[must_use]
    pub fn coefficients_in(&self, symbol: Symbol) -> Vec<Self> {
        let mut coefficients = vec![Self::default(); self.degree_in(symbol) as usize + 1];
        for (monomial, coefficient) in &self.terms {
            // Terms with the same power of the symbol stay in order without it.
            coefficients[monomial.degree_in(symbol) as usize].terms.push((monomial.without(symbol), coefficient.clone()));
        }
        coefficients
    }

    /// The polynomial times a number.
    #[must_use]
    pub fn scale(&self, factor: &Rational) -> Self {
        if factor.is_zero() {
            return Self::default();
        }
        Self { terms: self.terms.iter().map(|(monomial, coefficient)| (monomial.clone(), coefficient * factor)).collect() }
    }

    /// The polynomial times a monomial.
    ///
    /// # Panics
    /// If an exponent exceeds `u32::MAX`.
    #[must_use]
    pub fn times_monomial(&self, factor: &Monomial) -> Self {
        Self { terms: self.terms.iter().map(|(monomial, coefficient)| (monomial * factor, coefficient.clone())).collect() }
    }

    /// The polynomial to a whole power; the power 0 is 1, of zero too.
    ///
    /// # Panics
    /// If an exponent exceeds `u32::MAX`.
    #[must_use]
    pub fn pow(&self, exponent: u32) -> Self {
        match (self.terms.as_slice(), exponent) {
            (_, 0) => Self::one(),
            ([], _) => Self::zero(),
            (_, 1) => self.clone(),
            ([(monomial, coefficient)], _) => Self { terms: vec![(monomial.pow(exponent), coefficient.pow(exponent))] },
            ([first, second], _) => binomial_power(first, second, exponent),
            // Multiplying by the base keeps one factor short; squaring would multiply long by long.
            _ => (1..exponent).fold(self.clone(), |power, _| &power * self),
        }
    }

    /// The polynomial with `value` in place of a symbol.
    #[must_use]
    pub fn substitute(&self, symbol: Symbol, value: &Self) -> Self {
        let mut coefficients = self.coefficients_in(symbol).into_iter().rev();
        let leading = coefficients.next().unwrap_or_default();
        coefficients.fold(leading, |sum, coefficient| sum * value + coefficient)
    }

    /// The polynomial with values in place of several symbols, all at once: a
    /// symbol that occurs in a value is not replaced again.
    #[must_use]
    pub fn substitute_all(&self, values: &[(Symbol, Self)]) -> Self {
        let mut powers: Vec<Vec<Self>> = values.iter().map(|_| vec![Self::one()]).collect();
        let mut terms = Vec::new();
        for (monomial, coefficient) in &self.terms {
            let mut kept = monomial.clone();
            let mut product = Self::one();
            for ((symbol, value), powers) in values.iter().zip(&mut powers) {
                let exponent = kept.degree_in(*symbol) as usize;
                if exponent == 0 {
                    continue;
                }
                kept = kept.without(*symbol);
                while powers.len() <= exponent {
                    let next = powers.last().map_or_else(Self::one, |last| last * value);
                    powers.push(next);
                }
                product = &product * &powers[exponent];
            }
            terms.extend(product.terms.into_iter().map(|(factor, value)| (&factor * &kept, value * coefficient)));
        }
        Self::from_terms(terms)
    }

    /// The polynomial with one symbol in place of another.
    #[must_use]
    pub fn rename(&self, from: Symbol, to: Symbol) -> Self {
        self.map_symbols(|symbol| if symbol == from { to } else { symbol })
    }

    /// The polynomial with other symbols in place of some, all at once.
    #[cfg(feature = "cli")]
    #[must_use]
    pub(crate) fn renamed(&self, pairs: &[(Symbol, Symbol)]) -> Self {
        self.map_symbols(|symbol| pairs.iter().find(|pair| pair.0 == symbol).map_or(symbol, |pair| pair.1))
    }

    /// The polynomial with two symbols exchanged.
    #[must_use]
    pub fn swap(&self, a: Symbol, b: Symbol) -> Self {
        self.map_symbols(|symbol| match symbol {
            _ if symbol == a => b,
            _ if symbol == b => a,
            _ => symbol,
        })
    }

    fn map_symbols(&self, map: impl Fn(Symbol) -> Symbol) -> Self {
        Self::from_terms(self.terms.iter().map(|(monomial, coefficient)| {
            let factors = monomial.factors().iter().map(|&(symbol, exponent)| (map(symbol), exponent));
            (Monomial::from_factors(factors), coefficient.clone())
        }))
    }

    /// The one symbol that occurs, if there is exactly one.
    fn only_symbol(&self) -> Option<Symbol> {
        let (symbol, _) = *self.terms.first()?.0.factors().first()?;
        let only = |term: &(Monomial, Rational)| term.0.factors().iter().all(|factor| factor.0 == symbol);
        self.terms.iter().all(only).then_some(symbol)
    }
}

/// `(first + second)^exponent` by the binomial theorem.
fn binomial_power(first: &(Monomial, Rational), second: &(Monomial, Rational), exponent: u32) -> Polynomial {
    // With b = second/first, the coefficients follow from each other by (n - k)/(k + 1) b.
    let ratio = &second.1 / &first.1;
    let mut coefficient = first.1.pow(exponent);
    let mut terms = Vec::with_capacity(exponent as usize + 1);
    for k in 0..=exponent {
        terms.push((&first.0.pow(exponent - k) * &second.0.pow(k), coefficient.clone()));
        coefficient = coefficient * &ratio * Rational::new(i64::from(exponent - k), i64::from(k) + 1);
    }
    // first > second, so the products descend.
    Polynomial { terms }
}

/// The sum by one pass over both, moving the terms.
fn add(mut a: Polynomial, mut b: Polynomial) -> Polynomial {
    // Appending costs nothing for what is already there: terms may come one by one, in order.
    match (a.terms.last(), b.terms.first()) {
        (None, _) => return b,
        (_, None) => return a,
        (Some(last), Some(first)) if last.0 > first.0 => {
            a.terms.append(&mut b.terms);
            return a;
        }
        _ => {}
    }
    let mut terms = Vec::with_capacity(a.terms.len() + b.terms.len());
    let mut rest = b.terms.into_iter().peekable();
    for (monomial, coefficient) in a.terms {
        while let Some(term) = rest.next_if(|term| term.0 > monomial) {
            terms.push(term);
        }
        match rest.next_if(|term| term.0 == monomial) {
            None => terms.push((monomial, coefficient)),
            Some(term) => {
                let sum = coefficient + term.1;
                if !sum.is_zero() {
                    terms.push((monomial, sum));
                }
            }
        }
    }
    terms.extend(rest);
    Polynomial { terms }
}

fn multiply(a: &Polynomial, b: &Polynomial) -> Polynomial {
    let (short, long) = if a.len() <= b.len() { (a, b) } else { (b, a) };
    match short.terms.as_slice() {
        [] => return Polynomial::default(),
        [(monomial, coefficient)] if monomial.is_one() => return long.scale(coefficient),
        _ => {}
    }
    if let (Some(symbol), Some(other)) = (short.only_symbol(), long.only_symbol()) {
        let length = short.total_degree() as usize + long.total_degree() as usize + 1;
        if symbol == other && length / 2 <= short.len().saturating_mul(long.len()) {
            return convolve(short, long, symbol, length);
        }
    }
    multiply_rows(&short.terms, long)
}

/// The product with the terms of `short`, at least one. Multiplication by one
/// term keeps the order of monomials, so the rows only have to be merged, pair
/// by pair.
fn multiply_rows(short: &[(Monomial, Rational)], long: &Polynomial) -> Polynomial {
    match short {
        [(monomial, coefficient)] => Polynomial { terms: long.terms.iter().map(|(m, c)| (m * monomial, c * coefficient)).collect() },
        _ => {
            let (first, second) = short.split_at(short.len() / 2);
            add(multiply_rows(first, long), multiply_rows(second, long))
        }
    }
}

/// The product of two polynomials in one symbol, `length` - 1 its degree.
fn convolve(a: &Polynomial, b: &Polynomial, symbol: Symbol, length: usize) -> Polynomial {
    let mut coefficients = vec![Rational::zero(); length];
    for (m, c) in &a.terms {
        for (n, d) in &b.terms {
            coefficients[m.degree() as usize + n.degree() as usize] += c * d;
        }
    }
    let terms = (0u32..).zip(coefficients).filter(|(_, coefficient)| !coefficient.is_zero());
    let mut terms: Vec<_> = terms.map(|(power, coefficient)| (Monomial::power(symbol, power), coefficient)).collect();
    terms.reverse();
    Polynomial { terms }
}

/// Sums move their terms; products only read them.
macro_rules! operators {
    ($($operator:ident $method:ident $assign:ident $assign_method:ident $owned:expr, $borrowed:expr;)*) => {$(
        impl $operator<&Polynomial> for &Polynomial {
            type Output = Polynomial;
            fn $method(self, other: &Polynomial) -> Polynomial { $borrowed(self, other) }
        }
        impl $operator<Polynomial> for &Polynomial {
            type Output = Polynomial;
            fn $method(self, other: Polynomial) -> Polynomial { $owned(self.clone(), other) }
        }
        impl $operator<&Polynomial> for Polynomial {
            type Output = Polynomial;
            fn $method(self, other: &Polynomial) -> Polynomial { $owned(self, other.clone()) }
        }
        impl $operator for Polynomial {
            type Output = Polynomial;
            fn $method(self, other: Polynomial) -> Polynomial { $owned(self, other) }
        }
        impl $assign<&Polynomial> for Polynomial {
            fn $assign_method(&mut self, other: &Polynomial) { *self = $owned(std::mem::take(self), other.clone()); }
        }
        impl $assign for Polynomial {
            fn $assign_method(&mut self, other: Polynomial) { *self = $owned(std::mem::take(self), other); }
        }
    )*};
}

operators! {
    Add add AddAssign add_assign add, |a: &Polynomial, b: &Polynomial| add(a.clone(), b.clone());
    Sub sub SubAssign sub_assign |a, b: Polynomial| add(a, -b), |a: &Polynomial, b: &Polynomial| add(a.clone(), -b);
    Mul mul MulAssign mul_assign |a, b| multiply(&a, &b), multiply;
}

impl Neg for Polynomial {
    type Output = Self;
    fn neg(mut self) -> Self {
        for term in &mut self.terms {
            term.1 = -&term.1;
        }
        self
    }
}

impl Neg for &Polynomial {
    type Output = Polynomial;
    fn neg(self) -> Polynomial {
        -self.clone()
    }
}

impl Zero for Polynomial {
    fn zero() -> Self {
        Self::default()
    }
    fn is_zero(&self) -> bool {
        self.terms.is_empty()
    }
}

impl One for Polynomial {
    fn one() -> Self {
        Self::from(Rational::one())
    }
}

impl From<Rational> for Polynomial {
    fn from(value: Rational) -> Self {
        Self::term(Monomial::one(), value)
    }
}

impl From<Symbol> for Polynomial {
    fn from(symbol: Symbol) -> Self {
        Self::term(Monomial::from(symbol), Rational::one())
    }
}

impl fmt::Display for Polynomial {
    /// The terms in their order, as in `3/4 t^3 - 3/2 t^2 + 1`.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if self.is_zero() {
            return f.write_str("0");
        }
        for (place, (monomial, coefficient)) in self.terms.iter().enumerate() {
            f.write_str(match (place, coefficient.is_negative()) {
                (0, false) => "",
                (0, true) => "-",
                (_, false) => " + ",
                (_, true) => " - ",
            })?;
            let size = coefficient.abs();
            match (size.is_one(), monomial.is_one()) {
                (true, false) => write!(f, "{monomial}")?,
                (_, true) => write!(f, "{size}")?,
                (false, false) => write!(f, "{size} {monomial}")?,
            }
        }
        Ok(())
    }
}

impl fmt::Debug for Polynomial {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        fmt::Display::fmt(self, f)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    const T: Symbol = Symbol::new('t', None);
    const U: Symbol = Symbol::new('u', None);
    const A: Symbol = Symbol::new('a', None);

    fn polynomial() -> impl Strategy<Value = Polynomial> {
        let term = (0usize..3, 0u32..4, 0usize..3, 0u32..3, -4i64..5, 1i64..4);
        proptest::collection::vec(term, 0..6).prop_map(|terms| {
            let names = [T, U, A];
            Polynomial::from_terms(terms.into_iter().map(|(first, power, second, other, numer, denom)| {
                (Monomial::from_factors([(names[first], power), (names[second], other)]), Rational::new(numer, denom))
            }))
        })
    }

    fn canonical(p: &Polynomial) -> bool {
        p.terms.windows(2).all(|pair| pair[0].0 > pair[1].0) && p.terms.iter().all(|term| !term.1.is_zero())
    }

    proptest! {
        #[test]
        fn ring_laws(a in polynomial(), b in polynomial(), c in polynomial()) {
            prop_assert!([&a + &b, &a - &b, &a * &b, -&a, a.pow(3)].iter().all(canonical));
            prop_assert_eq!(&a + &b, &b + &a);
            prop_assert_eq!(&a * &b, &b * &a);
            prop_assert_eq!(&(&a * &b) * &c, &a * &(&b * &c));
            prop_assert_eq!(&a * &(&b + &c), &a * &b + &a * &c);
            prop_assert_eq!(&a - &a, Polynomial::zero());
            prop_assert_eq!(&a + &(-&b), &a - &b);
            prop_assert_eq!(a.pow(3), &(&a * &a) * &a);
            prop_assert_eq!(a.pow(0), Polynomial::one());
            prop_assert_eq!(a.scale(&Rational::new(2, 3)), &a * &Polynomial::from(Rational::new(2, 3)));
        }

        #[test]
        fn substitution_is_a_homomorphism(a in polynomial(), b in polynomial(), value in polynomial()) {
            prop_assert_eq!((&a * &b).substitute(T, &value), a.substitute(T, &value) * b.substitute(T, &value));
            prop_assert_eq!((&a + &b).substitute(T, &value), a.substitute(T, &value) + b.substitute(T, &value));
            prop_assert_eq!(a.substitute_all(&[(T, value.clone())]), a.substitute(T, &value));
            prop_assert_eq!(a.substitute_all(&[(T, Polynomial::from(U)), (U, Polynomial::from(T))]), a.swap(T, U));
            prop_assert_eq!(a.substitute(T, &Polynomial::from(U)), a.rename(T, U));
        }

        #[test]
        fn coefficients_there_and_back(a in polynomial()) {
            let coefficients = a.coefficients_in(T);
            prop_assert_eq!(coefficients.len(), a.degree_in(T) as usize + 1);
            prop_assert!(coefficients.iter().all(canonical));
            prop_assert_eq!(Polynomial::from_coefficients(T, &coefficients), a);
        }

        /// The two ways of multiplying agree with adding row by row.
        #[test]
        fn long_products(a in proptest::collection::vec(-3i64..4, 1..60), b in proptest::collection::vec(-3i64..4, 1..60)) {
            let dense = |values: &[i64], symbol| Polynomial::from_coefficients(
                symbol,
                &values.iter().map(|&value| Polynomial::from(Rational::from(value))).collect::<Vec<_>>(),
            );
            let (p, q) = (dense(&a, T), dense(&b, T));
            let product = &p * &q;
            prop_assert!(canonical(&product));
            let slow = p.terms().fold(Polynomial::zero(), |sum, (m, c)| sum + q.times_monomial(m).scale(c));
            prop_assert_eq!(&product, &slow);
            let mixed = &p * &dense(&b, U);
            prop_assert!(canonical(&mixed));
            prop_assert_eq!(mixed.rename(U, T), product);
        }
    }

    #[test]
    fn degrees_and_constants() {
        let zero = Polynomial::zero();
        assert_eq!(
            (zero.total_degree(), zero.degree_in(T), zero.coefficients_in(T).len(), zero.as_rational()),
            (0, 0, 1, Some(Rational::zero()))
        );
        let p = Polynomial::from_terms([
            (Monomial::from_factors([(T, 2), (A, 1)]), Rational::from(1)),
            (Monomial::power(T, 1), Rational::new(-1, 2)),
            (Monomial::one(), Rational::from(5)),
        ]);
        assert_eq!(p.to_string(), "a t^2 - 1/2 t + 5");
        assert_eq!((p.total_degree(), p.degree_in(T), p.as_rational(), p.len()), (3, 2, None, 3));
        assert_eq!(p.symbols(), [A, T]);
        assert_eq!(p.coefficient(&Monomial::power(T, 1)), Rational::new(-1, 2));
        assert_eq!(p.coefficient(&Monomial::power(T, 9)), Rational::zero());
    }
}
