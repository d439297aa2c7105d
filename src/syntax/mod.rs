//! Mathematics as text: one grammar for everything people type, and the
//! printers whose output it reads back.
//!
//! Text becomes tokens (`lexer`), tokens an expression (`parser`), an
//! expression a polynomial or a tuple of them (`evaluate`). On top of these
//! stand the inputs that commands take: maps, points, frames, polar arguments.
//! Every step keeps byte spans, so that an error can say where it is.

pub(crate) mod arguments;
mod brackets;
mod cost;
pub(crate) mod definition;
mod error;
pub(crate) mod evaluate;
// What worksheets add to the grammar is used by the program alone.
#[cfg_attr(not(feature = "cli"), allow(dead_code))]
pub(crate) mod expression;
mod frame;
mod input;
mod latex;
mod letter;
mod lexer;
pub mod limits;
mod lines;
mod literal;
mod map;
#[cfg_attr(not(feature = "cli"), allow(dead_code))]
pub(crate) mod parser;
mod points;
pub mod printer;
mod scalar;
mod span;
#[cfg(feature = "cli")]
pub(crate) mod statement;
pub(crate) mod token;

pub use arguments::{ArgumentInput, PolarArguments, parse_polar_arguments};
pub use error::SyntaxError;
pub use frame::{FrameInput, parse_frame};
pub use input::{Input, parse_input};
pub use lines::Lines;
pub use map::{MapInput, Variables, parse_map};
pub use points::{Nesting, PointInput, PointsInput, parse_points};
pub use printer::Style;
pub use scalar::{parse_components, parse_number, parse_scalar, parse_scalars, parse_symbol, parse_variables};
pub use span::Span;
