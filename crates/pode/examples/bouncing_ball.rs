//! A ball on a floor: every bounce, and the end of all bounces.

#![allow(clippy::disallowed_macros, clippy::print_stdout, reason = "an example prints")]

use pode::{
    Event, GuardId, GuardSpec, GuardValue, Guarded, Limits, Model, Reset, Resets, Settling,
    Simulator, Watch, stepper::Rk4,
};

/// Height (m) and speed (m/s) of a ball of 1 kg; each bounce keeps 0.8 of the speed.
#[derive(Clone, Copy)]
struct Ball;

const G: f64 = 9.81;
const RESTITUTION: f64 = 0.8;

impl Model for Ball {
    /// Whether the ball still bounces.
    type Mode = bool;
    type State = [f64; 2];
    type Input = ();
    const COORDS: usize = 1;

    fn derivative(&self, bounces: bool, x: &[f64; 2], (): &()) -> [f64; 2] {
        if bounces { [x[1], -G] } else { [0.0, 0.0] }
    }

    fn readout(&self, bounces: bool, _: &[f64; 2], (): &()) -> f64 {
        if bounces { 0.0 } else { G }
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
        let impulse = up * (1.0 + ratio) / (1.0 - ratio);
        Reset::to(true, [0.0, up]).with_impulse(up - x[1]).settling(Settling {
            after,
            ratio,
            mode: false,
            state: [0.0, 0.0],
            impulse,
        })
    }
}

/// Prints events; ticks last 1 ms.
struct Printer;

impl Watch<Ball> for Printer {
    fn event(&mut self, _: &Ball, event: &Event<'_, Ball>) {
        let t = (event.tick as f64 + event.theta) * 1e-3;
        println!("{t:.12} s  {:8} at {:.6} m/s", event.cause.name(), event.before.1[1]);
    }
}

fn main() {
    let mut ball = Simulator::new(Ball, Rk4, Limits::default(), true, [1.0, 0.0]);
    for _ in 0..5000 {
        let tick = ball.advance(1e-3, &|_| (), &mut Printer);
        assert_eq!(tick.advance, pode::Advance::Completed);
    }
}
