//! Interlock of a board's forces: armed, safe, expired.
//!
//! ```text
//! Safe ── disarm (gives a nonce) ──▶ Disarmed ── arm (takes it) ──▶ Armed
//!  ▲                                    ▲                             │
//!  │  expired: fades in 10 ms           └──────── disarm ─────────────┤
//!  └──────────────── or stopped, or a key failed ◀────────────────────┘
//! ```
//!
//! Forces expire only from the first one after an arming, since no force is rendered before.
//!
//! A board that was stopped, or has a failed key, is safe until a power cycle: these reasons
//! replace any lesser one. Times are the board's own (us).

use firmware_protocol::{acyclic::arm::FADE_MS, frame::hello::safe_reason};

const FADE_US: f64 = FADE_MS as f64 * 1e3;

#[derive(Clone, Copy, PartialEq, Debug)]
enum InterlockState {
    /// Renders nothing, for this reason; the earlier force fades from `fades_us` on, if any.
    Safe { reason: u8, fades_us: Option<u64> },
    /// Renders nothing yet; a request with this nonce may arm it.
    Disarmed { nonce: u32, fades_us: Option<u64> },
    /// Renders forces until they expire; there is no expiration before the first.
    Armed { expires_us: Option<u64> },
}

#[derive(Clone, Copy, Debug)]
pub(super) struct ForceInterlock {
    state: InterlockState,
    valid_us: u64,
    seed: u32,
    trips: u16,
    armings: u16,
}

#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum NotArmed {
    NotDisarmed,
    WrongNonce,
}

impl ForceInterlock {
    pub(super) const fn new(seed: u32) -> Self {
        let state = InterlockState::Safe { reason: safe_reason::NEVER_ARMED, fades_us: None };
        Self { state, valid_us: 0, seed, trips: 0, armings: 0 }
    }

    /// Removes all forces; returns the nonce for arming, or `None` if it is safe for good.
    pub(super) const fn disarm(&mut self, now_us: u64) -> Option<u32> {
        if self.is_latched() {
            return None;
        }
        self.seed = self.seed.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
        self.state = InterlockState::Disarmed { nonce: self.seed, fades_us: self.fades_us(now_us) };
        Some(self.seed)
    }

    const fn is_latched(&self) -> bool {
        matches!(self.state, InterlockState::Safe { reason, .. } if latches(reason))
    }

    /// Returns the time from which forces removed at `now_us` fade; expired ones began before.
    const fn fades_us(&self, now_us: u64) -> Option<u64> {
        match self.state {
            InterlockState::Safe { fades_us, .. } | InterlockState::Disarmed { fades_us, .. } => {
                fades_us
            }
            InterlockState::Armed { expires_us: Some(expires_us) } if now_us < expires_us => {
                Some(now_us)
            }
            InterlockState::Armed { expires_us } => expires_us,
        }
    }

    pub(super) const fn arm(&mut self, nonce: u32, valid_us: u64) -> Result<(), NotArmed> {
        match self.state {
            InterlockState::Disarmed { nonce: given, .. } if given == nonce => {
                self.force_armed(valid_us);
                Ok(())
            }
            InterlockState::Disarmed { .. } => Err(NotArmed::WrongNonce),
            InterlockState::Safe { .. } | InterlockState::Armed { .. } => {
                Err(NotArmed::NotDisarmed)
            }
        }
    }

    /// Arms the board without a nonce, for a simulation without a link.
    pub(super) const fn force_armed(&mut self, valid_us: u64) {
        self.state = InterlockState::Armed { expires_us: None };
        self.valid_us = valid_us;
        self.armings = self.armings.saturating_add(1);
    }

    /// Records forces that answer samples of `answered_us`; returns their permission.
    pub(super) const fn feed(&mut self, answered_us: u64, now_us: u64) -> ForceDecision {
        let fed = self.judge(answered_us, now_us);
        let until_us = answered_us.saturating_add(self.valid_us);
        if let (ForceDecision::Rendered, InterlockState::Armed { expires_us }) =
            (fed, &mut self.state)
        {
            *expires_us = match *expires_us {
                Some(later_us) if until_us < later_us => Some(later_us),
                Some(_) | None => Some(until_us),
            };
        }
        fed
    }

    pub(super) const fn judge(&self, answered_us: u64, now_us: u64) -> ForceDecision {
        let expires_us = answered_us.saturating_add(self.valid_us);
        match self.state {
            InterlockState::Armed { .. } if now_us <= expires_us => ForceDecision::Rendered,
            InterlockState::Armed { .. } => ForceDecision::Stale,
            // A board that was never armed cannot tell.
            InterlockState::Safe { .. } | InterlockState::Disarmed { .. }
                if 0 < self.valid_us && expires_us < now_us =>
            {
                ForceDecision::Stale
            }
            InterlockState::Safe { .. } | InterlockState::Disarmed { .. } => ForceDecision::Unarmed,
        }
    }

    /// Goes safe for `reason`; a safe board keeps its first reason unless only the new one latches.
    pub(super) const fn trip(&mut self, reason: u8, now_us: u64) {
        let is_safe = matches!(self.state, InterlockState::Safe { .. });
        if !self.is_latched() && (!is_safe || latches(reason)) {
            self.state = InterlockState::Safe { reason, fades_us: self.fades_us(now_us) };
        }
    }

    /// Checks for expiration; returns the share of the last forces to render, `0 ..= 1`.
    pub(super) fn share(&mut self, now_us: u64) -> f64 {
        match self.state {
            InterlockState::Armed { expires_us: None } => 0.0,
            InterlockState::Armed { expires_us: Some(expires_us) } if now_us <= expires_us => 1.0,
            InterlockState::Armed { expires_us: Some(expires_us) } => {
                self.trips = self.trips.saturating_add(1);
                let fades_us = Some(expires_us);
                self.state = InterlockState::Safe { reason: safe_reason::SILENCE, fades_us };
                self.share(now_us)
            }
            InterlockState::Safe { fades_us, .. } | InterlockState::Disarmed { fades_us, .. } => {
                let left = |since_us| 1.0 - now_us.saturating_sub(since_us) as f64 / FADE_US;
                fades_us.map_or(0.0, left).max(0.0)
            }
        }
    }

    pub(super) const fn is_armed(&self) -> bool {
        matches!(self.state, InterlockState::Armed { .. })
    }

    /// Returns the reason why no forces are rendered, as in the hello.
    pub(super) const fn reason(&self) -> u8 {
        match self.state {
            InterlockState::Safe { reason, .. } => reason,
            InterlockState::Disarmed { .. } => safe_reason::DISARMED,
            InterlockState::Armed { .. } => safe_reason::NONE,
        }
    }

    /// Returns the numbers of expirations and armings.
    pub(super) const fn counts(&self) -> (u16, u16) {
        (self.trips, self.armings)
    }
}

const fn latches(reason: u8) -> bool {
    matches!(reason, safe_reason::EMERGENCY_STOP | safe_reason::KEY_FAULT)
}

#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum ForceDecision {
    Rendered,
    Stale,
    Unarmed,
}

#[cfg(test)]
mod tests {
    use super::*;

    const VALID: u64 = 20_000;

    fn armed() -> ForceInterlock {
        let mut interlock = ForceInterlock::new(7);
        let nonce = interlock.disarm(0).unwrap();
        assert_eq!(interlock.arm(nonce, VALID), Ok(()));
        interlock
    }

    fn in_state(state: &str) -> (ForceInterlock, u32) {
        let mut interlock = ForceInterlock::new(7);
        let nonce = interlock.disarm(0).unwrap();
        if matches!(state, "safe" | "armed") {
            interlock.arm(nonce, VALID).unwrap();
            assert_eq!(interlock.feed(0, 0), ForceDecision::Rendered);
        }
        match state {
            "safe" => assert!(interlock.share(2 * VALID) < 1.0),
            "latched" => interlock.trip(safe_reason::EMERGENCY_STOP, 0),
            _ => {}
        }
        (interlock, nonce)
    }

    fn state_name(interlock: &ForceInterlock) -> &'static str {
        match interlock.state {
            InterlockState::Safe { .. } if interlock.is_latched() => "latched",
            InterlockState::Safe { .. } => "safe",
            InterlockState::Disarmed { .. } => "disarmed",
            InterlockState::Armed { .. } => "armed",
        }
    }

    #[test]
    fn every_row_of_the_table_of_states_in_the_protocol_is_what_happens() {
        const NOW: u64 = 1_000;
        let document = include_str!("../../../../firmware-protocol/PROTOCOL.md");
        let rows = document.lines().skip_while(|it| *it != "#### States").skip(4);
        let mut n = 0;
        for row in rows.take_while(|it| it.starts_with('|')) {
            let cells: Vec<_> = row.trim_matches('|').split('|').map(str::trim).collect();
            let (mut it, nonce) = in_state(cells[0]);
            let armed = |outcome: Result<(), NotArmed>| match outcome {
                Ok(()) => "Done",
                Err(NotArmed::NotDisarmed) => "WrongState",
                Err(NotArmed::WrongNonce) => "WrongNonce",
            };
            let answer = match cells[1] {
                "Disarm" => it.disarm(NOW).map_or("WrongState", |_nonce| "Done"),
                "Arm, last nonce" => armed(it.arm(nonce, VALID)),
                "Arm, other nonce" => armed(it.arm(!nonce, VALID)),
                "forces" if it.feed(NOW, NOW) == ForceDecision::Rendered => "taken",
                "forces" => "not taken",
                event => {
                    match event {
                        "stop" => it.trip(safe_reason::EMERGENCY_STOP, NOW),
                        "key fault" => it.trip(safe_reason::KEY_FAULT, NOW),
                        _ => assert!(event == "forces expire" && it.share(2 * VALID) < 1.0),
                    }
                    ""
                }
            };
            let reason = match it.reason() {
                safe_reason::NONE => "NONE",
                safe_reason::SILENCE => "SILENCE",
                safe_reason::DISARMED => "DISARMED",
                safe_reason::EMERGENCY_STOP => "EMERGENCY_STOP",
                safe_reason::KEY_FAULT => "KEY_FAULT",
                _ => "another",
            };
            assert_eq!(&cells[2..], [answer, state_name(&it), reason], "{row}");
            n += 1;
        }
        assert_eq!(n, 22);
    }

    #[test]
    fn before_the_first_force_there_is_none_and_nothing_expires() {
        let mut interlock = armed();
        assert!((0..1_000_000).step_by(1_000).all(|now| interlock.share(now) <= 0.0));
        assert!(interlock.is_armed());
    }

    #[test]
    fn a_force_expires_and_fades_within_10_ms() {
        let mut interlock = armed();
        assert_eq!(interlock.feed(1_000, 1_500), ForceDecision::Rendered);
        assert!(1.0 <= interlock.share(21_000));
        let shares: Vec<_> = (0..12).map(|ms| interlock.share(21_001 + 1_000 * ms)).collect();
        assert!(shares.is_sorted_by(|one, next| next <= one), "{shares:?}");
        assert!(0.99 < shares[0] && shares[10..].iter().all(|share| *share <= 0.0), "{shares:?}");
        assert_eq!((interlock.is_armed(), interlock.counts()), (false, (1, 1)));
    }

    #[test]
    fn a_force_that_answers_old_samples_is_stale_and_does_not_feed() {
        let mut interlock = armed();
        assert_eq!(interlock.feed(0, 0), ForceDecision::Rendered);
        assert_eq!(interlock.feed(0, 20_001), ForceDecision::Stale);
        assert!(interlock.share(20_001) < 1.0 && !interlock.is_armed());
    }

    #[test]
    fn a_stop_or_a_failed_key_takes_the_place_of_any_lesser_reason_and_stays() {
        use safe_reason::{EMERGENCY_STOP, KEY_FAULT, SILENCE};
        let (mut silent, mut disarmed) = (armed(), armed());
        let _silent = silent.feed(0, 0);
        assert!(silent.share(VALID + 5_000) < 1.0 && silent.reason() == SILENCE);
        let _disarmed = disarmed.disarm(VALID + 5_000).unwrap();
        for interlock in [ForceInterlock::new(7), silent, disarmed, armed()] {
            check_latched(interlock, EMERGENCY_STOP, KEY_FAULT);
            check_latched(interlock, KEY_FAULT, EMERGENCY_STOP);
            let mut interlock = interlock;
            interlock.trip(SILENCE, 0);
            assert_ne!(interlock.disarm(0), None, "silence is not for good");
        }
    }

    #[track_caller]
    fn check_latched(mut interlock: ForceInterlock, reason: u8, other: u8) {
        for later in [reason, other, safe_reason::SILENCE] {
            interlock.trip(later, VALID + 6_000);
            assert_eq!(interlock.reason(), reason);
        }
        assert_eq!(interlock.disarm(VALID + 7_000), None);
        assert_eq!(interlock.arm(interlock.seed, VALID), Err(NotArmed::NotDisarmed));
        assert_eq!(interlock.reason(), reason);
    }

    #[test]
    fn what_fades_or_has_faded_does_not_come_back_with_another_reason() {
        let away: [fn(&mut ForceInterlock, u64); 2] = [
            |interlock, now_us| interlock.trip(safe_reason::EMERGENCY_STOP, now_us),
            |interlock, now_us| _ = interlock.disarm(now_us),
        ];
        for take_away in away {
            // Disarmed at 5 ms; expired at 20 ms without a poll; armed and never fed.
            let (mut disarmed, mut expired, mut unfed) = (armed(), armed(), armed());
            let _fed = [disarmed.feed(0, 0), expired.feed(0, 0)];
            let _nonce = disarmed.disarm(5_000);
            take_away(&mut disarmed, 10_000);
            take_away(&mut expired, VALID + 5_000);
            take_away(&mut unfed, 1_000);
            assert!((disarmed.share(10_000) - 0.5).abs() < 1e-9);
            assert!((expired.share(VALID + 5_000) - 0.5).abs() < 1e-9);
            assert!(unfed.share(1_000) <= 0.0);
        }
    }
}
