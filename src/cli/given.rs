//! The shapes that a command line gives, as they were written, before it is
//! known which operation they are for.

use clap::ArgMatches;

use super::diagnostic::Problem;
use super::flags::is_given;
use super::source::Source;
use super::variables;
use crate::affine::{Frame, Interval, Rectangle, Triangle};
use crate::model::{ShapeFile, read_shape};
use crate::ops::Operation;
use crate::symbolic::{Polynomial, Symbol};
use crate::syntax::{self, FrameInput, Input, MapInput, Nesting, PointsInput, SyntaxError, Variables};
use crate::value::Domain;

/// A shape as it was written.
pub(super) enum Given {
    Equation(MapInput),
    Points(PointsInput),
    File(Box<ShapeFile>),
}

/// The frame that a flag gives.
pub(super) fn frame_of(text: &str, name: &str) -> Result<Frame<Polynomial>, Problem> {
    let interval = |(r, s)| Interval::new(r, s);
    Ok(match syntax::parse_frame(text).map_err(|error| Problem::syntax(name, text, error))? {
        FrameInput::Interval(r, s) => interval((r, s))?.into(),
        FrameInput::Triangle([r, s, t]) => Triangle::new(r, s, t)?.into(),
        FrameInput::Rectangle([u, v]) => Rectangle::new(interval(u)?, interval(v)?).into(),
    })
}

pub(super) fn domain_of<C>(frame: &Frame<C>) -> Domain {
    match frame {
        Frame::Interval(_) => Domain::Curve,
        Frame::Triangle(_) => Domain::Triangle,
        Frame::Rectangle(_) => Domain::Rectangle,
    }
}

/// A word that became a product of letters, which is rarely what was meant.
pub(super) fn word_note(text: &str) -> Option<String> {
    if text.contains('\\') {
        return None;
    }
    let word = text.split(|letter: char| !letter.is_ascii_alphabetic()).find(|word| word.len() >= 3)?;
    let letters: Vec<String> = word.chars().map(String::from).collect();
    Some(format!("`{word}` is read as the product {}: there are no functions here", letters.join(" ")))
}

impl Given {
    /// Reads the shape of one of the arguments, if the command takes one there.
    pub(super) fn of(verb: &str, matches: &ArgMatches, argument: &str, notes: &mut Vec<String>) -> Result<Option<Self>, Problem> {
        let prefix = if argument == "other" { "other_" } else { "" };
        let takes = |name: &str| Operation::of_verb(verb).any(|operation| operation.parameter(&format!("{prefix}{name}")).is_some());
        let (equations, points) = (takes("curve") || takes("surface"), takes("points"));
        if !equations && !points {
            return Ok(None);
        }
        // One piece is enough where the neighbour is what is asked for.
        if argument == "other" && is_given(matches, "extend") && !is_given(matches, "other") {
            return Ok(None);
        }
        let source = Source::of(matches, argument)?;
        if source.is_shape() {
            let shape = read_shape(&source.text).map_err(|fault| Problem::plain(format!("{}: {}", source.name, fault.message)))?;
            return Ok(Some(Self::File(Box::new(shape))));
        }
        let text = source.expression()?;
        let letters = variables(matches)?;
        let problem = |error: SyntaxError| Problem::syntax(&source.name, text, error);
        // Only where both may stand does the text decide which it is.
        let input = match (equations, points) {
            (true, false) => syntax::parse_map(text, letters.as_deref()).map(Input::Map),
            (false, true) => match syntax::parse_input(text, letters.as_deref()) {
                // Letters of a surface outside of any list: an equation, not points that are symbols.
                Ok(Input::Map(map)) if matches!(map.variables, Variables::Surface(..)) => Ok(Input::Map(map)),
                _ => syntax::parse_points(text).map(Input::Points),
            },
            _ => syntax::parse_input(text, letters.as_deref()),
        };
        // A text of the other kind deserves to be told so.
        let input = input.or_else(|error| syntax::parse_input(text, letters.as_deref()).map_err(|_| error));
        Ok(Some(match input.map_err(problem)? {
            Input::Map(_) if !equations => {
                return Err(Problem::plain(format!("`{verb}` takes control points; this is an equation"))
                    .with_help("`casteljau points` turns an equation into control points"));
            }
            Input::Points(_) if !points => {
                return Err(Problem::plain(format!("`{verb}` takes an equation; these are control points")).with_help(
                    "`casteljau equation` turns control points into an equation, `casteljau reframe` brings them over another frame",
                ));
            }
            Input::Map(map) => {
                notes.extend(word_note(text));
                Self::Equation(map)
            }
            Input::Points(points) => Self::Points(points),
        }))
    }

    /// Whether its control points have weights.
    pub(super) fn is_weighted(&self) -> bool {
        match self {
            Self::Equation(_) => false,
            Self::Points(points) => points.points().any(|point| point.weight.is_some()),
            Self::File(shape) => shape.weights.is_some(),
        }
    }

    /// The kind of shape, as far as the text alone says.
    pub(super) fn domain(&self, frame: Option<&Frame<Polynomial>>, bidegree: bool, is_total: bool) -> Domain {
        let by_frame = frame.map(domain_of);
        match self {
            Self::File(shape) => match shape.piece.frame() {
                Frame::Interval(_) => Domain::Curve,
                Frame::Triangle(_) => Domain::Triangle,
                Frame::Rectangle(_) => Domain::Rectangle,
            },
            Self::Equation(map) => match (map.variables, by_frame) {
                // A constant may be a surface as well.
                (Variables::Curve(variable), Some(Domain::Triangle | Domain::Rectangle)) if !occurs(map, variable) => {
                    by_frame.unwrap_or_default()
                }
                (Variables::Curve(_), _) => Domain::Curve,
                (Variables::Surface(..), Some(found @ (Domain::Triangle | Domain::Rectangle))) => found,
                (Variables::Surface(..), _) if bidegree && !is_total => Domain::Rectangle,
                (Variables::Surface(..), _) => Domain::Triangle,
            },
            Self::Points(points) => match (&points.nesting, by_frame) {
                (_, Some(found @ (Domain::Triangle | Domain::Rectangle))) => found,
                (Nesting::Flat(_), _) if bidegree => Domain::Rectangle,
                (Nesting::Flat(_), _) => Domain::Curve,
                (Nesting::Rows(rows), _) => {
                    let shrinks = rows.len() > 1 && rows[rows.len() - 1].len() < rows[0].len();
                    if shrinks && !bidegree { Domain::Triangle } else { Domain::Rectangle }
                }
            },
        }
    }
}

fn occurs(map: &MapInput, variable: Symbol) -> bool {
    map.components.iter().any(|component| component.degree_in(variable) > 0)
}
