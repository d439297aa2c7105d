//! Frames of the parameter plane.

use std::fmt;

use super::{PlaneParameter, Weights};
use crate::error::Error;
use crate::exact::Rational;
use crate::kernel::coefficient::Coefficient;

/// A frame `(r, s, t)` of the parameter plane: three points that are not on one
/// line, in either orientation.
///
/// ```
/// use casteljau::{Rational, Triangle};
/// let point = |u: i64, v: i64| [Rational::from(u), Rational::from(v)];
/// let frame = Triangle::new(point(1, 0), point(0, 1), point(0, 0))?;
/// assert_eq!(frame.barycentric(&point(2, 3))?, [2, 3, -4].map(Rational::from));
/// assert!(Triangle::new(point(0, 0), point(1, 2), point(2, 4)).is_err());
/// # Ok::<(), casteljau::Error>(())
/// ```
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Triangle<C = Rational> {
    vertices: [[C; 2]; 3],
}

/// Where a point lies in a frame.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Place {
    /// On a vertex.
    Vertex,
    /// On an edge or end, between vertices.
    Edge,
    /// Off all edges.
    Inside,
    /// Beyond an edge or end.
    Outside,
}

impl<C: Coefficient> Triangle<C> {
    /// The frame with these vertices.
    ///
    /// # Errors
    /// [`Error::DegenerateFrame`] if they are on one line.
    pub fn new(r: [C; 2], s: [C; 2], t: [C; 2]) -> Result<Self, Error> {
        let triangle = Self { vertices: [r, s, t] };
        if triangle.determinant().is_nothing() {
            return Err(Error::DegenerateFrame(format!(
                "the frame {triangle} is degenerate: its vertices lie on one line, and must not (either orientation will do)"
            )));
        }
        Ok(triangle)
    }

    /// The standard frame `r = (1,0)`, `s = (0,1)`, `t = (0,0)`, in which the
    /// first two barycentric coordinates are the parameters.
    #[must_use]
    pub fn standard() -> Self {
        let (zero, one) = (C::nothing, C::unit);
        Self { vertices: [[one(), zero()], [zero(), one()], [zero(), zero()]] }
    }

    /// The same frame with its vertices brought into another ring.
    pub(crate) fn map<D: Coefficient, E>(&self, number: &mut impl FnMut(&C) -> Result<D, E>) -> Result<Triangle<D>, E> {
        let mut point = |[u, v]: &[C; 2]| Ok([number(u)?, number(v)?]);
        let [r, s, t] = &self.vertices;
        Ok(Triangle { vertices: [point(r)?, point(s)?, point(t)?] })
    }

    /// The vertices `r`, `s`, `t`.
    #[must_use]
    pub fn vertices(&self) -> &[[C; 2]; 3] {
        &self.vertices
    }

    /// The first vertex.
    #[must_use]
    pub fn r(&self) -> &[C; 2] {
        &self.vertices[0]
    }

    /// The second vertex.
    #[must_use]
    pub fn s(&self) -> &[C; 2] {
        &self.vertices[1]
    }

    /// The third vertex.
    #[must_use]
    pub fn t(&self) -> &[C; 2] {
        &self.vertices[2]
    }

    /// Twice the signed area: positive where `r`, `s`, `t` turn to the left.
    #[must_use]
    pub fn determinant(&self) -> C {
        let [r, s, t] = &self.vertices;
        cross(&difference(s, r), &difference(t, r))
    }

    /// The barycentric coordinates `(λ, μ, ν)` of a point: `λ r + μ s + ν t`,
    /// with sum 1 (Gallier, *Curves and Surfaces in Geometric Modeling*, section 19.2).
    ///
    /// # Errors
    /// [`Error::Unsupported`] if the area of the frame is symbolic.
    pub fn barycentric(&self, point: &[C; 2]) -> Result<[C; 3], Error> {
        self.coordinates(&PlaneParameter::point(point.clone()))
    }

    /// The coordinates of a homogeneous argument; their sum is its weight.
    ///
    /// # Errors
    /// [`Error::Unsupported`] if the area of the frame is symbolic.
    pub fn coordinates(&self, argument: &PlaneParameter<C>) -> Result<[C; 3], Error> {
        let PlaneParameter { u, v, w } = argument;
        let determinant = self.determinant();
        // Relative to t, the argument is a vector of the plane.
        let [r, s, t] = &self.vertices;
        let vector = [u.minus(&w.times(&t[0])), v.minus(&w.times(&t[1]))];
        let (to_r, to_s) = (difference(r, t), difference(s, t));
        let share = |numerator: C| {
            numerator.over(&determinant).ok_or_else(|| {
                Error::Unsupported(format!("dividing by {determinant} needs a number: give the frame {self} numeric vertices"))
            })
        };
        let lambda = share(cross(&vector, &to_s))?;
        let mu = share(cross(&to_r, &vector))?;
        let nu = w.minus(&lambda).minus(&mu);
        Ok([lambda, mu, nu])
    }

    /// Arguments as combinations of the vertices in the order of the kernel: t, r, s.
    pub(crate) fn weights(&self, arguments: &[PlaneParameter<C>]) -> Result<Weights<C>, Error> {
        let mut weights = Weights::default();
        for argument in arguments {
            let [lambda, mu, nu] = self.coordinates(argument)?;
            weights.push(&[nu, lambda, mu]);
        }
        Ok(weights)
    }

    /// The vertices t, r, s as points of the plane.
    pub(crate) fn points(&self) -> [PlaneParameter<C>; 3] {
        let [r, s, t] = &self.vertices;
        [t, r, s].map(|vertex| PlaneParameter::point(vertex.clone()))
    }

    /// The point with barycentric coordinates in this frame.
    #[must_use]
    pub fn at(&self, barycentric: &[C; 3]) -> [C; 2] {
        [0, 1].map(|axis| {
            self.vertices.iter().zip(barycentric).fold(C::nothing(), |mut sum, (vertex, weight)| {
                sum.add_product(&vertex[axis], weight);
                sum
            })
        })
    }
}

impl Triangle {
    /// Where a point of the parameter plane lies.
    #[must_use]
    pub fn place(&self, point: &[Rational; 2]) -> Place {
        // The area of a frame of numbers is a number, so the coordinates exist.
        let Ok(coordinates) = self.barycentric(point) else { return Place::Outside };
        if coordinates.iter().any(num_traits::Signed::is_negative) {
            return Place::Outside;
        }
        match coordinates.iter().filter(|coordinate| num_traits::Zero::is_zero(*coordinate)).count() {
            0 => Place::Inside,
            1 => Place::Edge,
            _ => Place::Vertex,
        }
    }
}

fn difference<C: Coefficient>(a: &[C; 2], b: &[C; 2]) -> [C; 2] {
    [a[0].minus(&b[0]), a[1].minus(&b[1])]
}

fn cross<C: Coefficient>(a: &[C; 2], b: &[C; 2]) -> C {
    a[0].times(&b[1]).minus(&a[1].times(&b[0]))
}

impl<C: fmt::Display> fmt::Display for Triangle<C> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let [r, s, t] = &self.vertices;
        write!(f, "({},{}) ({},{}) ({},{})", r[0], r[1], s[0], s[1], t[0], t[1])
    }
}
