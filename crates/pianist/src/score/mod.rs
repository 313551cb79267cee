//! A Standard MIDI File as notes with times in seconds.

mod chunks;
mod notes;
mod passed_over;
mod tempo;
mod track;

use midi::output::score_timing::{self, meta};
use midi::{Pedal, PedalMove, ScoreMark, ScoreTiming, Velocity};

use chunks::Chunks;
use notes::NoteCollector;
pub use passed_over::{PassedOver, PassedOverCounts};
use track::{TrackEvent, TrackEventKind};

/// Contents of a MIDI file for a pianist.
#[derive(Clone, PartialEq, Debug, Default)]
pub struct Score {
    /// Notes in order of onset, then of key; no two on one key overlap.
    pub notes: Vec<ScoreNote>,
    /// Pedal moves in order of time.
    pub pedals: Vec<PedalMove>,
    pub passed_over: PassedOverCounts,
    /// Bars, tempi and names, unless ticks have a fixed length.
    pub timing: Option<ScoreTiming>,
    /// Every track of the file, in order.
    pub tracks: Vec<ScoreTrack>,
}

/// Track of a file.
#[derive(Clone, PartialEq, Eq, Debug, Default)]
pub struct ScoreTrack {
    pub name: String,
    /// Number of notes, played or not.
    pub notes: usize,
    /// Channels of its notes, bit 0 for channel 1.
    pub channels: u16,
}

/// Tracks and channels of a file that are played, counted from 1; an empty list is all of them.
#[derive(Clone, PartialEq, Eq, Debug, Default)]
pub struct ChosenParts {
    pub tracks: Vec<u16>,
    /// Channel 10 is percussion, and played only if it is listed.
    pub channels: Vec<u8>,
}

impl ChosenParts {
    fn contain(&self, track: u16, channel: u8) -> bool {
        let is_chosen_track = self.tracks.is_empty() || self.tracks.contains(&track);
        is_chosen_track && (self.channels.is_empty() || self.channels.contains(&channel))
    }
}

impl Score {
    /// Returns the time of the last note's end or the last pedal move (s).
    pub fn end(&self) -> f64 {
        let moves = self.pedals.iter().map(|pedal| pedal.at);
        self.notes.iter().map(|note| note.end).chain(moves).fold(0.0, f64::max)
    }

    /// Returns this score and then `next`, `rest` (s) after its end. Both together have no bars.
    #[must_use]
    pub fn followed_by(mut self, next: Self, rest: f64) -> Self {
        let later = self.end() + rest;
        let note = |it: ScoreNote| ScoreNote { onset: it.onset + later, end: it.end + later, ..it };
        self.notes.extend(next.notes.into_iter().map(note));
        let pedal = |it: PedalMove| PedalMove { at: it.at + later, ..it };
        self.pedals.extend(next.pedals.into_iter().map(pedal));
        self.passed_over.add_all(next.passed_over);
        Self { timing: None, ..self }
    }

    /// Returns this score with every pedal lifted at its end, as the next piece expects.
    #[must_use]
    pub fn with_pedals_lifted(mut self) -> Self {
        let at = self.end();
        for pedal in Pedal::ALL {
            let last = self.pedals.iter().rfind(|it| it.pedal == pedal);
            if last.is_some_and(|last| 0.0 < last.depth) {
                self.pedals.push(PedalMove { pedal, at, depth: 0.0 });
            }
        }
        self
    }
}

/// One note of a score, on key 0 ..= 87 with MIDI velocity 1 ..= 127.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct ScoreNote {
    pub key: u8,
    /// Wanted time of the strike (s).
    pub onset: f64,
    /// Wanted time of damping (s); not before the onset.
    pub end: f64,
    pub velocity: u8,
    /// Release velocity, if the file contains one.
    pub release: Option<Velocity>,
}

/// Reason why a file cannot be played.
#[derive(Clone, PartialEq, Eq, Debug, thiserror::Error)]
#[expect(missing_docs, reason = "the messages say it")]
pub enum ScoreError {
    #[error("the file is empty")]
    Empty,
    #[error("this is not a MIDI file, which begins with MThd and a header")]
    NotMidi,
    #[error("the MIDI file is truncated: of {declared} tracks only {present} are there")]
    TracksMissing { declared: u16, present: u16 },
    #[error(
        "track {track} of the MIDI file cannot be read from byte {at} on, after {notes} notes: \
         export the file again from the program that wrote it"
    )]
    Broken { track: u16, at: usize, notes: usize },
    #[error("the MIDI file gives its ticks no length")]
    NoTiming,
    #[error(
        "the MIDI file holds {tracks} independent patterns (format 2): choose one, as --track 1"
    )]
    Patterns { tracks: usize },
    #[error("the MIDI file has no track {wanted}: choose one of its tracks, 1 to {tracks}")]
    NoTrack { wanted: u16, tracks: usize },
    #[error("the MIDI file has no notes to play on the 88 keys, and {passed_over} besides")]
    NoNotes { passed_over: PassedOverCounts },
}

/// Reads all tracks and channels of a MIDI file like [`read_parts`], with the same errors.
pub fn read(bytes: &[u8]) -> Result<Score, ScoreError> {
    read_parts(bytes, &ChosenParts::default())
}

/// Reads the chosen `parts` of a MIDI file; never panics on any bytes.
///
/// All tracks are merged; tempo changes, metrical and SMPTE times are supported. A note without an
/// end ends with the file. A tempo of zero is ignored. Bytes that belong to no event, and damage
/// within the last bytes of a track, are counted; other damage is an error, since notes would be
/// missing.
///
/// # Errors
/// The bytes are not a complete MIDI file with at least one note on the 88 keys.
pub fn read_parts(bytes: &[u8], parts: &ChosenParts) -> Result<Score, ScoreError> {
    if bytes.is_empty() {
        return Err(ScoreError::Empty);
    }
    let chunks = Chunks::of(bytes)?;
    let present = 1..=chunks.tracks.len();
    if let Some(&wanted) = parts.tracks.iter().find(|it| !present.contains(&usize::from(**it))) {
        return Err(ScoreError::NoTrack { wanted, tracks: chunks.tracks.len() });
    }
    let is_pattern = chunks.format == 2;
    if is_pattern && parts.tracks.len() != 1 {
        return Err(ScoreError::Patterns { tracks: chunks.tracks.len() });
    }
    let mut tempo = tempo::Map::new(chunks.division).ok_or(ScoreError::NoTiming)?;
    let mut notes = NoteCollector::default();
    notes.parts.clone_from(parts);
    notes.passed_over.add(PassedOver::SkippedBytes, chunks.trailing);
    let mut tracks = vec![ScoreTrack::default(); chunks.tracks.len()];
    let mut marks = Vec::new();
    for event in events(&chunks, &mut notes.passed_over)? {
        // A pattern has its own tempo and bars.
        if is_pattern && !parts.tracks.contains(&event.track) {
            continue;
        }
        notes.now = tempo.seconds(event.tick);
        let track = &mut tracks[usize::from(event.track) - 1];
        match event.kind {
            TrackEventKind::Message { status, data } => {
                if notes.add(event.track, status, data) {
                    track.notes += 1;
                    track.channels |= 1 << (status & 0x0F);
                }
            }
            TrackEventKind::Meta { kind, data } => {
                if let (meta::TEMPO, Some(quarter)) = (kind, score_timing::quarter(data)) {
                    tempo.follow(event.tick, quarter);
                }
                marks.extend(mark(&event, track));
            }
            TrackEventKind::System => {}
        }
    }
    let (notes, pedals, passed_over) = notes.finish();
    if notes.is_empty() {
        return Err(ScoreError::NoNotes { passed_over });
    }
    let timing = tempo.per_quarter.map(|division| ScoreTiming::new(division, marks));
    Ok(Score { notes, pedals, passed_over, timing, tracks })
}

/// Returns the events of all tracks in order of time; simultaneous ones in order of tracks.
fn events<'a>(
    chunks: &Chunks<'a>,
    passed_over: &mut PassedOverCounts,
) -> Result<Vec<TrackEvent<'a>>, ScoreError> {
    let mut events = Vec::new();
    for (track, it) in (1..=u16::MAX).zip(&chunks.tracks) {
        let broken = |(at, notes)| ScoreError::Broken { track, at: it.at + at, notes };
        track::read(track, (it.bytes, it.missing), &mut events, passed_over).map_err(broken)?;
    }
    events.sort_by_key(|event| event.tick);
    Ok(events)
}

/// Returns the mark of a recording for a meta event of `track`, which may name the track. The first
/// track's name is the title, and the names of others are texts.
fn mark(event: &TrackEvent<'_>, track: &mut ScoreTrack) -> Option<ScoreMark> {
    let TrackEventKind::Meta { kind, data } = event.kind else { return None };
    if kind == meta::NAME && track.name.is_empty() {
        track.name = String::from_utf8_lossy(data).into_owned();
    }
    let (kind, data) = match kind {
        meta::NAME if 1 < event.track => {
            (meta::TEXT, [format!("track {}: ", event.track).as_bytes(), data].concat())
        }
        meta::NAME | meta::MARKER | meta::CUE => (kind, data.to_vec()),
        meta::TEMPO => (kind, data.first_chunk::<3>().filter(|it| it != &&[0; 3])?.to_vec()),
        meta::TIME_SIGNATURE => (kind, data.first_chunk::<4>()?.to_vec()),
        meta::KEY_SIGNATURE => (kind, data.first_chunk::<2>()?.to_vec()),
        _ => return None,
    };
    Some(ScoreMark { tick: event.tick, kind, data })
}
