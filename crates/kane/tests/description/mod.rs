//! Descriptions: what is read, and what is said about mistakes.

mod builtin;

use kane::description::{Description, NoBases, read, rendered};

/// Reads a text that has no mistake.
#[track_caller]
pub(crate) fn good(text: &str) -> Description {
    match read("test.toml", text, &NoBases) {
        Ok(description) => description,
        Err(mistakes) => {
            let name = "test.toml".to_owned();
            let source = kane::description::DescriptionSource { name, text: text.to_owned() };
            panic!("{}", rendered(&mistakes, &[source]))
        }
    }
}
