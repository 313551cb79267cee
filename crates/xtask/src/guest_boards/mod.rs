//! Plays and breaks boards over real drivers in a guest: CAN FD through `vcan`, USB through gadgets
//! on `dummy_hcd`. Guest time is executed instructions, so its counts hold anywhere.

mod conformance;

use std::time::Duration;

use crate::guest::{GuestCheck, GuestSystem, SCENE, TriedProgram, piece};
use crate::tools::Tool;

/// Tools that set up and disturb buses, and read reports.
pub(crate) const PROGRAMS: [Tool; 7] = [
    ("ip", "iproute2"),
    ("tc", "iproute2"),
    ("cansend", "can-utils"),
    ("cangen", "can-utils"),
    ("candump", "can-utils"),
    ("canbusload", "can-utils"),
    ("jq", "jq"),
];

/// CAN with a queue that can lose, delay and reject frames; eight USB ports with a device on each.
const MODULES: [&str; 7] =
    ["can-raw", "vcan echo=1", "sch-netem", "sch-tbf", "usb-f-acm", "dummy-hcd num=8", "cdc-acm"];

#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(crate) enum CheckScope {
    Short,
    Full,
}

/// Returns the guest with eight boards, on which `program` plays.
pub(crate) fn guest(form: CheckScope, program: TriedProgram) -> GuestCheck {
    let (word, minutes) = match form {
        CheckScope::Short => ("short", 15),
        CheckScope::Full => ("full", 60),
    };
    GuestCheck {
        name: "boards",
        plays_on: "boards over real drivers",
        system: GuestSystem::Busybox,
        modules: &MODULES,
        programs: &PROGRAMS,
        copies: &[],
        more: conformance::program().into_iter().collect(),
        files: vec![
            ("form", word.into()),
            ("scene.toml", SCENE.into()),
            ("piece.mid", piece::file()),
            ("checks.sh", include_str!("checks.sh").into()),
            ("play.sh", include_str!("play.sh").into()),
            ("can.sh", include_str!("can.sh").into()),
            ("fates.sh", include_str!("fates.sh").into()),
            ("refusals.sh", include_str!("refusals.sh").into()),
            ("usb.sh", include_str!("usb.sh").into()),
        ],
        parts: &["bus", "fates"],
        time_limit: Duration::from_mins(minutes),
        program,
    }
}
