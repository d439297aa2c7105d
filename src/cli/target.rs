//! Files that output goes to.

use std::io::Write as _;
use std::path::Path;

use super::diagnostic::Problem;

/// Replaces a file in one step, so that nobody ever sees half of it.
pub(super) fn replace(path: &Path, contents: &[u8]) -> Result<(), Problem> {
    let failed = |error: std::io::Error| Problem::plain(format!("cannot write `{}`: {error}", path.display()));
    let name = path.file_name().map_or_else(|| "output".into(), |name| name.to_string_lossy().into_owned());
    let beside = path.with_file_name(format!(".{name}.{}.part", std::process::id()));
    let written = std::fs::File::create(&beside).and_then(|mut file| {
        file.write_all(contents)?;
        file.sync_all()
    });
    written.and_then(|()| std::fs::rename(&beside, path)).map_err(|error| {
        // Best effort: what could not be written may not be there to remove.
        let _ = std::fs::remove_file(&beside);
        failed(error)
    })
}
