//! Mistakes in a file: their position, message and remedy.
//!
//! [`Diagnostic`] is one mistake, [`Diagnostics`] all of one file, and [`rendered`] shows them.
//! [`choice`] and [`nearest`] suggest a known name; [`shown`] and [`quoted`] make names printable.
//! [`open_input`] opens the file, and [`toml`] reads TOML with positions.

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
