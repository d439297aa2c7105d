//! Checking all joins of a model: which pieces meet, how smoothly, and whether
//! that is what was required.

mod angle;
mod corners;
mod domain;
mod field;
mod join;
mod judge;
mod lattice;
mod mates;
mod offset;
mod order;
mod pair;
mod requirement;
mod sign;
mod tangent;
mod tolerance;
mod verdict;

use rayon::prelude::*;

use self::judge::Judge;
use self::lattice::Lattice;
use self::mates::Mates;
use crate::error::Error;
use crate::exact::Rational;
use crate::model::Model;
use crate::piece::Piece;

pub use join::{Join, Terms};
pub use requirement::Requirement;
pub use tangent::Contact;
pub use tolerance::Tolerance;
pub use verdict::{Rounding, Verdict};

/// What was found of the joins of a model.
#[derive(Clone, Debug)]
pub struct Audit {
    /// The joins, ordered by the first side, then the second.
    pub joins: Vec<Join>,
    /// Ends and edges that nothing meets.
    pub open: usize,
    /// Edges that are one point, which are no joins.
    pub collapsed: usize,
    /// Places where more than two sides meet, which are not judged.
    pub branches: usize,
}

/// The highest degree of curves whose joins are checked.
pub const MAX_DEGREE: usize = 128;
/// The highest degree of patches, in one parameter, whose joins are checked.
pub const MAX_PATCH_DEGREE: usize = 40;

/// Finds the joins of a model and judges them, on all threads of the current
/// pool; the answer does not depend on their number.
///
/// # Errors
/// [`Error::TooLarge`] for degrees above [`MAX_DEGREE`] or [`MAX_PATCH_DEGREE`];
/// [`Error::Unsupported`] if what is required is
/// not defined: G2 of patches, C1 or C2 of triangles without a common domain.
pub fn audit(model: &Model, terms: &Terms, snap: Option<&Rational>) -> Result<Audit, Error> {
    for part in &model.parts {
        let (degree, limit, what) = match &part.piece {
            Piece::Curve(segment) => (segment.degree(), MAX_DEGREE, "degree of a curve whose joins are checked"),
            Piece::Triangle(patch) => (patch.degree(), MAX_PATCH_DEGREE, "degree of a patch whose joins are checked"),
            Piece::Rectangle(patch) => {
                (patch.degree().0.max(patch.degree().1), MAX_PATCH_DEGREE, "degree of a patch whose joins are checked")
            }
        };
        if degree > limit {
            return Err(Error::TooLarge { what, limit });
        }
    }
    let mates = Mates::of(model, snap);
    for mate in &mates.pairs {
        refuse_undefined(model, mate, terms)?;
    }
    let with_half = |lattice: Lattice| {
        let half = judge::half_unit(model.decimals, &lattice.scale);
        (lattice, half)
    };
    let common = Lattice::of_all(&model.parts).map(with_half);
    let judged = |mate: &mates::Mate| {
        let on = |(lattice, half): &(Lattice, Rational)| lattice.visit(&Judge { model, lattice, half, terms, mate });
        match &common {
            Some(common) => on(common),
            None => on(&with_half(Lattice::of_two(&model.parts, [mate.first.0, mate.second.0]))),
        }
    };
    let joins = mates.pairs.par_iter().map(judged).collect();
    Ok(Audit { joins, open: mates.open, collapsed: mates.collapsed, branches: mates.branches })
}

fn refuse_undefined(model: &Model, mate: &mates::Mate, terms: &Terms) -> Result<(), Error> {
    let Some(requirement) = terms.require else { return Ok(()) };
    let pieces = [mate.first, mate.second].map(|(index, _)| &model.parts[index].piece);
    let patches = !matches!(pieces[0], Piece::Curve(_));
    if patches && requirement == Requirement::G2 {
        return Err(Error::Unsupported("G2 is checked between curves only; patches can be held to C0, C1, C2 or G1".into()));
    }
    let triangle = pieces.iter().any(|piece| matches!(piece, Piece::Triangle(_)));
    if triangle && !mate.shares_domain && requirement.order() > 0 && !requirement.is_geometric() {
        return Err(Error::Unsupported(format!(
            "{requirement} between triangles needs their frames, with a common edge in the parameter plane; without frames they can be held to G1"
        )));
    }
    Ok(())
}
