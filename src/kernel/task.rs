//! The computations that the nouns ask for, each written once for every ring
//! and for every product of simplices.

use smallvec::SmallVec;

use super::coefficient::Task;
use super::form::Form;
use super::layout::{multinomials, multiply_by_multinomials};
use super::net::Net;
use super::reframe::Reframe;
use super::shape::{Factor, Shape};
use crate::exact::magnitude::Magnitude;
use crate::exact::width::Ring;

/// The sum of the multinomial numbers of a shape, with room for computing them.
pub(super) fn multinomial_growth(shape: &Shape) -> Magnitude {
    shape.factors.iter().fold(Magnitude::ONE, |growth, &Factor { dimension, degree }| {
        growth.times(Magnitude::from(dimension as u64 + 1).power(degree)).times(Magnitude::from(degree as u64 + 1))
    })
}

fn form_of_net<R: Ring>(shape: &Shape, mut entries: Vec<R>) -> Form<R> {
    multiply_by_multinomials(shape, &mut entries, &multinomials::<R>(shape));
    Form { shape: shape.clone(), entries }
}

/// Brings a map over to another frame. The result is a form.
pub(crate) struct ChangeFrame {
    pub(crate) shape: Shape,
    /// One plan a factor; their parameters follow each other.
    pub(crate) reframes: SmallVec<[Reframe; 1]>,
    /// Whether the data is a form already (an equation), not a net.
    pub(crate) from_form: bool,
}

impl Task for ChangeFrame {
    fn growth<R: Ring>(&self, parameters: &[R]) -> Magnitude {
        let entries = if self.from_form { Magnitude::from(self.shape.points() as u64) } else { multinomial_growth(&self.shape) };
        let mut rest = parameters;
        self.reframes.iter().fold(entries, |growth, reframe| {
            let (own, others) = rest.split_at(reframe.parameter_count());
            rest = others;
            growth.times(reframe.growth(self.shape.factors[reframe.factor()].degree, own))
        })
    }

    fn run<R: Ring>(&self, numerators: Vec<R>, parameters: &[R]) -> Vec<R> {
        let mut form =
            if self.from_form { Form { shape: self.shape.clone(), entries: numerators } } else { form_of_net(&self.shape, numerators) };
        let mut rest = parameters;
        for reframe in &self.reframes {
            let (own, others) = rest.split_at(reframe.parameter_count());
            rest = others;
            reframe.apply(&mut form, own);
        }
        form.entries
    }
}

/// A change of frame of which only the side opposite vertex 0 is kept: the
/// curve that a triangle carries along one edge of its new frame.
pub(crate) struct Edge {
    pub(crate) change: ChangeFrame,
}

impl Task for Edge {
    fn growth<R: Ring>(&self, parameters: &[R]) -> Magnitude {
        self.change.growth(parameters)
    }

    fn run<R: Ring>(&self, numerators: Vec<R>, parameters: &[R]) -> Vec<R> {
        let entries = self.change.run(numerators, parameters);
        let mut points = entries.chunks_exact(self.change.shape.stride);
        let mut edge: Vec<&[R]> = Vec::new();
        self.change.shape.for_each(|exponents| edge.extend(points.next().filter(|_| exponents[0] == 0)));
        // In the order of the triangle vertex 2 comes before vertex 1.
        edge.into_iter().rev().flatten().cloned().collect()
    }
}

/// The polar value of a net, in as many arguments of each factor as `counts`
/// says. Parameters: the weights of one argument after the other.
pub(crate) struct PolarValue {
    pub(crate) shape: Shape,
    pub(crate) counts: SmallVec<[usize; 2]>,
}

#[inline]
fn weights_growth<R: Ring>(weights: &[R]) -> Magnitude {
    weights.iter().fold(Magnitude::ZERO, |sum, weight| sum.plus(weight.magnitude())).max(Magnitude::ONE)
}

/// Calls `visit` with the weights of every argument, factor by factor.
#[inline]
fn for_each_argument<R>(shape: &Shape, counts: &[usize], parameters: &[R], mut visit: impl FnMut(usize, &[R])) {
    let mut rest = parameters;
    for (position, (factor, &count)) in shape.factors.iter().zip(counts).enumerate() {
        for _ in 0..count {
            let (weights, others) = rest.split_at(factor.dimension + 1);
            rest = others;
            visit(position, weights);
        }
    }
}

impl Task for PolarValue {
    fn growth<R: Ring>(&self, parameters: &[R]) -> Magnitude {
        let mut growth = Magnitude::ONE;
        for_each_argument(&self.shape, &self.counts, parameters, |_, weights| growth = growth.times(weights_growth(weights)));
        growth
    }

    fn run<R: Ring>(&self, numerators: Vec<R>, parameters: &[R]) -> Vec<R> {
        let mut net = Net { shape: self.shape.clone(), entries: numerators };
        for_each_argument(&self.shape, &self.counts, parameters, |factor, weights| net = net.step(factor, weights));
        net.entries
    }
}

/// The whole scheme of de Casteljau's algorithm in one factor.
pub(crate) struct Casteljau {
    pub(crate) shape: Shape,
    pub(crate) factor: usize,
}

impl Task for Casteljau {
    fn growth<R: Ring>(&self, parameters: &[R]) -> Magnitude {
        weights_growth(parameters).power(self.shape.factors[self.factor].degree)
    }

    fn run<R: Ring>(&self, numerators: Vec<R>, parameters: &[R]) -> Vec<R> {
        Net { shape: self.shape.clone(), entries: numerators }.scheme(self.factor, parameters).entries
    }
}

/// The nets of the steps that take one argument of each factor in, in turn:
/// bilinear interpolation on rectangles. Parameters: the weights of each factor.
pub(crate) struct CommonSteps {
    pub(crate) shape: Shape,
    pub(crate) steps: usize,
}

impl Task for CommonSteps {
    fn growth<R: Ring>(&self, parameters: &[R]) -> Magnitude {
        let counts: SmallVec<[usize; 2]> = self.shape.factors.iter().map(|_| 1).collect();
        let mut growth = Magnitude::ONE;
        for_each_argument(&self.shape, &counts, parameters, |_, weights| growth = growth.times(weights_growth(weights)));
        growth.power(self.steps)
    }

    fn run<R: Ring>(&self, numerators: Vec<R>, parameters: &[R]) -> Vec<R> {
        let counts: SmallVec<[usize; 2]> = self.shape.factors.iter().map(|_| 1).collect();
        let mut net = Net { shape: self.shape.clone(), entries: numerators };
        let mut all = net.entries.clone();
        for _ in 0..self.steps {
            for_each_argument(&self.shape, &counts, parameters, |factor, weights| net = net.step(factor, weights));
            all.extend_from_slice(&net.entries);
        }
        all
    }
}

/// The left half of a subdivided curve, then the right one.
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

/// The nets in which the argument stands in place of one of the vertices, for
/// each of `replaced` in turn: the faces of the scheme.
pub(crate) struct Faces {
    pub(crate) shape: Shape,
    pub(crate) factor: usize,
    pub(crate) replaced: SmallVec<[usize; 3]>,
}

impl Task for Faces {
    fn growth<R: Ring>(&self, parameters: &[R]) -> Magnitude {
        weights_growth(parameters).power(self.shape.factors[self.factor].degree)
    }

    fn run<R: Ring>(&self, numerators: Vec<R>, parameters: &[R]) -> Vec<R> {
        let simplex = self.shape.factors[self.factor];
        let (outer, inner) = self.shape.blocks(self.factor);
        let scheme = Net { shape: self.shape.clone(), entries: numerators }.scheme(self.factor, parameters);
        let all = scheme.shape.factors[self.factor];
        let mut faces = Vec::with_capacity(self.replaced.len() * self.shape.points() * self.shape.stride);
        for &vertex in &self.replaced {
            for repeat in 0..outer {
                simplex.for_each(|exponents| {
                    // In the scheme the argument is vertex 1, the old vertices stand around it.
                    let mut place: SmallVec<[usize; 4]> = SmallVec::from_slice(exponents);
                    let taken = std::mem::take(&mut place[vertex]);
                    place.insert(1, taken);
                    let start = (repeat * all.count() + all.index(&place[1..])) * inner;
                    faces.extend_from_slice(&scheme.entries[start..start + inner]);
                });
            }
        }
        faces
    }
}

/// The form of the same map with more arguments in a factor, or (from an elevated curve) with fewer.
pub(crate) struct ChangeDegree {
    pub(crate) shape: Shape,
    pub(crate) factor: usize,
    pub(crate) degree: usize,
}

impl Task for ChangeDegree {
    fn growth<R: Ring>(&self, _: &[R]) -> Magnitude {
        let larger = self.shape.factors[self.factor].degree.max(self.degree);
        multinomial_growth(&self.shape.with_degree(self.factor, larger)).times(Magnitude::from(self.degree as u64 + 1))
    }

    fn run<R: Ring>(&self, numerators: Vec<R>, _: &[R]) -> Vec<R> {
        let mut form = form_of_net(&self.shape, numerators);
        let degree = self.shape.factors[self.factor].degree;
        form.elevate(self.factor, self.degree.saturating_sub(degree));
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
        largest.times(multinomial_growth(&self.first)).times(multinomial_growth(&self.second))
    }

    fn run<R: Ring>(&self, numerators: Vec<R>, parameters: &[R]) -> Vec<R> {
        form_of_net(&self.first, numerators).product(&form_of_net(&self.second, parameters.to_vec())).entries
    }
}

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

/// The value of an equation where the vertices (origin, directions) have these weights.
pub(crate) struct Value {
    pub(crate) shape: Shape,
}

impl Task for Value {
    fn growth<R: Ring>(&self, parameters: &[R]) -> Magnitude {
        let mut growth = Magnitude::from(self.shape.points() as u64);
        let counts: SmallVec<[usize; 2]> = self.shape.factors.iter().map(|_| 1).collect();
        for_each_argument(&self.shape, &counts, parameters, |factor, weights| {
            // The tables of powers go one further than what is used of them.
            growth = growth.times(weights_growth(weights).power(self.shape.factors[factor].degree + 1));
        });
        growth
    }

    fn run<R: Ring>(&self, numerators: Vec<R>, parameters: &[R]) -> Vec<R> {
        Form { shape: self.shape.clone(), entries: numerators }.value(parameters)
    }
}

/// The form's values on the grid of all weights with a given sum: in each
/// factor every way to share `steps` among its vertices, in the order of a net
/// of that degree.
pub(crate) struct Grid {
    pub(crate) shape: Shape,
    pub(crate) steps: usize,
}

impl Grid {
    /// The shape of the grid: a net of degree `steps` in every factor.
    pub(crate) fn target(shape: &Shape, steps: usize) -> Shape {
        let factors = shape.factors.iter().map(|factor| Factor { degree: steps, ..*factor }).collect();
        Shape { factors, stride: shape.stride }
    }
}

impl Task for Grid {
    fn growth<R: Ring>(&self, _: &[R]) -> Magnitude {
        let steps = Magnitude::from(self.steps.max(1) as u64);
        // The tables of powers go one further than what is used of them.
        self.shape.factors.iter().fold(multinomial_growth(&self.shape), |growth, factor| growth.times(steps.power(factor.degree + 1)))
    }

    fn run<R: Ring>(&self, numerators: Vec<R>, _: &[R]) -> Vec<R> {
        let form = form_of_net(&self.shape, numerators);
        let mut values = Vec::with_capacity(Self::target(&self.shape, self.steps).points() * self.shape.stride);
        let mut weights: SmallVec<[R; 6]> = SmallVec::new();
        Self::target(&self.shape, self.steps).for_each(|shares| {
            weights.clear();
            weights.extend(shares.iter().map(|&share| R::from_count(share)));
            values.append(&mut form.value(&weights));
        });
        values
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
