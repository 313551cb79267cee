//! By the list of ports: a port that goes and is back before the next look is not noticed.

use midir::{MidiOutput, MidiOutputPort};

use crate::output::Unavailable;
use crate::output::ports::{named, open};

/// Looks for one port in the list of all.
pub(in crate::output) struct PortWatch {
    /// An established connection cannot list ports.
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

    /// Whether the port is there.
    pub(in crate::output) fn is_there(&mut self) -> bool {
        named(&self.system).iter().any(|(name, _)| *name == self.name)
    }
}
