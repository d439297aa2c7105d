//! `cargo bench --bench cubics`: the classes of many cubics from arrays, against
//! the same formulas on `BigRational` step by step. Times are those of a block
//! of a thousand cubics, so microseconds read as nanoseconds each.

use std::hint::black_box;

use casteljau::{CubicClass, Rational, classify_array, classify_rationals};
use criterion::{Criterion, Throughput, criterion_group, criterion_main};
use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{Signed, Zero};

const COUNT: usize = 1000;

fn random() -> impl FnMut() -> u64 {
    let mut state = 0x2545_f491_4f6c_dd1du64;
    move || {
        state ^= state << 13;
        state ^= state >> 7;
        state ^= state << 17;
        state
    }
}

/// Polygons with coordinates of absolute values below a bound.
fn integers(bound: i64) -> Vec<[i64; 8]> {
    let mut next = random();
    (0..COUNT).map(|_| std::array::from_fn(|_| (next() % (2 * bound as u64 - 1)) as i64 - bound + 1)).collect()
}

/// The textbook's formulas, one reduced fraction after the other.
fn step_by_step(p: &[BigRational; 8]) -> CubicClass {
    let q = |n: i64| BigRational::from(BigInt::from(n));
    let coefficients = |axis: usize| -> [BigRational; 3] {
        let b = |i: usize| &p[2 * i + axis];
        [q(3) * (b(1) - b(0)), q(3) * (b(2) - q(2) * b(1) + b(0)), b(3) - q(3) * b(2) + q(3) * b(1) - b(0)]
    };
    let ([x1, x2, x3], [y1, y2, y3]) = (coefficients(0), coefficients(1));
    let kappa12 = &x1 * &y2 - &y1 * &x2;
    let kappa23 = &x2 * &y3 - &y2 * &x3;
    let kappa31 = &x3 * &y1 - &y3 * &x1;
    if !kappa23.is_zero() {
        let discriminant = q(3) * &kappa31 * &kappa31 - q(4) * &kappa12 * &kappa23;
        return if discriminant.is_zero() {
            CubicClass::Pointy
        } else if discriminant.is_positive() {
            CubicClass::Humpy
        } else {
            CubicClass::Loopy
        };
    }
    match (kappa31.is_zero(), kappa12.is_zero()) {
        (false, _) => CubicClass::SShaped,
        (true, false) => CubicClass::Parabolic,
        (true, true) => CubicClass::Straight,
    }
}

fn classes(c: &mut Criterion) {
    let mut group = c.benchmark_group("classes of 1000 cubics");
    group.throughput(Throughput::Elements(COUNT as u64));
    for (name, bound) in [("integers below 2^28", 1i64 << 28), ("integers of 32 bits", 1 << 31)] {
        let cubics = integers(bound);
        let rationals: Vec<[BigRational; 8]> = cubics.iter().map(|p| p.map(|n| BigRational::from(BigInt::from(n)))).collect();
        assert_eq!(classify_array(&cubics), rationals.iter().map(step_by_step).collect::<Vec<_>>());
        group.bench_function(name, |b| b.iter(|| classify_array(black_box(&cubics))));
        group.bench_function(format!("{name}, BigRational step by step"), |b| {
            b.iter(|| black_box(&rationals).iter().map(step_by_step).collect::<Vec<_>>());
        });
    }
    let decimals: Vec<[Rational; 8]> = integers(1_000_000).iter().map(|p| p.map(|n| Rational::new(n, 1000))).collect();
    let rationals: Vec<[BigRational; 8]> = decimals.iter().map(|p| p.clone().map(BigRational::from)).collect();
    assert_eq!(classify_rationals(&decimals), rationals.iter().map(step_by_step).collect::<Vec<_>>());
    group.bench_function("three decimals", |b| b.iter(|| classify_rationals(black_box(&decimals))));
    group.bench_function("three decimals, BigRational step by step", |b| {
        b.iter(|| black_box(&rationals).iter().map(step_by_step).collect::<Vec<_>>());
    });
    group.finish();
}

criterion_group!(benches, classes);
criterion_main!(benches);
