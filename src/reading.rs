//! The ways in which a polynomial is polarized.

use crate::control::count;
use crate::error::Error;
use crate::kernel::shape::{Factors, Shape};
use crate::symbolic::{Monomial, Symbol};

/// How a polynomial map is read: which polar form it has, and with how many arguments.
///
/// A curve has one polar form for each polar degree. A polynomial in two
/// variables can be read in two ways (Gallier, *Curves and Surfaces in
/// Geometric Modeling*, section 19.1): by its total degree, which makes
/// triangular patches, or variable by variable, which makes rectangular ones.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Reading {
    /// A curve: `m` arguments on the line.
    Curve(usize),
    /// A surface by its total degree: `m` arguments in the plane.
    Total(usize),
    /// A surface by its bidegree: `p` arguments for the first variable and `q` for the second.
    Bidegree(usize, usize),
}

/// A product of arguments of a polar form: which coordinate of which argument.
/// Coordinate 0 is the weight of a homogeneous argument.
pub type PolarTerm = Vec<(usize, usize, usize)>;

/// The most coefficients that an equation may have, zeros included.
pub(crate) const MAX_COEFFICIENTS: usize = 1 << 22;

impl Reading {
    /// Whether a map of so many coordinates, read in this way, has no more
    /// coefficients than an equation may have.
    ///
    /// # Errors
    /// [`Error::TooLarge`] above [`MAX_COEFFICIENTS`].
    pub(crate) fn check_size(self, dimension: usize) -> Result<(), Error> {
        if count(&self.shape(dimension)) > MAX_COEFFICIENTS {
            let what = match self {
                Self::Curve(_) => "curve, counted in coefficients,",
                Self::Total(_) | Self::Bidegree(..) => "surface, counted in coefficients,",
            };
            return Err(Error::TooLarge { what, limit: MAX_COEFFICIENTS });
        }
        Ok(())
    }

    pub(crate) fn shape(self, stride: usize) -> Shape {
        match self {
            Self::Curve(degree) => Shape::curve(degree, stride),
            Self::Total(degree) => Shape::triangle(degree, stride),
            Self::Bidegree(p, q) => Shape::rectangle(p, q, stride),
        }
    }

    /// The number of control points.
    #[must_use]
    pub fn points(self) -> usize {
        self.shape(1).points()
    }

    /// The groups of arguments: how many each has, and of how many coordinates they are.
    #[must_use]
    pub fn groups(self) -> Vec<(usize, usize)> {
        self.shape(1).factors.iter().map(|factor| (factor.degree, factor.dimension)).collect()
    }

    /// The letter of a coordinate of the arguments of a group; coordinate 0 is the weight.
    ///
    /// # Panics
    /// If there is no such group or coordinate.
    #[must_use]
    pub fn letter(self, group: usize, coordinate: usize) -> char {
        match self {
            Self::Curve(_) => ['w', 't'][coordinate],
            Self::Total(_) => ['C', 'U', 'V'][coordinate],
            Self::Bidegree(..) => [['a', 'u'], ['b', 'v']][group][coordinate],
        }
    }

    /// The symbol of a coordinate of an argument, counted from 1: `t2`, `U1`, `v3`.
    ///
    /// # Panics
    /// If there is no such group or coordinate.
    #[must_use]
    pub fn symbol(self, group: usize, argument: usize, coordinate: usize) -> Symbol {
        Symbol::new(self.letter(group, coordinate), Some(argument as u32))
    }

    /// All symbols of the arguments, weights left out.
    pub fn symbols(self) -> impl Iterator<Item = Symbol> {
        self.groups().into_iter().enumerate().flat_map(move |(group, (count, dimension))| {
            (1..=count).flat_map(move |argument| (1..=dimension).map(move |coordinate| self.symbol(group, argument, coordinate)))
        })
    }

    /// The name of an argument, such as `t2`, `(U1,V1)` or `v3`.
    #[must_use]
    pub fn argument(self, group: usize, argument: usize) -> String {
        match self {
            Self::Total(_) => format!("({},{})", self.symbol(group, argument, 1), self.symbol(group, argument, 2)),
            _ => self.symbol(group, argument, 1).to_string(),
        }
    }

    /// The products of coordinates that share one coefficient of the polar
    /// form: in each group, so many arguments give each coordinate as
    /// `exponents` says (the weight first). Which arguments give the first
    /// coordinate varies slowest, in lexicographic order.
    pub(crate) fn terms(self, exponents: &[usize]) -> Vec<PolarTerm> {
        let mut products: Vec<PolarTerm> = vec![Vec::new()];
        let mut rest = exponents;
        for (group, (count, dimension)) in self.groups().into_iter().enumerate() {
            let (own, others) = rest.split_at(dimension + 1);
            rest = others;
            let assignments = assignments(count, own);
            products = products
                .iter()
                .flat_map(|product| {
                    assignments.iter().map(move |coordinates| {
                        let chosen = coordinates.iter().enumerate().map(|(argument, &coordinate)| (group, argument + 1, coordinate));
                        product.iter().copied().chain(chosen).collect()
                    })
                })
                .collect();
        }
        products
    }

    /// The product that a term stands for where all weights are 1.
    pub(crate) fn monomial(self, term: &PolarTerm) -> Monomial {
        let factors = term.iter().filter(|&&(_, _, coordinate)| coordinate > 0);
        Monomial::from_factors(factors.map(|&(group, argument, coordinate)| (self.symbol(group, argument, coordinate), 1)))
    }

    /// The exponents of every coefficient, at all vertices of all groups, in order.
    pub(crate) fn exponents(self) -> Vec<Vec<usize>> {
        let mut all = Vec::new();
        self.shape(1).for_each(|exponents| all.push(exponents.to_vec()));
        all
    }

    /// Whether the one map is known to have every polynomial that the other has.
    pub(crate) fn factors(self) -> Factors {
        self.shape(1).factors
    }
}

/// The coordinate that each of `count` arguments gives, if `exponents` says how
/// often each coordinate occurs.
fn assignments(count: usize, exponents: &[usize]) -> Vec<Vec<usize>> {
    let mut partial = vec![vec![0; count]];
    for (coordinate, &times) in exponents.iter().enumerate().skip(1) {
        partial = partial
            .into_iter()
            .flat_map(|assigned| {
                let free: Vec<usize> = (0..count).filter(|&argument| assigned[argument] == 0).collect();
                choices(free.len(), times)
                    .into_iter()
                    .map(|chosen| {
                        let mut assigned = assigned.clone();
                        chosen.into_iter().for_each(|place| assigned[free[place]] = coordinate);
                        assigned
                    })
                    .collect::<Vec<_>>()
            })
            .collect();
    }
    partial
}

/// The ways to choose `k` of the numbers from 0 to `n - 1`, in lexicographic order.
fn choices(n: usize, k: usize) -> Vec<Vec<usize>> {
    let mut all = Vec::new();
    let mut chosen: Vec<usize> = (0..k).collect();
    loop {
        all.push(chosen.clone());
        // The next choice: raise the last one that has room, and pack the rest behind it.
        let Some(position) = (0..k).rev().find(|&position| chosen[position] < n - (k - position)) else {
            return all;
        };
        let next = chosen[position] + 1;
        for (offset, place) in chosen[position..].iter_mut().enumerate() {
            *place = next + offset;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn shown(reading: Reading, exponents: &[usize]) -> Vec<String> {
        let name =
            |term: &PolarTerm| term.iter().map(|&(group, argument, c)| reading.symbol(group, argument, c).to_string()).collect::<String>();
        reading.terms(exponents).iter().map(name).collect()
    }

    #[test]
    fn terms_in_the_order_of_the_textbook() {
        assert_eq!(shown(Reading::Curve(3), &[1, 2]), ["t1t2w3", "t1w2t3", "w1t2t3"]);
        assert_eq!(shown(Reading::Total(3), &[0, 1, 2]), ["U1V2V3", "V1U2V3", "V1V2U3"]);
        assert_eq!(shown(Reading::Total(2), &[1, 1, 0]), ["U1C2", "C1U2"]);
        assert_eq!(shown(Reading::Bidegree(2, 1), &[1, 1, 0, 1]), ["u1a2v1", "a1u2v1"]);
        assert_eq!(shown(Reading::Curve(0), &[0, 0]), [""]);
        assert_eq!(Reading::Total(6).terms(&[1, 2, 3]).len(), 60);
    }
}
