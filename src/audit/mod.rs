//! Checking all joins of a model: which pieces meet, how smoothly, and whether
//! that is what was required.

mod angle;
mod domain;
mod field;
mod join;
mod lattice;
mod mates;
mod offset;
mod order;
mod pair;
mod requirement;
mod sign;
mod tangent;
mod tolerance;

use rayon::prelude::*;

use self::join::Judge;
use self::lattice::Lattice;
use self::mates::Mates;
use crate::error::Error;
use crate::exact::Rational;
use crate::model::Model;
use crate::piece::Piece;

pub use join::{Join, Rounding, Terms, Verdict};
pub use requirement::Requirement;
pub use tangent::Contact;
pub use tolerance::Tolerance;

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

/// The highest degree of pieces whose joins are checked.
pub const MAX_DEGREE: usize = 128;

/// Finds the joins of a model and judges them, on all threads of the current
/// pool; the answer does not depend on their number.
///
/// # Errors
/// [`Error::TooLarge`] for degrees above [`MAX_DEGREE`] or a common denominator
/// that would not fit the memory; [`Error::Unsupported`] if what is required is
/// not defined: G2 of patches, C1 or C2 of triangles without a common domain.
pub fn audit(model: &Model, terms: &Terms, snap: Option<&Rational>) -> Result<Audit, Error> {
    for part in &model.parts {
        let degree = match &part.piece {
            Piece::Curve(segment) => segment.degree(),
            Piece::Triangle(patch) => patch.degree(),
            Piece::Rectangle(patch) => patch.degree().0.max(patch.degree().1),
        };
        if degree > MAX_DEGREE {
            return Err(Error::TooLarge { what: "degree of a piece whose joins are checked", limit: MAX_DEGREE });
        }
    }
    let mates = Mates::of(model, snap);
    for mate in &mates.pairs {
        refuse_undefined(model, mate, terms)?;
    }
    let lattice = Lattice::of(&model.parts)?;
    let half = join::half_unit(model.decimals, &lattice.scale);
    let judged = |mate| lattice.visit(&Judge { model, lattice: &lattice, half: &half, terms, mate });
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
