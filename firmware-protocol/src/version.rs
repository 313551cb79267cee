//! The version of the protocol, and who may talk to whom.
//!
//! A **minor** number counts additions: new requests, new broadcasts, new bits that were zero,
//! new fields behind a record's last. Who does not know them ignores or refuses them, and all
//! else goes on. A **major** number counts changes after which old frames would be misread;
//! boards of another one are refused at their hello and never armed. The cyclic layouts have a
//! hash of their own, [`crate::schema::HASH`], so that not even a forgotten number lets a
//! force be misread.

/// What this crate speaks. 2.1 added where a finger starts and how long it takes to lift, 2.2 the
/// health of boards and keys, keys without motors, and the way into a bootloader.
pub const PROTOCOL_VERSION: ProtocolVersion = ProtocolVersion { major: 2, minor: 2 };

/// A version of the protocol.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct ProtocolVersion {
    /// Counts changes after which old frames would be misread.
    pub major: u8,
    /// Counts additions that the other side may ignore.
    pub minor: u8,
}

impl ProtocolVersion {
    /// Tells whether frames of `other` may be acted on: the major numbers are equal.
    pub const fn understands(self, other: Self) -> bool {
        self.major == other.major
    }
}
