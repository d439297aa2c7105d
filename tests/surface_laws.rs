//! The laws of blossoming for surfaces, on generated input compared with `==`.
//!
//! Frames in both orientations, points inside, on edges, on vertices and
//! outside, degrees from 0 on, bidegrees with a zero; the last test counts that
//! the generators reach them.

#[allow(dead_code)] // Other tests use the rest of it.
mod oracle;

use casteljau::{
    AffineMap, Axis, Bernstein, Interval, Mesh, Parameter, Piece, Place, PlaneParameter, Polynomial, Rational, Reading, Rectangle,
    RectangularPatch, Surface, Symbol, Symmetry, Triangle, TriangularPatch, bernstein_matrix, check_polar_form, homogeneous_points,
    projected,
};
use oracle::Terms;
use proptest::prelude::*;
use proptest::strategy::ValueTree;
use proptest::test_runner::TestRunner;

fn number() -> impl Strategy<Value = Rational> {
    prop_oneof![
        4 => Just(Rational::from(0)),
        12 => (-9i64..10, 1i64..7).prop_map(|(n, d)| Rational::new(n, d)),
        2 => (any::<i64>(), 1i64..1_000_000_007).prop_map(|(n, d)| Rational::new(n, d)),
        1 => (any::<i64>(), any::<i64>(), 1i64..i64::MAX).prop_map(|(a, b, d)| Rational::from(a) * Rational::new(b, d)),
    ]
}

fn small() -> impl Strategy<Value = Rational> {
    (-6i64..7, 1i64..5).prop_map(|(n, d)| Rational::new(n, d))
}

fn place() -> impl Strategy<Value = [Rational; 2]> {
    [small(), small()]
}

fn triangle() -> impl Strategy<Value = Triangle> {
    (place(), place(), place()).prop_filter_map("not on one line", |(r, s, t)| Triangle::new(r, s, t).ok())
}

fn interval() -> impl Strategy<Value = Interval> {
    (small(), small()).prop_filter_map("different ends", |(r, s)| Interval::new(r, s).ok())
}

fn rectangle() -> impl Strategy<Value = Rectangle> {
    (interval(), interval()).prop_map(|(u, v)| Rectangle::new(u, v))
}

/// A point of the parameter plane that is often on an edge or a vertex.
fn point_of(frame: &Triangle) -> impl Strategy<Value = [Rational; 2]> + use<> {
    let frame = frame.clone();
    prop_oneof![
        3 => (0i64..4, 0i64..4, 0i64..4).prop_filter_map("weights", move |(a, b, c)| {
            let sum = a + b + c;
            (sum > 0).then(|| frame.at(&[a, b, c].map(|part| Rational::new(part, sum))))
        }),
        2 => place(),
    ]
}

fn terms(max: usize) -> impl Strategy<Value = Terms> {
    let term = (0..=max, 0..=max, number()).prop_map(move |(h, k, c)| (h, k.min(max - h), c));
    prop::collection::vec(prop::collection::vec(term, 0..6), 1..4).prop_map(without_zeros)
}

/// A zero term says nothing of the degree, and is no term to the oracle.
fn without_zeros(mut terms: Terms) -> Terms {
    terms.iter_mut().for_each(|list| list.retain(|(_, _, c)| *c != Rational::from(0)));
    terms
}

fn total(max: usize) -> impl Strategy<Value = (Terms, Surface)> {
    (terms(max), 0usize..2).prop_filter_map("a surface", |(terms, more)| {
        let degree = Surface::total(terms.clone()).ok()?.true_total_degree() + more;
        Some((terms.clone(), Surface::new(Reading::Total(degree), terms).ok()?))
    })
}

fn tensor(max: usize) -> impl Strategy<Value = (Terms, Surface)> {
    let term = (0..=max, 0..=max, number());
    (prop::collection::vec(prop::collection::vec(term, 0..6), 1..4), any::<[bool; 4]>()).prop_filter_map(
        "a surface",
        |(mut terms, [no_u, no_v, more_u, more_v])| {
            // Often of degree 0 in one of the variables.
            terms.iter_mut().flatten().for_each(|(h, k, _)| {
                *h *= usize::from(!(no_u && no_v));
                *k *= usize::from(!no_u || no_v);
            });
            let terms = without_zeros(terms);
            let (p, q) = Surface::tensor(terms.clone()).ok()?.true_bidegree();
            let reading = Reading::Bidegree(p + usize::from(more_u), q + usize::from(more_v));
            Some((terms.clone(), Surface::new(reading, terms).ok()?))
        },
    )
}

fn bidegree(surface: &Surface) -> (usize, usize) {
    match surface.reading() {
        Reading::Bidegree(p, q) => (p, q),
        other => panic!("{other:?} is no bidegree"),
    }
}

fn degree(surface: &Surface) -> usize {
    match surface.reading() {
        Reading::Total(m) => m,
        other => panic!("{other:?} is no total degree"),
    }
}

fn triangular_patch(max: usize) -> impl Strategy<Value = TriangularPatch> {
    (1usize..4, 0..=max, triangle()).prop_flat_map(|(dimension, degree, frame)| {
        prop::collection::vec(prop::collection::vec(number(), dimension), (degree + 1) * (degree + 2) / 2)
            .prop_filter_map("a patch", move |points| TriangularPatch::from_points(points, frame.clone()).ok())
    })
}

fn rectangular_patch(max: usize) -> impl Strategy<Value = RectangularPatch> {
    (1usize..4, 0..=max, 0..=max, rectangle()).prop_flat_map(|(dimension, p, q, frame)| {
        prop::collection::vec(prop::collection::vec(number(), dimension), (p + 1) * (q + 1))
            .prop_filter_map("a patch", move |points| RectangularPatch::from_points((p, q), points, frame.clone()).ok())
    })
}

fn lists<'a>(points: impl Iterator<Item = &'a [Rational]>) -> Vec<Vec<Rational>> {
    points.map(<[Rational]>::to_vec).collect()
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 96, ..ProptestConfig::default() })]

    #[test]
    fn total_degree_polar_forms_are_the_polarization_identity((terms, surface) in total(4), seed in prop::collection::vec(([small(), small()], 0i64..3), 6)) {
        let m = degree(&surface);
        let arguments: Vec<[Rational; 3]> = seed[..m].iter().map(|([u, v], w)| [u.clone(), v.clone(), Rational::from(*w)]).collect();
        let homogeneous: Vec<PlaneParameter> = arguments.iter().map(|[u, v, w]| PlaneParameter::homogeneous(w.clone(), u.clone(), v.clone())).collect();
        let expected = oracle::total_polarization(&terms, &arguments);
        prop_assert_eq!(&surface.blossom(&homogeneous).expect("m arguments"), &expected);
        // The same through a net over a frame of its own.
        let patch = surface.over_triangle(&Triangle::standard()).expect("a patch");
        prop_assert_eq!(patch.blossom(&homogeneous).expect("m arguments"), expected);
    }

    #[test]
    fn bidegree_polar_forms_are_the_polarization_identity((terms, surface) in tensor(3), seed in prop::collection::vec((small(), prop_oneof![Just(Rational::from(1)), Just(Rational::from(0)), small()]), 8), frame in rectangle()) {
        let (p, q) = bidegree(&surface);
        let (us, vs) = (&seed[..p], &seed[4..4 + q]);
        let lift = |list: &[(Rational, Rational)]| list.iter().map(|(t, w)| Parameter::homogeneous(w.clone(), t.clone())).collect::<Vec<_>>();
        let expected = oracle::tensor_polarization(&terms, us, vs);
        prop_assert_eq!(&surface.blossom_bidegree(&lift(us), &lift(vs)).expect("p and q arguments"), &expected);
        let patch = surface.over_rectangle(&frame).expect("a patch");
        prop_assert_eq!(patch.blossom(&lift(us), &lift(vs)).expect("p and q arguments"), expected);
    }

    #[test]
    fn polar_forms_pass_the_check_in_both_readings((_, surface) in total(3), wrong in small()) {
        let variables = [Symbol::new('u', None), Symbol::new('v', None)];
        for surface in [surface.clone(), surface.by_bidegree().expect("small")] {
            let polar = surface.polar();
            let map: Vec<Polynomial> = (0..surface.dimension()).map(|index| {
                let term = |(h, k, c): (usize, usize, &Rational)| (casteljau::Monomial::from_factors([(variables[0], h as u32), (variables[1], k as u32)]), c.clone());
                Polynomial::from_terms(surface.terms(index).into_iter().map(term))
            }).collect();
            let mut claim: Vec<Polynomial> = (0..surface.dimension()).map(|index| polar.expand(index, 100_000).expect("few terms")).collect();
            prop_assert_eq!(check_polar_form(surface.reading(), &map, &variables, &claim).expect("as many coordinates"), []);
            if let Some(symbol) = surface.reading().symbols().next().filter(|_| wrong != Rational::from(0)) {
                claim[0] += &Polynomial::from(symbol).scale(&wrong);
                prop_assert!(!check_polar_form(surface.reading(), &map, &variables, &claim).expect("as many coordinates").is_empty());
            }
        }
    }

    #[test]
    fn triangular_nets_are_polar_values_and_round_trip((terms, surface) in total(4), frame in triangle(), at in place()) {
        let patch = surface.over_triangle(&frame).expect("a patch");
        let one = Rational::from(1);
        for [i, j, k] in TriangularPatch::<Rational>::indices(patch.degree()) {
            let vertices = [(frame.r(), i), (frame.s(), j), (frame.t(), k)];
            let arguments: Vec<[Rational; 3]> = vertices.iter().flat_map(|(vertex, times)| std::iter::repeat_n([vertex[0].clone(), vertex[1].clone(), one.clone()], *times)).collect();
            prop_assert_eq!(patch.point(i, j), oracle::total_polarization(&terms, &arguments));
        }
        prop_assert_eq!(&patch.surface().expect("a surface"), &surface);
        let expected = oracle::surface_value(&terms, &at[0], &at[1]);
        prop_assert_eq!(&surface.value(&at), &expected);
        prop_assert_eq!(&patch.value(&at).expect("a value"), &expected);
        let barycentric = frame.barycentric(&at).expect("numbers");
        prop_assert_eq!(frame.at(&barycentric), at.clone());
        prop_assert_eq!(oracle::triangular_value(patch.degree(), &lists(patch.points()), &barycentric), expected.clone());
        let basis = Bernstein::triangle(patch.degree(), frame.clone()).values(&at).expect("two parameters");
        let combined: Vec<Rational> = (0..patch.dimension()).map(|c| patch.points().zip(&basis).map(|(point, b)| &point[c] * b).sum()).collect();
        prop_assert_eq!(combined, expected);
        prop_assert_eq!(basis.into_iter().sum::<Rational>(), one);
    }

    #[test]
    fn rectangular_nets_round_trip_and_every_route_gives_the_point((terms, surface) in tensor(3), frame in rectangle(), [u, v] in place()) {
        let patch = surface.over_rectangle(&frame).expect("a patch");
        prop_assert_eq!(&patch.surface().expect("a surface"), &surface);
        let expected = oracle::surface_value(&terms, &u, &v);
        prop_assert_eq!(&surface.value(&[u.clone(), v.clone()]), &expected);
        prop_assert_eq!(&patch.value(&[u.clone(), v.clone()]).expect("a value"), &expected);
        for first in [Axis::U, Axis::V] {
            let steps = patch.two_steps(&[u.clone(), v.clone()], first).expect("numbers");
            prop_assert_eq!(steps.point(), &expected);
        }
        let common = patch.common_steps(&[u.clone(), v.clone()]).expect("numbers");
        prop_assert_eq!(common.point(), &expected);
        let basis = Bernstein::rectangle(patch.degree(), frame.clone()).values(&[u.clone(), v.clone()]).expect("two parameters");
        let combined: Vec<Rational> = (0..patch.dimension()).map(|c| patch.points().zip(&basis).map(|(point, b)| &point[c] * b).sum()).collect();
        prop_assert_eq!(combined, expected.clone());
        prop_assert_eq!(patch.iso(Axis::U, &u).expect("numbers").value(&v).expect("numbers"), expected.clone());
        prop_assert_eq!(patch.iso(Axis::V, &v).expect("numbers").value(&u).expect("numbers"), expected);
    }

    #[test]
    fn every_layer_of_the_tetrahedron_is_its_label(patch in triangular_patch(4), at in place()) {
        let scheme = patch.scheme(&at).expect("numbers");
        let m = patch.degree();
        let frame = patch.frame();
        for l in 0..=m {
            for (i, j) in scheme.indices(l) {
                let repeated = [(&at, l), (frame.r(), i), (frame.s(), j), (frame.t(), m - l - i - j)];
                let arguments: Vec<PlaneParameter> = repeated.iter().flat_map(|(point, times)| std::iter::repeat_n(PlaneParameter::point((*point).clone()), *times)).collect();
                prop_assert_eq!(scheme.get(l, i, j), patch.blossom(&arguments).expect("m arguments"));
            }
        }
    }

    #[test]
    fn steps_on_rectangles_are_their_labels(patch in rectangular_patch(3), [u, v] in place()) {
        let (p, q) = patch.degree();
        let (ru, su, rv, sv) = (patch.frame().u().r(), patch.frame().u().s(), patch.frame().v().r(), patch.frame().v().s());
        let list = |parts: [(&Rational, usize); 3]| parts.iter().flat_map(|(t, times)| std::iter::repeat_n(Parameter::from((*t).clone()), *times)).collect::<Vec<_>>();
        let common = patch.common_steps(&[u.clone(), v.clone()]).expect("numbers");
        for net in common.nets() {
            let (left, below) = net.degree();
            for i in 0..=left {
                for j in 0..=below {
                    let us = list([(ru, left - i), (su, i), (&u, p - left)]);
                    let vs = list([(rv, below - j), (sv, j), (&v, q - below)]);
                    prop_assert_eq!(net.point(i, j), patch.blossom(&us, &vs).expect("p and q arguments"));
                }
            }
        }
        let two = patch.two_steps(&[u.clone(), v.clone()], Axis::V).expect("numbers");
        for (l, net) in two.nets().iter().enumerate() {
            for i in 0..=p {
                for j in 0..=q - l {
                    let (us, vs) = (list([(ru, p - i), (su, i), (&u, 0)]), list([(rv, q - l - j), (sv, j), (&v, l)]));
                    prop_assert_eq!(net.point(i, j), patch.blossom(&us, &vs).expect("p and q arguments"));
                }
            }
        }
        for (l, layer) in two.layers().iter().enumerate() {
            for (k, point) in layer.iter().enumerate() {
                let (us, vs) = (list([(ru, p - l - k), (su, k), (&u, l)]), list([(rv, 0), (sv, 0), (&v, q)]));
                prop_assert_eq!(point, &patch.blossom(&us, &vs).expect("p and q arguments"));
            }
        }
    }

    #[test]
    fn parts_of_a_triangle_are_the_same_map((patch, at) in triangular_patch(4).prop_flat_map(|patch| { let at = point_of(patch.frame()); (Just(patch), at) })) {
        let parts = patch.split(&at).expect("numbers");
        let surface = patch.surface().expect("numbers");
        let barycentric = patch.frame().barycentric(&at).expect("numbers");
        for (part, coordinate) in [&parts.ast, &parts.rat, &parts.rsa].into_iter().zip(&barycentric) {
            prop_assert_eq!(part.is_none(), *coordinate == Rational::from(0));
            if let Some(part) = part {
                prop_assert!(part.surface().expect("numbers").same_map(&surface));
                prop_assert_eq!(part, &patch.reframe(part.frame()).expect("numbers"));
            }
        }
        prop_assert_eq!(parts.point, surface.value(&at));
        let four = patch.quadrisect().expect("numbers");
        for part in [four.abt, four.bac, four.crb, four.sca] {
            prop_assert_eq!(&part, &patch.reframe(part.frame()).expect("numbers"));
            // All four are turned over, and a quarter as large.
            prop_assert_eq!(part.frame().determinant() * Rational::from(-4), patch.frame().determinant());
        }
        let turned = patch.permuted([2, 0, 1]);
        prop_assert_eq!(&turned, &patch.reframe(turned.frame()).expect("numbers"));
    }

    #[test]
    fn parts_of_a_rectangle_are_the_same_map(patch in rectangular_patch(3), at in place(), on_edge: bool) {
        let u = if on_edge { patch.frame().u().r().clone() } else { at[0].clone() };
        let parts = patch.split(&[u.clone(), at[1].clone()]).expect("numbers");
        let surface = patch.surface().expect("numbers");
        for part in [&parts.ll, &parts.rl, &parts.lr, &parts.rr].into_iter().flatten() {
            prop_assert_eq!(part, &patch.reframe(part.frame()).expect("numbers"));
            prop_assert!(part.surface().expect("numbers").same_map(&surface));
        }
        prop_assert!(!on_edge || (parts.ll.is_none() && parts.lr.is_none()));
        prop_assert_eq!(parts.point, surface.value(&[u, at[1].clone()]));
        for piece in patch.subdivide(1).expect("small") {
            prop_assert_eq!(&piece, &patch.reframe(piece.frame()).expect("numbers"));
        }
    }

    #[test]
    fn segments_lie_on_the_surface((terms, surface) in total(4), (tensor_terms, tensor) in tensor(3), a in place(), b in place(), part in small()) {
        let at = [0, 1].map(|axis| &a[axis] + (&b[axis] - &a[axis]) * &part);
        let curve = surface.segment(&a, &b).expect("numbers");
        prop_assert_eq!(curve.degree(), degree(&surface));
        prop_assert_eq!(curve.value(&part).expect("numbers"), oracle::surface_value(&terms, &at[0], &at[1]));
        let curve = tensor.segment(&a, &b).expect("numbers");
        prop_assert_eq!(lists(curve.points()), oracle::rectangle_segment(&tensor_terms, bidegree(&tensor), &a, &b));
    }

    #[test]
    fn degrees_rise_and_fall(patch in triangular_patch(3), rectangle in rectangular_patch(3), by in 0usize..3) {
        let raised = patch.elevate(by).expect("small");
        prop_assert!(raised.same_map(&patch).expect("numbers"));
        let reduced = raised.reduce().expect("numbers");
        prop_assert_eq!(reduced.true_degree, patch.surface().expect("numbers").true_total_degree());
        prop_assert_eq!(&reduced.patch.elevate(raised.degree() - reduced.true_degree).expect("small"), &raised);
        let raised = rectangle.elevate(by, 2 - by).expect("small");
        prop_assert!(raised.same_map(&rectangle).expect("numbers"));
        let reduced = raised.reduce().expect("numbers");
        prop_assert_eq!(reduced.true_degree, rectangle.surface().expect("numbers").true_bidegree());
        prop_assert!(reduced.total_degree <= reduced.true_degree.0 + reduced.true_degree.1);
        prop_assert!(reduced.patch.same_map(&raised).expect("numbers"));
        prop_assert_eq!(reduced.zero, rectangle.coordinates().iter().all(|x| *x == Rational::from(0)));
    }

    #[test]
    fn derivatives_are_limits_of_differences((_, surface) in total(4), direction in place(), at in place(), frame in triangle()) {
        // F(x + h d) as a polynomial in h has the derivative as its second coefficient: interpolate exactly.
        let m = degree(&surface);
        let curve = surface.segment(&at, &[&at[0] + &direction[0], &at[1] + &direction[1]]).expect("numbers").curve().expect("numbers");
        let expected = if m == 0 { vec![Rational::from(0); surface.dimension()] } else { curve.vector(1).to_vec() };
        prop_assert_eq!(&surface.derivative(&direction, 1).value(&at), &expected);
        prop_assert_eq!(&surface.by_bidegree().expect("small").derivative(&direction, 1).value(&at), &expected);
        let patch = surface.over_triangle(&frame).expect("a patch").derivative(&direction).expect("numbers");
        prop_assert_eq!(&patch.value(&at).expect("numbers"), &expected);
        let rectangle = surface.over_rectangle(&Rectangle::unit()).expect("a patch");
        let [in_u, in_v] = [Axis::U, Axis::V].map(|axis| rectangle.partial(axis).expect("numbers").value(&at).expect("numbers"));
        let combined: Vec<Rational> = in_u.iter().zip(&in_v).map(|(a, b)| a * &direction[0] + b * &direction[1]).collect();
        prop_assert_eq!(combined, expected);
    }

    #[test]
    fn partial_derivatives_are_those_of_the_terms((terms, surface) in total(4), (tensor_terms, tensor) in tensor(3), orders in [0usize..6, 0usize..6], direction in place()) {
        let [in_u, in_v] = orders;
        let falling = |from: usize, by: usize| (0..by).map(|k| Rational::from(from - k)).product::<Rational>();
        let derived = |terms: &Terms| -> Terms {
            let coordinate = |list: &Vec<(usize, usize, Rational)>| {
                let kept = list.iter().filter(|(h, k, _)| *h >= in_u && *k >= in_v);
                kept.map(|(h, k, c)| (h - in_u, k - in_v, c * falling(*h, in_u) * falling(*k, in_v))).collect()
            };
            terms.iter().map(coordinate).collect()
        };
        let reading = Reading::Total(degree(&surface).saturating_sub(in_u + in_v));
        prop_assert_eq!(surface.partial(in_u, in_v), Surface::new(reading, derived(&terms)).expect("lower degrees"));
        let (p, q) = bidegree(&tensor);
        let reading = Reading::Bidegree(p.saturating_sub(in_u), q.saturating_sub(in_v));
        prop_assert_eq!(tensor.partial(in_u, in_v), Surface::new(reading, derived(&tensor_terms)).expect("lower degrees"));
        // Derivatives of derivatives, and beyond every degree.
        for surface in [surface, tensor] {
            let once = (0..in_u).fold(surface.clone(), |surface, _| surface.derivative(&direction, 1));
            prop_assert_eq!(&surface.derivative(&direction, in_u), &once);
            prop_assert!(surface.derivative(&direction, usize::MAX).is_zero());
        }
    }

    #[test]
    fn products_multiply_values(frame in triangle(), (_, a) in total(2), (_, b) in total(2), at in place()) {
        prop_assume!(a.dimension() == b.dimension() || a.dimension() == 1 || b.dimension() == 1);
        let values = |a: &[Rational], b: &[Rational]| -> Vec<Rational> { (0..a.len().max(b.len())).map(|c| &a[c % a.len()] * &b[c % b.len()]).collect() };
        let product = a.over_triangle(&frame).expect("a patch").product(&b.over_triangle(&frame).expect("a patch")).expect("one frame");
        let expected = values(&a.value(&at), &b.value(&at));
        prop_assert_eq!(product.degree(), degree(&a) + degree(&b));
        prop_assert_eq!(&product.value(&at).expect("numbers"), &expected);
        let square = Rectangle::unit();
        let product = a.over_rectangle(&square).expect("a patch").product(&b.over_rectangle(&square).expect("a patch")).expect("one frame");
        prop_assert_eq!(product.value(&at).expect("numbers"), expected);
    }

    #[test]
    fn readings_are_the_same_map((_, surface) in tensor(3), frame in triangle(), rectangle in rectangle()) {
        let triangle = surface.over_triangle(&frame).expect("a patch");
        let (p, q) = bidegree(&surface);
        prop_assert_eq!(triangle.degree(), p + q);
        let back = triangle.surface().expect("numbers").over_rectangle(&rectangle).expect("a patch");
        prop_assert_eq!(back.degree(), (p + q, p + q));
        prop_assert!(back.surface().expect("numbers").same_map(&surface));
        prop_assert_eq!(back.surface().expect("numbers").read_as(surface.reading()).expect("as before"), surface);
    }

    #[test]
    fn symmetries_exchange_and_reverse_parameters(patch in rectangular_patch(3), [u, v] in place()) {
        let unit = RectangularPatch::from_points(patch.degree(), lists(patch.points()), Rectangle::unit()).expect("a patch");
        let one = Rational::from(1);
        for symmetry in Symmetry::ALL {
            let image = unit.under(symmetry);
            // Over the frame that goes with it the surface is the same; over the unit square the parameters move.
            let moved = RectangularPatch::from_points(image.degree(), lists(image.points()), Rectangle::unit()).expect("a patch");
            let (back_u, back_v) = (&one - &u, &one - &v);
            let at = match symmetry {
                Symmetry::ReverseU => (back_u, v.clone()),
                Symmetry::ReverseV => (u.clone(), back_v),
                Symmetry::HalfTurn => (back_u, back_v),
                Symmetry::Transpose => (v.clone(), u.clone()),
                Symmetry::QuarterTurn => (back_v, u.clone()),
                Symmetry::QuarterTurnBack => (v.clone(), back_u),
                Symmetry::AntiTranspose => (back_v, back_u),
            };
            prop_assert_eq!(moved.value(&[u.clone(), v.clone()]).expect("numbers"), unit.value(&[at.0, at.1]).expect("numbers"), "{:?}", symmetry);
            prop_assert_eq!(unit.is_invariant(symmetry), moved == unit);
        }
    }

    #[test]
    fn matrices_multiply_to_the_equation(patch in rectangular_patch(3)) {
        let (p, q) = patch.degree();
        let unit = RectangularPatch::from_points((p, q), lists(patch.points()), Rectangle::unit()).expect("a patch");
        let surface = unit.surface().expect("numbers");
        for coordinate in 0..unit.dimension() {
            let control = nalgebra::DMatrix::from_fn(p + 1, q + 1, |i, j| unit.point(i, j)[coordinate].clone());
            let product = bernstein_matrix(p).transpose() * control * bernstein_matrix(q);
            let mut expected = nalgebra::DMatrix::from_element(p + 1, q + 1, Rational::from(0));
            surface.terms(coordinate).into_iter().for_each(|(h, k, c)| expected[(h, k)] = c.clone());
            prop_assert_eq!(product, expected);
        }
    }

    #[test]
    fn weights_divide_last(patch in rectangular_patch(2), [u, v] in place(), seed in prop::collection::vec(-3i64..4, 9)) {
        let weights: Vec<Rational> = seed[..patch.points().len()].iter().map(|&w| Rational::from(w)).collect();
        let lifted = homogeneous_points(&lists(patch.points()), &weights).expect("a weight each");
        let rational = RectangularPatch::from_points(patch.degree(), lifted, patch.frame().clone()).expect("a patch");
        let basis = Bernstein::rectangle(patch.degree(), patch.frame().clone()).values(&[u.clone(), v.clone()]).expect("two parameters");
        let weight: Rational = basis.iter().zip(&weights).map(|(b, w)| b * w).sum();
        let expected: Option<Vec<Rational>> = (weight != Rational::from(0)).then(|| {
            (0..patch.dimension()).map(|c| patch.points().zip(&basis).zip(&weights).map(|((point, b), w)| &point[c] * b * w).sum::<Rational>() / &weight).collect()
        });
        prop_assert_eq!(projected(&rational.value(&[u.clone(), v.clone()]).expect("numbers")), expected);
    }

    #[test]
    fn images_of_weighted_points_are_points_of_the_image(patch in rectangular_patch(2), [u, v] in place(), seed in prop::collection::vec(1i64..4, 9), entries in prop::collection::vec(small(), 12)) {
        let weights: Vec<Rational> = seed[..patch.points().len()].iter().map(|&w| Rational::from(w)).collect();
        let lifted = homogeneous_points(&lists(patch.points()), &weights).expect("a weight each");
        let rational = RectangularPatch::from_points(patch.degree(), lifted, patch.frame().clone()).expect("a patch");
        let n = patch.dimension();
        let map = AffineMap::new((0..3).map(|row| entries[3 * row..3 * row + n].to_vec()).collect(), entries[9..].to_vec()).expect("a map");
        let image = rational.transform(&map.homogeneous()).expect("one dimension more");
        let point = projected(&rational.value(&[u.clone(), v.clone()]).expect("numbers"));
        let expected = point.map(|point| map.apply(&point).expect("the dimension"));
        prop_assert_eq!(projected(&image.value(&[u.clone(), v.clone()]).expect("numbers")), expected);
    }

    /// Weights that are products of weights of the vertices only move the
    /// parameter: CS348a, lecture 12, section 4, whose formula for S holds for
    /// these weights and no others.
    #[test]
    fn product_weights_move_the_parameter(patch in triangular_patch(3), at in place(), seed in [1i64..5, 1i64..5, 1i64..5]) {
        let vertices = seed.map(Rational::from);
        let weights: Vec<Rational> = TriangularPatch::<Rational>::indices(patch.degree()).iter()
            .map(|index| index.iter().zip(&vertices).map(|(&times, w)| w.pow(times as u32)).product()).collect();
        let lifted = homogeneous_points(&lists(patch.points()), &weights).expect("a weight each");
        let rational = TriangularPatch::from_points(lifted, patch.frame().clone()).expect("a patch");
        let barycentric = patch.frame().barycentric(&at).expect("numbers");
        let parts: Vec<Rational> = barycentric.iter().zip(&vertices).map(|(part, w)| part * w).collect();
        let sum: Rational = parts.iter().sum();
        prop_assume!(sum != Rational::from(0));
        let moved = patch.frame().at(&[&parts[0] / &sum, &parts[1] / &sum, &parts[2] / &sum]);
        prop_assert_eq!(projected(&rational.value(&at).expect("numbers")), Some(patch.value(&moved).expect("numbers")));
    }

    #[test]
    fn meshes_are_points_of_the_patch(patch in triangular_patch(3), rectangle in rectangular_patch(2), depth in 0usize..3) {
        let steps = 1i64 << depth;
        if patch.dimension() == 3 {
            let mesh = Mesh::of(&Piece::Triangle(patch.clone()), false, depth).expect("small");
            let expected: Vec<Vec<Rational>> = TriangularPatch::<Rational>::indices(steps as usize).iter()
                .map(|index| patch.value(&patch.frame().at(&index.map(|part| Rational::new(part as i64, steps)))).expect("numbers")).collect();
            prop_assert_eq!(lists(mesh.vertices().iter().map(|vertex| vertex.as_slice())), expected);
        }
        if rectangle.dimension() == 1 {
            let mesh = Mesh::of(&Piece::Rectangle(rectangle.clone()), false, depth).expect("small");
            for [x, y, z] in mesh.vertices() {
                prop_assert_eq!(&rectangle.value(&[x.clone(), y.clone()]).expect("numbers")[0], z);
            }
        }
    }
}

/// The three forms of the algorithm agree for every bicubic patch: its control
/// points and parameters are symbols.
#[test]
fn all_forms_agree_on_every_bicubic_patch() {
    let symbol = |letter: char, index: u32| Polynomial::from(Symbol::new(letter, Some(index)));
    let points = (0..16).map(|index| vec![symbol('p', index)]).collect();
    let patch = RectangularPatch::from_points((3, 3), points, Rectangle::unit()).expect("a patch");
    let [u, v] = ['u', 'v'].map(|letter| Polynomial::from(Symbol::new(letter, None)));
    let by_u = patch.two_steps(&[u.clone(), v.clone()], Axis::U).expect("a numeric frame");
    let by_v = patch.two_steps(&[u.clone(), v.clone()], Axis::V).expect("a numeric frame");
    let common = patch.common_steps(&[u.clone(), v.clone()]).expect("a numeric frame");
    assert_eq!(by_u.point(), by_v.point());
    assert_eq!(by_u.point(), common.point());
    // 16 products of Bernstein polynomials, none of which vanishes.
    assert!(by_u.point()[0].symbols().len() == 18);
}

/// Dividing at the barycentre again and again leaves the edges of the net as
/// long as they were: it does not converge (Gallier, section 19.4).
#[test]
fn dividing_at_the_barycentre_keeps_an_edge() {
    let points =
        [[0, 0, 0], [0, 1, 5], [0, 2, 0], [1, 0, 7], [1, 1, 0], [2, 0, 1]].map(|point| point.map(Rational::from).to_vec()).to_vec();
    let mut patch = TriangularPatch::from_points(points, Triangle::standard()).expect("a patch");
    let edge = |patch: &TriangularPatch| lists((0..=2).map(|j| patch.point(0, j)));
    let before = edge(&patch);
    let third = Rational::new(1, 3);
    for _ in 0..5 {
        let middle = patch.frame().at(&[third.clone(), third.clone(), third.clone()]);
        patch = patch.split(&middle).expect("numbers").ast.expect("the barycentre is off all edges");
        assert_eq!(edge(&patch), before);
    }
}

#[test]
fn the_generators_reach_the_degenerate_cases() {
    let mut runner = TestRunner::deterministic();
    let mut draw =
        |count: usize| (0..count).map(|_| triangular_patch(4).new_tree(&mut runner).expect("a value").current()).collect::<Vec<_>>();
    let patches = draw(200);
    assert!(patches.iter().any(|patch| patch.degree() == 0));
    for turned in [false, true] {
        assert!(patches.iter().any(|patch| (patch.frame().determinant() < Rational::from(0)) == turned));
    }
    let mut places = Vec::new();
    for patch in &patches {
        let at = point_of(patch.frame()).new_tree(&mut runner).expect("a value").current();
        places.push(patch.frame().place(&at));
    }
    for place in [Place::Vertex, Place::Edge, Place::Inside, Place::Outside] {
        assert!(places.iter().filter(|found| **found == place).count() > 5, "{place:?}");
    }
    let surfaces: Vec<(Terms, Surface)> = (0..200).map(|_| tensor(3).new_tree(&mut runner).expect("a value").current()).collect();
    for test in
        [|(p, q): (usize, usize)| p == 0 && q > 0, |(p, q)| p > 0 && q == 0, |(p, q)| p == 0 && q == 0, |(p, q)| p != q && p > 0 && q > 0]
    {
        assert!(surfaces.iter().any(|(_, surface)| test(bidegree(surface))));
    }
    assert!(surfaces.iter().any(|(_, surface)| surface.true_bidegree() != bidegree(surface)));
}

/// Places that are not there are refused in words, in every build.
#[test]
fn places_outside_of_a_patch_panic_as_documented() {
    let points = |count: i64| (0..count).map(|z| vec![Rational::from(z)]).collect::<Vec<_>>();
    let triangle = TriangularPatch::from_points(points(6), Triangle::standard()).expect("six points");
    let rectangle = RectangularPatch::from_points((1, 2), points(6), Rectangle::unit()).expect("six points");
    let half = Rational::new(1, 2);
    let scheme = triangle.scheme(&[half.clone(), half.clone()]).expect("numbers");
    let [in_u, in_v] = [Axis::U, Axis::V].map(|axis| rectangle.two_steps(&[half.clone(), half.clone()], axis).expect("numbers"));
    let common = rectangle.common_steps(&[half.clone(), half.clone()]).expect("numbers");
    let messages = [
        oracle::panic_message(|| triangle.label(1, 2)),
        oracle::panic_message(|| triangle.point(usize::MAX, 1).to_vec()),
        oracle::panic_message(|| rectangle.label(2, 0)),
        oracle::panic_message(|| rectangle.label(0, 3)),
        oracle::panic_message(|| scheme.label(1, 1, 1)),
        oracle::panic_message(|| scheme.get(usize::MAX, 1, 0).to_vec()),
        oracle::panic_message(|| scheme.indices(3)),
        oracle::panic_message(|| in_u.label(1, 1, 0)),
        oracle::panic_message(|| in_u.second_label(2, 1)),
        oracle::panic_message(|| in_v.second_label(1, 1)),
        oracle::panic_message(|| common.label(1, 0, 2)),
    ];
    for (place, message) in messages.iter().enumerate() {
        assert!(message.starts_with("the degree is ") && message.contains(": no point has the exponents"), "{place}: {message}");
    }
    for order in [[0, 0, 1], [2, 2, 2], [0, 1, 3]] {
        assert!(oracle::panic_message(|| triangle.permuted(order)).ends_with("is no order of the vertices 0, 1, 2"));
    }
    assert_eq!(triangle.permuted([1, 2, 0]).permuted([2, 0, 1]), triangle);
}

/// What would not fit into memory is refused before it is made.
#[test]
fn degrees_of_surfaces_have_limits() {
    use casteljau::Error::{TooLarge, WrongCount};
    let one = Rational::from(1);
    let limit = Surface::<Rational>::MAX_COEFFICIENTS;
    let too_large = Err(TooLarge { what: "surface, counted in coefficients,", limit });
    for (h, k) in [(usize::MAX, 1), (usize::MAX, usize::MAX), (usize::MAX / 2, usize::MAX / 2), (limit, 0)] {
        assert_eq!(Surface::total(vec![vec![(h, k, one.clone())]]), too_large, "{h} {k}");
        assert_eq!(Surface::tensor(vec![vec![(h, k, one.clone())]]), too_large, "{h} {k}");
    }
    for reading in [Reading::Total(usize::MAX), Reading::Bidegree(usize::MAX, 0), Reading::Bidegree(0, usize::MAX)] {
        assert_eq!(Surface::new(reading, vec![vec![(0, 0, one.clone())]]), too_large, "{reading:?}");
    }
    let from_points = |degrees| RectangularPatch::from_points(degrees, vec![vec![one.clone()]], Rectangle::unit());
    assert_eq!(from_points((usize::MAX, 0)), Err(WrongCount { what: "control points", expected: usize::MAX, found: 1 }));
    let rectangle = from_points((0, 0)).expect("one point");
    let triangle = TriangularPatch::from_points(vec![vec![one.clone()]], Triangle::standard()).expect("one point");
    for by in [usize::MAX, usize::MAX / 2, 1 << 22, 1 << 13] {
        let too_large = TooLarge { what: "elevation, counted in steps,", limit: TriangularPatch::<Rational>::MAX_STEPS };
        assert_eq!(triangle.elevate(by), Err(too_large.clone()));
        assert_eq!(rectangle.elevate(by, 0), Err(too_large.clone()));
        assert_eq!(rectangle.elevate(1, by), Err(too_large));
    }
    assert_eq!(triangle.elevate(20).map(|raised| raised.points().len()), Ok(21 * 22 / 2));
}

#[test]
fn subdivisions_of_surfaces_have_limits() {
    use casteljau::Error::TooLarge;
    let points = |count: usize| vec![vec![Rational::from(1)]; count];
    let triangle = |count| TriangularPatch::from_points(points(count), Triangle::standard()).expect("a net");
    let rectangle = |p, q| RectangularPatch::from_points((p, q), points((p + 1) * (q + 1)), Rectangle::unit()).expect("a net");
    let (most, limit) = (RectangularPatch::<Rational>::MAX_DEPTH, RectangularPatch::<Rational>::MAX_STEPS);
    let (deep, long) = (TooLarge { what: "depth of subdivision", limit: most }, TooLarge { what: "subdivision, counted in steps,", limit });
    assert_eq!(most, TriangularPatch::<Rational>::MAX_DEPTH);
    assert_eq!(triangle(1).subdivide(most + 1), Err(deep.clone()));
    assert_eq!(rectangle(0, 0).subdivide(most + 1), Err(deep));
    // 4^10 pieces of so many points, each by as many levels as it has degrees and one.
    assert_eq!(triangle(15).subdivide(most), Err(long.clone()));
    assert_eq!(rectangle(3, 2).subdivide(most), Err(long));
    assert_eq!(rectangle(3, 2).subdivide(2).map(|pieces| pieces.len()), Ok(16));
}

/// What consists of numbers is equal to itself, and kinds are written by their names.
#[test]
fn nouns_are_eq_and_kinds_have_names() {
    fn is_eq<T: Eq>() {}
    is_eq::<(casteljau::Curve, casteljau::Segment, Surface, TriangularPatch, RectangularPatch, Piece)>();
    is_eq::<(Interval, Triangle, Rectangle, casteljau::Frame, Parameter, PlaneParameter, AffineMap)>();
    is_eq::<(casteljau::Spline, Mesh, casteljau::Joint, casteljau::PolarForm, Bernstein, casteljau::Cubic)>();
    for symmetry in Symmetry::ALL {
        assert_eq!(symmetry.to_string(), symmetry.name());
    }
    assert_eq!(format!("[{:>10}]", casteljau::Directions::Same), "[      same]");
}
