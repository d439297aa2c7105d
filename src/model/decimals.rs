//! Reading the many numbers of a file.

use crate::exact::decimal::short_decimal;
use crate::exact::{ParseNumberError, Rational};

/// A reader of numbers that keeps count: of the finest digit, and of the memory
/// that numbers take which are longer than they look, such as `1e9999`.
#[derive(Clone, Debug, Default)]
pub struct Decimals {
    finest: u32,
    words: usize,
}

impl Decimals {
    /// The most words that the long numbers of one file may take together.
    pub const MAX_WORDS: usize = 1 << 20;
    /// Numbers up to so many words are not counted.
    const FREE_WORDS: u64 = 4;

    /// Reads a number exactly.
    ///
    /// # Errors
    /// As for [`Rational`]'s `FromStr`; [`ParseNumberError::TooLong`] also where
    /// the long numbers of the file take more than [`Self::MAX_WORDS`].
    pub fn read(&mut self, text: &str) -> Result<Rational, ParseNumberError> {
        if let Some((number, places)) = short_decimal(text) {
            self.finest = self.finest.max(places);
            return Ok(number);
        }
        let number: Rational = text.parse()?;
        self.hold(&number)?;
        if let Some(places) = places(text) {
            self.finest = self.finest.max(places);
        }
        Ok(number)
    }

    /// Counts the memory of a number, one that was read or one that was computed
    /// from others, such as a sum of relative coordinates.
    ///
    /// # Errors
    /// [`ParseNumberError::TooLong`] where the long numbers of the file take more
    /// than [`Self::MAX_WORDS`].
    pub fn hold(&mut self, number: &Rational) -> Result<(), ParseNumberError> {
        let words = number.bits() / 64;
        if words > Self::FREE_WORDS {
            self.words += usize::try_from(words).unwrap_or(Self::MAX_WORDS);
            if self.words > Self::MAX_WORDS {
                return Err(ParseNumberError::TooLong);
            }
        }
        Ok(())
    }

    /// The most digits behind the dot that a coordinate had, its exponent counted.
    #[must_use]
    pub fn finest(&self) -> u32 {
        self.finest
    }

    /// Goes back to an earlier count of digits: the numbers since were no coordinates.
    pub fn restore(&mut self, finest: u32) {
        self.finest = finest;
    }
}

/// The digits behind the dot of a decimal; none of a fraction.
fn places(text: &str) -> Option<u32> {
    if text.contains('/') {
        return None;
    }
    let (mantissa, exponent) = match text.find(['e', 'E']) {
        Some(at) => (&text[..at], text[at + 1..].parse::<i64>().unwrap_or(0)),
        None => (text, 0),
    };
    let behind = mantissa.find('.').map_or(0, |at| mantissa.len() - at - 1);
    u32::try_from((behind as i64 - exponent).max(0)).ok()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_finest_digit() {
        for (text, finest) in [("12", 0), ("1.250", 3), ("-.5", 1), ("2.5e-3", 4), ("2.5e3", 0), ("1/3", 0), ("1.25e-20", 22)] {
            let mut decimals = Decimals::default();
            decimals.read(text).expect("a number");
            assert_eq!(decimals.finest(), finest, "{text}");
        }
    }

    #[test]
    fn digits_of_other_numbers_are_set_aside() {
        let mut decimals = Decimals::default();
        decimals.read("1.5").expect("a number");
        let finest = decimals.finest();
        decimals.read("0.125").expect("a number");
        decimals.restore(finest);
        assert_eq!(decimals.finest(), 1);
    }

    #[test]
    fn short_texts_do_not_fill_the_memory() {
        let mut decimals = Decimals::default();
        let refused = (0..100_000).find(|_| decimals.read("1e9999").is_err());
        assert!(refused.is_some_and(|count| count > 1000), "{refused:?}");
    }
}
