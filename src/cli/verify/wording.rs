//! What is said of claims and worksheets.

use crate::cli::diagnostic::Note;
use crate::worksheet::{Claim, Report, Verdict};

/// A refuted claim in one sentence, and what there is to know of it.
pub(super) fn sentence(claim: &Claim) -> String {
    let name = claim.name.as_deref().unwrap_or("this");
    let notes: Vec<String> = failure(claim).into_iter().map(|note| note.text().trim().to_owned()).collect();
    format!("{name} does not hold: {}", notes.join("; "))
}

/// What a failed claim's values are, and how they differ.
pub(super) fn failure(claim: &Claim) -> Vec<Note> {
    const MOST: usize = 8;
    const LONGEST: usize = 400;
    let mut notes = Vec::new();
    notes.extend(claim.left.as_ref().map(|left| Note::plain(format!("the left side is   {}", shortened(left, LONGEST)))));
    notes.extend(claim.right.as_ref().map(|right| Note::plain(format!("the right side is  {}", shortened(right, LONGEST)))));
    if claim.terms.is_empty() {
        notes.extend(claim.difference.clone().map(Note::plain));
    }
    for term in claim.terms.iter().take(MOST) {
        let place = if term.place.is_empty() { String::new() } else { format!("{}: ", term.place) };
        let what = if term.monomial == "1" { String::new() } else { format!(" at {}", term.monomial) };
        notes.push(Note::plain(format!("{place}{}{what}, claimed {}", term.left, term.right)));
    }
    if claim.terms.len() > MOST {
        notes.push(Note::plain(format!("and {} more differences", claim.terms.len() - MOST)));
    }
    notes.extend(claim.diagnosis.clone().map(Note::help));
    notes
}

/// A text short enough for the terminal.
pub(super) fn shortened(text: &str, longest: usize) -> String {
    match text.char_indices().nth(longest) {
        Some((end, _)) => format!("{}… ({} characters)", &text[..end], text.chars().count()),
        None => text.to_owned(),
    }
}

/// How many claims have which verdict.
pub(super) fn summary(report: &Report) -> String {
    let counts = [
        (report.count(Verdict::Proved), "proved"),
        (report.count(Verdict::Refuted), "refuted"),
        (report.count(Verdict::Error) + report.errors.len(), "in error"),
    ];
    let parts: Vec<String> =
        counts.into_iter().filter(|(count, what)| *count > 0 || *what == "proved").map(|(count, what)| format!("{count} {what}")).collect();
    parts.join(", ")
}
