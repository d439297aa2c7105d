//! The arguments of a function.

use super::Fault;
use crate::affine::{Frame, Interval, Rectangle, Triangle};
use crate::error::Error;
use crate::symbolic::{Polynomial, Symbol};
use crate::syntax::{Span, SyntaxError};
use crate::worksheet::evaluate::count_of;
use crate::worksheet::quantity::{Map, Net, Point, Quantity};

/// One argument of a function.
pub(in crate::worksheet) enum Operand {
    /// A value, with its text.
    Value { value: Quantity, span: Span, text: String },
    /// An interval.
    Range { from: Polynomial, to: Polynomial, span: Span },
    /// A value by name.
    Named { name: Symbol, value: Quantity, span: Span },
}

impl Operand {
    pub(super) fn span(&self) -> Span {
        match self {
            Self::Value { span, .. } | Self::Range { span, .. } | Self::Named { span, .. } => *span,
        }
    }
}

/// All arguments of a call.
pub(in crate::worksheet) struct Operands<'a> {
    pub(in crate::worksheet) list: &'a [Operand],
    pub(in crate::worksheet) name_span: Span,
    pub(in crate::worksheet) span: Span,
}

impl Operands<'_> {
    pub(super) fn len(&self) -> usize {
        self.list.len()
    }

    /// An error at an argument, or at the call if there are too few.
    pub(super) fn wrong(&self, index: usize, message: impl Into<String>) -> Fault {
        let span = self.list.get(index).map_or(self.name_span, Operand::span);
        Fault::At(SyntaxError::new(span, message))
    }

    /// An error that there are too few or too many.
    pub(super) fn count(&self, expected: &str) -> Fault {
        let found = self.list.len();
        let arguments = if found == 1 { "argument" } else { "arguments" };
        Fault::At(SyntaxError::new(self.span, format!("found {found} {arguments}, expected {expected}")))
    }

    /// The value of an argument.
    pub(super) fn value(&self, index: usize, what: &str) -> Result<&Quantity, Fault> {
        match self.list.get(index) {
            Some(Operand::Value { value, .. }) => Ok(value),
            Some(_) => Err(self.wrong(index, format!("found an interval, expected {what}"))),
            None => Err(self.wrong(index, format!("found {} arguments, expected {what}", self.len()))),
        }
    }

    /// The text of an argument.
    pub(super) fn text(&self, index: usize) -> Option<&str> {
        match self.list.get(index) {
            Some(Operand::Value { text, .. }) => Some(text),
            _ => None,
        }
    }

    pub(super) fn number(&self, index: usize) -> Result<&Polynomial, Fault> {
        match self.value(index, "a number")? {
            Quantity::Number(value) => Ok(value),
            other => Err(self.wrong(index, format!("found {}, expected a number", other.kind()))),
        }
    }

    pub(super) fn small(&self, index: usize) -> Result<usize, Fault> {
        count_of(self.number(index)?)
            .filter(|count| *count <= crate::syntax::limits::MAX_DEGREE as usize)
            .ok_or_else(|| self.wrong(index, "found no small whole number, expected one such as 3"))
    }

    /// A small whole number that may be left out.
    pub(super) fn small_or(&self, index: usize, default: usize) -> Result<usize, Fault> {
        if index < self.len() { self.small(index) } else { Ok(default) }
    }

    /// The coordinates of a point without a weight.
    pub(super) fn point(&self, index: usize) -> Result<Vec<Polynomial>, Fault> {
        match self.value(index, "a point")? {
            Quantity::Point(Point { coordinates, weight: None }) => Ok(coordinates.clone()),
            Quantity::Number(value) => Ok(vec![value.clone()]),
            other => Err(self.wrong(index, format!("found {}, expected a point", other.kind()))),
        }
    }

    /// A point of the parameter plane.
    pub(super) fn place(&self, index: usize) -> Result<[Polynomial; 2], Fault> {
        let point = self.point(index)?;
        <[Polynomial; 2]>::try_from(point)
            .map_err(|_| self.wrong(index, "found a number, expected a point `(u, v)` of the parameter plane"))
    }

    pub(super) fn net(&self, index: usize) -> Result<&Net, Fault> {
        match self.value(index, "a net")? {
            Quantity::Net(net) => Ok(net),
            other => {
                let error = SyntaxError::new(self.list[index].span(), format!("found {}, expected a net with its frame", other.kind()));
                Err(Fault::At(match other {
                    Quantity::Map(map) if map.variables.len() == 1 => error.with_help("`points(F, r..s)` is the net of a curve"),
                    Quantity::Map(_) => error.with_help("`points(S, …)` over a frame is the net of a surface"),
                    Quantity::List(_) => error.with_help("`curve(…, r..s)`, `triangle(…)` or `rectangle(…)` makes a net of a list"),
                    _ => error,
                }))
            }
        }
    }

    /// A map, or that of a net.
    pub(super) fn map(&self, index: usize) -> Result<Map, Fault> {
        match self.value(index, "a map")? {
            Quantity::Map(map) => Ok(map.clone()),
            Quantity::Net(net) => Ok(net.map()?),
            other => Err(self.wrong(index, format!("found {}, expected a map or a net", other.kind()))),
        }
    }

    /// The map of a curve.
    pub(super) fn curve(&self, index: usize) -> Result<Map, Fault> {
        let map = self.map(index)?;
        if map.variables.len() == 1 { Ok(map) } else { Err(self.wrong(index, "found a surface, expected a curve")) }
    }

    /// The map of a curve without a denominator.
    pub(super) fn polynomial_curve(&self, index: usize) -> Result<Map, Fault> {
        let map = self.curve(index)?;
        if map.weight.is_none() { Ok(map) } else { Err(self.wrong(index, "found a curve with weights, expected one without")) }
    }

    /// The map of a surface.
    pub(super) fn surface(&self, index: usize) -> Result<Map, Fault> {
        let map = self.map(index)?;
        if map.variables.len() == 2 {
            return Ok(map);
        }
        // A constant may be a surface as well.
        Err(self.wrong(index, "found a curve, expected a surface"))
    }

    /// The items of a list, or the points of a net.
    pub(super) fn list(&self, index: usize) -> Result<Vec<Quantity>, Fault> {
        match self.value(index, "a list")? {
            Quantity::List(items) => Ok(items.clone()),
            Quantity::Net(net) => match net.list() {
                Quantity::List(items) => Ok(items),
                other => Ok(vec![other]),
            },
            other => Err(self.wrong(index, format!("found {}, expected a list `[…]`", other.kind()))),
        }
    }

    /// The numbers of a list.
    pub(super) fn numbers(&self, index: usize) -> Result<Vec<Polynomial>, Fault> {
        let number = |item: Quantity| match item {
            Quantity::Number(value) => Ok(value),
            other => Err(self.wrong(index, format!("found {} in the list, expected numbers", other.kind()))),
        };
        self.list(index)?.into_iter().map(number).collect()
    }

    /// The frame that begins at an argument, and how many arguments it takes; `None` if there is none left.
    pub(super) fn frame(&self, index: usize) -> Result<Option<(Frame<Polynomial>, usize)>, Fault> {
        let interval = |from: &Polynomial, to: &Polynomial| Interval::new(from.clone(), to.clone());
        match (self.list.get(index), self.list.get(index + 1)) {
            (None, _) => Ok(None),
            (Some(Operand::Range { from, to, .. }), Some(Operand::Range { from: c, to: d, .. })) => {
                Ok(Some((Rectangle::new(interval(from, to)?, interval(c, d)?).into(), 2)))
            }
            (Some(Operand::Range { from, to, .. }), _) => Ok(Some((interval(from, to)?.into(), 1))),
            (Some(Operand::Value { value: Quantity::Point(_), .. }), _) => {
                if self.len() < index + 3 {
                    return Err(self.wrong(index, "found no frame, expected the three vertices of a triangle"));
                }
                let frame = Triangle::new(self.place(index)?, self.place(index + 1)?, self.place(index + 2)?)?;
                Ok(Some((frame.into(), 3)))
            }
            (Some(other), _) => {
                let error = SyntaxError::new(other.span(), "found no frame, expected one: `r..s`, `a..b, c..d` or three points");
                Err(Fault::At(error))
            }
        }
    }

    /// The frame that is all that is left from an argument on.
    pub(super) fn last_frame(&self, index: usize) -> Result<Frame<Polynomial>, Fault> {
        match self.frame(index)? {
            Some((frame, taken)) => {
                self.ends(index + taken)?;
                Ok(frame)
            }
            None => Err(self.count("a frame: `r..s`, `a..b, c..d` or three points")),
        }
    }

    /// Checks that there are no more arguments.
    pub(super) fn ends(&self, count: usize) -> Result<(), Fault> {
        match self.list.get(count) {
            None => Ok(()),
            Some(more) => Err(Fault::At(SyntaxError::new(more.span(), format!("found {} arguments, expected {count}", self.len())))),
        }
    }
}

impl From<Fault> for Error {
    fn from(fault: Fault) -> Self {
        match fault {
            Fault::Of(error) => error,
            Fault::At(error) => Self::WrongShape(error.message),
        }
    }
}
