//! Words that were meant where letters stand in a row.

use super::function::{is_function, known_word};
use crate::syntax::{Span, SyntaxError};

/// How many changes of one letter a word may be away, by its length.
fn reach(length: usize) -> usize {
    match length {
        0..=3 => 0,
        4..=6 => 1,
        _ => 2,
    }
}

/// The runs of letters of a text that are no words, with what stands behind each.
fn runs(text: &str) -> impl Iterator<Item = (Span, &str, Option<char>)> {
    let mut at = 0;
    std::iter::from_fn(move || {
        loop {
            let rest = text.get(at..)?;
            let start = at + rest.find(|c: char| c.is_ascii_alphabetic())?;
            let run = &text[start..];
            let length = run.find(|c: char| !(c.is_ascii_alphanumeric() || c == '_')).unwrap_or(run.len());
            at = start + length;
            let word = &text[start..at];
            // Commands of LaTeX are words of their own.
            if !text[..start].ends_with('\\') && known_word(word).is_none() {
                return Some((Span::new(start, at), word, text[at..].chars().next()));
            }
        }
    })
}

/// The word that is nearest to a run of letters, if one is near.
fn nearest(run: &str, functions_only: bool) -> Option<&'static str> {
    let most = reach(run.chars().count());
    if most == 0 {
        return None;
    }
    let words = super::function::all_words().filter(|word| !functions_only || is_function(word));
    let distance = |word: &&str| strsim::damerau_levenshtein(run, word);
    let word = words.filter(|word| word.len() > 3).min_by_key(|word| (distance(word), *word))?;
    (distance(&word) <= most).then_some(word)
}

/// An error if something is called that is no function but nearly one.
pub(super) fn misspelt_call(text: &str) -> Result<(), SyntaxError> {
    for (span, run, next) in runs(text) {
        if next == Some('(')
            && let Some(meant) = nearest(run, true)
        {
            let error = SyntaxError::new(span, format!("found `{run}`, which is no function"));
            return Err(error.with_help(format!("did you mean `{meant}`?")));
        }
    }
    Ok(())
}

/// The same error with a suggestion, if a word in the text is nearly another.
pub(super) fn suggested(error: SyntaxError, text: &str) -> SyntaxError {
    if error.help.is_some() {
        return error;
    }
    let found = runs(text).find_map(|(_, run, _)| nearest(run, false).map(|meant| (run, meant)));
    match found {
        Some((run, meant)) => error.with_help(format!("did you mean `{meant}` by `{run}`?")),
        None => error,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn near_words() {
        for (run, meant) in
            [("pionts", Some("points")), ("casteljeau", Some("casteljau")), ("abc", None), ("loppy", Some("loopy")), ("xyzw", None)]
        {
            assert_eq!(nearest(run, false), meant, "{run}");
        }
        assert!(misspelt_call("points(F, 0..1) == [1]").is_ok());
        assert!(misspelt_call("2 abcd(t + 1)").is_ok());
        let error = misspelt_call("1 + pionts(F, 0..1)").expect_err("a misspelt name");
        assert_eq!((error.span, error.help.as_deref()), (Span::new(4, 10), Some("did you mean `points`?")));
    }
}
