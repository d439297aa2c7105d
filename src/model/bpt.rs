//! Rectangular patches one after the other, each with its degrees: the format
//! in which the Newell tea set is handed around.

use super::scanner::Scanner;
use super::{Flaw, Format, Model, Part};

/// Reads the number of patches, and for each its degrees in `u` and `v` and its
/// points `x y z`, row by row; a row belongs to a value of `u`.
pub(super) fn read(text: &str) -> Result<Model, Flaw> {
    let mut scanner = Scanner::new(text);
    let count = scanner.count("the number of patches")?;
    let mut parts = Vec::with_capacity(count.min(scanner.left() / 10));
    for _ in 0..count {
        let place = scanner.here();
        let p = scanner.degree("the degree of a patch in u")?;
        let q = scanner.degree("the degree of a patch in v")?;
        let coordinates = scanner.points((p + 1) * (q + 1), 3)?;
        Part::patch((p, q), 3, coordinates, place).add_to(&mut parts)?;
    }
    scanner.finish()?;
    Ok(Model::of_patches(Format::Bpt, parts, scanner.decimals.finest()))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::model::Place;

    const TWO: &str = "2\n1 1\n0 0 0\n0 1 0.25\n1 0 0\n1 1 1.\n1 0\n0 0 0\n0 -1 1e-3\n";

    #[test]
    fn rows_belong_to_u() {
        let model = read(TWO).expect("a model");
        assert_eq!(model.parts[0].piece.points().nth(1).expect("b_01")[2].to_string(), "1/4");
        assert_eq!(model.parts[0].piece.points().nth(3).expect("b_11")[2].to_string(), "1");
        assert_eq!((model.parts.len(), model.decimals, model.parts[1].place), (2, 3, Place { line: 7, column: 1 }));
    }

    #[test]
    fn flaws() {
        for (text, line, column, message) in [
            ("", 1, 1, "the file ends here, expected the number of patches"),
            (
                "2\n1 1\n0 0 0\n0 1 0\n1 0 0\n1 1 1\n",
                6,
                6,
                "the file ends here, expected the degree of a patch in u, a whole number up to 4096",
            ),
            ("1\n0 1\n0 0 0\n0 1\n", 4, 4, "the file ends here, expected a coordinate, 3 for each of 2 points"),
            ("1\n0 1\n0 0 0\n0 NaN 1\n", 4, 3, "found `NaN`, expected a coordinate, 3 for each of 2 points"),
            ("1\n1000000000 1\n", 2, 1, "found `1000000000`, expected the degree of a patch in u, a whole number up to 4096"),
            ("1\n3 -3\n", 2, 3, "found `-3`, expected the degree of a patch in v, a whole number up to 4096"),
            ("0\n0\n", 2, 1, "found `0`, expected the end of the file"),
            ("4000000000\n4096 4096\n1 2 3", 3, 6, "the file ends here, expected a coordinate, 3 for each of 16785409 points"),
            (
                "1\n0 0\n1 2 1e999999999",
                3,
                5,
                "found `1e999999999`, expected a coordinate, 3 for each of 1 points: a number may have at most 10000 digits",
            ),
        ] {
            let flaw = read(text).expect_err(text);
            assert_eq!((flaw.place, flaw.message.as_str()), (Some(Place { line, column }), message));
        }
    }
}
