//! Worksheets as pages: formulas typeset, claims green or red, pictures beside
//! them, all in one file that needs no network.

mod formula;
mod picture;

use std::fmt::Write as _;
use std::ops::Range;

use pulldown_cmark::{CodeBlockKind, CowStr, Event, Parser, Tag, TagEnd};

use super::claim::{Claim, Verdict};
use super::document::{Document, Format, comments, marked_down, options};
use super::report::{Outcome, Rendered, Report};
use crate::report::xml::escape;
use formula::{Display, mathml};

/// The look of a page.
const STYLE: &str = include_str!("style.css");

/// A worksheet as a page in HTML.
///
/// ```
/// use casteljau::worksheet::{self, Format};
/// let source = "# Squares\n\n```casteljau\n(t + 1)^2 == t^2 + 2 t + 1\n```\n";
/// let page = worksheet::html("squares.md", source, Format::Markdown);
/// assert!(page.contains("class=\"claim proved\"") && page.contains("<math"));
/// ```
#[must_use]
pub fn html(title: &str, source: &str, format: Format) -> String {
    let marked = marked_down(source);
    let source = if format == Format::Markdown { &*marked } else { source };
    let report = super::check::check_for_rendering(source, format);
    let document = Document::new(source, format);
    let parts = Page { source, report: &report };
    let mut body = String::new();
    match format {
        Format::Statements => {
            for block in &document.blocks {
                body.push_str(&parts.block(block.range.clone(), true));
            }
        }
        Format::Markdown => pulldown_cmark::html::push_html(&mut body, parts.events(&document)),
    }
    let counts = [(report.count(Verdict::Proved), "proved"), (report.count(Verdict::Refuted), "refuted")];
    let errors = report.count(Verdict::Error) + report.errors.len();
    let mut summary: Vec<String> = counts
        .iter()
        .filter(|(count, _)| *count > 0)
        .map(|(count, name)| format!("<span class=\"{name}\">{count} {name}</span>"))
        .collect();
    if errors > 0 {
        summary.push(format!("<span class=\"error\">{errors} in error</span>"));
    }
    page(title, &if summary.is_empty() { "no claims".to_owned() } else { summary.join(", ") }, &body)
}

/// A page that leads to others: each its file, what it is called, how it went, and whether it holds.
pub(crate) fn index(pages: &[(String, String, String, bool)]) -> String {
    let rows = pages.iter().fold(String::new(), |mut rows, (file, name, summary, holds)| {
        let class = if *holds { "proved" } else { "refuted" };
        // Writing to a string does not fail.
        let _ = writeln!(
            rows,
            "<div class=\"claim {class}\"><span class=\"mark\">{}</span><div><a href=\"{}\">{}</a> <span class=\"note\">{}</span></div></div>",
            if *holds { "✓" } else { "✗" },
            escape(file),
            escape(name),
            escape(summary)
        );
        rows
    });
    page("Worksheets", "", &format!("<h1>Worksheets</h1>\n<div class=\"statements\">\n{rows}</div>\n"))
}

/// The frame of a page.
fn page(title: &str, summary: &str, body: &str) -> String {
    let title = escape(title);
    let summary = if summary.is_empty() { String::new() } else { format!("<p class=\"summary\">{title}: {summary}</p>\n") };
    format!(
        "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n<meta name=\"viewport\" content=\"width=device-width\">\n\
         <title>{title}</title>\n<style>\n{STYLE}</style>\n</head>\n<body>\n{summary}<main>\n{body}</main>\n</body>\n</html>\n"
    )
}

struct Page<'a> {
    source: &'a str,
    report: &'a Report,
}

impl Page<'_> {
    /// The Markdown with its blocks replaced by what they say.
    fn events<'p>(&'p self, document: &'p Document) -> impl Iterator<Item = Event<'p>> {
        let mut skipping = false;
        let is_block = |range: &Range<usize>| document.blocks.iter().any(|block| block.range == *range);
        Parser::new_ext(self.source, options()).into_offset_iter().filter_map(move |(event, range)| {
            let html = |text: String| Some(Event::Html(CowStr::from(text)));
            match event {
                Event::Start(Tag::CodeBlock(CodeBlockKind::Fenced(_))) if is_block(&range) => {
                    skipping = true;
                    html(self.block(range, false))
                }
                Event::End(TagEnd::CodeBlock) if skipping => {
                    skipping = false;
                    None
                }
                _ if skipping => None,
                Event::DisplayMath(_) if is_block(&range) => Some(Event::InlineHtml(CowStr::from(self.block(range, false)))),
                Event::DisplayMath(text) => Some(Event::InlineHtml(CowStr::from(mathml(&text, Display::Block)))),
                Event::InlineMath(text) => Some(Event::InlineHtml(CowStr::from(mathml(&text, Display::Inline)))),
                // Whatever is in the file, the page runs no script.
                Event::Html(text) | Event::InlineHtml(text) if text.trim_start().starts_with("<!--") => {
                    let _ = text;
                    None
                }
                Event::Html(text) | Event::InlineHtml(text) => Some(Event::Text(text)),
                Event::Start(Tag::Link { link_type, dest_url, title, id }) if !is_harmless(&dest_url) => {
                    let _ = dest_url;
                    Some(Event::Start(Tag::Link { link_type, dest_url: CowStr::from("#"), title, id }))
                }
                other => Some(other),
            }
        })
    }

    /// The statements of a block, with their verdicts, and pictures beside them.
    fn block(&self, range: Range<usize>, whole: bool) -> String {
        let inside = |place: usize| range.contains(&place) || (whole && place == range.end);
        let mut rows = String::new();
        let mut pictures = String::new();
        let statements: Vec<&Rendered> = self.report.statements.iter().filter(|statement| inside(statement.span.start)).collect();
        let notes = comments(&self.source[range.clone()]);
        let mut notes = notes.into_iter().map(|(at, note)| (range.start + at, note)).peekable();
        let mut shown = 0;
        for (index, statement) in statements.iter().enumerate() {
            // Comments on lines of their own stand before the statement.
            while let Some((_, note)) = notes.next_if(|(at, _)| *at < statement.span.start) {
                let _ = writeln!(rows, "<p class=\"note\">{}</p>", prose(note));
            }
            let next = statements.get(index + 1).map_or(range.end, |next| next.span.start);
            let line_end = self.source[statement.span.end..next].find('\n').map_or(next, |length| statement.span.end + length);
            let beside = notes.next_if(|(at, _)| *at <= line_end).map(|(_, note)| note);
            rows.push_str(&self.row(statement, beside));
            if let Some(svg) = statement.picture.as_ref().filter(|_| shown <= statements.len() / 8).and_then(picture::drawn) {
                shown += 1;
                let _ = writeln!(pictures, "<figure>{svg}</figure>");
            }
        }
        for (_, note) in notes {
            let _ = writeln!(rows, "<p class=\"note\">{}</p>", prose(note));
        }
        let pictures = if pictures.is_empty() { pictures } else { format!("<div class=\"pictures\">\n{pictures}</div>\n") };
        format!("<div class=\"block\">\n<div class=\"statements\">\n{rows}</div>\n{pictures}</div>\n")
    }

    fn row(&self, statement: &Rendered, note: Option<&str>) -> String {
        let source = statement.span.text(self.source);
        let formula = if statement.latex.is_empty() {
            format!("<code>{}</code>", escape(source))
        } else {
            statement.latex.iter().map(|latex| mathml(latex, Display::Block)).collect::<Vec<_>>().join(" ")
        };
        let note = note.map_or_else(String::new, |note| format!("<span class=\"note\">{}</span>", prose(note)));
        match statement.outcome {
            Outcome::Definition(_) => format!("<div class=\"definition\"><span class=\"mark\"></span><div>{formula}{note}</div></div>\n"),
            Outcome::Error(index) => {
                let message = self.report.errors.get(index).map_or_else(String::new, |error| error.message.clone());
                format!(
                    "<div class=\"claim error\"><span class=\"mark\">!</span><div><code>{}</code><p>{}</p></div></div>\n",
                    escape(source),
                    escape(&message)
                )
            }
            Outcome::Claim(index) => match self.report.claims.get(index) {
                Some(claim) => claim_row(claim, &formula, &note),
                None => String::new(),
            },
        }
    }
}

fn claim_row(claim: &Claim, formula: &str, note: &str) -> String {
    let mark = match claim.verdict {
        Verdict::Proved => "✓",
        Verdict::Refuted => "✗",
        Verdict::Error => "!",
    };
    let name = claim.name.as_ref().map_or_else(String::new, |name| format!("<span class=\"name\">{}</span>", escape(name)));
    let mut detail = String::new();
    if let Some(error) = &claim.error {
        let _ = write!(detail, "<p>{}</p>", escape(&error.message));
    }
    if claim.verdict == Verdict::Refuted {
        let line = |label: &str, text: &Option<String>| {
            text.as_ref().map_or_else(String::new, |text| format!("<tr><th>{label}</th><td>{}</td></tr>", escape(text)))
        };
        let _ = write!(
            detail,
            "<table>{}{}{}</table>",
            line("left", &claim.left),
            line("right", &claim.right),
            line("difference", &claim.difference)
        );
        if let Some(diagnosis) = &claim.diagnosis {
            let _ = write!(detail, "<p class=\"diagnosis\">{}</p>", escape(diagnosis));
        }
    }
    format!(
        "<div class=\"claim {}\" id=\"L{}\"><span class=\"mark\" title=\"{}, line {}\">{mark}</span><div>{name}{formula}{note}{detail}</div></div>\n",
        claim.verdict.name(),
        claim.line,
        claim.verdict.name(),
        claim.line,
    )
}

/// A comment as text.
fn prose(note: &str) -> String {
    escape(note.trim()).to_string()
}

/// Whether a link leads to a page or a place, not to a script.
fn is_harmless(link: &str) -> bool {
    let scheme = link.split_once(':').map_or("", |(scheme, _)| scheme).to_ascii_lowercase();
    !link.contains(':') || scheme.contains(['/', '#', '?']) || ["http", "https", "mailto"].contains(&scheme.as_str())
}
