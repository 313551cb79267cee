//! Undeclared Zeno sequences: the simulator measures the intervals, distinguishes those that
//! accumulate, and settles them into the contact mode. References are the same impacts followed one
//! by one in closed form, to rounding.

use pode::stepper::{Exact, Rk4};
use pode::{
    EquationKind, GuardId, GuardSpec, GuardValue, Guarded, Limits, Model, Nature, Reset, Resets,
    Simulator,
};

use crate::common::{BallMode as Mode, G, all_completed, close, each_step_and_phase, run};

/// A ball over a floor whose restitution falls with the speed of the impact: e0 / (1 + v/v0). Its
/// ratio of intervals is constant only in the limit.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Soft {
    e0: f64,
    /// Speed (m/s) at which restitution is half of e0; infinite for a constant one.
    v0: f64,
}

impl Soft {
    fn rebound(&self, v: f64) -> f64 {
        v * self.e0 / (1.0 + v / self.v0)
    }
}

impl Model for Soft {
    type Mode = Mode;
    type State = [f64; 2];
    type Input = ();
    const COORDS: usize = 1;

    fn derivative(&self, mode: Mode, x: &[f64; 2], (): &()) -> [f64; 2] {
        match mode {
            Mode::Flight => [x[1], -G],
            Mode::Rest => [0.0, 0.0],
        }
    }

    fn readout(&self, mode: Mode, _: &[f64; 2], (): &()) -> f64 {
        if mode == Mode::Rest { G } else { 0.0 }
    }

    fn nature(&self, _: Mode) -> Nature {
        Nature::new(EquationKind::Affine, 0.0)
    }
}

impl Guarded for Soft {
    fn guards(&self, mode: Mode) -> &'static [GuardSpec] {
        const FLOOR: [GuardSpec; 1] = [GuardSpec::new(0, "floor")];
        if mode == Mode::Flight { &FLOOR } else { &[] }
    }

    fn guard(&self, _: Mode, _: GuardId, x: &[f64; 2], (): &()) -> GuardValue {
        GuardValue::new(x[0], x[1])
    }
}

impl Resets for Soft {
    fn reset(&self, _: Mode, _: GuardId, x: &[f64; 2], (): &()) -> Reset<Self> {
        let after = self.rebound(-x[1]);
        Reset::to(Mode::Flight, [0.0, after])
            .with_impulse(after - x[1])
            .resting(Mode::Rest, [0.0, 0.0])
    }
}

/// Returns the time of rest (s) of a ball dropped from 1 m, and its impulse until then (N s/kg).
fn rest(ball: Soft) -> (f64, f64) {
    let mut v = (2.0 * G).sqrt();
    let (mut t, mut impulse) = (v / G, 0.0);
    while v > 1e-18 {
        let after = ball.rebound(v);
        impulse += v + after;
        t += 2.0 * after / G;
        v = after;
    }
    (t, impulse)
}

const BALLS: [Soft; 6] = [
    Soft { e0: 0.5, v0: f64::INFINITY },
    Soft { e0: 0.8, v0: f64::INFINITY },
    Soft { e0: 0.95, v0: f64::INFINITY },
    Soft { e0: 0.8, v0: 5.0 },
    Soft { e0: 0.6, v0: 1.0 },
    Soft { e0: 0.9, v0: 20.0 },
];

#[test]
fn impacts_whose_ratio_tends_to_a_constant_come_to_rest_in_time() {
    for ball in BALLS {
        let (t, impulse) = rest(ball);
        each_step_and_phase(|h, phase| {
            let what = |name: &str| format!("{name}, {ball:?}, h {h}, phase {phase}");
            let start = Simulator::new(ball, Rk4, Limits::default(), Mode::Flight, [1.0, 0.0]);
            let (recorder, ticks) = run(&mut { start }, h, phase, t + 0.1);
            all_completed(&ticks);
            let last = recorder.events().last().expect("an event");
            assert_eq!((last.name, last.to), ("settled", Mode::Rest), "{}", what("end"));
            // Settled as soon as the time is known to 2⁻²⁰ of a tick, or as well as the last events
            // of a tick permit; where hops are lost in rounding, to 1e-5 of their rest.
            close(what("time of rest"), last.t, t, 1e-5 * h + 5e-9);
            let sum: f64 = ticks.iter().map(|tick| tick.impulse).sum();
            close(what("impulse"), sum, impulse, G * (1e-5 * h + 5e-9));
            let most = ticks.iter().map(|tick| tick.work.events).max();
            assert!(most <= Some(30), "{}: {most:?} events in a tick", what("work"));
        });
    }
}

#[test]
fn hundreds_of_bounces_in_one_tick_are_a_handful_of_events() {
    // e = 0.99: a second of bouncing once they are 1 ms apart, in ticks of 0.1 s.
    let ball = Soft { e0: 0.99, v0: f64::INFINITY };
    let start = [0.0, 0.5 * G * 1e-3];
    let mut simulator = Simulator::new(ball, Exact, Limits::default(), Mode::Flight, start);
    let (recorder, ticks) = run(&mut simulator, 0.1, 0.0, 0.3);
    all_completed(&ticks);
    let last = recorder.events().last().expect("an event");
    assert_eq!(last.to, Mode::Rest);
    close("time of rest", last.t, 1e-3 / (1.0 - 0.99), 1e-7);
    assert!(recorder.events().len() < 30, "{} events", recorder.events().len());
}

/// A ball on a spring instead of gravity, x'' = −x, with a wall at 0: its interval tends to π, for
/// any restitution.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Springy {
    e: f64,
    /// Place of the wall: at 0 the interval is constant; the spring presses against one below.
    wall: f64,
}

impl Model for Springy {
    type Mode = Mode;
    type State = [f64; 2];
    type Input = ();
    const COORDS: usize = 1;

    fn derivative(&self, mode: Mode, x: &[f64; 2], (): &()) -> [f64; 2] {
        match mode {
            Mode::Flight => [x[1], -x[0]],
            Mode::Rest => [0.0, 0.0],
        }
    }

    fn nature(&self, mode: Mode) -> Nature {
        Nature::new(EquationKind::Affine, if mode == Mode::Flight { 1.0 } else { 0.0 })
    }
}

impl Guarded for Springy {
    fn guards(&self, mode: Mode) -> &'static [GuardSpec] {
        const WALL: [GuardSpec; 1] = [GuardSpec::new(0, "wall")];
        if mode == Mode::Flight { &WALL } else { &[] }
    }

    fn guard(&self, _: Mode, _: GuardId, x: &[f64; 2], (): &()) -> GuardValue {
        GuardValue::new(x[0] - self.wall, x[1])
    }
}

impl Resets for Springy {
    fn reset(&self, _: Mode, _: GuardId, x: &[f64; 2], (): &()) -> Reset<Self> {
        Reset::to(Mode::Flight, [self.wall, -self.e * x[1]]).resting(Mode::Rest, [self.wall, 0.0])
    }
}

#[test]
fn impacts_whose_interval_tends_to_a_constant_are_never_settled() {
    for e in [0.3, 0.9, 0.999] {
        for h in [1e-3, 0.1, 40.0] {
            // A wall at rest, and one just short of it, from which the spring pulls away.
            for wall in [0.0, -1e-3] {
                let limits = Limits { longest_step: 0.1, followed: 0, ..Limits::default() };
                let exact = Exact;
                let start = [1.0, 0.0];
                let mut it =
                    Simulator::new(Springy { e, wall }, exact, limits, Mode::Flight, start);
                let (recorder, _) = run(&mut it, h, 0.0, 40.0);
                let settled = recorder.events().iter().any(|seen| seen.to == Mode::Rest);
                assert!(!settled, "e {e}, h {h}, wall {wall}: {:?}", recorder.times());
            }
        }
    }
}

#[test]
fn a_spring_that_presses_comes_to_rest_on_its_wall() {
    for e in [0.3, 0.8] {
        let exact = Exact;
        let model = Springy { e, wall: 0.5 };
        // The same impacts, each arc in closed form: x = A cos(t + φ) above the wall.
        let mut v = (1.0_f64 - 0.25).sqrt();
        let mut t = 0.5_f64.acos();
        while v > 1e-17 {
            v *= e;
            t += 2.0 * v.atan2(0.5);
        }
        each_step_and_phase(|h, phase| {
            let start = Simulator::new(model, exact, Limits::default(), Mode::Flight, [1.0, 0.0]);
            let (recorder, ticks) = run(&mut { start }, h, phase, t + 0.1);
            all_completed(&ticks);
            let last = recorder.events().last().expect("an event");
            assert_eq!(last.to, Mode::Rest);
            close(format_args!("e {e}, h {h}, phase {phase}"), last.t, t, 1e-5 * h + 5e-9);
        });
    }
}
