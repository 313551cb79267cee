//! A board's clock as the host estimates it: offset, rate and uncertainty.
//!
//! A round trip determines the board's time to within half its length. A line is therefore fitted
//! through the last 64 trips by least squares, each weighted by the inverse square of its length.
//! Trips that are close together do not determine the rate, and a rate error of 2 % makes a time
//! wrong by 1 ms after 50 ms. No age of a sample is returned before the rate is known. The rate
//! outlasts a reset of the clock, since the oscillator is the same.
//! Times are microseconds; the host's never wrap, the board's do.

use firmware_protocol::acyclic::ping::CLOCK_TOLERANCE_PPM;

const WINDOW: usize = 64;

/// Error of the rate below which it counts as known (1): 0.15 ms between two round trips.
const RATE_ERROR: f64 = 3e-3;

/// Largest accepted drift of a board's clock, fast or slow (1).
pub const MOST_DRIFT: f64 = CLOCK_TOLERANCE_PPM as f64 * 1e-6;

/// Largest credible drift of a clock that was not reset (1).
const MOST_BELIEVED: f64 = 0.1;

#[derive(Clone, Copy, PartialEq, Debug, Default)]
struct RoundTrip {
    /// Middle of the round trip, host time since the first (us).
    host: f64,
    /// Board time then, since the first (us).
    board: f64,
    /// Duration (us).
    length: f64,
}

/// Effect of a round trip.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum ClockUpdate {
    /// It was used.
    News,
    /// The board's clock jumped: the board has restarted.
    Jumped,
}

/// The clock of one board.
#[derive(Clone, Debug)]
pub struct ClockModel {
    trips: [RoundTrip; WINDOW],
    n: usize,
    /// Host and board time of the first trip (us).
    origin: Option<(u64, u32)>,
    /// Board time since the origin of the newest trip (us), whole.
    newest: i64,
    /// Board minus host time at `middle`, since the origin (us).
    offset: f64,
    /// Host time since the origin around which the line turns (us).
    middle: f64,
    /// Rate of the board's clock minus 1.
    drift: f64,
    /// Error bound of `drift`; infinite while nothing is known.
    drift_error: f64,
}

impl Default for ClockModel {
    fn default() -> Self {
        Self {
            trips: [RoundTrip::default(); WINDOW],
            n: 0,
            origin: None,
            newest: 0,
            offset: 0.0,
            middle: 0.0,
            drift: 0.0,
            drift_error: f64::INFINITY,
        }
    }
}

impl ClockModel {
    /// Learns from a round trip: request at `sent_us`, answer `board_us`, arrival at `heard_us`.
    ///
    /// # Real-time
    /// Two passes over 64 trips.
    pub fn learn(&mut self, sent_us: u64, board_us: u32, heard_us: u64) -> ClockUpdate {
        let middle_us = sent_us + heard_us.saturating_sub(sent_us) / 2;
        let (host_origin, board_origin) = *self.origin.get_or_insert((middle_us, board_us));
        let since = board_us.wrapping_sub(board_origin);
        // The board time nearest to the newest with these low bits.
        let [a, b, c, d, ..] = self.newest.to_le_bytes();
        let ahead = since.wrapping_sub(u32::from_le_bytes([a, b, c, d])).cast_signed();
        let board = self.newest + i64::from(ahead);
        let length = heard_us.saturating_sub(sent_us) as f64;
        let trip = RoundTrip {
            host: middle_us.saturating_sub(host_origin) as f64,
            board: board as f64,
            length,
        };
        if self.is_jump(&trip) {
            *self = self.set_anew();
            return ClockUpdate::Jumped;
        }
        self.newest = board;
        self.trips[self.n % WINDOW] = trip;
        self.n += 1;
        self.fit();
        ClockUpdate::News
    }

    /// Returns the same oscillator with an unknown offset.
    #[must_use]
    pub fn set_anew(&self) -> Self {
        let Self { drift, drift_error, .. } = *self;
        Self { drift, drift_error, ..Self::default() }
    }

    pub const fn is_known(&self) -> bool {
        0 < self.n && self.is_rate_known()
    }

    const fn is_rate_known(&self) -> bool {
        self.drift_error <= RATE_ERROR
    }

    /// Returns `true` if the board's clock is too fast or too slow for the board to be used.
    pub fn is_beyond_tolerance(&self) -> bool {
        self.is_rate_known() && MOST_DRIFT + self.drift_error < self.drift.abs()
    }

    /// Returns the board's time at the host's `host_us` (us), low half.
    pub fn board_us(&self, host_us: u64) -> Option<u32> {
        let (host_origin, board_origin) = self.origin?;
        let host = signed(host_us, host_origin);
        let board = host + self.offset + self.drift * (host - self.middle);
        #[expect(clippy::cast_possible_truncation, reason = "within days, and wrapping is meant")]
        let since = board.round() as i64;
        let [a, b, c, d, ..] = since.to_le_bytes();
        Some(board_origin.wrapping_add(u32::from_le_bytes([a, b, c, d])))
    }

    /// Returns the age (us) of a board's time with the low 16 bits `stamp_us`, at the host's
    /// `now_us`. At most 65 ms can be distinguished, 5 ms of them in the future.
    ///
    /// `None` before the rate of the board's clock is known.
    pub fn age_us(&self, now_us: u64, stamp_us: u16) -> Option<i32> {
        /// Largest time by which a stamp may be in the future rather than old (us).
        const FUTURE: u16 = 5_000;
        let told = self.board_us(now_us).filter(|_| self.is_rate_known())?;
        let [low, high, ..] = told.to_le_bytes();
        let age = u16::from_le_bytes([low, high]).wrapping_sub(stamp_us);
        Some(i32::from(age.wrapping_add(FUTURE)) - i32::from(FUTURE))
    }

    /// Returns the drift against the host's clock (1e-6, fast positive).
    pub fn drift_ppm(&self) -> f64 {
        self.drift * 1e6
    }

    fn remembered(&self) -> &[RoundTrip] {
        &self.trips[..self.n.min(WINDOW)]
    }

    /// Returns `true` if drift and the trip's length cannot explain its offset.
    fn is_jump(&self, trip: &RoundTrip) -> bool {
        if self.n == 0 {
            return false;
        }
        let newest = self.trips[(self.n - 1) % WINDOW];
        let passed = trip.host - newest.host;
        let allowed = MOST_BELIEVED * passed.abs() + trip.length + newest.length + 1e3;
        allowed < (trip.board - newest.board - passed).abs()
    }

    /// Fits the line; short trips weigh more.
    fn fit(&mut self) {
        let trips = self.remembered();
        let sum = |value: &dyn Fn(&RoundTrip) -> f64| -> f64 {
            trips.iter().map(|trip| trip.weight() * value(trip)).sum()
        };
        let all = sum(&|_| 1.0);
        let middle = sum(&|trip| trip.host) / all;
        let offset = sum(&|trip| trip.board - trip.host) / all;
        let spread = sum(&|trip| (trip.host - middle).powi(2));
        let covariance = sum(&|trip| (trip.host - middle) * (trip.board - trip.host - offset));
        (self.middle, self.offset) = (middle, offset);
        // No trip is wrong by more than half its length, so this is a safe bound.
        let error = spread.sqrt().recip();
        // The rate from before a reset holds until it is known as well again.
        if error <= RATE_ERROR {
            self.drift = (covariance / spread).clamp(-MOST_BELIEVED, MOST_BELIEVED);
            self.drift_error = error;
        }
    }
}

impl RoundTrip {
    fn weight(&self) -> f64 {
        // Below 50 us the difference is noise of the system.
        self.length.max(50.0).powi(-2)
    }
}

/// Returns the low half of a clock (us), as on the wire.
pub(crate) const fn low(us: u64) -> u32 {
    let [a, b, c, d, ..] = us.to_le_bytes();
    u32::from_le_bytes([a, b, c, d])
}

fn signed(later: u64, earlier: u64) -> f64 {
    later as f64 - earlier as f64
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A delay of 150 us each way, with random extra (us).
    fn way(n: u64) -> (u64, u64) {
        let chance = |n: u64| (n.wrapping_mul(0x9E37_79B9_7F4A_7C15) >> 40) % 1_000;
        let late = |n: u64| if chance(n) < 700 { chance(n) / 10 } else { 4 * chance(n) };
        (150 + late(2 * n), 150 + late(2 * n + 1))
    }

    fn learned(n: u64, rate: f64, board_us: u32) -> (ClockModel, impl Fn(u64) -> u32) {
        learned_every(20_000, n, rate, board_us)
    }

    /// Returns a clock that learned from trips `every` (us).
    fn learned_every(
        every: u64,
        n: u64,
        rate: f64,
        board_us: u32,
    ) -> (ClockModel, impl Fn(u64) -> u32) {
        let board = move |host: u64| {
            #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "low half")]
            let passed = (host as f64 * rate) as u64 as u32;
            board_us.wrapping_add(passed)
        };
        let mut clock = ClockModel::default();
        for i in 0..n {
            let (there, back) = way(i);
            let sent = 1_000_000 + every * i;
            assert_eq!(
                clock.learn(sent, board(sent + there), sent + there + back),
                ClockUpdate::News
            );
        }
        (clock, board)
    }

    #[test]
    fn the_board_s_time_is_known_better_than_half_the_shortest_trip() {
        for rate in [1.0, 1.0 + 200e-6, 1.0 - 200e-6, 1.04, 0.96] {
            let (clock, board) = learned(200, rate, u32::MAX - 2_000_000);
            let now = 1_000_000 + 20_000 * 200;
            let error = clock.board_us(now).unwrap().wrapping_sub(board(now)).cast_signed();
            assert!(error.abs() < 150, "{error} us at rate {rate}");
            assert!((clock.drift_ppm() * 1e-6 - (rate - 1.0)).abs() < 100e-6, "{rate}");
        }
    }

    #[test]
    fn the_age_of_a_stamp_is_told_across_its_wrap() {
        let (clock, board) = learned(100, 1.0, 65_000);
        let now = 1_000_000 + 20_000 * 100;
        for age in [0, 900, 20_000, 59_000] {
            let [low, high, ..] = board(now - age).to_le_bytes();
            let told = clock.age_us(now, u16::from_le_bytes([low, high])).unwrap();
            assert!((i64::from(told) - age.cast_signed()).abs() < 150, "{told} for {age}");
        }
    }

    #[test]
    fn a_clock_that_was_set_anew_runs_as_fast_as_before() {
        let (mut clock, board) = learned(100, 0.98, 5_000_000);
        let now = 1_000_000 + 20_000 * 100;
        let set = |host| board(host).wrapping_sub(3_000_000);
        assert_eq!(clock.learn(now, set(now + 150), now + 300), ClockUpdate::Jumped);
        clock.learn(now, set(now + 150), now + 300);
        assert!(clock.is_known());
        let later = now + 300_000;
        let error = clock.board_us(later).unwrap().wrapping_sub(set(later)).cast_signed();
        assert!(error.abs() < 100, "{error} us");
    }

    #[test]
    fn no_age_is_told_before_the_rate_is_known() {
        for n in 1..60 {
            let (clock, board) = learned_every(5_000, n, 1.03, 77);
            let now = 1_000_000 + 5_000 * n + 50_000;
            let [low, high, ..] = board(now).to_le_bytes();
            let Some(age) = clock.age_us(now, u16::from_le_bytes([low, high])) else {
                assert!(n < 50, "still not known");
                continue;
            };
            // Half a trip, and the rate error over 50 ms.
            assert!(8 < n && age.abs() < 300, "{age} us after {n} trips");
        }
    }

    #[test]
    fn a_clock_is_beyond_the_tolerance_when_that_is_sure() {
        for (rate, is_beyond) in
            [(1.0, false), (1.0295, false), (0.9705, false), (1.032, true), (0.968, true)]
        {
            let (clock, _board) = learned(200, rate, 0);
            assert_eq!(clock.is_beyond_tolerance(), is_beyond, "{} ppm", clock.drift_ppm());
        }
        assert!(!learned(2, 1.05, 0).0.is_beyond_tolerance(), "two trips say nothing");
    }

    #[test]
    fn quick_trips_at_the_start_do_not_tell_a_rate() {
        let mut clock = ClockModel::default();
        for i in 0..8 {
            // Short trips with the largest error, always in the same direction.
            let sent = 1_000_000 + 5_000 * i;
            clock.learn(sent, low(sent + 10 + 20 * i), sent + 300);
        }
        let later = 1_000_000 + 2_500_000;
        for i in 0..4 {
            let sent = later + 50_000 * i;
            clock.learn(sent, low(sent + 1_000), sent + 2_000);
        }
        let now = later + 300_000;
        let error = clock.board_us(now).unwrap().wrapping_sub(low(now)).cast_signed();
        assert!(error.abs() < 500, "{error} us, {} ppm", clock.drift_ppm());
    }
}
