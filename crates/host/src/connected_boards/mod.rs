//! Boards on links, for every command: opening, planning, calibration files.

pub mod planning;

use std::path::PathBuf;

use boards::calibration::{KeyCalibration, file};
use boards::keybed::{Armed, FoundBoard, Keybed, NamedLink};
use boards::links::{BusSide, HostClock, reconnecting::ReconnectingLink};
use boards::plan::{Medium, NoPlan};
use boards::refusal::{BoardName, Refusal};
use documents::shown;
use firmware_protocol::{frame::hello::feature, key::PerKey};
use scheduler::time::Nanos;

use crate::control::BoardsTold;
use engine::realtime::clock;
use scene::{BoardBus, Boards};

/// Longest wait for boards to answer and to be armed (us).
pub const PATIENCE_US: u64 = 4_000_000;

/// Returns the host's time, to which boards' clocks are compared (us).
pub fn now_us() -> u64 {
    clock::monotonic().as_u64() / 1_000
}

/// Returns the clock for `buses`: a virtual one from 0 if all lead to programs in lockstep.
pub fn clock(buses: &[BoardBus]) -> HostClock {
    let is_virtual = !buses.is_empty() && buses.iter().all(|bus| bus.address.kind.is_in_lockstep);
    if is_virtual { HostClock::virtual_time() } else { HostClock::Monotonic(now_us) }
}

/// Opens a link for a host that lives by `clock`. A link to real boards is reopened whenever it
/// goes down; a program in lockstep starts once, since another one would begin at time 0.
pub fn open(bus: &BoardBus, clock: &HostClock) -> Result<NamedLink, boards::links::Error> {
    let (address, its_clock) = (bus.address.clone(), clock.clone());
    let open = move || address.open(BusSide::Host, &its_clock);
    let link = if bus.address.kind.is_in_lockstep {
        open()?
    } else {
        Box::new(ReconnectingLink::open(open)?)
    };
    let medium = medium(bus).ok();
    let (name, address) = (bus.address.place.clone(), bus.address.typed());
    Ok(NamedLink { name, address, link, medium })
}

/// Opens all links for a host that lives by `clock`.
///
/// # Errors
/// A sentence on each link that fails, to be printed after "letoff: ".
pub fn open_all(buses: &[BoardBus], clock: &HostClock) -> Result<Vec<NamedLink>, String> {
    let (mut lines, mut wrong) = (Vec::new(), Vec::new());
    for bus in buses {
        match open(bus, clock) {
            Ok(line) => lines.push(line),
            Err(error) => wrong.push(error.to_string()),
        }
    }
    if wrong.is_empty() { Ok(lines) } else { Err(wrong.join("\nletoff: ")) }
}

/// Returns the medium of a link, as far as its address and its rates determine it.
pub fn medium(bus: &BoardBus) -> Result<Medium, NoPlan> {
    (bus.address.kind.medium)(&bus.address, bus.bit_rates)
}

pub fn folder(boards: &Boards) -> Option<PathBuf> {
    boards.calibration.clone().or_else(file::usual_folder)
}

/// Returns the calibration of a board from its file, or from the board itself if it is simulated.
pub fn calibration(
    found: &FoundBoard,
    name: &BoardName,
    boards: &Boards,
) -> Result<PerKey<KeyCalibration>, Refusal> {
    let board = || name.clone();
    let path = folder(boards).map(|folder| file::path(&folder, found.uid()));
    let n_keys = usize::from(found.hello.n_keys);
    let read = path.as_deref().map(|path| file::read(path, found.uid(), n_keys)).transpose();
    match read.map_err(|why| Refusal::Calibration { board: board(), why })?.flatten() {
        Some(calibration) => Ok(calibration),
        None if found.hello.features & feature::FINGERS != 0 => Ok(nominal(found)),
        None => {
            let file = path.map_or_else(|| found.uid().to_string(), |it| shown(&it));
            let bus = boards.buses.get(found.line);
            let link = bus.map_or_else(|| name.line.clone(), |bus| bus.address.typed());
            Err(Refusal::NotCalibrated { board: board(), link, file })
        }
    }
}

/// Stops the forces of all boards until they are restarted.
pub fn stop_all(keybed: &mut Keybed<Armed>) -> BoardsTold {
    /// Repetitions of the command, since no board answers it.
    const TIMES: u8 = 3;
    const TRIES: u8 = 20;
    const PAUSE: Nanos = Nanos::from_millis(1);
    let boards = keybed.terms().count();
    let mut told = 0;
    for n in 0..TRIES {
        told = told.max(keybed.stop(1));
        if TIMES <= n + 1 && told == boards {
            break;
        }
        clock::sleep_until(clock::monotonic().after(PAUSE));
    }
    BoardsTold { told, boards }
}

fn nominal(found: &FoundBoard) -> PerKey<KeyCalibration> {
    alike(found, found.nominal())
}

/// Returns calibrations for keys to be measured: slopes as the board states, any position valid.
pub fn unmeasured(found: &FoundBoard) -> PerKey<KeyCalibration> {
    alike(found, found.nominal().unmeasured())
}

fn alike(found: &FoundBoard, calibration: KeyCalibration) -> PerKey<KeyCalibration> {
    PerKey::collect(std::iter::repeat_n(calibration, usize::from(found.hello.n_keys)))
}

#[cfg(test)]
mod tests {
    use boards::links::address::Address;

    use super::*;

    #[track_caller]
    fn check(address: &str, medium: Option<&str>) {
        let bus = BoardBus::new(Address::parse(address).unwrap());
        assert_eq!(
            super::medium(&bus).ok().map(|it| it.to_string()).as_deref(),
            medium,
            "{address}"
        );
    }

    #[test]
    fn a_link_whose_bits_take_their_time_has_a_medium() {
        check("can:can0", Some("CAN FD at 1/5 Mbit/s"));
        check("classic-can:can0", Some("classic CAN at 1 Mbit/s"));
        check("serial:/dev/ttyUSB7@3000000", Some("serial line at 3 Mbaud"));
        check("serial:/dev/ttyACM7", None);
        check("serial:/dev/pts/99", None);
    }
}
