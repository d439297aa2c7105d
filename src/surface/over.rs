//! Patches of surfaces, and curves on them.

use super::Surface;
use crate::affine::{Interval, PlaneParameter, Rectangle, Triangle};
use crate::control::{ControlNet, Data, change_frame, edge};
use crate::error::Error;
use crate::kernel::coefficient::Coefficient;
use crate::rectangular::RectangularPatch;
use crate::segment::Segment;
use crate::triangular::TriangularPatch;

impl<C: Coefficient> Surface<C> {
    /// The triangular patch over a frame: its control points are the polar
    /// values at the vertices, `b_ijk = f(r^i s^j t^k)` (Gallier, section 19.2).
    /// A surface read by its bidegree `(p, q)` becomes one of total degree `p + q`.
    ///
    /// # Errors
    /// [`Error::TooLarge`] above [`Surface::MAX_COEFFICIENTS`].
    pub fn over_triangle(&self, frame: &Triangle<C>) -> Result<TriangularPatch<C>, Error> {
        let surface = self.by_total_degree()?;
        let shape = surface.shape();
        if frame.vertices().iter().flatten().any(|coordinate| coordinate.as_rational().is_none()) {
            // Replacing vertices would divide by symbolic weights; polar values do not.
            let mut coordinates = Vec::with_capacity(surface.coefficients.len());
            let vertices = frame.points();
            for exponents in surface.reading.exponents() {
                let repeated = vertices.iter().zip(&exponents).flat_map(|(vertex, &times)| std::iter::repeat_n(vertex.clone(), times));
                coordinates.extend(surface.blossom(&repeated.collect::<Vec<_>>())?);
            }
            return Ok(TriangularPatch::from_net(ControlNet { shape, coordinates }, frame.clone()));
        }
        let data = (Data::Equation, surface.coefficients.as_slice());
        let coordinates = change_frame(&shape, data, &[PlaneParameter::weights(&frame.points())], Data::Net)?;
        Ok(TriangularPatch::from_net(ControlNet { shape, coordinates }, frame.clone()))
    }

    /// The rectangular patch over two frames: its control points are
    /// `b_ij = f(r1^{p-i} s1^i; r2^{q-j} s2^j)` (Gallier, section 19.3).
    /// A surface read by its total degree `m` becomes one of bidegree `(m, m)`.
    ///
    /// # Errors
    /// [`Error::TooLarge`] above [`Surface::MAX_COEFFICIENTS`].
    pub fn over_rectangle(&self, frame: &Rectangle<C>) -> Result<RectangularPatch<C>, Error> {
        let surface = self.by_bidegree()?;
        let shape = surface.shape();
        let vertices = [frame.u().vertices(), frame.v().vertices()];
        let coordinates = change_frame(&shape, (Data::Equation, &surface.coefficients), &vertices, Data::Net)?;
        Ok(RectangularPatch::from_net(ControlNet { shape, coordinates }, frame.clone()))
    }

    /// The curve that the surface carries along the line from `a` to `b`, over
    /// the frame `0..1`: its control points are `f(a^{m-i} b^i)`, where `m` is
    /// the total degree, or `p + q` for a bidegree (CS348a, lecture 12, section 4).
    ///
    /// # Errors
    /// [`Error::Unsupported`] if it is not known whether symbolic ends are
    /// different; [`Error::TooLarge`] above [`Surface::MAX_COEFFICIENTS`].
    pub fn segment(&self, a: &[C; 2], b: &[C; 2]) -> Result<Segment<C>, Error> {
        let surface = self.by_total_degree()?;
        let direction = [b[0].minus(&a[0]), b[1].minus(&a[1])];
        if direction.iter().all(C::is_nothing) {
            let point = surface.value(a);
            let coordinates = (0..=surface.reading.groups()[0].0).flat_map(|_| point.iter().cloned()).collect();
            return Segment::new(self.dimension, coordinates, Interval::unit());
        }
        // A third vertex off the line: a step across it. What it is does not matter.
        let across = if direction[1].is_nothing() { [C::nothing(), C::unit()] } else { [C::unit(), C::nothing()] };
        let off = PlaneParameter::vector(across);
        let vertices = [off, PlaneParameter::point(a.clone()), PlaneParameter::point(b.clone())];
        let net = edge(&surface.shape(), &surface.coefficients, &PlaneParameter::weights(&vertices))?;
        Ok(Segment::from_net(net, Interval::unit()))
    }
}
