//! Laws of checking joins: every fast answer against a slow one from the
//! definition, and what must not depend on how a model is written down.

use casteljau::audit::{Audit, Contact, Join, Requirement, Rounding, Terms, Verdict, audit};
use casteljau::model::{Decimals, Format, Model, Part, Place};
use casteljau::{
    Continuity, Interval, Piece, Rational, Rectangle, RectangularPatch, Segment, Side, Triangle, TriangularPatch, continuity_of_curves,
    continuity_of_surfaces, tangent_plane_join,
};
use proptest::prelude::*;

fn q(n: i64) -> Rational {
    Rational::from(n)
}

fn model(pieces: Vec<Piece>, has_frame: bool) -> Model {
    let part = |piece| Part { piece, rational: false, has_frame, name: None, place: Place { line: 1, column: 1 } };
    Model {
        format: Format::Shape,
        parts: pieces.into_iter().map(part).collect(),
        joints: Vec::new(),
        meets_by_position: true,
        decimals: Decimals::default().finest(),
        omissions: Vec::new(),
    }
}

fn requiring(require: Requirement) -> Terms {
    Terms { require: Some(require), ..Terms::default() }
}

fn checked(pieces: Vec<Piece>, terms: &Terms) -> Audit {
    audit(&model(pieces, false), terms, None).expect("an audit")
}

fn rectangle(rows: &[Vec<[i64; 3]>]) -> Piece {
    let rows = rows.iter().map(|row| row.iter().map(|point| point.map(q).to_vec()).collect()).collect();
    Piece::Rectangle(RectangularPatch::from_rows(rows, Rectangle::unit()).expect("rows"))
}

/// A net with its rows along u; `flip` and `turn` write the same patch in other words.
fn rearranged(rows: &[Vec<[i64; 3]>], turn: bool, flip_u: bool, flip_v: bool) -> Vec<Vec<[i64; 3]>> {
    let mut rows = rows.to_vec();
    if flip_u {
        rows.reverse();
    }
    if flip_v {
        rows.iter_mut().for_each(|row| row.reverse());
    }
    if turn { (0..rows[0].len()).map(|j| rows.iter().map(|row| row[j]).collect()).collect() } else { rows }
}

type Net = Vec<Vec<[i64; 3]>>;

fn points(count: usize, range: i64) -> impl Strategy<Value = Vec<[i64; 3]>> {
    prop::collection::vec([-range..=range, -range..=range, -range..=range], count)
}

/// Two bicubic or lower nets that share the last row of the first and the first
/// row of the second, continued with a ratio up to some order, or not at all.
fn neighbours() -> impl Strategy<Value = (Net, Net, i64)> {
    (1usize..=3, 1usize..=3, 0usize..=3, 1i64..=3).prop_flat_map(|(across, along, order, ratio)| {
        let order = order.min(across);
        (prop::collection::vec(points(along + 1, 9), across + 1), prop::collection::vec(points(along + 1, 9), across + 1)).prop_map(
            move |(first, mut second): (Net, Net)| {
                // Row i of the second: the extrapolation of the first, as far as the order goes.
                let choose = |n: usize, k: usize| (0..k as i64).fold(1, |product, j| product * (n as i64 - j) / (j + 1));
                let difference = |k: usize, column: usize, axis: usize| -> i64 {
                    let term = |l: usize| choose(k, l) * first[first.len() - 1 - l][column][axis];
                    (0..=k).map(|l| if (k - l).is_multiple_of(2) { term(l) } else { -term(l) }).sum()
                };
                for (i, row) in second.iter_mut().enumerate().take(order + 1) {
                    for (column, point) in row.iter_mut().enumerate() {
                        for (axis, number) in point.iter_mut().enumerate() {
                            *number = (0..=i).map(|k| choose(i, k) * difference(k, column, axis) * (-ratio).pow(k as u32)).sum();
                        }
                    }
                }
                (first, second, ratio)
            },
        )
    })
}

/// The order by the definition: the patches over neighbouring squares.
fn slow_order(first: &Net, second: &Net) -> Continuity {
    let patch = |net: &Net, from: i64| {
        let rows = net.iter().map(|row| row.iter().map(|point| point.map(q).to_vec()).collect()).collect();
        let frame = Rectangle::new(Interval::new(q(from), q(from + 1)).expect("different"), Interval::unit());
        RectangularPatch::from_rows(rows, frame).expect("rows").surface().expect("a surface")
    };
    let edge = [[q(1), q(0)], [q(1), q(1)]];
    continuity_of_surfaces(&patch(first, 0), &patch(second, 1), &edge).expect("an order")
}

fn is_collapsed(row: &[[i64; 3]]) -> bool {
    row.iter().all(|point| *point == row[0])
}

/// The squared sine of the angle between the tangent planes at a parameter of
/// the edge, from values of the patches' derivatives.
fn slow_sine(first: &Net, second: &Net, at: &Rational) -> Option<Rational> {
    let value = |row: Vec<Vec<Rational>>| Segment::from_points(row, Interval::unit()).expect("a row").value(at).expect("a value");
    let row = |net: &Net, k: usize| net[k].iter().map(|point| point.map(q).to_vec()).collect::<Vec<_>>();
    let minus = |a: &[Rational], b: &[Rational]| a.iter().zip(b).map(|(a, b)| a - b).collect::<Vec<Rational>>();
    let last = first.len() - 1;
    let edge = Segment::from_points(row(first, last), Interval::unit()).expect("a row");
    let along = edge.derivative().expect("a derivative").value(at).expect("a value");
    let p = minus(&value(row(first, last - 1)), &value(row(first, last)));
    let r = minus(&value(row(second, 1)), &value(row(second, 0)));
    let cross = |a: &[Rational], b: &[Rational]| {
        let entry = |i: usize, j: usize| &a[i] * &b[j] - &a[j] * &b[i];
        vec![entry(1, 2), entry(2, 0), entry(0, 1)]
    };
    let square = |a: &[Rational]| a.iter().map(|x| x * x).sum::<Rational>();
    let (n1, n2) = (cross(&along, &p), cross(&along, &r));
    square(&cross(&n1, &n2)).checked_div(&(square(&n1) * square(&n2)))
}

/// The join of two pieces, where chance has made no other: of a piece with
/// itself, or of more than two sides at one place, which is not judged.
fn only(audit: &Audit) -> Option<&Join> {
    match audit.joins.as_slice() {
        [join] if audit.branches == 0 && join.first.0 != join.second.0 => Some(join),
        _ => None,
    }
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 192, ..ProptestConfig::default() })]

    #[test]
    fn the_order_of_rectangles_is_that_of_their_maps((first, second, _) in neighbours()) {
        let audit = checked(vec![rectangle(&first), rectangle(&second)], &Terms::default());
        // Chance may let more than one pair of edges agree, or collapse one.
        if let Some(join) = only(&audit).filter(|_| !is_collapsed(&second[0])) {
            prop_assert_eq!((join.first, join.second), ((0, Side::U1), (1, Side::U0)));
            prop_assert_eq!(join.parametric, slow_order(&first, &second));
        }
    }

    #[test]
    fn joins_do_not_depend_on_how_patches_are_written(
        (first, second, _) in neighbours(), how in [any::<bool>(), any::<bool>(), any::<bool>(), any::<bool>(), any::<bool>(), any::<bool>()], swapped in any::<bool>(),
    ) {
        let [a, b, c, d, e, f] = how;
        let plain = checked(vec![rectangle(&first), rectangle(&second)], &requiring(Requirement::G1));
        let mut pieces = vec![rectangle(&rearranged(&first, a, b, c)), rectangle(&rearranged(&second, d, e, f))];
        if swapped {
            pieces.reverse();
        }
        let other = checked(pieces, &requiring(Requirement::G1));
        prop_assert_eq!((plain.joins.len(), plain.open, plain.collapsed), (other.joins.len(), other.open, other.collapsed));
        if let (Some(one), Some(two)) = (only(&plain), only(&other)) {
            let told = |join: &Join| (join.verdict, join.parametric, join.geometric, join.contact, join.offset2.clone(), join.rounding, join.obtuse);
            prop_assert_eq!(told(one), told(two));
            let ratio = if swapped { two.ratio.as_ref().and_then(Rational::recip) } else { two.ratio.clone() };
            prop_assert_eq!(&one.ratio, &ratio);
            prop_assert_eq!(casteljau::report::joins::fingerprint(one), casteljau::report::joins::fingerprint(two));
        }
    }

    #[test]
    fn tangent_planes_agree_where_their_polynomials_do((first, second, _) in neighbours()) {
        // The twin computes with polynomials over the rational numbers.
        let audit = checked(vec![rectangle(&first), rectangle(&second)], &Terms::default());
        let Some(join) = only(&audit) else { return Ok(()) };
        let slow = tangent_plane_join((&rectangle(&first), join.first.1), (&rectangle(&second), join.second.1), false).expect("a comparison");
        let expected = match (slow.coplanar, slow.opposite_sides) {
            _ if join.contact.is_degenerate() => {
                prop_assert!(slow.g1() != Some(false));
                return Ok(());
            }
            (Some(true), Some(true)) => Contact::Smooth,
            (Some(true), Some(false)) => Contact::Fold,
            (Some(false), _) => Contact::Kink,
            // The twin leaves open what a constant ratio settles.
            _ => {
                prop_assert!(join.ratio.is_some());
                return Ok(());
            }
        };
        prop_assert_eq!(join.contact, expected);
        if let Some(ratio) = &join.ratio {
            prop_assert_eq!(slow.ratio.and_then(|quotient| quotient.constant()), Some(ratio.clone()));
        }
    }

    #[test]
    fn a_constant_ratio_is_found((first, second, ratio) in neighbours()) {
        let audit = checked(vec![rectangle(&first), rectangle(&second)], &requiring(Requirement::G1));
        let Some(join) = only(&audit).filter(|_| !is_collapsed(&second[0])) else { return Ok(()) };
        let rows = |net: &Net, a: usize, b: usize| -> Vec<[i64; 3]> {
            net[a].iter().zip(&net[b]).map(|(x, y)| [x[0] - y[0], x[1] - y[1], x[2] - y[2]]).collect()
        };
        let into = [rows(&first, first.len() - 2, first.len() - 1), rows(&second, 1, 0)];
        let planted = into[0].iter().zip(&into[1]).all(|(p, r)| (0..3).all(|axis| r[axis] == -ratio * p[axis]));
        if planted && into[0].iter().any(|point| *point != [0, 0, 0]) && join.contact != Contact::NoTangentPlane {
            prop_assert_eq!(join.ratio.clone(), Some(q(ratio)));
            prop_assert_eq!((join.verdict, join.geometric, join.contact), (Verdict::Exact, Some(1), Contact::Smooth));
            prop_assert_eq!(&join.offset2, &Some(q(0)));
            prop_assert_eq!(join.parametric >= Continuity::C(1), ratio == 1);
        }
    }

    #[test]
    fn no_angle_of_the_edge_is_outside_of_the_bounds((first, second, _) in neighbours(), place in 0i64..=16) {
        let audit = checked(vec![rectangle(&first), rectangle(&second)], &Terms::default());
        let (Some(join), at) = (only(&audit).filter(|_| !is_collapsed(&second[0])), Rational::new(place, 16)) else { return Ok(()) };
        // (That the lower bound is reached is a test beside the bounds: peaks can be narrow.)
        if let (Some([low, high]), Some(sine)) = (&join.sin2, slow_sine(&first, &second, &at)) {
            prop_assert!(low <= high && sine <= *high, "sin² = {} at {}, bounds {} and {}", sine, at, low, high);
        }
    }

    #[test]
    fn a_tolerance_divides_where_the_angle_is(
        (first, second, _) in neighbours(), place in 0i64..=8,
    ) {
        let plain = checked(vec![rectangle(&first), rectangle(&second)], &requiring(Requirement::G1));
        let Some(join) = only(&plain).filter(|join| !is_collapsed(&second[0]) && join.contact == Contact::Kink && !join.obtuse) else { return Ok(()) };
        let Some(sine) = slow_sine(&first, &second, &Rational::new(place, 8)) else { return Ok(()) };
        for degrees in ["0.5deg", "5deg", "30deg", "60deg", "89deg"] {
            let terms = Terms { require: Some(Requirement::G1), tolerance: degrees.parse().expect("a tolerance"), ..Terms::default() };
            let bound = terms.tolerance.sin2().cloned().expect("an angle");
            let audit = checked(vec![rectangle(&first), rectangle(&second)], &terms);
            let verdict = audit.joins[0].verdict;
            let [low, high] = join.sin2.clone().expect("bounds");
            if sine > bound || low > bound {
                prop_assert_eq!(verdict, Verdict::Violated);
            }
            if high <= bound {
                prop_assert_eq!(verdict, Verdict::Within);
            }
        }
    }

    #[test]
    fn the_order_of_curves_is_that_of_their_maps(
        a in prop::collection::vec([-4i64..=4, -4i64..=4], 2..=5), b in prop::collection::vec([-4i64..=4, -4i64..=4], 1..=4), backward in any::<bool>(),
    ) {
        let mut second = vec![a[a.len() - 1]];
        second.extend(b);
        let segment = |points: &[[i64; 2]], from: i64| {
            let frame = Interval::new(q(from), q(from + 1)).expect("different");
            Segment::from_points(points.iter().map(|point| point.map(q).to_vec()).collect(), frame).expect("points")
        };
        let (one, two) = (segment(&a, 0), segment(&second, 1));
        let slow = continuity_of_curves(&one.curve().expect("a curve"), &two.curve().expect("a curve"), &q(1)).expect("an order");
        let mut written = second.clone();
        if backward {
            written.reverse();
        }
        let audit = checked(vec![Piece::Curve(segment(&a, 0)), Piece::Curve(segment(&written, 0))], &Terms::default());
        if let Some(join) = only(&audit) {
            prop_assert_eq!(join.parametric, slow);
            prop_assert_eq!(join.first, (0, Side::End));
        }
    }

    #[test]
    fn rounding_explains_what_some_printed_points_are(
        u in [-40i64..=40, -40i64..=40], ratio in (1i64..=5, 1i64..=3), error in [-1i64..=1, -1i64..=1],
    ) {
        // Points on a grid of quarters that are smooth, printed with a unit of 1.
        let v = [0, 1].map(|axis| u[axis] * ratio.0);
        let round = |number: i64, denom: i64| (2 * number + denom).div_euclid(2 * denom);
        let handle_a = u.map(|c| round(c, 4));
        let handle_b = [0, 1].map(|axis| round(v[axis], 4 * ratio.1) + error[axis]);
        let text = format!("<svg><path d=\"M{} {} L 0 0 L {} {}\"/></svg>", -handle_a[0], -handle_a[1], handle_b[0], handle_b[1]);
        let Ok(model) = casteljau::model::read(&text, Format::Svg) else { return Ok(()) };
        let audit = audit(&model, &requiring(Requirement::G1), None).expect("an audit");
        if let Some(join) = only(&audit).filter(|join| !join.contact.is_degenerate()) {
            if error == [0, 0] {
                prop_assert_eq!(join.rounding, Rounding::Yes);
            }
            // Slow: some direction within both boxes, tried on a fine grid of the first box.
            let fine = 8;
            let found = (-fine..=fine).any(|i| (-fine..=fine).any(|j| {
                let direction = [handle_a[0] * 2 * fine + i, handle_a[1] * 2 * fine + j];
                // λ with |b - λ direction| <= 1/2 in both coordinates.
                let (mut low, mut high) = (Rational::new(1, 1_000_000), q(1_000_000));
                for axis in 0..2 {
                    let d = Rational::new(direction[axis], 2 * fine);
                    let (least, most) = (q(handle_b[axis]) - Rational::new(1, 2), q(handle_b[axis]) + Rational::new(1, 2));
                    if d == q(0) {
                        if least > q(0) || most < q(0) {
                            return false;
                        }
                    } else {
                        let (x, y) = (&least / &d, &most / &d);
                        low = low.max(x.clone().min(y.clone()));
                        high = high.min(x.max(y));
                    }
                }
                low <= high
            }));
            if found {
                prop_assert_eq!(join.rounding, Rounding::Yes, "{}", text);
            }
            prop_assert!(join.rounding != Rounding::Unknown);
        }
    }
}

/// Triangles over frames: their order against the maps', and a smooth pair planted.
#[test]
fn triangles_over_frames_join_as_their_maps_do() {
    let frame = |r: [i64; 2]| Triangle::new(r.map(q), [q(1), q(0)], [q(0), q(1)]).expect("a triangle");
    let surface =
        casteljau::Surface::total(vec![vec![(1, 0, q(1))], vec![(0, 1, q(1))], vec![(2, 1, q(1)), (0, 3, q(-2))]]).expect("terms");
    let first = surface.over_triangle(&frame([0, 0])).expect("a patch");
    let second = surface.over_triangle(&frame([2, 2])).expect("a patch");
    for (index, order) in [(0, Continuity::Same), (9, Continuity::C(2))] {
        let mut points: Vec<Vec<Rational>> = second.points().map(<[_]>::to_vec).collect();
        // The last point is the one at r, three steps off the edge.
        if index > 0 {
            points[index][2] += q(1);
        }
        let second = TriangularPatch::from_points(points, second.frame().clone()).expect("points");
        let pieces = vec![Piece::Triangle(first.clone()), Piece::Triangle(second)];
        let audit = audit(&model(pieces, true), &requiring(Requirement::C2), None).expect("an audit");
        assert_eq!(audit.joins.len(), 1);
        assert_eq!((audit.joins[0].parametric, audit.joins[0].verdict, audit.open), (order, Verdict::Exact, 4));
    }
}

#[test]
fn frames_find_a_joint_that_points_do_not() {
    let graph = |points: [i64; 2], from: i64| {
        let frame = Interval::new(q(from), q(from + 1)).expect("different");
        Piece::Curve(Segment::from_points(points.map(|y| vec![q(y)]).to_vec(), frame).expect("points"))
    };
    let audit = audit(&model(vec![graph([0, 1], 0), graph([2, 3], 1)], true), &requiring(Requirement::C0), None).expect("an audit");
    assert_eq!(
        audit.joins.iter().map(|join| (join.parametric, join.verdict)).collect::<Vec<_>>(),
        [(Continuity::Broken, Verdict::Violated)]
    );
}

#[test]
fn ends_are_matched_up_to_the_snap_only() {
    let line = |points: [[i64; 2]; 2]| {
        Piece::Curve(
            Segment::from_points(points.map(|point| point.map(|c| Rational::new(c, 100)).to_vec()).to_vec(), Interval::unit())
                .expect("points"),
        )
    };
    let pieces = || vec![line([[0, 0], [100, 0]]), line([[101, 0], [200, 0]])];
    let joins = |snap: Option<Rational>| audit(&model(pieces(), false), &requiring(Requirement::G1), snap.as_ref()).expect("an audit");
    assert_eq!(joins(None).open, 4);
    assert_eq!(joins(Some(Rational::new(9, 1000))).open, 4);
    let found = joins(Some(Rational::new(1, 100)));
    assert_eq!((found.open, found.joins.len()), (2, 1));
    assert_eq!((found.joins[0].parametric, found.joins[0].geometric, found.joins[0].verdict), (Continuity::Broken, None, Verdict::Within));
}

#[test]
fn promises_hold_unless_they_are_ignored() {
    let text = "<glyph><outline><contour><point x=\"0\" y=\"0\" type=\"move\"/><point x=\"9\" y=\"0\" type=\"line\" smooth=\"yes\"/>\
                <point x=\"18\" y=\"5\" type=\"line\"/></contour></outline></glyph>";
    let model = casteljau::model::read(text, Format::Glif).expect("a glyph");
    for (ignores_promises, requirement, verdict) in [(false, Some(Requirement::G1), Verdict::Violated), (true, None, Verdict::Reported)] {
        let audit = audit(&model, &Terms { ignores_promises, ..Terms::default() }, None).expect("an audit");
        let found: Vec<_> = audit.joins.iter().map(|join| (join.requirement, join.verdict)).collect();
        assert_eq!(found, [(requirement, verdict)]);
    }
}

#[test]
fn contacts_of_curves_are_told_apart() {
    let join = |handle: [i64; 2]| {
        let text = format!("<svg><path d=\"M0 0 C 10 0 20 0 30 0 C {} {} 50 10 60 10\"/></svg>", 30 + handle[0], handle[1]);
        let model = casteljau::model::read(&text, Format::Svg).expect("a path");
        audit(&model, &requiring(Requirement::G1), None).expect("an audit").joins[0].clone()
    };
    for (handle, contact, verdict, obtuse) in [
        ([20, 0], Contact::Smooth, Verdict::Exact, false),
        ([20, 1], Contact::Kink, Verdict::Violated, false),
        ([-20, 1], Contact::Kink, Verdict::Violated, true),
        ([-20, 0], Contact::Fold, Verdict::Violated, true),
        ([0, 0], Contact::ZeroHandle, Verdict::Degenerate, false),
    ] {
        let found = join(handle);
        assert_eq!((found.contact, found.verdict, found.obtuse), (contact, verdict, obtuse), "{handle:?}");
    }
    // tan = 1/20: sin² = 1/401, and the nearer point has to move by 10/√401.
    assert_eq!(join([20, 1]).sin2, Some([Rational::new(1, 401), Rational::new(1, 401)]));
    assert_eq!(join([20, 1]).offset2, Some(Rational::new(100, 401)));
}

#[test]
fn the_generators_reach_every_order_and_contact() {
    use proptest::strategy::ValueTree;
    use proptest::test_runner::TestRunner;
    let mut runner = TestRunner::deterministic();
    let (mut orders, mut contacts) = (std::collections::BTreeMap::new(), std::collections::HashMap::new());
    for _ in 0..600 {
        let (first, second, _) = neighbours().new_tree(&mut runner).expect("a pair").current();
        for join in checked(vec![rectangle(&first), rectangle(&second)], &Terms::default()).joins {
            *orders.entry(format!("{:?}", join.parametric)).or_insert(0) += 1;
            *contacts.entry(format!("{:?}", join.contact)).or_insert(0) += 1;
        }
    }
    for order in ["C(0)", "C(1)", "C(2)", "Same"] {
        assert!(orders.get(order).is_some_and(|count| *count > 5), "{order}: {orders:?}");
    }
    for contact in ["Smooth", "Kink"] {
        assert!(contacts.get(contact).is_some_and(|count| *count > 50), "{contact}: {contacts:?}");
    }
}
