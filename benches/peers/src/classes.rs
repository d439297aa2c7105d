//! The classes of planar cubics from integer control points, with FLINT's integers.

use casteljau::CubicClass;

use crate::flint::{Flint, Fmpz, Integers};

/// The control points `x0, y0, …, x3, y3` of many cubics as FLINT's integers.
pub struct Polygons {
    coordinates: Integers,
    pub count: usize,
}

impl Polygons {
    /// The coordinates are below `2^61`, so each is a word.
    pub fn new(flint: &'static Flint, cubics: &[[i64; 8]]) -> Polygons {
        let coordinates = Integers::new(flint, 8 * cubics.len());
        for (index, &value) in cubics.iter().flatten().enumerate() {
            // SAFETY: inside the vector, and a small value is the word itself.
            unsafe { *coordinates.at(index) = value as Fmpz }
        }
        Polygons { coordinates, count: cubics.len() }
    }
}

/// The class of each cubic: three determinants of edges, and the sign of `B² - 4AC`
/// (the formulas of casteljau's own `classify_array`). The temporary integers are made once.
pub fn classes(flint: &'static Flint, polygons: &Polygons) -> Vec<CubicClass> {
    let room = Integers::new(flint, 12);
    let [edges, dets, sums] = [0, 6, 9].map(|start| move |index: usize| start + index);
    let at = |index: usize| room.at(index);
    (0..polygons.count)
        .map(|cubic| {
            let point = |index: usize| polygons.coordinates.at(8 * cubic + index);
            // SAFETY: all places are inside the two vectors, and initialised.
            unsafe {
                for index in 0..6 {
                    flint.fmpz_sub(at(edges(index)), point(index + 2), point(index));
                }
                for (det, [i, j]) in [[0, 1], [0, 2], [1, 2]].into_iter().enumerate() {
                    let edge = |edge: usize, axis: usize| at(edges(2 * edge + axis));
                    flint.fmpz_fmms(at(dets(det)), edge(i, 0), edge(j, 1), edge(i, 1), edge(j, 0));
                }
                let [a, b, c] = [0, 1, 2].map(|det| at(dets(det)));
                // κ23 = 3 (A - B + C)
                flint.fmpz_sub(at(sums(0)), a, b);
                flint.fmpz_add(at(sums(0)), at(sums(0)), c);
                if *at(sums(0)) != 0 {
                    flint.fmpz_mul(at(sums(1)), b, b);
                    flint.fmpz_mul(at(sums(2)), a, c);
                    flint.fmpz_mul_ui(at(sums(2)), at(sums(2)), 4);
                    return match flint.fmpz_cmp(at(sums(1)), at(sums(2))) {
                        0 => CubicClass::Pointy,
                        sign if sign > 0 => CubicClass::Humpy,
                        _ => CubicClass::Loopy,
                    };
                }
                // κ31 = 3 (2A - B)
                flint.fmpz_add(at(sums(1)), a, a);
                match (flint.fmpz_cmp(at(sums(1)), b) == 0, *a == 0) {
                    (false, _) => CubicClass::SShaped,
                    (true, false) => CubicClass::Parabolic,
                    (true, true) => CubicClass::Straight,
                }
            }
        })
        .collect()
}
