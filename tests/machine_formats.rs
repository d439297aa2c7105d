//! What checkers print for machines is what the published schemas ask for.

use casteljau::model::{Flaw, Place};
use casteljau::report::junit::{Case, Outcome, Suite};
use casteljau::report::{Level, Notice, Obstacle, Report, Rule, junit, sarif};
use proptest::prelude::*;
use roxmltree::{Document, Node};
use serde_json::Value;

const RULES: &[Rule] = &[Rule {
    code: "J003",
    name: "not-smooth",
    level: Level::Error,
    summary: "Two curves meet at an angle.",
    explanation: "The handles are not on one line.\n\nMove one of them.",
}];

const SARIF: &str = include_str!("schemas/sarif-2.1.0.json");
const JUNIT: &str = include_str!("schemas/junit-10.xsd");

fn sarif_log(notices: &[Notice], obstacles: &[Obstacle]) -> Value {
    let mut out = Vec::new();
    sarif::write(&Report { rules: RULES, notices, obstacles }, &mut out).expect("a vector takes all");
    serde_json::from_slice(&out).expect("a log is JSON")
}

fn sarif_validator() -> jsonschema::Validator {
    // The pattern of languages, which logs of ours do not name, has a stray bracket.
    let mended = SARIF.replace("-[a-zA-Z]{2}]?$", "-[a-zA-Z]{2}$");
    assert_ne!(mended, SARIF, "the publisher has mended the pattern");
    let schema = serde_json::from_str(&mended).expect("the schema is JSON");
    jsonschema::options().should_validate_formats(true).build(&schema).expect("the schema is one")
}

/// Text as strangers write it: any at all, and much of what has a meaning somewhere.
fn strange() -> impl Strategy<Value = String> {
    prop_oneof![any::<String>(), "[\\x00-\\x20a:,%/\\\\.{}\\[\\]()<>&\"'κ\u{fffe}]{0,12}"]
}

prop_compose! {
    fn notices()(
        path in strange(),
        message in strange(),
        place in proptest::option::of((1..=u32::MAX, 1..=u32::MAX)),
        fingerprint in proptest::option::of(strange()),
        level in prop_oneof![Just(Level::Note), Just(Level::Warning), Just(Level::Error)],
        known: bool,
    ) -> Notice {
        let place = place.map(|(line, column)| Place { line, column });
        Notice { rule: &RULES[0], level, path, place, message, fingerprint, known }
    }
}

#[test]
fn sarif_logs_are_valid() {
    let validator = sarif_validator();
    let mut runner = proptest::test_runner::TestRunner::default();
    let strategy = (proptest::collection::vec(notices(), 0..4), proptest::collection::vec((strange(), strange()), 0..3));
    runner
        .run(&strategy, |(notices, obstacles)| {
            let obstacles: Vec<Obstacle> = obstacles
                .into_iter()
                .map(|(path, message)| Obstacle { path, flaw: Flaw::at(Place { line: 1, column: 1 }, message) })
                .collect();
            let log = sarif_log(&notices, &obstacles);
            let flaws: Vec<String> = validator.iter_errors(&log).map(|flaw| format!("{}: {flaw}", flaw.instance_path())).collect();
            prop_assert!(flaws.is_empty(), "{:#?}", flaws);
            prop_assert_eq!(log["runs"][0]["results"].as_array().map(Vec::len), Some(notices.len()));
            Ok(())
        })
        .unwrap_or_else(|failure| panic!("{failure}"));
}

#[test]
fn the_sarif_schema_sees_what_is_wrong() {
    let validator = sarif_validator();
    let place = Some(Place { line: 3, column: 7 });
    let notice =
        Notice { rule: &RULES[0], level: Level::Error, path: "a.svg".into(), place, message: "m".into(), fingerprint: None, known: true };
    let log = sarif_log(&[notice], &[]);
    assert!(validator.is_valid(&log));
    for (pointer, wrong) in [
        ("/version", Value::from("2.0.0")),
        ("/runs/0/results/0/level", Value::from("fatal")),
        ("/runs/0/results/0/message", Value::from("m")),
        ("/runs/0/results/0/locations/0/physicalLocation/region/startLine", Value::from(0)),
        ("/runs/0/results/0/locations/0/physicalLocation/artifactLocation/uri", Value::from("a b.svg")),
        ("/runs/0/results/0/suppressions/0/kind", Value::from("baseline")),
        ("/runs/0/columnKind", Value::from("bytes")),
        ("/runs/0/tool/driver/rules/0/help", Value::Null),
    ] {
        let mut log = log.clone();
        *log.pointer_mut(pointer).unwrap_or_else(|| panic!("no {pointer}")) = wrong;
        assert!(!validator.is_valid(&log), "{pointer}");
    }
}

fn junit_text(suites: &[Suite]) -> String {
    let mut out = Vec::new();
    junit::write("casteljau check", suites, &mut out).expect("a vector takes all");
    String::from_utf8(out).expect("XML is text")
}

/// Against the schema: every element is declared as a child of the one around
/// it, every attribute is declared, the required ones are there. (The schema has
/// no order among children where there can be several.)
fn undeclared<'a>(node: Node<'a, 'a>, schema: Node<'a, 'a>) -> Vec<String> {
    let of_kind = |root: Node<'a, 'a>, kind| root.descendants().filter(move |part: &Node<'_, '_>| part.tag_name().name() == kind);
    let name = node.tag_name().name();
    let declaration = schema.children().find(|part| part.tag_name().name() == "element" && part.attribute("name") == Some(name));
    let Some(declaration) = declaration else { return vec![format!("no element <{name}>")] };
    let attributes: Vec<_> = of_kind(declaration, "attribute").collect();
    let mut found = Vec::new();
    for attribute in node.attributes() {
        if !attributes.iter().any(|declared| declared.attribute("name") == Some(attribute.name())) {
            found.push(format!("<{name}> has no attribute {}", attribute.name()));
        }
    }
    for declared in attributes.iter().filter(|declared| declared.attribute("use") == Some("required")) {
        if declared.attribute("name").and_then(|attribute| node.attribute(attribute)).is_none() {
            found.push(format!("<{name}> needs {:?}", declared.attribute("name")));
        }
    }
    for child in node.children().filter(Node::is_element) {
        let child_name = child.tag_name().name();
        if of_kind(declaration, "element").any(|part| part.attribute("ref") == Some(child_name)) {
            found.extend(undeclared(child, schema));
        } else {
            found.push(format!("<{name}> has no <{child_name}>"));
        }
    }
    found
}

fn cases() -> Vec<Case> {
    let [message, detail] = ["not \"smooth\"", "3:7\n  a < b ]]>"].map(String::from);
    let outcomes = [
        Outcome::Passed,
        Outcome::Failed { rule: &RULES[0], message: message.clone(), detail: detail.clone() },
        Outcome::Skipped { message: message.clone() },
        Outcome::Error { message: message.clone(), detail },
        Outcome::Error { message, detail: String::new() },
    ];
    outcomes.into_iter().enumerate().map(|(index, outcome)| Case { name: format!("node {index}"), outcome }).collect()
}

#[test]
fn junit_documents_have_what_the_schema_declares() {
    let schema = Document::parse(JUNIT).expect("the schema is XML");
    let suites = [Suite { name: "a.glif".into(), cases: cases() }, Suite { name: "b.glif".into(), cases: vec![] }];
    let text = junit_text(&suites);
    let document = Document::parse(&text).expect("the report is XML");
    assert_eq!(undeclared(document.root_element(), schema.root_element()), Vec::<String>::new());

    let broken = text.replace("<failure type", "<failing type").replace("</failure>", "</failing>").replace(" tests=\"0\"", " odd=\"0\"");
    let document = Document::parse(&broken).expect("still XML");
    let found = undeclared(document.root_element(), schema.root_element());
    assert_eq!(found, ["<testcase> has no <failing>", "<testsuite> has no attribute odd", "<testsuite> needs Some(\"tests\")"]);
}

#[test]
fn junit_counts_are_those_of_the_cases() {
    let suites = [Suite { name: "a.glif".into(), cases: cases() }, Suite { name: "b.glif".into(), cases: cases() }];
    let text = junit_text(&suites);
    let document = Document::parse(&text).expect("the report is XML");
    let root = document.root_element();
    let elements = |node: Node<'_, '_>, name| node.descendants().filter(|part| part.has_tag_name(name)).count().to_string();
    for node in root.descendants().filter(|node| node.has_tag_name("testsuite") || node.has_tag_name("testsuites")) {
        for (attribute, element) in [("tests", "testcase"), ("failures", "failure"), ("errors", "error"), ("skipped", "skipped")] {
            // The schema has no count of the skipped ones over all suites.
            if let Some(count) = node.attribute(attribute) {
                assert_eq!(count, elements(node, element), "{attribute} of {:?}", node.tag_name());
            }
        }
    }
    assert_eq!((root.attribute("tests"), root.attribute("errors")), (Some("10"), Some("4")));
}
