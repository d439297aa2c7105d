//! `verify`: every claim in worksheets.

use std::collections::BTreeMap;
use std::fmt::Write as _;
use std::io;
use std::path::Path;

use annotate_snippets::Level;
use clap::{Arg, ArgAction, ArgMatches, Command};
use serde_json::{Value, json};

use super::diagnostic::{Note, Problem, rendered};
use super::ending::Ending;
use super::flags::text_of;
use super::{files, tell};
use crate::model::{Flaw, Place, Places};
use crate::report::junit::{Case, Outcome, Suite};
use crate::report::{Notice, Obstacle, Report as Findings, github, junit, sarif};
use crate::syntax::{Lines, SyntaxError};
use crate::worksheet::{self, Claim, Format, MAX_WORKSHEET_BYTES, RULES, Report, Verdict};

pub(super) fn command() -> Command {
    Command::new("verify")
        .about("Prove or refute every claim in worksheets: made for CI")
        .after_help(format!(
            "Examples:\n  casteljau verify notes.md chapters/\n  casteljau verify --list examples/chapter18.md\n  \
             casteljau verify --format json notes.md\n\n\
             The language is in docs/worksheets.md. Exit status: 0 every claim is proved, 1 one is refuted, 2 one cannot be\n\
             decided or read, or there is none. Limit: {MAX_WORKSHEET_BYTES} bytes a worksheet."
        ))
        .arg(
            Arg::new("paths")
                .value_name("PATH")
                .num_args(1..)
                .required(true)
                .help("Worksheets (Markdown, or statements alone in .cj), folders of them, or `-` for standard input"),
        )
        .arg(Arg::new("list").long("list").action(ArgAction::SetTrue).help("Also print what was proved"))
        .arg(
            Arg::new("format")
                .long("format")
                .value_name("FORMAT")
                .value_parser(["text", "json", "sarif", "junit", "github"])
                .default_value("text")
                .help("How to print the verdicts"),
        )
        .arg(Arg::new("output").short('o').long("output").value_name("FILE").help("Write the verdicts to a file"))
        .arg(
            Arg::new("html")
                .long("html")
                .value_name("FOLDER")
                .help("Also write the worksheets as pages, with formulas, verdicts and pictures"),
        )
        .arg(Arg::new("allow-empty").long("allow-empty").action(ArgAction::SetTrue).help("Exit with 0 where there are no claims"))
        .arg(Arg::new("quiet").short('q').long("quiet").action(ArgAction::SetTrue).help("No warnings and no summary"))
        .arg(super::command::color())
}

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
        Some(path) => super::target::replace(Path::new(path), &output)?,
        None => super::print(&output)?,
    }
    if let Some(folder) = text_of(matches, "html") {
        pages(Path::new(folder), &checked)?;
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
            out.extend_from_slice(json(checked, obstacles).to_string().as_bytes());
            out.push(b'\n');
            Ok(())
        }
        Some("junit") => junit::write("casteljau verify", &checked.iter().map(suite).collect::<Vec<_>>(), out),
        Some(format @ ("sarif" | "github")) => {
            let notices: Vec<Notice> = checked.iter().flat_map(notices).collect();
            let findings = Findings { rules: &RULES, notices: &notices, obstacles };
            if format == "sarif" { sarif::write(&findings, out) } else { github::write(&findings, out) }
        }
        _ => {
            out.extend_from_slice(text(checked, matches, coloured).as_bytes());
            Ok(())
        }
    }
}

/// Writes the worksheets as pages, and a page that leads to them if there are several.
fn pages(folder: &Path, checked: &[Checked]) -> Result<(), Problem> {
    let failed = |path: &Path, error: io::Error| Problem::plain(format!("cannot write `{}`: {error}", path.display()));
    std::fs::create_dir_all(folder).map_err(|error| failed(folder, error))?;
    let mut index = Vec::new();
    let mut taken = Vec::new();
    for file in checked {
        // What leads out of the folder stays behind.
        let parts = Path::new(&file.path).components().filter_map(|part| match part {
            std::path::Component::Normal(name) => Some(name.to_string_lossy()),
            _ => None,
        });
        let parts: Vec<_> = parts.collect();
        let stem = |name: &str| name.rsplit_once('.').map_or(name, |(stem, _)| stem).to_owned();
        let mut name = parts.last().map_or_else(|| "worksheet".to_owned(), |last| stem(last));
        if taken.contains(&name) || name == "index" {
            name = stem(&parts.join("-"));
        }
        while taken.contains(&name) {
            name.push('-');
        }
        let page = worksheet::html(&file.path, &file.text, Format::of_path(&file.path));
        super::target::replace(&folder.join(format!("{name}.html")), page.as_bytes())?;
        index.push((format!("{name}.html"), file.path.clone(), summary(&file.report), file.report.holds()));
        taken.push(name);
    }
    if index.len() > 1 {
        super::target::replace(&folder.join("index.html"), worksheet::html_index(&index).as_bytes())?;
    }
    Ok(())
}

/// What a worksheet has to say, in the order of its places.
fn notices(file: &Checked) -> Vec<Notice> {
    let of = |code: &str, place: Place, message: String, fingerprint: Option<String>| {
        let rule = worksheet::rule(code);
        Notice { rule, level: rule.level, path: file.path.clone(), place: Some(place), message, fingerprint, known: false }
    };
    let with_help = |error: &SyntaxError| match &error.help {
        Some(help) => format!("{}. {help}", error.message),
        None => error.message.clone(),
    };
    let places = Places::new(&file.text);
    let mut notices = Vec::new();
    for error in &file.report.errors {
        notices.push(of("W003", places.of(error.span.start), with_help(error), None));
    }
    for claim in &file.report.claims {
        let at = Place::from((claim.line, claim.column));
        match (&claim.error, claim.verdict) {
            (Some(error), _) => notices.push(of("W002", places.of(error.span.start), with_help(error), claim.name.clone())),
            (None, Verdict::Refuted) => notices.push(of("W001", at, sentence(claim), claim.name.clone())),
            _ => {}
        }
    }
    for warning in &file.report.warnings {
        notices.push(of(warning.code, places.of(warning.error.span.start), warning.error.message.clone(), None));
    }
    notices.sort_by_key(|notice| notice.place.map(|place| (place.line, place.column)));
    notices
}

/// A refuted claim in one sentence, and what there is to know of it.
fn sentence(claim: &Claim) -> String {
    let name = claim.name.as_deref().unwrap_or("this");
    let notes: Vec<String> = failure(claim).into_iter().map(|note| note.text().trim().to_owned()).collect();
    format!("{name} does not hold: {}", notes.join("; "))
}

fn suite(file: &Checked) -> Suite {
    let mut seen: BTreeMap<String, usize> = BTreeMap::new();
    let mut unique = |name: String| {
        let count = seen.entry(name.clone()).or_default();
        *count += 1;
        if *count == 1 { name } else { format!("{name} ({count})") }
    };
    let places = Places::new(&file.text);
    let mut cases = Vec::new();
    for error in &file.report.errors {
        let at = places.of(error.span.start);
        let outcome = Outcome::Error { message: error.message.clone(), detail: format!("{}:{}:{}", file.path, at.line, at.column) };
        cases.push(Case { name: unique(format!("line {}", at.line)), outcome });
    }
    for claim in &file.report.claims {
        let source: String = claim.span.text(&file.text).split_whitespace().collect::<Vec<_>>().join(" ");
        let name = unique(claim.name.clone().unwrap_or_else(|| format!("line {}: {}", claim.line, shortened(&source, 120))));
        let at = format!("{}:{}:{}", file.path, claim.line, claim.column);
        let outcome = match (&claim.error, claim.verdict) {
            (Some(error), _) => Outcome::Error { message: error.message.clone(), detail: at },
            (None, Verdict::Refuted) => {
                let lines: Vec<String> = std::iter::once(at).chain(failure(claim).iter().map(|note| note.text().to_owned())).collect();
                Outcome::Failed { rule: worksheet::rule("W001"), message: sentence(claim), detail: lines.join("\n") }
            }
            _ => Outcome::Passed,
        };
        cases.push(Case { name, outcome });
    }
    Suite { name: file.path.clone(), cases }
}

fn json(checked: &[Checked], obstacles: &[Obstacle]) -> Value {
    let error = |places: &Places<'_>, error: &SyntaxError| {
        let place = places.of(error.span.start);
        json!({"line": place.line, "column": place.column, "message": error.message, "help": error.help})
    };
    let claim = |claim: &Claim| {
        let terms: Vec<Value> = claim
            .terms
            .iter()
            .map(|term| json!({"place": term.place, "monomial": term.monomial, "left": term.left, "right": term.right}))
            .collect();
        json!({
            "line": claim.line,
            "column": claim.column,
            "name": claim.name,
            "verdict": claim.verdict.name(),
            "left": claim.left,
            "right": claim.right,
            "difference": claim.difference,
            "diagnosis": claim.diagnosis,
            "terms": terms,
            "message": claim.error.as_ref().map(|error| error.message.as_str()),
        })
    };
    let mut listed: Vec<Value> = checked
        .iter()
        .map(|file| {
            let places = Places::new(&file.text);
            json!({
                "path": file.path,
                "claims": file.report.claims.iter().map(claim).collect::<Vec<_>>(),
                "errors": file.report.errors.iter().map(|found| error(&places, found)).collect::<Vec<_>>(),
                "warnings": file.report.warnings.iter().map(|warning| error(&places, &warning.error)).collect::<Vec<_>>(),
            })
        })
        .collect();
    listed.extend(obstacles.iter().map(|obstacle| {
        let message = &obstacle.flaw.message;
        json!({"path": obstacle.path, "claims": [], "errors": [{"line": null, "column": null, "message": message, "help": null}], "warnings": []})
    }));
    let count = |verdict| checked.iter().map(|file| file.report.count(verdict)).sum::<usize>();
    let errors = count(Verdict::Error) + checked.iter().map(|file| file.report.errors.len()).sum::<usize>() + obstacles.len();
    json!({
        "version": 1,
        "files": listed,
        "summary": {"proved": count(Verdict::Proved), "refuted": count(Verdict::Refuted), "error": errors},
    })
}

fn text(checked: &[Checked], matches: &ArgMatches, coloured: bool) -> String {
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

/// What a failed claim's values are, and how they differ.
fn failure(claim: &Claim) -> Vec<Note> {
    const MOST: usize = 8;
    const LONGEST: usize = 400;
    let mut notes = Vec::new();
    notes.extend(claim.left.as_ref().map(|left| Note::plain(format!("the left side is   {}", shortened(left, LONGEST)))));
    notes.extend(claim.right.as_ref().map(|right| Note::plain(format!("the right side is  {}", shortened(right, LONGEST)))));
    if claim.terms.is_empty() {
        notes.extend(claim.difference.clone().map(Note::plain));
    }
    for term in claim.terms.iter().take(MOST) {
        let place = if term.place.is_empty() { String::new() } else { format!("{}: ", term.place) };
        let what = if term.monomial == "1" { String::new() } else { format!(" at {}", term.monomial) };
        notes.push(Note::plain(format!("{place}{}{what}, claimed {}", term.left, term.right)));
    }
    if claim.terms.len() > MOST {
        notes.push(Note::plain(format!("and {} more differences", claim.terms.len() - MOST)));
    }
    notes.extend(claim.diagnosis.clone().map(Note::help));
    notes
}

/// A text short enough for the terminal.
fn shortened(text: &str, longest: usize) -> String {
    match text.char_indices().nth(longest) {
        Some((end, _)) => format!("{}… ({} characters)", &text[..end], text.chars().count()),
        None => text.to_owned(),
    }
}

fn summary(report: &Report) -> String {
    let counts = [
        (report.count(Verdict::Proved), "proved"),
        (report.count(Verdict::Refuted), "refuted"),
        (report.count(Verdict::Error) + report.errors.len(), "in error"),
    ];
    let parts: Vec<String> =
        counts.into_iter().filter(|(count, what)| *count > 0 || *what == "proved").map(|(count, what)| format!("{count} {what}")).collect();
    parts.join(", ")
}
