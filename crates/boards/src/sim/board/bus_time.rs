//! Bus time as a board knows it, for the age of multicast forces.

use firmware_protocol::frame::multicast_forces::GROUPS;
use firmware_protocol::sequence::{FrameOrder, SequenceNumber};

use crate::clock::low;

/// Time without bus time after which it counts as unknown (us).
const FORGET_US: u64 = 1_000_000;

/// Largest age that can be distinguished from the future: half of what 16 bits hold (us).
const OLDEST_US: u16 = 32_000;

/// Silence after which any frame is new (us).
const SILENCE_US: u64 = 60_000;

#[derive(Clone, Copy, Debug, Default)]
pub(super) struct BusTime {
    /// Own time minus bus time, low bits (us), and time of its reception (us).
    offset: Option<(u32, u64)>,
    /// Newest frame of each group, and time of its reception (us).
    newest: [Option<(SequenceNumber, u64)>; GROUPS],
}

impl BusTime {
    pub(super) const fn hear(&mut self, now_us: u64, host_us: u32) {
        self.offset = Some((low(now_us).wrapping_sub(host_us), now_us));
    }

    /// Returns the age of a bus time with these low bits (us); `None` if it is unknown.
    pub(super) fn age_us(&self, now_us: u64, stamp_us: u16) -> Option<u64> {
        let (offset, heard_us) = self.offset?;
        let [a, b, ..] = low(now_us).wrapping_sub(offset).to_le_bytes();
        // A frame may overtake the bus time by a little; its age is 0.
        let age = u16::from_le_bytes([a, b]).wrapping_sub(stamp_us);
        let is_known = now_us.saturating_sub(heard_us) < FORGET_US;
        let is_ahead = u16::MAX - 5_000 < age;
        match age {
            _ if !is_known => None,
            _ if is_ahead => Some(0),
            _ => (age <= OLDEST_US).then_some(age.into()),
        }
    }

    pub(super) fn accept(&mut self, group: u8, sequence: SequenceNumber, now_us: u64) -> bool {
        let Some(newest) = self.newest.get_mut(usize::from(group)) else { return false };
        let is_newer = newest.is_none_or(|(before, at)| {
            let arrival = sequence.after(before);
            SILENCE_US < now_us.saturating_sub(at) || matches!(arrival, FrameOrder::Newer { .. })
        });
        if is_newer {
            *newest = Some((sequence, now_us));
        }
        is_newer
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_age_is_told_by_bus_time_and_only_while_that_is_known() {
        let mut time = BusTime::default();
        assert_eq!(time.age_us(5_000, 0), None);
        time.hear(1_000_000, 70_000);
        // At 1 012 000 the bus shows 82 000; its low 16 bits are 16 464.
        assert_eq!(time.age_us(1_012_000, 16_464), Some(0));
        assert_eq!(time.age_us(1_012_000, 16_464 - 9_000), Some(9_000));
        assert_eq!(time.age_us(1_012_000, 16_464 + 1_000), Some(0));
        assert_eq!(time.age_us(1_012_000, 16_464_u16.wrapping_sub(40_000)), None);
        assert_eq!(time.age_us(2_000_001, 0), None);
    }

    #[test]
    fn an_overtaken_frame_is_no_news() {
        let mut time = BusTime::default();
        let news = |time: &mut BusTime, n, at| time.accept(1, SequenceNumber(n), at);
        assert!(news(&mut time, 7, 0) && news(&mut time, 9, 1_000));
        assert!(!news(&mut time, 8, 2_000) && !news(&mut time, 9, 2_000));
        assert!(news(&mut time, 3, 100_000), "after a silence");
    }
}
