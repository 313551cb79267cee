//! `letoff recover FILE`: copies the readable part of a truncated recording.

use std::fs;
use std::io::Write;
use std::path::{Path, PathBuf};

use clap::Args;
use documents::{escaped, shown};
use serde::Serialize;
use telemetry::recording::{RecordError, RecoverError, Recovered, recover};

use super::{Failure, print_report};

/// What `letoff recover` takes.
#[derive(Clone, Debug, Args)]
#[command(after_help = "Examples:
  letoff recover take1.mcap                   makes take1-recovered.mcap of what can be read
  letoff recover take1.mcap --into whole.mcap
  letoff recover take1.mcap --into take1.mcap --overwrite")]
pub struct RecoverArgs {
    /// The recording that breaks off; if it has several files, the one that does.
    #[arg(value_name = "FILE.mcap")]
    pub file: PathBuf,
    /// Where to; FILE-recovered.mcap without.
    #[arg(long, value_name = "OUT.mcap")]
    pub into: Option<PathBuf>,
    /// Takes the place of a file that is there, once it is complete.
    #[arg(long)]
    pub overwrite: bool,
    /// Prints what was saved as JSON.
    #[arg(long)]
    pub json: bool,
}

#[derive(Debug, Serialize)]
struct Saved {
    file: String,
    messages: u64,
    /// Time from the first to the last message (s).
    seconds: f64,
    /// Unusable rest at the old file's end (B).
    cut_bytes: u64,
    /// Damaged pieces, up to a second each.
    damaged: u64,
    wrong: Vec<String>,
}

pub(super) fn run(args: &RecoverArgs, out: &mut dyn Write) -> Result<(), Failure> {
    let into = args.into.clone().unwrap_or_else(|| beside(&args.file, "-recovered"));
    let recovered = if args.overwrite {
        replace(&args.file, &into)?
    } else {
        recover(&args.file, &into).map_err(|error| failure(&error))?
    };
    let saved = Saved::new(&into, recovered);
    if args.json { print_report(&saved, out) } else { print(&saved, &args.file, out) }
}

/// Returns `take1-recovered.mcap` for `take1.mcap`.
fn beside(file: &Path, suffix: &str) -> PathBuf {
    let mut name = file.file_stem().unwrap_or_default().to_owned();
    name.push(suffix);
    name.push(".");
    name.push(file.extension().unwrap_or_else(|| "mcap".as_ref()));
    file.with_file_name(name)
}

/// Writes the readable part of `file` to `into`, which may exist and may be `file` itself: it is
/// replaced only when the new file is complete and on the disk.
fn replace(file: &Path, into: &Path) -> Result<Recovered, Failure> {
    // The name contains the process id, so the rest of a killed process does not interfere.
    let unfinished = beside(into, &format!("-unfinished-{}", std::process::id()));
    let recovered = recover(file, &unfinished).map_err(|error| failure(&error))?;
    fs::rename(&unfinished, into).map_err(|error| {
        Failure::Running(format!(
            "{} cannot take the place of {}: {error}; move it there yourself",
            shown(&unfinished),
            shown(into)
        ))
    })?;
    Ok(recovered)
}

fn failure(error: &RecoverError) -> Failure {
    let text = error.to_string();
    match error {
        RecoverError::Open(_)
        | RecoverError::Nothing(_)
        | RecoverError::Record(RecordError::Exists(_) | RecordError::Create { .. }) => {
            Failure::Usage(text)
        }
        RecoverError::Record(
            RecordError::Write { .. }
            | RecordError::Remove { .. }
            | RecordError::LowDisk { .. }
            | RecordError::NoRoom { .. }
            | RecordError::NoSuchKey { .. }
            | RecordError::Ended,
        ) => Failure::Running(text),
    }
}

impl Saved {
    fn new(file: &Path, recovered: Recovered) -> Self {
        let Recovered { messages, span, cut, damaged, wrong } = recovered;
        let nanos = span.map_or(0, |(first, last)| last - first);
        Self {
            file: file.to_string_lossy().into_owned(),
            messages,
            seconds: nanos as f64 / 1e9,
            cut_bytes: cut,
            damaged,
            wrong,
        }
    }

    fn losses(&self) -> Vec<String> {
        let pieces = match self.damaged {
            0 => None,
            1 => Some("a damaged piece, of up to a second".to_owned()),
            several => Some(format!("{several} damaged pieces, of up to a second each")),
        };
        let end = (0 < self.cut_bytes)
            .then(|| format!("{} bytes at the end, and what came after them", self.cut_bytes));
        pieces.into_iter().chain(end).collect()
    }
}

fn print(it: &Saved, old: &Path, out: &mut dyn Write) -> Result<(), Failure> {
    writeln!(out, "{}: {} messages of {:.1} s", escaped(&it.file), it.messages, it.seconds)?;
    for wrong in &it.wrong {
        writeln!(out, "  {wrong}")?;
    }
    let losses = it.losses();
    if it.wrong.is_empty() && losses.is_empty() {
        writeln!(out, "  {} was complete, and this is a copy of it", shown(old))?;
    } else if losses.is_empty() {
        writeln!(out, "  nothing of what it had was lost")?;
    } else {
        writeln!(out, "  lost: {}", losses.join("; "))?;
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_was_lost_is_said_in_pieces_and_bytes() {
        let of = |cut, damaged| {
            let recovered = Recovered { cut, damaged, ..Recovered::default() };
            Saved::new(Path::new("a"), recovered).losses().join("; ")
        };
        assert_eq!(of(0, 0), "");
        assert_eq!(of(0, 1), "a damaged piece, of up to a second");
        assert_eq!(
            of(7, 2),
            "2 damaged pieces, of up to a second each; 7 bytes at the end, and what came after them"
        );
    }
}
