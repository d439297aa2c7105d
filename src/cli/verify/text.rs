//! Verdicts as text, with the lines they are about.

use std::fmt::Write as _;

use annotate_snippets::Level;
use clap::ArgMatches;

use super::Checked;
use super::wording::{failure, summary};
use crate::cli::diagnostic::{Note, rendered};
use crate::syntax::{Lines, SyntaxError};
use crate::worksheet::Verdict;

/// The verdicts of all files.
pub(super) fn text(checked: &[Checked], matches: &ArgMatches, coloured: bool) -> String {
    let (list, quiet) = (matches.get_flag("list"), matches.get_flag("quiet"));
    let mut text = String::new();
    for file in checked {
        let lines = Lines::new(&file.text);
        let show = |level: Level<'static>, error: &SyntaxError, title: &str, notes: &[Note]| {
            format!("{}\n\n", rendered(level, title, (&file.path, &lines, error.span), notes, error.help.as_deref(), coloured))
        };
        for error in &file.report.errors {
            text.push_str(&show(Level::ERROR, error, &error.message, &[]));
        }
        for claim in &file.report.claims {
            match (&claim.error, claim.verdict) {
                (Some(error), _) => text.push_str(&show(Level::ERROR, error, &error.message, &[])),
                (None, Verdict::Refuted) => {
                    let title = format!("{} does not hold", claim.name.as_deref().unwrap_or("this"));
                    text.push_str(&show(Level::ERROR, &SyntaxError::new(claim.span, ""), &title, &failure(claim)));
                }
                _ if list => {
                    let shown: String = claim.span.text(&file.text).split_whitespace().collect::<Vec<_>>().join(" ");
                    let name = claim.name.as_ref().map_or_else(String::new, |name| format!("{name}: "));
                    let _ = writeln!(text, "{}:{}:{}: proved {name}{shown}", file.path, claim.line, claim.column);
                }
                _ => {}
            }
        }
        if !quiet {
            for warning in &file.report.warnings {
                text.push_str(&show(Level::WARNING, &warning.error, &warning.error.message, &[]));
            }
            let _ = writeln!(text, "{}: {}", file.path, summary(&file.report));
        }
    }
    text
}
