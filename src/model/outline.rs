//! Outlines: contours of curves, each of which begins where the one before ends.

use super::{Flaw, Follow, Format, Model, Omission, Part, Place};
use crate::affine::Interval;
use crate::exact::Rational;
use crate::piece::Piece;
use crate::segment::Segment;

pub(super) type Point = [Rational; 2];

/// The contours of a file as they are read.
#[derive(Debug, Default)]
pub(super) struct Outline {
    parts: Vec<Part>,
    joints: Vec<Follow>,
    omissions: Vec<Omission>,
    /// The contours begun so far.
    contours: usize,
    run: Option<Run>,
}

/// A point where a contour begins, or where curves of it meet.
#[derive(Clone, Debug)]
pub(super) struct Node {
    pub(super) point: Point,
    /// Its index among all points of the contour.
    pub(super) index: usize,
    pub(super) place: Place,
    pub(super) smooth: bool,
}

/// The contour at hand.
#[derive(Debug)]
struct Run {
    start: Node,
    here: Node,
    /// The piece that begins at the start, if the contour does not begin with a gap.
    first: Option<usize>,
    /// The piece that ends here.
    last: Option<usize>,
    is_empty: bool,
}

impl Outline {
    /// Begins a contour. The one before is left open.
    pub(super) fn begin(&mut self, start: Node) {
        self.contours += 1;
        self.run = Some(Run { here: start.clone(), start, first: None, last: None, is_empty: true });
    }

    /// Leaves the contour at hand open.
    pub(super) fn end(&mut self) {
        self.run = None;
    }

    /// Where the contour at hand has come to.
    pub(super) fn here(&self) -> Option<&Node> {
        self.run.as_ref().map(|run| &run.here)
    }

    /// Goes on from here by a curve with these inner control points, which
    /// stands at a place in the file.
    pub(super) fn curve<const N: usize>(&mut self, controls: [Point; N], end: Node, place: Place) -> Result<(), Flaw> {
        let Some(run) = &mut self.run else { return Ok(()) };
        let points = [run.here.point.clone()].into_iter().chain(controls).chain([end.point.clone()]);
        let segment = Segment::new(2, points.flatten().collect(), Interval::unit()).map_err(|error| Flaw::at(place, error.to_string()))?;
        let second = self.parts.len();
        Part { piece: Piece::Curve(segment), rational: false, has_frame: false, name: None, place }.add_to(&mut self.parts)?;
        match run.last {
            Some(first) => self.joints.push(run.here.follow(first, second, self.contours - 1)),
            None if run.is_empty => run.first = Some(second),
            None => {}
        }
        (run.here, run.last, run.is_empty) = (end, Some(second), false);
        Ok(())
    }

    /// Goes on from here by something that is no piece.
    pub(super) fn gap(&mut self, end: Node, omission: Omission) {
        self.omissions.push(omission);
        if let Some(run) = &mut self.run {
            (run.here, run.last, run.is_empty) = (end, None, false);
        }
    }

    /// Passes something over.
    pub(super) fn omit(&mut self, omission: Omission) {
        self.omissions.push(omission);
    }

    /// Closes the contour, by a line if it has not come back to its start.
    pub(super) fn close(&mut self, place: Place) -> Result<(), Flaw> {
        let Some(run) = &self.run else { return Ok(()) };
        if run.here.point != run.start.point {
            let start = run.start.clone();
            self.curve([], start, place)?;
        }
        if let Some(Run { start, here, first: Some(first), last: Some(last), .. }) = self.run.take() {
            let node = Node { smooth: start.smooth || here.smooth, ..start };
            self.joints.push(node.follow(last, first, self.contours - 1));
        }
        Ok(())
    }

    /// The model that these contours are.
    pub(super) fn into_model(self, format: Format, decimals: u32) -> Model {
        let Self { parts, joints, omissions, .. } = self;
        Model { format, parts, joints, meets_by_position: false, decimals, omissions }
    }
}

impl Node {
    fn follow(&self, first: usize, second: usize, contour: usize) -> Follow {
        Follow { first, second, contour, node: self.index, place: self.place, smooth: self.smooth }
    }
}
