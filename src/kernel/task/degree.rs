//! More arguments, fewer arguments, products.

use super::{form_of_net, multinomial_growth, take};
use crate::exact::magnitude::Magnitude;
use crate::exact::width::{Entries, Ring};
use crate::kernel::coefficient::Task;
use crate::kernel::shape::Shape;

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

    fn run<R: Ring>(&self, entries: &mut Entries<R>, _: &[R]) {
        let mut form = form_of_net(&self.shape, take(entries));
        let degree = self.shape.factors[self.factor].degree;
        form.elevate(self.factor, self.degree.saturating_sub(degree));
        for _ in self.degree..degree {
            form.lower();
        }
        *entries = form.entries.into();
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

    fn run<R: Ring>(&self, entries: &mut Entries<R>, parameters: &[R]) {
        let product = form_of_net(&self.first, take(entries)).product(&form_of_net(&self.second, parameters.to_vec()));
        *entries = product.entries.into();
    }
}
