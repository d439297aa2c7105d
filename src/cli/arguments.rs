//! Telling values from flags.

use clap::Command;

/// The arguments with every value in a place where it cannot be taken for a
/// flag: only known flags are flags, and `-1..3`, `-t^2` or `-1/2` may stand
/// wherever a value may. What begins with `--` and is not known is left for
/// the parser to refuse.
pub(super) fn separated(arguments: Vec<String>, program: &Command) -> Vec<String> {
    let mut arguments = arguments.into_iter();
    let mut flags: Vec<String> = arguments.by_ref().take(1).collect();
    let mut command = None;
    let mut values = Vec::new();
    let mut before = Vec::new();
    while let Some(argument) = arguments.next() {
        let Some(found): Option<&Command> = command else {
            // What every command takes may also stand before it.
            if matches!(argument.as_str(), "-q" | "--quiet" | "-v" | "--verbose") || argument.starts_with("--color=") {
                before.push(argument);
                continue;
            }
            if argument == "--color" {
                before.extend(arguments.next().map(|choice| format!("--color={choice}")));
                continue;
            }
            command = program.find_subcommand(&argument);
            flags.push(argument);
            flags.append(&mut before);
            if command.is_none() {
                // Not a command: the parser explains it, or prints help.
                flags.extend(arguments);
                return flags;
            }
            continue;
        };
        if argument == "--" {
            values.extend(arguments);
            break;
        }
        if argument.starts_with("--") {
            let takes_value = takes_value(found, |flag| flag.get_long().is_some_and(|long| argument[2..] == *long));
            match takes_value.then(|| arguments.next()).flatten() {
                // A flag in the place of a value means that the value was forgotten.
                Some(value) if !value.starts_with("--") => flags.push(format!("{argument}={value}")),
                Some(next) => flags.extend([argument, next]),
                None => flags.push(argument),
            }
            continue;
        }
        let letters = argument.strip_prefix('-').unwrap_or_default();
        let short = letters.chars().next().filter(|letter| letters.len() == letter.len_utf8());
        let is_known = |letter: char| matches!(letter, 'h' | 'V') || found.get_arguments().any(|flag| flag.get_short() == Some(letter));
        if letters.len() > 1 && letters.chars().all(|letter| matches!(letter, 'q' | 'v')) {
            flags.push(argument);
            continue;
        }
        match short {
            Some(letter) if is_known(letter) => {
                let takes_value = takes_value(found, |flag| flag.get_short() == Some(letter));
                flags.push(argument);
                if takes_value {
                    flags.extend(arguments.next());
                }
            }
            _ => values.push(argument),
        }
    }
    if !values.is_empty() {
        flags.push("--".to_owned());
        flags.append(&mut values);
    }
    flags
}

fn takes_value(command: &Command, is_it: impl Fn(&clap::Arg) -> bool) -> bool {
    command.get_arguments().any(|flag| !flag.is_positional() && is_it(flag) && flag.get_action().takes_values())
}

#[cfg(test)]
mod tests {
    use super::super::command::program;
    use super::*;

    fn separate(line: &str) -> String {
        separated(line.split(' ').map(str::to_owned).collect(), &program()).join(" ")
    }

    #[test]
    fn values_that_look_like_flags() {
        for (line, expected) in [
            ("casteljau points -t^2 --over -1..3", "casteljau points --over=-1..3 -- -t^2"),
            ("casteljau eval t --at -1/2 -q", "casteljau eval --at=-1/2 -q -- t"),
            ("casteljau eval - --at=1", "casteljau eval --at=1 -- -"),
            ("casteljau eval t --nonsense", "casteljau eval --nonsense -- t"),
            ("casteljau eval t --at --steps", "casteljau eval --at --steps -- t"),
            ("casteljau plot t -o -x.svg", "casteljau plot -o -x.svg -- t"),
            ("casteljau -q --color never eval t", "casteljau eval -q --color=never -- t"),
            ("casteljau eval -vv -v^2", "casteljau eval -vv -- -v^2"),
            ("casteljau eval -- --at", "casteljau eval -- --at"),
            ("casteljau --version", "casteljau --version"),
            ("casteljau nonsense -x", "casteljau nonsense -x"),
        ] {
            assert_eq!(separate(line), expected);
        }
    }
}
