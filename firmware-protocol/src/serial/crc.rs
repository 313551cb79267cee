//! The checksum of the byte stream: CRC-16 with 0x1021 from 0xFFFF, unreflected.
//!
//! In the unstuffed frame it finds every error of up to three bits and every burst of up to 16; a
//! flipped bit in the stuffing moves a zero, which is two such errors.

use crc::{CRC_16_IBM_3740, Crc};

pub(super) const LEN: usize = 2;

const CCITT: Crc<u16> = Crc::<u16>::new(&CRC_16_IBM_3740);

/// Returns the little-endian checksum of `bytes`.
pub(super) fn checksum(bytes: &[u8]) -> [u8; LEN] {
    CCITT.checksum(bytes).to_le_bytes()
}
