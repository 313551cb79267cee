//! Alignment of strikes with the notes of one key: both in order of time, none used twice.

use std::cmp::Ordering;

/// Quality of an alignment: more pairs first, then less distance between them.
#[derive(Clone, Copy, Default)]
struct AlignmentScore {
    pairs: usize,
    /// Sum over the pairs (s).
    distance: f64,
}

impl AlignmentScore {
    fn with_pair(self, distance: f64) -> Self {
        Self { pairs: self.pairs + 1, distance: self.distance + distance }
    }

    fn is_above(&self, other: &Self) -> bool {
        let by_pairs = self.pairs.cmp(&other.pairs);
        by_pairs.then(other.distance.total_cmp(&self.distance)) == Ordering::Greater
    }
}

#[derive(Clone, Copy)]
enum AlignmentStep {
    LeaveNote,
    LeaveStrike,
    Pair,
}

struct NoteChoices {
    first: usize,
    steps: Vec<AlignmentStep>,
}

/// Returns the best alignment of notes with strikes at most `window` (s) away: the most pairs, and
/// among those the least distance. Times (s) increase; pairs are indices, in order.
pub(crate) fn align(notes: &[f64], strikes: &[f64], window: f64) -> Vec<(usize, usize)> {
    // best[n]: with the notes so far and the first n strikes.
    let mut best = vec![AlignmentScore::default()];
    let rows: Vec<_> = notes.iter().map(|note| row(*note, strikes, window, &mut best)).collect();
    let mut n = strikes.len();
    let mut pairs = Vec::new();
    for (note, NoteChoices { first, steps }) in rows.iter().enumerate().rev() {
        n = n.min(first + steps.len());
        while n > *first {
            match steps[n - 1 - first] {
                AlignmentStep::LeaveNote => break,
                AlignmentStep::LeaveStrike => n -= 1,
                AlignmentStep::Pair => {
                    n -= 1;
                    pairs.push((note, n));
                    break;
                }
            }
        }
    }
    pairs.reverse();
    pairs
}

fn row(note: f64, strikes: &[f64], window: f64, best: &mut Vec<AlignmentScore>) -> NoteChoices {
    let first = strikes.partition_point(|strike| *strike < note - window);
    let end = strikes.partition_point(|strike| *strike <= note + window);
    let last = best.last().copied().unwrap_or_default();
    best.resize(end.max(first) + 1, last);
    let mut before = best[first];
    let mut choose = |n: usize| {
        let pair = before.with_pair((strikes[n] - note).abs());
        let (mut step, mut score) = (AlignmentStep::LeaveNote, best[n + 1]);
        before = score;
        for (other, it) in [(AlignmentStep::LeaveStrike, best[n]), (AlignmentStep::Pair, pair)] {
            if it.is_above(&score) {
                (step, score) = (other, it);
            }
        }
        best[n + 1] = score;
        step
    };
    NoteChoices { first, steps: (first..end).map(&mut choose).collect() }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn strikes_that_are_all_late_belong_to_their_own_notes() {
        // The strike nearest to the second note belongs to the first.
        assert_eq!(align(&[1.0, 1.05], &[1.03, 1.08], 0.04), [(0, 0), (1, 1)]);
    }

    #[test]
    fn the_nearer_of_two_strikes_is_the_note_s_and_what_is_out_of_reach_is_nobody_s() {
        assert_eq!(align(&[1.0], &[0.97, 1.001, 1.01], 0.04), [(0, 1)]);
        assert_eq!(align(&[1.0, 2.0, 3.0], &[2.01], 0.04), [(1, 0)]);
        assert_eq!(align(&[1.0], &[1.1], 0.04), []);
        assert_eq!(align(&[], &[1.1], 0.04), []);
    }

    #[test]
    fn no_other_alignment_in_order_is_better() {
        let notes = [1.0, 1.02, 1.05, 1.3, 1.31];
        let strikes = [0.98, 1.0, 1.04, 1.06, 1.29, 1.5];
        let found = align(&notes, &strikes, 0.04);
        let distance = |pairs: &[(usize, usize)]| {
            pairs.iter().map(|(note, strike)| (notes[*note] - strikes[*strike]).abs()).sum::<f64>()
        };
        let wanted = best_of(&notes, &strikes);
        assert_eq!(found.len(), wanted.0);
        assert!((distance(&found) - wanted.1).abs() < 1e-12, "{found:?}");
    }

    /// Returns pairs and distance of the best alignment, by trying all.
    fn best_of(notes: &[f64], strikes: &[f64]) -> (usize, f64) {
        let (Some((note, later)), Some((strike, rest))) =
            (notes.split_first(), strikes.split_first())
        else {
            return (0, 0.0);
        };
        let apart = (note - strike).abs();
        let paired = best_of(later, rest);
        let paired = (apart <= 0.04).then_some((paired.0 + 1, paired.1 + apart));
        let all = [Some(best_of(later, strikes)), Some(best_of(notes, rest)), paired];
        all.into_iter().flatten().fold((0, 0.0), |best, it| {
            if it.0 > best.0 || it.0 == best.0 && it.1 < best.1 { it } else { best }
        })
    }
}
