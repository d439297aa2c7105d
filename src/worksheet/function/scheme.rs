//! Functions about de Casteljau's algorithm, derivatives, and curves on surfaces.

use super::net::{is_named, named, net_of};
use super::polar::with_letters;
use super::{Fault, Function, Operand, Operands, Outcome};
use crate::affine::Frame;
use crate::piece::Piece;
use crate::symbolic::Polynomial;
use crate::value::{Domain, Value};
use crate::worksheet::evaluate::Evaluator;
use crate::worksheet::quantity::{Degrees, Map, Net, Quantity};
use crate::worksheet::request::{Reply, Request};

pub(super) const FUNCTIONS: &[Function] = &[
    Function {
        name: "casteljau",
        signatures: &["casteljau(K, t)", "casteljau(F, r..s, t)", "casteljau(T, (u,v))", "casteljau(R, (u,v))"],
        run: casteljau,
    },
    Function { name: "twostep", signatures: &["twostep(R, (u,v))", "twostep(R, (u,v), v)"], run: two_step },
    Function { name: "split", signatures: &["split(K, t)", "split(T, (u,v))", "split(T)", "split(R, (u,v))"], run: split },
    Function {
        name: "derivative",
        signatures: &["derivative(F)", "derivative(F, k)", "derivative(S, (a,b))", "derivative(S, (a,b), k)"],
        run: derivative,
    },
    Function {
        name: "segment",
        signatures: &["segment(S, (u,v), (u,v))", "segment(R, u = c)", "segment(R, v = c)", "segment(T, rs)", "segment(R, u0)"],
        run: segment,
    },
    Function { name: "diagonal", signatures: &["diagonal(R)"], run: diagonal },
];

/// A net, or a map with the frame behind it; and how many arguments that took.
fn net(operands: &Operands<'_>) -> Result<(Net, usize), Fault> {
    if let Quantity::Net(net) = operands.value(0, "a net, or a map and its frame")? {
        return Ok((net.clone(), 1));
    }
    let map = operands.map(0)?;
    if operands.len() == 1 {
        operands.net(0)?;
    }
    match operands.list.get(1) {
        Some(Operand::Range { .. }) => {}
        _ if map.variables.len() == 2 && operands.len() >= 4 => {}
        _ => {
            operands.net(0)?;
        }
    }
    let Some((frame, taken)) = operands.frame(1)? else { return Err(operands.count("a map, its frame and a parameter")) };
    match net_of(&map, &frame)? {
        Quantity::Net(net) => Ok((net, 1 + taken)),
        other => Err(operands.wrong(0, format!("found {}, expected a net", other.kind()))),
    }
}

/// A request about a net at a parameter, or at two.
fn at(operands: &Operands<'_>, net: &Net, index: usize, [curve, triangle, rectangle]: [&'static str; 3]) -> Result<Request, Fault> {
    let (operation, domain) = named(net, [curve, triangle, rectangle]);
    let request = Request::new(operation, domain).with_net(net)?;
    Ok(match domain {
        Domain::Curve => request.with("t", Value::Number(operands.number(index)?.clone())),
        Domain::Triangle => request.with("a", Value::Point(operands.place(index)?.to_vec())),
        Domain::Rectangle => {
            let [u, v] = operands.place(index)?;
            request.with("u", Value::Number(u)).with("v", Value::Number(v))
        }
    })
}

fn casteljau(evaluator: &Evaluator<'_>, operands: &Operands<'_>) -> Outcome {
    let (mut net, taken) = net(operands)?;
    if let Some(slip) = evaluator.slip {
        net = slip.net(&net)?;
    }
    operands.ends(taken + 1)?;
    let request = at(operands, &net, taken, ["curve.casteljau", "triangle.casteljau", "rectangle.one_step"])?;
    Ok(request.reply()?.take("layers")?)
}

fn two_step(_: &Evaluator<'_>, operands: &Operands<'_>) -> Outcome {
    let net = operands.net(0)?;
    let Piece::Rectangle(_) = net.piece else { return Err(operands.wrong(0, "found another net, expected a rectangular one")) };
    let mut request = at(operands, net, 1, ["", "", "rectangle.two_step"])?;
    if operands.len() > 2 {
        operands.ends(3)?;
        let first = match operands.text(2) {
            Some("u") => "u",
            Some("v") => "v",
            _ => return Err(operands.wrong(2, "found something else, expected `u` or `v`: the parameter that is taken in first")),
        };
        request = request.with("first", Value::Word(first));
    }
    let reply = request.reply()?;
    match (reply.get("stage1"), reply.get("stage2")) {
        (Some(nets), Some(lines)) => Ok(Quantity::List(vec![nets.clone(), lines.clone()])),
        _ => Err(operands.count("a rectangular net and a point of the parameter plane")),
    }
}

fn parts(reply: &Reply, operands: &Operands<'_>, names: &[&str]) -> Outcome {
    let mut list = Vec::new();
    for name in names {
        match reply.get(name) {
            Some(part) => list.push(part.clone()),
            None => {
                let message = format!("found a parameter on the border of the frame, where the part {name} degenerates");
                return Err(operands.wrong(1, message));
            }
        }
    }
    Ok(Quantity::List(list))
}

fn split(_: &Evaluator<'_>, operands: &Operands<'_>) -> Outcome {
    let net = operands.net(0)?;
    if operands.len() == 1 {
        let Piece::Triangle(_) = net.piece else {
            return Err(operands.count("a net and a parameter; only a triangle is split without one, at the midpoints of its edges"));
        };
        let reply = Request::new("triangle.subdivide4", Domain::Triangle).with_net(net)?.with("midpoints", Value::Truth(true)).reply()?;
        return parts(&reply, operands, &["abt", "bac", "crb", "sca"]);
    }
    operands.ends(2)?;
    let reply = at(operands, net, 1, ["curve.split", "triangle.subdivide3", "rectangle.subdivide"])?.reply()?;
    match net.piece {
        Piece::Curve(_) => parts(&reply, operands, &["left", "right"]),
        Piece::Triangle(_) => parts(&reply, operands, &["ast", "rat", "rsa"]),
        Piece::Rectangle(_) => parts(&reply, operands, &["ll", "rl", "lr", "rr"]),
    }
}

fn derivative(_: &Evaluator<'_>, operands: &Operands<'_>) -> Outcome {
    let map = operands.map(0)?;
    if map.weight.is_some() {
        return Err(operands.wrong(0, "found a map with a weight, expected one without"));
    }
    let value = if map.variables.len() == 1 {
        operands.ends(2)?;
        Request::new("curve.derivative", Domain::Curve)
            .with("curve", Value::Curve(map.curve()?))
            .with("order", Value::Count(operands.small_or(1, 1)?))
            .reply()?
            .take("derivative")?
    } else {
        operands.ends(3)?;
        let by_total = map.is_by_total();
        let domain = if by_total { Domain::Triangle } else { Domain::Rectangle };
        let operation = if by_total { "triangle.derivative" } else { "rectangle.derivative" };
        Request::new(operation, domain)
            .with("surface", Value::Surface(map.surface(by_total)?))
            .with("direction", Value::Point(operands.place(1)?.to_vec()))
            .with("order", Value::Count(operands.small_or(2, 1)?))
            .reply()?
            .take("derivative")?
    };
    Ok(match value {
        Quantity::Map(derivative) => Quantity::Map(Map { degrees: Degrees::default(), ..with_letters(derivative, &map.variables) }),
        other => other,
    })
}

fn segment(_: &Evaluator<'_>, operands: &Operands<'_>) -> Outcome {
    if is_named(operands.list.get(1)) {
        operands.ends(2)?;
        let net = rectangle(operands)?;
        let Some(Operand::Named { name, value: Quantity::Number(value), .. }) = operands.list.get(1) else {
            return Err(operands.wrong(1, "found something else, expected a number such as `u = 1/2`"));
        };
        let name = match name.to_string().as_str() {
            "u" => "u",
            "v" => "v",
            _ => return Err(operands.wrong(1, format!("found the parameter `{name}`, expected `u` or `v`"))),
        };
        let request = Request::new("rectangle.iso", Domain::Rectangle).with_net(net)?;
        return Ok(request.with(name, Value::Number(value.clone())).reply()?.take("points")?);
    }
    let edges = ["rs", "st", "tr", "u0", "u1", "v0", "v1"];
    if let (2, Some(edge)) = (operands.len(), operands.text(1).and_then(|text| edges.into_iter().find(|edge| *edge == text))) {
        let net = operands.net(0)?;
        let (operation, domain) = named(net, ["", "triangle.edge", "rectangle.edge"]);
        if domain == Domain::Curve {
            return Err(operands.wrong(0, "found a curve, expected a patch"));
        }
        return Ok(Request::new(operation, domain).with_net(net)?.with("edge", Value::Word(edge)).reply()?.take("points")?);
    }
    let map = operands.map(0)?;
    if map.variables.len() == 1 {
        let frame = operands.last_frame(1)?;
        return match frame {
            Frame::Interval(_) => Ok(net_of(&map, &frame)?),
            _ => Err(operands.wrong(1, "found another frame, expected an interval `r..s`")),
        };
    }
    operands.ends(3)?;
    let by_total = map.is_by_total();
    let (operation, domain) = if by_total { ("triangle.segment", Domain::Triangle) } else { ("rectangle.segment", Domain::Rectangle) };
    let point = |[u, v]: [Polynomial; 2]| Value::Point(vec![u, v]);
    let value = Request::new(operation, domain)
        .with("surface", Value::Surface(map.surface(by_total)?))
        .with("A", point(operands.place(1)?))
        .with("B", point(operands.place(2)?))
        .reply()?
        .take("points")?;
    Ok(match value {
        Quantity::Net(net) => Quantity::Net(Net { weighted: map.weight.is_some(), ..net }),
        other => other,
    })
}

fn rectangle<'o>(operands: &'o Operands<'_>) -> Result<&'o Net, Fault> {
    let net = operands.net(0)?;
    match net.piece {
        Piece::Rectangle(_) => Ok(net),
        _ => Err(operands.wrong(0, "found another net, expected a rectangular one")),
    }
}

fn diagonal(_: &Evaluator<'_>, operands: &Operands<'_>) -> Outcome {
    operands.ends(1)?;
    let net = rectangle(operands)?;
    Ok(Request::new("rectangle.diagonal", Domain::Rectangle).with_net(net)?.with("diagonal", Value::Truth(true)).reply()?.take("points")?)
}
