//! A performance prepared and assessed on keys with closed-form responses.

use std::num::NonZero;

use haptics::plant::Gesture;
use midi::{Pedal, PedalMove};
use pianist::{
    DamperFall, Performance, Pianist, PlayOutcome, Rehearsal, Score, ScoreNote, Strike, Struck,
    assess,
};

/// A key whose hammer gets faster towards the treble and strikes 10 mm after its start.
#[derive(Clone)]
struct Toy {
    ratio: f64,
    now: f64,
}

impl Toy {
    fn new(key: u8) -> Self {
        Self { ratio: 4.0 + 0.02 * f64::from(key), now: 0.0 }
    }
}

impl Rehearsal for Toy {
    fn play(&mut self, gestures: &[Gesture], until: f64) -> PlayOutcome {
        let span = self.now..until;
        self.now = until;
        let strike = |gesture: &Gesture| Strike {
            at: gesture.start + 0.01 / gesture.speed,
            speed: self.ratio * gesture.speed,
        };
        let strikes = gestures.iter().map(strike).filter(|s| span.contains(&s.at)).collect();
        let mut falls = gestures.iter().map(|g| g.release + 0.03).filter(|at| span.contains(at));
        let fall = falls.next_back().map(|at| DamperFall { at, speed: 0.2 });
        PlayOutcome { strikes, damper_fall: fall }
    }

    fn depth(&self) -> f64 {
        0.0
    }

    fn period(&self) -> f64 {
        1e-3
    }
}

fn score() -> Score {
    let notes = (0..200_u32).map(|i| {
        let onset = 0.1 * f64::from(i);
        let (key, velocity) = (i * 37 % 88, 30 + i * 13 % 76);
        let [key, velocity] = [key, velocity].map(|value| u8::try_from(value).unwrap_or(1));
        ScoreNote { key, onset, end: onset + 0.5, velocity, release: None }
    });
    Score {
        notes: notes.collect(),
        pedals: vec![PedalMove { pedal: Pedal::Sustain, at: 0.5, depth: 1.0 }],
        ..Score::default()
    }
}

fn prepare(n_workers: usize) -> Performance {
    let n_workers = NonZero::new(n_workers).unwrap_or(NonZero::<usize>::MIN);
    Pianist { n_workers, ..Pianist::default() }.prepare(&score(), Toy::new, |_| ())
}

#[test]
fn what_is_prepared_is_what_the_score_wants() {
    let performance = prepare(2);
    let promised = assess(&performance.expected, &performance.predicted, &[]);
    assert_eq!((promised.played, promised.missed, promised.extra), (200, 0, 0));
    assert!(promised.onset_error_ms.max <= 0.1, "{promised}");
    assert!(promised.velocity_error.max < 0.5, "{promised}");
    let pedal = PedalMove { pedal: Pedal::Sustain, at: 1.5, depth: 1.0 };
    assert_eq!(performance.pedals, [pedal], "the lead-in holds for pedals too");
    assert_eq!(performance.gestures.len(), 88);
    // The lowest and the highest key: four times and 5.74 times the finger's 0.02 to 8 m/s.
    let (softest, loudest) = performance.range.expect("they strike");
    assert!((softest - 5.74 * 0.02).abs() < 1e-9, "{softest}");
    assert!((28.0..=32.0).contains(&loudest), "{loudest}");
    assert!(performance.expected.is_sorted_by_key(|note| note.onset));
}

#[test]
fn the_gestures_played_in_one_go_are_heard_as_promised() {
    let performance = prepare(2);
    let mut struck = Vec::new();
    for (key, gestures) in (0..).zip(&performance.gestures) {
        assert!(gestures.is_sorted_by_key(|gesture| gesture.start));
        let outcome = Toy::new(key).play(gestures, f64::INFINITY);
        struck.extend(outcome.strikes.iter().map(|strike| Struck {
            key,
            at: strike.at,
            velocity: Pianist::default().curve.velocity(strike.speed).get(),
        }));
    }
    let heard = assess(&performance.expected, &struck, &[]);
    assert_eq!(heard, assess(&performance.expected, &performance.predicted, &[]));
}

#[test]
fn the_number_of_threads_changes_nothing() {
    assert_eq!(prepare(1), prepare(3));
}

#[test]
fn a_performance_is_the_same_bits_after_it_was_bytes() {
    let performance = Performance { repeat: Some(30.0), ..prepare(2) };
    let bytes = performance.to_bytes();
    assert_eq!(Performance::from_bytes(&bytes), Some(performance));
    for end in (0..bytes.len()).step_by(4) {
        assert_eq!(Performance::from_bytes(&bytes[..end]), None, "{end} of {}", bytes.len());
    }
}
