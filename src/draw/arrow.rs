//! The head of an arrow on a curve.

use super::bezier::{Bezier, Point, distance, mix, polygon};

/// How far the head stays away from dots, in pixels.
const ROOM: f64 = 20.0;

/// An arrow head on the curve that shows where the parameter grows, at a place
/// away from the dots: its middle and its outline.
pub(super) fn arrow(curve: &Bezier, dots: &[Point]) -> Option<(Point, String)> {
    let room = |at: Point| dots.iter().map(|&dot| distance(dot, at)).fold(f64::INFINITY, f64::min);
    let straight = |part: f64| {
        let [before, at, after] = [part - 0.06, part, part + 0.06].map(|part| curve.split(part).0.end());
        distance(before, after) > 0.97 * (distance(before, at) + distance(at, after))
    };
    let parts = (0..=14).flat_map(|step| [0.5 + f64::from(step) / 40.0, 0.5 - f64::from(step) / 40.0]);
    let free: Vec<f64> = parts.filter(|&part| room(curve.split(part).0.end()) > ROOM).collect();
    let part = free.iter().copied().find(|&part| straight(part)).or(free.first().copied())?;
    let at = curve.split(part).0.end();
    let [behind, ahead] = [part - 0.02, part + 0.02].map(|part| curve.split(part).0.end());
    let length = distance(behind, ahead);
    if length < 0.5 {
        return None;
    }
    let [x, y] = [(ahead[0] - behind[0]) / length, (ahead[1] - behind[1]) / length];
    let corner = |forward: f64, aside: f64| [at[0] + forward * x - aside * y, at[1] + forward * y + aside * x];
    let [tip, notch] = [corner(7.0, 0.0), corner(-3.5, 0.0)];
    Some((mix(tip, notch, 0.5), polygon(&[tip, corner(-6.5, 5.2), notch, corner(-6.5, -5.2)])))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn arrows_keep_away_from_dots() {
        let line = Bezier::new(vec![[0.0, 0.0], [200.0, 0.0]]);
        assert!(arrow(&line, &[]).is_some_and(|(at, outline)| (at[0] - 101.75).abs() < 1e-9 && outline.starts_with("M107,0")));
        assert!(arrow(&line, &[[100.0, 0.0]]).is_some_and(|(at, _)| (at[0] - 100.0).abs() > 15.0));
        assert!(arrow(&Bezier::new(vec![[5.0, 5.0]; 3]), &[]).is_none());
    }
}
