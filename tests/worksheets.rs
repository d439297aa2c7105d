//! Worksheets: those that ship with the project, and what becomes of wrong ones.

use std::path::{Path, PathBuf};

use casteljau::worksheet::{Format, Report, check};

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).to_owned()
}

fn report(path: &Path) -> (String, Report) {
    let text = std::fs::read_to_string(path).expect("a readable worksheet");
    let report = check(&text, Format::of_path(&path.to_string_lossy()));
    (text, report)
}

/// The worksheets of the documents that the project is made from.
fn textbooks() -> Vec<PathBuf> {
    let folder = root().join("examples");
    let mut paths: Vec<PathBuf> = std::fs::read_dir(folder)
        .expect("the folder")
        .map(|entry| entry.expect("an entry").path())
        .filter(|path| path.extension().is_some_and(|extension| extension == "md"))
        .collect();
    paths.sort();
    paths
}

fn problems(text: &str, report: &Report) -> Vec<String> {
    let errors = report.errors.iter().map(|error| format!("{}: {error}", error.position(text).0));
    let claims = report.claims.iter().filter(|claim| claim.verdict.name() != "proved").map(|claim| {
        let why = claim.error.as_ref().map_or_else(|| format!("{:?} {:?}", claim.difference, claim.terms), ToString::to_string);
        format!("{}: {} {why}", claim.line, claim.verdict.name())
    });
    errors.chain(claims).collect()
}

#[test]
fn every_worksheet_of_the_project_holds() {
    let mut claims = 0;
    for path in textbooks().into_iter().chain([root().join("tests/worksheets/interface.cj")]) {
        let (text, report) = report(&path);
        assert!(report.holds(), "{}: {:#?}", path.display(), problems(&text, &report));
        claims += report.claims.len();
    }
    assert!(claims > 500, "only {claims} claims");
}
