//! The lines above a picture.

use super::label::width;
use super::number::{equation, short};
use super::scene::{kind, steps_are_drawn};
use super::style;
use super::svg::{Anchor, Stroke, Svg, Type};
use crate::exact::Rational;
use crate::segment::Segment;

/// The largest degree whose steps are explained one by one.
const MAX_EXPLAINED: usize = 6;
/// The most weights that are listed.
const MAX_TOLD_WEIGHTS: usize = 7;
/// Where lines begin.
const LEFT: f64 = 20.0;

/// What is said above a picture.
#[derive(Debug)]
pub(super) struct Caption {
    title: String,
    notes: Vec<String>,
    /// Colours and what they stand for.
    keys: Vec<(String, String)>,
}

impl Caption {
    pub(super) fn new(segment: &Segment, weights: Option<&[Rational]>, parameter: Option<&Rational>, depth: Option<usize>) -> Self {
        let (degree, [r, s]) = (segment.degree(), [segment.frame().r(), segment.frame().s()].map(short));
        let kind = match weights {
            None => kind(degree),
            Some(_) => kind(degree).replacen("A ", "A rational ", 1).into(),
        };
        let title = format!("{kind} over {r}..{s}");
        let mut vertices = format!("{}, {}", equation("r", &r), equation("s", &s));
        let mut keys = Vec::new();
        if let Some(t) = parameter {
            vertices.push_str(&format!(", {}", equation("t", &short(t))));
            if steps_are_drawn(degree) && degree <= MAX_EXPLAINED {
                keys.push((style::CONTROL.to_owned(), "control points".to_owned()));
                keys.extend((1..degree).map(|step| (style::step_colour(step, degree), format!("step {step}"))));
                keys.push((style::POINT.to_owned(), format!("step {degree}: F(t)")));
            }
        }
        let mut notes = vec![vertices];
        if let Some(weights) = weights.filter(|weights| weights.len() <= MAX_TOLD_WEIGHTS) {
            notes.push(format!("weights {}", weights.iter().map(short).collect::<Vec<_>>().join(", ")));
        }
        if let Some(depth) = depth {
            let (rounds, pieces) = (if depth == 1 { "round" } else { "rounds" }, 1_usize << depth.min(60));
            notes.push(format!("{depth} {rounds} of splitting in the middle, {pieces} {}", if pieces == 1 { "piece" } else { "pieces" }));
        }
        Self { title, notes, keys }
    }

    /// A caption with these lines.
    pub(super) fn of(title: String, notes: Vec<String>) -> Self {
        Self { title, notes, keys: Vec::new() }
    }

    /// Adds something to what is said below the title.
    pub(super) fn add_note(&mut self, note: String) {
        self.notes.push(note);
    }

    /// What the picture is called.
    pub(super) fn title(&self) -> &str {
        &self.title
    }

    /// The height of the lines.
    pub(super) fn height(&self) -> f64 {
        74.0 + if self.keys.is_empty() { 0.0 } else { 20.0 }
    }

    /// The width of the longest line, with margins.
    pub(super) fn width(&self) -> f64 {
        let keys: f64 = self.keys.iter().map(|(_, text)| 30.0 + width(text, style::NOTE_SIZE)).sum();
        let notes = width(&self.notes.join(" · "), style::NOTE_SIZE);
        width(&self.title, style::TITLE_SIZE).max(keys).max(notes) + 2.0 * LEFT
    }

    pub(super) fn draw(&self, svg: &mut Svg) {
        svg.open("caption");
        svg.text([LEFT, 27.0], &self.title, Type::new(style::TITLE_SIZE, style::TEXT, Anchor::Start));
        svg.text([LEFT, 47.0], &self.notes.join(" · "), Type::new(style::NOTE_SIZE, style::QUIET_TEXT, Anchor::Start));
        let mut x = LEFT + 5.0;
        for (colour, text) in &self.keys {
            svg.dot([x, 63.5], 4.0, colour, Stroke::solid("#ffffff", 0.5), "");
            svg.text([x + 9.0, 68.0], text, Type::new(style::NOTE_SIZE, style::QUIET_TEXT, Anchor::Start));
            x += 30.0 + width(text, style::NOTE_SIZE);
        }
        svg.close();
    }
}
