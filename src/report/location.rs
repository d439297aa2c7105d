//! Where files are, as other programs want to read it.

/// Whether `\` separates folders here and paths may have a drive.
const WINDOWS: bool = cfg!(windows);

/// A path as a repository names its files: forward slashes, no leading `./`.
pub(super) fn path(path: &str) -> String {
    neutral(path, WINDOWS)
}

/// A path as a reference after RFC 3986: relative if the path is, a `file` URI
/// if it is absolute.
pub(super) fn uri(path: &str) -> String {
    reference(path, WINDOWS)
}

fn neutral(path: &str, windows: bool) -> String {
    let slashed = if windows { path.replace('\\', "/") } else { path.to_owned() };
    let mut rest = slashed.as_str();
    while let Some(shorter) = rest.strip_prefix("./").filter(|shorter| !shorter.is_empty()) {
        rest = shorter.trim_start_matches('/');
    }
    rest.to_owned()
}

fn reference(path: &str, windows: bool) -> String {
    let path = neutral(path, windows);
    if windows {
        if let Some(share) = path.strip_prefix("//?/UNC/") {
            return format!("file://{}", encoded(share));
        }
        let plain = path.strip_prefix("//?/").unwrap_or(&path);
        if let Some(share) = plain.strip_prefix("//") {
            return format!("file://{}", encoded(share));
        }
        let bytes = plain.as_bytes();
        if bytes.first().is_some_and(u8::is_ascii_alphabetic) && bytes.get(1..3) == Some(b":/") {
            return format!("file:///{}:{}", &plain[..1], encoded(&plain[2..]));
        }
        return if plain.starts_with('/') { format!("file://{}", encoded(plain)) } else { encoded(plain) };
    }
    if path.starts_with('/') { format!("file://{}", encoded(&path)) } else { encoded(&path) }
}

/// Every byte that is not unreserved, a subdelimiter, `@` or a slash as `%XX`.
/// A colon is one of them: before the first slash it would end a scheme.
fn encoded(path: &str) -> String {
    const DIGITS: &[u8; 16] = b"0123456789ABCDEF";
    let mut text = String::with_capacity(path.len());
    for byte in path.bytes() {
        if byte.is_ascii_alphanumeric() || b"-._~!$&'()*+,;=@/".contains(&byte) {
            text.push(char::from(byte));
        } else {
            text.push('%');
            text.push(char::from(DIGITS[usize::from(byte >> 4)]));
            text.push(char::from(DIGITS[usize::from(byte & 15)]));
        }
    }
    text
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    #[test]
    fn references_are_relative_where_paths_are() {
        for (path, unix, windows) in [
            ("fonts/a.glif", "fonts/a.glif", "fonts/a.glif"),
            ("./a b/π%.svg", "a%20b/%CF%80%25.svg", "a%20b/%CF%80%25.svg"),
            (".//./x", "x", "x"),
            ("./", "./", "./"),
            ("../x#1?y", "../x%231%3Fy", "../x%231%3Fy"),
            ("/tmp/x:y", "file:///tmp/x%3Ay", "file:///tmp/x%3Ay"),
            ("c:x", "c%3Ax", "c%3Ax"),
            ("..\\a\\[b].md", "..%5Ca%5C%5Bb%5D.md", "../a/%5Bb%5D.md"),
            ("C:\\my font\\a.glif", "C%3A%5Cmy%20font%5Ca.glif", "file:///C:/my%20font/a.glif"),
            ("\\\\server\\share\\x", "%5C%5Cserver%5Cshare%5Cx", "file://server/share/x"),
            ("\\\\?\\C:\\x", "%5C%5C%3F%5CC%3A%5Cx", "file:///C:/x"),
            ("\\\\?\\UNC\\server\\x", "%5C%5C%3F%5CUNC%5Cserver%5Cx", "file://server/x"),
            ("\\x", "%5Cx", "file:///x"),
            ("", "", ""),
        ] {
            assert_eq!(reference(path, false), unix, "{path}");
            assert_eq!(reference(path, true), windows, "{path}");
        }
        assert_eq!(neutral(".\\a\\b c.svg", true), "a/b c.svg");
        assert_eq!(neutral("./a\\b", false), "a\\b");
    }

    /// What a reader of the reference makes of it.
    fn decoded(uri: &str) -> Vec<u8> {
        let mut bytes = uri.bytes();
        let mut path = Vec::new();
        while let Some(byte) = bytes.next() {
            path.push(match byte {
                b'%' => {
                    let pair: String = bytes.by_ref().take(2).map(char::from).collect();
                    u8::from_str_radix(&pair, 16).expect("two hexadecimal digits")
                }
                other => other,
            });
        }
        path
    }

    proptest! {
        #[test]
        fn references_lead_back(path in "\\PC*|[a-z/.:%\\x00-\\x20]*") {
            let uri = reference(&path, false);
            let named = neutral(&path, false);
            let named = if named.starts_with('/') { format!("file://{named}") } else { named };
            prop_assert_eq!(decoded(&uri), named.as_bytes());
            prop_assert!(uri.bytes().all(|byte| byte.is_ascii_graphic() && !b"\"<>\\^`{|}#?[]".contains(&byte)), "{}", uri);
        }
    }
}
