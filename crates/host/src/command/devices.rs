//! `letoff devices`: what is connected, and why something is missing.

use std::io::Write;

use clap::Args;
use hardware::discovery;
use serde::Serialize;

use super::{Failure, print_json};

/// What `letoff devices` takes.
#[derive(Clone, Copy, Debug, Args)]
#[command(after_help = "Example:
  letoff devices --json")]
pub struct DevicesArgs {
    /// Prints the list as JSON.
    #[arg(long)]
    pub json: bool,
}

/// One kind of device.
#[derive(Debug, Serialize)]
struct Section {
    kind: &'static str,
    found: Vec<Device>,
    /// Why nothing was found, and what to do.
    why_empty: Option<String>,
}

#[derive(Debug, Serialize)]
struct Device {
    name: String,
    detail: String,
    /// Why it cannot be used, and what to do.
    obstacle: Option<String>,
}

/// Prints serial ports, CAN interfaces and MIDI ports.
pub(super) fn run(args: DevicesArgs, out: &mut dyn Write) -> Result<(), Failure> {
    let sections = [serial(), can(), midi()];
    if args.json {
        return print_json(&sections, out);
    }
    for section in &sections {
        writeln!(out, "{}:", section.kind)?;
        for device in &section.found {
            writeln!(out, "  {:24} {}", device.name, device.detail)?;
            if let Some(obstacle) = &device.obstacle {
                writeln!(out, "    cannot be used: {obstacle}")?;
            }
        }
        if let Some(why) = &section.why_empty {
            writeln!(out, "  none: {why}")?;
        }
    }
    writeln!(
        out,
        "Boards are driven by a simulated keybed in this version; real links come next."
    )?;
    Ok(())
}

/// A section from a listing, or from the reason why there is none.
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
        name: port.path.display().to_string(),
        detail: port.usb.as_ref().map_or_else(String::new, usb),
        obstacle: port.obstacle.map(|it| it.to_string()),
    })
}

fn can() -> Section {
    section("CAN interfaces", discovery::can_interfaces(), |interface| Device {
        detail: wire(&interface),
        obstacle: interface.obstacle.map(|it| it.to_string()),
        name: interface.name,
    })
}

fn usb(usb: &discovery::UsbIdentity) -> String {
    let serial = usb.serial.as_deref().unwrap_or("no serial number");
    format!("USB {:04x}:{:04x} {}, {serial}", usb.vendor, usb.product, usb.name)
}

fn wire(it: &discovery::CanInterface) -> String {
    let kind = if it.carries_fd { "CAN FD" } else { "classic CAN" };
    let origin = if it.is_virtual { "virtual " } else { "" };
    let queue = it.queue_length.map_or_else(String::new, |n| format!(", queue of {n}"));
    format!("{origin}{kind}, {}{queue}", it.state)
}

fn midi() -> Section {
    let (found, why_empty) = match midi::ports() {
        Ok(ports) if ports.is_empty() => {
            (ports, Some("no program offers one; start the synthesizer first".to_owned()))
        }
        Ok(ports) => (ports, None),
        Err(unavailable) => (Vec::new(), Some(unavailable.to_string())),
    };
    let device = |name| Device { name, detail: String::new(), obstacle: None };
    Section { kind: "MIDI ports", found: found.into_iter().map(device).collect(), why_empty }
}
