//! Emitted from `the description of spring-wall` by `letoff model emit`; not to be changed by hand.
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
    NamedQuantity, ParameterTable, PresetTable, RestTable, WayTable,
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
    outputs: &[NamedQuantity { name: "F", unit: "N" }, NamedQuantity { name: "depth", unit: "m" }],
    rest: RestTable { mode: 0, instead: &[], state: 0, is_improved: true },
    damper: None,
    drawing: DrawingTable { numbers: 12, count: 0, bodies: &[], springs: &[] },
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
            12 => function_12(given, out),
            13 => preset_default(given, out),
            14 => input_per_metre(given, out),
            _ => return,
        };
        if done.is_none() {
            out.fill(f64::NAN);
        }
    }
}

/// What follows from the parameters.
fn derived_constants(_: &Arguments<'_>, _: &mut [f64]) -> Option<()> {
    Some(())
}

/// The readout in mode free.
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
    let out = out.first_chunk_mut::<2>()?;
    [out[0], out[1]] = [0.0, s - wall];
    Some(())
}

/// Energy, supplied and dissipated power in mode free.
fn balance_free(_: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let out = out.first_chunk_mut::<3>()?;
    [out[0], out[1], out[2]] = [0.0, 0.0, 0.0];
    Some(())
}

/// The guard and its rate: touch in mode free.
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
    let out = out.first_chunk_mut::<2>()?;
    out[0] = functions::larger(s_rate * B + K * v0, 0.0);
    out[1] = v0;
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

/// Is not used by the table.
fn function_12(_: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let out = out.first_chunk_mut::<4>()?;
    [out[0], out[1], out[2], out[3]] = [0.0, 0.0, 0.0, 0.0];
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
