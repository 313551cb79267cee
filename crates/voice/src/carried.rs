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

/// Returns the mode and the state from which `model` goes on where one of `entry` is as `seen`:
/// entries of the state are taken over by name and unit, and what the other one does not have is
/// as in `rest`. Where the other's mode is not known by its name, all is as in `rest`.
///
/// # Real-time
/// At most 32 × 32 names, and the names of modes, are compared.
pub(crate) fn carried<M: Playable>(
    model: &M,
    rest: (M::Mode, M::State),
    (entry, seen): (&ModelEntry, &ModelSnapshot),
) -> (M::Mode, M::State) {
    let Some(mode) = same_mode(model, entry, ModeCode(seen.mode)) else { return rest };
    let ModelEntry { states, state_units, .. } = *model.entry();
    let mut state = rest.1;
    for (index, place) in state.as_mut().iter_mut().enumerate() {
        let wanted = (states.get(index), state_units.get(index));
        let others = entry.states.iter().zip(entry.state_units);
        let same =
            others.zip(seen.state).find(|((name, unit), _)| (Some(*name), Some(*unit)) == wanted);
        if let Some((_, value)) = same.filter(|(_, value)| value.is_finite()) {
            *place = value;
        }
    }
    (mode, state)
}

/// Returns the mode of `model` that is called as the mode `code` of `entry`; with the same contacts
/// closed, if both models have the same.
fn same_mode<M: Playable>(model: &M, entry: &ModelEntry, code: ModeCode) -> Option<M::Mode> {
    let modes = model.entry().modes;
    let same = if modes == entry.modes { model.mode(code) } else { None };
    same.or_else(|| {
        let name = entry.modes.get(usize::from(code.structure()))?.name;
        let index = modes.iter().position(|mode| mode.name == name)?;
        model.mode(ModeCode::structural(u8::try_from(index).ok()?))
    })
}
