//! A block on a belt before a rigid stop: friction and a wall in one model.
//!
//! The reference joins closed forms: a harmonic motion about F_k/k while it slips, the belt's
//! motion while it sticks, and v⁺ = −e v⁻ at the stop.

use pode::contacts::{
    ContactIndices, ContactSet, ContactSpec, ContactState, ContactSystem, CoupledFrictions,
    EnergeticContacts, FrictionForces, FrictionLimits, FrictionSpec, FrictionalContacts,
    GuardedContacts, WithContacts,
};
use pode::filippov::Surface;
use pode::stepper::Exact;
use pode::{
    EnergyAudit, EnergyBalance, EquationKind, GuardId, GuardSpec, GuardValue, Limits, Motion,
    Nature, Reset, Simulator,
};

use crate::common::{all_completed, close, each_step_and_phase};
use crate::driven::{root, run_driven};

/// A mass on a spring: place (m) and speed (m/s) over a fixed ground.
#[derive(Clone, Debug)]
pub struct Block {
    /// They hold and slip together, each with its share of the friction.
    pub contacts: Vec<ContactSpec>,
    pub mass: f64,
    pub k: f64,
    pub stiction: f64,
    pub kinetic: f64,
    /// Place of the stop (m), and its restitution.
    pub stop: f64,
    pub restitution: f64,
}

const STOP: [GuardSpec; 1] = [GuardSpec::new(0, "stop").scaled(0.1)];

impl Block {
    fn omega(&self) -> f64 {
        (self.k / self.mass).sqrt()
    }
}

impl ContactSystem for Block {
    type Structure = ();
    type State = [f64; 2];
    type Input = Motion;
    const COORDS: usize = 1;

    fn contacts(&self) -> &[ContactSpec] {
        &self.contacts
    }

    fn gap(&self, (): (), _: usize, _: &[f64; 2], _: &Motion) -> GuardValue {
        unreachable!("the belt is always there")
    }

    fn derivative(&self, (): (), _: ContactIndices, x: &[f64; 2], _: &Motion) -> [f64; 2] {
        [x[1], -self.k * x[0] / self.mass]
    }

    fn readout(
        &self,
        (): (),
        _: ContactIndices,
        forces: &FrictionForces,
        _: &[f64; 2],
        _: &Motion,
    ) -> f64 {
        forces.at(0)
    }

    fn nature(&self, (): (), _: ContactSet) -> Nature {
        Nature::new(EquationKind::Linear, self.omega())
    }
}

impl CoupledFrictions for Block {}

impl FrictionalContacts for Block {
    fn slip(&self, (): (), _: usize, x: &[f64; 2], belt: &Motion) -> Surface<[f64; 2]> {
        Surface { value: x[1] - belt.rate, gradient: [0.0, 1.0], drift: -belt.acceleration }
    }

    fn response(&self, (): (), _: usize, _: &[f64; 2], _: &Motion) -> [f64; 2] {
        [0.0, 1.0 / self.mass]
    }

    fn friction(&self, (): (), _: usize, _: &[f64; 2], _: &Motion) -> FrictionLimits {
        let [stiction, kinetic] =
            [self.stiction, self.kinetic].map(|force| force / self.contacts.len() as f64);
        FrictionLimits { stiction, kinetic }
    }
}

impl GuardedContacts for Block {
    fn structure_guards(&self) -> &[GuardSpec] {
        &STOP
    }

    fn structure_guard(&self, (): (), _: GuardId, x: &[f64; 2], _: &Motion) -> GuardValue {
        GuardValue::new(self.stop - x[0], -x[1])
    }

    fn reset(
        &self,
        structure: (),
        contacts: ContactSet,
        _: GuardId,
        x: &[f64; 2],
        _: &Motion,
    ) -> Reset<WithContacts<Self>> {
        let mode = pode::contacts::ContactMode { structure, contacts };
        Reset::to(mode, [self.stop, -self.restitution * x[1]])
    }
}

impl EnergeticContacts for Block {
    fn balance(
        &self,
        (): (),
        _: ContactIndices,
        forces: &FrictionForces,
        x: &[f64; 2],
        belt: &Motion,
    ) -> EnergyBalance {
        EnergyBalance {
            energy: 0.5 * self.mass * x[1] * x[1] + 0.5 * self.k * x[0] * x[0],
            supplied: forces.at(0) * belt.rate,
            dissipated: 0.0,
        }
    }
}

#[derive(Clone, Copy, Debug, PartialEq)]
enum Ends {
    Slips,
    Sticks,
    Hits,
}

fn swing(it: &Block, x: [f64; 2], t: f64) -> [f64; 2] {
    let (w, c) = (it.omega(), it.kinetic / it.k);
    let (sin, cos) = (w * t).sin_cos();
    [c + (x[0] - c) * cos + x[1] / w * sin, x[1] * cos - w * (x[0] - c) * sin]
}

/// Returns the first `n` ends of pieces from a stick at `x0`, with time (s), and the state after.
fn pieces(it: &Block, x0: f64, belt: f64, n: usize) -> Vec<(f64, Ends, [f64; 2])> {
    const SAMPLES: u32 = 20_000;
    let (mut t, mut x, mut sticks, mut out) = (0.0, [x0, belt], true, vec![]);
    while out.len() < n {
        let (after, end) = if sticks {
            let [slips, hits] = [it.stiction / it.k, it.stop].map(|place| (place - x[0]) / belt);
            if slips < hits { (slips, Ends::Slips) } else { (hits, Ends::Hits) }
        } else {
            let over = |t: f64| swing(it, x, t)[1] - belt;
            let beyond = |t: f64| swing(it, x, t)[0] - it.stop;
            let step = std::f64::consts::TAU / it.omega() / f64::from(SAMPLES);
            let mut times = (2..SAMPLES).map(|i| f64::from(i) * step);
            let late = times.find(|t| over(*t) >= 0.0 || beyond(*t) >= 0.0).unwrap();
            let low = late - step;
            if over(late) >= 0.0 {
                (root(low, late, over), Ends::Sticks)
            } else {
                (root(low, late, beyond), Ends::Hits)
            }
        };
        x = if sticks { [x[0] + belt * after, belt] } else { swing(it, x, after) };
        if end == Ends::Hits {
            x = [it.stop, -it.restitution * x[1]];
        }
        sticks = end == Ends::Sticks;
        t += after;
        out.push((t, end, x));
    }
    out
}

#[track_caller]
fn check(it: Block, expected: &[Ends], (h, phase): (f64, f64)) {
    let speed = 0.15;
    let belt = |t: f64| Motion { position: speed * t, rate: speed, ..Motion::default() };
    let pieces = pieces(&it, 0.0, speed, expected.len());
    let model = WithContacts::new(it).unwrap();
    let (mode, x) = model.start((), &[0.0, speed], &belt(0.0));
    assert_eq!(mode.contacts.state(0), ContactState::Stick);
    let mut simulator = Simulator::new(model, Exact, Limits::default(), mode, x);
    let until = pieces[pieces.len() - 1].0 + 1e-3;
    let (recorder, ticks) = run_driven(&mut simulator, (h, phase), until, belt);
    all_completed(&ticks);
    assert_eq!(
        recorder.events().len(),
        pieces.len(),
        "h {h}, phase {phase}: {:?}",
        recorder.events()
    );
    for ((found, (t, end, x)), expected) in recorder.events().iter().zip(&pieces).zip(expected) {
        let what = format!("{end:?} at {t}, h {h}, phase {phase}");
        assert_eq!(end, expected, "{what}");
        assert_eq!(found.name, if *end == Ends::Hits { "stop" } else { "belt" }, "{what}");
        let state = found.to.contacts.state(0);
        let sticks = *end == Ends::Sticks;
        assert_eq!(state, if sticks { ContactState::Stick } else { ContactState::SlideDown });
        close(&what, found.t, *t, 1e-11);
        close(&what, found.after[0], x[0], 1e-11);
        close(&what, found.after[1], x[1], 1e-11);
    }
}

pub fn block() -> Block {
    let friction = FrictionSpec::new("belt", 1.0, 0.1);
    Block {
        contacts: vec![ContactSpec::bearing("belt", friction)],
        mass: 0.5,
        k: 80.0,
        stiction: 2.0,
        kinetic: 1.2,
        stop: 0.03,
        restitution: 0.6,
    }
}

#[test]
fn a_block_on_a_belt_is_carried_to_a_stop_thrown_back_and_carried_again() {
    use Ends::{Hits, Slips, Sticks};
    each_step_and_phase(|at, phase| {
        check(Block { stop: 0.02, ..block() }, &[Hits; 4], (at, phase));
        // The belt loses it at 0.025 m, and it slips on to a stop at 0.03 m …
        check(block(), &[Slips, Hits, Sticks, Slips, Hits, Sticks], (at, phase));
        // … or turns before one at 0.04 m.
        let far = Block { stop: 0.04, ..block() };
        check(far, &[Slips, Sticks, Slips, Sticks, Slips, Sticks], (at, phase));
    });
}

#[test]
fn belt_friction_and_stop_keep_the_books_of_the_energy() {
    let belt = |t: f64| Motion { position: 0.15 * t, rate: 0.15, ..Motion::default() };
    let model = WithContacts::new(block()).unwrap();
    let (mode, x) = model.start((), &[0.0, 0.15], &belt(0.0));
    let mut it = Simulator::new(model, Exact, Limits::default(), mode, x);
    let mut audit = EnergyAudit::default();
    for n in 0..2000 {
        let t = f64::from(n) * 1e-3;
        let _ = it.advance(1e-3, &|theta: f64| belt(t + theta * 1e-3), &mut audit);
    }
    assert!(audit.dissipated > 0.05 && audit.jumps < -1e-3, "{audit:?}");
    // Friction's power is a sine: Simpson's rule errs by (ωh)⁴/2880 of it.
    close("residual", audit.integration, 0.0, 1e-9);
}
