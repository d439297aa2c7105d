//! Glyphs of Unified Font Objects (*UFO 3 specification*, "GLIF").

use super::outline::{Node, Outline, Point};
use super::xml::{Element, Tag, Tags};
use super::{Decimals, Flaw, Format, Model, Place, shown};
use crate::exact::Rational;

/// A point of a contour as it stands in the file.
struct Entry {
    node: Node,
    kind: Kind,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Kind {
    Move,
    Line,
    Curve,
    Quadratic,
    Off,
}

/// Reads the contours of a glyph: cubic ones, and quadratic ones with points of
/// the curve implied half-way between control points. Components have no
/// outline of their own and are passed over.
pub(super) fn read(text: &str) -> Result<Model, Flaw> {
    let mut tags = Tags::new(text);
    let mut outline = Outline::default();
    let mut decimals = Decimals::default();
    let mut contour: Option<Vec<Entry>> = None;
    while let Some(tag) = tags.next()? {
        match tag {
            Tag::Start(element) if element.depth == 0 && element.name() != "glyph" => {
                return Err(Flaw::expected(tags.place(element.at), &format!("<{}>", element.name()), "a <glyph> document"));
            }
            Tag::Start(element) => match (element.name(), &mut contour) {
                ("contour", _) => contour = Some(Vec::new()),
                ("point", Some(entries)) => {
                    let entry = entry(&element, entries.len(), &mut tags, &mut decimals)?;
                    entries.push(entry);
                }
                _ => {}
            },
            Tag::End(name) if name == "contour" => draw(&contour.take().unwrap_or_default(), &mut outline)?,
            Tag::End(_) => {}
        }
    }
    Ok(outline.into_model(Format::Glif, decimals.finest()))
}

fn entry(element: &Element, index: usize, tags: &mut Tags, decimals: &mut Decimals) -> Result<Entry, Flaw> {
    let place = tags.place(element.at);
    let mut coordinate = |name: &str| {
        let Some(attribute) = element.attribute(name, tags.places())? else {
            return Err(Flaw::at(place, format!("the point has no `{name}`")));
        };
        decimals
            .read(attribute.value.trim())
            .map_err(|error| Flaw::at(place, format!("found {} as `{name}`: {error}", shown(&attribute.value))))
    };
    let point = [coordinate("x")?, coordinate("y")?];
    let kind = match element.attribute("type", tags.places())?.as_ref().map(|attribute| &*attribute.value) {
        Some("move") if index == 0 => Kind::Move,
        Some("move") => return Err(Flaw::at(place, "found a point of type `move` behind others, expected it first in its contour")),
        Some("line") => Kind::Line,
        Some("curve") => Kind::Curve,
        Some("qcurve") => Kind::Quadratic,
        Some("offcurve") | None => Kind::Off,
        Some(other) => {
            return Err(Flaw::expected(place, other, "the type of a point: move, line, curve, qcurve or offcurve"));
        }
    };
    let smooth = element.attribute("smooth", tags.places())?.is_some_and(|attribute| attribute.value == "yes");
    Ok(Entry { node: Node { point, index, place, smooth }, kind })
}

/// Adds a contour to an outline.
fn draw(entries: &[Entry], outline: &mut Outline) -> Result<(), Flaw> {
    let Some(start) = entries.iter().position(|entry| entry.kind != Kind::Off) else {
        return draw_implied(entries, outline);
    };
    outline.begin(entries[start].node.clone());
    let closed = entries[start].kind != Kind::Move;
    // A closed contour runs around to its first point of the curve again.
    let around = if closed { &entries[..=start] } else { &[] };
    let mut off: Vec<&Entry> = Vec::new();
    for entry in entries[start + 1..].iter().chain(around) {
        match entry.kind {
            Kind::Off => off.push(entry),
            _ => segment(&std::mem::take(&mut off), entry, closed && entry.node.index == start, outline)?,
        }
    }
    if let Some(entry) = off.first() {
        return Err(Flaw::at(
            entry.node.place,
            "found a control point at the end of an open contour, expected a point of the curve behind it",
        ));
    }
    if closed {
        outline.close(entries[start].node.place)?;
    }
    outline.end();
    Ok(())
}

/// A contour of control points only: quadratics between implied points.
fn draw_implied(entries: &[Entry], outline: &mut Outline) -> Result<(), Flaw> {
    let [.., last] = entries else { return Ok(()) };
    let Some(first) = entries.first().filter(|_| entries.len() > 1) else { return Ok(()) };
    let start = between(last, first);
    outline.begin(start.clone());
    let off: Vec<&Entry> = entries.iter().collect();
    quadratics(&off, start, outline)?;
    outline.close(first.node.place)
}

/// The curve from the point before to this one.
fn segment(off: &[&Entry], end: &Entry, closing: bool, outline: &mut Outline) -> Result<(), Flaw> {
    let place = off.first().map_or(end.node.place, |entry| entry.node.place);
    let control = |index: usize| off[index].node.point.clone();
    let node = end.node.clone();
    match (end.kind, off.len()) {
        // A contour that has come back already needs no line to close it.
        (_, 0) if closing && outline.here().is_some_and(|here| here.point == node.point) => Ok(()),
        (_, 0) => outline.curve([], node, place),
        (Kind::Curve, 1) => outline.curve([control(0)], node, place),
        (Kind::Curve, 2) => outline.curve([control(0), control(1)], node, place),
        (Kind::Quadratic, _) => quadratics(off, node, outline),
        (Kind::Curve, count) => Err(Flaw::at(place, format!("found {count} control points of a curve, expected at most 2"))),
        _ => Err(Flaw::at(place, "found a control point before a line, expected a point of the curve")),
    }
}

/// Quadratics with these control points and points implied between them.
fn quadratics(off: &[&Entry], end: Node, outline: &mut Outline) -> Result<(), Flaw> {
    for pair in off.windows(2) {
        outline.curve([pair[0].node.point.clone()], between(pair[0], pair[1]), pair[0].node.place)?;
    }
    match off {
        [.., last] => outline.curve([last.node.point.clone()], end, last.node.place),
        [] => Ok(()),
    }
}

/// The implied point half-way between two control points. It has no index and
/// no place but those of the first.
fn between(first: &Entry, second: &Entry) -> Node {
    let half = Rational::new(1, 2);
    let point: Point = [0, 1].map(|axis| (&first.node.point[axis] + &second.node.point[axis]) * &half);
    let place: Place = first.node.place;
    Node { point, index: first.node.index, place, smooth: false }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn of_points(points: &[(&str, &str)]) -> String {
        let point = |(at, rest): &(&str, &str)| {
            let (x, y) = at.split_once(' ').expect("two coordinates");
            format!("<point x=\"{x}\" y=\"{y}\" {rest}/>\n")
        };
        format!("<glyph><outline><contour>\n{}</contour></outline></glyph>", points.iter().map(point).collect::<String>())
    }

    fn joints(points: &[(&str, &str)]) -> (usize, Vec<(usize, usize, usize, bool)>) {
        let model = read(&of_points(points)).expect("a model");
        (model.parts.len(), model.joints.iter().map(|joint| (joint.first, joint.second, joint.node, joint.smooth)).collect())
    }

    #[test]
    fn contours_close_unless_they_begin_with_a_move() {
        let line = "type='line'";
        assert_eq!(joints(&[("0 0", line), ("1 0", line), ("1 1", line)]).1, [(0, 1, 1, false), (1, 2, 2, false), (2, 0, 0, false)]);
        assert_eq!(joints(&[("0 0", "type='move'"), ("1 0", line), ("1 1", line)]), (2, vec![(0, 1, 1, false)]));
        // A line that closes nothing is no piece, and either of its points may promise.
        assert_eq!(
            joints(&[("0 0", line), ("1 0", line), ("0 0", "type='line' smooth='yes'")]),
            (2, vec![(0, 1, 1, false), (1, 0, 0, true)])
        );
        assert_eq!(joints(&[("0 0", line)]), (0, vec![]));
        assert_eq!(joints(&[("0 0", "type='move'")]), (0, vec![]));
        assert_eq!(joints(&[]), (0, vec![]));
        assert_eq!(joints(&[("0 0", "")]), (0, vec![]));
        assert_eq!(joints(&[("0 0", ""), ("1 0", ""), ("5 5", "type='curve' smooth='yes'")]), (1, vec![(0, 0, 2, true)]));
    }

    #[test]
    fn degrees_follow_the_control_points() {
        let degrees = |off: usize, kind: &str| {
            let mut points = vec![("0 0", "type='move'")];
            points.extend(std::iter::repeat_n(("1 1", ""), off));
            points.push(("2 0", kind));
            let parts = read(&of_points(&points)).map(|model| model.parts);
            parts.map(|parts| parts.iter().map(|part| part.piece.points().len() - 1).collect::<Vec<_>>()).map_err(|flaw| flaw.message)
        };
        assert_eq!(degrees(0, "type='curve'"), Ok(vec![1]));
        assert_eq!(degrees(1, "type='curve'"), Ok(vec![2]));
        assert_eq!(degrees(2, "type='curve'"), Ok(vec![3]));
        assert_eq!(degrees(0, "type='qcurve'"), Ok(vec![1]));
        assert_eq!(degrees(4, "type='qcurve'"), Ok(vec![2; 4]));
        assert_eq!(degrees(3, "type='curve'"), Err("found 3 control points of a curve, expected at most 2".into()));
        assert_eq!(degrees(1, "type='line'"), Err("found a control point before a line, expected a point of the curve".into()));
    }

    #[test]
    fn flaws() {
        for (points, message) in [
            (
                &[("0 0", "type='line'"), ("1 0", "type='move'")][..],
                "found a point of type `move` behind others, expected it first in its contour",
            ),
            (
                &[("0 0", "type='line'"), ("1 0", "type='arc'")],
                "found `arc`, expected the type of a point: move, line, curve, qcurve or offcurve",
            ),
            (
                &[("0 0", "type='move'"), ("1 0", "")],
                "found a control point at the end of an open contour, expected a point of the curve behind it",
            ),
            (&[("0 0", "type='move'"), ("1e 0", "")], "found `1e` as `x`: expected a number such as 5, -7/3, 0.25 or 1e-3"),
        ] {
            let flaw = read(&of_points(points)).expect_err(message);
            assert_eq!((flaw.place, flaw.message.as_str()), (Some(Place { line: 3, column: 1 }), message));
        }
        let flaw = read("<glyph><outline><contour><point x='1'/></contour></outline></glyph>").expect_err("no y");
        assert_eq!((flaw.place, flaw.message.as_str()), (Some(Place { line: 1, column: 26 }), "the point has no `y`"));
        assert!(read("<plist/>").expect_err("no glyph").message.contains("found `<plist>`"));
    }
}
