//! The paper's model A: key and hammer, rigid contact. See README.md.

mod equations;

use models::{Described, ModeCode, ModeEntry, ModelEntry, Playable, Sounding};
use pode::{GuardId, Model as _, Motion};

use crate::entry;

use crate::key_hammer::{COUNT, Coupled, KeyHammerValues, PARAMETERS, PRESETS, gap};
use crate::values::{filled, write};

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

/// All modes, in the order of their numbers.
const MODES: [Mode; 2] = [Mode::A1, Mode::A2];

const MODE_ENTRIES: [ModeEntry; 2] = [
    entry::mode("A1", (2, 2), &[entry::guard("release", "N", &["A2"])]),
    entry::mode(
        "A2",
        (1, 0),
        &[entry::guard("land", "m", &["A1"]), entry::guard("string", "rad", &["A2"])],
    ),
];

/// What is known of the model without building one.
pub static ENTRY: ModelEntry = ModelEntry {
    name: "key-hammer-rigid",
    summary: "the paper's model A: key and hammer in rigid contact",
    file: None,
    parameters: &PARAMETERS,
    presets: &PRESETS,
    input: "s",
    input_unit: "rad",
    states: &["theta_h", "theta_h_dot"],
    state_units: &["rad", "rad/s"],
    coordinates: KeyHammerRigid::COORDS,
    modes: &MODE_ENTRIES,
    outputs: &["F_KH", "T_KU", "gap"],
    output_units: &["N", "N·m", "m"],
};

impl KeyHammerRigid {
    /// The model with one value per parameter, in their order.
    fn from_array(values: &[f64; COUNT]) -> Self {
        Self { values: KeyHammerValues::from_array(values) }
    }
}

impl Default for KeyHammerRigid {
    /// The model with the values of its first preset.
    fn default() -> Self {
        Self::from_array(&filled(&ENTRY, &[]))
    }
}

impl Described for KeyHammerRigid {
    fn entry(&self) -> &'static ModelEntry {
        &ENTRY
    }

    fn with_values(&self, values: &[f64]) -> Self {
        Self::from_array(&filled(&ENTRY, values))
    }

    fn mode_code(&self, mode: Mode) -> ModeCode {
        ModeCode::structural(mode as u8)
    }

    fn mode(&self, number: ModeCode) -> Option<Mode> {
        number.of(&MODES)
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
    fn input_per_metre(&self) -> f64 {
        1.0 / self.values.r
    }

    fn sounding(&self, guard: GuardId, before: &[f64; 2]) -> Option<Sounding> {
        (guard == equations::STRING).then(|| Sounding { speed: self.values.l2 * before[1].abs() })
    }
}
