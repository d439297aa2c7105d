//! Every operation once: what it takes, what it gives, and how it is carried out.
//!
//! The command line and `batch` are adaptors of [`operations`]: they bring
//! their own spelling of the arguments into [`Arguments`](crate::value::Arguments),
//! run the row, and render the [`Answer`](crate::value::Answer).

mod cubic;
mod curve;
mod extension;
mod geometry;
mod implicit;
mod join;
mod joint;
pub(crate) mod limits;
mod numbers;
mod pair;
mod picture;
mod piece;
mod rational;
mod rectangle;
mod table;
mod triangle;

pub use table::{Growth, Kind, Operation, Parameter, Run, Weighting, about, operations};
