//! What zeroes a board's motors when the host is silent.
//!
//! ```text
//! Waiting ── first frame ──▶ Fed ── 20 ms of silence ──▶ Safe (fades within 10 ms, stays)
//!    ▲                                                     │
//!    └──────────────────────── rearm ──────────────────────┘
//! ```

/// Silence after which the host counts as gone [s].
pub(super) const SILENCE: f64 = 20e-3;
/// Time in which the force fades then [s].
pub(super) const FADE: f64 = 10e-3;

/// The watchdog of one board; counts ticks of `period`.
#[derive(Clone, Copy, Debug)]
pub(super) struct Watchdog {
    period: f64,
    state: State,
}

#[derive(Clone, Copy, Debug)]
enum State {
    Waiting,
    Fed { silent: u32 },
    Safe { since: u32 },
}

impl Watchdog {
    /// A watchdog for ticks of `period` [s] that waits for the first frame.
    pub(super) const fn new(period: f64) -> Self {
        Self { period, state: State::Waiting }
    }

    /// Hears the host; says whether forces may be acted on.
    pub(super) const fn feed(&mut self) -> bool {
        match self.state {
            State::Waiting | State::Fed { .. } => {
                self.state = State::Fed { silent: 0 };
                true
            }
            State::Safe { .. } => false,
        }
    }

    /// Starts a tick; returns the share of the last forces to render in it, `0 ..= 1`.
    pub(super) fn tick(&mut self) -> f64 {
        match &mut self.state {
            State::Waiting => 0.0,
            State::Fed { silent } if f64::from(*silent) * self.period <= SILENCE => {
                *silent += 1;
                1.0
            }
            State::Fed { .. } => {
                self.state = State::Safe { since: 0 };
                self.tick()
            }
            State::Safe { since } => {
                *since = since.saturating_add(1);
                (1.0 - f64::from(*since) * self.period / FADE).max(0.0)
            }
        }
    }

    /// Whether it has tripped and not been armed since.
    pub(super) const fn is_safe(&self) -> bool {
        matches!(self.state, State::Safe { .. })
    }

    /// Leaves the safe state; waits for the first frame again.
    pub(super) const fn rearm(&mut self) {
        self.state = State::Waiting;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn fed() -> Watchdog {
        let mut watchdog = Watchdog::new(1e-3);
        assert!(watchdog.feed());
        watchdog
    }

    #[test]
    fn before_the_first_frame_there_is_no_force_and_no_trip() {
        let mut watchdog = Watchdog::new(1e-3);
        assert!((0..1_000).all(|_| watchdog.tick() <= 0.0));
        assert!(!watchdog.is_safe());
    }

    #[test]
    fn a_frame_in_every_tick_keeps_the_force() {
        let mut watchdog = fed();
        for _ in 0..1_000 {
            assert!(watchdog.feed());
            assert!(1.0 <= watchdog.tick());
        }
    }

    #[test]
    fn the_force_is_held_for_20_ms_and_gone_10_ms_later() {
        let mut watchdog = fed();
        let shares: Vec<_> = (0..40).map(|_| watchdog.tick()).collect();
        // Silence is 0 ms at the first tick, 20 ms at the 21st.
        assert!(shares[..21].iter().all(|share| 1.0 <= *share));
        assert!(shares[20..31].is_sorted_by(|before, after| after < before), "{shares:?}");
        assert!(shares[30..].iter().all(|share| *share <= 0.0), "{shares:?}");
    }

    #[test]
    fn it_stays_safe_when_the_host_comes_back_until_it_is_armed() {
        let mut watchdog = fed();
        for _ in 0..40 {
            let _share = watchdog.tick();
        }
        assert!(watchdog.is_safe() && !watchdog.feed());
        watchdog.rearm();
        assert!(!watchdog.is_safe() && watchdog.feed());
        assert!(1.0 <= watchdog.tick());
    }
}
