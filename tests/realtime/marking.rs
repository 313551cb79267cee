//! Marks the threads of the lanes from inside, by a voice that runs on them.

use std::ops::Range;

use engine::realtime::pool::BoxedVoice;
use scheduler::motion::KeySample;
use scheduler::observation::VoiceObservation;
use scheduler::values::ModelValues;
use scheduler::voice::{Voice, VoiceInternals, VoiceOutput};

use crate::trap::{self, Zone};

/// A voice that marks the thread on which it runs, for some ticks and between them.
struct Marking {
    voice: BoxedVoice,
    ticks: Range<u64>,
}

impl Marking {
    fn mark(&self, tick: u64) {
        let is_watched = self.ticks.contains(&tick);
        trap::enter(if is_watched { Zone::Tick } else { Zone::Elsewhere });
    }
}

impl Voice for Marking {
    fn tick(&mut self, tick: u64, sample: &KeySample, turn: &mut VoiceOutput) {
        self.mark(tick);
        self.voice.tick(tick, sample, turn);
    }

    fn observe(&self, seen: &mut VoiceObservation) {
        self.voice.observe(seen);
    }

    fn reset(&mut self, sample: &KeySample) {
        self.voice.reset(sample);
    }

    fn retune(&mut self, values: &ModelValues) -> bool {
        self.voice.retune(values)
    }

    fn take_over(&mut self, before: &dyn Voice) -> bool {
        self.voice.take_over(before)
    }

    fn internals(&self) -> VoiceInternals<'_> {
        self.voice.internals()
    }
}

/// Marks every lane over `ticks`, by each voice, since they change lanes. The first tick after them
/// unmarks the lanes, and must be run.
pub(crate) fn mark_lanes(voices: &mut [(usize, BoxedVoice)], ticks: &Range<u64>) {
    for (_key, voice) in voices {
        let inner = std::mem::replace(voice, Box::new(Silent));
        *voice = Box::new(Marking { voice: inner, ticks: ticks.clone() });
    }
}

struct Silent;

impl Voice for Silent {
    fn tick(&mut self, _tick: u64, _sample: &KeySample, _turn: &mut VoiceOutput) {}

    fn reset(&mut self, _sample: &KeySample) {}
}
