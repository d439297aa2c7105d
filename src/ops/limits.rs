//! How much an operation may ask for, estimated before it starts.

use super::table::{Growth, Operation};
use crate::error::Error;
use crate::kernel::coefficient::Coefficient;
use crate::syntax::limits::MAX_DEGREE;
use crate::value::{Arguments, Value};

/// The most numbers an answer may hold.
const MAX_NUMBERS: usize = 1 << 20;

/// The most work on machine words: some tens of seconds.
const MAX_WORD_STEPS: u64 = 1 << 34;

/// The most bits of all numbers of an answer together: half a gibibyte.
const MAX_BITS: u64 = 1 << 32;

/// The largest polar degree with symbolic parameters in coefficients or points.
const MAX_SYMBOLIC_DEGREE: usize = 256;

/// The largest polar degree with symbols in a frame, a parameter or an argument.
const MAX_SYMBOLIC_ARGUMENT_DEGREE: usize = 48;

/// What the arguments of an operation amount to.
#[derive(Default)]
struct Size {
    /// The polar degree of the shapes together.
    degree: usize,
    dimension: usize,
    /// Bits of the longest coefficient or coordinate.
    data_bits: u64,
    /// Bits of the longest frame end, parameter or argument.
    parameter_bits: u64,
    depth: usize,
    symbolic_data: bool,
    symbolic_parameter: bool,
}

impl Size {
    fn data<C: Coefficient>(&mut self, degree: usize, dimension: usize, values: &mut dyn Iterator<Item = &C>) {
        self.degree += degree;
        self.dimension = self.dimension.max(dimension);
        for value in values {
            self.data_bits = self.data_bits.max(value.bit_length());
            self.symbolic_data |= value.as_rational().is_none();
        }
    }

    fn parameter<C: Coefficient>(&mut self, value: &C) {
        self.parameter_bits = self.parameter_bits.max(value.bit_length());
        self.symbolic_parameter |= value.as_rational().is_none();
    }

    fn of<C: Coefficient>(arguments: &Arguments<C>) -> Self {
        let mut size = Self { parameter_bits: 1, ..Self::default() };
        let mut raised = 0;
        for (name, value) in arguments.iter() {
            match (name, value) {
                (_, Value::Curve(curve)) => {
                    let mut all = (0..curve.dimension()).flat_map(|index| curve.coordinate(index));
                    size.data(curve.degree(), curve.dimension(), &mut all);
                }
                (_, Value::Points(points)) => {
                    size.data(points.len().saturating_sub(1), points.first().map_or(0, Vec::len), &mut points.iter().flatten());
                }
                (_, Value::Numbers(values)) if name == "values" => size.data(values.len(), 1, &mut values.iter()),
                (_, Value::Numbers(values)) => values.iter().for_each(|value| size.parameter(value)),
                (_, Value::Number(value)) => size.parameter(value),
                (_, Value::Frame(frame)) => [frame.r(), frame.s()].into_iter().for_each(|end| size.parameter(end)),
                (_, Value::Arguments(list)) => {
                    list.iter().flat_map(|argument| [&argument.t, &argument.w]).for_each(|value| size.parameter(value))
                }
                ("degree", Value::Count(degree)) => raised = *degree,
                ("by", Value::Count(by)) => size.degree += by,
                ("depth", Value::Count(depth)) => size.depth = *depth,
                _ => {}
            }
        }
        size.degree = size.degree.max(raised);
        size.dimension = size.dimension.max(1);
        size
    }
}

/// Refuses an operation that would take too long or too much memory.
pub(super) fn check<C: Coefficient>(operation: &Operation, arguments: &Arguments<C>) -> Result<(), Error> {
    let size = Size::of(arguments);
    let too_large = |what, limit| Err(Error::TooLarge { what, limit });
    if size.degree > MAX_DEGREE as usize {
        return too_large("degree", MAX_DEGREE as usize);
    }
    if size.symbolic_data && size.degree > MAX_SYMBOLIC_DEGREE {
        return too_large("degree with symbolic parameters", MAX_SYMBOLIC_DEGREE);
    }
    if size.symbolic_parameter && size.degree > MAX_SYMBOLIC_ARGUMENT_DEGREE {
        return too_large("degree with a symbolic frame or argument", MAX_SYMBOLIC_ARGUMENT_DEGREE);
    }
    let one = (size.degree + 1) * size.dimension;
    let numbers = match operation.growth {
        Growth::Linear => Some(one),
        Growth::Quadratic if arguments.get("index").is_some() => Some(one),
        Growth::Quadratic => one.checked_mul(size.degree + 2).map(|all| all / 2),
        Growth::Doubling => {
            u32::try_from(size.depth).ok().and_then(|depth| 2usize.checked_pow(depth)).and_then(|pieces| pieces.checked_mul(one))
        }
    };
    let Some(numbers) = numbers.filter(|&numbers| numbers <= MAX_NUMBERS) else {
        return too_large("answer, counted in numbers,", MAX_NUMBERS);
    };
    // Every argument that is taken in lengthens a number by its own length, at most twice.
    let bits = size.data_bits + size.degree as u64 * (2 * size.parameter_bits + size.depth as u64 + 1);
    if bits.saturating_mul(numbers as u64) > MAX_BITS {
        return too_large("answer, counted in bits,", MAX_BITS as usize);
    }
    let steps = (numbers as u64).saturating_mul(size.degree as u64 + 1).saturating_mul(bits / 64 + 1);
    if steps > MAX_WORD_STEPS {
        return too_large("work, counted in steps on machine words,", MAX_WORD_STEPS as usize);
    }
    Ok(())
}
