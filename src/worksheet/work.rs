//! Worked solutions, as worksheets: every formula in them is a claim that
//! `verify` proves.

mod form;

use std::fmt::Write as _;

use num_traits::{One, Zero};

use crate::affine::{Frame, Rectangle, Triangle};
use crate::blossom::PolarForm;
use crate::curve::Curve;
use crate::error::Error;
use crate::kernel::coefficient::Coefficient;
use crate::kernel::layout::multinomials;
use crate::reading::Reading;
use crate::surface::Surface;
use crate::symbolic::{Polynomial, Symbol};
use crate::syntax::{MapInput, Style, Variables, printer};
use form::{Names, Vertex};

/// The largest polar degree of a worked solution.
pub const MAX_WORK_DEGREE: usize = 8;

/// What a worked solution is about.
#[derive(Clone, Debug)]
pub struct Task {
    /// The map.
    pub map: MapInput,
    /// The polar degree, if it is to be higher than the degree.
    pub degree: Option<usize>,
    /// The bidegree, if a surface is read variable by variable.
    pub bidegree: Option<(usize, usize)>,
    /// The frame of the control points; without it the worked solution ends with the polar form.
    pub frame: Option<Frame<Polynomial>>,
    /// The parameter of de Casteljau's algorithm: one number, or two.
    pub at: Option<Vec<Polynomial>>,
}

/// The worked solution of a task, in Markdown with formulas in LaTeX.
///
/// ```
/// use casteljau::{syntax, worksheet};
/// let task = worksheet::Task { map: syntax::parse_map("(t, t^2)", None)?, degree: None, bidegree: None, frame: None, at: None };
/// let text = worksheet::work(&task)?;
/// assert!(worksheet::check(&text, worksheet::Format::Markdown).holds());
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
/// [`Error::TooLarge`] above [`MAX_WORK_DEGREE`]; what making the shape and its control points says.
pub fn work(task: &Task) -> Result<String, Error> {
    let Page { title, sections } = page(task, None)?;
    Ok(format!("# {title}\n\n{sections}"))
}

/// A worked solution without its heading.
pub(super) struct Page {
    pub(super) title: String,
    pub(super) sections: String,
}

/// The worked solution, its names with an index if there is one.
pub(super) fn page(task: &Task, number: Option<u16>) -> Result<Page, Error> {
    let (form, raised) = polar_form(task)?;
    let reading = form.reading();
    let degree: usize = reading.groups().iter().map(|group| group.0).sum();
    if degree > MAX_WORK_DEGREE {
        return Err(Error::TooLarge { what: "polar degree of a worked solution", limit: MAX_WORK_DEGREE });
    }
    let names = Names::of(task, reading, number);
    let kind = match reading {
        Reading::Curve(_) => "A polynomial curve",
        Reading::Total(_) => "A polynomial surface, by its total degree",
        Reading::Bidegree(..) => "A polynomial surface, by its bidegree",
    };
    let mut text = String::new();
    definition(task, raised, &names, &mut text);
    powers(task, reading, &names, &mut text);
    names.polar_form(&form, &mut text);
    if let Some(frame) = &task.frame {
        let groups = groups(frame)?;
        if groups.len() != reading.groups().len() || groups[0].len() != reading.groups()[0].1 + 1 {
            return Err(Error::WrongShape(format!("the frame {frame} does not fit the polar form")));
        }
        names.frame(&groups, &mut text);
        names.control_points(&form, &groups, &mut text)?;
        if let Some(at) = &task.at {
            scheme(&form, &names, &groups, at, &mut text)?;
        }
    }
    Ok(Page { title: kind.to_owned(), sections: text })
}

/// The polar form, and whether its degree is more than that of the map.
fn polar_form(task: &Task) -> Result<(PolarForm<Polynomial>, bool), Error> {
    let components = &task.map.components;
    match (task.map.variables, &task.frame, task.bidegree) {
        (Variables::Curve(variable), None | Some(Frame::Interval(_)), None) => {
            let curve = Curve::new(components.iter().map(|component| component.coefficients_in(variable)).collect())?;
            let own = curve.degree();
            let degree = task.degree.unwrap_or(own);
            Ok((curve.with_degree(degree)?.polar(), degree > own))
        }
        (Variables::Surface(first, second), frame, bidegree) => {
            let terms = |component: &Polynomial| {
                let rows = component.coefficients_in(first).into_iter().enumerate();
                rows.flat_map(|(h, row)| row.coefficients_in(second).into_iter().enumerate().map(move |(k, c)| (h, k, c))).collect()
            };
            let lists = components.iter().map(terms).collect();
            if bidegree.is_some() || matches!(frame, Some(Frame::Rectangle(_))) {
                let surface = Surface::tensor(lists)?;
                let own = surface.reading();
                let surface = match bidegree {
                    Some((p, q)) => surface.read_as(Reading::Bidegree(p, q))?,
                    None => surface,
                };
                return Ok((surface.polar(), surface.reading() != own));
            }
            let surface = Surface::total(lists)?;
            let own = surface.reading();
            let surface = match task.degree {
                Some(degree) => surface.read_as(Reading::Total(degree))?,
                None => surface,
            };
            Ok((surface.polar(), surface.reading() != own))
        }
        _ => Err(Error::WrongShape("the frame is none of a curve: an interval r..s is".into())),
    }
}

/// The map as a definition.
fn definition(task: &Task, raised: bool, names: &Names, text: &mut String) {
    let (plain, latex) = (names.indexed('F', Style::Text), names.indexed('F', Style::Latex));
    let letters: Vec<Symbol> = task.map.variables.symbols();
    let list = |style| letters.iter().map(|letter| printer::symbol(*letter, style)).collect::<Vec<_>>().join(",");
    let components =
        |style| -> Vec<String> { task.map.components.iter().map(|component| printer::polynomial(component, &letters, style)).collect() };
    let body = |style| match components(style).as_slice() {
        [only] => only.clone(),
        several => printer::point(several, style),
    };
    // Writing to a string does not fail.
    let _ = match (raised, task.bidegree, task.degree) {
        (true, Some((p, q)), _) => {
            writeln!(text, "```casteljau\n{plain}({}) = {} bidegree {p},{q}\n```\n", list(Style::Text), body(Style::Text))
        }
        (true, None, Some(degree)) => {
            writeln!(text, "```casteljau\n{plain}({}) = {} degree {degree}\n```\n", list(Style::Text), body(Style::Text))
        }
        _ => writeln!(text, "<!-- casteljau -->\n$${latex}({}) = {}$$\n", list(Style::Latex), body(Style::Latex)),
    };
}

/// What the powers of the variables become.
fn powers(task: &Task, reading: Reading, names: &Names, text: &mut String) {
    text.push_str("## The polar form\n\n");
    let _ = writeln!(
        text,
        "{}\n",
        match reading {
            Reading::Curve(m) => format!(
                "Every coordinate gets a symmetric function of {m} arguments that is affine in each. The power t^k becomes the average of \
             the products of k different arguments, σ_k divided by their number C({m},k):"
            ),
            Reading::Total(m) => format!(
                "Every coordinate gets a symmetric function of {m} points that is affine in each. The product u^h v^k becomes the average of \
             the products of h letters u and k letters v of different points; there are {m}!/(h! k! ({m}-h-k)!) of them:"
            ),
            Reading::Bidegree(p, q) => format!(
                "Every coordinate gets a function of {p} arguments for the first variable and {q} for the second, symmetric in each group and \
             affine in each argument. The product u^h v^k becomes the average of the products of h and k arguments; there are \
             C({p},h) C({q},k) of them:"
            ),
        }
    );
    let counts = multinomials::<crate::exact::Rational>(&reading.shape(1));
    let mut lines = String::new();
    let mut number = 0;
    for (exponents, count) in reading.exponents().into_iter().zip(counts) {
        let place = super::slip::of_variables(reading, &exponents);
        let letters = task.map.variables.symbols();
        let occurs = task.map.components.iter().any(|component| {
            component.terms().any(|(monomial, _)| {
                let exponent = |index: usize| letters.get(index).map_or(0, |letter| monomial.degree_in(*letter) as usize);
                (exponent(0), exponent(1)) == place
            })
        });
        if !occurs || place == (0, 0) {
            continue;
        }
        number += 1;
        names.power(reading, &exponents, place, number, &count.to_string(), &mut lines);
    }
    if !lines.is_empty() {
        let _ = writeln!(text, "```casteljau\n{lines}```\n");
    }
}

/// The vertices of a frame, group by group.
fn groups(frame: &Frame<Polynomial>) -> Result<Vec<Vec<Vertex>>, Error> {
    let number = |name: &str, value: &Polynomial| Vertex { name: name.to_owned(), coordinates: vec![value.clone()] };
    Ok(match frame {
        Frame::Interval(frame) => vec![vec![number("r", frame.r()), number("s", frame.s())]],
        Frame::Triangle(frame) => {
            let vertices: &[[Polynomial; 2]; 3] = Triangle::vertices(frame);
            let vertex = |(name, place): (&str, &[Polynomial; 2])| Vertex { name: name.to_owned(), coordinates: place.to_vec() };
            vec![["r", "s", "t"].into_iter().zip(vertices).map(vertex).collect()]
        }
        Frame::Rectangle(frame) => {
            let (u, v) = (Rectangle::u(frame), Rectangle::v(frame));
            vec![vec![number("r_1", u.r()), number("s_1", u.s())], vec![number("r_2", v.r()), number("s_2", v.s())]]
        }
    })
}

/// De Casteljau's algorithm, one argument after the other.
fn scheme(form: &PolarForm<Polynomial>, names: &Names, groups: &[Vec<Vertex>], at: &[Polynomial], text: &mut String) -> Result<(), Error> {
    let expected: usize = if matches!(form.reading(), Reading::Curve(_)) { 1 } else { 2 };
    if at.len() != expected {
        return Err(Error::WrongCount { what: "parameters", expected, found: at.len() });
    }
    let places: Vec<Vec<Polynomial>> = match groups.len() {
        1 => vec![at.to_vec()],
        _ => at.iter().map(|value| vec![value.clone()]).collect(),
    };
    let weights = groups.iter().zip(&places).map(|(vertices, place)| barycentric(vertices, place)).collect::<Result<Vec<_>, _>>()?;
    text.push_str("## De Casteljau's algorithm\n\n");
    names.scheme(form, groups, &places, &weights, text)
}

/// The weights of the vertices whose combination is a place.
fn barycentric(vertices: &[Vertex], place: &[Polynomial]) -> Result<Vec<Polynomial>, Error> {
    let one = Polynomial::one();
    match (vertices, place) {
        ([r, s], [t]) => {
            let length = &s.coordinates[0] - &r.coordinates[0];
            let part =
                (t - &r.coordinates[0]).over(&length).ok_or_else(|| Error::Unsupported(format!("dividing by {length} needs a number")))?;
            Ok(vec![&one - &part, part])
        }
        ([r, s, t], [u, v]) => {
            let pair = |vertex: &Vertex| [vertex.coordinates[0].clone(), vertex.coordinates[1].clone()];
            Ok(Triangle::new(pair(r), pair(s), pair(t))?.barycentric(&[u.clone(), v.clone()])?.to_vec())
        }
        _ => Err(Error::WrongCount { what: "parameters", expected: vertices.len() - 1, found: place.len() }),
    }
}

/// Whether anything of a polynomial is left.
fn is_zero(value: &Polynomial) -> bool {
    value.is_zero()
}
