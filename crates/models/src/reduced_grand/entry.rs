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

const RESET: GuardEntry = GuardEntry::new("reset", &["FLA", "REP0"]);

const MODE_ENTRIES: [ModeEntry; 11] = [
    ModeEntry::new(
        "ACC",
        CARRIED,
        &[GuardEntry::new("lift-off", &["FLA"]), GuardEntry::new("button", &["LO"])],
    ),
    ModeEntry::new(
        "LO",
        CARRIED,
        &[
            GuardEntry::new("lift-off", &["FLL"]),
            GuardEntry::new("button-off", &["ACC"]),
            GuardEntry::new("trip", &["FLT"]),
        ],
    ),
    ModeEntry::new(
        "FLA",
        APART,
        &[
            GuardEntry::new("land", &["ACC"]),
            GuardEntry::new("button", &["FLL"]),
            GuardEntry::new("string-on", &["STU"]),
        ],
    ),
    ModeEntry::new(
        "FLL",
        APART,
        &[
            GuardEntry::new("land", &["LO"]),
            GuardEntry::new("button-off", &["FLA"]),
            GuardEntry::new("trip", &["FLT"]),
            GuardEntry::new("string-on", &["STU"]),
        ],
    ),
    ModeEntry::new(
        "FLT",
        APART,
        &[
            GuardEntry::new("string-on", &["STT"]),
            GuardEntry::new("rep-on", &["REPH", "REPL"]),
            RESET,
        ],
    ),
    ModeEntry::new(
        "STU",
        APART,
        &[GuardEntry::new("string-off", &["FLA", "FLL"]), GuardEntry::new("trip", &["STT"])],
    ),
    ModeEntry::new(
        "STT",
        APART,
        &[GuardEntry::new("string-off", &["FLT"]), GuardEntry::new("reset", &["STU"])],
    ),
    ModeEntry::new(
        "REPH",
        APART,
        &[
            GuardEntry::new("rep-off", &["FLT"]),
            GuardEntry::new("check", &["CHK"]),
            GuardEntry::new("check-far", &["REPL"]),
        ],
    ),
    ModeEntry::new(
        "REPL",
        APART,
        &[GuardEntry::new("rep-off", &["FLT"]), GuardEntry::new("check-near", &["REPH"]), RESET],
    ),
    ModeEntry::new(
        "REP0",
        APART,
        &[
            GuardEntry::new("rep-off", &["FLA"]),
            GuardEntry::new("jack-in", &["FLA"]),
            GuardEntry::new("jack-out", &["REPL"]),
        ],
    ),
    ModeEntry::new("CHK", CARRIED, &[GuardEntry::new("check-off", &["REPL"])]),
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
