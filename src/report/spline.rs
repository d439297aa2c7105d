//! Splines, and the neighbours of pieces, as people read about them.

use super::entry::Entry;
use super::formula::Notation;
use super::sheet::subscripts;
use crate::affine::Frame;
use crate::continuity::Continuity;
use crate::exact::Rational;
use crate::joint::Extension;
use crate::piece::Piece;
use crate::syntax::Style;
use crate::value::SplineFinding;

/// The polar label of a control point; the indices of rectangles become subscripts in LaTeX.
pub(super) fn label_text(label: &str, notation: &Notation) -> String {
    if notation.style == Style::Latex { subscripts(label) } else { label.to_owned() }
}

/// What a smooth neighbour is forced to have.
pub(super) fn extension(found: &Extension, notation: &Notation) -> Vec<Entry> {
    let mut lines = vec![frame(&found.continuation.frame(), notation)];
    for ((label, point), forced) in found.continuation.labels().iter().zip(found.continuation.points()).zip(&found.forced) {
        let label = label_text(label, notation);
        lines.push(match (forced, notation.style) {
            (true, _) => Entry::new("").with(format!("{label} = {}{}", notation.point(point), notation.approximately(point))),
            (false, Style::Latex) => Entry::new("").with(format!("{label}\\; \\text{{is free}}")),
            (false, _) => Entry::remark("", format!("{label} is free")),
        });
    }
    lines
}

fn frame(frame: &Frame<Rational>, notation: &Notation) -> Entry {
    let numbers: Vec<String> = frame.numbers().into_iter().map(|number| notation.number(number)).collect();
    let latex = notation.style == Style::Latex;
    match frame {
        Frame::Interval(_) => Entry::new("").with(format!("r = {}", numbers[0])).with(format!("s = {}", numbers[1])),
        Frame::Triangle(frame) => ["r", "s", "t"]
            .into_iter()
            .zip(frame.vertices())
            .fold(Entry::new(""), |entry, (name, vertex)| entry.with(format!("{name} = {}", notation.point(vertex)))),
        Frame::Rectangle(_) => ["r1", "s1", "r2", "s2"].into_iter().zip(numbers).fold(Entry::new(""), |entry, (name, number)| {
            let name = if latex { format!("{}_{}", &name[..1], &name[1..]) } else { name.to_owned() };
            entry.with(format!("{name} = {number}"))
        }),
    }
}

/// The Bézier pieces of a spline, and how they join.
pub(super) fn spline(found: &SplineFinding, notation: &Notation) -> Vec<Entry> {
    let mut lines = Vec::new();
    let latex = notation.style == Style::Latex;
    for segment in &found.pieces {
        let over = Frame::from(segment.frame().clone());
        lines.push(if latex { frame(&over, notation) } else { Entry::remark("", format!("over {}:", notation.frame(&over))) });
        let piece = Piece::Curve(segment.clone());
        for (label, point) in piece.labels().iter().zip(piece.points()) {
            lines.push(Entry::new("").with(format!("{label} = {}{}", notation.point(point), notation.approximately(point))).below());
        }
    }
    let degree = found.spline.degree();
    for join in &found.joins {
        let found = match join.order {
            Continuity::Same => "the same polynomial map on both sides".to_owned(),
            order => order.to_string(),
        };
        let promise = match degree.checked_sub(join.multiplicity) {
            Some(order) => format!("multiplicity {} promises C{order}", join.multiplicity),
            None => format!("multiplicity {} promises nothing", join.multiplicity),
        };
        let (knot, remark) = (notation.number(&join.knot), format!("{found} ({promise})"));
        lines.push(if latex { Entry::new("at").with(knot).with_remark(remark) } else { Entry::remark(&format!("at {knot}"), remark) });
    }
    if let Some(inserted) = &found.inserted {
        let knots: Vec<String> = inserted.knots().iter().map(|knot| notation.number(knot)).collect();
        let space = if latex { ",\\; " } else { " " };
        lines.push(Entry::new("with the knot inserted").with(knots.join(space)));
        lines.extend(
            inserted
                .points()
                .iter()
                .map(|point| Entry::new("").with(format!("{}{}", notation.point(point), notation.approximately(point))).below()),
        );
    }
    lines
}
