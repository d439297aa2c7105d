//! Control nets over products of simplices: what segments and patches have in common.

use smallvec::SmallVec;

use crate::affine::{AffineMap, Vertices, Weights};
use crate::error::Error;
use crate::exact::Rational;
use crate::kernel::coefficient::Coefficient;
use crate::kernel::layout::Layout;
use crate::kernel::reframe::Reframe;
use crate::kernel::shape::{Factor, Shape};
use crate::kernel::task::{Casteljau, ChangeDegree, ChangeFrame, Edge, Faces, Grid, PolarValue, Product};

/// The control points of a map, point by point in the order of the shape.
#[derive(Clone, Debug, PartialEq)]
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

/// The plan of a change of frame with its parameters, and the scales of the new vertices.
struct Plan<C> {
    change: ChangeFrame,
    parameters: SmallVec<[C; 12]>,
    scales: SmallVec<[C; 3]>,
}

fn plan<C: Coefficient>(shape: &Shape, data: Data, vertices: impl IntoIterator<Item = Vertices<C>>) -> Result<Plan<C>, Error> {
    let mut reframes = SmallVec::new();
    let mut parameters = SmallVec::new();
    let mut scales = SmallVec::new();
    for (factor, vertices) in vertices.into_iter().enumerate() {
        let size = shape.factors[factor].dimension + 1;
        let (reframe, own) = Reframe::new(factor, size, vertices.rows)
            .ok_or_else(|| Error::DegenerateFrame("the new frame is degenerate: its vertices are dependent".into()))?;
        reframes.push(reframe);
        parameters.extend(own);
        scales.extend(vertices.scales);
    }
    Ok(Plan { change: ChangeFrame { shape: shape.clone(), reframes, from_form: data == Data::Equation }, parameters, scales })
}

/// Brings an equation or a net over new vertices, one set for every factor;
/// the result is an equation or a net likewise.
///
/// # Errors
/// [`Error::DegenerateFrame`] if the new vertices are dependent.
pub(crate) fn change_frame<C: Coefficient>(
    shape: &Shape,
    (from, numbers): (Data, &[C]),
    vertices: impl IntoIterator<Item = Vertices<C>>,
    to: Data,
) -> Result<Vec<C>, Error> {
    let Plan { change, parameters, scales } = plan(shape, from, vertices)?;
    let layout = Layout { shape: shape.clone(), scales, multinomial: to == Data::Net, constant: C::unit(), divisors: SmallVec::new() };
    Ok(C::compute(&change, numbers, &parameters, &[layout]))
}

/// The control points of the curve along the side opposite vertex 0 of the new
/// frame of a triangle, from its equation.
///
/// # Errors
/// [`Error::DegenerateFrame`] if the new vertices are dependent.
pub(crate) fn edge<C: Coefficient>(shape: &Shape, equation: &[C], vertices: Vertices<C>) -> Result<ControlNet<C>, Error> {
    let Plan { change, parameters, mut scales } = plan(shape, Data::Equation, [vertices])?;
    scales.remove(0);
    let curve = Shape::curve(shape.factors[0].degree, shape.stride);
    let layout = Layout { scales, ..Layout::form(curve.clone()) };
    Ok(ControlNet { coordinates: C::compute(&Edge { change }, equation, &parameters, &[layout]), shape: curve })
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
    pub(crate) fn over(&self, vertices: impl IntoIterator<Item = Vertices<C>>) -> Result<Self, Error> {
        let coordinates = change_frame(&self.shape, (Data::Net, &self.coordinates), vertices, Data::Net)?;
        Ok(Self { shape: self.shape.clone(), coordinates })
    }

    /// The coefficients of the equation, given the origin and the directions
    /// as combinations of the vertices.
    pub(crate) fn equation(&self, vertices: impl IntoIterator<Item = Vertices<C>>) -> Result<Vec<C>, Error> {
        change_frame(&self.shape, (Data::Net, &self.coordinates), vertices, Data::Equation)
    }

    /// The net that is left when arguments are taken in, lists of them for each factor.
    pub(crate) fn polar_value(&self, arguments: &[Vec<Weights<C>>]) -> Self {
        let mut divisors = SmallVec::new();
        let mut parameters = Vec::new();
        let mut shape = self.shape.clone();
        for (factor, list) in shape.factors.iter_mut().zip(arguments) {
            factor.degree -= list.len();
            for argument in list {
                parameters.extend_from_slice(&argument.weights);
                divisors.push(argument.scale.clone());
            }
        }
        let task = PolarValue { shape: self.shape.clone(), counts: arguments.iter().map(Vec::len).collect() };
        let layout = Layout { divisors, ..Layout::constant(shape.clone(), C::unit()) };
        Self { shape, coordinates: C::compute(&task, &self.coordinates, &parameters, &[layout]) }
    }

    /// The derivative in a direction of one factor: the degree times the net
    /// that is left when that vector is taken in. A net of degree 0 asks for no vector.
    ///
    /// # Errors
    /// Those of the direction.
    pub(crate) fn derivative(&self, factor: usize, direction: impl FnOnce() -> Result<Weights<C>, Error>) -> Result<Self, Error> {
        let degree = self.shape.factors[factor].degree;
        if degree == 0 {
            return Ok(Self { shape: self.shape.clone(), coordinates: vec![C::nothing(); self.coordinates.len()] });
        }
        let mut arguments = vec![Vec::new(); self.shape.factors.len()];
        arguments[factor].push(direction()?);
        let mut net = self.polar_value(&arguments);
        let degree = C::from(Rational::from(degree as i64));
        net.coordinates.iter_mut().for_each(|coordinate| coordinate.multiply(&degree));
        Ok(net)
    }

    /// All steps of de Casteljau's algorithm in one factor: a net with the
    /// argument as one more vertex, vertex 1.
    pub(crate) fn scheme(&self, factor: usize, argument: &Weights<C>) -> Self {
        let mut shape = self.shape.clone();
        shape.factors[factor].dimension += 1;
        let mut scales: SmallVec<[C; 3]> = SmallVec::new();
        for (position, Factor { dimension, .. }) in self.shape.factors.iter().enumerate() {
            let start = scales.len();
            scales.resize(start + dimension + 1, C::unit());
            if position == factor {
                scales.insert(start + 1, argument.scale.clone());
            }
        }
        let layout = Layout { shape: shape.clone(), scales, multinomial: false, constant: C::unit(), divisors: SmallVec::new() };
        let task = Casteljau { shape: self.shape.clone(), factor };
        Self { shape, coordinates: C::compute(&task, &self.coordinates, &argument.weights, &[layout]) }
    }

    /// The nets with the argument in place of each of these vertices of a factor.
    pub(crate) fn faces(&self, factor: usize, argument: &Weights<C>, replaced: &[usize]) -> Vec<Self> {
        let first: usize = self.shape.factors[..factor].iter().map(|factor| factor.dimension + 1).sum();
        let all: usize = self.shape.factors.iter().map(|factor| factor.dimension + 1).sum();
        let layouts: Vec<Layout<C>> = replaced
            .iter()
            .map(|vertex| {
                let mut scales = SmallVec::from_elem(C::unit(), all);
                scales[first + vertex] = argument.scale.clone();
                Layout { shape: self.shape.clone(), scales, multinomial: false, constant: C::unit(), divisors: SmallVec::new() }
            })
            .collect();
        let task = Faces { shape: self.shape.clone(), factor, replaced: replaced.into() };
        let mut coordinates = C::compute(&task, &self.coordinates, &argument.weights, &layouts);
        let mut faces = Vec::with_capacity(replaced.len());
        for _ in replaced {
            let rest = coordinates.split_off(self.coordinates.len());
            faces.push(Self { shape: self.shape.clone(), coordinates });
            coordinates = rest;
        }
        faces
    }

    /// The points of the map on a regular grid of the frame: in each factor the
    /// combinations of the vertices with weights `k/steps`, in the order of a
    /// net of degree `steps`.
    pub(crate) fn grid(&self, steps: usize) -> Self {
        let shape = Grid::target(&self.shape, steps);
        let divisor = C::from(Rational::from(steps as i64));
        let degree: usize = self.shape.factors.iter().map(|factor| factor.degree).sum();
        let layout = Layout { divisors: SmallVec::from_elem(divisor, degree), ..Layout::constant(shape.clone(), C::unit()) };
        let task = Grid { shape: self.shape.clone(), steps };
        Self { coordinates: C::compute(&task, &self.coordinates, &[], &[layout]), shape }
    }

    /// The same map with another degree in a factor: a higher one, or for a
    /// curve a lower one that it is known to have.
    pub(crate) fn with_degree(&self, factor: usize, degree: usize) -> Self {
        let task = ChangeDegree { shape: self.shape.clone(), factor, degree };
        let shape = self.shape.with_degree(factor, degree);
        let coordinates = C::compute(&task, &self.coordinates, &[], &[Layout::form(shape.clone())]);
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
        let mut shape = Shape { stride: a.max(b), ..self.shape.clone() };
        for (factor, more) in shape.factors.iter_mut().zip(&other.shape.factors) {
            factor.degree += more.degree;
        }
        let (parameters, constant) = C::clear(&other.coordinates);
        let layout = Layout { constant, ..Layout::form(shape.clone()) };
        let task = Product { first: self.shape.clone(), second: other.shape.clone() };
        Ok(Self { coordinates: C::compute(&task, &self.coordinates, &parameters, &[layout]), shape })
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
        Ok(Self { shape: Shape { stride: map.target_dimension(), ..self.shape.clone() }, coordinates })
    }
}
