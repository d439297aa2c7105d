//! Polar forms: their coefficients, their terms, and checks of claimed ones.

use crate::affine::Weights;
use crate::error::Error;
use crate::exact::Rational;
use crate::exact::width::Entries;
use crate::kernel::coefficient::Coefficient;
use crate::kernel::layout::{Layout, multinomials};
use crate::kernel::shape::Shape;
use crate::kernel::task::{Symmetric, elementary_symmetric};
use crate::reading::Reading;
use crate::symbolic::{Monomial, Polynomial, Symbol};

/// The polar form of a curve or surface, as coefficients of the elementary
/// symmetric functions of its arguments.
///
/// For a curve of polar degree `m` these are `c_k = a_k / C(m, k)` with
/// `σ_k(t_1, …, t_m)`; for a surface there is one for every pair of exponents,
/// the coefficient of `u^h v^k` divided by the number of products that share
/// it: `m!/(h! k! (m-h-k)!)` by the total degree, `C(p, h) C(q, k)` by the bidegree.
///
/// (Gallier, *Curves and Surfaces in Geometric Modeling*, sections 18.1 and
/// 19.1; Ramshaw, *Blossoming*, 1987.)
///
/// ```
/// use casteljau::{Curve, Rational};
/// let cube = Curve::new(vec![[0, 3, 0, 1].map(Rational::from).to_vec()])?;
/// let polar = cube.polar();
/// assert_eq!(polar.coefficient(0, 1), &Rational::from(1));
/// assert_eq!(polar.value(&[1, 2, 3].map(Rational::from))?, [Rational::from(12)]);
/// # Ok::<(), casteljau::Error>(())
/// ```
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct PolarForm<C = Rational> {
    reading: Reading,
    dimension: usize,
    /// The vectors of coefficients, in the order of the reading.
    coefficients: Vec<C>,
}

impl<C: Coefficient> PolarForm<C> {
    /// The polar form of a map with these coefficients, vector by vector.
    pub(crate) fn new(reading: Reading, dimension: usize, coefficients: &[C]) -> Self {
        let counts = multinomials::<Rational>(&reading.shape(1));
        let inverses = counts.iter().filter_map(Rational::recip).map(C::from);
        let vectors = coefficients.chunks_exact(dimension).zip(inverses);
        let coefficients = vectors.flat_map(|(vector, inverse)| vector.iter().map(move |a| a.times(&inverse))).collect();
        Self { reading, dimension, coefficients }
    }

    /// How the map is read.
    #[must_use]
    pub fn reading(&self) -> Reading {
        self.reading
    }

    /// What the polar form would be if each coefficient of the map were divided
    /// by another number than the one of the products that share it: `count` of
    /// the exponents, for each group of arguments the weight's first, and of that number.
    #[cfg(feature = "cli")]
    pub(crate) fn divided_otherwise(&self, count: impl Fn(&[usize], &Rational) -> Rational) -> Self {
        let right = multinomials::<Rational>(&self.reading.shape(1));
        let factors = self.reading.exponents().into_iter().zip(right).map(|(exponents, right)| {
            let factor = right.checked_div(&count(&exponents, &right)).unwrap_or_default();
            C::from(factor)
        });
        let vectors = self.coefficients.chunks_exact(self.dimension).zip(factors);
        let coefficients = vectors.flat_map(|(vector, factor)| vector.iter().map(move |c| c.times(&factor))).collect();
        Self { coefficients, ..*self }
    }

    /// The number of arguments.
    #[must_use]
    pub fn degree(&self) -> usize {
        self.reading.groups().iter().map(|group| group.0).sum()
    }

    /// The number of coordinates.
    #[must_use]
    pub fn dimension(&self) -> usize {
        self.dimension
    }

    /// A coefficient of a coordinate: for a curve that of `σ_k`; for a surface
    /// the exponents are counted with the second one running faster.
    ///
    /// # Panics
    /// If there is no such coordinate or no such coefficient.
    #[must_use]
    pub fn coefficient(&self, coordinate: usize, index: usize) -> &C {
        self.check_coordinate(coordinate);
        &self.coefficients[index * self.dimension + coordinate]
    }

    #[track_caller]
    fn check_coordinate(&self, coordinate: usize) {
        assert!(coordinate < self.dimension, "the map has {} coordinates", self.dimension);
    }

    /// The coefficients of a coordinate.
    #[track_caller]
    fn own(&self, coordinate: usize) -> impl Iterator<Item = &C> {
        self.check_coordinate(coordinate);
        self.coefficients[coordinate..].iter().step_by(self.dimension)
    }

    /// The polar value at as many arguments as the polar degree, of a curve's
    /// polar form or one by the bidegree (then the first variable's come first).
    ///
    /// # Errors
    /// [`Error::WrongCount`] for any other number of arguments,
    /// [`Error::WrongShape`] if the arguments are points of the plane.
    pub fn value(&self, arguments: &[C]) -> Result<Vec<C>, Error> {
        if let Reading::Total(_) = self.reading {
            return Err(Error::WrongShape("the arguments of this polar form are points of the plane".into()));
        }
        let pairs: Vec<C> = arguments.iter().flat_map(|t| [C::unit(), t.clone()]).collect();
        self.sum(&pairs, 2)
    }

    /// The polar value at points of the plane, of a polar form by the total degree.
    ///
    /// # Errors
    /// [`Error::WrongCount`] for another number of arguments than the polar
    /// degree, [`Error::WrongShape`] if the arguments are numbers.
    pub fn value_at_points(&self, arguments: &[[C; 2]]) -> Result<Vec<C>, Error> {
        let Reading::Total(_) = self.reading else {
            return Err(Error::WrongShape("the arguments of this polar form are numbers".into()));
        };
        let triples: Vec<C> = arguments.iter().flat_map(|[u, v]| [C::unit(), u.clone(), v.clone()]).collect();
        self.sum(&triples, 3)
    }

    fn sum(&self, weights: &[C], size: usize) -> Result<Vec<C>, Error> {
        if weights.len() != self.degree() * size {
            return Err(Error::WrongCount { what: "polar arguments", expected: self.degree(), found: weights.len() / size });
        }
        let mut rest = weights;
        let mut symmetric = vec![C::unit()];
        for (count, dimension) in self.reading.groups() {
            let (own, others) = rest.split_at(count * (dimension + 1));
            rest = others;
            let mut group = Entries::new();
            elementary_symmetric(dimension, own, &mut group);
            symmetric = symmetric.iter().flat_map(|a| group.iter().map(move |b| a.times(b))).collect();
        }
        let mut sum = vec![C::nothing(); self.dimension];
        for (vector, value) in self.coefficients.chunks_exact(self.dimension).zip(&symmetric) {
            for (total, c) in sum.iter_mut().zip(vector) {
                total.add_product(c, value);
            }
        }
        Ok(sum)
    }

    /// The number of terms that writing out a coordinate takes.
    ///
    /// # Panics
    /// If there is no such coordinate.
    #[must_use]
    pub fn term_count(&self, coordinate: usize) -> Rational {
        let counts = multinomials::<Rational>(&self.reading.shape(1));
        self.own(coordinate).zip(counts).filter(|(c, _)| !c.is_nothing()).map(|(_, count)| count).sum()
    }

    /// The coefficients of a coordinate that are not zero, with the exponents
    /// they stand at: for each group of arguments the weight's first.
    pub(crate) fn terms(&self, coordinate: usize) -> Vec<(Vec<usize>, &C)> {
        self.reading.exponents().into_iter().zip(self.own(coordinate)).filter(|(_, c)| !c.is_nothing()).collect()
    }

    /// One coordinate written out as a polynomial in the coordinates of the
    /// arguments: `t1, …, tm`, or `U1, V1, …`, or `u1, …, v1, …`.
    ///
    /// # Errors
    /// [`Error::TooLarge`] if it has more than `limit` terms.
    ///
    /// # Panics
    /// If there is no such coordinate.
    pub fn expand(&self, coordinate: usize, limit: usize) -> Result<Polynomial, Error> {
        if self.term_count(coordinate) > Rational::from(limit) {
            return Err(Error::TooLarge { what: "number of terms of the polar form", limit });
        }
        let mut terms = Vec::new();
        for (exponents, coefficient) in self.terms(coordinate) {
            let coefficient: Polynomial = coefficient.clone().into();
            for term in self.reading.terms(&exponents) {
                let product = self.reading.monomial(&term);
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
    let mut weights = Weights::default();
    weights.push_numbers(arguments.iter());
    let layout = Layout::constant(Shape::curve(arguments.len(), 1), weights.scales.as_slice());
    C::compute(&Symmetric, &[C::unit()], weights.rows.as_slice(), &[layout])
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

/// Why a claimed polar form is not one of the map.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum PolarDefect {
    /// A coordinate changes when two arguments are exchanged.
    NotSymmetric {
        /// The coordinate, counted from 0.
        coordinate: usize,
        /// The group of arguments, counted from 0; only a bidegree has two.
        group: usize,
        /// The two arguments, counted from 1 in their group.
        arguments: (usize, usize),
        /// The form with the arguments exchanged minus the claimed one.
        difference: Polynomial,
    },
    /// A coordinate has a degree above 1 in an argument.
    NotAffine {
        /// The coordinate, counted from 0.
        coordinate: usize,
        /// The group of arguments, counted from 0.
        group: usize,
        /// The argument, counted from 1 in its group.
        argument: usize,
        /// The degree in it.
        degree: usize,
    },
    /// A coordinate does not agree with the map where all arguments are equal.
    WrongDiagonal {
        /// The coordinate, counted from 0.
        coordinate: usize,
        /// The claimed form on the diagonal minus the map, in its variables.
        difference: Polynomial,
    },
}

/// Checks a claimed polar form, one polynomial a coordinate in the coordinates
/// of the arguments ([`Reading::symbol`]), against the three axioms (CS348a,
/// lecture 6, section 3): symmetric, affine in every argument, and the map
/// itself on the diagonal. The map is given as polynomials in its one or two
/// variables. All defects are reported, for each coordinate and group the first
/// pair or argument that fails.
///
/// # Errors
/// [`Error::WrongCount`] if the claim has another number of coordinates than the map,
/// or if there are more or fewer variables than the reading has.
pub fn check_polar_form(
    reading: Reading,
    map: &[Polynomial],
    variables: &[Symbol],
    claim: &[Polynomial],
) -> Result<Vec<PolarDefect>, Error> {
    if claim.len() != map.len() {
        return Err(Error::WrongCount { what: "coordinates", expected: map.len(), found: claim.len() });
    }
    let expected = reading.groups().iter().map(|group| group.1).sum();
    if variables.len() != expected {
        return Err(Error::WrongCount { what: "variables", expected, found: variables.len() });
    }
    let mut defects = Vec::new();
    for (coordinate, (claimed, map)) in claim.iter().zip(map).enumerate() {
        let mut diagonal: Vec<(Symbol, Polynomial)> = Vec::new();
        let mut used = 0;
        for (group, (count, dimension)) in reading.groups().into_iter().enumerate() {
            let degree_in = |argument: usize| {
                let own: Vec<Symbol> = (1..=dimension).map(|axis| reading.symbol(group, argument, axis)).collect();
                let degree = |monomial: &Monomial| own.iter().map(|&symbol| monomial.degree_in(symbol)).sum::<u32>();
                claimed.terms().map(|(monomial, _)| degree(monomial)).max().unwrap_or(0) as usize
            };
            if let Some((argument, degree)) = (1..=count).map(|argument| (argument, degree_in(argument))).find(|found| found.1 > 1) {
                defects.push(PolarDefect::NotAffine { coordinate, group, argument, degree });
            }
            // Neighbouring transpositions generate all of them.
            for first in 1..count {
                let exchanged = (1..=dimension).fold(claimed.clone(), |form, axis| {
                    form.swap(reading.symbol(group, first, axis), reading.symbol(group, first + 1, axis))
                });
                if exchanged != *claimed {
                    let difference = &exchanged - claimed;
                    defects.push(PolarDefect::NotSymmetric { coordinate, group, arguments: (first, first + 1), difference });
                    break;
                }
            }
            let own = &variables[used..used + dimension];
            used += dimension;
            diagonal.extend((1..=count).flat_map(|argument| {
                own.iter().zip(1..).map(move |(&variable, axis)| (reading.symbol(group, argument, axis), Polynomial::from(variable)))
            }));
        }
        let difference = &claimed.substitute_all(&diagonal) - map;
        if !difference.is_empty() {
            defects.push(PolarDefect::WrongDiagonal { coordinate, difference });
        }
    }
    Ok(defects)
}
