//! The exact cases of `tests/vectors/`, asked through `batch` and compared with `==`.

mod normal;

use std::fmt::Write as _;

use serde_json::Value;

/// The operations that this version answers.
fn is_answered(op: &str) -> bool {
    let kinds = ["curve.", "triangle.", "rectangle.", "convert.", "rational.", "join.", "geometric.", "bspline."];
    kinds.iter().any(|kind| op.starts_with(kind))
        || matches!(op, "homogenize" | "roots.bernstein" | "cubic.classify" | "implicit.curve" | "quadric.surface")
}

fn cases(file: &str) -> Vec<Value> {
    let path = format!("{}/tests/vectors/{file}", env!("CARGO_MANIFEST_DIR"));
    let text = std::fs::read_to_string(&path).unwrap_or_else(|error| panic!("{path}: {error}"));
    let document: Value = serde_json::from_str(&text).expect("the vectors are JSON");
    document["cases"].as_array().expect("a list of cases").clone()
}

fn answers(requests: &str) -> Vec<Value> {
    let mut output = Vec::new();
    casteljau::batch::run(requests.as_bytes(), &mut output).expect("reading and writing memory");
    let text = String::from_utf8(output).expect("answers are UTF-8");
    text.lines().map(|line| serde_json::from_str(line).expect("every answer is JSON")).collect()
}

fn check(file: &str, expected_count: usize) {
    let cases: Vec<Value> = cases(file).into_iter().filter(|case| case["op"].as_str().is_some_and(is_answered)).collect();
    let mut requests = String::new();
    for case in &cases {
        writeln!(requests, "{}", serde_json::json!({"id": case["id"], "op": case["op"], "input": case["input"]})).expect("a string");
    }
    let answers = answers(&requests);
    assert_eq!(answers.len(), cases.len());
    for (case, answer) in cases.iter().zip(&answers) {
        assert_eq!(answer["id"], case["id"]);
        assert_eq!(answer["op"], case["op"]);
        let (mut output, mut expected) = (answer["output"].clone(), case["expect"].clone());
        if case["op"] == "cubic.classify" {
            normal::check(&case["input"]["curve"], &output["normal"], &expected["normal"]);
            for value in [&mut output, &mut expected] {
                value.as_object_mut().expect("an object").remove("normal");
            }
        }
        assert_eq!(output, expected, "{}", case["id"]);
    }
    assert_eq!(cases.len(), expected_count, "cases of {file} that are answered");
}

#[test]
fn the_textbook_cases_hold() {
    check("textbook.json", 92);
}

#[test]
fn the_general_cases_hold() {
    check("general.json", 768);
}
