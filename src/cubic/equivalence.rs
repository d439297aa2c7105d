//! Whether one cubic is the affine image of another.

use num_traits::{One, Signed, Zero};

use super::normal::taylor;
use super::{Cubic, CubicClass, Vector};
use crate::exact::{Rational, Surd};

/// The maps that carry one cubic `F` to another `G`:
/// `G(t) = matrix · F(t0 + scale · (t - t1)) + shift` for all `t`.
///
/// Two cubics that are not straight are equivalent over the reals exactly if
/// they have one class (CS348a, lecture 6, section 2.2). The maps lie in one
/// field `Q(√(c/c'))`; they are rational exactly if `c/c'` is a square.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Equivalence {
    /// The parameter of `F` that belongs to `t1`.
    pub t0: Rational,
    /// The parameter of `G` that belongs to `t0`.
    pub t1: Rational,
    /// The stretch of the parameter line.
    pub scale: Surd,
    /// The linear part of the map of the plane, by rows.
    pub matrix: [[Surd; 2]; 2],
    /// The image of the origin.
    pub shift: [Surd; 2],
}

/// A cubic in a frame of its own: `F(t0 + τ) = origin + u · columns[0] + v · columns[1]`
/// with `u` and `v` that are the same for all equivalent cubics once `τ` is
/// stretched by `α` and the columns by `α^exponents`.
struct Posture {
    t0: Rational,
    origin: Vector,
    columns: [Vector; 2],
    exponents: [u32; 2],
    /// What the square of the stretch is the ratio of; 0 where any stretch will do.
    c: Rational,
}

impl Cubic {
    fn posture(&self) -> Posture {
        let class = self.class();
        if let Some(standing) = self.standing() {
            let exponents = match class {
                CubicClass::SShaped => [1, 3],
                CubicClass::Parabolic => [1, 2],
                CubicClass::Humpy | CubicClass::Loopy | CubicClass::Pointy | CubicClass::Straight => [2, 3],
            };
            return Posture { t0: standing.t0, origin: standing.origin, columns: standing.columns, exponents, c: standing.c };
        }
        let degree = self.true_degree();
        let direction = self.vectors()[degree].clone();
        let (mut t0, mut c) = (Rational::zero(), Rational::zero());
        let axis = usize::from(direction[0].is_zero());
        let part = |vector: &Vector| vector[axis].checked_div(&direction[axis]).unwrap_or_default();
        if degree >= 2 {
            // Without the term below the leading one.
            t0 = -part(&self.vectors()[degree - 1]) * Rational::new(1, degree as i64);
        }
        if degree == 3 {
            c = part(&taylor(self, &t0)[1]);
        }
        let columns = if degree == 0 {
            [[Rational::one(), Rational::zero()], [Rational::zero(), Rational::one()]]
        } else {
            let across = [-&direction[1], direction[0].clone()];
            [direction, across]
        };
        Posture { origin: self.rational_point(&t0), t0, columns, exponents: [degree as u32, 0], c }
    }

    /// The maps that carry this cubic to another, checked as an identity; `None` if there are none.
    ///
    /// ```
    /// use casteljau::{Cubic, CubicClass, Rational, Surd};
    /// let humpy = CubicClass::Humpy.standard_cubic().ok_or("a standard cubic")?;
    /// // (t^2, t^3 + 2 t): the maps need √2.
    /// let mut vectors = humpy.vectors().clone();
    /// vectors[1] = [Rational::from(0), Rational::from(2)];
    /// let maps = humpy.equivalence(&Cubic::from_vectors(vectors)).ok_or("one class")?;
    /// assert_eq!(Some(maps.scale), Surd::root(&Rational::new(1, 2)));
    /// # Ok::<(), &str>(())
    /// ```
    #[must_use]
    pub fn equivalence(&self, other: &Self) -> Option<Equivalence> {
        if self.class() != other.class() || (self.class() == CubicClass::Straight && self.true_degree() != other.true_degree()) {
            return None;
        }
        let (from, to) = (self.posture(), other.posture());
        let ratio = match (from.c.is_zero(), to.c.is_zero()) {
            (true, true) => Rational::one(),
            (false, false) => to.c.checked_div(&from.c)?,
            _ => return None,
        };
        if ratio.is_negative() {
            return None;
        }
        // The stretch is √(c/c'), its inverse √(c'/c).
        let inverse_power = |exponent: u32| {
            let half = ratio.pow(exponent / 2);
            if exponent.is_multiple_of(2) { Some(Surd::from(half)) } else { Surd::with_factor(Rational::zero(), &half, &ratio) }
        };
        let [u, v] = &from.columns;
        let inverse = super::det(u, v).recip()?;
        let rows = [[&v[1] * &inverse, -&v[0] * &inverse], [-&u[1] * &inverse, &u[0] * &inverse]];
        let powers = [inverse_power(from.exponents[0])?, inverse_power(from.exponents[1])?];
        let entry = |i: usize, j: usize| {
            let terms = [0, 1].map(|k| powers[k].times_rational(&(&to.columns[k][i] * &rows[k][j])));
            terms[0].plus(&terms[1])
        };
        let matrix = [[entry(0, 0)?, entry(0, 1)?], [entry(1, 0)?, entry(1, 1)?]];
        let image = apply(&matrix, &from.origin)?;
        let shift = [0, 1].map(|i| (-&image[i]).plus_rational(&to.origin[i]));
        let maps = Equivalence { t0: from.t0, t1: to.t0, scale: Surd::root(&ratio.recip()?)?, matrix, shift };
        maps.carries(self, other).then_some(maps)
    }
}

fn apply(matrix: &[[Surd; 2]; 2], point: &Vector) -> Option<[Surd; 2]> {
    let row = |row: &[Surd; 2]| row[0].times_rational(&point[0]).plus(&row[1].times_rational(&point[1]));
    Some([row(&matrix[0])?, row(&matrix[1])?])
}

impl Equivalence {
    /// Whether the maps carry one cubic to the other, for every parameter.
    #[must_use]
    pub fn carries(&self, from: &Cubic, to: &Cubic) -> bool {
        self.identity(from, to).unwrap_or(false)
    }

    fn identity(&self, from: &Cubic, to: &Cubic) -> Option<bool> {
        let (from, to) = (taylor(from, &self.t0), taylor(to, &self.t1));
        let mut power = Surd::from(Rational::one());
        for (k, (source, target)) in from.iter().zip(&to).enumerate() {
            let image = apply(&self.matrix, source)?;
            for index in 0..2 {
                let mut value = image[index].times(&power)?;
                if k == 0 {
                    value = value.plus(&self.shift[index])?;
                }
                if value.as_rational() != Some(&target[index]) {
                    return Some(false);
                }
            }
            power = power.times(&self.scale)?;
        }
        Some(true)
    }

    /// Whether all numbers are rational.
    #[must_use]
    pub fn is_rational(&self) -> bool {
        self.scale.as_rational().is_some()
    }
}

impl Cubic {
    /// In a sentence, why two cubics between which there are no such maps have none.
    #[must_use]
    pub fn difference(&self, other: &Self) -> String {
        let (one, two) = (self.class(), other.class());
        if one != two {
            return format!("one is {one}, the other {two}");
        }
        let (one, two) = (self.true_degree(), other.true_degree());
        if one != two {
            return format!("both are straight, one parametrized in degree {one}, the other in degree {two}");
        }
        "both are straight and run through a line in degree three, but do not turn back equally often".to_owned()
    }
}
