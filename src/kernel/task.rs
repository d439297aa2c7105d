//! The computations on curves that the nouns ask for, each written once for every ring.

use smallvec::SmallVec;

use super::coefficient::Task;
use super::form::Form;
use super::layout::{multinomials, multiply_by_multinomials};
use super::net::Net;
use super::reframe::Reframe;
use super::shape::Shape;
use crate::exact::magnitude::Magnitude;
use crate::exact::width::Ring;

/// The sum of the multinomial numbers of a curve, with room for computing them.
fn multinomial_growth(degree: usize) -> Magnitude {
    Magnitude::from(2u64).power(degree).times(Magnitude::from(degree as u64 + 1))
}

fn form_of_net<R: Ring>(shape: &Shape, mut entries: Vec<R>) -> Form<R> {
    multiply_by_multinomials(shape, &mut entries, &multinomials::<R>(shape));
    Form { shape: shape.clone(), entries }
}

/// Brings a curve over to another frame. The result is a form.
pub(crate) struct ChangeFrame {
    pub(crate) shape: Shape,
    pub(crate) reframe: Reframe,
    /// Whether the data is a form already (an equation), not a net.
    pub(crate) from_form: bool,
}

impl Task for ChangeFrame {
    fn growth<R: Ring>(&self, parameters: &[R]) -> Magnitude {
        let degree = self.shape.factors[0].degree;
        let entries = if self.from_form { Magnitude::from(degree as u64 + 1) } else { multinomial_growth(degree) };
        self.reframe.growth(degree, parameters).times(entries)
    }

    fn run<R: Ring>(&self, numerators: Vec<R>, parameters: &[R]) -> Vec<R> {
        let mut form =
            if self.from_form { Form { shape: self.shape.clone(), entries: numerators } } else { form_of_net(&self.shape, numerators) };
        self.reframe.apply(&mut form, parameters);
        form.entries
    }
}

/// The polar value of a net at arguments given by pairs of weights.
pub(crate) struct PolarValue {
    pub(crate) shape: Shape,
}

#[inline]
fn weights_growth<R: Ring>(weights: &[R]) -> Magnitude {
    weights.iter().fold(Magnitude::ZERO, |sum, weight| sum.plus(weight.magnitude())).max(Magnitude::ONE)
}

impl Task for PolarValue {
    fn growth<R: Ring>(&self, parameters: &[R]) -> Magnitude {
        parameters.chunks_exact(2).fold(Magnitude::ONE, |growth, weights| growth.times(weights_growth(weights)))
    }

    fn run<R: Ring>(&self, numerators: Vec<R>, parameters: &[R]) -> Vec<R> {
        let mut net = Net { shape: self.shape.clone(), entries: numerators };
        for weights in parameters.chunks_exact(2) {
            net = net.step(0, weights);
        }
        net.entries
    }
}

/// The whole scheme of de Casteljau's algorithm at one pair of weights.
pub(crate) struct Casteljau {
    pub(crate) shape: Shape,
}

impl Task for Casteljau {
    fn growth<R: Ring>(&self, parameters: &[R]) -> Magnitude {
        weights_growth(parameters).power(self.shape.factors[0].degree)
    }

    fn run<R: Ring>(&self, numerators: Vec<R>, parameters: &[R]) -> Vec<R> {
        Net { shape: self.shape.clone(), entries: numerators }.scheme(0, parameters).entries
    }
}

/// The left half of a subdivision, then the right one.
pub(crate) struct Split {
    pub(crate) shape: Shape,
}

impl Task for Split {
    fn growth<R: Ring>(&self, parameters: &[R]) -> Magnitude {
        weights_growth(parameters).power(self.shape.factors[0].degree)
    }

    fn run<R: Ring>(&self, numerators: Vec<R>, parameters: &[R]) -> Vec<R> {
        let mut net = Net { shape: self.shape.clone(), entries: numerators };
        let mut halves = net.split(&[parameters[0].clone(), parameters[1].clone()]);
        halves.append(&mut net.entries);
        halves
    }
}

/// The form of the same curve with more arguments, or (from an elevated one) with fewer.
pub(crate) struct ChangeDegree {
    pub(crate) shape: Shape,
    pub(crate) degree: usize,
}

impl Task for ChangeDegree {
    fn growth<R: Ring>(&self, _: &[R]) -> Magnitude {
        multinomial_growth(self.shape.factors[0].degree.max(self.degree)).times(Magnitude::from(self.degree as u64 + 1))
    }

    fn run<R: Ring>(&self, numerators: Vec<R>, _: &[R]) -> Vec<R> {
        let mut form = form_of_net(&self.shape, numerators);
        let degree = self.shape.factors[0].degree;
        form.elevate(0, self.degree.saturating_sub(degree));
        for _ in self.degree..degree {
            form.lower();
        }
        form.entries
    }
}

/// The form of a product: the data is the first net, the parameters the second.
pub(crate) struct Product {
    pub(crate) first: Shape,
    pub(crate) second: Shape,
}

impl Task for Product {
    fn growth<R: Ring>(&self, parameters: &[R]) -> Magnitude {
        let largest = parameters.iter().fold(Magnitude::ONE, |largest, parameter| largest.max(parameter.magnitude()));
        let degrees = [&self.first, &self.second].map(|shape| multinomial_growth(shape.factors[0].degree));
        largest.times(degrees[0]).times(degrees[1])
    }

    fn run<R: Ring>(&self, numerators: Vec<R>, parameters: &[R]) -> Vec<R> {
        form_of_net(&self.first, numerators).product(&form_of_net(&self.second, parameters.to_vec())).entries
    }
}

/// The polar value of an equation: the sum of `A_k e_k c_k`, where `e_k` is the
/// coefficient of `X^k` in the product of all `(w_i + t_i X)`.
///
/// Parameters: pairs `(t_i, w_i)`, then the numbers `c_k`, which are a common
/// multiple of the binomial numbers `C(m,k)` divided by each of them.
///
/// (Ramshaw, *Blossoming: A Connect-the-Dots Approach to Splines*, 1987: polar
/// forms by elementary symmetric functions.)
pub(crate) struct SymmetricSum {
    pub(crate) degree: usize,
    pub(crate) dimension: usize,
}

impl Task for SymmetricSum {
    fn growth<R: Ring>(&self, parameters: &[R]) -> Magnitude {
        let (arguments, multiples) = parameters.split_at(2 * self.degree);
        let largest = multiples.iter().fold(Magnitude::ONE, |largest, multiple| largest.max(multiple.magnitude()));
        arguments.chunks_exact(2).fold(largest, |growth, argument| growth.times(weights_growth(argument)))
    }

    fn run<R: Ring>(&self, mut numerators: Vec<R>, parameters: &[R]) -> Vec<R> {
        let (arguments, multiples) = parameters.split_at(2 * self.degree);
        let mut symmetric: SmallVec<[R; 12]> = elementary_symmetric(arguments);
        for (value, multiple) in symmetric.iter_mut().zip(multiples) {
            value.multiply(multiple);
        }
        // The first vector of the data becomes the sum.
        let (sums, rest) = numerators.split_at_mut(self.dimension);
        sums.iter_mut().for_each(|sum| sum.multiply(&symmetric[0]));
        for (coefficients, value) in rest.chunks_exact(self.dimension).zip(&symmetric[1..]) {
            for (sum, coefficient) in sums.iter_mut().zip(coefficients) {
                sum.add_product(coefficient, value);
            }
        }
        numerators.truncate(self.dimension);
        numerators
    }
}

/// The coefficients of the product of all `(w_i + t_i X)`, from pairs `(t_i, w_i)`.
pub(crate) fn elementary_symmetric<R: Ring>(arguments: &[R]) -> SmallVec<[R; 12]> {
    let count = arguments.len() / 2;
    let mut symmetric: SmallVec<[R; 12]> = SmallVec::new();
    symmetric.resize(count + 1, R::nothing());
    symmetric[0] = R::unit();
    for (done, argument) in arguments.chunks_exact(2).enumerate() {
        let (t, w) = (&argument[0], &argument[1]);
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

/// The elementary symmetric functions of the parameters' pairs `(t_i, w_i)`; the data is the number 1.
pub(crate) struct Symmetric;

impl Task for Symmetric {
    fn growth<R: Ring>(&self, parameters: &[R]) -> Magnitude {
        parameters.chunks_exact(2).fold(Magnitude::ONE, |growth, argument| growth.times(weights_growth(argument)))
    }

    fn run<R: Ring>(&self, _: Vec<R>, parameters: &[R]) -> Vec<R> {
        elementary_symmetric(parameters).into_vec()
    }
}

/// The value of an equation at the homogeneous parameter `(t, w)`, by Horner's scheme.
pub(crate) struct Value {
    pub(crate) degree: usize,
    pub(crate) dimension: usize,
}

impl Task for Value {
    fn growth<R: Ring>(&self, parameters: &[R]) -> Magnitude {
        weights_growth(parameters).power(self.degree + 1).times(Magnitude::from(self.degree as u64 + 1))
    }

    fn run<R: Ring>(&self, numerators: Vec<R>, parameters: &[R]) -> Vec<R> {
        let mut sums = vec![R::nothing(); self.dimension];
        let mut power = R::unit();
        for coefficients in numerators.chunks_exact(self.dimension).rev() {
            for (sum, coefficient) in sums.iter_mut().zip(coefficients) {
                sum.multiply(&parameters[0]);
                sum.add_product(coefficient, &power);
            }
            power.multiply(&parameters[1]);
        }
        sums
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn elementary_symmetric_functions() {
        // (5 + 2X)(7 - 3X)(1 + X)
        assert_eq!(elementary_symmetric(&[2i64, 5, -3, 7, 1, 1])[..], [35, 34, -7, -6]);
        assert_eq!(elementary_symmetric::<i64>(&[])[..], [1]);
    }
}
