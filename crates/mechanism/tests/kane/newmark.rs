//! Newmark's method on the grand's action, against RK4 in steps of 20 µs.

use instruments::equations::ModeNumber;
use pode::contacts::WithContacts;
use pode::stepper::{Any, Newmark, Rk4};
use pode::{Energetic as _, Limits, Motion, RunRecorder, Simulator, Stepper};

use crate::kane::runnable::{Run, ShippedModel, described, model, shipped};

type Grand = WithContacts<Run<16>>;

fn grand() -> Grand {
    let shipped = ShippedModel::of(described(&shipped("grand")).program);
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
    model: &Grand,
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
    let hammer = hammer.expect("the hammer's speed");
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
    let (grand, case) = (grand(), (0.0112, 0.6, 0.7));
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
    let (grand, case) = (grand(), (0.0115, 0.043_125, 0.25));
    let fine = stroke(&grand, (Rk4, 2e-5), case);
    let it = stroke(&grand, (Newmark::default(), 1e-3), case);
    assert_eq!((it.times.len(), fine.times.len()), (2, 2), "the hammer meets the string once");
    let error = it.times[0] - fine.times[0];
    assert!(error.abs() < 1e-6, "the strike is {error} s late");
    for (side, (speed, expected)) in it.speeds.iter().zip(&fine.speeds).enumerate() {
        assert!((speed / expected - 1.0).abs() < 3e-3, "{side}: {speed} is not {expected} rad/s");
    }
    let before = (fine.times[0] / 1e-3) as usize;
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

#[test]
fn a_mode_with_dry_friction_is_stepped_by_rk4() {
    let rubbing = described(
        r#"
name = "rubbing"
summary = "a mass that is drawn over a table"
coordinates.x = { unit = "m", range = ["-1 m", "1 m"], speed_range = ["-10 m/s", "10 m/s"] }
frames.mass = { in = "ground", origin = ["x", "0 m"] }
bodies.mass = { frame = "mass", mass = "0.5 kg" }
springs.spring = { stretch = "s - x", stiffness = "80 N/m" }
frictions.bearing = { slip = "x'", stiction = "2 N", kinetic = "1.5 N" }
[input]
name = "s"
unit = "m"
per_metre = "1"

[modes.only]

[rest]
mode = "only"
"#,
    );
    let model: Run<2> = model(rubbing, (0, 0));
    let model = WithContacts::new(model).expect("few guards");
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
