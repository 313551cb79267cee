//! The virtual pianist: reads the piece, rehearses it on the scene's own keys, sits down.

use std::sync::{Mutex, PoisonError};

use performance::{Performance, Pianist, Score, Technique, read};

use super::SessionError;
use super::key_source::KeySource;
use crate::rehearsal::RehearsedKey;
use scene::{PerformanceSource, Scene};
use voice::VoiceBuilder;

pub use performance::Progress as PianistProgress;

/// Rehearses the scene's piece, up to `duration` (s) if the run ends before the piece does.
pub(super) fn rehearse(
    scene: &Scene,
    builder: &VoiceBuilder<'_>,
    key_source: &KeySource,
    duration: Option<f64>,
    progress: &(dyn Fn(PianistProgress) + Sync),
) -> Result<Option<Performance>, SessionError> {
    let Some(piece) = &scene.performance else { return Ok(None) };
    let technique = Technique::default();
    let score = load(piece)?;
    let keys = keys_of(builder, key_source)?;
    let score = within(score, duration, technique.lead_in, &keys);
    let keys = Mutex::new(keys);
    let instrument = |key: u8| {
        let keys = keys.lock().unwrap_or_else(PoisonError::into_inner);
        // `within` left only notes on keys that are there.
        keys[usize::from(key)].clone().unwrap_or_else(|| unreachable!("key {key} has no voice"))
    };
    let pianist = Pianist { curve: scene.midi.curve, technique, ..Pianist::default() };
    Ok(Some(pianist.prepare(&score, instrument, progress)))
}

fn load(source: &PerformanceSource) -> Result<Score, SessionError> {
    let failed =
        |name: &str, reason: String| SessionError::Performance { name: name.into(), reason };
    let (name, score) = match source {
        PerformanceSource::Embedded(name, bytes) => ((*name).to_owned(), read(bytes)),
        PerformanceSource::Path(path) => {
            let name = path.display().to_string();
            let bytes = std::fs::read(path).map_err(|error| failed(&name, error.to_string()))?;
            (name, read(&bytes))
        }
    };
    score.map_err(|error| failed(&name, error.to_string()))
}

/// Returns one key of every voice that has a motor, at rest.
fn keys_of(
    builder: &VoiceBuilder<'_>,
    key_source: &KeySource,
) -> Result<Vec<Option<RehearsedKey>>, SessionError> {
    let mut keys = vec![None; scheduler::motion::KEYS];
    for (key, voice) in builder.keys().filter(|(key, _)| key_source.carries(*key)) {
        keys[key] = Some(RehearsedKey::of_scene(builder, key, voice)?);
    }
    Ok(keys)
}

/// Returns the part of `score` that is struck before `duration` (s) on keys that have a voice.
fn within(
    mut score: Score,
    duration: Option<f64>,
    lead_in: f64,
    keys: &[Option<RehearsedKey>],
) -> Score {
    let end = duration.map_or(f64::INFINITY, |duration| duration - lead_in);
    score.notes.retain(|note| note.onset < end && keys[usize::from(note.key)].is_some());
    score.pedals.retain(|pedal| pedal.0 < end);
    score
}
