//! Data that all voices of a model share.

use core::ops::Deref;

use crate::equations::table::{Arguments, Equations, FunctionId, Functions, ModelTable};

use crate::model::entry::{ModelEntry, SharedFunctions};

/// Constant parts of a model, shared by all its voices.
pub struct ModelParts {
    entry: ModelEntry,
    table: ModelTable,
    functions: SharedFunctions,
}

impl ModelParts {
    pub(crate) const fn new(
        entry: ModelEntry,
        table: ModelTable,
        functions: SharedFunctions,
    ) -> Self {
        Self { entry, table, functions }
    }
}

impl Deref for ModelParts {
    type Target = ModelEntry;

    fn deref(&self) -> &ModelEntry {
        &self.entry
    }
}

impl core::fmt::Debug for ModelParts {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        f.debug_tuple("ModelParts").field(&self.entry.name).finish()
    }
}

impl Functions for ModelParts {
    #[inline]
    fn call(&self, function: FunctionId, arguments: &Arguments<'_>, out: &mut [f64]) {
        self.functions.call(function, arguments, out);
    }
}

impl Equations for ModelParts {
    #[inline]
    fn table(&self) -> &ModelTable {
        &self.table
    }
}
