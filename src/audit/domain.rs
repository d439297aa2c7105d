//! Sides in the parameter space: which pieces lie beside each other there.

use num_traits::Signed;

use crate::affine::Frame;
use crate::exact::Rational;
use crate::model::Part;
use crate::side::Side;

use super::mates::Place;

/// A point of the parameter plane; of the line, with a second coordinate 0.
pub(super) type Point = [Rational; 2];

/// The ends of a side in the parameter space, in order; the same for sides
/// that share it. Curves and patches do not mix, nor do dimensions.
pub(super) type Key = (bool, usize, Point, Point);

/// Where a side runs from and to, and a point of the piece off it.
pub(super) fn edge(part: &Part, side: Side) -> (Point, Point, Point) {
    let on_line = |t: &Rational| [t.clone(), Rational::from(0)];
    match part.piece.frame() {
        Frame::Interval(frame) => {
            let (r, s) = (on_line(frame.r()), on_line(frame.s()));
            if side == Side::End { (s.clone(), s, r) } else { (r.clone(), r, s) }
        }
        Frame::Triangle(frame) => {
            let [r, s, t] = frame.vertices().clone();
            match side {
                Side::Rs => (r, s, t),
                Side::St => (s, t, r),
                _ => (t, r, s),
            }
        }
        Frame::Rectangle(frame) => {
            let corner = |u: &Rational, v: &Rational| [u.clone(), v.clone()];
            let (u, v) = (frame.u(), frame.v());
            match side {
                Side::U0 => (corner(u.r(), v.r()), corner(u.r(), v.s()), corner(u.s(), v.r())),
                Side::U1 => (corner(u.s(), v.r()), corner(u.s(), v.s()), corner(u.r(), v.r())),
                Side::V0 => (corner(u.r(), v.r()), corner(u.s(), v.r()), corner(u.r(), v.s())),
                _ => (corner(u.r(), v.s()), corner(u.s(), v.s()), corner(u.r(), v.r())),
            }
        }
    }
}

/// What sides that share a place in the parameter space have in common; none
/// where the file gives no frame.
pub(super) fn key(part: &Part, side: Side) -> Option<Key> {
    if !part.has_frame {
        return None;
    }
    let (from, to, _) = edge(part, side);
    let is_curve = side.is_end();
    let dimension = part.piece.dimension() - usize::from(part.rational);
    Some(if from <= to { (is_curve, dimension, from, to) } else { (is_curve, dimension, to, from) })
}

/// Whether two sides share a parameter or an edge of the parameter plane, run
/// there as said, and lie on opposite sides of it.
pub(super) fn is_shared(parts: &[Part], first: Place, second: Place, reversed: bool) -> bool {
    let (a, b) = (&parts[first.0], &parts[second.0]);
    if !a.has_frame || !b.has_frame {
        return false;
    }
    let ((from, to, off_a), (start, end, off_b)) = (edge(a, first.1), edge(b, second.1));
    let is_curve = first.1.is_end();
    if is_curve {
        let t = &from[0];
        return start == from && ((&off_a[0] - t) * (&off_b[0] - t)).is_negative();
    }
    let same = if reversed { (&end, &start) == (&from, &to) } else { (&start, &end) == (&from, &to) };
    let turn = |point: &Point| (&to[0] - &from[0]) * (&point[1] - &from[1]) - (&to[1] - &from[1]) * (&point[0] - &from[0]);
    same && (turn(&off_a) * turn(&off_b)).is_negative()
}
