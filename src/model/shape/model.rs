//! Models: shape files with any number of pieces.

use serde_json::value::RawValue;

use super::{Kind, Shape, ShapeFile, SplineFile};
use crate::error::Error;
use crate::exact::Rational;
use crate::model::decimals::Decimals;
use crate::model::json::Fault;
use crate::model::splines::SplineWork;
use crate::model::{Flaw, Follow, Format, Model, Part, Place, Places, group_name, without_place};
use crate::piece::Piece;
use crate::weights::homogeneous_points;

/// Reads a shape file of any kind: one piece, a spline, or a model with a list
/// of both.
pub(in crate::model) fn read(text: &str) -> Result<Model, Flaw> {
    let mut reader = ModelReader {
        text,
        places: Places::new(text),
        decimals: Decimals::default(),
        parts: Vec::new(),
        joints: Vec::new(),
        splines: 0,
        work: SplineWork::default(),
    };
    let place_of_error = |error: &serde_json::Error| Place {
        line: u32::try_from(error.line()).unwrap_or(u32::MAX).max(1),
        column: u32::try_from(error.column()).unwrap_or(u32::MAX).max(1),
    };
    let raw: &RawValue =
        serde_json::from_str(text).map_err(|error| Flaw::at(place_of_error(&error), format!("not JSON: {}", without_place(&error))))?;
    match Shape::of(raw) {
        Ok(shape) if shape.kind == Kind::Model => {
            let pieces = shape.pieces().map_err(|fault| reader.flaw(raw, fault))?;
            for raw in pieces {
                reader.add(raw)?;
            }
        }
        _ => reader.add(raw)?,
    }
    let ModelReader { decimals, parts, joints, .. } = reader;
    Ok(Model { joints, ..Model::of_patches(Format::Shape, parts, decimals.finest()) })
}

/// The pieces of a shape file as they are read.
struct ModelReader<'a> {
    text: &'a str,
    places: Places<'a>,
    decimals: Decimals,
    parts: Vec<Part>,
    joints: Vec<Follow>,
    splines: usize,
    work: SplineWork,
}

impl<'a> ModelReader<'a> {
    /// Adds a piece or the pieces of a spline.
    fn add(&mut self, raw: &'a RawValue) -> Result<(), Flaw> {
        let (first, place) = (self.parts.len(), self.place(raw));
        let shape = Shape::of(raw).map_err(|fault| self.flaw(raw, fault))?;
        let is_spline = shape.kind == Kind::Spline;
        for part in self.parts_of(&shape, place).map_err(|fault| self.flaw(raw, fault))? {
            part.add_to(&mut self.parts)?;
        }
        if is_spline {
            self.joints.extend(Follow::chain(first..self.parts.len(), self.splines, place));
            self.splines += 1;
        }
        Ok(())
    }

    fn parts_of(&mut self, shape: &Shape, place: Place) -> Result<Vec<Part>, Fault> {
        match shape.kind {
            Kind::Model => Err(Fault::new("unsupported", "a model holds pieces and splines, no other models")),
            Kind::Spline => {
                let SplineFile { name, degree, knots, points, rational } = shape.spline(&mut self.decimals)?;
                let name = name.as_deref().and_then(group_name);
                let part = |segment| Part { piece: Piece::Curve(segment), rational, has_frame: true, name: name.clone(), place };
                Ok(self.work.pieces(degree, knots, points)?.into_iter().map(part).collect())
            }
            kind => {
                let ShapeFile { name, piece, weights, has_frame } = shape.piece(kind, &mut self.decimals)?;
                let name = name.as_deref().and_then(group_name);
                let rational = weights.is_some();
                let piece = match weights {
                    Some(weights) => homogeneous(&piece, &weights)?,
                    None => piece,
                };
                Ok(vec![Part { piece, rational, has_frame, name, place }])
            }
        }
    }

    fn place(&mut self, raw: &RawValue) -> Place {
        // Raw values are parts of the text.
        self.places.of((raw.get().as_ptr() as usize).saturating_sub(self.text.as_ptr() as usize))
    }

    fn flaw(&mut self, raw: &RawValue, fault: Fault) -> Flaw {
        Flaw::at(self.place(raw), fault.message)
    }
}

/// The piece whose points `(w b, w)` have the weight as their last coordinate.
fn homogeneous(piece: &Piece, weights: &[Rational]) -> Result<Piece, Error> {
    let points: Vec<Vec<Rational>> = piece.points().map(<[Rational]>::to_vec).collect();
    piece.with_points(homogeneous_points(&points, weights)?)
}
