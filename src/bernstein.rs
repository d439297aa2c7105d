//! Bernstein polynomials.

use crate::affine::{Frame, Interval, Rectangle, Triangle};
use crate::control::ControlNet;
use crate::error::Error;
use crate::exact::Rational;
use crate::exact::width::powers;
use crate::kernel::layout::multinomials;
use crate::piece::{Equation, Piece};
use crate::reading::Reading;
use crate::rectangular::RectangularPatch;
use crate::segment::Segment;
use crate::triangular::TriangularPatch;

/// The Bernstein polynomials of a degree over a frame, the coordinates of a
/// point of a curve or patch in its control points: `B_k(t)` on an interval,
/// `B_ijk(u, v)` on a triangle, the products `B_i(u) B_j(v)` on a rectangle
/// (Gallier, *Curves and Surfaces in Geometric Modeling*, sections 18.1, 19.2
/// and 19.3; CS348a, lecture 6, section 3.1).
///
/// ```
/// use casteljau::{Bernstein, Interval, Rational, Triangle};
/// let basis = Bernstein::new(3, Interval::unit());
/// assert_eq!(basis.values(&[Rational::new(1, 2)])?, [1, 3, 3, 1].map(|n| Rational::new(n, 8)));
/// assert_eq!(basis.maximum(1), Some((vec![Rational::new(1, 3)], Rational::new(4, 9))));
/// let basis = Bernstein::triangle(2, Triangle::standard());
/// assert_eq!(basis.indices()[4], [1, 1, 0]);
/// assert_eq!(basis.maximum(4), Some((vec![Rational::new(1, 2), Rational::new(1, 2)], Rational::new(1, 2))));
/// # Ok::<(), casteljau::Error>(())
/// ```
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Bernstein {
    reading: Reading,
    frame: Frame<Rational>,
}

impl Bernstein {
    /// The polynomials of degree `degree` over an interval.
    #[must_use]
    pub fn new(degree: usize, frame: Interval) -> Self {
        Self { reading: Reading::Curve(degree), frame: frame.into() }
    }

    /// The polynomials of total degree `degree` over a triangle.
    #[must_use]
    pub fn triangle(degree: usize, frame: Triangle) -> Self {
        Self { reading: Reading::Total(degree), frame: frame.into() }
    }

    /// The products of bidegree `(p, q)` over a rectangle.
    #[must_use]
    pub fn rectangle((p, q): (usize, usize), frame: Rectangle) -> Self {
        Self { reading: Reading::Bidegree(p, q), frame: frame.into() }
    }

    /// The degrees.
    #[must_use]
    pub fn reading(&self) -> Reading {
        self.reading
    }

    /// The frame.
    #[must_use]
    pub fn frame(&self) -> &Frame<Rational> {
        &self.frame
    }

    /// The indices of the polynomials in order: `[k]`, `[i, j, k]` or `[i, j]`.
    #[must_use]
    pub fn indices(&self) -> Vec<Vec<usize>> {
        let index = |exponents: Vec<usize>| match self.reading {
            Reading::Curve(_) => vec![exponents[1]],
            // The kernel's vertices are t, r, s.
            Reading::Total(_) => vec![exponents[1], exponents[2], exponents[0]],
            Reading::Bidegree(..) => vec![exponents[1], exponents[3]],
        };
        self.reading.exponents().into_iter().map(index).collect()
    }

    fn check(&self, position: usize) -> Result<(), Error> {
        let count = self.reading.points();
        if position < count {
            return Ok(());
        }
        Err(Error::WrongShape(format!("there is no Bernstein polynomial {position}; the last of these is {}", count - 1)))
    }

    /// The polynomial at a place of the order as a function: its control points
    /// are 1 there and 0 elsewhere.
    ///
    /// # Errors
    /// [`Error::WrongShape`] if there are not so many.
    pub fn piece(&self, position: usize) -> Result<Piece, Error> {
        self.check(position)?;
        let shape = self.reading.shape(1);
        let coordinates = (0..shape.points()).map(|place| Rational::from(i64::from(place == position))).collect();
        let net = ControlNet { shape, coordinates };
        Ok(match self.frame.clone() {
            Frame::Interval(frame) => Piece::Curve(Segment::from_net(net, frame)),
            Frame::Triangle(frame) => Piece::Triangle(TriangularPatch::from_net(net, frame)),
            Frame::Rectangle(frame) => Piece::Rectangle(RectangularPatch::from_net(net, frame)),
        })
    }

    /// The polynomial at a place of the order.
    ///
    /// # Errors
    /// [`Error::WrongShape`] if there are not so many.
    pub fn polynomial(&self, position: usize) -> Result<Equation, Error> {
        self.piece(position)?.equation()
    }

    /// The values of all polynomials in order, at one parameter on an interval,
    /// at two on a triangle or rectangle.
    ///
    /// # Errors
    /// [`Error::WrongCount`] for another number of parameters.
    pub fn values(&self, at: &[Rational]) -> Result<Vec<Rational>, Error> {
        let on = |frame: &Interval, t: &Rational| {
            let length = frame.s() - frame.r();
            vec![(frame.s() - t) / &length, (t - frame.r()) / &length]
        };
        // The coordinates of the parameter in every simplex, in the kernel's order.
        let coordinates = match (&self.frame, at) {
            (Frame::Interval(frame), [t]) => vec![on(frame, t)],
            (Frame::Triangle(frame), [u, v]) => {
                let [lambda, mu, nu] = frame.barycentric(&[u.clone(), v.clone()])?;
                vec![vec![nu, lambda, mu]]
            }
            (Frame::Rectangle(frame), [u, v]) => vec![on(frame.u(), u), on(frame.v(), v)],
            (frame, _) => {
                let expected = if matches!(frame, Frame::Interval(_)) { 1 } else { 2 };
                return Err(Error::WrongCount { what: "parameters", expected, found: at.len() });
            }
        };
        let degrees = self.reading.groups().into_iter().map(|(degree, _)| degree);
        let tables: Vec<_> =
            coordinates.iter().zip(degrees).flat_map(|(list, degree)| list.iter().map(move |x| powers(x, degree))).collect();
        let counts = multinomials::<Rational>(&self.reading.shape(1));
        let product = |(exponents, count): (Vec<usize>, Rational)| {
            tables.iter().zip(&exponents).fold(count, |product, (table, &exponent)| product * &table[exponent])
        };
        Ok(self.reading.exponents().into_iter().zip(counts).map(product).collect())
    }

    /// Where a polynomial is largest on the frame, and how large: at
    /// `r + (k/m)(s - r)`, at `(i r + j s + k t)/m`, or at both quotients on a
    /// rectangle (MA323, day 25, section 5). None for constants and where there
    /// is no such polynomial. A parameter that it does not depend on stands at
    /// the start of its frame.
    #[must_use]
    pub fn maximum(&self, position: usize) -> Option<(Vec<Rational>, Rational)> {
        let index = self.indices().into_iter().nth(position)?;
        let part = |k: usize, m: usize| Rational::new(k as i64, m.max(1) as i64);
        let place = match (&self.frame, self.reading) {
            (_, Reading::Curve(0) | Reading::Total(0) | Reading::Bidegree(0, 0)) => return None,
            (Frame::Interval(frame), Reading::Curve(m)) => vec![frame.at(&part(index[0], m))],
            (Frame::Triangle(frame), Reading::Total(m)) => frame.at(&[0, 1, 2].map(|vertex| part(index[vertex], m))).to_vec(),
            (Frame::Rectangle(frame), Reading::Bidegree(p, q)) => {
                vec![frame.u().at(&part(index[0], p)), frame.v().at(&part(index[1], q))]
            }
            // A basis is made with a frame of its own kind.
            _ => return None,
        };
        let value = self.values(&place).ok()?.swap_remove(position);
        Some((place, value))
    }
}
