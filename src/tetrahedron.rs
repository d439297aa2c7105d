//! The tetrahedron of polar values of de Casteljau's algorithm on a triangle.

use crate::affine::{PlaneParameter, Triangle};
use crate::control::ControlNet;
use crate::error::Error;
use crate::exact::Rational;
use crate::kernel::coefficient::Coefficient;
use crate::scheme::{polar_label, remaining};
use crate::triangular::TriangularPatch;

/// All polar values `b^l_ijk = f(a^l r^i s^j t^k)` of a triangular patch at one
/// point `a`, `i + j + k = m - l`: layer 0 is the net, layer `m` the point `F(a)`
/// (Gallier, *Curves and Surfaces in Geometric Modeling*, section 19.4).
///
/// ```
/// use casteljau::{Rational, Triangle, TriangularPatch};
/// let points = [0, 2, 8].map(|z| vec![Rational::from(z)]).to_vec(); // f(t), f(s), f(r)
/// let patch = TriangularPatch::from_points(points, Triangle::standard())?;
/// let scheme = patch.scheme(&[Rational::new(1, 4), Rational::new(1, 2)])?;
/// assert_eq!(scheme.label(1, 0, 0), "f(a)");
/// assert_eq!(scheme.point(), [Rational::from(3)]);
/// # Ok::<(), casteljau::Error>(())
/// ```
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct TriangularScheme<C = Rational> {
    /// A net with vertices t, a, r, s.
    net: ControlNet<C>,
    frame: Triangle<C>,
    parameter: [C; 2],
    barycentric: [C; 3],
}

impl<C: Coefficient> TriangularScheme<C> {
    pub(crate) fn of(patch: &TriangularPatch<C>, a: &[C; 2]) -> Result<Self, Error> {
        let frame = patch.frame().clone();
        let weights = frame.weights(&[PlaneParameter::point(a.clone())])?;
        let barycentric = frame.barycentric(a)?;
        Ok(Self { net: patch.net().scheme(0, &weights), frame, parameter: a.clone(), barycentric })
    }

    /// The degree `m`.
    #[must_use]
    pub fn degree(&self) -> usize {
        self.net.shape.factors[0].degree
    }

    /// The frame of the control points.
    #[must_use]
    pub fn frame(&self) -> &Triangle<C> {
        &self.frame
    }

    /// The point `a` of the parameter plane.
    #[must_use]
    pub fn parameter(&self) -> &[C; 2] {
        &self.parameter
    }

    /// The barycentric coordinates of `a`.
    #[must_use]
    pub fn barycentric(&self) -> &[C; 3] {
        &self.barycentric
    }

    /// The point `b^l_ijk`, `k = m - l - i - j`.
    ///
    /// # Panics
    /// If `l + i + j` is larger than the degree.
    #[must_use]
    pub fn get(&self, l: usize, i: usize, j: usize) -> &[C] {
        remaining(self.degree(), [l, i, j]);
        self.net.point(self.net.shape.factors[0].index(&[l, i, j]))
    }

    /// The polar label of `b^l_ijk`, such as `f(a,r,s)`.
    ///
    /// # Panics
    /// If `l + i + j` is larger than the degree.
    #[must_use]
    pub fn label(&self, l: usize, i: usize, j: usize) -> String {
        polar_label(&[("a", l), ("r", i), ("s", j), ("t", remaining(self.degree(), [l, i, j]))])
    }

    /// The exponents `(i, j)` of the points of a layer, row by row.
    ///
    /// # Panics
    /// If `l` is larger than the degree.
    #[must_use]
    pub fn indices(&self, l: usize) -> Vec<(usize, usize)> {
        TriangularPatch::<C>::indices(remaining(self.degree(), [l])).into_iter().map(|[i, j, _]| (i, j)).collect()
    }

    /// The point `F(a)`.
    #[must_use]
    pub fn point(&self) -> &[C] {
        self.get(self.degree(), 0, 0)
    }
}
