//! Polar values by elementary symmetric functions.

use smallvec::SmallVec;

use super::{for_each_argument, weights_growth};
use crate::exact::magnitude::Magnitude;
use crate::exact::width::Ring;
use crate::kernel::coefficient::Task;
use crate::kernel::shape::{Factor, Shape};

/// The polar value of an equation: the sum of `A_α e_α c_α`, where the `e_α`
/// are the coefficients of the product of all arguments as linear forms.
///
/// Parameters: the arguments, each with its weights at the vertices (origin,
/// directions), factor by factor; then for each factor the numbers `c_α`, a
/// common multiple of its multinomial numbers divided by each of them.
///
/// (Ramshaw, *Blossoming: A Connect-the-Dots Approach to Splines*, 1987: polar
/// forms by elementary symmetric functions.)
pub(crate) struct SymmetricSum {
    pub(crate) shape: Shape,
}

impl SymmetricSum {
    fn degrees(&self) -> SmallVec<[usize; 2]> {
        self.shape.factors.iter().map(|factor| factor.degree).collect()
    }

    fn argument_length(&self) -> usize {
        self.shape.factors.iter().map(|factor| factor.degree * (factor.dimension + 1)).sum()
    }
}

impl Task for SymmetricSum {
    fn growth<R: Ring>(&self, parameters: &[R]) -> Magnitude {
        let (arguments, mut multiples) = parameters.split_at(self.argument_length());
        let mut growth = Magnitude::ONE;
        for factor in &self.shape.factors {
            let (own, others) = multiples.split_at(factor.count());
            multiples = others;
            growth = growth.times(own.iter().fold(Magnitude::ONE, |largest, multiple| largest.max(multiple.magnitude())));
        }
        for_each_argument(&self.shape, &self.degrees(), arguments, |_, weights| growth = growth.times(weights_growth(weights)));
        growth
    }

    fn run<R: Ring>(&self, mut numerators: Vec<R>, parameters: &[R]) -> Vec<R> {
        let (mut arguments, mut multiples) = parameters.split_at(self.argument_length());
        let stride = self.shape.stride;
        // Factor by factor from the outermost: its entries are summed up, what is inside stays.
        for (position, factor) in self.shape.factors.iter().enumerate() {
            let (own, others) = arguments.split_at(factor.degree * (factor.dimension + 1));
            arguments = others;
            let mut symmetric = elementary_symmetric(factor.dimension, own);
            let (scales, others) = multiples.split_at(symmetric.len());
            multiples = others;
            for (value, multiple) in symmetric.iter_mut().zip(scales) {
                value.multiply(multiple);
            }
            let inner = self.shape.factors[position + 1..].iter().map(|factor| factor.count()).product::<usize>() * stride;
            // The first block of the data becomes the sum.
            let (sums, rest) = numerators.split_at_mut(inner);
            sums.iter_mut().for_each(|sum| sum.multiply(&symmetric[0]));
            for (coefficients, value) in rest.chunks_exact(inner).zip(&symmetric[1..]) {
                for (sum, coefficient) in sums.iter_mut().zip(coefficients) {
                    sum.add_product(coefficient, value);
                }
            }
            numerators.truncate(inner);
        }
        numerators
    }
}

/// The coefficients of the product of linear forms, each given by its weights
/// at the vertices of a simplex: `(w + t X)` on the line, `(w + u X + v Y)` in the plane.
pub(crate) fn elementary_symmetric<R: Ring>(dimension: usize, arguments: &[R]) -> SmallVec<[R; 12]> {
    if dimension != 1 {
        return symmetric_of_simplex(dimension, arguments);
    }
    let count = arguments.len() / 2;
    let mut symmetric: SmallVec<[R; 12]> = SmallVec::new();
    symmetric.resize(count + 1, R::nothing());
    symmetric[0] = R::unit();
    for (done, argument) in arguments.chunks_exact(2).enumerate() {
        let (w, t) = (&argument[0], &argument[1]);
        let row = &mut symmetric[..=done + 1];
        // The last entry is new: nothing yet times `w`.
        for k in (1..row.len()).rev() {
            let (head, tail) = row.split_at_mut(k);
            if k <= done {
                tail[0].multiply(w);
            }
            tail[0].add_product(&head[k - 1], t);
        }
        row[0].multiply(w);
    }
    symmetric
}

fn symmetric_of_simplex<R: Ring>(dimension: usize, arguments: &[R]) -> SmallVec<[R; 12]> {
    let mut product: SmallVec<[R; 12]> = SmallVec::from_elem(R::unit(), 1);
    for (degree, weights) in arguments.chunks_exact(dimension + 1).enumerate() {
        let larger = Factor { dimension, degree: degree + 1 };
        let mut next: SmallVec<[R; 12]> = SmallVec::from_elem(R::nothing(), larger.count());
        let mut entries = product.iter();
        Factor { dimension, degree }.for_each(|exponents| {
            let Some(entry) = entries.next() else { return };
            let mut raised: SmallVec<[usize; 4]> = SmallVec::from_slice(exponents);
            for (vertex, weight) in weights.iter().enumerate() {
                raised[vertex] += 1;
                next[larger.index(&raised[1..])].add_product(entry, weight);
                raised[vertex] -= 1;
            }
        });
        product = next;
    }
    product
}

/// The elementary symmetric functions of the parameters' pairs `(w_i, t_i)`; the data is the number 1.
pub(crate) struct Symmetric;

impl Task for Symmetric {
    fn growth<R: Ring>(&self, parameters: &[R]) -> Magnitude {
        parameters.chunks_exact(2).fold(Magnitude::ONE, |growth, argument| growth.times(weights_growth(argument)))
    }

    fn run<R: Ring>(&self, _: Vec<R>, parameters: &[R]) -> Vec<R> {
        elementary_symmetric(1, parameters).into_vec()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn elementary_symmetric_functions() {
        // (5 + 2X)(7 - 3X)(1 + X)
        assert_eq!(elementary_symmetric(1, &[5i64, 2, 7, -3, 1, 1])[..], [35, 34, -7, -6]);
        assert_eq!(elementary_symmetric::<i64>(1, &[])[..], [1]);
        // (1 + 2X + 3Y)(4 + 5X + 6Y) in the order 1, Y, Y², X, XY, X²
        assert_eq!(elementary_symmetric(2, &[1i64, 2, 3, 4, 5, 6])[..], [4, 18, 18, 13, 27, 10]);
    }
}
