//! What a model says about itself: names, parameters, presets, how a key plays it.

use pode::{Energetic, GuardId, Model, Motion, Resets, Sloped};

use crate::draw::Sketch;

/// A parameter of a model, with its unit and range.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Parameter {
    /// Name in scenes, on the command line and in files.
    pub name: &'static str,
    /// SI unit; `"1"` for a ratio.
    pub unit: &'static str,
    /// Smallest and largest allowed value.
    pub range: (f64, f64),
    /// What it is, in one line.
    pub doc: &'static str,
}

impl Parameter {
    /// A value between `low` and `high`.
    pub(crate) const fn within(
        name: &'static str,
        unit: &'static str,
        low: f64,
        high: f64,
        doc: &'static str,
    ) -> Self {
        Self { name, unit, range: (low, high), doc }
    }

    /// A value that something is divided by.
    pub(crate) const fn positive(
        name: &'static str,
        unit: &'static str,
        doc: &'static str,
    ) -> Self {
        Self::within(name, unit, 1e-9, 1e9, doc)
    }

    /// A value that may be zero.
    pub(crate) const fn not_negative(
        name: &'static str,
        unit: &'static str,
        doc: &'static str,
    ) -> Self {
        Self::within(name, unit, 0.0, 1e9, doc)
    }

    /// A place or a length with a sign (m).
    pub(crate) const fn length(name: &'static str, doc: &'static str) -> Self {
        Self::within(name, "m", -100.0, 100.0, doc)
    }

    /// Gravity (m/s²).
    pub(crate) const fn gravity() -> Self {
        Self::within("g", "m/s²", 0.0, 1000.0, "gravity")
    }

    /// Restitution of an impact on `doc`.
    pub(crate) const fn restitution(doc: &'static str) -> Self {
        Self::within("restitution", "1", 0.0, 1.0, doc)
    }

    /// Input per metre of key-front travel, for models whose input is a length.
    pub(crate) const fn scale(doc: &'static str) -> Self {
        Self::within("scale", "m/m", -1000.0, 1000.0, doc)
    }
}

/// A named set of parameter values, graded over the compass.
#[derive(Clone, Copy, Debug)]
pub struct Preset {
    pub name: &'static str,
    /// What it is, in one line.
    pub doc: &'static str,
    /// Value of the parameter with the given index for a key, 0 (A0) ..= 87 (C8).
    pub value: fn(parameter: usize, key: u8) -> f64,
}

/// A model with a name, parameters, and names for all that it has.
///
/// Its state is an array, so that entries can be set by name: `x.as_mut()[index]`.
pub trait Described:
    Model<Input = Motion, State: AsMut<[f64]>>
    + Resets
    + Energetic
    + Sloped
    + Copy
    + PartialEq
    + Send
    + 'static
{
    /// Name in scenes and on the command line.
    const NAME: &'static str;
    /// What it is, in one line.
    const SUMMARY: &'static str;
    /// Names of the state's entries.
    const STATES: &'static [&'static str];
    /// SI unit of each of them.
    const STATE_UNITS: &'static [&'static str];
    /// Every mode with its name.
    const MODES: &'static [(Self::Mode, &'static str)];
    /// The parameters, in the order of [`Described::with_values`].
    const PARAMETERS: &'static [Parameter];
    /// Named parameter sets; the first is the default.
    const PRESETS: &'static [Preset];
    /// Names of what [`Described::outputs`] writes.
    const OUTPUTS: &'static [&'static str];
    /// SI unit of each of them.
    const OUTPUT_UNITS: &'static [&'static str];

    /// The model with one value per parameter; a missing one is taken from the default
    /// preset.
    fn with_values(values: &[f64]) -> Self;

    /// Writes the outputs, forces first, for files and plots.
    fn outputs(&self, mode: Self::Mode, x: &Self::State, input: &Motion, out: &mut [f64]);

    /// At rest under a constant input, or where the parameters say that it starts: a
    /// `y0` above 0 is a drop.
    fn at_rest(&self, input: &Motion) -> (Self::Mode, Self::State);
}

/// A model that can be rendered on a key.
pub trait Playable: Described {
    /// The damper that the key lifts.
    const DAMPER: Damper;

    /// Speed below which what strikes touches the string but does not sound (m/s).
    const SOFTEST_TONE: f64;

    /// Input per metre of key-front travel (unit of the input / m); a force at the
    /// finger is the readout times this.
    fn input_per_metre(&self) -> f64;

    /// What firing `guard` in `before` sounds, if anything.
    fn sounding(&self, guard: GuardId, before: &Self::State) -> Option<Sounding>;

    /// Draws the mechanism, with these values.
    fn draw(&self, _sketch: &mut dyn Sketch) {}
}

/// A damper that a key lifts off its string.
///
/// `lift` is above `fall` by many encoder counts, so that a key held at a height does not chatter.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Damper {
    /// Key-front travel at which it leaves the string (m).
    pub lift: f64,
    /// Key-front travel at which it is back on the string (m).
    pub fall: f64,
}

impl Damper {
    /// A grand's: it is lifted at half of the key's dip (S), where the hammer is at half blow
    /// (piano-facts).
    pub const GRAND: Self = Self { lift: 5.0e-3, fall: 4.6e-3 };
}

/// [`Playable::SOFTEST_TONE`] of a grand (m/s).
///
/// Grands were measured to give no tone below 0.18 m/s (piano-facts); a little less, so that the
/// limit lies below the softest MIDI velocity of the Disklavier's curve.
pub(crate) const SOFTEST_TONE_OF_A_GRAND: f64 = 0.15;

/// A guard's firing that is heard.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Sounding {
    /// Speed of what strikes (m/s).
    pub speed: f64,
}

/// Writes `values` to the first entries of `out`, as many as there are.
pub(crate) fn write<const N: usize>(out: &mut [f64], values: [f64; N]) {
    for (slot, value) in out.iter_mut().zip(values) {
        *slot = value;
    }
}

/// `values` with what is missing taken from the default preset.
pub(crate) fn filled<const N: usize, M: Described>(values: &[f64]) -> [f64; N] {
    core::array::from_fn(|index| {
        values.get(index).copied().unwrap_or_else(|| (M::PRESETS[0].value)(index, 0))
    })
}
