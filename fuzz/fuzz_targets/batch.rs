//! `cargo fuzz run batch`: every line gets one answer, and every answer is JSON.
#![no_main]

use libfuzzer_sys::fuzz_target;

fuzz_target!(|bytes: &[u8]| {
    let lines = bytes.split(|&byte| byte == b'\n').filter(|line| !line.trim_ascii().is_empty()).count();
    let mut output = Vec::new();
    assert!(casteljau::batch::run(bytes, &mut output).is_ok());
    let answers = output.split(|&byte| byte == b'\n').filter(|line| !line.is_empty());
    assert_eq!(answers.count(), lines);
});
