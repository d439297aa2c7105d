//! Every operation once: what it takes, what it gives, and how it is carried out.
//!
//! The command line and `batch` are adaptors of [`OPERATIONS`]: they bring
//! their own spelling of the arguments into [`Arguments`], run the row, and
//! render the [`Answer`].

mod arguments;
mod curve;
mod geometry;
mod numbers;
mod picture;
mod table;
mod value;

pub use arguments::Arguments;
pub use table::{Kind, OPERATIONS, Operation, Parameter, Run};
pub use value::{Answer, Value};
