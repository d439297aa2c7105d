//! Points of space on the plane: an orthographic projection, and the floor
//! that lets depth be read.

use num_traits::{One, Signed, Zero};

use super::bezier::{Point, distance, mix, polygon};
use super::label::{Obstacles, width};
use super::style;
use super::svg::{Anchor, Stroke, Svg, Type};
use super::ticks::Step;
use super::view::View;
use crate::affine::AffineMap;
use crate::error::Error;
use crate::exact::Rational;

/// How many times longer one side may be before every axis gets a scale of its own.
const RATIO: i64 = 20;

/// A box of space and the direction it is looked at from.
#[derive(Clone, Debug)]
pub(super) struct Space {
    /// The box, from tick to tick.
    ranges: [(Rational, Rational); 3],
    steps: [Step; 3],
    map: AffineMap,
    /// How far toward the eye a point is, in the units of the plane.
    depth: AffineMap,
    /// Whether the side of the box that is closer to the eye is the upper one, for x and y.
    upper_is_near: [bool; 2],
}

/// The number with six digits, which is as much as ink needs.
fn rounded(value: f64) -> Rational {
    Rational::new((value * 1e6).round() as i64, 1_000_000)
}

impl Space {
    /// The box around points, seen from these angles in degrees.
    pub(super) fn new<'a>(points: impl Iterator<Item = &'a [Rational]> + Clone, azimuth: i32, elevation: i32) -> Result<Self, Error> {
        let bound = |axis: usize| {
            let values = points.clone().filter_map(move |point| point.get(axis));
            (values.clone().min().cloned().unwrap_or_default(), values.max().cloned().unwrap_or_default())
        };
        let mut ranges = [bound(0), bound(1), bound(2)];
        let extents = ranges.each_ref().map(|(low, high)| high - low);
        let largest = extents.iter().max().cloned().unwrap_or_default();
        let thin = extents.iter().any(|extent| !extent.is_zero() && extent * Rational::from(RATIO) < largest);
        let flat = if largest.is_zero() {
            let size = ranges.iter().map(|(low, _)| low.abs()).max().unwrap_or_default();
            if size.is_zero() { Rational::one() } else { size / Rational::from(2) }
        } else {
            &largest / Rational::from(8)
        };
        for (low, high) in &mut ranges {
            if low == high {
                *low -= &flat;
                *high += &flat;
            }
        }
        let longest = ranges.iter().map(|(low, high)| high - low).max().unwrap_or_else(Rational::one);
        let steps = ranges.each_ref().map(|(low, high)| {
            let length = if thin { high - low } else { longest.clone() };
            Step::at_least(&(length / Rational::from(5)))
        });
        for (range, step) in ranges.iter_mut().zip(&steps) {
            *range = step.widen(&range.0, &range.1);
        }
        let (sin, cos) = f64::from(azimuth.rem_euclid(360)).to_radians().sin_cos();
        let (rise, run) = f64::from(elevation.rem_euclid(360)).to_radians().sin_cos();
        let rows = [[-sin, cos, 0.0], [-rise * cos, -rise * sin, run], [run * cos, run * sin, rise]];
        let longest = ranges.iter().map(|(low, high)| high - low).max().unwrap_or_else(Rational::one);
        let scaled = |row: &[f64; 3]| -> Vec<Rational> {
            let length = |(low, high): &(Rational, Rational)| if thin { high - low } else { longest.clone() };
            row.iter().zip(&ranges).map(|(entry, range)| rounded(*entry) / length(range)).collect()
        };
        let mut rows: Vec<Vec<Rational>> = rows.iter().map(scaled).collect();
        let depth = AffineMap::new(rows.split_off(2), vec![Rational::zero()])?;
        let map = AffineMap::new(rows, vec![Rational::zero(), Rational::zero()])?;
        Ok(Self { ranges, steps, map, depth, upper_is_near: [cos * run >= 0.0, sin * run >= 0.0] })
    }

    /// The point of the plane that a point is seen at.
    pub(super) fn flat(&self, point: &[Rational]) -> Result<Vec<Rational>, Error> {
        self.map.apply(point)
    }

    /// How far toward the eye a point is.
    pub(super) fn toward(&self, point: &[Rational]) -> Result<Rational, Error> {
        Ok(self.depth.apply(point)?.swap_remove(0))
    }

    /// The point of the floor below a point.
    pub(super) fn below(&self, point: &[Rational]) -> Vec<Rational> {
        let mut point = point.to_vec();
        if let Some(height) = point.get_mut(2) {
            height.clone_from(&self.ranges[2].0);
        }
        point
    }

    fn corner(&self, upper: [bool; 3]) -> Vec<Rational> {
        self.ranges.iter().zip(upper).map(|((low, high), upper)| if upper { high.clone() } else { low.clone() }).collect()
    }

    /// The corners of the floor on the plane, and what is above the left one.
    pub(super) fn corners(&self) -> Result<Vec<Vec<Rational>>, Error> {
        let [x, y] = self.left();
        let floor = (0..4).map(|bits| self.corner([bits & 1 != 0, bits & 2 != 0, false]));
        floor.chain([self.corner([x, y, true])]).map(|corner| self.flat(&corner)).collect()
    }

    /// The corner of the floor that is seen at the left, of the two that the near edges end in.
    fn left(&self) -> [bool; 2] {
        let [near_x, near_y] = self.upper_is_near;
        let corners = [[near_x, !near_y], [!near_x, near_y]];
        // An error would have come up before: the corners have three coordinates.
        let over = |[x, y]: [bool; 2]| self.flat(&self.corner([x, y, false])).ok().and_then(|point| point.first().cloned());
        if over(corners[0]) < over(corners[1]) { corners[0] } else { corners[1] }
    }

    /// Draws the floor with its lines and numbers, and the upright edge at the left.
    pub(super) fn draw(&self, svg: &mut Svg, view: &View, obstacles: &mut Obstacles) -> Result<(), Error> {
        let seen = |point: &[Rational]| -> Result<Point, Error> { Ok(view.place(&self.flat(point)?)) };
        let [near_x, near_y] = self.upper_is_near;
        let [left_x, left_y] = self.left();
        let ring = [[near_x, near_y], [near_x, !near_y], [!near_x, !near_y], [!near_x, near_y]];
        let ring = ring.iter().map(|&[x, y]| seen(&self.corner([x, y, false]))).collect::<Result<Vec<Point>, _>>()?;
        svg.open("floor");
        svg.filled(&polygon(&ring), style::FLOOR);
        obstacles.add(&[ring[0], ring[1], ring[2], ring[3], ring[0]], 0.3);
        for axis in 0..3 {
            let start = if axis == 2 { [left_x, left_y, false] } else { [near_x, near_y, false] };
            let mut opposite = start;
            opposite[1 - axis.min(1)] ^= true;
            let (low, high) = &self.ranges[axis];
            let mut places = Vec::new();
            let mut outward = [-1.0, 0.0];
            for (index, (value, text)) in self.steps[axis].ticks(low, high).into_iter().enumerate() {
                let along = |corner: [bool; 3]| {
                    let mut point = self.corner(corner);
                    point[axis].clone_from(&value);
                    seen(&point)
                };
                let at = along(start)?;
                places.push(at);
                if axis == 2 {
                    svg.line(at, [at[0] - 4.0, at[1]], Stroke::solid(style::AXIS, 1.0));
                } else {
                    let end = along(opposite)?;
                    svg.line(at, end, Stroke::solid(style::GRID_IN_SPACE, 1.0));
                    let length = distance(at, end);
                    outward = if length > 1.0 { [(at[0] - end[0]) / length, (at[1] - end[1]) / length] } else { [0.0, 1.0] };
                }
                // The lowest number of z would stand on one of x or y.
                if axis < 2 || index > 0 {
                    obstacles.dots.push((number(svg, at, outward, &text), 6.0));
                }
            }
            let (Some(&first), Some(&last)) = (places.first(), places.last()) else { continue };
            svg.line(first, last, Stroke::solid(style::AXIS, 1.2));
            obstacles.add(&[first, last], 0.3);
            let name = if axis == 2 {
                [last[0], last[1] - 11.0]
            } else {
                let middle = mix(first, last, 0.5);
                [middle[0] + 42.0 * outward[0], middle[1] + 42.0 * outward[1] + 4.0]
            };
            svg.text(name, ["x", "y", "z"][axis], Type { bold: true, ..Type::new(13.0, style::QUIET_TEXT, Anchor::Middle) });
            obstacles.dots.push(([name[0], name[1] - 4.0], 8.0));
        }
        svg.close();
        Ok(())
    }
}

/// Writes a number beside an edge; gives the middle of the text.
fn number(svg: &mut Svg, at: Point, outward: Point, text: &str) -> Point {
    let half = width(text, style::TICK_SIZE) / 2.0;
    // A text beside the edge needs half of its width, one below it half of its height.
    let reach = 8.0 + half * outward[0].abs() + 4.0 * outward[1].abs();
    let middle = [at[0] + reach * outward[0], at[1] + reach * outward[1]];
    svg.text([middle[0], middle[1] + 4.0], text, Type::new(style::TICK_SIZE, style::QUIET_TEXT, Anchor::Middle));
    middle
}

#[cfg(test)]
mod tests {
    use super::*;

    fn space(points: &[[i64; 3]], azimuth: i32, elevation: i32) -> Space {
        let points: Vec<Vec<Rational>> = points.iter().map(|point| point.map(Rational::from).to_vec()).collect();
        Space::new(points.iter().map(Vec::as_slice), azimuth, elevation).unwrap()
    }

    #[test]
    fn from_above_the_plane_is_seen() {
        let space = space(&[[0, 0, 0], [10, 5, 1]], -90, 90);
        assert_eq!(space.flat(&[3, 4, 5].map(Rational::from)), Ok(vec![Rational::new(3, 10), Rational::new(4, 10)]));
    }

    #[test]
    fn boxes_reach_from_tick_to_tick() {
        let space = space(&[[-1, 0, 2], [9, 0, 3]], 30, 25);
        assert_eq!(space.ranges[0], (Rational::from(-2), Rational::from(10)));
        assert_eq!(space.ranges[1], (Rational::from(-2), Rational::from(2)));
        assert_eq!(space.below(&[1, 1, 1].map(Rational::from))[2], Rational::from(2));
    }

    #[test]
    fn a_single_point_has_a_box() {
        for point in [[0, 0, 0], [7, 0, -2]] {
            let space = space(&[point], 30, 25);
            assert!(space.ranges.iter().all(|(low, high)| low < high));
        }
    }
}
