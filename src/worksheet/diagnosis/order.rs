//! Nets in another order, and two values exchanged.

use super::{Case, holds};
use crate::worksheet::quantity::{Point, Quantity};

/// The rows of a list of lists; a flat list is one row.
fn rows(value: &Quantity) -> Option<Vec<Vec<Quantity>>> {
    let list = match value {
        Quantity::Net(net) => net.list(),
        other => other.clone(),
    };
    let Quantity::List(items) = list else { return None };
    if items.iter().all(|item| matches!(item, Quantity::List(_))) {
        let row = |item| match item {
            Quantity::List(row) => row,
            other => vec![other],
        };
        return Some(items.into_iter().map(row).collect());
    }
    Some(vec![items])
}

fn list(rows: Vec<Vec<Quantity>>) -> Quantity {
    let mut lists: Vec<Quantity> = rows.into_iter().map(Quantity::List).collect();
    if lists.len() == 1 { lists.pop().unwrap_or(Quantity::List(Vec::new())) } else { Quantity::List(lists) }
}

type Grid = Vec<Vec<Quantity>>;

fn transposed(rows: &Grid) -> Grid {
    let width = rows.iter().map(Vec::len).max().unwrap_or(0);
    (0..width).map(|j| rows.iter().filter_map(|row| row.get(j).cloned()).collect()).collect()
}

fn backward(rows: &Grid) -> Grid {
    rows.iter().map(|row| row.iter().rev().cloned().collect()).collect()
}

fn upside_down(rows: &Grid) -> Grid {
    rows.iter().rev().cloned().collect()
}

/// A triangular net with the vertices in another order: the entry at exponents of r, s, t.
fn turned(rows: &Grid, order: [usize; 3]) -> Grid {
    let m = rows.len() - 1;
    let entry = |i: usize, j: usize| {
        let mut old = [0; 3];
        order.iter().zip([i, j, m - i - j]).for_each(|(&vertex, exponent)| old[vertex] = exponent);
        rows[old[0]][old[1]].clone()
    };
    (0..=m).map(|i| (0..=m - i).map(|j| entry(i, j)).collect()).collect()
}

fn is_triangle(rows: &Grid) -> bool {
    rows.len() > 1 && rows.iter().enumerate().all(|(i, row)| row.len() == rows.len() - i)
}

fn is_inverted_triangle(rows: &Grid) -> bool {
    rows.len() > 1 && rows.iter().enumerate().all(|(i, row)| row.len() == i + 1)
}

/// A net whose points are right and in another order.
pub(super) fn of_nets(case: &Case<'_>) -> Option<String> {
    let (left, right) = (rows(case.left.1)?, rows(case.right.1)?);
    if right.iter().map(Vec::len).sum::<usize>() > 4096 {
        return None;
    }
    let expected = list(left.clone());
    let matches = |rows: &Grid| holds(&list(rows.clone()), &expected);
    let turn =
        |names: &str| format!("the net is in the order of the vertices {names}: here they are r, s, t, rows i = 0..m of r, then j of s");
    const ORDERS: [([usize; 3], &str); 5] =
        [([1, 0, 2], "s, r, t"), ([0, 2, 1], "r, t, s"), ([2, 1, 0], "t, s, r"), ([1, 2, 0], "t, r, s"), ([2, 0, 1], "s, t, r")];
    if is_triangle(&left) {
        // From the top down: the row of the largest i first.
        let top_down = if is_inverted_triangle(&right) { Some(upside_down(&right)) } else { None };
        for grid in [Some(right.clone()), top_down.clone(), top_down.as_ref().map(backward)].into_iter().flatten().filter(is_triangle) {
            if grid != right && matches(&grid) {
                return Some("the net is written from the other side: rows are i = 0..m of r, then j of s".to_owned());
            }
            for (order, names) in ORDERS {
                if matches(&turned(&grid, order)) {
                    return Some(turn(names));
                }
            }
        }
    }
    let orders: [(&str, Grid); 7] = [
        ("reversed", upside_down(&backward(&right))),
        ("transposed: u and v are exchanged", transposed(&right)),
        ("reversed in u", upside_down(&right)),
        ("reversed in v", backward(&right)),
        ("turned by a quarter", backward(&transposed(&right))),
        ("turned by a quarter the other way", upside_down(&transposed(&right))),
        ("transposed and reversed", upside_down(&backward(&transposed(&right)))),
    ];
    let same_points = right.len() > 1 || right.iter().any(|row| row.len() > 1);
    orders.into_iter().find(|(_, grid)| same_points && matches(grid)).map(|(name, _)| match name {
        "reversed" if left.len() == 1 => "the list is in the reverse order: the ends r and s are exchanged".to_owned(),
        name => format!("the net is {name}"),
    })
}

/// Two entries of lists, points or polynomials that are exchanged.
pub(super) fn exchanged(case: &Case<'_>) -> Option<String> {
    let (mut left, mut right) = (Vec::new(), Vec::new());
    points(case.left.1, String::new(), &mut left);
    points(case.right.1, String::new(), &mut right);
    if left.len() != right.len() {
        return None;
    }
    let wrong: Vec<usize> = (0..left.len()).filter(|&index| left[index].1 != right[index].1).collect();
    match *wrong.as_slice() {
        [a, b] if left[a].1 == right[b].1 && left[b].1 == right[a].1 => {
            Some(format!("the entries {} and {} are exchanged", left[a].0, left[b].0))
        }
        [a] => coordinates(&left[a].1, &right[a].1).or_else(|| coefficients(&left[a].1, &right[a].1)),
        _ => None,
    }
}

/// All points and numbers of nested lists, with their places.
fn points(value: &Quantity, place: String, found: &mut Vec<(String, Quantity)>) {
    match value {
        Quantity::List(items) => {
            items.iter().enumerate().for_each(|(index, item)| points(item, format!("{place}[{index}]"), found));
        }
        Quantity::Net(net) => points(&net.list(), place, found),
        other => found.push((place, other.clone())),
    }
}

/// Two coordinates of a point that are exchanged.
fn coordinates(left: &Quantity, right: &Quantity) -> Option<String> {
    let (Quantity::Point(Point { coordinates: left, .. }), Quantity::Point(Point { coordinates: right, .. })) = (left, right) else {
        return None;
    };
    if left.len() != right.len() {
        return None;
    }
    let wrong: Vec<usize> = (0..left.len()).filter(|&index| left[index] != right[index]).collect();
    match *wrong.as_slice() {
        [a, b] if left[a] == right[b] && left[b] == right[a] => Some(format!("the coordinates {} and {} are exchanged", a + 1, b + 1)),
        [a] => coefficients(&Quantity::Number(left[a].clone()), &Quantity::Number(right[a].clone())),
        _ => None,
    }
}

/// Two terms of a polynomial with each other's coefficients.
fn coefficients(left: &Quantity, right: &Quantity) -> Option<String> {
    let (Quantity::Number(left), Quantity::Number(right)) = (left, right) else { return None };
    let difference = left - right;
    let wrong: Vec<_> = difference.terms().map(|(monomial, _)| monomial.clone()).collect();
    let [a, b] = wrong.as_slice() else { return None };
    let crossed = left.coefficient(a) == right.coefficient(b) && left.coefficient(b) == right.coefficient(a);
    crossed.then(|| format!("the terms with {a} and {b} have each other's coefficients"))
}
