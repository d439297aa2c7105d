//! Judging one join: its orders, how far it is from a higher one, the verdict.

use num_bigint::{BigInt, BigUint};
use num_traits::{Signed, Zero};

use super::angle;
use super::field::{Field, Fields, fields};
use super::join::{Join, Terms};
use super::lattice::{Lattice, Points, View, Visitor, Whole};
use super::mates::Mate;
use super::offset::{Columns, is_explained_by_rounding, least_move};
use super::order;
use super::pair::Pair;
use super::requirement::Requirement;
use super::tangent::{Contact, Tangency, of_curves, of_patches};
use super::verdict::{Rounding, Verdict};
use crate::continuity::Continuity;
use crate::exact::Rational;
use crate::exact::width::Ring;
use crate::model::Model;
use crate::side::Arrangement;

/// The judge of one pair of sides.
pub(super) struct Judge<'a> {
    pub(super) model: &'a Model,
    pub(super) lattice: &'a Lattice,
    /// Half a unit of the last printed digit, times the scale of the lattice.
    pub(super) half: &'a Rational,
    pub(super) terms: &'a Terms,
    pub(super) mate: &'a Mate,
}

impl Visitor for Judge<'_> {
    type Output = Join;

    fn visit<P: Points + ?Sized>(&self, points: &P) -> Join {
        let Mate { first, second, reversed, shares_domain, stated } = *self.mate;
        let parts = &self.model.parts;
        let (part_a, part_b) = (&parts[first.0], &parts[second.0]);
        let a = self.lattice.view(points, first.0, first.1, false);
        let b = self.lattice.view(points, second.0, second.1, reversed && !first.1.is_end());
        let rational = part_a.rational || part_b.rational;
        let pair = Pair { parts, mate: self.mate };
        let both_rectangles = matches!((a.arrangement(), b.arrangement()), (Arrangement::Rectangle(..), Arrangement::Rectangle(..)));
        let parametric =
            if !shares_domain && !rational && (first.1.is_end() || both_rectangles) { order::order(&a, &b) } else { pair.parametric() };
        let in_space = |view: &View<'_, P>, rational: bool| view.dimension() - usize::from(rational);
        let tangency = if in_space(&a, part_a.rational) == in_space(&b, part_b.rational) {
            let (of_a, of_b) = (fields(&a, part_a.rational), fields(&b, part_b.rational));
            self.tangency(of_a, of_b, &pair)
        } else {
            Tangency { contact: Contact::NotAsked, ratio: None, sin2: None, obtuse: false }
        };
        let met = parametric > Continuity::Broken;
        let geometric = met.then(|| match tangency.contact {
            Contact::Smooth if first.1.is_end() => pair.geometric_curves().unwrap_or(1).max(1),
            Contact::Smooth => 1,
            Contact::NotAsked => usize::from(parametric >= Continuity::C(1)),
            _ => 0,
        });
        let requirement = self
            .terms
            .require
            .or_else(|| stated.filter(|&index| self.model.joints[index].smooth && !self.terms.ignores_promises).map(|_| Requirement::G1));
        let handles = if rational { None } else { handles(&a, &b) };
        let smooth = met && tangency.contact == Contact::Smooth;
        let offset2 = match (&handles, smooth) {
            (_, true) => Some(Rational::from(0)),
            (Some([a, b]), false) if !tangency.contact.is_degenerate() => least_move(a, b, &self.lattice.scale),
            _ => None,
        };
        let mut join = Join {
            first,
            second,
            reversed,
            stated,
            parametric,
            geometric,
            contact: tangency.contact,
            ratio: tangency.ratio,
            sin2: tangency.sin2,
            obtuse: tangency.obtuse,
            offset2,
            rounding: Rounding::Unknown,
            requirement,
            verdict: Verdict::Reported,
            points: Vec::new(),
            handles: Default::default(),
        };
        let required = requirement.unwrap_or(Requirement::G1);
        join.rounding = self.rounding(&join, required, handles.as_ref(), &pair);
        if let Some(requirement) = requirement {
            join.verdict = self.verdict(&join, requirement, &pair, || {
                let of_a = fields(&a, part_a.rational);
                let of_b = fields(&b, part_b.rational);
                Some([of_a.along?.widened(), of_a.into.widened(), of_b.into.widened()])
            });
        }
        // What leads to a finding; most joins are none.
        if matches!(join.verdict, Verdict::Violated | Verdict::Degenerate) || first.1.is_end() {
            join.points = (0..a.columns(0)).map(|column| scaled(a.point(0, column), &self.lattice.scale)).collect();
            if let Some(handles) = handles {
                join.handles = handles.map(|columns| columns.into_iter().map(|column| scaled(column, &self.lattice.scale)).collect());
            }
        }
        join
    }
}

fn scaled<W: Into<BigInt>>(numbers: Vec<W>, scale: &BigUint) -> Vec<Rational> {
    numbers.into_iter().map(|number| Rational::from_big(number.into(), scale.clone().into())).collect()
}

/// The differences behind a joint, column by column; none where the pieces have
/// different numbers of them.
fn handles<P: Points + ?Sized>(a: &View<'_, P>, b: &View<'_, P>) -> Option<[Columns<P::Number>; 2]> {
    if a.degree_across() == 0 || b.degree_across() == 0 || a.dimension() != b.dimension() || a.columns(1) != b.columns(1) {
        return None;
    }
    let columns = |view: &View<'_, P>| -> Columns<P::Number> {
        let entry = |column: usize, axis: usize| {
            let mut difference = view.get(1, column, axis);
            difference.subtract(&view.get(0, column, axis));
            difference
        };
        (0..view.columns(1)).map(|column| (0..view.dimension()).map(|axis| entry(column, axis)).collect()).collect()
    };
    Some([columns(a), columns(b)])
}

impl Judge<'_> {
    fn tangency<W: Whole>(&self, a: Fields<W>, b: Fields<W>, pair: &Pair<'_>) -> Tangency {
        let Mate { first, second, .. } = self.mate;
        let parts = &self.model.parts;
        let mut tangency = match a.along {
            None => of_curves(&a.into, &b.into),
            Some(along) => {
                let is_triangle = |index: usize| matches!(Arrangement::of(&parts[index].piece), Arrangement::Triangle(_));
                of_patches(&along, &a.into, &b.into, is_triangle(first.0) || is_triangle(second.0))
            }
        };
        // Homogeneous differences are weighted, and their weights may differ by a factor.
        if let (Some(ratio), Some(factor)) = (&tangency.ratio, pair.weight_ratio()) {
            tangency.ratio = Some(ratio / factor.pow(2));
        }
        tangency
    }

    fn rounding<W: Whole>(&self, join: &Join, requirement: Requirement, handles: Option<&[Columns<W>; 2]>, pair: &Pair<'_>) -> Rounding {
        if is_met(join, requirement) {
            return Rounding::Yes;
        }
        let Some([a, b]) = handles else { return Rounding::Unknown };
        let is_curve = join.first.1.is_end();
        let patches = !is_curve && !pair.are_rectangles();
        if requirement.order() != 1 || patches || join.contact.is_degenerate() || join.parametric == Continuity::Broken {
            return Rounding::Unknown;
        }
        let lambda = if requirement.is_geometric() { None } else { pair.parametric_ratio() };
        let explained = is_explained_by_rounding(a, b, self.half, !is_curve, lambda.as_ref());
        match (explained, is_curve || !requirement.is_geometric()) {
            (true, _) => Rounding::Yes,
            (false, true) => Rounding::No,
            // Patches may also be smooth with a ratio that varies.
            (false, false) => Rounding::Unknown,
        }
    }

    fn verdict(
        &self,
        join: &Join,
        requirement: Requirement,
        pair: &Pair<'_>,
        fields: impl FnOnce() -> Option<[Field<BigInt>; 3]>,
    ) -> Verdict {
        if is_met(join, requirement) {
            return Verdict::Exact;
        }
        if requirement.order() > 0 && join.contact.is_degenerate() {
            return Verdict::Degenerate;
        }
        let tolerance = &self.terms.tolerance;
        if tolerance.accepts_rounding() && join.rounding == Rounding::Yes {
            return Verdict::Within;
        }
        // Ends that were matched up to the snap are where they were accepted to be.
        let snapped = join.parametric == Continuity::Broken && join.stated.is_none() && !self.mate.shares_domain;
        if requirement == Requirement::C0 {
            return if snapped { Verdict::Within } else { Verdict::Violated };
        }
        let angle = tolerance.sin2().map(|bound| self.is_angle_within(join, bound, fields));
        let moved = tolerance.unit().map(|unit| {
            let allowed = unit.pow(2);
            let move2 = if requirement.is_geometric() { join.offset2.clone() } else { pair.least_move(requirement.order()) };
            move2.is_some_and(|move2| move2 <= allowed)
        });
        let meets = match requirement {
            // An angle says nothing of lengths.
            Requirement::C1 | Requirement::C2 => moved == Some(true) && angle != Some(false),
            Requirement::G1 => (angle.is_some() || moved.is_some()) && angle != Some(false) && moved != Some(false),
            Requirement::C0 | Requirement::G2 => false,
        };
        let only_snapped = snapped && requirement == Requirement::G1 && join.contact == Contact::Smooth;
        let apart = join.parametric == Continuity::Broken && !snapped;
        if (meets || only_snapped) && !apart { Verdict::Within } else { Verdict::Violated }
    }

    /// Whether the angle is at most the one that was stated, decided exactly.
    fn is_angle_within(&self, join: &Join, bound: &Rational, fields: impl FnOnce() -> Option<[Field<BigInt>; 3]>) -> bool {
        let Some([low, high]) = &join.sin2 else { return false };
        if join.obtuse || low > bound {
            return false;
        }
        if high <= bound {
            return true;
        }
        fields().is_some_and(|[along, a, b]| angle::is_within(bound, &along, [&a, &b]))
    }
}

/// Whether a join has an order exactly.
fn is_met(join: &Join, requirement: Requirement) -> bool {
    if requirement.is_geometric() {
        join.geometric.is_some_and(|order| order >= requirement.order())
    } else {
        join.parametric >= Continuity::C(requirement.order())
    }
}

/// Half a unit of the last printed digit, on a lattice.
pub(super) fn half_unit(decimals: u32, scale: &BigUint) -> Rational {
    let unit = BigInt::from(10u32).pow(decimals.min(u32::from(u16::MAX)));
    let half = Rational::from_big(BigInt::from(scale.clone()), unit * 2);
    debug_assert!(half.is_positive() && !half.is_zero());
    half
}
