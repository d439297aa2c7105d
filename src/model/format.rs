//! The formats of files that hold pieces.

use std::fmt;
use std::path::Path;

use super::scanner::{Scanner, Word};
use crate::syntax::limits::MAX_DEGREE;

/// A file format.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Format {
    /// Shape files: JSON with the kinds curve, triangle, rectangle, spline and model.
    Shape,
    /// The path data of Scalable Vector Graphics.
    Svg,
    /// A glyph of a Unified Font Object.
    Glif,
    /// Patches by indices of vertices, as the Utah teapot was published.
    Newell,
    /// Patches one after the other with their degrees.
    Bpt,
    /// BezierView: patches of several kinds.
    BezierView,
    /// The free-form curves and surfaces of Wavefront OBJ.
    Wavefront,
}

impl Format {
    /// All of them.
    pub const ALL: [Self; 7] = [Self::Shape, Self::Svg, Self::Glif, Self::Newell, Self::Bpt, Self::BezierView, Self::Wavefront];

    /// The name that the command line and reports use.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Shape => "shape",
            Self::Svg => "svg",
            Self::Glif => "glif",
            Self::Newell => "newell",
            Self::Bpt => "bpt",
            Self::BezierView => "bv",
            Self::Wavefront => "obj",
        }
    }

    /// The format with a name.
    #[must_use]
    pub fn named(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|format| format.name() == name)
    }

    /// The format that a file's ending says it has.
    #[must_use]
    pub fn of_path(path: &Path) -> Option<Self> {
        let name = path.file_name()?.to_str()?.to_ascii_lowercase();
        let endings = [
            (".json", Self::Shape),
            (".svg", Self::Svg),
            (".glif", Self::Glif),
            (".patches.txt", Self::Newell),
            (".newell", Self::Newell),
            (".bpt", Self::Bpt),
            (".bv", Self::BezierView),
            (".obj", Self::Wavefront),
        ];
        endings.into_iter().find(|(ending, _)| name.ends_with(ending)).map(|(_, format)| format)
    }

    /// The format that the beginning of a file shows, for files whose ending
    /// says nothing.
    #[must_use]
    pub fn of_content(text: &str) -> Option<Self> {
        let text = text.trim_start_matches('\u{feff}').trim_start();
        match text.bytes().next()? {
            b'{' => Some(Self::Shape),
            b'<' => of_markup(text),
            b'0'..=b'9' => of_counts(text),
            _ if text.get(..5).is_some_and(|word| word.eq_ignore_ascii_case("group")) => Some(Self::BezierView),
            _ => of_keyword(text),
        }
    }
}

/// How far into a file its format is looked for.
const BEGINNING: usize = 1 << 14;

fn of_markup(text: &str) -> Option<Format> {
    let end = text.char_indices().map(|(at, _)| at).take_while(|&at| at <= BEGINNING).last()?;
    let names = text[..end].split('<').map(|tag| {
        let name = tag.split(|letter: char| letter.is_whitespace() || matches!(letter, '>' | '/')).next().unwrap_or_default();
        name.rsplit(':').next().unwrap_or_default()
    });
    names.into_iter().find_map(|name| match name {
        "svg" => Some(Format::Svg),
        "glyph" => Some(Format::Glif),
        _ => None,
    })
}

/// The formats that begin with numbers, told apart by their counts.
fn of_counts(text: &str) -> Option<Format> {
    let mut lines = text.lines().filter(|line| !line.trim().is_empty());
    let (first, second) = (lines.next()?, lines.next().unwrap_or_default());
    if first.split_whitespace().count() == 1 && (second.contains(',') || second.split_whitespace().count() == 16) {
        return Some(Format::Newell);
    }
    let mut scanner = Scanner::new(text);
    let count = scanner.next().and_then(Word::whole)?;
    let is_kind = matches!(count, 1 | 3 | 4 | 5 | 8 | 9 | 10);
    Some(if !is_kind || has_second_patch(&mut scanner, count) { Format::Bpt } else { Format::BezierView })
}

/// Whether the first of so many patches is followed by the two degrees of the
/// next in a line of their own, or for the only one by nothing.
fn has_second_patch(scanner: &mut Scanner, count: usize) -> bool {
    let mut degree = || scanner.next().and_then(Word::whole).filter(|&degree| degree <= MAX_DEGREE as usize);
    let (Some(p), Some(q)) = (degree(), degree()) else { return false };
    if (0..3 * (p + 1) * (q + 1)).any(|_| scanner.next().is_none()) {
        return false;
    }
    let [first, second, third] = [(); 3].map(|()| scanner.next().map(|word| word.starts_line));
    if count == 1 { first.is_none() } else { (first, second) == (Some(true), Some(false)) && third != Some(false) }
}

/// Wavefront files, by the first word behind the comments.
fn of_keyword(text: &str) -> Option<Format> {
    const KEYWORDS: [&str; 22] = [
        "v", "vt", "vn", "vp", "cstype", "deg", "bmat", "step", "p", "l", "f", "curv", "curv2", "surf", "g", "s", "mg", "o", "mtllib",
        "usemtl", "bevel", "lod",
    ];
    let line = text.lines().take(BEGINNING).map(str::trim).find(|line| !line.is_empty() && !line.starts_with('#'))?;
    let word = line.split_whitespace().next()?;
    KEYWORDS.contains(&word).then_some(Format::Wavefront)
}

impl fmt::Display for Format {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn formats_by_their_content() {
        let square = "0 0 0\n0 1 0\n1 0 0\n1 1 0\n";
        for (text, format) in [
            (" {\"kind\"".to_owned(), Some(Format::Shape)),
            ("\u{feff}<?xml version='1.0'?>\n<!-- <b> -->\n<svg:svg>".into(), Some(Format::Svg)),
            ("<?xml version='1.0'?><glyph name='a'>".into(), Some(Format::Glif)),
            ("<html><p>".into(), None),
            ("32\n1,2,3,4".into(), Some(Format::Newell)),
            (format!("2\n1 1\n{square}1 1\n{square}"), Some(Format::Bpt)),
            (format!("5\n1 1\n{square}1 1\n{square}"), Some(Format::Bpt)),
            (format!("1\n1 1\n{square}"), Some(Format::Bpt)),
            (format!("5\n1 1\n{square}5\n1 1\n{square}"), Some(Format::BezierView)),
            (format!("5 1 1\n{square}"), Some(Format::BezierView)),
            ("1 3 1 0 0 0".into(), Some(Format::BezierView)),
            ("Group 1 lid\n3".into(), Some(Format::BezierView)),
            ("# a teapot\n\nv 1 2 3".into(), Some(Format::Wavefront)),
            ("hello".into(), None),
            ("".into(), None),
            ("\0".into(), None),
        ] {
            assert_eq!(Format::of_content(&text), format, "{text}");
        }
    }
}
