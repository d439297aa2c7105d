//! Maps as homogeneous polynomials: changing vertices, elevating, multiplying.
//!
//! The form of a net has the coefficients `G_α = multinomial(α) · b_α`, so that
//! a change of frame is a linear substitution with integer entries, and no
//! common multiple of multinomial numbers is ever needed. The coefficients
//! `a_k` of an equation are the form over the origin and the direction.

use std::ops::DerefMut;

use smallvec::SmallVec;

use super::shape::{Factor, Shape};
use crate::exact::width::{Ring, powers};

/// A map in the homogeneous coordinates of its frame's vertices, its entries
/// held as a list or as a slice of somebody else's.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Form<E> {
    pub(crate) shape: Shape,
    pub(crate) entries: E,
}

impl<R: Ring, E: DerefMut<Target = [R]>> Form<E> {
    /// Replaces one vertex of a factor by the combination of all its vertices
    /// with these weights; the weight at `vertex` itself must not be zero if
    /// the new vertices are to be a frame.
    pub(crate) fn replace(&mut self, factor: usize, vertex: usize, weights: &[R]) {
        self.scale(factor, vertex, &weights[vertex]);
        for (source, weight) in weights.iter().enumerate() {
            if source != vertex && !weight.is_nothing() {
                self.shear(factor, source, vertex, weight);
            }
        }
    }

    /// Multiplies every entry by `weight` to the power of its exponent at `vertex`.
    pub(crate) fn scale(&mut self, factor: usize, vertex: usize, weight: &R) {
        self.with_powers(factor, vertex, weight, R::multiply);
    }

    /// Undoes [`Form::scale`] where the entries are known to be multiples.
    pub(crate) fn unscale(&mut self, factor: usize, vertex: usize, weight: &R) {
        match weight.undo() {
            Some(inverse) => self.scale(factor, vertex, &inverse),
            None => self.with_powers(factor, vertex, weight, R::divide_exactly),
        }
    }

    #[inline]
    fn with_powers(&mut self, factor: usize, vertex: usize, weight: &R, apply: impl Fn(&mut R, &R)) {
        if weight.is_unit() {
            return;
        }
        let simplex = self.shape.factors[factor];
        if simplex.dimension != 1 {
            return self.with_powers_of_simplex(factor, vertex, weight, apply);
        }
        let inner = self.shape.inner(factor);
        for_each_block(&mut self.entries, (simplex.degree + 1) * inner, |block| {
            // The exponents of a curve count up or down: one running power.
            let mut power = R::unit();
            if inner == 1 {
                // One coordinate is frequent, and not worth a loop of its own.
                let next = |scalar: &mut R| {
                    power.multiply(weight);
                    apply(scalar, &power);
                };
                return match vertex {
                    1 => block[1..].iter_mut().for_each(next),
                    _ => block[..simplex.degree].iter_mut().rev().for_each(next),
                };
            }
            let next = |point: &mut [R]| {
                power.multiply(weight);
                point.iter_mut().for_each(|scalar| apply(scalar, &power));
            };
            match vertex {
                1 => block[inner..].chunks_exact_mut(inner).for_each(next),
                _ => block[..simplex.degree * inner].chunks_exact_mut(inner).rev().for_each(next),
            }
        });
    }

    #[inline(never)]
    fn with_powers_of_simplex(&mut self, factor: usize, vertex: usize, weight: &R, apply: impl Fn(&mut R, &R)) {
        let simplex = self.shape.factors[factor];
        let (outer, inner) = self.shape.blocks(factor);
        let powers = powers(weight, simplex.degree);
        let mut entries = self.entries.chunks_exact_mut(inner);
        for _ in 0..outer {
            simplex.for_each(|exponents| {
                let Some(entry) = entries.next() else { return };
                if exponents[vertex] > 0 {
                    entry.iter_mut().for_each(|scalar| apply(scalar, &powers[exponents[vertex]]));
                }
            });
        }
    }

    /// Substitutes `x_source + weight · x_target` for `x_source`.
    fn shear(&mut self, factor: usize, source: usize, target: usize, weight: &R) {
        if weight.is_unit() {
            self.shear_by(factor, source, target, R::add);
        } else if R::LONG && (weight.is_odd() || !R::WRAPS) {
            // In units of `weight` the vertex is sheared by 1: a linear number
            // of multiplications instead of a quadratic one. (The larger
            // entries on the way may wrap.)
            self.scale(factor, source, weight);
            self.shear_by(factor, source, target, R::add);
            self.unscale(factor, source, weight);
        } else {
            self.shear_by(factor, source, target, |to, from| to.add_product(from, weight));
        }
    }

    /// The same, given how a multiple of one entry is added to another.
    #[inline]
    fn shear_by(&mut self, factor: usize, source: usize, target: usize, add: impl Fn(&mut R, &R)) {
        let simplex = self.shape.factors[factor];
        let inner = self.shape.inner(factor);
        if simplex.dimension == 1 {
            // Neighbours on the one line of a curve are neighbours in memory.
            return for_each_block(&mut self.entries, (simplex.degree + 1) * inner, |block| {
                if target == 1 { shear_up(block, inner, &add) } else { shear_down(block, inner, &add) }
            });
        }
        let lines = lines(simplex, source, target);
        for_each_block(&mut self.entries, simplex.count() * inner, |block| {
            for line in &lines {
                // Horner's scheme: each pass carries one power of x_source over.
                for last in (1..line.len()).rev() {
                    for k in 1..=last {
                        for offset in 0..inner {
                            let (from, to) = pair(block, line[k - 1] * inner + offset, line[k] * inner + offset);
                            add(to, from);
                        }
                    }
                }
            }
        });
    }
}

impl<R: Ring> Form<Vec<R>> {
    /// The form of the same map with `by` more arguments in a factor: the form
    /// times that power of the sum of the factor's coordinates. Over vertices
    /// that are points this sum is 1.
    pub(crate) fn elevate(&mut self, factor: usize, by: usize) {
        for _ in 0..by {
            let small = self.shape.factors[factor];
            let large = Factor { degree: small.degree + 1, ..small };
            let (outer, inner) = self.shape.blocks(factor);
            let mut entries = vec![R::nothing(); outer * large.count() * inner];
            for repeat in 0..outer {
                let mut source = repeat * small.count();
                small.for_each(|exponents| {
                    let mut raised: SmallVec<[usize; 4]> = SmallVec::from_slice(exponents);
                    for vertex in 0..=small.dimension {
                        raised[vertex] += 1;
                        let target = (repeat * large.count() + large.index(&raised[1..])) * inner;
                        raised[vertex] -= 1;
                        for offset in 0..inner {
                            entries[target + offset].add(&self.entries[source * inner + offset]);
                        }
                    }
                    source += 1;
                });
            }
            self.shape.factors[factor] = large;
            self.entries = entries;
        }
    }

    /// Undoes elevating a curve by one argument, where the map is known to
    /// have one to spare.
    pub(crate) fn lower(&mut self) {
        let (degree, stride) = (self.shape.factors[0].degree, self.shape.stride);
        for position in stride..degree * stride {
            let (done, rest) = self.entries.split_at_mut(position);
            rest[0].subtract(&done[position - stride]);
        }
        self.entries.truncate(degree * stride);
        self.shape.factors[0].degree -= 1;
    }

    /// The product of two maps over the same vertices, coordinate by
    /// coordinate; a map with one coordinate multiplies every coordinate of the other.
    pub(crate) fn product(&self, other: &Self) -> Self {
        let mut shape = self.shape;
        for (factor, more) in shape.factors.iter_mut().zip(other.shape.factors.iter()) {
            factor.degree += more.degree;
        }
        let stride = self.shape.stride.max(other.shape.stride);
        shape.stride = stride;
        let mut entries = vec![R::nothing(); shape.points() * stride];
        let mut firsts = self.entries.chunks_exact(self.shape.stride);
        self.shape.for_each(|alpha| {
            let Some(first) = firsts.next() else { return };
            let mut seconds = other.entries.chunks_exact(other.shape.stride);
            other.shape.for_each(|beta| {
                let Some(second) = seconds.next() else { return };
                let sum: SmallVec<[usize; 6]> = alpha.iter().zip(beta).map(|(a, b)| a + b).collect();
                let place = shape.index(&sum) * stride;
                for (offset, entry) in entries[place..place + stride].iter_mut().enumerate() {
                    entry.add_product(&first[offset % first.len()], &second[offset % second.len()]);
                }
            });
        });
        Self { shape, entries }
    }

    /// The value where the vertices have these weights, one list of weights
    /// after the other: the sum of all entries times their monomials.
    pub(crate) fn value(&self, weights: &[R]) -> Vec<R> {
        let mut tables: SmallVec<[SmallVec<[R; 16]>; 3]> = SmallVec::new();
        let mut rest = weights;
        for factor in self.shape.factors.iter() {
            let (own, others) = rest.split_at(factor.dimension + 1);
            rest = others;
            tables.extend(own.iter().map(|weight| powers(weight, factor.degree)));
        }
        let mut sums = vec![R::nothing(); self.shape.stride];
        let mut entries = self.entries.chunks_exact(self.shape.stride);
        self.shape.for_each(|exponents| {
            let Some(entry) = entries.next() else { return };
            if entry.iter().all(R::is_nothing) {
                return;
            }
            let mut monomial = tables[0][exponents[0]].clone();
            for (powers, &exponent) in tables.iter().zip(exponents).skip(1) {
                monomial.multiply(&powers[exponent]);
            }
            for (sum, coefficient) in sums.iter_mut().zip(entry) {
                sum.add_product(coefficient, &monomial);
            }
        });
        sums
    }
}

/// Visits the entries in pieces of one length. (`chunks_exact_mut` would divide,
/// which is felt on the few entries of a cubic.)
#[inline]
fn for_each_block<R>(mut entries: &mut [R], length: usize, mut visit: impl FnMut(&mut [R])) {
    while let Some((block, rest)) = entries.split_at_mut_checked(length)
        && length > 0
    {
        visit(block);
        entries = rest;
    }
}

/// One pass of Horner's scheme: every entry takes in the one before it.
#[inline]
fn carry<'a, R: 'a>(mut line: impl Iterator<Item = &'a mut R>, add: impl Fn(&mut R, &R)) {
    let Some(first) = line.next() else { return };
    let mut from = &*first;
    for to in line {
        add(to, from);
        from = to;
    }
}

/// Horner's scheme on a line that lies in order, `inner` interleaved ones at a time.
#[inline]
fn shear_up<R>(block: &mut [R], inner: usize, add: impl Fn(&mut R, &R)) {
    let mut end = block.len();
    while end > inner {
        if inner == 1 {
            carry(block[..end].iter_mut(), &add);
        } else {
            for place in inner..end {
                let (head, tail) = block[place - inner..end].split_at_mut(inner);
                add(&mut tail[0], &head[0]);
            }
        }
        end -= inner;
    }
}

/// The same on a line that lies in reverse order.
#[inline]
fn shear_down<R>(block: &mut [R], inner: usize, add: impl Fn(&mut R, &R)) {
    let mut start = 0;
    while start + inner < block.len() {
        if inner == 1 {
            carry(block[start..].iter_mut().rev(), &add);
        } else {
            for place in (start..block.len() - inner).rev() {
                let (head, tail) = block[place..].split_at_mut(inner);
                add(&mut head[0], &tail[0]);
            }
        }
        start += inner;
    }
}

/// Two different entries, the second one to be changed.
#[inline]
fn pair<R>(block: &mut [R], source: usize, target: usize) -> (&R, &mut R) {
    if source < target {
        let (head, tail) = block.split_at_mut(target);
        (&head[source], &mut tail[0])
    } else {
        let (head, tail) = block.split_at_mut(source);
        (&tail[0], &mut head[target])
    }
}

/// The entries along every line from `source` to `target`: each list starts
/// where the exponent at `target` is zero.
fn lines(simplex: Factor, source: usize, target: usize) -> SmallVec<[SmallVec<[usize; 16]>; 1]> {
    let mut lines = SmallVec::new();
    simplex.for_each(|exponents| {
        if exponents[target] > 0 || exponents[source] == 0 {
            return;
        }
        let mut moved: SmallVec<[usize; 4]> = SmallVec::from_slice(exponents);
        let mut line = SmallVec::with_capacity(exponents[source] + 1);
        for _ in 0..=exponents[source] {
            line.push(simplex.index(&moved[1..]));
            if moved[source] > 0 {
                moved[source] -= 1;
                moved[target] += 1;
            }
        }
        lines.push(line);
    });
    lines
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::exact::fixed::Fixed;
    use crate::exact::width::Integer;
    use num_bigint::BigInt;
    use proptest::prelude::*;

    fn triangle(degree: usize, entries: Vec<i128>) -> Form<Vec<i128>> {
        Form { shape: Shape::triangle(degree, 1), entries }
    }

    /// The form as a polynomial: its value at homogeneous coordinates.
    fn value(form: &Form<Vec<i128>>, at: &[i128]) -> Vec<i128> {
        let mut sums = vec![0; form.shape.stride];
        let mut entries = form.entries.chunks_exact(form.shape.stride);
        form.shape.for_each(|exponents| {
            let monomial: i128 = exponents.iter().zip(at).map(|(&exponent, x)| x.pow(exponent as u32)).product();
            for (sum, entry) in sums.iter_mut().zip(entries.next().into_iter().flatten()) {
                *sum += entry * monomial;
            }
        });
        sums
    }

    proptest! {
        #[test]
        fn replacing_is_a_substitution(
            entries in prop::collection::vec(-50i128..50, 10),
            vertex in 0usize..3,
            weights in prop::array::uniform3(-4i128..5),
            at in prop::array::uniform3(-3i128..4),
        ) {
            let form = triangle(3, entries);
            let mut replaced = form.clone();
            replaced.replace(0, vertex, &weights);
            let mut old = at;
            for source in 0..3 {
                old[source] = if source == vertex { weights[vertex] * at[vertex] } else { at[source] + weights[source] * at[vertex] };
            }
            prop_assert_eq!(value(&replaced, &at), value(&form, &old));
        }

        /// Straight loops, wrapping words and additive shears against the definition.
        #[test]
        fn curves_of_any_ring_are_substituted_alike(
            entries in prop::collection::vec(-50i64..50, 12),
            stride in 1usize..4,
            vertex in 0usize..2,
            weights in prop::array::uniform2(-4i64..5),
        ) {
            let degree = 12 / stride - 1;
            let words = Form { shape: Shape::curve(degree, stride), entries: entries[..(degree + 1) * stride].to_vec() };
            let mut long: Form<Vec<_>> = Form { shape: words.shape, entries: words.entries.iter().map(|&x| BigInt::from(x)).collect() };
            let mut double: Form<Vec<i128>> = Form { shape: words.shape, entries: words.entries.iter().map(|&x| i128::from(x)).collect() };
            let before = double.clone();
            long.replace(0, vertex, &weights.map(BigInt::from));
            double.replace(0, vertex, &weights.map(i128::from));
            prop_assert_eq!(&long.entries, &double.entries.iter().map(|&x| BigInt::from(x)).collect::<Vec<_>>());
            // Where the entries on the way are too long, and perhaps the results too.
            let shifted = |x: &BigInt| Fixed::<6>::from_big(&(x << 370)).into_big();
            let mut fixed: Form<Vec<_>> =
                Form { shape: words.shape, entries: words.entries.iter().map(|&x| Fixed::<6>::from_big(&(BigInt::from(x) << 370))).collect() };
            fixed.replace(0, vertex, &weights.map(Fixed::<6>::from_i64));
            prop_assert_eq!(
                fixed.entries.into_iter().map(Fixed::into_big).collect::<Vec<_>>(),
                long.entries.iter().map(shifted).collect::<Vec<_>>()
            );
            for at in [[2i128, 3], [-1, 2], [1, 0], [0, 1]] {
                let mut old = at;
                for source in 0..2 {
                    let weight = i128::from(weights[source]) * at[vertex];
                    old[source] = if source == vertex { weight } else { at[source] + weight };
                }
                prop_assert_eq!(value(&double, &at), value(&before, &old));
            }
            if weights[0] % 2 != 0 {
                let mut scaled = words.clone();
                // Far beyond a word: undoing does not mind.
                for _ in 0..30 {
                    scaled.scale(0, vertex, &weights[0]);
                }
                for _ in 0..30 {
                    scaled.unscale(0, vertex, &weights[0]);
                }
                prop_assert_eq!(scaled, words);
            }
        }

        #[test]
        fn elevating_multiplies_by_the_sum(entries in prop::collection::vec(-50i128..50, 6), at in prop::array::uniform3(-3i128..4)) {
            let form = triangle(2, entries);
            let mut elevated = form.clone();
            elevated.elevate(0, 2);
            let sum: i128 = at.iter().sum();
            prop_assert_eq!(value(&elevated, &at)[0], value(&form, &at)[0] * sum * sum);
        }

        #[test]
        fn lowering_undoes_elevating(entries in prop::collection::vec(-50i128..50, 8)) {
            let form = Form { shape: Shape::curve(3, 2), entries };
            let mut elevated = form.clone();
            elevated.elevate(0, 1);
            elevated.lower();
            prop_assert_eq!(elevated, form);
        }

        #[test]
        fn products_multiply_values(
            a in prop::collection::vec(-50i128..50, 4),
            b in prop::collection::vec(-50i128..50, 6),
            at in prop::array::uniform2(-3i128..4),
        ) {
            let scalar = Form { shape: Shape::curve(3, 1), entries: a };
            let vector = Form { shape: Shape::curve(2, 2), entries: b };
            let factor = value(&scalar, &at)[0];
            let expected: Vec<i128> = value(&vector, &at).iter().map(|x| x * factor).collect();
            prop_assert_eq!(value(&scalar.product(&vector), &at), expected.clone());
            prop_assert_eq!(value(&vector.product(&scalar), &at), expected);
        }
    }
}
