//! The steps of de Casteljau's algorithm.

use smallvec::SmallVec;

use super::{for_each_argument, take, weights_growth};
use crate::exact::magnitude::Magnitude;
use crate::exact::width::{Entries, Ring};
use crate::kernel::coefficient::Task;
use crate::kernel::net::{Net, split};
use crate::kernel::shape::Shape;

/// The polar value of a net, in as many arguments of each factor as `counts`
/// says. Parameters: the weights of one argument after the other.
pub(crate) struct PolarValue {
    pub(crate) shape: Shape,
    pub(crate) counts: SmallVec<[usize; 2]>,
}

impl Task for PolarValue {
    fn growth<R: Ring>(&self, parameters: &[R]) -> Magnitude {
        let mut growth = Magnitude::ONE;
        for_each_argument(&self.shape, &self.counts, parameters, |_, weights| growth = growth.times(weights_growth(weights)));
        growth
    }

    fn run<R: Ring>(&self, entries: &mut Entries<R>, parameters: &[R]) {
        let mut net = Net { shape: self.shape, entries: take(entries) };
        for_each_argument(&self.shape, &self.counts, parameters, |factor, weights| net = net.step(factor, weights));
        *entries = net.entries.into();
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

    fn run<R: Ring>(&self, entries: &mut Entries<R>, parameters: &[R]) {
        *entries = Net { shape: self.shape, entries: take(entries) }.scheme(self.factor, parameters).entries.into();
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

    fn run<R: Ring>(&self, entries: &mut Entries<R>, parameters: &[R]) {
        let counts: SmallVec<[usize; 2]> = self.shape.factors.iter().map(|_| 1).collect();
        let mut net = Net { shape: self.shape, entries: entries.to_vec() };
        for _ in 0..self.steps {
            for_each_argument(&self.shape, &counts, parameters, |factor, weights| net = net.step(factor, weights));
            entries.extend(net.entries.iter().cloned());
        }
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

    fn run<R: Ring>(&self, entries: &mut Entries<R>, parameters: &[R]) {
        let count = entries.len();
        entries.resize(2 * count, R::nothing());
        let (left, right) = entries.split_at_mut(count);
        right.swap_with_slice(left);
        split(right, left, self.shape.stride, [&parameters[0], &parameters[1]]);
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

    fn run<R: Ring>(&self, entries: &mut Entries<R>, parameters: &[R]) {
        let simplex = self.shape.factors[self.factor];
        let (outer, inner) = self.shape.blocks(self.factor);
        let scheme = Net { shape: self.shape, entries: take(entries) }.scheme(self.factor, parameters);
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
        *entries = faces.into();
    }
}
