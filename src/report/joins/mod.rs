//! What was found of the joins in files, for people and for programs.

mod fingerprint;
mod json;
mod notices;
mod rules;
mod text;
mod wording;

use crate::audit::{Audit, Join, Verdict};
use crate::model::{Flaw, Follow, Model, Place};

pub use fingerprint::fingerprint;
pub use json::json;
pub use notices::{notices, sentence, suites};
pub use rules::{RULES, rule_of};
pub use text::{Style, text};

/// A file and what came of it.
#[derive(Debug)]
pub struct File {
    /// The path, as the user names it.
    pub path: String,
    /// Its text, where lines of it are to be shown.
    pub text: Option<String>,
    /// What was found, or why it could not be examined.
    pub outcome: Result<Examined, Flaw>,
}

/// A file whose joins were judged.
#[derive(Debug)]
pub struct Examined {
    /// Its pieces.
    pub model: Model,
    /// Its joins.
    pub audit: Audit,
    /// For every join, the fingerprint of its finding, if it is one.
    pub fingerprints: Vec<Option<String>>,
    /// For every join, whether a baseline names it.
    pub known: Vec<bool>,
}

impl Examined {
    /// The joint of an outline or a spline that a join is at.
    #[must_use]
    pub fn stated(&self, join: &Join) -> Option<&Follow> {
        join.stated.map(|index| &self.model.joints[index])
    }

    /// The place in the file that leads to a join.
    #[must_use]
    pub fn place(&self, join: &Join) -> Place {
        self.stated(join).map_or_else(|| self.model.parts[join.second.0].place, |joint| joint.place)
    }

    /// The joins that fail the run, with their indices.
    pub fn failures(&self) -> impl Iterator<Item = (usize, &Join)> {
        let fails = |(index, join): &(usize, &Join)| join.verdict == Verdict::Violated && !self.known[*index];
        self.audit.joins.iter().enumerate().filter(fails)
    }
}

/// How many joins have each verdict.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Summary {
    /// All joins.
    pub joins: usize,
    /// How many there are of [`Verdict::ALL`], in that order.
    pub verdicts: [usize; 5],
    /// How many of the violated ones a baseline names.
    pub known: usize,
    /// Files that could not be examined.
    pub unreadable: usize,
}

impl Summary {
    /// The sum over files.
    #[must_use]
    pub fn of(files: &[File]) -> Self {
        let mut summary = Self::default();
        for file in files {
            let Ok(examined) = &file.outcome else {
                summary.unreadable += 1;
                continue;
            };
            summary.joins += examined.audit.joins.len();
            for (join, known) in examined.audit.joins.iter().zip(&examined.known) {
                let place = Verdict::ALL.iter().position(|verdict| *verdict == join.verdict).unwrap_or(0);
                summary.verdicts[place] += 1;
                summary.known += usize::from(*known);
            }
        }
        summary
    }

    /// How many joins have a verdict.
    #[must_use]
    pub fn count(&self, verdict: Verdict) -> usize {
        Verdict::ALL.iter().position(|other| *other == verdict).map_or(0, |place| self.verdicts[place])
    }

    /// Whether something fails the run: a violation that no baseline names.
    #[must_use]
    pub fn fails(&self) -> bool {
        self.count(Verdict::Violated) > self.known
    }
}
