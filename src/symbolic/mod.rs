//! Polynomials over the rationals in named variables: symbols, monomials and
//! sparse polynomials.

mod monomial;
mod polynomial;
// Worksheets, which compute with roots, belong to the program.
#[cfg_attr(not(feature = "cli"), allow(dead_code))]
mod root;
mod symbol;

pub use monomial::Monomial;
pub use polynomial::Polynomial;
pub use symbol::Symbol;
