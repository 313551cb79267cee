//! What is wrong in a file, where, and what to do about it.
//!
//! [`Diagnostic`] is one mistake with its line and column, [`Diagnostics`] all of one file;
//! [`choice`] and [`nearest`] say which name was probably meant.

mod diagnostic;
mod suggest;

pub use diagnostic::{Diagnostic, Diagnostics};
pub use suggest::{choice, nearest, quoted};
