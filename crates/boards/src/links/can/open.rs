//! Checks of an interface before and after it is opened.

use super::CanMode;
use crate::links::discovery::{CanInterface, Obstacle, known_can_interfaces};
use crate::links::trouble::CanTrouble;

/// Checks an interface in the kernel's files; if those are missing, opening will fail instead.
pub(super) fn check(interface: &str, mode: CanMode) -> Result<(), CanTrouble> {
    let Ok(listing) = known_can_interfaces() else { return Ok(()) };
    let Some(found) = listing.found.iter().find(|can| can.name == interface) else {
        let names: Vec<_> = listing.found.iter().map(|can| can.name.as_str()).collect();
        let those = || format!("those that there are: {}", names.join(", "));
        return Err(CanTrouble::Missing { there_are: listing.why_empty.unwrap_or_else(those) });
    };
    obstacle(found, mode).map_or(Ok(()), Err)
}

fn obstacle(can: &CanInterface, mode: CanMode) -> Option<CanTrouble> {
    if mode == CanMode::Fd && !can.carries_fd {
        let name = &can.name;
        let set_up = if can.is_virtual {
            format!("sudo ip link set {name} mtu 72 && sudo ip link set {name} up")
        } else {
            format!("sudo ip link set {name} up type can bitrate 1000000 dbitrate 5000000 fd on")
        };
        return Some(CanTrouble::NoFd {
            command: format!("sudo ip link set {name} down && {set_up}"),
        });
    }
    match &can.obstacle {
        Some(down @ Obstacle::Down { .. }) if !can.is_up => Some(CanTrouble::Down(down.clone())),
        _ => None,
    }
}

#[cfg(target_os = "linux")]
pub(super) fn trouble(error: std::io::Error) -> CanTrouble {
    use rustix::io::Errno;

    match Errno::from_io_error(&error) {
        Some(Errno::PERM | Errno::ACCESS) => CanTrouble::Forbidden,
        Some(Errno::AFNOSUPPORT | Errno::PROTONOSUPPORT) => CanTrouble::NoSockets,
        Some(Errno::NODEV) => CanTrouble::Missing {
            there_are: "`letoff devices` lists the interfaces there are".to_owned(),
        },
        _ => CanTrouble::Other(error),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn interface() -> CanInterface {
        CanInterface {
            name: "can0".to_owned(),
            is_virtual: false,
            carries_fd: true,
            is_up: true,
            state: "up".to_owned(),
            mtu: Some(72),
            queue_length: None,
            driver: None,
            link: None,
            obstacle: None,
            advice: Vec::new(),
        }
    }

    #[test]
    fn an_interface_without_fd_says_what_sets_it_up() {
        for (is_virtual, part) in [(true, "can0 mtu 72"), (false, "dbitrate 5000000 fd on")] {
            let classic = CanInterface { carries_fd: false, is_virtual, ..interface() };
            let sentence = obstacle(&classic, CanMode::Fd).unwrap().to_string();
            assert!(sentence.contains(part) && sentence.contains("MTU 16"), "{sentence}");
        }
    }

    #[cfg(target_os = "linux")]
    #[test]
    fn refusals_of_the_system_say_what_to_do() {
        use std::io;
        let sentence = |errno: rustix::io::Errno| trouble(io::Error::from(errno)).to_string();
        assert!(sentence(rustix::io::Errno::PERM).contains("AF_CAN"));
        assert!(sentence(rustix::io::Errno::AFNOSUPPORT).contains("modprobe can-raw"));
        assert!(sentence(rustix::io::Errno::NODEV).contains("letoff devices"));
    }
}
