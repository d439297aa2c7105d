//! `verify`: every claim in worksheets.

mod command;
mod json;
mod notices;
mod pages;
mod text;
mod wording;

use std::io;
use std::path::Path;

use clap::ArgMatches;

use super::diagnostic::Problem;
use super::ending::Ending;
use super::flags::text_of;
use super::{files, tell};
use crate::model::Flaw;
use crate::report::{Notice, Obstacle, Report as Findings, github, junit, sarif};
use crate::worksheet::{self, Format, MAX_WORKSHEET_BYTES, RULES, Report, Verdict};

pub(super) use command::command;

/// A worksheet with what became of it.
struct Checked {
    path: String,
    text: String,
    report: Report,
}

/// Checks the worksheets.
pub(super) fn verify(matches: &ArgMatches, coloured: bool) -> Result<Ending, Problem> {
    let paths: Vec<String> = matches.get_many::<String>("paths").unwrap_or_default().cloned().collect();
    let on_disk: Vec<String> = paths.iter().filter(|path| *path != "-").cloned().collect();
    let is_worksheet = |path: &Path| path.extension().is_some_and(|ending| ending == "md" || ending == "cj");
    let (mut checked, mut obstacles) = (Vec::new(), Vec::new());
    let mut add = |path: String, text: Result<String, String>| match text {
        Ok(text) => {
            let report = worksheet::check(&text, Format::of_path(&path));
            checked.push(Checked { path, text, report });
        }
        Err(message) => obstacles.push(Obstacle { path, flaw: Flaw { place: None, message } }),
    };
    if paths.iter().any(|path| path == "-") {
        add("standard input".into(), files::read_within(io::stdin().lock(), MAX_WORKSHEET_BYTES as u64));
    }
    for candidate in files::collect(&on_disk, is_worksheet)? {
        add(candidate.shown(), files::text_within(&candidate.path, MAX_WORKSHEET_BYTES as u64));
    }
    let mut output = Vec::new();
    write(matches, &checked, &obstacles, coloured, &mut output).map_err(Problem::output)?;
    match text_of(matches, "output") {
        Some(path) => crate::cli::target::replace(Path::new(path), &output)?,
        None => crate::cli::print(&output)?,
    }
    if let Some(folder) = text_of(matches, "html") {
        pages::pages(Path::new(folder), &checked)?;
    }
    if text_of(matches, "format").is_some_and(|format| format == "text") {
        obstacles.iter().for_each(|obstacle| tell(&format!("{}: {}", obstacle.path, obstacle.flaw.message)));
    }
    let count = |verdict| checked.iter().map(|file| file.report.count(verdict)).sum::<usize>();
    let unreadable = !obstacles.is_empty() || checked.iter().any(|file| !file.report.errors.is_empty());
    if unreadable || count(Verdict::Error) > 0 {
        return Ok(Ending::Unusable);
    }
    if count(Verdict::Proved) + count(Verdict::Refuted) == 0 && !matches.get_flag("allow-empty") {
        tell("there is no claim to verify: claims stand in fenced blocks of the language casteljau (--allow-empty makes that a success)");
        return Ok(Ending::Unusable);
    }
    Ok(Ending::of_answer(count(Verdict::Refuted) == 0))
}

fn write(matches: &ArgMatches, checked: &[Checked], obstacles: &[Obstacle], coloured: bool, out: &mut Vec<u8>) -> io::Result<()> {
    match text_of(matches, "format").map(String::as_str) {
        Some("json") => {
            out.extend_from_slice(json::json(checked, obstacles).to_string().as_bytes());
            out.push(b'\n');
            Ok(())
        }
        Some("junit") => junit::write("casteljau verify", &checked.iter().map(notices::suite).collect::<Vec<_>>(), out),
        Some(format @ ("sarif" | "github")) => {
            let notices: Vec<Notice> = checked.iter().flat_map(notices::notices).collect();
            let findings = Findings { rules: &RULES, notices: &notices, obstacles };
            if format == "sarif" { sarif::write(&findings, out) } else { github::write(&findings, out) }
        }
        _ => {
            out.extend_from_slice(text::text(checked, matches, coloured).as_bytes());
            Ok(())
        }
    }
}
