//! A model with a contact: its modes have codes and names, and its energy stays.

use contacts::ContactSpec;
use descriptions::register_model;
use equations::table::{
    Arguments, ContactModeTable, ContactTable, FunctionId, Functions, ModeTable, ModelTable,
};
use models::catalogue::{self, Visitor};
use models::{ModeName, Playable};
use pode::stepper::Rk4;
use pode::{Limits, Motion, Simulator, State as _};

use crate::ball::{Ball, FLIGHT, TABLE};

/// Stiffness of the floor (N/m).
const STIFFNESS: f64 = 1e4;

const GAP: FunctionId = 100;
const PUSH: FunctionId = 101;
const PUSH_JACOBIAN: FunctionId = 102;
const PUSH_BALANCE: FunctionId = 103;

/// The ball on a floor that gives way.
#[derive(Debug)]
struct SoftFloor;

impl Functions for SoftFloor {
    fn call(&self, function: FunctionId, arguments: &Arguments<'_>, out: &mut [f64]) {
        let Arguments { constants, state, input, .. } = *arguments;
        let (GAP..=PUSH_BALANCE) = function else { return Ball.call(function, arguments, out) };
        let mass = constants[2];
        let (gap, rate) = (state[0] - input[0], state[1] - input[1]);
        let force = -STIFFNESS * gap;
        let values: &[f64] = match function {
            GAP => &[gap, rate],
            PUSH => &[0.0, force / mass],
            PUSH_JACOBIAN => &[0.0, 0.0, -STIFFNESS / mass, 0.0],
            _ => &[force, 0.5 * STIFFNESS * gap * gap, force * input[1], 0.0],
        };
        for (place, value) in out.iter_mut().zip(values) {
            *place = *value;
        }
    }
}

static SOFT: ModelTable = ModelTable {
    name: "soft-floor",
    modes: &[ModeTable {
        name: "free",
        guards: &[],
        guard_specs: &[],
        contacts: &[ContactModeTable {
            contact: 0,
            gap: Some(GAP),
            bound: None,
            normal: Some(PUSH),
            jacobian: Some(PUSH_JACOBIAN),
            balance: Some(PUSH_BALANCE),
            slip: None,
            slip_bound: None,
            limits: None,
            response: None,
            slopes: None,
            sounds: None,
        }],
        ..FLIGHT
    }],
    contacts: &[ContactTable { name: "floor", gap: Some(1.0), friction: None }],
    contact_specs: &[ContactSpec::new("floor", 1.0)],
    drawing: equations::table::DrawingTable { count: 0, ..TABLE.drawing },
    ..TABLE
};

/// Names of the modes in the order in which they came, and the energies (J).
struct Drop;

impl Visitor for Drop {
    type Output = (Vec<String>, Vec<f64>, Vec<f64>);

    fn visit<M: Playable>(self, model: M) -> Self::Output {
        let still = Motion::default();
        let (mode, state) = model.at_rest(&still);
        let mut simulator = Simulator::new(model, Rk4, Limits::default(), mode, state);
        let (mut names, mut energies, mut heights) = (Vec::new(), Vec::new(), Vec::new());
        for _ in 0..1000 {
            simulator.advance(1e-3, &|_: f64| still, &mut pode::Silent);
            let mode = simulator.mode();
            let code = model.mode_code(mode);
            assert_eq!(model.mode(code), Some(mode), "{code:?}");
            let name = ModeName::new(&model, code).to_string();
            if names.last() != Some(&name) {
                names.push(name);
            }
            energies.push(model.energy(mode, simulator.state(), &still));
            heights.push(simulator.state().entries()[0]);
        }
        (names, energies, heights)
    }
}

#[test]
fn a_ball_on_a_soft_floor_comes_back_to_where_it_fell_from() {
    let entry = register_model(&SOFT, &SoftFloor, None).unwrap();
    let guards: Vec<_> = entry.modes[0].guards.iter().map(|it| (it.name, it.to)).collect();
    assert_eq!(guards, [("floor", &["free"][..])]);
    let (names, energies, heights) = catalogue::visit(entry, Drop).unwrap();
    assert_eq!(names, ["free", "free floor=closed", "free"]);
    let most = energies.iter().fold(0.0, |most: f64, it| most.max((it - 9.81).abs()));
    // RK4 loses (ω h)⁶/72 of it a step: 32 steps of 0.1 rad.
    assert!(most < 5e-6, "{most} J of 9.81 J");
    // Down by the root of ½ k d² = m g (h + d): 45.3 mm.
    let d = 9.81 / STIFFNESS * (1.0 + (1.0_f64 + 2.0 * STIFFNESS / 9.81).sqrt());
    let lowest = heights.iter().copied().fold(0.0, f64::min);
    assert!((lowest + d).abs() < 5e-5, "{lowest} m, {d} m by energy");
}

/// Names of the modes in which the model begins 1 mm above the floor and 1 mm in it, from the mode
/// with its contact open and from that with it closed.
struct Beginnings;

impl Visitor for Beginnings {
    type Output = [[String; 2]; 2];

    fn visit<M: Playable>(self, model: M) -> Self::Output {
        let still = Motion::default();
        let (open, above) = model.at_rest(&still);
        [1e-3, -1e-3].map(|height| {
            let mut state = above;
            state.as_mut()[0] = height;
            let (right, _) = model.begin(open, &state, &still);
            // The other mode is the one in which it begins at the other side.
            state.as_mut()[0] = -height;
            let (wrong, _) = model.begin(open, &state, &still);
            state.as_mut()[0] = height;
            [right, wrong].map(|from| {
                let (mode, begun) = model.begin(from, &state, &still);
                assert_eq!(begun, state);
                ModeName::new(&model, model.mode_code(mode)).to_string()
            })
        })
    }
}

#[test]
fn a_model_begins_with_what_overlaps_closed_and_the_rest_open() {
    let entry = register_model(&SOFT, &SoftFloor, None).unwrap();
    let begun = catalogue::visit(entry, Beginnings).unwrap();
    assert_eq!(begun, [["free", "free"], ["free floor=closed", "free floor=closed"]]);
}
