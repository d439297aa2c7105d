//! Real roots of polynomials in one variable: counted and isolated, never approximated.

use num_bigint::BigInt;
use num_traits::{One, Signed, Zero};

use crate::affine::Interval;
use crate::curve::Curve;
use crate::error::Error;
use crate::exact::Rational;
use crate::exact::univariate::IntegerPolynomial;

/// A real root: the number itself where it is rational, else an open interval
/// that holds this root and no other, with rational ends.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum RootPlace {
    /// The root is this number.
    Exact(Rational),
    /// The root lies strictly between these two. It is irrational, or has a
    /// denominator above `2^64`.
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

/// The real roots of a polynomial strictly between two numbers.
///
/// Each square-free factor is split in the middle until Descartes's rule of
/// signs, on its Bernstein coefficients, leaves no doubt (Lane and Riesenfeld,
/// "Bounds on a polynomial", 1981; Basu, Pollack and Roy, *Algorithms in Real
/// Algebraic Geometry*, section 10.2).
///
/// ```
/// use casteljau::{Interval, Rational, RealRoots, RootPlace};
/// // (t - 1/2)^2 (t^2 - 2)
/// let coefficients = [(-1, 2), (2, 1), (-7, 4), (-1, 1), (1, 1)].map(|(n, d)| Rational::new(n, d));
/// let roots = RealRoots::inside(&coefficients, &Interval::new(0.into(), 2.into())?)?;
/// assert_eq!((roots.distinct(), roots.with_multiplicity()), (2, 3));
/// let places = roots.isolated();
/// assert_eq!(places[0].place, RootPlace::Exact(Rational::new(1, 2)));
/// assert!(matches!(places[1].place, RootPlace::Between(..)));
/// # Ok::<(), casteljau::Error>(())
/// ```
#[derive(Clone, Debug)]
pub struct RealRoots {
    factors: Vec<Factor>,
    /// What an interval is at most as long as when it is shown.
    resolution: Rational,
}

#[derive(Clone, Debug)]
struct Factor {
    polynomial: IntegerPolynomial,
    multiplicity: usize,
    roots: Vec<Isolated>,
}

#[derive(Clone, Debug)]
enum Isolated {
    Exact(Rational),
    /// The only root strictly between; the polynomial has this sign just above `low`.
    Between {
        low: Rational,
        high: Rational,
        sign: i8,
    },
}

impl RealRoots {
    /// The largest degree of a polynomial whose roots are counted.
    pub const MAX_DEGREE: usize = 512;
    /// The most halvings of the frame that separate two roots.
    pub const MAX_HALVINGS: usize = 1000;
    /// Intervals are shown at most this part of the frame long.
    const SHOWN: i64 = 256;
    /// Rational roots are recognized up to denominators of this many bits.
    const DENOMINATOR_BITS: u32 = 64;

    /// The roots in the open interval between the ends of a frame of the
    /// polynomial with these coefficients in ascending powers.
    ///
    /// # Errors
    /// [`Error::Unsupported`] for the zero polynomial, whose roots are all
    /// numbers; [`Error::TooLarge`] above [`RealRoots::MAX_DEGREE`], and if two
    /// roots are closer than [`RealRoots::MAX_HALVINGS`] halvings of the frame tell.
    pub fn inside(coefficients: &[Rational], frame: &Interval) -> Result<Self, Error> {
        let whole = IntegerPolynomial::primitive(Rational::clear_to_integers(coefficients));
        if whole.is_zero() {
            return Err(Error::Unsupported("the polynomial is zero everywhere: every number is a root".into()));
        }
        if whole.degree() > Self::MAX_DEGREE {
            return Err(Error::TooLarge { what: "degree of a polynomial whose roots are counted", limit: Self::MAX_DEGREE });
        }
        let frame = if frame.r() < frame.s() { frame.clone() } else { frame.reversed() };
        let mut factors = Vec::new();
        for (polynomial, multiplicity) in whole.square_free_factors() {
            let list = polynomial.coefficients().iter().cloned().map(Rational::from).collect();
            let segment = Curve::new(vec![list])?.segment(&frame)?;
            let mut roots = Vec::new();
            isolate(Rational::clear_to_integers(segment.coordinates()), frame.r().clone(), frame.s().clone(), &mut roots)?;
            factors.push(Factor { polynomial, multiplicity, roots });
        }
        Ok(Self { factors, resolution: (frame.s() - frame.r()) * Rational::new(1, Self::SHOWN) })
    }

    /// The number of different roots.
    #[must_use]
    pub fn distinct(&self) -> usize {
        self.factors.iter().map(|factor| factor.roots.len()).sum()
    }

    /// The number of roots, each as often as it counts.
    #[must_use]
    pub fn with_multiplicity(&self) -> usize {
        self.factors.iter().map(|factor| factor.multiplicity * factor.roots.len()).sum()
    }

    /// The roots in ascending order; intervals around irrational ones are
    /// disjoint from each other and from the rational ones.
    #[must_use]
    pub fn isolated(&self) -> Vec<Root> {
        self.isolated_within(&self.resolution)
    }

    /// The same with intervals at most so wide.
    #[must_use]
    pub fn isolated_within(&self, width: &Rational) -> Vec<Root> {
        let mut found: Vec<(Isolated, &Factor)> = Vec::new();
        for factor in &self.factors {
            for root in &factor.roots {
                let mut root = factor.rational(root).unwrap_or_else(|| root.clone());
                while root.length() > *width && width.is_positive() {
                    factor.halve(&mut root);
                }
                found.push((root, factor));
            }
        }
        // Different factors have no root in common, so halving ends.
        loop {
            found.sort_by(|a, b| a.0.ends().0.cmp(b.0.ends().0));
            let Some(position) = (1..found.len()).find(|&k| found[k - 1].0.ends().1 > found[k].0.ends().0) else { break };
            for (root, factor) in &mut found[position - 1..=position] {
                factor.halve(root);
            }
        }
        let place = |root| match root {
            Isolated::Exact(value) => RootPlace::Exact(value),
            Isolated::Between { low, high, .. } => RootPlace::Between(low, high),
        };
        found.into_iter().map(|(root, factor)| Root { place: place(root), multiplicity: factor.multiplicity }).collect()
    }
}

impl Isolated {
    fn ends(&self) -> (&Rational, &Rational) {
        match self {
            Self::Exact(value) => (value, value),
            Self::Between { low, high, .. } => (low, high),
        }
    }

    fn length(&self) -> Rational {
        let (low, high) = self.ends();
        high - low
    }
}

impl Factor {
    fn halve(&self, root: &mut Isolated) {
        let Isolated::Between { low, high, sign } = root else { return };
        let middle = (&*low + &*high) * Rational::new(1, 2);
        match self.polynomial.sign_at(&middle) {
            0 => *root = Isolated::Exact(middle),
            found if found == *sign => *low = middle,
            _ => *high = middle,
        }
    }

    /// The root as a number if it is rational. Its denominator divides the
    /// leading coefficient, and an interval shorter than the inverse square of
    /// a number holds at most one fraction with such a denominator, which is
    /// then the simplest one in it.
    fn rational(&self, root: &Isolated) -> Option<Isolated> {
        let leading = self.polynomial.coefficients().last().map_or_else(BigInt::one, Signed::abs);
        let largest = leading.min(BigInt::one() << RealRoots::DENOMINATOR_BITS);
        let short = Rational::from(&largest * &largest).recip()?;
        let mut root = root.clone();
        while root.length() >= short {
            self.halve(&mut root);
            if matches!(root, Isolated::Exact(_)) {
                return Some(root);
            }
        }
        let (low, high) = root.ends();
        let simplest = if low == high { low.clone() } else { simplest_between(low, high) };
        (self.polynomial.sign_at(&simplest) == 0).then_some(Isolated::Exact(simplest))
    }
}

/// The sign changes in a list, zeros dropped. For the Bernstein coefficients
/// of a polynomial on a frame this is the number of its roots strictly between
/// the ends, or an even number more (variation diminution).
pub(crate) fn sign_variations<'a>(signs: impl Iterator<Item = &'a BigInt>) -> usize {
    let mut previous: Option<bool> = None;
    signs.filter(|value| !value.is_zero()).fold(0, |count, value| {
        let changed = previous.is_some_and(|negative| negative != value.is_negative());
        previous = Some(value.is_negative());
        count + usize::from(changed)
    })
}

/// Splits in the middle until at most one sign change is left. The polynomial
/// is square-free, so this ends (the two-circle theorem).
fn isolate(bernstein: Vec<BigInt>, low: Rational, high: Rational, roots: &mut Vec<Isolated>) -> Result<(), Error> {
    let mut waiting = vec![(bernstein, low, high, 0)];
    while let Some((mut bernstein, low, high, halvings)) = waiting.pop() {
        match sign_variations(bernstein.iter()) {
            0 => {}
            1 => {
                let first = bernstein.iter().find(|value| !value.is_zero());
                let sign = if first.is_some_and(Signed::is_negative) { -1 } else { 1 };
                roots.push(Isolated::Between { low, high, sign });
            }
            _ if halvings == RealRoots::MAX_HALVINGS => {
                return Err(Error::TooLarge { what: "number of halvings that separate two roots", limit: RealRoots::MAX_HALVINGS });
            }
            _ => {
                let left = halves(&mut bernstein);
                let middle = (&low + &high) * Rational::new(1, 2);
                if bernstein[0].is_zero() {
                    roots.push(Isolated::Exact(middle.clone()));
                }
                // Parts without roots are not kept: near close roots there is one at every halving.
                let parts = [(left, low, middle.clone(), halvings + 1), (bernstein, middle, high, halvings + 1)];
                waiting.extend(parts.into_iter().filter(|(part, ..)| sign_variations(part.iter()) > 0));
            }
        }
    }
    Ok(())
}

/// De Casteljau's algorithm in the middle, without its divisions: the list ends
/// as its right half, the left half is returned, both over the same `2^m`.
fn halves(bernstein: &mut [BigInt]) -> Vec<BigInt> {
    let degree = bernstein.len() - 1;
    let mut left = Vec::with_capacity(degree + 1);
    left.push(&bernstein[0] << degree);
    for step in 1..=degree {
        for index in 0..=degree - step {
            let (head, tail) = bernstein.split_at_mut(index + 1);
            head[index] += &tail[0];
        }
        left.push(&bernstein[0] << (degree - step));
    }
    for (index, value) in bernstein.iter_mut().enumerate() {
        *value <<= index;
    }
    left
}

/// The fraction with the least denominator strictly between two numbers.
fn simplest_between(low: &Rational, high: &Rational) -> Rational {
    let floor = num_integer::Integer::div_floor(&low.numer(), &low.denom());
    let next = Rational::from(&floor + BigInt::one());
    if next < *high {
        // The integer nearest zero among those between.
        return if low.is_negative() && high.is_positive() { Rational::from(0) } else { next };
    }
    // Both lie in [floor, floor + 1]: the answer is floor + 1/x for the simplest x between the inverses.
    let floor = Rational::from(floor);
    let Some(lower) = (high - &floor).recip() else { return next };
    let x = match (low - &floor).recip() {
        Some(upper) => simplest_between(&lower, &upper),
        None => Rational::from(num_integer::Integer::div_floor(&lower.numer(), &lower.denom()) + BigInt::one()),
    };
    floor + x.recip().unwrap_or_else(Rational::zero)
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

    fn roots_of(coefficients: &[i64], low: i64, high: i64) -> RealRoots {
        let coefficients: Vec<Rational> = coefficients.iter().map(|&c| Rational::from(c)).collect();
        let frame = Interval::new(Rational::from(low), Rational::from(high)).expect("a frame");
        RealRoots::inside(&coefficients, &frame).expect("not the zero polynomial")
    }

    #[test]
    fn irrational_roots_are_isolated() {
        // (t^2 - 2)^2 (t - 1)
        let roots = roots_of(&[-4, 4, 4, -4, -1, 1], 3, -3).isolated();
        assert_eq!(roots.iter().map(|root| root.multiplicity).collect::<Vec<_>>(), [2, 1, 2]);
        assert_eq!(roots[1].place, RootPlace::Exact(Rational::from(1)));
        let RootPlace::Between(low, high) = &roots[2].place else { panic!("√2 is irrational") };
        let two = Rational::from(2);
        assert!(low * low < two && two < high * high && *low >= Rational::from(1));
    }

    #[test]
    fn the_ends_do_not_count() {
        assert_eq!(roots_of(&[0, -1, 0, 1], -1, 1).distinct(), 1);
        assert_eq!(roots_of(&[0, -1, 0, 1], 0, 1).distinct(), 0);
        assert_eq!(roots_of(&[5], -9, 9).isolated(), []);
        assert!(RealRoots::inside(&[Rational::from(0)], &Interval::unit()).is_err());
    }

    #[test]
    fn roots_that_are_nearly_the_same() {
        // (t - 1/3) (3^40 t - 3^39 - 1): two rational roots 3^-40 apart.
        let power = Rational::from(3).pow(40);
        let second = &Rational::new(1, 3) + &power.recip().expect("not zero");
        let product = times(&[Rational::new(-1, 3), Rational::from(1)], &[-&second, Rational::from(1)]);
        let roots = RealRoots::inside(&product, &Interval::unit()).expect("not zero");
        let places: Vec<RootPlace> = roots.isolated().into_iter().map(|root| root.place).collect();
        assert_eq!(places, [RootPlace::Exact(Rational::new(1, 3)), RootPlace::Exact(second)]);
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
            // The quadratic factor has no real root: its discriminant is negative.
            prop_assume!(quadratic.1 * quadratic.1 < 4 * quadratic.0 * quadratic.2);
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
            let inside: Vec<Root> = expected.into_iter()
                .filter(|(root, _)| low < *root && *root < high)
                .map(|(root, multiplicity)| Root { place: RootPlace::Exact(root), multiplicity })
                .collect();
            let roots = RealRoots::inside(&polynomial, &Interval::new(low, high).expect("a frame")).expect("not zero");
            prop_assert_eq!(roots.distinct(), inside.len());
            prop_assert_eq!(roots.with_multiplicity(), inside.iter().map(|root| root.multiplicity).sum::<usize>());
            prop_assert_eq!(roots.isolated(), inside);
        }
    }
}
