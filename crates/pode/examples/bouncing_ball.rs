//! A ball on a floor: every bounce, and the end of all bounces.

#![allow(clippy::disallowed_macros, clippy::print_stdout, reason = "an example prints")]

use pode::{
    GuardId, GuardSpec, GuardValue, Guarded, Limits, Model, Reset, Resets, RunRecorder, Settling,
    Simulator, stepper::Rk4,
};

/// Height (m) and speed (m/s) of a ball; each bounce keeps 0.8 of the speed.
#[derive(Clone, Copy, Debug)]
struct Ball;

const G: f64 = 9.81;
const RESTITUTION: f64 = 0.8;

impl Model for Ball {
    type Mode = bool;
    type State = [f64; 2];
    type Input = ();
    const COORDS: usize = 1;

    fn derivative(&self, bounces: bool, x: &[f64; 2], (): &()) -> [f64; 2] {
        if bounces { [x[1], -G] } else { [0.0, 0.0] }
    }
}

impl Guarded for Ball {
    fn guards(&self, bounces: bool) -> &'static [GuardSpec] {
        if bounces { const { &[GuardSpec::new(0, "floor")] } } else { &[] }
    }

    fn guard(&self, _: bool, _: GuardId, x: &[f64; 2], (): &()) -> GuardValue {
        GuardValue::new(x[0], x[1])
    }
}

impl Resets for Ball {
    fn reset(&self, _: bool, _: GuardId, x: &[f64; 2], (): &()) -> Reset<Self> {
        let (ratio, up) = (RESTITUTION, -RESTITUTION * x[1]);
        let after = 2.0 * up / (G * (1.0 - ratio));
        let (mode, state, impulse) = (false, [0.0, 0.0], up * (1.0 + ratio) / (1.0 - ratio));
        let settling = Settling { after, ratio, mode, state, impulse };
        Reset::to(true, [0.0, up]).with_impulse(up - x[1]).settling(settling)
    }
}

fn main() {
    let mut ball = Simulator::new(Ball, Rk4, Limits::default(), true, [1.0, 0.0]);
    let mut recorder = RunRecorder::new(1e-3);
    let report = ball.run(5.0, 1e-3, |_| (), &mut recorder);
    recorder.events().iter().for_each(|event| println!("{event}"));
    println!("{:?} after {} ticks, {:?}", report.advance, report.ticks, report.work);
}
