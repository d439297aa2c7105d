//! Usual mistakes, made on purpose.

use std::borrow::Cow;

use super::quantity::{Net, Quantity};
use crate::affine::Frame;
use crate::error::Error;
use crate::symbolic::Polynomial;
use crate::syntax::ArgumentInput;

/// A usual mistake.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Slip {}

impl Slip {
    pub(super) fn on_shape<'q>(self, _: &'q Quantity) -> Result<Cow<'q, Quantity>, Error> {
        match self {}
    }

    pub(super) fn polar_value(self, _: &Quantity, _: &[Vec<ArgumentInput>]) -> Result<Quantity, Error> {
        match self {}
    }

    pub(super) fn points(self, _: &Quantity, _: &Frame<Polynomial>) -> Result<Quantity, Error> {
        match self {}
    }

    pub(super) fn net(self, _: &Net) -> Result<Net, Error> {
        match self {}
    }
}
