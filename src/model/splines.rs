//! The Bézier pieces of the splines of one file, with a limit for all of them.

use crate::affine::Interval;
use crate::error::Error;
use crate::exact::Rational;
use crate::segment::Segment;
use crate::spline::{Spline, piece_steps};

/// The work that the splines of a file take together.
#[derive(Debug, Default)]
pub(super) struct SplineWork {
    steps: u64,
}

impl SplineWork {
    /// The most steps for all splines of a file.
    const MAX_STEPS: u64 = 1 << 36;

    /// The Bézier pieces of the spline with these knots and de Boor points.
    ///
    /// # Errors
    /// As for [`Spline::new`]; [`Error::TooLarge`] where the splines of the file
    /// together take too much work.
    pub(super) fn pieces(&mut self, degree: usize, knots: Vec<Rational>, points: Vec<Vec<Rational>>) -> Result<Vec<Segment>, Error> {
        let spline = Spline::within(Self::MAX_STEPS, degree, knots, points)?;
        self.charge(spline.steps())?;
        spline.pieces()
    }

    /// A piece over a part of its frame.
    ///
    /// # Errors
    /// As for [`Self::pieces`].
    pub(super) fn part(&mut self, piece: &Segment, frame: &Interval) -> Result<Segment, Error> {
        let longest = |numbers: &mut dyn Iterator<Item = &Rational>| numbers.map(Rational::bits).max().unwrap_or(0);
        let bits = (
            longest(&mut piece.coordinates().iter()),
            longest(&mut [frame.r(), frame.s(), piece.frame().r(), piece.frame().s()].into_iter()),
        );
        self.charge(piece_steps(piece.degree(), piece.dimension(), bits))?;
        piece.reframe(frame)
    }

    fn charge(&mut self, steps: u64) -> Result<(), Error> {
        self.steps = self.steps.saturating_add(steps);
        if self.steps > Self::MAX_STEPS {
            return Err(Error::TooLarge { what: "work for the splines of a file, counted in steps,", limit: Self::MAX_STEPS as usize });
        }
        Ok(())
    }
}
