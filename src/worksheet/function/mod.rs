//! The functions of worksheets: one table, each an adaptor of an operation.

mod cubic;
mod equation;
mod join;
mod net;
mod operand;
mod polar;
mod scheme;

pub(super) use net::net_of;
pub(super) use operand::{Operand, Operands};
pub(super) use polar::with_letters;

use super::evaluate::{Evaluator, at};
use super::quantity::Quantity;
use crate::error::Error;
use crate::syntax::SyntaxError;

/// Why a function has no value: at the call, or at one of its arguments.
pub(super) enum Fault {
    /// What the operation says.
    Of(Error),
    /// At a place.
    At(SyntaxError),
}

impl From<Error> for Fault {
    fn from(error: Error) -> Self {
        Self::Of(error)
    }
}

impl From<SyntaxError> for Fault {
    fn from(error: SyntaxError) -> Self {
        Self::At(error)
    }
}

type Outcome = Result<Quantity, Fault>;

/// A function: its name, how it is called, and how it is carried out.
pub(super) struct Function {
    pub(super) name: &'static str,
    /// The ways to call it, without what may be left out first.
    pub(super) signatures: &'static [&'static str],
    run: fn(&Evaluator<'_>, &Operands<'_>) -> Outcome,
}

/// All functions, file by file.
fn functions() -> impl Iterator<Item = &'static Function> {
    [net::FUNCTIONS, polar::FUNCTIONS, scheme::FUNCTIONS, cubic::FUNCTIONS, equation::FUNCTIONS, join::FUNCTIONS].into_iter().flatten()
}

/// Words that are no functions: classes, orders, answers, and what stands behind definitions.
const WORDS: &[&str] = &[
    "humpy",
    "loopy",
    "pointy",
    "s_shaped",
    "parabolic",
    "straight",
    "same",
    "true",
    "false",
    "bidegree",
    "weight",
    "all",
    // Quadrics.
    "ellipsoid",
    "imaginary_ellipsoid",
    "hyperboloid_one_sheet",
    "hyperboloid_two_sheets",
    "cone",
    "imaginary_cone",
    "elliptic_paraboloid",
    "hyperbolic_paraboloid",
    "elliptic_cylinder",
    "imaginary_elliptic_cylinder",
    "hyperbolic_cylinder",
    "parabolic_cylinder",
    "plane_pair",
    "plane",
    "line",
    "point",
    "not_a_quadric",
    // Conics.
    "ellipse",
    "imaginary_ellipse",
    "hyperbola",
    "crossing_lines",
    "parabola",
    "parallel_lines",
    "imaginary_lines",
    "double_line",
    // Symmetries of rectangles.
    "reverse_u",
    "reverse_v",
    "half_turn",
    "transpose",
    "quarter_turn",
    "quarter_turn_back",
    "anti_transpose",
];

/// The word of worksheets that a text is, if it is one.
pub(super) fn known_word(text: &str) -> Option<&'static str> {
    use std::collections::HashSet;
    use std::sync::LazyLock;
    static ALL: LazyLock<HashSet<&'static str>> = LazyLock::new(|| all_words().collect());
    // Every word is longer than a letter with its index mostly is.
    if text.len() < 3 { None } else { ALL.get(text).copied() }
}

/// Whether a word is the name of a function.
pub(super) fn is_function(word: &str) -> bool {
    functions().any(|function| function.name == word)
}

/// The words that a function takes as arguments, whatever they stand for elsewhere.
pub(super) fn own_words(name: &str) -> &'static [&'static str] {
    match name {
        "segment" => &["rs", "st", "tr", "u0", "u1", "v0", "v1"],
        "twostep" => &["u", "v"],
        _ => &[],
    }
}

/// How a function is called.
pub(super) fn signature(name: &str) -> &'static str {
    functions().find(|function| function.name == name).and_then(|function| function.signatures.first()).copied().unwrap_or("")
}

/// All words.
pub(super) fn all_words() -> impl Iterator<Item = &'static str> {
    functions().map(|function| function.name).chain(WORDS.iter().copied())
}

/// The value of a function.
pub(super) fn call(evaluator: &Evaluator<'_>, name: &str, operands: &Operands<'_>) -> Result<Quantity, SyntaxError> {
    let Some(function) = functions().find(|function| function.name == name) else {
        return Err(SyntaxError::new(operands.name_span, format!("found `{name}` called, which is no function")));
    };
    (function.run)(evaluator, operands).map_err(|fault| match fault {
        Fault::Of(error) => at(operands.span)(error),
        Fault::At(error) if error.help.is_none() => {
            let ways: Vec<String> = function.signatures.iter().map(|way| format!("`{way}`")).collect();
            error.with_help(format!("the ways to call it: {}", ways.join(", ")))
        }
        Fault::At(error) => error,
    })
}
