//! Case C8: a head that falls on a spring without loss.

use super::G;
use pode::{
    EquationKind, GuardId, GuardSpec, GuardValue, Guarded, Limits, Model, Nature, Reset, Resets,
    Simulator, Stepper,
};

pub const MASS: f64 = 0.01;

/// Fraction of a radian of the contact's oscillation in one step of RK4.
pub const RADIANS: f64 = 0.05;

/// Stiffness (N/m), contact time (s), deepest point (m), period (s); from 40-digit arithmetic.
pub const CONTACTS: [[f64; 4]; 3] = [
    [1e3, 0.010_130_725_363_703_42, 0.003_261_898_920_601_624, 0.214_004_323_732_714_6],
    [1e5, 0.000_995_420_820_285_805_5, 0.000_317_210_287_639_522_7, 0.204_869_019_189_297],
    [1e7, 0.000_099_365_502_657_331_63, 0.000_031_632_588_123_310_1, 0.203_972_963_871_668_5],
];

/// A head that falls on F = −k min(x, 0): height (m) and speed (m/s).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Head {
    pub k: f64,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Mode {
    Flight,
    Contact,
}

impl Head {
    pub fn omega(self) -> f64 {
        (self.k / MASS).sqrt()
    }

    pub fn dropped<T: Stepper>(self, stepper: T) -> Simulator<Self, T> {
        Simulator::new(self, stepper, Limits::default(), Mode::Flight, [0.0, -1.0])
    }
}

impl Model for Head {
    type Mode = Mode;
    type State = [f64; 2];
    type Input = ();
    const COORDS: usize = 1;

    fn derivative(&self, mode: Mode, x: &[f64; 2], (): &()) -> [f64; 2] {
        [x[1], self.readout(mode, x, &()) / MASS - G]
    }

    fn readout(&self, mode: Mode, x: &[f64; 2], (): &()) -> f64 {
        match mode {
            Mode::Flight => 0.0,
            Mode::Contact => -self.k * x[0],
        }
    }

    fn nature(&self, mode: Mode) -> Nature {
        let (rate, longest) = match mode {
            Mode::Flight => (0.0, f64::INFINITY),
            Mode::Contact => (self.omega(), RADIANS / self.omega()),
        };
        Nature::new(EquationKind::Affine, rate).with_longest_step(longest)
    }
}

impl Guarded for Head {
    fn guards(&self, mode: Mode) -> &'static [GuardSpec] {
        const TOUCH: [GuardSpec; 1] = [GuardSpec::new(0, "touch").scaled(0.1)];
        const CONTACT: [GuardSpec; 2] = [
            // Penetrations are smaller than heights.
            GuardSpec::new(1, "leave").scaled(1e-3),
            GuardSpec::new(2, "deepest").on_crossing(),
        ];
        match mode {
            Mode::Flight => &TOUCH,
            Mode::Contact => &CONTACT,
        }
    }

    fn guard(&self, mode: Mode, id: GuardId, x: &[f64; 2], (): &()) -> GuardValue {
        match id.0 {
            0 => GuardValue::new(x[0], x[1]),
            1 => GuardValue::new(-x[0], -x[1]),
            _ => GuardValue::new(-x[1], -self.derivative(mode, x, &())[1]),
        }
    }
}

impl Resets for Head {
    fn reset(&self, _: Mode, id: GuardId, x: &[f64; 2], (): &()) -> Reset<Self> {
        match id.0 {
            0 => Reset::to(Mode::Contact, [0.0, x[1]]),
            1 => Reset::to(Mode::Flight, [0.0, x[1]]),
            _ => Reset::to(Mode::Contact, *x),
        }
    }
}
