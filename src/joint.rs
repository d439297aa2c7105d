//! Where two pieces meet, and the conditions of a smooth join one by one.

use crate::affine::{Frame, Parameter, PlaneParameter, Triangle};
use crate::error::Error;
use crate::exact::Rational;
use crate::piece::{Equation, Piece};
use crate::reading::Reading;
use crate::rectangular::bidegree_label;
use crate::scheme::polar_label;
use crate::triangular::TriangularPatch;

/// What two pieces have in common in the space of parameters.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Joint {
    /// A parameter of two curves.
    Parameter(Rational),
    /// An edge of two patches in one parameter plane, from point to point.
    Edge([[Rational; 2]; 2]),
}

/// One condition of a join: a polar value of both maps. The names of the
/// arguments are `s` and `t` for the ends of a common edge (`s` alone for
/// curves) and `q` for a vertex of the second piece off the joint.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct JoinCondition {
    /// How many arguments are off the joint: the order that it belongs to.
    pub order: usize,
    /// The polar label, such as `f(q,s,t)`.
    pub label: String,
    /// The polar value of the first map.
    pub first: Vec<Rational>,
    /// The polar value of the second map.
    pub second: Vec<Rational>,
}

impl JoinCondition {
    /// Whether it holds.
    #[must_use]
    pub fn holds(&self) -> bool {
        self.first == self.second
    }

    /// The second value minus the first.
    #[must_use]
    pub fn defect(&self) -> Vec<Rational> {
        self.second.iter().zip(&self.first).map(|(b, a)| b - a).collect()
    }
}

/// The vertices of a patch around its frame.
pub(crate) fn corners(frame: &Frame<Rational>) -> Vec<[Rational; 2]> {
    match frame {
        Frame::Interval(_) => Vec::new(),
        Frame::Triangle(frame) => frame.vertices().to_vec(),
        Frame::Rectangle(frame) => {
            let (u, v) = (frame.u(), frame.v());
            [(u.r(), v.r()), (u.s(), v.r()), (u.s(), v.s()), (u.r(), v.s())].map(|(u, v)| [u.clone(), v.clone()]).to_vec()
        }
    }
}

/// The sides of a patch.
fn sides(frame: &Frame<Rational>) -> Vec<[[Rational; 2]; 2]> {
    let corners = corners(frame);
    (0..corners.len()).map(|k| [corners[k].clone(), corners[(k + 1) % corners.len()].clone()]).collect()
}

impl Joint {
    /// The joint of two pieces over frames that share an end or a side; none if
    /// they share none, or more than one.
    #[must_use]
    pub fn between(first: &Piece, second: &Piece) -> Option<Self> {
        let (a, b) = (first.frame(), second.frame());
        let mut found = Vec::new();
        if let (Frame::Interval(a), Frame::Interval(b)) = (&a, &b) {
            found.extend([a.r(), a.s()].into_iter().filter(|end| [b.r(), b.s()].contains(end)).map(|end| Self::Parameter(end.clone())));
        }
        for side in sides(&a) {
            let [from, to] = &side;
            if sides(&b).iter().any(|[start, end]| (start, end) == (from, to) || (start, end) == (to, from)) {
                found.push(Self::Edge(side));
            }
        }
        if found.len() == 1 { found.pop() } else { None }
    }
}

/// The conditions for continuity of the orders up to `order`, each listed once
/// (CS348a, lecture 12, section 5; of the two vertices that the lecture uses one
/// is enough). Where the degrees differ the lower one is raised.
///
/// # Errors
/// [`Error::WrongShape`] if the joint does not fit the pieces; what making the
/// maps says.
pub fn join_conditions(first: &Piece, second: &Piece, joint: &Joint, order: usize) -> Result<Vec<JoinCondition>, Error> {
    match (first.equation()?, second.equation()?, joint) {
        (Equation::Curve(a), Equation::Curve(b), Joint::Parameter(s)) => {
            let Frame::Interval(frame) = second.frame() else { return Err(unfit()) };
            let q = if frame.r() == s { frame.s().clone() } else { frame.r().clone() };
            let degree = a.degree().max(b.degree());
            let (a, b) = (a.with_degree(degree)?, b.with_degree(degree)?);
            let condition = |order: usize| {
                let arguments: Vec<Rational> =
                    std::iter::repeat_n(q.clone(), order).chain(std::iter::repeat_n(s.clone(), degree - order)).collect();
                Ok(JoinCondition {
                    order,
                    label: polar_label(&[("q", order), ("s", degree - order)]),
                    first: a.blossom(&arguments)?,
                    second: b.blossom(&arguments)?,
                })
            };
            (0..=order.min(degree)).map(condition).collect()
        }
        (Equation::Surface(a), Equation::Surface(b), Joint::Edge([s, t])) => {
            if let (Reading::Bidegree(..), Reading::Bidegree(..)) = (a.reading(), b.reading()) {
                return rectangles(&a, &b, second, [s, t], order);
            }
            // A vertex of the second piece off the edge.
            let q = corners(&second.frame()).into_iter().find(|corner| corner != s && corner != t).ok_or_else(unfit)?;
            let (a, b) = (a.by_total_degree()?, b.by_total_degree()?);
            let degree = [&a, &b].map(|surface| surface.reading().groups()[0].0).into_iter().max().unwrap_or(0);
            let (a, b) = (a.read_as(Reading::Total(degree))?, b.read_as(Reading::Total(degree))?);
            let mut conditions = Vec::new();
            for order in 0..=order.min(degree) {
                for last in 0..=degree - order {
                    let counts = [(&q, order), (s, degree - order - last), (t, last)];
                    let arguments: Vec<PlaneParameter> = counts
                        .iter()
                        .flat_map(|(point, times)| std::iter::repeat_n(PlaneParameter::point((*point).clone()), *times))
                        .collect();
                    conditions.push(JoinCondition {
                        order,
                        label: polar_label(&[("q", order), ("s", degree - order - last), ("t", last)]),
                        first: a.blossom(&arguments)?,
                        second: b.blossom(&arguments)?,
                    });
                }
            }
            Ok(conditions)
        }
        _ => Err(unfit()),
    }
}

fn unfit() -> Error {
    Error::WrongShape("the joint does not fit these pieces: curves join at a parameter, patches along an edge".into())
}

/// The conditions of two rectangles along a line of one parameter: `s` is its
/// value there and `q` the other end of the second frame; the other parameter
/// runs over the ends `s` and `t` of the edge.
fn rectangles(
    a: &crate::surface::Surface,
    b: &crate::surface::Surface,
    second: &Piece,
    [from, to]: [&[Rational; 2]; 2],
    order: usize,
) -> Result<Vec<JoinCondition>, Error> {
    let (Reading::Bidegree(p1, q1), Reading::Bidegree(p2, q2)) = (a.reading(), b.reading()) else { return Err(unfit()) };
    let (p, q) = (p1.max(p2), q1.max(q2));
    let (a, b) = (a.read_as(Reading::Bidegree(p, q))?, b.read_as(Reading::Bidegree(p, q))?);
    let constant = usize::from(from[0] != to[0]);
    let Frame::Rectangle(frame) = second.frame() else { return Err(unfit()) };
    let own = if constant == 0 { frame.u() } else { frame.v() };
    let at = &from[constant];
    let off = if own.r() == at { own.s() } else { own.r() };
    let (across, along) = if constant == 0 { (p, q) } else { (q, p) };
    let list = |parts: [(&Rational, usize); 2]| {
        parts.iter().flat_map(|(x, times)| std::iter::repeat_n(Parameter::from((*x).clone()), *times)).collect::<Vec<Parameter>>()
    };
    let mut conditions = Vec::new();
    for order in 0..=order.min(across) {
        for last in 0..=along {
            let first_group = list([(off, order), (at, across - order)]);
            let second_group = list([(&from[1 - constant], along - last), (&to[1 - constant], last)]);
            let labels = (&[("q", order), ("s", across - order)][..], &[("s", along - last), ("t", last)][..]);
            let (us, vs, label) = if constant == 0 {
                (&first_group, &second_group, bidegree_label(labels.0, labels.1))
            } else {
                (&second_group, &first_group, bidegree_label(labels.1, labels.0))
            };
            let (first, second) = (a.blossom_bidegree(us, vs)?, b.blossom_bidegree(us, vs)?);
            conditions.push(JoinCondition { order, label, first, second });
        }
    }
    Ok(conditions)
}

/// Four control points of two triangles that are to be an affine image of
/// `p`, `s`, `t` and `q`, the vertices of their frames (CS348a, lecture 12, section 5).
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct AffineGroup {
    /// The other arguments of all four polar values, such as `s,t`.
    pub label: String,
    /// `A(p,…)`, `A(s,…)`, `A(t,…)` and `B(q,…)`.
    pub points: [Vec<Rational>; 4],
    /// Whether one affine map takes the vertices to them: `B(q,…)` is the same
    /// combination of the others as `q` is of `p`, `s` and `t`.
    pub holds: bool,
}

/// The condition for continuity of order 1 between two triangles in the form
/// of an affine image: the barycentric coordinates of `q` in `p`, `s`, `t`, and
/// for every choice of the other arguments from `s` and `t` the four points.
/// One affine map a choice takes the quadrilateral of the vertices to them.
///
/// # Errors
/// [`Error::WrongShape`] unless both are triangles with the joint as a side.
pub fn affine_groups(first: &Piece, second: &Piece, joint: &Joint) -> Result<([Rational; 3], Vec<AffineGroup>), Error> {
    let (Piece::Triangle(a), Piece::Triangle(b), Joint::Edge([s, t])) = (first, second, joint) else { return Err(unfit()) };
    let off = |patch: &TriangularPatch| patch.frame().vertices().iter().find(|vertex| *vertex != s && *vertex != t).cloned();
    let (p, q) = (off(a).ok_or_else(unfit)?, off(b).ok_or_else(unfit)?);
    let degree = a.degree().max(b.degree());
    let over = |patch: &TriangularPatch, inner: &[Rational; 2]| -> Result<TriangularPatch, Error> {
        let frame = Triangle::new(inner.clone(), s.clone(), t.clone())?;
        patch.elevate(degree - patch.degree())?.reframe(&frame)
    };
    let (a, b) = (over(a, &p)?, over(b, &q)?);
    let weights = a.frame().barycentric(&q)?;
    let group = |last: usize| {
        let first = degree - 1 - last;
        let points = [a.point(1, first), a.point(0, first + 1), a.point(0, first), b.point(1, first)].map(<[Rational]>::to_vec);
        let image = |axis: usize| (0..3).map(|k| &points[k][axis] * &weights[k]).sum::<Rational>();
        let holds = (0..points[3].len()).all(|axis| image(axis) == points[3][axis]);
        let label = polar_label(&[("s", first), ("t", last)]).trim_start_matches("f(").trim_end_matches(')').to_owned();
        AffineGroup { label, points, holds }
    };
    let groups = (0..degree).map(group).collect();
    Ok((weights, groups))
}

/// The net that a smooth neighbour is bound to have.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Extension {
    /// The continuation of the piece over the neighbour's frame: the neighbour's
    /// control points as far as they are forced.
    pub continuation: Piece,
    /// For every control point, in order, whether it is forced; the others are free.
    pub forced: Vec<bool>,
}

/// What continuity of order `order` across a joint forces on the neighbour over
/// a frame: the control points with at most `order` arguments off the joint are
/// those of the piece continued (CS348a, lecture 12, section 5; Farin, *Curves
/// and Surfaces for CAGD*, subdivision and continuity).
///
/// # Errors
/// [`Error::WrongShape`] if a curve is to be continued over the frame of a patch
/// or the reverse, or if the frame does not have the joint as one of its ends or sides.
pub fn extend(piece: &Piece, frame: &Frame<Rational>, joint: &Joint, order: usize) -> Result<Extension, Error> {
    let continuation = continued(piece, frame)?;
    let off = arguments_off(&continuation, joint)?;
    Ok(Extension { continuation, forced: off.into_iter().map(|off| off <= order).collect() })
}

/// The same map over another frame.
fn continued(piece: &Piece, frame: &Frame<Rational>) -> Result<Piece, Error> {
    Ok(match (piece, frame) {
        (Piece::Curve(segment), Frame::Interval(frame)) => Piece::Curve(segment.reframe(frame)?),
        (Piece::Triangle(patch), Frame::Triangle(frame)) => Piece::Triangle(patch.reframe(frame)?),
        (Piece::Rectangle(patch), Frame::Rectangle(frame)) => Piece::Rectangle(patch.reframe(frame)?),
        (Piece::Rectangle(patch), Frame::Triangle(frame)) => Piece::Triangle(patch.surface()?.over_triangle(frame)?),
        (Piece::Triangle(patch), Frame::Rectangle(frame)) => Piece::Rectangle(patch.surface()?.over_rectangle(frame)?),
        _ => return Err(unfit()),
    })
}

/// Both maps over the frame of the second piece, the lower degrees raised, so
/// that control points stand for control points.
pub(crate) fn over_one_frame(first: &Piece, second: &Piece) -> Result<[Piece; 2], Error> {
    let [first, second] = match (continued(first, &second.frame())?, second) {
        (Piece::Curve(a), Piece::Curve(b)) => {
            let degree = a.degree().max(b.degree());
            [&a, b].map(|segment| segment.elevate(degree - segment.degree()).map(Piece::Curve))
        }
        (Piece::Triangle(a), Piece::Triangle(b)) => {
            let degree = a.degree().max(b.degree());
            [&a, b].map(|patch| patch.elevate(degree - patch.degree()).map(Piece::Triangle))
        }
        (Piece::Rectangle(a), Piece::Rectangle(b)) => {
            let (p, q) = (a.degree().0.max(b.degree().0), a.degree().1.max(b.degree().1));
            [&a, b].map(|patch| patch.elevate(p - patch.degree().0, q - patch.degree().1).map(Piece::Rectangle))
        }
        _ => return Err(unfit()),
    };
    Ok([first?, second?])
}

/// For every control point of a piece, how many of its arguments are off a
/// joint that is one of the piece's ends or sides.
pub(crate) fn arguments_off(piece: &Piece, joint: &Joint) -> Result<Vec<usize>, Error> {
    Ok(match (piece, joint) {
        (Piece::Curve(segment), Joint::Parameter(at)) => {
            let degree = segment.degree();
            let first = segment.frame().r() == at;
            if !first && segment.frame().s() != at {
                return Err(unfit());
            }
            (0..=degree).map(|i| if first { i } else { degree - i }).collect()
        }
        (Piece::Triangle(patch), Joint::Edge(ends)) => {
            let on_joint = |vertex: &[Rational; 2]| ends.contains(vertex);
            let vertices = patch.frame().vertices();
            let inner = vertices.iter().position(|vertex| !on_joint(vertex)).ok_or_else(unfit)?;
            if vertices.iter().filter(|vertex| on_joint(vertex)).count() != 2 {
                return Err(unfit());
            }
            TriangularPatch::<Rational>::indices(patch.degree()).into_iter().map(|index| index[inner]).collect()
        }
        (Piece::Rectangle(patch), Joint::Edge([from, to])) => {
            let (p, q) = patch.degree();
            let along_v = from[0] == to[0];
            let own = if along_v { patch.frame().u() } else { patch.frame().v() };
            let at = if along_v { &from[0] } else { &from[1] };
            let first = own.r() == at;
            if !first && own.s() != at {
                return Err(unfit());
            }
            let count = |k: usize, degree: usize| if first { k } else { degree - k };
            (0..=p).flat_map(|i| (0..=q).map(move |j| (i, j))).map(|(i, j)| if along_v { count(i, p) } else { count(j, q) }).collect()
        }
        _ => return Err(unfit()),
    })
}
