//! Emitted from `the description of spring-wall` by `letoff model emit`; not to be changed by hand.
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
    MidiTable, ModeTable, ModelTable, NamedQuantity, OutlineTable, ParameterTable, PresetTable,
    RestTable, SpringTable, WayTable,
};
use pode::{EquationKind, Fires, GuardId, GuardSpec, Reads};

/// All of the model but its arithmetic.
pub static TABLE: ModelTable = ModelTable {
    name: "spring-wall",
    summary: "a spring and a damper behind a wall: the calibration feel",
    parameters: &[
        ParameterTable {
            name: "K",
            title: "stiffness",
            unit: "N/m",
            range: (0.0, 1_000_000_000.0),
            doc: "stiffness",
        },
        ParameterTable {
            name: "B",
            title: "damping",
            unit: "N·s/m",
            range: (0.0, 1_000_000_000.0),
            doc: "damping",
        },
        ParameterTable {
            name: "wall",
            title: "wall",
            unit: "m",
            range: (-100.0, 100.0),
            doc: "key travel at which the wall stands",
        },
    ],
    presets: &[PresetTable {
        name: "default",
        doc: "1 kN/m and 0.5 N·s/m from 5 mm on",
        values: 13,
    }],
    requirements: &[],
    states: &[],
    coordinates: 0,
    constants: 3,
    derive_constants: 0,
    input: NamedQuantity { name: "s", unit: "m" },
    input_per_metre: 14,
    modes: &[
        ModeTable {
            name: "free",
            derivative: 0,
            parts: &[],
            part_list: &[],
            slaved: None,
            projection: None,
            projected: 0,
            longest_projection: None,
            readout: 1,
            slopes: 2,
            outputs: 3,
            balance: 4,
            jacobian: 0,
            series: None,
            kind: EquationKind::Affine,
            loss: None,
            is_stiffening: false,
            guards: &[GuardTable {
                id: 0,
                name: "touch",
                unit: "m",
                priority: 0,
                scale: 1.0,
                fires: Fires::WhileNegative,
                reads: Reads::StateAndInput,
                value: 5,
                bound: Some(6),
                ways: &[WayTable { when: None, to: 1, reset: None, resting: None }],
                sounds: None,
            }],
            guard_specs: &[GuardSpec {
                id: GuardId(0),
                name: "touch",
                priority: 0,
                scale: 1.0,
                fires: Fires::WhileNegative,
                reads: Reads::StateAndInput,
            }],
            contacts: &[],
            freedom: Freedom { n: 0, m: 0, p: 0 },
        },
        ModeTable {
            name: "contact",
            derivative: 0,
            parts: &[],
            part_list: &[],
            slaved: None,
            projection: None,
            projected: 0,
            longest_projection: None,
            readout: 7,
            slopes: 8,
            outputs: 9,
            balance: 10,
            jacobian: 0,
            series: None,
            kind: EquationKind::Affine,
            loss: None,
            is_stiffening: false,
            guards: &[GuardTable {
                id: 1,
                name: "leave",
                unit: "m",
                priority: 0,
                scale: 1.0,
                fires: Fires::WhileNegative,
                reads: Reads::StateAndInput,
                value: 11,
                bound: Some(6),
                ways: &[WayTable { when: None, to: 0, reset: None, resting: None }],
                sounds: None,
            }],
            guard_specs: &[GuardSpec {
                id: GuardId(1),
                name: "leave",
                priority: 0,
                scale: 1.0,
                fires: Fires::WhileNegative,
                reads: Reads::StateAndInput,
            }],
            contacts: &[],
            freedom: Freedom { n: 0, m: 0, p: 0 },
        },
    ],
    contacts: &[],
    contact_specs: &[],
    guard_specs: &[
        GuardSpec {
            id: GuardId(0),
            name: "touch",
            priority: 0,
            scale: 1.0,
            fires: Fires::WhileNegative,
            reads: Reads::StateAndInput,
        },
        GuardSpec {
            id: GuardId(1),
            name: "leave",
            priority: 0,
            scale: 1.0,
            fires: Fires::WhileNegative,
            reads: Reads::StateAndInput,
        },
    ],
    outputs: &[
        NamedQuantity { name: "F", unit: "N" },
        NamedQuantity { name: "depth", unit: "m" },
        NamedQuantity { name: "key.x", unit: "m" },
        NamedQuantity { name: "key.y", unit: "m" },
        NamedQuantity { name: "key.angle", unit: "rad" },
        NamedQuantity { name: "pad.x", unit: "m" },
        NamedQuantity { name: "pad.y", unit: "m" },
        NamedQuantity { name: "pad.angle", unit: "rad" },
    ],
    rest: RestTable { mode: 0, instead: &[], state: 0, is_improved: true },
    damper: None,
    midi: MidiTable { speeds: None, velocity: None, pressure: None },
    drawing: DrawingTable {
        numbers: 12,
        count: 116,
        bodies: &[
            BodyTable {
                name: "key",
                output: Some(2),
                outlines: &[OutlineTable {
                    material: Material::Wood,
                    is_closed: true,
                    points: (4, 4),
                    modes: &[],
                }],
            },
            BodyTable {
                name: "finger",
                output: Some(2),
                outlines: &[OutlineTable {
                    material: Material::Finger,
                    is_closed: true,
                    points: (12, 8),
                    modes: &[],
                }],
            },
            BodyTable {
                name: "ground",
                output: None,
                outlines: &[
                    OutlineTable {
                        material: Material::Ground,
                        is_closed: false,
                        points: (28, 28),
                        modes: &[],
                    },
                    OutlineTable {
                        material: Material::Metal,
                        is_closed: false,
                        points: (84, 4),
                        modes: &[],
                    },
                ],
            },
            BodyTable {
                name: "wall",
                output: Some(5),
                outlines: &[
                    OutlineTable {
                        material: Material::Felt,
                        is_closed: true,
                        points: (92, 4),
                        modes: &[],
                    },
                    OutlineTable {
                        material: Material::Metal,
                        is_closed: false,
                        points: (100, 2),
                        modes: &[],
                    },
                    OutlineTable {
                        material: Material::Metal,
                        is_closed: true,
                        points: (104, 4),
                        modes: &[],
                    },
                ],
            },
        ],
        springs: &[SpringTable { name: "K", from: (2, 112), to: (3, 114), modes: &[] }],
    },
};

/// The model's arithmetic.
#[derive(Clone, Copy, Debug, Default)]
pub struct SpringWallFunctions;

impl Functions for SpringWallFunctions {
    fn call(&self, function: FunctionId, given: &Arguments<'_>, out: &mut [f64]) {
        let done = match function {
            0 => derived_constants(given, out),
            1 => readout_free(given, out),
            2 => slopes_free(given, out),
            3 => outputs_free(given, out),
            4 => balance_free(given, out),
            5 => guard_touch_free(given, out),
            6 => bound_touch_free(given, out),
            7 => readout_contact(given, out),
            8 => slopes_contact(given, out),
            9 => outputs_contact(given, out),
            10 => balance_contact(given, out),
            11 => guard_leave_contact(given, out),
            12 => drawing(given, out),
            13 => preset_default(given, out),
            14 => input_per_metre(given, out),
            _ => return,
        };
        if done.is_none() {
            out.fill(f64::NAN);
        }
    }

    #[inline(always)]
    fn derivative(&self, function: FunctionId, given: &Arguments<'_>, out: &mut [f64]) {
        let done = match function {
            0 => derived_constants(given, out),
            _ => None,
        };
        if done.is_none() {
            out.fill(f64::NAN);
        }
    }

    #[inline(always)]
    fn readout(&self, function: FunctionId, given: &Arguments<'_>, out: &mut [f64]) {
        let done = match function {
            1 => readout_free(given, out),
            7 => readout_contact(given, out),
            _ => None,
        };
        if done.is_none() {
            out.fill(f64::NAN);
        }
    }

    #[inline(always)]
    fn guard(&self, function: FunctionId, given: &Arguments<'_>, out: &mut [f64]) {
        let done = match function {
            5 => guard_touch_free(given, out),
            11 => guard_leave_contact(given, out),
            _ => None,
        };
        if done.is_none() {
            out.fill(f64::NAN);
        }
    }

    #[inline(always)]
    fn bound(&self, function: FunctionId, given: &Arguments<'_>, out: &mut [f64]) {
        let done = match function {
            6 => bound_touch_free(given, out),
            _ => None,
        };
        if done.is_none() {
            out.fill(f64::NAN);
        }
    }
}

/// What follows from the parameters.
#[inline(always)]
fn derived_constants(_: &Arguments<'_>, _: &mut [f64]) -> Option<()> {
    Some(())
}

/// The readout in mode free.
#[inline(always)]
fn readout_free(_: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let out = out.first_chunk_mut::<1>()?;
    out[0] = 0.0;
    Some(())
}

/// The readout's slopes in mode free.
fn slopes_free(_: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let out = out.first_chunk_mut::<2>()?;
    [out[0], out[1]] = [0.0, 0.0];
    Some(())
}

/// The outputs in mode free.
fn outputs_free(given: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let constants = given.constants.first_chunk::<3>()?;
    let input = given.input;
    let wall = constants[2];
    let s = input[0];
    let out = out.first_chunk_mut::<8>()?;
    [out[0], out[1], out[2], out[3], out[4], out[5]] = [0.0, s - wall, 0.0, -s, 0.0, 0.0];
    out[6] = -functions::larger(s, wall);
    out[7] = 0.0;
    Some(())
}

/// Energy, supplied and dissipated power in mode free.
fn balance_free(_: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let out = out.first_chunk_mut::<3>()?;
    [out[0], out[1], out[2]] = [0.0, 0.0, 0.0];
    Some(())
}

/// The guard and its rate: touch in mode free.
#[inline(always)]
fn guard_touch_free(given: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let constants = given.constants.first_chunk::<3>()?;
    let input = given.input;
    let wall = constants[2];
    let s = input[0];
    let s_rate = input[1];
    let out = out.first_chunk_mut::<2>()?;
    [out[0], out[1]] = [wall - s, -s_rate];
    Some(())
}

/// Bounds of the guard's move and bend: touch in mode free.
#[inline(always)]
fn bound_touch_free(given: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let extra = given.extra.first_chunk::<4>()?;
    let input = given.input;
    let s_rate = input[1];
    let s_rate2 = input[2];
    let out = out.first_chunk_mut::<2>()?;
    out[0] = s_rate * extra[3];
    out[1] = s_rate2 * (extra[3] * extra[3]);
    Some(())
}

/// The readout in mode contact.
#[inline(always)]
fn readout_contact(given: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let constants = given.constants.first_chunk::<3>()?;
    let input = given.input;
    let K = constants[0];
    let B = constants[1];
    let wall = constants[2];
    let s = input[0];
    let s_rate = input[1];
    let v0 = functions::larger(s_rate * B + K * (s - wall), 0.0);
    let out = out.first_chunk_mut::<1>()?;
    out[0] = v0;
    Some(())
}

/// The readout's slopes in mode contact.
fn slopes_contact(given: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let constants = given.constants.first_chunk::<3>()?;
    let input = given.input;
    let K = constants[0];
    let B = constants[1];
    let wall = constants[2];
    let s = input[0];
    let s_rate = input[1];
    let v0 = s_rate * B + K * (s - wall);
    let v1 = if v0 > 0.0 { K } else { 0.0 };
    let v2 = if v0 > 0.0 { B } else { 0.0 };
    let out = out.first_chunk_mut::<2>()?;
    [out[0], out[1]] = [v1, v2];
    Some(())
}

/// The outputs in mode contact.
fn outputs_contact(given: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let constants = given.constants.first_chunk::<3>()?;
    let input = given.input;
    let K = constants[0];
    let B = constants[1];
    let wall = constants[2];
    let s = input[0];
    let s_rate = input[1];
    let v0 = s - wall;
    let out = out.first_chunk_mut::<8>()?;
    out[0] = functions::larger(s_rate * B + K * v0, 0.0);
    [out[1], out[2], out[3], out[4], out[5]] = [v0, 0.0, -s, 0.0, 0.0];
    out[6] = -functions::larger(s, wall);
    out[7] = 0.0;
    Some(())
}

/// Energy, supplied and dissipated power in mode contact.
fn balance_contact(given: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let constants = given.constants.first_chunk::<3>()?;
    let input = given.input;
    let K = constants[0];
    let B = constants[1];
    let wall = constants[2];
    let s = input[0];
    let s_rate = input[1];
    let v0 = s - wall;
    let v1 = K * v0;
    let v2 = functions::larger(s_rate * B + v1, 0.0);
    let out = out.first_chunk_mut::<3>()?;
    out[0] = 0.5 * (v0 * v1);
    out[1] = s_rate * v2;
    out[2] = s_rate * (v2 - v1);
    Some(())
}

/// The guard and its rate: leave in mode contact.
#[inline(always)]
fn guard_leave_contact(given: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let constants = given.constants.first_chunk::<3>()?;
    let input = given.input;
    let wall = constants[2];
    let s = input[0];
    let s_rate = input[1];
    let out = out.first_chunk_mut::<2>()?;
    [out[0], out[1]] = [s - wall, s_rate];
    Some(())
}

/// The numbers of the drawing.
fn drawing(given: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let constants = given.constants.first_chunk::<3>()?;
    let wall = constants[2];
    let v0 = functions::larger(wall, 0.0);
    let v1 = -(0.033 + v0);
    let v2 = -(0.035_862_222_222_222_226 + v0);
    let v3 = -(0.0165 + v0);
    let out = out.first_chunk_mut::<116>()?;
    out[0] = -0.023;
    out[1] = functions::smaller(v1, -(0.012 + v0)) - 0.006;
    [out[2], out[3], out[4], out[5], out[6], out[7]] = [0.023, 0.045, -0.0115, 0.0, 0.0115, 0.0];
    [out[8], out[9], out[10], out[11], out[12]] = [0.0115, 0.012, -0.0115, 0.012, -0.00375];
    [out[13], out[14], out[15], out[16], out[17]] = [0.012, 0.00375, 0.012, 0.00675, 0.015];
    [out[18], out[19]] = [0.0075, 0.0195];
    out[20] = 0.005_249_999_999_999_999_5;
    out[21] = 0.036_000_000_000_000_004;
    out[22] = -0.00825;
    out[23] = 0.036_000_000_000_000_004;
    out[24] = -0.0075;
    out[25] = 0.018_000_000_000_000_002;
    out[26] = -0.006_299_999_999_999_999;
    [out[27], out[28], out[29]] = [0.0138, -0.0184, v1];
    out[30] = -0.014_311_111_111_111_111;
    out[31] = v1;
    out[32] = -0.017_173_333_333_333_332;
    out[33] = v2;
    out[34] = -0.014_311_111_111_111_111;
    out[35] = v1;
    out[36] = -0.010_222_222_222_222_223;
    out[37] = v1;
    out[38] = -0.013_084_444_444_444_444;
    out[39] = v2;
    out[40] = -0.010_222_222_222_222_223;
    out[41] = v1;
    out[42] = -0.006_133_333_333_333_334;
    out[43] = v1;
    out[44] = -0.008_995_555_555_555_557;
    out[45] = v2;
    out[46] = -0.006_133_333_333_333_334;
    out[47] = v1;
    out[48] = -0.002_044_444_444_444_446;
    out[49] = v1;
    out[50] = -0.004_906_666_666_666_668_5;
    out[51] = v2;
    out[52] = -0.002_044_444_444_444_446;
    out[53] = v1;
    out[54] = 0.002_044_444_444_444_442_5;
    out[55] = v1;
    out[56] = -0.000_817_777_777_777_781_9;
    out[57] = v2;
    out[58] = 0.002_044_444_444_444_442_5;
    out[59] = v1;
    out[60] = 0.006_133_333_333_333_331;
    out[61] = v1;
    out[62] = 0.003_271_111_111_111_106_6;
    out[63] = v2;
    out[64] = 0.006_133_333_333_333_331;
    out[65] = v1;
    out[66] = 0.010_222_222_222_222_22;
    out[67] = v1;
    out[68] = 0.007_359_999_999_999_995;
    out[69] = v2;
    out[70] = 0.010_222_222_222_222_22;
    out[71] = v1;
    out[72] = 0.014_311_111_111_111_108;
    out[73] = v1;
    out[74] = 0.011_448_888_888_888_883;
    out[75] = v2;
    out[76] = 0.014_311_111_111_111_108;
    [out[77], out[78], out[79]] = [v1, 0.0184, v1];
    out[80] = 0.015_537_777_777_777_775;
    [out[81], out[82], out[83], out[84], out[85]] = [v2, 0.0184, v1, 0.002_875, v3];
    [out[86], out[87], out[88], out[89], out[90]] = [0.002_875, v1, 0.008_625, v1, 0.008_625];
    [out[91], out[92], out[93], out[94], out[95]] = [v3, -0.0115, -0.003, 0.0115, -0.003];
    [out[96], out[97], out[98], out[99], out[100]] = [0.0115, 0.0, -0.0115, 0.0, 0.00575];
    [out[101], out[102], out[103], out[104], out[105]] = [-0.003, 0.00575, -0.018, 0.00322, -0.019];
    [out[106], out[107], out[108], out[109]] = [0.00828, -0.019, 0.00828, -0.018];
    [out[110], out[111], out[112], out[113], out[114]] = [0.00322, -0.018, -0.00575, v1, -0.00575];
    out[115] = -0.003;
    Some(())
}

/// The preset default.
fn preset_default(_: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let out = out.first_chunk_mut::<3>()?;
    [out[0], out[1], out[2]] = [1000.0, 0.5, 0.005];
    Some(())
}

/// Input per metre of key-front travel.
fn input_per_metre(_: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let out = out.first_chunk_mut::<1>()?;
    out[0] = 1.0;
    Some(())
}
