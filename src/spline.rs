//! B-spline curves through blossoms.

use crate::affine::Interval;
use crate::continuity::{Continuity, continuity_of_curves};
use crate::error::Error;
use crate::exact::Rational;
use crate::segment::Segment;

/// A piecewise polynomial curve of degree `m`, given by knots `u_0 ≤ u_1 ≤ …`
/// and de Boor points: on every nonempty `[u_j, u_{j+1}]` the polar form `f_j`
/// of its piece has `d_i = f_j(u_{i+1}, …, u_{i+m})`, `j - m ≤ i ≤ j`
/// (Ramshaw, *Blossoming: A Connect-the-Dots Approach to Splines*, 1987).
///
/// ```
/// use casteljau::{Rational, Spline};
/// let q = |n| Rational::from(n);
/// let knots = [0, 0, 0, 1, 2, 2, 2].map(q).to_vec();
/// let points = [0, 2, 4, 2].map(|y| vec![q(y)]).to_vec();
/// let spline = Spline::new(2, knots, points)?;
/// let pieces = spline.pieces()?;
/// assert_eq!(pieces[0].point(2), [q(3)]);
/// assert_eq!(spline.insert(&Rational::new(1, 2))?.points().len(), 5);
/// # Ok::<(), casteljau::Error>(())
/// ```
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Spline {
    degree: usize,
    knots: Vec<Rational>,
    points: Vec<Vec<Rational>>,
}

/// Two pieces of a spline at their common knot.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct KnotJoin {
    /// The knot.
    pub knot: Rational,
    /// How often it is listed.
    pub multiplicity: usize,
    /// The order of continuity that was found. The multiplicity `μ` promises `m - μ`.
    pub order: Continuity,
}

/// A knot in a message, where a number of many digits is of no use.
fn shown(knot: &Rational) -> String {
    let text = knot.to_string();
    if text.len() <= 40 { text } else { format!("a number of {} letters", text.len()) }
}

impl Spline {
    /// The most work, in steps on machine words, for all the pieces of a spline.
    pub const MAX_STEPS: u64 = 1 << 30;

    /// The spline with these knots and de Boor points.
    ///
    /// # Errors
    /// [`Error::WrongCount`] unless there are `m + 1` more knots than points;
    /// [`Error::WrongShape`] for fewer than `m + 1` points, points of different
    /// dimensions, knots that fall, one that is listed more than `m + 1` times,
    /// or no interval between the knots `u_m` and `u_n`; [`Error::TooLarge`]
    /// where the pieces take more than [`Spline::MAX_STEPS`].
    pub fn new(degree: usize, knots: Vec<Rational>, points: Vec<Vec<Rational>>) -> Result<Self, Error> {
        Self::within(Self::MAX_STEPS, degree, knots, points)
    }

    /// The spline, if its pieces take at most so many steps.
    pub(crate) fn within(limit: u64, degree: usize, knots: Vec<Rational>, points: Vec<Vec<Rational>>) -> Result<Self, Error> {
        let dimension = points.first().map_or(0, Vec::len);
        if points.len() <= degree || dimension == 0 || points.iter().any(|point| point.len() != dimension) {
            return Err(Error::WrongShape(format!(
                "a spline of degree {degree} needs at least {} points, all with the same number of coordinates; found {}",
                degree + 1,
                points.len()
            )));
        }
        if knots.len() != points.len() + degree + 1 {
            return Err(Error::WrongCount { what: "knots", expected: points.len() + degree + 1, found: knots.len() });
        }
        if let Some(place) = knots.windows(2).position(|pair| pair[0] > pair[1]) {
            return Err(Error::WrongShape(format!(
                "the knots must not fall: {} stands before {}",
                shown(&knots[place]),
                shown(&knots[place + 1])
            )));
        }
        if let Some(window) = knots.windows(degree + 2).find(|window| window[0] == window[degree + 1]) {
            return Err(Error::WrongShape(format!(
                "the knot {} is listed {} times, which no spline of degree {degree} has",
                shown(&window[0]),
                knots.iter().filter(|knot| **knot == window[0]).count()
            )));
        }
        let spline = Self { degree, knots, points };
        if spline.intervals().next().is_none() {
            return Err(Error::WrongShape("there is no interval between the knots u_m and u_n".into()));
        }
        if spline.steps() > limit {
            return Err(Error::TooLarge { what: "work for the pieces of a spline, counted in steps,", limit: limit as usize });
        }
        Ok(spline)
    }

    /// What the pieces cost.
    pub(crate) fn steps(&self) -> u64 {
        let longest = |numbers: &mut dyn Iterator<Item = &Rational>| numbers.map(Rational::bits).max().unwrap_or(0);
        let bits = (longest(&mut self.points.iter().flatten()), longest(&mut self.knots.iter()));
        piece_steps(self.degree, self.points[0].len(), bits).saturating_mul(self.intervals().count() as u64)
    }

    /// The degree `m`.
    #[must_use]
    pub fn degree(&self) -> usize {
        self.degree
    }

    /// The knots.
    #[must_use]
    pub fn knots(&self) -> &[Rational] {
        &self.knots
    }

    /// The de Boor points.
    #[must_use]
    pub fn points(&self) -> &[Vec<Rational>] {
        &self.points
    }

    /// The places `j` of the nonempty intervals `[u_j, u_{j+1}]`.
    fn intervals(&self) -> impl DoubleEndedIterator<Item = usize> {
        (self.degree..self.points.len()).filter(|&j| self.knots[j] < self.knots[j + 1])
    }

    /// The polar value of the piece on `[u_j, u_{j+1}]`: one step of de Boor's
    /// algorithm for each argument.
    fn polar_value(&self, j: usize, arguments: &[&Rational]) -> Vec<Rational> {
        let m = self.degree;
        let mut layer: Vec<Vec<Rational>> = self.points[j - m..=j].to_vec();
        for (step, x) in (1..=m).zip(arguments) {
            layer = (j - m + step..=j)
                .map(|i| {
                    // Both knots stand around the interval, so they differ.
                    let (low, high) = (&self.knots[i], &self.knots[i + m + 1 - step]);
                    let part = (*x - low) / (high - low);
                    let place = i - (j - m + step);
                    layer[place].iter().zip(&layer[place + 1]).map(|(a, b)| a + (b - a) * &part).collect()
                })
                .collect();
        }
        layer.swap_remove(0)
    }

    /// The Bézier pieces, one for every nonempty interval: their control points
    /// are `f_j(u_j^{m-i} u_{j+1}^i)`.
    ///
    /// # Errors
    /// None. The ends of a nonempty interval differ, and [`Spline::new`] saw to
    /// it that all points have as many coordinates.
    pub fn pieces(&self) -> Result<Vec<Segment>, Error> {
        let piece = |j: usize| {
            let (low, high) = (&self.knots[j], &self.knots[j + 1]);
            let point = |i: usize| {
                let arguments: Vec<&Rational> = std::iter::repeat_n(low, self.degree - i).chain(std::iter::repeat_n(high, i)).collect();
                self.polar_value(j, &arguments)
            };
            Segment::from_points((0..=self.degree).map(point).collect(), Interval::new(low.clone(), high.clone())?)
        };
        self.intervals().map(piece).collect()
    }

    /// The orders of continuity at the knots between pieces.
    ///
    /// # Errors
    /// None, as for [`Spline::pieces`]: all pieces have as many coordinates, and
    /// frames of numbers.
    pub fn joins(&self) -> Result<Vec<KnotJoin>, Error> {
        let pieces = self.pieces()?;
        let join = |pair: &[Segment]| {
            let knot = pair[1].frame().r().clone();
            let order = continuity_of_curves(&pair[0].curve()?, &pair[1].curve()?, &knot)?;
            Ok(KnotJoin { multiplicity: self.knots.iter().filter(|other| **other == knot).count(), order, knot })
        };
        pieces.windows(2).map(join).collect()
    }

    /// The same curve with one more knot (W. Boehm, "Inserting new knots into
    /// B-spline curves", 1980): the new points are the polar values at the new knots.
    ///
    /// # Errors
    /// [`Error::WrongShape`] if the knot lies outside of the curve's parameters,
    /// or is listed `m + 1` times already.
    pub fn insert(&self, knot: &Rational) -> Result<Self, Error> {
        let m = self.degree;
        let inside = |j: &usize| self.knots[*j] <= *knot && *knot <= self.knots[j + 1];
        let Some(k) = self.intervals().rev().find(inside) else {
            let (low, high) = (&self.knots[m], &self.knots[self.points.len()]);
            return Err(Error::WrongShape(format!("the knot {} lies outside of {}..{}", shown(knot), shown(low), shown(high))));
        };
        let points = (0..=self.points.len()).map(|i| {
            if i + m <= k {
                return self.points[i].clone();
            }
            if i > k {
                return self.points[i - 1].clone();
            }
            let (low, high) = (&self.knots[i], &self.knots[i + m]);
            let part = (knot - low) / (high - low);
            self.points[i - 1].iter().zip(&self.points[i]).map(|(a, b)| a + (b - a) * &part).collect()
        });
        let points = points.collect();
        let mut knots = self.knots.clone();
        knots.insert(k + 1, knot.clone());
        Self::new(m, knots, points)
    }
}

/// What the points of one piece cost, given the bits of control points and of
/// parameters: for each of them the algorithm of de Boor or de Casteljau, whose
/// numbers lengthen by those of the parameters at each of its `m` levels;
/// lowest terms make a step quadratic in the length.
pub(crate) fn piece_steps(degree: usize, dimension: usize, (points, parameters): (u64, u64)) -> u64 {
    let levels = degree as u64 + 1;
    let words = (points + 4 * degree as u64 * parameters) / 64 + 16;
    [levels, levels, dimension as u64, words, words].into_iter().fold(levels, u64::saturating_mul)
}
