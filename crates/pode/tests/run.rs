//! Runs of many ticks, and their records.

use pode::stepper::{Dop853, Rk4};
use pode::{
    Advance, Fault, GuardId, GuardSpec, GuardValue, Guarded, Limits, Model, Resets, RunRecorder,
    Silent, Simulator, Work,
};

use crate::common::{Ball, BallMode, G, close};

#[derive(Clone, Copy, Debug, PartialEq)]
struct Integral {
    guards: &'static [GuardSpec],
}

const PASSES: [GuardSpec; 1] = [GuardSpec::new(0, "passes").on_crossing()];

impl Model for Integral {
    type Mode = ();
    type State = [f64; 1];
    type Input = f64;
    const COORDS: usize = 1;

    fn derivative(&self, (): (), _: &[f64; 1], input: &f64) -> [f64; 1] {
        [*input]
    }
}

impl Guarded for Integral {
    fn guards(&self, (): ()) -> &'static [GuardSpec] {
        self.guards
    }

    fn guard(&self, (): (), _: GuardId, x: &[f64; 1], input: &f64) -> GuardValue {
        GuardValue::new(1.0 - x[0], -input)
    }
}

impl Resets for Integral {}

#[derive(Clone, Copy, Debug, PartialEq)]
struct Undefined;

impl Model for Undefined {
    type Mode = ();
    type State = [f64; 1];
    type Input = ();
    const COORDS: usize = 1;

    fn derivative(&self, (): (), _: &[f64; 1], (): &()) -> [f64; 1] {
        [1.0]
    }
}

impl Guarded for Undefined {
    fn guards(&self, (): ()) -> &'static [GuardSpec] {
        &PASSES
    }
}

impl Resets for Undefined {}

#[test]
fn a_driven_model_follows_the_integral_of_its_input() {
    let model = Integral { guards: &PASSES };
    let mut simulator = Simulator::new(model, Rk4, Limits::default(), (), [0.0]);
    let mut recorder = RunRecorder::new(0.01).sampled(0.25);
    let report = simulator.run(2.0, 0.01, |t| 3.0 * t * t, &mut recorder);
    assert_eq!((report.advance, report.ticks), (Advance::Completed, 200));
    assert_eq!((report.work, report.work.events), (recorder.work(), 1));
    // x = t³, which RK4 follows exactly.
    close("end", simulator.state()[0], 8.0, 1e-13);
    close("passes one", recorder.times_of("passes")[0], 1.0, 1e-12);
    let event = &recorder.events()[0];
    let [before, after] = [event.before, event.after].map(|x| x[0].to_bits());
    assert_eq!(before, after, "the default reset map changes nothing");
    let times: Vec<f64> = recorder.samples().iter().map(|sample| sample.t).collect();
    assert_eq!(times, [0.0, 0.25, 0.5, 0.75, 1.0, 1.25, 1.5, 1.75, 2.0]);
    for sample in recorder.samples() {
        close(format_args!("sample at {}", sample.t), sample.state[0], sample.t.powi(3), 1e-13);
        close(format_args!("input at {}", sample.t), sample.input, 3.0 * sample.t.powi(2), 1e-11);
    }
}

#[test]
fn a_run_ends_at_the_nearest_line_and_goes_on_from_there() {
    let ticks = |until: f64| {
        let model = Integral { guards: &[] };
        let mut simulator = Simulator::new(model, Rk4, Limits::default(), (), [0.0]);
        let report = simulator.run(until, 0.1, |_| 1.0, &mut Silent);
        close("state", simulator.state()[0], report.ticks as f64 * 0.1, 1e-14);
        let again = simulator.run(until, 0.1, |_| f64::NAN, &mut Silent);
        assert_eq!(
            (again.advance, again.ticks, again.work),
            (Advance::Completed, 0, Work::default())
        );
        report.ticks
    };
    // 0.3 / 0.1 is a little less than 3.
    let found = [0.3, 0.34, 0.36, 0.0, -1.0, f64::NAN].map(ticks);
    assert_eq!(found, [3, 3, 4, 0, 0, 0]);
}

#[test]
fn a_run_stops_at_the_first_tick_that_is_not_completed() {
    let model = Integral { guards: &[] };
    let mut simulator = Simulator::new(model, Rk4, Limits::default(), (), [0.0]);
    let input = |t: f64| if t > 0.55 { f64::NAN } else { 1.0 };
    let report = simulator.run(1.0, 0.1, input, &mut Silent);
    assert_eq!((report.advance, report.ticks), (Advance::Faulty(Fault::State), 6));
    for h in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        let mut simulator = Simulator::new(model, Rk4, Limits::default(), (), [0.0]);
        let report = simulator.run(1.0, h, |_| 1.0, &mut Silent);
        assert_eq!((report.advance, report.ticks), (Advance::Faulty(Fault::Period), 1), "h {h}");
    }
}

#[test]
fn a_guard_that_is_not_defined_is_a_fault() {
    let mut simulator = Simulator::new(Undefined, Rk4, Limits::default(), (), [0.0]);
    let report = simulator.run(1.0, 0.1, |_| (), &mut Silent);
    assert_eq!((report.advance, report.ticks), (Advance::Faulty(Fault::Guard), 1));
}

#[test]
fn samples_inside_long_ticks_are_those_of_the_dense_output() {
    let mut ball = Simulator::new(
        Ball { restitution: 0.5, mass: 1.0 },
        Dop853,
        Limits::default(),
        BallMode::Flight,
        [1.0, 0.0],
    );
    let mut recorder = RunRecorder::new(0.25).sampled(0.01);
    let report = ball.run(1.5, 0.25, |_| (), &mut recorder);
    assert!(report.is_completed());
    let impact = (2.0 / G).sqrt();
    let second = 2.0 * impact;
    let flight = recorder.samples().iter().filter(|sample| sample.t < second);
    let mut seen = 0;
    for sample in flight {
        let t = sample.t;
        let late = t - impact;
        let expected = if late <= 0.0 {
            1.0 - 0.5 * G * t * t
        } else {
            0.5 * G * impact * late - 0.5 * G * late * late
        };
        close(format_args!("height at {t} s"), sample.state[0], expected, 1e-13);
        seen += 1;
    }
    assert_eq!(seen, 91);
    close("first impact", recorder.times()[0], impact, 1e-13);
    close("impulse", recorder.impulse(), 3.0 * (2.0 * G).sqrt(), 1e-12);
}
