//! How smoothly two shapes join.

use super::{Fault, Function, Operands, Outcome};
use crate::continuity::{
    Continuity, continuity_of_curves, continuity_of_rational_curves, continuity_of_rational_surfaces, continuity_of_surfaces,
};
use crate::error::Error;
use crate::exact::Rational;
use crate::geometric::{geometric_join, geometric_join_of_rational};
use crate::joint::Joint;
use crate::piece::{Equation, Piece};
use crate::side::Side;
use crate::tangent::tangent_plane_join;
use crate::worksheet::evaluate::Evaluator;
use crate::worksheet::quantity::{Map, Order, Quantity, rational};

pub(super) const FUNCTIONS: &[Function] =
    &[Function { name: "join", signatures: &["join(K, L)", "join(F, G, t)", "join(S, X, (u,v), (u,v))"], run: join }];

fn equation(map: &Map) -> Result<Equation, Error> {
    Ok(if map.variables.len() == 1 {
        Equation::Curve(map.curve()?.map(&mut rational)?)
    } else {
        Equation::Surface(map.surface(true)?.map(&mut rational)?)
    })
}

fn join(_: &Evaluator<'_>, operands: &Operands<'_>) -> Outcome {
    let both = (operands.value(0, "a net or a map")?, operands.value(1, "a net or a map")?);
    if let ((Quantity::Net(first), Quantity::Net(second)), 2) = (both, operands.len()) {
        if first.weighted != second.weighted {
            return Err(operands
                .wrong(1, "found a net with weights and one without, expected two of a kind: give both some, 1 where there is none"));
        }
        let pieces = [first.numeric()?, second.numeric()?];
        let joint = Joint::between(&pieces[0], &pieces[1]).ok_or_else(|| {
            let frames = format!("{} and {}", pieces[0].frame(), pieces[1].frame());
            operands.wrong(1, format!("found the frames {frames}, expected two that share one end or one edge"))
        })?;
        let equations = (pieces[0].equation()?, pieces[1].equation()?);
        return Ok(Quantity::Order(order(&equations, &joint, first.weighted, Some(&pieces))?));
    }
    let (first, second) = (operands.map(0)?, operands.map(1)?);
    if first.weight.is_some() != second.weight.is_some() {
        return Err(operands.wrong(1, "found a map with a weight and one without, expected two of a kind"));
    }
    let place = |index: usize| -> Result<[Rational; 2], Fault> {
        let [u, v] = operands.place(index)?;
        Ok([rational(&u)?, rational(&v)?])
    };
    let joint = match (first.variables.len(), operands.len()) {
        (1, 3) => Joint::Parameter(rational(operands.number(2)?)?),
        (2, 4) => Joint::Edge([place(2)?, place(3)?]),
        (1, _) => return Err(operands.count("two curves and the parameter where they join")),
        _ => return Err(operands.count("two surfaces and two points of the line of the parameter plane where they join")),
    };
    let equations = (equation(&first)?, equation(&second)?);
    Ok(Quantity::Order(order(&equations, &joint, first.weight.is_some(), None)?))
}

fn order(equations: &(Equation, Equation), joint: &Joint, weighted: bool, pieces: Option<&[Piece; 2]>) -> Result<Order, Error> {
    let (parametric, geometric) = match (equations, joint) {
        ((Equation::Curve(a), Equation::Curve(b)), Joint::Parameter(t)) => {
            let (parametric, join) = if weighted {
                (continuity_of_rational_curves(a, b, t)?.cartesian, geometric_join_of_rational(a, b, t, t))
            } else {
                (continuity_of_curves(a, b, t)?, geometric_join(a, b, t, t))
            };
            (parametric, join.map(|join| join.order.map_or(-1, |order| order as i64)).map_err(|error| error.to_string()))
        }
        ((Equation::Surface(a), Equation::Surface(b)), Joint::Edge(edge)) => {
            let found = if weighted { continuity_of_rational_surfaces(a, b, edge)?.cartesian } else { continuity_of_surfaces(a, b, edge)? };
            let geometric = match pieces {
                Some(pieces) => geometric_order(pieces, joint, weighted, found),
                None => Err("geometric continuity needs two nets".to_owned()),
            };
            (found, geometric)
        }
        _ => return Err(Error::WrongShape("found a curve and a surface, expected two curves or two surfaces".into())),
    };
    Ok(Order::Found { parametric, geometric })
}

/// G1 of two patches: what a smooth parametric join says, or the tangent planes.
fn geometric_order([first, second]: &[Piece; 2], joint: &Joint, weighted: bool, parametric: Continuity) -> Result<i64, String> {
    let at_least = match parametric {
        Continuity::Broken => return Ok(-1),
        Continuity::C(order) => order as i64,
        Continuity::Same => i64::MAX,
    };
    let (Some((own, _)), Some((other, _))) = (Side::on(first, joint), Side::on(second, joint)) else {
        return Err("the nets share a line, but no edge".to_owned());
    };
    let join = tangent_plane_join((first, own), (second, other), weighted).map_err(|error| error.to_string())?;
    match join.g1() {
        Some(true) => Ok(at_least.max(1)),
        Some(false) => Ok(at_least.min(0)),
        None => Err("a normal vanishes on the joint, so that geometric continuity is not decided".to_owned()),
    }
}
