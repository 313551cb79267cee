use crate::clock::{ClockModel, ClockUpdate};
use crate::{periods::PING_US, rt::round_trips::RoundTripHistory};

/// Initial round trips, to learn a board's clock from.
const QUICK_PINGS: u32 = 8;
/// Round trips after which those for an unknown clock slow down, to relieve a busy machine. Distant
/// trips also determine a rate better.
const MOST_QUICK_PINGS: u32 = 32;
/// Interval of quick round trips (us).
const QUICK_PING_US: u64 = 10_000;

#[derive(Clone, Debug, Default)]
pub(super) struct BoardTiming {
    clock: ClockModel,
    round_trips: RoundTripHistory,
    /// Round trips since the clock was reset or has jumped.
    n_pings: u32,
    /// Due time of the next round trip (us).
    next_ping: u64,
    jumps: u64,
}

impl BoardTiming {
    pub(super) const fn clock(&self) -> &ClockModel {
        &self.clock
    }

    pub(super) const fn round_trips(&self) -> &RoundTripHistory {
        &self.round_trips
    }

    pub(super) const fn jumps(&self) -> u64 {
        self.jumps
    }

    pub(super) const fn is_known(&self) -> bool {
        QUICK_PINGS <= self.n_pings && self.clock.is_known()
    }

    /// Returns the clock's drift (1e-6, fast positive), if it exceeds the limit.
    pub(super) fn excess_ppm(&self) -> Option<i32> {
        self.clock.is_beyond_tolerance().then(|| millionths(self.clock.drift_ppm()))
    }

    /// Returns `true` if a round trip is due at `now` (us), and then expects it to be made.
    pub(super) const fn take_ping(&mut self, now: u64) -> bool {
        if now < self.next_ping {
            return false;
        }
        let is_quick =
            self.n_pings < QUICK_PINGS || self.n_pings < MOST_QUICK_PINGS && !self.clock.is_known();
        self.next_ping = now + if is_quick { QUICK_PING_US } else { PING_US };
        true
    }

    /// Learns from a round trip from `sent_us` to `now` (us).
    pub(super) fn learn(&mut self, sent_us: u64, board_us: u32, now: u64) {
        self.round_trips.push(now.saturating_sub(sent_us));
        match self.clock.learn(sent_us, board_us, now) {
            ClockUpdate::News => self.n_pings = self.n_pings.saturating_add(1),
            ClockUpdate::Jumped => {
                self.jumps += 1;
                self.n_pings = 0;
            }
        }
    }

    pub(super) fn on_start(&mut self) {
        self.clock = self.clock.set_anew();
        self.n_pings = 0;
    }

    /// Forgets the clock, for a board that was rejected for it and has restarted.
    pub(super) fn forget(&mut self) {
        self.clock = ClockModel::default();
        self.n_pings = 0;
    }
}

#[expect(clippy::cast_possible_truncation, reason = "saturates")]
const fn millionths(ppm: f64) -> i32 {
    ppm.round() as i32
}
