//! Frames on an asynchronous serial line: 8 data bits, no parity, one stop bit.
//!
//! Each frame has a CRC, is coded without zeros (COBS), and ends with a zero.

/// Checksum of a frame (bytes).
const CRC: usize = 2;
/// Bits on the line for each byte: start, 8, stop.
const BITS_PER_BYTE: f64 = 10.0;
/// Bytes after which COBS needs a further code byte.
const COBS_RUN: usize = 254;

/// Turns of the senders on a serial line.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Wiring {
    /// A pair of wires each way: a board's own link, or that of a hub for all keys.
    FullDuplex,
    /// One pair for all, as in RS-485: host and boards take turns.
    HalfDuplex {
        /// Silence before each frame, until its sender has the line (us).
        turnaround: u32,
    },
}

/// Returns the maximum length of a frame of `bytes` on the wire (bytes).
pub const fn wire_bytes(bytes: usize) -> usize {
    let checked = bytes + CRC;
    let code = 1 + checked / COBS_RUN;
    let delimiter = 1;
    checked + code + delimiter
}

/// Returns the time of a frame at `baud` (bit/s), without turnaround (us).
pub fn time(bytes: usize, baud: u32) -> f64 {
    wire_bytes(bytes) as f64 * BITS_PER_BYTE * 1e6 / f64::from(baud)
}

#[cfg(test)]
mod tests {
    use super::*;
    use firmware_protocol::serial::{MAX_FRAME, MAX_WIRE, encode};

    #[test]
    fn every_frame_of_the_protocol_has_the_length_that_is_charged() {
        for n in 0..=MAX_FRAME {
            let mut wire = [0; MAX_WIRE];
            let sent = encode(&[0xA5; MAX_FRAME][..n], &mut wire).unwrap();
            assert_eq!(sent, wire_bytes(n), "{n} bytes");
        }
    }
}
