//! Transcripts: command lines and exactly what they print.
//!
//! A line `$ casteljau …` is a command (single quotes group, `\` at the end of
//! a line continues it); the lines up to the next command are its standard
//! output, then its standard error with `! ` before each line, then `[exit N]`
//! if the exit status is not 0. `#` lines and blank lines between are comments.

use std::fmt::Write as _;
use std::path::Path;
use std::process::{Command, Output, Stdio};

/// Splits a command line into words as a shell does with single quotes.
pub(crate) fn words(line: &str) -> Vec<String> {
    let mut words = Vec::new();
    let mut current: Option<String> = None;
    let mut quoted = false;
    for letter in line.chars() {
        match letter {
            '\'' => {
                quoted = !quoted;
                current.get_or_insert_default();
            }
            ' ' if !quoted => words.extend(current.take()),
            _ => current.get_or_insert_default().push(letter),
        }
    }
    assert!(!quoted, "unbalanced quote in {line}");
    words.extend(current);
    words
}

/// Runs the program with these words (the first is its name).
pub(crate) fn run(words: &[String], directory: &Path) -> Output {
    assert_eq!(words[0], "casteljau", "transcripts run this program only");
    Command::new(env!("CARGO_BIN_EXE_casteljau"))
        .args(&words[1..])
        .current_dir(directory)
        .stdin(Stdio::null())
        .env_remove("NO_COLOR")
        .output()
        .expect("the program starts")
}

/// What a command prints, in the form of a transcript.
pub(crate) fn printed(line: &str, directory: &Path) -> String {
    let output = run(&words(line), directory);
    let mut text = String::from_utf8(output.stdout).expect("standard output is UTF-8");
    for line in String::from_utf8(output.stderr).expect("standard error is UTF-8").lines() {
        writeln!(text, "! {line}").expect("a string");
    }
    match output.status.code() {
        Some(0) => {}
        Some(code) => writeln!(text, "[exit {code}]").expect("a string"),
        None => text.push_str("[killed]\n"),
    }
    // Trailing blanks are invisible in a transcript.
    text.lines().map(|line| format!("{}\n", line.trim_end())).collect()
}

/// A transcript with everything that commands print taken from the program.
pub(crate) fn replayed(transcript: &str, directory: &Path) -> (String, usize) {
    let mut replayed = String::new();
    let mut commands = 0;
    let mut lines = transcript.lines().peekable();
    while let Some(line) = lines.next() {
        replayed.push_str(line);
        replayed.push('\n');
        let Some(command) = line.strip_prefix("$ ") else { continue };
        let mut command = command.to_owned();
        while let Some(start) = command.strip_suffix('\\') {
            let next = lines.next().expect("a continued command goes on");
            replayed.push_str(next);
            replayed.push('\n');
            command = format!("{start}{}", next.trim_start());
        }
        commands += 1;
        replayed.push_str(&printed(&command, directory));
        // What was recorded goes until the next command or comment; the blank lines before it stay.
        let mut blanks = 0;
        while let Some(&next) = lines.peek() {
            if next.starts_with("$ ") || next.starts_with("# ") {
                break;
            }
            blanks = if next.is_empty() { blanks + 1 } else { 0 };
            lines.next();
        }
        replayed.push_str(&"\n".repeat(blanks));
    }
    (replayed, commands)
}
