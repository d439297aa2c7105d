//! How a command ends.

use std::process::ExitCode;

/// What the exit status says; the larger one wins.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum Ending {
    /// Done, and everything holds.
    Fine,
    /// A claim or a required join does not hold, or a question is answered no.
    No,
    /// Something cannot be used or decided, or there was nothing to check.
    Unusable,
}

impl Ending {
    /// The end of a command that answers a question.
    pub(super) fn of_answer(holds: bool) -> Self {
        if holds { Self::Fine } else { Self::No }
    }
}

impl From<Ending> for ExitCode {
    fn from(ending: Ending) -> Self {
        Self::from(match ending {
            Ending::Fine => 0,
            Ending::No => 1,
            Ending::Unusable => 2,
        })
    }
}
