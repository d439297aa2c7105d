//! Where labels go: beside their dots, on nothing else if there is room.

use super::bezier::{Point, distance, mix};
use super::svg::{Anchor, Stroke, Svg, Type};
use super::view::Rect;

/// How far labels are from the borders of their dots.
const GAPS: [f64; 5] = [5.0, 12.0, 22.0, 34.0, 50.0];
/// The gap beyond which a line joins a label to its dot, and its price.
const FAR: f64 = 20.0;
const LEADER: f64 = 4.0;
/// Directions that are tried.
const DIRECTIONS: usize = 16;
/// How often every label may move again after the others have.
const ROUNDS: usize = 4;
/// How much wider bold text is.
const BOLD: f64 = 1.14;

/// A label and the dot it belongs to.
#[derive(Clone, Debug)]
pub(super) struct Label {
    pub(super) lines: Vec<String>,
    pub(super) at: Point,
    /// The radius of the dot.
    pub(super) radius: f64,
    pub(super) size: f64,
    pub(super) colour: String,
    pub(super) bold: bool,
    /// The direction to go to if nothing else matters.
    pub(super) outward: Point,
    /// Whether the label may be left out where there is no room.
    pub(super) optional: bool,
}

/// What labels should not cover.
#[derive(Debug, Default)]
pub(super) struct Obstacles {
    pub(super) dots: Vec<(Point, f64)>,
    /// Lines, each with the price of covering a pixel of it.
    pub(super) lines: Vec<(Point, Point, f64)>,
}

impl Obstacles {
    /// Adds the lines that join points.
    pub(super) fn add(&mut self, points: &[Point], price: f64) {
        self.lines.extend(points.windows(2).map(|pair| (pair[0], pair[1], price)));
    }
}

#[derive(Clone, Copy, Debug)]
struct Candidate {
    area: Rect,
    anchor: Anchor,
    /// The line to the dot, if the label is far from it.
    leader: Option<[Point; 2]>,
    price: f64,
}

impl Candidate {
    /// How much two labels, or their lines, are in each other's way.
    fn conflict(&self, other: &Self) -> f64 {
        let crossed = |area: &Rect, leader: Option<[Point; 2]>| leader.map_or(0.0, |[from, to]| area.length_inside(from, to));
        self.area.grown(2.0).overlap(&other.area) + 4.0 * (crossed(&self.area, other.leader) + crossed(&other.area, self.leader))
    }
}

/// How wide a text is at most in the fonts it may be set in.
pub(super) fn width(text: &str, size: f64) -> f64 {
    let em = |letter: char| match letter {
        'i' | 'j' | 'l' | '.' | ',' | ' ' | '\'' | ':' => 0.33,
        '(' | ')' | '-' | 'r' | 's' | 't' | 'f' | '·' | '/' | '⁰'..='⁹' | '¹' | '²' | '³' | '⁻' | '₀'..='₉' => 0.43,
        '=' | '+' | '≈' | '…' | 'm' | 'w' => 0.86,
        'A'..='Z' => 0.72,
        _ => 0.63,
    };
    size * text.chars().map(em).sum::<f64>()
}

fn unit([x, y]: Point) -> Point {
    let length = x.hypot(y);
    if length < 1e-9 { [0.0, 0.0] } else { [x / length, y / length] }
}

impl Label {
    fn line_height(&self) -> f64 {
        self.size * 1.2
    }

    fn candidates(&self, obstacles: &Obstacles, sheet: &Rect) -> Vec<Candidate> {
        let wide = self.lines.iter().map(|line| width(line, self.size)).fold(0.0, f64::max) * if self.bold { BOLD } else { 1.0 };
        let high = self.line_height() * self.lines.len() as f64;
        let outward = unit(self.outward);
        let mut found = Vec::with_capacity(DIRECTIONS * GAPS.len());
        for gap in GAPS {
            for step in 0..DIRECTIONS {
                let angle = step as f64 * std::f64::consts::TAU / DIRECTIONS as f64;
                let (down, right) = angle.sin_cos();
                // The box touches the circle with the middle of a side, or close to a corner.
                let [over, below] = [right, down].map(|part| (part * 1.45).clamp(-1.0, 1.0));
                let reach = self.radius + gap;
                let centre = [self.at[0] + reach * right + over * wide / 2.0, self.at[1] + reach * down + below * high / 2.0];
                let area = Rect {
                    left: centre[0] - wide / 2.0,
                    right: centre[0] + wide / 2.0,
                    top: centre[1] - high / 2.0,
                    bottom: centre[1] + high / 2.0,
                };
                let anchor = match over {
                    over if over > 0.6 => Anchor::Start,
                    over if over < -0.6 => Anchor::End,
                    _ => Anchor::Middle,
                };
                let along = right * outward[0] + down * outward[1];
                let leader = if gap > FAR { LEADER } else { 0.0 };
                let mut price = gap * 0.45 + leader + (1.0 - along) * 5.0;
                let visible = area.overlap(sheet);
                price += (wide * high - visible) * 2.0;
                price += obstacles.dots.iter().map(|&(dot, radius)| covered_dot(&area, dot, radius)).sum::<f64>();
                price += obstacles.lines.iter().map(|&(from, to, price)| price * area.grown(1.5).length_inside(from, to)).sum::<f64>();
                found.push(Candidate { area, anchor, leader: (gap > FAR).then(|| self.leader(&area)), price });
            }
        }
        found
    }

    /// The line from the dot to a label.
    fn leader(&self, area: &Rect) -> [Point; 2] {
        let near = [self.at[0].clamp(area.left, area.right), self.at[1].clamp(area.top, area.bottom)];
        let whole = distance(self.at, near).max(1.0);
        [(self.radius + 2.0) / whole, 1.0 - 1.0 / whole].map(|part| mix(self.at, near, part))
    }

    fn draw(&self, svg: &mut Svg, place: &Candidate) {
        let Rect { left, right, top, .. } = place.area;
        let x = match place.anchor {
            Anchor::Start => left,
            Anchor::Middle => (left + right) / 2.0,
            Anchor::End => right,
        };
        if let Some([from, to]) = place.leader {
            svg.line(from, to, Stroke::solid(&self.colour, 0.6));
        }
        let style = Type { size: self.size, colour: &self.colour, anchor: place.anchor, bold: self.bold, halo: true };
        for (index, line) in self.lines.iter().enumerate() {
            svg.text([x, top + self.line_height() * index as f64 + self.size * 0.93], line, style);
        }
    }
}

fn covered_dot(area: &Rect, [x, y]: Point, radius: f64) -> f64 {
    let dot = Rect { left: x, right: x, top: y, bottom: y }.grown(radius + 1.0);
    area.overlap(&dot) * 4.0
}

/// Puts every label at its best place, the first ones first, and draws them.
pub(super) fn draw_labels(svg: &mut Svg, labels: &[Label], obstacles: &Obstacles, sheet: &Rect) {
    let candidates: Vec<Vec<Candidate>> = labels.iter().map(|label| label.candidates(obstacles, sheet)).collect();
    let mut chosen: Vec<Option<Candidate>> = vec![None; labels.len()];
    let collision = |chosen: &[Option<Candidate>], index: usize, place: &Candidate| -> f64 {
        let others = chosen.iter().enumerate().filter(|&(other, _)| other != index);
        others.filter_map(|(_, other)| other.as_ref()).map(|other| place.conflict(other)).sum()
    };
    for _ in 0..=ROUNDS {
        for (index, list) in candidates.iter().enumerate() {
            let priced = list.iter().map(|candidate| (candidate.price + 3.0 * collision(&chosen, index, candidate), candidate));
            chosen[index] = priced.min_by(|a, b| a.0.total_cmp(&b.0)).map(|(_, candidate)| *candidate);
        }
    }
    for index in (0..labels.len()).rev() {
        let crowded = |place: &Candidate| collision(&chosen, index, &Candidate { area: place.area.grown(-3.0), ..*place }) > 0.0;
        if labels[index].optional && chosen[index].as_ref().is_some_and(crowded) {
            chosen[index] = None;
        }
    }
    for (label, place) in labels.iter().zip(&chosen) {
        if let Some(place) = place {
            label.draw(svg, place);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn label(at: Point, outward: Point) -> Label {
        Label { lines: vec!["f(r,s)".into()], at, radius: 4.0, size: 14.0, colour: "#000000".into(), bold: false, outward, optional: false }
    }

    const SHEET: Rect = Rect { left: 0.0, top: 0.0, right: 300.0, bottom: 200.0 };

    #[test]
    fn a_free_label_goes_outward() {
        let up = label([150.0, 100.0], [0.0, -1.0]).candidates(&Obstacles::default(), &SHEET);
        let best = up.iter().min_by(|a, b| a.price.total_cmp(&b.price));
        assert!(best.is_some_and(|best| best.area.bottom < 100.0 && best.anchor == Anchor::Middle));
    }

    #[test]
    fn labels_stay_on_the_sheet_and_apart() {
        let labels = [label([2.0, 2.0], [-1.0, -1.0]), label([8.0, 6.0], [-1.0, -1.0]), label([298.0, 190.0], [1.0, 0.0])];
        let mut svg = Svg::default();
        draw_labels(&mut svg, &labels, &Obstacles::default(), &SHEET);
        let text = svg.finish([300.0, 200.0], "t");
        assert_eq!(text.matches("f(r,s)</text>").count(), 3);
        let mut places: Vec<&str> = text.lines().filter(|line| line.starts_with("<text")).collect();
        places.dedup();
        assert_eq!(places.len(), 3);
    }

    #[test]
    fn optional_labels_give_way() {
        let labels: Vec<Label> = (0..100).map(|_| Label { optional: true, ..label([150.0, 100.0], [0.0, 1.0]) }).collect();
        let mut svg = Svg::default();
        draw_labels(&mut svg, &labels, &Obstacles::default(), &SHEET);
        assert!(svg.finish([300.0, 200.0], "t").matches("</text>").count() < 60);
    }
}
