//! Shakes a rendered voice by a small sinusoid, with its force held and late.
//!
//! At each frequency a new voice is moved slowly to the depth, and then shaken. Least squares of a
//! constant, a sine and a cosine give the fundamental of its forces at the ticks. The finger feels
//! each force from its delay on, for a period: the fundamental of that is
//! sinc(ωT/2) exp(−jω(T/2 + delay)) of it. Images above half the rate are ignored.

use std::f64::consts::{PI, TAU};

use crate::stability::{LoopQuantity, LoopValues, TrialAnswer, TrialVoice, VoiceMaker, VoiceOrder};
use figures::parallel::in_parallel;
use nalgebra_of_lm::{Complex, Matrix3, Vector3};

use crate::impedance::curve::{ImpedanceCurve, ImpedancePoint};

/// Highest frequency over the rate: at the half a sinusoid may be sampled at its zeros only.
const HIGHEST: f64 = 0.45;

/// Time for the way down, and for the rest there (s).
pub(crate) const APPROACH: f64 = 0.5;
const REST: f64 = 2.0;
/// Minimum time (s) and cycles of settling, and then of measuring.
const STEADY: (f64, f64) = (0.5, 4.0);
const MEASURED: (f64, f64) = (1.0, 8.0);

/// Largest acceleration of the key (m/s²), so that nothing on it is thrown.
const GENTLE: f64 = 0.5;

/// Timing of a force between its sample and the finger.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct ForceHold {
    /// Period of the loop, for which it is held (s).
    pub period: f64,
    /// Time between its sample and its effect (s).
    pub delay: f64,
}

impl ForceHold {
    pub const fn of(values: &LoopValues) -> Self {
        let (period, delay) = (LoopQuantity::Period, LoopQuantity::Delay);
        Self { period: values.get(period), delay: values.get(delay) }
    }

    /// Returns the felt force at `frequency` (Hz), over that of the voice.
    pub fn at(&self, frequency: f64) -> Complex<f64> {
        let half = PI * frequency * self.period;
        let sinc = if half == 0.0 { 1.0 } else { half.sin() / half };
        Complex::from_polar(sinc, -half - TAU * frequency * self.delay)
    }

    /// Returns the highest measured frequency (Hz).
    pub fn highest(&self) -> f64 {
        HIGHEST / self.period
    }
}

/// A voice that is shaken.
#[derive(Clone, Copy)]
pub struct ShakenVoice<'a> {
    pub maker: VoiceMaker<'a>,
    /// Order of the voices, with its own period and delay.
    pub order: VoiceOrder<'a>,
    /// Travel of the key's front (m).
    pub depth: f64,
    /// Largest amplitude (m).
    pub amplitude: f64,
}

impl std::fmt::Debug for ShakenVoice<'_> {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("ShakenVoice").field("order", &self.order).finish_non_exhaustive()
    }
}

impl ShakenVoice<'_> {
    /// Returns the impedance at `frequencies` (Hz); calls `done` after each.
    ///
    /// # Errors
    /// If a voice cannot be made or fails, in a sentence.
    pub fn curve(
        &self,
        frequencies: &[f64],
        done: &(dyn Fn() + Sync),
    ) -> Result<ImpedanceCurve, String> {
        let points = in_parallel(frequencies, &|frequency| {
            let point = self.at(*frequency);
            done();
            point
        });
        let points = points.into_iter().collect::<Result<Vec<_>, _>>()?;
        let name = format!("voice, {}", self.order.estimator.name());
        let ForceHold { period, delay } = ForceHold::of(self.order.values);
        let [period, delay] = [period, delay].map(|it| 1e3 * it);
        let remark = format!("force held for {period} ms, {delay} ms late");
        Ok(ImpedanceCurve { name, remark, points })
    }

    /// Measures the impedance at one frequency (Hz).
    fn at(&self, frequency: f64) -> Result<ImpedancePoint, String> {
        let held = ForceHold::of(self.order.values);
        let omega = TAU * frequency;
        let amplitude = self.amplitude.min(GENTLE / (omega * omega));
        let mut voice = (self.maker)(&self.order)?;
        let ticks = |time: f64| (time / held.period).ceil();
        let long = |(time, cycles): (f64, f64)| ticks(time.max(cycles / frequency)).max(64.0);
        let (down, still) = (ticks(APPROACH), ticks(APPROACH) + ticks(REST));
        let (steady, end) = (long(STEADY), long(STEADY) + long(MEASURED));
        let mut wave = Fundamental::default();
        let mut tick = 0;
        while (tick as f64) < still + end {
            let since = tick as f64 - still;
            let (sin, cos) = (omega * held.period * since).sin_cos();
            let shaken = amplitude * smooth(since / (0.5 * steady));
            let position = self.depth * smooth(tick as f64 / down) + shaken * sin;
            let force = answer(voice.as_mut(), tick, position)
                .map_err(|what| format!("at {frequency} Hz the voice {what}"))?;
            if since >= steady {
                wave.enter(sin, cos, force);
            }
            tick += 1;
        }
        let (gain, coherence) =
            wave.gain().ok_or_else(|| format!("no sinusoid fits the forces at {frequency} Hz"))?;
        let cycles = long(MEASURED) * held.period * frequency;
        let z = gain / amplitude * held.at(frequency) / Complex::new(0.0, omega);
        Ok(ImpedancePoint::measured(frequency, z, coherence, cycles))
    }
}

fn answer(voice: &mut dyn TrialVoice, tick: u64, position: f64) -> Result<f64, &'static str> {
    match voice.answer(tick, position) {
        TrialAnswer::Force(force) => Ok(force),
        TrialAnswer::Muted => Err("was muted because it makes energy; try a smaller --amplitude"),
        TrialAnswer::Failed => Err("cannot be followed; try another --depth or a shorter --period"),
    }
}

pub(crate) fn smooth(x: f64) -> f64 {
    let x = x.clamp(0.0, 1.0);
    x * x * (3.0 - 2.0 * x)
}

#[derive(Default)]
struct Fundamental {
    matrix: Matrix3<f64>,
    moments: Vector3<f64>,
    /// First force (N), the zero of the others, and the sum of their squares (N²).
    first: Option<f64>,
    squares: f64,
}

impl Fundamental {
    fn enter(&mut self, sin: f64, cos: f64, force: f64) {
        let force = force - *self.first.get_or_insert(force);
        let row = Vector3::new(1.0, sin, cos);
        self.matrix += row * row.transpose();
        self.moments += force * row;
        self.squares += force * force;
    }

    /// Returns the force's phasor over that of the sine (N), and the share of its power that fits.
    fn gain(&self) -> Option<(Complex<f64>, f64)> {
        let fit = self.matrix.cholesky()?.solve(&self.moments);
        let count = self.matrix[(0, 0)];
        let mean = self.moments[0] / count;
        let power = self.squares - count * mean * mean;
        let rest = self.squares - fit.dot(&self.moments);
        // A constant force is explained, too.
        let share = if power > f64::MIN_POSITIVE { 1.0 - rest / power } else { 1.0 };
        Some((Complex::new(fit[1], fit[2]), share.clamp(0.0, 1.0)))
    }
}
