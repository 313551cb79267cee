use std::fmt;
use std::panic::{AssertUnwindSafe, catch_unwind};

use scheduler::motion::KeySample;
use scheduler::observation::VoiceObservation;
use scheduler::values::ModelValues;
use scheduler::voice::{TurnRules, Voice, VoiceFault, VoiceInternals, VoiceOutput};

/// Voice of any kind, on any lane.
pub type BoxedVoice = Box<dyn Voice + Send>;

/// Voice that is never called again once it has panicked, so only its own key is lost.
///
/// A panic is a bug, so unlike a diverged model the voice is not tried again: its key stays at the
/// safe force until another voice replaces it.
pub struct PanicGuard {
    voice: BoxedVoice,
    panicked: bool,
}

impl PanicGuard {
    pub fn new(voice: BoxedVoice) -> Self {
        Self { voice, panicked: false }
    }

    fn guarded<T>(&mut self, work: impl FnOnce(&mut BoxedVoice) -> T) -> Option<T> {
        if self.panicked {
            return None;
        }
        // The state may be broken after unwinding, and is never used again.
        let done = catch_unwind(AssertUnwindSafe(|| work(&mut self.voice))).ok();
        self.panicked = done.is_none();
        done
    }
}

impl Voice for PanicGuard {
    fn tick(&mut self, tick: u64, sample: &KeySample, turn: &mut VoiceOutput) {
        if self.guarded(|voice| voice.tick(tick, sample, turn)).is_none() {
            turn.fail(VoiceFault::Panicked);
        }
    }

    fn observe(&self, seen: &mut VoiceObservation) {
        if !self.panicked {
            self.voice.observe(seen);
        }
    }

    fn restrict(&mut self, rules: TurnRules) {
        self.guarded(|voice| voice.restrict(rules)).unwrap_or_default();
    }

    fn internals(&self) -> VoiceInternals<'_> {
        if self.panicked { VoiceInternals::default() } else { self.voice.internals() }
    }

    fn reset(&mut self, sample: &KeySample) {
        self.guarded(|voice| voice.reset(sample)).unwrap_or_default();
    }

    fn retune(&mut self, values: &ModelValues) -> bool {
        self.guarded(|voice| voice.retune(values)).unwrap_or(false)
    }

    fn take_over(&mut self, before: &dyn Voice) -> bool {
        self.guarded(|voice| voice.take_over(before)).unwrap_or(false)
    }
}

impl fmt::Debug for PanicGuard {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("PanicGuard").field("panicked", &self.panicked).finish_non_exhaustive()
    }
}
