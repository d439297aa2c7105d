//! Triangle meshes of patches, with exact vertices.

use crate::error::Error;
use crate::exact::Rational;
use crate::kernel::shape::Factor;
use crate::piece::{Equation, Piece};
use crate::reading::Reading;
use crate::weights::projected;

/// The triangles of a recursive subdivision of a patch, all of whose vertices
/// lie on it (Gallier, *Curves and Surfaces in Geometric Modeling*, section
/// 19.4, figure 19.3).
///
/// A triangular patch is divided at the midpoints of its edges again and again;
/// a rectangular one is first divided along a diagonal of its frame. The mesh is
/// watertight: a vertex is computed once, exactly, and shared by its triangles.
///
/// ```
/// use casteljau::{Mesh, Piece, Rational, Rectangle, Surface};
/// let q = |n| Rational::from(n);
/// let saddle = Surface::tensor(vec![vec![(1, 0, q(1))], vec![(0, 1, q(1))], vec![(3, 0, q(1)), (1, 2, q(-3))]])?;
/// let mesh = Mesh::of(&Piece::Rectangle(saddle.over_rectangle(&Rectangle::unit())?), false, 3)?;
/// assert_eq!((mesh.vertices().len(), mesh.triangles().len()), (81, 2 * 64));
/// assert_eq!(mesh.vertices()[80], [q(1), q(1), q(-2)]);
/// # Ok::<(), casteljau::Error>(())
/// ```
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Mesh {
    vertices: Vec<[Rational; 3]>,
    triangles: Vec<[u32; 3]>,
}

impl Mesh {
    /// The most rounds of subdivision.
    pub const MAX_DEPTH: usize = 10;

    /// The mesh of a patch after `depth` rounds. The last coordinate of a
    /// weighted patch is its weight. A patch of one coordinate is taken as the
    /// graph over its frame, one of two as lying in the plane.
    ///
    /// # Errors
    /// [`Error::Unsupported`] for curves, for other dimensions, and where a
    /// vertex is at infinity; [`Error::TooLarge`] above [`Mesh::MAX_DEPTH`].
    pub fn of(piece: &Piece, weighted: bool, depth: usize) -> Result<Self, Error> {
        if depth > Self::MAX_DEPTH {
            return Err(Error::TooLarge { what: "depth of a mesh", limit: Self::MAX_DEPTH });
        }
        let steps = 1 << depth;
        Ok(Self { vertices: grid(piece, weighted, steps)?, triangles: triangles(piece, steps) })
    }

    /// The vertices.
    #[must_use]
    pub fn vertices(&self) -> &[[Rational; 3]] {
        &self.vertices
    }

    /// The triangles, each by its vertices, in the orientation of the frame.
    #[must_use]
    pub fn triangles(&self) -> &[[u32; 3]] {
        &self.triangles
    }
}

/// The patch in space: graphs of functions, and plane patches, become such.
///
/// # Errors
/// [`Error::Unsupported`] for curves and other dimensions.
pub(crate) fn in_space(piece: &Piece, weighted: bool) -> Result<Piece, Error> {
    let dimension = piece.dimension() - usize::from(weighted);
    match (piece, dimension) {
        (Piece::Curve(_), _) => Err(Error::Unsupported("a mesh needs a surface; this is a curve".into())),
        (_, 3) => Ok(piece.clone()),
        (_, 2) => {
            // A third coordinate that is 0, in front of the weight if there is one.
            let flat = |point: &[Rational]| {
                let mut point = point.to_vec();
                point.insert(2, Rational::from(0));
                point
            };
            piece.with_points(piece.points().map(flat).collect())
        }
        (_, 1) if !weighted => graph(piece),
        _ => Err(Error::Unsupported(format!(
            "a picture of a surface needs 1, 2 or 3 coordinates, found {dimension}: `transform` projects it"
        ))),
    }
}

/// The graph `(u, v, F(u, v))`.
fn graph(piece: &Piece) -> Result<Piece, Error> {
    let Equation::Surface(surface) = piece.equation()? else {
        return Err(Error::Unsupported("the graph of a curve is no surface".into()));
    };
    let one = || Rational::from(1);
    let own = surface.terms(0).into_iter().map(|(h, k, c)| (h, k, c.clone())).collect();
    let reading = match surface.reading() {
        Reading::Bidegree(p, q) => Reading::Bidegree(p.max(1), q.max(1)),
        Reading::Total(m) | Reading::Curve(m) => Reading::Total(m.max(1)),
    };
    let graph = crate::surface::Surface::new(reading, vec![vec![(1, 0, one())], vec![(0, 1, one())], own])?;
    Ok(match piece {
        Piece::Rectangle(patch) => Piece::Rectangle(graph.over_rectangle(patch.frame())?),
        Piece::Triangle(patch) => Piece::Triangle(graph.over_triangle(patch.frame())?),
        Piece::Curve(_) => piece.clone(),
    })
}

/// The points of a patch on a regular grid of its frame, `steps` along every edge.
///
/// # Errors
/// As for [`Mesh::of`].
pub(crate) fn grid(piece: &Piece, weighted: bool, steps: usize) -> Result<Vec<[Rational; 3]>, Error> {
    let piece = in_space(piece, weighted)?;
    let net = piece.net().grid(steps);
    let point = |point: &[Rational]| {
        let place = if weighted { projected(point) } else { Some(point.to_vec()) };
        match place.map(<[Rational; 3]>::try_from) {
            Some(Ok(point)) => Ok(point),
            _ => Err(Error::Unsupported("a point of the patch is at infinity: a weight vanishes on its frame".into())),
        }
    };
    net.points().map(point).collect()
}

/// The triangles of a regular grid.
pub(crate) fn triangles(piece: &Piece, steps: usize) -> Vec<[u32; 3]> {
    let mut all = Vec::new();
    if let Piece::Triangle(_) = piece {
        let simplex = Factor { dimension: 2, degree: steps };
        let index = |i: usize, j: usize| simplex.index(&[i, j]) as u32;
        for i in 0..steps {
            for j in 0..steps - i {
                // Toward r, toward s: the orientation of r, s, t.
                all.push([index(i, j), index(i + 1, j), index(i, j + 1)]);
                if i + j + 1 < steps {
                    all.push([index(i + 1, j), index(i + 1, j + 1), index(i, j + 1)]);
                }
            }
        }
        return all;
    }
    let index = |i: usize, j: usize| (i * (steps + 1) + j) as u32;
    for i in 0..steps {
        for j in 0..steps {
            all.push([index(i, j), index(i + 1, j), index(i, j + 1)]);
            all.push([index(i + 1, j), index(i + 1, j + 1), index(i, j + 1)]);
        }
    }
    all
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::affine::{Rectangle, Triangle};
    use crate::surface::Surface;
    use std::collections::HashMap;

    /// Every inner edge belongs to two triangles, in opposite directions.
    #[test]
    fn meshes_are_watertight() {
        let one = || Rational::from(1);
        let surface = Surface::total(vec![vec![(1, 0, one())], vec![(0, 1, one())], vec![(1, 1, one())]]).expect("a surface");
        let pieces = [
            Piece::Triangle(surface.over_triangle(&Triangle::standard()).expect("a patch")),
            Piece::Rectangle(surface.over_rectangle(&Rectangle::unit()).expect("a patch")),
        ];
        for (piece, count) in pieces.iter().zip([1, 2]) {
            for depth in 0..5 {
                let mesh = Mesh::of(piece, false, depth).expect("a mesh");
                assert_eq!(mesh.triangles().len(), count << (2 * depth));
                let mut edges: HashMap<[u32; 2], i32> = HashMap::new();
                for &[a, b, c] in mesh.triangles() {
                    for [from, to] in [[a, b], [b, c], [c, a]] {
                        *edges.entry([from, to]).or_default() += 1;
                    }
                }
                assert!(edges.values().all(|&times| times == 1));
                let open = edges.keys().filter(|&&[from, to]| !edges.contains_key(&[to, from])).count();
                assert_eq!(open, (2 + count) << depth);
                for [x, y, z] in mesh.vertices() {
                    assert_eq!(&(x * y), z);
                }
            }
        }
    }
}
