//! Polynomials over the rationals in named variables: symbols, monomials and
//! sparse polynomials.

mod monomial;
mod polynomial;
mod root;
mod symbol;

pub use monomial::Monomial;
pub use polynomial::Polynomial;
pub use symbol::Symbol;
