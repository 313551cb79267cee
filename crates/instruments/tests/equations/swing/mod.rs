//! A pendulum that hangs from an arm on a spring, as a table and functions.

use std::sync::LazyLock;

use instruments::equations::table::{
    Arguments, AutomatonTable, ConstantTable, DrawingTable, DriveTable, Equations, ForceTable,
    Freedom, FunctionId, Functions, GuardTable, MidiTable, ModeTable, ModelTable, NamedQuantity,
    ParameterTable, PartTable, PresetTable, Reading, RequirementTable, RestTable, SoundTable,
    WayTable,
};
use pode::{EquationKind, Fires, GuardId, GuardSpec, Part, Reads};

#[derive(Clone, Copy, Debug)]
pub struct Swing;

const CONSTANTS: FunctionId = 0;
const PRESET: FunctionId = 1;
const PER_METRE: FunctionId = 2;
const DERIVATIVE: FunctionId = 3;
const JACOBIAN: FunctionId = 4;
const READOUT: FunctionId = 5;
const SLOPES: FunctionId = 6;
const OUTPUTS: FunctionId = 7;
const BALANCE: FunctionId = 8;
const GUARD: FunctionId = 9;
const RESET: FunctionId = 10;
const SOUNDS: FunctionId = 11;
const REST: FunctionId = 12;
const MARGIN: FunctionId = 13;
const DRAWING: FunctionId = 14;

fn write<const K: usize>(out: &mut [f64], values: [f64; K]) {
    for (place, value) in out.iter_mut().zip(values) {
        *place = value;
    }
}

impl Functions for Swing {
    /// Constants: k (1/s²), g/l (1/s²), and their sum; state: angle and its rate.
    fn call(&self, function: FunctionId, arguments: &Arguments<'_>, out: &mut [f64]) {
        let Arguments { constants: c, state: x, input: s, extra } = *arguments;
        match function {
            CONSTANTS => write(out, [c[0] + c[1]]),
            PRESET => write(out, [20.0 + extra[0], 5.0]),
            PER_METRE => write(out, [2.0]),
            DERIVATIVE => write(out, [x[1], c[0] * (s[0] - x[0]) - c[1] * x[0].sin()]),
            JACOBIAN => write(out, [0.0, 1.0, -c[0] - c[1] * x[0].cos(), 0.0]),
            READOUT => write(out, [c[0] * (s[0] - x[0])]),
            SLOPES => write(out, [c[0], 0.0]),
            OUTPUTS => write(out, [x[0], c[0] * (s[0] - x[0]), c[2]]),
            BALANCE => {
                let stretch = s[0] - x[0];
                let stored = 0.5 * c[0] * stretch * stretch;
                let energy = 0.5 * x[1] * x[1] + stored - c[1] * x[0].cos();
                write(out, [energy, c[0] * stretch * s[1], 0.0]);
            }
            GUARD => write(out, [0.5 - x[0], -x[1]]),
            RESET => write(out, [0.5, -x[1], 7.0]),
            SOUNDS => write(out, [x[1].abs()]),
            REST => write(out, [s[0], 0.0]),
            MARGIN => write(out, [c[0] - 1.0]),
            DRAWING => write(out, [-1.0, -1.0, 1.0, 1.0, c[0]]),
            _ => {}
        }
    }
}

const STOP: GuardSpec = GuardSpec {
    id: GuardId(3),
    name: "stop",
    priority: 0,
    scale: 1.0,
    fires: Fires::WhileNegative,
    reads: Reads::State,
};

const FORCES: ForceTable = ForceTable {
    readout: READOUT,
    slopes: SLOPES,
    outputs: OUTPUTS,
    balance: BALANCE,
    averaged: None,
};

fn mode() -> ModeTable {
    ModeTable {
        name: "swing",
        derivative: DERIVATIVE,
        parts: vec![PartTable {
            entries: 3,
            derivative: DERIVATIVE,
            kind: EquationKind::Conservative,
            loss: None,
            reads: Reads::StateAndInput,
        }],
        part_list: vec![Part::WHOLE],
        forces: FORCES,
        jacobian: Some(JACOBIAN),
        kind: EquationKind::Conservative,
        guards: vec![GuardTable {
            id: 3,
            name: "stop",
            unit: "",
            priority: 0,
            scale: 1.0,
            fires: Fires::WhileNegative,
            reads: Reads::State,
            value: GUARD,
            bound: None,
            closes: None,
            pressed: None,
            ways: vec![WayTable {
                when: None,
                to: 0,
                reset: Some(RESET),
                resting: None,
                releases: None,
            }],
            sounds: Some(SOUNDS),
        }],
        guard_specs: vec![STOP],
        freedom: Freedom { n: 1, m: 0, p: 1 },
        ..ModeTable::NOTHING
    }
}

fn parameter(name: &'static str) -> ParameterTable {
    ParameterTable {
        name,
        title: name.into(),
        unit: "1/s²",
        range: (0.0, 1e6),
        doc: "a stiffness".into(),
        reading: Reading::default(),
    }
}

const fn quantity(name: &'static str) -> NamedQuantity {
    NamedQuantity { name, unit: "1" }
}

pub static TABLE: LazyLock<ModelTable> = LazyLock::new(|| ModelTable {
    name: "swing",
    summary: "a pendulum on a spring".into(),
    parameters: vec![parameter("k"), parameter("weight")],
    presets: vec![PresetTable { name: "default", doc: "graded".into(), values: PRESET }],
    states: vec![quantity("angle"), quantity("rate")],
    coordinates: 1,
    constants: ConstantTable {
        count: 3,
        derive: CONSTANTS,
        requirements: vec![RequirementTable { text: "k > 1".into(), margin: MARGIN }],
    },
    input: DriveTable { quantity: quantity("s"), per_metre: PER_METRE },
    modes: vec![mode()],
    contacts: vec![],
    automata: AutomatonTable { contacts: vec![], guards: vec![STOP], impacts: vec![] },
    outputs: vec![quantity("angle"), quantity("F"), quantity("sum")],
    rest: RestTable { mode: 0, instead: vec![], state: REST, is_improved: true },
    sound: SoundTable { damper: None, midi: MidiTable::HAMMER },
    drawing: DrawingTable { numbers: DRAWING, count: 5, bodies: vec![], springs: vec![] },
});

impl Equations for Swing {
    fn table(&self) -> &ModelTable {
        &TABLE
    }
}
