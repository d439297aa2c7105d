//! Input from strangers: every input gets an answer or a clear error, and none
//! ends the program in another way.

use std::io::Write as _;
use std::process::{Command, Output, Stdio};

use proptest::prelude::*;
use serde_json::Value;

/// Runs the program with standard input given.
fn run(arguments: &[&str], input: &[u8]) -> Output {
    let mut child = Command::new(env!("CARGO_BIN_EXE_casteljau"))
        .args(arguments)
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .expect("the program starts");
    let mut stdin = child.stdin.take().expect("a pipe");
    let input = input.to_vec();
    // The program may stop reading early; that closes the pipe and is fine.
    let writer = std::thread::spawn(move || drop(stdin.write_all(&input)));
    let output = child.wait_with_output().expect("the program ends");
    writer.join().expect("the writer ends");
    output
}

/// A refusal: status 2, nothing on standard output, an error that says this.
fn refused(arguments: &[&str], input: &[u8], message: &str) {
    let output = run(arguments, input);
    let errors = String::from_utf8_lossy(&output.stderr).into_owned();
    let shown: String = errors.chars().take(600).collect();
    assert_eq!(output.status.code(), Some(2), "{arguments:?}: {shown}");
    assert!(output.stdout.is_empty(), "{arguments:?}");
    assert!(errors.starts_with("error: ") && errors.contains(message), "{arguments:?}: {shown}");
    assert!(errors.len() < 2000, "{arguments:?}: an error of {} bytes", errors.len());
}

#[test]
fn texts_of_any_size_and_depth() {
    let polar = ["polar", "-"];
    refused(&polar, b"", "found nothing");
    refused(&polar, "(".repeat(1_000_000).as_bytes(), "nest");
    refused(&polar, "-".repeat(1_000_000).as_bytes(), "found");
    refused(&polar, "\\frac{".repeat(100_000).as_bytes(), "found");
    refused(&polar, "√".repeat(100_000).as_bytes(), "found");
    refused(&polar, &"t^".repeat(100_000).into_bytes(), "found");
    refused(&polar, "9".repeat(1_000_000).as_bytes(), "digits");
    refused(&polar, format!("0.{}1", "0".repeat(999_000)).as_bytes(), "digits");
    refused(&polar, b"1e99999999999999999999", "digits");
    refused(&polar, "t".repeat(2_000_000).as_bytes(), "too long");
    refused(&polar, "+".repeat(17 << 20).as_bytes(), "too large");
    refused(&polar, b"t^1000000000", "degree");
    refused(&polar, b"((t^99)^99)^99", "degree");
    refused(&polar, b"((9^999)^999)^999", "digits");
    refused(&polar, b"(a+b+c+d+e+f+g+t)^300", "found");
    refused(&polar, b"\xff\xfe", "not valid UTF-8");
    refused(&polar, "t + \u{202e}2".as_bytes(), "found");
    refused(&polar, b"t + \x07", "found");
    refused(&["polar", "t^2", "--at", &"1 ".repeat(5000)], b"", "found");
    refused(&["points", "t^2", "--over", "0..1..2"], b"", "found");
    refused(&["points", "t^2", "--over", ".."], b"", "found");
    refused(&["polar", "t", "--degree", "999999999999999999999999"], b"", "at most");
    refused(&["polar", "t^12", "--degree", "4000", "--expand"], b"", "terms");
    refused(&["polar", "t^12", "--degree", "4000", "--format", "json"], b"", "terms");
    refused(&["plot", "(t,t,t,t)", "-q"], b"", "coordinates");
    refused(&["eval", "(0,0) (1,1)", "--at", ""], b"", "found nothing");
}

#[test]
fn usage_errors_have_status_2_and_help_has_0() {
    for arguments in [&["nonsense"][..], &["points", "t", "--nonsense"], &["points", "t", "--over"], &["eval", "t", "--at", "--steps"], &[]]
    {
        let output = run(arguments, b"");
        assert_eq!(output.status.code(), Some(2), "{arguments:?}");
        assert!(output.stdout.is_empty() && !output.stderr.is_empty(), "{arguments:?}");
    }
    for arguments in [&["--help"][..], &["--version"], &["polar", "--help"], &["completions", "bash"]] {
        let output = run(arguments, b"");
        assert_eq!(output.status.code(), Some(0), "{arguments:?}");
        assert!(!output.stdout.is_empty(), "{arguments:?}");
    }
    let help = String::from_utf8(run(&["--help"], b"").stdout).expect("text");
    assert!(help.contains("depth of subdivision 20 for curves and 10 for patches"), "{help}");
}

#[cfg(unix)]
#[test]
fn an_argument_that_is_not_utf8() {
    use std::os::unix::ffi::OsStrExt;
    let argument = std::ffi::OsStr::from_bytes(b"t\xff");
    let output = Command::new(env!("CARGO_BIN_EXE_casteljau")).arg("polar").arg(argument).output().expect("the program starts");
    assert_eq!(output.status.code(), Some(2));
    assert!(String::from_utf8_lossy(&output.stderr).contains("not valid UTF-8"));
}

#[cfg(unix)]
#[test]
fn a_closed_pipe_ends_quietly() {
    let mut child = Command::new(env!("CARGO_BIN_EXE_casteljau"))
        .args(["split", "(0,0) (1,2) (3,2) (4,0)", "--depth", "12", "-q"])
        .stdin(Stdio::null())
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .expect("the program starts");
    drop(child.stdout.take());
    let output = child.wait_with_output().expect("the program ends");
    assert_eq!((output.status.code(), output.stderr.as_slice()), (Some(0), &b""[..]));
}

fn answers(input: &[u8]) -> Vec<Value> {
    let mut output = Vec::new();
    casteljau::batch::run(input, &mut output).expect("memory");
    String::from_utf8(output).expect("UTF-8").lines().map(|line| serde_json::from_str(line).expect("an answer is JSON")).collect()
}

#[test]
fn bad_requests_are_answered_and_the_run_goes_on() {
    let good = r#"{"id": "good", "op": "curve.points", "input": {"curve": {"degree": 1, "coeffs": [["0", "1"]]}, "frame": [0, 0.5]}}"#;
    let points = |input: &str| format!(r#"{{"id": 7, "op": "curve.points", "input": {input}}}"#);
    let curve = r#""curve": {"degree": 1, "coeffs": [["0", "1"]]}"#;
    let digits = "1".repeat(1_000_000);
    let cases: Vec<(Vec<u8>, &str)> = vec![
        (b"{".to_vec(), "bad-json"),
        (b"\xff\xff".to_vec(), "bad-json"),
        (b"[1, 2]".to_vec(), "wrong-shape"),
        ("[".repeat(100_000).into_bytes(), "bad-json"),
        (br#"{"id": 7}"#.to_vec(), "missing-field"),
        (br#"{"id": 7, "op": "curve.points"}"#.to_vec(), "missing-field"),
        (br#"{"id": 7, "op": "curve.pints", "input": {}}"#.to_vec(), "unknown-op"),
        (br#"{"id": 7, "op": 5, "input": {}}"#.to_vec(), "wrong-shape"),
        (points("{}").into_bytes(), "missing-field"),
        (points("[]").into_bytes(), "wrong-shape"),
        (points(&format!("{{{curve}}}")).into_bytes(), "missing-field"),
        (points(&format!(r#"{{{curve}, "frame": ["1", "1"]}}"#)).into_bytes(), "degenerate-frame"),
        (points(&format!(r#"{{{curve}, "frame": ["0", "1", "2"]}}"#)).into_bytes(), "wrong-count"),
        (points(&format!(r#"{{{curve}, "frame": [0, 1], "colour": 1}}"#)).into_bytes(), "unknown-field"),
        (points(&format!(r#"{{{curve}, "frame": [0, 1], "degree": 0}}"#)).into_bytes(), "degree-too-low"),
        (points(&format!(r#"{{{curve}, "frame": [0, 1], "degree": 99999999}}"#)).into_bytes(), "too-large"),
        (points(&format!(r#"{{{curve}, "frame": ["a", "1"]}}"#)).into_bytes(), "bad-number"),
        (points(&format!(r#"{{{curve}, "frame": ["1/0", "1"]}}"#)).into_bytes(), "bad-number"),
        (points(&format!(r#"{{{curve}, "frame": [1e999999999, 1]}}"#)).into_bytes(), "too-large"),
        (points(&format!(r#"{{{curve}, "frame": [{digits}, 1]}}"#)).into_bytes(), "too-large"),
        (points(&format!(r#"{{{curve}, "frame": [null, 1]}}"#)).into_bytes(), "wrong-shape"),
        (points(r#"{"curve": {"degree": 2, "coeffs": [["0", "1"]]}, "frame": [0, 1]}"#).into_bytes(), "wrong-count"),
        (points(r#"{"curve": {"degree": 2, "coeffs": []}, "frame": [0, 1]}"#).into_bytes(), "wrong-shape"),
        (points(r#"{"curve": {"degree": 1.5, "coeffs": [[0]]}, "frame": [0, 1]}"#).into_bytes(), "wrong-shape"),
        (br#"{"id": 7, "op": "curve.blossom", "input": {"curve": {"degree": 1, "coeffs": [[0, 1]]}, "args": []}}"#.to_vec(), "wrong-count"),
        (br#"{"id": 7, "op": "curve.equation", "input": {"points": [[0], [1, 2]], "frame": [0, 1]}}"#.to_vec(), "wrong-count"),
        (br#"{"id": 7, "op": "curve.equation", "input": {"points": [], "frame": [0, 1]}}"#.to_vec(), "wrong-shape"),
        (br#"{"id": 7, "op": "roots.bernstein", "input": {"points": [0, 0], "frame": [0, 1]}}"#.to_vec(), "unsupported"),
        (vec![b' '; casteljau::batch::MAX_LINE + 10], "too-large"),
    ];
    let surface = |op: &str, input: &str| format!(r#"{{"id": 7, "op": "{op}", "input": {input}}}"#).into_bytes();
    let triangle = r#""frame": [[1, 0], [0, 1], [0, 0]]"#;
    let cases: Vec<(Vec<u8>, &str)> = cases
        .into_iter()
        .chain([
            (
                surface("triangle.points", r#"{"surface": {"degree": 1, "terms": [[[1, 0, "1"]]]}, "frame": [[0, 0], [1, 1], [2, 2]]}"#),
                "degenerate-frame",
            ),
            (
                surface("triangle.points", r#"{"surface": {"degree": 1, "terms": [[[1, 1, "1"]]]}, "frame": [[1, 0], [0, 1], [0, 0]]}"#),
                "degree-too-low",
            ),
            (
                surface("triangle.points", r#"{"surface": {"degree": [1, 1], "terms": [[]]}, "frame": [[1, 0], [0, 1], [0, 0]]}"#),
                "wrong-shape",
            ),
            (
                surface("triangle.points", r#"{"surface": {"degree": 1, "terms": [[[1, 0]]]}, "frame": [[1, 0], [0, 1], [0, 0]]}"#),
                "wrong-count",
            ),
            (surface("triangle.points", r#"{"surface": {"degree": 4000, "terms": [[]]}, "frame": [[1, 0], [0, 1], [0, 0]]}"#), "too-large"),
            (surface("triangle.equation", &format!(r#"{{"points": [[[0], [1]], [[2], [3]]], "degree": 1, {triangle}}}"#)), "wrong-shape"),
            (surface("triangle.equation", &format!(r#"{{"points": [[[0], [1]], [[2]]], "degree": 2, {triangle}}}"#)), "wrong-count"),
            (surface("triangle.equation", &format!(r#"{{"points": [[[0], [1]], [[2, 3]]], "degree": 1, {triangle}}}"#)), "wrong-count"),
            (surface("triangle.equation", r#"{"points": [[[0], [1]], [[2]]], "degree": 1, "frame": [0, 1]}"#), "wrong-shape"),
            (surface("triangle.blossom", r#"{"surface": {"degree": 1, "terms": [[[1, 0, 1]]]}, "args": [[1, 2, 3]]}"#), "wrong-count"),
            (surface("rectangle.equation", r#"{"points": [[[0], [1]], [[2]]], "frame": [[0, 1], [0, 1]]}"#), "wrong-shape"),
            (
                surface("rectangle.points", r#"{"surface": {"degree": [1, 0], "terms": [[[1, 1, 1]]]}, "frame": [[0, 1], [0, 1]]}"#),
                "degree-too-low",
            ),
            (
                surface("rectangle.points", r#"{"surface": {"degree": [1, 0], "terms": [[]]}, "frame": [[0, 1], [2, 2]]}"#),
                "degenerate-frame",
            ),
            (surface("rectangle.two_step", r#"{"points": [[[0]]], "u": 0, "v": 0, "first": "w"}"#), "wrong-shape"),
            (surface("rational.curve", r#"{"points": [[0], [1]], "frame": [0, 1], "t": 0}"#), "wrong-shape"),
            (surface("rational.curve", r#"{"points": [[0], [1]], "weights": [1], "frame": [0, 1], "t": 0}"#), "wrong-count"),
            (
                surface(
                    "rational.triangle",
                    &format!(r#"{{"points": [[[0], [1]], [[2]]], "weights": [[1], [1, 1]], "degree": 1, {triangle}, "a": [0, 0]}}"#),
                ),
                "wrong-shape",
            ),
            (surface("product", r#"{"surface": {"degree": 1, "terms": [[]]}, "points": [[[0]]]}"#), "unknown-field"),
            (surface("homogenize", r#"{"terms": [[1, 1, "1"]], "degree": 1}"#), "degree-too-low"),
            (surface("influence", r#"{"points": [[0], [1]], "index": [7]}"#), "wrong-shape"),
        ])
        .collect();
    let mut input = Vec::new();
    for (line, _) in &cases {
        input.extend_from_slice(line);
        input.push(b'\n');
        input.extend_from_slice(good.as_bytes());
        input.extend_from_slice(b"\r\n\n");
    }
    let answers = answers(&input);
    assert_eq!(answers.len(), 2 * cases.len());
    for ((line, code), pair) in cases.iter().zip(answers.chunks(2)) {
        let shown = String::from_utf8_lossy(&line[..line.len().min(200)]).into_owned();
        assert_eq!(pair[0]["error"]["code"], *code, "{shown}: {}", pair[0]);
        assert!(pair[0]["error"]["message"].as_str().is_some_and(|message| !message.is_empty() && message.len() < 1000), "{shown}");
        assert!(pair[0]["id"] == 7 || pair[0]["id"].is_null(), "{shown}");
        assert_eq!(pair[1]["output"]["points"], serde_json::json!([["0"], ["1/2"]]), "after {shown}");
    }
}

/// Every answer is written before the next request is waited for.
#[test]
fn batch_answers_before_it_reads_on() {
    use std::io::{BufRead, BufReader};
    let mut child = Command::new(env!("CARGO_BIN_EXE_casteljau"))
        .arg("batch")
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .spawn()
        .expect("the program starts");
    let mut requests = child.stdin.take().expect("a pipe");
    let mut answers = BufReader::new(child.stdout.take().expect("a pipe"));
    for index in 0..3 {
        writeln!(requests, r#"{{"id": {index}, "op": "sigma", "input": {{"values": [1, 2]}}}}"#).expect("the program reads");
        requests.flush().expect("the program reads");
        let mut line = String::new();
        answers.read_line(&mut line).expect("an answer");
        assert!(line.contains(&format!("\"id\":{index}")), "{line}");
    }
    drop(requests);
    assert!(child.wait().expect("the program ends").success());
}

/// Characters that mean something in the grammar, and some that do not.
fn noise() -> impl Strategy<Value = String> {
    let piece = prop::sample::select(vec![
        "t", "t1", "u", "v", "a", "λ", "0", "1", "12", "/", "^", "_", "{", "}", "(", ")", "[", "]", ",", ";", ":", "=", "+", "-", "−", "*",
        "·", ".", "..", "1e", "\\frac", "\\left(", "\\right)", "\\sqrt", "√", "½", "²", "₁", "&", "\\\\", "$$", " ", "\n", "F_1(t)", "z",
        "|", "é", "\u{0}", "\"", "'",
    ]);
    prop::collection::vec(piece, 0..24).prop_map(|pieces| pieces.concat())
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 2000, ..ProptestConfig::default() })]

    #[test]
    fn no_text_panics(text in noise()) {
        use casteljau::syntax;
        let _ = syntax::parse_input(&text, None);
        let _ = syntax::parse_points(&text);
        let _ = syntax::parse_frame(&text);
        let _ = syntax::parse_polar_arguments(&text);
        let _ = syntax::parse_scalars(&text);
        let _ = syntax::parse_components(&text);
    }

    #[test]
    fn no_request_panics(text in "[\\[\\]{}:,\"0-9a-z./ -]{0,60}", points in noise()) {
        let id = serde_json::json!(points);
        let lines = format!("{text}\n{{\"id\": {id}, \"op\": \"curve.reduce\", \"input\": {{\"points\": [[{id}], [1]]}}}}\n");
        for answer in answers(lines.as_bytes()) {
            prop_assert!(answer.get("output").is_some() || answer["error"]["code"].is_string());
        }
    }
}

/// Work that would take minutes or gigabytes is refused before it starts.
#[test]
fn large_but_legal_work_has_limits() {
    let long = "7".repeat(9000);
    refused(&["points", "t^4096", "--over", &format!("0..{long}")], b"", "beyond the limit");
    refused(&["split", "(0,0) (1,1)", "--depth", "20", "-q"], b"", "beyond the limit");
    refused(&["elevate", "(0,0) (1,1)", "--by", "4096", "-q"], b"", "beyond the limit");
    refused(&["bernstein", "--degree", "4000"], b"", "beyond the limit");
    refused(&["points", "(1+t)^200", "--over", "r..s"], b"", "symbolic");
    refused(&["points", "(1+t)^40", "--over", "a+b..c+d"], b"", "symbolic");
    let letters: String = ('a'..='z').filter(|letter| *letter != 't').map(|letter| format!("{letter} ")).collect();
    refused(&["polar", "(1+t)^25", "--at", letters.trim()], b"", "symbolic");
    refused(&["sigma", letters.trim()], b"", "symbolic");
    refused(&["elevate", "(0,0) (1,1)", "--by", "4000", "-q"], b"", "beyond the limit");
    refused(&["points", "a t^400", "--over", "0..1"], b"", "symbolic");
    let many = format!("[{}]", vec!["1"; 3000].join(","));
    refused(&["eval", "-", "--at", "1/3", "--steps", "-q"], many.as_bytes(), "beyond the limit");
    refused(&["product", "-", &many, "-q"], many.as_bytes(), "beyond the limit");
    refused(&["roots", "-", "-q"], format!("[1,{}2]", "0,".repeat(2000)).as_bytes(), "beyond the limit");
}

/// Where standard error cannot be written, the answer and the exit status have to do.
#[cfg(target_os = "linux")]
#[test]
fn a_full_standard_error_does_not_panic() {
    for (arguments, status) in [(&["eval", "(0,0) (1,1)", "--at", "1/2"][..], 0), (&["eval", "(0,0", "--at", "1/2"], 2)] {
        let full = std::fs::OpenOptions::new().write(true).open("/dev/full").expect("the device");
        let output = Command::new(env!("CARGO_BIN_EXE_casteljau")).args(arguments).stderr(full).output().expect("the program starts");
        assert_eq!(output.status.code(), Some(status), "{arguments:?}");
    }
}

/// A worksheet on standard input is held to the same limit as one in a file,
/// also where the limit is inside a character.
#[test]
fn worksheets_on_standard_input() {
    let output = run(&["verify", "-"], "½".repeat((8 << 20) + 1).as_bytes());
    let errors = String::from_utf8_lossy(&output.stderr).into_owned();
    assert_eq!((output.status.code(), errors.contains("too long; at most 16777216 bytes")), (Some(2), true), "{errors}");
}

/// Pictures and meshes replace a file in one step: another name of the old one keeps its text.
#[test]
fn pictures_are_never_half_written() {
    let folder = std::path::Path::new(env!("CARGO_TARGET_TMPDIR")).join("pictures");
    let _ = std::fs::remove_dir_all(&folder);
    std::fs::create_dir_all(&folder).expect("a folder");
    let (picture, other) = (folder.join("picture.svg"), folder.join("other"));
    std::fs::write(&picture, "before").expect("a file");
    std::fs::hard_link(&picture, &other).expect("a second name");
    let output = run(&["plot", "(t, t^2)", "--over", "0..1", "-o", &picture.to_string_lossy()], b"");
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    assert!(std::fs::read_to_string(&picture).expect("a picture").contains("<svg"));
    assert_eq!(std::fs::read_to_string(&other).expect("the old file"), "before");
}
