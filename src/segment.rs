//! Segments of polynomial curves, given by control points over a frame.

use crate::affine::{AffineMap, Interval, Parameter};
use crate::control::{ControlNet, MAX_STEPS};
use crate::curve::Curve;
use crate::error::Error;
use crate::exact::Rational;
use crate::kernel::coefficient::Coefficient;
use crate::kernel::integers::Integers;
use crate::kernel::layout::Layout;
use crate::kernel::shape::Shape;
use crate::kernel::task::Split;
use crate::scheme::{Scheme, polar_label, remaining};

/// A polynomial curve over a frame `(r, s)`, given by its control points
/// `b_i = f(r^{m-i} s^i)`.
///
/// Any `m + 1` points are the control points of exactly one curve of polar
/// degree `m` (Gallier, *Curves and Surfaces in Geometric Modeling*, lemma
/// 18.1.2), so a segment says as much as a [`Curve`] does.
///
/// ```
/// use casteljau::{Interval, Rational, Segment};
/// let points = [[0, 0], [-4, 4], [-4, -12], [0, 0]];
/// let points = points.map(|p| p.map(Rational::from).to_vec()).to_vec();
/// let segment = Segment::from_points(points, Interval::new((-1).into(), 3.into())?)?;
/// assert_eq!(segment.value(&Rational::from(1))?, [Rational::from(-3), Rational::from(-3)]);
/// let (left, right) = segment.split(&Rational::from(1))?;
/// assert_eq!(left.point(2), [Rational::from(-3), Rational::from(-1)]);
/// assert!(left.same_map(&right)?);
/// # Ok::<(), casteljau::Error>(())
/// ```
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Segment<C = Rational> {
    net: ControlNet<C>,
    frame: Interval<C>,
}

/// A segment at its true degree, and what that is.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Reduction<C = Rational> {
    /// The largest degree of the coordinates; 0 for a constant.
    pub true_degree: usize,
    /// Whether all coordinates vanish identically.
    pub zero: bool,
    /// The same map with the true degree as its polar degree.
    pub segment: Segment<C>,
}

impl<C: Coefficient> Segment<C> {
    /// The most rounds of splitting in the middle that are carried out at once.
    pub const MAX_DEPTH: usize = 20;
    /// The most steps, each on one coordinate, of a subdivision or an elevation.
    pub const MAX_STEPS: usize = MAX_STEPS;

    /// The segment whose control points have these coordinates, point by point.
    ///
    /// # Errors
    /// [`Error::WrongShape`] if there is no point or the list does not divide
    /// into points of that dimension.
    pub fn new(dimension: usize, coordinates: Vec<C>, frame: Interval<C>) -> Result<Self, Error> {
        if dimension == 0 || coordinates.is_empty() || !coordinates.len().is_multiple_of(dimension) {
            return Err(Error::WrongShape(format!(
                "{} coordinates do not make one or more points with {dimension} coordinates",
                coordinates.len()
            )));
        }
        Ok(Self { net: ControlNet { shape: Shape::curve(coordinates.len() / dimension - 1, dimension), coordinates }, frame })
    }

    /// The segment with these control points.
    ///
    /// # Errors
    /// [`Error::WrongShape`] if there is no point, a point without coordinates,
    /// or points of different dimensions.
    pub fn from_points(points: Vec<Vec<C>>, frame: Interval<C>) -> Result<Self, Error> {
        let degree = points.len().saturating_sub(1);
        Ok(Self { net: ControlNet::from_points(|dimension| Shape::curve(degree, dimension), points)?, frame })
    }

    /// The polar degree: one less than the number of control points.
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
    pub fn frame(&self) -> &Interval<C> {
        &self.frame
    }

    /// The coordinates of all control points, point by point.
    #[must_use]
    pub fn coordinates(&self) -> &[C] {
        &self.net.coordinates
    }

    /// The control point `b_i`.
    ///
    /// # Panics
    /// If `index` is larger than the polar degree.
    #[must_use]
    pub fn point(&self, index: usize) -> &[C] {
        self.net.point(index)
    }

    /// The polar label of the control point `b_i`, such as `f(r,r,s)`.
    ///
    /// # Panics
    /// If `index` is larger than the polar degree.
    #[must_use]
    pub fn label(&self, index: usize) -> String {
        polar_label(&[("r", remaining(self.degree(), [index])), ("s", index)])
    }

    /// The control points in order.
    pub fn points(&self) -> impl DoubleEndedIterator<Item = &[C]> + ExactSizeIterator + Clone {
        self.net.points()
    }

    /// The segment with this control polygon.
    pub(crate) fn from_net(net: ControlNet<C>, frame: Interval<C>) -> Self {
        debug_assert_eq!(net.coordinates.len(), net.shape.points() * net.shape.stride);
        Self { net, frame }
    }

    pub(crate) fn net(&self) -> &ControlNet<C> {
        &self.net
    }

    /// The equation of the curve.
    ///
    /// # Errors
    /// [`Error::Unsupported`] if the length of the frame is symbolic.
    pub fn curve(&self) -> Result<Curve<C>, Error> {
        let vertices = self.frame.weights(&Parameter::line())?;
        Ok(Curve::from_vectors(self.dimension(), self.net.equation(&[vertices])?))
    }

    /// The control points over another frame: the polar values at its vertices.
    ///
    /// # Errors
    /// [`Error::Unsupported`] if the length of the present frame is symbolic.
    pub fn reframe(&self, frame: &Interval<C>) -> Result<Self, Error> {
        if frame.r().as_rational().is_none() || frame.s().as_rational().is_none() {
            // Replacing vertices directly would divide by a symbolic weight.
            return self.curve()?.segment(frame);
        }
        let vertices = self.frame.weights(&frame.ends())?;
        Ok(Self { net: self.net.over(&[vertices])?, frame: frame.clone() })
    }

    /// The polar value `f(t_1, …, t_m)`: one step of de Casteljau's algorithm
    /// for each argument (Gallier, section 18.1, the expansion of `f` over
    /// subsets, in a quadratic number of steps).
    ///
    /// # Errors
    /// [`Error::WrongCount`] unless there are as many arguments as the polar
    /// degree; [`Error::Unsupported`] if the length of the frame is symbolic.
    pub fn blossom(&self, arguments: &[C]) -> Result<Vec<C>, Error> {
        let arguments: Vec<Parameter<C>> = arguments.iter().cloned().map(Parameter::from).collect();
        self.blossom_homogeneous(&arguments)
    }

    /// The polar value at homogeneous arguments `[w; t]`, vectors included.
    ///
    /// # Errors
    /// As for [`Segment::blossom`].
    pub fn blossom_homogeneous(&self, arguments: &[Parameter<C>]) -> Result<Vec<C>, Error> {
        if arguments.len() != self.degree() {
            return Err(Error::WrongCount { what: "polar arguments", expected: self.degree(), found: arguments.len() });
        }
        Ok(self.net.polar_value(&[self.frame.weights(arguments)?]).coordinates)
    }

    /// The point `F(t)`, for any `t`, inside the frame or not.
    ///
    /// # Errors
    /// [`Error::Unsupported`] if the length of the frame is symbolic.
    pub fn value(&self, t: &C) -> Result<Vec<C>, Error> {
        self.blossom(&vec![t.clone(); self.degree()])
    }

    /// De Casteljau's algorithm at `t` with all intermediate points.
    ///
    /// # Errors
    /// [`Error::Unsupported`] if the length of the frame is symbolic.
    pub fn scheme(&self, t: &C) -> Result<Scheme<C>, Error> {
        Scheme::of(self, t)
    }

    /// The control points over `(r, t)` and over `(t, s)`.
    ///
    /// At a vertex one of the two frames has no length; use
    /// [`Segment::scheme`] to see that half all the same.
    ///
    /// # Errors
    /// [`Error::DegenerateFrame`] if `t` is `r` or `s`; [`Error::Unsupported`]
    /// if the length of the frame is symbolic.
    pub fn split(&self, t: &C) -> Result<(Self, Self), Error> {
        if t == self.frame.r() || t == self.frame.s() {
            return Err(Error::DegenerateFrame(format!(
                "{t} is an end of the frame {}: splitting there leaves one part without length",
                self.frame
            )));
        }
        let left = Interval::new(self.frame.r().clone(), t.clone())?;
        let right = Interval::new(t.clone(), self.frame.s().clone())?;
        let found = self.frame.weights(&[Parameter::from(t.clone())])?;
        let shape = self.net.shape;
        // The vertices of the halves: r, t and t, s.
        let mut scales = Integers::default();
        scales.push_word(1);
        scales.extend(found.scales.as_slice());
        scales.push_word(1);
        let scales = scales.as_slice();
        let layouts = [Layout::net(shape, scales.up_to(2)), Layout::net(shape, scales.after(1))];
        let mut first = C::compute(&Split { shape }, self.coordinates(), found.rows.as_slice(), &layouts);
        let second = first.split_off(self.coordinates().len());
        let piece = |coordinates, frame| Self { net: ControlNet { shape, coordinates }, frame };
        Ok((piece(first, left), piece(second, right)))
    }

    /// The pieces of `depth` rounds of splitting in the middle, `2^depth` in order.
    ///
    /// # Errors
    /// [`Error::TooLarge`] above [`Segment::MAX_DEPTH`] or
    /// [`Segment::MAX_STEPS`]; [`Error::Unsupported`] if the length of the
    /// frame is symbolic.
    pub fn subdivide(&self, depth: usize) -> Result<Vec<Self>, Error> {
        self.net.check_subdivision(depth, Self::MAX_DEPTH)?;
        let half = C::from(Rational::new(1, 2));
        let mut pieces = vec![self.clone()];
        for _ in 0..depth {
            let mut halves = Vec::with_capacity(2 * pieces.len());
            for piece in &pieces {
                let (left, right) = piece.split(&piece.frame.at(&half))?;
                halves.extend([left, right]);
            }
            pieces = halves;
        }
        Ok(pieces)
    }

    /// The points of the curve at the ends of the pieces of [`Segment::subdivide`], in order.
    ///
    /// # Errors
    /// As for [`Segment::subdivide`].
    pub fn polyline(&self, depth: usize) -> Result<Vec<Vec<C>>, Error> {
        let pieces = self.subdivide(depth)?;
        let ends = pieces.iter().map(|piece| piece.point(piece.degree()).to_vec());
        Ok(std::iter::once(self.point(0).to_vec()).chain(ends).collect())
    }

    /// The same map with `by` more control points (Gallier, section 18.1, the
    /// remark on polar degrees; Farin, *Curves and Surfaces for CAGD*, degree elevation).
    ///
    /// # Errors
    /// [`Error::TooLarge`] above [`Segment::MAX_STEPS`].
    pub fn elevate(&self, by: usize) -> Result<Self, Error> {
        Ok(Self { net: self.net.elevate(&[by])?, frame: self.frame.clone() })
    }

    /// The same map with as few control points as it can have.
    ///
    /// # Errors
    /// [`Error::Unsupported`] if the length of the frame is symbolic.
    pub fn reduce(&self) -> Result<Reduction<C>, Error> {
        let curve = self.curve()?;
        let true_degree = curve.true_degree();
        Ok(Reduction {
            true_degree,
            zero: curve.is_zero(),
            segment: Self { net: self.net.with_degree(0, true_degree), frame: self.frame.clone() },
        })
    }

    /// The derivative as a segment over the same frame; its control points are
    /// the vectors `m (b_{i+1} - b_i) / (s - r)`.
    ///
    /// # Errors
    /// [`Error::Unsupported`] if the length of the frame is symbolic.
    pub fn derivative(&self) -> Result<Self, Error> {
        let net = self.net.derivative(0, || self.frame.weights(&[Parameter::direction()]))?;
        Ok(Self { net, frame: self.frame.clone() })
    }

    /// The product with another segment over the same frame: coordinate by
    /// coordinate, or a curve with one coordinate times every coordinate of the other.
    ///
    /// # Errors
    /// [`Error::WrongShape`] if the frames differ, or the dimensions do and neither is 1.
    pub fn product(&self, other: &Self) -> Result<Self, Error> {
        if self.frame != other.frame {
            return Err(Error::WrongShape("a product needs both segments over the same frame; reframe one of them first".into()));
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

    /// Whether two segments are pieces of the same polynomial map, whatever
    /// their frames and polar degrees: they agree on an arc only if they agree
    /// everywhere (CS348a, lecture 6, section 1.2).
    ///
    /// # Errors
    /// [`Error::Unsupported`] if the length of a frame is symbolic.
    pub fn same_map(&self, other: &Self) -> Result<bool, Error> {
        Ok(self.curve()?.same_map(&other.curve()?))
    }
}
