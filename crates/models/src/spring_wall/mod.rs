//! A spring and a damper behind a wall: the calibration feel. See README.md.

mod drawing;
mod equations;

use pode::{GuardId, Motion};

use crate::describe::{
    Damper, Described, Parameter, Playable, Preset, SOFTEST_TONE_OF_A_GRAND, Sounding, filled,
    write,
};
use crate::draw::Sketch;

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
    Parameter::not_negative("K", "N/m", "stiffness"),
    Parameter::not_negative("B", "N·s/m", "damping"),
    Parameter::length("wall", "key travel at which the wall stands"),
];

/// In the middle of a key's travel, and soft enough for any key at 1 kHz (E).
const DEFAULT: [f64; 3] = [1000.0, 0.5, 0.005];

impl Described for SpringWall {
    const NAME: &'static str = "spring-wall";
    const SUMMARY: &'static str = "a spring and a damper behind a wall: the calibration feel";
    const STATES: &'static [&'static str] = &[];
    const STATE_UNITS: &'static [&'static str] = &[];
    const MODES: &'static [(Mode, &'static str)] =
        &[(Mode::Free, "free"), (Mode::Contact, "contact")];
    const PARAMETERS: &'static [Parameter] = &PARAMETERS;
    const PRESETS: &'static [Preset] = &[Preset {
        name: "default",
        doc: "1 kN/m and 0.5 N·s/m from 5 mm on",
        value: |parameter, _key| DEFAULT[parameter],
    }];
    const OUTPUTS: &'static [&'static str] = &["F", "depth"];
    const OUTPUT_UNITS: &'static [&'static str] = &["N", "m"];

    fn with_values(values: &[f64]) -> Self {
        let [stiffness, damping, wall] = filled::<_, Self>(values);
        Self { stiffness, damping, wall }
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
    const DAMPER: Damper = Damper::GRAND;
    const SOFTEST_TONE: f64 = SOFTEST_TONE_OF_A_GRAND;

    fn input_per_metre(&self) -> f64 {
        1.0
    }

    /// Returns nothing, since no contact sounds.
    fn sounding(&self, _guard: GuardId, _before: &[f64; 0]) -> Option<Sounding> {
        None
    }

    fn draw(&self, sketch: &mut dyn Sketch) {
        self.sketch(sketch);
    }
}
