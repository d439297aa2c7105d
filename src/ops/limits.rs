//! How much an operation may ask for, estimated before it starts.

use std::collections::{BTreeMap, BTreeSet};

use num_bigint::BigInt;

use super::table::{Growth, Operation};
use crate::error::Error;
use crate::kernel::coefficient::Coefficient;
use crate::piece::Piece;
use crate::symbolic::{Polynomial, Symbol};
use crate::syntax::limits::MAX_DEGREE;
use crate::value::{Arguments, Domain, Value};

/// The most numbers an answer may hold.
pub(crate) const MAX_NUMBERS: usize = 1 << 20;

/// The most work, in multiplications of machine words: some ten seconds.
pub(crate) const MAX_STEPS: u64 = 1 << 30;

/// What an operation on long numbers costs beside its words.
const OVERHEAD: u64 = 32;

/// What an operation on one term of a symbolic polynomial costs.
const TERM: u64 = 128;

/// The most bits of all numbers of an answer together: 128 mebibytes.
const MAX_BITS: u64 = 1 << 30;

/// The most terms of all polynomials of an answer with symbolic parameters.
const MAX_TERMS: u64 = 1 << 20;

/// The largest polar degree with symbolic parameters.
const MAX_SYMBOLIC_DEGREE: usize = 256;

/// What the arguments of an operation amount to.
#[derive(Default)]
struct Size {
    /// The polar degree of the shapes together; of rectangles, of both variables.
    degree: usize,
    /// The number of control points or coefficients of the larger shape.
    points: usize,
    dimension: usize,
    /// Bits of the longest coefficient or coordinate.
    data_bits: u64,
    /// Bits of the longest frame end, parameter or argument.
    parameter_bits: u64,
    depth: usize,
    /// The different denominators of the data: their bits together bound those of the common one.
    denominators: BTreeSet<BigInt>,
    /// The terms of all coefficients and coordinates of a shape with symbols; answers are linear in each.
    data_terms: Vec<u64>,
    /// How often each other symbol may occur as a factor of one term.
    powers: BTreeMap<Symbol, u64>,
}

impl Size {
    fn data<C: Coefficient>(&mut self, degree: usize, dimension: usize, values: &mut dyn Iterator<Item = &C>) {
        self.degree += degree;
        self.dimension = self.dimension.max(dimension);
        let (mut terms, mut is_symbolic) = (0, false);
        for value in values {
            self.data_bits = self.data_bits.max(value.bit_length());
            match value.as_rational() {
                Some(number) if number.is_integer() => terms += 1,
                Some(number) => {
                    terms += 1;
                    self.denominators.insert(number.denom());
                }
                None => {
                    let polynomial: Polynomial = value.clone().into();
                    terms += polynomial.len() as u64;
                    is_symbolic = true;
                }
            }
        }
        if is_symbolic {
            self.data_terms.push(terms);
        }
    }

    /// A number that is multiplied in up to `times` times.
    fn parameter<C: Coefficient>(&mut self, value: &C, times: usize) {
        self.parameter_bits = self.parameter_bits.max(value.bit_length());
        if value.as_rational().is_none() {
            let polynomial: Polynomial = value.clone().into();
            for symbol in polynomial.symbols() {
                *self.powers.entry(symbol).or_default() += u64::from(polynomial.degree_in(symbol)) * times as u64;
            }
        }
    }

    fn of<C: Coefficient>(arguments: &Arguments<C>) -> Self {
        let mut size = Self { parameter_bits: 1, ..Self::default() };
        let (mut raised, mut bidegree) = (0, 0);
        for (name, value) in arguments.iter() {
            match (name, value) {
                (_, Value::Curve(curve)) => {
                    let mut all = (0..curve.dimension()).flat_map(|index| curve.coordinate(index));
                    size.data(curve.degree(), curve.dimension(), &mut all);
                }
                (_, Value::Surface(surface)) => {
                    let degree = surface.reading().groups().iter().map(|group| group.0).sum();
                    size.points = size.points.max(surface.reading().points());
                    size.data(degree, surface.dimension(), &mut surface.coefficients().iter());
                }
                (_, Value::Rows(rows)) => {
                    let widest = rows.iter().map(Vec::len).max().unwrap_or(0);
                    let degree = match arguments.domain() {
                        Domain::Rectangle => rows.len() + widest,
                        _ => rows.len(),
                    };
                    let dimension = rows.first().and_then(|row| row.first()).map_or(0, Vec::len);
                    size.points = size.points.max(rows.iter().map(Vec::len).sum());
                    size.data(degree, dimension, &mut rows.iter().flatten().flatten());
                }
                (_, Value::Piece(piece)) => {
                    let degree = match piece {
                        Piece::Curve(segment) => segment.degree(),
                        Piece::Triangle(patch) => patch.degree(),
                        Piece::Rectangle(patch) => patch.degree().0 + patch.degree().1,
                    };
                    size.points += piece.points().len();
                    size.data(degree, piece.dimension(), &mut piece.coordinates().iter());
                    piece.frame().numbers().into_iter().for_each(|number| size.parameter(number, degree));
                }
                (_, Value::Points(points)) => {
                    size.data(points.len().saturating_sub(1), points.first().map_or(0, Vec::len), &mut points.iter().flatten());
                }
                ("values", Value::Numbers(values)) => size.degree += values.len(),
                ("degree", Value::Count(degree)) => raised = *degree,
                ("by", Value::Count(by)) => size.degree += by,
                ("by" | "bidegree", Value::Counts(counts)) => bidegree = counts.iter().sum(),
                ("depth", Value::Count(depth)) => size.depth = *depth,
                _ => {}
            }
        }
        if arguments.flag("midpoints") {
            size.depth = size.depth.max(1);
        }
        size.degree = match arguments.get("by") {
            Some(_) => size.degree + bidegree,
            None => size.degree.max(raised).max(bidegree),
        };
        // What a shape of that degree may have at most, and has if it is dense.
        size.points = size.points.max(match arguments.domain() {
            Domain::Curve => size.degree + 1,
            Domain::Triangle => (size.degree + 1).saturating_mul(size.degree + 2) / 2,
            // With p + q given, (p+1)(q+1) is at most this.
            Domain::Rectangle => (size.degree / 2 + 1).saturating_mul(size.degree.div_ceil(2) + 1),
        });
        size.dimension = size.dimension.max(1);
        for (_, value) in arguments.iter() {
            match value {
                Value::Numbers(values) => values.iter().for_each(|value| size.parameter(value, 1)),
                // A point of the parameter plane is taken in as often as the degree says.
                Value::Point(values) => values.iter().for_each(|value| size.parameter(value, size.degree)),
                Value::PlaneArguments(list) => {
                    list.iter().flat_map(|argument| [&argument.u, &argument.v, &argument.w]).for_each(|value| size.parameter(value, 1))
                }
                Value::Arguments(list) => {
                    list.iter().flat_map(|argument| [&argument.t, &argument.w]).for_each(|value| size.parameter(value, 1))
                }
                Value::Number(value) => size.parameter(value, size.degree),
                Value::Frame(frame) => frame.numbers().into_iter().for_each(|end| size.parameter(end, size.degree)),
                _ => {}
            }
        }
        size
    }

    /// A bound of the number of terms of one polynomial of the answer.
    fn terms(&self) -> u64 {
        let by_powers = self.powers.values().fold(1u64, |terms, power| terms.saturating_mul(power + 1));
        // The monomials of the highest degree that can occur, in so many symbols.
        let degree = self.powers.values().copied().max().unwrap_or(0).max(self.degree as u64);
        let by_degree = (1..=self.powers.len() as u64).fold(1u64, |count, k| count.saturating_mul(degree + k) / k);
        self.data_terms.iter().fold(by_powers.min(by_degree), |terms, own| terms.saturating_mul(own + 1))
    }
}

/// Refuses an operation that would take too long or too much memory.
pub(super) fn check<C: Coefficient>(operation: &Operation, arguments: &Arguments<C>) -> Result<(), Error> {
    let size = Size::of(arguments);
    let too_large = |what, limit| Err(Error::TooLarge { what, limit });
    let one = size.points.saturating_mul(size.dimension);
    let each = (size.degree as u64).saturating_add(1);
    // How many numbers there are in the answer, and how many each of them is made from.
    let (numbers, sources) = match operation.growth {
        Growth::Counted => return Ok(()),
        // Control points over a frame are made of all coefficients, whoever asks.
        Growth::Direct if arguments.get("frame").is_none() => (Some(one), 1),
        Growth::Direct | Growth::Linear => (Some(one), each),
        Growth::Basis if arguments.get("index").is_some() => (Some(one), each.saturating_mul(2)),
        Growth::Basis => (one.checked_mul(size.points), each.saturating_mul(2)),
        // Long fractions are reduced one by one, which costs more than making them.
        Growth::Scheme => (one.checked_mul(size.degree.saturating_add(2)).map(|all| all / 2), 16),
        Growth::Grid => {
            let side = u32::try_from(size.depth).ok().and_then(|depth| 2usize.checked_pow(depth)?.checked_add(1));
            (side.and_then(|side| side.checked_mul(side)?.checked_mul(size.dimension.max(3))), size.points as u64)
        }
        Growth::Doubling => {
            let parts: usize = if arguments.domain() == Domain::Curve { 2 } else { 4 };
            let pieces = u32::try_from(size.depth).ok().and_then(|depth| parts.checked_pow(depth));
            (pieces.and_then(|pieces| pieces.checked_mul(one)), each)
        }
    };
    if size.degree > MAX_DEGREE as usize {
        return too_large("degree", MAX_DEGREE as usize);
    }
    let is_symbolic = !size.data_terms.is_empty() || !size.powers.is_empty();
    if is_symbolic && size.degree > MAX_SYMBOLIC_DEGREE {
        return too_large("degree with symbolic parameters", MAX_SYMBOLIC_DEGREE);
    }
    let Some(numbers) = numbers.filter(|&numbers| numbers <= MAX_NUMBERS) else {
        return too_large("answer, counted in numbers,", MAX_NUMBERS);
    };
    // Every argument that is taken in lengthens a number by its own length, at most twice.
    let common: u64 = size.denominators.iter().map(BigInt::bits).sum();
    let bits = size.data_bits + common + size.degree as u64 * (2 * size.parameter_bits + size.depth as u64 + 1);
    if bits.saturating_mul(numbers as u64) > MAX_BITS {
        return too_large("answer, counted in bits,", MAX_BITS as usize);
    }
    if is_symbolic && size.terms().saturating_mul(numbers as u64) > MAX_TERMS {
        return too_large("answer, counted in terms with symbolic parameters,", MAX_TERMS as usize);
    }
    let steps = (numbers as u64).saturating_mul(sources).saturating_mul(bits / 64 + OVERHEAD);
    // Lowest terms over a long common denominator take a quadratic gcd each.
    let gcds = (numbers as u64).saturating_mul((common / 64).saturating_mul(common / 64));
    let steps = steps.saturating_add(gcds);
    let steps = if is_symbolic {
        // Each term of a polynomial is found and added by itself.
        let terms = (numbers as u64).saturating_mul(sources).saturating_mul(size.terms());
        steps.max(terms.saturating_mul(TERM))
    } else {
        steps
    };
    if steps > MAX_STEPS {
        return too_large("work, counted in steps on machine words,", MAX_STEPS as usize);
    }
    Ok(())
}
