//! Time of a protocol frame on any kind of wire.

use std::fmt;

use firmware_protocol::{MAX_FRAME, can::padded, can::pieces::PIECE};

use super::can::{self, FdBits, Id, Stuffing};
use super::uart::{self, Wiring};
use super::usb::UsbRate;

/// Medium of frames between the host and its boards.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Medium {
    /// Classic CAN; a frame takes pieces of 7 bytes.
    ClassicCan {
        bitrate: u32,
    },
    /// CAN FD with rate switch; a frame above 64 bytes takes several.
    CanFd {
        /// Rate of head and tail (bit/s).
        nominal: u32,
        /// Rate of the rest (bit/s).
        data: u32,
    },
    Uart {
        baud: u32,
        wiring: Wiring,
    },
    /// Bulk transfers of full-speed devices behind one transaction translator, framed as serial.
    UsbFullSpeed,
    UsbHighSpeed,
}

impl Medium {
    /// Returns the time for which a frame of `bytes` occupies the medium (us).
    ///
    /// # Real-time
    /// A few dozen operations, at any length.
    pub fn time(self, bytes: usize, stuffing: Stuffing) -> f64 {
        let piece = self.piece(bytes);
        if piece == 0 {
            return self.piece_time(0, stuffing);
        }
        let (full, rest) = (bytes / piece, bytes % piece);
        let last = if rest == 0 { 0.0 } else { self.piece_time(rest, stuffing) };
        full as f64 * self.piece_time(piece, stuffing) + last
    }

    /// Returns the longest wait of the most urgent other frame for a frame of `bytes` (us).
    pub fn blocking(self, bytes: usize) -> f64 {
        match self {
            Self::UsbFullSpeed => UsbRate::Full.frame_time(),
            Self::UsbHighSpeed => UsbRate::High.frame_time(),
            Self::ClassicCan { .. } | Self::CanFd { .. } | Self::Uart { .. } => {
                self.piece_time(self.piece(bytes), Stuffing::Most)
            }
        }
    }

    /// Returns the length of an uninterrupted piece (bytes).
    fn piece(self, bytes: usize) -> usize {
        match self {
            Self::ClassicCan { .. } => bytes.min(PIECE),
            Self::CanFd { .. } => bytes.min(MAX_FRAME),
            Self::Uart { .. } | Self::UsbFullSpeed | Self::UsbHighSpeed => bytes,
        }
    }

    fn piece_time(self, bytes: usize, stuffing: Stuffing) -> f64 {
        match self {
            Self::ClassicCan { bitrate } => {
                // Its first byte identifies the piece.
                can::classic_time(Id::Standard, 1 + bytes, stuffing, bitrate)
            }
            Self::CanFd { nominal, data } => {
                FdBits::of(Id::Standard, padded(bytes), stuffing).time(nominal, data)
            }
            Self::Uart { baud, wiring: Wiring::FullDuplex } => uart::time(bytes, baud),
            Self::Uart { baud, wiring: Wiring::HalfDuplex { turnaround } } => {
                uart::time(bytes, baud) + f64::from(turnaround)
            }
            Self::UsbFullSpeed => UsbRate::Full.time(uart::wire_bytes(bytes)),
            Self::UsbHighSpeed => UsbRate::High.time(uart::wire_bytes(bytes)),
        }
    }

    pub const fn is_shared(self) -> bool {
        !matches!(self, Self::Uart { wiring: Wiring::FullDuplex, .. })
    }

    pub const fn reaches_all(self) -> bool {
        match self {
            Self::ClassicCan { .. } | Self::CanFd { .. } => true,
            Self::Uart { wiring, .. } => matches!(wiring, Wiring::HalfDuplex { .. }),
            Self::UsbFullSpeed | Self::UsbHighSpeed => false,
        }
    }
}

impl fmt::Display for Medium {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let mega = |rate: u32| f64::from(rate) / 1e6;
        match *self {
            Self::ClassicCan { bitrate } => write!(f, "classic CAN at {} Mbit/s", mega(bitrate)),
            Self::CanFd { nominal, data } => {
                write!(f, "CAN FD at {}/{} Mbit/s", mega(nominal), mega(data))
            }
            Self::Uart { baud, wiring: Wiring::FullDuplex } => {
                write!(f, "serial line at {} Mbaud", mega(baud))
            }
            Self::Uart { baud, wiring: Wiring::HalfDuplex { .. } } => {
                write!(f, "RS-485 at {} Mbaud", mega(baud))
            }
            Self::UsbFullSpeed => f.write_str("full-speed USB"),
            Self::UsbHighSpeed => f.write_str("high-speed USB"),
        }
    }
}

/// The reason why nothing is planned for a link.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum NoPlan {
    /// It exists in memory only.
    Virtual,
    /// Its rate does not follow from its name.
    NoRates,
    /// No board is left for it.
    NoBoards,
}

impl fmt::Display for NoPlan {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Virtual => "it is virtual and takes no time, so nothing is planned",
            Self::NoRates => {
                "it takes any rate and keeps none, as USB devices and pseudo-terminals do, so \
                 nothing is planned"
            }
            Self::NoBoards => {
                "no board is left for it, so nothing is planned; list its boards in the scene, or \
                 leave it out"
            }
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const FD: Medium = Medium::CanFd { nominal: 1_000_000, data: 5_000_000 };

    #[track_caller]
    fn check(medium: Medium, bytes: usize, time: f64) {
        let got = medium.time(bytes, Stuffing::Most);
        assert!((got - time).abs() < 1e-9, "{bytes} bytes on {medium}: {got} us");
    }

    #[test]
    fn what_is_too_long_for_a_can_fd_frame_goes_as_several() {
        check(FD, 26, 104.8);
        check(FD, 64, 168.8);
        check(FD, 64 + 8, 168.8 + 55.8);
    }
}
