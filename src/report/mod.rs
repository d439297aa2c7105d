//! Answers as text, LaTeX, Mathematica lists and JSON.

mod decimal;
mod formula;
#[cfg(feature = "cli")]
pub mod json;
mod mathematica;
mod sheet;
mod text;

pub use decimal::decimal;
pub use formula::Notation;
pub use mathematica::mathematica;
pub use sheet::latex;
pub use text::text;
