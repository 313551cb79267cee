//! The number of each guard of a model.

use std::collections::HashMap;

use super::AssemblyError;
use crate::kane::mechanism::Fires;
use crate::kane::system::{GuardEquations, ModeEquations};

/// The number of each guard: one for all guards of one name that are watched alike.
#[derive(Debug, Default)]
pub(super) struct GuardNumbers {
    numbers: HashMap<(String, u64, u8, bool), u8>,
}

impl GuardNumbers {
    pub(super) fn of(modes: &[ModeEquations]) -> Result<Self, AssemblyError> {
        let mut numbers = Self::default();
        for guard in modes.iter().flat_map(|mode| &mode.guards) {
            let next = numbers.numbers.len();
            let number = u8::try_from(next).ok().ok_or(AssemblyError::TooManyGuards(next))?;
            numbers.numbers.entry(key(guard)).or_insert(number);
        }
        Ok(numbers)
    }

    /// The number of `guard`; the last one if it is none of them.
    pub(super) fn number(&self, guard: &GuardEquations) -> u8 {
        self.numbers.get(&key(guard)).copied().unwrap_or(u8::MAX)
    }
}

fn key(guard: &GuardEquations) -> (String, u64, u8, bool) {
    let on_crossing = guard.fires == Fires::OnCrossing;
    (guard.name.clone(), guard.scale.to_bits(), guard.priority, on_crossing)
}
