//! Colours and sizes.

/// Text.
pub(super) const TEXT: &str = "#1f2933";
/// Text that is not about the curve: numbers at the axes, second lines.
pub(super) const QUIET_TEXT: &str = "#6b7680";
/// The lines of the grid.
pub(super) const GRID: &str = "#eceff2";
/// The lines of the grid on a floor.
pub(super) const GRID_IN_SPACE: &str = "#dde2e7";
/// The floor.
pub(super) const FLOOR: &str = "#f7f9fa";
/// The axes.
pub(super) const AXIS: &str = "#b4bec8";
/// The curve.
pub(super) const CURVE: &str = "#1d4f91";
/// The curve outside of its frame.
pub(super) const BEYOND: &str = "#a9bedb";
/// The control polygon.
pub(super) const POLYGON: &str = "#8b96a1";
/// The control points.
pub(super) const CONTROL: &str = "#333f4b";
/// Lines down to the floor, and the shadow of the curve.
pub(super) const SHADOW: &str = "#c3ccd5";
/// The point `F(t)`.
pub(super) const POINT: &str = "#c2184b";
/// Flexes, cusps and other points that the curve itself has.
pub(super) const FEATURE: &str = "#0a7d55";
/// The median line of a cubic.
pub(super) const MEDIAN: &str = "#7fbfa5";
/// The pieces of a subdivision, in turn.
pub(super) const PIECES: [&str; 2] = ["#7a5ba6", "#2f8f7f"];

/// The front of a surface, in the dark and in the light.
pub(super) const FRONT: ([f64; 3], [f64; 3]) = ([96.0, 132.0, 178.0], [226.0, 236.0, 248.0]);
/// The back of a surface.
pub(super) const BACK: ([f64; 3], [f64; 3]) = ([178.0, 140.0, 96.0], [250.0, 238.0, 218.0]);

/// The size of the title.
pub(super) const TITLE_SIZE: f64 = 17.0;
/// The size of the lines below the title.
pub(super) const NOTE_SIZE: f64 = 13.0;
/// The size of the labels of control points.
pub(super) const LABEL_SIZE: f64 = 14.0;
/// The size of the labels of intermediate points.
pub(super) const SMALL_SIZE: f64 = 13.0;
/// The size of the numbers at the axes.
pub(super) const TICK_SIZE: f64 = 11.5;

/// The colours that those of the steps of de Casteljau's algorithm run through.
const STEPS: [[f64; 3]; 4] = [[10.0, 132.0, 140.0], [84.0, 138.0, 36.0], [204.0, 125.0, 8.0], [205.0, 78.0, 28.0]];

/// The colour of a step `1 ≤ step < steps`.
pub(super) fn step_colour(step: usize, steps: usize) -> String {
    let part = if steps > 2 { step.saturating_sub(1) as f64 / (steps - 2) as f64 } else { 0.0 };
    let along = (part.min(1.0) * 2.999).max(0.0);
    let index = along as usize;
    let [r, g, b] = [0, 1, 2].map(|channel| {
        let (from, to) = (STEPS[index][channel], STEPS[index + 1][channel]);
        (from + (to - from) * (along - index as f64)).round() as u8
    });
    format!("#{r:02x}{g:02x}{b:02x}")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_step_has_a_colour_of_its_own() {
        for steps in 2..12 {
            let mut colours: Vec<String> = (1..steps).map(|step| step_colour(step, steps)).collect();
            assert!(colours.iter().all(|colour| colour.len() == 7));
            colours.dedup();
            assert_eq!(colours.len(), steps - 1);
        }
    }
}
