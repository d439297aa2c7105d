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
    let factorial: Rational = (1..=m).map(Rational::from).product();
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

/// A polynomial surface as its terms: `terms[coordinate]`, each `(h, k, c)`.
pub(crate) type Terms = Vec<Vec<(usize, usize, Rational)>>;

/// The polar value by the total degree at homogeneous arguments `(u, v, w)`, by
/// the polarization identity.
pub(crate) fn total_polarization(surface: &Terms, arguments: &[[Rational; 3]]) -> Vec<Rational> {
    let m = arguments.len();
    let factorial: Rational = (1..=m).map(Rational::from).product();
    let value = |terms: &Vec<(usize, usize, Rational)>| {
        let mut sum = zero();
        for subset in 0u32..1 << m {
            let coordinate =
                |axis: usize| (0..m).filter(|index| subset >> index & 1 == 1).map(|index| arguments[index][axis].clone()).sum::<Rational>();
            let [u, v, w] = [coordinate(0), coordinate(1), coordinate(2)];
            let homogeneous: Rational =
                terms.iter().map(|(h, k, c)| c * u.pow(*h as u32) * v.pow(*k as u32) * w.pow((m - h - k) as u32)).sum();
            if (m - subset.count_ones() as usize).is_multiple_of(2) { sum += homogeneous } else { sum -= homogeneous }
        }
        sum / &factorial
    };
    surface.iter().map(value).collect()
}

/// The polar value by the bidegree at homogeneous arguments `(t, w)`: that of a
/// curve in the first variable whose coefficients are those in the second.
pub(crate) fn tensor_polarization(surface: &Terms, us: &[(Rational, Rational)], vs: &[(Rational, Rational)]) -> Vec<Rational> {
    let value = |terms: &Vec<(usize, usize, Rational)>| {
        let mut row = vec![zero(); us.len() + 1];
        for (h, entry) in row.iter_mut().enumerate() {
            let mut inner = vec![zero(); vs.len() + 1];
            terms.iter().filter(|term| term.0 == h).for_each(|(_, k, c)| inner[*k] += c);
            *entry = polarization(&vec![inner], vs).swap_remove(0);
        }
        polarization(&vec![row], us).swap_remove(0)
    };
    surface.iter().map(value).collect()
}

/// The point of a surface by powers.
pub(crate) fn surface_value(surface: &Terms, u: &Rational, v: &Rational) -> Vec<Rational> {
    surface.iter().map(|terms| terms.iter().map(|(h, k, c)| c * u.pow(*h as u32) * v.pow(*k as u32)).sum()).collect()
}

fn factorial(n: usize) -> Rational {
    (1..=n).map(Rational::from).product()
}

/// The point of a triangular net by Bernstein polynomials.
pub(crate) fn triangular_value(degree: usize, points: &[Vec<Rational>], barycentric: &[Rational; 3]) -> Vec<Rational> {
    let mut sum = vec![zero(); points[0].len()];
    let mut points = points.iter();
    for i in 0..=degree {
        for j in 0..=degree - i {
            let k = degree - i - j;
            let [l, m, n] = barycentric;
            let weight =
                factorial(degree) / (factorial(i) * factorial(j) * factorial(k)) * l.pow(i as u32) * m.pow(j as u32) * n.pow(k as u32);
            let point = points.next().expect("a point for every index");
            sum.iter_mut().zip(point).for_each(|(total, x)| *total += x * &weight);
        }
    }
    sum
}

/// The Bernstein form of a curve on a rectangle along a segment: sums of polar
/// values over the ways to share the arguments (degree p + q).
pub(crate) fn rectangle_segment(surface: &Terms, (p, q): (usize, usize), a: &[Rational; 2], b: &[Rational; 2]) -> Vec<Vec<Rational>> {
    let binomial = |n: usize, k: usize| factorial(n) / (factorial(k) * factorial(n - k));
    let one = Rational::from(1);
    (0..=p + q)
        .map(|k| {
            let mut sum = vec![zero(); surface.len()];
            for i in k.saturating_sub(q)..=k.min(p) {
                let list = |axis: usize, degree: usize, second: usize| -> Vec<(Rational, Rational)> {
                    (0..degree).map(|place| (if place < second { b[axis].clone() } else { a[axis].clone() }, one.clone())).collect()
                };
                let value = tensor_polarization(surface, &list(0, p, i), &list(1, q, k - i));
                let weight = binomial(p, i) * binomial(q, k - i) / binomial(p + q, k);
                sum.iter_mut().zip(&value).for_each(|(total, x)| *total += x * &weight);
            }
            sum
        })
        .collect()
}

/// What a call that must panic says.
pub(crate) fn panic_message<T>(call: impl FnOnce() -> T) -> String {
    let Err(panic) = std::panic::catch_unwind(std::panic::AssertUnwindSafe(call)) else { return "no panic".into() };
    let text = panic.downcast_ref::<&str>().map(ToString::to_string);
    text.or_else(|| panic.downcast_ref::<String>().cloned()).unwrap_or_default()
}
