//! The numbers both sides work on.

use crate::flint::{Flint, Fractions};
use casteljau::Rational;

/// Numerators and denominators, not yet reduced, from which each side makes its own numbers.
pub struct Numbers(Vec<(i64, u64)>);

impl Numbers {
    /// k/1000 with |k| at most 1000.
    pub fn thousandths(length: usize) -> Numbers {
        let mut random = Random(1);
        Numbers((0..length).map(|_| (random.between(-1000, 1000), 1000)).collect())
    }

    /// p/q, each of eight bits, p signed.
    pub fn eight_bits(length: usize) -> Numbers {
        let mut random = Random(2);
        Numbers((0..length).map(|_| (random.between(-128, 127), random.between(1, 255) as u64)).collect())
    }

    pub fn casteljau(&self) -> Vec<Rational> {
        self.0.iter().map(|&(num, den)| Rational::new(num, den as i64)).collect()
    }

    pub fn flint(&self, flint: &'static Flint) -> Fractions {
        Fractions::new(flint, &self.0)
    }
}

/// Knuth's linear congruential generator.
struct Random(u64);

impl Random {
    fn between(&mut self, low: i64, high: i64) -> i64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        low + ((self.0 >> 33) % (high - low + 1) as u64) as i64
    }
}
