//! `check`: every join of the pieces in files, held to what is required.

mod baseline;
mod command;
mod settings;

use std::io::{self, IsTerminal, Write};
use std::path::Path;
use std::str::FromStr;
use std::time::Duration;

use clap::ArgMatches;
use indicatif::{ProgressBar, ProgressStyle};
use rayon::prelude::*;

use self::baseline::Baseline;
use self::settings::{Demands, Settings};
use super::diagnostic::Problem;
use super::ending::Ending;
use super::files::{self, Candidate};
use super::flags::text_of;
use super::tell;
use crate::audit::{Tolerance, Verdict, audit};
use crate::model::{Flaw, Format, read};
use crate::report::joins::{self, Examined, File, RULES, Style, Summary, fingerprint};
use crate::report::{Report, github, junit, sarif};

pub(super) use command::command;

/// Runs the command.
pub(super) fn check(matches: &ArgMatches, coloured: bool) -> Result<Ending, Problem> {
    let threads = matches.get_one::<u16>("jobs").map_or(0, |&jobs| usize::from(jobs));
    let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build();
    let pool = pool.map_err(|error| Problem::plain(format!("cannot start threads: {error}")))?;
    pool.install(|| run(matches, coloured))
}

fn run(matches: &ArgMatches, coloured: bool) -> Result<Ending, Problem> {
    let quiet = matches.get_flag("quiet");
    if let Some(path) = text_of(matches, "plot").filter(|path| !path.ends_with(".svg")) {
        return Err(Problem::plain(format!("findings are drawn as .svg: `{path}` ends otherwise")));
    }
    let settings =
        if matches.get_flag("no-config") { Settings::default() } else { Settings::find(text_of(matches, "config").map(String::as_str))? };
    let above = demands(matches)?;
    let format = text_of(matches, "read-as").and_then(|name| Format::named(name));
    let paths: Vec<String> = matches.get_many::<String>("paths").unwrap_or_default().cloned().collect();
    let from_input = paths.iter().any(|path| path == "-");
    let on_disk: Vec<String> = paths.into_iter().filter(|path| path != "-").collect();
    let candidates = files::collect(&on_disk, |path| Format::of_path(path).is_some() && !settings.excludes(path))?;
    let known = match text_of(matches, "baseline").map(|path| Path::new(path).to_owned()).or_else(|| settings.baseline.clone()) {
        Some(path) if text_of(matches, "write-baseline").is_none() => Some(Baseline::read(&path)?),
        _ => None,
    };
    let bar = progress(candidates.len(), quiet);
    let mut examined: Vec<File> = candidates
        .par_iter()
        .filter_map(|candidate| {
            let file = examine(candidate, format, &settings.of(&candidate.path, &above));
            bar.inc(1);
            file
        })
        .collect();
    bar.finish_and_clear();
    if from_input {
        let text = files::read(io::stdin().lock()).map_err(|error| Problem::plain(format!("cannot read standard input: {error}")))?;
        examined.insert(0, judged("standard input".into(), text, format, &settings.of(Path::new("-"), &above)));
    }
    if let Some(known) = known {
        let gone = known.mark(&mut examined);
        if gone > 0 && !quiet {
            tell(&format!("{gone} findings of the baseline do not occur any more; --write-baseline leaves them out"));
        }
    }
    let mut output = Vec::new();
    print(matches, &examined, coloured, &mut output).map_err(Problem::output)?;
    match text_of(matches, "output") {
        Some(path) => super::target::replace(Path::new(path), &output)?,
        None => {
            let mut out = io::stdout().lock();
            out.write_all(&output).and_then(|()| out.flush()).map_err(Problem::output)?;
        }
    }
    if let Some(path) = text_of(matches, "plot") {
        super::target::replace(Path::new(path), crate::draw::joins(&examined)?.as_bytes())?;
    }
    let summary = Summary::of(&examined);
    let written = match text_of(matches, "write-baseline") {
        Some(path) => {
            let count = Baseline::write(Path::new(path), &examined)?;
            if !quiet {
                tell(&format!("{count} findings were written to {path}"));
            }
            true
        }
        None => false,
    };
    if summary.unreadable > 0 {
        return Ok(Ending::Unusable);
    }
    if summary.joins == 0 && !matches.get_flag("allow-empty") {
        tell("there is no join to check (--allow-empty makes that a success)");
        return Ok(Ending::Unusable);
    }
    Ok(if summary.fails() && !written { Ending::No } else { Ending::Fine })
}

/// What the command line asks of joins.
fn demands(matches: &ArgMatches) -> Result<Demands, Problem> {
    let named = |name: &'static str| move |error: String| Problem::plain(format!("--{name}: {error}"));
    let mut tolerance: Option<Tolerance> = None;
    for text in matches.get_many::<String>("tolerance").unwrap_or_default() {
        let one = Tolerance::from_str(text).map_err(named("tolerance"))?;
        tolerance = Some(tolerance.unwrap_or_default().and(one).map_err(named("tolerance"))?);
    }
    Ok(Demands {
        require: text_of(matches, "require").map(|text| settings::requirement(text)).transpose().map_err(named("require"))?,
        tolerance,
        snap: text_of(matches, "snap").map(|text| settings::snap(text)).transpose().map_err(named("snap"))?,
    })
}

/// A bar on a terminal, or for a single file, of which it is not known how long
/// it takes, something that moves.
fn progress(files: usize, quiet: bool) -> ProgressBar {
    if quiet || !io::stderr().is_terminal() {
        return ProgressBar::hidden();
    }
    if files < 2 {
        let spinner = ProgressBar::new_spinner();
        spinner.enable_steady_tick(Duration::from_millis(120));
        return spinner;
    }
    let bar = ProgressBar::new(files as u64);
    if let Ok(style) = ProgressStyle::with_template("{wide_bar} {pos}/{len} files, {eta}") {
        bar.set_style(style);
    }
    bar
}

/// Reads a file and judges its joins; nothing comes of a file in a folder that
/// holds something else.
fn examine(candidate: &Candidate, format: Option<Format>, demands: &Demands) -> Option<File> {
    let by_path = Format::of_path(&candidate.path);
    let file = match files::text(&candidate.path) {
        Err(message) => File { path: candidate.shown(), text: None, outcome: Err(Flaw::of_file(message)) },
        // Many files are JSON; shapes say of what kind they are.
        Ok(text) if !candidate.named && by_path == Some(Format::Shape) && !text.contains("\"kind\"") => return None,
        Ok(text) => judged(candidate.shown(), text, format.or(by_path), demands),
    };
    let empty = file.outcome.as_ref().is_ok_and(|examined| examined.model.parts.is_empty());
    (candidate.named || !empty).then_some(file)
}

/// A file with the verdicts on its joins.
fn judged(path: String, text: String, format: Option<Format>, demands: &Demands) -> File {
    let outcome = judge(&text, format, demands);
    let shown = match &outcome {
        Ok(examined) => examined.audit.joins.iter().any(|join| matches!(join.verdict, Verdict::Violated | Verdict::Degenerate)),
        Err(flaw) => flaw.place.is_some(),
    };
    File { path, text: shown.then_some(text), outcome }
}

fn judge(text: &str, format: Option<Format>, demands: &Demands) -> Result<Examined, Flaw> {
    let unknown = || {
        let names = Format::ALL.map(Format::name).join(", ");
        Flaw::of_file(format!("neither the ending nor the content tells the format: --read-as takes {names}"))
    };
    let format = format.or_else(|| Format::of_content(text)).ok_or_else(unknown)?;
    let model = read(text, format)?;
    let audit = audit(&model, &demands.terms(), demands.snap.as_ref()).map_err(|error| Flaw::of_file(error.to_string()))?;
    let fingerprints = audit.joins.iter().map(|join| (join.verdict == Verdict::Violated).then(|| fingerprint(join))).collect();
    Ok(Examined { known: vec![false; audit.joins.len()], fingerprints, model, audit })
}

fn print(matches: &ArgMatches, files: &[File], coloured: bool, out: &mut dyn Write) -> io::Result<()> {
    match text_of(matches, "format").map(String::as_str) {
        Some("json") => joins::json(files, out),
        Some("junit") => junit::write("casteljau check", &joins::suites(files), out),
        Some(machine @ ("sarif" | "github")) => {
            let (notices, obstacles) = joins::notices(files);
            let report = Report { rules: &RULES, notices: &notices, obstacles: &obstacles };
            if machine == "sarif" { sarif::write(&report, out) } else { github::write(&report, out) }
        }
        _ => joins::text(files, Style { coloured, verbose: matches.get_count("verbose") > 0 }, out),
    }
}
