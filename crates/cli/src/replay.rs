//! `letoff replay FILE`: a recording, run again and compared.

use std::io::Write;
use std::path::{Path, PathBuf};

use clap::Args;
use diagnostics::shown;
use indicatif::{ProgressBar, ProgressStyle};
use telemetry::recording::{ReadError, Recording, Selection, export_csv};

use super::{Failure, print_report, tell};
use host::replay::{MissingTicks, Replayed, ResumedTicks, replay};

/// What `letoff replay` takes.
#[derive(Clone, Debug, Args)]
#[command(after_help = "Examples:
  letoff replay take1.mcap                    runs it again; says the first bit that differs
  letoff replay take1.mcap --export take1     keys and events as CSV files in a folder")]
pub struct ReplayArgs {
    /// The recording to replay.
    #[arg(value_name = "FILE.mcap")]
    pub file: PathBuf,
    /// Writes it as CSV into this folder instead.
    #[arg(long, value_name = "FOLDER")]
    pub export: Option<PathBuf>,
    /// Prints what came of it as JSON.
    #[arg(long)]
    pub json: bool,
}

/// Runs a recording again, or exports it.
pub(super) fn run(args: &ReplayArgs, out: &mut dyn Write) -> Result<(), Failure> {
    let usage = |error: &dyn std::fmt::Display| Failure::Usage(error.to_string());
    let recording = Recording::open(&args.file).map_err(|error| usage(&error))?;
    if let Some(tear) = recording.tear() {
        tell(&tear.to_string());
    }
    if let Some(folder) = &args.export {
        return export(&recording, folder, out);
    }
    let line = ProgressBar::new_spinner();
    line.set_style(
        ProgressStyle::with_template("{spinner} {pos} ticks")
            .unwrap_or_else(|_| ProgressStyle::default_spinner()),
    );
    let messages = recording.messages().filter_map(|message| match message {
        Ok((_at, update)) => Some(Ok(update)),
        Err(ReadError::Missing(piece)) if piece.is_said_again() => {
            tell(&format!("{piece}; it is said again elsewhere, and nothing is missing"));
            None
        }
        Err(error) => Some(Err(error.to_string())),
    });
    let replayed = replay(messages, |ticks| line.set_position(ticks));
    line.finish_and_clear();
    let replayed = replayed.map_err(|error| usage(&error))?;
    if args.json {
        print_report(&replayed, out)?;
    } else {
        print(&replayed, out)?;
    }
    match &replayed.first_difference {
        None => Ok(()),
        Some(first) => Err(Failure::Running(format!(
            "{} of {} messages are not the same; the first: {first}",
            replayed.different, replayed.compared
        ))),
    }
}

fn print(it: &Replayed, out: &mut dyn Write) -> Result<(), Failure> {
    let Replayed { scene, ticks, recorded, compared, strikes, faults, .. } = it;
    writeln!(out, "{scene}: {ticks} ticks run again, {strikes} strikes, {faults} faults")?;
    if it.first_difference.is_none() {
        writeln!(
            out,
            "  {compared} messages compared: forces, events and MIDI are the same to the last bit"
        )?;
    }
    for missing in &it.missing {
        writeln!(out, "  {}", words(missing))?;
        if let Some(behind) = &missing.behind {
            writeln!(out, "  {}", words_behind(behind))?;
        }
    }
    match (it.incomplete_from, it.missing.is_empty()) {
        (Some(tick), true) => writeln!(
            out,
            "  from tick {tick} on it does not tell all that decided, so that nothing could be \
             compared: {ticks} of {recorded} ticks were"
        )?,
        (Some(tick), false) => writeln!(
            out,
            "  from tick {tick} on nothing could be compared to the last bit: what voices were like \
             behind what is missing is not in it; {ticks} of {recorded} ticks were"
        )?,
        (None, _) => {}
    }
    Ok(())
}

/// Returns what is missing, in a sentence.
fn words(missing: &MissingTicks) -> String {
    let MissingTicks { from, from_s, why, .. } = missing;
    match (missing.to, missing.to_s) {
        (Some(to), Some(to_s)) => {
            format!("ticks {from} to {to} ({from_s:.3} s to {to_s:.3} s) are missing: {why}")
        }
        _no_end => format!("what was from tick {from} ({from_s:.3} s) on is missing: {why}"),
    }
}

/// Returns what came of the ticks behind missing ones, in a sentence.
fn words_behind(behind: &ResumedTicks) -> String {
    let ResumedTicks { ticks, compared, agreeing, largest, .. } = behind;
    let found = match (behind.agree_from, behind.agree_from_s) {
        (Some(from), Some(from_s)) => format!("from tick {from} ({from_s:.3} s) on all are"),
        _to_the_end => "at the end not all are".to_owned(),
    };
    let largest = largest.map_or_else(String::new, |it| {
        let key = telemetry::key_name(it.key);
        format!(", the largest difference is {:.3} N ({key} in tick {})", it.newtons, it.tick)
    });
    format!(
        "behind them every voice began anew, at rest where its key was: {ticks} ticks were run, \
         {agreeing} of {compared} forces are within 10 mN of the recorded ones{largest}; {found}"
    )
}

fn export(recording: &Recording, folder: &Path, out: &mut dyn Write) -> Result<(), Failure> {
    std::fs::create_dir_all(folder)
        .map_err(|error| Failure::Usage(format!("{}: {error}", shown(folder))))?;
    let exported = export_csv(recording, folder, &Selection::default());
    let exported = exported.map_err(|error| Failure::Running(error.to_string()))?;
    for wrong in &exported.wrong {
        tell(wrong);
    }
    let (files, rows, events) = (exported.files.len(), exported.rows, exported.events);
    writeln!(out, "{}: {files} files, {rows} rows, {events} events", shown(folder))?;
    Ok(())
}
