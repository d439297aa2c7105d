//! Values, one or a grid of them.

use smallvec::SmallVec;

use super::{for_each_argument, form_of_net, multinomial_growth, weights_growth};
use crate::exact::magnitude::Magnitude;
use crate::exact::width::Ring;
use crate::kernel::coefficient::Task;
use crate::kernel::form::Form;
use crate::kernel::shape::{Factor, Shape};

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
