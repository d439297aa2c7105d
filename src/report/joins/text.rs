//! What was found of joins, to be read.

use std::collections::BTreeMap;
use std::fmt::Write as _;
use std::io::{self, Write};

use annotate_snippets::{AnnotationKind, Level, Origin, Renderer, Snippet, Title};

use super::rules::rule_of;
use super::wording::{demand, finding, location, remedy};
use super::{Examined, File, Summary};
use crate::audit::{Join, Verdict};
use crate::continuity::Continuity;
use crate::exact::Rational;
use crate::model::Place;
use crate::report::Excerpt;
use crate::syntax::{Lines, Span};

/// How text is written.
#[derive(Clone, Copy, Debug, Default)]
pub struct Style {
    /// Whether with colours.
    pub coloured: bool,
    /// Whether degenerate joins and what was passed over are listed too.
    pub verbose: bool,
}

/// Writes the findings one by one, then what was found of each file without
/// requirements, then the summary.
///
/// # Errors
/// What writing gives.
pub fn text(files: &[File], style: Style, out: &mut dyn Write) -> io::Result<()> {
    let renderer = if style.coloured { Renderer::styled() } else { Renderer::plain() };
    for file in files {
        let lines = file.text.as_deref().map(Lines::new);
        match &file.outcome {
            Err(flaw) => {
                let title = Level::ERROR.primary_title(flaw.message.as_str());
                writeln!(out, "{}\n", located(&renderer, title, (&file.path, lines.as_ref()), flaw.place, "here", &[]))?;
            }
            Ok(examined) => {
                let degenerate = examined.audit.joins.iter().filter(|join| style.verbose && join.verdict == Verdict::Degenerate);
                let mut shown: Vec<&Join> = examined.failures().map(|(_, join)| join).chain(degenerate).collect();
                shown.sort_by_key(|join| examined.place(join));
                for join in shown {
                    writeln!(out, "{}\n", one(&renderer, (&file.path, lines.as_ref()), examined, join))?;
                }
                if style.verbose {
                    for omitted in &examined.model.omissions {
                        writeln!(out, "note[J020]: {}\n  --> {}:{}\n", omitted.what, file.path, omitted.place)?;
                    }
                }
            }
        }
    }
    for file in files {
        if let Ok(examined) = &file.outcome {
            let silent = examined.audit.joins.iter().all(|join| join.verdict == Verdict::Reported);
            if silent || files.len() == 1 {
                writeln!(out, "{}: {}", file.path, overview(examined))?;
            }
        }
    }
    writeln!(out, "{}", summary(files))
}

/// The surroundings of the character at a place; `None` if nothing stands there.
fn excerpt(lines: &Lines<'_>, place: Place) -> Option<Excerpt> {
    let byte = lines.byte(place.line as usize, place.column as usize)?;
    let rest = &lines.text()[byte..];
    if rest.is_empty() && place.column == 1 {
        // Behind the last line end there is nothing to show.
        return None;
    }
    let letter = rest.chars().next().map_or(0, char::len_utf8);
    Some(Excerpt::around(lines, Span::new(byte, byte + letter)))
}

/// A message with its place, the line there if it is known, and notes.
fn located(
    renderer: &Renderer,
    title: Title<'_>,
    (path, lines): (&str, Option<&Lines<'_>>),
    place: Option<Place>,
    label: &str,
    notes: &[String],
) -> String {
    let origin = Origin::path(path);
    let Some(place) = place else {
        let group = title.element(origin);
        return renderer.render(&[notes.iter().fold(group, |group, note| group.element(Level::NOTE.message(note.as_str())))]);
    };
    let origin = origin.line(place.line as usize).char_column(place.column as usize);
    let excerpt = lines.and_then(|lines| excerpt(lines, place));
    let group = match &excerpt {
        None => title.element(origin),
        Some(excerpt) => {
            let annotation = AnnotationKind::Primary.span(excerpt.span.clone()).label(label);
            let snippet = Snippet::source(excerpt.text.as_str()).line_start(excerpt.line).annotation(annotation);
            // Of a line whose beginning is left out the place is told apart.
            if excerpt.is_cut { title.element(origin).element(snippet) } else { title.element(snippet.path(path)) }
        }
    };
    renderer.render(&[notes.iter().fold(group, |group, note| group.element(Level::NOTE.message(note.as_str())))])
}

fn one(renderer: &Renderer, (path, lines): (&str, Option<&Lines<'_>>), examined: &Examined, join: &Join) -> String {
    let code = rule_of(join).map_or("", |rule| rule.code);
    let demand = demand(examined, join);
    let message = if demand.is_empty() { finding(join) } else { format!("{} ({demand})", finding(join)) };
    let level = if join.verdict == Verdict::Violated { Level::ERROR } else { Level::NOTE };
    let title = level.primary_title(message.as_str()).id(code);
    let place = Some(examined.place(join));
    let label = location(examined, join);
    let remedy = remedy(join);
    if examined.stated(join).is_some() {
        return located(renderer, title, (path, lines), place, &label, remedy.as_slice());
    }
    // The lines of a patch say little: its numbers are many.
    let notes: Vec<String> = std::iter::once(label).chain(remedy).collect();
    located(renderer, title, (path, None), place, "", &notes)
}

fn counted(count: usize, one: &str, many: &str) -> String {
    format!("{count} {}", if count == 1 { one } else { many })
}

/// The orders of all joins of a file, and what else there is.
fn overview(examined: &Examined) -> String {
    let mut orders: BTreeMap<(usize, String), usize> = BTreeMap::new();
    let mut ratios: BTreeMap<&Rational, usize> = BTreeMap::new();
    for join in &examined.audit.joins {
        // The best order, the strongest first.
        let key = match (join.parametric, join.geometric) {
            (Continuity::Same, _) => (0, "of one polynomial map".to_owned()),
            (Continuity::C(order), _) if order > 0 => (100 - order.min(90), format!("C{order}")),
            (_, Some(order)) if order > 0 => {
                if let Some(ratio) = &join.ratio {
                    *ratios.entry(ratio).or_default() += 1;
                }
                (200 - order, format!("G{order}"))
            }
            (_, _) if join.contact.is_degenerate() => (300, "degenerate".to_owned()),
            (Continuity::C(_), _) => (400, "C0".to_owned()),
            (Continuity::Broken, _) => (500, "broken".to_owned()),
        };
        *orders.entry(key).or_default() += 1;
    }
    let mut text = counted(examined.model.parts.len(), "piece", "pieces");
    let _ = write!(text, ", {}", counted(examined.audit.joins.len(), "join", "joins"));
    if !orders.is_empty() {
        let list: Vec<String> = orders.iter().map(|((_, name), count)| format!("{count} {name}")).collect();
        let _ = write!(text, " ({})", list.join(", "));
    }
    if !ratios.is_empty() && ratios.len() <= 6 {
        let list: Vec<String> = ratios.iter().map(|(ratio, count)| format!("{ratio} ({count})")).collect();
        let _ = write!(text, ", ratios {}", list.join(", "));
    }
    let patches = examined.model.parts.iter().any(|part| !matches!(part.piece, crate::piece::Piece::Curve(_)));
    let open = if patches { ("open edge", "open edges") } else { ("open end", "open ends") };
    let mut also = |count: usize, one: &str, many: &str| {
        if count > 0 {
            let _ = write!(text, ", {}", counted(count, one, many));
        }
    };
    also(examined.audit.open, open.0, open.1);
    also(examined.audit.collapsed, "collapsed edge", "collapsed edges");
    also(examined.audit.branches, "branch", "branches");
    also(examined.model.omissions.len(), "passed over", "passed over");
    text
}

/// The last line.
fn summary(files: &[File]) -> String {
    let summary = Summary::of(files);
    let mut parts = Vec::new();
    for verdict in Verdict::ALL {
        let count = summary.count(verdict);
        if count > 0 {
            let of_them =
                if verdict == Verdict::Violated && summary.known > 0 { format!(" ({} known)", summary.known) } else { String::new() };
            parts.push(format!("{count} {}{of_them}", verdict.name()));
        }
    }
    let mut text = format!("{} in {}", counted(summary.joins, "join", "joins"), counted(files.len(), "file", "files"));
    if !parts.is_empty() {
        let _ = write!(text, ": {}", parts.join(", "));
    }
    if summary.unreadable > 0 {
        let _ = write!(text, "; {} not be checked", counted(summary.unreadable, "file could", "files could"));
    }
    text
}
