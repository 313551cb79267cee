//! Watch by the list of ports: a port that returns before the next check is not noticed as gone.

use midir::{MidiOutput, MidiOutputPort};

use crate::output::Unavailable;
use crate::output::ports::{named, open};

pub(in crate::output) struct PortWatch {
    /// Client for the list: an established connection cannot list ports.
    system: MidiOutput,
    name: String,
}

impl PortWatch {
    /// Watches `port`; to be called before it is connected.
    pub(in crate::output) fn of(port: &MidiOutputPort) -> Result<Self, Unavailable> {
        let system = open()?;
        let name = system.port_name(port).map_err(|_gone| Unavailable::NotStarted)?;
        Ok(Self { system, name })
    }

    pub(in crate::output) fn is_there(&mut self) -> bool {
        named(&self.system).iter().any(|(name, _)| *name == self.name)
    }
}
