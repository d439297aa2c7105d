//! Writing SVG.
//!
//! Everything is said in presentation attributes: no style sheet, no script, no
//! identifier, so that several pictures can stand in one page.

use std::fmt::Write as _;

use super::bezier::{Point, place};
use crate::report::xml::escape;

/// The letters of every text, with what to use where a font is missing.
const FONTS: &str = "'STIX Two Text','Libertinus Serif',Charter,Georgia,'DejaVu Serif',serif";

/// A coordinate with at most two decimals.
pub(super) fn number(value: f64) -> String {
    if !value.is_finite() {
        return "0".into();
    }
    let text = format!("{value:.2}");
    let text = text.trim_end_matches('0').trim_end_matches('.');
    if text == "-0" { "0".into() } else { text.into() }
}

/// How a line is drawn.
#[derive(Clone, Copy, Debug)]
pub(super) struct Stroke<'a> {
    pub(super) colour: &'a str,
    pub(super) width: f64,
    /// The lengths of dashes and gaps, or nothing for a solid line.
    pub(super) dashes: &'a str,
}

impl<'a> Stroke<'a> {
    pub(super) const fn solid(colour: &'a str, width: f64) -> Self {
        Self { colour, width, dashes: "" }
    }

    pub(super) const fn dashed(colour: &'a str, width: f64, dashes: &'a str) -> Self {
        Self { colour, width, dashes }
    }

    fn attributes(&self) -> String {
        let dashes = if self.dashes.is_empty() { String::new() } else { format!(" stroke-dasharray=\"{}\"", self.dashes) };
        format!("stroke=\"{}\" stroke-width=\"{}\"{dashes}", self.colour, number(self.width))
    }
}

/// Which end of a text is at its place.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Anchor {
    Start,
    Middle,
    End,
}

/// How a text is drawn.
#[derive(Clone, Copy, Debug)]
pub(super) struct Type<'a> {
    pub(super) size: f64,
    pub(super) colour: &'a str,
    pub(super) anchor: Anchor,
    pub(super) bold: bool,
    /// A margin of the colour of the paper, for text on top of lines.
    pub(super) halo: bool,
}

impl<'a> Type<'a> {
    pub(super) const fn new(size: f64, colour: &'a str, anchor: Anchor) -> Self {
        Self { size, colour, anchor, bold: false, halo: false }
    }
}

/// The elements of a picture so far.
#[derive(Debug, Default)]
pub(super) struct Svg {
    body: String,
}

impl Svg {
    fn element(&mut self, text: std::fmt::Arguments<'_>) {
        // Writing to a string does not fail.
        let _ = self.body.write_fmt(text);
        self.body.push('\n');
    }

    /// Opens a group; its name says what the elements are.
    pub(super) fn open(&mut self, class: &str) {
        self.element(format_args!("<g class=\"{class}\">"));
    }

    /// Closes the last group.
    pub(super) fn close(&mut self) {
        self.element(format_args!("</g>"));
    }

    /// A line from point to point.
    pub(super) fn line(&mut self, from: Point, to: Point, stroke: Stroke<'_>) {
        let [x1, y1, x2, y2] = [from[0], from[1], to[0], to[1]].map(number);
        self.element(format_args!("<line x1=\"{x1}\" y1=\"{y1}\" x2=\"{x2}\" y2=\"{y2}\" {}/>", stroke.attributes()));
    }

    /// A path without filling.
    pub(super) fn path(&mut self, path: &str, stroke: Stroke<'_>) {
        let joints = "stroke-linejoin=\"round\" stroke-linecap=\"round\"";
        self.element(format_args!("<path d=\"{path}\" fill=\"none\" {} {joints}/>", stroke.attributes()));
    }

    /// A filled path without an outline.
    pub(super) fn filled(&mut self, path: &str, colour: &str) {
        self.element(format_args!("<path d=\"{path} Z\" fill=\"{colour}\"/>"));
    }

    /// A filled path with a thin outline of its own colour, which closes the
    /// gaps to its neighbours, or of another one. What is behind shines through a little.
    pub(super) fn facet(&mut self, path: &str, fill: &str, outline: &str) {
        let width = if fill == outline { 0.5 } else { 0.6 };
        self.element(format_args!(
            "<path d=\"{path} Z\" fill=\"{fill}\" fill-opacity=\"0.92\" stroke=\"{outline}\" stroke-width=\"{width}\" stroke-linejoin=\"round\"/>"
        ));
    }

    /// Points joined by lines.
    pub(super) fn polyline(&mut self, points: &[Point], stroke: Stroke<'_>) {
        let mut places: Vec<String> = points.iter().map(|&point| place(point)).collect();
        places.dedup();
        let joints = "stroke-linejoin=\"round\" stroke-linecap=\"round\"";
        self.element(format_args!("<polyline points=\"{}\" fill=\"none\" {} {joints}/>", places.join(" "), stroke.attributes()));
    }

    /// A round dot; `tip` is what a reader that points at it is told.
    pub(super) fn dot(&mut self, at: Point, radius: f64, fill: &str, outline: Stroke<'_>, tip: &str) {
        let [x, y, r] = [at[0], at[1], radius].map(number);
        let attributes = format!("cx=\"{x}\" cy=\"{y}\" r=\"{r}\" fill=\"{fill}\" {}", outline.attributes());
        if tip.is_empty() {
            self.element(format_args!("<circle {attributes}/>"));
        } else {
            self.element(format_args!("<circle {attributes}><title>{}</title></circle>", escape(tip)));
        }
    }

    /// A line of text; `at` is on its base line.
    pub(super) fn text(&mut self, at: Point, text: &str, style: Type<'_>) {
        let [x, y, size] = [at[0], at[1], style.size].map(number);
        let anchor = match style.anchor {
            Anchor::Start => "",
            Anchor::Middle => " text-anchor=\"middle\"",
            Anchor::End => " text-anchor=\"end\"",
        };
        let weight = if style.bold { " font-weight=\"bold\"" } else { "" };
        let halo =
            if style.halo { " stroke=\"#ffffff\" stroke-width=\"3.5\" stroke-linejoin=\"round\" paint-order=\"stroke\"" } else { "" };
        let attributes = format!("x=\"{x}\" y=\"{y}\" font-size=\"{size}\" fill=\"{}\"{anchor}{weight}{halo}", style.colour);
        self.element(format_args!("<text {attributes}>{}</text>", escape(text)));
    }

    /// The whole document.
    pub(super) fn finish(self, [width, height]: [f64; 2], title: &str) -> String {
        let [w, h] = [width, height].map(number);
        format!(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{w}\" height=\"{h}\" viewBox=\"0 0 {w} {h}\" role=\"img\" font-family=\"{FONTS}\">\n\
             <title>{}</title>\n<rect width=\"{w}\" height=\"{h}\" fill=\"#ffffff\"/>\n{}</svg>\n",
            escape(title),
            self.body
        )
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_short() {
        for (value, text) in [(1.0, "1"), (0.125, "0.12"), (-0.001, "0"), (100.0, "100"), (2.5, "2.5"), (f64::NAN, "0")] {
            assert_eq!(number(value), text);
        }
    }

    #[test]
    fn text_is_escaped() {
        let mut svg = Svg::default();
        svg.text([1.0, 2.0], "a < b & \"c\"", Type::new(12.0, "#000000", Anchor::End));
        let text = svg.finish([10.0, 20.0], "<t>");
        assert!(text.contains("a &lt; b &amp; &quot;c&quot;</text>") && text.contains("<title>&lt;t&gt;</title>"), "{text}");
    }

    #[test]
    fn lines_of_text_and_dots() {
        let mut svg = Svg::default();
        svg.open("dots");
        svg.dot([1.5, 2.0], 3.0, "#123456", Stroke::solid("#ffffff", 1.0), "f(r)");
        svg.polyline(&[[0.0, 0.0], [0.001, 0.0], [2.0, 3.0]], Stroke::dashed("#000000", 1.0, "2 3"));
        svg.close();
        let text = svg.finish([10.0, 20.0], "t");
        assert!(text.contains("<title>f(r)</title></circle>") && text.contains("points=\"0,0 2,3\""), "{text}");
        assert!(text.contains("stroke-dasharray=\"2 3\""));
    }
}
