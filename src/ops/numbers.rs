//! Operations on numbers and on polynomials in one variable.

use num_traits::{Signed, Zero};

use crate::affine::{AffineMap, Frame, Place};
use crate::bernstein::Bernstein;
use crate::blossom;
use crate::error::Error;
use crate::exact::Rational;
use crate::kernel::coefficient::Coefficient;
use crate::piece::Piece;
use crate::roots::{RealRoots, Root, RootPlace, sign_variations};
use crate::value::{Answer, Arguments, Value};

/// The most bits of the width of an isolating interval.
const MAX_WIDTH_BITS: u64 = 1024;

pub(super) fn sigma<C: Coefficient>(arguments: &Arguments<C>) -> Result<Answer<C>, Error> {
    Ok(Answer::new(vec![("values", Value::Numbers(blossom::sigma(arguments.numbers("values")?)))]))
}

pub(super) fn contains(arguments: &Arguments) -> Result<Answer, Error> {
    let at = arguments.numbers("t")?;
    let place = match (arguments.any_frame("frame")?, at.as_slice()) {
        (Frame::Interval(frame), [t]) if t == frame.r() || t == frame.s() => Place::Vertex,
        (Frame::Interval(frame), [t]) if frame.contains(t) => Place::Inside,
        (Frame::Interval(_), [_]) => Place::Outside,
        (Frame::Triangle(frame), [u, v]) => frame.place(&[u.clone(), v.clone()]),
        (Frame::Rectangle(frame), [u, v]) => frame.place(&[u.clone(), v.clone()]),
        (frame, _) => {
            let expected = if matches!(frame, Frame::Interval(_)) { 1 } else { 2 };
            return Err(Error::WrongCount { what: "parameters", expected, found: at.len() });
        }
    };
    let (inside, name) = match place {
        Place::Vertex => (true, "vertex"),
        Place::Edge => (true, "edge"),
        Place::Inside => (true, "inside"),
        Place::Outside => (false, "outside"),
    };
    Ok(Answer::new(vec![("inside", Value::Truth(inside)), ("place", Value::Word(name))]).that_holds(inside))
}

pub(super) fn barycentric<C: Coefficient>(arguments: &Arguments<C>) -> Result<Answer<C>, Error> {
    let Frame::Triangle(frame) = arguments.frame_or_default("frame") else {
        return Err(Error::WrongShape("barycentric coordinates are those of a triangle, such as '(1,0) (0,1) (0,0)'".into()));
    };
    let coordinates = frame.barycentric(&arguments.parameter_point("a")?)?;
    Ok(Answer::new(vec![("barycentric", Value::Numbers(coordinates.to_vec()))]))
}

/// The Bernstein polynomials that the arguments ask for.
fn basis(arguments: &Arguments) -> Result<Bernstein, Error> {
    let degree = || {
        arguments
            .count("degree")
            .copied()
            .map_err(|_| Error::WrongShape("the degree is missing: say --degree, or --bidegree P,Q on a rectangle".into()))
    };
    Ok(match arguments.frame_or_default("frame") {
        Frame::Interval(frame) => Bernstein::new(degree()?, frame),
        Frame::Triangle(frame) => Bernstein::triangle(degree()?, frame),
        Frame::Rectangle(frame) => match arguments.pair("bidegree") {
            Ok(bidegree) => Bernstein::rectangle(bidegree, frame),
            Err(_) => Bernstein::rectangle((degree()?, degree()?), frame),
        },
    })
}

/// The place of an index among those of a basis.
fn position(basis: &Bernstein, index: &[usize]) -> Result<usize, Error> {
    basis.indices().iter().position(|known| known == index).ok_or_else(|| {
        let written = index.iter().map(usize::to_string).collect::<Vec<_>>().join(",");
        let last = basis.indices().pop().unwrap_or_default().iter().map(usize::to_string).collect::<Vec<_>>().join(",");
        Error::WrongShape(format!("there is no index {written} here; the last one is {last}"))
    })
}

pub(super) fn bernstein(arguments: &Arguments) -> Result<Answer, Error> {
    let basis = basis(arguments)?;
    let indices = basis.indices();
    let all = match arguments.counts("index") {
        Ok(index) => {
            let place = position(&basis, index)?;
            place..place + 1
        }
        Err(_) => 0..indices.len(),
    };
    let values = arguments.numbers("t").ok().map(|t| basis.values(t)).transpose()?;
    let mut polynomials = Vec::new();
    for place in all {
        let index = &indices[place];
        let name = if let [k] = index.as_slice() { Value::Count(*k) } else { Value::Counts(index.clone()) };
        let mut record = vec![("index", name), ("polynomial", basis.polynomial(place)?.into()), ("maximum", largest(&basis, place, None))];
        if let Some(value) = values.as_ref().and_then(|values| values.get(place)) {
            record.push(("value", Value::Number(value.clone())));
        }
        polynomials.push(Value::Record(record));
    }
    Ok(Answer::new(vec![("frame", Value::Frame(basis.frame().clone())), ("polynomials", Value::List(polynomials))]))
}

/// Where a Bernstein polynomial is largest, and its value there, or its value times a vector.
fn largest(basis: &Bernstein, place: usize, by: Option<&[Rational]>) -> Value {
    let Some((at, value)) = basis.maximum(place) else { return Value::Nothing };
    let at = match at.as_slice() {
        [t] => Value::Number(t.clone()),
        _ => Value::Point(at),
    };
    let value = match by {
        None => Value::Number(value),
        Some(vector) => Value::Point(vector.iter().map(|x| x * &value).collect()),
    };
    Value::Record(vec![("t", at), ("value", value)])
}

pub(super) fn influence(arguments: &Arguments) -> Result<Answer, Error> {
    let piece = arguments.piece()?;
    let basis = match &piece {
        Piece::Curve(segment) => Bernstein::new(segment.degree(), segment.frame().clone()),
        Piece::Triangle(patch) => Bernstein::triangle(patch.degree(), patch.frame().clone()),
        Piece::Rectangle(patch) => Bernstein::rectangle(patch.degree(), patch.frame().clone()),
    };
    let place = position(&basis, arguments.counts("index")?)?;
    let by = arguments.point("by").ok();
    if let Some(by) = by.filter(|by| by.len() != piece.dimension()) {
        return Err(Error::WrongCount { what: "coordinates", expected: piece.dimension(), found: by.len() });
    }
    let mut change = basis.piece(place)?;
    if let Some(by) = by {
        // The change of the whole map: the vector times the Bernstein polynomial.
        change = change.transform(&AffineMap::new(by.iter().map(|x| vec![x.clone()]).collect(), vec![Rational::from(0); by.len()])?)?;
    }
    Ok(Answer::new(vec![
        ("label", Value::Document(piece.labels().swap_remove(place))),
        ("change", change.equation()?.into()),
        ("largest", largest(&basis, place, by.map(Vec::as_slice))),
    ]))
}

pub(super) fn roots(arguments: &Arguments) -> Result<Answer, Error> {
    let mut segment = arguments.segment()?;
    if let Ok(plane) = arguments.map("plane") {
        segment = segment.transform(plane)?;
        if segment.coordinates().iter().all(Zero::is_zero) {
            return Err(Error::Unsupported("the whole curve lies in the line or plane".into()));
        }
    }
    if segment.dimension() != 1 {
        return Err(Error::WrongShape(format!(
            "roots are those of one number: give numbers as control points, or a line or plane (found {} coordinates)",
            segment.dimension()
        )));
    }
    let signs: Vec<_> = segment.coordinates().iter().map(Rational::numer).collect();
    let variations = sign_variations(signs.iter());
    let curve = segment.curve()?;
    let coefficients: Vec<_> = curve.coordinate(0).cloned().collect();
    let roots = RealRoots::inside(&coefficients, segment.frame())?;
    let mut fields = vec![
        ("sign_variations", Value::Count(variations)),
        ("distinct_roots_open", Value::Count(roots.distinct())),
        ("roots_with_multiplicity_open", Value::Count(roots.with_multiplicity())),
    ];
    if arguments.flag("isolate") {
        let isolated = match arguments.number("width") {
            Ok(width) if width.is_positive() && width.bits() <= MAX_WIDTH_BITS => roots.isolated_within(width),
            Ok(_) => return Err(Error::WrongShape(format!("a width must be positive, with at most {MAX_WIDTH_BITS} bits"))),
            Err(_) => roots.isolated(),
        };
        fields.push(("roots", Value::List(isolated.into_iter().map(root).collect())));
    }
    Ok(Answer::new(fields))
}

fn root(root: Root) -> Value {
    let place = match root.place {
        RootPlace::Exact(value) => ("t", Value::Number(value)),
        RootPlace::Between(low, high) => ("between", Value::Numbers(vec![low, high])),
    };
    Value::Record(vec![place, ("multiplicity", Value::Count(root.multiplicity))])
}
