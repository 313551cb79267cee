//! Installs the package under a real systemd in a guest; `checks.sh` exercises the service.

use std::time::Duration;

use crate::guest::{GuestCheck, GuestSystem, TriedProgram};
use crate::tools::Tool;

const PROGRAMS: [Tool; 5] = [
    ("/lib/systemd/systemd", "systemd"),
    ("/lib/systemd/systemd-udevd", "udev"),
    ("deb-systemd-invoke", "init-system-helpers"),
    ("chrt", "util-linux"),
    ("ip", "iproute2"),
];

/// Modules for this machine's files, CAN, and an FTDI serial port.
const MODULES: [&str; 8] =
    ["virtio-pci", "9pnet-virtio", "9p", "overlay", "can-raw", "vcan", "xhci-pci", "ftdi-sio"];

/// Returns the guest that installs a package of programs built with `profile`.
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
