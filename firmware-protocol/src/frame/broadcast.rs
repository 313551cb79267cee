//! Frames to all boards at once.
//!
//! ```text
//! byte 0      kind 0, board 15
//! byte 1      1 emergency stop, 2 bus time, 3 who is there?
//! byte 2..    emergency stop: 0xDE 0xAD, reason
//!             bus time: host time [us], four bytes
//!             who is there: the host's protocol version, major and minor
//! ```
//!
//! A stopped board takes its forces away within 10 ms and is safe until it restarts, whatever its
//! state was: see [`crate::acyclic::arm`]. Bus time determines the age of multicast forces. A
//! board answers "who is there?" with its hello, after as many milliseconds as its number.

use super::{ALL_BOARDS, DecodeError, FrameKind, check_kind, check_padding, head};
use crate::version::ProtocolVersion;

/// Maximum length without padding (bytes).
pub const MAX_LEN: usize = 8;

/// Protection against a corrupt frame that looks like an emergency stop.
pub const STOP_MAGIC: [u8; 2] = [0xDE, 0xAD];

pub const STOP: u8 = 1;
pub const TIME: u8 = 2;
pub const WHO: u8 = 3;

/// A frame to all boards.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Broadcast {
    /// Removes the force from every key until the board restarts.
    EmergencyStop {
        /// Free for the sender's use.
        reason: u8,
    },
    BusTime {
        /// Host time (us); wraps.
        host_us: u32,
    },
    /// Requests a hello from every board.
    WhoIsThere { version: ProtocolVersion },
}

impl Broadcast {
    pub fn decode(bytes: &[u8]) -> Result<Self, DecodeError> {
        let length = DecodeError::Length { got: bytes.len() };
        if MAX_LEN < bytes.len() {
            return Err(length);
        }
        let [first, what, rest @ ..] = bytes else { return Err(length) };
        check_kind(*first, FrameKind::Broadcast)?;
        // Board 15 means all boards; a stop for one board would be a different frame.
        if *first & ALL_BOARDS != ALL_BOARDS {
            return Err(DecodeError::Value { at: 0 });
        }
        let (broadcast, padding) = match (*what, rest) {
            (STOP, [one, other, reason, padding @ ..]) => {
                if [*one, *other] != STOP_MAGIC {
                    return Err(DecodeError::Magic);
                }
                (Self::EmergencyStop { reason: *reason }, padding)
            }
            (TIME, [a, b, c, d, padding @ ..]) => {
                (Self::BusTime { host_us: u32::from_le_bytes([*a, *b, *c, *d]) }, padding)
            }
            (WHO, [major, minor, padding @ ..]) => (
                Self::WhoIsThere { version: ProtocolVersion { major: *major, minor: *minor } },
                padding,
            ),
            (STOP | TIME | WHO, _) => return Err(length),
            _ => return Err(DecodeError::Value { at: 1 }),
        };
        check_padding(padding)?;
        Ok(broadcast)
    }

    /// Writes the frame and zeros after it; returns its length without them.
    pub fn encode(&self, bytes: &mut [u8; MAX_LEN]) -> usize {
        let (what, rest, len) = match *self {
            Self::EmergencyStop { reason } => (STOP, [STOP_MAGIC[0], STOP_MAGIC[1], reason, 0], 5),
            Self::BusTime { host_us } => (TIME, host_us.to_le_bytes(), 6),
            Self::WhoIsThere { version } => (WHO, [version.major, version.minor, 0, 0], 4),
        };
        let [a, b, c, d] = rest;
        *bytes = [head(FrameKind::Broadcast, ALL_BOARDS), what, a, b, c, d, 0, 0];
        len
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_only_looks_like_a_stop_is_none() {
        assert_eq!(Broadcast::decode(&[0x0F, 1, 0xDE, 0xAF, 0]), Err(DecodeError::Magic));
        assert_eq!(Broadcast::decode(&[0x0F, 9, 0, 0, 0]), Err(DecodeError::Value { at: 1 }));
        let trailing = Broadcast::decode(&[0x0F, 1, 0xDE, 0xAD, 0, 1]);
        assert_eq!(trailing, Err(DecodeError::Padding));
        let for_one = Broadcast::decode(&[0x03, 1, 0xDE, 0xAD, 0]);
        assert_eq!(for_one, Err(DecodeError::Value { at: 0 }));
    }
}
