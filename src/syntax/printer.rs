//! Mathematics back to text.
//!
//! What is printed as [`Style::Text`] or [`Style::Latex`] is read back as the
//! same value by the parsers of this module.

use std::collections::BTreeMap;

use num_traits::{One, Signed};

use super::latex;
use crate::exact::Rational;
use crate::symbolic::{Monomial, Polynomial, Symbol};

/// The notation that is printed.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Default)]
pub enum Style {
    /// Plain text: `3/4 t1^2`.
    #[default]
    Text,
    /// LaTeX: `\frac{3}{4} t_{1}^{2}`.
    Latex,
    /// Mathematica input: `3/4 t1^2`, and `{a, b}` for points.
    Mathematica,
}

/// A number: `-7/3`, or `-\frac{7}{3}`.
#[must_use]
pub fn rational(value: &Rational, style: Style) -> String {
    match style {
        Style::Text | Style::Mathematica => value.to_string(),
        Style::Latex if value.is_integer() => value.to_string(),
        Style::Latex => {
            let sign = if value.is_negative() { "-" } else { "" };
            format!("{sign}\\frac{{{}}}{{{}}}", value.abs().numer(), value.denom())
        }
    }
}

/// A symbol: `t1`, or `t_{1}` and `\lambda`.
#[must_use]
pub fn symbol(symbol: Symbol, style: Style) -> String {
    match (symbol.radicand(), style) {
        (Some(prime), Style::Latex) => return format!("\\sqrt{{{prime}}}"),
        (Some(prime), Style::Mathematica) => return format!("Sqrt[{prime}]"),
        (_, Style::Text | Style::Mathematica) => return symbol.to_string(),
        (None, Style::Latex) => {}
    }
    let letter = latex::greek_name(symbol.letter()).map_or_else(|| symbol.letter().to_string(), |name| format!("\\{name}"));
    match symbol.index() {
        None => letter,
        Some(index) => format!("{letter}_{{{index}}}"),
    }
}

fn power(base: Symbol, exponent: u32, style: Style) -> String {
    let base = symbol(base, style);
    match (exponent, style) {
        (1, _) => base,
        (_, Style::Latex) => format!("{base}^{{{exponent}}}"),
        (_, Style::Text | Style::Mathematica) => format!("{base}^{exponent}"),
    }
}

/// A product of powers in the given order; empty for 1.
fn powers(factors: impl IntoIterator<Item = (Symbol, u32)>, style: Style) -> String {
    let factors: Vec<String> = factors.into_iter().map(|(base, exponent)| power(base, exponent, style)).collect();
    factors.join(" ")
}

/// A polynomial in roots of numbers and other symbols, the terms without roots
/// first, and products of roots under one sign: `1/2 + 1/2 √5`.
#[cfg(feature = "cli")]
pub(crate) fn roots_last(value: &Polynomial, style: Style) -> String {
    let mut terms: Vec<(Vec<u32>, Monomial, Rational)> = value
        .terms()
        .map(|(monomial, number)| {
            let primes = monomial.factors().iter().filter_map(|(symbol, _)| symbol.radicand()).collect();
            let rest = monomial.factors().iter().copied().filter(|(symbol, _)| symbol.radicand().is_none());
            (primes, Monomial::from_factors(rest), number.clone())
        })
        .collect();
    terms.sort_by(|a, b| b.1.cmp(&a.1).then_with(|| a.0.cmp(&b.0)));
    let mut text = Terms::new(style);
    for (primes, rest, number) in terms {
        let radicand: num_bigint::BigUint = primes.iter().copied().map(num_bigint::BigUint::from).product();
        let root = match (primes.is_empty(), style) {
            (true, _) => String::new(),
            (_, Style::Text) => format!("√{radicand}"),
            (_, Style::Latex) => format!("\\sqrt{{{radicand}}}"),
            (_, Style::Mathematica) => format!("Sqrt[{radicand}]"),
        };
        text.push_term(&number, &rest, &root);
    }
    text.finish()
}

/// A point: `(a, b)`, or `{a, b}` for Mathematica.
#[must_use]
pub fn point(coordinates: &[String], style: Style) -> String {
    let inside = coordinates.join(", ");
    match style {
        Style::Text => format!("({inside})"),
        Style::Latex if inside.contains("\\frac") => format!("\\left({inside}\\right)"),
        Style::Latex => format!("({inside})"),
        Style::Mathematica => format!("{{{inside}}}"),
    }
}

/// A polynomial by the powers of its main symbols, the highest total degree
/// first, equal ones by the first main symbol; the other symbols are in the
/// coefficients: `(a + b) t^2 + 1/2 b t`.
#[must_use]
pub fn polynomial(value: &Polynomial, main: &[Symbol], style: Style) -> String {
    type Term = (Monomial, Rational);
    // By the exponents of the main symbols, behind their sum, which decides first.
    let mut groups: BTreeMap<(u64, Vec<u32>), Vec<Term>> = BTreeMap::new();
    for (monomial, coefficient) in value.terms() {
        let exponents: Vec<u32> = main.iter().map(|&symbol| monomial.degree_in(symbol)).collect();
        let total = exponents.iter().map(|&exponent| u64::from(exponent)).sum();
        let rest = monomial.factors().iter().copied().filter(|factor| !main.contains(&factor.0));
        groups.entry((total, exponents)).or_default().push((Monomial::from_factors(rest), coefficient.clone()));
    }
    let mut text = Terms::new(style);
    for ((_, exponents), coefficient) in groups.into_iter().rev() {
        let factors = main.iter().copied().zip(exponents).filter(|factor| factor.1 > 0);
        text.push(&Polynomial::from_terms(coefficient), &powers(factors, style));
    }
    text.finish()
}

/// A linear combination of groups, each a coefficient and the monomials that
/// share it: `1/4 (t1 t2 + t1 t3 + t2 t3) - 9/4`. The empty monomial is 1.
/// Groups with coefficient zero or without monomials are left out.
#[must_use]
pub fn sum(terms: &[(Polynomial, Vec<Monomial>)], style: Style) -> String {
    let mut text = Terms::new(style);
    for (coefficient, monomials) in terms {
        let products: Vec<String> = monomials.iter().map(|monomial| powers(monomial.factors().iter().copied(), style)).collect();
        match products.as_slice() {
            [] => {}
            [single] => text.push(coefficient, single),
            several => {
                let shown: Vec<&str> = several.iter().map(|product| if product.is_empty() { "1" } else { product.as_str() }).collect();
                text.push(coefficient, &format!("({})", shown.join(" + ")));
            }
        }
    }
    text.finish()
}

/// A sum in the making.
struct Terms {
    text: String,
    style: Style,
}

impl Terms {
    fn new(style: Style) -> Self {
        Self { text: String::new(), style }
    }

    /// Adds `coefficient · factor`; the empty factor is 1.
    fn push(&mut self, coefficient: &Polynomial, factor: &str) {
        let mut terms = coefficient.terms();
        match (terms.next(), terms.next()) {
            (None, _) => {}
            (Some((monomial, number)), None) => self.push_term(number, monomial, factor),
            _ if factor.is_empty() => coefficient.terms().for_each(|(monomial, number)| self.push_term(number, monomial, "")),
            (Some((_, leading)), Some(_)) => {
                let negative = leading.is_negative();
                let mut inside = Self::new(self.style);
                inside.push(&if negative { -coefficient } else { coefficient.clone() }, "");
                self.push_sign(negative);
                self.text.push_str(&format!("({}) {factor}", inside.text));
            }
        }
    }

    fn push_term(&mut self, number: &Rational, monomial: &Monomial, factor: &str) {
        self.push_sign(number.is_negative());
        let size = number.abs();
        let product = powers(monomial.factors().iter().copied(), self.style);
        let number = if size.is_one() && !(product.is_empty() && factor.is_empty()) { String::new() } else { rational(&size, self.style) };
        let parts = [number.as_str(), product.as_str(), factor];
        let parts: Vec<&str> = parts.into_iter().filter(|part| !part.is_empty()).collect();
        self.text.push_str(&parts.join(" "));
    }

    fn push_sign(&mut self, negative: bool) {
        self.text.push_str(match (self.text.is_empty(), negative) {
            (true, false) => "",
            (true, true) => "-",
            (false, false) => " + ",
            (false, true) => " - ",
        });
    }

    fn finish(self) -> String {
        if self.text.is_empty() { "0".to_owned() } else { self.text }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::syntax::parse_scalar;
    use proptest::prelude::*;

    const SYMBOLS: [Symbol; 6] = [
        Symbol::new('t', None),
        Symbol::new('u', None),
        Symbol::new('e', Some(12)),
        Symbol::new('t', Some(1)),
        Symbol::new('λ', None),
        Symbol::new('Ω', Some(0)),
    ];

    fn any_polynomial() -> impl Strategy<Value = Polynomial> {
        let factor = (0usize..6, 0u32..13);
        let term = (proptest::collection::vec(factor, 0..4), -30i64..30, 1i64..9);
        proptest::collection::vec(term, 0..7).prop_map(|terms| {
            Polynomial::from_terms(terms.into_iter().map(|(factors, numer, denom)| {
                (Monomial::from_factors(factors.into_iter().map(|(place, power)| (SYMBOLS[place], power))), Rational::new(numer, denom))
            }))
        })
    }

    fn read(text: &str) -> Polynomial {
        match parse_scalar(text) {
            Ok(value) => value,
            Err(error) => panic!("{text}: {error}"),
        }
    }

    proptest! {
        #[test]
        fn printed_polynomials_are_read_back(value in any_polynomial(), main in 0usize..4) {
            for style in [Style::Text, Style::Latex] {
                let text = polynomial(&value, &SYMBOLS[..main], style);
                prop_assert_eq!(&read(&text), &value, "{}", text);
            }
            prop_assert_eq!(&read(&value.to_string()), &value);
            prop_assert_eq!(value.to_string(), polynomial(&value, &value.symbols(), Style::Text));
        }

        #[test]
        fn printed_sums_are_read_back(parts in proptest::collection::vec((any_polynomial(), any_polynomial()), 0..4)) {
            let terms: Vec<(Polynomial, Vec<Monomial>)> =
                parts.into_iter().map(|(c, p)| (c, p.terms().map(|term| term.0.clone()).collect())).collect();
            let value = terms.iter().fold(Polynomial::default(), |sum, (c, monomials)| {
                sum + c * &Polynomial::from_terms(monomials.iter().map(|monomial| (monomial.clone(), Rational::one())))
            });
            for style in [Style::Text, Style::Latex] {
                let text = sum(&terms, style);
                prop_assert_eq!(&read(&text), &value, "{}", text);
            }
        }
    }

    #[test]
    fn polynomials() {
        let t = Symbol::new('t', None);
        let (u, v) = (Symbol::new('u', None), Symbol::new('v', None));
        for (source, main, text, tex) in [
            ("0", vec![t], "0", "0"),
            ("-9/4 t + 3/4 t^3 - 3/2 t^2", vec![t], "3/4 t^3 - 3/2 t^2 - 9/4 t", r"\frac{3}{4} t^{3} - \frac{3}{2} t^{2} - \frac{9}{4} t"),
            ("c + b t + a t^2", vec![t], "a t^2 + b t + c", "a t^{2} + b t + c"),
            ("(a + b) t^2 + b t/2", vec![t], "(a + b) t^2 + 1/2 b t", r"(a + b) t^{2} + \frac{1}{2} b t"),
            ("(b - a) t + a - b", vec![t], "-(a - b) t + a - b", "-(a - b) t + a - b"),
            ("-t^2", vec![t], "-t^2", "-t^{2}"),
            ("-1/2", vec![t], "-1/2", r"-\frac{1}{2}"),
            ("1", vec![t], "1", "1"),
            ("v^2 + u v + u^2 + v^3", vec![u, v], "v^3 + u^2 + u v + v^2", "v^{3} + u^{2} + u v + v^{2}"),
            ("λ t1 t_12", vec![], "t1 t12 λ", r"t_{1} t_{12} \lambda"),
        ] {
            let value = read(source);
            assert_eq!(polynomial(&value, &main, Style::Text), text, "{source}");
            assert_eq!(polynomial(&value, &main, Style::Latex), tex, "{source}");
            assert_eq!(polynomial(&value, &main, Style::Mathematica), text, "{source}");
        }
    }

    #[test]
    fn sums() {
        let monomials = |source: &str| -> Vec<Monomial> { read(source).terms().map(|term| term.0.clone()).collect() };
        let form = [
            (read("1/4"), monomials("t1 t2 + t1 t3 + t2 t3")),
            (read("-1/2"), monomials("t1 + t2 + t3")),
            (read("-9/4"), monomials("1")),
            (read("0"), monomials("t1")),
        ];
        assert_eq!(sum(&form, Style::Text), "1/4 (t1 t2 + t1 t3 + t2 t3) - 1/2 (t1 + t2 + t3) - 9/4");
        let text = r"\frac{1}{4} (t_{1} t_{2} + t_{1} t_{3} + t_{2} t_{3}) - \frac{1}{2} (t_{1} + t_{2} + t_{3}) - \frac{9}{4}";
        assert_eq!(sum(&form, Style::Latex), text);
        for (terms, expected) in [
            (vec![("3/4", "t1 t2 t3")], "3/4 t1 t2 t3"),
            (vec![("1", "t1 t2 t3"), ("-1", "t1 + t2")], "t1 t2 t3 - (t1 + t2)"),
            (vec![("1/2 b", "t1 + t2"), ("c", "1")], "1/2 b (t1 + t2) + c"),
            (vec![("a - b", "t1 + t2"), ("a + b", "1")], "(a - b) (t1 + t2) + a + b"),
            (vec![("2", "t1"), ("1", "t1 + 1")], "2 t1 + (t1 + 1)"),
            (vec![("0", "t1")], "0"),
            (vec![], "0"),
            (vec![("1", "1")], "1"),
        ] {
            let terms: Vec<_> = terms.into_iter().map(|(c, m)| (read(c), monomials(m))).collect();
            assert_eq!(sum(&terms, Style::Text), expected);
        }
    }

    #[test]
    fn points() {
        let half = Rational::new(-1, 2);
        let coordinates = |style| [rational(&half, style), rational(&Rational::from(3), style)];
        assert_eq!(point(&coordinates(Style::Text), Style::Text), "(-1/2, 3)");
        assert_eq!(point(&coordinates(Style::Latex), Style::Latex), r"\left(-\frac{1}{2}, 3\right)");
        assert_eq!(point(&coordinates(Style::Mathematica), Style::Mathematica), "{-1/2, 3}");
    }
}
