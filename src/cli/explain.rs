//! `explain`: what the rule behind a code is about.

use std::fmt::Write as _;

use clap::{Arg, ArgMatches, Command};

use super::diagnostic::Problem;
use super::flags::text_of;
use crate::report::{Rule, joins};

/// All rules there are.
fn rules() -> impl Iterator<Item = &'static Rule> {
    joins::RULES.iter().chain(&crate::worksheet::RULES)
}

/// The command.
pub(super) fn command() -> Command {
    Command::new("explain")
        .about("Explain the rule behind a code, such as J002; without a code, list all")
        .after_help("Examples:\n  casteljau explain J002\n  casteljau explain")
        .arg(Arg::new("code").value_name("CODE").help("The code of a finding"))
        .arg(super::command::color())
}

/// What it prints.
pub(super) fn explain(matches: &ArgMatches) -> Result<String, Problem> {
    let Some(code) = text_of(matches, "code") else {
        return Ok(rules().fold(String::new(), |mut text, rule| {
            // Writing to a string does not fail.
            let _ = writeln!(text, "{}  {:<20} {}", rule.code, rule.name, rule.summary);
            text
        }));
    };
    let wanted = code.trim().to_ascii_uppercase();
    let found = rules().find(|rule| rule.code == wanted || rule.name.eq_ignore_ascii_case(code.trim()));
    let Some(rule) = found else {
        let codes: Vec<&str> = rules().map(|rule| rule.code).collect();
        return Err(Problem::plain(format!("there is no rule `{}`", crate::model::excerpt(code)))
            .with_help(format!("there are {}", codes.join(", "))));
    };
    let mut text = format!("{} {} ({})\n\n{}\n", rule.code, rule.name, rule.level.name(), rule.summary);
    for paragraph in rule.explanation.split("\n\n") {
        let _ = write!(text, "\n{}\n", wrapped(paragraph, 100));
    }
    Ok(text)
}

/// A paragraph in lines of at most so many characters, where words allow it.
fn wrapped(paragraph: &str, width: usize) -> String {
    let mut lines: Vec<String> = vec![String::new()];
    for word in paragraph.split_whitespace() {
        let last = lines.len() - 1;
        if !lines[last].is_empty() && lines[last].chars().count() + 1 + word.chars().count() > width {
            lines.push(word.to_owned());
        } else {
            if !lines[last].is_empty() {
                lines[last].push(' ');
            }
            lines[last].push_str(word);
        }
    }
    lines.join("\n")
}
