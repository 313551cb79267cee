//! The virtual pianist: a score, rehearsed key by key.

use std::num::NonZero;
use std::panic::resume_unwind;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::thread;

use haptics::plant::Gesture;
use keyboard::KEYS;
use midi::{PedalMove, VelocityCurve};

use crate::assess::{ExpectedNote, Struck};
use crate::rehearse::{Practice, Rehearsal, RehearsedStroke, Shortfall, StrokeTables};
use crate::score::Score;
use crate::stroke::{PlannedStroke, Technique, plan};

/// Finds the gestures by which simulated fingers play a score.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Pianist {
    /// What a hammer speed is worth.
    pub curve: VelocityCurve,
    /// How the pianist plays.
    pub technique: Technique,
    /// Keys that are rehearsed at a time; the result does not depend on it.
    pub n_workers: NonZero<usize>,
}

impl Default for Pianist {
    fn default() -> Self {
        Self {
            curve: VelocityCurve::default(),
            technique: Technique::default(),
            n_workers: thread::available_parallelism().unwrap_or(NonZero::<usize>::MIN),
        }
    }
}

/// How far a preparation has come.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Progress {
    pub done: usize,
    /// Strokes of the score.
    pub total: usize,
}

/// What the fingers do, and what should be heard of it.
#[derive(Clone, PartialEq, Debug, Default)]
pub struct Performance {
    /// For each of the 88 keys its gestures, in order of start.
    pub gestures: Vec<Vec<Gesture>>,
    /// What the score wants, in order of onset, then of key.
    pub expected: Vec<ExpectedNote>,
    /// What the rehearsal promises: compare with [`assess`](crate::assess()).
    pub predicted: Vec<Struck>,
    /// What cannot be played as it is written, in order of onset, then of key.
    pub shortfalls: Vec<ShortStroke>,
    /// Softest and loudest speed of the hammer at the string that every key which is played gives
    /// from rest (m/s), if each of them strikes.
    pub range: Option<(f64, f64)>,
    /// Moves of the pedals, in order of time.
    pub pedals: Vec<PedalMove>,
    /// The time after which all of it begins again (s), later than its end; once if there is none.
    pub repeat: Option<f64>,
}

/// A note that is not played as it is written.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct ShortStroke {
    /// Which key, 0 ..= 87.
    pub key: u8,
    /// When it should be heard (s since the start of the performance).
    pub onset: f64,
    pub why: Shortfall,
}

impl Performance {
    /// When the last finger has left its key or the pedal is moved last (s).
    pub fn end(&self) -> f64 {
        let ends = self.gestures.iter().flatten().map(Gesture::end);
        ends.chain(self.pedals.iter().map(|pedal| pedal.at)).fold(0.0, f64::max)
    }
}

impl Pianist {
    /// Finds out how to play `score`.
    ///
    /// `instrument` makes a key (0 ..= 87), at rest at time 0; it is called by several threads.
    /// `progress` is called after every stroke, by whichever thread rehearsed it.
    pub fn prepare<R: Rehearsal>(
        &self,
        score: &Score,
        instrument: impl Fn(u8) -> R + Sync,
        progress: impl Fn(Progress) + Sync,
    ) -> Performance {
        let keys = plan(score, self.curve, &self.technique);
        let total = keys.iter().map(Vec::len).sum();
        let done = AtomicUsize::new(0);
        let step = || {
            let done = done.fetch_add(1, Ordering::Relaxed) + 1;
            progress(Progress { done, total });
        };
        let rehearsed = self.share_out(&keys, |strokes| {
            strokes.first().map(|first| self.rehearse(instrument(first.key), strokes, step))
        });
        let range = range(&rehearsed);
        let strokes: Vec<_> =
            rehearsed.into_iter().map(|key| key.map_or_else(Vec::new, |key| key.strokes)).collect();
        Performance { range, ..self.put_together(score, &keys, &strokes) }
    }

    fn rehearse<R: Rehearsal>(
        &self,
        instrument: R,
        strokes: &[PlannedStroke],
        progress: impl FnMut(),
    ) -> KeyFindings {
        let tables = StrokeTables::measure(&instrument, &self.technique);
        let practice = Practice { tables: &tables, curve: self.curve, technique: &self.technique };
        let strokes = practice.rehearse(instrument, strokes, progress);
        KeyFindings { strokes, range: tables.range() }
    }

    /// Lets the workers take key after key, the busiest first; results in order of keys.
    fn share_out<T: Send + Default>(
        &self,
        keys: &[Vec<PlannedStroke>],
        work: impl Fn(&[PlannedStroke]) -> T + Sync,
    ) -> Vec<T> {
        let mut order: Vec<usize> = (0..keys.len()).collect();
        order.sort_by_key(|key| usize::MAX - keys[*key].len());
        let taken = AtomicUsize::new(0);
        let take = || order.get(taken.fetch_add(1, Ordering::Relaxed)).copied();
        let worker = || {
            let mine = std::iter::from_fn(take).map(|key| (key, work(&keys[key])));
            mine.collect::<Vec<_>>()
        };
        let mut results: Vec<T> = keys.iter().map(|_| T::default()).collect();
        for (key, result) in run(self.n_workers.get(), &worker) {
            results[key] = result;
        }
        results
    }

    fn put_together(
        &self,
        score: &Score,
        keys: &[Vec<PlannedStroke>],
        rehearsed: &[Vec<RehearsedStroke>],
    ) -> Performance {
        let mut expected: Vec<_> = keys.iter().flatten().map(wanted).collect();
        expected.sort_by(|a, b| a.onset.total_cmp(&b.onset).then(a.key.cmp(&b.key)));
        let mut gestures: Vec<Vec<_>> = rehearsed
            .iter()
            .map(|strokes| strokes.iter().filter_map(|stroke| stroke.gesture).collect())
            .collect();
        gestures.resize(KEYS, Vec::new());
        let lead_in = self.technique.lead_in;
        let mut shortfalls: Vec<_> = rehearsed.iter().flatten().filter_map(short).collect();
        shortfalls.sort_by(|a, b| a.onset.total_cmp(&b.onset).then(a.key.cmp(&b.key)));
        Performance {
            shortfalls,
            gestures,
            expected,
            range: None,
            repeat: None,
            predicted: rehearsed.iter().flatten().filter_map(|s| self.predict(s)).collect(),
            pedals: score
                .pedals
                .iter()
                .map(|pedal| PedalMove { at: pedal.at + lead_in, ..*pedal })
                .collect(),
        }
    }

    fn predict(&self, stroke: &RehearsedStroke) -> Option<Struck> {
        let strike = stroke.strike?;
        let velocity = self.curve.velocity(strike.speed).get();
        Some(Struck { key: stroke.wanted.key, at: strike.at, velocity })
    }
}

/// What was found out about one key.
struct KeyFindings {
    strokes: Vec<RehearsedStroke>,
    /// Softest and loudest hammer speed that it gives (m/s).
    range: Option<(f64, f64)>,
}

/// The hammer speeds that all of `keys` give (m/s).
fn range(keys: &[Option<KeyFindings>]) -> Option<(f64, f64)> {
    let ranges = keys.iter().flatten().map(|key| key.range);
    let common = ranges.reduce(|one, other| {
        let (one, other) = (one?, other?);
        Some((one.0.max(other.0), one.1.min(other.1)))
    });
    common.flatten()
}

fn short(stroke: &RehearsedStroke) -> Option<ShortStroke> {
    let PlannedStroke { key, onset, .. } = stroke.wanted;
    stroke.shortfall.map(|why| ShortStroke { key, onset, why })
}

fn wanted(stroke: &PlannedStroke) -> ExpectedNote {
    let &PlannedStroke { key, onset, speed, velocity, .. } = stroke;
    ExpectedNote { key, onset, speed, velocity: velocity.get() }
}

/// Runs `worker` on `n_workers` threads and returns all that they made.
fn run<T: Send>(n_workers: usize, worker: &(impl Fn() -> Vec<T> + Sync)) -> Vec<T> {
    thread::scope(|scope| {
        let workers: Vec<_> = (0..n_workers).map(|_| scope.spawn(worker)).collect();
        let joined = workers
            .into_iter()
            .flat_map(|worker| worker.join().unwrap_or_else(|panic| resume_unwind(panic)));
        joined.collect()
    })
}
