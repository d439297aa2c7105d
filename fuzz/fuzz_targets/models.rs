//! `cargo fuzz run models`: every file gets a model or a flaw with its place, whatever it is read as.
#![no_main]

use casteljau::model::{Format, read};
use libfuzzer_sys::fuzz_target;

fuzz_target!(|text: &str| {
    let _ = Format::of_content(text);
    for format in Format::ALL {
        if let Err(flaw) = read(text, format) {
            assert!(flaw.place.is_some(), "{flaw}");
        }
    }
});
