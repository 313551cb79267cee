//! CAN interfaces, from the kernel's files on network interfaces and from `ip`.

use std::{collections::BTreeMap, fs, path::Path};

use super::can_link::{self, CanLink};
use super::{Listing, Obstacle, can_interface::CanInterface, diagnosis};
use crate::links::Error;

/// Hardware type of CAN in `type`: `ARPHRD_CAN`.
const CAN: u32 = 280;
/// MTU of an interface that carries CAN FD frames: `CANFD_MTU`.
const FD_MTU: u32 = 72;
/// Bit of `flags` for an interface that was brought up: `IFF_UP`.
const UP: u32 = 0x1;

const NONE: &str = "there is no CAN interface: plug in an adapter whose driver is in the \
                    kernel, or make a virtual one: sudo modprobe vcan && \
                    sudo ip link add vcan0 type vcan";

pub fn can_interfaces() -> Result<Listing<CanInterface>, Error> {
    let mut listing = known_can_interfaces()?;
    if cfg!(target_os = "linux") {
        let kernel = diagnosis::kernel::KernelVersion::read(Path::new("/"));
        examine(&mut listing.found, &can_link::ask_ip(), kernel);
    }
    Ok(listing)
}

/// Lists the CAN interfaces from the kernel's files alone: without `ip`, and without advice.
pub(crate) fn known_can_interfaces() -> Result<Listing<CanInterface>, Error> {
    if cfg!(target_os = "linux") {
        interfaces_in(Path::new("/sys/class/net"))
    } else {
        let why = "CAN interfaces are known on Linux only, as SocketCAN; elsewhere use serial";
        Ok(Listing::new(Vec::new(), why))
    }
}

/// Adds the output of `ip`, and advice for a kernel of this version.
fn examine(
    found: &mut [CanInterface],
    links: &BTreeMap<String, CanLink>,
    kernel: Option<diagnosis::kernel::KernelVersion>,
) {
    for can in found {
        can.link = links.get(&can.name).cloned();
        can.advice = diagnosis::can::advice(can, kernel);
    }
}

fn interfaces_in(net: &Path) -> Result<Listing<CanInterface>, Error> {
    let unreadable = |source| Error::Unreadable { path: net.to_owned(), source };
    let folders = fs::read_dir(net).map_err(unreadable)?;
    // An interface may vanish while it is read; then it is not listed.
    let mut found: Vec<_> =
        folders.flatten().filter_map(|folder| interface(&folder.path())).collect();
    found.sort_by(|one, other| one.name.cmp(&other.name));
    Ok(Listing::new(found, NONE))
}

fn interface(folder: &Path) -> Option<CanInterface> {
    let text =
        |file: &str| fs::read_to_string(folder.join(file)).ok().map(|text| text.trim().to_owned());
    let number = |file: &str| text(file)?.parse().ok();
    if number("type") != Some(CAN) {
        return None;
    }
    let name = folder.file_name()?.to_string_lossy().into_owned();
    let flags = text("flags")?;
    let flags = u32::from_str_radix(flags.trim_start_matches("0x"), 16).ok()?;
    let mtu = number("mtu");
    let mut can = CanInterface {
        is_virtual: !folder.join("device").exists(),
        carries_fd: mtu == Some(FD_MTU),
        mtu,
        is_up: flags & UP != 0,
        state: text("operstate").unwrap_or_else(|| "unknown".to_owned()),
        queue_length: number("tx_queue_len"),
        driver: text("device/uevent").and_then(|it| driver(&it)),
        link: None,
        obstacle: None,
        advice: Vec::new(),
        name,
    };
    can.obstacle = can.find_obstacle();
    Some(can)
}

fn driver(uevent: &str) -> Option<String> {
    uevent.lines().find_map(|line| line.strip_prefix("DRIVER=")).map(str::to_owned)
}

impl CanInterface {
    fn find_obstacle(&self) -> Option<Obstacle> {
        let name = &self.name;
        if self.is_up {
            return (self.state == "down").then(|| Obstacle::NotRunning { name: name.clone() });
        }
        // A real interface has no bit rate until it is set.
        let rates = if self.is_virtual {
            ""
        } else {
            " type can bitrate 1000000 dbitrate 5000000 fd on restart-ms 100"
        };
        Some(Obstacle::Down { command: format!("sudo ip link set {name} up{rates}") })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::links::discovery::testing::Root;

    const ETHERNET: (&str, &[(&str, &str)]) = ("eth0", &[("type", "1"), ("flags", "0x1003")]);

    #[test]
    fn ethernet_is_no_can_and_the_empty_list_says_what_to_do() {
        let net = Root::new("empty").with_all(ETHERNET.0, ETHERNET.1);
        let listing = interfaces_in(net.path()).unwrap();
        assert_eq!(listing.found, []);
        assert!(listing.why_empty.unwrap().contains("there is no CAN interface"));
    }

    #[test]
    fn an_interface_that_is_down_says_how_to_bring_it_up() {
        let files = [("type", "280"), ("flags", "0x80"), ("mtu", "16"), ("device", "")];
        let net = Root::new("down").with_all("can0", &files);
        let [can] = interfaces_in(net.path()).unwrap().found.try_into().unwrap();
        assert!(!can.is_up && !can.is_virtual && !can.carries_fd);
        let sentence = can.obstacle.unwrap().to_string();
        let command = "sudo ip link set can0 up type can bitrate 1000000";
        assert!(sentence.contains(command), "{sentence}");
    }

    #[test]
    fn a_virtual_interface_that_is_up_has_no_obstacle() {
        let files = [
            ("type", "280"),
            ("flags", "0xc1"),
            ("mtu", "72"),
            ("operstate", "unknown"),
            ("tx_queue_len", "1000"),
        ];
        let net = Root::new("up").with_all("vcan1", &files).with_all("vcan0", &files);
        let listing = interfaces_in(net.path()).unwrap();
        let names: Vec<_> = listing.found.iter().map(|can| can.name.as_str()).collect();
        assert_eq!(names, ["vcan0", "vcan1"]);
        let can = &listing.found[0];
        assert!(can.is_up && can.is_virtual && can.carries_fd && can.obstacle.is_none());
        assert_eq!((can.queue_length, &listing.why_empty), (Some(1_000), &None));
    }

    #[test]
    fn a_controller_is_examined_with_what_ip_tells_of_it() {
        let files = [
            ("type", "280"),
            ("flags", "0x400c1"),
            ("mtu", "72"),
            ("operstate", "up"),
            ("tx_queue_len", "10"),
            ("device/uevent", "DRIVER=gs_usb\nDEVTYPE=usb_interface"),
        ];
        let net = Root::new("examined").with_all("can0", &files);
        let mut found = interfaces_in(net.path()).unwrap().found;
        let ip = r#"[{"ifname":"can0","link_type":"can",
            "linkinfo":{"info_kind":"can","info_data":{"restart_ms":0}}}]"#;
        examine(&mut found, &can_link::parse(ip), None);
        let [can] = found.try_into().unwrap();
        assert_eq!((can.mtu, can.driver.as_deref()), (Some(72), Some("gs_usb")));
        assert_eq!(can.link.unwrap().restart_ms, Some(0));
        let [restart, queue] = can.advice.try_into().unwrap();
        assert!(restart.contains("restart-ms 100") && queue.contains("txqueuelen"));
    }
}
