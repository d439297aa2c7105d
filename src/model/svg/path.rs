//! Path data, command by command, and lists of points.

use crate::exact::{ParseNumberError, Rational};
use crate::model::outline::{Node, Outline, Point};
use crate::model::place::Places;
use crate::model::scanner::read_scanned;
use crate::model::xml::Attribute;
use crate::model::{Decimals, Flaw, Omission, Place};

/// A reader of the value of an attribute.
pub(super) struct PathReader<'a, 'p, 't> {
    text: &'a str,
    at: usize,
    base: Base,
    places: &'p Places<'t>,
    outline: &'p mut Outline,
    decimals: &'p mut Decimals,
    current: Point,
    /// The last control point, if the last command was a curve.
    handle: Option<Handle>,
}

/// How bytes of the value have places in the file.
enum Base {
    /// The value stands in the file from this byte on.
    Verbatim(usize),
    /// The value was decoded, and all of it is at one place.
    Decoded(Place),
}

/// The last inner control point of a curve.
struct Handle {
    degree: usize,
    point: Point,
}

const COMMANDS: &str = "MmLlHhVvCcSsQqTtAaZz";

impl<'a, 'p, 't> PathReader<'a, 'p, 't> {
    pub(super) fn new(attribute: &'a Attribute, places: &'p Places<'t>, outline: &'p mut Outline, decimals: &'p mut Decimals) -> Self {
        let base = if attribute.is_verbatim { Base::Verbatim(attribute.at) } else { Base::Decoded(places.of(attribute.at)) };
        Self { text: &attribute.value, at: 0, base, places, outline, decimals, current: origin(), handle: None }
    }

    /// Reads path data.
    pub(super) fn path(mut self) -> Result<(), Flaw> {
        self.skip_blanks();
        if self.text[self.at..].trim_end() == "none" {
            return Ok(());
        }
        let mut start = None;
        while let Some(command) = self.peek() {
            let at = self.at;
            if !COMMANDS.as_bytes().contains(&command) {
                return Err(self.unexpected(at, format!("a command, one of {COMMANDS}")));
            }
            if start.is_none() && !command.eq_ignore_ascii_case(&b'm') {
                return Err(self.unexpected(at, "M or m, with which a path begins"));
            }
            self.at += 1;
            if command.eq_ignore_ascii_case(&b'z') {
                let place = self.place(at);
                self.outline.close(place)?;
                if let Some(Node { point: [x, y], .. }) = start.clone() {
                    // The start is used twice more: by the closing line, and by what follows.
                    self.current = [self.held(x, at)?, self.held(y, at)?];
                }
                self.handle = None;
            } else {
                self.segments(command, &mut start)?;
            }
            self.skip_blanks();
        }
        self.outline.end();
        Ok(())
    }

    /// Reads a list of points, and closes it for a polygon.
    pub(super) fn polygon(mut self, closed: bool) -> Result<(), Flaw> {
        self.skip_blanks();
        let mut start = None;
        while self.peek().is_some() {
            let command = if start.is_none() { b'M' } else { b'L' };
            self.segment(command, &mut start)?;
            self.skip_separator();
        }
        if closed {
            let place = self.place(self.text.len());
            self.outline.close(place)?;
        }
        self.outline.end();
        Ok(())
    }

    /// The arguments of one command, as often as they are repeated.
    fn segments(&mut self, command: u8, start: &mut Option<Node>) -> Result<(), Flaw> {
        let mut command = command;
        loop {
            self.segment(command, start)?;
            // Further points behind a moveto are linetos.
            command = match command {
                b'M' => b'L',
                b'm' => b'l',
                other => other,
            };
            let comma = self.skip_separator();
            if !comma && !self.peek().is_some_and(|byte| byte.is_ascii_digit() || matches!(byte, b'.' | b'+' | b'-')) {
                return Ok(());
            }
        }
    }

    fn segment(&mut self, command: u8, start: &mut Option<Node>) -> Result<(), Flaw> {
        let relative = command.is_ascii_lowercase();
        self.skip_blanks();
        if self.peek() == Some(b',') {
            return Err(self.unexpected(self.at, format!("a number, an argument of {}", char::from(command))));
        }
        let begin = self.place(self.at);
        if !command.eq_ignore_ascii_case(&b'm') && self.outline.here().is_none() {
            // Behind a closed contour the next begins at the same point.
            if let Some(start) = start {
                self.outline.begin(start.clone());
            }
        }
        let mut handle = None;
        match command.to_ascii_uppercase() {
            b'M' => {
                let (point, place) = self.point(command)?;
                self.current = point.clone();
                let node = Node { point, index: 0, place, smooth: false };
                *start = Some(node.clone());
                self.outline.begin(node);
            }
            b'H' | b'V' => {
                let axis = usize::from(command.eq_ignore_ascii_case(&b'v'));
                let (value, at) = self.number(command)?;
                let mut point = self.current.clone();
                point[axis] = if relative { self.sum(&self.current[axis].clone(), &value, at)? } else { value };
                self.curve([], point, begin, begin)?;
            }
            b'C' => {
                let (first, _) = self.point(command)?;
                handle = Some(self.cubic(first, command, begin)?);
            }
            b'S' => {
                let first = self.reflected(3, self.at)?;
                handle = Some(self.cubic(first, command, begin)?);
            }
            b'Q' => {
                let (control, _) = self.point(command)?;
                handle = Some(self.quadratic(control, command, begin)?);
            }
            b'T' => {
                let control = self.reflected(2, self.at)?;
                handle = Some(self.quadratic(control, command, begin)?);
            }
            b'A' => self.arc(command, begin)?,
            _ => {
                let (point, place) = self.point(command)?;
                self.curve([], point, place, begin)?;
            }
        }
        self.handle = handle;
        Ok(())
    }

    fn cubic(&mut self, first: Point, command: u8, begin: Place) -> Result<Handle, Flaw> {
        let (second, _) = self.point(command)?;
        let (end, place) = self.point(command)?;
        self.curve([first, second.clone()], end, place, begin)?;
        Ok(Handle { degree: 3, point: second })
    }

    fn quadratic(&mut self, control: Point, command: u8, begin: Place) -> Result<Handle, Flaw> {
        let (end, place) = self.point(command)?;
        self.curve([control.clone()], end, place, begin)?;
        Ok(Handle { degree: 2, point: control })
    }

    /// An elliptical arc, which is passed over; one without radius is a line,
    /// and one that ends where it begins is nothing.
    fn arc(&mut self, command: u8, begin: Place) -> Result<(), Flaw> {
        let finest = self.decimals.finest();
        let radii = [self.number(command)?.0, self.number(command)?.0];
        self.number(command)?;
        self.decimals.restore(finest);
        self.flag()?;
        self.flag()?;
        let (end, place) = self.point(command)?;
        if end == self.current {
            return Ok(());
        }
        if radii.iter().any(num_traits::Zero::is_zero) {
            return self.curve([], end, place, begin);
        }
        let node = self.next_node(0, end.clone(), place);
        self.outline.gap(node, Omission { place: begin, what: "an arc is not a Bézier curve" });
        self.current = end;
        Ok(())
    }

    fn curve<const N: usize>(&mut self, controls: [Point; N], end: Point, place: Place, begin: Place) -> Result<(), Flaw> {
        let node = self.next_node(N, end.clone(), place);
        self.outline.curve(controls, node, begin)?;
        self.current = end;
        Ok(())
    }

    fn next_node(&self, controls: usize, point: Point, place: Place) -> Node {
        let index = self.outline.here().map_or(0, |here| here.index) + controls + 1;
        Node { point, index, place, smooth: false }
    }

    /// The last control point of a curve of this degree in the mirror of the
    /// current point; behind anything else, the current point.
    fn reflected(&mut self, degree: usize, at: usize) -> Result<Point, Flaw> {
        let Some(Handle { point, .. }) = self.handle.take().filter(|handle| handle.degree == degree) else {
            return Ok(self.current.clone());
        };
        let [x, y] = [0, 1].map(|axis| &self.current[axis] + (&self.current[axis] - &point[axis]));
        Ok([self.held(x, at)?, self.held(y, at)?])
    }

    /// A point of the plane and the place of its first coordinate.
    fn point(&mut self, command: u8) -> Result<(Point, Place), Flaw> {
        let (x, at) = self.number(command)?;
        let place = self.place(at);
        let (y, y_at) = self.number(command)?;
        if command.is_ascii_uppercase() {
            return Ok(([x, y], place));
        }
        let [from_x, from_y] = self.current.clone();
        Ok(([self.sum(&from_x, &x, at)?, self.sum(&from_y, &y, y_at)?], place))
    }

    fn sum(&mut self, from: &Rational, by: &Rational, at: usize) -> Result<Rational, Flaw> {
        self.held(from + by, at)
    }

    fn held(&mut self, number: Rational, at: usize) -> Result<Rational, Flaw> {
        match self.decimals.hold(&number) {
            Ok(()) => Ok(number),
            Err(_) => Err(Flaw::at(self.place(at), "the coordinates have too many digits")),
        }
    }

    /// A number and where it begins. The next may follow it without a blank:
    /// `.5.5`, `1-2`.
    fn number(&mut self, command: u8) -> Result<(Rational, usize), Flaw> {
        self.skip_separator();
        let bytes = self.text.as_bytes();
        let at = self.at;
        let digits = |from: usize| from + bytes[from.min(bytes.len())..].iter().take_while(|byte| byte.is_ascii_digit()).count();
        let mut end = at + usize::from(matches!(bytes.get(at), Some(b'+' | b'-')));
        end = digits(end);
        if bytes.get(end) == Some(&b'.') {
            end = digits(end + 1);
        }
        if let Some(b'e' | b'E') = bytes.get(end) {
            let sign = usize::from(matches!(bytes.get(end + 1), Some(b'+' | b'-')));
            let after = digits(end + 1 + sign);
            if after > end + 1 + sign {
                end = after;
            }
        }
        let letter = char::from(command);
        match read_scanned(self.decimals, &self.text[at..end]) {
            Ok(number) => {
                self.at = end;
                Ok((number, at))
            }
            Err(ParseNumberError::Malformed) => Err(self.unexpected(at, format!("a number, an argument of {letter}"))),
            Err(error) => Err(Flaw::at(self.place(at), format!("found {}: {error}", crate::model::shown(&self.text[at..end])))),
        }
    }

    /// A flag of an arc; the next number may be glued to it.
    fn flag(&mut self) -> Result<(), Flaw> {
        self.skip_separator();
        if !matches!(self.peek(), Some(b'0' | b'1')) {
            return Err(self.unexpected(self.at, "a flag of an arc, 0 or 1"));
        }
        self.at += 1;
        Ok(())
    }

    fn peek(&self) -> Option<u8> {
        self.text.as_bytes().get(self.at).copied()
    }

    fn skip_blanks(&mut self) {
        while matches!(self.peek(), Some(b' ' | b'\t' | b'\n' | b'\r' | b'\x0C')) {
            self.at += 1;
        }
    }

    /// Skips blanks with one comma among them; whether there was one.
    fn skip_separator(&mut self) -> bool {
        self.skip_blanks();
        let comma = self.peek() == Some(b',');
        if comma {
            self.at += 1;
            self.skip_blanks();
        }
        comma
    }

    fn place(&mut self, at: usize) -> Place {
        match self.base {
            Base::Verbatim(base) => self.places.of(base + at),
            Base::Decoded(place) => place,
        }
    }

    fn unexpected(&mut self, at: usize, expected: impl std::fmt::Display) -> Flaw {
        let rest = &self.text[at..];
        let place = self.place(at);
        match rest.split(|letter: char| letter.is_whitespace()).next() {
            None | Some("") => Flaw::at(place, format!("the data ends here, expected {expected}")),
            Some(word) => Flaw::expected(place, word, expected),
        }
    }
}

fn origin() -> Point {
    [0.into(), 0.into()]
}
