//! An impedance over frequency, and where it is not passive.

use std::fmt;

use figures::digits::rounded;
use nalgebra_of_lm::Complex;
use serde::Serialize;

/// Negative share of |Z| in Re Z that is significant: linearisation leaves a millionth.
const CERTAIN: f64 = 1e-4;

/// Significant standard errors of Re Z, and the coherence below which the error is unknown.
const ERRORS: f64 = 3.0;
const COHERENT: f64 = 0.5;

/// Returns `count` frequencies (Hz) from `low` to `high`, evenly spaced in their logarithms.
pub fn frequencies((low, high): (f64, f64), count: usize) -> Vec<f64> {
    let last = count.max(2) - 1;
    (0..=last).map(|it| low * (high / low).powf(it as f64 / last as f64)).collect()
}

/// Impedance at one frequency.
#[derive(Clone, Copy, PartialEq, Debug, Serialize)]
pub struct ImpedancePoint {
    /// Frequency (Hz).
    pub frequency: f64,
    /// Real and imaginary part (N s/m).
    pub real: f64,
    pub imaginary: f64,
    pub coherence: f64,
    /// Standard error of each part (N s/m).
    pub error: f64,
}

impl ImpedancePoint {
    /// Returns the point of `z` (N s/m) at `frequency` (Hz), without an error.
    pub const fn exact(frequency: f64, z: Complex<f64>) -> Self {
        Self { frequency, real: z.re, imaginary: z.im, coherence: 1.0, error: 0.0 }
    }

    /// Returns the point as the mean of `count` measurements with that coherence: its error is
    /// |Z| √((1 − γ²)/(2 γ² n)) (Bendat & Piersol).
    pub fn measured(frequency: f64, z: Complex<f64>, coherence: f64, count: f64) -> Self {
        let share = (1.0 - coherence).max(0.0) / (2.0 * coherence * count);
        let error = z.norm() * share.sqrt();
        Self { coherence, error, ..Self::exact(frequency, z) }
    }

    /// Returns |Z| (N s/m).
    pub fn magnitude(&self) -> f64 {
        self.real.hypot(self.imaginary)
    }

    /// Returns the lead of the force over the velocity (°), −180 to 180.
    pub fn phase(&self) -> f64 {
        self.imaginary.atan2(self.real).to_degrees()
    }

    pub fn is_active(&self) -> bool {
        let doubt = CERTAIN * self.magnitude() + ERRORS * self.error;
        COHERENT <= self.coherence && self.real < -doubt
    }
}

/// An impedance over frequency.
#[derive(Clone, PartialEq, Debug, Serialize)]
pub struct ImpedanceCurve {
    pub name: String,
    pub remark: String,
    pub points: Vec<ImpedancePoint>,
}

/// Band of frequencies in which Re Z is below zero.
#[derive(Clone, Copy, PartialEq, Debug, Serialize)]
pub struct ActiveBand {
    /// Ends (Hz); Re Z is linear between two points.
    pub from: f64,
    pub to: f64,
    /// Lowest Re Z (N s/m), and its frequency (Hz).
    pub lowest: f64,
    pub at: f64,
}

impl fmt::Display for ActiveBand {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let [from, to, lowest, at] = [self.from, self.to, self.lowest, self.at].map(rounded);
        if from == to {
            return write!(f, "at {at} Hz ({lowest} N·s/m)");
        }
        write!(f, "from {from} to {to} Hz (lowest {lowest} N·s/m at {at} Hz)")
    }
}

impl ImpedanceCurve {
    /// Returns the bands that are not passive, from the lowest.
    pub fn active_bands(&self) -> Vec<ActiveBand> {
        let mut bands: Vec<ActiveBand> = Vec::new();
        let mut before: Option<&ImpedancePoint> = None;
        for point in &self.points {
            let was = before.is_some_and(ImpedancePoint::is_active);
            match (was, point.is_active(), bands.last_mut()) {
                (true, true, Some(band)) => band.reach(point),
                (true, false, Some(band)) => band.to = crossing(before, point),
                (_, true, _) => bands.push(ActiveBand {
                    from: crossing(before, point),
                    to: point.frequency,
                    lowest: point.real,
                    at: point.frequency,
                }),
                _ => {}
            }
            before = Some(point);
        }
        bands
    }

    pub fn verdict(&self) -> String {
        let bands = self.active_bands();
        if bands.is_empty() {
            return format!("{}: Re Z is nowhere below zero, it is passive", self.name);
        }
        let bands: Vec<_> = bands.iter().map(ToString::to_string).collect();
        format!(
            "{}: Re Z is below zero {}; there it is not passive, and can shake a finger",
            self.name,
            bands.join(", and ")
        )
    }
}

impl ActiveBand {
    fn reach(&mut self, point: &ImpedancePoint) {
        self.to = point.frequency;
        if point.real < self.lowest {
            (self.lowest, self.at) = (point.real, point.frequency);
        }
    }
}

/// Returns the zero of Re Z between two points, or the second if one is missing or unknown.
fn crossing(before: Option<&ImpedancePoint>, after: &ImpedancePoint) -> f64 {
    match before {
        Some(before) if before.real * after.real < 0.0 => {
            let part = before.real / (before.real - after.real);
            before.frequency + part * (after.frequency - before.frequency)
        }
        Some(before) if before.is_active() => before.frequency,
        _ => after.frequency,
    }
}
