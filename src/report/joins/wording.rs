//! Joins in words.

use num_traits::Zero;

use super::Examined;
use crate::audit::{Contact, Join, Rounding, Verdict};
use crate::continuity::Continuity;
use crate::exact::Rational;

/// A number with three significant digits, for readers.
fn near(value: f64) -> String {
    if value == 0.0 {
        return "0".into();
    }
    let digits = (2 - value.abs().log10().floor() as i32).clamp(0, 12) as usize;
    if value.abs() < 1e-9 { format!("{value:.2e}") } else { trimmed(&format!("{value:.digits$}")) }
}

fn trimmed(text: &str) -> String {
    if text.contains('.') { text.trim_end_matches('0').trim_end_matches('.').to_owned() } else { text.to_owned() }
}

/// The angle that a squared sine belongs to, in degrees, marked as approximate.
pub(super) fn angle(sin2: &Rational, obtuse: bool) -> String {
    let acute = sin2.approximate().clamp(0.0, 1.0).sqrt().asin().to_degrees();
    if sin2.is_zero() {
        return if obtuse { "180°".into() } else { "0°".into() };
    }
    format!("≈ {}°", near(if obtuse { 180.0 - acute } else { acute }))
}

/// A length of which the square is known.
pub(super) fn length(squared: &Rational) -> String {
    format!("≈ {}", near(squared.approximate().max(0.0).sqrt()))
}

/// A point as text.
pub(super) fn point(coordinates: &[Rational]) -> String {
    let numbers: Vec<String> = coordinates.iter().map(decimal).collect();
    if numbers.len() == 1 { numbers[0].clone() } else { format!("({})", numbers.join(", ")) }
}

/// A number as a file prints it: as a decimal where it is one, else as a fraction.
fn decimal(number: &Rational) -> String {
    for places in 0..=12 {
        let text = crate::report::decimal(number, places);
        if text.parse::<Rational>().is_ok_and(|read| read == *number) {
            return text;
        }
    }
    number.to_string()
}

/// What was found, in a sentence.
pub(super) fn finding(join: &Join) -> String {
    let curves = join.first.1.is_end();
    let (these, tangents) = if curves { ("the curves", "tangents") } else { ("the patches", "tangent planes") };
    match (join.verdict, join.parametric, join.contact) {
        (Verdict::Exact, ..) => "as required".into(),
        (Verdict::Within, ..) => "within the tolerance".into(),
        (Verdict::Degenerate, _, Contact::ZeroHandle) => "a handle is zero: there is no tangent".into(),
        (Verdict::Degenerate, _, Contact::SingularPoints) => "the tangent planes agree, and a normal vanishes at single points".into(),
        (Verdict::Degenerate, ..) => "there is no tangent plane along the edge".into(),
        (_, Continuity::Broken, _) => format!("{these} do not meet"),
        (_, _, Contact::Fold) => format!("{these} turn back on themselves"),
        (_, _, Contact::Kink) => {
            let most = join.sin2.as_ref().map(|[low, high]| angle(if join.obtuse { low } else { high }, join.obtuse));
            let up_to = if curves { "" } else { "up to " };
            most.map_or_else(|| format!("the {tangents} differ"), |angle| format!("the {tangents} differ by {up_to}{angle}"))
        }
        (_, Continuity::C(0), _) => {
            let ratio = join.ratio.as_ref().map_or_else(String::new, |ratio| format!(" (ratio {ratio})"));
            format!("the {tangents} agree and the first derivatives do not{ratio}")
        }
        (_, Continuity::C(1), _) if join.geometric == Some(1) && curves => "the second derivatives and the curvatures differ".into(),
        _ => "the second derivatives differ".into(),
    }
}

/// What was asked for and why.
pub(super) fn demand(examined: &Examined, join: &Join) -> String {
    let Some(requirement) = join.requirement else { return String::new() };
    let promised = examined.stated(join).is_some_and(|joint| joint.smooth);
    if promised && requirement == crate::audit::Requirement::G1 {
        format!("{requirement} is promised: the node is flagged smooth")
    } else {
        format!("{requirement} is required")
    }
}

/// How far it is off and what would mend it.
pub(super) fn remedy(join: &Join) -> Option<String> {
    if join.verdict != Verdict::Violated || join.contact != Contact::Kink {
        return None;
    }
    let curves = join.first.1.is_end();
    let mut parts = Vec::new();
    if let ([joint], [[a], [b]]) = (join.points.as_slice(), join.handles.each_ref().map(Vec::as_slice)) {
        let tip = |handle: &[Rational]| point(&joint.iter().zip(handle).map(|(x, y)| x + y).collect::<Vec<_>>());
        parts.push(format!("the handles end at {} and {}", tip(a), tip(b)));
    }
    if let Some(offset2) = &join.offset2 {
        let what = if curves { "one handle moved by" } else { "one row of control points, each moved by up to" };
        parts.push(format!("{what} {} makes it smooth", length(offset2)));
    }
    match join.rounding {
        Rounding::Yes => parts.push("half a unit of the last printed digit explains it".into()),
        Rounding::No => parts.push("half a unit of the last printed digit does not explain it".into()),
        Rounding::Unknown => {}
    }
    (!parts.is_empty()).then(|| parts.join("; "))
}

/// Where it is: the node of an outline, or pieces and their sides.
pub(super) fn location(examined: &Examined, join: &Join) -> String {
    if let Some(joint) = examined.stated(join) {
        let at = join.points.first().map_or_else(String::new, |coordinates| format!(" at {}", point(coordinates)));
        return format!("contour {}, node {}{at}", joint.contour, joint.node);
    }
    let name = |(index, side): (usize, crate::side::Side)| {
        let part = &examined.model.parts[index];
        match &part.name {
            Some(name) => format!("piece {index} \"{}\", {side}", crate::model::excerpt(name)),
            None => format!("piece {index}, {side}"),
        }
    };
    let run = match (join.points.first(), join.points.last()) {
        (Some(first), Some(last)) if join.points.len() > 1 => format!(": from {} to {}", point(first), point(last)),
        (Some(first), _) => format!(": at {}", point(first)),
        _ => String::new(),
    };
    let reversed = if join.reversed { ", reversed" } else { "" };
    format!("{} and {}{reversed}{run}", name(join.first), name(join.second))
}
