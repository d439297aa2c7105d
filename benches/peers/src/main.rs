//! casteljau and FLINT's C library side by side in one process: equal answers first, then the time of each.

mod classes;
mod data;
mod flint;
mod race;
mod rival;

use std::env;
use std::hint::black_box;

use casteljau::{Curve, Interval, Rational, Segment, classify_array};
use data::Numbers;
use flint::{Flint, Fractions};
use race::{Outcome, race};

fn main() {
    let flint = Flint::load();
    let sympy = Sympy::from_environment();
    println!("Per call, beside FLINT {}; the ratio with its quartiles over the rounds.\n", flint.version());
    println!("| task | degree | casteljau | FLINT | casteljau / FLINT | SymPy | SymPy / casteljau |");
    println!("|---|---:|---:|---:|---:|---:|---:|");
    for degree in [3, 10, 30, 100, 300, 1000] {
        points(flint, degree, sympy.as_ref());
    }
    for degree in [3, 10, 30, 100] {
        polar_value(flint, degree);
    }
    for degree in [3, 10, 30] {
        split(flint, degree);
    }
    for bits in [28, 31] {
        classes(flint, bits);
    }
}

/// Control points over [-1/3, 7/5] from the coefficients of a polynomial.
fn points(flint: &'static Flint, degree: usize, sympy: Option<&Sympy>) {
    let (curve, frame) = (curve(degree), frame());
    let coefficients = Numbers::thousandths(degree + 1).flint(flint);
    let ends = Fractions::new(flint, &[(-1, 3), (7, 5)]);
    let mut theirs = Fractions::zeros(flint, degree + 1);

    let ours = curve.segment(&frame).unwrap();
    rival::points(flint, &coefficients, ends.at(0), ends.at(1), &mut theirs);
    assert_same(ours.coordinates(), &theirs.to_strings());
    let sympy = sympy.filter(|sympy| sympy.points.len() == degree + 1);
    if let Some(sympy) = sympy {
        assert_same(ours.coordinates(), &sympy.points);
    }

    let outcome = race([
        &mut || {
            black_box(black_box(&curve).segment(&frame).unwrap().coordinates());
        },
        &mut || {
            let mut theirs = Fractions::zeros(flint, degree + 1);
            rival::points(flint, black_box(&coefficients), ends.at(0), ends.at(1), &mut theirs);
            black_box(&theirs);
        },
    ]);
    print_row("control points", degree, &outcome, sympy);
}

/// The polar value at n arguments from the coefficients of a polynomial.
fn polar_value(flint: &'static Flint, degree: usize) {
    let curve = curve(degree);
    let arguments = Numbers::eight_bits(degree);
    let (our_arguments, their_arguments) = (arguments.casteljau(), arguments.flint(flint));
    let coefficients = Numbers::thousandths(degree + 1).flint(flint);
    let mut theirs = Fractions::zeros(flint, 1);

    let ours = curve.blossom(&our_arguments).unwrap();
    rival::polar_value(flint, &coefficients, &their_arguments, &mut theirs);
    assert_same(&ours, &theirs.to_strings());

    let outcome = race([
        &mut || {
            black_box(black_box(&curve).blossom(&our_arguments).unwrap());
        },
        &mut || {
            let mut theirs = Fractions::zeros(flint, 1);
            rival::polar_value(flint, black_box(&coefficients), &their_arguments, &mut theirs);
            black_box(&theirs);
        },
    ]);
    print_row("polar value", degree, &outcome, None);
}

/// Both halves, at 1/3, of a curve in space given by its control points over [0, 1].
fn split(flint: &'static Flint, degree: usize) {
    const DIMENSION: usize = 3;
    let length = DIMENSION * (degree + 1);
    let polygon = Numbers::thousandths(length);
    let unit = Interval::new(Rational::from(0), Rational::from(1)).unwrap();
    let segment = Segment::new(DIMENSION, polygon.casteljau(), unit).unwrap();
    let our_third = Rational::new(1, 3);
    let their_third = Fractions::new(flint, &[(1, 3)]);
    let polygon = polygon.flint(flint);
    let mut left = Fractions::zeros(flint, length);
    let mut right = Fractions::zeros(flint, length);

    let halves = segment.split(&our_third).unwrap();
    rival::split(flint, DIMENSION, &polygon, their_third.at(0), &mut left, &mut right);
    assert_same(halves.0.coordinates(), &left.to_strings());
    assert_same(halves.1.coordinates(), &right.to_strings());

    let outcome = race([
        &mut || {
            let halves = black_box(&segment).split(&our_third).unwrap();
            black_box((halves.0.coordinates(), halves.1.coordinates()));
        },
        &mut || {
            let mut left = Fractions::zeros(flint, length);
            let mut right = Fractions::zeros(flint, length);
            rival::split(flint, DIMENSION, black_box(&polygon), their_third.at(0), &mut left, &mut right);
            black_box((&left, &right));
        },
    ]);
    print_row("split in space", degree, &outcome, None);
}

/// The classes of a thousand cubics from integers of so many bits and a sign.
fn classes(flint: &'static Flint, bits: u32) {
    let mut state = 0x2545_f491_4f6c_dd1du64;
    let mut next = || {
        state ^= state << 13;
        state ^= state >> 7;
        state ^= state << 17;
        (state as i64) >> (63 - bits)
    };
    let cubics: Vec<[i64; 8]> = (0..1000).map(|_| std::array::from_fn(|_| next())).collect();
    let theirs = classes::Polygons::new(flint, &cubics);
    assert_eq!(classify_array(&cubics), classes::classes(flint, &theirs));
    let outcome = race([
        &mut || {
            black_box(classify_array(black_box(&cubics)));
        },
        &mut || {
            black_box(classes::classes(flint, black_box(&theirs)));
        },
    ]);
    print_row(&format!("1000 classes from {bits}-bit integers"), 3, &outcome, None);
}

fn curve(degree: usize) -> Curve {
    Curve::new(vec![Numbers::thousandths(degree + 1).casteljau()]).unwrap()
}

fn frame() -> Interval {
    Interval::new(Rational::new(-1, 3), Rational::new(7, 5)).unwrap()
}

/// What `sympy_points.py` printed: nanoseconds a call, then the control points.
struct Sympy {
    seconds: f64,
    points: Vec<String>,
}

impl Sympy {
    fn from_environment() -> Option<Sympy> {
        let printed = env::var("SYMPY_POINTS").ok()?;
        let mut words = printed.split_whitespace().map(str::to_owned);
        let nanoseconds: f64 = words.next()?.parse().expect("SYMPY_POINTS begins with nanoseconds");
        Some(Sympy { seconds: nanoseconds * 1e-9, points: words.collect() })
    }
}

fn assert_same(ours: &[Rational], theirs: &[String]) {
    let ours: Vec<String> = ours.iter().map(Rational::to_string).collect();
    assert_eq!(ours, theirs, "casteljau (left) and its peer (right) differ");
}

fn print_row(task: &str, degree: usize, outcome: &Outcome, sympy: Option<&Sympy>) {
    let [ours, flint] = outcome.medians;
    let [low, middle, high] = outcome.ratio;
    let (sympy_time, sympy_ratio) = match sympy {
        Some(sympy) => (duration(sympy.seconds), format!("{:.0}", sympy.seconds / ours)),
        None => Default::default(),
    };
    println!(
        "| {task} | {degree} | {} | {} | **{middle:.2}** ({low:.2}–{high:.2}) | {sympy_time} | {sympy_ratio} |",
        duration(ours),
        duration(flint)
    );
}

fn duration(seconds: f64) -> String {
    match seconds {
        ..1e-6 => format!("{:.0} ns", seconds * 1e9),
        ..1e-3 => format!("{:.2} µs", seconds * 1e6),
        _ => format!("{:.2} ms", seconds * 1e3),
    }
}
