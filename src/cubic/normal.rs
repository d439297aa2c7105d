//! Normal forms: the standard cubics, and the maps that carry them to others.

use num_traits::{One, Signed, Zero};

use super::special::Centred;
use super::{Cubic, CubicClass, Vector, det, scaled};
use crate::exact::{Rational, Surd};

impl CubicClass {
    /// The coefficients of the standard cubic of the class, one list a
    /// coordinate in ascending powers: `(r², r³ + r)` is humpy, `(r², r³ - r)`
    /// loopy, `(r², r³)` pointy, `(r, r³)` S-shaped, `(r, r²)` parabolic. There
    /// is none for straight curves, which fall into several kinds.
    #[must_use]
    pub fn standard(self) -> Option<[[i64; 4]; 2]> {
        match self {
            Self::Humpy => Some([[0, 0, 1, 0], [0, 1, 0, 1]]),
            Self::Loopy => Some([[0, 0, 1, 0], [0, -1, 0, 1]]),
            Self::Pointy => Some([[0, 0, 1, 0], [0, 0, 0, 1]]),
            Self::SShaped => Some([[0, 1, 0, 0], [0, 0, 0, 1]]),
            Self::Parabolic => Some([[0, 1, 0, 0], [0, 0, 1, 0]]),
            Self::Straight => None,
        }
    }

    /// The standard cubic of the class.
    #[must_use]
    pub fn standard_cubic(self) -> Option<Cubic> {
        let [x, y] = self.standard()?;
        Some(Cubic::from_vectors([0, 1, 2, 3].map(|power| [Rational::from(x[power]), Rational::from(y[power])])))
    }
}

/// The maps that carry the standard cubic of a class to a cubic `F`:
/// `F(t0 + scale · r) = matrix · standard(r) + shift` for all `r`.
///
/// For humpy and loopy cubics the numbers lie in the field of `√|D|` and are
/// unique up to `r → -r`; for the others they are rational.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct NormalForm {
    /// The class.
    pub form: CubicClass,
    /// The parameter that 0 is carried to.
    pub t0: Surd,
    /// The stretch of the parameter line.
    pub scale: Surd,
    /// The linear part of the map of the plane, by rows.
    pub matrix: [[Surd; 2]; 2],
    /// The image of the origin.
    pub shift: [Surd; 2],
}

/// The rational form of a cubic: coordinates `X` and `Y` of the plane, affine
/// functions of `x` and `y`, in which the curve has a short equation.
///
/// With `κ23 ≠ 0` it is `Y² = X (X + c)²` (parametrized by `X = τ²`,
/// `Y = τ³ + c τ`, so that `t = t* + Y/(X + c)` away from the double point);
/// for an S-shaped cubic `Y = X³`, for a parabola `Y = X²`. No roots occur.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct SemiNormalForm {
    /// The class.
    pub form: CubicClass,
    /// `X = a x + b y + d` as `[a, b, d]`.
    pub x: [Rational; 3],
    /// `Y = a x + b y + d` as `[a, b, d]`.
    pub y: [Rational; 3],
    /// The constant of `Y² = X (X + c)²`; 0 for the other equations.
    pub c: Rational,
    /// The parameter of the point with `X = Y = 0`.
    pub t0: Rational,
}

/// A parameter and an affine frame of the plane in which the class has its standard shape.
pub(super) struct Standing {
    pub(super) t0: Rational,
    pub(super) origin: Vector,
    pub(super) columns: [Vector; 2],
    pub(super) c: Rational,
}

impl Cubic {
    /// The frame that goes with the class; `None` for straight curves.
    pub(super) fn standing(&self) -> Option<Standing> {
        if let Some(Centred { t, g0, g2, f3, c, .. }) = Centred::of(self) {
            return Some(Standing { t0: t, origin: g0, columns: [g2, f3], c });
        }
        let [f0, f1, f2, f3] = self.vectors();
        match self.class() {
            CubicClass::SShaped => {
                let invariants = self.invariants();
                let t = invariants.kappa12.checked_div(&(Rational::from(3) * invariants.kappa31))?;
                let tangent = super::pair(self.curve().derivative(1).value(&t));
                Some(Standing { origin: self.rational_point(&t), t0: t, columns: [tangent, f3.clone()], c: Rational::zero() })
            }
            CubicClass::Parabolic => {
                Some(Standing { t0: Rational::zero(), origin: f0.clone(), columns: [f1.clone(), f2.clone()], c: Rational::zero() })
            }
            CubicClass::Humpy | CubicClass::Loopy | CubicClass::Pointy | CubicClass::Straight => None,
        }
    }

    /// The maps that carry the standard cubic here, checked as an identity of
    /// polynomials; `None` for straight curves.
    #[must_use]
    pub fn normal_form(&self) -> Option<NormalForm> {
        let Standing { t0, origin, columns: [u, v], c } = self.standing()?;
        let (form, size) = (self.class(), c.abs());
        let (scale, [u, v]) = if c.is_zero() {
            (Surd::from(Rational::one()), [u, v].map(|column| column.map(Surd::from)))
        } else {
            let root = Surd::root(&size)?;
            let v = [root.times_rational(&(&size * &v[0])), root.times_rational(&(&size * &v[1]))];
            (root, [scaled(&size, &u).map(Surd::from), v])
        };
        let ([a, c], [b, d]) = (u, v);
        let normal = NormalForm { form, t0: Surd::from(t0), scale, matrix: [[a, b], [c, d]], shift: origin.map(Surd::from) };
        normal.carries_to(self).then_some(normal)
    }

    /// The rational form, checked as an identity of polynomials; `None` for straight curves.
    #[must_use]
    pub fn semi_normal_form(&self) -> Option<SemiNormalForm> {
        let Standing { t0, origin, columns: [u, v], c } = self.standing()?;
        let inverse = det(&u, &v).recip()?;
        // P = origin + X u + Y v
        let functional = |a: Rational, b: Rational| {
            let offset = -(&a * &origin[0] + &b * &origin[1]);
            [a, b, offset]
        };
        let x = functional(&v[1] * &inverse, -&v[0] * &inverse);
        let y = functional(-&u[1] * &inverse, &u[0] * &inverse);
        let form = SemiNormalForm { form: self.class(), x, y, c, t0 };
        form.holds_on(self).then_some(form)
    }
}

/// The coefficients of `F(t0 + τ)` in `τ`: derivatives over factorials.
pub(super) fn taylor(cubic: &Cubic, t0: &Rational) -> [Vector; 4] {
    let curve = cubic.curve();
    [(0, 1), (1, 1), (2, 2), (3, 6)].map(|(order, factorial)| {
        let value = super::pair(curve.derivative(order).value(t0));
        if factorial == 1 { value } else { scaled(&Rational::new(1, factorial), &value) }
    })
}

impl NormalForm {
    /// Whether `F(t0 + scale · r) = matrix · standard(r) + shift` holds for all `r`.
    #[must_use]
    pub fn carries_to(&self, cubic: &Cubic) -> bool {
        self.identity(cubic).unwrap_or(false)
    }

    fn identity(&self, cubic: &Cubic) -> Option<bool> {
        let standard = self.form.standard()?;
        let coefficients = taylor(cubic, self.t0.as_rational()?);
        // The square of the stretch is rational, so its powers are cheap.
        let square = self.scale.times(&self.scale)?;
        let square = square.as_rational()?;
        let powers = [Surd::from(Rational::one()), self.scale.clone(), Surd::from(square), self.scale.times_rational(square)];
        for (k, (vector, power)) in coefficients.iter().zip(&powers).enumerate() {
            for (index, row) in self.matrix.iter().enumerate() {
                let mut right = if k == 0 { self.shift[index].clone() } else { Surd::default() };
                for (entry, list) in row.iter().zip(&standard) {
                    right = match list[k] {
                        0 => right,
                        1 => right.plus(entry)?,
                        other => right.plus(&entry.times_rational(&Rational::from(other)))?,
                    };
                }
                if power.times_rational(&vector[index]) != right {
                    return Some(false);
                }
            }
        }
        Some(true)
    }
}

impl SemiNormalForm {
    /// The value of `X` or `Y` at a point.
    fn value(functional: &[Rational; 3], point: &Vector) -> Rational {
        &functional[0] * &point[0] + &functional[1] * &point[1] + &functional[2]
    }

    /// Whether the curve satisfies the equation with the parametrization that belongs to it.
    #[must_use]
    pub fn holds_on(&self, cubic: &Cubic) -> bool {
        let coefficients = taylor(cubic, &self.t0);
        let along = |functional: &[Rational; 3]| {
            [0, 1, 2, 3].map(|k| {
                let vector = &coefficients[k];
                let linear = &functional[0] * &vector[0] + &functional[1] * &vector[1];
                if k == 0 { linear + &functional[2] } else { linear }
            })
        };
        let q = Rational::from;
        let (x, y) = match self.form {
            CubicClass::Humpy | CubicClass::Loopy | CubicClass::Pointy => ([q(0), q(0), q(1), q(0)], [q(0), self.c.clone(), q(0), q(1)]),
            CubicClass::SShaped => ([q(0), q(1), q(0), q(0)], [q(0), q(0), q(0), q(1)]),
            CubicClass::Parabolic => ([q(0), q(1), q(0), q(0)], [q(0), q(0), q(1), q(0)]),
            CubicClass::Straight => return false,
        };
        along(&self.x) == x && along(&self.y) == y
    }

    /// The parameter of a point of the curve; `None` for a point that is not on
    /// it, and for its double point, which has two or none.
    #[must_use]
    pub fn parameter(&self, point: &Vector) -> Option<Rational> {
        let (x, y) = (Self::value(&self.x, point), Self::value(&self.y, point));
        let tau = match self.form {
            CubicClass::Humpy | CubicClass::Loopy | CubicClass::Pointy => {
                let sum = &x + &self.c;
                (&y * &y == &x * &sum * &sum).then(|| y.checked_div(&sum)).flatten()?
            }
            CubicClass::SShaped => (y == &x * &x * &x).then_some(x)?,
            CubicClass::Parabolic => (y == &x * &x).then_some(x)?,
            CubicClass::Straight => return None,
        };
        Some(&self.t0 + tau)
    }
}
