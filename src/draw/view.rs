//! Where points of the plane are on the paper.
//!
//! The bounding box is mapped to the picture in exact arithmetic; only the
//! result becomes a float. So points of any size, and of any distance from one
//! another, have finite places.

use num_traits::{One, Signed, Zero};

use super::bezier::Point;
use crate::exact::Rational;

/// Pixels between the points and the border of the plot, for labels.
const INSET: [i64; 2] = [80, 46];
/// The most pixels the points may take.
const ROOM: [i64; 2] = [476, 430];
/// The fewest pixels the plot offers to them.
const LEAST: [i64; 2] = [400, 150];
/// The height of a plot whose axes have nothing to do with one another.
const FREE_HEIGHT: i64 = 320;
/// How many times longer one side may be before the axes get scales of their own.
const RATIO: i64 = 20;

/// A rectangle of the paper.
#[derive(Clone, Copy, Debug)]
pub(super) struct Rect {
    pub(super) left: f64,
    pub(super) top: f64,
    pub(super) right: f64,
    pub(super) bottom: f64,
}

impl Rect {
    /// Whether a point lies inside.
    pub(super) fn contains(&self, [x, y]: Point) -> bool {
        self.left <= x && x <= self.right && self.top <= y && y <= self.bottom
    }

    /// The rectangle with all sides moved outwards.
    pub(super) fn grown(&self, by: f64) -> Self {
        Self { left: self.left - by, top: self.top - by, right: self.right + by, bottom: self.bottom + by }
    }

    /// The area common to both.
    pub(super) fn overlap(&self, other: &Self) -> f64 {
        let width = self.right.min(other.right) - self.left.max(other.left);
        let height = self.bottom.min(other.bottom) - self.top.max(other.top);
        width.max(0.0) * height.max(0.0)
    }

    /// How much of a segment of a line lies inside.
    pub(super) fn length_inside(&self, from: Point, to: Point) -> f64 {
        let (mut enter, mut leave) = (0.0_f64, 1.0_f64);
        for (start, end, low, high) in [(from[0], to[0], self.left, self.right), (from[1], to[1], self.top, self.bottom)] {
            let step = end - start;
            if step.abs() < 1e-9 {
                if start < low || start > high {
                    return 0.0;
                }
                continue;
            }
            let (first, second) = ((low - start) / step, (high - start) / step);
            enter = enter.max(first.min(second));
            leave = leave.min(first.max(second));
        }
        (leave - enter).max(0.0) * (from[0] - to[0]).hypot(from[1] - to[1])
    }
}

/// How the two axes share the plot.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Fit {
    /// A unit is as long on one axis as on the other.
    Rigid,
    /// The same, unless one side of the box would be too thin to be seen.
    Equal,
    /// Each axis has its own unit.
    Free,
}

/// The map from the plane to the paper.
#[derive(Clone, Debug)]
pub(super) struct View {
    low: [Rational; 2],
    /// Pixels for a unit.
    scale: [Rational; 2],
    /// Pixels from the border of the plot to the lowest point.
    shift: [Rational; 2],
    size: [Rational; 2],
    /// The plot.
    pub(super) rect: Rect,
}

/// Half the width of what is shown around a single number.
fn surroundings(number: &Rational) -> Rational {
    if number.is_zero() { Rational::one() } else { number.abs() / Rational::from(2) }
}

impl View {
    /// The view of all of these points, with the plot at a corner of the paper.
    pub(super) fn of<'a>(points: impl IntoIterator<Item = &'a [Rational]>, fit: Fit, corner: Point) -> Self {
        let mut points = points.into_iter();
        let first = points.next().unwrap_or_default();
        let mut low = [0, 1].map(|axis| first.get(axis).cloned().unwrap_or_default());
        let mut high = low.clone();
        for point in points {
            for (axis, value) in point.iter().enumerate().take(2) {
                if *value < low[axis] {
                    low[axis] = value.clone();
                }
                if *value > high[axis] {
                    high[axis] = value.clone();
                }
            }
        }
        Self::fitted(low, high, fit, corner)
    }

    fn fitted(mut low: [Rational; 2], mut high: [Rational; 2], mut fit: Fit, corner: Point) -> Self {
        let extent = |low: &[Rational; 2], high: &[Rational; 2]| [&high[0] - &low[0], &high[1] - &low[1]];
        let [width, height] = extent(&low, &high);
        let thin = |a: &Rational, b: &Rational| !a.is_zero() && a * Rational::from(RATIO) < *b;
        if fit == Fit::Equal && (thin(&width, &height) || thin(&height, &width)) {
            fit = Fit::Free;
        }
        let single = width.is_zero() && height.is_zero();
        let nonzero = low.iter().filter(|number| !number.is_zero());
        let around = nonzero.map(surroundings).max().unwrap_or_else(Rational::one);
        for axis in 0..2 {
            if low[axis] == high[axis] && (single || fit == Fit::Free) {
                let half = if fit == Fit::Free { surroundings(&low[axis]) } else { around.clone() };
                high[axis] = &low[axis] + &half;
                low[axis] -= half;
            }
        }
        let extent = extent(&low, &high);
        let room = if fit == Fit::Free { [ROOM[0], FREE_HEIGHT] } else { ROOM };
        let fills = [0, 1].map(|axis| Rational::from(room[axis]).checked_div(&extent[axis]));
        let smallest = fills.iter().flatten().min().cloned().unwrap_or_else(Rational::one);
        let scale = fills.map(|fill| if fit == Fit::Free { fill.unwrap_or_else(|| smallest.clone()) } else { smallest.clone() });
        let size = [0, 1].map(|axis| (&extent[axis] * &scale[axis]).max(Rational::from(LEAST[axis])) + Rational::from(2 * INSET[axis]));
        let shift = [0, 1].map(|axis| (&size[axis] - &extent[axis] * &scale[axis]) / Rational::from(2));
        let [left, top] = corner;
        let rect = Rect { left, top, right: left + size[0].approximate(), bottom: top + size[1].approximate() };
        Self { low, scale, shift, size, rect }
    }

    /// Moves the plot to the right.
    pub(super) fn shift_right(&mut self, by: f64) {
        self.rect.left += by;
        self.rect.right += by;
    }

    /// The place of a point.
    pub(super) fn place(&self, point: &[Rational]) -> Point {
        let from_border = |axis: usize| {
            let value = point.get(axis).unwrap_or(&self.low[axis]);
            ((value - &self.low[axis]) * &self.scale[axis] + &self.shift[axis]).approximate()
        };
        [self.rect.left + from_border(0), self.rect.bottom - from_border(1)]
    }

    /// The numbers of an axis that the plot shows.
    pub(super) fn range(&self, axis: usize) -> (Rational, Rational) {
        let low = &self.low[axis] - &self.shift[axis] / &self.scale[axis];
        let high = &low + &self.size[axis] / &self.scale[axis];
        (low, high)
    }

    /// The number of units that so many pixels of an axis are.
    pub(super) fn units(&self, axis: usize, pixels: i64) -> Rational {
        Rational::from(pixels) / &self.scale[axis]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn view(points: &[[Rational; 2]], fit: Fit) -> View {
        View::of(points.iter().map(<[_; 2]>::as_slice), fit, [64.0, 50.0])
    }

    #[test]
    fn units_are_equally_long() {
        let points = [[0, 0], [10, 5]].map(|point| point.map(Rational::from));
        let view = view(&points, Fit::Equal);
        let [[x, y], [u, v]] = [view.place(&points[0]), view.place(&points[1])];
        assert!(((u - x) - 2.0 * (y - v)).abs() < 1e-9 && (u - x - 476.0).abs() < 1e-9);
        assert!(view.range(0).0 < points[0][0] && points[1][0] < view.range(0).1);
        assert_eq!(view.units(0, 476), Rational::from(10));
    }

    #[test]
    fn extreme_points_have_finite_places() {
        let (huge, tiny) = (Rational::from(10).pow(300), Rational::new(1, 10).pow(300));
        for values in [[&huge, &tiny], [&tiny, &tiny], [&huge, &huge]] {
            for fit in [Fit::Rigid, Fit::Equal, Fit::Free] {
                let points = [values.map(Clone::clone), [Rational::zero(), Rational::zero()], values.map(|value| -value)];
                for count in 1..=3 {
                    let view = view(&points[..count], fit);
                    assert!(points[..count].iter().all(|point| view.rect.contains(view.place(point))));
                }
            }
        }
    }

    #[test]
    fn thin_boxes_are_stretched() {
        let points = [[0, 0], [1000, 1]].map(|point| point.map(Rational::from));
        let height = |fit| {
            let view = view(&points, fit);
            view.place(&points[0])[1] - view.place(&points[1])[1]
        };
        assert!(height(Fit::Equal) > 100.0 && height(Fit::Rigid) < 1.0);
    }

    #[test]
    fn rectangles() {
        let rect = Rect { left: 0.0, top: 0.0, right: 10.0, bottom: 10.0 };
        assert_eq!(rect.overlap(&Rect { left: 5.0, top: 8.0, right: 20.0, bottom: 20.0 }), 10.0);
        assert_eq!(rect.length_inside([-5.0, 5.0], [5.0, 5.0]), 5.0);
        assert_eq!(rect.length_inside([-5.0, 15.0], [5.0, 15.0]), 0.0);
        assert!(rect.grown(1.0).contains([-0.5, 10.5]));
    }
}
