//! The join of two pieces: its orders and conditions, and its repair.

use num_traits::Zero;

use super::join::order;
use super::pair::Pair;
use crate::continuity::Continuity;
use crate::error::Error;
use crate::exact::Rational;
use crate::joint::{AffineGroup, JoinCondition, Joint, affine_groups, join_conditions};
use crate::meeting::Meeting;
use crate::quotient::Quotient;
use crate::repair::{Repair, repair_tangents, repair_to_order};
use crate::value::{Answer, Arguments, Contact, Finding, JoinFinding, RepairFinding, Value};
use crate::weights::projected;

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
        let group = |group: &AffineGroup| {
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
