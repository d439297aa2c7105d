//! What can be wrong with a request, whatever door it came in by.

use std::fmt;

/// Why a shape could not be built or an operation not be carried out.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum Error {
    /// The vertices of a frame coincide or are dependent.
    DegenerateFrame(String),
    /// The polar degree asked for is below the degree of the polynomials.
    DegreeTooLow {
        /// The polar degree that was asked for.
        asked: usize,
        /// The largest degree of the coordinates.
        needed: usize,
    },
    /// The bidegree asked for is below the degree of the polynomials in a variable.
    BidegreeTooLow {
        /// The bidegree that was asked for.
        asked: (usize, usize),
        /// The largest degree of the coordinates in each variable.
        needed: (usize, usize),
    },
    /// A list has the wrong length.
    WrongCount {
        /// What the list holds, in the plural: "arguments", "coordinates".
        what: &'static str,
        /// How many there must be.
        expected: usize,
        /// How many there are.
        found: usize,
    },
    /// The parts of the input do not fit together.
    WrongShape(String),
    /// The input is understood, but this operation does not exist for it.
    Unsupported(String),
    /// The input or the result is beyond a limit.
    TooLarge {
        /// What is too large, in the singular: "degree", "depth".
        what: &'static str,
        /// The limit.
        limit: usize,
    },
}

impl Error {
    /// The stable code of the error in machine-readable answers.
    #[must_use]
    pub fn code(&self) -> &'static str {
        match self {
            Self::DegenerateFrame(_) => "degenerate-frame",
            Self::DegreeTooLow { .. } | Self::BidegreeTooLow { .. } => "degree-too-low",
            Self::WrongCount { .. } => "wrong-count",
            Self::WrongShape(_) => "wrong-shape",
            Self::Unsupported(_) => "unsupported",
            Self::TooLarge { .. } => "too-large",
        }
    }
}

impl fmt::Display for Error {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::DegenerateFrame(message) | Self::WrongShape(message) | Self::Unsupported(message) => f.write_str(message),
            Self::DegreeTooLow { asked, needed } => {
                write!(f, "polar degree {asked} is too low: a coordinate has degree {needed}; ask for {needed} or more")
            }
            Self::BidegreeTooLow { asked, needed } => write!(
                f,
                "bidegree {},{} is too low: the coordinates have degrees up to {} and {} in the two variables; ask for {},{} or more",
                asked.0, asked.1, needed.0, needed.1, needed.0, needed.1
            ),
            Self::WrongCount { what, expected, found } => write!(f, "expected {expected} {what}, found {found}"),
            Self::TooLarge { what, limit } => write!(f, "the {what} is beyond the limit of {limit}"),
        }
    }
}

impl std::error::Error for Error {}
