//! Points as integer combinations of the vertices of a frame.

use smallvec::{SmallVec, smallvec};

use crate::kernel::coefficient::Coefficient;

/// A point or vector as a combination of vertices, cleared of denominators:
/// `scale · x` is the sum of `weights[k]` times vertex `k`.
#[derive(Clone, Debug)]
pub(crate) struct Weights<C> {
    pub(crate) weights: SmallVec<[C; 3]>,
    pub(crate) scale: C,
}

impl<C: Coefficient> Weights<C> {
    /// The number `t` on the homogeneous line: one origin and `t` directions.
    pub(crate) fn of_number(t: &C) -> Self {
        let (t, scale) = t.fraction();
        Self { weights: smallvec![scale.clone(), t], scale }
    }

    /// The combination of two vertices.
    pub(crate) fn of_pair(first: &C, second: &C) -> Self {
        let ((a, a_scale), (b, b_scale)) = (first.fraction(), second.fraction());
        if a_scale == b_scale {
            Self { weights: smallvec![a, b], scale: a_scale }
        } else {
            Self { weights: smallvec![a.times(&b_scale), b.times(&a_scale)], scale: a_scale.times(&b_scale) }
        }
    }

    /// The combination of any number of vertices.
    pub(crate) fn of(parts: &[C]) -> Self {
        let (weights, scale) = C::clear(parts);
        Self { weights: weights.into(), scale }
    }
}

/// The new vertices of one factor as combinations of its old ones.
#[derive(Clone, Debug)]
pub(crate) struct Vertices<C> {
    /// The weights of one new vertex after the other.
    pub(crate) rows: SmallVec<[C; 6]>,
    pub(crate) scales: SmallVec<[C; 3]>,
}

impl<C> FromIterator<Weights<C>> for Vertices<C> {
    fn from_iter<I: IntoIterator<Item = Weights<C>>>(vertices: I) -> Self {
        let mut all = Self { rows: SmallVec::new(), scales: SmallVec::new() };
        for vertex in vertices {
            all.rows.extend(vertex.weights);
            all.scales.push(vertex.scale);
        }
        all
    }
}
