//! Emitted from `the description of reduced-grand` by `letoff model emit`; not to be changed by hand.
#![allow(
    non_snake_case,
    unreachable_pub,
    clippy::allow_attributes,
    clippy::large_stack_frames,
    clippy::suspicious_operation_groupings,
    clippy::too_many_lines,
    clippy::unnecessary_wraps,
    reason = "names as in the description, straight lines of operations: what applies varies"
)]

use equations::functions;
use equations::table::{
    Arguments, DrawingTable, Freedom, FunctionId, Functions, GuardTable, ModeTable, ModelTable,
    NamedQuantity, ParameterTable, PartTable, PresetTable, RestTable, SeriesTable, WayTable,
};
use pode::{EquationKind, Fires, GuardId, GuardSpec, Part, Reads, math};

/// All of the model but its arithmetic.
pub static TABLE: ModelTable = ModelTable {
    name: "reduced-grand",
    summary: "a grand's key and hammer with let-off, check and repetition, reduced to two coordinates",
    parameters: &[
        ParameterTable {
            name: "R",
            title: "ratio",
            unit: "1",
            range: (1e-9, 1_000_000_000.0),
            doc: "hammer-head travel over key-front travel",
        },
        ParameterTable {
            name: "mk",
            title: "key mass",
            unit: "kg",
            range: (1e-9, 1_000_000_000.0),
            doc: "mass of the key, felt at its front",
        },
        ParameterTable {
            name: "mh",
            title: "hammer mass",
            unit: "kg",
            range: (1e-9, 1_000_000_000.0),
            doc: "mass of the hammer, felt at its head",
        },
        ParameterTable {
            name: "g",
            title: "gravity",
            unit: "m/s²",
            range: (0.0, 1000.0),
            doc: "gravity",
        },
        ParameterTable {
            name: "Wk",
            title: "key weight",
            unit: "N",
            range: (-100.0, 100.0),
            doc: "weight of the key at its front, without the hammer; negative with leads",
        },
        ParameterTable {
            name: "ck",
            title: "key damping",
            unit: "N·s/m",
            range: (0.0, 1_000_000_000.0),
            doc: "viscous damping of the key",
        },
        ParameterTable {
            name: "Fc",
            title: "friction",
            unit: "N",
            range: (0.0, 1_000_000_000.0),
            doc: "dry friction of the key",
        },
        ParameterTable {
            name: "vc",
            title: "friction speed",
            unit: "m/s",
            range: (1e-9, 1_000_000_000.0),
            doc: "key speed at which dry friction is at 76 %",
        },
        ParameterTable {
            name: "ch",
            title: "hammer damping",
            unit: "N·s/m",
            range: (0.0, 1_000_000_000.0),
            doc: "viscous damping of the hammer",
        },
        ParameterTable {
            name: "ybed",
            title: "key bed",
            unit: "m",
            range: (-100.0, 100.0),
            doc: "key travel at which the key bed begins",
        },
        ParameterTable {
            name: "Kb",
            title: "bed stiffness",
            unit: "N/m²",
            range: (0.0, 1_000_000_000_000.0),
            doc: "stiffness of the key bed, a softened square law",
        },
        ParameterTable {
            name: "ab",
            title: "bed loss",
            unit: "s/m",
            range: (0.0, 1_000_000_000.0),
            doc: "loss of the key bed",
        },
        ParameterTable {
            name: "wf",
            title: "felt width",
            unit: "m",
            range: (1e-9, 1_000_000_000.0),
            doc: "travel over which bed and rest rail set in",
        },
        ParameterTable {
            name: "Kr",
            title: "rail stiffness",
            unit: "N/m²",
            range: (0.0, 1_000_000_000_000.0),
            doc: "stiffness of the rest rail, a softened square law",
        },
        ParameterTable {
            name: "ar",
            title: "rail loss",
            unit: "s/m",
            range: (0.0, 1_000_000_000.0),
            doc: "loss of the rest rail",
        },
        ParameterTable {
            name: "yb",
            title: "button",
            unit: "m",
            range: (-100.0, 100.0),
            doc: "key travel at which the jack meets the let-off button",
        },
        ParameterTable {
            name: "zt",
            title: "trip height",
            unit: "m",
            range: (-100.0, 100.0),
            doc: "head height at which the jack trips; more than R yb",
        },
        ParameterTable {
            name: "rho",
            title: "trip ratio",
            unit: "1",
            range: (0.0, 1.0),
            doc: "hammer ratio at the trip over R",
        },
        ParameterTable {
            name: "nu",
            title: "button friction",
            unit: "1",
            range: (0.0, 1_000_000_000.0),
            doc: "friction of the let-off, a ratio beside the hammer's",
        },
        ParameterTable {
            name: "kj",
            title: "jack spring",
            unit: "N/m",
            range: (0.0, 1_000_000_000.0),
            doc: "spring of jack and button, at the key front",
        },
        ParameterTable {
            name: "wj",
            title: "jack width",
            unit: "m",
            range: (1e-9, 1_000_000_000.0),
            doc: "travel over which that spring sets in",
        },
        ParameterTable {
            name: "zs",
            title: "string",
            unit: "m",
            range: (-100.0, 100.0),
            doc: "head height at the string; more than zt",
        },
        ParameterTable {
            name: "Ks",
            title: "string stiffness",
            unit: "N",
            range: (1e-9, 1_000_000_000_000_000.0),
            doc: "force of the hammer's felt at 1 m, were it to go on by its power law",
        },
        ParameterTable {
            name: "ps",
            title: "string exponent",
            unit: "1",
            range: (1.0, 10.0),
            doc: "exponent of the hammer's felt",
        },
        ParameterTable {
            name: "mus",
            title: "string loss",
            unit: "s/m",
            range: (0.0, 1_000_000_000.0),
            doc: "loss of the hammer's felt",
        },
        ParameterTable {
            name: "kr",
            title: "lever spring",
            unit: "N/m",
            range: (1e-9, 1_000_000_000.0),
            doc: "spring of the repetition lever, at the head",
        },
        ParameterTable {
            name: "cr",
            title: "lever loss",
            unit: "s/m",
            range: (0.0, 1_000_000_000.0),
            doc: "loss of that spring",
        },
        ParameterTable {
            name: "o_r",
            title: "lever offset",
            unit: "m",
            range: (-100.0, 100.0),
            doc: "height of the lever above a head that lies on the jack",
        },
        ParameterTable {
            name: "yd",
            title: "drop screw",
            unit: "m",
            range: (-100.0, 100.0),
            doc: "key travel at which the lever meets the drop screw",
        },
        ParameterTable {
            name: "wd",
            title: "drop width",
            unit: "m",
            range: (1e-9, 1_000_000_000.0),
            doc: "travel over which the drop screw sets in",
        },
        ParameterTable {
            name: "zc",
            title: "check height",
            unit: "m",
            range: (-100.0, 100.0),
            doc: "head height in check with the key at its bed",
        },
        ParameterTable {
            name: "Rc",
            title: "check ratio",
            unit: "1",
            range: (1e-9, 1_000_000_000.0),
            doc: "travel of a head in check over that of the key",
        },
        ParameterTable {
            name: "yck",
            title: "check from",
            unit: "m",
            range: (-100.0, 100.0),
            doc: "key travel from which on the check catches",
        },
        ParameterTable {
            name: "yco",
            title: "check off",
            unit: "m",
            range: (-100.0, 100.0),
            doc: "key travel below which the check lets go",
        },
        ParameterTable {
            name: "yrs",
            title: "jack reset",
            unit: "m",
            range: (-100.0, 100.0),
            doc: "key travel below which the jack slips back under the knuckle",
        },
        ParameterTable {
            name: "k1",
            title: "coupling",
            unit: "N/m",
            range: (1e-9, 1_000_000_000.0),
            doc: "spring between the finger's position and the key",
        },
        ParameterTable {
            name: "b1",
            title: "coupling damper",
            unit: "N·s/m",
            range: (0.0, 1_000_000_000.0),
            doc: "damper beside it",
        },
    ],
    presets: &[
        PresetTable {
            name: "default",
            doc: "one key of a grand, plausible and not measured",
            values: 99,
        },
        PresetTable {
            name: "playable",
            doc: "hammers graded over the compass, and a key that comes up by itself from everywhere",
            values: 100,
        },
    ],
    requirements: &[],
    states: &[
        NamedQuantity { name: "y", unit: "m" },
        NamedQuantity { name: "z", unit: "m" },
        NamedQuantity { name: "u", unit: "m/s" },
        NamedQuantity { name: "w", unit: "m/s" },
    ],
    coordinates: 2,
    constants: 161,
    derive_constants: 102,
    input: NamedQuantity { name: "s", unit: "m" },
    input_per_metre: 101,
    modes: &[
        ModeTable {
            name: "ACC",
            derivative: 0,
            parts: &[PartTable {
                entries: 0x5,
                derivative: 1,
                kind: EquationKind::Smooth,
                loss: None,
                reads: Reads::StateAndInput,
            }],
            part_list: &[Part::of(&[0, 2])],
            slaved: Some(2),
            projection: None,
            projected: 0,
            longest_projection: None,
            readout: 4,
            slopes: 5,
            outputs: 6,
            balance: 7,
            jacobian: 3,
            series: Some(SeriesTable {
                start: 14,
                step: 15,
                entries: 0x5,
                guards: 2,
                conditions: 6,
                lanes: 15,
                carried: 27,
            }),
            kind: EquationKind::Smooth,
            loss: None,
            is_stiffening: true,
            guards: &[
                GuardTable {
                    id: 0,
                    name: "lift-off",
                    unit: "N",
                    priority: 0,
                    scale: 40.0,
                    fires: Fires::WhileNegative,
                    reads: Reads::StateAndInput,
                    value: 9,
                    bound: Some(10),
                    ways: &[WayTable { when: None, to: 2, reset: Some(8), resting: None }],
                    sounds: None,
                },
                GuardTable {
                    id: 1,
                    name: "button",
                    unit: "m",
                    priority: 1,
                    scale: 0.01,
                    fires: Fires::WhileNegative,
                    reads: Reads::State,
                    value: 12,
                    bound: Some(13),
                    ways: &[WayTable { when: None, to: 1, reset: Some(11), resting: None }],
                    sounds: None,
                },
            ],
            guard_specs: &[
                GuardSpec {
                    id: GuardId(0),
                    name: "lift-off",
                    priority: 0,
                    scale: 40.0,
                    fires: Fires::WhileNegative,
                    reads: Reads::StateAndInput,
                },
                GuardSpec {
                    id: GuardId(1),
                    name: "button",
                    priority: 1,
                    scale: 0.01,
                    fires: Fires::WhileNegative,
                    reads: Reads::State,
                },
            ],
            contacts: &[],
            freedom: Freedom { n: 2, m: 1, p: 1 },
        },
        ModeTable {
            name: "LO",
            derivative: 16,
            parts: &[PartTable {
                entries: 0x5,
                derivative: 17,
                kind: EquationKind::Smooth,
                loss: None,
                reads: Reads::StateAndInput,
            }],
            part_list: &[Part::of(&[0, 2])],
            slaved: Some(18),
            projection: None,
            projected: 0,
            longest_projection: None,
            readout: 4,
            slopes: 5,
            outputs: 20,
            balance: 21,
            jacobian: 19,
            series: Some(SeriesTable {
                start: 27,
                step: 28,
                entries: 0x5,
                guards: 3,
                conditions: 6,
                lanes: 27,
                carried: 47,
            }),
            kind: EquationKind::Smooth,
            loss: None,
            is_stiffening: true,
            guards: &[
                GuardTable {
                    id: 0,
                    name: "lift-off",
                    unit: "N",
                    priority: 0,
                    scale: 40.0,
                    fires: Fires::WhileNegative,
                    reads: Reads::StateAndInput,
                    value: 22,
                    bound: Some(23),
                    ways: &[WayTable { when: None, to: 3, reset: Some(11), resting: None }],
                    sounds: None,
                },
                GuardTable {
                    id: 2,
                    name: "button-off",
                    unit: "m",
                    priority: 2,
                    scale: 0.01,
                    fires: Fires::WhileNegative,
                    reads: Reads::State,
                    value: 24,
                    bound: Some(13),
                    ways: &[WayTable { when: None, to: 0, reset: Some(8), resting: None }],
                    sounds: None,
                },
                GuardTable {
                    id: 3,
                    name: "trip",
                    unit: "m",
                    priority: 3,
                    scale: 0.01,
                    fires: Fires::WhileNegative,
                    reads: Reads::State,
                    value: 25,
                    bound: Some(26),
                    ways: &[WayTable { when: None, to: 4, reset: Some(11), resting: None }],
                    sounds: None,
                },
            ],
            guard_specs: &[
                GuardSpec {
                    id: GuardId(0),
                    name: "lift-off",
                    priority: 0,
                    scale: 40.0,
                    fires: Fires::WhileNegative,
                    reads: Reads::StateAndInput,
                },
                GuardSpec {
                    id: GuardId(2),
                    name: "button-off",
                    priority: 2,
                    scale: 0.01,
                    fires: Fires::WhileNegative,
                    reads: Reads::State,
                },
                GuardSpec {
                    id: GuardId(3),
                    name: "trip",
                    priority: 3,
                    scale: 0.01,
                    fires: Fires::WhileNegative,
                    reads: Reads::State,
                },
            ],
            contacts: &[],
            freedom: Freedom { n: 2, m: 1, p: 1 },
        },
        ModeTable {
            name: "FLA",
            derivative: 29,
            parts: &[
                PartTable {
                    entries: 0x5,
                    derivative: 30,
                    kind: EquationKind::Smooth,
                    loss: None,
                    reads: Reads::StateAndInput,
                },
                PartTable {
                    entries: 0xa,
                    derivative: 31,
                    kind: EquationKind::Affine,
                    loss: Some(32),
                    reads: Reads::State,
                },
            ],
            part_list: &[Part::of(&[0, 2]), Part::of(&[1, 3]).of_state()],
            slaved: None,
            projection: None,
            projected: 0,
            longest_projection: None,
            readout: 4,
            slopes: 5,
            outputs: 34,
            balance: 35,
            jacobian: 33,
            series: Some(SeriesTable {
                start: 43,
                step: 44,
                entries: 0xf,
                guards: 3,
                conditions: 6,
                lanes: 15,
                carried: 27,
            }),
            kind: EquationKind::Smooth,
            loss: None,
            is_stiffening: true,
            guards: &[
                GuardTable {
                    id: 4,
                    name: "land",
                    unit: "m",
                    priority: 4,
                    scale: 0.05,
                    fires: Fires::WhileNegative,
                    reads: Reads::State,
                    value: 37,
                    bound: Some(38),
                    ways: &[WayTable { when: None, to: 0, reset: Some(36), resting: None }],
                    sounds: None,
                },
                GuardTable {
                    id: 1,
                    name: "button",
                    unit: "m",
                    priority: 1,
                    scale: 0.01,
                    fires: Fires::WhileNegative,
                    reads: Reads::State,
                    value: 12,
                    bound: Some(13),
                    ways: &[WayTable { when: None, to: 3, reset: None, resting: None }],
                    sounds: None,
                },
                GuardTable {
                    id: 5,
                    name: "string-on",
                    unit: "m",
                    priority: 5,
                    scale: 0.05,
                    fires: Fires::WhileNegative,
                    reads: Reads::State,
                    value: 41,
                    bound: Some(42),
                    ways: &[WayTable { when: None, to: 5, reset: Some(39), resting: None }],
                    sounds: Some(40),
                },
            ],
            guard_specs: &[
                GuardSpec {
                    id: GuardId(4),
                    name: "land",
                    priority: 4,
                    scale: 0.05,
                    fires: Fires::WhileNegative,
                    reads: Reads::State,
                },
                GuardSpec {
                    id: GuardId(1),
                    name: "button",
                    priority: 1,
                    scale: 0.01,
                    fires: Fires::WhileNegative,
                    reads: Reads::State,
                },
                GuardSpec {
                    id: GuardId(5),
                    name: "string-on",
                    priority: 5,
                    scale: 0.05,
                    fires: Fires::WhileNegative,
                    reads: Reads::State,
                },
            ],
            contacts: &[],
            freedom: Freedom { n: 2, m: 0, p: 2 },
        },
        ModeTable {
            name: "FLL",
            derivative: 29,
            parts: &[
                PartTable {
                    entries: 0x5,
                    derivative: 30,
                    kind: EquationKind::Smooth,
                    loss: None,
                    reads: Reads::StateAndInput,
                },
                PartTable {
                    entries: 0xa,
                    derivative: 31,
                    kind: EquationKind::Affine,
                    loss: Some(32),
                    reads: Reads::State,
                },
            ],
            part_list: &[Part::of(&[0, 2]), Part::of(&[1, 3]).of_state()],
            slaved: None,
            projection: None,
            projected: 0,
            longest_projection: None,
            readout: 4,
            slopes: 5,
            outputs: 34,
            balance: 35,
            jacobian: 33,
            series: Some(SeriesTable {
                start: 48,
                step: 49,
                entries: 0xf,
                guards: 4,
                conditions: 6,
                lanes: 16,
                carried: 29,
            }),
            kind: EquationKind::Smooth,
            loss: None,
            is_stiffening: true,
            guards: &[
                GuardTable {
                    id: 4,
                    name: "land",
                    unit: "m",
                    priority: 4,
                    scale: 0.05,
                    fires: Fires::WhileNegative,
                    reads: Reads::State,
                    value: 46,
                    bound: Some(47),
                    ways: &[WayTable { when: None, to: 1, reset: Some(45), resting: None }],
                    sounds: None,
                },
                GuardTable {
                    id: 2,
                    name: "button-off",
                    unit: "m",
                    priority: 2,
                    scale: 0.01,
                    fires: Fires::WhileNegative,
                    reads: Reads::State,
                    value: 24,
                    bound: Some(13),
                    ways: &[WayTable { when: None, to: 2, reset: None, resting: None }],
                    sounds: None,
                },
                GuardTable {
                    id: 3,
                    name: "trip",
                    unit: "m",
                    priority: 3,
                    scale: 0.01,
                    fires: Fires::WhileNegative,
                    reads: Reads::State,
                    value: 25,
                    bound: Some(26),
                    ways: &[WayTable { when: None, to: 4, reset: None, resting: None }],
                    sounds: None,
                },
                GuardTable {
                    id: 5,
                    name: "string-on",
                    unit: "m",
                    priority: 5,
                    scale: 0.05,
                    fires: Fires::WhileNegative,
                    reads: Reads::State,
                    value: 41,
                    bound: Some(42),
                    ways: &[WayTable { when: None, to: 5, reset: Some(39), resting: None }],
                    sounds: Some(40),
                },
            ],
            guard_specs: &[
                GuardSpec {
                    id: GuardId(4),
                    name: "land",
                    priority: 4,
                    scale: 0.05,
                    fires: Fires::WhileNegative,
                    reads: Reads::State,
                },
                GuardSpec {
                    id: GuardId(2),
                    name: "button-off",
                    priority: 2,
                    scale: 0.01,
                    fires: Fires::WhileNegative,
                    reads: Reads::State,
                },
                GuardSpec {
                    id: GuardId(3),
                    name: "trip",
                    priority: 3,
                    scale: 0.01,
                    fires: Fires::WhileNegative,
                    reads: Reads::State,
                },
                GuardSpec {
                    id: GuardId(5),
                    name: "string-on",
                    priority: 5,
                    scale: 0.05,
                    fires: Fires::WhileNegative,
                    reads: Reads::State,
                },
            ],
            contacts: &[],
            freedom: Freedom { n: 2, m: 0, p: 2 },
        },
        ModeTable {
            name: "FLT",
            derivative: 29,
            parts: &[
                PartTable {
                    entries: 0x5,
                    derivative: 30,
                    kind: EquationKind::Smooth,
                    loss: None,
                    reads: Reads::StateAndInput,
                },
                PartTable {
                    entries: 0xa,
                    derivative: 31,
                    kind: EquationKind::Affine,
                    loss: Some(32),
                    reads: Reads::State,
                },
            ],
            part_list: &[Part::of(&[0, 2]), Part::of(&[1, 3]).of_state()],
            slaved: None,
            projection: None,
            projected: 0,
            longest_projection: None,
            readout: 4,
            slopes: 5,
            outputs: 34,
            balance: 35,
            jacobian: 33,
            series: Some(SeriesTable {
                start: 55,
                step: 56,
                entries: 0xf,
                guards: 3,
                conditions: 7,
                lanes: 18,
                carried: 32,
            }),
            kind: EquationKind::Smooth,
            loss: None,
            is_stiffening: true,
            guards: &[
                GuardTable {
                    id: 5,
                    name: "string-on",
                    unit: "m",
                    priority: 5,
                    scale: 0.05,
                    fires: Fires::WhileNegative,
                    reads: Reads::State,
                    value: 41,
                    bound: Some(42),
                    ways: &[WayTable { when: None, to: 6, reset: Some(39), resting: None }],
                    sounds: Some(40),
                },
                GuardTable {
                    id: 6,
                    name: "rep-on",
                    unit: "m",
                    priority: 7,
                    scale: 0.05,
                    fires: Fires::WhileNegative,
                    reads: Reads::State,
                    value: 51,
                    bound: Some(52),
                    ways: &[
                        WayTable { when: Some(50), to: 7, reset: None, resting: None },
                        WayTable { when: None, to: 8, reset: None, resting: None },
                    ],
                    sounds: None,
                },
                GuardTable {
                    id: 7,
                    name: "reset",
                    unit: "m",
                    priority: 13,
                    scale: 0.01,
                    fires: Fires::WhileNegative,
                    reads: Reads::State,
                    value: 54,
                    bound: Some(13),
                    ways: &[
                        WayTable { when: Some(53), to: 2, reset: None, resting: None },
                        WayTable { when: None, to: 9, reset: None, resting: None },
                    ],
                    sounds: None,
                },
            ],
            guard_specs: &[
                GuardSpec {
                    id: GuardId(5),
                    name: "string-on",
                    priority: 5,
                    scale: 0.05,
                    fires: Fires::WhileNegative,
                    reads: Reads::State,
                },
                GuardSpec {
                    id: GuardId(6),
                    name: "rep-on",
                    priority: 7,
                    scale: 0.05,
                    fires: Fires::WhileNegative,
                    reads: Reads::State,
                },
                GuardSpec {
                    id: GuardId(7),
                    name: "reset",
                    priority: 13,
                    scale: 0.01,
                    fires: Fires::WhileNegative,
                    reads: Reads::State,
                },
            ],
            contacts: &[],
            freedom: Freedom { n: 2, m: 0, p: 2 },
        },
        ModeTable {
            name: "STU",
            derivative: 57,
            parts: &[
                PartTable {
                    entries: 0x5,
                    derivative: 30,
                    kind: EquationKind::Smooth,
                    loss: None,
                    reads: Reads::StateAndInput,
                },
                PartTable {
                    entries: 0xa,
                    derivative: 58,
                    kind: EquationKind::Smooth,
                    loss: Some(59),
                    reads: Reads::State,
                },
            ],
            part_list: &[Part::of(&[0, 2]), Part::of(&[1, 3]).of_state()],
            slaved: None,
            projection: None,
            projected: 0,
            longest_projection: None,
            readout: 4,
            slopes: 5,
            outputs: 61,
            balance: 62,
            jacobian: 60,
            series: Some(SeriesTable {
                start: 65,
                step: 66,
                entries: 0xf,
                guards: 2,
                conditions: 8,
                lanes: 18,
                carried: 33,
            }),
            kind: EquationKind::Smooth,
            loss: None,
            is_stiffening: true,
            guards: &[
                GuardTable {
                    id: 8,
                    name: "string-off",
                    unit: "m",
                    priority: 6,
                    scale: 0.05,
                    fires: Fires::WhileNegative,
                    reads: Reads::State,
                    value: 64,
                    bound: Some(42),
                    ways: &[
                        WayTable { when: Some(63), to: 2, reset: None, resting: None },
                        WayTable { when: None, to: 3, reset: None, resting: None },
                    ],
                    sounds: None,
                },
                GuardTable {
                    id: 3,
                    name: "trip",
                    unit: "m",
                    priority: 3,
                    scale: 0.01,
                    fires: Fires::WhileNegative,
                    reads: Reads::State,
                    value: 25,
                    bound: Some(26),
                    ways: &[WayTable { when: None, to: 6, reset: None, resting: None }],
                    sounds: None,
                },
            ],
            guard_specs: &[
                GuardSpec {
                    id: GuardId(8),
                    name: "string-off",
                    priority: 6,
                    scale: 0.05,
                    fires: Fires::WhileNegative,
                    reads: Reads::State,
                },
                GuardSpec {
                    id: GuardId(3),
                    name: "trip",
                    priority: 3,
                    scale: 0.01,
                    fires: Fires::WhileNegative,
                    reads: Reads::State,
                },
            ],
            contacts: &[],
            freedom: Freedom { n: 2, m: 0, p: 2 },
        },
        ModeTable {
            name: "STT",
            derivative: 57,
            parts: &[
                PartTable {
                    entries: 0x5,
                    derivative: 30,
                    kind: EquationKind::Smooth,
                    loss: None,
                    reads: Reads::StateAndInput,
                },
                PartTable {
                    entries: 0xa,
                    derivative: 58,
                    kind: EquationKind::Smooth,
                    loss: Some(59),
                    reads: Reads::State,
                },
            ],
            part_list: &[Part::of(&[0, 2]), Part::of(&[1, 3]).of_state()],
            slaved: None,
            projection: None,
            projected: 0,
            longest_projection: None,
            readout: 4,
            slopes: 5,
            outputs: 61,
            balance: 62,
            jacobian: 60,
            series: Some(SeriesTable {
                start: 67,
                step: 68,
                entries: 0xf,
                guards: 2,
                conditions: 8,
                lanes: 18,
                carried: 33,
            }),
            kind: EquationKind::Smooth,
            loss: None,
            is_stiffening: true,
            guards: &[
                GuardTable {
                    id: 8,
                    name: "string-off",
                    unit: "m",
                    priority: 6,
                    scale: 0.05,
                    fires: Fires::WhileNegative,
                    reads: Reads::State,
                    value: 64,
                    bound: Some(42),
                    ways: &[WayTable { when: None, to: 4, reset: None, resting: None }],
                    sounds: None,
                },
                GuardTable {
                    id: 7,
                    name: "reset",
                    unit: "m",
                    priority: 13,
                    scale: 0.01,
                    fires: Fires::WhileNegative,
                    reads: Reads::State,
                    value: 54,
                    bound: Some(13),
                    ways: &[WayTable { when: None, to: 5, reset: None, resting: None }],
                    sounds: None,
                },
            ],
            guard_specs: &[
                GuardSpec {
                    id: GuardId(8),
                    name: "string-off",
                    priority: 6,
                    scale: 0.05,
                    fires: Fires::WhileNegative,
                    reads: Reads::State,
                },
                GuardSpec {
                    id: GuardId(7),
                    name: "reset",
                    priority: 13,
                    scale: 0.01,
                    fires: Fires::WhileNegative,
                    reads: Reads::State,
                },
            ],
            contacts: &[],
            freedom: Freedom { n: 2, m: 0, p: 2 },
        },
        ModeTable {
            name: "REPH",
            derivative: 69,
            parts: &[PartTable {
                entries: 0xf,
                derivative: 69,
                kind: EquationKind::Smooth,
                loss: None,
                reads: Reads::StateAndInput,
            }],
            part_list: &[Part::WHOLE],
            slaved: None,
            projection: None,
            projected: 0,
            longest_projection: None,
            readout: 4,
            slopes: 5,
            outputs: 71,
            balance: 72,
            jacobian: 70,
            series: Some(SeriesTable {
                start: 79,
                step: 80,
                entries: 0xf,
                guards: 3,
                conditions: 8,
                lanes: 24,
                carried: 43,
            }),
            kind: EquationKind::Smooth,
            loss: None,
            is_stiffening: true,
            guards: &[
                GuardTable {
                    id: 9,
                    name: "rep-off",
                    unit: "m",
                    priority: 8,
                    scale: 0.05,
                    fires: Fires::WhileNegative,
                    reads: Reads::State,
                    value: 73,
                    bound: Some(74),
                    ways: &[WayTable { when: None, to: 4, reset: None, resting: None }],
                    sounds: None,
                },
                GuardTable {
                    id: 10,
                    name: "check",
                    unit: "m",
                    priority: 9,
                    scale: 0.05,
                    fires: Fires::OnCrossing,
                    reads: Reads::State,
                    value: 76,
                    bound: Some(77),
                    ways: &[WayTable { when: None, to: 10, reset: Some(75), resting: None }],
                    sounds: None,
                },
                GuardTable {
                    id: 11,
                    name: "check-far",
                    unit: "m",
                    priority: 10,
                    scale: 0.01,
                    fires: Fires::WhileNegative,
                    reads: Reads::State,
                    value: 78,
                    bound: Some(13),
                    ways: &[WayTable { when: None, to: 8, reset: None, resting: None }],
                    sounds: None,
                },
            ],
            guard_specs: &[
                GuardSpec {
                    id: GuardId(9),
                    name: "rep-off",
                    priority: 8,
                    scale: 0.05,
                    fires: Fires::WhileNegative,
                    reads: Reads::State,
                },
                GuardSpec {
                    id: GuardId(10),
                    name: "check",
                    priority: 9,
                    scale: 0.05,
                    fires: Fires::OnCrossing,
                    reads: Reads::State,
                },
                GuardSpec {
                    id: GuardId(11),
                    name: "check-far",
                    priority: 10,
                    scale: 0.01,
                    fires: Fires::WhileNegative,
                    reads: Reads::State,
                },
            ],
            contacts: &[],
            freedom: Freedom { n: 2, m: 0, p: 2 },
        },
        ModeTable {
            name: "REPL",
            derivative: 69,
            parts: &[PartTable {
                entries: 0xf,
                derivative: 69,
                kind: EquationKind::Smooth,
                loss: None,
                reads: Reads::StateAndInput,
            }],
            part_list: &[Part::WHOLE],
            slaved: None,
            projection: None,
            projected: 0,
            longest_projection: None,
            readout: 4,
            slopes: 5,
            outputs: 71,
            balance: 72,
            jacobian: 70,
            series: Some(SeriesTable {
                start: 82,
                step: 83,
                entries: 0xf,
                guards: 3,
                conditions: 8,
                lanes: 24,
                carried: 43,
            }),
            kind: EquationKind::Smooth,
            loss: None,
            is_stiffening: true,
            guards: &[
                GuardTable {
                    id: 9,
                    name: "rep-off",
                    unit: "m",
                    priority: 8,
                    scale: 0.05,
                    fires: Fires::WhileNegative,
                    reads: Reads::State,
                    value: 73,
                    bound: Some(74),
                    ways: &[WayTable { when: None, to: 4, reset: None, resting: None }],
                    sounds: None,
                },
                GuardTable {
                    id: 12,
                    name: "check-near",
                    unit: "m",
                    priority: 11,
                    scale: 0.01,
                    fires: Fires::WhileNegative,
                    reads: Reads::State,
                    value: 81,
                    bound: Some(13),
                    ways: &[WayTable { when: None, to: 7, reset: None, resting: None }],
                    sounds: None,
                },
                GuardTable {
                    id: 7,
                    name: "reset",
                    unit: "m",
                    priority: 13,
                    scale: 0.01,
                    fires: Fires::WhileNegative,
                    reads: Reads::State,
                    value: 54,
                    bound: Some(13),
                    ways: &[
                        WayTable { when: Some(53), to: 2, reset: None, resting: None },
                        WayTable { when: None, to: 9, reset: None, resting: None },
                    ],
                    sounds: None,
                },
            ],
            guard_specs: &[
                GuardSpec {
                    id: GuardId(9),
                    name: "rep-off",
                    priority: 8,
                    scale: 0.05,
                    fires: Fires::WhileNegative,
                    reads: Reads::State,
                },
                GuardSpec {
                    id: GuardId(12),
                    name: "check-near",
                    priority: 11,
                    scale: 0.01,
                    fires: Fires::WhileNegative,
                    reads: Reads::State,
                },
                GuardSpec {
                    id: GuardId(7),
                    name: "reset",
                    priority: 13,
                    scale: 0.01,
                    fires: Fires::WhileNegative,
                    reads: Reads::State,
                },
            ],
            contacts: &[],
            freedom: Freedom { n: 2, m: 0, p: 2 },
        },
        ModeTable {
            name: "REP0",
            derivative: 69,
            parts: &[PartTable {
                entries: 0xf,
                derivative: 69,
                kind: EquationKind::Smooth,
                loss: None,
                reads: Reads::StateAndInput,
            }],
            part_list: &[Part::WHOLE],
            slaved: None,
            projection: None,
            projected: 0,
            longest_projection: None,
            readout: 4,
            slopes: 5,
            outputs: 71,
            balance: 72,
            jacobian: 70,
            series: Some(SeriesTable {
                start: 86,
                step: 87,
                entries: 0xf,
                guards: 3,
                conditions: 8,
                lanes: 24,
                carried: 43,
            }),
            kind: EquationKind::Smooth,
            loss: None,
            is_stiffening: true,
            guards: &[
                GuardTable {
                    id: 9,
                    name: "rep-off",
                    unit: "m",
                    priority: 8,
                    scale: 0.05,
                    fires: Fires::WhileNegative,
                    reads: Reads::State,
                    value: 73,
                    bound: Some(74),
                    ways: &[WayTable { when: None, to: 2, reset: None, resting: None }],
                    sounds: None,
                },
                GuardTable {
                    id: 13,
                    name: "jack-in",
                    unit: "m",
                    priority: 14,
                    scale: 0.05,
                    fires: Fires::WhileNegative,
                    reads: Reads::State,
                    value: 84,
                    bound: Some(38),
                    ways: &[WayTable { when: None, to: 2, reset: None, resting: None }],
                    sounds: None,
                },
                GuardTable {
                    id: 14,
                    name: "jack-out",
                    unit: "m",
                    priority: 15,
                    scale: 0.01,
                    fires: Fires::WhileNegative,
                    reads: Reads::State,
                    value: 85,
                    bound: Some(13),
                    ways: &[WayTable { when: None, to: 8, reset: None, resting: None }],
                    sounds: None,
                },
            ],
            guard_specs: &[
                GuardSpec {
                    id: GuardId(9),
                    name: "rep-off",
                    priority: 8,
                    scale: 0.05,
                    fires: Fires::WhileNegative,
                    reads: Reads::State,
                },
                GuardSpec {
                    id: GuardId(13),
                    name: "jack-in",
                    priority: 14,
                    scale: 0.05,
                    fires: Fires::WhileNegative,
                    reads: Reads::State,
                },
                GuardSpec {
                    id: GuardId(14),
                    name: "jack-out",
                    priority: 15,
                    scale: 0.01,
                    fires: Fires::WhileNegative,
                    reads: Reads::State,
                },
            ],
            contacts: &[],
            freedom: Freedom { n: 2, m: 0, p: 2 },
        },
        ModeTable {
            name: "CHK",
            derivative: 88,
            parts: &[PartTable {
                entries: 0x5,
                derivative: 89,
                kind: EquationKind::Smooth,
                loss: None,
                reads: Reads::StateAndInput,
            }],
            part_list: &[Part::of(&[0, 2])],
            slaved: Some(90),
            projection: None,
            projected: 0,
            longest_projection: None,
            readout: 4,
            slopes: 5,
            outputs: 92,
            balance: 93,
            jacobian: 91,
            series: Some(SeriesTable {
                start: 96,
                step: 97,
                entries: 0x5,
                guards: 1,
                conditions: 7,
                lanes: 19,
                carried: 34,
            }),
            kind: EquationKind::Smooth,
            loss: None,
            is_stiffening: true,
            guards: &[GuardTable {
                id: 15,
                name: "check-off",
                unit: "m",
                priority: 12,
                scale: 0.01,
                fires: Fires::WhileNegative,
                reads: Reads::State,
                value: 95,
                bound: Some(13),
                ways: &[WayTable { when: None, to: 8, reset: Some(94), resting: None }],
                sounds: None,
            }],
            guard_specs: &[GuardSpec {
                id: GuardId(15),
                name: "check-off",
                priority: 12,
                scale: 0.01,
                fires: Fires::WhileNegative,
                reads: Reads::State,
            }],
            contacts: &[],
            freedom: Freedom { n: 2, m: 1, p: 1 },
        },
    ],
    contacts: &[],
    contact_specs: &[],
    guard_specs: &[
        GuardSpec {
            id: GuardId(0),
            name: "lift-off",
            priority: 0,
            scale: 40.0,
            fires: Fires::WhileNegative,
            reads: Reads::StateAndInput,
        },
        GuardSpec {
            id: GuardId(1),
            name: "button",
            priority: 1,
            scale: 0.01,
            fires: Fires::WhileNegative,
            reads: Reads::State,
        },
        GuardSpec {
            id: GuardId(2),
            name: "button-off",
            priority: 2,
            scale: 0.01,
            fires: Fires::WhileNegative,
            reads: Reads::State,
        },
        GuardSpec {
            id: GuardId(3),
            name: "trip",
            priority: 3,
            scale: 0.01,
            fires: Fires::WhileNegative,
            reads: Reads::State,
        },
        GuardSpec {
            id: GuardId(4),
            name: "land",
            priority: 4,
            scale: 0.05,
            fires: Fires::WhileNegative,
            reads: Reads::State,
        },
        GuardSpec {
            id: GuardId(5),
            name: "string-on",
            priority: 5,
            scale: 0.05,
            fires: Fires::WhileNegative,
            reads: Reads::State,
        },
        GuardSpec {
            id: GuardId(6),
            name: "rep-on",
            priority: 7,
            scale: 0.05,
            fires: Fires::WhileNegative,
            reads: Reads::State,
        },
        GuardSpec {
            id: GuardId(7),
            name: "reset",
            priority: 13,
            scale: 0.01,
            fires: Fires::WhileNegative,
            reads: Reads::State,
        },
        GuardSpec {
            id: GuardId(8),
            name: "string-off",
            priority: 6,
            scale: 0.05,
            fires: Fires::WhileNegative,
            reads: Reads::State,
        },
        GuardSpec {
            id: GuardId(9),
            name: "rep-off",
            priority: 8,
            scale: 0.05,
            fires: Fires::WhileNegative,
            reads: Reads::State,
        },
        GuardSpec {
            id: GuardId(10),
            name: "check",
            priority: 9,
            scale: 0.05,
            fires: Fires::OnCrossing,
            reads: Reads::State,
        },
        GuardSpec {
            id: GuardId(11),
            name: "check-far",
            priority: 10,
            scale: 0.01,
            fires: Fires::WhileNegative,
            reads: Reads::State,
        },
        GuardSpec {
            id: GuardId(12),
            name: "check-near",
            priority: 11,
            scale: 0.01,
            fires: Fires::WhileNegative,
            reads: Reads::State,
        },
        GuardSpec {
            id: GuardId(13),
            name: "jack-in",
            priority: 14,
            scale: 0.05,
            fires: Fires::WhileNegative,
            reads: Reads::State,
        },
        GuardSpec {
            id: GuardId(14),
            name: "jack-out",
            priority: 15,
            scale: 0.01,
            fires: Fires::WhileNegative,
            reads: Reads::State,
        },
        GuardSpec {
            id: GuardId(15),
            name: "check-off",
            priority: 12,
            scale: 0.01,
            fires: Fires::WhileNegative,
            reads: Reads::State,
        },
    ],
    outputs: &[
        NamedQuantity { name: "F_KU", unit: "N" },
        NamedQuantity { name: "F_jack", unit: "N" },
        NamedQuantity { name: "F_lever", unit: "N" },
        NamedQuantity { name: "F_string", unit: "N" },
    ],
    rest: RestTable { mode: 0, instead: &[], state: 98, is_improved: true },
    damper: None,
    drawing: DrawingTable { numbers: 98, count: 0, bodies: &[], springs: &[] },
};

/// The model's arithmetic.
#[derive(Clone, Copy, Debug, Default)]
pub struct ReducedGrandFunctions;

impl Functions for ReducedGrandFunctions {
    fn call(&self, function: FunctionId, given: &Arguments<'_>, out: &mut [f64]) {
        let done = match function {
            0 => derivative_acc(given, out),
            1 => part_0_acc(given, out),
            2 => slaved_acc(given, out),
            3 => jacobian_acc(given, out),
            4 => readout_acc(given, out),
            5 => slopes_acc(given, out),
            6 => outputs_acc(given, out),
            7 => balance_acc(given, out),
            8 => reset_0_lift_off_acc(given, out),
            9 => guard_lift_off_acc(given, out),
            10 => bound_lift_off_acc(given, out),
            11 => reset_0_button_acc(given, out),
            12 => guard_button_acc(given, out),
            13 => bound_button_acc(given, out),
            14 => series_start_acc(given, out),
            15 => series_step_acc(given, out),
            16 => derivative_lo(given, out),
            17 => part_0_lo(given, out),
            18 => slaved_lo(given, out),
            19 => jacobian_lo(given, out),
            20 => outputs_lo(given, out),
            21 => balance_lo(given, out),
            22 => guard_lift_off_lo(given, out),
            23 => bound_lift_off_lo(given, out),
            24 => guard_button_off_lo(given, out),
            25 => guard_trip_lo(given, out),
            26 => bound_trip_lo(given, out),
            27 => series_start_lo(given, out),
            28 => series_step_lo(given, out),
            29 => derivative_fla(given, out),
            30 => part_0_fla(given, out),
            31 => part_1_fla(given, out),
            32 => function_32(given, out),
            33 => jacobian_fla(given, out),
            34 => outputs_fla(given, out),
            35 => balance_fla(given, out),
            36 => reset_0_land_fla(given, out),
            37 => guard_land_fla(given, out),
            38 => bound_land_fla(given, out),
            39 => reset_0_string_on_fla(given, out),
            40 => speed_string_on_fla(given, out),
            41 => guard_string_on_fla(given, out),
            42 => bound_string_on_fla(given, out),
            43 => series_start_fla(given, out),
            44 => series_step_fla(given, out),
            45 => reset_0_land_fll(given, out),
            46 => guard_land_fll(given, out),
            47 => bound_land_fll(given, out),
            48 => series_start_fll(given, out),
            49 => series_step_fll(given, out),
            50 => when_0_rep_on_flt(given, out),
            51 => guard_rep_on_flt(given, out),
            52 => bound_rep_on_flt(given, out),
            53 => when_0_reset_flt(given, out),
            54 => guard_reset_flt(given, out),
            55 => series_start_flt(given, out),
            56 => series_step_flt(given, out),
            57 => derivative_stu(given, out),
            58 => part_1_stu(given, out),
            59 => function_59(given, out),
            60 => jacobian_stu(given, out),
            61 => outputs_stu(given, out),
            62 => balance_stu(given, out),
            63 => when_0_string_off_stu(given, out),
            64 => guard_string_off_stu(given, out),
            65 => series_start_stu(given, out),
            66 => series_step_stu(given, out),
            67 => series_start_stt(given, out),
            68 => series_step_stt(given, out),
            69 => derivative_reph(given, out),
            70 => jacobian_reph(given, out),
            71 => outputs_reph(given, out),
            72 => balance_reph(given, out),
            73 => guard_rep_off_reph(given, out),
            74 => bound_rep_off_reph(given, out),
            75 => reset_0_check_reph(given, out),
            76 => guard_check_reph(given, out),
            77 => bound_check_reph(given, out),
            78 => guard_check_far_reph(given, out),
            79 => series_start_reph(given, out),
            80 => series_step_reph(given, out),
            81 => guard_check_near_repl(given, out),
            82 => series_start_repl(given, out),
            83 => series_step_repl(given, out),
            84 => guard_jack_in_rep0(given, out),
            85 => guard_jack_out_rep0(given, out),
            86 => series_start_rep0(given, out),
            87 => series_step_rep0(given, out),
            88 => derivative_chk(given, out),
            89 => part_0_chk(given, out),
            90 => slaved_chk(given, out),
            91 => jacobian_chk(given, out),
            92 => outputs_chk(given, out),
            93 => balance_chk(given, out),
            94 => reset_0_check_off_chk(given, out),
            95 => guard_check_off_chk(given, out),
            96 => series_start_chk(given, out),
            97 => series_step_chk(given, out),
            98 => rest(given, out),
            99 => preset_default(given, out),
            100 => preset_playable(given, out),
            101 => input_per_metre(given, out),
            102 => derived_constants(given, out),
            _ => return,
        };
        if done.is_none() {
            out.fill(f64::NAN);
        }
    }
}

/// The derivative of the state in mode ACC.
fn derivative_acc(given: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let constants = given.constants.first_chunk::<47>()?;
    let state = given.state.first_chunk::<3>()?;
    let input = given.input;
    let R = constants[0];
    let Wk = constants[4];
    let ck = constants[5];
    let Fc = constants[6];
    let ybed = constants[9];
    let ab = constants[11];
    let ar = constants[14];
    let yb = constants[15];
    let k1 = constants[35];
    let b1 = constants[36];
    let c37 = constants[37];
    let c38 = constants[38];
    let c39 = constants[39];
    let c40 = constants[40];
    let c41 = constants[41];
    let c42 = constants[42];
    let c43 = constants[43];
    let c44 = constants[44];
    let c45 = constants[45];
    let c46 = constants[46];
    let y = state[0];
    let u = state[2];
    let s = input[0];
    let s_rate = input[1];
    let v0 = functions::softplus(c37 * (y - ybed));
    let v1 = c38 * (v0 * v0) * functions::larger(1.0 + u * ab, 0.0);
    let v2 = functions::softplus(-(y * c37));
    let v3 = c39 * (v2 * v2) * functions::larger(1.0 - u * ar, 0.0);
    let v4 = k1 * (s - y) + b1 * (s_rate - u) - (Wk + u * ck + R * (c44 + u * c43));
    let v5 = v4 - Fc * math::tanh(u * c40) - c42 * functions::softplus(c41 * (y - yb));
    let v6 = v3 + (v5 - v1);
    let out = out.first_chunk_mut::<4>()?;
    [out[0], out[1], out[2], out[3]] = [u, u * R, c45 * v6, c46 * v6];
    Some(())
}

/// The derivative of a part in mode ACC.
fn part_0_acc(given: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let constants = given.constants.first_chunk::<46>()?;
    let state = given.state.first_chunk::<3>()?;
    let input = given.input;
    let R = constants[0];
    let Wk = constants[4];
    let ck = constants[5];
    let Fc = constants[6];
    let ybed = constants[9];
    let ab = constants[11];
    let ar = constants[14];
    let yb = constants[15];
    let k1 = constants[35];
    let b1 = constants[36];
    let c37 = constants[37];
    let c38 = constants[38];
    let c39 = constants[39];
    let c40 = constants[40];
    let c41 = constants[41];
    let c42 = constants[42];
    let c43 = constants[43];
    let c44 = constants[44];
    let c45 = constants[45];
    let y = state[0];
    let u = state[2];
    let s = input[0];
    let s_rate = input[1];
    let v0 = functions::softplus(c37 * (y - ybed));
    let v1 = c38 * (v0 * v0) * functions::larger(1.0 + u * ab, 0.0);
    let v2 = functions::softplus(-(y * c37));
    let v3 = c39 * (v2 * v2) * functions::larger(1.0 - u * ar, 0.0);
    let v4 = k1 * (s - y) + b1 * (s_rate - u) - (Wk + u * ck + R * (c44 + u * c43));
    let v5 = v4 - Fc * math::tanh(u * c40) - c42 * functions::softplus(c41 * (y - yb));
    let out = out.first_chunk_mut::<4>()?;
    [out[0], out[1]] = [u, 0.0];
    out[2] = c45 * (v3 + (v5 - v1));
    out[3] = 0.0;
    Some(())
}

/// The state with slaved entries in place in mode ACC.
fn slaved_acc(given: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let constants = given.constants.first_chunk::<1>()?;
    let state = given.state.first_chunk::<3>()?;
    let R = constants[0];
    let y = state[0];
    let u = state[2];
    let out = out.first_chunk_mut::<4>()?;
    [out[0], out[1], out[2], out[3]] = [y, y * R, u, R * u];
    Some(())
}

/// The derivative's derivative by the state in mode ACC.
fn jacobian_acc(given: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let constants = given.constants.first_chunk::<52>()?;
    let state = given.state.first_chunk::<3>()?;
    let ybed = constants[9];
    let ab = constants[11];
    let ar = constants[14];
    let yb = constants[15];
    let kj = constants[19];
    let k1 = constants[35];
    let c37 = constants[37];
    let c38 = constants[38];
    let c39 = constants[39];
    let c40 = constants[40];
    let c41 = constants[41];
    let c45 = constants[45];
    let c47 = constants[47];
    let c48 = constants[48];
    let c49 = constants[49];
    let c50 = constants[50];
    let c51 = constants[51];
    let y = state[0];
    let u = state[2];
    let v0 = 1.0 + u * ab;
    let v1 = c37 * (y - ybed);
    let v2 = functions::softplus(v1);
    let v3 = functions::logistic(v1) * (c47 * v2) * functions::larger(v0, 0.0);
    let v4 = 1.0 - u * ar;
    let v5 = -(y * c37);
    let v6 = functions::softplus(v5);
    let v7 = functions::logistic(v5) * (c48 * v6) * functions::larger(v4, 0.0);
    let v8 = k1 + kj * functions::logistic(c41 * (y - yb)) + 2.0 * (v3 + v7);
    let v9 = if v0 > 0.0 { ab } else { 0.0 };
    let v10 = if v4 > 0.0 { c49 } else { 0.0 };
    let v11 = math::tanh(u * c40);
    let v12 = c51 + c39 * v10 * (v6 * v6) - (c38 * v9 * (v2 * v2) + c50 * (1.0 - v11 * v11));
    let out = out.first_chunk_mut::<16>()?;
    [out[0], out[1], out[2], out[3], out[4], out[5], out[6]] = [0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0];
    [out[7], out[8], out[9], out[10], out[11]] = [0.0, c45 * -v8, 0.0, c45 * v12, 0.0];
    [out[12], out[13], out[14], out[15]] = [0.0, 0.0, 0.0, 0.0];
    Some(())
}

/// The readout in mode ACC.
fn readout_acc(given: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let constants = given.constants.first_chunk::<37>()?;
    let state = given.state.first_chunk::<3>()?;
    let input = given.input;
    let k1 = constants[35];
    let b1 = constants[36];
    let y = state[0];
    let u = state[2];
    let s = input[0];
    let s_rate = input[1];
    let out = out.first_chunk_mut::<1>()?;
    out[0] = k1 * (s - y) + b1 * (s_rate - u);
    Some(())
}

/// The readout's slopes in mode ACC.
fn slopes_acc(given: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let constants = given.constants.first_chunk::<37>()?;
    let k1 = constants[35];
    let b1 = constants[36];
    let out = out.first_chunk_mut::<2>()?;
    [out[0], out[1]] = [k1, b1];
    Some(())
}

/// The outputs in mode ACC.
fn outputs_acc(given: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let constants = given.constants.first_chunk::<53>()?;
    let state = given.state.first_chunk::<3>()?;
    let input = given.input;
    let R = constants[0];
    let Wk = constants[4];
    let ck = constants[5];
    let Fc = constants[6];
    let ybed = constants[9];
    let ab = constants[11];
    let ar = constants[14];
    let yb = constants[15];
    let k1 = constants[35];
    let b1 = constants[36];
    let c37 = constants[37];
    let c38 = constants[38];
    let c39 = constants[39];
    let c40 = constants[40];
    let c41 = constants[41];
    let c42 = constants[42];
    let c43 = constants[43];
    let c44 = constants[44];
    let c52 = constants[52];
    let y = state[0];
    let u = state[2];
    let s = input[0];
    let s_rate = input[1];
    let v0 = k1 * (s - y) + b1 * (s_rate - u);
    let v1 = functions::softplus(c37 * (y - ybed));
    let v2 = c38 * (v1 * v1) * functions::larger(1.0 + u * ab, 0.0);
    let v3 = functions::softplus(-(y * c37));
    let v4 = c39 * (v3 * v3) * functions::larger(1.0 - u * ar, 0.0);
    let v5 = c44 + u * c43;
    let v6 = v0 - (Wk + u * ck) - R * v5 - Fc * math::tanh(u * c40);
    let v7 = v6 - c42 * functions::softplus(c41 * (y - yb)) - v2;
    let out = out.first_chunk_mut::<4>()?;
    out[0] = v0;
    out[1] = v5 + c52 * (v4 + v7);
    [out[2], out[3]] = [0.0, 0.0];
    Some(())
}

/// Energy, supplied and dissipated power in mode ACC.
fn balance_acc(given: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let constants = given.constants.first_chunk::<59>()?;
    let state = given.state.first_chunk::<3>()?;
    let input = given.input;
    let mk = constants[1];
    let Wk = constants[4];
    let ck = constants[5];
    let Fc = constants[6];
    let ybed = constants[9];
    let ab = constants[11];
    let ar = constants[14];
    let yb = constants[15];
    let k1 = constants[35];
    let b1 = constants[36];
    let c37 = constants[37];
    let c38 = constants[38];
    let c39 = constants[39];
    let c40 = constants[40];
    let c41 = constants[41];
    let c53 = constants[53];
    let c54 = constants[54];
    let c55 = constants[55];
    let c56 = constants[56];
    let c57 = constants[57];
    let c58 = constants[58];
    let y = state[0];
    let u = state[2];
    let s = input[0];
    let s_rate = input[1];
    let v0 = s - y;
    let v1 = k1 * v0;
    let v2 = c37 * (y - ybed);
    let v3 = -(y * c37);
    let v4 = 0.5 * (v0 * v1) + (y * (Wk + c57) + u * u * (0.5 * (mk + c56)));
    let v5 = c53 * functions::softplus_area(c41 * (y - yb));
    let v6 = v4 + c55 * functions::softplus_square_area(v3);
    let v7 = v6 + (v5 + c54 * functions::softplus_square_area(v2));
    let v8 = s_rate - u;
    let v9 = b1 * v8;
    let v10 = functions::softplus(v2);
    let v11 = c38 * (functions::larger(1.0 + u * ab, 0.0) - 1.0);
    let v12 = functions::softplus(v3);
    let v13 = c39 * (functions::larger(1.0 - u * ar, 0.0) - 1.0);
    let v14 = u * c58 + (u * ck + Fc * math::tanh(u * c40)) + v10 * v10 * v11;
    let out = out.first_chunk_mut::<3>()?;
    out[0] = v7;
    out[1] = s_rate * (v1 + v9);
    out[2] = v8 * v9 + u * (v14 - v12 * v12 * v13);
    Some(())
}

/// The state after guard lift_off in mode ACC.
fn reset_0_lift_off_acc(given: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let constants = given.constants.first_chunk::<1>()?;
    let state = given.state.first_chunk::<3>()?;
    let R = constants[0];
    let y = state[0];
    let u = state[2];
    let out = out.first_chunk_mut::<5>()?;
    [out[0], out[1], out[2], out[3], out[4]] = [y, y * R, u, R * u, 0.0];
    Some(())
}

/// The guard and its rate: lift_off in mode ACC.
fn guard_lift_off_acc(given: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let constants = given.constants.first_chunk::<65>()?;
    let state = given.state.first_chunk::<3>()?;
    let input = given.input;
    let R = constants[0];
    let Wk = constants[4];
    let ck = constants[5];
    let Fc = constants[6];
    let ybed = constants[9];
    let ab = constants[11];
    let ar = constants[14];
    let yb = constants[15];
    let kj = constants[19];
    let k1 = constants[35];
    let b1 = constants[36];
    let c37 = constants[37];
    let c38 = constants[38];
    let c39 = constants[39];
    let c40 = constants[40];
    let c41 = constants[41];
    let c42 = constants[42];
    let c43 = constants[43];
    let c44 = constants[44];
    let c45 = constants[45];
    let c47 = constants[47];
    let c48 = constants[48];
    let c59 = constants[59];
    let c60 = constants[60];
    let c61 = constants[61];
    let c62 = constants[62];
    let c63 = constants[63];
    let c64 = constants[64];
    let y = state[0];
    let u = state[2];
    let s = input[0];
    let s_rate = input[1];
    let s_rate2 = input[2];
    let v0 = s_rate - u;
    let v1 = 1.0 + u * ab;
    let v2 = c37 * (y - ybed);
    let v3 = functions::softplus(v2);
    let v4 = v3 * functions::larger(v1, 0.0);
    let v5 = c38 * v3;
    let v6 = 1.0 - u * ar;
    let v7 = -(y * c37);
    let v8 = functions::softplus(v7);
    let v9 = v8 * functions::larger(v6, 0.0);
    let v10 = c39 * v8;
    let v11 = math::tanh(u * c40);
    let v12 = c41 * (y - yb);
    let v13 = Fc * v11 + c42 * functions::softplus(v12) + (v5 * v4 - v10 * v9);
    let v14 = k1 * (s - y) + b1 * v0 - (Wk + u * ck) - v13;
    let v15 = c44 + u * c43;
    let v16 = v14 - R * v15;
    let v17 = c47 * functions::logistic(v2) * v4 + c48 * functions::logistic(v7) * v9;
    let v18 = if v1 > 0.0 { c60 * v16 } else { 0.0 };
    let v19 = if v6 > 0.0 { -(c61 * v16) } else { 0.0 };
    let v20 = k1 * v0 + u * -(kj * functions::logistic(v12) + 2.0 * v17);
    let v21 = -(c63 + c62 * (1.0 - v11 * v11)) * v16 + v20 + b1 * (s_rate2 - c45 * v16);
    let v22 = c59 * (v21 + (v10 * (v8 * v19) - v5 * (v3 * v18)));
    let out = out.first_chunk_mut::<2>()?;
    out[0] = v15 + c59 * v14;
    out[1] = c64 * v16 + v22;
    Some(())
}

/// Bounds of the guard's move and bend: lift_off in mode ACC.
fn bound_lift_off_acc(given: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let constants = given.constants.first_chunk::<89>()?;
    let state = given.state.first_chunk::<3>()?;
    let extra = given.extra.first_chunk::<11>()?;
    let input = given.input;
    let ybed = constants[9];
    let Kb = constants[10];
    let ab = constants[11];
    let Kr = constants[13];
    let ar = constants[14];
    let yb = constants[15];
    let kj = constants[19];
    let k1 = constants[35];
    let c37 = constants[37];
    let c38 = constants[38];
    let c39 = constants[39];
    let c40 = constants[40];
    let c41 = constants[41];
    let c43 = constants[43];
    let c47 = constants[47];
    let c48 = constants[48];
    let c49 = constants[49];
    let c50 = constants[50];
    let c59 = constants[59];
    let c65 = constants[65];
    let c66 = constants[66];
    let c67 = constants[67];
    let c68 = constants[68];
    let c69 = constants[69];
    let c70 = constants[70];
    let c71 = constants[71];
    let c72 = constants[72];
    let c73 = constants[73];
    let c74 = constants[74];
    let c75 = constants[75];
    let c76 = constants[76];
    let c77 = constants[77];
    let c78 = constants[78];
    let c79 = constants[79];
    let c80 = constants[80];
    let c81 = constants[81];
    let c82 = constants[82];
    let c83 = constants[83];
    let c84 = constants[84];
    let c85 = constants[85];
    let c86 = constants[86];
    let c87 = constants[87];
    let c88 = constants[88];
    let y = state[0];
    let u = state[2];
    let s_rate = input[1];
    let s_rate2 = input[2];
    let s_rate3 = input[3];
    let v0 = 1.0 + u * ab;
    let v1 = functions::larger(v0, 0.0);
    let v2 = c37 * (y - ybed);
    let v3 = functions::logistic(v2);
    let v4 = functions::softplus(v2);
    let v5 = c47 * v4;
    let v6 = v3 * v5;
    let v7 = u * ar;
    let v8 = 1.0 - v7;
    let v9 = functions::larger(v8, 0.0);
    let v10 = y * c37;
    let v11 = -v10;
    let v12 = functions::logistic(v11);
    let v13 = functions::softplus(v11);
    let v14 = c48 * v13;
    let v15 = v12 * v14;
    let v16 = c41 * (y - yb);
    let v17 = functions::logistic(v16);
    let v18 = (k1 + kj * v17 + 2.0 * (v6 * v1 + v15 * v9)).abs();
    let v19 = extra[0] * c68;
    let v20 = functions::logistic(functions::larger(v2.abs() - v19, 0.0));
    let v21 = v20 * (1.0 - v20);
    let v22 = functions::logistic(functions::larger(v10.abs() - v19, 0.0));
    let v23 = v22 * (1.0 - v22);
    let v24 = 2.0 * ((v14 * v9).abs() * v23 + (v5 * v1).abs() * v21);
    let v25 = extra[0] * c69;
    let v26 = functions::logistic(functions::larger(v16.abs() - v25, 0.0));
    let v27 = v26 * (1.0 - v26);
    let v28 = v19 + v2;
    let v29 = functions::logistic(v28);
    let v30 = v0.abs();
    let v31 = extra[8] * c66;
    let v32 = v31 + v30;
    let v33 = extra[0] * v29 * (0.5 * (v32 + v32.abs()));
    let v34 = 0.5 * (v31 + v31.abs());
    let v35 = v5.abs();
    let v36 = v19 - v10;
    let v37 = functions::logistic(v36);
    let v38 = (v7 - 1.0).abs();
    let v39 = extra[8] * c67;
    let v40 = v39 + v38;
    let v41 = extra[0] * v37 * (0.5 * (v40 + v40.abs()));
    let v42 = 0.5 * (v39 + v39.abs());
    let v43 = v14.abs();
    let v44 = v29 * (v34 * v35 + c70 * v33) + v37 * (v42 * v43 + c71 * v41);
    let v45 = v18 + 2.0 * v44 + extra[0] * (c72 * v27 + c68 * v24);
    let v46 = v30 - v31;
    let v47 = if v0 > 0.0 { c66 } else { 0.0 };
    let v48 = if v46 > 0.0 { v47 } else { c66 };
    let v49 = c81 * (v48 * (functions::softplus(v28) + v4.abs()));
    let v50 = v38 - v39;
    let v51 = if v8 > 0.0 { c67 } else { 0.0 };
    let v52 = if v50 > 0.0 { v51 } else { c67 };
    let v53 = c82 * (v52 * (functions::softplus(v36) + v13.abs()));
    let v54 = if v0 > 0.0 { ab } else { 0.0 };
    let v55 = if v46 > 0.0 { 0.0 } else { c66 + v54.abs() };
    let v56 = v4 * (c38 * v4);
    let v57 = if v8 > 0.0 { c49 } else { 0.0 };
    let v58 = if v50 > 0.0 { 0.0 } else { c67 + v57.abs() };
    let v59 = v13 * (c39 * v13);
    let v60 = u * c40;
    let v61 = math::tanh(v60);
    let v62 = v61.abs();
    let v63 = functions::larger(v60.abs() - extra[8] * c80, 0.0);
    let v64 = math::tanh(v63);
    let v65 = 1.0 - v64 * v64;
    let v66 = extra[8] * v65;
    let v67 = v62 + functions::smaller(v62 + c80 * v66, 1.0);
    let v68 = v66 * v67;
    let v69 = v58 * v59.abs() + v55 * v56.abs() + extra[0] * (v37 * v53 + v29 * v49);
    let v70 = v61 * v61;
    let v71 = 1.0 - v70;
    let v72 = c59 * (c65 - c50 * v71 + (v57 * v59 - v54 * v56));
    let v73 = (c43 + v72).abs() + c84 * (v69 + c83 * v68);
    let v74 = extra[3] * (s_rate * c87 + s_rate2 * c88) + extra[0] * (c73 * v45);
    let v75 = if v46 > 0.0 { 0.0 } else { f64::INFINITY };
    let v76 = if v50 > 0.0 { 0.0 } else { f64::INFINITY };
    let v77 = v3 * (1.0 - v3);
    let v78 = v12 * (1.0 - v12);
    let v79 = c74 * (v17 * (1.0 - v17)) + Kb * (v1 * (2.0 * (v3 * v3 + v4 * v77)));
    let v80 = Kr * (-(2.0 * (v12 * v12 + v13 * v78)) * v9) + v79;
    let v81 = Kb * v1;
    let v82 = v29 + v3.abs();
    let v83 = Kr * v9;
    let v84 = v37 + v12.abs();
    let v85 = 2.0 * (v84 * v83.abs() * v23 + v82 * v81.abs() * v21);
    let v86 = v19 * v21;
    let v87 = v86 + v82 * v86;
    let v88 = (v34 * (Kb * v4).abs() + c76 * v33) * (v77.abs() + v87);
    let v89 = v19 * v23;
    let v90 = v89 + v84 * v89;
    let v91 = (v42 * (Kr * v13).abs() + c78 * v41) * (v78.abs() + v90);
    let v92 = 1.0 + (functions::logistic(v25 + v16) + v17.abs());
    let v93 = v29 * v34 * (c75 * v29) + c77 * v37 * (v37 * v42);
    let v94 = (v4 * v81).abs() * v87 + v91 + (v93 + (v13 * v83).abs() * v90 + v88);
    let v95 = v80.abs() + c79 * (extra[0] * (c69 * (v92 * v27)));
    let v96 = extra[1] * (extra[0] * (c68 * v85) + v95 + 2.0 * v94);
    let v97 = v48 * (extra[0] * (v29 * (c70 * v29) + c68 * v35 * v21));
    let v98 = v52 * (extra[0] * (v37 * (c71 * v37) + c68 * v43 * v23));
    let v99 = 2.0 * (v97 + (v58 * v15.abs() + v55 * v6.abs() + v98));
    let v100 = extra[9] * ((2.0 * (v57 * v15 + v54 * v6)).abs() + v99);
    let v101 = c73 * (extra[2] * v45 + extra[1] * (2.0 * v100 + v96));
    let v102 = extra[3] * extra[3] * (c87 * s_rate2 + c88 * s_rate3);
    let v103 = c85 * v61;
    let v104 = c80 * v103.abs() * v67 + c86 * ((v70 - 1.0).abs() + c80 * v68);
    let v105 = (2.0 * (v103 * v71)).abs() + extra[8] * (v65 * (2.0 * v104));
    let v106 = v76 + (v102 + v75) + v101 + extra[10] * v73 + extra[9] * (extra[9] * v105);
    let out = out.first_chunk_mut::<2>()?;
    out[0] = v74 + extra[8] * v73;
    out[1] = v106;
    Some(())
}

/// The state after guard button in mode ACC.
fn reset_0_button_acc(given: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let constants = given.constants.first_chunk::<93>()?;
    let state = given.state.first_chunk::<3>()?;
    let yb = constants[15];
    let c89 = constants[89];
    let c90 = constants[90];
    let c91 = constants[91];
    let c92 = constants[92];
    let y = state[0];
    let u = state[2];
    let v0 = y - yb;
    let v1 = c90 * v0;
    let out = out.first_chunk_mut::<5>()?;
    out[0] = y;
    out[1] = c92 + c91 * (v0 * (c89 - 0.5 * v1));
    out[2] = u;
    out[3] = c91 * u * (c89 - v1);
    out[4] = 0.0;
    Some(())
}

/// The guard and its rate: button in mode ACC.
fn guard_button_acc(given: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let constants = given.constants.first_chunk::<16>()?;
    let state = given.state.first_chunk::<3>()?;
    let yb = constants[15];
    let y = state[0];
    let u = state[2];
    let out = out.first_chunk_mut::<2>()?;
    [out[0], out[1]] = [yb - y, -u];
    Some(())
}

/// Bounds of the guard's move and bend: button in mode ACC.
fn bound_button_acc(given: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let extra = given.extra.first_chunk::<3>()?;
    let out = out.first_chunk_mut::<2>()?;
    [out[0], out[1]] = [extra[0], extra[2]];
    Some(())
}

/// Where the Taylor series begins in mode ACC.
fn series_start_acc(given: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let constants = given.constants.first_chunk::<60>()?;
    let state = given.state.first_chunk::<3>()?;
    let input = given.input;
    let R = constants[0];
    let Wk = constants[4];
    let ck = constants[5];
    let Fc = constants[6];
    let ybed = constants[9];
    let ab = constants[11];
    let ar = constants[14];
    let yb = constants[15];
    let k1 = constants[35];
    let b1 = constants[36];
    let c37 = constants[37];
    let c38 = constants[38];
    let c39 = constants[39];
    let c40 = constants[40];
    let c41 = constants[41];
    let c42 = constants[42];
    let c43 = constants[43];
    let c44 = constants[44];
    let c45 = constants[45];
    let c59 = constants[59];
    let y = state[0];
    let u = state[2];
    let s = input[0];
    let s_rate = input[1];
    let v0 = c44 + u * c43;
    let v1 = 1.0 + u * ab;
    let v2 = v1 - 0.0;
    let v3 = if v2 > 0.0 { v1 } else { 0.0 };
    let v4 = c37 * (y - ybed);
    let v5 = functions::logistic(v4);
    let v6 = functions::softplus(v4);
    let v7 = c38 * (v6 * v6);
    let v8 = 1.0 - u * ar;
    let v9 = v8 - 0.0;
    let v10 = if v9 > 0.0 { v8 } else { 0.0 };
    let v11 = -(y * c37);
    let v12 = functions::logistic(v11);
    let v13 = functions::softplus(v11);
    let v14 = c39 * (v13 * v13);
    let v15 = u * c40;
    let v16 = math::tanh(v15);
    let v17 = y - yb;
    let v18 = c41 * v17;
    let v19 = functions::logistic(v18);
    let v20 = Fc * v16 + c42 * functions::softplus(v18) + (v7 * v3 - v14 * v10);
    let v21 = k1 * (s - y) + b1 * (s_rate - u) - (Wk + u * ck) - v20;
    let v22 = v4.abs();
    let v23 = if v22 - 20.0 > 0.0 { 20.0 } else { 10.0 };
    let v24 = if v22 - 40.0 > 0.0 { 40.0 } else { v23 };
    let v25 = v22 - v24;
    let v26 = v25 - 0.0;
    let v27 = if v26 > 0.0 { v25 } else { 0.0 };
    let v28 = v11.abs();
    let v29 = if v28 - 20.0 > 0.0 { 20.0 } else { 10.0 };
    let v30 = if v28 - 40.0 > 0.0 { 40.0 } else { v29 };
    let v31 = v28 - v30;
    let v32 = v31 - 0.0;
    let v33 = if v32 > 0.0 { v31 } else { 0.0 };
    let v34 = v18.abs();
    let v35 = if v34 - 20.0 > 0.0 { 20.0 } else { 10.0 };
    let v36 = if v34 - 40.0 > 0.0 { 40.0 } else { v35 };
    let v37 = v34 - v36;
    let v38 = v37 - 0.0;
    let v39 = if v38 > 0.0 { v37 } else { 0.0 };
    let v40 = v15.abs();
    let v41 = v40 + v40;
    let v42 = if v41 - 20.0 > 0.0 { 20.0 } else { 10.0 };
    let v43 = if v41 - 40.0 > 0.0 { 40.0 } else { v42 };
    let v44 = v41 - v43;
    let v45 = v44 - 0.0;
    let v46 = if v45 > 0.0 { v44 } else { 0.0 };
    let out = out.first_chunk_mut::<39>()?;
    out[0] = u;
    out[1] = c45 * (v21 - R * v0);
    [out[2], out[3]] = [R * y, u * R];
    out[4] = v0 + c59 * v21;
    [out[5], out[6], out[7], out[8], out[9], out[10], out[11]] = [-v17, v2, v9, v27, v33, v39, v46];
    [out[12], out[13], out[14], out[15], out[16]] = [v2, v5 - v5 * v5, v5 + v5, v5, v6 + v6];
    [out[17], out[18], out[19]] = [v7, v3, v9];
    out[20] = v12 - v12 * v12;
    [out[21], out[22], out[23], out[24], out[25]] = [v12 + v12, v12, v13 + v13, v14, v10];
    out[26] = 1.0 - v16 * v16;
    out[27] = v16 + v16;
    out[28] = v19 - v19 * v19;
    [out[29], out[30]] = [v19 + v19, v19];
    out[31] = functions::sign(v4);
    out[32] = v26;
    out[33] = functions::sign(v11);
    out[34] = v32;
    out[35] = functions::sign(v18);
    out[36] = v38;
    out[37] = functions::sign(v15);
    out[38] = v45;
    Some(())
}

/// One order of the Taylor series in mode ACC.
fn series_step_acc(given: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let constants = given.constants.first_chunk::<60>()?;
    let state = given.state.first_chunk::<3>()?;
    let extra = given.extra.first_chunk::<44>()?;
    let input = given.input;
    let R = constants[0];
    let ck = constants[5];
    let Fc = constants[6];
    let ab = constants[11];
    let ar = constants[14];
    let k1 = constants[35];
    let b1 = constants[36];
    let c37 = constants[37];
    let c38 = constants[38];
    let c39 = constants[39];
    let c40 = constants[40];
    let c41 = constants[41];
    let c42 = constants[42];
    let c43 = constants[43];
    let c45 = constants[45];
    let c59 = constants[59];
    let y = state[0];
    let u = state[2];
    let s = input[0];
    let s_rate = input[1];
    let v0 = c43 * u;
    let v1 = ab * u;
    let v2 = if extra[2] > 0.0 { v1 } else { 0.0 };
    let v3 = c37 * y;
    let v4 = extra[29] * extra[1] + v3 * extra[3];
    let v5 = extra[31] * extra[1] + v3 * extra[5];
    let v6 = c38 * (extra[32] + extra[6] * v5);
    let v7 = -(ar * u);
    let v8 = if extra[9] > 0.0 { v7 } else { 0.0 };
    let v9 = -v3;
    let v10 = extra[34] * extra[1] + v9 * extra[10];
    let v11 = extra[36] * extra[1] + v9 * extra[12];
    let v12 = c39 * (extra[37] + extra[13] * v11);
    let v13 = extra[38] + extra[14] * v8 + v12 * extra[15];
    let v14 = c40 * u;
    let v15 = extra[39] * extra[1] + v14 * extra[16];
    let v16 = c41 * y;
    let v17 = extra[41] * extra[1] + v16 * extra[18];
    let v18 = Fc * v15 + c42 * (extra[43] * extra[1] + v16 * extra[20]);
    let v19 = v18 + (extra[33] + extra[7] * v2 + v6 * extra[8] - v13);
    let v20 = k1 * (s - y) + b1 * (s_rate - u) - ck * u - v19;
    let v21 = if extra[22] > 0.0 { extra[21] * v3 } else { 0.0 };
    let v22 = if extra[24] > 0.0 { extra[23] * v9 } else { 0.0 };
    let v23 = if extra[26] > 0.0 { extra[25] * v16 } else { 0.0 };
    let v24 = extra[27] * v14;
    let v25 = if extra[28] > 0.0 { v24 + v24 } else { 0.0 };
    let v26 = extra[0] * v3;
    let v27 = extra[0] * v9;
    let v28 = extra[0] * v16;
    let out = out.first_chunk_mut::<42>()?;
    out[0] = u;
    out[1] = c45 * (v20 - R * v0);
    [out[2], out[3]] = [R * y, R * u];
    out[4] = v0 + c59 * v20;
    [out[5], out[6], out[7], out[8], out[9], out[10], out[11]] = [-y, v1, v7, v21, v22, v23, v25];
    [out[12], out[13], out[14], out[15], out[16], out[17]] = [v26, v4, v26, v5, v6, v27];
    [out[18], out[19], out[20], out[21]] = [v10, v27, v11, v12];
    out[22] = extra[0] * v14;
    [out[23], out[24], out[25], out[26]] = [v15, v28, v17, v28];
    out[27] = v4 - (extra[30] + extra[4] * v4);
    [out[28], out[29], out[30], out[31]] = [v4, v4, v5, v2];
    out[32] = v10 - (extra[35] + extra[11] * v10);
    [out[33], out[34], out[35], out[36]] = [v10, v10, v11, v8];
    out[37] = -(extra[40] + extra[17] * v15);
    out[38] = v15;
    out[39] = v17 - (extra[42] + extra[19] * v17);
    [out[40], out[41]] = [v17, v17];
    Some(())
}

/// The derivative of the state in mode LO.
fn derivative_lo(given: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let constants = given.constants.first_chunk::<97>()?;
    let state = given.state.first_chunk::<3>()?;
    let input = given.input;
    let R = constants[0];
    let mk = constants[1];
    let mh = constants[2];
    let g = constants[3];
    let Wk = constants[4];
    let ck = constants[5];
    let Fc = constants[6];
    let ybed = constants[9];
    let ab = constants[11];
    let ar = constants[14];
    let yb = constants[15];
    let k1 = constants[35];
    let b1 = constants[36];
    let c37 = constants[37];
    let c38 = constants[38];
    let c39 = constants[39];
    let c40 = constants[40];
    let c41 = constants[41];
    let c42 = constants[42];
    let c43 = constants[43];
    let c89 = constants[89];
    let c90 = constants[90];
    let c91 = constants[91];
    let c93 = constants[93];
    let c94 = constants[94];
    let c95 = constants[95];
    let c96 = constants[96];
    let y = state[0];
    let u = state[2];
    let s = input[0];
    let s_rate = input[1];
    let v0 = y - yb;
    let v1 = c91 * (c89 - c90 * v0);
    let v2 = functions::softplus(c37 * (y - ybed));
    let v3 = c38 * (v2 * v2) * functions::larger(1.0 + u * ab, 0.0);
    let v4 = functions::softplus(-(y * c37));
    let v5 = c39 * (v4 * v4) * functions::larger(1.0 - u * ar, 0.0);
    let v6 = math::tanh(u * c40);
    let v7 = 1.0 - c93 * v0;
    let v8 = 1.0 - c89 * v0;
    let v9 = R * v7 + 16.0 * (c94 * (v0 * v0) * (v8 * v8) * v6);
    let v10 = c95 * (u * u);
    let v11 = k1 * (s - y) + b1 * (s_rate - u) - (Wk + u * ck) - Fc * v6;
    let v12 = v11 - c42 * functions::softplus(c41 * v0) - (mh * (g - v10) + u * c43 * v7) * v9;
    let v13 = 1.0 / (mk + c96 * v7 * v9) * (v5 + (v12 - v3));
    let out = out.first_chunk_mut::<4>()?;
    [out[0], out[1], out[2]] = [u, u * v1, v13];
    out[3] = v1 * v13 - v10;
    Some(())
}

/// The derivative of a part in mode LO.
fn part_0_lo(given: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let constants = given.constants.first_chunk::<97>()?;
    let state = given.state.first_chunk::<3>()?;
    let input = given.input;
    let R = constants[0];
    let mk = constants[1];
    let mh = constants[2];
    let g = constants[3];
    let Wk = constants[4];
    let ck = constants[5];
    let Fc = constants[6];
    let ybed = constants[9];
    let ab = constants[11];
    let ar = constants[14];
    let yb = constants[15];
    let k1 = constants[35];
    let b1 = constants[36];
    let c37 = constants[37];
    let c38 = constants[38];
    let c39 = constants[39];
    let c40 = constants[40];
    let c41 = constants[41];
    let c42 = constants[42];
    let c43 = constants[43];
    let c89 = constants[89];
    let c93 = constants[93];
    let c94 = constants[94];
    let c95 = constants[95];
    let c96 = constants[96];
    let y = state[0];
    let u = state[2];
    let s = input[0];
    let s_rate = input[1];
    let v0 = functions::softplus(c37 * (y - ybed));
    let v1 = c38 * (v0 * v0) * functions::larger(1.0 + u * ab, 0.0);
    let v2 = functions::softplus(-(y * c37));
    let v3 = c39 * (v2 * v2) * functions::larger(1.0 - u * ar, 0.0);
    let v4 = math::tanh(u * c40);
    let v5 = y - yb;
    let v6 = 1.0 - c93 * v5;
    let v7 = 1.0 - c89 * v5;
    let v8 = R * v6 + 16.0 * (c94 * (v5 * v5) * (v7 * v7) * v4);
    let v9 = k1 * (s - y) + b1 * (s_rate - u) - (Wk + u * ck) - Fc * v4;
    let v10 = (mh * (g - c95 * (u * u)) + u * c43 * v6) * v8;
    let v11 = v9 - c42 * functions::softplus(c41 * v5) - v10 - v1;
    let out = out.first_chunk_mut::<4>()?;
    [out[0], out[1]] = [u, 0.0];
    out[2] = (v3 + v11) / (mk + c96 * v6 * v8);
    out[3] = 0.0;
    Some(())
}

/// The state with slaved entries in place in mode LO.
fn slaved_lo(given: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let constants = given.constants.first_chunk::<93>()?;
    let state = given.state.first_chunk::<3>()?;
    let yb = constants[15];
    let c89 = constants[89];
    let c90 = constants[90];
    let c91 = constants[91];
    let c92 = constants[92];
    let y = state[0];
    let u = state[2];
    let v0 = y - yb;
    let v1 = c90 * v0;
    let out = out.first_chunk_mut::<4>()?;
    out[0] = y;
    out[1] = c92 + c91 * (v0 * (c89 - 0.5 * v1));
    out[2] = u;
    out[3] = c91 * u * (c89 - v1);
    Some(())
}

/// The derivative's derivative by the state in mode LO.
fn jacobian_lo(given: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let constants = given.constants.first_chunk::<102>()?;
    let state = given.state.first_chunk::<3>()?;
    let input = given.input;
    let R = constants[0];
    let mk = constants[1];
    let mh = constants[2];
    let g = constants[3];
    let Wk = constants[4];
    let ck = constants[5];
    let Fc = constants[6];
    let ybed = constants[9];
    let ab = constants[11];
    let ar = constants[14];
    let yb = constants[15];
    let kj = constants[19];
    let k1 = constants[35];
    let b1 = constants[36];
    let c37 = constants[37];
    let c38 = constants[38];
    let c39 = constants[39];
    let c40 = constants[40];
    let c41 = constants[41];
    let c42 = constants[42];
    let c43 = constants[43];
    let c47 = constants[47];
    let c48 = constants[48];
    let c49 = constants[49];
    let c50 = constants[50];
    let c65 = constants[65];
    let c89 = constants[89];
    let c93 = constants[93];
    let c94 = constants[94];
    let c95 = constants[95];
    let c96 = constants[96];
    let c97 = constants[97];
    let c98 = constants[98];
    let c99 = constants[99];
    let c100 = constants[100];
    let c101 = constants[101];
    let y = state[0];
    let u = state[2];
    let s = input[0];
    let s_rate = input[1];
    let v0 = 1.0 + u * ab;
    let v1 = functions::larger(v0, 0.0);
    let v2 = c37 * (y - ybed);
    let v3 = functions::softplus(v2);
    let v4 = 1.0 - u * ar;
    let v5 = functions::larger(v4, 0.0);
    let v6 = -(y * c37);
    let v7 = functions::softplus(v6);
    let v8 = y - yb;
    let v9 = c41 * v8;
    let v10 = 1.0 - c93 * v8;
    let v11 = c43 * v10;
    let v12 = mh * (g - c95 * (u * u)) + u * v11;
    let v13 = math::tanh(u * c40);
    let v14 = 1.0 - c89 * v8;
    let v15 = v8 * (v14 * (32.0 * (c94 * v14 - c97 * v8)) * v13);
    let v16 = v15 - c95;
    let v17 = v8 * v14;
    let v18 = R * v10 + 16.0 * (c94 * v17 * (v17 * v13));
    let v19 = functions::logistic(v2) * (c47 * v3) * v1;
    let v20 = 2.0 * (v19 + functions::logistic(v6) * (c48 * v7) * v5);
    let v21 = u * c98 * v18 - (k1 + kj * functions::logistic(v9) + v12 * v16);
    let v22 = c96 * v10;
    let v23 = v3 * (c38 * v3);
    let v24 = v7 * (c39 * v7);
    let v25 = k1 * (s - y) + b1 * (s_rate - u) - (Wk + u * ck) - Fc * v13;
    let v26 = v25 - c42 * functions::softplus(v9) - v12 * v18 - v23 * v1;
    let v27 = 1.0 / (mk + v22 * v18);
    let v28 = (v24 * v5 + v26) * v27;
    let v29 = v27 * (v21 - v20 - (v22 * v16 - c99 * v18) * v28);
    let v30 = 1.0 - v13 * v13;
    let v31 = if v0 > 0.0 { ab } else { 0.0 };
    let v32 = if v4 > 0.0 { c49 } else { 0.0 };
    let v33 = c65 + -(c50 + 16.0 * (v17 * v17 * (c100 * v12))) * v30;
    let v34 = v32 * v24 - v31 * v23 + (v33 - (v11 - 2.0 * (u * c99)) * v18);
    let v35 = v34 - 16.0 * (c101 * v10 * (v17 * (v17 * v30) * v28));
    let out = out.first_chunk_mut::<16>()?;
    [out[0], out[1], out[2], out[3], out[4], out[5], out[6]] = [0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0];
    [out[7], out[8], out[9], out[10], out[11], out[12]] = [0.0, v29, 0.0, v27 * v35, 0.0, 0.0];
    [out[13], out[14], out[15]] = [0.0, 0.0, 0.0];
    Some(())
}

/// The outputs in mode LO.
fn outputs_lo(given: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let constants = given.constants.first_chunk::<97>()?;
    let state = given.state.first_chunk::<3>()?;
    let input = given.input;
    let R = constants[0];
    let mk = constants[1];
    let mh = constants[2];
    let g = constants[3];
    let Wk = constants[4];
    let ck = constants[5];
    let Fc = constants[6];
    let ybed = constants[9];
    let ab = constants[11];
    let ar = constants[14];
    let yb = constants[15];
    let k1 = constants[35];
    let b1 = constants[36];
    let c37 = constants[37];
    let c38 = constants[38];
    let c39 = constants[39];
    let c40 = constants[40];
    let c41 = constants[41];
    let c42 = constants[42];
    let c43 = constants[43];
    let c89 = constants[89];
    let c93 = constants[93];
    let c94 = constants[94];
    let c95 = constants[95];
    let c96 = constants[96];
    let y = state[0];
    let u = state[2];
    let s = input[0];
    let s_rate = input[1];
    let v0 = k1 * (s - y) + b1 * (s_rate - u);
    let v1 = functions::softplus(c37 * (y - ybed));
    let v2 = c38 * (v1 * v1) * functions::larger(1.0 + u * ab, 0.0);
    let v3 = functions::softplus(-(y * c37));
    let v4 = c39 * (v3 * v3) * functions::larger(1.0 - u * ar, 0.0);
    let v5 = math::tanh(u * c40);
    let v6 = y - yb;
    let v7 = 1.0 - c93 * v6;
    let v8 = 1.0 - c89 * v6;
    let v9 = R * v7 + 16.0 * (c94 * (v6 * v6) * (v8 * v8) * v5);
    let v10 = mh * (g - c95 * (u * u)) + u * c43 * v7;
    let v11 = v0 - (Wk + u * ck) - Fc * v5 - c42 * functions::softplus(c41 * v6);
    let v12 = c96 * v7;
    let v13 = v12 * (v4 + (v11 - v10 * v9 - v2)) / (mk + v12 * v9);
    let out = out.first_chunk_mut::<4>()?;
    [out[0], out[1], out[2], out[3]] = [v0, v10 + v13, 0.0, 0.0];
    Some(())
}

/// Energy, supplied and dissipated power in mode LO.
fn balance_lo(given: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let constants = given.constants.first_chunk::<104>()?;
    let state = given.state.first_chunk::<3>()?;
    let input = given.input;
    let R = constants[0];
    let mk = constants[1];
    let mh = constants[2];
    let g = constants[3];
    let Wk = constants[4];
    let ck = constants[5];
    let Fc = constants[6];
    let ybed = constants[9];
    let ab = constants[11];
    let ar = constants[14];
    let yb = constants[15];
    let k1 = constants[35];
    let b1 = constants[36];
    let c37 = constants[37];
    let c38 = constants[38];
    let c39 = constants[39];
    let c40 = constants[40];
    let c41 = constants[41];
    let c42 = constants[42];
    let c43 = constants[43];
    let c44 = constants[44];
    let c53 = constants[53];
    let c54 = constants[54];
    let c55 = constants[55];
    let c89 = constants[89];
    let c90 = constants[90];
    let c91 = constants[91];
    let c92 = constants[92];
    let c93 = constants[93];
    let c94 = constants[94];
    let c95 = constants[95];
    let c96 = constants[96];
    let c102 = constants[102];
    let c103 = constants[103];
    let y = state[0];
    let u = state[2];
    let s = input[0];
    let s_rate = input[1];
    let v0 = y - yb;
    let v1 = c90 * v0;
    let v2 = c89 - v1;
    let v3 = u * u;
    let v4 = s - y;
    let v5 = k1 * v4;
    let v6 = c41 * v0;
    let v7 = c37 * (y - ybed);
    let v8 = -(y * c37);
    let v9 = c89 * v0;
    let v10 = y * Wk + 0.5 * (v4 * v5) + v3 * (0.5 * (mk + c102 * (v2 * v2)));
    let v11 = c44 * (c92 + c91 * (v9 - 0.5 * (v0 * v1))) + v10;
    let v12 = c53 * functions::softplus_area(v6) + c54 * functions::softplus_square_area(v7);
    let v13 = c55 * functions::softplus_square_area(v8) + v11 + v12;
    let v14 = s_rate - u;
    let v15 = b1 * v14;
    let v16 = v5 + v15;
    let v17 = math::tanh(u * c40);
    let v18 = u * ck + Fc * v17;
    let v19 = functions::softplus(v7);
    let v20 = v19 * (c38 * v19);
    let v21 = v20 * functions::larger(1.0 + u * ab, 0.0);
    let v22 = functions::softplus(v8);
    let v23 = v22 * (c39 * v22);
    let v24 = v23 * functions::larger(1.0 - u * ar, 0.0);
    let v25 = 1.0 - c93 * v0;
    let v26 = 1.0 - v9;
    let v27 = c94 * v26 * (v0 * v26 * (v0 * v17));
    let v28 = R * v25 + 16.0 * v27;
    let v29 = mh * (g - c95 * v3) + u * c43 * v25;
    let v30 = v16 - Wk - v18 - c42 * functions::softplus(v6) - v29 * v28;
    let v31 = c96 * v25;
    let v32 = v29 + v31 * (v30 + (v24 - v21)) / (mk + v31 * v28);
    let v33 = v2 * (c103 * (u * v2)) + v18 + (v21 - v20) - (v24 - v23);
    let out = out.first_chunk_mut::<3>()?;
    [out[0], out[1]] = [v13, s_rate * v16];
    out[2] = v14 * v15 + u * (v33 + 16.0 * (v27 * v32));
    Some(())
}

/// The guard and its rate: lift_off in mode LO.
fn guard_lift_off_lo(given: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let constants = given.constants.first_chunk::<105>()?;
    let state = given.state.first_chunk::<3>()?;
    let input = given.input;
    let R = constants[0];
    let mk = constants[1];
    let mh = constants[2];
    let g = constants[3];
    let Wk = constants[4];
    let ck = constants[5];
    let Fc = constants[6];
    let ybed = constants[9];
    let ab = constants[11];
    let ar = constants[14];
    let yb = constants[15];
    let kj = constants[19];
    let k1 = constants[35];
    let b1 = constants[36];
    let c37 = constants[37];
    let c38 = constants[38];
    let c39 = constants[39];
    let c40 = constants[40];
    let c41 = constants[41];
    let c42 = constants[42];
    let c43 = constants[43];
    let c47 = constants[47];
    let c48 = constants[48];
    let c50 = constants[50];
    let c59 = constants[59];
    let c89 = constants[89];
    let c93 = constants[93];
    let c94 = constants[94];
    let c95 = constants[95];
    let c96 = constants[96];
    let c98 = constants[98];
    let c99 = constants[99];
    let c104 = constants[104];
    let y = state[0];
    let u = state[2];
    let s = input[0];
    let s_rate = input[1];
    let s_rate2 = input[2];
    let v0 = s_rate - u;
    let v1 = 1.0 + u * ab;
    let v2 = c37 * (y - ybed);
    let v3 = functions::softplus(v2);
    let v4 = v3 * functions::larger(v1, 0.0);
    let v5 = c38 * v3;
    let v6 = 1.0 - u * ar;
    let v7 = -(y * c37);
    let v8 = functions::softplus(v7);
    let v9 = v8 * functions::larger(v6, 0.0);
    let v10 = c39 * v8;
    let v11 = math::tanh(u * c40);
    let v12 = y - yb;
    let v13 = c41 * v12;
    let v14 = Fc * v11 + c42 * functions::softplus(v13) + (v5 * v4 - v10 * v9);
    let v15 = k1 * (s - y) + b1 * v0 - (Wk + u * ck) - v14;
    let v16 = 1.0 - c93 * v12;
    let v17 = mh * (g - c95 * (u * u)) + u * (c43 * v16);
    let v18 = 1.0 - c89 * v12;
    let v19 = R * v16 + 16.0 * (c94 * (v12 * v12) * (v18 * v18) * v11);
    let v20 = v15 - v17 * v19;
    let v21 = 1.0 / (mk + c96 * v16 * v19);
    let v22 = v21 * v20;
    let v23 = c47 * functions::logistic(v2) * v4 + c48 * functions::logistic(v7) * v9;
    let v24 = if v1 > 0.0 { ab * v22 } else { 0.0 };
    let v25 = if v6 > 0.0 { -(ar * v22) } else { 0.0 };
    let v26 = k1 * v0 + u * -(kj * functions::logistic(v13) + 2.0 * v23);
    let v27 = -(ck + c50 * (1.0 - v11 * v11)) * v21 * v20 + v26;
    let v28 = v10 * (v8 * v25) + (v27 + b1 * (s_rate2 - v22) - v5 * (v3 * v24));
    let v29 = u * -(u * c98 + c104 * v15 + 2.0 * (c99 * v22)) + v16 * (c43 * v22 + c59 * v28);
    let out = out.first_chunk_mut::<2>()?;
    out[0] = v17 + c59 * v16 * v15;
    out[1] = v29;
    Some(())
}

/// Bounds of the guard's move and bend: lift_off in mode LO.
fn bound_lift_off_lo(given: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let constants = given.constants.first_chunk::<124>()?;
    let state = given.state.first_chunk::<3>()?;
    let extra = given.extra.first_chunk::<11>()?;
    let input = given.input;
    let Wk = constants[4];
    let ck = constants[5];
    let Fc = constants[6];
    let ybed = constants[9];
    let Kb = constants[10];
    let ab = constants[11];
    let Kr = constants[13];
    let ar = constants[14];
    let yb = constants[15];
    let kj = constants[19];
    let k1 = constants[35];
    let b1 = constants[36];
    let c37 = constants[37];
    let c38 = constants[38];
    let c39 = constants[39];
    let c40 = constants[40];
    let c41 = constants[41];
    let c42 = constants[42];
    let c43 = constants[43];
    let c47 = constants[47];
    let c48 = constants[48];
    let c49 = constants[49];
    let c50 = constants[50];
    let c59 = constants[59];
    let c65 = constants[65];
    let c66 = constants[66];
    let c67 = constants[67];
    let c68 = constants[68];
    let c69 = constants[69];
    let c70 = constants[70];
    let c71 = constants[71];
    let c72 = constants[72];
    let c74 = constants[74];
    let c75 = constants[75];
    let c76 = constants[76];
    let c77 = constants[77];
    let c78 = constants[78];
    let c79 = constants[79];
    let c80 = constants[80];
    let c81 = constants[81];
    let c82 = constants[82];
    let c83 = constants[83];
    let c85 = constants[85];
    let c87 = constants[87];
    let c88 = constants[88];
    let c93 = constants[93];
    let c98 = constants[98];
    let c99 = constants[99];
    let c104 = constants[104];
    let c105 = constants[105];
    let c106 = constants[106];
    let c107 = constants[107];
    let c108 = constants[108];
    let c109 = constants[109];
    let c110 = constants[110];
    let c111 = constants[111];
    let c112 = constants[112];
    let c113 = constants[113];
    let c114 = constants[114];
    let c115 = constants[115];
    let c116 = constants[116];
    let c117 = constants[117];
    let c118 = constants[118];
    let c119 = constants[119];
    let c120 = constants[120];
    let c121 = constants[121];
    let c122 = constants[122];
    let c123 = constants[123];
    let y = state[0];
    let u = state[2];
    let s_rate = input[1];
    let s_rate2 = input[2];
    let s_rate3 = input[3];
    let v0 = extra[0] * c112;
    let v1 = y - yb;
    let v2 = c93 * v1;
    let v3 = v0 + (v2 - 1.0).abs();
    let v4 = c37 * (y - ybed);
    let v5 = extra[0] * c68;
    let v6 = v5 + v4;
    let v7 = functions::logistic(v6);
    let v8 = 1.0 + u * ab;
    let v9 = v8.abs();
    let v10 = extra[8] * c66;
    let v11 = v10 + v9;
    let v12 = 0.5 * (v11 + v11.abs());
    let v13 = functions::softplus(v4);
    let v14 = c81 * (functions::softplus(v6) + v13.abs());
    let v15 = y * c37;
    let v16 = v5 - v15;
    let v17 = functions::logistic(v16);
    let v18 = u * ar;
    let v19 = (v18 - 1.0).abs();
    let v20 = extra[8] * c67;
    let v21 = v20 + v19;
    let v22 = 0.5 * (v21 + v21.abs());
    let v23 = -v15;
    let v24 = functions::softplus(v23);
    let v25 = c82 * (functions::softplus(v16) + v24.abs());
    let v26 = c41 * v1;
    let v27 = extra[0] * c69;
    let v28 = functions::logistic(v27 + v26);
    let v29 = v17 * v25 * v22 + (c111 * v28 + v12 * (v7 * v14));
    let v30 = u * c40;
    let v31 = functions::larger(v30.abs() - extra[8] * c80, 0.0);
    let v32 = math::tanh(v31);
    let v33 = 1.0 - v32 * v32;
    let v34 = 0.5 * (v10 + v10.abs());
    let v35 = c38 * v13;
    let v36 = v13 * v35;
    let v37 = v36.abs();
    let v38 = 0.5 * (v20 + v20.abs());
    let v39 = c39 * v24;
    let v40 = v24 * v39;
    let v41 = v40.abs();
    let v42 = c108 * (s_rate + extra[8]) + c107 * (extra[0] + extra[3] * s_rate);
    let v43 = v34 * v37 + (v42 + v38 * v41) + extra[0] * v29 + extra[8] * (c110 + c109 * v33);
    let v44 = functions::logistic(v4);
    let v45 = functions::larger(v8, 0.0);
    let v46 = v13 * v45;
    let v47 = c47 * v46;
    let v48 = functions::logistic(v23);
    let v49 = 1.0 - v18;
    let v50 = functions::larger(v49, 0.0);
    let v51 = v24 * v50;
    let v52 = c48 * v51;
    let v53 = functions::logistic(v26);
    let v54 = k1 + 2.0 * (v44 * v47) + 2.0 * (0.5 * (kj * v53) + v48 * v52);
    let v55 = extra[0] * v17;
    let v56 = v55 * v22;
    let v57 = c48 * v24;
    let v58 = v57.abs();
    let v59 = functions::logistic(functions::larger(v15.abs() - v5, 0.0));
    let v60 = v59 * (1.0 - v59);
    let v61 = v5 * v60;
    let v62 = functions::logistic(functions::larger(v26.abs() - v27, 0.0));
    let v63 = v62 * (1.0 - v62);
    let v64 = extra[0] * v7;
    let v65 = v64 * v12;
    let v66 = c47 * v13;
    let v67 = v66.abs();
    let v68 = functions::logistic(functions::larger(v4.abs() - v5, 0.0));
    let v69 = v68 * (1.0 - v68);
    let v70 = v5 * v69;
    let v71 = 2.0 * (v7 * (v34 * v67 + c70 * v65) + v47.abs() * v70);
    let v72 = v17 * (v38 * v58 + c71 * v56) + v52.abs() * v61;
    let v73 = 2.0 * (v72 + 0.5 * (extra[0] * c72 * v63 + v71));
    let v74 = extra[0] * c115;
    let v75 = 1.0 - v2;
    let v76 = c59 * v75;
    let v77 = v76.abs();
    let v78 = -v54;
    let v79 = math::tanh(v30);
    let v80 = u * -(b1 + ck) + (k1 * (extra[7] - y) - Wk) - Fc * v79;
    let v81 = v39 * v51 + (v80 - c42 * functions::softplus(v26) - v35 * v46);
    let v82 = extra[8] * c113 + (u * c98 + c104 * v81 - v76 * v78).abs();
    let v83 = v74 * (v54.abs() + v73) + (v82 + c114 * v43 + v77 * v73);
    let v84 = v79 * v79;
    let v85 = 1.0 - v84;
    let v86 = if v8 > 0.0 { ab } else { 0.0 };
    let v87 = if v49 > 0.0 { c49 } else { 0.0 };
    let v88 = c50 * v85 + (v86 * v36 - v87 * v40);
    let v89 = c65 - v88;
    let v90 = (2.0 * (u * c99) + v75 * -(c43 + c59 * v89)).abs();
    let v91 = v19 - v20;
    let v92 = if v49 > 0.0 { c67 } else { 0.0 };
    let v93 = if v91 > 0.0 { v92 } else { c67 };
    let v94 = if v91 > 0.0 { 0.0 } else { c67 + v87.abs() };
    let v95 = v79.abs();
    let v96 = extra[8] * v33;
    let v97 = c80 * v96;
    let v98 = v95 + functions::smaller(v95 + v97, 1.0);
    let v99 = v9 - v10;
    let v100 = if v8 > 0.0 { c66 } else { 0.0 };
    let v101 = if v99 > 0.0 { v100 } else { c66 };
    let v102 = if v99 > 0.0 { 0.0 } else { c66 + v86.abs() };
    let v103 = v55 * v93 * v25 + v94 * v41 + (v101 * v64 * v14 + v102 * v37 + c83 * v96 * v98);
    let v104 = extra[0] * (c113 + c115 * ((c105 + v88).abs() + v103));
    let v105 = 2.0 * (extra[8] * c117) + v90 + v77 * v103 + v104;
    let v106 = c123 + extra[3] * ((s_rate * c87 + s_rate2 * c88) * v3);
    let v107 = if v99 > 0.0 { 0.0 } else { f64::INFINITY };
    let v108 = if v91 > 0.0 { 0.0 } else { f64::INFINITY };
    let v109 = extra[3] * v3;
    let v110 = 2.0 * (s_rate * (extra[1] * c121)) + s_rate3 * (c88 * v109);
    let v111 = s_rate2 * (2.0 * (extra[1] * c122) + c87 * v109) + v110;
    let v112 = Kr * v50;
    let v113 = v48 * (1.0 - v48);
    let v114 = Kr * v51;
    let v115 = Kb * v45;
    let v116 = v44 * (1.0 - v44);
    let v117 = Kb * v46;
    let v118 = c74 * (v53 * (1.0 - v53)) + 2.0 * (v44 * v44 * v115 + v116 * v117);
    let v119 = 2.0 * (v48 * v48 * v112 + v113 * v114 - 0.5 * v118);
    let v120 = (v7 + v44.abs()) * v70;
    let v121 = v70 + v120;
    let v122 = (v34 * (Kb * v13).abs() + c76 * v65) * (v116.abs() + v121);
    let v123 = (v17 + v48.abs()) * v61;
    let v124 = v17 * v17 * (c77 * v38) + v112.abs() * v123 + (v117.abs() * v121 + v122);
    let v125 = v61 + v123;
    let v126 = (v38 * (Kr * v24).abs() + c78 * v56) * (v113.abs() + v125);
    let v127 = extra[0] * (c69 * ((1.0 + (v28 + v53.abs())) * v63));
    let v128 = 2.0 * (v7 * v7 * (c75 * v34) + v115.abs() * v120);
    let v129 = v114.abs() * v125 + v126 + 0.5 * (c79 * v127 + v128);
    let v130 = 2.0 * (v124 + v129);
    let v131 = (2.0 * (c104 * v78) - v76 * v119).abs() + 2.0 * (c116 * v73);
    let v132 = v74 * ((-v119).abs() + v130) + (v77 * v130 + v131);
    let v133 = v44 * v66;
    let v134 = v48 * v57;
    let v135 = 2.0 * (v87 * v134 + v86 * v133);
    let v136 = v101 * (extra[0] * (v7 * (c70 * v7) + c68 * v67 * v69));
    let v137 = v93 * (extra[0] * (v17 * (c71 * v17) + c68 * v58 * v60));
    let v138 = v94 * v134.abs() + v137 + (v102 * v133.abs() + v136);
    let v139 = 2.0 * v138;
    let v140 = (c104 * v89 + (c98 - v76 * -v135)).abs() + v77 * v139;
    let v141 = extra[9] * (v74 * (v135.abs() + v139) + v140 + c116 * v103);
    let v142 = v97 * v98;
    let v143 = c119 * (v0 * (c106 * v79).abs() + c118 * v3 * v96);
    let v144 = v75 * (c85 * v79);
    let v145 = v144.abs() * v142 + v143 * ((v84 - 1.0).abs() + v142);
    let v146 = extra[9] * ((2.0 * (v85 * v144) - c120).abs() + 2.0 * v145);
    let v147 = v108 + (c123 + v107) + extra[3] * v111 + extra[2] * v83;
    let v148 = extra[1] * (extra[1] * v132 + 2.0 * v141) + extra[10] * v105;
    let out = out.first_chunk_mut::<2>()?;
    out[0] = v106 + extra[0] * v83 + extra[8] * v105;
    out[1] = v147 + extra[9] * v146 + v148;
    Some(())
}

/// The guard and its rate: button_off in mode LO.
fn guard_button_off_lo(given: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let constants = given.constants.first_chunk::<16>()?;
    let state = given.state.first_chunk::<3>()?;
    let yb = constants[15];
    let y = state[0];
    let u = state[2];
    let out = out.first_chunk_mut::<2>()?;
    [out[0], out[1]] = [y - yb, u];
    Some(())
}

/// The guard and its rate: trip in mode LO.
fn guard_trip_lo(given: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let constants = given.constants.first_chunk::<125>()?;
    let state = given.state.first_chunk::<3>()?;
    let c124 = constants[124];
    let y = state[0];
    let u = state[2];
    let out = out.first_chunk_mut::<2>()?;
    [out[0], out[1]] = [c124 - y, -u];
    Some(())
}

/// Bounds of the guard's move and bend: trip in mode LO.
fn bound_trip_lo(given: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let constants = given.constants.first_chunk::<124>()?;
    let extra = given.extra.first_chunk::<3>()?;
    let c123 = constants[123];
    let out = out.first_chunk_mut::<2>()?;
    out[0] = extra[0] + c123;
    out[1] = c123 + extra[2];
    Some(())
}

/// Where the Taylor series begins in mode LO.
fn series_start_lo(given: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let constants = given.constants.first_chunk::<125>()?;
    let state = given.state.first_chunk::<3>()?;
    let input = given.input;
    let R = constants[0];
    let mk = constants[1];
    let mh = constants[2];
    let g = constants[3];
    let Wk = constants[4];
    let ck = constants[5];
    let Fc = constants[6];
    let ybed = constants[9];
    let ab = constants[11];
    let ar = constants[14];
    let yb = constants[15];
    let k1 = constants[35];
    let b1 = constants[36];
    let c37 = constants[37];
    let c38 = constants[38];
    let c39 = constants[39];
    let c40 = constants[40];
    let c41 = constants[41];
    let c42 = constants[42];
    let c43 = constants[43];
    let c59 = constants[59];
    let c89 = constants[89];
    let c90 = constants[90];
    let c91 = constants[91];
    let c92 = constants[92];
    let c93 = constants[93];
    let c94 = constants[94];
    let c95 = constants[95];
    let c96 = constants[96];
    let c124 = constants[124];
    let y = state[0];
    let u = state[2];
    let s = input[0];
    let s_rate = input[1];
    let v0 = y - yb;
    let v1 = 1.0 - c93 * v0;
    let v2 = u * c40;
    let v3 = math::tanh(v2);
    let v4 = c89 * v0;
    let v5 = 1.0 - v4;
    let v6 = v5 * v5;
    let v7 = c94 * (v0 * v0);
    let v8 = v7 * v6;
    let v9 = R * v1 + 16.0 * (v8 * v3);
    let v10 = u * c43;
    let v11 = mh * (g - c95 * (u * u)) + v10 * v1;
    let v12 = 1.0 + u * ab;
    let v13 = v12 - 0.0;
    let v14 = if v13 > 0.0 { v12 } else { 0.0 };
    let v15 = c37 * (y - ybed);
    let v16 = functions::logistic(v15);
    let v17 = functions::softplus(v15);
    let v18 = c38 * (v17 * v17);
    let v19 = 1.0 - u * ar;
    let v20 = v19 - 0.0;
    let v21 = if v20 > 0.0 { v19 } else { 0.0 };
    let v22 = -(y * c37);
    let v23 = functions::logistic(v22);
    let v24 = functions::softplus(v22);
    let v25 = c39 * (v24 * v24);
    let v26 = c41 * v0;
    let v27 = functions::logistic(v26);
    let v28 = Fc * v3 + c42 * functions::softplus(v26) + (v18 * v14 - v25 * v21);
    let v29 = k1 * (s - y) + b1 * (s_rate - u) - (Wk + u * ck) - v28;
    let v30 = c96 * v1;
    let v31 = mk + v30 * v9;
    let v32 = (v29 - v11 * v9) / v31;
    let v33 = c90 * v0;
    let v34 = c89 - v33;
    let v35 = u * c91;
    let v36 = c59 * v1;
    let v37 = v15.abs();
    let v38 = if v37 - 20.0 > 0.0 { 20.0 } else { 10.0 };
    let v39 = if v37 - 40.0 > 0.0 { 40.0 } else { v38 };
    let v40 = v37 - v39;
    let v41 = v40 - 0.0;
    let v42 = if v41 > 0.0 { v40 } else { 0.0 };
    let v43 = v22.abs();
    let v44 = if v43 - 20.0 > 0.0 { 20.0 } else { 10.0 };
    let v45 = if v43 - 40.0 > 0.0 { 40.0 } else { v44 };
    let v46 = v43 - v45;
    let v47 = v46 - 0.0;
    let v48 = if v47 > 0.0 { v46 } else { 0.0 };
    let v49 = v26.abs();
    let v50 = if v49 - 20.0 > 0.0 { 20.0 } else { 10.0 };
    let v51 = if v49 - 40.0 > 0.0 { 40.0 } else { v50 };
    let v52 = v49 - v51;
    let v53 = v52 - 0.0;
    let v54 = if v53 > 0.0 { v52 } else { 0.0 };
    let v55 = v2.abs();
    let v56 = v55 + v55;
    let v57 = if v56 - 20.0 > 0.0 { 20.0 } else { 10.0 };
    let v58 = if v56 - 40.0 > 0.0 { 40.0 } else { v57 };
    let v59 = v56 - v58;
    let v60 = v59 - 0.0;
    let v61 = if v60 > 0.0 { v59 } else { 0.0 };
    let out = out.first_chunk_mut::<60>()?;
    [out[0], out[1]] = [u, v32];
    out[2] = c92 + c91 * (v4 - 0.5 * (v0 * v33));
    out[3] = v35 * v34;
    out[4] = v11 + v36 * v29;
    [out[5], out[6], out[7], out[8], out[9], out[10]] = [v0, c124 - y, v13, v20, v42, v48];
    [out[11], out[12]] = [v54, v61];
    out[13] = 1.0 - v3 * v3;
    [out[14], out[15], out[16], out[17], out[18]] = [v3 + v3, v0 + v0, v5 + v5, v7, v6];
    [out[19], out[20], out[21], out[22], out[23], out[24]] = [v8, v3, u + u, v10, v1, v11];
    [out[25], out[26]] = [v9, v13];
    out[27] = v16 - v16 * v16;
    [out[28], out[29], out[30], out[31], out[32]] = [v16 + v16, v16, v17 + v17, v18, v14];
    out[33] = v20;
    out[34] = v23 - v23 * v23;
    [out[35], out[36], out[37], out[38], out[39]] = [v23 + v23, v23, v24 + v24, v25, v21];
    out[40] = v27 - v27 * v27;
    [out[41], out[42], out[43], out[44], out[45]] = [v27 + v27, v27, v30, v32, 1.0 / v31];
    [out[46], out[47], out[48], out[49], out[50], out[51]] = [v0, v33, v35, v34, v36, v29];
    out[52] = functions::sign(v15);
    out[53] = v41;
    out[54] = functions::sign(v22);
    out[55] = v47;
    out[56] = functions::sign(v26);
    out[57] = v53;
    out[58] = functions::sign(v2);
    out[59] = v60;
    Some(())
}

/// One order of the Taylor series in mode LO.
fn series_step_lo(given: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let constants = given.constants.first_chunk::<97>()?;
    let state = given.state.first_chunk::<3>()?;
    let extra = given.extra.first_chunk::<76>()?;
    let input = given.input;
    let R = constants[0];
    let mh = constants[2];
    let ck = constants[5];
    let Fc = constants[6];
    let ab = constants[11];
    let ar = constants[14];
    let k1 = constants[35];
    let b1 = constants[36];
    let c37 = constants[37];
    let c38 = constants[38];
    let c39 = constants[39];
    let c40 = constants[40];
    let c41 = constants[41];
    let c42 = constants[42];
    let c43 = constants[43];
    let c59 = constants[59];
    let c89 = constants[89];
    let c90 = constants[90];
    let c91 = constants[91];
    let c93 = constants[93];
    let c94 = constants[94];
    let c95 = constants[95];
    let c96 = constants[96];
    let y = state[0];
    let u = state[2];
    let s = input[0];
    let s_rate = input[1];
    let v0 = -(c93 * y);
    let v1 = c40 * u;
    let v2 = extra[49] * extra[1] + v1 * extra[2];
    let v3 = c89 * y;
    let v4 = -v3;
    let v5 = extra[52] + extra[5] * v4;
    let v6 = c94 * (extra[51] + extra[4] * y);
    let v7 = extra[53] + extra[6] * v5 + v6 * extra[7];
    let v8 = 16.0 * (extra[54] + extra[8] * v2 + v7 * extra[9]);
    let v9 = R * v0 + v8;
    let v10 = c43 * u;
    let v11 = extra[56] + extra[11] * v0 + v10 * extra[12];
    let v12 = mh * -(c95 * (extra[55] + extra[10] * u)) + v11;
    let v13 = ab * u;
    let v14 = if extra[15] > 0.0 { v13 } else { 0.0 };
    let v15 = c37 * y;
    let v16 = extra[58] * extra[1] + v15 * extra[16];
    let v17 = extra[60] * extra[1] + v15 * extra[18];
    let v18 = c38 * (extra[61] + extra[19] * v17);
    let v19 = -(ar * u);
    let v20 = if extra[22] > 0.0 { v19 } else { 0.0 };
    let v21 = -v15;
    let v22 = extra[63] * extra[1] + v21 * extra[23];
    let v23 = extra[65] * extra[1] + v21 * extra[25];
    let v24 = c39 * (extra[66] + extra[26] * v23);
    let v25 = extra[62] + extra[20] * v14 + v18 * extra[21];
    let v26 = v25 - (extra[67] + extra[27] * v20 + v24 * extra[28]);
    let v27 = c41 * y;
    let v28 = extra[68] * extra[1] + v27 * extra[29];
    let v29 = Fc * v2 + c42 * (extra[70] * extra[1] + v27 * extra[31]);
    let v30 = k1 * (s - y) + b1 * (s_rate - u) - ck * u - (v29 + v26);
    let v31 = v30 - (extra[57] + extra[13] * v9 + v12 * extra[14]);
    let v32 = c96 * v0;
    let v33 = extra[71] + extra[32] * v9 + v32 * extra[14];
    let v34 = (v31 - extra[72] - extra[33] * v33) * extra[34];
    let v35 = c90 * y;
    let v36 = 0.5 * (extra[73] + extra[35] * v35 + y * extra[36]);
    let v37 = -v35;
    let v38 = c91 * u;
    let v39 = c59 * v0;
    let v40 = v12 + (extra[75] + extra[39] * v30 + v39 * extra[40]);
    let v41 = if extra[42] > 0.0 { extra[41] * v15 } else { 0.0 };
    let v42 = if extra[44] > 0.0 { extra[43] * v21 } else { 0.0 };
    let v43 = if extra[46] > 0.0 { extra[45] * v27 } else { 0.0 };
    let v44 = extra[47] * v1;
    let v45 = if extra[48] > 0.0 { v44 + v44 } else { 0.0 };
    let v46 = extra[0] * v15;
    let v47 = extra[0] * v21;
    let v48 = extra[0] * v27;
    let out = out.first_chunk_mut::<67>()?;
    [out[0], out[1]] = [u, v34];
    out[2] = c91 * (v3 - v36);
    out[3] = extra[74] + extra[37] * v37 + v38 * extra[38];
    [out[4], out[5], out[6], out[7], out[8], out[9], out[10]] = [v40, y, -y, v13, v19, v41, v42];
    [out[11], out[12]] = [v43, v45];
    out[13] = extra[0] * v1;
    [out[14], out[15], out[16], out[17], out[18], out[19], out[20]] = [v2, y, v4, v6, v7, u, v10];
    [out[21], out[22], out[23], out[24], out[25], out[26]] = [v12, v46, v16, v46, v17, v18];
    [out[27], out[28], out[29], out[30], out[31], out[32]] = [v47, v22, v47, v23, v24, v48];
    [out[33], out[34], out[35], out[36], out[37], out[38]] = [v28, v48, v32, v33, y, v38];
    out[39] = v39;
    out[40] = -(extra[50] + extra[3] * v2);
    [out[41], out[42], out[43], out[44], out[45], out[46], out[47]] = [v2, y, v4, v5, v2, u, v0];
    out[48] = v9;
    out[49] = v16 - (extra[59] + extra[17] * v16);
    [out[50], out[51], out[52], out[53]] = [v16, v16, v17, v14];
    out[54] = v22 - (extra[64] + extra[24] * v22);
    [out[55], out[56], out[57], out[58]] = [v22, v22, v23, v20];
    out[59] = v28 - (extra[69] + extra[30] * v28);
    [out[60], out[61], out[62], out[63], out[64], out[65]] = [v28, v28, v9, v34, v35, v37];
    out[66] = v30;
    Some(())
}

/// The derivative of the state in mode FLA.
fn derivative_fla(given: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let constants = given.constants.first_chunk::<127>()?;
    let state = given.state.first_chunk::<4>()?;
    let input = given.input;
    let g = constants[3];
    let Wk = constants[4];
    let ck = constants[5];
    let Fc = constants[6];
    let ybed = constants[9];
    let ab = constants[11];
    let ar = constants[14];
    let yb = constants[15];
    let k1 = constants[35];
    let b1 = constants[36];
    let c37 = constants[37];
    let c38 = constants[38];
    let c39 = constants[39];
    let c40 = constants[40];
    let c41 = constants[41];
    let c42 = constants[42];
    let c125 = constants[125];
    let c126 = constants[126];
    let y = state[0];
    let u = state[2];
    let w = state[3];
    let s = input[0];
    let s_rate = input[1];
    let v0 = functions::softplus(c37 * (y - ybed));
    let v1 = c38 * (v0 * v0) * functions::larger(1.0 + u * ab, 0.0);
    let v2 = functions::softplus(-(y * c37));
    let v3 = c39 * (v2 * v2) * functions::larger(1.0 - u * ar, 0.0);
    let v4 = k1 * (s - y) + b1 * (s_rate - u) - (Wk + u * ck) - Fc * math::tanh(u * c40);
    let v5 = v4 - c42 * functions::softplus(c41 * (y - yb)) - v1;
    let out = out.first_chunk_mut::<4>()?;
    [out[0], out[1]] = [u, w];
    out[2] = c125 * (v3 + v5);
    out[3] = -(g + w * c126);
    Some(())
}

/// The derivative of a part in mode FLA.
fn part_0_fla(given: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let constants = given.constants.first_chunk::<126>()?;
    let state = given.state.first_chunk::<3>()?;
    let input = given.input;
    let Wk = constants[4];
    let ck = constants[5];
    let Fc = constants[6];
    let ybed = constants[9];
    let ab = constants[11];
    let ar = constants[14];
    let yb = constants[15];
    let k1 = constants[35];
    let b1 = constants[36];
    let c37 = constants[37];
    let c38 = constants[38];
    let c39 = constants[39];
    let c40 = constants[40];
    let c41 = constants[41];
    let c42 = constants[42];
    let c125 = constants[125];
    let y = state[0];
    let u = state[2];
    let s = input[0];
    let s_rate = input[1];
    let v0 = functions::softplus(c37 * (y - ybed));
    let v1 = c38 * (v0 * v0) * functions::larger(1.0 + u * ab, 0.0);
    let v2 = functions::softplus(-(y * c37));
    let v3 = c39 * (v2 * v2) * functions::larger(1.0 - u * ar, 0.0);
    let v4 = k1 * (s - y) + b1 * (s_rate - u) - (Wk + u * ck) - Fc * math::tanh(u * c40);
    let v5 = v4 - c42 * functions::softplus(c41 * (y - yb)) - v1;
    let out = out.first_chunk_mut::<4>()?;
    [out[0], out[1]] = [u, 0.0];
    out[2] = c125 * (v3 + v5);
    out[3] = 0.0;
    Some(())
}

/// The derivative of a part in mode FLA.
fn part_1_fla(given: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let constants = given.constants.first_chunk::<127>()?;
    let state = given.state.first_chunk::<4>()?;
    let g = constants[3];
    let c126 = constants[126];
    let w = state[3];
    let out = out.first_chunk_mut::<4>()?;
    [out[0], out[1], out[2]] = [0.0, w, 0.0];
    out[3] = -(g + w * c126);
    Some(())
}

/// Is not used by the table.
fn function_32(given: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let constants = given.constants.first_chunk::<9>()?;
    let ch = constants[8];
    let out = out.first_chunk_mut::<1>()?;
    out[0] = ch * ch;
    Some(())
}

/// The derivative's derivative by the state in mode FLA.
fn jacobian_fla(given: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let constants = given.constants.first_chunk::<128>()?;
    let state = given.state.first_chunk::<3>()?;
    let ybed = constants[9];
    let ab = constants[11];
    let ar = constants[14];
    let yb = constants[15];
    let kj = constants[19];
    let k1 = constants[35];
    let c37 = constants[37];
    let c38 = constants[38];
    let c39 = constants[39];
    let c40 = constants[40];
    let c41 = constants[41];
    let c47 = constants[47];
    let c48 = constants[48];
    let c49 = constants[49];
    let c50 = constants[50];
    let c65 = constants[65];
    let c125 = constants[125];
    let c127 = constants[127];
    let y = state[0];
    let u = state[2];
    let v0 = 1.0 + u * ab;
    let v1 = c37 * (y - ybed);
    let v2 = functions::softplus(v1);
    let v3 = functions::logistic(v1) * (c47 * v2) * functions::larger(v0, 0.0);
    let v4 = 1.0 - u * ar;
    let v5 = -(y * c37);
    let v6 = functions::softplus(v5);
    let v7 = functions::logistic(v5) * (c48 * v6) * functions::larger(v4, 0.0);
    let v8 = k1 + kj * functions::logistic(c41 * (y - yb)) + 2.0 * (v3 + v7);
    let v9 = if v0 > 0.0 { ab } else { 0.0 };
    let v10 = if v4 > 0.0 { c49 } else { 0.0 };
    let v11 = math::tanh(u * c40);
    let v12 = c65 + c39 * v10 * (v6 * v6) - (c38 * v9 * (v2 * v2) + c50 * (1.0 - v11 * v11));
    let out = out.first_chunk_mut::<16>()?;
    [out[0], out[1], out[2], out[3], out[4], out[5], out[6]] = [0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0];
    [out[7], out[8], out[9], out[10], out[11]] = [1.0, c125 * -v8, 0.0, c125 * v12, 0.0];
    [out[12], out[13], out[14], out[15]] = [0.0, 0.0, 0.0, c127];
    Some(())
}

/// The outputs in mode FLA.
fn outputs_fla(given: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let constants = given.constants.first_chunk::<37>()?;
    let state = given.state.first_chunk::<3>()?;
    let input = given.input;
    let k1 = constants[35];
    let b1 = constants[36];
    let y = state[0];
    let u = state[2];
    let s = input[0];
    let s_rate = input[1];
    let out = out.first_chunk_mut::<4>()?;
    out[0] = k1 * (s - y) + b1 * (s_rate - u);
    [out[1], out[2], out[3]] = [0.0, 0.0, 0.0];
    Some(())
}

/// Energy, supplied and dissipated power in mode FLA.
fn balance_fla(given: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let constants = given.constants.first_chunk::<56>()?;
    let state = given.state.first_chunk::<4>()?;
    let input = given.input;
    let mk = constants[1];
    let mh = constants[2];
    let Wk = constants[4];
    let ck = constants[5];
    let Fc = constants[6];
    let ch = constants[8];
    let ybed = constants[9];
    let ab = constants[11];
    let ar = constants[14];
    let yb = constants[15];
    let k1 = constants[35];
    let b1 = constants[36];
    let c37 = constants[37];
    let c38 = constants[38];
    let c39 = constants[39];
    let c40 = constants[40];
    let c41 = constants[41];
    let c44 = constants[44];
    let c53 = constants[53];
    let c54 = constants[54];
    let c55 = constants[55];
    let y = state[0];
    let z = state[1];
    let u = state[2];
    let w = state[3];
    let s = input[0];
    let s_rate = input[1];
    let v0 = s - y;
    let v1 = k1 * v0;
    let v2 = c37 * (y - ybed);
    let v3 = -(y * c37);
    let v4 = y * Wk + z * c44 + 0.5 * (v0 * v1 + (mk * (u * u) + mh * (w * w)));
    let v5 = c53 * functions::softplus_area(c41 * (y - yb));
    let v6 = v4 + c55 * functions::softplus_square_area(v3);
    let v7 = v6 + (v5 + c54 * functions::softplus_square_area(v2));
    let v8 = s_rate - u;
    let v9 = b1 * v8;
    let v10 = functions::softplus(v2);
    let v11 = c38 * (functions::larger(1.0 + u * ab, 0.0) - 1.0);
    let v12 = functions::softplus(v3);
    let v13 = c39 * (functions::larger(1.0 - u * ar, 0.0) - 1.0);
    let v14 = u * ck + Fc * math::tanh(u * c40) + v10 * v10 * v11;
    let v15 = w * (w * ch) + v8 * v9 + u * (v14 - v12 * v12 * v13);
    let out = out.first_chunk_mut::<3>()?;
    out[0] = v7;
    out[1] = s_rate * (v1 + v9);
    out[2] = v15;
    Some(())
}

/// The state after guard land in mode FLA.
fn reset_0_land_fla(given: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let constants = given.constants.first_chunk::<97>()?;
    let state = given.state.first_chunk::<4>()?;
    let R = constants[0];
    let mk = constants[1];
    let c45 = constants[45];
    let c46 = constants[46];
    let c96 = constants[96];
    let y = state[0];
    let u = state[2];
    let w = state[3];
    let v0 = u * mk + w * c96;
    let out = out.first_chunk_mut::<5>()?;
    [out[0], out[1], out[2], out[3], out[4]] = [y, y * R, c45 * v0, c46 * v0, 0.0];
    Some(())
}

/// The guard and its rate: land in mode FLA.
fn guard_land_fla(given: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let constants = given.constants.first_chunk::<1>()?;
    let state = given.state.first_chunk::<4>()?;
    let R = constants[0];
    let y = state[0];
    let z = state[1];
    let u = state[2];
    let w = state[3];
    let out = out.first_chunk_mut::<2>()?;
    [out[0], out[1]] = [z - y * R, w - R * u];
    Some(())
}

/// Bounds of the guard's move and bend: land in mode FLA.
fn bound_land_fla(given: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let constants = given.constants.first_chunk::<129>()?;
    let extra = given.extra.first_chunk::<7>()?;
    let c128 = constants[128];
    let out = out.first_chunk_mut::<2>()?;
    out[0] = extra[4] + extra[0] * c128;
    out[1] = extra[6] + c128 * extra[2];
    Some(())
}

/// The state after guard string_on in mode FLA.
fn reset_0_string_on_fla(given: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let constants = given.constants.first_chunk::<22>()?;
    let state = given.state.first_chunk::<4>()?;
    let zs = constants[21];
    let y = state[0];
    let u = state[2];
    let w = state[3];
    let out = out.first_chunk_mut::<5>()?;
    [out[0], out[1], out[2], out[3], out[4]] = [y, zs, u, w, 0.0];
    Some(())
}

/// The speed of what strikes at guard string_on in mode FLA.
fn speed_string_on_fla(given: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let state = given.state.first_chunk::<4>()?;
    let w = state[3];
    let out = out.first_chunk_mut::<1>()?;
    out[0] = w.abs();
    Some(())
}

/// The guard and its rate: string_on in mode FLA.
fn guard_string_on_fla(given: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let constants = given.constants.first_chunk::<22>()?;
    let state = given.state.first_chunk::<4>()?;
    let zs = constants[21];
    let z = state[1];
    let w = state[3];
    let out = out.first_chunk_mut::<2>()?;
    [out[0], out[1]] = [zs - z, -w];
    Some(())
}

/// Bounds of the guard's move and bend: string_on in mode FLA.
fn bound_string_on_fla(given: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let extra = given.extra.first_chunk::<7>()?;
    let out = out.first_chunk_mut::<2>()?;
    [out[0], out[1]] = [extra[4], extra[6]];
    Some(())
}

/// Where the Taylor series begins in mode FLA.
fn series_start_fla(given: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let constants = given.constants.first_chunk::<127>()?;
    let state = given.state.first_chunk::<4>()?;
    let input = given.input;
    let R = constants[0];
    let g = constants[3];
    let Wk = constants[4];
    let ck = constants[5];
    let Fc = constants[6];
    let ybed = constants[9];
    let ab = constants[11];
    let ar = constants[14];
    let yb = constants[15];
    let zs = constants[21];
    let k1 = constants[35];
    let b1 = constants[36];
    let c37 = constants[37];
    let c38 = constants[38];
    let c39 = constants[39];
    let c40 = constants[40];
    let c41 = constants[41];
    let c42 = constants[42];
    let c125 = constants[125];
    let c126 = constants[126];
    let y = state[0];
    let z = state[1];
    let u = state[2];
    let w = state[3];
    let s = input[0];
    let s_rate = input[1];
    let v0 = 1.0 + u * ab;
    let v1 = v0 - 0.0;
    let v2 = if v1 > 0.0 { v0 } else { 0.0 };
    let v3 = c37 * (y - ybed);
    let v4 = functions::logistic(v3);
    let v5 = functions::softplus(v3);
    let v6 = c38 * (v5 * v5);
    let v7 = 1.0 - u * ar;
    let v8 = v7 - 0.0;
    let v9 = if v8 > 0.0 { v7 } else { 0.0 };
    let v10 = -(y * c37);
    let v11 = functions::logistic(v10);
    let v12 = functions::softplus(v10);
    let v13 = c39 * (v12 * v12);
    let v14 = u * c40;
    let v15 = math::tanh(v14);
    let v16 = y - yb;
    let v17 = c41 * v16;
    let v18 = functions::logistic(v17);
    let v19 = k1 * (s - y) + b1 * (s_rate - u) - (Wk + u * ck) - Fc * v15;
    let v20 = v13 * v9 + (v19 - c42 * functions::softplus(v17) - v6 * v2);
    let v21 = v3.abs();
    let v22 = if v21 - 20.0 > 0.0 { 20.0 } else { 10.0 };
    let v23 = if v21 - 40.0 > 0.0 { 40.0 } else { v22 };
    let v24 = v21 - v23;
    let v25 = v24 - 0.0;
    let v26 = if v25 > 0.0 { v24 } else { 0.0 };
    let v27 = v10.abs();
    let v28 = if v27 - 20.0 > 0.0 { 20.0 } else { 10.0 };
    let v29 = if v27 - 40.0 > 0.0 { 40.0 } else { v28 };
    let v30 = v27 - v29;
    let v31 = v30 - 0.0;
    let v32 = if v31 > 0.0 { v30 } else { 0.0 };
    let v33 = v17.abs();
    let v34 = if v33 - 20.0 > 0.0 { 20.0 } else { 10.0 };
    let v35 = if v33 - 40.0 > 0.0 { 40.0 } else { v34 };
    let v36 = v33 - v35;
    let v37 = v36 - 0.0;
    let v38 = if v37 > 0.0 { v36 } else { 0.0 };
    let v39 = v14.abs();
    let v40 = v39 + v39;
    let v41 = if v40 - 20.0 > 0.0 { 20.0 } else { 10.0 };
    let v42 = if v40 - 40.0 > 0.0 { 40.0 } else { v41 };
    let v43 = v40 - v42;
    let v44 = v43 - 0.0;
    let v45 = if v44 > 0.0 { v43 } else { 0.0 };
    let out = out.first_chunk_mut::<40>()?;
    [out[0], out[1], out[2]] = [u, w, c125 * v20];
    out[3] = -(g + w * c126);
    [out[4], out[5], out[6], out[7], out[8], out[9]] = [z - y * R, -v16, zs - z, v1, v8, v26];
    [out[10], out[11], out[12], out[13], out[14]] = [v32, v38, v45, v1, v4 - v4 * v4];
    [out[15], out[16], out[17], out[18], out[19], out[20]] = [v4 + v4, v4, v5 + v5, v6, v2, v8];
    out[21] = v11 - v11 * v11;
    [out[22], out[23], out[24], out[25], out[26]] = [v11 + v11, v11, v12 + v12, v13, v9];
    out[27] = 1.0 - v15 * v15;
    out[28] = v15 + v15;
    out[29] = v18 - v18 * v18;
    [out[30], out[31]] = [v18 + v18, v18];
    out[32] = functions::sign(v3);
    out[33] = v25;
    out[34] = functions::sign(v10);
    out[35] = v31;
    out[36] = functions::sign(v17);
    out[37] = v37;
    out[38] = functions::sign(v14);
    out[39] = v44;
    Some(())
}

/// One order of the Taylor series in mode FLA.
fn series_step_fla(given: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let constants = given.constants.first_chunk::<127>()?;
    let state = given.state.first_chunk::<4>()?;
    let extra = given.extra.first_chunk::<44>()?;
    let input = given.input;
    let R = constants[0];
    let ck = constants[5];
    let Fc = constants[6];
    let ab = constants[11];
    let ar = constants[14];
    let k1 = constants[35];
    let b1 = constants[36];
    let c37 = constants[37];
    let c38 = constants[38];
    let c39 = constants[39];
    let c40 = constants[40];
    let c41 = constants[41];
    let c42 = constants[42];
    let c125 = constants[125];
    let c126 = constants[126];
    let y = state[0];
    let z = state[1];
    let u = state[2];
    let w = state[3];
    let s = input[0];
    let s_rate = input[1];
    let v0 = ab * u;
    let v1 = if extra[2] > 0.0 { v0 } else { 0.0 };
    let v2 = c37 * y;
    let v3 = extra[29] * extra[1] + v2 * extra[3];
    let v4 = extra[31] * extra[1] + v2 * extra[5];
    let v5 = c38 * (extra[32] + extra[6] * v4);
    let v6 = -(ar * u);
    let v7 = if extra[9] > 0.0 { v6 } else { 0.0 };
    let v8 = -v2;
    let v9 = extra[34] * extra[1] + v8 * extra[10];
    let v10 = extra[36] * extra[1] + v8 * extra[12];
    let v11 = c39 * (extra[37] + extra[13] * v10);
    let v12 = c40 * u;
    let v13 = extra[39] * extra[1] + v12 * extra[16];
    let v14 = c41 * y;
    let v15 = extra[41] * extra[1] + v14 * extra[18];
    let v16 = k1 * (s - y) + b1 * (s_rate - u) - ck * u - Fc * v13;
    let v17 = v16 - c42 * (extra[43] * extra[1] + v14 * extra[20]);
    let v18 = v17 - (extra[33] + extra[7] * v1 + v5 * extra[8]);
    let v19 = extra[38] + extra[14] * v7 + v11 * extra[15] + v18;
    let v20 = if extra[22] > 0.0 { extra[21] * v2 } else { 0.0 };
    let v21 = if extra[24] > 0.0 { extra[23] * v8 } else { 0.0 };
    let v22 = if extra[26] > 0.0 { extra[25] * v14 } else { 0.0 };
    let v23 = extra[27] * v12;
    let v24 = if extra[28] > 0.0 { v23 + v23 } else { 0.0 };
    let v25 = extra[0] * v2;
    let v26 = extra[0] * v8;
    let v27 = extra[0] * v14;
    let out = out.first_chunk_mut::<43>()?;
    [out[0], out[1], out[2], out[3], out[4]] = [u, w, c125 * v19, -(c126 * w), z - R * y];
    [out[5], out[6], out[7], out[8], out[9], out[10], out[11]] = [-y, -z, v0, v6, v20, v21, v22];
    [out[12], out[13], out[14], out[15], out[16], out[17]] = [v24, v25, v3, v25, v4, v5];
    [out[18], out[19], out[20], out[21], out[22]] = [v26, v9, v26, v10, v11];
    out[23] = extra[0] * v12;
    [out[24], out[25], out[26], out[27]] = [v13, v27, v15, v27];
    out[28] = v3 - (extra[30] + extra[4] * v3);
    [out[29], out[30], out[31], out[32]] = [v3, v3, v4, v1];
    out[33] = v9 - (extra[35] + extra[11] * v9);
    [out[34], out[35], out[36], out[37]] = [v9, v9, v10, v7];
    out[38] = -(extra[40] + extra[17] * v13);
    out[39] = v13;
    out[40] = v15 - (extra[42] + extra[19] * v15);
    [out[41], out[42]] = [v15, v15];
    Some(())
}

/// The state after guard land in mode FLL.
fn reset_0_land_fll(given: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let constants = given.constants.first_chunk::<97>()?;
    let state = given.state.first_chunk::<4>()?;
    let mk = constants[1];
    let yb = constants[15];
    let c56 = constants[56];
    let c89 = constants[89];
    let c90 = constants[90];
    let c91 = constants[91];
    let c92 = constants[92];
    let c93 = constants[93];
    let c96 = constants[96];
    let y = state[0];
    let u = state[2];
    let w = state[3];
    let v0 = y - yb;
    let v1 = c90 * v0;
    let v2 = 1.0 - c93 * v0;
    let v3 = (u * mk + w * c96 * v2) * (1.0 / (mk + c56 * (v2 * v2)));
    let out = out.first_chunk_mut::<5>()?;
    out[0] = y;
    out[1] = c92 + c91 * (v0 * (c89 - 0.5 * v1));
    out[2] = v3;
    out[3] = c91 * (c89 - v1) * v3;
    out[4] = 0.0;
    Some(())
}

/// The guard and its rate: land in mode FLL.
fn guard_land_fll(given: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let constants = given.constants.first_chunk::<93>()?;
    let state = given.state.first_chunk::<4>()?;
    let yb = constants[15];
    let c89 = constants[89];
    let c90 = constants[90];
    let c91 = constants[91];
    let c92 = constants[92];
    let y = state[0];
    let z = state[1];
    let u = state[2];
    let w = state[3];
    let v0 = y - yb;
    let v1 = c90 * v0;
    let out = out.first_chunk_mut::<2>()?;
    out[0] = z - c92 - c91 * (v0 * (c89 - 0.5 * v1));
    out[1] = w - c91 * (u * (c89 - v1));
    Some(())
}

/// Bounds of the guard's move and bend: land in mode FLL.
fn bound_land_fll(given: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let constants = given.constants.first_chunk::<131>()?;
    let state = given.state.first_chunk::<1>()?;
    let extra = given.extra.first_chunk::<7>()?;
    let yb = constants[15];
    let c89 = constants[89];
    let c90 = constants[90];
    let c91 = constants[91];
    let c123 = constants[123];
    let c129 = constants[129];
    let c130 = constants[130];
    let y = state[0];
    let v0 = extra[0] * c129 + (c91 * (c89 - c90 * (y - yb))).abs();
    let v1 = c123 + extra[6] + c130 * (extra[1] * extra[1]) + extra[2] * v0;
    let out = out.first_chunk_mut::<2>()?;
    out[0] = extra[4] + c123 + extra[0] * v0;
    out[1] = v1;
    Some(())
}

/// Where the Taylor series begins in mode FLL.
fn series_start_fll(given: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let constants = given.constants.first_chunk::<127>()?;
    let state = given.state.first_chunk::<4>()?;
    let input = given.input;
    let g = constants[3];
    let Wk = constants[4];
    let ck = constants[5];
    let Fc = constants[6];
    let ybed = constants[9];
    let ab = constants[11];
    let ar = constants[14];
    let yb = constants[15];
    let zs = constants[21];
    let k1 = constants[35];
    let b1 = constants[36];
    let c37 = constants[37];
    let c38 = constants[38];
    let c39 = constants[39];
    let c40 = constants[40];
    let c41 = constants[41];
    let c42 = constants[42];
    let c89 = constants[89];
    let c90 = constants[90];
    let c91 = constants[91];
    let c92 = constants[92];
    let c124 = constants[124];
    let c125 = constants[125];
    let c126 = constants[126];
    let y = state[0];
    let z = state[1];
    let u = state[2];
    let w = state[3];
    let s = input[0];
    let s_rate = input[1];
    let v0 = 1.0 + u * ab;
    let v1 = v0 - 0.0;
    let v2 = if v1 > 0.0 { v0 } else { 0.0 };
    let v3 = c37 * (y - ybed);
    let v4 = functions::logistic(v3);
    let v5 = functions::softplus(v3);
    let v6 = c38 * (v5 * v5);
    let v7 = 1.0 - u * ar;
    let v8 = v7 - 0.0;
    let v9 = if v8 > 0.0 { v7 } else { 0.0 };
    let v10 = -(y * c37);
    let v11 = functions::logistic(v10);
    let v12 = functions::softplus(v10);
    let v13 = c39 * (v12 * v12);
    let v14 = u * c40;
    let v15 = math::tanh(v14);
    let v16 = y - yb;
    let v17 = c41 * v16;
    let v18 = functions::logistic(v17);
    let v19 = k1 * (s - y) + b1 * (s_rate - u) - (Wk + u * ck) - Fc * v15;
    let v20 = v13 * v9 + (v19 - c42 * functions::softplus(v17) - v6 * v2);
    let v21 = c89 - 0.5 * (c90 * v16);
    let v22 = v3.abs();
    let v23 = if v22 - 20.0 > 0.0 { 20.0 } else { 10.0 };
    let v24 = if v22 - 40.0 > 0.0 { 40.0 } else { v23 };
    let v25 = v22 - v24;
    let v26 = v25 - 0.0;
    let v27 = if v26 > 0.0 { v25 } else { 0.0 };
    let v28 = v10.abs();
    let v29 = if v28 - 20.0 > 0.0 { 20.0 } else { 10.0 };
    let v30 = if v28 - 40.0 > 0.0 { 40.0 } else { v29 };
    let v31 = v28 - v30;
    let v32 = v31 - 0.0;
    let v33 = if v32 > 0.0 { v31 } else { 0.0 };
    let v34 = v17.abs();
    let v35 = if v34 - 20.0 > 0.0 { 20.0 } else { 10.0 };
    let v36 = if v34 - 40.0 > 0.0 { 40.0 } else { v35 };
    let v37 = v34 - v36;
    let v38 = v37 - 0.0;
    let v39 = if v38 > 0.0 { v37 } else { 0.0 };
    let v40 = v14.abs();
    let v41 = v40 + v40;
    let v42 = if v41 - 20.0 > 0.0 { 20.0 } else { 10.0 };
    let v43 = if v41 - 40.0 > 0.0 { 40.0 } else { v42 };
    let v44 = v41 - v43;
    let v45 = v44 - 0.0;
    let v46 = if v45 > 0.0 { v44 } else { 0.0 };
    let out = out.first_chunk_mut::<43>()?;
    [out[0], out[1], out[2]] = [u, w, c125 * v20];
    out[3] = -(g + w * c126);
    out[4] = z - c92 - c91 * (v16 * v21);
    [out[5], out[6], out[7], out[8], out[9], out[10]] = [v16, c124 - y, zs - z, v1, v8, v27];
    [out[11], out[12], out[13], out[14], out[15]] = [v33, v39, v46, v1, v4 - v4 * v4];
    [out[16], out[17], out[18], out[19], out[20], out[21]] = [v4 + v4, v4, v5 + v5, v6, v2, v8];
    out[22] = v11 - v11 * v11;
    [out[23], out[24], out[25], out[26], out[27]] = [v11 + v11, v11, v12 + v12, v13, v9];
    out[28] = 1.0 - v15 * v15;
    out[29] = v15 + v15;
    out[30] = v18 - v18 * v18;
    [out[31], out[32], out[33], out[34]] = [v18 + v18, v18, v16, v21];
    out[35] = functions::sign(v3);
    out[36] = v26;
    out[37] = functions::sign(v10);
    out[38] = v32;
    out[39] = functions::sign(v17);
    out[40] = v38;
    out[41] = functions::sign(v14);
    out[42] = v45;
    Some(())
}

/// One order of the Taylor series in mode FLL.
fn series_step_fll(given: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let constants = given.constants.first_chunk::<127>()?;
    let state = given.state.first_chunk::<4>()?;
    let extra = given.extra.first_chunk::<47>()?;
    let input = given.input;
    let ck = constants[5];
    let Fc = constants[6];
    let ab = constants[11];
    let ar = constants[14];
    let k1 = constants[35];
    let b1 = constants[36];
    let c37 = constants[37];
    let c38 = constants[38];
    let c39 = constants[39];
    let c40 = constants[40];
    let c41 = constants[41];
    let c42 = constants[42];
    let c90 = constants[90];
    let c91 = constants[91];
    let c125 = constants[125];
    let c126 = constants[126];
    let y = state[0];
    let z = state[1];
    let u = state[2];
    let w = state[3];
    let s = input[0];
    let s_rate = input[1];
    let v0 = ab * u;
    let v1 = if extra[2] > 0.0 { v0 } else { 0.0 };
    let v2 = c37 * y;
    let v3 = extra[31] * extra[1] + v2 * extra[3];
    let v4 = extra[33] * extra[1] + v2 * extra[5];
    let v5 = c38 * (extra[34] + extra[6] * v4);
    let v6 = -(ar * u);
    let v7 = if extra[9] > 0.0 { v6 } else { 0.0 };
    let v8 = -v2;
    let v9 = extra[36] * extra[1] + v8 * extra[10];
    let v10 = extra[38] * extra[1] + v8 * extra[12];
    let v11 = c39 * (extra[39] + extra[13] * v10);
    let v12 = c40 * u;
    let v13 = extra[41] * extra[1] + v12 * extra[16];
    let v14 = c41 * y;
    let v15 = extra[43] * extra[1] + v14 * extra[18];
    let v16 = k1 * (s - y) + b1 * (s_rate - u) - ck * u - Fc * v13;
    let v17 = v16 - c42 * (extra[45] * extra[1] + v14 * extra[20]);
    let v18 = v17 - (extra[35] + extra[7] * v1 + v5 * extra[8]);
    let v19 = extra[40] + extra[14] * v7 + v11 * extra[15] + v18;
    let v20 = -(0.5 * (c90 * y));
    let v21 = c91 * (extra[46] + extra[21] * v20 + y * extra[22]);
    let v22 = if extra[24] > 0.0 { extra[23] * v2 } else { 0.0 };
    let v23 = if extra[26] > 0.0 { extra[25] * v8 } else { 0.0 };
    let v24 = if extra[28] > 0.0 { extra[27] * v14 } else { 0.0 };
    let v25 = extra[29] * v12;
    let v26 = if extra[30] > 0.0 { v25 + v25 } else { 0.0 };
    let v27 = extra[0] * v2;
    let v28 = extra[0] * v8;
    let v29 = extra[0] * v14;
    let out = out.first_chunk_mut::<46>()?;
    [out[0], out[1], out[2], out[3], out[4], out[5]] = [u, w, c125 * v19, -(c126 * w), z - v21, y];
    [out[6], out[7], out[8], out[9], out[10], out[11], out[12]] = [-y, -z, v0, v6, v22, v23, v24];
    [out[13], out[14], out[15], out[16], out[17], out[18]] = [v26, v27, v3, v27, v4, v5];
    [out[19], out[20], out[21], out[22], out[23]] = [v28, v9, v28, v10, v11];
    out[24] = extra[0] * v12;
    [out[25], out[26], out[27], out[28], out[29]] = [v13, v29, v15, v29, y];
    out[30] = v3 - (extra[32] + extra[4] * v3);
    [out[31], out[32], out[33], out[34]] = [v3, v3, v4, v1];
    out[35] = v9 - (extra[37] + extra[11] * v9);
    [out[36], out[37], out[38], out[39]] = [v9, v9, v10, v7];
    out[40] = -(extra[42] + extra[17] * v13);
    out[41] = v13;
    out[42] = v15 - (extra[44] + extra[19] * v15);
    [out[43], out[44], out[45]] = [v15, v15, v20];
    Some(())
}

/// Is positive where a way is taken from guard rep_on in mode FLT.
fn when_0_rep_on_flt(given: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let constants = given.constants.first_chunk::<33>()?;
    let state = given.state.first_chunk::<1>()?;
    let yck = constants[32];
    let y = state[0];
    let out = out.first_chunk_mut::<1>()?;
    out[0] = y - yck;
    Some(())
}

/// The guard and its rate: rep_on in mode FLT.
fn guard_rep_on_flt(given: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let constants = given.constants.first_chunk::<132>()?;
    let state = given.state.first_chunk::<4>()?;
    let R = constants[0];
    let o_r = constants[27];
    let yd = constants[28];
    let wd = constants[29];
    let c131 = constants[131];
    let y = state[0];
    let z = state[1];
    let u = state[2];
    let w = state[3];
    let v0 = c131 * (y - yd);
    let out = out.first_chunk_mut::<2>()?;
    out[0] = z - o_r - R * (y - wd * functions::softplus(v0));
    out[1] = w - R * (u * (1.0 - functions::logistic(v0)));
    Some(())
}

/// Bounds of the guard's move and bend: rep_on in mode FLT.
fn bound_rep_on_flt(given: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let constants = given.constants.first_chunk::<134>()?;
    let state = given.state.first_chunk::<1>()?;
    let extra = given.extra.first_chunk::<7>()?;
    let R = constants[0];
    let yd = constants[28];
    let c131 = constants[131];
    let c132 = constants[132];
    let c133 = constants[133];
    let y = state[0];
    let v0 = extra[0] * c132;
    let v1 = c131 * (y - yd);
    let v2 = functions::logistic(functions::larger(v1.abs() - v0, 0.0));
    let v3 = v2 * (1.0 - v2);
    let v4 = functions::logistic(v1);
    let v5 = 1.0 - v4;
    let v6 = (R * v5).abs() + extra[0] * c133 * v3;
    let v7 = (1.0 + (functions::logistic(v0 + v1) + v4.abs())) * v3;
    let v8 = c133 * (extra[1] * extra[1]) * ((v4 * v5).abs() + extra[0] * (c132 * v7));
    let out = out.first_chunk_mut::<2>()?;
    out[0] = extra[4] + extra[0] * v6;
    out[1] = extra[6] + extra[2] * v6 + v8;
    Some(())
}

/// Is positive where a way is taken from guard reset in mode FLT.
fn when_0_reset_flt(given: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let constants = given.constants.first_chunk::<1>()?;
    let state = given.state.first_chunk::<2>()?;
    let R = constants[0];
    let y = state[0];
    let z = state[1];
    let out = out.first_chunk_mut::<1>()?;
    out[0] = z - y * R;
    Some(())
}

/// The guard and its rate: reset in mode FLT.
fn guard_reset_flt(given: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let constants = given.constants.first_chunk::<35>()?;
    let state = given.state.first_chunk::<3>()?;
    let yrs = constants[34];
    let y = state[0];
    let u = state[2];
    let out = out.first_chunk_mut::<2>()?;
    [out[0], out[1]] = [y - yrs, u];
    Some(())
}

/// Where the Taylor series begins in mode FLT.
fn series_start_flt(given: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let constants = given.constants.first_chunk::<132>()?;
    let state = given.state.first_chunk::<4>()?;
    let input = given.input;
    let R = constants[0];
    let g = constants[3];
    let Wk = constants[4];
    let ck = constants[5];
    let Fc = constants[6];
    let ybed = constants[9];
    let ab = constants[11];
    let ar = constants[14];
    let yb = constants[15];
    let zs = constants[21];
    let o_r = constants[27];
    let yd = constants[28];
    let wd = constants[29];
    let yrs = constants[34];
    let k1 = constants[35];
    let b1 = constants[36];
    let c37 = constants[37];
    let c38 = constants[38];
    let c39 = constants[39];
    let c40 = constants[40];
    let c41 = constants[41];
    let c42 = constants[42];
    let c125 = constants[125];
    let c126 = constants[126];
    let c131 = constants[131];
    let y = state[0];
    let z = state[1];
    let u = state[2];
    let w = state[3];
    let s = input[0];
    let s_rate = input[1];
    let v0 = 1.0 + u * ab;
    let v1 = v0 - 0.0;
    let v2 = if v1 > 0.0 { v0 } else { 0.0 };
    let v3 = c37 * (y - ybed);
    let v4 = functions::logistic(v3);
    let v5 = functions::softplus(v3);
    let v6 = c38 * (v5 * v5);
    let v7 = 1.0 - u * ar;
    let v8 = v7 - 0.0;
    let v9 = if v8 > 0.0 { v7 } else { 0.0 };
    let v10 = -(y * c37);
    let v11 = functions::logistic(v10);
    let v12 = functions::softplus(v10);
    let v13 = c39 * (v12 * v12);
    let v14 = u * c40;
    let v15 = math::tanh(v14);
    let v16 = c41 * (y - yb);
    let v17 = functions::logistic(v16);
    let v18 = k1 * (s - y) + b1 * (s_rate - u) - (Wk + u * ck) - Fc * v15;
    let v19 = v13 * v9 + (v18 - c42 * functions::softplus(v16) - v6 * v2);
    let v20 = c131 * (y - yd);
    let v21 = functions::logistic(v20);
    let v22 = z - o_r - R * (y - wd * functions::softplus(v20));
    let v23 = v3.abs();
    let v24 = if v23 - 20.0 > 0.0 { 20.0 } else { 10.0 };
    let v25 = if v23 - 40.0 > 0.0 { 40.0 } else { v24 };
    let v26 = v23 - v25;
    let v27 = v26 - 0.0;
    let v28 = if v27 > 0.0 { v26 } else { 0.0 };
    let v29 = v10.abs();
    let v30 = if v29 - 20.0 > 0.0 { 20.0 } else { 10.0 };
    let v31 = if v29 - 40.0 > 0.0 { 40.0 } else { v30 };
    let v32 = v29 - v31;
    let v33 = v32 - 0.0;
    let v34 = if v33 > 0.0 { v32 } else { 0.0 };
    let v35 = v16.abs();
    let v36 = if v35 - 20.0 > 0.0 { 20.0 } else { 10.0 };
    let v37 = if v35 - 40.0 > 0.0 { 40.0 } else { v36 };
    let v38 = v35 - v37;
    let v39 = v38 - 0.0;
    let v40 = if v39 > 0.0 { v38 } else { 0.0 };
    let v41 = v20.abs();
    let v42 = if v41 - 20.0 > 0.0 { 20.0 } else { 10.0 };
    let v43 = if v41 - 40.0 > 0.0 { 40.0 } else { v42 };
    let v44 = v41 - v43;
    let v45 = v44 - 0.0;
    let v46 = if v45 > 0.0 { v44 } else { 0.0 };
    let v47 = v14.abs();
    let v48 = v47 + v47;
    let v49 = if v48 - 20.0 > 0.0 { 20.0 } else { 10.0 };
    let v50 = if v48 - 40.0 > 0.0 { 40.0 } else { v49 };
    let v51 = v48 - v50;
    let v52 = v51 - 0.0;
    let v53 = if v52 > 0.0 { v51 } else { 0.0 };
    let out = out.first_chunk_mut::<46>()?;
    [out[0], out[1], out[2]] = [u, w, c125 * v19];
    out[3] = -(g + w * c126);
    [out[4], out[5], out[6], out[7], out[8], out[9]] = [zs - z, v22, y - yrs, v1, v8, v28];
    [out[10], out[11], out[12], out[13], out[14], out[15]] = [v34, v40, v46, v53, v1, v4 - v4 * v4];
    [out[16], out[17], out[18], out[19], out[20], out[21]] = [v4 + v4, v4, v5 + v5, v6, v2, v8];
    out[22] = v11 - v11 * v11;
    [out[23], out[24], out[25], out[26], out[27]] = [v11 + v11, v11, v12 + v12, v13, v9];
    out[28] = 1.0 - v15 * v15;
    out[29] = v15 + v15;
    out[30] = v17 - v17 * v17;
    [out[31], out[32]] = [v17 + v17, v17];
    out[33] = v21 - v21 * v21;
    [out[34], out[35]] = [v21 + v21, v21];
    out[36] = functions::sign(v3);
    out[37] = v27;
    out[38] = functions::sign(v10);
    out[39] = v33;
    out[40] = functions::sign(v16);
    out[41] = v39;
    out[42] = functions::sign(v20);
    out[43] = v45;
    out[44] = functions::sign(v14);
    out[45] = v52;
    Some(())
}

/// One order of the Taylor series in mode FLT.
fn series_step_flt(given: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let constants = given.constants.first_chunk::<132>()?;
    let state = given.state.first_chunk::<4>()?;
    let extra = given.extra.first_chunk::<52>()?;
    let input = given.input;
    let R = constants[0];
    let ck = constants[5];
    let Fc = constants[6];
    let ab = constants[11];
    let ar = constants[14];
    let wd = constants[29];
    let k1 = constants[35];
    let b1 = constants[36];
    let c37 = constants[37];
    let c38 = constants[38];
    let c39 = constants[39];
    let c40 = constants[40];
    let c41 = constants[41];
    let c42 = constants[42];
    let c125 = constants[125];
    let c126 = constants[126];
    let c131 = constants[131];
    let y = state[0];
    let z = state[1];
    let u = state[2];
    let w = state[3];
    let s = input[0];
    let s_rate = input[1];
    let v0 = ab * u;
    let v1 = if extra[2] > 0.0 { v0 } else { 0.0 };
    let v2 = c37 * y;
    let v3 = extra[34] * extra[1] + v2 * extra[3];
    let v4 = extra[36] * extra[1] + v2 * extra[5];
    let v5 = c38 * (extra[37] + extra[6] * v4);
    let v6 = -(ar * u);
    let v7 = if extra[9] > 0.0 { v6 } else { 0.0 };
    let v8 = -v2;
    let v9 = extra[39] * extra[1] + v8 * extra[10];
    let v10 = extra[41] * extra[1] + v8 * extra[12];
    let v11 = c39 * (extra[42] + extra[13] * v10);
    let v12 = c40 * u;
    let v13 = extra[44] * extra[1] + v12 * extra[16];
    let v14 = c41 * y;
    let v15 = extra[46] * extra[1] + v14 * extra[18];
    let v16 = k1 * (s - y) + b1 * (s_rate - u) - ck * u - Fc * v13;
    let v17 = v16 - c42 * (extra[48] * extra[1] + v14 * extra[20]);
    let v18 = v17 - (extra[38] + extra[7] * v1 + v5 * extra[8]);
    let v19 = extra[43] + extra[14] * v7 + v11 * extra[15] + v18;
    let v20 = c131 * y;
    let v21 = extra[49] * extra[1] + v20 * extra[21];
    let v22 = y - wd * (extra[51] * extra[1] + v20 * extra[23]);
    let v23 = if extra[25] > 0.0 { extra[24] * v2 } else { 0.0 };
    let v24 = if extra[27] > 0.0 { extra[26] * v8 } else { 0.0 };
    let v25 = if extra[29] > 0.0 { extra[28] * v14 } else { 0.0 };
    let v26 = if extra[31] > 0.0 { extra[30] * v20 } else { 0.0 };
    let v27 = extra[32] * v12;
    let v28 = if extra[33] > 0.0 { v27 + v27 } else { 0.0 };
    let v29 = extra[0] * v2;
    let v30 = extra[0] * v8;
    let v31 = extra[0] * v14;
    let v32 = extra[0] * v20;
    let out = out.first_chunk_mut::<50>()?;
    [out[0], out[1], out[2], out[3], out[4]] = [u, w, c125 * v19, -(c126 * w), -z];
    [out[5], out[6], out[7], out[8], out[9], out[10]] = [z - R * v22, y, v0, v6, v23, v24];
    [out[11], out[12], out[13], out[14], out[15], out[16]] = [v25, v26, v28, v29, v3, v29];
    [out[17], out[18], out[19], out[20], out[21], out[22]] = [v4, v5, v30, v9, v30, v10];
    out[23] = v11;
    out[24] = extra[0] * v12;
    [out[25], out[26], out[27], out[28], out[29], out[30]] = [v13, v31, v15, v31, v32, v21];
    out[31] = v32;
    out[32] = v3 - (extra[35] + extra[4] * v3);
    [out[33], out[34], out[35], out[36]] = [v3, v3, v4, v1];
    out[37] = v9 - (extra[40] + extra[11] * v9);
    [out[38], out[39], out[40], out[41]] = [v9, v9, v10, v7];
    out[42] = -(extra[45] + extra[17] * v13);
    out[43] = v13;
    out[44] = v15 - (extra[47] + extra[19] * v15);
    [out[45], out[46]] = [v15, v15];
    out[47] = v21 - (extra[50] + extra[22] * v21);
    [out[48], out[49]] = [v21, v21];
    Some(())
}

/// The derivative of the state in mode STU.
fn derivative_stu(given: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let constants = given.constants.first_chunk::<135>()?;
    let state = given.state.first_chunk::<4>()?;
    let input = given.input;
    let g = constants[3];
    let Wk = constants[4];
    let ck = constants[5];
    let Fc = constants[6];
    let ybed = constants[9];
    let ab = constants[11];
    let ar = constants[14];
    let yb = constants[15];
    let zs = constants[21];
    let ps = constants[23];
    let mus = constants[24];
    let k1 = constants[35];
    let b1 = constants[36];
    let c37 = constants[37];
    let c38 = constants[38];
    let c39 = constants[39];
    let c40 = constants[40];
    let c41 = constants[41];
    let c42 = constants[42];
    let c125 = constants[125];
    let c126 = constants[126];
    let c134 = constants[134];
    let y = state[0];
    let z = state[1];
    let u = state[2];
    let w = state[3];
    let s = input[0];
    let s_rate = input[1];
    let v0 = functions::softplus(c37 * (y - ybed));
    let v1 = c38 * (v0 * v0) * functions::larger(1.0 + u * ab, 0.0);
    let v2 = functions::softplus(-(y * c37));
    let v3 = c39 * (v2 * v2) * functions::larger(1.0 - u * ar, 0.0);
    let v4 = k1 * (s - y) + b1 * (s_rate - u) - (Wk + u * ck) - Fc * math::tanh(u * c40);
    let v5 = v4 - c42 * functions::softplus(c41 * (y - yb)) - v1;
    let v6 = math::powf(functions::larger(z - zs, 0.0), ps);
    let v7 = c134 * functions::larger(1.0 + w * mus, 0.0) * v6;
    let out = out.first_chunk_mut::<4>()?;
    [out[0], out[1]] = [u, w];
    out[2] = c125 * (v3 + v5);
    out[3] = -(g + w * c126 + v7);
    Some(())
}

/// The derivative of a part in mode STU.
fn part_1_stu(given: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let constants = given.constants.first_chunk::<135>()?;
    let state = given.state.first_chunk::<4>()?;
    let g = constants[3];
    let zs = constants[21];
    let ps = constants[23];
    let mus = constants[24];
    let c126 = constants[126];
    let c134 = constants[134];
    let z = state[1];
    let w = state[3];
    let v0 = math::powf(functions::larger(z - zs, 0.0), ps);
    let v1 = c134 * functions::larger(1.0 + w * mus, 0.0) * v0;
    let out = out.first_chunk_mut::<4>()?;
    [out[0], out[1], out[2]] = [0.0, w, 0.0];
    out[3] = -(g + w * c126 + v1);
    Some(())
}

/// Is not used by the table.
fn function_59(given: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let constants = given.constants.first_chunk::<25>()?;
    let ch = constants[8];
    let Ks = constants[22];
    let mus = constants[24];
    let out = out.first_chunk_mut::<1>()?;
    out[0] = ch * ch + Ks * Ks * (mus * mus);
    Some(())
}

/// The derivative's derivative by the state in mode STU.
fn jacobian_stu(given: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let constants = given.constants.first_chunk::<137>()?;
    let state = given.state.first_chunk::<4>()?;
    let ybed = constants[9];
    let ab = constants[11];
    let ar = constants[14];
    let yb = constants[15];
    let kj = constants[19];
    let zs = constants[21];
    let ps = constants[23];
    let mus = constants[24];
    let k1 = constants[35];
    let c37 = constants[37];
    let c38 = constants[38];
    let c39 = constants[39];
    let c40 = constants[40];
    let c41 = constants[41];
    let c47 = constants[47];
    let c48 = constants[48];
    let c49 = constants[49];
    let c50 = constants[50];
    let c65 = constants[65];
    let c125 = constants[125];
    let c126 = constants[126];
    let c134 = constants[134];
    let c135 = constants[135];
    let c136 = constants[136];
    let y = state[0];
    let z = state[1];
    let u = state[2];
    let w = state[3];
    let v0 = 1.0 + u * ab;
    let v1 = c37 * (y - ybed);
    let v2 = functions::softplus(v1);
    let v3 = functions::logistic(v1) * (c47 * v2) * functions::larger(v0, 0.0);
    let v4 = 1.0 - u * ar;
    let v5 = -(y * c37);
    let v6 = functions::softplus(v5);
    let v7 = functions::logistic(v5) * (c48 * v6) * functions::larger(v4, 0.0);
    let v8 = k1 + kj * functions::logistic(c41 * (y - yb)) + 2.0 * (v3 + v7);
    let v9 = if v0 > 0.0 { ab } else { 0.0 };
    let v10 = if v4 > 0.0 { c49 } else { 0.0 };
    let v11 = math::tanh(u * c40);
    let v12 = c65 + c39 * v10 * (v6 * v6) - (c38 * v9 * (v2 * v2) + c50 * (1.0 - v11 * v11));
    let v13 = 1.0 + w * mus;
    let v14 = z - zs;
    let v15 = if v14 > 0.0 { 1.0 } else { 0.0 };
    let v16 = functions::larger(v14, 0.0);
    let v17 = c136 * v15 * functions::larger(v13, 0.0) * math::powf(v16, c135);
    let v18 = if v13 > 0.0 { mus } else { 0.0 };
    let out = out.first_chunk_mut::<16>()?;
    [out[0], out[1], out[2], out[3], out[4], out[5], out[6]] = [0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0];
    [out[7], out[8], out[9], out[10], out[11]] = [1.0, c125 * -v8, 0.0, c125 * v12, 0.0];
    [out[12], out[13], out[14]] = [0.0, -v17, 0.0];
    out[15] = -(c126 + c134 * v18 * math::powf(v16, ps));
    Some(())
}

/// The outputs in mode STU.
fn outputs_stu(given: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let constants = given.constants.first_chunk::<37>()?;
    let state = given.state.first_chunk::<4>()?;
    let input = given.input;
    let zs = constants[21];
    let Ks = constants[22];
    let ps = constants[23];
    let mus = constants[24];
    let k1 = constants[35];
    let b1 = constants[36];
    let y = state[0];
    let z = state[1];
    let u = state[2];
    let w = state[3];
    let s = input[0];
    let s_rate = input[1];
    let v0 = math::powf(functions::larger(z - zs, 0.0), ps);
    let out = out.first_chunk_mut::<4>()?;
    out[0] = k1 * (s - y) + b1 * (s_rate - u);
    [out[1], out[2]] = [0.0, 0.0];
    out[3] = Ks * functions::larger(1.0 + w * mus, 0.0) * v0;
    Some(())
}

/// Energy, supplied and dissipated power in mode STU.
fn balance_stu(given: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let constants = given.constants.first_chunk::<138>()?;
    let state = given.state.first_chunk::<4>()?;
    let input = given.input;
    let mk = constants[1];
    let mh = constants[2];
    let Wk = constants[4];
    let ck = constants[5];
    let Fc = constants[6];
    let ch = constants[8];
    let ybed = constants[9];
    let ab = constants[11];
    let ar = constants[14];
    let yb = constants[15];
    let zs = constants[21];
    let Ks = constants[22];
    let ps = constants[23];
    let mus = constants[24];
    let k1 = constants[35];
    let b1 = constants[36];
    let c37 = constants[37];
    let c38 = constants[38];
    let c39 = constants[39];
    let c40 = constants[40];
    let c41 = constants[41];
    let c44 = constants[44];
    let c53 = constants[53];
    let c54 = constants[54];
    let c55 = constants[55];
    let c137 = constants[137];
    let y = state[0];
    let z = state[1];
    let u = state[2];
    let w = state[3];
    let s = input[0];
    let s_rate = input[1];
    let v0 = s - y;
    let v1 = k1 * v0;
    let v2 = c37 * (y - ybed);
    let v3 = -(y * c37);
    let v4 = z - zs;
    let v5 = math::powf(functions::larger(v4, 0.0), ps);
    let v6 = y * Wk + z * c44 + 0.5 * (v0 * v1 + (mk * (u * u) + mh * (w * w)));
    let v7 = c53 * functions::softplus_area(c41 * (y - yb));
    let v8 = v6 + c55 * functions::softplus_square_area(v3);
    let v9 = v8 + (v7 + c54 * functions::softplus_square_area(v2));
    let v10 = s_rate - u;
    let v11 = b1 * v10;
    let v12 = functions::softplus(v2);
    let v13 = c38 * (functions::larger(1.0 + u * ab, 0.0) - 1.0);
    let v14 = functions::softplus(v3);
    let v15 = c39 * (functions::larger(1.0 - u * ar, 0.0) - 1.0);
    let v16 = u * ck + Fc * math::tanh(u * c40) + v12 * v12 * v13;
    let v17 = (functions::larger(1.0 + w * mus, 0.0) - 1.0) * v5;
    let v18 = v10 * v11 + u * (v16 - v14 * v14 * v15) + w * (w * ch + Ks * v17);
    let out = out.first_chunk_mut::<3>()?;
    out[0] = v9 + c137 * v4 * v5;
    out[1] = s_rate * (v1 + v11);
    out[2] = v18;
    Some(())
}

/// Is positive where a way is taken from guard string_off in mode STU.
fn when_0_string_off_stu(given: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let constants = given.constants.first_chunk::<16>()?;
    let state = given.state.first_chunk::<1>()?;
    let yb = constants[15];
    let y = state[0];
    let out = out.first_chunk_mut::<1>()?;
    out[0] = yb - y;
    Some(())
}

/// The guard and its rate: string_off in mode STU.
fn guard_string_off_stu(given: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let constants = given.constants.first_chunk::<22>()?;
    let state = given.state.first_chunk::<4>()?;
    let zs = constants[21];
    let z = state[1];
    let w = state[3];
    let out = out.first_chunk_mut::<2>()?;
    [out[0], out[1]] = [z - zs, w];
    Some(())
}

/// Where the Taylor series begins in mode STU.
fn series_start_stu(given: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let constants = given.constants.first_chunk::<135>()?;
    let state = given.state.first_chunk::<4>()?;
    let input = given.input;
    let g = constants[3];
    let Wk = constants[4];
    let ck = constants[5];
    let Fc = constants[6];
    let ybed = constants[9];
    let ab = constants[11];
    let ar = constants[14];
    let yb = constants[15];
    let zs = constants[21];
    let ps = constants[23];
    let mus = constants[24];
    let k1 = constants[35];
    let b1 = constants[36];
    let c37 = constants[37];
    let c38 = constants[38];
    let c39 = constants[39];
    let c40 = constants[40];
    let c41 = constants[41];
    let c42 = constants[42];
    let c124 = constants[124];
    let c125 = constants[125];
    let c126 = constants[126];
    let c134 = constants[134];
    let y = state[0];
    let z = state[1];
    let u = state[2];
    let w = state[3];
    let s = input[0];
    let s_rate = input[1];
    let v0 = 1.0 + u * ab;
    let v1 = v0 - 0.0;
    let v2 = if v1 > 0.0 { v0 } else { 0.0 };
    let v3 = c37 * (y - ybed);
    let v4 = functions::logistic(v3);
    let v5 = functions::softplus(v3);
    let v6 = c38 * (v5 * v5);
    let v7 = 1.0 - u * ar;
    let v8 = v7 - 0.0;
    let v9 = if v8 > 0.0 { v7 } else { 0.0 };
    let v10 = -(y * c37);
    let v11 = functions::logistic(v10);
    let v12 = functions::softplus(v10);
    let v13 = c39 * (v12 * v12);
    let v14 = u * c40;
    let v15 = math::tanh(v14);
    let v16 = c41 * (y - yb);
    let v17 = functions::logistic(v16);
    let v18 = k1 * (s - y) + b1 * (s_rate - u) - (Wk + u * ck) - Fc * v15;
    let v19 = v13 * v9 + (v18 - c42 * functions::softplus(v16) - v6 * v2);
    let v20 = z - zs;
    let v21 = v20 - 0.0;
    let v22 = if v21 > 0.0 { v20 } else { 0.0 };
    let v23 = math::powf(v22, ps);
    let v24 = 1.0 + w * mus;
    let v25 = v24 - 0.0;
    let v26 = if v25 > 0.0 { v24 } else { 0.0 };
    let v27 = c134 * v26;
    let v28 = v3.abs();
    let v29 = if v28 - 20.0 > 0.0 { 20.0 } else { 10.0 };
    let v30 = if v28 - 40.0 > 0.0 { 40.0 } else { v29 };
    let v31 = v28 - v30;
    let v32 = v31 - 0.0;
    let v33 = if v32 > 0.0 { v31 } else { 0.0 };
    let v34 = v10.abs();
    let v35 = if v34 - 20.0 > 0.0 { 20.0 } else { 10.0 };
    let v36 = if v34 - 40.0 > 0.0 { 40.0 } else { v35 };
    let v37 = v34 - v36;
    let v38 = v37 - 0.0;
    let v39 = if v38 > 0.0 { v37 } else { 0.0 };
    let v40 = v16.abs();
    let v41 = if v40 - 20.0 > 0.0 { 20.0 } else { 10.0 };
    let v42 = if v40 - 40.0 > 0.0 { 40.0 } else { v41 };
    let v43 = v40 - v42;
    let v44 = v43 - 0.0;
    let v45 = if v44 > 0.0 { v43 } else { 0.0 };
    let v46 = v14.abs();
    let v47 = v46 + v46;
    let v48 = if v47 - 20.0 > 0.0 { 20.0 } else { 10.0 };
    let v49 = if v47 - 40.0 > 0.0 { 40.0 } else { v48 };
    let v50 = v47 - v49;
    let v51 = v50 - 0.0;
    let v52 = if v51 > 0.0 { v50 } else { 0.0 };
    let out = out.first_chunk_mut::<47>()?;
    [out[0], out[1], out[2]] = [u, w, c125 * v19];
    out[3] = -(g + w * c126 + v27 * v23);
    [out[4], out[5], out[6], out[7], out[8], out[9]] = [v20, c124 - y, v1, v8, v21, v25];
    [out[10], out[11], out[12], out[13], out[14], out[15]] = [v33, v39, v45, v52, v1, v4 - v4 * v4];
    [out[16], out[17], out[18], out[19], out[20], out[21]] = [v4 + v4, v4, v5 + v5, v6, v2, v8];
    out[22] = v11 - v11 * v11;
    [out[23], out[24], out[25], out[26], out[27]] = [v11 + v11, v11, v12 + v12, v13, v9];
    out[28] = 1.0 - v15 * v15;
    out[29] = v15 + v15;
    out[30] = v17 - v17 * v17;
    [out[31], out[32], out[33], out[34], out[35]] = [v17 + v17, v17, v21, v23, 1.0 / v22];
    [out[36], out[37], out[38]] = [v22, v25, v27];
    out[39] = functions::sign(v3);
    out[40] = v32;
    out[41] = functions::sign(v10);
    out[42] = v38;
    out[43] = functions::sign(v16);
    out[44] = v44;
    out[45] = functions::sign(v14);
    out[46] = v51;
    Some(())
}

/// One order of the Taylor series in mode STU.
fn series_step_stu(given: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let constants = given.constants.first_chunk::<135>()?;
    let state = given.state.first_chunk::<4>()?;
    let extra = given.extra.first_chunk::<53>()?;
    let input = given.input;
    let ck = constants[5];
    let Fc = constants[6];
    let ab = constants[11];
    let ar = constants[14];
    let ps = constants[23];
    let mus = constants[24];
    let k1 = constants[35];
    let b1 = constants[36];
    let c37 = constants[37];
    let c38 = constants[38];
    let c39 = constants[39];
    let c40 = constants[40];
    let c41 = constants[41];
    let c42 = constants[42];
    let c125 = constants[125];
    let c126 = constants[126];
    let c134 = constants[134];
    let y = state[0];
    let z = state[1];
    let u = state[2];
    let w = state[3];
    let s = input[0];
    let s_rate = input[1];
    let v0 = ab * u;
    let v1 = if extra[2] > 0.0 { v0 } else { 0.0 };
    let v2 = c37 * y;
    let v3 = extra[35] * extra[1] + v2 * extra[3];
    let v4 = extra[37] * extra[1] + v2 * extra[5];
    let v5 = c38 * (extra[38] + extra[6] * v4);
    let v6 = -(ar * u);
    let v7 = if extra[9] > 0.0 { v6 } else { 0.0 };
    let v8 = -v2;
    let v9 = extra[40] * extra[1] + v8 * extra[10];
    let v10 = extra[42] * extra[1] + v8 * extra[12];
    let v11 = c39 * (extra[43] + extra[13] * v10);
    let v12 = c40 * u;
    let v13 = extra[45] * extra[1] + v12 * extra[16];
    let v14 = c41 * y;
    let v15 = extra[47] * extra[1] + v14 * extra[18];
    let v16 = k1 * (s - y) + b1 * (s_rate - u) - ck * u - Fc * v13;
    let v17 = v16 - c42 * (extra[49] * extra[1] + v14 * extra[20]);
    let v18 = v17 - (extra[39] + extra[7] * v1 + v5 * extra[8]);
    let v19 = extra[44] + extra[14] * v7 + v11 * extra[15] + v18;
    let v20 = if extra[21] > 0.0 { z } else { 0.0 };
    let v21 = (ps + 1.0) * (extra[51] * extra[1]) - extra[50] + ps * extra[22] * v20;
    let v22 = extra[24] * extra[24] + v20 * v20;
    let v23 = if v22 > 0.0 { v21 * extra[23] } else { 0.0 };
    let v24 = mus * w;
    let v25 = if extra[25] > 0.0 { v24 } else { 0.0 };
    let v26 = c134 * v25;
    let v27 = c126 * w + (extra[52] + extra[26] * v23 + v26 * extra[22]);
    let v28 = if extra[28] > 0.0 { extra[27] * v2 } else { 0.0 };
    let v29 = if extra[30] > 0.0 { extra[29] * v8 } else { 0.0 };
    let v30 = if extra[32] > 0.0 { extra[31] * v14 } else { 0.0 };
    let v31 = extra[33] * v12;
    let v32 = if extra[34] > 0.0 { v31 + v31 } else { 0.0 };
    let v33 = extra[0] * v2;
    let v34 = extra[0] * v8;
    let v35 = extra[0] * v14;
    let out = out.first_chunk_mut::<50>()?;
    [out[0], out[1], out[2], out[3], out[4], out[5], out[6]] = [u, w, c125 * v19, -v27, z, -y, v0];
    [out[7], out[8], out[9], out[10], out[11], out[12], out[13]] = [v6, z, v24, v28, v29, v30, v32];
    [out[14], out[15], out[16], out[17], out[18], out[19]] = [v33, v3, v33, v4, v5, v34];
    [out[20], out[21], out[22], out[23]] = [v9, v34, v10, v11];
    out[24] = extra[0] * v12;
    [out[25], out[26], out[27], out[28], out[29]] = [v13, v35, v15, v35, v20];
    out[30] = extra[0] * v20;
    out[31] = v26;
    out[32] = v3 - (extra[36] + extra[4] * v3);
    [out[33], out[34], out[35], out[36]] = [v3, v3, v4, v1];
    out[37] = v9 - (extra[41] + extra[11] * v9);
    [out[38], out[39], out[40], out[41]] = [v9, v9, v10, v7];
    out[42] = -(extra[46] + extra[17] * v13);
    out[43] = v13;
    out[44] = v15 - (extra[48] + extra[19] * v15);
    [out[45], out[46], out[47], out[48], out[49]] = [v15, v15, v23, v23, v23];
    Some(())
}

/// Where the Taylor series begins in mode STT.
fn series_start_stt(given: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let constants = given.constants.first_chunk::<135>()?;
    let state = given.state.first_chunk::<4>()?;
    let input = given.input;
    let g = constants[3];
    let Wk = constants[4];
    let ck = constants[5];
    let Fc = constants[6];
    let ybed = constants[9];
    let ab = constants[11];
    let ar = constants[14];
    let yb = constants[15];
    let zs = constants[21];
    let ps = constants[23];
    let mus = constants[24];
    let yrs = constants[34];
    let k1 = constants[35];
    let b1 = constants[36];
    let c37 = constants[37];
    let c38 = constants[38];
    let c39 = constants[39];
    let c40 = constants[40];
    let c41 = constants[41];
    let c42 = constants[42];
    let c125 = constants[125];
    let c126 = constants[126];
    let c134 = constants[134];
    let y = state[0];
    let z = state[1];
    let u = state[2];
    let w = state[3];
    let s = input[0];
    let s_rate = input[1];
    let v0 = 1.0 + u * ab;
    let v1 = v0 - 0.0;
    let v2 = if v1 > 0.0 { v0 } else { 0.0 };
    let v3 = c37 * (y - ybed);
    let v4 = functions::logistic(v3);
    let v5 = functions::softplus(v3);
    let v6 = c38 * (v5 * v5);
    let v7 = 1.0 - u * ar;
    let v8 = v7 - 0.0;
    let v9 = if v8 > 0.0 { v7 } else { 0.0 };
    let v10 = -(y * c37);
    let v11 = functions::logistic(v10);
    let v12 = functions::softplus(v10);
    let v13 = c39 * (v12 * v12);
    let v14 = u * c40;
    let v15 = math::tanh(v14);
    let v16 = c41 * (y - yb);
    let v17 = functions::logistic(v16);
    let v18 = k1 * (s - y) + b1 * (s_rate - u) - (Wk + u * ck) - Fc * v15;
    let v19 = v13 * v9 + (v18 - c42 * functions::softplus(v16) - v6 * v2);
    let v20 = z - zs;
    let v21 = v20 - 0.0;
    let v22 = if v21 > 0.0 { v20 } else { 0.0 };
    let v23 = math::powf(v22, ps);
    let v24 = 1.0 + w * mus;
    let v25 = v24 - 0.0;
    let v26 = if v25 > 0.0 { v24 } else { 0.0 };
    let v27 = c134 * v26;
    let v28 = v3.abs();
    let v29 = if v28 - 20.0 > 0.0 { 20.0 } else { 10.0 };
    let v30 = if v28 - 40.0 > 0.0 { 40.0 } else { v29 };
    let v31 = v28 - v30;
    let v32 = v31 - 0.0;
    let v33 = if v32 > 0.0 { v31 } else { 0.0 };
    let v34 = v10.abs();
    let v35 = if v34 - 20.0 > 0.0 { 20.0 } else { 10.0 };
    let v36 = if v34 - 40.0 > 0.0 { 40.0 } else { v35 };
    let v37 = v34 - v36;
    let v38 = v37 - 0.0;
    let v39 = if v38 > 0.0 { v37 } else { 0.0 };
    let v40 = v16.abs();
    let v41 = if v40 - 20.0 > 0.0 { 20.0 } else { 10.0 };
    let v42 = if v40 - 40.0 > 0.0 { 40.0 } else { v41 };
    let v43 = v40 - v42;
    let v44 = v43 - 0.0;
    let v45 = if v44 > 0.0 { v43 } else { 0.0 };
    let v46 = v14.abs();
    let v47 = v46 + v46;
    let v48 = if v47 - 20.0 > 0.0 { 20.0 } else { 10.0 };
    let v49 = if v47 - 40.0 > 0.0 { 40.0 } else { v48 };
    let v50 = v47 - v49;
    let v51 = v50 - 0.0;
    let v52 = if v51 > 0.0 { v50 } else { 0.0 };
    let out = out.first_chunk_mut::<47>()?;
    [out[0], out[1], out[2]] = [u, w, c125 * v19];
    out[3] = -(g + w * c126 + v27 * v23);
    [out[4], out[5], out[6], out[7], out[8], out[9]] = [v20, y - yrs, v1, v8, v21, v25];
    [out[10], out[11], out[12], out[13], out[14], out[15]] = [v33, v39, v45, v52, v1, v4 - v4 * v4];
    [out[16], out[17], out[18], out[19], out[20], out[21]] = [v4 + v4, v4, v5 + v5, v6, v2, v8];
    out[22] = v11 - v11 * v11;
    [out[23], out[24], out[25], out[26], out[27]] = [v11 + v11, v11, v12 + v12, v13, v9];
    out[28] = 1.0 - v15 * v15;
    out[29] = v15 + v15;
    out[30] = v17 - v17 * v17;
    [out[31], out[32], out[33], out[34], out[35]] = [v17 + v17, v17, v21, v23, 1.0 / v22];
    [out[36], out[37], out[38]] = [v22, v25, v27];
    out[39] = functions::sign(v3);
    out[40] = v32;
    out[41] = functions::sign(v10);
    out[42] = v38;
    out[43] = functions::sign(v16);
    out[44] = v44;
    out[45] = functions::sign(v14);
    out[46] = v51;
    Some(())
}

/// One order of the Taylor series in mode STT.
fn series_step_stt(given: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let constants = given.constants.first_chunk::<135>()?;
    let state = given.state.first_chunk::<4>()?;
    let extra = given.extra.first_chunk::<53>()?;
    let input = given.input;
    let ck = constants[5];
    let Fc = constants[6];
    let ab = constants[11];
    let ar = constants[14];
    let ps = constants[23];
    let mus = constants[24];
    let k1 = constants[35];
    let b1 = constants[36];
    let c37 = constants[37];
    let c38 = constants[38];
    let c39 = constants[39];
    let c40 = constants[40];
    let c41 = constants[41];
    let c42 = constants[42];
    let c125 = constants[125];
    let c126 = constants[126];
    let c134 = constants[134];
    let y = state[0];
    let z = state[1];
    let u = state[2];
    let w = state[3];
    let s = input[0];
    let s_rate = input[1];
    let v0 = ab * u;
    let v1 = if extra[2] > 0.0 { v0 } else { 0.0 };
    let v2 = c37 * y;
    let v3 = extra[35] * extra[1] + v2 * extra[3];
    let v4 = extra[37] * extra[1] + v2 * extra[5];
    let v5 = c38 * (extra[38] + extra[6] * v4);
    let v6 = -(ar * u);
    let v7 = if extra[9] > 0.0 { v6 } else { 0.0 };
    let v8 = -v2;
    let v9 = extra[40] * extra[1] + v8 * extra[10];
    let v10 = extra[42] * extra[1] + v8 * extra[12];
    let v11 = c39 * (extra[43] + extra[13] * v10);
    let v12 = c40 * u;
    let v13 = extra[45] * extra[1] + v12 * extra[16];
    let v14 = c41 * y;
    let v15 = extra[47] * extra[1] + v14 * extra[18];
    let v16 = k1 * (s - y) + b1 * (s_rate - u) - ck * u - Fc * v13;
    let v17 = v16 - c42 * (extra[49] * extra[1] + v14 * extra[20]);
    let v18 = v17 - (extra[39] + extra[7] * v1 + v5 * extra[8]);
    let v19 = extra[44] + extra[14] * v7 + v11 * extra[15] + v18;
    let v20 = if extra[21] > 0.0 { z } else { 0.0 };
    let v21 = (ps + 1.0) * (extra[51] * extra[1]) - extra[50] + ps * extra[22] * v20;
    let v22 = extra[24] * extra[24] + v20 * v20;
    let v23 = if v22 > 0.0 { v21 * extra[23] } else { 0.0 };
    let v24 = mus * w;
    let v25 = if extra[25] > 0.0 { v24 } else { 0.0 };
    let v26 = c134 * v25;
    let v27 = c126 * w + (extra[52] + extra[26] * v23 + v26 * extra[22]);
    let v28 = if extra[28] > 0.0 { extra[27] * v2 } else { 0.0 };
    let v29 = if extra[30] > 0.0 { extra[29] * v8 } else { 0.0 };
    let v30 = if extra[32] > 0.0 { extra[31] * v14 } else { 0.0 };
    let v31 = extra[33] * v12;
    let v32 = if extra[34] > 0.0 { v31 + v31 } else { 0.0 };
    let v33 = extra[0] * v2;
    let v34 = extra[0] * v8;
    let v35 = extra[0] * v14;
    let out = out.first_chunk_mut::<50>()?;
    [out[0], out[1], out[2], out[3], out[4], out[5], out[6]] = [u, w, c125 * v19, -v27, z, y, v0];
    [out[7], out[8], out[9], out[10], out[11], out[12], out[13]] = [v6, z, v24, v28, v29, v30, v32];
    [out[14], out[15], out[16], out[17], out[18], out[19]] = [v33, v3, v33, v4, v5, v34];
    [out[20], out[21], out[22], out[23]] = [v9, v34, v10, v11];
    out[24] = extra[0] * v12;
    [out[25], out[26], out[27], out[28], out[29]] = [v13, v35, v15, v35, v20];
    out[30] = extra[0] * v20;
    out[31] = v26;
    out[32] = v3 - (extra[36] + extra[4] * v3);
    [out[33], out[34], out[35], out[36]] = [v3, v3, v4, v1];
    out[37] = v9 - (extra[41] + extra[11] * v9);
    [out[38], out[39], out[40], out[41]] = [v9, v9, v10, v7];
    out[42] = -(extra[46] + extra[17] * v13);
    out[43] = v13;
    out[44] = v15 - (extra[48] + extra[19] * v15);
    [out[45], out[46], out[47], out[48], out[49]] = [v15, v15, v23, v23, v23];
    Some(())
}

/// The derivative of the state in mode REPH.
fn derivative_reph(given: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let constants = given.constants.first_chunk::<140>()?;
    let state = given.state.first_chunk::<4>()?;
    let input = given.input;
    let R = constants[0];
    let g = constants[3];
    let Wk = constants[4];
    let ck = constants[5];
    let Fc = constants[6];
    let ybed = constants[9];
    let ab = constants[11];
    let ar = constants[14];
    let yb = constants[15];
    let cr = constants[26];
    let o_r = constants[27];
    let yd = constants[28];
    let wd = constants[29];
    let k1 = constants[35];
    let b1 = constants[36];
    let c37 = constants[37];
    let c38 = constants[38];
    let c39 = constants[39];
    let c40 = constants[40];
    let c41 = constants[41];
    let c42 = constants[42];
    let c125 = constants[125];
    let c126 = constants[126];
    let c131 = constants[131];
    let c138 = constants[138];
    let c139 = constants[139];
    let y = state[0];
    let z = state[1];
    let u = state[2];
    let w = state[3];
    let s = input[0];
    let s_rate = input[1];
    let v0 = functions::softplus(c37 * (y - ybed));
    let v1 = c38 * (v0 * v0) * functions::larger(1.0 + u * ab, 0.0);
    let v2 = functions::softplus(-(y * c37));
    let v3 = c39 * (v2 * v2) * functions::larger(1.0 - u * ar, 0.0);
    let v4 = k1 * (s - y) + b1 * (s_rate - u) - (Wk + u * ck) - Fc * math::tanh(u * c40);
    let v5 = v4 - c42 * functions::softplus(c41 * (y - yb)) - v1;
    let v6 = c131 * (y - yd);
    let v7 = 1.0 - functions::logistic(v6);
    let v8 = o_r - z + R * (y - wd * functions::softplus(v6));
    let v9 = v8 * functions::softplus(cr * (u * R * v7 - w));
    let v10 = c125 * (v3 + v5) - core::f64::consts::LOG2_E * (c138 * v7 * v9);
    let v11 = core::f64::consts::LOG2_E * (c139 * v9) - (g + w * c126);
    let out = out.first_chunk_mut::<4>()?;
    [out[0], out[1], out[2], out[3]] = [u, w, v10, v11];
    Some(())
}

/// The derivative's derivative by the state in mode REPH.
fn jacobian_reph(given: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let constants = given.constants.first_chunk::<149>()?;
    let state = given.state.first_chunk::<4>()?;
    let R = constants[0];
    let ybed = constants[9];
    let ab = constants[11];
    let ar = constants[14];
    let yb = constants[15];
    let kj = constants[19];
    let cr = constants[26];
    let o_r = constants[27];
    let yd = constants[28];
    let wd = constants[29];
    let k1 = constants[35];
    let c37 = constants[37];
    let c38 = constants[38];
    let c39 = constants[39];
    let c40 = constants[40];
    let c41 = constants[41];
    let c47 = constants[47];
    let c48 = constants[48];
    let c49 = constants[49];
    let c50 = constants[50];
    let c65 = constants[65];
    let c125 = constants[125];
    let c126 = constants[126];
    let c131 = constants[131];
    let c138 = constants[138];
    let c139 = constants[139];
    let c140 = constants[140];
    let c141 = constants[141];
    let c142 = constants[142];
    let c143 = constants[143];
    let c144 = constants[144];
    let c145 = constants[145];
    let c146 = constants[146];
    let c147 = constants[147];
    let c148 = constants[148];
    let y = state[0];
    let z = state[1];
    let u = state[2];
    let w = state[3];
    let v0 = c131 * (y - yd);
    let v1 = functions::logistic(v0);
    let v2 = 1.0 - v1;
    let v3 = cr * (u * R * v2 - w);
    let v4 = functions::softplus(v3);
    let v5 = v2 * v4;
    let v6 = o_r - z + R * (y - wd * functions::softplus(v0));
    let v7 = v6 * functions::logistic(v3);
    let v8 = v1 * v2;
    let v9 = u * v8;
    let v10 = core::f64::consts::LOG2_E * (c142 * v9 * v7 - c141 * v5);
    let v11 = 1.0 + u * ab;
    let v12 = c37 * (y - ybed);
    let v13 = functions::softplus(v12);
    let v14 = functions::logistic(v12) * (c47 * v13) * functions::larger(v11, 0.0);
    let v15 = 1.0 - u * ar;
    let v16 = -(y * c37);
    let v17 = functions::softplus(v16);
    let v18 = functions::logistic(v16) * (c48 * v17) * functions::larger(v15, 0.0);
    let v19 = k1 + kj * functions::logistic(c41 * (y - yb)) + 2.0 * (v14 + v18);
    let v20 = core::f64::consts::LOG2_E * (v8 * v6 * (c140 * v4));
    let v21 = if v11 > 0.0 { ab } else { 0.0 };
    let v22 = if v15 > 0.0 { c49 } else { 0.0 };
    let v23 = math::tanh(u * c40);
    let v24 = c38 * v21 * (v13 * v13) + c50 * (1.0 - v23 * v23);
    let v25 = v2 * v7;
    let v26 = core::f64::consts::LOG2_E * (c145 * v2 * v25);
    let v27 = c125 * (c65 + c39 * v22 * (v17 * v17) - v24) - v26;
    let v28 = core::f64::consts::LOG2_E * (c143 * v5 - c144 * v9 * v7);
    let v29 = -(c126 + core::f64::consts::LOG2_E * (c148 * v7));
    let out = out.first_chunk_mut::<16>()?;
    [out[0], out[1], out[2], out[3], out[4], out[5], out[6]] = [0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0];
    out[7] = 1.0;
    out[8] = c125 * -v19 + v20 + v2 * v10;
    out[9] = core::f64::consts::LOG2_E * (c138 * v5);
    out[10] = v27;
    out[11] = core::f64::consts::LOG2_E * (c147 * v25);
    out[12] = v28;
    out[13] = -(core::f64::consts::LOG2_E * (c139 * v4));
    out[14] = core::f64::consts::LOG2_E * (c146 * v25);
    out[15] = v29;
    Some(())
}

/// The outputs in mode REPH.
fn outputs_reph(given: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let constants = given.constants.first_chunk::<132>()?;
    let state = given.state.first_chunk::<4>()?;
    let input = given.input;
    let R = constants[0];
    let kr = constants[25];
    let cr = constants[26];
    let o_r = constants[27];
    let yd = constants[28];
    let wd = constants[29];
    let k1 = constants[35];
    let b1 = constants[36];
    let c131 = constants[131];
    let y = state[0];
    let z = state[1];
    let u = state[2];
    let w = state[3];
    let s = input[0];
    let s_rate = input[1];
    let v0 = c131 * (y - yd);
    let v1 = cr * (u * R * (1.0 - functions::logistic(v0)) - w);
    let v2 = kr * (o_r - z + R * (y - wd * functions::softplus(v0)));
    let v3 = core::f64::consts::LOG2_E * (v2 * functions::softplus(v1));
    let out = out.first_chunk_mut::<4>()?;
    out[0] = k1 * (s - y) + b1 * (s_rate - u);
    [out[1], out[2], out[3]] = [0.0, v3, 0.0];
    Some(())
}

/// Energy, supplied and dissipated power in mode REPH.
fn balance_reph(given: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let constants = given.constants.first_chunk::<132>()?;
    let state = given.state.first_chunk::<4>()?;
    let input = given.input;
    let R = constants[0];
    let mk = constants[1];
    let mh = constants[2];
    let Wk = constants[4];
    let ck = constants[5];
    let Fc = constants[6];
    let ch = constants[8];
    let ybed = constants[9];
    let ab = constants[11];
    let ar = constants[14];
    let yb = constants[15];
    let kr = constants[25];
    let cr = constants[26];
    let o_r = constants[27];
    let yd = constants[28];
    let wd = constants[29];
    let k1 = constants[35];
    let b1 = constants[36];
    let c37 = constants[37];
    let c38 = constants[38];
    let c39 = constants[39];
    let c40 = constants[40];
    let c41 = constants[41];
    let c44 = constants[44];
    let c53 = constants[53];
    let c54 = constants[54];
    let c55 = constants[55];
    let c131 = constants[131];
    let y = state[0];
    let z = state[1];
    let u = state[2];
    let w = state[3];
    let s = input[0];
    let s_rate = input[1];
    let v0 = s - y;
    let v1 = k1 * v0;
    let v2 = c37 * (y - ybed);
    let v3 = -(y * c37);
    let v4 = c131 * (y - yd);
    let v5 = o_r - z + R * (y - wd * functions::softplus(v4));
    let v6 = v0 * v1 + (mk * (u * u) + mh * (w * w)) + v5 * (kr * v5);
    let v7 = y * Wk + z * c44 + c55 * functions::softplus_square_area(v3);
    let v8 = c53 * functions::softplus_area(c41 * (y - yb));
    let v9 = v7 + (v8 + c54 * functions::softplus_square_area(v2));
    let v10 = s_rate - u;
    let v11 = b1 * v10;
    let v12 = functions::softplus(v2);
    let v13 = c38 * (functions::larger(1.0 + u * ab, 0.0) - 1.0);
    let v14 = functions::softplus(v3);
    let v15 = c39 * (functions::larger(1.0 - u * ar, 0.0) - 1.0);
    let v16 = u * ck + Fc * math::tanh(u * c40) + v12 * v12 * v13;
    let v17 = u * R * (1.0 - functions::logistic(v4)) - w;
    let v18 = core::f64::consts::LOG2_E * functions::softplus(cr * v17);
    let v19 = w * (w * ch) + v10 * v11 + u * (v16 - v14 * v14 * v15);
    let out = out.first_chunk_mut::<3>()?;
    out[0] = v9 + 0.5 * v6;
    out[1] = s_rate * (v1 + v11);
    out[2] = v19 + v17 * (kr * (v5 * (v18 - 1.0)));
    Some(())
}

/// The guard and its rate: rep_off in mode REPH.
fn guard_rep_off_reph(given: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let constants = given.constants.first_chunk::<132>()?;
    let state = given.state.first_chunk::<4>()?;
    let R = constants[0];
    let o_r = constants[27];
    let yd = constants[28];
    let wd = constants[29];
    let c131 = constants[131];
    let y = state[0];
    let z = state[1];
    let u = state[2];
    let w = state[3];
    let v0 = c131 * (y - yd);
    let out = out.first_chunk_mut::<2>()?;
    out[0] = o_r - z + R * (y - wd * functions::softplus(v0));
    out[1] = R * (u * (1.0 - functions::logistic(v0))) - w;
    Some(())
}

/// Bounds of the guard's move and bend: rep_off in mode REPH.
fn bound_rep_off_reph(given: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let constants = given.constants.first_chunk::<151>()?;
    let state = given.state.first_chunk::<1>()?;
    let extra = given.extra.first_chunk::<7>()?;
    let yd = constants[28];
    let c128 = constants[128];
    let c131 = constants[131];
    let c132 = constants[132];
    let c149 = constants[149];
    let c150 = constants[150];
    let y = state[0];
    let v0 = extra[0] * c132;
    let v1 = c131 * (y - yd);
    let v2 = functions::logistic(functions::larger(v1.abs() - v0, 0.0));
    let v3 = v0 * (v2 * (1.0 - v2));
    let v4 = functions::logistic(v1);
    let v5 = c128 * ((v4 - 1.0).abs() + v3);
    let v6 = v3 + (functions::logistic(v0 + v1) + v4.abs()) * v3;
    let v7 = extra[1] * extra[1] * ((c149 * (v4 * (1.0 - v4))).abs() + c150 * v6);
    let out = out.first_chunk_mut::<2>()?;
    out[0] = extra[4] + extra[0] * v5;
    out[1] = extra[6] + extra[2] * v5 + v7;
    Some(())
}

/// The state after guard check in mode REPH.
fn reset_0_check_reph(given: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let constants = given.constants.first_chunk::<154>()?;
    let state = given.state.first_chunk::<4>()?;
    let mk = constants[1];
    let ybed = constants[9];
    let zc = constants[30];
    let Rc = constants[31];
    let c151 = constants[151];
    let c152 = constants[152];
    let c153 = constants[153];
    let y = state[0];
    let u = state[2];
    let w = state[3];
    let v0 = u * mk + w * c151;
    let out = out.first_chunk_mut::<5>()?;
    out[0] = y;
    out[1] = zc + Rc * (y - ybed);
    [out[2], out[3], out[4]] = [c152 * v0, c153 * v0, 0.0];
    Some(())
}

/// The guard and its rate: check in mode REPH.
fn guard_check_reph(given: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let constants = given.constants.first_chunk::<32>()?;
    let state = given.state.first_chunk::<4>()?;
    let ybed = constants[9];
    let zc = constants[30];
    let Rc = constants[31];
    let y = state[0];
    let z = state[1];
    let u = state[2];
    let w = state[3];
    let out = out.first_chunk_mut::<2>()?;
    out[0] = z - zc - Rc * (y - ybed);
    out[1] = w - Rc * u;
    Some(())
}

/// Bounds of the guard's move and bend: check in mode REPH.
fn bound_check_reph(given: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let constants = given.constants.first_chunk::<155>()?;
    let extra = given.extra.first_chunk::<7>()?;
    let c154 = constants[154];
    let out = out.first_chunk_mut::<2>()?;
    out[0] = extra[4] + extra[0] * c154;
    out[1] = extra[6] + c154 * extra[2];
    Some(())
}

/// The guard and its rate: check_far in mode REPH.
fn guard_check_far_reph(given: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let constants = given.constants.first_chunk::<33>()?;
    let state = given.state.first_chunk::<3>()?;
    let yck = constants[32];
    let y = state[0];
    let u = state[2];
    let out = out.first_chunk_mut::<2>()?;
    [out[0], out[1]] = [y - yck, u];
    Some(())
}

/// Where the Taylor series begins in mode REPH.
fn series_start_reph(given: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let constants = given.constants.first_chunk::<140>()?;
    let state = given.state.first_chunk::<4>()?;
    let input = given.input;
    let R = constants[0];
    let g = constants[3];
    let Wk = constants[4];
    let ck = constants[5];
    let Fc = constants[6];
    let ybed = constants[9];
    let ab = constants[11];
    let ar = constants[14];
    let yb = constants[15];
    let cr = constants[26];
    let o_r = constants[27];
    let yd = constants[28];
    let wd = constants[29];
    let zc = constants[30];
    let Rc = constants[31];
    let yck = constants[32];
    let k1 = constants[35];
    let b1 = constants[36];
    let c37 = constants[37];
    let c38 = constants[38];
    let c39 = constants[39];
    let c40 = constants[40];
    let c41 = constants[41];
    let c42 = constants[42];
    let c125 = constants[125];
    let c126 = constants[126];
    let c131 = constants[131];
    let c138 = constants[138];
    let c139 = constants[139];
    let y = state[0];
    let z = state[1];
    let u = state[2];
    let w = state[3];
    let s = input[0];
    let s_rate = input[1];
    let v0 = 1.0 + u * ab;
    let v1 = v0 - 0.0;
    let v2 = if v1 > 0.0 { v0 } else { 0.0 };
    let v3 = y - ybed;
    let v4 = c37 * v3;
    let v5 = functions::logistic(v4);
    let v6 = functions::softplus(v4);
    let v7 = c38 * (v6 * v6);
    let v8 = 1.0 - u * ar;
    let v9 = v8 - 0.0;
    let v10 = if v9 > 0.0 { v8 } else { 0.0 };
    let v11 = -(y * c37);
    let v12 = functions::logistic(v11);
    let v13 = functions::softplus(v11);
    let v14 = c39 * (v13 * v13);
    let v15 = u * c40;
    let v16 = math::tanh(v15);
    let v17 = c41 * (y - yb);
    let v18 = functions::logistic(v17);
    let v19 = k1 * (s - y) + b1 * (s_rate - u) - (Wk + u * ck) - Fc * v16;
    let v20 = v14 * v10 + (v19 - c42 * functions::softplus(v17) - v7 * v2);
    let v21 = c131 * (y - yd);
    let v22 = functions::logistic(v21);
    let v23 = 1.0 - v22;
    let v24 = o_r - z + R * (y - wd * functions::softplus(v21));
    let v25 = u * R;
    let v26 = cr * (v25 * v23 - w);
    let v27 = functions::logistic(v26);
    let v28 = functions::softplus(v26);
    let v29 = v24 * v28;
    let v30 = c138 * v23;
    let v31 = c125 * v20 - core::f64::consts::LOG2_E * (v30 * v29);
    let v32 = core::f64::consts::LOG2_E * (c139 * v29) - (g + w * c126);
    let v33 = v4.abs();
    let v34 = if v33 - 20.0 > 0.0 { 20.0 } else { 10.0 };
    let v35 = if v33 - 40.0 > 0.0 { 40.0 } else { v34 };
    let v36 = v33 - v35;
    let v37 = v36 - 0.0;
    let v38 = if v37 > 0.0 { v36 } else { 0.0 };
    let v39 = v11.abs();
    let v40 = if v39 - 20.0 > 0.0 { 20.0 } else { 10.0 };
    let v41 = if v39 - 40.0 > 0.0 { 40.0 } else { v40 };
    let v42 = v39 - v41;
    let v43 = v42 - 0.0;
    let v44 = if v43 > 0.0 { v42 } else { 0.0 };
    let v45 = v17.abs();
    let v46 = if v45 - 20.0 > 0.0 { 20.0 } else { 10.0 };
    let v47 = if v45 - 40.0 > 0.0 { 40.0 } else { v46 };
    let v48 = v45 - v47;
    let v49 = v48 - 0.0;
    let v50 = if v49 > 0.0 { v48 } else { 0.0 };
    let v51 = v21.abs();
    let v52 = if v51 - 20.0 > 0.0 { 20.0 } else { 10.0 };
    let v53 = if v51 - 40.0 > 0.0 { 40.0 } else { v52 };
    let v54 = v51 - v53;
    let v55 = v54 - 0.0;
    let v56 = if v55 > 0.0 { v54 } else { 0.0 };
    let v57 = v26.abs();
    let v58 = if v57 - 20.0 > 0.0 { 20.0 } else { 10.0 };
    let v59 = if v57 - 40.0 > 0.0 { 40.0 } else { v58 };
    let v60 = v57 - v59;
    let v61 = v60 - 0.0;
    let v62 = if v61 > 0.0 { v60 } else { 0.0 };
    let v63 = v15.abs();
    let v64 = v63 + v63;
    let v65 = if v64 - 20.0 > 0.0 { 20.0 } else { 10.0 };
    let v66 = if v64 - 40.0 > 0.0 { 40.0 } else { v65 };
    let v67 = v64 - v66;
    let v68 = v67 - 0.0;
    let v69 = if v68 > 0.0 { v67 } else { 0.0 };
    let out = out.first_chunk_mut::<58>()?;
    [out[0], out[1], out[2], out[3], out[4]] = [u, w, v31, v32, v24];
    out[5] = z - zc - Rc * v3;
    [out[6], out[7], out[8], out[9], out[10], out[11]] = [y - yck, v1, v9, v38, v44, v50];
    [out[12], out[13], out[14], out[15], out[16]] = [v56, v62, v69, v1, v5 - v5 * v5];
    [out[17], out[18], out[19], out[20], out[21], out[22]] = [v5 + v5, v5, v6 + v6, v7, v2, v9];
    out[23] = v12 - v12 * v12;
    [out[24], out[25], out[26], out[27], out[28]] = [v12 + v12, v12, v13 + v13, v14, v10];
    out[29] = 1.0 - v16 * v16;
    out[30] = v16 + v16;
    out[31] = v18 - v18 * v18;
    [out[32], out[33]] = [v18 + v18, v18];
    out[34] = v22 - v22 * v22;
    [out[35], out[36], out[37], out[38]] = [v22 + v22, v22, v25, v23];
    out[39] = v27 - v27 * v27;
    [out[40], out[41], out[42], out[43], out[44], out[45]] = [v27 + v27, v27, v24, v28, v30, v29];
    out[46] = functions::sign(v4);
    out[47] = v37;
    out[48] = functions::sign(v11);
    out[49] = v43;
    out[50] = functions::sign(v17);
    out[51] = v49;
    out[52] = functions::sign(v21);
    out[53] = v55;
    out[54] = functions::sign(v26);
    out[55] = v61;
    out[56] = functions::sign(v15);
    out[57] = v68;
    Some(())
}

/// One order of the Taylor series in mode REPH.
fn series_step_reph(given: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let constants = given.constants.first_chunk::<140>()?;
    let state = given.state.first_chunk::<4>()?;
    let extra = given.extra.first_chunk::<69>()?;
    let input = given.input;
    let R = constants[0];
    let ck = constants[5];
    let Fc = constants[6];
    let ab = constants[11];
    let ar = constants[14];
    let cr = constants[26];
    let wd = constants[29];
    let Rc = constants[31];
    let k1 = constants[35];
    let b1 = constants[36];
    let c37 = constants[37];
    let c38 = constants[38];
    let c39 = constants[39];
    let c40 = constants[40];
    let c41 = constants[41];
    let c42 = constants[42];
    let c125 = constants[125];
    let c126 = constants[126];
    let c131 = constants[131];
    let c138 = constants[138];
    let c139 = constants[139];
    let y = state[0];
    let z = state[1];
    let u = state[2];
    let w = state[3];
    let s = input[0];
    let s_rate = input[1];
    let v0 = ab * u;
    let v1 = if extra[2] > 0.0 { v0 } else { 0.0 };
    let v2 = c37 * y;
    let v3 = extra[45] * extra[1] + v2 * extra[3];
    let v4 = extra[47] * extra[1] + v2 * extra[5];
    let v5 = c38 * (extra[48] + extra[6] * v4);
    let v6 = -(ar * u);
    let v7 = if extra[9] > 0.0 { v6 } else { 0.0 };
    let v8 = -v2;
    let v9 = extra[50] * extra[1] + v8 * extra[10];
    let v10 = extra[52] * extra[1] + v8 * extra[12];
    let v11 = c39 * (extra[53] + extra[13] * v10);
    let v12 = c40 * u;
    let v13 = extra[55] * extra[1] + v12 * extra[16];
    let v14 = c41 * y;
    let v15 = extra[57] * extra[1] + v14 * extra[18];
    let v16 = k1 * (s - y) + b1 * (s_rate - u) - ck * u - Fc * v13;
    let v17 = v16 - c42 * (extra[59] * extra[1] + v14 * extra[20]);
    let v18 = v17 - (extra[49] + extra[7] * v1 + v5 * extra[8]);
    let v19 = extra[54] + extra[14] * v7 + v11 * extra[15] + v18;
    let v20 = c131 * y;
    let v21 = extra[60] * extra[1] + v20 * extra[21];
    let v22 = -v21;
    let v23 = y - wd * (extra[62] * extra[1] + v20 * extra[23]);
    let v24 = -z + R * v23;
    let v25 = R * u;
    let v26 = extra[63] + extra[24] * v22 + v25 * extra[25] - w;
    let v27 = cr * v26;
    let v28 = extra[64] * extra[1] + v27 * extra[26];
    let v29 = extra[66] * extra[1] + v27 * extra[28];
    let v30 = extra[67] + extra[29] * v29 + v24 * extra[30];
    let v31 = c138 * v22;
    let v32 = core::f64::consts::LOG2_E * (extra[68] + extra[31] * v30 + v31 * extra[32]);
    let v33 = core::f64::consts::LOG2_E * (c139 * v30) - c126 * w;
    let v34 = if extra[34] > 0.0 { extra[33] * v2 } else { 0.0 };
    let v35 = if extra[36] > 0.0 { extra[35] * v8 } else { 0.0 };
    let v36 = if extra[38] > 0.0 { extra[37] * v14 } else { 0.0 };
    let v37 = if extra[40] > 0.0 { extra[39] * v20 } else { 0.0 };
    let v38 = if extra[42] > 0.0 { extra[41] * v27 } else { 0.0 };
    let v39 = extra[43] * v12;
    let v40 = if extra[44] > 0.0 { v39 + v39 } else { 0.0 };
    let v41 = extra[0] * v2;
    let v42 = extra[0] * v8;
    let v43 = extra[0] * v14;
    let v44 = extra[0] * v20;
    let v45 = extra[0] * v27;
    let out = out.first_chunk_mut::<63>()?;
    [out[0], out[1]] = [u, w];
    out[2] = c125 * v19 - v32;
    [out[3], out[4], out[5], out[6], out[7], out[8]] = [v33, v24, z - Rc * y, y, v0, v6];
    [out[9], out[10], out[11], out[12], out[13], out[14]] = [v34, v35, v36, v37, v38, v40];
    [out[15], out[16], out[17], out[18], out[19], out[20]] = [v41, v3, v41, v4, v5, v42];
    [out[21], out[22], out[23], out[24]] = [v9, v42, v10, v11];
    out[25] = extra[0] * v12;
    [out[26], out[27], out[28], out[29], out[30], out[31]] = [v13, v43, v15, v43, v44, v21];
    [out[32], out[33], out[34], out[35], out[36], out[37]] = [v44, v25, v45, v28, v45, v24];
    out[38] = v31;
    out[39] = v3 - (extra[46] + extra[4] * v3);
    [out[40], out[41], out[42], out[43]] = [v3, v3, v4, v1];
    out[44] = v9 - (extra[51] + extra[11] * v9);
    [out[45], out[46], out[47], out[48]] = [v9, v9, v10, v7];
    out[49] = -(extra[56] + extra[17] * v13);
    out[50] = v13;
    out[51] = v15 - (extra[58] + extra[19] * v15);
    [out[52], out[53]] = [v15, v15];
    out[54] = v21 - (extra[61] + extra[22] * v21);
    [out[55], out[56], out[57]] = [v21, v21, v22];
    out[58] = v28 - (extra[65] + extra[27] * v28);
    [out[59], out[60], out[61], out[62]] = [v28, v28, v29, v30];
    Some(())
}

/// The guard and its rate: check_near in mode REPL.
fn guard_check_near_repl(given: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let constants = given.constants.first_chunk::<33>()?;
    let state = given.state.first_chunk::<3>()?;
    let yck = constants[32];
    let y = state[0];
    let u = state[2];
    let out = out.first_chunk_mut::<2>()?;
    [out[0], out[1]] = [yck - y, -u];
    Some(())
}

/// Where the Taylor series begins in mode REPL.
fn series_start_repl(given: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let constants = given.constants.first_chunk::<140>()?;
    let state = given.state.first_chunk::<4>()?;
    let input = given.input;
    let R = constants[0];
    let g = constants[3];
    let Wk = constants[4];
    let ck = constants[5];
    let Fc = constants[6];
    let ybed = constants[9];
    let ab = constants[11];
    let ar = constants[14];
    let yb = constants[15];
    let cr = constants[26];
    let o_r = constants[27];
    let yd = constants[28];
    let wd = constants[29];
    let yck = constants[32];
    let yrs = constants[34];
    let k1 = constants[35];
    let b1 = constants[36];
    let c37 = constants[37];
    let c38 = constants[38];
    let c39 = constants[39];
    let c40 = constants[40];
    let c41 = constants[41];
    let c42 = constants[42];
    let c125 = constants[125];
    let c126 = constants[126];
    let c131 = constants[131];
    let c138 = constants[138];
    let c139 = constants[139];
    let y = state[0];
    let z = state[1];
    let u = state[2];
    let w = state[3];
    let s = input[0];
    let s_rate = input[1];
    let v0 = 1.0 + u * ab;
    let v1 = v0 - 0.0;
    let v2 = if v1 > 0.0 { v0 } else { 0.0 };
    let v3 = c37 * (y - ybed);
    let v4 = functions::logistic(v3);
    let v5 = functions::softplus(v3);
    let v6 = c38 * (v5 * v5);
    let v7 = 1.0 - u * ar;
    let v8 = v7 - 0.0;
    let v9 = if v8 > 0.0 { v7 } else { 0.0 };
    let v10 = -(y * c37);
    let v11 = functions::logistic(v10);
    let v12 = functions::softplus(v10);
    let v13 = c39 * (v12 * v12);
    let v14 = u * c40;
    let v15 = math::tanh(v14);
    let v16 = c41 * (y - yb);
    let v17 = functions::logistic(v16);
    let v18 = k1 * (s - y) + b1 * (s_rate - u) - (Wk + u * ck) - Fc * v15;
    let v19 = v13 * v9 + (v18 - c42 * functions::softplus(v16) - v6 * v2);
    let v20 = c131 * (y - yd);
    let v21 = functions::logistic(v20);
    let v22 = 1.0 - v21;
    let v23 = o_r - z + R * (y - wd * functions::softplus(v20));
    let v24 = u * R;
    let v25 = cr * (v24 * v22 - w);
    let v26 = functions::logistic(v25);
    let v27 = functions::softplus(v25);
    let v28 = v23 * v27;
    let v29 = c138 * v22;
    let v30 = c125 * v19 - core::f64::consts::LOG2_E * (v29 * v28);
    let v31 = core::f64::consts::LOG2_E * (c139 * v28) - (g + w * c126);
    let v32 = v3.abs();
    let v33 = if v32 - 20.0 > 0.0 { 20.0 } else { 10.0 };
    let v34 = if v32 - 40.0 > 0.0 { 40.0 } else { v33 };
    let v35 = v32 - v34;
    let v36 = v35 - 0.0;
    let v37 = if v36 > 0.0 { v35 } else { 0.0 };
    let v38 = v10.abs();
    let v39 = if v38 - 20.0 > 0.0 { 20.0 } else { 10.0 };
    let v40 = if v38 - 40.0 > 0.0 { 40.0 } else { v39 };
    let v41 = v38 - v40;
    let v42 = v41 - 0.0;
    let v43 = if v42 > 0.0 { v41 } else { 0.0 };
    let v44 = v16.abs();
    let v45 = if v44 - 20.0 > 0.0 { 20.0 } else { 10.0 };
    let v46 = if v44 - 40.0 > 0.0 { 40.0 } else { v45 };
    let v47 = v44 - v46;
    let v48 = v47 - 0.0;
    let v49 = if v48 > 0.0 { v47 } else { 0.0 };
    let v50 = v20.abs();
    let v51 = if v50 - 20.0 > 0.0 { 20.0 } else { 10.0 };
    let v52 = if v50 - 40.0 > 0.0 { 40.0 } else { v51 };
    let v53 = v50 - v52;
    let v54 = v53 - 0.0;
    let v55 = if v54 > 0.0 { v53 } else { 0.0 };
    let v56 = v25.abs();
    let v57 = if v56 - 20.0 > 0.0 { 20.0 } else { 10.0 };
    let v58 = if v56 - 40.0 > 0.0 { 40.0 } else { v57 };
    let v59 = v56 - v58;
    let v60 = v59 - 0.0;
    let v61 = if v60 > 0.0 { v59 } else { 0.0 };
    let v62 = v14.abs();
    let v63 = v62 + v62;
    let v64 = if v63 - 20.0 > 0.0 { 20.0 } else { 10.0 };
    let v65 = if v63 - 40.0 > 0.0 { 40.0 } else { v64 };
    let v66 = v63 - v65;
    let v67 = v66 - 0.0;
    let v68 = if v67 > 0.0 { v66 } else { 0.0 };
    let out = out.first_chunk_mut::<58>()?;
    [out[0], out[1], out[2], out[3], out[4], out[5]] = [u, w, v30, v31, v23, yck - y];
    [out[6], out[7], out[8], out[9], out[10], out[11]] = [y - yrs, v1, v8, v37, v43, v49];
    [out[12], out[13], out[14], out[15], out[16]] = [v55, v61, v68, v1, v4 - v4 * v4];
    [out[17], out[18], out[19], out[20], out[21], out[22]] = [v4 + v4, v4, v5 + v5, v6, v2, v8];
    out[23] = v11 - v11 * v11;
    [out[24], out[25], out[26], out[27], out[28]] = [v11 + v11, v11, v12 + v12, v13, v9];
    out[29] = 1.0 - v15 * v15;
    out[30] = v15 + v15;
    out[31] = v17 - v17 * v17;
    [out[32], out[33]] = [v17 + v17, v17];
    out[34] = v21 - v21 * v21;
    [out[35], out[36], out[37], out[38]] = [v21 + v21, v21, v24, v22];
    out[39] = v26 - v26 * v26;
    [out[40], out[41], out[42], out[43], out[44], out[45]] = [v26 + v26, v26, v23, v27, v29, v28];
    out[46] = functions::sign(v3);
    out[47] = v36;
    out[48] = functions::sign(v10);
    out[49] = v42;
    out[50] = functions::sign(v16);
    out[51] = v48;
    out[52] = functions::sign(v20);
    out[53] = v54;
    out[54] = functions::sign(v25);
    out[55] = v60;
    out[56] = functions::sign(v14);
    out[57] = v67;
    Some(())
}

/// One order of the Taylor series in mode REPL.
fn series_step_repl(given: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let constants = given.constants.first_chunk::<140>()?;
    let state = given.state.first_chunk::<4>()?;
    let extra = given.extra.first_chunk::<69>()?;
    let input = given.input;
    let R = constants[0];
    let ck = constants[5];
    let Fc = constants[6];
    let ab = constants[11];
    let ar = constants[14];
    let cr = constants[26];
    let wd = constants[29];
    let k1 = constants[35];
    let b1 = constants[36];
    let c37 = constants[37];
    let c38 = constants[38];
    let c39 = constants[39];
    let c40 = constants[40];
    let c41 = constants[41];
    let c42 = constants[42];
    let c125 = constants[125];
    let c126 = constants[126];
    let c131 = constants[131];
    let c138 = constants[138];
    let c139 = constants[139];
    let y = state[0];
    let z = state[1];
    let u = state[2];
    let w = state[3];
    let s = input[0];
    let s_rate = input[1];
    let v0 = ab * u;
    let v1 = if extra[2] > 0.0 { v0 } else { 0.0 };
    let v2 = c37 * y;
    let v3 = extra[45] * extra[1] + v2 * extra[3];
    let v4 = extra[47] * extra[1] + v2 * extra[5];
    let v5 = c38 * (extra[48] + extra[6] * v4);
    let v6 = -(ar * u);
    let v7 = if extra[9] > 0.0 { v6 } else { 0.0 };
    let v8 = -v2;
    let v9 = extra[50] * extra[1] + v8 * extra[10];
    let v10 = extra[52] * extra[1] + v8 * extra[12];
    let v11 = c39 * (extra[53] + extra[13] * v10);
    let v12 = c40 * u;
    let v13 = extra[55] * extra[1] + v12 * extra[16];
    let v14 = c41 * y;
    let v15 = extra[57] * extra[1] + v14 * extra[18];
    let v16 = k1 * (s - y) + b1 * (s_rate - u) - ck * u - Fc * v13;
    let v17 = v16 - c42 * (extra[59] * extra[1] + v14 * extra[20]);
    let v18 = v17 - (extra[49] + extra[7] * v1 + v5 * extra[8]);
    let v19 = extra[54] + extra[14] * v7 + v11 * extra[15] + v18;
    let v20 = c131 * y;
    let v21 = extra[60] * extra[1] + v20 * extra[21];
    let v22 = -v21;
    let v23 = y - wd * (extra[62] * extra[1] + v20 * extra[23]);
    let v24 = -z + R * v23;
    let v25 = R * u;
    let v26 = extra[63] + extra[24] * v22 + v25 * extra[25] - w;
    let v27 = cr * v26;
    let v28 = extra[64] * extra[1] + v27 * extra[26];
    let v29 = extra[66] * extra[1] + v27 * extra[28];
    let v30 = extra[67] + extra[29] * v29 + v24 * extra[30];
    let v31 = c138 * v22;
    let v32 = core::f64::consts::LOG2_E * (extra[68] + extra[31] * v30 + v31 * extra[32]);
    let v33 = core::f64::consts::LOG2_E * (c139 * v30) - c126 * w;
    let v34 = if extra[34] > 0.0 { extra[33] * v2 } else { 0.0 };
    let v35 = if extra[36] > 0.0 { extra[35] * v8 } else { 0.0 };
    let v36 = if extra[38] > 0.0 { extra[37] * v14 } else { 0.0 };
    let v37 = if extra[40] > 0.0 { extra[39] * v20 } else { 0.0 };
    let v38 = if extra[42] > 0.0 { extra[41] * v27 } else { 0.0 };
    let v39 = extra[43] * v12;
    let v40 = if extra[44] > 0.0 { v39 + v39 } else { 0.0 };
    let v41 = extra[0] * v2;
    let v42 = extra[0] * v8;
    let v43 = extra[0] * v14;
    let v44 = extra[0] * v20;
    let v45 = extra[0] * v27;
    let out = out.first_chunk_mut::<63>()?;
    [out[0], out[1]] = [u, w];
    out[2] = c125 * v19 - v32;
    [out[3], out[4], out[5], out[6], out[7], out[8], out[9]] = [v33, v24, -y, y, v0, v6, v34];
    [out[10], out[11], out[12], out[13], out[14], out[15]] = [v35, v36, v37, v38, v40, v41];
    [out[16], out[17], out[18], out[19], out[20], out[21]] = [v3, v41, v4, v5, v42, v9];
    [out[22], out[23], out[24]] = [v42, v10, v11];
    out[25] = extra[0] * v12;
    [out[26], out[27], out[28], out[29], out[30], out[31]] = [v13, v43, v15, v43, v44, v21];
    [out[32], out[33], out[34], out[35], out[36], out[37]] = [v44, v25, v45, v28, v45, v24];
    out[38] = v31;
    out[39] = v3 - (extra[46] + extra[4] * v3);
    [out[40], out[41], out[42], out[43]] = [v3, v3, v4, v1];
    out[44] = v9 - (extra[51] + extra[11] * v9);
    [out[45], out[46], out[47], out[48]] = [v9, v9, v10, v7];
    out[49] = -(extra[56] + extra[17] * v13);
    out[50] = v13;
    out[51] = v15 - (extra[58] + extra[19] * v15);
    [out[52], out[53]] = [v15, v15];
    out[54] = v21 - (extra[61] + extra[22] * v21);
    [out[55], out[56], out[57]] = [v21, v21, v22];
    out[58] = v28 - (extra[65] + extra[27] * v28);
    [out[59], out[60], out[61], out[62]] = [v28, v28, v29, v30];
    Some(())
}

/// The guard and its rate: jack_in in mode REP0.
fn guard_jack_in_rep0(given: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let constants = given.constants.first_chunk::<1>()?;
    let state = given.state.first_chunk::<4>()?;
    let R = constants[0];
    let y = state[0];
    let z = state[1];
    let u = state[2];
    let w = state[3];
    let out = out.first_chunk_mut::<2>()?;
    [out[0], out[1]] = [y * R - z, R * u - w];
    Some(())
}

/// The guard and its rate: jack_out in mode REP0.
fn guard_jack_out_rep0(given: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let constants = given.constants.first_chunk::<35>()?;
    let state = given.state.first_chunk::<3>()?;
    let yrs = constants[34];
    let y = state[0];
    let u = state[2];
    let out = out.first_chunk_mut::<2>()?;
    [out[0], out[1]] = [yrs - y, -u];
    Some(())
}

/// Where the Taylor series begins in mode REP0.
fn series_start_rep0(given: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let constants = given.constants.first_chunk::<140>()?;
    let state = given.state.first_chunk::<4>()?;
    let input = given.input;
    let R = constants[0];
    let g = constants[3];
    let Wk = constants[4];
    let ck = constants[5];
    let Fc = constants[6];
    let ybed = constants[9];
    let ab = constants[11];
    let ar = constants[14];
    let yb = constants[15];
    let cr = constants[26];
    let o_r = constants[27];
    let yd = constants[28];
    let wd = constants[29];
    let yrs = constants[34];
    let k1 = constants[35];
    let b1 = constants[36];
    let c37 = constants[37];
    let c38 = constants[38];
    let c39 = constants[39];
    let c40 = constants[40];
    let c41 = constants[41];
    let c42 = constants[42];
    let c125 = constants[125];
    let c126 = constants[126];
    let c131 = constants[131];
    let c138 = constants[138];
    let c139 = constants[139];
    let y = state[0];
    let z = state[1];
    let u = state[2];
    let w = state[3];
    let s = input[0];
    let s_rate = input[1];
    let v0 = 1.0 + u * ab;
    let v1 = v0 - 0.0;
    let v2 = if v1 > 0.0 { v0 } else { 0.0 };
    let v3 = c37 * (y - ybed);
    let v4 = functions::logistic(v3);
    let v5 = functions::softplus(v3);
    let v6 = c38 * (v5 * v5);
    let v7 = 1.0 - u * ar;
    let v8 = v7 - 0.0;
    let v9 = if v8 > 0.0 { v7 } else { 0.0 };
    let v10 = -(y * c37);
    let v11 = functions::logistic(v10);
    let v12 = functions::softplus(v10);
    let v13 = c39 * (v12 * v12);
    let v14 = u * c40;
    let v15 = math::tanh(v14);
    let v16 = c41 * (y - yb);
    let v17 = functions::logistic(v16);
    let v18 = k1 * (s - y) + b1 * (s_rate - u) - (Wk + u * ck) - Fc * v15;
    let v19 = v13 * v9 + (v18 - c42 * functions::softplus(v16) - v6 * v2);
    let v20 = c131 * (y - yd);
    let v21 = functions::logistic(v20);
    let v22 = 1.0 - v21;
    let v23 = o_r - z + R * (y - wd * functions::softplus(v20));
    let v24 = u * R;
    let v25 = cr * (v24 * v22 - w);
    let v26 = functions::logistic(v25);
    let v27 = functions::softplus(v25);
    let v28 = v23 * v27;
    let v29 = c138 * v22;
    let v30 = c125 * v19 - core::f64::consts::LOG2_E * (v29 * v28);
    let v31 = core::f64::consts::LOG2_E * (c139 * v28) - (g + w * c126);
    let v32 = v3.abs();
    let v33 = if v32 - 20.0 > 0.0 { 20.0 } else { 10.0 };
    let v34 = if v32 - 40.0 > 0.0 { 40.0 } else { v33 };
    let v35 = v32 - v34;
    let v36 = v35 - 0.0;
    let v37 = if v36 > 0.0 { v35 } else { 0.0 };
    let v38 = v10.abs();
    let v39 = if v38 - 20.0 > 0.0 { 20.0 } else { 10.0 };
    let v40 = if v38 - 40.0 > 0.0 { 40.0 } else { v39 };
    let v41 = v38 - v40;
    let v42 = v41 - 0.0;
    let v43 = if v42 > 0.0 { v41 } else { 0.0 };
    let v44 = v16.abs();
    let v45 = if v44 - 20.0 > 0.0 { 20.0 } else { 10.0 };
    let v46 = if v44 - 40.0 > 0.0 { 40.0 } else { v45 };
    let v47 = v44 - v46;
    let v48 = v47 - 0.0;
    let v49 = if v48 > 0.0 { v47 } else { 0.0 };
    let v50 = v20.abs();
    let v51 = if v50 - 20.0 > 0.0 { 20.0 } else { 10.0 };
    let v52 = if v50 - 40.0 > 0.0 { 40.0 } else { v51 };
    let v53 = v50 - v52;
    let v54 = v53 - 0.0;
    let v55 = if v54 > 0.0 { v53 } else { 0.0 };
    let v56 = v25.abs();
    let v57 = if v56 - 20.0 > 0.0 { 20.0 } else { 10.0 };
    let v58 = if v56 - 40.0 > 0.0 { 40.0 } else { v57 };
    let v59 = v56 - v58;
    let v60 = v59 - 0.0;
    let v61 = if v60 > 0.0 { v59 } else { 0.0 };
    let v62 = v14.abs();
    let v63 = v62 + v62;
    let v64 = if v63 - 20.0 > 0.0 { 20.0 } else { 10.0 };
    let v65 = if v63 - 40.0 > 0.0 { 40.0 } else { v64 };
    let v66 = v63 - v65;
    let v67 = v66 - 0.0;
    let v68 = if v67 > 0.0 { v66 } else { 0.0 };
    let out = out.first_chunk_mut::<58>()?;
    [out[0], out[1], out[2], out[3], out[4], out[5]] = [u, w, v30, v31, v23, y * R - z];
    [out[6], out[7], out[8], out[9], out[10], out[11]] = [yrs - y, v1, v8, v37, v43, v49];
    [out[12], out[13], out[14], out[15], out[16]] = [v55, v61, v68, v1, v4 - v4 * v4];
    [out[17], out[18], out[19], out[20], out[21], out[22]] = [v4 + v4, v4, v5 + v5, v6, v2, v8];
    out[23] = v11 - v11 * v11;
    [out[24], out[25], out[26], out[27], out[28]] = [v11 + v11, v11, v12 + v12, v13, v9];
    out[29] = 1.0 - v15 * v15;
    out[30] = v15 + v15;
    out[31] = v17 - v17 * v17;
    [out[32], out[33]] = [v17 + v17, v17];
    out[34] = v21 - v21 * v21;
    [out[35], out[36], out[37], out[38]] = [v21 + v21, v21, v24, v22];
    out[39] = v26 - v26 * v26;
    [out[40], out[41], out[42], out[43], out[44], out[45]] = [v26 + v26, v26, v23, v27, v29, v28];
    out[46] = functions::sign(v3);
    out[47] = v36;
    out[48] = functions::sign(v10);
    out[49] = v42;
    out[50] = functions::sign(v16);
    out[51] = v48;
    out[52] = functions::sign(v20);
    out[53] = v54;
    out[54] = functions::sign(v25);
    out[55] = v60;
    out[56] = functions::sign(v14);
    out[57] = v67;
    Some(())
}

/// One order of the Taylor series in mode REP0.
fn series_step_rep0(given: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let constants = given.constants.first_chunk::<140>()?;
    let state = given.state.first_chunk::<4>()?;
    let extra = given.extra.first_chunk::<69>()?;
    let input = given.input;
    let R = constants[0];
    let ck = constants[5];
    let Fc = constants[6];
    let ab = constants[11];
    let ar = constants[14];
    let cr = constants[26];
    let wd = constants[29];
    let k1 = constants[35];
    let b1 = constants[36];
    let c37 = constants[37];
    let c38 = constants[38];
    let c39 = constants[39];
    let c40 = constants[40];
    let c41 = constants[41];
    let c42 = constants[42];
    let c125 = constants[125];
    let c126 = constants[126];
    let c131 = constants[131];
    let c138 = constants[138];
    let c139 = constants[139];
    let y = state[0];
    let z = state[1];
    let u = state[2];
    let w = state[3];
    let s = input[0];
    let s_rate = input[1];
    let v0 = ab * u;
    let v1 = if extra[2] > 0.0 { v0 } else { 0.0 };
    let v2 = c37 * y;
    let v3 = extra[45] * extra[1] + v2 * extra[3];
    let v4 = extra[47] * extra[1] + v2 * extra[5];
    let v5 = c38 * (extra[48] + extra[6] * v4);
    let v6 = -(ar * u);
    let v7 = if extra[9] > 0.0 { v6 } else { 0.0 };
    let v8 = -v2;
    let v9 = extra[50] * extra[1] + v8 * extra[10];
    let v10 = extra[52] * extra[1] + v8 * extra[12];
    let v11 = c39 * (extra[53] + extra[13] * v10);
    let v12 = c40 * u;
    let v13 = extra[55] * extra[1] + v12 * extra[16];
    let v14 = c41 * y;
    let v15 = extra[57] * extra[1] + v14 * extra[18];
    let v16 = k1 * (s - y) + b1 * (s_rate - u) - ck * u - Fc * v13;
    let v17 = v16 - c42 * (extra[59] * extra[1] + v14 * extra[20]);
    let v18 = v17 - (extra[49] + extra[7] * v1 + v5 * extra[8]);
    let v19 = extra[54] + extra[14] * v7 + v11 * extra[15] + v18;
    let v20 = c131 * y;
    let v21 = extra[60] * extra[1] + v20 * extra[21];
    let v22 = -v21;
    let v23 = y - wd * (extra[62] * extra[1] + v20 * extra[23]);
    let v24 = -z + R * v23;
    let v25 = R * u;
    let v26 = extra[63] + extra[24] * v22 + v25 * extra[25] - w;
    let v27 = cr * v26;
    let v28 = extra[64] * extra[1] + v27 * extra[26];
    let v29 = extra[66] * extra[1] + v27 * extra[28];
    let v30 = extra[67] + extra[29] * v29 + v24 * extra[30];
    let v31 = c138 * v22;
    let v32 = core::f64::consts::LOG2_E * (extra[68] + extra[31] * v30 + v31 * extra[32]);
    let v33 = core::f64::consts::LOG2_E * (c139 * v30) - c126 * w;
    let v34 = if extra[34] > 0.0 { extra[33] * v2 } else { 0.0 };
    let v35 = if extra[36] > 0.0 { extra[35] * v8 } else { 0.0 };
    let v36 = if extra[38] > 0.0 { extra[37] * v14 } else { 0.0 };
    let v37 = if extra[40] > 0.0 { extra[39] * v20 } else { 0.0 };
    let v38 = if extra[42] > 0.0 { extra[41] * v27 } else { 0.0 };
    let v39 = extra[43] * v12;
    let v40 = if extra[44] > 0.0 { v39 + v39 } else { 0.0 };
    let v41 = extra[0] * v2;
    let v42 = extra[0] * v8;
    let v43 = extra[0] * v14;
    let v44 = extra[0] * v20;
    let v45 = extra[0] * v27;
    let out = out.first_chunk_mut::<63>()?;
    [out[0], out[1]] = [u, w];
    out[2] = c125 * v19 - v32;
    [out[3], out[4], out[5], out[6], out[7], out[8]] = [v33, v24, R * y - z, -y, v0, v6];
    [out[9], out[10], out[11], out[12], out[13], out[14]] = [v34, v35, v36, v37, v38, v40];
    [out[15], out[16], out[17], out[18], out[19], out[20]] = [v41, v3, v41, v4, v5, v42];
    [out[21], out[22], out[23], out[24]] = [v9, v42, v10, v11];
    out[25] = extra[0] * v12;
    [out[26], out[27], out[28], out[29], out[30], out[31]] = [v13, v43, v15, v43, v44, v21];
    [out[32], out[33], out[34], out[35], out[36], out[37]] = [v44, v25, v45, v28, v45, v24];
    out[38] = v31;
    out[39] = v3 - (extra[46] + extra[4] * v3);
    [out[40], out[41], out[42], out[43]] = [v3, v3, v4, v1];
    out[44] = v9 - (extra[51] + extra[11] * v9);
    [out[45], out[46], out[47], out[48]] = [v9, v9, v10, v7];
    out[49] = -(extra[56] + extra[17] * v13);
    out[50] = v13;
    out[51] = v15 - (extra[58] + extra[19] * v15);
    [out[52], out[53]] = [v15, v15];
    out[54] = v21 - (extra[61] + extra[22] * v21);
    [out[55], out[56], out[57]] = [v21, v21, v22];
    out[58] = v28 - (extra[65] + extra[27] * v28);
    [out[59], out[60], out[61], out[62]] = [v28, v28, v29, v30];
    Some(())
}

/// The derivative of the state in mode CHK.
fn derivative_chk(given: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let constants = given.constants.first_chunk::<157>()?;
    let state = given.state.first_chunk::<3>()?;
    let input = given.input;
    let R = constants[0];
    let Wk = constants[4];
    let ck = constants[5];
    let Fc = constants[6];
    let ybed = constants[9];
    let ab = constants[11];
    let ar = constants[14];
    let yb = constants[15];
    let kr = constants[25];
    let yd = constants[28];
    let wd = constants[29];
    let Rc = constants[31];
    let k1 = constants[35];
    let b1 = constants[36];
    let c37 = constants[37];
    let c38 = constants[38];
    let c39 = constants[39];
    let c40 = constants[40];
    let c41 = constants[41];
    let c42 = constants[42];
    let c44 = constants[44];
    let c131 = constants[131];
    let c152 = constants[152];
    let c153 = constants[153];
    let c155 = constants[155];
    let c156 = constants[156];
    let y = state[0];
    let u = state[2];
    let s = input[0];
    let s_rate = input[1];
    let v0 = y - ybed;
    let v1 = functions::softplus(c37 * v0);
    let v2 = c38 * (v1 * v1) * functions::larger(1.0 + u * ab, 0.0);
    let v3 = functions::softplus(-(y * c37));
    let v4 = c39 * (v3 * v3) * functions::larger(1.0 - u * ar, 0.0);
    let v5 = c131 * (y - yd);
    let v6 = c155 - Rc * v0 + R * (y - wd * functions::softplus(v5));
    let v7 = v6 * (kr * (Rc - R * (1.0 - functions::logistic(v5))));
    let v8 = k1 * (s - y) + b1 * (s_rate - u) - (Wk + u * ck + Rc * (c44 + u * c156));
    let v9 = v8 - Fc * math::tanh(u * c40) - c42 * functions::softplus(c41 * (y - yb));
    let v10 = v9 + v7 + (v4 - v2);
    let out = out.first_chunk_mut::<4>()?;
    [out[0], out[1], out[2], out[3]] = [u, u * Rc, c152 * v10, c153 * v10];
    Some(())
}

/// The derivative of a part in mode CHK.
fn part_0_chk(given: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let constants = given.constants.first_chunk::<157>()?;
    let state = given.state.first_chunk::<3>()?;
    let input = given.input;
    let R = constants[0];
    let Wk = constants[4];
    let ck = constants[5];
    let Fc = constants[6];
    let ybed = constants[9];
    let ab = constants[11];
    let ar = constants[14];
    let yb = constants[15];
    let kr = constants[25];
    let yd = constants[28];
    let wd = constants[29];
    let Rc = constants[31];
    let k1 = constants[35];
    let b1 = constants[36];
    let c37 = constants[37];
    let c38 = constants[38];
    let c39 = constants[39];
    let c40 = constants[40];
    let c41 = constants[41];
    let c42 = constants[42];
    let c44 = constants[44];
    let c131 = constants[131];
    let c152 = constants[152];
    let c155 = constants[155];
    let c156 = constants[156];
    let y = state[0];
    let u = state[2];
    let s = input[0];
    let s_rate = input[1];
    let v0 = y - ybed;
    let v1 = functions::softplus(c37 * v0);
    let v2 = c38 * (v1 * v1) * functions::larger(1.0 + u * ab, 0.0);
    let v3 = functions::softplus(-(y * c37));
    let v4 = c39 * (v3 * v3) * functions::larger(1.0 - u * ar, 0.0);
    let v5 = c131 * (y - yd);
    let v6 = c155 - Rc * v0 + R * (y - wd * functions::softplus(v5));
    let v7 = v6 * (kr * (Rc - R * (1.0 - functions::logistic(v5))));
    let v8 = k1 * (s - y) + b1 * (s_rate - u) - (Wk + u * ck + Rc * (c44 + u * c156));
    let v9 = v8 - Fc * math::tanh(u * c40) - c42 * functions::softplus(c41 * (y - yb));
    let out = out.first_chunk_mut::<4>()?;
    [out[0], out[1]] = [u, 0.0];
    out[2] = c152 * (v9 + v7 + (v4 - v2));
    out[3] = 0.0;
    Some(())
}

/// The state with slaved entries in place in mode CHK.
fn slaved_chk(given: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let constants = given.constants.first_chunk::<32>()?;
    let state = given.state.first_chunk::<3>()?;
    let ybed = constants[9];
    let zc = constants[30];
    let Rc = constants[31];
    let y = state[0];
    let u = state[2];
    let out = out.first_chunk_mut::<4>()?;
    out[0] = y;
    out[1] = zc + Rc * (y - ybed);
    [out[2], out[3]] = [u, Rc * u];
    Some(())
}

/// The derivative's derivative by the state in mode CHK.
fn jacobian_chk(given: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let constants = given.constants.first_chunk::<159>()?;
    let state = given.state.first_chunk::<3>()?;
    let R = constants[0];
    let ybed = constants[9];
    let ab = constants[11];
    let ar = constants[14];
    let yb = constants[15];
    let kj = constants[19];
    let kr = constants[25];
    let yd = constants[28];
    let wd = constants[29];
    let Rc = constants[31];
    let k1 = constants[35];
    let c37 = constants[37];
    let c38 = constants[38];
    let c39 = constants[39];
    let c40 = constants[40];
    let c41 = constants[41];
    let c47 = constants[47];
    let c48 = constants[48];
    let c49 = constants[49];
    let c50 = constants[50];
    let c131 = constants[131];
    let c152 = constants[152];
    let c155 = constants[155];
    let c157 = constants[157];
    let c158 = constants[158];
    let y = state[0];
    let u = state[2];
    let v0 = 1.0 + u * ab;
    let v1 = y - ybed;
    let v2 = c37 * v1;
    let v3 = functions::softplus(v2);
    let v4 = functions::logistic(v2) * (c47 * v3) * functions::larger(v0, 0.0);
    let v5 = 1.0 - u * ar;
    let v6 = -(y * c37);
    let v7 = functions::softplus(v6);
    let v8 = functions::logistic(v6) * (c48 * v7) * functions::larger(v5, 0.0);
    let v9 = c131 * (y - yd);
    let v10 = functions::logistic(v9);
    let v11 = 1.0 - v10;
    let v12 = Rc - R * v11;
    let v13 = c155 - Rc * v1 + R * (y - wd * functions::softplus(v9));
    let v14 = -v12 * (kr * v12) - (k1 + kj * functions::logistic(c41 * (y - yb)));
    let v15 = c152 * (c157 * (v10 * v11) * v13 + v14 - 2.0 * (v4 + v8));
    let v16 = if v0 > 0.0 { ab } else { 0.0 };
    let v17 = if v5 > 0.0 { c49 } else { 0.0 };
    let v18 = math::tanh(u * c40);
    let v19 = c158 + c39 * v17 * (v7 * v7) - (c38 * v16 * (v3 * v3) + c50 * (1.0 - v18 * v18));
    let out = out.first_chunk_mut::<16>()?;
    [out[0], out[1], out[2], out[3], out[4], out[5], out[6]] = [0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0];
    [out[7], out[8], out[9], out[10], out[11], out[12]] = [0.0, v15, 0.0, c152 * v19, 0.0, 0.0];
    [out[13], out[14], out[15]] = [0.0, 0.0, 0.0];
    Some(())
}

/// The outputs in mode CHK.
fn outputs_chk(given: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let constants = given.constants.first_chunk::<156>()?;
    let state = given.state.first_chunk::<3>()?;
    let input = given.input;
    let R = constants[0];
    let ybed = constants[9];
    let kr = constants[25];
    let yd = constants[28];
    let wd = constants[29];
    let Rc = constants[31];
    let k1 = constants[35];
    let b1 = constants[36];
    let c131 = constants[131];
    let c155 = constants[155];
    let y = state[0];
    let u = state[2];
    let s = input[0];
    let s_rate = input[1];
    let v0 = R * (y - wd * functions::softplus(c131 * (y - yd)));
    let out = out.first_chunk_mut::<4>()?;
    out[0] = k1 * (s - y) + b1 * (s_rate - u);
    out[1] = 0.0;
    out[2] = kr * (c155 - Rc * (y - ybed) + v0);
    out[3] = 0.0;
    Some(())
}

/// Energy, supplied and dissipated power in mode CHK.
fn balance_chk(given: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let constants = given.constants.first_chunk::<161>()?;
    let state = given.state.first_chunk::<3>()?;
    let input = given.input;
    let R = constants[0];
    let mk = constants[1];
    let Wk = constants[4];
    let ck = constants[5];
    let Fc = constants[6];
    let ybed = constants[9];
    let ab = constants[11];
    let ar = constants[14];
    let yb = constants[15];
    let kr = constants[25];
    let yd = constants[28];
    let wd = constants[29];
    let zc = constants[30];
    let Rc = constants[31];
    let k1 = constants[35];
    let b1 = constants[36];
    let c37 = constants[37];
    let c38 = constants[38];
    let c39 = constants[39];
    let c40 = constants[40];
    let c41 = constants[41];
    let c44 = constants[44];
    let c53 = constants[53];
    let c54 = constants[54];
    let c55 = constants[55];
    let c131 = constants[131];
    let c155 = constants[155];
    let c159 = constants[159];
    let c160 = constants[160];
    let y = state[0];
    let u = state[2];
    let s = input[0];
    let s_rate = input[1];
    let v0 = s - y;
    let v1 = k1 * v0;
    let v2 = y - ybed;
    let v3 = c37 * v2;
    let v4 = -(y * c37);
    let v5 = Rc * v2;
    let v6 = R * (y - wd * functions::softplus(c131 * (y - yd)));
    let v7 = c155 - v5 + v6;
    let v8 = c44 * (zc + v5) + (y * Wk + u * u * (0.5 * (mk + c159)));
    let v9 = c53 * functions::softplus_area(c41 * (y - yb));
    let v10 = v8 + c55 * functions::softplus_square_area(v4);
    let v11 = v10 + (v9 + c54 * functions::softplus_square_area(v3));
    let v12 = s_rate - u;
    let v13 = b1 * v12;
    let v14 = functions::softplus(v3);
    let v15 = c38 * (functions::larger(1.0 + u * ab, 0.0) - 1.0);
    let v16 = functions::softplus(v4);
    let v17 = c39 * (functions::larger(1.0 - u * ar, 0.0) - 1.0);
    let v18 = u * c160 + (u * ck + Fc * math::tanh(u * c40)) + v14 * v14 * v15;
    let out = out.first_chunk_mut::<3>()?;
    out[0] = v11 + 0.5 * (v0 * v1 + v7 * (kr * v7));
    out[1] = s_rate * (v1 + v13);
    out[2] = v12 * v13 + u * (v18 - v16 * v16 * v17);
    Some(())
}

/// The state after guard check_off in mode CHK.
fn reset_0_check_off_chk(given: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let constants = given.constants.first_chunk::<32>()?;
    let state = given.state.first_chunk::<3>()?;
    let ybed = constants[9];
    let zc = constants[30];
    let Rc = constants[31];
    let y = state[0];
    let u = state[2];
    let out = out.first_chunk_mut::<5>()?;
    out[0] = y;
    out[1] = zc + Rc * (y - ybed);
    [out[2], out[3], out[4]] = [u, Rc * u, 0.0];
    Some(())
}

/// The guard and its rate: check_off in mode CHK.
fn guard_check_off_chk(given: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let constants = given.constants.first_chunk::<34>()?;
    let state = given.state.first_chunk::<3>()?;
    let yco = constants[33];
    let y = state[0];
    let u = state[2];
    let out = out.first_chunk_mut::<2>()?;
    [out[0], out[1]] = [y - yco, u];
    Some(())
}

/// Where the Taylor series begins in mode CHK.
fn series_start_chk(given: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let constants = given.constants.first_chunk::<157>()?;
    let state = given.state.first_chunk::<3>()?;
    let input = given.input;
    let R = constants[0];
    let Wk = constants[4];
    let ck = constants[5];
    let Fc = constants[6];
    let ybed = constants[9];
    let ab = constants[11];
    let ar = constants[14];
    let yb = constants[15];
    let kr = constants[25];
    let yd = constants[28];
    let wd = constants[29];
    let zc = constants[30];
    let Rc = constants[31];
    let yco = constants[33];
    let k1 = constants[35];
    let b1 = constants[36];
    let c37 = constants[37];
    let c38 = constants[38];
    let c39 = constants[39];
    let c40 = constants[40];
    let c41 = constants[41];
    let c42 = constants[42];
    let c44 = constants[44];
    let c131 = constants[131];
    let c152 = constants[152];
    let c155 = constants[155];
    let c156 = constants[156];
    let y = state[0];
    let u = state[2];
    let s = input[0];
    let s_rate = input[1];
    let v0 = 1.0 + u * ab;
    let v1 = v0 - 0.0;
    let v2 = if v1 > 0.0 { v0 } else { 0.0 };
    let v3 = y - ybed;
    let v4 = c37 * v3;
    let v5 = functions::logistic(v4);
    let v6 = functions::softplus(v4);
    let v7 = c38 * (v6 * v6);
    let v8 = 1.0 - u * ar;
    let v9 = v8 - 0.0;
    let v10 = if v9 > 0.0 { v8 } else { 0.0 };
    let v11 = -(y * c37);
    let v12 = functions::logistic(v11);
    let v13 = functions::softplus(v11);
    let v14 = c39 * (v13 * v13);
    let v15 = u * c40;
    let v16 = math::tanh(v15);
    let v17 = c41 * (y - yb);
    let v18 = functions::logistic(v17);
    let v19 = Rc * v3;
    let v20 = c131 * (y - yd);
    let v21 = functions::logistic(v20);
    let v22 = c155 - v19 + R * (y - wd * functions::softplus(v20));
    let v23 = kr * (Rc - R * (1.0 - v21));
    let v24 = k1 * (s - y) + b1 * (s_rate - u) - (Wk + u * ck + Rc * (c44 + u * c156));
    let v25 = v24 - Fc * v16 - c42 * functions::softplus(v17) + v22 * v23;
    let v26 = v4.abs();
    let v27 = if v26 - 20.0 > 0.0 { 20.0 } else { 10.0 };
    let v28 = if v26 - 40.0 > 0.0 { 40.0 } else { v27 };
    let v29 = v26 - v28;
    let v30 = v29 - 0.0;
    let v31 = if v30 > 0.0 { v29 } else { 0.0 };
    let v32 = v11.abs();
    let v33 = if v32 - 20.0 > 0.0 { 20.0 } else { 10.0 };
    let v34 = if v32 - 40.0 > 0.0 { 40.0 } else { v33 };
    let v35 = v32 - v34;
    let v36 = v35 - 0.0;
    let v37 = if v36 > 0.0 { v35 } else { 0.0 };
    let v38 = v17.abs();
    let v39 = if v38 - 20.0 > 0.0 { 20.0 } else { 10.0 };
    let v40 = if v38 - 40.0 > 0.0 { 40.0 } else { v39 };
    let v41 = v38 - v40;
    let v42 = v41 - 0.0;
    let v43 = if v42 > 0.0 { v41 } else { 0.0 };
    let v44 = v20.abs();
    let v45 = if v44 - 20.0 > 0.0 { 20.0 } else { 10.0 };
    let v46 = if v44 - 40.0 > 0.0 { 40.0 } else { v45 };
    let v47 = v44 - v46;
    let v48 = v47 - 0.0;
    let v49 = if v48 > 0.0 { v47 } else { 0.0 };
    let v50 = v15.abs();
    let v51 = v50 + v50;
    let v52 = if v51 - 20.0 > 0.0 { 20.0 } else { 10.0 };
    let v53 = if v51 - 40.0 > 0.0 { 40.0 } else { v52 };
    let v54 = v51 - v53;
    let v55 = v54 - 0.0;
    let v56 = if v55 > 0.0 { v54 } else { 0.0 };
    let out = out.first_chunk_mut::<46>()?;
    out[0] = u;
    out[1] = c152 * (v25 + (v14 * v10 - v7 * v2));
    [out[2], out[3], out[4], out[5], out[6], out[7]] = [zc + v19, u * Rc, y - yco, v1, v9, v31];
    [out[8], out[9], out[10], out[11], out[12], out[13]] = [v37, v43, v49, v56, v1, v5 - v5 * v5];
    [out[14], out[15], out[16], out[17], out[18], out[19]] = [v5 + v5, v5, v6 + v6, v7, v2, v9];
    out[20] = v12 - v12 * v12;
    [out[21], out[22], out[23], out[24], out[25]] = [v12 + v12, v12, v13 + v13, v14, v10];
    out[26] = 1.0 - v16 * v16;
    out[27] = v16 + v16;
    out[28] = v18 - v18 * v18;
    [out[29], out[30]] = [v18 + v18, v18];
    out[31] = v21 - v21 * v21;
    [out[32], out[33], out[34], out[35]] = [v21 + v21, v21, v22, v23];
    out[36] = functions::sign(v4);
    out[37] = v30;
    out[38] = functions::sign(v11);
    out[39] = v36;
    out[40] = functions::sign(v17);
    out[41] = v42;
    out[42] = functions::sign(v20);
    out[43] = v48;
    out[44] = functions::sign(v15);
    out[45] = v55;
    Some(())
}

/// One order of the Taylor series in mode CHK.
fn series_step_chk(given: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let constants = given.constants.first_chunk::<157>()?;
    let state = given.state.first_chunk::<3>()?;
    let extra = given.extra.first_chunk::<55>()?;
    let input = given.input;
    let R = constants[0];
    let ck = constants[5];
    let Fc = constants[6];
    let ab = constants[11];
    let ar = constants[14];
    let kr = constants[25];
    let wd = constants[29];
    let Rc = constants[31];
    let k1 = constants[35];
    let b1 = constants[36];
    let c37 = constants[37];
    let c38 = constants[38];
    let c39 = constants[39];
    let c40 = constants[40];
    let c41 = constants[41];
    let c42 = constants[42];
    let c131 = constants[131];
    let c152 = constants[152];
    let c156 = constants[156];
    let y = state[0];
    let u = state[2];
    let s = input[0];
    let s_rate = input[1];
    let v0 = ab * u;
    let v1 = if extra[2] > 0.0 { v0 } else { 0.0 };
    let v2 = c37 * y;
    let v3 = extra[36] * extra[1] + v2 * extra[3];
    let v4 = extra[38] * extra[1] + v2 * extra[5];
    let v5 = c38 * (extra[39] + extra[6] * v4);
    let v6 = -(ar * u);
    let v7 = if extra[9] > 0.0 { v6 } else { 0.0 };
    let v8 = -v2;
    let v9 = extra[41] * extra[1] + v8 * extra[10];
    let v10 = extra[43] * extra[1] + v8 * extra[12];
    let v11 = c39 * (extra[44] + extra[13] * v10);
    let v12 = c40 * u;
    let v13 = extra[46] * extra[1] + v12 * extra[16];
    let v14 = c41 * y;
    let v15 = extra[48] * extra[1] + v14 * extra[18];
    let v16 = Rc * y;
    let v17 = c131 * y;
    let v18 = extra[51] * extra[1] + v17 * extra[21];
    let v19 = y - wd * (extra[53] * extra[1] + v17 * extra[23]);
    let v20 = -v16 + R * v19;
    let v21 = kr * -(R * -v18);
    let v22 = k1 * (s - y) + b1 * (s_rate - u) - (ck * u + Rc * (c156 * u));
    let v23 = v22 - Fc * v13 - c42 * (extra[50] * extra[1] + v14 * extra[20]);
    let v24 = v23 + (extra[54] + extra[24] * v21 + v20 * extra[25]);
    let v25 = extra[45] + extra[14] * v7 + v11 * extra[15];
    let v26 = v25 - (extra[40] + extra[7] * v1 + v5 * extra[8]);
    let v27 = if extra[27] > 0.0 { extra[26] * v2 } else { 0.0 };
    let v28 = if extra[29] > 0.0 { extra[28] * v8 } else { 0.0 };
    let v29 = if extra[31] > 0.0 { extra[30] * v14 } else { 0.0 };
    let v30 = if extra[33] > 0.0 { extra[32] * v17 } else { 0.0 };
    let v31 = extra[34] * v12;
    let v32 = if extra[35] > 0.0 { v31 + v31 } else { 0.0 };
    let v33 = extra[0] * v2;
    let v34 = extra[0] * v8;
    let v35 = extra[0] * v14;
    let v36 = extra[0] * v17;
    let out = out.first_chunk_mut::<50>()?;
    out[0] = u;
    out[1] = c152 * (v24 + v26);
    [out[2], out[3], out[4], out[5], out[6], out[7], out[8]] = [v16, Rc * u, y, v0, v6, v27, v28];
    [out[9], out[10], out[11], out[12], out[13], out[14]] = [v29, v30, v32, v33, v3, v33];
    [out[15], out[16], out[17], out[18], out[19], out[20]] = [v4, v5, v34, v9, v34, v10];
    out[21] = v11;
    out[22] = extra[0] * v12;
    [out[23], out[24], out[25], out[26], out[27], out[28]] = [v13, v35, v15, v35, v36, v18];
    [out[29], out[30]] = [v36, v20];
    out[31] = v3 - (extra[37] + extra[4] * v3);
    [out[32], out[33], out[34], out[35]] = [v3, v3, v4, v1];
    out[36] = v9 - (extra[42] + extra[11] * v9);
    [out[37], out[38], out[39], out[40]] = [v9, v9, v10, v7];
    out[41] = -(extra[47] + extra[17] * v13);
    out[42] = v13;
    out[43] = v15 - (extra[49] + extra[19] * v15);
    [out[44], out[45]] = [v15, v15];
    out[46] = v18 - (extra[52] + extra[22] * v18);
    [out[47], out[48], out[49]] = [v18, v18, v21];
    Some(())
}

/// The state to start from.
fn rest(_: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let out = out.first_chunk_mut::<4>()?;
    [out[0], out[1], out[2], out[3]] = [0.0, 0.0, 0.0, 0.0];
    Some(())
}

/// The preset default.
fn preset_default(_: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let out = out.first_chunk_mut::<37>()?;
    [out[0], out[1], out[2], out[3], out[4], out[5]] = [5.0, 0.15, 0.0112, 9.81, -0.18, 0.4];
    [out[6], out[7], out[8], out[9], out[10]] = [0.12, 0.004, 0.002, 0.01, 20_000_000.0];
    [out[11], out[12], out[13], out[14], out[15]] = [1.0, 5e-5, 20_000_000.0, 1.0, 0.0082];
    [out[16], out[17], out[18], out[19], out[20], out[21]] = [0.0435, 0.1, 5.0, 250.0, 5e-5, 0.045];
    out[22] = 1_000_000_000.0;
    [out[23], out[24], out[25], out[26], out[27], out[28]] = [2.5, 0.1, 45.0, 4.0, 0.003, 0.008];
    [out[29], out[30], out[31], out[32], out[33]] = [0.0002, 0.032, 1.5, 0.0085, 0.0078];
    [out[34], out[35], out[36]] = [0.007, 8000.0, 20.0];
    Some(())
}

/// The preset playable.
fn preset_playable(given: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let extra = given.extra.first_chunk::<1>()?;
    let v0 = 0.003_058_169_4 * extra[0] - 0.164_301_830_600_000_03;
    let out = out.first_chunk_mut::<37>()?;
    [out[0], out[1]] = [5.0, 0.15];
    out[2] = 0.011_137_652 - 6.2348e-5 * extra[0];
    out[3] = 9.81;
    out[4] = functions::larger(v0, -0.04);
    [out[5], out[6], out[7], out[8], out[9]] = [0.4, 0.0, 0.004, 0.002, 0.01];
    [out[10], out[11], out[12], out[13], out[14]] = [20_000_000.0, 1.0, 5e-5, 20_000_000.0, 1.0];
    [out[15], out[16], out[17], out[18], out[19]] = [0.0082, 0.0435, 0.1, 5.0, 250.0];
    [out[20], out[21]] = [5e-5, 0.045];
    out[22] = 1_000_000_000.0;
    [out[23], out[24], out[25], out[26], out[27], out[28]] = [2.5, 0.1, 45.0, 4.0, 0.003, 0.008];
    [out[29], out[30], out[31], out[32], out[33]] = [0.0005, 0.032, 0.2, 0.0085, 0.0078];
    [out[34], out[35], out[36]] = [0.007, 8000.0, 20.0];
    Some(())
}

/// Input per metre of key-front travel.
fn input_per_metre(_: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let out = out.first_chunk_mut::<1>()?;
    out[0] = 1.0;
    Some(())
}

/// What follows from the parameters.
fn derived_constants(given: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let constants = given.constants.first_chunk::<37>()?;
    let R = constants[0];
    let mk = constants[1];
    let mh = constants[2];
    let g = constants[3];
    let ck = constants[5];
    let Fc = constants[6];
    let vc = constants[7];
    let ch = constants[8];
    let Kb = constants[10];
    let ab = constants[11];
    let wf = constants[12];
    let Kr = constants[13];
    let ar = constants[14];
    let yb = constants[15];
    let zt = constants[16];
    let rho = constants[17];
    let nu = constants[18];
    let kj = constants[19];
    let wj = constants[20];
    let Ks = constants[22];
    let ps = constants[23];
    let kr = constants[25];
    let cr = constants[26];
    let o_r = constants[27];
    let wd = constants[29];
    let zc = constants[30];
    let Rc = constants[31];
    let k1 = constants[35];
    let b1 = constants[36];
    let v0 = 1.0 / wf;
    let v1 = wf * Kb;
    let v2 = wf * v1;
    let v3 = wf * Kr;
    let v4 = wf * v3;
    let v5 = 1.0 / vc;
    let v6 = 1.0 / wj;
    let v7 = wj * kj;
    let v8 = R * ch;
    let v9 = R * mh;
    let v10 = R * v9;
    let v11 = 1.0 / (mk + v10);
    let v12 = Fc * v5;
    let v13 = R * v8;
    let v14 = b1 + ck;
    let v15 = 1.0 / mk;
    let v16 = v9 * v15;
    let v17 = v0.abs();
    let v18 = v6.abs();
    let v19 = v15.abs();
    let v20 = R.abs();
    let v21 = mh.abs();
    let v22 = v20 * v21;
    let v23 = v22 * v19;
    let v24 = kj * v6;
    let v25 = Kb.abs();
    let v26 = Kr.abs();
    let v27 = v5.abs();
    let v28 = v5 * v12;
    let v29 = v27 * v28.abs();
    let v30 = k1.abs();
    let v31 = b1.abs();
    let v32 = R * yb;
    let v33 = 2.0 * ((zt - v32) / (R * (1.0 + rho)));
    let v34 = functions::larger(v33, 1e-6);
    let v35 = 1.0 / v34;
    let v36 = (1.0 - rho) * v35;
    let v37 = R * v34;
    let v38 = v35 * (nu * v35);
    let v39 = v9 * v36;
    let v40 = v5 * v38;
    let v41 = v34 * v37;
    let v42 = v16 * v36;
    let v43 = v35.abs();
    let v44 = (rho - 1.0).abs() * v43;
    let v45 = v20 * v44;
    let v46 = f64::INFINITY - v33.abs();
    let v47 = if v46 > 0.0 { 0.0 } else { f64::INFINITY };
    let v48 = 1.0 / mh;
    let v49 = ch * v48;
    let v50 = 1.0 / wd;
    let v51 = v50.abs();
    let v52 = Ks * v48;
    let v53 = R * kr;
    let v54 = v53 * v15;
    let v55 = R * v54;
    let v56 = cr * v55;
    let v57 = cr * v48;
    let v58 = v53 * v50;
    let v59 = R * v50;
    let v60 = mh * Rc;
    let v61 = Rc * v60;
    let v62 = 1.0 / (mk + v61);
    let v63 = ch * Rc;
    let v64 = Rc * v63;
    let out = out.first_chunk_mut::<124>()?;
    [out[0], out[1], out[2], out[3], out[4], out[5], out[6]] = [v0, v2, v4, v5, v6, v7, v8];
    [out[7], out[8], out[9], out[10], out[11], out[12]] = [mh * g, v11, R * v11, v1, v3, -ar];
    [out[13], out[14], out[15], out[16], out[17]] = [v12, -(v14 + v13), v9 * v11, wj * v7, wf * v2];
    [out[18], out[19], out[20], out[21], out[22]] = [wf * v4, v10, g * v9, v13, v16];
    [out[23], out[24], out[25], out[26]] = [ab * v11, ar * v11, v12 * v11, ck * v11];
    [out[27], out[28], out[29], out[30], out[31]] = [v8 * v11, -v14, ab.abs(), ar.abs(), v17];
    out[32] = v18;
    out[33] = v1.abs() * v17;
    out[34] = v3.abs() * v17;
    out[35] = kj.abs() * v18;
    [out[36], out[37], out[38], out[39], out[40]] = [v23, v24, v25, v25 * v17, v26];
    [out[41], out[42], out[43]] = [v26 * v17, v24.abs(), v27];
    out[44] = v2.abs() * v17;
    out[45] = v4.abs() * v17;
    out[46] = v27 * v12.abs();
    [out[47], out[48], out[49], out[50]] = [v16.abs(), v16 * v28, v23 * v29, v30 * v23];
    [out[51], out[52], out[53], out[54], out[55]] = [v31 * v23, v35, v35 * v36, v37, v32];
    [out[56], out[57], out[58], out[59], out[60]] = [v36, v38, R * v36, v9, v35 * v38];
    [out[61], out[62], out[63], out[64], out[65]] = [v8 * v36, v39, v40, v9 * v40, v9 * v41];
    [out[66], out[67], out[68], out[69], out[70]] = [v8 * v41, v42, v14, R * v28, v30];
    out[71] = v31;
    out[72] = Fc.abs() * v27;
    out[73] = ck.abs();
    out[74] = v7.abs() * v18;
    out[75] = v44;
    out[76] = ch.abs() * v45;
    out[77] = v19 * v39.abs();
    [out[78], out[79], out[80], out[81]] = [v23 * v44, v42.abs(), v22 * v44, v20 * v29];
    [out[82], out[83]] = [v21 * v19, 2.0 * v39];
    out[84] = (k1 * v42).abs();
    out[85] = (b1 * v42).abs();
    [out[86], out[87], out[88], out[89], out[90], out[91]] = [v47, yb + v34, v15, v49, -v49, v20];
    out[92] = v44 * (v37.abs() * v43);
    [out[93], out[94], out[95], out[96], out[97]] = [v45, v50, v51, v20 * v51, v52];
    [out[98], out[99]] = [ps - 1.0, ps * v52];
    out[100] = Ks / (1.0 + ps);
    [out[101], out[102], out[103], out[104], out[105]] = [v54, kr * v48, v50 * v54, v55, v50 * v56];
    [out[106], out[107], out[108], out[109]] = [v53 * v48, v57 * v58, v56, v53 * v57];
    [out[110], out[111], out[112], out[113], out[114]] = [cr * v54, kr * v57, v59, v59.abs(), v60];
    [out[115], out[116], out[117], out[118], out[119]] = [v62, Rc * v62, Rc.abs(), o_r - zc, v63];
    [out[120], out[121], out[122], out[123]] = [v58, -(v14 + v64), v61, v64];
    Some(())
}
