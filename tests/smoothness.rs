//! The prepared test of joins against the order that divisibility gives.

use casteljau::{
    Continuity, Curve, Equation, Error, Interval, Joint, Piece, Rational, Rectangle, Segment, SmoothnessTest, Surface, Term, Triangle,
    continuity_of_curves, continuity_of_surfaces,
};
use proptest::prelude::*;

fn small() -> impl Strategy<Value = Rational> {
    prop_oneof![3 => (-4i64..5, 1i64..4).prop_map(|(n, d)| Rational::new(n, d)), 1 => any::<i32>().prop_map(|n| Rational::new(i64::from(n), 1000))]
}

/// Factors that bring the sums below and above each width of integers.
fn scale() -> impl Strategy<Value = Rational> {
    prop_oneof![
        Just(Rational::from(1)),
        (20u32..50).prop_map(|bits| Rational::from(1i64 << bits)),
        Just(Rational::from(3).pow(50)),
        Just(Rational::new(1, 1_000_003)),
    ]
}

/// The order up to `asked` that divisibility of the difference gives.
fn slow(first: &Piece, second: &Piece, joint: &Joint, asked: usize) -> Option<usize> {
    let found = match (first.equation().expect("numbers"), second.equation().expect("numbers"), joint) {
        (Equation::Curve(a), Equation::Curve(b), Joint::Parameter(at)) => continuity_of_curves(&a, &b, at),
        (Equation::Surface(a), Equation::Surface(b), Joint::Edge(edge)) => continuity_of_surfaces(&a, &b, edge),
        _ => unreachable!("curves join at parameters"),
    };
    match found.expect("one dimension") {
        Continuity::Broken => None,
        Continuity::C(order) => Some(order.min(asked)),
        Continuity::Same => Some(asked),
    }
}

/// The coordinates of both over a common denominator, if they are integers of a word.
fn words(first: &Piece, second: &Piece) -> Option<[Vec<i64>; 2]> {
    let all = || first.coordinates().iter().chain(second.coordinates());
    let common = all().try_fold(1i64, |common, x| {
        let denominator = i64::try_from(x.denom()).ok()?;
        (1..=64).map(|k| common.checked_mul(k)).find(|multiple| multiple.is_none_or(|multiple| multiple % denominator == 0)).flatten()
    })?;
    let integer = |x: &Rational| i64::try_from((x * Rational::from(common)).numer()).ok();
    let integers = |piece: &Piece| piece.coordinates().iter().map(integer).collect::<Option<Vec<i64>>>();
    Some([integers(first)?, integers(second)?])
}

fn check(first: &Piece, second: &Piece, joint: &Joint, asked: usize) -> Result<(), TestCaseError> {
    let expected = slow(first, second, joint, asked);
    let test = SmoothnessTest::new(first, second, joint, asked).expect("they join there");
    prop_assert_eq!(test.order_of_rationals(first.coordinates(), second.coordinates()).expect("they fit"), expected);
    if let Some([a, b]) = words(first, second) {
        prop_assert_eq!(test.order(&a, &b).expect("they fit"), expected);
    }
    // The other way round there are other conditions for the same order.
    let back = SmoothnessTest::new(second, first, joint, asked).expect("they join there");
    prop_assert_eq!(back.order_of_rationals(second.coordinates(), first.coordinates()).expect("they fit"), expected);
    Ok(())
}

/// `l^power` as terms, for the linear form `l` that vanishes on a line.
fn line_power([from, to]: &[[Rational; 2]; 2], power: usize, factor: &Rational) -> Vec<Term> {
    let (a, b) = (&to[1] - &from[1], &from[0] - &to[0]);
    let c = -(&a * &from[0] + &b * &from[1]);
    let mut terms: Vec<Term> = vec![(0, 0, factor.clone())];
    for _ in 0..power {
        terms = terms.iter().flat_map(|(h, k, x)| [(h + 1, *k, x * &a), (*h, k + 1, x * &b), (*h, *k, x * &c)]).collect();
    }
    terms
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 200, ..ProptestConfig::default() })]

    #[test]
    fn curves(lists in prop::collection::vec(prop::collection::vec(small(), 1..5), 1..6), [r, s, q] in [small(), small(), small()], power in 0usize..5, factor in small(), scale in scale(), raised in 0usize..3, turned: [bool; 2], asked in 0usize..5) {
        prop_assume!(r != s && s != q);
        let dimension = lists.len();
        let mut changed = lists.clone();
        let mut difference = vec![&factor * &scale];
        for _ in 0..power {
            difference = (0..=difference.len()).map(|k| k.checked_sub(1).map_or(Rational::from(0), |k| difference[k].clone()) - difference.get(k).map_or(Rational::from(0), |x| x * &s)).collect();
        }
        let last = &mut changed[dimension - 1];
        last.resize(last.len().max(difference.len()), Rational::from(0));
        last.iter_mut().zip(&difference).for_each(|(x, d)| *x += d);
        let over = |lists: &[Vec<Rational>], [a, b]: [&Rational; 2], turned: bool| -> Segment {
            let (a, b) = if turned { (b, a) } else { (a, b) };
            Curve::new(lists.to_vec()).and_then(|curve| curve.segment(&Interval::new(a.clone(), b.clone())?)).expect("a segment")
        };
        let first = Piece::Curve(over(&lists, [&r, &s], turned[0]));
        let second = Piece::Curve(over(&changed, [&s, &q], turned[1]).elevate(raised).expect("small"));
        check(&first, &second, &Joint::Parameter(s), asked)?;
    }

    #[test]
    fn patches(terms in prop::collection::vec((0usize..3, 0usize..3, small()), 0..5), vertices in prop::array::uniform4([small(), small()]), power in 0usize..4, factor in small(), scale in scale(), raised in 0usize..3, orders in [0usize..6, 0usize..6], asked in 0usize..4, space in 1usize..4) {
        let [p, s, t, q] = vertices;
        let joint = [s.clone(), t.clone()];
        let triangle = |inner: &[Rational; 2], order: usize| {
            let all = [inner, &s, &t];
            let [a, b, c] = [[0, 1, 2], [0, 2, 1], [1, 0, 2], [1, 2, 0], [2, 0, 1], [2, 1, 0]][order].map(|k: usize| all[k].clone());
            Triangle::new(a, b, c)
        };
        let (Ok(own), Ok(other)) = (triangle(&p, orders[0]), triangle(&q, orders[1])) else { return Ok(()) };
        let mut changed = terms.clone();
        changed.extend(line_power(&joint, power, &(&factor * &scale)));
        let surface = |terms: &[Term]| {
            let plane = [vec![(1, 0, Rational::from(2))], vec![(0, 1, Rational::new(1, 3))]];
            Surface::total(plane.into_iter().cycle().take(space - 1).chain([terms.to_vec()]).collect()).expect("a surface")
        };
        let (a, b) = (surface(&terms), surface(&changed));
        let first = Piece::Triangle(a.over_triangle(&own).expect("a patch"));
        let second = Piece::Triangle(b.over_triangle(&other).expect("a patch").elevate(raised).expect("small"));
        check(&first, &second, &Joint::Edge(joint), asked)?;

        // Rectangles along a line of one parameter, and a rectangle with a triangle.
        let (low, high) = (Rational::new(-1, 2), Rational::from(2));
        let at = &s[0];
        prop_assume!(p[0] != *at && q[0] != *at);
        let joint = [[at.clone(), low.clone()], [at.clone(), high.clone()]];
        let mut changed = terms.clone();
        changed.extend(line_power(&joint, power, &(&factor * &scale)));
        let b = surface(&changed);
        let along = |turned: bool| if turned { Interval::new(high.clone(), low.clone()) } else { Interval::new(low.clone(), high.clone()) }.expect("a frame");
        let across = |end: &Rational, turned: bool| if turned { Interval::new(end.clone(), at.clone()) } else { Interval::new(at.clone(), end.clone()) }.expect("a frame");
        let first = a.over_rectangle(&Rectangle::new(across(&p[0], orders[0] < 3), along(orders[0] % 2 == 0))).expect("a patch");
        let second = b.over_rectangle(&Rectangle::new(across(&q[0], orders[1] < 3), along(orders[1] % 2 == 0))).expect("a patch");
        let joint = Joint::Edge(joint);
        check(&Piece::Rectangle(first.clone()), &Piece::Rectangle(second.elevate(raised, 0).expect("small")), &joint, asked)?;
        let Joint::Edge([from, to]) = &joint else { unreachable!() };
        let beyond = Triangle::new(from.clone(), [q[0].clone(), q[1].clone()], to.clone()).expect("a frame");
        check(&Piece::Rectangle(first), &Piece::Triangle(b.over_triangle(&beyond).expect("a patch")), &joint, asked)?;
    }
}

/// A difference that is a multiple of 2^64 is none in one word: the bound must ask for two.
#[test]
fn sums_that_would_wrap_to_zero_are_seen() {
    let q = Rational::from;
    let short = Rational::new(1, 1 << 32);
    let curve = |from: Rational, to: Rational| {
        Piece::Curve(Segment::new(1, vec![q(0), q(0)], Interval::new(from, to).expect("a frame")).expect("a segment"))
    };
    let (first, second) = (curve(q(0), q(1)), curve(q(1), q(1) + short));
    let test = SmoothnessTest::new(&first, &second, &Joint::Parameter(q(1)), 1).expect("they join");
    // 2^32 b1 = (2^32 + 1) a1 - a0
    assert_eq!(test.order(&[-(1 << 32), 0], &[0, 1]), Ok(Some(1)));
    assert_eq!(test.order(&[-(1 << 32), 0], &[0, 1 + (1 << 32)]), Ok(Some(0)));
    assert_eq!(test.order(&[0, 0], &[0, 1 << 32]), Ok(Some(0)));
}

#[test]
fn what_does_not_fit_is_refused() {
    let q = Rational::from;
    let curve = |from: i64, to: i64, points: &[i64]| {
        Piece::Curve(
            Segment::new(1, points.iter().map(|&n| q(n)).collect(), Interval::new(q(from), q(to)).expect("a frame")).expect("a segment"),
        )
    };
    let (first, second) = (curve(0, 1, &[0, 1]), curve(1, 2, &[1, 2]));
    assert!(SmoothnessTest::new(&first, &second, &Joint::Parameter(q(2)), 1).is_err());
    assert!(SmoothnessTest::new(&first, &second, &Joint::Edge([[q(0), q(0)], [q(0), q(1)]]), 1).is_err());
    let test = SmoothnessTest::new(&first, &second, &Joint::Parameter(q(1)), 9).expect("they join");
    assert_eq!(test.order(&[0, 1], &[1, 2]), Ok(Some(9)));
    assert_eq!(test.order(&[i64::MIN, i64::MAX], &[i64::MAX, i64::MIN]), Ok(Some(0)));
    assert!(matches!(test.order(&[0, 1, 2], &[1, 2, 3]), Err(Error::WrongCount { .. })));
    assert!(matches!(test.order(&[0, 1], &[1, 2, 3, 4]), Err(Error::WrongCount { .. })));
    assert!(test.order(&[], &[]).is_err());
    let long = curve(1, 2, &[0; SmoothnessTest::MAX_POINTS + 1]);
    assert!(matches!(SmoothnessTest::new(&first, &long, &Joint::Parameter(q(1)), 1), Err(Error::TooLarge { .. })));
}
