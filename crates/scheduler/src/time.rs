//! Host time in integer nanoseconds, and the due time of each tick.
//!
//! The only clock arithmetic in the workspace. A due time is computed from the tick's number,
//! never accumulated, so a rate that does not divide a second keeps exact time for days.

const SECOND: u64 = 1_000_000_000;

/// Fastest accepted tick rate (1/s); far above what a host can keep.
const MAX_TICK_HZ: u32 = 100_000;

/// Monotonic host time, or a span of it, in nanoseconds.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug, Default, Hash)]
#[must_use]
pub struct Nanos(u64);

impl Nanos {
    /// Origin of the clock; empty span.
    pub const ZERO: Self = Self(0);

    pub const fn new(nanoseconds: u64) -> Self {
        Self(nanoseconds)
    }

    pub const fn from_micros(microseconds: u64) -> Self {
        Self(microseconds.saturating_mul(1_000))
    }

    pub const fn from_millis(milliseconds: u64) -> Self {
        Self(milliseconds.saturating_mul(1_000_000))
    }

    pub const fn as_u64(self) -> u64 {
        self.0
    }

    pub const fn as_secs_f64(self) -> f64 {
        self.0 as f64 * 1e-9
    }

    /// Returns the time since `earlier`; zero if `earlier` is later.
    pub const fn since(self, earlier: Self) -> Self {
        Self(self.0.saturating_sub(earlier.0))
    }

    /// Returns the time `span` before `self`, or the origin.
    pub const fn before(self, span: Self) -> Self {
        Self(self.0.saturating_sub(span.0))
    }

    pub const fn after(self, span: Self) -> Self {
        Self(self.0.saturating_add(span.0))
    }
}

/// Time between ticks, kept as a rate so that no rounding adds up.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Period {
    hz: u32,
}

impl Period {
    /// Returns the period of `tick_hz` ticks a second; `None` outside `1 ..= 100_000`.
    pub const fn from_hz(tick_hz: u32) -> Option<Self> {
        if 0 < tick_hz && tick_hz <= MAX_TICK_HZ { Some(Self { hz: tick_hz }) } else { None }
    }

    pub const fn hz(self) -> u32 {
        self.hz
    }

    pub fn as_secs_f64(self) -> f64 {
        1.0 / f64::from(self.hz)
    }

    /// Returns the time of `ticks` ticks, rounded down to a nanosecond.
    pub const fn span(self, ticks: u64) -> Nanos {
        let hz = self.hz as u64;
        // Whole seconds first: `ticks * SECOND` would overflow after days.
        Nanos((ticks / hz).saturating_mul(SECOND).saturating_add(ticks % hz * SECOND / hz))
    }

    /// Returns the largest number of ticks whose [`Period::span`] is at most `span`.
    pub const fn ticks_in(self, span: Nanos) -> u64 {
        let hz = self.hz as u64;
        let fraction = span.0 % SECOND;
        // Spans are rounded down, so a tick counts from the nanosecond in which it begins.
        (span.0 / SECOND).saturating_mul(hz).saturating_add(((fraction + 1) * hz - 1) / SECOND)
    }
}

/// Due times of all ticks.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Timetable {
    /// Tick that is due at `start`.
    first: u64,
    start: Nanos,
    period: Period,
}

impl Timetable {
    /// Returns a timetable with tick 0 due at `start`, and one more every `period`.
    pub const fn new(start: Nanos, period: Period) -> Self {
        Self { first: 0, start, period }
    }

    /// Returns a timetable of equal rate with `tick` due at `due`; earlier ticks are forgotten.
    #[must_use]
    pub const fn moved(self, tick: u64, due: Nanos) -> Self {
        Self { first: tick, start: due, period: self.period }
    }

    pub const fn period(self) -> Period {
        self.period
    }

    pub const fn due(self, tick: u64) -> Nanos {
        self.start.after(self.period.span(tick.saturating_sub(self.first)))
    }

    /// Returns the time by which the forces of `tick` must be out: when the next one is due.
    pub const fn deadline(self, tick: u64) -> Nanos {
        self.due(tick.saturating_add(1))
    }

    /// Returns the newest tick that is due at `now`; `None` before the start.
    pub fn newest(self, now: Nanos) -> Option<u64> {
        let elapsed = || now.since(self.start);
        (self.start <= now).then(|| self.first.saturating_add(self.period.ticks_in(elapsed())))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn timetable(start: u64, hz: u32) -> Timetable {
        Timetable::new(Nanos::new(start), Period::from_hz(hz).unwrap())
    }

    #[test]
    fn rates_outside_the_range_are_refused() {
        assert_eq!(Period::from_hz(0), None);
        assert_eq!(Period::from_hz(100_001), None);
        assert!(Period::from_hz(100_000).is_some());
    }

    #[test]
    fn a_rate_that_does_not_divide_a_second_does_not_drift() {
        let hz = 44_100;
        let year_of_seconds = 365 * 24 * 3600;
        let tick = year_of_seconds * u64::from(hz);
        assert_eq!(timetable(7, hz).due(tick), Nanos::new(7 + year_of_seconds * SECOND));
        assert_eq!(timetable(0, 3).due(1), Nanos::new(333_333_333));
        assert_eq!(timetable(0, 3).due(2), Nanos::new(666_666_666));
    }

    #[test]
    fn a_moved_timetable_goes_on_counting() {
        let moved = timetable(0, 1000).moved(500, Nanos::new(77));
        assert_eq!(moved.due(502), Nanos::new(2_000_077));
        assert_eq!(moved.newest(Nanos::new(76)), None);
        assert_eq!(moved.newest(Nanos::new(77)), Some(500));
    }

    proptest! {
        #[test]
        fn the_newest_tick_is_due_and_the_next_is_not(
            start in 0..SECOND, elapsed in 0..u64::MAX / 4, hz in 1..=MAX_TICK_HZ,
        ) {
            let timetable = timetable(start, hz);
            let now = Nanos::new(start + elapsed);
            let newest = timetable.newest(now).unwrap();
            assert!(timetable.due(newest) <= now);
            assert!(now < timetable.due(newest + 1));
        }
    }
}
