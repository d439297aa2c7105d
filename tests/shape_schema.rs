//! The published schema of shape files says what the reader takes.

use std::path::{Path, PathBuf};

use casteljau::model::{Format, read};
use serde_json::Value;

fn validator() -> jsonschema::Validator {
    let schema: Value = serde_json::from_str(include_str!("../docs/shape.schema.json")).expect("JSON");
    jsonschema::draft202012::meta::validate(&schema).expect("a schema of draft 2020-12");
    jsonschema::validator_for(&schema).expect("a schema")
}

/// The shape files of the examples and the tests.
fn shape_files() -> Vec<PathBuf> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let folders = ["examples", "tests/cli", "tests/models"];
    let entries = folders.iter().flat_map(|folder| std::fs::read_dir(root.join(folder)).expect("a folder"));
    let mut files: Vec<PathBuf> = entries.map(|entry| entry.expect("an entry").path()).collect();
    files.retain(|path| Format::of_path(path) == Some(Format::Shape));
    files.sort();
    files
}

#[test]
fn good_files_are_valid() {
    let validator = validator();
    let files = shape_files();
    assert!(files.len() >= 8, "{files:?}");
    for path in files {
        let text = std::fs::read_to_string(&path).expect("text");
        read(&text, Format::Shape).unwrap_or_else(|flaw| panic!("{}: {flaw}", path.display()));
        let value: Value = serde_json::from_str(&text).expect("JSON");
        let errors: Vec<String> = validator.iter_errors(&value).map(|error| format!("{}: {error}", error.instance_path())).collect();
        assert!(errors.is_empty(), "{}: {errors:#?}", path.display());
    }
}

/// What the schema and the reader agree to refuse; that points fit the degree
/// and vertices make a frame, only the reader sees.
#[test]
fn wrong_files_are_not() {
    let validator = validator();
    for text in [
        r#"[]"#,
        r#"{}"#,
        r#"{"kind": "blob"}"#,
        r#"{"kind": "curve", "points": [[0], [1]]}"#,
        r#"{"kind": "curve", "degree": 1}"#,
        r#"{"kind": "curve", "degree": 1, "points": [[0], [1]], "colour": 1}"#,
        r#"{"kind": "curve", "degree": -1, "points": [[0]]}"#,
        r#"{"kind": "curve", "degree": 1.5, "points": [[0], [1]]}"#,
        r#"{"kind": "curve", "degree": 4097, "points": [[0], [1]]}"#,
        r#"{"kind": "curve", "degree": [1], "points": [[0], [1]]}"#,
        r#"{"kind": "curve", "degree": 1, "points": [[0], ["1."]]}"#,
        r#"{"kind": "curve", "degree": 1, "points": [[0], ["1/0"]]}"#,
        r#"{"kind": "curve", "degree": 1, "points": [[0], ["nan"]]}"#,
        r#"{"kind": "curve", "degree": 1, "points": [[0], [null]]}"#,
        r#"{"kind": "curve", "degree": 1, "points": [[0], []]}"#,
        r#"{"kind": "curve", "degree": 1, "frame": [0], "points": [[0], [1]]}"#,
        r#"{"kind": "curve", "degree": 1, "frame": [[0, 0], [1, 0], [0, 1]], "points": [[0], [1]]}"#,
        r#"{"kind": "curve", "degree": 1, "points": [[0], [1]], "name": 7}"#,
        r#"{"kind": "triangle", "degree": 1, "points": [0, 1]}"#,
        r#"{"kind": "triangle", "degree": [1, 1], "points": [[[0], [1]], [[2]]]}"#,
        r#"{"kind": "triangle", "degree": 1, "frame": [[0, 0], [1, 0]], "points": [[[0], [1]], [[2]]]}"#,
        r#"{"kind": "rectangle", "degree": 1, "points": [[[0], [1]], [[2], [3]]]}"#,
        r#"{"kind": "rectangle", "degree": [1, 1], "frame": [0, 1], "points": [[[0], [1]], [[2], [3]]]}"#,
        r#"{"kind": "spline", "degree": 1, "points": [[0], [1]]}"#,
        r#"{"kind": "spline", "degree": 1, "frame": [0, 1], "knots": [0, 0, 1, 1], "points": [[0], [1]]}"#,
        r#"{"kind": "model"}"#,
        r#"{"kind": "model", "pieces": [{"kind": "model", "pieces": []}]}"#,
        r#"{"kind": "model", "pieces": [], "degree": 1}"#,
    ] {
        let value: Value = serde_json::from_str(text).expect("JSON");
        assert!(!validator.is_valid(&value), "the schema takes {text}");
        assert!(read(text, Format::Shape).is_err(), "the reader takes {text}");
    }
}
