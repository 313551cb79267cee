//! The name of a mode, as text.

use core::fmt;

use pode::contacts::ContactState;

use crate::equations::table::Equations as _;
use crate::model::equation_model::decoded;
use crate::model::mode_code::ModeCode;
use crate::model::parts::ModelParts;

/// Writes a structural mode and its contacts that are not open, `B1 string=closed`; `?` if unknown.
#[derive(Clone, Copy, Debug)]
pub struct ModeName<'a> {
    pub model: &'a ModelParts,
    pub mode: ModeCode,
}

impl fmt::Display for ModeName<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let specs = &self.model.table().automata.contacts;
        let mode = self.model.modes.get(usize::from(self.mode.structure()));
        let contacts = decoded(self.mode.contacts(), specs.len());
        let Some((mode, contacts)) = mode.zip(contacts) else { return f.write_str("?") };
        f.write_str(mode.name)?;
        for contact in contacts.closed() {
            let name = specs.get(contact).map_or("?", |contact| contact.name);
            write!(f, " {name}={}", word(contacts.state(contact)))?;
        }
        Ok(())
    }
}

const fn word(state: ContactState) -> &'static str {
    match state {
        ContactState::Open => "open",
        ContactState::Closed => "closed",
        ContactState::Stick => "stick",
        ContactState::SlideUp => "up",
        ContactState::SlideDown => "down",
    }
}
