//! Equations for people: text as descriptions are written, and LaTeX.
//!
//! A part that stands more than once and is not small gets a name, `z1`, `z2` …, and is said once.
//! Every pass is a loop over the graph; no depth of an expression goes down the stack.

mod names;
mod notation;
mod system;
mod words;
mod writer;

pub use names::SymbolNames;
pub use notation::Notation;
pub use system::{mode_equations, system_equations};
pub use writer::{Equation, equations, expression};
