//! Curves and surfaces from their points and parameters.

use crate::affine::{Interval, Rectangle};
use crate::control::ControlNet;
use crate::error::Error;
use crate::exact::Rational;
use crate::kernel::shape::Shape;
use crate::model::Place;
use crate::model::splines::SplineWork;
use crate::piece::Piece;
use crate::rectangular::RectangularPatch;
use crate::segment::Segment;

/// What the points and parameters of a curve or surface mean.
#[derive(Clone, Copy, Debug)]
pub(super) enum Basis {
    /// No `cstype` was stated.
    Unknown,
    Bezier,
    Spline,
    /// One that is passed over, and why.
    Other(&'static str),
}

/// A curve or surface as it is stated.
#[derive(Debug)]
pub(super) struct Element {
    pub(super) place: Place,
    pub(super) basis: Basis,
    pub(super) rational: bool,
    pub(super) is_surface: bool,
    degrees: (usize, usize),
    /// The ends of the range in `u`, and of a surface in `v`.
    pub(super) range: Vec<Rational>,
    /// The indices of its vertices, `u` running first.
    pub(super) points: Vec<usize>,
    /// The breakpoints or knots in `u` and `v`.
    pub(super) parameters: [Vec<Rational>; 2],
}

/// The point with the weight as its last coordinate, if the element is
/// rational; a vertex without a weight has weight 1.
pub(super) fn point(vertex: &[Rational; 3], weight: Option<Option<&Rational>>) -> Vec<Rational> {
    match weight {
        None => vertex.to_vec(),
        Some(None) => vertex.iter().cloned().chain([Rational::from(1)]).collect(),
        Some(Some(weight)) => vertex.iter().map(|x| x * weight).chain([weight.clone()]).collect(),
    }
}

impl Element {
    pub(super) fn new(place: Place, basis: Basis, rational: bool, degrees: (usize, usize)) -> Self {
        Self { place, basis, rational, is_surface: false, degrees, range: Vec::new(), points: Vec::new(), parameters: Default::default() }
    }

    /// The Bézier pieces within the range; those of a surface row by row, `u` first.
    pub(super) fn pieces(&self, points: Vec<Vec<Rational>>, work: &mut SplineWork) -> Result<Vec<Piece>, String> {
        if self.is_surface {
            return self.patches(&points, work);
        }
        let count = self.count(0, self.degrees.0)?;
        if points.len() != count {
            return Err(format!("found {} points of a curve, expected {count} by its degree and `parm`", points.len()));
        }
        let pieces = self.line(0, self.degrees.0, points, work)?;
        Ok(pieces.into_iter().map(Piece::Curve).collect())
    }

    fn patches(&self, points: &[Vec<Rational>], work: &mut SplineWork) -> Result<Vec<Piece>, String> {
        let (p, q) = self.degrees;
        let (columns, rows) = (self.count(0, p)?, self.count(1, q)?);
        if columns.checked_mul(rows) != Some(points.len()) {
            return Err(format!("found {} points of a surface, expected {columns} times {rows} by its degrees and `parm`", points.len()));
        }
        let dimension = points[0].len();
        // In u, a whole column of points is one point of a curve; then in v, a whole row of a strip.
        let column = |i: usize| (0..rows).flat_map(|j| points[j * columns + i].iter().cloned()).collect();
        let mut patches = Vec::new();
        for strip in self.line(0, p, (0..columns).map(column).collect(), work)? {
            let row = |j: usize| strip.points().flat_map(|point| point[j * dimension..(j + 1) * dimension].iter().cloned()).collect();
            for piece in self.line(1, q, (0..rows).map(row).collect(), work)? {
                let coordinate = |i: usize| piece.points().flat_map(move |point| point[i * dimension..(i + 1) * dimension].iter().cloned());
                let net = ControlNet { coordinates: (0..=p).flat_map(coordinate).collect(), shape: Shape::rectangle(p, q, dimension) };
                let frame = Rectangle::new(strip.frame().clone(), piece.frame().clone());
                patches.push(Piece::Rectangle(RectangularPatch::from_net(net, frame)));
            }
        }
        Ok(patches)
    }

    /// How many points the degree and the parameters ask for.
    fn count(&self, axis: usize, degree: usize) -> Result<usize, String> {
        let (letter, found) = (["u", "v"][axis], self.parameters[axis].len());
        if degree == 0 {
            return Err(format!("there is no degree in {letter}, expected it in `deg` before"));
        }
        match self.basis {
            Basis::Spline if found > 2 * degree + 1 => Ok(found - degree - 1),
            Basis::Spline => {
                Err(format!("found {found} knots in `parm {letter}`, expected at least {} for degree {degree}", 2 * degree + 2))
            }
            Basis::Bezier if found > 1 => Ok((found - 1) * degree + 1),
            Basis::Bezier => Err(format!("found {found} breakpoints in `parm {letter}`, expected at least 2")),
            Basis::Unknown | Basis::Other(_) => Err("there is no type of curves and surfaces, expected `cstype` before".into()),
        }
    }

    /// The pieces in one parameter, within its range.
    fn line(&self, axis: usize, degree: usize, points: Vec<Vec<Rational>>, work: &mut SplineWork) -> Result<Vec<Segment>, String> {
        let parameters = &self.parameters[axis];
        let pieces = match self.basis {
            Basis::Spline => work.pieces(degree, parameters.clone(), points),
            _ => bezier_pieces(degree, parameters, &points),
        };
        self.within_range(axis, pieces.map_err(|error| error.to_string())?, work)
    }

    /// What of the pieces lies in the range of one parameter.
    fn within_range(&self, axis: usize, pieces: Vec<Segment>, work: &mut SplineWork) -> Result<Vec<Segment>, String> {
        let (from, to) = (&self.range[2 * axis], &self.range[2 * axis + 1]);
        let (Some(first), Some(last)) = (pieces.first(), pieces.last()) else { return Ok(pieces) };
        let (low, high) = (first.frame().r(), last.frame().s());
        if from >= to || from < low || to > high {
            return Err(format!("found the range {from}..{to} in {}, expected a part of {low}..{high}", ["u", "v"][axis]));
        }
        let part = |piece: Segment| {
            let (r, s) = (piece.frame().r().max(from).clone(), piece.frame().s().min(to).clone());
            if (&r, &s) == (piece.frame().r(), piece.frame().s()) {
                return Some(Ok(piece));
            }
            (r < s).then(|| work.part(&piece, &Interval::new(r, s)?))
        };
        pieces.into_iter().filter_map(part).collect::<Result<_, Error>>().map_err(|error| error.to_string())
    }
}

/// The Bézier pieces over the intervals between breakpoints; neighbours share a point.
fn bezier_pieces(degree: usize, breakpoints: &[Rational], points: &[Vec<Rational>]) -> Result<Vec<Segment>, Error> {
    let piece = |(k, ends): (usize, &[Rational])| {
        if ends[0] >= ends[1] {
            return Err(Error::WrongShape(format!("the breakpoints must rise: {} stands before {}", ends[0], ends[1])));
        }
        let own = points[k * degree..=(k + 1) * degree].to_vec();
        Segment::from_points(own, Interval::new(ends[0].clone(), ends[1].clone())?)
    };
    breakpoints.windows(2).enumerate().map(piece).collect()
}
