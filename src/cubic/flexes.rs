//! Humpy cubics from their flexes.

use num_traits::Zero;

use super::{Cubic, Vector, along, det, scaled};
use crate::error::Error;
use crate::exact::Rational;

impl Cubic {
    /// The humpy cubic with these flexes, at the parameters 1 and -1, and this
    /// summit, at the parameter 0: `S + ((f1 + f2)/2 - S) ρ² + (f1 - f2)(ρ³ + 3ρ)/8`.
    /// As a set of points it is the only one (CS348a, lecture 6, section 2.2).
    ///
    /// ```
    /// use casteljau::{Cubic, CubicClass, Rational};
    /// let point = |x: i64, y: i64| [Rational::from(x), Rational::from(y)];
    /// let cubic = Cubic::from_flexes(&point(1, 4), &point(1, -4), &point(0, 0))?;
    /// assert_eq!(cubic.class(), CubicClass::Humpy);
    /// assert_eq!(cubic.rational_point(&Rational::from(1)), point(1, 4));
    /// # Ok::<(), casteljau::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`Error::WrongShape`] for three points on one line.
    pub fn from_flexes(first: &Vector, second: &Vector, summit: &Vector) -> Result<Self, Error> {
        let minus_one = Rational::from(-1);
        let (to_first, to_second) = (along(first, &minus_one, summit), along(second, &minus_one, summit));
        if det(&to_first, &to_second).is_zero() {
            let [a, b, c] = [first, second, summit].map(|point| format!("({}, {})", point[0], point[1]));
            return Err(Error::WrongShape(format!(
                "the flexes {a} and {b} and the summit {c} lie on one line: a humpy cubic needs a triangle"
            )));
        }
        let middle = scaled(&Rational::new(1, 2), &along(&to_first, &Rational::from(1), &to_second));
        let across = scaled(&Rational::new(1, 8), &along(first, &minus_one, second));
        Ok(Self::from_vectors([summit.clone(), scaled(&Rational::from(3), &across), middle, across]))
    }
}
