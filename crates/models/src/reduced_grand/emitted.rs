//! Emitted from `the description of reduced-grand` by `letoff model emit`; not to be changed by hand.
#![allow(
    non_snake_case,
    unreachable_pub,
    clippy::allow_attributes,
    clippy::inline_always,
    clippy::large_stack_frames,
    clippy::suspicious_operation_groupings,
    clippy::too_many_lines,
    clippy::unnecessary_wraps,
    reason = "names as in the description, straight lines of operations: what applies varies"
)]

use equations::functions;
use equations::table::{
    Arguments, BodyTable, DamperTable, DrawingTable, Freedom, FunctionId, Functions, GuardTable,
    Material, MidiTable, ModeTable, ModelTable, NamedQuantity, OutlineTable, ParameterTable,
    PartTable, PresetTable, RequirementTable, RestTable, SeriesTable, SpringTable, WayTable,
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
            values: 102,
        },
        PresetTable {
            name: "playable",
            doc: "hammers graded over the compass, and a key that comes up by itself from everywhere",
            values: 103,
        },
    ],
    requirements: &[
        RequirementTable { text: "zt > R*yb", margin: 104 },
        RequirementTable { text: "zs > zt", margin: 105 },
        RequirementTable { text: "yck > yco", margin: 106 },
    ],
    states: &[
        NamedQuantity { name: "y", unit: "m" },
        NamedQuantity { name: "z", unit: "m" },
        NamedQuantity { name: "u", unit: "m/s" },
        NamedQuantity { name: "w", unit: "m/s" },
    ],
    coordinates: 2,
    constants: 178,
    derive_constants: 109,
    input: NamedQuantity { name: "s", unit: "m" },
    input_per_metre: 107,
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
            outputs: 45,
            balance: 35,
            jacobian: 33,
            series: Some(SeriesTable {
                start: 49,
                step: 50,
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
                    value: 47,
                    bound: Some(48),
                    ways: &[WayTable { when: None, to: 1, reset: Some(46), resting: None }],
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
            outputs: 51,
            balance: 35,
            jacobian: 33,
            series: Some(SeriesTable {
                start: 57,
                step: 58,
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
                    value: 53,
                    bound: Some(54),
                    ways: &[
                        WayTable { when: Some(52), to: 7, reset: None, resting: None },
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
                    value: 56,
                    bound: Some(13),
                    ways: &[
                        WayTable { when: Some(55), to: 2, reset: None, resting: None },
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
            derivative: 59,
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
                    derivative: 60,
                    kind: EquationKind::Smooth,
                    loss: Some(61),
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
            outputs: 63,
            balance: 64,
            jacobian: 62,
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
                    value: 66,
                    bound: Some(42),
                    ways: &[
                        WayTable { when: Some(65), to: 2, reset: None, resting: None },
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
            derivative: 59,
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
                    derivative: 60,
                    kind: EquationKind::Smooth,
                    loss: Some(61),
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
            outputs: 69,
            balance: 64,
            jacobian: 62,
            series: Some(SeriesTable {
                start: 70,
                step: 71,
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
                    value: 66,
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
                    value: 56,
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
            derivative: 72,
            parts: &[PartTable {
                entries: 0xf,
                derivative: 72,
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
            outputs: 74,
            balance: 75,
            jacobian: 73,
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
                    value: 76,
                    bound: Some(77),
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
                    value: 79,
                    bound: Some(80),
                    ways: &[WayTable { when: None, to: 10, reset: Some(78), resting: None }],
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
                    value: 81,
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
            derivative: 72,
            parts: &[PartTable {
                entries: 0xf,
                derivative: 72,
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
            outputs: 74,
            balance: 75,
            jacobian: 73,
            series: Some(SeriesTable {
                start: 85,
                step: 86,
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
                    value: 76,
                    bound: Some(77),
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
                    value: 84,
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
                    value: 56,
                    bound: Some(13),
                    ways: &[
                        WayTable { when: Some(55), to: 2, reset: None, resting: None },
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
            derivative: 72,
            parts: &[PartTable {
                entries: 0xf,
                derivative: 72,
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
            outputs: 74,
            balance: 75,
            jacobian: 73,
            series: Some(SeriesTable {
                start: 89,
                step: 90,
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
                    value: 76,
                    bound: Some(77),
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
                    value: 87,
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
                    value: 88,
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
            derivative: 91,
            parts: &[PartTable {
                entries: 0x5,
                derivative: 92,
                kind: EquationKind::Smooth,
                loss: None,
                reads: Reads::StateAndInput,
            }],
            part_list: &[Part::of(&[0, 2])],
            slaved: Some(93),
            projection: None,
            projected: 0,
            longest_projection: None,
            readout: 4,
            slopes: 5,
            outputs: 95,
            balance: 96,
            jacobian: 94,
            series: Some(SeriesTable {
                start: 99,
                step: 100,
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
                value: 98,
                bound: Some(13),
                ways: &[WayTable { when: None, to: 8, reset: Some(97), resting: None }],
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
        NamedQuantity { name: "key.x", unit: "m" },
        NamedQuantity { name: "key.y", unit: "m" },
        NamedQuantity { name: "key.angle", unit: "rad" },
        NamedQuantity { name: "whippen.x", unit: "m" },
        NamedQuantity { name: "whippen.y", unit: "m" },
        NamedQuantity { name: "whippen.angle", unit: "rad" },
        NamedQuantity { name: "jack.x", unit: "m" },
        NamedQuantity { name: "jack.y", unit: "m" },
        NamedQuantity { name: "jack.angle", unit: "rad" },
        NamedQuantity { name: "lever.x", unit: "m" },
        NamedQuantity { name: "lever.y", unit: "m" },
        NamedQuantity { name: "lever.angle", unit: "rad" },
        NamedQuantity { name: "hammer.x", unit: "m" },
        NamedQuantity { name: "hammer.y", unit: "m" },
        NamedQuantity { name: "hammer.angle", unit: "rad" },
        NamedQuantity { name: "finger.x", unit: "m" },
        NamedQuantity { name: "finger.y", unit: "m" },
        NamedQuantity { name: "finger.angle", unit: "rad" },
    ],
    rest: RestTable { mode: 0, instead: &[], state: 108, is_improved: true },
    damper: Some(DamperTable { lift: 0.005, fall: 0.0046, softest_tone: 0.15 }),
    midi: MidiTable { speeds: None, velocity: None, pressure: None },
    drawing: DrawingTable {
        numbers: 101,
        count: 738,
        bodies: &[
            BodyTable {
                name: "string",
                output: None,
                outlines: &[OutlineTable {
                    material: Material::String,
                    is_closed: false,
                    points: (4, 2),
                    modes: &[],
                }],
            },
            BodyTable {
                name: "key frame",
                output: None,
                outlines: &[
                    OutlineTable {
                        material: Material::Ground,
                        is_closed: true,
                        points: (8, 5),
                        modes: &[],
                    },
                    OutlineTable {
                        material: Material::Metal,
                        is_closed: false,
                        points: (18, 2),
                        modes: &[],
                    },
                    OutlineTable {
                        material: Material::Felt,
                        is_closed: true,
                        points: (22, 4),
                        modes: &[],
                    },
                    OutlineTable {
                        material: Material::Felt,
                        is_closed: true,
                        points: (30, 4),
                        modes: &[],
                    },
                ],
            },
            BodyTable {
                name: "hammer rail",
                output: None,
                outlines: &[
                    OutlineTable {
                        material: Material::Ground,
                        is_closed: true,
                        points: (38, 4),
                        modes: &[],
                    },
                    OutlineTable {
                        material: Material::Wood,
                        is_closed: true,
                        points: (46, 4),
                        modes: &[],
                    },
                    OutlineTable {
                        material: Material::Metal,
                        is_closed: false,
                        points: (54, 2),
                        modes: &[],
                    },
                    OutlineTable {
                        material: Material::Metal,
                        is_closed: true,
                        points: (58, 4),
                        modes: &[],
                    },
                ],
            },
            BodyTable {
                name: "let-off button",
                output: None,
                outlines: &[
                    OutlineTable {
                        material: Material::Ground,
                        is_closed: true,
                        points: (66, 4),
                        modes: &[],
                    },
                    OutlineTable {
                        material: Material::Metal,
                        is_closed: false,
                        points: (74, 3),
                        modes: &[],
                    },
                    OutlineTable {
                        material: Material::Felt,
                        is_closed: true,
                        points: (80, 4),
                        modes: &[],
                    },
                ],
            },
            BodyTable {
                name: "whippen rail",
                output: None,
                outlines: &[
                    OutlineTable {
                        material: Material::Wood,
                        is_closed: true,
                        points: (88, 4),
                        modes: &[],
                    },
                    OutlineTable {
                        material: Material::Ground,
                        is_closed: true,
                        points: (96, 4),
                        modes: &[],
                    },
                ],
            },
            BodyTable {
                name: "key",
                output: Some(4),
                outlines: &[
                    OutlineTable {
                        material: Material::Wood,
                        is_closed: true,
                        points: (104, 4),
                        modes: &[],
                    },
                    OutlineTable {
                        material: Material::Metal,
                        is_closed: true,
                        points: (112, 24),
                        modes: &[],
                    },
                    OutlineTable {
                        material: Material::Metal,
                        is_closed: true,
                        points: (160, 24),
                        modes: &[],
                    },
                    OutlineTable {
                        material: Material::Metal,
                        is_closed: true,
                        points: (208, 24),
                        modes: &[],
                    },
                    OutlineTable {
                        material: Material::Metal,
                        is_closed: true,
                        points: (256, 4),
                        modes: &[],
                    },
                    OutlineTable {
                        material: Material::Metal,
                        is_closed: true,
                        points: (264, 24),
                        modes: &[],
                    },
                    OutlineTable {
                        material: Material::Metal,
                        is_closed: false,
                        points: (312, 2),
                        modes: &[],
                    },
                    OutlineTable {
                        material: Material::Wood,
                        is_closed: true,
                        points: (316, 4),
                        modes: &[],
                    },
                    OutlineTable {
                        material: Material::Felt,
                        is_closed: true,
                        points: (324, 4),
                        modes: &[],
                    },
                ],
            },
            BodyTable {
                name: "whippen",
                output: Some(7),
                outlines: &[
                    OutlineTable {
                        material: Material::Wood,
                        is_closed: true,
                        points: (332, 14),
                        modes: &[],
                    },
                    OutlineTable {
                        material: Material::Felt,
                        is_closed: true,
                        points: (360, 4),
                        modes: &[],
                    },
                    OutlineTable {
                        material: Material::Metal,
                        is_closed: true,
                        points: (368, 24),
                        modes: &[],
                    },
                ],
            },
            BodyTable {
                name: "jack",
                output: Some(10),
                outlines: &[
                    OutlineTable {
                        material: Material::Wood,
                        is_closed: true,
                        points: (416, 12),
                        modes: &[],
                    },
                    OutlineTable {
                        material: Material::Metal,
                        is_closed: true,
                        points: (440, 24),
                        modes: &[],
                    },
                ],
            },
            BodyTable {
                name: "repetition lever",
                output: Some(13),
                outlines: &[
                    OutlineTable {
                        material: Material::Wood,
                        is_closed: true,
                        points: (488, 7),
                        modes: &[],
                    },
                    OutlineTable {
                        material: Material::Metal,
                        is_closed: true,
                        points: (502, 24),
                        modes: &[],
                    },
                ],
            },
            BodyTable {
                name: "hammer",
                output: Some(16),
                outlines: &[
                    OutlineTable {
                        material: Material::Wood,
                        is_closed: true,
                        points: (550, 6),
                        modes: &[],
                    },
                    OutlineTable {
                        material: Material::Wood,
                        is_closed: true,
                        points: (562, 4),
                        modes: &[],
                    },
                    OutlineTable {
                        material: Material::Felt,
                        is_closed: true,
                        points: (570, 24),
                        modes: &[],
                    },
                    OutlineTable {
                        material: Material::Wood,
                        is_closed: true,
                        points: (618, 9),
                        modes: &[],
                    },
                    OutlineTable {
                        material: Material::Felt,
                        is_closed: true,
                        points: (636, 15),
                        modes: &[],
                    },
                    OutlineTable {
                        material: Material::Metal,
                        is_closed: true,
                        points: (666, 24),
                        modes: &[],
                    },
                ],
            },
            BodyTable {
                name: "finger",
                output: Some(19),
                outlines: &[OutlineTable {
                    material: Material::Finger,
                    is_closed: true,
                    points: (714, 8),
                    modes: &[],
                }],
            },
        ],
        springs: &[
            SpringTable { name: "kr", from: (6, 730), to: (8, 732), modes: &[] },
            SpringTable { name: "k1", from: (5, 734), to: (10, 736), modes: &[] },
        ],
    },
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
            45 => outputs_fll(given, out),
            46 => reset_0_land_fll(given, out),
            47 => guard_land_fll(given, out),
            48 => bound_land_fll(given, out),
            49 => series_start_fll(given, out),
            50 => series_step_fll(given, out),
            51 => outputs_flt(given, out),
            52 => when_0_rep_on_flt(given, out),
            53 => guard_rep_on_flt(given, out),
            54 => bound_rep_on_flt(given, out),
            55 => when_0_reset_flt(given, out),
            56 => guard_reset_flt(given, out),
            57 => series_start_flt(given, out),
            58 => series_step_flt(given, out),
            59 => derivative_stu(given, out),
            60 => part_1_stu(given, out),
            61 => function_61(given, out),
            62 => jacobian_stu(given, out),
            63 => outputs_stu(given, out),
            64 => balance_stu(given, out),
            65 => when_0_string_off_stu(given, out),
            66 => guard_string_off_stu(given, out),
            67 => series_start_stu(given, out),
            68 => series_step_stu(given, out),
            69 => outputs_stt(given, out),
            70 => series_start_stt(given, out),
            71 => series_step_stt(given, out),
            72 => derivative_reph(given, out),
            73 => jacobian_reph(given, out),
            74 => outputs_reph(given, out),
            75 => balance_reph(given, out),
            76 => guard_rep_off_reph(given, out),
            77 => bound_rep_off_reph(given, out),
            78 => reset_0_check_reph(given, out),
            79 => guard_check_reph(given, out),
            80 => bound_check_reph(given, out),
            81 => guard_check_far_reph(given, out),
            82 => series_start_reph(given, out),
            83 => series_step_reph(given, out),
            84 => guard_check_near_repl(given, out),
            85 => series_start_repl(given, out),
            86 => series_step_repl(given, out),
            87 => guard_jack_in_rep0(given, out),
            88 => guard_jack_out_rep0(given, out),
            89 => series_start_rep0(given, out),
            90 => series_step_rep0(given, out),
            91 => derivative_chk(given, out),
            92 => part_0_chk(given, out),
            93 => slaved_chk(given, out),
            94 => jacobian_chk(given, out),
            95 => outputs_chk(given, out),
            96 => balance_chk(given, out),
            97 => reset_0_check_off_chk(given, out),
            98 => guard_check_off_chk(given, out),
            99 => series_start_chk(given, out),
            100 => series_step_chk(given, out),
            101 => drawing(given, out),
            102 => preset_default(given, out),
            103 => preset_playable(given, out),
            104 => requirement_0(given, out),
            105 => requirement_1(given, out),
            106 => requirement_2(given, out),
            107 => input_per_metre(given, out),
            108 => rest(given, out),
            109 => derived_constants(given, out),
            _ => return,
        };
        if done.is_none() {
            out.fill(f64::NAN);
        }
    }

    #[inline(always)]
    fn readout(&self, function: FunctionId, given: &Arguments<'_>, out: &mut [f64]) {
        let done = match function {
            4 => readout_acc(given, out),
            _ => None,
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
#[inline(always)]
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
    let constants = given.constants.first_chunk::<63>()?;
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
    let c53 = constants[53];
    let c54 = constants[54];
    let c55 = constants[55];
    let c56 = constants[56];
    let c57 = constants[57];
    let c58 = constants[58];
    let c59 = constants[59];
    let c60 = constants[60];
    let c61 = constants[61];
    let c62 = constants[62];
    let y = state[0];
    let u = state[2];
    let s = input[0];
    let s_rate = input[1];
    let v0 = y * c53;
    let v1 = v0 - c55;
    let v2 = k1 * (s - y) + b1 * (s_rate - u);
    let v3 = functions::softplus(c37 * (y - ybed));
    let v4 = c38 * (v3 * v3) * functions::larger(1.0 + u * ab, 0.0);
    let v5 = functions::softplus(-(y * c37));
    let v6 = c39 * (v5 * v5) * functions::larger(1.0 - u * ar, 0.0);
    let v7 = c44 + u * c43;
    let v8 = v2 - (Wk + u * ck) - R * v7 - Fc * math::tanh(u * c40);
    let v9 = v8 - c42 * functions::softplus(c41 * (y - yb)) - v4;
    let v10 = c54 + v0;
    let (sin_v1, cos_v1) = math::sin_cos(v1);
    let out = out.first_chunk_mut::<22>()?;
    out[0] = v2;
    out[1] = v7 + c52 * (v6 + v9);
    [out[2], out[3], out[4], out[5]] = [0.0, 0.0, 0.0, 0.0];
    out[6] = c56 + 3.853_564_547_206_165_7 * y;
    [out[7], out[8], out[9]] = [0.1935, 0.042, v10];
    out[10] = 0.1935 - 0.072 * cos_v1;
    out[11] = 0.042 - 0.072 * sin_v1;
    out[12] = v10;
    out[13] = 0.1935 - 0.04 * cos_v1 - 0.047 * sin_v1;
    out[14] = 0.047 * cos_v1 + (0.042 - 0.04 * sin_v1);
    [out[15], out[16], out[17]] = [v10, c60, c61];
    out[18] = y * c58 - c59;
    [out[19], out[20], out[21]] = [c62, c57 - s, 0.0];
    Some(())
}

/// Energy, supplied and dissipated power in mode ACC.
fn balance_acc(given: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let constants = given.constants.first_chunk::<69>()?;
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
    let c63 = constants[63];
    let c64 = constants[64];
    let c65 = constants[65];
    let c66 = constants[66];
    let c67 = constants[67];
    let c68 = constants[68];
    let y = state[0];
    let u = state[2];
    let s = input[0];
    let s_rate = input[1];
    let v0 = s - y;
    let v1 = k1 * v0;
    let v2 = c37 * (y - ybed);
    let v3 = -(y * c37);
    let v4 = 0.5 * (v0 * v1) + (y * (Wk + c67) + u * u * (0.5 * (mk + c66)));
    let v5 = c63 * functions::softplus_area(c41 * (y - yb));
    let v6 = v4 + c65 * functions::softplus_square_area(v3);
    let v7 = v6 + (v5 + c64 * functions::softplus_square_area(v2));
    let v8 = s_rate - u;
    let v9 = b1 * v8;
    let v10 = functions::softplus(v2);
    let v11 = c38 * (functions::larger(1.0 + u * ab, 0.0) - 1.0);
    let v12 = functions::softplus(v3);
    let v13 = c39 * (functions::larger(1.0 - u * ar, 0.0) - 1.0);
    let v14 = u * c68 + (u * ck + Fc * math::tanh(u * c40)) + v10 * v10 * v11;
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
    let constants = given.constants.first_chunk::<75>()?;
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
    let c69 = constants[69];
    let c70 = constants[70];
    let c71 = constants[71];
    let c72 = constants[72];
    let c73 = constants[73];
    let c74 = constants[74];
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
    let v18 = if v1 > 0.0 { c70 * v16 } else { 0.0 };
    let v19 = if v6 > 0.0 { -(c71 * v16) } else { 0.0 };
    let v20 = k1 * v0 + u * -(kj * functions::logistic(v12) + 2.0 * v17);
    let v21 = -(c73 + c72 * (1.0 - v11 * v11)) * v16 + v20 + b1 * (s_rate2 - c45 * v16);
    let v22 = c69 * (v21 + (v10 * (v8 * v19) - v5 * (v3 * v18)));
    let out = out.first_chunk_mut::<2>()?;
    out[0] = v15 + c69 * v14;
    out[1] = c74 * v16 + v22;
    Some(())
}

/// Bounds of the guard's move and bend: lift_off in mode ACC.
fn bound_lift_off_acc(given: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let constants = given.constants.first_chunk::<99>()?;
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
    let c69 = constants[69];
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
    let c89 = constants[89];
    let c90 = constants[90];
    let c91 = constants[91];
    let c92 = constants[92];
    let c93 = constants[93];
    let c94 = constants[94];
    let c95 = constants[95];
    let c96 = constants[96];
    let c97 = constants[97];
    let c98 = constants[98];
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
    let v19 = extra[0] * c78;
    let v20 = functions::logistic(functions::larger(v2.abs() - v19, 0.0));
    let v21 = v20 * (1.0 - v20);
    let v22 = functions::logistic(functions::larger(v10.abs() - v19, 0.0));
    let v23 = v22 * (1.0 - v22);
    let v24 = 2.0 * ((v14 * v9).abs() * v23 + (v5 * v1).abs() * v21);
    let v25 = extra[0] * c79;
    let v26 = functions::logistic(functions::larger(v16.abs() - v25, 0.0));
    let v27 = v26 * (1.0 - v26);
    let v28 = v19 + v2;
    let v29 = functions::logistic(v28);
    let v30 = v0.abs();
    let v31 = extra[8] * c76;
    let v32 = v31 + v30;
    let v33 = extra[0] * v29 * (0.5 * (v32 + v32.abs()));
    let v34 = 0.5 * (v31 + v31.abs());
    let v35 = v5.abs();
    let v36 = v19 - v10;
    let v37 = functions::logistic(v36);
    let v38 = (v7 - 1.0).abs();
    let v39 = extra[8] * c77;
    let v40 = v39 + v38;
    let v41 = extra[0] * v37 * (0.5 * (v40 + v40.abs()));
    let v42 = 0.5 * (v39 + v39.abs());
    let v43 = v14.abs();
    let v44 = v29 * (v34 * v35 + c80 * v33) + v37 * (v42 * v43 + c81 * v41);
    let v45 = v18 + 2.0 * v44 + extra[0] * (c82 * v27 + c78 * v24);
    let v46 = v30 - v31;
    let v47 = if v0 > 0.0 { c76 } else { 0.0 };
    let v48 = if v46 > 0.0 { v47 } else { c76 };
    let v49 = c91 * (v48 * (functions::softplus(v28) + v4.abs()));
    let v50 = v38 - v39;
    let v51 = if v8 > 0.0 { c77 } else { 0.0 };
    let v52 = if v50 > 0.0 { v51 } else { c77 };
    let v53 = c92 * (v52 * (functions::softplus(v36) + v13.abs()));
    let v54 = if v0 > 0.0 { ab } else { 0.0 };
    let v55 = if v46 > 0.0 { 0.0 } else { c76 + v54.abs() };
    let v56 = v4 * (c38 * v4);
    let v57 = if v8 > 0.0 { c49 } else { 0.0 };
    let v58 = if v50 > 0.0 { 0.0 } else { c77 + v57.abs() };
    let v59 = v13 * (c39 * v13);
    let v60 = u * c40;
    let v61 = math::tanh(v60);
    let v62 = v61.abs();
    let v63 = functions::larger(v60.abs() - extra[8] * c90, 0.0);
    let v64 = math::tanh(v63);
    let v65 = 1.0 - v64 * v64;
    let v66 = extra[8] * v65;
    let v67 = v62 + functions::smaller(v62 + c90 * v66, 1.0);
    let v68 = v66 * v67;
    let v69 = v58 * v59.abs() + v55 * v56.abs() + extra[0] * (v37 * v53 + v29 * v49);
    let v70 = v61 * v61;
    let v71 = 1.0 - v70;
    let v72 = c69 * (c75 - c50 * v71 + (v57 * v59 - v54 * v56));
    let v73 = (c43 + v72).abs() + c94 * (v69 + c93 * v68);
    let v74 = extra[3] * (s_rate * c97 + s_rate2 * c98) + extra[0] * (c83 * v45);
    let v75 = if v46 > 0.0 { 0.0 } else { f64::INFINITY };
    let v76 = if v50 > 0.0 { 0.0 } else { f64::INFINITY };
    let v77 = v3 * (1.0 - v3);
    let v78 = v12 * (1.0 - v12);
    let v79 = c84 * (v17 * (1.0 - v17)) + Kb * (v1 * (2.0 * (v3 * v3 + v4 * v77)));
    let v80 = Kr * (-(2.0 * (v12 * v12 + v13 * v78)) * v9) + v79;
    let v81 = Kb * v1;
    let v82 = v29 + v3.abs();
    let v83 = Kr * v9;
    let v84 = v37 + v12.abs();
    let v85 = 2.0 * (v84 * v83.abs() * v23 + v82 * v81.abs() * v21);
    let v86 = v19 * v21;
    let v87 = v86 + v82 * v86;
    let v88 = (v34 * (Kb * v4).abs() + c86 * v33) * (v77.abs() + v87);
    let v89 = v19 * v23;
    let v90 = v89 + v84 * v89;
    let v91 = (v42 * (Kr * v13).abs() + c88 * v41) * (v78.abs() + v90);
    let v92 = 1.0 + (functions::logistic(v25 + v16) + v17.abs());
    let v93 = v29 * v34 * (c85 * v29) + c87 * v37 * (v37 * v42);
    let v94 = (v4 * v81).abs() * v87 + v91 + (v93 + (v13 * v83).abs() * v90 + v88);
    let v95 = v80.abs() + c89 * (extra[0] * (c79 * (v92 * v27)));
    let v96 = extra[1] * (extra[0] * (c78 * v85) + v95 + 2.0 * v94);
    let v97 = v48 * (extra[0] * (v29 * (c80 * v29) + c78 * v35 * v21));
    let v98 = v52 * (extra[0] * (v37 * (c81 * v37) + c78 * v43 * v23));
    let v99 = 2.0 * (v97 + (v58 * v15.abs() + v55 * v6.abs() + v98));
    let v100 = extra[9] * ((2.0 * (v57 * v15 + v54 * v6)).abs() + v99);
    let v101 = c83 * (extra[2] * v45 + extra[1] * (2.0 * v100 + v96));
    let v102 = extra[3] * extra[3] * (c97 * s_rate2 + c98 * s_rate3);
    let v103 = c95 * v61;
    let v104 = c90 * v103.abs() * v67 + c96 * ((v70 - 1.0).abs() + c90 * v68);
    let v105 = (2.0 * (v103 * v71)).abs() + extra[8] * (v65 * (2.0 * v104));
    let v106 = v76 + (v102 + v75) + v101 + extra[10] * v73 + extra[9] * (extra[9] * v105);
    let out = out.first_chunk_mut::<2>()?;
    out[0] = v74 + extra[8] * v73;
    out[1] = v106;
    Some(())
}

/// The state after guard button in mode ACC.
fn reset_0_button_acc(given: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let constants = given.constants.first_chunk::<103>()?;
    let state = given.state.first_chunk::<3>()?;
    let yb = constants[15];
    let c99 = constants[99];
    let c100 = constants[100];
    let c101 = constants[101];
    let c102 = constants[102];
    let y = state[0];
    let u = state[2];
    let v0 = y - yb;
    let v1 = c100 * v0;
    let out = out.first_chunk_mut::<5>()?;
    out[0] = y;
    out[1] = c102 + c101 * (v0 * (c99 - 0.5 * v1));
    out[2] = u;
    out[3] = c101 * u * (c99 - v1);
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
    let constants = given.constants.first_chunk::<70>()?;
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
    let c69 = constants[69];
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
    out[4] = v0 + c69 * v21;
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
    let constants = given.constants.first_chunk::<70>()?;
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
    let c69 = constants[69];
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
    out[4] = v0 + c69 * v20;
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
    let constants = given.constants.first_chunk::<107>()?;
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
    let c99 = constants[99];
    let c100 = constants[100];
    let c101 = constants[101];
    let c103 = constants[103];
    let c104 = constants[104];
    let c105 = constants[105];
    let c106 = constants[106];
    let y = state[0];
    let u = state[2];
    let s = input[0];
    let s_rate = input[1];
    let v0 = y - yb;
    let v1 = c101 * (c99 - c100 * v0);
    let v2 = functions::softplus(c37 * (y - ybed));
    let v3 = c38 * (v2 * v2) * functions::larger(1.0 + u * ab, 0.0);
    let v4 = functions::softplus(-(y * c37));
    let v5 = c39 * (v4 * v4) * functions::larger(1.0 - u * ar, 0.0);
    let v6 = math::tanh(u * c40);
    let v7 = 1.0 - c103 * v0;
    let v8 = 1.0 - c99 * v0;
    let v9 = R * v7 + 16.0 * (c104 * (v0 * v0) * (v8 * v8) * v6);
    let v10 = c105 * (u * u);
    let v11 = k1 * (s - y) + b1 * (s_rate - u) - (Wk + u * ck) - Fc * v6;
    let v12 = v11 - c42 * functions::softplus(c41 * v0) - (mh * (g - v10) + u * c43 * v7) * v9;
    let v13 = 1.0 / (mk + c106 * v7 * v9) * (v5 + (v12 - v3));
    let out = out.first_chunk_mut::<4>()?;
    [out[0], out[1], out[2]] = [u, u * v1, v13];
    out[3] = v1 * v13 - v10;
    Some(())
}

/// The derivative of a part in mode LO.
fn part_0_lo(given: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let constants = given.constants.first_chunk::<107>()?;
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
    let c99 = constants[99];
    let c103 = constants[103];
    let c104 = constants[104];
    let c105 = constants[105];
    let c106 = constants[106];
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
    let v6 = 1.0 - c103 * v5;
    let v7 = 1.0 - c99 * v5;
    let v8 = R * v6 + 16.0 * (c104 * (v5 * v5) * (v7 * v7) * v4);
    let v9 = k1 * (s - y) + b1 * (s_rate - u) - (Wk + u * ck) - Fc * v4;
    let v10 = (mh * (g - c105 * (u * u)) + u * c43 * v6) * v8;
    let v11 = v9 - c42 * functions::softplus(c41 * v5) - v10 - v1;
    let out = out.first_chunk_mut::<4>()?;
    [out[0], out[1]] = [u, 0.0];
    out[2] = (v3 + v11) / (mk + c106 * v6 * v8);
    out[3] = 0.0;
    Some(())
}

/// The state with slaved entries in place in mode LO.
fn slaved_lo(given: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let constants = given.constants.first_chunk::<103>()?;
    let state = given.state.first_chunk::<3>()?;
    let yb = constants[15];
    let c99 = constants[99];
    let c100 = constants[100];
    let c101 = constants[101];
    let c102 = constants[102];
    let y = state[0];
    let u = state[2];
    let v0 = y - yb;
    let v1 = c100 * v0;
    let out = out.first_chunk_mut::<4>()?;
    out[0] = y;
    out[1] = c102 + c101 * (v0 * (c99 - 0.5 * v1));
    out[2] = u;
    out[3] = c101 * u * (c99 - v1);
    Some(())
}

/// The derivative's derivative by the state in mode LO.
fn jacobian_lo(given: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let constants = given.constants.first_chunk::<112>()?;
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
    let c75 = constants[75];
    let c99 = constants[99];
    let c103 = constants[103];
    let c104 = constants[104];
    let c105 = constants[105];
    let c106 = constants[106];
    let c107 = constants[107];
    let c108 = constants[108];
    let c109 = constants[109];
    let c110 = constants[110];
    let c111 = constants[111];
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
    let v10 = 1.0 - c103 * v8;
    let v11 = c43 * v10;
    let v12 = mh * (g - c105 * (u * u)) + u * v11;
    let v13 = math::tanh(u * c40);
    let v14 = 1.0 - c99 * v8;
    let v15 = v8 * (v14 * (32.0 * (c104 * v14 - c107 * v8)) * v13);
    let v16 = v15 - c105;
    let v17 = v8 * v14;
    let v18 = R * v10 + 16.0 * (c104 * v17 * (v17 * v13));
    let v19 = functions::logistic(v2) * (c47 * v3) * v1;
    let v20 = 2.0 * (v19 + functions::logistic(v6) * (c48 * v7) * v5);
    let v21 = u * c108 * v18 - (k1 + kj * functions::logistic(v9) + v12 * v16);
    let v22 = c106 * v10;
    let v23 = v3 * (c38 * v3);
    let v24 = v7 * (c39 * v7);
    let v25 = k1 * (s - y) + b1 * (s_rate - u) - (Wk + u * ck) - Fc * v13;
    let v26 = v25 - c42 * functions::softplus(v9) - v12 * v18 - v23 * v1;
    let v27 = 1.0 / (mk + v22 * v18);
    let v28 = (v24 * v5 + v26) * v27;
    let v29 = v27 * (v21 - v20 - (v22 * v16 - c109 * v18) * v28);
    let v30 = 1.0 - v13 * v13;
    let v31 = if v0 > 0.0 { ab } else { 0.0 };
    let v32 = if v4 > 0.0 { c49 } else { 0.0 };
    let v33 = c75 + -(c50 + 16.0 * (v17 * v17 * (c110 * v12))) * v30;
    let v34 = v32 * v24 - v31 * v23 + (v33 - (v11 - 2.0 * (u * c109)) * v18);
    let v35 = v34 - 16.0 * (c111 * v10 * (v17 * (v17 * v30) * v28));
    let out = out.first_chunk_mut::<16>()?;
    [out[0], out[1], out[2], out[3], out[4], out[5], out[6]] = [0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0];
    [out[7], out[8], out[9], out[10], out[11], out[12]] = [0.0, v29, 0.0, v27 * v35, 0.0, 0.0];
    [out[13], out[14], out[15]] = [0.0, 0.0, 0.0];
    Some(())
}

/// The outputs in mode LO.
fn outputs_lo(given: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let constants = given.constants.first_chunk::<114>()?;
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
    let c53 = constants[53];
    let c54 = constants[54];
    let c55 = constants[55];
    let c56 = constants[56];
    let c57 = constants[57];
    let c59 = constants[59];
    let c60 = constants[60];
    let c61 = constants[61];
    let c62 = constants[62];
    let c99 = constants[99];
    let c100 = constants[100];
    let c101 = constants[101];
    let c102 = constants[102];
    let c103 = constants[103];
    let c104 = constants[104];
    let c105 = constants[105];
    let c106 = constants[106];
    let c112 = constants[112];
    let c113 = constants[113];
    let y = state[0];
    let u = state[2];
    let s = input[0];
    let s_rate = input[1];
    let v0 = y * c53;
    let v1 = v0 - c55;
    let v2 = k1 * (s - y) + b1 * (s_rate - u);
    let v3 = functions::softplus(c37 * (y - ybed));
    let v4 = c38 * (v3 * v3) * functions::larger(1.0 + u * ab, 0.0);
    let v5 = functions::softplus(-(y * c37));
    let v6 = c39 * (v5 * v5) * functions::larger(1.0 - u * ar, 0.0);
    let v7 = math::tanh(u * c40);
    let v8 = y - yb;
    let v9 = 1.0 - c103 * v8;
    let v10 = c99 * v8;
    let v11 = 1.0 - v10;
    let v12 = v8 * v8;
    let v13 = R * v9 + 16.0 * (c104 * v12 * (v11 * v11) * v7);
    let v14 = mh * (g - c105 * (u * u)) + u * c43 * v9;
    let v15 = v2 - (Wk + u * ck) - Fc * v7 - c42 * functions::softplus(c41 * v8);
    let v16 = c106 * v9;
    let v17 = v16 * (v6 + (v15 - v14 * v13 - v4)) / (mk + v16 * v13);
    let v18 = c54 + v0;
    let (sin_v1, cos_v1) = math::sin_cos(v1);
    let v19 = c113 * (c102 + c101 * (v10 - 0.5 * (c100 * v12)));
    let out = out.first_chunk_mut::<22>()?;
    [out[0], out[1], out[2], out[3], out[4], out[5]] = [v2, v14 + v17, 0.0, 0.0, 0.0, 0.0];
    out[6] = c56 + 3.853_564_547_206_165_7 * y;
    [out[7], out[8], out[9]] = [0.1935, 0.042, v18];
    out[10] = 0.1935 - 0.072 * cos_v1;
    out[11] = 0.042 - 0.072 * sin_v1;
    out[12] = v18 + c112 * v8;
    out[13] = 0.1935 - 0.04 * cos_v1 - 0.047 * sin_v1;
    out[14] = 0.047 * cos_v1 + (0.042 - 0.04 * sin_v1);
    [out[15], out[16], out[17], out[18], out[19]] = [v18, c60, c61, v19 - c59, c62];
    [out[20], out[21]] = [c57 - s, 0.0];
    Some(())
}

/// Energy, supplied and dissipated power in mode LO.
fn balance_lo(given: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let constants = given.constants.first_chunk::<116>()?;
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
    let c63 = constants[63];
    let c64 = constants[64];
    let c65 = constants[65];
    let c99 = constants[99];
    let c100 = constants[100];
    let c101 = constants[101];
    let c102 = constants[102];
    let c103 = constants[103];
    let c104 = constants[104];
    let c105 = constants[105];
    let c106 = constants[106];
    let c114 = constants[114];
    let c115 = constants[115];
    let y = state[0];
    let u = state[2];
    let s = input[0];
    let s_rate = input[1];
    let v0 = y - yb;
    let v1 = c100 * v0;
    let v2 = c99 - v1;
    let v3 = u * u;
    let v4 = s - y;
    let v5 = k1 * v4;
    let v6 = c41 * v0;
    let v7 = c37 * (y - ybed);
    let v8 = -(y * c37);
    let v9 = c99 * v0;
    let v10 = y * Wk + 0.5 * (v4 * v5) + v3 * (0.5 * (mk + c114 * (v2 * v2)));
    let v11 = c44 * (c102 + c101 * (v9 - 0.5 * (v0 * v1))) + v10;
    let v12 = c63 * functions::softplus_area(v6) + c64 * functions::softplus_square_area(v7);
    let v13 = c65 * functions::softplus_square_area(v8) + v11 + v12;
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
    let v25 = 1.0 - c103 * v0;
    let v26 = 1.0 - v9;
    let v27 = c104 * v26 * (v0 * v26 * (v0 * v17));
    let v28 = R * v25 + 16.0 * v27;
    let v29 = mh * (g - c105 * v3) + u * c43 * v25;
    let v30 = v16 - Wk - v18 - c42 * functions::softplus(v6) - v29 * v28;
    let v31 = c106 * v25;
    let v32 = v29 + v31 * (v30 + (v24 - v21)) / (mk + v31 * v28);
    let v33 = v2 * (c115 * (u * v2)) + v18 + (v21 - v20) - (v24 - v23);
    let out = out.first_chunk_mut::<3>()?;
    [out[0], out[1]] = [v13, s_rate * v16];
    out[2] = v14 * v15 + u * (v33 + 16.0 * (v27 * v32));
    Some(())
}

/// The guard and its rate: lift_off in mode LO.
fn guard_lift_off_lo(given: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let constants = given.constants.first_chunk::<117>()?;
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
    let c69 = constants[69];
    let c99 = constants[99];
    let c103 = constants[103];
    let c104 = constants[104];
    let c105 = constants[105];
    let c106 = constants[106];
    let c108 = constants[108];
    let c109 = constants[109];
    let c116 = constants[116];
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
    let v16 = 1.0 - c103 * v12;
    let v17 = mh * (g - c105 * (u * u)) + u * (c43 * v16);
    let v18 = 1.0 - c99 * v12;
    let v19 = R * v16 + 16.0 * (c104 * (v12 * v12) * (v18 * v18) * v11);
    let v20 = v15 - v17 * v19;
    let v21 = 1.0 / (mk + c106 * v16 * v19);
    let v22 = v21 * v20;
    let v23 = u * -(u * c108 + c116 * v15 + 2.0 * (c109 * v22));
    let v24 = c47 * functions::logistic(v2) * v4 + c48 * functions::logistic(v7) * v9;
    let v25 = if v1 > 0.0 { ab * v22 } else { 0.0 };
    let v26 = if v6 > 0.0 { -(ar * v22) } else { 0.0 };
    let v27 = k1 * v0 + u * -(kj * functions::logistic(v13) + 2.0 * v24);
    let v28 = -(ck + c50 * (1.0 - v11 * v11)) * v21 * v20 + v27;
    let v29 = v10 * (v8 * v26) + (v28 + b1 * (s_rate2 - v22) - v5 * (v3 * v25));
    let out = out.first_chunk_mut::<2>()?;
    out[0] = v17 + c69 * v16 * v15;
    out[1] = v23 + v16 * (c43 * v22 + c69 * v29);
    Some(())
}

/// Bounds of the guard's move and bend: lift_off in mode LO.
fn bound_lift_off_lo(given: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let constants = given.constants.first_chunk::<136>()?;
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
    let c69 = constants[69];
    let c75 = constants[75];
    let c76 = constants[76];
    let c77 = constants[77];
    let c78 = constants[78];
    let c79 = constants[79];
    let c80 = constants[80];
    let c81 = constants[81];
    let c82 = constants[82];
    let c84 = constants[84];
    let c85 = constants[85];
    let c86 = constants[86];
    let c87 = constants[87];
    let c88 = constants[88];
    let c89 = constants[89];
    let c90 = constants[90];
    let c91 = constants[91];
    let c92 = constants[92];
    let c93 = constants[93];
    let c95 = constants[95];
    let c97 = constants[97];
    let c98 = constants[98];
    let c103 = constants[103];
    let c108 = constants[108];
    let c109 = constants[109];
    let c116 = constants[116];
    let c117 = constants[117];
    let c118 = constants[118];
    let c119 = constants[119];
    let c120 = constants[120];
    let c121 = constants[121];
    let c122 = constants[122];
    let c123 = constants[123];
    let c124 = constants[124];
    let c125 = constants[125];
    let c126 = constants[126];
    let c127 = constants[127];
    let c128 = constants[128];
    let c129 = constants[129];
    let c130 = constants[130];
    let c131 = constants[131];
    let c132 = constants[132];
    let c133 = constants[133];
    let c134 = constants[134];
    let c135 = constants[135];
    let y = state[0];
    let u = state[2];
    let s_rate = input[1];
    let s_rate2 = input[2];
    let s_rate3 = input[3];
    let v0 = extra[0] * c124;
    let v1 = y - yb;
    let v2 = c103 * v1;
    let v3 = v0 + (v2 - 1.0).abs();
    let v4 = c37 * (y - ybed);
    let v5 = extra[0] * c78;
    let v6 = v5 + v4;
    let v7 = functions::logistic(v6);
    let v8 = 1.0 + u * ab;
    let v9 = v8.abs();
    let v10 = extra[8] * c76;
    let v11 = v10 + v9;
    let v12 = 0.5 * (v11 + v11.abs());
    let v13 = functions::softplus(v4);
    let v14 = c91 * (functions::softplus(v6) + v13.abs());
    let v15 = y * c37;
    let v16 = v5 - v15;
    let v17 = functions::logistic(v16);
    let v18 = u * ar;
    let v19 = (v18 - 1.0).abs();
    let v20 = extra[8] * c77;
    let v21 = v20 + v19;
    let v22 = 0.5 * (v21 + v21.abs());
    let v23 = -v15;
    let v24 = functions::softplus(v23);
    let v25 = c92 * (functions::softplus(v16) + v24.abs());
    let v26 = c41 * v1;
    let v27 = extra[0] * c79;
    let v28 = functions::logistic(v27 + v26);
    let v29 = v17 * v25 * v22 + (c123 * v28 + v12 * (v7 * v14));
    let v30 = u * c40;
    let v31 = functions::larger(v30.abs() - extra[8] * c90, 0.0);
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
    let v42 = c120 * (s_rate + extra[8]) + c119 * (extra[0] + extra[3] * s_rate);
    let v43 = v34 * v37 + (v42 + v38 * v41) + extra[0] * v29 + extra[8] * (c122 + c121 * v33);
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
    let v71 = 2.0 * (v7 * (v34 * v67 + c80 * v65) + v47.abs() * v70);
    let v72 = v17 * (v38 * v58 + c81 * v56) + v52.abs() * v61;
    let v73 = 2.0 * (v72 + 0.5 * (extra[0] * c82 * v63 + v71));
    let v74 = extra[0] * c127;
    let v75 = 1.0 - v2;
    let v76 = c69 * v75;
    let v77 = v76.abs();
    let v78 = -v54;
    let v79 = math::tanh(v30);
    let v80 = u * -(b1 + ck) + (k1 * (extra[7] - y) - Wk) - Fc * v79;
    let v81 = v39 * v51 + (v80 - c42 * functions::softplus(v26) - v35 * v46);
    let v82 = extra[8] * c125 + (u * c108 + c116 * v81 - v76 * v78).abs();
    let v83 = v74 * (v54.abs() + v73) + (v82 + c126 * v43 + v77 * v73);
    let v84 = v79 * v79;
    let v85 = 1.0 - v84;
    let v86 = if v8 > 0.0 { ab } else { 0.0 };
    let v87 = if v49 > 0.0 { c49 } else { 0.0 };
    let v88 = c50 * v85 + (v86 * v36 - v87 * v40);
    let v89 = c75 - v88;
    let v90 = (2.0 * (u * c109) + v75 * -(c43 + c69 * v89)).abs();
    let v91 = v19 - v20;
    let v92 = if v49 > 0.0 { c77 } else { 0.0 };
    let v93 = if v91 > 0.0 { v92 } else { c77 };
    let v94 = if v91 > 0.0 { 0.0 } else { c77 + v87.abs() };
    let v95 = v79.abs();
    let v96 = extra[8] * v33;
    let v97 = c90 * v96;
    let v98 = v95 + functions::smaller(v95 + v97, 1.0);
    let v99 = v9 - v10;
    let v100 = if v8 > 0.0 { c76 } else { 0.0 };
    let v101 = if v99 > 0.0 { v100 } else { c76 };
    let v102 = if v99 > 0.0 { 0.0 } else { c76 + v86.abs() };
    let v103 = v55 * v93 * v25 + v94 * v41 + (v101 * v64 * v14 + v102 * v37 + c93 * v96 * v98);
    let v104 = extra[0] * (c125 + c127 * ((c117 + v88).abs() + v103));
    let v105 = 2.0 * (extra[8] * c129) + v90 + v77 * v103 + v104;
    let v106 = c135 + extra[3] * ((s_rate * c97 + s_rate2 * c98) * v3);
    let v107 = if v99 > 0.0 { 0.0 } else { f64::INFINITY };
    let v108 = if v91 > 0.0 { 0.0 } else { f64::INFINITY };
    let v109 = extra[3] * v3;
    let v110 = 2.0 * (s_rate * (extra[1] * c133)) + s_rate3 * (c98 * v109);
    let v111 = s_rate2 * (2.0 * (extra[1] * c134) + c97 * v109) + v110;
    let v112 = Kr * v50;
    let v113 = v48 * (1.0 - v48);
    let v114 = Kr * v51;
    let v115 = Kb * v45;
    let v116 = v44 * (1.0 - v44);
    let v117 = Kb * v46;
    let v118 = c84 * (v53 * (1.0 - v53)) + 2.0 * (v44 * v44 * v115 + v116 * v117);
    let v119 = 2.0 * (v48 * v48 * v112 + v113 * v114 - 0.5 * v118);
    let v120 = (v7 + v44.abs()) * v70;
    let v121 = v70 + v120;
    let v122 = (v34 * (Kb * v13).abs() + c86 * v65) * (v116.abs() + v121);
    let v123 = (v17 + v48.abs()) * v61;
    let v124 = v17 * v17 * (c87 * v38) + v112.abs() * v123 + (v117.abs() * v121 + v122);
    let v125 = v61 + v123;
    let v126 = (v38 * (Kr * v24).abs() + c88 * v56) * (v113.abs() + v125);
    let v127 = extra[0] * (c79 * ((1.0 + (v28 + v53.abs())) * v63));
    let v128 = 2.0 * (v7 * v7 * (c85 * v34) + v115.abs() * v120);
    let v129 = v114.abs() * v125 + v126 + 0.5 * (c89 * v127 + v128);
    let v130 = 2.0 * (v124 + v129);
    let v131 = (2.0 * (c116 * v78) - v76 * v119).abs() + 2.0 * (c128 * v73);
    let v132 = v74 * ((-v119).abs() + v130) + (v77 * v130 + v131);
    let v133 = v44 * v66;
    let v134 = v48 * v57;
    let v135 = 2.0 * (v87 * v134 + v86 * v133);
    let v136 = v101 * (extra[0] * (v7 * (c80 * v7) + c78 * v67 * v69));
    let v137 = v93 * (extra[0] * (v17 * (c81 * v17) + c78 * v58 * v60));
    let v138 = v94 * v134.abs() + v137 + (v102 * v133.abs() + v136);
    let v139 = 2.0 * v138;
    let v140 = (c116 * v89 + (c108 - v76 * -v135)).abs() + v77 * v139;
    let v141 = extra[9] * (v74 * (v135.abs() + v139) + v140 + c128 * v103);
    let v142 = v97 * v98;
    let v143 = c131 * (v0 * (c118 * v79).abs() + c130 * v3 * v96);
    let v144 = v75 * (c95 * v79);
    let v145 = v144.abs() * v142 + v143 * ((v84 - 1.0).abs() + v142);
    let v146 = extra[9] * ((2.0 * (v85 * v144) - c132).abs() + 2.0 * v145);
    let v147 = v108 + (c135 + v107) + extra[3] * v111 + extra[2] * v83;
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
    let constants = given.constants.first_chunk::<137>()?;
    let state = given.state.first_chunk::<3>()?;
    let c136 = constants[136];
    let y = state[0];
    let u = state[2];
    let out = out.first_chunk_mut::<2>()?;
    [out[0], out[1]] = [c136 - y, -u];
    Some(())
}

/// Bounds of the guard's move and bend: trip in mode LO.
fn bound_trip_lo(given: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let constants = given.constants.first_chunk::<136>()?;
    let extra = given.extra.first_chunk::<3>()?;
    let c135 = constants[135];
    let out = out.first_chunk_mut::<2>()?;
    out[0] = extra[0] + c135;
    out[1] = c135 + extra[2];
    Some(())
}

/// Where the Taylor series begins in mode LO.
fn series_start_lo(given: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let constants = given.constants.first_chunk::<137>()?;
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
    let c69 = constants[69];
    let c99 = constants[99];
    let c100 = constants[100];
    let c101 = constants[101];
    let c102 = constants[102];
    let c103 = constants[103];
    let c104 = constants[104];
    let c105 = constants[105];
    let c106 = constants[106];
    let c136 = constants[136];
    let y = state[0];
    let u = state[2];
    let s = input[0];
    let s_rate = input[1];
    let v0 = y - yb;
    let v1 = 1.0 - c103 * v0;
    let v2 = u * c40;
    let v3 = math::tanh(v2);
    let v4 = c99 * v0;
    let v5 = 1.0 - v4;
    let v6 = v5 * v5;
    let v7 = c104 * (v0 * v0);
    let v8 = v7 * v6;
    let v9 = R * v1 + 16.0 * (v8 * v3);
    let v10 = u * c43;
    let v11 = mh * (g - c105 * (u * u)) + v10 * v1;
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
    let v30 = c106 * v1;
    let v31 = mk + v30 * v9;
    let v32 = (v29 - v11 * v9) / v31;
    let v33 = c100 * v0;
    let v34 = c99 - v33;
    let v35 = u * c101;
    let v36 = c69 * v1;
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
    out[2] = c102 + c101 * (v4 - 0.5 * (v0 * v33));
    out[3] = v35 * v34;
    out[4] = v11 + v36 * v29;
    [out[5], out[6], out[7], out[8], out[9], out[10]] = [v0, c136 - y, v13, v20, v42, v48];
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
    let constants = given.constants.first_chunk::<107>()?;
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
    let c69 = constants[69];
    let c99 = constants[99];
    let c100 = constants[100];
    let c101 = constants[101];
    let c103 = constants[103];
    let c104 = constants[104];
    let c105 = constants[105];
    let c106 = constants[106];
    let y = state[0];
    let u = state[2];
    let s = input[0];
    let s_rate = input[1];
    let v0 = -(c103 * y);
    let v1 = c40 * u;
    let v2 = extra[49] * extra[1] + v1 * extra[2];
    let v3 = c99 * y;
    let v4 = -v3;
    let v5 = extra[52] + extra[5] * v4;
    let v6 = c104 * (extra[51] + extra[4] * y);
    let v7 = extra[53] + extra[6] * v5 + v6 * extra[7];
    let v8 = 16.0 * (extra[54] + extra[8] * v2 + v7 * extra[9]);
    let v9 = R * v0 + v8;
    let v10 = c43 * u;
    let v11 = extra[56] + extra[11] * v0 + v10 * extra[12];
    let v12 = mh * -(c105 * (extra[55] + extra[10] * u)) + v11;
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
    let v32 = c106 * v0;
    let v33 = extra[71] + extra[32] * v9 + v32 * extra[14];
    let v34 = (v31 - extra[72] - extra[33] * v33) * extra[34];
    let v35 = c100 * y;
    let v36 = 0.5 * (extra[73] + extra[35] * v35 + y * extra[36]);
    let v37 = -v35;
    let v38 = c101 * u;
    let v39 = c69 * v0;
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
    out[2] = c101 * (v3 - v36);
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
    let constants = given.constants.first_chunk::<139>()?;
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
    let c137 = constants[137];
    let c138 = constants[138];
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
    out[2] = c137 * (v3 + v5);
    out[3] = -(g + w * c138);
    Some(())
}

/// The derivative of a part in mode FLA.
fn part_0_fla(given: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let constants = given.constants.first_chunk::<138>()?;
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
    let c137 = constants[137];
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
    out[2] = c137 * (v3 + v5);
    out[3] = 0.0;
    Some(())
}

/// The derivative of a part in mode FLA.
fn part_1_fla(given: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let constants = given.constants.first_chunk::<139>()?;
    let state = given.state.first_chunk::<4>()?;
    let g = constants[3];
    let c138 = constants[138];
    let w = state[3];
    let out = out.first_chunk_mut::<4>()?;
    [out[0], out[1], out[2]] = [0.0, w, 0.0];
    out[3] = -(g + w * c138);
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
    let constants = given.constants.first_chunk::<140>()?;
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
    let c75 = constants[75];
    let c137 = constants[137];
    let c139 = constants[139];
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
    let v12 = c75 + c39 * v10 * (v6 * v6) - (c38 * v9 * (v2 * v2) + c50 * (1.0 - v11 * v11));
    let out = out.first_chunk_mut::<16>()?;
    [out[0], out[1], out[2], out[3], out[4], out[5], out[6]] = [0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0];
    [out[7], out[8], out[9], out[10], out[11]] = [1.0, c137 * -v8, 0.0, c137 * v12, 0.0];
    [out[12], out[13], out[14], out[15]] = [0.0, 0.0, 0.0, c139];
    Some(())
}

/// The outputs in mode FLA.
fn outputs_fla(given: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let constants = given.constants.first_chunk::<141>()?;
    let state = given.state.first_chunk::<3>()?;
    let input = given.input;
    let k1 = constants[35];
    let b1 = constants[36];
    let c53 = constants[53];
    let c54 = constants[54];
    let c55 = constants[55];
    let c56 = constants[56];
    let c57 = constants[57];
    let c59 = constants[59];
    let c60 = constants[60];
    let c61 = constants[61];
    let c62 = constants[62];
    let c113 = constants[113];
    let c140 = constants[140];
    let y = state[0];
    let z = state[1];
    let u = state[2];
    let s = input[0];
    let s_rate = input[1];
    let v0 = y * c53;
    let v1 = v0 - c55;
    let v2 = c54 + v0;
    let (sin_v1, cos_v1) = math::sin_cos(v1);
    let out = out.first_chunk_mut::<22>()?;
    out[0] = k1 * (s - y) + b1 * (s_rate - u);
    [out[1], out[2], out[3], out[4], out[5]] = [0.0, 0.0, 0.0, 0.0, 0.0];
    out[6] = c56 + 3.853_564_547_206_165_7 * y;
    [out[7], out[8], out[9]] = [0.1935, 0.042, v2];
    out[10] = 0.1935 - 0.072 * cos_v1;
    out[11] = 0.042 - 0.072 * sin_v1;
    out[12] = v2;
    out[13] = 0.1935 - 0.04 * cos_v1 - 0.047 * sin_v1;
    out[14] = 0.047 * cos_v1 + (0.042 - 0.04 * sin_v1);
    [out[15], out[16], out[17]] = [c140 + v0, c60, c61];
    out[18] = z * c113 - c59;
    [out[19], out[20], out[21]] = [c62, c57 - s, 0.0];
    Some(())
}

/// Energy, supplied and dissipated power in mode FLA.
fn balance_fla(given: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let constants = given.constants.first_chunk::<66>()?;
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
    let c63 = constants[63];
    let c64 = constants[64];
    let c65 = constants[65];
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
    let v5 = c63 * functions::softplus_area(c41 * (y - yb));
    let v6 = v4 + c65 * functions::softplus_square_area(v3);
    let v7 = v6 + (v5 + c64 * functions::softplus_square_area(v2));
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
    let constants = given.constants.first_chunk::<107>()?;
    let state = given.state.first_chunk::<4>()?;
    let R = constants[0];
    let mk = constants[1];
    let c45 = constants[45];
    let c46 = constants[46];
    let c106 = constants[106];
    let y = state[0];
    let u = state[2];
    let w = state[3];
    let v0 = u * mk + w * c106;
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
    let constants = given.constants.first_chunk::<142>()?;
    let extra = given.extra.first_chunk::<7>()?;
    let c141 = constants[141];
    let out = out.first_chunk_mut::<2>()?;
    out[0] = extra[4] + extra[0] * c141;
    out[1] = extra[6] + c141 * extra[2];
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
    let constants = given.constants.first_chunk::<139>()?;
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
    let c137 = constants[137];
    let c138 = constants[138];
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
    [out[0], out[1], out[2]] = [u, w, c137 * v20];
    out[3] = -(g + w * c138);
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
    let constants = given.constants.first_chunk::<139>()?;
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
    let c137 = constants[137];
    let c138 = constants[138];
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
    [out[0], out[1], out[2], out[3], out[4]] = [u, w, c137 * v19, -(c138 * w), z - R * y];
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

/// The outputs in mode FLL.
fn outputs_fll(given: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let constants = given.constants.first_chunk::<143>()?;
    let state = given.state.first_chunk::<3>()?;
    let input = given.input;
    let yb = constants[15];
    let k1 = constants[35];
    let b1 = constants[36];
    let c53 = constants[53];
    let c54 = constants[54];
    let c55 = constants[55];
    let c56 = constants[56];
    let c57 = constants[57];
    let c59 = constants[59];
    let c60 = constants[60];
    let c61 = constants[61];
    let c62 = constants[62];
    let c112 = constants[112];
    let c113 = constants[113];
    let c142 = constants[142];
    let y = state[0];
    let z = state[1];
    let u = state[2];
    let s = input[0];
    let s_rate = input[1];
    let v0 = y * c53;
    let v1 = v0 - c55;
    let v2 = c54 + v0;
    let (sin_v1, cos_v1) = math::sin_cos(v1);
    let v3 = sin_v1 - 1.175 * cos_v1;
    let v4 = functions::smaller(1.0, c142 - 1.244_542_782_574_11 * v3);
    let v5 = 0.093_476_781_158_589_46 + math::asin(functions::larger(-1.0, v4));
    let out = out.first_chunk_mut::<22>()?;
    out[0] = k1 * (s - y) + b1 * (s_rate - u);
    [out[1], out[2], out[3], out[4], out[5]] = [0.0, 0.0, 0.0, 0.0, 0.0];
    out[6] = c56 + 3.853_564_547_206_165_7 * y;
    [out[7], out[8], out[9]] = [0.1935, 0.042, v2];
    out[10] = 0.1935 - 0.072 * cos_v1;
    out[11] = 0.042 - 0.072 * sin_v1;
    out[12] = v2 + c112 * (y - yb);
    out[13] = 0.1935 - 0.04 * cos_v1 - 0.047 * sin_v1;
    out[14] = 0.042 - 0.04 * v3;
    [out[15], out[16], out[17]] = [v5, c60, c61];
    out[18] = z * c113 - c59;
    [out[19], out[20], out[21]] = [c62, c57 - s, 0.0];
    Some(())
}

/// The state after guard land in mode FLL.
fn reset_0_land_fll(given: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let constants = given.constants.first_chunk::<107>()?;
    let state = given.state.first_chunk::<4>()?;
    let mk = constants[1];
    let yb = constants[15];
    let c66 = constants[66];
    let c99 = constants[99];
    let c100 = constants[100];
    let c101 = constants[101];
    let c102 = constants[102];
    let c103 = constants[103];
    let c106 = constants[106];
    let y = state[0];
    let u = state[2];
    let w = state[3];
    let v0 = y - yb;
    let v1 = c100 * v0;
    let v2 = 1.0 - c103 * v0;
    let v3 = (u * mk + w * c106 * v2) * (1.0 / (mk + c66 * (v2 * v2)));
    let out = out.first_chunk_mut::<5>()?;
    out[0] = y;
    out[1] = c102 + c101 * (v0 * (c99 - 0.5 * v1));
    out[2] = v3;
    out[3] = c101 * (c99 - v1) * v3;
    out[4] = 0.0;
    Some(())
}

/// The guard and its rate: land in mode FLL.
fn guard_land_fll(given: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let constants = given.constants.first_chunk::<103>()?;
    let state = given.state.first_chunk::<4>()?;
    let yb = constants[15];
    let c99 = constants[99];
    let c100 = constants[100];
    let c101 = constants[101];
    let c102 = constants[102];
    let y = state[0];
    let z = state[1];
    let u = state[2];
    let w = state[3];
    let v0 = y - yb;
    let v1 = c100 * v0;
    let out = out.first_chunk_mut::<2>()?;
    out[0] = z - c102 - c101 * (v0 * (c99 - 0.5 * v1));
    out[1] = w - c101 * (u * (c99 - v1));
    Some(())
}

/// Bounds of the guard's move and bend: land in mode FLL.
fn bound_land_fll(given: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let constants = given.constants.first_chunk::<145>()?;
    let state = given.state.first_chunk::<1>()?;
    let extra = given.extra.first_chunk::<7>()?;
    let yb = constants[15];
    let c99 = constants[99];
    let c100 = constants[100];
    let c101 = constants[101];
    let c135 = constants[135];
    let c143 = constants[143];
    let c144 = constants[144];
    let y = state[0];
    let v0 = extra[0] * c143 + (c101 * (c99 - c100 * (y - yb))).abs();
    let v1 = c135 + extra[6] + c144 * (extra[1] * extra[1]) + extra[2] * v0;
    let out = out.first_chunk_mut::<2>()?;
    out[0] = extra[4] + c135 + extra[0] * v0;
    out[1] = v1;
    Some(())
}

/// Where the Taylor series begins in mode FLL.
fn series_start_fll(given: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let constants = given.constants.first_chunk::<139>()?;
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
    let c99 = constants[99];
    let c100 = constants[100];
    let c101 = constants[101];
    let c102 = constants[102];
    let c136 = constants[136];
    let c137 = constants[137];
    let c138 = constants[138];
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
    let v21 = c99 - 0.5 * (c100 * v16);
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
    [out[0], out[1], out[2]] = [u, w, c137 * v20];
    out[3] = -(g + w * c138);
    out[4] = z - c102 - c101 * (v16 * v21);
    [out[5], out[6], out[7], out[8], out[9], out[10]] = [v16, c136 - y, zs - z, v1, v8, v27];
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
    let constants = given.constants.first_chunk::<139>()?;
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
    let c100 = constants[100];
    let c101 = constants[101];
    let c137 = constants[137];
    let c138 = constants[138];
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
    let v20 = -(0.5 * (c100 * y));
    let v21 = c101 * (extra[46] + extra[21] * v20 + y * extra[22]);
    let v22 = if extra[24] > 0.0 { extra[23] * v2 } else { 0.0 };
    let v23 = if extra[26] > 0.0 { extra[25] * v8 } else { 0.0 };
    let v24 = if extra[28] > 0.0 { extra[27] * v14 } else { 0.0 };
    let v25 = extra[29] * v12;
    let v26 = if extra[30] > 0.0 { v25 + v25 } else { 0.0 };
    let v27 = extra[0] * v2;
    let v28 = extra[0] * v8;
    let v29 = extra[0] * v14;
    let out = out.first_chunk_mut::<46>()?;
    [out[0], out[1], out[2], out[3], out[4], out[5]] = [u, w, c137 * v19, -(c138 * w), z - v21, y];
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

/// The outputs in mode FLT.
fn outputs_flt(given: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let constants = given.constants.first_chunk::<146>()?;
    let state = given.state.first_chunk::<3>()?;
    let input = given.input;
    let k1 = constants[35];
    let b1 = constants[36];
    let c53 = constants[53];
    let c54 = constants[54];
    let c55 = constants[55];
    let c56 = constants[56];
    let c57 = constants[57];
    let c59 = constants[59];
    let c60 = constants[60];
    let c61 = constants[61];
    let c62 = constants[62];
    let c113 = constants[113];
    let c142 = constants[142];
    let c145 = constants[145];
    let y = state[0];
    let z = state[1];
    let u = state[2];
    let s = input[0];
    let s_rate = input[1];
    let v0 = y * c53;
    let v1 = v0 - c55;
    let (sin_v1, cos_v1) = math::sin_cos(v1);
    let v2 = sin_v1 - 1.175 * cos_v1;
    let v3 = functions::smaller(1.0, c142 - 1.244_542_782_574_11 * v2);
    let v4 = 0.093_476_781_158_589_46 + math::asin(functions::larger(-1.0, v3));
    let out = out.first_chunk_mut::<22>()?;
    out[0] = k1 * (s - y) + b1 * (s_rate - u);
    [out[1], out[2], out[3], out[4], out[5]] = [0.0, 0.0, 0.0, 0.0, 0.0];
    out[6] = c56 + 3.853_564_547_206_165_7 * y;
    [out[7], out[8], out[9]] = [0.1935, 0.042, c54 + v0];
    out[10] = 0.1935 - 0.072 * cos_v1;
    out[11] = 0.042 - 0.072 * sin_v1;
    out[12] = c145 + v0;
    out[13] = 0.1935 - 0.04 * cos_v1 - 0.047 * sin_v1;
    out[14] = 0.042 - 0.04 * v2;
    [out[15], out[16], out[17]] = [v4, c60, c61];
    out[18] = z * c113 - c59;
    [out[19], out[20], out[21]] = [c62, c57 - s, 0.0];
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
    let constants = given.constants.first_chunk::<147>()?;
    let state = given.state.first_chunk::<4>()?;
    let R = constants[0];
    let o_r = constants[27];
    let yd = constants[28];
    let wd = constants[29];
    let c146 = constants[146];
    let y = state[0];
    let z = state[1];
    let u = state[2];
    let w = state[3];
    let v0 = c146 * (y - yd);
    let out = out.first_chunk_mut::<2>()?;
    out[0] = z - o_r - R * (y - wd * functions::softplus(v0));
    out[1] = w - R * (u * (1.0 - functions::logistic(v0)));
    Some(())
}

/// Bounds of the guard's move and bend: rep_on in mode FLT.
fn bound_rep_on_flt(given: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let constants = given.constants.first_chunk::<149>()?;
    let state = given.state.first_chunk::<1>()?;
    let extra = given.extra.first_chunk::<7>()?;
    let R = constants[0];
    let yd = constants[28];
    let c146 = constants[146];
    let c147 = constants[147];
    let c148 = constants[148];
    let y = state[0];
    let v0 = extra[0] * c147;
    let v1 = c146 * (y - yd);
    let v2 = functions::logistic(functions::larger(v1.abs() - v0, 0.0));
    let v3 = v2 * (1.0 - v2);
    let v4 = functions::logistic(v1);
    let v5 = 1.0 - v4;
    let v6 = (R * v5).abs() + extra[0] * c148 * v3;
    let v7 = (1.0 + (functions::logistic(v0 + v1) + v4.abs())) * v3;
    let v8 = c148 * (extra[1] * extra[1]) * ((v4 * v5).abs() + extra[0] * (c147 * v7));
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
    let constants = given.constants.first_chunk::<147>()?;
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
    let c137 = constants[137];
    let c138 = constants[138];
    let c146 = constants[146];
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
    let v20 = c146 * (y - yd);
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
    [out[0], out[1], out[2]] = [u, w, c137 * v19];
    out[3] = -(g + w * c138);
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
    let constants = given.constants.first_chunk::<147>()?;
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
    let c137 = constants[137];
    let c138 = constants[138];
    let c146 = constants[146];
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
    let v20 = c146 * y;
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
    [out[0], out[1], out[2], out[3], out[4]] = [u, w, c137 * v19, -(c138 * w), -z];
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
    let constants = given.constants.first_chunk::<150>()?;
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
    let c137 = constants[137];
    let c138 = constants[138];
    let c149 = constants[149];
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
    let v7 = c149 * functions::larger(1.0 + w * mus, 0.0) * v6;
    let out = out.first_chunk_mut::<4>()?;
    [out[0], out[1]] = [u, w];
    out[2] = c137 * (v3 + v5);
    out[3] = -(g + w * c138 + v7);
    Some(())
}

/// The derivative of a part in mode STU.
fn part_1_stu(given: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let constants = given.constants.first_chunk::<150>()?;
    let state = given.state.first_chunk::<4>()?;
    let g = constants[3];
    let zs = constants[21];
    let ps = constants[23];
    let mus = constants[24];
    let c138 = constants[138];
    let c149 = constants[149];
    let z = state[1];
    let w = state[3];
    let v0 = math::powf(functions::larger(z - zs, 0.0), ps);
    let v1 = c149 * functions::larger(1.0 + w * mus, 0.0) * v0;
    let out = out.first_chunk_mut::<4>()?;
    [out[0], out[1], out[2]] = [0.0, w, 0.0];
    out[3] = -(g + w * c138 + v1);
    Some(())
}

/// Is not used by the table.
fn function_61(given: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
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
    let constants = given.constants.first_chunk::<152>()?;
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
    let c75 = constants[75];
    let c137 = constants[137];
    let c138 = constants[138];
    let c149 = constants[149];
    let c150 = constants[150];
    let c151 = constants[151];
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
    let v12 = c75 + c39 * v10 * (v6 * v6) - (c38 * v9 * (v2 * v2) + c50 * (1.0 - v11 * v11));
    let v13 = 1.0 + w * mus;
    let v14 = z - zs;
    let v15 = if v14 > 0.0 { 1.0 } else { 0.0 };
    let v16 = functions::larger(v14, 0.0);
    let v17 = c151 * v15 * functions::larger(v13, 0.0) * math::powf(v16, c150);
    let v18 = if v13 > 0.0 { mus } else { 0.0 };
    let out = out.first_chunk_mut::<16>()?;
    [out[0], out[1], out[2], out[3], out[4], out[5], out[6]] = [0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0];
    [out[7], out[8], out[9], out[10], out[11]] = [1.0, c137 * -v8, 0.0, c137 * v12, 0.0];
    [out[12], out[13], out[14]] = [0.0, -v17, 0.0];
    out[15] = -(c138 + c149 * v18 * math::powf(v16, ps));
    Some(())
}

/// The outputs in mode STU.
fn outputs_stu(given: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let constants = given.constants.first_chunk::<141>()?;
    let state = given.state.first_chunk::<4>()?;
    let input = given.input;
    let yb = constants[15];
    let zs = constants[21];
    let Ks = constants[22];
    let ps = constants[23];
    let mus = constants[24];
    let k1 = constants[35];
    let b1 = constants[36];
    let c53 = constants[53];
    let c54 = constants[54];
    let c55 = constants[55];
    let c56 = constants[56];
    let c57 = constants[57];
    let c59 = constants[59];
    let c60 = constants[60];
    let c61 = constants[61];
    let c62 = constants[62];
    let c112 = constants[112];
    let c113 = constants[113];
    let c140 = constants[140];
    let y = state[0];
    let z = state[1];
    let u = state[2];
    let w = state[3];
    let s = input[0];
    let s_rate = input[1];
    let v0 = y * c53;
    let v1 = v0 - c55;
    let v2 = math::powf(functions::larger(z - zs, 0.0), ps);
    let v3 = c54 + v0;
    let (sin_v1, cos_v1) = math::sin_cos(v1);
    let out = out.first_chunk_mut::<22>()?;
    out[0] = k1 * (s - y) + b1 * (s_rate - u);
    [out[1], out[2]] = [0.0, 0.0];
    out[3] = Ks * functions::larger(1.0 + w * mus, 0.0) * v2;
    [out[4], out[5]] = [0.0, 0.0];
    out[6] = c56 + 3.853_564_547_206_165_7 * y;
    [out[7], out[8], out[9]] = [0.1935, 0.042, v3];
    out[10] = 0.1935 - 0.072 * cos_v1;
    out[11] = 0.042 - 0.072 * sin_v1;
    out[12] = v3 + c112 * (y - yb);
    out[13] = 0.1935 - 0.04 * cos_v1 - 0.047 * sin_v1;
    out[14] = 0.047 * cos_v1 + (0.042 - 0.04 * sin_v1);
    [out[15], out[16], out[17]] = [c140 + v0, c60, c61];
    out[18] = z * c113 - c59;
    [out[19], out[20], out[21]] = [c62, c57 - s, 0.0];
    Some(())
}

/// Energy, supplied and dissipated power in mode STU.
fn balance_stu(given: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let constants = given.constants.first_chunk::<153>()?;
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
    let c63 = constants[63];
    let c64 = constants[64];
    let c65 = constants[65];
    let c152 = constants[152];
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
    let v7 = c63 * functions::softplus_area(c41 * (y - yb));
    let v8 = v6 + c65 * functions::softplus_square_area(v3);
    let v9 = v8 + (v7 + c64 * functions::softplus_square_area(v2));
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
    out[0] = v9 + c152 * v4 * v5;
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
    let constants = given.constants.first_chunk::<150>()?;
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
    let c136 = constants[136];
    let c137 = constants[137];
    let c138 = constants[138];
    let c149 = constants[149];
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
    let v27 = c149 * v26;
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
    [out[0], out[1], out[2]] = [u, w, c137 * v19];
    out[3] = -(g + w * c138 + v27 * v23);
    [out[4], out[5], out[6], out[7], out[8], out[9]] = [v20, c136 - y, v1, v8, v21, v25];
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
    let constants = given.constants.first_chunk::<150>()?;
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
    let c137 = constants[137];
    let c138 = constants[138];
    let c149 = constants[149];
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
    let v26 = c149 * v25;
    let v27 = c138 * w + (extra[52] + extra[26] * v23 + v26 * extra[22]);
    let v28 = if extra[28] > 0.0 { extra[27] * v2 } else { 0.0 };
    let v29 = if extra[30] > 0.0 { extra[29] * v8 } else { 0.0 };
    let v30 = if extra[32] > 0.0 { extra[31] * v14 } else { 0.0 };
    let v31 = extra[33] * v12;
    let v32 = if extra[34] > 0.0 { v31 + v31 } else { 0.0 };
    let v33 = extra[0] * v2;
    let v34 = extra[0] * v8;
    let v35 = extra[0] * v14;
    let out = out.first_chunk_mut::<50>()?;
    [out[0], out[1], out[2], out[3], out[4], out[5], out[6]] = [u, w, c137 * v19, -v27, z, -y, v0];
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

/// The outputs in mode STT.
fn outputs_stt(given: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let constants = given.constants.first_chunk::<146>()?;
    let state = given.state.first_chunk::<4>()?;
    let input = given.input;
    let zs = constants[21];
    let Ks = constants[22];
    let ps = constants[23];
    let mus = constants[24];
    let k1 = constants[35];
    let b1 = constants[36];
    let c53 = constants[53];
    let c54 = constants[54];
    let c55 = constants[55];
    let c56 = constants[56];
    let c57 = constants[57];
    let c59 = constants[59];
    let c60 = constants[60];
    let c61 = constants[61];
    let c62 = constants[62];
    let c113 = constants[113];
    let c142 = constants[142];
    let c145 = constants[145];
    let y = state[0];
    let z = state[1];
    let u = state[2];
    let w = state[3];
    let s = input[0];
    let s_rate = input[1];
    let v0 = y * c53;
    let v1 = v0 - c55;
    let v2 = math::powf(functions::larger(z - zs, 0.0), ps);
    let (sin_v1, cos_v1) = math::sin_cos(v1);
    let v3 = sin_v1 - 1.175 * cos_v1;
    let v4 = functions::smaller(1.0, c142 - 1.244_542_782_574_11 * v3);
    let v5 = 0.093_476_781_158_589_46 + math::asin(functions::larger(-1.0, v4));
    let out = out.first_chunk_mut::<22>()?;
    out[0] = k1 * (s - y) + b1 * (s_rate - u);
    [out[1], out[2]] = [0.0, 0.0];
    out[3] = Ks * functions::larger(1.0 + w * mus, 0.0) * v2;
    [out[4], out[5]] = [0.0, 0.0];
    out[6] = c56 + 3.853_564_547_206_165_7 * y;
    [out[7], out[8], out[9]] = [0.1935, 0.042, c54 + v0];
    out[10] = 0.1935 - 0.072 * cos_v1;
    out[11] = 0.042 - 0.072 * sin_v1;
    out[12] = c145 + v0;
    out[13] = 0.1935 - 0.04 * cos_v1 - 0.047 * sin_v1;
    out[14] = 0.042 - 0.04 * v3;
    [out[15], out[16], out[17]] = [v5, c60, c61];
    out[18] = z * c113 - c59;
    [out[19], out[20], out[21]] = [c62, c57 - s, 0.0];
    Some(())
}

/// Where the Taylor series begins in mode STT.
fn series_start_stt(given: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let constants = given.constants.first_chunk::<150>()?;
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
    let c137 = constants[137];
    let c138 = constants[138];
    let c149 = constants[149];
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
    let v27 = c149 * v26;
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
    [out[0], out[1], out[2]] = [u, w, c137 * v19];
    out[3] = -(g + w * c138 + v27 * v23);
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
    let constants = given.constants.first_chunk::<150>()?;
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
    let c137 = constants[137];
    let c138 = constants[138];
    let c149 = constants[149];
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
    let v26 = c149 * v25;
    let v27 = c138 * w + (extra[52] + extra[26] * v23 + v26 * extra[22]);
    let v28 = if extra[28] > 0.0 { extra[27] * v2 } else { 0.0 };
    let v29 = if extra[30] > 0.0 { extra[29] * v8 } else { 0.0 };
    let v30 = if extra[32] > 0.0 { extra[31] * v14 } else { 0.0 };
    let v31 = extra[33] * v12;
    let v32 = if extra[34] > 0.0 { v31 + v31 } else { 0.0 };
    let v33 = extra[0] * v2;
    let v34 = extra[0] * v8;
    let v35 = extra[0] * v14;
    let out = out.first_chunk_mut::<50>()?;
    [out[0], out[1], out[2], out[3], out[4], out[5], out[6]] = [u, w, c137 * v19, -v27, z, y, v0];
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
    let constants = given.constants.first_chunk::<155>()?;
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
    let c137 = constants[137];
    let c138 = constants[138];
    let c146 = constants[146];
    let c153 = constants[153];
    let c154 = constants[154];
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
    let v6 = c146 * (y - yd);
    let v7 = 1.0 - functions::logistic(v6);
    let v8 = o_r - z + R * (y - wd * functions::softplus(v6));
    let v9 = v8 * functions::softplus(cr * (u * R * v7 - w));
    let v10 = c137 * (v3 + v5) - core::f64::consts::LOG2_E * (c153 * v7 * v9);
    let v11 = core::f64::consts::LOG2_E * (c154 * v9) - (g + w * c138);
    let out = out.first_chunk_mut::<4>()?;
    [out[0], out[1], out[2], out[3]] = [u, w, v10, v11];
    Some(())
}

/// The derivative's derivative by the state in mode REPH.
fn jacobian_reph(given: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let constants = given.constants.first_chunk::<164>()?;
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
    let c75 = constants[75];
    let c137 = constants[137];
    let c138 = constants[138];
    let c146 = constants[146];
    let c153 = constants[153];
    let c154 = constants[154];
    let c155 = constants[155];
    let c156 = constants[156];
    let c157 = constants[157];
    let c158 = constants[158];
    let c159 = constants[159];
    let c160 = constants[160];
    let c161 = constants[161];
    let c162 = constants[162];
    let c163 = constants[163];
    let y = state[0];
    let z = state[1];
    let u = state[2];
    let w = state[3];
    let v0 = c146 * (y - yd);
    let v1 = functions::logistic(v0);
    let v2 = 1.0 - v1;
    let v3 = cr * (u * R * v2 - w);
    let v4 = functions::softplus(v3);
    let v5 = v2 * v4;
    let v6 = o_r - z + R * (y - wd * functions::softplus(v0));
    let v7 = v6 * functions::logistic(v3);
    let v8 = v1 * v2;
    let v9 = u * v8;
    let v10 = core::f64::consts::LOG2_E * (c157 * v9 * v7 - c156 * v5);
    let v11 = 1.0 + u * ab;
    let v12 = c37 * (y - ybed);
    let v13 = functions::softplus(v12);
    let v14 = functions::logistic(v12) * (c47 * v13) * functions::larger(v11, 0.0);
    let v15 = 1.0 - u * ar;
    let v16 = -(y * c37);
    let v17 = functions::softplus(v16);
    let v18 = functions::logistic(v16) * (c48 * v17) * functions::larger(v15, 0.0);
    let v19 = k1 + kj * functions::logistic(c41 * (y - yb)) + 2.0 * (v14 + v18);
    let v20 = core::f64::consts::LOG2_E * (v8 * v6 * (c155 * v4));
    let v21 = if v11 > 0.0 { ab } else { 0.0 };
    let v22 = if v15 > 0.0 { c49 } else { 0.0 };
    let v23 = math::tanh(u * c40);
    let v24 = c38 * v21 * (v13 * v13) + c50 * (1.0 - v23 * v23);
    let v25 = v2 * v7;
    let v26 = core::f64::consts::LOG2_E * (c160 * v2 * v25);
    let v27 = c137 * (c75 + c39 * v22 * (v17 * v17) - v24) - v26;
    let v28 = core::f64::consts::LOG2_E * (c158 * v5 - c159 * v9 * v7);
    let v29 = -(c138 + core::f64::consts::LOG2_E * (c163 * v7));
    let out = out.first_chunk_mut::<16>()?;
    [out[0], out[1], out[2], out[3], out[4], out[5], out[6]] = [0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0];
    out[7] = 1.0;
    out[8] = c137 * -v19 + v20 + v2 * v10;
    out[9] = core::f64::consts::LOG2_E * (c153 * v5);
    out[10] = v27;
    out[11] = core::f64::consts::LOG2_E * (c162 * v25);
    out[12] = v28;
    out[13] = -(core::f64::consts::LOG2_E * (c154 * v4));
    out[14] = core::f64::consts::LOG2_E * (c161 * v25);
    out[15] = v29;
    Some(())
}

/// The outputs in mode REPH.
fn outputs_reph(given: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let constants = given.constants.first_chunk::<166>()?;
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
    let c53 = constants[53];
    let c54 = constants[54];
    let c55 = constants[55];
    let c56 = constants[56];
    let c57 = constants[57];
    let c59 = constants[59];
    let c60 = constants[60];
    let c61 = constants[61];
    let c62 = constants[62];
    let c113 = constants[113];
    let c145 = constants[145];
    let c146 = constants[146];
    let c164 = constants[164];
    let c165 = constants[165];
    let y = state[0];
    let z = state[1];
    let u = state[2];
    let w = state[3];
    let s = input[0];
    let s_rate = input[1];
    let v0 = y * c53;
    let v1 = v0 - c55;
    let v2 = c59 - z * c113;
    let v3 = c146 * (y - yd);
    let v4 = cr * (u * R * (1.0 - functions::logistic(v3)) - w);
    let v5 = kr * (o_r - z + R * (y - wd * functions::softplus(v3)));
    let v6 = core::f64::consts::LOG2_E * (v5 * functions::softplus(v4));
    let ([sin_v1, sin_v2], [cos_v1, cos_v2]) = math::sin_cos_of_two([v1, v2]);
    let v7 = sin_v1 - 1.175 * cos_v1;
    let v8 = 31.113_569_564_352_75 * (c164 * sin_v2) + (c165 + 0.311_135_695_643_527_5 * cos_v2);
    let v9 = functions::smaller(1.0, v8 - 1.244_542_782_574_11 * v7);
    let v10 = 0.093_476_781_158_589_46 + math::asin(functions::larger(-1.0, v9));
    let out = out.first_chunk_mut::<22>()?;
    out[0] = k1 * (s - y) + b1 * (s_rate - u);
    [out[1], out[2], out[3], out[4], out[5]] = [0.0, v6, 0.0, 0.0, 0.0];
    out[6] = c56 + 3.853_564_547_206_165_7 * y;
    [out[7], out[8], out[9]] = [0.1935, 0.042, c54 + v0];
    out[10] = 0.1935 - 0.072 * cos_v1;
    out[11] = 0.042 - 0.072 * sin_v1;
    out[12] = c145 + v0;
    out[13] = 0.1935 - 0.04 * cos_v1 - 0.047 * sin_v1;
    out[14] = 0.042 - 0.04 * v7;
    [out[15], out[16], out[17], out[18], out[19], out[20]] = [v10, c60, c61, -v2, c62, c57 - s];
    out[21] = 0.0;
    Some(())
}

/// Energy, supplied and dissipated power in mode REPH.
fn balance_reph(given: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let constants = given.constants.first_chunk::<147>()?;
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
    let c63 = constants[63];
    let c64 = constants[64];
    let c65 = constants[65];
    let c146 = constants[146];
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
    let v4 = c146 * (y - yd);
    let v5 = o_r - z + R * (y - wd * functions::softplus(v4));
    let v6 = v0 * v1 + (mk * (u * u) + mh * (w * w)) + v5 * (kr * v5);
    let v7 = y * Wk + z * c44 + c65 * functions::softplus_square_area(v3);
    let v8 = c63 * functions::softplus_area(c41 * (y - yb));
    let v9 = v7 + (v8 + c64 * functions::softplus_square_area(v2));
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
    let constants = given.constants.first_chunk::<147>()?;
    let state = given.state.first_chunk::<4>()?;
    let R = constants[0];
    let o_r = constants[27];
    let yd = constants[28];
    let wd = constants[29];
    let c146 = constants[146];
    let y = state[0];
    let z = state[1];
    let u = state[2];
    let w = state[3];
    let v0 = c146 * (y - yd);
    let out = out.first_chunk_mut::<2>()?;
    out[0] = o_r - z + R * (y - wd * functions::softplus(v0));
    out[1] = R * (u * (1.0 - functions::logistic(v0))) - w;
    Some(())
}

/// Bounds of the guard's move and bend: rep_off in mode REPH.
fn bound_rep_off_reph(given: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let constants = given.constants.first_chunk::<168>()?;
    let state = given.state.first_chunk::<1>()?;
    let extra = given.extra.first_chunk::<7>()?;
    let yd = constants[28];
    let c141 = constants[141];
    let c146 = constants[146];
    let c147 = constants[147];
    let c166 = constants[166];
    let c167 = constants[167];
    let y = state[0];
    let v0 = extra[0] * c147;
    let v1 = c146 * (y - yd);
    let v2 = functions::logistic(functions::larger(v1.abs() - v0, 0.0));
    let v3 = v0 * (v2 * (1.0 - v2));
    let v4 = functions::logistic(v1);
    let v5 = c141 * ((v4 - 1.0).abs() + v3);
    let v6 = v3 + (functions::logistic(v0 + v1) + v4.abs()) * v3;
    let v7 = extra[1] * extra[1] * ((c166 * (v4 * (1.0 - v4))).abs() + c167 * v6);
    let out = out.first_chunk_mut::<2>()?;
    out[0] = extra[4] + extra[0] * v5;
    out[1] = extra[6] + extra[2] * v5 + v7;
    Some(())
}

/// The state after guard check in mode REPH.
fn reset_0_check_reph(given: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let constants = given.constants.first_chunk::<171>()?;
    let state = given.state.first_chunk::<4>()?;
    let mk = constants[1];
    let ybed = constants[9];
    let zc = constants[30];
    let Rc = constants[31];
    let c168 = constants[168];
    let c169 = constants[169];
    let c170 = constants[170];
    let y = state[0];
    let u = state[2];
    let w = state[3];
    let v0 = u * mk + w * c168;
    let out = out.first_chunk_mut::<5>()?;
    out[0] = y;
    out[1] = zc + Rc * (y - ybed);
    [out[2], out[3], out[4]] = [c169 * v0, c170 * v0, 0.0];
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
    let constants = given.constants.first_chunk::<172>()?;
    let extra = given.extra.first_chunk::<7>()?;
    let c171 = constants[171];
    let out = out.first_chunk_mut::<2>()?;
    out[0] = extra[4] + extra[0] * c171;
    out[1] = extra[6] + c171 * extra[2];
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
    let constants = given.constants.first_chunk::<155>()?;
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
    let c137 = constants[137];
    let c138 = constants[138];
    let c146 = constants[146];
    let c153 = constants[153];
    let c154 = constants[154];
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
    let v21 = c146 * (y - yd);
    let v22 = functions::logistic(v21);
    let v23 = 1.0 - v22;
    let v24 = o_r - z + R * (y - wd * functions::softplus(v21));
    let v25 = u * R;
    let v26 = cr * (v25 * v23 - w);
    let v27 = functions::logistic(v26);
    let v28 = functions::softplus(v26);
    let v29 = v24 * v28;
    let v30 = c153 * v23;
    let v31 = c137 * v20 - core::f64::consts::LOG2_E * (v30 * v29);
    let v32 = core::f64::consts::LOG2_E * (c154 * v29) - (g + w * c138);
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
    let constants = given.constants.first_chunk::<155>()?;
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
    let c137 = constants[137];
    let c138 = constants[138];
    let c146 = constants[146];
    let c153 = constants[153];
    let c154 = constants[154];
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
    let v20 = c146 * y;
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
    let v31 = c153 * v22;
    let v32 = core::f64::consts::LOG2_E * (extra[68] + extra[31] * v30 + v31 * extra[32]);
    let v33 = core::f64::consts::LOG2_E * (c154 * v30) - c138 * w;
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
    out[2] = c137 * v19 - v32;
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
    let constants = given.constants.first_chunk::<155>()?;
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
    let c137 = constants[137];
    let c138 = constants[138];
    let c146 = constants[146];
    let c153 = constants[153];
    let c154 = constants[154];
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
    let v20 = c146 * (y - yd);
    let v21 = functions::logistic(v20);
    let v22 = 1.0 - v21;
    let v23 = o_r - z + R * (y - wd * functions::softplus(v20));
    let v24 = u * R;
    let v25 = cr * (v24 * v22 - w);
    let v26 = functions::logistic(v25);
    let v27 = functions::softplus(v25);
    let v28 = v23 * v27;
    let v29 = c153 * v22;
    let v30 = c137 * v19 - core::f64::consts::LOG2_E * (v29 * v28);
    let v31 = core::f64::consts::LOG2_E * (c154 * v28) - (g + w * c138);
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
    let constants = given.constants.first_chunk::<155>()?;
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
    let c137 = constants[137];
    let c138 = constants[138];
    let c146 = constants[146];
    let c153 = constants[153];
    let c154 = constants[154];
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
    let v20 = c146 * y;
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
    let v31 = c153 * v22;
    let v32 = core::f64::consts::LOG2_E * (extra[68] + extra[31] * v30 + v31 * extra[32]);
    let v33 = core::f64::consts::LOG2_E * (c154 * v30) - c138 * w;
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
    out[2] = c137 * v19 - v32;
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
    let constants = given.constants.first_chunk::<155>()?;
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
    let c137 = constants[137];
    let c138 = constants[138];
    let c146 = constants[146];
    let c153 = constants[153];
    let c154 = constants[154];
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
    let v20 = c146 * (y - yd);
    let v21 = functions::logistic(v20);
    let v22 = 1.0 - v21;
    let v23 = o_r - z + R * (y - wd * functions::softplus(v20));
    let v24 = u * R;
    let v25 = cr * (v24 * v22 - w);
    let v26 = functions::logistic(v25);
    let v27 = functions::softplus(v25);
    let v28 = v23 * v27;
    let v29 = c153 * v22;
    let v30 = c137 * v19 - core::f64::consts::LOG2_E * (v29 * v28);
    let v31 = core::f64::consts::LOG2_E * (c154 * v28) - (g + w * c138);
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
    let constants = given.constants.first_chunk::<155>()?;
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
    let c137 = constants[137];
    let c138 = constants[138];
    let c146 = constants[146];
    let c153 = constants[153];
    let c154 = constants[154];
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
    let v20 = c146 * y;
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
    let v31 = c153 * v22;
    let v32 = core::f64::consts::LOG2_E * (extra[68] + extra[31] * v30 + v31 * extra[32]);
    let v33 = core::f64::consts::LOG2_E * (c154 * v30) - c138 * w;
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
    out[2] = c137 * v19 - v32;
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
    let constants = given.constants.first_chunk::<174>()?;
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
    let c146 = constants[146];
    let c169 = constants[169];
    let c170 = constants[170];
    let c172 = constants[172];
    let c173 = constants[173];
    let y = state[0];
    let u = state[2];
    let s = input[0];
    let s_rate = input[1];
    let v0 = y - ybed;
    let v1 = functions::softplus(c37 * v0);
    let v2 = c38 * (v1 * v1) * functions::larger(1.0 + u * ab, 0.0);
    let v3 = functions::softplus(-(y * c37));
    let v4 = c39 * (v3 * v3) * functions::larger(1.0 - u * ar, 0.0);
    let v5 = c146 * (y - yd);
    let v6 = c172 - Rc * v0 + R * (y - wd * functions::softplus(v5));
    let v7 = v6 * (kr * (Rc - R * (1.0 - functions::logistic(v5))));
    let v8 = k1 * (s - y) + b1 * (s_rate - u) - (Wk + u * ck + Rc * (c44 + u * c173));
    let v9 = v8 - Fc * math::tanh(u * c40) - c42 * functions::softplus(c41 * (y - yb));
    let v10 = v9 + v7 + (v4 - v2);
    let out = out.first_chunk_mut::<4>()?;
    [out[0], out[1], out[2], out[3]] = [u, u * Rc, c169 * v10, c170 * v10];
    Some(())
}

/// The derivative of a part in mode CHK.
fn part_0_chk(given: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let constants = given.constants.first_chunk::<174>()?;
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
    let c146 = constants[146];
    let c169 = constants[169];
    let c172 = constants[172];
    let c173 = constants[173];
    let y = state[0];
    let u = state[2];
    let s = input[0];
    let s_rate = input[1];
    let v0 = y - ybed;
    let v1 = functions::softplus(c37 * v0);
    let v2 = c38 * (v1 * v1) * functions::larger(1.0 + u * ab, 0.0);
    let v3 = functions::softplus(-(y * c37));
    let v4 = c39 * (v3 * v3) * functions::larger(1.0 - u * ar, 0.0);
    let v5 = c146 * (y - yd);
    let v6 = c172 - Rc * v0 + R * (y - wd * functions::softplus(v5));
    let v7 = v6 * (kr * (Rc - R * (1.0 - functions::logistic(v5))));
    let v8 = k1 * (s - y) + b1 * (s_rate - u) - (Wk + u * ck + Rc * (c44 + u * c173));
    let v9 = v8 - Fc * math::tanh(u * c40) - c42 * functions::softplus(c41 * (y - yb));
    let out = out.first_chunk_mut::<4>()?;
    [out[0], out[1]] = [u, 0.0];
    out[2] = c169 * (v9 + v7 + (v4 - v2));
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
    let constants = given.constants.first_chunk::<176>()?;
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
    let c146 = constants[146];
    let c169 = constants[169];
    let c172 = constants[172];
    let c174 = constants[174];
    let c175 = constants[175];
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
    let v9 = c146 * (y - yd);
    let v10 = functions::logistic(v9);
    let v11 = 1.0 - v10;
    let v12 = Rc - R * v11;
    let v13 = c172 - Rc * v1 + R * (y - wd * functions::softplus(v9));
    let v14 = -v12 * (kr * v12) - (k1 + kj * functions::logistic(c41 * (y - yb)));
    let v15 = c169 * (c174 * (v10 * v11) * v13 + v14 - 2.0 * (v4 + v8));
    let v16 = if v0 > 0.0 { ab } else { 0.0 };
    let v17 = if v5 > 0.0 { c49 } else { 0.0 };
    let v18 = math::tanh(u * c40);
    let v19 = c175 + c39 * v17 * (v7 * v7) - (c38 * v16 * (v3 * v3) + c50 * (1.0 - v18 * v18));
    let out = out.first_chunk_mut::<16>()?;
    [out[0], out[1], out[2], out[3], out[4], out[5], out[6]] = [0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0];
    [out[7], out[8], out[9], out[10], out[11], out[12]] = [0.0, v15, 0.0, c169 * v19, 0.0, 0.0];
    [out[13], out[14], out[15]] = [0.0, 0.0, 0.0];
    Some(())
}

/// The outputs in mode CHK.
fn outputs_chk(given: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let constants = given.constants.first_chunk::<173>()?;
    let state = given.state.first_chunk::<3>()?;
    let input = given.input;
    let R = constants[0];
    let ybed = constants[9];
    let kr = constants[25];
    let yd = constants[28];
    let wd = constants[29];
    let zc = constants[30];
    let Rc = constants[31];
    let k1 = constants[35];
    let b1 = constants[36];
    let c53 = constants[53];
    let c54 = constants[54];
    let c55 = constants[55];
    let c56 = constants[56];
    let c57 = constants[57];
    let c59 = constants[59];
    let c60 = constants[60];
    let c61 = constants[61];
    let c62 = constants[62];
    let c113 = constants[113];
    let c145 = constants[145];
    let c146 = constants[146];
    let c164 = constants[164];
    let c165 = constants[165];
    let c172 = constants[172];
    let y = state[0];
    let u = state[2];
    let s = input[0];
    let s_rate = input[1];
    let v0 = y * c53;
    let v1 = v0 - c55;
    let v2 = Rc * (y - ybed);
    let v3 = c59 - c113 * (zc + v2);
    let v4 = R * (y - wd * functions::softplus(c146 * (y - yd)));
    let ([sin_v1, sin_v3], [cos_v1, cos_v3]) = math::sin_cos_of_two([v1, v3]);
    let v5 = sin_v1 - 1.175 * cos_v1;
    let v6 = 0.311_135_695_643_527_5 * cos_v3 + (c165 - 1.244_542_782_574_11 * v5);
    let v7 = functions::smaller(1.0, 31.113_569_564_352_75 * (c164 * sin_v3) + v6);
    let v8 = 0.093_476_781_158_589_46 + math::asin(functions::larger(-1.0, v7));
    let out = out.first_chunk_mut::<22>()?;
    out[0] = k1 * (s - y) + b1 * (s_rate - u);
    out[1] = 0.0;
    out[2] = kr * (c172 - v2 + v4);
    [out[3], out[4], out[5]] = [0.0, 0.0, 0.0];
    out[6] = c56 + 3.853_564_547_206_165_7 * y;
    [out[7], out[8], out[9]] = [0.1935, 0.042, c54 + v0];
    out[10] = 0.1935 - 0.072 * cos_v1;
    out[11] = 0.042 - 0.072 * sin_v1;
    out[12] = c145 + v0;
    out[13] = 0.1935 - 0.04 * cos_v1 - 0.047 * sin_v1;
    out[14] = 0.042 - 0.04 * v5;
    [out[15], out[16], out[17], out[18], out[19], out[20]] = [v8, c60, c61, -v3, c62, c57 - s];
    out[21] = 0.0;
    Some(())
}

/// Energy, supplied and dissipated power in mode CHK.
fn balance_chk(given: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let constants = given.constants.first_chunk::<178>()?;
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
    let c63 = constants[63];
    let c64 = constants[64];
    let c65 = constants[65];
    let c146 = constants[146];
    let c172 = constants[172];
    let c176 = constants[176];
    let c177 = constants[177];
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
    let v6 = R * (y - wd * functions::softplus(c146 * (y - yd)));
    let v7 = c172 - v5 + v6;
    let v8 = c44 * (zc + v5) + (y * Wk + u * u * (0.5 * (mk + c176)));
    let v9 = c63 * functions::softplus_area(c41 * (y - yb));
    let v10 = v8 + c65 * functions::softplus_square_area(v4);
    let v11 = v10 + (v9 + c64 * functions::softplus_square_area(v3));
    let v12 = s_rate - u;
    let v13 = b1 * v12;
    let v14 = functions::softplus(v3);
    let v15 = c38 * (functions::larger(1.0 + u * ab, 0.0) - 1.0);
    let v16 = functions::softplus(v4);
    let v17 = c39 * (functions::larger(1.0 - u * ar, 0.0) - 1.0);
    let v18 = u * c177 + (u * ck + Fc * math::tanh(u * c40)) + v14 * v14 * v15;
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
    let constants = given.constants.first_chunk::<174>()?;
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
    let c146 = constants[146];
    let c169 = constants[169];
    let c172 = constants[172];
    let c173 = constants[173];
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
    let v20 = c146 * (y - yd);
    let v21 = functions::logistic(v20);
    let v22 = c172 - v19 + R * (y - wd * functions::softplus(v20));
    let v23 = kr * (Rc - R * (1.0 - v21));
    let v24 = k1 * (s - y) + b1 * (s_rate - u) - (Wk + u * ck + Rc * (c44 + u * c173));
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
    out[1] = c169 * (v25 + (v14 * v10 - v7 * v2));
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
    let constants = given.constants.first_chunk::<174>()?;
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
    let c146 = constants[146];
    let c169 = constants[169];
    let c173 = constants[173];
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
    let v17 = c146 * y;
    let v18 = extra[51] * extra[1] + v17 * extra[21];
    let v19 = y - wd * (extra[53] * extra[1] + v17 * extra[23]);
    let v20 = -v16 + R * v19;
    let v21 = kr * -(R * -v18);
    let v22 = k1 * (s - y) + b1 * (s_rate - u) - (ck * u + Rc * (c173 * u));
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
    out[1] = c169 * (v24 + v26);
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

/// The numbers of the drawing.
fn drawing(given: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let constants = given.constants.first_chunk::<34>()?;
    let R = constants[0];
    let Wk = constants[4];
    let ybed = constants[9];
    let yb = constants[15];
    let zs = constants[21];
    let o_r = constants[27];
    let yd = constants[28];
    let wd = constants[29];
    let zc = constants[30];
    let Rc = constants[31];
    let yco = constants[33];
    let v0 = 1.0 / R;
    let v1 = zs * v0;
    let v2 = 1.926_782_273_603_082_9 * v1;
    let v3 = functions::smaller(1.0, 3.846_153_846_153_846 * zs);
    let v4 = functions::larger(math::asin(functions::larger(-1.0, v3)), 0.0);
    let v5 = 3.853_564_547_206_165_7 * ybed - v2;
    let v6 = if zs.abs() > 0.0 { 2.0 * (v4 / zs) } else { 7.692_307_692_307_692 };
    let v7 = ybed - wd * functions::softplus((ybed - yd) / wd);
    let v8 = v4 - (o_r + R * v7) * v6;
    let v9 = (zc + Rc * (0.5 * (yco - ybed))) * v6;
    let v10 = v4 - v9;
    let v11 = 2.0 * v4 - v9;
    let v12 = 1.926_782_273_603_082_9 * (ybed + yco - v1);
    let ([sin_v2, sin_v5], [cos_v2, cos_v5]) = math::sin_cos_of_two([v2, v5]);
    let v13 = 0.532_917_688_041_813_9 * cos_v2 - 0.746_084_763_258_539_6;
    let v14 = functions::smaller(1.0, v13 - 2.460_303_326_459_708 * sin_v2);
    let v15 = math::asin(functions::larger(-1.0, v14));
    let v16 = 0.214_815_400_401_658_6 + v15;
    let v17 = 0.532_917_688_041_813_9 * cos_v5 - 0.746_084_763_258_539_6;
    let v18 = functions::smaller(1.0, 2.460_303_326_459_708 * sin_v5 + v17);
    let v19 = (v15 - math::asin(functions::larger(-1.0, v18))) / ybed;
    let v20 = if ybed.abs() > 0.0 { v19 } else { 0.0 };
    let v21 = v16 - yb * v20;
    let v22 = v16 - yd * v20;
    let ([sin_v8, sin_v4], [cos_v8, cos_v4]) = math::sin_cos_of_two([v8, v4]);
    let v23 = functions::smaller(0.05, 0.090_829_217_025_748_84 * v0);
    let v24 = functions::larger(0.008, v23);
    let ([sin_v16, sin_v22], [cos_v16, cos_v22]) = math::sin_cos_of_two([v16, v22]);
    let v25 = 0.01 * sin_v4;
    let v26 = v24 * (1.0 - cos_v4) + (0.072 + v25) + 0.048 * sin_v16;
    let v27 = v26 - 0.072 * cos_v16;
    let v28 = math::sqrt(functions::larger(4.225e-5 - v27 * v27, 0.0));
    let v29 = 0.072 * (sin_v16 + 0.666_666_666_666_666_7 * cos_v16);
    let v30 = cos_v4 + 100.0 * (v24 * sin_v4) + 100.0 * (v29 + v28);
    let v31 = sin_v22 + 1.175 * cos_v22;
    let v32 = 0.140_011_063_039_587_3 + 31.113_569_564_352_75 * (v24 * sin_v8);
    let v33 = v32 + 1.244_542_782_574_11 * v31 + 0.311_135_695_643_527_5 * (cos_v8 - v30);
    let v34 = functions::larger(-1.0, functions::smaller(1.0, v33));
    let v35 = 0.093_476_781_158_589_47 + math::asin(v34);
    let v36 = 0.5 * v1;
    let v37 = functions::larger(v36.abs(), (v36 - 0.012).abs());
    let v38 = 0.13 * (sin_v4 + 0.076_923_076_923_076_93 * v30);
    let v39 = 0.092 + v38;
    let v40 = 0.012 * sin_v5;
    let v41 = 0.239_500_000_000_000_02 * cos_v5;
    let v42 = v40 - 0.01 - v41;
    let v43 = 0.239_500_000_000_000_02 * (sin_v5 + 0.050_104_384_133_611_686 * cos_v5);
    let v44 = -(0.005 + v43);
    let v45 = 0.01 + v40 - v41;
    let v46 = -v43;
    let v47 = 0.012 * sin_v2;
    let v48 = 0.215 * cos_v2;
    let v49 = v48 - (0.01 + v47);
    let v50 = 0.215 * (sin_v2 + 0.055_813_953_488_372_09 * cos_v2);
    let v51 = -(0.005 + v50);
    let v52 = v48 + (0.01 - v47);
    let v53 = -v50;
    let v54 = 0.076_500_000_000_000_01 - v24;
    let v55 = 0.01 * v30;
    let v56 = 0.036_000_000_000_000_004 + v55;
    let v57 = 0.103_500_000_000_000_01 - v24;
    let v58 = 0.052_000_000_000_000_005 + v55;
    let v59 = 0.124_500_000_000_000_01 - v24;
    let ([sin_v35, sin_v21], [cos_v35, cos_v21]) = math::sin_cos_of_two([v35, v21]);
    let v60 = 0.003 * (sin_v35 + 15.0 * cos_v35);
    let v61 = 0.047 * (sin_v22 - 0.851_063_829_787_234 * cos_v22);
    let v62 = 0.1935 + v61 - v60;
    let v63 = sin_v35 - 0.066_666_666_666_666_67 * cos_v35;
    let v64 = v31 - f64::from_bits(0x3ff2_0000_0000_0000) * v63;
    let v65 = 0.04 * v64;
    let v66 = 0.042 + v65;
    let v67 = 0.1915 + v61 - v60;
    let v68 = 0.1955 + v61 - v60;
    let v69 = 0.044_000_000_000_000_004 + v65;
    let v70 = 0.122 * cos_v21;
    let v71 = 0.1935 + 0.012 * sin_v21;
    let v72 = 0.122 * sin_v21;
    let v73 = 0.042 + 0.012 * cos_v21;
    let v74 = 0.096 * cos_v21;
    let v75 = 0.096 * sin_v21;
    let v76 = 0.027_999_999_999_999_997 * sin_v21;
    let v77 = 0.1935 - v74;
    let v78 = 0.027_999_999_999_999_997 * cos_v21;
    let v79 = 0.042 + v75;
    let v80 = 0.016 * sin_v21;
    let v81 = 0.016 * cos_v21;
    let v82 = 0.088 * cos_v21;
    let v83 = 0.088 * sin_v21;
    let v84 = 0.009_000_000_000_000_001 * sin_v21 + (0.1935 - v82);
    let v85 = 0.009_000_000_000_000_001 * cos_v21 + (0.042 + v83);
    let v86 = 0.091 * cos_v21;
    let v87 = 0.1935 + 0.006 * sin_v21;
    let v88 = 0.091 * sin_v21;
    let v89 = 0.042 + 0.006 * cos_v21;
    let v90 = 0.084_999_999_999_999_99 * cos_v21;
    let v91 = 0.084_999_999_999_999_99 * sin_v21;
    let v92 = 0.01 * sin_v21;
    let v93 = 0.01 * cos_v21;
    let ([sin_v10, sin_v11], [cos_v10, cos_v11]) = math::sin_cos_of_two([v10, v11]);
    let v94 = 0.121_500_000_000_000_01 - v24 + 0.009 * cos_v11 + (0.13 * cos_v10 - 0.02 * sin_v11);
    let (sin_v12, cos_v12) = math::sin_cos(v12);
    let v95 = 0.042 - 0.009 * sin_v11 - (0.02 * cos_v11 + 0.13 * sin_v10);
    let v96 = v95 + v55;
    let v97 = cos_v12 * v94 + sin_v12 * v96;
    let v98 = 0.012 + v97;
    let v99 = if -Wk > 0.0 { 1.0 } else { 0.0 };
    let v100 = -(0.155_094_445_042_265_6 * v99);
    let v101 = 0.001_552_914_270_615_124_6 * v99;
    let v102 = -(0.155_693_847_577_293_38 * v99);
    let v103 = 0.002_999_999_999_999_999_6 * v99;
    let v104 = -(0.156_647_359_312_880_7 * v99);
    let v105 = 0.004_242_640_687_119_285 * v99;
    let v106 = -(0.15789 * v99);
    let v107 = 0.005_196_152_422_706_632 * v99;
    let v108 = -(0.159_337_085_729_384_88 * v99);
    let v109 = 0.005_795_554_957_734_41 * v99;
    let v110 = -(0.16089 * v99);
    let v111 = 0.006 * v99;
    let v112 = -(0.162_442_914_270_615_14 * v99);
    let v113 = -(0.16389 * v99);
    let v114 = 0.005_196_152_422_706_633 * v99;
    let v115 = -(0.165_132_640_687_119_3 * v99);
    let v116 = 0.004_242_640_687_119_286 * v99;
    let v117 = -(0.166_086_152_422_706_63 * v99);
    let v118 = -(0.166_685_554_957_734_4 * v99);
    let v119 = 0.001_552_914_270_615_126 * v99;
    let v120 = 7.347_880_794_884_119e-19 * v99;
    let v121 = -(0.001_552_914_270_615_124_8 * v99);
    let v122 = -(0.002_999_999_999_999_998_3 * v99);
    let v123 = -(0.004_242_640_687_119_283 * v99);
    let v124 = -(0.005_196_152_422_706_63 * v99);
    let v125 = -v109;
    let v126 = -v111;
    let v127 = -(0.005_795_554_957_734_410_5 * v99);
    let v128 = -v107;
    let v129 = -(0.004_242_640_687_119_287 * v99);
    let v130 = -(0.003_000_000_000_000_002_7 * v99);
    let v131 = -(0.001_552_914_270_615_129_6 * v99);
    let v132 = -(0.103_194_445_042_265_59 * v99);
    let v133 = -(0.103_793_847_577_293_37 * v99);
    let v134 = -(0.104_747_359_312_880_72 * v99);
    let v135 = -(0.10599 * v99);
    let v136 = -(0.10899 * v99);
    let v137 = -(0.110_542_914_270_615_13 * v99);
    let v138 = -(0.11199 * v99);
    let v139 = -(0.113_232_640_687_119_29 * v99);
    let v140 = -(0.114_186_152_422_706_63 * v99);
    let v141 = -(0.114_785_554_957_734_42 * v99);
    let v142 = sin_v12 * v94 - cos_v12 * v96;
    let v143 = v97 - 0.000_556_918_164_431_386_9;
    let v144 = -(0.014_306_985_781_712_595 + v142);
    let v145 = 0.004_638_564_979_913_594 + v97;
    let v146 = 0.006_040_175_074_210_945 - v142;
    let v147 = v24 - 0.001;
    let v148 = 0.001 + v24;
    let v149 = 0.002_250_000_000_000_000_3 + v24;
    let v150 = v24 - 0.001_164_685_702_961_342_7;
    let v151 = 0.004 * cos_v4;
    let v152 = 0.036_000_000_000_000_004 * sin_v4;
    let v153 = 0.13 - v151;
    let v154 = 0.004 * sin_v4;
    let v155 = 0.036_000_000_000_000_004 * cos_v4;
    let v156 = 0.005 * cos_v4;
    let v157 = 0.005 * sin_v4;
    let v158 = 0.13 + 0.006 * cos_v4 - 0.026_000_000_000_000_002 * sin_v4;
    let v159 = 0.006 * sin_v4 + 0.026_000_000_000_000_002 * cos_v4;
    let v160 = 0.13 + 0.009_000_000_000_000_001 * cos_v4 - 0.02 * sin_v4;
    let v161 = 0.009_000_000_000_000_001 * sin_v4 + 0.02 * cos_v4;
    let v162 = 0.00525 * cos_v4;
    let v163 = 0.0143 * sin_v4;
    let v164 = 0.00525 * sin_v4;
    let v165 = 0.0143 * cos_v4;
    let v166 = 0.00945 * cos_v4;
    let v167 = 0.024_800_000_000_000_003 * sin_v4;
    let v168 = 0.00945 * sin_v4;
    let v169 = 0.024_800_000_000_000_003 * cos_v4;
    let v170 = 0.0105 * cos_v4;
    let v171 = 0.035_300_000_000_000_005 * sin_v4;
    let v172 = 0.0105 * sin_v4;
    let v173 = 0.035_300_000_000_000_005 * cos_v4;
    let v174 = 0.008_137_207_050_000_001 * cos_v4;
    let v175 = 0.043_684_674_2 * sin_v4;
    let v176 = 0.008_137_207_050_000_001 * sin_v4;
    let v177 = 0.043_684_674_2 * cos_v4;
    let v178 = 0.007_022_618_400_000_001 * cos_v4;
    let v179 = 0.046_208_994_950_000_006 * sin_v4;
    let v180 = 0.007_022_618_400_000_001 * sin_v4;
    let v181 = 0.046_208_994_950_000_006 * cos_v4;
    let v182 = 0.005_150_181_750_000_001 * cos_v4;
    let v183 = 0.048_235_934_9 * sin_v4;
    let v184 = 0.005_150_181_750_000_001 * sin_v4;
    let v185 = 0.048_235_934_9 * cos_v4;
    let v186 = 0.002_721_961_2 * cos_v4;
    let v187 = 0.049_546_755_95 * sin_v4;
    let v188 = 0.002_721_961_2 * sin_v4;
    let v189 = 0.049_546_755_95 * cos_v4;
    let out = out.first_chunk_mut::<738>()?;
    out[0] = -0.284_500_000_000_000_03;
    out[1] = -(0.028 + v37);
    [out[2], out[3]] = [0.275, 0.108 + v38];
    out[4] = 0.13 * cos_v4 - (0.0785 + v24);
    [out[5], out[6], out[7], out[8], out[9], out[10]] = [v39, 0.275, v39, 0.0, -0.012, -0.012];
    [out[11], out[12], out[13], out[14], out[15]] = [-0.022, -0.012, -0.028, 0.012, -0.028];
    [out[16], out[17], out[18], out[19], out[20]] = [0.012, -0.022, 0.0, -0.012, 0.0];
    [out[21], out[22], out[23], out[24], out[25], out[26]] = [0.016, v42, v44, v45, v44, v45];
    [out[27], out[28], out[29], out[30], out[31], out[32]] = [v46, v42, v46, v49, v51, v52];
    [out[33], out[34], out[35], out[36], out[37], out[38]] = [v51, v52, v53, v49, v53, v54];
    [out[39], out[40], out[41], out[42], out[43], out[44]] = [v56, v57, v56, v57, v58, v54];
    [out[45], out[46]] = [v58, v57];
    out[47] = 0.037_000_000_000_000_005 + v55;
    [out[48], out[49], out[50]] = [v59, 0.039 + v55, v59];
    out[51] = 0.045_000_000_000_000_005 + v55;
    [out[52], out[53], out[54], out[55], out[56]] = [v57, 0.048 + v55, v62, 0.042 + v55, v62];
    [out[57], out[58], out[59], out[60], out[61], out[62]] = [v66, v67, v66, v68, v66, v68];
    [out[63], out[64], out[65], out[66], out[67]] = [v69, v67, v69, v71 - v70, v72 + v73];
    [out[68], out[69], out[70], out[71]] = [v71 - v74, v75 + v73, v76 + v77, v78 + v79];
    out[72] = v76 + (0.1935 - v70);
    out[73] = v78 + (0.042 + v72);
    [out[74], out[75]] = [v80 + v77, v81 + v79];
    out[76] = 0.1935 + v80 - v82;
    out[77] = v83 + (0.042 + v81);
    [out[78], out[79], out[80], out[81], out[82]] = [v84, v85, v87 - v86, v88 + v89, v87 - v90];
    out[83] = v91 + v89;
    out[84] = v92 + (0.1935 - v90);
    out[85] = v93 + (0.042 + v91);
    out[86] = v92 + (0.1935 - v86);
    out[87] = v93 + (0.042 + v88);
    [out[88], out[89], out[90], out[91]] = [0.1915, 0.039, 0.1995, 0.039];
    out[92] = 0.205_500_000_000_000_02;
    out[93] = 0.054_000_000_000_000_006;
    out[94] = 0.1975;
    out[95] = 0.054_000_000_000_000_006;
    out[96] = 0.1945;
    out[97] = 0.054_000_000_000_000_006;
    out[98] = 0.209_500_000_000_000_02;
    out[99] = 0.054_000_000_000_000_006;
    out[100] = 0.209_500_000_000_000_02;
    [out[101], out[102], out[103], out[104], out[105]] = [0.064, 0.1945, 0.064, -0.2595, -0.012];
    [out[106], out[107], out[108], out[109], out[110]] = [v98, -0.012, v98, 0.012, -0.2595];
    out[111] = 0.012;
    out[112] = -(0.15489 * v99);
    [out[113], out[114], out[115], out[116], out[117]] = [0.0, v100, v101, v102, v103];
    [out[118], out[119], out[120], out[121], out[122]] = [v104, v105, v106, v107, v108];
    [out[123], out[124], out[125], out[126], out[127]] = [v109, v110, v111, v112, v109];
    [out[128], out[129], out[130], out[131], out[132]] = [v113, v114, v115, v116, v117];
    [out[133], out[134], out[135]] = [v103, v118, v119];
    out[136] = -(0.16689 * v99);
    [out[137], out[138], out[139], out[140], out[141]] = [v120, v118, v121, v117, v122];
    [out[142], out[143], out[144], out[145], out[146]] = [v115, v123, v113, v124, v112];
    [out[147], out[148], out[149], out[150], out[151]] = [v125, v110, v126, v108, v127];
    [out[152], out[153], out[154], out[155], out[156]] = [v106, v128, v104, v129, v102];
    [out[157], out[158], out[159]] = [v130, v100, v131];
    out[160] = -(0.10299 * v99);
    [out[161], out[162], out[163], out[164], out[165]] = [0.0, v132, v101, v133, v103];
    [out[166], out[167], out[168], out[169]] = [v134, v105, v135, v107];
    out[170] = -(0.107_437_085_729_384_87 * v99);
    [out[171], out[172], out[173], out[174], out[175]] = [v109, v136, v111, v137, v109];
    [out[176], out[177], out[178], out[179], out[180]] = [v138, v114, v139, v116, v140];
    [out[181], out[182], out[183]] = [v103, v141, v119];
    out[184] = -(0.114_990_000_000_000_01 * v99);
    [out[185], out[186], out[187], out[188], out[189]] = [v120, v141, v121, v140, v122];
    [out[190], out[191], out[192], out[193], out[194]] = [v139, v123, v138, v124, v137];
    [out[195], out[196], out[197]] = [v125, v136, v126];
    out[198] = -(0.107_437_085_729_384_89 * v99);
    [out[199], out[200], out[201], out[202], out[203]] = [v127, v135, v128, v134, v129];
    [out[204], out[205], out[206], out[207], out[208]] = [v133, v130, v132, v131, 0.002];
    out[209] = 0.0;
    out[210] = 0.001_931_851_652_578_136_8;
    out[211] = 0.000_517_638_090_205_041_5;
    out[212] = 0.001_732_050_807_568_877_4;
    out[213] = 0.000_999_999_999_999_999_8;
    out[214] = 0.001_414_213_562_373_095_2;
    out[215] = 0.001_414_213_562_373_095;
    out[216] = 0.001_000_000_000_000_000_2;
    out[217] = 0.001_732_050_807_568_877_2;
    out[218] = 0.000_517_638_090_205_041_5;
    out[219] = 0.001_931_851_652_578_136_8;
    out[220] = 1.224_646_799_147_353_1e-19;
    out[221] = 0.002;
    out[222] = -0.000_517_638_090_205_041_3;
    out[223] = 0.001_931_851_652_578_136_8;
    out[224] = -0.000_999_999_999_999_999_6;
    out[225] = 0.001_732_050_807_568_877_4;
    out[226] = -0.001_414_213_562_373_095;
    out[227] = 0.001_414_213_562_373_095_2;
    out[228] = -0.001_732_050_807_568_877_4;
    out[229] = 0.000_999_999_999_999_999_8;
    out[230] = -0.001_931_851_652_578_136_5;
    out[231] = 0.000_517_638_090_205_042_1;
    out[232] = -0.002;
    out[233] = 2.449_293_598_294_706_3e-19;
    out[234] = -0.001_931_851_652_578_136_8;
    out[235] = -0.000_517_638_090_205_041_6;
    out[236] = -0.001_732_050_807_568_877_6;
    out[237] = -0.000_999_999_999_999_999_4;
    out[238] = -0.001_414_213_562_373_096;
    out[239] = -0.001_414_213_562_373_094_4;
    out[240] = -0.001_000_000_000_000_000_9;
    out[241] = -0.001_732_050_807_568_876_7;
    out[242] = -0.000_517_638_090_205_041_3;
    out[243] = -0.001_931_851_652_578_136_8;
    out[244] = -3.673_940_397_442_059_7e-19;
    out[245] = -0.002;
    out[246] = 0.000_517_638_090_205_040_7;
    out[247] = -0.001_931_851_652_578_137;
    out[248] = 0.001_000_000_000_000_000_2;
    out[249] = -0.001_732_050_807_568_877_2;
    out[250] = 0.001_414_213_562_373_094_8;
    out[251] = -0.001_414_213_562_373_095_5;
    out[252] = 0.001_732_050_807_568_876_7;
    out[253] = -0.001_000_000_000_000_000_9;
    out[254] = 0.001_931_851_652_578_136_1;
    out[255] = -0.000_517_638_090_205_043_1;
    [out[256], out[257], out[258], out[259], out[260]] = [0.137, 0.012, 0.14, 0.012, 0.14];
    [out[261], out[262], out[263]] = [0.026, 0.137, 0.026];
    out[264] = 0.142_500_000_000_000_02;
    out[265] = 0.026;
    out[266] = 0.142_363_703_305_156_3;
    out[267] = 0.027_035_276_180_410_083;
    out[268] = 0.141_964_101_615_137_76;
    out[269] = 0.027_999_999_999_999_997;
    out[270] = 0.141_328_427_124_746_2;
    out[271] = 0.028_828_427_124_746_19;
    out[272] = 0.1405;
    out[273] = 0.029_464_101_615_137_753;
    out[274] = 0.139_535_276_180_410_1;
    out[275] = 0.029_863_703_305_156_274;
    [out[276], out[277]] = [0.1385, 0.03];
    out[278] = 0.137_464_723_819_589_93;
    out[279] = 0.029_863_703_305_156_274;
    out[280] = 0.1365;
    out[281] = 0.029_464_101_615_137_753;
    out[282] = 0.135_671_572_875_253_83;
    out[283] = 0.028_828_427_124_746_19;
    out[284] = 0.135_035_898_384_862_27;
    out[285] = 0.027_999_999_999_999_997;
    out[286] = 0.134_636_296_694_843_73;
    out[287] = 0.027_035_276_180_410_083;
    [out[288], out[289]] = [0.1345, 0.026];
    out[290] = 0.134_636_296_694_843_73;
    out[291] = 0.024_964_723_819_589_914;
    out[292] = 0.135_035_898_384_862_27;
    out[293] = 0.024;
    out[294] = 0.135_671_572_875_253_83;
    out[295] = 0.023_171_572_875_253_81;
    out[296] = 0.1365;
    out[297] = 0.022_535_898_384_862_245;
    out[298] = 0.137_464_723_819_589_93;
    out[299] = 0.022_136_296_694_843_724;
    [out[300], out[301]] = [0.1385, 0.022];
    out[302] = 0.139_535_276_180_410_1;
    out[303] = 0.022_136_296_694_843_724;
    out[304] = 0.1405;
    out[305] = 0.022_535_898_384_862_245;
    out[306] = 0.141_328_427_124_746_2;
    out[307] = 0.023_171_572_875_253_81;
    out[308] = 0.141_964_101_615_137_76;
    out[309] = 0.023_999_999_999_999_997;
    out[310] = 0.142_363_703_305_156_3;
    out[311] = 0.024_964_723_819_589_91;
    [out[312], out[313]] = [0.004 + v97, 0.012];
    out[314] = 0.003_834_242_856_227_685 + v97;
    out[315] = -(0.009_235_723_129_212_295 + v142);
    [out[316], out[317]] = [v143, v144];
    out[318] = 0.005_256_556_365_832_482 + v97;
    out[319] = -(0.015_791_409_537_239_735 + v142);
    out[320] = 0.010_452_039_510_177_464 + v97;
    out[321] = 0.004_555_751_318_683_807 - v142;
    [out[322], out[323]] = [v145, v146];
    out[324] = v97 - 0.003_463_655_429_563_321;
    out[325] = -(0.013_564_773_903_949_027 + v142);
    [out[326], out[327], out[328], out[329]] = [v143, v144, v145, v146];
    out[330] = 0.001_731_827_714_781_660_5 + v97;
    out[331] = 0.006_782_386_951_974_514 - v142;
    [out[332], out[333], out[334], out[335], out[336]] = [0.006, -0.004, 0.006, 0.004, -0.034];
    [out[337], out[338], out[339]] = [0.006, -0.037, 0.047];
    out[340] = -0.043_000_000_000_000_003;
    [out[341], out[342], out[343], out[344], out[345]] = [0.047, -0.045, 0.006, -0.065, 0.006];
    [out[346], out[347], out[348], out[349], out[350]] = [-0.068, 0.004, -0.078, 0.0, -0.077];
    [out[351], out[352], out[353], out[354], out[355]] = [-0.007, -0.061, -0.007, -0.06, -0.01];
    [out[356], out[357], out[358], out[359], out[360]] = [-0.05, -0.01, -0.049, -0.006, -0.06];
    [out[361], out[362], out[363], out[364], out[365]] = [-0.012, -0.05, -0.012, -0.05, -0.01];
    [out[366], out[367], out[368], out[369]] = [-0.06, -0.01, 0.002, 0.0];
    out[370] = 0.001_931_851_652_578_136_8;
    out[371] = 0.000_517_638_090_205_041_5;
    out[372] = 0.001_732_050_807_568_877_4;
    out[373] = 0.000_999_999_999_999_999_8;
    out[374] = 0.001_414_213_562_373_095_2;
    out[375] = 0.001_414_213_562_373_095;
    out[376] = 0.001_000_000_000_000_000_2;
    out[377] = 0.001_732_050_807_568_877_2;
    out[378] = 0.000_517_638_090_205_041_5;
    out[379] = 0.001_931_851_652_578_136_8;
    out[380] = 1.224_646_799_147_353_1e-19;
    out[381] = 0.002;
    out[382] = -0.000_517_638_090_205_041_3;
    out[383] = 0.001_931_851_652_578_136_8;
    out[384] = -0.000_999_999_999_999_999_6;
    out[385] = 0.001_732_050_807_568_877_4;
    out[386] = -0.001_414_213_562_373_095;
    out[387] = 0.001_414_213_562_373_095_2;
    out[388] = -0.001_732_050_807_568_877_4;
    out[389] = 0.000_999_999_999_999_999_8;
    out[390] = -0.001_931_851_652_578_136_5;
    out[391] = 0.000_517_638_090_205_042_1;
    out[392] = -0.002;
    out[393] = 2.449_293_598_294_706_3e-19;
    out[394] = -0.001_931_851_652_578_136_8;
    out[395] = -0.000_517_638_090_205_041_6;
    out[396] = -0.001_732_050_807_568_877_6;
    out[397] = -0.000_999_999_999_999_999_4;
    out[398] = -0.001_414_213_562_373_096;
    out[399] = -0.001_414_213_562_373_094_4;
    out[400] = -0.001_000_000_000_000_000_9;
    out[401] = -0.001_732_050_807_568_876_7;
    out[402] = -0.000_517_638_090_205_041_3;
    out[403] = -0.001_931_851_652_578_136_8;
    out[404] = -3.673_940_397_442_059_7e-19;
    out[405] = -0.002;
    out[406] = 0.000_517_638_090_205_040_7;
    out[407] = -0.001_931_851_652_578_137;
    out[408] = 0.001_000_000_000_000_000_2;
    out[409] = -0.001_732_050_807_568_877_2;
    out[410] = 0.001_414_213_562_373_094_8;
    out[411] = -0.001_414_213_562_373_095_5;
    out[412] = 0.001_732_050_807_568_876_7;
    out[413] = -0.001_000_000_000_000_000_9;
    out[414] = 0.001_931_851_652_578_136_1;
    out[415] = -0.000_517_638_090_205_043_1;
    [out[416], out[417], out[418], out[419], out[420]] = [0.003, -0.004, 0.002, 0.015, 0.002];
    [out[421], out[422], out[423], out[424]] = [0.048, 0.00174, 0.049, 0.001];
    out[425] = 0.049_740_000_000_000_006;
    [out[426], out[427], out[428]] = [0.0, 0.05, -0.0032];
    out[429] = 0.049_600_000_000_000_005;
    [out[430], out[431], out[432], out[433]] = [-0.0032, 0.015, -0.005, 0.006];
    out[434] = -0.018_000_000_000_000_002;
    out[435] = 0.006;
    out[436] = -0.018_000_000_000_000_002;
    [out[437], out[438], out[439], out[440], out[441]] = [0.002, -0.004, -0.004, 0.0015, 0.0];
    out[442] = 0.001_448_888_739_433_602_6;
    out[443] = 0.000_388_228_567_653_781_14;
    out[444] = 0.001_299_038_105_676_658;
    out[445] = 0.000_749_999_999_999_999_9;
    out[446] = 0.001_060_660_171_779_821_4;
    out[447] = 0.001_060_660_171_779_821_2;
    out[448] = 0.000_750_000_000_000_000_2;
    out[449] = 0.001_299_038_105_676_658;
    out[450] = 0.000_388_228_567_653_781_14;
    out[451] = 0.001_448_888_739_433_602_6;
    out[452] = 9.184_850_993_605_149e-20;
    out[453] = 0.0015;
    out[454] = -0.000_388_228_567_653_780_9;
    out[455] = 0.001_448_888_739_433_602_6;
    out[456] = -0.000_749_999_999_999_999_7;
    out[457] = 0.001_299_038_105_676_658;
    out[458] = -0.001_060_660_171_779_821_2;
    out[459] = 0.001_060_660_171_779_821_4;
    out[460] = -0.001_299_038_105_676_658;
    out[461] = 0.000_749_999_999_999_999_9;
    out[462] = -0.001_448_888_739_433_602_4;
    out[463] = 0.000_388_228_567_653_781_6;
    out[464] = -0.0015;
    out[465] = 1.836_970_198_721_029_8e-19;
    out[466] = -0.001_448_888_739_433_602_6;
    out[467] = -0.000_388_228_567_653_781_25;
    out[468] = -0.001_299_038_105_676_658_2;
    out[469] = -0.000_749_999_999_999_999_6;
    out[470] = -0.001_060_660_171_779_821_9;
    out[471] = -0.001_060_660_171_779_820_8;
    out[472] = -0.000_750_000_000_000_000_7;
    out[473] = -0.001_299_038_105_676_657_5;
    out[474] = -0.000_388_228_567_653_780_9;
    out[475] = -0.001_448_888_739_433_602_6;
    out[476] = -2.755_455_298_081_545e-19;
    out[477] = -0.0015;
    out[478] = 0.000_388_228_567_653_780_44;
    out[479] = -0.001_448_888_739_433_602_6;
    out[480] = 0.000_750_000_000_000_000_2;
    out[481] = -0.001_299_038_105_676_658;
    out[482] = 0.001_060_660_171_779_821;
    out[483] = -0.001_060_660_171_779_821_4;
    out[484] = 0.001_299_038_105_676_657_5;
    out[485] = -0.000_750_000_000_000_000_7;
    out[486] = 0.001_448_888_739_433_602_2;
    out[487] = -0.000_388_228_567_653_782_33;
    out[488] = -0.051_000_000_000_000_004;
    out[489] = 0.003;
    out[490] = -0.051_000_000_000_000_004;
    out[491] = -0.001;
    out[492] = -0.026_000_000_000_000_002;
    [out[493], out[494]] = [-0.0025, 0.0];
    out[495] = -0.004_500_000_000_000_000_5;
    out[496] = 0.018_000_000_000_000_002;
    out[497] = -0.002;
    out[498] = 0.018_000_000_000_000_002;
    [out[499], out[500], out[501], out[502], out[503]] = [0.002, -0.006, 0.003, 0.0015, 0.0];
    out[504] = 0.001_448_888_739_433_602_6;
    out[505] = 0.000_388_228_567_653_781_14;
    out[506] = 0.001_299_038_105_676_658;
    out[507] = 0.000_749_999_999_999_999_9;
    out[508] = 0.001_060_660_171_779_821_4;
    out[509] = 0.001_060_660_171_779_821_2;
    out[510] = 0.000_750_000_000_000_000_2;
    out[511] = 0.001_299_038_105_676_658;
    out[512] = 0.000_388_228_567_653_781_14;
    out[513] = 0.001_448_888_739_433_602_6;
    out[514] = 9.184_850_993_605_149e-20;
    out[515] = 0.0015;
    out[516] = -0.000_388_228_567_653_780_9;
    out[517] = 0.001_448_888_739_433_602_6;
    out[518] = -0.000_749_999_999_999_999_7;
    out[519] = 0.001_299_038_105_676_658;
    out[520] = -0.001_060_660_171_779_821_2;
    out[521] = 0.001_060_660_171_779_821_4;
    out[522] = -0.001_299_038_105_676_658;
    out[523] = 0.000_749_999_999_999_999_9;
    out[524] = -0.001_448_888_739_433_602_4;
    out[525] = 0.000_388_228_567_653_781_6;
    out[526] = -0.0015;
    out[527] = 1.836_970_198_721_029_8e-19;
    out[528] = -0.001_448_888_739_433_602_6;
    out[529] = -0.000_388_228_567_653_781_25;
    out[530] = -0.001_299_038_105_676_658_2;
    out[531] = -0.000_749_999_999_999_999_6;
    out[532] = -0.001_060_660_171_779_821_9;
    out[533] = -0.001_060_660_171_779_820_8;
    out[534] = -0.000_750_000_000_000_000_7;
    out[535] = -0.001_299_038_105_676_657_5;
    out[536] = -0.000_388_228_567_653_780_9;
    out[537] = -0.001_448_888_739_433_602_6;
    out[538] = -2.755_455_298_081_545e-19;
    out[539] = -0.0015;
    out[540] = 0.000_388_228_567_653_780_44;
    out[541] = -0.001_448_888_739_433_602_6;
    out[542] = 0.000_750_000_000_000_000_2;
    out[543] = -0.001_299_038_105_676_658;
    out[544] = 0.001_060_660_171_779_821;
    out[545] = -0.001_060_660_171_779_821_4;
    out[546] = 0.001_299_038_105_676_657_5;
    out[547] = -0.000_750_000_000_000_000_7;
    out[548] = 0.001_448_888_739_433_602_2;
    out[549] = -0.000_388_228_567_653_782_33;
    [out[550], out[551], out[552], out[553]] = [-0.004, -0.004, 0.008 + v24, -0.005];
    [out[554], out[555], out[556], out[557], out[558]] = [0.014 + v24, -0.003, 0.13, -0.003, 0.13];
    [out[559], out[560], out[561], out[562], out[563]] = [0.003, -0.004, 0.004, v147, -0.01];
    [out[564], out[565], out[566], out[567], out[568]] = [v148, -0.01, v148, -0.005, v147];
    [out[569], out[570], out[571]] = [-0.005, 0.0045 + v24, -0.01];
    out[572] = 0.004_346_666_218_300_807 + v24;
    out[573] = -0.008_835_314_297_038_658;
    out[574] = 0.003_897_114_317_029_974 + v24;
    out[575] = -0.007_750_000_000_000_001;
    out[576] = 0.003_181_980_515_339_464 + v24;
    out[577] = -0.006_818_019_484_660_537;
    out[578] = v149;
    out[579] = -0.006_102_885_682_970_027;
    out[580] = 0.001_164_685_702_961_343_2 + v24;
    out[581] = -0.005_653_333_781_699_193;
    out[582] = 2.755_455_298_081_544_4e-19 + v24;
    out[583] = -0.005_500_000_000_000_000_5;
    out[584] = v150;
    out[585] = -0.005_653_333_781_699_193;
    out[586] = v24 - 0.002_249_999_999_999_999;
    out[587] = -0.006_102_885_682_970_027;
    out[588] = v24 - 0.003_181_980_515_339_463_4;
    out[589] = -0.006_818_019_484_660_536;
    out[590] = v24 - 0.003_897_114_317_029_974;
    out[591] = -0.007_750_000_000_000_001;
    out[592] = v24 - 0.004_346_666_218_300_806;
    out[593] = -0.008_835_314_297_038_656;
    [out[594], out[595]] = [v24 - 0.0045, -0.01];
    out[596] = v24 - 0.004_346_666_218_300_807;
    out[597] = -0.011_164_685_702_961_344;
    out[598] = v24 - 0.003_897_114_317_029_974_5;
    out[599] = -0.012_249_999_999_999_999;
    out[600] = v24 - 0.003_181_980_515_339_465;
    out[601] = -0.013_181_980_515_339_461;
    out[602] = v24 - 0.002_250_000_000_000_002;
    out[603] = -0.013_897_114_317_029_972;
    out[604] = v150;
    out[605] = -0.014_346_666_218_300_807;
    out[606] = v24 - 8.266_365_894_244_633e-19;
    out[607] = -0.014_499_999_999_999_999;
    out[608] = 0.001_164_685_702_961_341_2 + v24;
    out[609] = -0.014_346_666_218_300_809;
    out[610] = v149;
    out[611] = -0.013_897_114_317_029_974;
    out[612] = 0.003_181_980_515_339_463 + v24;
    out[613] = -0.013_181_980_515_339_465;
    out[614] = 0.003_897_114_317_029_972_3 + v24;
    out[615] = -0.012_250_000_000_000_002;
    out[616] = 0.004_346_666_218_300_806 + v24;
    out[617] = -0.011_164_685_702_961_348;
    [out[618], out[619]] = [v152 + v153, v154 + v155];
    out[620] = 0.13 - v25 - v156;
    out[621] = v157 - 0.01 * cos_v4;
    out[622] = v153 - 0.024 * sin_v4;
    out[623] = v154 - 0.024 * cos_v4;
    out[624] = 0.13 - 0.001 * cos_v4 - 0.027 * sin_v4;
    out[625] = 0.001 * sin_v4 - 0.027 * cos_v4;
    [out[626], out[627], out[628], out[629]] = [v158, -v159, v160, -v161];
    out[630] = 0.13 + 0.0085 * cos_v4 - 0.014 * sin_v4;
    out[631] = -(0.0085 * sin_v4 + 0.014 * cos_v4);
    out[632] = 0.002 * sin_v4 + (0.13 + v156);
    out[633] = 0.002 * cos_v4 - v157;
    out[634] = v152 + (0.13 + v151);
    out[635] = v155 - v154;
    out[636] = v163 + (0.13 + v162);
    out[637] = v165 - v164;
    out[638] = v167 + (0.13 + v166);
    out[639] = v169 - v168;
    out[640] = v171 + (0.13 + v170);
    out[641] = v173 - v172;
    out[642] = v175 + (0.13 + v174);
    out[643] = v177 - v176;
    out[644] = v179 + (0.13 + v178);
    out[645] = v181 - v180;
    out[646] = v183 + (0.13 + v182);
    out[647] = v185 - v184;
    out[648] = v187 + (0.13 + v186);
    out[649] = v189 - v188;
    out[650] = 0.13 + 0.05 * sin_v4;
    out[651] = 0.05 * cos_v4;
    out[652] = v187 + (0.13 - v186);
    out[653] = v188 + v189;
    out[654] = v183 + (0.13 - v182);
    out[655] = v184 + v185;
    out[656] = v179 + (0.13 - v178);
    out[657] = v180 + v181;
    out[658] = v175 + (0.13 - v174);
    out[659] = v176 + v177;
    out[660] = v171 + (0.13 - v170);
    out[661] = v172 + v173;
    out[662] = v167 + (0.13 - v166);
    out[663] = v168 + v169;
    out[664] = v163 + (0.13 - v162);
    [out[665], out[666], out[667]] = [v164 + v165, 0.002, 0.0];
    out[668] = 0.001_931_851_652_578_136_8;
    out[669] = 0.000_517_638_090_205_041_5;
    out[670] = 0.001_732_050_807_568_877_4;
    out[671] = 0.000_999_999_999_999_999_8;
    out[672] = 0.001_414_213_562_373_095_2;
    out[673] = 0.001_414_213_562_373_095;
    out[674] = 0.001_000_000_000_000_000_2;
    out[675] = 0.001_732_050_807_568_877_2;
    out[676] = 0.000_517_638_090_205_041_5;
    out[677] = 0.001_931_851_652_578_136_8;
    out[678] = 1.224_646_799_147_353_1e-19;
    out[679] = 0.002;
    out[680] = -0.000_517_638_090_205_041_3;
    out[681] = 0.001_931_851_652_578_136_8;
    out[682] = -0.000_999_999_999_999_999_6;
    out[683] = 0.001_732_050_807_568_877_4;
    out[684] = -0.001_414_213_562_373_095;
    out[685] = 0.001_414_213_562_373_095_2;
    out[686] = -0.001_732_050_807_568_877_4;
    out[687] = 0.000_999_999_999_999_999_8;
    out[688] = -0.001_931_851_652_578_136_5;
    out[689] = 0.000_517_638_090_205_042_1;
    out[690] = -0.002;
    out[691] = 2.449_293_598_294_706_3e-19;
    out[692] = -0.001_931_851_652_578_136_8;
    out[693] = -0.000_517_638_090_205_041_6;
    out[694] = -0.001_732_050_807_568_877_6;
    out[695] = -0.000_999_999_999_999_999_4;
    out[696] = -0.001_414_213_562_373_096;
    out[697] = -0.001_414_213_562_373_094_4;
    out[698] = -0.001_000_000_000_000_000_9;
    out[699] = -0.001_732_050_807_568_876_7;
    out[700] = -0.000_517_638_090_205_041_3;
    out[701] = -0.001_931_851_652_578_136_8;
    out[702] = -3.673_940_397_442_059_7e-19;
    out[703] = -0.002;
    out[704] = 0.000_517_638_090_205_040_7;
    out[705] = -0.001_931_851_652_578_137;
    out[706] = 0.001_000_000_000_000_000_2;
    out[707] = -0.001_732_050_807_568_877_2;
    out[708] = 0.001_414_213_562_373_094_8;
    out[709] = -0.001_414_213_562_373_095_5;
    out[710] = 0.001_732_050_807_568_876_7;
    out[711] = -0.001_000_000_000_000_000_9;
    out[712] = 0.001_931_851_652_578_136_1;
    out[713] = -0.000_517_638_090_205_043_1;
    [out[714], out[715], out[716], out[717]] = [-0.004, 0.0, 0.004, 0.0];
    out[718] = 0.007_200_000_000_000_001;
    [out[719], out[720], out[721], out[722], out[723]] = [0.0032, 0.008, 0.008, 0.0056, 0.0256];
    [out[724], out[725], out[726], out[727]] = [-0.0088, 0.0256, -0.008, 0.0064];
    [out[728], out[729], out[730], out[731], out[732]] = [-0.00672, 0.00192, -0.053, 0.006, -0.016];
    [out[733], out[734], out[735], out[736], out[737]] = [-0.003, -0.2465, 0.012, 0.0, 0.0];
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

/// Is positive where a condition on the parameters is met.
fn requirement_0(given: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let constants = given.constants.first_chunk::<17>()?;
    let R = constants[0];
    let yb = constants[15];
    let zt = constants[16];
    let out = out.first_chunk_mut::<1>()?;
    out[0] = zt - yb * R;
    Some(())
}

/// Is positive where a condition on the parameters is met.
fn requirement_1(given: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let constants = given.constants.first_chunk::<22>()?;
    let zt = constants[16];
    let zs = constants[21];
    let out = out.first_chunk_mut::<1>()?;
    out[0] = zs - zt;
    Some(())
}

/// Is positive where a condition on the parameters is met.
fn requirement_2(given: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let constants = given.constants.first_chunk::<34>()?;
    let yck = constants[32];
    let yco = constants[33];
    let out = out.first_chunk_mut::<1>()?;
    out[0] = yck - yco;
    Some(())
}

/// Input per metre of key-front travel.
fn input_per_metre(_: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let out = out.first_chunk_mut::<1>()?;
    out[0] = 1.0;
    Some(())
}

/// The state to start from.
fn rest(_: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let out = out.first_chunk_mut::<4>()?;
    [out[0], out[1], out[2], out[3]] = [0.0, 0.0, 0.0, 0.0];
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
    let ybed = constants[9];
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
    let zs = constants[21];
    let Ks = constants[22];
    let ps = constants[23];
    let kr = constants[25];
    let cr = constants[26];
    let o_r = constants[27];
    let yd = constants[28];
    let wd = constants[29];
    let zc = constants[30];
    let Rc = constants[31];
    let k1 = constants[35];
    let b1 = constants[36];
    let v0 = 1.0 / R;
    let v1 = 1.926_782_273_603_082_9 * (zs * v0);
    let v2 = functions::smaller(1.0, 3.846_153_846_153_846 * zs);
    let v3 = functions::larger(math::asin(functions::larger(-1.0, v2)), 0.0);
    let v4 = 3.853_564_547_206_165_7 * ybed - v1;
    let v5 = if zs.abs() > 0.0 { 2.0 * (v3 / zs) } else { 7.692_307_692_307_692 };
    let v6 = 1.0 / wd;
    let v7 = ybed - wd * functions::softplus((ybed - yd) * v6);
    let v8 = v3 - (o_r + R * v7) * v5;
    let ([sin_v1, sin_v4], [cos_v1, cos_v4]) = math::sin_cos_of_two([v1, v4]);
    let v9 = 0.532_917_688_041_813_9 * cos_v1 - 0.746_084_763_258_539_6;
    let v10 = functions::smaller(1.0, v9 - 2.460_303_326_459_708 * sin_v1);
    let v11 = math::asin(functions::larger(-1.0, v10));
    let v12 = 0.214_815_400_401_658_6 + v11;
    let v13 = 0.532_917_688_041_813_9 * cos_v4 - 0.746_084_763_258_539_6;
    let v14 = functions::smaller(1.0, 2.460_303_326_459_708 * sin_v4 + v13);
    let v15 = (v11 - math::asin(functions::larger(-1.0, v14))) / ybed;
    let v16 = if ybed.abs() > 0.0 { v15 } else { 0.0 };
    let v17 = 1.0 / wf;
    let v18 = wf * Kb;
    let v19 = wf * v18;
    let v20 = wf * Kr;
    let v21 = wf * v20;
    let v22 = 1.0 / vc;
    let v23 = 1.0 / wj;
    let v24 = wj * kj;
    let v25 = R * ch;
    let v26 = R * mh;
    let v27 = R * v26;
    let v28 = 1.0 / (mk + v27);
    let v29 = Fc * v22;
    let v30 = R * v25;
    let v31 = b1 + ck;
    let v32 = functions::smaller(0.05, 0.090_829_217_025_748_84 * v0);
    let v33 = functions::larger(0.008, v32);
    let ([sin_v3, sin_v12], [cos_v3, cos_v12]) = math::sin_cos_of_two([v3, v12]);
    let v34 = v33 * (1.0 - cos_v3) + (0.072 + 0.01 * sin_v3) + 0.048 * sin_v12;
    let v35 = v34 - 0.072 * cos_v12;
    let v36 = math::sqrt(functions::larger(4.225e-5 - v35 * v35, 0.0));
    let v37 = 0.072 * (sin_v12 + 0.666_666_666_666_666_7 * cos_v12);
    let v38 = cos_v3 + 100.0 * (v33 * sin_v3) + 100.0 * (v37 + v36);
    let v39 = 1.0 / mk;
    let v40 = v26 * v39;
    let v41 = v17.abs();
    let v42 = v23.abs();
    let v43 = v39.abs();
    let v44 = R.abs();
    let v45 = mh.abs();
    let v46 = v44 * v45;
    let v47 = v46 * v43;
    let v48 = kj * v23;
    let v49 = Kb.abs();
    let v50 = Kr.abs();
    let v51 = v22.abs();
    let v52 = v22 * v29;
    let v53 = v51 * v52.abs();
    let v54 = k1.abs();
    let v55 = b1.abs();
    let v56 = R * yb;
    let v57 = 2.0 * ((zt - v56) * v0 / (1.0 + rho));
    let v58 = functions::larger(v57, 1e-6);
    let v59 = 1.0 / v58;
    let v60 = (1.0 - rho) * v59;
    let v61 = R * v58;
    let v62 = v59 * (nu * v59);
    let v63 = v26 * v60;
    let v64 = v22 * v62;
    let v65 = ybed - yb;
    let ([sin_v12_yb_v16, sin_v12_ybed_v16], [_, _]) =
        math::sin_cos_of_two([v12 - yb * v16, v12 - ybed * v16]);
    let v66 = 0.072 * (sin_v12_ybed_v16 - sin_v12_yb_v16) / v65;
    let v67 = if v65 > 0.0 { 62.5 * v66 } else { 0.0 };
    let v68 = v58 * v61;
    let v69 = v40 * v60;
    let v70 = v59.abs();
    let v71 = (rho - 1.0).abs() * v70;
    let v72 = v44 * v71;
    let v73 = f64::INFINITY - v57.abs();
    let v74 = if v73 > 0.0 { 0.0 } else { f64::INFINITY };
    let v75 = 1.0 / mh;
    let v76 = ch * v75;
    let v77 = 0.214_815_400_401_658_6 + 240.384_615_384_615_36 * (o_r * v33);
    let (sin_v8, cos_v8) = math::sin_cos(v8);
    let v78 = 0.140_011_063_039_587_3 + 31.113_569_564_352_75 * (v33 * sin_v8);
    let v79 = v6.abs();
    let v80 = Ks * v75;
    let v81 = R * kr;
    let v82 = v81 * v39;
    let v83 = R * v82;
    let v84 = cr * v83;
    let v85 = cr * v75;
    let v86 = v81 * v6;
    let v87 = 0.140_011_063_039_587_38 - 0.311_135_695_643_527_5 * v38;
    let v88 = R * v6;
    let v89 = mh * Rc;
    let v90 = Rc * v89;
    let v91 = 1.0 / (mk + v90);
    let v92 = ch * Rc;
    let v93 = Rc * v92;
    let out = out.first_chunk_mut::<141>()?;
    [out[0], out[1], out[2], out[3], out[4], out[5], out[6]] = [v17, v19, v21, v22, v23, v24, v25];
    [out[7], out[8], out[9], out[10], out[11], out[12]] = [mh * g, v28, R * v28, v18, v20, -ar];
    [out[13], out[14], out[15], out[16], out[17]] = [v29, -(v31 + v30), v26 * v28, v16, -v12];
    [out[18], out[19]] = [v12, -v1];
    out[20] = 0.2465 * sin_v1 + (0.014 + 0.012 * cos_v1);
    [out[21], out[22]] = [R * v5, v3];
    out[23] = 0.121_500_000_000_000_01 - v33;
    out[24] = 0.042 + 0.01 * v38;
    out[25] = 0.012 * sin_v1 - 0.2465 * cos_v1;
    [out[26], out[27], out[28], out[29], out[30]] = [wj * v24, wf * v19, wf * v21, v27, g * v26];
    [out[31], out[32], out[33], out[34], out[35]] = [v30, v40, ab * v28, ar * v28, v29 * v28];
    [out[36], out[37], out[38], out[39], out[40]] = [ck * v28, v25 * v28, -v31, ab.abs(), ar.abs()];
    [out[41], out[42]] = [v41, v42];
    out[43] = v18.abs() * v41;
    out[44] = v20.abs() * v41;
    out[45] = kj.abs() * v42;
    [out[46], out[47], out[48], out[49], out[50]] = [v47, v48, v49, v49 * v41, v50];
    [out[51], out[52], out[53]] = [v50 * v41, v48.abs(), v51];
    out[54] = v19.abs() * v41;
    out[55] = v21.abs() * v41;
    out[56] = v51 * v29.abs();
    [out[57], out[58], out[59], out[60]] = [v40.abs(), v40 * v52, v47 * v53, v54 * v47];
    [out[61], out[62], out[63], out[64], out[65]] = [v55 * v47, v59, v59 * v60, v61, v56];
    [out[66], out[67], out[68], out[69], out[70]] = [v60, v62, R * v60, v26, v59 * v62];
    [out[71], out[72], out[73], out[74], out[75]] = [v25 * v60, v63, v64, v26 * v64, v67];
    [out[76], out[77], out[78], out[79], out[80]] = [v5, v26 * v68, v25 * v68, v69, v31];
    [out[81], out[82], out[83]] = [R * v52, v54, v55];
    out[84] = Fc.abs() * v51;
    out[85] = ck.abs();
    out[86] = v24.abs() * v42;
    out[87] = v71;
    out[88] = ch.abs() * v72;
    out[89] = v43 * v63.abs();
    [out[90], out[91], out[92], out[93]] = [v47 * v71, v69.abs(), v46 * v71, v44 * v53];
    [out[94], out[95]] = [v45 * v43, 2.0 * v63];
    out[96] = (k1 * v69).abs();
    out[97] = (b1 * v69).abs();
    [out[98], out[99], out[100], out[101], out[102]] = [v74, yb + v58, v39, v76, -v76];
    [out[103], out[104]] = [-(v77 + v11), v44];
    out[105] = v78 + 0.311_135_695_643_527_5 * (cos_v8 - v38);
    out[106] = v71 * (v61.abs() * v70);
    out[107] = v72;
    out[108] = functions::larger(0.17, v65 * v67) - v12;
    [out[109], out[110], out[111], out[112], out[113]] = [v6, v79, v44 * v79, v80, ps - 1.0];
    out[114] = ps * v80;
    out[115] = Ks / (1.0 + ps);
    [out[116], out[117], out[118], out[119], out[120]] = [v82, kr * v75, v6 * v82, v83, v6 * v84];
    [out[121], out[122], out[123], out[124]] = [v81 * v75, v85 * v86, v84, v81 * v85];
    [out[125], out[126], out[127], out[128], out[129]] = [cr * v82, kr * v85, v33, v87, v88];
    [out[130], out[131], out[132], out[133], out[134]] = [v88.abs(), v89, v91, Rc * v91, Rc.abs()];
    [out[135], out[136], out[137], out[138], out[139]] = [o_r - zc, v92, v86, -(v31 + v93), v90];
    out[140] = v93;
    Some(())
}
