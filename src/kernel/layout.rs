//! What the entries of a result are divided by.

use smallvec::SmallVec;

use super::shape::Shape;
use crate::exact::width::Ring;

/// What the numbers of a result are to be divided by: for the entry with
/// exponents `α`, the constant and the divisors, each vertex's scale to the power of its
/// exponent, and, if asked for, the multinomial number of `α`.
#[derive(Clone, Debug)]
pub struct Layout<C> {
    pub(crate) shape: Shape,
    pub(crate) scales: SmallVec<[C; 3]>,
    pub(crate) multinomial: bool,
    pub(crate) constant: C,
    /// Factors of the constant that are better not multiplied out beforehand.
    pub(crate) divisors: SmallVec<[C; 4]>,
}

impl<C> Layout<C> {
    /// The multinomial number of every entry, or nothing where none is asked for.
    pub(crate) fn multinomials<R: Ring>(&self) -> Vec<R> {
        if self.multinomial { multinomials(&self.shape) } else { Vec::new() }
    }
}

/// The multinomial numbers of a shape, in the order of its points.
pub(crate) fn multinomials<R: Ring>(shape: &Shape) -> Vec<R> {
    let mut rows = shape.factors.iter().map(|factor| multinomial_row::<R>(factor.dimension, factor.degree));
    let mut all = rows.next().unwrap_or_else(|| vec![R::unit()]);
    for row in rows {
        all = all
            .iter()
            .flat_map(|outer| {
                row.iter().map(|inner| {
                    let mut product = outer.clone();
                    product.multiply(inner);
                    product
                })
            })
            .collect();
    }
    all
}

fn multinomial_row<R: Ring>(dimension: usize, degree: usize) -> Vec<R> {
    if dimension == 0 {
        return vec![R::unit()];
    }
    let mut row = Vec::with_capacity(degree + 1);
    let mut binomial = R::unit();
    for first in 0..=degree {
        if dimension == 1 {
            row.push(binomial.clone());
        } else {
            row.extend(multinomial_row::<R>(dimension - 1, degree - first).into_iter().map(|mut rest| {
                rest.multiply(&binomial);
                rest
            }));
        }
        binomial.multiply(&R::from_count(degree - first));
        binomial.divide_exactly(&R::from_count(first + 1));
    }
    row
}

/// Multiplies every entry of a net by its multinomial number: the net becomes a form.
pub(crate) fn multiply_by_multinomials<R: Ring>(shape: &Shape, entries: &mut [R], multinomials: &[R]) {
    for (point, multinomial) in entries.chunks_exact_mut(shape.stride).zip(multinomials) {
        if !multinomial.is_unit() {
            point.iter_mut().for_each(|entry| entry.multiply(multinomial));
        }
    }
}

impl<C: Ring> Layout<C> {
    /// Every entry over the same number.
    pub(crate) fn constant(shape: Shape, constant: C) -> Self {
        Self { shape, scales: SmallVec::new(), multinomial: false, constant, divisors: SmallVec::new() }
    }

    /// A form over vertices that are points, to be read as a net.
    pub(crate) fn form(shape: Shape) -> Self {
        Self { shape, scales: SmallVec::new(), multinomial: true, constant: C::unit(), divisors: SmallVec::new() }
    }
}
