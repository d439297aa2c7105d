//! Planar cubics: what kind they are, and where their special points lie.
//!
//! Every cubic curve of the plane is affinely equivalent to one of six
//! (CS348a, lecture 6, section 2.2): humpy, loopy, pointy, S-shaped, parabolic,
//! straight. Which one is decided by the signs of four numbers, so the answer
//! is exact for exact input.

mod array;
mod class;
mod distance;
mod equivalence;
mod family;
mod flexes;
mod graph;
mod intended;
mod invariants;
mod normal;
mod portion;
mod special;
mod straight;

pub use array::{classify_array, classify_rationals};
pub use class::{Branch, CubicClass};
pub use distance::{ClassChange, Distance};
pub use equivalence::Equivalence;
pub use family::{Breakpoint, Family};
pub use graph::{Direction, Graph, Rotated};
pub use intended::{Intention, Replacement};
pub use invariants::Invariants;
pub use normal::{NormalForm, SemiNormalForm};
pub(crate) use portion::place_name;
pub use portion::{Feature, Portion, PortionShape};
pub use special::{MedianLine, Special, SpecialPoint};
pub use straight::{Image, Straight};

use num_traits::Zero;

use crate::curve::Curve;
use crate::error::Error;
use crate::exact::{Rational, Surd};

/// A vector or a point of the plane.
pub(crate) type Vector = [Rational; 2];

/// A curve of the plane of degree three at most, `F_0 + F_1 t + F_2 t² + F_3 t³`.
///
/// ```
/// use casteljau::{Cubic, CubicClass, Curve, Rational, Surd};
/// // (t^2, t^3 - t) crosses itself in (1, 0).
/// let q = Rational::from;
/// let curve = Curve::new(vec![vec![q(0), q(0), q(1)], vec![q(0), q(-1), q(0), q(1)]])?;
/// let cubic = Cubic::new(&curve)?;
/// assert_eq!(cubic.class(), CubicClass::Loopy);
/// assert_eq!(cubic.invariants().discriminant(), q(-4));
/// let special = cubic.special_points();
/// assert_eq!(special.double_point(), Some(&[q(1), q(0)]));
/// assert_eq!(special.crunode_parameters(), [Surd::from(q(-1)), Surd::from(q(1))]);
/// # Ok::<(), casteljau::Error>(())
/// ```
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Cubic {
    /// `F_0` to `F_3`.
    vectors: [Vector; 4],
}

impl Cubic {
    /// The cubic that a curve is.
    ///
    /// # Errors
    /// [`Error::Unsupported`] for a curve that is not in the plane, or of a degree above three.
    pub fn new(curve: &Curve) -> Result<Self, Error> {
        check(curve.dimension(), curve.true_degree())?;
        let vector = |power: usize| match curve.vector(power) {
            [x, y] => [x.clone(), y.clone()],
            _ => Vector::default(),
        };
        Ok(Self { vectors: [0, 1, 2, 3].map(|power| if power <= curve.degree() { vector(power) } else { Vector::default() }) })
    }

    /// The cubic with these coefficient vectors `F_0, …, F_3`.
    #[must_use]
    pub fn from_vectors(vectors: [Vector; 4]) -> Self {
        Self { vectors }
    }

    /// The coefficient vectors `F_0, …, F_3`.
    #[must_use]
    pub fn vectors(&self) -> &[Vector; 4] {
        &self.vectors
    }

    /// The cubic as a curve of polar degree three.
    #[must_use]
    pub fn curve(&self) -> Curve {
        Curve::from_vectors(2, self.vectors.iter().flatten().cloned().collect())
    }

    /// The largest degree of the coordinates.
    #[must_use]
    pub fn true_degree(&self) -> usize {
        (1..4).rev().find(|&power| self.vectors[power].iter().any(|c| !c.is_zero())).unwrap_or(0)
    }

    /// The coefficients of a coordinate, in ascending powers.
    pub(crate) fn coordinate(&self, index: usize) -> impl DoubleEndedIterator<Item = &Rational> + Clone {
        self.vectors.iter().map(move |vector| &vector[index])
    }

    /// The point at a parameter.
    #[must_use]
    pub fn point(&self, t: &Surd) -> [Surd; 2] {
        [0, 1].map(|index| t.evaluate(self.coordinate(index)))
    }

    /// The point at a rational parameter.
    #[must_use]
    pub fn rational_point(&self, t: &Rational) -> Vector {
        pair(self.curve().value(t))
    }

    /// The invariants that decide the class.
    #[must_use]
    pub fn invariants(&self) -> Invariants {
        let [_, one, two, three] = &self.vectors;
        Invariants { kappa12: det(one, two), kappa23: det(two, three), kappa31: det(three, one) }
    }

    /// The class of the whole curve.
    #[must_use]
    pub fn class(&self) -> CubicClass {
        self.invariants().class()
    }
}

/// The two coordinates of a point of the plane.
pub(crate) fn pair(coordinates: Vec<Rational>) -> Vector {
    let mut coordinates = coordinates.into_iter();
    [coordinates.next().unwrap_or_default(), coordinates.next().unwrap_or_default()]
}

/// Refuses what is no planar cubic, with what is possible instead.
pub(crate) fn check(dimension: usize, true_degree: usize) -> Result<(), Error> {
    if dimension != 2 {
        let remedy = match dimension {
            1 => "the graph of a function of t is the curve (t, F(t))",
            _ => "`transform` projects a curve into the plane, as with --map '(x, y)'",
        };
        return Err(Error::Unsupported(format!("planar cubics have two coordinates, this curve has {dimension}: {remedy}")));
    }
    if true_degree > 3 {
        return Err(Error::Unsupported(format!(
            "planar cubics have degree three at most, this curve has degree {true_degree}: `implicit` gives the equation of a plane \
             curve of any degree"
        )));
    }
    Ok(())
}

/// The determinant of two vectors.
pub(crate) fn det(a: &Vector, b: &Vector) -> Rational {
    &a[0] * &b[1] - &a[1] * &b[0]
}

/// The scalar product of two vectors.
pub(crate) fn dot(a: &Vector, b: &Vector) -> Rational {
    &a[0] * &b[0] + &a[1] * &b[1]
}

/// The vector `a + k b`.
pub(crate) fn along(a: &Vector, k: &Rational, b: &Vector) -> Vector {
    [&a[0] + k * &b[0], &a[1] + k * &b[1]]
}

/// A multiple of a vector.
pub(crate) fn scaled(k: &Rational, a: &Vector) -> Vector {
    [k * &a[0], k * &a[1]]
}

pub(crate) fn is_zero(a: &Vector) -> bool {
    a.iter().all(Zero::is_zero)
}
