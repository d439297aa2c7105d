//! Real algebraic numbers: `a ± √d` where possible, else a polynomial and an
//! interval that holds one of its roots.

use std::fmt;

use num_bigint::BigInt;
use num_traits::{One, Signed, Zero};

use crate::affine::Interval;
use crate::error::Error;
use crate::exact::univariate::IntegerPolynomial;
use crate::exact::{Rational, Surd};
use crate::roots::{RealRoots, RootPlace};

/// A real root of a polynomial with rational coefficients.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum AlgebraicNumber {
    /// A number of degree one or two.
    Surd(Surd),
    /// Any other.
    Isolated(IsolatedRoot),
}

/// The only root of a square-free polynomial in an open interval.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct IsolatedRoot {
    polynomial: IntegerPolynomial,
    low: Rational,
    high: Rational,
}

impl IsolatedRoot {
    /// The coefficients of the polynomial in ascending powers, integers without a common factor.
    #[must_use]
    pub fn polynomial(&self) -> &[BigInt] {
        self.polynomial.coefficients()
    }

    /// The ends of the interval.
    #[must_use]
    pub fn interval(&self) -> (&Rational, &Rational) {
        (&self.low, &self.high)
    }

    /// Whether this is also a root of another polynomial.
    pub(crate) fn is_root_of(&self, coefficients: &[Rational]) -> bool {
        let other = primitive(coefficients);
        if other.is_zero() {
            return true;
        }
        // A common factor is square-free, and has no other root in the interval.
        let common = self.polynomial.gcd(&other);
        common.sign_at(&self.low) * common.sign_at(&self.high) < 0
    }

    /// The middle of the interval.
    pub(crate) fn middle(&self) -> Rational {
        (&self.low + &self.high) * Rational::new(1, 2)
    }
}

impl AlgebraicNumber {
    /// The most roots whose pairs are tried for a common quadratic factor.
    const MAX_PAIRED: usize = 48;
    /// Intervals are shown at most `1/SHOWN` long.
    const SHOWN: i64 = 1 << 20;

    /// The real roots of a polynomial, by its coefficients in ascending powers,
    /// each once and in ascending order; a constant has none. The intervals are
    /// disjoint from each other and from the other roots.
    ///
    /// A number `a + √d` is a root together with `a - √d`, so two of the roots
    /// have a rational sum and a rational product whose denominators divide the
    /// leading coefficient. Such pairs are recognized without factoring.
    ///
    /// ```
    /// use casteljau::{AlgebraicNumber, Rational};
    /// // (t^2 - 2) (t^3 - 2)
    /// let roots = AlgebraicNumber::real_roots(&[4, 0, -2, -2, 0, 1].map(Rational::from))?;
    /// let texts: Vec<String> = roots.iter().map(ToString::to_string).collect();
    /// assert_eq!((texts[0].as_str(), texts[2].as_str()), ("-√2", "√2"));
    /// assert!(texts[1].starts_with("the root of x^3 - 2 between"));
    /// # Ok::<(), casteljau::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`Error::Unsupported`] for the zero polynomial; [`Error::TooLarge`] as for [`RealRoots::inside`].
    pub fn real_roots(coefficients: &[Rational]) -> Result<Vec<Self>, Error> {
        let whole = primitive(coefficients);
        if whole.is_zero() {
            return Err(Error::Unsupported("the polynomial is zero everywhere: every number is a root".into()));
        }
        if whole.degree() > RealRoots::MAX_DEGREE {
            return Err(Error::TooLarge { what: "degree of a polynomial whose roots are counted", limit: RealRoots::MAX_DEGREE });
        }
        let radical = whole.square_free_part();
        if radical.degree() == 0 {
            return Ok(Vec::new());
        }
        if radical.degree() == 2 {
            return Ok(quadratic_roots(&radical).into_iter().map(Self::Surd).collect());
        }
        let bound = root_bound(&radical);
        let list: Vec<Rational> = radical.coefficients().iter().cloned().map(Rational::from).collect();
        let roots = RealRoots::inside(&list, &Interval::new(-&bound, bound.clone())?)?;
        let mut rest = radical.clone();
        let mut found: Vec<Self> = Vec::new();
        for root in roots.isolated() {
            if let RootPlace::Exact(value) = &root.place {
                rest = rest.divide(&linear(value)).unwrap_or(rest);
                found.push(Self::Surd(Surd::from(value)));
            }
        }
        let mut quadratics = Vec::new();
        if rest.degree() == 2 {
            quadratics.push(rest.clone());
        } else if rest.degree() > 2 {
            quadratics = quadratic_factors(&roots, &rest, &bound);
        }
        for factor in quadratics {
            rest = rest.divide(&factor).unwrap_or(rest);
            found.extend(quadratic_roots(&factor).into_iter().map(Self::Surd));
        }
        // What is left is at neither of these; the width keeps the intervals away from them.
        let mut width = Rational::new(1, Self::SHOWN);
        while rest.degree() > 0 {
            let isolated = roots.isolated_within(&width);
            let places = isolated.into_iter().filter_map(|root| match root.place {
                RootPlace::Between(low, high) => Some((low, high)),
                RootPlace::Exact(_) => None,
            });
            let others: Vec<(Rational, Rational)> = places.filter(|(low, high)| rest.sign_at(low) * rest.sign_at(high) < 0).collect();
            let apart = |low: &Rational, high: &Rational| {
                found.iter().all(|number| match number {
                    Self::Surd(surd) => *surd <= Surd::from(low) || *surd >= Surd::from(high),
                    Self::Isolated(_) => true,
                })
            };
            if others.iter().all(|(low, high)| apart(low, high)) {
                let isolated = others.into_iter().map(|(low, high)| IsolatedRoot { polynomial: rest.clone(), low, high });
                found.extend(isolated.map(Self::Isolated));
                break;
            }
            width = &width * &width;
        }
        // Intervals are apart from everything else, so any of their points will do.
        found.sort_by_cached_key(|number| match number {
            Self::Surd(surd) => surd.clone(),
            Self::Isolated(root) => Surd::from(root.middle()),
        });
        Ok(found)
    }

    /// Rational numbers with this one between them, or on both if it is rational.
    pub(crate) fn ends(&self) -> (Rational, Rational) {
        match self {
            Self::Surd(surd) => surd.enclosure(8),
            Self::Isolated(root) => (root.low.clone(), root.high.clone()),
        }
    }

    /// A rational number between two neighbouring roots of one polynomial, the smaller one first.
    pub(crate) fn between(one: &Self, other: &Self) -> Rational {
        let end = |number: &Self, upper: bool| match number {
            Self::Surd(surd) => surd.clone(),
            Self::Isolated(root) => Surd::from(if upper { &root.high } else { &root.low }),
        };
        let (low, high) = (end(one, true), end(other, false));
        // Intervals may touch; the point where they do is between the roots.
        Surd::between(&low, &high).unwrap_or_else(|| low.rational().clone())
    }
}

fn primitive(coefficients: &[Rational]) -> IntegerPolynomial {
    IntegerPolynomial::primitive(Rational::clear_to_integers(coefficients))
}

/// A number that no root exceeds in absolute value: one more than the largest
/// ratio of a coefficient to the leading one (Cauchy), rounded up to a power of two.
fn root_bound(polynomial: &IntegerPolynomial) -> Rational {
    let leading = polynomial.coefficients().last().map_or(1, |c| c.bits());
    let longest = polynomial.coefficients().iter().map(BigInt::bits).max().unwrap_or(1);
    Rational::from(BigInt::one() << (longest + 2 - leading.min(longest)))
}

/// The polynomial with one root.
fn linear(root: &Rational) -> IntegerPolynomial {
    IntegerPolynomial::primitive(vec![-root.numer(), root.denom()])
}

/// The real roots of a square-free quadratic, ascending.
fn quadratic_roots(polynomial: &IntegerPolynomial) -> Vec<Surd> {
    let [c, b, a] = polynomial.coefficients() else { return Vec::new() };
    let (a, b, c) = (Rational::from(a.clone()), Rational::from(b.clone()), Rational::from(c.clone()));
    let Some(inverse) = a.recip() else { return Vec::new() };
    let middle = b * &inverse * Rational::new(-1, 2);
    let square = &middle * &middle - c * inverse;
    [-1, 1].into_iter().filter_map(|sign| Surd::new(middle.clone(), sign, square.clone())).collect()
}

/// The quadratic factors with two real irrational roots.
fn quadratic_factors(roots: &RealRoots, rest: &IntegerPolynomial, bound: &Rational) -> Vec<IntegerPolynomial> {
    let leading = Rational::from(rest.coefficients().last().cloned().unwrap_or_else(BigInt::one)).abs();
    // Sums and products of two numbers that are known so well, times the leading coefficient, are known better than to 1/2.
    let fine = (Rational::from(16) * &leading * bound).recip().unwrap_or_default();
    let mut intervals: Vec<(Rational, Rational)> = Vec::new();
    for root in roots.isolated_within(&fine) {
        if let RootPlace::Between(low, high) = root.place {
            intervals.push((low, high));
        }
    }
    let mut factors = Vec::new();
    if intervals.len() > AlgebraicNumber::MAX_PAIRED {
        return factors;
    }
    let mut is_taken = vec![false; intervals.len()];
    for i in 0..intervals.len() {
        for j in i + 1..intervals.len() {
            if is_taken[i] || is_taken[j] {
                continue;
            }
            let [one, two] = [&intervals[i], &intervals[j]].map(|(low, high)| (low + high) * Rational::new(1, 2));
            let nearest = |value: Rational| {
                let shifted = value + Rational::new(1, 2);
                num_integer::Integer::div_floor(&shifted.numer(), &shifted.denom())
            };
            let (sum, product) = (nearest(&leading * (&one + &two)), nearest(&leading * (one * two)));
            let candidate = IntegerPolynomial::primitive(vec![product, -sum, leading.numer()]);
            // The candidate has these two roots, and not others near by.
            let has = |(low, high): &(Rational, Rational)| candidate.sign_at(low) * candidate.sign_at(high) < 0;
            if has(&intervals[i]) && has(&intervals[j]) && rest.divide(&candidate).is_some() {
                (is_taken[i], is_taken[j]) = (true, true);
                factors.push(candidate);
            }
        }
    }
    factors
}

impl fmt::Display for AlgebraicNumber {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Surd(surd) => write!(f, "{surd}"),
            Self::Isolated(root) => {
                let letter = crate::symbolic::Symbol::new('x', None);
                let terms = root.polynomial().iter().enumerate().filter(|(_, c)| !c.is_zero()).map(|(power, c)| {
                    let power = crate::symbolic::Monomial::from_factors([(letter, power as u32)].into_iter().filter(|factor| factor.1 > 0));
                    (power, Rational::from(c.clone()))
                });
                let polynomial = crate::symbolic::Polynomial::from_terms(terms);
                write!(f, "the root of {polynomial} between {} and {}", root.low, root.high)
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn times(a: &[Rational], b: &[Rational]) -> Vec<Rational> {
        let mut product = vec![Rational::zero(); a.len() + b.len() - 1];
        for (i, x) in a.iter().enumerate() {
            for (j, y) in b.iter().enumerate() {
                product[i + j] += x * y;
            }
        }
        product
    }

    proptest! {
        /// Plant quadratic factors, rational roots and a cubic factor, then ask for them.
        #[test]
        fn planted_numbers_are_found(
            quadratics in prop::collection::vec((1i64..5, -6i64..7, -9i64..10), 0..3),
            rationals in prop::collection::vec((-9i64..10, 1i64..5), 0..3),
            cubic: bool,
        ) {
            let mut polynomial = vec![Rational::from(1)];
            let mut expected: Vec<Surd> = Vec::new();
            for (a, b, c) in quadratics {
                polynomial = times(&polynomial, &[c, b, a].map(Rational::from));
                let (middle, square) = (Rational::new(-b, 2 * a), Rational::new(b * b - 4 * a * c, 4 * a * a));
                expected.extend([-1, 1].into_iter().filter_map(|sign| Surd::new(middle.clone(), sign, square.clone())));
            }
            for (n, d) in rationals {
                polynomial = times(&polynomial, &[-n, d].map(Rational::from));
                expected.push(Surd::from(Rational::new(n, d)));
            }
            if cubic {
                // x^3 - 3x + 1 has three real roots, none of degree two.
                polynomial = times(&polynomial, &[1, -3, 0, 1].map(Rational::from));
            }
            expected.sort();
            expected.dedup();
            let roots = AlgebraicNumber::real_roots(&polynomial).expect("not zero");
            let surds: Vec<Surd> = roots.iter().filter_map(|root| match root {
                AlgebraicNumber::Surd(surd) => Some(surd.clone()),
                AlgebraicNumber::Isolated(_) => None,
            }).collect();
            prop_assert_eq!(&surds, &expected);
            prop_assert_eq!(roots.len() - surds.len(), if cubic { 3 } else { 0 });
            for pair in roots.windows(2) {
                prop_assert!(pair[0].ends().0 <= pair[1].ends().1);
                let middle = Surd::from(AlgebraicNumber::between(&pair[0], &pair[1]));
                for (number, above) in [(&pair[0], false), (&pair[1], true)] {
                    match number {
                        AlgebraicNumber::Surd(surd) => prop_assert_eq!(*surd > middle, above),
                        AlgebraicNumber::Isolated(root) => {
                            prop_assert!(root.is_root_of(&polynomial) && !root.is_root_of(&[-2, 0, 1].map(Rational::from)));
                            let end = Surd::from(if above { root.interval().0 } else { root.interval().1 });
                            prop_assert!(end == middle || (end > middle) == above);
                        }
                    }
                }
            }
        }
    }
}
