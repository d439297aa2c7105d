//! The rules that joins are held to, with their codes.

use crate::audit::{Contact, Join, Requirement, Verdict};
use crate::continuity::Continuity;
use crate::report::notice::{Level, Rule};

/// Every rule of `check`, in the order of the codes.
pub static RULES: [Rule; 9] = [
    Rule {
        code: "J001",
        name: "broken",
        level: Level::Error,
        summary: "Two pieces that belong together do not meet.",
        explanation: "The file says that one piece goes on as the other, by its knots or by frames that share a parameter or an edge, but their \
                      points there differ. Not even C0 holds.\n\n\
                      Make the control points of the joint equal. A knot of a spline whose multiplicity exceeds the degree breaks it on purpose: \
                      then require nothing there.",
    },
    Rule {
        code: "J002",
        name: "kink",
        level: Level::Error,
        summary: "Two pieces meet at an angle.",
        explanation: "The tangents of two curves, or the tangent planes of two patches somewhere along their edge, differ: G1 does not hold, and so \
                      neither do C1, C2 and G2.\n\n\
                      Of curves the two handles must lie on one line through the joint, on opposite sides. The report says how far one control \
                      point would have to move, and whether half a unit of the last printed digit explains the difference; then the pieces were \
                      smooth before they were printed, and --tolerance rounding accepts them. --tolerance 0.01deg or 0.5unit accepts what is \
                      that near. `casteljau join A B --repair` prints the nearest control points that are smooth.",
    },
    Rule {
        code: "J003",
        name: "fold",
        level: Level::Error,
        summary: "Two pieces touch, but turn back: a cusp or a fold.",
        explanation: "The tangents lie on one line, or the tangent planes are one, but both pieces lie on the same side of the joint. A curve turns \
                      back in a cusp, a surface is folded. Often a control point was put on the wrong side of the joint.",
    },
    Rule {
        code: "J004",
        name: "first-derivatives",
        level: Level::Error,
        summary: "The pieces run on smoothly, but with another speed: G1 holds and C1 does not.",
        explanation: "The differences of control points on both sides are proportional and not equal. If only the shape matters, require G1; the \
                      ratio in the report is the second difference over the first. C1 is about parameters: over unit intervals the differences \
                      behind the joint must be equal for pieces of one degree; over given frames they are in the ratio of the lengths.",
    },
    Rule {
        code: "J005",
        name: "second-derivatives",
        level: Level::Error,
        summary: "First derivatives agree and second ones do not: C1 holds and C2 does not.",
        explanation: "Continue the first piece over the frame of the second by de Casteljau's algorithm: its control points up to the second row \
                      behind the joint are those that C2 asks of the second piece. `casteljau join A B --extend` prints them.",
    },
    Rule {
        code: "J006",
        name: "curvature",
        level: Level::Error,
        summary: "The tangents run on and the curvatures differ: G1 holds and G2 does not.",
        explanation: "The second derivatives differ by more than a multiple of the tangent. G2 has no tolerance: either it holds or it does not.",
    },
    Rule {
        code: "J010",
        name: "degenerate",
        level: Level::Note,
        summary: "There is no tangent or tangent plane that could agree.",
        explanation: "The handle of a curve at the joint is zero; or a patch has no tangent plane all along the edge, since its second row of control \
                      points is the first; or the tangent planes agree but a normal vanishes at single points. Smoothness cannot be told from \
                      first differences there. Such joins are counted and fail nothing.",
    },
    Rule {
        code: "J020",
        name: "not-bezier",
        level: Level::Note,
        summary: "Something in the file is no Bézier piece and was passed over.",
        explanation: "An arc of a path is part of an ellipse, which no polynomial curve is; polyhedra have no control points. Joins at them are not \
                      checked.",
    },
    Rule {
        code: "J021",
        name: "branch",
        level: Level::Note,
        summary: "More than two pieces meet at one end or edge.",
        explanation: "Which of them should run on as which is not known, so no join there is checked.",
    },
];

fn rule(code: &str) -> &'static Rule {
    RULES.iter().find(|rule| rule.code == code).unwrap_or(&RULES[0])
}

/// The rule that passed over things break.
pub(super) fn omission() -> &'static Rule {
    rule("J020")
}

/// The rule for places where more than two pieces meet.
pub(super) fn branch() -> &'static Rule {
    rule("J021")
}

/// The rule that a join breaks, if it breaks one.
#[must_use]
pub fn rule_of(join: &Join) -> Option<&'static Rule> {
    let code = match join.verdict {
        Verdict::Exact | Verdict::Within | Verdict::Reported => return None,
        Verdict::Degenerate => "J010",
        Verdict::Violated => match (join.parametric, join.contact, join.requirement?) {
            (Continuity::Broken, ..) => "J001",
            (_, Contact::Fold, _) => "J003",
            (_, Contact::Kink, _) => "J002",
            (_, _, Requirement::G2) => "J006",
            (Continuity::C(0), ..) => "J004",
            _ => "J005",
        },
    };
    Some(rule(code))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn codes_are_in_order_and_there_is_one_rule_for_each() {
        assert!(RULES.windows(2).all(|pair| pair[0].code < pair[1].code));
        assert!(["J001", "J002", "J003", "J004", "J005", "J006", "J010", "J020", "J021"].iter().all(|code| rule(code).code == *code));
    }
}
