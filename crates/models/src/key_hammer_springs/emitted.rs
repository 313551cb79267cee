//! Emitted from `the description of key-hammer-springs` by `letoff model emit`; not to be changed by hand.
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
    Arguments, BodyTable, DamperTable, DrawingTable, Freedom, FunctionId, Functions, GuardTable,
    Material, ModeTable, ModelTable, NamedQuantity, OutlineTable, ParameterTable, PartTable,
    PresetTable, RestTable, SeriesTable, SpringTable, WayTable,
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
    constants: 30,
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
        NamedQuantity { name: "hammer.x", unit: "m" },
        NamedQuantity { name: "hammer.y", unit: "m" },
        NamedQuantity { name: "hammer.angle", unit: "rad" },
        NamedQuantity { name: "slider.x", unit: "m" },
        NamedQuantity { name: "slider.y", unit: "m" },
        NamedQuantity { name: "slider.angle", unit: "rad" },
        NamedQuantity { name: "manipulandum.x", unit: "m" },
        NamedQuantity { name: "manipulandum.y", unit: "m" },
        NamedQuantity { name: "manipulandum.angle", unit: "rad" },
    ],
    rest: RestTable { mode: 0, instead: &[], state: 31, is_improved: true },
    damper: Some(DamperTable { lift: 0.005, fall: 0.0046, softest_tone: 0.15 }),
    drawing: DrawingTable {
        numbers: 26,
        count: 84,
        bodies: &[
            BodyTable {
                name: "key",
                output: Some(5),
                outlines: &[OutlineTable {
                    material: Material::Wood,
                    is_closed: true,
                    points: (4, 4),
                    modes: &[],
                }],
            },
            BodyTable {
                name: "hammer",
                output: Some(8),
                outlines: &[OutlineTable {
                    material: Material::Wood,
                    is_closed: true,
                    points: (12, 4),
                    modes: &[],
                }],
            },
            BodyTable {
                name: "slider",
                output: Some(11),
                outlines: &[OutlineTable {
                    material: Material::Metal,
                    is_closed: true,
                    points: (20, 24),
                    modes: &[],
                }],
            },
            BodyTable {
                name: "manipulandum",
                output: Some(14),
                outlines: &[OutlineTable {
                    material: Material::Metal,
                    is_closed: true,
                    points: (68, 4),
                    modes: &[],
                }],
            },
        ],
        springs: &[
            SpringTable { name: "k1", from: (0, 76), to: (3, 78), modes: &[] },
            SpringTable { name: "k2", from: (0, 80), to: (2, 82), modes: &[] },
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
}

/// The derivative of the state in mode B1.
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
    let constants = given.constants.first_chunk::<16>()?;
    let state = given.state.first_chunk::<4>()?;
    let input = given.input;
    let L1 = constants[0];
    let L3 = constants[2];
    let L4 = constants[3];
    let k1 = constants[6];
    let k2 = constants[7];
    let b1 = constants[14];
    let c2 = constants[15];
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
    let v8 = v2 + sin_theta_k * v7;
    let v9 = v0 - cos_theta_k * v7;
    let v10 = theta_k_dot * (sin_theta_h * v9 - cos_theta_h * -v8);
    let v11 = functions::larger(1.0 + c2 * (1.0 / v4 * (v10 - theta_h_dot * v6)), 0.0);
    let sin_theta_k_theta_h = math::sin_cos(theta_k - theta_h).0;
    let v12 = L4 * cos_theta_h - L3 * sin_theta_h - L1 * sin_theta_k_theta_h;
    let out = out.first_chunk_mut::<17>()?;
    out[0] = k2 * v7 * v11;
    out[1] = k1 * (s - theta_k) + b1 * (s_rate - theta_k_dot);
    [out[2], out[3], out[4], out[5], out[6], out[7], out[8]] = [v12, v7, v6, 0.0, 0.0, theta_k, L3];
    [out[9], out[10], out[11], out[12], out[13], out[14]] = [L4, theta_h, v8, v9, theta_k, 0.0];
    [out[15], out[16]] = [0.0, s];
    Some(())
}

/// Energy, supplied and dissipated power in mode B1.
fn balance_b1(given: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let constants = given.constants.first_chunk::<25>()?;
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
    let c23 = constants[23];
    let c24 = constants[24];
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
    let v11 = c17 * sin_theta_k - M2 * -(c24 + c23 * sin_theta_h);
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
fn bound_release_b1(given: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let constants = given.constants.first_chunk::<28>()?;
    let state = given.state.first_chunk::<2>()?;
    let extra = given.extra.first_chunk::<7>()?;
    let L1 = constants[0];
    let L3 = constants[2];
    let L4 = constants[3];
    let c25 = constants[25];
    let c26 = constants[26];
    let c27 = constants[27];
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
    let v9 = c27 * v8 + (v1.abs() + extra[0] * (c25 * v3 + c26 * v4));
    let v10 = cos_v0.abs();
    let v11 = c27 * functions::smaller(v10 + v8, 1.0);
    let v12 = L1 * sin_v0;
    let v13 = (L4 * cos_theta_h - L3 * sin_theta_h - v12).abs();
    let v14 = v5 * functions::smaller(v7 + v10, 1.0);
    let v15 = c27 * v14;
    let v16 = extra[1] * (extra[0] * (c25 * v4 + c26 * v3) + (v13 + v15));
    let v17 = c27 * (extra[5] * functions::smaller(v6 + v14, 1.0));
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
fn derivative_b2(given: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let constants = given.constants.first_chunk::<29>()?;
    let state = given.state.first_chunk::<4>()?;
    let input = given.input;
    let k1 = constants[6];
    let b1 = constants[14];
    let c17 = constants[17];
    let c20 = constants[20];
    let c28 = constants[28];
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
    out[2] = -(c28 * cos_theta_h);
    out[3] = c20 * v0;
    Some(())
}

/// The derivative of a part in mode B2.
fn part_0_b2(given: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let constants = given.constants.first_chunk::<29>()?;
    let state = given.state.first_chunk::<3>()?;
    let c28 = constants[28];
    let theta_h = state[0];
    let theta_h_dot = state[2];
    let cos_theta_h = math::sin_cos(theta_h).1;
    let out = out.first_chunk_mut::<4>()?;
    [out[0], out[1]] = [theta_h_dot, 0.0];
    out[2] = -(c28 * cos_theta_h);
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
    let constants = given.constants.first_chunk::<30>()?;
    let state = given.state.first_chunk::<2>()?;
    let k1 = constants[6];
    let c17 = constants[17];
    let c20 = constants[20];
    let c28 = constants[28];
    let c29 = constants[29];
    let theta_h = state[0];
    let theta_k = state[1];
    let ([sin_theta_h, sin_theta_k], [_, _]) = math::sin_cos_of_two([theta_h, theta_k]);
    let out = out.first_chunk_mut::<16>()?;
    [out[0], out[1], out[2], out[3], out[4], out[5], out[6]] = [0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0];
    out[7] = 1.0;
    out[8] = c28 * sin_theta_h;
    [out[9], out[10], out[11], out[12]] = [0.0, 0.0, 0.0, 0.0];
    out[13] = c20 * (c17 * sin_theta_k - k1);
    [out[14], out[15]] = [0.0, c29];
    Some(())
}

/// The outputs in mode B2.
fn outputs_b2(given: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let constants = given.constants.first_chunk::<15>()?;
    let state = given.state.first_chunk::<4>()?;
    let input = given.input;
    let L1 = constants[0];
    let L3 = constants[2];
    let L4 = constants[3];
    let k1 = constants[6];
    let b1 = constants[14];
    let theta_h = state[0];
    let theta_k = state[1];
    let theta_k_dot = state[3];
    let s = input[0];
    let s_rate = input[1];
    let ([sin_theta_h, sin_theta_k_theta_h], [cos_theta_h, _]) =
        math::sin_cos_of_two([theta_h, theta_k - theta_h]);
    let v0 = L4 * cos_theta_h - L3 * sin_theta_h - L1 * sin_theta_k_theta_h;
    let (sin_theta_k, cos_theta_k) = math::sin_cos(theta_k);
    let v1 = L1 * cos_theta_k;
    let v2 = L1 * sin_theta_k;
    let v3 = cos_theta_h * (L4 - v2) - sin_theta_h * (L3 - v1);
    let v4 = sin_theta_h * sin_theta_k + cos_theta_h * cos_theta_k;
    let v5 = v3 * (1.0 / -v4);
    let out = out.first_chunk_mut::<17>()?;
    out[0] = 0.0;
    out[1] = k1 * (s - theta_k) + b1 * (s_rate - theta_k_dot);
    [out[2], out[3], out[4], out[5], out[6], out[7]] = [v0, 0.0, 0.0, 0.0, 0.0, theta_k];
    [out[8], out[9], out[10]] = [L3, L4, theta_h];
    out[11] = v1 + sin_theta_k * v5;
    out[12] = v2 - cos_theta_k * v5;
    [out[13], out[14], out[15], out[16]] = [theta_k, 0.0, 0.0, s];
    Some(())
}

/// Energy, supplied and dissipated power in mode B2.
fn balance_b2(given: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let constants = given.constants.first_chunk::<25>()?;
    let state = given.state.first_chunk::<4>()?;
    let input = given.input;
    let M2 = constants[5];
    let k1 = constants[6];
    let JK = constants[9];
    let JH = constants[10];
    let b1 = constants[14];
    let c17 = constants[17];
    let c23 = constants[23];
    let c24 = constants[24];
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
    let v3 = 0.5 * (v0 * v1 + v2) + c17 * sin_theta_k - M2 * -(c24 + c23 * sin_theta_h);
    let v4 = s_rate - theta_k_dot;
    let v5 = b1 * v4;
    let out = out.first_chunk_mut::<3>()?;
    out[0] = v3;
    out[1] = s_rate * (v1 + v5);
    out[2] = v4 * v5;
    Some(())
}

/// The guard and its rate: land in mode B2.
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
fn bound_land_b2(given: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let constants = given.constants.first_chunk::<28>()?;
    let state = given.state.first_chunk::<2>()?;
    let extra = given.extra.first_chunk::<7>()?;
    let L1 = constants[0];
    let L3 = constants[2];
    let L4 = constants[3];
    let c25 = constants[25];
    let c26 = constants[26];
    let c27 = constants[27];
    let theta_h = state[0];
    let theta_k = state[1];
    let v0 = theta_k - theta_h;
    let ([sin_theta_h, sin_v0], [cos_theta_h, cos_v0]) = math::sin_cos_of_two([theta_h, v0]);
    let v1 = L1 * cos_v0;
    let v2 = extra[0] + extra[4];
    let v3 = sin_v0.abs();
    let v4 = 0.5 * v2;
    let v5 = c27 * v2 * functions::smaller(v4 + v3, 1.0);
    let v6 = 0.5 * extra[0];
    let v7 = functions::smaller(v6 + cos_theta_h.abs(), 1.0);
    let v8 = functions::smaller(v6 + sin_theta_h.abs(), 1.0);
    let v9 = (L4 * sin_theta_h + L3 * cos_theta_h - v1).abs() + v5;
    let v10 = extra[0] * (c25 * v7 + c26 * v8) + v9;
    let v11 = v1.abs() + v5;
    let v12 = L1 * sin_v0;
    let v13 = (L4 * cos_theta_h - L3 * sin_theta_h - v12).abs();
    let v14 = v2 * functions::smaller(v4 + cos_v0.abs(), 1.0);
    let v15 = c27 * v14;
    let v16 = extra[1] * (extra[0] * (c25 * v8 + c26 * v7) + (v13 + v15));
    let v17 = extra[1] * (v16 + 2.0 * (extra[5] * (v12.abs() + v15)));
    let v18 = c27 * extra[5] * (extra[5] * functions::smaller(v3 + v14, 1.0));
    let out = out.first_chunk_mut::<2>()?;
    out[0] = extra[4] * v11 + extra[0] * v10;
    out[1] = extra[6] * v11 + extra[2] * v10 + v17 + v18;
    Some(())
}

/// Where the Taylor series begins in mode B2.
fn series_start_b2(given: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let constants = given.constants.first_chunk::<29>()?;
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
    let c28 = constants[28];
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
    out[2] = -(c28 * cos_theta_h);
    [out[3], out[4]] = [c20 * v1, v2];
    out[5] = string_angle - theta_h;
    [out[6], out[7], out[8], out[9]] = [cos_theta_h, sin_theta_h, cos_theta_k, sin_theta_k];
    [out[10], out[11]] = [cos_v0, sin_v0];
    Some(())
}

/// One order of the Taylor series in mode B2.
fn series_step_b2(given: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let constants = given.constants.first_chunk::<29>()?;
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
    let c28 = constants[28];
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
    [out[0], out[1], out[2], out[3]] = [theta_h_dot, theta_k_dot, -(c28 * v2), c20 * v4];
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
    let string_angle = constants[12];
    let r = constants[16];
    let v0 = 0.2 * L1;
    let v1 = 0.6 * L1;
    let v2 = f64::from_bits(0x3fd3_3333_3333_3333) * L1 + (L3 + L2);
    let sin_string_angle = math::sin_cos(string_angle).0;
    let v3 = -r;
    let v4 = -v0;
    let v5 = 1.08 * L1;
    let v6 = -(0.09 * L1);
    let v7 = -(0.03 * L1);
    let v8 = 0.016 * L1;
    let v9 = 0.05 * L1;
    let v10 = 0.015_454_813_220_625_094 * L1;
    let v11 = 0.004_141_104_721_640_332 * L1;
    let v12 = 0.013_856_406_460_551_019 * L1;
    let v13 = 0.007_999_999_999_999_998 * L1;
    let v14 = 0.011_313_708_498_984_762 * L1;
    let v15 = 0.011_313_708_498_984_76 * L1;
    let v16 = 0.008_000_000_000_000_002 * L1;
    let v17 = 0.013_856_406_460_551_017 * L1;
    let v18 = -(0.004_141_104_721_640_330_4 * L1);
    let v19 = -v8;
    let v20 = -v10;
    let v21 = -(0.008_000_000_000_000_007 * L1);
    let v22 = 0.013_856_406_460_551_014 * L1;
    let v23 = 0.02 * L1;
    let v24 = 0.08 * L1;
    let v25 = -(f64::from_bits(0x3fe6_6666_6666_6666) * r);
    let v26 = -v24;
    let out = out.first_chunk_mut::<84>()?;
    [out[0], out[1], out[2]] = [-(r + v0), -v1, v2];
    out[3] = L4 + v1 + L2 * sin_string_angle.abs();
    [out[4], out[5], out[6], out[7], out[8], out[9], out[10]] = [v3, v4, v5, v4, v5, v6, v3];
    [out[11], out[12], out[13], out[14], out[15], out[16], out[17]] = [v6, v7, v8, L2, v8, L2, v9];
    [out[18], out[19], out[20], out[21], out[22], out[23]] = [v7, v9, v8, 0.0, v10, v11];
    [out[24], out[25], out[26], out[27], out[28], out[29]] = [v12, v13, v14, v15, v16, v17];
    [out[30], out[31]] = [v11, v10];
    out[32] = 9.797_174_393_178_825e-19 * L1;
    [out[33], out[34], out[35]] = [v8, v18, v10];
    out[36] = -(0.007_999_999_999_999_997 * L1);
    [out[37], out[38], out[39], out[40], out[41]] = [v12, -v15, v14, -v12, v13];
    out[42] = -(0.015_454_813_220_625_092 * L1);
    out[43] = 0.004_141_104_721_640_336_5 * L1;
    out[44] = v19;
    out[45] = 1.959_434_878_635_765e-18 * L1;
    out[46] = v20;
    out[47] = -(0.004_141_104_721_640_333 * L1);
    out[48] = -(0.013_856_406_460_551_02 * L1);
    out[49] = -(0.007_999_999_999_999_995 * L1);
    out[50] = -(0.011_313_708_498_984_767 * L1);
    out[51] = -(0.011_313_708_498_984_755 * L1);
    [out[52], out[53], out[54], out[55]] = [v21, -v22, v18, v20];
    out[56] = -(2.939_152_317_953_647_7e-18 * L1);
    out[57] = v19;
    out[58] = 0.004_141_104_721_640_325 * L1;
    out[59] = -(0.015_454_813_220_625_096 * L1);
    [out[60], out[61]] = [v16, -v17];
    out[62] = 0.011_313_708_498_984_758 * L1;
    out[63] = -(0.011_313_708_498_984_764 * L1);
    [out[64], out[65]] = [v22, v21];
    out[66] = 0.015_454_813_220_625_089 * L1;
    out[67] = -(0.004_141_104_721_640_345 * L1);
    [out[68], out[69], out[70], out[71], out[72], out[73]] = [v3, v9, v23, v9, v23, v24];
    [out[74], out[75], out[76], out[77], out[78], out[79]] = [v3, v24, v25, v26, v25, v9];
    [out[80], out[81], out[82], out[83]] = [L1, v26, 0.0, 0.0];
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
    let constants = given.constants.first_chunk::<15>()?;
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
    let v0 = g * L2;
    let v1 = M2 * v0;
    let v2 = 1.0 / JH;
    let v3 = 1.0 / JK;
    let out = out.first_chunk_mut::<13>()?;
    out[0] = cK * (g * M1);
    [out[1], out[2], out[3], out[4], out[5], out[6]] = [v1, v2, v3, k2 * v2, k2 * v3, v0];
    [out[7], out[8], out[9], out[10], out[11]] = [g * L4, L4.abs(), L3.abs(), L1.abs(), v1 * v2];
    out[12] = -(b1 * v3);
    Some(())
}
