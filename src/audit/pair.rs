//! Two pieces that meet, over frames that meet.

use num_traits::{Signed, Zero};

use super::domain;
use super::mates::{Mate, Place};
use crate::affine::{Interval, Rectangle};
use crate::continuity::{
    Continuity, continuity_of_curves, continuity_of_rational_curves, continuity_of_rational_surfaces, continuity_of_surfaces,
};
use crate::error::Error;
use crate::exact::Rational;
use crate::geometric::geometric_join_of_ends;
use crate::joint::{Joint, extend};
use crate::model::Part;
use crate::piece::{Equation, Piece};
use crate::rectangular::RectangularPatch;
use crate::segment::Segment;
use crate::side::Arrangement;

/// Two sides that meet.
pub(super) struct Pair<'a> {
    pub(super) parts: &'a [Part],
    pub(super) mate: &'a Mate,
}

/// A point with its weight.
fn lifted(part: &Part, point: &[Rational], rational: bool) -> Vec<Rational> {
    let mut point = point.to_vec();
    if rational && !part.rational {
        point.push(Rational::from(1));
    }
    point
}

impl Pair<'_> {
    fn part(&self, (index, _): Place) -> &Part {
        &self.parts[index]
    }

    fn is_rational(&self) -> bool {
        self.part(self.mate.first).rational || self.part(self.mate.second).rational
    }

    pub(super) fn are_rectangles(&self) -> bool {
        [self.mate.first, self.mate.second].into_iter().all(|place| matches!(self.part(place).piece, Piece::Rectangle(_)))
    }

    /// The number of coordinates, weights left out.
    fn dimensions(&self) -> [usize; 2] {
        [self.mate.first, self.mate.second].map(|place| self.part(place).piece.dimension() - usize::from(self.part(place).rational))
    }

    /// The control points of a side's layers, in the direction of the first side.
    fn layers(&self, place: Place, reversed: bool) -> Vec<Vec<Vec<Rational>>> {
        let part = self.part(place);
        let (arrangement, side, rational) = (Arrangement::of(&part.piece), place.1, self.is_rational());
        (0..=arrangement.degree_across(side))
            .map(|layer| {
                let columns = arrangement.columns(side, layer);
                (0..columns)
                    .map(|column| {
                        let column = if reversed { columns - 1 - column } else { column };
                        lifted(part, part.piece.net().point(arrangement.index(side, layer, column)), rational)
                    })
                    .collect()
            })
            .collect()
    }

    /// The pieces over frames that meet at a joint: their own where they share
    /// one, else unit frames before and behind it. Triangles have none of these.
    fn over_frames(&self) -> Result<(Piece, Piece, Joint), Error> {
        let Mate { first, second, reversed, shares_domain, .. } = *self.mate;
        if shares_domain {
            let own = |place: Place| -> Result<Piece, Error> {
                let part = self.part(place);
                if !self.is_rational() || part.rational {
                    return Ok(part.piece.clone());
                }
                part.piece.with_points(part.piece.points().map(|point| lifted(part, point, true)).collect())
            };
            let (from, to, _) = domain::edge(self.part(first), first.1);
            let joint = if first.1.is_end() { Joint::Parameter(from[0].clone()) } else { Joint::Edge([from, to]) };
            return Ok((own(first)?, own(second)?, joint));
        }
        let (zero, one, two) = (Rational::from(0), Rational::from(1), Rational::from(2));
        let (before, behind) = (Interval::new(one.clone(), zero.clone())?, Interval::new(one.clone(), two)?);
        let (a, b) = (self.layers(first, false), self.layers(second, reversed && !first.1.is_end()));
        match (&self.part(first).piece, &self.part(second).piece) {
            (Piece::Curve(_), Piece::Curve(_)) => {
                let segment = |layers: Vec<Vec<Vec<Rational>>>, frame| Segment::from_points(layers.into_iter().flatten().collect(), frame);
                Ok((Piece::Curve(segment(a, before)?), Piece::Curve(segment(b, behind)?), Joint::Parameter(one)))
            }
            (Piece::Rectangle(_), Piece::Rectangle(_)) => {
                let along = Interval::unit();
                let patch = |layers, frame| RectangularPatch::from_rows(layers, Rectangle::new(frame, along.clone()));
                let joint = Joint::Edge([[one.clone(), zero], [one.clone(), one]]);
                Ok((Piece::Rectangle(patch(a, before)?), Piece::Rectangle(patch(b, behind)?), joint))
            }
            _ => Err(Error::Unsupported("triangles without frames have no common parameters".into())),
        }
    }

    /// The order of parametric continuity; of triangles without frames only
    /// whether the points agree.
    pub(super) fn parametric(&self) -> Continuity {
        let [a, b] = self.dimensions();
        if a != b {
            return Continuity::Broken;
        }
        let order = self.over_frames().and_then(|(first, second, joint)| {
            Ok(match (first.equation()?, second.equation()?, &joint, self.is_rational()) {
                (Equation::Curve(a), Equation::Curve(b), Joint::Parameter(at), false) => continuity_of_curves(&a, &b, at)?,
                (Equation::Curve(a), Equation::Curve(b), Joint::Parameter(at), true) => {
                    continuity_of_rational_curves(&a, &b, at)?.cartesian
                }
                (Equation::Surface(a), Equation::Surface(b), Joint::Edge(edge), false) => continuity_of_surfaces(&a, &b, edge)?,
                (Equation::Surface(a), Equation::Surface(b), Joint::Edge(edge), true) => {
                    continuity_of_rational_surfaces(&a, &b, edge)?.cartesian
                }
                _ => return Err(Error::Unsupported("a curve and a patch do not join".into())),
            })
        });
        order.unwrap_or_else(|_| if self.boundaries_agree() { Continuity::C(0) } else { Continuity::Broken })
    }

    /// Whether the two sides are the same curve.
    fn boundaries_agree(&self) -> bool {
        let Mate { first, second, reversed, .. } = *self.mate;
        let (a, b) = (self.layers(first, false).swap_remove(0), self.layers(second, reversed && !first.1.is_end()).swap_remove(0));
        let segment = |points| Segment::from_points(points, Interval::unit()).and_then(|segment| segment.curve());
        let (Ok(a), Ok(b)) = (segment(a), segment(b)) else { return false };
        match self.weight_ratio() {
            None => a.same_map(&b),
            // The homogeneous curves are multiples of each other.
            Some(factor) => {
                let degree = a.degree().max(b.degree());
                let (Ok(a), Ok(b)) = (a.with_degree(degree), b.with_degree(degree)) else { return false };
                (0..=degree).all(|power| a.vector(power).iter().zip(b.vector(power)).all(|(x, y)| *y == x * &factor))
            }
        }
    }

    /// The weight of the second piece over that of the first at the beginning of
    /// the joint, if one is rational and the weights are not zero.
    pub(super) fn weight_ratio(&self) -> Option<Rational> {
        if !self.is_rational() {
            return None;
        }
        let Mate { first, second, reversed, .. } = *self.mate;
        let weight = |place: Place, reversed: bool| {
            let part = self.part(place);
            let arrangement = Arrangement::of(&part.piece);
            let column = if reversed { arrangement.columns(place.1, 0) - 1 } else { 0 };
            lifted(part, part.piece.net().point(arrangement.index(place.1, 0, column)), true).pop()
        };
        let (a, b) = (weight(first, false)?, weight(second, reversed && !first.1.is_end())?);
        b.checked_div(&a).filter(|ratio| !ratio.is_zero())
    }

    /// The order of geometric continuity of two curves with a common tangent.
    pub(super) fn geometric_curves(&self) -> Option<usize> {
        let rational = self.is_rational();
        let segment = |place: Place| -> Option<Segment> {
            let part = self.part(place);
            let Piece::Curve(segment) = &part.piece else { return None };
            let points = segment.points().map(|point| lifted(part, point, rational)).collect();
            Segment::from_points(points, segment.frame().clone()).ok()
        };
        let (a, b) = (segment(self.mate.first)?, segment(self.mate.second)?);
        geometric_join_of_ends((&a, self.mate.first.1), (&b, self.mate.second.1), rational).ok()?.order
    }

    /// The ratio of the differences behind the joint that equal first derivatives need.
    pub(super) fn parametric_ratio(&self) -> Option<Rational> {
        let (a, b, joint) = self.over_frames().ok()?;
        let reach = |piece: &Piece, place: Place| -> Option<Rational> {
            let arrangement = Arrangement::of(&self.part(place).piece);
            let degree = match (piece, self.mate.shares_domain) {
                (Piece::Rectangle(patch), false) => patch.degree().0,
                _ => arrangement.degree_across(place.1),
            };
            let length = match (piece, &joint) {
                (Piece::Curve(segment), _) => segment.frame().s() - segment.frame().r(),
                (Piece::Rectangle(patch), Joint::Edge([from, to])) => {
                    let frame = if from[0] == to[0] { patch.frame().u() } else { patch.frame().v() };
                    frame.s() - frame.r()
                }
                _ => return None,
            };
            length.abs().checked_div(&Rational::from(degree))
        };
        reach(&b, self.mate.second)?.checked_div(&reach(&a, self.mate.first)?)
    }

    /// The largest squared move of a control point that an order asks of the second piece.
    pub(super) fn least_move(&self, order: usize) -> Option<Rational> {
        if self.is_rational() {
            return None;
        }
        let (a, b, joint) = self.over_frames().ok()?;
        let extension = extend(&a, &b.frame(), &joint, order).ok()?;
        if Arrangement::of(&extension.continuation) != Arrangement::of(&b) {
            return None;
        }
        let moves = extension.continuation.points().zip(b.points()).zip(&extension.forced).filter(|(_, forced)| **forced);
        moves.map(|((x, y), _)| x.iter().zip(y).map(|(x, y)| (x - y).pow(2)).sum::<Rational>()).max()
    }
}
