//! A block on a belt, held by a spring, before a rigid stop.

use pode::contacts::{
    ContactIndices, ContactMode, ContactSet, ContactSpec, ContactSystem, CoupledFrictions,
    EnergeticContacts, FrictionForces, FrictionLimits, FrictionSpec, FrictionalContacts,
    GuardedContacts, Surface, WithContacts,
};
use pode::{
    EnergyBalance, EquationKind, GuardId, GuardSpec, GuardValue, Limits, Motion, Nature, Reset,
    Simulator, Stepper,
};

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
    /// Further kinetic friction of a slow slip (N), and the slip speed that halves it (m/s).
    pub slow: [f64; 2],
    pub nature: Nature,
}

const STOP: [GuardSpec; 1] = [GuardSpec::new(0, "stop").scaled(0.1)];

pub fn belt(name: &'static str, slip: f64) -> ContactSpec {
    ContactSpec::bearing(name, FrictionSpec::new(name, 1.0, slip))
}

impl Block {
    /// Returns a block without a stop within reach.
    pub fn new(mass: f64, k: f64, [stiction, kinetic]: [f64; 2]) -> Self {
        Self {
            contacts: vec![belt("belt", 1.0)],
            mass,
            k,
            stiction,
            kinetic,
            stop: 1e3,
            restitution: 0.6,
            slow: [0.0, 1.0],
            nature: Nature::new(EquationKind::Linear, (k / mass).sqrt()),
        }
    }

    pub fn omega(&self) -> f64 {
        (self.k / self.mass).sqrt()
    }

    pub fn start<T: Stepper>(
        self,
        stepper: T,
        x: [f64; 2],
        belt: &Motion,
    ) -> Simulator<WithContacts<Self>, T> {
        let model = WithContacts::new(self).unwrap();
        let (mode, x) = model.start((), &x, belt);
        Simulator::new(model, stepper, Limits::default(), mode, x)
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
        self.nature
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

    fn friction(&self, (): (), _: usize, x: &[f64; 2], belt: &Motion) -> FrictionLimits {
        let [slow, half] = self.slow;
        let slip = (x[1] - belt.rate) / half;
        let kinetic = self.kinetic + slow / (1.0 + slip * slip);
        let [stiction, kinetic] =
            [self.stiction, kinetic].map(|force| force / self.contacts.len() as f64);
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
        let mode = ContactMode { structure, contacts };
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
