//! What was wanted against what was struck.

use std::collections::BTreeMap;
use std::fmt;

/// A strike further than this from its note's onset belongs to no note (s).
///
/// A little more than half of a grand's quickest repetition (15/s).
pub const WINDOW: f64 = 0.04;

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

/// Errors in whole units, and how often each occurred: little memory for any number of them.
#[derive(Clone, PartialEq, Eq, Debug, Default)]
struct ErrorCounts(BTreeMap<u32, usize>);

impl ErrorCounts {
    fn add(&mut self, error: u32) {
        *self.0.entry(error).or_default() += 1;
    }

    /// Returns how the errors are distributed, of which each unit is `unit`.
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

/// How a performance went.
#[derive(Clone, Copy, PartialEq, Debug, Default)]
pub struct Assessment {
    /// Notes that were wanted.
    pub played: usize,
    pub struck: usize,
    /// Notes without a strike.
    pub missed: usize,
    /// Strikes without a note.
    pub extra: usize,
    /// How far strikes were from their onsets, early or late (ms), to a microsecond.
    pub onset_error_ms: Spread,
    /// How far strikes were from their notes' velocities, in MIDI units.
    pub velocity_error: Spread,
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
/// On each key, notes and strikes that are nearest to each other belong together first; each is
/// used once, and none is paired over more than [`WINDOW`].
pub fn assess(expected: &[ExpectedNote], struck: &[Struck]) -> Assessment {
    let mut counts = NoteCounts::default();
    counts.add(expected, struck);
    counts.assessment()
}

/// What was counted of all passes so far.
#[derive(Clone, PartialEq, Debug, Default)]
struct NoteCounts {
    played: usize,
    struck: usize,
    paired: usize,
    /// How far strikes were from their onsets (us).
    onset: ErrorCounts,
    /// How far strikes were from their notes' velocities, as [`Assessment`] has it.
    velocity: ErrorCounts,
}

impl NoteCounts {
    fn add(&mut self, expected: &[ExpectedNote], struck: &[Struck]) {
        let pairs = pair(expected, struck);
        self.played += expected.len();
        self.struck += struck.len();
        self.paired += pairs.len();
        for (note, strike) in pairs {
            let (note, strike) = (&expected[note], &struck[strike]);
            #[expect(
                clippy::cast_possible_truncation,
                clippy::cast_sign_loss,
                reason = "a window"
            )]
            self.onset.add(((strike.at - note.onset).abs() * 1e6).round() as u32);
            self.velocity.add(strike.velocity.abs_diff(note.velocity).into());
        }
    }

    fn assessment(&self) -> Assessment {
        Assessment {
            played: self.played,
            struck: self.struck,
            missed: self.played - self.paired,
            extra: self.struck - self.paired,
            onset_error_ms: self.onset.spread(1e-3),
            velocity_error: self.velocity.spread(1.0),
        }
    }
}

/// Compares a performance with what is struck while it is played, as often as it repeats.
///
/// It keeps the strikes of one pass, and of those before their counts.
#[derive(Clone, Debug)]
pub struct Assessor {
    expected: Vec<ExpectedNote>,
    /// Length of a pass (s), if there is more than one.
    repeat: Option<f64>,
    /// Passes that are over.
    passes: u64,
    /// Strikes of the present pass, in time from its beginning.
    struck: Vec<Struck>,
    counts: NoteCounts,
}

impl Assessor {
    /// Returns an assessor that has heard nothing yet; the notes that are expected come again
    /// after `repeat` (s), if they do.
    pub fn new(expected: Vec<ExpectedNote>, repeat: Option<f64>) -> Self {
        let (struck, counts) = (Vec::new(), NoteCounts::default());
        Self { expected, repeat, passes: 0, struck, counts }
    }

    /// Takes a strike; those of one pass come before those of the next.
    pub fn hear(&mut self, strike: Struck) {
        let at = self.in_pass(strike.at);
        self.struck.push(Struck { at, ..strike });
    }

    /// Returns how all went that the performance asks for before the end at `duration` (s).
    pub fn finish(mut self, duration: f64) -> Assessment {
        // A note wanted within a matching window of the end may rightly be struck after it.
        let heard = self.in_pass(duration - WINDOW);
        self.expected.retain(|note| note.onset < heard);
        self.struck.retain(|strike| strike.at < heard);
        self.counts.add(&self.expected, &self.struck);
        self.counts.assessment()
    }

    /// Returns the time since the beginning of the pass in which `at` (s) is; ends those before.
    fn in_pass(&mut self, at: f64) -> f64 {
        let Some(length) = self.repeat else { return at };
        while (self.passes + 1) as f64 * length <= at {
            self.counts.add(&self.expected, &self.struck);
            self.struck.clear();
            self.passes += 1;
        }
        at - self.passes as f64 * length
    }
}

/// Which note belongs to which strike, as indices.
fn pair(expected: &[ExpectedNote], struck: &[Struck]) -> Vec<(usize, usize)> {
    let mut candidates = candidates(expected, struck);
    candidates.sort_by(|a, b| a.0.total_cmp(&b.0).then((a.1, a.2).cmp(&(b.1, b.2))));
    let mut note_is_free = vec![true; expected.len()];
    let mut strike_is_free = vec![true; struck.len()];
    let mut pairs = Vec::new();
    for (_distance, note, strike) in candidates {
        if note_is_free[note] && strike_is_free[strike] {
            note_is_free[note] = false;
            strike_is_free[strike] = false;
            pairs.push((note, strike));
        }
    }
    pairs
}

/// Every pair of a note and a strike within the window, with its distance (s).
fn candidates(expected: &[ExpectedNote], struck: &[Struck]) -> Vec<(f64, usize, usize)> {
    let mut by_time: Vec<usize> = (0..struck.len()).collect();
    by_time.sort_by(|a, b| struck[*a].at.total_cmp(&struck[*b].at));
    let mut found = Vec::new();
    for (note, wanted) in expected.iter().enumerate() {
        let first = by_time.partition_point(|i| struck[*i].at < wanted.onset - WINDOW);
        let near = by_time[first..].iter().take_while(|i| struck[**i].at <= wanted.onset + WINDOW);
        for &strike in near.filter(|i| struck[**i].key == wanted.key) {
            found.push(((struck[strike].at - wanted.onset).abs(), note, strike));
        }
    }
    found
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
        let found = assess(&notes, &[struck(2, 1.0, 60), struck(2, 2.0 + 2.0 * WINDOW, 60)]);
        assert_eq!((found.played, found.struck, found.missed, found.extra), (2, 2, 2, 2));
        assert_eq!(found.onset_error_ms, Spread::default());
    }

    #[test]
    fn passes_add_up_to_their_last_note_and_keep_the_strikes_of_one() {
        let notes = vec![expected(1, 1.0, 60), expected(2, 2.0, 60)];
        let mut assessor = Assessor::new(notes, Some(4.0));
        for pass in 0..1000_u32 {
            let at = 4.0 * f64::from(pass) + 1.0 + 1e-6 * f64::from(pass % 100);
            assessor.hear(struck(1, at, 61));
            assert!(assessor.struck.len() <= 1, "of this pass");
        }
        // The last pass is over before its second note; in a pass of silence all is missed.
        let found = assessor.clone().finish(4.0 * 999.0 + 1.5);
        assert_eq!((found.played, found.struck, found.missed, found.extra), (1999, 1000, 999, 0));
        assert!((found.onset_error_ms.p50 - 0.049).abs() < 1e-9, "{found}");
        assert!((found.onset_error_ms.p99 - 0.098).abs() < 1e-9, "{found}");
        assert_eq!(found.velocity_error, Spread { p50: 1.0, p99: 1.0, max: 1.0 });
        assert_eq!(assessor.finish(4.0 * 1001.0).missed, 1000 + 2);
    }

    #[test]
    fn nothing_wanted_and_nothing_struck_is_no_error() {
        assert_eq!(assess(&[], &[]), Assessment::default());
    }
}
