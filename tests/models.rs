//! Real files of the formats, and small ones of our own.

use std::path::{Path, PathBuf};

use casteljau::model::{Format, Model, Part, read};
use casteljau::{Piece, Rational};

/// The folder of real data, which is not part of the project: `CASTELJAU_DATA`.
fn data() -> Option<PathBuf> {
    let folder = std::env::var_os("CASTELJAU_DATA").map(PathBuf::from);
    if folder.is_none() {
        eprintln!("skipped: CASTELJAU_DATA does not name the folder of real data");
    }
    folder
}

fn files(folder: &Path, found: &mut Vec<PathBuf>) {
    for entry in std::fs::read_dir(folder).expect("a folder") {
        let path = entry.expect("an entry").path();
        if path.is_dir() { files(&path, found) } else { found.push(path) }
    }
}

/// All files below a folder that the format's ending names, read.
fn models(folder: &Path, format: Format) -> Vec<(PathBuf, Model)> {
    let mut found = Vec::new();
    files(folder, &mut found);
    found.sort();
    found.retain(|path| Format::of_path(path) == Some(format));
    let read_file = |path: PathBuf| {
        let text = std::fs::read_to_string(&path).expect("text");
        let model = read(&text, format).unwrap_or_else(|flaw| panic!("{}:{:?}: {flaw}", path.display(), flaw.place));
        (path, model)
    };
    found.into_iter().map(read_file).collect()
}

#[test]
fn the_tea_set() {
    let Some(data) = data() else { return };
    let models = models(&data.join("newell"), Format::Newell);
    let counts: Vec<(String, usize, u32)> = models
        .iter()
        .map(|(path, model)| (path.file_name().expect("a name").to_string_lossy().into_owned(), model.parts.len(), model.decimals))
        .collect();
    assert_eq!(counts, [("teacup.patches.txt".to_owned(), 26, 7), ("teapot.patches.txt".to_owned(), 32, 5)]);
}

#[test]
fn the_glyphs_of_source_sans() {
    let Some(data) = data() else { return };
    let models = models(&data.join("glif"), Format::Glif);
    assert_eq!(models.len(), 150);
    let smooth = models.iter().flat_map(|(_, model)| &model.joints).filter(|joint| joint.smooth).count();
    assert_eq!(smooth, 1061);
    assert!(models.iter().all(|(_, model)| !model.meets_by_position && model.decimals == 0 && model.omissions.is_empty()));
}

#[test]
fn the_icons() {
    let Some(data) = data() else { return };
    let models = models(&data.join("svg"), Format::Svg);
    assert_eq!(models.len(), 319);
    let count = |count: &dyn Fn(&Model) -> usize| models.iter().map(|(_, model)| count(model)).sum::<usize>();
    println!("{} parts, {} joints, {} omissions", count(&|m| m.parts.len()), count(&|m| m.joints.len()), count(&|m| m.omissions.len()));
    for (path, model) in &models {
        let text = std::fs::read_to_string(path).expect("text");
        let lines: Vec<&str> = text.lines().collect();
        for joint in &model.joints {
            let line = lines[joint.place.line as usize - 1];
            let rest = &line[joint.place.column as usize - 1..];
            assert!(
                rest.starts_with(|letter: char| letter.is_ascii_digit() || "-.+".contains(letter)),
                "{}:{}",
                path.display(),
                joint.place
            );
        }
    }
}

fn sample(name: &str) -> String {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/models").join(name);
    std::fs::read_to_string(path).expect("a sample file")
}

/// A sample file, read as its ending says.
fn model(name: &str) -> Model {
    let format = Format::of_path(Path::new(name)).expect("a known ending");
    read(&sample(name), format).unwrap_or_else(|flaw| panic!("{name}:{:?}: {flaw}", flaw.place))
}

/// The points of a piece: `0,0 1,1/2`.
fn points(piece: &Piece) -> String {
    let point = |point: &[Rational]| point.iter().map(Rational::to_string).collect::<Vec<_>>().join(",");
    piece.points().map(point).collect::<Vec<_>>().join(" ")
}

/// The parts and joints of a model, a line each.
fn outline(model: &Model) -> Vec<String> {
    let parts = model.parts.iter().map(|part| format!("{} {}", part.place, points(&part.piece)));
    let joints = model.joints.iter().map(|joint| {
        let smooth = if joint.smooth { " smooth" } else { "" };
        format!("{} joins {} and {} at {}.{}{smooth}", joint.place, joint.first, joint.second, joint.contour, joint.node)
    });
    let omissions = model.omissions.iter().map(|omission| format!("{} {}", omission.place, omission.what));
    parts.chain(joints).chain(omissions).collect()
}

#[test]
fn path_data() {
    let model = model("s.svg");
    assert_eq!((model.decimals, model.meets_by_position), (1, false));
    assert_eq!(
        outline(&model),
        [
            "5:36 0,0 24,0",
            "5:39 24,0 24,24",
            "5:42 24,24 0,24",
            "5:43 0,24 0,0",
            "10:20 18,6 18,4 15,3 12,3",
            "10:35 12,3 9,3 6,9/2 6,8",
            "10:45 6,8 6,23/2 12,12 12,12",
            "11:14 12,12 12,12 18,25/2 18,16",
            "11:22 18,16 18,39/2 15,21 12,21",
            "11:30 12,21 9,21 6,20 6,18",
            "12:20 12,2 16,6 12,10",
            "12:28 12,10 8,14 12,18",
            "12:49 1/2,1/2 3,3",
            "12:52 3,3 1,1",
            "12:59 5,5 9,1 9,5",
            "12:67 9,5 9,9 5,5",
            "5:36 joins 0 and 1 at 0.1",
            "5:39 joins 1 and 2 at 0.2",
            "5:42 joins 2 and 3 at 0.3",
            "5:32 joins 3 and 0 at 0.0",
            "10:30 joins 4 and 5 at 1.3",
            "10:41 joins 5 and 6 at 1.6",
            "10:49 joins 6 and 7 at 1.9",
            "11:19 joins 7 and 8 at 1.12",
            "11:26 joins 8 and 9 at 1.15",
            "12:24 joins 10 and 11 at 2.2",
            "12:49 joins 12 and 13 at 3.2",
            "12:63 joins 14 and 15 at 4.2",
            "12:55 joins 15 and 14 at 4.0",
            "12:36 an arc is not a Bézier curve",
            "13:5 a circle is not a Bézier curve",
        ]
    );
}

#[test]
fn cubic_glyph() {
    let model = model("a.glif");
    assert_eq!((model.decimals, model.meets_by_position), (1, false));
    assert_eq!(
        outline(&model),
        [
            "9:7 200,0 300,0 400,201/2 400,200",
            "12:7 400,200 400,400",
            "13:7 400,400 0,400",
            "14:7 0,400 0,200",
            "15:7 0,200 0,100 100,0 200,0",
            "22:7 0,0 10,10",
            "11:7 joins 0 and 1 at 0.4 smooth",
            "12:7 joins 1 and 2 at 0.5",
            "13:7 joins 2 and 3 at 0.6",
            "14:7 joins 3 and 4 at 0.7 smooth",
            "8:7 joins 4 and 0 at 0.1 smooth",
        ]
    );
}

#[test]
fn quadratic_glyph() {
    assert_eq!(
        outline(&model("quadratic.glif")),
        [
            "6:7 0,0 0,10 5,21/2",
            "7:7 5,21/2 10,11 15,21/2",
            "8:7 15,21/2 20,10 20,0",
            "5:7 20,0 0,0",
            "12:7 1/2,-1/2 1,0 1/2,1/2",
            "13:7 1/2,1/2 0,1 -1/2,1/2",
            "14:7 -1/2,1/2 -1,0 -1/2,-1/2",
            "15:7 -1/2,-1/2 0,-1 1/2,-1/2",
            "6:7 joins 0 and 1 at 0.1",
            "7:7 joins 1 and 2 at 0.2",
            "9:7 joins 2 and 3 at 0.4",
            "5:7 joins 3 and 0 at 0.0 smooth",
            "12:7 joins 4 and 5 at 1.0",
            "13:7 joins 5 and 6 at 1.1",
            "14:7 joins 6 and 7 at 1.2",
            "15:7 joins 7 and 4 at 1.3",
        ]
    );
}

/// What is known of each part but its points.
fn kinds(model: &Model) -> Vec<(bool, bool, Option<&str>, String)> {
    let kind = |part: &'_ Part| (part.rational, part.has_frame, part.piece.frame().to_string());
    let names = model.parts.iter().map(|part| part.name.as_deref());
    model.parts.iter().map(kind).zip(names).map(|((rational, has_frame, frame), name)| (rational, has_frame, name, frame)).collect()
}

#[test]
fn splines_are_their_pieces() {
    let model = model("spline.json");
    assert_eq!(outline(&model), ["1:1 0,0 1/2,1 5/6,1", "1:1 5/6,1 3/2,1 2,0", "1:1 joins 0 and 1 at 0.0"]);
    let name = Some("thirds");
    assert_eq!(kinds(&model), [(false, true, name, "0..1/3".into()), (false, true, name, "1/3..1".into())]);
    assert_eq!((model.decimals, model.meets_by_position), (1, true));
}

#[test]
fn models_hold_pieces_of_all_kinds() {
    let model = model("model.json");
    assert_eq!(
        outline(&model),
        ["2:3 0,0 1,5/4", "3:3 0,0,1 2,2,2", "3:3 2,2,2 2,0,1", "4:3 0,0,1 0,1,1 1/8,0,1/8", "3:3 joins 1 and 2 at 0.0"]
    );
    assert_eq!(
        kinds(&model),
        [
            (false, false, None, "0..1".into()),
            (true, true, None, "0..1".into()),
            (true, true, None, "1..2".into()),
            (true, true, Some("tile"), "(1,0) (0,1) (0,0)".into())
        ]
    );
    // Neither weights nor frames are coordinates.
    assert_eq!(model.decimals, 2);
}

/// The same two patches, written in five ways.
#[test]
fn patches_are_the_same_in_all_formats() {
    let points_of = |name: &str| model(name).parts.iter().map(|part| points(&part.piece)).collect::<Vec<_>>();
    let expected = points_of("two_patches.json");
    assert_eq!(expected[0], "0,0,0 0,1,1/4 0,2,0 1,0,1/2 1,1,1 1,2,1/2 2,0,3/4 2,1,5/4 2,2,3/4");
    for name in ["two_patches.bpt", "two_patches.bv", "vault_bezier.obj", "vault_bspline.obj"] {
        assert_eq!(points_of(name), expected, "{name}");
    }
    for name in ["vault_bezier.obj", "vault_bspline.obj"] {
        let vault = Some("vault");
        assert_eq!(kinds(&model(name)), [(false, true, vault, "0..1, 0..1".into()), (false, true, vault, "1..2, 0..1".into())]);
    }
    let newell = model("two_bicubics.patches.txt");
    let ends: Vec<[&[Rational]; 2]> = newell
        .parts
        .iter()
        .map(|part| {
            let rows = part.piece.rows();
            [rows[0][3], rows[3][0]]
        })
        .collect();
    assert_eq!(ends[0].map(|point| point[0].to_string()), ["0", "3"]);
    assert_eq!(ends[1].map(|point| point[1].to_string()), ["3", "0"]);
    assert_eq!((newell.decimals, newell.meets_by_position), (2, true));
}

#[test]
fn rational_points_are_homogeneous() {
    for name in ["quadrant.json", "quadrant.obj", "quadrant.bv"] {
        let model = model(name);
        let part = &model.parts[0];
        assert!(part.rational, "{name}");
        // Every point lies on the circle or cylinder: (x/w)^2 + (y/w)^2 = 1 at all of a few parameters.
        let half = Rational::new(1, 2);
        let value = match &part.piece {
            Piece::Curve(curve) => curve.value(&half),
            Piece::Rectangle(patch) => patch.value(&[half.clone(), half.clone()]),
            Piece::Triangle(_) => unreachable!("no triangle in these files"),
        }
        .expect("a point");
        let w = value.last().expect("a weight");
        assert_eq!(&value[0] * &value[0] + &value[1] * &value[1], w * w, "{name}");
    }
}

#[test]
fn triangles_share_an_edge() {
    let model = model("triangles.bv");
    let rows: Vec<Vec<Vec<&[Rational]>>> = model.parts.iter().map(|part| part.piece.rows()).collect();
    // In both, the last points of the rows are the edge from s to r; they run against each other.
    let side = |rows: &[Vec<&[Rational]>]| rows.iter().map(|row| row[row.len() - 1].to_vec()).collect::<Vec<_>>();
    let mut second = side(&rows[1]);
    second.reverse();
    assert_eq!(side(&rows[0]), second);
}
