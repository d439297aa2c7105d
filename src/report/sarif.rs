//! Reports as logs in the Static Analysis Results Interchange Format.
//!
//! Source: OASIS, *Static Analysis Results Interchange Format (SARIF) Version
//! 2.1.0*; sections are named where something follows from them.

use std::io::{self, Write};

use serde::{Serialize, Serializer};

use super::location;
use super::notice::{Notice, Obstacle, Report, Rule};
use crate::model::Place;

/// The name under which fingerprints are kept, with the version of how they are made.
const FINGERPRINT: &str = "casteljau/v1";

/// Writes a report as a SARIF log.
///
/// Paths become relative references wherever they are relative. Notices that a
/// baseline knows are suppressed externally, which tells consumers not to
/// show them. Files that could not be examined are notifications, and the
/// execution then counts as unsuccessful.
///
/// Pieces are small: `out` should be buffered.
///
/// # Errors
/// What writing gives.
pub fn write(report: &Report<'_>, out: &mut dyn Write) -> io::Result<()> {
    let log = Log {
        schema: "https://json.schemastore.org/sarif-2.1.0.json",
        version: "2.1.0",
        runs: [Run {
            tool: Tool { driver: Driver::new(report.rules) },
            invocations: [Invocation {
                execution_successful: report.obstacles.is_empty(),
                tool_execution_notifications: report.obstacles.iter().map(Notification::of).collect(),
            }],
            column_kind: "unicodeCodePoints",
            results: report,
        }],
    };
    serde_json::to_writer_pretty(&mut *out, &log)?;
    writeln!(out)
}

#[derive(Serialize)]
struct Log<'a> {
    #[serde(rename = "$schema")]
    schema: &'static str,
    version: &'static str,
    runs: [Run<'a>; 1],
}

#[derive(Serialize)]
#[serde(rename_all = "camelCase")]
struct Run<'a> {
    tool: Tool<'a>,
    invocations: [Invocation; 1],
    column_kind: &'static str,
    #[serde(serialize_with = "results")]
    results: &'a Report<'a>,
}

#[derive(Serialize)]
struct Tool<'a> {
    driver: Driver<'a>,
}

#[derive(Serialize)]
#[serde(rename_all = "camelCase")]
struct Driver<'a> {
    name: &'static str,
    version: &'static str,
    semantic_version: &'static str,
    #[serde(skip_serializing_if = "str::is_empty")]
    information_uri: &'static str,
    rules: Vec<Descriptor<'a>>,
}

impl<'a> Driver<'a> {
    fn new(rules: &'a [Rule]) -> Self {
        Self {
            name: env!("CARGO_PKG_NAME"),
            version: env!("CARGO_PKG_VERSION"),
            semantic_version: env!("CARGO_PKG_VERSION"),
            information_uri: env!("CARGO_PKG_REPOSITORY"),
            rules: rules.iter().map(Descriptor::of).collect(),
        }
    }
}

#[derive(Serialize)]
#[serde(rename_all = "camelCase")]
struct Descriptor<'a> {
    id: &'a str,
    name: &'a str,
    short_description: Message,
    full_description: Message,
    help: Message,
    default_configuration: Configuration,
}

impl<'a> Descriptor<'a> {
    fn of(rule: &'a Rule) -> Self {
        Self {
            id: rule.code,
            name: rule.name,
            short_description: Message::of(rule.summary),
            // The first paragraph: what comes behind is help.
            full_description: Message::of(rule.explanation.split("\n\n").next().unwrap_or_default()),
            help: Message::of(rule.explanation),
            default_configuration: Configuration { level: rule.level.name() },
        }
    }
}

#[derive(Serialize)]
struct Configuration {
    level: &'static str,
}

#[derive(Serialize)]
struct Message {
    text: String,
}

impl Message {
    /// Plain text, in which braces are doubled because `{0}` stands for an
    /// argument (3.11.5), and no bracket is followed by a parenthesis because
    /// `[1](2)` is a link (3.11.6), which nothing outside a link can escape.
    fn of(text: &str) -> Self {
        Self { text: text.replace('{', "{{").replace('}', "}}").replace("](", "] (") }
    }
}

#[derive(Serialize)]
#[serde(rename_all = "camelCase")]
struct Invocation {
    execution_successful: bool,
    tool_execution_notifications: Vec<Notification>,
}

#[derive(Serialize)]
struct Notification {
    level: &'static str,
    message: Message,
    locations: [Location; 1],
}

impl Notification {
    fn of(obstacle: &Obstacle) -> Self {
        Self {
            level: "error",
            message: Message::of(&obstacle.flaw.message),
            locations: [Location::of(&obstacle.path, obstacle.flaw.place)],
        }
    }
}

#[derive(Serialize)]
#[serde(rename_all = "camelCase")]
struct Location {
    physical_location: PhysicalLocation,
}

#[derive(Serialize)]
#[serde(rename_all = "camelCase")]
struct PhysicalLocation {
    artifact_location: ArtifactLocation,
    #[serde(skip_serializing_if = "Option::is_none")]
    region: Option<Region>,
}

#[derive(Serialize)]
struct ArtifactLocation {
    uri: String,
}

#[derive(Serialize)]
#[serde(rename_all = "camelCase")]
struct Region {
    start_line: u32,
    start_column: u32,
}

impl Location {
    fn of(path: &str, place: Option<Place>) -> Self {
        Self {
            physical_location: PhysicalLocation {
                artifact_location: ArtifactLocation { uri: location::uri(path) },
                region: place.map(|place| Region { start_line: place.line, start_column: place.column }),
            },
        }
    }
}

#[derive(Serialize)]
#[serde(rename_all = "camelCase")]
struct Finding<'a> {
    rule_id: &'a str,
    #[serde(skip_serializing_if = "Option::is_none")]
    rule_index: Option<usize>,
    level: &'static str,
    message: Message,
    locations: [Location; 1],
    #[serde(skip_serializing_if = "Option::is_none")]
    partial_fingerprints: Option<Fingerprints<'a>>,
    #[serde(skip_serializing_if = "Option::is_none")]
    suppressions: Option<Vec<Suppression>>,
}

struct Fingerprints<'a>(&'a str);

impl Serialize for Fingerprints<'_> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_map([(FINGERPRINT, self.0)])
    }
}

#[derive(Serialize)]
struct Suppression {
    kind: &'static str,
    status: &'static str,
}

/// The results one by one: a log of many is not held in memory.
fn results<S: Serializer>(report: &&Report<'_>, serializer: S) -> Result<S::Ok, S::Error> {
    // Either all results say whether they are suppressed or none does (3.27.23).
    let is_known = report.notices.iter().any(|notice| notice.known);
    serializer.collect_seq(report.notices.iter().map(|notice| finding(notice, report.rules, is_known)))
}

fn finding<'a>(notice: &'a Notice, rules: &[Rule], is_known: bool) -> Finding<'a> {
    let external = Suppression { kind: "external", status: "accepted" };
    Finding {
        rule_id: notice.rule.code,
        rule_index: rules.iter().position(|rule| rule.code == notice.rule.code),
        level: notice.level.name(),
        message: Message::of(&notice.message),
        locations: [Location::of(&notice.path, notice.place)],
        partial_fingerprints: notice.fingerprint.as_deref().map(Fingerprints),
        suppressions: is_known.then(|| if notice.known { vec![external] } else { vec![] }),
    }
}

#[cfg(test)]
mod tests {
    use serde_json::{Value, json};

    use super::*;
    use crate::report::notice::samples::{HOSTILE, RULES, notice, obstacle};

    fn log(notices: &[Notice], obstacles: &[Obstacle]) -> Value {
        let mut out = Vec::new();
        write(&Report { rules: &RULES, notices, obstacles }, &mut out).expect("a vector takes all");
        assert!(out.ends_with(b"}\n"));
        serde_json::from_slice(&out).expect("a log is JSON")
    }

    #[test]
    fn a_log_in_full() {
        let unlike = Notice { place: None, fingerprint: None, ..notice(1, "b c.md", "x == x") };
        let known = Notice { known: true, level: crate::report::Level::Note, ..notice(0, "./c.svg", "an old one") };
        let found = log(&[notice(0, "a.svg", "a corner"), unlike, known], &[obstacle("d.svg", "not XML")]);
        let descriptor = |rule: &Rule, first: &str, help: &str| {
            json!({
                "id": rule.code, "name": rule.name, "shortDescription": {"text": rule.summary},
                "fullDescription": {"text": first}, "help": {"text": help}, "defaultConfiguration": {"level": rule.level.name()},
            })
        };
        let location =
            |uri: &str| json!({"physicalLocation": {"artifactLocation": {"uri": uri}, "region": {"startLine": 3, "startColumn": 7}}});
        assert_eq!(
            found,
            json!({
                "$schema": "https://json.schemastore.org/sarif-2.1.0.json",
                "version": "2.1.0",
                "runs": [{
                    "tool": {"driver": {
                        "name": "casteljau", "version": env!("CARGO_PKG_VERSION"), "semanticVersion": env!("CARGO_PKG_VERSION"),
                        "rules": [
                            descriptor(&RULES[0], "The handles are not on one line.", RULES[0].explanation),
                            descriptor(&RULES[1], "x == x says nothing, whatever {{x}} is.", "x == x says nothing, whatever {{x}} is."),
                        ],
                    }},
                    "invocations": [{"executionSuccessful": false, "toolExecutionNotifications": [{
                        "level": "error", "message": {"text": "not XML"},
                        "locations": [{"physicalLocation": {
                            "artifactLocation": {"uri": "d.svg"}, "region": {"startLine": 1, "startColumn": 2},
                        }}],
                    }]}],
                    "columnKind": "unicodeCodePoints",
                    "results": [
                        {
                            "ruleId": "J003", "ruleIndex": 0, "level": "error", "message": {"text": "a corner"},
                            "locations": [location("a.svg")], "partialFingerprints": {"casteljau/v1": "0f1e"}, "suppressions": [],
                        },
                        {
                            "ruleId": "W001", "ruleIndex": 1, "level": "warning", "message": {"text": "x == x"},
                            "locations": [{"physicalLocation": {"artifactLocation": {"uri": "b%20c.md"}}}], "suppressions": [],
                        },
                        {
                            "ruleId": "J003", "ruleIndex": 0, "level": "note", "message": {"text": "an old one"},
                            "locations": [location("c.svg")], "partialFingerprints": {"casteljau/v1": "0f1e"},
                            "suppressions": [{"kind": "external", "status": "accepted"}],
                        },
                    ],
                }],
            })
        );
    }

    #[test]
    fn without_a_baseline_nothing_is_said_of_suppression() {
        let found = log(&[notice(0, "a.svg", "a corner")], &[]);
        assert_eq!(found["runs"][0]["results"][0].get("suppressions"), None);
        assert_eq!(found["runs"][0]["invocations"], json!([{"executionSuccessful": true, "toolExecutionNotifications": []}]));
    }

    /// What a consumer shows of a message without arguments.
    fn shown(text: &str) -> String {
        let mut letters = text.chars();
        let mut shown = String::new();
        while let Some(letter) = letters.next() {
            if matches!(letter, '{' | '}') {
                assert_eq!(letters.next(), Some(letter), "a placeholder in {text:?}");
            }
            shown.push(letter);
        }
        shown
    }

    #[test]
    fn hostile_text_comes_back() {
        for hostile in HOSTILE {
            let found = log(&[notice(0, "a.svg", hostile)], &[obstacle("b.svg", hostile)]);
            let run = &found["runs"][0];
            for message in [&run["results"][0]["message"], &run["invocations"][0]["toolExecutionNotifications"][0]["message"]] {
                let text = message["text"].as_str().unwrap_or_default();
                assert!(!text.contains("]("), "a link in {text:?}");
                assert_eq!(shown(text), hostile.replace("](", "] ("));
            }
        }
    }
}
