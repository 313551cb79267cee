//! Names, modes and guards of the reduced grand, and where each guard leads.

use models::{GuardEntry, ModeEntry, ModelEntry};
use pode::Model as _;

use super::{Mode, ReducedGrand, parameters, presets};
use crate::entry;

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

const RESET: GuardEntry = entry::guard("reset", "m", &["FLA", "REP0"]);

const MODE_ENTRIES: [ModeEntry; 11] = [
    entry::mode(
        "ACC",
        CARRIED,
        &[entry::guard("lift-off", "N", &["FLA"]), entry::guard("button", "m", &["LO"])],
    ),
    entry::mode(
        "LO",
        CARRIED,
        &[
            entry::guard("lift-off", "N", &["FLL"]),
            entry::guard("button-off", "m", &["ACC"]),
            entry::guard("trip", "m", &["FLT"]),
        ],
    ),
    entry::mode(
        "FLA",
        APART,
        &[
            entry::guard("land", "m", &["ACC"]),
            entry::guard("button", "m", &["FLL"]),
            entry::guard("string-on", "m", &["STU"]),
        ],
    ),
    entry::mode(
        "FLL",
        APART,
        &[
            entry::guard("land", "m", &["LO"]),
            entry::guard("button-off", "m", &["FLA"]),
            entry::guard("trip", "m", &["FLT"]),
            entry::guard("string-on", "m", &["STU"]),
        ],
    ),
    entry::mode(
        "FLT",
        APART,
        &[
            entry::guard("string-on", "m", &["STT"]),
            entry::guard("rep-on", "m", &["REPH", "REPL"]),
            RESET,
        ],
    ),
    entry::mode(
        "STU",
        APART,
        &[entry::guard("string-off", "m", &["FLA", "FLL"]), entry::guard("trip", "m", &["STT"])],
    ),
    entry::mode(
        "STT",
        APART,
        &[entry::guard("string-off", "m", &["FLT"]), entry::guard("reset", "m", &["STU"])],
    ),
    entry::mode(
        "REPH",
        APART,
        &[
            entry::guard("rep-off", "m", &["FLT"]),
            entry::guard("check", "m", &["CHK"]),
            entry::guard("check-far", "m", &["REPL"]),
        ],
    ),
    entry::mode(
        "REPL",
        APART,
        &[
            entry::guard("rep-off", "m", &["FLT"]),
            entry::guard("check-near", "m", &["REPH"]),
            RESET,
        ],
    ),
    entry::mode(
        "REP0",
        APART,
        &[
            entry::guard("rep-off", "m", &["FLA"]),
            entry::guard("jack-in", "m", &["FLA"]),
            entry::guard("jack-out", "m", &["REPL"]),
        ],
    ),
    entry::mode("CHK", CARRIED, &[entry::guard("check-off", "m", &["REPL"])]),
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
