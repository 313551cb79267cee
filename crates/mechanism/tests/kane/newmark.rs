//! Newmark's method on the grand's action, against RK4 in steps of 20 µs.

use instruments::equations::ModeNumber;
use pode::contacts::WithContacts;
use pode::stepper::{Any, Newmark, Rk4};
use pode::{Energetic as _, Limits, Motion, RunRecorder, Simulator, Stepper};

use crate::kane::runnable::{Run, ShippedModel, described, mass, shipped};

type Action = WithContacts<Run<16>>;

fn action(name: &str) -> Action {
    let shipped = ShippedModel::of(described(&shipped(name)).program);
    WithContacts::new(shipped.valued(&shipped.values(0, 39))).expect("few guards")
}

/// Returns the motion of a press by `way` (m) from 20 ms on in `duration` (s): a minimum-jerk path.
fn press(way: f64, duration: f64, t: f64) -> Motion {
    let z = ((t - 0.02) / duration).clamp(0.0, 1.0);
    let scaled = |value: f64, power: i32| way * value / duration.powi(power);
    Motion {
        position: scaled(z.powi(3) * (10.0 + z * (6.0 * z - 15.0)), 0),
        rate: scaled(30.0 * (z * (1.0 - z)).powi(2), 1),
        acceleration: scaled(60.0 * z * (1.0 - z) * (1.0 - 2.0 * z), 2),
        jerk: scaled(60.0 * (1.0 - 6.0 * z * (1.0 - z)), 3),
    }
}

struct Stroke {
    times: Vec<f64>,
    /// Speeds of the hammer where it meets and leaves the string (rad/s).
    speeds: Vec<f64>,
    /// Forces on the finger and energies, each ms.
    forces: Vec<f64>,
    energies: Vec<f64>,
    evaluations: Vec<u32>,
}

fn stroke<T: Stepper>(
    model: &Action,
    (stepper, h): (T, f64),
    (way, duration, until): (f64, f64, f64),
) -> Stroke {
    let input = |t: f64| press(way, duration, t);
    let (mode, x) = model.system().at_rest(&Motion::default());
    let (mode, x) = model.start(mode, &x, &Motion::default());
    let mut simulator = Simulator::new(*model, stepper, Limits::default(), mode, x);
    let mut recorder = RunRecorder::new(h).sampled(1e-3);
    assert!(simulator.run(until, h, input, &mut recorder).is_completed());
    let samples = recorder.samples();
    let hammer = model.system().table().states.iter().position(|it| it.name == "w_h");
    let hammer = hammer.unwrap_or_default();
    Stroke {
        times: recorder.times(),
        speeds: recorder.events().iter().map(|it| it.after[hammer]).collect(),
        forces: samples.iter().map(|it| it.readout).collect(),
        energies: samples.iter().map(|it| model.energy(it.mode, &it.state, &it.input)).collect(),
        evaluations: recorder.ticks().iter().map(|it| it.work.derivatives).collect(),
    }
}

fn largest_error(one: &[f64], other: &[f64], count: usize) -> f64 {
    assert_eq!(one.len(), other.len());
    let pairs = one.iter().zip(other).take(count);
    pairs.fold(0.0, |most: f64, (x, y)| most.max((x - y).abs()))
}

#[test]
fn a_soft_press_takes_two_steps_a_tick_and_moves_the_finger_as_fine_steps_do() {
    let (grand, case) = (action("grand"), (0.0112, 0.6, 0.7));
    let fine = stroke(&grand, (Rk4, 1e-4), case);
    let it = stroke(&grand, (Newmark::default(), 1e-3), case);
    assert!(it.times.is_empty() && fine.times.is_empty(), "no strike");
    let error = largest_error(&it.forces, &fine.forces, usize::MAX);
    assert!(error < 1e-3, "{error} N");
    let most = it.evaluations.iter().skip(1).max().copied();
    assert!(most <= Some(5), "two or four steps, one repeated at most: {most:?}");
    let mean = it.evaluations.iter().sum::<u32>() as usize / it.evaluations.len();
    assert_eq!(mean, 2);
}

#[test]
fn a_loud_stroke_is_that_of_fine_steps_and_makes_no_energy() {
    let (grand, case) = (action("grand"), (0.0115, 0.043_125, 0.25));
    let fine = stroke(&grand, (Rk4, 2e-5), case);
    let it = stroke(&grand, (Newmark::default(), 1e-3), case);
    assert_eq!((it.times.len(), fine.times.len()), (2, 2), "the hammer meets the string once");
    let error = it.times[0] - fine.times[0];
    assert!(error.abs() < 1e-6, "the strike is {error} s late");
    for (side, (speed, expected)) in it.speeds.iter().zip(&fine.speeds).enumerate() {
        assert!((speed / expected - 1.0).abs() < 3e-3, "{side}: {speed} is not {expected} rad/s");
    }
    let before = (0..250).take_while(|ms| f64::from(*ms) * 1e-3 < fine.times[0]).count() - 1;
    let error = largest_error(&it.forces, &fine.forces, before);
    assert!(error < 0.05, "{error} N before the strike");
    // The finger stands from 63.1 ms on.
    for (at, pair) in it.energies.windows(2).enumerate().skip(65) {
        assert!(pair[1] - pair[0] < 1e-6, "{} J made at {at} ms", pair[1] - pair[0]);
    }
    let quiet = it.evaluations.iter().enumerate().filter(|(tick, _)| *tick > 65);
    let most = quiet.map(|it| *it.1).max();
    assert!(most <= Some(6), "{most:?} evaluations in a tick");
}

/// Actions with the largest RMS error of the force in a loud stroke (N), and with the mean and the
/// largest number of evaluations in a tick.
const ACTIONS: [(&str, f64, f64, u32); 10] = [
    ("grand", 0.06, 2.4, 13),
    ("upright", 0.03, 2.1, 9),
    ("organ", 0.002, 2.05, 6),
    ("viennese", 0.012, 2.1, 7),
    ("harpsichord", 0.003, 2.1, 7),
    ("celesta", 0.006, 2.1, 13),
    ("rhodes", 0.015, 2.15, 13),
    ("clavichord", 0.0003, 2.05, 5),
    ("hammond", 0.0015, 2.05, 7),
    ("synth", 0.0011, 2.05, 6),
];

#[test]
fn every_action_with_felts_is_played_with_two_to_four_steps_a_tick() {
    let case = (0.0115, 0.043_125, 0.4);
    let mut wrong = Vec::new();
    for (name, most_error, most_mean, most_in_tick) in ACTIONS {
        let action = action(name);
        let fine = stroke(&action, (Rk4, 2e-5), case);
        let it = stroke(&action, (Newmark::default(), 1e-3), case);
        let squares = it.forces.iter().zip(&fine.forces).map(|(a, b)| (a - b).powi(2));
        let error = (squares.sum::<f64>() / it.forces.len() as f64).sqrt();
        let mean = f64::from(it.evaluations.iter().sum::<u32>()) / it.evaluations.len() as f64;
        let most = it.evaluations.iter().max().copied().unwrap_or_default();
        let events = (it.times.len(), fine.times.len());
        let is_right = events.0 == events.1
            && error <= most_error
            && mean <= most_mean
            && most <= most_in_tick;
        if !is_right {
            wrong.push(format!("{name}: {error} N, {mean} and {most} evaluations, {events:?}"));
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

/// Returns a mass of 1 kg between a spring to the input and nothing else.
fn oscillator(stiffness: f64, loss: f64, more: &str) -> WithContacts<Run<2>> {
    let model = mass(&format!(
        r#"
coordinates.x = {{ unit = "m", range = ["-1 m", "1 m"], speed_range = ["-10 m/s", "10 m/s"] }}
frames.mass = {{ in = "ground", origin = ["x", "0 m"] }}
bodies.mass = {{ frame = "mass", mass = "1 kg" }}
springs.spring = {{ stretch = "x - s", stiffness = "{stiffness:?} N/m", damping = "{loss:?} N*s/m" }}
{more}
"#
    ));
    WithContacts::new(model).expect("few guards")
}

/// Returns the states at the ends of `n` ticks of `h` (s), from x = 1 m at rest.
fn states(
    model: &WithContacts<Run<2>>,
    input: impl Fn(f64) -> Motion + Copy,
    (h, n): (f64, usize),
) -> Vec<[f64; 2]> {
    let (mode, _) = model.start(ModeNumber(0), &[0.0; 2], &input(0.0));
    let method = Newmark { tolerance: f64::INFINITY };
    let mut simulator = Simulator::new(*model, method, Limits::default(), mode, [1.0, 0.0]);
    let one = |tick: usize| {
        let line = |at: usize| (tick + at) as f64 * h;
        let outcome = simulator.run(line(1), h, input, &mut pode::Silent);
        assert!(outcome.is_completed());
        *simulator.state()
    };
    (0..n).map(one).collect()
}

/// Returns the rate of an undamped motion in steps of `h`: 2 cos ωh = (x₊ + x₋)/x.
fn rate(states: &[[f64; 2]], h: f64) -> f64 {
    let (mut over, mut under) = (0.0, 0.0);
    for window in states.windows(3) {
        over += (window[0][0] + window[2][0]) * window[1][0];
        under += 2.0 * window[1][0].powi(2);
    }
    (over / under).acos() / h
}

const fn still(_: f64) -> Motion {
    Motion { position: 0.0, rate: 0.0, acceleration: 0.0, jerk: 0.0 }
}

#[test]
fn a_driven_and_damped_motion_has_order_two() {
    // x'' + 2d x' + w² x = w² s + 2d s' with s = sin 1000 t.
    const W: f64 = 5e3;
    const D: f64 = 1e3;
    const P: f64 = 1e3;
    let input = |t: f64| Motion {
        position: (P * t).sin(),
        rate: P * (P * t).cos(),
        acceleration: -P * P * (P * t).sin(),
        jerk: -P * P * P * (P * t).cos(),
    };
    let exact = |t: f64| {
        let (a, b, f) = (W * W - P * P, 2.0 * D * P, W * W);
        // (f + ib)/(a + ib), by its real and imaginary part.
        let size = a.hypot(b).powi(2);
        let (sine, cosine) = (a.mul_add(f, b.powi(2)) / size, b * (a - f) / size);
        let w = (W * W - D * D).sqrt();
        let c = 1.0 - cosine;
        let s = (D * c - P * sine) / w;
        (-D * t).exp() * (c * (w * t).cos() + s * (w * t).sin())
            + sine * (P * t).sin()
            + cosine * (P * t).cos()
    };
    let model = oscillator(W * W, 2.0 * D, "");
    let error = |n: usize| {
        let states = states(&model, input, (1e-3 / n as f64, n));
        (states[n - 1][0] - exact(1e-3)).abs()
    };
    let errors = [32, 64, 128].map(error);
    for pair in errors.windows(2) {
        let order = (pair[0] / pair[1]).log2();
        assert!((order - 2.0).abs() < 0.1, "{errors:?}: order {order}");
    }
}

#[test]
fn the_frequency_of_an_oscillator_errs_by_the_fourth_power_of_the_step() {
    const OMEGA: f64 = 8e3;
    let model = oscillator(OMEGA * OMEGA, 0.0, "");
    for radians in [0.4, 0.8] {
        let h = radians / OMEGA;
        let states = states(&model, still, (h, 400));
        let error = rate(&states[20..], h) / OMEGA - 1.0;
        let expected = radians.powi(4) / 480.0;
        assert!((error.abs() / expected - 1.0).abs() < 0.1, "{radians}: {error} for {expected}");
    }
}

#[test]
fn a_spring_of_any_stiffness_is_stable_and_loses_nothing() {
    for radians in [2.0_f64, 2.4, 2.5, 3.0, 10.0, 1e3, 1e6] {
        let h = 6e-5;
        let model = oscillator((radians / h).powi(2), 0.0, "");
        let states = states(&model, still, (h, 2000));
        let most = states.iter().fold(0.0, |most: f64, x| most.max(x[0].abs()));
        assert!(most < 3.0, "{radians} rad a step: {most}");
        let last = states[1000..].iter().fold(0.0, |most: f64, x| most.max(x[0].abs()));
        assert!(last > 0.3, "{radians} rad a step: {last} is left");
    }
}

#[test]
fn a_mode_with_dry_friction_is_stepped_by_rk4() {
    let bearing = r#"frictions.bearing = { slip = "x'", stiction = "2 N", kinetic = "1.5 N" }"#;
    let model = oscillator(80.0, 0.0, bearing);
    let input = |t: f64| press(0.1, 0.05, t);
    let (mode, x) = model.start(ModeNumber(0), &[0.0; 2], &Motion::default());
    let run = |method: &str| {
        let method = Any::named(method).expect("a method");
        let mut simulator = Simulator::new(model, method, Limits::default(), mode, x);
        let mut recorder = RunRecorder::new(1e-3);
        assert!(simulator.run(0.2, 1e-3, input, &mut recorder).is_completed());
        (simulator.state().map(f64::to_bits), recorder.work().derivatives)
    };
    assert_eq!(run("newmark"), run("rk4"));
}
