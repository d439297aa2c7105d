//! Worksheets: those that ship with the project, and what becomes of wrong ones.

use std::path::{Path, PathBuf};

use casteljau::worksheet::{Format, Report, check};

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).to_owned()
}

fn report(path: &Path) -> (String, Report) {
    let text = std::fs::read_to_string(path).expect("a readable worksheet");
    let report = check(&text, Format::of_path(&path.to_string_lossy()));
    (text, report)
}

/// The worksheets of the documents that the project is made from.
fn textbooks() -> Vec<PathBuf> {
    let folder = root().join("examples");
    let mut paths: Vec<PathBuf> = std::fs::read_dir(folder)
        .expect("the folder")
        .map(|entry| entry.expect("an entry").path())
        .filter(|path| path.extension().is_some_and(|extension| extension == "md"))
        .collect();
    paths.sort();
    paths
}

fn problems(text: &str, report: &Report) -> Vec<String> {
    let errors = report.errors.iter().map(|error| format!("{}: {error}", error.position(text).0));
    let claims = report.claims.iter().filter(|claim| claim.verdict.name() != "proved").map(|claim| {
        let why = claim.error.as_ref().map_or_else(|| format!("{:?} {:?}", claim.difference, claim.terms), ToString::to_string);
        format!("{}: {} {why}", claim.line, claim.verdict.name())
    });
    errors.chain(claims).collect()
}

#[test]
fn every_worksheet_of_the_project_holds() {
    let mut claims = 0;
    for path in textbooks().into_iter().chain([root().join("tests/worksheets/interface.cj")]) {
        let (text, report) = report(&path);
        assert!(report.holds(), "{}: {:#?}", path.display(), problems(&text, &report));
        claims += report.claims.len();
    }
    assert!(claims > 500, "only {claims} claims");
}

/// What is said of the one claim of a worksheet that fails.
fn diagnosis(source: &str) -> String {
    let report = check(source, Format::Statements);
    assert!(report.errors.is_empty(), "{source}: {:?}", report.errors);
    let mut failed = report.claims.iter().filter(|claim| claim.verdict.name() != "proved");
    let claim = failed.next().unwrap_or_else(|| panic!("nothing fails in {source}"));
    assert!(failed.next().is_none(), "more than one claim fails in {source}");
    assert_eq!(claim.verdict.name(), "refuted", "{source}: {:?}", claim.error);
    claim.diagnosis.clone().unwrap_or_default()
}

const CUBIC: &str = "F(t) = (3/4 t^2 - 3/2 t - 9/4, 3/4 t^3 - 3/2 t^2 - 9/4 t)\n";
const ENNEPER: &str = "S(u,v) = (u - u^3/3 + u v^2, v - v^3/3 + u^2 v, u^2 - v^2)\n";
const ARC: &str = "A = curve([(1,0):1, (1,1):1, (0,1):2], 0..1)\nG(t) = (1 - t^2, 2t) weight 1 + t^2\n";

/// Every usual mistake, one by one: the claim, and what its diagnosis says.
#[test]
fn mistakes_are_recognised() {
    for (definitions, claim, expected) in [
        // A missing 1/C(m,k) of a curve: in one coordinate, in a value, in a net.
        (
            CUBIC,
            "f(t1,t2,t3) == (3/4 (t1 t2 + t1 t3 + t2 t3) - 1/2 (t1 + t2 + t3) - 9/4, 3/4 t1 t2 t3 - 1/2 (t1 t2 + t1 t3 + t2 t3) - 3/4 (t1 + t2 + t3))",
            "coordinate 1: 1/C(3,2) = 1/3 is missing: t^2 becomes the sum of 3 products",
        ),
        (
            CUBIC,
            "f(t1,t2,t3) == (3/4 (t1 t2 + t1 t3 + t2 t3) - 3/2 (t1 + t2 + t3) - 9/4, 3/4 t1 t2 t3 - 3/2 (t1 t2 + t1 t3 + t2 t3) - 9/4 (t1 + t2 + t3))",
            "1/C(m,k) is missing everywhere",
        ),
        ("Q(t) = t^2 + t\n", "q(1, 3) == 3 + 4", "1/C(2,1) = 1/2 is missing: t becomes the sum of 2 products"),
        ("Q(t) = (t, t^2)\n", "points(Q, 0..1) == [(0, 0), (1, 0), (2, 1)]", "1/C(2,1) = 1/2 is missing: t becomes"),
        // Another number: C(4,2) for C(3,2), 2! for the multinomial.
        ("Q(t) = t^3 + 6 t^2\n", "q(t1,t2,t3) == t1 t2 t3 + t1 t2 + t1 t3 + t2 t3", "t^2 is divided by 6: it has 3 products of arguments"),
        // A missing multinomial, and one for C(p,h) C(q,k).
        (
            "X(u,v) = u v^2\n",
            "x((u1,v1),(u2,v2),(u3,v3)) == u1 v2 v3 + u2 v1 v3 + u3 v1 v2",
            "the multinomial 1/(3!/(1! 2! 0!)) = 1/3 is missing",
        ),
        ("X(u,v) = u v degree 2\n", "x((u1,v1),(u2,v2)) == 1/4 (u1 v2 + u2 v1)", "divided by C(m,h) C(m,k)"),
        (
            "X(u,v) = u v + u^2 v^2\n",
            "x(u1,u2; v1,v2) == 1/12 (u1 + u2)(v1 + v2) + u1 u2 v1 v2 / 6",
            "multinomials, which belong to the polar form by the total degree",
        ),
        ("X(u,v) = u v + u^2 v^2\n", "x(u1,u2; v1,v2) == 1/2 (u1 + u2)(v1 + v2) + u1 u2 v1 v2", "is missing"),
        (ENNEPER, "s((1,0),(1,0),(0,1)) == (2/3, 0, 1/3)", ""),
        // A quadratic coordinate of a cubic polarized at 2.
        ("F(t) = (t^2, t^3)\n", "f(t1,t2,t3) == (t1 t2, t1 t2 t3)", "polarized at its own degree"),
        ("F(t) = (t^2, t^3)\n", "f(1,2,3) == (2, 6)", "polarized at its own degree"),
        // r and s exchanged.
        (CUBIC, "f(-1,-1,3) == (-4, -12)", "r and s are exchanged"),
        ("F(t) = (t, t^2 + t)\n", "points(F, 0..2) == [(2, 6), (1, 1), (0, 0)]", "r and s are exchanged"),
        // Nets in another order.
        ("K = curve([(0,0), (1,5), (2,7)], 0..1)\n", "points(K) == [(2,7), (1,5), (0,0)]", "reverse order"),
        (
            ENNEPER,
            "points(S, (1,0), (0,1), (0,0)) == [[(0,0,0), (0,1/3,0), (0,2/3,-1/3), (0,2/3,-1)], [(1/3,0,0), (1/3,1/3,0), (2/3,2/3,-1/3)], [(2/3,0,1/3), (2/3,2/3,1/3)], [(2/3,0,1)]]",
            "",
        ),
        ("X(u,v) = u^2 + 2 v\n", "points(X, (1,0), (0,1), (0,0)) == [[0, 0, 1], [1, 1], [2]]", "the order of the vertices"),
        ("X(u,v) = u^2 + 2 v\n", "points(X, (1,0), (0,1), (0,0)) == [[1], [0, 1], [0, 1, 2]]", "from the other side"),
        ("X(u,v) = u^2 v\n", "points(X, 0..2, 0..1) == [[0, 0, 0], [0, 0, 4]]", "transposed"),
        ("X(u,v) = u + 2 v\n", "points(X, 0..1, 0..1) == [[1, 3], [0, 2]]", "reversed in u"),
        // A sign of κ23 or κ31.
        ("F(t) = (t^2, t^3 + a t)\n", "kappa31(F) == a", ""),
        ("F(t) = (t^3, t^2 + t)\n", "kappa31(F) == -1", "the sign of κ31 is wrong"),
        ("F(t) = (t^2 + t, t^3 - t)\n", "kappa23(F) == -1", "the sign of κ23 is wrong"),
        ("F(t) = (t^2, t^3 - t)\n", "discriminant(F) == -4", ""),
        ("F(t) = (t^2 - t, t^3)\n", "summittime(F) == -1/2", ""),
        // Weights forgotten, or the division by them.
        (ARC, "A(1/2) == (3/4, 3/4)", "the weights are forgotten"),
        (ARC, "G(1/2) == (3/4, 1)", ""),
        (ARC, "points(G, 0..1) == [(1,0), (1,1), (0,1)]", ""),
        (ARC, "A(1/2) == (3/4, 1)", "the division by the weight"),
        // A decimal in the place of a fraction.
        ("", "1/3 == 0.33", "the decimal 0.33 stands for the fraction 1/3"),
        ("F(t) = (t, t^2/3)\n", "F(2) == (2, 1.333)", "the decimal 1.333 stands for the fraction 4/3"),
        ("F(t) = (t/3, t^2/3)\n", "F(2) == (0.67, 1.333)", "0.67 for 2/3, 1.333 for 4/3"),
        // Two values exchanged, a wrong sign, a factor.
        ("F(t) = (t, t^3)\n", "points(F, 0..3) == [(0,0), (2,0), (1,0), (3,27)]", "the entries [1] and [2] are exchanged"),
        ("F(t) = (t, t^2 + 1)\n", "F(2) == (5, 2)", "the coordinates 1 and 2 are exchanged"),
        ("", "(t + 2)^2 == t^2 + 4 + 4 t^2 - 4 t^2 + 4 t + 1 - 1 + 2 t - 2 t + s - s", ""),
        ("", "(2 t + 3)^2 == 4 t^2 + 9 t + 12", "each other's coefficients"),
        ("", "(t - 2)^2 == t^2 + 4 t + 4", "the sign of `4 t` is wrong"),
        (CUBIC, "f(-1,-1,3) == (4, 4)", "the sign of `4` is wrong"),
        ("", "(t + 1)^2 == 2 t^2 + 4 t + 2", "the right side is 2 times the left side"),
    ] {
        if expected.is_empty() {
            continue;
        }
        let source = format!("{definitions}{claim}");
        let found = diagnosis(&source);
        assert!(found.contains(expected), "{claim}\n  expected {expected}\n  found {found:?}");
    }
}

/// A claimed polar form that is none, told apart by the axioms.
#[test]
fn wrong_polar_forms_are_told_apart() {
    for (claim, expected) in [
        ("f(t1,t2) == t1 t2 + t1", "not symmetric: exchanging t1 and t2 changes it"),
        ("f(a1,a2) == a1^2/2 + a2^2/2 + (a1 + a2)/2", "not affine in a1: its degree in it is 2"),
        ("f(t1,t2) == t1 t2 + t1 + t2", "wrong on the diagonal: with equal arguments it is off by t"),
    ] {
        let found = diagnosis(&format!("F(t) = t^2 + t\n{claim}"));
        assert!(found.contains(expected), "{claim}: {found:?}");
    }
    let found = diagnosis("S(u,v) = (u v, u)\ns((u1,v1),(u2,v2)) == (u1 v2, (u1 + u2)/2)");
    assert!(found.contains("coordinate 1 of the claimed form is not symmetric: exchanging (u1,v1) and (u2,v2)"), "{found}");
}

/// Nothing is diagnosed that would not make the claim true.
#[test]
fn what_is_just_wrong_is_not_explained() {
    for source in
        ["F(t) = (t, t^2)\nF(2) == (2, 5)", "1/3 == 0.4", "K = curve([(0,0), (1,5), (2,7)], 0..1)\npoints(K) == [(0,0), (1,5), (2,8)]"]
    {
        assert_eq!(diagnosis(source), "", "{source}");
    }
}

/// The right side of a claim with one thing changed, in all ways: each literal
/// that is not zero made larger by one, each sign turned around.
fn mutants(claim: &str) -> Vec<String> {
    let Some((left, right)) = claim.split_once("==").or_else(|| claim.split_once('=')) else { return Vec::new() };
    let sign = if claim.contains("==") { "==" } else { "=" };
    let mut mutants = Vec::new();
    let bytes = right.as_bytes();
    let mut at = 0;
    while at < bytes.len() {
        let before = right[..at].chars().next_back().unwrap_or(' ');
        let is_index = before.is_alphabetic() || before == '_' || right[..at].ends_with("_{");
        if bytes[at].is_ascii_digit() {
            let length = right[at..].find(|c: char| !(c.is_ascii_digit())).unwrap_or(right.len() - at);
            let number = &right[at..at + length];
            let value: u64 = number.parse().expect("a literal of a textbook");
            if value > 0 && !is_index {
                mutants.push(format!("{left}{sign}{}{}{}", &right[..at], value + 1, &right[at + length..]));
            }
            at += length;
            continue;
        }
        // A name of a claim or of a word may contain digits and hyphens, but not on the right.
        if matches!(bytes[at], b'+' | b'-') {
            let other = if bytes[at] == b'+' { '-' } else { '+' };
            let behind = right[at + 1..].trim_start();
            let is_zero = behind.starts_with('0') && !behind[1..].starts_with(|c: char| c.is_ascii_digit() || c == '.');
            if !is_zero {
                mutants.push(format!("{left}{sign}{}{other}{}", &right[..at], &right[at + 1..]));
            }
        }
        at += right[at..].chars().next().map_or(1, char::len_utf8);
    }
    mutants
}

/// Each mutation of a right worksheet is refuted, or an error, on its line.
#[test]
fn every_mutation_is_refuted() {
    let (mut total, mut survivors) = (0, Vec::new());
    for path in textbooks() {
        let (text, whole) = report(&path);
        // All mutants of a claim go below it, where the same names are defined.
        let mut mutated = String::new();
        let mut expected = Vec::new();
        let mut copied = 0;
        for claim in &whole.claims {
            let source = claim.span.text(&text);
            if ["!=", "<", ">", "\\neq", "\\le", "\\ge"].iter().any(|sign| source.contains(sign)) {
                continue;
            }
            // A formula gets a block of its own, below the one it stands in.
            let is_formula = !source.contains("==");
            let end = if is_formula {
                text[claim.span.end..].find("$$").map_or(text.len(), |length| claim.span.end + length)
            } else {
                claim.span.end
            };
            let line_end = text[end..].find('\n').map_or(text.len(), |length| end + length);
            mutated.push_str(&text[copied.min(line_end)..line_end]);
            copied = copied.max(line_end);
            for mutant in mutants(source) {
                mutated.push_str(if is_formula { "\n\n<!-- casteljau -->\n$$\n" } else { "\n" });
                expected.push((mutated.matches('\n').count() + 1, mutant.clone()));
                mutated.push_str(&mutant);
                if is_formula {
                    mutated.push_str("\n$$\n");
                }
            }
        }
        mutated.push_str(&text[copied..]);
        let report = check(&mutated, Format::of_path(&path.to_string_lossy()));
        let proved: std::collections::HashSet<usize> =
            report.claims.iter().filter(|claim| claim.verdict.name() == "proved").map(|claim| claim.line).collect();
        let failed: std::collections::HashSet<usize> =
            report.claims.iter().filter(|claim| claim.verdict.name() != "proved").map(|claim| claim.line).collect();
        total += expected.len();
        for (line, mutant) in expected {
            if proved.contains(&line) || !failed.contains(&line) {
                survivors.push(format!("{}: {mutant}", path.file_name().unwrap_or_default().to_string_lossy()));
            }
        }
    }
    assert!(survivors.is_empty(), "{} of {total} survive:\n{}", survivors.len(), survivors.join("\n"));
    assert!(total > 3000, "only {total} mutations");
}

/// Worked solutions of curves and surfaces prove themselves, without a warning.
#[test]
fn worked_solutions_hold() {
    use casteljau::syntax::{parse_map, parse_scalars};
    use casteljau::worksheet::{Task, work};
    use casteljau::{Interval, Polynomial, Rational, Rectangle, Triangle};
    let number = |value: i64| Polynomial::from(Rational::from(value));
    let interval = |from: i64, to: i64| Interval::new(number(from), number(to)).expect("a frame");
    let square = || Rectangle::new(interval(0, 1), interval(-1, 1)).into();
    for (map, degree, bidegree, frame, at) in [
        ("(3/4 t^2 - 3/2 t - 9/4, 3/4 t^3 - 3/2 t^2 - 9/4 t)", None, None, Some(interval(-1, 3).into()), Some("1/2")),
        ("(t, a t^2 + 1)", Some(4), None, Some(interval(3, -1).into()), Some("5")),
        ("F(r) = r^2 + 7", None, None, None, None),
        ("(5, 7)", None, None, Some(interval(0, 1).into()), Some("1/3")),
        ("(u - u^3/3 + u v^2, v - v^3/3 + u^2 v, u^2 - v^2)", None, None, Some(Triangle::standard().into()), Some("1/3 1/4")),
        ("(u v, s u + v)", Some(3), None, Some(Triangle::standard().into()), Some("1/3 1/4")),
        ("z = x^3 - 3 x y^2", None, None, Some(square()), Some("1/2 0")),
        ("(u v, u)", None, Some((2, 2)), Some(square()), None),
    ] {
        let at = at.map(|text| parse_scalars(text).expect("numbers"));
        let task = Task { map: parse_map(map, None).expect("a map"), degree, bidegree, frame, at };
        let text = work(&task).unwrap_or_else(|error| panic!("{map}: {error}"));
        let report = check(&text, Format::Markdown);
        assert!(report.holds() && !report.claims.is_empty(), "{map}: {:#?}\n{text}", problems(&text, &report));
        assert!(report.warnings.is_empty(), "{map}: {:?}", report.warnings);
    }
}

/// So do the solutions of exercises, and the same seed gives the same ones.
#[test]
fn solutions_of_exercises_hold() {
    use casteljau::worksheet::{Exercise, exercises};
    for kind in Exercise::ALL {
        for seed in 0..6 {
            let made = exercises(kind, seed, 14).expect("exercises");
            let report = check(&made.solutions, Format::Markdown);
            assert!(report.holds() && report.claims.len() >= 14, "{kind:?} {seed}: {:#?}", problems(&made.solutions, &report));
            assert_eq!(made, exercises(kind, seed, 14).expect("exercises"));
            assert!(made.exercises.matches("**").count() == 28 && !made.exercises.contains("casteljau -->"));
        }
        assert_ne!(exercises(kind, 1, 3), exercises(kind, 2, 3));
    }
}

/// The first thing that is said of a worksheet: a claim's error or another one.
fn complaint(source: &str) -> (usize, String) {
    let report = check(source, Format::Statements);
    let claims = report.claims.iter().filter_map(|claim| claim.error.as_ref());
    let error = report.errors.iter().chain(claims).min_by_key(|error| error.span).unwrap_or_else(|| panic!("no error in {source}"));
    (error.position(source).0, format!("{error}{}", error.help.as_ref().map_or_else(String::new, |help| format!(" | {help}"))))
}

/// Every error of the language, on the line where it is.
#[test]
fn errors_say_where_and_what() {
    for (source, line, expected) in [
        // Definitions.
        ("F(t) = t\nF(t) = t^2", 2, "found a second definition of `F`, which line 1 defines"),
        ("F(t) = (t, 1)\nF_1(t) = t^2", 2, "found a second definition of `F1`, which line 1 defines"),
        ("F_1(t) = t\nF_3(t) = t\nF(1) == (1, 1)", 2, "found a definition of `F_3` but none of `F_2`"),
        ("F(1) == 2\nF(t) = t", 1, "found `F` before its definition in line 2"),
        ("f(1, 2) == 2\nF(t) = t^2", 1, "found `F` before its definition in line 2 | move the definition up"),
        ("a == 2\na = 2", 1, "found `a` before its definition in line 2"),
        ("a = b + 1\nb = c\nc = 2 a", 1, "found `b`, which is defined by itself: a → b → c → a"),
        ("a = a + 1", 1, "defined by itself: a → a"),
        ("t = 1\nF(t) = t^2", 2, "found the variable `t`, which is a name already"),
        ("p(t) = t^2", 1, "found a map named `p`, expected a capital letter | write `P`"),
        ("F(t) = t^2\nf(1) = 2", 2, "found `=` behind a value, expected `==` | `=` defines, `==` claims"),
        ("F(t) = t^3 degree 2", 1, "polar degree 2 is too low"),
        ("F(t,u,v) = t", 1, "found 3 variables"),
        ("x: a = 2", 1, "found the name `x` before a definition"),
        // Claims.
        ("1 + 1", 1, "expected an operator, or `==` and another value"),
        ("1 == (1, 2)", 1, "found a number and a point with 2 coordinates, expected two values of one kind"),
        ("a < 2", 1, "found the symbolic parameter `a`, expected numbers on both sides of `<`"),
        ("F(t) = t^2\nf(1) == 2", 2, "expected 2 polar arguments, found 1"),
        ("F(t) = t^2\nF(1, 2) == 2", 2, "expected 1 parameters, found 2"),
        ("F(t) = t^2\npoints(F) == [1]", 2, "found a curve, expected a net with its frame | `points(F, r..s)` is the net of a curve"),
        ("F(t) = t^2\npoints(F, 1..1) == [1]", 2, "the frame 1..1 is degenerate"),
        ("pionts(1) == 1", 1, "found `pionts`, which is no function | did you mean `points`?"),
        ("points == 1", 1, "found the function `points` without its arguments | write `points(F, r..s)`"),
        ("F(t) = (t^2, t^3)\nclass(F) == poinnty", 2, "did you mean `pointy` by `poinnty`?"),
        ("F(t) = (t, t^2)\ncusp(F) == (0, 0)", 2, "this curve has no cusp: its class is parabolic"),
        ("F(t) = (t, a t^3)\nclass(F) == s_shaped", 2, "this needs numbers, found the symbolic parameter `a`"),
        ("1 == (1", 1, "found `(` without a closing `)`"),
        ("1 == 1)", 1, "found `)` without an opening bracket"),
        ("1/0 == 1", 1, "found a division by zero"),
        ("(a+b+c+d)^200 == 1", 1, "expected at most"),
        ("[1, 2][2] == 1", 1, "found the entry 2, expected one from 0 to 1"),
        ("√-1 == 1", 1, "expected"),
    ] {
        let (found_line, found) = complaint(source);
        assert!(found.contains(expected), "{source}\n  expected {expected}\n  found {found}");
        assert_eq!(found_line, line, "{source}: {found}");
    }
}

/// What the warnings are about.
#[test]
fn warnings() {
    let report = check("a = 1\nb = 2\nb == 2\n1 == 1\nF(t) = t", Format::Statements);
    let codes: Vec<&str> = report.warnings.iter().map(|warning| warning.code).collect();
    assert_eq!(codes, ["W101", "W102", "W101"]);
    assert!(report.holds());
    // As of errors, only so many are listed, and the last says so.
    let report = check(&"x == x\n".repeat(60_000), Format::Statements);
    let last = report.warnings.last().map(|warning| warning.error.message.as_str());
    assert_eq!((report.warnings.len(), report.claims.len(), report.holds()), (2001, 60_000, true));
    assert_eq!(last, Some("found more than 2000 warnings above, and none is listed from here on"));
}

/// Formulas as textbooks print them are read as they stand.
#[test]
fn textbook_formulas() {
    let source = r"<!-- casteljau -->
$$F_1(t) = \frac{3}{4}t^2 - \frac{3}{2}t - \frac{9}{4}, \qquad F_2(t) = \frac{3}{4}t^3 - \frac{3}{2}t^2 - \frac{9}{4}t.$$

<!-- casteljau -->
```math
f_1(t_1, t_2, t_3) = \frac{1}{4}(t_1t_2 + t_1t_3 + t_2t_3) - \frac{1}{2}(t_1 + t_2 + t_3) - \frac{9}{4}
```

<!-- casteljau -->
$$\begin{aligned}
f(-1, -1, 3) &= (-4, 4) \\
f(-1, 3, 3) &\neq (-4, 4), \qquad F_1(1) < 0
\end{aligned}$$

<!-- casteljau -->
$$x(t) = t^2 + 1, \quad x(2) = 5 = 4 + 1$$
";
    let report = check(source, Format::Markdown);
    assert!(report.holds(), "{:#?}", problems(source, &report));
    assert_eq!(report.claims.len(), 5);
    let lines: Vec<usize> = report.claims.iter().map(|claim| claim.line).collect();
    assert_eq!(lines, [6, 11, 12, 12, 16]);
}

/// Any text gets an answer: pieces of worksheets in any order, and what is no worksheet at all.
#[test]
fn strangers() {
    use proptest::prelude::*;
    use proptest::test_runner::{Config, TestRunner};
    let piece = "(```casteljau\n|```\n|```math\n|<!-- casteljau -->\n|\\$\\$|F\\(t\\) = |f\\(|points\\(F, 0..1\\)|==|!=|=|\\(|\\)|\\[|\\]|,|;|:|#|\n|\r\n|\t|\u{feff}|t|1/2|2|√2|\\^|degree 4|class|curve\\(\\[|> |- |\\\\frac\\{1\\}\\{2\\}|\\\\\\\\|&| )";
    let text = proptest::collection::vec(proptest::string::string_regex(piece).expect("a pattern"), 0..40);
    let mut runner = TestRunner::new(Config::with_cases(400));
    let outcome = runner.run(&text, |pieces| {
        let source = pieces.concat();
        for format in [Format::Markdown, Format::Statements] {
            let report = check(&source, format);
            for error in report.errors.iter().chain(report.claims.iter().filter_map(|claim| claim.error.as_ref())) {
                prop_assert!(error.span.start <= error.span.end && error.span.end <= source.len(), "{error:?}");
            }
            prop_assert!(casteljau::worksheet::html("x", &source, format).ends_with("</html>\n"));
        }
        Ok(())
    });
    if let Err(error) = outcome {
        panic!("{error}");
    }
}

/// Short texts that ask for very much: each ends at a limit that says what to do.
#[test]
fn strangers_who_ask_for_much() {
    let doubled = |first: &str, next: &dyn Fn(usize) -> String, count: usize| {
        let lines = (1..count).map(|k| format!("A{} = {}\n", k + 1, next(k)));
        format!("A1 = {first}\n{}", lines.collect::<String>())
    };
    let pairs = doubled("[1, 2]", &|k| format!("[A{k}, A{k}]"), 40);
    let nested = doubled("[1]", &|k| format!("[A{k}]"), 8000);
    let wide = format!("A = [1]\nB = [{}]", vec!["A"; 300_000].join(","));
    let long = "9".repeat(9_999);
    let numbers = format!("{long} == {long}\n").repeat(250);
    let hundred = vec!["1"; 100].join(",");
    let held = (0..30).map(|k| format!("B{k} = [{}]\n", vec!["A"; 500].join(","))).collect::<String>();
    let held = format!("A = [{hundred}]\n{held}");
    for (source, expected) in [
        (&pairs, "found a list of more than 65536 numbers and terms, expected at most 65536 | write shorter lists"),
        (&nested, "found lists nested more than 128 deep, expected at most 128 | write one list with all entries"),
        (&wide, "found a list of more than 65536"),
        (
            &numbers,
            "found statements above that take more than 40000000 steps together, and nothing is read from here on | split the worksheet",
        ),
        (&held, "found definitions of more than 524288 numbers and terms together, expected at most 524288 | split the worksheet"),
    ] {
        let report = check(source, Format::Statements);
        let claims = report.claims.iter().filter_map(|claim| claim.error.as_ref());
        let shown = |error: &casteljau::syntax::SyntaxError| format!("{error} | {}", error.help.as_deref().unwrap_or_default());
        let found: Vec<String> = report.errors.iter().chain(claims).map(shown).collect();
        assert!(found.iter().any(|error| error.contains(expected)), "{:.60}\n  expected {expected}\n  found {:?}", source, found.first());
    }
}

/// Entries of entries go as deep as lists do, and no further.
#[test]
fn long_rows_of_entries() {
    let list = format!("{}7{}", "[".repeat(100), "]".repeat(100));
    assert!(check(&format!("L = {list}\nL{} == 7", "[0]".repeat(100)), Format::Statements).holds());
    for list in ["L", "[[1, 2]]", "(1, 2)"] {
        let (line, found) = complaint(&format!("L = [[1, 2]]\nL == L\n{list}{} == 1", "[1]".repeat(8000)));
        assert!(line == 3 && found.contains("found "), "{list}: {found}");
    }
    assert_eq!(complaint("L = [[1, 2]]\nL[0][1][0] == 1"), (2, "found a number, expected a list, a net or a point".into()));
}

/// What is long and yet honest passes.
#[test]
fn long_worksheets_hold() {
    let claims = (0..4000).map(|k| format!("f({k}, {}, -1) == ({}, {})\n", k + 1, -k * k - k, 6 * k + 4));
    let source = format!("F(t) = (t^3, 9 t + 4)\n{}", claims.collect::<String>());
    let report = check(&source, Format::Statements);
    assert!(report.holds() && report.claims.len() == 4000, "{:#?}", problems(&source, &report).first());
}
