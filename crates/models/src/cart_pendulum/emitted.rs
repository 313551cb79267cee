//! Emitted from `the description of cart-pendulum` by `letoff model emit`; not to be changed by hand.
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
    Arguments, BodyTable, DrawingTable, Freedom, FunctionId, Functions, GuardTable, Material,
    MidiTable, ModeTable, ModelTable, NamedQuantity, OutlineTable, ParameterTable, PartTable,
    PresetTable, RequirementTable, RestTable, RestingTable, SeriesTable, SpringTable, WayTable,
};
use pode::{EquationKind, Fires, GuardId, GuardSpec, Part, Reads, math};

/// All of the model but its arithmetic.
pub static TABLE: ModelTable = ModelTable {
    name: "cart-pendulum",
    summary: "a cart with a pendulum between two walls, pulled by a spring",
    parameters: &[
        ParameterTable {
            name: "cart_mass",
            title: "cart",
            unit: "kg",
            range: (1e-9, 1_000_000_000.0),
            doc: "mass of the cart",
        },
        ParameterTable {
            name: "bob_mass",
            title: "bob",
            unit: "kg",
            range: (1e-9, 1_000_000_000.0),
            doc: "mass of the bob",
        },
        ParameterTable {
            name: "length",
            title: "length",
            unit: "m",
            range: (1e-9, 1_000_000_000.0),
            doc: "pivot to the bob's mass centre",
        },
        ParameterTable {
            name: "inertia",
            title: "inertia",
            unit: "kg·m²",
            range: (0.0, 1_000_000_000.0),
            doc: "inertia of the bob about its mass centre",
        },
        ParameterTable {
            name: "g",
            title: "gravity",
            unit: "m/s²",
            range: (0.0, 1000.0),
            doc: "gravity",
        },
        ParameterTable {
            name: "k",
            title: "spring",
            unit: "N/m",
            range: (0.0, 1_000_000_000.0),
            doc: "spring between the input and the cart",
        },
        ParameterTable {
            name: "b",
            title: "damper",
            unit: "N·s/m",
            range: (0.0, 1_000_000_000.0),
            doc: "damper beside the spring",
        },
        ParameterTable {
            name: "left",
            title: "left wall",
            unit: "m",
            range: (-100.0, 100.0),
            doc: "where the cart meets the left wall",
        },
        ParameterTable {
            name: "right",
            title: "right wall",
            unit: "m",
            range: (-100.0, 100.0),
            doc: "where the cart meets the right wall; right of the left one",
        },
        ParameterTable {
            name: "restitution",
            title: "restitution",
            unit: "1",
            range: (0.0, 1.0),
            doc: "speed of the cart after a wall over its speed before",
        },
        ParameterTable {
            name: "scale",
            title: "scale",
            unit: "m/m",
            range: (-1000.0, 1000.0),
            doc: "input per key travel; positive pulls the cart to the right",
        },
    ],
    presets: &[
        PresetTable {
            name: "default",
            doc: "1 kg of cart, 0.3 kg of pendulum, walls at ±5 cm",
            values: 38,
        },
        PresetTable {
            name: "key",
            doc: "60 g in all on a rubber band, pulled 5 times the key's travel",
            values: 39,
        },
    ],
    requirements: &[RequirementTable { text: "right > left", margin: 40 }],
    states: &[
        NamedQuantity { name: "x", unit: "m" },
        NamedQuantity { name: "theta", unit: "rad" },
        NamedQuantity { name: "x_dot", unit: "m/s" },
        NamedQuantity { name: "theta_dot", unit: "rad/s" },
    ],
    coordinates: 2,
    constants: 42,
    derive_constants: 43,
    input: NamedQuantity { name: "s", unit: "m" },
    input_per_metre: 41,
    modes: &[
        ModeTable {
            name: "free",
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
                start: 15,
                step: 16,
                entries: 0xf,
                guards: 2,
                conditions: 0,
                lanes: 9,
                carried: 11,
            }),
            kind: EquationKind::Smooth,
            loss: Some(1),
            is_stiffening: false,
            guards: &[
                GuardTable {
                    id: 0,
                    name: "left",
                    unit: "m",
                    priority: 0,
                    scale: 1.0,
                    fires: Fires::WhileNegative,
                    reads: Reads::State,
                    value: 11,
                    bound: Some(12),
                    ways: &[WayTable {
                        when: None,
                        to: 0,
                        reset: Some(7),
                        resting: Some(RestingTable { to: 1, state: 8, meeting: 9 }),
                    }],
                    sounds: Some(10),
                },
                GuardTable {
                    id: 1,
                    name: "right",
                    unit: "m",
                    priority: 1,
                    scale: 1.0,
                    fires: Fires::WhileNegative,
                    reads: Reads::State,
                    value: 14,
                    bound: Some(12),
                    ways: &[WayTable {
                        when: None,
                        to: 0,
                        reset: Some(7),
                        resting: Some(RestingTable { to: 2, state: 8, meeting: 13 }),
                    }],
                    sounds: Some(10),
                },
            ],
            guard_specs: &[
                GuardSpec {
                    id: GuardId(0),
                    name: "left",
                    priority: 0,
                    scale: 1.0,
                    fires: Fires::WhileNegative,
                    reads: Reads::State,
                },
                GuardSpec {
                    id: GuardId(1),
                    name: "right",
                    priority: 1,
                    scale: 1.0,
                    fires: Fires::WhileNegative,
                    reads: Reads::State,
                },
            ],
            contacts: &[],
            freedom: Freedom { n: 2, m: 0, p: 2 },
        },
        ModeTable {
            name: "left",
            derivative: 17,
            parts: &[PartTable {
                entries: 0xa,
                derivative: 17,
                kind: EquationKind::Conservative,
                loss: None,
                reads: Reads::State,
            }],
            part_list: &[Part::of(&[1, 3]).of_state()],
            slaved: Some(18),
            projection: None,
            projected: 0,
            longest_projection: Some(28),
            readout: 20,
            slopes: 4,
            outputs: 21,
            balance: 22,
            jacobian: 19,
            series: Some(SeriesTable {
                start: 26,
                step: 27,
                entries: 0xa,
                guards: 1,
                conditions: 0,
                lanes: 4,
                carried: 5,
            }),
            kind: EquationKind::Smooth,
            loss: Some(1),
            is_stiffening: false,
            guards: &[GuardTable {
                id: 2,
                name: "off",
                unit: "N",
                priority: 0,
                scale: 1.0,
                fires: Fires::WhileNegative,
                reads: Reads::StateAndInput,
                value: 24,
                bound: Some(25),
                ways: &[WayTable { when: None, to: 0, reset: Some(23), resting: None }],
                sounds: None,
            }],
            guard_specs: &[GuardSpec {
                id: GuardId(2),
                name: "off",
                priority: 0,
                scale: 1.0,
                fires: Fires::WhileNegative,
                reads: Reads::StateAndInput,
            }],
            contacts: &[],
            freedom: Freedom { n: 2, m: 1, p: 1 },
        },
        ModeTable {
            name: "right",
            derivative: 17,
            parts: &[PartTable {
                entries: 0xa,
                derivative: 17,
                kind: EquationKind::Conservative,
                loss: None,
                reads: Reads::State,
            }],
            part_list: &[Part::of(&[1, 3]).of_state()],
            slaved: Some(29),
            projection: None,
            projected: 0,
            longest_projection: Some(28),
            readout: 30,
            slopes: 4,
            outputs: 31,
            balance: 32,
            jacobian: 19,
            series: Some(SeriesTable {
                start: 35,
                step: 36,
                entries: 0xa,
                guards: 1,
                conditions: 0,
                lanes: 4,
                carried: 5,
            }),
            kind: EquationKind::Smooth,
            loss: Some(1),
            is_stiffening: false,
            guards: &[GuardTable {
                id: 2,
                name: "off",
                unit: "N",
                priority: 0,
                scale: 1.0,
                fires: Fires::WhileNegative,
                reads: Reads::StateAndInput,
                value: 34,
                bound: Some(25),
                ways: &[WayTable { when: None, to: 0, reset: Some(33), resting: None }],
                sounds: None,
            }],
            guard_specs: &[GuardSpec {
                id: GuardId(2),
                name: "off",
                priority: 0,
                scale: 1.0,
                fires: Fires::WhileNegative,
                reads: Reads::StateAndInput,
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
            name: "left",
            priority: 0,
            scale: 1.0,
            fires: Fires::WhileNegative,
            reads: Reads::State,
        },
        GuardSpec {
            id: GuardId(1),
            name: "right",
            priority: 1,
            scale: 1.0,
            fires: Fires::WhileNegative,
            reads: Reads::State,
        },
        GuardSpec {
            id: GuardId(2),
            name: "off",
            priority: 0,
            scale: 1.0,
            fires: Fires::WhileNegative,
            reads: Reads::StateAndInput,
        },
    ],
    outputs: &[
        NamedQuantity { name: "F", unit: "N" },
        NamedQuantity { name: "N", unit: "N" },
        NamedQuantity { name: "cart.x", unit: "m" },
        NamedQuantity { name: "cart.y", unit: "m" },
        NamedQuantity { name: "cart.angle", unit: "rad" },
        NamedQuantity { name: "bob.x", unit: "m" },
        NamedQuantity { name: "bob.y", unit: "m" },
        NamedQuantity { name: "bob.angle", unit: "rad" },
        NamedQuantity { name: "hand.x", unit: "m" },
        NamedQuantity { name: "hand.y", unit: "m" },
        NamedQuantity { name: "hand.angle", unit: "rad" },
    ],
    rest: RestTable { mode: 0, instead: &[], state: 42, is_improved: true },
    damper: None,
    midi: MidiTable { speeds: None, velocity: None, pressure: None },
    drawing: DrawingTable {
        numbers: 37,
        count: 288,
        bodies: &[
            BodyTable {
                name: "walls",
                output: None,
                outlines: &[
                    OutlineTable {
                        material: Material::Ground,
                        is_closed: true,
                        points: (4, 4),
                        modes: &[],
                    },
                    OutlineTable {
                        material: Material::Ground,
                        is_closed: true,
                        points: (12, 4),
                        modes: &[],
                    },
                    OutlineTable {
                        material: Material::Ground,
                        is_closed: false,
                        points: (20, 2),
                        modes: &[],
                    },
                ],
            },
            BodyTable {
                name: "cart",
                output: Some(2),
                outlines: &[
                    OutlineTable {
                        material: Material::Wood,
                        is_closed: true,
                        points: (24, 4),
                        modes: &[],
                    },
                    OutlineTable {
                        material: Material::Metal,
                        is_closed: true,
                        points: (32, 4),
                        modes: &[],
                    },
                    OutlineTable {
                        material: Material::Metal,
                        is_closed: true,
                        points: (40, 24),
                        modes: &[],
                    },
                    OutlineTable {
                        material: Material::Metal,
                        is_closed: true,
                        points: (88, 24),
                        modes: &[],
                    },
                ],
            },
            BodyTable {
                name: "pendulum",
                output: Some(5),
                outlines: &[
                    OutlineTable {
                        material: Material::Metal,
                        is_closed: false,
                        points: (136, 2),
                        modes: &[],
                    },
                    OutlineTable {
                        material: Material::Metal,
                        is_closed: true,
                        points: (140, 24),
                        modes: &[],
                    },
                    OutlineTable {
                        material: Material::Metal,
                        is_closed: true,
                        points: (188, 24),
                        modes: &[],
                    },
                ],
            },
            BodyTable {
                name: "hand",
                output: Some(8),
                outlines: &[OutlineTable {
                    material: Material::Finger,
                    is_closed: true,
                    points: (236, 24),
                    modes: &[],
                }],
            },
        ],
        springs: &[SpringTable { name: "k", from: (1, 284), to: (3, 286), modes: &[] }],
    },
};

/// The model's arithmetic.
#[derive(Clone, Copy, Debug, Default)]
pub struct CartPendulumFunctions;

impl Functions for CartPendulumFunctions {
    fn call(&self, function: FunctionId, given: &Arguments<'_>, out: &mut [f64]) {
        let done = match function {
            0 => derivative_free(given, out),
            1 => function_1(given, out),
            2 => jacobian_free(given, out),
            3 => readout_free(given, out),
            4 => slopes_free(given, out),
            5 => outputs_free(given, out),
            6 => balance_free(given, out),
            7 => reset_0_left_free(given, out),
            8 => function_8(given, out),
            9 => function_9(given, out),
            10 => speed_left_free(given, out),
            11 => guard_left_free(given, out),
            12 => bound_left_free(given, out),
            13 => function_13(given, out),
            14 => guard_right_free(given, out),
            15 => series_start_free(given, out),
            16 => series_step_free(given, out),
            17 => derivative_left(given, out),
            18 => slaved_left(given, out),
            19 => jacobian_left(given, out),
            20 => readout_left(given, out),
            21 => outputs_left(given, out),
            22 => balance_left(given, out),
            23 => reset_0_off_left(given, out),
            24 => guard_off_left(given, out),
            25 => bound_off_left(given, out),
            26 => series_start_left(given, out),
            27 => series_step_left(given, out),
            28 => function_28(given, out),
            29 => slaved_right(given, out),
            30 => readout_right(given, out),
            31 => outputs_right(given, out),
            32 => balance_right(given, out),
            33 => reset_0_off_right(given, out),
            34 => guard_off_right(given, out),
            35 => series_start_right(given, out),
            36 => series_step_right(given, out),
            37 => drawing(given, out),
            38 => preset_default(given, out),
            39 => preset_key(given, out),
            40 => requirement_0(given, out),
            41 => input_per_metre(given, out),
            42 => rest(given, out),
            43 => derived_constants(given, out),
            _ => return,
        };
        if done.is_none() {
            out.fill(f64::NAN);
        }
    }

    #[inline(always)]
    fn derivative(&self, function: FunctionId, given: &Arguments<'_>, out: &mut [f64]) {
        let done = match function {
            0 => derivative_free(given, out),
            17 => derivative_left(given, out),
            _ => None,
        };
        if done.is_none() {
            out.fill(f64::NAN);
        }
    }

    #[inline(always)]
    fn readout(&self, function: FunctionId, given: &Arguments<'_>, out: &mut [f64]) {
        let done = match function {
            3 => readout_free(given, out),
            20 => readout_left(given, out),
            30 => readout_right(given, out),
            _ => None,
        };
        if done.is_none() {
            out.fill(f64::NAN);
        }
    }

    #[inline(always)]
    fn guard(&self, function: FunctionId, given: &Arguments<'_>, out: &mut [f64]) {
        let done = match function {
            11 => guard_left_free(given, out),
            14 => guard_right_free(given, out),
            24 => guard_off_left(given, out),
            34 => guard_off_right(given, out),
            _ => None,
        };
        if done.is_none() {
            out.fill(f64::NAN);
        }
    }

    #[inline(always)]
    fn bound(&self, function: FunctionId, given: &Arguments<'_>, out: &mut [f64]) {
        let done = match function {
            12 => bound_left_free(given, out),
            25 => bound_off_left(given, out),
            _ => None,
        };
        if done.is_none() {
            out.fill(f64::NAN);
        }
    }
}

/// The derivative of the state in mode free.
#[inline(always)]
fn derivative_free(given: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let constants = given.constants.first_chunk::<17>()?;
    let state = given.state.first_chunk::<4>()?;
    let input = given.input;
    let k = constants[5];
    let b = constants[6];
    let c11 = constants[11];
    let c12 = constants[12];
    let c13 = constants[13];
    let c14 = constants[14];
    let c15 = constants[15];
    let c16 = constants[16];
    let x = state[0];
    let theta = state[1];
    let x_dot = state[2];
    let theta_dot = state[3];
    let s = input[0];
    let s_rate = input[1];
    let (sin_theta, cos_theta) = math::sin_cos(theta);
    let v0 = k * (s - x) + b * (s_rate - x_dot) + c11 * (theta_dot * theta_dot) * sin_theta;
    let v1 = c15 * cos_theta;
    let v2 = -(c12 * sin_theta + v1 * v0) * (1.0 / (c14 - c13 * (cos_theta * cos_theta)));
    let out = out.first_chunk_mut::<4>()?;
    [out[0], out[1]] = [x_dot, theta_dot];
    out[2] = c16 * v0 - v1 * v2;
    out[3] = v2;
    Some(())
}

/// Is not used by the table.
fn function_1(given: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let constants = given.constants.first_chunk::<7>()?;
    let b = constants[6];
    let out = out.first_chunk_mut::<1>()?;
    out[0] = b * b;
    Some(())
}

/// The derivative's derivative by the state in mode free.
fn jacobian_free(given: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let constants = given.constants.first_chunk::<24>()?;
    let state = given.state.first_chunk::<4>()?;
    let input = given.input;
    let k = constants[5];
    let b = constants[6];
    let c11 = constants[11];
    let c12 = constants[12];
    let c13 = constants[13];
    let c14 = constants[14];
    let c15 = constants[15];
    let c17 = constants[17];
    let c18 = constants[18];
    let c19 = constants[19];
    let c20 = constants[20];
    let c21 = constants[21];
    let c22 = constants[22];
    let c23 = constants[23];
    let x = state[0];
    let theta = state[1];
    let x_dot = state[2];
    let theta_dot = state[3];
    let s = input[0];
    let s_rate = input[1];
    let (sin_theta, cos_theta) = math::sin_cos(theta);
    let v0 = 1.0 / (c14 - c13 * (cos_theta * cos_theta));
    let v1 = cos_theta * v0;
    let v2 = cos_theta * v1;
    let v3 = theta_dot * sin_theta;
    let v4 = k * (s - x) + b * (s_rate - x_dot) + theta_dot * c11 * v3;
    let v5 = c15 * v4;
    let v6 = sin_theta * -(c12 * sin_theta + cos_theta * v5);
    let v7 = v6 * v1;
    let v8 = c12 + theta_dot * (c13 * (theta_dot * cos_theta));
    let v9 = sin_theta * v5 + cos_theta * -v8;
    let v10 = theta_dot * (theta_dot * c15) + v0 * (2.0 * (c20 * v7) - c15 * v9);
    let v11 = theta_dot * (sin_theta * (2.0 * (c15 + c20 * v2)));
    let out = out.first_chunk_mut::<16>()?;
    [out[0], out[1], out[2], out[3], out[4], out[5], out[6]] = [0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0];
    out[7] = 1.0;
    out[8] = -(c18 + c17 * v2);
    out[9] = v6 * (c15 * v0) + cos_theta * v10;
    out[10] = -(c22 + c21 * v2);
    [out[11], out[12]] = [v11, c19 * v1];
    out[13] = v0 * (v9 - 2.0 * (c13 * v7));
    out[14] = c23 * v1;
    out[15] = -(2.0 * (c13 * v3 * v1));
    Some(())
}

/// The readout in mode free.
#[inline(always)]
fn readout_free(given: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let constants = given.constants.first_chunk::<7>()?;
    let state = given.state.first_chunk::<3>()?;
    let input = given.input;
    let k = constants[5];
    let b = constants[6];
    let x = state[0];
    let x_dot = state[2];
    let s = input[0];
    let s_rate = input[1];
    let out = out.first_chunk_mut::<1>()?;
    out[0] = k * (s - x) + b * (s_rate - x_dot);
    Some(())
}

/// The readout's slopes in mode free.
fn slopes_free(given: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let constants = given.constants.first_chunk::<7>()?;
    let k = constants[5];
    let b = constants[6];
    let out = out.first_chunk_mut::<2>()?;
    [out[0], out[1]] = [k, b];
    Some(())
}

/// The outputs in mode free.
fn outputs_free(given: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let constants = given.constants.first_chunk::<26>()?;
    let state = given.state.first_chunk::<3>()?;
    let input = given.input;
    let k = constants[5];
    let b = constants[6];
    let c24 = constants[24];
    let c25 = constants[25];
    let x = state[0];
    let theta = state[1];
    let x_dot = state[2];
    let s = input[0];
    let s_rate = input[1];
    let out = out.first_chunk_mut::<11>()?;
    out[0] = k * (s - x) + b * (s_rate - x_dot);
    [out[1], out[2], out[3], out[4], out[5], out[6], out[7]] = [0.0, x, 0.0, 0.0, x, 0.0, theta];
    [out[8], out[9], out[10]] = [s + c24, c25, 0.0];
    Some(())
}

/// Energy, supplied and dissipated power in mode free.
fn balance_free(given: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let constants = given.constants.first_chunk::<27>()?;
    let state = given.state.first_chunk::<4>()?;
    let input = given.input;
    let k = constants[5];
    let b = constants[6];
    let c11 = constants[11];
    let c12 = constants[12];
    let c14 = constants[14];
    let c26 = constants[26];
    let x = state[0];
    let theta = state[1];
    let x_dot = state[2];
    let theta_dot = state[3];
    let s = input[0];
    let s_rate = input[1];
    let cos_theta = math::sin_cos(theta).1;
    let v0 = 0.5 * (x_dot * c26) + c11 * (theta_dot * cos_theta);
    let v1 = s - x;
    let v2 = k * v1;
    let v3 = 0.5 * (theta_dot * (theta_dot * c14) + v1 * v2) - c12 * cos_theta;
    let v4 = s_rate - x_dot;
    let v5 = b * v4;
    let out = out.first_chunk_mut::<3>()?;
    out[0] = v3 + x_dot * v0;
    out[1] = s_rate * (v2 + v5);
    out[2] = v4 * v5;
    Some(())
}

/// The state after guard left in mode free.
fn reset_0_left_free(given: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let constants = given.constants.first_chunk::<31>()?;
    let state = given.state.first_chunk::<4>()?;
    let c13 = constants[13];
    let c14 = constants[14];
    let c16 = constants[16];
    let c27 = constants[27];
    let c28 = constants[28];
    let c29 = constants[29];
    let c30 = constants[30];
    let x = state[0];
    let theta = state[1];
    let x_dot = state[2];
    let theta_dot = state[3];
    let cos_theta = math::sin_cos(theta).1;
    let v0 = cos_theta * (1.0 / (c14 - c13 * (cos_theta * cos_theta)));
    let v1 = cos_theta * v0;
    let v2 = 1.0 / (c16 + c27 * v1);
    let out = out.first_chunk_mut::<5>()?;
    [out[0], out[1]] = [x, theta];
    out[2] = x_dot * (1.0 + -(c28 + c30 * v1) * v2);
    out[3] = theta_dot + c29 * v0 * (x_dot * v2);
    out[4] = 0.0;
    Some(())
}

/// Is not used by the table.
fn function_8(given: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let constants = given.constants.first_chunk::<32>()?;
    let state = given.state.first_chunk::<4>()?;
    let c13 = constants[13];
    let c14 = constants[14];
    let c15 = constants[15];
    let c16 = constants[16];
    let c27 = constants[27];
    let c28 = constants[28];
    let c30 = constants[30];
    let c31 = constants[31];
    let x = state[0];
    let theta = state[1];
    let x_dot = state[2];
    let theta_dot = state[3];
    let cos_theta = math::sin_cos(theta).1;
    let v0 = cos_theta * (1.0 / (c14 - c13 * (cos_theta * cos_theta)));
    let v1 = cos_theta * v0;
    let v2 = 1.0 / (c16 + c27 * v1);
    let out = out.first_chunk_mut::<5>()?;
    [out[0], out[1]] = [x, theta];
    out[2] = x_dot + c31 * (x_dot * (-(c28 + c30 * v1) * v2));
    out[3] = theta_dot + c15 * v0 * (x_dot * v2);
    out[4] = 0.0;
    Some(())
}

/// Is not used by the table.
fn function_9(given: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let constants = given.constants.first_chunk::<10>()?;
    let state = given.state.first_chunk::<3>()?;
    let restitution = constants[9];
    let x_dot = state[2];
    let out = out.first_chunk_mut::<2>()?;
    [out[0], out[1]] = [-x_dot, restitution];
    Some(())
}

/// The speed of what strikes at guard left in mode free.
fn speed_left_free(given: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let state = given.state.first_chunk::<3>()?;
    let x_dot = state[2];
    let out = out.first_chunk_mut::<1>()?;
    out[0] = x_dot.abs();
    Some(())
}

/// The guard and its rate: left in mode free.
#[inline(always)]
fn guard_left_free(given: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let constants = given.constants.first_chunk::<8>()?;
    let state = given.state.first_chunk::<3>()?;
    let left = constants[7];
    let x = state[0];
    let x_dot = state[2];
    let out = out.first_chunk_mut::<2>()?;
    [out[0], out[1]] = [x - left, x_dot];
    Some(())
}

/// Bounds of the guard's move and bend: left in mode free.
#[inline(always)]
fn bound_left_free(given: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let extra = given.extra.first_chunk::<3>()?;
    let out = out.first_chunk_mut::<2>()?;
    [out[0], out[1]] = [extra[0], extra[2]];
    Some(())
}

/// Is not used by the table.
fn function_13(given: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let constants = given.constants.first_chunk::<10>()?;
    let state = given.state.first_chunk::<3>()?;
    let restitution = constants[9];
    let x_dot = state[2];
    let out = out.first_chunk_mut::<2>()?;
    [out[0], out[1]] = [x_dot, restitution];
    Some(())
}

/// The guard and its rate: right in mode free.
#[inline(always)]
fn guard_right_free(given: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let constants = given.constants.first_chunk::<9>()?;
    let state = given.state.first_chunk::<3>()?;
    let right = constants[8];
    let x = state[0];
    let x_dot = state[2];
    let out = out.first_chunk_mut::<2>()?;
    [out[0], out[1]] = [right - x, -x_dot];
    Some(())
}

/// Where the Taylor series begins in mode free.
fn series_start_free(given: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let constants = given.constants.first_chunk::<17>()?;
    let state = given.state.first_chunk::<4>()?;
    let input = given.input;
    let k = constants[5];
    let b = constants[6];
    let left = constants[7];
    let right = constants[8];
    let c11 = constants[11];
    let c12 = constants[12];
    let c13 = constants[13];
    let c14 = constants[14];
    let c15 = constants[15];
    let c16 = constants[16];
    let x = state[0];
    let theta = state[1];
    let x_dot = state[2];
    let theta_dot = state[3];
    let s = input[0];
    let s_rate = input[1];
    let (sin_theta, cos_theta) = math::sin_cos(theta);
    let v0 = c11 * (theta_dot * theta_dot);
    let v1 = k * (s - x) + b * (s_rate - x_dot) + v0 * sin_theta;
    let v2 = c15 * cos_theta;
    let v3 = -(c12 * sin_theta + v2 * v1);
    let v4 = 1.0 / (c14 - c13 * (cos_theta * cos_theta));
    let v5 = v3 * v4;
    let out = out.first_chunk_mut::<17>()?;
    [out[0], out[1]] = [x_dot, theta_dot];
    out[2] = c16 * v1 - v2 * v5;
    [out[3], out[4], out[5], out[6], out[7]] = [v5, x - left, right - x, cos_theta, sin_theta];
    out[8] = theta_dot + theta_dot;
    [out[9], out[10], out[11]] = [v0, v2, v1];
    out[12] = cos_theta + cos_theta;
    [out[13], out[14], out[15], out[16]] = [v4, v4, v3, v5];
    Some(())
}

/// One order of the Taylor series in mode free.
fn series_step_free(given: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let constants = given.constants.first_chunk::<17>()?;
    let state = given.state.first_chunk::<4>()?;
    let extra = given.extra.first_chunk::<22>()?;
    let input = given.input;
    let k = constants[5];
    let b = constants[6];
    let c11 = constants[11];
    let c12 = constants[12];
    let c13 = constants[13];
    let c15 = constants[15];
    let c16 = constants[16];
    let x = state[0];
    let theta = state[1];
    let x_dot = state[2];
    let theta_dot = state[3];
    let s = input[0];
    let s_rate = input[1];
    let v0 = extra[13] * extra[1] + theta * extra[2];
    let v1 = -(extra[14] * extra[1] + theta * extra[3]);
    let v2 = c11 * (extra[15] + extra[4] * theta_dot);
    let v3 = k * (s - x) + b * (s_rate - x_dot) + (extra[16] + extra[5] * v0 + v2 * extra[3]);
    let v4 = c15 * v1;
    let v5 = c12 * v0 + (extra[17] + extra[6] * v3 + v4 * extra[7]);
    let v6 = -v5;
    let v7 = -(c13 * (extra[18] + extra[8] * v1));
    let v8 = (-extra[19] - extra[9] * v7) * extra[10];
    let v9 = extra[20] + extra[11] * v8 + v6 * extra[9];
    let v10 = c16 * v3 - (extra[21] + extra[6] * v9 + v4 * extra[12]);
    let v11 = extra[0] * theta;
    let out = out.first_chunk_mut::<24>()?;
    [out[0], out[1], out[2], out[3], out[4], out[5]] = [x_dot, theta_dot, v10, v9, x, -x];
    [out[6], out[7], out[8], out[9], out[10], out[11]] = [v11, v11, theta_dot, v2, v4, v1];
    [out[12], out[13], out[14], out[15], out[16], out[17]] = [v7, v6, v4, v1, v0, theta_dot];
    [out[18], out[19], out[20], out[21], out[22], out[23]] = [v0, v3, v1, v8, v8, v9];
    Some(())
}

/// The derivative of the state in mode left.
#[inline(always)]
fn derivative_left(given: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let constants = given.constants.first_chunk::<33>()?;
    let state = given.state.first_chunk::<4>()?;
    let c32 = constants[32];
    let theta = state[1];
    let theta_dot = state[3];
    let sin_theta = math::sin_cos(theta).0;
    let out = out.first_chunk_mut::<4>()?;
    [out[0], out[1], out[2]] = [0.0, theta_dot, 0.0];
    out[3] = -(c32 * sin_theta);
    Some(())
}

/// The state with slaved entries in place in mode left.
fn slaved_left(given: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let constants = given.constants.first_chunk::<8>()?;
    let state = given.state.first_chunk::<4>()?;
    let left = constants[7];
    let theta = state[1];
    let theta_dot = state[3];
    let out = out.first_chunk_mut::<4>()?;
    [out[0], out[1], out[2], out[3]] = [left, theta, 0.0, theta_dot];
    Some(())
}

/// The derivative's derivative by the state in mode left.
fn jacobian_left(given: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let constants = given.constants.first_chunk::<33>()?;
    let state = given.state.first_chunk::<2>()?;
    let c32 = constants[32];
    let theta = state[1];
    let cos_theta = math::sin_cos(theta).1;
    let out = out.first_chunk_mut::<16>()?;
    [out[0], out[1], out[2], out[3], out[4], out[5], out[6]] = [0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0];
    [out[7], out[8], out[9], out[10], out[11], out[12]] = [1.0, 0.0, 0.0, 0.0, 0.0, 0.0];
    out[13] = -(c32 * cos_theta);
    [out[14], out[15]] = [0.0, 0.0];
    Some(())
}

/// The readout in mode left.
#[inline(always)]
fn readout_left(given: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let constants = given.constants.first_chunk::<8>()?;
    let input = given.input;
    let k = constants[5];
    let b = constants[6];
    let left = constants[7];
    let s = input[0];
    let s_rate = input[1];
    let out = out.first_chunk_mut::<1>()?;
    out[0] = s_rate * b + k * (s - left);
    Some(())
}

/// The outputs in mode left.
fn outputs_left(given: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let constants = given.constants.first_chunk::<34>()?;
    let state = given.state.first_chunk::<4>()?;
    let input = given.input;
    let k = constants[5];
    let b = constants[6];
    let left = constants[7];
    let c11 = constants[11];
    let c24 = constants[24];
    let c25 = constants[25];
    let c33 = constants[33];
    let theta = state[1];
    let theta_dot = state[3];
    let s = input[0];
    let s_rate = input[1];
    let v0 = s_rate * b + k * (s - left);
    let (sin_theta, cos_theta) = math::sin_cos(theta);
    let v1 = -(theta_dot * (theta_dot * c11) + c33 * cos_theta);
    let out = out.first_chunk_mut::<11>()?;
    out[0] = v0;
    out[1] = sin_theta * v1 - v0;
    [out[2], out[3], out[4], out[5], out[6], out[7]] = [left, 0.0, 0.0, left, 0.0, theta];
    [out[8], out[9], out[10]] = [s + c24, c25, 0.0];
    Some(())
}

/// Energy, supplied and dissipated power in mode left.
fn balance_left(given: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let constants = given.constants.first_chunk::<15>()?;
    let state = given.state.first_chunk::<4>()?;
    let input = given.input;
    let k = constants[5];
    let b = constants[6];
    let left = constants[7];
    let c12 = constants[12];
    let c14 = constants[14];
    let theta = state[1];
    let theta_dot = state[3];
    let s = input[0];
    let s_rate = input[1];
    let v0 = s - left;
    let v1 = k * v0;
    let cos_theta = math::sin_cos(theta).1;
    let v2 = 0.5 * (c14 * (theta_dot * theta_dot) + v0 * v1) - c12 * cos_theta;
    let v3 = s_rate * b;
    let out = out.first_chunk_mut::<3>()?;
    out[0] = v2;
    out[1] = s_rate * (v3 + v1);
    out[2] = s_rate * v3;
    Some(())
}

/// The state after guard off in mode left.
fn reset_0_off_left(given: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let constants = given.constants.first_chunk::<8>()?;
    let state = given.state.first_chunk::<4>()?;
    let left = constants[7];
    let theta = state[1];
    let theta_dot = state[3];
    let out = out.first_chunk_mut::<5>()?;
    [out[0], out[1], out[2], out[3], out[4]] = [left, theta, 0.0, theta_dot, 0.0];
    Some(())
}

/// The guard and its rate: off in mode left.
#[inline(always)]
fn guard_off_left(given: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let constants = given.constants.first_chunk::<34>()?;
    let state = given.state.first_chunk::<4>()?;
    let input = given.input;
    let k = constants[5];
    let b = constants[6];
    let left = constants[7];
    let c11 = constants[11];
    let c33 = constants[33];
    let theta = state[1];
    let theta_dot = state[3];
    let s = input[0];
    let s_rate = input[1];
    let s_rate2 = input[2];
    let (sin_theta, cos_theta) = math::sin_cos(theta);
    let v0 = -(theta_dot * (theta_dot * c11) + c33 * cos_theta);
    let v1 = 3.0 * (sin_theta * (c33 * sin_theta)) + cos_theta * v0;
    let out = out.first_chunk_mut::<2>()?;
    out[0] = sin_theta * v0 - (s_rate * b + k * (s - left));
    out[1] = theta_dot * v1 - (b * s_rate2 + k * s_rate);
    Some(())
}

/// Bounds of the guard's move and bend: off in mode left.
#[inline(always)]
fn bound_off_left(given: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let constants = given.constants.first_chunk::<42>()?;
    let state = given.state.first_chunk::<4>()?;
    let extra = given.extra.first_chunk::<15>()?;
    let input = given.input;
    let c11 = constants[11];
    let c33 = constants[33];
    let c34 = constants[34];
    let c35 = constants[35];
    let c36 = constants[36];
    let c37 = constants[37];
    let c38 = constants[38];
    let c39 = constants[39];
    let c40 = constants[40];
    let c41 = constants[41];
    let theta = state[1];
    let theta_dot = state[3];
    let s_rate = input[1];
    let s_rate2 = input[2];
    let s_rate3 = input[3];
    let (sin_theta, cos_theta) = math::sin_cos(theta);
    let v0 = theta_dot * c11;
    let v1 = theta_dot * v0;
    let v2 = c33 * cos_theta;
    let v3 = cos_theta * (v1 + v2) - sin_theta * (c33 * sin_theta);
    let v4 = sin_theta.abs();
    let v5 = 0.5 * extra[4];
    let v6 = functions::smaller(v5 + v4, 1.0);
    let v7 = v1.abs();
    let v8 = cos_theta.abs();
    let v9 = extra[4] * v6;
    let v10 = functions::smaller(v8 + v9, 1.0);
    let v11 = functions::smaller(v5 + v8, 1.0);
    let v12 = extra[4] * v11;
    let v13 = functions::smaller(v4 + v12, 1.0);
    let v14 = v11 * (c35 * (v4 + v13)) + v6 * (v7 + c35 * (v8 + v10));
    let v15 = extra[12] + 2.0 * theta_dot.abs();
    let v16 = extra[12] * c34;
    let v17 = v16 * v10;
    let v18 = v3.abs() + v15 * v17 + extra[4] * v14;
    let v19 = v16 * v13;
    let v20 = v0.abs();
    let v21 = (2.0 * (v0 * sin_theta)).abs() + 2.0 * (v20 * v12 + v19);
    let v22 = extra[3] * (s_rate * c40 + s_rate2 * c41) + extra[12] * v21;
    let v23 = extra[3] * extra[3] * (c40 * s_rate2 + c41 * s_rate3);
    let v24 = extra[4] * ((c36 * sin_theta).abs() * v6 + v11 * (c37 * v10));
    let v25 = (sin_theta * (v1 + 4.0 * v2)).abs() + v7 * v12 + v15 * v19;
    let v26 = (2.0 * (v0 * cos_theta)).abs() + 2.0 * (v20 * v9 + v17);
    let v27 = 2.0 * (extra[13] * v26) + extra[5] * (v25 + 4.0 * (c38 * v24));
    let v28 = (2.0 * (c11 * sin_theta)).abs() + 2.0 * (c39 * v12);
    let v29 = v23 + extra[13] * (extra[13] * v28) + extra[14] * v21;
    let out = out.first_chunk_mut::<2>()?;
    out[0] = v22 + extra[4] * v18;
    out[1] = v29 + extra[6] * v18 + extra[5] * v27;
    Some(())
}

/// Where the Taylor series begins in mode left.
fn series_start_left(given: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let constants = given.constants.first_chunk::<34>()?;
    let state = given.state.first_chunk::<4>()?;
    let input = given.input;
    let k = constants[5];
    let b = constants[6];
    let left = constants[7];
    let c11 = constants[11];
    let c32 = constants[32];
    let c33 = constants[33];
    let theta = state[1];
    let theta_dot = state[3];
    let s = input[0];
    let s_rate = input[1];
    let (sin_theta, cos_theta) = math::sin_cos(theta);
    let v0 = theta_dot * c11;
    let v1 = -(theta_dot * v0 + c33 * cos_theta);
    let out = out.first_chunk_mut::<10>()?;
    out[0] = theta_dot;
    out[1] = -(c32 * sin_theta);
    [out[2], out[3]] = [left, 0.0];
    out[4] = sin_theta * v1 - (s_rate * b + k * (s - left));
    [out[5], out[6], out[7], out[8], out[9]] = [cos_theta, sin_theta, theta_dot, v0, v1];
    Some(())
}

/// One order of the Taylor series in mode left.
fn series_step_left(given: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let constants = given.constants.first_chunk::<34>()?;
    let state = given.state.first_chunk::<4>()?;
    let extra = given.extra.first_chunk::<11>()?;
    let input = given.input;
    let k = constants[5];
    let b = constants[6];
    let c11 = constants[11];
    let c32 = constants[32];
    let c33 = constants[33];
    let theta = state[1];
    let theta_dot = state[3];
    let s = input[0];
    let s_rate = input[1];
    let v0 = extra[7] * extra[1] + theta * extra[2];
    let v1 = -(extra[8] * extra[1] + theta * extra[3]);
    let v2 = c11 * theta_dot;
    let v3 = extra[9] + extra[4] * v2 + theta_dot * extra[5] + c33 * v1;
    let v4 = -v3;
    let v5 = extra[10] + extra[3] * v4 + v0 * extra[6] - (b * s_rate + k * s);
    let v6 = extra[0] * theta;
    let out = out.first_chunk_mut::<13>()?;
    [out[0], out[1], out[2], out[3], out[4], out[5]] = [theta_dot, -(c32 * v0), 0.0, 0.0, v5, v6];
    [out[6], out[7], out[8], out[9], out[10], out[11]] = [v6, theta_dot, v0, v1, v0, v2];
    out[12] = v4;
    Some(())
}

/// Is not used by the table.
fn function_28(_: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let out = out.first_chunk_mut::<1>()?;
    out[0] = 0.0001;
    Some(())
}

/// The state with slaved entries in place in mode right.
fn slaved_right(given: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let constants = given.constants.first_chunk::<9>()?;
    let state = given.state.first_chunk::<4>()?;
    let right = constants[8];
    let theta = state[1];
    let theta_dot = state[3];
    let out = out.first_chunk_mut::<4>()?;
    [out[0], out[1], out[2], out[3]] = [right, theta, 0.0, theta_dot];
    Some(())
}

/// The readout in mode right.
#[inline(always)]
fn readout_right(given: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let constants = given.constants.first_chunk::<9>()?;
    let input = given.input;
    let k = constants[5];
    let b = constants[6];
    let right = constants[8];
    let s = input[0];
    let s_rate = input[1];
    let out = out.first_chunk_mut::<1>()?;
    out[0] = s_rate * b + k * (s - right);
    Some(())
}

/// The outputs in mode right.
fn outputs_right(given: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let constants = given.constants.first_chunk::<34>()?;
    let state = given.state.first_chunk::<4>()?;
    let input = given.input;
    let k = constants[5];
    let b = constants[6];
    let right = constants[8];
    let c11 = constants[11];
    let c24 = constants[24];
    let c25 = constants[25];
    let c33 = constants[33];
    let theta = state[1];
    let theta_dot = state[3];
    let s = input[0];
    let s_rate = input[1];
    let v0 = s_rate * b + k * (s - right);
    let (sin_theta, cos_theta) = math::sin_cos(theta);
    let v1 = sin_theta * (theta_dot * (theta_dot * c11) + c33 * cos_theta);
    let out = out.first_chunk_mut::<11>()?;
    [out[0], out[1], out[2], out[3], out[4], out[5]] = [v0, v0 + v1, right, 0.0, 0.0, right];
    [out[6], out[7], out[8], out[9], out[10]] = [0.0, theta, s + c24, c25, 0.0];
    Some(())
}

/// Energy, supplied and dissipated power in mode right.
fn balance_right(given: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let constants = given.constants.first_chunk::<15>()?;
    let state = given.state.first_chunk::<4>()?;
    let input = given.input;
    let k = constants[5];
    let b = constants[6];
    let right = constants[8];
    let c12 = constants[12];
    let c14 = constants[14];
    let theta = state[1];
    let theta_dot = state[3];
    let s = input[0];
    let s_rate = input[1];
    let v0 = s - right;
    let v1 = k * v0;
    let cos_theta = math::sin_cos(theta).1;
    let v2 = 0.5 * (c14 * (theta_dot * theta_dot) + v0 * v1) - c12 * cos_theta;
    let v3 = s_rate * b;
    let out = out.first_chunk_mut::<3>()?;
    out[0] = v2;
    out[1] = s_rate * (v3 + v1);
    out[2] = s_rate * v3;
    Some(())
}

/// The state after guard off in mode right.
fn reset_0_off_right(given: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let constants = given.constants.first_chunk::<9>()?;
    let state = given.state.first_chunk::<4>()?;
    let right = constants[8];
    let theta = state[1];
    let theta_dot = state[3];
    let out = out.first_chunk_mut::<5>()?;
    [out[0], out[1], out[2], out[3], out[4]] = [right, theta, 0.0, theta_dot, 0.0];
    Some(())
}

/// The guard and its rate: off in mode right.
#[inline(always)]
fn guard_off_right(given: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let constants = given.constants.first_chunk::<34>()?;
    let state = given.state.first_chunk::<4>()?;
    let input = given.input;
    let k = constants[5];
    let b = constants[6];
    let right = constants[8];
    let c11 = constants[11];
    let c33 = constants[33];
    let theta = state[1];
    let theta_dot = state[3];
    let s = input[0];
    let s_rate = input[1];
    let s_rate2 = input[2];
    let (sin_theta, cos_theta) = math::sin_cos(theta);
    let v0 = theta_dot * (theta_dot * c11) + c33 * cos_theta;
    let v1 = cos_theta * v0 - 3.0 * (sin_theta * (c33 * sin_theta));
    let out = out.first_chunk_mut::<2>()?;
    out[0] = s_rate * b + k * (s - right) + sin_theta * v0;
    out[1] = b * s_rate2 + s_rate * k + theta_dot * v1;
    Some(())
}

/// Where the Taylor series begins in mode right.
fn series_start_right(given: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let constants = given.constants.first_chunk::<34>()?;
    let state = given.state.first_chunk::<4>()?;
    let input = given.input;
    let k = constants[5];
    let b = constants[6];
    let right = constants[8];
    let c11 = constants[11];
    let c32 = constants[32];
    let c33 = constants[33];
    let theta = state[1];
    let theta_dot = state[3];
    let s = input[0];
    let s_rate = input[1];
    let (sin_theta, cos_theta) = math::sin_cos(theta);
    let v0 = theta_dot * c11;
    let v1 = theta_dot * v0 + c33 * cos_theta;
    let out = out.first_chunk_mut::<10>()?;
    out[0] = theta_dot;
    out[1] = -(c32 * sin_theta);
    [out[2], out[3]] = [right, 0.0];
    out[4] = s_rate * b + k * (s - right) + sin_theta * v1;
    [out[5], out[6], out[7], out[8], out[9]] = [cos_theta, sin_theta, theta_dot, v0, v1];
    Some(())
}

/// One order of the Taylor series in mode right.
fn series_step_right(given: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let constants = given.constants.first_chunk::<34>()?;
    let state = given.state.first_chunk::<4>()?;
    let extra = given.extra.first_chunk::<11>()?;
    let input = given.input;
    let k = constants[5];
    let b = constants[6];
    let c11 = constants[11];
    let c32 = constants[32];
    let c33 = constants[33];
    let theta = state[1];
    let theta_dot = state[3];
    let s = input[0];
    let s_rate = input[1];
    let v0 = extra[7] * extra[1] + theta * extra[2];
    let v1 = -(extra[8] * extra[1] + theta * extra[3]);
    let v2 = c11 * theta_dot;
    let v3 = extra[9] + extra[4] * v2 + theta_dot * extra[5] + c33 * v1;
    let v4 = b * s_rate + k * s + (extra[10] + extra[3] * v3 + v0 * extra[6]);
    let v5 = extra[0] * theta;
    let out = out.first_chunk_mut::<13>()?;
    [out[0], out[1], out[2], out[3], out[4], out[5]] = [theta_dot, -(c32 * v0), 0.0, 0.0, v4, v5];
    [out[6], out[7], out[8], out[9], out[10], out[11]] = [v5, theta_dot, v0, v1, v0, v2];
    out[12] = v3;
    Some(())
}

/// The numbers of the drawing.
fn drawing(given: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let constants = given.constants.first_chunk::<11>()?;
    let length = constants[2];
    let left = constants[7];
    let right = constants[8];
    let scale = constants[10];
    let v0 = 1.09 * length;
    let v1 = functions::smaller(left, right) - functions::larger(v0, 0.375 * length);
    let v2 = functions::larger(functions::larger(left, right), 0.0);
    let v3 = 0.012 * (scale.abs() + functions::larger(-scale, 0.0));
    let v4 = functions::larger(right + v0, 0.9 * length + v3 + v2);
    let v5 = 0.224_999_999_999_999_98 * length;
    let v6 = left - v5;
    let v7 = 0.09 * length;
    let v8 = -v7;
    let v9 = 0.15 * length;
    let v10 = left - v9;
    let v11 = 0.105 * length;
    let v12 = right + v9;
    let v13 = right + v5;
    let v14 = -v9;
    let v15 = -(0.045 * length);
    let v16 = 0.12 * length;
    let v17 = 0.21 * length;
    let v18 = 0.0525 * length;
    let v19 = -v18;
    let v20 = 0.053_777_781_514_159_94 * length;
    let v21 = -v20;
    let v22 = -(0.042_794_285_808_655_47 * length);
    let v23 = 0.057_524_047_358_083_54 * length;
    let v24 = -(0.033_749_999_999_999_995 * length);
    let v25 = 0.063_483_495_705_504_46 * length;
    let v26 = -v25;
    let v27 = -(0.025_983_495_705_504_466 * length);
    let v28 = -(0.07125 * length);
    let v29 = -(0.020_024_047_358_083_55 * length);
    let v30 = 0.080_294_285_808_655_47 * length;
    let v31 = -(0.016_277_781_514_159_935 * length);
    let v32 = -(0.014_999_999_999_999_996 * length);
    let v33 = 0.099_705_714_191_344_52 * length;
    let v34 = -v33;
    let v35 = -(0.020_024_047_358_083_545 * length);
    let v36 = 0.116_516_504_294_495_52 * length;
    let v37 = -(0.025_983_495_705_504_463 * length);
    let v38 = 0.122_475_952_641_916_45 * length;
    let v39 = -v38;
    let v40 = 0.126_222_218_485_840_06 * length;
    let v41 = -v40;
    let v42 = -(0.042_794_285_808_655_456 * length);
    let v43 = 0.1275 * length;
    let v44 = -(0.052_499_999_999_999_984 * length);
    let v45 = -(0.062_205_714_191_344_52 * length);
    let v46 = 0.071_249_999_999_999_98 * length;
    let v47 = -v46;
    let v48 = -(0.079_016_504_294_495_51 * length);
    let v49 = -(0.084_975_952_641_916_43 * length);
    let v50 = -(0.088_722_218_485_840_05 * length);
    let v51 = -(0.084_975_952_641_916_44 * length);
    let v52 = -(0.079_016_504_294_495_53 * length);
    let v53 = 0.071_250_000_000_000_01 * length;
    let v54 = -v53;
    let v55 = -(0.062_205_714_191_344_554 * length);
    let v56 = 0.10875 * length;
    let v57 = -length;
    let v58 = 0.018 * length;
    let v59 = 0.017_386_664_873_203_228 * length;
    let v60 = 0.004_658_742_811_845_373 * length;
    let v61 = 0.015_588_457_268_119_896 * length;
    let v62 = 0.008_999_999_999_999_998 * length;
    let v63 = 0.012_727_922_061_357_855 * length;
    let v64 = 0.012_727_922_061_357_854 * length;
    let v65 = 0.009_000_000_000_000_001 * length;
    let v66 = 0.015_588_457_268_119_894 * length;
    let v67 = -(0.004_658_742_811_845_371 * length);
    let v68 = 0.017_386_664_873_203_225 * length;
    let v69 = -v58;
    let v70 = -v59;
    let v71 = -(0.009_000_000_000_000_008 * length);
    let v72 = 0.015_588_457_268_119_89 * length;
    let v73 = 0.075 * length;
    let v74 = 0.072_444_436_971_680_13 * length;
    let v75 = -(0.980_588_571_617_311 * length);
    let v76 = 0.064_951_905_283_832_9 * length;
    let v77 = -(0.9625 * length);
    let v78 = 0.053_033_008_588_991_064 * length;
    let v79 = -(0.946_966_991_411_008_9 * length);
    let v80 = 0.037_500_000_000_000_006 * length;
    let v81 = -(0.935_048_094_716_167_1 * length);
    let v82 = 0.019_411_428_382_689_055 * length;
    let v83 = -(0.927_555_563_028_319_9 * length);
    let v84 = 4.592_425_496_802_574e-18 * length;
    let v85 = -(0.019_411_428_382_689_045 * length);
    let v86 = -(0.037_499_999_999_999_985 * length);
    let v87 = 0.053_033_008_588_991_06 * length;
    let v88 = -v87;
    let v89 = -v76;
    let v90 = -(0.072_444_436_971_680_11 * length);
    let v91 = -v73;
    let v92 = -v74;
    let v93 = -(1.019_411_428_382_689_2 * length);
    let v94 = -(f64::from_bits(0x3ff0_9999_9999_999a) * length);
    let v95 = -(0.053_033_008_588_991_09 * length);
    let v96 = -(f64::from_bits(0x3ff0_d939_23d7_f8a4) * length);
    let v97 = -(0.037_500_000_000_000_03 * length);
    let v98 = -(1.064_951_905_283_833 * length);
    let v99 = -(1.072_444_436_971_680_1 * length);
    let v100 = -(1.377_727_649_040_772_2e-17 * length);
    let v101 = 0.019_411_428_382_689_02 * length;
    let v102 = 0.053_033_008_588_991_05 * length;
    let v103 = -(f64::from_bits(0x3ff0_d939_23d7_f8a5) * length);
    let v104 = 0.064_951_905_283_832_88 * length;
    let v105 = 0.072_444_436_971_680_1 * length;
    let v106 = 0.037_499_999_999_999_99 * length;
    let v107 = 0.064_951_905_283_832_89 * length;
    let out = out.first_chunk_mut::<288>()?;
    out[0] = v1;
    out[1] = -(1.165 * length);
    out[2] = v4;
    out[3] = 0.449_999_999_999_999_96 * length;
    [out[4], out[5], out[6], out[7], out[8], out[9], out[10]] = [v6, v8, v10, v8, v10, v11, v6];
    [out[11], out[12], out[13], out[14], out[15], out[16]] = [v11, v12, v8, v13, v8, v13];
    [out[17], out[18], out[19], out[20], out[21], out[22]] = [v11, v12, v11, v10, v8, v12];
    [out[23], out[24], out[25], out[26], out[27], out[28]] = [v8, v14, v15, v9, v15, v9];
    [out[29], out[30], out[31], out[32], out[33], out[34]] = [v7, v14, v7, v16, v7, v9];
    [out[35], out[36], out[37], out[38], out[39], out[40]] = [v7, v9, v17, v16, v17, v19];
    [out[41], out[42], out[43], out[44], out[45], out[46]] = [v19, v21, v22, -v23, v24, v26];
    [out[47], out[48], out[49], out[50], out[51], out[52]] = [v27, v28, v29, -v30, v31, v8];
    [out[53], out[54], out[55]] = [v32, v34, v31];
    out[56] = -(0.108_749_999_999_999_97 * length);
    [out[57], out[58], out[59], out[60], out[61], out[62]] = [v35, -v36, v37, v39, v24, v41];
    [out[63], out[64], out[65], out[66], out[67], out[68]] = [v42, -v43, v44, v41, v45, v39];
    out[69] = v47;
    out[70] = -(0.116_516_504_294_495_53 * length);
    out[71] = v48;
    out[72] = -(0.108_750_000_000_000_01 * length);
    [out[73], out[74], out[75], out[76], out[77]] = [v49, v34, v50, v8, v8];
    out[78] = -(0.080_294_285_808_655_48 * length);
    [out[79], out[80], out[81], out[82], out[83]] = [v50, v28, v51, v26, v52];
    out[84] = -(0.057_524_047_358_083_56 * length);
    [out[85], out[86], out[87], out[88], out[89], out[90]] = [v54, v21, v55, v43, v19, v40];
    [out[91], out[92], out[93], out[94], out[95], out[96]] = [v22, v38, v24, v36, v27, v56];
    [out[97], out[98], out[99], out[100], out[101], out[102]] = [v29, v33, v31, v7, v32, v30];
    [out[103], out[104], out[105], out[106], out[107], out[108]] = [v31, v53, v35, v25, v37, v23];
    [out[109], out[110], out[111], out[112], out[113], out[114]] = [v24, v20, v42, v18, v44, v20];
    [out[115], out[116], out[117]] = [v45, v23, v47];
    out[118] = 0.063_483_495_705_504_45 * length;
    [out[119], out[120], out[121], out[122], out[123], out[124]] = [v48, v46, v49, v30, v50, v7];
    out[125] = v8;
    out[126] = 0.099_705_714_191_344_51 * length;
    [out[127], out[128], out[129], out[130], out[131]] = [v50, v56, v51, v36, v52];
    out[132] = 0.122_475_952_641_916_44 * length;
    [out[133], out[134], out[135], out[136], out[137], out[138]] = [v54, v40, v55, 0.0, 0.0, 0.0];
    [out[139], out[140], out[141], out[142], out[143], out[144]] = [v57, v58, 0.0, v59, v60, v61];
    [out[145], out[146], out[147], out[148], out[149], out[150]] = [v62, v63, v64, v65, v66, v60];
    out[151] = v59;
    out[152] = 1.102_182_119_232_617_8e-18 * length;
    [out[153], out[154], out[155]] = [v58, v67, v59];
    out[156] = -(0.008_999_999_999_999_996 * length);
    [out[157], out[158], out[159], out[160], out[161]] = [v61, -v64, v63, -v61, v62];
    out[162] = -v68;
    out[163] = 0.004_658_742_811_845_378 * length;
    out[164] = v69;
    out[165] = 2.204_364_238_465_235_5e-18 * length;
    out[166] = v70;
    out[167] = -(0.004_658_742_811_845_374 * length);
    out[168] = -(0.015_588_457_268_119_898 * length);
    out[169] = -(0.008_999_999_999_999_994 * length);
    out[170] = -(0.012_727_922_061_357_86 * length);
    out[171] = -(0.012_727_922_061_357_847 * length);
    [out[172], out[173], out[174], out[175]] = [v71, -v72, v67, v70];
    out[176] = -(3.306_546_357_697_853_3e-18 * length);
    out[177] = v69;
    out[178] = 0.004_658_742_811_845_365 * length;
    out[179] = -(0.017_386_664_873_203_23 * length);
    [out[180], out[181]] = [v65, -v66];
    out[182] = 0.012_727_922_061_357_852 * length;
    out[183] = -(0.012_727_922_061_357_857 * length);
    [out[184], out[185], out[186]] = [v72, v71, v68];
    out[187] = -(0.004_658_742_811_845_388 * length);
    [out[188], out[189], out[190], out[191], out[192], out[193]] = [v73, v57, v74, v75, v76, v77];
    [out[194], out[195], out[196], out[197], out[198], out[199]] = [v78, v79, v80, v81, v82, v83];
    out[200] = v84;
    out[201] = -(0.925 * length);
    [out[202], out[203], out[204], out[205], out[206], out[207]] = [v85, v83, v86, v81, v88, v79];
    [out[208], out[209], out[210], out[211], out[212], out[213]] = [v89, v77, v90, v75, v91, v57];
    [out[214], out[215], out[216], out[217], out[218], out[219]] = [v92, v93, v89, v94, v95, v96];
    [out[220], out[221], out[222], out[223], out[224]] = [v97, v98, v85, v99, v100];
    out[225] = -(1.075 * length);
    [out[226], out[227], out[228], out[229], out[230]] = [v101, v99, v80, v98, v102];
    [out[231], out[232], out[233], out[234], out[235]] = [v103, v104, v94, v105, v93];
    [out[236], out[237], out[238], out[239], out[240], out[241]] = [v73, 0.0, v74, v82, v76, v106];
    [out[242], out[243], out[244], out[245], out[246], out[247]] = [v78, v87, v80, v107, v82, v74];
    [out[248], out[249], out[250], out[251], out[252], out[253]] = [v84, v73, v85, v74, v86, v76];
    [out[254], out[255], out[256], out[257], out[258]] = [v88, v78, v89, v106, v90];
    out[259] = 0.019_411_428_382_689_076 * length;
    out[260] = v91;
    out[261] = 9.184_850_993_605_149e-18 * length;
    out[262] = v92;
    out[263] = -(0.019_411_428_382_689_06 * length);
    out[264] = v89;
    out[265] = -(0.037_499_999_999_999_98 * length);
    out[266] = v95;
    out[267] = -(0.053_033_008_588_991_036 * length);
    [out[268], out[269], out[270], out[271], out[272]] = [v97, -v104, v85, v92, v100];
    [out[273], out[274], out[275], out[276], out[277]] = [v91, v101, v92, v80, -v107];
    out[278] = v102;
    out[279] = -(0.053_033_008_588_991_08 * length);
    [out[280], out[281], out[282]] = [v104, v97, v105];
    out[283] = -(0.019_411_428_382_689_118 * length);
    out[284] = v9;
    out[285] = 0.18 * length;
    [out[286], out[287]] = [v91, 0.0];
    Some(())
}

/// The preset default.
fn preset_default(_: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let out = out.first_chunk_mut::<11>()?;
    out[0] = 1.0;
    out[1] = f64::from_bits(0x3fd3_3333_3333_3333);
    [out[2], out[3], out[4], out[5], out[6], out[7]] = [0.25, 0.0, 9.81, 200.0, 0.0, -0.05];
    out[8] = 0.05;
    out[9] = f64::from_bits(0x3fe6_6666_6666_6666);
    out[10] = 1.0;
    Some(())
}

/// The preset key.
fn preset_key(_: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let out = out.first_chunk_mut::<11>()?;
    [out[0], out[1], out[2], out[3], out[4], out[5]] = [0.04, 0.02, 0.1, 0.0, 9.81, 60.0];
    out[6] = f64::from_bits(0x3fd3_3333_3333_3333);
    [out[7], out[8], out[9], out[10]] = [-0.005, 0.04, 0.6, 5.0];
    Some(())
}

/// Is positive where a condition on the parameters is met.
fn requirement_0(given: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let constants = given.constants.first_chunk::<9>()?;
    let left = constants[7];
    let right = constants[8];
    let out = out.first_chunk_mut::<1>()?;
    out[0] = right - left;
    Some(())
}

/// Input per metre of key-front travel.
fn input_per_metre(given: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let constants = given.constants.first_chunk::<11>()?;
    let scale = constants[10];
    let out = out.first_chunk_mut::<1>()?;
    out[0] = scale;
    Some(())
}

/// The state to start from.
fn rest(given: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let input = given.input;
    let s = input[0];
    let out = out.first_chunk_mut::<4>()?;
    [out[0], out[1], out[2], out[3]] = [s, 0.0, 0.0, 0.0];
    Some(())
}

/// What follows from the parameters.
fn derived_constants(given: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let constants = given.constants.first_chunk::<11>()?;
    let cart_mass = constants[0];
    let bob_mass = constants[1];
    let length = constants[2];
    let inertia = constants[3];
    let g = constants[4];
    let k = constants[5];
    let b = constants[6];
    let left = constants[7];
    let right = constants[8];
    let restitution = constants[9];
    let scale = constants[10];
    let v0 = length * bob_mass;
    let v1 = g * v0;
    let v2 = bob_mass + cart_mass;
    let v3 = 1.0 / v2;
    let v4 = v0 * v3;
    let v5 = v0 * v4;
    let v6 = inertia + length * v0;
    let v7 = k * v4;
    let v8 = b * v4;
    let v9 = functions::larger(functions::larger(left, right), 0.0);
    let v10 = f64::from_bits(0x3fe0_cccc_cccc_cccd) * length;
    let v11 = v10 + 0.012 * functions::larger(-scale, 0.0) + v9;
    let v12 = 1.0 + restitution;
    let v13 = v12 * v4;
    let v14 = 1.0 / v6;
    let v15 = v1 * v14;
    let v16 = v0 * v1;
    let v17 = v16.abs();
    let v18 = v14.abs();
    let out = out.first_chunk_mut::<31>()?;
    [out[0], out[1], out[2], out[3], out[4], out[5], out[6]] = [v0, v1, v5, v6, v4, v3, v4 * v7];
    [out[7], out[8], out[9], out[10], out[11]] = [k * v3, v7, v4 * v5, v4 * v8, b * v3];
    [out[12], out[13]] = [v8, v11];
    out[14] = 0.18 * length;
    [out[15], out[16], out[17], out[18], out[19]] = [v2, v4 * v4, v12 * v3, v13, v4 * v13];
    [out[20], out[21], out[22]] = [1.0 / v12, v15, v0 * v15];
    out[23] = length.abs() * bob_mass.abs();
    [out[24], out[25], out[26], out[27], out[28]] = [v17 * v18, v16, v17, v18, v0.abs()];
    [out[29], out[30]] = [k.abs(), b.abs()];
    Some(())
}
