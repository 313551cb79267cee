//! A reduced grand action with let-off, check and repetition: model C. See README.md.

mod bounds;
mod energy;
mod entry;
mod forces;
mod geometry;
mod guards;
mod motion;
mod parameters;
mod presets;
mod resets;
mod rest;
mod steps;

pub use entry::ENTRY;
pub use parameters::ReducedGrandValues;

use models::{Described, ModeCode, ModelEntry, Playable, Sounding};
use pode::{GuardId, Motion};

use crate::values::{filled, write};
use bounds::PerWidth;
use entry::MODES;
use geometry::LetOff;
use steps::LongestSteps;

/// A key and a hammer in eleven configurations of jack, string, lever and check.
///
/// State: y (m) key front, down; z (m) hammer head, up; u = y', w = z' (m/s).
/// Input: the finger's position s (m), down.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct ReducedGrand {
    values: ReducedGrandValues,
    let_off: LetOff,
    longest_steps: LongestSteps,
    per_width: PerWidth,
}

impl ReducedGrand {
    /// Returns the values in the order of the parameters.
    pub const fn values(&self) -> &ReducedGrandValues {
        &self.values
    }

    /// The model with one value per parameter, in their order.
    fn from_array(values: &[f64; parameters::COUNT]) -> Self {
        let values = ReducedGrandValues::from_array(values);
        Self {
            values,
            let_off: LetOff::new(&values),
            longest_steps: LongestSteps::new(&values),
            per_width: PerWidth::new(&values),
        }
    }
}

/// Where the hammer's head is, and how the jack stands.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Mode {
    /// Accelerated: the head on the jack.
    Acc,
    /// Let-off: the head on the jack, the jack on its button.
    Lo,
    /// In the air, the jack below and off its button.
    Fla,
    /// In the air, the jack below and on its button.
    Fll,
    /// In the air, the jack tripped.
    Flt,
    /// On the string, the jack below.
    Stu,
    /// On the string, the jack tripped.
    Stt,
    /// On the repetition lever, with the check in reach.
    RepH,
    /// On the repetition lever, with the check out of reach.
    RepL,
    /// On the repetition lever, the jack pushing its way back.
    Rep0,
    Chk,
}

impl Default for ReducedGrand {
    /// The model with the values of its first preset.
    fn default() -> Self {
        Self::from_array(&filled(&ENTRY, &[]))
    }
}

impl Described for ReducedGrand {
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
        let [y, z, u, w] = *x;
        let (mut jack, mut lever, mut string) = (0.0, 0.0, 0.0);
        match mode {
            Mode::Acc | Mode::Lo => jack = self.jack_force(mode, x, s),
            Mode::RepH | Mode::RepL | Mode::Rep0 => lever = self.lever_force(&self.lever(y), x),
            Mode::Stu | Mode::Stt => string = self.string_force(z, w),
            Mode::Chk => lever = self.lever_under_check(y),
            Mode::Fla | Mode::Fll | Mode::Flt => {}
        }
        write(out, [self.finger(y, u, s), jack, lever, string]);
    }

    fn at_rest(&self, input: &Motion) -> (Mode, [f64; 4]) {
        self.balance(input.position)
    }
}

impl Playable for ReducedGrand {
    fn input_per_metre(&self) -> f64 {
        1.0
    }

    fn sounding(&self, guard: GuardId, before: &[f64; 4]) -> Option<Sounding> {
        (guard == guards::STRING_ON).then(|| Sounding { speed: before[3].abs() })
    }
}
