//! Rectangular patches of polynomial surfaces, given by control points.

use crate::affine::{AffineMap, Interval, Parameter, Rectangle, Weights};
use crate::bilinear::{CommonSteps, TwoSteps};
use crate::control::{ControlNet, MAX_PATCH_DEPTH, MAX_STEPS, count};
use crate::error::Error;
use crate::exact::Rational;
use crate::kernel::coefficient::Coefficient;
use crate::kernel::shape::Shape;
use crate::reading::Reading;
use crate::scheme::{polar_label, remaining};
use crate::segment::Segment;
use crate::surface::Surface;

/// A polynomial surface of bidegree `(p, q)` over two frames, given by its
/// rectangular net `b_ij = f(r1^{p-i} s1^i; r2^{q-j} s2^j)`.
///
/// Any `(p+1)(q+1)` points are the net of exactly one surface of that bidegree
/// (Gallier, *Curves and Surfaces in Geometric Modeling*, lemma 19.3.1). The
/// points stand row by row: `i`, which belongs to `u`, is the row.
///
/// ```
/// use casteljau::{Rational, Rectangle, RectangularPatch};
/// let rows = [[0, 1], [2, 7]].map(|row| row.map(|z| vec![Rational::from(z)]).to_vec()).to_vec();
/// let patch = RectangularPatch::from_rows(rows, Rectangle::unit())?;
/// let half = Rational::new(1, 2);
/// assert_eq!(patch.value(&[half.clone(), half.clone()])?, [Rational::new(5, 2)]);
/// assert_eq!(patch.label(1, 0), "f(s1;r2)");
/// # Ok::<(), casteljau::Error>(())
/// ```
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct RectangularPatch<C = Rational> {
    net: ControlNet<C>,
    frame: Rectangle<C>,
}

/// One of the two parameters of a rectangle.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Axis {
    /// The first parameter, whose index is that of the rows.
    U,
    /// The second parameter.
    V,
}

impl Axis {
    /// The other one.
    #[must_use]
    pub fn other(self) -> Self {
        if self == Self::U { Self::V } else { Self::U }
    }

    pub(crate) fn factor(self) -> usize {
        usize::from(self == Self::V)
    }
}

/// The nets of a rectangle subdivided at `(u, v)`; none where a part has no width.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Quartering<C = Rational> {
    /// The point `F(u, v)`.
    pub point: Vec<C>,
    /// Over `[r1, u] × [r2, v]`.
    pub ll: Option<RectangularPatch<C>>,
    /// Over `[u, s1] × [r2, v]`.
    pub rl: Option<RectangularPatch<C>>,
    /// Over `[r1, u] × [v, s2]`.
    pub lr: Option<RectangularPatch<C>>,
    /// Over `[u, s1] × [v, s2]`.
    pub rr: Option<RectangularPatch<C>>,
}

/// A patch at its true bidegree, and its degrees.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct RectangularReduction<C = Rational> {
    /// The largest degree of the coordinates in each parameter.
    pub true_degree: (usize, usize),
    /// The largest total degree of the coordinates.
    pub total_degree: usize,
    /// Whether all coordinates vanish identically.
    pub zero: bool,
    /// The same map with the true bidegree as its bidegree.
    pub patch: RectangularPatch<C>,
}

/// The label of a polar value of a rectangle, such as `f(r1,s1;r2,t2)`.
#[must_use]
pub fn bidegree_label(us: &[(&str, usize)], vs: &[(&str, usize)]) -> String {
    let list = |arguments: &[(&str, usize)]| polar_label(arguments)[2..].trim_end_matches(')').to_owned();
    format!("f({};{})", list(us), list(vs))
}

impl<C: Coefficient> RectangularPatch<C> {
    /// The most rounds of subdivision that are carried out at once.
    pub const MAX_DEPTH: usize = MAX_PATCH_DEPTH;
    /// The most steps, each on one coordinate, of a subdivision or an elevation.
    pub const MAX_STEPS: usize = MAX_STEPS;

    /// The patch with these rows of control points, `i = 0, …, p`.
    ///
    /// # Errors
    /// [`Error::WrongShape`] if there is no point, the rows differ in length,
    /// or the points in dimension.
    pub fn from_rows(rows: Vec<Vec<Vec<C>>>, frame: Rectangle<C>) -> Result<Self, Error> {
        let length = rows.first().map_or(0, Vec::len);
        if length == 0 {
            return Err(Error::WrongShape("a rectangular net needs at least one point".into()));
        }
        if let Some((index, row)) = rows.iter().enumerate().find(|(_, row)| row.len() != length) {
            return Err(Error::WrongShape(format!(
                "row {index} of the rectangular net has {} points, row 0 has {length}: all must have the same number",
                row.len()
            )));
        }
        let degrees = (rows.len() - 1, length - 1);
        Self::from_points(degrees, rows.into_iter().flatten().collect(), frame)
    }

    /// The patch of bidegree `(p, q)` with these control points, row by row.
    ///
    /// # Errors
    /// [`Error::WrongCount`] unless there are `(p+1)(q+1)` points;
    /// [`Error::WrongShape`] if they are not all of one dimension.
    pub fn from_points((p, q): (usize, usize), points: Vec<Vec<C>>, frame: Rectangle<C>) -> Result<Self, Error> {
        let expected = count(&Shape::rectangle(p, q, 1));
        if points.len() != expected {
            return Err(Error::WrongCount { what: "control points", expected, found: points.len() });
        }
        Ok(Self { net: ControlNet::from_points(|dimension| Shape::rectangle(p, q, dimension), points)?, frame })
    }

    pub(crate) fn from_net(net: ControlNet<C>, frame: Rectangle<C>) -> Self {
        debug_assert_eq!(net.coordinates.len(), net.shape.points() * net.shape.stride);
        Self { net, frame }
    }

    pub(crate) fn net(&self) -> &ControlNet<C> {
        &self.net
    }

    /// The bidegree `(p, q)`.
    #[must_use]
    pub fn degree(&self) -> (usize, usize) {
        (self.net.shape.factors[0].degree, self.net.shape.factors[1].degree)
    }

    /// The number of coordinates.
    #[must_use]
    pub fn dimension(&self) -> usize {
        self.net.dimension()
    }

    /// The frames.
    #[must_use]
    pub fn frame(&self) -> &Rectangle<C> {
        &self.frame
    }

    fn interval(&self, axis: Axis) -> &Interval<C> {
        match axis {
            Axis::U => self.frame.u(),
            Axis::V => self.frame.v(),
        }
    }

    /// The coordinates of all control points, point by point.
    #[must_use]
    pub fn coordinates(&self) -> &[C] {
        &self.net.coordinates
    }

    /// The control point `b_ij`.
    ///
    /// # Panics
    /// If an index is larger than its degree.
    #[must_use]
    pub fn point(&self, i: usize, j: usize) -> &[C] {
        let (p, q) = self.degree();
        assert!(i <= p && j <= q, "a net of bidegree ({p}, {q}) has no point ({i}, {j})");
        self.net.point(i * (q + 1) + j)
    }

    /// The polar label of `b_ij`, such as `f(r1,s1;r2,r2)`.
    ///
    /// # Panics
    /// If an index is larger than its degree.
    #[must_use]
    pub fn label(&self, i: usize, j: usize) -> String {
        let (p, q) = self.degree();
        bidegree_label(&[("r1", remaining(p, [i])), ("s1", i)], &[("r2", remaining(q, [j])), ("s2", j)])
    }

    /// The control points, row by row.
    pub fn points(&self) -> impl DoubleEndedIterator<Item = &[C]> + ExactSizeIterator + Clone {
        self.net.points()
    }

    /// The rows of control points.
    pub fn rows(&self) -> impl Iterator<Item = impl DoubleEndedIterator<Item = &[C]> + ExactSizeIterator + Clone> {
        let row = (self.degree().1 + 1) * self.dimension();
        self.net.coordinates.chunks_exact(row).map(|row| row.chunks_exact(self.dimension()))
    }

    /// The equation of the surface.
    ///
    /// # Errors
    /// [`Error::Unsupported`] if the length of a frame is symbolic.
    pub fn surface(&self) -> Result<Surface<C>, Error> {
        let line = Parameter::line();
        let (p, q) = self.degree();
        let coefficients = self.net.equation(&[self.frame.u().weights(&line)?, self.frame.v().weights(&line)?])?;
        Ok(Surface::from_coefficients(Reading::Bidegree(p, q), self.dimension(), coefficients))
    }

    /// The control points over other frames: the polar values at their vertices.
    ///
    /// # Errors
    /// [`Error::Unsupported`] if the length of a present frame is symbolic.
    pub fn reframe(&self, frame: &Rectangle<C>) -> Result<Self, Error> {
        let ends = [frame.u().r(), frame.u().s(), frame.v().r(), frame.v().s()];
        if ends.iter().any(|end| end.as_rational().is_none()) {
            return self.surface()?.over_rectangle(frame);
        }
        let (u, v) = (self.frame.u(), self.frame.v());
        let net = self.net.over(&[u.weights(&frame.u().ends())?, v.weights(&frame.v().ends())?])?;
        Ok(Self { net, frame: frame.clone() })
    }

    /// The polar value `f(u_1, …, u_p; v_1, …, v_q)` at numbers or homogeneous arguments.
    ///
    /// # Errors
    /// [`Error::WrongCount`] for other numbers of arguments;
    /// [`Error::Unsupported`] if the length of a frame is symbolic.
    pub fn blossom(&self, us: &[Parameter<C>], vs: &[Parameter<C>]) -> Result<Vec<C>, Error> {
        let (p, q) = self.degree();
        if (us.len(), vs.len()) != (p, q) {
            return Err(Error::WrongCount { what: "polar arguments", expected: p + q, found: us.len() + vs.len() });
        }
        Ok(self.net.polar_value(&[self.frame.u().weights(us)?, self.frame.v().weights(vs)?]).coordinates)
    }

    /// The point `F(u, v)`, inside the frame or not.
    ///
    /// # Errors
    /// [`Error::Unsupported`] if the length of a frame is symbolic.
    pub fn value(&self, [u, v]: &[C; 2]) -> Result<Vec<C>, Error> {
        let (p, q) = self.degree();
        self.blossom(&vec![Parameter::from(u.clone()); p], &vec![Parameter::from(v.clone()); q])
    }

    /// De Casteljau's algorithm in one parameter, then in the other, with all
    /// intermediate points (MA323, day 25, section 3).
    ///
    /// # Errors
    /// [`Error::Unsupported`] if the length of a frame is symbolic.
    pub fn two_steps(&self, at: &[C; 2], first: Axis) -> Result<TwoSteps<C>, Error> {
        TwoSteps::of(self, at, first)
    }

    /// De Casteljau's algorithm in both parameters at once, by bilinear
    /// interpolation, with all intermediate points; where the degrees differ,
    /// the algorithm of curves finishes it (MA323, day 25, section 4).
    ///
    /// # Errors
    /// [`Error::Unsupported`] if the length of a frame is symbolic.
    pub fn common_steps(&self, at: &[C; 2]) -> Result<CommonSteps<C>, Error> {
        CommonSteps::of(self, at)
    }

    pub(crate) fn argument(&self, axis: Axis, at: &C) -> Result<Weights<C>, Error> {
        self.interval(axis).weights(&[Parameter::from(at.clone())])
    }

    /// The two parts of the net on either side of a parameter, where they have width.
    ///
    /// # Errors
    /// [`Error::Unsupported`] if the length of the frame is symbolic.
    pub fn split_axis(&self, axis: Axis, at: &C) -> Result<[Option<Self>; 2], Error> {
        let interval = self.interval(axis);
        let weights = self.argument(axis, at)?;
        // The part toward an end keeps that end and has the parameter in place of the other.
        let parts = [(1, interval.r().clone(), at.clone()), (0, at.clone(), interval.s().clone())];
        let replaced: Vec<usize> = parts.iter().filter(|(_, r, s)| r != s).map(|part| part.0).collect();
        let mut nets = self.net.faces(axis.factor(), &weights, &replaced).into_iter();
        let halves = parts.map(|(_, r, s)| {
            let part = Interval::new(r, s).ok()?;
            let frame = match axis {
                Axis::U => Rectangle::new(part, self.frame.v().clone()),
                Axis::V => Rectangle::new(self.frame.u().clone(), part),
            };
            nets.next().map(|net| Self { net, frame })
        });
        Ok(halves)
    }

    /// The nets of the four rectangles that meet at `(u, v)`.
    ///
    /// # Errors
    /// [`Error::Unsupported`] if the length of a frame is symbolic.
    pub fn split(&self, at: &[C; 2]) -> Result<Quartering<C>, Error> {
        let quarters = self.split_axis(Axis::U, &at[0])?.map(|half| match half {
            Some(half) => half.split_axis(Axis::V, &at[1]),
            None => Ok([None, None]),
        });
        let [lower, upper] = quarters;
        let ([ll, lr], [rl, rr]) = (lower?, upper?);
        Ok(Quartering { point: self.value(at)?, ll, rl, lr, rr })
    }

    /// The nets of `depth` rounds of subdivision in the middle of both frames,
    /// `4^depth`, row by row.
    ///
    /// # Errors
    /// [`Error::TooLarge`] above [`RectangularPatch::MAX_DEPTH`] or
    /// [`RectangularPatch::MAX_STEPS`]; [`Error::Unsupported`] if the length of
    /// a frame is symbolic.
    pub fn subdivide(&self, depth: usize) -> Result<Vec<Self>, Error> {
        self.net.check_subdivision(depth, Self::MAX_DEPTH)?;
        let half = C::from(Rational::new(1, 2));
        let strips = |pieces: Vec<Self>, axis| {
            let mut pieces = pieces;
            for _ in 0..depth {
                let mut parts = Vec::with_capacity(2 * pieces.len());
                for piece in &pieces {
                    parts.extend(piece.split_axis(axis, &piece.interval(axis).at(&half))?.into_iter().flatten());
                }
                pieces = parts;
            }
            Ok::<_, Error>(pieces)
        };
        let mut all = Vec::new();
        for row in strips(vec![self.clone()], Axis::U)? {
            all.extend(strips(vec![row], Axis::V)?);
        }
        Ok(all)
    }

    /// The curve where one parameter is constant, over the frame of the other.
    ///
    /// # Errors
    /// [`Error::Unsupported`] if the length of the frame is symbolic.
    pub fn iso(&self, constant: Axis, at: &C) -> Result<Segment<C>, Error> {
        let degree = self.net.shape.factors[constant.factor()].degree;
        let weights = self.argument(constant, at)?.repeated(degree);
        let arguments = if constant == Axis::U { [weights, Weights::default()] } else { [Weights::default(), weights] };
        let coordinates = self.net.polar_value(&arguments).coordinates;
        Segment::new(self.dimension(), coordinates, self.interval(constant.other()).clone())
    }

    /// The curve along the line from `a` to `b` of the parameter plane, of
    /// degree `p + q`, over `0..1`; see [`Surface::segment`].
    ///
    /// # Errors
    /// As for [`Surface::segment`].
    pub fn segment(&self, a: &[C; 2], b: &[C; 2]) -> Result<Segment<C>, Error> {
        self.surface()?.segment(a, b)
    }

    /// The curve along the diagonal of the frame, from `(r1, r2)` to `(s1, s2)`.
    ///
    /// # Errors
    /// As for [`Surface::segment`].
    pub fn diagonal(&self) -> Result<Segment<C>, Error> {
        let (u, v) = (self.frame.u(), self.frame.v());
        self.segment(&[u.r().clone(), v.r().clone()], &[u.s().clone(), v.s().clone()])
    }

    /// The same map with the degrees this much higher.
    ///
    /// # Errors
    /// [`Error::TooLarge`] above [`RectangularPatch::MAX_STEPS`].
    pub fn elevate(&self, in_u: usize, in_v: usize) -> Result<Self, Error> {
        Ok(Self { net: self.net.elevate(&[in_u, in_v])?, frame: self.frame.clone() })
    }

    /// The same map with as few control points as it can have.
    ///
    /// # Errors
    /// [`Error::Unsupported`] if the length of a frame is symbolic.
    pub fn reduce(&self) -> Result<RectangularReduction<C>, Error> {
        let surface = self.surface()?;
        let (p, q) = surface.true_bidegree();
        let patch =
            if (p, q) == self.degree() { self.clone() } else { surface.read_as(Reading::Bidegree(p, q))?.over_rectangle(&self.frame)? };
        Ok(RectangularReduction { true_degree: (p, q), total_degree: surface.true_total_degree(), zero: surface.is_zero(), patch })
    }

    /// The partial derivative in one parameter, a patch of vectors over the
    /// same frames, of a degree one lower in that parameter.
    ///
    /// # Errors
    /// [`Error::Unsupported`] if the length of the frame is symbolic.
    pub fn partial(&self, axis: Axis) -> Result<Self, Error> {
        let net = self.net.derivative(axis.factor(), || self.interval(axis).weights(&[Parameter::direction()]))?;
        Ok(Self { net, frame: self.frame.clone() })
    }

    /// The product with another patch over the same frames; see
    /// [`TriangularPatch::product`](crate::TriangularPatch::product).
    ///
    /// # Errors
    /// [`Error::WrongShape`] if the frames differ, or the dimensions do and neither is 1.
    pub fn product(&self, other: &Self) -> Result<Self, Error> {
        if self.frame != other.frame {
            return Err(Error::WrongShape("a product needs both patches over the same frames; reframe one of them first".into()));
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
    /// their frames and bidegrees.
    ///
    /// # Errors
    /// [`Error::Unsupported`] if the length of a frame is symbolic.
    pub fn same_map(&self, other: &Self) -> Result<bool, Error> {
        Ok(self.surface()?.same_map(&other.surface()?))
    }

    /// The net with its points in another order: entry `(i, j)` is the point
    /// that `source` names, which must be in the net.
    pub(crate) fn rearranged(&self, (p, q): (usize, usize), source: impl Fn(usize, usize) -> (usize, usize)) -> ControlNet<C> {
        let mut coordinates = Vec::with_capacity(self.net.coordinates.len());
        for i in 0..=p {
            for j in 0..=q {
                let (from_i, from_j) = source(i, j);
                coordinates.extend_from_slice(self.point(from_i, from_j));
            }
        }
        ControlNet { shape: Shape::rectangle(p, q, self.dimension()), coordinates }
    }
}
