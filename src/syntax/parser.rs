//! From tokens to expressions.

use super::brackets::{partners, too_deep};
use super::expression::{Argument, Arguments, Call, Callee, Expression, ExpressionKind};
use super::lexer::{self, Spelling, shorten, superscript_digits};
use super::limits::{Budget, MAX_NESTING};
use super::token::{Bracket, Token, TokenKind};
use super::{Span, SyntaxError};
use crate::symbolic::Symbol;

const FACTOR: &str = "a number, a letter or `(`";

/// What a worksheet has beyond the grammar of formulas.
#[derive(Clone, Copy)]
pub(crate) struct Vocabulary<'a> {
    /// The words: names of functions, classes, orders.
    pub(crate) word: fn(&str) -> Option<&'static str>,
    /// Whether a letter is the name of a map or of its polar form, and which;
    /// asked with whether several arguments stand behind it.
    pub(crate) callee: &'a dyn Fn(Symbol, bool) -> Option<Named>,
}

/// What a letter in front of a bracket stands for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Named {
    Map,
    PolarForm,
}

/// A cursor over the tokens of one text. The methods that read a piece of it
/// leave the cursor behind that piece; what it is followed by is the caller's
/// business, see [`Parser::finish`].
pub(crate) struct Parser<'a> {
    pub(crate) source: &'a str,
    pub(crate) budget: Budget,
    tokens: Vec<Token>,
    partners: Vec<u32>,
    at: usize,
    latex: bool,
    depth: usize,
    /// Whether a blank ends an expression: in lists, outside round brackets.
    spaced: bool,
    /// Whether the head of a definition ends an expression.
    definitions: bool,
    /// Whether a line end does, where no operator stands.
    lines: bool,
    /// What letters and words stand for, in a worksheet.
    vocabulary: Option<Vocabulary<'a>>,
    /// In how many brackets of calls and lists the cursor is.
    inside: usize,
}

impl<'a> Parser<'a> {
    pub(crate) fn new(source: &'a str) -> Result<Self, SyntaxError> {
        Self::with(source, Spelling::of(source), None)
    }

    /// A parser of the statements of a worksheet.
    pub(crate) fn of_worksheet(source: &'a str, latex: bool, vocabulary: Vocabulary<'a>) -> Result<Self, SyntaxError> {
        let spelling = Spelling { latex: latex || lexer::is_latex(source), word: vocabulary.word };
        Self::with(source, spelling, Some(vocabulary))
    }

    fn with(source: &'a str, spelling: Spelling, vocabulary: Option<Vocabulary<'a>>) -> Result<Self, SyntaxError> {
        let tokens = lexer::tokens(source, spelling)?;
        Ok(Self {
            source,
            budget: Budget::new(),
            partners: partners(&tokens)?,
            tokens,
            at: 0,
            latex: spelling.latex,
            depth: 0,
            spaced: false,
            definitions: false,
            lines: false,
            vocabulary,
            inside: 0,
        })
    }

    /// The same, with blanks ending an expression.
    pub(crate) fn spaced(source: &'a str) -> Result<Self, SyntaxError> {
        let mut parser = Self::new(source)?;
        parser.spaced = true;
        Ok(parser)
    }

    pub(crate) fn set_spaced(&mut self, spaced: bool) -> bool {
        std::mem::replace(&mut self.spaced, spaced)
    }

    pub(crate) fn set_definitions(&mut self, definitions: bool) {
        self.definitions = definitions;
    }

    /// Lets a line end be the end of an expression, where no operator stands.
    pub(crate) fn set_lines(&mut self, lines: bool) {
        self.lines = lines;
    }

    /// Whether the cursor is in the brackets of a call or a list.
    pub(crate) fn is_inside(&self) -> bool {
        self.inside > 0
    }

    /// Whether roots that are not rational are numbers, as they are in worksheets.
    pub(crate) fn allows_roots(&self) -> bool {
        self.vocabulary.is_some()
    }

    /// What the letter at the cursor stands for in front of a bracket.
    pub(crate) fn named(&self, symbol: Symbol) -> Option<Named> {
        let several = self.token(1).kind == TokenKind::Open(Bracket::Round) && self.has_separator(1);
        self.vocabulary.and_then(|vocabulary| (vocabulary.callee)(symbol, several))
    }

    pub(crate) fn is_latex(&self) -> bool {
        self.latex
    }

    /// The token `ahead` of the cursor; beyond the last one, the last one.
    pub(crate) fn token(&self, ahead: usize) -> Token {
        let end = Span::new(self.source.len(), self.source.len());
        let last = Token { kind: TokenKind::End, span: end, blank_before: false, break_before: false };
        self.tokens.get(self.at + ahead).copied().unwrap_or(last)
    }

    pub(crate) fn peek(&self) -> TokenKind {
        self.token(0).kind
    }

    pub(crate) fn at_end(&self) -> bool {
        self.peek() == TokenKind::End
    }

    /// How many tokens there are from the bracket at the cursor up to its partner, both included; 1 for no bracket.
    pub(crate) fn bracket_length(&self, ahead: usize) -> usize {
        let place = self.at + ahead;
        self.partners.get(place).map_or(1, |&partner| (partner as usize).saturating_sub(place) + 1)
    }

    pub(crate) fn advance(&mut self) -> Token {
        let token = self.token(0);
        if token.kind != TokenKind::End {
            self.at += 1;
        }
        token
    }

    /// Passes a token of this kind if it is next.
    pub(crate) fn take(&mut self, kind: TokenKind) -> bool {
        let found = self.peek() == kind;
        if found {
            self.advance();
        }
        found
    }

    /// The tokens outside all brackets, from the cursor on, with their distances from it.
    pub(crate) fn top_level(&self) -> impl Iterator<Item = (usize, Token)> + '_ {
        let mut ahead = 0;
        std::iter::from_fn(move || {
            let token = self.token(ahead);
            let place = ahead;
            ahead += if matches!(token.kind, TokenKind::Open(_)) { self.bracket_length(ahead) } else { 1 };
            (token.kind != TokenKind::End).then_some((place, token))
        })
    }

    /// Whether the bracket `ahead` contains a comma that is not in a further bracket.
    pub(crate) fn has_comma(&self, ahead: usize) -> bool {
        self.contains(ahead, &[TokenKind::Comma])
    }

    /// Whether the bracket `ahead` contains a comma or semicolon that is not in a further bracket.
    fn has_separator(&self, ahead: usize) -> bool {
        self.contains(ahead, &[TokenKind::Comma, TokenKind::Semicolon])
    }

    fn contains(&self, ahead: usize, kinds: &[TokenKind]) -> bool {
        let end = ahead + self.bracket_length(ahead);
        let mut inside = ahead + 1;
        while inside < end {
            let token = self.token(inside);
            match token.kind {
                kind if kinds.contains(&kind) => return true,
                TokenKind::Open(_) => inside += self.bracket_length(inside),
                _ => inside += 1,
            }
        }
        false
    }

    /// "found …, expected …" at the cursor.
    pub(crate) fn expected(&self, what: &str) -> SyntaxError {
        let token = self.token(0);
        SyntaxError::new(token.span, format!("found {}, expected {what}", self.describe(token)))
    }

    pub(crate) fn describe(&self, token: Token) -> String {
        match token.kind {
            TokenKind::End => "the end of the input".to_owned(),
            _ => format!("`{}`", shorten(token.span.text(self.source))),
        }
    }

    /// Checks that nothing is left.
    pub(crate) fn finish(&self, what: &str) -> Result<(), SyntaxError> {
        if self.at_end() { Ok(()) } else { Err(self.expected(what)) }
    }

    /// Checks that there is anything at all.
    pub(crate) fn not_empty(&self, what: &str) -> Result<(), SyntaxError> {
        let span = Span::new(0, 0);
        if self.at_end() { Err(SyntaxError::new(span, format!("found nothing, expected {what}"))) } else { Ok(()) }
    }

    /// Whether the head of a definition is next: a name, perhaps with a bracket, and `=`.
    pub(crate) fn at_definition(&self) -> bool {
        if !matches!(self.peek(), TokenKind::Symbol(_)) {
            return false;
        }
        let behind = match self.token(1).kind {
            TokenKind::Open(Bracket::Round) => 1 + self.bracket_length(1),
            _ => 1,
        };
        self.token(behind).kind == TokenKind::Equals
    }

    /// One level deeper, where no bracket has been counted yet.
    fn nested<T>(&mut self, read: impl FnOnce(&mut Self) -> Result<T, SyntaxError>) -> Result<T, SyntaxError> {
        if self.depth == MAX_NESTING {
            return Err(too_deep(self.token(0).span));
        }
        self.depth += 1;
        let result = read(self);
        self.depth -= 1;
        result
    }

    /// Reads a sum of products: the whole of an expression.
    pub(crate) fn expression(&mut self) -> Result<Expression, SyntaxError> {
        let start = self.token(0).span;
        let negative = self.signs();
        let first = self.product()?;
        if !negative && !self.at_sign() {
            return Ok(first);
        }
        let mut span = start.to(first.span);
        let mut terms = vec![(negative, first)];
        while self.at_sign() {
            let negative = self.signs();
            let term = self.product()?;
            span = span.to(term.span);
            terms.push((negative, term));
        }
        Ok(Expression { kind: ExpressionKind::Sum(terms), span })
    }

    /// Whether a sign is next that continues the expression.
    fn at_sign(&self) -> bool {
        let sign = self.token(0);
        let begins_item = self.spaced && sign.blank_before && !self.token(1).blank_before;
        matches!(sign.kind, TokenKind::Plus | TokenKind::Minus) && !begins_item
    }

    /// Passes signs; whether they make what follows negative.
    fn signs(&mut self) -> bool {
        let mut negative = false;
        while let kind @ (TokenKind::Plus | TokenKind::Minus) = self.peek() {
            negative ^= kind == TokenKind::Minus;
            self.advance();
        }
        negative
    }

    fn product(&mut self) -> Result<Expression, SyntaxError> {
        let first = self.power()?;
        let mut span = first.span;
        let mut after_tuple = matches!(first.kind, ExpressionKind::Tuple(_));
        let mut factors = vec![(false, first)];
        loop {
            let token = self.token(0);
            let divided = token.kind == TokenKind::Over;
            let mut negative = false;
            match token.kind {
                TokenKind::Times | TokenKind::Over => {
                    self.advance();
                    negative = self.signs();
                }
                _ if !self.begins_factor(token) => break,
                // In lists a blank separates, and so does the end of a point.
                _ if self.spaced && (token.blank_before || after_tuple) => break,
                _ if self.definitions && self.at_definition() => break,
                _ if self.lines && token.break_before => break,
                _ => {}
            }
            let factor = self.power()?;
            after_tuple = matches!(factor.kind, ExpressionKind::Tuple(_));
            span = span.to(factor.span);
            let factor = if negative { Expression { span: factor.span, kind: ExpressionKind::Sum(vec![(true, factor)]) } } else { factor };
            factors.push((divided, factor));
        }
        match factors.pop() {
            Some((false, only)) if factors.is_empty() => Ok(only),
            Some(last) => {
                factors.push(last);
                Ok(Expression { kind: ExpressionKind::Product(factors), span })
            }
            None => Err(self.expected(FACTOR)),
        }
    }

    fn begins_factor(&self, token: Token) -> bool {
        match token.kind {
            TokenKind::Number | TokenKind::Symbol(_) | TokenKind::Root | TokenKind::Fraction | TokenKind::Open(Bracket::Round) => true,
            TokenKind::Open(Bracket::Curly) => self.latex,
            TokenKind::Word(_) => self.calls(),
            _ => false,
        }
    }

    /// Whether the bracket of a call stands right behind the name at the cursor.
    fn calls(&self) -> bool {
        let next = self.token(1);
        next.kind == TokenKind::Open(Bracket::Round) && !next.blank_before
    }

    fn power(&mut self) -> Result<Expression, SyntaxError> {
        let mut base = self.atom()?;
        if self.at_entry() {
            base = self.entry(base)?;
        }
        if !matches!(self.peek(), TokenKind::Power | TokenKind::Superscript) {
            return Ok(base);
        }
        let exponent = self.exponent()?;
        if matches!(self.peek(), TokenKind::Power | TokenKind::Superscript) {
            let (a, b) = (shorten(base.span.text(self.source)), shorten(exponent.span.text(self.source)));
            let error = SyntaxError::new(self.token(0).span, "found a second exponent, expected brackets around a tower of powers");
            return Err(error.with_help(format!("write `({a}^{b})^…` or `{a}^({b}^…)`")));
        }
        let span = base.span.to(exponent.span);
        Ok(Expression { kind: ExpressionKind::Power(Box::new(base), Box::new(exponent)), span })
    }

    /// The exponent at the cursor, with the `^` before it.
    pub(crate) fn exponent(&mut self) -> Result<Expression, SyntaxError> {
        const EXPONENT: &str = "a non-negative whole number as exponent";
        let sign = self.advance();
        if sign.kind == TokenKind::Superscript {
            let value = self.number_value(&superscript_digits(sign.span.text(self.source)), sign.span)?;
            return Ok(Expression { kind: ExpressionKind::Number(value), span: sign.span });
        }
        let token = self.token(0);
        match token.kind {
            TokenKind::Number => {
                let text = token.span.text(self.source);
                if self.latex && text.chars().count() > 1 {
                    let (first, rest) = text.split_at(text.chars().next().map_or(0, char::len_utf8));
                    let message = format!(
                        "found `^{0}`, which LaTeX reads as `^{first}` followed by {rest}, expected an exponent in braces",
                        shorten(text)
                    );
                    let help = format!("write `^{{{}}}` or `^{first} {}`", shorten(text), shorten(rest));
                    return Err(SyntaxError::new(sign.span.to(token.span), message).with_help(help));
                }
                if !text.bytes().all(|byte| byte.is_ascii_digit()) {
                    return Err(self.expected(EXPONENT));
                }
                self.advance();
                let value = self.number_value(text, token.span)?;
                Ok(Expression { kind: ExpressionKind::Number(value), span: token.span })
            }
            TokenKind::Open(Bracket::Round | Bracket::Curly) => self.group(),
            TokenKind::Minus => {
                let number = self.token(1);
                let shown = if number.kind == TokenKind::Number { number.span.text(self.source) } else { "" };
                let error =
                    SyntaxError::new(token.span.to(number.span), format!("found the exponent `-{}`, expected {EXPONENT}", shorten(shown)));
                Err(error.with_help("only polynomials are possible here; divide by numbers with `/`"))
            }
            _ => Err(self.expected(EXPONENT)),
        }
    }

    fn atom(&mut self) -> Result<Expression, SyntaxError> {
        let token = self.token(0);
        match token.kind {
            TokenKind::Number => {
                self.advance();
                let value = self.number_value(token.span.text(self.source), token.span)?;
                Ok(Expression { kind: ExpressionKind::Number(value), span: token.span })
            }
            TokenKind::Symbol(symbol) => {
                if self.calls()
                    && let Some(named) = self.named(symbol)
                {
                    return self.call(Callee::Name(symbol), named == Named::PolarForm);
                }
                self.advance();
                Ok(Expression { kind: ExpressionKind::Symbol(symbol), span: token.span })
            }
            TokenKind::Word(name) if self.calls() => self.call(Callee::Function(name), false),
            TokenKind::Word(name) => {
                self.advance();
                Ok(Expression { kind: ExpressionKind::Word(name), span: token.span })
            }
            TokenKind::Open(Bracket::Round) => self.group(),
            TokenKind::Open(Bracket::Curly) if self.latex => self.group(),
            TokenKind::Open(Bracket::Square) if self.vocabulary.is_some() => self.list(),
            TokenKind::Open(Bracket::Square) => {
                Err(self.expected(FACTOR).with_help("`[ ]` makes a list; round brackets group, as in `2 (t + 1)`"))
            }
            TokenKind::Open(Bracket::Curly) => Err(self.expected(FACTOR).with_help("round brackets group, as in `2 (t + 1)`")),
            TokenKind::Root => {
                self.advance();
                if self.peek() == TokenKind::Open(Bracket::Square) {
                    return Err(self.expected("a square root, such as `\\sqrt{2}`"));
                }
                let argument = self.nested(Self::argument)?;
                let span = token.span.to(argument.span);
                Ok(Expression { kind: ExpressionKind::Root(Box::new(argument)), span })
            }
            TokenKind::Fraction => {
                self.advance();
                let numerator = self.nested(Self::argument)?;
                let denominator = self.nested(Self::argument)?;
                let span = token.span.to(denominator.span);
                // A fraction is one factor, whatever precedes it: `1/\frac{1}{2}` is 2.
                let quotient = Expression { kind: ExpressionKind::Product(vec![(false, numerator), (true, denominator)]), span };
                Ok(Expression { kind: ExpressionKind::Group(Box::new(quotient)), span })
            }
            _ => Err(self.expected(FACTOR)),
        }
    }

    /// The argument of a root or a fraction: a bracket or, in LaTeX, one digit or letter.
    fn argument(&mut self) -> Result<Expression, SyntaxError> {
        let token = self.token(0);
        let text = token.span.text(self.source);
        // TeX takes one character of `\frac32` and of `\frac t2`, which the lexer has joined.
        let joined = match token.kind {
            TokenKind::Number => text.bytes().all(|byte| byte.is_ascii_digit()),
            TokenKind::Symbol(_) => text.len() > 1 && text.bytes().skip(1).all(|byte| byte.is_ascii_digit()),
            _ => false,
        };
        if !self.latex || !joined || text.len() == 1 {
            return self.atom();
        }
        let span = Span::new(token.span.start, token.span.start + 1);
        let kind = match token.kind {
            TokenKind::Symbol(symbol) => ExpressionKind::Symbol(Symbol::new(symbol.letter(), None)),
            _ => ExpressionKind::Number(self.number_value(span.text(self.source), span)?),
        };
        if let Some(rest) = self.tokens.get_mut(self.at) {
            rest.kind = TokenKind::Number;
            rest.span.start = span.end;
            rest.blank_before = false;
        }
        Ok(Expression { kind, span })
    }

    /// A bracket, round or curly, with one expression or several.
    fn group(&mut self) -> Result<Expression, SyntaxError> {
        let open = self.advance();
        self.bracketed(|parser| parser.group_inside(open))
    }

    /// Reads what stands in a bracket, where neither blanks nor lines separate.
    fn bracketed<T>(&mut self, read: impl FnOnce(&mut Self) -> Result<T, SyntaxError>) -> Result<T, SyntaxError> {
        let outside = (self.spaced, self.definitions, self.lines, self.inside);
        (self.spaced, self.definitions, self.lines) = (false, false, false);
        let result = self.nested(read);
        (self.spaced, self.definitions, self.lines, self.inside) = outside;
        result
    }

    /// A call; the name is at the cursor, its bracket behind it.
    fn call(&mut self, callee: Callee, is_polar: bool) -> Result<Expression, SyntaxError> {
        let name_span = self.advance().span;
        let open = self.advance();
        let arguments = self.bracketed(|parser| {
            parser.inside += 1;
            if is_polar {
                return parser.polar_groups().map(Arguments::Polar);
            }
            parser.plain_arguments().map(Arguments::Plain)
        })?;
        let span = name_span.to(open.span).to(self.advance().span);
        Ok(Expression { kind: ExpressionKind::Call(Box::new(Call { callee, name_span, arguments })), span })
    }

    fn polar_groups(&mut self) -> Result<Vec<Vec<super::expression::PolarArgument>>, SyntaxError> {
        let mut groups = Vec::new();
        loop {
            // Only where no comma separates do blanks.
            let commas = self.group_has_comma();
            self.set_spaced(!commas);
            groups.push(self.polar_arguments()?);
            if matches!(self.peek(), TokenKind::Close(_)) {
                return Ok(groups);
            }
            if groups.len() == 2 {
                return Err(self.expected("at most two groups of arguments"));
            }
            self.advance();
        }
    }

    fn plain_arguments(&mut self) -> Result<Vec<Argument>, SyntaxError> {
        let mut arguments = Vec::new();
        if matches!(self.peek(), TokenKind::Close(_)) {
            return Ok(arguments);
        }
        loop {
            arguments.push(match (self.peek(), self.token(1).kind) {
                (TokenKind::Symbol(name), TokenKind::Equals) => {
                    self.advance();
                    self.advance();
                    Argument::Named(name, self.expression()?)
                }
                _ => {
                    let first = self.weighted()?;
                    if self.take(TokenKind::Range) { Argument::Range(first, self.expression()?) } else { Argument::Plain(first) }
                }
            });
            match self.peek() {
                TokenKind::Close(_) => return Ok(arguments),
                TokenKind::Comma => self.advance(),
                _ => return Err(self.expected("an operator, `,` or `)` behind an argument")),
            };
        }
    }

    /// An expression, with its weight if there is one.
    pub(crate) fn weighted(&mut self) -> Result<Expression, SyntaxError> {
        let point = self.expression()?;
        if self.vocabulary.is_none() || !self.take(TokenKind::Colon) {
            return Ok(point);
        }
        let weight = self.expression()?;
        let span = point.span.to(weight.span);
        Ok(Expression { kind: ExpressionKind::Weighted(Box::new(point), Box::new(weight)), span })
    }

    /// Whether a list without commas is one of points or of numbers, not one product.
    fn is_row(&self) -> bool {
        let (mut points, mut others) = (0, 0);
        for (ahead, token) in self.top_level().take_while(|(_, token)| !matches!(token.kind, TokenKind::Close(_))) {
            match token.kind {
                TokenKind::Open(Bracket::Square) => points += 1,
                TokenKind::Open(_) if self.has_comma(ahead) => points += 1,
                TokenKind::Open(_) | TokenKind::Symbol(_) | TokenKind::Word(_) => others += 1,
                _ => {}
            }
        }
        points > 1 || others == 0
    }

    /// A list in square brackets: separated by commas or, where there is none, by blanks.
    fn list(&mut self) -> Result<Expression, SyntaxError> {
        let open = self.advance();
        let items = self.bracketed(|parser| {
            parser.inside += 1;
            let commas = parser.group_has_comma();
            parser.set_spaced(!commas && parser.is_row());
            let mut items = Vec::new();
            while !matches!(parser.peek(), TokenKind::Close(_)) {
                items.push(parser.weighted()?);
                let comma = parser.take(TokenKind::Comma);
                if !parser.spaced && !comma && !matches!(parser.peek(), TokenKind::Close(_)) {
                    return Err(parser.expected("an operator, `,` or `]` behind an entry of the list"));
                }
            }
            Ok(items)
        })?;
        let span = open.span.to(self.advance().span);
        Ok(Expression { kind: ExpressionKind::List(items), span })
    }

    /// Whether the number of an entry is next: `[k]` right behind a list.
    fn at_entry(&self) -> bool {
        let open = self.token(0);
        self.vocabulary.is_some() && open.kind == TokenKind::Open(Bracket::Square) && !open.blank_before
    }

    /// An entry of a list: `[k]` behind it, or several.
    fn entry(&mut self, list: Expression) -> Result<Expression, SyntaxError> {
        let mut numbers = Vec::new();
        let mut span = list.span;
        while self.at_entry() {
            self.advance();
            numbers.push(self.bracketed(|parser| {
                let number = parser.expression()?;
                if !matches!(parser.peek(), TokenKind::Close(_)) {
                    return Err(parser.expected("an operator or `]` behind the number of an entry"));
                }
                Ok(number)
            })?);
            span = span.to(self.advance().span);
        }
        Ok(Expression { kind: ExpressionKind::Entry(Box::new(list), numbers), span })
    }

    fn group_inside(&mut self, open: Token) -> Result<Expression, SyntaxError> {
        let first = self.expression()?;
        let mut items = Vec::new();
        while self.peek() == TokenKind::Comma {
            self.advance();
            items.push(self.expression()?);
        }
        if !matches!(self.peek(), TokenKind::Close(_)) {
            return Err(self.expected("an operator, `,` or a closing bracket"));
        }
        let span = open.span.to(self.advance().span);
        if items.is_empty() {
            return Ok(Expression { kind: ExpressionKind::Group(Box::new(first)), span });
        }
        items.insert(0, first);
        Ok(Expression { kind: ExpressionKind::Tuple(items), span })
    }
}
