//! Polynomial surfaces by their equations.

mod over;
mod polar;

use crate::affine::{AffineMap, Weights};
use crate::error::Error;
use crate::exact::Rational;
use crate::kernel::coefficient::Coefficient;
use crate::kernel::integers::Integers;
use crate::kernel::layout::Layout;
use crate::kernel::shape::Shape;
use crate::kernel::task::Value;
use crate::reading::{MAX_COEFFICIENTS, Reading};
use crate::symbolic::{Monomial, Polynomial, Symbol};

/// One term `c u^h v^k` of a coordinate: `(h, k, c)`.
pub type Term<C = Rational> = (usize, usize, C);

/// A polynomial map `F(u, v)` from the plane into a space of any dimension,
/// together with the way it is read: by its total degree `m`, or by its
/// bidegree `(p, q)`. The degrees are at least those of every coordinate.
///
/// ```
/// use casteljau::{Rational, Surface, Triangle};
/// // Enneper's surface (Gallier, section 19.1).
/// let q = |n, d| Rational::new(n, d);
/// let enneper = Surface::total(vec![
///     vec![(1, 0, q(1, 1)), (3, 0, q(-1, 3)), (1, 2, q(1, 1))],
///     vec![(0, 1, q(1, 1)), (0, 3, q(-1, 3)), (2, 1, q(1, 1))],
///     vec![(2, 0, q(1, 1)), (0, 2, q(-1, 1))],
/// ])?;
/// let patch = enneper.over_triangle(&Triangle::standard())?;
/// assert_eq!(patch.label(2, 1), "f(r,r,s)");
/// assert_eq!(patch.point(2, 1), [q(2, 3), q(2, 3), q(1, 3)]);
/// assert!(patch.surface()?.same_map(&enneper));
/// # Ok::<(), casteljau::Error>(())
/// ```
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Surface<C = Rational> {
    pub(super) reading: Reading,
    pub(super) dimension: usize,
    /// The vectors `F_hk`, the second exponent running faster.
    pub(super) coefficients: Vec<C>,
}

impl<C: Coefficient> Surface<C> {
    /// The most coefficients that a surface may have, zeros included.
    pub const MAX_COEFFICIENTS: usize = MAX_COEFFICIENTS;

    /// The surface with these terms, one list a coordinate, read in some way.
    ///
    /// # Errors
    /// [`Error::WrongShape`] if there is no coordinate or the reading is that of
    /// a curve; [`Error::DegreeTooLow`] or [`Error::BidegreeTooLow`] if a term
    /// is beyond it; [`Error::TooLarge`] above [`Surface::MAX_COEFFICIENTS`].
    pub fn new(reading: Reading, coordinates: Vec<Vec<Term<C>>>) -> Result<Self, Error> {
        let dimension = coordinates.len();
        if dimension == 0 || matches!(reading, Reading::Curve(_)) {
            return Err(Error::WrongShape("a surface needs at least one coordinate, and a total degree or a bidegree".into()));
        }
        check_reading(reading, largest_degrees(coordinates.iter().flatten()))?;
        reading.check_size(dimension)?;
        let mut surface = Self { reading, dimension, coefficients: vec![C::nothing(); reading.points() * dimension] };
        for (position, terms) in coordinates.into_iter().enumerate() {
            for (h, k, c) in terms.into_iter().filter(|(_, _, c)| !c.is_nothing()) {
                let place = surface.place(h, k) * dimension + position;
                surface.coefficients[place].add(&c);
            }
        }
        Ok(surface)
    }

    /// The surface with these terms, read by the least total degree.
    ///
    /// # Errors
    /// As for [`Surface::new`].
    pub fn total(coordinates: Vec<Vec<Term<C>>>) -> Result<Self, Error> {
        let degree = largest_degrees(coordinates.iter().flatten()).2;
        Self::new(Reading::Total(degree), coordinates)
    }

    /// The surface with these terms, read by the least bidegree.
    ///
    /// # Errors
    /// As for [`Surface::new`].
    pub fn tensor(coordinates: Vec<Vec<Term<C>>>) -> Result<Self, Error> {
        let (p, q, _) = largest_degrees(coordinates.iter().flatten());
        let reading = Reading::Bidegree(p, q);
        Self::new(reading, coordinates)
    }

    pub(crate) fn from_coefficients(reading: Reading, dimension: usize, coefficients: Vec<C>) -> Self {
        debug_assert_eq!(coefficients.len(), reading.points() * dimension);
        Self { reading, dimension, coefficients }
    }

    /// The same surface with every coefficient brought into another ring.
    pub(crate) fn map<D: Coefficient, E>(&self, number: &mut impl FnMut(&C) -> Result<D, E>) -> Result<Surface<D>, E> {
        let coefficients = self.coefficients.iter().map(number).collect::<Result<_, E>>()?;
        Ok(Surface { reading: self.reading, dimension: self.dimension, coefficients })
    }

    pub(super) fn shape(&self) -> Shape {
        self.reading.shape(self.dimension)
    }

    /// The place of the coefficient of `u^h v^k`, which must be within the reading.
    fn place(&self, h: usize, k: usize) -> usize {
        match self.reading {
            Reading::Total(m) => self.shape().index(&[m - h - k, h, k]),
            Reading::Bidegree(_, q) => h * (q + 1) + k,
            Reading::Curve(_) => h,
        }
    }

    /// How it is read.
    #[must_use]
    pub fn reading(&self) -> Reading {
        self.reading
    }

    /// The number of coordinates.
    #[must_use]
    pub fn dimension(&self) -> usize {
        self.dimension
    }

    /// The exponents `(h, k)` of all coefficients in order, zeros included.
    fn exponents(&self) -> Vec<(usize, usize)> {
        let mut all = Vec::with_capacity(self.coefficients.len() / self.dimension);
        let tensor = matches!(self.reading, Reading::Bidegree(..));
        self.shape().for_each(|exponents| all.push(if tensor { (exponents[1], exponents[3]) } else { (exponents[1], exponents[2]) }));
        all
    }

    /// The terms of a coordinate that are not zero, sorted by their exponents.
    ///
    /// # Panics
    /// If there is no such coordinate.
    #[must_use]
    pub fn terms(&self, coordinate: usize) -> Vec<Term<&C>> {
        assert!(coordinate < self.dimension, "the surface has {} coordinates", self.dimension);
        let own = self.coefficients[coordinate..].iter().step_by(self.dimension);
        let terms = self.exponents().into_iter().zip(own);
        terms.filter(|(_, c)| !c.is_nothing()).map(|((h, k), c)| (h, k, c)).collect()
    }

    /// The coordinates as polynomials in two variables.
    pub(crate) fn polynomials(&self, variables: [Symbol; 2]) -> Vec<Polynomial> {
        let product = |h: usize, k: usize| &Monomial::power(variables[0], h as u32) * &Monomial::power(variables[1], k as u32);
        let coordinate = |index| {
            let terms = self.terms(index).into_iter().flat_map(|(h, k, c)| {
                let c: Polynomial = c.clone().into();
                c.terms().map(|(monomial, number)| (monomial * &product(h, k), number.clone())).collect::<Vec<_>>()
            });
            Polynomial::from_terms(terms)
        };
        (0..self.dimension).map(coordinate).collect()
    }

    /// All coefficients, zeros included.
    pub(crate) fn coefficients(&self) -> &[C] {
        &self.coefficients
    }

    /// The vectors of coefficients that are not zero, with their exponents.
    fn vectors(&self) -> impl Iterator<Item = ((usize, usize), &[C])> {
        let vectors = self.coefficients.chunks_exact(self.dimension);
        self.exponents().into_iter().zip(vectors).filter(|(_, vector)| vector.iter().any(|c| !c.is_nothing()))
    }

    /// The exponents of all terms that are not zero, in any coordinate.
    fn support(&self) -> impl Iterator<Item = (usize, usize)> {
        self.vectors().map(|(place, _)| place)
    }

    /// The largest total degree of the coordinates; 0 for constants.
    #[must_use]
    pub fn true_total_degree(&self) -> usize {
        self.support().map(|(h, k)| h + k).max().unwrap_or(0)
    }

    /// The largest degree of the coordinates in each variable.
    #[must_use]
    pub fn true_bidegree(&self) -> (usize, usize) {
        self.support().fold((0, 0), |(p, q), (h, k)| (p.max(h), q.max(k)))
    }

    /// Whether all coordinates vanish identically.
    #[must_use]
    pub fn is_zero(&self) -> bool {
        self.coefficients.iter().all(C::is_nothing)
    }

    /// The same map read in another way.
    ///
    /// # Errors
    /// [`Error::DegreeTooLow`] or [`Error::BidegreeTooLow`] if a coordinate has
    /// a higher degree; [`Error::TooLarge`] above [`Surface::MAX_COEFFICIENTS`].
    pub fn read_as(&self, reading: Reading) -> Result<Self, Error> {
        if reading == self.reading {
            return Ok(self.clone());
        }
        let lists = (0..self.dimension).map(|index| self.terms(index).into_iter().map(|(h, k, c)| (h, k, c.clone())).collect()).collect();
        Self::new(reading, lists)
    }

    /// The same map read by a total degree: `p + q` for a bidegree `(p, q)`.
    ///
    /// # Errors
    /// [`Error::TooLarge`] above [`Surface::MAX_COEFFICIENTS`].
    pub fn by_total_degree(&self) -> Result<Self, Error> {
        match self.reading {
            Reading::Bidegree(p, q) => self.read_as(Reading::Total(p + q)),
            _ => Ok(self.clone()),
        }
    }

    /// The same map read by a bidegree: `(m, m)` for a total degree `m`.
    ///
    /// # Errors
    /// [`Error::TooLarge`] above [`Surface::MAX_COEFFICIENTS`].
    pub fn by_bidegree(&self) -> Result<Self, Error> {
        match self.reading {
            Reading::Total(m) => self.read_as(Reading::Bidegree(m, m)),
            _ => Ok(self.clone()),
        }
    }

    pub(super) fn point_layout<'a>(&self, divisors: &'a Integers<C>) -> Layout<'a, C> {
        Layout::constant(Shape::curve(0, self.dimension), divisors.as_slice())
    }

    /// The point `F(u, v)`.
    #[must_use]
    pub fn value(&self, [u, v]: &[C; 2]) -> Vec<C> {
        let mut place = Weights::default();
        match self.reading {
            Reading::Bidegree(..) => place.push_numbers([u, v].into_iter()),
            Reading::Total(_) | Reading::Curve(_) => place.push(&[C::unit(), u.clone(), v.clone()]),
        }
        // Each scale to the power of the degree in its factor.
        let mut divisors = Integers::default();
        for (position, factor) in self.reading.factors().iter().enumerate() {
            let scale = place.scales.as_slice().after(position).up_to(1);
            (0..factor.degree).for_each(|_| divisors.extend(scale));
        }
        C::compute(&Value { shape: self.shape() }, &self.coefficients, place.rows.as_slice(), &[self.point_layout(&divisors)])
    }

    /// The partial derivative of some orders: a surface of vectors, of a total
    /// degree or bidegree that much lower (0 beyond the degree).
    #[must_use]
    pub fn partial(&self, in_u: usize, in_v: usize) -> Self {
        let falling = |from: usize, by: usize| (from - by + 1..=from).map(Rational::from).product::<Rational>();
        let mut result = self.zero(self.lowered(in_u, in_v));
        for ((h, k), vector) in self.vectors().filter(|&((h, k), _)| h >= in_u && k >= in_v) {
            result.add_multiple((h - in_u, k - in_v), vector, &C::from(falling(h, in_u) * falling(k, in_v)));
        }
        result
    }

    fn lowered(&self, in_u: usize, in_v: usize) -> Reading {
        match self.reading {
            Reading::Bidegree(p, q) => Reading::Bidegree(p.saturating_sub(in_u), q.saturating_sub(in_v)),
            Reading::Total(m) | Reading::Curve(m) => Reading::Total(m.saturating_sub(in_u).saturating_sub(in_v)),
        }
    }

    /// The derivative in the direction `(du, dv)`, of some order. Its total
    /// degree is that much lower; its bidegree is the same, as either variable
    /// may keep its degree.
    #[must_use]
    pub fn derivative(&self, [du, dv]: &[C; 2], order: usize) -> Self {
        // Beyond the degrees there is nothing left.
        let degree: usize = self.reading.groups().iter().map(|group| group.0).sum();
        let mut result = self.clone();
        for _ in 0..order.min(degree + 1) {
            let reading = if let Reading::Bidegree(..) = result.reading { result.reading } else { result.lowered(1, 0) };
            let mut sum = self.zero(reading);
            for ((h, k), vector) in result.vectors() {
                if h > 0 {
                    sum.add_multiple((h - 1, k), vector, &du.times(&C::from(Rational::from(h))));
                }
                if k > 0 {
                    sum.add_multiple((h, k - 1), vector, &dv.times(&C::from(Rational::from(k))));
                }
            }
            result = sum;
        }
        result
    }

    /// The surface of as many coordinates, read in some way, that vanishes.
    fn zero(&self, reading: Reading) -> Self {
        Self { reading, dimension: self.dimension, coefficients: vec![C::nothing(); reading.points() * self.dimension] }
    }

    /// Adds a multiple of a vector to the coefficients of `u^h v^k`.
    fn add_multiple(&mut self, (h, k): (usize, usize), vector: &[C], factor: &C) {
        let start = self.place(h, k) * self.dimension;
        self.coefficients[start..].iter_mut().zip(vector).for_each(|(sum, c)| sum.add_product(c, factor));
    }

    /// The map with one more coordinate, given by its terms; the degrees rise if need be.
    ///
    /// # Errors
    /// As for [`Surface::new`].
    pub fn with_coordinate(&self, terms: Vec<Term<C>>) -> Result<Self, Error> {
        let kept = |index| self.terms(index).into_iter().map(|(h, k, c)| (h, k, c.clone())).collect();
        let mut coordinates: Vec<Vec<Term<C>>> = (0..self.dimension).map(kept).collect();
        let largest = largest_degrees(terms.iter());
        let reading = match self.reading {
            Reading::Bidegree(p, q) => Reading::Bidegree(p.max(largest.0), q.max(largest.1)),
            Reading::Total(m) | Reading::Curve(m) => Reading::Total(m.max(largest.2)),
        };
        coordinates.push(terms);
        Self::new(reading, coordinates)
    }

    /// The image under an affine map.
    ///
    /// # Errors
    /// [`Error::WrongCount`] if the map takes points of another dimension.
    pub fn transform(&self, map: &AffineMap<C>) -> Result<Self, Error> {
        let constant = self.place(0, 0);
        let mut coefficients = Vec::with_capacity(self.coefficients.len());
        for (place, vector) in self.coefficients.chunks_exact(self.dimension).enumerate() {
            coefficients.extend(if place == constant { map.apply(vector)? } else { map.apply_to_vector(vector)? });
        }
        Ok(Self { reading: self.reading, dimension: map.target_dimension(), coefficients })
    }

    /// Whether two surfaces are the same polynomial map, however they are read.
    #[must_use]
    pub fn same_map(&self, other: &Self) -> bool {
        self.dimension == other.dimension && (0..self.dimension).all(|index| self.terms(index) == other.terms(index))
    }
}

/// The largest degrees of terms that are not zero: in each variable, and in both together.
fn largest_degrees<'t, C: Coefficient + 't>(terms: impl Iterator<Item = &'t Term<C>>) -> (usize, usize, usize) {
    let nonzero = terms.filter(|(_, _, c)| !c.is_nothing());
    nonzero.fold((0, 0, 0), |(p, q, m), &(h, k, _)| (p.max(h), q.max(k), m.max(h.saturating_add(k))))
}

fn check_reading(reading: Reading, needed: (usize, usize, usize)) -> Result<(), Error> {
    match reading {
        Reading::Total(asked) if asked < needed.2 => Err(Error::DegreeTooLow { asked, needed: needed.2 }),
        Reading::Bidegree(p, q) if p < needed.0 || q < needed.1 => {
            Err(Error::BidegreeTooLow { asked: (p, q), needed: (needed.0, needed.1) })
        }
        _ => Ok(()),
    }
}
