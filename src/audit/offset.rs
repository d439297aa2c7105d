//! How far control points are from making a joint smooth.

use num_bigint::{BigInt, BigUint};
use num_traits::{Signed, Zero};

use super::tangent::squared;
use crate::exact::Rational;

/// The control points behind a joint, seen from the joint, column by column.
pub(super) type Columns = Vec<Vec<BigInt>>;

fn dot<'a>(a: impl Iterator<Item = &'a BigInt>, b: impl Iterator<Item = &'a BigInt>) -> BigInt {
    a.zip(b).map(|(x, y)| x * y).sum()
}

/// The largest squared distance of `b` from `-λ a`, column by column, where the
/// one `λ > 0` for all columns makes the sum of squares least; none if there is
/// no such `λ`.
fn distance(a: &Columns, b: &Columns, scale: &BigUint) -> Option<Rational> {
    let lambda = -dot(a.iter().flatten(), b.iter().flatten());
    let whole = dot(a.iter().flatten(), a.iter().flatten());
    if !lambda.is_positive() || whole.is_zero() {
        return None;
    }
    let column = |(a, b): (&Vec<BigInt>, &Vec<BigInt>)| -> BigInt {
        a.iter().zip(b).map(|(x, y)| y * &whole + x * &lambda).map(|part| &part * &part).sum()
    };
    let largest = a.iter().zip(b).map(column).max()?;
    Some(squared(largest, &whole * &whole, scale))
}

/// The least squared move of the control points behind one side that makes the
/// tangents run on with one ratio: the largest over the columns, for the side
/// where it is smaller.
pub(super) fn least_move(a: &Columns, b: &Columns, scale: &BigUint) -> Option<Rational> {
    match (distance(a, b, scale), distance(b, a, scale)) {
        (Some(one), Some(other)) => Some(one.min(other)),
        (one, other) => one.or(other),
    }
}

/// Whether points within half a unit of the last digit of these are smooth.
///
/// A control point may be anywhere in the box of half-width `half` around the
/// printed one; those of the joint itself too, if `joint_moves`. Then
/// `|b + λ a| <= half (1 + λ)` in each coordinate, twice that if the joint
/// moves: an interval of `λ` for each, and all intervals need a common point
/// with `λ > 0` (or the given `λ` in them).
pub(super) fn is_explained_by_rounding(a: &Columns, b: &Columns, half: &Rational, joint_moves: bool, lambda: Option<&Rational>) -> bool {
    let slack = if joint_moves { half * Rational::from(2) } else { half.clone() };
    let (slack, unit) = (slack.numer(), slack.denom());
    // low <= λ <= high, as fractions with positive denominators; high may be infinite.
    let mut low = (BigInt::zero(), BigInt::from(1));
    let mut high: Option<(BigInt, BigInt)> = None;
    let positive = |numer: BigInt, denom: BigInt| if denom.is_negative() { (-numer, -denom) } else { (numer, denom) };
    let less = |x: &(BigInt, BigInt), y: &(BigInt, BigInt)| &x.0 * &y.1 < &y.0 * &x.1;
    for (x, y) in a.iter().flatten().zip(b.iter().flatten()) {
        for sign in [BigInt::from(1), BigInt::from(-1)] {
            // sign (y + λ x) - slack (1 + λ) <= 0, that is constant + λ factor <= 0.
            let constant: BigInt = y * &unit * &sign - &slack;
            let factor: BigInt = x * &unit * &sign - &slack;
            if factor.is_zero() {
                if constant.is_positive() {
                    return false;
                }
                continue;
            }
            let bound = positive(-constant, factor.clone());
            if factor.is_positive() {
                if high.as_ref().is_none_or(|high| less(&bound, high)) {
                    high = Some(bound);
                }
            } else if less(&low, &bound) {
                low = bound;
            }
        }
    }
    if let Some(lambda) = lambda {
        let lambda = (lambda.numer(), lambda.denom());
        return !less(&lambda, &low) && high.as_ref().is_none_or(|high| !less(high, &lambda));
    }
    high.as_ref().is_none_or(|high| high.0.is_positive() && !less(high, &low))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn columns(points: &[&[i64]]) -> Columns {
        points.iter().map(|point| point.iter().copied().map(BigInt::from).collect()).collect()
    }

    fn explained(a: &[i64], b: &[i64], half: Rational) -> bool {
        is_explained_by_rounding(&columns(&[a]), &columns(&[b]), &half, false, None)
    }

    #[test]
    fn handles_on_a_grid() {
        let half = || Rational::new(1, 2);
        assert!(explained(&[10, 3], &[-20, -6], half()));
        assert!(explained(&[10, 3], &[-20, -7], half()));
        assert!(!explained(&[10, 3], &[-20, -8], half()));
        assert!(!explained(&[10, 3], &[20, 6], half()), "a cusp");
        // Just so: (10, 0.5) and (-20, -1): the corners of the boxes touch.
        assert!(explained(&[10, 0], &[-20, 0], Rational::from(0)));
        assert!(!explained(&[10, 0], &[-20, 1], Rational::from(0)));
    }

    #[test]
    fn a_given_ratio_is_needed_for_equal_derivatives() {
        let (a, b) = (columns(&[&[10, 3]]), columns(&[&[-20, -6]]));
        let one = Rational::from(1);
        assert!(!is_explained_by_rounding(&a, &b, &Rational::new(1, 2), false, Some(&one)));
        let b = columns(&[&[-11, -2]]);
        assert!(is_explained_by_rounding(&a, &b, &Rational::new(1, 2), false, Some(&one)));
        assert!(!is_explained_by_rounding(&a, &columns(&[&[-11, -1]]), &Rational::new(1, 2), false, Some(&one)));
    }

    #[test]
    fn the_least_move_is_the_distance_from_the_ray() {
        let scale = BigUint::from(10u32);
        // (3, 4)/10 against the ray of (-1, 0): 4/10 away; the other way (1, 0) is 4/50 away.
        let (a, b) = (columns(&[&[1, 0]]), columns(&[&[-3, 4]]));
        assert_eq!(least_move(&a, &b, &scale), Some(Rational::new(16, 2500)));
        assert_eq!(least_move(&a, &columns(&[&[3, 4]]), &scale), None, "more than a right angle");
    }
}
