//! The table of a lever with a hammer on it, about as large as the models of pianos: something to
//! emit, whose equations nobody reads.

use contacts::{ContactSpec, FrictionSpec};
use equations::table::{
    BodyTable, ContactModeTable, ContactTable, DamperTable, DrawingTable, Freedom, GuardTable,
    Material, MidiTable, ModeTable, ModelTable, NamedQuantity, OutlineTable, ParameterTable,
    PresetTable, PressureKind, PressureTable, RequirementTable, RestTable, RestingTable,
    SpringTable, WayTable,
};
use pode::{EquationKind, Fires, GuardId, GuardSpec, Part, Reads};

const LENGTH: (f64, f64) = (1e-3, 10.0);

const fn parameter(name: &'static str, unit: &'static str) -> ParameterTable {
    ParameterTable {
        name,
        title: "A name for people",
        unit,
        range: LENGTH,
        doc: "One line about it, with \"quotes\", a \\ and signs like µ that is long enough to be \
              broken into two lines of text in the emitted file",
    }
}

const MODE: ModeTable = ModeTable {
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
            WayTable { when: Some(2), to: 1, reset: Some(7), resting: Some(RESTING) },
            WayTable { when: None, to: 0, reset: None, resting: None },
        ],
        sounds: Some(2),
    }],
    guard_specs: &[RELEASE],
    contacts: &[CONTACT],
    freedom: Freedom { n: 2, m: 0, p: 2 },
};

const RESTING: RestingTable = RestingTable { to: 1, state: 7, meeting: 6 };

const RELEASE: GuardSpec = GuardSpec {
    id: GuardId(0),
    name: "release",
    priority: 0,
    scale: 1.0,
    fires: Fires::OnCrossing,
    reads: Reads::StateAndInput,
};

const STRING: ContactSpec = ContactSpec::new("string", 1e-3).with_friction(FrictionSpec {
    name: "rub",
    force: 1.0,
    slip: 1e-3,
    slack: 0.0,
});

/// The example's table.
pub static TABLE: ModelTable = ModelTable {
    name: "lever-with-hammer",
    summary: "A lever with a hammer on it",
    parameters: &[
        parameter("L1", "m"),
        parameter("M1", "kg"),
        parameter("J1", "kg*m^2"),
        parameter("J2", "kg*m^2"),
        parameter("k1", "N*m/rad"),
        parameter("k2", "N/m"),
        parameter("a very long name that no identifier should have", "1"),
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
    modes: &[MODE, ModeTable { name: "free'", kind: EquationKind::Affine, guards: &[], ..MODE }],
    contacts: &[ContactTable { name: "string", gap: Some(1e-3), friction: None }],
    contact_specs: &[STRING],
    guard_specs: &[RELEASE],
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

const CONTACT: ContactModeTable = ContactModeTable {
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
};
