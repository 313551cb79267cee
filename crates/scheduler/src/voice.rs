//! One key's running simulation, as the scheduler sees it.

use core::any::Any;

use crate::motion::{KeyEvent, KeySample, KeySlope, Moment};
use crate::observation::{FollowedKeys, VoiceObservation};
use crate::overload::Simplifications;
use crate::values::ModelValues;
use crate::work::{TurnLimit, VoiceKind};

/// Key events that one voice can report in one tick; more are counted, not kept.
pub const MAX_EVENTS_PER_TURN: usize = 8;

/// A voice: sample in, force out, once a tick.
pub trait Voice {
    /// Runs one tick into `turn`, which is empty. `tick` is absolute and jumps over skipped ticks:
    /// a voice measures elapsed time by the difference of tick numbers.
    ///
    /// # Real-time
    /// Bounded by the voice's own declared work; no heap, lock or clock.
    fn tick(&mut self, tick: u64, sample: &KeySample, turn: &mut VoiceOutput);

    /// Writes the model's state after the last tick and its mode changes; may leave `seen` as is.
    ///
    /// # Real-time
    /// Copies numbers.
    fn observe(&self, seen: &mut VoiceObservation) {
        let _ = seen;
    }

    /// Sets the rules of the turns from the next tick on; [`TurnRules::FREE`] hold at first.
    ///
    /// A simplification leaves no step in the force, which is computed from the same state. A voice
    /// with turns that are all alike may ignore the limit.
    ///
    /// # Real-time
    /// Copies numbers.
    fn restrict(&mut self, rules: TurnRules) {
        let _ = rules;
    }

    /// Returns what its lane and its successor need beyond what is observed.
    fn internals(&self) -> VoiceInternals<'_> {
        VoiceInternals::default()
    }

    /// Puts the voice at rest at `sample`: before its first tick, and after a fault.
    fn reset(&mut self, sample: &KeySample);

    /// Rebuilds the model from `values` and keeps the state; `false` for values of another model.
    ///
    /// # Real-time
    /// Arithmetic on the values; no heap, lock or clock.
    fn retune(&mut self, _values: &ModelValues) -> bool {
        false
    }

    /// Takes over the state of `before`; `false` if they share no mode: the scheduler resets it.
    ///
    /// # Real-time
    /// Copies what both have by the same names; no heap, lock or clock.
    fn take_over(&mut self, _before: &dyn Voice) -> bool {
        false
    }
}

/// Rules of a voice's turns.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct TurnRules {
    pub simplified: Simplifications,
    /// A turn that needs more work ends as [`VoiceFault::Capped`].
    pub limit: TurnLimit,
}

impl TurnRules {
    /// Nothing is left out, and nothing limited.
    pub const FREE: Self = Self { simplified: Simplifications::NONE, limit: TurnLimit::NONE };
}

/// Internals of a voice for those that do not know its type.
#[derive(Clone, Copy, Debug, Default)]
pub struct VoiceInternals<'a> {
    /// By which the cost of its work is learned.
    pub kind: VoiceKind,
    /// State for the voice that takes its place, as [`Voice::take_over`] may know it.
    pub memory: Option<&'a dyn Any>,
}

/// Output of a voice in one tick, with its trustworthiness.
#[expect(clippy::struct_excessive_bools, reason = "flags, of which one follows from another")]
#[derive(Clone, Copy, PartialEq, Debug, Default)]
pub struct VoiceOutput {
    /// Force on the finger, up positive (N).
    pub force: f64,
    /// Continuation of the force until the next tick; held by default.
    pub slope: KeySlope,
    pub events: Events,
    pub work: VoiceWork,
    pub fault: Option<VoiceFault>,
    /// `true` if the voice was at rest and skipped its equations.
    pub idle: bool,
    /// `true` if the lane did not finish or the voice had to wait, so the last force is held.
    pub late: bool,
    /// `true` if the voice had to wait, since its lane had no time left.
    pub waited: bool,
    /// `true` in the first turn after a change or reset: the force is unrelated to the last one.
    pub fresh: bool,
    /// Units of work to which a turn was limited that is [`VoiceFault::Capped`] by that; 0 of others.
    pub limit: u32,
    /// Like `limit`, for the turn that came too late for an earlier tick and has its events here.
    pub late_limit: u32,
}

impl VoiceOutput {
    /// Becomes a turn in which nothing has happened yet.
    pub const fn begin(&mut self) {
        (self.force, self.slope) = (0.0, KeySlope::HELD);
        self.events.clear();
        self.work = VoiceWork::NONE;
        (self.fault, self.limit, self.late_limit) = (None, 0, 0);
        (self.idle, self.late, self.waited, self.fresh) = (false, false, false, false);
    }

    /// Becomes a turn without a trusted force.
    pub const fn fail(&mut self, fault: VoiceFault) {
        self.begin();
        self.fault = Some(fault);
    }

    /// Becomes the turn of a late lane: the same force, marked late; its events were counted.
    pub const fn hold(&mut self) {
        let (force, idle) = (self.force, self.idle);
        self.begin();
        (self.force, self.idle, self.late) = (force, idle, true);
    }

    /// Becomes the turn of a voice that had to wait, whose last force was `force` (N).
    pub const fn wait(&mut self, force: f64) {
        self.begin();
        (self.force, self.late, self.waited) = (force, true, true);
    }

    /// Returns `true` if the voice ran its equations: it did not rest, was in time, and was called.
    pub const fn was_run(&self) -> bool {
        let is_kept = matches!(
            self.fault,
            Some(VoiceFault::BadSample | VoiceFault::Panicked | VoiceFault::Muted)
        );
        !(self.idle || self.late || is_kept)
    }

    /// Returns `true` if the voice of `key` is followed and was run, or was not seen yet.
    #[inline]
    pub const fn is_seen(&self, key: usize, followed: FollowedKeys) -> bool {
        followed.contains(key) && (self.was_run() || followed.is_new(key))
    }
}

/// Evaluations that one tick of one voice took; independent of the machine.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub struct VoiceWork {
    /// Work in the voice's own unit, whose cost is measured, as [`crate::work`] describes.
    pub units: u32,
    pub derivatives: u32,
    pub guards: u32,
    pub events: u32,
    /// Steps in which no crossing of the computed orbit was missed.
    pub certain: u32,
    /// Steps of which that is not known.
    pub unknown: u32,
}

impl VoiceWork {
    pub const NONE: Self =
        Self { units: 0, derivatives: 0, guards: 0, events: 0, certain: 0, unknown: 0 };

    /// Returns the evaluations of derivatives and guards.
    #[inline]
    pub const fn evaluations(self) -> u32 {
        self.derivatives.saturating_add(self.guards)
    }

    #[must_use]
    #[inline]
    pub const fn plus(self, other: Self) -> Self {
        Self {
            units: self.units.saturating_add(other.units),
            derivatives: self.derivatives.saturating_add(other.derivatives),
            guards: self.guards.saturating_add(other.guards),
            events: self.events.saturating_add(other.events),
            certain: self.certain.saturating_add(other.certain),
            unknown: self.unknown.saturating_add(other.unknown),
        }
    }

    #[must_use]
    #[inline]
    pub fn largest(self, other: Self) -> Self {
        Self {
            units: self.units.max(other.units),
            derivatives: self.derivatives.max(other.derivatives),
            guards: self.guards.max(other.guards),
            events: self.events.max(other.events),
            certain: self.certain.max(other.certain),
            unknown: self.unknown.max(other.unknown),
        }
    }
}

/// Reason why a voice could not produce a force.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum VoiceFault {
    NotFinite,
    BadSample,
    /// A cap on events, cascades or work was reached; the model was held.
    Capped {
        /// Events handled before giving up.
        handled: u32,
    },
    /// The model's energy changed by much more than its own work in this tick explains.
    Diverged,
    /// The voice panicked and is not called again.
    Panicked,
    /// The voice returned more energy than was put into it; it is muted.
    MakesEnergy,
    /// The voice generated energy or failed repeatedly; other values or another voice revive it.
    Muted,
}

/// A short list of key events with a fixed capacity.
#[derive(Clone, Copy, Debug)]
pub struct Events {
    list: [(Moment, KeyEvent); MAX_EVENTS_PER_TURN],
    n: usize,
    dropped: u32,
}

impl Default for Events {
    fn default() -> Self {
        let nothing = (Moment { tick: 0, theta: 0.0 }, KeyEvent::DamperLift);
        Self { list: [nothing; MAX_EVENTS_PER_TURN], n: 0, dropped: 0 }
    }
}

impl PartialEq for Events {
    fn eq(&self, other: &Self) -> bool {
        self.as_slice() == other.as_slice() && self.dropped == other.dropped
    }
}

impl Events {
    pub const fn clear(&mut self) {
        (self.n, self.dropped) = (0, 0);
    }

    /// Appends an event; counts it as dropped when the list is full.
    pub fn push(&mut self, at: Moment, event: KeyEvent) {
        if let Some(place) = self.list.get_mut(self.n) {
            *place = (at, event);
            self.n += 1;
        } else {
            self.dropped += 1;
        }
    }

    /// Appends the events of `later`, and its dropped ones.
    pub fn extend(&mut self, later: &Self) {
        for &(at, event) in later.as_slice() {
            self.push(at, event);
        }
        self.dropped += later.dropped;
    }

    /// Returns `true` if nothing happened and nothing was dropped.
    pub const fn is_empty(&self) -> bool {
        self.n == 0 && self.dropped == 0
    }

    /// Returns the events in order of time.
    pub fn as_slice(&self) -> &[(Moment, KeyEvent)] {
        &self.list[..self.n]
    }

    pub fn strikes(&self) -> usize {
        let is_strike = |it: &&(Moment, KeyEvent)| matches!(it.1, KeyEvent::Strike { .. });
        self.as_slice().iter().filter(is_strike).count()
    }

    pub const fn dropped(&self) -> u32 {
        self.dropped
    }
}
