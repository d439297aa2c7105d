//! Whole pictures: what they contain, and what they never contain.

use num_traits::Zero;

use super::CurvePicture;
use crate::affine::Interval;
use crate::error::Error;
use crate::exact::Rational;
use crate::segment::Segment;

fn over_unit(dimension: usize, coordinates: Vec<Rational>) -> Segment {
    Segment::new(dimension, coordinates, Interval::unit()).unwrap()
}

fn small(dimension: usize, coordinates: &[i64]) -> Segment {
    over_unit(dimension, coordinates.iter().map(|&value| value.into()).collect())
}

fn textbook() -> Segment {
    let coordinates = [0, 0, -4, 4, -4, -12, 0, 0].map(Rational::from).to_vec();
    Segment::new(2, coordinates, Interval::new((-1).into(), 3.into()).unwrap()).unwrap()
}

/// The picture, after a check that its tags balance and all its numbers are on the paper.
fn checked(picture: &CurvePicture) -> String {
    let svg = picture.svg().unwrap();
    assert_eq!(picture.svg().as_ref(), Ok(&svg), "pictures are deterministic");
    let mut open: Vec<&str> = Vec::new();
    for part in svg.split('<').skip(1) {
        let (tag, text) = part.split_once('>').expect("tags end");
        assert!(
            !text.contains('>') && !text.replace("&lt;", "").replace("&gt;", "").replace("&amp;", "").replace("&quot;", "").contains('&')
        );
        assert_eq!(tag.matches('"').count() % 2, 0, "{tag}");
        match tag.strip_prefix('/') {
            Some(name) => assert_eq!(open.pop(), Some(name)),
            None if tag.ends_with('/') => {}
            None => open.push(tag.split(' ').next().unwrap_or_default()),
        }
    }
    assert!(open.is_empty() && !svg.contains("NaN") && !svg.contains("inf"));
    let size: Vec<f64> = attribute(&svg, " viewBox=\"").next().unwrap().split(' ').map(|value| value.parse().unwrap()).collect();
    let inside = |x: f64, y: f64| assert!((0.0..=size[2]).contains(&x) && (0.0..=size[3]).contains(&y), "{x},{y}: {svg}");
    for name in [" d=\"", " points=\""] {
        for pair in attribute(&svg, name).flat_map(|path| path.split([' ', 'M', 'L', 'Q', 'C', 'Z'])).filter(|pair| !pair.is_empty()) {
            let (x, y) = pair.split_once(',').unwrap();
            inside(x.parse().unwrap(), y.parse().unwrap());
            assert!(pair.split([',', '.']).all(|digits| digits.len() <= 4), "at most two decimals: {pair}");
        }
    }
    for (x, y) in [(" x=\"", " y=\""), (" x1=\"", " y1=\""), (" x2=\"", " y2=\""), (" cx=\"", " cy=\"")] {
        for (x, y) in attribute(&svg, x).zip(attribute(&svg, y)) {
            inside(x.parse().unwrap(), y.parse().unwrap());
        }
    }
    svg
}

fn attribute<'a>(svg: &'a str, start: &'a str) -> impl Iterator<Item = &'a str> {
    svg.split(start).skip(1).filter_map(|rest| rest.split('"').next())
}

#[test]
fn a_cubic_is_one_exact_command() {
    let svg = checked(&CurvePicture::new(textbook()));
    for text in
        ["A cubic over -1..3", "r = -1, s = 3", ">f(r,r,s) = (-4, 4)</text>", ">f(r,s,s) = (-4, -12)</text>", ">f(r,r,r) = f(s,s,s)</text>"]
    {
        assert!(svg.contains(text), "{text}");
    }
    let curve = attribute(&svg, " d=\"").find(|path| path.contains(" C") && path.split(' ').count() == 4);
    assert!(curve.is_some());
    assert_eq!(svg.matches("<polyline").count(), 0);
}

#[test]
fn the_shells_have_polar_labels() {
    for (t, point) in [
        (Rational::from(1), "F(1) = (-3, -3)"),
        (Rational::new(1, 2), "F(1/2) = (-45/16, -45/32)"),
        (Rational::new(7, 2), "F(7/2) = (27/16, 189/32)"),
    ] {
        let svg = checked(&CurvePicture::new(textbook()).with_scheme(t));
        for label in ["f(r,r,t)", "f(r,s,t)", "f(s,s,t)", "f(r,t,t)", "f(s,t,t)", point] {
            assert!(svg.contains(&format!(">{label}</text>")), "{label}");
        }
    }
    let outside = checked(&CurvePicture::new(textbook()).with_scheme((-2).into()));
    assert!(outside.contains("stroke-dasharray=\"6 5\""));
    let vertex = checked(&CurvePicture::new(textbook()).with_scheme(3.into()));
    assert!(vertex.contains(">F(3) = (0, 0)</text>") && !vertex.contains(">f(s,s,t)</text>"));
}

#[test]
fn subdivision_has_a_polygon_for_every_piece() {
    for depth in [0, 1, 2, 6] {
        let svg = checked(&CurvePicture::new(textbook()).with_subdivision(depth));
        assert_eq!(svg.matches("<polyline").count(), 1 << depth);
    }
    let too_deep = CurvePicture::new(textbook()).with_subdivision(11).svg();
    assert_eq!(too_deep, Err(Error::TooLarge { what: "depth of a picture", limit: 10 }));
}

#[test]
fn graphs_and_space_curves() {
    let svg = checked(&CurvePicture::new(small(1, &[2, -3, 5, 1])).with_scheme(Rational::new(1, 3)));
    assert!(svg.contains(">F(1/3) = 11/27</text>") && svg.contains(">F(t)</text>"));
    assert!(checked(&CurvePicture::new(small(1, &[5]))).contains(">f() = 5</text>"));
    let twisted = small(3, &[-1, 1, -1, 0, 0, 1, 0, 0, -1, 1, 1, 1]);
    for (azimuth, elevation) in [(30, 25), (0, 0), (90, 90), (-135, -40), (i32::MAX, i32::MIN)] {
        let svg = checked(&CurvePicture::new(twisted.clone()).with_view(azimuth, elevation).with_subdivision(2).with_scheme(2.into()));
        assert!(svg.contains(">z</text>") && svg.contains("F(2) = "));
    }
    let many = CurvePicture::new(small(4, &[1, 2, 3, 4])).svg();
    assert!(matches!(many, Err(Error::Unsupported(message)) if message.contains("`transform`")));
}

#[test]
fn degenerate_curves_are_drawn() {
    for dimension in 1..=3 {
        for coordinates in [[0; 12], [7; 12], [0, 0, 0, 1, 0, 0, 2, 0, 0, 5, 0, 0], [1, 9, 0, 1, 8, 0, 1, 9, 0, 1, 9, 0]] {
            for count in [1, 2, 4] {
                let segment = small(dimension, &coordinates[..count * dimension]);
                checked(&CurvePicture::new(segment.clone()));
                checked(&CurvePicture::new(segment).with_scheme(Rational::new(-3, 2)).with_subdivision(3));
            }
        }
    }
}

#[test]
fn extreme_numbers_have_finite_places() {
    let (huge, tiny) = (Rational::from(10).pow(300), Rational::new(1, 10).pow(300));
    let long = Rational::from(7).pow(200) / Rational::from(3).pow(200);
    for values in [[&huge, &tiny, &long], [&tiny, &tiny, &huge], [&long, &long, &long]] {
        for dimension in 1..=3 {
            let coordinates = (0..4 * dimension).map(|index| values[index % 3] * Rational::from(index * 5 % 7)).collect();
            let frame = Interval::new(values[0].clone(), values[0] + Rational::from(1)).unwrap();
            let segment = Segment::new(dimension, coordinates, frame).unwrap();
            let picture = CurvePicture::new(segment).with_scheme(values[0] + Rational::new(1, 3)).with_subdivision(1);
            assert!(checked(&picture).len() < 30_000);
        }
    }
    let far = [Rational::zero(), Rational::from(1), &huge + Rational::from(3)];
    for t in far {
        checked(&CurvePicture::new(textbook()).with_scheme(t));
    }
}

#[test]
fn high_degrees_are_drawn_up_to_a_limit() {
    let wave = |degree: usize| small(2, &(0..=degree as i64).flat_map(|i| [i, i * 7919 % 41]).collect::<Vec<_>>());
    for degree in [5, 9, 12, 17, 60] {
        checked(&CurvePicture::new(wave(degree)).with_subdivision(2));
        checked(&CurvePicture::new(wave(degree)).with_scheme(Rational::new(11, 10)));
    }
    let too_high = CurvePicture::new(wave(201)).svg();
    assert_eq!(too_high, Err(Error::TooLarge { what: "degree of a picture", limit: 200 }));
}

#[test]
fn rational_curves_show_their_weights_and_their_steps() {
    let arc = |weights: [i64; 3]| {
        let points = [[1, 0], [1, 1], [0, 1]].map(|point| point.map(Rational::from).to_vec()).to_vec();
        let lifted = crate::weights::homogeneous_points(&points, &weights.map(Rational::from)).expect("a weight each");
        Segment::from_points(lifted, Interval::unit()).expect("three points")
    };
    let svg = checked(&CurvePicture::rational(&arc([1, 1, 2])).expect("positive weights").with_scheme(Rational::new(1, 2)));
    for text in ["A rational quadratic over 0..1", "weights 1, 1, 2", "F(1/2) = (3/5, 4/5)"] {
        assert!(svg.contains(text), "{text}");
    }
    let outside = checked(&CurvePicture::rational(&arc([-1, -1, -2])).expect("negative weights").with_scheme(2.into()));
    assert!(outside.contains("F(2) = (-3/5, 4/5)"));
    assert!(CurvePicture::rational(&arc([1, 0, 1])).is_err() && CurvePicture::rational(&arc([1, -1, 1])).is_err());
}
