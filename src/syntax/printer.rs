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
    if style != Style::Latex {
        return symbol.to_string();
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
    // Exponents of the main symbols, behind their sum, which decides first.
    let mut groups: BTreeMap<(u64, Vec<u32>), Vec<(Monomial, Rational)>> = BTreeMap::new();
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
