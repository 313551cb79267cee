//! A mass that sticks and slips on a belt.

use pode::Nature;
use pode::filippov::{Branch, Sided, Surface, SurfaceSide};

/// Place and speed of a mass on a spring on a belt at 0.1 m/s: 1 kg, 100 N/m, 1 N while it slips
/// and 1.5 N while it sticks.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct StickSlip {
    pub nature: Nature,
}

impl Sided for StickSlip {
    type State = [f64; 2];
    type Input = ();
    const COORDS: usize = 1;
    const SIZE: f64 = 0.1;
    const RATE: f64 = 1.0;

    fn derivative(&self, branch: Branch, x: &[f64; 2], (): &()) -> [f64; 2] {
        [x[1], self.readout(branch, x, &()) - 100.0 * x[0]]
    }

    fn readout(&self, branch: Branch, _: &[f64; 2], (): &()) -> f64 {
        -branch.side.sign() * if branch.holds { 1.5 } else { 1.0 }
    }

    fn surface(&self, x: &[f64; 2], (): &()) -> Surface<[f64; 2]> {
        Surface { value: x[1] - 0.1, gradient: [0.0, 1.0], drift: 0.0 }
    }

    fn nature(&self, _: SurfaceSide) -> Nature {
        self.nature
    }
}
