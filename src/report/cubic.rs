//! Planar cubics as people read about them.

use super::decimal::decimal;
use super::entry::{Entry, kappa};
use super::formula::Notation;
use crate::algebraic::AlgebraicNumber;
use crate::cubic::{
    Branch, Cubic, CubicClass, Distance, Equivalence, Family, Image, Intention, NormalForm, Portion, SemiNormalForm, Special, SpecialPoint,
    Straight, place_name,
};
use crate::exact::{Rational, Surd};
use crate::scheme::polar_label;
use crate::symbolic::Symbol;
use crate::syntax::{Style, printer};
use crate::value::CubicFinding;

/// Everything about a cubic.
pub(super) fn entries(found: &CubicFinding, notation: &Notation) -> Vec<Entry> {
    let sheet = Sheet { notation };
    let cubic = &found.cubic;
    let mut lines = vec![class(cubic)];
    lines.extend(sheet.invariants(cubic));
    lines.extend(sheet.special(cubic, &found.special));
    if let Some(portion) = &found.portion {
        lines.extend(sheet.portion(portion));
    }
    lines.extend(sheet.coordinates(cubic));
    lines.extend(found.normal.as_ref().map(|normal| sheet.normal(normal)));
    if let Some(distance) = &found.distance {
        lines.push(sheet.distance(distance));
        lines.extend(found.intention.as_ref().map(|intention| sheet.intention(intention)));
    }
    match &found.equivalence {
        Some(Ok(maps)) => lines.extend(sheet.equivalence(maps)),
        Some(Err(reason)) => lines.push(Entry::remark("equivalent", format!("no: {reason}"))),
        None => {}
    }
    lines
}

fn class(cubic: &Cubic) -> Entry {
    let class = cubic.class();
    let kind = match class {
        CubicClass::Straight if cubic.is_point() => "point",
        CubicClass::Straight => "line",
        CubicClass::Humpy | CubicClass::Loopy | CubicClass::Pointy | CubicClass::SShaped | CubicClass::Parabolic => class.loop_blinn_name(),
    };
    let elsewhere = match class.double_point_name().filter(|name| *name != kind) {
        Some(double) => format!("elsewhere {kind}, or cubic with {} {double}", if double.starts_with('a') { "an" } else { "a" }),
        None => format!("elsewhere {kind}"),
    };
    Entry::remark("class", format!("{class} ({elsewhere})"))
}

struct Sheet<'a> {
    notation: &'a Notation,
}

impl Sheet<'_> {
    fn number(&self, number: &Rational) -> String {
        let surd = Surd::from(number);
        format!("{}{}", self.notation.surd(&surd), self.notation.decimals_of(&[surd]))
    }

    fn surd(&self, surd: &Surd) -> String {
        format!("{}{}", self.notation.surd(surd), self.notation.decimals_of(std::slice::from_ref(surd)))
    }

    fn point(&self, point: &[Surd]) -> String {
        format!("{}{}", self.notation.surds(point), self.notation.decimals_of(point))
    }

    fn vector(&self, vector: &[Rational]) -> String {
        self.point(&vector.iter().map(Surd::from).collect::<Vec<_>>())
    }

    fn letter(&self) -> String {
        printer::symbol(self.notation.variable, self.notation.style)
    }

    fn at(&self, t: &Surd) -> String {
        format!("{} = {}", self.letter(), self.surd(t))
    }

    fn special_point(&self, label: &str, found: &SpecialPoint) -> Entry {
        Entry::new(label).with(self.at(&found.t)).with(self.point(&found.point))
    }

    fn invariants(&self, cubic: &Cubic) -> Vec<Entry> {
        let invariants = cubic.invariants();
        let named = |index: &str, value: &Rational| format!("{} = {}", kappa(index, self.notation), self.number(value));
        let formula = match self.notation.style {
            Style::Latex => "D = 3 \\kappa_{31}^{2} - 4 \\kappa_{12} \\kappa_{23}",
            Style::Text | Style::Mathematica => "D = 3 κ31^2 - 4 κ12 κ23",
        };
        vec![
            Entry::new("invariants")
                .with(named("12", &invariants.kappa12))
                .with(named("23", &invariants.kappa23))
                .with(named("31", &invariants.kappa31)),
            Entry::new("discriminant").with(format!("{formula} = {}", self.number(&invariants.discriminant()))),
            Entry::new("branch").with(self.conditions(invariants.branch())),
            Entry::new("Loop–Blinn")
                .with(format!("{} = {}", self.indexed('d', 1), self.number(&invariants.kappa23)))
                .with(format!("{} = {}", self.indexed('d', 2), self.number(&invariants.kappa31)))
                .with(format!("{} = {}", self.indexed('d', 3), self.number(&invariants.kappa12))),
        ]
    }

    fn conditions(&self, branch: Branch) -> String {
        let text = branch.conditions();
        match self.notation.style {
            Style::Latex => ["12", "23", "31"]
                .iter()
                .fold(text.replace('≠', "\\neq"), |text, index| text.replace(&format!("κ{index}"), &kappa(index, self.notation))),
            Style::Text | Style::Mathematica => text.to_owned(),
        }
    }

    fn indexed(&self, letter: char, index: u32) -> String {
        printer::symbol(Symbol::new(letter, Some(index)), self.notation.style)
    }

    fn special(&self, cubic: &Cubic, special: &Special) -> Vec<Entry> {
        let mut lines: Vec<Entry> = Vec::new();
        match special {
            Special::Humpy { summit, flexes, acnode, .. } => {
                lines.extend(flexes.iter().map(|flex| self.special_point("flex", flex)));
                lines.push(self.special_point("summit", summit));
                lines.push(Entry::new("acnode").with(self.vector(acnode)).with_remark("an isolated double point, at no real parameter"));
            }
            Special::Loopy { summit, parameters, crunode, .. } => {
                let mut line = Entry::new("crunode").with(self.vector(crunode));
                for t in parameters {
                    line = line.with(self.at(t));
                }
                lines.push(line);
                lines.push(self.special_point("summit", summit));
                lines.extend(cubic.loop_area().map(|area| Entry::new("area of the loop").with(self.surd(&area))));
            }
            Special::Pointy { cusp, .. } => lines.push(self.special_point("cusp", cusp)),
            Special::SShaped { flex } => {
                let motion = cubic.flex_motion().map_or("", super::super::cubic::Direction::name);
                let remark = format!("the centre of symmetry, where v is {motion}");
                lines.push(self.special_point("flex", flex).with_remark(remark));
            }
            Special::Parabolic { vertex } => lines.push(self.special_point("vertex", vertex)),
            Special::Straight(straight) => lines.extend(self.straight(straight)),
        }
        if let Some(median) = special.median() {
            let (point, direction) = (self.vector(&median.point), self.vector(&median.direction));
            let line = match self.notation.style {
                Style::Latex => format!("{point} + \\lambda {direction}"),
                Style::Text | Style::Mathematica => format!("{point} + λ {direction}"),
            };
            lines.push(
                Entry::new("median line")
                    .with(line)
                    .with_remark(format!("halves the chords parallel to {}", self.vector_in_words(&median.chord))),
            );
        }
        if let Some(point) = cubic.curve().point_at_infinity() {
            let coordinates: Vec<String> = point.iter().map(|c| printer::rational(c, self.notation.style)).collect();
            lines.push(Entry::new("point at infinity").with(format!("[0; {}]", coordinates.join(", "))));
        }
        lines
    }

    /// A vector inside of a remark.
    fn vector_in_words(&self, vector: &[Rational]) -> String {
        format!("({})", vector.iter().map(Rational::to_string).collect::<Vec<_>>().join(", "))
    }

    fn straight(&self, straight: &Straight) -> Vec<Entry> {
        let (Some(direction), Some(profile)) = (&straight.direction, &straight.profile) else {
            return vec![Entry::new("point").with(self.vector(&straight.start)).with_remark("the whole curve")];
        };
        let letter = self.letter();
        let profile = self.notation.univariate(profile, self.notation.variable);
        let mut lines = vec![
            Entry::new("parametrization")
                .with(format!("F({letter}) = {} + p({letter}) {}", self.vector(&straight.start), self.vector(direction)))
                .with(format!("p({letter}) = {profile}"))
                .with_remark(format!("of degree {}", straight.degree)),
        ];
        for turn in &straight.turns {
            lines.push(Entry::new("turns back").with(self.at(turn)).with(self.point(&straight.point(&straight.profile_at(turn)))));
        }
        let image = match (straight.image, straight.turns.len()) {
            (Image::Ray, _) => "a ray, covered twice",
            (Image::Line, 0) => "the line, covered once",
            (Image::Line, _) => "the line, parts of it covered three times",
            (Image::Point, _) => "a point",
        };
        lines.push(Entry::remark("image", image));
        lines
    }

    fn portion(&self, portion: &Portion) -> Vec<Entry> {
        let shape = portion.shape.name().replace('_', " ");
        let mut lines = vec![Entry::remark(&format!("segment {}", portion.frame), shape)];
        for feature in &portion.features {
            let place = match place_name(feature.place) {
                "end" => "on an end",
                place => place,
            };
            lines.push(Entry::new(feature.name).with(self.at(&feature.t)).with_remark(place).below());
        }
        if let Some([from, to]) = &portion.straight_ends {
            lines.push(Entry::new("covers").with(self.point(from)).with(self.point(to)).below());
        }
        lines
    }

    /// Coordinates in which the curve has a short equation.
    fn coordinates(&self, cubic: &Cubic) -> Vec<Entry> {
        let letter = self.notation.variable;
        let mut lines = Vec::new();
        let graph = cubic.graph();
        if let Some(rotated) = graph.as_ref().map(|graph| graph.rotated.clone()).or_else(|| cubic.rotated()) {
            let named = |name: &str, list: &[Rational]| format!("{name} = {}", self.notation.univariate(list, letter));
            let mut line = Entry::new("rotated").with(named("u", &rotated.u)).with(named("v", &rotated.v));
            if let Some(right) = cubic.opens_to_the_right() {
                line = line.with_remark(if right { "u opens to the right" } else { "u opens to the left" });
            }
            lines.push(line);
        }
        if let Some(graph) = graph {
            let u = Symbol::new('u', None);
            lines.push(Entry::new("graph").with(format!("v = {}", self.notation.univariate(&graph.coefficients, u))));
        }
        lines.extend(cubic.semi_normal_form().map(|form| self.semi_normal(&form)));
        lines
    }

    fn semi_normal(&self, form: &SemiNormalForm) -> Entry {
        let power = |base: &str, exponent: u32| match self.notation.style {
            Style::Latex => format!("{base}^{{{exponent}}}"),
            Style::Text | Style::Mathematica => format!("{base}^{exponent}"),
        };
        let equation = match form.form {
            CubicClass::SShaped => format!("Y = {}", power("X", 3)),
            CubicClass::Parabolic => format!("Y = {}", power("X", 2)),
            CubicClass::Pointy => format!("{} = {}", power("Y", 2), power("X", 3)),
            CubicClass::Humpy | CubicClass::Loopy | CubicClass::Straight => {
                let sum = self.notation.univariate(&[form.c.clone(), Rational::from(1)], Symbol::new('X', None));
                format!("{} = X {}", power("Y", 2), power(&format!("({sum})"), 2))
            }
        };
        Entry::new("rational form")
            .with(equation)
            .with(format!("X = {}", self.notation.affine(&form.x)))
            .with(format!("Y = {}", self.notation.affine(&form.y)))
    }

    fn normal(&self, normal: &NormalForm) -> Entry {
        let r = Symbol::new('r', None);
        let standard = normal.form.standard().unwrap_or_default();
        let standard = standard.map(|list| self.notation.univariate(&list.map(Rational::from), r));
        let image = self.map(&normal.matrix, &standard, &normal.shift);
        Entry::new("normal form").with(format!("F({}) = {image}", self.substitution(&normal.t0, &normal.scale)))
    }

    /// The argument `t0 + scale r`.
    fn substitution(&self, t0: &Surd, scale: &Surd) -> String {
        self.combination(t0, &[(scale, "r")])
    }

    /// The point `matrix (x, y) + shift`, with these texts for `x` and `y`.
    fn map(&self, matrix: &[[Surd; 2]; 2], [x, y]: &[String; 2], shift: &[Surd; 2]) -> String {
        let rows: Vec<String> =
            [0, 1].map(|i| self.combination(&shift[i], &[(&matrix[i][0], x.as_str()), (&matrix[i][1], y.as_str())])).to_vec();
        printer::point(&rows, self.notation.style)
    }

    /// A sum of multiples of texts and a constant, which comes last.
    fn combination(&self, constant: &Surd, terms: &[(&Surd, &str)]) -> String {
        let mut text = String::new();
        for (factor, name) in terms.iter().copied().chain([(constant, "")]) {
            if factor.is_zero() {
                continue;
            }
            let is_sum = factor.sign() != 0 && factor.rational() != &Rational::from(0);
            let negative = !is_sum && factor.signum() < 0;
            let size = if negative { -factor } else { factor.clone() };
            let printed = self.notation.surd(&size);
            let is_one = printed == "1";
            let name = if name.contains(' ') && (!is_one || negative) { format!("({name})") } else { name.to_owned() };
            let term = match name.as_str() {
                "" => printed,
                _ if is_one => name,
                _ if is_sum => format!("({printed}) {name}"),
                _ => format!("{printed} {name}"),
            };
            text += match (text.is_empty(), negative) {
                (true, false) => "",
                (true, true) => "-",
                (false, false) => " + ",
                (false, true) => " - ",
            };
            text += &term;
        }
        if text.is_empty() { "0".to_owned() } else { text }
    }

    fn distance(&self, distance: &Distance) -> Entry {
        let Some(change) = &distance.change else {
            return Entry::remark("distance", format!("no move of a single coordinate makes this anything but {}", distance.class));
        };
        let coordinate = if change.coordinate == 0 { "x" } else { "y" };
        let ordinal = ["first", "second", "third", "fourth"][change.point.min(3)];
        let label = polar_label(&[("r", distance.degree - change.point), ("s", change.point)]);
        let point = format!("{ordinal} control point {label}");
        let length = change.by.abs();
        let size = if self.notation.decimals.is_some() { String::new() } else { rough(&length) };
        let line = Entry::new("distance").with(format!("{}{size}", self.surd(&length)));
        let direction = if change.grows { "grows" } else { "shrinks" };
        line.with_remark(if length.is_zero() {
            format!("{} as soon as the {coordinate} of the {point} {direction}", change.class)
        } else {
            let by = if change.reached { "if" } else { "if more than" };
            format!("{} {by} the {coordinate} of the {point} {direction} by that", change.class)
        })
    }

    fn intention(&self, intention: &Intention) -> Entry {
        let list: Vec<String> = intention
            .replacements
            .iter()
            .map(|replacement| format!("{} for {}", replacement.meant, decimal(&replacement.given, replacement.decimals as usize)))
            .collect();
        let remark = format!("then the curve would be {}", intention.meant);
        Entry::remark("did you mean", format!("{}? {remark}", list.join(", ")))
    }

    fn equivalence(&self, maps: &Equivalence) -> Vec<Entry> {
        let letter = self.letter();
        let tau = Surd::from(-&maps.t1);
        let shifted = if maps.t1 == Rational::from(0) {
            letter.clone()
        } else {
            format!("({})", self.combination(&tau, &[(&Surd::from(Rational::from(1)), letter.as_str())]))
        };
        let argument = self.combination(&Surd::from(&maps.t0), &[(&maps.scale, shifted.as_str())]);
        let [x, y] = ["x", "y"].map(str::to_owned);
        vec![
            Entry::remark("equivalent", if maps.is_rational() { "yes, by rational maps" } else { "yes" }),
            Entry::new("the other").with(format!("G({letter}) = M(F({argument}))")).below(),
            Entry::new("with").with(format!("M(x, y) = {}", self.map(&maps.matrix, &[x, y], &maps.shift))).below(),
        ]
    }
}

/// A small number by its size, since √ and long fractions do not show it.
fn rough(length: &Surd) -> String {
    let near = length.approximate();
    if length.as_rational().is_some_and(|length| length.bits() <= 20) || !near.is_finite() {
        return String::new();
    }
    if (0.001..1e6).contains(&near) { format!(" ≈ {near:.4}") } else { format!(" ≈ {near:.2e}") }
}

/// The classes of a family.
pub(super) fn family(family: &Family, notation: &Notation) -> Vec<Entry> {
    let polynomial = |value| printer::polynomial(value, &[family.parameter], notation.style);
    let named = |index: &str, value| format!("{} = {}", kappa(index, notation), polynomial(value));
    let invariants = &family.invariants;
    let mut lines = vec![
        Entry::new("invariants")
            .with(named("12", &invariants.kappa12))
            .with(named("23", &invariants.kappa23))
            .with(named("31", &invariants.kappa31)),
        Entry::new("discriminant").with(format!("D = {}", polynomial(&invariants.discriminant()))),
    ];
    let letter = printer::symbol(family.parameter, notation.style);
    // A value that is not `a ± √d` gets a name, and is told behind.
    let name = |index: usize| match &family.breakpoints[index].value {
        AlgebraicNumber::Surd(surd) => notation.surd(surd),
        AlgebraicNumber::Isolated(_) => printer::symbol(Symbol::new(family.parameter.letter(), Some(index as u32 + 1)), notation.style),
    };
    let less = |low: String, high: &str| format!("{low} < {high}");
    for (index, class) in family.between.iter().enumerate() {
        let before = index.checked_sub(1).map(name);
        let after = (index < family.breakpoints.len()).then(|| name(index));
        let range = match (before, after) {
            (None, None) => format!("every {letter}"),
            (None, Some(after)) => less(letter.clone(), &after),
            (Some(before), Some(after)) => less(less(before, &letter), &after),
            (Some(before), None) => format!("{letter} > {before}"),
        };
        lines.push(Entry::new("").with(range).with_remark(class.to_string()));
        if let Some(found) = family.breakpoints.get(index) {
            let surd = match &found.value {
                AlgebraicNumber::Surd(surd) => notation.decimals_of(std::slice::from_ref(surd)),
                AlgebraicNumber::Isolated(_) => String::new(),
            };
            lines.push(Entry::new("").with(format!("{letter} = {}{surd}", name(index))).with_remark(found.class.to_string()));
        }
    }
    for (index, found) in family.breakpoints.iter().enumerate() {
        if matches!(found.value, AlgebraicNumber::Isolated(_)) {
            let value = notation.algebraic(&found.value, family.parameter);
            lines.push(Entry::new("where").with(format!("{} is {value}", name(index))));
        }
    }
    lines
}
