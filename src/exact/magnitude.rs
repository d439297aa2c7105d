//! Upper bounds of integers, for choosing a width before the work starts.

use num_bigint::BigUint;

/// A number that some integer is known not to exceed: `mantissa * 2^exponent`,
/// where every operation rounds upward.
///
/// Products of many factors lose less than one bit in total, where adding up
/// bit lengths would lose up to one bit a factor.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Magnitude {
    mantissa: u64,
    exponent: u64,
}

impl Magnitude {
    pub(crate) const ZERO: Self = Self { mantissa: 0, exponent: 0 };
    pub(crate) const ONE: Self = Self { mantissa: 1, exponent: 0 };

    pub(crate) fn from_big(value: &BigUint) -> Self {
        let excess = value.bits().saturating_sub(64);
        let shifted = value >> excess;
        let leading = u128::from(shifted.iter_u64_digits().next().unwrap_or(0));
        Self::rounded(leading + u128::from(excess > 0), excess)
    }

    #[inline(never)]
    fn rounded(mantissa: u128, exponent: u64) -> Self {
        let excess = 64 - (mantissa >> 64).leading_zeros().saturating_sub(64);
        if excess == 0 {
            return Self { mantissa: mantissa as u64, exponent };
        }
        let kept = mantissa >> excess;
        let lost = kept << excess != mantissa;
        match (kept as u64).checked_add(u64::from(lost)) {
            Some(mantissa) => Self { mantissa, exponent: exponent + u64::from(excess) },
            None => Self { mantissa: 1 << 63, exponent: exponent + u64::from(excess) + 1 },
        }
    }

    #[inline]
    pub(crate) fn times(self, other: Self) -> Self {
        if let Some(mantissa) = self.mantissa.checked_mul(other.mantissa) {
            return Self { mantissa, exponent: self.exponent + other.exponent };
        }
        Self::rounded(u128::from(self.mantissa) * u128::from(other.mantissa), self.exponent + other.exponent)
    }

    #[inline]
    pub(crate) fn plus(self, other: Self) -> Self {
        if let (0, 0, Some(mantissa)) = (self.exponent, other.exponent, self.mantissa.checked_add(other.mantissa)) {
            return Self::from(mantissa);
        }
        self.plus_long(other)
    }

    #[inline(never)]
    fn plus_long(self, other: Self) -> Self {
        let (high, low) = if self.exponent >= other.exponent { (self, other) } else { (other, self) };
        let gap = high.exponent - low.exponent;
        if high.mantissa == 0 {
            return low;
        }
        // Align at the larger exponent; what is shifted out counts as one.
        let room = u64::from(high.mantissa.leading_zeros()).min(gap);
        let shift = gap - room;
        let aligned = if shift >= 64 { u64::from(low.mantissa != 0) } else { (low.mantissa >> shift) + u64::from(shift > 0) };
        Self::rounded(u128::from(high.mantissa) * (1u128 << room) + u128::from(aligned), high.exponent - room)
    }

    #[inline]
    pub(crate) fn power(self, mut exponent: usize) -> Self {
        if self == Self::ONE {
            return self;
        }
        if let Some(mantissa) =
            u32::try_from(exponent).ok().filter(|_| self.exponent == 0).and_then(|power| self.mantissa.checked_pow(power))
        {
            return Self::from(mantissa);
        }
        let (mut base, mut result) = (self, Self::ONE);
        while exponent > 0 {
            if exponent & 1 == 1 {
                result = result.times(base);
            }
            exponent >>= 1;
            if exponent > 0 {
                base = base.times(base);
            }
        }
        result
    }

    #[inline]
    pub(crate) fn max(self, other: Self) -> Self {
        if self.exponent == other.exponent {
            return if self.mantissa >= other.mantissa { self } else { other };
        }
        self.max_long(other)
    }

    #[inline(never)]
    fn max_long(self, other: Self) -> Self {
        let difference_free = self.bits().cmp(&other.bits());
        match difference_free {
            std::cmp::Ordering::Less => other,
            std::cmp::Ordering::Greater => self,
            // Same length: their leading bits decide; either is within a factor of two anyway.
            std::cmp::Ordering::Equal if self.leading() >= other.leading() => self,
            std::cmp::Ordering::Equal => other,
        }
    }

    fn leading(self) -> u64 {
        if self.mantissa == 0 { 0 } else { self.mantissa << self.mantissa.leading_zeros() }
    }

    /// The number of bits of the bound: every covered integer is below `2^bits`.
    pub(crate) fn bits(self) -> u64 {
        if self.mantissa == 0 { 0 } else { 64 - u64::from(self.mantissa.leading_zeros()) + self.exponent }
    }
}

impl From<u64> for Magnitude {
    #[inline]
    fn from(value: u64) -> Self {
        Self { mantissa: value, exponent: 0 }
    }
}

impl From<u128> for Magnitude {
    fn from(value: u128) -> Self {
        Self::rounded(value, 0)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn covers(bound: Magnitude, value: &BigUint) -> bool {
        BigUint::from(bound.mantissa) << bound.exponent >= *value
    }

    /// The bound is not more than a little above the value.
    fn tight(bound: Magnitude, value: &BigUint) -> bool {
        (BigUint::from(bound.mantissa) << bound.exponent) * 1000u32 <= value * 1001u32 + 1000u32
    }

    proptest! {
        #[test]
        fn bounds_hold_and_are_tight(
            a in prop::collection::vec(any::<u32>(), 0..6),
            b in prop::collection::vec(any::<u32>(), 0..6),
            power in 0usize..20,
        ) {
            let (a, b) = (BigUint::new(a), BigUint::new(b));
            let (x, y) = (Magnitude::from_big(&a), Magnitude::from_big(&b));
            for (bound, value) in [
                (x, a.clone()),
                (x.times(y), &a * &b),
                (x.plus(y), &a + &b),
                (x.max(y), a.clone().max(b.clone())),
                (x.power(power), a.pow(power as u32)),
            ] {
                prop_assert!(covers(bound, &value) && tight(bound, &value), "{bound:?} for {value}");
                prop_assert!(value.bits() <= bound.bits());
            }
        }
    }
}
