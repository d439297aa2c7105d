//! The forms of de Casteljau's algorithm on rectangles, with all their steps.

use crate::affine::Weights;
use crate::control::ControlNet;
use crate::error::Error;
use crate::exact::Rational;
use crate::kernel::coefficient::Coefficient;
use crate::kernel::integers::Integers;
use crate::kernel::layout::Layout;
use crate::kernel::shape::Shape;
use crate::kernel::task;
use crate::rectangular::{Axis, RectangularPatch, bidegree_label};
use crate::scheme::remaining;

/// The steps in one parameter on all lines of the net, then those in the other
/// on the one line that is left: the two-step view (MA323, day 25, section 3).
///
/// ```
/// use casteljau::{Axis, Rational, Rectangle, RectangularPatch};
/// let rows = [[0, 4], [8, 0]].map(|row| row.map(|z| vec![Rational::from(z)]).to_vec()).to_vec();
/// let patch = RectangularPatch::from_rows(rows, Rectangle::unit())?;
/// let half = Rational::new(1, 2);
/// let steps = patch.two_steps(&[half.clone(), half.clone()], Axis::U)?;
/// assert_eq!(steps.nets()[1].point(0, 1), [Rational::from(2)]);
/// assert_eq!(steps.label(1, 0, 1), "f(u;s2)");
/// assert_eq!(steps.point(), [Rational::from(3)]);
/// # Ok::<(), casteljau::Error>(())
/// ```
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct TwoSteps<C = Rational> {
    first: Axis,
    parameters: (C, C),
    nets: Vec<RectangularPatch<C>>,
    /// The points of the second stage, layer by layer.
    layers: Vec<Vec<Vec<C>>>,
}

impl<C: Coefficient> TwoSteps<C> {
    pub(crate) fn of(patch: &RectangularPatch<C>, [u, v]: &[C; 2], first: Axis) -> Result<Self, Error> {
        let (p, q) = patch.degree();
        let (along, across) = if first == Axis::U { (u, v) } else { (v, u) };
        let (own, other) = if first == Axis::U { (p, q) } else { (q, p) };
        // The scheme in the first parameter: a triangle of entries, whose layers are the nets.
        let scheme = patch.net().scheme(first.factor(), &patch.argument(first, along)?);
        let net_of = |layer: usize| {
            let (p, q) = if first == Axis::U { (p - layer, q) } else { (p, q - layer) };
            let mut coordinates = Vec::new();
            for i in 0..=p {
                for j in 0..=q {
                    let place = match first {
                        Axis::U => scheme.shape.index(&[p - i, layer, i, q - j, j]),
                        Axis::V => scheme.shape.index(&[p - i, i, q - j, layer, j]),
                    };
                    coordinates.extend_from_slice(scheme.point(place));
                }
            }
            RectangularPatch::from_net(ControlNet { shape: Shape::rectangle(p, q, patch.dimension()), coordinates }, patch.frame().clone())
        };
        let nets: Vec<RectangularPatch<C>> = (0..=own).map(net_of).collect();
        let line = patch.iso(first, along)?.scheme(across)?;
        let layers = (0..=other).map(|layer| line.layer(layer).map(<[C]>::to_vec).collect()).collect();
        Ok(Self { first, parameters: (u.clone(), v.clone()), nets, layers })
    }

    /// The parameter that comes first.
    #[must_use]
    pub fn first(&self) -> Axis {
        self.first
    }

    /// The parameters.
    #[must_use]
    pub fn parameters(&self) -> (&C, &C) {
        (&self.parameters.0, &self.parameters.1)
    }

    /// The nets after 0, 1, … steps in the first parameter.
    #[must_use]
    pub fn nets(&self) -> &[RectangularPatch<C>] {
        &self.nets
    }

    /// The points after 0, 1, … steps in the other one.
    #[must_use]
    pub fn layers(&self) -> &[Vec<Vec<C>>] {
        &self.layers
    }

    /// The point `F(u, v)`.
    #[must_use]
    pub fn point(&self) -> &[C] {
        // The last layer is one point.
        &self.layers[self.layers.len() - 1][0]
    }

    /// The polar label of a point of the first stage: step `l`, entry `(i, j)`.
    ///
    /// # Panics
    /// If there is no such entry.
    #[must_use]
    pub fn label(&self, l: usize, i: usize, j: usize) -> String {
        let (p, q) = self.nets[l].degree();
        match self.first {
            Axis::U => bidegree_label(&[("r1", remaining(p, [i])), ("s1", i), ("u", l)], &[("r2", remaining(q, [j])), ("s2", j)]),
            Axis::V => bidegree_label(&[("r1", remaining(p, [i])), ("s1", i)], &[("r2", remaining(q, [j])), ("s2", j), ("v", l)]),
        }
    }

    /// The polar label of a point of the second stage: step `l`, entry `k`.
    ///
    /// # Panics
    /// If there is no such entry.
    #[must_use]
    pub fn second_label(&self, l: usize, k: usize) -> String {
        let (p, q) = self.nets[0].degree();
        match self.first {
            Axis::U => bidegree_label(&[("u", p)], &[("r2", remaining(q, [l, k])), ("s2", k), ("v", l)]),
            Axis::V => bidegree_label(&[("r1", remaining(p, [l, k])), ("s1", k), ("u", l)], &[("v", q)]),
        }
    }
}

/// The steps in both parameters at once, each by bilinear interpolation of four
/// neighbours: the one-step view (MA323, day 25, section 4). Where the degrees
/// differ, steps in the parameter of the higher degree follow.
///
/// ```
/// use casteljau::{Rational, Rectangle, RectangularPatch};
/// let rows = [[0, 4], [8, 0]].map(|row| row.map(|z| vec![Rational::from(z)]).to_vec()).to_vec();
/// let patch = RectangularPatch::from_rows(rows, Rectangle::unit())?;
/// let half = Rational::new(1, 2);
/// let steps = patch.common_steps(&[half.clone(), half.clone()])?;
/// assert_eq!(steps.point(), [Rational::from(3)]);
/// # Ok::<(), casteljau::Error>(())
/// ```
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct CommonSteps<C = Rational> {
    parameters: (C, C),
    nets: Vec<RectangularPatch<C>>,
    common: usize,
}

impl<C: Coefficient> CommonSteps<C> {
    pub(crate) fn of(patch: &RectangularPatch<C>, [u, v]: &[C; 2]) -> Result<Self, Error> {
        let (p, q) = patch.degree();
        let steps = p.min(q);
        let weights: [Weights<C>; 2] = [patch.argument(Axis::U, u)?, patch.argument(Axis::V, v)?];
        let shapes: Vec<Shape> = (0..=steps).map(|k| Shape::rectangle(p - k, q - k, patch.dimension())).collect();
        // Both scales once a step.
        let (mut parameters, mut scales) = (Integers::default(), Integers::default());
        weights.iter().for_each(|weights| parameters.extend(weights.rows.as_slice()));
        for _ in 0..steps {
            weights.iter().for_each(|weights| scales.extend(weights.scales.as_slice()));
        }
        let layout = |(k, &shape): (usize, &Shape)| Layout::constant(shape, scales.as_slice().up_to(2 * k));
        let layouts: Vec<Layout<'_, C>> = shapes.iter().enumerate().map(layout).collect();
        let task = task::CommonSteps { shape: patch.net().shape, steps };
        let mut rest = C::compute(&task, &patch.net().coordinates, parameters.as_slice(), &layouts);
        let mut nets = Vec::with_capacity(p.max(q) + 1);
        for shape in shapes {
            let others = rest.split_off(shape.points() * shape.stride);
            nets.push(RectangularPatch::from_net(ControlNet { shape, coordinates: rest }, patch.frame().clone()));
            rest = others;
        }
        // What is left is a line, or already the point.
        let last = &nets[steps];
        let axis = if p > q { Axis::U } else { Axis::V };
        let [u_weights, v_weights] = &weights;
        let more: Vec<RectangularPatch<C>> = (1..=p.abs_diff(q))
            .map(|count| {
                let arguments = match axis {
                    Axis::U => [u_weights.repeated(count), Weights::default()],
                    Axis::V => [Weights::default(), v_weights.repeated(count)],
                };
                RectangularPatch::from_net(last.net().polar_value(&arguments), patch.frame().clone())
            })
            .collect();
        nets.extend(more);
        Ok(Self { parameters: (u.clone(), v.clone()), nets, common: steps })
    }

    /// The parameters.
    #[must_use]
    pub fn parameters(&self) -> (&C, &C) {
        (&self.parameters.0, &self.parameters.1)
    }

    /// The nets after 0, 1, … steps.
    #[must_use]
    pub fn nets(&self) -> &[RectangularPatch<C>] {
        &self.nets
    }

    /// How many of the steps are in both parameters.
    #[must_use]
    pub fn common(&self) -> usize {
        self.common
    }

    /// The point `F(u, v)`.
    #[must_use]
    pub fn point(&self) -> &[C] {
        // The last net is one point.
        self.nets[self.nets.len() - 1].point(0, 0)
    }

    /// The polar label of a point: step `l`, entry `(i, j)`.
    ///
    /// # Panics
    /// If there is no such entry.
    #[must_use]
    pub fn label(&self, l: usize, i: usize, j: usize) -> String {
        let ((p, q), (all_p, all_q)) = (self.nets[l].degree(), self.nets[0].degree());
        bidegree_label(&[("r1", remaining(p, [i])), ("s1", i), ("u", all_p - p)], &[("r2", remaining(q, [j])), ("s2", j), ("v", all_q - q)])
    }
}
