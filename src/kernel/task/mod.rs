//! The computations that the nouns ask for, each written once for every ring
//! and for every product of simplices.

mod degree;
mod frame;
mod steps;
mod symmetric;
mod value;

pub(crate) use degree::{ChangeDegree, Product};
pub(crate) use frame::{ChangeFrame, Edge};
pub(crate) use steps::{Casteljau, CommonSteps, Faces, PolarValue, Split};
pub(crate) use symmetric::{Symmetric, SymmetricSum, elementary_symmetric};
pub(crate) use value::{Grid, Value};

use std::ops::DerefMut;

use super::form::Form;
use super::layout::{multinomials, multiply_by_multinomials};
use super::shape::{Factor, Shape};
use crate::exact::magnitude::Magnitude;
use crate::exact::width::{Entries, Ring};

/// The sum of the multinomial numbers of a shape, with room for computing them.
pub(super) fn multinomial_growth(shape: &Shape) -> Magnitude {
    shape.factors.iter().fold(Magnitude::ONE, |growth, &Factor { dimension, degree }| {
        growth.times(Magnitude::from(dimension as u64 + 1).power(degree)).times(Magnitude::from(degree as u64 + 1))
    })
}

/// The form that a net becomes, on its own entries.
pub(super) fn form_of_net<R: Ring, E: DerefMut<Target = [R]>>(shape: &Shape, mut entries: E) -> Form<E> {
    multiply_by_multinomials(shape, &mut entries, &multinomials::<R>(shape));
    Form { shape: *shape, entries }
}

/// The entries as a list that can change its length.
pub(super) fn take<R: Ring>(entries: &mut Entries<R>) -> Vec<R> {
    std::mem::take(entries).into_vec()
}

#[inline]
pub(super) fn weights_growth<R: Ring>(weights: &[R]) -> Magnitude {
    weights.iter().fold(Magnitude::ZERO, |sum, weight| sum.plus(weight.magnitude())).max(Magnitude::ONE)
}

/// Calls `visit` with the weights of every argument, factor by factor.
#[inline]
pub(super) fn for_each_argument<R>(shape: &Shape, counts: &[usize], parameters: &[R], mut visit: impl FnMut(usize, &[R])) {
    let mut rest = parameters;
    for (position, (factor, &count)) in shape.factors.iter().zip(counts).enumerate() {
        for _ in 0..count {
            let (weights, others) = rest.split_at(factor.dimension + 1);
            rest = others;
            visit(position, weights);
        }
    }
}
