//! The statements of worksheets: definitions and claims.

use super::definition::Definition;
use super::expression::{Expression, ExpressionKind};
use super::parser::Parser;
use super::token::{Comparison, TokenKind};
use super::{Span, SyntaxError};
use crate::symbolic::Symbol;

/// One statement.
pub(crate) enum Statement {
    /// A name and what it stands for.
    Definition(Box<MapDefinition>),
    /// Values that are compared, each with the next.
    Claim(Claim),
}

/// A definition with what may stand behind its body.
pub(crate) struct MapDefinition {
    pub(crate) definition: Definition,
    /// The polar degree that is asked for, or the two of a bidegree.
    pub(crate) degree: Vec<Expression>,
    /// What the body is divided by.
    pub(crate) weight: Option<Expression>,
}

/// Values that are compared, each with the next: one more than comparisons.
pub(crate) struct Claim {
    pub(crate) sides: Vec<Expression>,
    pub(crate) comparisons: Vec<Comparison>,
}

impl Claim {
    /// Where the claim stands.
    pub(crate) fn span(&self) -> Span {
        self.sides.iter().map(|side| side.span).reduce(Span::to).unwrap_or_default()
    }
}

impl Comparison {
    /// The sign as it is written in text.
    pub(crate) fn sign(self) -> &'static str {
        match self {
            Self::Equal => "==",
            Self::NotEqual => "!=",
            Self::Less => "<",
            Self::LessOrEqual => "<=",
            Self::Greater => ">",
            Self::GreaterOrEqual => ">=",
        }
    }

    /// The sign as LaTeX has it.
    pub(crate) fn latex(self) -> &'static str {
        match self {
            Self::Equal => "=",
            Self::NotEqual => "\\neq",
            Self::Less => "<",
            Self::LessOrEqual => "\\le",
            Self::Greater => ">",
            Self::GreaterOrEqual => "\\ge",
        }
    }
}

impl Parser<'_> {
    /// Reads the next statement; `None` at the end. In formulas, `=` claims
    /// where `is_defined` says that the left side is a name in use.
    pub(crate) fn statement(&mut self, formula: bool, is_defined: &dyn Fn(Symbol) -> bool) -> Result<Option<Statement>, SyntaxError> {
        // In a formula line ends and the like separate; `x \kappa = 0` is one claim.
        self.set_definitions(!formula);
        self.set_lines(formula);
        while self.take(TokenKind::Comma) {}
        if self.at_end() {
            return Ok(None);
        }
        let statement = if self.at_definition() && !(formula && self.name_at_cursor().is_some_and(is_defined)) {
            Statement::Definition(Box::new(self.map_definition()?))
        } else {
            Statement::Claim(self.claim(formula)?)
        };
        self.end_of_statement(formula)?;
        Ok(Some(statement))
    }

    fn name_at_cursor(&self) -> Option<Symbol> {
        match self.peek() {
            TokenKind::Symbol(symbol) => Some(symbol),
            _ => None,
        }
    }

    fn map_definition(&mut self) -> Result<MapDefinition, SyntaxError> {
        let (name, next) = (self.name_at_cursor(), self.token(1));
        if let Some(name) = name
            && self.named(name).is_some()
            && next.kind == TokenKind::Open(super::token::Bracket::Round)
            && !matches!(self.token(2).kind, TokenKind::Symbol(_))
        {
            let equals = self.token(1 + self.bracket_length(1)).span;
            let error = SyntaxError::new(equals, "found `=` behind a value, expected `==`");
            return Err(error.with_help("`=` defines, `==` claims"));
        }
        let definition = self.definition()?;
        let (mut degree, mut weight) = (Vec::new(), None);
        while let TokenKind::Word(word @ ("degree" | "bidegree" | "weight")) = self.peek() {
            self.advance();
            match word {
                "weight" => weight = Some(self.expression()?),
                _ => {
                    degree = vec![self.expression()?];
                    if word == "bidegree" {
                        degree = match degree.pop() {
                            Some(Expression { kind: ExpressionKind::Tuple(items), .. }) => items,
                            other => other.into_iter().collect(),
                        };
                        if degree.len() == 1 {
                            if !self.take(TokenKind::Comma) {
                                return Err(self.expected("`,` and the degree in the second variable, as in `bidegree 3,2`"));
                            }
                            degree.push(self.expression()?);
                        }
                    }
                }
            }
        }
        Ok(MapDefinition { definition, degree, weight })
    }

    fn claim(&mut self, formula: bool) -> Result<Claim, SyntaxError> {
        let mut sides = vec![self.weighted()?];
        let mut comparisons = Vec::new();
        loop {
            let comparison = match self.peek() {
                TokenKind::Comparison(comparison) => comparison,
                TokenKind::Equals if formula => Comparison::Equal,
                TokenKind::Equals => {
                    let error = self.expected("`==`, which claims");
                    return Err(error.with_help("`=` defines: a name, perhaps with its variables in brackets, stands on its left"));
                }
                _ if comparisons.is_empty() => {
                    let error = self.expected("an operator, or `==` and another value");
                    return Err(error.with_help("a statement is a definition `F(t) = …` or a claim `… == …`"));
                }
                _ => return Ok(Claim { sides, comparisons }),
            };
            self.advance();
            comparisons.push(comparison);
            sides.push(self.weighted()?);
        }
    }

    /// What must stand behind a statement.
    fn end_of_statement(&mut self, formula: bool) -> Result<(), SyntaxError> {
        let separated = self.token(0).break_before && formula;
        if self.at_end() || self.take(TokenKind::Comma) || separated {
            return Ok(());
        }
        Err(self.expected("an operator or the end of the line"))
    }
}
