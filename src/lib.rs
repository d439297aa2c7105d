//! The exact polynomial and blossoming toolkit.
//!
//! Polynomial curves with rational (or symbolic) coefficients go in as
//! equations; out come their polar forms, control points over any frame,
//! subdivisions and worked steps, exact to the last digit, and back.
//!
//! **Everything is the polar form read at other arguments.** A point is
//! `f(t,…,t)`; a control point `f(r,…,r,s,…,s)`; a half of a subdivided curve
//! `f(r^{m-i} t^i)`; a new frame, the same with new vertices; a derivative,
//! arguments that are vectors.
//!
//! ```
//! use casteljau::{Curve, Interval, Rational};
//!
//! // F(t) = (t, t^2), over the frame -1..3
//! let integer = |n: i64| Rational::from(n);
//! let curve = Curve::new(vec![vec![integer(0), integer(1)], vec![integer(0), integer(0), integer(1)]])?;
//! let segment = curve.segment(&Interval::new(integer(-1), integer(3))?)?;
//! assert_eq!(segment.point(1), [integer(1), integer(-3)]); // f(r,s) = ((-1+3)/2, -1·3)
//!
//! // De Casteljau's algorithm with all its steps, and the equation back.
//! let scheme = segment.scheme(&Rational::new(1, 2))?;
//! assert_eq!(scheme.point(), [Rational::new(1, 2), Rational::new(1, 4)]);
//! assert!(segment.curve()?.same_map(&curve));
//! # Ok::<(), casteljau::Error>(())
//! ```
//!
//! # Layers
//!
//! Imports point downward only; a test holds that.
//!
//! | layer | what it holds |
//! |---|---|
//! | `main`, `cli`, `batch` | adaptors: arguments, files, exit status; requests a line |
//! | `worksheet` | hand calculations that check themselves |
//! | [`ops`] | one table of operations, whoever asks |
//! | [`report`], [`draw`] | text, LaTeX, JSON, Mathematica, SARIF, JUnit; pictures |
//! | `audit` | all joins of a file: mates, orders, deviations, verdicts |
//! | [`value`], `model` | what operations take and give; shapes in files |
//! | `cubic`, `implicit`, `quadric` | questions asked of shapes: classes and special points, equations |
//! | `curve`, `surface`, `segment`, `triangular`, `rectangular`, `piece`, `weights`, `blossom`, `reading`, `control`, `scheme`, `tetrahedron`, `bilinear`, `bernstein`, `symmetry`, `hull`, `flatness`, `mesh`, `matrix`, `roots`, `algebraic`, `continuity`, `geometric`, `joint`, `meeting`, `quotient`, `repair`, `side`, `smoothness`, `spline`, `tangent` | the nouns |
//! | `affine` | frames, homogeneous parameters, affine maps |
//! | `kernel` | nets and forms over any ring, and the width of its integers |
//! | [`syntax`] | the grammar and its printers, places and lines of texts |
//! | `symbolic` | symbols, monomials, polynomials |
//! | `exact` | rational numbers, numbers `a ± √d`, decimals, gcds, widths of integers |
//! | `error`, `name` | what can be wrong with a request; what is written by its name |
//!
//! The library without the default feature `cli` has no command line, no JSON
//! and none of the packages these need.

mod affine;
mod algebraic;
#[cfg(feature = "cli")]
pub mod audit;
#[cfg(feature = "cli")]
pub mod batch;
mod bernstein;
mod bilinear;
mod blossom;
#[cfg(feature = "cli")]
pub mod cli;
mod continuity;
mod control;
mod cubic;
mod curve;
pub mod draw;
mod error;
mod exact;
mod flatness;
mod geometric;
mod hull;
mod implicit;
mod joint;
mod kernel;
mod matrix;
mod meeting;
mod mesh;
#[cfg(feature = "cli")]
pub mod model;
mod name;
pub mod ops;
mod piece;
mod quadric;
mod quotient;
mod reading;
mod rectangular;
mod repair;
pub mod report;
mod roots;
mod scheme;
mod segment;
mod side;
mod smoothness;
mod spline;
mod surface;
mod symbolic;
mod symmetry;
pub mod syntax;
mod tangent;
mod tetrahedron;
mod triangular;
pub mod value;
mod weights;
#[cfg(feature = "cli")]
pub mod worksheet;

pub use affine::{AffineMap, Frame, Interval, Parameter, Place, PlaneParameter, Rectangle, Triangle};
pub use algebraic::{AlgebraicNumber, IsolatedRoot};
pub use bernstein::Bernstein;
pub use bilinear::{CommonSteps, TwoSteps};
pub use blossom::{PolarDefect, PolarForm, check_polar_form, sigma};
pub use continuity::{
    Continuity, RationalContinuity, continuity_of_curves, continuity_of_rational_curves, continuity_of_rational_surfaces,
    continuity_of_surfaces,
};
pub use cubic::{
    Branch, Breakpoint, ClassChange, Cubic, CubicClass, Direction, Distance, Equivalence, Family, Feature, Graph, Image, Intention,
    Invariants, MedianLine, NormalForm, Portion, PortionShape, Replacement, Rotated, SemiNormalForm, Special, SpecialPoint, Straight,
    classify_array, classify_rationals,
};
pub use curve::Curve;
pub use error::Error;
pub use exact::{MAX_DIGITS, ParseNumberError, Rational, Surd};
pub use flatness::Flattening;
pub use geometric::{Directions, GeometricJoin, SingularJoint, geometric_join, geometric_join_of_ends, geometric_join_of_rational};
pub use hull::{ConvexHull, bounding_box};
pub use implicit::{ConicType, ImplicitCurve, Parameters};
pub use joint::{AffineGroup, Extension, JoinCondition, Joint, affine_groups, extend, join_conditions};
pub use kernel::coefficient::Coefficient;
pub use matrix::bernstein_matrix;
pub use meeting::Meeting;
pub use mesh::Mesh;
pub use piece::{Equation, Piece};
pub use quadric::{QUADRIC_MONOMIALS, QuadricClass, QuadricSurface};
pub use quotient::Quotient;
pub use reading::{PolarTerm, Reading};
pub use rectangular::{Axis, Quartering, RectangularPatch, RectangularReduction, bidegree_label};
pub use repair::{Repair, repair_tangents, repair_to_order};
pub use roots::{RealRoots, Root, RootPlace};
pub use scheme::{Scheme, polar_label};
pub use segment::{Reduction, Segment};
pub use side::{Arrangement, Side};
pub use smoothness::SmoothnessTest;
pub use spline::{KnotJoin, Spline};
pub use surface::{Surface, Term};
pub use symbolic::{Monomial, Polynomial, Symbol};
pub use symmetry::Symmetry;
pub use tangent::{TangentPlaneJoin, Vanishing, tangent_plane_join};
pub use tetrahedron::TriangularScheme;
pub use triangular::{Quadrisection, TriangularPatch, TriangularReduction, Trisection, triangular_degree};
pub use weights::{homogeneous_points, projected};

/// The library example of the README, run as a documentation test.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct ReadmeExamples;
