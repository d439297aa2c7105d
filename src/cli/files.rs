//! The files that checkers look at.

use std::io::Read;
use std::path::{Path, PathBuf};

use ignore::WalkBuilder;

use super::diagnostic::Problem;

/// The most bytes of a file.
const MAX_BYTES: u64 = 1 << 30;

/// A file to look at.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Candidate {
    pub(super) path: PathBuf,
    /// Whether the user named it; one that was found in a folder need not hold anything.
    pub(super) named: bool,
}

impl Candidate {
    /// The path as reports show it: with slashes.
    pub(super) fn shown(&self) -> String {
        shown(&self.path)
    }
}

/// A path with slashes, without `./` before it.
pub(super) fn shown(path: &Path) -> String {
    let text = path.to_string_lossy();
    let text = if std::path::MAIN_SEPARATOR == '\\' { text.replace('\\', "/") } else { text.into_owned() };
    text.strip_prefix("./").map_or_else(|| text.clone(), str::to_owned)
}

/// A path as seen from a folder; one that is not below it as it is.
pub(super) fn relative(path: &Path, folder: &Path) -> PathBuf {
    // The folder of a file that is named alone is the working directory.
    let folder = if folder.as_os_str().is_empty() { Path::new(".") } else { folder };
    let absolute = |path: &Path| std::path::absolute(path).unwrap_or_else(|_| path.to_owned());
    absolute(path).strip_prefix(absolute(folder)).map_or_else(|_| path.to_owned(), Path::to_owned)
}

/// The files that paths stand for, in order of their paths: of a folder all
/// below it that are wanted, what version control ignores left out.
pub(super) fn collect(paths: &[String], wanted: impl Fn(&Path) -> bool) -> Result<Vec<Candidate>, Problem> {
    let mut found = Vec::new();
    for path in paths {
        let path = Path::new(path);
        let kind = std::fs::metadata(path).map_err(|error| Problem::plain(format!("cannot read `{}`: {error}", path.display())))?;
        if !kind.is_dir() {
            found.push(Candidate { path: path.to_owned(), named: true });
            continue;
        }
        for entry in WalkBuilder::new(path).sort_by_file_path(Path::cmp).build() {
            let entry = entry.map_err(|error| Problem::plain(format!("cannot read the folder: {error}")))?;
            let is_file = entry.file_type().is_some_and(|kind| kind.is_file());
            if is_file && wanted(entry.path()) {
                found.push(Candidate { path: entry.into_path(), named: false });
            }
        }
    }
    found.sort_by(|a, b| a.path.cmp(&b.path).then(b.named.cmp(&a.named)));
    found.dedup_by(|later, first| later.path == first.path);
    Ok(found)
}

/// The text of a file.
pub(super) fn text(path: &Path) -> Result<String, String> {
    text_within(path, MAX_BYTES)
}

/// The text of a file of at most so many bytes.
pub(super) fn text_within(path: &Path, most: u64) -> Result<String, String> {
    read_within(std::fs::File::open(path).map_err(|error| error.to_string())?, most)
}

/// The text that a reader gives, as far as it is not too long: what has no size
/// beforehand may never end.
pub(super) fn read(reader: impl Read) -> Result<String, String> {
    read_within(reader, MAX_BYTES)
}

/// The same of at most so many bytes.
pub(super) fn read_within(reader: impl Read, most: u64) -> Result<String, String> {
    let mut bytes = Vec::new();
    reader.take(most.saturating_add(1)).read_to_end(&mut bytes).map_err(|error| error.to_string())?;
    if bytes.len() as u64 > most {
        return Err(format!("the file is too long; at most {most} bytes are read"));
    }
    String::from_utf8(bytes)
        .map_err(|error| format!("not valid UTF-8: byte {} does not belong to any character", error.utf8_error().valid_up_to()))
}
