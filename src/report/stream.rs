//! Answers as JSON text, without the tree of values in between, for streams of many.

use std::fmt::{Display, Write};

use super::json::encode;
use crate::error::Error;
use crate::exact::Surd;
use crate::kernel::coefficient::Coefficient;
use crate::value::{Answer, Value};

/// The text of the `output` of a `batch` answer: what [`json::output`](super::json::output) prints.
///
/// # Errors
/// As for [`json::output`](super::json::output).
pub fn output_text<C: Coefficient>(answer: &Answer<C>) -> Result<String, Error> {
    let mut text = String::with_capacity(1024);
    if answer.weighted {
        return Ok(super::json::output(answer)?.to_string());
    }
    record(&answer.fields, &mut text)?;
    Ok(text)
}

fn record<C: Coefficient>(fields: &[(&'static str, Value<C>)], text: &mut String) -> Result<(), Error> {
    text.push('{');
    for (index, (name, value)) in fields.iter().enumerate() {
        text.push_str(if index > 0 { ",\"" } else { "\"" });
        text.push_str(name);
        text.push_str("\":");
        write(value, text)?;
    }
    text.push('}');
    Ok(())
}

fn list<T>(items: &[T], text: &mut String, mut item: impl FnMut(&T, &mut String) -> Result<(), Error>) -> Result<(), Error> {
    text.push('[');
    for (index, value) in items.iter().enumerate() {
        if index > 0 {
            text.push(',');
        }
        item(value, text)?;
    }
    text.push(']');
    Ok(())
}

/// A number as a string.
fn number<C: Display>(number: &C, text: &mut String) -> Result<(), Error> {
    // Writing to a string does not fail.
    let _ = write!(text, "\"{number}\"");
    Ok(())
}

fn surd(surd: &Surd, text: &mut String) -> Result<(), Error> {
    let _ = write!(text, "{{\"a\":\"{}\",\"sgn\":{},\"rad\":\"{}\"}}", surd.rational(), surd.sign(), surd.radicand());
    Ok(())
}

fn write<C: Coefficient>(value: &Value<C>, text: &mut String) -> Result<(), Error> {
    match value {
        Value::Number(value) => number(value, text),
        Value::Numbers(values) | Value::Point(values) => list(values, text, number),
        Value::Points(points) => list(points, text, |point, text| list(point, text, number)),
        Value::Surd(value) => surd(value, text),
        Value::Surds(values) => list(values, text, surd),
        Value::List(values) => list(values, text, write),
        Value::Record(fields) => record(fields, text),
        other => {
            let _ = write!(text, "{}", encode(other, false)?);
            Ok(())
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::exact::Rational;

    #[test]
    fn the_text_is_that_of_the_tree() {
        let root = Surd::root(&Rational::new(2, 3)).unwrap_or_default();
        let q = Rational::new(-7, 3);
        let answer: Answer = Answer::new(vec![
            ("number", Value::Number(q.clone())),
            ("list", Value::List(vec![Value::Count(3), Value::Word("κ \"quoted\""), Value::Nothing, Value::Truth(true)])),
            ("record", Value::Record(vec![("empty", Value::Numbers(vec![])), ("point", Value::Point(vec![q.clone(), q]))])),
            ("surds", Value::Surds(vec![root.clone(), -&root])),
            ("points", Value::Points(vec![vec![Rational::from(1)], vec![]])),
        ]);
        assert_eq!(output_text(&answer), super::super::json::output(&answer).map(|json| json.to_string()));
    }
}
