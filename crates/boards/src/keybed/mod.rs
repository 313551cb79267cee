//! Real boards, from their links to a bus that ticks.
//!
//! ```text
//! Keybed<Offline> ── identify ──▶ Keybed<Identified> ── calibrate ──▶ Keybed<Calibrated>
//!                                                                          │ arm
//!                                            Keybed<Armed>: KeyBus ◀───────┘
//! ```
//!
//! Each step returns all that is wrong at once, and a keybed that is not armed has no way to
//! send a force. These steps wait and allocate; what an armed keybed does in a tick is in
//! [`crate::rt`].

mod armed;
mod ask;
mod calibrated;
mod identified;
mod offline;

use std::time::Duration;

pub use armed::{Armed, BoardReport, LineReport};
pub use ask::Asker;
pub use calibrated::Calibrated;
pub use identified::{FoundBoard, Identified, WantedBoards};
pub use offline::Offline;

pub use crate::rt::terms::Terms;

use crate::links::{HostClock, Link};

use crate::plan::Medium;
use crate::refusal::Refusal;

/// Boards on their lines, and how far they have been brought up.
#[derive(Debug)]
pub struct Keybed<S> {
    lines: Vec<NamedLink>,
    stage: S,
    clock: HostClock,
}

/// A link with its name.
pub struct NamedLink {
    /// What it is called in sentences: a port, an interface.
    pub name: String,
    /// What a command takes for it, as `can:can0`.
    pub address: String,
    /// What carries its frames.
    pub link: Box<dyn Link + Send>,
    /// What that is made of, if its times are known.
    pub medium: Option<Medium>,
}

impl NamedLink {
    /// Returns a link of which only its name is known.
    pub fn new(name: impl Into<String>, link: Box<dyn Link + Send>) -> Self {
        let name = name.into();
        Self { address: name.clone(), name, link, medium: None }
    }
}

impl std::fmt::Debug for NamedLink {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("Line").field("name", &self.name).finish_non_exhaustive()
    }
}

impl<S> Keybed<S> {
    /// Returns the names of the lines.
    pub fn line_names(&self) -> impl Iterator<Item = &str> {
        self.lines.iter().map(|line| line.name.as_str())
    }

    /// Returns what each line is made of, if that is known.
    pub fn media(&self) -> impl Iterator<Item = Option<Medium>> {
        self.lines.iter().map(|line| line.medium)
    }

    /// Returns the clock by which the host waits for these boards.
    pub const fn clock(&self) -> &HostClock {
        &self.clock
    }

    /// Returns the host's clock now (us).
    pub fn now_us(&self) -> u64 {
        self.clock.now_us()
    }
}

/// Returns why links are down for good.
fn faults(lines: &[NamedLink]) -> impl Iterator<Item = Refusal> {
    let faults = lines.iter().filter_map(|line| line.link.fault());
    faults.map(|fault| Refusal::Link { fault: fault.to_string() })
}

/// Returns what a command takes for the line that is called `name`.
fn address(lines: &[NamedLink], name: &str) -> String {
    let line = lines.iter().find(|line| line.name == name);
    line.map_or_else(|| name.to_owned(), |line| line.address.clone())
}

/// Time between two looks at what may have come.
const LOOK: Duration = Duration::from_micros(500);
