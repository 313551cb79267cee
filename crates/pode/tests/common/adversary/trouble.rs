//! Guards made to be difficult.

use std::cell::Cell;

use pode::{GuardValue, Motion};

use super::bytes::Bytes;
use super::{Calls, STATE};

/// A guard, as a function of the time x₀, the count x₁, the height x₂ and its rate x₃.
#[derive(Clone, Copy, Debug)]
pub enum Trouble {
    /// A line that falls through zero at this time (s).
    Falls(f64),
    Floor,
    /// Jumps between −1 and 1 at this frequency (1/s).
    Chatters(f64),
    Constant(f64, f64),
    Jumps(f64),
    /// NaN from the first time, for the second (s).
    NotANumber(f64, f64),
    NoRate(f64),
    Waves(f64),
    /// Close pairs of roots: 1 + cos ωt − δ.
    Dips(f64, f64),
    /// Flat roots: −(t − t0)⁹, with rate zero.
    Flat(f64),
    Steep(f64),
    Counts(f64),
    Huge(f64),
    /// The input, up to this threshold.
    Follows(f64),
    /// No function: another answer each time.
    Fickle(u64),
    /// No function: prolongs each search for its root as far as possible.
    Malice,
}

impl Trouble {
    pub fn from_bytes(bytes: &mut Bytes<'_>) -> Self {
        let time = |bytes: &mut Bytes<'_>| bytes.sized(1e-5, 0.05);
        let rate = |bytes: &mut Bytes<'_>| bytes.sized(1.0, 1e7);
        match bytes.byte() % 21 {
            0..=2 => Self::Falls(time(bytes)),
            3..=5 => Self::Floor,
            6 => Self::Chatters(rate(bytes)),
            7 => Self::Constant(0.0, 0.0),
            8 => Self::Constant(
                bytes.odd(|it| it.signed(1e-18, 1e3)),
                bytes.odd(|it| it.signed(1.0, 1e9)),
            ),
            9 => Self::Jumps(time(bytes)),
            10 => Self::NotANumber(time(bytes), time(bytes)),
            11 => Self::NoRate(time(bytes)),
            12 => Self::Waves(rate(bytes)),
            13 => Self::Dips(rate(bytes), bytes.signed(1e-16, 1.0)),
            14 => Self::Flat(time(bytes)),
            15 => Self::Steep(time(bytes)),
            16 => Self::Counts(rate(bytes)),
            17 => Self::Huge(time(bytes)),
            18 => Self::Follows(bytes.signed(1e-3, 1.0)),
            19 => Self::Fickle(bytes.word()),
            _ => Self::Malice,
        }
    }

    pub fn value(self, x: &[f64; STATE], input: &Motion, calls: &Calls) -> GuardValue {
        let [t, n, z, w] = *x;
        let (value, rate) = match self {
            Self::Falls(t0) => (t0 - t, -1.0),
            Self::Floor => (z, w),
            Self::Chatters(f) => (if (t * f).fract() < 0.5 { 1.0 } else { -1.0 }, 0.0),
            Self::Constant(value, rate) => (value, rate),
            Self::Jumps(t0) => (if t < t0 { 1.0 } else { -1.0 }, 0.0),
            Self::NotANumber(t0, long) => {
                (if (t0..t0 + long).contains(&t) { f64::NAN } else { t0 + 0.5 * long - t }, -1.0)
            }
            Self::NoRate(t0) => (t0 - t, if t < t0 { -1.0 } else { f64::NAN }),
            Self::Waves(f) => ((f * t).cos(), -f * (f * t).sin()),
            Self::Dips(f, depth) => (1.0 + (f * t).cos() - depth, -f * (f * t).sin()),
            Self::Flat(t0) => (-(t - t0).powi(9), 0.0),
            Self::Steep(t0) => ((t0 - t).abs().sqrt().copysign(t0 - t), -1e300),
            Self::Counts(f) => ((f * t + n).sin(), f),
            Self::Huge(t0) => (f64::MAX * (t0 - t), f64::MIN),
            Self::Follows(threshold) => (threshold - input.position, -input.rate),
            Self::Fickle(seed) => fickle(seed.wrapping_add(u64::from(calls.guards.get()))),
            Self::Malice => malice(t, &calls.malice),
        };
        GuardValue::new(value, rate)
    }
}

/// Returns two numbers unrelated to those before, by splitmix64.
fn fickle(seed: u64) -> (f64, f64) {
    const VALUES: [f64; 8] = [1.0, -1.0, 1.0, -1.0, 0.0, 1e-15, -1e-15, 1e9];
    const RATES: [f64; 8] = [1.0, -1.0, 1e6, -1e6, 0.0, 1e3, -1e3, -1e12];
    let mut z = seed.wrapping_mul(0x9e37_79b9_7f4a_7c15);
    z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    (VALUES[(z >> 8) as usize % 8], RATES[(z >> 16) as usize % 8])
}

/// Leaves the longer part of the bracket in which the queried times enclose a root, and leads
/// interpolation to its start.
fn malice(t: f64, bracket: &Cell<[f64; 2]>) -> (f64, f64) {
    const BEFORE: (f64, f64) = (1e-9, -1e9);
    const AFTER: (f64, f64) = (-1e9, 1e12);
    let [lo, hi] = bracket.get();
    if t <= lo {
        bracket.set([t, hi]);
        BEFORE
    } else if t > hi {
        bracket.set([hi, t]);
        AFTER
    } else if t >= hi {
        bracket.set([t, t]);
        AFTER
    } else if hi - t >= t - lo {
        bracket.set([t, hi]);
        BEFORE
    } else {
        bracket.set([lo, t]);
        AFTER
    }
}
