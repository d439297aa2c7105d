//! Polar values by elementary symmetric functions.

use smallvec::SmallVec;

use super::{for_each_argument, weights_growth};
use crate::exact::magnitude::Magnitude;
use crate::exact::width::{Entries, Ring};
use crate::kernel::coefficient::Task;
use crate::kernel::combination::ShortProduct;
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
        for factor in self.shape.factors.iter() {
            let (own, others) = multiples.split_at(factor.count());
            multiples = others;
            // The first one is the common multiple itself.
            growth = growth.times(own[0].magnitude());
        }
        for_each_argument(&self.shape, &self.degrees(), arguments, |_, weights| growth = growth.times(weights_growth(weights)));
        growth
    }

    fn run<R: Ring>(&self, entries: &mut Entries<R>, parameters: &[R]) {
        let (mut arguments, mut multiples) = parameters.split_at(self.argument_length());
        // Factor by factor from the outermost: its entries are summed up, what is inside stays.
        for (position, factor) in self.shape.factors.iter().enumerate() {
            let (own, others) = arguments.split_at(factor.degree * (factor.dimension + 1));
            arguments = others;
            let mut symmetric = Entries::new();
            elementary_symmetric(factor.dimension, own, &mut symmetric);
            let (scales, others) = multiples.split_at(symmetric.len());
            multiples = others;
            let inner = self.shape.inner(position);
            for (value, multiple) in symmetric.iter_mut().zip(scales) {
                multiply(value, multiple);
            }
            // The first block of the data becomes the sum.
            for place in 0..inner {
                let mut sum = R::nothing();
                let coefficients = entries[place..].iter().step_by(inner);
                // The coefficient is the shorter factor, which counts where both are long.
                symmetric.iter().zip(coefficients).for_each(|(value, coefficient)| add_product(&mut sum, value, coefficient));
                entries[place] = sum;
            }
            entries.truncate(inner);
        }
    }
}

/// One at a time: two in a vector register would wait for both to leave the store buffer.
#[inline(never)]
fn multiply<R: Ring>(value: &mut R, multiple: &R) {
    value.multiply(multiple);
}

/// The same.
#[inline(never)]
fn add_product<R: Ring>(sum: &mut R, a: &R, b: &R) {
    sum.add_product(a, b);
}

/// The coefficients of the product of linear forms, each given by its weights
/// at the vertices of a simplex: `(w + t X)` on the line, `(w + u X + v Y)` in the plane.
#[inline]
pub(crate) fn elementary_symmetric<R: Ring>(dimension: usize, arguments: &[R], product: &mut Entries<R>) {
    if dimension != 1 {
        return symmetric_of_simplex(dimension, arguments, product);
    }
    product.clear();
    product.push(R::unit());
    let (pairs, _) = arguments.as_chunks::<2>();
    if !R::WIDE {
        product.extend(pairs.iter().map(|_| R::nothing()));
        let product = &mut product[..];
        return pairs.iter().enumerate().for_each(|(done, form)| multiply_by_form(&mut product[..done + 2], form));
    }
    // As many forms as their product certainly fits words are multiplied out there,
    // so that each pass over the long product takes in several.
    let mut group = ShortProduct::default();
    for form in pairs {
        let [Some(w), Some(t)] = form.each_ref().map(R::as_word) else {
            product.push(R::nothing());
            multiply_by_form(product, form);
            continue;
        };
        if !group.take([w, t]) {
            group.multiply_into(product);
            if !group.take([w, t]) {
                product.push(R::nothing());
                multiply_by_form(product, form);
            }
        }
    }
    group.multiply_into(product);
}

/// Multiplies a polynomial, whose last entry is still nothing, by `w + t X`.
#[inline]
fn multiply_by_form<R: Ring>(product: &mut [R], [w, t]: &[R; 2]) {
    // From the top down: every entry takes in the one before it.
    let mut entries = product.iter_mut().rev();
    let Some(mut to) = entries.next() else { return };
    for from in entries {
        to.multiply(w);
        to.add_product(from, t);
        to = from;
    }
    to.multiply(w);
}

fn symmetric_of_simplex<R: Ring>(dimension: usize, arguments: &[R], product: &mut Entries<R>) {
    *product = Entries::from_elem(R::unit(), 1);
    for (degree, weights) in arguments.chunks_exact(dimension + 1).enumerate() {
        let larger = Factor { dimension, degree: degree + 1 };
        let mut next: Entries<R> = Entries::from_elem(R::nothing(), larger.count());
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
        *product = next;
    }
}

/// The elementary symmetric functions of the parameters' pairs `(w_i, t_i)`; the data is the number 1.
pub(crate) struct Symmetric;

impl Task for Symmetric {
    fn growth<R: Ring>(&self, parameters: &[R]) -> Magnitude {
        parameters.chunks_exact(2).fold(Magnitude::ONE, |growth, argument| growth.times(weights_growth(argument)))
    }

    fn run<R: Ring>(&self, entries: &mut Entries<R>, parameters: &[R]) {
        elementary_symmetric(1, parameters, entries);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::exact::fixed::Fixed;
    use crate::exact::width::Integer;
    use num_bigint::BigInt;
    use proptest::prelude::*;

    fn symmetric<R: Ring>(dimension: usize, arguments: &[R]) -> Vec<R> {
        let mut product = Entries::new();
        elementary_symmetric(dimension, arguments, &mut product);
        product.into_vec()
    }

    #[test]
    fn elementary_symmetric_functions() {
        // (5 + 2X)(7 - 3X)(1 + X)
        assert_eq!(symmetric(1, &[5i64, 2, 7, -3, 1, 1]), [35, 34, -7, -6]);
        assert_eq!(symmetric::<i64>(1, &[]), [1]);
        // (1 + 2X + 3Y)(4 + 5X + 6Y) in the order 1, Y, Y², X, XY, X²
        assert_eq!(symmetric(2, &[1i64, 2, 3, 4, 5, 6]), [4, 18, 18, 13, 27, 10]);
    }

    /// Short ones, of which many make a group, words at both ends, and longer ones.
    fn weight() -> impl Strategy<Value = BigInt> {
        prop_oneof![
            6 => (-300i64..300).prop_map(BigInt::from),
            2 => (any::<i64>(), 0u32..64).prop_map(|(value, shift)| BigInt::from(value >> shift)),
            1 => (0i64..2).prop_map(|k| BigInt::from(i64::MAX - k)),
            1 => (0i64..2).prop_map(|k| BigInt::from(i64::MIN + k)),
            1 => any::<i128>().prop_map(BigInt::from),
        ]
    }

    fn of_width<R: Integer>(arguments: &[BigInt]) -> Vec<BigInt> {
        let arguments: Vec<R> = arguments.iter().map(R::from_big).collect();
        symmetric(1, &arguments).into_iter().map(R::into_big).collect()
    }

    proptest! {
        /// In groups and one form at a time, against the product written out.
        #[test]
        fn groups_multiply_like_single_forms(arguments in prop::collection::vec(weight(), 0..30)) {
            let pairs = arguments.len() / 2;
            let arguments = &arguments[..2 * pairs];
            let mut product = vec![BigInt::from(1)];
            for form in arguments.chunks_exact(2) {
                let mut next = vec![BigInt::ZERO; product.len() + 1];
                for (power, entry) in product.iter().enumerate() {
                    next[power] += entry * &form[0];
                    next[power + 1] += entry * &form[1];
                }
                product = next;
            }
            prop_assert_eq!(&of_width::<BigInt>(arguments), &product);
            // Every width is right modulo its power of two.
            let modulo = |values: &[BigInt], bits: usize| -> Vec<BigInt> {
                let size = BigInt::from(1) << bits;
                values.iter().map(|x| ((x % &size) + &size) % &size).collect()
            };
            prop_assert_eq!(modulo(&of_width::<i64>(arguments), 64), modulo(&product, 64));
            prop_assert_eq!(modulo(&of_width::<i128>(arguments), 128), modulo(&product, 128));
            if arguments.iter().all(|x| x.bits() < 128) {
                prop_assert_eq!(modulo(&of_width::<Fixed<4>>(arguments), 256), modulo(&product, 256));
            }
        }
    }
}
