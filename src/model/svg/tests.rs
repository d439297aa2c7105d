//! Paths against what their commands mean, spelled out.

use proptest::prelude::*;

use super::*;
use crate::exact::Rational;
use crate::model::Place;

/// A document with this path data from column 15 on.
fn of_path(data: &str) -> String {
    format!("<svg><path d=\"{data}\"/></svg>")
}

/// The points of all pieces.
fn pieces(model: &Model) -> Vec<Vec<[Rational; 2]>> {
    let points = |part: &crate::model::Part| part.piece.points().map(|point| [point[0].clone(), point[1].clone()]).collect();
    model.parts.iter().map(points).collect()
}

fn text_of(data: &str) -> Vec<String> {
    let model = read(&of_path(data)).unwrap_or_else(|flaw| panic!("{data}: {flaw}"));
    let point = |[x, y]: &[Rational; 2]| format!("{x},{y}");
    pieces(&model).iter().map(|piece| piece.iter().map(point).collect::<Vec<_>>().join(" ")).collect()
}

#[test]
fn compact_numbers() {
    assert_eq!(text_of("M.5.5-1-2"), ["1/2,1/2 -1,-2"]);
    assert_eq!(text_of("M0,0L1e1.5 1E-1-.5"), ["0,0 10,1/2", "10,1/2 1/10,-1/2"]);
    assert_eq!(text_of(" M +1\t1\r\n , 2.,3"), ["1,1 2,3"]);
    assert_eq!(text_of("m1 1 1 1L0 0"), ["1,1 2,2", "2,2 0,0"]);
    assert_eq!(text_of("M0 0h1v1H0"), ["0,0 1,0", "1,0 1,1", "1,1 0,1"]);
}

#[test]
fn reflected_control_points() {
    // Behind another kind of command there is nothing to reflect.
    assert_eq!(text_of("M0 0S1 1 2 0"), ["0,0 0,0 1,1 2,0"]);
    assert_eq!(text_of("M0 0Q1 1 2 0S3 1 4 0"), ["0,0 1,1 2,0", "2,0 2,0 3,1 4,0"]);
    assert_eq!(text_of("M0 0C0 1 1 1 2 0T4 0"), ["0,0 0,1 1,1 2,0", "2,0 2,0 4,0"]);
    assert_eq!(text_of("M0 0Q1 1 2 0T4 0T6 0"), ["0,0 1,1 2,0", "2,0 3,-1 4,0", "4,0 5,1 6,0"]);
    assert_eq!(text_of("M0 0Q1 1 2 0L2 0T6 0"), ["0,0 1,1 2,0", "2,0 2,0", "2,0 2,0 6,0"]);
    assert_eq!(text_of("M0 0c0 1 1 1 2 0s1 1 2 0"), ["0,0 0,1 1,1 2,0", "2,0 3,-1 3,1 4,0"]);
}

#[test]
fn closed_contours() {
    let joints = |data: &str| {
        let model = read(&of_path(data)).expect(data);
        let joint = |joint: &crate::model::Follow| (joint.first, joint.second, joint.contour, joint.node);
        (model.parts.len(), model.joints.iter().map(joint).collect::<Vec<_>>())
    };
    // With a gap, without one, a single loop, and nothing at all.
    assert_eq!(joints("M0 0 1 0 1 1z"), (3, vec![(0, 1, 0, 1), (1, 2, 0, 2), (2, 0, 0, 0)]));
    assert_eq!(joints("M0 0 1 0 0 0z"), (2, vec![(0, 1, 0, 1), (1, 0, 0, 0)]));
    assert_eq!(joints("M0 0C1 0 0 1 0 0Z"), (1, vec![(0, 0, 0, 0)]));
    assert_eq!(joints("M0 0zM1 1Z"), (0, vec![]));
    // An open contour that comes back does not join, and a new one begins behind `z` where the last did.
    assert_eq!(joints("M0 0 1 0 0 0"), (2, vec![(0, 1, 0, 1)]));
    assert_eq!(joints("M1 1 1 0 0 0zl1 1 0 1M0 0"), (5, vec![(0, 1, 0, 1), (1, 2, 0, 2), (2, 0, 0, 0), (3, 4, 1, 1)]));
    assert_eq!(text_of("M1 1 1 0zl1 1"), ["1,1 1,0", "1,0 1,1", "1,1 2,2"]);
}

#[test]
fn arcs_are_no_pieces() {
    let model = read(&of_path("M0 0L1 0A1 1 0 01.5.5L3 3z")).expect("a model");
    assert_eq!(model.omissions, [Omission { place: Place { line: 1, column: 24 }, what: "an arc is not a Bézier curve" }]);
    let joints: Vec<(usize, usize)> = model.joints.iter().map(|joint| (joint.first, joint.second)).collect();
    assert_eq!((model.parts.len(), joints), (3, vec![(1, 2), (2, 0)]));
    // Without a radius it is a line; without a length, nothing. Radii are no coordinates.
    assert_eq!(text_of("M0 0A0 1.125 0 0 0 1 1A1 1 0 1 1 1 1a1 0 0 10 1-1"), ["0,0 1,1", "1,1 2,0"]);
    assert_eq!(read(&of_path("M0 0a0 1.125 45.0625 0 0 1 1.5")).expect("a model").decimals, 1);
}

#[test]
fn other_shapes() {
    let model = read(
        "<svg:svg xmlns:svg='http://www.w3.org/2000/svg'><svg:polygon points='0,0 1,0 1,1'/><polyline points=' 0 0, 2.5 0 3 3'/>\
         <polygon points=''/><line x2='4'/><line x1='1cm'/><rect/><ellipse/><circle/><path/><path d=' none '/><path d=''/></svg:svg>",
    )
    .expect("a model");
    assert_eq!((model.parts.len(), model.joints.len(), model.decimals), (3 + 2 + 1, 3 + 1, 1));
    let what: Vec<&str> = model.omissions.iter().map(|omission| omission.what).collect();
    assert_eq!(
        what,
        [
            "a line whose ends have units is passed over",
            "a rectangle is given by lengths, not by points",
            "an ellipse is not a Bézier curve",
            "a circle is not a Bézier curve",
        ]
    );
}

#[test]
fn flaws() {
    for (data, column, message) in [
        ("L0 0", 15, "found `L0`, expected M or m, with which a path begins"),
        ("1 1", 15, "found `1`, expected a command, one of MmLlHhVvCcSsQqTtAaZz"),
        ("M0 0 L1", 22, "the data ends here, expected a number, an argument of L"),
        ("M0 0 C1 1 2 2 3", 30, "the data ends here, expected a number, an argument of C"),
        ("M0 0 X", 20, "found `X`, expected a command, one of MmLlHhVvCcSsQqTtAaZz"),
        ("M0 0z1 1", 20, "found `1`, expected a command, one of MmLlHhVvCcSsQqTtAaZz"),
        ("M,0 0", 16, "found `,0`, expected a number, an argument of M"),
        ("M0,,0", 18, "found `,0`, expected a number, an argument of M"),
        ("M0 0,", 20, "the data ends here, expected a number, an argument of L"),
        ("M0 0L1 1,L2 2", 24, "found `L2`, expected a number, an argument of L"),
        ("M0 0L1e 1", 21, "found `e`, expected a number, an argument of L"),
        ("M0 0L--1 1", 20, "found `--1`, expected a number, an argument of L"),
        ("M0 0A1 1 0 2 0 1 1", 26, "found `2`, expected a flag of an arc, 0 or 1"),
        ("M0 0L1e99999 1", 20, "found `1e99999`: a number may have at most 10000 digits"),
        ("M0 0\u{1b}", 19, "found `\u{fffd}`, expected a command, one of MmLlHhVvCcSsQqTtAaZz"),
    ] {
        let flaw = read(&of_path(data)).expect_err(data);
        assert_eq!((flaw.place, flaw.message.as_str()), (Some(Place { line: 1, column }), message), "{data}");
    }
    for (text, message) in [
        ("", "found no element, expected an XML document"),
        ("<html/>", "found `<html>`, expected an <svg> document"),
        ("<svg></svg><svg/>", "found `<svg>`, expected the end of the file behind the root element"),
        ("<svg><g></svg>", "not well-formed XML: ill-formed document: expected `</g>`, but `</svg>` was found"),
        ("<svg><g>", "the file ends inside of an element, expected its end tag"),
    ] {
        assert_eq!(read(text).expect_err(text).message, message);
    }
}

#[derive(Clone, Debug)]
enum Command {
    Line([i64; 2]),
    Horizontal(i64),
    Vertical(i64),
    Cubic([[i64; 2]; 3]),
    SmoothCubic([[i64; 2]; 2]),
    Quadratic([[i64; 2]; 2]),
    SmoothQuadratic([i64; 2]),
    Close,
}

fn command() -> impl Strategy<Value = Command> {
    let number = || -60i64..60;
    let point = || [number(), number()];
    prop_oneof![
        point().prop_map(Command::Line),
        number().prop_map(Command::Horizontal),
        number().prop_map(Command::Vertical),
        [point(), point(), point()].prop_map(Command::Cubic),
        [point(), point()].prop_map(Command::SmoothCubic),
        [point(), point()].prop_map(Command::Quadratic),
        point().prop_map(Command::SmoothQuadratic),
        Just(Command::Close),
    ]
}

/// Numbers in eighths, as short as they can be written behind one another.
fn compact(letter: char, numbers: &[i64], data: &mut String) {
    data.push(letter);
    let mut last = String::new();
    for &number in numbers {
        let (sign, size) = (if number < 0 { "-" } else { "" }, number.abs());
        let whole = if size < 8 && size % 8 != 0 { String::new() } else { (size / 8).to_string() };
        let behind = ["", ".125", ".25", ".375", ".5", ".625", ".75", ".875"][usize::try_from(size % 8).expect("a rest")];
        let text = format!("{sign}{whole}{behind}");
        let glued = last.is_empty() || text.starts_with('-') || (text.starts_with('.') && last.contains('.'));
        if !glued {
            data.push(' ');
        }
        *data += &text;
        last = text;
    }
}

proptest! {
    #[test]
    fn relative_and_absolute_commands_are_the_same(
        start in [-60i64..60, -60i64..60],
        commands in prop::collection::vec((command(), any::<bool>()), 0..12),
    ) {
        let mut data = String::new();
        compact('M', &start, &mut data);
        let mut expected: Vec<Vec<[i64; 2]>> = Vec::new();
        let (mut here, mut cubic, mut quadratic) = (start, None, None);
        for (command, relative) in commands {
            let mirror = |handle: Option<[i64; 2]>| handle.map_or(here, |[x, y]: [i64; 2]| [2 * here[0] - x, 2 * here[1] - y]);
            // The letter, the points it is written with, and all that it means.
            let (letter, written, meant) = match command {
                Command::Line(end) => ('L', vec![end], vec![end]),
                Command::Horizontal(x) => ('H', vec![], vec![[x, here[1]]]),
                Command::Vertical(y) => ('V', vec![], vec![[here[0], y]]),
                Command::Cubic(points) => ('C', points.to_vec(), points.to_vec()),
                Command::SmoothCubic([control, end]) => ('S', vec![control, end], vec![mirror(cubic), control, end]),
                Command::Quadratic(points) => ('Q', points.to_vec(), points.to_vec()),
                Command::SmoothQuadratic(end) => ('T', vec![end], vec![mirror(quadratic), end]),
                Command::Close if here == start => ('Z', vec![], vec![]),
                Command::Close => ('Z', vec![], vec![start]),
            };
            let base = if relative { here } else { [0, 0] };
            let numbers: Vec<i64> = match letter {
                'H' => vec![meant[0][0] - base[0]],
                'V' => vec![meant[0][1] - base[1]],
                _ => written.iter().flat_map(|point| [point[0] - base[0], point[1] - base[1]]).collect(),
            };
            compact(if relative { letter.to_ascii_lowercase() } else { letter }, &numbers, &mut data);
            (cubic, quadratic) = match letter {
                'C' | 'S' => (Some(meant[1]), None),
                'Q' | 'T' => (None, Some(meant[0])),
                _ => (None, None),
            };
            if let Some(&end) = meant.last() {
                expected.push([here].into_iter().chain(meant.iter().copied()).collect());
                here = end;
            }
        }
        let model = read(&of_path(&data)).map_err(|flaw| TestCaseError::fail(format!("{data}: {flaw}")))?;
        let eighths = |point: &[i64; 2]| point.map(|number| Rational::new(number, 8));
        let expected: Vec<Vec<[Rational; 2]>> = expected.iter().map(|piece| piece.iter().map(eighths).collect()).collect();
        prop_assert_eq!(pieces(&model), expected, "{}", data);
    }
}
