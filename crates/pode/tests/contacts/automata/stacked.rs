//! Two blocks, one on the other, pulled by the lower one: stick on stick, slip on stick, both slip,
//! and back to rest. Under a straight rise and fall of the force, speeds are quadratics.

use pode::contacts::{
    ContactIndices, ContactSpec, ContactState, ContactSystem, CoupledFrictions, FrictionLimits,
    FrictionSpec, FrictionalContacts, GuardedContacts, Surface, WithContacts,
};
use pode::stepper::Rk4;
use pode::{GuardValue, Limits, Simulator};

use crate::common::{all_completed, close};
use crate::driven::{Clock, root, run_driven};
use ContactState::{SlideDown, SlideUp, Stick};

/// Places of the lower and the upper block (m), then speeds.
#[derive(Clone, Copy, Debug)]
struct Stack {
    contacts: [ContactSpec; 2],
    m: [f64; 2],
    /// Friction to the ground, and between the blocks (N).
    stiction: [f64; 2],
    kinetic: [f64; 2],
    /// Rise of the pull (N/s) until `turn` (s), then its fall.
    pull: f64,
    turn: f64,
}

impl Stack {
    fn pull(&self, t: f64) -> f64 {
        self.pull * (self.turn - (t - self.turn).abs())
    }

    fn pulled(&self, t: f64) -> f64 {
        let rise = t.min(self.turn);
        let fall = t - rise;
        self.pull * (0.5 * rise * rise + fall * (self.turn - 0.5 * fall))
    }
}

impl ContactSystem for Stack {
    type Structure = ();
    type State = [f64; 4];
    type Input = Clock;
    const COORDS: usize = 2;

    fn contacts(&self) -> &[ContactSpec] {
        &self.contacts
    }

    fn gap(&self, (): (), _: usize, _: &[f64; 4], _: &Clock) -> GuardValue {
        unreachable!("the blocks lie on each other")
    }

    fn derivative(&self, (): (), _: ContactIndices, x: &[f64; 4], t: &Clock) -> [f64; 4] {
        [x[2], x[3], self.pull(t.0) / self.m[0], 0.0]
    }
}

impl CoupledFrictions for Stack {}

impl FrictionalContacts for Stack {
    fn slip(&self, (): (), contact: usize, x: &[f64; 4], _: &Clock) -> Surface<[f64; 4]> {
        let gradient = if contact == 0 { [0.0, 0.0, 1.0, 0.0] } else { [0.0, 0.0, -1.0, 1.0] };
        let value = if contact == 0 { x[2] } else { x[3] - x[2] };
        Surface { value, gradient, drift: 0.0 }
    }

    fn response(&self, (): (), contact: usize, _: &[f64; 4], _: &Clock) -> [f64; 4] {
        let [low, high] = self.m.map(|m| 1.0 / m);
        if contact == 0 { [0.0, 0.0, low, 0.0] } else { [0.0, 0.0, -low, high] }
    }

    fn friction(&self, (): (), contact: usize, _: &[f64; 4], _: &Clock) -> FrictionLimits {
        FrictionLimits { stiction: self.stiction[contact], kinetic: self.kinetic[contact] }
    }
}

impl GuardedContacts for Stack {}

type Phases = [(f64, [ContactState; 2], [f64; 2]); 7];

fn phases(it: &Stack) -> Phases {
    let (m, [f0, f1]) = (it.m[0] + it.m[1], it.kinetic);
    // Together, from t0 at the speed v0: m v' = P − f0.
    let together =
        |t0: f64, v0: f64, t: f64| v0 + (it.pulled(t) - it.pulled(t0) - f0 * (t - t0)) / m;
    let t1 = it.stiction[0] / it.pull;
    // The upper block is held by m2 v' up to its stiction.
    let t2 = (f0 + m * it.stiction[1] / it.m[1]) / it.pull;
    assert!(t1 < t2 && t2 < it.turn);
    let v2 = together(t1, 0.0, t2);
    let low = |t: f64| v2 + (it.pulled(t) - it.pulled(t2) - (f0 + f1) * (t - t2)) / it.m[0];
    let high = |t: f64| v2 + f1 / it.m[1] * (t - t2);
    let t3 = root(it.turn, 2.0 * it.turn, |t| low(t) - high(t));
    let v3 = high(t3);
    // Braked, the upper block slips on as soon as −m2 v' is more than that holds.
    let t4 = 2.0 * it.turn - (f0 - m * it.stiction[1] / it.m[1]) / it.pull;
    let v4 = together(t3, v3, t4);
    let low = |t: f64| v4 + (it.pulled(t) - it.pulled(t4) - (f0 - f1) * (t - t4)) / it.m[0];
    let t5 = root(t4, 2.0 * it.turn, low);
    let v5 = v4 - f1 / it.m[1] * (t5 - t4);
    let t6 = t5 + v5 * it.m[1] / f1;
    let t7 = 2.0 * it.turn + t1;
    assert!(t3 < t4 && t6 < t7 && it.pull(t5) + f1 < it.stiction[0]);
    [
        (t1, [SlideUp, Stick], [0.0; 2]),
        (t2, [SlideUp, SlideDown], [v2; 2]),
        (t3, [SlideUp, Stick], [v3; 2]),
        (t4, [SlideUp, SlideUp], [v4; 2]),
        (t5, [Stick, SlideUp], [0.0, v5]),
        (t6, [Stick, Stick], [0.0; 2]),
        (t7, [SlideDown, Stick], [0.0; 2]),
    ]
}

#[track_caller]
fn check(it: Stack, (h, phase): (f64, f64)) {
    let phases = phases(&it);
    let model = WithContacts::new(it).unwrap();
    let (mode, x) = model.start((), &[0.0; 4], &Clock(0.0));
    assert_eq!([0, 1].map(|n| mode.contacts.state(n)), [Stick, Stick]);
    let mut simulator = Simulator::new(model, Rk4, Limits::default(), mode, x);
    let (recorder, ticks) = run_driven(&mut simulator, (h, phase), phases[6].0 + 0.05, Clock);
    all_completed(&ticks);
    assert_eq!(recorder.events().len(), 7, "{:?}", recorder.events());
    for (n, (seen, (t, states, speeds))) in recorder.events().iter().zip(&phases).enumerate() {
        let what = format!("change {n}, h {h}, phase {phase}: {seen:?}");
        assert_eq!(&[0, 1].map(|n| seen.to.contacts.state(n)), states, "{what}");
        close(&what, seen.t, *t, 1e-11);
        close(&what, seen.after[2], speeds[0], 1e-11);
        close(&what, seen.after[3], speeds[1], 1e-11);
    }
}

#[test]
fn two_frictions_in_series_hold_and_slip_in_turn() {
    let contacts = ["ground", "between"]
        .map(|name| ContactSpec::bearing(name, FrictionSpec::new(name, 1.0, 0.1)));
    // Ticks that end where the pull turns, at 0.5 s.
    for (h, phase) in [(1e-3, 0.0), (1e-2, 0.0), (2.5e-3, 0.0)] {
        let coulomb = Stack {
            contacts,
            m: [1.0, 0.5],
            stiction: [6.0, 0.5],
            kinetic: [6.0, 0.5],
            pull: 16.0,
            turn: 0.5,
        };
        check(coulomb, (h, phase));
        check(Stack { kinetic: [5.5, 0.4], ..coulomb }, (h, phase));
        check(
            Stack { m: [0.3, 2.0], stiction: [6.0, 1.5], kinetic: [5.6, 1.4], ..coulomb },
            (h, phase),
        );
    }
}
