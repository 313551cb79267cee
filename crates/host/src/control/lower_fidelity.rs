//! Lower fidelities for keys at rest while a tick has more work than time, and back again.

use std::collections::BTreeMap;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::thread;
use std::time::Duration;

use keyboard::KeyRange;
use scene::{Instrument, KeyVoice, Voicing};
use scheduler::overload::Simplification;

use super::RequestHandler;
use super::current_voices::CurrentVoices;
use super::new_voice::{NewVoice, VoiceHandover};

/// Time between two looks.
const LOOK: Duration = Duration::from_millis(50);

/// Keys that are changed at a look: their voices are built beside a tick that has too much to do.
const MOST_AT_ONCE: usize = 8;

/// The writer that telemetry names.
const OVERLOAD: &str = "overload";

/// Gives keys at rest a lower fidelity while the scheduler leaves fidelity out, on a thread of its
/// own; ends when it is dropped.
#[derive(Debug)]
pub struct FidelityWatch {
    stop: Arc<AtomicBool>,
}

impl FidelityWatch {
    /// Watches the run that `handler` answers for.
    ///
    /// # Errors
    /// If the system gives no thread.
    pub fn start(handler: Arc<RequestHandler>) -> std::io::Result<Self> {
        let stop = Arc::new(AtomicBool::new(false));
        let its_stop = Arc::clone(&stop);
        thread::Builder::new().name("letoff-fidelity".into()).spawn(move || {
            let mut lowered = LoweredKeys::default();
            while !its_stop.load(Ordering::Acquire) {
                thread::sleep(LOOK);
                lowered.look(&handler);
            }
        })?;
        Ok(Self { stop })
    }
}

impl Drop for FidelityWatch {
    fn drop(&mut self) {
        self.stop.store(true, Ordering::Release);
    }
}

/// The keys that have a lower fidelity now.
#[derive(Debug, Default)]
struct LoweredKeys {
    before: BTreeMap<u8, OriginalVoice>,
    /// The next lower fidelity of each instrument, if it has one that is stable.
    lower: BTreeMap<String, Option<Arc<Instrument>>>,
    /// Keys that were changed and not told of yet.
    untold: usize,
}

/// What a key played before.
#[derive(Debug)]
struct OriginalVoice {
    voice: KeyVoice,
    voicing: Voicing,
    instrument: String,
    /// What it was given instead.
    lower: String,
}

impl LoweredKeys {
    /// Looks once at all keys at rest.
    fn look(&mut self, handler: &RequestHandler) {
        let Some(counters) = handler.run.status.counters() else { return };
        let is_wanted = counters.overload.now().contains(Simplification::Fidelity);
        let asleep: Vec<_> = counters.keys_asleep().collect();
        let changes = if is_wanted {
            self.lower_voices(handler, &asleep)
        } else {
            self.former_voices(handler, &asleep)
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

    /// Tells what was done in the last looks, once there is nothing more to do.
    fn tell(&mut self, handler: &RequestHandler) {
        let (changed, lower) = (std::mem::take(&mut self.untold), self.before.len());
        if 0 < changed {
            let text = format!("{changed} keys changed at rest; {lower} have a lower fidelity");
            handler.tell(&text, OVERLOAD);
        }
    }

    /// Returns the lower voices of some keys that are `asleep`, all of one instrument.
    fn lower_voices(&mut self, handler: &RequestHandler, asleep: &[u8]) -> BTreeMap<u8, NewVoice> {
        let playing = handler.playing().clone();
        let mut changes = BTreeMap::new();
        let mut of: Option<&str> = None;
        for key in asleep.iter().filter(|key| !self.before.contains_key(key)) {
            let Some(name) = playing.untouched_instrument(*key) else { continue };
            if of.is_some_and(|of| of != name) || changes.len() == MOST_AT_ONCE {
                continue;
            }
            let lower = self.lower.entry(name.to_owned()).or_insert_with(|| lower(handler, name));
            let Some(lower) = lower else { continue };
            of = Some(name);
            changes.insert(*key, NewVoice::anew(&lower.voicing, *key, &lower.name));
        }
        changes
    }

    /// Returns the former voices of some keys that are `asleep`, all of one instrument, unless
    /// somebody else changed them meanwhile.
    fn former_voices(&mut self, handler: &RequestHandler, asleep: &[u8]) -> BTreeMap<u8, NewVoice> {
        if self.before.is_empty() {
            return BTreeMap::new();
        }
        let playing = handler.playing().clone();
        self.before.retain(|key, it| playing.untouched_instrument(*key) == Some(it.lower.as_str()));
        let mut changes = BTreeMap::new();
        let of = self.before.values().next().map(|it| it.instrument.clone());
        for (key, it) in &self.before {
            let is_first = of.as_ref() == Some(&it.instrument);
            if !is_first || !asleep.contains(key) || changes.len() == MOST_AT_ONCE {
                continue;
            }
            let handover = VoiceHandover::Anew(it.voicing.clone(), it.instrument.clone());
            changes.insert(*key, NewVoice { voice: it.voice.clone(), handover });
        }
        changes
    }
}

/// Lets `changes` play; returns what those keys played before, or nothing if they are refused now,
/// and tried again at the next look.
fn change(
    handler: &RequestHandler,
    changes: BTreeMap<u8, NewVoice>,
) -> Option<Vec<(u8, OriginalVoice)>> {
    let mut playing = handler.playing();
    let before = originals(&playing, &changes);
    let model = changes.values().next()?.voice.model;
    let catalogue = handler.catalogue_with(&playing, model);
    handler.put_in(&mut playing, changes, catalogue, OVERLOAD).ok()?;
    Some(before)
}

/// Returns what the keys of `changes` play now.
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

/// Returns the next lower fidelity of the instrument called `name`, if it has one that is stable
/// in the loop of `handler`'s run.
fn lower(handler: &RequestHandler, name: &str) -> Option<Arc<Instrument>> {
    let (_fidelity, lower) = Instrument::load(name).ok()?.levels.into_iter().next()?;
    let lower = Instrument::load(&lower).ok()?;
    handler.refuse_unfit(&lower, KeyRange::ALL).ok()?;
    Some(Arc::new(lower))
}
