//! What is wrong in a file, where, and what to do about it.
//!
//! [`Diagnostic`] is one mistake with its line and column, [`Diagnostics`] all of one file;
//! [`rendered`] shows them with their lines; [`choice`] and [`nearest`] say which name was probably
//! meant; [`shown`] and [`quoted`] make names fit to be printed; [`open_input`] opens the file in the
//! first place, and [`toml`] reads it if it is TOML.

mod caret;
mod diagnostic;
#[cfg(unix)]
mod input;
mod shown;
mod suggest;
pub mod toml;

pub use caret::rendered;
pub use diagnostic::{Diagnostic, Diagnostics};
#[cfg(unix)]
pub use input::{open_input, read_input};
pub use shown::{escaped, is_unprintable, shown};
pub use suggest::{choice, nearest, quoted, shortened};
