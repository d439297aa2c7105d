//! Answers as text, LaTeX, Mathematica lists and JSON; what checkers found, as other programs read it.

mod cubic;
mod decimal;
mod entry;
#[cfg(feature = "cli")]
mod excerpt;
mod finding;
mod formula;
#[cfg(feature = "cli")]
pub mod github;
mod implicit;
mod join;
#[cfg(feature = "cli")]
pub mod joins;
#[cfg(feature = "cli")]
pub mod json;
#[cfg(feature = "cli")]
pub mod junit;
#[cfg(feature = "cli")]
mod location;
mod mathematica;
#[cfg(feature = "cli")]
mod notice;
#[cfg(feature = "cli")]
pub mod sarif;
mod sheet;
mod spline;
#[cfg(feature = "cli")]
pub mod stream;
mod surd;
mod text;
pub(crate) mod xml;

pub use decimal::decimal;
#[cfg(feature = "cli")]
pub(crate) use excerpt::Excerpt;
pub use formula::Notation;
pub use mathematica::mathematica;
#[cfg(feature = "cli")]
pub use notice::{Level, Notice, Obstacle, Report, Rule};
pub use sheet::latex;
pub use text::text;

/// What a field is called in text.
fn title(name: &str) -> String {
    match name {
        "distinct_roots_open" => "roots inside the frame".to_owned(),
        "roots_with_multiplicity_open" => "counted with multiplicity".to_owned(),
        _ => name.replace('_', " "),
    }
}
