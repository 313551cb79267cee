//! Safety: sends the voice's force while it can be trusted, and fades to zero when it cannot.
//!
//! Each key is a small state machine, stepped once a tick. `n` is the ticks in [`FADE`]:
//!
//! | state | trusted | trusted, fresh | not there (late, stale, disarmed) | fault |
//! |---|---|---|---|---|
//! | **Following** | the voice's force | → Returning over `n` | → Outage, hold | → Condemned, hold |
//! | **Outage** of `k` ticks | → Returning over `k + 1` or what was left of the last return, at most `n` | → Returning over `n` | hold, then fade | → Condemned, the same fade |
//! | **Condemned** | fade; from zero → Returning over `n` | as trusted | fade | fade |
//! | **Returning** | blend towards the voice; at its end → Following | start again over `n` | → Outage, hold | → Condemned, hold |
//!
//! The first tick of an outage or fault holds the last force; zero is sent [`FADE`] after it. A
//! held or fading force is passive: where the key moves with it, it falls like that of a relaxing
//! spring of [`RELAXATION`], and it never rises again. It gives the finger at most the energy of
//! that spring, F²/(2 k), 31 mJ of 25 N and 50 µJ of 1 N, however fast the key comes up, and beyond
//! that only what the force changes within a tick. A fault must reach zero before the voice is felt
//! again; an outage may end on the way. A skipped tick is an outage of every key. A key begins as
//! after a long outage, so that power-up has no force step either.
//!
//! Towards a voice a force never changes faster than the slew limit: the voice's own gate does not
//! know the force sent in its stead. The fade to zero has its own time, [`FADE`].
//!
//! # A voice that takes the place of another
//!
//! Values, voices and versions of models change while a key is held. The transfer is bumpless
//! `[PVH96]`: with F₀ the force sent last and F the new voice's, tick k of `n` sends
//! F₀ + (F − F₀) k/n, so that the difference F₀ − F decays to zero in a straight line over
//! [`FADE`]. A tick changes the force by at most |F₀ − F|/n, plus k/n of the voice's own change.
//!
//! The force differs from one of the new voice by at most |F₀ − F|, for a [`FADE`] only, so the
//! blend gives the finger at most |F₀ − F| times the travel in that time: 3 mJ for 1 N and 3 mm.
//! That is once for each change, not a rate. The voice's passivity observer `[HR02]` restarts with
//! the change, as the energy stored under other values is another one.
//!
//! The size of a force is limited by the voice's own force gate, not here. NaN never passes.

use crate::motion::{KEYS, KeySample, KeySlope};
use crate::time::{Nanos, Period};
use crate::voice::VoiceOutput;

/// Force of a key with an untrusted voice (N).
pub const SAFE_FORCE: f64 = 0.0;

/// Time from the first untrusted tick to the safe force.
pub const FADE: Nanos = Nanos::from_millis(20);

/// Stiffness by which a force without its voice falls where its key moves with it (N/m).
pub const RELAXATION: f64 = 1e4;

/// Ticks without a new sample that a voice bridges by extrapolation.
pub const MAX_EXTRAPOLATED: u32 = 1;

#[derive(Clone, Copy, PartialEq, Eq, Debug)]
enum Trust {
    Trusted,
    /// Trusted, but unrelated to the force felt before.
    Fresh,
    NotThere,
    Fault,
}

impl Trust {
    fn of(turn: &VoiceOutput, sample: &KeySample) -> Self {
        if turn.fault.is_some() || !turn.force.is_finite() {
            Self::Fault
        } else if turn.late || MAX_EXTRAPOLATED < sample.age {
            Self::NotThere
        } else if turn.fresh {
            Self::Fresh
        } else {
            Self::Trusted
        }
    }
}

#[derive(Clone, Copy, PartialEq, Debug)]
enum SafetyState {
    Following,
    /// `held` (N) was sent last, `ticks` ago with this one. The return takes at least `left` ticks,
    /// because the outage cut another one short.
    Outage {
        held: f64,
        ticks: u32,
        left: u32,
    },
    /// Like an outage, after a fault.
    Condemned {
        held: f64,
        ticks: u32,
    },
    /// `done` of `of` ticks from `from` (N) to the voice's force.
    Returning {
        from: f64,
        done: u32,
        of: u32,
    },
}

#[derive(Clone, Copy, PartialEq, Debug)]
struct KeySafety {
    state: SafetyState,
    /// Force sent last (N).
    sent: f64,
    /// Position at which it was sent (m).
    position: f64,
}

impl KeySafety {
    const SILENT: Self = Self {
        state: SafetyState::Outage { held: SAFE_FORCE, ticks: u32::MAX, left: 0 },
        sent: SAFE_FORCE,
        position: 0.0,
    };

    /// Applies a row of the table at `position` (m), `ticks` later; returns the force to send (N).
    fn step(
        &mut self,
        trust: Trust,
        (force, position): (f64, f64),
        ramps: Ramps,
        ticks: f64,
    ) -> f64 {
        let Ramps { fade_ticks, reach } = ramps;
        self.state = match trust {
            Trust::Trusted => self.trusted(fade_ticks),
            Trust::Fresh => self.fresh(fade_ticks),
            Trust::NotThere => self.not_there(1),
            Trust::Fault => self.fault(),
        };
        self.relax(position);
        let force = match self.state {
            SafetyState::Following => towards(self.sent, force, reach * ticks),
            SafetyState::Outage { held, ticks, .. } | SafetyState::Condemned { held, ticks } => {
                faded(held, ticks, fade_ticks)
            }
            SafetyState::Returning { from, done, of } => {
                let blend = from + (force - from) * f64::from(done) / f64::from(of);
                towards(self.sent, blend, reach * ticks)
            }
        };
        // A blend of huge forces can overflow, and `f64::clamp` passes NaN through.
        self.sent = if force.is_finite() { force } else { SAFE_FORCE };
        self.sent
    }

    /// Reduces a voiceless force like a relaxing spring's as the key goes to `position` (m).
    fn relax(&mut self, position: f64) {
        let rise = self.position - position;
        self.position = position;
        if let SafetyState::Outage { held, .. } | SafetyState::Condemned { held, .. } =
            &mut self.state
        {
            // A displacement that is not finite counts as none.
            let lost = (RELAXATION * rise * held.signum()).max(0.0);
            *held -= lost.min(held.abs()).copysign(*held);
        }
    }

    fn trusted(&self, fade_ticks: u32) -> SafetyState {
        match self.state {
            SafetyState::Following => SafetyState::Following,
            SafetyState::Outage { held, ticks, left } => {
                let of = ticks.saturating_add(1).max(left).min(fade_ticks);
                returning(faded(held, ticks, fade_ticks), 0, of)
            }
            SafetyState::Condemned { ticks, .. } if fade_ticks < ticks => {
                returning(SAFE_FORCE, 0, fade_ticks)
            }
            SafetyState::Condemned { held, ticks } => {
                SafetyState::Condemned { held, ticks: ticks + 1 }
            }
            SafetyState::Returning { from, done, of } => returning(from, done, of),
        }
    }

    fn fresh(&self, fade_ticks: u32) -> SafetyState {
        match self.state {
            SafetyState::Following | SafetyState::Returning { .. } => {
                returning(self.sent, 0, fade_ticks)
            }
            SafetyState::Outage { held, ticks, .. } => {
                returning(faded(held, ticks, fade_ticks), 0, fade_ticks)
            }
            SafetyState::Condemned { .. } => self.trusted(fade_ticks),
        }
    }

    /// Returns the state after `missing` more ticks without the voice.
    const fn not_there(&self, missing: u32) -> SafetyState {
        match self.state {
            SafetyState::Following => {
                SafetyState::Outage { held: self.sent, ticks: missing, left: 0 }
            }
            SafetyState::Returning { done, of, .. } => {
                SafetyState::Outage { held: self.sent, ticks: missing, left: of - done }
            }
            SafetyState::Outage { held, ticks, left } => {
                SafetyState::Outage { held, ticks: ticks.saturating_add(missing), left }
            }
            SafetyState::Condemned { held, ticks } => {
                SafetyState::Condemned { held, ticks: ticks.saturating_add(missing) }
            }
        }
    }

    /// Returns the slope of the force just sent: the voice's, if the voice's force was sent.
    fn slope(&self, turn: &VoiceOutput) -> KeySlope {
        let is_sent = self.sent.to_bits() == turn.force.to_bits();
        let is_followed = self.state == SafetyState::Following && is_sent && turn.slope.is_finite();
        if is_followed { turn.slope } else { KeySlope::HELD }
    }

    const fn fault(&self) -> SafetyState {
        match self.state {
            SafetyState::Following | SafetyState::Returning { .. } => {
                SafetyState::Condemned { held: self.sent, ticks: 1 }
            }
            SafetyState::Outage { held, ticks, .. } | SafetyState::Condemned { held, ticks } => {
                SafetyState::Condemned { held, ticks: ticks.saturating_add(1) }
            }
        }
    }
}

/// Returns the state one tick further on the return, which ends after `of` ticks.
const fn returning(from: f64, done: u32, of: u32) -> SafetyState {
    if done + 1 < of {
        SafetyState::Returning { from, done: done + 1, of }
    } else {
        SafetyState::Following
    }
}

/// Returns the force `ticks` after `held` (N) was sent: whole in the first tick, then falling.
fn faded(held: f64, ticks: u32, fade_ticks: u32) -> f64 {
    if fade_ticks < ticks {
        return SAFE_FORCE;
    }
    // The ratio first: a hold must be exact.
    held * (f64::from(fade_ticks + 1 - ticks) / f64::from(fade_ticks))
}

/// Returns the force nearest to `wanted` (N) within `reach` (N) of `sent` (N).
fn towards(sent: f64, wanted: f64, reach: f64) -> f64 {
    let change = wanted - sent;
    if change.abs() <= reach { wanted } else { sent + reach.copysign(change) }
}

#[derive(Clone, Copy, PartialEq, Debug)]
struct Ramps {
    /// Ticks that fit into [`FADE`], at least 1.
    fade_ticks: u32,
    /// Largest change towards a voice in a tick (N).
    reach: f64,
}

impl Ramps {
    fn new(period: Period, slew: f64) -> Self {
        let fade_ticks = u32::try_from(period.ticks_in(FADE)).unwrap_or(u32::MAX - 1).max(1);
        Self { fade_ticks, reach: slew * period.as_secs_f64() }
    }
}

/// Last gate before the bus for one key, also used by a rehearsal of that key.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct KeyGate {
    safety: KeySafety,
    ramps: Ramps,
}

impl KeyGate {
    /// Returns the gate of a silent, armed key, with a force that changes by at most `slew` (N/s).
    pub fn new(period: Period, slew: f64) -> Self {
        Self { safety: KeySafety::SILENT, ramps: Ramps::new(period, slew) }
    }

    /// Returns the force to send (N), after a tick without a gap.
    pub fn apply(&mut self, turn: &VoiceOutput, sample: &KeySample) -> f64 {
        let wanted = (turn.force, sample.position);
        self.safety.step(Trust::of(turn, sample), wanted, self.ramps, 1.0)
    }

    pub fn slope(&self, turn: &VoiceOutput) -> KeySlope {
        self.safety.slope(turn)
    }
}

/// Numbers of keys that do not feel their voice's own force.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub struct SafetyReport {
    /// Keys that hold, fade or are silent.
    pub withheld: u32,
    /// Keys on the return to their voice.
    pub returning: u32,
}

impl SafetyReport {
    fn count(&mut self, state: SafetyState) {
        match state {
            SafetyState::Following => {}
            SafetyState::Outage { .. } | SafetyState::Condemned { .. } => self.withheld += 1,
            SafetyState::Returning { .. } => self.returning += 1,
        }
    }
}

/// Last gate before the bus, for all keys.
#[derive(Clone, Debug)]
pub struct Safety {
    keys: [KeySafety; KEYS],
    ramps: Ramps,
    armed: bool,
}

impl Safety {
    /// Returns the gate of all silent, armed keys; forces change by at most `slew` (N/s).
    pub fn new(period: Period, slew: f64) -> Self {
        Self { keys: [KeySafety::SILENT; KEYS], ramps: Ramps::new(period, slew), armed: true }
    }

    /// Lets the keys follow their voices (the initial state).
    pub const fn arm(&mut self) {
        self.armed = true;
    }

    /// Withholds all voices from the next tick on: all keys hold one tick, then fade.
    pub const fn disarm(&mut self) {
        self.armed = false;
    }

    pub const fn is_armed(&self) -> bool {
        self.armed
    }

    /// Writes the force for each key (N), after `skipped` ticks that were never run.
    pub fn apply(
        &mut self,
        skipped: u64,
        samples: &[KeySample; KEYS],
        turns: &[VoiceOutput; KEYS],
        forces: &mut [f64; KEYS],
    ) -> SafetyReport {
        let missing = u32::try_from(skipped).unwrap_or(u32::MAX);
        let ticks = 1.0 + f64::from(missing);
        let mut report = SafetyReport::default();
        for (key, force) in forces.iter_mut().enumerate() {
            let safety = &mut self.keys[key];
            if 0 < missing {
                safety.state = safety.not_there(missing);
            }
            let trust = match Trust::of(&turns[key], &samples[key]) {
                Trust::Trusted | Trust::Fresh if !self.armed => Trust::NotThere,
                known @ (Trust::Trusted | Trust::Fresh | Trust::NotThere | Trust::Fault) => known,
            };
            let wanted = (turns[key].force, samples[key].position);
            *force = safety.step(trust, wanted, self.ramps, ticks);
            report.count(safety.state);
        }
        report
    }

    /// Writes the slopes of the forces just sent: the voices' own, where voices are followed.
    pub fn slopes(&self, turns: &[VoiceOutput; KEYS], slopes: &mut [KeySlope; KEYS]) {
        for ((slope, turn), key) in slopes.iter_mut().zip(turns).zip(&self.keys) {
            *slope = key.slope(turn);
        }
    }
}

#[cfg(test)]
mod tests;
