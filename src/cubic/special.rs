//! The special points of a planar cubic.

use num_traits::{Signed, Zero};

use super::{Cubic, CubicClass, Straight, Vector, along, det, dot};
use crate::exact::{Rational, Surd};

/// A point of the curve with its parameter.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct SpecialPoint {
    /// The parameter.
    pub t: Surd,
    /// The point.
    pub point: [Surd; 2],
}

/// A line by a point and a direction.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct MedianLine {
    /// A point of it, the summit.
    pub point: Vector,
    /// Its direction, `G_2`.
    pub direction: Vector,
    /// The common direction `F_3` of the chords that it halves.
    pub chord: Vector,
}

/// The special points of a planar cubic, by its class (CS348a, lecture 6,
/// section 2.2).
///
/// Where `κ23 ≠ 0`, the curve is `F(t* + τ) = G_0 + G_2 τ² + F_3 (τ³ + c τ)`
/// with the summit `G_0` at `t* = κ31/(2 κ23)`, `G_2 = F_2 + 3 F_3 t*` and
/// `c = D/(4 κ23²)`; the double point is `G_0 - c G_2` always, a rational point.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Special {
    /// Two flexes, the summit between them, and the isolated double point.
    Humpy {
        /// The summit.
        summit: SpecialPoint,
        /// The line through the middles of the chords that are parallel to `F_3`.
        median: MedianLine,
        /// The flexes, the smaller parameter first.
        flexes: [SpecialPoint; 2],
        /// The double point, which belongs to no real parameter.
        acnode: Vector,
    },
    /// The point that the curve runs through twice.
    Loopy {
        /// The summit.
        summit: SpecialPoint,
        /// The line through the middles of the chords that are parallel to `F_3`.
        median: MedianLine,
        /// The two parameters, the smaller one first.
        parameters: [Surd; 2],
        /// The crunode.
        crunode: Vector,
    },
    /// The cusp, which is the summit.
    Pointy {
        /// The cusp.
        cusp: SpecialPoint,
        /// The tangent there.
        median: MedianLine,
    },
    /// The flex, which is the centre of symmetry.
    SShaped {
        /// The flex.
        flex: SpecialPoint,
    },
    /// The vertex of the parabola.
    Parabolic {
        /// The point of largest curvature.
        vertex: SpecialPoint,
    },
    /// Where the point turns back on its line.
    Straight(Straight),
}

/// The numbers that all cubics with `κ23 ≠ 0` share.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Centred {
    pub(super) t: Rational,
    pub(super) g0: Vector,
    pub(super) g2: Vector,
    pub(super) f3: Vector,
    pub(super) kappa23: Rational,
    /// `D / (4 κ23²)`
    pub(super) c: Rational,
}

impl Centred {
    /// `None` where `κ23 = 0`.
    pub(super) fn of(cubic: &Cubic) -> Option<Self> {
        let invariants = cubic.invariants();
        let half = invariants.kappa23.recip()? * Rational::new(1, 2);
        let t = &invariants.kappa31 * &half;
        let c = invariants.discriminant() * &half * &half;
        let [_, _, f2, f3] = cubic.vectors();
        let g2 = along(f2, &(Rational::from(3) * &t), f3);
        Some(Self { g0: cubic.rational_point(&t), g2, f3: f3.clone(), t, c, kappa23: invariants.kappa23 })
    }

    /// The double point.
    pub(super) fn double_point(&self) -> Vector {
        along(&self.g0, &-&self.c, &self.g2)
    }

    fn summit(&self) -> SpecialPoint {
        SpecialPoint { t: Surd::from(&self.t), point: self.g0.each_ref().map(Surd::from) }
    }

    fn median(&self) -> MedianLine {
        MedianLine { point: self.g0.clone(), direction: self.g2.clone(), chord: self.f3.clone() }
    }

    /// The flex at `t* ± √third`, where `τ³ + c τ` is four times `third τ`:
    /// `G_0 + third G_2 ± 4 third √third F_3`.
    fn flex(&self, t: &Surd, third: &Rational) -> [Surd; 2] {
        let root = t.plus_rational(&-&self.t);
        let along = Rational::from(4) * third;
        [0, 1].map(|index| root.times_rational(&(&along * &self.f3[index])).plus_rational(&(&self.g0[index] + third * &self.g2[index])))
    }

    /// The two parameters `t* ± √square`.
    fn around(&self, square: &Rational) -> [Surd; 2] {
        let number = |sign: i8| Surd::new(self.t.clone(), sign, square.clone()).unwrap_or_default();
        [number(-1), number(1)]
    }
}

impl Cubic {
    /// The special points of the curve.
    #[must_use]
    pub fn special_points(&self) -> Special {
        let Some(centred) = Centred::of(self) else { return self.special_points_at_infinity() };
        let (summit, median) = (centred.summit(), centred.median());
        if centred.c.is_zero() {
            return Special::Pointy { cusp: summit, median };
        }
        if centred.c.is_negative() {
            let parameters = centred.around(&-&centred.c);
            return Special::Loopy { summit, median, parameters, crunode: centred.double_point() };
        }
        // κ12 - 3 κ31 t + 3 κ23 t² = 3 κ23 (τ² - c/3)
        let third = &centred.c * Rational::new(1, 3);
        let flexes = centred.around(&third).map(|t| SpecialPoint { point: centred.flex(&t, &third), t });
        Special::Humpy { summit, median, flexes, acnode: centred.double_point() }
    }

    /// Those of a curve with `κ23 = 0`.
    fn special_points_at_infinity(&self) -> Special {
        let invariants = self.invariants();
        let [_, f1, f2, f3] = self.vectors();
        let at = |t: Rational| SpecialPoint { point: self.rational_point(&t).map(Surd::from), t: Surd::from(t) };
        if let Some(inverse) = (&invariants.kappa31 * Rational::from(3)).recip() {
            return Special::SShaped { flex: at(invariants.kappa12 * inverse) };
        }
        // A parabola has F_3 = 0 and F_2 ≠ 0. Its vertex is where F' and F'' are orthogonal.
        let parabola = !invariants.kappa12.is_zero() && super::is_zero(f3);
        match (dot(f2, f2) * Rational::from(-2)).recip().filter(|_| parabola) {
            Some(inverse) => Special::Parabolic { vertex: at(dot(f1, f2) * inverse) },
            None => Special::Straight(Straight::of(self)),
        }
    }
}

impl Special {
    /// The class of the curve.
    #[must_use]
    pub fn class(&self) -> CubicClass {
        match self {
            Self::Humpy { .. } => CubicClass::Humpy,
            Self::Loopy { .. } => CubicClass::Loopy,
            Self::Pointy { .. } => CubicClass::Pointy,
            Self::SShaped { .. } => CubicClass::SShaped,
            Self::Parabolic { .. } => CubicClass::Parabolic,
            Self::Straight(_) => CubicClass::Straight,
        }
    }

    /// The flexes, by ascending parameters.
    #[must_use]
    pub fn flexes(&self) -> &[SpecialPoint] {
        match self {
            Self::Humpy { flexes, .. } => flexes,
            Self::SShaped { flex } => std::slice::from_ref(flex),
            Self::Loopy { .. } | Self::Pointy { .. } | Self::Parabolic { .. } | Self::Straight(_) => &[],
        }
    }

    /// The summit, where the tangent is parallel to the chords `F_3`; for a pointy cubic it is the cusp.
    #[must_use]
    pub fn summit(&self) -> Option<&SpecialPoint> {
        match self {
            Self::Humpy { summit, .. } | Self::Loopy { summit, .. } => Some(summit),
            Self::Pointy { cusp, .. } => Some(cusp),
            Self::SShaped { .. } | Self::Parabolic { .. } | Self::Straight(_) => None,
        }
    }

    /// The line through the summit that halves the chords parallel to `F_3`.
    #[must_use]
    pub fn median(&self) -> Option<&MedianLine> {
        match self {
            Self::Humpy { median, .. } | Self::Loopy { median, .. } | Self::Pointy { median, .. } => Some(median),
            Self::SShaped { .. } | Self::Parabolic { .. } | Self::Straight(_) => None,
        }
    }

    /// The acnode or the crunode.
    #[must_use]
    pub fn double_point(&self) -> Option<&Vector> {
        match self {
            Self::Humpy { acnode, .. } => Some(acnode),
            Self::Loopy { crunode, .. } => Some(crunode),
            Self::Pointy { .. } | Self::SShaped { .. } | Self::Parabolic { .. } | Self::Straight(_) => None,
        }
    }

    /// The two parameters of the crunode, the smaller one first; of other curves none.
    #[must_use]
    pub fn crunode_parameters(&self) -> &[Surd] {
        match self {
            Self::Loopy { parameters, .. } => parameters,
            Self::Humpy { .. } | Self::Pointy { .. } | Self::SShaped { .. } | Self::Parabolic { .. } | Self::Straight(_) => &[],
        }
    }

    /// The cusp.
    #[must_use]
    pub fn cusp(&self) -> Option<&SpecialPoint> {
        match self {
            Self::Pointy { cusp, .. } => Some(cusp),
            Self::Humpy { .. } | Self::Loopy { .. } | Self::SShaped { .. } | Self::Parabolic { .. } | Self::Straight(_) => None,
        }
    }
}

impl Cubic {
    /// The area inside the loop of a loopy cubic, `(8/15) e^{5/2} |κ23|` with `e = -c`.
    #[must_use]
    pub fn loop_area(&self) -> Option<Surd> {
        let centred = Centred::of(self).filter(|centred| centred.c.is_negative())?;
        let e = -&centred.c;
        Surd::with_factor(Rational::zero(), &(Rational::new(8, 15) * &e * &e * centred.kappa23.abs()), &e)
    }

    /// The two tangent directions in the crunode, `± 2 √e G_2 + 2 e F_3`, in the order of its parameters.
    #[must_use]
    pub fn crunode_tangents(&self) -> Option<[[Surd; 2]; 2]> {
        let centred = Centred::of(self).filter(|centred| centred.c.is_negative())?;
        let e = -&centred.c;
        let tangent = |sign: i64| -> Option<[Surd; 2]> {
            let entry = |index: usize| {
                Surd::with_factor(Rational::from(2) * &e * &centred.f3[index], &(Rational::from(2 * sign) * &centred.g2[index]), &e)
            };
            Some([entry(0)?, entry(1)?])
        };
        Some([tangent(-1)?, tangent(1)?])
    }

    /// Half the cross product of the first two derivatives,
    /// `κ12 - 3 κ31 t + 3 κ23 t²`, in ascending powers: zero at the flexes.
    #[must_use]
    pub fn flex_polynomial(&self) -> [Rational; 3] {
        let [_, f1, f2, f3] = self.vectors();
        [det(f1, f2), Rational::from(3) * det(f1, f3), Rational::from(3) * det(f2, f3)]
    }
}
