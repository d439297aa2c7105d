//! What operations take and give, whoever asks: values, arguments, answers.

mod answer;
mod arguments;
mod finding;

pub use answer::{Answer, Homogeneous, Layers, Value};
pub use arguments::{Arguments, Domain};
pub use finding::{CubicFinding, Finding, ImplicitFinding};
