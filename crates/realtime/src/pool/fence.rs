//! A voice whose panic is caught: only its own key is lost.

use std::any::Any;
use std::fmt;
use std::panic::{AssertUnwindSafe, catch_unwind};

use scheduler::motion::KeySample;
use scheduler::observation::VoiceObservation;
use scheduler::overload::Simplifications;
use scheduler::values::ModelValues;
use scheduler::voice::{Voice, VoiceFault, VoiceOutput};

/// A voice of any kind, on whichever lane.
pub type BoxedVoice = Box<dyn Voice + Send>;

/// A voice that is never called again once it has panicked.
///
/// A panic is a bug, so unlike a model that diverged it is not tried again: its key stays at
/// the safe force until another voice is put in.
pub struct PanicGuard {
    voice: BoxedVoice,
    panicked: bool,
}

impl PanicGuard {
    /// Guards the lane against `voice`.
    pub fn new(voice: BoxedVoice) -> Self {
        Self { voice, panicked: false }
    }
}

impl Voice for PanicGuard {
    fn tick(&mut self, tick: u64, sample: &KeySample, turn: &mut VoiceOutput) {
        if !self.panicked {
            // The voice's state may be broken after unwinding, and is never used again.
            let run = AssertUnwindSafe(|| self.voice.tick(tick, sample, turn));
            self.panicked = catch_unwind(run).is_err();
        }
        if self.panicked {
            turn.fail(VoiceFault::Panicked);
        }
    }

    fn observe(&self, seen: &mut VoiceObservation) {
        if !self.panicked {
            self.voice.observe(seen);
        }
    }

    fn simplify(&mut self, simplified: Simplifications) {
        if !self.panicked {
            // As in `tick`.
            let run = AssertUnwindSafe(|| self.voice.simplify(simplified));
            self.panicked = catch_unwind(run).is_err();
        }
    }

    fn reset(&mut self, sample: &KeySample) {
        if !self.panicked {
            // As in `tick`.
            let outcome = catch_unwind(AssertUnwindSafe(|| self.voice.reset(sample)));
            self.panicked = outcome.is_err();
        }
    }

    fn retune(&mut self, values: &ModelValues) -> bool {
        if self.panicked {
            return false;
        }
        // As in `tick`.
        let outcome = catch_unwind(AssertUnwindSafe(|| self.voice.retune(values)));
        self.panicked = outcome.is_err();
        outcome.unwrap_or(false)
    }

    fn take_over(&mut self, before: &dyn Voice) -> bool {
        // As in `tick`.
        let outcome = catch_unwind(AssertUnwindSafe(|| self.voice.take_over(before)));
        self.panicked |= outcome.is_err();
        outcome.unwrap_or(false)
    }

    fn memory(&self) -> Option<&dyn Any> {
        if self.panicked { None } else { self.voice.memory() }
    }
}

impl fmt::Debug for PanicGuard {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("PanicGuard").field("panicked", &self.panicked).finish_non_exhaustive()
    }
}
