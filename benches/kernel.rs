//! `cargo bench`: the operations that everything else stands on, from rationals
//! in to reduced rationals out. The race against other systems is in
//! `benches/peers/`.

use std::hint::black_box;

use casteljau::{Curve, Interval, Mesh, Piece, Rational, Reading, Rectangle, Segment, Surface, Triangle};
use criterion::{BenchmarkId, Criterion, criterion_group, criterion_main};
use num_rational::BigRational;
use num_traits::Zero;

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

/// A homogeneous polynomial in three variables: `form[i][j]` stands at the
/// exponents `(m - i - j, i, j)`.
type PlainForm = Vec<Vec<BigRational>>;

/// Substitutes `weights[vertex] x_vertex` for `x_vertex` and `x_k + weights[k] x_vertex`
/// for each of the others: the vertex is replaced, as in the kernel.
fn plain_replace(form: &mut PlainForm, vertex: usize, weights: &[BigRational; 3]) {
    let degree = form.len() - 1;
    let mut power = BigRational::from_integer(1.into());
    for exponent in 1..=degree {
        power *= &weights[vertex];
        for (i, row) in form.iter_mut().enumerate() {
            for (j, entry) in row.iter_mut().enumerate() {
                if [degree - i - j, i, j][vertex] == exponent {
                    *entry *= &power;
                }
            }
        }
    }
    for source in (0..3).filter(|&source| source != vertex) {
        // Along every line from `source` to `vertex` each pass of Horner's scheme carries one power over.
        let third = 3 - source - vertex;
        for fixed in 0..=degree {
            let at = |k: usize| {
                let mut exponents = [0; 3];
                (exponents[third], exponents[vertex], exponents[source]) = (fixed, k, degree - fixed - k);
                (exponents[1], exponents[2])
            };
            for last in (1..=degree - fixed).rev() {
                for k in 1..=last {
                    let ((from_i, from_j), (i, j)) = (at(k - 1), at(k));
                    let share = &form[from_i][from_j] * &weights[source];
                    form[i][j] += share;
                }
            }
        }
    }
}

/// The triangular net of a polynomial, one operation on `BigRational` at a time.
fn plain_net(degree: usize, terms: &[(usize, usize, BigRational)], [r, s, t]: &[[BigRational; 2]; 3]) -> Vec<BigRational> {
    let mut form: PlainForm = (0..=degree).map(|i| vec![BigRational::zero(); degree + 1 - i]).collect();
    terms.iter().for_each(|(h, k, c)| form[*h][*k] += c);
    let one = BigRational::from_integer(1.into());
    plain_replace(&mut form, 0, &[one.clone(), t[0].clone(), t[1].clone()]);
    let (a, b, c, d) = (&r[0] - &t[0], &r[1] - &t[1], &s[0] - &t[0], &s[1] - &t[1]);
    plain_replace(&mut form, 1, &[one.clone(), a.clone(), b.clone()]);
    let part = c / a;
    plain_replace(&mut form, 2, &[&one - &part, part.clone(), d - part * b]);
    let factorial = |n: usize| (1..=n).fold(one.clone(), |product, k| product * BigRational::from_integer((k as i64).into()));
    let count = |i: usize, j: usize| factorial(degree) / (factorial(i) * factorial(j) * factorial(degree - i - j));
    (0..=degree).flat_map(|i| (0..=degree - i).map(move |j| (i, j))).map(|(i, j)| &form[i][j] / count(i, j)).collect()
}

fn triangular_nets(c: &mut Criterion) {
    let mut group = c.benchmark_group("triangular net of an equation");
    let place = |a: i64, b: i64, c: i64, d: i64| [Rational::new(a, b), Rational::new(c, d)];
    let frame = Triangle::new(place(-1, 3, 7, 5), place(2, 3, -1, 2), place(3, 5, 4, 3)).expect("a frame");
    for degree in [5, 10, 20] {
        let places = (0..=degree).flat_map(|h| (0..=degree - h).map(move |k| (h, k)));
        let values = numbers((degree + 1) * (degree + 2) / 2, 1000, |_| 1000);
        let terms: Vec<_> = places.zip(values).map(|((h, k), c)| (h, k, c)).collect();
        let surface = Surface::new(Reading::Total(degree), vec![terms.clone()]).expect("a surface");
        group.bench_function(BenchmarkId::from_parameter(degree), |b| b.iter(|| black_box(&surface).over_triangle(black_box(&frame))));
        if degree <= 10 {
            let plain: Vec<_> = terms.into_iter().map(|(h, k, c)| (h, k, BigRational::from(c))).collect();
            let vertices = frame.vertices().clone().map(|vertex| vertex.map(BigRational::from));
            let net = surface.over_triangle(&frame).expect("a net");
            let expected: Vec<BigRational> = net.points().map(|point| BigRational::from(point[0].clone())).collect();
            assert_eq!(plain_net(degree, &plain, &vertices), expected);
            group.bench_function(BenchmarkId::new("BigRational step by step", degree), |b| {
                b.iter(|| plain_net(degree, black_box(&plain), black_box(&vertices)));
            });
        }
    }
}

fn meshes(c: &mut Criterion) {
    let mut group = c.benchmark_group("mesh of the monkey saddle");
    group.sample_size(10);
    let q = Rational::from;
    let saddle = vec![vec![(1, 0, q(1))], vec![(0, 1, q(1))], vec![(3, 0, q(1)), (1, 2, q(-3))]];
    let patch = Surface::tensor(saddle).and_then(|saddle| saddle.over_rectangle(&Rectangle::unit())).expect("a patch");
    for depth in [6, 8] {
        let piece = Piece::Rectangle(patch.clone());
        group.bench_function(BenchmarkId::from_parameter(depth), |b| b.iter(|| Mesh::of(black_box(&piece), false, depth)));
    }
}

criterion_group!(benches, points, polar_values, subdivision, triangular_nets, meshes);
criterion_main!(benches);
