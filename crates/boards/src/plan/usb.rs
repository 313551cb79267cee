//! Bulk transfers over USB (USB 2.0, 5.8): bytes of a frame's budget.
//!
//! These are ceilings of the wire; the host's scheduling adds up to a frame of delay.

/// Signalling rate of a device.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum UsbRate {
    /// 12 Mbit/s, frames of 1 ms; all such devices behind one transaction translator share it.
    Full,
    /// 480 Mbit/s, frames of 125 us.
    High,
}

impl UsbRate {
    /// Returns the maximum payload of one transaction (bytes).
    pub const fn payload(self) -> usize {
        match self {
            Self::Full => 64,
            Self::High => 512,
        }
    }

    const fn overhead(self) -> usize {
        match self {
            Self::Full => 13,
            Self::High => 55,
        }
    }

    const fn budget(self) -> usize {
        match self {
            Self::Full => 1_500,
            Self::High => 7_500,
        }
    }

    /// Returns the period of frames (us).
    pub const fn frame_time(self) -> f64 {
        match self {
            Self::Full => 1_000.0,
            Self::High => 125.0,
        }
    }

    /// Returns the transactions with a payload of `bytes` that fit into one frame.
    pub const fn transactions_per_frame(self, bytes: usize) -> usize {
        self.budget() / (self.overhead() + bytes)
    }

    /// Returns the share of a frame's budget that a transfer takes (bytes). It ends with a
    /// transaction that is not full; one that fills its last needs an additional empty one.
    pub const fn cost(self, bytes: usize) -> usize {
        let transactions = bytes / self.payload() + 1;
        bytes + transactions * self.overhead()
    }

    /// Returns the share of the wire's time, as time, that a transfer takes (us).
    pub const fn time(self, bytes: usize) -> f64 {
        self.cost(bytes) as f64 / self.budget() as f64 * self.frame_time()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_transfer_that_fills_its_last_transaction_costs_an_empty_one_more() {
        assert_eq!(UsbRate::Full.cost(63), 63 + 13);
        assert_eq!(UsbRate::Full.cost(64), 64 + 2 * 13);
        assert_eq!(UsbRate::Full.cost(65), 65 + 2 * 13);
        assert_eq!(UsbRate::High.cost(512), 512 + 2 * 55);
    }
}
