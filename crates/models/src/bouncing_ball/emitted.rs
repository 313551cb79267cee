//! Emitted from `the description of bouncing-ball` by `letoff model emit`; not to be changed by hand.
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
    PartTable, PresetTable, RestTable, RestingTable, SeriesTable, WayTable,
};
use pode::{EquationKind, Fires, GuardId, GuardSpec, Part, Reads, math};

/// All of the model but its arithmetic.
pub static TABLE: ModelTable = ModelTable {
    name: "bouncing-ball",
    summary: "a ball bouncing on a floor that the key moves",
    parameters: &[
        ParameterTable {
            name: "g",
            title: "gravity",
            unit: "m/s²",
            range: (0.0, 1000.0),
            doc: "gravity",
        },
        ParameterTable {
            name: "restitution",
            title: "restitution",
            unit: "1",
            range: (0.0, 1.0),
            doc: "speed after an impact over speed before",
        },
        ParameterTable {
            name: "mass",
            title: "mass",
            unit: "kg",
            range: (1e-9, 1_000_000_000.0),
            doc: "mass of the ball",
        },
        ParameterTable {
            name: "y0",
            title: "drop",
            unit: "m",
            range: (0.0, 100.0),
            doc: "height of the drop at the start; 0: none",
        },
        ParameterTable {
            name: "scale",
            title: "scale",
            unit: "m/m",
            range: (-1000.0, 1000.0),
            doc: "floor per key travel; positive raises the floor as the key goes down",
        },
    ],
    presets: &[
        PresetTable { name: "default", doc: "1 kg dropped from 1 m, restitution 0.8", values: 28 },
        PresetTable {
            name: "key",
            doc: "10 g lying on a paddle that rises 5 times the key's travel",
            values: 29,
        },
    ],
    requirements: &[],
    states: &[NamedQuantity { name: "y", unit: "m" }, NamedQuantity { name: "v", unit: "m/s" }],
    coordinates: 1,
    constants: 15,
    derive_constants: 33,
    input: NamedQuantity { name: "s", unit: "m" },
    input_per_metre: 30,
    modes: &[
        ModeTable {
            name: "flight",
            derivative: 0,
            parts: &[PartTable {
                entries: 0x3,
                derivative: 0,
                kind: EquationKind::Affine,
                loss: None,
                reads: Reads::State,
            }],
            part_list: &[Part::WHOLE.of_state()],
            slaved: None,
            projection: None,
            projected: 0,
            longest_projection: None,
            readout: 2,
            slopes: 3,
            outputs: 4,
            balance: 5,
            jacobian: 1,
            series: Some(SeriesTable {
                start: 15,
                step: 16,
                entries: 0x3,
                guards: 1,
                conditions: 0,
                lanes: 0,
                carried: 0,
            }),
            kind: EquationKind::Affine,
            loss: None,
            is_stiffening: false,
            guards: &[GuardTable {
                id: 0,
                name: "floor",
                unit: "m",
                priority: 0,
                scale: 1.0,
                fires: Fires::WhileNegative,
                reads: Reads::StateAndInput,
                value: 13,
                bound: Some(14),
                ways: &[
                    WayTable { when: Some(6), to: 0, reset: Some(7), resting: None },
                    WayTable { when: Some(8), to: 1, reset: Some(9), resting: None },
                    WayTable {
                        when: None,
                        to: 0,
                        reset: Some(10),
                        resting: Some(RestingTable { to: 1, state: 11, meeting: 12 }),
                    },
                ],
                sounds: None,
            }],
            guard_specs: &[GuardSpec {
                id: GuardId(0),
                name: "floor",
                priority: 0,
                scale: 1.0,
                fires: Fires::WhileNegative,
                reads: Reads::StateAndInput,
            }],
            contacts: &[],
            freedom: Freedom { n: 1, m: 0, p: 1 },
        },
        ModeTable {
            name: "rest",
            derivative: 17,
            parts: &[],
            part_list: &[],
            slaved: Some(18),
            projection: None,
            projected: 0,
            longest_projection: Some(26),
            readout: 20,
            slopes: 3,
            outputs: 21,
            balance: 22,
            jacobian: 19,
            series: None,
            kind: EquationKind::Affine,
            loss: None,
            is_stiffening: false,
            guards: &[GuardTable {
                id: 1,
                name: "lift",
                unit: "m/s²",
                priority: 1,
                scale: 10.0,
                fires: Fires::WhileNegative,
                reads: Reads::StateAndInput,
                value: 24,
                bound: Some(25),
                ways: &[WayTable { when: None, to: 0, reset: Some(23), resting: None }],
                sounds: None,
            }],
            guard_specs: &[GuardSpec {
                id: GuardId(1),
                name: "lift",
                priority: 1,
                scale: 10.0,
                fires: Fires::WhileNegative,
                reads: Reads::StateAndInput,
            }],
            contacts: &[],
            freedom: Freedom { n: 1, m: 1, p: 0 },
        },
    ],
    contacts: &[],
    contact_specs: &[],
    guard_specs: &[
        GuardSpec {
            id: GuardId(0),
            name: "floor",
            priority: 0,
            scale: 1.0,
            fires: Fires::WhileNegative,
            reads: Reads::StateAndInput,
        },
        GuardSpec {
            id: GuardId(1),
            name: "lift",
            priority: 1,
            scale: 10.0,
            fires: Fires::WhileNegative,
            reads: Reads::StateAndInput,
        },
    ],
    outputs: &[
        NamedQuantity { name: "F", unit: "N" },
        NamedQuantity { name: "gap", unit: "m" },
        NamedQuantity { name: "key.x", unit: "m" },
        NamedQuantity { name: "key.y", unit: "m" },
        NamedQuantity { name: "key.angle", unit: "rad" },
        NamedQuantity { name: "floor.x", unit: "m" },
        NamedQuantity { name: "floor.y", unit: "m" },
        NamedQuantity { name: "floor.angle", unit: "rad" },
        NamedQuantity { name: "ball.x", unit: "m" },
        NamedQuantity { name: "ball.y", unit: "m" },
        NamedQuantity { name: "ball.angle", unit: "rad" },
        NamedQuantity { name: "finger.x", unit: "m" },
        NamedQuantity { name: "finger.y", unit: "m" },
        NamedQuantity { name: "finger.angle", unit: "rad" },
    ],
    rest: RestTable { mode: 1, instead: &[(31, 0)], state: 32, is_improved: false },
    damper: Some(DamperTable { lift: 0.005, fall: 0.0046, softest_tone: 0.15 }),
    midi: MidiTable { speeds: None, velocity: None, pressure: None },
    drawing: DrawingTable {
        numbers: 27,
        count: 138,
        bodies: &[
            BodyTable {
                name: "pivot",
                output: None,
                outlines: &[OutlineTable {
                    material: Material::Ground,
                    is_closed: true,
                    points: (4, 3),
                    modes: &[],
                }],
            },
            BodyTable {
                name: "key",
                output: Some(2),
                outlines: &[
                    OutlineTable {
                        material: Material::Wood,
                        is_closed: true,
                        points: (10, 4),
                        modes: &[],
                    },
                    OutlineTable {
                        material: Material::Metal,
                        is_closed: true,
                        points: (18, 24),
                        modes: &[],
                    },
                ],
            },
            BodyTable {
                name: "paddle",
                output: Some(5),
                outlines: &[OutlineTable {
                    material: Material::Wood,
                    is_closed: true,
                    points: (66, 4),
                    modes: &[],
                }],
            },
            BodyTable {
                name: "ball",
                output: Some(8),
                outlines: &[OutlineTable {
                    material: Material::Felt,
                    is_closed: true,
                    points: (74, 24),
                    modes: &[],
                }],
            },
            BodyTable {
                name: "finger",
                output: Some(11),
                outlines: &[OutlineTable {
                    material: Material::Finger,
                    is_closed: true,
                    points: (122, 8),
                    modes: &[],
                }],
            },
        ],
        springs: &[],
    },
};

/// The model's arithmetic.
#[derive(Clone, Copy, Debug, Default)]
pub struct BouncingBallFunctions;

impl Functions for BouncingBallFunctions {
    fn call(&self, function: FunctionId, given: &Arguments<'_>, out: &mut [f64]) {
        let done = match function {
            0 => derivative_flight(given, out),
            1 => jacobian_flight(given, out),
            2 => readout_flight(given, out),
            3 => slopes_flight(given, out),
            4 => outputs_flight(given, out),
            5 => balance_flight(given, out),
            6 => when_0_floor_flight(given, out),
            7 => reset_0_floor_flight(given, out),
            8 => when_1_floor_flight(given, out),
            9 => reset_1_floor_flight(given, out),
            10 => reset_2_floor_flight(given, out),
            11 => function_11(given, out),
            12 => function_12(given, out),
            13 => guard_floor_flight(given, out),
            14 => bound_floor_flight(given, out),
            15 => series_start_flight(given, out),
            16 => series_step_flight(given, out),
            17 => derivative_rest(given, out),
            18 => slaved_rest(given, out),
            19 => jacobian_rest(given, out),
            20 => readout_rest(given, out),
            21 => outputs_rest(given, out),
            22 => balance_rest(given, out),
            23 => reset_0_lift_rest(given, out),
            24 => guard_lift_rest(given, out),
            25 => bound_lift_rest(given, out),
            26 => function_26(given, out),
            27 => drawing(given, out),
            28 => preset_default(given, out),
            29 => preset_key(given, out),
            30 => input_per_metre(given, out),
            31 => rest_when_0(given, out),
            32 => rest(given, out),
            33 => derived_constants(given, out),
            _ => return,
        };
        if done.is_none() {
            out.fill(f64::NAN);
        }
    }

    #[inline(always)]
    fn derivative(&self, function: FunctionId, given: &Arguments<'_>, out: &mut [f64]) {
        let done = match function {
            0 => derivative_flight(given, out),
            17 => derivative_rest(given, out),
            _ => None,
        };
        if done.is_none() {
            out.fill(f64::NAN);
        }
    }

    #[inline(always)]
    fn readout(&self, function: FunctionId, given: &Arguments<'_>, out: &mut [f64]) {
        let done = match function {
            2 => readout_flight(given, out),
            20 => readout_rest(given, out),
            _ => None,
        };
        if done.is_none() {
            out.fill(f64::NAN);
        }
    }

    #[inline(always)]
    fn guard(&self, function: FunctionId, given: &Arguments<'_>, out: &mut [f64]) {
        let done = match function {
            13 => guard_floor_flight(given, out),
            24 => guard_lift_rest(given, out),
            _ => None,
        };
        if done.is_none() {
            out.fill(f64::NAN);
        }
    }

    #[inline(always)]
    fn bound(&self, function: FunctionId, given: &Arguments<'_>, out: &mut [f64]) {
        let done = match function {
            14 => bound_floor_flight(given, out),
            25 => bound_lift_rest(given, out),
            _ => None,
        };
        if done.is_none() {
            out.fill(f64::NAN);
        }
    }
}

/// The derivative of the state in mode flight.
#[inline(always)]
fn derivative_flight(given: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let constants = given.constants.first_chunk::<6>()?;
    let state = given.state.first_chunk::<2>()?;
    let c5 = constants[5];
    let v = state[1];
    let out = out.first_chunk_mut::<2>()?;
    [out[0], out[1]] = [v, c5];
    Some(())
}

/// The derivative's derivative by the state in mode flight.
fn jacobian_flight(_: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let out = out.first_chunk_mut::<4>()?;
    [out[0], out[1], out[2], out[3]] = [0.0, 1.0, 0.0, 0.0];
    Some(())
}

/// The readout in mode flight.
#[inline(always)]
fn readout_flight(_: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let out = out.first_chunk_mut::<1>()?;
    out[0] = 0.0;
    Some(())
}

/// The readout's slopes in mode flight.
fn slopes_flight(_: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let out = out.first_chunk_mut::<2>()?;
    [out[0], out[1]] = [0.0, 0.0];
    Some(())
}

/// The outputs in mode flight.
fn outputs_flight(given: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let constants = given.constants.first_chunk::<12>()?;
    let state = given.state.first_chunk::<1>()?;
    let input = given.input;
    let c6 = constants[6];
    let c7 = constants[7];
    let c8 = constants[8];
    let c9 = constants[9];
    let c10 = constants[10];
    let c11 = constants[11];
    let y = state[0];
    let s = input[0];
    let v0 = if c7 > 0.0 { s * c6 } else { 0.0 };
    let out = out.first_chunk_mut::<14>()?;
    [out[0], out[1], out[2], out[3], out[4], out[5]] = [0.0, y - s, 0.0, c10, c8 * v0, 0.0];
    [out[6], out[7], out[8], out[9], out[10], out[11]] = [s, 0.0, 0.0, y, 0.0, c11];
    [out[12], out[13]] = [c9 - v0, 0.0];
    Some(())
}

/// Energy, supplied and dissipated power in mode flight.
fn balance_flight(given: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let constants = given.constants.first_chunk::<13>()?;
    let state = given.state.first_chunk::<2>()?;
    let mass = constants[2];
    let c12 = constants[12];
    let y = state[0];
    let v = state[1];
    let out = out.first_chunk_mut::<3>()?;
    out[0] = y * c12 + 0.5 * (mass * (v * v));
    [out[1], out[2]] = [0.0, 0.0];
    Some(())
}

/// Is positive where a way is taken from guard floor in mode flight.
fn when_0_floor_flight(given: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let state = given.state.first_chunk::<2>()?;
    let input = given.input;
    let v = state[1];
    let s_rate = input[1];
    let out = out.first_chunk_mut::<1>()?;
    out[0] = v - s_rate - 1e-5;
    Some(())
}

/// The state after guard floor in mode flight.
fn reset_0_floor_flight(given: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let state = given.state.first_chunk::<2>()?;
    let input = given.input;
    let v = state[1];
    let s = input[0];
    let out = out.first_chunk_mut::<3>()?;
    [out[0], out[1], out[2]] = [s, v, 0.0];
    Some(())
}

/// Is positive where a way is taken from guard floor in mode flight.
fn when_1_floor_flight(given: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let constants = given.constants.first_chunk::<2>()?;
    let state = given.state.first_chunk::<2>()?;
    let input = given.input;
    let restitution = constants[1];
    let v = state[1];
    let s_rate = input[1];
    let out = out.first_chunk_mut::<1>()?;
    out[0] = 1e-10 - restitution * (s_rate - v);
    Some(())
}

/// The state after guard floor in mode flight.
fn reset_1_floor_flight(given: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let constants = given.constants.first_chunk::<3>()?;
    let state = given.state.first_chunk::<2>()?;
    let input = given.input;
    let mass = constants[2];
    let v = state[1];
    let s = input[0];
    let s_rate = input[1];
    let out = out.first_chunk_mut::<3>()?;
    [out[0], out[1]] = [s, s_rate];
    out[2] = mass * (s_rate - v);
    Some(())
}

/// The state after guard floor in mode flight.
fn reset_2_floor_flight(given: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let constants = given.constants.first_chunk::<15>()?;
    let state = given.state.first_chunk::<2>()?;
    let input = given.input;
    let c13 = constants[13];
    let c14 = constants[14];
    let v = state[1];
    let s = input[0];
    let s_rate = input[1];
    let v0 = v - s_rate;
    let out = out.first_chunk_mut::<3>()?;
    [out[0], out[1], out[2]] = [s, v - c13 * v0, -(c14 * v0)];
    Some(())
}

/// Is not used by the table.
fn function_11(given: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let constants = given.constants.first_chunk::<3>()?;
    let state = given.state.first_chunk::<2>()?;
    let input = given.input;
    let mass = constants[2];
    let v = state[1];
    let s = input[0];
    let s_rate = input[1];
    let out = out.first_chunk_mut::<3>()?;
    [out[0], out[1]] = [s, s_rate];
    out[2] = -(mass * (v - s_rate));
    Some(())
}

/// Is not used by the table.
fn function_12(given: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let constants = given.constants.first_chunk::<2>()?;
    let state = given.state.first_chunk::<2>()?;
    let input = given.input;
    let restitution = constants[1];
    let v = state[1];
    let s_rate = input[1];
    let out = out.first_chunk_mut::<2>()?;
    [out[0], out[1]] = [s_rate - v, restitution];
    Some(())
}

/// The guard and its rate: floor in mode flight.
#[inline(always)]
fn guard_floor_flight(given: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let state = given.state.first_chunk::<2>()?;
    let input = given.input;
    let y = state[0];
    let v = state[1];
    let s = input[0];
    let s_rate = input[1];
    let out = out.first_chunk_mut::<2>()?;
    [out[0], out[1]] = [y - s, v - s_rate];
    Some(())
}

/// Bounds of the guard's move and bend: floor in mode flight.
#[inline(always)]
fn bound_floor_flight(given: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let extra = given.extra.first_chunk::<4>()?;
    let input = given.input;
    let s_rate = input[1];
    let s_rate2 = input[2];
    let out = out.first_chunk_mut::<2>()?;
    out[0] = extra[0] + s_rate * extra[3];
    out[1] = extra[2] + s_rate2 * (extra[3] * extra[3]);
    Some(())
}

/// Where the Taylor series begins in mode flight.
fn series_start_flight(given: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let constants = given.constants.first_chunk::<6>()?;
    let state = given.state.first_chunk::<2>()?;
    let input = given.input;
    let c5 = constants[5];
    let y = state[0];
    let v = state[1];
    let s = input[0];
    let out = out.first_chunk_mut::<3>()?;
    [out[0], out[1], out[2]] = [v, c5, y - s];
    Some(())
}

/// One order of the Taylor series in mode flight.
fn series_step_flight(given: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let state = given.state.first_chunk::<2>()?;
    let input = given.input;
    let y = state[0];
    let v = state[1];
    let s = input[0];
    let out = out.first_chunk_mut::<3>()?;
    [out[0], out[1], out[2]] = [v, 0.0, y - s];
    Some(())
}

/// The derivative of the state in mode rest.
#[inline(always)]
fn derivative_rest(given: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let input = given.input;
    let s_rate = input[1];
    let s_rate2 = input[2];
    let out = out.first_chunk_mut::<2>()?;
    [out[0], out[1]] = [s_rate, s_rate2];
    Some(())
}

/// The state with slaved entries in place in mode rest.
fn slaved_rest(given: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let input = given.input;
    let s = input[0];
    let s_rate = input[1];
    let out = out.first_chunk_mut::<2>()?;
    [out[0], out[1]] = [s, s_rate];
    Some(())
}

/// The derivative's derivative by the state in mode rest.
fn jacobian_rest(_: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let out = out.first_chunk_mut::<4>()?;
    [out[0], out[1], out[2], out[3]] = [0.0, 0.0, 0.0, 0.0];
    Some(())
}

/// The readout in mode rest.
#[inline(always)]
fn readout_rest(given: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let constants = given.constants.first_chunk::<13>()?;
    let input = given.input;
    let mass = constants[2];
    let c12 = constants[12];
    let s_rate2 = input[2];
    let out = out.first_chunk_mut::<1>()?;
    out[0] = c12 + mass * s_rate2;
    Some(())
}

/// The outputs in mode rest.
fn outputs_rest(given: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let constants = given.constants.first_chunk::<13>()?;
    let input = given.input;
    let mass = constants[2];
    let c6 = constants[6];
    let c7 = constants[7];
    let c8 = constants[8];
    let c9 = constants[9];
    let c10 = constants[10];
    let c11 = constants[11];
    let c12 = constants[12];
    let s = input[0];
    let s_rate2 = input[2];
    let v0 = if c7 > 0.0 { s * c6 } else { 0.0 };
    let out = out.first_chunk_mut::<14>()?;
    out[0] = c12 + mass * s_rate2;
    [out[1], out[2], out[3], out[4], out[5], out[6]] = [0.0, 0.0, c10, c8 * v0, 0.0, s];
    [out[7], out[8], out[9], out[10], out[11], out[12]] = [0.0, 0.0, s, 0.0, c11, c9 - v0];
    out[13] = 0.0;
    Some(())
}

/// Energy, supplied and dissipated power in mode rest.
fn balance_rest(given: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let constants = given.constants.first_chunk::<13>()?;
    let input = given.input;
    let mass = constants[2];
    let c12 = constants[12];
    let s = input[0];
    let s_rate = input[1];
    let s_rate2 = input[2];
    let out = out.first_chunk_mut::<3>()?;
    out[0] = s * c12 + 0.5 * (mass * (s_rate * s_rate));
    out[1] = s_rate * (c12 + mass * s_rate2);
    out[2] = 0.0;
    Some(())
}

/// The state after guard lift in mode rest.
fn reset_0_lift_rest(given: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let input = given.input;
    let s = input[0];
    let s_rate = input[1];
    let out = out.first_chunk_mut::<3>()?;
    [out[0], out[1], out[2]] = [s, s_rate, 0.0];
    Some(())
}

/// The guard and its rate: lift in mode rest.
#[inline(always)]
fn guard_lift_rest(given: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let constants = given.constants.first_chunk::<1>()?;
    let input = given.input;
    let g = constants[0];
    let s_rate2 = input[2];
    let s_rate3 = input[3];
    let out = out.first_chunk_mut::<2>()?;
    [out[0], out[1]] = [g + s_rate2, s_rate3];
    Some(())
}

/// Bounds of the guard's move and bend: lift in mode rest.
#[inline(always)]
fn bound_lift_rest(given: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let extra = given.extra.first_chunk::<4>()?;
    let input = given.input;
    let s_rate3 = input[3];
    let out = out.first_chunk_mut::<2>()?;
    out[0] = s_rate3 * extra[3];
    out[1] = f64::INFINITY;
    Some(())
}

/// Is not used by the table.
fn function_26(given: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let constants = given.constants.first_chunk::<5>()?;
    let scale = constants[4];
    let out = out.first_chunk_mut::<1>()?;
    out[0] = 0.002 * functions::larger(scale.abs(), 1.0);
    Some(())
}

/// The numbers of the drawing.
fn drawing(given: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let constants = given.constants.first_chunk::<5>()?;
    let g = constants[0];
    let mass = constants[2];
    let y0 = constants[3];
    let scale = constants[4];
    let v0 = math::powf(0.000_238_732_414_637_843 * mass, 0.333_333_333_333_333_3);
    let v1 = functions::larger(10.0 * v0, functions::larger(0.25 * y0, 0.2));
    let v2 = scale.abs();
    let v3 = functions::larger(v1 / (1.0 + v2), 0.048);
    let v4 = -v3;
    let v5 = scale * v3;
    let v6 = 1.6 * v0;
    let v7 = v5 - v6;
    let v8 = 0.04 * v1;
    let v9 = v6 + v5;
    let v10 = 0.125 * (scale * scale / functions::larger(g, 1.0));
    let v11 = 2.0 * v0;
    let v12 = 0.013_200_000_000_000_002 * v2 + v11 + 1.1 * functions::larger(y0, v10);
    let v13 = 0.12 * v1;
    let v14 = -v8;
    let v15 = -v13;
    let v16 = 0.02 * v1;
    let v17 = -v16;
    let v18 = functions::larger(v5, 0.0);
    let v19 = 0.01 * v1;
    let v20 = 0.009_659_258_262_890_684 * v1;
    let v21 = 0.002_588_190_451_025_207_4 * v1;
    let v22 = 0.008_660_254_037_844_387 * v1;
    let v23 = 0.004_999_999_999_999_999 * v1;
    let v24 = 0.007_071_067_811_865_476 * v1;
    let v25 = 0.007_071_067_811_865_474_5 * v1;
    let v26 = 0.005_000_000_000_000_001 * v1;
    let v27 = -(0.002_588_190_451_025_206_5 * v1);
    let v28 = -(0.004_999_999_999_999_997_5 * v1);
    let v29 = -v22;
    let v30 = 0.009_659_258_262_890_682 * v1;
    let v31 = -v19;
    let v32 = -v20;
    let v33 = -(0.005_000_000_000_000_004_4 * v1);
    let v34 = 0.008_660_254_037_844_385 * v1;
    let v35 = 0.965_925_826_289_068_3 * v0;
    let v36 = 0.866_025_403_784_438_7 * v0;
    let v37 = 1.5 * v0;
    let v38 = 1.707_106_781_186_547_5 * v0;
    let v39 = 0.500_000_000_000_000_1 * v0 + v5;
    let v40 = 1.965_925_826_289_068_2 * v0;
    let v41 = v5 - 0.258_819_045_102_520_63 * v0;
    let v42 = 0.015 * v1;
    let v43 = 0.03 * v1;
    let v44 = 0.096 * v1;
    let out = out.first_chunk_mut::<138>()?;
    out[0] = functions::smaller(v4, v7) - v8;
    out[1] = -(0.012 + 0.012 * v2 + 0.13 * v1);
    out[2] = v8 + functions::larger(v9, 0.0);
    out[3] = functions::larger(v12, v13);
    [out[4], out[5], out[6], out[7], out[8], out[9], out[10]] = [0.0, v14, v14, v15, v8, v15, v4];
    [out[11], out[12], out[13], out[14], out[15], out[16]] = [v17, v18, v17, v18, v16, v4];
    [out[17], out[18], out[19], out[20], out[21], out[22]] = [v16, v19, 0.0, v20, v21, v22];
    [out[23], out[24], out[25], out[26], out[27], out[28]] = [v23, v24, v25, v26, v22, v21];
    out[29] = v20;
    out[30] = 6.123_233_995_736_766e-19 * v1;
    [out[31], out[32], out[33], out[34], out[35], out[36]] = [v19, v27, v20, v28, v22, -v25];
    [out[37], out[38], out[39], out[40]] = [v24, v29, v23, -v30];
    out[41] = 0.002_588_190_451_025_210_4 * v1;
    out[42] = v31;
    out[43] = 1.224_646_799_147_353_2e-18 * v1;
    out[44] = v32;
    out[45] = -(0.002_588_190_451_025_208 * v1);
    out[46] = -(0.008_660_254_037_844_388 * v1);
    out[47] = v28;
    out[48] = -(0.007_071_067_811_865_479 * v1);
    out[49] = -(0.007_071_067_811_865_471 * v1);
    [out[50], out[51], out[52], out[53]] = [v33, -v34, v27, v32];
    out[54] = -(1.836_970_198_721_029_6e-18 * v1);
    out[55] = v31;
    out[56] = 0.002_588_190_451_025_203 * v1;
    [out[57], out[58], out[59]] = [v32, v26, v29];
    out[60] = 0.007_071_067_811_865_474 * v1;
    out[61] = -(0.007_071_067_811_865_477 * v1);
    [out[62], out[63], out[64]] = [v34, v33, v30];
    out[65] = -(0.002_588_190_451_025_215_6 * v1);
    [out[66], out[67], out[68], out[69], out[70], out[71]] = [v7, v17, v9, v17, v9, 0.0];
    [out[72], out[73], out[74], out[75], out[76]] = [v7, 0.0, v0 + v5, v0, v35 + v5];
    out[77] = 1.258_819_045_102_520_7 * v0;
    [out[78], out[79]] = [v36 + v5, v37];
    out[80] = core::f64::consts::FRAC_1_SQRT_2 * v0 + v5;
    [out[81], out[82]] = [v38, v39];
    out[83] = 1.866_025_403_784_438_6 * v0;
    out[84] = 0.258_819_045_102_520_74 * v0 + v5;
    out[85] = v40;
    out[86] = 6.123_233_995_736_766e-17 * v0 + v5;
    [out[87], out[88], out[89]] = [v11, v41, v40];
    out[90] = v5 - 0.499_999_999_999_999_8 * v0;
    out[91] = 1.866_025_403_784_438_8 * v0;
    out[92] = v5 - f64::from_bits(0x3fe6_a09e_667f_3bcc) * v0;
    [out[93], out[94], out[95]] = [v38, v5 - v36, v37];
    out[96] = v5 - 0.965_925_826_289_068_2 * v0;
    out[97] = 1.258_819_045_102_521 * v0;
    out[98] = v5 - v0;
    out[99] = 1.000_000_000_000_000_2 * v0;
    out[100] = v5 - v35;
    out[101] = 0.741_180_954_897_479_3 * v0;
    out[102] = v5 - 0.866_025_403_784_438_8 * v0;
    out[103] = 0.500_000_000_000_000_2 * v0;
    out[104] = v5 - f64::from_bits(0x3fe6_a09e_667f_3bd0) * v0;
    out[105] = 0.292_893_218_813_452_87 * v0;
    out[106] = v5 - 0.500_000_000_000_000_4 * v0;
    out[107] = 0.133_974_596_215_561_63 * v0;
    out[108] = v41;
    out[109] = 0.034_074_173_710_931_69 * v0;
    out[110] = v5 - 1.836_970_198_721_029_7e-16 * v0;
    out[111] = 0.0;
    out[112] = 0.258_819_045_102_520_3 * v0 + v5;
    out[113] = 0.034_074_173_710_931_58 * v0;
    out[114] = v39;
    out[115] = 0.133_974_596_215_561_4 * v0;
    out[116] = f64::from_bits(0x3fe6_a09e_667f_3bcb) * v0 + v5;
    out[117] = 0.292_893_218_813_452_3 * v0;
    out[118] = 0.866_025_403_784_438_4 * v0 + v5;
    out[119] = 0.499_999_999_999_999_56 * v0;
    out[120] = 0.965_925_826_289_068_1 * v0 + v5;
    out[121] = 0.741_180_954_897_478_4 * v0;
    [out[122], out[123], out[124], out[125], out[126]] = [-v42, 0.0, v42, 0.0, 0.027 * v1];
    [out[127], out[128], out[129]] = [0.012 * v1, v43, v43];
    out[130] = 0.020_999_999_999_999_998 * v1;
    out[131] = v44;
    out[132] = -(0.033 * v1);
    [out[133], out[134], out[135]] = [v44, -v43, 0.024 * v1];
    out[136] = -(0.025_199_999_999_999_997 * v1);
    out[137] = 0.0072 * v1;
    Some(())
}

/// The preset default.
fn preset_default(_: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let out = out.first_chunk_mut::<5>()?;
    [out[0], out[1], out[2], out[3], out[4]] = [9.81, 0.8, 1.0, 1.0, 1.0];
    Some(())
}

/// The preset key.
fn preset_key(_: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let out = out.first_chunk_mut::<5>()?;
    out[0] = 9.81;
    out[1] = f64::from_bits(0x3fe6_6666_6666_6666);
    [out[2], out[3], out[4]] = [0.01, 0.0, 5.0];
    Some(())
}

/// Input per metre of key-front travel.
fn input_per_metre(given: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let constants = given.constants.first_chunk::<5>()?;
    let scale = constants[4];
    let out = out.first_chunk_mut::<1>()?;
    out[0] = scale;
    Some(())
}

/// Is positive where it rests in another mode.
fn rest_when_0(given: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let constants = given.constants.first_chunk::<4>()?;
    let y0 = constants[3];
    let out = out.first_chunk_mut::<1>()?;
    out[0] = y0;
    Some(())
}

/// The state to start from.
fn rest(given: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let constants = given.constants.first_chunk::<4>()?;
    let input = given.input;
    let y0 = constants[3];
    let s = input[0];
    let out = out.first_chunk_mut::<2>()?;
    [out[0], out[1]] = [y0 + s, 0.0];
    Some(())
}

/// What follows from the parameters.
fn derived_constants(given: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let constants = given.constants.first_chunk::<5>()?;
    let g = constants[0];
    let restitution = constants[1];
    let mass = constants[2];
    let y0 = constants[3];
    let scale = constants[4];
    let v0 = scale.abs();
    let v1 = math::powf(0.000_238_732_414_637_843 * mass, 0.333_333_333_333_333_3);
    let v2 = functions::larger(10.0 * v1, functions::larger(0.25 * y0, 0.2));
    let v3 = functions::larger(v2 / (1.0 + v0), 0.048);
    let v4 = 1.0 + restitution;
    let out = out.first_chunk_mut::<10>()?;
    [out[0], out[1], out[2], out[3], out[4]] = [-g, 1.0 / scale, v0, 1.0 / v3, -(0.02 * v2)];
    out[5] = -(0.04 * v2);
    out[6] = 0.016 * v2 - v3;
    [out[7], out[8], out[9]] = [g * mass, v4, mass * v4];
    Some(())
}
