//! Polar forms and polar values of surfaces.

use num_bigint::BigInt;

use super::Surface;
use crate::affine::{Parameter, PlaneParameter, Weights};
use crate::blossom::PolarForm;
use crate::error::Error;
use crate::exact::Rational;
use crate::exact::gcd::gcd_big;
use crate::kernel::coefficient::Coefficient;
use crate::kernel::layout::multinomials;
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
        Ok(self.polar_value(PlaneParameter::weights(arguments)))
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
        let mut arguments = Weights::default();
        us.iter().chain(vs).for_each(|Parameter { t, w }| arguments.push_pair(w, t));
        Ok(self.polar_value(arguments))
    }

    fn polar_value(&self, arguments: Weights<C>) -> Vec<C> {
        let Weights { rows: mut parameters, scales: mut divisors } = arguments;
        for &factor in self.reading.factors().iter() {
            let shape = Shape { factors: factor.into(), stride: 1 };
            let common = common_multiple(&multinomials::<BigInt>(&shape));
            multinomials::<BigInt>(&shape).into_iter().for_each(|n| parameters.push(C::from(Rational::from(&common / n))));
            divisors.push(C::from(Rational::from(common)));
        }
        let task = SymmetricSum { shape: self.shape() };
        C::compute(&task, &self.coefficients, parameters.as_slice(), &[self.point_layout(&divisors)])
    }
}

/// The least common multiple of some positive numbers.
fn common_multiple(numbers: &[BigInt]) -> BigInt {
    numbers.iter().fold(BigInt::from(1), |common, number| {
        let shared = BigInt::from(gcd_big(common.magnitude(), number.magnitude()));
        common / shared * number
    })
}
