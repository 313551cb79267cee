//! Analyses a recorded stroke by the cross-spectrum of motion and force, and their coherence.
//!
//! Position and force are differenced first, which keeps their ratio and removes constants.
//! Segments of four cycles of the lowest frequency, each half over the next and under a Hann
//! window, are averaged: F/x = S_xf/S_xx, with the coherence γ² = |S_xf|²/(S_xx S_ff). Parts of a
//! stroke with different impedances lower the coherence, as noise does.

use std::f64::consts::TAU;

use figures::digits::rounded;
use nalgebra_of_lm::Complex;

use crate::impedance::curve::{ImpedanceCurve, ImpedancePoint};
use crate::impedance::sampled::ForceHold;

/// Cycles of the lowest frequency in a segment: the resolution of its window.
const CYCLES: f64 = 4.0;
/// Minimum segments: with one all would be coherent.
const SEGMENTS: usize = 4;

/// A key's positions and the forces that were sent for them, tick by tick.
#[derive(Clone, PartialEq, Debug)]
pub struct RecordedStroke {
    pub name: String,
    pub held: ForceHold,
    /// Travel of the key's front (m), down positive.
    pub position: Vec<f64>,
    /// Force on the finger (N), up positive.
    pub force: Vec<f64>,
}

#[derive(Clone, Copy, Default)]
struct Powers {
    motion: f64,
    force: f64,
    cross: Complex<f64>,
}

impl RecordedStroke {
    /// Returns the impedance at `frequencies` (Hz), the lowest first.
    ///
    /// # Errors
    /// If the recording is too short for the lowest or the key does not move, in a sentence.
    pub fn curve(&self, frequencies: &[f64], done: &dyn Fn()) -> Result<ImpedanceCurve, String> {
        let lowest = frequencies.first().copied().unwrap_or(f64::INFINITY);
        let [motion, force] = [&self.position, &self.force].map(|it| differences(it));
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "a length")]
        let length = (CYCLES / (lowest * self.held.period)).ceil() as usize;
        let step = (length / 2).max(1);
        let count = motion.len().checked_sub(length).map_or(0, |rest| rest / step + 1);
        if count < SEGMENTS {
            return Err(self.too_short(motion.len(), lowest));
        }
        if motion.iter().all(|it| *it == 0.0) {
            return Err(format!("{} lies still; choose another --key", self.name));
        }
        let mut points = Vec::new();
        for frequency in frequencies {
            let mut powers = Powers::default();
            for start in (0..count).map(|it| it * step) {
                let parts = [&motion, &force].map(|it| &it[start..start + length]);
                powers.enter(parts, frequency * self.held.period);
            }
            points.extend(self.point(*frequency, &powers, count));
            done();
        }
        let remark = format!("{count} segments of {} s", rounded(length as f64 * self.held.period));
        Ok(ImpedanceCurve { name: self.name.clone(), remark, points })
    }

    fn too_short(&self, ticks: usize, lowest: f64) -> String {
        let lasts = ticks as f64 * self.held.period;
        let needed = 0.5 * (SEGMENTS as f64 + 1.0) * CYCLES;
        let possible = 1.01 * needed / lasts;
        let begin = format!("begin at {} Hz, or ", rounded(possible));
        let begin = if possible < self.held.highest() { begin.as_str() } else { "" };
        let [told, needed] = [lowest, needed / lowest].map(rounded);
        let (name, lasts) = (&self.name, rounded(lasts));
        format!("{name} moves for {lasts} s, and {told} Hz takes {needed} s; {begin}record more")
    }

    fn point(&self, frequency: f64, powers: &Powers, count: usize) -> Option<ImpedancePoint> {
        let Powers { motion, force, cross } = *powers;
        let ratio = cross / motion;
        let coherence = if force > 0.0 { cross.norm_sqr() / (motion * force) } else { 1.0 };
        let z = ratio * self.held.at(frequency) / Complex::new(0.0, TAU * frequency);
        let point = ImpedancePoint::measured(frequency, z, coherence, count as f64);
        point.error.is_finite().then_some(point)
    }
}

impl Powers {
    /// Adds a segment of both, at a frequency in cycles per sample.
    fn enter(&mut self, [motion, force]: [&[f64]; 2], frequency: f64) {
        let (mut x, mut f) = (Complex::new(0.0, 0.0), Complex::new(0.0, 0.0));
        let length = motion.len() as f64;
        for (place, (motion, force)) in motion.iter().zip(force).enumerate() {
            let hann = 0.5 - 0.5 * (TAU * (place as f64 + 0.5) / length).cos();
            let turn = Complex::from_polar(hann, -TAU * frequency * place as f64);
            x += turn * *motion;
            f += turn * *force;
        }
        self.motion += x.norm_sqr();
        self.force += f.norm_sqr();
        self.cross += x.conj() * f;
    }
}

fn differences(values: &[f64]) -> Vec<f64> {
    values.windows(2).map(|it| it[1] - it[0]).collect()
}
