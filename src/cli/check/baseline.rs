//! Baselines: findings that are known and fail nothing.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

use serde::{Deserialize, Serialize};

use crate::audit::Verdict;
use crate::cli::diagnostic::Problem;
use crate::cli::files::{relative, shown};
use crate::cli::target::replace;
use crate::report::joins::{File, rule_of};

#[derive(Deserialize, Serialize)]
#[serde(deny_unknown_fields)]
struct Document {
    version: u8,
    findings: Vec<Entry>,
}

#[derive(Deserialize, Serialize)]
#[serde(deny_unknown_fields)]
struct Entry {
    path: String,
    rule: String,
    fingerprint: String,
    count: usize,
}

/// Where a finding is, its rule and its fingerprint.
type Key = (String, String, String);

/// How often each finding is known.
#[derive(Debug, Default)]
pub(super) struct Baseline {
    folder: PathBuf,
    counts: BTreeMap<Key, usize>,
}

impl Baseline {
    /// Reads one.
    pub(super) fn read(path: &Path) -> Result<Self, Problem> {
        let wrong = |error: String| Problem::plain(format!("the baseline `{}`: {error}", path.display()));
        let text = crate::cli::files::text(path).map_err(wrong)?;
        let document: Document = serde_json::from_str(&text).map_err(|error| wrong(error.to_string()))?;
        if document.version != 1 {
            return Err(wrong(format!("version {} is not known, 1 is", document.version)));
        }
        let mut baseline = Self { folder: folder(path), counts: BTreeMap::new() };
        for Entry { path, rule, fingerprint, count } in document.findings {
            *baseline.counts.entry((path, rule, fingerprint)).or_default() += count;
        }
        Ok(baseline)
    }

    /// Writes the violations of files as one.
    pub(super) fn write(path: &Path, files: &[File]) -> Result<usize, Problem> {
        let mut baseline = Self { folder: folder(path), counts: BTreeMap::new() };
        for file in files {
            let Ok(examined) = &file.outcome else { continue };
            for (join, fingerprint) in examined.audit.joins.iter().zip(&examined.fingerprints) {
                if let (Verdict::Violated, Some(rule), Some(fingerprint)) = (join.verdict, rule_of(join), fingerprint) {
                    *baseline.counts.entry(baseline.key(&file.path, rule.code, fingerprint)).or_default() += 1;
                }
            }
        }
        let total = baseline.counts.values().sum();
        let entry = |((path, rule, fingerprint), count)| Entry { path, rule, fingerprint, count };
        let document = Document { version: 1, findings: baseline.counts.into_iter().map(entry).collect() };
        let mut text = serde_json::to_vec_pretty(&document).map_err(|error| Problem::plain(error.to_string()))?;
        text.push(b'\n');
        replace(path, &text)?;
        Ok(total)
    }

    fn key(&self, path: &str, rule: &str, fingerprint: &str) -> Key {
        (shown(&relative(Path::new(path), &self.folder)), rule.to_owned(), fingerprint.to_owned())
    }

    /// Marks what is known; gives the number of known findings that did not occur.
    pub(super) fn mark(mut self, files: &mut [File]) -> usize {
        for file in files {
            let Ok(examined) = &mut file.outcome else { continue };
            for (index, join) in examined.audit.joins.iter().enumerate() {
                let (Verdict::Violated, Some(rule), Some(fingerprint)) = (join.verdict, rule_of(join), &examined.fingerprints[index])
                else {
                    continue;
                };
                let key = self.key(&file.path, rule.code, fingerprint);
                if let Some(count) = self.counts.get_mut(&key).filter(|count| **count > 0) {
                    *count -= 1;
                    examined.known[index] = true;
                }
            }
        }
        self.counts.values().sum()
    }
}

fn folder(path: &Path) -> PathBuf {
    path.parent().map_or_else(PathBuf::new, Path::to_owned)
}
