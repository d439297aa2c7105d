//! Values, one or a grid of them.

use smallvec::SmallVec;

use super::{for_each_argument, form_of_net, multinomial_growth, take, weights_growth};
use crate::exact::magnitude::Magnitude;
use crate::exact::width::{Entries, Ring};
use crate::kernel::coefficient::Task;
use crate::kernel::form::Form;
use crate::kernel::shape::Shape;

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

    fn run<R: Ring>(&self, entries: &mut Entries<R>, parameters: &[R]) {
        *entries = Form { shape: self.shape, entries: take(entries) }.value(parameters).into();
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
        (0..shape.factors.len()).fold(*shape, |target, factor| target.with_degree(factor, steps))
    }
}

impl Task for Grid {
    fn growth<R: Ring>(&self, _: &[R]) -> Magnitude {
        let steps = Magnitude::from(self.steps.max(1) as u64);
        // The tables of powers go one further than what is used of them.
        self.shape.factors.iter().fold(multinomial_growth(&self.shape), |growth, factor| growth.times(steps.power(factor.degree + 1)))
    }

    fn run<R: Ring>(&self, entries: &mut Entries<R>, _: &[R]) {
        let form = form_of_net(&self.shape, take(entries));
        let mut weights: SmallVec<[R; 6]> = SmallVec::new();
        Self::target(&self.shape, self.steps).for_each(|shares| {
            weights.clear();
            weights.extend(shares.iter().map(|&share| R::from_count(share)));
            entries.extend(form.value(&weights));
        });
    }
}
