//! A change of frame as replacements of one vertex at a time.

use smallvec::{SmallVec, smallvec};

use super::form::Form;
use super::integers::{IntegerSlice, Integers};
use crate::exact::magnitude::Magnitude;
use crate::exact::width::Ring;

/// How to bring a factor's form over to new vertices.
///
/// Each new vertex is an integer combination of the old ones. After the first
/// replacements the remaining new vertices must be expressed in the changed
/// frame, which would divide by the weight replaced at; instead they are
/// multiplied by it, and what that adds to the entries is divided out at the
/// end, exactly (fraction-free elimination).
///
/// The plan itself holds no numbers. Its parameters are made with it and handed
/// back when it is applied, in the ring of the entries: a row of weights for
/// each replacement, then for each new vertex the surplus that its entries
/// carry, to the power of their exponent.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Reframe {
    factor: usize,
    places: Places,
    /// The largest sum of the absolute weights on one old vertex, if only the
    /// result needs to fit: every surplus can be undone modulo a power of two.
    column: Option<Magnitude>,
}

/// The old vertex in whose place each new one is put, in order.
#[derive(Clone, Copy, Debug)]
struct Places {
    list: [u8; 3],
    count: u8,
}

impl Places {
    #[inline]
    fn iter(&self) -> impl ExactSizeIterator<Item = usize> {
        self.list[..usize::from(self.count)].iter().map(|&place| usize::from(place))
    }

    #[inline]
    fn push(&mut self, place: usize) {
        self.list[usize::from(self.count)] = place as u8;
        self.count += 1;
    }

    /// A free place that fits, the next one's own if that does.
    #[inline]
    fn find(&self, fits: impl Fn(usize) -> bool, size: usize) -> Option<usize> {
        let own = usize::from(self.count);
        let free = |place: usize| self.iter().all(|taken| taken != place) && fits(place);
        if free(own) { Some(own) } else { (0..size).find(|&place| free(place)) }
    }
}

impl Reframe {
    /// The plan for new vertices given by rows of weights on the old ones, or
    /// `None` if they are not a frame. Appends its parameters.
    #[inline]
    pub(crate) fn new<R: Ring>(factor: usize, size: usize, rows: IntegerSlice<'_, R>, parameters: &mut Integers<R>) -> Option<Self> {
        let start = parameters.as_slice().len();
        parameters.extend(rows);
        (0..size).for_each(|_| parameters.push_word(1));
        // Short integers are eliminated as such: every step adds one bit to twice the bits.
        let bits = 48 >> (size - 1).min(6);
        if let Integers::Words(words) = parameters {
            let own = &mut words[start..];
            if own.iter().all(|word| word.unsigned_abs() >> bits == 0) {
                return Self::eliminate(factor, size, own);
            }
        }
        Self::eliminate(factor, size, &mut parameters.as_elements_mut()[start..])
    }

    /// Makes rows of replacements of rows of weights, and the surplus of ones after them.
    #[inline]
    fn eliminate<R: Ring>(factor: usize, size: usize, rows: &mut [R]) -> Option<Self> {
        let (rows, surplus) = rows.split_at_mut(size * size);
        let mut column = Magnitude::ONE;
        for vertex in 0..size {
            column = column.max((0..size).fold(Magnitude::ZERO, |sum, new| sum.plus(rows[new * size + vertex].magnitude())));
        }
        let mut places = Places { list: [0; 3], count: 0 };
        let mut undone = true;
        for new in 0..size {
            // Its own place where possible, so that nothing needs reordering;
            // but rather a place with an odd weight, which can be undone.
            let (done, rest) = rows.split_at_mut((new + 1) * size);
            let row = &done[new * size..];
            let vertex = match places.find(|vertex| row[vertex].is_odd(), size) {
                Some(vertex) => vertex,
                None => {
                    undone &= new + 1 == size;
                    places.find(|vertex| !row[vertex].is_nothing(), size)?
                }
            };
            for (other, surplus) in rest.chunks_exact_mut(size).zip(&mut surplus[new + 1..]) {
                let at_vertex = other[vertex].clone();
                for position in (0..size).filter(|&position| position != vertex) {
                    let mut share = at_vertex.clone();
                    share.multiply(&row[position]);
                    other[position].multiply(&row[vertex]);
                    other[position].subtract(&share);
                }
                surplus.multiply(&row[vertex]);
            }
            places.push(vertex);
        }
        Some(Self { factor, places, column: undone.then_some(column) })
    }

    /// How many parameters go with the plan: a row for each new vertex, and its surplus.
    pub(crate) fn parameter_count(&self) -> usize {
        let size = self.size();
        size * (size + 1)
    }

    fn size(&self) -> usize {
        self.places.iter().len()
    }

    /// The factor that is brought over.
    pub(crate) fn factor(&self) -> usize {
        self.factor
    }

    /// The most that the change multiplies the sum of the absolute entries by.
    pub(crate) fn growth<R: Ring>(&self, degree: usize, parameters: &[R]) -> Magnitude {
        if let Some(column) = self.column {
            // The coordinate of an old vertex becomes the sum of its weights
            // times the new coordinates: a product of as many such sums as the
            // degree has no coefficient above the product of their totals.
            return column.power(degree);
        }
        let sizes: Vec<Magnitude> = parameters.iter().map(R::magnitude).collect();
        let rows = sizes.chunks_exact(self.size());
        self.places.iter().zip(rows).fold(Magnitude::ONE, |growth, (vertex, row)| {
            // A coordinate x_u becomes x_u + w_u z, the replaced one w z.
            let column = row.iter().enumerate().fold(row[vertex].max(Magnitude::ONE), |largest, (position, &weight)| {
                if position == vertex { largest } else { largest.max(weight.plus(Magnitude::ONE)) }
            });
            growth.times(column.power(degree))
        })
    }

    pub(crate) fn apply<R: Ring>(&self, form: &mut Form<&mut [R]>, parameters: &[R]) {
        let size = self.size();
        let (rows, surplus) = parameters.split_at(size * size);
        for (vertex, weights) in self.places.iter().zip(rows.chunks_exact(size)) {
            form.replace(self.factor, vertex, weights);
        }
        for (vertex, surplus) in self.places.iter().zip(surplus) {
            if !surplus.is_unit() {
                form.unscale(self.factor, vertex, surplus);
            }
        }
        self.reorder(form);
    }

    /// Puts the new vertices in their own places.
    fn reorder<R: Ring>(&self, form: &mut Form<&mut [R]>) {
        if self.places.iter().enumerate().all(|(new, place)| new == place) {
            return;
        }
        let simplex = form.shape.factors[self.factor];
        let (outer, inner) = form.shape.blocks(self.factor);
        let mut entries = Vec::with_capacity(form.entries.len());
        for repeat in 0..outer {
            simplex.for_each(|exponents| {
                let mut placed: SmallVec<[usize; 4]> = smallvec![0; exponents.len()];
                for (new, place) in self.places.iter().enumerate() {
                    placed[place] = exponents[new];
                }
                let start = (repeat * simplex.count() + simplex.index(&placed[1..])) * inner;
                entries.extend_from_slice(&form.entries[start..start + inner]);
            });
        }
        form.entries.iter_mut().zip(entries).for_each(|(place, entry)| *place = entry);
    }
}

#[cfg(test)]
mod tests {
    use super::super::shape::Shape;
    use super::*;
    use num_bigint::BigInt;
    use proptest::prelude::*;

    fn binomial(m: usize, k: usize) -> i64 {
        (1..=k).fold(1, |c, i| c * (m + 1 - i) as i64 / i as i64)
    }

    proptest! {
        /// Over the new vertices, the entry of a pure power is a value at the vertex.
        #[test]
        fn corner_entries_are_values(entries in prop::collection::vec(-30i64..30, 10), rows in prop::array::uniform9(-3i64..4)) {
            let shape = Shape::triangle(3, 1);
            let form: Form<Vec<BigInt>> = Form { shape, entries: entries.iter().map(|&x| BigInt::from(x)).collect() };
            let rows: Vec<BigInt> = rows.iter().map(|&x| BigInt::from(x)).collect();
            let determinant = &rows[0] * (&rows[4] * &rows[8] - &rows[5] * &rows[7])
                - &rows[1] * (&rows[3] * &rows[8] - &rows[5] * &rows[6])
                + &rows[2] * (&rows[3] * &rows[7] - &rows[4] * &rows[6]);
            let mut parameters = Integers::default();
            let plan = Reframe::new(0, 3, IntegerSlice::Any(&rows), &mut parameters);
            prop_assert_eq!(plan.is_some(), determinant != BigInt::ZERO);
            if let Some(plan) = plan {
                let parameters = parameters.as_slice().to_elements();
                let mut reframed = form.clone();
                plan.apply(&mut Form { shape, entries: &mut reframed.entries }, &parameters);
                let total = |form: &Form<Vec<BigInt>>| form.entries.iter().map(|x| x.magnitude().clone()).sum::<num_bigint::BigUint>();
                let bound = plan.growth(3, &parameters).times(Magnitude::from_big(&total(&form)));
                prop_assert!(total(&reframed).bits() <= bound.bits());
                for (new, index) in [(0, 0), (1, 9), (2, 3)] {
                    let mut value = BigInt::ZERO;
                    let mut entries = form.entries.iter();
                    form.shape.for_each(|exponents| {
                        let mut term = entries.next().cloned().unwrap_or_default();
                        for (vertex, &exponent) in exponents.iter().enumerate() {
                            term *= rows[3 * new + vertex].pow(exponent as u32);
                        }
                        value += term;
                    });
                    prop_assert_eq!(&reframed.entries[index], &value);
                }
            }
        }

        /// Bernstein coefficients on [r, s] of powers of t, with r = 0 and s = 0 reached.
        #[test]
        fn powers_of_t_over_any_frame(degree in 0usize..7, power in 0usize..7, r in -4i64..5, s in -4i64..5) {
            prop_assume!(power <= degree && r != s);
            let mut form = Form { shape: Shape::curve(degree, 1), entries: vec![0i64; degree + 1] };
            form.entries[power] = 1;
            let mut parameters = Integers::default();
            let plan = Reframe::new(0, 2, IntegerSlice::<i64>::Words(&[1, r, 1, s]), &mut parameters);
            prop_assert!(plan.is_some());
            if let Some(plan) = plan {
                plan.apply(&mut Form { shape: form.shape, entries: &mut form.entries }, &parameters.as_slice().to_elements());
            }
            // The definition: C(m,k) of f(r^{m-k} s^k) = sum over subsets / C(m,power).
            for k in 0..=degree {
                let sum: i64 = (0..=k.min(power))
                    .filter(|&j| power - j <= degree - k)
                    .map(|j| binomial(k, j) * s.pow(j as u32) * binomial(degree - k, power - j) * r.pow((power - j) as u32))
                    .sum();
                prop_assert_eq!(form.entries[k] * binomial(degree, power), sum * binomial(degree, k));
            }
        }
    }
}
