//! A spring and a damper behind a wall: the calibration feel. See README.md.

mod equations;

use models::{Described, ModeCode, ModeEntry, ModelEntry, Parameter, Playable, Preset, Sounding};
use pode::{GuardId, Model as _, Motion};

use crate::entry;
use crate::parameter;

use crate::values::{filled, write};

/// Nothing before the wall (`free`), a spring and a damper behind it (`contact`).
///
/// State: none. Input: the key front's travel s (m).
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct SpringWall {
    /// Stiffness K (N/m).
    pub stiffness: f64,
    /// Damping B (N·s/m).
    pub damping: f64,
    /// Where the wall stands (m).
    pub wall: f64,
}

/// Whether the key touches the wall.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Mode {
    Free,
    Contact,
}

const PARAMETERS: [Parameter; 3] = [
    parameter::not_negative("K", "N/m", "stiffness"),
    parameter::not_negative("B", "N·s/m", "damping"),
    parameter::length("wall", "key travel at which the wall stands"),
];

/// In the middle of a key's travel, and soft enough for any key at 1 kHz (E).
const DEFAULT: [f64; 3] = [1000.0, 0.5, 0.005];

/// All modes, in the order of their numbers.
const MODES: [Mode; 2] = [Mode::Free, Mode::Contact];

const MODE_ENTRIES: [ModeEntry; 2] = [
    entry::mode("free", (0, 0), &[entry::guard("touch", "m", &["contact"])]),
    entry::mode("contact", (0, 0), &[entry::guard("leave", "m", &["free"])]),
];

/// What is known of the model without building one.
pub static ENTRY: ModelEntry = ModelEntry {
    name: "spring-wall",
    summary: "a spring and a damper behind a wall: the calibration feel",
    file: None,
    parameters: &PARAMETERS,
    presets: &[Preset {
        name: "default",
        doc: "1 kN/m and 0.5 N·s/m from 5 mm on",
        value: &|parameter, _key| DEFAULT[parameter],
    }],
    input: "s",
    input_unit: "m",
    states: &[],
    state_units: &[],
    coordinates: SpringWall::COORDS,
    modes: &MODE_ENTRIES,
    outputs: &["F", "depth"],
    output_units: &["N", "m"],
};

impl SpringWall {
    /// The model with one value per parameter, in their order.
    fn from_array(values: &[f64; 3]) -> Self {
        let [stiffness, damping, wall] = *values;
        Self { stiffness, damping, wall }
    }
}

impl Default for SpringWall {
    /// The model with the values of its first preset.
    fn default() -> Self {
        Self::from_array(&filled(&ENTRY, &[]))
    }
}

impl Described for SpringWall {
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

    fn outputs(&self, mode: Mode, _x: &[f64; 0], s: &Motion, out: &mut [f64]) {
        write(out, [self.force(mode, s), self.depth(s)]);
    }

    fn at_rest(&self, s: &Motion) -> (Mode, [f64; 0]) {
        let mode = if self.depth(s) > 0.0 { Mode::Contact } else { Mode::Free };
        (mode, [])
    }
}

impl Playable for SpringWall {
    fn input_per_metre(&self) -> f64 {
        1.0
    }

    /// Returns nothing, since no contact sounds.
    fn sounding(&self, _guard: GuardId, _before: &[f64; 0]) -> Option<Sounding> {
        None
    }
}
