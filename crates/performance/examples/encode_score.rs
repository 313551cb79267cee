//! Encodes a written score as a MIDI file: `encode_score FILE.score [FILE.mid]`.
//!
//! The notation is explained in `configs/performances/README.md`. Without a second name, the
//! MIDI file stands beside the score. For both pieces that come with Letoff:
//!
//! ```text
//! cargo run -p performance --example encode_score -- configs/performances/bach-bwv-846.score
//! ```

use std::error::Error;
use std::path::{Path, PathBuf};
use std::{env, fs};

mod notation;

fn main() -> Result<(), Box<dyn Error>> {
    let mut arguments = env::args().skip(1);
    let usage = "usage: encode_score FILE.score [FILE.mid]";
    let source = PathBuf::from(arguments.next().ok_or(usage)?);
    let target = arguments.next().map_or_else(|| source.with_extension("mid"), PathBuf::from);
    encode(&source, &target)
}

fn encode(source: &Path, target: &Path) -> Result<(), Box<dyn Error>> {
    let text = fs::read_to_string(source)
        .map_err(|error| format!("{} cannot be read: {error}", source.display()))?;
    let bytes = notation::encode(&text).map_err(|error| format!("{}:{error}", source.display()))?;
    fs::write(target, bytes)
        .map_err(|error| format!("{} cannot be written: {error}", target.display()))?;
    Ok(())
}
