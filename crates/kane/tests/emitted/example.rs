//! Emitted from `lever-with-hammer.toml` by `letoff model emit`; not to be changed by hand.
#![expect(clippy::allow_attributes, reason = "which rules are broken depends on the model")]
#![allow(
    non_snake_case,
    unreachable_pub,
    clippy::large_stack_frames,
    clippy::suspicious_operation_groupings,
    clippy::too_many_lines,
    clippy::unnecessary_wraps,
    reason = "names as in the description, and straight lines of operations"
)]

use equations::functions;
use equations::table::{
    Arguments, BodyTable, ContactTable, DamperTable, DrawingTable, Freedom, FunctionId, Functions,
    GuardTable, Material, ModeTable, ModelTable, OutlineTable, ParameterTable, PresetTable,
    Quantity, RequirementTable, RestTable, SpringTable, WayTable,
};
use pode::{EquationKind, Fires, Reads, math};

/// All of the model but its arithmetic.
pub static TABLE: ModelTable = ModelTable {
    name: "lever-with-hammer",
    summary: "A lever with a hammer on it",
    parameters: &[
        ParameterTable {
            name: "L1",
            title: "A name for people",
            unit: "m",
            range: (0.001, 10.0),
            doc: "One line about it, with \"quotes\", a \\ and signs like µ that is long enough to \
                be broken into two lines of text in the emitted file",
        },
        ParameterTable {
            name: "M1",
            title: "A name for people",
            unit: "kg",
            range: (0.001, 10.0),
            doc: "One line about it, with \"quotes\", a \\ and signs like µ that is long enough to \
                be broken into two lines of text in the emitted file",
        },
        ParameterTable {
            name: "J1",
            title: "A name for people",
            unit: "kg*m^2",
            range: (0.001, 10.0),
            doc: "One line about it, with \"quotes\", a \\ and signs like µ that is long enough to \
                be broken into two lines of text in the emitted file",
        },
        ParameterTable {
            name: "J2",
            title: "A name for people",
            unit: "kg*m^2",
            range: (0.001, 10.0),
            doc: "One line about it, with \"quotes\", a \\ and signs like µ that is long enough to \
                be broken into two lines of text in the emitted file",
        },
        ParameterTable {
            name: "k1",
            title: "A name for people",
            unit: "N*m/rad",
            range: (0.001, 10.0),
            doc: "One line about it, with \"quotes\", a \\ and signs like µ that is long enough to \
                be broken into two lines of text in the emitted file",
        },
        ParameterTable {
            name: "k2",
            title: "A name for people",
            unit: "N/m",
            range: (0.001, 10.0),
            doc: "One line about it, with \"quotes\", a \\ and signs like µ that is long enough to \
                be broken into two lines of text in the emitted file",
        },
        ParameterTable {
            name: "a very long name that no identifier should have",
            title: "A name for people",
            unit: "1",
            range: (0.001, 10.0),
            doc: "One line about it, with \"quotes\", a \\ and signs like µ that is long enough to \
                be broken into two lines of text in the emitted file",
        },
    ],
    presets: &[PresetTable { name: "default", doc: "", values: 0 }],
    requirements: &[RequirementTable { text: "L1 > 0", margin: 2 }],
    states: &[
        Quantity { name: "theta_k", unit: "rad" },
        Quantity { name: "theta_h", unit: "rad" },
        Quantity { name: "theta_k'", unit: "rad/s" },
        Quantity { name: "theta_h'", unit: "rad/s" },
    ],
    coordinates: 2,
    constants: 8,
    derive_constants: 0,
    input: Quantity { name: "s", unit: "rad" },
    input_per_metre: 2,
    modes: &[
        ModeTable {
            name: "contact",
            derivative: 1,
            parts: &[],
            slaved: None,
            projection: None,
            projected: 0,
            longest_projection: 0.001,
            readout: 2,
            slopes: 3,
            outputs: 4,
            balance: 3,
            jacobian: 5,
            kind: EquationKind::Smooth,
            guards: &[GuardTable {
                id: 0,
                name: "release",
                priority: 0,
                scale: 1.0,
                fires: Fires::OnCrossing,
                reads: Reads::StateAndInput,
                value: 6,
                bound: None,
                ways: &[
                    WayTable { when: Some(2), to: 1, reset: Some(7) },
                    WayTable { when: None, to: 0, reset: None },
                ],
                sounds: Some(2),
            }],
            contacts: &[],
            freedom: Freedom { n: 2, m: 0, p: 2 },
        },
        ModeTable {
            name: "free'",
            derivative: 1,
            parts: &[],
            slaved: None,
            projection: None,
            projected: 0,
            longest_projection: 0.001,
            readout: 2,
            slopes: 3,
            outputs: 4,
            balance: 3,
            jacobian: 5,
            kind: EquationKind::Affine,
            guards: &[],
            contacts: &[],
            freedom: Freedom { n: 2, m: 0, p: 2 },
        },
    ],
    contacts: &[ContactTable { name: "string", gap: Some(0.001), friction: None }],
    outputs: &[Quantity { name: "F", unit: "N" }],
    rest: RestTable { mode: 0, state: 7, is_improved: true },
    damper: Some(DamperTable { lift: 0.005, fall: 0.0046, softest_tone: 0.15 }),
    drawing: DrawingTable {
        numbers: 8,
        count: 6,
        bodies: &[BodyTable {
            name: "lever",
            output: None,
            outlines: &[OutlineTable {
                material: Material::Wood,
                is_closed: true,
                points: (4, 1),
                modes: &[0, 1],
            }],
        }],
        springs: &[SpringTable { name: "k1", from: (0, 4), to: (0, 4), modes: &[] }],
    },
};

/// The model's arithmetic.
#[derive(Clone, Copy, Debug, Default)]
pub struct LeverWithHammerFunctions;

impl Functions for LeverWithHammerFunctions {
    fn call(&self, function: FunctionId, given: &Arguments<'_>, out: &mut [f64]) {
        let done = match function {
            0 => derived_constants(given, out),
            1 => derivative_contact(given, out),
            2 => input_per_metre(given, out),
            3 => slopes_contact(given, out),
            4 => outputs_contact(given, out),
            5 => jacobian_contact(given, out),
            6 => guard_release_contact(given, out),
            7 => rest(given, out),
            8 => drawing(given, out),
            _ => return,
        };
        if done.is_none() {
            out.fill(f64::NAN);
        }
    }
}

/// What follows from the parameters.
fn derived_constants(given: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let constants = given.constants.first_chunk::<2>()?;
    let L1 = constants[0];
    let M1 = constants[1];
    let out = out.first_chunk_mut::<1>()?;
    out[0] = core::f64::consts::PI * (L1 * M1);
    Some(())
}

/// The derivative of the state in mode contact.
fn derivative_contact(given: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let constants = given.constants.first_chunk::<6>()?;
    let state = given.state.first_chunk::<4>()?;
    let input = given.input;
    let L1 = constants[0];
    let M1 = constants[1];
    let J1 = constants[2];
    let J2 = constants[3];
    let k1 = constants[4];
    let k2 = constants[5];
    let theta_k = state[0];
    let theta_h = state[1];
    let theta_k_rate = state[2];
    let theta_h_rate = state[3];
    let s = input[0];
    let s_rate = input[1];
    let v0 = theta_k - theta_h;
    let ([sin_v0, sin_theta_k], [cos_v0, cos_theta_k]) = math::sin_cos_of_two([v0, theta_k]);
    let v1 = L1 * L1;
    let v2 = v1 * M1;
    let v3 = J1 + v2;
    let v4 = J2 + 0.25 * v2;
    let v5 = 0.05 * sin_v0 + 0.4 * sin_theta_k - 0.1 * theta_h;
    let v6 = math::powf(functions::larger(v5, 0.0), 2.5);
    let v7 = 15.0 * sin_v0 + 120.0 * sin_theta_k - 30.0 * theta_h;
    let v8 = k1 * (s - theta_k) + 0.01 * (k1 * (s_rate - theta_k_rate));
    let v9 = 0.001 * functions::softplus(v7);
    let v10 = v8 - v9 - v2 * (theta_h_rate * theta_h_rate) * sin_v0;
    let v11 = v10 - 9.81 * (L1 * M1 * cos_theta_k) - 0.4 * (k2 * cos_theta_k * v6);
    let v12 = v9 + v2 * (theta_k_rate * theta_k_rate) * sin_v0 + 0.1 * (k2 * cos_v0 * v6);
    let v13 = v12 - 0.02 * theta_h_rate;
    let v14 = v3 * v4 - v1 * v1 * (M1 * M1) * (cos_v0 * cos_v0);
    let v15 = v2 * cos_v0;
    let out = out.first_chunk_mut::<4>()?;
    out[0] = theta_k_rate;
    out[1] = theta_h_rate;
    out[2] = (v4 * v11 - v15 * v13) / v14;
    out[3] = (v3 * v13 - v15 * v11) / v14;
    Some(())
}

/// Input per metre of key-front travel.
fn input_per_metre(given: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let constants = given.constants.first_chunk::<5>()?;
    let state = given.state.first_chunk::<1>()?;
    let input = given.input;
    let k1 = constants[4];
    let theta_k = state[0];
    let s = input[0];
    let out = out.first_chunk_mut::<1>()?;
    out[0] = k1 * (s - theta_k);
    Some(())
}

/// The readout's slopes in mode contact.
fn slopes_contact(given: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let constants = given.constants.first_chunk::<5>()?;
    let state = given.state.first_chunk::<1>()?;
    let input = given.input;
    let L1 = constants[0];
    let M1 = constants[1];
    let k1 = constants[4];
    let theta_k = state[0];
    let s = input[0];
    let v0 = s - theta_k;
    let out = out.first_chunk_mut::<3>()?;
    out[0] = k1 * v0;
    out[1] = core::f64::consts::PI * (L1 * M1);
    out[2] = v0;
    Some(())
}

/// The outputs in mode contact.
fn outputs_contact(given: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let constants = given.constants.first_chunk::<5>()?;
    let state = given.state.first_chunk::<2>()?;
    let input = given.input;
    let k1 = constants[4];
    let theta_k = state[0];
    let theta_h = state[1];
    let s = input[0];
    let v0 = f64::from_bits(0x4009_1eb8_51eb_851f);
    let v1 = if k1 * (s - theta_k) > 0.0 { v0 } else { theta_h };
    let out = out.first_chunk_mut::<1>()?;
    out[0] = v1;
    Some(())
}

/// The derivative's derivative by the state in mode contact.
fn jacobian_contact(given: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let constants = given.constants.first_chunk::<6>()?;
    let state = given.state.first_chunk::<4>()?;
    let input = given.input;
    let L1 = constants[0];
    let M1 = constants[1];
    let J1 = constants[2];
    let J2 = constants[3];
    let k1 = constants[4];
    let k2 = constants[5];
    let theta_k = state[0];
    let theta_h = state[1];
    let theta_k_rate = state[2];
    let theta_h_rate = state[3];
    let s = input[0];
    let s_rate = input[1];
    let v0 = theta_k - theta_h;
    let ([sin_v0, sin_theta_k], [cos_v0, cos_theta_k]) = math::sin_cos_of_two([v0, theta_k]);
    let v1 = L1 * L1;
    let v2 = v1 * M1;
    let v3 = J1 + v2;
    let v4 = v2 * cos_v0;
    let v5 = J2 + 0.25 * v2;
    let v6 = 0.05 * sin_v0 + 0.4 * sin_theta_k - 0.1 * theta_h;
    let v7 = functions::larger(v6, 0.0);
    let v8 = math::powf(v7, 2.5);
    let v9 = 15.0 * sin_v0 + 120.0 * sin_theta_k - 30.0 * theta_h;
    let v10 = v2 * (theta_h_rate * theta_h_rate);
    let v11 = v2 * (theta_k_rate * theta_k_rate);
    let v12 = L1 * M1;
    let v13 = k2 * cos_theta_k;
    let v14 = k1 * (s - theta_k) + 0.01 * (k1 * (s_rate - theta_k_rate));
    let v15 = 0.001 * functions::softplus(v9);
    let v16 = v14 - v15 - v10 * sin_v0 - 9.81 * (v12 * cos_theta_k);
    let v17 = v16 - 0.4 * (v13 * v8);
    let v18 = k2 * cos_v0;
    let v19 = v15 + v11 * sin_v0 + 0.1 * (v18 * v8) - 0.02 * theta_h_rate;
    let v20 = v1 * v1 * (M1 * M1);
    let v21 = v3 * v5 - v20 * (cos_v0 * cos_v0);
    let v22 = 0.05 * cos_v0;
    let v23 = if v6 > 0.0 { v22 + 0.4 * cos_theta_k } else { 0.0 };
    let v24 = math::powf(v7, 1.5);
    let v25 = 15.0 * cos_v0;
    let v26 = functions::logistic(v9);
    let v27 = v10 * cos_v0;
    let v28 = v11 * cos_v0;
    let v29 = 9.81 * (v12 * sin_theta_k) + 0.4 * (k2 * sin_theta_k * v8);
    let v30 = 0.001 * ((v25 + 120.0 * cos_theta_k) * v26);
    let v31 = v29 - k1 - v30 - v27 - v13 * v23 * v24;
    let v32 = 0.1 * (k2 * sin_v0 * v8);
    let v33 = v30 + v28 + 0.25 * (v18 * v23 * v24) - v32;
    let v34 = v2 * sin_v0;
    let v35 = v34 * v19;
    let v36 = v20 * sin_v0 * cos_v0;
    let v37 = v21 * v21;
    let v38 = 2.0 * (v36 * (v5 * v17 - v4 * v19) / v37);
    let v39 = if v6 > 0.0 { -0.1 - v22 } else { 0.0 };
    let v40 = 0.001 * (v26 * (-30.0 - v25));
    let v41 = v27 - v40 - v13 * v24 * v39;
    let v42 = v32 + v40 + 0.25 * (v18 * v24 * v39) - v28;
    let v43 = -(0.01 * (k1 * v5)) - 2.0 * (v20 * theta_k_rate * sin_v0 * cos_v0);
    let v44 = 0.02 * v4 - 2.0 * (v2 * theta_h_rate * sin_v0 * v5);
    let v45 = v34 * v17;
    let v46 = 2.0 * (v36 * (v3 * v19 - v4 * v17) / v37);
    let v47 = 2.0 * (v2 * theta_k_rate * sin_v0 * v3) + 0.01 * (v2 * k1 * cos_v0);
    let v48 = 2.0 * (v20 * theta_h_rate * sin_v0 * cos_v0) - 0.02 * J1;
    let out = out.first_chunk_mut::<16>()?;
    out[0] = 0.0;
    out[1] = 0.0;
    out[2] = 1.0;
    out[3] = 0.0;
    out[4] = 0.0;
    out[5] = 0.0;
    out[6] = 0.0;
    out[7] = 1.0;
    out[8] = (v5 * v31 + v35 - v4 * v33) / v21 - v38;
    out[9] = v38 + (v5 * v41 - v35 - v4 * v42) / v21;
    out[10] = v43 / v21;
    out[11] = v44 / v21;
    out[12] = (v3 * v33 + v45 - v4 * v31) / v21 - v46;
    out[13] = v46 + (v3 * v42 - v45 - v4 * v41) / v21;
    out[14] = v47 / v21;
    out[15] = (v48 - 0.02 * v2) / v21;
    Some(())
}

/// The guard and its rate: release in mode contact.
fn guard_release_contact(given: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let state = given.state.first_chunk::<2>()?;
    let input = given.input;
    let theta_k = state[0];
    let theta_h = state[1];
    let s = input[0];
    let out = out.first_chunk_mut::<2>()?;
    out[0] = math::atan2(theta_k, theta_h);
    out[1] = s - theta_k;
    Some(())
}

/// The state to start from.
fn rest(given: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let state = given.state.first_chunk::<2>()?;
    let theta_k = state[0];
    let theta_h = state[1];
    let out = out.first_chunk_mut::<4>()?;
    out[0] = theta_k;
    out[1] = theta_h;
    out[2] = 0.333_333_333_333_333_3;
    out[3] = 1.5e-9;
    Some(())
}

/// The numbers of the drawing.
fn drawing(given: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let state = given.state.first_chunk::<1>()?;
    let extra = given.extra.first_chunk::<1>()?;
    let theta_k = state[0];
    let extra_0 = extra[0];
    let out = out.first_chunk_mut::<6>()?;
    out[0] = 0.333_333_333_333_333_3 * extra_0;
    out[1] = 123_456_789.0;
    out[2] = 0.333_333_333_333_333_3;
    out[3] = core::f64::consts::PI;
    out[4] = theta_k;
    out[5] = theta_k;
    Some(())
}
