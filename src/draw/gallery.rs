//! A sheet with all kinds of planar cubics, the ways from one to another, and
//! the tree that tells them apart (CS348a, lecture 6, section 2.2, figures 1 to 6).

use super::bezier::{Bezier, Point, polygon};
use super::feature::clipped;
use super::label::width;
use super::style;
use super::svg::{Anchor, Stroke, Svg, Type};
use super::view::Rect;
use crate::affine::{Interval, Place};
use crate::cubic::{Branch, Cubic, CubicClass, Special};
use crate::error::Error;
use crate::exact::{Rational, Surd};

/// The size of a panel with its title, and the room between two.
const PANEL: [f64; 2] = [196.0, 208.0];
const GAP: f64 = 14.0;
const MARGIN: f64 = 26.0;
/// The room for the title of a row.
const ROW_TITLE: f64 = 34.0;
/// How far curves stay away from the border of their panel.
const INSET: f64 = 16.0;
/// The height of the title of a panel.
const TITLE: f64 = 40.0;

/// What the dots of the gallery stand for.
const KEYS: [(&str, Dot); 5] = [
    ("flex", Dot::Filled(style::POINT)),
    ("summit", Dot::Filled(style::FEATURE)),
    ("crunode", Dot::Filled(style::CONTROL)),
    ("cusp", Dot::Filled("#c26a00")),
    ("acnode", Dot::Hollow),
];

#[derive(Clone, Copy)]
enum Dot {
    Filled(&'static str),
    Hollow,
}

/// One picture of the gallery.
struct Panel {
    title: String,
    subtitle: String,
    cubic: Cubic,
    /// Numerators over 4 of the ends of the segment that is drawn.
    range: [i64; 2],
}

impl Panel {
    fn new(title: impl Into<String>, subtitle: impl Into<String>, coefficients: [[Rational; 4]; 2], range: [i64; 2]) -> Self {
        let [x, y] = coefficients;
        let vectors = [0, 1, 2, 3].map(|power| [x[power].clone(), y[power].clone()]);
        Self { title: title.into(), subtitle: subtitle.into(), cubic: Cubic::from_vectors(vectors), range }
    }

    /// A panel whose title is the class.
    fn classified(subtitle: impl Into<String>, coefficients: [[Rational; 4]; 2], range: [i64; 2]) -> Self {
        let panel = Self::new("", subtitle, coefficients, range);
        Self { title: panel.cubic.class().to_string(), ..panel }
    }
}

/// The five standard cubics.
fn standard() -> Vec<Panel> {
    let formula = |class: CubicClass| match class {
        CubicClass::Humpy => "(r², r³ + r)",
        CubicClass::Loopy => "(r², r³ - r)",
        CubicClass::Pointy => "(r², r³)",
        CubicClass::SShaped => "(r, r³)",
        CubicClass::Parabolic => "(r, r²)",
        CubicClass::Straight => "",
    };
    let panel = |class: CubicClass| {
        let list = class.standard()?.map(|coordinate| coordinate.map(Rational::from));
        let range = if class == CubicClass::Parabolic { [-6, 6] } else { [-5, 5] };
        Some(Panel::classified(formula(class), list, range))
    };
    CubicClass::ALL.into_iter().filter_map(panel).collect()
}

/// `(t², t³ + k t)`: two flexes and an acnode meet in a cusp, and part as a crunode.
fn through_the_cusp() -> Vec<Panel> {
    let q = Rational::from;
    let panel = |(n, d, text): (i64, i64, &str)| {
        let list = [[q(0), q(0), q(1), q(0)], [q(0), Rational::new(n, d), q(0), q(1)]];
        Panel::classified(format!("k = {text}"), list, [-5, 5])
    };
    [(1, 1, "1"), (1, 3, "1/3"), (0, 1, "0"), (-1, 3, "-1/3"), (-1, 1, "-1")].map(panel).into()
}

/// `(t + k t², t³)`: the hump goes away to infinity on one side and comes back on the other.
fn through_infinity() -> Vec<Panel> {
    let q = Rational::from;
    let panel = |(n, d, text): (i64, i64, &str)| {
        let list = [[q(0), q(1), Rational::new(n, d), q(0)], [q(0), q(0), q(0), q(1)]];
        // The second flex is at -1/k.
        let range = match n.signum() {
            -1 => [-6, 12],
            1 => [-12, 6],
            _ => [-7, 7],
        };
        Panel::classified(format!("k = {text}"), list, range)
    };
    [(-2, 3, "-2/3"), (-2, 5, "-2/5"), (0, 1, "0"), (2, 5, "2/5"), (2, 3, "2/3")].map(panel).into()
}

/// All kinds of planar cubics on one sheet, as SVG.
///
/// ```
/// let svg = casteljau::draw::gallery()?;
/// assert!(svg.contains("S-shaped") && svg.contains("acnode"));
/// # Ok::<(), casteljau::Error>(())
/// ```
///
/// # Errors
/// None are known; those of making segments are passed on.
pub fn gallery() -> Result<String, Error> {
    let rows = [
        ("The standard cubics", standard()),
        ("From humpy over pointy to loopy: (t², t³ + k t)", through_the_cusp()),
        ("From humpy over S-shaped to humpy: (t + k t², t³)", through_infinity()),
    ];
    let wide = 2.0 * MARGIN + 5.0 * PANEL[0] + 4.0 * GAP;
    let mut svg = Svg::default();
    svg.open("caption");
    svg.text([MARGIN, 34.0], "Planar cubics", Type::new(21.0, style::TEXT, Anchor::Start));
    keys(&mut svg, wide);
    svg.close();
    let mut top = 52.0;
    for (title, panels) in rows {
        svg.text([MARGIN, top + 22.0], title, Type::new(style::TITLE_SIZE, style::TEXT, Anchor::Start));
        top += ROW_TITLE;
        for (index, panel) in panels.iter().enumerate() {
            let left = MARGIN + index as f64 * (PANEL[0] + GAP);
            draw_panel(&mut svg, panel, Rect { left, top, right: left + PANEL[0], bottom: top + PANEL[1] })?;
        }
        top += PANEL[1] + GAP;
    }
    svg.text([MARGIN, top + 22.0], "Which one it is", Type::new(style::TITLE_SIZE, style::TEXT, Anchor::Start));
    top = tree(&mut svg, top + ROW_TITLE + 6.0, wide);
    Ok(svg.finish([wide, top + 20.0], "Planar cubics"))
}

fn dot(svg: &mut Svg, at: Point, dot: Dot, tip: &str) {
    match dot {
        Dot::Filled(colour) => svg.dot(at, 4.2, colour, Stroke::solid("#ffffff", 1.0), tip),
        Dot::Hollow => svg.dot(at, 3.8, "#ffffff", Stroke::solid(style::FEATURE, 1.6), tip),
    }
}

fn key(name: &str) -> Dot {
    KEYS.iter().find(|(known, _)| *known == name).map_or(Dot::Hollow, |(_, dot)| *dot)
}

/// What the dots mean, at the right of the title.
fn keys(svg: &mut Svg, wide: f64) {
    let median = "median line";
    let mut x = wide - MARGIN - width(median, style::NOTE_SIZE);
    svg.text([x, 33.0], median, Type::new(style::NOTE_SIZE, style::QUIET_TEXT, Anchor::Start));
    svg.line([x - 34.0, 28.5], [x - 8.0, 28.5], Stroke::dashed(style::MEDIAN, 1.6, "7 3 1.5 3"));
    x -= 56.0;
    for (name, mark) in KEYS.into_iter().rev() {
        x -= width(name, style::NOTE_SIZE);
        svg.text([x, 33.0], name, Type::new(style::NOTE_SIZE, style::QUIET_TEXT, Anchor::Start));
        dot(svg, [x - 11.0, 28.5], mark, "");
        x -= 34.0;
    }
}

/// The special points that a panel shows.
fn points(cubic: &Cubic, frame: &Interval) -> Vec<(&'static str, [Surd; 2])> {
    let special = cubic.special_points();
    let portion = cubic.portion(&special, frame);
    let shown = portion.features.iter().filter(|feature| feature.place != Place::Outside);
    let mut points: Vec<(&'static str, [Surd; 2])> = shown
        .filter(|feature| !matches!(feature.name, "crunode" | "vertex"))
        .map(|feature| (feature.name, cubic.point(&feature.t)))
        .collect();
    let rational = |point: &[Rational; 2]| point.each_ref().map(Surd::from);
    match &special {
        Special::Humpy { acnode, .. } => points.push(("acnode", rational(acnode))),
        Special::Loopy { crunode, .. } => points.push(("crunode", rational(crunode))),
        Special::Pointy { .. } | Special::SShaped { .. } | Special::Parabolic { .. } | Special::Straight(_) => {}
    }
    points
}

fn draw_panel(svg: &mut Svg, panel: &Panel, rect: Rect) -> Result<(), Error> {
    let [r, s] = panel.range.map(|end| Rational::new(end, 4));
    let frame = Interval::new(r, s)?;
    let segment = panel.cubic.curve().segment(&frame)?;
    // Everything here is small, so floats place it well enough.
    let control: Vec<Point> = segment.points().map(|point| [point[0].approximate(), point[1].approximate()]).collect();
    let curve = Bezier::new(control);
    let special = points(&panel.cubic, &frame);
    let seen = |point: &[Surd; 2]| [point[0].approximate(), point[1].approximate()];
    let mut all = curve.samples(96);
    all.extend(special.iter().map(|(_, point)| seen(point)));
    let range = |axis: usize| {
        let values = || all.iter().map(|point| point[axis]);
        (values().fold(f64::INFINITY, f64::min), values().fold(f64::NEG_INFINITY, f64::max))
    };
    let (x_range, y_range) = (range(0), range(1));
    let plot = Rect { left: rect.left + INSET, right: rect.right - INSET, top: rect.top + TITLE + 6.0, bottom: rect.bottom - INSET };
    let scale = [(plot.right - plot.left) / (x_range.1 - x_range.0), (plot.bottom - plot.top) / (y_range.1 - y_range.0)];
    let place = |[x, y]: Point| [plot.left + (x - x_range.0) * scale[0], plot.bottom - (y - y_range.0) * scale[1]];

    svg.open("panel");
    let corners = [[rect.left, rect.top], [rect.right, rect.top], [rect.right, rect.bottom], [rect.left, rect.bottom]];
    svg.path(&format!("{} Z", polygon(&corners)), Stroke::solid(style::GRID, 1.2));
    // The axes, as far as they are in the panel.
    let origin = place([0.0, 0.0]);
    svg.line([rect.left + 6.0, origin[1]], [rect.right - 6.0, origin[1]], Stroke::solid(style::GRID, 1.0));
    svg.line([origin[0], rect.top + TITLE], [origin[0], rect.bottom - 6.0], Stroke::solid(style::GRID, 1.0));
    if let Some(median) = panel.cubic.special_points().median() {
        let start = [median.point[0].approximate(), median.point[1].approximate()];
        let direction = [median.direction[0].approximate(), median.direction[1].approximate()];
        let end = |k: f64| place([start[0] + k * direction[0], start[1] + k * direction[1]]);
        if let Some([from, to]) = clipped(end(-50.0), end(50.0), &Rect { left: rect.left + 6.0, right: rect.right - 6.0, ..plot }) {
            svg.line(from, to, Stroke::dashed(style::MEDIAN, 1.4, "7 3 1.5 3"));
        }
    }
    svg.path(&Bezier::new(curve.points.iter().map(|&point| place(point)).collect()).path(), Stroke::solid(style::CURVE, 2.2));
    for (name, point) in &special {
        dot(svg, place(seen(point)), key(name), &format!("{name} ({}, {})", point[0], point[1]));
    }
    let middle = (rect.left + rect.right) / 2.0;
    let bold = Type { bold: true, ..Type::new(style::LABEL_SIZE, style::TEXT, Anchor::Middle) };
    svg.text([middle, rect.top + 18.0], &panel.title, bold);
    svg.text([middle, rect.top + 34.0], &panel.subtitle, Type::new(style::NOTE_SIZE, style::QUIET_TEXT, Anchor::Middle));
    svg.close();
    Ok(())
}

/// One box of the classification tree.
struct Node {
    text: String,
    below: String,
    at: Point,
    colour: &'static str,
}

/// The classification tree; gives the place where it ends.
fn tree(svg: &mut Svg, top: f64, wide: f64) -> f64 {
    let step = 84.0;
    let columns = |part: f64| MARGIN + (wide - 2.0 * MARGIN) * part;
    let question = |text: &str, part: f64, level: f64| Node {
        text: text.to_owned(),
        below: String::new(),
        at: [columns(part), top + level * step],
        colour: style::TEXT,
    };
    let leaf = |branch: Branch, part: f64, level: f64| Node {
        text: branch.class().to_string(),
        below: branch.class().loop_blinn_name().to_owned(),
        at: [columns(part), top + level * step],
        colour: style::CURVE,
    };
    let nodes = [
        question("κ23", 0.5, 0.0),
        question("D = 3 κ31² - 4 κ12 κ23", 0.24, 1.0),
        leaf(Branch::DiscriminantPositive, 0.07, 2.0),
        leaf(Branch::DiscriminantZero, 0.24, 2.0),
        leaf(Branch::DiscriminantNegative, 0.41, 2.0),
        question("κ31", 0.74, 1.0),
        leaf(Branch::OnlyKappa23Zero, 0.6, 2.0),
        question("κ12", 0.84, 2.0),
        leaf(Branch::OnlyKappa12Left, 0.75, 3.0),
        leaf(Branch::AllZero, 0.93, 3.0),
    ];
    let edges = [
        (0, 1, "≠ 0"),
        (0, 5, "= 0"),
        (1, 2, "> 0"),
        (1, 3, "= 0"),
        (1, 4, "< 0"),
        (5, 6, "≠ 0"),
        (5, 7, "= 0"),
        (7, 8, "≠ 0"),
        (7, 9, "= 0"),
    ];
    svg.open("tree");
    let half = |node: &Node| width(&node.text, 16.0).max(width(&node.below, style::NOTE_SIZE)) / 2.0 + 12.0;
    for (parent, child, text) in edges {
        let (from, to) = (&nodes[parent], &nodes[child]);
        let ends = [[from.at[0], from.at[1] + 17.0], [to.at[0], to.at[1] - 17.0]];
        svg.line(ends[0], ends[1], Stroke::solid(style::POLYGON, 1.3));
        // Beside the line, on the outer side of the tree.
        let aside = if to.at[0] < from.at[0] { -17.0 } else { 17.0 };
        let middle = [(ends[0][0] + ends[1][0]) / 2.0 + aside, (ends[0][1] + ends[1][1]) / 2.0];
        svg.text(middle, text, Type { halo: true, ..Type::new(style::LABEL_SIZE, style::TEXT, Anchor::Middle) });
    }
    for node in &nodes {
        let (half, deep) = (half(node), if node.below.is_empty() { 17.0 } else { 31.0 });
        let [x, y] = node.at;
        let corners = [[x - half, y - 17.0], [x + half, y - 17.0], [x + half, y + deep], [x - half, y + deep]];
        svg.filled(&polygon(&corners), if node.below.is_empty() { "#ffffff" } else { style::FLOOR });
        svg.path(&format!("{} Z", polygon(&corners)), Stroke::solid(style::AXIS, 1.2));
        let bold = !node.below.is_empty();
        svg.text([x, y + 5.5], &node.text, Type { bold, ..Type::new(16.0, node.colour, Anchor::Middle) });
        if bold {
            svg.text([x, y + 23.0], &node.below, Type::new(style::NOTE_SIZE, style::QUIET_TEXT, Anchor::Middle));
        }
    }
    svg.close();
    top + 3.0 * step + 34.0
}
