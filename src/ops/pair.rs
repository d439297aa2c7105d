//! Two pieces that are asked about together.

use crate::continuity::{
    Continuity, continuity_of_curves, continuity_of_rational_curves, continuity_of_rational_surfaces, continuity_of_surfaces,
};
use crate::error::Error;
use crate::exact::Rational;
use crate::geometric::{geometric_join, geometric_join_of_ends, geometric_join_of_rational};
use crate::joint::Joint;
use crate::meeting::Meeting;
use crate::piece::{Equation, Piece};
use crate::side::{Side, Strip};
use crate::tangent::tangent_plane_join;
use crate::value::{Arguments, Contact, JoinFinding};

/// The order of continuity, of rational pieces the Cartesian one, and those of
/// their homogeneous maps: as they are, and up to a factor.
pub(super) type Orders = (Continuity, Option<(Continuity, Continuity)>);

/// Two pieces that are asked about.
pub(super) struct Pair {
    pub(super) first: Piece,
    pub(super) second: Piece,
    pub(super) rational: bool,
    pub(super) meeting: Meeting,
}

impl Pair {
    pub(super) fn of(arguments: &Arguments) -> Result<Self, Error> {
        let (first, second) = (arguments.piece()?, arguments.other_piece()?);
        let rational = arguments.is_weighted();
        if rational != arguments.get("other_weights").is_some() {
            return Err(Error::WrongShape(
                "one of the pieces has weights and the other has none: give both some, 1 where there is none".into(),
            ));
        }
        if matches!(first, Piece::Curve(_)) != matches!(second, Piece::Curve(_)) {
            return Err(Error::WrongShape("a curve and a patch do not join".into()));
        }
        let meeting = match (arguments.number("at"), arguments.word("edge"), arguments.word("other_edge")) {
            (Ok(_), Ok(_), _) | (Ok(_), _, Ok(_)) => {
                return Err(Error::WrongShape(
                    "`at` is a parameter of both curves, `edge` and `other_edge` name an end of each: give one or the others".into(),
                ));
            }
            (Ok(at), ..) => Meeting::Joint(Joint::Parameter(at.clone())),
            (_, Ok(edge), Ok(other)) => Meeting::Sides(Side::named(&first, edge)?, Side::named(&second, other)?),
            (_, Ok(_), _) | (_, _, Ok(_)) => {
                return Err(Error::WrongShape("name an edge of both pieces: `edge` of the first and `other_edge` of the second".into()));
            }
            _ => match Joint::between(&first, &second) {
                Some(joint) => Meeting::Joint(joint),
                None => Self::by_position(&first, &second, rational)?,
            },
        };
        Ok(Self { first, second, rational, meeting })
    }

    /// The only place in space where they meet.
    fn by_position(first: &Piece, second: &Piece, rational: bool) -> Result<Meeting, Error> {
        let mut found = Meeting::by_position(first, second, rational)?;
        match (found.pop(), found.pop()) {
            (Some(only), None) => Ok(only),
            (one, other) => Err(Error::WrongShape(format!(
                "the frames {} and {} do not share one end or side, and {} ends or sides are the same in space: give the pieces their \
                 frames (--over, --other-over), curves --at T, or both an end or edge (--edge, --other-edge)",
                first.frame(),
                second.frame(),
                if one.is_none() {
                    "no"
                } else if other.is_some() {
                    "several"
                } else {
                    "some"
                }
            ))),
        }
    }

    /// The orders of continuity; none without a common parameter.
    pub(super) fn order(&self, second: &Piece) -> Result<Option<Orders>, Error> {
        let Meeting::Joint(joint) = &self.meeting else { return Ok(None) };
        Ok(Some(match (self.first.equation()?, second.equation()?, joint, self.rational) {
            (Equation::Curve(a), Equation::Curve(b), Joint::Parameter(at), false) => (continuity_of_curves(&a, &b, at)?, None),
            (Equation::Surface(a), Equation::Surface(b), Joint::Edge(edge), false) => (continuity_of_surfaces(&a, &b, edge)?, None),
            (Equation::Curve(a), Equation::Curve(b), Joint::Parameter(at), true) => {
                let join = continuity_of_rational_curves(&a, &b, at)?;
                (join.cartesian, Some((join.homogeneous, join.scaled)))
            }
            (Equation::Surface(a), Equation::Surface(b), Joint::Edge(edge), true) => {
                let join = continuity_of_rational_surfaces(&a, &b, edge)?;
                (join.cartesian, Some((join.homogeneous, join.scaled)))
            }
            _ => return Err(Error::WrongShape("curves join at a parameter, patches along an edge".into())),
        }))
    }

    /// The ends or edges that meet, and whether they run against each other.
    pub(super) fn sides(&self) -> Option<(Side, Side, bool)> {
        match &self.meeting {
            Meeting::Joint(joint) => {
                let ((own, turned), (other, back)) = (Side::on(&self.first, joint)?, Side::on(&self.second, joint)?);
                Some((own, other, turned != back))
            }
            Meeting::Sides(own, other) => {
                // The direction in which the ends of the edges are closer together.
                let ends = |piece: &Piece, side: Side, reversed: bool| -> Vec<Rational> {
                    let along = Strip::of(piece, side, reversed).along;
                    let points: Vec<&[Rational]> = piece.points().collect();
                    [along.first(), along.last()].into_iter().flatten().flat_map(|&place| points[place].iter().cloned()).collect()
                };
                let start = ends(&self.first, *own, false);
                let distance = |reversed: bool| -> Rational {
                    start.iter().zip(ends(&self.second, *other, reversed)).map(|(a, b)| (a - b).pow(2)).sum()
                };
                Some((*own, *other, distance(true) < distance(false)))
            }
        }
    }

    /// The geometric continuity, if the pieces have the dimension for it and no
    /// weight vanishes at the joint.
    pub(super) fn contact(&self, second: &Piece) -> Result<Option<Contact>, Error> {
        let dimension = self.first.dimension() - usize::from(self.rational);
        let found = match (&self.first, second, &self.meeting) {
            (Piece::Curve(_), ..) if dimension < 2 => return Ok(None),
            (Piece::Curve(a), Piece::Curve(b), Meeting::Joint(Joint::Parameter(at))) => {
                let join = if self.rational { geometric_join_of_rational } else { geometric_join };
                join(&a.curve()?, &b.curve()?, at, at).map(Contact::Curves)
            }
            (Piece::Curve(a), Piece::Curve(b), Meeting::Sides(own, other)) => {
                geometric_join_of_ends((a, *own), (b, *other), self.rational).map(Contact::Curves)
            }
            _ if dimension != 3 => return Ok(None),
            _ => match self.sides() {
                Some((own, other, _)) => {
                    tangent_plane_join((&self.first, own), (second, other), self.rational).map(|join| Contact::Patches(Box::new(join)))
                }
                None => return Ok(None),
            },
        };
        match found {
            Ok(contact) => Ok(Some(contact)),
            // Where the degree is too high for roots to be counted, nothing is said about tangent planes.
            Err(Error::Unsupported(_) | Error::TooLarge { .. }) => Ok(None),
            Err(error) => Err(error),
        }
    }

    pub(super) fn find(&self) -> Result<JoinFinding, Error> {
        let found = self.order(&self.second)?;
        let overlap = matches!(&self.meeting, Meeting::Joint(joint) if joint.has_both_on_one_side(&self.first, &self.second));
        Ok(JoinFinding {
            meeting: self.meeting.clone(),
            overlap,
            order: found.map(|(order, _)| order),
            homogeneous: found.and_then(|(_, homogeneous)| homogeneous),
            contact: self.contact(&self.second)?,
            conditions: Vec::new(),
            groups: None,
            requirement: None,
            repair: None,
        })
    }
}
