//! Installs the package under a real systemd in a guest, and lets the service go through what
//! befalls one; what must hold is written in `checks.sh`.

use std::time::Duration;

use crate::guest::{GuestCheck, GuestSystem, TriedProgram};
use crate::tools::Tool;

/// What the guest finds among this machine's files.
const PROGRAMS: [Tool; 5] = [
    ("/lib/systemd/systemd", "systemd"),
    ("/lib/systemd/systemd-udevd", "udev"),
    ("deb-systemd-invoke", "init-system-helpers"),
    ("chrt", "util-linux"),
    ("ip", "iproute2"),
];

/// This machine's files, CAN, and a serial port of FTDI's.
const MODULES: [&str; 8] =
    ["virtio-pci", "9pnet-virtio", "9p", "overlay", "can-raw", "vcan", "xhci-pci", "ftdi-sio"];

/// The guest in which a package of programs is installed that are built with `profile`.
pub(crate) fn guest(profile: &str) -> GuestCheck {
    GuestCheck {
        name: "service",
        plays_on: "the package under systemd",
        system: GuestSystem::Systemd,
        modules: &MODULES,
        programs: &PROGRAMS,
        copies: &[],
        more: Vec::new(),
        files: vec![
            ("scene.toml", include_str!("scene.toml").into()),
            ("checks.sh", include_str!("checks.sh").into()),
        ],
        parts: &["service"],
        time_limit: Duration::from_mins(30),
        program: TriedProgram::Packaged(profile.to_owned()),
    }
}
