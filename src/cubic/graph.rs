//! Cubics in rotated coordinates, and those that are graphs in them.

use num_traits::{Signed, Zero};

use super::{Cubic, CubicClass, Vector, dot, is_zero};
use crate::exact::Rational;
use crate::name::display_by_name;

/// The coordinates `u = y3 x - x3 y` and `v = x3 x + y3 y` along the curve, a
/// rotation and stretch of the plane that makes `u` quadratic (CS348a, lecture
/// 6, section 2.2). With `(x2, y2)` in place of `(x3, y3)` for a quadratic, `u`
/// becomes linear (section 2.1).
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Rotated {
    /// The coefficients of `u(t)`, ascending.
    pub u: [Rational; 4],
    /// The coefficients of `v(t)`, ascending.
    pub v: [Rational; 4],
}

/// A curve as the graph `v = p(u)` of a polynomial in rotated coordinates.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Graph {
    /// The coordinates.
    pub rotated: Rotated,
    /// The coefficients of `p`, ascending: four, or three for a parabola.
    pub coefficients: Vec<Rational>,
}

/// How the coordinate `v` moves where an S-shaped cubic has its flex.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Direction {
    /// It grows, as it does far away.
    Increasing,
    /// Its derivative is zero.
    Still,
    /// It shrinks, against the direction far away.
    Decreasing,
}

impl Direction {
    /// The name in answers.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Increasing => "increasing",
            Self::Still => "still",
            Self::Decreasing => "decreasing",
        }
    }
}

display_by_name!(Direction);

impl Cubic {
    /// The coordinates that `F_3` turns; `None` if `F_3 = 0`.
    #[must_use]
    pub fn rotated(&self) -> Option<Rotated> {
        self.turned_by(3)
    }

    fn turned_by(&self, power: usize) -> Option<Rotated> {
        let turn: &Vector = &self.vectors()[power];
        if is_zero(turn) {
            return None;
        }
        let [x, y] = turn;
        Some(Rotated {
            u: self.vectors().each_ref().map(|vector| y * &vector[0] - x * &vector[1]),
            v: self.vectors().each_ref().map(|vector| dot(turn, vector)),
        })
    }

    /// An S-shaped cubic or a parabola as the graph of a polynomial over a
    /// straight line; `None` for other classes.
    #[must_use]
    pub fn graph(&self) -> Option<Graph> {
        let power = match self.class() {
            CubicClass::SShaped => 3,
            CubicClass::Parabolic => 2,
            CubicClass::Humpy | CubicClass::Loopy | CubicClass::Pointy | CubicClass::Straight => return None,
        };
        let rotated = self.turned_by(power)?;
        // u = u0 + u1 t, so t = (u - u0)/u1: put that into v by Horner's scheme.
        let slope = rotated.u[1].recip()?;
        let constant = -&rotated.u[0] * &slope;
        let mut coefficients = vec![Rational::zero(); power + 1];
        for next in rotated.v[..=power].iter().rev() {
            for k in (0..=power).rev() {
                let below = if k > 0 { &coefficients[k - 1] * &slope } else { next.clone() };
                coefficients[k] = &coefficients[k] * &constant + below;
            }
        }
        Some(Graph { rotated, coefficients })
    }

    /// How `v` moves at the flex of an S-shaped cubic; `None` for other classes.
    #[must_use]
    pub fn flex_motion(&self) -> Option<Direction> {
        if self.class() != CubicClass::SShaped {
            return None;
        }
        let [tangent, f3] = self.standing()?.columns;
        let speed = dot(&tangent, &f3);
        Some(if speed.is_positive() {
            Direction::Increasing
        } else if speed.is_negative() {
            Direction::Decreasing
        } else {
            Direction::Still
        })
    }

    /// Whether the coordinate `u` has a minimum at the summit, so that the curve
    /// opens to the side where `u` is large; `None` where `κ23 = 0`.
    #[must_use]
    pub fn opens_to_the_right(&self) -> Option<bool> {
        let kappa23 = self.invariants().kappa23;
        (!kappa23.is_zero()).then(|| kappa23.is_positive())
    }
}
