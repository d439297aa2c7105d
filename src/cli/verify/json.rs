//! Verdicts as JSON.

use serde_json::{Value, json};

use super::Checked;
use crate::model::Places;
use crate::report::Obstacle;
use crate::syntax::SyntaxError;
use crate::worksheet::{Claim, Verdict};

/// The verdicts of all files, and what could not be read.
pub(super) fn json(checked: &[Checked], obstacles: &[Obstacle]) -> Value {
    let error = |places: &Places<'_>, error: &SyntaxError| {
        let place = places.of(error.span.start);
        json!({"line": place.line, "column": place.column, "message": error.message, "help": error.help})
    };
    let claim = |claim: &Claim| {
        let terms: Vec<Value> = claim
            .terms
            .iter()
            .map(|term| json!({"place": term.place, "monomial": term.monomial, "left": term.left, "right": term.right}))
            .collect();
        json!({
            "line": claim.line,
            "column": claim.column,
            "name": claim.name,
            "verdict": claim.verdict.name(),
            "left": claim.left,
            "right": claim.right,
            "difference": claim.difference,
            "diagnosis": claim.diagnosis,
            "terms": terms,
            "message": claim.error.as_ref().map(|error| error.message.as_str()),
        })
    };
    let mut listed: Vec<Value> = checked
        .iter()
        .map(|file| {
            let places = Places::new(&file.text);
            json!({
                "path": file.path,
                "claims": file.report.claims.iter().map(claim).collect::<Vec<_>>(),
                "errors": file.report.errors.iter().map(|found| error(&places, found)).collect::<Vec<_>>(),
                "warnings": file.report.warnings.iter().map(|warning| error(&places, &warning.error)).collect::<Vec<_>>(),
            })
        })
        .collect();
    listed.extend(obstacles.iter().map(|obstacle| {
        let message = &obstacle.flaw.message;
        json!({"path": obstacle.path, "claims": [], "errors": [{"line": null, "column": null, "message": message, "help": null}], "warnings": []})
    }));
    let count = |verdict| checked.iter().map(|file| file.report.count(verdict)).sum::<usize>();
    let errors = count(Verdict::Error) + checked.iter().map(|file| file.report.errors.len()).sum::<usize>() + obstacles.len();
    json!({
        "version": 1,
        "files": listed,
        "summary": {"proved": count(Verdict::Proved), "refuted": count(Verdict::Refuted), "error": errors},
    })
}
