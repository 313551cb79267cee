//! The system's MIDI, through midir: existing ports, and a virtual one of our own.

use std::fmt;

use midir::{MidiOutput, MidiOutputConnection, MidiOutputPort};

use super::ports::{CLIENT, Unavailable, named, open};
use super::reconnecting::MidiSystem;
use super::watch::PortWatch;

/// Returns the names of all ports that could be connected; an error contains the remedy.
pub fn ports() -> Result<Vec<String>, Unavailable> {
    Ok(named(&open()?).into_iter().map(|(name, _)| name).collect())
}

#[derive(Clone, PartialEq, Eq, Debug)]
pub(super) enum WantedPort {
    /// First port whose name contains this text, ignoring case.
    Existing(String),
    /// Port of our own, for others to connect to.
    Virtual,
}

pub(super) struct System {
    wanted: WantedPort,
    connection: Option<MidiOutputConnection>,
    /// Full name of the connected port; `None` for a virtual one.
    port: Option<String>,
    /// Watch on the connected port; `None` for a virtual one.
    watch: Option<PortWatch>,
}

impl System {
    pub(super) fn new(wanted: WantedPort) -> Self {
        Self { wanted, connection: None, port: None, watch: None }
    }

    fn connect_existing(&mut self, wanted: &str) -> Result<(), Unavailable> {
        let system = open()?;
        let (name, port) = find(&system, wanted)?;
        let watch = PortWatch::of(&port)?;
        let connection =
            system.connect(&port, CLIENT).map_err(|error| refused(&name, &error.to_string()))?;
        self.connection = Some(connection);
        self.port = Some(name);
        self.watch = Some(watch);
        Ok(())
    }

    #[cfg(unix)]
    fn connect_virtual(&mut self) -> Result<(), Unavailable> {
        use midir::os::unix::VirtualOutput as _;
        let connection =
            open()?.create_virtual(CLIENT).map_err(|error| refused(CLIENT, &error.to_string()))?;
        self.connection = Some(connection);
        Ok(())
    }

    #[cfg(not(unix))]
    fn connect_virtual(&mut self) -> Result<(), Unavailable> {
        Err(Unavailable::NoVirtualPorts)
    }
}

impl MidiSystem for System {
    fn connect(&mut self) -> Result<(), Unavailable> {
        *self = Self::new(self.wanted.clone());
        match self.wanted.clone() {
            WantedPort::Existing(name) => self.connect_existing(&name),
            WantedPort::Virtual => self.connect_virtual(),
        }
    }

    fn send(&mut self, bytes: &[u8]) -> bool {
        self.connection.as_mut().is_some_and(|connection| connection.send(bytes).is_ok())
    }

    fn is_there(&mut self) -> bool {
        self.connection.is_some() && self.watch.as_mut().is_none_or(PortWatch::is_there)
    }

    fn destination(&self) -> Option<String> {
        self.port.clone()
    }
}

impl fmt::Debug for System {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("System")
            .field("wanted", &self.wanted)
            .field("port", &self.port)
            .field("connected", &self.connection.is_some())
            .finish_non_exhaustive()
    }
}

pub(crate) fn refused(port: &str, reason: &str) -> Unavailable {
    Unavailable::Refused { port: port.to_owned(), reason: reason.to_owned() }
}

fn find(system: &MidiOutput, wanted: &str) -> Result<(String, MidiOutputPort), Unavailable> {
    let mut ports = named(system);
    let names: Vec<_> = ports.iter().map(|(name, _)| name.clone()).collect();
    match choose(&names, wanted) {
        Some(index) => Ok(ports.swap_remove(index)),
        None => Err(Unavailable::NoSuchPort { wanted: wanted.to_owned(), existing: names }),
    }
}

/// Returns the first of `names` that contains `wanted`, ignoring case.
fn choose(names: &[String], wanted: &str) -> Option<usize> {
    let wanted = wanted.to_lowercase();
    names.iter().position(|name| name.to_lowercase().contains(&wanted))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_port_is_found_by_part_of_its_name_in_any_case() {
        let names = ["Midi Through:0".to_owned(), "FLUID Synth (77):0".to_owned()];
        assert_eq!(choose(&names, "fluid"), Some(1));
        assert_eq!(choose(&names, "0"), Some(0));
        assert_eq!(choose(&names, "pianoteq"), None);
    }

    #[test]
    fn a_wrong_name_is_answered_with_the_right_ones() {
        let error = |existing: &[&str]| {
            let existing = existing.iter().map(ToString::to_string).collect();
            Unavailable::NoSuchPort { wanted: "x".to_owned(), existing }.to_string()
        };
        assert_eq!(error(&["a", "b"]), "no MIDI port is called \"x\": choose one of \"a\", \"b\"");
        assert!(error(&[]).ends_with("there is none, start the synthesizer first"));
    }

    #[cfg(target_os = "linux")]
    #[test]
    fn without_a_sequencer_the_error_says_what_to_do() {
        if std::path::Path::new("/dev/snd/seq").exists() {
            return;
        }
        assert_eq!(ports(), Err(Unavailable::NoSequencer));
        assert!(Unavailable::NoSequencer.to_string().contains("modprobe snd-seq"));
        assert!(Unavailable::NotAllowed.to_string().contains("group audio"));
    }
}
