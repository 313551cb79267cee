//! Watch by the announcements of ALSA's sequencer. A restarted synthesizer has the same name and
//! number as before, but is no longer connected; no list of ports shows that.

use std::io::{self, ErrorKind};

use alsa::seq::{Addr, Event, EventType, PortCap, PortSubscribe, PortType, Seq};
use alsa::{Direction, Error};
use midir::MidiOutputPort;

use crate::output::Unavailable;

/// Most announcements that one check reads; the kernel keeps fewer.
const MOST: usize = 4096;

/// Listener to the announcements about one port.
pub(in crate::output) struct PortWatch {
    sequencer: Seq,
    port: Addr,
    has_gone: bool,
}

impl PortWatch {
    /// Watches `port`; to be called before it is connected.
    pub(in crate::output) fn of(port: &MidiOutputPort) -> Result<Self, Unavailable> {
        let port = port.id().parse().map_err(|_no_address| Unavailable::NotStarted)?;
        let sequencer = listen().map_err(|_no_client| Unavailable::NotStarted)?;
        Ok(Self { sequencer, port, has_gone: false })
    }

    /// Returns `true` if the port is there and has been since it was watched.
    pub(in crate::output) fn is_there(&mut self) -> bool {
        self.has_gone = self.has_gone || self.hears_that_it_goes();
        !self.has_gone
    }

    /// Reads all announcements since the last check.
    fn hears_that_it_goes(&self) -> bool {
        let mut input = self.sequencer.input();
        for _ in 0..MOST {
            match input.event_input().map(|event| ends(&event, self.port)) {
                Ok(true) => return true,
                Ok(false) => {}
                Err(error) => match consequence(error) {
                    Consequence::NothingMore => return false,
                    Consequence::ReadOn => {}
                    Consequence::Unknown => return true,
                },
            }
        }
        true
    }
}

/// Opens a separate client that receives the announcements.
fn listen() -> Result<Seq, Error> {
    let sequencer = Seq::open(None, Some(Direction::Capture), true)?;
    sequencer.set_client_name(c"letoff watch")?;
    // Written by the kernel only: others neither see it as a destination nor may connect it.
    let writable = PortCap::WRITE | PortCap::NO_EXPORT;
    let port = sequencer.create_simple_port(c"announcements", writable, PortType::APPLICATION)?;
    let subscription = PortSubscribe::empty()?;
    subscription.set_sender(Addr::system_announce());
    subscription.set_dest(Addr { client: sequencer.client_id()?, port });
    sequencer.subscribe_port(&subscription)?;
    Ok(sequencer)
}

/// Returns `true` if `event` announces the end of `port`, or of its program.
fn ends(event: &Event<'_>, port: Addr) -> bool {
    let Some(of) = event.get_data::<Addr>() else { return false };
    let port_ends = event.get_type() == EventType::PortExit && of == port;
    let program_ends = event.get_type() == EventType::ClientExit && of.client == port.client;
    port_ends || program_ends
}

/// Consequence of an error of reading.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
enum Consequence {
    NothingMore,
    /// Announcement unknown to this library, or a signal.
    ReadOn,
    /// Announcements were lost: the port may be gone.
    Unknown,
}

fn consequence(error: Error) -> Consequence {
    let kind = io::Error::from_raw_os_error(error.errno()).kind();
    if kind == ErrorKind::WouldBlock {
        Consequence::NothingMore
    } else if kind == ErrorKind::Unsupported || kind == ErrorKind::Interrupted {
        Consequence::ReadOn
    } else {
        Consequence::Unknown
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const PORT: Addr = Addr { client: 128, port: 1 };

    fn ends_port(kind: EventType, client: i32, port: i32) -> bool {
        ends(&Event::new(kind, &Addr { client, port }), PORT)
    }

    #[test]
    fn a_port_goes_by_itself_or_with_its_program() {
        assert!(ends_port(EventType::PortExit, 128, 1));
        assert!(ends_port(EventType::ClientExit, 128, 0));
    }

    #[test]
    fn what_happens_to_others_is_no_end() {
        assert!(!ends_port(EventType::PortExit, 128, 0));
        assert!(!ends_port(EventType::PortExit, 129, 1));
        assert!(!ends_port(EventType::ClientExit, 129, 1));
        assert!(!ends_port(EventType::PortChange, 128, 1));
        assert!(!ends_port(EventType::ClientStart, 128, 1));
    }

    #[test]
    fn lost_announcements_count_as_an_end_and_unknown_ones_do_not() {
        let check = |errno, expected| {
            assert_eq!(consequence(Error::new("snd_seq_event_input", errno)), expected);
        };
        let (eintr, eagain, enospc, enotsup) = (4, 11, 28, 95);
        check(eagain, Consequence::NothingMore);
        check(eintr, Consequence::ReadOn);
        check(enotsup, Consequence::ReadOn);
        check(enospc, Consequence::Unknown);
    }
}
