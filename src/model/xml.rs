//! The elements of an XML document with their places.

use std::borrow::Cow;

use quick_xml::Reader;
use quick_xml::events::{BytesStart, Event};

use super::place::{Flaw, Place, Places};

/// The tags of a document, one after the other. Nothing is kept of what was
/// passed, entities that the document declares are not expanded, and depth
/// costs no stack.
pub(super) struct Tags<'a> {
    text: &'a str,
    reader: Reader<&'a [u8]>,
    places: Places<'a>,
    depth: usize,
    has_root: bool,
}

/// The beginning or the end of an element.
pub(super) enum Tag<'a> {
    Start(Element<'a>),
    /// With the name, without its prefix.
    End(String),
}

/// The start tag of an element.
pub(super) struct Element<'a> {
    text: &'a str,
    tag: BytesStart<'a>,
    /// The byte of its `<`.
    pub(super) at: usize,
    /// How many elements it is in; 0 for the root.
    pub(super) depth: usize,
}

/// The value of an attribute.
pub(super) struct Attribute<'a> {
    pub(super) value: Cow<'a, str>,
    /// The byte where the value begins.
    pub(super) at: usize,
    /// Whether the value stands in the file as it is, so that its bytes have places.
    pub(super) is_verbatim: bool,
}

/// Where a part of a text begins in it.
fn offset(text: &str, part: &str) -> usize {
    (part.as_ptr() as usize).saturating_sub(text.as_ptr() as usize)
}

impl<'a> Tags<'a> {
    pub(super) fn new(text: &'a str) -> Self {
        let mut reader = Reader::from_str(text);
        reader.config_mut().expand_empty_elements = true;
        Self { text, reader, places: Places::new(text), depth: 0, has_root: false }
    }

    /// The place of a byte of the document.
    pub(super) fn place(&mut self, at: usize) -> Place {
        self.places.of(at)
    }

    pub(super) fn places(&self) -> &Places<'a> {
        &self.places
    }

    /// The next tag, if there is one.
    pub(super) fn next(&mut self) -> Result<Option<Tag<'a>>, Flaw> {
        loop {
            let event = self.reader.read_event();
            match event {
                Ok(Event::Start(tag)) => {
                    let at = offset(self.text, &tag).saturating_sub(1);
                    if self.depth == 0 && self.has_root {
                        return Err(Flaw::expected(
                            self.place(at),
                            &format!("<{}>", tag.name().as_ref()),
                            "the end of the file behind the root element",
                        ));
                    }
                    let element = Element { text: self.text, tag, at, depth: self.depth };
                    self.depth += 1;
                    self.has_root = true;
                    return Ok(Some(Tag::Start(element)));
                }
                Ok(Event::End(tag)) => {
                    self.depth = self.depth.saturating_sub(1);
                    return Ok(Some(Tag::End(tag.local_name().as_ref().to_owned())));
                }
                Ok(Event::Eof) if self.depth > 0 => {
                    return Err(Flaw::at(self.place(self.text.len()), "the file ends inside of an element, expected its end tag"));
                }
                Ok(Event::Eof) if !self.has_root => {
                    return Err(Flaw::at(self.place(self.text.len()), "found no element, expected an XML document"));
                }
                Ok(Event::Eof) => return Ok(None),
                Ok(_) => {}
                Err(error) => {
                    let at = usize::try_from(self.reader.error_position()).unwrap_or(usize::MAX);
                    return Err(Flaw::at(self.place(at), format!("not well-formed XML: {error}")));
                }
            }
        }
    }
}

impl<'a> Element<'a> {
    /// The name, without its prefix.
    pub(super) fn name(&self) -> &str {
        self.tag.local_name().into_inner()
    }

    /// The attribute with a name, if there is one.
    pub(super) fn attribute(&self, name: &str, places: &Places) -> Result<Option<Attribute<'a>>, Flaw> {
        for attribute in self.tag.attributes().with_checks(false) {
            let attribute = attribute.map_err(|error| Flaw::at(places.of(self.at), format!("not well-formed XML: {error}")))?;
            if attribute.key.as_ref() != name {
                continue;
            }
            let at = offset(self.text, &attribute.value);
            let raw = self.text.get(at..at + attribute.value.len()).unwrap_or_default();
            if !raw.contains('&') {
                return Ok(Some(Attribute { value: Cow::Borrowed(raw), at, is_verbatim: true }));
            }
            let value = quick_xml::escape::unescape(raw).map_err(|error| {
                Flaw::at(
                    places.of(at),
                    format!("the attribute `{name}` cannot be read: {error}; entities that the document declares are not expanded"),
                )
            })?;
            return Ok(Some(Attribute { value, at, is_verbatim: false }));
        }
        Ok(None)
    }
}
