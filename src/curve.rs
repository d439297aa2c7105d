//! Polynomial curves by their equations.

use std::slice;

use crate::affine::{AffineMap, Interval, Parameter, Weights};
use crate::blossom::PolarForm;
use crate::control::{ControlNet, Data, change_frame};
use crate::error::Error;
use crate::exact::Rational;
use crate::kernel::coefficient::Coefficient;
use crate::kernel::combination::ShortArguments;
use crate::kernel::integers::{IntegerSlice, Integers};
use crate::kernel::layout::Layout;
use crate::kernel::shape::Shape;
use crate::kernel::task::{SymmetricSum, Value};
use crate::reading::{MAX_COEFFICIENTS, Reading};
use crate::segment::Segment;
use crate::symbolic::{Polynomial, Symbol};

/// A polynomial map `F(t) = F_0 + F_1 t + … + F_m t^m` from the line into a
/// space of any dimension, with a polar degree `m` that is at least the degree
/// of every coordinate.
///
/// ```
/// use casteljau::{Curve, Interval, Rational};
/// // The cubic of Gallier, section 18.1.
/// let q = |n, d| Rational::new(n, d);
/// let curve = Curve::new(vec![
///     vec![q(-9, 4), q(-3, 2), q(3, 4)],
///     vec![q(0, 1), q(-9, 4), q(-3, 2), q(3, 4)],
/// ])?;
/// assert_eq!(curve.degree(), 3);
/// let segment = curve.segment(&Interval::new(q(-1, 1), q(3, 1))?)?;
/// assert_eq!(segment.point(1), [q(-4, 1), q(4, 1)]);
/// assert_eq!(segment.curve()?, curve);
/// # Ok::<(), casteljau::Error>(())
/// ```
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Curve<C = Rational> {
    degree: usize,
    dimension: usize,
    /// `F_0`, then `F_1`, …: the coordinates of one vector after the other.
    coefficients: Vec<C>,
}

impl<C: Coefficient> Curve<C> {
    /// The most coefficients that the equation of a curve may have, zeros included.
    pub const MAX_COEFFICIENTS: usize = MAX_COEFFICIENTS;

    /// The curve whose coordinates have these coefficients, in ascending powers.
    /// The polar degree is one less than the longest list.
    ///
    /// # Errors
    /// [`Error::WrongShape`] if there is no coordinate or every list is empty;
    /// [`Error::TooLarge`] above [`Curve::MAX_COEFFICIENTS`].
    pub fn new(coordinates: Vec<Vec<C>>) -> Result<Self, Error> {
        let dimension = coordinates.len();
        let length = coordinates.iter().map(Vec::len).max().unwrap_or(0);
        if length == 0 {
            return Err(Error::WrongShape("a curve needs at least one coordinate with at least one coefficient".into()));
        }
        Reading::Curve(length - 1).check_size(dimension)?;
        let mut coefficients = vec![C::nothing(); length * dimension];
        for (position, coordinate) in coordinates.into_iter().enumerate() {
            for (power, coefficient) in coordinate.into_iter().enumerate() {
                coefficients[power * dimension + position] = coefficient;
            }
        }
        Ok(Self { degree: length - 1, dimension, coefficients })
    }

    /// The curve with the vectors `F_0, …, F_m`, one after the other.
    pub(crate) fn from_vectors(dimension: usize, coefficients: Vec<C>) -> Self {
        debug_assert!(dimension > 0 && !coefficients.is_empty() && coefficients.len().is_multiple_of(dimension));
        Self { degree: coefficients.len() / dimension - 1, dimension, coefficients }
    }

    /// The same curve with every coefficient brought into another ring.
    pub(crate) fn map<D: Coefficient, E>(&self, number: &mut impl FnMut(&C) -> Result<D, E>) -> Result<Curve<D>, E> {
        let coefficients = self.coefficients.iter().map(number).collect::<Result<_, E>>()?;
        Ok(Curve { degree: self.degree, dimension: self.dimension, coefficients })
    }

    /// The polar degree: the number of arguments of the polar form.
    #[must_use]
    pub fn degree(&self) -> usize {
        self.degree
    }

    /// The number of coordinates.
    #[must_use]
    pub fn dimension(&self) -> usize {
        self.dimension
    }

    /// The largest degree of the coordinates; 0 for constants.
    #[must_use]
    pub fn true_degree(&self) -> usize {
        (1..=self.degree).rev().find(|&power| self.vector(power).iter().any(|c| !c.is_nothing())).unwrap_or(0)
    }

    /// Whether all coordinates vanish identically.
    #[must_use]
    pub fn is_zero(&self) -> bool {
        self.coefficients.iter().all(C::is_nothing)
    }

    /// The vector `F_k` of the coefficients of `t^k`.
    ///
    /// # Panics
    /// If `power` is larger than the polar degree.
    #[must_use]
    pub fn vector(&self, power: usize) -> &[C] {
        &self.coefficients[power * self.dimension..(power + 1) * self.dimension]
    }

    /// The coefficients of one coordinate, in ascending powers.
    ///
    /// # Panics
    /// If there is no such coordinate.
    pub fn coordinate(&self, index: usize) -> impl DoubleEndedIterator<Item = &C> + ExactSizeIterator {
        assert!(index < self.dimension, "the curve has {} coordinates", self.dimension);
        self.coefficients[index..].iter().step_by(self.dimension)
    }

    /// The coordinates as polynomials in a variable.
    pub(crate) fn polynomials(&self, variable: Symbol) -> Vec<Polynomial> {
        let coordinate = |index| self.coordinate(index).map(|c| c.clone().into()).collect::<Vec<Polynomial>>();
        (0..self.dimension).map(|index| Polynomial::from_coefficients(variable, &coordinate(index))).collect()
    }

    /// The same map with another polar degree.
    ///
    /// # Errors
    /// [`Error::DegreeTooLow`] if a coordinate has a higher degree;
    /// [`Error::TooLarge`] above [`Curve::MAX_COEFFICIENTS`].
    pub fn with_degree(mut self, degree: usize) -> Result<Self, Error> {
        let needed = self.true_degree();
        if degree < needed {
            return Err(Error::DegreeTooLow { asked: degree, needed });
        }
        Reading::Curve(degree).check_size(self.dimension)?;
        self.coefficients.resize((degree + 1) * self.dimension, C::nothing());
        self.degree = degree;
        Ok(self)
    }

    /// The polar form: the one symmetric map, affine in each of its `m`
    /// arguments, that agrees with the curve where they are all equal.
    #[must_use]
    pub fn polar(&self) -> PolarForm<C> {
        PolarForm::new(Reading::Curve(self.degree), self.dimension, &self.coefficients)
    }

    /// The polar value `f(t_1, …, t_m)`.
    ///
    /// # Errors
    /// [`Error::WrongCount`] unless there are as many arguments as the polar degree.
    pub fn blossom(&self, arguments: &[C]) -> Result<Vec<C>, Error> {
        if let Some(value) = self.short_polar_value(arguments) {
            return Ok(value);
        }
        let mut weights = Weights::default();
        weights.push_numbers(arguments.iter());
        self.polar_value(&mut weights)
    }

    /// The same where every number is short. (A function of its own has the
    /// registers for itself, wherever it is called from.)
    #[inline(never)]
    fn short_polar_value(&self, arguments: &[C]) -> Option<Vec<C>> {
        if arguments.len() != self.degree {
            return None;
        }
        let multiples = short_multiples(self.degree)?;
        let mut product = ShortArguments::default();
        for argument in arguments {
            product.take(argument.short_fraction()?)?;
        }
        product.combine(multiples, &self.coefficients, self.dimension)
    }

    /// The polar value at homogeneous arguments `[w; t]`, vectors (`w = 0`) included.
    ///
    /// # Errors
    /// [`Error::WrongCount`] unless there are as many arguments as the polar degree.
    pub fn blossom_homogeneous(&self, arguments: &[Parameter<C>]) -> Result<Vec<C>, Error> {
        let mut weights = Weights::default();
        arguments.iter().for_each(|Parameter { t, w }| weights.push_pair(w, t));
        self.polar_value(&mut weights)
    }

    #[inline]
    fn polar_value(&self, Weights { rows: parameters, scales: divisors }: &mut Weights<C>) -> Result<Vec<C>, Error> {
        let found = divisors.as_slice().len();
        if found != self.degree {
            return Err(Error::WrongCount { what: "polar arguments", expected: self.degree, found });
        }
        push_multiples(self.degree, parameters, divisors);
        let task = SymmetricSum { shape: Shape::curve(self.degree, self.dimension) };
        Ok(C::compute(&task, &self.coefficients, parameters.as_slice(), &[self.point_layout(divisors)]))
    }

    /// The point `F(t)`.
    #[must_use]
    pub fn value(&self, t: &C) -> Vec<C> {
        let mut place = Weights::default();
        place.push_numbers(std::iter::once(t));
        let divisors = place.repeated(self.degree).scales;
        let task = Value { shape: Shape::curve(self.degree, self.dimension) };
        C::compute(&task, &self.coefficients, place.rows.as_slice(), &[self.point_layout(&divisors)])
    }

    fn point_layout<'a>(&self, divisors: &'a Integers<C>) -> Layout<'a, C> {
        Layout::constant(Shape::curve(0, self.dimension), divisors.as_slice())
    }

    /// The derivative of some order, a curve of vectors of a polar degree that
    /// much lower (zero of polar degree 0 beyond the degree).
    #[must_use]
    pub fn derivative(&self, order: usize) -> Self {
        if order > self.degree {
            return Self::from_vectors(self.dimension, vec![C::nothing(); self.dimension]);
        }
        let mut coefficients = Vec::with_capacity((self.degree + 1 - order) * self.dimension);
        for power in order..=self.degree {
            let factor: Rational = (power - order + 1..=power).map(Rational::from).product();
            let factor = C::from(factor);
            coefficients.extend(self.vector(power).iter().map(|c| c.times(&factor)));
        }
        Self::from_vectors(self.dimension, coefficients)
    }

    /// The map with one more coordinate, given by its coefficients in ascending
    /// powers; the polar degree rises if need be.
    ///
    /// # Errors
    /// As for [`Curve::new`].
    pub fn with_coordinate(&self, coefficients: Vec<C>) -> Result<Self, Error> {
        let mut coordinates: Vec<Vec<C>> = (0..self.dimension).map(|index| self.coordinate(index).cloned().collect()).collect();
        coordinates.push(coefficients);
        Self::new(coordinates)
    }

    /// The segment over a frame: its control points are the polar values at
    /// the vertices, `b_i = f(r^{m-i} s^i)` (Gallier, section 18.1).
    ///
    /// # Errors
    /// None. The plan of the change of frame looks whether the new vertices are
    /// independent, which the ends of every [`Interval`] are: they differ.
    pub fn segment(&self, frame: &Interval<C>) -> Result<Segment<C>, Error> {
        let shape = Shape::curve(self.degree, self.dimension);
        let mut vertices = Weights::default();
        frame.push_vertices(&mut vertices);
        let coordinates = change_frame(&shape, (Data::Equation, &self.coefficients), slice::from_ref(&vertices), Data::Net)?;
        Ok(Segment::from_net(ControlNet { shape, coordinates }, frame.clone()))
    }

    /// The image under an affine map.
    ///
    /// # Errors
    /// [`Error::WrongCount`] if the map takes points of another dimension.
    pub fn transform(&self, map: &AffineMap<C>) -> Result<Self, Error> {
        let mut coefficients = map.apply(self.vector(0))?;
        for power in 1..=self.degree {
            coefficients.extend(map.apply_to_vector(self.vector(power))?);
        }
        Ok(Self::from_vectors(map.target_dimension(), coefficients))
    }

    /// Whether two curves are the same polynomial map, whatever their polar degrees.
    #[must_use]
    pub fn same_map(&self, other: &Self) -> bool {
        let (short, long) = if self.degree < other.degree { (self, other) } else { (other, self) };
        short.dimension == long.dimension
            && long.coefficients.starts_with(&short.coefficients)
            && long.coefficients[short.coefficients.len()..].iter().all(C::is_nothing)
    }
}

/// The largest degree whose multiples are in the table.
const TABLE: usize = 16;

/// The rows of multiples for small degrees, one after the other.
static MULTIPLES: [i64; (TABLE + 1) * (TABLE + 2) / 2] = {
    let mut table = [0; (TABLE + 1) * (TABLE + 2) / 2];
    let (mut common, mut degree, mut place) = (1, 0, 0);
    while degree <= TABLE {
        // lcm(C(m,0), …, C(m,m)) = lcm(1, …, m+1) / (m+1)
        let (mut a, mut b) = (common, degree as i64 + 1);
        while b != 0 {
            (a, b) = (b, a % b);
        }
        common = common / a * (degree as i64 + 1);
        let mut multiple = common / (degree as i64 + 1);
        let mut k = 0;
        while k <= degree {
            table[place] = multiple;
            // C(m,k+1) = C(m,k) (m-k)/(k+1), so the multiple changes by the inverse.
            if k < degree {
                multiple = multiple * (k as i64 + 1) / (degree - k) as i64;
            }
            place += 1;
            k += 1;
        }
        degree += 1;
    }
    table
};

/// Appends the least common multiple of the binomial numbers `C(m, k)`, divided
/// by each of them, to the parameters, and itself to the divisors.
#[inline]
fn push_multiples<C: Coefficient>(degree: usize, parameters: &mut Integers<C>, divisors: &mut Integers<C>) {
    let Some(multiples) = short_multiples(degree) else {
        let multiples = binomial_multiples(degree);
        divisors.push(C::from(multiples[0].clone()));
        return multiples.into_iter().for_each(|multiple| parameters.push(C::from(multiple)));
    };
    parameters.extend(IntegerSlice::Words(multiples));
    divisors.push_word(multiples[0]);
}

/// The multiples of a degree in the table.
#[inline]
fn short_multiples(degree: usize) -> Option<&'static [i64]> {
    let start = degree * (degree + 1) / 2;
    (degree <= TABLE).then(|| &MULTIPLES[start..=start + degree])
}

/// The same for any degree.
fn binomial_multiples(degree: usize) -> Vec<Rational> {
    // lcm(C(m,0), …, C(m,m)) = lcm(1, …, m+1) / (m+1)
    let mut common = num_bigint::BigInt::from(1u32);
    for k in 2..=degree + 1 {
        let mut rest = k;
        let mut prime_power = 1;
        // k contributes its prime exactly if it is a power of one.
        if let Some(prime) = (2..=k).find(|p| k % p == 0) {
            while rest % prime == 0 {
                rest /= prime;
            }
            if rest == 1 {
                prime_power = prime;
            }
        }
        common *= prime_power;
    }
    common /= degree + 1;
    let mut multiple = common;
    (0..=degree)
        .map(|k| {
            let result = Rational::from(multiple.clone());
            // C(m,k+1) = C(m,k) (m-k)/(k+1), so the multiple changes by the inverse.
            if k < degree {
                multiple = &multiple * (k + 1) / (degree - k);
            }
            result
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn multiples_are_integers_times_binomials() {
        for degree in 0..40 {
            let multiples = binomial_multiples(degree);
            let (mut parameters, mut divisors) = (Integers::default(), Integers::default());
            push_multiples(degree, &mut parameters, &mut divisors);
            assert_eq!(multiples[..], parameters.as_slice().to_elements());
            assert_eq!(multiples[..1], divisors.as_slice().to_elements());
            let mut binomial = Rational::from(1);
            for (k, multiple) in multiples.iter().enumerate() {
                assert!(multiple.is_integer());
                assert_eq!(multiple * &binomial, multiples[0]);
                binomial = &binomial * &Rational::new((degree - k) as i64, k as i64 + 1);
            }
        }
    }
}
