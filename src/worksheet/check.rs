//! Checking a worksheet: statement by statement, every claim decided.

use std::collections::BTreeSet;
use std::ops::Range;

use super::claim::{Claim, Verdict};
use super::decision::{Decision, decide, picture_of};
use super::definition::{self, Made};
use super::document::{Block, Document, Format, head, statements};
use super::function;
use super::quantity::Quantity;
use super::report::{Outcome, Picture, Rendered, Report, Warning};
use super::scope::{Component, Later, Scope};
use super::size::{Ledger, MAX_WORKSHEET_WORK};
use super::suggest::{misspelt_call, suggested};
use super::typeset;
use crate::symbolic::Symbol;
use crate::syntax::expression::{Callee, Expression, ExpressionKind};
use crate::syntax::parser::{Named, Parser, Vocabulary};
use crate::syntax::statement::{self, MapDefinition, Statement};
use crate::syntax::{Lines, Span, SyntaxError};

/// Checks a worksheet.
///
/// ```
/// use casteljau::worksheet::{self, Format, Verdict};
/// let report = worksheet::check("F(t) = (t, t^2)\nf(1,3) == (2, 3)\nf(1,3) == (2, 4)", Format::Statements);
/// let verdicts: Vec<Verdict> = report.claims.iter().map(|claim| claim.verdict).collect();
/// assert_eq!(verdicts, [Verdict::Proved, Verdict::Refuted]);
/// ```
#[must_use]
pub fn check(source: &str, format: Format) -> Report {
    checked(source, format, false)
}

/// The same, with all that a page shows.
pub(super) fn check_for_rendering(source: &str, format: Format) -> Report {
    checked(source, format, true)
}

fn checked(source: &str, format: Format, renders: bool) -> Report {
    let document = Document::new(source, format);
    let mut checker = Checker {
        scope: Scope::default(),
        report: Report::default(),
        lines: Lines::new(source),
        diagnoses: 0,
        ledger: Ledger::default(),
        is_over: false,
        renders,
    };
    checker.report.errors = document.errors;
    checker.report.warnings = document.warnings.into_iter().map(|error| Warning { code: "W103", error }).collect();
    let parts: Vec<(String, Vec<Range<usize>>)> = document
        .blocks
        .iter()
        .map(|block| {
            let whole = || std::iter::once(0..block.text.len()).collect();
            if block.is_formula { (block.text.clone(), whole()) } else { statements(&block.text) }
        })
        .collect();
    for (block, (text, ranges)) in document.blocks.iter().zip(&parts) {
        for range in ranges {
            checker.announce(block, text, range);
        }
    }
    for (block, (text, ranges)) in document.blocks.iter().zip(&parts) {
        for range in ranges {
            if checker.report.errors.len() + checker.diagnoses > MAX_PROBLEMS {
                let start = block.in_file(Span::new(range.start, range.start + 1));
                let message = format!("found more than {MAX_PROBLEMS} statements that fail above, and nothing is read from here on");
                checker.report.errors.push(SyntaxError::new(start, message));
                return checker.finish();
            }
            checker.part(block, text, range.clone());
            if checker.is_over {
                return checker.finish();
            }
        }
    }
    checker.finish()
}

/// After so many statements that fail, the rest of a worksheet is not read; after so many warnings, no more are listed.
const MAX_PROBLEMS: usize = 2000;

/// The most failed claims of a worksheet that are explained: of more, the first ones say enough.
const MAX_DIAGNOSES: usize = 64;

struct Checker<'s> {
    scope: Scope,
    report: Report,
    lines: Lines<'s>,
    /// How many failed claims there were.
    diagnoses: usize,
    /// What the statements above have used.
    ledger: Ledger,
    /// Whether they have used up what there is, and an error says so.
    is_over: bool,
    /// Whether the worksheet is rendered too.
    renders: bool,
}

/// A part of a block, and how places in it are places in the file.
struct Part<'b> {
    block: &'b Block,
    text: &'b str,
    offset: usize,
}

impl Part<'_> {
    fn span(&self, span: Span) -> Span {
        self.block.in_file(Span::new(span.start + self.offset, span.end + self.offset))
    }

    fn error(&self, error: SyntaxError) -> SyntaxError {
        SyntaxError { span: self.span(error.span), ..error }
    }
}

impl Checker<'_> {
    /// Notes the names that a part will define, for errors about using them too early.
    fn announce(&mut self, block: &Block, text: &str, range: &Range<usize>) {
        let mut lines: Vec<(usize, &str)> = Vec::new();
        if block.is_formula {
            let mut at = range.start;
            for piece in text[range.clone()].split("\\\\").flat_map(|piece| piece.split("\\qquad")) {
                lines.push((at, piece));
                at += piece.len();
            }
        } else {
            lines.push((range.start, &text[range.clone()]));
        }
        for (at, line) in lines {
            let Some((name, body)) = head(line.trim_start()) else { continue };
            let letters = letters_of(body);
            let at = at + (line.len() - line.trim_start().len());
            let line = self.lines.line(block.in_file(Span::new(at, at)).start);
            let mut announce = |name: Symbol| {
                self.scope.later.entry(name).or_insert_with(|| Later { line, failed: false, letters: letters.clone() });
            };
            announce(name);
            // A component announces its map.
            if name.index().is_some() && name.letter().is_uppercase() {
                announce(Symbol::new(name.letter(), None));
            }
        }
    }

    /// Reads and checks the statements of a part.
    fn part(&mut self, block: &Block, text: &str, range: Range<usize>) {
        let (name, skipped) = if block.is_formula { (None, 0) } else { claim_name(&text[range.clone()]) };
        let name_span = name.map(|name| block.in_file(Span::new(range.start, range.start + name.len())));
        let part = Part { block, text: &text[range.start + skipped..range.end], offset: range.start + skipped };
        let checked = misspelt_call(part.text).and_then(|()| self.statements(&part, name, name_span));
        if let Err(error) = checked {
            let line = self.lines.line(part.span(Span::new(0, 0)).start);
            let own = head(part.text).and_then(|(name, _)| self.scope.later.get_mut(&name)).filter(|later| later.line == line);
            if let Some(later) = own {
                later.failed = true;
            }
            self.fail(&part, name, part.error(suggested(error, part.text)));
        }
    }

    /// An error in the place of a claim if the text is one, else by itself.
    fn fail(&mut self, part: &Part<'_>, name: Option<&str>, error: SyntaxError) {
        let is_claim = ["==", "!=", "<", ">"].iter().any(|sign| part.text.contains(sign)) && head(part.text).is_none();
        if !is_claim {
            self.render(error.span, Outcome::Error(self.report.errors.len()), Vec::new(), None);
            self.report.errors.push(error);
            return;
        }
        let start = part.text.len() - part.text.trim_start().len();
        let span = part.span(Span::new(start, start + part.text.trim().len()));
        let position = self.lines.position(span.start);
        let mut claim = Claim::new(position, span, name);
        claim.verdict = Verdict::Error;
        claim.error = Some(error);
        self.diagnoses += 1;
        self.render(span, Outcome::Claim(self.report.claims.len()), Vec::new(), None);
        self.report.claims.push(claim);
    }

    fn statements(&mut self, part: &Part<'_>, name: Option<&str>, name_span: Option<Span>) -> Result<(), SyntaxError> {
        let formula = part.block.is_formula;
        let mut at = 0;
        // A definition changes what letters mean, so that every statement has a parser of its own.
        loop {
            let rest = &part.text[at..];
            let sub = Part { block: part.block, text: rest, offset: part.offset + at };
            let shift = |error: SyntaxError| SyntaxError { span: Span::new(error.span.start + at, error.span.end + at), ..error };
            let scope = &self.scope;
            let callee = |symbol: Symbol, several: bool| scope.callee(symbol, several).map(|callee| callee.named);
            let vocabulary = Vocabulary { word: function::known_word, callee: &callee };
            let mut parser = Parser::of_worksheet(rest, formula, vocabulary).map_err(shift)?;
            let is_defined = |symbol: Symbol| scope.place_of(symbol).is_some() || callee_is_made(scope, symbol);
            let statement = parser.statement(formula, &is_defined).map_err(shift)?;
            let consumed = parser.token(0).span.start;
            let is_last = parser.at_end();
            if statement.is_some() && self.ledger.is_spent() {
                self.is_over = true;
                let message = format!(
                    "found statements above that take more than {MAX_WORKSHEET_WORK} steps together, and nothing is read from here on"
                );
                return Err(shift(SyntaxError::new(Span::new(0, consumed), message).with_help("split the worksheet")));
            }
            match statement {
                None => return Ok(()),
                Some(statement) if !waiting_letters(&self.scope, &bodies(&statement)).is_empty() => {
                    // The first use of a map completes it; then the statement is read again.
                    for letter in waiting_letters(&self.scope, &bodies(&statement)) {
                        if let Err(error) = self.scope.complete(letter) {
                            self.report.errors.push(error);
                            return Ok(());
                        }
                    }
                    continue;
                }
                Some(Statement::Definition(definition)) => {
                    if let Some(name) = name {
                        let message = format!("found the name `{name}` before a definition, expected one before a claim");
                        self.report.errors.push(SyntaxError::new(name_span.unwrap_or_default(), message));
                        return Ok(());
                    }
                    let values = definition::made(&self.scope, &mut parser, &definition);
                    self.ledger.worked(parser.budget.spent());
                    let values = values.map_err(shift)?;
                    let latex = if self.renders { vec![typeset::definition(&definition, rest)] } else { Vec::new() };
                    self.define(&sub, &definition, values, formula, latex).map_err(shift)?;
                }
                Some(Statement::Claim(claim)) => {
                    let (line, column) = self.lines.position(sub.span(claim.span()).start);
                    let explains = self.diagnoses < MAX_DIAGNOSES;
                    let found = decide(&self.scope, &mut parser, &claim, rest, explains).map_err(|error| suggested(error, rest));
                    let (latex, picture) = match self.renders {
                        true => (typeset::claim(&claim, rest), picture_of(&self.scope, &mut parser, &claim)),
                        false => (Vec::new(), None),
                    };
                    self.ledger.worked(parser.budget.spent());
                    self.record(&sub, &claim, name, (line, column), found, (latex, picture));
                }
            }
            if is_last {
                return Ok(());
            }
            at += consumed;
        }
    }

    fn record(
        &mut self,
        part: &Part<'_>,
        claim: &statement::Claim,
        name: Option<&str>,
        position: (usize, usize),
        found: Result<Decision, SyntaxError>,
        (latex, picture): (Vec<String>, Option<Picture>),
    ) {
        let span = part.span(claim.span());
        let mut record = Claim::new(position, span, name);
        match found {
            Ok(Decision::Holds { trivial }) => {
                if let Some(side) = trivial {
                    let message = "found the same on both sides, which holds whatever it is";
                    self.report.warnings.push(Warning { code: "W102", error: SyntaxError::new(part.span(side), message) });
                }
            }
            Ok(Decision::Fails(failure)) => {
                record.verdict = Verdict::Refuted;
                self.diagnoses += 1;
                let failure = *failure;
                (record.left, record.right) = (Some(failure.left), Some(failure.right));
                record.difference = failure.difference;
                record.terms = failure.terms;
                record.diagnosis = failure.diagnosis;
            }
            Err(error) => {
                record.verdict = Verdict::Error;
                self.diagnoses += 1;
                record.error = Some(part.error(error));
            }
        }
        self.render(span, Outcome::Claim(self.report.claims.len()), latex, picture);
        self.report.claims.push(record);
    }

    fn define(
        &mut self,
        part: &Part<'_>,
        definition: &MapDefinition,
        value: Made,
        formula: bool,
        latex: Vec<String>,
    ) -> Result<(), SyntaxError> {
        let (name, span) = (definition.definition.name, definition.definition.name_span);
        if let Some(place) = self.scope.place_of(name) {
            let line = self.lines.line(place.start);
            let error = SyntaxError::new(span, format!("found a second definition of `{name}`, which line {line} defines"));
            return Err(error.with_help("a name stands for one thing in a worksheet: take another letter or an index"));
        }
        let in_file = part.span(span);
        let value = match value {
            Made::Component(index, component) => {
                self.ledger.hold(Quantity::Number(component.body.clone()).size(), span)?;
                self.scope.insert_component(name.letter(), index, Component { span: in_file, ..component });
                Quantity::List(Vec::new())
            }
            Made::Value(value) => {
                let callable = matches!(value, Quantity::Map(_) | Quantity::Net(_));
                if callable && name.letter().is_lowercase() && !formula {
                    let upper = name.letter().to_uppercase();
                    let error = SyntaxError::new(span, format!("found a map named `{name}`, expected a capital letter"));
                    return Err(error.with_help(format!("write `{upper}`; the small letter is then its polar form")));
                }
                self.ledger.hold(value.size(), span)?;
                self.scope.insert(name, value.clone(), in_file);
                value
            }
        };
        let whole = part.span(span.to(definition.definition.body.span));
        let picture = match &value {
            Quantity::Net(net) if self.renders => Some(Picture { net: net.clone(), at: None, label: name.to_string() }),
            _ => None,
        };
        self.render(whole, Outcome::Definition(self.report.definitions.len()), latex, picture);
        self.report.definitions.push((name, value, in_file));
        Ok(())
    }

    /// Keeps a statement for those who render the worksheet.
    fn render(&mut self, span: Span, outcome: Outcome, latex: Vec<String>, picture: Option<Picture>) {
        if self.renders {
            self.report.statements.push(Rendered { span, outcome, latex, picture });
        }
    }

    fn finish(mut self) -> Report {
        // Maps that nothing used are complete, or not, all the same.
        for (symbol, span) in self.scope.unused() {
            if self.scope.is_waiting(symbol.letter())
                && let Err(error) = self.scope.complete(symbol.letter())
            {
                self.report.errors.push(error);
            }
            let error = SyntaxError::new(span, format!("found a definition of `{symbol}` that nothing uses"));
            self.report.warnings.push(Warning { code: "W101", error });
        }
        self.report.warnings.sort_by_key(|warning| warning.error.span);
        if self.report.warnings.len() > MAX_PROBLEMS {
            self.report.warnings.truncate(MAX_PROBLEMS + 1);
            if let Some(last) = self.report.warnings.last_mut() {
                last.error.message = format!("found more than {MAX_PROBLEMS} warnings above, and none is listed from here on");
            }
        }
        self.report
    }
}

/// Whether a name in call position belongs to something that is defined, not just announced.
fn callee_is_made(scope: &Scope, symbol: Symbol) -> bool {
    scope.callee(symbol, false).is_some_and(|callee| scope.place_of(callee.base).is_some() && callee.named == Named::PolarForm)
        || scope.place_of(symbol).is_some()
}

/// The letters in a text, each with its index.
fn letters_of(text: &str) -> BTreeSet<Symbol> {
    let mut letters = BTreeSet::new();
    let mut rest = text;
    while let Some(place) = rest.find(|c: char| Symbol::is_letter(c)) {
        let letter = rest[place..].chars().next().unwrap_or('a');
        rest = &rest[place + letter.len_utf8()..];
        let digits_from = rest.strip_prefix('_').unwrap_or(rest);
        let length = digits_from.find(|c: char| !c.is_ascii_digit()).unwrap_or(digits_from.len());
        letters.insert(Symbol::new(letter, digits_from[..length].parse().ok()));
    }
    letters
}

/// The name in front of a claim, and how many bytes it and its colon take.
fn claim_name(text: &str) -> (Option<&str>, usize) {
    let start = text.len() - text.trim_start().len();
    let Some((name, rest)) = text.split_once(':') else { return (None, 0) };
    let name = &name[start.min(name.len())..];
    let fits = name.starts_with(|c: char| c.is_alphabetic()) && name.chars().all(|c| c.is_alphanumeric() || "-_.".contains(c));
    if fits && rest.starts_with([' ', '\t']) { (Some(name), start + name.len() + 1) } else { (None, 0) }
}

/// The expressions of a statement.
fn bodies(statement: &Statement) -> Vec<&Expression> {
    match statement {
        Statement::Claim(claim) => claim.sides.iter().collect(),
        Statement::Definition(definition) => vec![&definition.definition.body],
    }
}

/// The letters of the maps in expressions whose components still wait for others.
fn waiting_letters(scope: &Scope, expressions: &[&Expression]) -> Vec<char> {
    let mut letters = Vec::new();
    let mut ahead = expressions.to_vec();
    while let Some(expression) = ahead.pop() {
        let symbol = match &expression.kind {
            ExpressionKind::Call(call) => match call.callee {
                Callee::Name(symbol) => Some(symbol),
                Callee::Function(_) => None,
            },
            ExpressionKind::Symbol(symbol) => Some(*symbol),
            _ => None,
        };
        let upper = symbol.and_then(|symbol| symbol.letter().to_uppercase().next());
        letters.extend(upper.filter(|letter| scope.is_waiting(*letter) && !letters.contains(letter)));
        ahead.extend(expression.parts());
    }
    letters
}
