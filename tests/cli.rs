//! Every transcript in `tests/cli/` is what the program prints.
//!
//! `CASTELJAU_BLESS=1 cargo test --test cli` rewrites them; read the difference
//! before committing it.

mod transcript;

use std::path::Path;

#[test]
fn transcripts_are_what_the_program_prints() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/cli");
    let bless = std::env::var_os("CASTELJAU_BLESS").is_some();
    let mut commands = 0;
    let mut differing = Vec::new();
    let mut paths: Vec<_> = std::fs::read_dir(&folder).expect("the folder exists").map(|entry| entry.expect("an entry").path()).collect();
    paths.sort();
    for path in paths.iter().filter(|path| path.extension().is_some_and(|extension| extension == "txt")) {
        let recorded = std::fs::read_to_string(path).expect("a readable transcript");
        let (replayed, count) = transcript::replayed(&recorded, &folder);
        commands += count;
        if bless {
            std::fs::write(path, &replayed).expect("a writable transcript");
        } else if replayed != recorded {
            let line = recorded.lines().zip(replayed.lines()).position(|(a, b)| a != b);
            let line = line.unwrap_or(recorded.lines().count().min(replayed.lines().count()));
            differing.push(format!(
                "{}:{}: recorded {:?}, printed {:?}",
                path.display(),
                line + 1,
                recorded.lines().nth(line),
                replayed.lines().nth(line)
            ));
        }
    }
    assert!(differing.is_empty(), "{}", differing.join("\n"));
    assert!(commands > 80, "only {commands} commands ran");
}
