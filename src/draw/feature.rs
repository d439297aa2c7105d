//! The special points of planar cubics, as far as a segment shows them.

use super::bezier::Point;
use super::mark::{Mark, Rank};
use super::view::{Rect, View};
use crate::affine::Place;
use crate::cubic::{Cubic, MedianLine, PortionShape, Special};
use crate::exact::{Rational, Surd};
use crate::segment::Segment;

/// The longest text of the coordinates of a point that is written out exactly.
const LONGEST: usize = 22;

/// Coordinates of more bits than these have no special points in a picture.
const MAX_BITS: u64 = 4096;

/// What a picture shows of a cubic beside its control points.
#[derive(Debug)]
pub(super) struct Features {
    /// What the whole curve is, and what the segment shows of it.
    pub(super) note: String,
    points: Vec<Feature>,
    median: Option<MedianLine>,
}

#[derive(Debug)]
struct Feature {
    name: &'static str,
    point: [Surd; 2],
    /// Whether no parameter of the segment leads to it.
    isolated: bool,
}

impl Features {
    /// The features of a segment in the plane of degree two or three; `None` for others.
    pub(super) fn of(segment: &Segment) -> Option<Self> {
        if segment.dimension() != 2 {
            return None;
        }
        let cubic = Cubic::new(&segment.curve().ok()?).ok()?;
        let longest = segment.coordinates().iter().map(Rational::bits).max().unwrap_or(0);
        if cubic.true_degree() < 2 || longest > MAX_BITS {
            return None;
        }
        let special = cubic.special_points();
        let portion = cubic.portion(&special, segment.frame());
        let shown =
            |name: &'static str| portion.features.iter().filter(move |feature| feature.name == name && feature.place != Place::Outside);
        let mut points: Vec<Feature> = Vec::new();
        let on_curve = |name: &'static str, point: [Surd; 2]| Feature { name, point, isolated: false };
        for name in ["flex", "cusp", "summit", "turn"] {
            points.extend(shown(name).map(|feature| on_curve(feature.name, cubic.point(&feature.t))));
        }
        match &special {
            // A segment that passes the crunode only once does not cross itself there.
            Special::Loopy { crunode, .. } if portion.shape == PortionShape::Loop => {
                points.push(on_curve("crunode", crunode.each_ref().map(Surd::from)));
            }
            Special::Humpy { acnode, .. } => {
                points.push(Feature { name: "acnode", point: acnode.each_ref().map(Surd::from), isolated: true });
            }
            Special::Loopy { .. } | Special::Pointy { .. } | Special::SShaped { .. } | Special::Parabolic { .. } | Special::Straight(_) => {
            }
        }
        let has_summit = points.iter().any(|feature| matches!(feature.name, "summit" | "cusp"));
        let median = special.median().filter(|_| has_summit).cloned();
        let note = format!("{}, here {}", special.class(), portion.shape.in_words());
        Some(Self { note, points, median })
    }

    /// The dots, those of points off the curve only where the picture reaches.
    pub(super) fn marks(&self, view: &View) -> Vec<Mark> {
        let place = |feature: &Feature| view.place(&feature.point.each_ref().map(Surd::near));
        let visible = self.points.iter().filter(|feature| !feature.isolated || view.rect.contains(place(feature)));
        visible
            .map(|feature| {
                let exact = format!("({}, {})", feature.point[0], feature.point[1]);
                let near: Vec<String> = feature.point.iter().map(|c| super::number::short(&c.near()).replace('≈', "")).collect();
                let told = if exact.chars().count() <= LONGEST { exact } else { format!("≈ ({})", near.join(", ")) };
                Mark {
                    at: place(feature),
                    rank: if feature.isolated { Rank::Isolated } else { Rank::Feature },
                    name: format!("{} {told}", feature.name),
                    value: Vec::new(),
                    told: false,
                    outward: [0.6, -0.8],
                }
            })
            .collect()
    }

    /// The part of the median line in the plot.
    pub(super) fn median(&self, view: &View) -> Option<[Point; 2]> {
        let median = self.median.as_ref()?;
        // As long as the plot is wide, so that its places tell the direction.
        let [width, height] = [0, 1].map(|axis| {
            let (low, high) = view.range(axis);
            high - low
        });
        let size = |k: usize| num_traits::Signed::abs(&median.direction[k]);
        let factor = if size(0) * &height > size(1) * &width { width.checked_div(&size(0)) } else { height.checked_div(&size(1)) }?;
        let end = |sign: i64| {
            let factor = &factor * Rational::from(sign);
            view.place(&[0, 1].map(|k| &median.point[k] + &factor * &median.direction[k]))
        };
        clipped(end(-1), end(1), &view.rect)
    }
}

/// The part of a line from point to point that lies in a rectangle.
pub(super) fn clipped(from: Point, to: Point, rect: &Rect) -> Option<[Point; 2]> {
    let (mut enter, mut leave) = (0.0_f64, 1.0_f64);
    for (start, end, low, high) in [(from[0], to[0], rect.left, rect.right), (from[1], to[1], rect.top, rect.bottom)] {
        let step = end - start;
        if step.abs() < 1e-9 {
            if start < low || start > high {
                return None;
            }
            continue;
        }
        let (first, second) = ((low - start) / step, (high - start) / step);
        enter = enter.max(first.min(second));
        leave = leave.min(first.max(second));
    }
    (enter < leave).then(|| [super::bezier::mix(from, to, enter), super::bezier::mix(from, to, leave)])
}
