//! Program changes from other programs: `Cn pp`, program `pp` (0 ..= 127) on channel `n`.

use midir::{MidiInput, MidiInputConnection, MidiInputPort};

use crate::output::{CLIENT, Unavailable, look_for_sequencer, refused};

const PROGRAM_CHANGE: u8 = 0xC0;

/// Program change on a channel.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct ProgramChange {
    /// Channel as people number it, 1 ..= 16.
    pub channel: u8,
    /// Program as General MIDI numbers it, 1 ..= 128.
    pub program: u8,
}

impl ProgramChange {
    /// Decodes a complete program change; `None` for any other bytes.
    #[must_use]
    pub const fn decode(bytes: &[u8]) -> Option<Self> {
        match *bytes {
            [status, program] if status & 0xF0 == PROGRAM_CHANGE && program <= 0x7F => {
                Some(Self { channel: (status & 0x0F) + 1, program: program + 1 })
            }
            _ => None,
        }
    }
}

/// A port that receives program changes until it is dropped.
pub struct ProgramInput {
    _connection: MidiInputConnection<()>,
}

impl ProgramInput {
    /// Listens to the first port whose name contains `name`, ignoring case. A thread of the
    /// system's MIDI calls `heard`.
    ///
    /// # Errors
    /// There is no MIDI or no such port; lists the ports and the remedy.
    pub fn connect(
        name: &str,
        heard: impl FnMut(ProgramChange) + Send + 'static,
    ) -> Result<Self, Unavailable> {
        let system = open()?;
        let mut ports = named(&system);
        let names: Vec<_> = ports.iter().map(|(name, _)| name.clone()).collect();
        let wanted = name.to_lowercase();
        let found = names.iter().position(|name| name.to_lowercase().contains(&wanted));
        let Some(index) = found else {
            return Err(Unavailable::NoSuchPort { wanted: name.to_owned(), existing: names });
        };
        let (name, port) = ports.swap_remove(index);
        let connected = system.connect(&port, CLIENT, listener(heard), ());
        let connection = connected.map_err(|error| refused(&name, &error.to_string()))?;
        Ok(Self { _connection: connection })
    }

    /// Creates a port called "letoff", to which other programs connect.
    ///
    /// # Errors
    /// There is no MIDI, or the system has no virtual ports (Windows).
    #[cfg(unix)]
    pub fn create(heard: impl FnMut(ProgramChange) + Send + 'static) -> Result<Self, Unavailable> {
        use midir::os::unix::VirtualInput as _;
        let connected = open()?.create_virtual(CLIENT, listener(heard), ());
        let connection = connected.map_err(|error| refused(CLIENT, &error.to_string()))?;
        Ok(Self { _connection: connection })
    }

    /// Returns an error: this system has no virtual ports.
    #[cfg(not(unix))]
    pub fn create(_heard: impl FnMut(ProgramChange) + Send + 'static) -> Result<Self, Unavailable> {
        Err(Unavailable::NoVirtualPorts)
    }
}

impl std::fmt::Debug for ProgramInput {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("ProgramInput").finish_non_exhaustive()
    }
}

fn open() -> Result<MidiInput, Unavailable> {
    look_for_sequencer()?;
    MidiInput::new(CLIENT).map_err(|_init| Unavailable::NotStarted)
}

/// Returns all ports with their names; a port that vanishes meanwhile is left out.
fn named(system: &MidiInput) -> Vec<(String, MidiInputPort)> {
    let ports = system.ports().into_iter();
    ports.filter_map(|port| Some((system.port_name(&port).ok()?, port))).collect()
}

fn listener(
    mut heard: impl FnMut(ProgramChange) + Send + 'static,
) -> impl FnMut(u64, &[u8], &mut ()) + Send + 'static {
    move |_time, bytes, ()| {
        if let Some(change) = ProgramChange::decode(bytes) {
            heard(change);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_whole_program_changes_are_heard() {
        let change = |channel, program| Some(ProgramChange { channel, program });
        assert_eq!(ProgramChange::decode(&[0xC0, 0]), change(1, 1));
        assert_eq!(ProgramChange::decode(&[0xCF, 127]), change(16, 128));
        for other in [&[][..], &[0xC0], &[0xC0, 128], &[0xC0, 1, 2], &[0xD0, 1], &[0x90, 60, 1]] {
            assert_eq!(ProgramChange::decode(other), None, "{other:?}");
        }
    }
}
