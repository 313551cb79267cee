//! The protocol of host and guardian: one line of JSON per message.

use std::io;
use std::path::{Path, PathBuf};

use midi::{MidiPort, Output, RawPort, Unavailable};
use serde::{Deserialize, Serialize};

use crate::{control::place, midi_thread::AnyOutput, report::Quantiles};

/// Protocol version; a guardian of another version is left alone.
pub(super) const VERSION: u32 = 2;

#[derive(Clone, PartialEq, Eq, Debug, Serialize, Deserialize)]
pub(crate) enum GuardedPort {
    /// A port of this program, to which other programs connect.
    Virtual,
    /// The first port with a name that contains this text.
    Named(String),
    /// A device file or FIFO for the bytes of a cable.
    Raw(PathBuf),
}

impl GuardedPort {
    /// Opens the port in this process and ends the notes that a dead process left there; returns
    /// it with the reason if those notes cannot be ended on this port.
    pub(crate) fn open(&self) -> Result<(AnyOutput, Option<String>), Unavailable> {
        Ok(match self {
            Self::Virtual => with_ledger(MidiPort::create()?, MidiPort::keep_ledger),
            Self::Named(name) => with_ledger(MidiPort::connect(name)?, MidiPort::keep_ledger),
            Self::Raw(path) => with_ledger(RawPort::open(path)?, RawPort::keep_ledger),
        })
    }
}

/// Attaches a ledger to `port` by `keep`; returns the reason if that fails.
fn with_ledger<O: Output + Send + 'static>(
    mut port: O,
    keep: fn(&mut O, &Path) -> io::Result<()>,
) -> (AnyOutput, Option<String>) {
    let kept = place::runtime_folder().and_then(|folder| keep(&mut port, &folder));
    let trouble = kept
        .err()
        .map(|error| format!("if this process is killed, its notes sound on: no ledger, {error}"));
    (Box::new(port), trouble)
}

/// Returns `true` if the machine has no MIDI for this user; a host does not fail for that.
pub(super) fn is_missing(why: &Unavailable) -> bool {
    match why {
        Unavailable::NoSequencer
        | Unavailable::NotAllowed
        | Unavailable::NotStarted
        | Unavailable::NoVirtualPorts => true,
        Unavailable::NoSuchPort { .. }
        | Unavailable::Refused { .. }
        | Unavailable::NoDevice { .. } => false,
    }
}

#[derive(Clone, PartialEq, Debug, Serialize, Deserialize)]
pub(super) enum HostLine {
    /// The first line of a host: asks for a port.
    Hello { version: u32, port: GuardedPort },
    Message {
        bytes: Vec<u8>,
        /// Time of the host's write, by the monotonic clock (ns).
        handed_over: u64,
    },
    /// A sign that the host lives and its ticks continue.
    Beat,
    /// End of the run: the port may close.
    Finish,
}

#[derive(Clone, PartialEq, Debug, Serialize, Deserialize)]
pub(super) enum GuardianLine {
    /// The port is open.
    Opened {},
    /// This machine has no MIDI; a sentence.
    Missing { why: String },
    /// The port cannot be opened; a sentence.
    Refused { why: String },
    /// The guardian is another host's or of another version; a sentence.
    Declined { why: String },
    /// Answer to a beat.
    Beat(PassedOn),
    /// All notes are ended and the port is closed.
    Finished { passed_on: PassedOn, after_us: Option<Quantiles> },
}

#[derive(Clone, PartialEq, Eq, Debug, Default, Serialize, Deserialize)]
pub(super) struct PassedOn {
    pub(super) n_lost: u64,
    pub(super) trouble: Option<String>,
    /// Silences of the host so long that its notes were ended.
    pub(super) n_interruptions: u64,
}
