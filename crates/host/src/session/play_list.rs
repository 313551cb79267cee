//! The virtual pianist: reads its pieces, rehearses them on the scene's own keys, and plays.
//!
//! A play list is one long score, so that all of it is rehearsed before the first tick.

use std::collections::BTreeMap;
use std::sync::{Arc, Mutex, PoisonError};

use haptics::Gesture;
use instruments::{Playable, Visitor};
use midi::ScoreTiming;
use pianist::{ChosenParts, Performance, Pianist, Score, Technique};

use super::SessionError;
use crate::control::RunHandle;
use crate::report::UnplayedNotes;
use engine::realtime::clock;
use engine::voice::VoiceBuilder;
use figures::rehearsal::{MAX_REHEARSED_TICKS, RehearsalError, RehearsalWork, RehearsedKey};
use scene::{MidiOutput, PerformanceSource, PlayList, Scene};

pub use pianist::Progress as PianistProgress;

/// Silence between two pieces (s), in which fingers and strings come to rest.
const REST: f64 = 2.0;

#[derive(Debug)]
pub(super) struct RehearsedPlayList {
    pub(super) performance: Performance,
    pub(super) pieces: usize,
    /// Length of a pass in ticks, if the list repeats.
    pub(super) pass: Option<u64>,
    pub(super) unplayed: UnplayedNotes,
    /// Bars and names of the piece for a MIDI file, which begin at time 0 of the run.
    pub(super) timing: Option<ScoreTiming>,
    pub(super) is_kept: bool,
}

/// Rehearses the scene's play list, up to `duration` (s) if the run ends before the list does.
pub(super) fn rehearse(
    scene: &Scene,
    builder: &VoiceBuilder<'_>,
    duration: Option<f64>,
    handle: &RunHandle,
    progress: &(dyn Fn(PianistProgress) + Sync),
) -> Result<Option<RehearsedPlayList>, SessionError> {
    let Some(PlayList { pieces, repeat, parts }) = &scene.play_list else { return Ok(None) };
    let hold = Gesture::hold_of(scene.rig.dip);
    let mut technique = Technique { hold, ..Technique::default() };
    let score = load_all(pieces, parts)?;
    let timing = timing_of(scene, &score, &mut technique);
    let length = score.end() + technique.lead_in;
    let work =
        Arc::new(RehearsalWork::new(MAX_REHEARSED_TICKS, Arc::clone(handle.background.is_over())));
    let keys = keys_of(builder, &work)?;
    let (mut score, unplayed) = within(score, duration, technique.lead_in, &keys);
    without_dynamics(&mut score, scene);
    let period = builder.period().as_secs_f64();
    if least_ticks(&score, period) > MAX_REHEARSED_TICKS as f64 {
        return Err(RehearsalError::TooLong.into());
    }
    let keys = Mutex::new(keys);
    let instrument = |key: u8| {
        let keys = keys.lock().unwrap_or_else(PoisonError::into_inner);
        // `within` left only notes on keys with a voice.
        keys[usize::from(key)].clone().unwrap_or_else(|| unreachable!("key {key} has no voice"))
    };
    let pianist = Pianist { curve: scene.midi.curve, technique, ..Pianist::default() };
    let rehearsed = |now: PianistProgress| {
        handle.status.rehearse(now.done, now.total);
        progress(now);
    };
    let cache = handle.rehearsals();
    let content = cache.map(|cache| cache.content((scene, builder), &pianist, &score));
    let cache = cache.zip(content.as_deref());
    let kept = cache.and_then(|(cache, content)| cache.find(content));
    let is_kept = kept.is_some();
    let mut performance = kept.unwrap_or_else(|| pianist.prepare(&score, instrument, rehearsed));
    work.verdict()?;
    if let Some((cache, content)) = cache.filter(|_| !is_kept) {
        // Without a place for it the next run rehearses again.
        let _unkept = cache.keep(content, &performance);
    }
    // The length of a cut score is too small.
    let length = length.max(performance.end()) + REST - technique.lead_in;
    let pass = repeat.then(|| clock::nearest_integer((length / period).ceil()));
    performance.repeat = pass.map(|ticks| ticks as f64 * period);
    let pieces = pieces.len();
    Ok(Some(RehearsedPlayList { performance, pieces, pass, unplayed, timing, is_kept }))
}

fn load_all(pieces: &[PerformanceSource], parts: &ChosenParts) -> Result<Score, SessionError> {
    let load = |source: &PerformanceSource| {
        let failed = |reason| SessionError::Performance { name: source.name(), reason };
        source.score(parts).map_err(failed)
    };
    let scores: Vec<_> = pieces.iter().map(load).collect::<Result<_, _>>()?;
    let lifted = scores.into_iter().map(Score::with_pedals_lifted);
    Ok(lifted.reduce(|one, next| one.followed_by(next, REST)).unwrap_or_default())
}

/// Returns the bars of a single piece for a file, and lengthens the silence before the piece to
/// whole bars. Several pieces, or a piece that repeats, have none: their rests are no bars.
fn timing_of(scene: &Scene, score: &Score, technique: &mut Technique) -> Option<ScoreTiming> {
    let repeats = scene.play_list.as_ref().is_some_and(|list| list.repeat);
    let is_written = matches!(scene.midi.output, MidiOutput::File(_)) && !repeats;
    let mut timing = score.timing.clone().filter(|_| is_written)?;
    technique.lead_in = timing.begin_after(technique.lead_in);
    Some(timing)
}

/// Plays keys without dynamics with an even touch: an organ gets no louder from a harder touch.
fn without_dynamics(score: &mut Score, scene: &Scene) {
    const EVEN: u8 = 64;
    for note in &mut score.notes {
        let voice = scene.keys[usize::from(note.key)].as_ref();
        if voice.is_some_and(|voice| voice.model.visit(HasOneVelocity)) {
            note.velocity = EVEN;
        }
    }
}

struct HasOneVelocity;

impl Visitor for HasOneVelocity {
    type Output = bool;

    fn visit<M: Playable>(self, model: M) -> Self::Output {
        model.midi().velocity.is_some()
    }
}

fn keys_of(
    builder: &VoiceBuilder<'_>,
    work: &Arc<RehearsalWork>,
) -> Result<Vec<Option<RehearsedKey>>, SessionError> {
    let mut keys = vec![None; scheduler::motion::KEYS];
    for (key, voice) in builder.keys() {
        let rehearsed = keys[key].insert(RehearsedKey::of_scene(builder, key, voice)?);
        rehearsed.count_by(Arc::clone(work));
    }
    Ok(keys)
}

/// Returns a lower bound for the ticks of `period` (s) of a rehearsal: each key's up to its last
/// note.
fn least_ticks(score: &Score, period: f64) -> f64 {
    let mut last = BTreeMap::<u8, f64>::new();
    for note in &score.notes {
        let last = last.entry(note.key).or_default();
        *last = last.max(note.onset);
    }
    last.into_values().sum::<f64>() / period
}

/// Returns the notes struck before `duration` (s) on keys with a voice, and those left out.
fn within(
    mut score: Score,
    duration: Option<f64>,
    lead_in: f64,
    keys: &[Option<RehearsedKey>],
) -> (Score, UnplayedNotes) {
    let end = duration.map_or(f64::INFINITY, |duration| duration - lead_in);
    score.notes.retain(|note| note.onset < end);
    score.pedals.retain(|pedal| pedal.at < end);
    let (voiced, without_voice): (Vec<_>, Vec<_>) =
        score.notes.iter().copied().partition(|note| keys[usize::from(note.key)].is_some());
    let without_voice: Vec<u8> = without_voice.iter().map(|note| note.key).collect();
    let unplayed = UnplayedNotes::new(&without_voice, score.passed_over);
    (Score { notes: voiced, ..score }, unplayed)
}
