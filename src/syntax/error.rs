//! What is wrong with a text, and where.

use std::fmt;

use super::Span;

/// Why a text could not be read: what was found and what was expected, the
/// place, and a suggestion where one is plain.
///
/// `Display` gives the bare message on one line; showing the source line with a
/// caret is left to the caller, who has the text.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct SyntaxError {
    /// What was found and what was expected.
    pub message: String,
    /// Where it was found.
    pub span: Span,
    /// What to write instead.
    pub help: Option<String>,
}

impl SyntaxError {
    /// An error without a suggestion.
    #[must_use]
    pub fn new(span: Span, message: impl Into<String>) -> Self {
        Self { message: message.into(), span, help: None }
    }

    /// The same error with a suggestion.
    #[must_use]
    pub fn with_help(mut self, help: impl Into<String>) -> Self {
        self.help = Some(help.into());
        self
    }

    /// Line and column in the text that was read, both from 1; columns count
    /// characters.
    #[must_use]
    pub fn position(&self, source: &str) -> (usize, usize) {
        self.span.position(source)
    }
}

impl fmt::Display for SyntaxError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.message)
    }
}

impl std::error::Error for SyntaxError {}
