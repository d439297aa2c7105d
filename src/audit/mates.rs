//! Which sides of which pieces meet.

use std::borrow::Cow;
use std::collections::{HashMap, HashSet};

use super::corners::{Corners, is_near};
use super::domain;
use crate::affine::Interval;
use crate::exact::Rational;
use crate::model::{Model, Part};
use crate::segment::Segment;
use crate::side::{Arrangement, Side};
use crate::weights::projected;

/// A side of a part of a model.
pub(super) type Place = (usize, Side);

/// Two sides that meet.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Mate {
    pub(super) first: Place,
    pub(super) second: Place,
    /// Whether the sides run in opposite directions.
    pub(super) reversed: bool,
    /// Whether they share a part of the parameter space, from opposite sides.
    pub(super) shares_domain: bool,
    /// The index of the joint that the file states.
    pub(super) stated: Option<usize>,
}

/// What was found about the sides of a model.
#[derive(Debug, Default)]
pub(super) struct Mates {
    pub(super) pairs: Vec<Mate>,
    /// Sides that no other side meets.
    pub(super) open: usize,
    /// Edges that are one point.
    pub(super) collapsed: usize,
    /// Places where more than two sides meet.
    pub(super) branches: usize,
}

/// The control points of a side, without weights, in its direction.
fn boundary(part: &Part, side: Side) -> Option<Vec<Cow<'_, [Rational]>>> {
    let arrangement = Arrangement::of(&part.piece);
    (0..arrangement.columns(side, 0))
        .map(|column| {
            let point = part.piece.net().point(arrangement.index(side, 0, column));
            if part.rational { projected(point).map(Cow::Owned) } else { Some(Cow::Borrowed(point)) }
        })
        .collect()
}

/// The polynomial map of a side in homogeneous coordinates, so that equal curves
/// of unequal degrees and weights have equal numbers.
fn canonical(part: &Part, side: Side, reversed: bool) -> Option<Vec<Rational>> {
    let arrangement = Arrangement::of(&part.piece);
    let mut points: Vec<Vec<Rational>> = (0..arrangement.columns(side, 0))
        .map(|column| {
            let mut point = part.piece.net().point(arrangement.index(side, 0, column)).to_vec();
            if !part.rational {
                point.push(Rational::from(1));
            }
            point
        })
        .collect();
    if reversed {
        points.reverse();
    }
    let reduced = Segment::from_points(points, Interval::unit()).ok()?.reduce().ok()?.segment;
    let weight = reduced.point(0).last()?.recip()?;
    Some(reduced.coordinates().iter().map(|number| number * &weight).collect())
}

/// A graph over its parameters: one coordinate over a given frame has no place
/// of its own in space.
fn is_graph(part: &Part) -> bool {
    part.has_frame && part.piece.dimension() == 1 + usize::from(part.rational)
}

/// A side with the numbers of the points that it runs between.
struct Candidate {
    place: Place,
    from: u32,
    to: u32,
}

impl Mates {
    /// Finds them: the stated ones, those that share an edge of the parameter
    /// space, and those that lie at the same place, up to `snap`.
    pub(super) fn of(model: &Model, snap: Option<&Rational>) -> Self {
        let mut mates = Self::default();
        let mut taken: HashSet<Place> = HashSet::new();
        for (index, joint) in model.joints.iter().enumerate() {
            let (first, second) = ((joint.first, Side::End), (joint.second, Side::Start));
            taken.extend([first, second]);
            let shares_domain = domain::is_shared(&model.parts, first, second, false);
            mates.push(first, second, false, shares_domain, Some(index));
        }
        let mut open = Vec::new();
        if model.meets_by_position {
            mates.by_position(model, snap, &taken, &mut open);
            mates.open = mates.by_domain(model, open);
        } else {
            let sides = |part: &Part| Arrangement::of(&part.piece).sides().len();
            mates.open = model.parts.iter().map(sides).sum::<usize>() - taken.len();
        }
        mates.pairs.sort_unstable_by_key(|pair| (pair.first, pair.second));
        mates
    }

    fn push(&mut self, first: Place, second: Place, reversed: bool, shares_domain: bool, stated: Option<usize>) {
        let (first, second) = (first.min(second), first.max(second));
        self.pairs.push(Mate { first, second, reversed, shares_domain, stated });
    }

    fn by_position(&mut self, model: &Model, snap: Option<&Rational>, taken: &HashSet<Place>, open: &mut Vec<Place>) {
        let mut corners = Corners::default();
        let (mut ends, mut edges) = (Vec::new(), Vec::new());
        for (index, part) in model.parts.iter().enumerate() {
            let arrangement = Arrangement::of(&part.piece);
            for &side in arrangement.sides() {
                let place = (index, side);
                if taken.contains(&place) {
                    continue;
                }
                let points = if is_graph(part) { None } else { boundary(part, side) };
                let Some(points) = points.filter(|points| !points.is_empty()) else {
                    open.push(place);
                    continue;
                };
                let is_edge = !side.is_end();
                if is_edge && points.iter().all(|point| *point == points[0]) {
                    self.collapsed += 1;
                    continue;
                }
                let candidate =
                    Candidate { place, from: corners.number(points[0].clone()), to: corners.number(points[points.len() - 1].clone()) };
                if is_edge { edges.push(candidate) } else { ends.push(candidate) }
            }
        }
        if let Some(snap) = snap {
            let leaders = corners.snapped(snap);
            for candidate in ends.iter_mut().chain(&mut edges) {
                (candidate.from, candidate.to) = (leaders[candidate.from as usize], leaders[candidate.to as usize]);
            }
        }
        drop(corners);
        let between = |candidate: &Candidate| (candidate.from.min(candidate.to), candidate.from.max(candidate.to));
        ends.sort_by_key(between);
        for group in ends.chunk_by(|a, b| a.from == b.from) {
            match group {
                [one] => open.push(one.place),
                // Parameters run on from an end to a start; two starts run apart.
                [one, other] => self.meet(model, one.place, other.place, one.place.1 == other.place.1),
                _ => self.branches += 1,
            }
        }
        edges.sort_by_key(between);
        for group in edges.chunk_by(|a, b| between(a) == between(b)) {
            for class in classes(&model.parts, group, snap) {
                match class.as_slice() {
                    [(place, _)] => open.push(*place),
                    [(first, a), (second, b)] => self.meet(model, *first, *second, a != b),
                    _ => self.branches += 1,
                }
            }
        }
    }

    fn meet(&mut self, model: &Model, first: Place, second: Place, reversed: bool) {
        let shares_domain = domain::is_shared(&model.parts, first, second, reversed);
        self.push(first, second, reversed, shares_domain, None);
    }

    /// Sides of frames that meet though their points do not. Gives the number of
    /// those that are left.
    fn by_domain(&mut self, model: &Model, open: Vec<Place>) -> usize {
        let mut left = 0;
        let mut groups: HashMap<domain::Key, Vec<Place>> = HashMap::new();
        for place in open {
            match domain::key(&model.parts[place.0], place.1) {
                Some(key) => groups.entry(key).or_default().push(place),
                None => left += 1,
            }
        }
        for group in groups.into_values() {
            match group.as_slice() {
                &[first, second] => {
                    match [false, true].into_iter().find(|&reversed| domain::is_shared(&model.parts, first, second, reversed)) {
                        Some(reversed) => self.push(first, second, reversed, true, None),
                        None => left += 2,
                    }
                }
                others => left += others.len(),
            }
        }
        left
    }
}

/// The sides of a group with the same ends that are the same curve, each with
/// whether it runs against the common direction.
fn classes(parts: &[Part], group: &[Candidate], snap: Option<&Rational>) -> Vec<Vec<(Place, bool)>> {
    if group.len() == 1 {
        return vec![vec![(group[0].place, false)]];
    }
    let mut classes: Vec<Vec<(Place, bool)>> = Vec::new();
    if let ([one, other], None) = (group, snap)
        && let Some(reversed) = plainly_equal(parts, one.place, other.place)
    {
        return match reversed {
            Some(reversed) => vec![vec![(one.place, false), (other.place, reversed)]],
            None => vec![vec![(one.place, false)], vec![(other.place, false)]],
        };
    }
    if let Some(snap) = snap {
        // Few meet at two points; more than that is no surface.
        for candidate in group {
            let near = |class: &&mut Vec<(Place, bool)>| {
                let (place, _) = class[0];
                [false, true].into_iter().any(|reversed| is_boundary_near(parts, place, candidate.place, reversed, snap))
            };
            match classes.iter_mut().take(64).find(near) {
                None => classes.push(vec![(candidate.place, false)]),
                Some(class) => {
                    let straight = is_boundary_near(parts, class[0].0, candidate.place, false, snap);
                    class.push((candidate.place, !straight));
                }
            }
        }
        return classes;
    }
    let mut known: HashMap<Vec<Rational>, usize> = HashMap::new();
    for candidate in group {
        let part = &parts[candidate.place.0];
        let forward = canonical(part, candidate.place.1, false);
        let backward = || canonical(part, candidate.place.1, true);
        let (key, reversed) = match candidate.from.cmp(&candidate.to) {
            std::cmp::Ordering::Less => (forward, false),
            std::cmp::Ordering::Greater => (backward(), true),
            // A closed edge: one of its directions, the same for all.
            std::cmp::Ordering::Equal => {
                let backward = backward();
                if forward <= backward { (forward, false) } else { (backward, true) }
            }
        };
        let Some(key) = key else {
            classes.push(vec![(candidate.place, false)]);
            continue;
        };
        let index = *known.entry(key).or_insert_with(|| {
            classes.push(Vec::new());
            classes.len() - 1
        });
        classes[index].push((candidate.place, reversed));
    }
    classes
}

/// Whether two sides without weights and of one degree have the same control
/// points, in opposite directions or not; nothing is said of others.
fn plainly_equal(parts: &[Part], first: Place, second: Place) -> Option<Option<bool>> {
    let (a, b) = (&parts[first.0], &parts[second.0]);
    let (of_a, of_b) = (Arrangement::of(&a.piece), Arrangement::of(&b.piece));
    let count = of_a.columns(first.1, 0);
    if a.rational || b.rational || count != of_b.columns(second.1, 0) {
        return None;
    }
    let agree = |reversed: bool| {
        (0..count).all(|column| {
            let other = if reversed { count - 1 - column } else { column };
            a.piece.net().point(of_a.index(first.1, 0, column)) == b.piece.net().point(of_b.index(second.1, 0, other))
        })
    };
    Some([false, true].into_iter().find(|&reversed| agree(reversed)))
}

fn is_boundary_near(parts: &[Part], first: Place, second: Place, reversed: bool, snap: &Rational) -> bool {
    let (Some(a), Some(mut b)) = (boundary(&parts[first.0], first.1), boundary(&parts[second.0], second.1)) else { return false };
    if reversed {
        b.reverse();
    }
    // Unequal degrees have control points at unequal places: both are raised.
    let raise = |points: Vec<Cow<'_, [Rational]>>, degree: usize| -> Option<Vec<Vec<Rational>>> {
        let points: Vec<Vec<Rational>> = points.into_iter().map(Cow::into_owned).collect();
        if points.len() == degree + 1 {
            return Some(points);
        }
        let by = degree + 1 - points.len();
        let segment = Segment::from_points(points, Interval::unit()).ok()?.elevate(by).ok()?;
        Some(segment.points().map(<[Rational]>::to_vec).collect())
    };
    let degree = a.len().max(b.len()) - 1;
    let (Some(a), Some(b)) = (raise(a, degree), raise(b, degree)) else { return false };
    a.iter().zip(&b).all(|(a, b)| is_near(a, b, snap))
}
