//! What is wrong in a file, where, and what to do about it.
//!
//! [`Diagnostic`] is one mistake with its line and column, [`Diagnostics`] all of one file;
//! [`rendered`] shows them with their lines; [`choice`] and [`nearest`] say which name was probably
//! meant; [`open_input`] opens the file in the first place.

mod caret;
mod diagnostic;
mod input;
mod suggest;

pub use caret::rendered;
pub use diagnostic::{Diagnostic, Diagnostics};
pub use input::{open_input, read_input};
pub use suggest::{choice, nearest, quoted};
