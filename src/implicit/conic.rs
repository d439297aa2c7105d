//! Types of conics.

use num_traits::{Signed, Zero};

use super::ImplicitCurve;
use crate::exact::Rational;
use crate::name::display_by_name;

/// The affine type of `A x² + B x y + C y² + D x + E y + F = 0`, not all of
/// `A`, `B`, `C` zero.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum ConicType {
    /// An ellipse.
    Ellipse,
    /// An ellipse without real points.
    ImaginaryEllipse,
    /// A point, where two conjugate lines meet.
    Point,
    /// A hyperbola.
    Hyperbola,
    /// Two lines that meet.
    CrossingLines,
    /// A parabola.
    Parabola,
    /// Two parallel lines.
    ParallelLines,
    /// Two parallel lines without real points.
    ImaginaryLines,
    /// One line, counted twice.
    DoubleLine,
}

impl ConicType {
    /// The name in answers.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Ellipse => "ellipse",
            Self::ImaginaryEllipse => "imaginary_ellipse",
            Self::Point => "point",
            Self::Hyperbola => "hyperbola",
            Self::CrossingLines => "crossing_lines",
            Self::Parabola => "parabola",
            Self::ParallelLines => "parallel_lines",
            Self::ImaginaryLines => "imaginary_lines",
            Self::DoubleLine => "double_line",
        }
    }

    /// The type of the conic with the coefficients `[A, B, C, D, E, F]`; `None`
    /// where `A = B = C = 0`, which is no conic.
    ///
    /// ```
    /// use casteljau::{ConicType, Rational};
    /// let parabola = [1, 0, 0, 0, -1, 0].map(Rational::from); // x² - y
    /// assert_eq!(ConicType::of(&parabola), Some(ConicType::Parabola));
    /// ```
    #[must_use]
    pub fn of(coefficients: &[Rational; 6]) -> Option<Self> {
        let [a, b, c, d, e, f] = coefficients;
        if a.is_zero() && b.is_zero() && c.is_zero() {
            return None;
        }
        let four = Rational::from(4);
        let at_infinity = b * b - &four * a * c;
        // Four times the determinant of the symmetric 3×3 matrix.
        let determinant = &four * a * c * f + b * d * e - a * e * e - c * d * d - f * b * b;
        Some(match (at_infinity.is_zero(), determinant.is_zero()) {
            (false, true) if at_infinity.is_negative() => Self::Point,
            (false, true) => Self::CrossingLines,
            (false, false) if at_infinity.is_positive() => Self::Hyperbola,
            // An ellipse has real points if its matrix is indefinite.
            (false, false) if (determinant * (a + c)).is_negative() => Self::Ellipse,
            (false, false) => Self::ImaginaryEllipse,
            (true, false) => Self::Parabola,
            (true, true) => {
                let apart = d * d + e * e - &four * (a + c) * f;
                if apart.is_zero() {
                    Self::DoubleLine
                } else if apart.is_positive() {
                    Self::ParallelLines
                } else {
                    Self::ImaginaryLines
                }
            }
        })
    }
}

display_by_name!(ConicType);

impl ImplicitCurve {
    /// The type of the conic; `None` for a curve of another degree.
    #[must_use]
    pub fn conic_type(&self) -> Option<ConicType> {
        if self.degree() != 2 {
            return None;
        }
        let coefficient = |i: usize, j: usize| {
            let term = self.terms.iter().find(|term| (term.0, term.1) == (i, j));
            term.map_or_else(Rational::zero, |term| Rational::from(term.2.clone()))
        };
        let [a, b, c, d, e, f] = [(2, 0), (1, 1), (0, 2), (1, 0), (0, 1), (0, 0)].map(|(i, j)| coefficient(i, j));
        ConicType::of(&[a, b, c, d, e, f])
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn all_types_and_their_affine_images() {
        for (coefficients, expected) in [
            ([1, 0, 1, 0, 0, -1], ConicType::Ellipse),
            ([1, 0, 1, 0, 0, 1], ConicType::ImaginaryEllipse),
            ([1, 0, 1, 0, 0, 0], ConicType::Point),
            ([1, 0, -1, 0, 0, -1], ConicType::Hyperbola),
            ([0, 1, 0, 0, 0, 1], ConicType::Hyperbola),
            ([0, 1, 0, 0, 0, 0], ConicType::CrossingLines),
            ([1, 0, 0, 0, -1, 0], ConicType::Parabola),
            ([0, 0, 1, 0, 0, -1], ConicType::ParallelLines),
            ([1, 0, 0, 0, 0, 1], ConicType::ImaginaryLines),
            ([1, 2, 1, 0, 0, 0], ConicType::DoubleLine),
        ] {
            let [a, b, c, d, e, f] = coefficients;
            // x → 2x + 3y + 1, y → x - y + 2
            let moved = [
                4 * a + 2 * b + c,
                12 * a + b - 2 * c,
                9 * a - 3 * b + c,
                4 * a + 4 * b + b + 4 * c + 2 * d + e,
                6 * a + 6 * b - b - 4 * c + 3 * d - e,
                a + 2 * b + 4 * c + d + 2 * e + f,
            ];
            for list in [coefficients, moved, moved.map(|number| -number)] {
                assert_eq!(ConicType::of(&list.map(Rational::from)), Some(expected), "{list:?}");
            }
        }
        assert_eq!(ConicType::of(&[0, 0, 0, 1, 0, 0].map(Rational::from)), None);
    }
}
