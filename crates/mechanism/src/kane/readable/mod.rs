//! Readable equations: text in the notation of descriptions, and LaTeX.
//!
//! A larger part that occurs more than once is named, `z1`, `z2` …, and defined once.
//! Every pass is a loop over the graph, so the depth of an expression uses no stack.

mod names;
mod notation;
mod system;
mod words;
mod writer;

pub use names::SymbolNames;
pub use notation::Notation;
pub use system::{mode_equations, system_equations};
pub use writer::{Equation, equations, expression};
