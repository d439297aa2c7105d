//! Functions about polar forms, degrees and bases.

use super::{Fault, Function, Operand, Operands, Outcome};
use crate::affine::{Frame, Interval, Rectangle, Triangle};
use crate::blossom::PolarForm;
use crate::error::Error;
use crate::piece::Piece;
use crate::reading::Reading;
use crate::symbolic::{Polynomial, Symbol};
use crate::value::{Domain, Value};
use crate::worksheet::evaluate::{Evaluator, MAX_POLAR_TERMS, count_of};
use crate::worksheet::quantity::{Degrees, Map, Quantity};
use crate::worksheet::request::Request;

pub(super) const FUNCTIONS: &[Function] = &[
    Function { name: "polar", signatures: &["polar(F)", "polar(F, m)", "polar(S, m)", "polar(S, p, q)"], run: polar },
    Function { name: "sigma", signatures: &["sigma(k, a, b, c)", "sigma(k, [a, b, c])", "sigma([a, b, c])"], run: sigma },
    Function { name: "degree", signatures: &["degree(F)"], run: degree },
    Function { name: "bidegree", signatures: &["bidegree(S)"], run: bidegree },
    Function { name: "polardegree", signatures: &["polardegree(F)"], run: polar_degree },
    Function { name: "homogenize", signatures: &["homogenize(S)", "homogenize(S, m)", "homogenize(S, p, q)"], run: homogenize },
    Function {
        name: "bernstein",
        signatures: &["bernstein(k, m)", "bernstein(k, m, r..s)", "bernstein((i,j), m)", "bernstein((i,j), (p,q))"],
        run: bernstein,
    },
    Function { name: "influence", signatures: &["influence(K, k)", "influence(T, (i,j))", "influence(R, (i,j))"], run: influence },
    Function { name: "barycentric", signatures: &["barycentric((u,v), (u,v), (u,v), (u,v))"], run: barycentric },
];

/// A polar form written out, in the letters of the map with the numbers of the arguments.
fn expanded<'a>(form: &PolarForm<Polynomial>, variables: impl Iterator<Item = &'a Symbol> + Clone) -> Result<Vec<Polynomial>, Error> {
    // The letters of the polar form in the order of the groups and coordinates.
    let letters = form.reading().groups().into_iter().enumerate().flat_map(|(group, (count, dimension))| {
        (1..=count).flat_map(move |argument| (1..=dimension).map(move |axis| (group, argument, axis, dimension)))
    });
    let variables: Vec<Symbol> = variables.copied().collect();
    let renaming: Vec<(Symbol, Symbol)> = letters
        .map(|(group, argument, axis, dimension)| {
            let variable = variables[if dimension == 2 { axis - 1 } else { group.min(variables.len() - 1) }];
            (form.reading().symbol(group, argument, axis), variable.with_index(argument as u32))
        })
        .collect();
    (0..form.dimension()).map(|coordinate| Ok(form.expand(coordinate, MAX_POLAR_TERMS)?.renamed(&renaming))).collect()
}

fn polar(_: &Evaluator<'_>, operands: &Operands<'_>) -> Outcome {
    let map = operands.map(0)?;
    let form = match (map.variables.len(), operands.len()) {
        (1, 1) => map.curve()?.polar(),
        (1, 2) => map.curve()?.with_degree(operands.small(1)?)?.polar(),
        (2, 1) => map.surface(map.is_by_total())?.polar(),
        (2, 2) => map.surface(true)?.read_as(Reading::Total(operands.small(1)?))?.polar(),
        (2, 3) => map.surface(false)?.read_as(Reading::Bidegree(operands.small(1)?, operands.small(2)?))?.polar(),
        (1, _) => return Err(operands.count("a curve, and perhaps its polar degree")),
        _ => return Err(operands.count("a surface, and perhaps its polar degree or its two degrees")),
    };
    let values = expanded(&form, map.variables.iter())?;
    Ok(Quantity::point(values))
}

fn sigma(_: &Evaluator<'_>, operands: &Operands<'_>) -> Outcome {
    let all = |values: Vec<Polynomial>| -> Result<Vec<Quantity>, Fault> {
        let reply = Request::new("sigma", Domain::Curve).with("values", Value::Numbers(values)).reply()?;
        match reply.take("values")? {
            Quantity::List(values) => Ok(values),
            other => Ok(vec![other]),
        }
    };
    if let (Quantity::List(_), 1) = (operands.value(0, "a number or a list")?, operands.len()) {
        return Ok(Quantity::List(all(operands.numbers(0)?)?));
    }
    let index = operands.small(0)?;
    let values = match operands.list.get(1) {
        Some(Operand::Value { value: Quantity::List(_), .. }) => {
            operands.ends(2)?;
            operands.numbers(1)?
        }
        _ => (1..operands.len()).map(|place| operands.number(place).cloned()).collect::<Result<_, _>>()?,
    };
    let count = values.len();
    all(values)?
        .into_iter()
        .nth(index)
        .ok_or_else(|| operands.wrong(0, format!("found σ_{index} of {count} numbers, expected at most σ_{count}")))
}

fn degree(_: &Evaluator<'_>, operands: &Operands<'_>) -> Outcome {
    operands.ends(1)?;
    let map = operands.map(0)?;
    let degree_of = |value: &Polynomial| {
        let degree = |monomial: &crate::symbolic::Monomial| map.variables.iter().map(|&symbol| monomial.degree_in(symbol)).sum::<u32>();
        value.terms().map(|(monomial, _)| degree(monomial)).max().unwrap_or(0)
    };
    Ok(Quantity::count(map.homogeneous().map(degree_of).max().unwrap_or(0) as usize))
}

fn bidegree(_: &Evaluator<'_>, operands: &Operands<'_>) -> Outcome {
    operands.ends(1)?;
    let map = operands.surface(0)?;
    let degrees = map.variables.iter().map(|&symbol| map.homogeneous().map(|value| value.degree_in(symbol)).max().unwrap_or(0));
    Ok(counts(&degrees.map(|degree| degree as usize).collect::<Vec<_>>()))
}

fn counts(list: &[usize]) -> Quantity {
    Quantity::point(list.iter().map(|&count| Polynomial::from(crate::exact::Rational::from(count as i64))).collect())
}

fn polar_degree(_: &Evaluator<'_>, operands: &Operands<'_>) -> Outcome {
    operands.ends(1)?;
    let map = operands.map(0)?;
    Ok(match (map.own_degrees()?, map.is_by_total()) {
        (Degrees { pair: Some((p, q)), .. }, false) => counts(&[p, q]),
        (degrees, _) => Quantity::count(degrees.total.unwrap_or(0)),
    })
}

fn homogenize(_: &Evaluator<'_>, operands: &Operands<'_>) -> Outcome {
    let map = operands.surface(0)?;
    if map.weight.is_some() {
        return Err(operands.wrong(0, "found a surface with a weight, expected one without"));
    }
    let mut request = Request::new("homogenize", Domain::Triangle).with("surface", Value::Surface(map.surface(true)?));
    let mut part = "total";
    match operands.len() {
        1 => {}
        2 => request = request.with("degree", Value::Count(operands.small(1)?)),
        3 => {
            request = request.with("bidegree", Value::Counts(vec![operands.small(1)?, operands.small(2)?]));
            part = "tensor";
        }
        _ => return Err(operands.count("a surface, and perhaps its degree or its two degrees")),
    }
    let reply = request.reply()?;
    if let Some(value) = reply.get(part) {
        return Ok(value.clone());
    }
    let Quantity::List(records) = reply.take("coordinates")? else { return Err(operands.count("a surface")) };
    let place = usize::from(part == "tensor");
    let coordinates = records.into_iter().filter_map(|record| match record {
        Quantity::List(mut parts) if parts.len() > place => match parts.swap_remove(place) {
            Quantity::Number(value) => Some(value),
            _ => None,
        },
        _ => None,
    });
    Ok(Quantity::point(coordinates.collect()))
}

/// Two counts in brackets.
fn pair(operands: &Operands<'_>, index: usize) -> Result<Option<Vec<usize>>, Fault> {
    match operands.value(index, "a number or a pair of numbers")? {
        Quantity::Point(point) if point.coordinates.len() == 2 => {
            let counts: Option<Vec<usize>> = point.coordinates.iter().map(count_of).collect();
            counts.map(Some).ok_or_else(|| operands.wrong(index, "found no whole numbers, expected some such as (1,2)"))
        }
        _ => Ok(None),
    }
}

fn bernstein(_: &Evaluator<'_>, operands: &Operands<'_>) -> Outcome {
    let (index, degrees) = (pair(operands, 0)?, pair(operands, 1)?);
    let own = if operands.len() > 2 { Some(operands.last_frame(2)?) } else { None };
    let frame = own.unwrap_or_else(|| match (&index, &degrees) {
        (None, _) => Frame::Interval(Interval::unit()),
        (Some(_), None) => Frame::Triangle(Triangle::standard()),
        (Some(_), Some(_)) => Frame::Rectangle(Rectangle::unit()),
    });
    let mut index = match index {
        Some(index) => index,
        None => vec![operands.small(0)?],
    };
    if let (Frame::Triangle(_), &[i, j], None) = (&frame, index.as_slice(), &degrees) {
        // The last of the three indices is what the others leave.
        index.push(operands.small(1)?.checked_sub(i + j).ok_or_else(|| operands.wrong(0, "found an index beyond the degree"))?);
    }
    let degree = match degrees {
        Some(degrees) => ("bidegree", Value::Counts(degrees)),
        None => ("degree", Value::Count(operands.small(1)?)),
    };
    let reply = Request::new("bernstein", Domain::Curve)
        .with(degree.0, degree.1)
        .with("index", Value::Counts(index))
        .with("frame", Value::Frame(frame))
        .reply()?;
    // One record: the index, the polynomial, and where it is largest.
    let Quantity::List(records) = reply.take("polynomials")? else { return Err(operands.count("an index and a degree")) };
    let parts = records.into_iter().find_map(|record| match record {
        Quantity::List(parts) => Some(parts),
        _ => None,
    });
    let map = parts.into_iter().flatten().find_map(|part| match part {
        Quantity::Map(map) => Some(map),
        _ => None,
    });
    map.and_then(|map| map.components.into_iter().next()).map(Quantity::from).ok_or_else(|| operands.count("an index and a degree"))
}

fn influence(_: &Evaluator<'_>, operands: &Operands<'_>) -> Outcome {
    operands.ends(2)?;
    let net = operands.net(0)?;
    let index = match pair(operands, 1)? {
        Some(index) => index,
        None => vec![operands.small(1)?],
    };
    let index = match (&net.piece, index.as_slice()) {
        // The last of the three indices is what the others leave.
        (Piece::Triangle(patch), &[i, j]) if i + j <= patch.degree() => vec![i, j, patch.degree() - i - j],
        _ => index,
    };
    let (_, domain) = super::net::named(net, [""; 3]);
    Ok(Request::new("influence", domain).with_net(net)?.with("index", Value::Counts(index)).reply()?.take("change")?)
}

fn barycentric(_: &Evaluator<'_>, operands: &Operands<'_>) -> Outcome {
    let Frame::Triangle(frame) = operands.last_frame(1)? else {
        return Err(operands.wrong(1, "found another frame, expected three points"));
    };
    Ok(Quantity::point(frame.barycentric(&operands.place(0)?)?.to_vec()))
}

/// The letters of maps that operations give.
pub(in crate::worksheet) fn with_letters(map: Map, letters: &[Symbol]) -> Map {
    let renaming: Vec<(Symbol, Symbol)> =
        map.variables.iter().copied().zip(letters.iter().copied()).filter(|(from, to)| from != to).collect();
    if renaming.is_empty() {
        return map;
    }
    Map {
        components: map.components.iter().map(|component| component.renamed(&renaming)).collect(),
        weight: map.weight.as_ref().map(|weight| weight.renamed(&renaming)),
        variables: letters.to_vec(),
        degrees: map.degrees,
    }
}
