//! `casteljau.toml`: what a project asks of its files.

use std::path::{Path, PathBuf};
use std::str::FromStr;

use globset::{GlobBuilder, GlobMatcher};
use serde::Deserialize;

use crate::audit::{Requirement, Terms, Tolerance};
use crate::cli::diagnostic::Problem;
use crate::exact::Rational;
use crate::syntax::{Span, SyntaxError};

/// The name of the file that is looked for.
const NAME: &str = "casteljau.toml";

/// What is asked of joins, as far as it is said.
#[derive(Clone, Debug, Default)]
pub(super) struct Demands {
    /// `Some(None)`: nothing is required, not even what a file promises.
    pub(super) require: Option<Option<Requirement>>,
    pub(super) tolerance: Option<Tolerance>,
    pub(super) snap: Option<Rational>,
}

impl Demands {
    /// These demands, and where they say nothing, others.
    fn or(self, other: &Self) -> Self {
        Self {
            require: self.require.or(other.require),
            tolerance: self.tolerance.or_else(|| other.tolerance.clone()),
            snap: self.snap.or_else(|| other.snap.clone()),
        }
    }

    pub(super) fn terms(&self) -> Terms {
        Terms {
            require: self.require.flatten(),
            ignores_promises: self.require == Some(None),
            tolerance: self.tolerance.clone().unwrap_or_default(),
        }
    }
}

/// The settings of a run: those of the file, and those of the command line above them.
#[derive(Debug, Default)]
pub(super) struct Settings {
    /// The folder that patterns and paths are relative to.
    folder: PathBuf,
    demands: Demands,
    by_path: Vec<(GlobMatcher, Demands)>,
    exclude: Vec<GlobMatcher>,
    pub(super) baseline: Option<PathBuf>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Document {
    require: Option<String>,
    tolerance: Option<String>,
    snap: Option<toml::Value>,
    baseline: Option<String>,
    #[serde(default)]
    exclude: Vec<String>,
    #[serde(default)]
    path: Vec<PathTable>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct PathTable {
    glob: String,
    require: Option<String>,
    tolerance: Option<String>,
    snap: Option<toml::Value>,
}

/// A requirement, or the word that there is none.
pub(super) fn requirement(text: &str) -> Result<Option<Requirement>, String> {
    if text == "none" { Ok(None) } else { Requirement::from_str(text).map(Some).map_err(|error| format!("{error}, or none")) }
}

/// The distance up to which ends are matched.
pub(super) fn snap(text: &str) -> Result<Rational, String> {
    let snap: Rational = text.parse().map_err(|error| format!("found `{text}`: {error}"))?;
    if snap > Rational::from(0) { Ok(snap) } else { Err(format!("found `{text}`: the snap is a distance above 0")) }
}

fn demands(require: Option<&str>, tolerance: Option<&str>, distance: Option<&toml::Value>) -> Result<Demands, String> {
    let named = |name: &'static str| move |error: String| format!("`{name}`: {error}");
    let distance = match distance {
        None => None,
        Some(toml::Value::String(text)) => Some(text.clone()),
        // A float would have been rounded already.
        Some(toml::Value::Integer(number)) => Some(number.to_string()),
        Some(_) => return Err("`snap`: write the number as a text, such as snap = \"0.001\", so that it is read exactly".into()),
    };
    Ok(Demands {
        require: require.map(requirement).transpose().map_err(named("require"))?,
        tolerance: tolerance.map(Tolerance::from_str).transpose().map_err(named("tolerance"))?,
        snap: distance.as_deref().map(snap).transpose().map_err(named("snap"))?,
    })
}

fn matcher(pattern: &str) -> Result<GlobMatcher, String> {
    let glob = GlobBuilder::new(pattern).literal_separator(true).build().map_err(|error| format!("the pattern `{pattern}`: {error}"))?;
    Ok(glob.compile_matcher())
}

impl Settings {
    /// The settings of a file; without one, of the nearest `casteljau.toml` in
    /// the working directory or above it.
    pub(super) fn find(given: Option<&str>) -> Result<Self, Problem> {
        let path = match given {
            Some(path) => PathBuf::from(path),
            None => {
                let Ok(here) = std::env::current_dir() else { return Ok(Self::default()) };
                let Some(path) = here.ancestors().map(|folder| folder.join(NAME)).find(|path| path.is_file()) else {
                    return Ok(Self::default());
                };
                path
            }
        };
        let text = crate::cli::files::text(&path).map_err(|error| Problem::plain(format!("cannot read `{}`: {error}", path.display())))?;
        let shown = given.map_or_else(|| NAME.to_owned(), str::to_owned);
        Self::read(&text, path.parent().unwrap_or(Path::new(""))).map_err(|(message, span)| match span {
            Some(span) => Problem::syntax(&shown, &text, SyntaxError::new(Span::new(span.start, span.end), message)),
            None => Problem::plain(format!("{shown}: {message}")),
        })
    }

    fn read(text: &str, folder: &Path) -> Result<Self, (String, Option<std::ops::Range<usize>>)> {
        let document: Document = toml::from_str(text).map_err(|error| (error.message().to_owned(), error.span()))?;
        let plain = |message: String| (message, None);
        let mut by_path = Vec::new();
        for table in &document.path {
            let of_path = demands(table.require.as_deref(), table.tolerance.as_deref(), table.snap.as_ref())
                .map_err(|error| plain(format!("in the table for `{}`: {error}", table.glob)))?;
            by_path.push((matcher(&table.glob).map_err(plain)?, of_path));
        }
        Ok(Self {
            folder: folder.to_owned(),
            demands: demands(document.require.as_deref(), document.tolerance.as_deref(), document.snap.as_ref()).map_err(plain)?,
            by_path,
            exclude: document.exclude.iter().map(|pattern| matcher(pattern)).collect::<Result<_, _>>().map_err(plain)?,
            baseline: document.baseline.map(|baseline| folder.join(baseline)),
        })
    }

    /// A path as patterns see it: relative to the settings' folder.
    fn relative(&self, path: &Path) -> PathBuf {
        crate::cli::files::relative(path, &self.folder)
    }

    /// Whether files found at this path are left out.
    pub(super) fn excludes(&self, path: &Path) -> bool {
        let relative = self.relative(path);
        self.exclude.iter().any(|pattern| pattern.is_match(&relative))
    }

    /// What is asked of a file: what the command line says, else the last of the
    /// tables that match its path, else the file's settings as a whole.
    pub(super) fn of(&self, path: &Path, above: &Demands) -> Demands {
        let relative = self.relative(path);
        let tables = self.by_path.iter().filter(|(pattern, _)| pattern.is_match(&relative));
        let by_path = tables.fold(Demands::default(), |found, (_, demands)| demands.clone().or(&found));
        above.clone().or(&by_path).or(&self.demands)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn read(text: &str) -> Result<Settings, String> {
        Settings::read(text, Path::new("/project")).map_err(|(message, _)| message)
    }

    #[test]
    fn tables_override_by_path() {
        let settings = read(
            "require = \"G1\"\ntolerance = \"0.01deg\"\nbaseline = \"known.json\"\nexclude = [\"old/**\"]\n\
             [[path]]\nglob = \"icons/**\"\nrequire = \"none\"\n[[path]]\nglob = \"icons/*.svg\"\nsnap = \"0.001\"\n",
        );
        let settings = settings.expect("settings");
        let of = |path: &str| settings.of(Path::new(path), &Demands::default());
        assert_eq!(of("/project/a.bv").require, Some(Some(Requirement::G1)));
        assert!(of("/project/a.bv").tolerance.is_some() && of("/project/a.bv").snap.is_none());
        assert_eq!(of("/project/icons/a.svg").require, Some(None));
        assert_eq!(of("/project/icons/a.svg").snap, Some(Rational::new(1, 1000)));
        assert_eq!(of("/project/icons/deep/a.svg").snap, None);
        let above = Demands { require: Some(Some(Requirement::C1)), ..Demands::default() };
        assert_eq!(settings.of(Path::new("/project/icons/a.svg"), &above).terms().require, Some(Requirement::C1));
        assert!(settings.excludes(Path::new("/project/old/a/b.svg")) && !settings.excludes(Path::new("/project/new/a.svg")));
        assert_eq!(settings.baseline, Some(PathBuf::from("/project/known.json")));
    }

    #[test]
    fn what_is_wrong_is_said() {
        for (text, part) in [
            ("require = \"G3\"", "expected C0"),
            ("requires = \"G1\"", "unknown field"),
            ("snap = 0.1", "as a text"),
            ("snap = \"-1\"", "above 0"),
            ("tolerance = \"5\"", "with its unit"),
            ("exclude = [\"a[\"]", "pattern"),
            ("[[path]]\nrequire = \"G1\"", "glob"),
            ("require = ", ""),
        ] {
            let error = read(text).map(|_| ()).expect_err(text);
            assert!(error.contains(part), "{text}: {error}");
        }
    }
}
