//! The virtual pianist: a score, rehearsed key by key.

use std::num::NonZero;
use std::panic::resume_unwind;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::thread;

use haptics::plant::Gesture;
use keyboard::KEYS;
use midi::{PedalMove, Velocity, VelocityCurve};

use crate::assess::{ExpectedNote, Struck};
use crate::rehearse::{
    LIFTS, Practice, QUICK_LIFT, Rehearsal, RehearsedStroke, Shortfall, StrokeTables,
};
use crate::score::Score;
use crate::stroke::{PlannedStroke, Technique, plan};

/// Finds the gestures with which simulated fingers play a score.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Pianist {
    pub curve: VelocityCurve,
    pub technique: Technique,
    /// Keys rehearsed at a time; the result does not depend on it.
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

/// Progress of a preparation.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Progress {
    pub done: usize,
    pub total: usize,
}

/// Motions of the fingers, and the notes that should sound.
#[derive(Clone, PartialEq, Debug, Default)]
pub struct Performance {
    /// Gestures of each of the 88 keys, in order of start.
    pub gestures: Vec<Vec<Gesture>>,
    /// Notes of the score, in order of onset, then of key.
    pub expected: Vec<ExpectedNote>,
    /// Strikes that the rehearsal predicts: compare with [`assess`](crate::assess()).
    pub predicted: Vec<Struck>,
    /// Notes that cannot be played as written, in order of onset, then of key.
    pub shortfalls: Vec<ShortStroke>,
    /// Notes that end early for the next stroke on their key, in order of onset, then of key.
    pub cuts: Vec<CutNote>,
    /// Softest and loudest hammer speed (m/s) of every played key from rest, if each strikes.
    pub range: Option<(f64, f64)>,
    pub pedals: Vec<PedalMove>,
    /// Time after which the performance repeats (s), later than its end; `None` if it does not.
    pub repeat: Option<f64>,
}

/// A note on key 0 ..= 87 that is not played as written.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct ShortStroke {
    pub key: u8,
    /// Wanted time (s since the start of the performance).
    pub onset: f64,
    pub why: Shortfall,
}

/// A note that ends early so that its key, 0 ..= 87, can be struck again.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct CutNote {
    pub key: u8,
    /// Wanted time of the note (s since the start of the performance).
    pub onset: f64,
    /// Lost time (s).
    pub by: f64,
    /// Wanted time of the next stroke (s).
    pub next: f64,
}

impl Performance {
    /// Returns the time when the last finger leaves its key or the last pedal moves (s).
    pub fn end(&self) -> f64 {
        let ends = self.gestures.iter().flatten().map(Gesture::end);
        ends.chain(self.pedals.iter().map(|pedal| pedal.at)).fold(0.0, f64::max)
    }
}

impl Pianist {
    /// Prepares `score`. Several threads call `instrument`, which makes a key (0 ..= 87) at rest at
    /// time 0; the thread that rehearsed a stroke calls `progress` after it.
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
        let has_releases = strokes.iter().any(|stroke| stroke.release.is_some());
        let lifts = if has_releases { &LIFTS[..] } else { &[Gesture::LIFT, QUICK_LIFT] };
        let tables = StrokeTables::measure(&instrument, &self.technique, lifts);
        let range = tables.range();
        let practice = Practice { tables, curve: self.curve, technique: &self.technique };
        KeyFindings { strokes: practice.rehearse(instrument, strokes, progress), range }
    }

    /// Gives the workers key after key, the busiest first; returns results in order of keys.
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
        let mut cuts: Vec<_> = rehearsed.iter().flat_map(|strokes| cuts(strokes)).collect();
        cuts.sort_by(|a, b| a.onset.total_cmp(&b.onset).then(a.key.cmp(&b.key)));
        Performance {
            shortfalls,
            cuts,
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

struct KeyFindings {
    strokes: Vec<RehearsedStroke>,
    /// Softest and loudest hammer speed (m/s).
    range: Option<(f64, f64)>,
}

/// Returns the hammer speeds that all of `keys` reach (m/s).
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

/// Returns the cut notes among one key's strokes.
fn cuts(strokes: &[RehearsedStroke]) -> impl Iterator<Item = CutNote> {
    let is_played = |stroke: &&RehearsedStroke| stroke.gesture.is_some();
    let played = strokes.iter().filter(is_played);
    played.clone().zip(played.skip(1)).filter_map(|(stroke, next)| {
        let PlannedStroke { key, onset, .. } = stroke.wanted;
        (0.0 < stroke.cut).then_some(CutNote {
            key,
            onset,
            by: stroke.cut,
            next: next.wanted.onset,
        })
    })
}

fn wanted(stroke: &PlannedStroke) -> ExpectedNote {
    let &PlannedStroke { key, onset, end, speed, velocity, release, .. } = stroke;
    let release = release.map(Velocity::get);
    ExpectedNote { key, onset, speed, velocity: velocity.get(), end, release }
}

fn run<T: Send>(n_workers: usize, worker: &(impl Fn() -> Vec<T> + Sync)) -> Vec<T> {
    thread::scope(|scope| {
        let workers: Vec<_> = (0..n_workers).map(|_| scope.spawn(worker)).collect();
        let joined = workers
            .into_iter()
            .flat_map(|worker| worker.join().unwrap_or_else(|panic| resume_unwind(panic)));
        joined.collect()
    })
}
