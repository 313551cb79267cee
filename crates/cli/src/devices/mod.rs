//! `letoff devices`: connected devices, reasons for missing ones, and advice on the set-up.

use std::io::Write;

use boards::links::address::Address;
use boards::links::discovery;
use clap::Args;
use documents::shown;
use firmware_protocol::key::KeyIndex;
use serde::Serialize;

use super::arguments::{link_help, note};
use super::{Failure, print_json};
use boards::conformance::ConformanceDepth;

mod board_list;
mod health;
mod settings;
mod test;

use self::settings::BoardSetting;

/// Longest time for the boards of one link to answer (us).
const PATIENCE_US: u64 = 2_500_000;

/// Options of `letoff devices`.
#[derive(Clone, Debug, Default, Args)]
#[command(after_help = "Examples:
  letoff devices --json
  letoff devices --boards --link serial:/dev/ttyACM0 --light 3
  letoff devices --boards --link serial:/dev/ttyACM0 --test=arm
  letoff devices --boards --link serial:/dev/ttyACM0 --set number=3

--test says item by item whether the boards keep firmware-protocol/PROTOCOL.md,
and ends with exit code 1 if one does not. No board is armed and no force is sent;
with --test=arm boards are armed, and each key is asked for 0.05 N at most; with
--test=stop they are stopped in the end, until they are started anew.")]
#[expect(clippy::struct_excessive_bools, reason = "the flags of a command line")]
pub struct DevicesArgs {
    /// Asks on the links who is there, and lists the boards instead.
    #[arg(long)]
    pub boards: bool,
    /// Links to be asked.
    #[arg(long = "link", value_name = "LINK", help = link_help(), value_parser = Address::parse,
          requires = "boards")]
    pub links: Vec<Address>,
    /// Lets the board with this number blink.
    #[arg(long, value_name = "N", requires = "boards")]
    pub light: Option<u8>,
    /// Only the board with this number.
    #[arg(long, value_name = "N", requires = "boards")]
    pub board: Option<u8>,
    /// Tries whether the boards keep the protocol: quiet (without a value), arm or stop.
    #[arg(long, value_name = "HOW", requires = "boards", value_parser = test::depth,
          num_args = 0..=1, require_equals = true, default_missing_value = "quiet",
          conflicts_with_all = ["light", "log", "set"])]
    pub test: Option<ConformanceDepth>,
    /// Writes a setting that the board keeps: number, first_key or max_force_mn.
    #[arg(long, value_name = "NAME=VALUE", requires = "boards",
          value_parser = BoardSetting::parse)]
    pub set: Vec<BoardSetting>,
    /// Prints how the boards and their keys are, where boards know it.
    #[arg(long, requires = "boards")]
    pub health: bool,
    /// Takes the motor of a key off, until its board is started anew.
    #[arg(long, value_name = "KEY", requires = "boards", value_parser = note)]
    pub mute: Vec<KeyIndex>,
    /// Takes the motor of a key back on.
    #[arg(long, value_name = "KEY", requires = "boards", value_parser = note)]
    pub unmute: Vec<KeyIndex>,
    /// Lets the board start its bootloader, so that its firmware can be changed.
    #[arg(long, requires = "boards", conflicts_with_all = ["light", "log", "set", "health"])]
    pub bootloader: bool,
    /// Prints the boards' logs.
    #[arg(long, requires = "boards")]
    pub log: bool,
    /// Prints the list as JSON.
    #[arg(long)]
    pub json: bool,
}

#[derive(Debug, Serialize)]
struct Section {
    kind: &'static str,
    found: Vec<Device>,
    /// Reason why none was found, and the remedy.
    why_empty: Option<String>,
}

#[derive(Debug, Serialize)]
struct Device {
    name: String,
    detail: String,
    /// Reason why it cannot be used, and the remedy.
    obstacle: Option<String>,
    /// Settings that are bad for forces, each with the remedy.
    advice: Vec<String>,
}

/// Prints serial ports, CAN interfaces, MIDI ports, and the machine's effects on a tick.
pub(super) fn run(args: &DevicesArgs, out: &mut dyn Write) -> Result<(), Failure> {
    if args.boards {
        return board_list::run(args, out);
    }
    let sections = [serial(), can(), midi(), machine()];
    if args.json {
        return print_json(&sections, out);
    }
    sections.iter().try_for_each(|section| print(section, out))
}

fn print(section: &Section, out: &mut dyn Write) -> Result<(), Failure> {
    writeln!(out, "{}:", section.kind)?;
    for device in &section.found {
        writeln!(out, "{}", format!("  {:24} {}", device.name, device.detail).trim_end())?;
        if let Some(obstacle) = &device.obstacle {
            writeln!(out, "    cannot be used: {obstacle}")?;
        }
        for advice in &device.advice {
            writeln!(out, "    advice: {advice}")?;
        }
    }
    if let Some(why) = &section.why_empty {
        writeln!(out, "  none: {why}")?;
    }
    Ok(())
}

/// Returns a section with a listing, or with the reason why there is none.
fn section<T, E: std::fmt::Display>(
    kind: &'static str,
    listing: Result<discovery::Listing<T>, E>,
    device: impl Fn(T) -> Device,
) -> Section {
    match listing {
        Ok(listing) => Section {
            kind,
            found: listing.found.into_iter().map(device).collect(),
            why_empty: listing.why_empty,
        },
        Err(error) => Section { kind, found: Vec::new(), why_empty: Some(error.to_string()) },
    }
}

fn serial() -> Section {
    section("Serial ports", discovery::serial_ports(), |port| Device {
        name: shown(&port.path),
        detail: line(&port),
        obstacle: port.obstacle.map(|it| it.to_string()),
        advice: port.advice,
    })
}

fn can() -> Section {
    section("CAN interfaces", discovery::can_interfaces(), |interface| Device {
        detail: wire(&interface),
        obstacle: interface.obstacle.map(|it| it.to_string()),
        name: interface.name,
        advice: interface.advice,
    })
}

fn machine() -> Section {
    let listing: Result<_, std::convert::Infallible> = Ok(discovery::this_machine());
    section("This machine", listing, |fact| Device {
        name: fact.name.to_owned(),
        detail: fact.detail,
        obstacle: None,
        advice: fact.advice.into_iter().collect(),
    })
}

fn line(port: &discovery::SerialPort) -> String {
    let speed = port.place.as_ref().map(|place| speed(place.speed).to_owned());
    let latency = port.latency.map(|ms| format!("latency timer {ms} ms"));
    let parts = [port.usb.as_ref().map(usb), speed, latency];
    parts.into_iter().flatten().collect::<Vec<_>>().join(", ")
}

fn usb(usb: &discovery::UsbIdentity) -> String {
    let serial = usb.serial.as_deref().unwrap_or("no serial number");
    format!("USB {:04x}:{:04x} {}, {serial}", usb.vendor, usb.product, usb.name)
}

const fn speed(speed: discovery::UsbSpeed) -> &'static str {
    match speed {
        discovery::UsbSpeed::Low => "low speed",
        discovery::UsbSpeed::Full => "full speed",
        discovery::UsbSpeed::High => "high speed",
        discovery::UsbSpeed::Super => "SuperSpeed",
    }
}

fn wire(it: &discovery::CanInterface) -> String {
    let kind = if it.carries_fd { "CAN FD" } else { "classic CAN" };
    let origin = if it.is_virtual { "virtual " } else { "" };
    let parts = [
        Some(format!("{origin}{kind}, {}", it.state)),
        it.mtu.map(|mtu| format!("MTU {mtu}")),
        it.queue_length.map(|n| format!("queue of {n}")),
        it.driver.as_ref().map(|driver| format!("driver {driver}")),
    ];
    let controller = it.link.as_ref().map(controller).unwrap_or_default();
    parts.into_iter().flatten().chain(controller).collect::<Vec<_>>().join(", ")
}

fn controller(link: &discovery::CanLink) -> Vec<String> {
    let rate = |it: discovery::BitTiming| {
        let percent = f64::from(it.sample_point) / 10.0;
        format!("{} Mbit/s sampled at {percent} %", f64::from(it.bitrate) / 1e6)
    };
    let errors = link.tx_errors.zip(link.rx_errors);
    let parts = [
        link.nominal.map(rate),
        link.data.map(|it| format!("data {}", rate(it))),
        link.state.clone(),
        errors.map(|(tx, rx)| format!("{tx} transmit and {rx} receive errors")),
        link.restart_ms.map(|ms| format!("restart-ms {ms}")),
        (!link.modes.is_empty()).then(|| format!("modes {}", link.modes.join(" "))),
    ];
    parts.into_iter().flatten().collect()
}

fn midi() -> Section {
    let (found, why_empty) = match midi::ports() {
        Ok(ports) if ports.is_empty() => {
            (ports, Some("no program offers one; start the synthesizer first".to_owned()))
        }
        Ok(ports) => (ports, None),
        Err(unavailable) => (Vec::new(), Some(unavailable.to_string())),
    };
    let device = |name| Device { name, detail: String::new(), obstacle: None, advice: Vec::new() };
    Section { kind: "MIDI ports", found: found.into_iter().map(device).collect(), why_empty }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn text(section: &Section) -> String {
        let mut out = Vec::new();
        print(section, &mut out).unwrap();
        String::from_utf8(out).unwrap()
    }

    #[test]
    fn advice_stands_under_its_device() {
        let device = Device {
            name: "can0".to_owned(),
            detail: "CAN FD, up".to_owned(),
            obstacle: Some("it is off".to_owned()),
            advice: vec!["do this".to_owned(), "do that".to_owned()],
        };
        let section = Section { kind: "CAN interfaces", found: vec![device], why_empty: None };
        assert_eq!(
            text(&section),
            "CAN interfaces:\n  can0                     CAN FD, up\n    \
             cannot be used: it is off\n    advice: do this\n    advice: do that\n"
        );
    }

    #[test]
    fn the_list_has_four_sections_for_a_reader_and_for_a_program() {
        let print = |json| {
            let mut out = Vec::new();
            run(&DevicesArgs { json, ..DevicesArgs::default() }, &mut out).unwrap();
            String::from_utf8(out).unwrap()
        };
        let (text, json) = (print(false), print(true));
        for kind in ["Serial ports", "CAN interfaces", "MIDI ports", "This machine"] {
            assert!(text.contains(&format!("{kind}:\n")), "{text}");
            assert!(json.contains(kind), "{json}");
        }
    }
}
