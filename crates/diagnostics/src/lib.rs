//! What is wrong in a file, where, and what to do about it.
//!
//! [`Diagnostic`] is one mistake with its line and column, [`Diagnostics`] all of one file;
//! [`rendered`] shows them with their lines; [`choice`] and [`nearest`] say which name was probably
//! meant.

mod caret;
mod diagnostic;
mod suggest;

pub use caret::rendered;
pub use diagnostic::{Diagnostic, Diagnostics};
pub use suggest::{choice, nearest, quoted};
