//! Repairs of joins: what they reach, that they are projections, and what they refuse.

use casteljau::{
    Arrangement, Continuity, Curve, Equation, Error, Interval, Joint, Piece, Rational, Reading, Rectangle, RectangularPatch, Repair,
    Segment, Side, Surface, Triangle, TriangularPatch, continuity_of_curves, continuity_of_rational_curves, continuity_of_surfaces,
    geometric_join_of_ends, homogeneous_points, projected, repair_tangents, repair_to_order, tangent_plane_join,
};
use proptest::prelude::*;

fn small() -> impl Strategy<Value = Rational> {
    (-6i64..7, 1i64..4).prop_map(|(n, d)| Rational::new(n, d))
}

fn points(count: usize, dimension: usize) -> impl Strategy<Value = Vec<Vec<Rational>>> {
    prop::collection::vec(prop::collection::vec(small(), dimension), count)
}

fn unit(from: i64, to: i64) -> Interval {
    Interval::new(Rational::from(from), Rational::from(to)).expect("a frame")
}

fn at(u: i64, v: i64) -> [Rational; 2] {
    [Rational::from(u), Rational::from(v)]
}

fn order(first: &Piece, second: &Piece, joint: &Joint) -> Continuity {
    match (first.equation().expect("numbers"), second.equation().expect("numbers"), joint) {
        (Equation::Curve(a), Equation::Curve(b), Joint::Parameter(at)) => continuity_of_curves(&a, &b, at),
        (Equation::Surface(a), Equation::Surface(b), Joint::Edge(edge)) => continuity_of_surfaces(&a, &b, edge),
        _ => unreachable!("curves join at parameters"),
    }
    .expect("one dimension")
}

fn squares(a: &Piece, b: &Piece) -> Rational {
    a.coordinates().iter().zip(b.coordinates()).map(|(x, y)| (x - y).pow(2)).sum()
}

/// The theorem of Pythagoras holds for a projection and every other point that
/// it could have gone to, and for nothing else.
fn is_projection(start: &Piece, repair: &Repair, other: &Repair) -> Result<(), TestCaseError> {
    prop_assert_eq!(&repair.squares, &squares(start, &repair.piece));
    prop_assert_eq!(squares(start, &other.piece), &repair.squares + squares(&repair.piece, &other.piece));
    let moved: Vec<usize> = start.points().zip(repair.piece.points()).enumerate().filter(|(_, (a, b))| a != b).map(|(k, _)| k).collect();
    prop_assert_eq!(&repair.moved, &moved);
    Ok(())
}

fn check(first: &Piece, second: &Piece, elsewhere: &Piece, joint: &Joint, asked: usize, solvable: bool) -> Result<(), TestCaseError> {
    let repair = match repair_to_order(first, second, joint, asked, false) {
        Ok(repair) => repair,
        Err(Error::Unsupported(_)) if !solvable => return Ok(()),
        Err(error) => return Err(TestCaseError::fail(format!("{error}"))),
    };
    prop_assert!(order(first, &repair.piece, joint) >= Continuity::C(asked));
    let other = repair_to_order(first, elsewhere, joint, asked, false).expect("the same conditions");
    is_projection(second, &repair, &other)?;
    let again = repair_to_order(first, &repair.piece, joint, asked, false).expect("the same conditions");
    prop_assert!(again.moved.is_empty() && again.squares == Rational::from(0) && again.piece == repair.piece);
    Ok(())
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 96, ..ProptestConfig::default() })]

    #[test]
    fn curves(a in points(4, 2), b in points(6, 2), c in points(6, 2), count in 2usize..7, turned: bool, asked in 0usize..4) {
        let frame = if turned { unit(3, 1) } else { unit(1, 3) };
        let curve = |points: &[Vec<Rational>], frame: &Interval| Piece::Curve(Segment::from_points(points.to_vec(), frame.clone()).expect("a segment"));
        let first = curve(&a, &unit(0, 1));
        check(&first, &curve(&b[..count], &frame), &curve(&c[..count], &frame), &Joint::Parameter(Rational::from(1)), asked, asked < count)?;
    }

    #[test]
    fn patches(a in points(10, 1), b in points(15, 1), c in points(15, 1), degree in 2usize..5, asked in 0usize..3, turned in 0usize..3) {
        let count = (degree + 1) * (degree + 2) / 2;
        let triangle = |points: &[Vec<Rational>], frame: &Triangle| Piece::Triangle(TriangularPatch::from_points(points.to_vec(), frame.clone()).expect("a patch"));
        let own = Triangle::new(at(0, 0), at(1, 0), at(1, 1)).expect("a frame");
        let mut vertices = [at(1, 0), at(3, 2), at(1, 1)];
        vertices.rotate_left(turned);
        let [r, s, t] = vertices;
        let frame = Triangle::new(r, s, t).expect("a frame");
        let joint = Joint::Edge([at(1, 0), at(1, 1)]);
        let (second, elsewhere) = (triangle(&b[..count], &frame), triangle(&c[..count], &frame));
        check(&triangle(&a, &own), &second, &elsewhere, &joint, asked, degree >= 3)?;
        let rectangle = |points: &[Vec<Rational>], (p, q): (usize, usize), from: i64, to: i64| {
            Piece::Rectangle(RectangularPatch::from_points((p, q), points[..(p + 1) * (q + 1)].to_vec(), Rectangle::new(unit(from, to), unit(0, 1))).expect("a patch"))
        };
        let bidegree = (degree, 2);
        check(&rectangle(&a, (2, 1), 0, 1), &rectangle(&b, bidegree, 1, 2), &rectangle(&c, bidegree, 1, 2), &joint, asked, true)?;
        check(&rectangle(&a, (2, 2), 0, 1), &rectangle(&b, (2, 1), 1, 2), &rectangle(&c, (2, 1), 1, 2), &joint, asked, false)?;
        check(&rectangle(&a, (1, 1), 0, 1), &second, &elsewhere, &joint, asked, true)?;
    }

    /// The weights stay, the points move, and the Cartesian maps are as smooth as was asked.
    #[test]
    fn rational_curves(a in points(3, 2), b in points(4, 2), c in points(4, 2), weights in prop::collection::vec(1i64..5, 7), asked in 0usize..3) {
        let weights: Vec<Rational> = weights.into_iter().map(Rational::from).collect();
        let curve = |points: &[Vec<Rational>], weights: &[Rational], from: i64| {
            Piece::Curve(Segment::from_points(homogeneous_points(points, weights).expect("as many"), unit(from, from + 1)).expect("a segment"))
        };
        let (first, second, elsewhere) = (curve(&a, &weights[..3], 0), curve(&b, &weights[3..], 1), curve(&c, &weights[3..], 1));
        let joint = Joint::Parameter(Rational::from(1));
        let repair = repair_to_order(&first, &second, &joint, asked, true).expect("a high degree");
        let (Ok(Equation::Curve(own)), Ok(Equation::Curve(other))) = (first.equation(), repair.piece.equation()) else { unreachable!() };
        prop_assert!(continuity_of_rational_curves(&own, &other, &Rational::from(1)).expect("finite").cartesian >= Continuity::C(asked));
        let other = repair_to_order(&first, &elsewhere, &joint, asked, true).expect("a high degree");
        let cartesian = |piece: &Piece| piece.points().map(|point| projected(point).expect("finite")).collect::<Vec<_>>();
        let squares = |a: &Piece, b: &Piece| cartesian(a).iter().flatten().zip(cartesian(b).iter().flatten()).map(|(x, y)| (x - y).pow(2)).sum::<Rational>();
        prop_assert_eq!(&repair.squares, &squares(&second, &repair.piece));
        prop_assert_eq!(squares(&second, &other.piece), &repair.squares + squares(&repair.piece, &other.piece));
        prop_assert!(repair.piece.points().zip(second.points()).all(|(new, old)| new[2] == old[2]));
    }

    #[test]
    fn tangents_of_curves(a in points(4, 2), b in points(5, 2), c in points(5, 2), sides: [bool; 2]) {
        let side = |start: bool| if start { Side::Start } else { Side::End };
        let curve = |points: &[Vec<Rational>]| Segment::from_points(points.to_vec(), unit(0, 1)).expect("a segment");
        let (first, second, elsewhere) = (Piece::Curve(curve(&a)), Piece::Curve(curve(&b)), Piece::Curve(curve(&c)));
        let ask = |second: &Piece| repair_tangents((&first, side(sides[0])), (second, side(sides[1])), false);
        let (Ok(repair), Ok(other)) = (ask(&second), ask(&elsewhere)) else { return Ok(()) };
        is_projection(&second, &repair, &other)?;
        let (Piece::Curve(own), Piece::Curve(changed)) = (&first, &repair.piece) else { unreachable!() };
        let join = geometric_join_of_ends((own, side(sides[0])), (changed, side(sides[1])), false).expect("one dimension");
        prop_assert!(join.order >= Some(1));
        // The shape parameter is of derivatives, the ratio of differences: 4 and 3 times those.
        let (ratio, _) = repair.ratio.clone().expect("a ratio");
        prop_assert_eq!(join.betas[0].clone(), ratio * Rational::new(4, 3));
        prop_assert!(ask(&repair.piece).expect("it is good").moved.is_empty());
    }

    #[test]
    fn tangent_planes(a in points(16, 3), b in points(16, 3), c in points(16, 3), kinds: [bool; 2], sides in [0usize..4, 0usize..4], reversed: bool) {
        let patch = |points: &[Vec<Rational>], triangle: bool, degree: usize| {
            if triangle {
                Piece::Triangle(TriangularPatch::from_points(points[..(degree + 1) * (degree + 2) / 2].to_vec(), Triangle::standard()).expect("a patch"))
            } else {
                Piece::Rectangle(RectangularPatch::from_points((degree, degree), points[..(degree + 1).pow(2)].to_vec(), Rectangle::unit()).expect("a patch"))
            }
        };
        // Beside a rectangle a triangle needs one degree more.
        let degree = if kinds[1] && !kinds[0] { 3 } else { 2 };
        let (first, second, elsewhere) = (patch(&a, kinds[0], 2), patch(&b, kinds[1], degree), patch(&c, kinds[1], degree));
        let side = |piece: &Piece, k: usize| Arrangement::of(piece).sides()[k % Arrangement::of(piece).sides().len()];
        let (own, other) = (side(&first, sides[0]), side(&second, sides[1]));
        let ask = |second: &Piece| repair_tangents((&first, own), (second, other), reversed);
        let (Ok(repair), Ok(elsewhere)) = (ask(&second), ask(&elsewhere)) else { return Ok(()) };
        is_projection(&second, &repair, &elsewhere)?;
        let join = tangent_plane_join((&first, own), (&repair.piece, other), false).expect("in space");
        prop_assert!(join.g1() != Some(false), "{join:?}");
        let (ratio, shear) = repair.ratio.clone().expect("a ratio");
        if join.g1() == Some(true) && join.reversed == reversed {
            prop_assert_eq!(join.ratio.and_then(|ratio| ratio.constant()), Some(ratio));
            let found = join.shear.expect("a regular join");
            let mut shear = shear;
            while shear.last().is_some_and(|x| *x == Rational::from(0)) {
                shear.pop();
            }
            prop_assert_eq!((found.numerator, found.denominator), (shear, vec![Rational::from(1)]));
        }
        prop_assert!(ask(&repair.piece).expect("it is good").moved.is_empty());
    }
}

/// A join with constant `λ` and `μ`, both of them needed, is good already.
#[test]
fn shears_of_triangles_are_allowed_for() {
    let q = Rational::from;
    // The graph of u^2 + u v + v^3 over two triangles that are no parallelogram, and over a rectangle.
    let height = vec![(2, 0, q(1)), (1, 1, q(1)), (0, 3, q(1))];
    let surface = Surface::new(Reading::Total(3), vec![vec![(1, 0, q(1))], vec![(0, 1, q(1))], height]).expect("a surface");
    let triangle = |inner| {
        let frame = Triangle::new(inner, at(0, 0), at(1, 0)).expect("a frame");
        Piece::Triangle(surface.over_triangle(&frame).expect("a patch"))
    };
    let above = triangle(at(1, 2));
    let below = Piece::Rectangle(surface.over_rectangle(&Rectangle::new(unit(0, 1), unit(0, -1))).expect("a patch"));
    let Piece::Triangle(raised) = triangle(at(3, 2)) else { unreachable!() };
    for (first, own, second, other) in [
        (triangle(at(0, -1)), Side::St, above.clone(), Side::St),
        (above, Side::St, below.clone(), Side::V0),
        (below, Side::V0, Piece::Triangle(raised.elevate(1).expect("small")), Side::St),
    ] {
        let repair = repair_tangents((&first, own), (&second, other), false).expect("it is good");
        assert!(repair.moved.is_empty() && repair.piece == second);
        let (ratio, shear) = repair.ratio.expect("a ratio");
        let join = tangent_plane_join((&first, own), (&second, other), false).expect("in space");
        assert_eq!(join.ratio.and_then(|ratio| ratio.constant()), Some(ratio));
        assert!(shear.iter().any(|x| *x != q(0)));
    }
}

#[test]
fn what_cannot_be_repaired_is_refused() {
    let q = Rational::from;
    let curve = |points: &[[i64; 2]], from: i64| {
        Piece::Curve(Segment::from_points(points.iter().map(|p| p.map(q).to_vec()).collect(), unit(from, from + 1)).expect("a segment"))
    };
    let first = curve(&[[0, 0], [1, 2], [3, 2], [4, 0]], 0);
    let message = |result: Result<Repair, Error>| result.map_or_else(|error| error.to_string(), |_| "repaired".to_owned());
    let joint = Joint::Parameter(q(1));
    // A line has no second derivative to change.
    let line = curve(&[[4, 0], [5, 5]], 1);
    assert_eq!(message(repair_to_order(&first, &line, &joint, 1, false)), "repaired");
    assert!(message(repair_to_order(&first, &line, &joint, 2, false)).contains("`casteljau elevate` raises it"));
    let ends = |second: &Piece| message(repair_tangents((&first, Side::End), (second, Side::Start), false));
    assert_eq!(ends(&line), "the best ratio is -9/5, which is not positive: the second piece lies on the side of the first one");
    assert_eq!(ends(&curve(&[[4, 0], [6, -3]], 1)), "repaired");
    let cusp = curve(&[[0, 0], [4, 0], [4, 0]], 0);
    assert!(message(repair_tangents((&cusp, Side::End), (&line, Side::Start), false)).contains("has no tangent"));
    assert!(ends(&curve(&[[4, 0]], 1)).contains("too low"));
    let constant = Curve::new(vec![vec![q(1)], vec![q(1)]]).and_then(|curve| curve.segment(&unit(1, 2))).expect("a point");
    assert!(message(repair_to_order(&first, &Piece::Curve(constant), &joint, 1, false)).contains("too low"));
}
