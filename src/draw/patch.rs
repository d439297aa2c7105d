//! Pictures of patches in space.

use super::bezier::{Point, mix, polygon};
use super::caption::Caption;
use super::label::{Obstacles, draw_labels};
use super::mark::{Mark, Rank, draw_dots, labels};
use super::model::{cross, minus};
use super::number::{equation, lowered, short, tuple};
use super::space::Space;
use super::style;
use super::svg::{Stroke, Svg};
use super::view::{Fit, Rect, View};
use crate::affine::Frame;
use crate::error::Error;
use crate::exact::Rational;
use crate::mesh::{grid, in_space, triangles};
use crate::piece::Piece;
use crate::weights::projected;

/// Into how many strips a patch is divided by its lines, and each strip again for its shape.
const LINES: usize = 8;
const FINE: usize = 4;
/// The largest number of control points that all have polar labels.
const MAX_POLAR: usize = 10;
/// The largest number of control points that all have names.
const MAX_NAMED: usize = 36;
/// Into how many pieces a line of the control net is divided to see what hides it.
const PIECES: usize = 10;

/// A picture of a triangular or rectangular patch with its control net: the
/// lines of constant parameters on the shaded surface, or the triangles of a
/// recursive subdivision.
///
/// ```
/// use casteljau::{Piece, Rational, Rectangle, RectangularPatch, draw::PatchPicture};
/// let rows = [[0, 1], [2, 7]].map(|row| row.map(|z| vec![Rational::from(z)]).to_vec()).to_vec();
/// let patch = RectangularPatch::from_rows(rows, Rectangle::unit())?;
/// let svg = PatchPicture::new(Piece::Rectangle(patch), false).with_point([1.into(), 0.into()]).svg()?;
/// assert!(svg.contains("A rectangular patch of bidegree (1,1)") && svg.contains("F(1,0) = (1, 0, 2)"));
/// # Ok::<(), casteljau::Error>(())
/// ```
#[derive(Clone, Debug)]
pub struct PatchPicture {
    piece: Piece,
    weighted: bool,
    parameter: Option<[Rational; 2]>,
    depth: Option<usize>,
    angles: [i32; 2],
}

/// A point of space as it is seen: on the paper, and how far toward the eye.
#[derive(Clone, Copy, Debug)]
struct Seen {
    at: Point,
    near: f64,
}

/// Something that hides what is behind it.
struct Item {
    near: f64,
    ink: Ink,
}

enum Ink {
    Facet(Vec<Point>, String, bool),
    Line(Point, Point, &'static str, f64),
}

impl PatchPicture {
    /// The most rounds of subdivision that are drawn.
    pub const MAX_DEPTH: usize = 6;
    /// The most control points of a patch that is drawn.
    pub const MAX_POINTS: usize = 2000;

    /// The patch and its control net; the last coordinate of a weighted one is the weight.
    #[must_use]
    pub fn new(piece: Piece, weighted: bool) -> Self {
        Self { piece, weighted, parameter: None, depth: None, angles: [30, 25] }
    }

    /// Also the point at two parameters.
    #[must_use]
    pub fn with_point(self, parameter: [Rational; 2]) -> Self {
        Self { parameter: Some(parameter), ..self }
    }

    /// The triangles of so many rounds of subdivision instead of lines.
    #[must_use]
    pub fn with_subdivision(self, depth: usize) -> Self {
        Self { depth: Some(depth), ..self }
    }

    /// The direction it is looked at from, in degrees: the angle of the eye
    /// around the z axis and its height; 30 and 25 unless said otherwise.
    #[must_use]
    pub fn with_view(self, azimuth: i32, elevation: i32) -> Self {
        Self { angles: [azimuth, elevation], ..self }
    }

    /// The picture as SVG.
    ///
    /// # Errors
    /// [`Error::Unsupported`] for curves, for patches in more than three
    /// dimensions and for ones that reach infinity; [`Error::TooLarge`] beyond
    /// [`PatchPicture::MAX_DEPTH`] or [`PatchPicture::MAX_POINTS`].
    pub fn svg(&self) -> Result<String, Error> {
        if self.depth.is_some_and(|depth| depth > Self::MAX_DEPTH) {
            return Err(Error::TooLarge { what: "depth of a picture of a patch", limit: Self::MAX_DEPTH });
        }
        if self.piece.points().len() > Self::MAX_POINTS {
            return Err(Error::TooLarge { what: "number of control points of a picture", limit: Self::MAX_POINTS });
        }
        let piece = in_space(&self.piece, self.weighted)?;
        let steps = self.depth.map_or(LINES * FINE, |depth| 1 << depth);
        let surface = grid(&piece, self.weighted, steps)?;
        // The triangles of a subdivision are shown alone.
        let control = if self.depth.is_some() { Vec::new() } else { self.control(&piece) };
        let point = self.point(&piece)?;
        let all =
            || surface.iter().map(|vertex| vertex.as_slice()).chain(control.iter().flatten().map(Vec::as_slice)).chain(point.as_deref());
        let space = Space::new(all(), self.angles[0], self.angles[1])?;
        let flat: Vec<Vec<Rational>> = all().map(|vertex| space.flat(vertex)).collect::<Result<_, _>>()?;
        let corners = space.corners()?;
        let caption = self.caption();
        let mut view = View::of(flat.iter().chain(&corners).map(Vec::as_slice), Fit::Rigid, [0.0, caption.height() - 24.0]);
        view.shift_right(10.0);
        let unit = view.units(0, 1).approximate();
        let seen = |vertex: &[Rational]| -> Result<Seen, Error> {
            let near = space.toward(vertex)?.approximate() / if unit > 0.0 { unit } else { 1.0 };
            Ok(Seen { at: view.place(&space.flat(vertex)?), near })
        };
        let surface: Vec<Seen> = surface.iter().map(|vertex| seen(vertex)).collect::<Result<_, _>>()?;
        let control_seen: Vec<Option<Seen>> =
            control.iter().map(|vertex| vertex.as_deref().map(seen).transpose()).collect::<Result<_, _>>()?;
        let point_seen = point.as_deref().map(seen).transpose()?;

        let mut svg = Svg::default();
        caption.draw(&mut svg);
        let mut obstacles = Obstacles::default();
        space.draw(&mut svg, &view, &mut obstacles)?;
        let mut items = self.facets(&surface, steps);
        svg.open("hidden-net");
        for (from, to) in self.net_lines() {
            let at = |index: usize| control_seen.get(index).copied().flatten();
            let (Some(from), Some(to)) = (at(from), at(to)) else { continue };
            svg.line(from.at, to.at, Stroke::dashed(style::POLYGON, 0.9, "1.5 2.5"));
            obstacles.add(&[from.at, to.at], 0.4);
            items.extend((0..PIECES).map(|piece| {
                let part = |k: usize| k as f64 / PIECES as f64;
                let (start, end) = (mix(from.at, to.at, part(piece)), mix(from.at, to.at, part(piece + 1)));
                let middle = (part(piece) + part(piece + 1)) / 2.0;
                Item { near: from.near + (to.near - from.near) * middle + 2.0, ink: Ink::Line(start, end, style::POLYGON, 1.2) }
            }));
        }
        svg.close();
        items.sort_by(|a, b| a.near.total_cmp(&b.near));
        svg.open("surface");
        for item in &items {
            match &item.ink {
                Ink::Facet(points, colour, outlined) => svg.facet(&polygon(points), colour, if *outlined { style::CURVE } else { colour }),
                Ink::Line(from, to, colour, width) => svg.line(*from, *to, Stroke::solid(colour, *width)),
            }
        }
        svg.close();
        let marks = self.marks(&control, &control_seen, point.as_deref(), point_seen);
        draw_dots(&mut svg, &marks);
        obstacles.dots.extend(marks.iter().map(|mark| (mark.at, 4.0)));
        svg.open("labels");
        let rect = view.rect;
        let size = [(rect.right + 20.0).max(caption.width()).ceil(), (rect.bottom + 6.0).ceil()];
        let sheet = Rect { left: rect.left + 2.0, right: size[0] - 6.0, top: rect.top, bottom: rect.bottom - 2.0 };
        draw_labels(&mut svg, &labels(&marks), &obstacles, &sheet);
        svg.close();
        Ok(svg.finish(size, caption.title()))
    }

    /// The control points in space; none for one at infinity.
    fn control(&self, piece: &Piece) -> Vec<Option<Vec<Rational>>> {
        piece.points().map(|point| if self.weighted { projected(point) } else { Some(point.to_vec()) }).collect()
    }

    /// The point that is marked.
    fn point(&self, piece: &Piece) -> Result<Option<Vec<Rational>>, Error> {
        let Some(at) = &self.parameter else { return Ok(None) };
        let value = match piece {
            Piece::Triangle(patch) => patch.value(at)?,
            Piece::Rectangle(patch) => patch.value(at)?,
            Piece::Curve(_) => return Ok(None),
        };
        let value = if self.weighted { projected(&value) } else { Some(value) };
        value.map_or_else(|| Err(Error::Unsupported("the point is at infinity: its weight is 0".into())), |value| Ok(Some(value)))
    }

    /// The pieces of the surface and the lines on it.
    fn facets(&self, surface: &[Seen], steps: usize) -> Vec<Item> {
        let mut items = Vec::new();
        // The nearest facet around every vertex: a line on the surface lies just before it.
        let mut around = vec![f64::NEG_INFINITY; surface.len()];
        for triangle in triangles(&self.piece, steps) {
            let corners = triangle.map(|index| surface[index as usize]);
            let near = corners.iter().map(|corner| corner.near).sum::<f64>() / 3.0;
            for index in triangle {
                let nearest = &mut around[index as usize];
                *nearest = nearest.max(near);
            }
            let points = corners.iter().map(|corner| corner.at).collect();
            items.push(Item { near, ink: Ink::Facet(points, shade(corners), self.depth.is_some()) });
        }
        if self.depth.is_none() {
            for (from, to, is_edge) in self.surface_lines(steps) {
                let near = around[from].max(around[to]) + 1e-6;
                let (from, to) = (surface[from], surface[to]);
                let width = if is_edge { 2.0 } else { 0.9 };
                items.push(Item { near, ink: Ink::Line(from.at, to.at, style::CURVE, width) });
            }
        }
        items
    }

    /// The short pieces of the lines of constant parameters, and whether they are on the boundary.
    fn surface_lines(&self, steps: usize) -> Vec<(usize, usize, bool)> {
        let mut lines = Vec::new();
        if let Piece::Triangle(_) = self.piece {
            let simplex = crate::kernel::shape::Factor { dimension: 2, degree: steps };
            let index = |i: usize, j: usize| simplex.index(&[i, j]);
            for i in 0..steps {
                for j in 0..steps - i {
                    let k = steps - i - j - 1;
                    let small = [index(i, j), index(i + 1, j), index(i, j + 1)];
                    // The three edges lie where j, i and k are constant.
                    for (constant, from, to) in [(j, 0, 1), (i, 0, 2), (k, 1, 2)] {
                        if constant % FINE == 0 {
                            lines.push((small[from], small[to], constant == 0));
                        }
                    }
                }
            }
            return lines;
        }
        let index = |i: usize, j: usize| i * (steps + 1) + j;
        for line in (0..=steps).step_by(FINE) {
            let is_edge = line == 0 || line == steps;
            for along in 0..steps {
                lines.push((index(line, along), index(line, along + 1), is_edge));
                lines.push((index(along, line), index(along + 1, line), is_edge));
            }
        }
        lines
    }

    /// The lines of the control net, by the places of their ends.
    fn net_lines(&self) -> Vec<(usize, usize)> {
        let mut lines = Vec::new();
        match &self.piece {
            Piece::Triangle(patch) => {
                let simplex = crate::kernel::shape::Factor { dimension: 2, degree: patch.degree() };
                let index = |i: usize, j: usize| simplex.index(&[i, j]);
                for i in 0..patch.degree() {
                    for j in 0..patch.degree() - i {
                        lines.extend([(index(i, j), index(i + 1, j)), (index(i, j), index(i, j + 1)), (index(i + 1, j), index(i, j + 1))]);
                    }
                }
            }
            Piece::Rectangle(patch) => {
                let (p, q) = patch.degree();
                let index = |i: usize, j: usize| i * (q + 1) + j;
                for i in 0..=p {
                    for j in 0..=q {
                        lines.extend((i < p).then(|| (index(i, j), index(i + 1, j))));
                        lines.extend((j < q).then(|| (index(i, j), index(i, j + 1))));
                    }
                }
            }
            Piece::Curve(_) => {}
        }
        lines
    }

    fn caption(&self) -> Caption {
        let kind = if self.weighted { "rational " } else { "" };
        let article = if self.weighted { "A rational" } else { "A" };
        let (title, vertices) = match self.piece.frame() {
            Frame::Triangle(frame) => {
                let degree = if let Piece::Triangle(patch) = &self.piece { patch.degree() } else { 0 };
                let names = ["r", "s", "t"].iter().zip(frame.vertices());
                let vertices: Vec<String> = names.map(|(name, vertex)| equation(name, &tuple(vertex))).collect();
                (format!("{article} triangular patch of degree {degree}"), vertices.join(", "))
            }
            Frame::Rectangle(frame) => {
                let (p, q) = if let Piece::Rectangle(patch) = &self.piece { patch.degree() } else { (0, 0) };
                let names = [("r1", frame.u().r()), ("s1", frame.u().s()), ("r2", frame.v().r()), ("s2", frame.v().s())];
                let vertices: Vec<String> = names.iter().map(|(name, value)| equation(name, &short(value))).collect();
                (format!("{article} rectangular patch of bidegree ({p},{q})"), vertices.join(", "))
            }
            Frame::Interval(_) => (format!("A {kind}curve"), String::new()),
        };
        let mut notes = vec![vertices];
        if let Some(depth) = self.depth {
            let count = if matches!(self.piece, Piece::Triangle(_)) { 1 } else { 2 } << (2 * depth);
            notes.push(format!("{count} triangles after {depth} {} of subdivision", if depth == 1 { "round" } else { "rounds" }));
        }
        Caption::of(title, notes)
    }

    /// The names of the control points: polar labels, or `b₀₁` and `b₀₁₂` where
    /// these would be too long, or nothing but the corners' where there are too many.
    fn names(&self) -> Vec<String> {
        let labels = self.piece.labels();
        if labels.len() <= MAX_POLAR {
            return labels;
        }
        let index = |digits: &[usize]| {
            let digits: Vec<String> = digits.iter().map(usize::to_string).collect();
            let separator = if digits.iter().any(|digit| digit.len() > 1) { "," } else { "" };
            format!("b{}", lowered(&digits.join(separator)))
        };
        let many = labels.len() > MAX_NAMED;
        let named = |digits: &[usize], is_corner: bool| if many && !is_corner { String::new() } else { index(digits) };
        match &self.piece {
            Piece::Triangle(patch) => {
                let degree = patch.degree();
                let all = crate::triangular::TriangularPatch::<Rational>::indices(degree);
                all.iter().map(|digits| named(digits, digits.contains(&degree))).collect()
            }
            Piece::Rectangle(patch) => {
                let (p, q) = patch.degree();
                let all = (0..=p).flat_map(|i| (0..=q).map(move |j| [i, j]));
                all.map(|[i, j]| named(&[i, j], (i == 0 || i == p) && (j == 0 || j == q))).collect()
            }
            Piece::Curve(_) => labels,
        }
    }

    fn marks(&self, control: &[Option<Vec<Rational>>], seen: &[Option<Seen>], point: Option<&[Rational]>, at: Option<Seen>) -> Vec<Mark> {
        let places: Vec<Point> = seen.iter().flatten().map(|seen| seen.at).collect();
        let count = places.len().max(1) as f64;
        let middle = places.iter().fold([0.0, 0.0], |sum, place| [sum[0] + place[0] / count, sum[1] + place[1] / count]);
        let away = |at: Point| {
            let (x, y) = (at[0] - middle[0], at[1] - middle[1]);
            let length = x.hypot(y).max(1e-9);
            [x / length, y / length]
        };
        let labels = self.names();
        let mut marks: Vec<Mark> = control
            .iter()
            .zip(seen)
            .zip(labels)
            .filter_map(|((value, seen), name)| {
                let (value, seen) = (value.clone()?, (*seen)?);
                Some(Mark { at: seen.at, rank: Rank::Control, name, value, told: false, outward: away(seen.at) })
            })
            .collect();
        if let (Some(value), Some(seen), Some([u, v])) = (point, at, &self.parameter) {
            let name = format!("F({},{})", short(u), short(v));
            marks.push(Mark { at: seen.at, rank: Rank::Point, name, value: value.to_vec(), told: true, outward: away(seen.at) });
        }
        marks
    }
}

/// The colour of a facet by the light on it; its two sides have different ones.
fn shade(corners: [Seen; 3]) -> String {
    // Paper runs down, space up.
    let [a, b, c] = corners.map(|Seen { at, near }| [at[0], -at[1], near]);
    let normal = cross(minus(b, a), minus(c, a));
    let length = normal.iter().map(|x| x * x).sum::<f64>().sqrt();
    let unit = if length > 0.0 { normal.map(|x| x / length) } else { [0.0, 0.0, 1.0] };
    let front = unit[2] >= 0.0;
    let toward = if front { unit } else { unit.map(|x| -x) };
    // From above, a little from the left, mostly from where the eye is.
    let light = (toward[0] * -0.35 + toward[1] * 0.5 + toward[2] * 0.79).max(0.0);
    let part = 0.25 + 0.75 * light;
    let (dark, bright) = if front { style::FRONT } else { style::BACK };
    let [r, g, b] = [0, 1, 2].map(|channel: usize| (dark[channel] + (bright[channel] - dark[channel]) * part).round() as u8);
    format!("#{r:02x}{g:02x}{b:02x}")
}
