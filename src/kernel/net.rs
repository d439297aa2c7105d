//! Polar values, and what taking an argument in does to them.

use smallvec::SmallVec;

use super::shape::{Factor, Shape};
use crate::exact::width::Ring;

/// The polar values of a map at the vertices of a product of simplices.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Net<R> {
    pub(crate) shape: Shape,
    pub(crate) entries: Vec<R>,
}

impl<R: Ring> Net<R> {
    /// Takes one argument in: the net of the polar form with one argument of
    /// `factor` fixed at the combination of its vertices with these weights.
    /// The degree in that factor goes down by one.
    pub(crate) fn step(&self, factor: usize, weights: &[R]) -> Self {
        let shape = self.shape.with_degree(factor, self.shape.factors[factor].degree - 1);
        let (outer, inner) = self.shape.blocks(factor);
        let mut entries = Vec::with_capacity(shape.points() * shape.stride);
        let sources = step_sources(shape.factors[factor]);
        let block = self.shape.factors[factor].count() * inner;
        for repeat in 0..outer {
            step_block(&self.entries[repeat * block..(repeat + 1) * block], inner, &sources, weights, &mut entries);
        }
        Self { shape, entries }
    }

    /// All steps of de Casteljau's algorithm with one argument, kept.
    ///
    /// The scheme of a simplex of dimension `d` is a simplex of dimension
    /// `d + 1` whose new vertex is the argument, as vertex 1: layer `l` holds
    /// the entries with exponent `l` there.
    pub(crate) fn scheme(&self, factor: usize, weights: &[R]) -> Self {
        let Factor { dimension, degree } = self.shape.factors[factor];
        let mut shape = self.shape;
        shape.factors[factor] = Factor { dimension: dimension + 1, degree };
        let (outer, inner) = self.shape.blocks(factor);
        let block = self.shape.factors[factor].count() * inner;
        let mut entries = Vec::with_capacity(shape.points() * shape.stride);
        for repeat in 0..outer {
            let mut layer = self.entries[repeat * block..(repeat + 1) * block].to_vec();
            for left in (0..degree).rev() {
                let mut next = Vec::with_capacity(Factor { dimension, degree: left }.count() * inner);
                step_block(&layer, inner, &step_sources(Factor { dimension, degree: left }), weights, &mut next);
                entries.append(&mut layer);
                layer = next;
            }
            entries.append(&mut layer);
        }
        Self { shape, entries }
    }
}

/// De Casteljau's algorithm on a curve, in place: the points end as those of
/// the right half, and those of the left half are written into `left`. Memory stays linear.
pub(crate) fn split<R: Ring>(points: &mut [R], left: &mut [R], stride: usize, [first, second]: [&R; 2]) {
    for (rest, done) in (0..points.len()).step_by(stride).rev().zip(left.chunks_exact_mut(stride)) {
        done.clone_from_slice(&points[..stride]);
        for position in 0..rest {
            let (head, tail) = points.split_at_mut(position + stride);
            let entry = &mut head[position];
            entry.multiply(first);
            entry.add_product(&tail[0], second);
        }
    }
}

/// For every entry of the smaller simplex, its neighbours in the larger one,
/// one toward each vertex.
fn step_sources(target: Factor) -> SmallVec<[usize; 32]> {
    let source = Factor { dimension: target.dimension, degree: target.degree + 1 };
    let mut sources = SmallVec::with_capacity(target.count() * (target.dimension + 1));
    target.for_each(|exponents| {
        let mut raised: SmallVec<[usize; 4]> = SmallVec::from_slice(exponents);
        for vertex in 0..=target.dimension {
            raised[vertex] += 1;
            sources.push(source.index(&raised[1..]));
            raised[vertex] -= 1;
        }
    });
    sources
}

fn step_block<R: Ring>(block: &[R], inner: usize, sources: &[usize], weights: &[R], target: &mut Vec<R>) {
    for neighbours in sources.chunks_exact(weights.len()) {
        for offset in 0..inner {
            let mut sum = R::nothing();
            for (&neighbour, weight) in neighbours.iter().zip(weights) {
                sum.add_product(&block[neighbour * inner + offset], weight);
            }
            target.push(sum);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn triangle(entries: Vec<i64>) -> Net<i64> {
        Net { shape: Shape::triangle(2, 1), entries }
    }

    #[test]
    fn a_curve_steps_between_neighbours() {
        let net = Net { shape: Shape::curve(2, 2), entries: vec![0i64, 0, 1, 2, 4, 4] };
        assert_eq!(net.step(0, &[3, -2]).entries, [-2, -4, -5, -2]);
    }

    #[test]
    fn a_triangle_steps_in_small_triangles() {
        // Entries tt ts ss tr rs rr; the argument at each vertex picks its entries.
        let net = triangle(vec![1, 2, 4, 8, 16, 32]);
        assert_eq!(net.step(0, &[1, 0, 0]).entries, [1, 2, 8]);
        assert_eq!(net.step(0, &[0, 1, 0]).entries, [8, 16, 32]);
        assert_eq!(net.step(0, &[0, 0, 1]).entries, [2, 4, 16]);
    }

    #[test]
    fn a_scheme_is_its_steps() {
        let net = triangle(vec![1, 2, 4, 8, 16, 32]);
        let weights = [2, -3, 2];
        let first = net.step(0, &weights);
        let second = first.step(0, &weights);
        let scheme = net.scheme(0, &weights);
        assert_eq!(scheme.shape.factors[0], Factor { dimension: 3, degree: 2 });
        assert_eq!(scheme.entries, [net.entries.clone(), first.entries, second.entries].concat());
    }

    #[test]
    fn splitting_in_place_reads_the_scheme() {
        let mut points = [1i64, 5, -2, 7];
        let mut left = [0; 4];
        let scheme = Net { shape: Shape::curve(3, 1), entries: points.to_vec() }.scheme(0, &[3, 4]).entries;
        split(&mut points, &mut left, 1, [&3, &4]);
        assert_eq!(left, [scheme[0], scheme[4], scheme[7], scheme[9]]);
        assert_eq!(points, [scheme[9], scheme[8], scheme[6], scheme[3]]);
    }

    #[test]
    fn rectangles_step_in_one_factor_at_a_time() {
        let net = Net { shape: Shape::rectangle(1, 1, 1), entries: vec![1i64, 2, 3, 5] };
        assert_eq!(net.step(0, &[1, 1]).entries, [4, 7]);
        assert_eq!(net.step(1, &[1, 1]).entries, [3, 8]);
        assert_eq!(net.step(0, &[2, 3]).step(1, &[5, 7]).entries, net.step(1, &[5, 7]).step(0, &[2, 3]).entries);
    }
}
