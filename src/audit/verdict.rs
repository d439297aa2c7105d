//! Verdicts on joins.

use crate::name::display_by_name;

/// What is said of a join that was asked for.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Verdict {
    /// It has the required order, exactly.
    Exact,
    /// It has the order up to the tolerance that was stated.
    Within,
    /// It does not have the order.
    Violated,
    /// There is no tangent or tangent plane that could agree.
    Degenerate,
    /// Nothing was required.
    Reported,
}

impl Verdict {
    /// All of them.
    pub const ALL: [Self; 5] = [Self::Exact, Self::Within, Self::Violated, Self::Degenerate, Self::Reported];

    /// The word for it.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Exact => "exact",
            Self::Within => "within",
            Self::Violated => "violated",
            Self::Degenerate => "degenerate",
            Self::Reported => "reported",
        }
    }
}

display_by_name!(Verdict);

/// Whether points within half a unit of the last printed digit are smooth.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Rounding {
    /// Some are.
    Yes,
    /// None are.
    No,
    /// Not decided for this kind of join.
    Unknown,
}

impl Rounding {
    /// The word for it.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Yes => "yes",
            Self::No => "no",
            Self::Unknown => "unknown",
        }
    }
}

display_by_name!(Rounding);
