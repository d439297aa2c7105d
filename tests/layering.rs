//! Imports point downward: the layers of `lib.rs` are kept.

use std::path::{Path, PathBuf};

/// From the bottom up; modules of one layer may use each other.
const LAYERS: &[&[&str]] = &[
    &["error", "name"],
    &["exact"],
    &["symbolic"],
    &["syntax"],
    &["kernel"],
    &["affine"],
    &[
        "reading",
        "control",
        "blossom",
        "curve",
        "surface",
        "segment",
        "side",
        "triangular",
        "rectangular",
        "piece",
        "weights",
        "scheme",
        "tetrahedron",
        "bilinear",
        "bernstein",
        "symmetry",
        "hull",
        "flatness",
        "mesh",
        "matrix",
        "roots",
        "continuity",
        "geometric",
        "spline",
        "joint",
        "smoothness",
        "tangent",
        "repair",
        "meeting",
        "quotient",
        "algebraic",
    ],
    &["cubic", "implicit", "quadric"],
    &["value", "model"],
    &["audit"],
    &["report", "draw"],
    &["ops"],
    &["worksheet"],
    &["cli", "batch"],
    &["main", "lib"],
];

fn layer(module: &str) -> usize {
    LAYERS
        .iter()
        .position(|layer| layer.contains(&module))
        .unwrap_or_else(|| panic!("`{module}` is in no layer: add it to LAYERS and to lib.rs"))
}

fn sources(folder: &Path, found: &mut Vec<PathBuf>) {
    for entry in std::fs::read_dir(folder).expect("a folder") {
        let path = entry.expect("an entry").path();
        if path.is_dir() {
            sources(&path, found);
        } else if path.extension().is_some_and(|extension| extension == "rs") {
            found.push(path);
        }
    }
}

/// The top modules that a text names behind `crate::`, comments left out.
fn imports(text: &str) -> Vec<String> {
    let code: Vec<&str> = text.lines().filter(|line| !line.trim_start().starts_with("//")).collect();
    code.join("\n")
        .split("crate::")
        .skip(1)
        .map(|rest| rest.chars().take_while(|letter| letter.is_alphanumeric() || *letter == '_').collect())
        .collect()
}

#[test]
fn imports_point_downward() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("src");
    let mut files = Vec::new();
    sources(&root, &mut files);
    let mut upward = Vec::new();
    let mut seen = 0;
    for file in &files {
        let relative = file.strip_prefix(&root).expect("below src");
        let first = relative.components().next().expect("a name").as_os_str().to_string_lossy();
        let module = first.trim_end_matches(".rs");
        if module == "lib" {
            continue;
        }
        for import in imports(&std::fs::read_to_string(file).expect("a source file")) {
            seen += 1;
            if layer(&import) > layer(module) {
                upward.push(format!("{} uses crate::{import}", relative.display()));
            }
        }
    }
    assert!(seen > 100, "only {seen} imports were found");
    assert!(upward.is_empty(), "{upward:#?}");
}

#[test]
fn the_test_sees_an_upward_import() {
    assert_eq!(imports("use crate::ops::X;\n// use crate::cli::Y;\nfn f() { crate::exact::g() }"), ["ops", "exact"]);
    assert!(layer("ops") > layer("exact"));
}
