//! Index arithmetic of products of simplices.
//!
//! The entries of a simplex of dimension `d` and degree `m` are the exponents
//! `(α_0, …, α_d)` with sum `m`, in lexicographic order of `(α_1, …, α_d)`;
//! vertex 0 is implicit. For a triangle of degree 2 with vertices t, r, s:
//!
//! ```text
//!   index      0   1   2 | 3   4 | 5
//!   (r, s)    00  01  02  10  11  20
//!   label     tt  ts  ss  tr  rs  rr
//! ```

use std::fmt;
use std::ops::{Deref, DerefMut};

use smallvec::SmallVec;

/// One simplex of the product.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Factor {
    pub(crate) dimension: usize,
    pub(crate) degree: usize,
}

impl Factor {
    /// The number of entries: the binomial number `C(degree + dimension, dimension)`.
    #[inline]
    pub(crate) fn count(self) -> usize {
        if self.dimension == 1 {
            return self.degree + 1;
        }
        let mut count = 1;
        for k in 1..=self.dimension {
            count = count * (self.degree + k) / k;
        }
        count
    }

    /// The place of the exponents `(α_1, …, α_d)`.
    pub(crate) fn index(self, exponents: &[usize]) -> usize {
        let Factor { mut dimension, mut degree } = self;
        let mut index = 0;
        for &exponent in exponents {
            let whole = Factor { dimension, degree }.count();
            degree -= exponent;
            index += whole - Factor { dimension, degree }.count();
            dimension -= 1;
        }
        index
    }

    /// Calls `visit` with the exponents `(α_0, …, α_d)` of every entry in order.
    #[inline]
    pub(crate) fn for_each(self, mut visit: impl FnMut(&[usize])) {
        if self.dimension == 1 {
            // Every curve: nothing to carry.
            (0..=self.degree).for_each(|exponent| visit(&[self.degree - exponent, exponent]));
            return;
        }
        let mut exponents: SmallVec<[usize; 4]> = SmallVec::from_elem(0, self.dimension + 1);
        exponents[0] = self.degree;
        loop {
            visit(&exponents);
            // The lexicographic successor: move one unit from vertex 0 to the
            // last vertex, carrying to the left where vertex 0 is empty.
            let mut last = self.dimension;
            while last > 0 && exponents[0] == 0 {
                exponents[0] += std::mem::take(&mut exponents[last]);
                last -= 1;
            }
            if last == 0 {
                return;
            }
            exponents[0] -= 1;
            exponents[last] += 1;
        }
    }
}

/// One simplex or the product of two: as a slice, outermost first.
#[derive(Clone, Copy)]
pub(crate) struct Factors {
    list: [Factor; 2],
    both: bool,
}

impl Deref for Factors {
    type Target = [Factor];
    #[inline]
    fn deref(&self) -> &[Factor] {
        if self.both { &self.list } else { &self.list[..1] }
    }
}

impl DerefMut for Factors {
    #[inline]
    fn deref_mut(&mut self) -> &mut [Factor] {
        if self.both { &mut self.list } else { &mut self.list[..1] }
    }
}

impl From<Factor> for Factors {
    #[inline]
    fn from(factor: Factor) -> Self {
        Self { list: [factor; 2], both: false }
    }
}

impl From<[Factor; 2]> for Factors {
    fn from(list: [Factor; 2]) -> Self {
        Self { list, both: true }
    }
}

impl PartialEq for Factors {
    fn eq(&self, other: &Self) -> bool {
        self[..] == other[..]
    }
}

impl Eq for Factors {}

impl fmt::Debug for Factors {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self[..].fmt(f)
    }
}

/// The layout of a net: simplices, then the coordinates of a point.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Shape {
    pub(crate) factors: Factors,
    /// The number of coordinates of a point.
    pub(crate) stride: usize,
}

impl Shape {
    /// The shape of a curve of polar degree `degree` in `stride` dimensions.
    #[inline]
    pub(crate) fn curve(degree: usize, stride: usize) -> Self {
        Self { factors: Factor { dimension: 1, degree }.into(), stride }
    }

    /// The shape of a triangular net of total degree `degree`.
    pub(crate) fn triangle(degree: usize, stride: usize) -> Self {
        Self { factors: Factor { dimension: 2, degree }.into(), stride }
    }

    /// The shape of a rectangular net of bidegree `(p, q)`.
    pub(crate) fn rectangle(p: usize, q: usize, stride: usize) -> Self {
        Self { factors: [p, q].map(|degree| Factor { dimension: 1, degree }).into(), stride }
    }

    /// The number of points.
    #[inline]
    pub(crate) fn points(&self) -> usize {
        let [first, second] = self.factors.list;
        if self.factors.both { first.count() * second.count() } else { first.count() }
    }

    /// How often the factor repeats, and how many scalars one of its entries spans.
    #[inline]
    pub(crate) fn blocks(&self, factor: usize) -> (usize, usize) {
        (if factor == 0 { 1 } else { self.factors.list[0].count() }, self.inner(factor))
    }

    /// How many scalars one of the factor's entries spans.
    #[inline]
    pub(crate) fn inner(&self, factor: usize) -> usize {
        if factor == 0 && self.factors.both { self.factors.list[1].count() * self.stride } else { self.stride }
    }

    /// The place of the point with these exponents at all vertices of all factors.
    pub(crate) fn index(&self, exponents: &[usize]) -> usize {
        let mut rest = exponents;
        self.factors.iter().fold(0, |index, factor| {
            let (own, others) = rest.split_at(factor.dimension + 1);
            rest = others;
            index * factor.count() + factor.index(&own[1..])
        })
    }

    pub(crate) fn with_degree(mut self, factor: usize, degree: usize) -> Self {
        self.factors[factor].degree = degree;
        self
    }

    /// Calls `visit` with the exponents of every point at all vertices of all factors.
    #[inline]
    pub(crate) fn for_each(&self, mut visit: impl FnMut(&[usize])) {
        if let [factor] = self.factors[..] {
            return factor.for_each(visit);
        }
        let mut lists: SmallVec<[Vec<usize>; 2]> = SmallVec::new();
        for factor in self.factors.iter() {
            let mut list = Vec::with_capacity(factor.count() * (factor.dimension + 1));
            factor.for_each(|exponents| list.extend_from_slice(exponents));
            lists.push(list);
        }
        let widths: SmallVec<[usize; 2]> = self.factors.iter().map(|factor| factor.dimension + 1).collect();
        let mut exponents: SmallVec<[usize; 6]> = SmallVec::new();
        for point in 0..self.points() {
            exponents.clear();
            let mut rest = self.points();
            for ((factor, list), &width) in self.factors.iter().zip(&lists).zip(&widths) {
                rest /= factor.count();
                let entry = point / rest % factor.count();
                exponents.extend_from_slice(&list[entry * width..(entry + 1) * width]);
            }
            visit(&exponents);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn indices_follow_the_order_of_enumeration() {
        for dimension in 0..4 {
            for degree in 0..6 {
                let factor = Factor { dimension, degree };
                let mut next = 0;
                factor.for_each(|exponents| {
                    assert_eq!(exponents.iter().sum::<usize>(), degree);
                    assert_eq!(factor.index(&exponents[1..]), next);
                    next += 1;
                });
                assert_eq!(next, factor.count());
            }
        }
    }

    #[test]
    fn products_run_over_the_last_factor_first() {
        let shape = Shape::rectangle(1, 2, 3);
        let mut seen = Vec::new();
        shape.for_each(|exponents| seen.push((exponents[1], exponents[3])));
        let mut next = 0;
        shape.for_each(|exponents| {
            assert_eq!(shape.index(exponents), next);
            next += 1;
        });
        assert_eq!(seen, [(0, 0), (0, 1), (0, 2), (1, 0), (1, 1), (1, 2)]);
        assert_eq!(shape.blocks(0), (1, 9));
        assert_eq!(shape.blocks(1), (2, 3));
    }
}
