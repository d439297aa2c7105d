//! Lists of points: control polygons and control nets.

use std::collections::BTreeMap;

use num_traits::Zero;

use super::evaluate::Value;
use super::parser::Parser;
use super::token::{Bracket, TokenKind};
use super::{Span, SyntaxError};
use crate::symbolic::Polynomial;

/// One point as it was written.
#[derive(Clone, Debug, PartialEq)]
pub struct PointInput {
    /// The coordinates, at least one; a plain number is a point of a line.
    pub coordinates: Vec<Polynomial>,
    /// The weight behind the point, if there was one.
    pub weight: Option<Polynomial>,
    /// Where the point was written, its weight included.
    pub span: Span,
}

/// How points were arranged.
#[derive(Clone, Debug, PartialEq)]
pub enum Nesting {
    /// One list, at least one point.
    Flat(Vec<PointInput>),
    /// Rows, at least one, none of them empty; not necessarily of one length.
    Rows(Vec<Vec<PointInput>>),
}

/// A list of points as it was written; all have the same number of coordinates.
#[derive(Clone, Debug, PartialEq)]
pub struct PointsInput {
    /// The points.
    pub nesting: Nesting,
    /// The number of coordinates of every point, at least 1.
    pub dimension: usize,
}

impl PointsInput {
    /// All points, row by row.
    pub fn points(&self) -> impl Iterator<Item = &PointInput> {
        let rows = match &self.nesting {
            Nesting::Flat(points) => std::slice::from_ref(points),
            Nesting::Rows(rows) => rows.as_slice(),
        };
        rows.iter().flatten()
    }
}

/// Reads points separated by blanks or commas, in rows separated by `;`, or in
/// lists `[…]`, nested for rows; lists may also be Mathematica's `{{0, 0}, …}`.
///
/// # Errors
/// If the text is no such list, if a point has another number of coordinates
/// than the others, or if it exceeds a limit.
///
/// ```
/// use casteljau::syntax;
/// let points = syntax::parse_points("(0,0) (-4,4):2 (a,1/2)")?;
/// assert_eq!((points.dimension, points.points().count()), (2, 3));
/// # Ok::<(), syntax::SyntaxError>(())
/// ```
pub fn parse_points(text: &str) -> Result<PointsInput, SyntaxError> {
    Parser::new(text)?.points()
}

enum Item {
    Point(PointInput),
    List { items: Vec<Item>, span: Span, curly: bool },
}

impl Item {
    fn span(&self) -> Span {
        match self {
            Self::Point(point) => point.span,
            Self::List { span, .. } => *span,
        }
    }

    /// A Mathematica list of numbers as the point it is inside another list.
    fn into_point(self) -> Self {
        let is_number = |item: &Self| matches!(item, Self::Point(point) if point.coordinates.len() == 1 && point.weight.is_none());
        match self {
            Self::List { items, span, curly: true } if items.iter().all(is_number) => {
                let coordinates = items.into_iter().flat_map(|item| match item {
                    Self::Point(point) => point.coordinates,
                    Self::List { .. } => Vec::new(),
                });
                Self::Point(PointInput { coordinates: coordinates.collect(), weight: None, span })
            }
            other => other,
        }
    }
}

impl Parser<'_> {
    pub(crate) fn points(&mut self) -> Result<PointsInput, SyntaxError> {
        const POINT: &str = "a point such as `(0,0)` or a list `[…]`";
        self.not_empty("points such as `(0,0) (1,2)`")?;
        self.set_spaced(true);
        let mut items = self.items(POINT)?;
        self.finish(POINT)?;
        if items.len() == 1 {
            items = match items.pop() {
                Some(Item::List { items, .. }) => items,
                other => other.into_iter().collect(),
            };
        } else {
            items = items.into_iter().map(Item::into_point).collect();
        }
        let nesting = arrange(items)?;
        let input = PointsInput { nesting, dimension: 0 };
        let dimension = common_dimension(&input)?;
        Ok(PointsInput { dimension, ..input })
    }

    /// Items up to the end or a closing bracket; rows become lists.
    fn items(&mut self, what: &str) -> Result<Vec<Item>, SyntaxError> {
        let mut rows: Vec<Item> = Vec::new();
        let mut row: Vec<Item> = Vec::new();
        loop {
            row.push(self.item(what)?);
            // A row alone stays as it is; from the first semicolon on rows are lists.
            match self.peek() {
                TokenKind::Comma => {
                    self.advance();
                }
                TokenKind::Semicolon => {
                    self.advance();
                    rows.push(list_of_row(std::mem::take(&mut row)));
                }
                TokenKind::End | TokenKind::Close(_) if rows.is_empty() => return Ok(row),
                TokenKind::End | TokenKind::Close(_) => {
                    rows.push(list_of_row(row));
                    return Ok(rows);
                }
                _ => {}
            }
        }
    }

    fn item(&mut self, what: &str) -> Result<Item, SyntaxError> {
        let start = self.token(0).span;
        let curly = match self.peek() {
            TokenKind::Open(Bracket::Square) => false,
            TokenKind::Open(Bracket::Curly) if !self.is_latex() => true,
            TokenKind::End | TokenKind::Close(_) | TokenKind::Comma | TokenKind::Semicolon => return Err(self.expected(what)),
            _ => {
                let expression = self.expression()?;
                let coordinates = match self.evaluate(&expression)? {
                    Value::Scalar(value) => vec![value],
                    Value::Tuple(values) => values,
                };
                let weight = self.weight()?;
                let span = start.to(weight.as_ref().map_or(expression.span, |weight| weight.1));
                return Ok(Item::Point(PointInput { coordinates, weight: weight.map(|weight| weight.0), span }));
            }
        };
        self.advance();
        let items = self.items("a point or a number")?;
        let span = start.to(self.advance().span);
        let items = items.into_iter().map(Item::into_point).collect();
        let list = Item::List { items, span, curly };
        if self.peek() != TokenKind::Colon {
            return Ok(list);
        }
        match list.into_point() {
            Item::Point(point) => {
                let weight = self.weight()?;
                let span = weight.as_ref().map_or(span, |weight| span.to(weight.1));
                Ok(Item::Point(PointInput { weight: weight.map(|weight| weight.0), span, ..point }))
            }
            Item::List { .. } => Err(self.expected("a blank or `,`, since a weight belongs to a single point")),
        }
    }

    /// The weight behind a point, with its place.
    fn weight(&mut self) -> Result<Option<(Polynomial, Span)>, SyntaxError> {
        if !self.take(TokenKind::Colon) {
            return Ok(None);
        }
        let expression = self.expression()?;
        let weight = self.evaluate_scalar(&expression)?;
        Ok(Some((weight, expression.span)))
    }
}

/// A row between semicolons as a list; a list alone is the row itself.
fn list_of_row(mut row: Vec<Item>) -> Item {
    if let Some(list) = row.pop_if(|item| matches!(item, Item::List { .. })) {
        if row.is_empty() {
            return list;
        }
        row.push(list);
    }
    let span = row.iter().map(Item::span).reduce(Span::to).unwrap_or_default();
    Item::List { items: row.into_iter().map(Item::into_point).collect(), span, curly: false }
}

/// Points as a flat list, lists of points as rows, nothing else.
fn arrange(items: Vec<Item>) -> Result<Nesting, SyntaxError> {
    let mut points = Vec::new();
    let mut rows = Vec::new();
    for item in items {
        match item {
            Item::Point(point) if rows.is_empty() => points.push(point),
            Item::Point(point) => return Err(SyntaxError::new(point.span, "found a point between rows, expected a list of points")),
            Item::List { span, .. } if !points.is_empty() => {
                return Err(SyntaxError::new(span, "found a list between points, expected a point"));
            }
            Item::List { items, .. } => {
                let mut row = Vec::with_capacity(items.len());
                for item in items {
                    match item {
                        Item::Point(point) => row.push(point),
                        Item::List { span, .. } => {
                            return Err(SyntaxError::new(
                                span,
                                "found a list nested too deep, expected a point: a net is a list of rows of points",
                            ));
                        }
                    }
                }
                rows.push(row);
            }
        }
    }
    Ok(if rows.is_empty() { Nesting::Flat(points) } else { Nesting::Rows(rows) })
}

/// The number of coordinates of all points, or an error at the odd one.
fn common_dimension(input: &PointsInput) -> Result<usize, SyntaxError> {
    let mut counts: BTreeMap<usize, usize> = BTreeMap::new();
    for point in input.points() {
        *counts.entry(point.coordinates.len()).or_default() += 1;
    }
    let first = input.points().next().map_or(0, |point| point.coordinates.len());
    // The majority is right; among equals, the first point.
    let usual = counts.iter().max_by_key(|&(&dimension, &count)| (count, dimension == first)).map_or(0, |entry| *entry.0);
    match input.points().find(|point| point.coordinates.len() != usual) {
        None if usual.is_zero() => Err(SyntaxError::new(Span::default(), "found no points, expected at least one")),
        None => Ok(usual),
        Some(odd) => {
            let plural = |count: usize| if count == 1 { "1 coordinate".to_owned() } else { format!("{count} coordinates") };
            let found = plural(odd.coordinates.len());
            Err(SyntaxError::new(odd.span, format!("found a point with {found}, expected {} like the other points", plural(usual))))
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn point(point: &PointInput) -> String {
        let coordinates: Vec<String> = point.coordinates.iter().map(ToString::to_string).collect();
        format!("{}{}", coordinates.join(","), point.weight.as_ref().map_or(String::new(), |weight| format!(":{weight}")))
    }

    /// Points separated by blanks, rows by slashes; a bar begins each row.
    fn shown(source: &str) -> String {
        let row = |points: &[PointInput]| points.iter().map(point).collect::<Vec<_>>().join(" ");
        match parse_points(source) {
            Ok(PointsInput { nesting: Nesting::Flat(points), .. }) => row(&points),
            Ok(PointsInput { nesting: Nesting::Rows(rows), .. }) => rows.iter().map(|points| format!("|{}", row(points))).collect(),
            Err(error) => format!("{}: {error}", error.position(source).1),
        }
    }

    #[test]
    fn grammar() {
        for (source, expected) in [
            ("(0,0) (-4,4) (-4,-12) (0,0)", "0,0 -4,4 -4,-12 0,0"),
            ("(0,0), (1,1),(2,2)", "0,0 1,1 2,2"),
            ("(0,0)(1,1)", "0,0 1,1"),
            ("[(0,0), (1,2)]", "0,0 1,2"),
            ("[(0,0) (1,2)]", "0,0 1,2"),
            ("[1, 3, 5]", "1 3 5"),
            ("[1 3 -5]", "1 3 -5"),
            ("1 3 5", "1 3 5"),
            ("[1 - 3 5]", "-2 5"),
            ("(1,1):2 (2,2)", "1,1:2 2,2"),
            ("1:2 3:1/2", "1:2 3:1/2"),
            ("(a,b/2):w (2t,t^2)", "a,1/2 b:w 2 t,t^2"),
            ("(2 t, 3)", "2 t,3"),
            ("2(1,0) (1,0)/2 -(1,1)", "2,0 1/2,0 -1,-1"),
            ("(0,0) (1,1); (2,2) (3,3)", "|0,0 1,1|2,2 3,3"),
            ("[(0,0) (1,1); (2,2) (3,3)]", "|0,0 1,1|2,2 3,3"),
            ("[[(0,0), (1,1)], [(2,2), (3,3)]]", "|0,0 1,1|2,2 3,3"),
            ("[(0,0), (1,1)], [(2,2), (3,3)]", "|0,0 1,1|2,2 3,3"),
            ("[(0,0), (1,1)]; [(2,2), (3,3)]", "|0,0 1,1|2,2 3,3"),
            ("[[1, 2], [3]]", "|1 2|3"),
            ("[[(0,0)]]", "|0,0"),
            ("{{0, 0, 0}, {0, 1/2, 0}}", "0,0,0 0,1/2,0"),
            ("{{0,0},{1,1}}, {{2,2},{3,3}}", "|0,0 1,1|2,2 3,3"),
            ("{{{0,0},{1,1}},{{2,2},{3,3}}}", "|0,0 1,1|2,2 3,3"),
            ("{0, 1}", "0 1"),
            ("{0, 1} {1, 2}", "0,1 1,2"),
            ("{{0,0}:2, {1,1}}", "0,0:2 1,1"),
            (r"\left(\frac{2}{3}, 0\right), \left(0, \frac12\right).", "2/3,0 0,1/2"),
        ] {
            assert_eq!(shown(source), expected, "{source}");
        }
    }

    #[test]
    fn errors() {
        for (source, expected) in [
            ("", "1: found nothing, expected points such as `(0,0) (1,2)`"),
            ("(1,2) (3,4,5) (1,1)", "7: found a point with 3 coordinates, expected 2 coordinates like the other points"),
            ("(1,2,3) (4,5) (1,1)", "1: found a point with 3 coordinates, expected 2 coordinates like the other points"),
            ("(1,2) 3", "7: found a point with 1 coordinate, expected 2 coordinates like the other points"),
            ("(1,2),", "7: found the end of the input, expected a point such as `(0,0)` or a list `[…]`"),
            ("(1,2),,(3,4)", "7: found `,`, expected a point such as `(0,0)` or a list `[…]`"),
            ("[]", "2: found `]`, expected a point or a number"),
            ("[(1,2), (3,4)", "1: found `[` without a closing `]`"),
            ("(1,2) [(3,4)]", "7: found a list between points, expected a point"),
            ("[(3,4)] (1,2)", "9: found a point between rows, expected a list of points"),
            ("[[[(1,2)]]]", "3: found a list nested too deep, expected a point: a net is a list of rows of points"),
            ("(1,2);", "7: found the end of the input, expected a point such as `(0,0)` or a list `[…]`"),
            ("[(1,2)]:2", "8: found `:`, expected a blank or `,`, since a weight belongs to a single point"),
            ("(1,2):(3,4)", "7: found a point with 2 coordinates, expected a single value"),
            ("(1,2) = (3,4)", "7: found `=`, expected a number, a letter or `(`"),
            ("((1,2),3)", "2: found a point with 2 coordinates, expected a single value"),
        ] {
            assert_eq!(shown(source), expected, "{source}");
        }
    }

    #[test]
    fn places() {
        let source = "(0,0) (1,1):2";
        let spans = parse_points(source).map(|input| input.points().map(|point| point.span.text(source)).collect::<Vec<_>>());
        assert_eq!(spans, Ok(vec!["(0,0)", "(1,1):2"]));
    }
}
