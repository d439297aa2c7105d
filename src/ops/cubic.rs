//! Operations on planar cubics.

use crate::affine::Interval;
use crate::algebraic::AlgebraicNumber;
use crate::cubic::{Cubic, Distance, Equivalence, Family, Intention, NormalForm, Portion, Special, SpecialPoint, Straight, place_name};
use crate::curve::Curve;
use crate::error::Error;
use crate::exact::{Rational, Surd};
use crate::kernel::coefficient::Coefficient;
use crate::segment::Segment;
use crate::symbolic::Polynomial;
use crate::value::{Answer, Arguments, CubicFinding, Finding, Value};

/// The longest coefficients; special points are some ten times as long.
const MAX_BITS: u64 = 1 << 15;

type Fields = Vec<(&'static str, Value)>;

pub(super) fn classify(arguments: &Arguments) -> Result<Answer, Error> {
    let given = Given::of(arguments)?;
    let cubic = Cubic::new(&given.curve)?;
    let longest = cubic.vectors().iter().flatten().map(Rational::bits).max().unwrap_or(0);
    if longest > MAX_BITS {
        return Err(Error::TooLarge {
            what: "length of a coefficient of a cubic whose special points are computed, in bits,",
            limit: MAX_BITS as usize,
        });
    }
    let special = cubic.special_points();
    let portion = given.frame.as_ref().map(|frame| cubic.portion(&special, frame));
    let normal = cubic.normal_form();
    let mut fields = invariants(&cubic);
    fields.extend(special_fields(&cubic, &special));
    fields.extend(normal.as_ref().map(|normal| ("normal", normal_form(normal))));
    fields.extend(cubic.rotated().map(|rotated| {
        let list = |numbers: [Rational; 4]| Value::Numbers(numbers.to_vec());
        ("rotated", Value::Record(vec![("u", list(rotated.u)), ("v", list(rotated.v))]))
    }));
    fields.extend(portion.as_ref().map(|portion| ("segment", segment(portion))));
    if arguments.flag("details") {
        fields.extend(details(&cubic));
    }
    let (mut distance, mut intention) = (None, None);
    if arguments.flag("distance") {
        let segment = given.segment()?;
        let found = Cubic::distance(&segment)?;
        intention = if given.is_polygon { Cubic::intention_of_segment(&segment)? } else { Cubic::intention_of_curve(&given.curve)? };
        fields.push(("distance", distance_field(&found)));
        fields.push(("did_you_mean", intention.as_ref().map_or(Value::Nothing, intention_field)));
        distance = Some(found);
    }
    let mut answer = Answer::new(fields);
    let mut equivalence = None;
    if let Some(other) = arguments.get("other") {
        let other = match other {
            Value::Curve(curve) => Cubic::new(curve)?,
            Value::Points(points) => Cubic::new(
                &Segment::from_points(points.clone(), arguments.frame("frame").cloned().unwrap_or_else(|_| Interval::unit()))?.curve()?,
            )?,
            _ => return Err(Error::WrongShape("`other` is a curve or a list of control points".into())),
        };
        let maps = cubic.equivalence(&other);
        answer.fields.push(("equivalent", equivalence_field(maps.as_ref())));
        answer = answer.that_holds(maps.is_some());
        equivalence = Some(maps.ok_or_else(|| cubic.difference(&other)));
    }
    Ok(answer.with_finding(Finding::Cubic(Box::new(CubicFinding { cubic, special, normal, portion, distance, intention, equivalence }))))
}

pub(super) fn class(arguments: &Arguments) -> Result<Answer, Error> {
    Ok(Answer::new(vec![("class", Value::Word(Cubic::new(&arguments.curve()?)?.class().name()))]))
}

/// The curve, with what is known of the segment.
struct Given {
    curve: Curve,
    /// The frame, unless only an equation was given.
    frame: Option<Interval>,
    points: Option<Segment>,
    is_polygon: bool,
}

impl Given {
    fn of(arguments: &Arguments) -> Result<Self, Error> {
        let frame = arguments.frame("frame").ok().cloned();
        if arguments.get("points").is_some() {
            let segment = arguments.segment()?;
            let frame = Some(segment.frame().clone());
            return Ok(Self { curve: segment.curve()?, frame, points: Some(segment), is_polygon: true });
        }
        Ok(Self { curve: arguments.curve()?, frame, points: None, is_polygon: false })
    }

    /// The control points; those of an equation are four.
    fn segment(&self) -> Result<Segment, Error> {
        match &self.points {
            Some(segment) => Ok(segment.clone()),
            None => {
                let frame = self.frame.clone().unwrap_or_else(Interval::unit);
                self.curve.clone().with_degree(self.curve.true_degree().max(3))?.segment(&frame)
            }
        }
    }
}

fn invariants(cubic: &Cubic) -> Fields {
    let invariants = cubic.invariants();
    let (discriminant, class) = (invariants.discriminant(), invariants.class());
    vec![
        ("kappa12", Value::Number(invariants.kappa12)),
        ("kappa23", Value::Number(invariants.kappa23)),
        ("kappa31", Value::Number(invariants.kappa31)),
        ("D", Value::Number(discriminant)),
        ("class", Value::Word(class.name())),
    ]
}

fn surd(surd: &Surd) -> Value {
    Value::Surd(surd.clone())
}

fn surds(list: &[Surd]) -> Value {
    Value::Surds(list.to_vec())
}

fn special_point(point: &SpecialPoint) -> Value {
    Value::Record(vec![("t", surd(&point.t)), ("point", surds(&point.point))])
}

fn special_fields(cubic: &Cubic, special: &Special) -> Fields {
    let mut fields = Fields::new();
    fields.extend(special.summit().map(|summit| ("summit", special_point(summit))));
    if let Some(median) = special.median() {
        let line = vec![("point", Value::Point(median.point.to_vec())), ("dir", Value::Point(median.direction.to_vec()))];
        fields.push(("median", Value::Record(line)));
        fields.push(("chord_dir", Value::Point(median.chord.to_vec())));
    }
    fields.extend(cubic.opens_to_the_right().map(|right| ("u_opens", Value::Word(if right { "right" } else { "left" }))));
    let flexes = || Value::List(special.flexes().iter().map(special_point).collect());
    match special {
        Special::Humpy { acnode, .. } => {
            fields.push(("flexes", flexes()));
            fields.push(("acnode", Value::Record(vec![("point", Value::Point(acnode.to_vec()))])));
        }
        Special::Loopy { parameters, crunode, .. } => {
            let point: Vec<Surd> = crunode.iter().map(Surd::from).collect();
            fields.push(("crunode", Value::Record(vec![("t", surds(parameters)), ("point", surds(&point))])));
        }
        Special::Pointy { cusp, .. } => fields.push(("cusp", special_point(cusp))),
        Special::SShaped { .. } => {
            fields.push(("flexes", flexes()));
            fields.extend(cubic.flex_motion().map(|motion| ("flex_motion", Value::Word(motion.name()))));
        }
        Special::Parabolic { vertex } => fields.push(("vertex", special_point(vertex))),
        Special::Straight(found) => fields.push(("straight", straight(found))),
    }
    fields
}

fn straight(straight: &Straight) -> Value {
    let mut fields = vec![("degree", Value::Count(straight.degree))];
    fields.extend(straight.direction.as_ref().map(|direction| ("dir", Value::Point(direction.to_vec()))));
    fields.extend(straight.profile.as_ref().map(|profile| ("profile", Value::Numbers(profile.to_vec()))));
    fields.push(("turns", surds(&straight.turns)));
    fields.push(("image", Value::Word(straight.image.name())));
    Value::Record(fields)
}

fn matrix(rows: &[[Surd; 2]; 2]) -> Value {
    Value::List(rows.iter().map(|row| surds(row)).collect())
}

fn normal_form(normal: &NormalForm) -> Value {
    Value::Record(vec![
        ("form", Value::Word(normal.form.name())),
        ("t0", surd(&normal.t0)),
        ("scale", surd(&normal.scale)),
        ("A", matrix(&normal.matrix)),
        ("b", surds(&normal.shift)),
    ])
}

fn segment(portion: &Portion) -> Value {
    let features = portion.features.iter().map(|feature| {
        Value::Record(vec![("name", Value::Word(feature.name)), ("t", surd(&feature.t)), ("place", Value::Word(place_name(feature.place)))])
    });
    let mut fields = vec![
        ("frame", Value::Frame(portion.frame.clone().into())),
        ("shape", Value::Word(portion.shape.name())),
        ("features", Value::List(features.collect())),
    ];
    if let Some(ends) = &portion.straight_ends {
        fields.push(("covers", Value::List(ends.iter().map(|end| surds(end)).collect())));
    }
    Value::Record(fields)
}

fn details(cubic: &Cubic) -> Fields {
    let invariants = cubic.invariants();
    let (branch, class) = (invariants.branch(), invariants.class());
    let word = |word: Option<&'static str>| word.map_or(Value::Nothing, Value::Word);
    let mut fields = vec![
        ("branch", Value::Word(branch.conditions())),
        (
            "names",
            Value::Record(vec![("loop_blinn", Value::Word(class.loop_blinn_name())), ("double_point", word(class.double_point_name()))]),
        ),
        (
            "loop_blinn",
            Value::Record(vec![
                ("d1", Value::Number(invariants.kappa23)),
                ("d2", Value::Number(invariants.kappa31)),
                ("d3", Value::Number(invariants.kappa12)),
            ]),
        ),
        ("flex_polynomial", Value::Numbers(cubic.flex_polynomial().to_vec())),
    ];
    if let Some(form) = cubic.semi_normal_form() {
        let record = vec![
            ("X", Value::Numbers(form.x.to_vec())),
            ("Y", Value::Numbers(form.y.to_vec())),
            ("c", Value::Number(form.c)),
            ("t0", Value::Number(form.t0)),
        ];
        fields.push(("semi_normal", Value::Record(record)));
    }
    if let Some(graph) = cubic.graph() {
        let list = |numbers: [Rational; 4]| Value::Numbers(numbers.to_vec());
        let record = vec![("u", list(graph.rotated.u)), ("v", list(graph.rotated.v)), ("coefficients", Value::Numbers(graph.coefficients))];
        fields.push(("graph", Value::Record(record)));
    }
    if let Some(area) = cubic.loop_area() {
        fields.push(("loop_area", Value::Surd(area)));
    }
    if let Some([first, second]) = cubic.crunode_tangents() {
        fields.push(("crunode_tangents", Value::List(vec![surds(&first), surds(&second)])));
    }
    fields.push(("point_at_infinity", cubic.curve().point_at_infinity().map_or(Value::Nothing, |point| Value::Point(point.to_vec()))));
    fields
}

fn distance_field(distance: &Distance) -> Value {
    let Some(change) = &distance.change else { return Value::Nothing };
    Value::Record(vec![
        ("length", Value::Surd(change.by.abs())),
        ("point", Value::Count(change.point)),
        ("coordinate", Value::Count(change.coordinate)),
        ("by", surd(&change.by)),
        ("grows", Value::Truth(change.grows)),
        ("class", Value::Word(change.class.name())),
        ("reached", Value::Truth(change.reached)),
    ])
}

fn intention_field(intention: &Intention) -> Value {
    let replacements = intention.replacements.iter().map(|replacement| {
        Value::Record(vec![("given", Value::Number(replacement.given.clone())), ("meant", Value::Number(replacement.meant.clone()))])
    });
    Value::Record(vec![("replacements", Value::List(replacements.collect())), ("class", Value::Word(intention.meant.name()))])
}

fn equivalence_field(maps: Option<&Equivalence>) -> Value {
    let Some(maps) = maps else { return Value::Nothing };
    Value::Record(vec![
        ("t0", Value::Number(maps.t0.clone())),
        ("t1", Value::Number(maps.t1.clone())),
        ("scale", surd(&maps.scale)),
        ("A", matrix(&maps.matrix)),
        ("b", surds(&maps.shift)),
    ])
}

pub(super) fn family<C: Coefficient>(arguments: &Arguments<C>) -> Result<Answer<C>, Error> {
    let curve = arguments.curve()?.map(&mut |number: &C| Ok::<Polynomial, Error>(number.clone().into()))?;
    let family = Family::of(&curve)?;
    let value = |number: &AlgebraicNumber| match number {
        AlgebraicNumber::Surd(surd) => ("value", Value::Surd(surd.clone())),
        AlgebraicNumber::Isolated(root) => {
            let number = |value: &Rational| C::from(value.clone());
            let (low, high) = root.interval();
            let record = vec![
                ("polynomial", Value::Numbers(root.polynomial().iter().map(|c| C::from(Rational::from(c.clone()))).collect())),
                ("between", Value::Numbers(vec![number(low), number(high)])),
            ];
            ("value", Value::Record(record))
        }
    };
    let expressions = |polynomial: &Polynomial| Value::Document(polynomial.to_string());
    let breakpoints =
        family.breakpoints.iter().map(|found| Value::Record(vec![value(&found.value), ("class", Value::Word(found.class.name()))]));
    let fields = vec![
        ("parameter", Value::Document(family.parameter.to_string())),
        ("kappa12", expressions(&family.invariants.kappa12)),
        ("kappa23", expressions(&family.invariants.kappa23)),
        ("kappa31", expressions(&family.invariants.kappa31)),
        ("D", expressions(&family.invariants.discriminant())),
        ("breakpoints", Value::List(breakpoints.collect())),
        ("between", Value::List(family.between.iter().map(|class| Value::Word(class.name())).collect())),
    ];
    Ok(Answer::new(fields).with_finding(Finding::Family(Box::new(family))))
}

pub(super) fn from_flexes(arguments: &Arguments) -> Result<Answer, Error> {
    let Some(Value::Points(points)) = arguments.get("from_flexes") else {
        return Err(Error::WrongShape("`from_flexes` is a list of three points".into()));
    };
    let [first, second, summit] = points.as_slice() else {
        return Err(Error::WrongCount { what: "points (two flexes and a summit)", expected: 3, found: points.len() });
    };
    let planar = |point: &[Rational]| match point {
        [x, y] => Ok([x.clone(), y.clone()]),
        _ => Err(Error::WrongCount { what: "coordinates of a point of the plane", expected: 2, found: point.len() }),
    };
    let cubic = Cubic::from_flexes(&planar(first)?, &planar(second)?, &planar(summit)?)?;
    Ok(Answer::new(vec![("curve", Value::Curve(cubic.curve()))]))
}
