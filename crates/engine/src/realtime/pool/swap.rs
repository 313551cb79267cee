//! Changes of voices and values between ticks, without the tick waiting or freeing memory.

use std::fmt;
use std::thread;
use std::time::{Duration, Instant};

use rtrb::{Consumer, Producer, PushError, RingBuffer};
use scheduler::motion::KEYS;
use scheduler::observation::VoiceObservation;
use scheduler::slot::Slot;
use scheduler::values::ModelValues;

use super::fence::{BoxedVoice, PanicGuard};
use super::share::{RemoteLane, SlotPlace};

/// Changes made in one tick; a whole instrument takes several ticks.
const MAX_CHANGES_PER_TICK: usize = 4;

/// Time that changes wait for those sent before them.
const ROOM_WITHIN: Duration = Duration::from_millis(250);

/// Rejected change, which is returned.
pub enum Refused {
    NoSuchVoice(Box<VoiceChange>),
    /// As many changes are waiting as there are keys; room is free after some ticks.
    Full(Box<VoiceChange>),
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
            Self::Full(_) => TOO_MANY,
        })
    }
}

impl std::error::Error for Refused {}

const TOO_MANY: &str = "too many voices are waiting to be put in; try again";

/// Sending end for changes to voices; it also frees replaced voices.
#[derive(Debug)]
pub struct VoiceSwaps {
    into: Producer<QueuedChange>,
    out: Consumer<PanicGuard>,
    has_voice: [bool; KEYS],
}

#[derive(Debug)]
struct QueuedChange {
    key: usize,
    change: VoiceChange,
}

/// Change to a key's voice.
#[expect(clippy::large_enum_variant, reason = "the tick must free nothing, a box of values either")]
pub enum VoiceChange {
    /// Replaces the voice by another, at rest where the key is.
    Replace(BoxedVoice),
    /// Replaces the voice by another that continues from its state, as far as both share it.
    Succeed(BoxedVoice),
    /// Changes the values of the voice's model and keeps its state.
    Retune(ModelValues),
}

impl fmt::Debug for VoiceChange {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Replace(_) => f.write_str("Replace(..)"),
            Self::Succeed(_) => f.write_str("Succeed(..)"),
            Self::Retune(values) => f.debug_tuple("Retune").field(values).finish(),
        }
    }
}

impl VoiceSwaps {
    /// Sends `change` to the voice of `key`, for one of the next ticks, after earlier changes.
    /// Safety blends the new force in. Not for the tick.
    ///
    /// # Errors
    /// If the key has no voice to change, or too many changes are waiting.
    pub fn send(&mut self, key: usize, change: VoiceChange) -> Result<(), Refused> {
        self.drain();
        if !self.has_voice.get(key).is_some_and(|has_voice| *has_voice) {
            return Err(Refused::NoSuchVoice(Box::new(change)));
        }
        let pushed = self.into.push(QueuedChange { key, change });
        pushed.map_err(|PushError::Full(it)| Refused::Full(Box::new(it.change)))
    }

    /// Waits up to 250 ms, for several ticks, for room for changes of all `keys`. Not in a tick.
    ///
    /// # Errors
    /// The reason why there is no room.
    pub fn wait_for_room(&mut self, keys: &[usize]) -> Result<(), String> {
        if let Some(key) = keys.iter().find(|key| !self.has_voice.get(**key).is_some_and(|it| *it))
        {
            return Err(format!("key {key} has no voice in this scene"));
        }
        let until = Instant::now() + ROOM_WITHIN;
        loop {
            self.drain();
            if keys.len() <= self.into.slots() {
                return Ok(());
            }
            if until <= Instant::now() {
                return Err(TOO_MANY.into());
            }
            thread::sleep(Duration::from_millis(1));
        }
    }

    /// Frees the replaced voices and returns their number; not for the tick.
    pub fn drain(&mut self) -> usize {
        std::iter::from_fn(|| self.out.pop().ok()).count()
    }
}

#[derive(Debug)]
pub(super) struct InnerEnd {
    into: Consumer<QueuedChange>,
    out: Producer<PanicGuard>,
}

pub(super) fn rings(has_voice: [bool; KEYS]) -> (VoiceSwaps, InnerEnd) {
    let (into, from_outside) = RingBuffer::new(KEYS);
    let (to_outside, out) = RingBuffer::new(KEYS);
    (VoiceSwaps { into, out, has_voice }, InnerEnd { into: from_outside, out: to_outside })
}

impl InnerEnd {
    /// Applies the waiting changes, while there is room for replaced voices and the next key is at
    /// home. `observed` records each change in its tick, even of a late voice.
    ///
    /// # Real-time
    /// At most [`MAX_CHANGES_PER_TICK`] moves of a pointer or models built; frees nothing.
    pub(super) fn apply(
        &mut self,
        inline: &mut [Slot<PanicGuard>],
        remotes: &mut [RemoteLane],
        observed: &mut [VoiceObservation; KEYS],
    ) {
        for _ in 0..MAX_CHANGES_PER_TICK {
            if self.out.is_full() {
                return;
            }
            let Ok(key) = self.into.peek().map(|next| next.key) else { return };
            let here = inline.iter_mut().find(|it| it.key() == key).map(SlotPlace::Here);
            let place = here.or_else(|| remotes.iter_mut().find_map(|it| it.place(key)));
            let mut slot = match place {
                Some(SlotPlace::Here(slot)) => Some(slot),
                // Its lane is late: later changes wait as well, so that they stay in order.
                Some(SlotPlace::Away { lost: false }) => return,
                Some(SlotPlace::Away { lost: true }) | None => None,
            };
            let Ok(queued) = self.into.pop() else { return };
            let old = queued.apply(slot.as_deref_mut());
            if let Some(slot) = slot {
                slot.show(&mut observed[key]);
            }
            if let Some(old) = old {
                let sent = self.out.push(old);
                debug_assert!(sent.is_ok(), "there was room a moment ago");
            }
        }
    }
}

impl QueuedChange {
    /// Applies the change, and returns the replaced voice, which must be freed elsewhere.
    fn apply(self, slot: Option<&mut Slot<PanicGuard>>) -> Option<PanicGuard> {
        match self.change {
            VoiceChange::Replace(voice) => {
                let voice = PanicGuard::new(voice);
                Some(if let Some(slot) = slot { slot.replace(voice) } else { voice })
            }
            VoiceChange::Succeed(voice) => {
                let voice = PanicGuard::new(voice);
                Some(if let Some(slot) = slot { slot.succeed(voice) } else { voice })
            }
            VoiceChange::Retune(values) => {
                // A voice that rejects them has panicked, and stays at the safe force.
                let _taken = slot.is_some_and(|slot| slot.retune(&values));
                None
            }
        }
    }
}
