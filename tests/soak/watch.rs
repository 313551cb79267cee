//! Between scheduler and keys: spoils samples as planned, and checks every force.

use std::sync::atomic::{AtomicU64, Ordering};
use std::sync::{Arc, Mutex, PoisonError};

use boards::sim::keybed::SimulatedKeybed;
use firmware_protocol::key::{BoardId, KeyIndex};
use host::session::RunTrial;
use scheduler::motion::{KEYS, KeySample};
use scheduler::safety::{FADE, MAX_EXTRAPOLATED};

use crate::actions::{Actor, FailingVoices};
use crate::plan::SoakPlan;

/// A motor's force that counts as none (N): it fades by its own lag.
const NO_FORCE: f64 = 1e-3;

/// Time from a board's last forces until its motors have none (s): its own patience, the fade of 10
/// ms, and the motors' lag.
const BOARD_FADE: f64 = 0.05;

/// FNV-1a (G. Fowler, L. C. Noll, K.-P. Vo) on words of 64 bits.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(crate) struct Digest(pub(crate) u64);

impl Default for Digest {
    fn default() -> Self {
        Self(0xcbf2_9ce4_8422_2325)
    }
}

impl Digest {
    pub(crate) const fn add(&mut self, word: u64) {
        self.0 = (self.0 ^ word).wrapping_mul(0x0100_0000_01b3);
    }
}

#[derive(Clone, Copy, PartialEq, Debug, Default)]
pub(crate) struct BrokenPromise {
    pub(crate) times: u64,
    /// Tick, key and force (N).
    pub(crate) first: Option<(u64, usize, f64)>,
}

impl BrokenPromise {
    fn note(&mut self, tick: u64, key: usize, force: f64) {
        self.times += 1;
        self.first.get_or_insert((tick, key, force));
    }
}

#[derive(Clone, Debug)]
pub(crate) struct SoakFindings {
    pub(crate) ticks: u64,
    /// Largest force sent, and largest force of a motor (N).
    pub(crate) sent: f64,
    pub(crate) given: f64,
    pub(crate) over_limit: BrokenPromise,
    pub(crate) untrusted: BrokenPromise,
    pub(crate) unreached: BrokenPromise,
    pub(crate) before: [Digest; KEYS],
    pub(crate) whole: [Digest; KEYS],
    pub(crate) wires: FrameCounts,
}

#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub(crate) struct FrameCounts {
    pub(crate) flipped: u64,
    pub(crate) dropped: u64,
    pub(crate) delayed: u64,
    pub(crate) down: u64,
    pub(crate) refused: u64,
    pub(crate) missing: u64,
    pub(crate) rearmed: u64,
}

pub(crate) type SharedFindings = Arc<Mutex<Option<Box<SoakFindings>>>>;

pub(crate) struct KeyWatch {
    plan: Arc<SoakPlan>,
    actor: Option<Actor>,
    failing: FailingVoices,
    now: Arc<AtomicU64>,
    limit: f64,
    /// Ticks for which a force may outlast its sample.
    fade: u32,
    board_fade: u64,
    /// Ticks since each key's last trusted sample.
    untrusted: [u32; KEYS],
    exchanges: u64,
    last_tick: u64,
    seen: Box<SoakFindings>,
    shared: SharedFindings,
}

impl KeyWatch {
    pub(crate) fn new(
        plan: &Arc<SoakPlan>,
        (actor, failing): (Option<Actor>, FailingVoices),
        now: &Arc<AtomicU64>,
        (limit, tick_hz): (f64, u32),
    ) -> (Self, SharedFindings) {
        let shared = SharedFindings::default();
        let ticks =
            |seconds: f64| engine::realtime::clock::nearest_integer(seconds * f64::from(tick_hz));
        let watch = Self {
            plan: Arc::clone(plan),
            actor,
            failing,
            now: Arc::clone(now),
            limit,
            // One tick is bridged, one holds, and one may pass until a change is taken.
            fade: u32::try_from(ticks(FADE.as_secs_f64())).unwrap_or(u32::MAX) + 3,
            board_fade: ticks(BOARD_FADE),
            untrusted: [0; KEYS],
            exchanges: 0,
            last_tick: 0,
            seen: Box::new(SoakFindings {
                ticks: 0,
                sent: 0.0,
                given: 0.0,
                over_limit: BrokenPromise::default(),
                untrusted: BrokenPromise::default(),
                unreached: BrokenPromise::default(),
                before: [Digest::default(); KEYS],
                whole: [Digest::default(); KEYS],
                wires: FrameCounts::default(),
            }),
            shared: Arc::clone(&shared),
        };
        (watch, shared)
    }

    fn check_forces(&mut self, tick: u64, forces: &[f64; KEYS]) {
        for (key, force) in forces.iter().enumerate() {
            let size = force.abs();
            self.seen.sent = self.seen.sent.max(size);
            if size.is_nan() || self.limit < size {
                self.seen.over_limit.note(tick, key, *force);
            }
            if self.fade < self.untrusted[key] && 0.0 < size {
                self.seen.untrusted.note(tick, key, *force);
            }
            self.seen.whole[key].add(force.to_bits());
            if tick < self.plan.first[key] {
                self.seen.before[key].add(force.to_bits());
            }
        }
    }

    fn check_motors(&mut self, tick: u64, keybed: &SimulatedKeybed) {
        for key in KeyIndex::all() {
            let force = keybed.rig(key).map_or(0.0, |rig| rig.motor_force().abs());
            self.seen.given = self.seen.given.max(force);
            if force.is_nan() || self.limit + NO_FORCE < force {
                self.seen.over_limit.note(tick, usize::from(key.number()), force);
            }
        }
        let plan = Arc::clone(&self.plan);
        for (board, silences) in &plan.silences {
            let is_silent = |it: &std::ops::Range<u64>| {
                it.start + self.board_fade <= self.exchanges && self.exchanges < it.end
            };
            if !silences.iter().any(is_silent) {
                continue;
            }
            for key in board.keys() {
                self.check_unreached(tick, key, keybed);
            }
        }
    }

    fn check_unreached(&mut self, tick: u64, key: usize, keybed: &SimulatedKeybed) {
        let rig = u8::try_from(key).ok().and_then(KeyIndex::new).and_then(|it| keybed.rig(it));
        let force = rig.map_or(0.0, haptics::KeyRig::motor_force);
        if NO_FORCE < force.abs() {
            self.seen.unreached.note(tick, key, force);
        }
    }

    fn count_wires(&mut self, keybed: &SimulatedKeybed) {
        let mut sum = FrameCounts { rearmed: keybed.rearmed(), ..FrameCounts::default() };
        for board in BoardId::all() {
            let (injected, statistics) = (keybed.fault_counts(board), keybed.statistics(board));
            let (wire, own) = (keybed.wire(board), keybed.board_counts(board));
            sum.flipped += injected.flipped;
            sum.dropped += injected.dropped;
            sum.delayed += injected.delayed;
            sum.down += injected.down;
            sum.refused += wire.corrupt + statistics.refused + own.corrupt + own.refused;
            sum.missing += statistics.samples.missing;
        }
        self.seen.wires = sum;
    }
}

impl RunTrial for KeyWatch {
    fn receive(&mut self, tick: u64, samples: &mut [KeySample; KEYS]) {
        for outage in self.plan.sensors.iter().filter(|it| it.ticks.contains(&tick)) {
            samples[outage.key].position = f64::NAN;
        }
        let ticks = u32::try_from(tick.saturating_sub(self.last_tick)).unwrap_or(u32::MAX).max(1);
        self.last_tick = tick;
        for (key, (sample, bad)) in samples.iter().zip(&mut self.untrusted).enumerate() {
            let is_good = sample.age <= MAX_EXTRAPOLATED && sample.position.is_finite();
            *bad = if is_good && !self.failing.has(key) { 0 } else { bad.saturating_add(ticks) };
        }
    }

    fn send(&mut self, tick: u64, forces: &[f64; KEYS], keybed: &SimulatedKeybed) {
        self.exchanges += 1;
        self.seen.ticks += 1;
        self.check_forces(tick, forces);
        self.check_motors(tick, keybed);
        if self.exchanges.is_multiple_of(256) || tick + 1 == self.plan.ticks {
            self.count_wires(keybed);
        }
        self.now.store(tick + 1, Ordering::Release);
        if let Some(actor) = &mut self.actor {
            actor.act_until(tick + 1);
        }
    }
}

impl Drop for KeyWatch {
    fn drop(&mut self) {
        let seen = Some(self.seen.clone());
        *self.shared.lock().unwrap_or_else(PoisonError::into_inner) = seen;
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use haptics::plant::RigParameters;

    /// Returns the findings for ticks in which key 5 has samples of this age and this force (N).
    fn seen(ticks: u64, age: u32, force: f64) -> SoakFindings {
        let plan = Arc::new(SoakPlan::new(1, 20.0, 1000).undisturbed());
        let now = Arc::default();
        let (mut watch, shared) =
            KeyWatch::new(&plan, (None, FailingVoices::default()), &now, (25.0, 1000));
        let keybed = SimulatedKeybed::new(1e-3, RigParameters::default()).expect("a period");
        for tick in 0..ticks {
            let (mut samples, mut forces) = ([KeySample::default(); KEYS], [0.0; KEYS]);
            samples[5].age = age;
            forces[5] = force;
            watch.receive(tick, &mut samples);
            watch.send(tick, &forces, &keybed);
        }
        drop(watch);
        let seen = shared.lock().expect("nobody else").take().expect("it was dropped");
        *seen
    }

    #[test]
    fn a_force_above_the_limit_and_one_that_is_no_number_are_seen() {
        assert_eq!(seen(3, 0, 25.0).over_limit.times, 0);
        assert_eq!(seen(3, 0, -25.1).over_limit.first, Some((0, 5, -25.1)));
        assert_eq!(seen(3, 0, f64::NAN).over_limit.times, 3);
    }

    #[test]
    fn a_force_that_outlasts_its_sample_is_seen() {
        assert_eq!(seen(100, 0, 1.0).untrusted.times, 0);
        assert_eq!(seen(23, 9, 1.0).untrusted.times, 0);
        assert_eq!(seen(30, 9, 1.0).untrusted.first, Some((23, 5, 1.0)));
        assert_eq!(seen(100, 9, 0.0).untrusted.times, 0);
    }

    #[test]
    fn forces_that_differ_in_a_bit_have_another_digest() {
        let [one, same, other] = [1.0, 1.0, 1.0 + f64::EPSILON].map(|force| seen(9, 0, force));
        assert_eq!((one.before, one.whole), (same.before, same.whole));
        assert_ne!(one.whole[5], other.whole[5]);
        assert_eq!(one.whole[6], other.whole[6]);
    }
}
