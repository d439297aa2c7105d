//! The order of parametric continuity of two pieces over unit parameters.

use super::field::{binomials, product};
use super::lattice::{Points, View};
use crate::continuity::Continuity;
use crate::exact::width::Ring;

/// What two pieces that meet have to be brought to before derivatives compare.
struct Common {
    /// The degree along the edge, if theirs differ.
    along: Option<usize>,
    /// Whether their degrees across it differ.
    across: bool,
}

/// All derivatives of an order into a piece, coordinate by coordinate and column
/// by column.
fn derivatives<P: Points + ?Sized>(view: &View<'_, P>, order: usize, common: &Common) -> Vec<P::Number> {
    let across = view.degree_across();
    let columns = view.degree_along() + 1;
    if order > across {
        return vec![P::Number::nothing(); view.dimension() * common.along.map_or(columns, |degree| degree + 1)];
    }
    let signs = binomials::<P::Number>(order);
    // m (m-1) … (m-k+1)
    let falling = (0..order).fold(P::Number::unit(), |mut falling, k| {
        falling.multiply(&P::Number::from_count(across - k));
        falling
    });
    let difference = |axis: usize, column: usize| {
        let mut sum = P::Number::nothing();
        for (layer, factor) in signs.iter().enumerate() {
            let mut term = view.get(layer, column, axis);
            if order > 1 {
                term.multiply(factor);
            }
            if (order - layer).is_multiple_of(2) { sum.add(&term) } else { sum.subtract(&term) }
        }
        if common.across {
            sum.multiply(&falling);
        }
        sum
    };
    let mut all = Vec::with_capacity(view.dimension() * columns);
    for axis in 0..view.dimension() {
        let series = (0..columns).map(|column| difference(axis, column));
        match common.along {
            None => all.extend(series),
            Some(degree) => {
                let weighted = series.zip(binomials(columns - 1)).map(|(mut number, factor): (_, P::Number)| {
                    number.multiply(&factor);
                    number
                });
                all.extend(product(&weighted.collect::<Vec<_>>(), &binomials(degree + 1 - columns)));
            }
        }
    }
    all
}

/// The order of two polynomial curves at a common end, or of two rectangles
/// along a common edge, each over parameters from 0 to 1 that run on across it:
/// up to that order all derivatives agree.
pub(super) fn order<P: Points + ?Sized>(a: &View<'_, P>, b: &View<'_, P>) -> Continuity {
    let most = a.degree_across().max(b.degree_across());
    let common = Common {
        along: (a.degree_along() != b.degree_along()).then(|| a.degree_along().max(b.degree_along())),
        across: a.degree_across() != b.degree_across(),
    };
    for order in 0..=most {
        let mut of_a = derivatives(a, order, &common);
        let of_b = derivatives(b, order, &common);
        if !order.is_multiple_of(2) {
            // Into the second piece is out of the first.
            for number in &mut of_a {
                let mut opposite = P::Number::nothing();
                opposite.subtract(number);
                *number = opposite;
            }
        }
        if of_a != of_b {
            return if order == 0 { Continuity::Broken } else { Continuity::C(order - 1) };
        }
    }
    Continuity::Same
}
