//! A large model to measure with: bicubic patches of one B-spline surface,
//! printed with six decimals as programs print them.
//!
//! `cargo run --release --example large_model -- 100000 > large.bv`, then
//! `time casteljau check --require G1 --tolerance 0.01deg large.bv`.
//!
//! The surface is C2; the printed patches are not, because they are rounded.

use std::io::{self, Write};

/// Control points in millionths of a unit: a grid with hills, and some roughness.
fn control(i: i64, j: i64) -> [i64; 3] {
    // A sequence without a period that matters: no two patches are alike.
    let mut state = (i.wrapping_mul(0x9E37_79B9) ^ j.wrapping_mul(0x85EB_CA6B)) as u64;
    state = (state ^ (state >> 15)).wrapping_mul(0x2545_F491_4F6C_DD1D);
    let rough = (state >> 44) as i64 % 100_000;
    let hill = |k: i64| (k % 200 - 100).abs() * 20_000;
    [i * 370_000 + rough / 3, j * 410_000 - rough / 5, hill(i) + hill(j + 50) + rough]
}

/// The Bézier points, times 6, of the piece of a uniform cubic B-spline with these de Boor points.
fn bezier(d: [i64; 4]) -> [i64; 4] {
    [d[0] + 4 * d[1] + d[2], 4 * d[1] + 2 * d[2], 2 * d[1] + 4 * d[2], d[1] + 4 * d[2] + d[3]]
}

fn main() -> io::Result<()> {
    let count: i64 = std::env::args().nth(1).and_then(|text| text.parse().ok()).unwrap_or(10_000);
    let side = (1..).find(|side| side * side >= count).unwrap_or(1);
    let mut out = io::BufWriter::new(io::stdout().lock());
    for patch in 0..count {
        let (i, j) = (patch / side, patch % side);
        writeln!(out, "5\n3 3")?;
        let coordinates = [0, 1, 2].map(|axis| {
            let rows: [[i64; 4]; 4] = [0, 1, 2, 3].map(|k| bezier([0, 1, 2, 3].map(|l| control(i + k, j + l)[axis])));
            let columns: [[i64; 4]; 4] = [0, 1, 2, 3].map(|l: usize| bezier(rows.map(|row| row[l])));
            // Rounded to the last digit that is printed.
            columns.map(|column| column.map(|number| (number + 18).div_euclid(36)))
        });
        let points = (0..4).flat_map(|k| (0..4).map(move |l| coordinates.map(|columns| columns[l][k])));
        for point in points {
            let [x, y, z] = point.map(|number| {
                let sign = if number < 0 { "-" } else { "" };
                format!("{sign}{}.{:06}", number.abs() / 1_000_000, number.abs() % 1_000_000)
            });
            writeln!(out, "{x} {y} {z}")?;
        }
    }
    out.flush()
}
