//! From a system to what runs: a model's table, and one tape per function.
//!
//! Expressions of the parameters alone are found once, when the model is made; everything else is
//! a function of constants, state and input.

mod builder;
mod contacts;
mod drawing;
mod error;
mod functions;
mod guard_numbers;
mod guards;
mod hoist;
mod jacobian;
mod kinds;
mod mechanics;
mod modes;
mod moving;
mod names;
mod parts;
mod switches;
mod table;

pub use error::AssemblyError;
pub use functions::TapeFunctions;
pub(in crate::kane) use switches::stays_at_zero;

use instruments::equations::table::{Arguments, Equations, FunctionId, Functions, ModelTable};

use crate::kane::system::EquationSystem;
use crate::kane::tape::Tape;

/// What runs: all of a model but its arithmetic, and that arithmetic function by function.
#[derive(Clone, Debug)]
pub struct Program {
    pub table: ModelTable,
    pub functions: TapeFunctions,
    /// What each function is for: `B1_derivative`.
    pub names: Vec<String>,
    /// Work that reading, deriving and assembling took: of at most [`crate::kane::graph::MAX_WORK`].
    pub work: u64,
}

impl Program {
    pub fn tapes(&self) -> &[Tape] {
        self.functions.tapes()
    }
}

impl Functions for Program {
    fn call(&self, function: FunctionId, arguments: &Arguments<'_>, out: &mut [f64]) {
        self.functions.call(function, arguments, out);
    }
}

impl Equations for Program {
    fn table(&self) -> &ModelTable {
        &self.table
    }
}

impl EquationSystem {
    /// Makes the program of the system.
    ///
    /// # Errors
    /// A system that is larger than a model can be, or that is not complete.
    pub fn assemble(self) -> Result<Program, AssemblyError> {
        table::assemble(self)
    }
}
