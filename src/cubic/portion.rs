//! Where the features of a cubic lie relative to a segment of it.

use std::cmp::Ordering;

use super::{Cubic, CubicClass, Special};
use crate::affine::{Interval, Place};
use crate::exact::Surd;
use crate::name::display_by_name;

/// The name of a place in answers.
pub(crate) fn place_name(place: Place) -> &'static str {
    match place {
        Place::Inside => "inside",
        Place::Vertex | Place::Edge => "end",
        Place::Outside => "outside",
    }
}

/// Where a parameter lies.
pub(super) fn place(t: &Surd, frame: &Interval) -> Place {
    let (r, s) = (t.cmp(&Surd::from(frame.r())), t.cmp(&Surd::from(frame.s())));
    match (r, s) {
        (Ordering::Equal, _) | (_, Ordering::Equal) => Place::Vertex,
        (Ordering::Less, Ordering::Greater) | (Ordering::Greater, Ordering::Less) => Place::Inside,
        (Ordering::Less, Ordering::Less) | (Ordering::Greater, Ordering::Greater) => Place::Outside,
    }
}

/// A parameter that means something, and where it lies.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Feature {
    /// What it is: "flex", "crunode", "cusp", "summit", "turn", "vertex".
    pub name: &'static str,
    /// The parameter.
    pub t: Surd,
    /// Where it lies: inside the frame, outside, or on one of its ends (its vertices).
    pub place: Place,
}

/// What a segment shows of the curve it is a part of, which may be less than
/// the class of the whole curve promises.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum PortionShape {
    /// It crosses or touches itself: both parameters of the crunode belong to the closed segment.
    Loop,
    /// The cusp belongs to the closed segment.
    Cusp,
    /// Two flexes in the open segment.
    DoubleInflection,
    /// One flex in the open segment.
    SingleInflection,
    /// It turns one way only.
    Arch,
    /// A part of a parabola.
    Quadratic,
    /// A part of a line.
    Line,
    /// A point.
    Point,
}

impl PortionShape {
    /// The name in answers.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Loop => "loop",
            Self::Cusp => "cusp",
            Self::DoubleInflection => "double_inflection",
            Self::SingleInflection => "single_inflection",
            Self::Arch => "arch",
            Self::Quadratic => "quadratic",
            Self::Line => "line",
            Self::Point => "point",
        }
    }
}

display_by_name!(PortionShape);

impl PortionShape {
    /// What is to be seen, in the words of the lecture.
    #[must_use]
    pub fn in_words(self) -> &'static str {
        match self {
            Self::Loop => "a loop",
            Self::Cusp => "a cusp",
            Self::DoubleInflection => "two flexes",
            Self::SingleInflection => "one flex",
            Self::Arch => "an arch",
            Self::Quadratic => "a part of a parabola",
            Self::Line => "a part of a line",
            Self::Point => "a point",
        }
    }
}

/// The segment of a cubic over a frame.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Portion {
    /// The frame.
    pub frame: Interval,
    /// The features of the whole curve, with their places.
    pub features: Vec<Feature>,
    /// What the segment shows.
    pub shape: PortionShape,
    /// The ends of what a straight segment covers.
    pub straight_ends: Option<[[Surd; 2]; 2]>,
}

impl Cubic {
    /// The features of the segment over a frame.
    #[must_use]
    pub fn portion(&self, special: &Special, frame: &Interval) -> Portion {
        let feature = |name: &'static str, t: &Surd| Feature { name, t: t.clone(), place: place(t, frame) };
        let mut features: Vec<Feature> = Vec::new();
        features.extend(special.flexes().iter().map(|flex| feature("flex", &flex.t)));
        features.extend(special.crunode_parameters().iter().map(|t| feature("crunode", t)));
        features.extend(special.cusp().map(|cusp| feature("cusp", &cusp.t)));
        let mut straight_ends = None;
        match special {
            Special::Humpy { summit, .. } | Special::Loopy { summit, .. } => features.push(feature("summit", &summit.t)),
            Special::Parabolic { vertex } => features.push(feature("vertex", &vertex.t)),
            Special::Straight(straight) => {
                features.extend(straight.turns.iter().map(|turn| feature("turn", turn)));
                let (low, high) = straight.range(frame);
                straight_ends = Some([straight.point(&low), straight.point(&high)]);
            }
            Special::Pointy { .. } | Special::SShaped { .. } => {}
        }
        let shape = self.shape(special.class(), &features);
        Portion { frame: frame.clone(), features, shape, straight_ends }
    }

    fn shape(&self, class: CubicClass, features: &[Feature]) -> PortionShape {
        let count = |name: &str, ends: bool| {
            let counts = |feature: &&Feature| feature.place == Place::Inside || (ends && feature.place == Place::Vertex);
            features.iter().filter(|feature| feature.name == name).filter(counts).count()
        };
        match class {
            CubicClass::Straight if self.is_point() => PortionShape::Point,
            CubicClass::Straight => PortionShape::Line,
            CubicClass::Parabolic => PortionShape::Quadratic,
            CubicClass::Loopy if count("crunode", true) == 2 => PortionShape::Loop,
            CubicClass::Pointy if count("cusp", true) == 1 => PortionShape::Cusp,
            CubicClass::Humpy | CubicClass::SShaped | CubicClass::Loopy | CubicClass::Pointy => match count("flex", false) {
                0 => PortionShape::Arch,
                1 => PortionShape::SingleInflection,
                _ => PortionShape::DoubleInflection,
            },
        }
    }
}
