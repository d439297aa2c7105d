//! Questions to the table of operations, and their answers as values.

use super::quantity::{Map, Net, Quantity, usual_variables};
use crate::affine::Frame;
use crate::error::Error;
use crate::exact::{Rational, Surd};
use crate::kernel::coefficient::Coefficient;
use crate::ops::Operation;
use crate::piece::{Equation, Piece};
use crate::rectangular::RectangularPatch;
use crate::segment::Segment;
use crate::symbolic::{Polynomial, Symbol};
use crate::triangular::TriangularPatch;
use crate::value::{Answer, Arguments, Domain, Value};

/// An operation with its arguments.
pub(super) struct Request {
    operation: &'static str,
    arguments: Arguments<Polynomial>,
}

/// The parts of an answer by name; parts that do not exist are left out.
pub(super) struct Reply(Vec<(&'static str, Quantity)>);

impl Request {
    /// An operation on a kind of shape, without arguments so far.
    pub(super) fn new(operation: &'static str, domain: Domain) -> Self {
        Self { operation, arguments: Arguments::new(domain) }
    }

    /// The same with an argument.
    pub(super) fn with(mut self, name: &'static str, value: Value<Polynomial>) -> Self {
        self.arguments.insert(name, value);
        self
    }

    /// The same with the control points of a net, its frame and its weights.
    pub(super) fn with_net(self, net: &Net) -> Result<Self, Error> {
        self.with_net_as(net, ["points", "frame", "weights"])
    }

    /// The same with a second net.
    pub(super) fn with_other_net(self, net: &Net) -> Result<Self, Error> {
        self.with_net_as(net, ["other_points", "other_frame", "other_weights"])
    }

    fn with_net_as(self, net: &Net, [points, frame, weights]: [&'static str; 3]) -> Result<Self, Error> {
        let mut weight_list = Vec::new();
        let mut rows: Vec<Vec<Vec<Polynomial>>> = Vec::new();
        for row in net.piece.rows() {
            let mut points = Vec::new();
            for point in row {
                match (net.weighted, Quantity::homogeneous(point)) {
                    (false, _) => points.push(point.to_vec()),
                    (true, Ok(Quantity::Point(point))) => {
                        points.push(point.coordinates);
                        weight_list.extend(point.weight);
                    }
                    (true, Ok(_)) => {}
                    (true, Err(error)) => return Err(error),
                }
            }
            rows.push(points);
        }
        let value = match (&net.piece, rows.len()) {
            (Piece::Curve(_), 1) => Value::Points(rows.swap_remove(0)),
            _ => Value::Rows(rows),
        };
        let request = self.with(points, value).with(frame, Value::Frame(net.frame()));
        Ok(if net.weighted { request.with(weights, Value::Numbers(weight_list)) } else { request })
    }

    /// Carries the operation out, on numbers if there is no symbolic parameter.
    pub(super) fn reply(self) -> Result<Reply, Error> {
        let operation =
            Operation::named(self.operation).ok_or_else(|| Error::Unsupported(format!("there is no operation `{}`", self.operation)))?;
        match self.arguments.numeric() {
            Ok(arguments) => Reply::of(&operation.on_numbers(&arguments)?),
            Err((symbol, _)) => match operation.on_symbols(&self.arguments) {
                Some(answer) => Reply::of(&answer?),
                None => Err(Error::Unsupported(match symbol.radicand() {
                    Some(prime) => format!("this needs rational numbers, found √{prime}"),
                    None => format!("this needs numbers, found the symbolic parameter `{symbol}`"),
                })),
            },
        }
    }
}

impl Reply {
    fn of<C: Coefficient>(answer: &Answer<C>) -> Result<Self, Error> {
        let mut fields = Vec::new();
        for (name, value) in &answer.fields {
            if let Some(quantity) = quantity(value, answer.weighted)? {
                fields.push((*name, quantity));
            }
        }
        Ok(Self(fields))
    }

    /// The part with a name, if there is one.
    pub(super) fn get(&self, name: &str) -> Option<&Quantity> {
        self.0.iter().find(|(key, _)| *key == name).map(|(_, value)| value)
    }

    /// The part with a name.
    pub(super) fn take(mut self, name: &str) -> Result<Quantity, Error> {
        match self.0.iter().position(|(key, _)| *key == name) {
            Some(place) => Ok(self.0.swap_remove(place).1),
            None => Err(Error::Unsupported(format!("there is no {} here", name.replace('_', " ")))),
        }
    }
}

/// A number `a ± √d` as a polynomial in roots of primes.
pub(super) fn surd(value: &Surd) -> Result<Polynomial, Error> {
    let (rational, factor, radicand) = value.printed_parts();
    let root = Polynomial::square_root(&Rational::from(radicand.clone()))
        .ok_or_else(|| Error::Unsupported(format!("√{radicand} has a prime factor under the root that is too large")))?;
    Ok(Polynomial::from(rational) + root.scale(&factor))
}

/// A value of an answer; `None` for what does not exist or has no form in worksheets.
fn quantity<C: Coefficient>(value: &Value<C>, weighted: bool) -> Result<Option<Quantity>, Error> {
    let number = |number: &C| -> Polynomial { number.clone().into() };
    let lifted = |point: &[C]| -> Vec<Polynomial> { point.iter().map(number).collect() };
    let point = |point: &[C]| if weighted { Quantity::homogeneous(&lifted(point)) } else { Ok(Quantity::point(lifted(point))) };
    let points = |list: &mut dyn Iterator<Item = &[C]>| list.map(point).collect::<Result<Vec<_>, Error>>().map(Quantity::List);
    let counts = |counts: &[usize]| Quantity::point(counts.iter().map(|&k| Polynomial::from(Rational::from(k as i64))).collect());
    Ok(Some(match value {
        Value::Truth(truth) => Quantity::truth(*truth),
        Value::Count(count) => Quantity::count(*count),
        Value::Integer(integer) => Quantity::Number(Polynomial::from(Rational::from(*integer))),
        Value::Counts(list) => counts(list),
        Value::Number(value) => Quantity::from(number(value)),
        Value::Numbers(list) => Quantity::List(list.iter().map(|value| Quantity::from(number(value))).collect()),
        Value::Surd(value) => Quantity::from(surd(value)?),
        Value::Surds(list) => Quantity::point(list.iter().map(surd).collect::<Result<_, _>>()?),
        Value::Point(value) => point(value)?,
        Value::Points(list) => points(&mut list.iter().map(Vec::as_slice))?,
        Value::Rows(rows) => {
            let rows = rows.iter().map(|row| points(&mut row.iter().map(Vec::as_slice)));
            Quantity::List(rows.collect::<Result<_, _>>()?)
        }
        Value::Curve(curve) => equation(&Equation::Curve(curve.clone()), weighted),
        Value::Surface(surface) => equation(&Equation::Surface(surface.clone()), weighted),
        Value::Net(piece) | Value::Piece(piece) => Quantity::Net(Net { piece: in_symbols(piece)?, weighted }),
        Value::Pieces(pieces) => {
            let nets = pieces.iter().map(|piece| Ok(Quantity::Net(Net { piece: in_symbols(piece)?, weighted })));
            Quantity::List(nets.collect::<Result<_, Error>>()?)
        }
        Value::Scheme(scheme) => {
            let layers = scheme.layers().map(|mut layer| points(&mut layer));
            Quantity::List(layers.collect::<Result<_, _>>()?)
        }
        Value::Layers(layers) => {
            let mut list = Vec::new();
            for layer in &layers.layers {
                let rows = layer.iter().map(|row| points(&mut row.iter().map(|(_, point)| point.as_slice())));
                let mut rows: Vec<Quantity> = rows.collect::<Result<_, _>>()?;
                list.push(if layers.in_rows { Quantity::List(rows) } else { rows.pop().unwrap_or(Quantity::List(Vec::new())) });
            }
            Quantity::List(list)
        }
        Value::Homogeneous(form) => {
            let symbols: Vec<Symbol> = form.letters.iter().map(|&letter| Symbol::new(letter, None)).collect();
            let terms = form.terms.iter().map(|(exponents, c)| {
                let factors = symbols.iter().copied().zip(exponents.iter().map(|&exponent| exponent as u32));
                number(c).times_monomial(&crate::symbolic::Monomial::from_factors(factors))
            });
            Quantity::from(terms.fold(Polynomial::default(), |sum, term| sum + term))
        }
        Value::Word(word) => Quantity::Word(word),
        Value::List(list) => {
            let items: Result<Vec<Option<Quantity>>, Error> = list.iter().map(|value| quantity(value, weighted)).collect();
            Quantity::List(items?.into_iter().flatten().collect())
        }
        Value::Record(fields) => {
            let items: Result<Vec<Option<Quantity>>, Error> = fields.iter().map(|(_, value)| quantity(value, weighted)).collect();
            Quantity::List(items?.into_iter().flatten().collect())
        }
        Value::Matrix(_)
        | Value::Frame(_)
        | Value::Arguments(_)
        | Value::PlaneArguments(_)
        | Value::Polar(_)
        | Value::HomogeneousPolar(_)
        | Value::Mesh(_)
        | Value::Map(_)
        | Value::Expressions(_)
        | Value::Variables(_)
        | Value::Defects(..)
        | Value::Document(_)
        | Value::Nothing => return Ok(None),
    }))
}

fn equation<C: Coefficient>(equation: &Equation<C>, weighted: bool) -> Quantity {
    Quantity::Map(Map::of(equation, &usual_variables(equation), weighted))
}

/// A piece with polynomials as coordinates.
fn in_symbols<C: Coefficient>(piece: &Piece<C>) -> Result<Piece<Polynomial>, Error> {
    let points: Vec<Vec<Polynomial>> =
        piece.points().map(|point| point.iter().map(|x| Into::<Polynomial>::into(x.clone()).with_simple_roots()).collect()).collect();
    let frame = piece.frame().map(&mut |number: &C| Ok::<Polynomial, Error>(number.clone().into()))?;
    over(piece, points, frame)
}

fn over<C: Coefficient>(piece: &Piece<C>, points: Vec<Vec<Polynomial>>, frame: Frame<Polynomial>) -> Result<Piece<Polynomial>, Error> {
    Ok(match (piece, frame) {
        (_, Frame::Interval(frame)) => Piece::Curve(Segment::from_points(points, frame)?),
        (_, Frame::Triangle(frame)) => Piece::Triangle(TriangularPatch::from_points(points, frame)?),
        (Piece::Rectangle(patch), Frame::Rectangle(frame)) => {
            Piece::Rectangle(RectangularPatch::from_points(patch.degree(), points, frame)?)
        }
        _ => return Err(Error::WrongShape("a piece over a rectangle is a rectangular one".into())),
    })
}
