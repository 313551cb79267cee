//! Emitted from `lever-with-hammer.toml` by `letoff model emit`; not to be changed by hand.
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

use contacts::{ContactSpec, FrictionSpec};
use equations::functions;
use equations::table::{
    Arguments, BodyTable, ContactModeTable, ContactTable, DamperTable, DrawingTable, Freedom,
    FunctionId, Functions, GuardTable, Material, MidiTable, ModeTable, ModelTable, NamedQuantity,
    OutlineTable, ParameterTable, PresetTable, PressureKind, PressureTable, RequirementTable,
    RestTable, RestingTable, SpringTable, WayTable,
};
use pode::{EquationKind, Fires, GuardId, GuardSpec, Part, Reads, math};

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
        NamedQuantity { name: "theta_k", unit: "rad" },
        NamedQuantity { name: "theta_h", unit: "rad" },
        NamedQuantity { name: "theta_k'", unit: "rad/s" },
        NamedQuantity { name: "theta_h'", unit: "rad/s" },
    ],
    coordinates: 2,
    constants: 8,
    derive_constants: 0,
    input: NamedQuantity { name: "s", unit: "rad" },
    input_per_metre: 2,
    modes: &[
        ModeTable {
            name: "contact",
            derivative: 1,
            parts: &[],
            part_list: &[Part::of(&[0, 2]), Part::WHOLE.of_state()],
            slaved: None,
            projection: None,
            projected: 0,
            longest_projection: Some(7),
            readout: 2,
            slopes: 3,
            outputs: 4,
            balance: 3,
            jacobian: 5,
            series: None,
            kind: EquationKind::Smooth,
            loss: Some(2),
            is_stiffening: true,
            guards: &[GuardTable {
                id: 0,
                name: "release",
                unit: "",
                priority: 0,
                scale: 1.0,
                fires: Fires::OnCrossing,
                reads: Reads::StateAndInput,
                value: 6,
                bound: None,
                ways: &[
                    WayTable {
                        when: Some(2),
                        to: 1,
                        reset: Some(7),
                        resting: Some(RestingTable { to: 1, state: 7, meeting: 6 }),
                    },
                    WayTable { when: None, to: 0, reset: None, resting: None },
                ],
                sounds: Some(2),
            }],
            guard_specs: &[GuardSpec {
                id: GuardId(0),
                name: "release",
                priority: 0,
                scale: 1.0,
                fires: Fires::OnCrossing,
                reads: Reads::StateAndInput,
            }],
            contacts: &[ContactModeTable {
                contact: 0,
                gap: Some(6),
                bound: None,
                normal: Some(1),
                jacobian: Some(5),
                balance: None,
                slip: None,
                slip_bound: None,
                limits: None,
                response: None,
                slopes: None,
                sounds: None,
            }],
            freedom: Freedom { n: 2, m: 0, p: 2 },
        },
        ModeTable {
            name: "free'",
            derivative: 1,
            parts: &[],
            part_list: &[Part::of(&[0, 2]), Part::WHOLE.of_state()],
            slaved: None,
            projection: None,
            projected: 0,
            longest_projection: Some(7),
            readout: 2,
            slopes: 3,
            outputs: 4,
            balance: 3,
            jacobian: 5,
            series: None,
            kind: EquationKind::Affine,
            loss: Some(2),
            is_stiffening: true,
            guards: &[],
            guard_specs: &[GuardSpec {
                id: GuardId(0),
                name: "release",
                priority: 0,
                scale: 1.0,
                fires: Fires::OnCrossing,
                reads: Reads::StateAndInput,
            }],
            contacts: &[ContactModeTable {
                contact: 0,
                gap: Some(6),
                bound: None,
                normal: Some(1),
                jacobian: Some(5),
                balance: None,
                slip: None,
                slip_bound: None,
                limits: None,
                response: None,
                slopes: None,
                sounds: None,
            }],
            freedom: Freedom { n: 2, m: 0, p: 2 },
        },
    ],
    contacts: &[ContactTable { name: "string", gap: Some(0.001), friction: None }],
    contact_specs: &[ContactSpec {
        name: "string",
        gap: Some(0.001),
        friction: Some(FrictionSpec { name: "rub", force: 1.0, slip: 0.001, slack: 0.0 }),
    }],
    guard_specs: &[GuardSpec {
        id: GuardId(0),
        name: "release",
        priority: 0,
        scale: 1.0,
        fires: Fires::OnCrossing,
        reads: Reads::StateAndInput,
    }],
    outputs: &[NamedQuantity { name: "F", unit: "N" }],
    rest: RestTable { mode: 0, instead: &[], state: 7, is_improved: true },
    damper: Some(DamperTable { lift: 0.005, fall: 0.0046, softest_tone: 0.15 }),
    midi: MidiTable {
        speeds: Some((0.05, 1.5)),
        velocity: Some(64),
        pressure: Some(PressureTable { kind: PressureKind::Key, range: (5.0, 15.0) }),
    },
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

    #[inline(always)]
    fn derivative(&self, function: FunctionId, given: &Arguments<'_>, out: &mut [f64]) {
        let done = match function {
            1 => derivative_contact(given, out),
            _ => None,
        };
        if done.is_none() {
            out.fill(f64::NAN);
        }
    }

    #[inline(always)]
    fn readout(&self, function: FunctionId, given: &Arguments<'_>, out: &mut [f64]) {
        let done = match function {
            2 => input_per_metre(given, out),
            _ => None,
        };
        if done.is_none() {
            out.fill(f64::NAN);
        }
    }

    #[inline(always)]
    fn guard(&self, function: FunctionId, given: &Arguments<'_>, out: &mut [f64]) {
        let done = match function {
            6 => guard_release_contact(given, out),
            _ => None,
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
#[inline(always)]
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
    let v1 = L1 * (L1 * M1);
    let v2 = J2 + 0.25 * v1;
    let ([sin_theta_k, sin_v0], [cos_theta_k, cos_v0]) = math::sin_cos_of_two([theta_k, v0]);
    let v3 = sin_theta_k - 0.25 * (theta_h - 0.5 * sin_v0);
    let v4 = 9.81 * cos_theta_k + L1 * (theta_h_rate * (theta_h_rate * sin_v0));
    let v5 = k1 * (s - theta_k + 0.01 * (s_rate - theta_k_rate));
    let v6 = math::powf(functions::larger(0.4 * v3, 0.0), 2.5);
    let v7 = k2 * v6;
    let v8 = 0.001 * functions::softplus(120.0 * v3);
    let v9 = v5 + L1 * (M1 * -v4) - v8 - 0.4 * (cos_theta_k * v7);
    let v10 = theta_k_rate * theta_k_rate * v1 * sin_v0 - 0.02 * theta_h_rate;
    let v11 = v10 + v8 + 0.1 * (cos_v0 * v7);
    let v12 = v1 * cos_v0;
    let v13 = J1 + v1;
    let v14 = 1.0 / (v13 * v2 - v12 * v12);
    let out = out.first_chunk_mut::<4>()?;
    [out[0], out[1]] = [theta_k_rate, theta_h_rate];
    out[2] = v14 * (v2 * v9 - v12 * v11);
    out[3] = v14 * (v13 * v11 - v12 * v9);
    Some(())
}

/// Input per metre of key-front travel.
#[inline(always)]
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
    let v1 = L1 * M1;
    let v2 = L1 * v1;
    let v3 = J2 + 0.25 * v2;
    let ([sin_theta_k, sin_v0], [cos_theta_k, cos_v0]) = math::sin_cos_of_two([theta_k, v0]);
    let v4 = sin_theta_k - 0.25 * (theta_h - 0.5 * sin_v0);
    let v5 = 120.0 * v4;
    let v6 = theta_h_rate * sin_v0;
    let v7 = M1 * -(9.81 * cos_theta_k + L1 * theta_h_rate * v6);
    let v8 = k1 * (s - theta_k + 0.01 * (s_rate - theta_k_rate));
    let v9 = 0.4 * v4;
    let v10 = functions::larger(v9, 0.0);
    let v11 = math::powf(v10, 2.5);
    let v12 = k2 * v11;
    let v13 = 0.001 * functions::softplus(v5);
    let v14 = v8 + L1 * v7 - v13 - 0.4 * (cos_theta_k * v12);
    let v15 = v2 * sin_v0;
    let v16 = theta_k_rate * theta_k_rate;
    let v17 = v16 * v15 - 0.02 * theta_h_rate + v13 + 0.1 * (cos_v0 * v12);
    let v18 = v2 * cos_v0;
    let v19 = J1 + v2;
    let v20 = 1.0 / (v19 * v3 - v18 * v18);
    let v21 = v15 * v18;
    let v22 = v20 * (v21 * v20);
    let v23 = cos_v0 + 8.0 * cos_theta_k;
    let v24 = functions::logistic(v5);
    let v25 = theta_h_rate * theta_h_rate * v18;
    let v26 = math::powf(v10, 1.5);
    let v27 = if v9 > 0.0 { 0.05 * v23 } else { 0.0 };
    let v28 = 0.4 * (sin_theta_k * v11) - cos_theta_k * v27 * v26;
    let v29 = 0.001 * (15.0 * v23 * v24);
    let v30 = 9.81 * (v1 * sin_theta_k) - k1 - v25 - v29 + k2 * v28;
    let v31 = v15 * v17;
    let v32 = k2 * v26;
    let v33 = cos_v0 * v32;
    let v34 = v16 * v18 - 0.1 * (sin_v0 * v12);
    let v35 = 0.25 * (v27 * v33) + (v29 + v34);
    let v36 = 2.0 * (v22 * (v3 * v14 - v18 * v17));
    let v37 = if v9 > 0.0 { -(0.1 + 0.05 * cos_v0) } else { 0.0 };
    let v38 = 0.001 * (-(30.0 + 15.0 * cos_v0) * v24);
    let v39 = v25 - v38 - cos_theta_k * v37 * v32;
    let v40 = 0.25 * (v37 * v33) + (v38 - v34);
    let v41 = -(0.01 * (k1 * v3) + 2.0 * (theta_k_rate * v21)) * v20;
    let v42 = L1 * L1;
    let v43 = v42 * (M1 * (0.02 * cos_v0 - 2.0 * (v3 * v6))) * v20;
    let v44 = v15 * v14;
    let v45 = 2.0 * (v22 * (v19 * v17 - v18 * v14));
    let v46 = 0.01 * (k1 * cos_v0) + 2.0 * (theta_k_rate * v19 * sin_v0);
    let out = out.first_chunk_mut::<16>()?;
    [out[0], out[1], out[2], out[3], out[4], out[5], out[6]] = [0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0];
    out[7] = 1.0;
    out[8] = v20 * (v31 + v3 * v30 - v18 * v35) - v36;
    out[9] = v36 + v20 * (v3 * v39 - v31 - v18 * v40);
    [out[10], out[11]] = [v41, v43];
    out[12] = v20 * (v19 * v35 + (v44 - v18 * v30)) - v45;
    out[13] = v45 + v20 * (v19 * v40 - (v18 * v39 + v44));
    out[14] = v42 * (M1 * v46) * v20;
    out[15] = (2.0 * (theta_h_rate * v21) - 0.02 * v19) * v20;
    Some(())
}

/// The guard and its rate: release in mode contact.
#[inline(always)]
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
    [out[0], out[1]] = [theta_k, theta_h];
    out[2] = 0.333_333_333_333_333_3;
    out[3] = 1.5e-9;
    Some(())
}

/// The numbers of the drawing.
fn drawing(given: &Arguments<'_>, out: &mut [f64]) -> Option<()> {
    let state = given.state.first_chunk::<1>()?;
    let extra = given.extra.first_chunk::<1>()?;
    let theta_k = state[0];
    let out = out.first_chunk_mut::<6>()?;
    out[0] = 0.333_333_333_333_333_3 * extra[0];
    out[1] = 123_456_789.0;
    out[2] = 0.333_333_333_333_333_3;
    out[3] = core::f64::consts::PI;
    [out[4], out[5]] = [theta_k, theta_k];
    Some(())
}
