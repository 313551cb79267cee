//! `letoff replay FILE`: replays and compares a recording, or exports it.

use std::io::Write;
use std::path::{Path, PathBuf};

use clap::Args;
use documents::shown;
use indicatif::{ProgressBar, ProgressStyle};
use midi::{Message, Output as _, Smf};
use telemetry::Update;
use telemetry::recording::{ReadError, Recording, Selection, export_csv};

use super::{Failure, print_report, tell};
use host::replay::{Replayed, replay};
use scene::{MidiOutput, midi_output};

/// What `letoff replay` takes.
#[derive(Clone, Debug, Args)]
#[command(after_help = "Examples:
  letoff replay take1.mcap                    runs it again; says the first bit that differs
  letoff replay take1.mcap --export take1     keys and events as CSV files in a folder
  letoff replay take1.mcap --midi take1.mid   what was played, as a MIDI file

Exit codes: 0 the same to the last bit; 1 a bit differs, or a damaged recording has a hole; 2 wrong
usage, or a file that cannot be replayed.")]
pub struct ReplayArgs {
    /// The recording to replay.
    #[arg(value_name = "FILE.mcap")]
    pub file: PathBuf,
    /// Writes it as CSV into this folder instead.
    #[arg(long, value_name = "FOLDER")]
    pub export: Option<PathBuf>,
    /// Writes the MIDI messages of the recording into this file instead.
    #[arg(long, value_name = "FILE.mid", conflicts_with = "export", value_parser = midi_file)]
    pub midi: Option<PathBuf>,
    /// Prints what came of it as JSON.
    #[arg(long)]
    pub json: bool,
}

pub(super) fn run(args: &ReplayArgs, out: &mut dyn Write) -> Result<(), Failure> {
    let usage = |error: &dyn std::fmt::Display| Failure::Usage(error.to_string());
    let recording = Recording::open(&args.file).map_err(|error| usage(&error))?;
    if let Some(tear) = recording.tear() {
        tell(&tear.to_string());
    }
    if let Some(folder) = &args.export {
        return export(&recording, folder, out);
    }
    if let Some(file) = &args.midi {
        return write_midi(&recording, file, out);
    }
    let line = ProgressBar::new_spinner();
    line.set_style(
        ProgressStyle::with_template("{spinner} {pos} ticks")
            .unwrap_or_else(|_| ProgressStyle::default_spinner()),
    );
    let replayed = replay(updates(&recording), |ticks| line.set_position(ticks));
    line.finish_and_clear();
    let replayed = replayed.map_err(|error| usage(&error))?;
    if args.json {
        print_report(&replayed, out)?;
    } else {
        print(&replayed, out)?;
    }
    let Replayed { compared, different, ticks, .. } = &replayed;
    match (&replayed.first_difference, &replayed.damage) {
        (None, None) => Ok(()),
        (None, Some(damage)) => Err(Failure::Running(format!(
            "the replay ends after {ticks} ticks, the same so far: {damage}"
        ))),
        (Some(first), _) => Err(Failure::Running(format!(
            "{different} of {compared} messages are not the same; the first: {first}"
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
    if let (Some(tick), None) = (it.incomplete_from, &it.damage) {
        writeln!(
            out,
            "  from tick {tick} on it does not contain all inputs, so that nothing could be \
             compared: {ticks} of {recorded} ticks were"
        )?;
    }
    Ok(())
}

/// Returns the contents of `recording`, and what is missing of it.
fn updates(recording: &Recording) -> impl Iterator<Item = Result<Update, String>> + '_ {
    recording.messages().filter_map(|message| match message {
        Ok((_at, update)) => Some(Ok(update)),
        Err(ReadError::Missing(piece)) if piece.is_said_again() => {
            tell(&format!("{piece}; it is repeated elsewhere, and nothing is missing"));
            None
        }
        Err(error) => Some(Err(error.to_string())),
    })
}

/// Writes all MIDI messages, also those around a gap, which is reported.
fn write_midi(recording: &Recording, file: &Path, out: &mut dyn Write) -> Result<(), Failure> {
    let mut smf = Smf::new(file);
    for update in updates(recording) {
        let sent = match update {
            Ok(Update::Midi(midi)) => match Message::decode(&midi.bytes) {
                Ok(message) => smf.send(midi.at, message).map_err(|error| error.to_string()),
                Err(unknown) => Err(unknown.to_string()),
            },
            Ok(_) => Ok(()),
            Err(damage) => Err(damage),
        };
        sent.unwrap_or_else(|why| tell(&format!("the MIDI file may lack notes: {why}")));
    }
    let messages = smf.messages().len();
    if messages == 0 {
        let text = "the recording has no MIDI messages: no note was struck in it";
        return Err(Failure::Usage(text.to_owned()));
    }
    smf.finish().map_err(|error| Failure::Running(error.to_string()))?;
    Ok(writeln!(out, "{}: {messages} messages", shown(file))?)
}

fn midi_file(text: &str) -> Result<PathBuf, String> {
    let MidiOutput::File(path) = midi_output(text.to_owned()) else {
        return Err(format!("`{text}` is no name of a MIDI file: let it end in .mid"));
    };
    Ok(path)
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
