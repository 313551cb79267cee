//! What was wanted against what was struck.

use std::fmt;

use crate::align::align;

/// A strike further than this from its note's onset is not in time (s).
///
/// A little more than half of a grand's quickest repetition (15/s).
pub const WINDOW: f64 = 0.04;

/// A strike later than this after a note's onset is not taken for the note (s).
pub const REACH: f64 = 5.0;

/// A note that should be heard.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct ExpectedNote {
    /// Which key, 0 ..= 87.
    pub key: u8,
    /// When (s since the start of the performance).
    pub onset: f64,
    /// Speed of the hammer at the string (m/s).
    pub speed: f64,
    /// MIDI velocity, 1 ..= 127.
    pub velocity: u8,
}

/// A strike that really happened.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Struck {
    /// Which key, 0 ..= 87.
    pub key: u8,
    /// Time of the strike (s).
    pub at: f64,
    /// How hard, as a MIDI velocity, 1 ..= 127.
    pub velocity: u8,
}

/// How a set of errors is distributed, by nearest rank; all zero if there is none.
#[derive(Clone, Copy, PartialEq, Debug, Default)]
pub struct Spread {
    /// Half of the errors are at most this.
    pub p50: f64,
    /// 99 % of the errors are at most this.
    pub p99: f64,
    /// No error is above this.
    pub max: f64,
}

impl Spread {
    fn of(mut errors: Vec<f64>) -> Self {
        errors.sort_by(f64::total_cmp);
        let rank = |percent: usize| {
            let index = (errors.len() * percent).div_ceil(100).saturating_sub(1);
            errors.get(index).copied().unwrap_or_default()
        };
        Self { p50: rank(50), p99: rank(99), max: rank(100) }
    }
}

/// How a performance went.
#[derive(Clone, PartialEq, Debug, Default)]
pub struct Assessment {
    /// Notes that were wanted.
    pub played: usize,
    pub struck: usize,
    /// Notes without a strike.
    pub missed: usize,
    /// Strikes without a note.
    pub extra: usize,
    /// How far strikes were from their onsets, early or late (ms).
    pub onset_error_ms: Spread,
    /// How far strikes were from their notes' velocities, in MIDI units.
    pub velocity_error: Spread,
    /// Notes that are missed or late and strikes that are extra, in order of time, then of key.
    pub deviations: Vec<Deviation>,
}

/// A note that is missed or late, or a strike that is extra.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Deviation {
    /// Which key, 0 ..= 87.
    pub key: u8,
    /// When the note is wanted, or the extra strike happened (s since the start).
    pub at: f64,
    pub kind: DeviationKind,
}

/// What is wrong with a note.
#[derive(Clone, Copy, PartialEq, Debug)]
pub enum DeviationKind {
    Missed,
    Extra,
    /// The note is struck more than [`WINDOW`] after its onset.
    Late {
        /// How late (s).
        by: f64,
    },
}

impl fmt::Display for Assessment {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Spread { p50, p99, max } = self.onset_error_ms;
        let velocity = self.velocity_error;
        write!(
            f,
            "{} notes: {} missed, {} extra strikes; onset error {p50:.2} ms (p99 {p99:.2}, \
             max {max:.2}); velocity error {:.0} (p99 {:.0}, max {:.0})",
            self.played, self.missed, self.extra, velocity.p50, velocity.p99, velocity.max
        )
    }
}

/// Compares what was wanted with what was struck.
///
/// On each key notes and strikes belong together in order, as many as there can be within
/// [`WINDOW`] and of these the nearest. What is left of a key is late where a strike follows a note
/// before the next note of the key is struck, and within [`REACH`].
pub fn assess(expected: &[ExpectedNote], struck: &[Struck]) -> Assessment {
    let mut found = NoteFindings::default();
    for key in 0..=u8::MAX {
        let mut notes: Vec<_> = expected.iter().filter(|note| note.key == key).collect();
        let mut strikes: Vec<_> = struck.iter().filter(|strike| strike.key == key).collect();
        notes.sort_by(|a, b| a.onset.total_cmp(&b.onset));
        strikes.sort_by(|a, b| a.at.total_cmp(&b.at));
        found.add(&notes, &strikes);
    }
    let NoteFindings { onset_errors, velocity_errors, mut deviations } = found;
    deviations.sort_by(|a, b| a.at.total_cmp(&b.at).then(a.key.cmp(&b.key)));
    Assessment {
        played: expected.len(),
        struck: struck.len(),
        missed: expected.len() - onset_errors.len(),
        extra: struck.len() - onset_errors.len(),
        onset_error_ms: Spread::of(onset_errors),
        velocity_error: Spread::of(velocity_errors),
        deviations,
    }
}

/// What became of the notes of the keys so far.
#[derive(Default)]
struct NoteFindings {
    /// Of each note with a strike, early or late (ms).
    onset_errors: Vec<f64>,
    /// Of each note with a strike, in MIDI units.
    velocity_errors: Vec<f64>,
    deviations: Vec<Deviation>,
}

impl NoteFindings {
    /// Adds one key's notes and strikes, each in order of time.
    fn add(&mut self, notes: &[&ExpectedNote], strikes: &[&Struck]) {
        let onsets: Vec<_> = notes.iter().map(|note| note.onset).collect();
        let times: Vec<_> = strikes.iter().map(|strike| strike.at).collect();
        let mut from = (0, 0);
        for (note, strike) in align(&onsets, &times, WINDOW) {
            self.leave(&notes[from.0..note], &strikes[from.1..strike]);
            self.pair(notes[note], strikes[strike]);
            from = (note + 1, strike + 1);
        }
        self.leave(&notes[from.0..], &strikes[from.1..]);
    }

    fn pair(&mut self, note: &ExpectedNote, strike: &Struck) {
        self.onset_errors.push((strike.at - note.onset).abs() * 1e3);
        self.velocity_errors.push(f64::from(strike.velocity.abs_diff(note.velocity)));
    }

    /// Adds what lies between two pairs of a key: each note takes the first strike after it.
    fn leave(&mut self, notes: &[&ExpectedNote], mut strikes: &[&Struck]) {
        let extra = |strike: &&Struck| Deviation {
            key: strike.key,
            at: strike.at,
            kind: DeviationKind::Extra,
        };
        for note in notes {
            let early = strikes.partition_point(|strike| strike.at < note.onset);
            self.deviations.extend(strikes[..early].iter().map(extra));
            strikes = &strikes[early..];
            let mut kind = DeviationKind::Missed;
            if let Some((strike, rest)) = strikes.split_first()
                && strike.at - note.onset <= REACH
            {
                kind = DeviationKind::Late { by: strike.at - note.onset };
                self.pair(note, strike);
                strikes = rest;
            }
            self.deviations.push(Deviation { key: note.key, at: note.onset, kind });
        }
        self.deviations.extend(strikes.iter().map(extra));
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn expected(key: u8, onset: f64, velocity: u8) -> ExpectedNote {
        ExpectedNote { key, onset, speed: 1.0, velocity }
    }

    fn struck(key: u8, at: f64, velocity: u8) -> Struck {
        Struck { key, at, velocity }
    }

    #[test]
    fn every_note_finds_its_strike() {
        let notes = [expected(1, 1.0, 60), expected(1, 1.1, 60), expected(2, 1.0, 70)];
        let strikes = [struck(2, 1.001, 72), struck(1, 1.0995, 60), struck(1, 0.998, 59)];
        let found = assess(&notes, &strikes);
        assert_eq!((found.missed, found.extra), (0, 0));
        assert!((found.onset_error_ms.max - 2.0).abs() < 1e-9);
        assert!((found.onset_error_ms.p50 - 1.0).abs() < 1e-9);
        assert_eq!(found.velocity_error, Spread { p50: 1.0, p99: 2.0, max: 2.0 });
    }

    #[test]
    fn a_double_strike_is_an_extra_one() {
        let found = assess(&[expected(1, 1.0, 60)], &[struck(1, 1.01, 9), struck(1, 1.001, 60)]);
        assert_eq!((found.missed, found.extra), (0, 1));
        assert_eq!(found.velocity_error, Spread::default());
    }

    #[test]
    fn a_strike_on_another_key_or_too_late_is_a_miss() {
        let notes = [expected(1, 1.0, 60), expected(2, 2.0, 60)];
        let found = assess(&notes, &[struck(2, 1.0, 60), struck(2, 2.0 + 2.0 * REACH, 60)]);
        assert_eq!((found.played, found.struck, found.missed, found.extra), (2, 2, 2, 2));
        assert_eq!(found.onset_error_ms, Spread::default());
        let kinds: Vec<_> = found.deviations.iter().map(|it| (it.key, it.at, it.kind)).collect();
        let (missed, extra) = (DeviationKind::Missed, DeviationKind::Extra);
        assert_eq!(kinds, [(1, 1.0, missed), (2, 1.0, extra), (2, 2.0, missed), (2, 12.0, extra)]);
    }

    #[test]
    fn a_note_that_is_four_seconds_late_is_one_late_note() {
        let found = assess(&[expected(1, 1.0, 60)], &[struck(1, 5.0, 60)]);
        assert_eq!((found.missed, found.extra), (0, 0));
        assert!((found.onset_error_ms.max - 4000.0).abs() < 1e-9);
        let late = DeviationKind::Late { by: 4.0 };
        assert_eq!(found.deviations, [Deviation { key: 1, at: 1.0, kind: late }]);
    }

    #[test]
    fn a_strike_after_the_next_note_s_own_is_not_the_missed_note_s() {
        let notes = [expected(1, 1.0, 60), expected(1, 3.0, 60)];
        let found = assess(&notes, &[struck(1, 3.0, 60), struck(1, 3.05, 9)]);
        assert_eq!((found.missed, found.extra), (1, 1));
        assert!(found.onset_error_ms.max < 1e-9);
    }

    #[test]
    fn nothing_wanted_and_nothing_struck_is_no_error() {
        assert_eq!(assess(&[], &[]), Assessment::default());
    }
}
