//! Functions about planar cubics.

use super::{Fault, Function, Operands, Outcome};
use crate::cubic::{Cubic, Invariants, Special, SpecialPoint};
use crate::curve::Curve;
use crate::error::Error;
use crate::exact::{Rational, Surd};
use crate::kernel::coefficient::Coefficient;
use crate::symbolic::Polynomial;
use crate::value::{Domain, Value};
use crate::worksheet::evaluate::Evaluator;
use crate::worksheet::quantity::{Quantity, rational};
use crate::worksheet::request::{Request, surd};
use crate::worksheet::slip::Slip;

pub(super) const FUNCTIONS: &[Function] = &[
    Function {
        name: "kappa12",
        signatures: &["kappa12(F)"],
        run: |evaluator, operands| invariant(evaluator, operands, |found| found.kappa12.clone()),
    },
    Function {
        name: "kappa23",
        signatures: &["kappa23(F)"],
        run: |evaluator, operands| invariant(evaluator, operands, |found| found.kappa23.clone()),
    },
    Function {
        name: "kappa31",
        signatures: &["kappa31(F)"],
        run: |evaluator, operands| invariant(evaluator, operands, |found| found.kappa31.clone()),
    },
    Function {
        name: "discriminant",
        signatures: &["discriminant(F)"],
        run: |evaluator, operands| invariant(evaluator, operands, Invariants::discriminant),
    },
    Function { name: "class", signatures: &["class(F)"], run: class },
    Function { name: "flexes", signatures: &["flexes(F)"], run: |_, operands| all(operands, point) },
    Function { name: "flextimes", signatures: &["flextimes(F)"], run: flex_times },
    Function { name: "cusp", signatures: &["cusp(F)"], run: |_, operands| one(operands, "cusp", Special::cusp, point) },
    Function { name: "cusptime", signatures: &["cusptime(F)"], run: |_, operands| one(operands, "cusp", Special::cusp, time) },
    Function { name: "summit", signatures: &["summit(F)"], run: |_, operands| one(operands, "summit", Special::summit, point) },
    Function { name: "summittime", signatures: &["summittime(F)"], run: summit_time },
    Function { name: "vertex", signatures: &["vertex(F)"], run: |_, operands| one(operands, "vertex", vertex, point) },
    Function { name: "vertextime", signatures: &["vertextime(F)"], run: |_, operands| one(operands, "vertex", vertex, time) },
    Function { name: "crunode", signatures: &["crunode(F)"], run: crunode },
    Function { name: "crunodetimes", signatures: &["crunodetimes(F)"], run: crunode_times },
    Function { name: "acnode", signatures: &["acnode(F)"], run: acnode },
    Function { name: "equivalent", signatures: &["equivalent(F, G)"], run: equivalent },
];

/// The curve with numbers only.
fn numeric(operands: &Operands<'_>, index: usize) -> Result<Curve, Fault> {
    let curve = operands.polynomial_curve(index)?.curve()?;
    Ok(curve.map(&mut rational)?)
}

fn invariant(evaluator: &Evaluator<'_>, operands: &Operands<'_>, read: fn(&Invariants<Polynomial>) -> Polynomial) -> Outcome {
    operands.ends(1)?;
    let found = Invariants::of(&operands.polynomial_curve(0)?.curve()?)?;
    Ok(Quantity::from(read(&with_signs(found, evaluator.slip))))
}

/// The invariants with one of their signs mistaken.
fn with_signs<C: Coefficient>(mut found: Invariants<C>, slip: Option<Slip>) -> Invariants<C> {
    match slip {
        Some(Slip::Kappa23) => found.kappa23 = C::nothing().minus(&found.kappa23),
        Some(Slip::Kappa31) => found.kappa31 = C::nothing().minus(&found.kappa31),
        _ => {}
    }
    found
}

/// The parameters of the flexes with a sign mistaken: the roots of κ12 - 3 κ31 t + 3 κ23 t².
fn mistaken_flexes(operands: &Operands<'_>, slip: Slip) -> Outcome {
    let found = with_signs(Cubic::new(&numeric(operands, 0)?)?.invariants(), Some(slip));
    let discriminant = found.discriminant() * Rational::from(3);
    let half = (found.kappa23.clone() * Rational::from(6)).recip();
    let (Some(half), Some(root)) = (half, Polynomial::square_root(&discriminant)) else {
        return Err(Error::Unsupported("there are no flexes".into()).into());
    };
    let middle = Polynomial::from(found.kappa31 * Rational::from(3));
    let mut times = [&middle - &root, &middle + &root].map(|time| time.scale(&half).with_simple_roots());
    times.sort_by(|a, b| a.compare_numbers(b).unwrap_or(std::cmp::Ordering::Equal));
    Ok(Quantity::List(times.into_iter().map(Quantity::Number).collect()))
}

fn flex_times(evaluator: &Evaluator<'_>, operands: &Operands<'_>) -> Outcome {
    match evaluator.slip {
        Some(slip @ (Slip::Kappa23 | Slip::Kappa31)) => mistaken_flexes(operands, slip),
        _ => all(operands, time),
    }
}

fn summit_time(evaluator: &Evaluator<'_>, operands: &Operands<'_>) -> Outcome {
    let value = one(operands, "summit", Special::summit, time)?;
    Ok(match (evaluator.slip, value) {
        (Some(Slip::Kappa23 | Slip::Kappa31), Quantity::Number(value)) => Quantity::Number(-value),
        (_, value) => value,
    })
}

fn class(evaluator: &Evaluator<'_>, operands: &Operands<'_>) -> Outcome {
    operands.ends(1)?;
    if let Some(slip @ (Slip::Kappa23 | Slip::Kappa31)) = evaluator.slip {
        return Ok(Quantity::Word(with_signs(Cubic::new(&numeric(operands, 0)?)?.invariants(), Some(slip)).class().name()));
    }
    Ok(Request::new("cubic.class", Domain::Curve)
        .with("curve", Value::Curve(operands.polynomial_curve(0)?.curve()?))
        .reply()?
        .take("class")?)
}

/// The special points, refused for coefficients that would make them very long.
fn special(operands: &Operands<'_>) -> Result<Special, Fault> {
    const MAX_BITS: u64 = 1 << 15;
    operands.ends(1)?;
    let cubic = Cubic::new(&numeric(operands, 0)?)?;
    if cubic.vectors().iter().flatten().map(Rational::bits).max().unwrap_or(0) > MAX_BITS {
        return Err(Error::TooLarge { what: "length of a coefficient, in bits,", limit: MAX_BITS as usize }.into());
    }
    Ok(cubic.special_points())
}

fn surds(list: &[Surd]) -> Result<Vec<Polynomial>, Error> {
    list.iter().map(surd).collect()
}

fn point(found: &SpecialPoint) -> Result<Quantity, Error> {
    Ok(Quantity::point(surds(&found.point)?))
}

fn time(found: &SpecialPoint) -> Result<Quantity, Error> {
    Ok(Quantity::from(surd(&found.t)?))
}

fn all(operands: &Operands<'_>, read: fn(&SpecialPoint) -> Result<Quantity, Error>) -> Outcome {
    Ok(Quantity::List(special(operands)?.flexes().iter().map(read).collect::<Result<_, _>>()?))
}

fn vertex(special: &Special) -> Option<&SpecialPoint> {
    match special {
        Special::Parabolic { vertex } => Some(vertex),
        _ => None,
    }
}

/// An error that a curve of this class has no such point.
fn none(special: &Special, what: &str) -> Fault {
    Fault::Of(Error::Unsupported(format!("this curve has no {what}: its class is {}", special.class().name())))
}

fn one(
    operands: &Operands<'_>,
    what: &str,
    find: fn(&Special) -> Option<&SpecialPoint>,
    read: fn(&SpecialPoint) -> Result<Quantity, Error>,
) -> Outcome {
    let special = special(operands)?;
    let found = find(&special).ok_or_else(|| none(&special, what))?;
    Ok(read(found)?)
}

fn crunode(_: &Evaluator<'_>, operands: &Operands<'_>) -> Outcome {
    match special(operands)? {
        Special::Loopy { crunode, .. } => Ok(Quantity::point(crunode.iter().cloned().map(Polynomial::from).collect())),
        special => Err(none(&special, "crunode")),
    }
}

fn crunode_times(_: &Evaluator<'_>, operands: &Operands<'_>) -> Outcome {
    match special(operands)? {
        Special::Loopy { parameters, .. } => Ok(Quantity::List(surds(&parameters)?.into_iter().map(Quantity::from).collect())),
        special => Err(none(&special, "crunode")),
    }
}

fn acnode(_: &Evaluator<'_>, operands: &Operands<'_>) -> Outcome {
    match special(operands)? {
        Special::Humpy { acnode, .. } => Ok(Quantity::point(acnode.iter().cloned().map(Polynomial::from).collect())),
        special => Err(none(&special, "acnode")),
    }
}

fn equivalent(_: &Evaluator<'_>, operands: &Operands<'_>) -> Outcome {
    operands.ends(2)?;
    let (first, second) = (Cubic::new(&numeric(operands, 0)?)?, Cubic::new(&numeric(operands, 1)?)?);
    Ok(Quantity::truth(first.equivalence(&second).is_some()))
}
