use instruments::LoadedModel;

use super::data::MeasuredStroke;
use super::smooth::{EXACT, noise, smoothed};
use crate::random::SeededRandom;
use cli::simulate::{InputTable, Reconstruct};
use figures::action::Opener;

/// Longest tick (s).
const TICK: f64 = 1e-3;
/// Longest lead-in of a stroke (s).
const LEAD: f64 = 0.3;
const LEAD_POINTS: u32 = 16;
/// Least assumed noise of a force (N): the resolution of a good cell.
const LEAST_NOISE: f64 = 1e-3;

/// A stroke that drives a key, with the forces to compare.
#[derive(Clone, Debug)]
pub(super) struct DrivenStroke {
    /// Time (s) and travel (m) of each row, without noise.
    samples: Vec<(f64, f64)>,
    /// Noise of the travel (m); zero for a static curve.
    travel_noise: f64,
    track: InputTable,
    /// Times of the compared forces (s).
    times: Vec<f64>,
    /// Measured forces (N).
    forces: Vec<f64>,
    /// Standard deviation of each (N).
    pub(super) noises: Vec<f64>,
}

impl DrivenStroke {
    /// Prepares `stroke`, and estimates the noise of its force (N) if none is stated. Noise in the
    /// travel becomes noise in the force where the force is steep (Orear 1982).
    pub(super) fn new(stroke: &MeasuredStroke, force_noise: Option<f64>) -> Self {
        let rows = &stroke.rows;
        let travels: Vec<_> = rows.iter().map(|row| row.travel).collect();
        let forces: Vec<_> = rows.iter().map(|row| row.force).collect();
        let of_force = force_noise.unwrap_or_else(|| noise(&forces)).max(LEAST_NOISE);
        // Rows of a static curve have arbitrary spacing, so their spread is no noise.
        let of_travel = if stroke.is_static { 0.0 } else { noise(&travels) };
        let slope = |at: usize| {
            let (a, b) = (at.saturating_sub(2), (at + 2).min(rows.len() - 1));
            let way = (travels[b] - travels[a]).abs().max(4.0 * of_travel);
            if way > 0.0 { (forces[b] - forces[a]).abs() / way } else { 0.0 }
        };
        let noises = (0..rows.len()).map(|at| of_force.hypot(slope(at) * of_travel)).collect();
        let mut samples: Vec<_> = rows.iter().map(|row| (row.t, row.travel)).collect();
        // A cubic overshoots where a static curve turns.
        let mut how = Reconstruct::Linear;
        if !stroke.is_static {
            (samples, how) = (smoothed(&samples), Reconstruct::Spline);
        }
        let (track, times) = track(&samples, how);
        Self { samples, travel_noise: of_travel, track, times, forces, noises }
    }

    pub(super) fn is_noisy(&self) -> bool {
        self.travel_noise >= EXACT
    }

    pub(super) fn shaken(&self, random: &mut SeededRandom) -> Self {
        if !self.is_noisy() {
            return self.clone();
        }
        let mut noisy = |travel: f64| travel + self.travel_noise * random.gaussian();
        let samples = self.samples.iter().map(|(t, travel)| (*t, noisy(*travel)));
        let samples = smoothed(&samples.collect::<Vec<_>>());
        let (track, times) = track(&samples, Reconstruct::Spline);
        Self { samples, track, times, ..self.clone() }
    }

    /// Returns the force at each row (N) of a key with these `values`; `None` if the model fails.
    pub(super) fn follow(&self, model: &LoadedModel, values: &[f64]) -> Option<Vec<f64>> {
        let mut key = model.visit(Opener { values });
        let mut t = 0.0;
        let found = self.times.iter().map(|end| {
            // Equal ticks to the row, none longer than TICK.
            let ticks = ((end - t) / TICK).ceil();
            let h = (end - t) / ticks.max(1.0);
            while end - t > 0.5 * h {
                key.advance(h, &|theta| self.track.at(t + theta * h)).then_some(())?;
                t += h;
            }
            Some(key.sample().force).filter(|force| force.is_finite())
        });
        found.collect()
    }

    pub(super) fn differences(&self, found: &[f64]) -> Vec<f64> {
        let rows = found.iter().zip(&self.forces).zip(&self.noises);
        rows.map(|((found, measured), noise)| (found - measured) / noise).collect()
    }

    pub(super) const fn rows(&self) -> usize {
        self.times.len()
    }
}

/// Returns the key's path through `samples` (s, m) from rest, and their times on it (s).
fn track(samples: &[(f64, f64)], how: Reconstruct) -> (InputTable, Vec<f64>) {
    let mut all = lead_in(samples);
    let lead = all.len();
    all.extend_from_slice(samples);
    let start = all[0].0;
    for sample in &mut all {
        sample.0 -= start;
    }
    let times = all[lead..].iter().map(|it| it.0).collect();
    (InputTable::through(&all, how), times)
}

/// Returns the path from rest to the first of `samples` (s, m) and their speed there, if they move:
/// a cubic without reversal, as a speed above three times the mean would reverse.
fn lead_in(samples: &[(f64, f64)]) -> Vec<(f64, f64)> {
    let (start, travel) = samples[0];
    let (later, further) = samples[(samples.len() - 1).min(3)];
    let speed = (further - travel) / (later - start);
    let lead = LEAD.min(3.0 * (travel / speed).abs());
    if travel.abs() < 1e-9 || lead.is_nan() || lead < 1e-6 {
        return Vec::new();
    }
    let point = |part: u32| {
        let x = f64::from(part) / f64::from(LEAD_POINTS);
        let place = travel * x * x * (3.0 - 2.0 * x) + speed * lead * x * x * (x - 1.0);
        (start - lead * (1.0 - x), place)
    };
    (0..LEAD_POINTS).map(point).collect()
}
