//! Names of findings that survive changes elsewhere in their file.

use std::fmt::Write as _;
use std::hash::Hasher as _;

use fnv::FnvHasher;

use super::rules::rule_of;
use crate::audit::Join;
use crate::exact::Rational;

fn written(text: &mut String, points: &[Vec<Rational>], backward: bool) {
    let mut one = |point: &Vec<Rational>| {
        for number in point {
            // Writing to a string does not fail.
            let _ = write!(text, "{number} ");
        }
        text.push(',');
    };
    if backward {
        points.iter().rev().for_each(&mut one)
    } else {
        points.iter().for_each(&mut one)
    }
    text.push(';');
}

/// The fingerprint of a finding: made of its rule and of the control points at
/// the joint and behind it alone. It does not change when pieces change their
/// order or direction, when lines move, or when anything else is edited.
#[must_use]
pub fn fingerprint(join: &Join) -> String {
    let variant = |exchanged: bool, backward: bool| {
        let mut text = String::new();
        written(&mut text, &join.points, backward);
        let [a, b] = &join.handles;
        let (first, second) = if exchanged { (b, a) } else { (a, b) };
        written(&mut text, first, backward);
        written(&mut text, second, backward);
        text
    };
    let variants = [(false, false), (false, true), (true, false), (true, true)];
    let least = variants.map(|(exchanged, backward)| variant(exchanged, backward)).into_iter().min().unwrap_or_default();
    let mut hasher = FnvHasher::default();
    hasher.write(rule_of(join).map_or("", |rule| rule.code).as_bytes());
    hasher.write(least.as_bytes());
    format!("{:016x}", hasher.finish())
}
