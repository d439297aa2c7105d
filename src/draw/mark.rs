//! Dots with names.

use super::bezier::{Point, distance};
use super::label::Label;
use super::number::{equation, lowered, raised, tuple};
use super::style;
use super::svg::{Stroke, Svg};
use crate::exact::Rational;
use crate::scheme::polar_label;

/// Points closer than this are one dot, in pixels.
const SAME: f64 = 2.0;
/// The longest label that says the coordinates too.
const LONGEST: usize = 26;
/// The largest degree whose polar labels list all arguments.
const MAX_LISTED: usize = 4;
/// The largest degree with polar labels.
const MAX_POLAR: usize = 8;
/// The largest degree whose control points all have names.
const MAX_NAMED: usize = 16;

/// What a dot is.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Rank {
    Control,
    /// A point of this step of de Casteljau's algorithm, of this many.
    Step(usize, usize),
    Point,
    /// A flex, a cusp, a crossing: a point that the curve has by itself.
    Feature,
    /// A point beside the curve that belongs to it all the same.
    Isolated,
}

/// A dot and what it is called.
#[derive(Clone, Debug)]
pub(super) struct Mark {
    pub(super) at: Point,
    pub(super) rank: Rank,
    /// Nothing for a dot without a label.
    pub(super) name: String,
    /// The coordinates, which the label says if there is room and the tip says always.
    pub(super) value: Vec<Rational>,
    /// Whether the label should say the coordinates.
    pub(super) told: bool,
    pub(super) outward: Point,
}

/// The name of `f(r^… s^… t^…)`, or of the control point where that would be long.
pub(super) fn polar_name(arguments: &[(&str, usize)]) -> String {
    let degree: usize = arguments.iter().map(|&(_, count)| count).sum();
    if degree <= MAX_LISTED {
        return polar_label(arguments);
    }
    let power = |&(letter, count): &(&str, usize)| match count {
        0 => String::new(),
        1 => letter.to_owned(),
        _ => format!("{letter}{}", raised(&count.to_string())),
    };
    format!("f({})", arguments.iter().map(power).collect::<String>())
}

/// The name of a control point; empty where there are too many to name them all.
pub(super) fn control_name(degree: usize, index: usize) -> String {
    match degree {
        0..=MAX_POLAR => polar_name(&[("r", degree - index), ("s", index)]),
        _ if degree <= MAX_NAMED || index == 0 || index == degree => format!("b{}", lowered(&index.to_string())),
        _ => String::new(),
    }
}

impl Mark {
    fn radius(&self) -> f64 {
        match self.rank {
            Rank::Control => 4.0,
            Rank::Step(..) => 3.3,
            Rank::Point => 6.0,
            Rank::Feature => 5.0,
            Rank::Isolated => 4.2,
        }
    }

    fn colour(&self) -> String {
        match self.rank {
            Rank::Control => style::CONTROL.into(),
            Rank::Step(step, steps) => style::step_colour(step, steps),
            Rank::Point => style::POINT.into(),
            Rank::Feature | Rank::Isolated => style::FEATURE.into(),
        }
    }

    fn told(&self) -> String {
        equation(&self.name, &tuple(&self.value))
    }
}

/// Draws the dots, the most important ones on top, small ones if there are many.
pub(super) fn draw_dots(svg: &mut Svg, marks: &[Mark]) {
    let shrink = if marks.len() > 40 { 0.6 } else { 1.0 };
    let mut sorted: Vec<&Mark> = marks.iter().collect();
    sorted.sort_by_key(|mark| match mark.rank {
        Rank::Step(step, _) => (0, step),
        Rank::Control => (1, 0),
        Rank::Feature | Rank::Isolated => (2, 0),
        Rank::Point => (3, 0),
    });
    svg.open("points");
    for mark in sorted {
        let tip = if mark.name.is_empty() || mark.value.is_empty() { mark.name.clone() } else { mark.told() };
        let colour = mark.colour();
        let (fill, outline) = match mark.rank {
            Rank::Isolated => ("#ffffff", Stroke::solid(&colour, 1.8)),
            Rank::Control | Rank::Step(..) | Rank::Point | Rank::Feature => (colour.as_str(), Stroke::solid("#ffffff", 1.2)),
        };
        svg.dot(mark.at, mark.radius() * shrink, fill, outline, &tip);
    }
    svg.close();
}

/// The labels, one for all the dots of a kind at one place.
pub(super) fn labels(marks: &[Mark]) -> Vec<Label> {
    let mut groups: Vec<Vec<&Mark>> = Vec::new();
    let order = |mark: &&Mark| match mark.rank {
        Rank::Point => 0,
        Rank::Control => 1,
        Rank::Feature | Rank::Isolated => 2,
        Rank::Step(..) => 3,
    };
    let mut named: Vec<&Mark> = marks.iter().filter(|mark| !mark.name.is_empty()).collect();
    named.sort_by_key(order);
    for mark in named {
        let beside = |group: &[&Mark]| group.first().is_some_and(|first| distance(first.at, mark.at) < SAME);
        let alike = |group: &[&Mark]| group.first().is_some_and(|first| order(first) == order(&mark));
        // An intermediate point that coincides with a control point needs no name of its own.
        if matches!(mark.rank, Rank::Step(..)) && groups.iter().any(|group| beside(group) && !alike(group)) {
            continue;
        }
        match groups.iter_mut().find(|group| beside(group) && alike(group)) {
            Some(group) => group.push(mark),
            None => groups.push(vec![mark]),
        }
    }
    groups.iter().filter_map(|group| label(group)).collect()
}

fn label(group: &[&Mark]) -> Option<Label> {
    let (first, last) = (*group.first()?, *group.last()?);
    let outward = group.iter().fold([0.0, 0.0], |sum, mark| [sum[0] + mark.outward[0], sum[1] + mark.outward[1]]);
    let is_step = matches!(first.rank, Rank::Step(..));
    let value = if first.told { equation("", &tuple(&first.value)).trim_start().to_owned() } else { String::new() };
    let mut lines = Vec::new();
    let is_feature = matches!(first.rank, Rank::Feature | Rank::Isolated);
    if !is_feature && group.iter().all(|mark| mark.value == first.value) {
        let names = match group {
            [only] => only.name.clone(),
            [one, two] => format!("{} = {}", one.name, two.name),
            _ => format!("{} = … = {}", first.name, last.name),
        };
        let whole = format!("{names} {value}");
        if value.is_empty() {
            lines.push(names);
        } else if whole.chars().count() <= LONGEST || first.rank == Rank::Point {
            lines.push(whole);
        } else if value.chars().count() <= LONGEST {
            lines.extend([names, value]);
        } else {
            lines.push(names);
        }
    } else {
        // Different points that are seen at one place.
        lines.extend(group.iter().take(3).map(|mark| mark.name.clone()));
        if group.len() > 3 {
            lines.push("…".into());
        }
    }
    Some(Label {
        lines,
        at: first.at,
        radius: first.radius(),
        size: if is_step { style::SMALL_SIZE } else { style::LABEL_SIZE },
        colour: first.colour(),
        bold: first.rank == Rank::Point,
        outward,
        optional: is_step,
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn mark(x: f64, rank: Rank, name: &str, value: i64) -> Mark {
        Mark { at: [x, 0.0], rank, name: name.into(), value: vec![Rational::from(value)], told: true, outward: [0.0, 1.0] }
    }

    #[test]
    fn names() {
        assert_eq!(control_name(3, 1), "f(r,r,s)");
        assert_eq!(control_name(7, 2), "f(r⁵s²)");
        assert_eq!(control_name(0, 0), "f()");
        assert_eq!(control_name(12, 10), "b₁₀");
        assert_eq!([control_name(100, 100), control_name(100, 3)], ["b₁₀₀", ""]);
    }

    #[test]
    fn coinciding_points_share_a_label() {
        let marks = [mark(0.0, Rank::Control, "f(r)", 5), mark(30.0, Rank::Control, "a", 1), mark(0.5, Rank::Control, "f(s)", 5)];
        let lines: Vec<Vec<String>> = labels(&marks).into_iter().map(|label| label.lines).collect();
        assert_eq!(lines, [["f(r) = f(s) = 5"], ["a = 1"]]);
        let marks = [mark(0.0, Rank::Control, "a", 5), mark(0.5, Rank::Control, "b", 6), mark(0.0, Rank::Step(1, 3), "c", 5)];
        let lines: Vec<Vec<String>> = labels(&marks).into_iter().map(|label| label.lines).collect();
        assert_eq!(lines, [["a", "b"]]);
    }
}
