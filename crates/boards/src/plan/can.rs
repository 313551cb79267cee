//! Lengths of CAN frames in bits, from start of frame to the end of the pause after it.
//!
//! After five equal bits the sender inserts their inverse, so the length depends on the payload.
//! Head and tail of a CAN FD frame are sent at the nominal rate, the rest at the data rate.

/// Unstuffed end of a classic frame: CRC delimiter, ACK, its delimiter, 7 end, 3 pause (bits).
const CLASSIC_TAIL: usize = 13;
/// End of a CAN FD frame at the nominal rate: ACK, ACK delimiter, 7, 3 (bits).
const FD_TAIL: usize = 12;
/// Between the rate switch and the payload: ESI, 4 of the length (bits).
const FD_HEAD: usize = 5;
/// The stuff bits' count, 3 and parity (bits).
const STUFF_COUNT: usize = 4;

/// Length of a frame's identifier.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub enum Id {
    #[default]
    Standard,
    Extended,
}

/// Charged payload among those of one length.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Stuffing {
    Fewest,
    Most,
}

impl Stuffing {
    /// Returns the stuff bits among `bits`: the first after five, each further one after four.
    const fn among(self, bits: usize) -> usize {
        match self {
            Self::Fewest => 0,
            Self::Most => (bits - 1) / 4,
        }
    }
}

/// Returns the length of a classic frame with a payload of `bytes`, at most 8 (bits).
pub const fn classic_bits(id: Id, bytes: usize, stuffing: Stuffing) -> usize {
    // Start, identifier, flags, length, and the CRC behind the payload.
    let fixed = match id {
        Id::Standard => 34,
        Id::Extended => 54,
    };
    let stuffed = fixed + 8 * bytes;
    stuffed + stuffing.among(stuffed) + CLASSIC_TAIL
}

/// Returns the time of a classic frame at `bitrate` (bit/s) on the bus (us).
pub fn classic_time(id: Id, bytes: usize, stuffing: Stuffing, bitrate: u32) -> f64 {
    micros(classic_bits(id, bytes, stuffing), bitrate)
}

/// Length of a CAN FD frame by the rates of its bits.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct FdBits {
    pub nominal: usize,
    pub data: usize,
}

impl FdBits {
    /// Returns the length of a frame that switches rates, with a payload of `bytes`, one of
    /// [`firmware_protocol::can::LENGTHS`].
    ///
    /// The bits in which the rate switches belong half to each rate. The first counts as nominal,
    /// the last as data: exact if both rates sample at the same point. [`Stuffing::Most`] puts as
    /// many stuff bits as possible into the slower part.
    pub const fn of(id: Id, bytes: usize, stuffing: Stuffing) -> Self {
        let head = match id {
            Id::Standard => 17,
            Id::Extended => 36,
        };
        let crc = if bytes <= 16 { 17 } else { 21 };
        let fixed_stuff = 1 + (STUFF_COUNT + crc) / 4;
        let stuff_nominal = stuffing.among(head);
        let stuff_data = stuffing.among(head + FD_HEAD + 8 * bytes) - stuff_nominal;
        let delimiter = 1;
        Self {
            nominal: head + FD_TAIL + stuff_nominal,
            data: FD_HEAD + 8 * bytes + STUFF_COUNT + crc + fixed_stuff + delimiter + stuff_data,
        }
    }

    /// Returns its time on a bus of these rates (bit/s) (us).
    pub fn time(self, nominal: u32, data: u32) -> f64 {
        micros(self.nominal, nominal) + micros(self.data, data)
    }
}

fn micros(bits: usize, rate: u32) -> f64 {
    bits as f64 * 1e6 / f64::from(rate)
}
