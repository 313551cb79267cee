//! A block on a belt, held by a spring: it sticks until the spring pulls it off, and slips back.

#![allow(clippy::disallowed_macros, clippy::print_stdout, reason = "an example prints")]

use pode::filippov::{Branch, Filippov, Sided, Surface};
use pode::{Limits, RunRecorder, Simulator, stepper::Rk4};

/// Place (m) and speed (m/s) of a block of 1 kg over the ground.
#[derive(Clone, Copy, PartialEq, Debug)]
struct Block;

/// Stiffness of the spring (N/m), speed of the belt (m/s), static and sliding friction (N).
const STIFFNESS: f64 = 100.0;
const BELT: f64 = 0.1;
const HELD: f64 = 2.0;
const KINETIC: f64 = 1.0;

impl Sided for Block {
    type State = [f64; 2];
    type Input = ();
    const COORDS: usize = 1;
    const SIZE: f64 = 1.0;
    const RATE: f64 = 10.0;

    fn derivative(&self, branch: Branch, x: &[f64; 2], (): &()) -> [f64; 2] {
        [x[1], self.readout(branch, x, &()) - STIFFNESS * x[0]]
    }

    /// Returns the friction (N).
    fn readout(&self, branch: Branch, _: &[f64; 2], (): &()) -> f64 {
        -branch.side.sign() * if branch.holds { HELD } else { KINETIC }
    }

    fn surface(&self, x: &[f64; 2], (): &()) -> Surface<[f64; 2]> {
        Surface { value: x[1] - BELT, gradient: [0.0, 1.0], drift: 0.0 }
    }
}

fn main() {
    let model = Filippov(Block);
    let (mode, state) = model.start(&[0.0, BELT], &());
    let mut simulator = Simulator::new(model, Rk4, Limits::default(), mode, state);
    let mut recorder = RunRecorder::new(1e-3);
    let report = simulator.run(1.0, 1e-3, |_| (), &mut recorder);
    recorder.events().iter().for_each(|event| println!("{event}"));
    println!("{:?} after {} ticks, {:?}", report.advance, report.ticks, report.work);
}
