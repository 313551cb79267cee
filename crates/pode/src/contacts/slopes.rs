use crate::contacts::{ContactMode, GuardedContacts, WithContacts};
use crate::{Model, Motion, ReadoutSlopes, Sloped, differenced_slopes};

/// In the present contacts: the system's own slopes, otherwise central differences.
impl<M: GuardedContacts<Input = Motion>> Sloped for WithContacts<M> {
    fn slopes(
        &self,
        mode: ContactMode<M::Structure>,
        x: &<Self as Model>::State,
        input: &Motion,
    ) -> ReadoutSlopes {
        let known = self.system().slopes(mode.structure, mode.contacts, x, input);
        known.unwrap_or_else(|| differenced_slopes(self, mode, x, input))
    }
}
