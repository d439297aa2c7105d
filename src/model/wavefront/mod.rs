//! The free-form curves and surfaces of Wavefront OBJ (Alias|Wavefront,
//! *Advanced Visualizer Manual*, appendix B1, "Object Files").

mod element;
mod statement;
#[cfg(test)]
mod tests;

use super::scanner::read_scanned;
use super::splines::SplineWork;
use super::{Decimals, Flaw, Follow, Format, Model, Omission, Part, Places, group_name};
use crate::exact::{ParseNumberError, Rational};
use crate::syntax::limits::MAX_DEGREE;
use element::{Basis, Element};
use statement::{Statement, Statements, Word};

/// Reads the curves and surfaces of a file: Bézier and B-spline, polynomial or
/// rational, within the range of parameters that they state. The weight of a
/// rational point is the fourth number of its vertex.
///
/// Polygons, and everything that does not say what a curve or surface is, are
/// passed over in silence; other bases, trimming and curves in parameter planes
/// are omissions.
pub(super) fn read(text: &str) -> Result<Model, Flaw> {
    let mut reader = Reader {
        places: Places::new(text),
        decimals: Decimals::default(),
        vertices: Vec::new(),
        weights: Vec::new(),
        basis: Basis::Unknown,
        rational: false,
        degrees: (0, 0),
        name: None,
        element: None,
        curves: 0,
        work: SplineWork::default(),
        parts: Vec::new(),
        joints: Vec::new(),
        omissions: Vec::new(),
    };
    let mut statements = Statements::new(text);
    while let Some(statement) = statements.next() {
        reader.statement(&statement)?;
    }
    if let Some(element) = reader.element {
        return Err(Flaw::at(element.place, "the file ends inside of this curve or surface, expected `end` behind it"));
    }
    let Reader { decimals, parts, joints, omissions, .. } = reader;
    Ok(Model { joints, omissions, ..Model::of_patches(Format::Wavefront, parts, decimals.finest()) })
}

/// What is known at a line of the file.
struct Reader<'a> {
    places: Places<'a>,
    decimals: Decimals,
    vertices: Vec<[Rational; 3]>,
    /// The weights of the vertices up to the last that has one.
    weights: Vec<Rational>,
    basis: Basis,
    rational: bool,
    degrees: (usize, usize),
    name: Option<String>,
    /// The curve or surface that has begun and not ended.
    element: Option<Element>,
    curves: usize,
    work: SplineWork,
    parts: Vec<Part>,
    joints: Vec<Follow>,
    omissions: Vec<Omission>,
}

impl<'a> Reader<'a> {
    fn statement(&mut self, statement: &Statement<'a>) -> Result<(), Flaw> {
        match statement.keyword {
            "v" => self.vertex(statement),
            "cstype" => self.basis(statement),
            "deg" => self.degrees(statement),
            "curv" | "surf" | "curv2" => self.begin(statement),
            "parm" => self.parameters(statement),
            "end" => self.end(statement),
            "o" | "g" => {
                self.name = group_name(statement.rest());
                Ok(())
            }
            "trim" | "hole" => self.omit(statement, "trimming is passed over, and the surface read as a whole"),
            "con" => self.omit(statement, "the statement that trimmed surfaces are connected is passed over"),
            "bsp" | "bzp" | "cdc" | "cdp" => self.omit(statement, "the patches of old versions of the format are not read"),
            "call" => self.omit(statement, "the file that is called is not read"),
            _ => Ok(()),
        }
    }

    fn omit(&mut self, statement: &Statement, what: &'static str) -> Result<(), Flaw> {
        let place = self.places.of(statement.at);
        self.omissions.push(Omission { place, what });
        Ok(())
    }

    /// `v x y z [w]`, or with a colour `v x y z [w] r g b`.
    fn vertex(&mut self, statement: &Statement<'a>) -> Result<(), Flaw> {
        let mut words = statement.words();
        let expected = "a coordinate of a vertex";
        let point = [
            self.number(words.next(), statement, expected)?,
            self.number(words.next(), statement, expected)?,
            self.number(words.next(), statement, expected)?,
        ];
        self.vertices.push(point);
        let Some(word) = words.next() else { return Ok(()) };
        if matches!(words.count(), 0 | 3) {
            let weight = self.aside(Some(word), statement, "the weight of a vertex")?;
            self.weights.resize(self.vertices.len() - 1, Rational::from(1));
            self.weights.push(weight);
        }
        Ok(())
    }

    fn basis(&mut self, statement: &Statement<'a>) -> Result<(), Flaw> {
        let mut words = statement.words().peekable();
        self.rational = words.next_if(|word| word.text == "rat").is_some();
        self.basis = match words.next() {
            None => return Err(self.ends(statement, "the type of curves and surfaces")),
            Some(word) => match word.text {
                "bezier" => Basis::Bezier,
                "bspline" => Basis::Spline,
                "bmatrix" => Basis::Other("a curve or surface given by a basis matrix is not read"),
                "cardinal" => Basis::Other("a cardinal curve or surface is not read"),
                "taylor" => Basis::Other("a Taylor curve or surface is not read"),
                _ => return Err(self.unexpected(word, "a type of curves and surfaces: bezier, bspline, bmatrix, cardinal or taylor")),
            },
        };
        Ok(())
    }

    fn degrees(&mut self, statement: &Statement<'a>) -> Result<(), Flaw> {
        let mut words = statement.words();
        let degree = |reader: &mut Self, word: Option<Word<'a>>| {
            let expected = format!("a degree, a whole number from 1 to {MAX_DEGREE}");
            let Some(word) = word else { return Err(reader.ends(statement, expected)) };
            let degree = word.text.parse().ok().filter(|degree| (1..=MAX_DEGREE as usize).contains(degree));
            degree.ok_or_else(|| reader.unexpected(word, expected))
        };
        self.degrees.0 = degree(self, words.next())?;
        self.degrees.1 = match words.next() {
            None => 0,
            word => degree(self, word)?,
        };
        Ok(())
    }

    /// The beginning of a curve or surface, with its range of parameters and its points.
    fn begin(&mut self, statement: &Statement<'a>) -> Result<(), Flaw> {
        let place = self.places.of(statement.at);
        if self.element.is_some() {
            return Err(Flaw::at(place, format!("found `{}`, expected `end` behind the curve or surface before it", statement.keyword)));
        }
        let mut element = Element::new(place, self.basis, self.rational, self.degrees);
        if statement.keyword == "curv2" {
            element.basis = Basis::Other("a curve in the parameter plane of a surface is no curve in space");
        }
        if !matches!(element.basis, Basis::Other(_)) {
            element.is_surface = statement.keyword == "surf";
            let mut words = statement.words();
            let ends = if element.is_surface { 4 } else { 2 };
            for _ in 0..ends {
                let end = self.aside(words.next(), statement, "an end of a range of parameters")?;
                element.range.push(end);
            }
            for word in words {
                let index = self.index(word)?;
                element.points.push(index);
            }
        }
        self.element = Some(element);
        Ok(())
    }

    /// `parm u` and `parm v`: breakpoints or knots.
    fn parameters(&mut self, statement: &Statement<'a>) -> Result<(), Flaw> {
        let mut words = statement.words();
        let axis = match words.next() {
            Some(Word { text: "u", .. }) => 0,
            Some(Word { text: "v", .. }) => 1,
            Some(word) => return Err(self.unexpected(word, "`u` or `v`")),
            None => return Err(self.ends(statement, "`u` or `v`")),
        };
        let mut parameters = Vec::new();
        for word in words {
            parameters.push(self.aside(Some(word), statement, "a parameter")?);
        }
        match &mut self.element {
            Some(element) => element.parameters[axis].append(&mut parameters),
            None => return Err(Flaw::at(self.places.of(statement.at), "found `parm`, expected a curve or surface before it")),
        }
        Ok(())
    }

    fn end(&mut self, statement: &Statement<'a>) -> Result<(), Flaw> {
        let place = self.places.of(statement.at);
        let Some(element) = self.element.take() else {
            return Err(Flaw::at(place, "found `end`, expected a curve or surface before it"));
        };
        if let Basis::Other(what) = element.basis {
            self.omissions.push(Omission { place: element.place, what });
            return Ok(());
        }
        let weights = element.rational.then_some(self.weights.as_slice());
        let mut points = Vec::with_capacity(element.points.len());
        for &index in &element.points {
            let point = element::point(&self.vertices[index], weights.map(|weights| weights.get(index)));
            for coordinate in &point {
                // Points may be used again and again.
                self.decimals.hold(coordinate).map_err(|error| Flaw::at(element.place, format!("the points are too long: {error}")))?;
            }
            points.push(point);
        }
        let pieces = element.pieces(points, &mut self.work).map_err(|message| Flaw::at(element.place, message))?;
        if !element.is_surface {
            let (first, contour) = (self.parts.len(), self.curves);
            self.curves += 1;
            self.joints.extend(Follow::chain(first..first + pieces.len(), contour, element.place));
        }
        for piece in pieces {
            let part = Part { piece, rational: element.rational, has_frame: true, name: self.name.clone(), place: element.place };
            part.add_to(&mut self.parts)?;
        }
        Ok(())
    }

    /// The place in the list of a vertex: from 1 on, or from -1 backward; what
    /// stands behind a slash are texture and normal.
    fn index(&mut self, word: Word<'a>) -> Result<usize, Flaw> {
        let count = self.vertices.len();
        let number = word.text.split('/').next().and_then(|text| text.parse::<i64>().ok());
        let index = number.and_then(|number| match number {
            1.. => usize::try_from(number - 1).ok(),
            0 => None,
            _ => count.checked_sub(usize::try_from(number.unsigned_abs()).unwrap_or(usize::MAX)),
        });
        index.filter(|&index| index < count).ok_or_else(|| self.unexpected(word, format!("the index of one of {count} vertices")))
    }

    fn number(&mut self, word: Option<Word<'a>>, statement: &Statement, expected: &str) -> Result<Rational, Flaw> {
        let Some(word) = word else { return Err(self.ends(statement, expected)) };
        read_scanned(&mut self.decimals, word.text).map_err(|error| match error {
            ParseNumberError::Malformed => self.unexpected(word, expected),
            error => self.unexpected(word, format!("{expected}: {error}")),
        })
    }

    /// A number that is no coordinate.
    fn aside(&mut self, word: Option<Word<'a>>, statement: &Statement, expected: &str) -> Result<Rational, Flaw> {
        let finest = self.decimals.finest();
        let number = self.number(word, statement, expected);
        self.decimals.restore(finest);
        number
    }

    fn unexpected(&mut self, word: Word, expected: impl std::fmt::Display) -> Flaw {
        Flaw::expected(self.places.of(word.at), word.text, expected)
    }

    fn ends(&mut self, statement: &Statement, expected: impl std::fmt::Display) -> Flaw {
        Flaw::at(self.places.of(statement.end()), format!("the line ends here, expected {expected}"))
    }
}
