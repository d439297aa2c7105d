//! From expressions to polynomials, within the limits.

use num_traits::{One, Signed, Zero};

use super::cost::{check_degree, check_digits, check_terms, too_long};
use super::expression::{Expression, ExpressionKind};
use super::limits::{MAX_BITS, number_cost};
use super::literal::exponent_value;
use super::parser::Parser;
use super::printer::{self, Style};
use super::{Span, SyntaxError};
use crate::exact::Rational;
use crate::symbolic::{Monomial, Polynomial};

/// What an expression stands for.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Value {
    Scalar(Polynomial),
    /// The coordinates of a point or a vector, two or more.
    Tuple(Vec<Polynomial>),
}

impl Parser<'_> {
    /// Reads an expression and evaluates it to one polynomial.
    pub(crate) fn scalar(&mut self) -> Result<Polynomial, SyntaxError> {
        let expression = self.expression()?;
        self.evaluate_scalar(&expression)
    }

    pub(crate) fn evaluate_scalar(&mut self, expression: &Expression) -> Result<Polynomial, SyntaxError> {
        match self.evaluate(expression)? {
            Value::Scalar(value) => Ok(value),
            Value::Tuple(values) => {
                Err(SyntaxError::new(expression.span, format!("found a point with {} coordinates, expected a single value", values.len())))
            }
        }
    }

    pub(crate) fn evaluate(&mut self, expression: &Expression) -> Result<Value, SyntaxError> {
        match &expression.kind {
            ExpressionKind::Number(value) => Ok(Value::Scalar(Polynomial::from(value.clone()))),
            ExpressionKind::Symbol(symbol) => Ok(Value::Scalar(Polynomial::from(*symbol))),
            ExpressionKind::Sum(terms) => self.sum(terms, expression.span),
            ExpressionKind::Product(factors) => self.factors(factors, expression.span),
            ExpressionKind::Power(base, exponent) => self.raise(base, exponent, expression.span).map(Value::Scalar),
            ExpressionKind::Root(radicand) => self.root(radicand, expression.span).map(Value::Scalar),
            ExpressionKind::Group(inner) => self.evaluate(inner),
            ExpressionKind::Tuple(items) => {
                items.iter().map(|item| self.evaluate_scalar(item)).collect::<Result<Vec<_>, _>>().map(Value::Tuple)
            }
            ExpressionKind::Known(value) => Ok(value.clone()),
            ExpressionKind::List(_)
            | ExpressionKind::Entry(..)
            | ExpressionKind::Weighted(..)
            | ExpressionKind::Word(_)
            | ExpressionKind::Call(_) => {
                let shown = super::lexer::shorten(expression.span.text(self.source));
                Err(SyntaxError::new(expression.span, format!("found `{shown}`, expected a number, a polynomial or a point")))
            }
        }
    }

    fn sum(&mut self, terms: &[(bool, Expression)], span: Span) -> Result<Value, SyntaxError> {
        // One list of terms for each coordinate, merged once: n log n for n summands.
        let mut collected: Vec<Vec<(Monomial, Rational)>> = Vec::new();
        let mut tuple = false;
        for (place, (negative, term)) in terms.iter().enumerate() {
            let (values, is_tuple) = match self.evaluate(term)? {
                Value::Scalar(value) => (vec![value], false),
                Value::Tuple(values) => (values, true),
            };
            if place == 0 {
                collected.resize_with(values.len(), Vec::new);
                tuple = is_tuple;
            } else if tuple != is_tuple || values.len() != collected.len() {
                let describe = |tuple: bool, length: usize| {
                    if tuple { format!("a point with {length} coordinates") } else { "a single value".to_owned() }
                };
                let message = format!("found {} in a sum, expected {}", describe(is_tuple, values.len()), describe(tuple, collected.len()));
                return Err(SyntaxError::new(term.span, message));
            }
            for (list, value) in collected.iter_mut().zip(&values) {
                self.budget.spend(value.len() as u64, span)?;
                list.extend(value.terms().map(|(monomial, c)| (monomial.clone(), if *negative { -c } else { c.clone() })));
            }
        }
        let mut sums = collected.into_iter().map(|list| self.merge(list, span)).collect::<Result<Vec<_>, _>>()?;
        Ok(match (tuple, sums.pop()) {
            (false, Some(sum)) => Value::Scalar(sum),
            (_, last) => {
                sums.extend(last);
                Value::Tuple(sums)
            }
        })
    }

    /// The sum of terms, counting the cost of adding coefficients as they grow.
    fn merge(&mut self, mut terms: Vec<(Monomial, Rational)>, span: Span) -> Result<Polynomial, SyntaxError> {
        terms.sort_by(|a, b| b.0.cmp(&a.0));
        let mut merged: Vec<(Monomial, Rational)> = Vec::new();
        for (monomial, coefficient) in terms {
            match merged.last_mut() {
                Some((last, sum)) if *last == monomial => {
                    let integers = sum.is_integer() && coefficient.is_integer();
                    self.budget.spend(number_cost(sum.bits() + coefficient.bits(), integers), span)?;
                    *sum += coefficient;
                    check_digits(sum, span)?;
                }
                _ => merged.push((monomial, coefficient)),
            }
        }
        let sum = Polynomial::from_terms(merged);
        check_terms(sum.len() as u64, span)?;
        Ok(sum)
    }

    fn factors(&mut self, factors: &[(bool, Expression)], span: Span) -> Result<Value, SyntaxError> {
        // Numbers and monomials are gathered apart, so that a long row of them
        // does not pass through a long polynomial again and again.
        let mut number = Rational::one();
        let mut monomial = Monomial::one();
        let mut product: Option<Polynomial> = None;
        let mut tuple: Option<Vec<Polynomial>> = None;
        for (divided, factor) in factors {
            let value = match self.evaluate(factor)? {
                Value::Scalar(value) if *divided => match value.reciprocal() {
                    Some(root) if value.has_roots() => root,
                    _ => {
                        number = self.multiply_numbers(&number, &inverse(&value, factor.span)?, span)?;
                        continue;
                    }
                },
                Value::Tuple(_) if *divided => {
                    return Err(SyntaxError::new(factor.span, "found a point as divisor, expected a non-zero number"));
                }
                Value::Tuple(_) if tuple.is_some() => {
                    let error = SyntaxError::new(factor.span, "found a product of two points, expected at most one point in a product");
                    return Err(error.with_help("a list of points is separated by blanks or commas, with nothing else between"));
                }
                Value::Tuple(values) => {
                    tuple = Some(values);
                    continue;
                }
                Value::Scalar(value) => value,
            };
            if value.len() > 1 {
                product = Some(match product {
                    Some(product) => self.multiply(&product, &value, span)?,
                    None => value,
                });
                continue;
            }
            match value.terms().next() {
                None => number = Rational::zero(),
                Some((power, coefficient)) => {
                    number = self.multiply_numbers(&number, coefficient, span)?;
                    check_degree(u64::from(monomial.degree()) + u64::from(power.degree()), span)?;
                    self.budget.spend(monomial.factors().len() as u64 / 4, span)?;
                    monomial = &monomial * power;
                }
            }
        }
        let factor = Polynomial::term(monomial, number);
        let factor = match product {
            Some(product) => self.multiply(&product, &factor, span)?,
            None => factor,
        };
        Ok(match tuple {
            Some(values) => Value::Tuple(values.iter().map(|value| self.multiply(value, &factor, span)).collect::<Result<_, _>>()?),
            None => Value::Scalar(factor),
        })
    }

    fn multiply_numbers(&mut self, a: &Rational, b: &Rational, span: Span) -> Result<Rational, SyntaxError> {
        self.budget.spend(number_cost(a.bits() + b.bits(), a.is_integer() && b.is_integer()), span)?;
        let product = a * b;
        check_digits(&product, span)?;
        Ok(product)
    }

    fn raise(&mut self, base: &Expression, exponent: &Expression, span: Span) -> Result<Polynomial, SyntaxError> {
        let power = self.evaluate_scalar(exponent)?;
        let Some(number) = power.as_rational() else {
            let message = format!("found the exponent `{}`, expected a non-negative whole number", shown(&power));
            return Err(SyntaxError::new(exponent.span, message));
        };
        if number.is_negative() || !number.is_integer() {
            let message =
                format!("found the exponent `{}`, expected a non-negative whole number", super::lexer::shorten(&number.to_string()));
            return Err(SyntaxError::new(exponent.span, message));
        }
        let Some(count) = exponent_value(&number) else {
            return Err(SyntaxError::new(
                exponent.span,
                format!("found an exponent of {} bits, expected at most {}", number.bits(), u32::MAX),
            ));
        };
        let base = match self.evaluate(base)? {
            Value::Scalar(value) => value,
            Value::Tuple(_) => return Err(SyntaxError::new(base.span, "found a power of a point, expected a power of a single value")),
        };
        if let Some(value) = base.as_rational() {
            // |value| = p/q with p or q at least 2^(bits - 1).
            if value.bits().saturating_sub(1).saturating_mul(u64::from(count)) > MAX_BITS {
                return Err(too_long(span));
            }
            self.budget.spend(number_cost(value.bits().saturating_mul(u64::from(count)).min(2 * MAX_BITS), false), span)?;
            let result = if value.bits() <= 1 { small_power(&value, count) } else { value.pow(count) };
            check_digits(&result, span)?;
            return Ok(Polynomial::from(result));
        }
        check_degree(u64::from(base.total_degree()).saturating_mul(u64::from(count)), span)?;
        self.check_power(&base, count, span)?;
        let result = base.pow(count);
        result.terms().try_for_each(|(_, coefficient)| check_digits(coefficient, span))?;
        Ok(result)
    }

    fn root(&mut self, radicand: &Expression, span: Span) -> Result<Polynomial, SyntaxError> {
        let value = self.evaluate_scalar(radicand)?;
        let Some(value) = value.as_rational() else {
            return Err(SyntaxError::new(radicand.span, format!("found the root of `{}`, expected the root of a number", shown(&value))));
        };
        if value.is_negative() {
            return Err(SyntaxError::new(radicand.span, "found the root of a negative number, expected one that is not negative"));
        }
        self.budget.spend(number_cost(value.bits(), false), span)?;
        let (numer, denom) = (value.numer().sqrt(), value.denom().sqrt());
        if &numer * &numer != value.numer() || &denom * &denom != value.denom() {
            let shown = super::lexer::shorten(&value.to_string());
            if self.allows_roots() {
                let message = || format!("found √({shown}), whose radicand has a prime factor that is too large");
                return Polynomial::square_root(&value).ok_or_else(|| SyntaxError::new(span, message()));
            }
            return Err(SyntaxError::new(span, format!("found √({shown}), which is not rational, expected rational numbers here")));
        }
        Ok(Polynomial::from(Rational::from_big(numer, denom)))
    }
}

/// A power of 0, 1 or -1, however large the exponent.
fn small_power(value: &Rational, exponent: u32) -> Rational {
    match exponent {
        0 => Rational::one(),
        _ if value.is_negative() && exponent.is_multiple_of(2) => -value,
        _ => value.clone(),
    }
}

/// One over the value of a divisor.
fn inverse(value: &Polynomial, span: Span) -> Result<Rational, SyntaxError> {
    match value.as_rational() {
        Some(number) => {
            number.recip().ok_or_else(|| SyntaxError::new(span, "found a division by zero, expected a non-zero number as divisor"))
        }
        None => {
            let message = format!("found a division by `{}`, expected a non-zero number as divisor", shown(value));
            Err(SyntaxError::new(span, message)
                .with_help("only polynomials are possible here; a rational map has its denominator as a weight"))
        }
    }
}

/// A polynomial in a message.
fn shown(value: &Polynomial) -> String {
    if value.len() > 8 {
        format!("a polynomial of {} terms", value.len())
    } else {
        super::lexer::shorten(&printer::polynomial(value, &[], Style::Text))
    }
}
