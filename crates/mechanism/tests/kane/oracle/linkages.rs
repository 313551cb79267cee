use pode::stepper::Rk4;
use pode::{Limits, Motion, RunRecorder, Simulator};
use serde_json::{Value, json};

use instruments::equations::ModeNumber;

use crate::kane::evaluation::Derived;
use crate::kane::runnable::Runnable;

/// Three different rods in a chain, with a spring and a damper in the last joint.
const CHAIN: &str = r#"
name = "chain"
gravity = ["0", "-9.81 m/s^2"]

[coordinates]
a = { unit = "rad", range = [-10, 10], speed_range = [-60, 60] }
b = { unit = "rad", range = [-10, 10], speed_range = [-60, 60] }
c = { unit = "rad", range = [-10, 10], speed_range = [-60, 60] }

[frames]
A = { in = "ground", turn = "a" }
B = { in = "A", origin = ["0.1 m"], turn = "b" }
C = { in = "B", origin = ["0.08 m", "0.01 m"], turn = "c" }

[bodies]
A = { frame = "A", mass = "0.05 kg", centre = ["0.04 m", "0.005 m"], inertia = "5e-5 kg*m^2" }
B = { frame = "B", mass = "0.03 kg", centre = ["0.05 m"], inertia = "2e-5 kg*m^2" }
C = { frame = "C", mass = "0.04 kg", centre = ["0.03 m", "-0.01 m"], inertia = "3e-5 kg*m^2" }

[springs]
c = { stretch = "0.4 rad - c", stiffness = "0.01 N*m/rad", damping = "2e-5 N*m*s/rad" }

[rest]
mode = "motion"
start = true
"#;

/// Step of the finer run (s): a hundredth of a radian and less.
const STEP: f64 = 5e-5;

/// Interval of the comparison (s), and its length.
const EVERY: f64 = 0.05;
const UNTIL: f64 = 0.5;

pub(super) fn cases() -> Vec<Value> {
    vec![chain(), four_bar()]
}

fn chain() -> Value {
    let derived = Derived::described(CHAIN, 0);
    let [rows, coarse] = motions(&derived, &[-0.4, 0.9, -0.5, 3.0, -6.0, 2.0], 0.0);
    let body = |parent: i32, at: [f64; 2], mass: f64, centre: [f64; 2], inertia: f64| json!({ "parent": parent, "at": at, "mass": mass, "centre": centre, "inertia": inertia });
    json!({
        "name": "chain of three", "step": STEP, "rows": rows, "coarse": coarse,
        "bodies": [
            body(-1, [0.0, 0.0], 0.05, [0.04, 0.005], 5e-5),
            body(0, [0.1, 0.0], 0.03, [0.05, 0.0], 2e-5),
            body(1, [0.08, 0.01], 0.04, [0.03, -0.01], 3e-5),
        ],
        "spring": { "joint": 2, "rest": 0.4, "stiffness": 0.01, "damping": 2e-5 },
    })
}

/// Returns the shipped linkage: the coupler's angle is to the crank in the other program.
fn four_bar() -> Value {
    let mut derived = Derived::shipped("linkage");
    // Soft enough for a wide swing.
    derived.set("k", 0.01);
    let input = 0.3;
    let start = [0.2, 0.6, 1.3, 8.0, 0.0, 0.0];
    let start = derived.consistent(0, &start, [input, 0.0, 0.0, 0.0]);
    let relative = |rows: Vec<Vec<f64>>| -> Vec<Vec<f64>> {
        rows.into_iter()
            .map(|it| vec![it[0], it[1], it[2] - it[1], it[3], it[4], it[5] - it[4], it[6]])
            .collect()
    };
    let [rows, coarse] = motions(&derived, &start, input).map(relative);
    let of = |name: &str| derived.value_of(name);
    let rod = |parent: i32, at: f64, mass: &str, length: &str| {
        let (mass, length) = (of(mass), of(length));
        json!({
            "parent": parent, "at": [at, 0.0], "mass": mass, "centre": [0.5 * length, 0.0],
            "inertia": mass * length * length / 12.0,
        })
    };
    json!({
        "name": "four-bar linkage", "rows": rows, "coarse": coarse,
        "bodies": [
            rod(-1, 0.0, "m1", "crank"), rod(0, of("crank"), "m2", "coupler"),
            rod(-1, of("base"), "m3", "rocker"),
        ],
        "spring": { "joint": 0, "rest": input, "stiffness": of("k"), "damping": of("b") },
        "connect": { "bodies": [1, 2], "at": [of("coupler"), 0.0] },
    })
}

fn motions(derived: &Derived, start: &[f64], input: f64) -> [Vec<Vec<f64>>; 2] {
    let start: [f64; 6] = start.try_into().expect("three bodies");
    let still = Motion { position: input, ..Motion::default() };
    let model = derived.model::<6>();
    [STEP, 2.0 * STEP].map(|h| motion(&model, (still, start), h))
}

fn motion(model: &Runnable<6>, (still, start): (Motion, [f64; 6]), h: f64) -> Vec<Vec<f64>> {
    let mut simulator = Simulator::new(*model, Rk4, Limits::default(), ModeNumber(0), start);
    let mut recorder = RunRecorder::new(h).sampled(EVERY);
    assert!(simulator.run(UNTIL, h, |_| still, &mut recorder).is_completed());
    let rows = recorder.samples().iter();
    rows.map(|it| [it.t].into_iter().chain(it.state).collect()).collect()
}
