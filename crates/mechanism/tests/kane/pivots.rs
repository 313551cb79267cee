//! Constraints whose slopes vanish one after the other on the way.

use instruments::equations::ModeNumber;
use mechanism::kane::derive_model;
use pode::stepper::{Any, Stepper};
use pode::{Guarded as _, Limits, Motion, RunRecorder, Simulator};

use crate::kane::runnable::{Run, described, model};

const PENDULUM: &str = r#"
name = "pendulum"
gravity = ["0", "-9.81 m/s^2"]
[coordinates]
x = { unit = "m", range = ["-2 m", "2 m"], speed_range = ["-10 m/s", "10 m/s"] }
y = { unit = "m", range = ["-2 m", "2 m"], speed_range = ["-10 m/s", "10 m/s"] }
[frames]
bob = { origin = ["x", "y"] }
[bodies]
bob = { frame = "bob", mass = "1 kg" }
[constraints]
rod = { zero = "x^2 + y^2 - 1 m^2" }
[outputs]
tension = { unit = "N/m", value = "reaction(rod)" }
[rest]
start = true
x = "1 m"
"#;

fn energy([_, y, u, v]: [f64; 4]) -> f64 {
    0.5 * (u * u + v * v) + 9.81 * y
}

/// Returns the largest errors of energy (J) and reaction (N) in 20 s.
fn errors(model: &Run<4>, method: impl Stepper, h: f64, start: [f64; 4]) -> [f64; 2] {
    let mut simulator = Simulator::new(*model, method, Limits::default(), ModeNumber(0), start);
    let mut recorder = RunRecorder::new(h).sampled(0.1);
    assert!(simulator.run(20.0, h, |_| Motion::default(), &mut recorder).is_completed());
    let states = recorder.samples().iter().map(|it| it.state);
    states.fold([0.0; 2], |[lost, pulled], it| {
        let mut tension = [0.0];
        model.outputs(ModeNumber(0), &it, &Motion::default(), &mut tension);
        // Towards the pivot: 2 r λ + the weight's part = −v²/r.
        let [x, y, u, v] = it;
        let pull = 2.0 * tension[0] - 9.81 * y + (u * u + v * v);
        assert!((x.hypot(y) - 1.0).abs() < 1e-13);
        [f64::max(lost, (energy(it) - energy(start)).abs()), f64::max(pulled, pull.abs())]
    })
}

#[test]
fn a_pendulum_in_x_and_y_keeps_its_energy_through_the_bottom_and_the_sides() {
    let model = model::<4>(described(PENDULUM), (0, 39));
    for start in [[1.0, 0.0, 0.0, 0.0], [0.0, -1.0, 7.0, 0.0]] {
        for (name, most) in [
            ("dop853", 1e-11),
            ("tsitouras5", 1e-11),
            ("rk4", 1e-8),
            ("by-need", 2e-3),
            ("linear-implicit-midpoint", 2e-3),
        ] {
            let method = Any::named(name).expect("a method");
            let [lost, pulled] = errors(&model, method, 1e-3, start);
            println!("{name} from {start:?}: {lost:.1e} J, {pulled:.1e} N");
            assert!(lost < most && pulled < 1e-12, "{name}: {lost:e} J, {pulled:e} N");
        }
    }
    let rk4 = |h| errors(&model, Any::named("rk4").expect("a method"), h, [1.0, 0.0, 0.0, 0.0])[0];
    assert!(rk4(1e-2) > 12.0 * rk4(5e-3), "of fourth order");
}

#[test]
fn it_rests_where_its_forces_balance() {
    let spring = "[springs]\nk = { stretch = \"x - 0.2 m\", stiffness = \"30 N/m\" }\n[rest]";
    let text = PENDULUM.replace("[rest]\nstart = true", spring).replace("\"1 m\"", "\"0.6 m\"");
    let model = model::<4>(described(&(text + "y = \"-0.8 m\"\n")), (0, 39));
    let (mode, x) = model.at_rest(&Motion::default());
    // SciPy's brentq on 9.81 sin θ + 30 (sin θ − 0.2) cos θ.
    let angle: f64 = 0.150_862_027_218_291;
    assert!((x[0] - angle.sin()).abs() < 1e-12 && x[2].abs() < 1e-12, "{x:?}");
    assert_eq!(model.constrain(mode, &x, &Motion::default()), x);
}

#[test]
fn an_elastic_wall_throws_it_back_without_a_loss() {
    let wall = "[contacts]\nwall = { gap = \"x + 0.3 m\", rigid = true, restitution = 1 }\n[rest]";
    let text = PENDULUM.replace("[rest]", wall).replace("\"1 m\"", "\"0.6 m\"");
    let model = model::<4>(described(&(text + "y = \"-0.8 m\"\n")), (0, 39));
    let start = [1.0, 0.0, 0.0, 0.0];
    let method = Any::named("dop853").expect("a method");
    let mut simulator = Simulator::new(model, method, Limits::default(), ModeNumber(0), start);
    let mut recorder = RunRecorder::new(1e-3).sampled(0.1);
    let outcome = simulator.run(5.0, 1e-3, |_| Motion::default(), &mut recorder);
    assert!(outcome.is_completed() && outcome.work.events > 2, "{outcome:?}");
    let lost = recorder.samples().iter().map(|it| energy(it.state).abs()).fold(0.0, f64::max);
    assert!(lost < 1e-11, "{lost:e} J");
}

#[test]
fn impossible_independent_speeds_are_said() {
    let modes = "[modes.motion]\nindependent = [\"x'\"]\n[outputs]";
    let said = derive_model("it.toml", &PENDULUM.replace("[outputs]", modes), &()).unwrap_err();
    assert!(said.to_string().contains("do not follow from x' by the constraints rod"), "{said}");
}
