//! What a picture shows, in exact points of the plane.

use std::borrow::Cow;

use num_traits::Signed;

use super::axes::margin;
use super::bezier::{Bezier, Point};
use super::space::Space;
use super::view::{Fit, View};
use crate::error::Error;
use crate::exact::Rational;
use crate::segment::Segment;
use crate::weights::{homogeneous_points, projected};

/// The largest degree whose steps are drawn.
const MAX_STEPS: usize = 12;

/// The curve and everything about it on the plane.
#[derive(Debug)]
pub(super) struct Scene {
    /// The places of the control points.
    control: Vec<Vec<Rational>>,
    /// The curve as it is drawn, which has as many control points, or one more for a constant graph.
    curve: Segment,
    /// The weights of its control points, if it is rational.
    weights: Option<Vec<Rational>>,
    steps: Steps,
    /// The shadow of the curve on the floor.
    shadow: Option<Segment>,
    pub(super) space: Option<Space>,
    pub(super) view: View,
}

/// Where the parameter of the point `F(t)` is.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Place {
    Inside,
    Before,
    After,
}

/// The graph of a function: its control points lie over equally spaced
/// parameters, the polar values of `t` itself (Farin, *Curves and Surfaces for
/// CAGD*, the section on nonparametric curves).
fn graph(segment: &Segment) -> Result<Segment, Error> {
    let degree = segment.degree();
    let over = |index: usize| segment.frame().at(&Rational::new(index as i64, degree.max(1) as i64));
    let points = segment.points().enumerate().map(|(index, point)| {
        let mut place = vec![over(index)];
        place.extend_from_slice(point);
        place
    });
    Segment::from_points(points.collect(), segment.frame().clone())
}

fn mapped(segment: &Segment, map: impl Fn(&[Rational]) -> Result<Vec<Rational>, Error>) -> Result<Segment, Error> {
    Segment::from_points(segment.points().map(map).collect::<Result<_, _>>()?, segment.frame().clone())
}

impl Scene {
    pub(super) fn new(
        segment: &Segment,
        weights: Option<&[Rational]>,
        parameter: Option<&Rational>,
        [azimuth, elevation]: [i32; 2],
        top: f64,
    ) -> Result<Self, Error> {
        let (mut space, mut shadow) = (None, None);
        let curve = match segment.dimension() {
            1 if weights.is_some() => {
                return Err(Error::Unsupported(
                    "the graph of a quotient of polynomials is not drawn; a second coordinate makes it a curve".into(),
                ));
            }
            // The graph of a constant is a line.
            1 => graph(&if segment.degree() == 0 { segment.elevate(1)? } else { segment.clone() })?,
            2 => segment.clone(),
            3 => {
                let steps = Steps::of(segment, weights, parameter)?;
                let found = Space::new(segment.points().chain(steps.points()), azimuth, elevation)?;
                shadow = Some(mapped(segment, |point| found.flat(&found.below(point)))?);
                let curve = mapped(segment, |point| found.flat(point))?;
                space = Some(found);
                curve
            }
            dimension => {
                return Err(Error::Unsupported(format!(
                    "a picture needs 1, 2 or 3 coordinates, found {dimension}: project the curve first with `transform`"
                )));
            }
        };
        let steps = Steps::of(&curve, weights, parameter)?;
        let control = if curve.degree() == segment.degree() {
            curve.points().map(<[Rational]>::to_vec).collect()
        } else {
            vec![curve.value(&segment.frame().at(&Rational::new(1, 2)))?]
        };
        let corners = space.as_ref().map_or_else(|| Ok(Vec::new()), Space::corners)?;
        let fit = match segment.dimension() {
            1 => Fit::Free,
            2 => Fit::Equal,
            _ => Fit::Rigid,
        };
        // Above a box in space there is nothing to name.
        let top = if space.is_some() { top - 24.0 } else { top };
        let mut view = View::of(curve.points().chain(steps.points()).chain(corners.iter().map(Vec::as_slice)), fit, [0.0, top]);
        view.shift_right(if space.is_some() { 10.0 } else { margin(&view) });
        Ok(Self { control, curve, weights: weights.map(<[Rational]>::to_vec), steps, shadow, space, view })
    }

    fn bezier(&self, segment: &Segment, weights: Option<&[Rational]>) -> Bezier {
        let curve = Bezier::new(segment.points().map(|point| self.view.place(point)).collect());
        match weights {
            None => curve,
            Some(weights) => {
                // Only their ratios count, which keeps long numbers within the range of floats.
                let ratio = |weight: &Rational| weight.checked_div(&weights[0]).map_or(1.0, |ratio| ratio.approximate());
                curve.with_weights(weights.iter().map(ratio).collect())
            }
        }
    }

    /// The control points on the paper.
    pub(super) fn control(&self) -> Vec<Point> {
        self.control.iter().map(|point| self.view.place(point)).collect()
    }

    /// The curve over its frame.
    pub(super) fn curve(&self) -> Bezier {
        self.bezier(&self.curve, self.weights.as_deref())
    }

    /// The shadow of the curve on the floor, and of its control points.
    pub(super) fn shadow(&self) -> Option<Bezier> {
        self.shadow.as_ref().map(|shadow| self.bezier(shadow, self.weights.as_deref()))
    }

    /// The layers of de Casteljau's algorithm on the paper, if they are few enough.
    pub(super) fn layers(&self) -> Vec<Vec<Point>> {
        let layers = self.steps.layers.iter();
        layers.map(|layer| layer.iter().map(|point| self.view.place(point)).collect()).collect()
    }

    /// The point `F(t)` on the paper.
    pub(super) fn point(&self) -> Option<Point> {
        self.steps.point.as_ref().map(|point| self.view.place(point))
    }

    /// The curve between the frame and a parameter outside of it.
    pub(super) fn beyond(&self) -> Option<Bezier> {
        self.steps.beyond.as_ref().map(|(beyond, weights)| self.bezier(beyond, weights.as_deref()))
    }
}

/// The points of de Casteljau's algorithm that are drawn.
#[derive(Debug, Default)]
struct Steps {
    /// All layers, or none if they are too many.
    layers: Vec<Vec<Vec<Rational>>>,
    point: Option<Vec<Rational>>,
    /// The curve between the frame and a parameter outside of it.
    beyond: Option<(Segment, Option<Vec<Rational>>)>,
}

impl Steps {
    fn of(curve: &Segment, weights: Option<&[Rational]>, parameter: Option<&Rational>) -> Result<Self, Error> {
        let Some(t) = parameter else { return Ok(Self::default()) };
        let lifted = lifted(curve, weights)?;
        let shown = |point: &[Rational]| shown(point, weights.is_some());
        let layers = if steps_are_drawn(curve.degree()) {
            lifted.scheme(t)?.layers().map(|layer| layer.map(shown).collect()).collect::<Result<_, _>>()?
        } else {
            Vec::new()
        };
        let beyond = match place_of(curve, t) {
            Place::Inside => None,
            Place::Before => Some(lifted.split(t)?.0),
            Place::After => Some(lifted.split(t)?.1),
        };
        let beyond = match beyond {
            Some(beyond) if weights.is_some() => flattened(&beyond)?.map(|(beyond, weights)| (beyond, Some(weights))),
            beyond => beyond.map(|beyond| (beyond, None)),
        };
        Ok(Self { layers, point: Some(shown(&lifted.value(t)?)?), beyond })
    }

    fn points(&self) -> impl Iterator<Item = &[Rational]> + Clone {
        let beyond = self.beyond.iter().flat_map(|(beyond, _)| beyond.points());
        self.layers.iter().flatten().chain(&self.point).map(Vec::as_slice).chain(beyond)
    }
}

/// The segment that the algorithms run on: that of the homogeneous control points, if there are weights.
pub(super) fn lifted(segment: &Segment, weights: Option<&[Rational]>) -> Result<Segment, Error> {
    let Some(weights) = weights else { return Ok(segment.clone()) };
    let points: Vec<Vec<Rational>> = segment.points().map(<[Rational]>::to_vec).collect();
    Segment::from_points(homogeneous_points(&points, weights)?, segment.frame().clone())
}

/// The place of one of its points.
pub(super) fn shown(point: &[Rational], weighted: bool) -> Result<Vec<Rational>, Error> {
    if !weighted {
        return Ok(point.to_vec());
    }
    projected(point).ok_or_else(|| Error::Unsupported("a point of the picture is at infinity: its weight is 0".into()))
}

/// The control points of a homogeneous segment and their weights, if all of these have one
/// sign, so that nothing of the curve is at infinity.
pub(super) fn flattened(homogeneous: &Segment) -> Result<Option<(Segment, Vec<Rational>)>, Error> {
    let weights: Vec<Rational> = homogeneous.points().filter_map(|point| point.last().cloned()).collect();
    if !(weights.iter().all(Signed::is_positive) || weights.iter().all(Signed::is_negative)) {
        return Ok(None);
    }
    let points = homogeneous.points().map(|point| shown(point, true)).collect::<Result<_, _>>()?;
    Ok(Some((Segment::from_points(points, homogeneous.frame().clone())?, weights)))
}

/// Whether the shells of a curve of this degree are drawn.
pub(super) fn steps_are_drawn(degree: usize) -> bool {
    (1..=MAX_STEPS).contains(&degree)
}

/// Where a parameter lies.
pub(super) fn place_of(segment: &Segment, t: &Rational) -> Place {
    let frame = segment.frame();
    match (frame.contains(t), (t < frame.r()) == (frame.r() < frame.s())) {
        (true, _) => Place::Inside,
        (false, true) => Place::Before,
        (false, false) => Place::After,
    }
}

/// The name of a polynomial curve of a degree, with its article.
pub(super) fn kind(degree: usize) -> Cow<'static, str> {
    match degree {
        0 => "A constant".into(),
        1 => "A line".into(),
        2 => "A quadratic".into(),
        3 => "A cubic".into(),
        4 => "A quartic".into(),
        5 => "A quintic".into(),
        _ => format!("A curve of degree {degree}").into(),
    }
}
