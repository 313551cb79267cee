//! Whether a board may render forces: armed, safe, and what has expired.
//!
//! ```text
//! Safe ── disarm (gives a nonce) ──▶ Disarmed ── arm (takes it) ──▶ Armed
//!  ▲                                    ▲                             │
//!  │  expired: fades in 10 ms           └──────── disarm ─────────────┤
//!  └──────────────── or stopped, or a key failed ◀────────────────────┘
//! ```
//!
//! Times are the board's own [us].

use firmware_protocol::acyclic::arm::FADE_MS;
use firmware_protocol::frame::hello::safe_reason;

/// Time in which a force fades [us].
const FADE_US: f64 = FADE_MS as f64 * 1e3;

/// What a board may do.
#[derive(Clone, Copy, PartialEq, Debug)]
enum State {
    /// Nothing, for this reason, since then; the force of before fades.
    Safe { reason: u8, since_us: u64 },
    /// Nothing yet; whoever says this nonce may arm it.
    Disarmed { nonce: u32, since_us: u64 },
    /// It renders forces; the newest ones expire then. Nothing expires before the first.
    Armed { expires_us: Option<u64> },
}

/// The guard of one board.
#[derive(Clone, Copy, Debug)]
pub(super) struct Guard {
    state: State,
    /// How long forces are valid [us].
    valid_us: u64,
    /// What the next nonce is made of.
    seed: u32,
    /// Times that forces expired.
    trips: u16,
    /// Times that it was armed.
    armings: u16,
}

/// Why a board was not armed.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum NotArmed {
    /// It was not disarmed before.
    NotDisarmed,
    /// The nonce is another one.
    WrongNonce,
}

impl Guard {
    /// A board that was just switched on.
    pub(super) const fn new(seed: u32) -> Self {
        let state = State::Safe { reason: safe_reason::NEVER_ARMED, since_us: 0 };
        Self { state, valid_us: 0, seed, trips: 0, armings: 0 }
    }

    /// Takes all forces away; returns the nonce for arming.
    pub(super) const fn disarm(&mut self, now_us: u64) -> u32 {
        self.seed = self.seed.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
        let since_us = match self.state {
            State::Safe { since_us, .. } | State::Disarmed { since_us, .. } => since_us,
            State::Armed { .. } => now_us,
        };
        self.state = State::Disarmed { nonce: self.seed, since_us };
        self.seed
    }

    /// Arms the board for forces that are valid for `valid_us`.
    pub(super) const fn arm(&mut self, nonce: u32, valid_us: u64) -> Result<(), NotArmed> {
        match self.state {
            State::Disarmed { nonce: given, .. } if given == nonce => {
                self.force_armed(valid_us);
                Ok(())
            }
            State::Disarmed { .. } => Err(NotArmed::WrongNonce),
            State::Safe { .. } | State::Armed { .. } => Err(NotArmed::NotDisarmed),
        }
    }

    /// Arms the board without asking, as in a simulation without a link.
    pub(super) const fn force_armed(&mut self, valid_us: u64) {
        self.state = State::Armed { expires_us: None };
        self.valid_us = valid_us;
        self.armings = self.armings.saturating_add(1);
    }

    /// Takes note of forces that answer samples of `answered_us`; says whether they may be
    /// rendered.
    pub(super) const fn feed(&mut self, answered_us: u64, now_us: u64) -> Fed {
        let expires_us = answered_us.saturating_add(self.valid_us);
        match self.state {
            State::Armed { .. } if now_us <= expires_us => {
                self.state = State::Armed { expires_us: Some(expires_us) };
                Fed::Rendered
            }
            State::Armed { .. } => Fed::Stale,
            // A board that was never armed cannot tell.
            State::Safe { .. } | State::Disarmed { .. }
                if 0 < self.valid_us && expires_us < now_us =>
            {
                Fed::Stale
            }
            State::Safe { .. } | State::Disarmed { .. } => Fed::Unarmed,
        }
    }

    /// Goes safe for `reason`; a board that is safe already keeps its first reason.
    pub(super) const fn trip(&mut self, reason: u8, now_us: u64) {
        if !matches!(self.state, State::Safe { .. }) {
            self.state = State::Safe { reason, since_us: now_us };
        }
    }

    /// Looks whether anything has expired by now; returns the share of the last forces to
    /// render, `0 ..= 1`.
    pub(super) fn share(&mut self, now_us: u64) -> f64 {
        match self.state {
            State::Armed { expires_us: None } => 0.0,
            State::Armed { expires_us: Some(expires_us) } if now_us <= expires_us => 1.0,
            State::Armed { expires_us: Some(expires_us) } => {
                self.trips = self.trips.saturating_add(1);
                self.state = State::Safe { reason: safe_reason::SILENCE, since_us: expires_us };
                self.share(now_us)
            }
            State::Safe { since_us, .. } | State::Disarmed { since_us, .. } => {
                let passed = now_us.saturating_sub(since_us) as f64;
                (1.0 - passed / FADE_US).max(0.0)
            }
        }
    }

    /// Whether forces are rendered.
    pub(super) const fn is_armed(&self) -> bool {
        matches!(self.state, State::Armed { .. })
    }

    /// Why no forces are rendered, as the hello says it.
    pub(super) const fn reason(&self) -> u8 {
        match self.state {
            State::Safe { reason, .. } => reason,
            State::Disarmed { .. } => safe_reason::DISARMED,
            State::Armed { .. } => safe_reason::NONE,
        }
    }

    /// Times that forces expired, and that it was armed.
    pub(super) const fn counts(&self) -> (u16, u16) {
        (self.trips, self.armings)
    }
}

/// What becomes of forces that came.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum Fed {
    /// They are rendered.
    Rendered,
    /// They are too old.
    Stale,
    /// The board is not armed.
    Unarmed,
}

#[cfg(test)]
mod tests {
    use super::*;

    const VALID: u64 = 20_000;

    fn armed() -> Guard {
        let mut guard = Guard::new(7);
        let nonce = guard.disarm(0);
        assert_eq!(guard.arm(nonce, VALID), Ok(()));
        guard
    }

    #[test]
    fn it_is_armed_by_the_nonce_that_was_given_out_and_only_once() {
        let mut guard = Guard::new(7);
        assert_eq!(guard.arm(7, VALID), Err(NotArmed::NotDisarmed));
        let (old, nonce) = (guard.disarm(0), guard.disarm(0));
        assert_ne!(old, nonce);
        assert_eq!(guard.arm(old, VALID), Err(NotArmed::WrongNonce));
        assert_eq!(guard.arm(nonce, VALID), Ok(()));
        assert_eq!(guard.arm(nonce, VALID), Err(NotArmed::NotDisarmed));
    }

    #[test]
    fn before_the_first_force_there_is_none_and_nothing_expires() {
        let mut guard = armed();
        assert!((0..1_000_000).step_by(1_000).all(|now| guard.share(now) <= 0.0));
        assert!(guard.is_armed());
    }

    #[test]
    fn a_force_expires_and_fades_within_10_ms() {
        let mut guard = armed();
        assert_eq!(guard.feed(1_000, 1_500), Fed::Rendered);
        assert!(1.0 <= guard.share(21_000));
        let shares: Vec<_> = (0..12).map(|ms| guard.share(21_001 + 1_000 * ms)).collect();
        assert!(shares.is_sorted_by(|one, next| next <= one), "{shares:?}");
        assert!(0.99 < shares[0] && shares[10..].iter().all(|share| *share <= 0.0), "{shares:?}");
        assert_eq!((guard.is_armed(), guard.counts()), (false, (1, 1)));
    }

    #[test]
    fn it_stays_safe_until_it_is_disarmed_and_armed() {
        let mut guard = armed();
        assert_eq!(guard.feed(0, 0), Fed::Rendered);
        assert!(guard.share(50_000) <= 0.0);
        assert_eq!(guard.feed(50_000, 50_000), Fed::Unarmed);
        let nonce = guard.disarm(60_000);
        assert_eq!(guard.feed(60_000, 60_000), Fed::Unarmed);
        assert_eq!(guard.arm(nonce, VALID), Ok(()));
        assert_eq!(guard.feed(60_000, 60_000), Fed::Rendered);
        assert!(1.0 <= guard.share(61_000));
    }

    #[test]
    fn a_force_that_answers_old_samples_is_stale_and_does_not_feed() {
        let mut guard = armed();
        assert_eq!(guard.feed(0, 0), Fed::Rendered);
        assert_eq!(guard.feed(0, 20_001), Fed::Stale);
        assert!(guard.share(20_001) < 1.0 && !guard.is_armed());
    }

    #[test]
    fn a_stop_keeps_its_reason() {
        let mut guard = armed();
        guard.trip(safe_reason::EMERGENCY_STOP, 5);
        guard.trip(safe_reason::KEY_FAULT, 6);
        assert_eq!(guard.reason(), safe_reason::EMERGENCY_STOP);
    }
}
