//! Position of a USB device: its speed, and the devices that share it.

use std::path::{Path, PathBuf};

use super::files::{number, text};

/// `bDeviceProtocol` of a high-speed hub with a transaction translator for each port.
const MULTI_TT: &str = "02";

/// Signalling rate of a USB device.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum UsbSpeed {
    Low,
    Full,
    High,
    Super,
}

impl UsbSpeed {
    fn of(megabits: &str) -> Option<Self> {
        let megabits: f64 = megabits.parse().ok()?;
        Some(if megabits < 12.0 {
            Self::Low
        } else if megabits < 480.0 {
            Self::Full
        } else if megabits < 5_000.0 {
            Self::High
        } else {
            Self::Super
        })
    }
}

/// The USB device behind a port.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct UsbPlace {
    pub folder: PathBuf,
    pub speed: UsbSpeed,
    /// Owner of the 12 Mbit/s that full-speed devices share: a port, or a hub with one translator.
    pub shared: Option<PathBuf>,
    /// Time without traffic after which it is put to sleep; `None` for never (ms).
    pub sleeps_after: Option<u32>,
}

/// Returns the USB device of the terminal `tty`, if it is one, from the files under `sys`.
pub(in super::super) fn place(sys: &Path, tty: &str) -> Option<UsbPlace> {
    let device = sys.join("class/tty").join(tty).join("device").canonicalize().ok()?;
    let folder = device.ancestors().find(|it| it.join("idVendor").exists())?.to_owned();
    let speed = speed(&folder)?;
    Some(UsbPlace {
        shared: (speed == UsbSpeed::Full).then(|| domain(&folder)),
        sleeps_after: sleeps_after(&folder),
        speed,
        folder,
    })
}

fn speed(folder: &Path) -> Option<UsbSpeed> {
    UsbSpeed::of(&text(&folder.join("speed"))?)
}

/// Walks up the tree, past full-speed hubs, to the owner of 12 Mbit/s.
fn domain(device: &Path) -> PathBuf {
    let mut below = device;
    while let Some(hub) = below.parent().filter(|hub| hub.join("speed").exists()) {
        let is_root = hub.file_name().is_some_and(|name| name.to_string_lossy().starts_with("usb"));
        if !is_root && speed(hub) == Some(UsbSpeed::High) {
            let protocol = text(&hub.join("bDeviceProtocol"));
            let own = protocol.as_deref() == Some(MULTI_TT);
            return if own { below } else { hub }.to_owned();
        }
        if is_root {
            break;
        }
        below = hub;
    }
    below.to_owned()
}

fn sleeps_after(folder: &Path) -> Option<u32> {
    let power = folder.join("power");
    let automatic = text(&power.join("control")).as_deref() == Some("auto");
    let delay = || number::<i64>(&power.join("autosuspend_delay_ms")).unwrap_or(0);
    // A negative delay means never.
    automatic.then(delay)?.try_into().ok()
}

#[cfg(all(test, unix))]
pub(super) mod tests {
    use super::*;
    use crate::links::discovery::testing::Root;

    const BUS: &str = "devices/pci0/usb1";

    fn with_usb(root: Root, path: &str, speed: &str, protocol: &str) -> Root {
        let files = [("idVendor", "1209"), ("speed", speed), ("bDeviceProtocol", protocol)];
        root.with_all(&format!("{BUS}{path}"), &files)
    }

    fn with_tty(root: Root, path: &str, tty: &str) -> Root {
        let interface = format!("{BUS}{path}/interface");
        root.with(&format!("{interface}/bInterfaceNumber"), "00")
            .with_link(&format!("class/tty/{tty}/device"), &interface)
    }

    pub(in super::super) fn tree(test: &str, protocol: &str) -> Root {
        let mut root = with_usb(Root::new(test), "", "480", "01");
        root = with_usb(root, "/1-1", "480", protocol);
        for (path, tty) in
            [("/1-1/1-1.1", "ttyACM0"), ("/1-1/1-1.2", "ttyACM1"), ("/1-2", "ttyACM2")]
        {
            root = with_tty(with_usb(root, path, "12", "00"), path, tty);
        }
        root
    }

    #[test]
    fn devices_behind_a_hub_share_its_translator_unless_each_port_has_one() {
        for (test, protocol, is_one) in [("single-tt", "01", true), ("multi-tt", "02", false)] {
            let root = tree(test, protocol);
            let shared = |tty| place(root.path(), tty).unwrap().shared.unwrap();
            assert_eq!(shared("ttyACM0") == shared("ttyACM1"), is_one, "{test}");
            assert_eq!(shared("ttyACM0").ends_with("usb1/1-1"), is_one, "{test}");
            assert_ne!(shared("ttyACM0"), shared("ttyACM2"), "{test}");
        }
    }

    #[test]
    fn a_full_speed_hub_shares_what_it_has() {
        let mut root = tree("full-speed-hub", "02");
        root = with_usb(root, "/1-1/1-1.3", "12", "00");
        for tty in ["ttyACM3", "ttyACM4"] {
            let path = format!("/1-1/1-1.3/{tty}");
            root = with_tty(with_usb(root, &path, "12", "00"), &path, tty);
        }
        let shared = |tty| place(root.path(), tty).unwrap().shared.unwrap();
        assert_eq!(shared("ttyACM3"), shared("ttyACM4"));
        assert!(shared("ttyACM3").ends_with("1-1.3"));
    }

    #[test]
    fn a_high_speed_device_shares_no_translator() {
        let root = with_tty(with_usb(Root::new("high"), "/1-1", "480", "00"), "/1-1", "ttyACM0");
        let place = place(root.path(), "ttyACM0").unwrap();
        assert_eq!((place.speed, place.shared, place.sleeps_after), (UsbSpeed::High, None, None));
    }

    #[test]
    fn a_device_sleeps_if_the_kernel_may_send_it_to() {
        let power = |delay| {
            let files = [("control", "auto"), ("autosuspend_delay_ms", delay)];
            let root = tree("sleep", "01").with_all(&format!("{BUS}/1-2/power"), &files);
            place(root.path(), "ttyACM2").unwrap().sleeps_after
        };
        assert_eq!((power("2000"), power("-1000")), (Some(2_000), None));
    }

    #[test]
    fn a_port_on_the_board_is_no_usb_device() {
        let root = Root::new("platform").with("devices/serial8250/driver_override", "");
        let root = root.with_link("class/tty/ttyS0/device", "devices/serial8250");
        assert_eq!(place(root.path(), "ttyS0"), None);
    }
}
