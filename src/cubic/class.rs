//! The classes of planar cubics, with the names they have elsewhere.

use std::cmp::Ordering;
use std::fmt;

/// What a planar cubic is, as a whole curve. The classes exclude each other,
/// and every curve of the plane of degree three at most has one.
///
/// The names are those of CS348a, lecture 6 (Leonidas Guibas and Lyle Ramshaw).
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum CubicClass {
    /// Two flexes and an isolated double point.
    Humpy,
    /// A point that the curve runs through twice.
    Loopy,
    /// A cusp.
    Pointy,
    /// One flex, about which the curve is symmetric; in some frame the graph of a cubic function.
    SShaped,
    /// A parabola.
    Parabolic,
    /// A straight line, a part of one, or a point.
    Straight,
}

/// The way through the classification tree, which ends in a class.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Branch {
    /// `κ23 ≠ 0`, `D > 0`.
    DiscriminantPositive,
    /// `κ23 ≠ 0`, `D < 0`.
    DiscriminantNegative,
    /// `κ23 ≠ 0`, `D = 0`.
    DiscriminantZero,
    /// `κ23 = 0`, `κ31 ≠ 0`.
    OnlyKappa23Zero,
    /// `κ23 = κ31 = 0`, `κ12 ≠ 0`.
    OnlyKappa12Left,
    /// `κ12 = κ23 = κ31 = 0`.
    AllZero,
}

impl Branch {
    /// The branch by the answers to its tests, asked for in this order: whether
    /// `κ23` is zero, the sign of `D`, whether `κ31` and `κ12` are zero.
    #[inline]
    pub(super) fn of(
        kappa23_is_zero: bool,
        discriminant: impl FnOnce() -> Ordering,
        kappa31_is_zero: impl FnOnce() -> bool,
        kappa12_is_zero: impl FnOnce() -> bool,
    ) -> Self {
        if !kappa23_is_zero {
            match discriminant() {
                Ordering::Greater => Self::DiscriminantPositive,
                Ordering::Less => Self::DiscriminantNegative,
                Ordering::Equal => Self::DiscriminantZero,
            }
        } else if !kappa31_is_zero() {
            Self::OnlyKappa23Zero
        } else if !kappa12_is_zero() {
            Self::OnlyKappa12Left
        } else {
            Self::AllZero
        }
    }

    /// The class at the end of the branch.
    #[must_use]
    pub fn class(self) -> CubicClass {
        match self {
            Self::DiscriminantPositive => CubicClass::Humpy,
            Self::DiscriminantNegative => CubicClass::Loopy,
            Self::DiscriminantZero => CubicClass::Pointy,
            Self::OnlyKappa23Zero => CubicClass::SShaped,
            Self::OnlyKappa12Left => CubicClass::Parabolic,
            Self::AllZero => CubicClass::Straight,
        }
    }

    /// The conditions along the branch, in the order they are tested.
    #[must_use]
    pub fn conditions(self) -> &'static str {
        match self {
            Self::DiscriminantPositive => "κ23 ≠ 0, D > 0",
            Self::DiscriminantNegative => "κ23 ≠ 0, D < 0",
            Self::DiscriminantZero => "κ23 ≠ 0, D = 0",
            Self::OnlyKappa23Zero => "κ23 = 0, κ31 ≠ 0",
            Self::OnlyKappa12Left => "κ23 = 0, κ31 = 0, κ12 ≠ 0",
            Self::AllZero => "κ23 = 0, κ31 = 0, κ12 = 0",
        }
    }
}

impl CubicClass {
    /// All classes, the general ones first.
    pub const ALL: [Self; 6] = [Self::Humpy, Self::Loopy, Self::Pointy, Self::SShaped, Self::Parabolic, Self::Straight];

    /// The name, as in answers for machines and in worksheets.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Humpy => "humpy",
            Self::Loopy => "loopy",
            Self::Pointy => "pointy",
            Self::SShaped => "s_shaped",
            Self::Parabolic => "parabolic",
            Self::Straight => "straight",
        }
    }

    /// The name in Loop and Blinn, "Resolution independent curve rendering"
    /// (2005), which Skia uses too. (It tells lines from points; for them see
    /// [`Straight`](super::Straight).)
    #[must_use]
    pub fn loop_blinn_name(self) -> &'static str {
        match self {
            Self::Humpy => "serpentine",
            Self::Loopy => "loop",
            Self::Pointy => "cusp",
            Self::SShaped => "cusp at infinity",
            Self::Parabolic => "quadratic",
            Self::Straight => "line or point",
        }
    }

    /// What classical geometry calls the double point of the curve, which every
    /// rational plane cubic has once.
    #[must_use]
    pub fn double_point_name(self) -> Option<&'static str> {
        match self {
            Self::Humpy => Some("acnode"),
            Self::Loopy => Some("crunode"),
            Self::Pointy => Some("cusp"),
            Self::SShaped => Some("cusp at infinity"),
            Self::Parabolic | Self::Straight => None,
        }
    }

    /// Whether every small change of the coefficients leaves the class as it is.
    #[must_use]
    pub fn is_stable(self) -> bool {
        match self {
            Self::Humpy | Self::Loopy => true,
            Self::Pointy | Self::SShaped | Self::Parabolic | Self::Straight => false,
        }
    }
}

impl fmt::Display for CubicClass {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(match self {
            Self::SShaped => "S-shaped",
            Self::Humpy | Self::Loopy | Self::Pointy | Self::Parabolic | Self::Straight => self.name(),
        })
    }
}
