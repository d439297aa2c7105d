//! Control nets over products of simplices: what segments and patches have in common.

use std::borrow::Cow;

use smallvec::SmallVec;

use crate::affine::{AffineMap, Weights};
use crate::error::Error;
use crate::exact::Rational;
use crate::kernel::coefficient::Coefficient;
use crate::kernel::integers::{IntegerSlice, Integers};
use crate::kernel::layout::Layout;
use crate::kernel::reframe::Reframe;
use crate::kernel::shape::{Factor, Shape};
use crate::kernel::task::{Casteljau, ChangeDegree, ChangeFrame, Edge, Faces, Grid, PolarValue, Product};

/// The most steps on one coordinate that a subdivision or an elevation may take.
pub(crate) const MAX_STEPS: usize = 1 << 25;

/// The most rounds of subdivision of a patch that are carried out at once.
pub(crate) const MAX_PATCH_DEPTH: usize = 10;

/// How many numbers stand in a shape that may be too large to be made.
pub(crate) fn count(shape: &Shape) -> usize {
    shape.factors.iter().fold(shape.stride, |numbers, factor| {
        let entries = (1..=factor.dimension).fold(1usize, |entries, k| entries.saturating_mul(factor.degree.saturating_add(k)) / k);
        numbers.saturating_mul(entries)
    })
}

/// The control points of a map, point by point in the order of the shape.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct ControlNet<C> {
    pub(crate) shape: Shape,
    pub(crate) coordinates: Vec<C>,
}

/// What the numbers of a change of frame are.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Data {
    /// The coefficients of an equation.
    Equation,
    /// Control points.
    Net,
}

/// The plans for bringing every factor over new vertices. Appends their parameters.
#[inline(always)]
fn plans<C: Coefficient>(
    shape: &Shape,
    vertices: &[Weights<C>],
    parameters: &mut Integers<C>,
    reframes: &mut SmallVec<[Reframe; 2]>,
) -> Result<(), Error> {
    for (factor, vertices) in vertices.iter().enumerate() {
        let size = shape.factors[factor].dimension + 1;
        let Some(reframe) = Reframe::new(factor, size, vertices.rows.as_slice(), parameters) else {
            return Err(Error::DegenerateFrame("the new frame is degenerate: its vertices are dependent".into()));
        };
        reframes.push(reframe);
    }
    Ok(())
}

/// Brings an equation or a net over new vertices, one set for every factor;
/// the result is an equation or a net likewise.
///
/// # Errors
/// [`Error::DegenerateFrame`] if the new vertices are dependent.
// Inline wherever it is called from: what the data is and is to be is known there.
#[inline(always)]
pub(crate) fn change_frame<C: Coefficient>(
    shape: &Shape,
    (from, numbers): (Data, &[C]),
    vertices: &[Weights<C>],
    to: Data,
) -> Result<Vec<C>, Error> {
    let mut parameters = Integers::default();
    let mut change = ChangeFrame { shape: *shape, reframes: SmallVec::new(), from_form: from == Data::Equation };
    plans(shape, vertices, &mut parameters, &mut change.reframes)?;
    let mut joined = Integers::default();
    let scales = match vertices {
        [only] => &only.scales,
        _ => {
            vertices.iter().for_each(|vertices| joined.extend(vertices.scales.as_slice()));
            &joined
        }
    };
    let layout = Layout { multinomial: to == Data::Net, ..Layout::net(*shape, scales.as_slice()) };
    Ok(C::compute(&change, numbers, parameters.as_slice(), &[layout]))
}

/// The control points of the curve along the side opposite vertex 0 of the new
/// frame of a triangle, from its equation.
///
/// # Errors
/// [`Error::DegenerateFrame`] if the new vertices are dependent.
pub(crate) fn edge<C: Coefficient>(shape: &Shape, equation: &[C], vertices: &Weights<C>) -> Result<ControlNet<C>, Error> {
    let mut parameters = Integers::default();
    let mut change = ChangeFrame { shape: *shape, reframes: SmallVec::new(), from_form: true };
    plans(shape, std::slice::from_ref(vertices), &mut parameters, &mut change.reframes)?;
    let curve = Shape::curve(shape.factors[0].degree, shape.stride);
    let layout = Layout::form(curve, vertices.scales.as_slice().after(1));
    Ok(ControlNet { coordinates: C::compute(&Edge { change }, equation, parameters.as_slice(), &[layout]), shape: curve })
}

impl<C: Coefficient> ControlNet<C> {
    /// The net with these points.
    ///
    /// # Errors
    /// [`Error::WrongShape`] if a point has no coordinate or another number of
    /// them than the first.
    pub(crate) fn from_points(shape: impl FnOnce(usize) -> Shape, points: Vec<Vec<C>>) -> Result<Self, Error> {
        let dimension = points.first().map_or(0, Vec::len);
        if dimension == 0 {
            return Err(Error::WrongShape("control points need at least one coordinate".into()));
        }
        if let Some(odd) = points.iter().position(|point| point.len() != dimension) {
            return Err(Error::WrongShape(format!(
                "point {odd} has {} coordinates, point 0 has {dimension}: all must have the same number",
                points[odd].len()
            )));
        }
        Ok(Self { shape: shape(dimension), coordinates: points.into_iter().flatten().collect() })
    }

    pub(crate) fn dimension(&self) -> usize {
        self.shape.stride
    }

    pub(crate) fn point(&self, index: usize) -> &[C] {
        &self.coordinates[index * self.dimension()..(index + 1) * self.dimension()]
    }

    pub(crate) fn points(&self) -> impl DoubleEndedIterator<Item = &[C]> + ExactSizeIterator + Clone {
        self.coordinates.chunks_exact(self.dimension())
    }

    /// The net over other vertices.
    pub(crate) fn over(&self, vertices: &[Weights<C>]) -> Result<Self, Error> {
        let coordinates = change_frame(&self.shape, (Data::Net, &self.coordinates), vertices, Data::Net)?;
        Ok(Self { shape: self.shape, coordinates })
    }

    /// The coefficients of the equation, given the origin and the directions
    /// as combinations of the vertices.
    pub(crate) fn equation(&self, vertices: &[Weights<C>]) -> Result<Vec<C>, Error> {
        change_frame(&self.shape, (Data::Net, &self.coordinates), vertices, Data::Equation)
    }

    /// The net that is left when arguments are taken in, those of each factor.
    pub(crate) fn polar_value(&self, arguments: &[Weights<C>]) -> Self {
        let (mut parameters, mut divisors) = (Integers::default(), Integers::default());
        let (mut shape, mut counts) = (self.shape, SmallVec::new());
        for (factor, own) in shape.factors.iter_mut().zip(arguments) {
            parameters.extend(own.rows.as_slice());
            divisors.extend(own.scales.as_slice());
            counts.push(own.scales.as_slice().len());
            factor.degree -= own.scales.as_slice().len();
        }
        let task = PolarValue { shape: self.shape, counts };
        let layout = Layout::constant(shape, divisors.as_slice());
        Self { shape, coordinates: C::compute(&task, &self.coordinates, parameters.as_slice(), &[layout]) }
    }

    /// The derivative in a direction of one factor: the degree times the net
    /// that is left when that vector is taken in. A net of degree 0 asks for no vector.
    ///
    /// # Errors
    /// Those of the direction.
    pub(crate) fn derivative(&self, factor: usize, direction: impl FnOnce() -> Result<Weights<C>, Error>) -> Result<Self, Error> {
        let degree = self.shape.factors[factor].degree;
        if degree == 0 {
            return Ok(Self { shape: self.shape, coordinates: vec![C::nothing(); self.coordinates.len()] });
        }
        let mut arguments = vec![Weights::default(); self.shape.factors.len()];
        arguments[factor] = direction()?;
        let mut net = self.polar_value(&arguments);
        let degree = C::from(Rational::from(degree));
        net.coordinates.iter_mut().for_each(|coordinate| coordinate.multiply(&degree));
        Ok(net)
    }

    /// All steps of de Casteljau's algorithm in one factor: a net with the
    /// argument as one more vertex, vertex 1.
    pub(crate) fn scheme(&self, factor: usize, argument: &Weights<C>) -> Self {
        let mut shape = self.shape;
        shape.factors[factor].dimension += 1;
        let scales = self.scales_with(argument, &shape, (factor, 1));
        let layout = Layout::net(shape, scales.as_slice());
        let task = Casteljau { shape: self.shape, factor };
        Self { shape, coordinates: C::compute(&task, &self.coordinates, argument.rows.as_slice(), &[layout]) }
    }

    /// The nets with the argument in place of each of these vertices of a factor.
    pub(crate) fn faces(&self, factor: usize, argument: &Weights<C>, replaced: &[usize]) -> Vec<Self> {
        let scales: Vec<Integers<C>> = replaced.iter().map(|&vertex| self.scales_with(argument, &self.shape, (factor, vertex))).collect();
        let layouts: Vec<Layout<'_, C>> = scales.iter().map(|scales| Layout::net(self.shape, scales.as_slice())).collect();
        let task = Faces { shape: self.shape, factor, replaced: replaced.into() };
        let mut coordinates = C::compute(&task, &self.coordinates, argument.rows.as_slice(), &layouts);
        let mut faces = Vec::with_capacity(replaced.len());
        for _ in replaced {
            let rest = coordinates.split_off(self.coordinates.len());
            faces.push(Self { shape: self.shape, coordinates });
            coordinates = rest;
        }
        faces
    }

    /// The scales of the vertices of a shape, all 1 but that of an argument in one place.
    fn scales_with(&self, argument: &Weights<C>, shape: &Shape, place: (usize, usize)) -> Integers<C> {
        let mut scales = Integers::default();
        for (factor, Factor { dimension, .. }) in shape.factors.iter().enumerate() {
            for vertex in 0..=*dimension {
                if (factor, vertex) == place { scales.extend(argument.scales.as_slice()) } else { scales.push_word(1) }
            }
        }
        scales
    }

    /// The points of the map on a regular grid of the frame: in each factor the
    /// combinations of the vertices with weights `k/steps`, in the order of a
    /// net of degree `steps`.
    pub(crate) fn grid(&self, steps: usize) -> Self {
        let shape = Grid::target(&self.shape, steps);
        let divisors = vec![steps as i64; self.total_degree()];
        let layout = Layout::constant(shape, IntegerSlice::Words(&divisors));
        let task = Grid { shape: self.shape, steps };
        Self { coordinates: C::compute(&task, &self.coordinates, IntegerSlice::NONE, &[layout]), shape }
    }

    /// The degrees of all factors together.
    fn total_degree(&self) -> usize {
        self.shape.factors.iter().map(|factor| factor.degree).sum()
    }

    /// Whether this many rounds of subdivision in the middle are within the
    /// limits: at most so many rounds, and one step for each level of de
    /// Casteljau's algorithm and each coordinate of a control point.
    ///
    /// # Errors
    /// [`Error::TooLarge`] if not.
    pub(crate) fn check_subdivision(&self, depth: usize, most: usize) -> Result<(), Error> {
        if depth > most {
            return Err(Error::TooLarge { what: "depth of subdivision", limit: most });
        }
        // Every round doubles the pieces in each dimension of the parameters.
        let dimension: usize = self.shape.factors.iter().map(|factor| factor.dimension).sum();
        let pieces = (0..dimension).fold(1usize, |pieces, _| pieces.saturating_mul(1 << depth));
        let steps = self.coordinates.len().saturating_mul(pieces).saturating_mul(self.total_degree() + 1);
        if steps > MAX_STEPS {
            return Err(Error::TooLarge { what: "subdivision, counted in steps,", limit: MAX_STEPS });
        }
        Ok(())
    }

    /// The same map with a degree this much higher in each factor.
    ///
    /// # Errors
    /// [`Error::TooLarge`] for more than [`MAX_STEPS`]: one for each degree and
    /// each coordinate of a new control point, whose numbers are as long as the
    /// degree is high before they are divided.
    pub(crate) fn elevate(&self, by: &[usize]) -> Result<Self, Error> {
        if by.iter().all(|&more| more == 0) {
            return Ok(self.clone());
        }
        let (mut shape, mut levels) = (self.shape, 1usize);
        for (factor, &more) in shape.factors.iter_mut().zip(by) {
            factor.degree = factor.degree.saturating_add(more);
            levels = levels.saturating_add(factor.degree);
        }
        if count(&shape).saturating_mul(levels) > MAX_STEPS {
            return Err(Error::TooLarge { what: "elevation, counted in steps,", limit: MAX_STEPS });
        }
        let mut net = Cow::Borrowed(self);
        for (factor, _) in by.iter().enumerate().filter(|(_, more)| **more > 0) {
            net = Cow::Owned(net.with_degree(factor, shape.factors[factor].degree));
        }
        Ok(net.into_owned())
    }

    /// The same map with another degree in a factor: a higher one, or for a
    /// curve a lower one that it is known to have.
    pub(crate) fn with_degree(&self, factor: usize, degree: usize) -> Self {
        let task = ChangeDegree { shape: self.shape, factor, degree };
        let shape = self.shape.with_degree(factor, degree);
        let coordinates = C::compute(&task, &self.coordinates, IntegerSlice::NONE, &[Layout::form(shape, IntegerSlice::NONE)]);
        Self { shape, coordinates }
    }

    /// The product, coordinate by coordinate; a map with one coordinate
    /// multiplies every coordinate of the other.
    ///
    /// # Errors
    /// [`Error::WrongShape`] if the dimensions differ and neither is 1.
    pub(crate) fn product(&self, other: &Self) -> Result<Self, Error> {
        let (a, b) = (self.dimension(), other.dimension());
        if a != b && a != 1 && b != 1 {
            return Err(Error::WrongShape(format!("a product needs equal dimensions, or one that is 1; found {a} and {b}")));
        }
        let mut shape = Shape { stride: a.max(b), ..self.shape };
        for (factor, more) in shape.factors.iter_mut().zip(other.shape.factors.iter()) {
            factor.degree += more.degree;
        }
        let mut factor = Weights::default();
        factor.push(&other.coordinates);
        let layout = Layout { divisors: factor.scales.as_slice(), ..Layout::form(shape, IntegerSlice::NONE) };
        let task = Product { first: self.shape, second: other.shape };
        Ok(Self { coordinates: C::compute(&task, &self.coordinates, factor.rows.as_slice(), &[layout]), shape })
    }

    /// The image under an affine map: the images of the control points.
    ///
    /// # Errors
    /// [`Error::WrongCount`] if the map takes points of another dimension.
    pub(crate) fn transform(&self, map: &AffineMap<C>) -> Result<Self, Error> {
        let mut coordinates = Vec::with_capacity(self.shape.points() * map.target_dimension());
        for point in self.points() {
            coordinates.extend(map.apply(point)?);
        }
        Ok(Self { shape: Shape { stride: map.target_dimension(), ..self.shape }, coordinates })
    }
}
