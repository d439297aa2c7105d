//! Control nets and the steps of de Casteljau's algorithm.

use super::Page;
use crate::affine::{Frame, Interval};
use crate::kernel::coefficient::Coefficient;
use crate::piece::Piece;
use crate::scheme::Scheme;
use crate::value::Layers;

impl<C: Coefficient> Page<'_, C> {
    pub(super) fn net(&mut self, piece: &Piece<C>) {
        let labels = piece.labels();
        let width = labels.iter().map(|label| label.chars().count()).max().unwrap_or(0);
        for (label, point) in labels.iter().zip(piece.points()) {
            self.lines.push(format!("{label:width$} = {}", self.point(point, true)));
        }
    }

    pub(super) fn piece(&mut self, piece: &Piece<C>) {
        self.lines.push(format!("over {}:", self.notation.frame(&piece.frame())));
        self.indented(|page| page.net(piece));
    }

    pub(super) fn indented(&mut self, write: impl FnOnce(&mut Self)) {
        let start = self.lines.len();
        write(self);
        for line in &mut self.lines[start..] {
            line.insert_str(0, "  ");
        }
    }

    pub(super) fn frame(&mut self, title: &str, frame: &Frame<C>) {
        let numbers: Vec<String> = frame.numbers().into_iter().map(|number| self.notation.number(number)).collect();
        self.lines.push(match frame {
            Frame::Triangle(_) => {
                format!("r = ({}, {}), s = ({}, {}), t = ({}, {})", numbers[0], numbers[1], numbers[2], numbers[3], numbers[4], numbers[5])
            }
            _ => format!("{title}: {}", self.notation.frame(frame)),
        });
    }

    pub(super) fn matrix(&mut self, title: &str, rows: &[Vec<C>]) {
        let cells: Vec<Vec<String>> = rows.iter().map(|row| row.iter().map(|number| self.notation.number(number)).collect()).collect();
        let columns = cells.first().map_or(0, Vec::len);
        let widths: Vec<usize> = (0..columns).map(|k| cells.iter().map(|row| row[k].chars().count()).max().unwrap_or(0)).collect();
        self.lines.push(format!("{title}:"));
        for row in cells {
            let padded: Vec<String> = row.iter().zip(&widths).map(|(cell, &width)| format!("{cell:>width$}")).collect();
            self.lines.push(format!("  [ {} ]", padded.join("  ")));
        }
    }

    /// The steps on a patch: under a heading for each layer its rows, aligned.
    pub(super) fn layers(&mut self, layers: &Layers<C>) {
        for (number, layer) in layers.layers.iter().enumerate() {
            let cell = |(label, point): &(String, Vec<C>)| format!("{label} = {}", self.point(point, true));
            let cells: Vec<Vec<String>> = layer.iter().map(|row| row.iter().map(cell).collect()).collect();
            let columns = cells.iter().map(Vec::len).max().unwrap_or(0);
            let width = |column: usize| cells.iter().filter_map(|row| row.get(column)).map(|text| text.chars().count()).max().unwrap_or(0);
            let widths: Vec<usize> = (0..columns).map(width).collect();
            let fits = widths.iter().sum::<usize>() + 3 * columns <= 160;
            self.lines.push(format!("{} {number}:", layers.name));
            for row in cells {
                if !fits {
                    self.lines.extend(row.into_iter().map(|text| format!("  {text}")));
                    continue;
                }
                let mut line = String::from(" ");
                for (text, &width) in row.iter().zip(&widths) {
                    line += &format!(" {text}");
                    line.extend(std::iter::repeat_n(' ', width + 2 - text.chars().count()));
                }
                self.lines.push(line.trim_end().to_owned());
            }
        }
    }

    /// Whether the parameter of a scheme lies in the closed frame, so that all
    /// points are convex combinations; symbols do not tell.
    pub(super) fn is_inside(&self, scheme: &Scheme<C>) -> Option<bool> {
        let frame = scheme.frame();
        let frame = Interval::new(frame.r().as_rational()?, frame.s().as_rational()?).ok()?;
        Some(frame.contains(&scheme.parameter().as_rational()?))
    }

    /// The triangular scheme: a column a step, each point between the two it comes from.
    pub(super) fn scheme(&mut self, scheme: &Scheme<C>) {
        let degree = scheme.degree();
        let cell = |i: usize, j: usize| format!("{} = {}", scheme.label(i, j), self.point(scheme.get(i, j), true));
        let columns: Vec<Vec<String>> = (0..=degree).map(|j| (0..=degree - j).map(|i| cell(i, j)).collect()).collect();
        let widths: Vec<usize> = columns.iter().map(|column| column.iter().map(|text| text.chars().count()).max().unwrap_or(0)).collect();
        let frame = format!(
            "r = {}, s = {}, t = {}",
            self.notation.number(scheme.frame().r()),
            self.notation.number(scheme.frame().s()),
            self.notation.number(scheme.parameter())
        );
        let frame = match self.is_inside(scheme) {
            Some(true) => format!("{frame} (inside the frame)"),
            Some(false) => format!("{frame} (outside the frame)"),
            None => frame,
        };
        self.lines.push(frame);
        if widths.iter().sum::<usize>() > 160 {
            // Too wide for a triangle: one step after the other.
            for (j, column) in columns.iter().enumerate() {
                self.lines.push(format!("step {j}:"));
                self.lines.extend(column.iter().map(|text| format!("  {text}")));
            }
            return;
        }
        for row in 0..=2 * degree {
            let mut line = String::new();
            for (j, column) in columns.iter().enumerate() {
                let text = match row.checked_sub(j) {
                    Some(offset) if offset % 2 == 0 => column.get(offset / 2).map_or("", String::as_str),
                    _ => "",
                };
                line += text;
                line.extend(std::iter::repeat_n(' ', widths[j] + 3 - text.chars().count()));
            }
            self.lines.push(line.trim_end().to_owned());
        }
    }
}
