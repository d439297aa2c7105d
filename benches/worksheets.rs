//! `cargo bench --bench worksheets`: a thousand claims at degrees up to 6, all
//! worksheets of `examples/`, and the polar form of a surface of degree 8 with
//! symbolic coefficients.

use std::fmt::Write as _;
use std::hint::black_box;

use casteljau::worksheet::{Format, Report, Verdict, check};
use criterion::{Criterion, criterion_group, criterion_main};

/// A worksheet of 250 curves, with four claims on each.
fn thousand_claims() -> String {
    let mut text = String::new();
    for k in 0..250u32 {
        let degree = 2 + k % 5;
        let powers: Vec<String> = (0..=degree).map(|power| format!("{} t^{power}", 1 + (k * 7 + power * 5) % 9)).collect();
        let (name, polar) = (format!("F{}", k + 1), format!("f{}", k + 1));
        let arguments = |value: &str| vec![value; degree as usize].join(", ");
        // At 0 and at 1 a polynomial is read off; the net ends there, and halves are of the same map.
        let sum: u32 = (0..=degree).map(|power| 1 + (k * 7 + power * 5) % 9).sum();
        let _ = writeln!(text, "{name}(t) = ({}, t)", powers.join(" + "));
        let _ = writeln!(text, "{polar}({}) == ({}, 0)", arguments("0"), 1 + (k * 7) % 9);
        let _ = writeln!(text, "{polar}({}) == ({sum}, 1)", arguments("1"));
        let _ = writeln!(text, "degree({name}) == {degree}");
        let _ = writeln!(text, "derivative({name}) != {name}");
    }
    text
}

/// Every coefficient of a surface of degree 8 is a letter of its own.
fn symbolic_surface() -> String {
    let mut terms = Vec::new();
    for h in 0..=8u32 {
        for k in 0..=8 - h {
            terms.push(format!("a{} u^{h} v^{k}", 10 * h + k));
        }
    }
    // The polar form written out: every argument gives its u, its v, or 1.
    let factorial = |n: u32| (1..=n).product::<u32>();
    let mut form = Vec::new();
    for code in 0..3u32.pow(8) {
        let choices: Vec<u32> = (0..8).map(|place| code / 3u32.pow(place) % 3).collect();
        let count = |wanted: u32| choices.iter().filter(|choice| **choice == wanted).count() as u32;
        let (h, k, rest) = (count(1), count(2), count(0));
        let factors: Vec<String> = choices
            .iter()
            .zip(1..)
            .filter(|(choice, _)| **choice > 0)
            .map(|(choice, place)| format!("{}{place}", if *choice == 1 { 'u' } else { 'v' }))
            .collect();
        let number = factorial(8) / (factorial(h) * factorial(k) * factorial(rest));
        form.push(format!("1/{number} a{} {}", 10 * h + k, factors.join(" ")));
    }
    let arguments: Vec<String> = (1..=8).map(|place| format!("(u{place},v{place})")).collect();
    format!("S(u,v) = {}\ns({}) == {}\n", terms.join(" + "), arguments.join(", "), form.join(" + "))
}

fn proved(report: &Report) -> usize {
    report.claims.iter().filter(|claim| claim.verdict == Verdict::Proved).count()
}

fn worksheets(criterion: &mut Criterion) {
    let text = thousand_claims();
    assert_eq!(proved(&check(&text, Format::Statements)), 1000);
    criterion.bench_function("worksheets/a thousand claims", |bencher| bencher.iter(|| check(black_box(&text), Format::Statements)));
    let text = symbolic_surface();
    assert_eq!(proved(&check(&text, Format::Statements)), 1);
    criterion.bench_function("worksheets/a surface of degree 8", |bencher| bencher.iter(|| check(black_box(&text), Format::Statements)));
    let folder = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("examples");
    let mut all = Vec::new();
    for entry in std::fs::read_dir(folder).expect("the examples") {
        let path = entry.expect("an entry").path();
        if path.extension().is_some_and(|extension| extension == "md") {
            all.push(std::fs::read_to_string(path).expect("a worksheet"));
        }
    }
    assert!(all.iter().map(|text| proved(&check(text, Format::Markdown))).sum::<usize>() > 500);
    let every = || all.iter().map(|text| check(black_box(text), Format::Markdown).claims.len()).sum::<usize>();
    criterion.bench_function("worksheets/examples", |bencher| bencher.iter(every));
}

criterion_group!(benches, worksheets);
criterion_main!(benches);
