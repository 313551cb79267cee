//! Branches of equations over the state, against closed forms, with five methods each.

use std::f64::consts::PI;

use instruments::equations::ModeNumber;
use mechanism::kane::derive_model;
use pode::contacts::WithContacts;
use pode::stepper::{ByNeed, Dop853, Exact, LinearImplicitMidpoint, Rk4};
use pode::{Limits, Motion, RunRecorder, Simulator, Stepper};

use crate::kane::runnable::{Run, described, model};
use crate::kane::shipped::Folder;

const MASS: &str = r#"
name = "mass"
summary = "a mass on a line"
[input]
name = "s"
unit = "m"
per_metre = "1"
[coordinates]
x = { unit = "m", range = ["-1 m", "1 m"], speed_range = ["-10 m/s", "10 m/s"] }
[frames]
b = { in = "ground", origin = ["x", "0 m"] }
[bodies]
b = { frame = "b", mass = "1 kg" }
[rest]
start = true
"#;

/// A mass of 1 kg on a line, with the laws of `tables`.
fn mass(tables: &str) -> Run<2> {
    model(described(&format!("{MASS}{tables}")), (0, 0))
}

type Start = ([f64; 2], f64);

/// The end of a run in steps of 1 ms under a constant input, and the times of all events.
fn run<T: Stepper>(
    stepper: T,
    model: &Run<2>,
    (x, input): Start,
    until: f64,
) -> ([f64; 2], Vec<f64>) {
    let input = Motion { position: input, ..Motion::default() };
    let model = WithContacts::new(*model).unwrap();
    let (mode, x) = model.start(ModeNumber(0), &x, &input);
    let mut simulator = Simulator::new(model, stepper, Limits::default(), mode, x);
    let mut recorder = RunRecorder::new(1e-3);
    let outcome = simulator.run(until, 1e-3, |_| input, &mut recorder);
    assert!(outcome.is_completed(), "{}: {outcome:?}", T::NAME);
    (*simulator.state(), recorder.times())
}

/// The ends and events of five methods, each with its name and tolerance.
fn five(model: &Run<2>, x: Start, until: f64) -> [(&'static str, f64, [f64; 2], Vec<f64>); 5] {
    let named = |name, tolerance, (end, events)| (name, tolerance, end, events);
    [
        named(Rk4::NAME, 1e-10, run(Rk4, model, x, until)),
        named(Dop853::NAME, 1e-12, run(Dop853, model, x, until)),
        named(Exact::NAME, 1e-12, run(Exact, model, x, until)),
        named(ByNeed::NAME, 1e-12, run(ByNeed::default(), model, x, until)),
        // Its phase is off by (ωh)²/12 of 1e-5.
        named(LinearImplicitMidpoint::NAME, 3e-5, run(LinearImplicitMidpoint, model, x, until)),
    ]
}

#[test]
fn a_force_that_begins_at_a_place_acts_from_there() {
    let field = r#"field = { stretch = "x", force = "if(x > 0.1 m, 100 N, 0 N)", energy = "0 J" }"#;
    let field = mass(&format!("[forces]\n{field}"));
    // In at 0.1 s with 1 m/s; out again 2 · 1/100 s later.
    for (name, _, x, events) in five(&field, ([0.0, 1.0], 0.0), 0.3) {
        assert_eq!(events.len(), 2, "{name}: {events:?}");
        assert!((events[0] - 0.1).abs() < 1e-12 && (events[1] - 0.12).abs() < 1e-12, "{events:?}");
        assert!((x[0] + 0.08).abs() < 1e-11 && (x[1] + 1.0).abs() < 1e-11, "{name}: {x:?}");
    }
}

/// From x0, half a swing of π/10 s leads to −x0 less 2 · 2/100 m; it holds within 0.02 m.
#[test]
fn a_friction_of_constant_size_brakes_and_holds() {
    let forces = r#"rub = { stretch = "x", force = "2 N*sign(x')", energy = "0 J" }"#;
    let spring = r#"spring = { stretch = "x", stiffness = "100 N/m" }"#;
    let rubbed = mass(&format!("[forces]\n{forces}\n[springs]\n{spring}"));
    for (start, swings, rest) in [(0.13, 3.0, -0.01), (0.11, 3.0, 0.01), (0.035, 1.0, 0.005)] {
        for (name, tolerance, x, events) in five(&rubbed, ([start, 0.0], 0.0), 2.0) {
            let last = events.last().copied().unwrap_or(0.0);
            let (time, place) = (last - swings * PI / 10.0, x[0] - rest);
            assert!(time.abs() < tolerance, "{name} from {start}: {events:?}");
            assert!(place.abs() < tolerance && x[1].abs() < 1e-12, "{name} from {start}: {x:?}");
        }
    }
}

/// From turn to turn the spring's energy falls by friction times way, 1 N below 0.05 m and 2 N above.
#[test]
fn branches_in_branches_have_the_sides_of_each_other() {
    let forces = r#"rub = { stretch = "x", force = "if(x > 0.05 m, 2 N*sign(x'), 1 N*sign(x'))", energy = "0 J" }"#;
    let spring = r#"spring = { stretch = "x", stiffness = "100 N/m" }"#;
    let rubbed = mass(&format!("[forces]\n{forces}\n[springs]\n{spring}"));
    let outer = |x: f64| 0.05_f64.max(x) - 0.05;
    let mut x: f64 = 0.13;
    while 100.0 * x.abs() > if x > 0.05 { 2.0 } else { 1.0 } {
        // 50 (x² − y²) = |x − y| + |outer(x) − outer(y)|: y by iteration from −x.
        let way = |y: f64| (x - y).abs() + (outer(x) - outer(y)).abs();
        x = (0..200).fold(-x, |y, _| way(y) / (50.0 * (x - y)) - x);
    }
    for (name, tolerance, end, _) in five(&rubbed, ([0.13, 0.0], 0.0), 2.5) {
        assert!((end[0] - x).abs() < tolerance, "{name}: {end:?}, not {x}");
    }
}

#[test]
fn a_key_on_the_edge_of_a_detent_rests_there() {
    let force = r#"step = { stretch = "x", force = "if(x > 5 mm, 60 N, 0 N)", energy = "0 J" }"#;
    let spring = r#"finger = { stretch = "x - s", stiffness = "40 kN/m", damping = "200 N*s/m" }"#;
    let detent = mass(&format!("[forces]\n{force}\n[springs]\n{spring}"));
    // 40 N of the finger hold it at the edge; behind it 1.5 mm make up for the 60 N.
    for (finger, expected) in [(6e-3, 5e-3), (10e-3, 8.5e-3)] {
        for (name, _, x, events) in five(&detent, ([0.0, 0.0], finger), 0.4) {
            assert!((x[0] - expected).abs() < 1e-9, "{name}: {x:?} after {}", events.len());
        }
    }
}

#[test]
fn what_rest_does_not_touch_keeps_the_budget() {
    let felt = r#"felt = { compression = "x - 0.1 m", stiffness = "1e8 N/m", exponent = 1 }"#;
    let felt = mass(&format!("[felts]\n{felt}"));
    let (x, _) = run(ByNeed::default(), &felt, ([0.0, 1.0], 0.0), 0.3);
    // It is in the felt for half a swing of 1e4 rad/s.
    let expected = 0.1 - (0.2 - PI / 1e4);
    assert!((x[0] - expected).abs() < 1e-9 && (x[1] + 1.0).abs() < 1e-9, "{x:?}");
    let weight = r#"weight = { stretch = "x", force = "9.81 N", energy = "9.81 N*x" }"#;
    let hard = (r#"stiffness = "1e9 N/m""#, 1e-9);
    // 11 impacts, each half a swing, at most 2 of the budget per radian.
    let curved = (r#"stiffness = "1e9 N/m^1.5", exponent = 1.5"#, 11.0 * PI * 2.0 * ByNeed::BUDGET);
    for (law, share) in [hard, curved] {
        let floor = format!("floor = {{ gap = \"x\", {law} }}");
        let falls = mass(&format!("[contacts]\n{floor}\n[forces]\n{weight}"));
        let (x, events) = run(ByNeed::default(), &falls, ([0.01, 0.0], 0.0), 1.0);
        let energy = 9.81 * x[0] + 0.5 * x[1] * x[1];
        assert_eq!(events.len(), 22);
        assert!((energy / 0.0981 - 1.0).abs() < share, "{law}: {energy}");
    }
}

#[test]
fn a_guard_that_stays_at_zero_is_refused() {
    let derived = |positive: &str| {
        let guard = format!("name = \"end\"\npositive = \"{positive}\"\nto = \"free\"");
        let text = format!("{MASS}mode = \"free\"\n[[modes.free.guards]]\n{guard}");
        derive_model("it.toml", &text, &Folder)
    };
    for positive in ["max(x, 0)", "if(x > 0 m, 2*x, 0 m)", "(x + abs(x))/2"] {
        let mistakes = derived(positive).expect_err("it never fires").to_string();
        assert!(mistakes.contains("stays at zero"), "{positive}: {mistakes}");
    }
    assert!(derived("max(x, x' * 1 s)").is_ok());
}
