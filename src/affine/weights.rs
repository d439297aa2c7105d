//! Points as integer combinations of the vertices of a frame.

use crate::kernel::coefficient::Coefficient;
use crate::kernel::integers::Integers;

/// Points or vectors as combinations of vertices, cleared of denominators: for
/// each of them `scale · x` is the sum of the weights in its row times the vertices.
#[derive(Clone, Debug)]
pub(crate) struct Weights<C> {
    /// The weights of one point after the other.
    pub(crate) rows: Integers<C>,
    pub(crate) scales: Integers<C>,
}

impl<C> Default for Weights<C> {
    #[inline]
    fn default() -> Self {
        Self { rows: Integers::default(), scales: Integers::default() }
    }
}

impl<C: Coefficient> Weights<C> {
    /// Adds numbers `t` on the homogeneous line: one origin and `t` directions.
    #[inline]
    pub(crate) fn push_numbers<'a, N: Iterator<Item = &'a C> + Clone>(&mut self, numbers: N)
    where
        C: 'a,
    {
        let mut short = 0;
        if let (Integers::Words(rows), Integers::Words(scales)) = (&mut self.rows, &mut self.scales) {
            let fractions = numbers.clone().map_while(C::short_fraction);
            let before = scales.len();
            scales.extend(fractions.clone().map(|(_, scale)| scale));
            rows.extend(fractions.flat_map(|(t, scale)| [scale, t]));
            short = scales.len() - before;
        }
        numbers.skip(short).for_each(|number| self.push_number(number));
    }

    #[inline(never)]
    fn push_number(&mut self, t: &C) {
        let (t, scale) = t.fraction();
        self.rows.push(scale.clone());
        self.rows.push(t);
        self.scales.push(scale);
    }

    /// Adds a combination of two vertices.
    #[inline]
    pub(crate) fn push_pair(&mut self, first: &C, second: &C) {
        if let (Some((a, a_scale)), Some((b, b_scale))) = (first.short_fraction(), second.short_fraction())
            && a_scale == b_scale
        {
            self.rows.push_word(a);
            self.rows.push_word(b);
            return self.scales.push_word(a_scale);
        }
        let ((a, a_scale), (b, b_scale)) = (first.fraction(), second.fraction());
        self.rows.push(a.times(&b_scale));
        self.rows.push(b.times(&a_scale));
        self.scales.push(a_scale.times(&b_scale));
    }

    /// The same points several times over.
    pub(crate) fn repeated(&self, times: usize) -> Self {
        let mut all = Self::default();
        for _ in 0..times {
            all.rows.extend(self.rows.as_slice());
            all.scales.extend(self.scales.as_slice());
        }
        all
    }

    /// Adds a combination of any number of vertices.
    pub(crate) fn push(&mut self, parts: &[C]) {
        let (weights, scale) = C::clear(parts);
        weights.into_iter().for_each(|weight| self.rows.push(weight));
        self.scales.push(scale);
    }
}
