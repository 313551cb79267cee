//! Serial ports, as the system lists them.

use std::path::{Path, PathBuf};

use serialport::SerialPortType;

use super::access::User;
use super::diagnosis;
use super::diagnosis::usb::UsbPlace;
use super::{Listing, Obstacle};
use crate::links::Error;

/// Where Linux lists its ports; without it the list cannot be made.
const TTYS: &str = "/sys/class/tty";
/// The kernel's files on devices.
const SYS: &str = "/sys";

const NONE: &str = "there is no serial port: plug in a board, or give a port by its path, \
                    which is the only way to a pseudo-terminal";

/// A serial port of this machine.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct SerialPort {
    /// What it is opened by.
    pub path: PathBuf,
    /// Who is behind it, if it is a USB device; boards are told apart by its serial number.
    pub usb: Option<UsbIdentity>,
    /// Where it hangs, if it is a USB device.
    pub place: Option<UsbPlace>,
    /// How long its adapter holds bytes back, if it is one that does (ms).
    pub latency: Option<u32>,
    /// Why it cannot be used, if that is known.
    pub obstacle: Option<Obstacle>,
    /// What to change, each in a sentence.
    pub advice: Vec<String>,
}

/// What a USB device says of itself.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct UsbIdentity {
    pub vendor: u16,
    pub product: u16,
    pub serial: Option<String>,
    /// The maker's and the product's names, as far as they are told.
    pub name: String,
}

/// Lists the serial ports of this machine; opens none of them.
///
/// # Errors
/// The system does not list its ports.
pub fn serial_ports() -> Result<Listing<SerialPort>, Error> {
    if cfg!(target_os = "linux") && !Path::new(TTYS).is_dir() {
        return Ok(Listing::new(Vec::new(), "there is no /sys/class/tty: is /sys mounted?"));
    }
    let user = User::current();
    let ports = serialport::available_ports()?;
    let mut found: Vec<_> = ports.into_iter().map(|port| describe(port, &user)).collect();
    found.sort_by(|one, other| one.path.cmp(&other.path));
    examine(&mut found, Path::new(SYS));
    Ok(Listing::new(found, NONE))
}

fn describe(port: serialport::SerialPortInfo, user: &User) -> SerialPort {
    let path = PathBuf::from(port.port_name);
    let usb = match port.port_type {
        SerialPortType::UsbPort(usb) => Some(UsbIdentity {
            vendor: usb.vid,
            product: usb.pid,
            name: [usb.manufacturer, usb.product]
                .into_iter()
                .flatten()
                .collect::<Vec<_>>()
                .join(" "),
            serial: usb.serial_number,
        }),
        SerialPortType::PciPort | SerialPortType::BluetoothPort | SerialPortType::Unknown => None,
    };
    let obstacle = user.obstacle(&path);
    SerialPort { path, usb, place: None, latency: None, obstacle, advice: Vec::new() }
}

/// Adds what the files under `sys` tell, and what to change.
fn examine(ports: &mut [SerialPort], sys: &Path) {
    for port in &mut *ports {
        let tty = tty(&port.path);
        port.place = diagnosis::usb::place(sys, &tty);
        port.latency = diagnosis::serial::latency_timer(sys, &tty);
    }
    let places: Vec<_> = ports.iter().filter_map(|port| port.place.clone()).collect();
    for port in ports {
        let tty = tty(&port.path);
        port.advice = diagnosis::serial::advice(&tty, port.latency, port.place.as_ref(), &places);
    }
}

/// Returns the kernel's name of a port.
fn tty(path: &Path) -> String {
    path.file_name().unwrap_or_default().to_string_lossy().into_owned()
}

#[cfg(test)]
mod tests {
    use super::*;
    use serialport::{SerialPortInfo, UsbPortInfo};

    #[test]
    fn a_usb_board_is_known_by_its_serial_number() {
        let usb = UsbPortInfo {
            vid: 0x1209,
            pid: 0x4B42,
            serial_number: Some("BASS-01".to_owned()),
            manufacturer: Some("Letoff".to_owned()),
            product: Some("key board".to_owned()),
        };
        let info = SerialPortInfo {
            port_name: "/dev/no-such-port".to_owned(),
            port_type: SerialPortType::UsbPort(usb),
        };
        let usb = describe(info, &User::current()).usb.unwrap();
        assert_eq!(usb.serial.as_deref(), Some("BASS-01"));
        assert_eq!(usb.name, "Letoff key board");
    }

    #[test]
    fn a_port_is_examined_with_what_the_kernel_tells_of_it() {
        let latency = "bus/usb-serial/devices/ttyUSB0/latency_timer";
        let root = crate::links::discovery::testing::Root::new("examined-port").with(latency, "16");
        let info = SerialPortInfo {
            port_name: "/dev/ttyUSB0".to_owned(),
            port_type: SerialPortType::Unknown,
        };
        let mut ports = [describe(info, &User::current())];
        examine(&mut ports, root.path());
        assert_eq!((ports[0].latency, ports[0].advice.len()), (Some(16), 1));
    }
}
