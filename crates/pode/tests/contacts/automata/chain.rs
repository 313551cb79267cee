//! Five frictions between three blocks and the ground, more than there are speeds: under every
//! drive the laws of friction hold at every tick, and the energy is kept.

use pode::contacts::{
    ContactIndices, ContactSet, ContactSpec, ContactState, ContactSystem, CoupledFrictions,
    EnergeticContacts, FrictionForces, FrictionLimits, FrictionSpec, FrictionalContacts,
    GuardedContacts, Surface, WithContacts,
};
use pode::stepper::Rk4;
use pode::{EnergyAudit, EnergyBalance, GuardValue, Limits, Nature, Simulator};
use proptest::prelude::*;

use crate::common::{all_completed, close};
use crate::driven::Clock;

#[derive(Clone, Copy, Debug)]
struct Chain {
    contacts: [ContactSpec; 5],
    m: [f64; 3],
    k: f64,
    /// Static and kinetic friction of each contact (N).
    friction: [[f64; 2]; 5],
    /// Amplitude (N) and rate (rad/s) of the force on each block.
    drive: [[f64; 2]; 3],
}

/// Weights of the blocks' speeds in a slip: the ground's three, then the neighbours'.
const SLIPS: [[f64; 3]; 5] =
    [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0], [-1.0, 1.0, 0.0], [0.0, -1.0, 1.0]];

impl Chain {
    fn force(&self, block: usize, t: f64) -> f64 {
        let [amplitude, rate] = self.drive[block];
        amplitude * (rate * t).sin()
    }
}

impl ContactSystem for Chain {
    type Structure = ();
    type State = [f64; 6];
    type Input = Clock;
    const COORDS: usize = 3;

    fn contacts(&self) -> &[ContactSpec] {
        &self.contacts
    }

    fn gap(&self, (): (), _: usize, _: &[f64; 6], _: &Clock) -> GuardValue {
        unreachable!("no contact opens")
    }

    fn derivative(&self, (): (), _: ContactIndices, x: &[f64; 6], t: &Clock) -> [f64; 6] {
        let pushed = |i: usize| (self.force(i, t.0) - self.k * x[i]) / self.m[i];
        std::array::from_fn(|i| if i < 3 { x[3 + i] } else { pushed(i - 3) })
    }

    fn nature(&self, (): (), _: ContactSet) -> Nature {
        Nature::default().with_longest_step(1e-3)
    }
}

impl CoupledFrictions for Chain {}

impl FrictionalContacts for Chain {
    fn slip(&self, (): (), contact: usize, x: &[f64; 6], _: &Clock) -> Surface<[f64; 6]> {
        let weights = SLIPS[contact];
        let gradient = std::array::from_fn(|i| if i < 3 { 0.0 } else { weights[i - 3] });
        let value = (0..3).map(|i| weights[i] * x[3 + i]).sum();
        Surface { value, gradient, drift: 0.0 }
    }

    fn response(&self, (): (), contact: usize, _: &[f64; 6], _: &Clock) -> [f64; 6] {
        let weights = SLIPS[contact];
        std::array::from_fn(|i| if i < 3 { 0.0 } else { weights[i - 3] / self.m[i - 3] })
    }

    fn friction(&self, (): (), contact: usize, _: &[f64; 6], _: &Clock) -> FrictionLimits {
        let [stiction, kinetic] = self.friction[contact];
        FrictionLimits { stiction, kinetic }
    }
}

impl GuardedContacts for Chain {}

impl EnergeticContacts for Chain {
    fn balance(
        &self,
        (): (),
        _: ContactIndices,
        _: &FrictionForces,
        x: &[f64; 6],
        t: &Clock,
    ) -> EnergyBalance {
        let each = |i: usize| self.m[i] * x[3 + i] * x[3 + i] + self.k * x[i] * x[i];
        EnergyBalance {
            energy: 0.5 * (0..3).map(each).sum::<f64>(),
            supplied: (0..3).map(|i| self.force(i, t.0) * x[3 + i]).sum(),
            dissipated: 0.0,
        }
    }
}

#[track_caller]
fn obeys_coulomb(it: &Simulator<WithContacts<Chain>, Rk4>, t: f64) {
    let (mode, x, clock) = (it.mode(), it.state(), Clock(t));
    let forces = it.model().friction_forces(mode, x, &clock);
    let chain = it.model().system();
    for contact in 0..5 {
        let slip = chain.slip((), contact, x, &clock).value;
        let [stiction, kinetic] = chain.friction[contact];
        let state = mode.contacts.state(contact);
        let what = format!("{contact} {state:?} at {t}: {mode:?}");
        if state == ContactState::Stick {
            close(&what, slip, 0.0, 1e-15);
            assert!(forces.at(contact).abs() <= stiction * (1.0 + 1e-9), "{what}: {forces:?}");
        } else {
            assert!(state.slip_sign() * slip >= -1e-12, "{what}: slip {slip:e}");
            close(&what, forces.at(contact), -state.slip_sign() * kinetic, 1e-12);
        }
    }
}

#[track_caller]
fn check(chain: &Chain) -> u32 {
    let h = 5e-3;
    let model = WithContacts::new(*chain).unwrap();
    let (mode, x) = model.start((), &[0.0; 6], &Clock(0.0));
    let mut it = Simulator::new(model, Rk4, Limits::default(), mode, x).without_readout();
    let mut audit = EnergyAudit::default();
    let ticks = (0..400).map(|n| {
        let t = f64::from(n) * h;
        let tick = it.advance(h, &|theta: f64| Clock(t + theta * h), &mut audit);
        obeys_coulomb(&it, t + h);
        tick
    });
    let ticks: Vec<_> = ticks.collect();
    all_completed(&ticks);
    assert!(audit.dissipated > -1e-12 && audit.jumps.abs() < 1e-9, "{audit:?}");
    close("residual", audit.integration, 0.0, 1e-7 * (1.0 + audit.supplied.abs()));
    ticks.iter().map(|tick| tick.work.events).sum()
}

fn chain(m: [f64; 3], limits: [f64; 5], ratio: f64, (force, rate): ([f64; 3], [f64; 3])) -> Chain {
    let names = ["ground 1", "ground 2", "ground 3", "1 on 2", "2 on 3"];
    Chain {
        contacts: names.map(|it| ContactSpec::bearing(it, FrictionSpec::new(it, 1.0, 0.1))),
        m,
        k: 50.0,
        friction: limits.map(|limit| [limit, ratio * limit]),
        drive: std::array::from_fn(|i| [force[i], rate[i]]),
    }
}

#[test]
fn a_chain_sticks_and_slips_in_many_ways() {
    let drive = ([6.0, 5.0, 7.0], [7.0, 11.0, 5.0]);
    let events = check(&chain([1.0, 0.7, 1.3], [1.0, 1.5, 0.8, 1.2, 0.6], 0.8, drive));
    assert!(events > 20, "{events}");
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 60, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn any_chain_obeys_coulomb(
        m in prop::array::uniform3(0.2..3.0),
        limits in prop::array::uniform5(0.1..3.0),
        ratio in prop_oneof![Just(1.0), 0.6..1.0],
        force in prop::array::uniform3(0.0..10.0),
        rate in prop::array::uniform3(2.0..20.0),
    ) {
        check(&chain(m, limits, ratio, (force, rate)));
        prop_assert!(true);
    }
}
