//! Vectors along an edge as polynomials: the derivative along it, and the one
//! from it into a patch.
//!
//! Coefficients are those of Bernstein's polynomials times binomial numbers, so
//! that a product is a convolution and nothing is divided.

use num_bigint::BigInt;

use super::lattice::{Points, View, Whole};
use crate::exact::width::Ring;
use crate::side::Arrangement;

/// A polynomial of one parameter, coefficient `i` belongs to `(1-x)^(n-i) x^i`.
pub(super) type Series<W> = Vec<W>;

/// The sum of products `a b`, as a polynomial.
fn add_product<W: Whole>(sum: &mut [W], a: &[W], b: &[W], negative: bool) {
    for (i, a) in a.iter().enumerate() {
        if a.is_nothing() {
            continue;
        }
        for (j, b) in b.iter().enumerate() {
            if negative {
                let mut product = a.clone();
                product.multiply(b);
                sum[i + j].subtract(&product);
            } else {
                sum[i + j].add_product(a, b);
            }
        }
    }
}

/// The product of two polynomials.
pub(super) fn product<W: Whole>(a: &[W], b: &[W]) -> Series<W> {
    let mut sum = vec![W::nothing(); a.len() + b.len() - 1];
    add_product(&mut sum, a, b, false);
    sum
}

/// The binomial numbers of a degree.
pub(super) fn binomials<W: Whole>(degree: usize) -> Vec<W> {
    let mut row = Vec::with_capacity(degree + 1);
    let mut number = W::unit();
    for k in 0..degree {
        row.push(number.clone());
        number.multiply(&W::from_count(degree - k));
        number.divide_exactly(&W::from_count(k + 1));
    }
    row.push(number);
    row
}

/// A vector for every value of the parameter: its coordinates, all of one degree.
#[derive(Clone, Debug)]
pub(super) struct Field<W> {
    pub(super) coordinates: Vec<Series<W>>,
}

impl<W: Whole> Field<W> {
    pub(super) fn degree(&self) -> usize {
        self.coordinates[0].len() - 1
    }

    pub(super) fn is_zero(&self) -> bool {
        self.coordinates.iter().flatten().all(W::is_nothing)
    }

    /// The same vectors with numbers of any length.
    pub(super) fn widened(&self) -> Field<BigInt> {
        let wide = |series: &Series<W>| series.iter().cloned().map(Into::into).collect();
        Field { coordinates: self.coordinates.iter().map(wide).collect() }
    }

    /// The same vectors, written with a higher degree.
    pub(super) fn with_degree(mut self, degree: usize) -> Self {
        let missing = degree.saturating_sub(self.degree());
        if missing > 0 {
            let ones = binomials(missing);
            self.coordinates = self.coordinates.iter().map(|series| product(series, &ones)).collect();
        }
        self
    }

    /// Three coordinates' vector product.
    pub(super) fn cross(&self, other: &Self) -> Self {
        let entry = |i: usize, j: usize| {
            let (a, b) = (&self.coordinates, &other.coordinates);
            let mut sum = vec![W::nothing(); self.degree() + other.degree() + 1];
            add_product(&mut sum, &a[i], &b[j], false);
            add_product(&mut sum, &a[j], &b[i], true);
            sum
        };
        Self { coordinates: vec![entry(1, 2), entry(2, 0), entry(0, 1)] }
    }

    /// The scalar product.
    pub(super) fn dot(&self, other: &Self) -> Series<W> {
        let mut sum = vec![W::nothing(); self.degree() + other.degree() + 1];
        for (a, b) in self.coordinates.iter().zip(&other.coordinates) {
            add_product(&mut sum, a, b, false);
        }
        sum
    }
}

/// The fields of one side of a joint.
pub(super) struct Fields<W> {
    /// Along the edge; none at the end of a curve.
    pub(super) along: Option<Field<W>>,
    /// From the joint into the piece.
    pub(super) into: Field<W>,
}

/// Differences of homogeneous polynomials `(X, W)`: `W X' - W' X`, the
/// derivative of the quotient up to the positive factor `W²`.
fn quotient_rule<W: Whole>(points: &Field<W>, derivative: &Field<W>) -> Field<W> {
    let last = points.coordinates.len() - 1;
    let (weight, change) = (&points.coordinates[last], &derivative.coordinates[last]);
    let rule = |axis: usize| {
        let mut sum = vec![W::nothing(); points.degree() + derivative.degree() + 1];
        add_product(&mut sum, weight, &derivative.coordinates[axis], false);
        add_product(&mut sum, change, &points.coordinates[axis], true);
        sum
    };
    Field { coordinates: (0..last).map(rule).collect() }
}

/// The fields of a piece at a joint, up to positive factors: those of polynomial
/// pieces are differences of control points.
pub(super) fn fields<P: Points + ?Sized>(view: &View<'_, P>, rational: bool) -> Fields<P::Number> {
    let degree = view.degree_along();
    // Into a triangle the layers lose a point each.
    let lost = usize::from(matches!(view.arrangement(), Arrangement::Triangle(_)));
    let weigh = |degree: usize, entry: &dyn Fn(usize, usize) -> P::Number| {
        let binomials = binomials::<P::Number>(degree);
        let coordinate = |axis: usize| {
            let number = |(column, factor): (usize, &P::Number)| {
                let mut number = entry(column, axis);
                number.multiply(factor);
                number
            };
            binomials.iter().enumerate().map(number).collect()
        };
        Field { coordinates: (0..view.dimension()).map(coordinate).collect() }
    };
    let difference = |mut to: P::Number, from: &P::Number| {
        to.subtract(from);
        to
    };
    let into = |column: usize, axis: usize| difference(view.get(1, column, axis), &view.get(0, column, axis));
    let along = |column: usize, axis: usize| difference(view.get(0, column + 1, axis), &view.get(0, column, axis));
    let into = if view.degree_across() == 0 { weigh(0, &|_, _| P::Number::nothing()) } else { weigh(degree - lost.min(degree), &into) };
    let along = (degree > 0).then(|| weigh(degree - 1, &along));
    if !rational {
        return Fields { along, into };
    }
    let points = weigh(degree, &|column, axis| view.get(0, column, axis));
    Fields { along: along.map(|along| quotient_rule(&points, &along)), into: quotient_rule(&points, &into) }
}
