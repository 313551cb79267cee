//! The parts of a voice that its successor takes over.

use std::sync::Arc;

use instruments::{ModeCode, ModelEntry, ModelParts, Playable};
use pode::Motion;
use scheduler::observation::ModelSnapshot;

use crate::voice::coupling::Coupling;
use crate::voice::damper::DamperTracker;
use crate::voice::input::InputPath;
use crate::voice::shift::InputShift;

/// A voice's memory beyond its model's mode and state.
#[derive(Clone, Debug)]
pub struct KeyMemory {
    pub model: Arc<ModelParts>,
    pub input: InputPath,
    pub damper: DamperTracker,
    /// Between the player's key and the model's, if there is one.
    pub coupling: Option<Coupling>,
    /// Shift of the model's key from the position of the player's, after a change.
    pub shift: InputShift,
}

impl KeyMemory {
    pub(crate) fn player(&self) -> Motion {
        let newest = self.input.newest();
        Motion { position: newest.position + self.shift.now(), ..newest }
    }

    pub(crate) fn key(&self) -> Motion {
        self.coupling.map_or_else(|| self.player(), |it| it.key())
    }

    /// Continues from the key of `before`, of the same model with other settings.
    pub(crate) fn succeed(&mut self, before: &Self) {
        self.input.succeed(&before.input);
        let at = if self.coupling.is_some() { before.player() } else { before.key() };
        self.shift = InputShift::new(at.position - self.input.newest().position);
        match (&mut self.coupling, &before.coupling) {
            (Some(own), Some(before)) => own.succeed(before),
            (Some(own), None) => own.place(&at),
            (None, _) => {}
        }
    }
}

/// Takes over into `state`, of the model of `own`, the values with equal names and units in the
/// model of `entry` as `seen`; the rest stays unchanged.
///
/// # Real-time
/// At most 32 × 32 names are compared.
pub(crate) fn carry(
    state: &mut [f64],
    own: &ModelEntry,
    (entry, seen): (&ModelEntry, &ModelSnapshot),
) {
    let names = own.states.iter().zip(&own.state_units);
    for (place, wanted) in state.iter_mut().zip(names) {
        let mut others = entry.states.iter().zip(&entry.state_units).zip(seen.state);
        let same = others.find(|(name_and_unit, _)| *name_and_unit == wanted);
        if let Some((_, value)) = same.filter(|(_, value)| value.is_finite()) {
            *place = value;
        }
    }
}

/// Returns the mode of `model` with the name of the structural mode `number` of `entry`.
///
/// # Real-time
/// The names of modes are compared.
pub(crate) fn same_mode<M: Playable>(model: &M, entry: &ModelEntry, number: u8) -> Option<M::Mode> {
    let name = entry.modes.get(usize::from(number))?.name;
    let index = model.entry().modes.iter().position(|mode| mode.name == name)?;
    model.mode(ModeCode::structural(u8::try_from(index).ok()?))
}
