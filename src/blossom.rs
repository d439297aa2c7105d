//! Polar forms of curves: their coefficients, their terms, and checks of claimed ones.

use crate::curve::Curve;
use crate::error::Error;
use crate::exact::Rational;
use crate::kernel::coefficient::{Coefficient, Compute};
use crate::kernel::layout::Layout;
use crate::kernel::shape::Shape;
use crate::kernel::task::Symmetric;
use crate::symbolic::{Monomial, Polynomial, Symbol};

/// The polar form of a curve of polar degree `m`: for every coordinate the
/// coefficients `c_k = a_k / C(m, k)` of the elementary symmetric functions
/// `σ_k(t_1, …, t_m)`.
///
/// (Gallier, *Curves and Surfaces in Geometric Modeling*, section 18.1;
/// Ramshaw, *Blossoming*, 1987.)
///
/// ```
/// use casteljau::{Curve, Rational};
/// let cube = Curve::new(vec![[0, 3, 0, 1].map(Rational::from).to_vec()])?;
/// let polar = cube.polar();
/// assert_eq!(polar.coefficient(0, 1), &Rational::from(1));
/// assert_eq!(polar.value(&[1, 2, 3].map(Rational::from))?, [Rational::from(12)]);
/// # Ok::<(), casteljau::Error>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct PolarForm<C = Rational> {
    degree: usize,
    /// One list a coordinate: `c_0, …, c_m`.
    coefficients: Vec<Vec<C>>,
}

impl<C: Coefficient> PolarForm<C> {
    pub(crate) fn of(curve: &Curve<C>) -> Self {
        let degree = curve.degree();
        let inverses: Vec<C> = binomials(degree).into_iter().filter_map(|c| c.recip()).map(C::from).collect();
        let coefficients = (0..curve.dimension())
            .map(|index| curve.coordinate(index).zip(&inverses).map(|(a, inverse)| a.times(inverse)).collect())
            .collect();
        Self { degree, coefficients }
    }

    /// The number of arguments.
    #[must_use]
    pub fn degree(&self) -> usize {
        self.degree
    }

    /// The number of coordinates.
    #[must_use]
    pub fn dimension(&self) -> usize {
        self.coefficients.len()
    }

    /// The coefficient of `σ_k` in a coordinate.
    ///
    /// # Panics
    /// If there is no such coordinate or `k` is larger than the polar degree.
    #[must_use]
    pub fn coefficient(&self, coordinate: usize, k: usize) -> &C {
        &self.coefficients[coordinate][k]
    }

    /// The polar value at as many arguments as the polar degree.
    ///
    /// # Errors
    /// [`Error::WrongCount`] for any other number of arguments.
    pub fn value(&self, arguments: &[C]) -> Result<Vec<C>, Error> {
        if arguments.len() != self.degree {
            return Err(Error::WrongCount { what: "polar arguments", expected: self.degree, found: arguments.len() });
        }
        let symmetric = sigma(arguments);
        let combine = |coefficients: &Vec<C>| {
            coefficients.iter().zip(&symmetric).fold(C::nothing(), |mut sum, (c, value)| {
                sum.add_product(c, value);
                sum
            })
        };
        Ok(self.coefficients.iter().map(combine).collect())
    }

    /// The number of terms that writing out a coordinate takes.
    #[must_use]
    pub fn term_count(&self, coordinate: usize) -> Rational {
        let counts = binomials(self.degree);
        self.coefficients[coordinate].iter().zip(counts).filter(|(c, _)| !c.is_nothing()).map(|(_, count)| count).sum()
    }
}

impl<C: Coefficient + Into<Polynomial>> PolarForm<C> {
    /// One coordinate written out as a polynomial in `t1, …, tm`.
    ///
    /// # Errors
    /// [`Error::TooLarge`] if it has more than `limit` terms.
    pub fn expand(&self, coordinate: usize, limit: usize) -> Result<Polynomial, Error> {
        if self.term_count(coordinate) > Rational::from(limit as i64) {
            return Err(Error::TooLarge { what: "number of terms of the polar form", limit });
        }
        let mut terms = Vec::new();
        for (k, coefficient) in self.coefficients[coordinate].iter().enumerate() {
            if coefficient.is_nothing() {
                continue;
            }
            let coefficient: Polynomial = coefficient.clone().into();
            for product in symmetric_terms(self.degree, k) {
                terms.extend(coefficient.terms().map(|(monomial, c)| (monomial * &product, c.clone())));
            }
        }
        Ok(Polynomial::from_terms(terms))
    }
}

/// The elementary symmetric functions `σ_0, …, σ_m` of `m` numbers
/// (Gallier, section 18.1), in a quadratic number of operations.
///
/// ```
/// use casteljau::{Rational, sigma};
/// let values = sigma(&[1, 2, 3].map(Rational::from));
/// assert_eq!(values, [1, 6, 11, 6].map(Rational::from));
/// ```
#[must_use]
pub fn sigma<C: Coefficient>(arguments: &[C]) -> Vec<C> {
    let mut constant = C::unit();
    let mut pairs = Vec::with_capacity(2 * arguments.len());
    for (t, scale) in arguments.iter().map(Compute::fraction) {
        constant.multiply(&scale);
        pairs.extend([t, scale]);
    }
    let layout = Layout::constant(Shape::curve(arguments.len(), 1), constant);
    C::compute(&Symmetric, &[C::unit()], &pairs, &[layout])
}

/// The argument `t_i` of a polar form, counted from 1.
#[must_use]
pub fn polar_symbol(index: usize) -> Symbol {
    Symbol::new('t', Some(index as u32))
}

/// The products of `k` of the symbols `t1, …, tm`, in lexicographic order: the terms of `σ_k`.
#[must_use]
pub fn symmetric_terms(degree: usize, k: usize) -> Vec<Monomial> {
    let mut terms = Vec::new();
    let mut chosen: Vec<usize> = (1..=k).collect();
    loop {
        terms.push(Monomial::from_factors(chosen.iter().map(|&index| (polar_symbol(index), 1))));
        // The next choice: raise the last index that has room, and pack the rest behind it.
        let Some(position) = (0..k).rev().find(|&position| chosen[position] < degree - (k - 1 - position)) else {
            return terms;
        };
        let next = chosen[position] + 1;
        for (offset, index) in chosen[position..].iter_mut().enumerate() {
            *index = next + offset;
        }
    }
}

/// The binomial numbers `C(m, 0), …, C(m, m)`.
pub(crate) fn binomials(degree: usize) -> Vec<Rational> {
    let mut binomial = Rational::from(1);
    (0..=degree)
        .map(|k| {
            let current = binomial.clone();
            binomial = &binomial * &Rational::new((degree - k) as i64, k as i64 + 1);
            current
        })
        .collect()
}

/// Why a claimed polar form is not one of the curve.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum PolarDefect {
    /// A coordinate changes when two arguments are exchanged.
    NotSymmetric {
        /// The coordinate, counted from 0.
        coordinate: usize,
        /// The two arguments, counted from 1.
        arguments: (usize, usize),
        /// The form with the arguments exchanged minus the claimed one.
        difference: Polynomial,
    },
    /// A coordinate has a degree above 1 in an argument.
    NotAffine {
        /// The coordinate, counted from 0.
        coordinate: usize,
        /// The argument, counted from 1.
        argument: usize,
        /// The degree in it.
        degree: usize,
    },
    /// A coordinate does not agree with the curve where all arguments are equal.
    WrongDiagonal {
        /// The coordinate, counted from 0.
        coordinate: usize,
        /// The claimed form on the diagonal minus the curve, in `t`.
        difference: Polynomial,
    },
}

/// Checks a claimed polar form, one polynomial in `t1, …, tm` a coordinate,
/// against the three axioms (CS348a, lecture 6, section 3): symmetric, affine
/// in every argument, and the curve on the diagonal. All defects are reported,
/// for each coordinate the first pair or argument that fails.
///
/// # Errors
/// [`Error::WrongCount`] if the claim has another number of coordinates than the curve.
pub fn check_polar_form(curve: &Curve<Polynomial>, claim: &[Polynomial], variable: Symbol) -> Result<Vec<PolarDefect>, Error> {
    if claim.len() != curve.dimension() {
        return Err(Error::WrongCount { what: "coordinates", expected: curve.dimension(), found: claim.len() });
    }
    let mut defects = Vec::new();
    for (coordinate, claimed) in claim.iter().enumerate() {
        let arguments = 1..=curve.degree();
        if let Some(argument) = arguments.clone().find(|&index| claimed.degree_in(polar_symbol(index)) > 1) {
            let degree = claimed.degree_in(polar_symbol(argument)) as usize;
            defects.push(PolarDefect::NotAffine { coordinate, argument, degree });
        }
        // Neighbouring transpositions generate all of them.
        for first in 1..curve.degree() {
            let exchanged = claimed.swap(polar_symbol(first), polar_symbol(first + 1));
            if exchanged != *claimed {
                let difference = &exchanged - claimed;
                defects.push(PolarDefect::NotSymmetric { coordinate, arguments: (first, first + 1), difference });
                break;
            }
        }
        let t = Polynomial::from(variable);
        let replacements: Vec<(Symbol, Polynomial)> = arguments.map(|index| (polar_symbol(index), t.clone())).collect();
        let diagonal = claimed.substitute_all(&replacements);
        let coefficients: Vec<Polynomial> = curve.coordinate(coordinate).cloned().collect();
        let difference = &diagonal - &Polynomial::from_coefficients(variable, &coefficients);
        if !difference.is_empty() {
            defects.push(PolarDefect::WrongDiagonal { coordinate, difference });
        }
    }
    Ok(defects)
}
