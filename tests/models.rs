//! Real files of the formats, and small ones of our own.

use std::path::{Path, PathBuf};

use casteljau::model::{Format, Model, read};

/// The folder of real data, which is not part of the project: `CASTELJAU_DATA`.
fn data() -> Option<PathBuf> {
    let folder = std::env::var_os("CASTELJAU_DATA").map(PathBuf::from);
    if folder.is_none() {
        eprintln!("skipped: CASTELJAU_DATA does not name the folder of real data");
    }
    folder
}

fn files(folder: &Path, found: &mut Vec<PathBuf>) {
    for entry in std::fs::read_dir(folder).expect("a folder") {
        let path = entry.expect("an entry").path();
        if path.is_dir() { files(&path, found) } else { found.push(path) }
    }
}

/// All files below a folder that the format's ending names, read.
fn models(folder: &Path, format: Format) -> Vec<(PathBuf, Model)> {
    let mut found = Vec::new();
    files(folder, &mut found);
    found.sort();
    found.retain(|path| Format::of_path(path) == Some(format));
    let read_file = |path: PathBuf| {
        let text = std::fs::read_to_string(&path).expect("text");
        let model = read(&text, format).unwrap_or_else(|flaw| panic!("{}:{:?}: {flaw}", path.display(), flaw.place));
        (path, model)
    };
    found.into_iter().map(read_file).collect()
}

#[test]
fn the_tea_set() {
    let Some(data) = data() else { return };
    let models = models(&data.join("newell"), Format::Newell);
    let counts: Vec<(String, usize, u32)> = models
        .iter()
        .map(|(path, model)| (path.file_name().expect("a name").to_string_lossy().into_owned(), model.parts.len(), model.decimals))
        .collect();
    assert_eq!(counts, [("teacup.patches.txt".to_owned(), 26, 7), ("teapot.patches.txt".to_owned(), 32, 5)]);
}

#[test]
fn the_glyphs_of_source_sans() {
    let Some(data) = data() else { return };
    let models = models(&data.join("glif"), Format::Glif);
    assert_eq!(models.len(), 150);
    let smooth = models.iter().flat_map(|(_, model)| &model.joints).filter(|joint| joint.smooth).count();
    assert_eq!(smooth, 1061);
    assert!(models.iter().all(|(_, model)| !model.meets_by_position && model.decimals == 0 && model.omissions.is_empty()));
}

#[test]
fn the_icons() {
    let Some(data) = data() else { return };
    let models = models(&data.join("svg"), Format::Svg);
    assert_eq!(models.len(), 319);
    let count = |count: &dyn Fn(&Model) -> usize| models.iter().map(|(_, model)| count(model)).sum::<usize>();
    println!("{} parts, {} joints, {} omissions", count(&|m| m.parts.len()), count(&|m| m.joints.len()), count(&|m| m.omissions.len()));
    for (path, model) in &models {
        let text = std::fs::read_to_string(path).expect("text");
        let lines: Vec<&str> = text.lines().collect();
        for joint in &model.joints {
            let line = lines[joint.place.line as usize - 1];
            let rest = &line[joint.place.column as usize - 1..];
            assert!(
                rest.starts_with(|letter: char| letter.is_ascii_digit() || "-.+".contains(letter)),
                "{}:{}",
                path.display(),
                joint.place
            );
        }
    }
}
