//! The one engine under every curve and surface.
//!
//! A [`Net`](net::Net) holds polar values at the vertices of a product of
//! simplices: one factor of dimension 1 for a curve, two for a rectangle, one
//! of dimension 2 for a triangle. A [`Form`](form::Form) holds the same map as
//! a homogeneous polynomial, each polar value times its multinomial number.
//! Taking an argument in (`step`) is natural on nets; changing a vertex
//! (`replace`), elevating and multiplying are additions on forms.
//!
//! Neither knows numbers: both are generic over a [`Ring`](crate::exact::width::Ring),
//! and [`coefficient`] decides, once a computation, which ring that is.

pub(crate) mod coefficient;
pub(crate) mod combination;
pub(crate) mod denominator;
pub(crate) mod form;
pub(crate) mod integers;
pub(crate) mod layout;
pub(crate) mod net;
pub(crate) mod reframe;
pub(crate) mod shape;
pub(crate) mod short;
pub(crate) mod task;
