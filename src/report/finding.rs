//! Findings as people read them.

use super::entry::Entry;
use super::formula::Notation;
use super::{cubic, implicit, join, spline};
use crate::value::Finding;

fn entries(finding: &Finding, notation: &Notation) -> Vec<Entry> {
    match finding {
        Finding::Cubic(found) => cubic::entries(found, notation),
        Finding::Family(family) => cubic::family(family, notation),
        Finding::Implicit(found) => implicit::curve(found, notation),
        Finding::Quadric(found) => implicit::quadric(found, notation),
        Finding::Join(found) => join::join(found, notation),
        Finding::Extension(found) => spline::extension(found, notation),
        Finding::Spline(found) => spline::spline(found, notation),
    }
}

/// The lines of a finding, each ending in a line end.
pub(super) fn text(finding: &Finding, notation: &Notation) -> String {
    entries(finding, notation).iter().map(|entry| format!("{}\n", entry.text())).collect()
}

/// The lines of a finding for an `aligned` block.
pub(super) fn formulas(finding: &Finding, notation: &Notation) -> Vec<String> {
    entries(finding, notation).iter().map(Entry::formula).collect()
}
