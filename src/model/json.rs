//! Exact values in JSON.
//!
//! A number is a string (`"7/3"`, `"0.25"`) or a JSON number, and is never
//! seen as a float: values are taken as raw text and read by the exact parser.

use std::collections::HashSet;

use serde::de::{DeserializeOwned, MapAccess, Visitor};
use serde::{Deserialize, Deserializer};
use serde_json::value::RawValue;

use super::decimals::Decimals;
use crate::error::Error;
use crate::exact::Rational;
use crate::syntax::limits::MAX_DEGREE;

/// What is wrong with a JSON value, with the stable code of `batch` answers.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Fault {
    /// The code.
    pub code: &'static str,
    /// What was found and what was expected.
    pub message: String,
}

impl Fault {
    /// A fault with this code.
    #[must_use]
    pub fn new(code: &'static str, message: impl Into<String>) -> Self {
        Self { code, message: message.into() }
    }
}

impl From<Error> for Fault {
    fn from(error: Error) -> Self {
        Self { code: error.code(), message: error.to_string() }
    }
}

/// An object's members in order, as raw text.
#[derive(Debug)]
pub struct Fields<'a> {
    members: Vec<(String, &'a RawValue)>,
}

impl<'a> Fields<'a> {
    /// The members of an object.
    ///
    /// # Errors
    /// `wrong-shape` if it is not an object or names a member twice.
    pub fn of(raw: &'a RawValue, what: &str) -> Result<Self, Fault> {
        let Members(members) = serde_json::from_str(raw.get())
            .map_err(|_| Fault::new("wrong-shape", format!("{what} must be an object, found {}", excerpt(raw.get()))))?;
        let mut seen = HashSet::with_capacity(members.len());
        if let Some((name, _)) = members.iter().find(|(name, _)| !seen.insert(name)) {
            return Err(Fault::new("wrong-shape", format!("{what} has `{}` twice", excerpt(name))));
        }
        Ok(Self { members })
    }

    /// The member with a name.
    #[must_use]
    pub fn get(&self, name: &str) -> Option<&'a RawValue> {
        self.members.iter().find(|(key, _)| key == name).map(|(_, value)| *value)
    }

    /// The member with a name.
    ///
    /// # Errors
    /// `missing-field` if there is none.
    pub fn require(&self, name: &str, what: &str) -> Result<&'a RawValue, Fault> {
        self.get(name).ok_or_else(|| Fault::new("missing-field", format!("{what} needs `{name}`")))
    }

    /// Refuses members with other names than these.
    ///
    /// # Errors
    /// `unknown-field`, with the names there are.
    pub fn only(&self, known: &[&str], what: &str) -> Result<(), Fault> {
        match self.members.iter().find(|(name, _)| !known.contains(&name.as_str())) {
            None => Ok(()),
            Some((name, _)) => {
                Err(Fault::new("unknown-field", format!("{what} has no `{}`; known are {}", excerpt(name), known.join(", "))))
            }
        }
    }
}

/// The members of an object, repeated names included, which a map would drop.
struct Members<'a>(Vec<(String, &'a RawValue)>);

impl<'de: 'a, 'a> Deserialize<'de> for Members<'a> {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct Collect;
        impl<'de> Visitor<'de> for Collect {
            type Value = Members<'de>;
            fn expecting(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
                f.write_str("an object")
            }
            fn visit_map<A: MapAccess<'de>>(self, mut map: A) -> Result<Self::Value, A::Error> {
                let mut members = Vec::new();
                while let Some(name) = map.next_key()? {
                    members.push((name, map.next_value()?));
                }
                Ok(Members(members))
            }
        }
        deserializer.deserialize_map(Collect)
    }
}

/// The beginning of a text, for messages.
pub(crate) fn excerpt(text: &str) -> String {
    const LENGTH: usize = 60;
    match text.char_indices().nth(LENGTH) {
        Some((end, _)) => format!("{}…", &text[..end]),
        None => text.to_owned(),
    }
}

/// The items of a list.
///
/// # Errors
/// `wrong-shape` if it is something else.
pub(crate) fn list<'a>(raw: &'a RawValue, what: &str) -> Result<Vec<&'a RawValue>, Fault> {
    serde_json::from_str(raw.get()).map_err(|_| Fault::new("wrong-shape", format!("{what} must be a list, found {}", excerpt(raw.get()))))
}

/// A value of a plain type, such as a count.
///
/// # Errors
/// `wrong-shape` if it is something else.
pub(crate) fn plain<T: DeserializeOwned>(raw: &RawValue, what: &str) -> Result<T, Fault> {
    serde_json::from_str(raw.get()).map_err(|_| Fault::new("wrong-shape", format!("expected {what}, found {}", excerpt(raw.get()))))
}

/// A degree or another small whole number.
///
/// # Errors
/// `too-large` above the limit of degrees, `wrong-shape` if it is no whole number.
pub(crate) fn count(raw: &RawValue, what: &str) -> Result<usize, Fault> {
    let text = raw.get();
    let too_large = || Fault::new("too-large", format!("{what} is at most {MAX_DEGREE}, found {}", excerpt(text)));
    if !text.is_empty() && text.bytes().all(|byte| byte.is_ascii_digit()) {
        return text.parse().ok().filter(|&count| count <= MAX_DEGREE as usize).ok_or_else(too_large);
    }
    Err(Fault::new("wrong-shape", format!("{what} must be a whole number from 0 on, found {}", excerpt(text))))
}

/// A number, exactly.
///
/// # Errors
/// `bad-number`, `too-large` beyond the limits of digits, `wrong-shape` if it is
/// neither a string nor a number.
pub fn number(raw: &RawValue, decimals: &mut Decimals) -> Result<Rational, Fault> {
    let text = raw.get();
    let parsed = match text.as_bytes().first() {
        Some(b'"') => decimals.read(&plain::<String>(raw, "a number")?),
        Some(b'-' | b'0'..=b'9') => decimals.read(text),
        _ => return Err(Fault::new("wrong-shape", format!("expected a number, found {}", excerpt(text)))),
    };
    parsed.map_err(|error| {
        let code = if error == crate::exact::ParseNumberError::TooLong { "too-large" } else { "bad-number" };
        Fault::new(code, format!("found {}: {error}", excerpt(text)))
    })
}

/// A list of numbers.
///
/// # Errors
/// As for [`number`], and `wrong-shape` if it is no list.
pub fn numbers(raw: &RawValue, what: &str, decimals: &mut Decimals) -> Result<Vec<Rational>, Fault> {
    list(raw, what)?.into_iter().map(|item| number(item, decimals)).collect()
}

/// A list of points; a number is a point of the line.
///
/// # Errors
/// As for [`numbers`], `wrong-count` for points of different dimensions,
/// `too-large` for more points than the limit of degrees allows.
pub fn points(raw: &RawValue, decimals: &mut Decimals) -> Result<Vec<Vec<Rational>>, Fault> {
    points_up_to(raw, MAX_POINTS, decimals)
}

/// A list of points with a limit of its own.
///
/// # Errors
/// As for [`points`].
pub(crate) fn points_up_to(raw: &RawValue, most: usize, decimals: &mut Decimals) -> Result<Vec<Vec<Rational>>, Fault> {
    let points = list_of_points(raw, "points", most, decimals)?;
    check_dimensions(points.iter())?;
    Ok(points)
}

fn list_of_points(raw: &RawValue, what: &str, most: usize, decimals: &mut Decimals) -> Result<Vec<Vec<Rational>>, Fault> {
    let items = list(raw, what)?;
    if items.len() > most {
        return Err(Fault::new("too-large", format!("at most {most} points, found {}", items.len())));
    }
    let point = |item: &RawValue| {
        if item.get().starts_with('[') { numbers(item, "a point", decimals) } else { Ok(vec![number(item, decimals)?]) }
    };
    items.into_iter().map(point).collect()
}

/// Rows of points.
///
/// # Errors
/// As for [`points`].
pub fn rows(raw: &RawValue, decimals: &mut Decimals) -> Result<Vec<Vec<Vec<Rational>>>, Fault> {
    let items = list(raw, "rows of points")?;
    if items.len() > MAX_POINTS {
        return Err(Fault::new("too-large", format!("at most {MAX_POINTS} rows of points, found {}", items.len())));
    }
    let rows: Vec<Vec<Vec<Rational>>> = items
        .into_iter()
        .enumerate()
        .map(|(index, row)| list_of_points(row, &format!("row {index}"), MAX_POINTS, decimals))
        .collect::<Result<_, _>>()?;
    check_dimensions(rows.iter().flatten())?;
    Ok(rows)
}

/// The most points of a curve, and of a row of a patch.
const MAX_POINTS: usize = MAX_DEGREE as usize + 1;

fn check_dimensions<'p>(points: impl Iterator<Item = &'p Vec<Rational>> + Clone) -> Result<(), Fault> {
    let dimension = points.clone().next().map_or(0, Vec::len);
    if dimension == 0 {
        return Err(Fault::new("wrong-shape", "expected at least one point with at least one coordinate"));
    }
    match points.clone().enumerate().find(|(_, point)| point.len() != dimension) {
        Some((odd, point)) => {
            Err(Fault::new("wrong-count", format!("point {odd} has {} coordinates, point 0 has {dimension}", point.len())))
        }
        None => Ok(()),
    }
}

/// How deep lists are nested at the beginning of a value.
pub(crate) fn depth(raw: &RawValue) -> usize {
    raw.get().bytes().filter(|byte| !byte.is_ascii_whitespace()).take_while(|&byte| byte == b'[').count()
}

/// What `serde_json` says, without the line and column behind it.
pub(crate) fn without_place(error: &serde_json::Error) -> String {
    let message = error.to_string();
    match message.rfind(" at line ") {
        Some(end) => message[..end].to_owned(),
        None => message,
    }
}
