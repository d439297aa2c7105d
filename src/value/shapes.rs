//! The curves, surfaces and pieces that arguments make.

use super::arguments::{missing, wrong_frame};
use super::{Arguments, Value};
use crate::affine::Frame;
use crate::curve::Curve;
use crate::error::Error;
use crate::kernel::coefficient::Coefficient;
use crate::piece::Piece;
use crate::reading::Reading;
use crate::rectangular::RectangularPatch;
use crate::segment::Segment;
use crate::surface::Surface;
use crate::symbolic::Polynomial;
use crate::triangular::TriangularPatch;
use crate::weights::homogeneous_points;

impl<C: Coefficient> Arguments<C> {
    /// The curve, by its equation or by its control points.
    ///
    /// # Errors
    /// [`Error::WrongShape`] if there is neither, and what making it of control points says.
    pub fn curve(&self) -> Result<Curve<C>, Error> {
        match (self.get("curve"), self.get("points")) {
            (Some(Value::Curve(curve)), None) => self.raised(curve.clone()),
            (None, Some(Value::Points(_))) => self.segment()?.curve(),
            _ => Err(missing("curve")),
        }
    }

    /// The surface, by its equation or by its control points, read as the
    /// operation reads surfaces.
    ///
    /// # Errors
    /// [`Error::WrongShape`] if there is neither, and what making it of control points says.
    pub fn surface(&self) -> Result<Surface<C>, Error> {
        match (self.get("surface"), self.get("points")) {
            (Some(Value::Surface(surface)), None) => self.read(surface.clone()),
            (None, Some(_)) => match self.piece()? {
                Piece::Triangle(patch) => patch.surface(),
                Piece::Rectangle(patch) => patch.surface(),
                Piece::Curve(_) => Err(missing("surface")),
            },
            _ => Err(missing("surface")),
        }
    }

    /// The segment over `frame`, by control points or by an equation.
    ///
    /// # Errors
    /// [`Error::WrongShape`] if there is neither, and what making it says.
    pub fn segment(&self) -> Result<Segment<C>, Error> {
        match self.piece()? {
            Piece::Curve(segment) => Ok(segment),
            _ => Err(missing("points")),
        }
    }

    /// The triangular patch, by control points or by an equation.
    ///
    /// # Errors
    /// [`Error::WrongShape`] if there is neither, and what making it says.
    pub fn triangular(&self) -> Result<TriangularPatch<C>, Error> {
        match self.piece()? {
            Piece::Triangle(patch) => Ok(patch),
            _ => Err(missing("points")),
        }
    }

    /// The rectangular patch, by control points or by an equation.
    ///
    /// # Errors
    /// [`Error::WrongShape`] if there is neither, and what making it says.
    pub fn rectangular(&self) -> Result<RectangularPatch<C>, Error> {
        match self.piece()? {
            Piece::Rectangle(patch) => Ok(patch),
            _ => Err(missing("points")),
        }
    }

    /// The piece over `frame`, of the kind the operation is about.
    ///
    /// # Errors
    /// [`Error::WrongShape`] if there is none, and what making it says.
    pub fn piece(&self) -> Result<Piece<C>, Error> {
        self.piece_over(self.frame_or_default("frame"))
    }

    /// The piece over a frame.
    ///
    /// # Errors
    /// As for [`Arguments::piece`].
    pub fn piece_over(&self, frame: Frame<C>) -> Result<Piece<C>, Error> {
        self.piece_of(["curve", "surface", "points", "weights"], frame)
    }

    /// The second piece of an operation on two, over the frame of the first
    /// unless it has its own.
    ///
    /// # Errors
    /// As for [`Arguments::piece`].
    pub fn other_piece(&self) -> Result<Piece<C>, Error> {
        let frame = self.any_frame("other_frame").cloned().unwrap_or_else(|_| self.frame_or_default("frame"));
        self.piece_of(["other_curve", "other_surface", "other_points", "other_weights"], frame)
    }

    fn piece_of(&self, [curve, surface, points, weights]: [&str; 4], frame: Frame<C>) -> Result<Piece<C>, Error> {
        if self.get("weight").is_some() && self.get(points).is_some() {
            return Err(Error::WrongShape("`weight` goes with an equation; control points have a weight each, as in (1,1):2".into()));
        }
        let lifted = |points: Vec<Vec<C>>| match self.get(weights) {
            Some(Value::Numbers(weights)) => homogeneous_points(&points, weights),
            _ => Ok(points),
        };
        Ok(match (self.get(points), self.get(curve), self.get(surface), frame) {
            (Some(Value::Points(points)), _, _, Frame::Interval(frame)) => {
                self.check_count(points.len())?;
                Piece::Curve(Segment::from_points(lifted(points.clone())?, frame)?)
            }
            (Some(Value::Rows(rows)), _, _, Frame::Triangle(frame)) => {
                // Made of rows first, so that an odd row is named.
                let degree = TriangularPatch::from_rows(rows.clone(), frame.clone())?.degree();
                self.check_degree(degree)?;
                Piece::Triangle(TriangularPatch::from_points(lifted(rows.iter().flatten().cloned().collect())?, frame)?)
            }
            (Some(Value::Rows(rows)), _, _, Frame::Rectangle(frame)) => {
                let degree = RectangularPatch::from_rows(rows.clone(), frame.clone())?.degree();
                self.check_bidegree(degree)?;
                Piece::Rectangle(RectangularPatch::from_points(degree, lifted(rows.iter().flatten().cloned().collect())?, frame)?)
            }
            (None, Some(Value::Curve(curve)), _, Frame::Interval(frame)) => Piece::Curve(self.raised(curve.clone())?.segment(&frame)?),
            (None, _, Some(Value::Surface(surface)), Frame::Triangle(frame)) => {
                Piece::Triangle(self.read(surface.clone())?.over_triangle(&frame)?)
            }
            (None, _, Some(Value::Surface(surface)), Frame::Rectangle(frame)) => {
                Piece::Rectangle(self.read(surface.clone())?.over_rectangle(&frame)?)
            }
            (None, None, None, _) => return Err(missing(points)),
            (_, _, _, frame) => return Err(wrong_frame(&format!("the frame of a {}", self.domain.name()), &frame)),
        })
    }

    fn check_bidegree(&self, found: (usize, usize)) -> Result<(), Error> {
        match self.pair("bidegree") {
            Ok((p, q)) if (p, q) != found => {
                Err(Error::WrongCount { what: "control points", expected: (p + 1) * (q + 1), found: (found.0 + 1) * (found.1 + 1) })
            }
            _ => Ok(()),
        }
    }

    /// The degree of a curve, where it is given beside the points.
    fn check_count(&self, found: usize) -> Result<(), Error> {
        match self.get("degree") {
            Some(Value::Count(degree)) if degree + 1 != found => {
                Err(Error::WrongCount { what: "control points", expected: degree + 1, found })
            }
            _ => Ok(()),
        }
    }

    /// The degree of a net, where it is given beside the points.
    fn check_degree(&self, found: usize) -> Result<(), Error> {
        match self.get("degree") {
            Some(Value::Count(degree)) if *degree != found => {
                let expected = (degree + 1) * (degree + 2) / 2;
                Err(Error::WrongCount { what: "control points", expected, found: (found + 1) * (found + 2) / 2 })
            }
            _ => Ok(()),
        }
    }

    fn raised(&self, mut curve: Curve<C>) -> Result<Curve<C>, Error> {
        if let Some(weight) = self.weight()? {
            let [variable] = [self.variable()];
            let weight = weight.coefficients_in(variable).iter().map(number_of).collect::<Result<_, _>>()?;
            curve = curve.with_coordinate(weight)?;
        }
        match self.get("degree") {
            Some(Value::Count(degree)) => curve.with_degree(*degree),
            _ => Ok(curve),
        }
    }

    /// The weight that a map is divided by, if it has one.
    fn weight(&self) -> Result<Option<Polynomial>, Error> {
        match self.get("weight") {
            Some(Value::Expressions(list)) => match list.as_slice() {
                [weight] => Ok(Some(weight.clone())),
                other => Err(Error::WrongCount { what: "weights", expected: 1, found: other.len() }),
            },
            _ => Ok(None),
        }
    }

    /// A surface in the way that the arguments or the kind of shape ask for.
    fn read(&self, mut surface: Surface<C>) -> Result<Surface<C>, Error> {
        if let Some(weight) = self.weight()? {
            let [u, v] = self.variables();
            let mut terms = Vec::new();
            for (h, row) in weight.coefficients_in(u).iter().enumerate() {
                for (k, c) in row.coefficients_in(v).iter().enumerate() {
                    terms.push((h, k, number_of(c)?));
                }
            }
            surface = surface.with_coordinate(terms)?;
        }
        match (self.get("degree"), self.get("bidegree")) {
            (Some(Value::Count(degree)), _) => surface.read_as(Reading::Total(*degree)),
            (_, Some(Value::Counts(_))) => {
                let (p, q) = self.pair("bidegree")?;
                surface.read_as(Reading::Bidegree(p, q))
            }
            _ => Ok(surface),
        }
    }
}

/// A coefficient from a polynomial in symbolic parameters.
fn number_of<C: Coefficient>(value: &Polynomial) -> Result<C, Error> {
    C::from_polynomial(value).ok_or_else(|| {
        let symbol = value.symbols().first().map_or_else(String::new, ToString::to_string);
        Error::Unsupported(format!("the weight contains the symbolic parameter `{symbol}`; the variables are those of the map"))
    })
}
