//! Formulas in the notations that mathematics is printed in.

use crate::affine::{Frame, Parameter, PlaneParameter};
use crate::blossom::PolarForm;
use crate::curve::Curve;
use crate::exact::Rational;
use crate::kernel::coefficient::Coefficient;
use crate::kernel::layout::multinomials;
use crate::reading::{PolarTerm, Reading};
use crate::surface::Surface;
use crate::symbolic::{Monomial, Polynomial, Symbol};
use crate::syntax::{Style, printer};
use crate::value::{Arguments, Domain, Homogeneous};
use crate::weights::projected;

/// How an answer is to be printed.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Notation {
    /// Text, LaTeX or Mathematica.
    pub style: Style,
    /// The letter of a curve's parameter.
    pub variable: Symbol,
    /// The letters of a surface's parameters.
    pub variables: [Symbol; 2],
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

    /// A notation with the parameters `t`, or `u` and `v`, and nothing added.
    #[must_use]
    pub fn new(style: Style) -> Self {
        let [t, u, v] = ['t', 'u', 'v'].map(|letter| Symbol::new(letter, None));
        Self { style, variable: t, variables: [u, v], decimals: None, expand: false }
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

    /// One coordinate of a surface as a polynomial in the parameters.
    pub(super) fn surface_coordinate<C: Coefficient>(&self, surface: &Surface<C>, index: usize) -> String {
        printer::polynomial(&surface.polynomials(self.variables)[index], &self.variables, self.style)
    }

    /// The right side of a surface's equation.
    pub(super) fn surface<C: Coefficient>(&self, surface: &Surface<C>) -> String {
        let polynomials = surface.polynomials(self.variables);
        let coordinates: Vec<String> =
            polynomials.iter().map(|polynomial| printer::polynomial(polynomial, &self.variables, self.style)).collect();
        match coordinates.as_slice() {
            [only] => only.clone(),
            _ => printer::point(&coordinates, self.style),
        }
    }

    /// A homogeneous point with its weight, `(x, y):w`; one at infinity as `[0; x, y]`.
    pub(super) fn weighted<C: Coefficient>(&self, homogeneous: &[C]) -> String {
        let Some((weight, rest)) = homogeneous.split_last() else { return String::new() };
        match projected(homogeneous) {
            Some(point) => format!("{}:{}", self.point(&point), self.number(weight)),
            None => format!("[{}; {}]", self.number(weight), rest.iter().map(|x| self.number(x)).collect::<Vec<_>>().join(", ")),
        }
    }

    /// A frame: `-1..3`, `(1,0) (0,1) (0,0)`, `0..1, 0..1`.
    pub(super) fn frame<C: Coefficient>(&self, frame: &Frame<C>) -> String {
        let numbers: Vec<String> = frame.numbers().into_iter().map(|number| self.number(number)).collect();
        match frame {
            Frame::Interval(_) => format!("{}..{}", numbers[0], numbers[1]),
            Frame::Triangle(_) => numbers.chunks(2).map(|vertex| format!("({},{})", vertex[0], vertex[1])).collect::<Vec<_>>().join(" "),
            Frame::Rectangle(_) => format!("{}..{}, {}..{}", numbers[0], numbers[1], numbers[2], numbers[3]),
        }
    }

    /// A homogenized polynomial in its letters.
    pub(super) fn homogeneous<C: Coefficient>(&self, form: &Homogeneous<C>) -> String {
        let symbols: Vec<Symbol> = form.letters.iter().map(|&letter| Symbol::new(letter, None)).collect();
        let mut sum = Vec::new();
        for (exponents, coefficient) in form.terms.iter().rev() {
            let coefficient: Polynomial = coefficient.clone().into();
            let monomial = Monomial::from_factors(symbols.iter().copied().zip(exponents.iter().map(|&exponent| exponent as u32)));
            sum.push((coefficient, vec![monomial]));
        }
        printer::sum(&sum, self.style)
    }

    /// Whether a coordinate of a polar form is written out.
    pub(super) fn writes_out<C: Coefficient>(&self, polar: &PolarForm<C>, coordinate: usize) -> bool {
        let limit = if self.expand { Self::MAX_EXPANDED_TERMS } else { Self::MAX_TERMS };
        polar.term_count(coordinate) <= Rational::from(limit)
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
        let at = self.parameters(arguments);
        match (name, at) {
            ("point", Some(at)) => Some(format!("F({at})")),
            ("value", Some(at)) if arguments.get("direction").is_some() => Some(format!("{}({at})", self.directional(arguments, order))),
            ("value", Some(at)) => Some(format!("F{prime}({at})")),
            ("value", None) => self.polar_arguments(arguments).map(|list| format!("f({list})")),
            ("derivative", _) if arguments.get("direction").is_some() => Some(format!(
                "{}({})",
                self.directional(arguments, order),
                self.variables.map(|v| printer::symbol(v, self.style)).join(",")
            )),
            ("derivative", _) => Some(format!("F{prime}({})", printer::symbol(self.variable, self.style))),
            ("curve", _) => Some(format!("F({})", printer::symbol(self.variable, self.style))),
            ("surface", _) => Some(format!("F({})", self.variables.map(|variable| printer::symbol(variable, self.style)).join(","))),
            _ => None,
        }
    }

    /// The parameters that a point is asked for at.
    fn parameters<C: Coefficient>(&self, arguments: &Arguments<C>) -> Option<String> {
        let list = |numbers: &[C]| numbers.iter().map(|number| self.number(number)).collect::<Vec<_>>().join(", ");
        match arguments.domain() {
            Domain::Curve => arguments.number("t").ok().map(|t| self.number(t)),
            _ => match (arguments.point("a"), arguments.number("u"), arguments.number("v")) {
                (Ok(a), ..) => Some(list(a)),
                (_, Ok(u), Ok(v)) => Some(list(&[u.clone(), v.clone()])),
                _ => None,
            },
        }
    }

    fn directional<C: Coefficient>(&self, arguments: &Arguments<C>, order: usize) -> String {
        let direction = arguments.point("direction").map(|direction| {
            let list: Vec<String> = direction.iter().map(|number| self.number(number)).collect();
            list.join(",")
        });
        let power = match (order, self.style) {
            (1, _) => String::new(),
            (_, Style::Latex) => format!("^{{{order}}}"),
            _ => format!("^{order}"),
        };
        match self.style {
            Style::Latex => format!("D_{{({})}}{power} F", direction.unwrap_or_default()),
            _ => format!("D[{}]{power} F", direction.unwrap_or_default()),
        }
    }

    /// The arguments of a polar value as they were given.
    fn polar_arguments<C: Coefficient>(&self, arguments: &Arguments<C>) -> Option<String> {
        let line = |list: &[Parameter<C>]| list.iter().map(|argument| self.argument(argument)).collect::<Vec<_>>().join(",");
        if let (Ok(us), Ok(vs)) = (arguments.polar_arguments("us"), arguments.polar_arguments("vs")) {
            return Some(format!("{};{}", line(us), line(vs)));
        }
        match (arguments.polar_arguments("args"), arguments.plane_arguments("args")) {
            (Ok(list), _) => Some(line(list)),
            (_, Ok(list)) => Some(list.iter().map(|argument| self.plane_argument(argument)).collect::<Vec<_>>().join(",")),
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

    fn plane_argument<C: Coefficient>(&self, PlaneParameter { u, v, w }: &PlaneParameter<C>) -> String {
        if w.is_unit() {
            format!("({},{})", self.number(u), self.number(v))
        } else {
            format!("[{}; {},{}]", self.number(w), self.number(u), self.number(v))
        }
    }

    /// The right side of one coordinate of a polar form: written out with the
    /// terms grouped by symmetric sums, or by the symmetric functions
    /// themselves where that would take too many terms. The highest come first.
    pub(super) fn polar<C: Coefficient>(&self, polar: &PolarForm<C>, coordinate: usize) -> String {
        let reading = polar.reading();
        let mut terms = polar.terms(coordinate);
        let degrees = |exponents: &[usize]| directions(reading, exponents);
        terms.sort_by_key(|(exponents, _)| std::cmp::Reverse((degrees(exponents).iter().sum::<usize>(), degrees(exponents))));
        if self.writes_out(polar, coordinate) {
            let monomials = |exponents: &[usize]| reading.terms(exponents).iter().map(|term| reading.monomial(term)).collect();
            let written: Vec<_> = terms.into_iter().map(|(exponents, c)| (c.clone().into(), monomials(&exponents))).collect();
            return printer::sum(&written, self.style);
        }
        // Behind the symmetric function stands its number of terms, so that what is left is the coefficient of the map.
        let counts = multinomials::<Rational>(&reading.shape(1));
        let places = reading.exponents();
        let mut text = String::new();
        for (exponents, coefficient) in terms {
            let coefficient: Polynomial = coefficient.clone().into();
            let count =
                places.iter().position(|place| *place == exponents).map_or_else(|| Rational::from(1), |place| counts[place].clone());
            let printed = printer::polynomial(&coefficient.scale(&count), &[], self.style);
            let several = coefficient.len() > 1;
            let sigma = self.sigma(reading, &exponents, &count);
            let (sign, size) = match printed.strip_prefix('-') {
                Some(size) if !several => ("-", size.to_owned()),
                _ if several && sigma.is_some() => ("+", format!("({printed})")),
                _ => ("+", printed),
            };
            let term = match (sigma, size.as_str()) {
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

    /// A polar form with the weights of homogeneous arguments, written out.
    pub(super) fn homogeneous_polar<C: Coefficient>(&self, polar: &PolarForm<C>, coordinate: usize) -> String {
        let reading = polar.reading();
        let monomial =
            |term: &PolarTerm| Monomial::from_factors(term.iter().map(|&(group, argument, c)| (reading.symbol(group, argument, c), 1)));
        let terms = polar.terms(coordinate).into_iter().rev();
        let written: Vec<_> =
            terms.map(|(exponents, c)| (c.clone().into(), reading.terms(&exponents).iter().map(monomial).collect())).collect();
        printer::sum(&written, self.style)
    }

    /// A symmetric function over its number of terms; nothing for the constant 1.
    fn sigma(&self, reading: Reading, exponents: &[usize], count: &Rational) -> Option<String> {
        let degrees = directions(reading, exponents);
        if degrees.iter().all(|&degree| degree == 0) {
            return None;
        }
        if let Reading::Curve(degree) = reading {
            let k = degrees[0];
            return Some(match self.style {
                Style::Latex => format!("\\sigma_{{{k}}} / \\binom{{{degree}}}{{{k}}}"),
                Style::Text => format!("σ{k}/C({degree},{k})"),
                Style::Mathematica => {
                    let symbols: Vec<String> = reading.symbols().map(|symbol| symbol.to_string()).collect();
                    format!("SymmetricPolynomial[{k}, {{{}}}]/Binomial[{degree}, {k}]", symbols.join(", "))
                }
            });
        }
        let indices = degrees.iter().map(usize::to_string).collect::<Vec<_>>().join(",");
        Some(match self.style {
            Style::Latex => format!("\\sigma_{{{indices}}} / {count}"),
            Style::Text => format!("σ({indices})/{count}"),
            Style::Mathematica => format!("\\[Sigma][{indices}]/{count}"),
        })
    }

    /// The arguments `t1,t2,…`, `(U1,V1),…` or `u1,…;v1,…` of a polar form.
    pub(super) fn arguments(&self, reading: Reading) -> String {
        let separator = if self.style == Style::Text { "," } else { ", " };
        let groups = reading.groups().into_iter().enumerate().map(|(group, (count, dimension))| {
            let shown = |argument: usize| {
                let symbols: Vec<String> =
                    (1..=dimension).map(|axis| printer::symbol(reading.symbol(group, argument, axis), self.style)).collect();
                if dimension == 1 { symbols[0].clone() } else { format!("({})", symbols.join(",")) }
            };
            if count <= 12 {
                return (1..=count).map(shown).collect::<Vec<_>>().join(separator);
            }
            let dots = if self.style == Style::Latex { "\\ldots" } else { "…" };
            [shown(1), dots.to_owned(), shown(count)].join(separator)
        });
        groups.collect::<Vec<_>>().join(if self.style == Style::Text { ";" } else { "; " })
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

/// The exponents of the coordinates of a polar term, weights left out.
fn directions(reading: Reading, exponents: &[usize]) -> Vec<usize> {
    match reading {
        Reading::Curve(_) | Reading::Total(_) => exponents[1..].to_vec(),
        Reading::Bidegree(..) => vec![exponents[1], exponents[3]],
    }
}
