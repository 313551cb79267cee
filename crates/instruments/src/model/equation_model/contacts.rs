//! Models with contacts: a mode is a structural mode, and the state of each contact.

use alloc::sync::Arc;

use crate::equations::table::MAX_CODED_CONTACTS;
use crate::equations::{EquationModel, ModeNumber};
use pode::contacts::{
    ContactGuard, ContactMode, ContactSet, ContactState, ContactSystem as _, MAX_CONTACTS,
    SlipKind, WithContacts,
};
use pode::{GuardId, Motion};

use crate::model::describe::{Described, NamedModes, Playable, Sounding};
use crate::model::draw::Sketch;
use crate::model::mode_code::ModeCode;
use crate::model::parts::ModelParts;

/// States of a contact in the order of their digits.
const STATES: [ContactState; 5] = [
    ContactState::Open,
    ContactState::Closed,
    ContactState::Stick,
    ContactState::SlideUp,
    ContactState::SlideDown,
];

/// Encodes the states of `count` contacts as a number to the base 5, the first contact last.
fn code(contacts: &ContactSet, count: usize) -> u64 {
    let digit = |contact| {
        let state = contacts.state(contact);
        (0..).zip(STATES).find(|(_, it)| *it == state).map_or(0, |(digit, _)| digit)
    };
    let digits = (0..count.min(MAX_CODED_CONTACTS)).rev().map(digit);
    digits.fold(0, |code: u64, digit: u64| 5 * code + digit)
}

/// Decodes the states of `count` contacts; `None` if the code has more contacts.
pub(in crate::model) fn decoded(code: u64, count: usize) -> Option<ContactSet> {
    let (mut set, mut rest) = (ContactSet::OPEN, code);
    for contact in 0..count.min(MAX_CODED_CONTACTS) {
        let digit = usize::from((rest % 5).to_le_bytes()[0]);
        set = set.with(contact, STATES.get(digit).copied().unwrap_or(ContactState::Open));
        rest /= 5;
    }
    (rest == 0).then_some(set)
}

impl<const N: usize, const C: usize> NamedModes
    for WithContacts<EquationModel<Arc<ModelParts>, N, C>>
{
    fn shared(&self) -> &Arc<ModelParts> {
        self.system().shared()
    }

    fn mode_code(&self, mode: ContactMode<ModeNumber>) -> ModeCode {
        let contacts = code(&mode.contacts, self.system().contacts().len());
        ModeCode::with_contacts(mode.structure.0, contacts)
    }

    fn mode(&self, code: ModeCode) -> Option<ContactMode<ModeNumber>> {
        let structure = self.system().mode(ModeCode::structural(code.structure()))?;
        let contacts = decoded(code.contacts(), self.system().contacts().len())?;
        Some(ContactMode { structure, contacts })
    }
}

impl<const N: usize, const C: usize> Described
    for WithContacts<EquationModel<Arc<ModelParts>, N, C>>
{
    fn with_values(&self, values: &[f64]) -> Self {
        Self::new(self.system().with_values(values)).unwrap_or_else(|_unchanged| self.clone())
    }

    fn outputs(
        &self,
        mode: ContactMode<ModeNumber>,
        x: &[f64; N],
        input: &Motion,
        out: &mut [f64],
    ) {
        let mut frictions = [0.0; MAX_CONTACTS];
        for (contact, force) in self.friction_forces(mode, x, input).iter() {
            if let Some(slot) = frictions.get_mut(contact) {
                *slot = force;
            }
        }
        self.system().outputs_with(mode.structure, (x, input), &frictions, out);
    }

    fn unmet(&self, report: &mut dyn FnMut(&str)) {
        Described::unmet(self.system(), report);
    }

    /// Closes contacts that overlap at rest; those with friction stick, switches have their side.
    fn at_rest(&self, input: &Motion) -> (ContactMode<ModeNumber>, [f64; N]) {
        let system = self.system();
        let (structure, x) = system.at_rest(input);
        let mut contacts = ContactSet::OPEN;
        for (number, contact) in system.contacts().iter().enumerate() {
            let is_apart = system.gap(structure, number, &x, input).value >= 0.0;
            let state = match (contact.gap, contact.friction) {
                (Some(_), _) if is_apart => ContactState::Open,
                (_, Some(it)) if it.kind == SlipKind::Condition => {
                    self.start(structure, &x, input).0.contacts.state(number)
                }
                (_, Some(_)) => ContactState::Stick,
                (_, None) => ContactState::Closed,
            };
            contacts = contacts.with(number, state);
        }
        (ContactMode { structure, contacts }, x)
    }

    fn begin(
        &self,
        mode: ContactMode<ModeNumber>,
        x: &[f64; N],
        input: &Motion,
    ) -> (ContactMode<ModeNumber>, [f64; N]) {
        self.start(mode.structure, x, input)
    }
}

impl<const N: usize, const C: usize> Playable
    for WithContacts<EquationModel<Arc<ModelParts>, N, C>>
{
    fn input_per_metre(&self) -> f64 {
        self.system().input_per_metre()
    }

    fn sounding(&self, guard: GuardId, before: &[f64; N]) -> Option<Sounding> {
        match ContactGuard::of(guard) {
            ContactGuard::Structure(guard) => Playable::sounding(self.system(), guard, before),
            ContactGuard::Gap(contact) => {
                let speed = self.system().contact_sounding(contact, before);
                speed.map(|speed| Sounding { speed })
            }
            ContactGuard::Friction(_) => None,
        }
    }

    fn draw(&self, sketch: &mut dyn Sketch) {
        self.system().draw(sketch);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_code_has_the_state_of_every_contact() {
        let mut set = ContactSet::OPEN;
        for (contact, state) in STATES.iter().cycle().take(MAX_CODED_CONTACTS).enumerate() {
            set = set.with(contact, *state);
        }
        let number = code(&set, MAX_CODED_CONTACTS);
        assert!(number < 1 << 56, "it fits beside the structural mode");
        assert_eq!(decoded(number, MAX_CODED_CONTACTS), Some(set));
        assert_eq!(decoded(number, MAX_CODED_CONTACTS - 1), None, "of more contacts");
        assert_eq!(code(&ContactSet::OPEN, 7), 0);
    }
}
