//! Enums that are written by their names.

/// Writes types that have a `name()` by it, padded as the format asks.
macro_rules! display_by_name {
    ($($named:ty),+) => {$(
        impl std::fmt::Display for $named {
            fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
                f.pad(self.name())
            }
        }
    )+};
}

pub(crate) use display_by_name;
