//! The commands of LaTeX that mathematics in textbooks uses, and Greek letters.

use super::token::Comparison;

/// What a command stands for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Command {
    Greek(char),
    Fraction,
    Root,
    Times,
    Comparison(Comparison),
    /// A word in braces, as in `\operatorname{class}`.
    Word,
    /// Spacing and layout, skipped like a blank.
    Blank,
    /// What may separate definitions; a blank otherwise.
    Break,
    /// The size of the bracket that follows; skipped.
    Delimiter,
    /// `\begin` or `\end`, with the environment's name in braces.
    Environment,
}

/// Names of Greek letters. Where two commands give one letter, the first prints it.
const GREEK: [(&str, char); 40] = [
    ("alpha", 'α'),
    ("beta", 'β'),
    ("gamma", 'γ'),
    ("delta", 'δ'),
    ("epsilon", 'ε'),
    ("varepsilon", 'ε'),
    ("zeta", 'ζ'),
    ("eta", 'η'),
    ("theta", 'θ'),
    ("vartheta", 'θ'),
    ("iota", 'ι'),
    ("kappa", 'κ'),
    ("lambda", 'λ'),
    ("mu", 'μ'),
    ("nu", 'ν'),
    ("xi", 'ξ'),
    ("pi", 'π'),
    ("varpi", 'π'),
    ("rho", 'ρ'),
    ("varrho", 'ρ'),
    ("varsigma", 'ς'),
    ("sigma", 'σ'),
    ("tau", 'τ'),
    ("upsilon", 'υ'),
    ("phi", 'φ'),
    ("varphi", 'φ'),
    ("chi", 'χ'),
    ("psi", 'ψ'),
    ("omega", 'ω'),
    ("Gamma", 'Γ'),
    ("Delta", 'Δ'),
    ("Theta", 'Θ'),
    ("Lambda", 'Λ'),
    ("Xi", 'Ξ'),
    ("Pi", 'Π'),
    ("Sigma", 'Σ'),
    ("Upsilon", 'Υ'),
    ("Phi", 'Φ'),
    ("Psi", 'Ψ'),
    ("Omega", 'Ω'),
];

/// The environments that only lay out formulas.
const ENVIRONMENTS: [&str; 9] = ["split", "aligned", "align", "alignedat", "gathered", "gather", "equation", "multline", "cases"];

/// The command of this name, given without the backslash.
pub(crate) fn command(name: &str) -> Option<Command> {
    Some(match name {
        "frac" | "tfrac" | "dfrac" => Command::Fraction,
        "sqrt" => Command::Root,
        "cdot" | "times" | "ast" => Command::Times,
        "ne" | "neq" => Command::Comparison(Comparison::NotEqual),
        "lt" => Command::Comparison(Comparison::Less),
        "le" | "leq" => Command::Comparison(Comparison::LessOrEqual),
        "gt" => Command::Comparison(Comparison::Greater),
        "ge" | "geq" => Command::Comparison(Comparison::GreaterOrEqual),
        "operatorname" | "text" | "mathrm" | "textrm" => Command::Word,
        "," | ";" | ":" | "!" | ">" | " " | "quad" | "displaystyle" | "textstyle" | "nonumber" | "notag" | "allowbreak" | "enspace"
        | "thinspace" => Command::Blank,
        "\\" | "qquad" | "[" | "]" | "(" | ")" | "newline" => Command::Break,
        "left" | "right" | "big" | "Big" | "bigg" | "Bigg" | "bigl" | "bigr" | "Bigl" | "Bigr" | "biggl" | "biggr" | "Biggl" | "Biggr" => {
            Command::Delimiter
        }
        "begin" | "end" => Command::Environment,
        _ => Command::Greek(GREEK.iter().find(|entry| entry.0 == name)?.1),
    })
}

/// Whether an environment only lays out formulas, so that it can be skipped.
pub(crate) fn is_layout(environment: &str) -> bool {
    let name = environment.strip_suffix('*').unwrap_or(environment);
    ENVIRONMENTS.contains(&name)
}

/// The command that prints a Greek letter, without the backslash.
pub(crate) fn greek_name(letter: char) -> Option<&'static str> {
    GREEK.iter().find(|entry| entry.1 == letter).map(|entry| entry.0)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::symbolic::Symbol;

    #[test]
    fn greek_letters_are_letters_and_print() {
        for (name, letter) in GREEK {
            assert!(Symbol::is_letter(letter), "{name}");
            assert_eq!(command(name), Some(Command::Greek(letter)));
            let printed = greek_name(letter).and_then(command);
            assert_eq!(printed, Some(Command::Greek(letter)));
        }
        assert_eq!(greek_name('t'), None);
    }

    #[test]
    fn environments() {
        assert!(is_layout("aligned") && is_layout("align*"));
        assert!(!is_layout("pmatrix"));
    }
}
