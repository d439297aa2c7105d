//! The join of two pieces: its orders and conditions, its repair, and the
//! continuation of one piece.

use num_traits::Zero;

use super::join::order;
use crate::affine::{Frame, Interval, Rectangle, Triangle};
use crate::continuity::{
    Continuity, continuity_of_curves, continuity_of_rational_curves, continuity_of_rational_surfaces, continuity_of_surfaces,
};
use crate::error::Error;
use crate::exact::Rational;
use crate::geometric::{geometric_join, geometric_join_of_ends, geometric_join_of_rational};
use crate::joint::{Extension, JoinCondition, Joint, affine_groups, extend, join_conditions};
use crate::meeting::Meeting;
use crate::piece::{Equation, Piece};
use crate::repair::{Repair, repair_tangents, repair_to_order};
use crate::side::{Side, Strip};
use crate::tangent::{Quotient, tangent_plane_join};
use crate::value::{Answer, Arguments, Contact, Finding, JoinFinding, RepairFinding, Value};
use crate::weights::projected;

/// The order of continuity, of rational pieces the Cartesian one, and those of
/// their homogeneous maps: as they are, and up to a factor.
type Orders = (Continuity, Option<(Continuity, Continuity)>);

/// Two pieces that are asked about.
struct Pair {
    first: Piece,
    second: Piece,
    rational: bool,
    meeting: Meeting,
}

impl Pair {
    fn of(arguments: &Arguments) -> Result<Self, Error> {
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
    fn order(&self, second: &Piece) -> Result<Option<Orders>, Error> {
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
    fn sides(&self) -> Option<(Side, Side, bool)> {
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
    fn contact(&self, second: &Piece) -> Result<Option<Contact>, Error> {
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

    fn find(&self) -> Result<JoinFinding, Error> {
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

/// Whether a requirement such as `C2` or `G1` holds.
///
/// # Errors
/// [`Error::Unsupported`] where the question means nothing.
fn holds(word: &str, found: Option<Continuity>, contact: Option<&Contact>) -> Result<bool, Error> {
    let needed: usize = word[1..].parse().unwrap_or(0);
    if word.starts_with('C') {
        let found = found.ok_or_else(|| {
            Error::Unsupported(format!(
                "{word} is about a common parameter, and these pieces meet in space only: give them frames that share an end or side"
            ))
        })?;
        return Ok(found >= Continuity::C(needed));
    }
    match contact {
        None => Err(Error::Unsupported(format!(
            "{word} needs curves in the plane or in space, or patches in space that have the joint as a side, with no weight 0 there"
        ))),
        Some(Contact::Patches(_)) if needed > 1 => Err(Error::Unsupported(format!("{word} between patches is not supported: G1 is"))),
        Some(contact) => Ok(contact.order().is_some_and(|order| order >= needed as i64)),
    }
}

fn numbers(list: &[Rational]) -> Value {
    Value::Numbers(list.to_vec())
}

/// A function of the parameter of the edge: a number where it is constant, and
/// else nothing beside its numerator and denominator.
fn quotient(names: [&'static str; 2], found: Option<&Quotient>) -> Vec<(&'static str, Value)> {
    let Some(found) = found else { return vec![(names[0], Value::Nothing)] };
    match found.constant() {
        Some(number) => vec![(names[0], Value::Number(number))],
        None => {
            let parts = vec![("numerator", numbers(&found.numerator)), ("denominator", numbers(&found.denominator))];
            vec![(names[0], Value::Nothing), (names[1], Value::Record(parts))]
        }
    }
}

fn place(meeting: &Meeting) -> Vec<(&'static str, Value)> {
    match meeting {
        Meeting::Joint(Joint::Parameter(at)) => vec![("at", Value::Number(at.clone()))],
        Meeting::Joint(Joint::Edge(ends)) => vec![("edge", Value::Points(ends.iter().map(|end| end.to_vec()).collect()))],
        Meeting::Sides(own, other) => vec![("edge", Value::Word(own.name())), ("other_edge", Value::Word(other.name()))],
    }
}

/// What is known beside the conditions, for machines.
fn fields(found: &JoinFinding) -> Vec<(&'static str, Value)> {
    let mut fields = place(&found.meeting);
    if let Some((homogeneous, scaled)) = found.homogeneous {
        fields.extend([("homogeneous_max_k", order(homogeneous)), ("scaled_homogeneous_max_k", order(scaled))]);
    }
    fields.extend(found.order.map(|found| ("max_k", order(found))));
    let Some(contact) = &found.contact else { return fields };
    fields.push(("max_g", contact.order().map_or(Value::Nothing, Value::Integer)));
    match contact {
        Contact::Curves(join) => {
            fields.push(("betas", numbers(&join.betas)));
            if join.reversed {
                fields.push(("reversed_tangent", Value::Truth(true)));
            }
            if let Some(singular) = join.singular {
                let orders = singular.orders.map(|order| order.map_or(Value::Nothing, Value::Count));
                let directions = singular.directions.map_or(Value::Nothing, |directions| Value::Word(directions.name()));
                fields.push(("singular", Value::Record(vec![("orders", Value::List(orders.to_vec())), ("directions", directions)])));
            }
        }
        Contact::Patches(join) if join.same_edge => {
            fields.push(("reversed", Value::Truth(join.reversed)));
            let test = |result: Option<bool>| result.map_or(Value::Nothing, Value::Truth);
            fields.extend([
                ("coplanar_identity", test(join.coplanar)),
                ("regular", test(join.regular())),
                ("opposite_sides", test(join.opposite_sides)),
            ]);
            fields.extend(quotient(["ratio", "ratio_function"], join.ratio.as_ref()));
            fields.extend(quotient(["shear", "shear_function"], join.shear.as_ref()));
        }
        Contact::Patches(_) => {}
    }
    fields
}

/// Two pieces where they meet: the orders, and the conditions one by one.
pub(super) fn join(arguments: &Arguments) -> Result<Answer, Error> {
    let pair = Pair::of(arguments)?;
    let mut found = pair.find()?;
    let mut fields = fields(&found);
    if let (Meeting::Joint(joint), Some(reached)) = (&pair.meeting, found.order) {
        // One order more than holds, to show what fails; of maps that are the same, as many as they have.
        let shown = match (arguments.count("order"), reached) {
            (Ok(&order), _) => order,
            (Err(_), Continuity::Broken) => 0,
            (Err(_), Continuity::C(order)) => order + 1,
            (Err(_), Continuity::Same) => usize::MAX,
        };
        found.conditions = join_conditions(&pair.first, &pair.second, joint, shown)?;
        if shown > 0 && !pair.rational {
            found.groups = affine_groups(&pair.first, &pair.second, joint).ok().filter(|(_, groups)| !groups.is_empty());
        }
    }
    if let Ok(&word) = arguments.word("require") {
        let met = holds(word, found.order, found.contact.as_ref())?;
        found.requirement = Some((word, met));
        fields.extend([("required", Value::Word(word)), ("holds", Value::Truth(met))]);
    }
    if let Some((weights, groups)) = &found.groups {
        let group = |group: &crate::joint::AffineGroup| {
            let points = Value::Points(group.points.to_vec());
            Value::Record(vec![
                ("arguments", Value::Document(group.label.clone())),
                ("points", points),
                ("affine_image", Value::Truth(group.holds)),
            ])
        };
        fields.push(("barycentric", numbers(weights)));
        fields.push(("groups", Value::List(groups.iter().map(group).collect())));
    }
    if matches!(found.meeting, Meeting::Joint(_)) {
        fields.push(("conditions", Value::List(found.conditions.iter().map(condition).collect())));
    }
    let answer = Answer::new(fields);
    let answer = match found.requirement {
        Some((_, met)) => answer.that_holds(met),
        None => answer,
    };
    Ok(answer.with_finding(Finding::Join(Box::new(found))))
}

fn condition(condition: &JoinCondition) -> Value {
    let mut fields = vec![
        ("order", Value::Count(condition.order)),
        ("label", Value::Document(condition.label.clone())),
        ("first", Value::Point(condition.first.clone())),
        ("second", Value::Point(condition.second.clone())),
    ];
    if !condition.holds() {
        fields.push(("defect", Value::Point(condition.defect())));
    }
    Value::Record(fields)
}

/// The least change of the second piece after which a requirement holds.
pub(super) fn repair(arguments: &Arguments) -> Result<Answer, Error> {
    let pair = Pair::of(arguments)?;
    let mut found = pair.find()?;
    let word = *arguments.word("require")?;
    let met = holds(word, found.order, found.contact.as_ref())?;
    let order: usize = word[1..].parse().unwrap_or(0);
    let repair = match (&pair.meeting, word.starts_with('C')) {
        _ if met => Repair { piece: pair.second.clone(), moved: Vec::new(), squares: Rational::zero(), ratio: None },
        (Meeting::Joint(joint), true) => repair_to_order(&pair.first, &pair.second, joint, order, pair.rational)?,
        _ if word != "G1" => return Err(Error::Unsupported(format!("a repair to {word} is not supported: C0 to C4 and G1 are"))),
        _ if pair.rational => return Err(Error::Unsupported("a repair to G1 is for pieces without weights; C1 is for others too".into())),
        _ => {
            let sides = pair.sides();
            let (own, other, reversed) =
                sides.ok_or_else(|| Error::WrongShape("a repair to G1 needs a joint that is an end or side of both pieces".into()))?;
            repair_tangents((&pair.first, own), (&pair.second, other), reversed)?
        }
    };
    // Whatever was changed, the join is asked once more.
    let reached = pair.order(&repair.piece)?.map(|(order, _)| order);
    let contact = pair.contact(&repair.piece)?;
    if !holds(word, reached, contact.as_ref())? {
        return Err(Error::Unsupported(format!(
            "moved as little as possible the pieces are not {word}: a normal or tangent vanishes at the joint, or they lie on one side of it"
        )));
    }
    let text = match (word.starts_with('C'), reached, contact.as_ref().and_then(Contact::order)) {
        (true, Some(reached), _) => reached.to_string(),
        (_, _, Some(order)) => format!("G{order}"),
        _ => word.to_owned(),
    };
    let mut fields = place(&pair.meeting);
    fields.extend([("required", Value::Word(word)), ("holds", Value::Truth(met))]);
    let labels = pair.second.labels();
    let cartesian = |point: &[Rational]| if pair.rational { projected(point).unwrap_or_default() } else { point.to_vec() };
    let (old, new): (Vec<_>, Vec<_>) = (pair.second.points().map(cartesian).collect(), repair.piece.points().map(cartesian).collect());
    let moved = repair.moved.iter().map(|&place| {
        let displacement = new[place].iter().zip(&old[place]).map(|(a, b)| a - b).collect();
        Value::Record(vec![
            ("label", Value::Document(labels[place].clone())),
            ("from", Value::Point(old[place].clone())),
            ("to", Value::Point(new[place].clone())),
            ("displacement", Value::Point(displacement)),
        ])
    });
    fields.extend([("moved", Value::List(moved.collect())), ("sum_of_squares", Value::Number(repair.squares.clone()))]);
    if let Some((ratio, shear)) = &repair.ratio {
        fields.extend([("ratio", Value::Number(ratio.clone())), ("shear", numbers(shear))]);
    }
    fields.push(("reached", Value::Document(text.clone())));
    fields.push(("frame", Value::Frame(repair.piece.frame())));
    fields.push(("points", Value::Net(repair.piece.with_points(new)?)));
    if pair.rational {
        fields.push(("weights", Value::Numbers(repair.piece.points().filter_map(|point| point.last().cloned()).collect())));
    }
    found.requirement = Some((word, met));
    found.repair = Some(RepairFinding { before: pair.second.clone(), repair, rational: pair.rational, reached: text });
    Ok(Answer::new(fields).with_finding(Finding::Join(Box::new(found))))
}

/// What continuity forces on a neighbour across an end or side of a piece.
pub(super) fn extension(arguments: &Arguments) -> Result<Answer, Error> {
    let piece = arguments.piece()?;
    let (to, order) = (arguments.numbers("extend")?, *arguments.count("order")?);
    let unless_said = match piece {
        Piece::Curve(_) => Side::End,
        Piece::Triangle(_) => Side::St,
        Piece::Rectangle(_) => Side::U1,
    };
    let side = arguments.word("edge").map_or(Ok(unless_said), |name| Side::named(&piece, name))?;
    let joint = match arguments.number("at") {
        Ok(at) => Joint::Parameter(at.clone()),
        Err(_) => side.joint(&piece.frame())?,
    };
    // The neighbour begins at the joint and ends at the new vertex.
    let frame: Frame<Rational> = match (piece.frame(), &joint, to.as_slice()) {
        (Frame::Interval(_), Joint::Parameter(at), [end]) => Interval::new(at.clone(), end.clone())?.into(),
        (Frame::Triangle(_), Joint::Edge([from, along]), [u, v]) => {
            Triangle::new([u.clone(), v.clone()], from.clone(), along.clone())?.into()
        }
        (Frame::Rectangle(frame), Joint::Edge([from, _]), [end]) => {
            let beside = |at: &Rational| Interval::new(at.clone(), end.clone());
            match side {
                Side::U0 | Side::U1 => Rectangle::new(beside(&from[0])?, frame.v().clone()).into(),
                _ => Rectangle::new(frame.u().clone(), beside(&from[1])?).into(),
            }
        }
        (Frame::Triangle(_), ..) => {
            return Err(Error::WrongCount { what: "parameters of the neighbour's vertex", expected: 2, found: to.len() });
        }
        _ => return Err(Error::WrongCount { what: "parameters of the neighbour's vertex", expected: 1, found: to.len() }),
    };
    let found = extend(&piece, &frame, &joint, order)?;
    let Extension { continuation, forced } = &found;
    let entries = continuation.labels().into_iter().zip(continuation.points()).zip(forced).map(|((label, point), forced)| {
        let point = if *forced { Value::Point(point.to_vec()) } else { Value::Nothing };
        Value::Record(vec![("label", Value::Document(label)), ("forced", point)])
    });
    let fields = vec![("frame", Value::Frame(frame)), ("neighbour", Value::List(entries.collect()))];
    Ok(Answer::new(fields).with_finding(Finding::Extension(Box::new(found))))
}
