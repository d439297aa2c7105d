//! What the entries of a result are divided by.

use super::integers::IntegerSlice;
use super::shape::{Factor, Shape};
use crate::exact::width::{Entries, Ring};

/// What the numbers of a result are to be divided by: for the entry with
/// exponents `α`, the divisors, each vertex's scale to the power of its
/// exponent, and, if asked for, the multinomial number of `α`.
#[derive(Clone, Copy, Debug)]
pub struct Layout<'a, C> {
    pub(crate) shape: Shape,
    pub(crate) scales: IntegerSlice<'a, C>,
    pub(crate) multinomial: bool,
    pub(crate) divisors: IntegerSlice<'a, C>,
}

impl<C> Layout<'_, C> {
    /// The multinomial number of every entry, or nothing where none is asked for.
    pub(crate) fn multinomials<R: Ring>(&self) -> Entries<R> {
        if self.multinomial { multinomials(&self.shape) } else { Entries::new() }
    }
}

/// The multinomial numbers of a shape, in the order of its points.
pub(crate) fn multinomials<R: Ring>(shape: &Shape) -> Entries<R> {
    let mut all = Entries::new();
    push_multinomials(shape, &R::unit(), &mut all);
    all
}

/// Appends the multinomial numbers of a shape times a number.
#[inline]
pub(crate) fn push_multinomials<R: Ring>(shape: &Shape, times: &R, all: &mut Entries<R>) {
    match shape.factors[..] {
        [factor] => push_row(factor, times, all),
        _ => {
            let mut outer = Entries::new();
            push_row(shape.factors[0], times, &mut outer);
            outer.iter().for_each(|number| push_row(shape.factors[1], number, all));
        }
    }
}

/// The same for one simplex.
#[inline]
fn push_row<R: Ring>(Factor { dimension, degree }: Factor, times: &R, row: &mut Entries<R>) {
    if dimension != 1 {
        return push_simplex(dimension, degree, times, row);
    }
    let start = row.len();
    row.extend((0..=degree).map(|_| times.clone()));
    // From both ends to the middle: divisions are what takes time.
    let mut binomial = times.clone();
    for first in 1..=degree / 2 {
        binomial.multiply(&R::from_count(degree + 1 - first));
        binomial.divide_exactly(&R::from_count(first));
        row[start + first] = binomial.clone();
        row[start + degree - first] = binomial.clone();
    }
}

fn push_simplex<R: Ring>(dimension: usize, degree: usize, times: &R, row: &mut Entries<R>) {
    if dimension == 0 {
        return row.push(times.clone());
    }
    let mut binomial = times.clone();
    for first in 0..=degree {
        push_row(Factor { dimension: dimension - 1, degree: degree - first }, &binomial, row);
        binomial.multiply(&R::from_count(degree - first));
        binomial.divide_exactly(&R::from_count(first + 1));
    }
}

/// Multiplies every entry of a net by its multinomial number: the net becomes a form.
pub(crate) fn multiply_by_multinomials<R: Ring>(shape: &Shape, entries: &mut [R], multinomials: &[R]) {
    for (point, multinomial) in entries.chunks_exact_mut(shape.stride).zip(multinomials) {
        if !multinomial.is_unit() {
            point.iter_mut().for_each(|entry| entry.multiply(multinomial));
        }
    }
}

impl<'a, C> Layout<'a, C> {
    /// Every entry over the same numbers.
    pub(crate) fn constant(shape: Shape, divisors: IntegerSlice<'a, C>) -> Self {
        Self { shape, scales: IntegerSlice::NONE, multinomial: false, divisors }
    }

    /// A net over vertices with these scales.
    pub(crate) fn net(shape: Shape, scales: IntegerSlice<'a, C>) -> Self {
        Self { shape, scales, multinomial: false, divisors: IntegerSlice::NONE }
    }

    /// A form over vertices with these scales (none if all are points), to be read as a net.
    pub(crate) fn form(shape: Shape, scales: IntegerSlice<'a, C>) -> Self {
        Self { shape, scales, multinomial: true, divisors: IntegerSlice::NONE }
    }
}
