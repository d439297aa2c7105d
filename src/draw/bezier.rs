//! Curves in the coordinates of the paper.
//!
//! The control points have been computed exactly and then placed on the paper,
//! so they are ordinary numbers of moderate size, and de Casteljau's algorithm
//! inside the frame is stable. What comes out is ink, never an answer.

use std::fmt::Write as _;

use super::svg::number;

/// A point of the paper, in pixels from the top left corner.
pub(super) type Point = [f64; 2];

/// How far a cubic may be from the curve it stands for, in pixels.
const TOLERANCE: f64 = 0.05;

/// The control points of a curve on the paper, and their weights.
#[derive(Clone, Debug)]
pub(super) struct Bezier {
    pub(super) points: Vec<Point>,
    /// All 1 for a polynomial curve.
    weights: Vec<f64>,
}

/// The point `a + (b - a) part`.
pub(super) fn mix(a: Point, b: Point, part: f64) -> Point {
    [a[0] + (b[0] - a[0]) * part, a[1] + (b[1] - a[1]) * part]
}

/// The distance of two points.
pub(super) fn distance(a: Point, b: Point) -> f64 {
    (a[0] - b[0]).hypot(a[1] - b[1])
}

impl Bezier {
    /// The polynomial curve with these control points.
    pub(super) fn new(points: Vec<Point>) -> Self {
        let weights = vec![1.0; points.len()];
        Self { points, weights }
    }

    /// The same control points with other weights, as many, none of them 0.
    pub(super) fn with_weights(self, weights: Vec<f64>) -> Self {
        debug_assert_eq!(self.points.len(), weights.len());
        Self { weights, ..self }
    }

    fn is_polynomial(&self) -> bool {
        self.weights.windows(2).all(|pair| pair[0] == pair[1])
    }

    /// The first point.
    pub(super) fn start(&self) -> Point {
        self.points.first().copied().unwrap_or_default()
    }

    /// The last point.
    pub(super) fn end(&self) -> Point {
        self.points.last().copied().unwrap_or_default()
    }

    /// The curve run through backwards.
    pub(super) fn reversed(&self) -> Self {
        Self { points: self.points.iter().rev().copied().collect(), weights: self.weights.iter().rev().copied().collect() }
    }

    /// The curve whose homogeneous control points are these.
    fn projected(row: Vec<[f64; 3]>) -> Self {
        Self { points: row.iter().map(|[x, y, w]| [x / w, y / w]).collect(), weights: row.iter().map(|&[_, _, w]| w).collect() }
    }

    /// The control points before and after a parameter.
    pub(super) fn split(&self, part: f64) -> (Self, Self) {
        let mut row: Vec<[f64; 3]> = self.points.iter().zip(&self.weights).map(|([x, y], w)| [x * w, y * w, *w]).collect();
        let (mut left, mut right) = (Vec::with_capacity(row.len()), Vec::with_capacity(row.len()));
        while let (Some(&first), Some(&last)) = (row.first(), row.last()) {
            left.push(first);
            right.push(last);
            for index in 1..row.len() {
                row[index - 1] = std::array::from_fn(|k| row[index - 1][k] + (row[index][k] - row[index - 1][k]) * part);
            }
            row.pop();
        }
        right.reverse();
        (Self::projected(left), Self::projected(right))
    }

    /// The pieces after so many rounds of splitting in the middle.
    pub(super) fn subdivide(self, depth: usize) -> Vec<Self> {
        (0..depth).fold(vec![self], |pieces, _| {
            let halves = pieces.iter().flat_map(|piece| {
                let (left, right) = piece.split(0.5);
                [left, right]
            });
            halves.collect()
        })
    }

    /// The points at so many equal steps of the parameter.
    pub(super) fn samples(&self, steps: usize) -> Vec<Point> {
        (0..=steps).map(|step| self.split(step as f64 / steps as f64).1.start()).collect()
    }

    /// The cubic with the same end points and end tangents.
    fn hermite(&self) -> [Point; 4] {
        let [start, end] = [self.start(), self.end()];
        let third = self.points.len().saturating_sub(1) as f64 / 3.0;
        match (self.points.as_slice(), self.weights.as_slice()) {
            ([_, second, ..], [own, next, ..]) => {
                let back = self.points.len() - 2;
                let leaving = mix(start, *second, third * next / own);
                [start, leaving, mix(end, self.points[back], third * self.weights[back] / self.weights[back + 1]), end]
            }
            _ => [start, start, end, end],
        }
    }

    /// Cubics that follow the curve more closely than can be seen.
    fn cubics(&self, depth: usize, found: &mut Vec<[Point; 4]>) {
        let cubic = self.hermite();
        let close = [0.25, 0.5, 0.75].into_iter().all(|part| {
            let exact = self.split(part).1.start();
            distance(exact, Self::new(cubic.to_vec()).split(part).1.start()) < TOLERANCE
        });
        // A curve of high degree gets a few pieces whatever it looks like at three parameters.
        let coarse = (self.points.len() > 4 || !self.is_polynomial()) && depth < 2;
        if depth >= 9 || (close && !coarse) {
            found.push(cubic);
        } else {
            let (left, right) = self.split(0.5);
            left.cubics(depth + 1, found);
            right.cubics(depth + 1, found);
        }
    }

    /// The curve as path commands: the Bézier commands themselves for polynomials
    /// up to degree 3, and cubics that meet with common tangents beyond.
    pub(super) fn path(&self) -> String {
        let mut path = format!("M{}", place(self.start()));
        let command = match self.points.len() {
            0 | 1 => return path,
            2 => "L",
            3 if self.is_polynomial() => "Q",
            4 if self.is_polynomial() => "C",
            _ => {
                let mut cubics = Vec::new();
                self.cubics(0, &mut cubics);
                for [_, second, third, end] in cubics {
                    // Writing to a string does not fail.
                    let _ = write!(path, " C{} {} {}", place(second), place(third), place(end));
                }
                return path;
            }
        };
        let rest: Vec<String> = self.points[1..].iter().map(|&point| place(point)).collect();
        let _ = write!(path, " {command}{}", rest.join(" "));
        path
    }

    /// What comes right after the end, as far as all of it passes the test,
    /// and at most a quarter of the parameters of the curve.
    pub(super) fn continuation(&self, inside: impl Fn(Point) -> bool) -> Option<Self> {
        let after = |part: f64| self.split(part).1.reversed();
        let fits = |part: &f64| {
            let more = after(*part);
            // Beyond a weight 0 the curve comes back from the other side.
            more.points.iter().all(|&point| inside(point)) && more.weights.iter().all(|weight| weight * self.weights[0] > 0.0)
        };
        let part = (1..=12).rev().map(|step| 1.0 + f64::from(step) / 48.0).find(fits)?;
        Some(after(part))
    }
}

/// The polygon through points, as path commands.
pub(super) fn polygon(points: &[Point]) -> String {
    let places: Vec<String> = points.iter().map(|&point| place(point)).collect();
    format!("M{}", places.join(" L"))
}

/// A point as the pair of numbers that SVG expects.
pub(super) fn place(point: Point) -> String {
    format!("{},{}", number(point[0]), number(point[1]))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn splitting_meets_the_curve() {
        let cubic = Bezier::new(vec![[0.0, 0.0], [0.0, 8.0], [8.0, 8.0], [8.0, 0.0]]);
        let (left, right) = cubic.split(0.5);
        assert_eq!((left.end(), right.start()), ([4.0, 6.0], [4.0, 6.0]));
        assert_eq!(cubic.clone().subdivide(3).len(), 8);
        assert_eq!(cubic.samples(4)[2], [4.0, 6.0]);
        assert_eq!(cubic.reversed().start(), [8.0, 0.0]);
    }

    #[test]
    fn low_degrees_are_exact_commands() {
        let points = [[0.0, 0.0], [10.0, 20.0], [30.25, 0.0], [40.0, -0.001]];
        let path = |count: usize| Bezier::new(points[..count].to_vec()).path();
        assert_eq!(path(1), "M0,0");
        assert_eq!(path(2), "M0,0 L10,20");
        assert_eq!(path(3), "M0,0 Q10,20 30.25,0");
        assert_eq!(path(4), "M0,0 C10,20 30.25,0 40,0");
    }

    #[test]
    fn high_degrees_are_followed_closely() {
        let wave = Bezier::new((0..8).map(|i| [50.0 * f64::from(i), if i % 2 == 0 { 0.0 } else { 300.0 }]).collect());
        let mut cubics = Vec::new();
        wave.cubics(0, &mut cubics);
        assert!((4..64).contains(&cubics.len()), "{}", cubics.len());
        assert!(cubics.windows(2).all(|pair| distance(pair[0][3], pair[1][0]) < 1e-9));
    }

    #[test]
    fn continuations_stay_inside() {
        let line = Bezier::new(vec![[0.0, 0.0], [100.0, 0.0]]);
        let longer = line.continuation(|point| point[0] <= 110.0);
        assert!(longer.is_some_and(|longer| longer.start() == [100.0, 0.0] && (104.0..=110.0).contains(&longer.end()[0])));
        assert!(line.continuation(|point| point[0] < 101.0).is_none());
    }

    #[test]
    fn weights_make_circles() {
        // A quarter of the circle of radius 100 about the origin.
        let arc = Bezier::new(vec![[100.0, 0.0], [100.0, 100.0], [0.0, 100.0]]).with_weights(vec![1.0, 1.0, 2.0]);
        let on_circle = |point: Point| (point[0].hypot(point[1]) - 100.0).abs() < 1e-9;
        assert!(arc.samples(16).into_iter().chain(arc.split(0.3).1.samples(3)).all(on_circle));
        let mut cubics = Vec::new();
        arc.cubics(0, &mut cubics);
        for cubic in cubics {
            assert!(on_circle(cubic[0]) && on_circle(cubic[3]));
            let samples = Bezier::new(cubic.to_vec()).samples(8);
            assert!(samples.into_iter().all(|point| (point[0].hypot(point[1]) - 100.0).abs() < TOLERANCE));
        }
        // Beyond the parameter where the weight is 0 nothing is continued.
        let hyperbola = Bezier::new(vec![[0.0, 0.0], [1.0, 0.0]]).with_weights(vec![1.0, 0.04]);
        assert!(hyperbola.continuation(|_| true).is_none_or(|more| more.weights.iter().all(|&weight| weight > 0.0)));
    }
}
