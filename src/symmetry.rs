//! Symmetries of rectangular nets.

use crate::affine::Rectangle;
use crate::kernel::coefficient::Coefficient;
use crate::name::display_by_name;
use crate::rectangular::RectangularPatch;

/// A rearrangement of a rectangular net: a symmetry of the rectangle.
///
/// All but the identity: two reversals, the half turn, and the four that
/// exchange the parameters and so turn the bidegree `(p, q)` into `(q, p)`.
/// The image has the same trace as the patch; what changes is how it is
/// parametrized (MA323, day 25, section 5, where the transposition is said to
/// exist for `p = q` only).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Symmetry {
    /// `(u, v) ↦ (u', v)`, where `u'` runs backwards.
    ReverseU,
    /// `(u, v) ↦ (u, v')`.
    ReverseV,
    /// `(u, v) ↦ (u', v')`.
    HalfTurn,
    /// `(u, v) ↦ (v, u)`.
    Transpose,
    /// `(u, v) ↦ (v', u)`: a quarter turn.
    QuarterTurn,
    /// `(u, v) ↦ (v, u')`: the other quarter turn.
    QuarterTurnBack,
    /// `(u, v) ↦ (v', u')`.
    AntiTranspose,
}

impl Symmetry {
    /// All of them.
    pub const ALL: [Self; 7] =
        [Self::ReverseU, Self::ReverseV, Self::HalfTurn, Self::Transpose, Self::QuarterTurn, Self::QuarterTurnBack, Self::AntiTranspose];

    /// Its name in answers.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::ReverseU => "reverse-u",
            Self::ReverseV => "reverse-v",
            Self::HalfTurn => "half-turn",
            Self::Transpose => "transpose",
            Self::QuarterTurn => "quarter-turn",
            Self::QuarterTurnBack => "quarter-turn-back",
            Self::AntiTranspose => "anti-transpose",
        }
    }

    /// Whether the parameters change places, and which of the old ones run backwards.
    fn parts(self) -> (bool, bool, bool) {
        match self {
            Self::ReverseU => (false, true, false),
            Self::ReverseV => (false, false, true),
            Self::HalfTurn => (false, true, true),
            Self::Transpose => (true, false, false),
            Self::QuarterTurn => (true, true, false),
            Self::QuarterTurnBack => (true, false, true),
            Self::AntiTranspose => (true, true, true),
        }
    }

    /// How the image is parametrized over the unit square: what stands for
    /// `X` at `(u, v)`.
    #[must_use]
    pub fn relation(self) -> &'static str {
        match self {
            Self::ReverseU => "X(1-u, v)",
            Self::ReverseV => "X(u, 1-v)",
            Self::HalfTurn => "X(1-u, 1-v)",
            Self::Transpose => "X(v, u)",
            Self::QuarterTurn => "X(1-v, u)",
            Self::QuarterTurnBack => "X(v, 1-u)",
            Self::AntiTranspose => "X(1-v, 1-u)",
        }
    }
}

display_by_name!(Symmetry);

impl<C: Coefficient> RectangularPatch<C> {
    /// The net rearranged, over the frame that goes with it: the same surface
    /// with its parameters exchanged or its frames reversed.
    ///
    /// ```
    /// use casteljau::{Rational, Rectangle, RectangularPatch, Symmetry};
    /// let rows = vec![[1, 2, 3].map(|z| vec![Rational::from(z)]).to_vec(), [4, 5, 6].map(|z| vec![Rational::from(z)]).to_vec()];
    /// let patch = RectangularPatch::from_rows(rows, Rectangle::unit())?;
    /// let turned = patch.under(Symmetry::QuarterTurn);
    /// assert_eq!(turned.degree(), (2, 1));
    /// assert_eq!(turned.point(0, 0), patch.point(1, 0));
    /// # Ok::<(), casteljau::Error>(())
    /// ```
    #[must_use]
    pub fn under(&self, symmetry: Symmetry) -> Self {
        let (exchanged, reverse_u, reverse_v) = symmetry.parts();
        let (p, q) = self.degree();
        let degree = if exchanged { (q, p) } else { (p, q) };
        let net = self.rearranged(degree, |i, j| {
            let (i, j) = if exchanged { (j, i) } else { (i, j) };
            (if reverse_u { p - i } else { i }, if reverse_v { q - j } else { j })
        });
        let u = if reverse_u { self.frame().u().reversed() } else { self.frame().u().clone() };
        let v = if reverse_v { self.frame().v().reversed() } else { self.frame().v().clone() };
        let frame = if exchanged { Rectangle::new(v, u) } else { Rectangle::new(u, v) };
        Self::from_net(net, frame)
    }

    /// The same rearranged net over the present frames, of which each symmetry
    /// of the net is an equality: whether the rearrangement leaves it as it is.
    #[must_use]
    pub fn is_invariant(&self, symmetry: Symmetry) -> bool {
        let image = self.under(symmetry);
        image.degree() == self.degree() && image.points().eq(self.points())
    }
}
