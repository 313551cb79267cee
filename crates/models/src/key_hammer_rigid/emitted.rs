//! Emitted from `the description of key-hammer-rigid` by `letoff model emit`; not to be changed by hand.
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
    PresetTable, RestTable, WayTable,
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
            values: 24,
        },
        PresetTable { name: "literal", doc: "Table 2 of the paper as printed, in SI", values: 25 },
        PresetTable {
            name: "playable",
            doc: "a real key's size, graded over the compass; the key bottom leaves the hammer 2–3 \
                mm short",
            values: 26,
        },
    ],
    requirements: &[],
    states: &[
        NamedQuantity { name: "theta_h", unit: "rad" },
        NamedQuantity { name: "theta_h_dot", unit: "rad/s" },
    ],
    coordinates: 1,
    constants: 105,
    derive_constants: 29,
    input: NamedQuantity { name: "s", unit: "rad" },
    input_per_metre: 27,
    modes: &[
        ModeTable {
            name: "A1",
            derivative: 0,
            parts: &[],
            part_list: &[],
            slaved: Some(1),
            projection: None,
            projected: 0,
            longest_projection: f64::INFINITY,
            readout: 3,
            slopes: 4,
            outputs: 5,
            balance: 6,
            jacobian: 2,
            kind: EquationKind::Affine,
            loss: None,
            is_stiffening: false,
            guards: &[GuardTable {
                id: 0,
                name: "release",
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
            derivative: 10,
            parts: &[PartTable {
                entries: 0x3,
                derivative: 10,
                kind: EquationKind::Conservative,
                loss: None,
                reads: Reads::State,
            }],
            part_list: &[Part::WHOLE.of_state()],
            slaved: None,
            projection: None,
            projected: 0,
            longest_projection: f64::INFINITY,
            readout: 12,
            slopes: 13,
            outputs: 14,
            balance: 15,
            jacobian: 11,
            kind: EquationKind::Conservative,
            loss: None,
            is_stiffening: false,
            guards: &[
                GuardTable {
                    id: 1,
                    name: "land",
                    priority: 0,
                    scale: 1.0,
                    fires: Fires::WhileNegative,
                    reads: Reads::StateAndInput,
                    value: 17,
                    bound: Some(18),
                    ways: &[WayTable { when: None, to: 0, reset: Some(16), resting: None }],
                    sounds: None,
                },
                GuardTable {
                    id: 2,
                    name: "string",
                    priority: 1,
                    scale: 1.0,
                    fires: Fires::OnCrossing,
                    reads: Reads::State,
                    value: 21,
                    bound: Some(22),
                    ways: &[WayTable { when: None, to: 1, reset: Some(19), resting: None }],
                    sounds: Some(20),
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
    ],
    rest: RestTable { mode: 0, state: 28, is_improved: true },
    damper: Some(DamperTable { lift: 0.005, fall: 0.0046, softest_tone: 0.15 }),
    drawing: DrawingTable {
        numbers: 23,
        count: 68,
        bodies: &[
            BodyTable {
                name: "key",
                output: Some(3),
                outlines: &[
                    OutlineTable {
                        material: Material::Wood,
                        is_closed: true,
                        points: (4, 4),
                        modes: &[],
                    },
                    OutlineTable {
                        material: Material::Metal,
                        is_closed: true,
                        points: (12, 24),
                        modes: &[],
                    },
                ],
            },
            BodyTable {
                name: "hammer",
                output: Some(6),
                outlines: &[OutlineTable {
                    material: Material::Wood,
                    is_closed: true,
                    points: (60, 4),
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
            10 => derivative_a2(given, out),
            11 => jacobian_a2(given, out),
            12 => readout_a2(given, out),
            13 => slopes_a2(given, out),
            14 => outputs_a2(given, out),
            15 => balance_a2(given, out),
            16 => reset_0_land_a2(given, out),
            17 => guard_land_a2(given, out),
            18 => bound_land_a2(given, out),
            19 => reset_0_string_a2(given, out),
            20 => speed_string_a2(given, out),
            21 => guard_string_a2(given, out),
            22 => bound_string_a2(given, out),
            23 => drawing(given, out),
            24 => preset_paper(given, out),
            25 => preset_literal(given, out),
            26 => preset_playable(given, out),
            27 => input_per_metre(given, out),
            28 => rest(given, out),
            29 => derived_constants(given, out),
            _ => return,
        };
        if done.is_none() {
            out.fill(f64::NAN);
        }
    }
}

/// The derivative of the state in mode A1.
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
    out[0] = 0.0;
    out[1] = 0.0;
    out[2] = 0.0;
    out[3] = 0.0;
    Some(())
}

/// The readout in mode A1.
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
    let out = out.first_chunk_mut::<9>()?;
    out[0] = v11;
    out[1] = s_rate2 * JK + c17 * cos_s + v9 * v11;
    out[2] = L4 * cos_v2 - L3 * sin_v2 - L1 * sin_v3;
    out[3] = 0.0;
    out[4] = 0.0;
    out[5] = s;
    out[6] = L3;
    out[7] = L4;
    out[8] = v2;
    Some(())
}

/// Energy, supplied and dissipated power in mode A1.
fn balance_a1(given: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let constants = given.constants.first_chunk::<23>()?;
    let input = given.input;
    let L1 = constants[0];
    let L3 = constants[2];
    let L4 = constants[3];
    let M2 = constants[5];
    let JK = constants[9];
    let JH = constants[10];
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
    let v3 = 1.0 / (v0 * v0 + v1 * v1);
    let v4 = L1 * (s_rate * (cos_s * v1 + sin_s * v0)) * v3;
    let v5 = s_rate * s_rate;
    let ([sin_v2, _], [cos_v2, cos_s_v2]) = math::sin_cos_of_two([v2, s - v2]);
    let v6 = c17 * sin_s + 0.5 * (JK * v5 + JH * (v4 * v4)) - M2 * -(c22 + c21 * sin_v2);
    let v7 = L1 * cos_s_v2;
    let v8 = cos_s * (s_rate2 * v1 + v5 * v0) + sin_s * (s_rate2 * v0 - v5 * v1);
    let v9 = L1 * (s_rate * (2.0 * (cos_s * v0 - sin_s * v1)));
    let v10 = v7 * (JH * (v3 * (L1 * v8 - v9 * v4)) + c18 * cos_v2);
    let v11 = JK * s_rate2 + c17 * cos_s + v10 / (v7 - (L4 * sin_v2 + L3 * cos_v2));
    let out = out.first_chunk_mut::<3>()?;
    out[0] = v6;
    out[1] = s_rate * v11;
    out[2] = 0.0;
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
    out[1] = v2;
    out[2] = 0.0;
    Some(())
}

/// The guard and its rate: release in mode A1.
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
    let constants = given.constants.first_chunk::<104>()?;
    let extra = given.extra.first_chunk::<4>()?;
    let input = given.input;
    let c23 = constants[23];
    let c24 = constants[24];
    let c25 = constants[25];
    let c26 = constants[26];
    let c27 = constants[27];
    let c28 = constants[28];
    let c29 = constants[29];
    let c30 = constants[30];
    let c31 = constants[31];
    let c32 = constants[32];
    let c33 = constants[33];
    let c34 = constants[34];
    let c35 = constants[35];
    let c36 = constants[36];
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
    let c47 = constants[47];
    let c48 = constants[48];
    let c49 = constants[49];
    let c50 = constants[50];
    let c51 = constants[51];
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
    let c63 = constants[63];
    let c64 = constants[64];
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
    let c99 = constants[99];
    let c100 = constants[100];
    let c101 = constants[101];
    let c102 = constants[102];
    let c103 = constants[103];
    let s = input[0];
    let s_rate = input[1];
    let s_rate2 = input[2];
    let s_rate3 = input[3];
    let extra_3 = extra[3];
    let v0 = 0.5 * s;
    let v1 = functions::smaller(v0, 1.0);
    let v2 = s * c23;
    let v3 = v2 * v1;
    let v4 = functions::smaller(1.0 + v0, 1.0);
    let v5 = v2 * v4;
    let v6 = functions::larger(c26 - v3, c24 - v5);
    let v7 = if v6 > 0.0 { 0.0 } else { f64::INFINITY };
    let v8 = s * v4;
    let v9 = c30 * (s * v1);
    let v10 = c31 * v8 + v9 * functions::smaller(v8, 1.0);
    let v11 = s_rate * v10;
    let v12 = c24 + v5;
    let v13 = c30 * v8 + v3 * v12;
    let v14 = s_rate * v13;
    let v15 = s_rate * c37;
    let v16 = v15 + v14 + v11;
    let v17 = 2.0 * v16;
    let v18 = v3 * (c33 + v3) + v5 * (c32 + v5);
    let v19 = 1.0 / functions::larger(c34 - v18, 0.0);
    let v20 = v18 * v19;
    let v21 = c35 * v20;
    let v22 = v5 * v12;
    let v23 = v9 + v3 * (c25 + v3);
    let v24 = v22 + v23;
    let v25 = c31 + v24;
    let v26 = c36 + v19;
    let v27 = v26 * v21;
    let v28 = c45 * v24 + v25 * v27;
    let v29 = v21 + (c61 + (c36 + v28));
    let v30 = v13 + v10;
    let v31 = 2.0 * v30;
    let v32 = c43 + v31;
    let v33 = s_rate * v22 + (s_rate * c31 + s_rate * v23);
    let v34 = v19 * (v33 * v19);
    let v35 = v32 * v34 + v17 * v29;
    let v36 = v25 * v19;
    let v37 = math::hypot(v5, v3);
    let v38 = v37 / functions::larger(c27 - v37, 0.0);
    let v39 = if v6 > 0.0 { v38 } else { f64::INFINITY };
    let v40 = s + v39;
    let v41 = 0.5 * v40;
    let v42 = c23 * v40;
    let v43 = v42 * functions::smaller(c28 + v41, 1.0);
    let v44 = 0.5 * v39;
    let v45 = functions::smaller(c29 + v44, 1.0);
    let v46 = v39 * v45;
    let v47 = functions::smaller(c28 + v44, 1.0);
    let v48 = v39 * v47;
    let v49 = v43 + (c24 * v46 + c40 * v48);
    let v50 = 1.0 / functions::larger(c55 - v49, 0.0);
    let v51 = c36 * v24 + v25 * v21;
    let v52 = c44 + v51;
    let v53 = v42 * functions::smaller(c29 + v41, 1.0);
    let v54 = v19 * (c48 * v18 + c24 * v48);
    let v55 = v19 * (c50 * v18 + c40 * v46);
    let v56 = c52 * v51 + v52 * v53 + (c49 * v24 + v25 * v54 + (c51 * v24 + v25 * v55));
    let v57 = c53 + v56;
    let v58 = c56 + v50;
    let v59 = v17 * v34;
    let v60 = s_rate2 * c31 + s_rate * v14 + (s_rate2 * v23 + s_rate * v11);
    let v61 = s_rate * v15 + s_rate2 * v22 + v60;
    let v62 = c38 * (v59 + v61 * (c36 + v21)) + c39 * v48;
    let v63 = v49 * v50;
    let v64 = c57 * v63;
    let v65 = (c41 + v62) * v64;
    let v66 = c58 * v62 + v58 * v65;
    let v67 = s_rate * c42 + v33;
    let v68 = 2.0 * v67;
    let v69 = v32 * v19;
    let v70 = s_rate * s_rate * (v23 + (c31 + c42 + v22)) + s_rate2 * (c37 + v13 + v10);
    let v71 = c35 * v18;
    let v72 = v71 * v70 + v33 * (v19 * (v68 + 2.0 * (v17 * v69)));
    let v73 = c45 + v27;
    let v74 = v61 * v73;
    let v75 = v17 * v73;
    let v76 = v19 * v72 + (v16 * v75 + (c36 * v70 + v32 * v74));
    let v77 = v19 * (c46 * v18 + c39 * v46);
    let v78 = c47 * v24 + (c38 * v76 + v25 * v77);
    let v79 = c54 + v78;
    let v80 = c59 * v56 + (c60 + c56 * v78) + v79 * v64 + v57 * v66;
    let v81 = c38 * ((s_rate3 * v36 + s_rate2 * v35) * v50) + s_rate * v80;
    let v82 = v57 * v57 * (c83 * v62 + v65 * (v50 * (c56 + 2.0 * v50)));
    let v83 = v57 * v58;
    let v84 = v19 * v39;
    let v85 = v84 * v45;
    let v86 = v18 * v26;
    let v87 = v25 * v25;
    let v88 = v24 * (c67 + v24);
    let v89 = c72 * v88 + v87 * (v19 * (c71 * v86 + c24 * v85));
    let v90 = v84 * v47;
    let v91 = c73 * v24 + v25 * (v19 * (c48 * v86 + c24 * v90));
    let v92 = c37 + v30;
    let v93 = c76 * v88 + v87 * (v19 * (c75 * v86 + c40 * v90));
    let v94 = c49 * v30 + v92 * v54 + v93 + (v89 + (c74 * v31 + v32 * v91));
    let v95 = c77 * v24 + v25 * (v19 * (c50 * v86 + c40 * v85));
    let v96 = c61 * v31 + v32 * v28;
    let v97 = c36 * v30 + v92 * v21 + v96;
    let v98 = (c79 + v51) * (c80 * v51) + v52 * v52 * v43 + (c52 * v97 + (c63 + v97) * v53);
    let v99 = v98 + (c51 * v30 + v92 * v55 + (c78 * v31 + v32 * v95));
    let v100 = v94 + v99;
    let v101 = c62 + 2.0 * v24;
    let v102 = 4.0 * (v68 * v32) + v17 * (2.0 * v101 + 6.0 * (v32 * v69));
    let v103 = s_rate2 * c42 + v61;
    let v104 = v21 * (v19 * (c36 + 2.0 * v19));
    let v105 = c64 + v104;
    let v106 = 2.0 * (v32 * (v61 * v105)) + 4.0 * (v16 * (v17 * v105));
    let v107 = v16 * v73;
    let v108 = c36 * v103 + v59 + v101 * v74 + v70 * (2.0 * (c65 + (c45 * v31 + v32 * v27)));
    let v109 = v19 * (v71 * v103 + v33 * (v19 * v19 * v102)) + v32 * v106;
    let v110 = c38 * (v67 * v75 + 2.0 * (v68 * v107) + v108 + v109);
    let v111 = c47 * v30 + (v110 + v87 * (v19 * (c66 * v86 + c39 * v90)));
    let v112 = c69 * v24 + v25 * (v19 * (c46 * v86 + c39 * v85));
    let v113 = v111 + (c70 * v31 + v92 * v77 + (c68 * v88 + v32 * v112));
    let v114 = c86 * v78 + (c84 + v56) * (c85 * v56) + v79 * (c58 * v56 + v64 * v83);
    let v115 = c59 * v100 + (c87 + c56 * v113) + (c82 + v113) * v64;
    let v116 = s_rate * (v115 + (c81 + v100) * v66 + 2.0 * (v82 + v114));
    let v117 = c89 * v63;
    let v118 = v69 * v34 + v17 * (c88 + (c64 * v24 + v25 * v104));
    let v119 = v101 * v34 + v92 * v75 + v68 * v29 + v32 * (v75 + v107 + 2.0 * v118);
    let v120 = v119 * (c92 + v117) + v35 * (c91 + (c90 * v56 + v83 * v117));
    let v121 = (c96 * v24 + c94 * v25 * (v20 * v26) + c97 * v49) * v50;
    let v122 = c94 * v20;
    let v123 = (c95 * v24 + v25 * v122) * v50 + v49 * (c101 * v58);
    let v124 = c98 * v31 + (c103 + c100 * v30) + c102 * v56 + v32 * v121;
    let v125 = v92 * ((v122 + c99 * v49) * v50) + v124 + v57 * (v50 * v123);
    let v126 = s_rate * (v116 + 2.0 * (s_rate2 * v120 + s_rate3 * v125));
    let v127 = c38 * v50;
    let v128 = s_rate2 * ((c93 + c36 * v31 + v32 * v21 + 2.0 * v96) * v127);
    let v129 = s_rate3 * (v35 * v127) + s_rate2 * (v128 + v80) + v126;
    let v130 = v7 + f64::INFINITY * (v36 * v127) + extra_3 * extra_3 * v129;
    let out = out.first_chunk_mut::<2>()?;
    out[0] = v7 + extra_3 * v81;
    out[1] = v130;
    Some(())
}

/// The derivative of the state in mode A2.
fn derivative_a2(given: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let constants = given.constants.first_chunk::<105>()?;
    let state = given.state.first_chunk::<2>()?;
    let c104 = constants[104];
    let theta_h = state[0];
    let theta_h_dot = state[1];
    let cos_theta_h = math::sin_cos(theta_h).1;
    let out = out.first_chunk_mut::<2>()?;
    out[0] = theta_h_dot;
    out[1] = -(c104 * cos_theta_h);
    Some(())
}

/// The derivative's derivative by the state in mode A2.
fn jacobian_a2(given: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let constants = given.constants.first_chunk::<105>()?;
    let state = given.state.first_chunk::<1>()?;
    let c104 = constants[104];
    let theta_h = state[0];
    let sin_theta_h = math::sin_cos(theta_h).0;
    let out = out.first_chunk_mut::<4>()?;
    out[0] = 0.0;
    out[1] = 1.0;
    out[2] = c104 * sin_theta_h;
    out[3] = 0.0;
    Some(())
}

/// The readout in mode A2.
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
    let constants = given.constants.first_chunk::<18>()?;
    let state = given.state.first_chunk::<1>()?;
    let input = given.input;
    let L1 = constants[0];
    let L3 = constants[2];
    let L4 = constants[3];
    let JK = constants[9];
    let c17 = constants[17];
    let theta_h = state[0];
    let s = input[0];
    let s_rate2 = input[2];
    let ([_, sin_theta_h], [cos_s, cos_theta_h]) = math::sin_cos_of_two([s, theta_h]);
    let sin_theta_h_s = math::sin_cos(theta_h - s).0;
    let v0 = L1 * sin_theta_h_s + (L4 * cos_theta_h - L3 * sin_theta_h);
    let out = out.first_chunk_mut::<9>()?;
    out[0] = 0.0;
    out[1] = s_rate2 * JK + c17 * cos_s;
    out[2] = v0;
    out[3] = 0.0;
    out[4] = 0.0;
    out[5] = s;
    out[6] = L3;
    out[7] = L4;
    out[8] = theta_h;
    Some(())
}

/// Energy, supplied and dissipated power in mode A2.
fn balance_a2(given: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let constants = given.constants.first_chunk::<23>()?;
    let state = given.state.first_chunk::<2>()?;
    let input = given.input;
    let M2 = constants[5];
    let JK = constants[9];
    let JH = constants[10];
    let c17 = constants[17];
    let c21 = constants[21];
    let c22 = constants[22];
    let theta_h = state[0];
    let theta_h_dot = state[1];
    let s = input[0];
    let s_rate = input[1];
    let s_rate2 = input[2];
    let ([sin_s, sin_theta_h], [cos_s, _]) = math::sin_cos_of_two([s, theta_h]);
    let v0 = JH * (theta_h_dot * theta_h_dot) + JK * (s_rate * s_rate);
    let v1 = 0.5 * v0 + c17 * sin_s - M2 * -(c22 + c21 * sin_theta_h);
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
    out[0] = v2;
    out[1] = v3;
    out[2] = v7 / (v6 * v6);
    Some(())
}

/// The guard and its rate: land in mode A2.
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
    let constants = given.constants.first_chunk::<41>()?;
    let state = given.state.first_chunk::<1>()?;
    let extra = given.extra.first_chunk::<4>()?;
    let input = given.input;
    let L1 = constants[0];
    let L3 = constants[2];
    let L4 = constants[3];
    let c23 = constants[23];
    let c24 = constants[24];
    let c40 = constants[40];
    let theta_h = state[0];
    let s = input[0];
    let s_rate = input[1];
    let s_rate2 = input[2];
    let extra_0 = extra[0];
    let extra_1 = extra[1];
    let extra_2 = extra[2];
    let extra_3 = extra[3];
    let (sin_theta_h, cos_theta_h) = math::sin_cos(theta_h);
    let v0 = L1 * cos_theta_h;
    let v1 = sin_theta_h.abs();
    let v2 = extra_0 + s;
    let v3 = 0.5 * v2;
    let v4 = c23 * v2;
    let v5 = v4 * functions::smaller(v3 + v1, 1.0);
    let v6 = cos_theta_h.abs();
    let v7 = 0.5 * extra_0;
    let v8 = functions::smaller(v7 + v6, 1.0);
    let v9 = functions::smaller(v7 + v1, 1.0);
    let v10 = (L4 * sin_theta_h + L3 * cos_theta_h - v0).abs() + v5;
    let v11 = v10 + extra_0 * (c24 * v8 + c40 * v9);
    let v12 = v0.abs() + v5;
    let v13 = s_rate * extra_3;
    let v14 = functions::smaller(v3 + v6, 1.0);
    let v15 = c23 * extra_1 * functions::smaller(v1 + v2 * v14, 1.0);
    let v16 = L1 * sin_theta_h;
    let v17 = v4 * v14;
    let v18 = extra_3 * s_rate2 * v12 + s_rate * (v13 * (v16.abs() + v17) + 2.0 * v15);
    let v19 = (v16 + L4 * cos_theta_h - L3 * sin_theta_h).abs();
    let v20 = extra_1 * (v19 + v17 + extra_0 * (c24 * v9 + c40 * v8));
    let out = out.first_chunk_mut::<2>()?;
    out[0] = v13 * v12 + extra_0 * v11;
    out[1] = extra_2 * v11 + extra_1 * v20 + extra_3 * v18;
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
    let extra_0 = extra[0];
    let extra_2 = extra[2];
    let out = out.first_chunk_mut::<2>()?;
    out[0] = extra_0;
    out[1] = extra_2;
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
    let v6 = 0.016 * L1;
    let v7 = -v6;
    let v8 = 1.015_454_813_220_625_1 * L1;
    let v9 = 1.013_856_406_460_551 * L1;
    let v10 = 0.007_999_999_999_999_998 * L1;
    let v11 = 1.011_313_708_498_984_7 * L1;
    let v12 = 1.008 * L1;
    let v13 = 0.013_856_406_460_551_017 * L1;
    let v14 = 1.004_141_104_721_640_4 * L1;
    let v15 = 0.015_454_813_220_625_094 * L1;
    let v16 = 0.995_858_895_278_359_7 * L1;
    let v17 = 0.992 * L1;
    let v18 = 0.988_686_291_501_015_3 * L1;
    let v19 = 0.986_143_593_539_449 * L1;
    let v20 = 0.984_545_186_779_374_9 * L1;
    let v21 = -(0.03 * L1);
    let v22 = 0.05 * L1;
    let out = out.first_chunk_mut::<68>()?;
    out[0] = -(r + v0);
    out[1] = -v1;
    out[2] = v2;
    out[3] = L4 + v1 + L2 * sin_string_angle.abs();
    out[4] = v3;
    out[5] = v4;
    out[6] = v5;
    out[7] = v4;
    out[8] = v5;
    out[9] = v7;
    out[10] = v3;
    out[11] = v7;
    out[12] = 1.016 * L1;
    out[13] = 0.0;
    out[14] = v8;
    out[15] = 0.004_141_104_721_640_332 * L1;
    out[16] = v9;
    out[17] = v10;
    out[18] = v11;
    out[19] = 0.011_313_708_498_984_76 * L1;
    out[20] = v12;
    out[21] = v13;
    out[22] = v14;
    out[23] = v15;
    out[24] = L1;
    out[25] = v6;
    out[26] = v16;
    out[27] = v15;
    out[28] = v17;
    out[29] = 0.013_856_406_460_551_019 * L1;
    out[30] = v18;
    out[31] = 0.011_313_708_498_984_762 * L1;
    out[32] = v19;
    out[33] = v10;
    out[34] = v20;
    out[35] = 0.004_141_104_721_640_336_5 * L1;
    out[36] = 0.984 * L1;
    out[37] = 1.959_434_878_635_765e-18 * L1;
    out[38] = v20;
    out[39] = -(0.004_141_104_721_640_333 * L1);
    out[40] = v19;
    out[41] = -(0.007_999_999_999_999_995 * L1);
    out[42] = v18;
    out[43] = -(0.011_313_708_498_984_755 * L1);
    out[44] = v17;
    out[45] = -(0.013_856_406_460_551_014 * L1);
    out[46] = v16;
    out[47] = -v15;
    out[48] = L1;
    out[49] = v7;
    out[50] = v14;
    out[51] = -(0.015_454_813_220_625_096 * L1);
    out[52] = v12;
    out[53] = -v13;
    out[54] = v11;
    out[55] = -(0.011_313_708_498_984_764 * L1);
    out[56] = v9;
    out[57] = -(0.008_000_000_000_000_007 * L1);
    out[58] = v8;
    out[59] = -(0.004_141_104_721_640_345 * L1);
    out[60] = v21;
    out[61] = v6;
    out[62] = L2;
    out[63] = v6;
    out[64] = L2;
    out[65] = v22;
    out[66] = v21;
    out[67] = v22;
    Some(())
}

/// The preset paper.
fn preset_paper(_: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let out = out.first_chunk_mut::<17>()?;
    out[0] = 0.4;
    out[1] = 1.0;
    out[2] = 0.1;
    out[3] = 0.05;
    out[4] = 6.5;
    out[5] = 0.01;
    out[6] = 6.2;
    out[7] = 15.0;
    out[8] = 0.002;
    out[9] = 0.01625;
    out[10] = 0.01;
    out[11] = 9.81;
    out[12] = 0.398;
    out[13] = 1.0;
    out[14] = 0.0;
    out[15] = 0.0;
    out[16] = 0.097_020_853_308_819_4;
    Some(())
}

/// The preset literal.
fn preset_literal(_: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let out = out.first_chunk_mut::<17>()?;
    out[0] = 4.0;
    out[1] = 10.0;
    out[2] = 1.0;
    out[3] = 0.5;
    out[4] = 6.5;
    out[5] = 0.01;
    out[6] = 620.0;
    out[7] = 15.0;
    out[8] = 0.02;
    out[9] = 1.625;
    out[10] = 1.0;
    out[11] = 9.81;
    out[12] = 0.398;
    out[13] = 1.0;
    out[14] = 0.0;
    out[15] = 0.0;
    out[16] = 0.097_020_853_308_819_4;
    Some(())
}

/// The preset playable.
fn preset_playable(given: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let extra = given.extra.first_chunk::<1>()?;
    let extra_0 = extra[0];
    let v0 = 0.000_630_306_423_357_664 * extra_0 - 0.034_866_025_053_821_58;
    let v1 = 0.000_207_048_950_680_000_01 - 1.159_049_32e-6 * extra_0;
    let out = out.first_chunk_mut::<17>()?;
    out[0] = 0.1385;
    out[1] = 0.13;
    out[2] = 0.124_800_000_000_000_01;
    out[3] = 0.0027;
    out[4] = 0.13;
    out[5] = 0.011_137_652 - 6.2348e-5 * extra_0;
    out[6] = 300.0;
    out[7] = 24000.0;
    out[8] = v0;
    out[9] = 0.002;
    out[10] = v1;
    out[11] = 9.81;
    out[12] = 0.213_336_278_760_121_84;
    out[13] = 0.1;
    out[14] = 0.12;
    out[15] = 6.0;
    out[16] = 0.2595;
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
    out[0] = 0.0;
    out[1] = 0.0;
    Some(())
}

/// What follows from the parameters.
fn derived_constants(given: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let constants = given.constants.first_chunk::<12>()?;
    let L1 = constants[0];
    let L2 = constants[1];
    let L3 = constants[2];
    let L4 = constants[3];
    let M1 = constants[4];
    let M2 = constants[5];
    let cK = constants[8];
    let JH = constants[10];
    let g = constants[11];
    let v0 = -L4;
    let v1 = L3 - L1;
    let v2 = -v1;
    let v3 = math::atan2(v0, v2);
    let v4 = g * L2;
    let v5 = M2 * v4;
    let v6 = L1 * L1;
    let v7 = L1.abs();
    let v8 = L4.abs();
    let v9 = v1.abs();
    let (sin_v3, cos_v3) = math::sin_cos(v3);
    let v10 = L1 * v2;
    let v11 = v10.abs();
    let v12 = L4 * L4 + v2 * v2;
    let v13 = v12.abs();
    let v14 = 1.0 / v13;
    let v15 = 1.0 / v12;
    let v16 = L4 * L1;
    let v17 = JH.abs();
    let v18 = v5 * cos_v3;
    let v19 = v18.abs();
    let v20 = L1 * v15;
    let v21 = v2 * v20;
    let v22 = (v21 - 1.0).abs();
    let v23 = v15 * v15;
    let v24 = v5 * sin_v3;
    let v25 = v15 * v24;
    let v26 = L4 * cos_v3;
    let v27 = v15 * v26;
    let v28 = L3 * sin_v3;
    let v29 = v15 * v28;
    let v30 = L1 * sin_v3;
    let v31 = 1.0 - v21;
    let v32 = v21 * sin_v3;
    let v33 = L3 * v32;
    let v34 = v31 * v30 - (v21 * v26 - v33);
    let v35 = (-v34).abs();
    let v36 = v5 * v32;
    let v37 = L1 * cos_v3;
    let v38 = L4 * sin_v3;
    let v39 = L3 * cos_v3;
    let v40 = v37 - (v38 + v39);
    let v41 = (-v40).abs();
    let v42 = 1.0 / v40;
    let v43 = 1.0 / v41;
    let v44 = v42 * v42;
    let v45 = v42 * (v18 * v42);
    let v46 = v34 * v42;
    let v47 = (g * (M2 * (L2 * (v42 * (v32 + cos_v3 * v46))))).abs();
    let v48 = v15 * v21;
    let v49 = L4 * v20;
    let v50 = v21 * v49 - 0.5 * v49;
    let v51 = 2.0 * v50;
    let v52 = v2 * (v15 * ((2.0 * L3 + v2) * sin_v3 - 2.0 * v26));
    let v53 = v15 * (v2 * (v21 * v39) + L4 * (v26 - v28 + L1 * v52));
    let v54 = L1 * (-v51 * sin_v3 - v31 * v31 * cos_v3 + v53);
    let v55 = v49 * v24 - (v21 * v21 * v18 + 2.0 * (v49 * v36));
    let v56 = 2.0 * (v32 * v34) + cos_v3 * (2.0 * (v34 * v46) - v54);
    let v57 = (v42 * (v55 + g * (M2 * (L2 * (v42 * v56))))).abs();
    let v58 = JH * v42;
    let v59 = v42 * v58;
    let v60 = JH * v15;
    let v61 = v60.abs();
    let v62 = v15 * (v42 * (L4 * (2.0 * v21 - 1.0) - v2 * v46));
    let out = out.first_chunk_mut::<88>()?;
    out[0] = cK * (g * M1);
    out[1] = v5;
    out[2] = v6;
    out[3] = L1 * JH;
    out[4] = v4;
    out[5] = L4 * g;
    out[6] = v7;
    out[7] = v8;
    out[8] = v9;
    out[9] = v2;
    out[10] = math::hypot(v0, v2);
    out[11] = sin_v3.abs();
    out[12] = cos_v3.abs();
    out[13] = v7 * v7;
    out[14] = v11;
    out[15] = 2.0 * v8;
    out[16] = 2.0 * v9;
    out[17] = v13;
    out[18] = v14;
    out[19] = v15.abs();
    out[20] = v16.abs();
    out[21] = v17;
    out[22] = v5.abs();
    out[23] = L3.abs();
    out[24] = v19;
    out[25] = v6.abs();
    out[26] = (2.0 * v16).abs();
    out[27] = v22;
    out[28] = v23.abs();
    out[29] = v14 * v24.abs();
    out[30] = v25.abs();
    out[31] = v14 * v26.abs();
    out[32] = v27.abs();
    out[33] = v14 * v28.abs();
    out[34] = v29.abs();
    out[35] = v30.abs();
    out[36] = v35;
    out[37] = v36.abs();
    out[38] = v41;
    out[39] = v42.abs();
    out[40] = v43;
    out[41] = v44.abs();
    out[42] = v45.abs();
    out[43] = v47;
    out[44] = v48.abs();
    out[45] = (2.0 * (v6 - v10)).abs();
    out[46] = v51.abs();
    out[47] = (v23 * v15).abs();
    out[48] = (2.0 * (v15 * v49)).abs();
    out[49] = v14 * v19;
    out[50] = 2.0 * v11;
    out[51] = (v23 * v18).abs();
    out[52] = (v15 * v25).abs();
    out[53] = (v15 * v36).abs();
    out[54] = v14 * v38.abs();
    out[55] = (v23 * v38).abs();
    out[56] = (v15 * v27).abs();
    out[57] = (v48 * v26).abs();
    out[58] = v14 * v39.abs();
    out[59] = (v23 * v39).abs();
    out[60] = (v15 * v29).abs();
    out[61] = (v15 * v33).abs();
    out[62] = 2.0 * v22;
    out[63] = v37.abs();
    out[64] = v54.abs();
    out[65] = (-v55).abs();
    out[66] = (v44 * v42).abs();
    out[67] = 2.0 * v35;
    out[68] = (v42 * v45).abs();
    out[69] = (v42 * v46).abs();
    out[70] = v57;
    out[71] = (v15 * v48).abs();
    out[72] = v17 * v43;
    out[73] = v59.abs();
    out[74] = (v46 * v58).abs();
    out[75] = v58.abs();
    out[76] = (4.0 * v50).abs();
    out[77] = v17 * v14;
    out[78] = v61;
    out[79] = (v15 * v60).abs();
    out[80] = (JH * v48).abs() * v43;
    out[81] = (v48 * v58).abs();
    out[82] = v61 * v43;
    out[83] = (v15 * v58).abs();
    out[84] = (JH * v21).abs() * v43;
    out[85] = (v21 * v59).abs();
    out[86] = (L1 * (JH * v62)).abs();
    out[87] = v5 / JH;
    Some(())
}
