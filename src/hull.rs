//! What encloses a control polygon: its bounding box, and in the plane its convex hull.

use crate::error::Error;
use crate::exact::Rational;
use num_traits::Signed;

/// The smallest box with sides along the axes around points: its least and
/// its largest corner. A segment of a curve lies in the box of its control points.
///
/// # Errors
/// [`Error::WrongShape`] if there is no point.
pub fn bounding_box<'a>(mut points: impl Iterator<Item = &'a [Rational]>) -> Result<(Vec<Rational>, Vec<Rational>), Error> {
    let first = points.next().ok_or_else(|| Error::WrongShape("there is no point to enclose".into()))?;
    let (mut least, mut largest) = (first.to_vec(), first.to_vec());
    for point in points {
        for ((low, high), x) in least.iter_mut().zip(&mut largest).zip(point) {
            if x < low {
                low.clone_from(x);
            }
            if x > high {
                high.clone_from(x);
            }
        }
    }
    Ok((least, largest))
}

/// The convex hull of points in the plane.
///
/// A segment of a curve over its frame lies in the hull of its control points
/// (CS348a, lecture 6, section 3.1; the lecture says end points and means
/// control points).
///
/// ```
/// use casteljau::{ConvexHull, Rational};
/// let square = [[0, 0], [0, 1], [1, 1], [1, 0]].map(|p| p.map(Rational::from));
/// let hull = ConvexHull::of(square.iter().map(|p| p.as_slice()))?;
/// assert!(hull.contains(&[Rational::new(1, 2), Rational::new(3, 4)]));
/// # Ok::<(), casteljau::Error>(())
/// ```
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ConvexHull {
    vertices: Vec<[Rational; 2]>,
}

impl ConvexHull {
    /// The hull, by Andrew's monotone chain (A. M. Andrew, "Another efficient
    /// algorithm for convex hulls in two dimensions", 1979) with exact signs.
    ///
    /// # Errors
    /// [`Error::WrongShape`] if there is no point; [`Error::Unsupported`] if a
    /// point is not in the plane.
    pub fn of<'a>(points: impl Iterator<Item = &'a [Rational]>) -> Result<Self, Error> {
        let mut sorted = Vec::new();
        for point in points {
            match point {
                [x, y] => sorted.push([x.clone(), y.clone()]),
                _ => return Err(Error::Unsupported(format!("a convex hull needs points of the plane, found {} coordinates", point.len()))),
            }
        }
        if sorted.is_empty() {
            return Err(Error::WrongShape("there is no point to enclose".into()));
        }
        sorted.sort();
        sorted.dedup();
        let mut lower = chain(sorted.iter());
        let mut upper = chain(sorted.iter().rev());
        // Each chain ends where the other begins.
        lower.pop();
        upper.pop();
        lower.append(&mut upper);
        if lower.is_empty() {
            lower = sorted;
        }
        Ok(Self { vertices: lower })
    }

    /// The corners, counter-clockwise from the leftmost (lowest) one; a
    /// degenerate hull has two or one.
    #[must_use]
    pub fn vertices(&self) -> &[[Rational; 2]] {
        &self.vertices
    }

    /// Whether a point lies in the hull, its border included.
    #[must_use]
    pub fn contains(&self, point: &[Rational; 2]) -> bool {
        match self.vertices.as_slice() {
            [] => false,
            [only] => only == point,
            [a, b] => turn(a, b, point) == 0.into() && (a.min(b)..=a.max(b)).contains(&point),
            vertices => vertices.iter().zip(vertices.iter().cycle().skip(1)).all(|(a, b)| !turn(a, b, point).is_negative()),
        }
    }
}

/// Twice the signed area of a triangle: positive for a left turn at `b`.
fn turn(a: &[Rational; 2], b: &[Rational; 2], c: &[Rational; 2]) -> Rational {
    (&b[0] - &a[0]) * (&c[1] - &a[1]) - (&b[1] - &a[1]) * (&c[0] - &a[0])
}

/// The part of the hull from the first point to the last, turning left throughout.
fn chain<'a>(points: impl Iterator<Item = &'a [Rational; 2]>) -> Vec<[Rational; 2]> {
    let mut chain: Vec<[Rational; 2]> = Vec::new();
    for point in points {
        while let [.., a, b] = chain.as_slice() {
            if turn(a, b, point).is_positive() {
                break;
            }
            chain.pop();
        }
        chain.push(point.clone());
    }
    chain
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn point(x: i64, y: i64) -> [Rational; 2] {
        [Rational::from(x), Rational::from(y)]
    }

    #[test]
    fn degenerate_hulls() {
        let hull = |points: &[[Rational; 2]]| ConvexHull::of(points.iter().map(<[Rational; 2]>::as_slice));
        assert_eq!(hull(&[point(1, 2), point(1, 2)]).map(|h| h.vertices().to_vec()), Ok(vec![point(1, 2)]));
        let line = hull(&[point(0, 0), point(2, 2), point(1, 1)]);
        assert_eq!(line.as_ref().map(|h| h.vertices().len()), Ok(2));
        assert_eq!(line.as_ref().map(|h| h.contains(&point(1, 1))), Ok(true));
        assert_eq!(line.as_ref().map(|h| h.contains(&point(3, 3))), Ok(false));
        assert_eq!(line.as_ref().map(|h| h.contains(&point(1, 0))), Ok(false));
        let vertical = hull(&[point(0, 0), point(0, 2)]);
        assert_eq!(vertical.map(|h| (h.contains(&point(0, 1)), h.contains(&point(0, 3)))), Ok((true, false)));
        assert!(hull(&[]).is_err());
    }

    proptest! {
        /// The slow twin: a point is outside iff some line through two points has it strictly alone on one side,
        /// or it is not between two of them where all are on one line.
        #[test]
        fn membership_by_all_pairs(points in prop::collection::vec((-3i64..4, -3i64..4), 1..7), probe in (-4i64..5, -4i64..5)) {
            let points: Vec<_> = points.into_iter().map(|(x, y)| point(x, y)).collect();
            let probe = point(probe.0, probe.1);
            let hull = ConvexHull::of(points.iter().map(<[Rational; 2]>::as_slice)).expect("points of the plane");
            let separated = points.iter().any(|a| points.iter().any(|b| {
                turn(a, b, &probe).is_negative() && points.iter().all(|c| !turn(a, b, c).is_negative())
            }));
            let flat = points.iter().all(|a| points.iter().all(|b| turn(a, b, &probe) == 0.into()));
            let inside = if flat {
                points.iter().any(|a| *a <= probe) && points.iter().any(|b| *b >= probe)
                    && (points.iter().any(|a| *a != points[0]) || points[0] == probe)
            } else {
                !separated
            };
            prop_assert_eq!(hull.contains(&probe), inside, "{:?} in {:?}", probe, hull);
            prop_assert!(points.iter().all(|p| hull.contains(p)));
        }
    }
}
