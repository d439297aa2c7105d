//! Tangent planes along edges, by construction: surfaces in changed parameters,
//! with the ratio that the change has.

use casteljau::{
    Curve, Directions, Interval, Piece, Polynomial, Quotient, Rational, Reading, Rectangle, Segment, Side, Surface, Symbol, Term, Triangle,
    Vanishing, geometric_join, geometric_join_of_ends, geometric_join_of_rational, tangent_plane_join,
};
use proptest::prelude::*;

fn small() -> impl Strategy<Value = Rational> {
    (-4i64..5, 1i64..4).prop_map(|(n, d)| Rational::new(n, d))
}

fn symbol(letter: char) -> Symbol {
    Symbol::new(letter, None)
}

fn number(value: &Rational) -> Polynomial {
    Polynomial::from(value.clone())
}

/// A polynomial in `x` by its coefficients.
fn in_x(coefficients: &[Rational]) -> Polynomial {
    Polynomial::from_coefficients(symbol('x'), &coefficients.iter().map(number).collect::<Vec<_>>())
}

fn terms(polynomial: &Polynomial) -> Vec<Term> {
    let rows = polynomial.coefficients_in(symbol('x'));
    let row = |(h, row): (usize, &Polynomial)| {
        let entries = row.coefficients_in(symbol('y')).into_iter().enumerate();
        entries.map(|(k, c)| (h, k, c.as_rational().expect("a number"))).collect::<Vec<_>>()
    };
    rows.iter().enumerate().flat_map(row).collect()
}

/// The graph of a polynomial: a surface that has tangent planes everywhere.
fn graph(height: &[(usize, usize, Rational)]) -> [Polynomial; 3] {
    let (x, y) = (Polynomial::from(symbol('x')), Polynomial::from(symbol('y')));
    let term = |(h, k, c): &(usize, usize, Rational)| (&x.pow(*h as u32) * &y.pow(*k as u32)).scale(c);
    let z = height.iter().map(term).fold(Polynomial::default(), |sum, term| sum + &term);
    [x, y, z]
}

/// The same surface where `x` and `y` become `x + y μ(x)` and `y λ(x)`.
fn changed(surface: &[Polynomial; 3], lambda: &Polynomial, mu: &Polynomial) -> [Polynomial; 3] {
    let (x, y) = (Polynomial::from(symbol('x')), Polynomial::from(symbol('y')));
    let change = [(symbol('x'), &x + &(&y * mu)), (symbol('y'), &y * lambda)];
    surface.each_ref().map(|coordinate| coordinate.substitute_all(&change))
}

fn interval(from: i64, to: i64) -> Interval {
    Interval::new(Rational::from(from), Rational::from(to)).expect("a frame")
}

/// Over `0..1` along the edge, on one side of it, as a rectangle; the edge is `v0`.
fn rectangle(coordinates: &[Polynomial], to: i64, turned: bool) -> Piece {
    let along = if turned { interval(1, 0) } else { interval(0, 1) };
    let surface = Surface::tensor(coordinates.iter().map(terms).collect()).expect("a surface");
    Piece::Rectangle(surface.over_rectangle(&Rectangle::new(along, interval(0, to))).expect("a patch"))
}

fn degree_across(piece: &Piece) -> Rational {
    match piece {
        Piece::Curve(segment) => Rational::from(segment.degree()),
        Piece::Triangle(patch) => Rational::from(patch.degree()),
        Piece::Rectangle(patch) => Rational::from(patch.degree().1),
    }
}

fn at(u: i64, v: i64) -> [Rational; 2] {
    [Rational::from(u), Rational::from(v)]
}

/// The value of a quotient.
fn value(quotient: &Quotient, x: &Rational) -> Rational {
    let horner = |list: &[Rational]| list.iter().rev().fold(Rational::from(0), |sum, c| sum * x + c);
    horner(&quotient.numerator) / horner(&quotient.denominator)
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 48, ..ProptestConfig::default() })]

    #[test]
    fn ratios_of_changed_parameters_are_found(height in prop::collection::vec((0usize..3, 0usize..3, small()), 0..5), lambda in [1i64..4, 0i64..3], mu in [small(), small()], turned: bool, weight in [1i64..4, 0i64..3, 0i64..3], rational: bool, at in 0i64..9) {
        let lambda = in_x(&lambda.map(Rational::from));
        let mu = in_x(&mu);
        let surface = graph(&height);
        let mut other = changed(&surface, &lambda, &mu).to_vec();
        let mut own = surface.to_vec();
        if rational {
            // Two weights that have nothing to do with each other.
            let [a, b, c] = weight.map(Rational::from);
            let (x, y) = (Polynomial::from(symbol('x')), Polynomial::from(symbol('y')));
            let first = &(&number(&a) + &x.scale(&b)) + &y.scale(&c);
            let second = &number(&Rational::from(2)) + &(&x * &y).scale(&b);
            own = own.iter().map(|p| p * &first).chain([first.clone()]).collect();
            other = other.iter().map(|p| p * &second).chain([second.clone()]).collect();
        }
        let (first, second) = (rectangle(&own, -1, false), rectangle(&other, 1, turned));
        let join = tangent_plane_join((&first, Side::V0), (&second, Side::V0), rational).expect("in space");
        prop_assert!(join.is_g1(), "{join:?}");
        prop_assert_eq!(join.reversed, turned);
        // Control points lie a degree closer together than derivatives say.
        let (m, n) = (degree_across(&first), degree_across(&second));
        let place = Rational::new(at, 8);
        let expected = |polynomial: &Polynomial| polynomial.substitute(symbol('x'), &number(&place)).as_rational().expect("a number");
        prop_assert_eq!(value(&join.ratio.clone().expect("a ratio"), &place), expected(&lambda) * m / &n);
        prop_assert_eq!(value(&join.shear.clone().expect("a shear"), &place), expected(&mu) / &n);
        let constant = lambda.degree_in(symbol('x')) == 0;
        prop_assert_eq!(join.ratio.expect("a ratio").constant().is_some(), constant);

        // The other way round the ratio is the reciprocal.
        let back = tangent_plane_join((&second, Side::V0), (&first, Side::V0), rational).expect("in space");
        let along = if turned { Rational::from(1) - &place } else { place.clone() };
        prop_assert_eq!(value(&back.ratio.expect("a ratio"), &along) * value(&join_ratio(&first, &second, rational), &place), Rational::from(1));
    }

    /// Folded over, and with a ratio that vanishes somewhere.
    #[test]
    fn folds_and_vanishing_normals_are_told_apart(height in prop::collection::vec((0usize..3, 0usize..3, small()), 0..5), mu in small(), root in 0i64..5) {
        let surface = graph(&height);
        let first = rectangle(&surface, -1, false);
        let ask = |lambda: &[i64]| {
            let lambda = in_x(&lambda.iter().map(|&n| Rational::from(n)).collect::<Vec<_>>());
            let second = rectangle(&changed(&surface, &lambda, &number(&mu)), 1, false);
            tangent_plane_join((&first, Side::V0), (&second, Side::V0), false).expect("in space")
        };
        let fold = ask(&[-2, -1]);
        prop_assert_eq!((fold.g1(), fold.coplanar, fold.opposite_sides), (Some(false), Some(true), Some(false)));
        // (4x - root)^2 vanishes at a quarter.
        let touching = ask(&[root * root, -8 * root, 16]);
        prop_assert_eq!((touching.g1(), touching.opposite_sides), (None, Some(true)));
        prop_assert!(touching.singular[0].is_nowhere());
        prop_assert_eq!(&touching.singular[1], &Vanishing::At(vec![casteljau::RootPlace::Exact(Rational::new(root, 4))]));
        // 4x - root changes its sign inside, so that one part is folded over.
        let crossing = ask(&[-root, 4]);
        prop_assert_eq!(crossing.g1(), if root == 0 { None } else { Some(false) });
        let flat = ask(&[0]);
        prop_assert_eq!(&flat.singular[1], &Vanishing::Everywhere);
        prop_assert_eq!(flat.g1(), None);
    }

    /// Triangles and rectangles of one surface, with their vertices in any order and of any degrees.
    #[test]
    fn patches_of_one_surface_join(height in prop::collection::vec((0usize..3, 0usize..2, small()), 0..5), kinds: [bool; 2], orders in [0usize..6, 0usize..6], raised in [0usize..3, 0usize..3], bend in small()) {
        let surface = graph(&height);
        let total = Surface::new(Reading::Total(3), surface.iter().map(terms).collect()).expect("a surface");
        let piece = |surface: &Surface, triangle: bool, order: usize, raised: usize, inner: i64| -> (Piece, Side) {
            let (s, t) = (at(0, 0), at(1, 0));
            if triangle {
                let all = [[Rational::from(2), Rational::from(inner)], s, t];
                let [a, b, c] = [[0, 1, 2], [0, 2, 1], [1, 0, 2], [1, 2, 0], [2, 0, 1], [2, 1, 0]][order];
                let frame = Triangle::new(all[a].clone(), all[b].clone(), all[c].clone()).expect("a frame");
                let side = [Side::St, Side::Tr, Side::Rs][[a, b, c].iter().position(|&k| k == 0).expect("one of them")];
                (Piece::Triangle(surface.over_triangle(&frame).expect("a patch").elevate(raised).expect("small")), side)
            } else {
                let along = if order.is_multiple_of(2) { interval(0, 1) } else { interval(1, 0) };
                let (across, side) = if order < 3 { (interval(0, inner), Side::V0) } else { (interval(inner, 0), Side::V1) };
                (Piece::Rectangle(surface.over_rectangle(&Rectangle::new(along, across)).expect("a patch").elevate(raised, raised).expect("small")), side)
            }
        };
        let (first, own) = piece(&total, kinds[0], orders[0], raised[0], -1);
        let (second, other) = piece(&total, kinds[1], orders[1], raised[1], 2);
        let join = tangent_plane_join((&first, own), (&second, other), false).expect("in space");
        prop_assert!(join.is_g1(), "{join:?}");
        prop_assert!(join.ratio.and_then(|ratio| ratio.constant()).is_some());
        let (folded, other) = piece(&total, kinds[1], orders[1], raised[1], -2);
        prop_assert_eq!(tangent_plane_join((&first, own), (&folded, other), false).expect("in space").opposite_sides, Some(false));
        // Bent away from the edge it is another plane.
        prop_assume!(bend != Rational::from(0));
        let mut bent = surface.clone();
        bent[2] += &Polynomial::from(symbol('y')).scale(&bend);
        let bent = Surface::new(Reading::Total(3), bent.iter().map(terms).collect()).expect("a surface");
        let (second, other) = piece(&bent, kinds[1], orders[1], raised[1], 2);
        let join = tangent_plane_join((&first, own), (&second, other), false).expect("in space");
        prop_assert_eq!((join.same_edge, join.coplanar, join.g1()), (true, Some(false), Some(false)));
    }

    /// A common factor of all homogeneous coordinates changes no shape parameter.
    #[test]
    fn weights_are_divided_out(f in prop::collection::vec(prop::collection::vec(small(), 4), 2), b1 in 1i64..4, factors in [[1i64..4, -3i64..4, -3i64..4], [1i64..4, -3i64..4, -3i64..4]]) {
        let curve = |lists: &[Vec<Rational>]| Curve::new(lists.to_vec()).expect("a curve");
        let times = |a: &[Rational], b: &[Rational]| -> Vec<Rational> {
            let mut product = vec![Rational::from(0); a.len() + b.len() - 1];
            a.iter().enumerate().for_each(|(i, x)| b.iter().enumerate().for_each(|(j, y)| product[i + j] += x * y));
            product
        };
        let g: Vec<Vec<Rational>> = f.iter().map(|list| list.iter().enumerate().map(|(k, c)| c * Rational::from(b1.pow(k as u32))).collect()).collect();
        let lifted = |lists: &[Vec<Rational>], factor: &[i64; 3]| {
            let weight = factor.map(Rational::from);
            curve(&lists.iter().map(|list| times(list, &weight)).chain([times(&[Rational::from(1)], &weight)]).collect::<Vec<_>>())
        };
        let zero = Rational::from(0);
        let plain = geometric_join(&curve(&f), &curve(&g), &zero, &zero).expect("one dimension");
        let weighted = geometric_join_of_rational(&lifted(&f, &factors[0]), &lifted(&g, &factors[1]), &zero, &zero).expect("finite");
        prop_assert_eq!(plain, weighted);
    }

    /// Two parts of one curve, put together again at their common end, in whatever directions they run.
    #[test]
    fn ends_of_one_curve(f in prop::collection::vec(prop::collection::vec(small(), 4), 2), turned: [bool; 2], length in 1i64..4) {
        let curve = Curve::new(f).expect("a curve");
        prop_assume!(curve.vector(1).iter().any(|x| *x != Rational::from(0)));
        let over = |from: i64, to: i64| curve.segment(&interval(from, to)).expect("a segment");
        let first = if turned[0] { (over(0, -1), Side::Start) } else { (over(-1, 0), Side::End) };
        let second = if turned[1] { (over(length, 0), Side::End) } else { (over(0, length), Side::Start) };
        let join = geometric_join_of_ends((&first.0, first.1), (&second.0, second.1), false).expect("one dimension");
        prop_assert_eq!((join.order, join.betas), (Some(3), vec![Rational::from(length), Rational::from(0), Rational::from(0)]));
        let back = geometric_join_of_ends((&second.0, second.1), (&second.0, second.1), false).expect("one dimension");
        prop_assert!(back.reversed);
    }
}

fn join_ratio(first: &Piece, second: &Piece, rational: bool) -> Quotient {
    tangent_plane_join((first, Side::V0), (second, Side::V0), rational).expect("in space").ratio.expect("a ratio")
}

#[test]
fn singular_ends_are_told_apart() {
    let q = Rational::from;
    let curve =
        |points: &[[i64; 2]]| Segment::from_points(points.iter().map(|p| p.map(q).to_vec()).collect(), interval(0, 1)).expect("a segment");
    // The last two points are the same: the first derivative vanishes at the end.
    let stop = curve(&[[0, 0], [2, 1], [3, 0], [3, 0]]);
    let ask =
        |second: &[[i64; 2]]| geometric_join_of_ends((&stop, Side::End), (&curve(second), Side::Start), false).expect("one dimension");
    for (second, orders, directions) in [
        (&[[3, 0], [3, 0], [4, 0], [5, 5]][..], [Some(2), Some(2)], Some(Directions::Different)),
        (&[[3, 0], [3, 0], [4, -1], [5, 5]][..], [Some(2), Some(2)], Some(Directions::Same)),
        (&[[3, 0], [2, 1], [5, 5]][..], [Some(2), Some(1)], Some(Directions::Opposite)),
        (&[[3, 0], [4, -1]][..], [Some(2), Some(1)], Some(Directions::Same)),
        (&[[3, 0], [3, 0], [3, 0], [4, -1]][..], [Some(2), Some(3)], Some(Directions::Same)),
        (&[[3, 0], [3, 0]][..], [Some(2), None], None),
    ] {
        let join = ask(second);
        let singular = join.singular.expect("a derivative vanishes");
        assert_eq!((singular.orders, singular.directions), (orders, directions), "{second:?}");
        assert_eq!((join.order, join.regular), (Some(0), false));
    }
    assert_eq!(ask(&[[9, 9], [9, 9]]).singular, None);
}
