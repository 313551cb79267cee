//! The version of the wire format, and who may talk to whom.
//!
//! The major number stands in every frame, so that a board of another generation is
//! refused at its first byte rather than misread.

/// What this crate speaks.
pub const PROTOCOL_VERSION: Version = Version { major: 1, minor: 0 };

const _: () = assert!(PROTOCOL_VERSION.major <= 0xF, "the major number has four bits");

/// A version of the wire format.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Version {
    /// Counts changes after which old frames would be misread, `0 ..= 15`.
    pub major: u8,
    /// Counts additions that old boards may ignore.
    pub minor: u8,
}

impl Version {
    /// Whether frames of `other` may be acted on: the major numbers are equal.
    pub const fn understands(self, other: Self) -> bool {
        self.major == other.major
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_addition_is_understood_and_a_new_generation_is_not() {
        let newer = Version { major: 1, minor: 9 };
        let foreign = Version { major: 2, minor: 0 };
        assert!(PROTOCOL_VERSION.understands(newer));
        assert!(!PROTOCOL_VERSION.understands(foreign));
    }
}
