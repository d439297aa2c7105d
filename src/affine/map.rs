//! Affine maps of space.

use nalgebra::{DMatrix, DVector};

use crate::error::Error;
use crate::exact::Rational;
use crate::kernel::coefficient::Coefficient;

/// An affine map `x ↦ A x + b` from `columns` to `rows` dimensions.
///
/// Control points of an image are the images of the control points (Gallier,
/// *Curves and Surfaces in Geometric Modeling*, section 18.2).
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct AffineMap<C = Rational> {
    rows: Vec<Vec<C>>,
    shift: Vec<C>,
}

impl<C: Coefficient> AffineMap<C> {
    /// The map with these rows of `A` and this `b`.
    ///
    /// # Errors
    /// [`Error::WrongShape`] if there is no row, if the rows differ in length,
    /// or if `b` does not have an entry for every row.
    pub fn new(rows: Vec<Vec<C>>, shift: Vec<C>) -> Result<Self, Error> {
        let columns = rows.first().map_or(0, Vec::len);
        if columns == 0 || rows.iter().any(|row| row.len() != columns) || rows.len() != shift.len() {
            return Err(Error::WrongShape(format!(
                "an affine map needs rows of equal length and one entry of the shift a row; found rows of lengths {:?} and {} entries",
                rows.iter().map(Vec::len).collect::<Vec<_>>(),
                shift.len()
            )));
        }
        Ok(Self { rows, shift })
    }

    /// The same map with its numbers brought into another ring.
    pub(crate) fn map<D: Coefficient, E>(&self, number: &mut impl FnMut(&C) -> Result<D, E>) -> Result<AffineMap<D>, E> {
        let mut list = |values: &[C]| values.iter().map(&mut *number).collect::<Result<Vec<D>, E>>();
        Ok(AffineMap { rows: self.rows.iter().map(|row| list(row)).collect::<Result<_, E>>()?, shift: list(&self.shift)? })
    }

    /// All its numbers: the rows, then the shift.
    pub fn numbers(&self) -> impl Iterator<Item = &C> {
        self.rows.iter().flatten().chain(&self.shift)
    }

    /// The number of coordinates of the points it takes.
    #[must_use]
    pub fn source_dimension(&self) -> usize {
        self.rows.first().map_or(0, Vec::len)
    }

    /// The number of coordinates of the points it gives.
    #[must_use]
    pub fn target_dimension(&self) -> usize {
        self.rows.len()
    }

    /// The image of a point.
    ///
    /// # Errors
    /// [`Error::WrongCount`] if the point has another dimension.
    pub fn apply(&self, point: &[C]) -> Result<Vec<C>, Error> {
        self.combine(point, |_, shift| shift.clone())
    }

    /// The image of a vector: the shift does not move it.
    ///
    /// # Errors
    /// [`Error::WrongCount`] if the vector has another dimension.
    pub fn apply_to_vector(&self, vector: &[C]) -> Result<Vec<C>, Error> {
        self.combine(vector, |_, _| C::nothing())
    }

    /// The same map on homogeneous points `(w x, w)`: linear, and leaving the weight as it is.
    #[must_use]
    pub fn homogeneous(&self) -> Self {
        let mut rows: Vec<Vec<C>> =
            self.rows.iter().zip(&self.shift).map(|(row, shift)| row.iter().chain([shift]).cloned().collect()).collect();
        let mut weight = vec![C::nothing(); self.source_dimension()];
        weight.push(C::unit());
        rows.push(weight);
        let shift = vec![C::nothing(); rows.len()];
        Self { rows, shift }
    }

    fn combine(&self, point: &[C], start: impl Fn(usize, &C) -> C) -> Result<Vec<C>, Error> {
        if point.len() != self.source_dimension() {
            return Err(Error::WrongCount { what: "coordinates", expected: self.source_dimension(), found: point.len() });
        }
        Ok(self
            .rows
            .iter()
            .zip(&self.shift)
            .enumerate()
            .map(|(index, (row, shift))| {
                row.iter().zip(point).fold(start(index, shift), |mut sum, (entry, coordinate)| {
                    sum.add_product(entry, coordinate);
                    sum
                })
            })
            .collect())
    }
}

/// The map `x ↦ A x + b` of `nalgebra`'s matrix and vector.
impl TryFrom<(DMatrix<Rational>, DVector<Rational>)> for AffineMap {
    type Error = Error;

    fn try_from((matrix, shift): (DMatrix<Rational>, DVector<Rational>)) -> Result<Self, Error> {
        let rows = matrix.row_iter().map(|row| row.iter().cloned().collect()).collect();
        Self::new(rows, shift.iter().cloned().collect())
    }
}
