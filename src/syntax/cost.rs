//! What multiplying out costs, known before it is done.

use num_traits::{One, Signed, Zero};

use super::limits::{MAX_BITS, MAX_DEGREE, MAX_TERMS, number_cost};
use super::parser::Parser;
use super::{Span, SyntaxError};
use crate::exact::{MAX_DIGITS, Rational};
use crate::symbolic::Polynomial;

/// What the cost of a multiplication depends on.
struct Shape {
    terms: u64,
    /// Symbols of the longest monomial.
    symbols: u64,
    /// By how many bits a factor of this shape can lengthen the coefficients of
    /// a product, brought to one denominator; 0 for a single monomial.
    bits: u64,
    integers: bool,
}

/// The bits by which a factor lengthens a product.
fn growth(value: &Rational) -> u64 {
    if value.abs().is_one() { 0 } else { value.bits() }
}

impl Parser<'_> {
    pub(crate) fn multiply(&mut self, a: &Polynomial, b: &Polynomial, span: Span) -> Result<Polynomial, SyntaxError> {
        if a.is_zero() || b.is_zero() {
            return Ok(Polynomial::zero());
        }
        check_degree(u64::from(a.total_degree()) + u64::from(b.total_degree()), span)?;
        let (s, t) = (self.shape(a, span)?, self.shape(b, span)?);
        let one = number_cost(s.bits + t.bits, s.integers && t.integers).saturating_add((s.symbols + t.symbols) / 4);
        self.budget.spend(s.terms.saturating_mul(t.terms).saturating_mul(one), span)?;
        let product = a * b;
        check_terms(product.len() as u64, span)?;
        product.terms().try_for_each(|(_, coefficient)| check_digits(coefficient, span))?;
        Ok(product)
    }

    fn shape(&mut self, value: &Polynomial, span: Span) -> Result<Shape, SyntaxError> {
        let (mut bits, mut symbols, mut integers) = (0, 0, true);
        let mut denominator = Rational::one();
        for (monomial, coefficient) in value.terms() {
            bits = bits.max(growth(coefficient));
            symbols = symbols.max(monomial.factors().len() as u64);
            if coefficient.is_integer() {
                continue;
            }
            integers = false;
            let next = coefficient.denom();
            if !(denominator.numer() % &next).is_zero() {
                self.budget.spend(number_cost(denominator.bits() + coefficient.bits(), false), span)?;
                denominator = Rational::from(num_integer::lcm(denominator.numer(), next));
                check_digits(&denominator, span)?;
            }
        }
        let terms = value.len() as u64;
        let sums = u64::from(terms.next_power_of_two().trailing_zeros());
        Ok(Shape { terms, symbols, bits: bits + growth(&denominator) + sums, integers })
    }

    /// Counts the work of a power of a polynomial that is not constant; `count` is at most [`MAX_DEGREE`].
    pub(crate) fn check_power(&mut self, base: &Polynomial, count: u32, span: Span) -> Result<(), SyntaxError> {
        let shape = self.shape(base, span)?;
        let bits = shape.bits.saturating_mul(u64::from(count));
        if shape.terms <= 2 {
            if bits > 4 * MAX_BITS {
                return Err(too_long(span));
            }
            let steps = if shape.terms == 1 { 1 } else { u64::from(count) + 1 };
            // Binomial coefficients are multiplied by short numbers only.
            let words = bits / 64;
            let one = number_cost(bits, true).saturating_add(shape.symbols) + if shape.integers { 0 } else { words * words / 128 };
            return self.budget.spend(steps.saturating_mul(one), span);
        }
        check_terms(terms_of_power(base, count), span)?;
        let mut cost = 0u64;
        for step in 1..count {
            let one = number_cost(shape.bits.saturating_mul(u64::from(step) + 1), shape.integers).saturating_add(shape.symbols / 2);
            cost = cost.saturating_add(shape.terms.saturating_mul(terms_of_power(base, step)).saturating_mul(one));
        }
        self.budget.spend(cost, span)
    }
}

/// An upper bound of the number of terms of a power: the number of products of
/// terms with repetition, and the number of monomials with its degrees,
/// whichever is less.
fn terms_of_power(base: &Polynomial, exponent: u32) -> u64 {
    const MANY: u64 = 1 << 40;
    let exponent = u64::from(exponent);
    let mut products = 1u64;
    for k in 1..base.len() as u64 {
        products = products.saturating_mul(exponent + k) / k;
        if products > MANY {
            break;
        }
    }
    let mut monomials = 1u64;
    for symbol in base.symbols() {
        monomials = monomials.saturating_mul(u64::from(base.degree_in(symbol)) * exponent + 1);
        if monomials > MANY {
            break;
        }
    }
    products.min(monomials)
}

pub(crate) fn too_long(span: Span) -> SyntaxError {
    SyntaxError::new(span, format!("found a number with more than {MAX_DIGITS} digits, expected at most {MAX_DIGITS}"))
}

pub(crate) fn check_digits(value: &Rational, span: Span) -> Result<(), SyntaxError> {
    if value.bits() <= MAX_BITS { Ok(()) } else { Err(too_long(span)) }
}

pub(crate) fn check_degree(degree: u64, span: Span) -> Result<(), SyntaxError> {
    if degree <= u64::from(MAX_DEGREE) {
        return Ok(());
    }
    Err(SyntaxError::new(span, format!("found a polynomial of degree {degree}, expected at most {MAX_DEGREE}")))
}

pub(crate) fn check_terms(terms: u64, span: Span) -> Result<(), SyntaxError> {
    if terms <= MAX_TERMS as u64 {
        return Ok(());
    }
    Err(SyntaxError::new(span, format!("found a polynomial of more than {MAX_TERMS} terms, expected at most {MAX_TERMS}")))
}
