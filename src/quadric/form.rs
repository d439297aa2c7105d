//! The affine types of quadrics.

use num_traits::{Signed, Zero};

use crate::exact::Rational;
use crate::name::display_by_name;

/// What a polynomial surface is, as a set of points.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum QuadricClass {
    /// An ellipsoid.
    Ellipsoid,
    /// An ellipsoid without real points.
    ImaginaryEllipsoid,
    /// A hyperboloid of one sheet.
    HyperboloidOneSheet,
    /// A hyperboloid of two sheets.
    HyperboloidTwoSheets,
    /// A cone.
    Cone,
    /// A cone with its vertex as the only real point.
    ImaginaryCone,
    /// An elliptic paraboloid.
    EllipticParaboloid,
    /// A hyperbolic paraboloid.
    HyperbolicParaboloid,
    /// An elliptic cylinder.
    EllipticCylinder,
    /// An elliptic cylinder without real points.
    ImaginaryEllipticCylinder,
    /// A hyperbolic cylinder.
    HyperbolicCylinder,
    /// A parabolic cylinder.
    ParabolicCylinder,
    /// Two planes, or one counted twice.
    PlanePair,
    /// In a plane.
    Plane,
    /// In a line.
    Line,
    /// A point.
    Point,
    /// A curve that is not in a plane.
    Curve,
    /// In no quadric.
    NotAQuadric,
}

impl QuadricClass {
    /// The name in answers.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Ellipsoid => "ellipsoid",
            Self::ImaginaryEllipsoid => "imaginary_ellipsoid",
            Self::HyperboloidOneSheet => "hyperboloid_one_sheet",
            Self::HyperboloidTwoSheets => "hyperboloid_two_sheets",
            Self::Cone => "cone",
            Self::ImaginaryCone => "imaginary_cone",
            Self::EllipticParaboloid => "elliptic_paraboloid",
            Self::HyperbolicParaboloid => "hyperbolic_paraboloid",
            Self::EllipticCylinder => "elliptic_cylinder",
            Self::ImaginaryEllipticCylinder => "imaginary_elliptic_cylinder",
            Self::HyperbolicCylinder => "hyperbolic_cylinder",
            Self::ParabolicCylinder => "parabolic_cylinder",
            Self::PlanePair => "plane_pair",
            Self::Plane => "plane",
            Self::Line => "line",
            Self::Point => "point",
            Self::Curve => "curve",
            Self::NotAQuadric => "not_a_quadric",
        }
    }

    /// The type of the quadric with these coefficients, by
    /// [`QUADRIC_MONOMIALS`](super::QUADRIC_MONOMIALS): from the ranks and
    /// signatures of its quadratic part and of its whole symmetric matrix.
    #[must_use]
    pub fn of(coefficients: &[Rational; 10]) -> Self {
        let half = Rational::new(1, 2);
        let [one, x, y, z, xx, xy, xz, yy, yz, zz] = coefficients;
        let halved = |value: &Rational| value * &half;
        let matrix = [
            vec![xx.clone(), halved(xy), halved(xz), halved(x)],
            vec![halved(xy), yy.clone(), halved(yz), halved(y)],
            vec![halved(xz), halved(yz), zz.clone(), halved(z)],
            vec![halved(x), halved(y), halved(z), one.clone()],
        ];
        let quadratic: Vec<Vec<Rational>> = matrix[..3].iter().map(|row| row[..3].to_vec()).collect();
        let ((r3, s3), (r4, s4)) = (rank_and_signature(quadratic), rank_and_signature(matrix.to_vec()));
        match (r3, r4, s3, s4) {
            (3, 4, 3, 2) => Self::Ellipsoid,
            (3, 4, 3, _) => Self::ImaginaryEllipsoid,
            (3, 4, _, 0) => Self::HyperboloidOneSheet,
            (3, 4, _, _) => Self::HyperboloidTwoSheets,
            (3, 3, 1, _) => Self::Cone,
            (3, 3, _, _) => Self::ImaginaryCone,
            (2, 4, 2, _) => Self::EllipticParaboloid,
            (2, 4, _, _) => Self::HyperbolicParaboloid,
            (2, 3, 2, 1) => Self::EllipticCylinder,
            (2, 3, 2, _) => Self::ImaginaryEllipticCylinder,
            (2, 3, _, _) => Self::HyperbolicCylinder,
            (1, 3, _, _) => Self::ParabolicCylinder,
            (0, _, _, _) => Self::Plane,
            _ => Self::PlanePair,
        }
    }
}

display_by_name!(QuadricClass);

/// The rank of a symmetric matrix, and how many more of its squares have one
/// sign than the other, by congruences (symmetric elimination).
fn rank_and_signature(mut matrix: Vec<Vec<Rational>>) -> (usize, usize) {
    let size = matrix.len();
    let (mut rank, mut positive) = (0, 0usize);
    let mut open: Vec<usize> = (0..size).collect();
    loop {
        let mut pivot = open.iter().copied().find(|&i| !matrix[i][i].is_zero());
        if pivot.is_none() {
            // With zeros on the diagonal, adding one variable to another makes a square.
            let mixed = open.iter().flat_map(|&i| open.iter().map(move |&j| (i, j))).find(|&(i, j)| !matrix[i][j].is_zero());
            let Some((i, j)) = mixed else { break };
            let row = matrix[j].clone();
            matrix[i].iter_mut().zip(&row).for_each(|(a, b)| *a += b);
            for line in &mut matrix {
                let entry = line[j].clone();
                line[i] += entry;
            }
            pivot = Some(i);
        }
        let Some(pivot) = pivot else { break };
        rank += 1;
        positive += usize::from(matrix[pivot][pivot].is_positive());
        open.retain(|&i| i != pivot);
        let row = matrix[pivot].clone();
        let inverse = row[pivot].recip().unwrap_or_default();
        for &i in &open {
            let factor = &matrix[i][pivot] * &inverse;
            for &j in &open {
                let change = &factor * &row[j];
                matrix[i][j] -= change;
            }
        }
        for &i in &open {
            matrix[i][pivot] = Rational::zero();
            matrix[pivot][i] = Rational::zero();
        }
    }
    (rank, (2 * positive).abs_diff(rank))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The quadric after `x → x + 2y - z + 1`, `y → y - 3x + 2`, `z → z + x + y`.
    fn moved(coefficients: [i64; 10]) -> [Rational; 10] {
        // Rows: the new 1, x, y, z as combinations of the old ones.
        let images = [[1, 0, 0, 0], [1, 1, 2, -1], [2, -3, 1, 0], [0, 1, 1, 1]];
        let mut sums = [[0i64; 4]; 4];
        for (c, (i, j)) in coefficients.iter().zip(super::super::FACTORS) {
            for (a, x) in images[i].iter().enumerate() {
                for (b, y) in images[j].iter().enumerate() {
                    sums[a.min(b)][a.max(b)] += c * x * y;
                }
            }
        }
        super::super::FACTORS.map(|(i, j)| Rational::from(sums[i][j]))
    }

    #[test]
    fn all_types_and_their_affine_images() {
        // 1, x, y, z, x², xy, xz, y², yz, z²
        for (coefficients, expected) in [
            ([-1, 0, 0, 0, 1, 0, 0, 1, 0, 1], QuadricClass::Ellipsoid),
            ([1, 0, 0, 0, 1, 0, 0, 1, 0, 1], QuadricClass::ImaginaryEllipsoid),
            ([-1, 0, 0, 0, 1, 0, 0, 1, 0, -1], QuadricClass::HyperboloidOneSheet),
            ([1, 0, 0, 0, 1, 0, 0, 1, 0, -1], QuadricClass::HyperboloidTwoSheets),
            ([0, 0, 0, 0, 1, 0, 0, 1, 0, -1], QuadricClass::Cone),
            ([0, 0, 0, 0, 0, 0, 1, -1, 0, 0], QuadricClass::Cone),
            ([0, 0, 0, 0, 1, 0, 0, 1, 0, 1], QuadricClass::ImaginaryCone),
            ([0, 0, 0, -1, 1, 0, 0, 1, 0, 0], QuadricClass::EllipticParaboloid),
            ([0, 0, 0, -1, 0, 1, 0, 0, 0, 0], QuadricClass::HyperbolicParaboloid),
            ([-1, 0, 0, 0, 1, 0, 0, 1, 0, 0], QuadricClass::EllipticCylinder),
            ([1, 0, 0, 0, 1, 0, 0, 1, 0, 0], QuadricClass::ImaginaryEllipticCylinder),
            ([1, 0, 0, 0, 0, 0, 0, 0, 1, 0], QuadricClass::HyperbolicCylinder),
            ([0, 0, -1, 0, 1, 0, 0, 0, 0, 0], QuadricClass::ParabolicCylinder),
            ([0, 0, 0, 0, 0, 1, 0, 0, 0, 0], QuadricClass::PlanePair),
            ([1, 0, 0, 0, 1, 0, 0, 0, 0, 0], QuadricClass::PlanePair),
            ([0, 0, 0, 0, 1, 0, 0, 0, 0, 0], QuadricClass::PlanePair),
            ([0, 1, 0, 0, 0, 0, 0, 0, 0, 0], QuadricClass::Plane),
        ] {
            assert_eq!(QuadricClass::of(&coefficients.map(Rational::from)), expected, "{coefficients:?}");
            assert_eq!(QuadricClass::of(&moved(coefficients)), expected, "the image of {coefficients:?}");
            let negative = moved(coefficients).map(|c| -c);
            assert_eq!(QuadricClass::of(&negative), expected, "the negative image of {coefficients:?}");
        }
    }
}
