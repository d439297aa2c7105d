//! Text in XML.

use std::borrow::Cow;

/// Text as it stands in an XML element or between the double quotes of an
/// attribute: a parser gives it back as it was.
///
/// The characters that XML 1.0 forbids (section 2.2, production 2) are shown
/// by others: control characters by their pictures (`␛` for escape), the two
/// that Unicode calls no characters by `�`.
pub(crate) fn escape(text: &str) -> Cow<'_, str> {
    if !text.contains(|letter| replacement(letter).is_some()) {
        return Cow::Borrowed(text);
    }
    let mut escaped = String::with_capacity(text.len() + 16);
    for letter in text.chars() {
        match replacement(letter) {
            None => escaped.push(letter),
            Some(Replacement::Reference(reference)) => escaped.push_str(reference),
            Some(Replacement::Picture(picture)) => escaped.push(picture),
        }
    }
    Cow::Owned(escaped)
}

enum Replacement {
    Reference(&'static str),
    Picture(char),
}

fn replacement(letter: char) -> Option<Replacement> {
    Some(match letter {
        '&' => Replacement::Reference("&amp;"),
        '<' => Replacement::Reference("&lt;"),
        '>' => Replacement::Reference("&gt;"),
        '"' => Replacement::Reference("&quot;"),
        // Parsers make a blank of these in attributes, and a line feed of the last everywhere.
        '\t' => Replacement::Reference("&#9;"),
        '\n' => Replacement::Reference("&#10;"),
        '\r' => Replacement::Reference("&#13;"),
        '\0'..='\u{1f}' => Replacement::Picture(picture(letter)),
        '\u{fffe}' | '\u{ffff}' => Replacement::Picture(char::REPLACEMENT_CHARACTER),
        _ => return None,
    })
}

/// The picture of a control character: Unicode has them from U+2400 on, in the same order.
fn picture(control: char) -> char {
    char::from_u32(0x2400 + u32::from(control)).unwrap_or(char::REPLACEMENT_CHARACTER)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn text_is_escaped_where_it_must_be() {
        for (text, escaped) in [
            ("plain κ 𝔽", "plain κ 𝔽"),
            ("a < b & \"c\" ]]>", "a &lt; b &amp; &quot;c&quot; ]]&gt;"),
            ("\t\r\n", "&#9;&#13;&#10;"),
            ("\u{0}\u{8}\u{1b}\u{1f}", "␀␈␛␟"),
            ("\u{fffd}\u{fffe}\u{ffff}", "���"),
        ] {
            assert_eq!(escape(text), escaped);
        }
        assert!(matches!(escape("plain"), Cow::Borrowed(_)));
    }
}
