//! A ball on a floor that the key moves, as a table and functions: what a description becomes.
#![allow(
    dead_code,
    unreachable_pub,
    clippy::expect_used,
    reason = "helpers of tests; each program that has them uses its own part"
)]

use std::path::Path;
use std::sync::Arc;
use std::sync::atomic::AtomicBool;

use descriptions::{DescriptionFiles, DescriptionReader, ReadModel};
use diagnostics::{Diagnostic, Diagnostics};
use equations::table::{
    Arguments, BodyTable, DrawingTable, Freedom, FunctionId, Functions, GuardTable, Material,
    MidiTable, ModeTable, ModelTable, NamedQuantity, OutlineTable, ParameterTable, PresetTable,
    RestTable, WayTable,
};
use pode::{EquationKind, Fires, GuardSpec, Part, Reads};

pub const DERIVED: FunctionId = 0;
pub const PER_METRE: FunctionId = 1;
pub const PRESET: FunctionId = 2;
pub const START: FunctionId = 3;
pub const FALL: FunctionId = 4;
pub const NOTHING: FunctionId = 5;
pub const OUTPUTS: FunctionId = 6;
pub const ENERGY: FunctionId = 7;
pub const FALL_JACOBIAN: FunctionId = 8;
pub const FLOOR: FunctionId = 9;
pub const IMPACT: FunctionId = 10;
pub const ON_FLOOR: FunctionId = 11;
pub const WEIGHT: FunctionId = 12;
pub const LIFT: FunctionId = 13;
pub const SPEED: FunctionId = 14;
pub const PICTURE: FunctionId = 15;
pub const FLOOR_WEIGHT_POWER: FunctionId = 16;

/// The ball's arithmetic.
#[derive(Clone, Copy, Debug)]
pub struct Ball;

impl Functions for Ball {
    fn call(&self, function: FunctionId, arguments: &Arguments<'_>, out: &mut [f64]) {
        let Arguments { constants, state, input, extra } = *arguments;
        let [s, rate, acceleration, jerk] = *input;
        let c = |index: usize| constants.get(index).copied().unwrap_or(f64::NAN);
        let x = |index: usize| state.get(index).copied().unwrap_or(f64::NAN);
        let (g, e, mass, scale, weight) = (c(0), c(1), c(2), c(3), c(4));
        let energy = mass * (0.5 * x(1) * x(1) + g * x(0));
        let values: &[f64] = match function {
            DERIVED => &[mass * g],
            PER_METRE => &[scale],
            PRESET => &[9.81, 0.8, 1.0 - 0.005 * extra.first().copied().unwrap_or(0.0), 1.0],
            START => &[s + 1.0, 0.0],
            FALL => &[x(1), -g],
            OUTPUTS => &[x(0) - s, 0.0, x(0), 0.0],
            ENERGY => &[energy, 0.0, 0.0],
            FLOOR_WEIGHT_POWER => &[energy, (weight + mass * acceleration) * rate, 0.0],
            FALL_JACOBIAN => &[0.0, 1.0, 0.0, 0.0],
            FLOOR => &[x(0) - s, x(1) - rate],
            IMPACT => &[s, rate - e * (x(1) - rate), mass * (1.0 + e) * (rate - x(1))],
            ON_FLOOR => &[s, rate],
            WEIGHT => &[weight + mass * acceleration],
            LIFT => &[g + acceleration, jerk],
            SPEED => &[x(1).abs()],
            PICTURE => &[-0.1, -0.1, 0.1, 1.1, -0.01, 0.0, 0.01, 0.0],
            _ => &[0.0; 4],
        };
        for (place, value) in out.iter_mut().zip(values) {
            *place = *value;
        }
    }
}

const FLOOR_SPEC: [GuardSpec; 1] = [GuardSpec::new(0, "floor")];
const LIFT_SPEC: [GuardSpec; 1] = [GuardSpec::new(1, "lift")];

const fn guard(id: u8, name: &'static str, value: FunctionId) -> GuardTable {
    GuardTable {
        id,
        name,
        unit: "",
        priority: 0,
        scale: 1.0,
        fires: Fires::WhileNegative,
        reads: Reads::StateAndInput,
        value,
        bound: None,
        ways: &[],
        sounds: None,
    }
}

const fn way(to: u8, reset: Option<FunctionId>) -> WayTable {
    WayTable { when: None, to, reset, resting: None }
}

pub const fn quantity(name: &'static str, unit: &'static str) -> NamedQuantity {
    NamedQuantity { name, unit }
}

const fn parameter(name: &'static str, title: &'static str, unit: &'static str) -> ParameterTable {
    ParameterTable { name, title, unit, range: (0.0, 100.0), doc: "of the ball" }
}

pub const FLIGHT: ModeTable = ModeTable {
    name: "flight",
    derivative: FALL,
    part_list: &[Part::WHOLE],
    parts: &[],
    readout: NOTHING,
    slopes: NOTHING,
    outputs: OUTPUTS,
    balance: ENERGY,
    jacobian: FALL_JACOBIAN,
    kind: EquationKind::Affine,
    guards: &[GuardTable {
        ways: &[way(0, Some(IMPACT))],
        sounds: Some(SPEED),
        ..guard(0, "floor", FLOOR)
    }],
    guard_specs: &FLOOR_SPEC,
    freedom: Freedom { n: 1, m: 0, p: 1 },
    ..ModeTable::NOTHING
};

const REST: ModeTable = ModeTable {
    name: "rest",
    derivative: NOTHING,
    slaved: Some(ON_FLOOR),
    readout: WEIGHT,
    slopes: NOTHING,
    outputs: OUTPUTS,
    balance: FLOOR_WEIGHT_POWER,
    jacobian: NOTHING,
    guards: &[GuardTable { ways: &[way(0, None)], ..guard(1, "lift", LIFT) }],
    guard_specs: &LIFT_SPEC,
    freedom: Freedom { n: 1, m: 1, p: 0 },
    ..ModeTable::NOTHING
};

/// The ball's table.
pub static TABLE: ModelTable = ModelTable {
    name: "described-ball",
    summary: "a ball on a floor, from a table",
    parameters: &[
        parameter("g", "gravity", "m/s²"),
        parameter("e", "restitution", "1"),
        parameter("mass", "mass of the ball", "kg"),
        parameter("scale", "floor per key travel", "m/m"),
    ],
    presets: &[PresetTable { name: "heavy", doc: "lighter in the treble", values: PRESET }],
    requirements: &[],
    states: &[quantity("y", "m"), quantity("v", "m/s")],
    coordinates: 1,
    constants: 5,
    derive_constants: DERIVED,
    input: quantity("floor_height", "m"),
    input_per_metre: PER_METRE,
    modes: &[FLIGHT, REST],
    contacts: &[],
    contact_specs: &[],
    guard_specs: &[],
    outputs: &[
        quantity("gap", "m"),
        quantity("ball_x", "m"),
        quantity("ball_y", "m"),
        quantity("ball_angle", "rad"),
    ],
    rest: RestTable { mode: 0, instead: &[], state: START, is_improved: false },
    damper: None,
    midi: MidiTable::HAMMER,
    drawing: DrawingTable {
        numbers: PICTURE,
        count: 8,
        bodies: &[BodyTable {
            name: "ball",
            output: Some(1),
            outlines: &[
                OutlineTable {
                    material: Material::Felt,
                    is_closed: false,
                    points: (4, 2),
                    modes: &[],
                },
                OutlineTable {
                    material: Material::Metal,
                    is_closed: true,
                    points: (4, 2),
                    modes: &[1],
                },
            ],
        }],
        springs: &[],
    },
};

/// Reads any file that begins with `[modes` as the ball; the others are wrong in line 1.
#[derive(Debug)]
pub struct BallReader;

impl DescriptionReader for BallReader {
    fn read(
        &self,
        (path, text): (&Path, &str),
        _files: &DescriptionFiles,
        _is_cancelled: &Arc<AtomicBool>,
    ) -> Result<ReadModel, Diagnostics> {
        if text.starts_with("[modes") {
            return Ok(ReadModel { table: &TABLE, functions: &Ball });
        }
        Err(Diagnostics::new(vec![Diagnostic {
            file: path.display().to_string(),
            line: Some(1),
            column: Some(1),
            message: "this is no ball".to_owned(),
            help: "begin with [modes]".to_owned(),
        }]))
    }
}
