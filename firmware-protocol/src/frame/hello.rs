//! Identity of a board: board → host, when it starts, on request, and as a reply.
//!
//! ```text
//! byte 0      kind 6, flag: it renders no forces, bits 3..0 board
//! byte 1..    the fields of [`Hello`], little-endian, in their order
//! ```
//!
//! 49 bytes; a board of a newer minor version may append more. Magic and version come first and
//! never move, so that a host rejects another major version by its number instead of misreading it.

use super::{DecodeError, FrameKind, check_board, flag, head};
use crate::MAX_FRAME;
use crate::Record as _;
use crate::key::BoardId;
use crate::version::{PROTOCOL_VERSION, ProtocolVersion};

/// Length without padding, in this version (bytes).
pub const LEN: usize = 1 + Hello::LEN;

/// First bytes of every hello.
pub const MAGIC: [u8; 4] = *b"LTOF";

/// Features of a board, one bit each, in [`Hello::features`].
pub mod feature {
    /// Renders slopes between frames.
    pub const SLOPES: u16 = 1 << 0;
    pub const MULTICAST: u16 = 1 << 1;
    pub const VELOCITY: u16 = 1 << 2;
    /// Is a simulation with fingers, see [`crate::acyclic::finger`].
    pub const FINGERS: u16 = 1 << 3;
    pub const LOG: u16 = 1 << 4;
    /// Reports the health of itself and its keys, see [`crate::acyclic::health`].
    pub const HEALTH: u16 = 1 << 5;
    pub const BOOTLOADER: u16 = 1 << 6;
}

/// Reasons for the safe state, in [`Hello::safe_reason`].
pub mod safe_reason {
    pub const NONE: u8 = 0;
    pub const NEVER_ARMED: u8 = 1;
    /// Its forces expired.
    pub const SILENCE: u8 = 2;
    pub const DISARMED: u8 = 3;
    /// All boards were stopped; lasts until a restart.
    pub const EMERGENCY_STOP: u8 = 4;
    /// A key, motor or sensor failed; lasts until a restart.
    pub const KEY_FAULT: u8 = 5;
}

record! {
    /// Identity and abilities of a board.
    Hello {
        /// `4C 54 4F 46`, the letters LTOF.
        magic: [u8; 4],
        /// Major number of the protocol, 2.
        major: u8,
        /// Minor number of the protocol.
        minor: u8,
        /// Schema hash, see Versions.
        schema: u64,
        /// Identity of the board; no other board has the same.
        uid: [u8; 6],
        /// Its first key, 0 for A0 to 87 for C8.
        first_key: u8,
        /// Number of its keys, 1 to 12, in a row.
        n_keys: u8,
        /// Sum of feature bits.
        features: u16,
        /// Highest rate of samples (1/s), above 0.
        max_sample_hz: u16,
        /// Highest rate of forces (1/s), above 0.
        max_force_hz: u16,
        /// Rate at which it computes the forces of its motors (1/s), above 0.
        law_hz: u16,
        /// Displacement of the key's front for one count (nm), 1 to 1 000 000.
        quantum_nm: u32,
        /// Largest force of its motors (mN), above 0.
        max_force_mn: u16,
        /// CRC-32 of its settings.
        config_crc: u32,
        /// Its clock (us); wraps.
        board_us: u32,
        /// Major number of its firmware.
        firmware_major: u8,
        /// Minor number of its firmware.
        firmware_minor: u8,
        /// 1 for power on; other values are free for the firmware.
        reset_reason: u8,
        /// Reason why it renders no force.
        safe_reason: u8,
    }
}

/// A hello with the header of its frame.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Introduction {
    pub board: BoardId,
    /// `true` if the board renders no forces, for the reason [`Hello::safe_reason`].
    pub safe: bool,
    pub hello: Hello,
}

impl Introduction {
    /// Decodes a frame of this or a newer minor version.
    pub fn decode(bytes: &[u8]) -> Result<Self, DecodeError> {
        let length = DecodeError::Length { got: bytes.len() };
        let [first, record @ ..] = bytes else { return Err(length) };
        if MAX_FRAME < bytes.len() {
            return Err(length);
        }
        let board = check_board(*first, FrameKind::Hello)?;
        let [a, b, c, d, major, ..] = record else { return Err(length) };
        if [*a, *b, *c, *d] != MAGIC {
            return Err(DecodeError::Magic);
        }
        if !PROTOCOL_VERSION.understands(ProtocolVersion { major: *major, minor: 0 }) {
            return Err(DecodeError::Version(*major));
        }
        let hello = Hello::take(record).ok_or(length)?;
        Ok(Self { board, safe: flag(*first), hello })
    }

    /// Writes the frame and zeros after it; returns its length without them.
    pub fn encode(&self, bytes: &mut [u8; MAX_FRAME]) -> usize {
        bytes.fill(0);
        let flag = u8::from(self.safe) << super::field::FLAG_SHIFT;
        bytes[0] = head(FrameKind::Hello, self.board.number()) | flag;
        1 + self.hello.put(&mut bytes[1..]).unwrap_or_default()
    }
}
