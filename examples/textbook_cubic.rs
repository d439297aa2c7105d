//! The worked example of Gallier, *Curves and Surfaces in Geometric Modeling*,
//! chapter 18, from the equation to the subdivided control polygon.
//!
//! `cargo run --example textbook_cubic`

use casteljau::{Curve, Error, Interval, Rational, Scheme, Segment};

fn main() -> Result<(), Error> {
    let q = Rational::new;
    let curve = Curve::new(vec![vec![q(-9, 4), q(-3, 2), q(3, 4)], vec![q(0, 1), q(-9, 4), q(-3, 2), q(3, 4)]])?;

    // The polar form: c_k is the coefficient of the k-th elementary symmetric function.
    let polar = curve.polar();
    for coordinate in 0..polar.dimension() {
        let coefficients: Vec<String> = (0..=polar.degree()).map(|k| polar.coefficient(coordinate, k).to_string()).collect();
        println!("f{} has the coefficients {} of σ0, …, σ3", coordinate + 1, coefficients.join(", "));
    }

    let segment: Segment = curve.segment(&Interval::new(q(-1, 1), q(3, 1))?)?;
    for (i, point) in segment.points().enumerate() {
        println!("b{i} = ({}, {})", point[0], point[1]);
    }

    let scheme: Scheme = segment.scheme(&q(1, 2))?;
    println!("{} = ({}, {})", scheme.label(0, 3), scheme.point()[0], scheme.point()[1]);

    let (left, right) = segment.split(&q(1, 2))?;
    assert!(left.same_map(&right)? && left.curve()? == curve);
    println!("both halves, over {} and {}, have the equation they came from", left.frame(), right.frame());
    Ok(())
}
