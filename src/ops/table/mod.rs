//! The table of operations: one row each, in a file for every kind of shape.

mod basis;
mod cubic;
mod curve;
mod join;
mod parameters;
mod piece;
mod rectangle;
mod triangle;

use super::limits;
use crate::error::Error;
use crate::exact::Rational;
use crate::symbolic::Polynomial;
use crate::value::{Answer, Arguments, Domain};

/// What an argument is, for the adaptors that read it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// A curve by its equation.
    Curve,
    /// A surface by its equation.
    Surface,
    /// A surface by its equation, however it is read: its degree may be left out.
    AnySurface,
    /// The terms of one coordinate of a surface.
    Terms,
    /// Control points: a list for a curve, rows for a patch.
    Points,
    /// A curve by its equation or by its control points, behind a flag.
    Shape,
    /// The weights of the control points, arranged like them.
    Weights,
    /// A polynomial that an equation is divided by.
    Weight,
    /// A frame of the kind that the operation is about.
    Frame,
    /// The frame of control points; an equation does not need it.
    FrameOfPoints,
    /// A number.
    Number,
    /// One parameter of a curve or two of a surface.
    Place,
    /// The first of two parameters that are given together.
    FirstParameter,
    /// The second one.
    SecondParameter,
    /// A list of numbers.
    Numbers,
    /// A point.
    Point,
    /// A small whole number.
    Count,
    /// Two of these: a bidegree, the index of a control point.
    Counts,
    /// Arguments of a polar form, numbers only.
    Arguments,
    /// Arguments of a polar form, vectors included.
    HomogeneousArguments,
    /// The arguments for the first variable of a bidegree form, numbers only or not.
    FirstArguments(Weighting),
    /// The arguments for the second variable.
    SecondArguments(Weighting),
    /// Arguments in the plane, points only or not.
    PlaneArguments(Weighting),
    /// A polar form that somebody claims.
    Claim,
    /// An affine map of space.
    Map,
    /// The line, plane or hyperplane where an affine function is zero, as a map to the line.
    Plane,
    /// A piece: its frame and its control points, weights last if they are homogeneous.
    Piece,
    /// Two points of the parameter plane.
    Edge,
    /// One of these words.
    Word(&'static [&'static str]),
    /// Yes or no.
    Flag,
}

/// Whether polar arguments may have weights.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Weighting {
    /// Points only.
    Points,
    /// Any homogeneous argument, vectors included.
    Homogeneous,
}

/// One argument of an operation.
#[derive(Clone, Copy, Debug)]
pub struct Parameter {
    /// The name in `batch` requests.
    pub name: &'static str,
    /// What it is.
    pub kind: Kind,
    /// Whether the operation needs it.
    pub required: bool,
    /// The flag on the command line; empty for the shapes, which are positional.
    pub flag: &'static str,
    /// One line of help.
    pub help: &'static str,
}

/// How an operation is carried out.
#[derive(Clone, Copy)]
pub enum Run {
    /// On numbers, and the same on symbolic parameters.
    Any(fn(&Arguments<Rational>) -> Result<Answer<Rational>, Error>, fn(&Arguments<Polynomial>) -> Result<Answer<Polynomial>, Error>),
    /// On numbers only.
    Numeric(fn(&Arguments<Rational>) -> Result<Answer<Rational>, Error>),
}

/// How the size of an answer depends on the size of its arguments.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Growth {
    /// About as many numbers come out as go in, each by itself.
    Direct,
    /// About as many numbers come out as go in, each from all.
    Linear,
    /// Every step of de Casteljau's algorithm.
    Scheme,
    /// A polynomial for every control point.
    Basis,
    /// The work is no function of a degree: the type that does it counts it itself.
    Counted,
    /// Twice as much for a curve at every depth, four times as much for a patch.
    Doubling,
    /// The points of a grid with twice as many steps at every depth.
    Grid,
}

/// One operation.
#[derive(Clone, Copy)]
pub struct Operation {
    /// The name in `batch` requests.
    pub name: &'static str,
    /// The command that carries it out; empty where only `batch` names it.
    pub verb: &'static str,
    /// The kinds of shapes that it is about; what is about none counts as being about curves.
    pub domains: &'static [Domain],
    /// The arguments, or arguments with a value as in `method=one-step`, each
    /// of which makes the command mean this operation instead of its plain one.
    pub selected_by: &'static [&'static str],
    /// What it does, in one line.
    pub doc: &'static str,
    /// A command line that shows it.
    pub example: &'static str,
    /// What it takes.
    pub parameters: &'static [Parameter],
    /// How much it gives.
    pub growth: Growth,
    /// How it is carried out.
    pub run: Run,
}

impl Operation {
    /// Carries out the operation on numbers.
    ///
    /// # Errors
    /// What the operation says, and [`Error::TooLarge`] if it would take too long.
    pub fn on_numbers(&self, arguments: &Arguments<Rational>) -> Result<Answer<Rational>, Error> {
        limits::check(self, arguments)?;
        match self.run {
            Run::Any(run, _) | Run::Numeric(run) => run(arguments),
        }
    }

    /// Carries out the operation on symbolic parameters; `None` if it needs numbers.
    #[must_use]
    pub fn on_symbols(&self, arguments: &Arguments<Polynomial>) -> Option<Result<Answer<Polynomial>, Error>> {
        match self.run {
            Run::Any(_, run) => Some(limits::check(self, arguments).and_then(|()| run(arguments))),
            Run::Numeric(_) => None,
        }
    }

    /// The operation with a name.
    #[must_use]
    pub fn named(name: &str) -> Option<&'static Self> {
        operations().find(|operation| operation.name == name)
    }

    /// The operations of a command, its own first.
    pub fn of_verb(verb: &str) -> impl Iterator<Item = &'static Self> {
        operations().filter(move |operation| operation.verb == verb)
    }

    /// The argument with a name.
    #[must_use]
    pub fn parameter(&self, name: &str) -> Option<&'static Parameter> {
        self.parameters.iter().find(|parameter| parameter.name == name)
    }
}

/// Every operation, in the order of the help.
pub fn operations() -> impl Iterator<Item = &'static Operation> {
    [
        curve::OPERATIONS,
        triangle::OPERATIONS,
        rectangle::OPERATIONS,
        piece::OPERATIONS,
        join::OPERATIONS,
        basis::OPERATIONS,
        cubic::OPERATIONS,
    ]
    .into_iter()
    .flatten()
}

/// What a command does, where that is more than its first operation says.
const COMMANDS: &[(&str, &str)] = &[
    ("polar", "The polar form (blossom) of a curve or surface, its values, and checks of claimed ones"),
    ("points", "The control points of a curve or surface over a frame"),
    ("equation", "The equation of the curve or surface with these control points"),
    ("eval", "The point of a curve or surface at a parameter, and de Casteljau's algorithm step by step"),
    ("split", "The control points of the parts of a subdivided curve or patch"),
    ("segment", "The curve that a surface carries along a segment, an edge, or a line of one parameter"),
    ("reframe", "The control points of the same curve or patch over another frame"),
    ("elevate", "The same curve or patch with more control points"),
    ("reduce", "The true degree, and the same curve or patch with as few control points as it can have"),
    ("derivative", "A derivative of a curve or surface"),
    ("convert", "A rectangular patch as a triangular one, and the other way"),
    ("plot", "A picture of a curve or patch (SVG), or a mesh of a patch (OBJ, glTF)"),
    ("implicit", "The implicit equation of a plane curve, or of the quadric that a surface lies on"),
];

/// What a command does, in one line.
#[must_use]
pub fn about(verb: &str) -> &'static str {
    let own = COMMANDS.iter().find(|(name, _)| *name == verb).map(|(_, doc)| *doc);
    own.or_else(|| Operation::of_verb(verb).next().map(|operation| operation.doc)).unwrap_or("")
}
