//! Quadrics: whether a polynomial surface lies in one, and in which.

mod form;

pub use form::QuadricClass;

use std::collections::BTreeMap;

use num_bigint::BigInt;
use num_traits::{Signed, Zero};

use crate::error::Error;
use crate::exact::Rational;
use crate::exact::univariate::IntegerPolynomial;
use crate::surface::Surface;
use crate::symbolic::{Monomial, Polynomial, Symbol};

/// The names of the monomials of a quadric, in the order of their coefficients.
pub const QUADRIC_MONOMIALS: [&str; 10] = ["1", "x", "y", "z", "x2", "xy", "xz", "y2", "yz", "z2"];

/// The factors of the monomials, where 0 is the constant 1 and 1 to 3 are the coordinates.
const FACTORS: [(usize, usize); 10] = [(0, 0), (0, 1), (0, 2), (0, 3), (1, 1), (1, 2), (1, 3), (2, 2), (2, 3), (3, 3)];

/// The quadrics that contain a polynomial surface of space.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct QuadricSurface {
    /// The dimension of the smallest affine space that contains the surface.
    pub affine_span: usize,
    /// The dimension of the space of polynomials of degree two at most that vanish on it.
    pub quadrics: usize,
    /// What the surface is, or what contains it.
    pub class: QuadricClass,
    /// The coefficients of the quadric, by [`QUADRIC_MONOMIALS`], where it is
    /// the only one and the surface spans space: integers without a common
    /// factor, the last that is not zero positive.
    pub quadric: Option<[BigInt; 10]>,
}

type Bivariate = BTreeMap<(usize, usize), Rational>;

impl QuadricSurface {
    /// The most terms that the three coordinates may have together.
    pub const MAX_TERMS: usize = 600;
    /// The most terms times the bits of the longest coefficient.
    pub const MAX_BITS: usize = 1 << 19;

    /// What quadric a surface of space lies in.
    ///
    /// ```
    /// use casteljau::{QuadricClass, QuadricSurface, Rational, Surface};
    /// let q = Rational::from;
    /// // (u, v, u v), the bilinear patch
    /// let patch = Surface::tensor(vec![vec![(1, 0, q(1))], vec![(0, 1, q(1))], vec![(1, 1, q(1))]])?;
    /// let surface = QuadricSurface::of(&patch)?;
    /// assert_eq!(surface.class, QuadricClass::HyperbolicParaboloid);
    /// assert_eq!(surface.equation().as_deref(), Some("x y - z = 0"));
    /// # Ok::<(), casteljau::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`Error::Unsupported`] unless there are three coordinates; [`Error::TooLarge`] beyond
    /// [`QuadricSurface::MAX_TERMS`] or [`QuadricSurface::MAX_BITS`].
    pub fn of(surface: &Surface) -> Result<Self, Error> {
        if surface.dimension() != 3 {
            return Err(Error::Unsupported(format!(
                "a quadric is a surface of space: it needs three coordinates, found {}",
                surface.dimension()
            )));
        }
        let [x, y, z] = [0, 1, 2].map(|index| {
            let terms = surface.terms(index).into_iter();
            terms.map(|(h, k, c)| ((h, k), c.clone())).collect::<Bivariate>()
        });
        if x.len() + y.len() + z.len() > Self::MAX_TERMS {
            return Err(Error::TooLarge { what: "number of terms of a surface whose quadric is computed", limit: Self::MAX_TERMS });
        }
        let terms = || [&x, &y, &z].into_iter().flat_map(BTreeMap::values);
        if terms().count() as u64 * terms().map(Rational::bits).max().unwrap_or(0) > Self::MAX_BITS as u64 {
            return Err(Error::TooLarge { what: "length of a surface whose quadric is computed, counted in bits,", limit: Self::MAX_BITS });
        }
        let one = Bivariate::from([((0, 0), Rational::from(1))]);
        let parts = [one, x, y, z];
        let composed = FACTORS.map(|(i, j)| times(&parts[i], &parts[j]));
        let affine_span = 4 - null_space(&composed[..4]).len();
        // The constant counts in the rank, but not in the dimension.
        let affine_span = affine_span - 1;
        let mut vanishing = null_space(&composed);
        let quadrics = vanishing.len();
        let flat = |class| Ok(Self { affine_span, quadrics, class, quadric: None });
        match affine_span {
            0 => return flat(QuadricClass::Point),
            1 => return flat(QuadricClass::Line),
            2 => return flat(QuadricClass::Plane),
            _ => {}
        }
        if is_collapsed(&parts[1..]) {
            return flat(QuadricClass::Curve);
        }
        let Some(coefficients) = vanishing.pop() else { return flat(QuadricClass::NotAQuadric) };
        let coefficients = primitive(&coefficients);
        Ok(Self {
            affine_span,
            quadrics,
            class: QuadricClass::of(&coefficients.each_ref().map(|c| Rational::from(c.clone()))),
            quadric: Some(coefficients),
        })
    }

    /// The equation of the quadric, such as `x y - z = 0`, the terms of degree two first.
    #[must_use]
    pub fn equation(&self) -> Option<String> {
        Some(format!("{} = 0", self.polynomial()?))
    }

    /// The polynomial of the quadric in the letters x, y, z.
    #[must_use]
    pub fn polynomial(&self) -> Option<Polynomial> {
        let letters = ['x', 'y', 'z'].map(|letter| Symbol::new(letter, None));
        let monomial = |(i, j): (usize, usize)| {
            let power = |index: usize| index.checked_sub(1).map(|index| (letters[index], 1));
            &Monomial::from_factors(power(i)) * &Monomial::from_factors(power(j))
        };
        let terms = FACTORS.into_iter().zip(self.quadric.as_ref()?);
        Some(Polynomial::from_terms(terms.map(|(factors, c)| (monomial(factors), Rational::from(c.clone())))))
    }
}

fn times(a: &Bivariate, b: &Bivariate) -> Bivariate {
    let mut product = Bivariate::new();
    for ((h, k), x) in a {
        for ((i, j), y) in b {
            *product.entry((h + i, k + j)).or_default() += x * y;
        }
    }
    product.retain(|_, c| !c.is_zero());
    product
}

fn primitive(coefficients: &[Rational]) -> [BigInt; 10] {
    let cleared = IntegerPolynomial::primitive(Rational::clear_to_integers(coefficients));
    let is_negative = cleared.coefficients().last().is_some_and(Signed::is_negative);
    std::array::from_fn(|k| {
        let c = cleared.coefficients().get(k).cloned().unwrap_or_default();
        if is_negative { -c } else { c }
    })
}

/// A basis of the combinations of polynomials that are zero: the weights of each.
fn null_space(polynomials: &[Bivariate]) -> Vec<Vec<Rational>> {
    let count = polynomials.len();
    let zero = Rational::zero();
    // Every monomial is a linear condition on the weights; the rows are kept reduced.
    let mut rows: Vec<(usize, Vec<Rational>)> = Vec::new();
    let mut monomials: Vec<&(usize, usize)> = polynomials.iter().flat_map(BTreeMap::keys).collect();
    monomials.sort();
    monomials.dedup();
    for monomial in monomials {
        let mut row: Vec<Rational> = polynomials.iter().map(|polynomial| polynomial.get(monomial).unwrap_or(&zero).clone()).collect();
        for (pivot, known) in &rows {
            eliminate(&mut row, known, *pivot);
        }
        let Some(pivot) = row.iter().position(|c| !c.is_zero()) else { continue };
        let inverse = row[pivot].recip().unwrap_or_default();
        row.iter_mut().for_each(|c| *c = &*c * &inverse);
        for (_, known) in &mut rows {
            eliminate(known, &row, pivot);
        }
        rows.push((pivot, row));
    }
    let is_pivot = |column: usize| rows.iter().any(|(pivot, _)| *pivot == column);
    (0..count)
        .filter(|&column| !is_pivot(column))
        .map(|free| {
            let mut weights = vec![Rational::zero(); count];
            weights[free] = Rational::from(1);
            for (pivot, row) in &rows {
                weights[*pivot] = -&row[free];
            }
            weights
        })
        .collect()
}

/// Subtracts the multiple of a row with a 1 at `pivot` that makes the entry there zero.
fn eliminate(row: &mut [Rational], known: &[Rational], pivot: usize) {
    if row[pivot].is_zero() {
        return;
    }
    let factor = row[pivot].clone();
    for (c, k) in row.iter_mut().zip(known) {
        *c -= &factor * k;
    }
}

/// Whether the surface is a curve: its two derivatives are parallel everywhere.
fn is_collapsed(coordinates: &[Bivariate]) -> bool {
    let derivative = |polynomial: &Bivariate, by_u: bool| -> Bivariate {
        let terms = polynomial.iter().filter(|((h, k), _)| if by_u { *h > 0 } else { *k > 0 });
        terms.map(|((h, k), c)| if by_u { ((h - 1, *k), c * Rational::from(*h)) } else { ((*h, k - 1), c * Rational::from(*k)) }).collect()
    };
    let pairs: Vec<(Bivariate, Bivariate)> = coordinates.iter().map(|p| (derivative(p, true), derivative(p, false))).collect();
    (0..pairs.len()).all(|i| (0..i).all(|j| times(&pairs[i].0, &pairs[j].1) == times(&pairs[j].0, &pairs[i].1)))
}
