//! Numbers `a ± √d` in the notations that mathematics is printed in.

use num_traits::{One, Signed, Zero};

use super::decimal::decimal;
use super::formula::Notation;
use crate::algebraic::AlgebraicNumber;
use crate::exact::{Rational, Surd};
use crate::symbolic::{Polynomial, Symbol};
use crate::syntax::{Style, printer};

impl Notation {
    /// A number `a ± b √n`.
    pub(super) fn surd(&self, surd: &Surd) -> String {
        let (rational, factor, radicand) = surd.printed_parts();
        if factor.is_zero() {
            return printer::rational(&rational, self.style);
        }
        let root = match self.style {
            Style::Text => format!("√{radicand}"),
            Style::Latex => format!("\\sqrt{{{radicand}}}"),
            Style::Mathematica => format!("Sqrt[{radicand}]"),
        };
        let size = factor.abs();
        let root = if size.is_one() { root } else { format!("{} {root}", printer::rational(&size, self.style)) };
        match (rational.is_zero(), factor.is_negative()) {
            (true, false) => root,
            (true, true) => format!("-{root}"),
            (false, negative) => {
                format!("{} {} {root}", printer::rational(&rational, self.style), if negative { "-" } else { "+" })
            }
        }
    }

    /// Several, as a point.
    pub(super) fn surds(&self, surds: &[Surd]) -> String {
        let texts: Vec<String> = surds.iter().map(|surd| self.surd(surd)).collect();
        printer::point(&texts, self.style)
    }

    /// The decimals of a number, if they are asked for and it is not whole.
    pub(super) fn decimals_of(&self, surds: &[Surd]) -> String {
        let Some(places) = self.decimals else { return String::new() };
        if surds.iter().all(|surd| surd.as_rational().is_some_and(Rational::is_integer)) {
            return String::new();
        }
        let texts: Vec<String> = surds.iter().map(|surd| rounded(surd, places)).collect();
        let sign = if self.style == Style::Latex { "\\approx" } else { "≈" };
        match texts.as_slice() {
            [only] => format!(" {sign} {only}"),
            several => format!(" {sign} ({})", several.join(", ")),
        }
    }

    /// A number of any degree.
    pub(super) fn algebraic(&self, number: &AlgebraicNumber, letter: Symbol) -> String {
        match number {
            AlgebraicNumber::Surd(surd) => format!("{}{}", self.surd(surd), self.decimals_of(std::slice::from_ref(surd))),
            AlgebraicNumber::Isolated(root) => {
                let coefficients: Vec<Rational> = root.polynomial().iter().cloned().map(Rational::from).collect();
                let (low, high) = root.interval();
                let [low, high] = [low, high].map(|end| printer::rational(end, self.style));
                let polynomial = self.univariate(&coefficients, letter);
                match self.style {
                    Style::Latex => format!("\\text{{the root of }} {polynomial} \\text{{ between }} {low} \\text{{ and }} {high}"),
                    Style::Text | Style::Mathematica => format!("the root of {polynomial} between {low} and {high}"),
                }
            }
        }
    }

    /// A polynomial in one letter, by its coefficients in ascending powers.
    pub(super) fn univariate(&self, coefficients: &[Rational], letter: Symbol) -> String {
        let coefficients: Vec<Polynomial> = coefficients.iter().cloned().map(Polynomial::from).collect();
        printer::polynomial(&Polynomial::from_coefficients(letter, &coefficients), &[letter], self.style)
    }

    /// An affine function `a x + b y + d` of the plane.
    pub(super) fn affine(&self, [a, b, d]: &[Rational; 3]) -> String {
        let [x, y] = ['x', 'y'].map(|letter| Symbol::new(letter, None));
        let term = |symbol: Symbol, factor: &Rational| Polynomial::from(symbol).scale(factor);
        let mut sum = term(x, a);
        sum += &term(y, b);
        sum += &Polynomial::from(d.clone());
        printer::polynomial(&sum, &[x, y], self.style)
    }
}

/// A number rounded to so many decimals.
fn rounded(surd: &Surd, places: usize) -> String {
    let mut bits = u32::try_from(4 * places + 16).unwrap_or(u32::MAX / 8);
    loop {
        let (low, high) = surd.enclosure(bits);
        let (low, high) = (decimal(&low, places), decimal(&high, places));
        if low == high {
            return low;
        }
        // Zero is approached from both sides with different signs.
        bits *= 2;
    }
}
