//! The grid of a plot in the plane, and the numbers beside it.

use num_traits::Zero;

use super::bezier::Point;
use super::label::{Obstacles, width};
use super::style;
use super::svg::{Anchor, Stroke, Svg, Type};
use super::ticks::Step;
use super::view::View;
use crate::exact::Rational;

/// The least distance of the lines of the grid, in pixels, for each axis.
const SPACING: [i64; 2] = [58, 44];
/// The price of covering a pixel of an axis with a label.
const PRICE: f64 = 0.25;

fn ticks(view: &View, axis: usize) -> Vec<(Rational, String)> {
    // Equal units look best with equal steps.
    let equal = view.units(0, 1) == view.units(1, 1);
    let decisive = if equal { 0 } else { axis };
    let (low, high) = view.range(axis);
    Step::at_least(&view.units(decisive, SPACING[decisive])).ticks(&low, &high)
}

/// The room that the numbers at the left need.
pub(super) fn margin(view: &View) -> f64 {
    let widest = ticks(view, 1).iter().map(|(_, text)| width(text, style::TICK_SIZE)).fold(0.0, f64::max);
    (widest + 16.0).clamp(46.0, 120.0)
}

/// Draws the grid, the axes, and the numbers.
pub(super) fn draw_axes(svg: &mut Svg, view: &View, names: [&str; 2], obstacles: &mut Obstacles) {
    let rect = view.rect;
    let numbers = |anchor| Type::new(style::TICK_SIZE, style::QUIET_TEXT, anchor);
    let mut axes: Vec<[Point; 2]> = Vec::new();
    svg.open("axes");
    for (value, text) in ticks(view, 0) {
        let x = view.place(std::slice::from_ref(&value))[0];
        let ends = [[x, rect.top], [x, rect.bottom]];
        if value.is_zero() {
            axes.push(ends);
        } else {
            svg.line(ends[0], ends[1], Stroke::solid(style::GRID, 1.0));
        }
        let half = width(&text, style::TICK_SIZE) / 2.0;
        if x - half > 2.0 && x + half < rect.right + 20.0 {
            svg.text([x, rect.bottom + 16.0], &text, numbers(Anchor::Middle));
        }
    }
    for (value, text) in ticks(view, 1) {
        let y = view.place(&[view.range(0).0, value.clone()])[1];
        let ends = [[rect.left, y], [rect.right, y]];
        if value.is_zero() {
            axes.push(ends);
        } else {
            svg.line(ends[0], ends[1], Stroke::solid(style::GRID, 1.0));
        }
        svg.text([rect.left - 7.0, y + 4.0], &text, numbers(Anchor::End));
    }
    for ends in axes {
        svg.line(ends[0], ends[1], Stroke::solid(style::AXIS, 1.2));
        obstacles.add(&ends, PRICE);
    }
    let bold = |anchor| Type { bold: true, ..Type::new(13.0, style::QUIET_TEXT, anchor) };
    svg.text([rect.right, rect.bottom + 31.0], names[0], bold(Anchor::End));
    svg.text([rect.left - 7.0, rect.top - 5.0], names[1], bold(Anchor::End));
    svg.close();
}
