//! Errors on the terminal.

use std::io::{self, Write};
use std::process::ExitCode;

use annotate_snippets::{AnnotationKind, Group, Level, Renderer, Snippet};

use crate::error::Error;
use crate::model::Fault;
use crate::syntax::{Span, SyntaxError};

/// Why a command could not be carried out.
pub(super) enum Problem {
    /// A text could not be read, at a place.
    Syntax { name: String, text: String, error: SyntaxError },
    /// Anything else, with a remedy where one is plain.
    Plain { message: String, help: Option<String> },
    /// Nobody reads the output any more.
    ClosedPipe,
}

/// A line below a source line.
pub(super) struct Note {
    text: String,
    is_help: bool,
}

impl Note {
    pub(super) fn plain(text: impl Into<String>) -> Self {
        Self { text: text.into(), is_help: false }
    }

    pub(super) fn text(&self) -> &str {
        &self.text
    }

    pub(super) fn help(text: impl Into<String>) -> Self {
        Self { text: text.into(), is_help: true }
    }
}

/// A message with the source line it is about, notes below it, and a remedy.
pub(super) fn rendered(
    level: Level<'static>,
    title: &str,
    (path, text, span): (&str, &str, Span),
    notes: &[Note],
    help: Option<&str>,
    styled: bool,
) -> String {
    let renderer = if styled { Renderer::styled() } else { Renderer::plain() };
    let window = Window::around(text, span.start, span.end);
    let (line, _) = span.position(text);
    let snippet = Snippet::source(window.text.as_str())
        .line_start(line)
        .path(path)
        .annotation(AnnotationKind::Primary.span(window.start..window.end));
    let mut group = level.primary_title(title).element(snippet);
    for note in notes {
        let level = if note.is_help { Level::HELP } else { Level::NOTE.no_name() };
        group = group.element(level.message(note.text.as_str()));
    }
    let mut groups = vec![group];
    groups.extend(help.map(|help| Group::with_title(Level::HELP.secondary_title(help))));
    renderer.render(&groups).to_string()
}

impl Problem {
    pub(super) fn plain(message: impl Into<String>) -> Self {
        Self::Plain { message: message.into(), help: None }
    }

    pub(super) fn with_help(self, remedy: impl Into<String>) -> Self {
        match self {
            Self::Plain { message, .. } => Self::Plain { message, help: Some(remedy.into()) },
            Self::Syntax { name, text, error } => Self::Syntax { name, text, error: error.with_help(remedy) },
            Self::ClosedPipe => self,
        }
    }

    pub(super) fn syntax(name: &str, text: &str, error: SyntaxError) -> Self {
        Self::Syntax { name: name.to_owned(), text: text.to_owned(), error }
    }

    pub(super) fn output(error: io::Error) -> Self {
        if error.kind() == io::ErrorKind::BrokenPipe { Self::ClosedPipe } else { Self::plain(format!("cannot write the answer: {error}")) }
    }

    /// Writes the problem to standard error and gives the exit status.
    pub(super) fn show(&self, styled: bool) -> ExitCode {
        let renderer = if styled { Renderer::styled() } else { Renderer::plain() };
        let rendered = match self {
            Self::ClosedPipe => return ExitCode::SUCCESS,
            Self::Plain { message, help } => {
                let mut groups = vec![Group::with_title(Level::ERROR.primary_title(message.as_str()))];
                groups.extend(help.as_deref().map(|help| Group::with_title(Level::HELP.secondary_title(help))));
                renderer.render(&groups)
            }
            Self::Syntax { name, text, error } => {
                let window = Window::around(text, error.span.start, error.span.end);
                let (line, _) = error.position(text);
                let snippet = Snippet::source(window.text.as_str())
                    .line_start(line)
                    .path(name.as_str())
                    .annotation(AnnotationKind::Primary.span(window.start..window.end).label("here"));
                let message = error.to_string();
                let mut groups = vec![Level::ERROR.primary_title(message.as_str()).element(snippet)];
                groups.extend(error.help.as_deref().map(|help| Group::with_title(Level::HELP.secondary_title(help))));
                renderer.render(&groups)
            }
        };
        // Where standard error is closed too, the exit status has to do.
        let _ = writeln!(io::stderr(), "{rendered}");
        ExitCode::from(2)
    }
}

impl From<Error> for Problem {
    fn from(error: Error) -> Self {
        let help = match &error {
            Error::DegreeTooLow { .. } => Some("the polar degree can be raised with --degree, not lowered"),
            _ => None,
        };
        Self::Plain { message: error.to_string(), help: help.map(str::to_owned) }
    }
}

impl From<Fault> for Problem {
    fn from(fault: Fault) -> Self {
        Self::plain(fault.message)
    }
}

/// The part of a source line that is worth showing.
struct Window {
    text: String,
    start: usize,
    end: usize,
}

impl Window {
    fn around(text: &str, start: usize, end: usize) -> Self {
        const REACH: usize = 60;
        let start = floor_boundary(text, start.min(text.len()));
        let line_start = text[..start].rfind('\n').map_or(0, |at| at + 1);
        let line_end = text[start..].find('\n').map_or(text.len(), |at| start + at);
        let end = floor_boundary(text, end.clamp(start, line_end));
        let first = floor_boundary(text, start.saturating_sub(REACH).max(line_start));
        let last = floor_boundary(text, (end.min(start + REACH) + REACH).min(line_end));
        let prefix = if first > line_start { "…" } else { "" };
        let suffix = if last < line_end { "…" } else { "" };
        // Control characters would move the caret away from what it points at.
        let shown: String = text[first..last].chars().map(|c| if c.is_control() { ' ' } else { c }).collect();
        let width = |part: &str| part.chars().map(|c| if c.is_control() { 1 } else { c.len_utf8() }).sum::<usize>();
        let begin = prefix.len() + width(&text[first..start]);
        let length = width(&text[start..end.min(last)]);
        Self { text: format!("{prefix}{shown}{suffix}"), start: begin, end: begin + length }
    }
}

fn floor_boundary(text: &str, mut at: usize) -> usize {
    while !text.is_char_boundary(at) {
        at -= 1;
    }
    at
}
