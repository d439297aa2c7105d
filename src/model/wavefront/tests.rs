//! Curves and surfaces against what their definitions say.

use proptest::prelude::*;

use super::*;
use crate::affine::Interval;
use crate::model::Place;
use crate::piece::Piece;
use crate::segment::Segment;
use crate::spline::Spline;

fn curves(model: &Model) -> Vec<&Segment> {
    let mut curves = Vec::new();
    for part in &model.parts {
        let Piece::Curve(segment) = &part.piece else { panic!("a curve") };
        curves.push(segment);
    }
    curves
}

const POINTS: &str = "v 0 0 0\nv 1 2 0\nv 3 2 0.5\nv 4 0 0\nv 5 -2 0\nv 7 -2 1\nv 8 0 0\n";

fn message(text: &str) -> String {
    let flaw = read(text).expect_err(text);
    format!("{}: {}", flaw.place.expect("a place"), flaw.message)
}

#[test]
fn a_curve_of_several_pieces_follows_itself() {
    let text = format!("{POINTS}o wave\ncstype bezier\ndeg 3\ncurv 0 5 1 2 3 4 5 6 7\nparm u 0 2 \\\n 5\nend\nf 1 2 3\n");
    let model = read(&text).expect("a model");
    let pieces = curves(&model);
    assert_eq!(pieces.iter().map(|piece| piece.frame().to_string()).collect::<Vec<_>>(), ["0..2", "2..5"]);
    assert_eq!(pieces[0].point(3), pieces[1].point(0));
    let place = Place { line: 11, column: 1 };
    assert_eq!(model.joints, [Follow { first: 0, second: 1, contour: 0, node: 0, place, smooth: false }]);
    assert_eq!((model.decimals, model.parts[1].name.as_deref(), model.parts[1].place), (1, Some("wave"), place));
}

#[test]
fn a_range_cuts_pieces() {
    let text = format!(
        "{POINTS}cstype bezier\ndeg 3\ncurv 1/2 3 -7 -6 -5 -4 -3 -2 -1\nparm u 0 2 5\nend\ncurv 0 2 1 2 3 4 5 6 7\nparm u 0 2 5\nend"
    );
    let model = read(&text).expect("a model");
    let pieces = curves(&model);
    assert_eq!(pieces.iter().map(|piece| piece.frame().to_string()).collect::<Vec<_>>(), ["1/2..2", "2..3", "0..2"]);
    assert!(pieces[0].same_map(pieces[2]).expect("numbers"));
    assert_eq!(model.joints.len(), 1);
}

#[test]
fn weights_belong_to_rational_curves_only() {
    let text = "v 1 0 0 1\nv 1 1 0 3 0.5 0.5 0.5\nv 0 1 0 9 9 9\ncstype rat bezier\ndeg 2\ncurv 0 1 1 2 3\nparm u 0 1\nend\n\
                cstype bezier\ncurv 0 1 1 2 3\nparm u 0 1\nend\n";
    let model = read(text).expect("a model");
    let points: Vec<Vec<String>> =
        curves(&model).iter().map(|curve| curve.coordinates().iter().map(Rational::to_string).collect()).collect();
    assert_eq!(points[0], ["1", "0", "0", "1", "3", "3", "0", "3", "0", "1", "0", "1"]);
    assert_eq!(points[1], ["1", "0", "0", "1", "1", "0", "0", "1", "0"]);
    assert_eq!(model.parts.iter().map(|part| part.rational).collect::<Vec<_>>(), [true, false]);
}

#[test]
fn what_is_passed_over() {
    let text = format!(
        "{POINTS}cstype cardinal\ndeg 3\ncurv 0 1 1 2 3 4\nparm u 0 1\nend\nvp 0 0\ncurv2 1 2\nparm u 0 1\nend\ncon 1 0 1 1 2 0 1 1\n\
         call other.obj\nusemtl x\n"
    );
    let model = read(&text).expect("a model");
    let omissions: Vec<(u32, &str)> = model.omissions.iter().map(|omission| (omission.place.line, omission.what)).collect();
    assert_eq!(
        omissions,
        [
            (10, "a cardinal curve or surface is not read"),
            (14, "a curve in the parameter plane of a surface is no curve in space"),
            (17, "the statement that trimmed surfaces are connected is passed over"),
            (18, "the file that is called is not read"),
        ]
    );
    assert!(model.parts.is_empty());
}

#[test]
fn flaws() {
    let curve = |statements: &str| format!("v 0 0 0\nv 1 0 0\nv 2 0 0\n{statements}\n");
    for (text, expected) in [
        ("v 1 2\n".to_owned(), "1:6: the line ends here, expected a coordinate of a vertex"),
        ("v 1 nan 2\n".into(), "1:5: found `nan`, expected a coordinate of a vertex"),
        ("cstype nurbs".into(), "1:8: found `nurbs`, expected a type of curves and surfaces: bezier, bspline, bmatrix, cardinal or taylor"),
        ("deg 1000000000".into(), "1:5: found `1000000000`, expected a degree, a whole number from 1 to 4096"),
        ("parm u 0 1".into(), "1:1: found `parm`, expected a curve or surface before it"),
        ("end".into(), "1:1: found `end`, expected a curve or surface before it"),
        (curve("deg 1\ncurv 0 1 1 2\nparm u 0 1\nend"), "5:1: there is no type of curves and surfaces, expected `cstype` before"),
        (curve("cstype bezier\ncurv 0 1 1 2\nparm u 0 1\nend"), "5:1: there is no degree in u, expected it in `deg` before"),
        (curve("cstype bezier\ndeg 1\ncurv 0 1 1 4\nparm u 0 1\nend"), "6:12: found `4`, expected the index of one of 3 vertices"),
        (curve("cstype bezier\ndeg 1\ncurv 0 1 1 0\nparm u 0 1\nend"), "6:12: found `0`, expected the index of one of 3 vertices"),
        (curve("cstype bezier\ndeg 1\ncurv 0 1 1 -4\nparm u 0 1\nend"), "6:12: found `-4`, expected the index of one of 3 vertices"),
        (
            curve("cstype bezier\ndeg 1\ncurv 0 1 1 2 3\nparm u 0 1\nend"),
            "6:1: found 3 points of a curve, expected 2 by its degree and `parm`",
        ),
        (curve("cstype bezier\ndeg 1\ncurv 0 1 1 2\nend"), "6:1: found 0 breakpoints in `parm u`, expected at least 2"),
        (curve("cstype bezier\ndeg 1\ncurv 0 1 1 2\nparm u 1 1\nend"), "6:1: the breakpoints must rise: 1 stands before 1"),
        (curve("cstype bezier\ndeg 1\ncurv 0 2 1 2\nparm u 0 1\nend"), "6:1: found the range 0..2 in u, expected a part of 0..1"),
        (
            curve("cstype bezier\ndeg 1\ncurv 0 1 1 2\nparm u 0 1"),
            "6:1: the file ends inside of this curve or surface, expected `end` behind it",
        ),
        (
            curve("cstype bezier\ndeg 1\ncurv 0 1 1 2\ncurv 0 1 1 2"),
            "7:1: found `curv`, expected `end` behind the curve or surface before it",
        ),
        (
            curve("cstype bspline\ndeg 1\ncurv 0 1 1 2\nparm u 0 0 1\nend"),
            "6:1: found 3 knots in `parm u`, expected at least 4 for degree 1",
        ),
        (curve("cstype bspline\ndeg 1\ncurv 0 1 1 2\nparm u 1 1 0 0\nend"), "6:1: the knots must not fall: 1 stands before 0"),
        (
            curve("cstype bezier\ndeg 1\nsurf 0 1 0 1 1 2\nparm u 0 1\nparm v 0 1\nend"),
            "6:1: there is no degree in v, expected it in `deg` before",
        ),
        (
            curve("cstype bezier\ndeg 1 1\nsurf 0 1 0 1 1 2\nparm u 0 1\nparm v 0 1\nend"),
            "6:1: found 2 points of a surface, expected 2 times 2 by its degrees and `parm`",
        ),
    ] {
        assert_eq!(message(&text), expected, "{text}");
    }
}

/// Knots of a spline of degree `degree`: rising by 0, 1/2 or 1, no knot listed too often.
fn knots(degree: usize, steps: &[u8]) -> Vec<Rational> {
    let mut knots = vec![Rational::from(0); degree + 1];
    let mut last = Rational::from(0);
    for (place, step) in steps.iter().enumerate() {
        // At most two equal knots inside, and a step at both ends.
        let step = if place % 2 == 0 || place + 1 == steps.len() { i64::from(*step % 2) + 1 } else { i64::from(*step % 3) };
        last += Rational::new(step, 2);
        knots.push(last.clone());
    }
    knots.extend(std::iter::repeat_n(last, degree));
    knots
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 48, ..ProptestConfig::default() })]

    /// The patches of a surface, made in u first, against the curves that it
    /// consists of, made in v first.
    #[test]
    fn surfaces_are_curves_of_curves(
        (p, q) in (1usize..4, 1usize..4),
        in_u in prop::collection::vec(0u8..6, 1..4),
        in_v in prop::collection::vec(0u8..6, 1..4),
        heights in prop::collection::vec(-40i32..40, 100),
    ) {
        let (us, vs) = (knots(p, &in_u), knots(q, &in_v));
        let (columns, rows) = (us.len() - p - 1, vs.len() - q - 1);
        let height = |i: usize, j: usize| Rational::new(heights[(i * 7 + j * 13) % heights.len()].into(), 4);
        let mut text = String::new();
        for j in 0..rows {
            for i in 0..columns {
                text += &format!("v {i} {j} {}\n", height(i, j));
            }
        }
        let list = |numbers: &[Rational]| numbers.iter().map(Rational::to_string).collect::<Vec<_>>().join(" ");
        let indices: Vec<String> = (1..=rows * columns).map(|index| index.to_string()).collect();
        text += &format!(
            "cstype bspline\ndeg {p} {q}\nsurf 0 {} 0 {} {}\nparm u {}\nparm v {}\nend\n",
            us[us.len() - 1], vs[vs.len() - 1], indices.join(" "), list(&us), list(&vs)
        );
        let model = read(&text).expect("a model");

        let line = |degree, knots: &[Rational], points: Vec<Vec<Rational>>| {
            Spline::new(degree, knots.to_vec(), points).and_then(|spline| spline.pieces()).expect("pieces")
        };
        let columns: Vec<Vec<Segment>> = (0..columns).map(|i| line(q, &vs, (0..rows).map(|j| vec![height(i, j)]).collect())).collect();
        let mut expected: Vec<(Interval, Interval, usize, usize, Rational)> = Vec::new();
        for piece in 0..columns[0].len() {
            for j in 0..=q {
                for (strip, across) in line(p, &us, columns.iter().map(|column| column[piece].point(j).to_vec()).collect()).iter().enumerate() {
                    for i in 0..=p {
                        let frame = (across.frame().clone(), columns[0][piece].frame().clone());
                        expected.push((frame.0, frame.1, strip * columns[0].len() + piece, i * (q + 1) + j, across.point(i)[0].clone()));
                    }
                }
            }
        }
        prop_assert_eq!(expected.len(), model.parts.len() * (p + 1) * (q + 1));
        for (u, v, part, point, height) in expected {
            let Piece::Rectangle(patch) = &model.parts[part].piece else { panic!("a rectangle") };
            prop_assert_eq!((patch.frame().u(), patch.frame().v()), (&u, &v));
            prop_assert_eq!(&patch.points().nth(point).expect("a point")[2], &height);
        }
    }
}
