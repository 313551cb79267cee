//! Case C3: a pendulum against a wall at its lowest point.
//!
//! Error model: RK4's phase error is (ω h)⁴/120 of the time; the third-order dense output adds as
//! much again per impact. Together less than (ω h)⁴ t / 30; below that, the rounding of some 1e5
//! steps, 1e-12 of the time.

use pode::stepper::Rk4;
use pode::{
    GuardId, GuardSpec, GuardValue, Guarded, Limits, Model, Reset, Resets, Settling, Simulator,
};

use crate::common::{G, all_completed, close, each_step_and_phase, run};

/// Angle (rad) and its rate; ω0² = 9.81 1/s², e = 0.9.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pendulum {
    pub has_wall: bool,
}

/// Number of an impact and its time (s), from 40-digit arithmetic.
pub const IMPACTS: [(usize, f64); 4] = [
    (1, 0.550_770_646_903_126),
    (2, 1.630_077_719_645_963_8),
    (5, 4.783_311_598_904_508),
    (10, 9.898_785_767_259_402),
];

const RESTITUTION: f64 = 0.9;

impl Model for Pendulum {
    type Mode = ();
    type State = [f64; 2];
    type Input = ();
    const COORDS: usize = 1;

    fn derivative(&self, (): (), x: &[f64; 2], (): &()) -> [f64; 2] {
        [x[1], -G * x[0].sin()]
    }
}

impl Guarded for Pendulum {
    fn guards(&self, (): ()) -> &'static [GuardSpec] {
        if self.has_wall { const { &[GuardSpec::new(0, "wall")] } } else { &[] }
    }

    fn guard(&self, (): (), _: GuardId, x: &[f64; 2], (): &()) -> GuardValue {
        GuardValue::new(x[0], x[1])
    }
}

impl Resets for Pendulum {
    /// Declares the Zeno sequence of the formula, at infinity for this wall: nothing pulls the
    /// pendulum against it.
    fn reset(&self, (): (), _: GuardId, x: &[f64; 2], (): &()) -> Reset<Self> {
        let after = -RESTITUTION * x[1];
        let closing = G * 0.0_f64.sin();
        Reset::to((), [0.0, after]).settling(Settling {
            after: 2.0 * after / (closing * (1.0 - RESTITUTION)),
            ratio: RESTITUTION,
            mode: (),
            state: [0.0, 0.0],
            impulse: 0.0,
        })
    }
}

fn from_rest() -> Simulator<Pendulum, Rk4> {
    let pendulum = Pendulum { has_wall: true };
    Simulator::new(pendulum, Rk4, Limits::default(), (), [1.2, 0.0])
}

fn tolerance(h: f64, t: f64) -> f64 {
    (G.sqrt() * h).powi(4) * t / 30.0 + 1e-12 * t
}

#[test]
fn impacts_are_at_their_times() {
    each_step_and_phase(|h, phase| {
        let (recorder, ticks) = run(&mut from_rest(), h, phase, 10.0);
        for (n, t) in IMPACTS {
            close(
                format_args!("h {h}, impact {n}"),
                recorder.events()[n - 1].t,
                t,
                tolerance(h, t),
            );
        }
        all_completed(&ticks);
    });
}

#[test]
fn the_first_impact_has_the_speed_of_the_fall() {
    each_step_and_phase(|h, phase| {
        let (recorder, _) = run(&mut from_rest(), h, phase, 0.6);
        // A speed errs like a time, times an acceleration of at most ω0² = 9.81.
        let speed = -recorder.events()[0].before[1];
        close(format_args!("h {h}"), speed, 3.537_024_294_116_124, G * tolerance(h, 0.6));
    });
}

#[test]
fn impacts_that_never_accumulate_are_never_settled() {
    let (recorder, ticks) = run(&mut from_rest(), 1e-3, 0.0, 60.0);
    all_completed(&ticks);
    assert!(recorder.events().iter().all(|seen| seen.name == "wall"), "settled");
    let times = recorder.times();
    let last = times[times.len() - 1] - times[times.len() - 2];
    // The swing of amplitude A lasts π/ω0 (1 + A²/16); after n impacts A is below eⁿ⁻¹ 1.2.
    let amplitude = 1.2 * RESTITUTION.powf(times.len() as f64 - 2.0);
    let swing = std::f64::consts::PI / G.sqrt();
    close("interval", last, swing, swing * amplitude * amplitude / 16.0 + 1e-9);
}
