//! The names of a worksheet.

use std::cell::Cell;
use std::collections::{BTreeMap, BTreeSet, HashMap};

use super::quantity::{Degrees, Map, Quantity};
use crate::symbolic::{Polynomial, Symbol};
use crate::syntax::parser::Named;
use crate::syntax::{Span, SyntaxError};

/// A definition.
pub(super) struct Entry {
    pub(super) value: Quantity,
    /// Where the name stands in the file.
    pub(super) span: Span,
    pub(super) used: Cell<bool>,
}

/// A component that waits for the others of its map.
#[derive(Clone)]
pub(super) struct Component {
    pub(super) body: Polynomial,
    pub(super) variables: Vec<Symbol>,
    pub(super) span: Span,
}

/// A definition further down: where it stands, and the letters in its body.
pub(super) struct Later {
    pub(super) line: usize,
    /// Whether it was tried already and is in error.
    pub(super) failed: bool,
    pub(super) letters: BTreeSet<Symbol>,
}

/// The names that are defined, and those that will be.
#[derive(Default)]
pub(super) struct Scope {
    entries: HashMap<Symbol, Entry>,
    /// Components by the letter of their map, until it is first used.
    components: HashMap<char, BTreeMap<u32, Component>>,
    /// All names that the worksheet defines, by what a scan of its lines shows.
    pub(super) later: HashMap<Symbol, Later>,
}

/// What a name in call position is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Callee {
    /// The name of the map or net.
    pub(super) base: Symbol,
    /// The component, counted from 1.
    pub(super) component: Option<u32>,
    pub(super) named: Named,
}

impl Scope {
    pub(super) fn get(&self, symbol: Symbol) -> Option<&Entry> {
        self.entries.get(&symbol)
    }

    /// The value of a name, which counts as a use of it.
    pub(super) fn value(&self, symbol: Symbol) -> Option<&Quantity> {
        let entry = self.entries.get(&symbol)?;
        entry.used.set(true);
        Some(&entry.value)
    }

    pub(super) fn insert(&mut self, symbol: Symbol, value: Quantity, span: Span) {
        self.entries.insert(symbol, Entry { value, span, used: Cell::new(false) });
    }

    pub(super) fn insert_component(&mut self, letter: char, index: u32, component: Component) {
        self.components.entry(letter).or_default().insert(index, component);
    }

    /// The component with a name, while its map is not complete.
    pub(super) fn component(&self, letter: char, index: u32) -> Option<&Component> {
        self.components.get(&letter)?.get(&index)
    }

    /// The place of a name that is in use already.
    pub(super) fn place_of(&self, symbol: Symbol) -> Option<Span> {
        let base = Symbol::new(symbol.letter(), None);
        let in_map = symbol.index().and_then(|index| {
            let entry = self.entries.get(&base)?;
            (index >= 1 && index as usize <= dimension(&entry.value)).then_some(entry.span)
        });
        let waiting = match symbol.index() {
            Some(index) => self.component(symbol.letter(), index).map(|component| component.span),
            None => self.components.get(&symbol.letter()).and_then(|list| list.values().next()).map(|component| component.span),
        };
        self.entries.get(&symbol).map(|entry| entry.span).or(in_map).or(waiting)
    }

    /// Definitions that nothing used, in the order of the file.
    pub(super) fn unused(&self) -> Vec<(Symbol, Span)> {
        let entries = self.entries.iter().filter(|(_, entry)| !entry.used.get()).map(|(symbol, entry)| (*symbol, entry.span));
        let waiting = self
            .components
            .iter()
            .filter_map(|(letter, list)| list.first_key_value().map(|(_, component)| (Symbol::new(*letter, None), component.span)));
        let mut unused: Vec<(Symbol, Span)> = entries.chain(waiting).collect();
        unused.sort_by_key(|(_, span)| *span);
        unused
    }

    /// What a letter in front of a bracket stands for. With several arguments
    /// it cannot be a product, and may be a name that is defined too late.
    pub(super) fn callee(&self, symbol: Symbol, several: bool) -> Option<Callee> {
        let lower = symbol.letter().is_lowercase();
        let letter = if lower { capital(symbol.letter())? } else { symbol.letter() };
        let named = if lower { Named::PolarForm } else { Named::Map };
        // Maps of formulas may have small letters: x(t) = …
        if lower && self.entries.get(&symbol).is_some_and(|entry| is_callable(&entry.value)) {
            return Some(Callee { base: symbol, component: None, named: Named::Map });
        }
        let own = symbol.index().map_or_else(|| Symbol::new(letter, None), |index| Symbol::new(letter, Some(index)));
        let whole = Callee { base: own, component: None, named };
        if let Some(entry) = self.entries.get(&own) {
            return is_callable(&entry.value).then_some(whole);
        }
        let base = Symbol::new(letter, None);
        let part = |index| Callee { base, component: Some(index), named };
        match (own.index(), self.entries.get(&base), self.components.get(&letter)) {
            (Some(index), Some(entry), _) if is_callable(&entry.value) && index >= 1 && index as usize <= dimension(&entry.value) => {
                Some(part(index))
            }
            (Some(index), None, Some(list)) if list.contains_key(&index) => Some(part(index)),
            (None, None, Some(_)) => Some(whole),
            // What is defined further down, for an error that says so.
            _ => (several && own.letter().is_uppercase() && self.later.contains_key(&own)).then_some(whole),
        }
    }

    /// Makes maps of the components whose map is needed now.
    pub(super) fn complete(&mut self, letter: char) -> Result<(), SyntaxError> {
        let Some(list) = self.components.remove(&letter) else { return Ok(()) };
        let span = list.values().map(|component| component.span).next().unwrap_or_default();
        for (wanted, (index, component)) in (1u32..).zip(&list) {
            if *index != wanted {
                let message = format!(
                    "found a definition of `{letter}_{index}` but none of `{letter}_{wanted}`, expected components numbered from 1 without a gap"
                );
                return Err(SyntaxError::new(component.span, message));
            }
        }
        let variables = list.values().next().map(|component| component.variables.clone()).unwrap_or_default();
        let components = list.into_values().map(|component| component.body).collect();
        let map = Map { components, variables, degrees: Degrees::default(), weight: None };
        self.insert(Symbol::new(letter, None), Quantity::Map(map), span);
        Ok(())
    }

    /// Whether components of a map with this letter wait for others.
    pub(super) fn is_waiting(&self, letter: char) -> bool {
        self.components.contains_key(&letter)
    }

    /// The way from one name over the definitions that use each other back to it, by way of another name.
    pub(super) fn cycle(&self, start: Symbol, by: Symbol) -> Option<Vec<Symbol>> {
        if start == by {
            return Some(vec![start, start]);
        }
        // Depth first, with the way that led here.
        let mut way = vec![start, by];
        let mut seen = BTreeSet::from([by]);
        let mut ahead: Vec<Vec<Symbol>> = vec![Vec::new(), self.named_in(by)];
        const FAR: usize = 1000;
        while let Some(next) = ahead.last_mut().filter(|_| seen.len() < FAR) {
            match next.pop() {
                None => {
                    ahead.pop();
                    way.pop();
                }
                Some(symbol) if symbol == start => {
                    way.push(start);
                    return Some(way);
                }
                Some(symbol) => {
                    if seen.insert(symbol) {
                        way.push(symbol);
                        ahead.push(self.named_in(symbol));
                    }
                }
            }
        }
        None
    }

    /// The names in the body of a definition that has not been made yet.
    fn named_in(&self, symbol: Symbol) -> Vec<Symbol> {
        let Some(later) = self.later.get(&symbol) else { return Vec::new() };
        let names = later.letters.iter().rev().filter_map(|letter| {
            let upper = capital(letter.letter()).map(|upper| Symbol::new(upper, letter.index()));
            [Some(*letter), upper].into_iter().flatten().find(|name| self.later.contains_key(name))
        });
        names.collect()
    }
}

/// The capital of a letter, if it is one letter.
fn capital(letter: char) -> Option<char> {
    let mut upper = letter.to_uppercase();
    upper.next().filter(|_| upper.next().is_none())
}

fn is_callable(value: &Quantity) -> bool {
    matches!(value, Quantity::Map(_) | Quantity::Net(_))
}

/// The number of coordinates of a map or net, weights left out.
pub(super) fn dimension(value: &Quantity) -> usize {
    match value {
        Quantity::Map(map) => map.components.len(),
        Quantity::Net(net) => net.piece.dimension() - usize::from(net.weighted),
        _ => 0,
    }
}
