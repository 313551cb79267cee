//! What of a voice goes on in the voice that takes its place.

use models::catalogue::ModelEntry;
use models::{ModeCode, Playable};
use scheduler::observation::ModelSnapshot;

use crate::damper::DamperTracker;
use crate::input::InputPath;

/// What a voice knows beyond its model's mode and state: its model, its key, and its damper.
#[derive(Clone, Copy, Debug)]
pub struct KeyMemory {
    /// The model in its version.
    pub entry: &'static ModelEntry,
    /// From samples to the model's input.
    pub input: InputPath,
    /// Whether the key has lifted the damper.
    pub damper: DamperTracker,
}

/// Takes over into `state`, of the model of `own`, what the model of `entry` as it was `seen` has by
/// the same names and units; the rest stays as it is.
///
/// # Real-time
/// At most 32 × 32 names are compared.
pub(crate) fn carry(
    state: &mut [f64],
    own: &ModelEntry,
    (entry, seen): (&ModelEntry, &ModelSnapshot),
) {
    let names = own.states.iter().zip(own.state_units);
    for (place, wanted) in state.iter_mut().zip(names) {
        let mut others = entry.states.iter().zip(entry.state_units).zip(seen.state);
        let same = others.find(|(name_and_unit, _)| *name_and_unit == wanted);
        if let Some((_, value)) = same.filter(|(_, value)| value.is_finite()) {
            *place = value;
        }
    }
}

/// Returns the mode of `model` that is called as the structural mode `number` of `entry`.
///
/// # Real-time
/// The names of modes are compared.
pub(crate) fn same_mode<M: Playable>(model: &M, entry: &ModelEntry, number: u8) -> Option<M::Mode> {
    let name = entry.modes.get(usize::from(number))?.name;
    let index = model.entry().modes.iter().position(|mode| mode.name == name)?;
    model.mode(ModeCode::structural(u8::try_from(index).ok()?))
}
