//! Control points of cubics whose class other projects publish in their tests.
//!
//! The list is not part of this repository: `CASTELJAU_DATA` names the folder
//! that holds `cubic_classes.json`; without it the test says so and passes.

use std::fmt::Write as _;

use casteljau::{CubicClass, Rational, Surd, classify_rationals};
use serde_json::{Value, json};

fn surd(value: &Value) -> Surd {
    let number = |key: &str| value[key].as_str().expect("a number").parse::<Rational>().expect("a number");
    Surd::new(number("a"), value["sgn"].as_i64().expect("a sign") as i8, number("rad")).expect("a radicand")
}

/// A number as it is published: `1/2`, or `-3 - sqrt(5/4)`.
fn published(value: &Value) -> Surd {
    let text = value.as_str().expect("a text");
    let number = |text: &str| text.parse::<Rational>().expect("a number");
    match text.split_once("sqrt(") {
        None => Surd::from(number(text)),
        Some((before, radicand)) => {
            let (rational, sign) = before.trim().rsplit_once(' ').expect("a sign between blanks");
            Surd::new(number(rational), if sign == "-" { -1 } else { 1 }, number(radicand.trim_end_matches(')'))).expect("a radicand")
        }
    }
}

/// The name of the class in the list.
fn name(class: CubicClass, is_point: bool) -> String {
    match class {
        CubicClass::Straight if is_point => "point".to_owned(),
        CubicClass::Straight => "line".to_owned(),
        other => other.loop_blinn_name().replace(' ', "_"),
    }
}

#[test]
fn published_classes_agree() {
    let Some(folder) = std::env::var_os("CASTELJAU_DATA") else {
        eprintln!("skipped: CASTELJAU_DATA does not name a folder with cubic_classes.json");
        return;
    };
    let path = std::path::Path::new(&folder).join("cubic_classes.json");
    let text = std::fs::read_to_string(&path).unwrap_or_else(|error| panic!("{}: {error}", path.display()));
    let document: Value = serde_json::from_str(&text).expect("the list is JSON");
    let cases = document["cases"].as_array().expect("a list of cases");
    let mut requests = String::new();
    for case in cases {
        let request = json!({"id": case["id"], "op": "cubic.classify", "input": {"points": case["control_points"]}});
        writeln!(requests, "{request}").expect("a string");
    }
    let mut output = Vec::new();
    casteljau::batch::run(requests.as_bytes(), &mut output).expect("reading and writing memory");
    let answers = String::from_utf8(output).expect("answers are UTF-8");
    let mut seen = std::collections::BTreeMap::new();
    for (case, line) in cases.iter().zip(answers.lines()) {
        let answer: Value = serde_json::from_str(line).expect("an answer is JSON");
        let (id, found, exact) = (&case["id"], &answer["output"], &case["exact"]);
        let polygon: Vec<Rational> = case["control_points"]
            .as_array()
            .expect("a list")
            .iter()
            .flat_map(|point| point.as_array().expect("a point"))
            .map(|number| number.as_str().expect("a text").parse().expect("a number"))
            .collect();
        let polygon: [Rational; 8] = polygon.try_into().expect("four points");
        let class = classify_rationals(&[polygon])[0];
        assert_eq!(found["class"], class.name(), "{id}: from the array and from the equation");
        let whole = name(class, found["straight"]["image"] == "point");
        assert_eq!(exact["class_whole_line"], whole.as_str(), "{id}");
        let shape = found["segment"]["shape"].as_str().expect("a shape");
        assert_eq!(exact["class_on_unit_interval"], shape, "{id}");
        let expected = |name: &str| match &case["expected"] {
            Value::Array(names) => names.iter().any(|expected| expected == name),
            expected => expected == name,
        };
        assert!(expected(if case["scope"] == "unit" { shape } else { &whole }), "{id}: {} is published", case["expected"]);
        let list = |value: &Value, read: fn(&Value) -> Surd| -> Vec<Surd> { value.as_array().into_iter().flatten().map(read).collect() };
        let flexes: Vec<Surd> = found["flexes"].as_array().into_iter().flatten().map(|flex| surd(&flex["t"])).collect();
        // At a cusp the list counts no flex.
        assert_eq!(flexes, list(&exact["inflection_params"], published), "{id}");
        assert_eq!(list(&found["crunode"]["t"], surd), list(&exact["double_point_params"], published), "{id}");
        assert_eq!(
            found["cusp"].is_object().then(|| surd(&found["cusp"]["t"])),
            exact["cusp_param"].is_string().then(|| published(&exact["cusp_param"])),
            "{id}"
        );
        *seen.entry(whole).or_insert(0) += 1;
    }
    assert_eq!(answers.lines().count(), cases.len());
    assert!(cases.len() >= 271 && seen.len() >= 6, "{seen:?}");
    println!("{} published cases agree: {seen:?}", cases.len());
}
