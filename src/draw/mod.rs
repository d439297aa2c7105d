//! Pictures.
//!
//! Curves and patches are drawn as SVG that needs nothing else, meshes written
//! as OBJ and glTF. Whatever decides where a
//! point lies is computed exactly; floats are used only for the coordinates of
//! ink, after the bounding box has been mapped to the paper.

mod arrow;
mod axes;
mod bezier;
mod caption;
mod curve;
mod feature;
mod gallery;
#[cfg(feature = "cli")]
mod joins;
mod label;
mod mark;
mod model;
mod number;
mod patch;
mod scene;
mod space;
mod style;
mod svg;
mod ticks;
mod view;

#[cfg(test)]
mod tests;

pub use curve::CurvePicture;
pub use gallery::gallery;
#[cfg(feature = "cli")]
pub use joins::{MAX_DRAWN, joins};
pub use model::{glb, obj};
pub use patch::PatchPicture;
