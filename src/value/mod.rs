//! What operations take and give, whoever asks: values, arguments, answers.

mod answer;
mod arguments;

pub use answer::{Answer, Homogeneous, Layers, Value};
pub use arguments::{Arguments, Domain};
