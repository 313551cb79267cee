//! Real boards, from their links to a bus that ticks.
//!
//! ```text
//! Keybed<Offline> ── identify ──▶ Keybed<Identified> ── calibrate ──▶ Keybed<Calibrated>
//!                                                                          │ arm
//!                                            Keybed<Armed>: KeyBus ◀───────┘
//! ```
//!
//! Each step waits, allocates and returns all faults at once. Only an armed keybed can send forces;
//! its work in a tick is in [`crate::rt`].

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

use crate::{plan::Medium, refusal::Refusal};

/// Boards on their lines, in one stage of the bring-up.
#[derive(Debug)]
pub struct Keybed<S> {
    lines: Vec<NamedLink>,
    stage: S,
    clock: HostClock,
}

/// A link with its name.
pub struct NamedLink {
    /// Name in messages: a port, an interface.
    pub name: String,
    /// Address in commands, as `can:can0`.
    pub address: String,
    pub link: Box<dyn Link + Send>,
    /// Its medium, if its times are known.
    pub medium: Option<Medium>,
}

impl NamedLink {
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
    pub fn line_names(&self) -> impl Iterator<Item = &str> {
        self.lines.iter().map(|line| line.name.as_str())
    }

    pub fn media(&self) -> impl Iterator<Item = Option<Medium>> {
        self.lines.iter().map(|line| line.medium)
    }

    pub const fn clock(&self) -> &HostClock {
        &self.clock
    }

    pub fn now_us(&self) -> u64 {
        self.clock.now_us()
    }
}

fn faults(lines: &[NamedLink]) -> impl Iterator<Item = Refusal> {
    let faults = lines.iter().filter_map(|line| line.link.fault());
    faults.map(|fault| Refusal::Link { fault: fault.to_string() })
}

fn address(lines: &[NamedLink], name: &str) -> String {
    let line = lines.iter().find(|line| line.name == name);
    line.map_or_else(|| name.to_owned(), |line| line.address.clone())
}

const LOOK: Duration = Duration::from_micros(500);
