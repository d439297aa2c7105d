//! Exact numbers in `nalgebra`: a rotation by a Pythagorean angle moves a curve
//! without any rounding, and back again.
//!
//! `cargo run --example exact_matrices`

use casteljau::{AffineMap, Error, Interval, Rational, Segment};
use nalgebra::{DMatrix, DVector, Point2};

fn main() -> Result<(), Error> {
    let point = |x: i64, y: i64| Point2::new(Rational::from(x), Rational::from(y));
    let segment = Segment::from_nalgebra(&[point(0, 0), point(-4, 4), point(-4, -12), point(0, 0)], Interval::unit())?;

    // (3/5, 4/5) is a point of the unit circle.
    let (cosine, sine) = (Rational::new(3, 5), Rational::new(4, 5));
    let rotation = DMatrix::from_row_slice(2, 2, &[cosine.clone(), -&sine, sine, cosine]);
    let turn = AffineMap::try_from((rotation.clone(), DVector::from_element(2, Rational::from(0))))?;
    let back = AffineMap::try_from((rotation.transpose(), DVector::from_element(2, Rational::from(0))))?;

    let turned = segment.transform(&turn)?;
    println!("the control points, one a column: {}", DMatrix::from(&turned));
    assert_eq!(turned.transform(&back)?, segment);
    println!("turned back, they are where they were");
    Ok(())
}
