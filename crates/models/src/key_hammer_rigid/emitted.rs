//! Emitted from `the description of key-hammer-rigid` by `letoff model emit`; not to be changed by hand.
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
    PartTable, PresetTable, RestTable, SeriesTable, WayTable,
};
use pode::{EquationKind, Fires, GuardId, GuardSpec, Part, Reads, math};

/// All of the model but its arithmetic.
pub static TABLE: ModelTable = ModelTable {
    name: "key-hammer-rigid",
    summary: "the paper's model A: key and hammer in rigid contact",
    parameters: &[
        ParameterTable {
            name: "L1",
            title: "key lever",
            unit: "m",
            range: (1e-9, 1_000_000_000.0),
            doc: "key pivot to the slider, along the key",
        },
        ParameterTable {
            name: "L2",
            title: "hammer radius",
            unit: "m",
            range: (1e-9, 1_000_000_000.0),
            doc: "hammer pivot to the hammer's mass centre",
        },
        ParameterTable {
            name: "L3",
            title: "hammer pivot, x",
            unit: "m",
            range: (-100.0, 100.0),
            doc: "hammer pivot, to the right of the key pivot",
        },
        ParameterTable {
            name: "L4",
            title: "hammer pivot, y",
            unit: "m",
            range: (-100.0, 100.0),
            doc: "hammer pivot, above the key pivot",
        },
        ParameterTable {
            name: "M1",
            title: "key mass",
            unit: "kg",
            range: (0.0, 1_000_000_000.0),
            doc: "mass of the key",
        },
        ParameterTable {
            name: "M2",
            title: "hammer mass",
            unit: "kg",
            range: (1e-9, 1_000_000_000.0),
            doc: "mass of the hammer",
        },
        ParameterTable {
            name: "k1",
            title: "coupling",
            unit: "N·m/rad",
            range: (1e-9, 1_000_000_000.0),
            doc: "torsion spring between manipulandum and key (model B; A is rigid)",
        },
        ParameterTable {
            name: "k2",
            title: "contact stiffness",
            unit: "N/m",
            range: (1e-9, 1_000_000_000.0),
            doc: "spring between key and slider (model B; A is rigid)",
        },
        ParameterTable {
            name: "cK",
            title: "key balance",
            unit: "m",
            range: (-100.0, 100.0),
            doc: "key pivot to the key's mass centre; negative on the player's side",
        },
        ParameterTable {
            name: "JK",
            title: "key inertia",
            unit: "kg·m²",
            range: (1e-9, 1_000_000_000.0),
            doc: "inertia of the key about its pivot",
        },
        ParameterTable {
            name: "JH",
            title: "hammer inertia",
            unit: "kg·m²",
            range: (1e-9, 1_000_000_000.0),
            doc: "inertia of the hammer about its pivot",
        },
        ParameterTable {
            name: "g",
            title: "gravity",
            unit: "m/s²",
            range: (0.0, 1000.0),
            doc: "gravity",
        },
        ParameterTable {
            name: "string_angle",
            title: "string",
            unit: "rad",
            range: (-1.5, 1.5),
            doc: "angle of the hammer at the string",
        },
        ParameterTable {
            name: "restitution",
            title: "restitution",
            unit: "1",
            range: (0.0, 1.0),
            doc: "speed after the string over speed before; the paper has 1",
        },
        ParameterTable {
            name: "b1",
            title: "coupling damper",
            unit: "N·m·s/rad",
            range: (0.0, 1_000_000_000.0),
            doc: "damper beside k1 (model B; the paper has none)",
        },
        ParameterTable {
            name: "c2",
            title: "felt loss",
            unit: "s/m",
            range: (0.0, 1_000_000_000.0),
            doc: "loss of the felt in k2, F = k2 q4 (1 + c2 q4') (model B; the paper has none)",
        },
        ParameterTable {
            name: "r",
            title: "finger lever",
            unit: "m",
            range: (1e-9, 1_000_000_000.0),
            doc: "lever arm of the finger: finger force = torque / r",
        },
    ],
    presets: &[
        PresetTable {
            name: "paper",
            doc: "Table 2 of the paper, lengths read as decimetres",
            values: 27,
        },
        PresetTable { name: "literal", doc: "Table 2 of the paper as printed, in SI", values: 28 },
        PresetTable {
            name: "playable",
            doc: "a real key's size, graded over the compass; the key bottom leaves the hammer 2–3 \
                mm short",
            values: 29,
        },
    ],
    requirements: &[],
    states: &[
        NamedQuantity { name: "theta_h", unit: "rad" },
        NamedQuantity { name: "theta_h_dot", unit: "rad/s" },
    ],
    coordinates: 1,
    constants: 34,
    derive_constants: 32,
    input: NamedQuantity { name: "s", unit: "rad" },
    input_per_metre: 30,
    modes: &[
        ModeTable {
            name: "A1",
            derivative: 0,
            parts: &[],
            part_list: &[],
            slaved: Some(1),
            projection: None,
            projected: 0,
            longest_projection: Some(10),
            readout: 3,
            slopes: 4,
            outputs: 5,
            balance: 6,
            jacobian: 2,
            series: None,
            kind: EquationKind::Affine,
            loss: None,
            is_stiffening: false,
            guards: &[GuardTable {
                id: 0,
                name: "release",
                unit: "N",
                priority: 0,
                scale: 1.0,
                fires: Fires::WhileNegative,
                reads: Reads::StateAndInput,
                value: 8,
                bound: Some(9),
                ways: &[WayTable { when: None, to: 1, reset: Some(7), resting: None }],
                sounds: None,
            }],
            guard_specs: &[GuardSpec {
                id: GuardId(0),
                name: "release",
                priority: 0,
                scale: 1.0,
                fires: Fires::WhileNegative,
                reads: Reads::StateAndInput,
            }],
            contacts: &[],
            freedom: Freedom { n: 2, m: 2, p: 0 },
        },
        ModeTable {
            name: "A2",
            derivative: 11,
            parts: &[PartTable {
                entries: 0x3,
                derivative: 11,
                kind: EquationKind::Conservative,
                loss: None,
                reads: Reads::State,
            }],
            part_list: &[Part::WHOLE.of_state()],
            slaved: None,
            projection: None,
            projected: 0,
            longest_projection: None,
            readout: 13,
            slopes: 14,
            outputs: 15,
            balance: 16,
            jacobian: 12,
            series: Some(SeriesTable {
                start: 24,
                step: 25,
                entries: 0x3,
                guards: 2,
                conditions: 0,
                lanes: 4,
                carried: 4,
            }),
            kind: EquationKind::Conservative,
            loss: None,
            is_stiffening: false,
            guards: &[
                GuardTable {
                    id: 1,
                    name: "land",
                    unit: "m",
                    priority: 0,
                    scale: 1.0,
                    fires: Fires::WhileNegative,
                    reads: Reads::StateAndInput,
                    value: 18,
                    bound: Some(19),
                    ways: &[WayTable { when: None, to: 0, reset: Some(17), resting: None }],
                    sounds: None,
                },
                GuardTable {
                    id: 2,
                    name: "string",
                    unit: "1",
                    priority: 1,
                    scale: 1.0,
                    fires: Fires::OnCrossing,
                    reads: Reads::State,
                    value: 22,
                    bound: Some(23),
                    ways: &[WayTable { when: None, to: 1, reset: Some(20), resting: None }],
                    sounds: Some(21),
                },
            ],
            guard_specs: &[
                GuardSpec {
                    id: GuardId(1),
                    name: "land",
                    priority: 0,
                    scale: 1.0,
                    fires: Fires::WhileNegative,
                    reads: Reads::StateAndInput,
                },
                GuardSpec {
                    id: GuardId(2),
                    name: "string",
                    priority: 1,
                    scale: 1.0,
                    fires: Fires::OnCrossing,
                    reads: Reads::State,
                },
            ],
            contacts: &[],
            freedom: Freedom { n: 2, m: 1, p: 1 },
        },
    ],
    contacts: &[],
    contact_specs: &[],
    guard_specs: &[
        GuardSpec {
            id: GuardId(0),
            name: "release",
            priority: 0,
            scale: 1.0,
            fires: Fires::WhileNegative,
            reads: Reads::StateAndInput,
        },
        GuardSpec {
            id: GuardId(1),
            name: "land",
            priority: 0,
            scale: 1.0,
            fires: Fires::WhileNegative,
            reads: Reads::StateAndInput,
        },
        GuardSpec {
            id: GuardId(2),
            name: "string",
            priority: 1,
            scale: 1.0,
            fires: Fires::OnCrossing,
            reads: Reads::State,
        },
    ],
    outputs: &[
        NamedQuantity { name: "F_KH", unit: "N" },
        NamedQuantity { name: "T_KU", unit: "N·m" },
        NamedQuantity { name: "gap", unit: "m" },
        NamedQuantity { name: "key.x", unit: "m" },
        NamedQuantity { name: "key.y", unit: "m" },
        NamedQuantity { name: "key.angle", unit: "rad" },
        NamedQuantity { name: "hammer.x", unit: "m" },
        NamedQuantity { name: "hammer.y", unit: "m" },
        NamedQuantity { name: "hammer.angle", unit: "rad" },
        NamedQuantity { name: "finger.x", unit: "m" },
        NamedQuantity { name: "finger.y", unit: "m" },
        NamedQuantity { name: "finger.angle", unit: "rad" },
    ],
    rest: RestTable { mode: 0, instead: &[], state: 31, is_improved: true },
    damper: Some(DamperTable { lift: 0.005, fall: 0.0046, softest_tone: 0.15 }),
    midi: MidiTable { speeds: None, velocity: None, pressure: None },
    drawing: DrawingTable {
        numbers: 26,
        count: 416,
        bodies: &[
            BodyTable {
                name: "balance rail",
                output: None,
                outlines: &[
                    OutlineTable {
                        material: Material::Ground,
                        is_closed: true,
                        points: (4, 3),
                        modes: &[],
                    },
                    OutlineTable {
                        material: Material::Ground,
                        is_closed: false,
                        points: (10, 28),
                        modes: &[],
                    },
                    OutlineTable {
                        material: Material::Metal,
                        is_closed: false,
                        points: (66, 2),
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
                        points: (70, 4),
                        modes: &[],
                    },
                    OutlineTable {
                        material: Material::Wood,
                        is_closed: true,
                        points: (78, 4),
                        modes: &[],
                    },
                ],
            },
            BodyTable {
                name: "key",
                output: Some(3),
                outlines: &[
                    OutlineTable {
                        material: Material::Wood,
                        is_closed: true,
                        points: (86, 4),
                        modes: &[],
                    },
                    OutlineTable {
                        material: Material::Wood,
                        is_closed: true,
                        points: (94, 4),
                        modes: &[],
                    },
                    OutlineTable {
                        material: Material::Metal,
                        is_closed: true,
                        points: (102, 24),
                        modes: &[],
                    },
                    OutlineTable {
                        material: Material::Metal,
                        is_closed: true,
                        points: (150, 24),
                        modes: &[],
                    },
                    OutlineTable {
                        material: Material::Metal,
                        is_closed: true,
                        points: (198, 4),
                        modes: &[],
                    },
                    OutlineTable {
                        material: Material::Metal,
                        is_closed: true,
                        points: (206, 24),
                        modes: &[],
                    },
                ],
            },
            BodyTable {
                name: "hammer",
                output: Some(6),
                outlines: &[
                    OutlineTable {
                        material: Material::Wood,
                        is_closed: true,
                        points: (254, 4),
                        modes: &[],
                    },
                    OutlineTable {
                        material: Material::Wood,
                        is_closed: true,
                        points: (262, 4),
                        modes: &[],
                    },
                    OutlineTable {
                        material: Material::Felt,
                        is_closed: true,
                        points: (270, 15),
                        modes: &[],
                    },
                    OutlineTable {
                        material: Material::Metal,
                        is_closed: true,
                        points: (300, 24),
                        modes: &[],
                    },
                    OutlineTable {
                        material: Material::Metal,
                        is_closed: true,
                        points: (348, 24),
                        modes: &[],
                    },
                ],
            },
            BodyTable {
                name: "string",
                output: None,
                outlines: &[OutlineTable {
                    material: Material::String,
                    is_closed: false,
                    points: (396, 2),
                    modes: &[],
                }],
            },
            BodyTable {
                name: "finger",
                output: Some(9),
                outlines: &[OutlineTable {
                    material: Material::Finger,
                    is_closed: true,
                    points: (400, 8),
                    modes: &[],
                }],
            },
        ],
        springs: &[],
    },
};

/// The model's arithmetic.
#[derive(Clone, Copy, Debug, Default)]
pub struct KeyHammerRigidFunctions;

impl Functions for KeyHammerRigidFunctions {
    fn call(&self, function: FunctionId, given: &Arguments<'_>, out: &mut [f64]) {
        let done = match function {
            0 => derivative_a1(given, out),
            1 => slaved_a1(given, out),
            2 => jacobian_a1(given, out),
            3 => readout_a1(given, out),
            4 => slopes_a1(given, out),
            5 => outputs_a1(given, out),
            6 => balance_a1(given, out),
            7 => reset_0_release_a1(given, out),
            8 => guard_release_a1(given, out),
            9 => bound_release_a1(given, out),
            10 => function_10(given, out),
            11 => derivative_a2(given, out),
            12 => jacobian_a2(given, out),
            13 => readout_a2(given, out),
            14 => slopes_a2(given, out),
            15 => outputs_a2(given, out),
            16 => balance_a2(given, out),
            17 => reset_0_land_a2(given, out),
            18 => guard_land_a2(given, out),
            19 => bound_land_a2(given, out),
            20 => reset_0_string_a2(given, out),
            21 => speed_string_a2(given, out),
            22 => guard_string_a2(given, out),
            23 => bound_string_a2(given, out),
            24 => series_start_a2(given, out),
            25 => series_step_a2(given, out),
            26 => drawing(given, out),
            27 => preset_paper(given, out),
            28 => preset_literal(given, out),
            29 => preset_playable(given, out),
            30 => input_per_metre(given, out),
            31 => rest(given, out),
            32 => derived_constants(given, out),
            _ => return,
        };
        if done.is_none() {
            out.fill(f64::NAN);
        }
    }

    #[inline(always)]
    fn derivative(&self, function: FunctionId, given: &Arguments<'_>, out: &mut [f64]) {
        let done = match function {
            0 => derivative_a1(given, out),
            11 => derivative_a2(given, out),
            _ => None,
        };
        if done.is_none() {
            out.fill(f64::NAN);
        }
    }

    #[inline(always)]
    fn readout(&self, function: FunctionId, given: &Arguments<'_>, out: &mut [f64]) {
        let done = match function {
            3 => readout_a1(given, out),
            13 => readout_a2(given, out),
            _ => None,
        };
        if done.is_none() {
            out.fill(f64::NAN);
        }
    }

    #[inline(always)]
    fn guard(&self, function: FunctionId, given: &Arguments<'_>, out: &mut [f64]) {
        let done = match function {
            8 => guard_release_a1(given, out),
            18 => guard_land_a2(given, out),
            22 => guard_string_a2(given, out),
            _ => None,
        };
        if done.is_none() {
            out.fill(f64::NAN);
        }
    }
}

/// The derivative of the state in mode A1.
#[inline(always)]
fn derivative_a1(given: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let constants = given.constants.first_chunk::<4>()?;
    let input = given.input;
    let L1 = constants[0];
    let L3 = constants[2];
    let L4 = constants[3];
    let s = input[0];
    let s_rate = input[1];
    let s_rate2 = input[2];
    let (sin_s, cos_s) = math::sin_cos(s);
    let v0 = L1 * cos_s - L3;
    let v1 = L1 * sin_s - L4;
    let v2 = 1.0 / (v1 * v1 + v0 * v0);
    let v3 = L1 * (s_rate * (cos_s * v0 + sin_s * v1)) * v2;
    let v4 = s_rate * s_rate;
    let v5 = cos_s * (s_rate2 * v0 + v4 * v1) + sin_s * (s_rate2 * v1 - v4 * v0);
    let v6 = L1 * (s_rate * (2.0 * (cos_s * v1 - sin_s * v0)));
    let out = out.first_chunk_mut::<2>()?;
    out[0] = v3;
    out[1] = v2 * (L1 * v5 - v6 * v3);
    Some(())
}

/// The state with slaved entries in place in mode A1.
fn slaved_a1(given: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let constants = given.constants.first_chunk::<4>()?;
    let input = given.input;
    let L1 = constants[0];
    let L3 = constants[2];
    let L4 = constants[3];
    let s = input[0];
    let s_rate = input[1];
    let (sin_s, cos_s) = math::sin_cos(s);
    let v0 = L1 * sin_s - L4;
    let v1 = L1 * cos_s - L3;
    let v2 = L1 * (s_rate * (cos_s * v1 + sin_s * v0)) / (v0 * v0 + v1 * v1);
    let out = out.first_chunk_mut::<2>()?;
    out[0] = math::atan2(v0, v1);
    out[1] = v2;
    Some(())
}

/// The derivative's derivative by the state in mode A1.
fn jacobian_a1(_: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let out = out.first_chunk_mut::<4>()?;
    [out[0], out[1], out[2], out[3]] = [0.0, 0.0, 0.0, 0.0];
    Some(())
}

/// The readout in mode A1.
#[inline(always)]
fn readout_a1(given: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let constants = given.constants.first_chunk::<19>()?;
    let input = given.input;
    let L1 = constants[0];
    let L3 = constants[2];
    let L4 = constants[3];
    let JK = constants[9];
    let JH = constants[10];
    let c17 = constants[17];
    let c18 = constants[18];
    let s = input[0];
    let s_rate = input[1];
    let s_rate2 = input[2];
    let (sin_s, cos_s) = math::sin_cos(s);
    let v0 = L1 * sin_s - L4;
    let v1 = L1 * cos_s - L3;
    let v2 = math::atan2(v0, v1);
    let ([sin_v2, _], [cos_v2, cos_s_v2]) = math::sin_cos_of_two([v2, s - v2]);
    let v3 = L1 * cos_s_v2;
    let v4 = s_rate * s_rate;
    let v5 = cos_s * (s_rate2 * v1 + v4 * v0) + sin_s * (s_rate2 * v0 - v4 * v1);
    let v6 = 1.0 / (v0 * v0 + v1 * v1);
    let v7 = L1 * (s_rate * (2.0 * (cos_s * v0 - sin_s * v1)));
    let v8 = v6 * (L1 * (s_rate * (cos_s * v1 + sin_s * v0)) * v7);
    let v9 = v3 * (JH * (v6 * (L1 * v5 - v8)) + c18 * cos_v2) / (v3 - (L4 * sin_v2 + L3 * cos_v2));
    let out = out.first_chunk_mut::<1>()?;
    out[0] = s_rate2 * JK + c17 * cos_s + v9;
    Some(())
}

/// The readout's slopes in mode A1.
fn slopes_a1(given: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let constants = given.constants.first_chunk::<21>()?;
    let input = given.input;
    let L1 = constants[0];
    let L3 = constants[2];
    let L4 = constants[3];
    let JH = constants[10];
    let c17 = constants[17];
    let c18 = constants[18];
    let c19 = constants[19];
    let c20 = constants[20];
    let s = input[0];
    let s_rate = input[1];
    let s_rate2 = input[2];
    let (sin_s, cos_s) = math::sin_cos(s);
    let v0 = L1 * sin_s;
    let v1 = v0 - L4;
    let v2 = L1 * cos_s;
    let v3 = v2 - L3;
    let v4 = math::atan2(v1, v3);
    let v5 = s - v4;
    let ([sin_v5, sin_v4], [cos_v5, cos_v4]) = math::sin_cos_of_two([v5, v4]);
    let v6 = s_rate * v3;
    let v7 = s_rate2 * v1 - s_rate * v6;
    let v8 = s_rate * v1;
    let v9 = s_rate2 * v3 + s_rate * v8;
    let v10 = s_rate * c19;
    let v11 = v2 * v6 + v0 * v8;
    let v12 = L1 * (2.0 * (cos_s * v1 - sin_s * v3));
    let v13 = v2 * v8 - v0 * v6;
    let v14 = 2.0 * v13;
    let v15 = 1.0 / (v1 * v1 + v3 * v3);
    let v16 = v14 * v15;
    let v17 = L1 * (cos_s * v9 + sin_s * v7);
    let v18 = v11 * (2.0 * (v12 * v16) - 2.0 * (v10 - v11)) - (v13 * v14 + v12 * v17);
    let v19 = s_rate * v10 + L1 * (cos_s * v7 + sin_s * -v9) + v15 * v18;
    let v20 = L1 * (cos_s * v3 + sin_s * v1);
    let v21 = v20 * v15;
    let v22 = (1.0 - v21) * sin_v5;
    let v23 = v15 * (v20 * (L3 * sin_v4 - L4 * cos_v4)) - L1 * v22;
    let v24 = JH * (v15 * (v17 - v11 * v16)) + c18 * cos_v4;
    let v25 = 1.0 / (L1 * cos_v5 - (L4 * sin_v4 + L3 * cos_v4));
    let v26 = JH * (v15 * v19) - c18 * v21 * sin_v4 - v23 * (v24 * v25);
    let v27 = L1 * (v25 * (cos_v5 * v26 - v22 * v24)) - c17 * sin_s;
    let v28 = c20 * (v15 * (v14 + v15 * -(v11 * v12 + v20 * v14)));
    let out = out.first_chunk_mut::<2>()?;
    out[0] = v27;
    out[1] = v28 * cos_v5 * v25;
    Some(())
}

/// The outputs in mode A1.
fn outputs_a1(given: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let constants = given.constants.first_chunk::<23>()?;
    let input = given.input;
    let L1 = constants[0];
    let L3 = constants[2];
    let L4 = constants[3];
    let JK = constants[9];
    let JH = constants[10];
    let r = constants[16];
    let c17 = constants[17];
    let c18 = constants[18];
    let c21 = constants[21];
    let c22 = constants[22];
    let s = input[0];
    let s_rate = input[1];
    let s_rate2 = input[2];
    let (sin_s, cos_s) = math::sin_cos(s);
    let v0 = L1 * sin_s - L4;
    let v1 = L1 * cos_s - L3;
    let v2 = math::atan2(v0, v1);
    let v3 = s - v2;
    let v4 = s_rate * s_rate;
    let v5 = cos_s * (s_rate2 * v1 + v4 * v0) + sin_s * (s_rate2 * v0 - v4 * v1);
    let v6 = 1.0 / (v0 * v0 + v1 * v1);
    let v7 = L1 * (s_rate * (2.0 * (cos_s * v0 - sin_s * v1)));
    let v8 = v6 * (L1 * (s_rate * (cos_s * v1 + sin_s * v0)) * v7);
    let ([sin_v2, sin_v3], [cos_v2, cos_v3]) = math::sin_cos_of_two([v2, v3]);
    let v9 = L1 * cos_v3;
    let v10 = JH * (v6 * (L1 * v5 - v8)) + c18 * cos_v2;
    let v11 = v10 * (1.0 / (v9 - (L4 * sin_v2 + L3 * cos_v2)));
    let out = out.first_chunk_mut::<12>()?;
    out[0] = v11;
    out[1] = s_rate2 * JK + c17 * cos_s + v9 * v11;
    out[2] = L4 * cos_v2 - L3 * sin_v2 - L1 * sin_v3;
    [out[3], out[4], out[5], out[6], out[7], out[8], out[9]] = [0.0, 0.0, s, L3, L4, v2, c22];
    [out[10], out[11]] = [c21 - s * r, 0.0];
    Some(())
}

/// Energy, supplied and dissipated power in mode A1.
fn balance_a1(given: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let constants = given.constants.first_chunk::<25>()?;
    let input = given.input;
    let L1 = constants[0];
    let L3 = constants[2];
    let L4 = constants[3];
    let M2 = constants[5];
    let JK = constants[9];
    let JH = constants[10];
    let c17 = constants[17];
    let c18 = constants[18];
    let c23 = constants[23];
    let c24 = constants[24];
    let s = input[0];
    let s_rate = input[1];
    let s_rate2 = input[2];
    let (sin_s, cos_s) = math::sin_cos(s);
    let v0 = L1 * sin_s - L4;
    let v1 = L1 * cos_s - L3;
    let v2 = math::atan2(v0, v1);
    let v3 = 1.0 / (v0 * v0 + v1 * v1);
    let v4 = L1 * (s_rate * (cos_s * v1 + sin_s * v0)) * v3;
    let v5 = s_rate * s_rate;
    let ([sin_v2, _], [cos_v2, cos_s_v2]) = math::sin_cos_of_two([v2, s - v2]);
    let v6 = c17 * sin_s + 0.5 * (JK * v5 + JH * (v4 * v4)) - M2 * -(c24 + c23 * sin_v2);
    let v7 = L1 * cos_s_v2;
    let v8 = cos_s * (s_rate2 * v1 + v5 * v0) + sin_s * (s_rate2 * v0 - v5 * v1);
    let v9 = L1 * (s_rate * (2.0 * (cos_s * v0 - sin_s * v1)));
    let v10 = v7 * (JH * (v3 * (L1 * v8 - v9 * v4)) + c18 * cos_v2);
    let v11 = JK * s_rate2 + c17 * cos_s + v10 / (v7 - (L4 * sin_v2 + L3 * cos_v2));
    let out = out.first_chunk_mut::<3>()?;
    [out[0], out[1], out[2]] = [v6, s_rate * v11, 0.0];
    Some(())
}

/// The state after guard release in mode A1.
fn reset_0_release_a1(given: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let constants = given.constants.first_chunk::<4>()?;
    let input = given.input;
    let L1 = constants[0];
    let L3 = constants[2];
    let L4 = constants[3];
    let s = input[0];
    let s_rate = input[1];
    let (sin_s, cos_s) = math::sin_cos(s);
    let v0 = L1 * sin_s - L4;
    let v1 = L1 * cos_s - L3;
    let v2 = L1 * (s_rate * (cos_s * v1 + sin_s * v0)) / (v0 * v0 + v1 * v1);
    let out = out.first_chunk_mut::<3>()?;
    out[0] = math::atan2(v0, v1);
    [out[1], out[2]] = [v2, 0.0];
    Some(())
}

/// The guard and its rate: release in mode A1.
#[inline(always)]
fn guard_release_a1(given: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let constants = given.constants.first_chunk::<20>()?;
    let input = given.input;
    let L1 = constants[0];
    let L3 = constants[2];
    let L4 = constants[3];
    let JH = constants[10];
    let c18 = constants[18];
    let c19 = constants[19];
    let s = input[0];
    let s_rate = input[1];
    let s_rate2 = input[2];
    let s_rate3 = input[3];
    let (sin_s, cos_s) = math::sin_cos(s);
    let v0 = L1 * sin_s - L4;
    let v1 = L1 * cos_s - L3;
    let v2 = math::atan2(v0, v1);
    let v3 = s - v2;
    let v4 = s_rate2 * v1;
    let v5 = s_rate * (s_rate * v0);
    let v6 = v4 + v5;
    let v7 = s_rate * (s_rate * v1);
    let v8 = s_rate2 * v0;
    let v9 = v8 - v7;
    let v10 = L1 * (cos_s * v6 + sin_s * v9);
    let v11 = L1 * (s_rate * (2.0 * (cos_s * v0 - sin_s * v1)));
    let v12 = cos_s * v1 + sin_s * v0;
    let v13 = L1 * (s_rate * v12);
    let v14 = 1.0 / (v0 * v0 + v1 * v1);
    let v15 = v13 * v14;
    let ([sin_v2, sin_v3], [cos_v2, cos_v3]) = math::sin_cos_of_two([v2, v3]);
    let v16 = 1.0 / (L1 * cos_v3 - (L4 * sin_v2 + L3 * cos_v2));
    let v17 = (JH * (v14 * (v10 - v11 * v15)) + c18 * cos_v2) * v16;
    let v18 = cos_s * (3.0 * v8 - v7) + sin_s * -(v5 + 3.0 * v4);
    let v19 = s_rate * (s_rate * c19);
    let v20 = s_rate * v19 + L1 * (s_rate3 * v12 + s_rate * v18);
    let v21 = 2.0 * v19 + L1 * (cos_s * (2.0 * v9) + sin_s * -(2.0 * v6));
    let v22 = v13 * (2.0 * (v11 * (v11 * v14)) - v21) - 2.0 * (v11 * v10);
    let v23 = JH * (v14 * (v20 + v14 * v22)) - c18 * v15 * sin_v2;
    let v24 = v13 * (v14 * (L3 * sin_v2 - L4 * cos_v2)) - (s_rate - v15) * (L1 * sin_v3);
    let out = out.first_chunk_mut::<2>()?;
    out[0] = v17;
    out[1] = v16 * (v23 - v24 * v17);
    Some(())
}

/// Bounds of the guard's move and bend: release in mode A1.
fn bound_release_a1(given: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let constants = given.constants.first_chunk::<33>()?;
    let extra = given.extra.first_chunk::<8>()?;
    let input = given.input;
    let L1 = constants[0];
    let L3 = constants[2];
    let L4 = constants[3];
    let JH = constants[10];
    let c18 = constants[18];
    let c25 = constants[25];
    let c26 = constants[26];
    let c27 = constants[27];
    let c28 = constants[28];
    let c29 = constants[29];
    let c30 = constants[30];
    let c31 = constants[31];
    let c32 = constants[32];
    let s_rate = input[1];
    let s_rate2 = input[2];
    let s_rate3 = input[3];
    let (sin_extra_7, cos_extra_7) = math::sin_cos(extra[7]);
    let v0 = L1 * sin_extra_7;
    let v1 = L4 - v0;
    let v2 = -v1;
    let v3 = L1 * cos_extra_7;
    let v4 = L3 - v3;
    let v5 = -v4;
    let v6 = math::atan2(v2, v5);
    let v7 = extra[7] - v6;
    let v8 = s_rate * extra[3];
    let v9 = sin_extra_7.abs();
    let v10 = 0.5 * v8;
    let v11 = functions::smaller(v10 + v9, 1.0);
    let v12 = c25 * v8;
    let v13 = v12 * v11;
    let v14 = v1.abs();
    let v15 = functions::smaller(v10 + cos_extra_7.abs(), 1.0);
    let v16 = v12 * v15;
    let v17 = functions::larger(-(v4 + v13), v14 - v16);
    let v18 = if v17 > 0.0 { 0.0 } else { f64::INFINITY };
    let v19 = v3 * v2;
    let v20 = v19.abs();
    let v21 = s_rate * v20;
    let v22 = v0 * v5;
    let v23 = v22.abs();
    let v24 = s_rate * v23;
    let v25 = v14 + v16;
    let v26 = v3.abs();
    let v27 = v26 * v16 + v13 * v25;
    let v28 = s_rate * v27;
    let v29 = v8 * v15;
    let v30 = c26 * v8 * v11 * functions::smaller(v9 + v29, 1.0);
    let v31 = (L1 * v5).abs() * v29 + v30;
    let v32 = s_rate * v31;
    let v33 = v21 + v24 + (v28 + v32);
    let v34 = 2.0 * v33;
    let v35 = v2 * v2 + v5 * v5;
    let v36 = v35.abs();
    let v37 = v4.abs();
    let v38 = v16 * (2.0 * v14 + v16) + v13 * (2.0 * v37 + v13);
    let v39 = 1.0 / functions::larger(v36 - v38, 0.0);
    let v40 = 1.0 / v36 * v38;
    let v41 = v40 * v39;
    let v42 = v3 * v5;
    let v43 = v0 * v2;
    let v44 = v42 + v43;
    let v45 = v44.abs();
    let v46 = v26 * v13 + v13 * (v37 + v13);
    let v47 = v0.abs() * v16 + v16 * v25;
    let v48 = v46 + v47;
    let v49 = v45 + v48;
    let v50 = 1.0 / v35;
    let v51 = v50.abs();
    let v52 = v51 + v39;
    let v53 = v41 * v52;
    let v54 = v50 * v50;
    let v55 = v54.abs();
    let v56 = v55 * v48 + v49 * v53;
    let v57 = v44 * v50;
    let v58 = v50 * v57;
    let v59 = v58.abs();
    let v60 = v41 + (v51 + v59 + v56);
    let v61 = v22 - v19;
    let v62 = 2.0 * v61;
    let v63 = v27 + v31;
    let v64 = 2.0 * v63;
    let v65 = v62.abs() + v64;
    let v66 = v42.abs();
    let v67 = v43.abs();
    let v68 = s_rate * v66 + s_rate * v67 + (s_rate * v46 + s_rate * v47);
    let v69 = v39 * (v68 * v39);
    let v70 = v65 * v69 + v34 * v60;
    let v71 = v49 * v39;
    let ([sin_v7, sin_v6], [cos_v7, cos_v6]) = math::sin_cos_of_two([v7, v6]);
    let v72 = L1 * cos_v7;
    let v73 = L4 * sin_v6;
    let v74 = L3 * cos_v6;
    let v75 = v72 - (v73 + v74);
    let v76 = (-v75).abs();
    let v77 = math::hypot(v16, v13);
    let v78 = functions::larger(math::hypot(v2, v5) - v77, 0.0);
    let v79 = if v17 > 0.0 { v77 / v78 } else { f64::INFINITY };
    let v80 = v8 + v79;
    let v81 = 0.5 * v80;
    let v82 = c25 * v80;
    let v83 = v82 * functions::smaller(sin_v7.abs() + v81, 1.0);
    let v84 = 0.5 * v79;
    let v85 = functions::smaller(cos_v6.abs() + v84, 1.0);
    let v86 = v79 * v85;
    let v87 = functions::smaller(sin_v6.abs() + v84, 1.0);
    let v88 = v79 * v87;
    let v89 = v83 + (c29 * v86 + c30 * v88);
    let v90 = 1.0 / functions::larger(v76 - v89, 0.0);
    let v91 = 1.0 - v57;
    let v92 = L1 * sin_v7;
    let v93 = L4 * cos_v6;
    let v94 = L3 * sin_v6;
    let v95 = v91 * v92 + (v57 * v93 - v57 * v94);
    let v96 = v95.abs();
    let v97 = (v57 - 1.0).abs();
    let v98 = v51 * v48 + v49 * v41;
    let v99 = v97 + v98;
    let v100 = v82 * functions::smaller(cos_v7.abs() + v81, 1.0);
    let v101 = v92.abs();
    let v102 = v93.abs();
    let v103 = v39 * (v40 * v102 + c29 * v88);
    let v104 = v50 * v93;
    let v105 = v104.abs();
    let v106 = v94.abs();
    let v107 = v39 * (v40 * v106 + c30 * v86);
    let v108 = v50 * v94;
    let v109 = v108.abs();
    let v110 = v48 * v105 + v49 * v103 + (v48 * v109 + v49 * v107);
    let v111 = v101 * v98 + v99 * v100 + v110;
    let v112 = v96 + v111;
    let v113 = c18 * cos_v6;
    let v114 = v113.abs();
    let v115 = v34 * v69;
    let v116 = s_rate2 * v66 + s_rate * v24 + (s_rate2 * v67 + s_rate * v21);
    let v117 = s_rate2 * v47 + s_rate * v28 + (s_rate2 * v46 + s_rate * v32);
    let v118 = v116 + v117;
    let v119 = c27 * (v115 + v118 * (v51 + v41)) + c28 * v88;
    let v120 = v114 + v119;
    let v121 = 1.0 / v75;
    let v122 = v121.abs();
    let v123 = v122 + v90;
    let v124 = 1.0 / v76 * v89;
    let v125 = v124 * v90;
    let v126 = v123 * v125;
    let v127 = v121 * v121;
    let v128 = v127.abs();
    let v129 = v128 * v119 + v120 * v126;
    let v130 = v121 * (v113 * v121);
    let v131 = v130.abs();
    let v132 = c18 * sin_v6;
    let v133 = v50 * v132;
    let v134 = v133.abs();
    let v135 = s_rate * c31 + v68;
    let v136 = 2.0 * v135;
    let v137 = v65 * v39;
    let v138 = s_rate * s_rate * (v47 + (v67 + (c31 + v66) + v46));
    let v139 = v138 + s_rate2 * (v20 + v23 + v27 + v31);
    let v140 = v40 * v139 + v68 * (v39 * (v136 + 2.0 * (v34 * v137)));
    let v141 = v55 + v53;
    let v142 = v118 * v141;
    let v143 = v34 * v141;
    let v144 = v33 * v143 + (v51 * v139 + v65 * v142) + v39 * v140;
    let v145 = v132.abs();
    let v146 = v39 * (v40 * v145 + c28 * v86);
    let v147 = v48 * v134 + (c27 * v144 + v49 * v146);
    let v148 = (v57 * v132).abs() + v147;
    let v149 = -v95;
    let v150 = v149 * v121;
    let v151 = v57 * sin_v6;
    let v152 = (c18 * (v121 * (v151 + cos_v6 * v150))).abs() + v122 * v147;
    let v153 = v131 * v111 + v152 + v148 * v125 + v112 * v129;
    let v154 = c27 * ((s_rate3 * v71 + s_rate2 * v70) * v90) + s_rate * v153;
    let v155 = (v127 * v121).abs() * v119 + v120 * v125 * (v90 * (v122 + 2.0 * v90));
    let v156 = (2.0 * v96 + v111) * ((v121 * v130).abs() * v111);
    let v157 = -v62;
    let v158 = L4 * (v44 * sin_v6 + v157 * cos_v6) + L3 * (v44 * cos_v6 - v157 * sin_v6);
    let v159 = -v61;
    let v160 = v157 * v58;
    let v161 = v159 * v50;
    let v162 = v160 - v161;
    let v163 = v50 * (v159 * (v94 - v93) + v50 * (v44 * v158));
    let v164 = L1 * -(v91 * v91 * cos_v7 + v162 * sin_v7) + v163;
    let v165 = v39 * v79;
    let v166 = v165 * v85;
    let v167 = v40 * v52;
    let v168 = v49 * v49;
    let v169 = v48 * (2.0 * v45 + v48);
    let v170 = v169 * (v54 * v73).abs() + v168 * (v39 * (v73.abs() * v167 + c29 * v166));
    let v171 = v165 * v87;
    let v172 = v48 * (v50 * v104).abs() + v49 * (v39 * (v102 * v167 + c29 * v171));
    let v173 = v61.abs() + v63;
    let v174 = v169 * (v54 * v74).abs() + v168 * (v39 * (v74.abs() * v167 + c30 * v171));
    let v175 = v105 * v63 + v173 * v103 + v174 + (v170 + ((v58 * v93).abs() * v64 + v65 * v172));
    let v176 = v48 * (v50 * v108).abs() + v49 * (v39 * (v106 * v167 + c30 * v166));
    let v177 = v109 * v63 + v173 * v107 + ((v58 * v94).abs() * v64 + v65 * v176);
    let v178 = (2.0 * v97 + v98) * (v72.abs() * v98) + v99 * v99 * v83;
    let v179 = v59 * v64 + v65 * v56;
    let v180 = v51 * v63 + v173 * v41 + v179;
    let v181 = v178 + (v101 * v180 + (v162.abs() + v180) * v100);
    let v182 = v175 + (v181 + v177);
    let v183 = v161 * v132 + (v57 * v57 * v113 - v160 * v132);
    let v184 = (2.0 * v44 - c32).abs() + 2.0 * v48;
    let v185 = 4.0 * (v136 * v65) + v34 * (2.0 * v184 + 6.0 * (v65 * v137));
    let v186 = s_rate2 * c31 + v118;
    let v187 = (v54 * v50).abs();
    let v188 = v41 * (v39 * (v51 + 2.0 * v39));
    let v189 = v187 + v188;
    let v190 = 2.0 * (v65 * (v118 * v189)) + 4.0 * (v33 * (v34 * v189));
    let v191 = v157 * v50;
    let v192 = 2.0 * ((v50 * v191).abs() + (v55 * v64 + v65 * v53));
    let v193 = v33 * v141;
    let v194 = v135 * v143 + 2.0 * (v136 * v193) + (v51 * v186 + v115 + v184 * v142 + v139 * v192);
    let v195 = v194 + v39 * (v40 * v186 + v68 * (v39 * v39 * v185));
    let v196 = c27 * (v65 * v190 + v195) + v168 * (v39 * (v114 * v167 + c28 * v171));
    let v197 = v48 * (v50 * v133).abs() + v49 * (v39 * (v145 * v167 + c28 * v166));
    let v198 = (v58 * v132).abs() * v64 + v173 * v146 + (v169 * (v54 * v113).abs() + v65 * v197);
    let v199 = v134 * v63 + v196 + v198;
    let v200 = 2.0 * (v151 * v149) + cos_v6 * (2.0 * (v149 * v150) - v164);
    let v201 = (v121 * v150).abs() * v147 + v156 + v148 * (v128 * v111 + v112 * v126);
    let v202 = (v121 * (-v183 + c18 * (v121 * v200))).abs() + v122 * v199;
    let v203 = v131 * v182 + v202 + (v183.abs() + v199) * v125 + (v164.abs() + v182) * v129;
    let v204 = s_rate * (v203 + 2.0 * (v112 * v112 * v155 + v201));
    let v205 = JH * v121;
    let v206 = c27 * v90;
    let v207 = v124 * v206;
    let v208 = (v121 * v205).abs() * v111 + v207 * (v112 * v123);
    let v209 = v34 * ((v50 * v58).abs() + (v187 * v48 + v49 * v188));
    let v210 = v65 * (v143 + v193 + 2.0 * (v137 * v69 + v209));
    let v211 = (v184 * v69 + v173 * v143 + v136 * v60 + v210) * (v205.abs() + v207);
    let v212 = s_rate2 * (v211 + v70 * ((v150 * v205).abs() + v208));
    let v213 = JH * (v50 * (v121 * (v44 * (v191 + v150) - v159)));
    let v214 = c27 * v49;
    let v215 = JH * v50;
    let v216 = (v50 * v215).abs() * v48 + v214 * v53 + (JH * v58).abs() * v124;
    let v217 = v215.abs();
    let v218 = (v217 * v48 + v214 * v41) * v90 + (JH * v57).abs() * v124 * v123;
    let v219 = (v50 * v205).abs() * v63 + (v58 * v205).abs() * v64;
    let v220 = v219 + v213.abs() + (v205 * (v57 * v121)).abs() * v111;
    let v221 = v173 * ((c27 * v41 + v217 * v124) * v90) + (v220 + v65 * (v216 * v90));
    let v222 = 2.0 * (s_rate3 * (v221 + v112 * (v90 * v218)) + v212);
    let v223 = (2.0 * v160 - v191).abs() + v51 * v64 + v65 * v41;
    let v224 = s_rate2 * (s_rate2 * ((v223 + 2.0 * v179) * v206) + v153);
    let v225 = s_rate3 * (v70 * v206) + v224 + s_rate * (v204 + v222);
    let v226 = v18 + f64::INFINITY * (v71 * v206) + extra[3] * extra[3] * v225;
    let out = out.first_chunk_mut::<2>()?;
    out[0] = v18 + extra[3] * v154;
    out[1] = v226;
    Some(())
}

/// Is not used by the table.
fn function_10(_: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let out = out.first_chunk_mut::<1>()?;
    out[0] = 4.0;
    Some(())
}

/// The derivative of the state in mode A2.
#[inline(always)]
fn derivative_a2(given: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let constants = given.constants.first_chunk::<34>()?;
    let state = given.state.first_chunk::<2>()?;
    let c33 = constants[33];
    let theta_h = state[0];
    let theta_h_dot = state[1];
    let cos_theta_h = math::sin_cos(theta_h).1;
    let out = out.first_chunk_mut::<2>()?;
    out[0] = theta_h_dot;
    out[1] = -(c33 * cos_theta_h);
    Some(())
}

/// The derivative's derivative by the state in mode A2.
fn jacobian_a2(given: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let constants = given.constants.first_chunk::<34>()?;
    let state = given.state.first_chunk::<1>()?;
    let c33 = constants[33];
    let theta_h = state[0];
    let sin_theta_h = math::sin_cos(theta_h).0;
    let out = out.first_chunk_mut::<4>()?;
    [out[0], out[1]] = [0.0, 1.0];
    out[2] = c33 * sin_theta_h;
    out[3] = 0.0;
    Some(())
}

/// The readout in mode A2.
#[inline(always)]
fn readout_a2(given: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let constants = given.constants.first_chunk::<18>()?;
    let input = given.input;
    let JK = constants[9];
    let c17 = constants[17];
    let s = input[0];
    let s_rate2 = input[2];
    let cos_s = math::sin_cos(s).1;
    let out = out.first_chunk_mut::<1>()?;
    out[0] = s_rate2 * JK + c17 * cos_s;
    Some(())
}

/// The readout's slopes in mode A2.
fn slopes_a2(given: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let constants = given.constants.first_chunk::<18>()?;
    let input = given.input;
    let c17 = constants[17];
    let s = input[0];
    let sin_s = math::sin_cos(s).0;
    let out = out.first_chunk_mut::<2>()?;
    out[0] = -(c17 * sin_s);
    out[1] = 0.0;
    Some(())
}

/// The outputs in mode A2.
fn outputs_a2(given: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let constants = given.constants.first_chunk::<23>()?;
    let state = given.state.first_chunk::<1>()?;
    let input = given.input;
    let L1 = constants[0];
    let L3 = constants[2];
    let L4 = constants[3];
    let JK = constants[9];
    let r = constants[16];
    let c17 = constants[17];
    let c21 = constants[21];
    let c22 = constants[22];
    let theta_h = state[0];
    let s = input[0];
    let s_rate2 = input[2];
    let ([_, sin_theta_h], [cos_s, cos_theta_h]) = math::sin_cos_of_two([s, theta_h]);
    let sin_theta_h_s = math::sin_cos(theta_h - s).0;
    let v0 = L1 * sin_theta_h_s + (L4 * cos_theta_h - L3 * sin_theta_h);
    let out = out.first_chunk_mut::<12>()?;
    out[0] = 0.0;
    out[1] = s_rate2 * JK + c17 * cos_s;
    [out[2], out[3], out[4], out[5], out[6], out[7], out[8]] = [v0, 0.0, 0.0, s, L3, L4, theta_h];
    [out[9], out[10], out[11]] = [c22, c21 - s * r, 0.0];
    Some(())
}

/// Energy, supplied and dissipated power in mode A2.
fn balance_a2(given: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let constants = given.constants.first_chunk::<25>()?;
    let state = given.state.first_chunk::<2>()?;
    let input = given.input;
    let M2 = constants[5];
    let JK = constants[9];
    let JH = constants[10];
    let c17 = constants[17];
    let c23 = constants[23];
    let c24 = constants[24];
    let theta_h = state[0];
    let theta_h_dot = state[1];
    let s = input[0];
    let s_rate = input[1];
    let s_rate2 = input[2];
    let ([sin_s, sin_theta_h], [cos_s, _]) = math::sin_cos_of_two([s, theta_h]);
    let v0 = JH * (theta_h_dot * theta_h_dot) + JK * (s_rate * s_rate);
    let v1 = 0.5 * v0 + c17 * sin_s - M2 * -(c24 + c23 * sin_theta_h);
    let out = out.first_chunk_mut::<3>()?;
    out[0] = v1;
    out[1] = s_rate * (JK * s_rate2 + c17 * cos_s);
    out[2] = 0.0;
    Some(())
}

/// The state after guard land in mode A2.
fn reset_0_land_a2(given: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let constants = given.constants.first_chunk::<21>()?;
    let state = given.state.first_chunk::<2>()?;
    let input = given.input;
    let L1 = constants[0];
    let L3 = constants[2];
    let L4 = constants[3];
    let c20 = constants[20];
    let theta_h_dot = state[1];
    let s = input[0];
    let s_rate = input[1];
    let (sin_s, cos_s) = math::sin_cos(s);
    let v0 = L1 * sin_s - L4;
    let v1 = L1 * cos_s - L3;
    let v2 = math::atan2(v0, v1);
    let v3 = L1 * (s_rate * (cos_s * v1 + sin_s * v0)) / (v0 * v0 + v1 * v1);
    let ([_, sin_v2], [cos_s_v2, cos_v2]) = math::sin_cos_of_two([s - v2, v2]);
    let v4 = L1 * cos_s_v2;
    let v5 = L4 * sin_v2 + L3 * cos_v2;
    let v6 = v4 - v5;
    let v7 = c20 * cos_s_v2 * (theta_h_dot * v5 + (s_rate - theta_h_dot) * v4);
    let out = out.first_chunk_mut::<3>()?;
    [out[0], out[1]] = [v2, v3];
    out[2] = v7 / (v6 * v6);
    Some(())
}

/// The guard and its rate: land in mode A2.
#[inline(always)]
fn guard_land_a2(given: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let constants = given.constants.first_chunk::<4>()?;
    let state = given.state.first_chunk::<2>()?;
    let input = given.input;
    let L1 = constants[0];
    let L3 = constants[2];
    let L4 = constants[3];
    let theta_h = state[0];
    let theta_h_dot = state[1];
    let s = input[0];
    let s_rate = input[1];
    let v0 = theta_h - s;
    let ([sin_theta_h, sin_v0], [cos_theta_h, cos_v0]) = math::sin_cos_of_two([theta_h, v0]);
    let v1 = L1 * sin_v0 + (L4 * cos_theta_h - L3 * sin_theta_h);
    let v2 = theta_h_dot * -(L4 * sin_theta_h + L3 * cos_theta_h);
    let out = out.first_chunk_mut::<2>()?;
    out[0] = v1;
    out[1] = v2 - L1 * (s_rate - theta_h_dot) * cos_v0;
    Some(())
}

/// Bounds of the guard's move and bend: land in mode A2.
fn bound_land_a2(given: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let constants = given.constants.first_chunk::<31>()?;
    let state = given.state.first_chunk::<1>()?;
    let extra = given.extra.first_chunk::<8>()?;
    let input = given.input;
    let L1 = constants[0];
    let L3 = constants[2];
    let L4 = constants[3];
    let c25 = constants[25];
    let c29 = constants[29];
    let c30 = constants[30];
    let theta_h = state[0];
    let s_rate = input[1];
    let s_rate2 = input[2];
    let v0 = theta_h - extra[7];
    let ([sin_theta_h, sin_v0], [cos_theta_h, cos_v0]) = math::sin_cos_of_two([theta_h, v0]);
    let v1 = L1 * cos_v0;
    let v2 = sin_v0.abs();
    let v3 = s_rate * extra[3];
    let v4 = extra[0] + v3;
    let v5 = 0.5 * v4;
    let v6 = c25 * v4;
    let v7 = v6 * functions::smaller(v5 + v2, 1.0);
    let v8 = 0.5 * extra[0];
    let v9 = functions::smaller(v8 + cos_theta_h.abs(), 1.0);
    let v10 = functions::smaller(v8 + sin_theta_h.abs(), 1.0);
    let v11 = (L4 * sin_theta_h + L3 * cos_theta_h - v1).abs() + v7;
    let v12 = extra[0] * (c29 * v9 + c30 * v10) + v11;
    let v13 = v1.abs() + v7;
    let v14 = functions::smaller(v5 + cos_v0.abs(), 1.0);
    let v15 = c25 * extra[1] * functions::smaller(v2 + v4 * v14, 1.0);
    let v16 = L1 * sin_v0;
    let v17 = v6 * v14;
    let v18 = extra[3] * s_rate2 * v13 + s_rate * (v3 * (v16.abs() + v17) + 2.0 * v15);
    let v19 = (v16 + (L4 * cos_theta_h - L3 * sin_theta_h)).abs();
    let v20 = extra[1] * (extra[0] * (c29 * v10 + c30 * v9) + (v19 + v17));
    let out = out.first_chunk_mut::<2>()?;
    out[0] = v3 * v13 + extra[0] * v12;
    out[1] = extra[2] * v12 + extra[1] * v20 + extra[3] * v18;
    Some(())
}

/// The state after guard string in mode A2.
fn reset_0_string_a2(given: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let constants = given.constants.first_chunk::<14>()?;
    let state = given.state.first_chunk::<2>()?;
    let string_angle = constants[12];
    let restitution = constants[13];
    let theta_h_dot = state[1];
    let out = out.first_chunk_mut::<3>()?;
    out[0] = string_angle;
    out[1] = -(theta_h_dot * restitution);
    out[2] = 0.0;
    Some(())
}

/// The speed of what strikes at guard string in mode A2.
fn speed_string_a2(given: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let constants = given.constants.first_chunk::<2>()?;
    let state = given.state.first_chunk::<2>()?;
    let L2 = constants[1];
    let theta_h_dot = state[1];
    let out = out.first_chunk_mut::<1>()?;
    out[0] = L2 * theta_h_dot.abs();
    Some(())
}

/// The guard and its rate: string in mode A2.
#[inline(always)]
fn guard_string_a2(given: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let constants = given.constants.first_chunk::<13>()?;
    let state = given.state.first_chunk::<2>()?;
    let string_angle = constants[12];
    let theta_h = state[0];
    let theta_h_dot = state[1];
    let out = out.first_chunk_mut::<2>()?;
    out[0] = string_angle - theta_h;
    out[1] = -theta_h_dot;
    Some(())
}

/// Bounds of the guard's move and bend: string in mode A2.
fn bound_string_a2(given: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let extra = given.extra.first_chunk::<3>()?;
    let out = out.first_chunk_mut::<2>()?;
    [out[0], out[1]] = [extra[0], extra[2]];
    Some(())
}

/// Where the Taylor series begins in mode A2.
fn series_start_a2(given: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let constants = given.constants.first_chunk::<34>()?;
    let state = given.state.first_chunk::<2>()?;
    let input = given.input;
    let L1 = constants[0];
    let L3 = constants[2];
    let L4 = constants[3];
    let string_angle = constants[12];
    let c33 = constants[33];
    let theta_h = state[0];
    let theta_h_dot = state[1];
    let s = input[0];
    let v0 = theta_h - s;
    let ([sin_theta_h, sin_v0], [cos_theta_h, cos_v0]) = math::sin_cos_of_two([theta_h, v0]);
    let v1 = L1 * sin_v0 + (L4 * cos_theta_h - L3 * sin_theta_h);
    let out = out.first_chunk_mut::<8>()?;
    out[0] = theta_h_dot;
    out[1] = -(c33 * cos_theta_h);
    out[2] = v1;
    out[3] = string_angle - theta_h;
    [out[4], out[5], out[6], out[7]] = [cos_theta_h, sin_theta_h, cos_v0, sin_v0];
    Some(())
}

/// One order of the Taylor series in mode A2.
fn series_step_a2(given: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let constants = given.constants.first_chunk::<34>()?;
    let state = given.state.first_chunk::<2>()?;
    let extra = given.extra.first_chunk::<10>()?;
    let input = given.input;
    let L1 = constants[0];
    let L3 = constants[2];
    let L4 = constants[3];
    let c33 = constants[33];
    let theta_h = state[0];
    let theta_h_dot = state[1];
    let s = input[0];
    let v0 = theta_h - s;
    let v1 = extra[6] * extra[1] + theta_h * extra[2];
    let v2 = -(extra[7] * extra[1] + theta_h * extra[3]);
    let v3 = extra[8] * extra[1] + v0 * extra[4];
    let v4 = extra[0] * theta_h;
    let v5 = extra[0] * v0;
    let out = out.first_chunk_mut::<12>()?;
    [out[0], out[1]] = [theta_h_dot, -(c33 * v2)];
    out[2] = L1 * v3 + (L4 * v2 - L3 * v1);
    [out[3], out[4], out[5], out[6], out[7], out[8], out[9]] = [-theta_h, v4, v4, v5, v5, v2, v1];
    out[10] = -(extra[9] * extra[1] + v0 * extra[5]);
    out[11] = v3;
    Some(())
}

/// The numbers of the drawing.
fn drawing(given: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let constants = given.constants.first_chunk::<17>()?;
    let L1 = constants[0];
    let L2 = constants[1];
    let L3 = constants[2];
    let L4 = constants[3];
    let cK = constants[8];
    let string_angle = constants[12];
    let r = constants[16];
    let v0 = math::atan2(-L4, L1 - L3);
    let v1 = 0.08 * L1;
    let v2 = 0.16 * L1;
    let ([sin_v0, sin_string_angle], [cos_v0, cos_string_angle]) =
        math::sin_cos_of_two([v0, string_angle]);
    let v3 = functions::larger(0.288_000_000_000_000_03 * L1, 0.012 + v2);
    let v4 = 0.088_000_000_000_000_01 * L1;
    let v5 = functions::smaller(L4 - 0.2 * L1 + L2 * sin_v0, -(v4 + v3));
    let v6 = 0.24 * L1 + functions::larger(L3 + L2, L1);
    let v7 = L4 + 0.4 * L1 + L2 * sin_string_angle;
    let v8 = functions::larger(L4 + v2, f64::from_bits(0x3fd4_7ae1_47ae_147b) * L1);
    let v9 = -(0.192 * L1);
    let v10 = -(0.296_000_000_000_000_04 * L1);
    let v11 = 0.124_444_444_444_444_44 * L1;
    let v12 = -v11;
    let v13 = -(f64::from_bits(0x3fd4_8971_8cdb_5d13) * L1);
    let v14 = -(0.088_888_888_888_888_89 * L1);
    let v15 = -(0.053_333_333_333_333_344 * L1);
    let v16 = 0.017_777_777_777_777_78 * L1;
    let v17 = -v16;
    let v18 = 0.053_333_333_333_333_316 * L1;
    let v19 = 0.088_888_888_888_888_88 * L1;
    let v20 = 0.064 * L1;
    let v21 = 0.055_999_999_999_999_994 * L1;
    let v22 = L3 - 0.152 * L1;
    let v23 = L4 + v20;
    let v24 = 0.016 * L1;
    let v25 = L3 - v24;
    let v26 = L4 + 0.144_000_000_000_000_02 * L1;
    let v27 = L4 - v24;
    let v28 = L3 + 0.008 * L1;
    let v29 = -r;
    let v30 = 1.08 * L1;
    let v31 = -v4;
    let v32 = functions::smaller(v21, 0.5 * r);
    let v33 = -v32;
    let v34 = 0.04 * L1;
    let v35 = 0.0144 * L1;
    let v36 = 0.013_909_331_898_562_582 * L1;
    let v37 = 0.003_726_994_249_476_298_5 * L1;
    let v38 = 0.012_470_765_814_495_917 * L1;
    let v39 = 0.007_199_999_999_999_999 * L1;
    let v40 = 0.010_182_337_649_086_284 * L1;
    let v41 = 0.010_182_337_649_086_283 * L1;
    let v42 = 0.007_200_000_000_000_001_5 * L1;
    let v43 = 0.012_470_765_814_495_915 * L1;
    let v44 = 8.817_456_953_860_942e-19 * L1;
    let v45 = -(0.003_726_994_249_476_297 * L1);
    let v46 = -(0.007_199_999_999_999_996 * L1);
    let v47 = -v41;
    let v48 = -v38;
    let v49 = -v36;
    let v50 = 0.003_726_994_249_476_302_4 * L1;
    let v51 = -v35;
    let v52 = 1.763_491_390_772_188_4e-18 * L1;
    let v53 = -(0.003_726_994_249_476_299_4 * L1);
    let v54 = -(0.012_470_765_814_495_919 * L1);
    let v55 = -(0.007_199_999_999_999_995_5 * L1);
    let v56 = -(0.010_182_337_649_086_29 * L1);
    let v57 = -(0.010_182_337_649_086_28 * L1);
    let v58 = -(0.007_200_000_000_000_006 * L1);
    let v59 = 0.012_470_765_814_495_912 * L1;
    let v60 = -v59;
    let v61 = -(2.645_237_086_158_282_6e-18 * L1);
    let v62 = 0.003_726_994_249_476_292 * L1;
    let v63 = -(0.013_909_331_898_562_584 * L1);
    let v64 = -v43;
    let v65 = 0.010_182_337_649_086_281 * L1;
    let v66 = -(0.010_182_337_649_086_286 * L1);
    let v67 = 0.013_909_331_898_562_58 * L1;
    let v68 = -(0.003_726_994_249_476_310_7 * L1);
    let v69 = functions::larger(v29, functions::smaller(cK, L1));
    let v70 = 0.032 * L1;
    let v71 = -(0.14 * L1);
    let v72 = -(0.131_717_790_556_719_34 * L1);
    let v73 = 0.027_712_812_921_102_038 * L1;
    let v74 = -(0.124_000_000_000_000_01 * L1);
    let v75 = -(0.117_372_583_002_030_49 * L1);
    let v76 = 0.016_000_000_000_000_004 * L1 + v69;
    let v77 = -(0.112_287_187_078_897_98 * L1);
    let v78 = -(0.109_090_373_558_749_83 * L1);
    let v79 = v69 - 0.008_282_209_443_280_661 * L1;
    let v80 = L1 - 32.352_380_637_815_095 * v69;
    let v81 = -(0.167_712_812_921_102_04 * L1);
    let v82 = -(0.170_909_626_441_250_2 * L1);
    let v83 = 0.992 * L1;
    let v84 = 1.008 * L1;
    let v85 = L1 * cos_v0;
    let v86 = 0.016 * v85;
    let v87 = L1 * sin_v0;
    let v88 = 0.016 * v87;
    let v89 = 0.004_141_104_721_640_332 * v87;
    let v90 = 0.015_454_813_220_625_094 * v85;
    let v91 = 0.004_141_104_721_640_332 * v85;
    let v92 = 0.015_454_813_220_625_094 * v87;
    let v93 = L1 - 0.007_999_999_999_999_998 * v87;
    let v94 = 0.013_856_406_460_551_019 * v85;
    let v95 = 0.007_999_999_999_999_998 * v85;
    let v96 = 0.013_856_406_460_551_019 * v87;
    let v97 = 0.011_313_708_498_984_762 * (v85 - 0.999_999_999_999_999_9 * v87);
    let v98 = 0.011_313_708_498_984_76 * (v85 + 1.000_000_000_000_000_2 * v87);
    let v99 = L1 + 0.008_000_000_000_000_002 * v85;
    let v100 = 0.013_856_406_460_551_017 * v87;
    let v101 = 0.008_000_000_000_000_002 * v87;
    let v102 = 0.013_856_406_460_551_017 * v85;
    let v103 = L1 - 0.004_141_104_721_640_330_4 * v85;
    let v104 = 0.004_141_104_721_640_330_4 * v87;
    let v105 = L1 - 0.004_141_104_721_640_336_5 * v87 - 0.015_454_813_220_625_092 * v85;
    let v106 = 0.004_141_104_721_640_336_5 * v85 - 0.015_454_813_220_625_092 * v87;
    let v107 = L1 + 0.007_999_999_999_999_995 * v87 - 0.013_856_406_460_551_02 * v85;
    let v108 = 0.007_999_999_999_999_995 * v85 + 0.013_856_406_460_551_02 * v87;
    let v109 = L1 + 0.011_313_708_498_984_755 * v87 - 0.011_313_708_498_984_767 * v85;
    let v110 = 0.011_313_708_498_984_755 * v85 + 0.011_313_708_498_984_767 * v87;
    let v111 = 0.008_000_000_000_000_007 * (v85 - 1.732_050_807_568_875_2 * v87);
    let v112 = 0.013_856_406_460_551_014 * (v85 + 0.577_350_269_189_626_5 * v87);
    let v113 = 0.015_454_813_220_625_096 * v87 + (L1 + 0.004_141_104_721_640_325 * v85);
    let v114 = 0.004_141_104_721_640_325 * v87 - 0.015_454_813_220_625_096 * v85;
    let v115 = 0.011_313_708_498_984_764 * v87 + (L1 + 0.011_313_708_498_984_758 * v85);
    let v116 = 0.011_313_708_498_984_758 * v87 - 0.011_313_708_498_984_764 * v85;
    let v117 = 0.015_454_813_220_625_089 * v85 + (L1 + 0.004_141_104_721_640_345 * v87);
    let v118 = 0.015_454_813_220_625_089 * v87 - 0.004_141_104_721_640_345 * v85;
    let v119 = -(0.024 * L1);
    let v120 = 0.048 * L1;
    let v121 = L1 * sin_string_angle;
    let v122 = L1 * cos_string_angle;
    let v123 = 0.027_999_999_999_999_997 * v122;
    let v124 = L2 - v123;
    let v125 = 0.16 * v121;
    let v126 = 0.027_999_999_999_999_997 * v121;
    let v127 = 0.16 * v122;
    let v128 = L2 + v123;
    let v129 = f64::from_bits(0x3fd4_7ae1_47ae_147b) * v121;
    let v130 = f64::from_bits(0x3fd4_7ae1_47ae_147b) * v122;
    let v131 = L2 + 0.128 * v121;
    let v132 = 0.04 * v122;
    let v133 = 0.04 * v121;
    let v134 = 0.128 * v122;
    let v135 = L2 + 0.208_000_000_000_000_02 * v121;
    let v136 = 0.072_000_000_000_000_01 * v122;
    let v137 = 0.072_000_000_000_000_01 * v121;
    let v138 = 0.208_000_000_000_000_02 * v122;
    let v139 = L2 + 0.288_000_000_000_000_03 * v121;
    let v140 = 0.08 * v122;
    let v141 = 0.08 * v121;
    let v142 = 0.288_000_000_000_000_03 * v122;
    let v143 = L2 + 0.351_883_232_000_000_05 * v121;
    let v144 = 0.061_997_768_000_000_01 * v122;
    let v145 = 0.061_997_768_000_000_01 * v121;
    let v146 = 0.351_883_232_000_000_05 * v122;
    let v147 = L2 + 0.371_116_152_000_000_03 * v121;
    let v148 = 0.053_505_664 * v122;
    let v149 = 0.053_505_664 * v121;
    let v150 = 0.371_116_152_000_000_03 * v122;
    let v151 = L2 + 0.386_559_504 * v121;
    let v152 = 0.039_239_48 * v122;
    let v153 = 0.039_239_48 * v121;
    let v154 = 0.386_559_504 * v122;
    let v155 = L2 + f64::from_bits(0x3fd9_6105_75d8_15ce) * v121;
    let v156 = 0.020_738_752 * v122;
    let v157 = 0.020_738_752 * v121;
    let v158 = f64::from_bits(0x3fd9_6105_75d8_15ce) * v122;
    let v159 = 0.012 * L1;
    let v160 = 0.011_591_109_915_468_82 * L1;
    let v161 = 0.003_105_828_541_230_249 * L1;
    let v162 = 0.010_392_304_845_413_265 * L1;
    let v163 = 0.005_999_999_999_999_999 * L1;
    let v164 = 0.008_485_281_374_238_571 * L1;
    let v165 = 0.008_485_281_374_238_57 * L1;
    let v166 = L2 + 0.006_000_000_000_000_002 * L1;
    let v167 = 0.010_392_304_845_413_263 * L1;
    let v168 = L2 - 0.003_105_828_541_230_247_4 * L1;
    let v169 = L2 - v162;
    let v170 = L2 - v160;
    let v171 = 0.006_000_000_000_000_005 * L1;
    let v172 = 0.010_392_304_845_413_26 * L1;
    let v173 = 0.026_000_000_000_000_002 * L1;
    let v174 = 0.052_000_000_000_000_005 * L1;
    let v175 = 0.166_400_000_000_000_02 * L1;
    let out = out.first_chunk_mut::<416>()?;
    out[0] = -(v2 + functions::larger(r, v1));
    [out[1], out[2]] = [v5, v6];
    out[3] = v1 + functions::larger(v7, v8);
    [out[4], out[5], out[6], out[7], out[8], out[9], out[10]] = [0.0, v9, -v1, v10, v1, v10, -v2];
    [out[11], out[12], out[13]] = [v10, v12, v10];
    out[14] = -(0.149_333_333_333_333_35 * L1);
    [out[15], out[16], out[17], out[18], out[19]] = [v13, v12, v10, v14, v10];
    out[20] = -(0.113_777_777_777_777_78 * L1);
    [out[21], out[22], out[23], out[24], out[25]] = [v13, v14, v10, v15, v10];
    out[26] = -(0.078_222_222_222_222_23 * L1);
    [out[27], out[28], out[29], out[30], out[31]] = [v13, v15, v10, v17, v10];
    out[32] = -(0.042_666_666_666_666_67 * L1);
    [out[33], out[34], out[35], out[36], out[37]] = [v13, v17, v10, v16, v10];
    out[38] = -(0.007_111_111_111_111_124 * L1);
    [out[39], out[40], out[41], out[42], out[43]] = [v13, v16, v10, v18, v10];
    out[44] = 0.028_444_444_444_444_44 * L1;
    [out[45], out[46], out[47], out[48], out[49], out[50]] = [v13, v18, v10, v19, v10, v20];
    [out[51], out[52], out[53], out[54], out[55]] = [v13, v19, v10, v11, v10];
    out[56] = 0.099_555_555_555_555_54 * L1;
    [out[57], out[58], out[59], out[60], out[61]] = [v13, v11, v10, v2, v10];
    out[62] = 0.135_111_111_111_111_15 * L1;
    [out[63], out[64], out[65], out[66], out[67], out[68]] = [v13, v2, v10, 0.0, v9, 0.0];
    [out[69], out[70], out[71], out[72], out[73], out[74]] = [v21, v22, v23, v25, v23, v25];
    [out[75], out[76], out[77]] = [v26, v22, v26];
    out[78] = L3 - 0.096 * L1;
    out[79] = v23;
    out[80] = L3 - 0.027_999_999_999_999_997 * L1;
    [out[81], out[82], out[83], out[84], out[85], out[86]] = [v27, v28, v27, v28, v23, v29];
    [out[87], out[88], out[89], out[90], out[91], out[92]] = [v9, v30, v9, v30, v31, v29];
    [out[93], out[94], out[95], out[96], out[97], out[98]] = [v31, v33, v31, v32, v31, v32];
    [out[99], out[100], out[101], out[102], out[103], out[104]] = [v34, v33, v34, v35, 0.0, v36];
    [out[105], out[106], out[107], out[108], out[109], out[110]] = [v37, v38, v39, v40, v41, v42];
    [out[111], out[112], out[113], out[114], out[115], out[116]] = [v43, v37, v36, v44, v35, v45];
    [out[117], out[118], out[119], out[120], out[121], out[122]] = [v36, v46, v38, v47, v40, v48];
    [out[123], out[124], out[125], out[126], out[127], out[128]] = [v39, v49, v50, v51, v52, v49];
    [out[129], out[130], out[131], out[132], out[133], out[134]] = [v53, v54, v55, v56, v57, v58];
    [out[135], out[136], out[137], out[138], out[139], out[140]] = [v60, v45, v49, v61, v51, v62];
    [out[141], out[142], out[143], out[144], out[145], out[146]] = [v63, v42, v64, v65, v66, v59];
    [out[147], out[148], out[149], out[150], out[151]] = [v58, v67, v68, v70 + v69, v71];
    out[152] = 0.030_909_626_441_250_188 * L1 + v69;
    [out[153], out[154], out[155]] = [v72, v73 + v69, v74];
    out[156] = 0.022_627_416_997_969_524 * L1 + v69;
    [out[157], out[158], out[159]] = [v75, v76, v77];
    out[160] = 0.008_282_209_443_280_664 * L1 + v69;
    out[161] = v78;
    out[162] = 1.959_434_878_635_765e-18 * L1 + v69;
    out[163] = -(0.108_000_000_000_000_01 * L1);
    [out[164], out[165]] = [v79, v78];
    out[166] = v69 - 0.015_999_999_999_999_993 * L1;
    out[167] = v77;
    out[168] = v69 - 0.022_627_416_997_969_52 * L1;
    [out[169], out[170], out[171]] = [v75, v69 - v73, v74];
    out[172] = -(0.030_909_626_441_250_185 * v80);
    [out[173], out[174], out[175]] = [v72, v69 - v70, v71];
    out[176] = -(0.030_909_626_441_250_188 * v80);
    out[177] = -(0.148_282_209_443_280_7 * L1);
    out[178] = v69 - 0.027_712_812_921_102_04 * L1;
    out[179] = -(0.156 * L1);
    out[180] = v69 - 0.022_627_416_997_969_534 * L1;
    out[181] = -(0.162_627_416_997_969_5 * L1);
    out[182] = v69 - 0.016_000_000_000_000_014 * L1;
    [out[183], out[184], out[185]] = [v81, v79, v82];
    out[186] = v69 - 5.878_304_635_907_295_5e-18 * L1;
    out[187] = -(0.172_000_000_000_000_01 * L1);
    out[188] = 0.008_282_209_443_280_65 * L1 + v69;
    [out[189], out[190], out[191]] = [v82, v76, v81];
    out[192] = 0.022_627_416_997_969_517 * L1 + v69;
    out[193] = -(0.162_627_416_997_969_54 * L1);
    out[194] = 0.027_712_812_921_102_028 * L1 + v69;
    out[195] = -(0.156_000_000_000_000_03 * L1);
    out[196] = 0.030_909_626_441_250_178 * L1 + v69;
    out[197] = -(0.148_282_209_443_280_72 * L1);
    [out[198], out[199], out[200], out[201], out[202], out[203]] = [v83, v31, v84, v31, v84, 0.0];
    [out[204], out[205], out[206], out[207]] = [v83, 0.0, L1 + v86, v88];
    out[208] = v90 + (L1 - v89);
    [out[209], out[210], out[211], out[212]] = [v91 + v92, v94 + v93, v95 + v96, L1 + v97];
    [out[213], out[214], out[215]] = [v98, v99 - v100, v101 + v102];
    out[216] = L1 + v91 - v92;
    out[217] = v89 + v90;
    out[218] = 9.797_174_393_178_825e-19 * v85 + (L1 - v88);
    out[219] = v86 + 9.797_174_393_178_825e-19 * v87;
    [out[220], out[221]] = [v103 - v92, v90 - v104];
    out[222] = L1 - v96 - 0.007_999_999_999_999_997 * v85;
    out[223] = v94 - 0.007_999_999_999_999_997 * v87;
    [out[224], out[225], out[226], out[227]] = [L1 - v98, v97, v93 - v94, v95 - v96];
    [out[228], out[229]] = [v105, v106];
    out[230] = L1 - v86 - 1.959_434_878_635_765e-18 * v87;
    out[231] = 1.959_434_878_635_765e-18 * v85 - v88;
    out[232] = 0.004_141_104_721_640_333 * v87 + (L1 - v90);
    out[233] = -(v92 + 0.004_141_104_721_640_333 * v85);
    [out[234], out[235], out[236], out[237], out[238]] = [v107, -v108, v109, -v110, L1 - v111];
    [out[239], out[240]] = [-v112, v92 + v103];
    out[241] = -(v90 + v104);
    out[242] = L1 + v88 - 2.939_152_317_953_647_7e-18 * v85;
    out[243] = -(v86 + 2.939_152_317_953_647_7e-18 * v87);
    [out[244], out[245], out[246], out[247]] = [v113, v114, v100 + v99, v101 - v102];
    [out[248], out[249], out[250], out[251], out[252]] = [v115, v116, L1 + v112, -v111, v117];
    [out[253], out[254], out[255], out[256], out[257], out[258]] = [v118, v119, v24, L2, v24, L2];
    [out[259], out[260], out[261], out[262]] = [v120, v119, v120, v124 - v125];
    [out[263], out[264]] = [v126 - v127, v128 - v125];
    out[265] = -(v126 + v127);
    [out[266], out[267], out[268], out[269]] = [v129 + v128, v130 - v126, v129 + v124, v126 + v130];
    [out[270], out[271], out[272], out[273]] = [v132 + v131, v134 - v133, v136 + v135, v138 - v137];
    [out[274], out[275], out[276], out[277]] = [v140 + v139, v142 - v141, v144 + v143, v146 - v145];
    [out[278], out[279], out[280], out[281]] = [v148 + v147, v150 - v149, v152 + v151, v154 - v153];
    [out[282], out[283]] = [v156 + v155, v158 - v157];
    out[284] = L2 + 0.4 * v121;
    [out[285], out[286], out[287], out[288]] = [0.4 * v122, v155 - v156, v157 + v158, v151 - v152];
    [out[289], out[290], out[291], out[292]] = [v153 + v154, v147 - v148, v149 + v150, v143 - v144];
    [out[293], out[294], out[295], out[296]] = [v145 + v146, v139 - v140, v141 + v142, v135 - v136];
    [out[297], out[298], out[299], out[300]] = [v137 + v138, v131 - v132, v133 + v134, v35];
    [out[301], out[302], out[303], out[304], out[305], out[306]] = [0.0, v36, v37, v38, v39, v40];
    [out[307], out[308], out[309], out[310], out[311], out[312]] = [v41, v42, v43, v37, v36, v44];
    [out[313], out[314], out[315], out[316], out[317], out[318]] = [v35, v45, v36, v46, v38, v47];
    [out[319], out[320], out[321], out[322], out[323], out[324]] = [v40, v48, v39, v49, v50, v51];
    [out[325], out[326], out[327], out[328], out[329], out[330]] = [v52, v49, v53, v54, v55, v56];
    [out[331], out[332], out[333], out[334], out[335], out[336]] = [v57, v58, v60, v45, v49, v61];
    [out[337], out[338], out[339], out[340], out[341], out[342]] = [v51, v62, v63, v42, v64, v65];
    [out[343], out[344], out[345], out[346], out[347]] = [v66, v59, v58, v67, v68];
    [out[348], out[349], out[350], out[351]] = [L2 + v159, 0.0, L2 + v160, v161];
    [out[352], out[353], out[354], out[355], out[356]] = [L2 + v162, v163, L2 + v164, v165, v166];
    [out[357], out[358], out[359]] = [v167, L2 + v161, v160];
    out[360] = L2 + 7.347_880_794_884_119e-19 * L1;
    [out[361], out[362], out[363]] = [v159, v168, v160];
    out[364] = L2 - 0.005_999_999_999_999_997_5 * L1;
    [out[365], out[366], out[367], out[368], out[369]] = [v162, L2 - v165, v164, v169, v163];
    out[370] = v170;
    out[371] = 0.003_105_828_541_230_252 * L1;
    out[372] = L2 - v159;
    out[373] = 1.469_576_158_976_823_9e-18 * L1;
    out[374] = v170;
    out[375] = -(0.003_105_828_541_230_249_6 * L1);
    out[376] = v169;
    out[377] = -(0.005_999_999_999_999_997 * L1);
    out[378] = L2 - 0.008_485_281_374_238_575 * L1;
    out[379] = -(0.008_485_281_374_238_566 * L1);
    [out[380], out[381], out[382], out[383]] = [L2 - v171, -v172, v168, -v160];
    out[384] = L2 - 2.204_364_238_465_235_5e-18 * L1;
    out[385] = -v159;
    out[386] = L2 + 0.003_105_828_541_230_243_5 * L1;
    out[387] = -(0.011_591_109_915_468_821 * L1);
    [out[388], out[389]] = [v166, -v167];
    out[390] = L2 + 0.008_485_281_374_238_568 * L1;
    out[391] = -(0.008_485_281_374_238_573 * L1);
    [out[392], out[393]] = [L2 + v172, -v171];
    out[394] = L2 + 0.011_591_109_915_468_818 * L1;
    out[395] = -(0.003_105_828_541_230_259 * L1);
    out[396] = L3 + L2 * (cos_string_angle - 0.6);
    [out[397], out[398], out[399], out[400], out[401], out[402]] = [v7, v6, v7, -v173, 0.0, v173];
    out[403] = 0.0;
    out[404] = 0.046_800_000_000_000_01 * L1;
    out[405] = 0.020_800_000_000_000_003 * L1;
    [out[406], out[407], out[408], out[409]] = [v174, v174, 0.0364 * L1, v175];
    out[410] = -(0.057_200_000_000_000_01 * L1);
    [out[411], out[412]] = [v175, -v174];
    out[413] = 0.041_600_000_000_000_005 * L1;
    out[414] = -(0.043_680_000_000_000_004 * L1);
    out[415] = 0.01248 * L1;
    Some(())
}

/// The preset paper.
fn preset_paper(_: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let out = out.first_chunk_mut::<17>()?;
    [out[0], out[1], out[2], out[3], out[4], out[5]] = [0.4, 1.0, 0.1, 0.05, 6.5, 0.01];
    [out[6], out[7], out[8], out[9], out[10], out[11]] = [6.2, 15.0, 0.002, 0.01625, 0.01, 9.81];
    [out[12], out[13], out[14], out[15]] = [0.398, 1.0, 0.0, 0.0];
    out[16] = 0.097_020_853_308_819_4;
    Some(())
}

/// The preset literal.
fn preset_literal(_: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let out = out.first_chunk_mut::<17>()?;
    [out[0], out[1], out[2], out[3], out[4], out[5]] = [4.0, 10.0, 1.0, 0.5, 6.5, 0.01];
    [out[6], out[7], out[8], out[9], out[10], out[11]] = [620.0, 15.0, 0.02, 1.625, 1.0, 9.81];
    [out[12], out[13], out[14], out[15]] = [0.398, 1.0, 0.0, 0.0];
    out[16] = 0.097_020_853_308_819_4;
    Some(())
}

/// The preset playable.
fn preset_playable(given: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let extra = given.extra.first_chunk::<1>()?;
    let v0 = 0.000_630_306_423_357_664 * extra[0] - 0.034_866_025_053_821_58;
    let v1 = 0.000_207_048_950_680_000_01 - 1.159_049_32e-6 * extra[0];
    let out = out.first_chunk_mut::<17>()?;
    [out[0], out[1]] = [0.1385, 0.13];
    out[2] = 0.124_800_000_000_000_01;
    [out[3], out[4]] = [0.0027, 0.13];
    out[5] = 0.011_137_652 - 6.2348e-5 * extra[0];
    [out[6], out[7], out[8], out[9], out[10], out[11]] = [300.0, 24000.0, v0, 0.002, v1, 9.81];
    out[12] = 0.213_336_278_760_121_84;
    [out[13], out[14], out[15], out[16]] = [0.1, 0.12, 6.0, 0.2595];
    Some(())
}

/// Input per metre of key-front travel.
fn input_per_metre(given: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let constants = given.constants.first_chunk::<17>()?;
    let r = constants[16];
    let out = out.first_chunk_mut::<1>()?;
    out[0] = 1.0 / r;
    Some(())
}

/// The state to start from.
fn rest(_: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let out = out.first_chunk_mut::<2>()?;
    [out[0], out[1]] = [0.0, 0.0];
    Some(())
}

/// What follows from the parameters.
fn derived_constants(given: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let constants = given.constants.first_chunk::<17>()?;
    let L1 = constants[0];
    let L2 = constants[1];
    let L3 = constants[2];
    let L4 = constants[3];
    let M1 = constants[4];
    let M2 = constants[5];
    let cK = constants[8];
    let JH = constants[10];
    let g = constants[11];
    let r = constants[16];
    let v0 = g * L2;
    let v1 = M2 * v0;
    let v2 = L1 * L1;
    let v3 = L1.abs();
    let out = out.first_chunk_mut::<17>()?;
    out[0] = cK * (g * M1);
    [out[1], out[2], out[3]] = [v1, v2, L1 * JH];
    out[4] = -(0.088_000_000_000_000_01 * L1);
    out[5] = 0.048 * L1 - r;
    [out[6], out[7], out[8], out[9], out[10]] = [v0, g * L4, v3, v3 * v3, JH.abs()];
    [out[11], out[12], out[13], out[14]] = [v1.abs(), L4.abs(), L3.abs(), v2.abs()];
    [out[15], out[16]] = [2.0 * v2, v1 / JH];
    Some(())
}
