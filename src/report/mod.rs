//! Answers as text, LaTeX, Mathematica lists and JSON.

mod cubic;
mod decimal;
mod entry;
mod finding;
mod formula;
mod implicit;
#[cfg(feature = "cli")]
pub mod json;
mod mathematica;
mod sheet;
#[cfg(feature = "cli")]
pub mod stream;
mod surd;
mod text;

pub use decimal::decimal;
pub use formula::Notation;
pub use mathematica::mathematica;
pub use sheet::latex;
pub use text::text;
