//! What a picture shows, in exact points of the plane.

use std::borrow::Cow;

use super::bezier::{Bezier, Point};
use super::space::Space;
use super::view::{Fit, View};
use crate::error::Error;
use crate::exact::Rational;
use crate::scheme::Scheme;
use crate::segment::Segment;

/// The largest degree whose steps are drawn.
const MAX_STEPS: usize = 12;

/// The curve and everything about it on the plane.
#[derive(Debug)]
pub(super) struct Scene {
    /// The places of the control points.
    control: Vec<Vec<Rational>>,
    /// The curve as it is drawn, which has as many control points, or one more for a constant graph.
    curve: Segment,
    /// The places of the points of de Casteljau's algorithm, if asked for.
    scheme: Option<Scheme>,
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
    pub(super) fn new(segment: &Segment, parameter: Option<&Rational>, [azimuth, elevation]: [i32; 2], top: f64) -> Result<Self, Error> {
        let place = parameter.map(|t| place_of(segment, t));
        let shown = |scheme: &Scheme| -> Vec<Vec<Rational>> {
            if steps_are_drawn(segment.degree()) {
                return scheme.layers().flat_map(|layer| layer.map(<[Rational]>::to_vec)).collect();
            }
            match place {
                Some(Place::Before) => scheme.left().map(<[Rational]>::to_vec).collect(),
                Some(Place::After) => scheme.right().map(<[Rational]>::to_vec).collect(),
                _ => Vec::new(),
            }
        };
        let (mut space, mut shadow) = (None, None);
        let curve = match segment.dimension() {
            // The graph of a constant is a line.
            1 => graph(&if segment.degree() == 0 { segment.elevate(1) } else { segment.clone() })?,
            2 => segment.clone(),
            3 => {
                let more = parameter.map(|t| segment.scheme(t)).transpose()?.as_ref().map_or_else(Vec::new, shown);
                let found = Space::new(segment.points().chain(more.iter().map(Vec::as_slice)), azimuth, elevation)?;
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
        let scheme = parameter.map(|t| curve.scheme(t)).transpose()?;
        let control = if curve.degree() == segment.degree() {
            curve.points().map(<[Rational]>::to_vec).collect()
        } else {
            vec![curve.value(&segment.frame().at(&Rational::new(1, 2)))?]
        };
        let extra = scheme.as_ref().map_or_else(Vec::new, shown);
        let corners = space.as_ref().map_or_else(|| Ok(Vec::new()), Space::corners)?;
        let fit = match segment.dimension() {
            1 => Fit::Free,
            2 => Fit::Equal,
            _ => Fit::Rigid,
        };
        let left = if space.is_some() { 20.0 } else { 62.0 };
        let view = View::of(curve.points().chain(extra.iter().chain(&corners).map(Vec::as_slice)), fit, [left, top]);
        Ok(Self { control, curve, scheme, shadow, space, view })
    }

    fn bezier<'a>(&self, points: impl Iterator<Item = &'a [Rational]>) -> Bezier {
        Bezier(points.map(|point| self.view.place(point)).collect())
    }

    /// The control points on the paper.
    pub(super) fn control(&self) -> Vec<Point> {
        self.control.iter().map(|point| self.view.place(point)).collect()
    }

    /// The curve over its frame.
    pub(super) fn curve(&self) -> Bezier {
        self.bezier(self.curve.points())
    }

    /// The shadow of the curve on the floor, and of its control points.
    pub(super) fn shadow(&self) -> Option<Bezier> {
        self.shadow.as_ref().map(|shadow| self.bezier(shadow.points()))
    }

    /// The layers of de Casteljau's algorithm on the paper, if they are few enough.
    pub(super) fn layers(&self) -> Vec<Vec<Point>> {
        match &self.scheme {
            Some(scheme) if steps_are_drawn(scheme.degree()) => {
                scheme.layers().map(|layer| layer.map(|point| self.view.place(point)).collect()).collect()
            }
            _ => Vec::new(),
        }
    }

    /// The point `F(t)` on the paper.
    pub(super) fn point(&self) -> Option<Point> {
        self.scheme.as_ref().map(|scheme| self.view.place(scheme.point()))
    }

    /// The curve from the frame on to a parameter outside of it.
    pub(super) fn beyond(&self) -> Option<Bezier> {
        let scheme = self.scheme.as_ref()?;
        match place_of(&self.curve, scheme.parameter()) {
            Place::Inside => None,
            Place::Before => Some(self.bezier(scheme.left())),
            Place::After => Some(self.bezier(scheme.right())),
        }
    }
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
