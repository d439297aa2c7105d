//! Worksheets as pages.

use std::io;
use std::path::Path;

use super::Checked;
use super::wording::summary;
use crate::cli::diagnostic::Problem;
use crate::cli::target;
use crate::worksheet::{self, Format};

/// Writes the worksheets as pages, and a page that leads to them if there are several.
pub(super) fn pages(folder: &Path, checked: &[Checked]) -> Result<(), Problem> {
    let failed = |path: &Path, error: io::Error| Problem::plain(format!("cannot write `{}`: {error}", path.display()));
    std::fs::create_dir_all(folder).map_err(|error| failed(folder, error))?;
    let mut index = Vec::new();
    let mut taken = Vec::new();
    for file in checked {
        // What leads out of the folder stays behind.
        let parts = Path::new(&file.path).components().filter_map(|part| match part {
            std::path::Component::Normal(name) => Some(name.to_string_lossy()),
            _ => None,
        });
        let parts: Vec<_> = parts.collect();
        let stem = |name: &str| name.rsplit_once('.').map_or(name, |(stem, _)| stem).to_owned();
        let mut name = parts.last().map_or_else(|| "worksheet".to_owned(), |last| stem(last));
        if taken.contains(&name) || name == "index" {
            name = stem(&parts.join("-"));
        }
        while taken.contains(&name) {
            name.push('-');
        }
        let page = worksheet::html(&file.path, &file.text, Format::of_path(&file.path));
        target::replace(&folder.join(format!("{name}.html")), page.as_bytes())?;
        index.push((format!("{name}.html"), file.path.clone(), summary(&file.report), file.report.holds()));
        taken.push(name);
    }
    if index.len() > 1 {
        target::replace(&folder.join("index.html"), worksheet::html_index(&index).as_bytes())?;
    }
    Ok(())
}
