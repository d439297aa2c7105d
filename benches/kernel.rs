//! `cargo bench`: the operations that everything else stands on, from rationals
//! in to reduced rationals out. The race against other systems is in
//! `benches/peers/`.

use std::hint::black_box;

use casteljau::{Curve, Interval, Rational, Segment};
use criterion::{BenchmarkId, Criterion, criterion_group, criterion_main};

/// Reproducible numbers `k / denominator` with `|k| ≤ bound`.
fn numbers(count: usize, bound: i64, denominator: impl Fn(u64) -> i64) -> Vec<Rational> {
    let mut state = 0x2545_f491_4f6c_dd1du64;
    let mut next = move || {
        state ^= state << 13;
        state ^= state >> 7;
        state ^= state << 17;
        state
    };
    (0..count).map(|_| Rational::new((next() % (2 * bound as u64 + 1)) as i64 - bound, denominator(next()))).collect()
}

fn points(c: &mut Criterion) {
    let mut group = c.benchmark_group("control points of an equation over -1/3..7/5");
    let frame = Interval::new(Rational::new(-1, 3), Rational::new(7, 5)).expect("a frame");
    for degree in [3, 10, 30, 100, 1000] {
        let curve = Curve::new(vec![numbers(degree + 1, 1000, |_| 1000)]).expect("a curve");
        group.bench_function(BenchmarkId::from_parameter(degree), |b| b.iter(|| black_box(&curve).segment(black_box(&frame))));
    }
}

fn polar_values(c: &mut Criterion) {
    let mut group = c.benchmark_group("polar value of an equation");
    for degree in [3, 10, 30, 100] {
        let curve = Curve::new(vec![numbers(degree + 1, 1000, |_| 1000)]).expect("a curve");
        let arguments = numbers(degree, 255, |seed| (seed % 255) as i64 + 1);
        group.bench_function(BenchmarkId::from_parameter(degree), |b| b.iter(|| black_box(&curve).blossom(black_box(&arguments))));
    }
}

fn subdivision(c: &mut Criterion) {
    let mut group = c.benchmark_group("subdivision at 1/3 in space");
    let t = Rational::new(1, 3);
    for degree in [3, 10, 30] {
        let segment = Segment::new(3, numbers(3 * (degree + 1), 1000, |_| 1000), Interval::unit()).expect("a segment");
        group.bench_function(BenchmarkId::from_parameter(degree), |b| b.iter(|| black_box(&segment).split(black_box(&t))));
    }
}

criterion_group!(benches, points, polar_values, subdivision);
criterion_main!(benches);
