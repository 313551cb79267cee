//! `letoff check FILE`: checks a scene, an instrument, a description of a model or a MIDI file.

use std::io::Write;
use std::path::{Path, PathBuf};

use clap::Args;
use documents::shown;
use serde_json::json;

use super::stable::check_stability;
use super::{Failure, piece, print_json};
use scene::{FileKind, Instrument, Library, check_file};

/// What `letoff check` takes.
#[derive(Clone, Debug, Args)]
#[command(after_help = "Example:
  letoff check my-scene.toml my-action.toml song.mid")]
pub struct CheckArgs {
    /// The scenes, instruments, descriptions of models or MIDI files to check.
    #[arg(required = true)]
    pub files: Vec<PathBuf>,
    /// Prints the mistakes as JSON, and what is in MIDI files.
    #[arg(long)]
    pub json: bool,
}

pub(super) fn run(args: &CheckArgs, out: &mut dyn Write) -> Result<(), Failure> {
    let library = Library::default();
    let (mut wrong, mut pieces) = (Vec::new(), Vec::new());
    for file in &args.files {
        match check_file(&library, file) {
            Ok(FileKind::Scene) => match check_stability(file) {
                Ok(_) if args.json => {}
                Ok(ranges) => {
                    writeln!(out, "{}: a good scene", shown(file))?;
                    for range in ranges {
                        writeln!(out, "  {range}")?;
                    }
                }
                Err(diagnostics) => wrong.push(diagnostics),
            },
            Ok(FileKind::Piece) => {
                let (words, report) = piece::contents(file)?;
                if !args.json {
                    writeln!(out, "{words}")?;
                }
                pieces.push(report);
            }
            Ok(_) if args.json => {}
            Ok(kind) => {
                writeln!(out, "{}: a good {}", shown(file), kind.name())?;
                if kind == FileKind::Instrument {
                    base_note(&library, file, out)?;
                }
            }
            Err(diagnostics) => wrong.push(diagnostics),
        }
    }
    if args.json {
        let checked: Vec<_> = wrong.iter().map(|it| json!(it)).chain(pieces).collect();
        print_json(&checked, out)?;
    }
    if wrong.is_empty() {
        return Ok(());
    }
    let texts: Vec<_> = wrong.iter().map(mechanism::rendered).collect();
    Err(Failure::Usage(format!("{} wrong:\n{}", files(wrong.len()), texts.join("\n"))))
}

/// Reports an instrument whose base has changed since it was saved.
fn base_note(library: &Library, file: &Path, out: &mut dyn Write) -> Result<(), Failure> {
    let instrument = Instrument::load(library, &file.to_string_lossy());
    let based = instrument.ok().and_then(|it| it.based);
    if let Some(based) = based.filter(|it| it.has_changed) {
        let base = based.base;
        writeln!(
            out,
            "  plays as saved: {base} has changed since; remove [base_values] to follow it"
        )?;
    }
    Ok(())
}

fn files(n: usize) -> String {
    if n == 1 { "1 file is".to_owned() } else { format!("{n} files are") }
}
