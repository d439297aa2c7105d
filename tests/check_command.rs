//! Runs of `check` that write files, and many of them.

use std::path::{Path, PathBuf};
use std::process::{Command, Output};

fn scratch(name: &str) -> PathBuf {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join(name);
    let _ = std::fs::remove_dir_all(&folder);
    std::fs::create_dir_all(&folder).expect("a folder for the test");
    folder
}

fn check(folder: &Path, arguments: &[&str]) -> Output {
    let program = env!("CARGO_BIN_EXE_casteljau");
    Command::new(program).arg("check").args(arguments).current_dir(folder).output().expect("the program starts")
}

fn status(folder: &Path, arguments: &[&str]) -> i32 {
    check(folder, arguments).status.code().expect("a status")
}

fn patch(x: [&str; 2], z: [&str; 2]) -> String {
    format!("5\n1 1\n{0} 0 {2}\n{0} 1 {2}\n{1} 0 {3}\n{1} 1 {3}\n", x[0], x[1], z[0], z[1])
}

#[test]
fn known_findings_survive_what_does_not_concern_them() {
    let folder = scratch("baseline");
    let pieces = [patch(["0", "1"], ["0", "0"]), patch(["1", "2"], ["0", "0.5"]), patch(["2", "3"], ["0.5", "1"])];
    let write = |order: &[usize]| {
        let text: String = order.iter().map(|&index| format!("group {index} piece\n{}", pieces[index])).collect();
        std::fs::write(folder.join("roof.bv"), text).expect("a file");
    };
    write(&[0, 1]);
    let flags = ["roof.bv", "--require", "G1"];
    let with = |more: &[&'static str]| [&flags[..], more].concat();
    assert_eq!(status(&folder, &flags), 1);
    assert_eq!(status(&folder, &with(&["--write-baseline", "known.json"])), 0);
    assert_eq!(status(&folder, &with(&["--baseline", "known.json"])), 0);
    // Another order, another piece that joins smoothly: nothing new.
    write(&[2, 1, 0]);
    let known = check(&folder, &with(&["--baseline", "known.json"]));
    assert_eq!(known.status.code(), Some(0), "{}", String::from_utf8_lossy(&known.stdout));
    assert!(String::from_utf8_lossy(&known.stdout).contains("1 violated (1 known)"));
    // The settings name the baseline as well.
    std::fs::write(folder.join("casteljau.toml"), "require = \"G1\"\nbaseline = \"known.json\"\n").expect("settings");
    assert_eq!(status(&folder, &["roof.bv"]), 0);
    assert_eq!(status(&folder, &["roof.bv", "--no-config", "--require", "G1"]), 1);
    // Another crease is another finding, and the old one is gone.
    std::fs::write(folder.join("roof.bv"), pieces[0].clone() + &patch(["1", "2"], ["0", "0.75"])).expect("a file");
    let other = check(&folder, &["roof.bv"]);
    assert_eq!(other.status.code(), Some(1));
    assert!(String::from_utf8_lossy(&other.stderr).contains("1 findings of the baseline do not occur"), "{other:?}");
    // A broken baseline is no baseline.
    std::fs::write(folder.join("known.json"), "{\"version\": 2, \"findings\": []}").expect("a file");
    assert_eq!(status(&folder, &["roof.bv"]), 2);
}

#[test]
fn every_format_of_the_output_says_the_same() {
    let folder = scratch("formats");
    std::fs::write(folder.join("roof.bv"), patch(["0", "1"], ["0", "0"]) + &patch(["1", "2"], ["0", "0.5"])).expect("a file");
    std::fs::write(folder.join("broken.bv"), "5\n1 1\n0 0 0\n").expect("a file");
    for (format, part) in [
        ("text", "J002"),
        ("json", "\"violated\":1"),
        ("sarif", "\"ruleId\": \"J002\""),
        ("junit", "failures=\"1\" errors=\"1\""),
        ("github", "::error file=roof.bv"),
    ] {
        let output = check(&folder, &["roof.bv", "broken.bv", "--require", "G1", "--format", format, "-o", "out"]);
        assert_eq!((output.status.code(), output.stdout.len()), (Some(2), 0), "{format}");
        let text = std::fs::read_to_string(folder.join("out")).expect("the output");
        let compact = text.replace("\":\"", "\": \"");
        assert!(compact.contains(part) || text.contains(part), "{format}: {text}");
        assert!(text.contains("broken.bv"), "{format}: {text}");
    }
    // Nothing is left beside what was asked for.
    let mut names: Vec<String> = std::fs::read_dir(&folder)
        .expect("the folder")
        .map(|entry| entry.expect("an entry").file_name().to_string_lossy().into_owned())
        .collect();
    names.sort();
    assert_eq!(names, ["broken.bv", "out", "roof.bv"]);
}

#[test]
fn pictures_mark_what_is_violated() {
    let folder = scratch("plot");
    std::fs::write(folder.join("roof.bv"), patch(["0", "1"], ["0", "0"]) + &patch(["1", "2"], ["0", "0.5"])).expect("a file");
    std::fs::write(folder.join("s.svg"), "<svg><path d=\"M0 0C1 0 2 0 3 0C4 1 5 1 6 1\"/></svg>").expect("a file");
    assert_eq!(status(&folder, &[".", "--require", "G1", "--plot", "findings.svg"]), 1);
    let picture = std::fs::read_to_string(folder.join("findings.svg")).expect("a picture");
    assert!(picture.contains("roof.bv") && picture.contains("s.svg"));
    assert!(picture.contains("stroke=\"#d0021b\" stroke-width=\"3.5\"") && picture.contains("the tangents differ"), "{picture}");
}

#[test]
fn threads_do_not_change_a_letter() {
    let folder = scratch("threads");
    let mut text = String::new();
    for k in 0..60 {
        text += &patch([&k.to_string(), &(k + 1).to_string()], [&format!("0.{k:02}"), &format!("0.{:02}", k + 1 + k % 3)]);
    }
    std::fs::write(folder.join("strip.bv"), text).expect("a file");
    let run =
        |jobs: &str| check(&folder, &["strip.bv", "--require", "G1", "--tolerance", "1deg", "--format", "json", "--jobs", jobs]).stdout;
    assert_eq!(run("1"), run("2"));
    assert_eq!(run("1"), run("7"));
}

#[test]
fn a_closed_pipe_and_a_missing_folder_are_no_panics() {
    let folder = scratch("missing");
    let output = check(&folder, &["nothing", "--require", "G1"]);
    assert_eq!(output.status.code(), Some(2));
    assert!(String::from_utf8_lossy(&output.stderr).contains("cannot read `nothing`"));
    let output = check(&folder, &["."]);
    assert_eq!(output.status.code(), Some(2));
    assert!(String::from_utf8_lossy(&output.stderr).contains("--allow-empty"));
    assert_eq!(status(&folder, &[".", "--allow-empty"]), 0);
}
