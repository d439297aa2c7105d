//! Dividing a triangular patch at the barycentre again and again does not
//! converge to the patch: the edges of the net stay as long as they were
//! (Gallier, *Curves and Surfaces in Geometric Modeling*, section 19.4).
//! Dividing at the midpoints of the edges does.
//!
//! `cargo run --example barycentre`

use casteljau::{Error, Rational, Surface, Triangle, TriangularPatch};

/// The square of the longest edge of the frame that the patch is over.
fn longest_edge(patch: &TriangularPatch) -> Option<Rational> {
    let [r, s, t] = patch.frame().vertices();
    let square = |a: &[Rational; 2], b: &[Rational; 2]| (&a[0] - &b[0]).pow(2) + (&a[1] - &b[1]).pow(2);
    [square(r, s), square(s, t), square(t, r)].into_iter().max()
}

fn main() -> Result<(), Error> {
    let q = |n: i64| Rational::from(n);
    let saddle = Surface::total(vec![vec![(1, 0, q(1))], vec![(0, 1, q(1))], vec![(3, 0, q(1)), (1, 2, q(-3))]])?;
    let patch = saddle.over_triangle(&Triangle::standard())?;
    let third = Rational::new(1, 3);
    let (mut by_barycentre, mut by_midpoints) = (vec![patch.clone()], vec![patch]);
    println!("rounds  longest edge squared, at the barycentre  at the midpoints");
    for round in 0..5 {
        let longest = |patches: &[TriangularPatch]| patches.iter().filter_map(longest_edge).max().unwrap_or_default();
        println!("{round:6}  {:>39}  {:>16}", longest(&by_barycentre).to_string(), longest(&by_midpoints).to_string());
        let mut parts = Vec::new();
        for patch in &by_barycentre {
            let middle = patch.frame().at(&[third.clone(), third.clone(), third.clone()]);
            let trisection = patch.split(&middle)?;
            parts.extend([trisection.ast, trisection.rat, trisection.rsa].into_iter().flatten());
        }
        by_barycentre = parts;
        let mut parts = Vec::new();
        for patch in &by_midpoints {
            parts.extend(patch.subdivide(1)?);
        }
        by_midpoints = parts;
    }
    Ok(())
}
