//! The paper's model B: key and hammer, springs in every contact. See README.md.

mod equations;
mod series;

use models::{Described, ModeCode, ModeEntry, ModelEntry, Playable, Sounding};
use pode::{GuardId, Model as _, Motion, Nature, Part};

use crate::entry;

use crate::key_hammer::{COUNT, KeyHammerValues, PARAMETERS, PRESETS};
use crate::values::{filled, write};

/// Key and hammer coupled by springs (B1) or apart (B2).
///
/// State: θh, θk (rad), θh', θk' (rad/s). Input: the manipulandum's angle s (rad).
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct KeyHammerSprings {
    values: KeyHammerValues,
    /// Longest steps in B1 and B2 (s): asked for in every tick, so found once.
    longest_steps: [f64; 2],
    /// What the equations of B1 and B2 are like.
    natures: [Nature; 2],
    /// Hammer and key, which move apart in B2.
    apart: [Part; 2],
    /// 1/JH and 1/JK (1/(kg·m²)): a product takes a third of a division's time.
    per_inertia: [f64; 2],
    /// Angular accelerations by the weight of hammer and key, lying level (rad/s²).
    weights: [f64; 2],
    /// Moments of the weight of hammer and key, lying level (N·m).
    moments: [f64; 2],
    /// What the Taylor series is given: see `equations::series_constants`.
    series: [f64; 10],
}

impl KeyHammerSprings {
    /// Returns the values in the order of the parameters.
    pub const fn values(&self) -> &KeyHammerValues {
        &self.values
    }

    /// The model with one value per parameter, in their order.
    fn from_array(values: &[f64; COUNT]) -> Self {
        let values = KeyHammerValues::from_array(values);
        let per_inertia = [1.0 / values.jh, 1.0 / values.jk];
        let moments = [values.m2 * values.l2, values.m1 * values.ck].map(|it| it * values.g);
        let weights = [0, 1].map(|i| moments[i] * per_inertia[i]);
        let longest_steps = equations::longest_steps(&values);
        let natures = equations::natures(&values);
        Self {
            values,
            longest_steps,
            natures,
            apart: equations::apart(&values, natures[1]),
            per_inertia,
            weights,
            moments,
            series: equations::series_constants(&values),
        }
    }
}

/// Whether the hammer is on the key.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Mode {
    /// Hammer on the key, through k2.
    B1,
    /// Hammer in free flight.
    B2,
}

/// All modes, in the order of their numbers.
const MODES: [Mode; 2] = [Mode::B1, Mode::B2];

const MODE_ENTRIES: [ModeEntry; 2] = [
    entry::mode(
        "B1",
        (4, 2),
        &[entry::guard("release", "m", &["B2"]), entry::guard("string", "rad", &["B1"])],
    ),
    entry::mode(
        "B2",
        (2, 0),
        &[entry::guard("land", "m", &["B1"]), entry::guard("string", "rad", &["B2"])],
    ),
];

/// What is known of the model without building one.
pub static ENTRY: ModelEntry = ModelEntry {
    name: "key-hammer-springs",
    summary: "the paper's model B: key and hammer with springs in the contacts",
    file: None,
    parameters: &PARAMETERS,
    presets: &PRESETS,
    input: "s",
    input_unit: "rad",
    states: &["theta_h", "theta_k", "theta_h_dot", "theta_k_dot"],
    state_units: &["rad", "rad", "rad/s", "rad/s"],
    coordinates: KeyHammerSprings::COORDS,
    modes: &MODE_ENTRIES,
    outputs: &["F_KH", "T_KU", "gap", "q4", "q3"],
    output_units: &["N", "N·m", "m", "m", "m"],
};

impl Default for KeyHammerSprings {
    /// The model with the values of its first preset.
    fn default() -> Self {
        Self::from_array(&filled(&ENTRY, &[]))
    }
}

impl Described for KeyHammerSprings {
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

    fn outputs(&self, mode: Mode, x: &[f64; 4], s: &Motion, out: &mut [f64]) {
        let contact = self.contact(x);
        let gap = -contact.q4 * contact.cos_delta;
        // Apart, the spring is slack and the slider is nowhere on the hammer.
        let (force, q4, q3) = match mode {
            Mode::B1 => (contact.force(), contact.q4, contact.q3),
            Mode::B2 => (0.0, 0.0, 0.0),
        };
        write(out, [force, self.coupling(x, s), gap, q4, q3]);
    }

    fn at_rest(&self, input: &Motion) -> (Mode, [f64; 4]) {
        (Mode::B1, self.equilibrium(input.position))
    }
}

impl Playable for KeyHammerSprings {
    fn input_per_metre(&self) -> f64 {
        1.0 / self.values.r
    }

    fn sounding(&self, guard: GuardId, before: &[f64; 4]) -> Option<Sounding> {
        (guard == equations::STRING).then(|| Sounding { speed: self.values.l2 * before[2].abs() })
    }
}
