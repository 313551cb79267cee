//! The paper's model A: key and hammer, rigid contact. See README.md.

mod drawing;
mod equations;

use pode::{GuardId, Motion};

use crate::describe::{
    Damper, Described, Parameter, Playable, Preset, SOFTEST_TONE_OF_A_GRAND, Sounding, filled,
    write,
};
use crate::draw::Sketch;
use crate::key_hammer::{Coupled, KeyHammerValues, PARAMETERS, PRESETS, gap};

/// Key and hammer in rigid contact (A1) or apart (A2).
///
/// State: θh (rad), θh' (rad/s). Input: the key's angle s (rad).
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct KeyHammerRigid {
    pub values: KeyHammerValues,
}

/// Whether the hammer is on the key.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Mode {
    /// Hammer on the key; no degree of freedom.
    A1,
    /// Hammer in free flight.
    A2,
}

impl Described for KeyHammerRigid {
    const NAME: &'static str = "key-hammer-rigid";
    const SUMMARY: &'static str = "the paper's model A: key and hammer in rigid contact";
    const STATES: &'static [&'static str] = &["theta_h", "theta_h_dot"];
    const STATE_UNITS: &'static [&'static str] = &["rad", "rad/s"];
    const MODES: &'static [(Mode, &'static str)] = &[(Mode::A1, "A1"), (Mode::A2, "A2")];
    const PARAMETERS: &'static [Parameter] = &PARAMETERS;
    const PRESETS: &'static [Preset] = &PRESETS;
    const OUTPUTS: &'static [&'static str] = &["F_KH", "T_KU", "gap"];
    const OUTPUT_UNITS: &'static [&'static str] = &["N", "N·m", "m"];

    fn with_values(values: &[f64]) -> Self {
        Self { values: KeyHammerValues::from_array(&filled::<_, Self>(values)) }
    }

    fn outputs(&self, mode: Mode, x: &[f64; 2], s: &Motion, out: &mut [f64]) {
        let (contact, torque) = self.forces(mode, s);
        let gap = gap(&self.values, (x[0], x[1]), (s.position, s.rate)).value;
        write(out, [contact, torque, gap]);
    }

    fn at_rest(&self, input: &Motion) -> (Mode, [f64; 2]) {
        let hammer = Coupled::on_key(&self.values, input);
        (Mode::A1, [hammer.angle, hammer.rate])
    }
}

impl Playable for KeyHammerRigid {
    const DAMPER: Damper = Damper::GRAND;
    const SOFTEST_TONE: f64 = SOFTEST_TONE_OF_A_GRAND;

    fn input_per_metre(&self) -> f64 {
        1.0 / self.values.r
    }

    fn sounding(&self, guard: GuardId, before: &[f64; 2]) -> Option<Sounding> {
        (guard == equations::STRING).then(|| Sounding { speed: self.values.l2 * before[1].abs() })
    }

    fn draw(&self, sketch: &mut dyn Sketch) {
        self.sketch(sketch);
    }
}
