//! Tolerances that the user states, as exact bounds.

use std::fmt;
use std::str::FromStr;

use num_bigint::BigUint;
use num_traits::{Signed, Zero};

use super::angle::rounded;
use crate::exact::Rational;

/// What a join may be off by.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Tolerance {
    /// The largest squared sine of the angle, with the degrees that were stated.
    angle: Option<(Rational, Rational)>,
    /// The largest move of a control point, in units of the data.
    unit: Option<Rational>,
    /// Whether half a unit of the last printed digit is accepted.
    rounding: bool,
}

impl Tolerance {
    /// The largest squared sine of the angle.
    #[must_use]
    pub fn sin2(&self) -> Option<&Rational> {
        self.angle.as_ref().map(|(_, sin2)| sin2)
    }

    /// The largest move of a control point.
    #[must_use]
    pub fn unit(&self) -> Option<&Rational> {
        self.unit.as_ref()
    }

    /// Whether half a unit of the last printed digit is accepted.
    #[must_use]
    pub fn accepts_rounding(&self) -> bool {
        self.rounding
    }

    /// Both tolerances together.
    ///
    /// # Errors
    /// If both state the same kind.
    pub fn and(mut self, other: Self) -> Result<Self, String> {
        if (self.angle.is_some() && other.angle.is_some())
            || (self.unit.is_some() && other.unit.is_some())
            || (self.rounding && other.rounding)
        {
            return Err("a tolerance of one kind is given twice".into());
        }
        self.angle = self.angle.or(other.angle);
        self.unit = self.unit.or(other.unit);
        self.rounding |= other.rounding;
        Ok(self)
    }
}

impl FromStr for Tolerance {
    type Err = String;

    /// Reads `0.01deg`, `0.5unit`, `rounding`, or several with commas between.
    fn from_str(text: &str) -> Result<Self, String> {
        let mut whole = Self::default();
        for part in text.split(',').map(str::trim) {
            let wrong = || format!("found `{part}`, expected a number with its unit, such as 0.01deg or 0.5unit, or `rounding`");
            let number = |text: &str| text.trim().parse::<Rational>().map_err(|_| wrong());
            let one = if part == "rounding" {
                Self { rounding: true, ..Self::default() }
            } else if let Some(text) = part.strip_suffix("deg") {
                let degrees = number(text)?;
                if !degrees.is_positive() || degrees >= Rational::from(90) {
                    return Err(format!("found `{part}`: an angle is above 0 and below 90 degrees"));
                }
                if degrees.bits() > 256 {
                    return Err(format!("found `{part}`: an angle has at most 256 bits"));
                }
                let sin2 = squared_sine_below(&degrees);
                Self { angle: Some((degrees, sin2)), ..Self::default() }
            } else if let Some(text) = part.strip_suffix("units").or_else(|| part.strip_suffix("unit")) {
                let unit = number(text)?;
                if !unit.is_positive() {
                    return Err(format!("found `{part}`: a distance is above 0"));
                }
                Self { unit: Some(unit), ..Self::default() }
            } else {
                return Err(wrong());
            };
            whole = whole.and(one)?;
        }
        Ok(whole)
    }
}

impl fmt::Display for Tolerance {
    /// What was stated, with the exact bound that an angle stands for.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let mut parts = Vec::new();
        if let Some((degrees, sin2)) = &self.angle {
            parts.push(format!("{degrees} deg (sin² <= {sin2})"));
        }
        if let Some(unit) = &self.unit {
            parts.push(format!("{unit} unit"));
        }
        if self.rounding {
            parts.push("rounding".into());
        }
        f.write_str(&parts.join(", "))
    }
}

/// A number a little below the squared sine of an angle between 0 and 90
/// degrees: Taylor's series, cut where what is left out is positive, at a value
/// below π.
fn squared_sine_below(degrees: &Rational) -> Rational {
    let pi = Rational::new(314_159_265_358_979_323, 100_000_000_000_000_000);
    let x = degrees * &pi / Rational::from(180);
    let square = x.pow(2);
    // x - x³/3! + x⁵/5! - …: the terms shrink from the first on, since x² < 6.
    let (mut term, mut sum) = (x, Rational::from(0));
    for k in 0..12i64 {
        sum += &term;
        term = -(term * &square) / Rational::from((2 * k + 2) * (2 * k + 3));
    }
    debug_assert!(term.is_positive(), "the last term taken was negative");
    let squared = sum.pow(2);
    let (numer, denom) = (squared.numer(), squared.denom());
    if numer.is_zero() {
        return Rational::from(0);
    }
    rounded(BigUint::clone(numer.magnitude()), denom.magnitude(), false)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn angles_become_bounds_on_the_strict_side() {
        for (degrees, sin2) in [
            (Rational::from(30), Rational::new(1, 4)),
            (Rational::from(45), Rational::new(1, 2)),
            (Rational::from(60), Rational::new(3, 4)),
        ] {
            let bound = squared_sine_below(&degrees);
            assert!(bound < sin2 && &sin2 - &bound < Rational::new(1, 100_000), "{degrees}: {bound}");
        }
        // sin² 0.01° = 3.0461741880…e-8
        let bound = squared_sine_below(&Rational::new(1, 100));
        assert!(bound < Rational::new(304_617_419, 10_000_000_000_000_000) && bound > Rational::new(304_616, 10_000_000_000_000));
        let whole: Tolerance = "89.999deg".parse().expect("a tolerance");
        assert!(whole.sin2().is_some_and(|sin2| *sin2 < Rational::from(1)));
    }

    #[test]
    fn what_is_stated() {
        let both: Tolerance = "0.5deg, 1/2unit".parse().expect("a tolerance");
        assert!(both.sin2().is_some() && both.unit() == Some(&Rational::new(1, 2)) && !both.accepts_rounding());
        assert!("rounding".parse::<Tolerance>().is_ok_and(|rounding| rounding.accepts_rounding()));
        for wrong in ["", "0.5", "0deg", "90deg", "-1unit", "0unit", "1deg,2deg", "deg", "abcunit", "rounding,rounding"] {
            assert!(wrong.parse::<Tolerance>().is_err(), "{wrong}");
        }
    }
}
