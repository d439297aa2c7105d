//! Where the text of an input comes from.

use std::fs::File;
use std::io::{self, Read};

use clap::ArgMatches;

use super::diagnostic::Problem;
use crate::syntax::limits::MAX_INPUT_BYTES;

/// The most bytes of a shape file.
const MAX_SHAPE_BYTES: usize = 16 << 20;

/// A text and what to call it in messages.
pub(super) struct Source {
    pub(super) name: String,
    pub(super) text: String,
}

impl Source {
    /// The input of a command: the argument with this name, `--input FILE` for
    /// the first one, `-` for standard input, a path that ends in `.json`.
    pub(super) fn of(matches: &ArgMatches, argument: &str) -> Result<Self, Problem> {
        let given = matches.get_one::<String>(argument);
        let file = if argument == "input" { matches.get_one::<String>("file") } else { None };
        match (given, file) {
            (Some(_), Some(_)) => Err(Problem::plain("the input is given twice: as an argument and by --input")),
            (None, None) => Err(Problem::plain(format!("the {argument} is missing"))
                .with_help("give it as an argument, by --input FILE, or as `-` for standard input")),
            (Some(text), None) if text == "-" => Self::read("standard input", &mut io::stdin().lock()),
            (Some(text), None) if text.ends_with(".json") => Self::open(text),
            (Some(text), None) => Ok(Self { name: format!("<{argument}>"), text: text.clone() }),
            (None, Some(path)) => Self::open(path),
        }
    }

    fn open(path: &str) -> Result<Self, Problem> {
        let mut file = File::open(path).map_err(|error| Problem::plain(format!("cannot read `{path}`: {error}")))?;
        Self::read(path, &mut file)
    }

    fn read(name: &str, reader: &mut dyn Read) -> Result<Self, Problem> {
        let mut bytes = Vec::new();
        let read = reader.take(MAX_SHAPE_BYTES as u64 + 1).read_to_end(&mut bytes);
        read.map_err(|error| Problem::plain(format!("cannot read {name}: {error}")))?;
        if bytes.len() > MAX_SHAPE_BYTES {
            return Err(Problem::plain(format!("{name} is too large: at most {MAX_SHAPE_BYTES} bytes are read")));
        }
        match String::from_utf8(bytes) {
            Ok(text) => Ok(Self { name: name.to_owned(), text }),
            Err(error) => {
                let at = error.utf8_error().valid_up_to();
                Err(Problem::plain(format!("{name} is not valid UTF-8: byte {at} does not belong to any character")))
            }
        }
    }

    /// Whether the text is a shape file and not mathematics.
    pub(super) fn is_shape(&self) -> bool {
        self.text.trim_start().strip_prefix('{').is_some_and(|rest| rest.trim_start().starts_with('"'))
    }

    /// The text for the expression parser, refused before any work if it is too long.
    pub(super) fn expression(&self) -> Result<&str, Problem> {
        if self.text.len() > MAX_INPUT_BYTES {
            return Err(Problem::plain(format!("{} is too long: an expression may have at most {MAX_INPUT_BYTES} bytes", self.name)));
        }
        Ok(&self.text)
    }
}
