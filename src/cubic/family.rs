//! Cubics with one symbolic parameter, and where their class changes.

use std::cmp::Ordering;

use super::{Branch, CubicClass, Invariants};
use crate::algebraic::AlgebraicNumber;
use crate::curve::Curve;
use crate::error::Error;
use crate::exact::{Rational, Surd};
use crate::symbolic::{Polynomial, Symbol};

/// A value of the parameter where the class is another than nearby.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Breakpoint {
    /// The value.
    pub value: AlgebraicNumber,
    /// The class there.
    pub class: CubicClass,
}

/// The classes of the cubics whose coefficients are polynomials in one parameter.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Family {
    /// The parameter.
    pub parameter: Symbol,
    /// The invariants, polynomials in the parameter.
    pub invariants: Invariants<Polynomial>,
    /// Where the class changes, in ascending order.
    pub breakpoints: Vec<Breakpoint>,
    /// The classes before the first breakpoint, between two of them, and behind the last.
    pub between: Vec<CubicClass>,
}

/// A polynomial in one variable, by its coefficients in ascending powers.
type Univariate = Vec<Rational>;

impl Family {
    /// The largest degree of the coefficients in the parameter.
    pub const MAX_DEGREE: u32 = 24;

    /// The classes of a family.
    ///
    /// ```
    /// use casteljau::{Family, CubicClass, Curve, Polynomial, Symbol};
    /// // (t^2, t^3 + k t) is loopy for k < 0, pointy for k = 0, humpy for k > 0.
    /// let k = Polynomial::from(Symbol::new('k', None));
    /// let (zero, one) = (Polynomial::default(), Polynomial::from(casteljau::Rational::from(1)));
    /// let curve = Curve::new(vec![vec![zero.clone(), zero.clone(), one.clone()], vec![zero.clone(), k, zero, one]])?;
    /// let family = Family::of(&curve)?;
    /// assert_eq!(family.between, [CubicClass::Loopy, CubicClass::Humpy]);
    /// assert_eq!(family.breakpoints[0].class, CubicClass::Pointy);
    /// # Ok::<(), casteljau::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`Error::Unsupported`] unless the coefficients contain exactly one
    /// symbol, and as for [`Cubic::new`](super::Cubic::new); [`Error::TooLarge`]
    /// beyond [`Family::MAX_DEGREE`], or if two values are too close to be told apart.
    pub fn of(curve: &Curve<Polynomial>) -> Result<Self, Error> {
        let coefficients = || (0..=curve.degree()).flat_map(|power| curve.vector(power));
        let mut symbols: Vec<Symbol> = coefficients().flat_map(Polynomial::symbols).collect();
        symbols.sort();
        symbols.dedup();
        let parameter = match symbols.as_slice() {
            [only] => *only,
            [] => return Err(Error::Unsupported("a family needs a symbolic parameter in its coefficients, as in (t^2, t^3 + k t)".into())),
            several => {
                let names: Vec<String> = several.iter().map(Symbol::to_string).collect();
                return Err(Error::Unsupported(format!("a family has one symbolic parameter, found {}", names.join(", "))));
            }
        };
        if coefficients().any(|coefficient| coefficient.degree_in(parameter) > Self::MAX_DEGREE) {
            return Err(Error::TooLarge { what: "degree of the coefficients in the parameter", limit: Self::MAX_DEGREE as usize });
        }
        let invariants = Invariants::of(curve)?;
        let numbers = |polynomial: &Polynomial| -> Univariate {
            polynomial.coefficients_in(parameter).iter().map(|c| c.as_rational().unwrap_or_default()).collect()
        };
        let sides = Sides {
            kappa12: numbers(&invariants.kappa12),
            kappa23: numbers(&invariants.kappa23),
            kappa31: numbers(&invariants.kappa31),
            discriminant: numbers(&invariants.discriminant()),
        };
        let (breakpoints, between) = sides.classes()?;
        Ok(Self { parameter, invariants, breakpoints, between })
    }
}

/// What decides the class, as functions of the parameter.
struct Sides {
    kappa12: Univariate,
    kappa23: Univariate,
    kappa31: Univariate,
    discriminant: Univariate,
}

fn vanishes(polynomial: &[Rational]) -> bool {
    polynomial.iter().all(num_traits::Zero::is_zero)
}

/// The sign of a polynomial at a root of a polynomial that all of its own roots
/// are roots of, or whether it vanishes there, which is all that is asked of others.
fn sign_at(polynomial: &[Rational], at: &AlgebraicNumber) -> Ordering {
    let sign = match at {
        AlgebraicNumber::Surd(surd) => surd.evaluate(polynomial.iter()).signum(),
        AlgebraicNumber::Isolated(root) if root.is_root_of(polynomial) => 0,
        AlgebraicNumber::Isolated(root) => Surd::from(root.middle()).evaluate(polynomial.iter()).signum(),
    };
    sign.cmp(&0)
}

impl Sides {
    fn class(&self, at: &AlgebraicNumber) -> CubicClass {
        let is_zero = |polynomial| sign_at(polynomial, at).is_eq();
        Branch::of(is_zero(&self.kappa23), || sign_at(&self.discriminant, at), || is_zero(&self.kappa31), || is_zero(&self.kappa12)).class()
    }

    /// The breakpoints, and the classes around them.
    fn classes(&self) -> Result<(Vec<Breakpoint>, Vec<CubicClass>), Error> {
        // The class is constant where the first of these that is not zero everywhere keeps its sign.
        let deciding: Vec<&Univariate> = if !vanishes(&self.kappa23) {
            [&self.kappa23, &self.discriminant].into_iter().filter(|side| !vanishes(side)).collect()
        } else if !vanishes(&self.kappa31) {
            vec![&self.kappa31]
        } else if !vanishes(&self.kappa12) {
            vec![&self.kappa12]
        } else {
            Vec::new()
        };
        let product = deciding.into_iter().fold(vec![Rational::from(1)], |product, side| times(&product, side));
        let roots = AlgebraicNumber::real_roots(&product)?;
        let rational = |number: Rational| AlgebraicNumber::Surd(Surd::from(number));
        let mut samples = Vec::with_capacity(roots.len() + 1);
        samples.push(roots.first().map_or_else(Rational::default, |first| first.ends().0 - Rational::from(1)));
        samples.extend(roots.windows(2).map(|pair| AlgebraicNumber::between(&pair[0], &pair[1])));
        samples.extend(roots.last().map(|last| last.ends().1 + Rational::from(1)));
        let mut between: Vec<CubicClass> = Vec::with_capacity(samples.len());
        let mut breakpoints = Vec::new();
        for (index, sample) in samples.into_iter().enumerate() {
            let class = self.class(&rational(sample));
            if let Some(value) = index.checked_sub(1).map(|before| &roots[before]) {
                let there = self.class(value);
                if there == class && between.last() == Some(&class) {
                    continue;
                }
                breakpoints.push(Breakpoint { value: value.clone(), class: there });
            }
            between.push(class);
        }
        Ok((breakpoints, between))
    }
}

fn times(a: &[Rational], b: &[Rational]) -> Univariate {
    let mut product = vec![Rational::default(); a.len() + b.len() - 1];
    for (i, x) in a.iter().enumerate() {
        for (j, y) in b.iter().enumerate() {
            product[i + j] += x * y;
        }
    }
    product
}
