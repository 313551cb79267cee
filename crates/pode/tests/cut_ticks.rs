//! Case C12: how ticks cut the time line is not seen in the events, on the exact flow.
//!
//! Error model: between two events every cut rounds the state once more, by ε/2 of its
//! largest term; over 2 s in ticks of 0.1 ms that is 2e-12 of 1 at the very worst, in one
//! direction, and some 1e-14 as it comes. The case's limit is 1e-12.

#![allow(clippy::disallowed_macros, reason = "a test may use the heap")]

use pode::stepper::Exact;
use pode::{
    EquationKind, GuardId, GuardSpec, GuardValue, Guarded, Limits, Model, Nature, Reset, Resets,
    Simulator,
};

use crate::common::head::{CONTACTS, Head};
use crate::common::{STEPS, all_completed, close, run};

/// A mass on a spring, x'' = −ω² x, that bounces off a wall.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Springy {
    omega: f64,
    wall: f64,
    restitution: f64,
}

impl Model for Springy {
    type Mode = ();
    type State = [f64; 2];
    type Input = ();
    const COORDS: usize = 1;

    fn derivative(&self, (): (), x: &[f64; 2], (): &()) -> [f64; 2] {
        [x[1], -self.omega * self.omega * x[0]]
    }

    fn readout(&self, (): (), _: &[f64; 2], (): &()) -> f64 {
        0.0
    }

    fn nature(&self, (): ()) -> Nature {
        Nature::new(EquationKind::Affine, self.omega)
    }
}

impl Guarded for Springy {
    fn guards(&self, (): ()) -> &'static [GuardSpec] {
        const WALL: [GuardSpec; 1] = [GuardSpec::new(0, "wall")];
        &WALL
    }

    fn guard(&self, (): (), _: GuardId, x: &[f64; 2], (): &()) -> GuardValue {
        GuardValue::new(x[0] - self.wall, x[1])
    }
}

impl Resets for Springy {
    fn reset(&self, (): (), _: GuardId, x: &[f64; 2], (): &()) -> Reset<Self> {
        Reset::to((), [self.wall, -self.restitution * x[1]])
    }
}

/// Guards and times of the events over 2 s in ticks of `h`.
fn events<M: Resets<Input = ()>>(
    start: Simulator<M, Exact>,
    h: f64,
    phase: f64,
) -> Vec<(&'static str, f64)> {
    let (recorder, ticks) = run(&mut { start }, h, phase, 2.0);
    all_completed(&ticks);
    recorder.events().iter().filter(|seen| seen.t < 1.99).map(|seen| (seen.name, seen.t)).collect()
}

/// Asserts that all cuts of the time line have the same events.
#[track_caller]
fn check<M: Resets<Input = ()> + Copy>(what: &str, start: Simulator<M, Exact>) {
    let whole = events(start, 1e-3, 0.0);
    assert!(whole.len() >= 2, "{what}: {whole:?}");
    for h in STEPS.into_iter().chain([1e-2, 0.05]) {
        for phase in crate::common::PHASES {
            let cut = events(start, h, phase);
            assert_eq!(cut.len(), whole.len(), "{what}, h {h}, phase {phase}");
            for (cut, whole) in cut.iter().zip(&whole) {
                assert_eq!(cut.0, whole.0, "{what}, h {h}, phase {phase}");
                close(format_args!("{what}, h {h}, phase {phase}"), cut.1, whole.1, 1e-12);
            }
        }
    }
}

#[test]
fn a_contact_does_not_depend_on_how_ticks_cut_it() {
    for [k, ..] in CONTACTS {
        check(&format!("k {k}"), Head { k }.dropped(Exact));
    }
}

#[test]
fn a_bouncing_mass_does_not_either() {
    for (omega, wall) in [(3.0, 0.0), (20.0, -0.4), (50.0, 0.0)] {
        let model = Springy { omega, wall, restitution: 0.9 };
        let exact = Exact;
        let start = Simulator::new(model, exact, Limits::default(), (), [1.0, 0.5]);
        check(&format!("{model:?}"), start);
    }
}
