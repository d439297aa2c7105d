//! How far control points are from making a joint smooth.

use std::cmp::Ordering;

use super::lattice::Whole;
use super::tangent::squared;
use crate::exact::Rational;
use num_bigint::{BigInt, BigUint};

/// The control points behind a joint, seen from the joint, column by column.
pub(super) type Columns<W> = Vec<Vec<W>>;

fn dot<W: Whole>(a: &Columns<W>, b: &Columns<W>) -> W {
    a.iter().flatten().zip(b.iter().flatten()).fold(W::nothing(), |mut sum, (x, y)| {
        sum.add_product(x, y);
        sum
    })
}

/// The largest squared distance of `b` from `-λ a`, column by column, where the
/// one `λ > 0` for all columns makes the sum of squares least; none if there is
/// no such `λ`.
fn distance<W: Whole>(a: &Columns<W>, b: &Columns<W>, scale: &BigUint) -> Option<Rational> {
    let (product, whole) = (dot(a, b), dot(a, a));
    if product >= W::nothing() || whole.is_nothing() {
        return None;
    }
    // Times |a|²: |a|² b - (a·b) a.
    let column = |(a, b): (&Vec<W>, &Vec<W>)| -> BigInt {
        let part = |(x, y): (&W, &W)| -> BigInt {
            let (mut part, mut along) = (y.clone(), x.clone());
            part.multiply(&whole);
            along.multiply(&product);
            part.subtract(&along);
            let part: BigInt = part.into();
            &part * &part
        };
        a.iter().zip(b).map(part).sum()
    };
    let largest = a.iter().zip(b).map(column).max()?;
    let whole: BigInt = whole.into();
    Some(squared(largest, &whole * &whole, scale))
}

/// The least squared move of the control points behind one side that makes the
/// tangents run on with one ratio: the largest over the columns, for the side
/// where it is smaller.
pub(super) fn least_move<W: Whole>(a: &Columns<W>, b: &Columns<W>, scale: &BigUint) -> Option<Rational> {
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
pub(super) fn is_explained_by_rounding<W: Whole>(
    a: &Columns<W>,
    b: &Columns<W>,
    half: &Rational,
    joint_moves: bool,
    lambda: Option<&Rational>,
) -> bool {
    let slack = if joint_moves { half * Rational::from(2) } else { half.clone() };
    let (slack, unit) = (slack.numer(), slack.denom());
    // Products of two of these numbers must fit.
    let bits = a.iter().chain(b).flatten().map(Whole::bits).max().unwrap_or(0) + unit.bits();
    if lambda.is_none()
        && bits.max(slack.bits()) < 62
        && let (Some(slack), Some(unit)) = (i128::of_big(&slack), i128::of_big(&unit))
    {
        let narrow = |columns: &Columns<W>| {
            columns.iter().map(|column| column.iter().map(|number| i128::from(number.shifted(0))).collect()).collect()
        };
        return has_ratio::<i128>(&narrow(a), &narrow(b), &slack, &unit, None);
    }
    let wide = |columns: &Columns<W>| columns.iter().map(|column| column.iter().cloned().map(Into::into).collect()).collect();
    has_ratio::<BigInt>(&wide(a), &wide(b), &slack, &unit, lambda)
}

fn has_ratio<W: Whole>(a: &Columns<W>, b: &Columns<W>, slack: &W, unit: &W, lambda: Option<&Rational>) -> bool {
    let zero = W::nothing();
    let negative = |number: &W| {
        let mut opposite = W::nothing();
        opposite.subtract(number);
        opposite
    };
    // low <= λ <= high, as fractions with positive denominators; high may be infinite.
    let mut low = (W::nothing(), W::unit());
    let mut high: Option<(W, W)> = None;
    let less = |x: &(W, W), y: &(W, W)| {
        let (mut left, mut right) = (x.0.clone(), y.0.clone());
        left.multiply(&y.1);
        right.multiply(&x.1);
        left < right
    };
    for (x, y) in a.iter().flatten().zip(b.iter().flatten()) {
        let (mut x, mut y) = (x.clone(), y.clone());
        x.multiply(unit);
        y.multiply(unit);
        for (x, y) in [(x.clone(), y.clone()), (negative(&x), negative(&y))] {
            // ±(y + λ x) - slack (1 + λ) <= 0, that is constant + λ factor <= 0.
            let (mut constant, mut factor) = (y, x);
            constant.subtract(slack);
            factor.subtract(slack);
            match factor.cmp(&zero) {
                Ordering::Equal if constant > zero => return false,
                Ordering::Equal => {}
                Ordering::Greater => {
                    let bound = (negative(&constant), factor);
                    if high.as_ref().is_none_or(|high| less(&bound, high)) {
                        high = Some(bound);
                    }
                }
                Ordering::Less => {
                    let bound = (constant, negative(&factor));
                    if less(&low, &bound) {
                        low = bound;
                    }
                }
            }
        }
    }
    if let Some((numer, denom)) = lambda.and_then(|lambda| Some((W::of_big(&lambda.numer())?, W::of_big(&lambda.denom())?))) {
        let lambda = (numer, denom);
        return !less(&lambda, &low) && high.as_ref().is_none_or(|high| !less(high, &lambda));
    }
    high.as_ref().is_none_or(|high| high.0 > zero && !less(high, &low))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn columns(points: &[&[i64]]) -> Columns<BigInt> {
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
        assert!(explained(&[10, 3], &[-20, -8], half()));
        assert!(!explained(&[10, 3], &[-20, -9], half()));
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
