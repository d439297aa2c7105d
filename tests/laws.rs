//! The laws of blossoming, for curves, on generated input compared with `==`.
//!
//! Strategy: numbers of every width (zero, small, at the borders of one and
//! two words, and far beyond), frames in both directions with ends at zero,
//! degrees from 0 on with leading coefficients that vanish often. The last
//! test counts what the generators make, so that the degenerate cases are
//! known to be reached.

#[allow(dead_code)] // Other tests use the rest of it.
mod oracle;

use casteljau::{
    AffineMap, Bernstein, Coefficient, ConvexHull, Curve, Interval, Parameter, Polynomial, Rational, Reading, Segment, Symbol,
    check_polar_form,
};
use oracle::Coefficients;
use proptest::prelude::*;
use proptest::strategy::ValueTree;
use proptest::test_runner::TestRunner;

fn number() -> impl Strategy<Value = Rational> {
    let integer = prop_oneof![
        3 => Just(0i64),
        8 => -9i64..10,
        2 => any::<i32>().prop_map(i64::from),
        1 => any::<i64>(),
        1 => (-1i64..2).prop_map(|k| i64::MAX - 1 + k),
    ];
    let denominator = prop_oneof![6 => Just(1i64), 6 => 1i64..13, 2 => 1i64..1_000_000_007, 1 => 1i64..i64::MAX];
    prop_oneof![
        12 => (integer, denominator).prop_map(|(n, d)| Rational::new(n, d)),
        1 => (any::<i64>(), any::<i64>(), 1i64..i64::MAX).prop_map(|(a, b, d)| Rational::from(a) * Rational::new(b, d)),
        1 => (-3i64..4, 1u32..60).prop_map(|(n, power)| Rational::from(n) + Rational::new(1, 7).pow(power)),
    ]
}

fn frame() -> impl Strategy<Value = Interval> {
    (number(), number()).prop_filter_map("different ends", |(r, s)| Interval::new(r, s).ok())
}

fn coefficients(max_degree: usize) -> impl Strategy<Value = Coefficients> {
    (1usize..4, 0..=max_degree).prop_flat_map(|(dimension, degree)| {
        let coordinate = (prop::collection::vec(number(), degree + 1), 0..=degree + 1).prop_map(|(mut list, kept)| {
            // Leading zeros: the true degree of the curve is often below its polar degree.
            if kept <= list.len() / 2 {
                list[kept..].iter_mut().for_each(|c| *c = Rational::from(0));
            }
            list
        });
        prop::collection::vec(coordinate, dimension)
    })
}

fn curve(max_degree: usize) -> impl Strategy<Value = Curve> {
    coefficients(max_degree).prop_filter_map("a curve", |lists| Curve::new(lists).ok())
}

fn segment(max_degree: usize) -> impl Strategy<Value = Segment> {
    (1usize..4, 0..=max_degree, frame()).prop_flat_map(|(dimension, degree, frame)| {
        prop::collection::vec(number(), dimension * (degree + 1))
            .prop_filter_map("a segment", move |list| Segment::new(dimension, list, frame.clone()).ok())
    })
}

fn points_of(segment: &Segment) -> Vec<Vec<Rational>> {
    segment.points().map(<[Rational]>::to_vec).collect()
}

fn combination(a: &[Rational], b: &[Rational], weight: &Rational) -> Vec<Rational> {
    a.iter().zip(b).map(|(x, y)| x * (Rational::from(1) - weight) + y * weight).collect()
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 192, ..ProptestConfig::default() })]

    #[test]
    fn the_polar_form_is_the_polarization_identity(lists in coefficients(6), seed in prop::collection::vec((number(), prop_oneof![Just(Rational::from(1)), Just(Rational::from(0)), number()]), 6)) {
        let curve = Curve::new(lists.clone()).expect("a curve");
        let arguments = &seed[..curve.degree()];
        let homogeneous: Vec<Parameter> = arguments.iter().map(|(t, w)| Parameter::homogeneous(w.clone(), t.clone())).collect();
        let expected = oracle::polarization(&lists, arguments);
        prop_assert_eq!(&curve.blossom_homogeneous(&homogeneous).expect("as many as the degree"), &expected);
        // The same through control points over a frame of their own.
        let segment = curve.segment(&Interval::new(Rational::new(-2, 3), Rational::from(5)).expect("a frame")).expect("a segment");
        prop_assert_eq!(segment.blossom_homogeneous(&homogeneous).expect("as many as the degree"), expected);
    }

    #[test]
    fn the_polar_form_is_symmetric_multiaffine_and_diagonal(curve in curve(7), seed in prop::collection::vec(number(), 8), weight in number(), place: prop::sample::Index, other: prop::sample::Index) {
        let m = curve.degree();
        let mut arguments = seed[..m].to_vec();
        let polar = curve.polar();
        prop_assert_eq!(polar.value(&arguments).expect("m arguments"), curve.blossom(&arguments).expect("m arguments"));
        prop_assert_eq!(curve.blossom(&vec![seed[7].clone(); m]).expect("m arguments"), curve.value(&seed[7]));
        if m > 0 {
            let (i, j) = (place.index(m), other.index(m));
            let value = curve.blossom(&arguments).expect("m arguments");
            arguments.swap(i, j);
            prop_assert_eq!(&curve.blossom(&arguments).expect("m arguments"), &value);
            arguments.swap(i, j);
            let (at_first, second) = (arguments[i].clone(), seed[7].clone());
            arguments[i] = second.clone();
            let at_second = curve.blossom(&arguments).expect("m arguments");
            arguments[i] = &at_first * (Rational::from(1) - &weight) + &second * &weight;
            prop_assert_eq!(curve.blossom(&arguments).expect("m arguments"), combination(&value, &at_second, &weight));
        }
    }

    #[test]
    fn control_points_are_polar_values(curve in curve(8), frame in frame()) {
        let segment = curve.segment(&frame).expect("a segment");
        let m = curve.degree();
        for i in 0..=m {
            let mut arguments = vec![frame.r().clone(); m - i];
            arguments.extend(vec![frame.s().clone(); i]);
            prop_assert_eq!(segment.point(i), curve.blossom(&arguments).expect("m arguments"));
        }
        prop_assert_eq!(&segment.curve().expect("a curve"), &curve);
    }

    #[test]
    fn any_points_are_control_points_of_one_curve(segment in segment(8)) {
        let curve = segment.curve().expect("a curve");
        prop_assert_eq!(curve.degree(), segment.degree());
        prop_assert_eq!(curve.segment(segment.frame()).expect("a segment"), segment);
    }

    #[test]
    fn polar_values_of_control_points_are_the_subset_sum(segment in segment(6), seed in prop::collection::vec(number(), 6)) {
        let arguments = &seed[..segment.degree()];
        let expected = oracle::subset_sum(&points_of(&segment), segment.frame().r(), segment.frame().s(), arguments);
        prop_assert_eq!(segment.blossom(arguments).expect("m arguments"), expected);
    }

    #[test]
    fn values_agree_by_every_route(lists in coefficients(7), frame in frame(), t in number()) {
        let curve = Curve::new(lists.clone()).expect("a curve");
        let expected = oracle::value(&lists, &t);
        let segment = curve.segment(&frame).expect("a segment");
        prop_assert_eq!(&curve.value(&t), &expected);
        prop_assert_eq!(&segment.value(&t).expect("a value"), &expected);
        let scheme = segment.scheme(&t).expect("a scheme");
        prop_assert_eq!(scheme.point(), &expected);
        let basis = Bernstein::new(segment.degree(), frame).values(std::slice::from_ref(&t)).expect("one parameter");
        prop_assert_eq!(basis.iter().sum::<Rational>(), Rational::from(1));
        let weighted: Vec<Rational> = (0..segment.dimension()).map(|c| segment.points().zip(&basis).map(|(point, b)| &point[c] * b).sum()).collect();
        prop_assert_eq!(weighted, expected);
    }

    #[test]
    fn every_entry_of_the_scheme_is_its_label(segment in segment(5), t in number()) {
        let scheme = segment.scheme(&t).expect("a scheme");
        let (r, s) = (segment.frame().r(), segment.frame().s());
        for j in 0..=segment.degree() {
            for i in 0..=segment.degree() - j {
                let mut arguments = vec![t.clone(); j];
                arguments.extend(vec![r.clone(); segment.degree() - i - j]);
                arguments.extend(vec![s.clone(); i]);
                let expected = oracle::subset_sum(&points_of(&segment), r, s, &arguments);
                prop_assert_eq!(scheme.get(i, j), expected);
            }
        }
    }

    #[test]
    fn halves_are_the_same_map_and_read_from_the_scheme(segment in segment(6), t in number()) {
        let scheme = segment.scheme(&t).expect("a scheme");
        match segment.split(&t) {
            Ok((left, right)) => {
                prop_assert!(left.same_map(&segment).expect("numbers") && right.same_map(&segment).expect("numbers"));
                prop_assert!(left.points().eq(scheme.left()) && right.points().eq(scheme.right()));
                prop_assert_eq!(&left, &segment.reframe(left.frame()).expect("numbers"));
            }
            Err(_) => prop_assert!(t == *segment.frame().r() || t == *segment.frame().s()),
        }
    }

    #[test]
    fn reframing_there_and_back_is_nothing(segment in segment(7), other in frame()) {
        let there = segment.reframe(&other).expect("numbers");
        prop_assert!(there.same_map(&segment).expect("numbers"));
        prop_assert_eq!(there.reframe(segment.frame()).expect("numbers"), segment);
    }

    #[test]
    fn reversing_the_frame_reverses_the_points(segment in segment(6)) {
        let reversed = segment.reframe(&segment.frame().reversed()).expect("numbers");
        prop_assert!(reversed.points().rev().eq(segment.points()));
    }

    #[test]
    fn elevating_and_reducing(segment in segment(6), by in 0usize..5) {
        let elevated = segment.elevate(by).expect("small");
        prop_assert_eq!(elevated.degree(), segment.degree() + by);
        prop_assert!(elevated.same_map(&segment).expect("numbers"));
        // One step at a time by the textbook's rule.
        let mut points = points_of(&segment);
        for _ in 0..by {
            let m = points.len();
            points = (0..=m).map(|i| {
                let before = points[i.max(1) - 1].clone();
                let here = points[i.min(m - 1)].clone();
                combination(&here, &before, &Rational::new(i as i64, m as i64))
            }).collect();
        }
        prop_assert_eq!(points_of(&elevated), points);
        let (reduced, original) = (elevated.reduce().expect("numbers"), segment.reduce().expect("numbers"));
        prop_assert_eq!(&reduced, &original);
        prop_assert_eq!(reduced.true_degree, segment.curve().expect("numbers").true_degree());
        prop_assert_eq!(reduced.zero, segment.coordinates().iter().all(|x| *x == Rational::from(0)));
    }

    #[test]
    fn derivatives_are_polar_values_at_directions(curve in curve(6), t in number(), order in 0usize..8) {
        let m = curve.degree();
        let derivative = curve.derivative(order);
        if order > m {
            prop_assert!(derivative.value(&t).iter().all(|x| *x == Rational::from(0)));
            return Ok(());
        }
        let mut arguments = vec![Parameter::from(t.clone()); m - order];
        arguments.extend(vec![Parameter::direction(); order]);
        let factor: Rational = (m - order + 1..=m).map(Rational::from).product();
        let expected: Vec<Rational> = curve.blossom_homogeneous(&arguments).expect("m arguments").iter().map(|x| x * &factor).collect();
        prop_assert_eq!(derivative.value(&t), expected);
        if order == 1 {
            let frame = Interval::new(Rational::from(-2), Rational::new(1, 3)).expect("a frame");
            let through_points = curve.segment(&frame).and_then(|segment| segment.derivative()).expect("numbers");
            prop_assert!(through_points.curve().expect("numbers").same_map(&derivative));
        }
    }

    #[test]
    fn products_multiply_values(a in segment(4), lists in coefficients(4), t in number()) {
        let other = Curve::new(lists).expect("a curve").segment(a.frame()).expect("a segment");
        match a.product(&other) {
            Ok(product) => {
                prop_assert_eq!(product.degree(), a.degree() + other.degree());
                let (x, y, z) = (a.value(&t).expect("numbers"), other.value(&t).expect("numbers"), product.value(&t).expect("numbers"));
                for (index, value) in z.iter().enumerate() {
                    prop_assert_eq!(value, &(&x[index % x.len()] * &y[index % y.len()]));
                }
            }
            Err(_) => prop_assert!(a.dimension() != other.dimension() && a.dimension() != 1 && other.dimension() != 1),
        }
    }

    #[test]
    fn control_points_of_the_image_are_images_of_the_control_points(segment in segment(5), entries in prop::collection::vec(number(), 8)) {
        let n = segment.dimension();
        let rows = vec![entries[..n].to_vec(), entries[3..3 + n].to_vec()];
        let map = AffineMap::new(rows, entries[6..8].to_vec()).expect("a map");
        let image = segment.transform(&map).expect("the dimension fits");
        prop_assert_eq!(&image.curve().expect("numbers"), &segment.curve().expect("numbers").transform(&map).expect("the dimension fits"));
        let frame = Interval::new(Rational::from(7), Rational::from(-1)).expect("a frame");
        let (one, two) = (image.reframe(&frame).expect("numbers"), segment.reframe(&frame).and_then(|s| s.transform(&map)).expect("numbers"));
        prop_assert_eq!(one, two);
    }

    #[test]
    fn symmetric_functions_are_sums_over_subsets(numbers in prop::collection::vec(number(), 0..8)) {
        prop_assert_eq!(casteljau::sigma(&numbers), oracle::sigma(&numbers));
    }

    #[test]
    fn the_curve_lies_in_the_hull_of_its_control_points(list in prop::collection::vec(number(), 8), frame in frame(), part in 0i64..17) {
        let segment = Segment::new(2, list, frame).expect("a segment");
        let t = segment.frame().at(&Rational::new(part, 16));
        prop_assert!(segment.frame().contains(&t));
        let point = segment.value(&t).expect("numbers");
        let hull = ConvexHull::of(segment.points()).expect("points of the plane");
        prop_assert!(hull.contains(&[point[0].clone(), point[1].clone()]));
    }

    #[test]
    fn the_polyline_is_as_near_as_it_says(segment in segment(4), depth in 0usize..4, part in 0i64..33) {
        let bound: Vec<Rational> = segment.flatness().iter().map(|b| b * Rational::new(1, 4).pow(depth as u32)).collect();
        let polyline = segment.polyline(depth).expect("numbers");
        let pieces = (polyline.len() - 1) as i64;
        let scaled = Rational::new(part * pieces, 32);
        let index = (0..pieces - 1).find(|&k| scaled < Rational::from(k + 1)).unwrap_or(pieces - 1);
        let chord = combination(&polyline[index as usize], &polyline[index as usize + 1], &(scaled - Rational::from(index)));
        let point = segment.value(&segment.frame().at(&Rational::new(part, 32))).expect("numbers");
        for ((a, b), limit) in chord.iter().zip(&point).zip(&bound) {
            let distance = if a > b { a - b } else { b - a };
            prop_assert!(distance <= *limit);
        }
    }

    #[test]
    fn symbols_stand_for_numbers(segment in segment(4), t in number(), values in prop::collection::vec(number(), 15)) {
        // Control points and parameter as symbols, then numbers put in, against numbers throughout.
        let frame = segment.frame().clone();
        let symbol = |index: usize| Symbol::new('p', Some(index as u32));
        let at = Symbol::new('t', None);
        let coordinates = (0..segment.coordinates().len()).map(|index| Polynomial::from(symbol(index))).collect();
        let symbolic_frame = Interval::new(Polynomial::from(frame.r().clone()), Polynomial::from(frame.s().clone())).expect("a frame");
        let symbolic = Segment::new(segment.dimension(), coordinates, symbolic_frame).expect("a segment");
        let mut put_in: Vec<(Symbol, Polynomial)> = values.iter().take(segment.coordinates().len()).enumerate().map(|(index, value)| (symbol(index), Polynomial::from(value.clone()))).collect();
        put_in.push((at, Polynomial::from(t.clone())));
        let numeric = Segment::new(segment.dimension(), values[..segment.coordinates().len()].to_vec(), frame).expect("a segment");
        let number = |polynomial: &Polynomial| polynomial.substitute_all(&put_in).as_rational().expect("all symbols are replaced");
        let scheme = symbolic.scheme(&Polynomial::from(at)).expect("a scheme");
        let expected = numeric.scheme(&t).expect("a scheme");
        for (one, two) in scheme.layers().zip(expected.layers()) {
            for (a, b) in one.zip(two) {
                prop_assert_eq!(a.iter().map(number).collect::<Vec<_>>(), b);
            }
        }
        let equation: Vec<Rational> = symbolic.curve().expect("numeric ends").value(&Polynomial::from(at)).iter().map(number).collect();
        prop_assert_eq!(equation, expected.point());
    }

    #[test]
    fn expanded_polar_forms_pass_the_check_and_changed_ones_fail(curve in curve(4), wrong in number(), kind in 0usize..3) {
        let variable = Symbol::new('t', None);
        let reading = Reading::Curve(curve.degree());
        let powers = |index| curve.coordinate(index).cloned().map(Polynomial::from).collect::<Vec<_>>();
        let map: Vec<Polynomial> = (0..curve.dimension()).map(|index| Polynomial::from_coefficients(variable, &powers(index))).collect();
        let mut claim: Vec<Polynomial> = (0..curve.dimension()).map(|index| curve.polar().expand(index, 1000).expect("few terms")).collect();
        prop_assert_eq!(check_polar_form(reading, &map, &[variable], &claim).expect("as many coordinates"), []);
        prop_assume!(wrong != Rational::from(0) && curve.degree() > 1);
        let first = Polynomial::from(reading.symbol(0, 1, 1));
        let second = Polynomial::from(reading.symbol(0, 2, 1));
        let error = match kind {
            0 => first.clone(),
            1 => &first - &second,
            _ => &(&first * &first) - &(&first * &second),
        };
        claim[0] += &error.scale(&wrong);
        prop_assert!(!check_polar_form(reading, &map, &[variable], &claim).expect("as many coordinates").is_empty());
    }
}

/// A word of a given length, all ones or one more, positive or negative.
fn at_a_border() -> impl Strategy<Value = i64> {
    (0u32..63, any::<bool>(), -1i64..2).prop_map(|(bits, negative, more)| {
        let value = ((1i64 << bits) - 1).saturating_add(more);
        if negative { -value } else { value }
    })
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 512, ..ProptestConfig::default() })]

    /// Numbers whose lengths sweep the borders where the integers change their
    /// width, all at their largest, against the definitions on plain fractions.
    #[test]
    fn widths_change_without_a_trace(
        numbers in prop::collection::vec((at_a_border(), prop_oneof![3 => Just(1i64), 2 => 1i64..1000, 1 => at_a_border().prop_map(|d| d.max(1))]), 12),
        parameters in prop::collection::vec((at_a_border(), prop_oneof![Just(1i64), 1i64..100]), 5),
        small in any::<bool>(),
        dimension in 1usize..4,
    ) {
        let rational = |&(numer, denom): &(i64, i64)| Rational::new(numer, denom);
        let lists: Coefficients = numbers.chunks_exact(12 / dimension).map(|list| list.iter().take(5).map(rational).collect()).collect();
        let curve = Curve::new(lists.clone()).expect("a curve");
        let m = curve.degree();
        let parameters: Vec<Rational> = parameters.iter().map(|&(t, d)| if small { Rational::new(t % 100, d) } else { Rational::new(t, d) }).collect();
        let at = |arguments: &[Rational]| {
            let weighted: Vec<(Rational, Rational)> = arguments.iter().map(|t| (t.clone(), Rational::from(1))).collect();
            oracle::polarization(&lists, &weighted)
        };
        prop_assert_eq!(curve.blossom(&parameters[..m]).expect("m arguments"), at(&parameters[..m]));
        let (r, s, t) = (&parameters[0], &parameters[1], &parameters[2]);
        let Ok(frame) = Interval::new(r.clone(), s.clone()) else { return Ok(()) };
        let segment = curve.segment(&frame).expect("a segment");
        for i in 0..=m {
            let vertices: Vec<Rational> = (0..m).map(|place| if place < i { s.clone() } else { r.clone() }).collect();
            prop_assert_eq!(segment.point(i), at(&vertices), "f(r^{} s^{})", m - i, i);
        }
        let Ok((left, right)) = segment.split(t) else { return Ok(()) };
        for i in 0..=m {
            let place = |first: &Rational, second: &Rational| -> Vec<Rational> { (0..m).map(|place| if place < i { second.clone() } else { first.clone() }).collect() };
            prop_assert_eq!(left.point(i), at(&place(r, t)));
            prop_assert_eq!(right.point(i), at(&place(t, s)));
        }
    }
}

/// Long numbers and high degrees, where every width of integer is chosen.
#[test]
fn round_trips_at_high_degrees() {
    for degree in [20, 45, 90, 180] {
        let list = (0..=degree).map(|k| Rational::new(k * k % 1999 - 1000, 1000)).collect();
        let curve = Curve::new(vec![list]).expect("a curve");
        let frame = Interval::new(Rational::new(-1, 3), Rational::new(7, 5)).expect("a frame");
        let segment = curve.segment(&frame).expect("a segment");
        assert_eq!(segment.curve().expect("numbers"), curve, "degree {degree}");
        assert_eq!(segment.point(0), curve.value(frame.r()), "degree {degree}");
        let arguments: Vec<Rational> = (0..degree).map(|k| Rational::new(k % 17 - 8, k % 5 + 1)).collect();
        assert_eq!(segment.blossom(&arguments), curve.blossom(&arguments), "degree {degree}");
        let (left, right) = segment.split(&Rational::new(1, 3)).expect("inside");
        assert!(left.same_map(&right).expect("numbers"), "degree {degree}");
    }
}

#[test]
fn the_generators_reach_the_degenerate_cases() {
    let mut runner = TestRunner::deterministic();
    let (mut reduced, mut constant, mut reversed, mut at_zero, mut long, mut zero_coordinate) = (0, 0, 0, 0, 0, 0);
    for _ in 0..500 {
        let curve = curve(6).new_tree(&mut runner).expect("a curve").current();
        let frame = frame().new_tree(&mut runner).expect("a frame").current();
        reduced += usize::from(curve.true_degree() < curve.degree());
        constant += usize::from(curve.degree() == 0);
        reversed += usize::from(frame.r() > frame.s());
        at_zero += usize::from(*frame.r() == Rational::from(0) || *frame.s() == Rational::from(0));
        long += usize::from((0..curve.dimension()).any(|index| curve.coordinate(index).any(|c| c.bits() > 64)));
        zero_coordinate += usize::from((0..curve.dimension()).any(|index| curve.coordinate(index).all(|c| *c == Rational::from(0))));
    }
    for (what, count) in [
        ("reduced", reduced),
        ("constant", constant),
        ("reversed", reversed),
        ("at zero", at_zero),
        ("long", long),
        ("zero", zero_coordinate),
    ] {
        assert!(count >= 15, "{what}: only {count} of 500");
    }
}

/// The trait that curves are generic over is usable from outside.
#[test]
fn coefficients_are_a_public_trait() {
    fn doubled<C: Coefficient>(value: &C) -> C {
        value.plus(value)
    }
    assert_eq!(doubled(&Rational::new(1, 2)), Rational::from(1));
    assert_eq!(doubled(&Polynomial::from(Symbol::new('a', None))).to_string(), "2 a");
}

/// Each axiom has a claim that fails it alone.
#[test]
fn every_axiom_is_checked_by_itself() {
    use casteljau::PolarDefect::{NotAffine, NotSymmetric, WrongDiagonal};
    let variable = Symbol::new('t', None);
    let polynomial = |text: &str| casteljau::syntax::parse_scalar(text).expect("a polynomial");
    let defects =
        |claim: &str| check_polar_form(Reading::Curve(2), &[polynomial("t^2")], &[variable], &[polynomial(claim)]).expect("one coordinate");
    assert_eq!(defects("t1 t2"), []);
    assert_eq!(defects("(t1^2 + t2^2)/2"), [NotAffine { coordinate: 0, group: 0, argument: 1, degree: 2 }]);
    assert_eq!(
        defects("t1 t2 + t1 - t2"),
        [NotSymmetric { coordinate: 0, group: 0, arguments: (1, 2), difference: polynomial("2 t2 - 2 t1") }]
    );
    assert_eq!(defects("t1 t2 + 1"), [WrongDiagonal { coordinate: 0, difference: polynomial("1") }]);
}

/// Places that are not there are refused in words, in every build.
#[test]
fn places_outside_of_a_curve_panic_as_documented() {
    let points = [0, 4, 8].map(|x| vec![Rational::from(x), Rational::from(1)]).to_vec();
    let segment = Segment::from_points(points, Interval::unit()).expect("three points");
    let scheme = segment.scheme(&Rational::new(1, 4)).expect("numbers");
    let polar = segment.curve().expect("numbers").polar();
    let no_point = "the degree is 2: no point has the exponents";
    assert!(oracle::panic_message(|| segment.label(3)).starts_with(no_point));
    assert!(oracle::panic_message(|| scheme.label(1, 2)).starts_with(no_point));
    assert!(oracle::panic_message(|| scheme.get(usize::MAX, 1).to_vec()).starts_with(no_point));
    assert!(oracle::panic_message(|| scheme.layer(3).len()).starts_with(no_point));
    // There are six coefficients, but only two coordinates.
    assert_eq!(oracle::panic_message(|| polar.term_count(2)), "the map has 2 coordinates");
    assert_eq!(oracle::panic_message(|| polar.expand(5, 100)), "the map has 2 coordinates");
}

#[test]
fn no_limit_refuses_no_polar_form() {
    let curve = Curve::new(vec![[0, 3, 0, 1].map(Rational::from).to_vec()]).expect("a curve");
    assert_eq!(curve.polar().expand(0, usize::MAX).map(|form| form.to_string()), Ok("t1 t2 t3 + t1 + t2 + t3".to_owned()));
    assert!(curve.polar().expand(0, 3).is_err());
}

#[test]
fn a_claim_needs_the_variables_of_its_reading() {
    let [t, u, v] = ['t', 'u', 'v'].map(|letter| Symbol::new(letter, None));
    let zero = [Polynomial::default()];
    let check = |reading, variables: &[Symbol]| check_polar_form(reading, &zero, variables, &zero);
    let wrong = |expected, found| Err(casteljau::Error::WrongCount { what: "variables", expected, found });
    assert_eq!(check(Reading::Curve(2), &[]), wrong(1, 0));
    assert_eq!(check(Reading::Curve(2), &[u, v]), wrong(1, 2));
    assert_eq!(check(Reading::Total(2), &[u]), wrong(2, 1));
    assert_eq!(check(Reading::Bidegree(1, 1), &[u]), wrong(2, 1));
    assert_eq!(check(Reading::Curve(2), &[t]), Ok(Vec::new()));
    assert_eq!(check(Reading::Bidegree(1, 0), &[u, v]), Ok(Vec::new()));
}

/// What would not fit into memory is refused before it is made.
#[test]
fn degrees_of_curves_have_limits() {
    use casteljau::Error::TooLarge;
    let line = Curve::new(vec![[0, 1].map(Rational::from).to_vec(), vec![Rational::from(1)]]).expect("a curve");
    for degree in [usize::MAX, usize::MAX / 2, Curve::<Rational>::MAX_COEFFICIENTS / 2] {
        assert!(matches!(line.clone().with_degree(degree), Err(TooLarge { limit: Curve::<Rational>::MAX_COEFFICIENTS, .. })), "{degree}");
    }
    let highest = Curve::<Rational>::MAX_COEFFICIENTS / 2 - 1;
    assert_eq!(line.clone().with_degree(highest).map(|curve| (curve.degree(), curve.true_degree())), Ok((highest, 1)));
    // One long list makes all the others as long.
    let sparse = std::iter::once(vec![Rational::from(1); 1 << 12]).chain(std::iter::repeat_n(Vec::new(), 1 << 12)).collect();
    assert!(matches!(Curve::new(sparse), Err(TooLarge { .. })));
    let segment = line.segment(&Interval::unit()).expect("numbers");
    for by in [usize::MAX, usize::MAX / 2, 1 << 22, 1 << 13] {
        assert!(matches!(segment.elevate(by), Err(TooLarge { limit: Segment::<Rational>::MAX_STEPS, .. })), "{by}");
    }
    assert_eq!(segment.elevate(1 << 8).map(|raised| raised.degree()), Ok(257));
}

#[test]
fn subdivisions_of_curves_have_limits() {
    use casteljau::Error::TooLarge;
    let point = |count: usize| Segment::new(1, vec![Rational::from(1); count], Interval::unit()).expect("points");
    let (most, limit) = (Segment::<Rational>::MAX_DEPTH, Segment::<Rational>::MAX_STEPS);
    assert_eq!(point(1).subdivide(most + 1), Err(TooLarge { what: "depth of subdivision", limit: most }));
    assert_eq!(point(6).subdivide(most), Err(TooLarge { what: "subdivision, counted in steps,", limit }));
    assert_eq!(point(6).subdivide(4).map(|pieces| pieces.len()), Ok(16));
}
