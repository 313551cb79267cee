//! Lower fidelities for resting keys while ticks have too little time, and back again.

use std::{collections::BTreeMap, io, sync::Arc, time::Duration};

use keyboard::KeyRange;
use scene::{Instrument, KeyVoice, Voicing};
use scheduler::overload::Simplification;

use super::new_voice::{NewVoice, VoiceHandover};
use super::{RequestHandler, current_voices::CurrentVoices, repeated_look::RepeatedLook};

const LOOK: Duration = Duration::from_millis(50);

/// Keys per poll: their voices are built while a tick has too much work.
const MOST_AT_ONCE: usize = 8;

const KEYS: u8 = 88;

const OVERLOAD: &str = "overload";

/// Gives resting keys a lower fidelity while the scheduler of `handler`'s run omits fidelity, until
/// the result is dropped. Fails if the system gives no thread.
pub fn follow_load(handler: Arc<RequestHandler>) -> io::Result<RepeatedLook> {
    let mut lowered = LoweredKeys::default();
    RepeatedLook::start("letoff-fidelity", LOOK, move || lowered.look(&handler))
}

#[derive(Debug, Default)]
struct LoweredKeys {
    before: BTreeMap<u8, OriginalVoice>,
    /// Next lower fidelity of each instrument, if a stable one exists.
    lower: BTreeMap<String, Option<Instrument>>,
    untold: usize,
}

#[derive(Debug)]
struct OriginalVoice {
    voice: KeyVoice,
    voicing: Voicing,
    instrument: String,
    lower: String,
}

impl LoweredKeys {
    fn look(&mut self, handler: &RequestHandler) {
        let Some(counters) = handler.run.status.counters() else { return };
        let is_wanted = counters.overload.now().contains(Simplification::Fidelity);
        let asleep = counters.asleep.load();
        let changes = if is_wanted {
            self.lower_voices(handler, asleep)
        } else {
            self.former_voices(handler, asleep)
        };
        if changes.is_empty() {
            self.tell(handler);
        } else if let Some(before) = change(handler, changes) {
            self.untold += before.len();
            if is_wanted {
                self.before.extend(before);
            } else {
                self.before.retain(|key, _| before.iter().all(|(changed, _)| changed != key));
            }
        }
    }

    fn tell(&mut self, handler: &RequestHandler) {
        let (changed, lower) = (std::mem::take(&mut self.untold), self.before.len());
        if 0 < changed {
            let text = format!("{changed} keys changed at rest; {lower} have a lower fidelity");
            handler.tell(&text, OVERLOAD);
        }
    }

    /// Returns the lower voices of some of the keys `asleep`, all of one instrument.
    fn lower_voices(&mut self, handler: &RequestHandler, asleep: u128) -> BTreeMap<u8, NewVoice> {
        let mut changes = BTreeMap::new();
        let mut of = None;
        // Trying an instrument takes time, in which clients may change voices.
        for (key, name) in self.untouched(handler, asleep) {
            if of.as_ref().is_some_and(|of| *of != name) || changes.len() == MOST_AT_ONCE {
                continue;
            }
            let lower = self.lower.entry(name.clone()).or_insert_with(|| lower(handler, &name));
            let Some(lower) = lower else { continue };
            changes.insert(key, NewVoice::anew(&lower.voicing, key, &lower.name));
            of = Some(name);
        }
        changes
    }

    /// Returns the keys `asleep` with unchanged fidelity and values, and the instruments' names.
    fn untouched(&self, handler: &RequestHandler, asleep: u128) -> Vec<(u8, String)> {
        let playing = handler.playing();
        let keys = (0..KEYS).filter(|key| is_in(asleep, *key) && !self.before.contains_key(key));
        keys.filter_map(|key| Some((key, playing.untouched_instrument(key)?.to_owned()))).collect()
    }

    /// Returns the former voices of some of the keys `asleep`, all of one instrument, unless
    /// a client changed them meanwhile.
    fn former_voices(&mut self, handler: &RequestHandler, asleep: u128) -> BTreeMap<u8, NewVoice> {
        if self.before.is_empty() {
            return BTreeMap::new();
        }
        let playing = handler.playing();
        self.before.retain(|key, it| playing.untouched_instrument(*key) == Some(it.lower.as_str()));
        drop(playing);
        let Some(of) = self.before.values().next().map(|it| &it.instrument) else {
            return BTreeMap::new();
        };
        let former = self.before.iter();
        let former = former.filter(|(key, it)| is_in(asleep, **key) && it.instrument == *of);
        let voice = |(key, it): (&u8, &OriginalVoice)| {
            let handover = VoiceHandover::Anew(it.voicing.clone(), it.instrument.clone());
            (*key, NewVoice { voice: it.voice.clone(), handover })
        };
        former.take(MOST_AT_ONCE).map(voice).collect()
    }
}

const fn is_in(keys: u128, key: u8) -> bool {
    keys >> key & 1 == 1
}

/// Plays `changes`; returns the former voices, or nothing if they are rejected until the next poll.
fn change(
    handler: &RequestHandler,
    changes: BTreeMap<u8, NewVoice>,
) -> Option<Vec<(u8, OriginalVoice)>> {
    let mut playing = handler.playing();
    let before = originals(&playing, &changes);
    let model = &changes.values().next()?.voice.model;
    let catalogue = handler.catalogue_with(&playing, model);
    handler.put_in(&mut playing, changes, catalogue, OVERLOAD).ok()?;
    Some(before)
}

fn originals(
    playing: &CurrentVoices,
    changes: &BTreeMap<u8, NewVoice>,
) -> Vec<(u8, OriginalVoice)> {
    let original = |(key, new): (&u8, &NewVoice)| {
        let index = usize::from(*key);
        let VoiceHandover::Anew(_, lower) = &new.handover else { return None };
        let original = OriginalVoice {
            voice: playing.keys.get(index)?.clone()?,
            voicing: playing.voicings.get(index)?.clone()?,
            instrument: playing.instruments.get(index)?.clone()?,
            lower: lower.clone(),
        };
        Some((*key, original))
    };
    changes.iter().filter_map(original).collect()
}

/// Returns the next lower fidelity of instrument `name` that is stable in `handler`'s loop.
fn lower(handler: &RequestHandler, name: &str) -> Option<Instrument> {
    let library = &handler.scene.library;
    let (_fidelity, lower) = Instrument::load(library, name).ok()?.levels.into_iter().next()?;
    let lower = Instrument::load(library, &lower).ok()?;
    let keys = handler.playing().keys_in(KeyRange::ALL).ok()?;
    handler.refuse_unfit(&lower, &keys).ok()?;
    Some(lower)
}
