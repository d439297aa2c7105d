//! Changes of frame.

use smallvec::SmallVec;

use super::{form_of_net, multinomial_growth};
use crate::exact::magnitude::Magnitude;
use crate::exact::width::{Entries, Ring};
use crate::kernel::coefficient::Task;
use crate::kernel::form::Form;
use crate::kernel::reframe::Reframe;
use crate::kernel::shape::Shape;

/// Brings a map over to another frame. The result is a form.
pub(crate) struct ChangeFrame {
    pub(crate) shape: Shape,
    /// One plan a factor; their parameters follow each other.
    pub(crate) reframes: SmallVec<[Reframe; 2]>,
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

    fn run<R: Ring>(&self, entries: &mut Entries<R>, parameters: &[R]) {
        let entries = &mut entries[..];
        let mut form = if self.from_form { Form { shape: self.shape, entries } } else { form_of_net(&self.shape, entries) };
        let mut rest = parameters;
        for reframe in &self.reframes {
            let (own, others) = rest.split_at(reframe.parameter_count());
            rest = others;
            reframe.apply(&mut form, own);
        }
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

    fn run<R: Ring>(&self, entries: &mut Entries<R>, parameters: &[R]) {
        self.change.run(entries, parameters);
        let mut points = entries.chunks_exact(self.change.shape.stride);
        let mut edge: Vec<&[R]> = Vec::new();
        self.change.shape.for_each(|exponents| edge.extend(points.next().filter(|_| exponents[0] == 0)));
        // In the order of the triangle vertex 2 comes before vertex 1.
        let edge = edge.into_iter().rev().flatten().cloned().collect();
        *entries = edge;
    }
}
