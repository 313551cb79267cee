//! Cases C6 and C2: several roots within a step, touches, and a ball on a shaker.

use pode::stepper::Rk4;
use pode::{
    GuardId, GuardSpec, GuardValue, Guarded, Limits, Model, Reset, Resets, RunRecorder, Simulator,
};

use crate::common::{
    G, ONE, Timed, all_completed, close, count, each_step_and_phase, no_input, run,
};

/// Fires on each fall; a rise brings it back without a word.
const FALLS: [GuardSpec; 1] = [ONE[0].on_crossing()];

/// Asserts the times of the events in one tick of 1 s, and in many.
#[track_caller]
fn check(guard: fn(GuardId, f64) -> GuardValue, effect: Effect, expected: &[f64]) {
    for n in [1_u32, 3, 10, 1000] {
        let h = 1.0 / f64::from(n);
        let mut timed = Timed { guards: &FALLS, guard, effect }.start();
        let mut recorder = RunRecorder::new(h);
        for _ in 0..n {
            let _ = timed.advance(h, &no_input, &mut recorder);
        }
        let times = recorder.times();
        assert_eq!(times.len(), expected.len(), "{n} ticks: {times:?}");
        for (t, expected) in times.iter().zip(expected) {
            // Rounding of the guard, 1e-16, over its slope at the root, 0.08 at least.
            close(format_args!("{n} ticks"), *t, *expected, 1e-14);
        }
    }
}

type Effect = fn(GuardId, &mut [f64; 3]) -> bool;

/// Negated, for a mode is valid while its guard is positive.
fn three(_: GuardId, t: f64) -> GuardValue {
    let (a, b, c) = (t - 0.2, t - 0.4, t - 0.8);
    GuardValue::new(-a * b * c, -(b * c + a * c + a * b))
}

#[test]
fn the_first_of_three_roots_is_the_event() {
    check(three, count, &[0.2, 0.8]);
}

fn pair(_: GuardId, t: f64) -> GuardValue {
    GuardValue::new(0.06 - t * (0.5 - t), -0.5 + 2.0 * t)
}

#[test]
fn a_pair_of_roots_inside_a_step_is_found() {
    check(pair, count, &[0.2]);
}

#[test]
fn a_pair_of_roots_leaves_a_mode_and_comes_back() {
    check(pair, crate::common::count_and_flip, &[0.2, 0.3]);
}

/// A ball thrown upwards, watched from below 1 m.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Thrown;

impl Model for Thrown {
    type Mode = ();
    type State = [f64; 2];
    type Input = ();
    const COORDS: usize = 1;

    fn derivative(&self, (): (), x: &[f64; 2], (): &()) -> [f64; 2] {
        [x[1], -G]
    }

    fn readout(&self, (): (), _: &[f64; 2], (): &()) -> f64 {
        0.0
    }
}

impl Guarded for Thrown {
    fn guards(&self, (): ()) -> &'static [GuardSpec] {
        &FALLS
    }

    fn guard(&self, (): (), _: GuardId, x: &[f64; 2], (): &()) -> GuardValue {
        GuardValue::new(1.0 - x[0], -x[1])
    }
}

impl Resets for Thrown {
    fn reset(&self, (): (), _: GuardId, x: &[f64; 2], (): &()) -> Reset<Self> {
        Reset::to((), *x)
    }
}

#[test]
fn a_ball_that_peeps_over_a_line_crosses_it_once_upwards() {
    let check = |h: f64, phase: f64| {
        let start = [0.0, (2.0 * G * 1.05).sqrt()];
        let mut ball = Simulator::new(Thrown, Rk4, Limits::default(), (), start);
        let (recorder, _) = run(&mut ball, h, phase, 1.0);
        assert_eq!(recorder.events().len(), 1, "h {h}, phase {phase}");
        close(format_args!("h {h}"), recorder.events()[0].t, 0.361_710_296_415_529_76, 1e-12);
    };
    each_step_and_phase(check);
    // Both crossings, 0.2 s apart, in one step of 1 s.
    check(1.0, 0.0);
}

/// 10 ((t − t*)² − d) and its rate.
fn touch(t: f64, d: f64) -> GuardValue {
    let left = t - 0.123_456_789;
    GuardValue::new(10.0 * (left * left - d), 20.0 * left)
}

#[test]
fn a_touch_is_an_event_if_it_goes_through() {
    /// Depth of the dip, and the first root if there is one.
    type Case = (fn(GuardId, f64) -> GuardValue, Option<f64>);
    const CASES: [Case; 6] = [
        (|_, t| touch(t, -1e-10), None),
        (|_, t| touch(t, 0.0), None),
        (|_, t| touch(t, 1e-4), Some(0.113_456_789)),
        (|_, t| touch(t, 1e-6), Some(0.122_456_789)),
        (|_, t| touch(t, 1e-8), Some(0.123_356_789)),
        (|_, t| touch(t, 1e-10), Some(0.123_446_789)),
    ];
    for (guard, expected) in CASES {
        each_step_and_phase(|h, phase| {
            let mut timed = Timed { guards: &FALLS, guard, effect: count }.start();
            let (recorder, _) = run(&mut timed, h, phase, 0.25);
            let times = recorder.times();
            assert_eq!(times.len(), usize::from(expected.is_some()), "h {h}: {times:?}");
            for (t, expected) in times.into_iter().zip(expected) {
                // 2500 sums of the time round by 1e-14 at most.
                close(format_args!("h {h}, phase {phase}"), t, expected, 2e-14);
            }
        });
    }
}

/// Table A sin ωt, A = 2 mm, ω = 40π: time, then the ball's height and speed.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Shaker;

const AMPLITUDE: f64 = 2e-3;
const OMEGA: f64 = 40.0 * std::f64::consts::PI;

/// The table's height, speed and acceleration at `t` (s).
fn table(t: f64) -> [f64; 3] {
    let (sin, cos) = (OMEGA * t).sin_cos();
    [AMPLITUDE * sin, AMPLITUDE * OMEGA * cos, -AMPLITUDE * OMEGA * OMEGA * sin]
}

impl Model for Shaker {
    /// Whether the ball lies on the table.
    type Mode = bool;
    type State = [f64; 3];
    type Input = ();
    const COORDS: usize = 2;

    fn derivative(&self, on_table: bool, x: &[f64; 3], (): &()) -> [f64; 3] {
        let [_, v, a] = table(x[0]);
        if on_table { [1.0, v, a] } else { [1.0, x[2], -G] }
    }

    fn readout(&self, _: bool, _: &[f64; 3], (): &()) -> f64 {
        0.0
    }
}

impl Guarded for Shaker {
    fn guards(&self, on_table: bool) -> &'static [GuardSpec] {
        const LIFT: [GuardSpec; 1] = [GuardSpec::new(0, "lift-off").scaled(G)];
        const GAP: [GuardSpec; 1] = [GuardSpec::new(1, "landing").scaled(AMPLITUDE)];
        if on_table { &LIFT } else { &GAP }
    }

    fn guard(&self, on_table: bool, _: GuardId, x: &[f64; 3], (): &()) -> GuardValue {
        let [y, v, a] = table(x[0]);
        if on_table {
            GuardValue::new(G + a, -OMEGA * OMEGA * v)
        } else {
            GuardValue::new(x[1] - y, x[2] - v)
        }
    }
}

impl Resets for Shaker {
    fn reset(&self, on_table: bool, _: GuardId, x: &[f64; 3], (): &()) -> Reset<Self> {
        let [y, v, _] = table(x[0]);
        Reset::to(!on_table, [x[0], y, v])
    }
}

#[test]
fn a_ball_leaves_a_shaker_without_gap_speed_or_acceleration_and_lands() {
    each_step_and_phase(|h, phase| {
        let start = [0.0, 0.0, table(0.0)[1]];
        let mut ball = Simulator::new(Shaker, Rk4, Limits::default(), true, start);
        let (recorder, ticks) = run(&mut ball, h, phase, 0.055);
        all_completed(&ticks);
        let names: Vec<_> = recorder.events().iter().take(2).map(|seen| seen.name).collect();
        assert_eq!(names, ["lift-off", "landing"], "h {h}, phase {phase}");
        // Flight is a parabola and the table is known: rounding only.
        let [lift_off, landing] = [&recorder.events()[0], &recorder.events()[1]];
        close(format_args!("h {h}: lift-off"), lift_off.t, 0.002_513_355_797_052_246, 1e-14);
        close(format_args!("h {h}: landing"), landing.t, 0.051_865_286_988_733_95, 1e-14);
        let relative = landing.before[2] - table(landing.before[0])[1];
        close(format_args!("h {h}: speed"), relative, -0.489_701_201_981_647_3, 1e-12);
    });
}
