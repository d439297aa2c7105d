//! What operations take and give, whoever asks: values, arguments, answers.

mod answer;
mod arguments;
mod domain;
mod finding;
mod numeric;
mod shapes;

pub use answer::{Answer, Homogeneous, LabelledRow, Layers, Value};
pub use arguments::Arguments;
pub use domain::Domain;
pub use finding::{Contact, CubicFinding, Finding, ImplicitFinding, JoinFinding, RepairFinding, SplineFinding};
