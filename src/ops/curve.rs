//! Operations on curves, for numbers and for symbolic parameters alike.

use crate::blossom::check_polar_form;
use crate::error::Error;
use crate::kernel::coefficient::Coefficient;
use crate::value::{Answer, Arguments, Value};

type Outcome<C> = Result<Answer<C>, Error>;

pub(super) fn polar<C: Coefficient>(arguments: &Arguments<C>) -> Outcome<C> {
    let curve = arguments.curve()?;
    let mut fields = vec![("maps", Value::Polar(curve.polar()))];
    if let Ok(frame) = arguments.frame("frame") {
        fields.push(("points", Value::Net(curve.segment(frame)?)));
    }
    Ok(Answer::new(fields))
}

pub(super) fn blossom<C: Coefficient>(arguments: &Arguments<C>) -> Outcome<C> {
    Ok(Answer::new(vec![("value", Value::Point(arguments.curve()?.blossom(arguments.numbers("args")?)?))]))
}

pub(super) fn blossom_homogeneous<C: Coefficient>(arguments: &Arguments<C>) -> Outcome<C> {
    let value = arguments.curve()?.blossom_homogeneous(arguments.polar_arguments("args")?)?;
    Ok(Answer::new(vec![("value", Value::Point(value))]))
}

pub(super) fn check<C: Coefficient>(arguments: &Arguments<C>) -> Outcome<C> {
    let curve = arguments.curve()?.map(&mut |number: &C| Ok::<_, Error>(number.clone().into()))?;
    let defects = check_polar_form(&curve, arguments.expressions("claim")?, arguments.variable())?;
    let holds = defects.is_empty();
    Ok(Answer::new(vec![("holds", Value::Truth(holds)), ("defects", Value::Defects(defects))]).that_holds(holds))
}

pub(super) fn points<C: Coefficient>(arguments: &Arguments<C>) -> Outcome<C> {
    let segment = arguments.curve()?.segment(arguments.frame("frame")?)?;
    Ok(Answer::new(vec![("points", Value::Net(segment))]))
}

pub(super) fn equation<C: Coefficient>(arguments: &Arguments<C>) -> Outcome<C> {
    Ok(Answer::new(vec![("curve", Value::Curve(arguments.segment()?.curve()?))]))
}

pub(super) fn eval<C: Coefficient>(arguments: &Arguments<C>) -> Outcome<C> {
    let t = arguments.number("t")?;
    let point = match arguments.get("points") {
        Some(_) => arguments.segment()?.value(t)?,
        None => arguments.curve()?.value(t),
    };
    Ok(Answer::new(vec![("point", Value::Point(point))]))
}

pub(super) fn casteljau<C: Coefficient>(arguments: &Arguments<C>) -> Outcome<C> {
    let scheme = arguments.segment()?.scheme(arguments.number("t")?)?;
    let list = |points: Vec<&[C]>| Value::Points(points.into_iter().map(<[C]>::to_vec).collect());
    let (point, left, right) = (scheme.point().to_vec(), list(scheme.left().collect()), list(scheme.right().collect()));
    Ok(Answer::new(vec![("layers", Value::Scheme(scheme)), ("point", Value::Point(point)), ("left", left), ("right", right)]))
}

pub(super) fn split<C: Coefficient>(arguments: &Arguments<C>) -> Outcome<C> {
    let (left, right) = arguments.segment()?.split(arguments.number("t")?)?;
    Ok(Answer::new(vec![("left", Value::Piece(left)), ("right", Value::Piece(right))]))
}

pub(super) fn subdivide<C: Coefficient>(arguments: &Arguments<C>) -> Outcome<C> {
    let (segment, depth) = (arguments.segment()?, arguments.count("depth").copied().unwrap_or(1));
    Ok(Answer::new(vec![if arguments.flag("polyline") {
        ("polyline", Value::Points(segment.polyline(depth)?))
    } else {
        ("pieces", Value::Pieces(segment.subdivide(depth)?))
    }]))
}

pub(super) fn reframe<C: Coefficient>(arguments: &Arguments<C>) -> Outcome<C> {
    let segment = arguments.segment()?.reframe(arguments.frame("new_frame")?)?;
    Ok(Answer::new(vec![("points", Value::Net(segment))]))
}

pub(super) fn elevate<C: Coefficient>(arguments: &Arguments<C>) -> Outcome<C> {
    let segment = arguments.segment()?.elevate(arguments.count("by").copied().unwrap_or(1));
    Ok(Answer::new(vec![("points", Value::Net(segment))]))
}

pub(super) fn reduce<C: Coefficient>(arguments: &Arguments<C>) -> Outcome<C> {
    let reduction = arguments.segment()?.reduce()?;
    Ok(Answer::new(vec![
        ("true_degree", Value::Count(reduction.true_degree)),
        ("zero", Value::Truth(reduction.zero)),
        ("points", Value::Net(reduction.segment)),
    ]))
}

pub(super) fn derivative<C: Coefficient>(arguments: &Arguments<C>) -> Outcome<C> {
    let derivative = arguments.curve()?.derivative(arguments.count("order").copied().unwrap_or(1));
    Ok(Answer::new(vec![match arguments.number("t") {
        Ok(t) => ("value", Value::Point(derivative.value(t))),
        Err(_) => ("derivative", Value::Curve(derivative)),
    }]))
}

pub(super) fn product<C: Coefficient>(arguments: &Arguments<C>) -> Outcome<C> {
    let product = arguments.segment()?.product(&arguments.other_segment()?)?;
    Ok(Answer::new(vec![("points", Value::Net(product))]))
}

pub(super) fn transform<C: Coefficient>(arguments: &Arguments<C>) -> Outcome<C> {
    let map = arguments.map("map")?;
    Ok(Answer::new(vec![match arguments.get("points") {
        Some(_) => ("points", Value::Net(arguments.segment()?.transform(map)?)),
        None => ("curve", Value::Curve(arguments.curve()?.transform(map)?)),
    }]))
}

pub(super) fn equal<C: Coefficient>(arguments: &Arguments<C>) -> Outcome<C> {
    let same = arguments.segment()?.same_map(&arguments.other_segment()?)?;
    Ok(Answer::new(vec![("equal", Value::Truth(same))]).that_holds(same))
}

pub(super) fn describe<C: Coefficient>(arguments: &Arguments<C>) -> Outcome<C> {
    let curve = arguments.curve()?;
    let (degree, true_degree, dimension) = (curve.degree(), curve.true_degree(), curve.dimension());
    let name = match degree {
        0 => "constant",
        1 => "affine",
        2 => "quadratic",
        3 => "cubic",
        4 => "quartic",
        5 => "quintic",
        _ => "n-ic",
    };
    Ok(Answer::new(vec![
        ("parameter_dimension", Value::Count(1)),
        ("object_dimension", Value::Count(dimension)),
        ("gauge_dimension", Value::Count(dimension.saturating_sub(1))),
        ("polar_degree", Value::Count(degree)),
        ("true_degree", Value::Count(true_degree)),
        ("degenerate", Value::Truth(true_degree < degree)),
        ("name", Value::Word(name)),
        ("control_points", Value::Count(degree + 1)),
        ("degrees_of_freedom", Value::Count((degree + 1) * dimension)),
    ]))
}
