//! A description in TOML, read into a [`Mechanism`] with all its mistakes at once.
//!
//! [`read`] is the entry. In the order of processing: `documents::toml` and `bases` build one tree,
//! `rigid` expands rigid contacts, `time` adds the coordinate `t`, `declare` collects every name
//! with its expressions, `order` sorts items by their needs, `geometry`, `laws` and `modes` build
//! nodes, `checks` tests numbers.

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
mod plausible;
mod presets;
mod reachable;
mod reader;
mod resolve;
mod rest;
mod rigid;
mod time;
mod toml_making;
mod world_frame;

pub use bases::Bases;
pub use caret::rendered;

use documents::toml::TomlSource;
use documents::{Diagnostic, Diagnostics};

use crate::kane::mechanism::Mechanism;

/// Longest accepted description (bytes).
pub const LONGEST: usize = 1 << 20;

/// Most coordinates, and most further speeds: a state has 64 entries at most.
pub const MOST_COORDINATES: usize = 64;

/// Most items of every kind except expressions.
pub const MOST_OF_A_KIND: usize = 256;

pub const MOST_EXPRESSIONS: usize = 4_096;

/// Description after reading, and its sources.
#[derive(Clone, Debug)]
pub struct Description {
    pub mechanism: Mechanism,
    /// Paragraphs about it: figure, sources, limits of validity.
    pub doc: String,
    /// Description's text, then its bases', each after the text that starts from it.
    pub sources: Vec<TomlSource>,
}

/// Reads the description `text`; `name` appears in mistakes and is passed to `bases`.
///
/// # Errors
/// All detected mistakes.
pub fn read(name: &str, text: &str, bases: &dyn Bases) -> Result<Description, Diagnostics> {
    if text.len() > LONGEST {
        return Err(refused(name, &format!("this is {} bytes long", text.len())));
    }
    let source = TomlSource { name: name.to_owned(), text: text.to_owned() };
    reader::MechanismReader::default().read(source, bases)
}

/// Reads a description from any bytes.
///
/// # Errors
/// Those of [`read`]; bytes that are not text.
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
