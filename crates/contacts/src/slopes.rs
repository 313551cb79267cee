//! How the readout of a mechanism with contacts goes on for a moment.

use crate::{ContactSystem, WithContacts};
use pode::{Motion, Sloped};

/// By central differences, with the contacts as they are.
impl<M: ContactSystem<Input = Motion>> Sloped for WithContacts<M> {}
