//! How far a cubic is from being of another class.

use num_traits::{Signed, Zero};

use super::{Branch, Cubic, CubicClass, Invariants};
use crate::error::Error;
use crate::exact::{Rational, Surd};
use crate::segment::Segment;

/// A move of one coordinate of one control point that changes the class.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ClassChange {
    /// The control point, counted from 0.
    pub point: usize,
    /// The coordinate, 0 for x and 1 for y.
    pub coordinate: usize,
    /// What is added to it.
    pub by: Surd,
    /// Whether the coordinate grows; what tells a direction apart where `by` is zero.
    pub grows: bool,
    /// The class that is reached.
    pub class: CubicClass,
    /// Whether this very move reaches it; else every move that is a little longer does.
    pub reached: bool,
}

/// The smallest move of a single coordinate of a control point that changes the class.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Distance {
    /// The class without a move.
    pub class: CubicClass,
    /// The degree of the polygon.
    pub degree: usize,
    /// The move; none if no single coordinate can change the class.
    pub change: Option<ClassChange>,
}

impl Distance {
    /// The length of the move.
    #[must_use]
    pub fn length(&self) -> Option<Surd> {
        self.change.as_ref().map(|change| change.by.abs())
    }
}

/// A polynomial of degree two at most in the length of a move, ascending.
type Quadratic = [Rational; 3];

/// The invariants as functions of a move.
struct Moved {
    kappa12: Quadratic,
    kappa23: Quadratic,
    kappa31: Quadratic,
    discriminant: Quadratic,
}

impl Moved {
    /// Moving a coordinate by `x` adds `x · weights` to that coordinate of the
    /// vectors `F_k`, so the determinants are affine in `x`.
    fn new(cubic: &Cubic, coordinate: usize, weights: &[Rational; 4]) -> Self {
        let Invariants { kappa12, kappa23, kappa31 } = cubic.invariants();
        let other = |power: usize| &cubic.vectors()[power][1 - coordinate];
        let slope = |i: usize, j: usize| {
            let slope = &weights[i] * other(j) - &weights[j] * other(i);
            if coordinate == 0 { slope } else { -slope }
        };
        let affine = |constant: Rational, slope: Rational| [constant, slope, Rational::zero()];
        let (kappa12, kappa23, kappa31) = (affine(kappa12, slope(1, 2)), affine(kappa23, slope(2, 3)), affine(kappa31, slope(3, 1)));
        let product = |p: &Quadratic, q: &Quadratic| [&p[0] * &q[0], &p[0] * &q[1] + &p[1] * &q[0], &p[1] * &q[1]];
        let (square, mixed) = (product(&kappa31, &kappa31), product(&kappa12, &kappa23));
        let discriminant = [0, 1, 2].map(|k| Rational::from(3) * &square[k] - Rational::from(4) * &mixed[k]);
        Self { kappa12, kappa23, kappa31, discriminant }
    }

    /// The class after a move.
    fn class(&self, by: &Surd) -> CubicClass {
        let sign = |polynomial: &Quadratic| by.evaluate(polynomial.iter()).signum().cmp(&0);
        let is_zero = |polynomial| sign(polynomial).is_eq();
        Branch::of(is_zero(&self.kappa23), || sign(&self.discriminant), || is_zero(&self.kappa31), || is_zero(&self.kappa12)).class()
    }

    /// The moves where the class may change.
    fn critical(&self) -> Vec<Surd> {
        let vanishes = |polynomial: &Quadratic| polynomial.iter().all(Zero::is_zero);
        let mut moves = roots(&self.kappa23);
        if !vanishes(&self.kappa23) {
            moves.extend(roots(&self.discriminant));
        } else if !vanishes(&self.kappa31) {
            moves.extend(roots(&self.kappa31));
        } else {
            moves.extend(roots(&self.kappa12));
        }
        moves
    }
}

/// The real roots of a polynomial that is not zero everywhere; of that one, none.
fn roots(polynomial: &Quadratic) -> Vec<Surd> {
    let [c, b, a] = polynomial;
    match (a.recip(), b.recip()) {
        (Some(inverse), _) => {
            let middle = b * &inverse * Rational::new(-1, 2);
            let square = &middle * &middle - c * inverse;
            [-1, 1].into_iter().filter_map(|sign| Surd::new(middle.clone(), sign, square.clone())).collect()
        }
        (None, Some(inverse)) => vec![Surd::from(-c * inverse)],
        (None, None) => Vec::new(),
    }
}

impl Cubic {
    /// The smallest move of one coordinate of one control point of a segment
    /// that changes the class of its curve.
    ///
    /// For a move of length `x` the invariants `κ` are affine in `x` and `D` is
    /// quadratic, so the answer is a number `a ± √d`. It is zero for the classes
    /// that almost any small move leaves.
    ///
    /// ```
    /// use casteljau::{Cubic, CubicClass, Interval, Rational, Segment, Surd};
    /// // With (0, 1) as the third point this has a cusp.
    /// let q = |n, d| Rational::new(n, d);
    /// let points = vec![q(0, 1), q(0, 1), q(1, 1), q(1, 1), q(0, 1), q(101, 100), q(1, 1), q(0, 1)];
    /// let distance = Cubic::distance(&Segment::new(2, points, Interval::unit())?)?;
    /// assert_eq!(distance.change.as_ref().map(|change| (change.class, change.reached)), Some((CubicClass::Pointy, true)));
    /// assert!(distance.length() <= Some(Surd::from(q(1, 100))));
    /// # Ok::<(), casteljau::Error>(())
    /// ```
    ///
    /// # Errors
    /// As for [`Cubic::new`]; [`Error::Unsupported`] for more than four control points.
    pub fn distance(segment: &Segment) -> Result<Distance, Error> {
        let cubic = Self::new(&segment.curve()?)?;
        let degree = segment.degree();
        if degree > 3 {
            return Err(Error::Unsupported(format!(
                "the distance to another class is that of a polygon of four points at most, found {}: `reduce` finds a shorter one",
                degree + 1
            )));
        }
        let class = cubic.class();
        let mut best: Option<ClassChange> = None;
        for point in 0..=degree {
            // The weights of the control point in the vectors F_k are the coefficients of its Bernstein polynomial.
            let influence = (0..=degree).map(|i| Rational::from(i64::from(i == point))).collect();
            let influence = Segment::new(1, influence, segment.frame().clone())?.curve()?;
            let weights = [0, 1, 2, 3].map(|power| if power <= degree { influence.vector(power)[0].clone() } else { Rational::zero() });
            for coordinate in 0..2 {
                let moved = Moved::new(&cubic, coordinate, &weights);
                for (grows, (by, new, reached)) in first_changes(&moved, class) {
                    if best.as_ref().is_none_or(|best| (by.abs(), !reached) < (best.by.abs(), !best.reached)) {
                        best = Some(ClassChange { point, coordinate, by, grows, class: new, reached });
                    }
                }
            }
        }
        Ok(Distance { class, degree, change: best })
    }
}

/// The first change of the class in either direction.
fn first_changes(moved: &Moved, class: CubicClass) -> Vec<(bool, (Surd, CubicClass, bool))> {
    let critical = moved.critical();
    let mut found = Vec::new();
    for direction in [1i64, -1] {
        // Measured along the direction, from zero on.
        let along = |surd: &Surd| surd.times_rational(&Rational::from(direction));
        let mut stops: Vec<Surd> = critical.iter().map(along).filter(|stop| stop.signum() >= 0).collect();
        stops.push(Surd::default());
        stops.sort();
        stops.dedup();
        for (index, stop) in stops.iter().enumerate() {
            let at = moved.class(&along(stop));
            if at != class {
                found.push((direction > 0, (along(stop), at, true)));
                break;
            }
            let beyond = match stops.get(index + 1) {
                Some(next) => Surd::between(stop, next),
                None => Some(stop.enclosure(1).1.abs() + Rational::from(1)),
            };
            let after = moved.class(&along(&Surd::from(beyond.unwrap_or_default())));
            if after != class {
                found.push((direction > 0, (along(stop), after, false)));
                break;
            }
        }
    }
    found
}
