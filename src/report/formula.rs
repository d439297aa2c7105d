//! Formulas in the notations that mathematics is printed in.

use crate::affine::Parameter;
use crate::blossom::{PolarForm, binomials, polar_symbol, symmetric_terms};
use crate::curve::Curve;
use crate::exact::Rational;
use crate::kernel::coefficient::Coefficient;
use crate::symbolic::{Polynomial, Symbol};
use crate::syntax::{Style, printer};
use crate::value::Arguments;

/// How an answer is to be printed.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Notation {
    /// Text, LaTeX or Mathematica.
    pub style: Style,
    /// The letter of the curve's parameter.
    pub variable: Symbol,
    /// Decimals to add to exact numbers in text.
    pub decimals: Option<usize>,
    /// Whether polar forms are written out however many terms they have.
    pub expand: bool,
}

impl Notation {
    /// The most terms of a coordinate that are written out without being asked for.
    pub const MAX_TERMS: usize = 64;
    /// The most terms of a coordinate that are ever written out.
    pub const MAX_EXPANDED_TERMS: usize = 100_000;

    /// A notation with the parameter `t` and nothing added.
    #[must_use]
    pub fn new(style: Style) -> Self {
        Self { style, variable: Symbol::new('t', None), decimals: None, expand: false }
    }

    pub(super) fn number<C: Coefficient>(&self, number: &C) -> String {
        match number.as_rational() {
            Some(number) => printer::rational(&number, self.style),
            None => printer::polynomial(&number.clone().into(), &[], self.style),
        }
    }

    /// A point; a point of a line is its number.
    pub(super) fn point<C: Coefficient>(&self, point: &[C]) -> String {
        match point {
            [only] => self.number(only),
            _ => printer::point(&point.iter().map(|coordinate| self.number(coordinate)).collect::<Vec<_>>(), self.style),
        }
    }

    /// One coordinate of a curve as a polynomial in the parameter.
    pub(super) fn coordinate<C: Coefficient>(&self, curve: &Curve<C>, index: usize) -> String {
        let coefficients: Vec<Polynomial> = curve.coordinate(index).map(|c| c.clone().into()).collect();
        printer::polynomial(&Polynomial::from_coefficients(self.variable, &coefficients), &[self.variable], self.style)
    }

    /// The right side of a curve's equation.
    pub(super) fn curve<C: Coefficient>(&self, curve: &Curve<C>) -> String {
        let coordinates: Vec<String> = (0..curve.dimension()).map(|index| self.coordinate(curve, index)).collect();
        match coordinates.as_slice() {
            [only] => only.clone(),
            _ => printer::point(&coordinates, self.style),
        }
    }

    /// Whether a coordinate of a polar form is written out.
    pub(super) fn writes_out<C: Coefficient>(&self, polar: &PolarForm<C>, coordinate: usize) -> bool {
        let limit = if self.expand { Self::MAX_EXPANDED_TERMS } else { Self::MAX_TERMS };
        polar.term_count(coordinate) <= Rational::from(limit as i64)
    }

    /// Refuses to write out a polar form of too many terms, if that was asked for.
    pub(super) fn check_expansion<C: Coefficient>(&self, polar: &PolarForm<C>) -> Result<(), String> {
        match (0..polar.dimension()).find(|&coordinate| self.expand && !self.writes_out(polar, coordinate)) {
            None => Ok(()),
            Some(coordinate) => Err(format!(
                "coordinate {} has more than {} terms, the most that are written out",
                coordinate + 1,
                Self::MAX_EXPANDED_TERMS
            )),
        }
    }

    /// What the value of an operation is the value of, such as `F(1)`, `F'(t)` or `f(1,1,2)`.
    pub(super) fn heading<C: Coefficient>(&self, arguments: &Arguments<C>, name: &str) -> Option<String> {
        let order = arguments.count("order").copied().unwrap_or(1);
        let prime = match (order, self.style) {
            (0..=3, _) => "'".repeat(order),
            (_, Style::Latex) => format!("^{{({order})}}"),
            _ => format!("^({order})"),
        };
        let at = arguments.number("t").ok().map(|t| self.number(t));
        match (name, at, arguments.polar_arguments("args")) {
            ("point", Some(t), _) => Some(format!("F({t})")),
            ("value", Some(t), _) => Some(format!("F{prime}({t})")),
            ("value", None, Ok(list)) => {
                Some(format!("f({})", list.iter().map(|argument| self.argument(argument)).collect::<Vec<_>>().join(",")))
            }
            ("derivative", ..) => Some(format!("F{prime}({})", printer::symbol(self.variable, self.style))),
            ("curve", ..) => Some(format!("F({})", printer::symbol(self.variable, self.style))),
            _ => None,
        }
    }

    fn argument<C: Coefficient>(&self, argument: &Parameter<C>) -> String {
        if argument.w.is_unit() {
            self.number(&argument.t)
        } else {
            format!("[{}; {}]", self.number(&argument.w), self.number(&argument.t))
        }
    }

    /// The right side of one coordinate of a polar form: written out with the
    /// terms grouped by symmetric sums, or by the symmetric functions
    /// themselves where that would take too many terms. The highest come first.
    pub(super) fn polar<C: Coefficient>(&self, polar: &PolarForm<C>, coordinate: usize) -> String {
        let degree = polar.degree();
        let coefficients = (0..=degree).rev().map(|k| (k, polar.coefficient(coordinate, k).clone().into()));
        let terms: Vec<(usize, Polynomial)> = coefficients.filter(|(_, coefficient)| !coefficient.is_empty()).collect();
        if self.writes_out(polar, coordinate) {
            let written: Vec<_> = terms.into_iter().map(|(k, coefficient)| (coefficient, symmetric_terms(degree, k))).collect();
            return printer::sum(&written, self.style);
        }
        // Behind σ_k stands its number of terms, so that what is left is the coefficient of t^k.
        let counts = binomials(degree);
        let mut text = String::new();
        for (k, coefficient) in terms {
            let printed = printer::polynomial(&coefficient.scale(&counts[k]), &[], self.style);
            let several = coefficient.len() > 1;
            let (sign, size) = match printed.strip_prefix('-') {
                Some(size) if !several => ("-", size.to_owned()),
                _ if several && k > 0 => ("+", format!("({printed})")),
                _ => ("+", printed),
            };
            let term = match (self.sigma(k, degree), size.as_str()) {
                (None, _) => size,
                (Some(sigma), "1") => sigma,
                (Some(sigma), _) => format!("{size} {sigma}"),
            };
            text += &match (text.is_empty(), sign) {
                (true, "-") => format!("-{term}"),
                (true, _) => term,
                _ => format!(" {sign} {term}"),
            };
        }
        if text.is_empty() { "0".to_owned() } else { text }
    }

    /// The symmetric function `σ_k` over its number of terms; nothing for `σ_0 = 1`.
    fn sigma(&self, k: usize, degree: usize) -> Option<String> {
        (k > 0).then(|| match self.style {
            Style::Latex => format!("\\sigma_{{{k}}} / \\binom{{{degree}}}{{{k}}}"),
            Style::Text => format!("σ{k}/C({degree},{k})"),
            Style::Mathematica => {
                let symbols: Vec<String> = (1..=degree).map(|index| polar_symbol(index).to_string()).collect();
                format!("SymmetricPolynomial[{k}, {{{}}}]/Binomial[{degree}, {k}]", symbols.join(", "))
            }
        })
    }

    /// The arguments `t1,t2,…` of a polar form.
    pub(super) fn arguments(&self, degree: usize) -> String {
        let separator = if self.style == Style::Text { "," } else { ", " };
        let symbols: Vec<String> = (1..=degree).map(|index| printer::symbol(polar_symbol(index), self.style)).collect();
        if degree <= 12 {
            return symbols.join(separator);
        }
        let dots = if self.style == Style::Latex { "\\ldots" } else { "…" };
        [symbols[0].as_str(), dots, symbols[degree - 1].as_str()].join(separator)
    }

    /// The letter of a map or polar form with the index of a coordinate, `F`
    /// or `f_{2}`; a map to the line has no index.
    pub(super) fn name(&self, letter: char, coordinate: usize, dimension: usize) -> String {
        match (dimension, self.style) {
            (1, _) => letter.to_string(),
            (_, Style::Latex) => format!("{letter}_{{{}}}", coordinate + 1),
            _ => format!("{letter}{}", coordinate + 1),
        }
    }
}
