//! What a run of a checker has to say about files, whatever it checked.

use crate::model::{Flaw, Place};

/// How much a notice matters.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Level {
    /// Something worth knowing that asks for nothing.
    Note,
    /// Something to look at that fails no run.
    Warning,
    /// Something that does not hold.
    Error,
}

impl Level {
    /// The level as a word: `note`, `warning` or `error`.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Note => "note",
            Self::Warning => "warning",
            Self::Error => "error",
        }
    }
}

/// What is looked for: notices of one kind have one rule.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Rule {
    /// The code that never changes, such as `J003`.
    pub code: &'static str,
    /// The name, in words joined by hyphens.
    pub name: &'static str,
    /// The level of its notices unless they say otherwise.
    pub level: Level,
    /// One sentence.
    pub summary: &'static str,
    /// What it means, why it matters and what to do: paragraphs of plain text.
    pub explanation: &'static str,
}

/// One thing found in a file.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Notice {
    /// What was looked for.
    pub rule: &'static Rule,
    /// How much it matters.
    pub level: Level,
    /// The file, as the user names it: relative to the working directory
    /// wherever it can be, so that others find it in their copy.
    pub path: String,
    /// Where in the file, if it is at one place.
    pub place: Option<Place>,
    /// What was found. The first sentence is understood alone.
    pub message: String,
    /// What tells it from other notices of its rule and stays the same when
    /// other parts of the file change.
    pub fingerprint: Option<String>,
    /// Whether a baseline names it: it is shown where the format has a place
    /// for that, and fails nothing.
    pub known: bool,
}

/// What kept a file from being examined.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Obstacle {
    /// The file, as the user names it.
    pub path: String,
    /// What is wrong with it.
    pub flaw: Flaw,
}

/// All that a run found.
#[derive(Clone, Copy, Debug)]
pub struct Report<'a> {
    /// Every rule that was looked for, found or not, in the order of their codes.
    pub rules: &'a [Rule],
    /// What was found, in the order of files and places.
    pub notices: &'a [Notice],
    /// The files that could not be examined.
    pub obstacles: &'a [Obstacle],
}

#[cfg(test)]
pub(super) mod samples {
    use super::*;

    /// Strings that break careless writers: quotes, line ends, control
    /// characters, ends of sections, placeholders, links, other planes.
    pub(crate) const HOSTILE: [&str; 12] = [
        "a \"quoted\" 'word' & <tag>",
        "two\nlines\r\nand\ta tab\r",
        "\u{0}\u{1b}[31mred\u{1b}[0m\u{7f}",
        "]]> <![CDATA[ &amp; <!-- -->",
        "κ₂₃ ≈ ½, 曲線, 𝔽",
        "C:\\fonts\\my font.glif",
        "100% of {0}, {{1}} and %25::error::",
        "f[1](2), [0; 1](3)",
        "a,b:c=d",
        "\u{fffe}\u{ffff}\u{2028}",
        "::error file=x::y",
        "",
    ];

    pub(crate) static RULES: [Rule; 2] = [
        Rule {
            code: "J003",
            name: "not-smooth",
            level: Level::Error,
            summary: "Two curves meet at an angle.",
            explanation: "The handles are not on one line.\n\nMove one of them.",
        },
        Rule {
            code: "W001",
            name: "trivial",
            level: Level::Warning,
            summary: "A claim holds of itself.",
            explanation: "x == x says nothing, whatever {x} is.",
        },
    ];

    pub(crate) fn notice(rule: usize, path: &str, message: &str) -> Notice {
        let rule = &RULES[rule];
        Notice {
            rule,
            level: rule.level,
            path: path.into(),
            place: Some(Place { line: 3, column: 7 }),
            message: message.into(),
            fingerprint: Some("0f1e".into()),
            known: false,
        }
    }

    pub(crate) fn obstacle(path: &str, message: &str) -> Obstacle {
        Obstacle { path: path.into(), flaw: Flaw::at(Place { line: 1, column: 2 }, message) }
    }
}
