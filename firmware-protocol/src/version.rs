//! The version of the protocol, and its compatibility.
//!
//! A **minor** number counts additions: new requests, new broadcasts, new bits that were zero,
//! new fields after a record's last. A peer without them ignores or rejects them, and all else
//! works. A **major** number counts changes that would make old frames misread; a host rejects
//! boards with another one at their hello and never arms them. The hash of the cyclic layouts,
//! [`crate::schema::HASH`], prevents misread forces even after a forgotten number.

/// Version of this crate. 2.1 added the start and the lift time of a finger, 2.2 the health of
/// boards and keys, keys without motors, and the entry into a bootloader.
pub const PROTOCOL_VERSION: ProtocolVersion = ProtocolVersion { major: 2, minor: 2 };

/// A version of the protocol.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct ProtocolVersion {
    pub major: u8,
    pub minor: u8,
}

impl ProtocolVersion {
    /// Returns `true` if frames of `other` may be acted on: the major numbers are equal.
    pub const fn understands(self, other: Self) -> bool {
        self.major == other.major
    }
}
