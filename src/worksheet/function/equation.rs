//! Functions about implicit equations, and about what encloses a net.

use super::net::named;
use super::{Fault, Function, Operands, Outcome};
use crate::algebraic::AlgebraicNumber;
use crate::curve::Curve;
use crate::error::Error;
use crate::exact::Rational;
use crate::implicit::{ImplicitCurve, Parameters};
use crate::quadric::{QUADRIC_MONOMIALS, QuadricSurface};
use crate::surface::Surface;
use crate::symbolic::{Monomial, Polynomial, Symbol};
use crate::value::{Domain, Value};
use crate::worksheet::evaluate::Evaluator;
use crate::worksheet::quantity::{Quantity, rational};
use crate::worksheet::request::{Request, surd};

pub(super) const FUNCTIONS: &[Function] = &[
    Function { name: "implicit", signatures: &["implicit(F)"], run: implicit },
    Function { name: "conic", signatures: &["conic(F)"], run: conic },
    Function { name: "parameters", signatures: &["parameters(F, (x,y))"], run: parameters },
    Function { name: "quadric", signatures: &["quadric(S)"], run: quadric },
    Function { name: "quadricclass", signatures: &["quadricclass(S)"], run: quadric_class },
    Function { name: "hull", signatures: &["hull(K)"], run: hull },
    Function { name: "inhull", signatures: &["inhull(K, (x,y))"], run: in_hull },
    Function { name: "box", signatures: &["box(K)"], run: bounding_box },
    Function { name: "roots", signatures: &["roots(K)"], run: roots },
];

fn curve(operands: &Operands<'_>) -> Result<Curve, Fault> {
    Ok(operands.polynomial_curve(0)?.curve()?.map(&mut rational)?)
}

fn surface(operands: &Operands<'_>) -> Result<Surface, Fault> {
    let map = operands.surface(0)?;
    if map.weight.is_some() {
        return Err(operands.wrong(0, "found a surface with a weight, expected one without"));
    }
    Ok(map.surface(true)?.map(&mut rational)?)
}

fn implicit(_: &Evaluator<'_>, operands: &Operands<'_>) -> Outcome {
    operands.ends(1)?;
    Ok(Quantity::Equation(ImplicitCurve::of(&curve(operands)?)?.polynomial()))
}

fn conic(_: &Evaluator<'_>, operands: &Operands<'_>) -> Outcome {
    operands.ends(1)?;
    let found = ImplicitCurve::of(&curve(operands)?)?.conic_type();
    found.map(|conic| Quantity::Word(conic.name())).ok_or_else(|| operands.wrong(0, "found a curve that is no conic"))
}

fn parameters(_: &Evaluator<'_>, operands: &Operands<'_>) -> Outcome {
    operands.ends(2)?;
    let point: Vec<Rational> = operands.point(1)?.iter().map(rational).collect::<Result<_, _>>()?;
    let found = match curve(operands)?.parameters_of(&point)? {
        Parameters::All => return Ok(Quantity::Word("all")),
        Parameters::These(list) => list,
    };
    let number = |number: &AlgebraicNumber| match number {
        AlgebraicNumber::Surd(value) => Ok(Quantity::from(surd(value)?)),
        AlgebraicNumber::Isolated(_) => Err(Error::Unsupported("a parameter is no number a ± √d".into())),
    };
    Ok(Quantity::List(found.iter().map(number).collect::<Result<_, _>>()?))
}

fn quadric(_: &Evaluator<'_>, operands: &Operands<'_>) -> Outcome {
    operands.ends(1)?;
    let found = QuadricSurface::of(&surface(operands)?)?;
    let Some(coefficients) = &found.quadric else {
        return Err(operands.wrong(0, format!("found a surface that lies on {} quadrics, expected one quadric", found.quadrics)));
    };
    let terms = QUADRIC_MONOMIALS.into_iter().zip(coefficients).map(|(name, c)| {
        let letters = name.chars().filter(char::is_ascii_alphabetic).map(|letter| (Symbol::new(letter, None), power(name)));
        (Monomial::from_factors(letters), Rational::from(c.clone()))
    });
    Ok(Quantity::Equation(Polynomial::from_terms(terms)))
}

/// The power of each letter in the name of a monomial, such as `x^2`, `x2` or `xy`.
fn power(name: &str) -> u32 {
    if name.contains('2') { 2 } else { 1 }
}

fn quadric_class(_: &Evaluator<'_>, operands: &Operands<'_>) -> Outcome {
    operands.ends(1)?;
    Ok(Quantity::Word(QuadricSurface::of(&surface(operands)?)?.class.name()))
}

fn hull(_: &Evaluator<'_>, operands: &Operands<'_>) -> Outcome {
    operands.ends(1)?;
    let net = operands.net(0)?;
    let (operation, domain) = named(net, ["hull"; 3]);
    Ok(Request::new(operation, domain).with_net(net)?.reply()?.take("hull")?)
}

fn in_hull(_: &Evaluator<'_>, operands: &Operands<'_>) -> Outcome {
    operands.ends(2)?;
    let net = operands.net(0)?;
    let (operation, domain) = named(net, ["hull"; 3]);
    let request = Request::new(operation, domain).with_net(net)?.with("point", Value::Point(operands.point(1)?));
    Ok(request.reply()?.take("contains")?)
}

fn bounding_box(_: &Evaluator<'_>, operands: &Operands<'_>) -> Outcome {
    operands.ends(1)?;
    let net = operands.net(0)?;
    let (operation, domain) = named(net, ["hull"; 3]);
    Ok(Request::new(operation, domain).with_net(net)?.reply()?.take("box")?)
}

fn roots(_: &Evaluator<'_>, operands: &Operands<'_>) -> Outcome {
    operands.ends(1)?;
    let net = operands.net(0)?;
    Ok(Request::new("roots.bernstein", Domain::Curve).with_net(net)?.reply()?.take("distinct_roots_open")?)
}
