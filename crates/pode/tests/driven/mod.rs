//! Models driven by time or by a known motion, run like those without an input.

use pode::contacts::Continued;
use pode::{Resets, Simulator, Stepper, Tick};

use pode::RunRecorder;

#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Clock(pub f64);

impl Continued for Clock {
    fn after(&self, dt: f64) -> Self {
        Self(self.0 + dt)
    }
}

/// Runs a model to exactly `until` (s) under `input`, a function of the time, with ticks of `h`,
/// the first one cut to `1 − phase` of a tick and the last one to fit; returns the events and every
/// tick.
pub fn run_driven<M: Resets, T: Stepper>(
    simulator: &mut Simulator<M, T>,
    (h, phase): (f64, f64),
    until: f64,
    input: impl Fn(f64) -> M::Input,
) -> (RunRecorder<M>, Vec<Tick>) {
    let mut recorder = RunRecorder::new(h);
    let mut ticks = Vec::new();
    let line = |n: u32| (f64::from(n) - phase) * h;
    for n in 0_u32.. {
        let begin = line(n).max(0.0);
        let end = if line(n + 1) < until - 1e-6 * h { line(n + 1) } else { until };
        let length = end - begin;
        recorder.place_tick(n.into(), begin, length);
        let signal = |theta: f64| input(if theta < 1.0 { begin + theta * length } else { end });
        ticks.push(simulator.advance(length, &signal, &mut recorder));
        if end >= until {
            break;
        }
    }
    (recorder, ticks)
}

/// The root of `f` in `lo` ..= `hi`, where it changes its sign, to the last digit.
pub fn root(mut lo: f64, mut hi: f64, f: impl Fn(f64) -> f64) -> f64 {
    let at_lo = f(lo);
    for _ in 0..200 {
        let middle = 0.5 * (lo + hi);
        if f(middle) * at_lo > 0.0 {
            lo = middle;
        } else {
            hi = middle;
        }
    }
    0.5 * (lo + hi)
}
