//! Integers that go with a computation: weights of arguments, scales, divisors.

use smallvec::SmallVec;

use crate::exact::width::Ring;

/// Elements without denominators, as machine words as long as all of them are.
///
/// Weights and scales are mostly short. As words they need no care when they
/// are copied and dropped, and are at once what the kernel runs on.
#[derive(Clone, Debug)]
#[allow(clippy::large_enum_variant)] // The large variant is the frequent one, and is built in place.
pub(crate) enum Integers<C> {
    Words(SmallVec<[i64; 32]>),
    Any(Vec<C>),
}

/// Some of them.
#[derive(Debug)]
pub enum IntegerSlice<'a, C> {
    Words(&'a [i64]),
    Any(&'a [C]),
}

impl<C> Default for Integers<C> {
    #[inline]
    fn default() -> Self {
        Self::Words(SmallVec::new())
    }
}

impl<C> Clone for IntegerSlice<'_, C> {
    #[inline]
    fn clone(&self) -> Self {
        *self
    }
}

impl<C> Copy for IntegerSlice<'_, C> {}

impl<C: Ring> Integers<C> {
    #[inline]
    pub(crate) fn push_word(&mut self, word: i64) {
        match self {
            Self::Words(words) => words.push(word),
            Self::Any(list) => list.push(C::from_word(word)),
        }
    }

    #[inline]
    pub(crate) fn push(&mut self, value: C) {
        match (&mut *self, value.as_word()) {
            (Self::Words(words), Some(word)) => words.push(word),
            _ => self.push_any(value),
        }
    }

    #[inline(never)]
    fn push_any(&mut self, value: C) {
        self.as_elements_mut().push(value);
    }

    /// The list as elements, which it becomes if it is of words.
    pub(crate) fn as_elements_mut(&mut self) -> &mut Vec<C> {
        if let Self::Words(words) = self {
            *self = Self::Any(words.iter().map(|&word| C::from_word(word)).collect());
        }
        match self {
            Self::Any(list) => list,
            Self::Words(_) => unreachable!("words have just become elements"),
        }
    }

    #[inline]
    pub(crate) fn extend(&mut self, more: IntegerSlice<'_, C>) {
        match (&mut *self, more) {
            (Self::Words(words), IntegerSlice::Words(more)) => words.extend(more.iter().copied()),
            _ => self.extend_any(more),
        }
    }

    #[inline(never)]
    fn extend_any(&mut self, more: IntegerSlice<'_, C>) {
        match more {
            IntegerSlice::Words(words) => words.iter().for_each(|&word| self.push_word(word)),
            IntegerSlice::Any(list) => list.iter().for_each(|value| self.push(value.clone())),
        }
    }

    #[inline]
    pub(crate) fn as_slice(&self) -> IntegerSlice<'_, C> {
        match self {
            Self::Words(words) => IntegerSlice::Words(words),
            Self::Any(list) => IntegerSlice::Any(list),
        }
    }
}

impl<C: Ring> FromIterator<C> for Integers<C> {
    fn from_iter<I: IntoIterator<Item = C>>(values: I) -> Self {
        let mut all = Self::default();
        values.into_iter().for_each(|value| all.push(value));
        all
    }
}

impl<C> IntegerSlice<'_, C> {
    pub(crate) const NONE: Self = Self::Words(&[]);

    #[inline]
    pub(crate) fn len(&self) -> usize {
        match self {
            Self::Words(words) => words.len(),
            Self::Any(list) => list.len(),
        }
    }

    pub(crate) fn is_nothing(&self, index: usize) -> bool
    where
        C: Ring,
    {
        match self {
            Self::Words(words) => words[index] == 0,
            Self::Any(list) => list[index].is_nothing(),
        }
    }

    /// The first ones.
    pub(crate) fn up_to(self, count: usize) -> Self {
        match self {
            Self::Words(words) => Self::Words(&words[..count]),
            Self::Any(list) => Self::Any(&list[..count]),
        }
    }

    /// Without the first ones.
    pub(crate) fn after(self, count: usize) -> Self {
        match self {
            Self::Words(words) => Self::Words(&words[count..]),
            Self::Any(list) => Self::Any(&list[count..]),
        }
    }
}

impl<C: Ring> IntegerSlice<'_, C> {
    /// The integers as elements.
    pub(crate) fn to_elements(self) -> Vec<C> {
        match self {
            Self::Words(words) => words.iter().map(|&word| C::from_word(word)).collect(),
            Self::Any(list) => list.to_vec(),
        }
    }
}
