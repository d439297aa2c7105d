//! BezierView: patches of several kinds (SurfLab, University of Florida,
//! *BezierView File Format*).

use super::scanner::{Scanner, Word};
use super::{Flaw, Format, Model, Omission, Part, group_name};
use crate::affine::Triangle;
use crate::control::ControlNet;
use crate::kernel::shape::Shape;
use crate::piece::Piece;
use crate::triangular::TriangularPatch;

/// Reads a sequence of patches, each with the number of its kind:
///
/// | kind | what |
/// |---|---|
/// | 1 | a polyhedron, which is passed over |
/// | 3 | a triangle: its degree, then its points |
/// | 4 | a rectangle with one degree for both directions |
/// | 5 | a rectangle: its degrees in `u` and `v`, then its points, row by row |
/// | 8 | a rational rectangle: points `x y z w` |
/// | 9, 10 | a triangle or rectangle with a net of normals, which are passed over |
///
/// A line `group NUMBER NAME` names the patches behind it. The `x y z` of a
/// rational point are taken as multiplied by `w` already, as BezierView itself
/// takes them. The rows of a triangle begin at the bottom, where `t` is on the
/// left and `s` on the right; `r` is on top.
pub(super) fn read(text: &str) -> Result<Model, Flaw> {
    let mut scanner = Scanner::new(text);
    let (mut parts, mut omissions) = (Vec::new(), Vec::new());
    let mut name: Option<String> = None;
    while let Some(word) = scanner.next() {
        if word.text.eq_ignore_ascii_case("group") {
            scanner.count("the number of the group")?;
            name = group_name(scanner.rest_of_line());
            continue;
        }
        let place = scanner.place(word.at);
        let mut part = match word.text {
            "1" => {
                polyhedron(&mut scanner)?;
                omissions.push(Omission { place, what: "a polyhedron has no Bézier pieces" });
                continue;
            }
            "3" | "9" => {
                let degree = scanner.degree("the degree of a triangle")?;
                let normals = if word.text == "9" { Some(scanner.degree("the degree of the normals")?) } else { None };
                let net = ControlNet { coordinates: scanner.points(triangle_count(degree), 3)?, shape: Shape::triangle(degree, 3) };
                if let Some(degree) = normals {
                    aside(&mut scanner, triangle_count(degree))?;
                }
                let piece = Piece::Triangle(TriangularPatch::from_net(net, Triangle::standard()));
                Part { piece, rational: false, has_frame: false, name: None, place }
            }
            "4" | "5" | "8" | "10" => {
                let p = scanner.degree("the degree of a rectangle in u")?;
                let q = if word.text == "4" { p } else { scanner.degree("the degree of a rectangle in v")? };
                let normals = match word.text {
                    "10" => Some([scanner.degree("the degree of the normals in u")?, scanner.degree("the degree of the normals in v")?]),
                    _ => None,
                };
                let dimension = if word.text == "8" { 4 } else { 3 };
                let coordinates = scanner.points((p + 1) * (q + 1), dimension)?;
                if let Some([p, q]) = normals {
                    aside(&mut scanner, (p + 1) * (q + 1))?;
                }
                Part { rational: dimension == 4, ..Part::patch((p, q), dimension, coordinates, place) }
            }
            _ => return Err(scanner.unexpected(Some(word), "a kind of patch, 1, 3, 4, 5, 8, 9 or 10, or `group`")),
        };
        part.name.clone_from(&name);
        part.add_to(&mut parts)?;
    }
    let model = Model::of_patches(Format::BezierView, parts, scanner.decimals.finest());
    Ok(Model { omissions, ..model })
}

/// The points of a triangular net.
fn triangle_count(degree: usize) -> usize {
    (degree + 1) * (degree + 2) / 2
}

/// Vectors that are no points: read, and dropped.
fn aside(scanner: &mut Scanner, count: usize) -> Result<(), Flaw> {
    let finest = scanner.decimals.finest();
    scanner.points(count, 3)?;
    scanner.decimals.restore(finest);
    Ok(())
}

/// The vertices and faces of a polyhedron.
fn polyhedron(scanner: &mut Scanner) -> Result<(), Flaw> {
    let vertices = scanner.count("the number of vertices of a polyhedron")?;
    let faces = scanner.count("the number of faces of a polyhedron")?;
    aside(scanner, vertices)?;
    for _ in 0..faces {
        for _ in 0..scanner.count("the number of corners of a face")? {
            let word = scanner.next();
            if word.and_then(Word::whole).is_none_or(|corner| corner >= vertices) {
                return Err(scanner.unexpected(word, format_args!("a corner of a face, counted from 0, of {vertices} vertices")));
            }
        }
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::exact::Rational;
    use crate::model::Place;

    #[test]
    fn kinds_and_names() {
        let text = "1 3 1 0 0 0.125 1 0 0 0 1 0 3 0 1 2\ngroup 4 lower left\n3 1 0 0 0 1 0 0 0 1 0.5\n4 1 0 0 0 0 1 0 1 0 0 1 1 0\r\n\
                    group 5\n8 0 1 0 0 0 2 1 1 1 2\n9 0 1 7 7 7 0.001 0 1 0 0 1 0 0 1\n10 0 0 0 0 1 2 3 0 0 1";
        let model = read(text).expect("a model");
        let kinds: Vec<(&str, bool, Option<&str>, u32)> = model
            .parts
            .iter()
            .map(|part| {
                let kind = if matches!(part.piece, Piece::Triangle(_)) { "triangle" } else { "rectangle" };
                (kind, part.rational, part.name.as_deref(), part.place.line)
            })
            .collect();
        assert_eq!(
            kinds,
            [
                ("triangle", false, Some("lower left"), 3),
                ("rectangle", false, Some("lower left"), 4),
                ("rectangle", true, None, 6),
                ("triangle", false, None, 7),
                ("rectangle", false, None, 8),
            ]
        );
        assert_eq!(model.omissions, [Omission { place: Place { line: 1, column: 1 }, what: "a polyhedron has no Bézier pieces" }]);
        assert_eq!(model.decimals, 1);
    }

    /// The bottom row is the edge from t to s, the right side from s to r.
    #[test]
    fn rows_of_triangles_begin_at_t() {
        let model = read("3 2  0 0 0  1 0 0  2 0 0   0 1 0  1 1 0   0 2 0").expect("a model");
        let Piece::Triangle(patch) = &model.parts[0].piece else { panic!("a triangle") };
        let value = |frame: &[Rational; 2]| patch.value(frame).expect("a point");
        let point = |x: i64, y: i64| [x, y, 0].map(Rational::from).to_vec();
        assert_eq!(value(patch.frame().t()), point(0, 0));
        assert_eq!(value(patch.frame().s()), point(2, 0));
        assert_eq!(value(patch.frame().r()), point(0, 2));
        assert_eq!(patch.point(1, 1), point(1, 1));
    }

    #[test]
    fn flaws() {
        for (text, line, column, message) in [
            ("7 3 3", 1, 1, "found `7`, expected a kind of patch, 1, 3, 4, 5, 8, 9 or 10, or `group`"),
            ("3 1\n0 0 0 1 0 0", 2, 12, "the file ends here, expected a coordinate, 3 for each of 3 points"),
            ("1 3 1 0 0 0 0 0 0 0 0 0\n3 0 1 3", 2, 7, "found `3`, expected a corner of a face, counted from 0, of 3 vertices"),
            ("1 4000000000 4000000000 0", 1, 26, "the file ends here, expected a coordinate, 3 for each of 4000000000 points"),
            ("group x", 1, 7, "found `x`, expected the number of the group"),
            ("3 1000000000", 1, 3, "found `1000000000`, expected the degree of a triangle, a whole number up to 4096"),
            ("5 1", 1, 4, "the file ends here, expected the degree of a rectangle in v, a whole number up to 4096"),
        ] {
            let flaw = read(text).expect_err(text);
            assert_eq!((flaw.place, flaw.message.as_str()), (Some(Place { line, column }), message));
        }
    }
}
