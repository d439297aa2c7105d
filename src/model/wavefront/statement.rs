//! The statements of a file, a line each.

/// A line of a file with the lines that continue it.
pub(super) struct Statement<'a> {
    /// The first word.
    pub(super) keyword: &'a str,
    /// The byte of the first word.
    pub(super) at: usize,
    /// What stands behind it, comments included.
    rest: &'a str,
    rest_at: usize,
}

/// A word behind the keyword.
#[derive(Clone, Copy, Debug)]
pub(super) struct Word<'a> {
    pub(super) text: &'a str,
    pub(super) at: usize,
}

/// The statements of a text, one after the other.
pub(super) struct Statements<'a> {
    text: &'a str,
    at: usize,
}

impl<'a> Statements<'a> {
    pub(super) fn new(text: &'a str) -> Self {
        Self { text, at: 0 }
    }

    /// The next line that is neither empty nor a comment.
    pub(super) fn next(&mut self) -> Option<Statement<'a>> {
        while self.at < self.text.len() {
            let (start, line) = (self.at, self.line());
            let content = line.trim_start();
            if content.is_empty() || content.starts_with('#') {
                continue;
            }
            let at = start + line.len() - content.len();
            let mut end = start + line.len();
            while self.text[start..end].trim_end().ends_with('\\') && self.at < self.text.len() {
                self.line();
                end = self.at;
            }
            let whole = &self.text[at..end];
            let length = whole.find(is_blank).unwrap_or(whole.len());
            return Some(Statement { keyword: &whole[..length], at, rest: &whole[length..], rest_at: at + length });
        }
        None
    }

    /// The line at hand, without its end.
    fn line(&mut self) -> &'a str {
        let rest = &self.text[self.at..];
        let length = rest.find('\n').unwrap_or(rest.len());
        self.at += (length + 1).min(rest.len());
        &rest[..length]
    }
}

/// A backslash joins lines and is a blank.
fn is_blank(letter: char) -> bool {
    letter.is_ascii_whitespace() || letter == '\\'
}

impl<'a> Statement<'a> {
    /// The words behind the keyword, up to a comment.
    pub(super) fn words(&self) -> impl Iterator<Item = Word<'a>> + use<'a> {
        let (rest, rest_at) = (self.rest, self.rest_at);
        let mut at = 0;
        std::iter::from_fn(move || {
            at += rest[at..].find(|letter| !is_blank(letter))?;
            let text = &rest[at..];
            if text.starts_with('#') {
                // Nothing counts behind it.
                at = rest.len();
                return None;
            }
            let length = text.find(is_blank).unwrap_or(text.len());
            let word = Word { text: &text[..length], at: rest_at + at };
            at += length;
            Some(word)
        })
    }

    /// What stands behind the keyword.
    pub(super) fn rest(&self) -> &'a str {
        self.rest
    }

    /// The byte behind the last word.
    pub(super) fn end(&self) -> usize {
        self.rest_at + self.rest.trim_end().len()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lines_and_their_words() {
        let mut statements = Statements::new("# a \\\n\nv 1 2 \\\r\n 3\\\n4 # five\r\n  end\ng a b\\");
        let mut all = Vec::new();
        while let Some(statement) = statements.next() {
            let words: Vec<(&str, usize)> = statement.words().map(|word| (word.text, word.at)).collect();
            all.push((statement.keyword, statement.at, words));
        }
        assert_eq!(
            all,
            [("v", 7, vec![("1", 9), ("2", 11), ("3", 17), ("4", 20)]), ("end", 32, vec![]), ("g", 36, vec![("a", 38), ("b", 40)])]
        );
    }
}
