//! All strokes of a fit, run for any values.

use instruments::LoadedModel;
use mechanism::unmet;
use nalgebra_of_lm::DVector;

use super::{data::MeasuredStroke, driven::DrivenStroke};
use crate::random::SeededRandom;
use figures::parallel::in_parallel;

/// An instrument's key, with its measured strokes.
#[derive(Clone, Copy, Debug)]
pub struct FitSubject<'a> {
    pub name: &'a str,
    pub model: &'a LoadedModel,
    pub values: &'a [f64],
    pub fitted: &'a [usize],
    pub strokes: &'a [MeasuredStroke],
    /// Standard deviation of the measured forces (N); estimated if `None`.
    pub force_noise: Option<f64>,
}

/// Draws of the travel's noise: they give its share of an interval to 20 %.
const SHAKEN: u64 = 12;

pub(super) struct FitTask<'a> {
    pub(super) model: &'a LoadedModel,
    pub(super) strokes: Vec<DrivenStroke>,
    progress: &'a (dyn Fn() + Sync),
}

/// Differences of all rows from the measured forces, each over its noise.
pub(super) type Differences = DVector<f64>;

impl<'a> FitTask<'a> {
    pub(super) fn new(subject: &FitSubject<'a>, progress: &'a (dyn Fn() + Sync)) -> Self {
        let strokes = subject.strokes.iter();
        let strokes = strokes.map(|it| DrivenStroke::new(it, subject.force_noise)).collect();
        Self { model: subject.model, strokes, progress }
    }

    pub(super) fn range(&self, place: usize) -> (f64, f64) {
        self.model.parameters[place].range
    }

    pub(super) fn rows(&self) -> usize {
        self.strokes.iter().map(DrivenStroke::rows).sum()
    }

    /// Returns the forces of each stroke (N) for each set of values; `None` where the model fails.
    pub(super) fn forces(&self, sets: &[Vec<f64>]) -> Vec<Option<Vec<Vec<f64>>>> {
        let count = self.strokes.len();
        let jobs: Vec<_> =
            sets.iter().flat_map(|set| self.strokes.iter().map(move |it| (set, it))).collect();
        let done = in_parallel(&jobs, &|(values, stroke)| {
            let is_allowed = unmet(self.model, values).is_empty();
            let found = is_allowed.then(|| stroke.follow(self.model, values)).flatten();
            (self.progress)();
            found
        });
        done.chunks(count.max(1)).map(|it| it.iter().cloned().collect()).collect()
    }

    pub(super) fn differences(&self, sets: &[Vec<f64>]) -> Vec<Option<Differences>> {
        let all = |found: Vec<Vec<f64>>| {
            let strokes = self.strokes.iter().zip(&found);
            let rows = strokes.flat_map(|(stroke, forces)| stroke.differences(forces));
            DVector::from_vec(rows.collect())
        };
        self.forces(sets).into_iter().map(|found| found.map(all)).collect()
    }

    /// Returns changes of the differences with `values` under other draws of the travel's noise.
    pub(super) fn shaken(&self, values: &[f64], now: &Differences) -> Vec<Differences> {
        if !self.strokes.iter().any(DrivenStroke::is_noisy) {
            return Vec::new();
        }
        let shaken = |seed: u64| {
            let mut random = SeededRandom::new(seed, 0);
            let strokes = self.strokes.iter().map(|it| it.shaken(&mut random)).collect();
            Self { model: self.model, strokes, progress: self.progress }
        };
        let tasks: Vec<_> = (0..SHAKEN).map(shaken).collect();
        let found = in_parallel(&tasks, &|task| task.differences_of(values));
        found.into_iter().flatten().map(|it| it - now).collect()
    }

    pub(super) fn differences_of(&self, values: &[f64]) -> Option<Differences> {
        self.differences(&[values.to_vec()]).pop().flatten()
    }
}
