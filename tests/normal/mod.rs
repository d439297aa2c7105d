//! Normal forms are not unique, so they are compared by what they say.

use casteljau::{Rational, Surd};
use serde_json::Value;

fn rational(value: &Value) -> Rational {
    value.as_str().expect("a number is a string").parse().expect("a number")
}

fn surd(value: &Value) -> Surd {
    let sign = value["sgn"].as_i64().expect("a sign") as i8;
    let surd = Surd::new(rational(&value["a"]), sign, rational(&value["rad"])).expect("a radicand");
    assert_eq!(surd.sign(), sign, "squares are folded");
    surd
}

/// The standard cubics of the lecture, at `r`.
fn standard(form: &str, r: i64) -> [Rational; 2] {
    let (x, y) = match form {
        "humpy" => (r * r, r * r * r + r),
        "loopy" => (r * r, r * r * r - r),
        "pointy" => (r * r, r * r * r),
        "s_shaped" => (r, r * r * r),
        "parabolic" => (r, r * r),
        other => panic!("there is no standard cubic for {other}"),
    };
    [Rational::from(x), Rational::from(y)]
}

/// Whether `F(t0 + scale r) = A standard(r) + b`, tried at more values of `r`
/// than two different cubics can agree in.
pub(crate) fn check(curve: &Value, found: &Value, expected: &Value) {
    assert_eq!(found.is_object(), expected.is_object(), "a normal form of {curve}");
    for normal in [found, expected].into_iter().filter(|normal| normal.is_object()) {
        let (t0, scale) = (surd(&normal["t0"]), surd(&normal["scale"]));
        assert!(!scale.is_zero());
        let entry = |i: usize, j: usize| surd(&normal["A"][i][j]);
        let determinant = entry(0, 0).times(&entry(1, 1)).zip(entry(0, 1).times(&entry(1, 0))).and_then(|(a, b)| a.minus(&b));
        assert!(determinant.is_some_and(|determinant| !determinant.is_zero()));
        for r in -2..4 {
            let t = t0.plus(&scale.times_rational(&Rational::from(r))).expect("one field");
            let [x, y] = standard(normal["form"].as_str().expect("a name"), r);
            for index in 0..2 {
                let coefficients: Vec<Rational> = curve["coeffs"][index].as_array().expect("a list").iter().map(rational).collect();
                let (first, second) = (entry(index, 0).times_rational(&x), entry(index, 1).times_rational(&y));
                let right = first.plus(&second).and_then(|sum| sum.plus(&surd(&normal["b"][index]))).expect("one field");
                assert_eq!(t.evaluate(coefficients.iter()), right, "{curve} at {r}");
            }
        }
    }
}
