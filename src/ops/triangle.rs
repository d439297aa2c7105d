//! Operations on surfaces by their total degree, and on triangular patches.

use super::curve::checked;
use crate::affine::Frame;
use crate::blossom::check_polar_form;
use crate::error::Error;
use crate::kernel::coefficient::Coefficient;
use crate::piece::Piece;
use crate::reading::Reading;
use crate::segment::Segment;
use crate::surface::Surface;
use crate::triangular::TriangularPatch;
use crate::value::{Answer, Arguments, Homogeneous, Layers, Value};

type Outcome<C> = Result<Answer<C>, Error>;

pub(super) fn polar<C: Coefficient>(arguments: &Arguments<C>) -> Outcome<C> {
    let surface = arguments.surface()?;
    let mut fields = vec![("maps", Value::Polar(surface.polar()))];
    if let Ok(frame) = arguments.triangle("frame") {
        fields.push(("points", Value::Net(Piece::Triangle(surface.over_triangle(frame)?))));
    }
    Ok(Answer::new(fields))
}

pub(super) fn polar_homogeneous<C: Coefficient>(arguments: &Arguments<C>) -> Outcome<C> {
    Ok(Answer::new(vec![("maps", Value::HomogeneousPolar(arguments.surface()?.polar()))]))
}

pub(super) fn blossom<C: Coefficient>(arguments: &Arguments<C>) -> Outcome<C> {
    let value = arguments.surface()?.blossom(arguments.plane_arguments("args")?)?;
    Ok(Answer::new(vec![("value", Value::Point(value))]))
}

pub(super) fn check<C: Coefficient>(arguments: &Arguments<C>) -> Outcome<C> {
    let (surface, variables) = (arguments.surface()?, arguments.variables());
    let defects = check_polar_form(surface.reading(), &surface.polynomials(variables), &variables, arguments.expressions("claim")?)?;
    Ok(checked(surface.reading(), defects))
}

/// A surface read by its least degrees, or by higher ones that were asked for.
fn readings<C: Coefficient>(arguments: &Arguments<C>) -> Result<[Surface<C>; 2], Error> {
    let Some(Value::Surface(surface)) = arguments.get("surface") else {
        return Err(Error::WrongShape("`surface` is missing".into()));
    };
    let (p, q) = if arguments.get("bidegree").is_some() { arguments.pair("bidegree")? } else { surface.true_bidegree() };
    let degree = arguments.count("degree").copied().unwrap_or_else(|_| surface.true_total_degree());
    Ok([surface.read_as(Reading::Total(degree))?, surface.read_as(Reading::Bidegree(p, q))?])
}

pub(super) fn both<C: Coefficient>(arguments: &Arguments<C>) -> Outcome<C> {
    let [total, tensor] = readings(arguments)?;
    Ok(Answer::new(vec![("total", Value::Polar(total.polar())), ("tensor", Value::Polar(tensor.polar()))]))
}

pub(super) fn index(arguments: &Arguments) -> Result<Answer, Error> {
    let indices = TriangularPatch::<crate::exact::Rational>::indices(*arguments.count("degree")?);
    let order = indices.iter().map(|index| Value::Counts(index.to_vec())).collect();
    Ok(Answer::new(vec![("count", Value::Count(indices.len())), ("order", Value::List(order))]))
}

pub(super) fn eval<C: Coefficient>(arguments: &Arguments<C>) -> Outcome<C> {
    let a = arguments.parameter_point("a")?;
    let point = match arguments.get("points") {
        Some(_) => arguments.triangular()?.value(&a)?,
        None => arguments.surface()?.value(&a),
    };
    Ok(Answer::new(vec![("point", Value::Point(point))]))
}

pub(super) fn casteljau<C: Coefficient>(arguments: &Arguments<C>) -> Outcome<C> {
    let scheme = arguments.triangular()?.scheme(&arguments.parameter_point("a")?)?;
    let row = |l: usize, i: usize| {
        let places = scheme.indices(l).into_iter().filter(move |place| place.0 == i);
        places.map(|(i, j)| (scheme.label(l, i, j), scheme.get(l, i, j).to_vec())).collect()
    };
    let layer = |l: usize| (0..=scheme.degree() - l).map(|i| row(l, i)).collect();
    let layers = Layers { name: "layer", layers: (0..=scheme.degree()).map(layer).collect(), in_rows: true };
    Ok(Answer::new(vec![
        ("frame", Value::Frame(scheme.frame().clone().into())),
        ("barycentric", Value::Numbers(scheme.barycentric().to_vec())),
        ("layers", Value::Layers(layers)),
        ("point", Value::Point(scheme.point().to_vec())),
    ])
    .weighted(arguments.is_weighted()))
}

pub(super) fn split<C: Coefficient>(arguments: &Arguments<C>) -> Outcome<C> {
    let parts = arguments.triangular()?.split(&arguments.parameter_point("a")?)?;
    let net = |patch: Option<TriangularPatch<C>>| patch.map_or(Value::Nothing, |patch| Value::Net(Piece::Triangle(patch)));
    Ok(Answer::new(vec![("point", Value::Point(parts.point)), ("ast", net(parts.ast)), ("rat", net(parts.rat)), ("rsa", net(parts.rsa))])
        .weighted(arguments.is_weighted()))
}

pub(super) fn quadrisect<C: Coefficient>(arguments: &Arguments<C>) -> Outcome<C> {
    let parts = arguments.triangular()?.quadrisect()?;
    let net = |patch| Value::Net(Piece::Triangle(patch));
    let fields = vec![("abt", net(parts.abt)), ("bac", net(parts.bac)), ("crb", net(parts.crb)), ("sca", net(parts.sca))];
    Ok(Answer::new(fields).weighted(arguments.is_weighted()))
}

/// A curve on a surface as an answer.
pub(super) fn carried<C: Coefficient>(arguments: &Arguments<C>, segment: Segment<C>, with_degree: bool) -> Outcome<C> {
    let true_degree = segment.curve()?.true_degree();
    let mut fields = vec![("degree", Value::Count(segment.degree()))];
    fields.retain(|_| with_degree);
    fields.extend([("points", Value::Net(Piece::Curve(segment))), ("true_degree", Value::Count(true_degree))]);
    Ok(Answer::new(fields).weighted(arguments.is_weighted()))
}

pub(super) fn segment<C: Coefficient>(arguments: &Arguments<C>) -> Outcome<C> {
    let segment = arguments.surface()?.segment(&arguments.parameter_point("A")?, &arguments.parameter_point("B")?)?;
    carried(arguments, segment, false)
}

pub(super) fn edge<C: Coefficient>(arguments: &Arguments<C>) -> Outcome<C> {
    let patch = arguments.triangular()?;
    let [r, s, t] = patch.frame().vertices();
    let (from, to) = match *arguments.word("edge")? {
        "rs" => (r, s),
        "st" => (s, t),
        "tr" => (t, r),
        other => return Err(Error::WrongShape(format!("a triangle has the edges rs, st and tr; found `{other}`"))),
    };
    carried(arguments, patch.surface()?.segment(from, to)?, true)
}

pub(super) fn reduce<C: Coefficient>(arguments: &Arguments<C>) -> Outcome<C> {
    let reduction = arguments.triangular()?.reduce()?;
    Ok(Answer::new(vec![
        ("true_degree", Value::Count(reduction.true_degree)),
        ("zero", Value::Truth(reduction.zero)),
        ("points", Value::Net(Piece::Triangle(reduction.patch))),
    ])
    .weighted(arguments.is_weighted()))
}

pub(super) fn derivative<C: Coefficient>(arguments: &Arguments<C>) -> Outcome<C> {
    if arguments.get("direction").is_none() {
        return Err(Error::WrongShape(
            "the derivative of a surface needs a direction: --direction 1,0 is that of the first variable".into(),
        ));
    }
    let direction = arguments.parameter_point("direction")?;
    let derivative = arguments.surface()?.derivative(&direction, arguments.count("order").copied().unwrap_or(1));
    Ok(Answer::new(vec![match arguments.get("a") {
        Some(_) => ("value", Value::Point(derivative.value(&arguments.parameter_point("a")?))),
        None => ("derivative", Value::Surface(derivative)),
    }]))
}

/// The equation of a piece over the frame that is converted from.
pub(super) fn converted_surface<C: Coefficient>(arguments: &Arguments<C>) -> Result<Surface<C>, Error> {
    if arguments.get("points").is_none() {
        return arguments.surface();
    }
    match arguments.piece_over(arguments.frame_or_default("from"))? {
        Piece::Triangle(patch) => patch.surface(),
        Piece::Rectangle(patch) => patch.surface(),
        Piece::Curve(_) => Err(Error::WrongShape("only surfaces are converted".into())),
    }
}

pub(super) fn to_rectangle<C: Coefficient>(arguments: &Arguments<C>) -> Outcome<C> {
    let Frame::Rectangle(frame) = arguments.frame_or_default("frame") else {
        let patch = converted_surface(arguments)?.over_triangle(arguments.triangle("frame")?)?;
        return Ok(Answer::new(vec![("degree", Value::Count(patch.degree())), ("points", Value::Net(Piece::Triangle(patch)))]));
    };
    let patch = converted_surface(arguments)?.over_rectangle(&frame)?;
    let (p, q) = patch.degree();
    Ok(Answer::new(vec![("degree", Value::Counts(vec![p, q])), ("points", Value::Net(Piece::Rectangle(patch)))]))
}

pub(super) fn homogenize<C: Coefficient>(arguments: &Arguments<C>) -> Outcome<C> {
    let [total, tensor] = readings(arguments)?;
    let (Reading::Total(m), Reading::Bidegree(p, q)) = (total.reading(), tensor.reading()) else {
        return Err(Error::WrongShape("only surfaces have two homogenizations".into()));
    };
    let records = (0..total.dimension()).map(|coordinate| {
        let by_total = total.terms(coordinate).into_iter().map(|(h, k, c)| (vec![m - h - k, h, k], c.clone()));
        let by_tensor = tensor.terms(coordinate).into_iter().map(|(h, k, c)| (vec![p - h, h, q - k, k], c.clone()));
        vec![
            ("total", Value::Homogeneous(Homogeneous { letters: &['c', 'u', 'v'], terms: by_total.collect() })),
            ("tensor", Value::Homogeneous(Homogeneous { letters: &['a', 'u', 'b', 'v'], terms: by_tensor.collect() })),
        ]
    });
    let mut records: Vec<_> = records.collect();
    Ok(Answer::new(if records.len() == 1 {
        records.swap_remove(0)
    } else {
        vec![("coordinates", Value::List(records.into_iter().map(Value::Record).collect()))]
    }))
}
