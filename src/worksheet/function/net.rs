//! Functions that make nets and change them.

use num_traits::One;

use super::{Fault, Function, Operand, Operands, Outcome};
use crate::affine::{AffineMap, Frame, Interval, Rectangle, Triangle};
use crate::error::Error;
use crate::piece::Piece;
use crate::rectangular::RectangularPatch;
use crate::segment::Segment;
use crate::symbolic::{Polynomial, Symbol};
use crate::triangular::{TriangularPatch, triangular_degree};
use crate::value::{Domain, Value};
use crate::worksheet::evaluate::Evaluator;
use crate::worksheet::quantity::{Map, Net, Point, Quantity};
use crate::worksheet::request::Request;

pub(super) const FUNCTIONS: &[Function] = &[
    Function { name: "curve", signatures: &["curve([points], r..s)", "curve([points])"], run: curve },
    Function { name: "triangle", signatures: &["triangle([[row], …], (u,v), (u,v), (u,v))", "triangle([[row], …])"], run: triangle },
    Function { name: "rectangle", signatures: &["rectangle([[row], …], a..b, c..d)", "rectangle([[row], …])"], run: rectangle },
    Function { name: "spline", signatures: &["spline([points], [knots], degree)"], run: spline },
    Function {
        name: "points",
        signatures: &["points(F, r..s)", "points(S, (u,v), (u,v), (u,v))", "points(S, a..b, c..d)", "points(K)"],
        run: points,
    },
    Function { name: "equation", signatures: &["equation(K)"], run: equation },
    Function {
        name: "reframe",
        signatures: &["reframe(K, r..s)", "reframe(T, (u,v), (u,v), (u,v))", "reframe(R, a..b, c..d)"],
        run: reframe,
    },
    Function { name: "elevate", signatures: &["elevate(K)", "elevate(K, by)", "elevate(R, in_u, in_v)"], run: elevate },
    Function { name: "reduce", signatures: &["reduce(K)"], run: reduce },
    Function { name: "product", signatures: &["product(K, L)"], run: product },
    Function { name: "transform", signatures: &["transform(K, (x + 1, 2 y))", "transform(F, (x + 1, 2 y))"], run: transform },
    Function { name: "symmetry", signatures: &["symmetry(R, transpose)"], run: symmetry },
];

/// The coordinates of the points of a list, with their weights last if one has a weight.
fn coordinates(operands: &Operands<'_>, items: &[Quantity]) -> Result<(Vec<Vec<Polynomial>>, bool), Fault> {
    let weighted = items.iter().any(|item| matches!(item, Quantity::Point(Point { weight: Some(_), .. })));
    let point = |item: &Quantity| {
        let (coordinates, weight) = match item {
            Quantity::Number(value) => (std::slice::from_ref(value), None),
            Quantity::Point(point) => (point.coordinates.as_slice(), point.weight.as_ref()),
            other => return Err(operands.wrong(0, format!("found {} in the list, expected points", other.kind()))),
        };
        if !weighted {
            return Ok(coordinates.to_vec());
        }
        let weight = weight.cloned().unwrap_or_else(Polynomial::one);
        Ok(coordinates.iter().map(|x| (x * &weight).with_simple_roots()).chain([weight.clone()]).collect())
    };
    Ok((items.iter().map(point).collect::<Result<_, Fault>>()?, weighted))
}

fn curve(_: &Evaluator<'_>, operands: &Operands<'_>) -> Outcome {
    let (points, weighted) = coordinates(operands, &operands.list(0)?)?;
    let frame = match if operands.len() > 1 { operands.last_frame(1)? } else { Interval::unit().into() } {
        Frame::Interval(frame) => frame,
        _ => return Err(operands.wrong(1, "found another frame, expected an interval `r..s`")),
    };
    Ok(Quantity::Net(Net { piece: Piece::Curve(Segment::from_points(points, frame)?), weighted }))
}

/// The rows of a nested list; a flat list is one row.
fn rows(items: Vec<Quantity>) -> Vec<Vec<Quantity>> {
    if items.iter().all(|item| matches!(item, Quantity::List(_))) {
        let row = |item| match item {
            Quantity::List(row) => row,
            other => vec![other],
        };
        return items.into_iter().map(row).collect();
    }
    vec![items]
}

fn triangle(_: &Evaluator<'_>, operands: &Operands<'_>) -> Outcome {
    let mut list = rows(operands.list(0)?);
    if list.len() == 1 && list[0].len() > 1 {
        let degree = triangular_degree(list[0].len()).ok_or_else(|| {
            operands.wrong(0, format!("found {} points, expected 1, 3, 6, 10, …: (m+1)(m+2)/2 for degree m", list[0].len()))
        })?;
        let mut points = list.remove(0).into_iter();
        list = (0..=degree).map(|i| points.by_ref().take(degree + 1 - i).collect()).collect();
    }
    let counts: Vec<usize> = list.iter().map(Vec::len).collect();
    let (points, weighted) = coordinates(operands, &list.into_iter().flatten().collect::<Vec<_>>())?;
    let frame = match if operands.len() > 1 { operands.last_frame(1)? } else { Triangle::standard().into() } {
        Frame::Triangle(frame) => frame,
        _ => return Err(operands.wrong(1, "found another frame, expected three points")),
    };
    let patch = TriangularPatch::from_rows(in_rows(points, &counts), frame)?;
    Ok(Quantity::Net(Net { piece: Piece::Triangle(patch), weighted }))
}

fn rectangle(_: &Evaluator<'_>, operands: &Operands<'_>) -> Outcome {
    let list = rows(operands.list(0)?);
    let counts: Vec<usize> = list.iter().map(Vec::len).collect();
    let (points, weighted) = coordinates(operands, &list.into_iter().flatten().collect::<Vec<_>>())?;
    let frame = match if operands.len() > 1 { operands.last_frame(1)? } else { Rectangle::unit().into() } {
        Frame::Rectangle(frame) => frame,
        _ => return Err(operands.wrong(1, "found another frame, expected two intervals `a..b, c..d`")),
    };
    let patch = RectangularPatch::from_rows(in_rows(points, &counts), frame)?;
    Ok(Quantity::Net(Net { piece: Piece::Rectangle(patch), weighted }))
}

fn in_rows(points: Vec<Vec<Polynomial>>, counts: &[usize]) -> Vec<Vec<Vec<Polynomial>>> {
    let mut points = points.into_iter();
    counts.iter().map(|&count| points.by_ref().take(count).collect()).collect()
}

fn spline(_: &Evaluator<'_>, operands: &Operands<'_>) -> Outcome {
    operands.ends(3)?;
    let (points, weighted) = coordinates(operands, &operands.list(0)?)?;
    if weighted {
        return Err(operands.wrong(0, "found points with weights, expected points without"));
    }
    let pieces = Request::new("bspline.pieces", Domain::Curve)
        .with("points", Value::Points(points))
        .with("knots", Value::Numbers(operands.numbers(1)?))
        .with("degree", Value::Count(operands.small(2)?))
        .reply()?
        .take("pieces")?;
    // Each piece is its interval and its curve; the net says both.
    let Quantity::List(pieces) = pieces else { return Ok(pieces) };
    let knots = operands.numbers(1)?;
    let mut intervals = knots.windows(2).filter(|pair| pair[0] != pair[1]);
    let degree = operands.small(2)?;
    let inside = |pair: &[Polynomial]| {
        let (low, high) = (&knots[degree], &knots[knots.len() - 1 - degree]);
        let order = |a: &Polynomial, b: &Polynomial| a.compare_numbers(b).is_some_and(std::cmp::Ordering::is_le);
        order(low, &pair[0]) && order(&pair[1], high)
    };
    let mut nets = Vec::new();
    for piece in pieces {
        let Some(Quantity::Map(map)) = (match piece {
            Quantity::List(mut parts) => parts.pop(),
            other => Some(other),
        }) else {
            continue;
        };
        if let Some(pair) = intervals.by_ref().find(|pair| inside(pair)) {
            nets.push(net_of(&map, &Interval::new(pair[0].clone(), pair[1].clone())?.into())?);
        }
    }
    Ok(Quantity::List(nets))
}

/// The net of a map over a frame.
pub(in crate::worksheet) fn net_of(map: &Map, frame: &Frame<Polynomial>) -> Result<Quantity, Error> {
    let weighted = map.weight.is_some();
    let (request, name, value) = match frame {
        Frame::Interval(_) => (Request::new("curve.points", Domain::Curve), "curve", Value::Curve(map.curve()?)),
        Frame::Triangle(_) => (Request::new("triangle.points", Domain::Triangle), "surface", Value::Surface(map.surface(true)?)),
        Frame::Rectangle(_) => (Request::new("rectangle.points", Domain::Rectangle), "surface", Value::Surface(map.surface(false)?)),
    };
    match request.with(name, value).with("frame", Value::Frame(frame.clone())).reply()?.take("points")? {
        Quantity::Net(net) => Ok(Quantity::Net(Net { weighted, ..net })),
        other => Ok(other),
    }
}

pub(super) fn points(evaluator: &Evaluator<'_>, operands: &Operands<'_>) -> Outcome {
    let shape = operands.value(0, "a map or a net")?;
    if operands.len() == 1 {
        return Ok(operands.net(0)?.list());
    }
    let frame = operands.last_frame(1)?;
    if let Some(slip) = evaluator.slip {
        return Ok(slip.points(shape, &frame)?);
    }
    // A net over a frame of its own kind keeps its polar degree.
    let map = operands.map(0)?;
    let is_surface = !matches!(frame, Frame::Interval(_));
    if is_surface != (map.variables.len() == 2) {
        let (found, expected) =
            if is_surface { ("a curve", "an interval `r..s`") } else { ("a surface", "three points, or two intervals") };
        return Err(operands.wrong(1, format!("found the frame {frame} for {found}, expected {expected}")));
    }
    Ok(net_of(&map, &frame)?)
}

fn equation(_: &Evaluator<'_>, operands: &Operands<'_>) -> Outcome {
    operands.ends(1)?;
    Ok(Quantity::Map(operands.net(0)?.map()?))
}

fn reframe(evaluator: &Evaluator<'_>, operands: &Operands<'_>) -> Outcome {
    operands.net(0)?;
    if operands.len() == 1 {
        return Err(operands.count("a net and its new frame"));
    }
    points(evaluator, operands)
}

fn elevate(_: &Evaluator<'_>, operands: &Operands<'_>) -> Outcome {
    let net = operands.net(0)?;
    let (operation, domain, by) = match &net.piece {
        Piece::Curve(_) => ("curve.elevate", Domain::Curve, Value::Count(operands.small_or(1, 1)?)),
        Piece::Triangle(_) => ("triangle.elevate", Domain::Triangle, Value::Count(operands.small_or(1, 1)?)),
        Piece::Rectangle(_) => {
            let in_u = operands.small_or(1, 1)?;
            let in_v = operands.small_or(2, if operands.len() == 2 { in_u } else { 1 })?;
            ("rectangle.elevate", Domain::Rectangle, Value::Counts(vec![in_u, in_v]))
        }
    };
    operands.ends(if domain == Domain::Rectangle { 3 } else { 2 })?;
    Ok(Request::new(operation, domain).with_net(net)?.with("by", by).reply()?.take("points")?)
}

fn reduce(_: &Evaluator<'_>, operands: &Operands<'_>) -> Outcome {
    operands.ends(1)?;
    let net = operands.net(0)?;
    let (operation, domain) = named(net, ["curve.reduce", "triangle.reduce", "rectangle.reduce"]);
    Ok(Request::new(operation, domain).with_net(net)?.reply()?.take("points")?)
}

/// The operation for the kind of a net.
pub(super) fn named(net: &Net, [curve, triangle, rectangle]: [&'static str; 3]) -> (&'static str, Domain) {
    match net.piece {
        Piece::Curve(_) => (curve, Domain::Curve),
        Piece::Triangle(_) => (triangle, Domain::Triangle),
        Piece::Rectangle(_) => (rectangle, Domain::Rectangle),
    }
}

fn product(_: &Evaluator<'_>, operands: &Operands<'_>) -> Outcome {
    operands.ends(2)?;
    let (first, second) = (operands.net(0)?, operands.net(1)?);
    if first.weighted || second.weighted {
        return Err(operands.wrong(0, "found a net with weights, expected nets without"));
    }
    let (_, domain) = named(first, [""; 3]);
    Ok(Request::new("product", domain).with_net(first)?.with_other_net(second)?.reply()?.take("points")?)
}

/// An affine map of space from the images of its coordinates.
fn affine(operands: &Operands<'_>, dimension: usize) -> Result<AffineMap<Polynomial>, Fault> {
    let images = operands.point(1)?;
    let letters: Vec<Symbol> = ['x', 'y', 'z'].into_iter().take(dimension).map(|letter| Symbol::new(letter, None)).collect();
    let (mut rows, mut shift) = (Vec::new(), Vec::new());
    for image in images {
        let mut rest = image.clone();
        let mut row = Vec::new();
        for &letter in &letters {
            let coefficient = rest.coefficients_in(letter).into_iter().nth(1).unwrap_or_default();
            rest -= &coefficient * &Polynomial::from(letter);
            row.push(coefficient);
        }
        if row.iter().chain([&rest]).any(|part| ['x', 'y', 'z'].iter().any(|&letter| part.degree_in(Symbol::new(letter, None)) > 0)) {
            return Err(operands.wrong(1, format!("found a map that is not affine in the {dimension} coordinates x, y, …")));
        }
        rows.push(row);
        shift.push(rest);
    }
    Ok(AffineMap::new(rows, shift)?)
}

fn transform(_: &Evaluator<'_>, operands: &Operands<'_>) -> Outcome {
    operands.ends(2)?;
    match operands.value(0, "a map or a net")? {
        Quantity::Net(net) => {
            let map = affine(operands, net.piece.dimension() - usize::from(net.weighted))?;
            let map = if net.weighted { map.homogeneous() } else { map };
            Ok(Quantity::Net(Net { piece: net.piece.transform(&map)?, weighted: net.weighted }))
        }
        _ => {
            let map = operands.map(0)?;
            if map.weight.is_some() {
                return Err(operands.wrong(0, "found a map with a weight, expected a map without, or a net"));
            }
            let affine = affine(operands, map.components.len())?;
            let components = affine.apply(&map.components)?;
            Ok(Quantity::Map(Map { components, ..map }))
        }
    }
}

fn symmetry(_: &Evaluator<'_>, operands: &Operands<'_>) -> Outcome {
    operands.ends(2)?;
    let net = operands.net(0)?;
    let Piece::Rectangle(_) = net.piece else { return Err(operands.wrong(0, "found another net, expected a rectangular one")) };
    let name = operands.text(1).unwrap_or("").replace('_', "-");
    let known = crate::symmetry::Symmetry::ALL.into_iter().find(|symmetry| symmetry.name() == name);
    let Some(symmetry) = known else {
        return Err(operands.wrong(
            1,
            "found no symmetry, expected reverse_u, reverse_v, half_turn, transpose, quarter_turn, quarter_turn_back or anti_transpose",
        ));
    };
    let rearranged = Request::new("rectangle.symmetry", Domain::Rectangle)
        .with_net(net)?
        .with("apply", Value::Word(symmetry.name()))
        .reply()?
        .take("points")?;
    // The operation turns the frame along; here the net is read over the frame as it was.
    let (Quantity::Net(Net { piece: Piece::Rectangle(patch), weighted }), Frame::Rectangle(frame)) = (rearranged, net.frame()) else {
        return Err(operands.wrong(0, "found another net, expected a rectangular one"));
    };
    let forward = |interval: &Interval<Polynomial>| {
        let known = [frame.u(), frame.v()].into_iter().find(|known| known.reversed() == *interval);
        known.unwrap_or(interval).clone()
    };
    let frame = Rectangle::new(forward(patch.frame().u()), forward(patch.frame().v()));
    let points = patch.points().map(<[Polynomial]>::to_vec).collect();
    Ok(Quantity::Net(Net { piece: Piece::Rectangle(RectangularPatch::from_points(patch.degree(), points, frame)?), weighted }))
}

/// Whether an argument is given by name.
pub(super) fn is_named(operand: Option<&Operand>) -> bool {
    matches!(operand, Some(Operand::Named { .. }))
}
