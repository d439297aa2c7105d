//! What the command line says of a flag.

use clap::ArgMatches;

/// Whether a flag or an argument is there.
pub(super) fn is_given(matches: &ArgMatches, flag: &str) -> bool {
    matches!(matches.try_contains_id(flag), Ok(true)) && matches.value_source(flag) == Some(clap::parser::ValueSource::CommandLine)
}

/// The text of a flag.
pub(super) fn text_of<'m>(matches: &'m ArgMatches, flag: &str) -> Option<&'m String> {
    matches.try_get_one::<String>(flag).ok().flatten()
}
