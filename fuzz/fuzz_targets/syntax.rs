//! `cargo fuzz run syntax`: no text makes the parsers panic, and what is
//! printed is read back as the same polynomial.
#![no_main]

use casteljau::Symbol;
use casteljau::syntax::{self, Style, printer};
use libfuzzer_sys::fuzz_target;

fuzz_target!(|text: &str| {
    let _ = syntax::parse_points(text);
    let _ = syntax::parse_frame(text);
    let _ = syntax::parse_polar_arguments(text);
    let _ = syntax::parse_components(text);
    if let Ok(polynomial) = syntax::parse_scalar(text) {
        for style in [Style::Text, Style::Latex] {
            let printed = printer::polynomial(&polynomial, &[Symbol::new('t', None)], style);
            // Printing may be longer than what was typed, and then beyond a limit.
            if let Ok(read) = syntax::parse_scalar(&printed) {
                assert_eq!(read, polynomial, "{printed}");
            }
        }
    }
});
