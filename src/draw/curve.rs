//! Pictures of curves.

use super::arrow::arrow;
use super::axes::draw_axes;
use super::bezier::{Bezier, Point, distance, polygon};
use super::caption::Caption;
use super::feature::Features;
use super::label::{Obstacles, draw_labels};
use super::mark::{Mark, Rank, control_name, draw_dots, labels, polar_name};
use super::number::short;
use super::scene::{Place, Scene, flattened, lifted, place_of, shown};
use super::style;
use super::svg::{Stroke, Svg};
use super::view::Rect;
use crate::error::Error;
use crate::exact::Rational;
use crate::segment::Segment;

/// The largest degree whose control points get coordinates in their labels.
const MAX_TOLD: usize = 4;
/// The largest degree whose intermediate points have labels.
const MAX_LABELLED_STEPS: usize = 6;
/// The largest degree that is continued a little outside of its frame.
const MAX_CONTINUED: usize = 20;
/// The most rounds of splitting whose pieces have marks where they meet.
const MAX_MARKED: usize = 4;
/// How many lines stand for the curve when labels look for room.
const CHORDS: usize = 48;

/// A picture of a segment with its control polygon.
///
/// Curves in the plane are drawn as they are, functions as their graphs, and
/// curves in space in an orthographic projection.
///
/// ```
/// use casteljau::{Interval, Rational, Segment, draw::CurvePicture};
/// let points = [[0, 0], [-4, 4], [-4, -12], [0, 0]];
/// let points = points.map(|p| p.map(Rational::from).to_vec()).to_vec();
/// let segment = Segment::from_points(points, Interval::new((-1).into(), 3.into())?)?;
/// let svg = CurvePicture::new(segment).with_scheme(1.into()).svg()?;
/// assert!(svg.contains("A cubic over -1..3") && svg.contains("F(1) = (-3, -3)"));
/// # Ok::<(), casteljau::Error>(())
/// ```
#[derive(Clone, Debug)]
pub struct CurvePicture {
    segment: Segment,
    weights: Option<Vec<Rational>>,
    parameter: Option<Rational>,
    depth: Option<usize>,
    angles: [i32; 2],
    features: bool,
}

impl CurvePicture {
    /// The most rounds of splitting that are drawn.
    pub const MAX_DEPTH: usize = 10;
    /// The largest polar degree that is drawn.
    pub const MAX_DEGREE: usize = 200;

    /// The curve and its control polygon, with labels.
    #[must_use]
    pub fn new(segment: Segment) -> Self {
        Self { segment, weights: None, parameter: None, depth: None, angles: [30, 25], features: false }
    }

    /// A rational curve, by its homogeneous control points `(w b, w)`.
    ///
    /// # Errors
    /// [`Error::Unsupported`] unless all weights are positive or all negative:
    /// the curve might go through infinity.
    pub fn rational(homogeneous: &Segment) -> Result<Self, Error> {
        match flattened(homogeneous)? {
            Some((segment, weights)) => Ok(Self { weights: Some(weights), ..Self::new(segment) }),
            None => Err(Error::Unsupported("a curve is drawn only if the weights of its control points are all positive or all negative; `split` gives pieces where they are".into())),
        }
    }

    /// Also the shells of de Casteljau's algorithm at a parameter, inside the
    /// frame or not.
    #[must_use]
    pub fn with_scheme(self, t: Rational) -> Self {
        Self { parameter: Some(t), ..self }
    }

    /// Also the control polygons after so many rounds of splitting in the middle.
    #[must_use]
    pub fn with_subdivision(self, depth: usize) -> Self {
        Self { depth: Some(depth), ..self }
    }

    /// The special points and the median line of a planar cubic beside the
    /// steps of an algorithm too; without steps they are always shown, as far
    /// as they belong to the segment.
    #[must_use]
    pub fn with_features(self) -> Self {
        Self { features: true, ..self }
    }

    /// The direction a curve in space is looked at from, in degrees: the angle
    /// of the eye around the z axis, counted from the x axis, and its height
    /// above the floor. They are 30 and 25 unless said otherwise.
    #[must_use]
    pub fn with_view(self, azimuth: i32, elevation: i32) -> Self {
        Self { angles: [azimuth, elevation], ..self }
    }

    /// The picture as SVG.
    ///
    /// # Errors
    /// [`Error::Unsupported`] for a curve in more than three dimensions;
    /// [`Error::TooLarge`] beyond [`CurvePicture::MAX_DEPTH`] or
    /// [`CurvePicture::MAX_DEGREE`].
    pub fn svg(&self) -> Result<String, Error> {
        if self.depth.is_some_and(|depth| depth > Self::MAX_DEPTH) {
            return Err(Error::TooLarge { what: "depth of a picture", limit: Self::MAX_DEPTH });
        }
        if self.segment.degree() > Self::MAX_DEGREE {
            return Err(Error::TooLarge { what: "degree of a picture", limit: Self::MAX_DEGREE });
        }
        // The steps of an algorithm and the features of the curve would hide each other.
        let plain = self.parameter.is_none() && self.depth.is_none();
        let features = if self.weights.is_none() && (plain || self.features) { Features::of(&self.segment) } else { None };
        let mut caption = Caption::new(&self.segment, self.weights.as_deref(), self.parameter.as_ref(), self.depth);
        if let Some(features) = &features {
            caption.add_note(features.note.clone());
        }
        let scene = Scene::new(&self.segment, self.weights.as_deref(), self.parameter.as_ref(), self.angles, caption.height())?;
        let rect = scene.view.rect;
        let [right, bottom] = if scene.space.is_some() { [20.0, 6.0] } else { [24.0, 40.0] };
        let size = [(rect.right + right).max(caption.width()).ceil(), (rect.bottom + bottom).ceil()];

        let mut svg = Svg::default();
        caption.draw(&mut svg);
        let mut obstacles = Obstacles::default();
        self.draw_ground(&mut svg, &scene, &mut obstacles)?;
        self.draw_polygons(&mut svg, &scene, &mut obstacles);
        if let Some([from, to]) = features.as_ref().and_then(|features| features.median(&scene.view)) {
            svg.line(from, to, Stroke::dashed(style::MEDIAN, 1.5, "9 4 2 4"));
            obstacles.add(&[from, to], 0.4);
        }
        let own: Vec<Mark> = features.iter().flat_map(|features| features.marks(&scene.view)).collect();
        self.draw_curve(&mut svg, &scene, &own, &mut obstacles);
        self.draw_pieces(&mut svg, &scene, &mut obstacles);
        let mut marks = self.marks(&scene)?;
        marks.extend(own);
        draw_dots(&mut svg, &marks);
        obstacles.dots.extend(marks.iter().map(|mark| (mark.at, 4.0)));
        svg.open("labels");
        let sheet = Rect { left: rect.left + 2.0, right: size[0] - 6.0, top: rect.top, bottom: rect.bottom - 2.0 };
        draw_labels(&mut svg, &labels(&marks), &obstacles, &sheet);
        svg.close();
        Ok(svg.finish(size, caption.title()))
    }

    /// The grid or the floor, and what lies on it.
    fn draw_ground(&self, svg: &mut Svg, scene: &Scene, obstacles: &mut Obstacles) -> Result<(), Error> {
        let Some(space) = &scene.space else {
            draw_axes(svg, &scene.view, if self.segment.dimension() == 1 { ["t", "F(t)"] } else { ["x", "y"] }, obstacles);
            return Ok(());
        };
        space.draw(svg, &scene.view, obstacles)?;
        let Some(shadow) = scene.shadow() else { return Ok(()) };
        svg.open("shadow");
        svg.path(&shadow.path(), Stroke::solid(style::SHADOW, 2.0));
        obstacles.add(&shadow.samples(CHORDS), 0.3);
        if self.segment.degree() <= 12 {
            for (from, to) in scene.control().into_iter().zip(shadow.points) {
                svg.line(from, to, Stroke::dashed(style::SHADOW, 1.0, "1.5 3"));
                svg.dot(to, 1.8, style::SHADOW, Stroke::solid(style::SHADOW, 0.0), "");
            }
        }
        svg.close();
        Ok(())
    }

    /// The control polygon and the shells.
    fn draw_polygons(&self, svg: &mut Svg, scene: &Scene, obstacles: &mut Obstacles) {
        let control = scene.control();
        obstacles.add(&control, 0.5);
        svg.path(&polygon(&control), Stroke::solid(style::POLYGON, 1.2));
        let layers = scene.layers();
        let place_of_t = self.parameter.as_ref().map(|t| place_of(&self.segment, t));
        svg.open("steps");
        for (step, layer) in layers.iter().enumerate().skip(1) {
            let colour = style::step_colour(step, self.segment.degree());
            if step + 1 < layers.len() {
                svg.path(&polygon(layer), Stroke::solid(&colour, 1.4));
                obstacles.add(layer, 0.5);
            }
            // Outside of the frame the points lie on the lines of the step before, but not between its points.
            let before = if step == 1 { style::POLYGON.to_owned() } else { style::step_colour(step - 1, self.segment.degree()) };
            let from = match place_of_t {
                Some(Place::Before) => &layers[step - 1][..layer.len()],
                Some(Place::After) => &layers[step - 1][1..],
                _ => continue,
            };
            for (&from, &to) in from.iter().zip(layer) {
                svg.path(&polygon(&[from, to]), Stroke::dashed(&before, 1.0, "2 4"));
                obstacles.add(&[from, to], 0.4);
            }
        }
        svg.close();
    }

    /// The curve, and where it goes outside of its frame.
    fn draw_curve(&self, svg: &mut Svg, scene: &Scene, features: &[Mark], obstacles: &mut Obstacles) {
        let curve = scene.curve();
        svg.open("curve");
        if scene.space.is_none() && self.segment.degree() <= MAX_CONTINUED {
            let place_of_t = self.parameter.as_ref().map(|t| place_of(&self.segment, t));
            for (side, ends) in [(Place::After, curve.clone()), (Place::Before, curve.reversed())] {
                let more = ends.continuation(|point| scene.view.rect.contains(point));
                if let Some(more) = more.filter(|more| place_of_t != Some(side) && distance(more.start(), more.end()) > 1.0) {
                    svg.path(&more.path(), Stroke::solid(style::BEYOND, 1.2));
                    obstacles.add(&more.samples(6), 0.4);
                }
            }
        }
        if let Some(more) = scene.beyond() {
            svg.path(&more.path(), Stroke::dashed(style::CURVE, 1.8, "6 5"));
            obstacles.add(&more.samples(CHORDS / 2), 0.8);
        }
        svg.path(&curve.path(), Stroke::solid(style::CURVE, if self.depth.is_some() { 2.0 } else { 2.6 }));
        obstacles.add(&curve.samples(CHORDS), 1.7);
        let mut dots = scene.control();
        dots.extend(scene.layers().into_iter().flatten().chain(scene.point()));
        dots.extend(features.iter().map(|mark| mark.at));
        if let Some(depth) = self.depth.filter(|&depth| depth <= MAX_MARKED) {
            dots.extend(curve.samples(1 << depth));
        }
        if let Some((middle, outline)) = arrow(&curve, &dots) {
            svg.filled(&outline, style::CURVE);
            obstacles.dots.push((middle, 7.0));
        }
        svg.close();
    }

    /// The control polygons of the pieces, and where they meet.
    fn draw_pieces(&self, svg: &mut Svg, scene: &Scene, obstacles: &mut Obstacles) {
        let Some(depth) = self.depth else { return };
        let pieces = scene.curve().subdivide(depth);
        // The dots of short pieces are small.
        let length = |piece: &Bezier| piece.points.windows(2).map(|pair| distance(pair[0], pair[1])).sum::<f64>();
        let shortest = pieces.iter().map(length).fold(f64::INFINITY, f64::min);
        let radius = (shortest / 8.0).clamp(2.2, 3.6);
        svg.open("pieces");
        for (index, piece) in pieces.iter().enumerate() {
            let colour = style::PIECES[index % 2];
            svg.polyline(&piece.points, Stroke::solid(colour, 1.4));
            if depth <= MAX_MARKED {
                obstacles.add(&piece.points, 0.5);
                let inner = piece.points.iter().skip(1).take(self.segment.degree().saturating_sub(1));
                for &point in inner.filter(|_| self.segment.degree() <= MAX_LABELLED_STEPS) {
                    svg.dot(point, radius * 0.7, colour, Stroke::solid("#ffffff", 0.4), "");
                }
            }
        }
        if depth <= MAX_MARKED {
            for piece in pieces.iter().skip(1) {
                svg.dot(piece.start(), radius, "#ffffff", Stroke::solid(style::CURVE, 1.6), "");
                obstacles.dots.push((piece.start(), 3.5));
            }
        }
        svg.close();
    }

    /// The dots with their names and their coordinates.
    fn marks(&self, scene: &Scene) -> Result<Vec<Mark>, Error> {
        let (degree, control) = (self.segment.degree(), scene.control());
        let middle = mean(&control);
        let mut marks: Vec<Mark> = Vec::new();
        for (index, (&at, value)) in control.iter().zip(self.segment.points()).enumerate() {
            let around: Vec<Point> =
                [index.checked_sub(1), Some(index + 1)].into_iter().flatten().filter_map(|i| control.get(i).copied()).collect();
            let outward = add(away(mean(&around), at, 1.0), away(middle, at, 0.6));
            let told = self.parameter.is_none() && (degree <= MAX_TOLD || index == 0 || index == degree);
            marks.push(Mark { at, rank: Rank::Control, name: control_name(degree, index), value: value.to_vec(), told, outward });
        }
        let (Some(t), Some(point)) = (&self.parameter, scene.point()) else { return Ok(marks) };
        let layers = scene.layers();
        let lifted = lifted(&self.segment, self.weights.as_deref())?;
        let shown = |point: &[Rational]| shown(point, self.weights.is_some());
        let scheme = if layers.is_empty() { None } else { Some(lifted.scheme(t)?) };
        for (step, layer) in layers.iter().enumerate().skip(1).take(degree.saturating_sub(1)) {
            for (index, (&at, value)) in layer.iter().zip(scheme.iter().flat_map(|scheme| scheme.layer(step))).enumerate() {
                let arguments = [("r", degree - index - step), ("s", index), ("t", step)];
                let name = if degree <= MAX_LABELLED_STEPS { polar_name(&arguments) } else { String::new() };
                let outward = away(point, at, 1.0);
                marks.push(Mark { at, rank: Rank::Step(step, degree), name, value: shown(value)?, told: false, outward });
            }
        }
        let outer = layers.iter().rev().nth(2).or(layers.first()).map_or(middle, |layer| mean(layer));
        let name = format!("F({})", short(t));
        let outward = away(outer, point, 1.0);
        marks.push(Mark { at: point, rank: Rank::Point, name, value: shown(&lifted.value(t)?)?, told: true, outward });
        Ok(marks)
    }
}

fn mean(points: &[Point]) -> Point {
    let count = points.len().max(1) as f64;
    points.iter().fold([0.0, 0.0], |sum, point| [sum[0] + point[0] / count, sum[1] + point[1] / count])
}

/// The vector of a given length that leads away from a point.
fn away(from: Point, at: Point, length: f64) -> Point {
    let whole = distance(from, at);
    if whole < 1e-6 { [0.0, 0.0] } else { [(at[0] - from[0]) / whole * length, (at[1] - from[1]) / whole * length] }
}

fn add(a: Point, b: Point) -> Point {
    [a[0] + b[0], a[1] + b[1]]
}
