//! Pictures of the joins of files: their pieces, with what was found marked.

use super::bezier::{Bezier, Point};
use super::label::width;
use super::style;
use super::svg::{Anchor, Stroke, Svg, Type};
use crate::audit::{Join, Verdict};
use crate::error::Error;
use crate::exact::Rational;
use crate::model::{Format, Part};
use crate::piece::Piece;
use crate::report::joins::{Examined, File, Summary, sentence};
use crate::side::{Arrangement, Side};

/// The most pieces that are drawn.
pub const MAX_DRAWN: usize = 50_000;
/// The most files that have a panel.
const MAX_PANELS: usize = 48;

const MARGIN: f64 = 24.0;
const GAP: f64 = 18.0;
/// The room for the name of a file, and for the line below it.
const TITLE: f64 = 44.0;
/// How far drawings stay away from the border of their panel.
const INSET: f64 = 22.0;
/// Into how many lines a rational curve is divided.
const SAMPLES: usize = 24;

/// From where space is looked at, in degrees.
const AZIMUTH: f64 = 35.0;
const ELEVATION: f64 = 25.0;

/// The colour of each verdict.
const fn colour(verdict: Verdict) -> &'static str {
    match verdict {
        Verdict::Exact => "#1a8f5a",
        Verdict::Within => "#d98a00",
        Verdict::Violated => "#d0021b",
        Verdict::Degenerate => "#7a5ba6",
        Verdict::Reported => "#8b96a1",
    }
}

/// A point of the file on a plane, before it is fitted to the paper.
fn flat(point: &[Rational], rational: bool, downward: bool) -> Point {
    let mut numbers: Vec<f64> = point.iter().map(Rational::approximate).collect();
    if rational {
        let weight = numbers.pop().unwrap_or(1.0);
        numbers.iter_mut().for_each(|number| *number /= weight);
    }
    match numbers.as_slice() {
        [x, y, z, ..] => {
            let ((sin, cos), (rise, run)) = (AZIMUTH.to_radians().sin_cos(), ELEVATION.to_radians().sin_cos());
            [-sin * x + cos * y, -rise * cos * x - rise * sin * y + run * z]
        }
        [x, y] => [*x, if downward { -y } else { *y }],
        [x] => [*x, 0.0],
        [] => [0.0, 0.0],
    }
}

/// A curve given by some control points of a part, on the plane.
fn curve(part: &Part, indices: impl Iterator<Item = usize>, downward: bool) -> Vec<Point> {
    let points: Vec<&[Rational]> = indices.map(|index| part.piece.net().point(index)).collect();
    if !part.rational {
        return points.into_iter().map(|point| flat(point, false, downward)).collect();
    }
    let homogeneous: Vec<Vec<f64>> = points.iter().map(|point| point.iter().map(Rational::approximate).collect()).collect();
    let value = |t: f64| -> Vec<f64> {
        let mut row = homogeneous.clone();
        while row.len() > 1 {
            row = row.windows(2).map(|pair| pair[0].iter().zip(&pair[1]).map(|(a, b)| a + (b - a) * t).collect()).collect();
        }
        row.swap_remove(0)
    };
    let sample = |k: usize| {
        let point = value(k as f64 / SAMPLES as f64);
        let exact: Vec<Rational> = point.iter().map(|number| near(*number)).collect();
        flat(&exact, true, downward)
    };
    (0..=SAMPLES).map(sample).collect()
}

/// The number as a fraction, near enough for ink.
fn near(number: f64) -> Rational {
    const UNIT: f64 = 1e9;
    if number.is_finite() && number.abs() < 9e9 { Rational::new((number * UNIT) as i64, UNIT as i64) } else { Rational::from(0) }
}

/// A line of a panel, still in units of the file.
struct Line {
    points: Vec<Point>,
    bezier: bool,
    colour: &'static str,
    width: f64,
}

/// A dot of a panel.
struct Dot {
    at: Point,
    verdict: Verdict,
    /// The ends of the handles there.
    handles: Vec<Point>,
    tip: String,
}

/// What one file looks like.
struct Panel {
    title: String,
    subtitle: String,
    lines: Vec<Line>,
    dots: Vec<Dot>,
}

impl Panel {
    fn of(file: &File, examined: &Examined) -> Self {
        let downward = examined.model.format == Format::Svg;
        let mut panel =
            Self { title: file.path.clone(), subtitle: subtitle(std::slice::from_ref(file)), lines: Vec::new(), dots: Vec::new() };
        for part in &examined.model.parts {
            let arrangement = Arrangement::of(&part.piece);
            let mut line = |indices: &mut dyn Iterator<Item = usize>| {
                let points = curve(part, indices, downward);
                panel.lines.push(Line { points, bezier: !part.rational, colour: style::BEYOND, width: 1.2 });
            };
            if let Piece::Curve(segment) = &part.piece {
                line(&mut (0..=segment.degree()));
            } else {
                for &side in arrangement.sides() {
                    line(&mut (0..arrangement.columns(side, 0)).map(|column| arrangement.index(side, 0, column)));
                }
            }
        }
        let mut joins: Vec<&Join> = examined.audit.joins.iter().collect();
        // What matters is drawn last, above the rest.
        joins.sort_by_key(|join| std::cmp::Reverse(rank(join.verdict)));
        for join in joins {
            let part = &examined.model.parts[join.first.0];
            let arrangement = Arrangement::of(&part.piece);
            if join.first.1.is_end() {
                let at = flat(part.piece.net().point(arrangement.index(join.first.1, 0, 0)), part.rational, downward);
                let handle = |(index, side): (usize, Side)| {
                    let part = &examined.model.parts[index];
                    let arrangement = Arrangement::of(&part.piece);
                    flat(
                        part.piece.net().point(arrangement.index(side, 1.min(arrangement.degree_across(side)), 0)),
                        part.rational,
                        downward,
                    )
                };
                let handles = if join.verdict == Verdict::Violated { vec![handle(join.first), handle(join.second)] } else { Vec::new() };
                panel.dots.push(Dot { at, verdict: join.verdict, handles, tip: sentence(examined, join) });
            } else {
                let indices = (0..arrangement.columns(join.first.1, 0)).map(|column| arrangement.index(join.first.1, 0, column));
                let points = curve(part, indices, downward);
                let width = if join.verdict == Verdict::Violated { 3.5 } else { 1.6 };
                panel.lines.push(Line { points, bezier: !part.rational, colour: colour(join.verdict), width });
            }
        }
        panel
    }

    /// Draws it into a box of the paper.
    fn draw(&self, svg: &mut Svg, [left, top]: Point, [wide, high]: [f64; 2]) {
        let fitting = |text: &str, size: f64| -> String {
            // The end of a path says more than its beginning.
            let mut shown: &str = text;
            while 1.15 * width(shown, size) > wide && shown.len() > 4 {
                let mut letters = shown.chars();
                letters.next();
                shown = letters.as_str();
            }
            if shown.len() < text.len() { format!("…{shown}") } else { text.to_owned() }
        };
        svg.text(
            [left, top + 14.0],
            &fitting(&self.title, style::NOTE_SIZE),
            Type { bold: true, ..Type::new(style::NOTE_SIZE, style::TEXT, Anchor::Start) },
        );
        svg.text([left, top + 32.0], &self.subtitle, Type::new(style::TICK_SIZE, style::QUIET_TEXT, Anchor::Start));
        let all = self.lines.iter().flat_map(|line| &line.points).chain(self.dots.iter().map(|dot| &dot.at));
        let all = || all.clone().filter(|point| point.iter().all(|number| number.is_finite()));
        let range = |axis: usize| {
            let low = all().map(|point| point[axis]).fold(f64::INFINITY, f64::min);
            let high = all().map(|point| point[axis]).fold(f64::NEG_INFINITY, f64::max);
            if low <= high { (low, high) } else { (0.0, 0.0) }
        };
        let (x, y) = (range(0), range(1));
        let room = [wide - 2.0 * INSET, high - TITLE - 2.0 * INSET];
        let fill = |room: f64, (low, high): (f64, f64)| if high > low { room / (high - low) } else { f64::INFINITY };
        let scale = fill(room[0], x).min(fill(room[1], y));
        let scale = if scale.is_finite() { scale } else { 1.0 };
        let middle = [left + wide / 2.0, top + TITLE + (high - TITLE) / 2.0];
        let place = |point: &Point| -> Point {
            let centre = [(x.0 + x.1) / 2.0, (y.0 + y.1) / 2.0];
            let at = [middle[0] + (point[0] - centre[0]) * scale, middle[1] - (point[1] - centre[1]) * scale];
            at.map(|number| if number.is_finite() { number } else { 0.0 })
        };
        for line in &self.lines {
            let points: Vec<Point> = line.points.iter().map(place).collect();
            let stroke = Stroke::solid(line.colour, line.width);
            if line.bezier { svg.path(&Bezier::new(points).path(), stroke) } else { svg.polyline(&points, stroke) }
        }
        for dot in &self.dots {
            let at = place(&dot.at);
            let own = colour(dot.verdict);
            for handle in &dot.handles {
                let end = place(handle);
                svg.line(at, end, Stroke::solid(own, 1.0));
                svg.dot(end, 1.8, own, Stroke::solid("#ffffff", 0.5), "");
            }
            let (radius, fill) = match dot.verdict {
                Verdict::Violated => (4.5, "#ffffff"),
                Verdict::Within => (3.0, own),
                Verdict::Degenerate => (3.0, "#ffffff"),
                _ => (2.0, own),
            };
            svg.dot(at, radius, fill, Stroke::solid(own, if dot.verdict == Verdict::Violated { 2.0 } else { 1.0 }), &dot.tip);
        }
    }
}

/// The order of importance.
fn rank(verdict: Verdict) -> usize {
    match verdict {
        Verdict::Violated => 0,
        Verdict::Degenerate => 1,
        Verdict::Within => 2,
        Verdict::Exact => 3,
        Verdict::Reported => 4,
    }
}

/// How many joins have which verdict.
fn subtitle(files: &[File]) -> String {
    let summary = Summary::of(files);
    let counted = Verdict::ALL.into_iter().filter(|verdict| summary.count(*verdict) > 0);
    let list: Vec<String> = counted.map(|verdict| format!("{} {}", summary.count(verdict), verdict.name())).collect();
    if list.is_empty() { "no joins".into() } else { list.join(", ") }
}

/// A picture of files, one panel each: the pieces, and the joins in the colour
/// of their verdict. Where joins are violated, only the files with such joins are
/// shown. What a dot is can be read by pointing at it.
///
/// # Errors
/// [`Error::TooLarge`] for more than [`MAX_DRAWN`] pieces.
pub fn joins(files: &[File]) -> Result<String, Error> {
    let mut examined: Vec<(&File, &Examined)> = files.iter().filter_map(|file| Some((file, file.outcome.as_ref().ok()?))).collect();
    // Where something fails, what does not only hides it.
    if examined.iter().any(|(_, examined)| examined.failures().next().is_some()) {
        examined.retain(|(_, examined)| examined.failures().next().is_some());
    }
    let left_out = examined.len().saturating_sub(MAX_PANELS);
    examined.truncate(MAX_PANELS);
    if examined.iter().map(|(_, examined)| examined.model.parts.len()).sum::<usize>() > MAX_DRAWN {
        return Err(Error::TooLarge { what: "number of pieces in a picture", limit: MAX_DRAWN });
    }
    let columns = match examined.len() {
        0 | 1 => 1,
        2..=4 => 2,
        5..=9 => 3,
        _ => 4,
    };
    let panel = if columns == 1 { [680.0, 600.0] } else { [320.0, 340.0] };
    let rows = examined.len().div_ceil(columns).max(1);
    let size = [
        2.0 * MARGIN + columns as f64 * panel[0] + (columns - 1) as f64 * GAP,
        2.0 * MARGIN + rows as f64 * panel[1] + (rows - 1) as f64 * GAP + 36.0,
    ];
    let mut svg = Svg::default();
    for (index, (file, examined)) in examined.iter().enumerate() {
        let (row, column) = (index / columns, index % columns);
        let corner = [MARGIN + column as f64 * (panel[0] + GAP), MARGIN + row as f64 * (panel[1] + GAP)];
        svg.open("panel");
        Panel::of(file, examined).draw(&mut svg, corner, panel);
        svg.close();
    }
    let (mut x, y) = (MARGIN, size[1] - MARGIN);
    for verdict in Verdict::ALL {
        svg.dot([x + 5.0, y - 4.0], 4.0, colour(verdict), Stroke::solid("#ffffff", 0.5), "");
        svg.text([x + 14.0, y], verdict.name(), Type::new(style::NOTE_SIZE, style::QUIET_TEXT, Anchor::Start));
        x += 30.0 + width(verdict.name(), style::NOTE_SIZE);
    }
    if left_out > 0 {
        svg.text([size[0] - MARGIN, y], &format!("{left_out} more files"), Type::new(style::NOTE_SIZE, style::QUIET_TEXT, Anchor::End));
    }
    Ok(svg.finish(size, "The joins of curves and patches in files"))
}
