//! Cubics whose image is straight.

use num_traits::{Signed, Zero};

use super::{Cubic, Vector, is_zero};
use crate::affine::{Interval, Place};
use crate::exact::{Rational, Surd};
use crate::name::display_by_name;

/// What a straight parametrization runs through.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Image {
    /// The whole line.
    Line,
    /// A ray, every point but its end twice.
    Ray,
    /// A single point.
    Point,
}

impl Image {
    /// The name in answers for machines.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Line => "line",
            Self::Ray => "ray",
            Self::Point => "point",
        }
    }
}

display_by_name!(Image);

/// A straight curve: `F(t) = F(0) + p(t) · direction` with a polynomial `p`
/// that has no constant term and leading coefficient 1.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Straight {
    /// The degree of `p`, 0 for a curve that is one point.
    pub degree: usize,
    /// The point `F(0)`.
    pub start: Vector,
    /// The direction; none for a point.
    pub direction: Option<Vector>,
    /// The coefficients of `p` in ascending powers, four of them; none for a point.
    pub profile: Option<[Rational; 4]>,
    /// The parameters where the point turns back, in ascending order.
    pub turns: Vec<Surd>,
    /// What the whole curve covers.
    pub image: Image,
}

impl Straight {
    /// The description of a curve whose three vectors are parallel.
    pub(super) fn of(cubic: &Cubic) -> Self {
        let vectors = cubic.vectors();
        let (degree, start) = (cubic.true_degree(), vectors[0].clone());
        if degree == 0 {
            return Self { degree, start, direction: None, profile: None, turns: Vec::new(), image: Image::Point };
        }
        let direction = vectors[degree].clone();
        // Every vector is this multiple of the direction, read off a coordinate where it is not zero.
        let axis = usize::from(direction[0].is_zero());
        let part = |power: usize| vectors[power][axis].checked_div(&direction[axis]).unwrap_or_default();
        let profile = [Rational::zero(), part(1), part(2), part(3)];
        let turns = turns(&profile, degree);
        let image = if degree == 2 { Image::Ray } else { Image::Line };
        Self { degree, start, direction: Some(direction), profile: Some(profile), turns, image }
    }

    /// The value of `p` at a parameter; 0 for a point.
    #[must_use]
    pub fn profile_at(&self, t: &Surd) -> Surd {
        self.profile.as_ref().map_or_else(Surd::default, |profile| t.evaluate(profile.iter()))
    }

    /// The smallest and the largest value of `p` on a frame: the image of the
    /// segment reaches from `F(0) + low · direction` to `F(0) + high · direction`.
    #[must_use]
    pub fn range(&self, frame: &Interval) -> (Surd, Surd) {
        let inside = self.turns.iter().filter(|turn| super::portion::place(turn, frame) == Place::Inside).cloned();
        let parameters = [frame.r(), frame.s()].map(Surd::from).into_iter().chain(inside);
        let values: Vec<Surd> = parameters.map(|t| self.profile_at(&t)).collect();
        let low = values.iter().min().cloned().unwrap_or_default();
        let high = values.into_iter().max().unwrap_or_default();
        (low, high)
    }

    /// The point `F(0) + value · direction`.
    #[must_use]
    pub fn point(&self, value: &Surd) -> [Surd; 2] {
        let zero = Vector::default();
        let direction = self.direction.as_ref().unwrap_or(&zero);
        [0, 1].map(|index| value.times_rational(&direction[index]).plus_rational(&self.start[index]))
    }
}

/// The roots of `p'` where it changes its sign.
fn turns(profile: &[Rational; 4], degree: usize) -> Vec<Surd> {
    let [_, one, two, _] = profile;
    match degree {
        // t² + b t turns at -b/2.
        2 => vec![Surd::from(one * Rational::new(-1, 2))],
        // 3 t² + 2 b t + a
        3 => {
            let square = (two * two - Rational::from(3) * one) * Rational::new(1, 9);
            if !square.is_positive() {
                return Vec::new();
            }
            let middle = two * Rational::new(-1, 3);
            [-1, 1].into_iter().filter_map(|sign| Surd::new(middle.clone(), sign, square.clone())).collect()
        }
        _ => Vec::new(),
    }
}

impl Cubic {
    /// Whether the whole curve is one point.
    #[must_use]
    pub fn is_point(&self) -> bool {
        self.vectors()[1..].iter().all(is_zero)
    }
}
