//! The resultant of `x(t) - X` and `y(t) - Y`.

use num_bigint::{BigInt, BigUint};
use num_traits::{One, Zero};

use super::ImplicitCurve;
use crate::error::Error;
use crate::exact::Rational;
use crate::exact::univariate::{PrimeField, previous_prime};

/// What finding a prime costs, in divisions.
const PRIME_SEARCH: u64 = 1 << 15;

/// The terms of a polynomial in `X` and `Y`: exponents and coefficients.
type Terms = Vec<(usize, usize, BigInt)>;

/// The degree of a polynomial by its coefficients.
fn degree<T: Zero>(coefficients: &[T]) -> usize {
    coefficients.iter().rposition(|c| !c.is_zero()).unwrap_or(0)
}

/// How many bits the coefficients of the resultant have at most: it is a
/// determinant with `deg y` rows made of `x(t) - X` and `deg x` rows made of
/// `y(t) - Y`, and so its coefficients, taken absolutely, add up to at most the
/// product over all rows.
fn bits(f: &[BigInt], g: &[BigInt]) -> u64 {
    let norm = |list: &[BigInt]| list.iter().map(BigInt::magnitude).sum::<BigUint>() + BigUint::one();
    norm(f).bits() * degree(g) as u64 + norm(g).bits() * degree(f) as u64
}

/// Refuses curves whose equation would take too long.
pub(super) fn check(coordinates: &[Vec<Rational>; 2]) -> Result<(), Error> {
    let [f, g] = coordinates.each_ref().map(|list| Rational::clear_to_integers(list));
    let work = (degree(&f) * degree(&f).max(1) * degree(&g).max(1) * degree(&g).max(1)) as u64;
    let primes = bits(&f, &g) / 30 + 1;
    // Finding the primes, working modulo each, and putting together what was found, which grows with every one.
    let terms = ((degree(&f) + 1) * (degree(&g) + 1)) as u64;
    let steps =
        work.saturating_add(PRIME_SEARCH).saturating_mul(primes).saturating_add(primes.saturating_mul(primes).saturating_mul(terms));
    if steps > ImplicitCurve::MAX_STEPS {
        return Err(Error::TooLarge { what: "work for an implicit equation, counted in steps,", limit: ImplicitCurve::MAX_STEPS as usize });
    }
    Ok(())
}

/// The polynomial whose zeros are the points of a curve, up to a factor.
pub(super) fn equation(coordinates: &[Vec<Rational>; 2]) -> Result<Terms, Error> {
    let cleared = coordinates.each_ref().map(|list| {
        let scale = Rational::common_denominator(list);
        (Rational::clear_to_integers(list), scale)
    });
    let [(x, x_scale), (y, y_scale)] = cleared;
    // The roots of the polynomial of higher degree are summed over.
    let is_swapped = degree(&x) < degree(&y);
    let (f, g) = if is_swapped { (y, x) } else { (x, y) };
    let terms = resultant(&f[..=degree(&f)], &g[..=degree(&g)]);
    // The equation of (a x, b y) in x and y.
    Ok(terms
        .into_iter()
        .map(|(i, j, c)| {
            let (i, j) = if is_swapped { (j, i) } else { (i, j) };
            (i, j, c * x_scale.pow(i as u32) * y_scale.pow(j as u32))
        })
        .collect())
}

/// The resultant of `f(t) - X` and `g(t) - Y` with respect to `t`, up to its
/// sign, for `deg f ≥ 1` and `deg f ≥ deg g`.
fn resultant(f: &[BigInt], g: &[BigInt]) -> Terms {
    let (n, m) = (degree(f), degree(g));
    let needed = bits(f, g) + 1;
    let mut modulus = BigInt::one();
    let mut lifted: Vec<BigInt> = vec![BigInt::zero(); (n + 1) * (m + 1)];
    let mut prime = 1u64 << 31;
    while modulus.bits() <= needed {
        prime = previous_prime(prime);
        let field = PrimeField::new(prime);
        if field.reduce(&f[n]) == 0 {
            continue;
        }
        let image = modular(&field, f, g);
        let inverse = field.inverse(field.reduce(&modulus));
        for (value, residue) in lifted.iter_mut().zip(image) {
            let difference = (residue + prime - field.reduce(value)) % prime;
            *value += &modulus * BigInt::from(difference * inverse % prime);
        }
        modulus *= prime;
    }
    let half = &modulus >> 1u32;
    let symmetric = lifted.into_iter().map(|value| if value > half { value - &modulus } else { value });
    symmetric.enumerate().map(|(place, c)| (place % (m + 1), place / (m + 1), c)).collect()
}

/// The resultant modulo a prime that does not divide the leading coefficient
/// of `f`, as the coefficients of `X^i Y^j` at `j (m + 1) + i`:
/// `f_n^m ∏ (Y - g(α))` over the roots `α` of `f - X`, from the power sums of
/// the `α`, of the `g(α)`, and Newton's identities. All of these are
/// polynomials in `X`.
fn modular(field: &PrimeField, f: &[BigInt], g: &[BigInt]) -> Vec<u64> {
    let (n, m, p) = (degree(f), degree(g), field.prime());
    let f: Vec<u64> = f.iter().map(|c| field.reduce(c)).collect();
    let g: Vec<u64> = g.iter().map(|c| field.reduce(c)).collect();
    let inverse = field.inverse(f[n]);
    let negative = |value: u64| if value == 0 { 0 } else { p - value };
    // s_j = Σ α^j, of degree j/n in X.
    let mut sums: Vec<Vec<u64>> = vec![vec![n as u64 % p]];
    for j in 1..=n * m {
        let mut sum = vec![0u64; j / n + 1];
        for k in 1..=j.min(n) {
            // f_{n-k} s_{j-k}, where s_0 counts as j in the first n identities.
            let other = &sums[j - k];
            let scale = |value: u64| if j == k { (j as u64 % p) * f[n - k] % p } else { value * f[n - k] % p };
            for (place, &value) in other.iter().enumerate() {
                sum[place] = (sum[place] + scale(value)) % p;
            }
            if k == n {
                // The constant term of f - X.
                for (place, &value) in other.iter().enumerate() {
                    let value = if j == k { j as u64 % p } else { value };
                    sum[place + 1] = (sum[place + 1] + negative(value)) % p;
                }
            }
        }
        sums.push(sum.into_iter().map(|value| negative(value * inverse % p)).collect());
    }
    // q_k = Σ g(α)^k
    let mut power = vec![1u64];
    let mut powers: Vec<Vec<u64>> = vec![Vec::new()];
    for _ in 1..=n {
        let mut next = vec![0u64; power.len() + m];
        for (i, &a) in power.iter().enumerate() {
            for (j, &b) in g.iter().enumerate() {
                next[i + j] = (next[i + j] + a * b) % p;
            }
        }
        power = next;
        let mut sum = vec![0u64; m + 1];
        for (weight, part) in power.iter().zip(&sums) {
            for (place, &value) in part.iter().enumerate() {
                sum[place] = (sum[place] + weight * value) % p;
            }
        }
        powers.push(sum);
    }
    // k e_k = q_1 e_{k-1} - q_2 e_{k-2} + …
    let mut elementary: Vec<Vec<u64>> = vec![vec![1u64]];
    for k in 1..=n {
        let mut sum = vec![0u64; m + 1];
        for i in 1..=k {
            for (a, &x) in elementary[k - i].iter().enumerate() {
                let x = if i % 2 == 1 { x } else { negative(x) };
                for (b, &y) in powers[i].iter().enumerate().take(m + 1 - a.min(m)) {
                    sum[a + b] = (sum[a + b] + x * y) % p;
                }
            }
        }
        let inverse = field.inverse(k as u64);
        elementary.push(sum.into_iter().map(|value| value * inverse % p).collect());
    }
    let leading = (0..m).fold(1, |product, _| product * f[n] % p);
    let mut result = vec![0u64; (n + 1) * (m + 1)];
    for (k, polynomial) in elementary.iter().enumerate() {
        for (i, &value) in polynomial.iter().enumerate() {
            let value = value * leading % p;
            result[(n - k) * (m + 1) + i] = if k % 2 == 0 { value } else { negative(value) };
        }
    }
    result
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::symbolic::{Monomial, Polynomial, Symbol};
    use proptest::prelude::*;

    /// The slow twin: the determinant of Sylvester's matrix, expanded along its first row.
    fn determinant(matrix: &[Vec<Polynomial>]) -> Polynomial {
        let Some((first, rest)) = matrix.split_first() else { return Polynomial::from(Rational::from(1)) };
        let mut sum = Polynomial::default();
        for (column, entry) in first.iter().enumerate().filter(|(_, entry)| !entry.is_empty()) {
            let minor: Vec<Vec<Polynomial>> =
                rest.iter().map(|row| row.iter().enumerate().filter(|(k, _)| *k != column).map(|(_, e)| e.clone()).collect()).collect();
            let term = entry * &determinant(&minor);
            if column % 2 == 0 { sum += &term } else { sum -= &term }
        }
        sum
    }

    fn sylvester(f: &[BigInt], g: &[BigInt]) -> Polynomial {
        let [x, y] = ['x', 'y'].map(|letter| Polynomial::from(Symbol::new(letter, None)));
        let row = |list: &[BigInt], minus: &Polynomial| {
            let mut row: Vec<Polynomial> = list.iter().map(|c| Polynomial::from(Rational::from(c.clone()))).collect();
            row[0] = &row[0] - minus;
            row
        };
        let (n, m) = (f.len() - 1, g.len() - 1);
        let mut matrix = Vec::new();
        for (list, count) in [(row(f, &x), m), (row(g, &y), n)] {
            for shift in 0..count {
                let mut line = vec![Polynomial::default(); n + m];
                line[shift..shift + list.len()].clone_from_slice(&list);
                matrix.push(line);
            }
        }
        determinant(&matrix)
    }

    fn coefficients(degree: usize) -> impl Strategy<Value = Vec<BigInt>> {
        let number = prop_oneof![6 => -5i64..6, 1 => any::<i64>()];
        prop::collection::vec(number, degree + 1).prop_map(|mut list| {
            if let Some(last) = list.last_mut().filter(|last| **last == 0) {
                *last = 1;
            }
            list.into_iter().map(BigInt::from).collect()
        })
    }

    proptest! {
        #![proptest_config(ProptestConfig { cases: 64, ..ProptestConfig::default() })]

        #[test]
        fn power_sums_give_the_determinant(
            (f, g) in (1usize..4).prop_flat_map(|n| (coefficients(n), (0..=n).prop_flat_map(coefficients))),
        ) {
            let [x, y] = ['x', 'y'].map(|letter| Symbol::new(letter, None));
            let found = Polynomial::from_terms(resultant(&f, &g).into_iter().map(|(i, j, c)| {
                (Monomial::from_factors([(x, i as u32), (y, j as u32)].into_iter().filter(|factor| factor.1 > 0)), Rational::from(c))
            }));
            let expected = sylvester(&f, &g);
            prop_assert!(found == expected || found == -&expected, "{} and {}", found, expected);
        }
    }
}
