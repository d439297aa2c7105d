//! Errors on the terminal.

use std::io::{self, Write};
use std::process::ExitCode;

use annotate_snippets::{AnnotationKind, Group, Level, Renderer, Snippet};

use crate::error::Error;
use crate::model::Fault;
use crate::report::Excerpt;
use crate::syntax::{Lines, Span, SyntaxError};

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
    (path, lines, span): (&str, &Lines<'_>, Span),
    notes: &[Note],
    help: Option<&str>,
    styled: bool,
) -> String {
    let renderer = if styled { Renderer::styled() } else { Renderer::plain() };
    let excerpt = Excerpt::around(lines, span);
    let snippet = Snippet::source(excerpt.text.as_str())
        .line_start(excerpt.line)
        .path(path)
        .annotation(AnnotationKind::Primary.span(excerpt.span.clone()));
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
                let excerpt = Excerpt::around(&Lines::new(text), error.span);
                let snippet = Snippet::source(excerpt.text.as_str())
                    .line_start(excerpt.line)
                    .path(name.as_str())
                    .annotation(AnnotationKind::Primary.span(excerpt.span.clone()).label("here"));
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
