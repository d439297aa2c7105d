//! The least change of a piece that makes it join another one smoothly.

use num_traits::{Signed, Zero};

use crate::affine::{AffineMap, Interval};
use crate::error::Error;
use crate::exact::Rational;
use crate::joint::{Joint, arguments_off, over_one_frame};
use crate::piece::Piece;
use crate::segment::Segment;
use crate::side::{Side, Strip};
use crate::smoothness::{conditions, unit_net};
use crate::weights::projected;

/// A piece whose control points were moved as little as possible: the sum of
/// the squared lengths of the moves is least.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Repair {
    /// The changed piece.
    pub piece: Piece,
    /// The places of the control points that moved.
    pub moved: Vec<usize>,
    /// The sum of the squared lengths of the moves.
    pub squares: Rational,
    /// For common tangent planes with a constant ratio: `λ`, which is positive,
    /// and the coefficients of `μ` in ascending powers of the side's parameter
    /// (see [`TangentPlaneJoin`](crate::TangentPlaneJoin)); none where it plays no part.
    pub ratio: Option<(Rational, Vec<Rational>)>,
}

impl Repair {
    /// The most conditions of a repair that moves more points than there are conditions.
    pub const MAX_CONDITIONS: usize = 96;

    fn new(old: &Piece, points: Vec<Vec<Rational>>, ratio: Option<(Rational, Vec<Rational>)>, rational: bool) -> Result<Self, Error> {
        let mut moved = Vec::new();
        let mut squares = Rational::from(0);
        for (place, (new, old)) in points.iter().zip(old.points()).enumerate() {
            if new != old {
                moved.push(place);
                // The weights stay as they are, so both are points.
                let ends = if rational { projected(new).zip(projected(old)) } else { Some((new.clone(), old.to_vec())) };
                let (new, old) = ends.unwrap_or_default();
                squares += new.iter().zip(&old).map(|(a, b)| (a - b).pow(2)).sum::<Rational>();
            }
        }
        Ok(Self { piece: old.with_points(points)?, moved, squares, ratio })
    }
}

/// The least change of the second piece after which it joins the first one with
/// continuity of this order. It is a projection: the conditions are linear in
/// the control points. Those with at most `order` arguments off the joint are
/// determined (where both pieces have the same degree they are those of the
/// first one continued), and all others stay. With `rational` the last coordinate is the
/// weight: the weights stay, the points move, and the continuity is Cartesian.
///
/// ```
/// use casteljau::{Interval, Joint, Piece, Rational, Segment, repair_to_order};
/// let q = Rational::from;
/// let over = |from, points: [i64; 4]| -> Result<Piece, casteljau::Error> {
///     Ok(Piece::Curve(Segment::new(1, points.map(q).to_vec(), Interval::new(q(from), q(from + 1))?)?))
/// };
/// let repair = repair_to_order(&over(0, [0, 0, 1, 3])?, &over(1, [3, 4, 9, 9])?, &Joint::Parameter(q(1)), 1, false)?;
/// assert_eq!(repair.piece, over(1, [3, 5, 9, 9])?);
/// assert_eq!((repair.moved, repair.squares), (vec![1], q(1)));
/// # Ok::<(), casteljau::Error>(())
/// ```
///
/// # Errors
/// [`Error::WrongShape`] if the joint is no end or side of the second piece;
/// [`Error::Unsupported`] if no change will do, as where the degree of the
/// second piece is too low; [`Error::TooLarge`] for more control points than
/// [`SmoothnessTest::MAX_POINTS`](crate::SmoothnessTest::MAX_POINTS) or, where
/// degrees differ or there are weights, more conditions than [`Repair::MAX_CONDITIONS`].
pub fn repair_to_order(first: &Piece, second: &Piece, joint: &Joint, order: usize, rational: bool) -> Result<Repair, Error> {
    let count = second.points().len();
    let rows = if rational { rational_system(first, second, joint, order)? } else { system(first, second, joint, order)? };
    let single = |row: &Vec<Rational>| row[..count].iter().filter(|x| !x.is_zero()).count() == 1;
    if rows.len() > Repair::MAX_CONDITIONS && !rows.iter().all(single) {
        return Err(Error::TooLarge { what: "number of conditions of a repair", limit: Repair::MAX_CONDITIONS });
    }
    let Some(moves) = solution(rows, count) else {
        let why = if rational { " with these weights, or at all" } else { "" };
        return Err(Error::Unsupported(format!(
            "no change of the second piece makes the join C{order}: its degree is too low{why}; `casteljau elevate` raises it"
        )));
    };
    let moved = |(point, change): (&[Rational], Vec<Rational>)| -> Vec<Rational> {
        let weight = point.last().filter(|_| rational);
        let shifted = |(place, x): (usize, &Rational)| match (change.get(place), weight) {
            (Some(step), Some(weight)) => x + step * weight,
            (Some(step), None) => x + step,
            (None, _) => x.clone(),
        };
        point.iter().enumerate().map(shifted).collect()
    };
    Repair::new(second, second.points().zip(moves).map(moved).collect(), None, rational)
}

/// The conditions on the moves of the second piece: coefficients, then what
/// their combination is to be, one number a coordinate.
fn system(first: &Piece, second: &Piece, joint: &Joint, order: usize) -> Result<Vec<Vec<Rational>>, Error> {
    let count = first.points().len();
    let dimension = first.dimension();
    let all: Vec<&[Rational]> = first.points().chain(second.points()).collect();
    let row = |(_, row): (usize, Vec<Rational>)| {
        let defect = (0..dimension).map(|axis| row.iter().zip(&all).map(|(factor, point)| factor * &point[axis]).sum::<Rational>());
        let defect: Vec<Rational> = defect.collect();
        row[count..].iter().map(|x| -x).chain(defect).collect()
    };
    Ok(conditions(first, second, joint, order)?.into_iter().map(row).collect())
}

/// The same for rational pieces: `X_A W_B - X_B W_A` is to vanish on the joint with its derivatives.
fn rational_system(first: &Piece, second: &Piece, joint: &Joint, order: usize) -> Result<Vec<Vec<Rational>>, Error> {
    if second.points().any(|point| point.last().is_none_or(Zero::is_zero)) {
        return Err(Error::Unsupported("a control point of the second piece has the weight 0: it is a direction, and cannot move".into()));
    }
    let dimension = second.dimension();
    // The points of the second piece as unknowns, times their weights.
    let mut unknown: Vec<Vec<Rational>> = unit_net(second)?.points().map(<[Rational]>::to_vec).collect();
    for (row, point) in unknown.iter_mut().zip(second.points()) {
        row.iter_mut().for_each(|x| *x *= &point[dimension - 1]);
    }
    let [a, b] = over_one_frame(first, second)?;
    let [_, unknown] = over_one_frame(first, &second.with_points(unknown)?)?;
    let axes = |range: std::ops::Range<usize>| {
        let rows = range.map(|axis| (0..dimension).map(|column| Rational::from(i64::from(column == axis))).collect::<Vec<_>>());
        let rows: Vec<_> = rows.collect();
        let zeros = vec![Rational::from(0); rows.len()];
        AffineMap::new(rows, zeros)
    };
    let (space, weight) = (axes(0..dimension - 1)?, axes(dimension - 1..dimension)?);
    let weight_of_first = a.transform(&weight)?;
    let unknown = unknown.product(&weight_of_first)?;
    let own = a.transform(&space)?.product(&b.transform(&weight)?)?;
    let other = b.transform(&space)?.product(&weight_of_first)?;
    let on_joint = weight_of_first.points().zip(arguments_off(&weight_of_first, joint)?).filter(|(_, off)| *off == 0);
    if on_joint.into_iter().all(|(weight, _)| weight[0].is_zero()) {
        return Err(Error::Unsupported("the weight of the first piece is 0 on the joint: its points there are at infinity".into()));
    }
    let off = arguments_off(&own, joint)?;
    let rows = unknown.points().zip(own.points().zip(other.points())).zip(off).filter(|(_, off)| *off <= order);
    Ok(rows.map(|((row, (own, other)), _)| row.iter().cloned().chain(own.iter().zip(other).map(|(x, y)| x - y)).collect()).collect())
}

/// Brings rows to their reduced echelon form in the first `columns` columns, and
/// gives the columns of their leading ones; rows that vanish there come last.
fn reduce(rows: &mut [Vec<Rational>], columns: usize) -> Vec<usize> {
    let mut pivots = Vec::new();
    for column in 0..columns {
        let rank = pivots.len();
        let Some(found) = (rank..rows.len()).find(|&row| !rows[row][column].is_zero()) else { continue };
        rows.swap(rank, found);
        if let Some(inverse) = rows[rank][column].recip() {
            rows[rank].iter_mut().filter(|x| !x.is_zero()).for_each(|x| *x *= &inverse);
        }
        let pivot = rows[rank].clone();
        for (place, row) in rows.iter_mut().enumerate() {
            if place != rank && !row[column].is_zero() {
                let factor = row[column].clone();
                row.iter_mut().zip(&pivot).filter(|(_, y)| !y.is_zero()).for_each(|(x, y)| *x -= y * &factor);
            }
        }
        pivots.push(column);
    }
    pivots
}

/// How the control points of the second piece move, one vector each; none if no
/// move will do.
///
/// The conditions are about the control points with at most `order` arguments
/// off the joint, and determine them: where a polynomial of the degree of the
/// piece has the wanted values and derivatives there, only one does. So the
/// other points stay, and the solution is the one with the least sum of squares.
fn solution(mut rows: Vec<Vec<Rational>>, unknowns: usize) -> Option<Vec<Vec<Rational>>> {
    let width = rows.first().map_or(unknowns, Vec::len);
    let pivots = reduce(&mut rows, unknowns);
    if rows[pivots.len()..].iter().any(|row| row.iter().any(|x| !x.is_zero())) {
        return None;
    }
    let mut solution = vec![vec![Rational::from(0); width - unknowns]; unknowns];
    for (&place, row) in pivots.iter().zip(&rows) {
        debug_assert!(row[..unknowns].iter().filter(|x| !x.is_zero()).count() == 1, "a control point that is not determined");
        solution[place] = row[unknowns..].to_vec();
    }
    Some(solution)
}

/// Control points of a curve, over `0..1`.
fn bernstein(points: Vec<Vec<Rational>>) -> Result<Segment, Error> {
    Segment::from_points(points, Interval::unit())
}

/// The same curve with so many degrees; none if it has none so low.
fn with_degree(segment: Segment, degree: usize) -> Result<Option<Segment>, Error> {
    let segment = if segment.degree() > degree { segment.reduce()?.segment } else { segment };
    degree.checked_sub(segment.degree()).map(|by| segment.elevate(by)).transpose()
}

fn difference(a: &[Rational], b: &[Rational]) -> Vec<Rational> {
    a.iter().zip(b).map(|(x, y)| x - y).collect()
}

/// The least change of the second piece after which it has the tangents or
/// tangent planes of the first one along a side, with a constant ratio `λ > 0`:
/// the side moves to that of the first piece, and the control points beside it
/// to where their differences from it are `λ` times those of the first piece,
/// on the other side. Where one of the pieces is a triangle, the derivative
/// along the side may be added, `μ` times, with a constant `μ` between two
/// triangles and a linear one beside a rectangle. Which `λ` and `μ` are best is
/// a matter of least squares. The second piece's side is run through from its
/// last to its first point if `reversed`.
///
/// # Errors
/// [`Error::Unsupported`] if the degree of the second piece is too low, if the
/// first piece has no tangent or tangent plane there, and if the best ratio is
/// not positive, so that it would fold the pieces onto each other.
pub fn repair_tangents(first: (&Piece, Side), second: (&Piece, Side), reversed: bool) -> Result<Repair, Error> {
    let too_low = || {
        Error::Unsupported("the degree of the second piece is too low for the side of the first one; `casteljau elevate` raises it".into())
    };
    let (own, other) = (Strip::of(first.0, first.1, false), Strip::of(second.0, second.1, reversed));
    let points: Vec<&[Rational]> = first.0.points().collect();
    let at = |places: &[usize]| places.iter().map(|&place| points[place].to_vec()).collect::<Vec<_>>();
    let edge = bernstein(at(&own.along))?;
    let degree = other.along.len() - 1;
    let forced = with_degree(edge.clone(), degree)?.ok_or_else(too_low)?;
    let forced: Vec<Vec<Rational>> = forced.points().map(<[Rational]>::to_vec).collect();
    // The fields that make up the differences of the second piece, with as many control points as these are.
    let last = other.inner.len().checked_sub(1).filter(|_| other.inner != other.along).ok_or_else(too_low)?;
    if own.inner.is_empty() {
        return Err(singular());
    }
    let across = own.inner.iter().zip(&own.along).map(|(&inner, &along)| difference(points[along], points[inner]));
    let mut fields = vec![with_degree(bernstein(across.collect())?, last)?.ok_or_else(too_low)?];
    if matches!(first.0, Piece::Triangle(_)) || matches!(second.0, Piece::Triangle(_)) {
        let along = bernstein(forced.clone())?.derivative()?;
        let mut power = bernstein(vec![vec![Rational::from(1)]])?;
        let x = Segment::new(1, vec![Rational::from(0), Rational::from(1)], Interval::unit())?;
        for _ in along.degree()..=last {
            fields.extend(with_degree(along.product(&power)?, last)?);
            power = power.product(&x)?;
        }
    }
    let targets: Vec<&[Rational]> = second.0.points().collect();
    let wanted: Vec<Rational> = other.inner.iter().zip(&forced).flat_map(|(&inner, along)| difference(targets[inner], along)).collect();
    let product = |a: &[Rational], b: &[Rational]| a.iter().zip(b).map(|(x, y)| x * y).sum::<Rational>();
    let row = |field: &Segment| {
        let entries = fields.iter().map(|other| product(field.coordinates(), other.coordinates()));
        entries.chain([product(field.coordinates(), &wanted)]).collect::<Vec<Rational>>()
    };
    let mut equations: Vec<Vec<Rational>> = fields.iter().map(row).collect();
    if reduce(&mut equations, fields.len()).len() < fields.len() {
        return Err(singular());
    }
    let factors: Vec<Rational> = equations.iter().filter_map(|row| row.last().cloned()).collect();
    if !factors[0].is_positive() {
        return Err(Error::Unsupported(format!(
            "the best ratio is {}, which is not positive: the second piece lies on the side of the first one",
            factors[0]
        )));
    }
    let mut changed: Vec<Vec<Rational>> = targets.iter().map(|point| point.to_vec()).collect();
    for (&place, point) in other.along.iter().zip(&forced) {
        changed[place].clone_from(point);
    }
    for (k, (&place, along)) in other.inner.iter().zip(&forced).enumerate() {
        let mut point = along.clone();
        for (factor, field) in factors.iter().zip(&fields) {
            point.iter_mut().zip(field.point(k)).for_each(|(x, y)| *x += factor * y);
        }
        changed[place] = point;
    }
    let (ratio, shear) = (factors[0].clone(), factors[1..].to_vec());
    Repair::new(second.0, changed, Some((ratio, shear)), false)
}

fn singular() -> Error {
    Error::Unsupported("the first piece has no tangent or tangent plane along the joint, so there is none to be taken over".into())
}
