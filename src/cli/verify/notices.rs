//! The findings in worksheets for programs that show them beside the source.

use std::collections::BTreeMap;

use super::Checked;
use super::wording::{failure, sentence, shortened};
use crate::model::{Place, Places};
use crate::report::Notice;
use crate::report::junit::{Case, Outcome, Suite};
use crate::syntax::SyntaxError;
use crate::worksheet::{self, Verdict};

/// What a worksheet has to say, in the order of its places.
pub(super) fn notices(file: &Checked) -> Vec<Notice> {
    let of = |code: &str, place: Place, message: String, fingerprint: Option<String>| {
        let rule = worksheet::rule(code);
        Notice { rule, level: rule.level, path: file.path.clone(), place: Some(place), message, fingerprint, known: false }
    };
    let with_help = |error: &SyntaxError| match &error.help {
        Some(help) => format!("{}. {help}", error.message),
        None => error.message.clone(),
    };
    let places = Places::new(&file.text);
    let mut notices = Vec::new();
    for error in &file.report.errors {
        notices.push(of("W003", places.of(error.span.start), with_help(error), None));
    }
    for claim in &file.report.claims {
        let at = Place::from((claim.line, claim.column));
        match (&claim.error, claim.verdict) {
            (Some(error), _) => notices.push(of("W002", places.of(error.span.start), with_help(error), claim.name.clone())),
            (None, Verdict::Refuted) => notices.push(of("W001", at, sentence(claim), claim.name.clone())),
            _ => {}
        }
    }
    for warning in &file.report.warnings {
        notices.push(of(warning.code, places.of(warning.error.span.start), warning.error.message.clone(), None));
    }
    notices.sort_by_key(|notice| notice.place.map(|place| (place.line, place.column)));
    notices
}

/// One suite a worksheet, one case a claim.
pub(super) fn suite(file: &Checked) -> Suite {
    let mut seen: BTreeMap<String, usize> = BTreeMap::new();
    let mut unique = |name: String| {
        let count = seen.entry(name.clone()).or_default();
        *count += 1;
        if *count == 1 { name } else { format!("{name} ({count})") }
    };
    let places = Places::new(&file.text);
    let mut cases = Vec::new();
    for error in &file.report.errors {
        let at = places.of(error.span.start);
        let outcome = Outcome::Error { message: error.message.clone(), detail: format!("{}:{}:{}", file.path, at.line, at.column) };
        cases.push(Case { name: unique(format!("line {}", at.line)), outcome });
    }
    for claim in &file.report.claims {
        let source: String = claim.span.text(&file.text).split_whitespace().collect::<Vec<_>>().join(" ");
        let name = unique(claim.name.clone().unwrap_or_else(|| format!("line {}: {}", claim.line, shortened(&source, 120))));
        let at = format!("{}:{}:{}", file.path, claim.line, claim.column);
        let outcome = match (&claim.error, claim.verdict) {
            (Some(error), _) => Outcome::Error { message: error.message.clone(), detail: at },
            (None, Verdict::Refuted) => {
                let lines: Vec<String> = std::iter::once(at).chain(failure(claim).iter().map(|note| note.text().to_owned())).collect();
                Outcome::Failed { rule: worksheet::rule("W001"), message: sentence(claim), detail: lines.join("\n") }
            }
            _ => Outcome::Passed,
        };
        cases.push(Case { name, outcome });
    }
    Suite { name: file.path.clone(), cases }
}
