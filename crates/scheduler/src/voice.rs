//! One key's running simulation, as the scheduler sees it.

use crate::look::{ModelSnapshot, Switches};
use crate::motion::{KeyEvent, KeySample, KeySlope, Moment};
use crate::values::ModelValues;

/// Key events that one voice can report in one tick; more are counted, not kept.
pub const MAX_EVENTS_PER_TURN: usize = 8;

/// A voice: sample in, force out, once a tick.
pub trait Voice {
    /// Runs one tick.
    ///
    /// `tick` is absolute. It usually grows by one, but a tick that the host skipped is never
    /// run, so it may jump: a voice measures elapsed time by the difference of tick numbers.
    ///
    /// # Real-time
    /// Bounded by the voice's own declared work; no heap, lock or clock.
    fn tick(&mut self, tick: u64, sample: &KeySample) -> VoiceOutput;

    /// The same, written where it is needed.
    ///
    /// A turn is large, so a voice at rest does better with [`VoiceOutput::rest_at`] than with a new
    /// one. Whatever `turn` holds before must not show in what it holds after.
    fn tick_into(&mut self, tick: u64, sample: &KeySample, turn: &mut VoiceOutput) {
        *turn = self.tick(tick, sample);
    }

    /// Puts the voice at rest at `sample`: before its first tick, and after a fault.
    fn reset(&mut self, sample: &KeySample);

    /// Builds its model anew from `values` and keeps the state that it is in; says whether it
    /// could, which a voice of another model cannot.
    ///
    /// # Real-time
    /// Arithmetic on the values; no heap, lock or clock.
    fn retune(&mut self, _values: &ModelValues) -> bool {
        false
    }
}

/// What one voice did in one tick.
#[derive(Clone, Copy, PartialEq, Debug, Default)]
pub struct VoiceOutput {
    /// Force on the finger, up positive (N).
    pub force: f64,
    /// How the force goes on until the next tick; of itself it is held.
    pub slope: KeySlope,
    /// What happened to the note.
    pub events: Events,
    pub work: VoiceWork,
    /// Why the force cannot be trusted, if so.
    pub fault: Option<VoiceFault>,
    /// The voice was at rest and skipped its equations.
    pub idle: bool,
    /// The lane did not finish: this is the previous tick's turn.
    pub late: bool,
    /// First turn after the voice was put in, reset or retuned: its force knows nothing of the
    /// last one.
    pub fresh: bool,
    /// What the model is like at the end, for those who watch; means nothing if it was not run.
    pub look: ModelSnapshot,
    pub switches: Switches,
    /// In which of the last ticks the voice was run: this one is bit 0.
    pub ran: u32,
}

impl VoiceOutput {
    /// Becomes a turn in which nothing has happened yet; what the model is like stays what it was
    /// in these words, and is for whoever runs it to say.
    ///
    /// Touches a few words only: the lists are long.
    pub const fn begin(&mut self) {
        (self.force, self.slope) = (0.0, KeySlope::HELD);
        self.events.clear();
        self.work = VoiceWork { derivatives: 0, guards: 0, events: 0 };
        self.fault = None;
        (self.idle, self.late, self.fresh) = (false, false, false);
        self.switches.clear();
        self.ran = 0;
    }

    /// A turn without a trusted force.
    pub fn faulty(fault: VoiceFault) -> Self {
        Self { fault: Some(fault), ..Self::default() }
    }

    /// Becomes the turn of a voice at rest that presses with `force`, up positive (N).
    pub const fn rest_at(&mut self, force: f64) {
        self.begin();
        (self.force, self.idle) = (force, true);
    }

    /// What stands in for the next turn when the lane is not done: the force, marked late.
    ///
    /// Events and work are left behind, since they have been counted once already.
    #[must_use]
    pub fn held(&self) -> Self {
        Self { force: self.force, idle: self.idle, late: true, ..Self::default() }
    }
}

/// Evaluations that one tick of one voice took; independent of the machine.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub struct VoiceWork {
    /// Evaluations of the derivative.
    pub derivatives: u32,
    pub guards: u32,
    pub events: u32,
}

impl VoiceWork {
    /// Both together.
    #[must_use]
    #[inline]
    pub const fn plus(self, other: Self) -> Self {
        Self {
            derivatives: self.derivatives.saturating_add(other.derivatives),
            guards: self.guards.saturating_add(other.guards),
            events: self.events.saturating_add(other.events),
        }
    }

    /// The larger of each count.
    #[must_use]
    #[inline]
    pub fn largest(self, other: Self) -> Self {
        Self {
            derivatives: self.derivatives.max(other.derivatives),
            guards: self.guards.max(other.guards),
            events: self.events.max(other.events),
        }
    }
}

/// Why a voice could not produce a force; small, `Copy`, and free of text.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum VoiceFault {
    /// The state or the readout left the set of finite numbers.
    NotFinite,
    /// The sample was not a finite number.
    BadSample,
    /// A cap on events, cascades or evaluations was reached; the model was held.
    Capped {
        /// Events handled before giving up.
        handled: u32,
    },
    /// The model's energy changed by much more than its own work in this tick explains.
    Diverged,
    /// The voice panicked and is not called again.
    Panicked,
    /// The voice gave back more energy than was put into it; it is muted.
    MakesEnergy,
    /// The voice made energy, or failed again and again; it is not called until its values are
    /// changed or another voice is put in.
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
    /// Forgets all events.
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

    /// Appends the events of `later`, and what it had dropped.
    pub fn extend(&mut self, later: &Self) {
        for &(at, event) in later.as_slice() {
            self.push(at, event);
        }
        self.dropped += later.dropped;
    }

    /// Nothing happened, and nothing was dropped.
    pub const fn is_empty(&self) -> bool {
        self.n == 0 && self.dropped == 0
    }

    /// The events in the order in which they happened.
    pub fn as_slice(&self) -> &[(Moment, KeyEvent)] {
        &self.list[..self.n]
    }

    /// How many did not fit.
    pub const fn dropped(&self) -> u32 {
        self.dropped
    }
}
