//! Newton's cradle: five pendulums whose balls touch at rest, under both laws of impact.

use pode::contacts::restitution::{ContactJacobian, Contacts, Resolved};
use pode::stepper::Rk4;
use pode::{
    GuardId, GuardSpec, GuardValue, Guarded, Limits, Model, Reset, Resets, RunRecorder, Simulator,
};

use crate::common::{G, all_completed, close, run};

/// Length of a pendulum (m); its balls have 1 kg.
const LENGTH: f64 = 0.2;

/// Neighbours closer than this (m) touch.
const TOUCHING: f64 = 1e-9;

/// Displacements from rest along the arc (m), then speeds (m/s).
type State = [f64; 10];

type Law = fn(&Contacts<4>) -> Resolved<4>;

const LAWS: [(&str, Law); 2] =
    [("sequential", Contacts::sequential), ("simultaneous", Contacts::simultaneous)];

#[derive(Clone, Copy, Debug)]
struct Cradle {
    restitution: f64,
    /// Law for all contacts that touch; without one, each guard resolves its own pair alone.
    law: Option<Law>,
}

impl Cradle {
    fn lifted(self, lifted: usize, angle: f64) -> Simulator<Self, Rk4> {
        let start = std::array::from_fn(|i| if i < lifted { -angle * LENGTH } else { 0.0 });
        Simulator::new(self, Rk4, Limits::default(), (), start)
    }
}

/// Returns the energy above rest (J) of balls of 1 kg.
fn energy(x: &State) -> f64 {
    let height = |s: f64| LENGTH * (1.0 - (s / LENGTH).cos());
    (0..5).map(|i| G * height(x[i]) + 0.5 * x[i + 5].powi(2)).sum()
}

fn momentum(x: &State) -> f64 {
    x[5..].iter().sum()
}

impl Model for Cradle {
    type Mode = ();
    type State = State;
    type Input = ();
    const COORDS: usize = 5;

    fn derivative(&self, (): (), x: &State, (): &()) -> State {
        std::array::from_fn(|i| match i {
            0..5 => x[i + 5],
            _ => -G * (x[i - 5] / LENGTH).sin(),
        })
    }
}

impl Guarded for Cradle {
    fn guards(&self, (): ()) -> &'static [GuardSpec] {
        const GAPS: [GuardSpec; 4] = [
            GuardSpec::new(0, "first gap").scaled(LENGTH),
            GuardSpec::new(1, "second gap").scaled(LENGTH),
            GuardSpec::new(2, "third gap").scaled(LENGTH),
            GuardSpec::new(3, "fourth gap").scaled(LENGTH),
        ];
        &GAPS
    }

    fn guard(&self, (): (), id: GuardId, x: &State, (): &()) -> GuardValue {
        let i = usize::from(id.0);
        GuardValue::new(x[i + 1] - x[i], x[i + 6] - x[i + 5])
    }
}

impl Resets for Cradle {
    fn reset(&self, (): (), id: GuardId, x: &State, (): &()) -> Reset<Self> {
        let unit = |i: usize, j: usize| if i == j { 1.0 } else { 0.0 };
        let row = |i: usize, j: usize| unit(i + 1, j) - unit(i, j);
        let jacobian = ContactJacobian {
            rows: std::array::from_fn(|i| std::array::from_fn(|j| row(i, j))),
            inverse_mass: std::array::from_fn(|i| std::array::from_fn(|j| unit(i, j))),
        };
        let speeds: [f64; 5] = std::array::from_fn(|i| x[i + 5]);
        let touches = std::array::from_fn(|i| match self.law {
            Some(_) => x[i + 1] - x[i] < TOUCHING,
            None => i == usize::from(id.0),
        });
        let law = self.law.unwrap_or(Contacts::sequential);
        let contacts = jacobian.contacts(&speeds, [self.restitution; 4]).among(touches);
        let after = jacobian.speeds_after(&speeds, &law(&contacts).impulses);
        Reset::to((), std::array::from_fn(|i| if i < 5 { x[i] } else { after[i - 5] }))
    }
}

#[track_caller]
fn check_impacts(what: &str, recorder: &RunRecorder<Cradle>, lost: f64) {
    assert!(!recorder.events().is_empty(), "{what}: nothing has touched");
    for seen in recorder.events() {
        let what = format_args!("{what}, {} s", seen.t).to_string();
        close(&what, momentum(&seen.after), momentum(&seen.before), 1e-13);
        let gained = energy(&seen.after) - energy(&seen.before);
        assert!(gained < 1e-13 && -gained <= lost + 1e-13, "{what}: gained {gained:e} J");
    }
}

#[test]
fn an_elastic_cradle_keeps_its_energy_for_30_s_under_both_laws() {
    for (name, law) in LAWS {
        for lifted in 1..5 {
            let what = format!("{name}, {lifted} lifted");
            let mut cradle = Cradle { restitution: 1.0, law: Some(law) }.lifted(lifted, 0.5);
            let before = energy(cradle.state());
            let (recorder, ticks) = run(&mut cradle, 1e-3, 0.0, 30.0);
            all_completed(&ticks);
            check_impacts(&what, &recorder, 0.0);
            // RK4 with 7 rad/s at 1 ms loses (7e-3)⁶ / 144 of the energy per step.
            close(&what, energy(cradle.state()), before, 1e-9 * before);
        }
    }
}

/// Returns the period (s) at this amplitude (rad), by the arithmetic-geometric mean.
fn period(amplitude: f64) -> f64 {
    let (mut a, mut b) = (1.0, (0.5 * amplitude).cos());
    for _ in 0..8 {
        (a, b) = (0.5 * (a + b), (a * b).sqrt());
    }
    std::f64::consts::TAU * (LENGTH / G).sqrt() / a
}

#[test]
fn one_ball_in_is_one_ball_out_each_half_period() {
    let cradle = Cradle { restitution: 1.0, law: Some(Contacts::sequential) };
    let (recorder, ticks) = run(&mut cradle.lifted(1, 0.5), 1e-3, 0.0, 30.0);
    all_completed(&ticks);
    let fastest = (2.0 * G * LENGTH * (1.0 - 0.5_f64.cos())).sqrt();
    for (n, seen) in recorder.events().iter().enumerate() {
        let expected = period(0.5) * (0.25 + 0.5 * n as f64);
        close(format_args!("impact {n}"), seen.t, expected, 1e-7);
        let moves = if n % 2 == 0 { 9 } else { 5 };
        close(format_args!("impact {n}"), seen.after[moves].abs(), fastest, 1e-8);
        let others = (5..10).filter(|i| *i != moves).map(|i| seen.after[i].abs());
        assert!(others.fold(0.0, f64::max) < 1e-12, "impact {n}: {:?}", seen.after);
    }
    let half_periods = 30.0 / (0.5 * period(0.5));
    close("impacts", recorder.events().len() as f64, half_periods, 0.5);
}

#[test]
fn a_cradle_with_losses_swings_as_one_after_a_while_under_both_laws() {
    for (name, law) in LAWS {
        for (lifted, restitution) in [(1, 0.9), (2, 0.5), (3, 0.0), (1, 0.05)] {
            let what = format!("{name}, {lifted} lifted, e = {restitution}");
            let mut cradle = Cradle { restitution, law: Some(law) }.lifted(lifted, 0.1);
            let (recorder, ticks) = run(&mut cradle, 1e-3, 0.0, 30.0);
            all_completed(&ticks);
            check_impacts(&what, &recorder, f64::INFINITY);
            let apart = |x: &State| {
                let mean = momentum(x) / 5.0;
                (5..10).map(|i| 0.5 * (x[i] - mean).powi(2)).sum::<f64>()
            };
            let first = apart(&recorder.events()[0].before);
            // Some 66 meetings; each leaves at most e² of the energy of the balls' relative motion.
            let last = apart(cradle.state());
            assert!(last < 1e-3 * first, "{what}: {first:e} J to {last:e} J apart");
        }
    }
}

#[test]
fn pairs_that_only_know_each_other_fit_the_default_limits() {
    for (restitution, lost) in [(1.0, 0.0), (0.9, f64::INFINITY)] {
        for (lifted, angle) in [(1, 0.5), (2, 0.5), (3, 0.5), (4, 0.5), (1, 1e-3), (2, 1e-3)] {
            let what = format!("{lifted} lifted to {angle}, e = {restitution}");
            let mut cradle = Cradle { restitution, law: None }.lifted(lifted, angle);
            let (recorder, ticks) = run(&mut cradle, 1e-3, 0.0, 30.0);
            all_completed(&ticks);
            check_impacts(&what, &recorder, lost);
        }
    }
}
