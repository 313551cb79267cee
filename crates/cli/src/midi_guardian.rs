//! `letoff midi-guardian PATH`: started by a host, to hold its MIDI port and outlive it.

use std::path::PathBuf;

use clap::Args;

use super::Failure;

/// What `letoff midi-guardian` takes.
#[derive(Clone, Debug, Args)]
pub struct MidiGuardianArgs {
    /// The path of the socket that listens on standard input.
    #[arg(value_name = "PATH")]
    pub path: PathBuf,
}

pub(super) fn run(args: &MidiGuardianArgs) -> Result<(), Failure> {
    host::guardian::attend(&args.path).map_err(|error| {
        Failure::Usage(format!(
            "a MIDI guardian is started by `letoff run`, with a socket on standard input: {error}"
        ))
    })
}
