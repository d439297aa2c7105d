//! The ends of curves and the edges of patches, by name.

use crate::affine::Frame;
use crate::error::Error;
use crate::exact::Rational;
use crate::joint::Joint;
use crate::kernel::coefficient::Coefficient;
use crate::name::display_by_name;
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
            Self::Triangle(degree) => (degree + 1).saturating_sub(layer),
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

/// The control points along a side and those of the next layer, by their places
/// in the net. The differences `inner - along`, one by one, are control points
/// of a derivative across the side, up to a factor: one at the end of a curve,
/// as many as the degree in triangles, and one more in rectangles.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Strip {
    pub(crate) along: Vec<usize>,
    pub(crate) inner: Vec<usize>,
}

impl Strip {
    /// The strip of a piece that has the side; from the last to the first point of the side if `reversed`.
    pub(crate) fn of<C: Coefficient>(piece: &Piece<C>, side: Side, reversed: bool) -> Self {
        let arrangement = Arrangement::of(piece);
        let layer = |layer: usize| {
            let mut places: Vec<usize> =
                (0..arrangement.columns(side, layer)).map(|column| arrangement.index(side, layer, column)).collect();
            if reversed {
                places.reverse();
            }
            places
        };
        // A triangle of degree 0 has an empty second layer, other pieces have none: the derivative vanishes.
        let second = match arrangement {
            Arrangement::Triangle(_) => 1,
            _ => arrangement.degree_across(side).min(1),
        };
        Self { along: layer(0), inner: layer(second) }
    }
}

impl Side {
    /// Whether it is an end of a curve and no edge of a patch.
    #[must_use]
    pub const fn is_end(self) -> bool {
        matches!(self, Self::End | Self::Start)
    }

    /// The end or edge of a piece with a name.
    ///
    /// # Errors
    /// [`Error::WrongShape`] if it has none of that name.
    pub fn named<C: Coefficient>(piece: &Piece<C>, name: &str) -> Result<Self, Error> {
        let all = Arrangement::of(piece).sides();
        all.iter().copied().find(|side| side.name() == name).ok_or_else(|| {
            let names: Vec<&str> = all.iter().map(|side| side.name()).collect();
            Error::WrongShape(format!("there is no edge `{name}` here; there are {}", names.join(", ")))
        })
    }

    /// Where the side lies in the parameter line or plane, in its direction.
    ///
    /// # Errors
    /// [`Error::WrongShape`] if it is no side of such a frame.
    pub fn joint(self, frame: &Frame<Rational>) -> Result<Joint, Error> {
        let point = |u: &Rational, v: &Rational| [u.clone(), v.clone()];
        Ok(match (frame, self) {
            (Frame::Interval(frame), Self::Start) => Joint::Parameter(frame.r().clone()),
            (Frame::Interval(frame), Self::End) => Joint::Parameter(frame.s().clone()),
            (Frame::Triangle(frame), Self::Rs) => Joint::Edge([frame.r().clone(), frame.s().clone()]),
            (Frame::Triangle(frame), Self::St) => Joint::Edge([frame.s().clone(), frame.t().clone()]),
            (Frame::Triangle(frame), Self::Tr) => Joint::Edge([frame.t().clone(), frame.r().clone()]),
            (Frame::Rectangle(frame), Self::U0 | Self::U1) => {
                let at = if self == Self::U0 { frame.u().r() } else { frame.u().s() };
                Joint::Edge([point(at, frame.v().r()), point(at, frame.v().s())])
            }
            (Frame::Rectangle(frame), Self::V0 | Self::V1) => {
                let at = if self == Self::V0 { frame.v().r() } else { frame.v().s() };
                Joint::Edge([point(frame.u().r(), at), point(frame.u().s(), at)])
            }
            _ => return Err(Error::WrongShape(format!("there is no edge `{self}` here"))),
        })
    }

    /// The end or edge of a piece that a joint is, and whether the joint runs against it.
    #[must_use]
    pub fn on(piece: &Piece, joint: &Joint) -> Option<(Self, bool)> {
        let frame = piece.frame();
        Arrangement::of(piece).sides().iter().find_map(|&side| match (side.joint(&frame).ok()?, joint) {
            (Joint::Parameter(own), Joint::Parameter(at)) => (own == *at).then_some((side, false)),
            (Joint::Edge([a, b]), Joint::Edge([from, to])) => match (a == *from && b == *to, a == *to && b == *from) {
                (true, _) => Some((side, false)),
                (_, true) => Some((side, true)),
                _ => None,
            },
            _ => None,
        })
    }

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

display_by_name!(Side);

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
