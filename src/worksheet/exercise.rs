//! Exercises with pleasant numbers, and their worked solutions.

mod numbers;

use std::fmt::Write as _;

use super::work::{Task, page};
use crate::affine::{Frame, Interval};
use crate::cubic::{Cubic, CubicClass};
use crate::curve::Curve;
use crate::error::Error;
use crate::exact::Rational;
use crate::segment::Segment;
use crate::symbolic::{Polynomial, Symbol};
use crate::syntax::{MapInput, Span, Style, Variables, printer};
use numbers::Numbers;

/// The most exercises of one run.
pub const MAX_EXERCISES: u16 = 200;

/// What an exercise asks for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Exercise {
    /// The polar form of a curve.
    Polar,
    /// The control points of a curve over a frame.
    Points,
    /// De Casteljau's algorithm on a control polygon.
    Casteljau,
    /// The class of a planar cubic.
    Classify,
    /// The order of continuity of two curves.
    Join,
}

impl Exercise {
    /// All kinds.
    pub const ALL: [Self; 5] = [Self::Polar, Self::Points, Self::Casteljau, Self::Classify, Self::Join];

    /// The name on the command line.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Polar => "polar",
            Self::Points => "points",
            Self::Casteljau => "casteljau",
            Self::Classify => "classify",
            Self::Join => "join",
        }
    }
}

/// Exercises and, apart, their solutions; both Markdown.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Exercises {
    /// What is to be done.
    pub exercises: String,
    /// The same, done: each solution is a part of one worksheet of claims.
    pub solutions: String,
}

/// Exercises of a kind; the same seed gives the same ones.
///
/// # Errors
/// None that is known: what making the curves says.
pub fn exercises(kind: Exercise, seed: u64, count: u16) -> Result<Exercises, Error> {
    let mut numbers = Numbers::new(seed ^ (kind as u64) << 56);
    let title = match kind {
        Exercise::Polar => "Polar forms",
        Exercise::Points => "Control points",
        Exercise::Casteljau => "De Casteljau's algorithm",
        Exercise::Classify => "Classes of planar cubics",
        Exercise::Join => "Smooth joins",
    };
    let (mut exercises, mut solutions) = (format!("# {title}\n\n"), format!("# {title}: solutions\n\n"));
    for number in 1..=count {
        let (question, answer) = match kind {
            Exercise::Polar => polar(&mut numbers, number)?,
            Exercise::Points => points(&mut numbers, number)?,
            Exercise::Casteljau => casteljau(&mut numbers, number)?,
            Exercise::Classify => classify(&mut numbers, number)?,
            Exercise::Join => join(&mut numbers, number)?,
        };
        // Writing to a string does not fail.
        let _ = write!(exercises, "**{number}.** {question}\n\n");
        let _ = write!(solutions, "## Exercise {number}\n\n{question}\n\n{}", answer.replace("## ", "### "));
    }
    Ok(Exercises { exercises, solutions })
}

fn t() -> Symbol {
    Symbol::new('t', None)
}

fn map_of(components: Vec<Polynomial>) -> MapInput {
    let spans = vec![Span::default(); components.len()];
    MapInput { components, spans, variables: Variables::Curve(t()), is_point: true }
}

fn shown(components: &[Polynomial]) -> String {
    let parts: Vec<String> = components.iter().map(|component| printer::polynomial(component, &[t()], Style::Latex)).collect();
    match parts.as_slice() {
        [only] => only.clone(),
        several => printer::point(several, Style::Latex),
    }
}

/// A polynomial whose coefficients are whole after division by the binomial numbers.
fn pleasant(numbers: &mut Numbers, degree: usize, polar_degree: usize) -> Polynomial {
    let binomials = crate::blossom::binomials(polar_degree);
    let mut coefficients: Vec<Polynomial> = (0..=degree)
        .map(|k| {
            let factor = if numbers.below(3) == 0 { Rational::from(1) } else { binomials[k].clone() };
            Polynomial::from(Rational::from(numbers.between(-4, 4)) * factor)
        })
        .collect();
    if coefficients[degree].as_rational() == Some(Rational::from(0)) {
        coefficients[degree] = Polynomial::from(binomials[degree].clone());
    }
    Polynomial::from_coefficients(t(), &coefficients)
}

fn polar(numbers: &mut Numbers, number: u16) -> Result<(String, String), Error> {
    let degree = 2 + numbers.below(2) as usize;
    let low = numbers.between(1, degree as i64) as usize;
    let components = vec![pleasant(numbers, low, degree), pleasant(numbers, degree, degree)];
    let question = format!("Find the polar form of $F(t) = {}$.", shown(&components));
    let task = Task { map: map_of(components), degree: None, bidegree: None, frame: None, at: None };
    Ok((question, page(&task, Some(number))?.sections))
}

/// Control points in whole numbers, none of them like the one before.
fn polygon(numbers: &mut Numbers, degree: usize, multiple: i64) -> Vec<Vec<Rational>> {
    let mut points: Vec<Vec<Rational>> = Vec::new();
    while points.len() <= degree {
        let point: Vec<Rational> = (0..2).map(|_| Rational::from(multiple * numbers.between(-4, 4))).collect();
        if points.last() != Some(&point) {
            points.push(point);
        }
    }
    points
}

fn interval(from: i64, to: i64) -> Result<Interval, Error> {
    Interval::new(Rational::from(from), Rational::from(to))
}

fn symbolic(frame: &Interval) -> Result<Frame<Polynomial>, Error> {
    Ok(Interval::new(Polynomial::from(frame.r().clone()), Polynomial::from(frame.s().clone()))?.into())
}

fn points(numbers: &mut Numbers, number: u16) -> Result<(String, String), Error> {
    let degree = 2 + numbers.below(2) as usize;
    let from = numbers.between(-2, 1);
    let frame = interval(from, from + 1 + numbers.between(0, 1))?;
    let curve = Segment::from_points(polygon(numbers, degree, 1), frame.clone())?.curve()?;
    let components = curve.polynomials(t());
    let question = format!("Find the control points of $F(t) = {}$ over the frame ${}..{}$.", shown(&components), frame.r(), frame.s());
    let task = Task { map: map_of(components), degree: Some(degree), bidegree: None, frame: Some(symbolic(&frame)?), at: None };
    Ok((question, page(&task, Some(number))?.sections))
}

fn list(points: &[Vec<Rational>], style: Style) -> String {
    let point = |point: &Vec<Rational>| printer::point(&point.iter().map(|x| printer::rational(x, style)).collect::<Vec<_>>(), style);
    points.iter().map(point).collect::<Vec<_>>().join(", ")
}

fn casteljau(numbers: &mut Numbers, number: u16) -> Result<(String, String), Error> {
    let degree = 2 + numbers.below(2) as usize;
    let frame = interval(0, 1)?;
    let t = [Rational::new(1, 2), Rational::new(1, 2), Rational::new(1, 4), Rational::from(2)][numbers.below(4) as usize].clone();
    let points = polygon(numbers, degree, 4);
    let segment = Segment::from_points(points.clone(), frame)?;
    let scheme = segment.scheme(&t)?;
    let at = printer::rational(&t, Style::Latex);
    let question = format!(
        "A curve has the control points ${}$ over the frame $0..1$. Find its point at $t = {at}$ by de Casteljau's algorithm, and the \
         control points of both parts.",
        list(&points, Style::Latex)
    );
    let layers: Vec<String> = (0..=degree)
        .map(|layer| format!("[{}]", list(&scheme.layer(layer).map(<[Rational]>::to_vec).collect::<Vec<_>>(), Style::Text)))
        .collect();
    let side = |points: Vec<&[Rational]>| list(&points.into_iter().map(<[Rational]>::to_vec).collect::<Vec<_>>(), Style::Text);
    let (left, right) = (side(scheme.left().collect()), side(scheme.right().collect()));
    let answer = format!(
        "Each step takes ${}$ of a point and ${}$ of the next.\n\n```casteljau\nK{number} = curve([{}], 0..1)\ncasteljau(K{number}, {t}) == [{}]\nK{number}({t}) == {}\n\
         split(K{number}, {t}) == [[{left}], [{right}]]\n```\n\n",
        printer::rational(&(Rational::from(1) - &t), Style::Latex),
        at,
        list(&points, Style::Text),
        layers.join(",\n    "),
        printer::point(&scheme.point().iter().map(ToString::to_string).collect::<Vec<_>>(), Style::Text),
    );
    Ok((question, answer))
}

fn classify(numbers: &mut Numbers, number: u16) -> Result<(String, String), Error> {
    use CubicClass::{Humpy, Loopy, Parabolic, Pointy, SShaped};
    let wanted = [Humpy, Loopy, Pointy, SShaped, Loopy, Humpy, Parabolic][usize::from(number - 1) % 7];
    // A standard form under a map of the plane and a shift of the parameter keeps its class and has small numbers.
    let standard = wanted.standard_cubic().ok_or_else(|| Error::Unsupported("there is no standard form".into()))?;
    let shift = numbers.between(-1, 1);
    let (a, b, c, d) = loop {
        let entries = [(); 4].map(|()| numbers.between(-2, 2));
        let [a, b, c, d] = entries;
        if a * d - b * c != 0 {
            break (a, b, c, d);
        }
    };
    let value = Polynomial::from(t()) + Polynomial::from(Rational::from(shift));
    let moved: Vec<Polynomial> = standard.curve().polynomials(t()).iter().map(|component| component.substitute(t(), &value)).collect();
    let combine = |x: i64, y: i64, z: i64| {
        moved[0].scale(&Rational::from(x)) + moved[1].scale(&Rational::from(y)) + Polynomial::from(Rational::from(z))
    };
    let components = vec![combine(a, b, numbers.between(-3, 3)), combine(c, d, numbers.between(-3, 3))];
    let question = format!("Find the class of $F(t) = {}$, and its special points.", shown(&components));
    let coordinates = components
        .iter()
        .map(|component| component.coefficients_in(t()).iter().map(|c| c.as_rational().unwrap_or_default()).collect::<Vec<Rational>>());
    let cubic = Cubic::new(&Curve::new(coordinates.collect())?)?;
    let invariants = cubic.invariants();
    let text: Vec<String> = components.iter().map(|component| printer::polynomial(component, &[t()], Style::Text)).collect();
    let n = number;
    let mut lines = format!(
        "F{n}(t) = {}\nkappa12(F{n}) == {}\nkappa23(F{n}) == {}\nkappa31(F{n}) == {}\n\
         discriminant(F{n}) == 3 kappa31(F{n})^2 - 4 kappa12(F{n}) kappa23(F{n}) == {}\nclass(F{n}) == {}\n",
        printer::point(&text, Style::Text),
        invariants.kappa12,
        invariants.kappa23,
        invariants.kappa31,
        invariants.discriminant(),
        cubic.class().name()
    );
    let special = cubic.special_points();
    let place = |point: &[crate::exact::Surd; 2]| format!("({}, {})", point[0], point[1]);
    if !special.flexes().is_empty() {
        let times: Vec<String> = special.flexes().iter().map(|flex| flex.t.to_string()).collect();
        let places: Vec<String> = special.flexes().iter().map(|flex| place(&flex.point)).collect();
        let _ = writeln!(lines, "flextimes(F{n}) == [{}]\nflexes(F{n}) == [{}]", times.join(", "), places.join(", "));
    }
    if let (Loopy, Some(crunode)) = (cubic.class(), special.double_point()) {
        let times: Vec<String> = special.crunode_parameters().iter().map(ToString::to_string).collect();
        let _ = writeln!(lines, "crunode(F{n}) == ({}, {})\ncrunodetimes(F{n}) == [{}]", crunode[0], crunode[1], times.join(", "));
    }
    if let Some(cusp) = special.cusp() {
        let _ = writeln!(lines, "cusptime(F{n}) == {}\ncusp(F{n}) == {}", cusp.t, place(&cusp.point));
    }
    if let crate::cubic::Special::Parabolic { vertex } = &special {
        let _ = writeln!(lines, "vertextime(F{n}) == {}\nvertex(F{n}) == {}", vertex.t, place(&vertex.point));
    }
    let answer = format!("The three determinants decide: {}.\n\n```casteljau\n{lines}```\n\n", invariants.branch().conditions());
    Ok((question, answer))
}

fn join(numbers: &mut Numbers, number: u16) -> Result<(String, String), Error> {
    let (degree, asked) = (2 + numbers.below(2) as usize, numbers.below(4));
    let (frame, next) = (interval(0, 1)?, interval(1, 2)?);
    let points = polygon(numbers, degree, 2);
    let segment = Segment::from_points(points.clone(), frame)?;
    // The continuation has all derivatives; from some point on it is moved away.
    let mut continued: Vec<Vec<Rational>> = segment.reframe(&next)?.points().map(<[Rational]>::to_vec).collect();
    if let Some(point) = continued.get_mut(asked as usize) {
        point[numbers.below(2) as usize] += Rational::from(1 + numbers.between(0, 2));
    }
    let second = Segment::from_points(continued.clone(), next)?;
    let found = crate::continuity::continuity_of_curves(&segment.curve()?, &second.curve()?, &Rational::from(1))?;
    let question = format!(
        "Two curves have the control points ${}$ over $0..1$ and ${}$ over $1..2$. How smoothly do they join?",
        list(&points, Style::Latex),
        list(&continued, Style::Latex)
    );
    let mut lines = format!(
        "K{number} = curve([{}], 0..1)\nL{number} = curve([{}], 1..2)\n",
        list(&points, Style::Text),
        list(&continued, Style::Text)
    );
    let arguments = |count: usize| {
        let list = std::iter::repeat_n("1", degree - count).chain(std::iter::repeat_n("2", count));
        list.collect::<Vec<_>>().join(",")
    };
    use crate::continuity::Continuity;
    let (last, claim) = match found {
        Continuity::Broken => (0, format!("join(K{number}, L{number}) < C0")),
        Continuity::C(order) => ((order + 1).min(degree), format!("join(K{number}, L{number}) == C{order}")),
        Continuity::Same => (degree, format!("join(K{number}, L{number}) == same")),
    };
    for count in 0..=last {
        let holds = match found {
            Continuity::Broken => false,
            Continuity::C(order) => count <= order,
            Continuity::Same => true,
        };
        let sign = if holds { "==" } else { "!=" };
        let _ = writeln!(lines, "k{number}({0}) {sign} l{number}({0})", arguments(count));
    }
    let answer = format!(
        "They are C^k where the polar values agree that have at most k arguments off the joint, which is at 1:\n\n```casteljau\n{lines}{claim}\n```\n\n"
    );
    Ok((question, answer))
}
