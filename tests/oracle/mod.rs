//! Slow and obviously right: the definitions, on plain rational numbers.

use casteljau::Rational;

/// A polynomial curve as its coefficients: `coefficients[coordinate][power]`.
pub(crate) type Coefficients = Vec<Vec<Rational>>;

pub(crate) fn zero() -> Rational {
    Rational::from(0)
}

/// The homogeneous polynomial of degree `m` that is `F` at weight 1.
fn homogeneous(coefficients: &[Rational], m: usize, t: &Rational, w: &Rational) -> Rational {
    coefficients.iter().enumerate().map(|(power, c)| c * t.pow(power as u32) * w.pow((m - power) as u32)).sum()
}

/// The polar value at homogeneous arguments `(t, w)` by the polarization
/// identity: an alternating sum of values at the sums of all subsets.
pub(crate) fn polarization(curve: &Coefficients, arguments: &[(Rational, Rational)]) -> Vec<Rational> {
    let m = arguments.len();
    let factorial: Rational = (1..=m).map(|k| Rational::from(k as i64)).product();
    let value = |coefficients: &Vec<Rational>| {
        let mut sum = zero();
        for subset in 0u32..1 << m {
            let chosen = |index: &usize| subset >> index & 1 == 1;
            let t: Rational = (0..m).filter(chosen).map(|index| arguments[index].0.clone()).sum();
            let w: Rational = (0..m).filter(chosen).map(|index| arguments[index].1.clone()).sum();
            let term = homogeneous(coefficients, m, &t, &w);
            if (m - subset.count_ones() as usize).is_multiple_of(2) { sum += term } else { sum -= term }
        }
        sum / &factorial
    };
    curve.iter().map(value).collect()
}

/// The polar value from control points by the expansion over subsets
/// (Gallier, section 18.1): products of `(s - t_i)/(s - r)` and `(t_j - r)/(s - r)`.
pub(crate) fn subset_sum(points: &[Vec<Rational>], r: &Rational, s: &Rational, arguments: &[Rational]) -> Vec<Rational> {
    let mut sum = vec![zero(); points[0].len()];
    for subset in 0u32..1 << arguments.len() {
        let weight: Rational = arguments
            .iter()
            .enumerate()
            .map(|(index, t)| if subset >> index & 1 == 1 { (t - r) / (s - r) } else { (s - t) / (s - r) })
            .product();
        for (total, coordinate) in sum.iter_mut().zip(&points[subset.count_ones() as usize]) {
            *total += coordinate * &weight;
        }
    }
    sum
}

/// The point of a curve by powers.
pub(crate) fn value(curve: &Coefficients, t: &Rational) -> Vec<Rational> {
    curve.iter().map(|coefficients| coefficients.iter().enumerate().map(|(power, c)| c * t.pow(power as u32)).sum()).collect()
}

/// The elementary symmetric functions by all subsets.
pub(crate) fn sigma(numbers: &[Rational]) -> Vec<Rational> {
    let mut sums = vec![zero(); numbers.len() + 1];
    for subset in 0u32..1 << numbers.len() {
        let product: Rational = (0..numbers.len()).filter(|index| subset >> index & 1 == 1).map(|index| numbers[index].clone()).product();
        sums[subset.count_ones() as usize] += product;
    }
    sums
}
