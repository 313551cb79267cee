//! Voices in and out between ticks, without the tick waiting or freeing memory.

use std::fmt;

use rtrb::{Consumer, Producer, PushError, RingBuffer};
use scheduler::motion::KEYS;
use scheduler::slot::{Slot, lane_of};

use super::fence::{BoxedVoice, PanicGuard};

/// Swaps that one lane does in one tick; a whole instrument takes several.
const MAX_SWAPS_PER_TICK: usize = 8;

/// Why a voice was not taken; it is given back.
pub enum Refused {
    /// No voice was set up for that key.
    NoSuchVoice(BoxedVoice),
    /// More swaps are waiting than the lane has keys; try again after some ticks.
    Full(BoxedVoice),
}

impl fmt::Debug for Refused {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::NoSuchVoice(_) => f.write_str("NoSuchVoice(..)"),
            Self::Full(_) => f.write_str("Full(..)"),
        }
    }
}

impl fmt::Display for Refused {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::NoSuchVoice(_) => "that key has no voice in this scene",
            Self::Full(_) => "too many voices are waiting to be put in; try again",
        })
    }
}

impl std::error::Error for Refused {}

/// The end that puts voices in; it also frees what comes out.
#[derive(Debug)]
pub struct VoiceSwaps {
    lanes: Vec<OuterEnd>,
    has_voice: [bool; KEYS],
}

/// A voice on its way to a key.
#[derive(Debug)]
struct Swap {
    key: usize,
    voice: PanicGuard,
    way: Way,
}

/// What becomes of the state that the key's voice is in.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Way {
    /// The new voice is put at rest where its key is.
    Replace,
    /// It is kept, if both are of one kind: only the values change.
    Retune,
}

#[derive(Debug)]
struct OuterEnd {
    into: Producer<Swap>,
    out: Consumer<PanicGuard>,
}

impl VoiceSwaps {
    /// Sends `voice` to take over `key` at one of the next ticks.
    ///
    /// Whatever its `way`, safety blends its force in. Not for the tick.
    ///
    /// # Errors
    /// If the key has no voice to replace, or too many are waiting.
    pub fn send(&mut self, key: usize, voice: BoxedVoice, way: Way) -> Result<(), Refused> {
        self.drain();
        if !self.has_voice.get(key).is_some_and(|has_voice| *has_voice) {
            return Err(Refused::NoSuchVoice(voice));
        }
        let lane = lane_of(key, self.lanes.len());
        self.lanes[lane]
            .into
            .push(Swap { key, voice: PanicGuard::new(voice), way })
            .map_err(|PushError::Full(swap)| Refused::Full(swap.voice.into_voice()))
    }

    /// Says in a sentence why voices for `keys` would not all be taken now.
    ///
    /// # Errors
    /// That sentence.
    pub fn refuse_without_room(&mut self, keys: &[usize]) -> Result<(), String> {
        self.drain();
        if let Some(key) = keys.iter().find(|key| !self.has_voice.get(**key).is_some_and(|it| *it))
        {
            return Err(format!("key {key} has no voice in this scene"));
        }
        let n_lanes = self.lanes.len();
        for (number, lane) in self.lanes.iter().enumerate() {
            let wanted = keys.iter().filter(|key| lane_of(**key, n_lanes) == number).count();
            if lane.into.slots() < wanted {
                return Err("too many voices are waiting to be put in; try again".into());
            }
        }
        Ok(())
    }

    /// Frees the voices that were replaced and returns how many. Not for the tick.
    pub fn drain(&mut self) -> usize {
        let drained = |end: &mut OuterEnd| std::iter::from_fn(|| end.out.pop().ok()).count();
        self.lanes.iter_mut().map(drained).sum()
    }
}

/// The end of a lane's swaps that its thread holds.
#[derive(Debug)]
pub(super) struct InnerEnd {
    into: Consumer<Swap>,
    out: Producer<PanicGuard>,
}

/// Rings for `n_lanes`, each with room for a voice for every key.
pub(super) fn rings(n_lanes: usize, has_voice: [bool; KEYS]) -> (VoiceSwaps, Vec<InnerEnd>) {
    let (outer, inner) = (0..n_lanes)
        .map(|_lane| {
            let (into, from_outside) = RingBuffer::new(KEYS);
            let (to_outside, out) = RingBuffer::new(KEYS);
            (OuterEnd { into, out }, InnerEnd { into: from_outside, out: to_outside })
        })
        .unzip();
    (VoiceSwaps { lanes: outer, has_voice }, inner)
}

impl InnerEnd {
    /// Puts in voices that are waiting, while there is room for what comes out.
    ///
    /// # Real-time
    /// At most [`MAX_SWAPS_PER_TICK`] moves of a pointer; frees nothing.
    pub(super) fn apply(&mut self, slots: &mut [Slot<PanicGuard>]) {
        for _ in 0..MAX_SWAPS_PER_TICK {
            if self.out.is_full() {
                return;
            }
            let Ok(Swap { key, voice, way }) = self.into.pop() else { return };
            let old = match slots.iter_mut().find(|slot| slot.key() == key) {
                Some(slot) if way == Way::Retune => slot.retune(voice),
                Some(slot) => slot.replace(voice),
                None => voice,
            };
            let sent = self.out.push(old);
            debug_assert!(sent.is_ok(), "there was room a moment ago");
        }
    }
}
