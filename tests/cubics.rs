//! The laws of planar cubics, on generated input compared with `==`.
//!
//! Strategy: the answer is planted. A cubic is made from the standard one of a
//! class by a random affine map of the plane and a random affine change of the
//! parameter, so that every class comes up as often as any other; coefficients
//! that are random outright are nearly all humpy or loopy. The last test counts
//! what the generators make.

use casteljau::{
    AffineMap, AlgebraicNumber, Cubic, CubicClass, Curve, Family, ImplicitCurve, Interval, Parameters, Polynomial, QuadricClass,
    QuadricSurface, Rational, RealRoots, Segment, Special, Surd, Surface, Symbol, classify_rationals,
};
use num_traits::{Signed, Zero};
use proptest::prelude::*;
use proptest::strategy::ValueTree;
use proptest::test_runner::TestRunner;

type Vector = [Rational; 2];

fn q(n: i64) -> Rational {
    Rational::from(n)
}

fn number() -> BoxedStrategy<Rational> {
    prop_oneof![
        2 => Just(q(0)),
        8 => (-9i64..10).prop_map(q),
        6 => (-60i64..60, 1i64..13).prop_map(|(n, d)| Rational::new(n, d)),
        1 => (any::<i32>(), 1i64..1_000_007).prop_map(|(n, d)| Rational::new(i64::from(n), d)),
        1 => (-3i64..4, 1u32..30).prop_map(|(n, power)| q(n) + Rational::new(1, 7).pow(power)),
    ]
    .boxed()
}

fn nonzero() -> impl Strategy<Value = Rational> {
    number().prop_filter("not zero", |x| !x.is_zero())
}

fn vector() -> impl Strategy<Value = Vector> {
    [number(), number()]
}

fn det(a: &Vector, b: &Vector) -> Rational {
    &a[0] * &b[1] - &a[1] * &b[0]
}

fn map() -> BoxedStrategy<AffineMap> {
    (vector(), vector(), vector())
        .prop_filter_map("not singular", |(a, b, shift)| {
            (!det(&a, &b).is_zero()).then(|| AffineMap::new(vec![a.to_vec(), b.to_vec()], shift.to_vec()).expect("a map"))
        })
        .boxed()
}

/// `F(a t + b)`, slowly: by adding up powers of the polynomial `a t + b`.
fn reparametrized(cubic: &Cubic, a: &Rational, b: &Rational) -> Cubic {
    let mut vectors: [Vector; 4] = Default::default();
    let mut power = [q(1), q(0), q(0), q(0)];
    for vector in cubic.vectors() {
        for (target, weight) in vectors.iter_mut().zip(&power) {
            for (sum, c) in target.iter_mut().zip(vector) {
                *sum += c * weight;
            }
        }
        power = [0, 1, 2, 3].map(|k| &power[k] * b + if k > 0 { &power[k - 1] * a } else { q(0) });
    }
    Cubic::from_vectors(vectors)
}

fn mapped(cubic: &Cubic, map: &AffineMap) -> Cubic {
    Cubic::new(&cubic.curve().transform(map).expect("the plane")).expect("a cubic")
}

/// Standard cubics: the five of the lecture and the kinds of straight ones.
fn standard() -> impl Strategy<Value = (CubicClass, Cubic)> {
    let straight = |coefficients: [i64; 4]| Cubic::from_vectors(coefficients.map(|c| [q(c), q(0)]));
    prop_oneof![
        5 => (0usize..5).prop_map(|index| {
            let class = CubicClass::ALL[index];
            (class, class.standard_cubic().expect("not straight"))
        }),
        1 => prop::sample::select(vec![[0, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1], [0, 1, 0, 1], [0, -1, 0, 1]])
            .prop_map(move |list| (CubicClass::Straight, straight(list))),
    ]
}

/// Boxed, like the other large ones: tests run on small stacks.
fn planted() -> BoxedStrategy<(CubicClass, Cubic)> {
    (standard(), map(), nonzero(), number())
        .prop_map(|((class, cubic), map, a, b)| (class, mapped(&reparametrized(&cubic, &a, &b), &map)))
        .boxed()
}

fn any_cubic() -> BoxedStrategy<Cubic> {
    prop_oneof![
        3 => planted().prop_map(|(_, cubic)| cubic),
        1 => [vector(), vector(), vector(), vector()].prop_map(Cubic::from_vectors),
        1 => prop::array::uniform8(-2i64..3).prop_map(|c| Cubic::from_vectors([0, 2, 4, 6].map(|k| [q(c[k]), q(c[k + 1])]))),
    ]
    .boxed()
}

fn frame() -> impl Strategy<Value = Interval> {
    (number(), number()).prop_filter_map("different ends", |(r, s)| Interval::new(r, s).ok())
}

/// The value of a polynomial at `a ± √d`.
fn at(coefficients: &[Rational], t: &Surd) -> Surd {
    t.evaluate(coefficients.iter())
}

/// The coefficients of a coordinate of a derivative.
fn derivative(cubic: &Cubic, order: usize, index: usize) -> Vec<Rational> {
    cubic.curve().derivative(order).coordinate(index).cloned().collect()
}

/// `F' × F''` at a parameter, from the derivatives themselves.
fn turning(cubic: &Cubic, t: &Surd) -> Surd {
    let [x1, y1, x2, y2] = [(1, 0), (1, 1), (2, 0), (2, 1)].map(|(order, index)| at(&derivative(cubic, order, index), t));
    x1.times(&y2).and_then(|a| a.minus(&y1.times(&x2)?)).expect("one field")
}

fn midpoint(a: &Vector, b: &Vector) -> Vector {
    [0, 1].map(|k| (&a[k] + &b[k]) * Rational::new(1, 2))
}

/// The slow twin of the class: from the roots of `F' × F''` and of `F'`.
fn class_by_flexes(cubic: &Cubic) -> CubicClass {
    let product = |a: &[Rational], b: &[Rational]| {
        let mut product = vec![q(0); a.len() + b.len()];
        for (i, x) in a.iter().enumerate() {
            for (j, y) in b.iter().enumerate() {
                product[i + j] += x * y;
            }
        }
        product
    };
    let [x1, y1, x2, y2] = [(1, 0), (1, 1), (2, 0), (2, 1)].map(|(order, index)| derivative(cubic, order, index));
    let turning: Vec<Rational> = product(&x1, &y2).iter().zip(product(&y1, &x2)).map(|(a, b)| a - b).collect();
    if turning.iter().all(Zero::is_zero) {
        return CubicClass::Straight;
    }
    let everywhere = Interval::new(-q(10).pow(80), q(10).pow(80)).expect("a frame");
    let roots = RealRoots::inside(&turning, &everywhere).expect("not zero");
    match (turning.iter().rposition(|c| !c.is_zero()), roots.distinct(), roots.with_multiplicity()) {
        (Some(0), ..) => CubicClass::Parabolic,
        (Some(1), ..) => CubicClass::SShaped,
        (_, 2, _) => CubicClass::Humpy,
        (_, 1, 2) => CubicClass::Pointy,
        (_, 0, _) => CubicClass::Loopy,
        other => panic!("{other:?} flexes of {cubic:?}"),
    }
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 160, ..ProptestConfig::default() })]

    #[test]
    fn the_class_is_the_planted_one((class, cubic) in planted()) {
        prop_assert_eq!(cubic.class(), class);
        prop_assert_eq!(cubic.special_points().class(), class);
    }

    #[test]
    fn the_class_is_that_of_the_flexes(cubic in any_cubic()) {
        prop_assert_eq!(cubic.class(), class_by_flexes(&cubic));
    }

    #[test]
    fn invariants_under_maps_and_parameters(cubic in any_cubic(), rows in (vector(), vector()), shift in vector(), a in number(), b in number()) {
        let k = cubic.invariants();
        let image = mapped(&cubic, &AffineMap::new(vec![rows.0.to_vec(), rows.1.to_vec()], shift.to_vec()).expect("a map")).invariants();
        let determinant = det(&rows.0, &rows.1);
        prop_assert_eq!([image.kappa12, image.kappa23, image.kappa31], [&k.kappa12, &k.kappa23, &k.kappa31].map(|x| x * &determinant));
        let new = reparametrized(&cubic, &a, &b).invariants();
        prop_assert_eq!(&new.kappa23, &(a.pow(5) * &k.kappa23));
        prop_assert_eq!(&new.kappa31, &(a.pow(4) * (&k.kappa31 - q(2) * &b * &k.kappa23)));
        prop_assert_eq!(&new.kappa12, &(a.pow(3) * (&k.kappa12 - q(3) * &b * &k.kappa31 + q(3) * &b * &b * &k.kappa23)));
        prop_assert_eq!(new.discriminant(), a.pow(8) * k.discriminant());
        // κ23 F1 + κ31 F2 + κ12 F3 = 0
        let [_, f1, f2, f3] = cubic.vectors();
        for index in 0..2 {
            prop_assert_eq!(&k.kappa23 * &f1[index] + &k.kappa31 * &f2[index] + &k.kappa12 * &f3[index], q(0));
        }
    }

    #[test]
    fn invariants_from_the_polygon(cubic in any_cubic(), frame in frame(), t in number()) {
        let segment = cubic.curve().segment(&frame).expect("a segment");
        let point = |i: usize| -> Vector { [segment.point(i)[0].clone(), segment.point(i)[1].clone()] };
        let edge = |i: usize| -> Vector { [0, 1].map(|k| &point(i + 1)[k] - &point(i)[k]) };
        let (a, b, c) = (det(&edge(0), &edge(1)), det(&edge(0), &edge(2)), det(&edge(1), &edge(2)));
        let local = reparametrized(&cubic, &(frame.s() - frame.r()), frame.r());
        let k = local.invariants();
        prop_assert_eq!(&k.kappa12, &(q(9) * &a));
        prop_assert_eq!(&k.kappa31, &(q(3) * (q(2) * &a - &b)));
        prop_assert_eq!(&k.kappa23, &(q(3) * (&a - &b + &c)));
        prop_assert_eq!(k.discriminant(), q(27) * (&b * &b - q(4) * &a * &c));
        let bernstein = q(18) * (&a * (q(1) - &t) * (q(1) - &t) + &b * &t * (q(1) - &t) + &c * &t * &t);
        prop_assert_eq!(turning(&local, &Surd::from(&t)), Surd::from(&bernstein));
        prop_assert_eq!(at(&local.flex_polynomial(), &Surd::from(&t)), Surd::from(bernstein * Rational::new(1, 2)));
        // The fast way from an array of control points, over any frame.
        let polygon: [Rational; 8] = std::array::from_fn(|k| segment.coordinates()[k].clone());
        prop_assert_eq!(classify_rationals(&[polygon]), [cubic.class()]);
    }

    #[test]
    fn special_points_are_what_they_are_called(cubic in any_cubic(), tau in nonzero()) {
        let special = cubic.special_points();
        for flex in special.flexes() {
            prop_assert_eq!(turning(&cubic, &flex.t), Surd::default());
            prop_assert_eq!(&cubic.point(&flex.t), &flex.point);
        }
        if let Some(summit) = special.summit() {
            // The tangent is parallel to F3, and the median halves the chords that are.
            let t = summit.t.as_rational().expect("a rational summit");
            let f3 = &cubic.vectors()[3];
            let tangent: Vector = [0, 1].map(|index| at(&derivative(&cubic, 1, index), &summit.t).rational().clone());
            prop_assert_eq!(det(&tangent, f3), q(0));
            let (low, high) = (cubic.rational_point(&(t - &tau)), cubic.rational_point(&(t + &tau)));
            let chord = [0, 1].map(|k| &high[k] - &low[k]);
            prop_assert_eq!(det(&chord, f3), q(0));
            let median = special.median().expect("with the summit");
            let middle = midpoint(&low, &high);
            let offset = [0, 1].map(|k| &middle[k] - &median.point[k]);
            prop_assert_eq!(det(&offset, &median.direction), q(0));
        }
        match &special {
            Special::Humpy { acnode, flexes, .. } => {
                prop_assert!(flexes[0].t < flexes[1].t);
                let implicit = ImplicitCurve::of(&cubic.curve()).expect("a curve");
                prop_assert_eq!(implicit.gauge(acnode), q(0));
                prop_assert_eq!(cubic.curve().parameters_of(acnode).expect("the plane"), Parameters::These(vec![]));
            }
            Special::Loopy { parameters, crunode, .. } => {
                prop_assert!(parameters[0] < parameters[1]);
                let point = crunode.each_ref().map(Surd::from);
                prop_assert_eq!([&cubic.point(&parameters[0]), &cubic.point(&parameters[1])], [&point, &point]);
                let found = parameters.clone().map(AlgebraicNumber::Surd).to_vec();
                prop_assert_eq!(cubic.curve().parameters_of(crunode).expect("the plane"), Parameters::These(found));
                let tangents = cubic.crunode_tangents().expect("a crunode");
                for (tangent, t) in tangents.iter().zip(parameters) {
                    let [x, y] = [0, 1].map(|index| at(&derivative(&cubic, 1, index), t));
                    prop_assert_eq!(x.times(&tangent[1]), y.times(&tangent[0]));
                }
            }
            Special::Pointy { cusp, .. } => {
                for index in 0..2 {
                    prop_assert_eq!(at(&derivative(&cubic, 1, index), &cusp.t), Surd::default());
                }
            }
            Special::SShaped { flex } => {
                let t = flex.t.as_rational().expect("a rational flex");
                let middle = midpoint(&cubic.rational_point(&(t - &tau)), &cubic.rational_point(&(t + &tau)));
                prop_assert_eq!(middle.map(Surd::from), flex.point.clone());
            }
            Special::Parabolic { vertex } => {
                let entry = |order, index| at(&derivative(&cubic, order, index), &vertex.t);
                let dot = entry(1, 0).times(&entry(2, 0)).and_then(|a| a.plus(&entry(1, 1).times(&entry(2, 1))?));
                prop_assert_eq!(dot, Some(Surd::default()));
            }
            Special::Straight(straight) => {
                let point = straight.point(&straight.profile_at(&Surd::from(&tau)));
                prop_assert_eq!(point, cubic.point(&Surd::from(&tau)));
                for turn in &straight.turns {
                    for index in 0..2 {
                        prop_assert_eq!(at(&derivative(&cubic, 1, index), turn), Surd::default());
                    }
                }
                let turns = match straight.degree { 2 => 1, 3 if straight.turns.is_empty() => 0, 3 => 2, _ => 0 };
                prop_assert_eq!(straight.turns.len(), turns);
            }
        }
    }

    #[test]
    fn normal_forms_carry_the_standard_cubic((class, cubic) in planted(), r in number(), t in number()) {
        let Some(normal) = cubic.normal_form() else {
            prop_assert_eq!(class, CubicClass::Straight);
            prop_assert!(cubic.semi_normal_form().is_none() && cubic.graph().is_none());
            return Ok(());
        };
        prop_assert_eq!(normal.form, class);
        let standard = class.standard_cubic().expect("not straight").rational_point(&r);
        let point = cubic.point(&normal.t0.plus(&normal.scale.times_rational(&r)).expect("one field"));
        for (index, coordinate) in point.iter().enumerate() {
            let [a, b] = [0, 1].map(|k| normal.matrix[index][k].times_rational(&standard[k]));
            prop_assert_eq!(Some(coordinate.clone()), a.plus(&b).and_then(|sum| sum.plus(&normal.shift[index])));
        }
        // The rational form, and its inversion.
        let form = cubic.semi_normal_form().expect("not straight");
        let point = cubic.rational_point(&t);
        let [x, y] = [&form.x, &form.y].map(|f| &f[0] * &point[0] + &f[1] * &point[1] + &f[2]);
        match class {
            CubicClass::SShaped => prop_assert_eq!(&y, &x.pow(3)),
            CubicClass::Parabolic => prop_assert_eq!(&y, &x.pow(2)),
            _ => prop_assert_eq!(&y * &y, &x * (&x + &form.c).pow(2)),
        }
        match form.parameter(&point) {
            Some(found) => prop_assert_eq!(found, t),
            None => prop_assert!(matches!(class, CubicClass::Loopy | CubicClass::Pointy) && (x + &form.c).is_zero()),
        }
        prop_assert_eq!(form.parameter(&[&point[0] + &q(1), point[1].clone()]).is_some_and(|t| cubic.rational_point(&t) != [&point[0] + &q(1), point[1].clone()]), false);
        if let Some(graph) = cubic.graph() {
            let value = |list: &[Rational], t: &Rational| list.iter().rev().fold(q(0), |sum, c| sum * t + c);
            let u = value(&graph.rotated.u, &r);
            prop_assert_eq!(value(&graph.coefficients, &u), value(&graph.rotated.v, &r));
        }
    }

    #[test]
    fn equivalent_cubics_and_no_others((class, cubic) in planted(), map in map(), a in nonzero(), b in number(), (other_class, other) in planted(), t in number()) {
        let image = mapped(&reparametrized(&cubic, &a, &b), &map);
        let maps = cubic.equivalence(&image).expect("an affine image");
        prop_assert!(maps.is_rational() || cubic.class().is_stable() || class == CubicClass::Straight);
        let argument = Surd::from(&maps.t0).plus(&maps.scale.times_rational(&(&t - &maps.t1))).expect("one field");
        let point = cubic.point(&argument);
        for index in 0..2 {
            let [x, y] = [0, 1].map(|k| maps.matrix[index][k].times(&point[k]).expect("one field"));
            let value = x.plus(&y).and_then(|sum| sum.plus(&maps.shift[index]));
            prop_assert_eq!(value, Some(Surd::from(image.rational_point(&t)[index].clone())));
        }
        // Over the reals, one class is one orbit.
        let found = cubic.equivalence(&other);
        if class != other_class {
            prop_assert!(found.is_none());
        } else if class != CubicClass::Straight {
            prop_assert!(found.is_some_and(|maps| maps.carries(&cubic, &other)));
        }
    }

    #[test]
    fn humpy_cubics_from_their_flexes(first in vector(), second in vector(), summit in vector()) {
        let edges = [0, 1].map(|k| (&first[k] - &summit[k], &second[k] - &summit[k]));
        match Cubic::from_flexes(&first, &second, &summit) {
            Err(_) => prop_assert_eq!(&edges[0].0 * &edges[1].1, &edges[1].0 * &edges[0].1),
            Ok(cubic) => {
                let Special::Humpy { summit: found, flexes, .. } = cubic.special_points() else { panic!("a humpy cubic") };
                prop_assert_eq!(found.point, summit.map(Surd::from));
                prop_assert_eq!([flexes[0].t.clone(), flexes[1].t.clone()], [q(-1), q(1)].map(Surd::from));
                prop_assert_eq!([flexes[0].point.clone(), flexes[1].point.clone()], [second.map(Surd::from), first.map(Surd::from)]);
            }
        }
    }

    #[test]
    fn portions_tell_what_lies_inside(cubic in any_cubic(), frame in frame()) {
        let special = cubic.special_points();
        let portion = cubic.portion(&special, &frame);
        let mut reversed = cubic.portion(&special, &frame.reversed());
        reversed.frame = frame.clone();
        prop_assert_eq!(&portion, &reversed);
        // Moved to 0..1, everything keeps its place.
        let local = reparametrized(&cubic, &(frame.s() - frame.r()), frame.r());
        let unit = local.portion(&local.special_points(), &Interval::unit());
        let mut places: Vec<_> = unit.features.iter().map(|feature| (feature.name, feature.place)).collect();
        if frame.s() < frame.r() {
            places.reverse();
        }
        let mut expected: Vec<_> = portion.features.iter().map(|feature| (feature.name, feature.place)).collect();
        let key = |entry: &(&'static str, casteljau::Place)| (entry.0, format!("{:?}", entry.1));
        places.sort_by_key(key);
        expected.sort_by_key(key);
        prop_assert_eq!(places, expected);
        prop_assert_eq!(portion.shape, unit.shape);
        if let Some(ends) = &portion.straight_ends {
            for part in 0..9 {
                let point = cubic.point(&Surd::from(frame.at(&Rational::new(part, 8))));
                for index in 0..2 {
                    let (low, high) = if ends[0][index] < ends[1][index] { (&ends[0][index], &ends[1][index]) } else { (&ends[1][index], &ends[0][index]) };
                    prop_assert!(low <= &point[index] && &point[index] <= high);
                }
            }
        }
    }
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 40, ..ProptestConfig::default() })]

    #[test]
    fn no_shorter_move_changes_the_class(cubic in any_cubic(), frame in frame(), part in 1i64..16, fewer: bool) {
        let degree = if fewer && cubic.true_degree() <= 2 { 2 } else { 3 };
        let segment = cubic.curve().with_degree(degree).and_then(|curve| curve.segment(&frame)).expect("a segment");
        let distance = Cubic::distance(&segment).expect("a cubic");
        prop_assert_eq!(distance.class, cubic.class());
        let moved = |point: usize, coordinate: usize, by: &Rational| {
            let mut points = segment.coordinates().to_vec();
            points[2 * point + coordinate] += by;
            Cubic::new(&Segment::new(2, points, frame.clone()).and_then(|s| s.curve()).expect("a curve")).expect("a cubic").class()
        };
        let Some(change) = distance.change else {
            for point in 0..=degree {
                for coordinate in 0..2 {
                    prop_assert_eq!(moved(point, coordinate, &Rational::new(part - 8, 3)), cubic.class());
                }
            }
            return Ok(());
        };
        if let Some(by) = change.by.as_rational() {
            prop_assert!(!change.reached || moved(change.point, change.coordinate, by) == change.class);
        }
        prop_assert!(change.class != cubic.class());
        // Anything shorter, of any coordinate, changes nothing.
        let length = change.by.abs();
        let shorter = length.enclosure(60).0 * Rational::new(part, 16);
        if shorter.is_positive() {
            for point in 0..=degree {
                for coordinate in 0..2 {
                    for by in [shorter.clone(), -&shorter] {
                        prop_assert_eq!(moved(point, coordinate, &by), cubic.class(), "{} of {}", by, length);
                    }
                }
            }
        } else if length.is_zero() {
            // Some tiny move reaches the other class, on one of the two sides.
            let tiny = Rational::new(1, 10).pow(400);
            let sides = [moved(change.point, change.coordinate, &tiny), moved(change.point, change.coordinate, &-&tiny)];
            prop_assert!(sides.contains(&change.class));
        }
    }

    #[test]
    fn families_have_the_class_of_their_members(one in any_cubic(), other in any_cubic(), third in any_cubic(), samples in prop::collection::vec(number(), 6), square: bool) {
        // F + k G, or F + k G + k² H
        let k = Symbol::new('k', None);
        let member = |t: &Rational| Cubic::from_vectors(std::array::from_fn(|power| [0, 1].map(|index| {
            let square = if square { t * t * &third.vectors()[power][index] } else { q(0) };
            &one.vectors()[power][index] + t * &other.vectors()[power][index] + square
        })));
        let coordinate = |index: usize| (0..4).map(|power| {
            let list = [&one, &other, &third].map(|cubic| Polynomial::from(cubic.vectors()[power][index].clone()));
            Polynomial::from_coefficients(k, if square { &list } else { &list[..2] })
        }).collect();
        let curve = Curve::new(vec![coordinate(0), coordinate(1)]).expect("a curve");
        let has_parameter = (0..4).any(|power| curve.vector(power).iter().any(|c| c.as_rational().is_none()));
        let family = match Family::of(&curve) {
            Ok(family) => family,
            Err(_) => {
                prop_assert!(!has_parameter);
                return Ok(());
            }
        };
        prop_assert_eq!(family.between.len(), family.breakpoints.len() + 1);
        let below = |number: &AlgebraicNumber, t: &Rational| match number {
            AlgebraicNumber::Surd(surd) => *surd < Surd::from(t),
            AlgebraicNumber::Isolated(root) => root.interval().1 <= t,
        };
        let near = |number: &AlgebraicNumber, t: &Rational| match number {
            AlgebraicNumber::Surd(surd) => surd.as_rational() == Some(t),
            AlgebraicNumber::Isolated(root) => root.interval().0 < t && t < root.interval().1,
        };
        let exact: Vec<Rational> = family.breakpoints.iter().filter_map(|found| match &found.value {
            AlgebraicNumber::Surd(surd) => surd.as_rational().cloned(),
            AlgebraicNumber::Isolated(_) => None,
        }).collect();
        for t in samples.iter().chain(&exact) {
            let class = member(t).class();
            match family.breakpoints.iter().find(|found| near(&found.value, t)) {
                Some(found) if matches!(found.value, AlgebraicNumber::Surd(_)) => prop_assert_eq!(found.class, class),
                Some(_) => {}
                None => {
                    let place = family.breakpoints.iter().filter(|found| below(&found.value, t)).count();
                    prop_assert_eq!(family.between[place], class, "at {}", t);
                }
            }
        }
    }
}

fn coordinate(degree: usize) -> impl Strategy<Value = Vec<Rational>> {
    prop::collection::vec(prop_oneof![2 => Just(q(0)), 6 => (-5i64..6).prop_map(q), 1 => number()], degree + 1)
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 48, ..ProptestConfig::default() })]

    #[test]
    fn equations_hold_on_their_curves(lists in (coordinate(5), coordinate(5)), t in (-20i64..20).prop_map(|n| Rational::new(n, 3)), probe in vector()) {
        let curve = Curve::new(vec![lists.0, lists.1]).expect("a curve");
        let Ok(implicit) = ImplicitCurve::of(&curve) else {
            prop_assert_eq!(curve.true_degree(), 0);
            return Ok(());
        };
        prop_assert!(implicit.vanishes_on(&curve));
        prop_assert_eq!(implicit.degree() * implicit.index(), curve.true_degree());
        prop_assert_eq!(implicit.conic_type().is_some(), implicit.degree() == 2);
        let point = curve.value(&t);
        let Parameters::These(list) = curve.parameters_of(&point).expect("the plane") else { panic!("not a point") };
        prop_assert!(list.contains(&AlgebraicNumber::Surd(Surd::from(t))));
        // A point off the curve has no parameter; one where the equation fails is off it.
        let found = curve.parameters_of(&probe).expect("the plane");
        prop_assert!(!found.exist() || implicit.gauge(&probe).is_zero());
        let primitive = implicit.terms().last().is_some_and(|(_, _, c)| c.is_positive());
        prop_assert!(primitive);
    }

    #[test]
    fn composing_multiplies_the_tracing_index(outer in (coordinate(3), coordinate(3)), inner in coordinate(2), a in nonzero()) {
        let outer = Curve::new(vec![outer.0, outer.1]).expect("a curve");
        // h has degree 1 or 2; F(t) = G(h(t)) runs through its points that many times as often.
        let mut inner = inner;
        if inner[2].is_zero() { inner[1] = a; }
        let degree = if inner[2].is_zero() { 1 } else { 2 };
        let t = Symbol::new('t', None);
        let h = Polynomial::from_coefficients(t, &inner.iter().cloned().map(Polynomial::from).collect::<Vec<_>>());
        let coordinates = (0..2).map(|index| {
            let list: Vec<Polynomial> = outer.coordinate(index).cloned().map(Polynomial::from).collect();
            let composed = Polynomial::from_coefficients(t, &list).substitute(t, &h);
            composed.coefficients_in(t).iter().map(|c| c.as_rational().expect("a number")).collect()
        }).collect();
        let composed = Curve::new(coordinates).expect("a curve");
        if let Ok(expected) = ImplicitCurve::of(&outer) {
            let found = ImplicitCurve::of(&composed).expect("a curve");
            prop_assert_eq!(found.terms(), expected.terms());
            prop_assert_eq!(found.index(), degree * expected.index());
        }
    }

    #[test]
    fn quadrics_contain_their_surfaces(corners in prop::array::uniform4(prop::array::uniform3(-4i64..5)), form in prop::array::uniform3(-3i64..4), u in number(), v in number()) {
        // Bilinear patches: hyperbolic paraboloids unless the corners are coplanar.
        let e = |k: usize| -> [i64; 3] { std::array::from_fn(|axis| match k {
            0 => corners[0][axis],
            1 => corners[1][axis] - corners[0][axis],
            2 => corners[2][axis] - corners[0][axis],
            _ => corners[0][axis] - corners[1][axis] - corners[2][axis] + corners[3][axis],
        }) };
        let terms = |axis: usize| vec![(0, 0, q(e(0)[axis])), (1, 0, q(e(1)[axis])), (0, 1, q(e(2)[axis])), (1, 1, q(e(3)[axis]))];
        let patch = Surface::tensor((0..3).map(terms).collect()).expect("a surface");
        let found = QuadricSurface::of(&patch).expect("in space");
        let [a, b, c] = [e(1), e(2), e(3)];
        let volume = a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0]) + a[2] * (b[0] * c[1] - b[1] * c[0]);
        prop_assert_eq!(found.class == QuadricClass::HyperbolicParaboloid, volume != 0);
        prop_assert!(volume != 0 || matches!(found.class, QuadricClass::Plane | QuadricClass::Line | QuadricClass::Point));
        // Graphs z = a u² + b u v + c v².
        let [a, b, c] = form;
        let graph = Surface::total(vec![vec![(1, 0, q(1))], vec![(0, 1, q(1))], vec![(2, 0, q(a)), (1, 1, q(b)), (0, 2, q(c))]]).expect("a surface");
        let class = QuadricSurface::of(&graph).expect("in space");
        prop_assert_eq!(class.class, match 4 * a * c - b * b {
            _ if form == [0, 0, 0] => QuadricClass::Plane,
            0 => QuadricClass::ParabolicCylinder,
            d if d > 0 => QuadricClass::EllipticParaboloid,
            _ => QuadricClass::HyperbolicParaboloid,
        });
        for (surface, found) in [(&patch, found), (&graph, class)] {
            if let Some(polynomial) = found.polynomial() {
                let point = surface.value(&[u.clone(), v.clone()]);
                let values: Vec<(Symbol, Polynomial)> =
                    ['x', 'y', 'z'].into_iter().zip(point).map(|(letter, c)| (Symbol::new(letter, None), Polynomial::from(c))).collect();
                prop_assert!(polynomial.substitute_all(&values).is_empty());
            }
        }
    }
}

#[test]
fn the_generators_reach_every_class() {
    let mut runner = TestRunner::deterministic();
    let (mut classes, mut random) = ([0usize; 6], [0usize; 6]);
    let (mut straight, mut shapes) = ([0usize; 6], std::collections::BTreeMap::new());
    let index = |class: CubicClass| CubicClass::ALL.iter().position(|known| *known == class).expect("all classes");
    for _ in 0..600 {
        let (class, cubic) = planted().new_tree(&mut runner).expect("a value").current();
        classes[index(class)] += 1;
        if let Special::Straight(found) = cubic.special_points() {
            straight[found.degree + found.turns.len()] += 1;
        }
        let cubic = any_cubic().new_tree(&mut runner).expect("a value").current();
        random[index(cubic.class())] += 1;
        let frame = frame().new_tree(&mut runner).expect("a value").current();
        *shapes.entry(cubic.portion(&cubic.special_points(), &frame).shape.name()).or_insert(0) += 1;
    }
    assert!(classes.iter().all(|&count| count >= 40), "{classes:?}");
    assert!(random.iter().all(|&count| count >= 30), "{random:?}");
    // Points, lines, double rays (2 + 1), cubics without (3) and with two turns (3 + 2).
    assert!([0, 1, 3, 5].iter().all(|&kind| straight[kind] >= 5), "{straight:?}");
    assert_eq!(shapes.len(), 8, "{shapes:?}");
}

#[test]
fn a_curve_that_is_no_planar_cubic_is_refused() {
    let refused = |lists: Vec<Vec<Rational>>| Cubic::new(&Curve::new(lists).expect("a curve")).expect_err("no planar cubic").to_string();
    assert!(refused(vec![vec![q(1)]; 3]).contains("`transform` projects"));
    assert!(refused(vec![vec![q(1), q(1)]]).contains("(t, F(t))"));
    assert!(refused(vec![vec![q(0), q(0), q(0), q(0), q(1)], vec![q(1)]]).contains("`implicit`"));
}
