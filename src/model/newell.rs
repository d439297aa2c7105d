//! Newell's patches: nets by indices of common vertices, as the Utah teapot was
//! published (M. Newell, *The Utilization of Procedure Models in Digital Image
//! Synthesis*, 1975).

use super::scanner::{Scanner, Word};
use super::{Flaw, Format, Model, Part};

/// The points of a bicubic net.
const POINTS: usize = 16;

const INDEX: &str = "the index of a vertex, 16 in the line of a patch";
const COORDINATE: &str = "a coordinate, three in the line of a vertex";

/// Reads a file of bicubic patches: their number, a line of 16 indices from 1
/// on for each, row by row (a row belongs to a value of `u`), the number of
/// vertices, and a line of three coordinates for each. Commas or blanks
/// separate.
pub(super) fn read(text: &str) -> Result<Model, Flaw> {
    let mut scanner = Scanner::with_commas(text);
    let count = scanner.count("the number of patches")?;
    let mut nets = Vec::with_capacity(count.min(scanner.left() / (2 * POINTS)));
    for _ in 0..count {
        let at = scanner.peek().map_or(text.len(), |word| word.at);
        let mut net = [0u32; POINTS];
        for (place, index) in net.iter_mut().enumerate() {
            let word = in_line(&mut scanner, place, INDEX)?;
            // Whether there is such a vertex shows at the end of the file.
            let found = word.and_then(Word::whole).filter(|&index| index > 0);
            *index = found.and_then(|index| u32::try_from(index).ok()).ok_or_else(|| scanner.unexpected(word, INDEX))?;
        }
        nets.push((net, at));
    }
    let expected = "the number of vertices in a line of its own, behind the patches";
    let word = in_line(&mut scanner, 0, expected)?;
    let vertices = word.and_then(Word::whole).ok_or_else(|| scanner.unexpected(word, expected))?;
    let mut points = Vec::with_capacity(3 * vertices.min(scanner.left() / 6));
    for _ in 0..vertices {
        for place in 0..3 {
            let word = in_line(&mut scanner, place, COORDINATE)?;
            points.push(scanner.number_in(word, COORDINATE)?);
        }
    }
    scanner.finish()?;

    let mut parts = Vec::with_capacity(nets.len());
    for (net, at) in nets {
        if net.iter().any(|&index| index as usize > vertices) {
            return Err(beyond(&mut scanner, at, vertices));
        }
        let mut coordinates = Vec::with_capacity(3 * POINTS);
        for index in net {
            let end = 3 * index as usize;
            scanner.copies(&points[end - 3..end], at, &mut coordinates)?;
        }
        Part::patch((3, 3), 3, coordinates, scanner.place(at)).add_to(&mut parts)?;
    }
    Ok(Model::of_patches(Format::Newell, parts, scanner.decimals.finest()))
}

/// The next word, which must begin a line if it is the first of its record, and not otherwise.
fn in_line<'a>(scanner: &mut Scanner<'a>, place: usize, expected: &str) -> Result<Option<Word<'a>>, Flaw> {
    match scanner.next() {
        Some(word) if word.starts_line != (place == 0) => Err(Flaw::at(
            scanner.place(word.at),
            if place == 0 {
                format!("the line goes on, expected {expected}")
            } else {
                format!("the line before ends after {place}, expected {expected}")
            },
        )),
        word => Ok(word),
    }
}

/// The first index of a patch that is beyond the vertices.
fn beyond(scanner: &mut Scanner, at: usize, vertices: usize) -> Flaw {
    scanner.go_to(at);
    let mut words = std::iter::from_fn(|| scanner.next());
    let found = words.find(|word| word.whole().is_none_or(|index| index > vertices));
    scanner.unexpected(found, format_args!("an index up to {vertices}, the number of vertices"))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::model::Place;

    const PLANE: &str = "1\n1,2,3,4,5,6,7,8,9,10,11,12,13,14,15,16\n16\n";

    fn plane() -> String {
        let points: Vec<String> = (0..16).map(|k| format!("{}.5,{},0", k / 4, k % 4)).collect();
        PLANE.to_owned() + &points.join("\n")
    }

    #[test]
    fn rows_belong_to_u() {
        let model = read(&plane()).expect("a model");
        let patch = &model.parts[0].piece;
        assert_eq!(patch.points().nth(4).expect("b_10"), ["3/2", "0", "0"].map(|x| x.parse().expect("a number")));
        assert_eq!((model.decimals, model.parts[0].place), (1, Place { line: 2, column: 1 }));
    }

    #[test]
    fn flaws() {
        let flaw = |text: &str| {
            let flaw = read(text).expect_err(text);
            let Place { line, column } = flaw.place.expect("a place");
            (line, column, flaw.message)
        };
        let good = plane();
        for (text, line, column, message) in [
            (String::new(), 1, 1, "the file ends here, expected the number of patches"),
            ("-1\n".into(), 1, 1, "found `-1`, expected the number of patches"),
            (good.replacen(",16\n", ",17\n", 1), 2, 37, "found `17`, expected an index up to 16, the number of vertices"),
            (good.replacen(",16\n", ",0\n", 1), 2, 37, "found `0`, expected the index of a vertex, 16 in the line of a patch"),
            (
                good.replacen(",16\n", "\n", 1),
                3,
                1,
                "the line before ends after 15, expected the index of a vertex, 16 in the line of a patch",
            ),
            (
                good.replacen(",16\n", ",16,1\n", 1),
                2,
                40,
                "the line goes on, expected the number of vertices in a line of its own, behind the patches",
            ),
            (good.replacen(",2,", ",,2,", 1), 2, 3, "found `,`, expected the index of a vertex, 16 in the line of a patch"),
            (
                good.replacen("1\n", "4000000000\n", 1),
                4,
                1,
                "the line before ends after 1, expected the index of a vertex, 16 in the line of a patch",
            ),
            (good.clone() + "\n7", 20, 1, "found `7`, expected the end of the file"),
            (good.replacen("0.5,0,0", "nan,0,0", 1), 4, 1, "found `nan`, expected a coordinate, three in the line of a vertex"),
        ] {
            assert_eq!(flaw(&text), (line, column, message.to_owned()));
        }
    }
}
