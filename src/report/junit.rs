//! Reports as the JUnit XML that systems for continuous integration read.
//!
//! The elements and attributes are those of `junit-10.xsd` of the Jenkins xUnit
//! plugin, the strictest schema in wide use. No times are written: they would
//! differ from run to run.

use std::io::{self, Write};

use super::notice::Rule;
use super::xml::escape;

/// The cases of one file.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Suite {
    /// The file, as the user names it.
    pub name: String,
    /// What was examined in it.
    pub cases: Vec<Case>,
}

/// One thing that was examined.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Case {
    /// A name that no other case of its suite has: readers tell cases apart by it.
    pub name: String,
    /// How it went.
    pub outcome: Outcome,
}

/// How an examination went.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Outcome {
    /// It holds.
    Passed,
    /// It does not hold.
    Failed {
        /// What was looked for.
        rule: &'static Rule,
        /// One line.
        message: String,
        /// All there is to say, in lines; may be empty.
        detail: String,
    },
    /// It fails nothing although it was not shown to hold.
    Skipped {
        /// Why.
        message: String,
    },
    /// It could not be decided, or the file could not be read.
    Error {
        /// One line.
        message: String,
        /// All there is to say, in lines; may be empty.
        detail: String,
    },
}

/// How many cases there are, and how many of them went otherwise than well.
#[derive(Clone, Copy, Default)]
struct Counts {
    tests: usize,
    failures: usize,
    errors: usize,
    skipped: usize,
}

impl Counts {
    fn of(suite: &Suite) -> Self {
        let mut counts = Self::default();
        for case in &suite.cases {
            counts.tests += 1;
            match case.outcome {
                Outcome::Passed => {}
                Outcome::Failed { .. } => counts.failures += 1,
                Outcome::Skipped { .. } => counts.skipped += 1,
                Outcome::Error { .. } => counts.errors += 1,
            }
        }
        counts
    }
}

/// Writes suites as a JUnit XML document with this name.
///
/// Pieces are small: `out` should be buffered.
///
/// # Errors
/// What writing gives.
pub fn write(name: &str, suites: &[Suite], out: &mut dyn Write) -> io::Result<()> {
    let total = suites.iter().map(Counts::of).fold(Counts::default(), |sum, counts| Counts {
        tests: sum.tests + counts.tests,
        failures: sum.failures + counts.failures,
        errors: sum.errors + counts.errors,
        skipped: sum.skipped + counts.skipped,
    });
    writeln!(out, "<?xml version=\"1.0\" encoding=\"UTF-8\"?>")?;
    let Counts { tests, failures, errors, .. } = total;
    writeln!(out, "<testsuites name=\"{}\" tests=\"{tests}\" failures=\"{failures}\" errors=\"{errors}\">", escape(name))?;
    for suite in suites {
        let Counts { tests, failures, errors, skipped } = Counts::of(suite);
        let name = escape(&suite.name);
        writeln!(out, "  <testsuite name=\"{name}\" tests=\"{tests}\" failures=\"{failures}\" errors=\"{errors}\" skipped=\"{skipped}\">")?;
        for case in &suite.cases {
            write!(out, "    <testcase name=\"{}\" classname=\"{name}\"", escape(&case.name))?;
            match &case.outcome {
                Outcome::Passed => writeln!(out, "/>")?,
                Outcome::Skipped { message } => {
                    writeln!(out, ">\n      <skipped message=\"{}\"/>\n    </testcase>", escape(message))?;
                }
                Outcome::Failed { rule, message, detail } => trouble(out, "failure", rule.code, message, detail)?,
                Outcome::Error { message, detail } => trouble(out, "error", "error", message, detail)?,
            }
        }
        writeln!(out, "  </testsuite>")?;
    }
    writeln!(out, "</testsuites>")
}

/// The rest of a case that did not go well.
fn trouble(out: &mut dyn Write, element: &str, kind: &str, message: &str, detail: &str) -> io::Result<()> {
    write!(out, ">\n      <{element} type=\"{}\" message=\"{}\"", escape(kind), escape(message))?;
    if detail.is_empty() { writeln!(out, "/>\n    </testcase>") } else { writeln!(out, ">{}</{element}>\n    </testcase>", lines(detail)) }
}

/// Text of an element, in which line feeds stay what they are: only attributes
/// lose them.
fn lines(text: &str) -> String {
    escape(text).replace("&#10;", "\n")
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;
    use roxmltree::{Document, Node};

    use super::*;
    use crate::report::notice::samples::{HOSTILE, RULES};

    fn text(suites: &[Suite]) -> String {
        let mut out = Vec::new();
        write("casteljau check", suites, &mut out).expect("a vector takes all");
        String::from_utf8(out).expect("XML is text")
    }

    fn case(name: &str, outcome: Outcome) -> Case {
        Case { name: name.into(), outcome }
    }

    fn failed(message: &str, detail: &str) -> Outcome {
        Outcome::Failed { rule: &RULES[0], message: message.into(), detail: detail.into() }
    }

    fn error(message: &str, detail: &str) -> Outcome {
        Outcome::Error { message: message.into(), detail: detail.into() }
    }

    #[test]
    fn a_document_as_ci_systems_read_it() {
        let suites = [
            Suite {
                name: "fonts/a.glif".into(),
                cases: vec![
                    case("contour 0, node 3", Outcome::Passed),
                    case("contour 0, node 6", failed("not \"smooth\"", "at 3:7\n  a < b")),
                    case("contour 1, node 0", Outcome::Skipped { message: "in the baseline".into() }),
                ],
            },
            Suite { name: "b.svg".into(), cases: vec![case("b.svg", error("not XML", ""))] },
            Suite { name: "empty.svg".into(), cases: vec![] },
        ];
        assert_eq!(
            text(&suites),
            r#"<?xml version="1.0" encoding="UTF-8"?>
<testsuites name="casteljau check" tests="4" failures="1" errors="1">
  <testsuite name="fonts/a.glif" tests="3" failures="1" errors="0" skipped="1">
    <testcase name="contour 0, node 3" classname="fonts/a.glif"/>
    <testcase name="contour 0, node 6" classname="fonts/a.glif">
      <failure type="J003" message="not &quot;smooth&quot;">at 3:7
  a &lt; b</failure>
    </testcase>
    <testcase name="contour 1, node 0" classname="fonts/a.glif">
      <skipped message="in the baseline"/>
    </testcase>
  </testsuite>
  <testsuite name="b.svg" tests="1" failures="0" errors="1" skipped="0">
    <testcase name="b.svg" classname="b.svg">
      <error type="error" message="not XML"/>
    </testcase>
  </testsuite>
  <testsuite name="empty.svg" tests="0" failures="0" errors="0" skipped="0">
  </testsuite>
</testsuites>
"#
        );
    }

    fn child<'a>(node: Node<'a, 'a>, name: &str) -> Node<'a, 'a> {
        node.children().find(|child| child.has_tag_name(name)).unwrap_or_else(|| panic!("no <{name}> in {node:?}"))
    }

    /// What XML can say of a text.
    fn sayable(text: &str) -> String {
        let shown = |letter| match letter {
            '\t' | '\n' | '\r' => letter,
            '\0'..='\u{1f}' => char::from_u32(0x2400 + letter as u32).expect("a picture"),
            '\u{fffe}' | '\u{ffff}' => '\u{fffd}',
            _ => letter,
        };
        text.chars().map(shown).collect()
    }

    fn comes_back(name: &str, message: &str, detail: &str) {
        let outcomes = [failed(message, detail), error(message, detail), Outcome::Skipped { message: message.into() }];
        for (outcome, element) in outcomes.into_iter().zip(["failure", "error", "skipped"]) {
            let text = text(&[Suite { name: name.into(), cases: vec![case(name, outcome)] }]);
            let document = Document::parse(&text).unwrap_or_else(|error| panic!("{error}: {text:?}"));
            let suite = child(document.root_element(), "testsuite");
            let case = child(suite, "testcase");
            for node in [suite, case] {
                assert_eq!(node.attribute("name"), Some(sayable(name).as_str()));
            }
            let trouble = child(case, element);
            assert_eq!(trouble.attribute("message"), Some(sayable(message).as_str()));
            let said: String = trouble.children().filter_map(|part| part.text()).collect();
            assert_eq!(said, if element == "skipped" { String::new() } else { sayable(detail) });
        }
    }

    #[test]
    fn hostile_text_comes_back() {
        for name in HOSTILE {
            for detail in HOSTILE {
                comes_back(name, detail, detail);
            }
        }
    }

    proptest! {
        #[test]
        fn any_text_comes_back(name in any::<String>(), message in any::<String>(), detail in any::<String>()) {
            comes_back(&name, &message, &detail);
        }
    }
}
