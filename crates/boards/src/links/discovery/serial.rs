use std::path::{Path, PathBuf};

use serialport::SerialPortType;

use super::{Listing, Obstacle, access::User, diagnosis, diagnosis::usb::UsbPlace};
use crate::links::Error;

/// Linux' list of ports, required for the listing.
const TTYS: &str = "/sys/class/tty";
const SYS: &str = "/sys";

const NONE: &str = "there is no serial port: plug in a board, or give a port by its path, \
                    which is the only way to a pseudo-terminal";

/// A serial port of this machine.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct SerialPort {
    pub path: PathBuf,
    /// Identity, if it is a USB device; boards are distinguished by its serial number.
    pub usb: Option<UsbIdentity>,
    pub place: Option<UsbPlace>,
    /// Delay of bytes by its adapter, if it has a latency timer (ms).
    pub latency: Option<u32>,
    pub obstacle: Option<Obstacle>,
    pub advice: Vec<String>,
}

/// Self-description of a USB device.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct UsbIdentity {
    pub vendor: u16,
    pub product: u16,
    pub serial: Option<String>,
    pub name: String,
}

/// Lists the serial ports of this machine; opens none of them.
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
