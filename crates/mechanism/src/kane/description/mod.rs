//! A description in TOML, read into a [`Mechanism`] with all its mistakes at once.
//!
//! [`read`] is the door. In the order in which a file passes: `documents::toml` and `bases`
//! make one tree, `rigid` writes out what rigid contacts mean, `declare` collects every name with its
//! expressions, `order` sorts what is built from what, `geometry`, `laws` and `modes` build nodes,
//! `checks` looks at the numbers.

mod bases;
mod caret;
mod checks;
mod configurations;
mod declare;
mod declare_geometry;
mod drawing;
mod expressions;
mod geometry;
mod guards;
mod items;
mod law_texts;
mod laws;
mod linear;
mod midi;
mod modes;
mod names;
mod names_in_use;
mod order;
mod outlines;
mod outputs;
mod parameters;
mod presets;
mod reachable;
mod reader;
mod resolve;
mod rest;
mod rigid;
mod toml_making;
mod world_frame;

pub use bases::Bases;
pub use caret::rendered;

use documents::toml::TomlSource;
use documents::{Diagnostic, Diagnostics};

use crate::kane::mechanism::Mechanism;

/// Longest description that is read (bytes).
pub const LONGEST: usize = 1 << 20;

/// Most coordinates, and most speeds of their own: a state has 64 entries at most.
pub const MOST_COORDINATES: usize = 64;

/// Most of every other kind of thing but expressions.
pub const MOST_OF_A_KIND: usize = 256;

/// Most expressions in a description.
pub const MOST_EXPRESSIONS: usize = 4_096;

/// A description that was read, and what it was read from.
#[derive(Clone, Debug)]
pub struct Description {
    pub mechanism: Mechanism,
    /// Paragraphs about it: figure, sources, where it stops being true.
    pub doc: String,
    /// The description's text, then its bases', each after the one that starts from it.
    pub sources: Vec<TomlSource>,
}

/// Reads the description `text`; `name` stands in mistakes and is given to `bases`.
///
/// # Errors
///
/// All mistakes that can be told.
pub fn read(name: &str, text: &str, bases: &dyn Bases) -> Result<Description, Diagnostics> {
    if text.len() > LONGEST {
        return Err(refused(name, &format!("this is {} bytes long", text.len())));
    }
    let source = TomlSource { name: name.to_owned(), text: text.to_owned() };
    reader::MechanismReader::default().read(source, bases)
}

/// Reads a description from bytes, whatever they are.
///
/// # Errors
///
/// As of [`read`]; bytes that are no text.
pub fn read_bytes(name: &str, bytes: &[u8], bases: &dyn Bases) -> Result<Description, Diagnostics> {
    if bytes.len() > LONGEST {
        return Err(refused(name, &format!("this is {} bytes long", bytes.len())));
    }
    match str::from_utf8(bytes) {
        Ok(text) => read(name, text, bases),
        Err(error) => {
            let before = str::from_utf8(bytes.get(..error.valid_up_to()).unwrap_or(&[]));
            let line = before.unwrap_or("").matches('\n').count() + 1;
            let message = format!("this is not UTF-8 text from line {line} on");
            Err(refused(name, &message))
        }
    }
}

fn refused(name: &str, message: &str) -> Diagnostics {
    let help = format!("give a description in TOML, up to {LONGEST} bytes");
    let file = name.to_owned();
    Diagnostics::new(vec![Diagnostic {
        file,
        line: None,
        column: None,
        message: message.to_owned(),
        help,
    }])
}
