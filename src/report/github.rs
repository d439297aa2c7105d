//! Reports as the workflow commands that GitHub shows beside the lines of a change.

use std::fmt::Write as _;
use std::io::{self, Write};

use super::location;
use super::notice::{Level, Report};
use crate::model::Place;

/// Writes a report as workflow commands, one a line: `::error
/// file=…,line=…,col=…,title=…::message`.
///
/// Known notices are left out: an annotation is for what a change brought. (See
/// GitHub, *Workflow commands for GitHub Actions*, "Setting an error message".)
///
/// Pieces are small: `out` should be buffered.
///
/// # Errors
/// What writing gives.
pub fn write(report: &Report<'_>, out: &mut dyn Write) -> io::Result<()> {
    for notice in report.notices.iter().filter(|notice| !notice.known) {
        let command = match notice.level {
            Level::Error => "error",
            Level::Warning => "warning",
            Level::Note => "notice",
        };
        let title = format!("{} {}", notice.rule.code, notice.rule.name);
        annotate(out, command, &notice.path, notice.place, &title, &notice.message)?;
    }
    for obstacle in report.obstacles {
        annotate(out, "error", &obstacle.path, obstacle.flaw.place, "cannot be examined", &obstacle.flaw.message)?;
    }
    Ok(())
}

fn annotate(out: &mut dyn Write, command: &str, path: &str, place: Option<Place>, title: &str, message: &str) -> io::Result<()> {
    let mut properties = format!("file={}", property(&location::path(path)));
    if let Some(Place { line, column }) = place {
        // Writing to a string does not fail.
        let _ = write!(properties, ",line={line},col={column}");
    }
    writeln!(out, "::{command} {properties},title={}::{}", property(title), data(message))
}

/// A message, in which what would end the line is escaped.
fn data(text: &str) -> String {
    text.replace('%', "%25").replace('\r', "%0D").replace('\n', "%0A")
}

/// The value of a property, in which what would end the value is escaped too.
fn property(text: &str) -> String {
    data(text).replace(':', "%3A").replace(',', "%2C")
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;
    use crate::report::notice::samples::{HOSTILE, RULES, notice, obstacle};
    use crate::report::notice::{Notice, Obstacle};

    fn text(notices: &[Notice], obstacles: &[Obstacle]) -> String {
        let mut out = Vec::new();
        write(&Report { rules: &RULES, notices, obstacles }, &mut out).expect("a vector takes all");
        String::from_utf8(out).expect("commands are text")
    }

    /// The runner's side: the command, its properties and its message.
    fn parsed(line: &str) -> (String, Vec<(String, String)>, String) {
        let unescaped =
            |text: &str| text.replace("%0D", "\r").replace("%0A", "\n").replace("%3A", ":").replace("%2C", ",").replace("%25", "%");
        let (head, message) = line.strip_prefix("::").and_then(|rest| rest.split_once("::")).expect("a command");
        let (command, properties) = head.split_once(' ').expect("properties");
        let properties = properties
            .split(',')
            .map(|pair| pair.split_once('=').expect("a name and a value"))
            .map(|(name, value)| (name.to_owned(), unescaped(value)))
            .collect();
        (command.to_owned(), properties, unescaped(message))
    }

    #[test]
    fn commands_are_those_of_the_documentation() {
        let whole = Notice { place: None, level: Level::Note, ..notice(1, "./b.md", "x == x") };
        let known = Notice { known: true, ..notice(0, "c.svg", "an old one") };
        assert_eq!(
            text(&[notice(0, "a,b.svg", "50% off:\nhere"), whole, known], &[obstacle("d.svg", "not XML")]),
            "::error file=a%2Cb.svg,line=3,col=7,title=J003 not-smooth::50%25 off:%0Ahere\n\
             ::notice file=b.md,title=W001 trivial::x == x\n\
             ::error file=d.svg,line=1,col=2,title=cannot be examined::not XML\n"
        );
        assert_eq!(text(&[], &[]), "");
    }

    fn comes_back(path: &str, message: &str) {
        let commands = text(&[notice(1, path, message)], &[]);
        assert_eq!(commands.matches('\n').count(), 1, "{commands:?}");
        let (command, properties, told) = parsed(commands.trim_end_matches('\n'));
        let place = [("line", "3"), ("col", "7"), ("title", "W001 trivial")].map(|(name, value)| (name.into(), value.into()));
        let mut expected = vec![("file".to_owned(), location::path(path))];
        expected.extend(place);
        assert_eq!((command.as_str(), properties, told.as_str()), ("warning", expected, message));
    }

    #[test]
    fn hostile_text_comes_back() {
        for path in HOSTILE {
            for message in HOSTILE {
                comes_back(path, message);
            }
        }
    }

    proptest! {
        #[test]
        fn any_text_comes_back(path in any::<String>(), message in any::<String>()) {
            comes_back(&path, &message);
        }
    }
}
