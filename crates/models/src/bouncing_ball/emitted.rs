//! Emitted from `the description of bouncing-ball` by `letoff model emit`; not to be changed by hand.
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
    PresetTable, RestTable, RestingTable, SeriesTable, WayTable,
};
use pode::{EquationKind, Fires, GuardId, GuardSpec, Part, Reads};

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
    constants: 9,
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
        NamedQuantity { name: "ball.x", unit: "m" },
        NamedQuantity { name: "ball.y", unit: "m" },
        NamedQuantity { name: "ball.angle", unit: "rad" },
        NamedQuantity { name: "floor.x", unit: "m" },
        NamedQuantity { name: "floor.y", unit: "m" },
        NamedQuantity { name: "floor.angle", unit: "rad" },
    ],
    rest: RestTable { mode: 1, instead: &[(31, 0)], state: 32, is_improved: false },
    damper: Some(DamperTable { lift: 0.005, fall: 0.0046, softest_tone: 0.15 }),
    drawing: DrawingTable {
        numbers: 27,
        count: 60,
        bodies: &[
            BodyTable {
                name: "ball",
                output: Some(2),
                outlines: &[OutlineTable {
                    material: Material::Felt,
                    is_closed: true,
                    points: (4, 24),
                    modes: &[],
                }],
            },
            BodyTable {
                name: "floor",
                output: Some(5),
                outlines: &[OutlineTable {
                    material: Material::Wood,
                    is_closed: true,
                    points: (52, 4),
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
}

/// The derivative of the state in mode flight.
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
    let state = given.state.first_chunk::<1>()?;
    let input = given.input;
    let y = state[0];
    let s = input[0];
    let out = out.first_chunk_mut::<8>()?;
    [out[0], out[1], out[2], out[3], out[4], out[5], out[6]] = [0.0, y - s, 0.0, y, 0.0, 0.0, s];
    out[7] = 0.0;
    Some(())
}

/// Energy, supplied and dissipated power in mode flight.
fn balance_flight(given: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let constants = given.constants.first_chunk::<7>()?;
    let state = given.state.first_chunk::<2>()?;
    let mass = constants[2];
    let c6 = constants[6];
    let y = state[0];
    let v = state[1];
    let out = out.first_chunk_mut::<3>()?;
    out[0] = y * c6 + 0.5 * (mass * (v * v));
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
    let constants = given.constants.first_chunk::<9>()?;
    let state = given.state.first_chunk::<2>()?;
    let input = given.input;
    let c7 = constants[7];
    let c8 = constants[8];
    let v = state[1];
    let s = input[0];
    let s_rate = input[1];
    let v0 = v - s_rate;
    let out = out.first_chunk_mut::<3>()?;
    [out[0], out[1], out[2]] = [s, v - c7 * v0, -(c8 * v0)];
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
fn readout_rest(given: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let constants = given.constants.first_chunk::<7>()?;
    let input = given.input;
    let mass = constants[2];
    let c6 = constants[6];
    let s_rate2 = input[2];
    let out = out.first_chunk_mut::<1>()?;
    out[0] = c6 + s_rate2 * mass;
    Some(())
}

/// The outputs in mode rest.
fn outputs_rest(given: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let constants = given.constants.first_chunk::<7>()?;
    let input = given.input;
    let mass = constants[2];
    let c6 = constants[6];
    let s = input[0];
    let s_rate2 = input[2];
    let out = out.first_chunk_mut::<8>()?;
    out[0] = c6 + s_rate2 * mass;
    [out[1], out[2], out[3], out[4], out[5], out[6], out[7]] = [0.0, 0.0, s, 0.0, 0.0, s, 0.0];
    Some(())
}

/// Energy, supplied and dissipated power in mode rest.
fn balance_rest(given: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let constants = given.constants.first_chunk::<7>()?;
    let input = given.input;
    let mass = constants[2];
    let c6 = constants[6];
    let s = input[0];
    let s_rate = input[1];
    let s_rate2 = input[2];
    let out = out.first_chunk_mut::<3>()?;
    out[0] = s * c6 + 0.5 * (mass * (s_rate * s_rate));
    out[1] = s_rate * (c6 + mass * s_rate2);
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
fn guard_lift_rest(given: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let constants = given.constants.first_chunk::<1>()?;
    let input = given.input;
    let g = constants[0];
    let s_rate2 = input[2];
    let s_rate3 = input[3];
    let out = out.first_chunk_mut::<2>()?;
    [out[0], out[1]] = [s_rate2 + g, s_rate3];
    Some(())
}

/// Bounds of the guard's move and bend: lift in mode rest.
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
fn drawing(_: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let out = out.first_chunk_mut::<60>()?;
    [out[0], out[1], out[2], out[3], out[4], out[5]] = [-0.4, -0.2, 0.4, 1.3, 0.06, 0.06];
    out[6] = 0.057_955_549_577_344_1;
    out[7] = 0.075_529_142_706_151_24;
    out[8] = 0.051_961_524_227_066_32;
    out[9] = 0.09;
    out[10] = 0.042_426_406_871_192_854;
    out[11] = 0.102_426_406_871_192_84;
    out[12] = 0.030_000_000_000_000_006;
    out[13] = 0.111_961_524_227_066_32;
    out[14] = 0.015_529_142_706_151_244;
    out[15] = 0.117_955_549_577_344_1;
    out[16] = 3.673_940_397_442_059e-18;
    out[17] = 0.12;
    out[18] = -0.015_529_142_706_151_237;
    out[19] = 0.117_955_549_577_344_1;
    out[20] = -0.029_999_999_999_999_985;
    out[21] = 0.111_961_524_227_066_32;
    out[22] = -0.042_426_406_871_192_85;
    out[23] = 0.102_426_406_871_192_85;
    out[24] = -0.051_961_524_227_066_32;
    out[25] = 0.09;
    out[26] = -0.057_955_549_577_344_09;
    out[27] = 0.075_529_142_706_151_26;
    out[28] = -0.06;
    out[29] = 0.060_000_000_000_000_005;
    out[30] = -0.057_955_549_577_344_1;
    out[31] = 0.044_470_857_293_848_75;
    out[32] = -0.051_961_524_227_066_326;
    out[33] = 0.030_000_000_000_000_016;
    out[34] = -0.042_426_406_871_192_875;
    out[35] = 0.017_573_593_128_807_17;
    out[36] = -0.030_000_000_000_000_027;
    out[37] = 0.008_038_475_772_933_7;
    out[38] = -0.015_529_142_706_151_237;
    out[39] = 0.002_044_450_422_655_899_6;
    out[40] = -1.102_182_119_232_617_8e-17;
    out[41] = 0.0;
    out[42] = 0.015_529_142_706_151_217;
    out[43] = 0.002_044_450_422_655_892_7;
    out[44] = 0.030_000_000_000_000_006;
    out[45] = 0.008_038_475_772_933_686;
    out[46] = 0.042_426_406_871_192_84;
    out[47] = 0.017_573_593_128_807_137;
    out[48] = 0.051_961_524_227_066_3;
    out[49] = 0.029_999_999_999_999_97;
    out[50] = 0.057_955_549_577_344_084;
    out[51] = 0.044_470_857_293_848_705;
    out[52] = -f64::from_bits(0x3fd3_3333_3333_3333);
    out[53] = -0.02;
    out[54] = f64::from_bits(0x3fd3_3333_3333_3333);
    out[55] = -0.02;
    out[56] = f64::from_bits(0x3fd3_3333_3333_3333);
    out[57] = 0.0;
    out[58] = -f64::from_bits(0x3fd3_3333_3333_3333);
    out[59] = 0.0;
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
    [out[0], out[1]] = [s + y0, 0.0];
    Some(())
}

/// What follows from the parameters.
fn derived_constants(given: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let constants = given.constants.first_chunk::<3>()?;
    let g = constants[0];
    let restitution = constants[1];
    let mass = constants[2];
    let v0 = restitution + 1.0;
    let out = out.first_chunk_mut::<4>()?;
    [out[0], out[1], out[2], out[3]] = [-g, g * mass, v0, mass * v0];
    Some(())
}
