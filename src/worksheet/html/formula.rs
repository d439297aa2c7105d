//! LaTeX to MathML.

use pulldown_latex::config::{DisplayMode, RenderConfig};
use pulldown_latex::{Parser, Storage, push_mathml};

use crate::report::xml::escape;

/// Where a formula stands.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Display {
    Inline,
    Block,
}

/// A formula as MathML; as its text where it is not understood.
pub(super) fn mathml(latex: &str, display: Display) -> String {
    let storage = Storage::new();
    let parsed: Result<Vec<_>, _> = Parser::new(latex, &storage).collect();
    let Ok(events) = parsed else { return format!("<code>{}</code>", escape(latex)) };
    let display_mode = if display == Display::Block { DisplayMode::Block } else { DisplayMode::Inline };
    let config = RenderConfig { display_mode, ..RenderConfig::default() };
    let mut text = String::new();
    let whole = events.into_iter().map(Ok::<_, std::convert::Infallible>);
    match push_mathml(&mut text, whole, config) {
        Ok(()) => text,
        Err(_) => format!("<code>{}</code>", escape(latex)),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn formulas_and_what_is_none() {
        assert!(mathml(r"\frac{1}{2} t_{1}", Display::Inline).contains("<mfrac>"));
        assert_eq!(mathml(r"\frac{<", Display::Inline), r"<code>\frac{&lt;</code>");
    }
}
