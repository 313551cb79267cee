//! What arguments are called in emitted code.

use equations::table::ModelTable;

use super::names::Identifiers;
use crate::tape::Argument;

/// What the arguments of a model's functions are called.
#[derive(Clone, Debug)]
pub(super) struct ArgumentNames {
    constants: Vec<String>,
    state: Vec<String>,
    input: [String; 4],
    /// What else is taken: names of one function start here.
    pub(super) taken: Identifiers,
}

impl ArgumentNames {
    pub(super) fn new(table: &ModelTable) -> Self {
        let mut taken = Identifiers::new();
        let mut constants: Vec<_> = table.parameters.iter().map(|it| taken.take(it.name)).collect();
        let state = table.states.iter().map(|it| taken.take(it.name)).collect();
        let stem = if table.input.name.is_empty() { "s" } else { table.input.name };
        let input = ["", "'", "''", "'''"].map(|rate| taken.take(&format!("{stem}{rate}")));
        let derived = constants.len()..table.constants;
        constants.extend(derived.map(|number| taken.take(&format!("c{number}"))));
        Self { constants, state, input, taken }
    }

    /// Returns the argument's name, and the expression that reads it; without a name it is both.
    pub(super) fn of(&self, argument: Argument) -> (String, String) {
        let named = |names: &[String], kind: &str, at: usize| {
            let name = names.get(at).cloned().unwrap_or_else(|| format!("{kind}_{at}"));
            (name, format!("{kind}[{at}]"))
        };
        match argument {
            Argument::Constant(at) => named(&self.constants, "constants", at.into()),
            Argument::State(at) => named(&self.state, "state", at.into()),
            Argument::Input(at) => named(&self.input, "input", at.into()),
            Argument::Extra(at) => (format!("extra[{at}]"), format!("extra[{at}]")),
        }
    }
}
