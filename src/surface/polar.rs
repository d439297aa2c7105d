//! Polar forms and polar values of surfaces.

use num_bigint::BigInt;
use smallvec::SmallVec;

use super::Surface;
use crate::affine::{Parameter, PlaneParameter, Weights};
use crate::blossom::PolarForm;
use crate::error::Error;
use crate::exact::Rational;
use crate::exact::gcd::gcd_big;
use crate::kernel::coefficient::Coefficient;
use crate::kernel::layout::{Layout, multinomials};
use crate::kernel::shape::Shape;
use crate::kernel::task::SymmetricSum;
use crate::reading::Reading;

impl<C: Coefficient> Surface<C> {
    /// The polar form in the way the surface is read.
    #[must_use]
    pub fn polar(&self) -> PolarForm<C> {
        PolarForm::new(self.reading, self.dimension, &self.coefficients)
    }

    /// The polar value at `m` points or vectors of the plane, if the surface is
    /// read by its total degree `m`.
    ///
    /// # Errors
    /// [`Error::WrongCount`] for another number of arguments;
    /// [`Error::WrongShape`] if it is read by its bidegree.
    pub fn blossom(&self, arguments: &[PlaneParameter<C>]) -> Result<Vec<C>, Error> {
        let Reading::Total(degree) = self.reading else {
            return Err(Error::WrongShape("this surface is read by its bidegree: its polar form takes two groups of numbers".into()));
        };
        if arguments.len() != degree {
            return Err(Error::WrongCount { what: "polar arguments", expected: degree, found: arguments.len() });
        }
        let weights = arguments.iter().map(|PlaneParameter { u, v, w }| Weights::of(&[w.clone(), u.clone(), v.clone()]));
        Ok(self.polar_value(weights))
    }

    /// The polar value at `p` arguments for the first and `q` for the second
    /// variable, if the surface is read by its bidegree `(p, q)`.
    ///
    /// # Errors
    /// [`Error::WrongCount`] for another number of arguments;
    /// [`Error::WrongShape`] if it is read by its total degree.
    pub fn blossom_bidegree(&self, us: &[Parameter<C>], vs: &[Parameter<C>]) -> Result<Vec<C>, Error> {
        let Reading::Bidegree(p, q) = self.reading else {
            return Err(Error::WrongShape("this surface is read by its total degree: its polar form takes points of the plane".into()));
        };
        for (what, expected, found) in
            [("polar arguments of the first variable", p, us.len()), ("polar arguments of the second variable", q, vs.len())]
        {
            if expected != found {
                return Err(Error::WrongCount { what, expected, found });
            }
        }
        Ok(self.polar_value(us.iter().chain(vs).map(|Parameter { t, w }| Weights::of_pair(w, t))))
    }

    fn polar_value(&self, arguments: impl Iterator<Item = Weights<C>>) -> Vec<C> {
        let mut divisors: SmallVec<[C; 4]> = SmallVec::new();
        let mut parameters = Vec::new();
        for argument in arguments {
            parameters.extend(argument.weights);
            divisors.push(argument.scale);
        }
        for factor in self.reading.factors() {
            let shape = Shape { factors: SmallVec::from_slice(&[factor]), stride: 1 };
            let common = common_multiple(&multinomials::<BigInt>(&shape));
            parameters.extend(multinomials::<BigInt>(&shape).into_iter().map(|n| C::from(Rational::from(&common / n))));
            divisors.push(C::from(Rational::from(common)));
        }
        let layout = Layout { divisors, ..self.point_layout() };
        C::compute(&SymmetricSum { shape: self.shape() }, &self.coefficients, &parameters, &[layout])
    }
}

/// The least common multiple of some positive numbers.
fn common_multiple(numbers: &[BigInt]) -> BigInt {
    numbers.iter().fold(BigInt::from(1), |common, number| {
        let shared = BigInt::from(gcd_big(common.magnitude(), number.magnitude()));
        common / shared * number
    })
}
