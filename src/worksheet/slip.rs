//! Usual mistakes, made on purpose: the values that a calculation has with one
//! of them, for comparison with what is claimed.

use std::borrow::Cow;

use super::evaluate::polar_value;
use super::function::net_of;
use super::quantity::{Degrees, Map, Net, Point, Quantity};
use crate::affine::{Frame, Rectangle, Triangle};
use crate::blossom::{PolarForm, binomials};
use crate::error::Error;
use crate::exact::Rational;
use crate::piece::Piece;
use crate::reading::Reading;
use crate::segment::Segment;
use crate::symbolic::Polynomial;
use crate::syntax::{ArgumentInput, Span};

/// A usual mistake.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Slip {
    /// No coefficient divided by the number of products that share it.
    Undivided,
    /// The coefficients with one set of exponents not divided.
    UndividedAt(Exponents),
    /// A coefficient divided by another number.
    DividedBy(Exponents, u32),
    /// The numbers of another kind of polar form.
    Counts(Counts),
    /// Each coordinate polarized at its own degree, with the first arguments or the last ones.
    OwnDegree { last: bool },
    /// The two ends of a frame, or two different arguments, exchanged.
    Exchanged,
    /// Without weights.
    Unweighted,
    /// Not divided by the weight at the end.
    Homogeneous,
    /// The opposite of κ23, wherever it is used.
    Kappa23,
    /// The opposite of κ31.
    Kappa31,
}

/// The exponents of the variables: of the second one 0 for a curve.
pub(super) type Exponents = (usize, usize);

/// The numbers of products of another kind of polar form.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Counts {
    /// `C(m, h) C(m, k)` in a form by the total degree.
    Bidegree,
    /// `C(m, h + k)` in a form by the total degree.
    Sum,
    /// `C(p, h)` only in a form by the bidegree.
    First,
    /// `C(q, k)` only.
    Second,
    /// The multinomial numbers of degree `p + q` in a form by the bidegree.
    Total,
}

fn binomial(degree: usize, index: usize) -> Rational {
    binomials(degree).get(index).cloned().unwrap_or_else(|| Rational::from(1))
}

/// The exponents of the variables among those of a reading.
pub(super) fn of_variables(reading: Reading, exponents: &[usize]) -> Exponents {
    match (reading, exponents) {
        (Reading::Curve(_), [_, k]) => (*k, 0),
        (Reading::Total(_), [_, h, k]) | (Reading::Bidegree(..), [_, h, _, k]) => (*h, *k),
        _ => (0, 0),
    }
}

fn unsupported() -> Error {
    Error::Unsupported("this mistake cannot be made here".into())
}

impl Slip {
    /// Whether the mistake is one in polar forms.
    fn is_of_forms(self) -> bool {
        matches!(
            self,
            Self::Undivided | Self::UndividedAt(_) | Self::DividedBy(..) | Self::Counts(_) | Self::OwnDegree { .. } | Self::Exchanged
        )
    }

    /// Whether the mistake may be made in one coordinate or point and not in others.
    pub(super) fn may_be_partial(self) -> bool {
        self.is_of_forms() && self != Self::Exchanged
    }

    /// The polar form with wrong numbers.
    fn form(self, form: &PolarForm<Polynomial>) -> Result<PolarForm<Polynomial>, Error> {
        let reading = form.reading();
        Ok(match self {
            Self::Undivided => form.divided_otherwise(|_, _| Rational::from(1)),
            Self::UndividedAt(place) => {
                form.divided_otherwise(
                    |exponents, right| {
                        if of_variables(reading, exponents) == place { Rational::from(1) } else { right.clone() }
                    },
                )
            }
            Self::DividedBy(place, number) => form.divided_otherwise(|exponents, right| {
                if of_variables(reading, exponents) == place { Rational::from(i64::from(number)) } else { right.clone() }
            }),
            Self::Counts(counts) => form.divided_otherwise(|exponents, right| {
                let (h, k) = of_variables(reading, exponents);
                match (reading, counts) {
                    (Reading::Total(m), Counts::Bidegree) => binomial(m, h) * binomial(m, k),
                    (Reading::Total(m), Counts::Sum) => binomial(m, h + k),
                    (Reading::Bidegree(p, _), Counts::First) => binomial(p, h),
                    (Reading::Bidegree(_, q), Counts::Second) => binomial(q, k),
                    (Reading::Bidegree(p, q), Counts::Total) => binomial(p + q, h) * binomial(p + q - h, k),
                    _ => right.clone(),
                }
            }),
            _ => return Err(unsupported()),
        })
    }

    /// The value of a polar form with the mistake in it.
    pub(super) fn polar_value(self, shape: &Quantity, groups: &[Vec<ArgumentInput>]) -> Result<Quantity, Error> {
        match self {
            Self::Unweighted => return polar_value(self.on_shape(shape)?.as_ref(), groups, None),
            Self::Exchanged => return polar_value(shape, &exchanged(groups).ok_or_else(unsupported)?, None),
            _ if !self.is_of_forms() => return polar_value(shape, groups, None),
            _ => {}
        }
        let map = match shape {
            Quantity::Map(map) => map.clone(),
            Quantity::Net(net) => net.map()?,
            _ => return Err(unsupported()),
        };
        if map.weight.is_some() || groups.iter().flatten().any(|argument| argument.is_homogeneous) {
            return Err(unsupported());
        }
        if let Self::OwnDegree { last } = self {
            return own_degrees(&map, groups, last);
        }
        let form = match (map.variables.len(), groups.len()) {
            (1, 1) => map.curve()?.polar(),
            (2, 1) => map.surface(true)?.polar(),
            (2, 2) => map.surface(false)?.polar(),
            _ => return Err(unsupported()),
        };
        let form = self.form(&form)?;
        let arguments = groups.iter().flatten();
        let value = if matches!(form.reading(), Reading::Total(_)) {
            let places = arguments.map(|argument| <[Polynomial; 2]>::try_from(argument.coordinates.clone()).map_err(|_| unsupported()));
            form.value_at_points(&places.collect::<Result<Vec<_>, _>>()?)?
        } else {
            form.value(&arguments.flat_map(|argument| argument.coordinates.clone()).collect::<Vec<_>>())?
        };
        Ok(Quantity::point(value))
    }

    /// The control points with the mistake in them.
    pub(super) fn points(self, shape: &Quantity, frame: &Frame<Polynomial>) -> Result<Quantity, Error> {
        let map = |shape: &Quantity| match shape {
            Quantity::Map(map) => Ok(map.clone()),
            Quantity::Net(net) => net.map(),
            _ => Err(unsupported()),
        };
        match (self, frame) {
            (Self::Unweighted, _) => return net_of(&map(self.on_shape(shape)?.as_ref())?, frame),
            (Self::Exchanged, Frame::Interval(interval)) => return net_of(&map(shape)?, &interval.reversed().into()),
            (Self::Exchanged, Frame::Triangle(triangle)) => {
                let [r, s, t] = triangle.vertices().clone();
                return net_of(&map(shape)?, &Triangle::new(s, r, t)?.into());
            }
            (Self::Exchanged, Frame::Rectangle(rectangle)) => {
                let reversed = Rectangle::new(rectangle.u().reversed(), rectangle.v().reversed());
                return net_of(&map(shape)?, &reversed.into());
            }
            _ if !self.is_of_forms() => return net_of(&map(shape)?, frame),
            _ => {}
        }
        let map = map(shape)?;
        let argument = |coordinates: Vec<Polynomial>| ArgumentInput {
            weight: num_traits::One::one(),
            coordinates,
            is_homogeneous: false,
            span: Span::default(),
        };
        let powers = |a: &Polynomial, b: &Polynomial, first: usize, second: usize| -> Vec<ArgumentInput> {
            let of = |value: &Polynomial, count: usize| std::iter::repeat_n(argument(vec![value.clone()]), count).collect::<Vec<_>>();
            [of(a, first), of(b, second)].concat()
        };
        let rows: Vec<Vec<Vec<Vec<ArgumentInput>>>> = match frame {
            Frame::Interval(frame) => {
                let m = map.curve()?.degree();
                vec![(0..=m).map(|i| vec![powers(frame.r(), frame.s(), m - i, i)]).collect()]
            }
            Frame::Triangle(frame) => {
                let m = map.surface(true)?.reading().groups()[0].0;
                let vertex = |index: usize, count: usize| std::iter::repeat_n(argument(frame.vertices()[index].to_vec()), count);
                let group = |i: usize, j: usize| vertex(0, i).chain(vertex(1, j)).chain(vertex(2, m - i - j)).collect::<Vec<_>>();
                (0..=m).map(|i| (0..=m - i).map(|j| vec![group(i, j)]).collect()).collect()
            }
            Frame::Rectangle(frame) => {
                let groups = map.surface(false)?.reading().groups();
                let (p, q) = (groups[0].0, groups[1].0);
                let (u, v) = (frame.u(), frame.v());
                let point = |i: usize, j: usize| vec![powers(u.r(), u.s(), p - i, i), powers(v.r(), v.s(), q - j, j)];
                (0..=p).map(|i| (0..=q).map(|j| point(i, j)).collect()).collect()
            }
        };
        let shape = Quantity::Map(map);
        let value = |groups: &Vec<Vec<ArgumentInput>>| self.polar_value(&shape, groups);
        let mut lists = rows.iter().map(|row| row.iter().map(value).collect::<Result<Vec<_>, _>>().map(Quantity::List));
        Ok(match frame {
            Frame::Interval(_) => lists.next().transpose()?.unwrap_or(Quantity::List(Vec::new())),
            _ => Quantity::List(lists.collect::<Result<_, _>>()?),
        })
    }

    /// A map or net without weights, or not divided by them.
    pub(super) fn on_shape<'q>(self, shape: &'q Quantity) -> Result<Cow<'q, Quantity>, Error> {
        Ok(match (self, shape) {
            (Self::Unweighted, Quantity::Map(map)) if map.weight.is_some() => {
                Cow::Owned(Quantity::Map(Map { weight: None, ..map.clone() }))
            }
            (Self::Homogeneous, Quantity::Map(map)) if map.weight.is_some() => {
                Cow::Owned(Quantity::Map(Map { weight: None, ..map.clone() }))
            }
            (Self::Unweighted | Self::Homogeneous, Quantity::Net(net)) if net.weighted => Cow::Owned(Quantity::Net(self.net(net)?)),
            _ => Cow::Borrowed(shape),
        })
    }

    /// A net without weights, not divided by them, or with the ends exchanged.
    pub(super) fn net(self, net: &Net) -> Result<Net, Error> {
        match (self, &net.piece) {
            (Self::Exchanged, Piece::Curve(segment)) => {
                let points = segment.points().rev().map(<[Polynomial]>::to_vec).collect();
                Ok(Net { piece: Piece::Curve(Segment::from_points(points, segment.frame().clone())?), weighted: net.weighted })
            }
            (Self::Unweighted | Self::Homogeneous, piece) if net.weighted => {
                let point = |homogeneous: &[Polynomial]| -> Result<Vec<Polynomial>, Error> {
                    match (self, Quantity::homogeneous(homogeneous)?) {
                        (Self::Unweighted, Quantity::Point(Point { coordinates, .. })) => Ok(coordinates),
                        _ => Ok(homogeneous[..homogeneous.len() - 1].to_vec()),
                    }
                };
                let points = piece.points().map(point).collect::<Result<Vec<_>, _>>()?;
                Ok(Net { piece: piece.with_points(points)?, weighted: false })
            }
            _ => Ok(net.clone()),
        }
    }
}

/// The same arguments with the two different ones exchanged; `None` if there are not just two.
fn exchanged(groups: &[Vec<ArgumentInput>]) -> Option<Vec<Vec<ArgumentInput>>> {
    let mut changed = false;
    let groups = groups.iter().map(|group| {
        let first = group.first()?;
        let other = group.iter().find(|argument| argument.coordinates != first.coordinates);
        let Some(other) = other else { return Some(group.clone()) };
        changed = true;
        let swap = |argument: &ArgumentInput| {
            let into = if argument.coordinates == first.coordinates {
                other
            } else if argument.coordinates == other.coordinates {
                first
            } else {
                return None;
            };
            Some(into.clone())
        };
        group.iter().map(swap).collect::<Option<Vec<_>>>()
    });
    let groups = groups.collect::<Option<Vec<_>>>()?;
    changed.then_some(groups)
}

/// Every coordinate by the polar form of its own degree.
fn own_degrees(map: &Map, groups: &[Vec<ArgumentInput>], last: bool) -> Result<Quantity, Error> {
    let mut values = Vec::new();
    for component in &map.components {
        let one = Map { components: vec![component.clone()], degrees: Degrees::default(), ..map.clone() };
        let counts: Vec<usize> = match (map.variables.len(), groups.len()) {
            (1, _) => vec![one.curve()?.degree()],
            (_, 1) => vec![one.surface(true)?.reading().groups()[0].0],
            _ => one.surface(false)?.reading().groups().iter().map(|group| group.0).collect(),
        };
        let chosen = groups.iter().zip(&counts).map(|(group, &count)| {
            let start = if last { group.len().saturating_sub(count) } else { 0 };
            group.iter().skip(start).take(count).cloned().collect()
        });
        match polar_value(&Quantity::Map(one), &chosen.collect::<Vec<_>>(), None)? {
            Quantity::Number(value) => values.push(value),
            _ => return Err(unsupported()),
        }
    }
    Ok(Quantity::point(values))
}
