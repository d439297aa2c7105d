//! Bernstein polynomials over a frame.

use crate::affine::Interval;
use crate::blossom::binomials;
use crate::curve::Curve;
use crate::error::Error;
use crate::exact::Rational;
use crate::segment::Segment;

/// The Bernstein polynomials of a degree `m` over a frame `(r, s)`:
///
/// `B_k(t) = C(m, k) ((s - t)/(s - r))^{m-k} ((t - r)/(s - r))^k`, `0 ≤ k ≤ m`.
///
/// They sum to 1, are non-negative on the frame, and are the coordinates of a
/// point of the curve in its control points (Gallier, *Curves and Surfaces in
/// Geometric Modeling*, section 18.1; CS348a, lecture 6, section 3.1).
///
/// ```
/// use casteljau::{Bernstein, Interval, Rational};
/// let basis = Bernstein::new(3, Interval::unit());
/// assert_eq!(basis.values(&Rational::new(1, 2)), [1, 3, 3, 1].map(|n| Rational::new(n, 8)));
/// assert_eq!(basis.maximum(1), Some((Rational::new(1, 3), Rational::new(4, 9))));
/// # Ok::<(), casteljau::Error>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Bernstein {
    degree: usize,
    frame: Interval,
}

impl Bernstein {
    /// The polynomials of degree `degree` over `frame`.
    #[must_use]
    pub fn new(degree: usize, frame: Interval) -> Self {
        Self { degree, frame }
    }

    /// The degree `m`; there are `m + 1` polynomials.
    #[must_use]
    pub fn degree(&self) -> usize {
        self.degree
    }

    /// The frame.
    #[must_use]
    pub fn frame(&self) -> &Interval {
        &self.frame
    }

    /// The polynomial `B_k` as a curve on the line.
    ///
    /// # Errors
    /// [`Error::WrongShape`] if `k` is larger than the degree.
    pub fn polynomial(&self, k: usize) -> Result<Curve, Error> {
        if k > self.degree {
            return Err(Error::WrongShape(format!(
                "there is no Bernstein polynomial {k} of degree {}; the last is {}",
                self.degree, self.degree
            )));
        }
        // Its control points are 1 at k and 0 elsewhere.
        let coordinates = (0..=self.degree).map(|i| Rational::from(i64::from(i == k))).collect();
        Segment::new(1, coordinates, self.frame.clone())?.curve()
    }

    /// The values `B_0(t), …, B_m(t)`.
    #[must_use]
    pub fn values(&self, t: &Rational) -> Vec<Rational> {
        let length = self.frame.s() - self.frame.r();
        let (low, high) = ((self.frame.s() - t) / &length, (t - self.frame.r()) / &length);
        let powers = |base: &Rational| {
            let mut powers = vec![Rational::from(1)];
            for k in 0..self.degree {
                powers.push(&powers[k] * base);
            }
            powers
        };
        let (low, high) = (powers(&low), powers(&high));
        binomials(self.degree).into_iter().enumerate().map(|(k, binomial)| binomial * &low[self.degree - k] * &high[k]).collect()
    }

    /// Where `B_k` is largest on the frame, `r + (k/m)(s - r)`, and how large;
    /// `None` for the constant of degree 0 and where there is no `B_k`.
    #[must_use]
    pub fn maximum(&self, k: usize) -> Option<(Rational, Rational)> {
        if self.degree == 0 || k > self.degree {
            return None;
        }
        let place = self.frame.at(&Rational::new(k as i64, self.degree as i64));
        let value = self.values(&place).swap_remove(k);
        Some((place, value))
    }
}
