//! Comparison of the wanted notes with the strikes.

use std::collections::BTreeMap;
use std::fmt;

use crate::align::align;

/// Largest distance of a strike from its note's onset (s): a little more than half of a grand's
/// quickest repetition (15/s).
pub const WINDOW: f64 = 0.04;

/// Delay after an onset beyond which a strike no longer counts for the note (s).
pub const REACH: f64 = 5.0;

/// Deviations kept one by one for a repeating performance.
pub const MOST_DEVIATIONS: usize = 1000;

/// A note that should sound on key 0 ..= 87: onset and damper's fall (s since the start), hammer
/// speed (m/s), and MIDI velocities, 1 ..= 127.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct ExpectedNote {
    pub key: u8,
    pub onset: f64,
    pub speed: f64,
    pub velocity: u8,
    pub end: f64,
    pub release: Option<u8>,
}

/// A fall of the damper of key 0 ..= 87 that happened, at a time (s).
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Damped {
    pub key: u8,
    pub at: f64,
    /// Speed of the key as a release velocity, 1 ..= 127.
    pub release: u8,
}

/// A strike that happened on key 0 ..= 87, at a time (s), with MIDI velocity 1 ..= 127.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Struck {
    pub key: u8,
    pub at: f64,
    pub velocity: u8,
}

/// Distribution of a set of errors, by nearest rank; all zero if the set is empty.
#[derive(Clone, Copy, PartialEq, Debug, Default)]
pub struct Spread {
    pub p50: f64,
    pub p99: f64,
    pub max: f64,
}

/// Errors in whole units with their counts: little memory for any number of them.
#[derive(Clone, PartialEq, Eq, Debug, Default)]
struct ErrorCounts(BTreeMap<u32, usize>);

impl ErrorCounts {
    fn add(&mut self, error: u32) {
        *self.0.entry(error).or_default() += 1;
    }

    /// Returns the distribution of the errors; one count is worth `unit`.
    fn spread(&self, unit: f64) -> Spread {
        let n: usize = self.0.values().sum();
        let rank = |percent: usize| {
            let wanted = (n * percent).div_ceil(100);
            let mut seen = 0;
            let mut errors = self.0.iter();
            let found = errors.find(|(_error, count)| {
                seen += **count;
                wanted <= seen
            });
            found.map_or(0.0, |(error, _count)| f64::from(*error) * unit)
        };
        Spread { p50: rank(50), p99: rank(99), max: rank(100) }
    }
}

/// Result of a performance.
#[derive(Clone, PartialEq, Debug, Default)]
pub struct Assessment {
    pub played: usize,
    pub struck: usize,
    /// Notes without a strike.
    pub missed: usize,
    /// Strikes without a note.
    pub extra: usize,
    /// Distances of strikes from their onsets, early or late (ms), to a microsecond.
    pub onset_error_ms: Spread,
    /// Distances of strikes from their notes' velocities (MIDI units).
    pub velocity_error: Spread,
    /// Distances of note ends from the wanted ones (ms), early or late, to a microsecond. A note
    /// ends when its damper falls, or when its key is struck again.
    pub end_error_ms: Spread,
    /// Distances of release velocities from those of notes that have one, if any has.
    pub release_error: Option<Spread>,
    /// Missed or late notes and extra strikes, in order of time, then of key; the first
    /// [`MOST_DEVIATIONS`] of a repeating performance.
    pub deviations: Vec<Deviation>,
}

/// A missed or late note, or an extra strike, on key 0 ..= 87.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Deviation {
    pub key: u8,
    /// Wanted time of the note, or time of the extra strike (s since the start).
    pub at: f64,
    pub kind: DeviationKind,
}

/// Kind of a deviation.
#[derive(Clone, Copy, PartialEq, Debug)]
pub enum DeviationKind {
    Missed,
    Extra,
    /// The strike is more than [`WINDOW`] after the onset.
    Late {
        /// Lateness of the strike (s).
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
             max {max:.2}); velocity error {:.0} (p99 {:.0}, max {:.0}); end error {:.1} ms (p99 \
             {:.1}, max {:.1})",
            self.played,
            self.missed,
            self.extra,
            velocity.p50,
            velocity.p99,
            velocity.max,
            self.end_error_ms.p50,
            self.end_error_ms.p99,
            self.end_error_ms.max
        )
    }
}

/// Compares the wanted notes with the strikes.
///
/// On each key notes and strikes are paired in order: as many as possible within [`WINDOW`], and
/// among those the nearest. A note left over is late if a strike follows within [`REACH`] and
/// before the next note of the key is struck.
pub fn assess(expected: &[ExpectedNote], struck: &[Struck], damped: &[Damped]) -> Assessment {
    let mut found = NoteFindings::default();
    found.add(expected, struck, damped);
    found.assessment()
}

#[derive(Clone, PartialEq, Debug, Default)]
struct NoteFindings {
    played: usize,
    struck: usize,
    paired: usize,
    /// Distances of these strikes from their onsets, early or late (us).
    onset: ErrorCounts,
    velocity: ErrorCounts,
    /// Distances of note ends (us).
    end: ErrorCounts,
    release: ErrorCounts,
    deviations: Vec<Deviation>,
}

/// Strikes and falls of the damper of one key, each in order of time.
#[derive(Clone, Copy)]
struct KeyEvents<'a> {
    strikes: &'a [&'a Struck],
    falls: &'a [&'a Damped],
}

impl NoteFindings {
    fn add(&mut self, expected: &[ExpectedNote], struck: &[Struck], damped: &[Damped]) {
        let known = self.deviations.len();
        for key in 0..=u8::MAX {
            let mut notes: Vec<_> = expected.iter().filter(|note| note.key == key).collect();
            let mut strikes: Vec<_> = struck.iter().filter(|strike| strike.key == key).collect();
            notes.sort_by(|a, b| a.onset.total_cmp(&b.onset));
            strikes.sort_by(|a, b| a.at.total_cmp(&b.at));
            let mut falls: Vec<_> = damped.iter().filter(|fall| fall.key == key).collect();
            falls.sort_by(|a, b| a.at.total_cmp(&b.at));
            self.add_key(&notes, KeyEvents { strikes: &strikes, falls: &falls });
        }
        self.played += expected.len();
        self.struck += struck.len();
        self.deviations[known..].sort_by(|a, b| a.at.total_cmp(&b.at).then(a.key.cmp(&b.key)));
    }

    /// Adds one key's notes, in order of time, and events.
    fn add_key(&mut self, notes: &[&ExpectedNote], events: KeyEvents<'_>) {
        let strikes = events.strikes;
        let onsets: Vec<_> = notes.iter().map(|note| note.onset).collect();
        let times: Vec<_> = strikes.iter().map(|strike| strike.at).collect();
        let mut from = (0, 0);
        for (note, strike) in align(&onsets, &times, WINDOW) {
            self.leave(&notes[from.0..note], &strikes[from.1..strike], events);
            self.pair(notes[note], strikes[strike], events);
            from = (note + 1, strike + 1);
        }
        self.leave(&notes[from.0..], &strikes[from.1..], events);
    }

    fn pair(
        &mut self,
        note: &ExpectedNote,
        strike: &Struck,
        KeyEvents { strikes, falls }: KeyEvents<'_>,
    ) {
        self.paired += 1;
        self.onset.add(micros(strike.at - note.onset));
        self.velocity.add(strike.velocity.abs_diff(note.velocity).into());
        let next = strikes.get(strikes.partition_point(|it| it.at <= strike.at)).map(|it| it.at);
        let fall = falls.get(falls.partition_point(|it| it.at <= strike.at));
        match fall.filter(|fall| next.is_none_or(|next| fall.at <= next)) {
            Some(fall) => {
                self.end.add(micros(fall.at - note.end));
                if let Some(wanted) = note.release {
                    self.release.add(fall.release.abs_diff(wanted).into());
                }
            }
            None => {
                if let Some(next) = next {
                    self.end.add(micros(next - note.end));
                }
            }
        }
    }

    /// Adds the notes and strikes between two pairs: each note takes the first strike after it.
    fn leave(&mut self, notes: &[&ExpectedNote], mut strikes: &[&Struck], events: KeyEvents<'_>) {
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
                self.pair(note, strike, events);
                strikes = rest;
            }
            self.deviations.push(Deviation { key: note.key, at: note.onset, kind });
        }
        self.deviations.extend(strikes.iter().map(extra));
    }

    fn assessment(self) -> Assessment {
        Assessment {
            played: self.played,
            struck: self.struck,
            missed: self.played - self.paired,
            extra: self.struck - self.paired,
            onset_error_ms: self.onset.spread(1e-3),
            velocity_error: self.velocity.spread(1.0),
            end_error_ms: self.end.spread(1e-3),
            release_error: (!self.release.0.is_empty()).then(|| self.release.spread(1.0)),
            deviations: self.deviations,
        }
    }
}

/// Returns the size of a time (us).
#[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "seconds")]
fn micros(seconds: f64) -> u32 {
    (seconds.abs() * 1e6).round() as u32
}

/// Compares a performance with its strikes as it is played. Keeps the strikes of one pass only.
#[derive(Clone, Debug)]
pub struct Assessor {
    expected: Vec<ExpectedNote>,
    /// Notes that are not played and count as missed.
    left_out: Vec<ExpectedNote>,
    /// Length of a pass (s), if there are several.
    repeat: Option<f64>,
    passes: u64,
    /// Strikes of the present pass, in time from its beginning.
    struck: Vec<Struck>,
    damped: Vec<Damped>,
    findings: NoteFindings,
}

impl Assessor {
    /// Returns an assessor; `expected` and `left_out` notes return after `repeat` (s), if given.
    pub fn new(
        expected: Vec<ExpectedNote>,
        left_out: Vec<ExpectedNote>,
        repeat: Option<f64>,
    ) -> Self {
        let (struck, damped, findings) = (Vec::new(), Vec::new(), NoteFindings::default());
        Self { expected, left_out, repeat, passes: 0, struck, damped, findings }
    }

    /// Adds a strike; strikes of one pass come before those of the next.
    pub fn hear(&mut self, strike: Struck) {
        let at = self.in_pass(strike.at);
        self.struck.push(Struck { at, ..strike });
    }

    /// Adds a fall of a damper, in order of time like the strikes.
    pub fn damp(&mut self, fall: Damped) {
        let at = self.in_pass(fall.at);
        self.damped.push(Damped { at, ..fall });
    }

    /// Returns the result for the notes before the end at `duration` (s).
    pub fn finish(mut self, duration: f64) -> Assessment {
        // A note within a matching window of the end may be struck after the end.
        let heard = self.in_pass(duration - WINDOW);
        self.expected.retain(|note| note.onset < heard);
        self.left_out.retain(|note| note.onset < heard);
        self.struck.retain(|strike| strike.at < heard);
        self.end_pass();
        self.findings.assessment()
    }

    /// Ends the passes before `at` (s); returns the time of `at` within its pass (s).
    fn in_pass(&mut self, at: f64) -> f64 {
        let Some(length) = self.repeat else { return at };
        while (self.passes + 1) as f64 * length <= at {
            self.end_pass();
            self.passes += 1;
        }
        at - self.passes as f64 * length
    }

    fn end_pass(&mut self) {
        let Self { findings, repeat, .. } = self;
        let known = findings.deviations.len();
        findings.add(&self.expected, &self.struck, &self.damped);
        findings.played += self.left_out.len();
        let begun = repeat.map_or(0.0, |length| self.passes as f64 * length);
        findings.deviations[known..].iter_mut().for_each(|it| it.at += begun);
        if repeat.is_some() {
            findings.deviations.truncate(MOST_DEVIATIONS);
        }
        self.struck.clear();
        self.damped.clear();
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn expected(key: u8, onset: f64, velocity: u8) -> ExpectedNote {
        ExpectedNote { key, onset, speed: 1.0, velocity, end: onset + 0.5, release: Some(60) }
    }

    fn struck(key: u8, at: f64, velocity: u8) -> Struck {
        Struck { key, at, velocity }
    }

    #[test]
    fn every_note_finds_its_strike() {
        let notes = [expected(1, 1.0, 60), expected(1, 1.1, 60), expected(2, 1.0, 70)];
        let strikes = [struck(2, 1.001, 72), struck(1, 1.0995, 60), struck(1, 0.998, 59)];
        let found = assess(&notes, &strikes, &[]);
        assert_eq!((found.missed, found.extra), (0, 0));
        assert!((found.onset_error_ms.max - 2.0).abs() < 1e-9);
        assert!((found.onset_error_ms.p50 - 1.0).abs() < 1e-9);
        assert_eq!(found.velocity_error, Spread { p50: 1.0, p99: 2.0, max: 2.0 });
    }

    #[test]
    fn a_strike_on_another_key_or_too_late_is_a_miss() {
        let notes = [expected(1, 1.0, 60), expected(2, 2.0, 60)];
        let found = assess(&notes, &[struck(2, 1.0, 60), struck(2, 2.0 + 2.0 * REACH, 60)], &[]);
        assert_eq!((found.played, found.struck, found.missed, found.extra), (2, 2, 2, 2));
        assert_eq!(found.onset_error_ms, Spread::default());
        let kinds: Vec<_> = found.deviations.iter().map(|it| (it.key, it.at, it.kind)).collect();
        let (missed, extra) = (DeviationKind::Missed, DeviationKind::Extra);
        assert_eq!(kinds, [(1, 1.0, missed), (2, 1.0, extra), (2, 2.0, missed), (2, 12.0, extra)]);
    }

    #[test]
    fn a_note_ends_with_its_damper_or_with_the_next_strike_on_its_key() {
        let notes = [expected(1, 1.0, 60), expected(1, 1.5, 60), expected(2, 1.0, 60)];
        let strikes = [struck(1, 1.0, 60), struck(1, 1.46, 60), struck(2, 1.0, 60)];
        let damped = |key, at| Damped { key, at, release: 57 };
        // The first is never damped, the second too late, the third in time.
        let falls = [damped(2, 1.5), damped(2, 9.0), damped(1, 2.01)];
        let found = assess(&notes, &strikes, &falls);
        assert_eq!(found.end_error_ms.p50.to_bits(), 10.0_f64.to_bits(), "{found}");
        assert!((found.end_error_ms.max - 40.0).abs() < 1e-9, "{found}");
        assert_eq!(found.release_error, Some(Spread { p50: 3.0, p99: 3.0, max: 3.0 }));
    }

    #[test]
    fn a_note_that_is_four_seconds_late_is_one_late_note() {
        let found = assess(&[expected(1, 1.0, 60)], &[struck(1, 5.0, 60)], &[]);
        assert_eq!((found.missed, found.extra), (0, 0));
        assert!((found.onset_error_ms.max - 4000.0).abs() < 1e-9);
        let late = DeviationKind::Late { by: 4.0 };
        assert_eq!(found.deviations, [Deviation { key: 1, at: 1.0, kind: late }]);
    }

    #[test]
    fn a_strike_after_the_next_note_s_own_is_not_the_missed_note_s() {
        let notes = [expected(1, 1.0, 60), expected(1, 3.0, 60)];
        let found = assess(&notes, &[struck(1, 3.0, 60), struck(1, 3.05, 9)], &[]);
        assert_eq!((found.missed, found.extra), (1, 1));
        assert!(found.onset_error_ms.max < 1e-9);
    }

    #[test]
    fn passes_add_up_to_their_last_note_and_keep_the_strikes_of_one() {
        let notes = vec![expected(1, 1.0, 60), expected(2, 2.0, 60)];
        let mut assessor = Assessor::new(notes, Vec::new(), Some(4.0));
        for pass in 0..1000_u32 {
            let at = 4.0 * f64::from(pass) + 1.0 + 1e-6 * f64::from(pass % 100);
            assessor.hear(struck(1, at, 61));
            assert!(assessor.struck.len() <= 1, "of this pass");
        }
        // The last pass ends before its second note; a pass of silence misses all.
        let found = assessor.clone().finish(4.0 * 999.0 + 1.5);
        assert_eq!((found.played, found.struck, found.missed, found.extra), (1999, 1000, 999, 0));
        assert!((found.onset_error_ms.p50 - 0.049).abs() < 1e-9, "{found}");
        assert!((found.onset_error_ms.p99 - 0.098).abs() < 1e-9, "{found}");
        assert_eq!(found.velocity_error, Spread { p50: 1.0, p99: 1.0, max: 1.0 });
        assert_eq!(assessor.finish(4.0 * 1001.0).missed, 1000 + 2);
    }
}
