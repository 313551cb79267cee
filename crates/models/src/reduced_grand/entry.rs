//! Names, modes and guards of the reduced grand, and where each guard leads.

use pode::Model as _;

use super::{Mode, ReducedGrand, parameters, presets};
use crate::entry::{GuardEntry, ModeEntry, ModelEntry};

/// All modes, in the order of their numbers.
pub(super) const MODES: [Mode; 11] = [
    Mode::Acc,
    Mode::Lo,
    Mode::Fla,
    Mode::Fll,
    Mode::Flt,
    Mode::Stu,
    Mode::Stt,
    Mode::RepH,
    Mode::RepL,
    Mode::Rep0,
    Mode::Chk,
];

/// The head goes where the key goes.
const CARRIED: (u8, u8) = (2, 1);
/// Key and head move by themselves.
const APART: (u8, u8) = (2, 0);

const RESET: GuardEntry = GuardEntry::new("reset", "m", &["FLA", "REP0"]);

const MODE_ENTRIES: [ModeEntry; 11] = [
    ModeEntry::new(
        "ACC",
        CARRIED,
        &[GuardEntry::new("lift-off", "N", &["FLA"]), GuardEntry::new("button", "m", &["LO"])],
    ),
    ModeEntry::new(
        "LO",
        CARRIED,
        &[
            GuardEntry::new("lift-off", "N", &["FLL"]),
            GuardEntry::new("button-off", "m", &["ACC"]),
            GuardEntry::new("trip", "m", &["FLT"]),
        ],
    ),
    ModeEntry::new(
        "FLA",
        APART,
        &[
            GuardEntry::new("land", "m", &["ACC"]),
            GuardEntry::new("button", "m", &["FLL"]),
            GuardEntry::new("string-on", "m", &["STU"]),
        ],
    ),
    ModeEntry::new(
        "FLL",
        APART,
        &[
            GuardEntry::new("land", "m", &["LO"]),
            GuardEntry::new("button-off", "m", &["FLA"]),
            GuardEntry::new("trip", "m", &["FLT"]),
            GuardEntry::new("string-on", "m", &["STU"]),
        ],
    ),
    ModeEntry::new(
        "FLT",
        APART,
        &[
            GuardEntry::new("string-on", "m", &["STT"]),
            GuardEntry::new("rep-on", "m", &["REPH", "REPL"]),
            RESET,
        ],
    ),
    ModeEntry::new(
        "STU",
        APART,
        &[
            GuardEntry::new("string-off", "m", &["FLA", "FLL"]),
            GuardEntry::new("trip", "m", &["STT"]),
        ],
    ),
    ModeEntry::new(
        "STT",
        APART,
        &[GuardEntry::new("string-off", "m", &["FLT"]), GuardEntry::new("reset", "m", &["STU"])],
    ),
    ModeEntry::new(
        "REPH",
        APART,
        &[
            GuardEntry::new("rep-off", "m", &["FLT"]),
            GuardEntry::new("check", "m", &["CHK"]),
            GuardEntry::new("check-far", "m", &["REPL"]),
        ],
    ),
    ModeEntry::new(
        "REPL",
        APART,
        &[
            GuardEntry::new("rep-off", "m", &["FLT"]),
            GuardEntry::new("check-near", "m", &["REPH"]),
            RESET,
        ],
    ),
    ModeEntry::new(
        "REP0",
        APART,
        &[
            GuardEntry::new("rep-off", "m", &["FLA"]),
            GuardEntry::new("jack-in", "m", &["FLA"]),
            GuardEntry::new("jack-out", "m", &["REPL"]),
        ],
    ),
    ModeEntry::new("CHK", CARRIED, &[GuardEntry::new("check-off", "m", &["REPL"])]),
];

/// What is known of the model without building one.
pub static ENTRY: ModelEntry = ModelEntry {
    name: "reduced-grand",
    summary: "a grand's key and hammer with let-off, check and repetition, reduced to two coordinates",
    file: None,
    parameters: &parameters::PARAMETERS,
    presets: &presets::PRESETS,
    input: "s",
    input_unit: "m",
    states: &["y", "z", "u", "w"],
    state_units: &["m", "m", "m/s", "m/s"],
    coordinates: ReducedGrand::COORDS,
    modes: &MODE_ENTRIES,
    outputs: &["F_KU", "F_jack", "F_lever", "F_string"],
    output_units: &["N", "N", "N", "N"],
};
