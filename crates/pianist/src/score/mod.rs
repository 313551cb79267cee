//! A Standard MIDI File as notes with times in seconds.

mod merge;
mod notes;
mod tempo;

use midi::{Pedal, PedalMove, Velocity};
use midly::{Format, Smf};

use notes::NoteCollector;

/// Contents of a MIDI file for a pianist.
#[derive(Clone, PartialEq, Debug, Default)]
pub struct Score {
    /// Notes in order of onset, then of key; no two on one key overlap.
    pub notes: Vec<ScoreNote>,
    /// Pedal moves in order of time.
    pub pedals: Vec<PedalMove>,
    /// Notes left out: not on the 88 keys, or on channel 10, which is percussion.
    pub skipped: u32,
    /// Notes shortened or left out because another note already held their key.
    pub overlaps: u32,
}

impl Score {
    /// Returns the time of the last note's end or the last pedal move (s).
    pub fn end(&self) -> f64 {
        let moves = self.pedals.iter().map(|pedal| pedal.at);
        self.notes.iter().map(|note| note.end).chain(moves).fold(0.0, f64::max)
    }

    /// Returns this score and then `next`, which begins `rest` (s) after the end of this one.
    #[must_use]
    pub fn followed_by(mut self, next: Self, rest: f64) -> Self {
        let later = self.end() + rest;
        let note = |it: ScoreNote| ScoreNote { onset: it.onset + later, end: it.end + later, ..it };
        self.notes.extend(next.notes.into_iter().map(note));
        let pedal = |it: PedalMove| PedalMove { at: it.at + later, ..it };
        self.pedals.extend(next.pedals.into_iter().map(pedal));
        self.skipped = self.skipped.saturating_add(next.skipped);
        self.overlaps = self.overlaps.saturating_add(next.overlaps);
        self
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

/// One note of a score.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct ScoreNote {
    /// Key, 0 ..= 87.
    pub key: u8,
    /// Wanted time of the strike (s).
    pub onset: f64,
    /// Wanted time of damping (s); not before the onset.
    pub end: f64,
    /// MIDI velocity, 1 ..= 127.
    pub velocity: u8,
    /// Release velocity, if the file contains one.
    pub release: Option<Velocity>,
}

/// Reason why a file cannot be played.
#[derive(Clone, PartialEq, Eq, Debug, thiserror::Error)]
pub enum ScoreError {
    #[error("the file is empty")]
    Empty,
    #[error("this is not a MIDI file, which would begin with MThd ({reason})")]
    NotMidi {
        /// Message of the parser.
        reason: String,
    },
    /// The file ends before its tracks do.
    #[error("the MIDI file is truncated: a chunk of {declared} bytes has only {present}")]
    Truncated {
        /// Bytes that a chunk announces.
        declared: u64,
        present: u64,
    },
    #[error("the MIDI file is truncated: of {declared} tracks only {present} are there")]
    TracksMissing {
        /// Tracks that the header announces.
        declared: u16,
        present: u16,
    },
    /// The header gives no length of a tick.
    #[error("the MIDI file gives its ticks no length")]
    NoTiming,
    #[error("the MIDI file holds independent patterns (format 2): save the wanted one as format 0")]
    Patterns,
    #[error("the MIDI file has no notes on the 88 keys ({skipped} others were left out)")]
    NoNotes {
        /// Notes left out: see [`Score::skipped`].
        skipped: u32,
    },
}

/// Reads a MIDI file; never panics on any bytes.
///
/// All tracks are merged; tempo changes, metrical and SMPTE times are supported. A note without an
/// end ends with the file. A tempo of zero, and bytes after the last track, are ignored.
///
/// # Errors
/// The bytes are not a complete MIDI file with at least one note on the 88 keys.
pub fn read(bytes: &[u8]) -> Result<Score, ScoreError> {
    if bytes.is_empty() {
        return Err(ScoreError::Empty);
    }
    // The parser checks files that are wrapped in RIFF.
    let chunks = if bytes.starts_with(b"MThd") { whole_chunks(bytes)? } else { bytes };
    let not_midi = |error: midly::Error| error.kind().message().to_owned();
    let smf =
        Smf::parse(chunks).map_err(|error| ScoreError::NotMidi { reason: not_midi(error) })?;
    if smf.header.format == Format::Sequential {
        return Err(ScoreError::Patterns);
    }
    let mut tempo = tempo::Map::new(smf.header.timing).ok_or(ScoreError::NoTiming)?;
    let mut notes = NoteCollector::default();
    for event in merge::merge(&smf.tracks) {
        let at = tempo.seconds(event.tick);
        tempo.follow(event.tick, event.kind);
        notes.hear(at, event.kind);
    }
    let score = notes.into_score();
    if score.notes.is_empty() {
        return Err(ScoreError::NoNotes { skipped: score.skipped });
    }
    Ok(score)
}

/// Returns the chunks at the start of `bytes`, without other bytes after the last track. Rejects a
/// truncated file, which the parser accepts: a performance must not stop in the middle.
fn whole_chunks(bytes: &[u8]) -> Result<&[u8], ScoreError> {
    let declared = bytes.get(10..12).and_then(|pair| pair.try_into().ok()).map(u16::from_be_bytes);
    let declared = declared.unwrap_or(0);
    let mut present = 0_u16;
    let mut rest = bytes;
    while let Some((kind, length, body)) = chunk(rest) {
        let Some(after) = body.get(length..) else {
            if 0 < present && declared <= present {
                break;
            }
            return Err(ScoreError::Truncated {
                declared: length as u64,
                present: body.len() as u64,
            });
        };
        present = present.saturating_add(u16::from(&kind == b"MTrk"));
        rest = after;
    }
    if present < declared {
        return Err(ScoreError::TracksMissing { declared, present });
    }
    Ok(bytes.get(..bytes.len() - rest.len()).unwrap_or(bytes))
}

/// Returns kind and announced length of the next chunk, and all bytes after these.
fn chunk(bytes: &[u8]) -> Option<([u8; 4], usize, &[u8])> {
    let (kind, rest) = bytes.split_first_chunk::<4>()?;
    let (length, body) = rest.split_first_chunk::<4>()?;
    Some((*kind, u32::from_be_bytes(*length) as usize, body))
}
