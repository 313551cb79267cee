//! What was wanted against what was struck.

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
#[derive(Clone, Copy, PartialEq, Debug, Default)]
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
    let pairs = pair(expected, struck);
    let onset =
        |&(note, strike): &(usize, usize)| (struck[strike].at - expected[note].onset).abs() * 1e3;
    let velocity = |&(note, strike): &(usize, usize)| {
        f64::from(struck[strike].velocity.abs_diff(expected[note].velocity))
    };
    Assessment {
        played: expected.len(),
        struck: struck.len(),
        missed: expected.len() - pairs.len(),
        extra: struck.len() - pairs.len(),
        onset_error_ms: Spread::of(pairs.iter().map(onset).collect()),
        velocity_error: Spread::of(pairs.iter().map(velocity).collect()),
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
    fn nothing_wanted_and_nothing_struck_is_no_error() {
        assert_eq!(assess(&[], &[]), Assessment::default());
    }
}
