//! Symbols that mean two things.

use super::diagnostic::Problem;
use super::read::Reader;
use crate::reading::Reading;
use crate::symbolic::{Polynomial, Symbol};
use crate::value::{Domain, Value};

impl Reader<'_> {
    /// Refuses symbols that would be taken for a parameter of the map, or for an
    /// argument of its polar form, in what is printed.
    pub(super) fn refuse_clashes(&self) -> Result<(), Problem> {
        let (parameters, kind): (Vec<Symbol>, &str) = match self.domain {
            Domain::Curve => (vec![self.arguments.variable()], "curve"),
            _ => (self.arguments.variables().to_vec(), "surface"),
        };
        let mut symbols: Vec<Symbol> = Vec::new();
        for (_, value) in self.arguments.iter() {
            match value {
                Value::Curve(curve) => {
                    symbols.extend((0..curve.dimension()).flat_map(|index| curve.coordinate(index)).flat_map(Polynomial::symbols));
                }
                Value::Surface(surface) => symbols.extend(surface.coefficients().iter().flat_map(Polynomial::symbols)),
                Value::Points(points) => symbols.extend(points.iter().flatten().flat_map(Polynomial::symbols)),
                Value::Rows(rows) => symbols.extend(rows.iter().flatten().flatten().flat_map(Polynomial::symbols)),
                Value::Map(map) => symbols.extend(map.numbers().flat_map(Polynomial::symbols)),
                _ => {}
            }
        }
        if let Some(variable) = parameters.iter().find(|variable| symbols.contains(variable)) {
            let equation = self.operation.parameter("curve").is_some() || self.operation.parameter("surface").is_some();
            let help = if equation {
                "use another letter for one of them; --vars says what the parameter is called".to_owned()
            } else {
                format!("`{}` takes control points; `casteljau points` turns an equation into some", self.operation.verb)
            };
            return Err(Problem::plain(format!("the symbol `{variable}` is also the parameter of the {kind}")).with_help(help));
        }
        let weights = |symbol: &&Symbol| matches!((symbol.letter(), symbol.index()), ('a' | 'b' | 'c' | 'u' | 'v', None));
        if let Some(letter) = symbols.iter().find(weights).filter(|_| self.operation.verb == "homogenize") {
            return Err(Problem::plain(format!("the symbol `{letter}` is also a letter of the homogenized polynomials"))
                .with_help("these are a, b, c, u and v; use another letter for it"));
        }
        if self.operation.verb != "polar" {
            return Ok(());
        }
        let reading = match self.domain {
            Domain::Curve => Reading::Curve(self.arguments.curve()?.degree()),
            _ => self.arguments.surface()?.reading(),
        };
        // Any index: more arguments than there are would look like one.
        let weights = self.arguments.flag("homogeneous");
        let letters: Vec<char> = match reading {
            Reading::Curve(_) => vec!['t'],
            Reading::Total(_) => ['U', 'V', 'C'].into_iter().take(if weights { 3 } else { 2 }).collect(),
            Reading::Bidegree(..) => ['u', 'v', 'a', 'b'].into_iter().take(if weights { 4 } else { 2 }).collect(),
        };
        if let Some(argument) = symbols.iter().find(|symbol| letters.contains(&symbol.letter()) && symbol.index().is_some()) {
            return Err(Problem::plain(format!("the symbol `{argument}` is also an argument of the polar form"))
                .with_help("use another letter for it"));
        }
        // A claim is about the arguments and the parameters of the map; anything else cannot be decided.
        let known: Vec<Symbol> = reading.symbols().collect();
        let mut claimed = self.arguments.expressions("claim").ok().into_iter().flatten().flat_map(Polynomial::symbols);
        if let Some(foreign) = claimed.find(|symbol| !symbols.contains(symbol) && !known.contains(symbol)) {
            return Err(Problem::plain(format!(
                "the claim contains `{foreign}`, which is neither an argument of the polar form nor a parameter of the {kind}"
            ))
            .with_help(match (known.first(), known.last()) {
                (Some(first), Some(last)) => format!("its arguments are {first} to {last}"),
                _ => format!("a {kind} of polar degree 0 has no arguments"),
            }));
        }
        Ok(())
    }
}
