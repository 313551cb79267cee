//! Emitted from `the description of key-hammer-springs` by `letoff model emit`; not to be changed by hand.
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
    PartTable, PresetTable, RestTable, SeriesTable, SpringTable, WayTable,
};
use pode::{EquationKind, Fires, GuardId, GuardSpec, Part, Reads, math};

/// All of the model but its arithmetic.
pub static TABLE: ModelTable = ModelTable {
    name: "key-hammer-springs",
    summary: "the paper's model B: key and hammer with springs in the contacts",
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
        NamedQuantity { name: "theta_k", unit: "rad" },
        NamedQuantity { name: "theta_h_dot", unit: "rad/s" },
        NamedQuantity { name: "theta_k_dot", unit: "rad/s" },
    ],
    coordinates: 2,
    constants: 32,
    derive_constants: 32,
    input: NamedQuantity { name: "s", unit: "rad" },
    input_per_metre: 30,
    modes: &[
        ModeTable {
            name: "B1",
            derivative: 0,
            parts: &[PartTable {
                entries: 0xf,
                derivative: 0,
                kind: EquationKind::Smooth,
                loss: Some(1),
                reads: Reads::StateAndInput,
            }],
            part_list: &[Part::WHOLE],
            slaved: None,
            projection: None,
            projected: 0,
            longest_projection: None,
            readout: 3,
            slopes: 4,
            outputs: 5,
            balance: 6,
            jacobian: 2,
            series: Some(SeriesTable {
                start: 13,
                step: 14,
                entries: 0xf,
                guards: 2,
                conditions: 1,
                lanes: 27,
                carried: 26,
            }),
            kind: EquationKind::Smooth,
            loss: Some(1),
            is_stiffening: false,
            guards: &[
                GuardTable {
                    id: 0,
                    name: "release",
                    unit: "m",
                    priority: 0,
                    scale: 1.0,
                    fires: Fires::WhileNegative,
                    reads: Reads::State,
                    value: 7,
                    bound: Some(8),
                    ways: &[WayTable { when: None, to: 1, reset: None, resting: None }],
                    sounds: None,
                },
                GuardTable {
                    id: 1,
                    name: "string",
                    unit: "1",
                    priority: 2,
                    scale: 1.0,
                    fires: Fires::OnCrossing,
                    reads: Reads::State,
                    value: 11,
                    bound: Some(12),
                    ways: &[WayTable { when: None, to: 0, reset: Some(9), resting: None }],
                    sounds: Some(10),
                },
            ],
            guard_specs: &[
                GuardSpec {
                    id: GuardId(0),
                    name: "release",
                    priority: 0,
                    scale: 1.0,
                    fires: Fires::WhileNegative,
                    reads: Reads::State,
                },
                GuardSpec {
                    id: GuardId(1),
                    name: "string",
                    priority: 2,
                    scale: 1.0,
                    fires: Fires::OnCrossing,
                    reads: Reads::State,
                },
            ],
            contacts: &[],
            freedom: Freedom { n: 4, m: 2, p: 2 },
        },
        ModeTable {
            name: "B2",
            derivative: 15,
            parts: &[
                PartTable {
                    entries: 0x5,
                    derivative: 16,
                    kind: EquationKind::Conservative,
                    loss: None,
                    reads: Reads::State,
                },
                PartTable {
                    entries: 0xa,
                    derivative: 17,
                    kind: EquationKind::Smooth,
                    loss: Some(18),
                    reads: Reads::StateAndInput,
                },
            ],
            part_list: &[Part::of(&[0, 2]).of_state(), Part::of(&[1, 3])],
            slaved: None,
            projection: None,
            projected: 0,
            longest_projection: None,
            readout: 3,
            slopes: 4,
            outputs: 20,
            balance: 21,
            jacobian: 19,
            series: Some(SeriesTable {
                start: 24,
                step: 25,
                entries: 0xf,
                guards: 2,
                conditions: 0,
                lanes: 6,
                carried: 6,
            }),
            kind: EquationKind::Smooth,
            loss: Some(18),
            is_stiffening: false,
            guards: &[
                GuardTable {
                    id: 2,
                    name: "land",
                    unit: "m",
                    priority: 1,
                    scale: 1.0,
                    fires: Fires::WhileNegative,
                    reads: Reads::State,
                    value: 22,
                    bound: Some(23),
                    ways: &[WayTable { when: None, to: 0, reset: None, resting: None }],
                    sounds: None,
                },
                GuardTable {
                    id: 1,
                    name: "string",
                    unit: "1",
                    priority: 2,
                    scale: 1.0,
                    fires: Fires::OnCrossing,
                    reads: Reads::State,
                    value: 11,
                    bound: Some(12),
                    ways: &[WayTable { when: None, to: 1, reset: Some(9), resting: None }],
                    sounds: Some(10),
                },
            ],
            guard_specs: &[
                GuardSpec {
                    id: GuardId(2),
                    name: "land",
                    priority: 1,
                    scale: 1.0,
                    fires: Fires::WhileNegative,
                    reads: Reads::State,
                },
                GuardSpec {
                    id: GuardId(1),
                    name: "string",
                    priority: 2,
                    scale: 1.0,
                    fires: Fires::OnCrossing,
                    reads: Reads::State,
                },
            ],
            contacts: &[],
            freedom: Freedom { n: 4, m: 2, p: 2 },
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
            reads: Reads::State,
        },
        GuardSpec {
            id: GuardId(1),
            name: "string",
            priority: 2,
            scale: 1.0,
            fires: Fires::OnCrossing,
            reads: Reads::State,
        },
        GuardSpec {
            id: GuardId(2),
            name: "land",
            priority: 1,
            scale: 1.0,
            fires: Fires::WhileNegative,
            reads: Reads::State,
        },
    ],
    outputs: &[
        NamedQuantity { name: "F_KH", unit: "N" },
        NamedQuantity { name: "T_KU", unit: "N·m" },
        NamedQuantity { name: "gap", unit: "m" },
        NamedQuantity { name: "q4", unit: "m" },
        NamedQuantity { name: "q3", unit: "m" },
        NamedQuantity { name: "key.x", unit: "m" },
        NamedQuantity { name: "key.y", unit: "m" },
        NamedQuantity { name: "key.angle", unit: "rad" },
        NamedQuantity { name: "sunk.x", unit: "m" },
        NamedQuantity { name: "sunk.y", unit: "m" },
        NamedQuantity { name: "sunk.angle", unit: "rad" },
        NamedQuantity { name: "manipulandum.x", unit: "m" },
        NamedQuantity { name: "manipulandum.y", unit: "m" },
        NamedQuantity { name: "manipulandum.angle", unit: "rad" },
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
        count: 432,
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
                output: Some(5),
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
                ],
            },
            BodyTable {
                name: "slider",
                output: Some(8),
                outlines: &[OutlineTable {
                    material: Material::Metal,
                    is_closed: true,
                    points: (198, 24),
                    modes: &[],
                }],
            },
            BodyTable {
                name: "manipulandum",
                output: Some(11),
                outlines: &[
                    OutlineTable {
                        material: Material::Metal,
                        is_closed: true,
                        points: (246, 4),
                        modes: &[],
                    },
                    OutlineTable {
                        material: Material::Metal,
                        is_closed: true,
                        points: (254, 4),
                        modes: &[],
                    },
                ],
            },
            BodyTable {
                name: "hammer",
                output: Some(14),
                outlines: &[
                    OutlineTable {
                        material: Material::Wood,
                        is_closed: true,
                        points: (262, 4),
                        modes: &[],
                    },
                    OutlineTable {
                        material: Material::Wood,
                        is_closed: true,
                        points: (270, 4),
                        modes: &[],
                    },
                    OutlineTable {
                        material: Material::Felt,
                        is_closed: true,
                        points: (278, 15),
                        modes: &[],
                    },
                    OutlineTable {
                        material: Material::Metal,
                        is_closed: true,
                        points: (308, 24),
                        modes: &[],
                    },
                    OutlineTable {
                        material: Material::Metal,
                        is_closed: true,
                        points: (356, 24),
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
                    points: (404, 2),
                    modes: &[],
                }],
            },
            BodyTable {
                name: "finger",
                output: Some(17),
                outlines: &[OutlineTable {
                    material: Material::Finger,
                    is_closed: true,
                    points: (408, 8),
                    modes: &[],
                }],
            },
        ],
        springs: &[
            SpringTable { name: "k1", from: (2, 424), to: (4, 426), modes: &[] },
            SpringTable { name: "k2", from: (2, 428), to: (3, 430), modes: &[] },
        ],
    },
};

/// The model's arithmetic.
#[derive(Clone, Copy, Debug, Default)]
pub struct KeyHammerSpringsFunctions;

impl Functions for KeyHammerSpringsFunctions {
    fn call(&self, function: FunctionId, given: &Arguments<'_>, out: &mut [f64]) {
        let done = match function {
            0 => derivative_b1(given, out),
            1 => function_1(given, out),
            2 => jacobian_b1(given, out),
            3 => readout_b1(given, out),
            4 => slopes_b1(given, out),
            5 => outputs_b1(given, out),
            6 => balance_b1(given, out),
            7 => guard_release_b1(given, out),
            8 => bound_release_b1(given, out),
            9 => reset_0_string_b1(given, out),
            10 => speed_string_b1(given, out),
            11 => guard_string_b1(given, out),
            12 => bound_string_b1(given, out),
            13 => series_start_b1(given, out),
            14 => series_step_b1(given, out),
            15 => derivative_b2(given, out),
            16 => part_0_b2(given, out),
            17 => part_1_b2(given, out),
            18 => function_18(given, out),
            19 => jacobian_b2(given, out),
            20 => outputs_b2(given, out),
            21 => balance_b2(given, out),
            22 => guard_land_b2(given, out),
            23 => bound_land_b2(given, out),
            24 => series_start_b2(given, out),
            25 => series_step_b2(given, out),
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
            0 => derivative_b1(given, out),
            15 => derivative_b2(given, out),
            _ => None,
        };
        if done.is_none() {
            out.fill(f64::NAN);
        }
    }

    #[inline(always)]
    fn readout(&self, function: FunctionId, given: &Arguments<'_>, out: &mut [f64]) {
        let done = match function {
            3 => readout_b1(given, out),
            _ => None,
        };
        if done.is_none() {
            out.fill(f64::NAN);
        }
    }

    #[inline(always)]
    fn guard(&self, function: FunctionId, given: &Arguments<'_>, out: &mut [f64]) {
        let done = match function {
            7 => guard_release_b1(given, out),
            11 => guard_string_b1(given, out),
            22 => guard_land_b2(given, out),
            _ => None,
        };
        if done.is_none() {
            out.fill(f64::NAN);
        }
    }

    #[inline(always)]
    fn bound(&self, function: FunctionId, given: &Arguments<'_>, out: &mut [f64]) {
        let done = match function {
            8 => bound_release_b1(given, out),
            12 => bound_string_b1(given, out),
            23 => bound_land_b2(given, out),
            _ => None,
        };
        if done.is_none() {
            out.fill(f64::NAN);
        }
    }
}

/// The derivative of the state in mode B1.
#[inline(always)]
fn derivative_b1(given: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let constants = given.constants.first_chunk::<21>()?;
    let state = given.state.first_chunk::<4>()?;
    let input = given.input;
    let L1 = constants[0];
    let L3 = constants[2];
    let L4 = constants[3];
    let k1 = constants[6];
    let k2 = constants[7];
    let b1 = constants[14];
    let c2 = constants[15];
    let c17 = constants[17];
    let c18 = constants[18];
    let c19 = constants[19];
    let c20 = constants[20];
    let theta_h = state[0];
    let theta_k = state[1];
    let theta_h_dot = state[2];
    let theta_k_dot = state[3];
    let s = input[0];
    let s_rate = input[1];
    let ([sin_theta_k, sin_theta_h], [cos_theta_k, cos_theta_h]) =
        math::sin_cos_of_two([theta_k, theta_h]);
    let v0 = L1 * sin_theta_k;
    let v1 = L4 - v0;
    let v2 = L1 * cos_theta_k;
    let v3 = L3 - v2;
    let v4 = sin_theta_k * sin_theta_h + cos_theta_k * cos_theta_h;
    let v5 = 1.0 / -v4;
    let v6 = (sin_theta_k * v1 + cos_theta_k * v3) * v5;
    let v7 = (cos_theta_h * v1 - sin_theta_h * v3) * v5;
    let v8 = sin_theta_h * (v0 - cos_theta_k * v7) - cos_theta_h * -(v2 + sin_theta_k * v7);
    let v9 = 1.0 / v4;
    let v10 = c2 * (v9 * (theta_k_dot * v8 - theta_h_dot * v6));
    let v11 = v9 * v7 * (k2 * functions::larger(1.0 + v10, 0.0));
    let v12 = k1 * (s - theta_k) + b1 * (s_rate - theta_k_dot) - c17 * cos_theta_k;
    let out = out.first_chunk_mut::<4>()?;
    [out[0], out[1]] = [theta_h_dot, theta_k_dot];
    out[2] = c19 * (v6 * v11 - c18 * cos_theta_h);
    out[3] = c20 * (v12 - v8 * v11);
    Some(())
}

/// Is not used by the table.
fn function_1(given: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let constants = given.constants.first_chunk::<16>()?;
    let k2 = constants[7];
    let b1 = constants[14];
    let c2 = constants[15];
    let out = out.first_chunk_mut::<1>()?;
    out[0] = b1 * b1 + k2 * k2 * (c2 * c2);
    Some(())
}

/// The derivative's derivative by the state in mode B1.
fn jacobian_b1(given: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let constants = given.constants.first_chunk::<23>()?;
    let state = given.state.first_chunk::<4>()?;
    let L1 = constants[0];
    let L3 = constants[2];
    let L4 = constants[3];
    let k1 = constants[6];
    let k2 = constants[7];
    let b1 = constants[14];
    let c2 = constants[15];
    let c17 = constants[17];
    let c18 = constants[18];
    let c19 = constants[19];
    let c20 = constants[20];
    let c21 = constants[21];
    let c22 = constants[22];
    let theta_h = state[0];
    let theta_k = state[1];
    let theta_h_dot = state[2];
    let theta_k_dot = state[3];
    let ([sin_theta_k, sin_theta_h], [cos_theta_k, cos_theta_h]) =
        math::sin_cos_of_two([theta_k, theta_h]);
    let v0 = L1 * sin_theta_k;
    let v1 = L4 - v0;
    let v2 = L1 * cos_theta_k;
    let v3 = L3 - v2;
    let v4 = sin_theta_k * v1 + cos_theta_k * v3;
    let v5 = cos_theta_h * v1 - sin_theta_h * v3;
    let v6 = sin_theta_k * sin_theta_h + cos_theta_k * cos_theta_h;
    let v7 = -v6;
    let v8 = 1.0 / v7;
    let v9 = v5 * v8;
    let v10 = v2 + sin_theta_k * v9;
    let v11 = -v10;
    let v12 = v0 - cos_theta_k * v9;
    let v13 = sin_theta_h * v12 - cos_theta_h * v11;
    let v14 = 1.0 / v6;
    let v15 = v14 * (theta_k_dot * v13 - theta_h_dot * (v4 * v8));
    let v16 = 1.0 + c2 * v15;
    let v17 = sin_theta_k * cos_theta_h - cos_theta_k * sin_theta_h;
    let v18 = -v17;
    let v19 = v18 * v8;
    let v20 = v17 * v14;
    let v21 = v20 + v19;
    let v22 = -(cos_theta_h * v3 + sin_theta_h * v1);
    let v23 = v8 * (v18 * v9 - v22);
    let v24 = cos_theta_h * (v12 - sin_theta_k * v23) + sin_theta_h * (v11 + cos_theta_k * v23);
    let v25 = v14 * v13;
    let v26 = theta_h_dot * (v8 * (v4 * v21)) + theta_k_dot * (v24 - v17 * v25);
    let v27 = if v16 > 0.0 { c2 * (v14 * v26) } else { 0.0 };
    let v28 = functions::larger(v16, 0.0);
    let v29 = v22 * v28 + v5 * (v27 + -(v20 + 2.0 * v19) * v28);
    let v30 = v8 * v8;
    let v31 = c18 * sin_theta_h + k2 * (v30 * (v4 * (v14 * v29)));
    let v32 = cos_theta_k * v1 - sin_theta_k * v3;
    let v33 = v17 * v8;
    let v34 = v18 * v14;
    let v35 = v34 + v33;
    let v36 = L1 * v7;
    let v37 = v8 * (v17 * v9 - v36);
    let v38 = sin_theta_h * (v10 + cos_theta_k * v37) - cos_theta_h * (v12 + sin_theta_k * v37);
    let v39 = theta_h_dot * (v8 * (v4 * v35 - v32)) + theta_k_dot * (v38 - v18 * v25);
    let v40 = if v16 > 0.0 { c2 * (v14 * v39) } else { 0.0 };
    let v41 = v32 * v28 + v4 * (v40 + -(v34 + 2.0 * v33) * v28);
    let v42 = c19 * (k2 * (v30 * (v14 * (v36 * v4 * v28 + v5 * v41))));
    let v43 = v14 * v8;
    let v44 = v4 * v43;
    let v45 = if v16 > 0.0 { -(c2 * v44) } else { 0.0 };
    let v46 = v44 * (c21 * v9);
    let v47 = if v16 > 0.0 { c2 * v25 } else { 0.0 };
    let v48 = v5 * (v13 * (v21 * v28 - v27) - v24 * v28) - v22 * v13 * v28;
    let v49 = v5 * (v13 * (v35 * v28 - v40) - v38 * v28) - v36 * v13 * v28;
    let v50 = c20 * (c17 * sin_theta_k - k1 + k2 * (v8 * (v14 * v49)));
    let v51 = v5 * v13;
    let out = out.first_chunk_mut::<16>()?;
    [out[0], out[1], out[2], out[3], out[4], out[5], out[6]] = [0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0];
    [out[7], out[8], out[9], out[10], out[11]] = [1.0, c19 * v31, v42, v46 * v45, v46 * v47];
    out[12] = c20 * (k2 * (v8 * (v14 * v48)));
    out[13] = v50;
    out[14] = -(c22 * v43 * v51 * v45);
    out[15] = c20 * -(b1 + k2 * v43 * v51 * v47);
    Some(())
}

/// The readout in mode B1.
#[inline(always)]
fn readout_b1(given: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let constants = given.constants.first_chunk::<15>()?;
    let state = given.state.first_chunk::<4>()?;
    let input = given.input;
    let k1 = constants[6];
    let b1 = constants[14];
    let theta_k = state[1];
    let theta_k_dot = state[3];
    let s = input[0];
    let s_rate = input[1];
    let out = out.first_chunk_mut::<1>()?;
    out[0] = k1 * (s - theta_k) + b1 * (s_rate - theta_k_dot);
    Some(())
}

/// The readout's slopes in mode B1.
fn slopes_b1(given: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let constants = given.constants.first_chunk::<15>()?;
    let k1 = constants[6];
    let b1 = constants[14];
    let out = out.first_chunk_mut::<2>()?;
    [out[0], out[1]] = [k1, b1];
    Some(())
}

/// The outputs in mode B1.
fn outputs_b1(given: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let constants = given.constants.first_chunk::<25>()?;
    let state = given.state.first_chunk::<4>()?;
    let input = given.input;
    let L1 = constants[0];
    let L3 = constants[2];
    let L4 = constants[3];
    let k1 = constants[6];
    let k2 = constants[7];
    let b1 = constants[14];
    let c2 = constants[15];
    let r = constants[16];
    let c23 = constants[23];
    let c24 = constants[24];
    let theta_h = state[0];
    let theta_k = state[1];
    let theta_h_dot = state[2];
    let theta_k_dot = state[3];
    let s = input[0];
    let s_rate = input[1];
    let ([sin_theta_k, sin_theta_h], [cos_theta_k, cos_theta_h]) =
        math::sin_cos_of_two([theta_k, theta_h]);
    let v0 = L1 * sin_theta_k;
    let v1 = L4 - v0;
    let v2 = L1 * cos_theta_k;
    let v3 = L3 - v2;
    let v4 = sin_theta_k * sin_theta_h + cos_theta_k * cos_theta_h;
    let v5 = 1.0 / -v4;
    let v6 = (sin_theta_k * v1 + cos_theta_k * v3) * v5;
    let v7 = (cos_theta_h * v1 - sin_theta_h * v3) * v5;
    let v8 = sin_theta_h * (v0 - cos_theta_k * v7) - cos_theta_h * -(v2 + sin_theta_k * v7);
    let v9 = c2 * (1.0 / v4 * (theta_k_dot * v8 - theta_h_dot * v6));
    let sin_theta_k_theta_h = math::sin_cos(theta_k - theta_h).0;
    let v10 = L4 * cos_theta_h - L3 * sin_theta_h - L1 * sin_theta_k_theta_h;
    let v11 = functions::larger(v7, 0.0);
    let out = out.first_chunk_mut::<20>()?;
    out[0] = k2 * v7 * functions::larger(1.0 + v9, 0.0);
    out[1] = k1 * (s - theta_k) + b1 * (s_rate - theta_k_dot);
    [out[2], out[3], out[4], out[5], out[6], out[7]] = [v10, v7, v6, 0.0, 0.0, theta_k];
    out[8] = sin_theta_k * v11;
    out[9] = -(cos_theta_k * v11);
    [out[10], out[11], out[12], out[13], out[14], out[15]] = [theta_k, 0.0, 0.0, s, L3, L4];
    [out[16], out[17], out[18], out[19]] = [theta_h, c24, c23 - s * r, 0.0];
    Some(())
}

/// Energy, supplied and dissipated power in mode B1.
fn balance_b1(given: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let constants = given.constants.first_chunk::<27>()?;
    let state = given.state.first_chunk::<4>()?;
    let input = given.input;
    let L1 = constants[0];
    let L3 = constants[2];
    let L4 = constants[3];
    let M2 = constants[5];
    let k1 = constants[6];
    let k2 = constants[7];
    let JK = constants[9];
    let JH = constants[10];
    let b1 = constants[14];
    let c2 = constants[15];
    let c17 = constants[17];
    let c25 = constants[25];
    let c26 = constants[26];
    let theta_h = state[0];
    let theta_k = state[1];
    let theta_h_dot = state[2];
    let theta_k_dot = state[3];
    let s = input[0];
    let s_rate = input[1];
    let v0 = s - theta_k;
    let v1 = k1 * v0;
    let ([sin_theta_h, sin_theta_k], [cos_theta_h, cos_theta_k]) =
        math::sin_cos_of_two([theta_h, theta_k]);
    let v2 = L1 * cos_theta_k;
    let v3 = L3 - v2;
    let v4 = L1 * sin_theta_k;
    let v5 = L4 - v4;
    let v6 = cos_theta_h * v5 - sin_theta_h * v3;
    let v7 = sin_theta_h * sin_theta_k + cos_theta_k * cos_theta_h;
    let v8 = 1.0 / -v7;
    let v9 = v6 * v8;
    let v10 = JH * (theta_h_dot * theta_h_dot) + JK * (theta_k_dot * theta_k_dot);
    let v11 = c17 * sin_theta_k - M2 * -(c26 + c25 * sin_theta_h);
    let v12 = s_rate - theta_k_dot;
    let v13 = b1 * v12;
    let v14 = theta_h_dot * (sin_theta_k * v5 + cos_theta_k * v3);
    let v15 = sin_theta_h * (v4 - cos_theta_k * v9) - cos_theta_h * -(v2 + sin_theta_k * v9);
    let v16 = 1.0 / v7 * (theta_k_dot * v15 - v14 * v8);
    let v17 = v6 * (functions::larger(1.0 + c2 * v16, 0.0) - 1.0);
    let out = out.first_chunk_mut::<3>()?;
    out[0] = v11 + 0.5 * (v0 * v1 + v10 + v9 * (k2 * v9));
    out[1] = s_rate * (v1 + v13);
    out[2] = v12 * v13 + v16 * (k2 * (v8 * v17));
    Some(())
}

/// The guard and its rate: release in mode B1.
#[inline(always)]
fn guard_release_b1(given: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let constants = given.constants.first_chunk::<4>()?;
    let state = given.state.first_chunk::<4>()?;
    let L1 = constants[0];
    let L3 = constants[2];
    let L4 = constants[3];
    let theta_h = state[0];
    let theta_k = state[1];
    let theta_h_dot = state[2];
    let theta_k_dot = state[3];
    let v0 = theta_k - theta_h;
    let ([sin_theta_h, sin_v0], [cos_theta_h, cos_v0]) = math::sin_cos_of_two([theta_h, v0]);
    let v1 = L1 * sin_v0 + (L3 * sin_theta_h - L4 * cos_theta_h);
    let v2 = theta_h_dot * (L4 * sin_theta_h + L3 * cos_theta_h);
    let out = out.first_chunk_mut::<2>()?;
    out[0] = v1;
    out[1] = L1 * (theta_k_dot - theta_h_dot) * cos_v0 + v2;
    Some(())
}

/// Bounds of the guard's move and bend: release in mode B1.
#[inline(always)]
fn bound_release_b1(given: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let constants = given.constants.first_chunk::<30>()?;
    let state = given.state.first_chunk::<2>()?;
    let extra = given.extra.first_chunk::<7>()?;
    let L1 = constants[0];
    let L3 = constants[2];
    let L4 = constants[3];
    let c27 = constants[27];
    let c28 = constants[28];
    let c29 = constants[29];
    let theta_h = state[0];
    let theta_k = state[1];
    let v0 = theta_k - theta_h;
    let ([sin_theta_h, sin_v0], [cos_theta_h, cos_v0]) = math::sin_cos_of_two([theta_h, v0]);
    let v1 = L4 * sin_theta_h + L3 * cos_theta_h - L1 * cos_v0;
    let v2 = 0.5 * extra[0];
    let v3 = functions::smaller(v2 + cos_theta_h.abs(), 1.0);
    let v4 = functions::smaller(v2 + sin_theta_h.abs(), 1.0);
    let v5 = extra[0] + extra[4];
    let v6 = sin_v0.abs();
    let v7 = 0.5 * v5;
    let v8 = v5 * functions::smaller(v7 + v6, 1.0);
    let v9 = c29 * v8 + (v1.abs() + extra[0] * (c27 * v3 + c28 * v4));
    let v10 = cos_v0.abs();
    let v11 = c29 * functions::smaller(v10 + v8, 1.0);
    let v12 = L1 * sin_v0;
    let v13 = (L4 * cos_theta_h - L3 * sin_theta_h - v12).abs();
    let v14 = v5 * functions::smaller(v7 + v10, 1.0);
    let v15 = c29 * v14;
    let v16 = extra[1] * (extra[0] * (c27 * v4 + c28 * v3) + (v13 + v15));
    let v17 = c29 * (extra[5] * functions::smaller(v6 + v14, 1.0));
    let v18 = extra[2] * v9 + extra[5] * (extra[5] * (v12.abs() + v15));
    let v19 = v18 + extra[6] * v11 + extra[1] * (v16 + 2.0 * v17);
    let out = out.first_chunk_mut::<2>()?;
    out[0] = extra[0] * v9 + extra[4] * v11;
    out[1] = v19;
    Some(())
}

/// The state after guard string in mode B1.
fn reset_0_string_b1(given: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let constants = given.constants.first_chunk::<14>()?;
    let state = given.state.first_chunk::<4>()?;
    let string_angle = constants[12];
    let restitution = constants[13];
    let theta_k = state[1];
    let theta_h_dot = state[2];
    let theta_k_dot = state[3];
    let out = out.first_chunk_mut::<5>()?;
    [out[0], out[1]] = [string_angle, theta_k];
    out[2] = -(theta_h_dot * restitution);
    [out[3], out[4]] = [theta_k_dot, 0.0];
    Some(())
}

/// The speed of what strikes at guard string in mode B1.
fn speed_string_b1(given: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let constants = given.constants.first_chunk::<2>()?;
    let state = given.state.first_chunk::<3>()?;
    let L2 = constants[1];
    let theta_h_dot = state[2];
    let out = out.first_chunk_mut::<1>()?;
    out[0] = L2 * theta_h_dot.abs();
    Some(())
}

/// The guard and its rate: string in mode B1.
#[inline(always)]
fn guard_string_b1(given: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let constants = given.constants.first_chunk::<13>()?;
    let state = given.state.first_chunk::<3>()?;
    let string_angle = constants[12];
    let theta_h = state[0];
    let theta_h_dot = state[2];
    let out = out.first_chunk_mut::<2>()?;
    out[0] = string_angle - theta_h;
    out[1] = -theta_h_dot;
    Some(())
}

/// Bounds of the guard's move and bend: string in mode B1.
#[inline(always)]
fn bound_string_b1(given: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let extra = given.extra.first_chunk::<3>()?;
    let out = out.first_chunk_mut::<2>()?;
    [out[0], out[1]] = [extra[0], extra[2]];
    Some(())
}

/// Where the Taylor series begins in mode B1.
fn series_start_b1(given: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let constants = given.constants.first_chunk::<21>()?;
    let state = given.state.first_chunk::<4>()?;
    let input = given.input;
    let L1 = constants[0];
    let L3 = constants[2];
    let L4 = constants[3];
    let k1 = constants[6];
    let k2 = constants[7];
    let string_angle = constants[12];
    let b1 = constants[14];
    let c2 = constants[15];
    let c17 = constants[17];
    let c18 = constants[18];
    let c19 = constants[19];
    let c20 = constants[20];
    let theta_h = state[0];
    let theta_k = state[1];
    let theta_h_dot = state[2];
    let theta_k_dot = state[3];
    let s = input[0];
    let s_rate = input[1];
    let v0 = theta_k - theta_h;
    let ([sin_theta_k, sin_theta_h], [cos_theta_k, cos_theta_h]) =
        math::sin_cos_of_two([theta_k, theta_h]);
    let v1 = L1 * sin_theta_k;
    let v2 = L4 - v1;
    let v3 = L1 * cos_theta_k;
    let v4 = L3 - v3;
    let v5 = sin_theta_k * v2 + cos_theta_k * v4;
    let v6 = sin_theta_k * sin_theta_h + cos_theta_k * cos_theta_h;
    let v7 = 1.0 / -v6;
    let v8 = v5 * v7;
    let v9 = cos_theta_h * v2 - sin_theta_h * v4;
    let v10 = v9 * v7;
    let v11 = -(v3 + sin_theta_k * v10);
    let v12 = v1 - cos_theta_k * v10;
    let v13 = sin_theta_h * v12 - cos_theta_h * v11;
    let v14 = theta_k_dot * v13 - theta_h_dot * v8;
    let v15 = 1.0 / v6;
    let v16 = 1.0 + c2 * (v15 * v14);
    let v17 = v16 - 0.0;
    let v18 = if v17 > 0.0 { v16 } else { 0.0 };
    let v19 = k2 * v18;
    let v20 = v15 * v10;
    let v21 = v20 * v19;
    let v22 = k1 * (s - theta_k) + b1 * (s_rate - theta_k_dot) - c17 * cos_theta_k;
    let (sin_v0, cos_v0) = math::sin_cos(v0);
    let v23 = L1 * sin_v0 + (L3 * sin_theta_h - L4 * cos_theta_h);
    let out = out.first_chunk_mut::<33>()?;
    [out[0], out[1]] = [theta_h_dot, theta_k_dot];
    out[2] = c19 * (v8 * v21 - c18 * cos_theta_h);
    out[3] = c20 * (v22 - v13 * v21);
    out[4] = v23;
    out[5] = string_angle - theta_h;
    [out[6], out[7], out[8], out[9], out[10]] = [v17, cos_theta_k, sin_theta_k, v2, v4];
    [out[11], out[12], out[13], out[14], out[15]] = [cos_theta_h, sin_theta_h, v7, v7, v5];
    [out[16], out[17], out[18], out[19], out[20], out[21]] = [theta_h_dot, v8, v9, v10, v11, v12];
    [out[22], out[23], out[24], out[25], out[26], out[27]] = [theta_k_dot, v13, v15, v15, v14, v17];
    [out[28], out[29], out[30], out[31], out[32]] = [v20, v19, v21, cos_v0, sin_v0];
    Some(())
}

/// One order of the Taylor series in mode B1.
fn series_step_b1(given: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let constants = given.constants.first_chunk::<21>()?;
    let state = given.state.first_chunk::<4>()?;
    let extra = given.extra.first_chunk::<55>()?;
    let input = given.input;
    let L1 = constants[0];
    let L3 = constants[2];
    let L4 = constants[3];
    let k1 = constants[6];
    let k2 = constants[7];
    let b1 = constants[14];
    let c2 = constants[15];
    let c17 = constants[17];
    let c18 = constants[18];
    let c19 = constants[19];
    let c20 = constants[20];
    let theta_h = state[0];
    let theta_k = state[1];
    let theta_h_dot = state[2];
    let theta_k_dot = state[3];
    let s = input[0];
    let s_rate = input[1];
    let v0 = theta_k - theta_h;
    let v1 = extra[28] * extra[1] + theta_k * extra[2];
    let v2 = -(extra[29] * extra[1] + theta_k * extra[3]);
    let v3 = L1 * v1;
    let v4 = -v3;
    let v5 = L1 * v2;
    let v6 = -v5;
    let v7 = extra[30] + extra[3] * v4 + v1 * extra[4];
    let v8 = v7 + (extra[31] + extra[2] * v6 + v2 * extra[5]);
    let v9 = extra[32] * extra[1] + theta_h * extra[6];
    let v10 = -(extra[33] * extra[1] + theta_h * extra[7]);
    let v11 = extra[35] + extra[2] * v10 + v2 * extra[6];
    let v12 = extra[34] + extra[3] * v9 + v1 * extra[7] + v11;
    let v13 = -v12;
    let v14 = (-extra[36] - extra[8] * v13) * extra[9];
    let v15 = extra[37] + extra[10] * v14 + v8 * extra[8];
    let v16 = extra[38] + extra[11] * v15 + theta_h_dot * extra[12];
    let v17 = extra[40] + extra[6] * v4 + v10 * extra[4];
    let v18 = v17 - (extra[39] + extra[7] * v6 + v9 * extra[5]);
    let v19 = extra[41] + extra[13] * v14 + v18 * extra[8];
    let v20 = v5 + (extra[42] + extra[3] * v19 + v1 * extra[14]);
    let v21 = -v20;
    let v22 = v3 - (extra[44] + extra[2] * v19 + v2 * extra[14]);
    let v23 = extra[43] + extra[6] * v21 + v10 * extra[15];
    let v24 = extra[45] + extra[7] * v22 + v9 * extra[16] - v23;
    let v25 = extra[46] + extra[17] * v24 + theta_k_dot * extra[18];
    let v26 = v25 - v16;
    let v27 = (-extra[47] - extra[19] * v12) * extra[20];
    let v28 = c2 * (extra[48] + extra[19] * v26 + v27 * extra[21]);
    let v29 = if extra[22] > 0.0 { v28 } else { 0.0 };
    let v30 = k2 * v29;
    let v31 = extra[49] + extra[19] * v19 + v27 * extra[14];
    let v32 = extra[50] + extra[23] * v30 + v31 * extra[24];
    let v33 = extra[51] + extra[12] * v32 + v15 * extra[25] - c18 * v10;
    let v34 = k1 * (s - theta_k) + b1 * (s_rate - theta_k_dot) - c17 * v2;
    let v35 = v34 - (extra[52] + extra[18] * v32 + v24 * extra[25]);
    let v36 = extra[53] * extra[1] + v0 * extra[26];
    let v37 = extra[0] * theta_k;
    let v38 = extra[0] * theta_h;
    let v39 = extra[0] * v0;
    let out = out.first_chunk_mut::<61>()?;
    [out[0], out[1], out[2], out[3]] = [theta_h_dot, theta_k_dot, c19 * v33, c20 * v35];
    out[4] = L1 * v36 + (L3 * v9 - L4 * v10);
    [out[5], out[6], out[7], out[8], out[9], out[10]] = [-theta_h, v28, v37, v37, v1, v2];
    [out[11], out[12], out[13], out[14], out[15], out[16]] = [v38, v38, v1, v2, v13, v8];
    [out[17], out[18], out[19], out[20], out[21], out[22]] = [theta_h_dot, v9, v10, v18, v1, v10];
    [out[23], out[24], out[25], out[26], out[27], out[28]] = [v2, v9, theta_k_dot, v12, v27, v27];
    [out[29], out[30], out[31], out[32], out[33], out[34]] = [v31, v15, v24, v39, v39, v2];
    [out[35], out[36], out[37], out[38], out[39], out[40]] = [v1, v4, v6, v10, v9, v9];
    [out[41], out[42], out[43], out[44], out[45], out[46]] = [v10, v14, v14, v15, v6, v4];
    [out[47], out[48], out[49], out[50], out[51], out[52]] = [v14, v19, v21, v19, v22, v24];
    [out[53], out[54], out[55], out[56], out[57], out[58]] = [v27, v26, v19, v30, v32, v32];
    out[59] = -(extra[54] * extra[1] + v0 * extra[27]);
    out[60] = v36;
    Some(())
}

/// The derivative of the state in mode B2.
#[inline(always)]
fn derivative_b2(given: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let constants = given.constants.first_chunk::<31>()?;
    let state = given.state.first_chunk::<4>()?;
    let input = given.input;
    let k1 = constants[6];
    let b1 = constants[14];
    let c17 = constants[17];
    let c20 = constants[20];
    let c30 = constants[30];
    let theta_h = state[0];
    let theta_k = state[1];
    let theta_h_dot = state[2];
    let theta_k_dot = state[3];
    let s = input[0];
    let s_rate = input[1];
    let ([_, _], [cos_theta_h, cos_theta_k]) = math::sin_cos_of_two([theta_h, theta_k]);
    let v0 = k1 * (s - theta_k) + b1 * (s_rate - theta_k_dot) - c17 * cos_theta_k;
    let out = out.first_chunk_mut::<4>()?;
    [out[0], out[1]] = [theta_h_dot, theta_k_dot];
    out[2] = -(c30 * cos_theta_h);
    out[3] = c20 * v0;
    Some(())
}

/// The derivative of a part in mode B2.
fn part_0_b2(given: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let constants = given.constants.first_chunk::<31>()?;
    let state = given.state.first_chunk::<3>()?;
    let c30 = constants[30];
    let theta_h = state[0];
    let theta_h_dot = state[2];
    let cos_theta_h = math::sin_cos(theta_h).1;
    let out = out.first_chunk_mut::<4>()?;
    [out[0], out[1]] = [theta_h_dot, 0.0];
    out[2] = -(c30 * cos_theta_h);
    out[3] = 0.0;
    Some(())
}

/// The derivative of a part in mode B2.
fn part_1_b2(given: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let constants = given.constants.first_chunk::<21>()?;
    let state = given.state.first_chunk::<4>()?;
    let input = given.input;
    let k1 = constants[6];
    let b1 = constants[14];
    let c17 = constants[17];
    let c20 = constants[20];
    let theta_k = state[1];
    let theta_k_dot = state[3];
    let s = input[0];
    let s_rate = input[1];
    let cos_theta_k = math::sin_cos(theta_k).1;
    let v0 = k1 * (s - theta_k) + b1 * (s_rate - theta_k_dot) - c17 * cos_theta_k;
    let out = out.first_chunk_mut::<4>()?;
    [out[0], out[1], out[2], out[3]] = [0.0, theta_k_dot, 0.0, c20 * v0];
    Some(())
}

/// Is not used by the table.
fn function_18(given: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let constants = given.constants.first_chunk::<15>()?;
    let b1 = constants[14];
    let out = out.first_chunk_mut::<1>()?;
    out[0] = b1 * b1;
    Some(())
}

/// The derivative's derivative by the state in mode B2.
fn jacobian_b2(given: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let constants = given.constants.first_chunk::<32>()?;
    let state = given.state.first_chunk::<2>()?;
    let k1 = constants[6];
    let c17 = constants[17];
    let c20 = constants[20];
    let c30 = constants[30];
    let c31 = constants[31];
    let theta_h = state[0];
    let theta_k = state[1];
    let ([sin_theta_h, sin_theta_k], [_, _]) = math::sin_cos_of_two([theta_h, theta_k]);
    let out = out.first_chunk_mut::<16>()?;
    [out[0], out[1], out[2], out[3], out[4], out[5], out[6]] = [0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0];
    out[7] = 1.0;
    out[8] = c30 * sin_theta_h;
    [out[9], out[10], out[11], out[12]] = [0.0, 0.0, 0.0, 0.0];
    out[13] = c20 * (c17 * sin_theta_k - k1);
    [out[14], out[15]] = [0.0, c31];
    Some(())
}

/// The outputs in mode B2.
fn outputs_b2(given: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let constants = given.constants.first_chunk::<25>()?;
    let state = given.state.first_chunk::<4>()?;
    let input = given.input;
    let L1 = constants[0];
    let L3 = constants[2];
    let L4 = constants[3];
    let k1 = constants[6];
    let b1 = constants[14];
    let r = constants[16];
    let c23 = constants[23];
    let c24 = constants[24];
    let theta_h = state[0];
    let theta_k = state[1];
    let theta_k_dot = state[3];
    let s = input[0];
    let s_rate = input[1];
    let ([sin_theta_h, sin_theta_k_theta_h], [cos_theta_h, _]) =
        math::sin_cos_of_two([theta_h, theta_k - theta_h]);
    let v0 = L4 * cos_theta_h - L3 * sin_theta_h - L1 * sin_theta_k_theta_h;
    let (sin_theta_k, cos_theta_k) = math::sin_cos(theta_k);
    let v1 = sin_theta_h * sin_theta_k + cos_theta_h * cos_theta_k;
    let v2 = cos_theta_h * (L4 - L1 * sin_theta_k) - sin_theta_h * (L3 - L1 * cos_theta_k);
    let v3 = functions::larger(v2 / -v1, 0.0);
    let out = out.first_chunk_mut::<20>()?;
    out[0] = 0.0;
    out[1] = k1 * (s - theta_k) + b1 * (s_rate - theta_k_dot);
    [out[2], out[3], out[4], out[5], out[6], out[7]] = [v0, 0.0, 0.0, 0.0, 0.0, theta_k];
    out[8] = sin_theta_k * v3;
    out[9] = -(cos_theta_k * v3);
    [out[10], out[11], out[12], out[13], out[14], out[15]] = [theta_k, 0.0, 0.0, s, L3, L4];
    [out[16], out[17], out[18], out[19]] = [theta_h, c24, c23 - s * r, 0.0];
    Some(())
}

/// Energy, supplied and dissipated power in mode B2.
fn balance_b2(given: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let constants = given.constants.first_chunk::<27>()?;
    let state = given.state.first_chunk::<4>()?;
    let input = given.input;
    let M2 = constants[5];
    let k1 = constants[6];
    let JK = constants[9];
    let JH = constants[10];
    let b1 = constants[14];
    let c17 = constants[17];
    let c25 = constants[25];
    let c26 = constants[26];
    let theta_h = state[0];
    let theta_k = state[1];
    let theta_h_dot = state[2];
    let theta_k_dot = state[3];
    let s = input[0];
    let s_rate = input[1];
    let v0 = s - theta_k;
    let v1 = k1 * v0;
    let ([sin_theta_k, sin_theta_h], [_, _]) = math::sin_cos_of_two([theta_k, theta_h]);
    let v2 = JH * (theta_h_dot * theta_h_dot) + JK * (theta_k_dot * theta_k_dot);
    let v3 = 0.5 * (v0 * v1 + v2) + c17 * sin_theta_k - M2 * -(c26 + c25 * sin_theta_h);
    let v4 = s_rate - theta_k_dot;
    let v5 = b1 * v4;
    let out = out.first_chunk_mut::<3>()?;
    out[0] = v3;
    out[1] = s_rate * (v1 + v5);
    out[2] = v4 * v5;
    Some(())
}

/// The guard and its rate: land in mode B2.
#[inline(always)]
fn guard_land_b2(given: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let constants = given.constants.first_chunk::<4>()?;
    let state = given.state.first_chunk::<4>()?;
    let L1 = constants[0];
    let L3 = constants[2];
    let L4 = constants[3];
    let theta_h = state[0];
    let theta_k = state[1];
    let theta_h_dot = state[2];
    let theta_k_dot = state[3];
    let v0 = theta_k - theta_h;
    let ([sin_theta_h, sin_v0], [cos_theta_h, cos_v0]) = math::sin_cos_of_two([theta_h, v0]);
    let v1 = L4 * cos_theta_h - L3 * sin_theta_h - L1 * sin_v0;
    let v2 = theta_h_dot * -(L4 * sin_theta_h + L3 * cos_theta_h);
    let out = out.first_chunk_mut::<2>()?;
    out[0] = v1;
    out[1] = v2 - L1 * (theta_k_dot - theta_h_dot) * cos_v0;
    Some(())
}

/// Bounds of the guard's move and bend: land in mode B2.
#[inline(always)]
fn bound_land_b2(given: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let constants = given.constants.first_chunk::<30>()?;
    let state = given.state.first_chunk::<2>()?;
    let extra = given.extra.first_chunk::<7>()?;
    let L1 = constants[0];
    let L3 = constants[2];
    let L4 = constants[3];
    let c27 = constants[27];
    let c28 = constants[28];
    let c29 = constants[29];
    let theta_h = state[0];
    let theta_k = state[1];
    let v0 = theta_k - theta_h;
    let ([sin_theta_h, sin_v0], [cos_theta_h, cos_v0]) = math::sin_cos_of_two([theta_h, v0]);
    let v1 = L1 * cos_v0;
    let v2 = extra[0] + extra[4];
    let v3 = sin_v0.abs();
    let v4 = 0.5 * v2;
    let v5 = c29 * v2 * functions::smaller(v4 + v3, 1.0);
    let v6 = 0.5 * extra[0];
    let v7 = functions::smaller(v6 + cos_theta_h.abs(), 1.0);
    let v8 = functions::smaller(v6 + sin_theta_h.abs(), 1.0);
    let v9 = (L4 * sin_theta_h + L3 * cos_theta_h - v1).abs() + v5;
    let v10 = extra[0] * (c27 * v7 + c28 * v8) + v9;
    let v11 = v1.abs() + v5;
    let v12 = L1 * sin_v0;
    let v13 = (L4 * cos_theta_h - L3 * sin_theta_h - v12).abs();
    let v14 = v2 * functions::smaller(v4 + cos_v0.abs(), 1.0);
    let v15 = c29 * v14;
    let v16 = extra[1] * (extra[0] * (c27 * v8 + c28 * v7) + (v13 + v15));
    let v17 = extra[1] * (v16 + 2.0 * (extra[5] * (v12.abs() + v15)));
    let v18 = c29 * extra[5] * (extra[5] * functions::smaller(v3 + v14, 1.0));
    let out = out.first_chunk_mut::<2>()?;
    out[0] = extra[4] * v11 + extra[0] * v10;
    out[1] = extra[6] * v11 + extra[2] * v10 + v17 + v18;
    Some(())
}

/// Where the Taylor series begins in mode B2.
fn series_start_b2(given: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let constants = given.constants.first_chunk::<31>()?;
    let state = given.state.first_chunk::<4>()?;
    let input = given.input;
    let L1 = constants[0];
    let L3 = constants[2];
    let L4 = constants[3];
    let k1 = constants[6];
    let string_angle = constants[12];
    let b1 = constants[14];
    let c17 = constants[17];
    let c20 = constants[20];
    let c30 = constants[30];
    let theta_h = state[0];
    let theta_k = state[1];
    let theta_h_dot = state[2];
    let theta_k_dot = state[3];
    let s = input[0];
    let s_rate = input[1];
    let v0 = theta_k - theta_h;
    let ([sin_theta_h, sin_theta_k], [cos_theta_h, cos_theta_k]) =
        math::sin_cos_of_two([theta_h, theta_k]);
    let v1 = k1 * (s - theta_k) + b1 * (s_rate - theta_k_dot) - c17 * cos_theta_k;
    let (sin_v0, cos_v0) = math::sin_cos(v0);
    let v2 = L4 * cos_theta_h - L3 * sin_theta_h - L1 * sin_v0;
    let out = out.first_chunk_mut::<12>()?;
    [out[0], out[1]] = [theta_h_dot, theta_k_dot];
    out[2] = -(c30 * cos_theta_h);
    [out[3], out[4]] = [c20 * v1, v2];
    out[5] = string_angle - theta_h;
    [out[6], out[7], out[8], out[9]] = [cos_theta_h, sin_theta_h, cos_theta_k, sin_theta_k];
    [out[10], out[11]] = [cos_v0, sin_v0];
    Some(())
}

/// One order of the Taylor series in mode B2.
fn series_step_b2(given: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let constants = given.constants.first_chunk::<31>()?;
    let state = given.state.first_chunk::<4>()?;
    let extra = given.extra.first_chunk::<14>()?;
    let input = given.input;
    let L1 = constants[0];
    let L3 = constants[2];
    let L4 = constants[3];
    let k1 = constants[6];
    let b1 = constants[14];
    let c17 = constants[17];
    let c20 = constants[20];
    let c30 = constants[30];
    let theta_h = state[0];
    let theta_k = state[1];
    let theta_h_dot = state[2];
    let theta_k_dot = state[3];
    let s = input[0];
    let s_rate = input[1];
    let v0 = theta_k - theta_h;
    let v1 = extra[8] * extra[1] + theta_h * extra[2];
    let v2 = -(extra[9] * extra[1] + theta_h * extra[3]);
    let v3 = -(extra[11] * extra[1] + theta_k * extra[5]);
    let v4 = k1 * (s - theta_k) + b1 * (s_rate - theta_k_dot) - c17 * v3;
    let v5 = extra[12] * extra[1] + v0 * extra[6];
    let v6 = extra[0] * theta_h;
    let v7 = extra[0] * theta_k;
    let v8 = extra[0] * v0;
    let out = out.first_chunk_mut::<18>()?;
    [out[0], out[1], out[2], out[3]] = [theta_h_dot, theta_k_dot, -(c30 * v2), c20 * v4];
    out[4] = L4 * v2 - L3 * v1 - L1 * v5;
    [out[5], out[6], out[7], out[8], out[9], out[10], out[11]] = [-theta_h, v6, v6, v7, v7, v8, v8];
    [out[12], out[13], out[14]] = [v2, v1, v3];
    out[15] = extra[10] * extra[1] + theta_k * extra[4];
    out[16] = -(extra[13] * extra[1] + v0 * extra[7]);
    out[17] = v5;
    Some(())
}

/// The numbers of the drawing.
fn drawing(given: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let constants = given.constants.first_chunk::<17>()?;
    let L1 = constants[0];
    let L2 = constants[1];
    let L3 = constants[2];
    let L4 = constants[3];
    let M2 = constants[5];
    let k1 = constants[6];
    let k2 = constants[7];
    let cK = constants[8];
    let g = constants[11];
    let string_angle = constants[12];
    let r = constants[16];
    let v0 = L3 - L1;
    let v1 = math::atan2(-L4, -v0);
    let v2 = 0.08 * L1;
    let v3 = 1.0 / functions::larger(v0.abs(), v2);
    let v4 = M2 * g * (L2 * v3);
    let v5 = 1.0 / k2;
    let v6 = (v5 + L1 * L1 / k1) * v3 * v4;
    let v7 = v6 + 2.0 * functions::larger(string_angle - v1, 0.0);
    let v8 = functions::smaller(v6 + math::sqrt(v6 * v7), 1.0);
    let v9 = 0.16 * L1;
    let ([sin_v1_v8, sin_string_angle], [_, cos_string_angle]) =
        math::sin_cos_of_two([v1 - v8, string_angle]);
    let v10 = functions::larger(0.088_000_000_000_000_01 * L1, 3.0 * (v5 * v4));
    let v11 = functions::larger(0.288_000_000_000_000_03 * L1, 0.012 + v9);
    let v12 = functions::smaller(L4 - 0.2 * L1 + L2 * sin_v1_v8, -(v11 + v10));
    let v13 = 0.24 * L1 + functions::larger(L3 + L2, L1);
    let v14 = L4 + 0.4 * L1 + L2 * sin_string_angle;
    let v15 = functions::larger(L4 + v9, f64::from_bits(0x3fd4_7ae1_47ae_147b) * L1);
    let v16 = -(0.104_000_000_000_000_01 * L1 + v10);
    let v17 = -(0.208_000_000_000_000_02 * L1 + v10);
    let v18 = 0.124_444_444_444_444_44 * L1;
    let v19 = -v18;
    let v20 = -(0.232_888_888_888_888_9 * L1 + v10);
    let v21 = -(0.088_888_888_888_888_89 * L1);
    let v22 = -(0.053_333_333_333_333_344 * L1);
    let v23 = 0.017_777_777_777_777_78 * L1;
    let v24 = -v23;
    let v25 = 0.053_333_333_333_333_316 * L1;
    let v26 = 0.088_888_888_888_888_88 * L1;
    let v27 = 0.064 * L1;
    let v28 = 0.055_999_999_999_999_994 * L1;
    let v29 = L3 - 0.152 * L1;
    let v30 = L4 + v27;
    let v31 = 0.016 * L1;
    let v32 = L3 - v31;
    let v33 = L4 + 0.144_000_000_000_000_02 * L1;
    let v34 = L4 - v31;
    let v35 = L3 + 0.008 * L1;
    let v36 = -r;
    let v37 = 1.08 * L1;
    let v38 = -v10;
    let v39 = functions::smaller(v28, 0.5 * r);
    let v40 = -v39;
    let v41 = 0.04 * L1;
    let v42 = 0.0144 * L1;
    let v43 = 0.013_909_331_898_562_582 * L1;
    let v44 = 0.003_726_994_249_476_298_5 * L1;
    let v45 = 0.012_470_765_814_495_917 * L1;
    let v46 = 0.007_199_999_999_999_999 * L1;
    let v47 = 0.010_182_337_649_086_284 * L1;
    let v48 = 0.010_182_337_649_086_283 * L1;
    let v49 = 0.007_200_000_000_000_001_5 * L1;
    let v50 = 0.012_470_765_814_495_915 * L1;
    let v51 = 8.817_456_953_860_942e-19 * L1;
    let v52 = -(0.003_726_994_249_476_297 * L1);
    let v53 = -(0.007_199_999_999_999_996 * L1);
    let v54 = -v48;
    let v55 = -v45;
    let v56 = -v43;
    let v57 = 0.003_726_994_249_476_302_4 * L1;
    let v58 = -v42;
    let v59 = 1.763_491_390_772_188_4e-18 * L1;
    let v60 = -(0.003_726_994_249_476_299_4 * L1);
    let v61 = -(0.012_470_765_814_495_919 * L1);
    let v62 = -(0.007_199_999_999_999_995_5 * L1);
    let v63 = -(0.010_182_337_649_086_29 * L1);
    let v64 = -(0.010_182_337_649_086_28 * L1);
    let v65 = -(0.007_200_000_000_000_006 * L1);
    let v66 = 0.012_470_765_814_495_912 * L1;
    let v67 = -v66;
    let v68 = -(2.645_237_086_158_282_6e-18 * L1);
    let v69 = 0.003_726_994_249_476_292 * L1;
    let v70 = -(0.013_909_331_898_562_584 * L1);
    let v71 = -v50;
    let v72 = 0.010_182_337_649_086_281 * L1;
    let v73 = -(0.010_182_337_649_086_286 * L1);
    let v74 = 0.013_909_331_898_562_58 * L1;
    let v75 = -(0.003_726_994_249_476_310_7 * L1);
    let v76 = functions::larger(v36, functions::smaller(cK, L1));
    let v77 = 0.032 * L1;
    let v78 = 0.052_000_000_000_000_005 * L1;
    let v79 = 0.027_712_812_921_102_038 * L1;
    let v80 = -(0.036_000_000_000_000_004 * L1 + v10);
    let v81 = 0.016_000_000_000_000_004 * L1 + v76;
    let v82 = -(0.021_090_373_558_749_816 * L1 + v10);
    let v83 = v76 - 0.008_282_209_443_280_661 * L1;
    let v84 = L1 - 32.352_380_637_815_095 * v76;
    let v85 = -(0.079_712_812_921_102_04 * L1 + v10);
    let v86 = -(0.082_909_626_441_250_19 * L1 + v10);
    let (sin_v1, cos_v1) = math::sin_cos(v1);
    let v87 = L1 * cos_v1;
    let v88 = 0.016 * v87;
    let v89 = L1 * sin_v1;
    let v90 = 0.016 * v89;
    let v91 = 0.004_141_104_721_640_332 * v89;
    let v92 = 0.015_454_813_220_625_094 * v87;
    let v93 = 0.004_141_104_721_640_332 * v87;
    let v94 = 0.015_454_813_220_625_094 * v89;
    let v95 = L1 - 0.007_999_999_999_999_998 * v89;
    let v96 = 0.013_856_406_460_551_019 * v87;
    let v97 = 0.007_999_999_999_999_998 * v87;
    let v98 = 0.013_856_406_460_551_019 * v89;
    let v99 = 0.011_313_708_498_984_762 * (v87 - 0.999_999_999_999_999_9 * v89);
    let v100 = 0.011_313_708_498_984_76 * (v87 + 1.000_000_000_000_000_2 * v89);
    let v101 = L1 + 0.008_000_000_000_000_002 * v87;
    let v102 = 0.013_856_406_460_551_017 * v89;
    let v103 = 0.008_000_000_000_000_002 * v89;
    let v104 = 0.013_856_406_460_551_017 * v87;
    let v105 = L1 - 0.004_141_104_721_640_330_4 * v87;
    let v106 = 0.004_141_104_721_640_330_4 * v89;
    let v107 = L1 - 0.004_141_104_721_640_336_5 * v89 - 0.015_454_813_220_625_092 * v87;
    let v108 = 0.004_141_104_721_640_336_5 * v87 - 0.015_454_813_220_625_092 * v89;
    let v109 = L1 + 0.007_999_999_999_999_995 * v89 - 0.013_856_406_460_551_02 * v87;
    let v110 = 0.007_999_999_999_999_995 * v87 + 0.013_856_406_460_551_02 * v89;
    let v111 = L1 + 0.011_313_708_498_984_755 * v89 - 0.011_313_708_498_984_767 * v87;
    let v112 = 0.011_313_708_498_984_755 * v87 + 0.011_313_708_498_984_767 * v89;
    let v113 = 0.008_000_000_000_000_007 * (v87 - 1.732_050_807_568_875_2 * v89);
    let v114 = 0.013_856_406_460_551_014 * (v87 + 0.577_350_269_189_626_5 * v89);
    let v115 = 0.015_454_813_220_625_096 * v89 + (L1 + 0.004_141_104_721_640_325 * v87);
    let v116 = 0.004_141_104_721_640_325 * v89 - 0.015_454_813_220_625_096 * v87;
    let v117 = 0.011_313_708_498_984_764 * v89 + (L1 + 0.011_313_708_498_984_758 * v87);
    let v118 = 0.011_313_708_498_984_758 * v89 - 0.011_313_708_498_984_764 * v87;
    let v119 = 0.015_454_813_220_625_089 * v87 + (L1 + 0.004_141_104_721_640_345 * v89);
    let v120 = 0.015_454_813_220_625_089 * v89 - 0.004_141_104_721_640_345 * v87;
    let v121 = 0.048 * L1;
    let v122 = 0.02 * L1;
    let v123 = -v122;
    let v124 = -(0.024 * L1);
    let v125 = L1 * sin_string_angle;
    let v126 = L1 * cos_string_angle;
    let v127 = 0.027_999_999_999_999_997 * v126;
    let v128 = L2 - v127;
    let v129 = 0.16 * v125;
    let v130 = 0.027_999_999_999_999_997 * v125;
    let v131 = 0.16 * v126;
    let v132 = L2 + v127;
    let v133 = f64::from_bits(0x3fd4_7ae1_47ae_147b) * v125;
    let v134 = f64::from_bits(0x3fd4_7ae1_47ae_147b) * v126;
    let v135 = L2 + 0.128 * v125;
    let v136 = 0.04 * v126;
    let v137 = 0.04 * v125;
    let v138 = 0.128 * v126;
    let v139 = L2 + 0.208_000_000_000_000_02 * v125;
    let v140 = 0.072_000_000_000_000_01 * v126;
    let v141 = 0.072_000_000_000_000_01 * v125;
    let v142 = 0.208_000_000_000_000_02 * v126;
    let v143 = L2 + 0.288_000_000_000_000_03 * v125;
    let v144 = 0.08 * v126;
    let v145 = 0.08 * v125;
    let v146 = 0.288_000_000_000_000_03 * v126;
    let v147 = L2 + 0.351_883_232_000_000_05 * v125;
    let v148 = 0.061_997_768_000_000_01 * v126;
    let v149 = 0.061_997_768_000_000_01 * v125;
    let v150 = 0.351_883_232_000_000_05 * v126;
    let v151 = L2 + 0.371_116_152_000_000_03 * v125;
    let v152 = 0.053_505_664 * v126;
    let v153 = 0.053_505_664 * v125;
    let v154 = 0.371_116_152_000_000_03 * v126;
    let v155 = L2 + 0.386_559_504 * v125;
    let v156 = 0.039_239_48 * v126;
    let v157 = 0.039_239_48 * v125;
    let v158 = 0.386_559_504 * v126;
    let v159 = L2 + f64::from_bits(0x3fd9_6105_75d8_15ce) * v125;
    let v160 = 0.020_738_752 * v126;
    let v161 = 0.020_738_752 * v125;
    let v162 = f64::from_bits(0x3fd9_6105_75d8_15ce) * v126;
    let v163 = 0.012 * L1;
    let v164 = 0.011_591_109_915_468_82 * L1;
    let v165 = 0.003_105_828_541_230_249 * L1;
    let v166 = 0.010_392_304_845_413_265 * L1;
    let v167 = 0.005_999_999_999_999_999 * L1;
    let v168 = 0.008_485_281_374_238_571 * L1;
    let v169 = 0.008_485_281_374_238_57 * L1;
    let v170 = L2 + 0.006_000_000_000_000_002 * L1;
    let v171 = 0.010_392_304_845_413_263 * L1;
    let v172 = L2 - 0.003_105_828_541_230_247_4 * L1;
    let v173 = L2 - v166;
    let v174 = L2 - v164;
    let v175 = 0.006_000_000_000_000_005 * L1;
    let v176 = 0.010_392_304_845_413_26 * L1;
    let v177 = 0.026_000_000_000_000_002 * L1;
    let v178 = 0.166_400_000_000_000_02 * L1;
    let v179 = -(f64::from_bits(0x3fe6_6666_6666_6666) * r);
    let out = out.first_chunk_mut::<432>()?;
    out[0] = -(v9 + functions::larger(r, v2));
    [out[1], out[2]] = [v12, v13];
    out[3] = v2 + functions::larger(v14, v15);
    [out[4], out[5], out[6], out[7], out[8], out[9], out[10]] = [0.0, v16, -v2, v17, v2, v17, -v9];
    [out[11], out[12], out[13]] = [v17, v19, v17];
    out[14] = -(0.149_333_333_333_333_35 * L1);
    [out[15], out[16], out[17], out[18], out[19]] = [v20, v19, v17, v21, v17];
    out[20] = -(0.113_777_777_777_777_78 * L1);
    [out[21], out[22], out[23], out[24], out[25]] = [v20, v21, v17, v22, v17];
    out[26] = -(0.078_222_222_222_222_23 * L1);
    [out[27], out[28], out[29], out[30], out[31]] = [v20, v22, v17, v24, v17];
    out[32] = -(0.042_666_666_666_666_67 * L1);
    [out[33], out[34], out[35], out[36], out[37]] = [v20, v24, v17, v23, v17];
    out[38] = -(0.007_111_111_111_111_124 * L1);
    [out[39], out[40], out[41], out[42], out[43]] = [v20, v23, v17, v25, v17];
    out[44] = 0.028_444_444_444_444_44 * L1;
    [out[45], out[46], out[47], out[48], out[49], out[50]] = [v20, v25, v17, v26, v17, v27];
    [out[51], out[52], out[53], out[54], out[55]] = [v20, v26, v17, v18, v17];
    out[56] = 0.099_555_555_555_555_54 * L1;
    [out[57], out[58], out[59], out[60], out[61]] = [v20, v18, v17, v9, v17];
    out[62] = 0.135_111_111_111_111_15 * L1;
    [out[63], out[64], out[65], out[66], out[67], out[68]] = [v20, v9, v17, 0.0, v16, 0.0];
    [out[69], out[70], out[71], out[72], out[73], out[74]] = [v28, v29, v30, v32, v30, v32];
    [out[75], out[76], out[77]] = [v33, v29, v33];
    out[78] = L3 - 0.096 * L1;
    out[79] = v30;
    out[80] = L3 - 0.027_999_999_999_999_997 * L1;
    [out[81], out[82], out[83], out[84], out[85], out[86]] = [v34, v35, v34, v35, v30, v36];
    [out[87], out[88], out[89], out[90], out[91], out[92]] = [v16, v37, v16, v37, v38, v36];
    [out[93], out[94], out[95], out[96], out[97], out[98]] = [v38, v40, v38, v39, v38, v39];
    [out[99], out[100], out[101], out[102], out[103], out[104]] = [v41, v40, v41, v42, 0.0, v43];
    [out[105], out[106], out[107], out[108], out[109], out[110]] = [v44, v45, v46, v47, v48, v49];
    [out[111], out[112], out[113], out[114], out[115], out[116]] = [v50, v44, v43, v51, v42, v52];
    [out[117], out[118], out[119], out[120], out[121], out[122]] = [v43, v53, v45, v54, v47, v55];
    [out[123], out[124], out[125], out[126], out[127], out[128]] = [v46, v56, v57, v58, v59, v56];
    [out[129], out[130], out[131], out[132], out[133], out[134]] = [v60, v61, v62, v63, v64, v65];
    [out[135], out[136], out[137], out[138], out[139], out[140]] = [v67, v52, v56, v68, v58, v69];
    [out[141], out[142], out[143], out[144], out[145], out[146]] = [v70, v49, v71, v72, v73, v66];
    [out[147], out[148], out[149], out[150], out[151]] = [v65, v74, v75, v77 + v76, -(v78 + v10)];
    out[152] = 0.030_909_626_441_250_188 * L1 + v76;
    out[153] = -(0.043_717_790_556_719_344 * L1 + v10);
    [out[154], out[155]] = [v79 + v76, v80];
    out[156] = 0.022_627_416_997_969_524 * L1 + v76;
    out[157] = -(0.029_372_583_002_030_484 * L1 + v10);
    out[158] = v81;
    out[159] = -(0.024_287_187_078_897_97 * L1 + v10);
    out[160] = 0.008_282_209_443_280_664 * L1 + v76;
    out[161] = v82;
    out[162] = 1.959_434_878_635_765e-18 * L1 + v76;
    out[163] = -(0.020_000_000_000_000_004 * L1 + v10);
    [out[164], out[165]] = [v83, v82];
    out[166] = v76 - 0.015_999_999_999_999_993 * L1;
    out[167] = -(0.024_287_187_078_897_966 * L1 + v10);
    out[168] = v76 - 0.022_627_416_997_969_52 * L1;
    out[169] = -(0.029_372_583_002_030_48 * L1 + v10);
    [out[170], out[171]] = [v76 - v79, v80];
    out[172] = -(0.030_909_626_441_250_185 * v84);
    out[173] = -(0.043_717_790_556_719_33 * L1 + v10);
    out[174] = v76 - v77;
    out[175] = -(0.052 * L1 + v10);
    out[176] = -(0.030_909_626_441_250_188 * v84);
    out[177] = -(0.060_282_209_443_280_67 * L1 + v10);
    out[178] = v76 - 0.027_712_812_921_102_04 * L1;
    out[179] = -(0.067_999_999_999_999_99 * L1 + v10);
    out[180] = v76 - 0.022_627_416_997_969_534 * L1;
    out[181] = -(0.074_627_416_997_969_51 * L1 + v10);
    out[182] = v76 - 0.016_000_000_000_000_014 * L1;
    [out[183], out[184], out[185]] = [v85, v83, v86];
    out[186] = v76 - 5.878_304_635_907_295_5e-18 * L1;
    out[187] = -(0.084 * L1 + v10);
    out[188] = 0.008_282_209_443_280_65 * L1 + v76;
    [out[189], out[190], out[191]] = [v86, v81, v85];
    out[192] = 0.022_627_416_997_969_517 * L1 + v76;
    out[193] = -(0.074_627_416_997_969_53 * L1 + v10);
    out[194] = 0.027_712_812_921_102_028 * L1 + v76;
    out[195] = -(0.068_000_000_000_000_02 * L1 + v10);
    out[196] = 0.030_909_626_441_250_178 * L1 + v76;
    out[197] = -(0.060_282_209_443_280_69 * L1 + v10);
    [out[198], out[199]] = [L1 + v88, v90];
    out[200] = v92 + (L1 - v91);
    [out[201], out[202], out[203], out[204]] = [v93 + v94, v96 + v95, v97 + v98, L1 + v99];
    [out[205], out[206], out[207]] = [v100, v101 - v102, v103 + v104];
    out[208] = L1 + v93 - v94;
    out[209] = v91 + v92;
    out[210] = 9.797_174_393_178_825e-19 * v87 + (L1 - v90);
    out[211] = v88 + 9.797_174_393_178_825e-19 * v89;
    [out[212], out[213]] = [v105 - v94, v92 - v106];
    out[214] = L1 - v98 - 0.007_999_999_999_999_997 * v87;
    out[215] = v96 - 0.007_999_999_999_999_997 * v89;
    [out[216], out[217], out[218], out[219]] = [L1 - v100, v99, v95 - v96, v97 - v98];
    [out[220], out[221]] = [v107, v108];
    out[222] = L1 - v88 - 1.959_434_878_635_765e-18 * v89;
    out[223] = 1.959_434_878_635_765e-18 * v87 - v90;
    out[224] = 0.004_141_104_721_640_333 * v89 + (L1 - v92);
    out[225] = -(v94 + 0.004_141_104_721_640_333 * v87);
    [out[226], out[227], out[228], out[229], out[230]] = [v109, -v110, v111, -v112, L1 - v113];
    [out[231], out[232]] = [-v114, v94 + v105];
    out[233] = -(v92 + v106);
    out[234] = L1 + v90 - 2.939_152_317_953_647_7e-18 * v87;
    out[235] = -(v88 + 2.939_152_317_953_647_7e-18 * v89);
    [out[236], out[237], out[238], out[239]] = [v115, v116, v102 + v101, v103 - v104];
    [out[240], out[241], out[242], out[243], out[244]] = [v117, v118, L1 + v114, -v113, v119];
    [out[245], out[246], out[247], out[248], out[249]] = [v120, v36, v121, v122, v121];
    [out[250], out[251], out[252], out[253], out[254], out[255]] = [v122, v2, v36, v2, v123, 0.0];
    [out[256], out[257], out[258], out[259], out[260]] = [v122, 0.0, v122, v121, v123];
    [out[261], out[262], out[263], out[264], out[265], out[266]] = [v121, v124, v31, L2, v31, L2];
    [out[267], out[268], out[269], out[270]] = [v121, v124, v121, v128 - v129];
    [out[271], out[272]] = [v130 - v131, v132 - v129];
    out[273] = -(v130 + v131);
    [out[274], out[275], out[276], out[277]] = [v133 + v132, v134 - v130, v133 + v128, v130 + v134];
    [out[278], out[279], out[280], out[281]] = [v136 + v135, v138 - v137, v140 + v139, v142 - v141];
    [out[282], out[283], out[284], out[285]] = [v144 + v143, v146 - v145, v148 + v147, v150 - v149];
    [out[286], out[287], out[288], out[289]] = [v152 + v151, v154 - v153, v156 + v155, v158 - v157];
    [out[290], out[291]] = [v160 + v159, v162 - v161];
    out[292] = L2 + 0.4 * v125;
    [out[293], out[294], out[295], out[296]] = [0.4 * v126, v159 - v160, v161 + v162, v155 - v156];
    [out[297], out[298], out[299], out[300]] = [v157 + v158, v151 - v152, v153 + v154, v147 - v148];
    [out[301], out[302], out[303], out[304]] = [v149 + v150, v143 - v144, v145 + v146, v139 - v140];
    [out[305], out[306], out[307], out[308]] = [v141 + v142, v135 - v136, v137 + v138, v42];
    [out[309], out[310], out[311], out[312], out[313], out[314]] = [0.0, v43, v44, v45, v46, v47];
    [out[315], out[316], out[317], out[318], out[319], out[320]] = [v48, v49, v50, v44, v43, v51];
    [out[321], out[322], out[323], out[324], out[325], out[326]] = [v42, v52, v43, v53, v45, v54];
    [out[327], out[328], out[329], out[330], out[331], out[332]] = [v47, v55, v46, v56, v57, v58];
    [out[333], out[334], out[335], out[336], out[337], out[338]] = [v59, v56, v60, v61, v62, v63];
    [out[339], out[340], out[341], out[342], out[343], out[344]] = [v64, v65, v67, v52, v56, v68];
    [out[345], out[346], out[347], out[348], out[349], out[350]] = [v58, v69, v70, v49, v71, v72];
    [out[351], out[352], out[353], out[354], out[355]] = [v73, v66, v65, v74, v75];
    [out[356], out[357], out[358], out[359]] = [L2 + v163, 0.0, L2 + v164, v165];
    [out[360], out[361], out[362], out[363], out[364]] = [L2 + v166, v167, L2 + v168, v169, v170];
    [out[365], out[366], out[367]] = [v171, L2 + v165, v164];
    out[368] = L2 + 7.347_880_794_884_119e-19 * L1;
    [out[369], out[370], out[371]] = [v163, v172, v164];
    out[372] = L2 - 0.005_999_999_999_999_997_5 * L1;
    [out[373], out[374], out[375], out[376], out[377]] = [v166, L2 - v169, v168, v173, v167];
    out[378] = v174;
    out[379] = 0.003_105_828_541_230_252 * L1;
    out[380] = L2 - v163;
    out[381] = 1.469_576_158_976_823_9e-18 * L1;
    out[382] = v174;
    out[383] = -(0.003_105_828_541_230_249_6 * L1);
    out[384] = v173;
    out[385] = -(0.005_999_999_999_999_997 * L1);
    out[386] = L2 - 0.008_485_281_374_238_575 * L1;
    out[387] = -(0.008_485_281_374_238_566 * L1);
    [out[388], out[389], out[390], out[391]] = [L2 - v175, -v176, v172, -v164];
    out[392] = L2 - 2.204_364_238_465_235_5e-18 * L1;
    out[393] = -v163;
    out[394] = L2 + 0.003_105_828_541_230_243_5 * L1;
    out[395] = -(0.011_591_109_915_468_821 * L1);
    [out[396], out[397]] = [v170, -v171];
    out[398] = L2 + 0.008_485_281_374_238_568 * L1;
    out[399] = -(0.008_485_281_374_238_573 * L1);
    [out[400], out[401]] = [L2 + v176, -v175];
    out[402] = L2 + 0.011_591_109_915_468_818 * L1;
    out[403] = -(0.003_105_828_541_230_259 * L1);
    out[404] = L3 + L2 * (cos_string_angle - 0.6);
    [out[405], out[406], out[407], out[408], out[409]] = [v14, v13, v14, -v177, 0.0];
    [out[410], out[411]] = [v177, 0.0];
    out[412] = 0.046_800_000_000_000_01 * L1;
    out[413] = 0.020_800_000_000_000_003 * L1;
    [out[414], out[415], out[416], out[417]] = [v78, v78, 0.0364 * L1, v178];
    out[418] = -(0.057_200_000_000_000_01 * L1);
    [out[419], out[420]] = [v178, -v78];
    out[421] = 0.041_600_000_000_000_005 * L1;
    out[422] = -(0.043_680_000_000_000_004 * L1);
    [out[423], out[424], out[425], out[426], out[427]] = [0.01248 * L1, v179, v38, v179, v121];
    [out[428], out[429], out[430], out[431]] = [L1, v38, L1, -v31];
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
fn rest(given: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let constants = given.constants.first_chunk::<4>()?;
    let input = given.input;
    let L1 = constants[0];
    let L3 = constants[2];
    let L4 = constants[3];
    let s = input[0];
    let (sin_s, cos_s) = math::sin_cos(s);
    let out = out.first_chunk_mut::<4>()?;
    out[0] = math::atan2(L1 * sin_s - L4, L1 * cos_s - L3);
    [out[1], out[2], out[3]] = [s, 0.0, 0.0];
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
    let k2 = constants[7];
    let cK = constants[8];
    let JK = constants[9];
    let JH = constants[10];
    let g = constants[11];
    let b1 = constants[14];
    let r = constants[16];
    let v0 = g * L2;
    let v1 = M2 * v0;
    let v2 = 1.0 / JH;
    let v3 = 1.0 / JK;
    let out = out.first_chunk_mut::<15>()?;
    out[0] = cK * (g * M1);
    [out[1], out[2], out[3], out[4], out[5], out[6]] = [v1, v2, v3, k2 * v2, k2 * v3, 0.08 * L1];
    out[7] = 0.048 * L1 - r;
    [out[8], out[9], out[10], out[11], out[12]] = [v0, g * L4, L4.abs(), L3.abs(), L1.abs()];
    [out[13], out[14]] = [v1 * v2, -(b1 * v3)];
    Some(())
}
