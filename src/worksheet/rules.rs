//! What a check of worksheets looks for.

use crate::report::{Level, Rule};

/// The rules, in the order of their codes.
pub static RULES: [Rule; 6] = [
    Rule {
        code: "W001",
        name: "refuted",
        level: Level::Error,
        summary: "A claim does not hold.",
        explanation: "The two sides of the claim are not what it says of them: they were computed exactly, and with letters left open \
                      compared as polynomials, so that one set of values at least makes the claim false.\n\n\
                      The message has both sides and their difference term by term and, where one usual mistake explains all of it, that \
                      mistake. It is named only if the claim holds once it is corrected.",
    },
    Rule {
        code: "W002",
        name: "undecided",
        level: Level::Error,
        summary: "A claim could not be read or decided.",
        explanation: "The claim has an error of grammar, uses a name that is not defined above it, compares values of different kinds, or \
                      asks for what an operation refuses. A claim that is not decided never counts as proved, and the run ends with \
                      exit status 2.",
    },
    Rule {
        code: "W003",
        name: "unreadable",
        level: Level::Error,
        summary: "A definition or a block could not be read.",
        explanation: "A definition has an error, a name is defined twice, or a fenced block is never closed. What depends on it cannot be \
                      decided either, and the run ends with exit status 2.",
    },
    Rule {
        code: "W101",
        name: "unused",
        level: Level::Warning,
        summary: "A definition is used by nothing.",
        explanation: "No claim and no other definition mentions the name. Perhaps a claim about it was forgotten, or another name was meant.",
    },
    Rule {
        code: "W102",
        name: "trivial",
        level: Level::Warning,
        summary: "A claim has the same text on both sides.",
        explanation: "It holds whatever the text stands for, and checks nothing.",
    },
    Rule {
        code: "W103",
        name: "stray-comment",
        level: Level::Warning,
        summary: "A comment asks for a formula to be read, and no formula follows.",
        explanation: "The comment <!-- casteljau --> makes the next $$ … $$ or ```math block a definition or a claim. None follows before the \
                      next heading, fence or comment of this kind.",
    },
];

/// The rule with a code.
pub(crate) fn rule(code: &str) -> &'static Rule {
    RULES.iter().find(|rule| rule.code == code).unwrap_or(&RULES[1])
}
