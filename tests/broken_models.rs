//! Files that are not what they should be: an answer for each, and never a
//! panic, a hang or a flood of memory.

use std::path::Path;

use casteljau::model::{Flaw, Format, Model, read};
use proptest::prelude::*;

/// The small files of all formats.
fn samples() -> Vec<(String, Format, String)> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/models");
    let mut samples = Vec::new();
    for entry in std::fs::read_dir(folder).expect("a folder") {
        let path = entry.expect("an entry").path();
        let format = Format::of_path(&path).expect("a known ending");
        let name = path.file_name().expect("a name").to_string_lossy().into_owned();
        samples.push((name, format, std::fs::read_to_string(&path).expect("text")));
    }
    samples.sort();
    samples
}

fn refused(text: &str, format: Format) -> Flaw {
    match read(text, format) {
        Ok(model) => panic!("{format} read {} parts", model.parts.len()),
        Err(flaw) => {
            assert!(flaw.place.is_some(), "{flaw}");
            assert!(flaw.message.len() < 400, "a long message: {flaw}");
            flaw
        }
    }
}

fn all(model: &Model) -> String {
    format!("{model:?}")
}

#[test]
fn samples_cover_all_formats() {
    let samples = samples();
    assert!(Format::ALL.iter().all(|format| samples.iter().any(|sample| sample.1 == *format)));
    for (name, format, text) in samples {
        assert_eq!(Format::of_content(&text), Some(format), "{name}");
    }
}

#[test]
fn line_ends_and_byte_order_marks_make_no_difference() {
    for (name, format, text) in samples() {
        let model = all(&read(&text, format).expect("a good sample"));
        for changed in [text.replace('\n', "\r\n"), format!("\u{feff}{text}"), text.trim_end().to_owned()] {
            assert_eq!(all(&read(&changed, format).unwrap_or_else(|flaw| panic!("{name}: {flaw}"))), model, "{name}");
        }
    }
}

#[test]
fn nothing_and_rubbish() {
    for format in Format::ALL {
        for text in ["", "\0", "\u{feff}", "é", "\n\n\r\n", "{}", "[]", "null", "<", "<a", "<a>", "</a>", "<a></b>", "&", "\"", "\\", "-"]
        {
            // A Wavefront file may hold nothing that is known.
            if format != Format::Wavefront && !(format == Format::BezierView && text.trim_matches(['\u{feff}', '\r', '\n']).is_empty()) {
                refused(text, format);
            } else {
                read(text, format).ok();
            }
        }
    }
}

/// Every file cut at every place: an answer, and where the rest is missing a flaw.
#[test]
fn cut_files() {
    for (name, format, text) in samples() {
        let mut flaws = 0;
        for (at, _) in text.char_indices() {
            flaws += usize::from(read(&text[..at], format).is_err());
        }
        assert!(2 * flaws > text.len() || format == Format::Wavefront, "{name}: {flaws} flaws in {} cuts", text.len());
    }
}

#[test]
fn entities_are_not_expanded() {
    let mut entities = String::from("<!DOCTYPE svg [<!ENTITY l0 \"M0 0 1 1\">");
    for level in 1..10 {
        entities += &format!("<!ENTITY l{level} \"{}\">", format!("&l{};", level - 1).repeat(10));
    }
    let laughs = format!("{entities}]><svg><path d=\"&l9;\"/></svg>");
    assert!(refused(&laughs, Format::Svg).message.contains("entities that the document declares are not expanded"));
    // Declared and unused, as some programs write them, they do no harm.
    let unused = format!("{entities}]><svg xmlns=\"&ns;\"><path d=\"M0 0&#32;1 1&#x20;L2 2\"/>&l9;</svg>");
    let model = read(&unused, Format::Svg).expect("a model");
    assert_eq!(model.parts.len(), 2);
    // All of a value with entities is at its beginning.
    let columns: Vec<u32> = model.joints.iter().map(|joint| joint.place.column).collect();
    assert_eq!(columns, [u32::try_from(unused.find("M0 0&").expect("the path")).expect("a short text") + 1]);
    refused(
        "<!DOCTYPE glyph [<!ENTITY x \"1\">]><glyph><outline><contour><point x=\"&x;\" y=\"0\"/></contour></outline></glyph>",
        Format::Glif,
    );
}

#[test]
fn deep_nesting() {
    let depth = 100_000;
    let nested = format!("<svg>{}<path d=\"M0 0 1 1\"/>{}</svg>", "<g>".repeat(depth), "</g>".repeat(depth));
    assert_eq!(read(&nested, Format::Svg).expect("a model").parts.len(), 1);
    refused(&format!("<svg>{}", "<g a=\"b\">".repeat(depth)), Format::Svg);
    refused(&format!("<glyph>{}", "<outline><contour>".repeat(depth)), Format::Glif);
    refused(&"[".repeat(10 * depth), Format::Shape);
    refused(&format!("{{\"kind\":\"curve\",\"degree\":1,\"points\":{}", "[".repeat(10 * depth)), Format::Shape);
    refused(&"{\"kind\":\"model\",\"pieces\":[".repeat(depth), Format::Shape);
}

#[test]
fn many_attributes_and_members() {
    let attributes: String = (0..200_000).map(|k| format!(" a{k}=\"\"")).collect();
    assert_eq!(read(&format!("<svg><path{attributes} d=\"M0 0 1 1\"/></svg>"), Format::Svg).expect("a model").parts.len(), 1);
    let members: String = (0..200_000).map(|k| format!("\"a{k}\":0,")).collect();
    refused(&format!("{{{members}\"kind\":\"curve\"}}"), Format::Shape);
}

/// The formats with one number to fill in.
fn with_number(number: &str) -> Vec<(Format, String)> {
    let plane = "1,".repeat(15);
    vec![
        (Format::Shape, format!("{{\"kind\":\"curve\",\"degree\":1,\"points\":[[\"{number}\"],[1]]}}")),
        (Format::Svg, format!("<svg><path d=\"M0 0L{number} 1\"/></svg>")),
        (Format::Glif, format!("<glyph><outline><contour><point x=\"{number}\" y=\"0\"/></contour></outline></glyph>")),
        (Format::Newell, format!("1\n{plane}1\n1\n0,0,{number}")),
        (Format::Bpt, format!("1\n0 0\n0 0 {number}")),
        (Format::BezierView, format!("3 0 0 0 {number}")),
        (Format::Wavefront, format!("v 0 0 {number}")),
    ]
}

#[test]
fn numbers_out_of_all_limits() {
    for (format, text) in with_number("1.5e-3") {
        assert!(read(&text, format).is_ok(), "{format}");
    }
    let long = "9".repeat(10_000_000);
    for number in [
        "1e999999999",
        "1e-999999999",
        "NaN",
        "inf",
        "-",
        "0x10",
        "١",
        &long,
        &format!("0.{}", &long[..100_000]),
        &format!("1e{}", &long[..100_000]),
    ] {
        for (format, text) in with_number(number) {
            let flaw = refused(&text, format);
            assert!(flaw.message.starts_with("found"), "{format}: {flaw}");
        }
    }
}

#[test]
fn counts_out_of_all_limits() {
    for (format, text) in [
        (Format::Newell, "4000000000\n1,1"),
        (Format::Newell, "0\n4000000000\n1,1,1"),
        (Format::Newell, "1\n4000000000,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1\n1\n1,1,1"),
        (Format::Newell, "-1"),
        (Format::Bpt, "18446744073709551616\n1 1"),
        (Format::Bpt, "1\n1000000000 1000000000\n0 0 0"),
        (Format::Bpt, "1\n4096 4096\n0 0 0"),
        (Format::Bpt, "1\n-3 3"),
        (Format::BezierView, "1 4000000000 4000000000"),
        (Format::BezierView, "1 0 4000000000 4000000000"),
        (Format::BezierView, "5 1000000000 1"),
        (Format::BezierView, "9 4096 4096 0 0 0"),
        (Format::BezierView, "group -4"),
        (Format::Wavefront, "deg 1000000000"),
        (Format::Wavefront, "deg -3"),
        (Format::Wavefront, "v 0 0 0\ncstype bezier\ndeg 4096\ncurv 0 1 1\nparm u 0 1\nend"),
        (Format::Wavefront, "v 0 0 0\ncurv 0 1 4000000000"),
        (Format::Wavefront, "v 0 0 0\ncurv 0 1 -9223372036854775808"),
        (Format::Shape, "{\"kind\":\"curve\",\"degree\":1000000000,\"points\":[[0],[1]]}"),
        (Format::Shape, "{\"kind\":\"rectangle\",\"degree\":[18446744073709551615,1],\"points\":[[[0],[1]]]}"),
        (Format::Shape, "{\"kind\":\"curve\",\"degree\":-1,\"points\":[[0]]}"),
    ] {
        refused(text, format);
    }
}

/// Short texts for long numbers, and long numbers that are used again and again.
#[test]
fn numbers_longer_than_they_look() {
    let all_ones = "1,".repeat(15);
    for (format, text) in [
        (Format::Svg, format!("<svg><path d=\"M1e9999 0{}\"/></svg>", "l1 0".repeat(4_000))),
        (Format::Svg, format!("<svg><path d=\"M0 0{}\"/></svg>", "T1e-9999 0".repeat(4_000))),
        (Format::Svg, format!("<svg><path d=\"M1e9999 0{}\"/></svg>", "L0 0z".repeat(4_000))),
        (Format::Newell, format!("4000\n{}1\n1e9999,0,0", format!("{all_ones}1\n").repeat(4_000))),
        (Format::Bpt, format!("4000\n{}", "0 0\n0 0 1e9999\n".repeat(4_000))),
        (Format::Wavefront, format!("v 1e9999 0 0\ncstype bezier\ndeg 1\n{}", "curv 0 1 1 1\nparm u 0 1\nend\n".repeat(4_000))),
        (
            Format::Shape,
            format!(
                "{{\"kind\":\"model\",\"pieces\":[{}]}}",
                vec!["{\"kind\":\"curve\",\"degree\":0,\"points\":[\"1e9999\"]}"; 4_000].join(",")
            ),
        ),
    ] {
        refused(&text, format);
    }
}

/// Tokens that stand for trouble.
const TROUBLE: [&str; 16] =
    ["", "-1", "0", "4000000000", "1e999999999", "1e9999", "1/3", "nan", "\0", "<", "&a;", "\"", ",", "#", "\\\n", "é"];

proptest! {
    #![proptest_config(ProptestConfig { cases: 512, ..ProptestConfig::default() })]

    /// Letters replaced, words exchanged or replaced, and the file read as what
    /// it is or as anything else.
    #[test]
    fn damaged_files_are_answered(
        sample in any::<prop::sample::Index>(),
        flips in prop::collection::vec((any::<prop::sample::Index>(), any::<char>()), 0..4),
        swaps in prop::collection::vec((any::<prop::sample::Index>(), any::<prop::sample::Index>()), 0..3),
        troubles in prop::collection::vec((any::<prop::sample::Index>(), prop::sample::select(&TROUBLE[..])), 0..3),
        stranger in prop::option::weighted(0.1, prop::sample::select(&Format::ALL[..])),
    ) {
        let samples = samples();
        let (_, format, text) = sample.get(&samples);
        let mut letters: Vec<char> = text.chars().collect();
        for (at, letter) in flips {
            let at = at.index(letters.len());
            letters[at] = letter;
        }
        let text: String = letters.into_iter().collect();
        let mut words: Vec<&str> = text.split_inclusive([' ', '\n', ',', '"', '[']).collect();
        for (a, b) in swaps {
            let (a, b) = (a.index(words.len()), b.index(words.len()));
            words.swap(a, b);
        }
        let mut words: Vec<String> = words.into_iter().map(str::to_owned).collect();
        for (at, trouble) in troubles {
            let at = at.index(words.len());
            words[at] = format!("{trouble}{}", words[at].chars().last().unwrap_or(' '));
        }
        let text = words.concat();
        let guess = Format::of_content(&text);
        if let Err(flaw) = read(&text, stranger.or(guess).unwrap_or(*format)) {
            prop_assert!(flaw.message.len() < 500, "{}", flaw);
        }
    }
}
