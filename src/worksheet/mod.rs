//! Worksheets: hand calculations that check themselves.
//!
//! A worksheet is Markdown with fenced `casteljau` blocks, or a file of
//! statements alone. Its definitions and claims are read by the grammar of
//! [`syntax`](crate::syntax), evaluated by the table of operations
//! ([`ops`](crate::ops)), and compared exactly; a claim with symbolic
//! parameters is proved for all their values.

mod check;
mod claim;
mod compare;
mod decision;
mod definition;
mod diagnosis;
mod document;
mod evaluate;
mod exercise;
mod function;
mod html;
mod quantity;
mod report;
mod request;
mod rules;
mod scope;
mod size;
mod slip;
mod suggest;
mod typeset;
mod work;

pub use check::check;
pub use claim::{Claim, Term, Verdict};
pub use document::{Format, MAX_WORKSHEET_BYTES};
pub use exercise::{Exercise, Exercises, MAX_EXERCISES, exercises};
pub use html::html;
pub(crate) use html::index as html_index;
pub use report::{Report, Warning};
pub use rules::RULES;
pub(crate) use rules::rule;
pub use size::{MAX_HELD, MAX_LIST_SIZE, MAX_WORKSHEET_WORK};
pub use work::{MAX_WORK_DEGREE, Task, work};
