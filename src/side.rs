//! The ends of curves and the edges of patches, by name.

use std::fmt;

use crate::kernel::coefficient::Coefficient;
use crate::piece::Piece;

/// An end of a curve, or an edge of a patch. Edges run from the first vertex in
/// their name to the second, those of rectangles in the direction of the other
/// parameter.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Side {
    /// The end of a curve, at `s`.
    End,
    /// The start of a curve, at `r`.
    Start,
    /// The edge of a triangle from `r` to `s`.
    Rs,
    /// The edge of a triangle from `s` to `t`.
    St,
    /// The edge of a triangle from `t` to `r`.
    Tr,
    /// The edge of a rectangle where `u = r1`.
    U0,
    /// The edge of a rectangle where `u = s1`.
    U1,
    /// The edge of a rectangle where `v = r2`.
    V0,
    /// The edge of a rectangle where `v = s2`.
    V1,
}

/// How the control points of a piece are arranged.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Arrangement {
    /// A list of one point more than the degree.
    Curve(usize),
    /// Rows `i = 0, …, m`, in a row `j = 0, …, m - i`.
    Triangle(usize),
    /// Rows `i = 0, …, p`, in a row `j = 0, …, q`.
    Rectangle(usize, usize),
}

impl Arrangement {
    /// That of a piece.
    #[must_use]
    pub fn of<C: Coefficient>(piece: &Piece<C>) -> Self {
        match piece {
            Piece::Curve(segment) => Self::Curve(segment.degree()),
            Piece::Triangle(patch) => Self::Triangle(patch.degree()),
            Piece::Rectangle(patch) => Self::Rectangle(patch.degree().0, patch.degree().1),
        }
    }

    /// The ends or edges of such a piece, in order.
    #[must_use]
    pub fn sides(self) -> &'static [Side] {
        match self {
            Self::Curve(_) => &[Side::End, Side::Start],
            Self::Triangle(_) => &[Side::Rs, Side::St, Side::Tr],
            Self::Rectangle(..) => &[Side::U0, Side::U1, Side::V0, Side::V1],
        }
    }

    /// The degree of the boundary curve on a side; 0 for the end of a curve.
    #[must_use]
    pub fn degree_along(self, side: Side) -> usize {
        match (self, side) {
            (Self::Curve(_), _) => 0,
            (Self::Triangle(degree), _) => degree,
            (Self::Rectangle(_, q), Side::U0 | Side::U1) => q,
            (Self::Rectangle(p, _), _) => p,
        }
    }

    /// The degree across a side: the number of layers behind it.
    #[must_use]
    pub fn degree_across(self, side: Side) -> usize {
        match (self, side) {
            (Self::Curve(degree) | Self::Triangle(degree), _) => degree,
            (Self::Rectangle(p, _), Side::U0 | Side::U1) => p,
            (Self::Rectangle(_, q), _) => q,
        }
    }

    /// The number of control points in a layer: layer 0 is the side itself, the
    /// next ones lie behind it.
    #[must_use]
    pub fn columns(self, side: Side, layer: usize) -> usize {
        match self {
            Self::Triangle(degree) => degree + 1 - layer,
            _ => self.degree_along(side) + 1,
        }
    }

    /// The index of a control point among all of them, by its layer and its
    /// place in the direction of the side.
    #[must_use]
    pub fn index(self, side: Side, layer: usize, column: usize) -> usize {
        let triangle = |degree: usize, i: usize, j: usize| i * (degree + 1) - i * i.saturating_sub(1) / 2 + j;
        match (self, side) {
            (Self::Curve(degree), Side::End) => degree - layer,
            (Self::Curve(_), _) => layer,
            (Self::Triangle(degree), Side::Rs) => triangle(degree, degree - layer - column, column),
            (Self::Triangle(degree), Side::St) => triangle(degree, layer, degree - layer - column),
            (Self::Triangle(degree), _) => triangle(degree, column, layer),
            (Self::Rectangle(_, q), Side::U0) => layer * (q + 1) + column,
            (Self::Rectangle(p, q), Side::U1) => (p - layer) * (q + 1) + column,
            (Self::Rectangle(_, q), Side::V0) => column * (q + 1) + layer,
            (Self::Rectangle(_, q), _) => column * (q + 1) + q - layer,
        }
    }
}

impl Side {
    /// The name: "start", "rs", "u0", ….
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::End => "end",
            Self::Start => "start",
            Self::Rs => "rs",
            Self::St => "st",
            Self::Tr => "tr",
            Self::U0 => "u0",
            Self::U1 => "u1",
            Self::V0 => "v0",
            Self::V1 => "v1",
        }
    }
}

impl fmt::Display for Side {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::triangular::TriangularPatch;

    #[test]
    fn the_layers_of_a_triangle_are_its_exponents() {
        let degree = 4;
        let all = TriangularPatch::<crate::exact::Rational>::indices(degree);
        let arrangement = Arrangement::Triangle(degree);
        for (side, off, along) in [(Side::Rs, 2, 1), (Side::St, 0, 2), (Side::Tr, 1, 0)] {
            for layer in 0..=degree {
                for column in 0..arrangement.columns(side, layer) {
                    let exponents = all[arrangement.index(side, layer, column)];
                    assert_eq!((exponents[off], exponents[along]), (layer, column), "{side} {layer} {column}");
                }
            }
        }
    }

    #[test]
    fn every_side_of_a_rectangle_reaches_every_point_once() {
        let arrangement = Arrangement::Rectangle(2, 3);
        for &side in arrangement.sides() {
            let layers = 0..=arrangement.degree_across(side);
            let mut seen: Vec<usize> = layers
                .flat_map(|layer| (0..arrangement.columns(side, layer)).map(move |column| arrangement.index(side, layer, column)))
                .collect();
            seen.sort_unstable();
            assert_eq!(seen, (0..12).collect::<Vec<_>>(), "{side}");
        }
        assert_eq!(arrangement.index(Side::U1, 0, 1), 9);
        assert_eq!(arrangement.index(Side::V1, 1, 2), 10);
    }
}
