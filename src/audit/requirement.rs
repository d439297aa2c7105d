//! What joins are held to.

use std::str::FromStr;

use crate::name::display_by_name;

/// An order of continuity that a join must have.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Requirement {
    /// Equal points.
    C0,
    /// Equal first derivatives.
    C1,
    /// Equal second derivatives too.
    C2,
    /// A common tangent direction or tangent plane.
    G1,
    /// A common curvature vector too; of curves only.
    G2,
}

impl Requirement {
    /// All of them.
    pub const ALL: [Self; 5] = [Self::C0, Self::C1, Self::C2, Self::G1, Self::G2];

    /// The name: "C0", ….
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::C0 => "C0",
            Self::C1 => "C1",
            Self::C2 => "C2",
            Self::G1 => "G1",
            Self::G2 => "G2",
        }
    }

    /// The order.
    #[must_use]
    pub const fn order(self) -> usize {
        match self {
            Self::C0 => 0,
            Self::C1 | Self::G1 => 1,
            Self::C2 | Self::G2 => 2,
        }
    }

    /// Whether it is about the shapes alone, not their parameters.
    #[must_use]
    pub const fn is_geometric(self) -> bool {
        matches!(self, Self::G1 | Self::G2)
    }
}

display_by_name!(Requirement);

impl FromStr for Requirement {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        Self::ALL
            .into_iter()
            .find(|requirement| requirement.name() == text)
            .ok_or_else(|| format!("found `{text}`, expected C0, C1, C2, G1 or G2"))
    }
}
