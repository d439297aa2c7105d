//! What must come out of published data, where its folder is at hand
//! (`CASTELJAU_DATA`).

use std::path::PathBuf;

use casteljau::audit::{Audit, Requirement, Rounding, Terms, Verdict, audit};
use casteljau::model::{Format, Model, read};
use casteljau::{Continuity, Rational};

fn folder(below: &str) -> Option<PathBuf> {
    let Some(data) = std::env::var_os("CASTELJAU_DATA") else {
        eprintln!("skipped: CASTELJAU_DATA does not name the folder of published data");
        return None;
    };
    Some(PathBuf::from(data).join(below))
}

fn checked(path: &std::path::Path, terms: &Terms) -> (Model, Audit) {
    let text = std::fs::read_to_string(path).expect("a text");
    let model = read(&text, Format::of_path(path).expect("a known ending")).unwrap_or_else(|flaw| panic!("{}: {flaw}", path.display()));
    let audit = audit(&model, terms, None).expect("an audit");
    (model, audit)
}

fn files(folder: &std::path::Path, ending: &str) -> Vec<PathBuf> {
    let mut found = Vec::new();
    for entry in std::fs::read_dir(folder).expect("a folder") {
        let path = entry.expect("an entry").path();
        if path.is_dir() {
            found.extend(files(&path, ending));
        } else if path.to_string_lossy().ends_with(ending) {
            found.push(path);
        }
    }
    found.sort();
    found
}

#[test]
fn the_teapot_is_smooth() {
    let Some(folder) = folder("newell") else { return };
    let terms = Terms { require: Some(Requirement::G1), ..Terms::default() };
    let (model, audit) = checked(&folder.join("teapot.patches.txt"), &terms);
    assert_eq!((model.parts.len(), audit.joins.len(), audit.open, audit.collapsed, audit.branches), (32, 52, 16, 8, 0));
    assert!(audit.joins.iter().all(|join| join.verdict == Verdict::Exact));
    let c1 = audit.joins.iter().filter(|join| join.parametric == Continuity::C(1)).count();
    let mut ratios: Vec<Rational> =
        audit.joins.iter().filter(|join| join.parametric == Continuity::C(0)).filter_map(|join| join.ratio.clone()).collect();
    ratios.sort();
    let (quarter, four) = (Rational::new(1, 4), Rational::from(4));
    assert_eq!((c1, ratios), (46, vec![quarter.clone(), quarter, four.clone(), four.clone(), four.clone(), four]));
}

#[test]
fn the_teacup_has_four_creases() {
    let Some(folder) = folder("newell") else { return };
    let terms = Terms { require: Some(Requirement::G1), ..Terms::default() };
    let (_, audit) = checked(&folder.join("teacup.patches.txt"), &terms);
    let count = |wanted: fn(&casteljau::audit::Join) -> bool| audit.joins.iter().filter(|join| wanted(join)).count();
    assert_eq!(audit.joins.len(), 46);
    assert_eq!(count(|join| join.parametric >= Continuity::C(1)), 26);
    assert_eq!(count(|join| join.parametric < Continuity::C(1) && join.geometric == Some(1)), 16);
    assert_eq!(count(|join| join.verdict == Verdict::Violated && join.obtuse), 4);
}

#[test]
fn clough_tocher_elements_are_c1() {
    let Some(folder) = folder("hct") else { return };
    let text = std::fs::read_to_string(folder.join("hct_elements.json")).expect("a text");
    let document: serde_json::Value = serde_json::from_str(&text).expect("JSON");
    let exact = |value: &serde_json::Value| -> Rational { value.as_str().expect("a text").parse().expect("a number") };
    let (mut functions, mut joins) = (0, 0);
    for family in document["data"].as_object().expect("families").values() {
        for function in family.as_array().expect("functions") {
            let mut pieces = Vec::new();
            for piece in function["pieces"].as_array().expect("pieces") {
                let vertex = |k: usize| [0, 1].map(|axis| exact(&piece["triangle"][k][axis]));
                let vertices = [vertex(0), vertex(1), vertex(2)];
                let degree = piece["degree"].as_u64().expect("a degree") as usize;
                let rows: Vec<Vec<Vec<String>>> = (0..=degree)
                    .map(|i| {
                        (0..=degree - i)
                            .map(|j| {
                                let k = degree - i - j;
                                let place = |axis: usize| {
                                    let sum: Rational =
                                        vertices.iter().zip([i, j, k]).map(|(vertex, times)| &vertex[axis] * Rational::from(times)).sum();
                                    (sum / Rational::from(degree)).to_string()
                                };
                                let value = piece["net"][format!("{i},{j},{k}")].as_str().expect("a value").to_owned();
                                vec![place(0), place(1), value]
                            })
                            .collect()
                    })
                    .collect();
                let frame: Vec<Vec<String>> = vertices.iter().map(|vertex| vertex.iter().map(Rational::to_string).collect()).collect();
                pieces.push(serde_json::json!({"kind": "triangle", "degree": degree, "frame": frame, "points": rows}));
            }
            let model = read(&serde_json::json!({"kind": "model", "pieces": pieces}).to_string(), Format::Shape).expect("a model");
            let terms = Terms { require: Some(Requirement::C1), ..Terms::default() };
            let audit = audit(&model, &terms, None).expect("an audit");
            assert_eq!((audit.joins.len(), audit.open), (3, 3));
            assert!(audit.joins.iter().all(|join| join.verdict == Verdict::Exact), "{:?}", audit.joins);
            functions += 1;
            joins += audit.joins.len();
        }
    }
    assert!(functions >= 6 && joins == 3 * functions, "{functions} functions");
}

#[test]
fn the_smooth_nodes_of_a_font() {
    let Some(folder) = folder("glif") else { return };
    let (mut nodes, mut exact, mut rounded, mut beyond) = (0, 0, 0, 0);
    for path in files(&folder, ".glif") {
        let (_, audit) = checked(&path, &Terms::default());
        for join in audit.joins.iter().filter(|join| join.requirement.is_some()) {
            nodes += 1;
            match (join.verdict, join.rounding) {
                (Verdict::Exact, _) => exact += 1,
                (Verdict::Violated, Rounding::Yes) => rounded += 1,
                (Verdict::Violated, Rounding::No) => beyond += 1,
                other => panic!("{}: {other:?}", path.display()),
            }
        }
    }
    assert_eq!((nodes, exact, rounded, beyond), (1061, 935, 110, 16));
}

#[test]
fn one_thread_and_two_say_the_same() {
    let Some(folder) = folder("svg") else { return };
    let terms = Terms { require: Some(Requirement::G1), tolerance: "1deg".parse().expect("a tolerance"), ..Terms::default() };
    let all = || -> Vec<_> { files(&folder, ".svg").iter().map(|path| checked(path, &terms).1.joins).collect() };
    let on = |threads: usize| rayon::ThreadPoolBuilder::new().num_threads(threads).build().expect("threads").install(all);
    let (one, two) = (on(1), on(2));
    assert_eq!(one.len(), 319);
    assert!(one == two);
}
