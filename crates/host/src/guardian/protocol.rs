//! What host and guardian tell each other, a line of JSON each.

use std::io;
use std::path::{Path, PathBuf};

use midi::{MidiPort, Output, RawPort, Unavailable};
use serde::{Deserialize, Serialize};

use crate::control::place;
use crate::midi_thread::AnyOutput;
use crate::report::Quantiles;

/// Number of this protocol; a guardian of another version is left alone.
pub(super) const VERSION: u32 = 2;

/// A port that a guardian opens.
#[derive(Clone, PartialEq, Eq, Debug, Serialize, Deserialize)]
pub(crate) enum GuardedPort {
    /// A port of our own, to which other programs connect.
    Virtual,
    /// The first port whose name contains this.
    Named(String),
    /// A device file or FIFO that takes the bytes of a cable.
    Raw(PathBuf),
}

impl GuardedPort {
    /// Opens the port in this process, and ends what a process that is gone has left there; returns
    /// it with the reason why that cannot be done for this one, if so.
    ///
    /// # Errors
    /// If it is not there, or cannot be opened.
    pub(crate) fn open(&self) -> Result<(AnyOutput, Option<String>), Unavailable> {
        Ok(match self {
            Self::Virtual => with_ledger(MidiPort::create()?, MidiPort::keep_ledger),
            Self::Named(name) => with_ledger(MidiPort::connect(name)?, MidiPort::keep_ledger),
            Self::Raw(path) => with_ledger(RawPort::open(path)?, RawPort::keep_ledger),
        })
    }
}

/// Has `port` keep a ledger by `keep`; returns it with the reason why it cannot, if so.
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

/// Returns whether the machine has no MIDI for this user, which a host does not fail for.
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

/// A line from the host.
#[derive(Clone, PartialEq, Debug, Serialize, Deserialize)]
pub(super) enum HostLine {
    /// Asks for a port; it is the first line of a host.
    Hello { version: u32, port: GuardedPort },
    /// A message for the port.
    Message {
        bytes: Vec<u8>,
        /// When the host wrote it, by the monotonic clock (ns).
        handed_over: u64,
    },
    /// A sign that the host lives, and that its ticks go on.
    Beat,
    /// The run is over: the port may close.
    Finish,
}

/// A line from the guardian.
#[derive(Clone, PartialEq, Debug, Serialize, Deserialize)]
pub(super) enum GuardianLine {
    /// The port is open.
    Opened {},
    /// There is no MIDI on this machine; a sentence.
    Missing { why: String },
    /// The port cannot be opened; a sentence.
    Refused { why: String },
    /// It is another host's, or of another version; a sentence.
    Declined { why: String },
    /// The answer to a beat.
    Beat(PassedOn),
    /// All is silent, and the port is closed.
    Finished { passed_on: PassedOn, after_us: Option<Quantiles> },
}

/// What became of a host's messages so far.
#[derive(Clone, PartialEq, Eq, Debug, Default, Serialize, Deserialize)]
pub(super) struct PassedOn {
    /// Messages that were lost.
    pub(super) n_lost: u64,
    /// The first reason; a sentence.
    pub(super) trouble: Option<String>,
    /// How often the host was silent for so long that its notes were ended.
    pub(super) n_interruptions: u64,
}
