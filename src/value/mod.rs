//! What operations take and give, whoever asks: values, arguments, answers.

mod answer;
mod arguments;

pub use answer::{Answer, Value};
pub use arguments::Arguments;
