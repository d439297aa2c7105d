//! Statements as LaTeX, written as they were typed.

use super::function;
use crate::syntax::expression::{Argument, Arguments, Call, Callee, Expression, ExpressionKind, PolarArgument};
use crate::syntax::statement::{Claim, MapDefinition};
use crate::syntax::{Style, printer};

/// A definition.
pub(super) fn definition(made: &MapDefinition, source: &str) -> String {
    let head = &made.definition;
    let name = printer::symbol(head.name, Style::Latex);
    let arguments = head.arguments.as_ref().map_or_else(String::new, |list| {
        let letters: Vec<String> = list.iter().map(|(symbol, _)| printer::symbol(*symbol, Style::Latex)).collect();
        format!("({})", letters.join(", "))
    });
    let mut text = format!("{name}{arguments} = {}", expression(&head.body, source));
    if let Some(weight) = &made.weight {
        text.push_str(&format!(" \\;\\text{{ weight }}\\; {}", expression(weight, source)));
    }
    let degrees: Vec<String> = made.degree.iter().map(|degree| expression(degree, source)).collect();
    match degrees.as_slice() {
        [] => {}
        [one] => text.push_str(&format!(" \\quad \\text{{(polar degree }} {one} \\text{{)}}")),
        several => text.push_str(&format!(" \\quad \\text{{(bidegree }} {} \\text{{)}}", several.join(", "))),
    }
    text
}

/// A claim: its first side, and each further one behind its sign, as formulas
/// between which a line may end.
pub(super) fn claim(made: &Claim, source: &str) -> Vec<String> {
    let mut parts = Vec::with_capacity(made.sides.len());
    for (index, side) in made.sides.iter().enumerate() {
        let side = expression(side, source);
        parts.push(match index.checked_sub(1).and_then(|before| made.comparisons.get(before)) {
            Some(comparison) => format!("{} {side}", comparison.latex()),
            None => side,
        });
    }
    parts
}

/// How long the LaTeX of a point or a list may be on one line.
const LINE: usize = 150;

/// Items in brackets; long ones below each other.
fn bracketed(items: &[String]) -> String {
    enclosed('(', items, ')')
}

fn enclosed(open: char, items: &[String], close: char) -> String {
    if items.len() > 1 && items.iter().map(String::len).sum::<usize>() > LINE {
        let rows: Vec<String> = items.iter().map(|item| format!("\\displaystyle {item}")).collect();
        return format!("\\left{open}\\begin{{array}}{{l}} {} \\end{{array}}\\right{close}", rows.join(" \\\\ "));
    }
    sized(open, &items.join(", "), close)
}

/// Brackets as high as what they hold.
fn sized(open: char, inside: &str, close: char) -> String {
    let is_high = ["\\frac", "\\begin", "\\sqrt", "\\left"].iter().any(|command| inside.contains(command));
    if is_high { format!("\\left{open}{inside}\\right{close}") } else { format!("{open}{inside}{close}") }
}

fn listed<'e>(items: impl IntoIterator<Item = &'e Expression>, source: &str) -> Vec<String> {
    items.into_iter().map(|item| expression(item, source)).collect()
}

/// An expression.
fn expression(made: &Expression, source: &str) -> String {
    match &made.kind {
        ExpressionKind::Number(value) => {
            let text = made.span.text(source);
            if text.bytes().all(|byte| byte.is_ascii_digit() || byte == b'.') {
                text.to_owned()
            } else {
                printer::rational(value, Style::Latex)
            }
        }
        ExpressionKind::Symbol(symbol) => printer::symbol(*symbol, Style::Latex),
        ExpressionKind::Sum(terms) => {
            let mut text = String::new();
            for (index, (negative, term)) in terms.iter().enumerate() {
                text.push_str(match (index, negative) {
                    (0, false) => "",
                    (_, true) => " - ",
                    (_, false) => " + ",
                });
                // A sum in a sum was written in brackets, or is a sign before a sign.
                let inner = expression(term, source);
                text.push_str(&if matches!(term.kind, ExpressionKind::Sum(_)) { format!("({inner})") } else { inner });
            }
            text
        }
        ExpressionKind::Product(factors) => product(factors, source),
        ExpressionKind::Power(base, exponent) => format!("{}^{{{}}}", expression(base, source), unbracketed(exponent, source)),
        ExpressionKind::Root(inner) => format!("\\sqrt{{{}}}", unbracketed(inner, source)),
        // A fraction is a group of its own in LaTeX.
        ExpressionKind::Group(inner) if made.span == inner.span => expression(inner, source),
        ExpressionKind::Group(inner) => sized('(', &expression(inner, source), ')'),
        ExpressionKind::Tuple(items) => bracketed(&listed(items, source)),
        ExpressionKind::List(items) => list(items, source),
        ExpressionKind::Entry(list, numbers) => {
            let numbers = numbers.iter().map(|number| format!("\\left[{}\\right]", expression(number, source)));
            std::iter::once(expression(list, source)).chain(numbers).collect()
        }
        ExpressionKind::Weighted(point, weight) => format!("{} : {}", expression(point, source), expression(weight, source)),
        ExpressionKind::Word(word) => format!("\\text{{{}}}", word.replace('_', " ")),
        ExpressionKind::Call(call) => called(call, source),
        ExpressionKind::Known(_) => made.span.text(source).to_owned(),
    }
}

/// A list; the rows of a net stand below each other.
fn list(items: &[Expression], source: &str) -> String {
    let is_net = items.len() > 1 && items.iter().all(|item| matches!(item.kind, ExpressionKind::List(_)));
    if !is_net {
        return enclosed('[', &listed(items, source), ']');
    }
    let rows: Vec<String> = items.iter().map(|row| expression(row, source)).collect();
    format!("\\left[\\begin{{array}}{{l}} {} \\end{{array}}\\right]", rows.join(" \\\\ "))
}

/// What stands in a bracket that the notation makes unneeded.
fn unbracketed(made: &Expression, source: &str) -> String {
    match &made.kind {
        ExpressionKind::Group(inner) => expression(inner, source),
        _ => expression(made, source),
    }
}

/// Factors and divisors: what stands before a divisor is its numerator.
fn product(factors: &[(bool, Expression)], source: &str) -> String {
    let mut text = String::new();
    // Whether the text is one thing, which needs no bracket in a numerator.
    let mut lone: Option<&Expression> = None;
    let mut count = 0;
    for (divided, factor) in factors {
        if *divided {
            let numerator = match (count, lone) {
                (1, Some(only)) => unbracketed(only, source),
                _ => text,
            };
            text = format!("\\frac{{{numerator}}}{{{}}}", unbracketed(factor, source));
            lone = None;
            count = 1;
            continue;
        }
        let part = expression(factor, source);
        let part = if matches!(factor.kind, ExpressionKind::Sum(_)) { sized('(', &part, ')') } else { part };
        let digits = part.starts_with(|c: char| c.is_ascii_digit()) || part.starts_with("\\frac");
        if count > 0 {
            text.push_str(if digits { " \\cdot " } else { "\\, " });
        }
        text.push_str(&part);
        lone = Some(factor);
        count += 1;
    }
    text
}

fn called(call: &Call, source: &str) -> String {
    let name = match call.callee {
        Callee::Name(symbol) => printer::symbol(symbol, Style::Latex),
        Callee::Function(name @ ("kappa12" | "kappa23" | "kappa31")) => format!("\\kappa_{{{}}}", &name["kappa".len()..]),
        Callee::Function("sigma") => "\\sigma".to_owned(),
        Callee::Function(name) => format!("\\operatorname{{{}}}", name.replace('_', "\\_")),
    };
    if let (Callee::Function("sigma"), Arguments::Plain(arguments)) = (call.callee, &call.arguments)
        && let [Argument::Plain(index), rest @ ..] = arguments.as_slice()
        && !rest.is_empty()
    {
        let rest = rest.iter().map(|argument| match argument {
            Argument::Plain(inner) | Argument::Named(_, inner) => expression(inner, source),
            Argument::Range(from, to) => format!("{}\\,..\\,{}", expression(from, source), expression(to, source)),
        });
        return format!("\\sigma_{{{}}}{}", unbracketed(index, source), sized('(', &rest.collect::<Vec<_>>().join(", "), ')'));
    }
    match &call.arguments {
        Arguments::Plain(arguments) => {
            let own = match call.callee {
                Callee::Function(name) => function::own_words(name),
                Callee::Name(_) => &[],
            };
            let shown = arguments.iter().map(|argument| match argument {
                Argument::Plain(inner) if own.contains(&inner.span.text(source).trim()) => inner.span.text(source).trim().to_owned(),
                Argument::Plain(inner) => expression(inner, source),
                Argument::Range(from, to) => format!("{}\\,..\\,{}", expression(from, source), expression(to, source)),
                Argument::Named(name, inner) => format!("{} = {}", printer::symbol(*name, Style::Latex), expression(inner, source)),
            });
            format!("{name}{}", sized('(', &shown.collect::<Vec<_>>().join(", "), ')'))
        }
        Arguments::Polar(groups) => {
            let groups: Vec<String> = groups.iter().map(|group| polar_group(group, source)).collect();
            format!("{name}{}", sized('(', &groups.join(";\\; "), ')'))
        }
    }
}

fn polar_group(group: &[PolarArgument], source: &str) -> String {
    let repeats = group.iter().any(|argument| argument.repeated.is_some());
    let shown = group.iter().map(|argument| {
        let coordinates = listed(&argument.coordinates, source).join(", ");
        let one = match &argument.weight {
            Some(weight) => format!("\\left[{};\\, {coordinates}\\right]", expression(weight, source)),
            None => coordinates,
        };
        match &argument.repeated {
            Some(count) => format!("{one}^{{{}}}", unbracketed(count, source)),
            None => one,
        }
    });
    shown.collect::<Vec<_>>().join(if repeats { "\\, " } else { ", " })
}
