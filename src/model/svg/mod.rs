//! The path data of Scalable Vector Graphics (W3C, *Scalable Vector Graphics
//! (SVG) 2*, chapters 9 and 10).

mod path;
#[cfg(test)]
mod tests;

use super::outline::{Node, Outline};
use super::xml::{Element, Tag, Tags};
use super::{Decimals, Flaw, Format, Model, Omission};
use path::PathReader;

/// Reads the paths, lines and polygons of a file, whatever they are nested in:
/// clip paths, symbols and definitions as well.
///
/// Coordinates are those of the path data. Transforms are not applied: how
/// pieces join is the same in every affine image.
pub(super) fn read(text: &str) -> Result<Model, Flaw> {
    let mut tags = Tags::new(text);
    let mut outline = Outline::default();
    let mut decimals = Decimals::default();
    while let Some(tag) = tags.next()? {
        let Tag::Start(element) = tag else { continue };
        if element.depth == 0 && element.name() != "svg" {
            return Err(Flaw::expected(tags.place(element.at), &format!("<{}>", element.name()), "an <svg> document"));
        }
        let what = match element.name() {
            "path" | "polyline" | "polygon" => {
                let name = if element.name() == "path" { "d" } else { "points" };
                if let Some(attribute) = element.attribute(name, tags.places())? {
                    let reader = PathReader::new(&attribute, tags.places(), &mut outline, &mut decimals);
                    match element.name() {
                        "path" => reader.path()?,
                        shape => reader.polygon(shape == "polygon")?,
                    }
                }
                continue;
            }
            "line" if line(&element, &mut tags, &mut outline, &mut decimals)? => continue,
            "line" => "a line whose ends have units is passed over",
            "circle" => "a circle is not a Bézier curve",
            "ellipse" => "an ellipse is not a Bézier curve",
            "rect" => "a rectangle is given by lengths, not by points",
            _ => continue,
        };
        outline.omit(Omission { place: tags.place(element.at), what });
    }
    Ok(outline.into_model(Format::Svg, decimals.finest()))
}

/// Reads a `<line>`, unless its coordinates have units.
fn line(element: &Element, tags: &mut Tags, outline: &mut Outline, decimals: &mut Decimals) -> Result<bool, Flaw> {
    let mut ends = [const { None }; 4];
    for (end, name) in ends.iter_mut().zip(["x1", "y1", "x2", "y2"]) {
        let number = match element.attribute(name, tags.places())? {
            None => Ok(0.into()),
            Some(attribute) => decimals.read(attribute.value.trim()),
        };
        *end = number.ok();
    }
    let [Some(x1), Some(y1), Some(x2), Some(y2)] = ends else { return Ok(false) };
    let place = tags.place(element.at);
    outline.begin(Node { point: [x1, y1], index: 0, place, smooth: false });
    outline.curve([], Node { point: [x2, y2], index: 1, place, smooth: false }, place)?;
    outline.end();
    Ok(true)
}
