//! Operations on numbers and on polynomials in one variable.

use num_traits::{Signed, Zero};

use crate::bernstein::Bernstein;
use crate::blossom;
use crate::error::Error;
use crate::exact::Rational;
use crate::kernel::coefficient::Coefficient;
use crate::roots::{RealRoots, Root, RootPlace, sign_variations};
use crate::value::{Answer, Arguments, Value};

/// The most bits of the width of an isolating interval.
const MAX_WIDTH_BITS: u64 = 1024;

pub(super) fn sigma<C: Coefficient>(arguments: &Arguments<C>) -> Result<Answer<C>, Error> {
    Ok(Answer::new(vec![("values", Value::Numbers(blossom::sigma(arguments.numbers("values")?)))]))
}

pub(super) fn contains(arguments: &Arguments) -> Result<Answer, Error> {
    let inside = arguments.frame("frame")?.contains(arguments.number("t")?);
    Ok(Answer::new(vec![("inside", Value::Truth(inside))]).that_holds(inside))
}

pub(super) fn bernstein(arguments: &Arguments) -> Result<Answer, Error> {
    let basis = Bernstein::new(*arguments.count("degree")?, arguments.frame_or_unit("frame"));
    let all = match arguments.count("index") {
        Ok(&index) => index..=index,
        Err(_) => 0..=basis.degree(),
    };
    let values = arguments.number("t").ok().map(|t| basis.values(t));
    let mut polynomials = Vec::new();
    for index in all {
        let mut record = vec![("index", Value::Count(index)), ("polynomial", Value::Curve(basis.polynomial(index)?))];
        record.push((
            "maximum",
            match basis.maximum(index) {
                Some((t, value)) => Value::Record(vec![("t", Value::Number(t)), ("value", Value::Number(value))]),
                None => Value::Nothing,
            },
        ));
        if let Some(value) = values.as_ref().and_then(|values| values.get(index)) {
            record.push(("value", Value::Number(value.clone())));
        }
        polynomials.push(Value::Record(record));
    }
    Ok(Answer::new(vec![("frame", Value::Frame(basis.frame().clone())), ("polynomials", Value::List(polynomials))]))
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
