//! How smoothly two shapes join.

use super::{Fault, Function, Operands, Outcome};
use crate::continuity::{
    Continuity, continuity_of_curves, continuity_of_rational_curves, continuity_of_rational_surfaces, continuity_of_surfaces,
};
use crate::error::Error;
use crate::exact::Rational;
use crate::geometric::{geometric_join, tangent_plane_join};
use crate::joint::Joint;
use crate::piece::{Equation, Piece};
use crate::triangular::TriangularPatch;
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
    let unknown = |why: &str| Err(why.to_owned());
    let (parametric, geometric) = match (equations, joint) {
        ((Equation::Curve(a), Equation::Curve(b)), Joint::Parameter(t)) if weighted => {
            (continuity_of_rational_curves(a, b, t)?.cartesian, unknown("geometric continuity of curves with weights is not decided"))
        }
        ((Equation::Curve(a), Equation::Curve(b)), Joint::Parameter(t)) => {
            let geometric = geometric_join(a, b, t, t).map(|join| join.order.map_or(-1, |order| order as i64));
            (continuity_of_curves(a, b, t)?, geometric.map_err(|error| error.to_string()))
        }
        ((Equation::Surface(a), Equation::Surface(b)), Joint::Edge(edge)) if weighted => {
            (continuity_of_rational_surfaces(a, b, edge)?.cartesian, unknown("geometric continuity of patches with weights is not decided"))
        }
        ((Equation::Surface(a), Equation::Surface(b)), Joint::Edge(edge)) => {
            let found = continuity_of_surfaces(a, b, edge)?;
            (found, pieces.map_or_else(|| unknown("geometric continuity needs two nets"), |pieces| geometric_order(pieces, edge, found)))
        }
        _ => return Err(Error::WrongShape("found a curve and a surface, expected two curves or two surfaces".into())),
    };
    Ok(Order::Found { parametric, geometric })
}

/// G1 of two triangles: what a smooth parametric join says, or the tangent planes.
fn geometric_order([first, second]: &[Piece; 2], edge: &[[Rational; 2]; 2], parametric: Continuity) -> Result<i64, String> {
    let at_least = match parametric {
        Continuity::Broken => return Ok(-1),
        Continuity::C(order) => order as i64,
        Continuity::Same => i64::MAX,
    };
    let (Piece::Triangle(first), Piece::Triangle(second)) = (first, second) else {
        return if at_least >= 1 { Ok(at_least) } else { Err("geometric continuity of rectangles is not decided here".to_owned()) };
    };
    // Each with the vertex off the edge first, the shared ones in one order.
    let turned = |patch: &TriangularPatch| {
        let vertices = patch.frame().vertices();
        let place = |wanted: &[Rational; 2]| vertices.iter().position(|vertex| vertex == wanted);
        let (from, to) = (place(&edge[0])?, place(&edge[1])?);
        Some(patch.permuted([3 - from - to, from, to]))
    };
    let (Some(first), Some(second)) = (turned(first), turned(second)) else {
        return Err("the nets share a line, but no edge".to_owned());
    };
    let join = tangent_plane_join(&first, &second).map_err(|error| error.to_string())?;
    Ok(if join.is_g1() { at_least.max(1) } else { at_least })
}
