//! Joins for programs that show findings beside the source.

use super::rules::{branch, omission, rule_of};
use super::wording::{demand, finding, location, remedy};
use super::{Examined, File};
use crate::audit::{Join, Verdict};
use crate::report::junit::{Case, Outcome, Suite};
use crate::report::notice::{Notice, Obstacle, Rule};

/// A join in one line: what was found, why it matters, where.
#[must_use]
pub fn sentence(examined: &Examined, join: &Join) -> String {
    let demand = demand(examined, join);
    let demand = if demand.is_empty() { demand } else { format!(" ({demand})") };
    let remedy = remedy(join).map_or_else(String::new, |remedy| format!("; {remedy}"));
    format!("{}{demand}: {}{remedy}", finding(join), location(examined, join))
}

/// The findings of all files, and the files that could not be examined.
#[must_use]
pub fn notices(files: &[File]) -> (Vec<Notice>, Vec<Obstacle>) {
    let (mut notices, mut obstacles) = (Vec::new(), Vec::new());
    for file in files {
        let examined = match &file.outcome {
            Ok(examined) => examined,
            Err(flaw) => {
                obstacles.push(Obstacle { path: file.path.clone(), flaw: flaw.clone() });
                continue;
            }
        };
        let mut note = |rule: &'static Rule, place, message: String, fingerprint, known| {
            notices.push(Notice { rule, level: rule.level, path: file.path.clone(), place, message, fingerprint, known });
        };
        let mut joins: Vec<(usize, &Join)> = examined.audit.joins.iter().enumerate().collect();
        joins.sort_by_key(|(_, join)| examined.place(join));
        for (index, join) in joins {
            if let Some(rule) = rule_of(join) {
                let fingerprint = examined.fingerprints[index].clone();
                note(rule, Some(examined.place(join)), sentence(examined, join), fingerprint, examined.known[index]);
            }
        }
        for omitted in &examined.model.omissions {
            note(omission(), Some(omitted.place), omitted.what.to_owned(), None, false);
        }
        if examined.audit.branches > 0 {
            let message = format!("more than two pieces meet at {} ends or edges", examined.audit.branches);
            note(branch(), None, message, None, false);
        }
    }
    (notices, obstacles)
}

/// One suite a file, one case a join.
#[must_use]
pub fn suites(files: &[File]) -> Vec<Suite> {
    let suite = |file: &File| {
        let cases = match &file.outcome {
            Err(flaw) => {
                let detail = flaw.place.map_or_else(String::new, |place| format!("{}:{place}", file.path));
                vec![Case { name: "readable".into(), outcome: Outcome::Error { message: flaw.message.clone(), detail } }]
            }
            Ok(examined) => examined.audit.joins.iter().enumerate().map(|(index, join)| case(file, examined, index, join)).collect(),
        };
        Suite { name: file.path.clone(), cases }
    };
    files.iter().map(suite).collect()
}

fn case(file: &File, examined: &Examined, index: usize, join: &Join) -> Case {
    let ((a, side_a), (b, side_b)) = (join.first, join.second);
    let name = match examined.stated(join) {
        Some(joint) => format!("contour {}, node {}", joint.contour, joint.node),
        None => format!("piece {a}, {side_a} - piece {b}, {side_b}"),
    };
    let outcome = match (join.verdict, rule_of(join)) {
        (Verdict::Violated, Some(_)) if examined.known[index] => Outcome::Skipped { message: "named by the baseline".into() },
        (Verdict::Violated, Some(rule)) => {
            Outcome::Failed { rule, message: sentence(examined, join), detail: format!("{}:{}", file.path, examined.place(join)) }
        }
        (Verdict::Degenerate, _) => Outcome::Skipped { message: finding(join) },
        (Verdict::Reported, _) => Outcome::Skipped { message: "nothing is required".into() },
        _ => Outcome::Passed,
    };
    Case { name, outcome }
}
