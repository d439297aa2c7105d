//! The grid of a plot in the plane, and the numbers beside it.

use num_traits::Zero;

use super::label::width;
use super::style;
use super::svg::{Anchor, Stroke, Svg, Type};
use super::ticks::Step;
use super::view::View;

/// The least distance of the lines of the grid, in pixels, for each axis.
const SPACING: [i64; 2] = [58, 44];

/// Draws the grid, the axes, and the numbers.
pub(super) fn draw_axes(svg: &mut Svg, view: &View, names: [&str; 2]) {
    let rect = view.rect;
    svg.open("axes");
    // Equal units look best with equal steps.
    let least = [0, 1].map(|axis| view.units(axis, SPACING[axis]));
    let equal = view.units(0, 1) == view.units(1, 1);
    let mut axes = Vec::new();
    for axis in 0..2 {
        let step = Step::at_least(if equal { &least[0] } else { &least[axis] });
        let (low, high) = view.range(axis);
        for (value, text) in step.ticks(&low, &high) {
            let at = view.place(&if axis == 0 { [value.clone(), view.range(1).0] } else { [view.range(0).0, value.clone()] });
            let (from, to) = if axis == 0 { ([at[0], rect.top], [at[0], rect.bottom]) } else { ([rect.left, at[1]], [rect.right, at[1]]) };
            if value.is_zero() {
                axes.push((from, to));
            } else {
                svg.line(from, to, Stroke::solid(style::GRID, 1.0));
            }
            if axis == 0 {
                let half = width(&text, style::TICK_SIZE) / 2.0;
                if at[0] - half > rect.left - 50.0 && at[0] + half < rect.right + 20.0 {
                    svg.text([at[0], rect.bottom + 16.0], &text, Type::new(style::TICK_SIZE, style::QUIET_TEXT, Anchor::Middle));
                }
            } else {
                svg.text([rect.left - 7.0, at[1] + 4.0], &text, Type::new(style::TICK_SIZE, style::QUIET_TEXT, Anchor::End));
            }
        }
    }
    for (from, to) in axes {
        svg.line(from, to, Stroke::solid(style::AXIS, 1.2));
    }
    let quiet = |anchor| Type { bold: true, ..Type::new(13.0, style::QUIET_TEXT, anchor) };
    svg.text([rect.right, rect.bottom + 31.0], names[0], quiet(Anchor::End));
    svg.text([rect.left - 7.0, rect.top - 4.0], names[1], quiet(Anchor::End));
    svg.close();
}
