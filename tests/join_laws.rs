//! Orders of continuity by construction: maps that differ by a known power of
//! the joint, curves in changed parameters, splines with known knots.

use casteljau::{
    Continuity, Curve, Error, Extension, Interval, JoinCondition, Joint, Meeting, Piece, Rational, Reading, Rectangle, RectangularPatch,
    Segment, Side, Spline, Surface, Term, Triangle, TriangularPatch, affine_groups, continuity_of_curves, continuity_of_rational_curves,
    continuity_of_rational_surfaces, continuity_of_surfaces, extend, geometric_join, join_conditions, tangent_plane_join,
};
use proptest::prelude::*;

fn small() -> impl Strategy<Value = Rational> {
    (-6i64..7, 1i64..5).prop_map(|(n, d)| Rational::new(n, d))
}

fn nonzero() -> impl Strategy<Value = Rational> {
    small().prop_filter("not zero", |x| *x != Rational::from(0))
}

fn curve(dimension: usize, degree: usize) -> impl Strategy<Value = Curve> {
    prop::collection::vec(prop::collection::vec(small(), degree + 1), dimension).prop_filter_map("a curve", |lists| Curve::new(lists).ok())
}

/// The product of two polynomials, by their coefficients in ascending powers.
fn times(a: &[Rational], b: &[Rational]) -> Vec<Rational> {
    let mut product = vec![Rational::from(0); a.len() + b.len() - 1];
    for (i, x) in a.iter().enumerate() {
        for (j, y) in b.iter().enumerate() {
            product[i + j] += x * y;
        }
    }
    product
}

fn power(base: &[Rational], exponent: usize) -> Vec<Rational> {
    (0..exponent).fold(vec![Rational::from(1)], |product, _| times(&product, base))
}

fn sum(a: &[Rational], b: &[Rational]) -> Vec<Rational> {
    let zero = Rational::from(0);
    (0..a.len().max(b.len())).map(|k| a.get(k).unwrap_or(&zero) + b.get(k).unwrap_or(&zero)).collect()
}

fn coordinates(curve: &Curve) -> Vec<Vec<Rational>> {
    (0..curve.dimension()).map(|index| curve.coordinate(index).cloned().collect()).collect()
}

/// A polynomial after another one is put in for its variable.
fn composed(outer: &[Rational], inner: &[Rational]) -> Vec<Rational> {
    outer.iter().rev().fold(vec![Rational::from(0)], |value, c| sum(&times(&value, inner), std::slice::from_ref(c)))
}

/// `(α u + β v + γ)^exponent` as terms.
fn linear_power([a, b, c]: &[Rational; 3], exponent: usize) -> Vec<Term> {
    let mut terms: Vec<Term> = vec![(0, 0, Rational::from(1))];
    for _ in 0..exponent {
        terms = terms.iter().flat_map(|(h, k, x)| [(h + 1, *k, x * a), (*h, k + 1, x * b), (*h, *k, x * c)]).collect();
    }
    terms
}

fn expected(order: usize) -> Continuity {
    if order == 0 { Continuity::Broken } else { Continuity::C(order - 1) }
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 96, ..ProptestConfig::default() })]

    #[test]
    fn curves_that_differ_by_a_power_of_the_joint((a, factor) in (curve(2, 3), nonzero()), at in small(), order in 0usize..5) {
        let difference = times(&power(&[-at.clone(), Rational::from(1)], order), &[factor]);
        let mut lists = coordinates(&a);
        lists[1] = sum(&lists[1], &difference);
        let b = Curve::new(lists).expect("a curve");
        prop_assert_eq!(continuity_of_curves(&a, &b, &at).expect("one dimension"), expected(order));
        prop_assert_eq!(continuity_of_curves(&a, &a.clone().with_degree(6).expect("higher"), &at).expect("one dimension"), Continuity::Same);
    }

    #[test]
    fn surfaces_that_differ_by_a_power_of_the_joint(terms in prop::collection::vec((0usize..3, 0usize..3, small()), 0..6), from in [small(), small()], to in [small(), small()], factor in nonzero(), order in 0usize..4) {
        prop_assume!(from != to);
        let joint = [from.clone(), to.clone()];
        // The linear form that vanishes on the joint.
        let (a, b) = (&to[1] - &from[1], &from[0] - &to[0]);
        let c = -(&a * &from[0] + &b * &from[1]);
        let mut changed = terms.clone();
        changed.extend(linear_power(&[a, b, c], order).into_iter().map(|(h, k, x)| (h, k, x * &factor)));
        let (first, second) = (Surface::tensor(vec![terms.clone()]).expect("a surface"), Surface::total(vec![changed]).expect("a surface"));
        prop_assert_eq!(continuity_of_surfaces(&first, &second, &joint).expect("one dimension"), expected(order));
        let raised = first.read_as(Reading::Total(6)).expect("higher");
        prop_assert_eq!(continuity_of_surfaces(&first, &raised, &joint).expect("one dimension"), Continuity::Same);
    }

    /// The conditions of a textbook say the same as divisibility.
    #[test]
    fn conditions_hold_up_to_the_order(a in curve(2, 3), factor in nonzero(), order in 0usize..5, terms in prop::collection::vec((0usize..3, 0usize..3, small()), 0..6)) {
        let one = || Rational::from(1);
        // On the line, at 1; in the plane, along u = 1.
        let mut lists = coordinates(&a);
        lists[0] = sum(&lists[0], &times(&power(&[-one(), one()], order), std::slice::from_ref(&factor)));
        let b = Curve::new(lists).expect("a curve");
        let unit = |from: i64, to: i64| Interval::new(Rational::from(from), Rational::from(to)).expect("a frame");
        let (first, second) = (Piece::Curve(a.segment(&unit(0, 1)).expect("a segment")), Piece::Curve(b.segment(&unit(1, 3)).expect("a segment")));
        let mut changed = terms.clone();
        changed.extend(linear_power(&[one(), Rational::from(0), -one()], order).into_iter().map(|(h, k, x)| (h, k, x * &factor)));
        let (a, b) = (Surface::tensor(vec![terms]).expect("a surface"), Surface::tensor(vec![changed]).expect("a surface"));
        let at = |u: i64, v: i64| [Rational::from(u), Rational::from(v)];
        let triangle = |surface: &Surface, r, s, t| Piece::Triangle(surface.over_triangle(&Triangle::new(r, s, t).expect("a frame")).expect("a patch"));
        let rectangle = |surface: &Surface, u, v| Piece::Rectangle(surface.over_rectangle(&Rectangle::new(u, v)).expect("a patch"));
        let pairs = [
            (first, second),
            (triangle(&a, at(0, 0), at(1, 0), at(1, 1)), triangle(&b, at(1, 1), at(3, 2), at(1, 0))),
            (rectangle(&a, unit(0, 1), unit(0, 1)), rectangle(&b, unit(1, 2), unit(1, 0))),
            (rectangle(&a, unit(0, 1), unit(0, 1)), triangle(&b, at(1, 1), at(3, 2), at(1, 0))),
        ];
        for (first, second) in pairs {
            let joint = Joint::between(&first, &second).expect("they share one end or side");
            let conditions = join_conditions(&first, &second, &joint, order).expect("they fit");
            prop_assert!(conditions.iter().filter(|condition| condition.order < order).all(JoinCondition::holds));
            prop_assert!(conditions.iter().any(|condition| condition.order == order && !condition.holds()) || conditions.iter().all(|condition| condition.order < order));
        }
    }

    /// Continuity of order 1 is what makes every group of four points an affine image of the frames.
    #[test]
    fn groups_are_affine_images(terms in prop::collection::vec((0usize..3, 0usize..2, small()), 0..6), vertices in prop::array::uniform4([small(), small()]), factor in nonzero(), order in 0usize..4, raised in 0usize..2) {
        let [p, s, t, q] = vertices;
        let (Ok(own), Ok(other)) = (Triangle::new(s.clone(), p, t.clone()), Triangle::new(q.clone(), s.clone(), t.clone())) else { return Ok(()) };
        let (a, b) = (&t[1] - &s[1], &s[0] - &t[0]);
        let c = -(&a * &s[0] + &b * &s[1]);
        let mut changed = terms.clone();
        changed.extend(linear_power(&[a, b, c], order).into_iter().map(|(h, k, x)| (h, k, x * &factor)));
        let over = |terms: &[Term], frame: Triangle| Surface::new(Reading::Total(3), vec![terms.to_vec()]).and_then(|surface| surface.over_triangle(&frame)).expect("a patch");
        let (first, second) = (Piece::Triangle(over(&terms, own.clone()).elevate(raised).expect("small")), Piece::Triangle(over(&changed, other)));
        let (weights, groups) = affine_groups(&first, &second, &Joint::Edge([s.clone(), t.clone()])).expect("two triangles");
        prop_assert_eq!(groups.len(), 3 + raised);
        prop_assert_eq!(weights.iter().sum::<Rational>(), Rational::from(1));
        // In the order p, s, t: the first vertex of the frame is s here.
        prop_assert_eq!(own.at(&[weights[1].clone(), weights[0].clone(), weights[2].clone()]), q);
        let holds = groups.iter().all(|group| group.holds);
        prop_assert_eq!(holds, order >= 2, "{:?}", groups);
    }

    /// Pieces that are moved in their parameters are found by their position in space.
    #[test]
    fn common_edges_are_found_by_position(points in prop::collection::vec([small(), small(), small()], 9), more in prop::collection::vec([small(), small(), small()], 6), side in 0usize..4, reversed: bool, weights in prop::collection::vec(1i64..4, 9), rational: bool) {
        let lifted = |point: &[Rational; 3], weight: i64| -> Vec<Rational> {
            let weight = Rational::from(weight);
            if rational { point.iter().map(|x| x * &weight).chain([weight.clone()]).collect() } else { point.to_vec() }
        };
        let all: Vec<Vec<Rational>> = points.iter().zip(&weights).map(|(point, weight)| lifted(point, *weight)).collect();
        let frame = Rectangle::unit();
        let first = Piece::Rectangle(RectangularPatch::from_points((2, 2), all.clone(), frame.clone()).expect("a patch"));
        let mut edge: Vec<Vec<Rational>> = match side {
            0 => all[..3].to_vec(),
            1 => all[6..].to_vec(),
            2 => all.iter().step_by(3).cloned().collect(),
            _ => all.iter().skip(2).step_by(3).cloned().collect(),
        };
        if reversed {
            edge.reverse();
        }
        // Twice the homogeneous points are the same points.
        let factor = Rational::from(if rational { 2 } else { 1 });
        let other = edge.iter().map(|point| point.iter().map(|x| x * &factor).collect()).chain(more.iter().map(|point| lifted(point, 1)));
        let second = Piece::Rectangle(RectangularPatch::from_points((2, 2), other.collect(), frame).expect("a patch"));
        let found = Meeting::by_position(&first, &second, rational).expect("one dimension");
        prop_assert!(found.contains(&Meeting::Sides([Side::U0, Side::U1, Side::V0, Side::V1][side], Side::U0)), "{:?}", found);
    }

    /// A neighbour that takes the forced points over joins as smoothly as promised, whatever the free ones are.
    #[test]
    fn forced_points_are_enough(a in curve(2, 3), order in 0usize..3, terms in prop::collection::vec((0usize..3, 0usize..3, small()), 0..6), noise in prop::collection::vec(small(), 30)) {
        let unit = |from: i64, to: i64| Interval::new(Rational::from(from), Rational::from(to)).expect("a frame");
        let changed = |extension: &Extension| -> Vec<Vec<Rational>> {
            let points = extension.continuation.points().zip(&extension.forced);
            points.enumerate().map(|(k, (point, forced))| if *forced { point.to_vec() } else { point.iter().map(|x| x + &noise[k]).collect() }).collect()
        };
        let piece = Piece::Curve(a.segment(&unit(0, 1)).expect("a segment"));
        let found = extend(&piece, &unit(1, 4).into(), &Joint::Parameter(Rational::from(1)), order).expect("it fits");
        let neighbour = Segment::from_points(changed(&found), unit(1, 4)).expect("a segment");
        prop_assert!(continuity_of_curves(&a, &neighbour.curve().expect("numbers"), &Rational::from(1)).expect("one dimension") >= Continuity::C(order));
        prop_assert_eq!(found.forced.iter().filter(|forced| **forced).count(), order + 1);

        let at = |u: i64, v: i64| [Rational::from(u), Rational::from(v)];
        let surface = Surface::new(Reading::Total(4), vec![terms]).expect("a surface");
        let frame = Triangle::new(at(0, 0), at(1, 0), at(1, 1)).expect("a frame");
        let piece = Piece::Triangle(surface.over_triangle(&frame).expect("a patch"));
        let edge = [at(1, 0), at(1, 1)];
        let beyond = Triangle::new(at(1, 1), at(3, 2), at(1, 0)).expect("a frame");
        let found = extend(&piece, &beyond.clone().into(), &Joint::Edge(edge.clone()), order).expect("it fits");
        let neighbour = TriangularPatch::from_points(changed(&found), beyond).expect("a patch");
        prop_assert!(continuity_of_surfaces(&surface, &neighbour.surface().expect("numbers"), &edge).expect("one dimension") >= Continuity::C(order));
        // (k+1)(2m-k+2)/2 conditions, as many as points.
        prop_assert_eq!(found.forced.iter().filter(|forced| **forced).count(), (order + 1) * (2 * 4 - order + 2) / 2);

        let tensor = surface.by_bidegree().expect("small");
        let piece = Piece::Rectangle(tensor.over_rectangle(&Rectangle::new(unit(0, 1), unit(0, 1))).expect("a patch"));
        let beyond = Rectangle::new(unit(1, 3), unit(0, 1));
        let found = extend(&piece, &beyond.clone().into(), &Joint::Edge(edge.clone()), order).expect("it fits");
        let neighbour = RectangularPatch::from_points((4, 4), changed(&found), beyond).expect("a patch");
        prop_assert!(continuity_of_surfaces(&tensor, &neighbour.surface().expect("numbers"), &edge).expect("one dimension") >= Continuity::C(order));
    }

    /// A common factor of all homogeneous coordinates is not seen in Cartesian ones.
    #[test]
    fn rational_joins_do_not_see_common_factors(a in curve(3, 2), at in small(), scale in nonzero(), slope in nonzero(), order in 0usize..3) {
        prop_assume!(a.value(&at)[2] != Rational::from(0));
        // scale + slope (t - at)^{order+1}: continuous up to `order` after scaling, everywhere the same in the plane.
        let factor = sum(&times(&power(&[-at.clone(), Rational::from(1)], order + 1), &[slope]), std::slice::from_ref(&scale));
        let b = Curve::new(coordinates(&a).iter().map(|list| times(list, &factor)).collect()).expect("a curve");
        let join = continuity_of_rational_curves(&a, &b, &at).expect("no weight is zero");
        prop_assert_eq!(join.cartesian, Continuity::Same);
        prop_assert_eq!(join.scale * &scale, Rational::from(1));
        prop_assert_eq!(join.scaled, Continuity::C(order));
        prop_assert_eq!(join.homogeneous, if scale == Rational::from(1) { Continuity::C(order) } else { Continuity::Broken });
    }

    #[test]
    fn rational_surfaces_of_one_weight_join_like_polynomial_ones(terms in prop::collection::vec((0usize..3, 0usize..3, small()), 1..6), weight in nonzero(), order in 0usize..3) {
        let joint = [[Rational::from(0), Rational::from(0)], [Rational::from(0), Rational::from(1)]];
        let mut changed = terms.clone();
        changed.push((order, 0, Rational::from(1)));
        let constant = vec![(0, 0, weight.clone())];
        let scaled = |terms: &[Term]| terms.iter().map(|(h, k, c)| (*h, *k, c * &weight)).collect::<Vec<_>>();
        let a = Surface::total(vec![terms.clone(), vec![(0, 0, Rational::from(1))]]).expect("a surface");
        let b = Surface::total(vec![scaled(&changed), constant]).expect("a surface");
        prop_assert_eq!(continuity_of_rational_surfaces(&a, &b, &joint).expect("no weight is zero").cartesian, expected(order));
    }

    /// A curve in a changed parameter joins itself with the derivatives of the change as shape parameters.
    #[test]
    fn changed_parameters_are_found(f in curve(3, 3), at in small(), b1 in 1i64..5, b2 in small(), b3 in small()) {
        prop_assume!(f.derivative(1).value(&at).iter().any(|x| *x != Rational::from(0)));
        let change = [at.clone(), Rational::from(b1), &b2 / Rational::from(2), &b3 / Rational::from(6)];
        let g = Curve::new(coordinates(&f).iter().map(|list| composed(list, &change)).collect()).expect("a curve");
        let join = geometric_join(&f, &g, &at, &Rational::from(0)).expect("one dimension");
        prop_assert_eq!((join.order, join.betas), (Some(3), vec![Rational::from(b1), b2, b3]));
        let turned = [at.clone(), Rational::from(-b1)];
        let g = Curve::new(coordinates(&f).iter().map(|list| composed(list, &turned)).collect()).expect("a curve");
        let join = geometric_join(&f, &g, &at, &Rational::from(0)).expect("one dimension");
        prop_assert!(join.reversed && join.order == Some(0));
    }

    /// One surface over two triangles on either side of an edge has common tangent planes.
    #[test]
    fn a_surface_joins_itself(terms in prop::collection::vec((0usize..3, 0usize..3, small()), 0..5)) {
        let one = || Rational::from(1);
        let surface = Surface::total(vec![vec![(1, 0, one())], vec![(0, 1, one())], terms]).expect("a surface");
        let at = |u: i64, v: i64| [Rational::from(u), Rational::from(v)];
        let side = |inner| Piece::Triangle(surface.over_triangle(&Triangle::new(inner, at(0, 0), at(1, 0)).expect("a frame")).expect("a patch"));
        let tangents = |first: &Piece, second: &Piece| tangent_plane_join((first, Side::St), (second, Side::St), false).expect("in space");
        let join = tangents(&side(at(0, 1)), &side(at(1, -2)));
        prop_assert!(join.is_g1());
        let folded = tangents(&side(at(0, 1)), &side(at(2, 3)));
        prop_assert!(folded.coplanar == Some(true) && folded.opposite_sides == Some(false));
    }

    #[test]
    fn splines_are_as_smooth_as_their_knots_promise(degree in 1usize..5, gaps in prop::collection::vec(0i64..3, 12), seed in prop::collection::vec([small(), small()], 16), part in 0i64..9) {
        let mut knots = vec![Rational::from(0)];
        for gap in gaps {
            knots.push(&knots[knots.len() - 1] + Rational::new(gap, 2));
        }
        let count = knots.len() - degree - 1;
        let points: Vec<Vec<Rational>> = seed[..count].iter().map(|point| point.to_vec()).collect();
        let Ok(spline) = Spline::new(degree, knots, points) else { return Ok(()) };
        for join in spline.joins().expect("a spline") {
            if let Continuity::C(order) = join.order {
                prop_assert!(order + join.multiplicity >= degree);
            }
            prop_assert!(join.order != Continuity::Broken || join.multiplicity > degree);
        }
        // A knot more changes nothing of the curve.
        let pieces = spline.pieces().expect("a spline");
        let frame = pieces[pieces.len() / 2].frame();
        let knot = frame.at(&Rational::new(part, 8));
        if let Ok(finer) = spline.insert(&knot) {
            for piece in finer.pieces().expect("a spline") {
                let middle = piece.frame().at(&Rational::new(1, 2));
                let whole = pieces.iter().find(|whole| whole.frame().contains(&middle)).expect("it lies in one");
                prop_assert!(piece.same_map(whole).expect("numbers"));
            }
        }
    }
}

#[test]
fn the_work_of_a_spline_is_bounded_by_its_pieces_not_by_its_number_of_points() {
    let spline = |degree: usize, points: usize, step: i64| {
        let knots = (0..=points + degree).map(|i| Rational::from(i as i64 * step)).collect();
        Spline::new(degree, knots, vec![vec![Rational::from(1)]; points])
    };
    assert_eq!(spline(3, 2000, 1 << 20).and_then(|spline| spline.pieces()).map(|pieces| pieces.len()), Ok(1997));
    assert!(matches!(spline(100, 140, 1 << 20), Err(Error::TooLarge { .. })));
}
