//! The three tasks as a C programmer would write them with FLINT: integers over a common denominator,
//! FLINT's own Taylor shift and polynomial product, one reduction to lowest terms for each number of the result.

use crate::flint::{Flint, Fmpq, Fmpz, Fractions, Integer, Integers};

/// The least common denominator of `fractions`, and their numerators over it.
unsafe fn clear_denominators(f: &'static Flint, numerators: &Integers, denominator: &mut Integer, fractions: &Fractions) {
    unsafe {
        for i in 0..fractions.len() {
            f.fmpz_lcm(denominator.at(), denominator.at(), &fractions.at(i).den);
        }
        for i in 0..fractions.len() {
            let to = numerators.at(i);
            f.fmpz_divexact(to, denominator.at(), &fractions.at(i).den);
            f.fmpz_mul(to, to, &fractions.at(i).num);
        }
    }
}

/// Multiplies the integers by 1, w, w², …, in the order in which `indices` names them. Leaves the last power in `power`.
unsafe fn scale(f: &'static Flint, integers: &Integers, indices: impl Iterator<Item = usize>, w: *const Fmpz, power: &mut Integer) {
    unsafe {
        for i in indices.skip(1) {
            f.fmpz_mul(power.at(), power.at(), w);
            f.fmpz_mul(integers.at(i), integers.at(i), power.at());
        }
    }
}

/// Divides the integers, exactly, by 1, w, w², …, in the order in which `indices` names them.
unsafe fn divide(f: &'static Flint, integers: &Integers, indices: impl Iterator<Item = usize>, w: *const Fmpz) {
    let mut power = Integer::new(f, 1);
    unsafe {
        for i in indices.skip(1) {
            f.fmpz_mul(power.at(), power.at(), w);
            f.fmpz_divexact(integers.at(i), integers.at(i), power.at());
        }
    }
}

/// From this degree on, dividing out known factors before reducing is faster.
const STRIP: usize = 16;

/// The control points over [r, s] of the polynomial with these coefficients (ascending).
///
/// With r = R/p, s = S/q and the common denominator D of the coefficients, the first shift gives Dpⁿ f((R + z)/p);
/// z = (Sp − Rq)x/q runs over [r, s] as x runs over [0, 1]; reversing and shifting by 1 turns Σ cₖxᵏ into
/// Σ C(n,j) bⱼ xʲ(1 − x)ⁿ⁻ʲ, the point bⱼ at place n − j. The denominator so far is C(n,j)Dpⁿqⁿ, but that of bⱼ divides
/// C(n,j)Dpⁿ⁻ʲqʲ: pʲqⁿ⁻ʲ can be divided out exactly.
pub fn points(f: &'static Flint, coefficients: &Fractions, r: &Fmpq, s: &Fmpq, points: &mut Fractions) {
    let length = coefficients.len();
    let n = length - 1;
    let a = Integers::new(f, length);
    let mut denominator = Integer::new(f, 1);
    let mut p_power = Integer::new(f, 1);
    let mut q_power = Integer::new(f, 1);
    let mut power = Integer::new(f, 1);
    let mut width = Integer::new(f, 0);
    let one = 1;
    // SAFETY: every pointer is to an initialised integer or fraction of ours, every index below `length`.
    unsafe {
        clear_denominators(f, &a, &mut denominator, coefficients);
        scale(f, &a, (0..length).rev(), &r.den, &mut p_power);
        f._fmpz_poly_taylor_shift(a.at(0), &r.num, length as i64);

        f.fmpz_mul(width.at(), &s.num, &r.den);
        f.fmpz_submul(width.at(), &r.num, &s.den);
        scale(f, &a, 0..length, width.at(), &mut power);
        scale(f, &a, (0..length).rev(), &s.den, &mut q_power);
        for i in 0..length / 2 {
            std::ptr::swap(a.at(i), a.at(n - i));
        }
        f._fmpz_poly_taylor_shift(a.at(0), &one, length as i64);

        f.fmpz_mul(denominator.at(), denominator.at(), p_power.at());
        let strip = n >= STRIP;
        if strip {
            divide(f, &a, 0..length, &s.den);
            divide(f, &a, (0..length).rev(), &r.den);
        } else {
            f.fmpz_mul(denominator.at(), denominator.at(), q_power.at());
        }
        for j in 0..=n {
            f.fmpq_set_fmpz_frac(points.at_mut(j), a.at(n - j), denominator.at());
            // C(n, j) becomes C(n, j + 1) inside the product.
            f.fmpz_mul_ui(denominator.at(), denominator.at(), (n - j) as u64);
            f.fmpz_divexact_ui(denominator.at(), denominator.at(), (j + 1) as u64);
            if strip {
                f.fmpz_mul(denominator.at(), denominator.at(), &s.den);
                f.fmpz_divexact(denominator.at(), denominator.at(), &r.den);
            }
        }
    }
}

/// Below this many factors multiplying them in one by one is faster.
const TREE: usize = 8;

/// The product of the factors q + pX, one for each fraction p/q.
unsafe fn product(f: &'static Flint, to: *mut Fmpz, arguments: &Fractions, first: usize, count: usize) {
    unsafe {
        if count < TREE {
            f.fmpz_set(to, &arguments.at(first).den);
            f.fmpz_set(to.add(1), &arguments.at(first).num);
            for i in 1..count {
                let Fmpq { num, den } = arguments.at(first + i);
                f.fmpz_mul(to.add(i + 1), to.add(i), num);
                for j in (1..=i).rev() {
                    f.fmpz_fmma(to.add(j), to.add(j), den, to.add(j - 1), num);
                }
                f.fmpz_mul(to, to, den);
            }
        } else {
            let half = count.div_ceil(2);
            let halves = Integers::new(f, count + 2);
            let (left, right) = (halves.at(0), halves.at(half + 1));
            product(f, left, arguments, first, half);
            product(f, right, arguments, first + half, count - half);
            f._fmpz_poly_mul(to, left, half as i64 + 1, right, (count - half) as i64 + 1);
        }
    }
}

/// The polar value f(t₁, …, tₙ) = Σ aₖ eₖ(t)/C(n,k), with tᵢ = pᵢ/qᵢ and Πqᵢ eₖ the coefficient of Xᵏ in Π(qᵢ + pᵢX).
pub fn polar_value(f: &'static Flint, coefficients: &Fractions, arguments: &Fractions, value: &mut Fractions) {
    let n = arguments.len();
    let a = Integers::new(f, n + 1);
    let e = Integers::new(f, n + 1);
    let mut denominator = Integer::new(f, 1);
    let mut weight = Integer::new(f, 1);
    let mut sum = Integer::new(f, 0);
    // SAFETY: every pointer is to an initialised integer or fraction of ours, every index at most n.
    unsafe {
        clear_denominators(f, &a, &mut denominator, coefficients);
        product(f, e.at(0), arguments, 0, n);
        f.fmpz_mul(denominator.at(), denominator.at(), e.at(0));
        // lcm of the C(n,k) = lcm(1, …, n + 1)/(n + 1); the weights lcm/C(n,k) are the same from both ends.
        for i in 2..=n as u64 + 1 {
            let common = f.n_gcd(f.fmpz_fdiv_ui(weight.at(), i), i);
            f.fmpz_mul_ui(weight.at(), weight.at(), i / common);
        }
        f.fmpz_divexact_ui(weight.at(), weight.at(), n as u64 + 1);
        f.fmpz_mul(denominator.at(), denominator.at(), weight.at());
        for k in 0..=n / 2 {
            let term = a.at(k);
            if k < n - k {
                f.fmpz_fmma(term, term, e.at(k), a.at(n - k), e.at(n - k));
            } else {
                f.fmpz_mul(term, term, e.at(k));
            }
            f.fmpz_addmul(sum.at(), term, weight.at());
            f.fmpz_mul_ui(weight.at(), weight.at(), (k + 1) as u64);
            if k < n {
                f.fmpz_divexact_ui(weight.at(), weight.at(), (n - k) as u64);
            }
        }
        f.fmpq_set_fmpz_frac(value.at_mut(0), sum.at(), denominator.at());
    }
}

/// Both halves, at t, of the curve with these control points (flat, point by point): de Casteljau's triangle over
/// one common denominator, which grows by the denominator of t from row to row.
pub fn split(f: &'static Flint, dimension: usize, polygon: &Fractions, t: &Fmpq, left: &mut Fractions, right: &mut Fractions) {
    let length = polygon.len();
    let n = length / dimension - 1;
    let row = Integers::new(f, length);
    let mut denominator = Integer::new(f, 1);
    let mut u = Integer::new(f, 0);
    // SAFETY: every pointer is to an initialised integer or fraction of ours, every index below `length`.
    unsafe {
        clear_denominators(f, &row, &mut denominator, polygon);
        f.fmpz_sub(u.at(), &t.den, &t.num);
        for c in 0..dimension {
            f.fmpq_set(left.at_mut(c), polygon.at(c));
            f.fmpq_set(right.at_mut(n * dimension + c), polygon.at(n * dimension + c));
        }
        for k in 1..=n {
            let last = (n - k) * dimension;
            for i in 0..last + dimension {
                f.fmpz_fmma(row.at(i), row.at(i), u.at(), row.at(i + dimension), &t.num);
            }
            f.fmpz_mul(denominator.at(), denominator.at(), &t.den);
            for c in 0..dimension {
                f.fmpq_set_fmpz_frac(left.at_mut(k * dimension + c), row.at(c), denominator.at());
                if k < n {
                    f.fmpq_set_fmpz_frac(right.at_mut(last + c), row.at(last + c), denominator.at());
                } else {
                    f.fmpq_set(right.at_mut(c), left.at(k * dimension + c));
                }
            }
        }
    }
}
