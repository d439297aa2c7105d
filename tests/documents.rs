//! What the documents show is what the program does.

mod transcript;

use std::fmt::Write as _;
use std::path::{Path, PathBuf};

use casteljau::ops::operations;

fn root() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR"))
}

/// Compares a document with what it should be, or rewrites it if asked to.
fn agree(path: &str, expected: &str) {
    let path = root().join(path);
    if std::env::var_os("CASTELJAU_BLESS").is_some() {
        std::fs::write(&path, expected).expect("a writable document");
        return;
    }
    let found = std::fs::read_to_string(&path).unwrap_or_default();
    assert!(found == expected, "{} is out of date: run the tests with CASTELJAU_BLESS=1 and read the difference", path.display());
}

fn scratch(name: &str) -> PathBuf {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join(name);
    std::fs::create_dir_all(&folder).expect("a folder for the test");
    folder
}

/// The console blocks of a Markdown document, replayed in place.
fn replayed(document: &str, folder: &Path) -> (String, usize) {
    let mut text = String::new();
    let mut commands = 0;
    let mut lines = document.lines();
    while let Some(line) = lines.next() {
        writeln!(text, "{line}").expect("a string");
        if line != "```console" {
            continue;
        }
        let block: Vec<&str> = lines.by_ref().take_while(|line| *line != "```").collect();
        // The program is built already: `cargo run` is the program, and the tests are running.
        const BY_CARGO: &str = "$ cargo run --release -- ";
        let direct: Vec<String> =
            block.iter().map(|line| line.replace(BY_CARGO, "$ casteljau ")).filter(|line| *line != "$ cargo test").collect();
        let (replayed, count) = transcript::replayed(&direct.join("\n"), folder);
        commands += count;
        let mut replayed = replayed.trim_end().to_owned();
        if let Some(first) = block.first().and_then(|line| line.strip_prefix(BY_CARGO)) {
            replayed = replayed.replacen("$ casteljau ", BY_CARGO, 1);
            assert!(replayed.starts_with(&format!("{BY_CARGO}{first}")));
        }
        if block.contains(&"$ cargo test") {
            replayed.push_str("\n\n$ cargo test");
        }
        writeln!(text, "{replayed}\n```").expect("a string");
    }
    (text, commands)
}

#[test]
fn every_command_of_the_readme_prints_what_it_shows() {
    let folder = scratch("readme");
    // The README's reader stands in the project's folder.
    let examples = folder.join("examples");
    std::fs::create_dir_all(&examples).expect("a folder for the test");
    for entry in std::fs::read_dir(root().join("examples")).expect("the examples") {
        let path = entry.expect("an entry").path();
        if path.is_file() {
            std::fs::copy(&path, examples.join(path.file_name().expect("a name"))).expect("a copy");
        }
    }
    let document = std::fs::read_to_string(root().join("README.md")).expect("the README");
    // The worksheet that it shows.
    let worksheet = document.split("````markdown\n").nth(1).and_then(|rest| rest.split("````").next());
    std::fs::write(folder.join("notes.md"), worksheet.expect("a worksheet")).expect("a file for the test");
    let (text, commands) = replayed(&document, &folder);
    assert!(commands >= 12, "only {commands} commands");
    agree("README.md", &text);
    for name in ["cubic.svg", "saddle.svg"] {
        let picture = std::fs::read_to_string(folder.join(name)).expect("the README plots a picture");
        agree(&format!("docs/{name}"), &picture);
    }
    assert!(std::fs::read(folder.join("saddle.glb")).expect("the README writes a mesh").starts_with(b"glTF"));
}

#[test]
fn every_command_about_checks_prints_what_it_shows() {
    let document = std::fs::read_to_string(root().join("docs/check.md")).expect("the document");
    let (text, commands) = replayed(&document, &root().join("tests/cli/check"));
    assert!(commands >= 5, "only {commands} commands");
    agree("docs/check.md", &text);
}

#[test]
fn the_operations_are_those_of_the_table() {
    let mut text = String::from(
        "# Operations\n\n\
         Every operation, made from the table in `src/ops/table/`. A command and `casteljau batch` carry out the same operation:\n\
         `{\"id\": …, \"op\": NAME, \"input\": {…}}` is answered by `{\"id\": …, \"op\": NAME, \"output\": {…}}` or\n\
         `{\"id\": …, \"error\": {\"code\": …, \"message\": …}}`, one a line, in order.\n\n\
         A number is a string (`\"7/3\"`, `\"0.25\"`) or a JSON number, read digit by digit; answers have strings in lowest terms. A curve is\n\
         `{\"degree\": m, \"coeffs\": [[c0, …, cm], …]}`, one list a coordinate, ascending powers; control points are a list of points\n\
         (a plain number is a point of the line); a frame is `[r, s]`. A surface is `{\"degree\": m or [p, q], \"terms\": [[[h, k, c], …], …]}`,\n\
         one list of terms c u^h v^k a coordinate; a control net is a list of rows, in triangles the points f(r^i s^j t^(m-i-j)) with i for the\n\
         row, in rectangles f(r1^(p-i) s1^i; r2^(q-j) s2^j); a frame is `[r, s, t]` with points `[u, v]`, or `[[r1, s1], [r2, s2]]`.\n\
         Where weights are given, the answer's points are `homogeneous_points`, each `[w x, …, w]`. An affine map is\n\
         `{\"matrix\": [[…], …], \"shift\": […]}`, a line or plane `{\"normal\": […], \"offset\": c}`, a homogeneous argument `[t, w]` or `[u, v, w]`,\n\
         a claimed polar form a list of texts, one a coordinate.\n\n\
         Error codes: bad-json, unknown-op, missing-field, unknown-field, bad-number, wrong-shape, wrong-count, degenerate-frame,\n\
         degree-too-low, unsupported, too-large.\n",
    );
    for operation in operations() {
        writeln!(text, "\n## {}\n\n{}.\n", operation.name, operation.doc).expect("a string");
        writeln!(text, "| input | | command line | |\n|---|---|---|---|").expect("a string");
        for parameter in operation.parameters {
            let need = if parameter.required { "required" } else { "optional" };
            let flag = match (operation.verb, parameter.flag) {
                ("", _) => "–".to_owned(),
                (_, "") => "the argument".to_owned(),
                (_, flag) => format!("`--{flag}`"),
            };
            writeln!(text, "| `{}` | {need} | {flag} | {} |", parameter.name, parameter.help).expect("a string");
        }
        if !operation.example.is_empty() {
            let command =
                if operation.example.contains(" -o ") { operation.example.to_owned() } else { format!("{} -q", operation.example) };
            let printed = transcript::printed(&command, &scratch("operations"));
            writeln!(text, "\n```console\n$ {}\n{}```", operation.example, printed).expect("a string");
            assert!(!printed.contains("! error"), "the example of {} fails: {printed}", operation.name);
        }
    }
    agree("docs/operations.md", &text);
}

#[test]
fn the_requests_of_chapter_18_are_answered() {
    let requests = std::fs::read(root().join("examples/chapter18.ndjson")).expect("the example");
    let mut answers = Vec::new();
    casteljau::batch::run(requests.as_slice(), &mut answers).expect("memory");
    let answers = String::from_utf8(answers).expect("UTF-8");
    assert_eq!(answers.lines().count(), 5);
    assert!(!answers.contains("\"error\""), "{answers}");
    assert!(answers.contains(r#"{"points":[["0","0"],["-4","4"],["-4","-12"],["0","0"]]}"#));
}
