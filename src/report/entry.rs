//! The lines of a finding.

use super::formula::Notation;
use crate::syntax::Style;

/// One line: what it is about, formulas, and a remark.
#[derive(Clone, Debug, Default)]
pub(super) struct Entry {
    label: String,
    formulas: Vec<String>,
    remark: String,
    /// How far the line is indented.
    level: usize,
}

impl Entry {
    pub(super) fn new(label: &str) -> Self {
        Self { label: label.to_owned(), ..Self::default() }
    }

    /// A line without formulas.
    pub(super) fn remark(label: &str, remark: impl Into<String>) -> Self {
        Self::new(label).with_remark(remark)
    }

    pub(super) fn with(mut self, formula: impl Into<String>) -> Self {
        self.formulas.push(formula.into());
        self
    }

    pub(super) fn with_remark(self, remark: impl Into<String>) -> Self {
        Self { remark: remark.into(), ..self }
    }

    /// The same below the line before.
    pub(super) fn below(self) -> Self {
        Self { level: 1, ..self }
    }

    /// The line in plain text.
    pub(super) fn text(&self) -> String {
        let formulas = self.formulas.join(", ");
        let body = match (formulas.is_empty(), self.remark.is_empty()) {
            (true, _) => self.remark.clone(),
            (false, true) => formulas,
            (false, false) if self.label.is_empty() => format!("{formulas}: {}", self.remark),
            (false, false) => format!("{formulas}; {}", self.remark),
        };
        let indent = "  ".repeat(self.level);
        if self.label.is_empty() { format!("{indent}{body}") } else { format!("{indent}{}: {body}", self.label) }
    }

    /// The line of an `aligned` block.
    pub(super) fn formula(&self) -> String {
        let remark = if self.remark.is_empty() { String::new() } else { format!("\\text{{{}}}", in_text(&self.remark)) };
        let label = if self.label.is_empty() { String::new() } else { format!("\\text{{{}:}}", in_text(&self.label)) };
        let mut parts = self.formulas.clone();
        parts.extend((!remark.is_empty()).then_some(remark));
        format!("{label}\\; &{}", parts.join(",\\; "))
    }
}

/// Words inside of a formula: mathematical signs among them become commands.
fn in_text(words: &str) -> String {
    let mut text = String::new();
    for letter in words.chars() {
        match letter {
            'κ' => text.push_str("$\\kappa$"),
            '≠' => text.push_str("$\\neq$"),
            '<' | '>' => text.push_str(&format!("${letter}$")),
            '_' => text.push_str("\\_"),
            '–' => text.push_str("--"),
            '√' => text.push_str("$\\surd$"),
            _ => text.push(letter),
        }
    }
    text
}

/// A name with an index: `κ12`, or `\kappa_{12}`.
pub(super) fn kappa(index: &str, notation: &Notation) -> String {
    match notation.style {
        Style::Text | Style::Mathematica => format!("κ{index}"),
        Style::Latex => format!("\\kappa_{{{index}}}"),
    }
}
