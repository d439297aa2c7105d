//! Triangular patches of polynomial surfaces, given by control points.

use crate::affine::{AffineMap, PlaneParameter, Triangle, Weights};
use crate::control::{ControlNet, MAX_PATCH_DEPTH, MAX_STEPS};
use crate::error::Error;
use crate::exact::Rational;
use crate::kernel::coefficient::Coefficient;
use crate::kernel::shape::{Factor, Shape};
use crate::reading::Reading;
use crate::scheme::{polar_label, remaining};
use crate::surface::Surface;
use crate::tetrahedron::TriangularScheme;

/// A polynomial surface of total degree `m` over a frame `(r, s, t)`, given by
/// its triangular net `b_ijk = f(r^i s^j t^k)`, `i + j + k = m`.
///
/// Any `(m+1)(m+2)/2` points are the net of exactly one surface of that total
/// degree (Gallier, *Curves and Surfaces in Geometric Modeling*, lemma 19.2.1).
/// The points stand row by row, `i = 0, …, m`, in a row `j = 0, …, m - i`.
///
/// ```
/// use casteljau::{Rational, Triangle, TriangularPatch};
/// let rows = [vec![[0, 0, 0], [0, 1, 0]], vec![[1, 0, 2]]];
/// let rows = rows.map(|row| row.into_iter().map(|point| point.map(Rational::from).to_vec()).collect()).to_vec();
/// let patch = TriangularPatch::from_rows(rows, Triangle::standard())?;
/// let middle = [Rational::new(1, 2), Rational::new(1, 4)];
/// assert_eq!(patch.value(&middle)?, [Rational::new(1, 2), Rational::new(1, 4), Rational::from(1)]);
/// # Ok::<(), casteljau::Error>(())
/// ```
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct TriangularPatch<C = Rational> {
    net: ControlNet<C>,
    frame: Triangle<C>,
}

/// The nets of a patch subdivided at a point `a`, each with `a` in place of one
/// vertex; none where the sub-triangle is flat.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Trisection<C = Rational> {
    /// The point `F(a)`.
    pub point: Vec<C>,
    /// The net over `(a, s, t)`; none where `a` lies on the line `st`.
    pub ast: Option<TriangularPatch<C>>,
    /// The net over `(r, a, t)`; none where `a` lies on the line `rt`.
    pub rat: Option<TriangularPatch<C>>,
    /// The net over `(r, s, a)`; none where `a` lies on the line `rs`.
    pub rsa: Option<TriangularPatch<C>>,
}

/// The nets of a patch subdivided at the midpoints `a` of `st`, `b` of `rt` and
/// `c` of `rs`, with vertices in the order of their names. All four have the
/// opposite orientation of the frame.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Quadrisection<C = Rational> {
    /// The net over `(a, b, t)`.
    pub abt: TriangularPatch<C>,
    /// The net over `(b, a, c)`.
    pub bac: TriangularPatch<C>,
    /// The net over `(c, r, b)`.
    pub crb: TriangularPatch<C>,
    /// The net over `(s, c, a)`.
    pub sca: TriangularPatch<C>,
}

/// A patch at its true total degree, and what that is.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct TriangularReduction<C = Rational> {
    /// The largest total degree of the coordinates; 0 for a constant.
    pub true_degree: usize,
    /// Whether all coordinates vanish identically.
    pub zero: bool,
    /// The same map with the true degree as its degree.
    pub patch: TriangularPatch<C>,
}

/// The degree of a triangular net with so many points.
#[must_use]
pub fn triangular_degree(points: usize) -> Option<usize> {
    // (m+1)(m+2)/2 = n, so m+1 is the whole root of 2n below its own successor.
    let twice = points.checked_mul(2)?;
    let root = twice.isqrt();
    (root > 0 && root * (root + 1) == twice).then(|| root - 1)
}

impl<C: Coefficient> TriangularPatch<C> {
    /// The most rounds of subdivision that are carried out at once.
    pub const MAX_DEPTH: usize = MAX_PATCH_DEPTH;
    /// The most steps, each on one coordinate, of a subdivision or an elevation.
    pub const MAX_STEPS: usize = MAX_STEPS;

    /// The patch with these control points, in the order of the rows.
    ///
    /// # Errors
    /// [`Error::WrongShape`] if their number is not that of a triangular net,
    /// or the points are not all of one dimension.
    pub fn from_points(points: Vec<Vec<C>>, frame: Triangle<C>) -> Result<Self, Error> {
        let Some(degree) = triangular_degree(points.len()) else {
            return Err(Error::WrongShape(format!(
                "a triangular net has 1, 3, 6, 10, … points, (m+1)(m+2)/2 for degree m; found {}",
                points.len()
            )));
        };
        Ok(Self { net: ControlNet::from_points(|dimension| Shape::triangle(degree, dimension), points)?, frame })
    }

    /// The patch with these rows of control points.
    ///
    /// # Errors
    /// [`Error::WrongShape`] if a row has the wrong length, which is named, or
    /// the points are not all of one dimension.
    pub fn from_rows(rows: Vec<Vec<Vec<C>>>, frame: Triangle<C>) -> Result<Self, Error> {
        let count = rows.len();
        if let Some((index, row)) = rows.iter().enumerate().find(|(index, row)| row.len() != count - index) {
            return Err(Error::WrongShape(format!(
                "row {index} of the triangular net has {} points; with {count} rows it needs {} (row i = 0, …, m has m + 1 - i)",
                row.len(),
                count - index
            )));
        }
        Self::from_points(rows.into_iter().flatten().collect(), frame)
    }

    pub(crate) fn from_net(net: ControlNet<C>, frame: Triangle<C>) -> Self {
        debug_assert_eq!(net.coordinates.len(), net.shape.points() * net.shape.stride);
        Self { net, frame }
    }

    pub(crate) fn net(&self) -> &ControlNet<C> {
        &self.net
    }

    /// The total degree `m`.
    #[must_use]
    pub fn degree(&self) -> usize {
        self.net.shape.factors[0].degree
    }

    /// The number of coordinates.
    #[must_use]
    pub fn dimension(&self) -> usize {
        self.net.dimension()
    }

    /// The frame.
    #[must_use]
    pub fn frame(&self) -> &Triangle<C> {
        &self.frame
    }

    /// The coordinates of all control points, point by point.
    #[must_use]
    pub fn coordinates(&self) -> &[C] {
        &self.net.coordinates
    }

    /// The control point `b_ijk`, `k = m - i - j`.
    ///
    /// # Panics
    /// If `i + j` is larger than the degree.
    #[must_use]
    pub fn point(&self, i: usize, j: usize) -> &[C] {
        remaining(self.degree(), [i, j]);
        self.net.point(self.net.shape.factors[0].index(&[i, j]))
    }

    /// The polar label of `b_ijk`, such as `f(r,r,s)`.
    ///
    /// # Panics
    /// If `i + j` is larger than the degree.
    #[must_use]
    pub fn label(&self, i: usize, j: usize) -> String {
        polar_label(&[("r", i), ("s", j), ("t", remaining(self.degree(), [i, j]))])
    }

    /// The exponents `(i, j, k)` of all control points, in the order of the rows.
    #[must_use]
    pub fn indices(degree: usize) -> Vec<[usize; 3]> {
        let mut all = Vec::new();
        Factor { dimension: 2, degree }.for_each(|exponents| all.push([exponents[1], exponents[2], exponents[0]]));
        all
    }

    /// The control points, row by row.
    pub fn points(&self) -> impl DoubleEndedIterator<Item = &[C]> + ExactSizeIterator + Clone {
        self.net.points()
    }

    /// The rows of control points.
    pub fn rows(&self) -> impl Iterator<Item = impl DoubleEndedIterator<Item = &[C]> + ExactSizeIterator + Clone> {
        (0..=self.degree()).map(move |i| {
            let start = self.net.shape.factors[0].index(&[i, 0]);
            (start..start + self.degree() + 1 - i).map(|index| self.net.point(index))
        })
    }

    /// The equation of the surface.
    ///
    /// # Errors
    /// [`Error::Unsupported`] if the area of the frame is symbolic.
    pub fn surface(&self) -> Result<Surface<C>, Error> {
        let vertices = self.frame.weights(&PlaneParameter::plane())?;
        Ok(Surface::from_coefficients(Reading::Total(self.degree()), self.dimension(), self.net.equation(&[vertices])?))
    }

    /// The control points over another frame: the polar values at its vertices.
    ///
    /// # Errors
    /// [`Error::Unsupported`] if the area of the present frame is symbolic.
    pub fn reframe(&self, frame: &Triangle<C>) -> Result<Self, Error> {
        if frame.vertices().iter().flatten().any(|coordinate| coordinate.as_rational().is_none()) {
            return self.surface()?.over_triangle(frame);
        }
        let vertices = self.frame.weights(&frame.points())?;
        Ok(Self { net: self.net.over(&[vertices])?, frame: frame.clone() })
    }

    /// The polar value at `m` points or vectors: one step of de Casteljau's
    /// algorithm for each (Gallier, lemma 19.2.1).
    ///
    /// # Errors
    /// [`Error::WrongCount`] for another number of arguments;
    /// [`Error::Unsupported`] if the area of the frame is symbolic.
    pub fn blossom(&self, arguments: &[PlaneParameter<C>]) -> Result<Vec<C>, Error> {
        if arguments.len() != self.degree() {
            return Err(Error::WrongCount { what: "polar arguments", expected: self.degree(), found: arguments.len() });
        }
        Ok(self.net.polar_value(&[self.frame.weights(arguments)?]).coordinates)
    }

    /// The point `F(a)`, for any `a`, inside the frame or not.
    ///
    /// # Errors
    /// [`Error::Unsupported`] if the area of the frame is symbolic.
    pub fn value(&self, a: &[C; 2]) -> Result<Vec<C>, Error> {
        self.blossom(&vec![PlaneParameter::point(a.clone()); self.degree()])
    }

    /// De Casteljau's algorithm at `a` with all intermediate points.
    ///
    /// # Errors
    /// [`Error::Unsupported`] if the area of the frame is symbolic.
    pub fn scheme(&self, a: &[C; 2]) -> Result<TriangularScheme<C>, Error> {
        TriangularScheme::of(self, a)
    }

    fn argument(&self, a: &[C; 2]) -> Result<Weights<C>, Error> {
        self.frame.weights(&[PlaneParameter::point(a.clone())])
    }

    /// The nets over `(a,s,t)`, `(r,a,t)` and `(r,s,a)`: faces of the
    /// tetrahedron of polar values (Gallier, section 19.4).
    ///
    /// # Errors
    /// [`Error::Unsupported`] if the area of the frame is symbolic.
    pub fn split(&self, a: &[C; 2]) -> Result<Trisection<C>, Error> {
        let weights = self.argument(a)?;
        // In the kernel the vertices are t, r, s; replacing one keeps the others in place.
        let [r, s, t] = self.frame.vertices();
        let targets = [(1, [a, s, t]), (2, [r, a, t]), (0, [r, s, a])];
        let replaced: Vec<usize> =
            targets.iter().map(|target| target.0).filter(|&vertex| !weights.rows.as_slice().is_nothing(vertex)).collect();
        let mut nets = self.net.faces(0, &weights, &replaced).into_iter();
        let [ast, rat, rsa] = targets.map(|(vertex, [r, s, t])| {
            if weights.rows.as_slice().is_nothing(vertex) {
                return Ok(None);
            }
            let frame = Triangle::new(r.clone(), s.clone(), t.clone())?;
            Ok::<_, Error>(nets.next().map(|net| Self { net, frame }))
        });
        Ok(Trisection { point: self.value(a)?, ast: ast?, rat: rat?, rsa: rsa? })
    }

    /// The nets of the four triangles that the midpoints of the edges make, in
    /// four calls of the subdivision algorithm: at `a` in `(r,s,t)`, at `b` in
    /// `(r,a,t)`, at `c` in `(r,s,a)`, and at `c` again, from outside, in `(r,a,b)`
    /// (Gallier, section 19.4).
    ///
    /// # Errors
    /// [`Error::Unsupported`] if the area of the frame is symbolic.
    pub fn quadrisect(&self) -> Result<Quadrisection<C>, Error> {
        let half = C::from(Rational::new(1, 2));
        let middle = |a: &[C; 2], b: &[C; 2]| [0, 1].map(|axis| a[axis].plus(&b[axis]).times(&half));
        let [r, s, t] = self.frame.vertices();
        let (a, b, c) = (middle(s, t), middle(r, t), middle(r, s));
        let flat = || Error::DegenerateFrame("a sub-triangle is flat".into());
        let first = self.split(&a)?;
        let second = first.rat.ok_or_else(flat)?.split(&b)?;
        let third = first.rsa.ok_or_else(flat)?.split(&c)?;
        let fourth = second.rsa.ok_or_else(flat)?.split(&c)?;
        let (bat, csa) = (second.ast.ok_or_else(flat)?, third.ast.ok_or_else(flat)?);
        let (rcb, cab) = (fourth.rat.ok_or_else(flat)?, fourth.ast.ok_or_else(flat)?);
        Ok(Quadrisection {
            abt: bat.permuted([1, 0, 2]),
            bac: cab.permuted([2, 1, 0]),
            crb: rcb.permuted([1, 0, 2]),
            sca: csa.permuted([1, 0, 2]),
        })
    }

    /// The same net with its vertices in another order: `order[k]` is which of
    /// `r`, `s`, `t` becomes vertex `k`.
    ///
    /// # Panics
    /// If `order` is not a permutation of 0, 1, 2.
    #[must_use]
    pub fn permuted(&self, order: [usize; 3]) -> Self {
        assert!((0..3).all(|vertex| order.contains(&vertex)), "{order:?} is no order of the vertices 0, 1, 2");
        let mut coordinates = Vec::with_capacity(self.net.coordinates.len());
        for exponents in Self::indices(self.degree()) {
            let mut old = [usize::MAX; 3];
            order.iter().zip(exponents).for_each(|(&vertex, exponent)| old[vertex] = exponent);
            coordinates.extend_from_slice(self.point(old[0], old[1]));
        }
        let frame = Triangle::new(
            self.frame.vertices()[order[0]].clone(),
            self.frame.vertices()[order[1]].clone(),
            self.frame.vertices()[order[2]].clone(),
        );
        // The same three vertices are a frame in any order.
        let frame = frame.unwrap_or_else(|_| self.frame.clone());
        Self { net: ControlNet { shape: self.net.shape, coordinates }, frame }
    }

    /// The nets of `depth` rounds of subdivision at the midpoints, `4^depth`
    /// (Gallier, section 19.4, figure 19.3).
    ///
    /// # Errors
    /// [`Error::TooLarge`] above [`TriangularPatch::MAX_DEPTH`] or
    /// [`TriangularPatch::MAX_STEPS`]; [`Error::Unsupported`] if the area of
    /// the frame is symbolic.
    pub fn subdivide(&self, depth: usize) -> Result<Vec<Self>, Error> {
        self.net.check_subdivision(depth, Self::MAX_DEPTH)?;
        let mut pieces = vec![self.clone()];
        for _ in 0..depth {
            let mut parts = Vec::with_capacity(4 * pieces.len());
            for piece in &pieces {
                let Quadrisection { abt, bac, crb, sca } = piece.quadrisect()?;
                parts.extend([abt, bac, crb, sca]);
            }
            pieces = parts;
        }
        Ok(pieces)
    }

    /// The same map with the degree `by` higher.
    ///
    /// # Errors
    /// [`Error::TooLarge`] above [`TriangularPatch::MAX_STEPS`].
    pub fn elevate(&self, by: usize) -> Result<Self, Error> {
        Ok(Self { net: self.net.elevate(&[by])?, frame: self.frame.clone() })
    }

    /// The same map with as few control points as it can have.
    ///
    /// # Errors
    /// [`Error::Unsupported`] if the area of the frame is symbolic.
    pub fn reduce(&self) -> Result<TriangularReduction<C>, Error> {
        let surface = self.surface()?;
        let true_degree = surface.true_total_degree();
        let patch = if true_degree == self.degree() {
            self.clone()
        } else {
            surface.read_as(Reading::Total(true_degree))?.over_triangle(&self.frame)?
        };
        Ok(TriangularReduction { true_degree, zero: surface.is_zero(), patch })
    }

    /// The derivative in a direction of the parameter plane, a patch of vectors
    /// over the same frame: `m` times the net with that direction as one argument.
    ///
    /// # Errors
    /// [`Error::Unsupported`] if the area of the frame is symbolic.
    pub fn derivative(&self, direction: &[C; 2]) -> Result<Self, Error> {
        let net = self.net.derivative(0, || self.frame.weights(&[PlaneParameter::vector(direction.clone())]))?;
        Ok(Self { net, frame: self.frame.clone() })
    }

    /// The product with another patch over the same frame: coordinate by
    /// coordinate, or a patch with one coordinate times every coordinate of the other.
    ///
    /// # Errors
    /// [`Error::WrongShape`] if the frames differ, or the dimensions do and neither is 1.
    pub fn product(&self, other: &Self) -> Result<Self, Error> {
        if self.frame != other.frame {
            return Err(Error::WrongShape("a product needs both patches over the same frame; reframe one of them first".into()));
        }
        Ok(Self { net: self.net.product(&other.net)?, frame: self.frame.clone() })
    }

    /// The image under an affine map: its control points are the images of the control points.
    ///
    /// # Errors
    /// [`Error::WrongCount`] if the map takes points of another dimension.
    pub fn transform(&self, map: &AffineMap<C>) -> Result<Self, Error> {
        Ok(Self { net: self.net.transform(map)?, frame: self.frame.clone() })
    }

    /// Whether two patches are pieces of the same polynomial map, whatever
    /// their frames and degrees.
    ///
    /// # Errors
    /// [`Error::Unsupported`] if the area of a frame is symbolic.
    pub fn same_map(&self, other: &Self) -> Result<bool, Error> {
        Ok(self.surface()?.same_map(&other.surface()?))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn degrees_of_counts() {
        let degrees: Vec<Option<usize>> = (0..12).map(triangular_degree).collect();
        let expected = [None, Some(0), None, Some(1), None, None, Some(2), None, None, None, Some(3), None];
        assert_eq!(degrees, expected);
        assert_eq!(triangular_degree(4097 * 4098 / 2), Some(4096));
        assert_eq!(triangular_degree(usize::MAX), None);
    }
}
