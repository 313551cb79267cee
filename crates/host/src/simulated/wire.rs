use std::path::Path;

use boards::links::serial::{self, Pty, Serial};
use boards::links::wire::{Wire, WirePlan};
use boards::links::{BusSide, HostClock, Link, address::Address, reconnecting::ReconnectingLink};
use firmware_protocol::key::BoardId;

use crate::connected_boards::now_us;

/// Kind of link of simulated boards.
#[derive(Clone, PartialEq, Debug)]
pub enum WireEndpoint {
    /// One pseudo-terminal per board, without delay or loss.
    Pty,
    /// One pseudo-terminal per board, behind a wire with faults.
    Wire(WirePlan),
    /// One link for all boards, reopened when it goes down.
    Shared(Address),
}

/// A board's end of its link, and the host's address.
pub struct Placed {
    pub link: Box<dyn Link + Send>,
    pub address: Address,
    /// Kept since the wire lives as long as the link.
    _wire: Option<Wire>,
}

impl std::fmt::Debug for Placed {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("Placed").field("address", &self.address).finish_non_exhaustive()
    }
}

pub fn place(board: BoardId, at: &WireEndpoint) -> Result<Placed, boards::links::Error> {
    match at {
        WireEndpoint::Pty => {
            let Pty { board, path } = Pty::open()?;
            Ok(Placed { link: Box::new(board), address: serial(&path), _wire: None })
        }
        WireEndpoint::Wire(plan) => {
            // Each board has its own random faults.
            let seed = plan.seed.wrapping_add(u64::from(board.number()));
            let wire = Wire::open(WirePlan { seed, ..*plan })?;
            let link = Box::new(Serial::open(wire.board(), 2_000_000)?);
            Ok(Placed { link, address: serial(wire.host()), _wire: Some(wire) })
        }
        WireEndpoint::Shared(address) => {
            let its_address = address.clone();
            let clock = HostClock::Monotonic(now_us);
            let open = move || its_address.open(BusSide::Board(board), &clock);
            let link = ReconnectingLink::open(open)?;
            Ok(Placed { link: Box::new(link), address: address.clone(), _wire: None })
        }
    }
}

fn serial(port: &Path) -> Address {
    Address::new(&serial::KIND, &port.to_string_lossy(), None)
}
