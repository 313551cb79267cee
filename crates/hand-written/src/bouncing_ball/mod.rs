//! A ball that bounces on a floor which the key moves. See README.md.

mod equations;

use models::{Described, ModeCode, ModeEntry, ModelEntry, Parameter, Playable, Preset, Sounding};
use pode::{GuardId, Model as _, Motion};

use crate::entry;
use crate::parameter;

use crate::values::{filled, write};

/// A ball above a floor (`flight`) or on it (`rest`).
///
/// State: y (m), v (m/s), upwards. Input: the floor's height s (m).
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct BouncingBall {
    /// Gravity (m/s²).
    pub g: f64,
    /// Speed after an impact over speed before, relative to the floor.
    pub restitution: f64,
    /// Mass of the ball (kg).
    pub mass: f64,
    /// Height above the floor from which the ball is dropped (m); 0: it lies there.
    pub y0: f64,
    /// Metres of floor per metre of key-front travel; positive raises it.
    pub scale: f64,
}

/// Whether the ball flies or lies on the floor.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Mode {
    /// The ball is in the air.
    Flight,
    /// The ball lies on the floor.
    Rest,
}

const PARAMETERS: [Parameter; 5] = [
    parameter::gravity(),
    parameter::restitution("speed after an impact over speed before"),
    parameter::positive("mass", "kg", "mass of the ball"),
    parameter::within("y0", "m", 0.0, 100.0, "height of the drop at the start; 0: none"),
    parameter::scale("floor per key travel; positive raises the floor as the key goes down"),
];

const DEFAULT: [f64; 5] = [9.81, 0.8, 1.0, 1.0, 1.0];

/// A ball of 10 g on a paddle: 0.49 N at the finger while it lies there (E).
const KEY: [f64; 5] = [9.81, 0.7, 0.01, 0.0, 5.0];

/// All modes, in the order of their numbers.
const MODES: [Mode; 2] = [Mode::Flight, Mode::Rest];

const MODE_ENTRIES: [ModeEntry; 2] = [
    entry::mode("flight", (1, 0), &[entry::guard("floor", "m", &["flight", "rest"])]),
    entry::mode("rest", (1, 1), &[entry::guard("lift", "m/s²", &["flight"])]),
];

/// What is known of the model without building one.
pub static ENTRY: ModelEntry = ModelEntry {
    name: "bouncing-ball",
    summary: "a ball bouncing on a floor that the key moves",
    file: None,
    parameters: &PARAMETERS,
    presets: &[
        Preset {
            name: "default",
            doc: "1 kg dropped from 1 m, restitution 0.8",
            value: &|parameter, _key| DEFAULT[parameter],
        },
        Preset {
            name: "key",
            doc: "10 g lying on a paddle that rises 5 times the key's travel",
            value: &|parameter, _key| KEY[parameter],
        },
    ],
    input: "s",
    input_unit: "m",
    states: &["y", "v"],
    state_units: &["m", "m/s"],
    coordinates: BouncingBall::COORDS,
    modes: &MODE_ENTRIES,
    outputs: &["F", "gap"],
    output_units: &["N", "m"],
};

impl BouncingBall {
    /// The model with one value per parameter, in their order.
    fn from_array(values: &[f64; 5]) -> Self {
        let [g, restitution, mass, y0, scale] = *values;
        Self { g, restitution, mass, y0, scale }
    }
}

impl Default for BouncingBall {
    /// The model with the values of its first preset.
    fn default() -> Self {
        Self::from_array(&filled(&ENTRY, &[]))
    }
}

impl Described for BouncingBall {
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
        write(out, [self.contact(mode, s), x[0] - s.position]);
    }

    fn at_rest(&self, s: &Motion) -> (Mode, [f64; 2]) {
        let mode = if self.y0 > 0.0 { Mode::Flight } else { Mode::Rest };
        (mode, [s.position + self.y0, 0.0])
    }
}

impl Playable for BouncingBall {
    fn input_per_metre(&self) -> f64 {
        self.scale
    }

    /// Nothing: how hard the ball met the floor depends on the floor's speed too.
    fn sounding(&self, _guard: GuardId, _before: &[f64; 2]) -> Option<Sounding> {
        None
    }
}
