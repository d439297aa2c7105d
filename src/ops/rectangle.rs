//! Operations on surfaces by their bidegree, and on rectangular patches.

use super::triangle::{carried, check as check_surface, converted_surface};
use crate::affine::Frame;
use crate::error::Error;
use crate::kernel::coefficient::Coefficient;
use crate::matrix::bernstein_matrix;
use crate::piece::Piece;
use crate::rectangular::{Axis, RectangularPatch};
use crate::symmetry::Symmetry;
use crate::value::{Answer, Arguments, LabelledRow, Layers, Value};

type Outcome<C> = Result<Answer<C>, Error>;

pub(super) fn polar<C: Coefficient>(arguments: &Arguments<C>) -> Outcome<C> {
    let surface = arguments.surface()?;
    let mut fields = vec![("maps", Value::Polar(surface.polar()))];
    if let Ok(frame) = arguments.rectangle("frame") {
        fields.push(("points", Value::Net(Piece::Rectangle(surface.over_rectangle(frame)?))));
    }
    Ok(Answer::new(fields))
}

pub(super) fn polar_homogeneous<C: Coefficient>(arguments: &Arguments<C>) -> Outcome<C> {
    super::triangle::polar_homogeneous(arguments)
}

pub(super) fn check<C: Coefficient>(arguments: &Arguments<C>) -> Outcome<C> {
    check_surface(arguments)
}

pub(super) fn blossom<C: Coefficient>(arguments: &Arguments<C>) -> Outcome<C> {
    let (us, vs) = (arguments.polar_arguments("us")?, arguments.polar_arguments("vs")?);
    Ok(Answer::new(vec![("value", Value::Point(arguments.surface()?.blossom_bidegree(us, vs)?))]))
}

/// The point of the parameter plane that is asked about.
pub(super) fn place<C: Coefficient>(arguments: &Arguments<C>) -> Result<[C; 2], Error> {
    Ok([arguments.number("u")?.clone(), arguments.number("v")?.clone()])
}

pub(super) fn eval<C: Coefficient>(arguments: &Arguments<C>) -> Outcome<C> {
    let at = place(arguments)?;
    let point = match arguments.get("points") {
        Some(_) => arguments.rectangular()?.value(&at)?,
        None => arguments.surface()?.value(&at),
    };
    Ok(Answer::new(vec![("point", Value::Point(point))]))
}

/// The rows of a net with labels.
fn labelled<C: Coefficient>(net: &RectangularPatch<C>, label: impl Fn(usize, usize) -> String) -> Vec<LabelledRow<C>> {
    let row = |(i, row): (usize, Vec<&[C]>)| row.into_iter().enumerate().map(|(j, point)| (label(i, j), point.to_vec())).collect();
    net.rows().map(Iterator::collect).enumerate().map(row).collect()
}

pub(super) fn two_step<C: Coefficient>(arguments: &Arguments<C>) -> Outcome<C> {
    let first = match arguments.word("first") {
        Ok(&"v") => Axis::V,
        _ => Axis::U,
    };
    let steps = arguments.rectangular()?.two_steps(&place(arguments)?, first)?;
    let nets = steps.nets().iter().enumerate().map(|(l, net)| labelled(net, |i, j| steps.label(l, i, j))).collect();
    let line = |(l, points): (usize, &Vec<Vec<C>>)| {
        vec![points.iter().enumerate().map(|(k, point)| (steps.second_label(l, k), point.clone())).collect()]
    };
    let lines = steps.layers().iter().enumerate().map(line).collect();
    Ok(Answer::new(vec![
        ("stage1", Value::Layers(Layers { name: if first == Axis::U { "step in u" } else { "step in v" }, layers: nets, in_rows: true })),
        ("stage2", Value::Layers(Layers { name: if first == Axis::U { "step in v" } else { "step in u" }, layers: lines, in_rows: false })),
        ("point", Value::Point(steps.point().to_vec())),
    ])
    .weighted(arguments.is_weighted()))
}

pub(super) fn one_step<C: Coefficient>(arguments: &Arguments<C>) -> Outcome<C> {
    let steps = arguments.rectangular()?.common_steps(&place(arguments)?)?;
    let nets = steps.nets().iter().enumerate().map(|(l, net)| labelled(net, |i, j| steps.label(l, i, j))).collect();
    Ok(Answer::new(vec![
        ("layers", Value::Layers(Layers { name: "step", layers: nets, in_rows: true })),
        ("point", Value::Point(steps.point().to_vec())),
    ])
    .weighted(arguments.is_weighted()))
}

pub(super) fn split<C: Coefficient>(arguments: &Arguments<C>) -> Outcome<C> {
    let parts = arguments.rectangular()?.split(&place(arguments)?)?;
    let net = |patch: Option<RectangularPatch<C>>| patch.map_or(Value::Nothing, |patch| Value::Net(Piece::Rectangle(patch)));
    Ok(Answer::new(vec![
        ("point", Value::Point(parts.point)),
        ("ll", net(parts.ll)),
        ("rl", net(parts.rl)),
        ("lr", net(parts.lr)),
        ("rr", net(parts.rr)),
    ])
    .weighted(arguments.is_weighted()))
}

pub(super) fn segment<C: Coefficient>(arguments: &Arguments<C>) -> Outcome<C> {
    let segment = arguments.surface()?.segment(&arguments.parameter_point("A")?, &arguments.parameter_point("B")?)?;
    carried(arguments, segment, true)
}

pub(super) fn diagonal<C: Coefficient>(arguments: &Arguments<C>) -> Outcome<C> {
    let segment = arguments.rectangular()?.diagonal()?;
    Ok(Answer::new(vec![("degree", Value::Count(segment.degree())), ("points", Value::Net(Piece::Curve(segment)))])
        .weighted(arguments.is_weighted()))
}

pub(super) fn iso<C: Coefficient>(arguments: &Arguments<C>) -> Outcome<C> {
    let patch = arguments.rectangular()?;
    let segment = match (arguments.number("u"), arguments.number("v")) {
        (Ok(u), Err(_)) => patch.iso(Axis::U, u)?,
        (Err(_), Ok(v)) => patch.iso(Axis::V, v)?,
        _ => return Err(Error::WrongShape("one of u and v is constant, the other one runs: give one of --u and --v".into())),
    };
    framed(arguments, segment)
}

/// A curve with a frame of its own.
fn framed<C: Coefficient>(arguments: &Arguments<C>, segment: crate::segment::Segment<C>) -> Outcome<C> {
    let frame = Value::Frame(segment.frame().clone().into());
    let mut answer = carried(arguments, segment, true)?;
    answer.fields.insert(0, ("frame", frame));
    Ok(answer)
}

pub(super) fn edge<C: Coefficient>(arguments: &Arguments<C>) -> Outcome<C> {
    let patch = arguments.rectangular()?;
    let frame = patch.frame().clone();
    let segment = match *arguments.word("edge")? {
        "u0" => patch.iso(Axis::U, frame.u().r())?,
        "u1" => patch.iso(Axis::U, frame.u().s())?,
        "v0" => patch.iso(Axis::V, frame.v().r())?,
        "v1" => patch.iso(Axis::V, frame.v().s())?,
        other => return Err(Error::WrongShape(format!("a rectangle has the edges u0, u1, v0 and v1; found `{other}`"))),
    };
    framed(arguments, segment)
}

pub(super) fn reduce<C: Coefficient>(arguments: &Arguments<C>) -> Outcome<C> {
    let reduction = arguments.rectangular()?.reduce()?;
    let (p, q) = reduction.true_degree;
    Ok(Answer::new(vec![
        ("true_degree", Value::Counts(vec![p, q])),
        ("total_degree", Value::Count(reduction.total_degree)),
        ("points", Value::Net(Piece::Rectangle(reduction.patch))),
    ])
    .weighted(arguments.is_weighted()))
}

pub(super) fn to_triangle<C: Coefficient>(arguments: &Arguments<C>) -> Outcome<C> {
    let Ok(Frame::Triangle(frame)) = arguments.any_frame("frame") else {
        let patch = converted_surface(arguments)?.over_rectangle(arguments.rectangle("frame")?)?;
        let (p, q) = patch.degree();
        return Ok(Answer::new(vec![("degree", Value::Counts(vec![p, q])), ("points", Value::Net(Piece::Rectangle(patch)))]));
    };
    let patch = converted_surface(arguments)?.over_triangle(frame)?;
    Ok(Answer::new(vec![("degree", Value::Count(patch.degree())), ("points", Value::Net(Piece::Triangle(patch)))]))
}

pub(super) fn symmetry<C: Coefficient>(arguments: &Arguments<C>) -> Outcome<C> {
    let patch = arguments.rectangular()?;
    if let Ok(name) = arguments.word("apply") {
        let symmetry = Symmetry::ALL.into_iter().find(|symmetry| symmetry.name() == *name);
        let symmetry = symmetry.ok_or_else(|| Error::WrongShape(format!("there is no symmetry `{name}` of a rectangle")))?;
        let image = patch.under(symmetry);
        let (p, q) = image.degree();
        return Ok(Answer::new(vec![("degree", Value::Counts(vec![p, q])), ("points", Value::Net(Piece::Rectangle(image)))]));
    }
    let mut records = Vec::new();
    for symmetry in Symmetry::ALL {
        let (p, q) = patch.under(symmetry).degree();
        records.push(Value::Record(vec![
            ("symmetry", Value::Word(symmetry.name())),
            ("relation", Value::Word(symmetry.relation())),
            ("degree", Value::Counts(vec![p, q])),
            ("invariant", Value::Truth(patch.is_invariant(symmetry))),
        ]));
    }
    Ok(Answer::new(vec![("symmetries", Value::List(records))]))
}

pub(super) fn matrix<C: Coefficient>(arguments: &Arguments<C>) -> Outcome<C> {
    let patch = arguments.rectangular()?;
    let (p, q) = patch.degree();
    let of = |matrix: nalgebra::DMatrix<crate::exact::Rational>| {
        Value::Matrix(matrix.row_iter().map(|row| row.iter().cloned().map(C::from).collect()).collect())
    };
    let coordinates = (0..patch.dimension()).map(|coordinate| {
        let control: Vec<Vec<C>> = patch.rows().map(|row| row.map(|point| point[coordinate].clone()).collect()).collect();
        let monomial = monomial_matrix(&patch, coordinate)?;
        Ok(Value::Record(vec![("control", Value::Matrix(control)), ("monomial", Value::Matrix(monomial))]))
    });
    let coordinates = coordinates.collect::<Result<_, Error>>()?;
    Ok(Answer::new(vec![
        ("local_frame", Value::Frame(patch.frame().clone().into())),
        ("bernstein_u", of(bernstein_matrix(p))),
        ("bernstein_v", of(bernstein_matrix(q))),
        ("coordinates", Value::List(coordinates)),
    ]))
}

/// The coefficients of the powers of the local parameters, which run from 0 to 1 over the frame.
fn monomial_matrix<C: Coefficient>(patch: &RectangularPatch<C>, coordinate: usize) -> Result<Vec<Vec<C>>, Error> {
    let points = patch.points().map(<[C]>::to_vec).collect();
    let surface = RectangularPatch::from_points(patch.degree(), points, crate::affine::Rectangle::unit())?.surface()?;
    let (p, q) = patch.degree();
    let mut matrix = vec![vec![C::nothing(); q + 1]; p + 1];
    for (h, k, c) in surface.terms(coordinate) {
        matrix[h][k] = c.clone();
    }
    Ok(matrix)
}
