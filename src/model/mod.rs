//! Shapes in files and requests, exactly as they are written: numbers are read
//! digit by digit and never seen as floats.

mod bezierview;
mod bpt;
mod decimals;
mod format;
mod glif;
mod json;
mod newell;
mod outline;
mod place;
mod scanner;
mod shape;
mod splines;
mod svg;
mod wavefront;
mod writer;
mod xml;

use crate::affine::Rectangle;
use crate::control::ControlNet;
use crate::exact::Rational;
use crate::kernel::shape::Shape;
use crate::piece::Piece;
use crate::rectangular::RectangularPatch;

pub use decimals::Decimals;
pub use format::Format;
pub use json::{Fault, Fields, number, numbers, points, rows};
pub(crate) use json::{count, depth, excerpt, list, plain, without_place};
pub(crate) use place::shown;
pub use place::{Flaw, Place, Places};
pub use shape::{ShapeFile, read_shape};
pub(crate) use shape::{frame, place, weights};
pub use writer::shape_text;

/// The pieces of a file, and how they hang together.
#[derive(Clone, Debug)]
pub struct Model {
    /// The format it was read as.
    pub format: Format,
    /// The pieces, in the order of the file.
    pub parts: Vec<Part>,
    /// The joints that the file itself states: where one curve goes on as
    /// another in an outline or a spline. In the order of the file.
    pub joints: Vec<Follow>,
    /// Whether pieces that no stated joint connects can meet all the same:
    /// patches and separate curves do, contours of an outline do not.
    pub meets_by_position: bool,
    /// The most digits behind the dot of any coordinate: the last printed digit
    /// is worth `10^-decimals`. Fractions such as `1/3` are exact and do not count.
    pub decimals: u32,
    /// What was passed over, such as arcs.
    pub omissions: Vec<Omission>,
}

/// A piece of a model.
#[derive(Clone, Debug)]
pub struct Part {
    /// The piece; its points have the weight as an additional last coordinate if
    /// it is rational.
    pub piece: Piece,
    /// Whether it is rational.
    pub rational: bool,
    /// Whether the file says what its frame is.
    pub has_frame: bool,
    /// Its name, if it has one.
    pub name: Option<String>,
    /// Where it begins in the file.
    pub place: Place,
}

/// A joint that a file states: the end of one curve is the start of another.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Follow {
    /// The index of the part that ends here.
    pub first: usize,
    /// The index of the part that starts here.
    pub second: usize,
    /// The index of the contour (of the spline) in the file.
    pub contour: usize,
    /// The index of the point among all points of its contour, control points
    /// included; of a spline, of the knot among its distinct inner knots.
    pub node: usize,
    /// Where the point is in the file.
    pub place: Place,
    /// Whether the file promises that the joint is smooth.
    pub smooth: bool,
}

/// Something in a file that holds no piece.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Omission {
    /// Where it begins.
    pub place: Place,
    /// What it is and why it is passed over: "an arc is not a Bézier curve".
    pub what: &'static str,
}

/// Reads a file.
///
/// # Errors
/// What was found and what was expected, with the place: the file is not of
/// this format, ends too early, goes on too long, or is beyond a limit.
pub fn read(text: &str, format: Format) -> Result<Model, Flaw> {
    let text = text.strip_prefix('\u{feff}').unwrap_or(text);
    match format {
        Format::Newell => newell::read(text),
        Format::Svg => svg::read(text),
        Format::Glif => glif::read(text),
        Format::Shape => shape::read(text),
        Format::Bpt => bpt::read(text),
        Format::BezierView => bezierview::read(text),
        Format::Wavefront => wavefront::read(text),
    }
}

impl Model {
    /// Patches that meet where their edges do.
    fn of_patches(format: Format, parts: Vec<Part>, decimals: u32) -> Self {
        Self { format, parts, joints: Vec::new(), meets_by_position: true, decimals, omissions: Vec::new() }
    }
}

/// The name of a group, which each of its pieces has: so it is shortened.
fn group_name(name: &str) -> Option<String> {
    const LENGTH: usize = 200;
    let name = name.trim();
    (!name.is_empty()).then(|| name.chars().filter(|letter| !letter.is_control()).take(LENGTH).collect())
}

impl Follow {
    /// The joints of the pieces of one spline, which are these parts.
    fn chain(parts: std::ops::Range<usize>, contour: usize, place: Place) -> impl Iterator<Item = Self> {
        let ends = parts.clone().zip(parts.skip(1)).enumerate();
        ends.map(move |(node, (first, second))| Self { first, second, contour, node, place, smooth: false })
    }
}

impl Part {
    /// The most pieces of one file.
    pub const MAX_COUNT: usize = 1 << 22;

    /// Adds the piece to those of its file.
    fn add_to(self, parts: &mut Vec<Self>) -> Result<(), Flaw> {
        if parts.len() >= Self::MAX_COUNT {
            return Err(Flaw::at(self.place, format!("found more pieces than a file may have, at most {}", Self::MAX_COUNT)));
        }
        parts.push(self);
        Ok(())
    }

    /// A polynomial patch over the unit square, with its coordinates point by point.
    fn patch((p, q): (usize, usize), dimension: usize, coordinates: Vec<Rational>, place: Place) -> Self {
        let net = ControlNet { shape: Shape::rectangle(p, q, dimension), coordinates };
        let piece = Piece::Rectangle(RectangularPatch::from_net(net, Rectangle::unit()));
        Self { piece, rational: false, has_frame: false, name: None, place }
    }
}
