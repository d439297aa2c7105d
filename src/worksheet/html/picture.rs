//! Pictures of the nets of a worksheet.

use crate::draw::{CurvePicture, PatchPicture};
use crate::piece::Piece;
use crate::worksheet::report::Picture;

/// The most points of a net that is drawn.
const MAX_POINTS: usize = 400;

/// A picture as an image that the page holds itself; `None` where nothing can be drawn.
pub(super) fn drawn(picture: &Picture) -> Option<String> {
    let weighted = picture.net.weighted;
    let piece = picture.net.numeric().ok()?;
    if piece.points().len() > MAX_POINTS {
        return None;
    }
    let svg = match piece {
        Piece::Curve(segment) if !weighted && segment.degree() > 0 && (2..=3).contains(&segment.dimension()) => {
            let plain = CurvePicture::new(segment);
            match &picture.at {
                Some(t) => plain.with_scheme(t.clone()).svg().ok()?,
                None => plain.svg().ok()?,
            }
        }
        Piece::Curve(_) => return None,
        patch if patch.dimension() - usize::from(weighted) == 3 => PatchPicture::new(patch, weighted).svg().ok()?,
        _ => return None,
    };
    Some(format!("<img alt=\"{}\" src=\"data:image/svg+xml,{}\">", picture.label, encoded(&svg)))
}

/// What a data link may hold.
fn encoded(svg: &str) -> String {
    let mut text = String::with_capacity(svg.len() + svg.len() / 4);
    for byte in svg.bytes() {
        match byte {
            b'%' | b'#' | b'"' | b'<' | b'>' | b'&' | b'\'' | b'\n' | b'\r' | b'\t' | 0x80.. => text.push_str(&format!("%{byte:02X}")),
            _ => text.push(char::from(byte)),
        }
    }
    text
}
