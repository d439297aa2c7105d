//! Where two pieces meet: in their parameters, or in space.

use num_traits::{Signed, Zero};

use crate::affine::{Frame, Interval};
use crate::curve::Curve;
use crate::error::Error;
use crate::exact::Rational;
use crate::joint::{Joint, corners};
use crate::piece::Piece;
use crate::segment::Segment;
use crate::side::{Arrangement, Side, Strip};
use crate::symbolic::{Polynomial, Symbol};

/// What two pieces have in common.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Meeting {
    /// A parameter of two curves or an edge of two patches in one parameter plane.
    Joint(Joint),
    /// An end or edge of each, in whatever parameters.
    Sides(Side, Side),
}

impl Meeting {
    /// All pairs of ends or edges of two pieces that are the same points, run
    /// through in one direction or the other. With `rational` the last
    /// coordinate is the weight.
    ///
    /// ```
    /// use casteljau::{Interval, Meeting, Piece, Rational, Segment, Side};
    /// let over = |points: [i64; 4]| -> Result<Piece, casteljau::Error> {
    ///     Ok(Piece::Curve(Segment::new(2, points.map(Rational::from).to_vec(), Interval::unit())?))
    /// };
    /// let (first, second) = (over([0, 0, 1, 1])?, over([2, 5, 0, 0])?);
    /// assert_eq!(Meeting::by_position(&first, &second, false)?, [Meeting::Sides(Side::Start, Side::End)]);
    /// # Ok::<(), casteljau::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`Error::WrongCount`] if they have different dimensions.
    pub fn by_position(first: &Piece, second: &Piece, rational: bool) -> Result<Vec<Self>, Error> {
        if first.dimension() != second.dimension() {
            return Err(Error::WrongCount { what: "coordinates", expected: first.dimension(), found: second.dimension() });
        }
        let mut found = Vec::new();
        for &side in Arrangement::of(first).sides() {
            let own = boundary(first, side, false)?;
            for &other in Arrangement::of(second).sides() {
                let turned = matches!(first, Piece::Triangle(_) | Piece::Rectangle(_));
                if same_points(&own, &boundary(second, other, false)?, rational)
                    || turned && same_points(&own, &boundary(second, other, true)?, rational)
                {
                    found.push(Self::Sides(side, other));
                }
            }
        }
        Ok(found)
    }
}

/// The curve along a side; a constant one for the end of a curve.
fn boundary(piece: &Piece, side: Side, reversed: bool) -> Result<Curve, Error> {
    let points: Vec<&[Rational]> = piece.points().collect();
    let along = Strip::of(piece, side, reversed).along.into_iter().map(|place| points[place].to_vec());
    Segment::from_points(along.collect(), Interval::unit())?.curve()
}

fn same_points(a: &Curve, b: &Curve, rational: bool) -> bool {
    if !rational {
        return a.same_map(b);
    }
    let x = Symbol::new('x', None);
    let (a, b) = (a.polynomials(x), b.polynomials(x));
    let (Some((weight, own)), Some((other_weight, other))) = (a.split_last(), b.split_last()) else { return false };
    let crossed = |x: &Polynomial, y: &Polynomial| (x * other_weight) == (y * weight);
    own.iter().zip(other).all(|(x, y)| crossed(x, y))
}

impl Joint {
    /// Whether both pieces lie on the same side of their joint in the space of
    /// parameters, so that they overlap: their order of continuity is that of
    /// the maps all the same.
    #[must_use]
    pub fn has_both_on_one_side(&self, first: &Piece, second: &Piece) -> bool {
        match (self.side_of(&first.frame()), self.side_of(&second.frame())) {
            (Some(a), Some(b)) => a == b,
            _ => false,
        }
    }

    /// On which side a frame lies, if the joint is one of its ends or sides.
    fn side_of(&self, frame: &Frame<Rational>) -> Option<bool> {
        match (self, frame) {
            (Self::Parameter(at), Frame::Interval(frame)) if frame.r() == at => Some(frame.s() > at),
            (Self::Parameter(at), Frame::Interval(frame)) if frame.s() == at => Some(frame.r() > at),
            (Self::Edge([from, to]), frame) => {
                let area =
                    |point: &[Rational; 2]| (&to[0] - &from[0]) * (&point[1] - &from[1]) - (&to[1] - &from[1]) * (&point[0] - &from[0]);
                let areas: Vec<Rational> = corners(frame).iter().map(area).collect();
                let off: Vec<&Rational> = areas.iter().filter(|area| !area.is_zero()).collect();
                let first = off.first()?.is_positive();
                (areas.len() == off.len() + 2 && off.iter().all(|area| area.is_positive() == first)).then_some(first)
            }
            _ => None,
        }
    }
}
