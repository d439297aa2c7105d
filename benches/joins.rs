//! `cargo bench --bench joins`: the order of continuity of many pairs of nets
//! over the same frames, up to `C2`, against the same conditions on
//! `BigRational` step by step. Times are those of a thousand pairs, so
//! microseconds read as nanoseconds each.

use std::hint::black_box;

use casteljau::{Interval, Joint, Piece, Rational, Rectangle, RectangularPatch, SmoothnessTest, Surface, Triangle, TriangularPatch};
use criterion::{Criterion, Throughput, criterion_group, criterion_main};
use num_bigint::BigInt;
use num_rational::BigRational;

const COUNT: usize = 1000;

/// Reproducible numbers from `-bound` to `bound`.
fn random(bound: i64) -> impl FnMut() -> i64 {
    let mut state = 0x2545_f491_4f6c_dd1du64;
    move || {
        state ^= state << 13;
        state ^= state >> 7;
        state ^= state << 17;
        (state % (2 * bound as u64 + 1)) as i64 - bound
    }
}

fn at(u: i64, v: i64) -> [Rational; 2] {
    [Rational::from(u), Rational::from(v)]
}

type Nets<T> = [Vec<T>; 2];

/// Pairs of cubic triangles of one surface in space, so that every condition has to be looked at.
fn triangles(bound: i64) -> (SmoothnessTest, Vec<Nets<i64>>) {
    let (p, s, t, q) = (at(0, 0), at(1, 0), at(0, 1), at(2, 1));
    let frames = [Triangle::new(p, s.clone(), t.clone()), Triangle::new(q, s.clone(), t.clone())].map(|frame| frame.expect("a frame"));
    let mut next = random(bound);
    let mut pairs = Vec::new();
    let mut test = None;
    for _ in 0..COUNT {
        let points = (0..10).map(|_| (0..3).map(|_| Rational::from(next())).collect()).collect();
        let first = TriangularPatch::from_points(points, frames[0].clone()).expect("a patch");
        let second = first.reframe(&frames[1]).expect("a patch");
        pairs.push([first.net_of_words(), second.net_of_words()]);
        test.get_or_insert_with(|| {
            let (first, second) = (Piece::Triangle(first), Piece::Triangle(second));
            SmoothnessTest::new(&first, &second, &Joint::Edge([s.clone(), t.clone()]), 2).expect("they join")
        });
    }
    (test.expect("one pair"), pairs)
}

/// The same for bicubic rectangles.
fn rectangles(bound: i64) -> (SmoothnessTest, Vec<Nets<i64>>) {
    let unit = |from: i64| Interval::new(Rational::from(from), Rational::from(from + 1)).expect("a frame");
    let frames = [0, 1].map(|from| Rectangle::new(unit(from), unit(0)));
    let mut next = random(bound);
    let mut pairs = Vec::new();
    let mut test = None;
    for _ in 0..COUNT {
        let points = (0..16).map(|_| (0..3).map(|_| Rational::from(next())).collect()).collect();
        let first = RectangularPatch::from_points((3, 3), points, frames[0].clone()).expect("a patch");
        let second = first.reframe(&frames[1]).expect("a patch");
        pairs.push([first.net_of_words(), second.net_of_words()]);
        test.get_or_insert_with(|| {
            let (first, second) = (Piece::Rectangle(first), Piece::Rectangle(second));
            SmoothnessTest::new(&first, &second, &Joint::Edge([at(1, 0), at(1, 1)]), 2).expect("they join")
        });
    }
    (test.expect("one pair"), pairs)
}

trait Words {
    fn net_of_words(&self) -> Vec<i64>;
}

fn words<'a>(points: impl Iterator<Item = &'a [Rational]>) -> Vec<i64> {
    points.flatten().map(|x| i64::try_from(x.numer()).expect("a word")).collect()
}

impl Words for TriangularPatch {
    fn net_of_words(&self) -> Vec<i64> {
        words(self.points())
    }
}

impl Words for RectangularPatch {
    fn net_of_words(&self) -> Vec<i64> {
        words(self.points())
    }
}

/// The conditions of two cubic triangles as the lecture writes them, the first
/// over `p`, `s`, `t` and the second over `q`, `s`, `t`, with `q = -2p + 2s + t`;
/// one reduced fraction after the other. Rows are those of the net: `i` arguments `p`.
fn step_by_step([a, b]: &Nets<BigRational>) -> Option<usize> {
    let weights = [-2i64, 2, 1].map(|n| BigRational::from(BigInt::from(n)));
    let index = |i: usize, j: usize| (0..i).map(|row| 4 - row).sum::<usize>() + j;
    // The layers of de Casteljau's algorithm at q, where i counts p, j counts s.
    let mut layer: Vec<Vec<BigRational>> = a.chunks(3).map(<[BigRational]>::to_vec).collect();
    let mut degree = 3;
    for order in 0..=2 {
        let own = |i: usize, j: usize| (0..i).map(|row| degree + 1 - row).sum::<usize>() + j;
        for j in 0..=degree {
            if layer[own(0, j)] != b[3 * index(order, j)..3 * index(order, j) + 3] {
                return order.checked_sub(1);
            }
        }
        let step = |i: usize, j: usize| -> Vec<BigRational> {
            (0..3)
                .map(|axis| {
                    let [p, s, t] = [&layer[own(i + 1, j)][axis], &layer[own(i, j + 1)][axis], &layer[own(i, j)][axis]];
                    p * &weights[0] + s * &weights[1] + t * &weights[2]
                })
                .collect()
        };
        layer = (0..degree).flat_map(|i| (0..degree - i).map(move |j| (i, j))).map(|(i, j)| step(i, j)).collect();
        degree -= 1;
    }
    Some(2)
}

fn fractions<T: From<Rational>>(pairs: &[Nets<i64>], denominator: i64) -> Vec<Nets<T>> {
    pairs.iter().map(|pair| pair.each_ref().map(|net| net.iter().map(|&n| T::from(Rational::new(n, denominator))).collect())).collect()
}

fn joins(c: &mut Criterion) {
    let mut group = c.benchmark_group("C1 and C2 of 1000 joins of cubic triangles");
    group.throughput(Throughput::Elements(COUNT as u64));
    let (test, pairs) = triangles(1_000_000);
    let orders = |pairs: &[Nets<i64>]| pairs.iter().filter(|[a, b]| test.order(a, b) == Ok(Some(2))).count();
    assert_eq!(orders(&pairs), COUNT);
    group.bench_function("integers", |b| b.iter(|| orders(black_box(&pairs))));
    let decimals: Vec<Nets<Rational>> = fractions(&pairs, 1000);
    let of_rationals = |pairs: &[Nets<Rational>]| pairs.iter().filter(|[a, b]| test.order_of_rationals(a, b) == Ok(Some(2))).count();
    assert_eq!(of_rationals(&decimals), COUNT);
    group.bench_function("three decimals", |b| b.iter(|| of_rationals(black_box(&decimals))));
    let plain: Vec<Nets<BigRational>> = fractions(&pairs, 1000);
    let steps = |pairs: &[Nets<BigRational>]| pairs.iter().filter(|pair| step_by_step(pair) == Some(2)).count();
    assert_eq!(steps(&plain), COUNT);
    group.bench_function("three decimals, BigRational step by step", |b| b.iter(|| steps(black_box(&plain))));
    let plain: Vec<Nets<BigRational>> = fractions(&pairs, 1);
    group.bench_function("integers, BigRational step by step", |b| b.iter(|| steps(black_box(&plain))));
    group.finish();

    let mut group = c.benchmark_group("C1 and C2 of 1000 joins of bicubic rectangles");
    group.throughput(Throughput::Elements(COUNT as u64));
    let (test, pairs) = rectangles(1_000_000);
    let orders = |pairs: &[Nets<i64>]| pairs.iter().filter(|[a, b]| test.order(a, b) == Ok(Some(2))).count();
    assert_eq!(orders(&pairs), COUNT);
    group.bench_function("integers", |b| b.iter(|| orders(black_box(&pairs))));
    group.finish();
}

/// What it costs to make a test.
fn preparation(c: &mut Criterion) {
    let mut group = c.benchmark_group("preparing a test up to C2");
    let surface = Surface::total(vec![vec![(3, 0, Rational::from(1))]]).expect("a surface");
    let (s, t) = (at(1, 0), at(0, 1));
    let over = |inner| {
        let frame = Triangle::new(inner, s.clone(), t.clone()).expect("a frame");
        Piece::Triangle(surface.over_triangle(&frame).expect("a patch"))
    };
    let (first, second, joint) = (over(at(0, 0)), over(at(2, 1)), Joint::Edge([s.clone(), t.clone()]));
    group.bench_function("cubic triangles", |b| b.iter(|| SmoothnessTest::new(black_box(&first), black_box(&second), &joint, 2)));
    group.finish();
}

criterion_group!(benches, joins, preparation);
criterion_main!(benches);
