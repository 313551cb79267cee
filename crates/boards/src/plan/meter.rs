//! Load of a bus by its observed frames.

use super::{Medium, can::Stuffing};

#[derive(Clone, Copy, PartialEq, Debug)]
struct Meter {
    medium: Medium,
    frames: u64,
    least: f64,
    most: f64,
}

/// Traffic in a window of time.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct MeterWindow {
    pub frames: u64,
    pub rate: f64,
    /// Share of the medium's time without any stuff bits.
    pub least: f64,
    /// Share of the medium's time with the worst payloads, as planned.
    pub most: f64,
}

impl Meter {
    const fn new(medium: Medium) -> Self {
        Self { medium, frames: 0, least: 0.0, most: 0.0 }
    }

    fn saw(&mut self, len: usize) {
        self.frames += 1;
        self.least += self.medium.time(len, Stuffing::Fewest);
        self.most += self.medium.time(len, Stuffing::Most);
    }

    fn since(&self, earlier: &Self) -> Self {
        Self {
            medium: self.medium,
            frames: self.frames.saturating_sub(earlier.frames),
            least: self.least - earlier.least,
            most: self.most - earlier.most,
        }
    }

    fn seen(&self, seconds: f64) -> MeterWindow {
        let share = |micros: f64| micros * 1e-6 / seconds;
        MeterWindow {
            frames: self.frames,
            rate: self.frames as f64 / seconds,
            least: share(self.least),
            most: share(self.most),
        }
    }
}

/// Counter of frames in both directions of a link.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct LinkMeter {
    down: Meter,
    up: Meter,
}

impl LinkMeter {
    pub const fn new(medium: Medium) -> Self {
        Self { down: Meter::new(medium), up: Meter::new(medium) }
    }

    /// Counts a frame of `len` bytes from the host.
    ///
    /// # Real-time
    /// Some dozens of operations, at any length; no heap.
    pub fn saw_down(&mut self, len: usize) {
        self.down.saw(len);
    }

    /// Counts a frame of `len` bytes to the host, bounded like [`Self::saw_down`].
    pub fn saw_up(&mut self, len: usize) {
        self.up.saw(len);
    }

    #[must_use]
    pub fn since(&self, earlier: &Self) -> Self {
        Self { down: self.down.since(&earlier.down), up: self.up.since(&earlier.up) }
    }

    /// Returns the traffic in `seconds`: both directions if they take turns, else the busier one.
    pub fn seen(&self, seconds: f64) -> MeterWindow {
        let (down, up) = (self.down.seen(seconds), self.up.seen(seconds));
        if self.up.medium.is_shared() {
            return MeterWindow {
                frames: down.frames + up.frames,
                rate: down.rate + up.rate,
                least: down.least + up.least,
                most: down.most + up.most,
            };
        }
        if down.most < up.most { up } else { down }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::plan::{BusPlan, Extras, ForcePacking, SamplePacking, standard, uart::Wiring};

    const FD: Medium = Medium::CanFd { nominal: 1_000_000, data: 5_000_000 };

    #[test]
    fn frames_as_planned_are_seen_as_planned() {
        let plan = BusPlan {
            name: "can0".to_owned(),
            medium: FD,
            boards: standard(0..8),
            samples: SamplePacking::Position16Velocity,
            forces: ForcePacking::Force16,
            sample_rate: 500.0,
            force_rate: 250.0,
            extras: Extras::NONE,
        };
        let mut meter = LinkMeter::new(FD);
        for frame in 0..8 * 500 {
            meter.saw_up(plan.samples.frame_len(11));
            if frame % 2 == 0 {
                meter.saw_down(plan.forces.frame_len(11));
            }
        }
        let seen = meter.seen(1.0);
        assert_eq!((seen.frames, seen.rate.round()), (6_000, 6_000.0));
        assert!((seen.most - plan.load()).abs() < 1e-9, "{seen:?}");
        assert!(seen.least < seen.most && 0.8 * seen.most < seen.least, "{seen:?}");
    }

    #[test]
    fn a_window_does_not_know_what_was_before_it() {
        let mut meter = LinkMeter::new(FD);
        (0..1_000).for_each(|_| meter.saw_up(60));
        let before = meter;
        meter.saw_up(26);
        let mut alone = LinkMeter::new(FD);
        alone.saw_up(26);
        let (seen, wanted) = (meter.since(&before).seen(1.0), alone.seen(1.0));
        assert_eq!(seen.frames, 1);
        assert!((seen.most - wanted.most).abs() < 1e-9, "{seen:?}");
    }

    #[test]
    fn directions_that_take_turns_add_up_and_others_do_not() {
        let both = |medium| {
            let mut meter = LinkMeter::new(medium);
            meter.saw_down(26);
            (0..2).for_each(|_| meter.saw_up(26));
            meter.seen(1e-3).most
        };
        let line = |wiring| Medium::Uart { baud: 1_000_000, wiring };
        assert!((both(FD) - 3.0 * 0.1048).abs() < 1e-9);
        assert!((both(line(Wiring::FullDuplex)) - 2.0 * 0.3).abs() < 1e-9);
        assert!((both(line(Wiring::HalfDuplex { turnaround: 0 })) - 3.0 * 0.3).abs() < 1e-9);
    }
}
