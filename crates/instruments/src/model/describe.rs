//! Descriptions of models: names, parameters, presets, playing by a key.

use alloc::sync::Arc;

use crate::equations::table::{Equations as _, MidiTable};
use pode::{Energetic, GuardId, Model, Motion, Resets, Sloped};

use crate::model::draw::Sketch;
use crate::model::entry::{ModeEntry, ModelEntry};
use crate::model::mode_code::ModeCode;
use crate::model::parts::ModelParts;

/// A model with names for its structural modes, and a number for each mode.
pub trait NamedModes: Model {
    fn shared(&self) -> &Arc<ModelParts>;

    fn mode_code(&self, mode: Self::Mode) -> ModeCode;

    /// Returns the mode with this number; `None` if there is none.
    fn mode(&self, number: ModeCode) -> Option<Self::Mode>;

    /// Returns every structural mode with its name, with all contacts open.
    fn modes(&self) -> impl Iterator<Item = (Self::Mode, &'static str)> {
        let named = |(index, mode): (u8, &ModeEntry)| {
            Some((self.mode(ModeCode::structural(index))?, mode.name))
        };
        (0..=u8::MAX).zip(&self.shared().modes).filter_map(named)
    }
}

/// A model with a name, parameters, and names for all its quantities.
///
/// The description belongs to the value, since one type is every model from a file. The state is an
/// array, so that entries can be set by name: `x.as_mut()[index]`.
pub trait Described:
    NamedModes<Input = Motion, State: AsMut<[f64]>>
    + Resets
    + Energetic
    + Sloped
    + Clone
    + PartialEq
    + Send
    + 'static
{
    fn entry(&self) -> &ModelEntry {
        self.shared()
    }

    /// Returns the model with one value per parameter; a missing one comes from the default preset.
    #[must_use]
    fn with_values(&self, values: &[f64]) -> Self;

    /// Writes the outputs, forces first, for files and plots.
    fn outputs(&self, mode: Self::Mode, x: &Self::State, input: &Motion, out: &mut [f64]);

    /// Calls `report` with each violated condition on the parameters, as `string > trip`.
    fn unmet(&self, report: &mut dyn FnMut(&str));

    /// Returns the state at rest under a constant input, or the start stated by the parameters.
    fn at_rest(&self, input: &Motion) -> (Self::Mode, Self::State);

    /// Returns the start at `x` in the structural mode of `mode`: constraints hold, and overlapping
    /// contacts are closed.
    fn begin(
        &self,
        mode: Self::Mode,
        x: &Self::State,
        input: &Motion,
    ) -> (Self::Mode, Self::State) {
        (mode, self.constrain(mode, x, input))
    }
}

/// A model that can be rendered on a key.
pub trait Playable: Described {
    fn damper(&self) -> Damper {
        let damper = self.shared().table().sound.damper;
        damper.map_or(Damper::USUAL, |it| Damper { lift: it.lift, fall: it.fall })
    }

    /// Returns the speed below which a strike does not sound (m/s).
    fn softest_tone(&self) -> f64 {
        let damper = self.shared().table().sound.damper;
        damper.map_or(Damper::USUAL_SOFTEST_TONE, |it| it.softest_tone)
    }

    fn midi(&self) -> MidiTable {
        self.shared().table().sound.midi
    }

    /// Returns the input per metre of key-front travel (unit of the input / m); a force at the
    /// finger is the readout times this.
    fn input_per_metre(&self) -> f64;

    fn sounding(&self, guard: GuardId, before: &Self::State) -> Option<Sounding>;

    fn draw(&self, _sketch: &mut dyn Sketch) {}
}

/// A damper that a key lifts off its string.
///
/// `lift` is above `fall` by many encoder counts, so that a key held at a height does not chatter.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Damper {
    /// Key-front travel at which the damper leaves the string, and at which it is back (m).
    pub lift: f64,
    pub fall: f64,
}

impl Damper {
    /// Default of a description without damper: at half of the usual dip (piano-facts).
    pub const USUAL: Self = Self { lift: 5.0e-3, fall: 4.6e-3 };

    /// Default softest tone (m/s).
    ///
    /// Grands were measured to give no tone below 0.18 m/s (piano-facts). The default is a little
    /// less, so that the limit is below the softest MIDI velocity of the Disklavier's curve.
    pub const USUAL_SOFTEST_TONE: f64 = 0.15;
}

/// Returns the speed of a grand's hammer (m/s) that is as loud as a strike at `speed` (m/s).
///
/// The softest and the loudest strike of an instrument with these conventions map to a grand's
/// softest and loudest tone, and those between logarithmically, as loudness is heard.
pub fn hammer_speed(midi: &MidiTable, speed: f64) -> f64 {
    /// Softest and loudest tone of a grand (m/s) (Goebl, Bresin & Galembo 2005).
    const TONES: (f64, f64) = (0.18, 6.8);
    let Some((softest, loudest)) = midi.speeds else { return speed };
    let place = (speed.max(f64::MIN_POSITIVE) / softest).ln() / (loudest / softest).ln();
    TONES.0 * (TONES.1 / TONES.0).powf(place)
}

/// The sound of a guard that fires.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Sounding {
    /// Speed of the strike (m/s).
    pub speed: f64,
}
