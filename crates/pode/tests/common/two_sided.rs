//! Two sets of equations, on either side of a condition, as one switch among contacts.

use pode::contacts::{
    ContactIndices, ContactMode, ContactSet, ContactSpec, ContactState, ContactSystem, Continued,
    CoupledFrictions, FrictionForces, FrictionLimits, FrictionSpec, FrictionalContacts,
    GuardedContacts, Surface, WithContacts,
};
use pode::stepper::Rk4;
use pode::{GuardValue, Limits, Nature, RecordedEvent, Simulator, State};

/// Equations above (side 1) and below (side −1) a condition c(x, u) = 0 with terms of size 1.
pub trait TwoSided: Copy {
    type State: State;
    type Input: Continued;
    const COORDS: usize;

    fn flow(&self, side: f64, x: &Self::State, input: &Self::Input) -> Self::State;

    fn condition(&self, x: &Self::State, input: &Self::Input) -> Surface<Self::State>;

    /// Returns c' with its derivatives, where both sides have the same.
    fn kept(&self, _x: &Self::State, _input: &Self::Input) -> Option<Surface<Self::State>> {
        None
    }

    fn nature(&self) -> Nature {
        Nature::default()
    }
}

/// Its readout is f above, −f below, and the share of both between, as f is.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Switch<M> {
    pub sides: M,
    contacts: [ContactSpec; 1],
}

pub type Switched<M> = WithContacts<Switch<M>>;

/// Starts `sides` at `x` with RK4.
pub fn start<M: TwoSided>(
    sides: M,
    x: M::State,
    input: &M::Input,
    limits: Limits,
) -> Simulator<Switched<M>, Rk4> {
    let contacts = [ContactSpec::bearing("switch", FrictionSpec::switch("switch", 1.0))];
    let model = WithContacts::new(Switch { sides, contacts }).unwrap();
    let (mode, state) = model.start((), &x, input);
    Simulator::new(model, Rk4, limits, mode, state)
}

pub fn side(mode: ContactMode<()>) -> ContactState {
    mode.contacts.state(0)
}

/// Returns the states into which a contact went, event by event.
pub fn states<M: GuardedContacts<Structure = ()>>(
    events: &[RecordedEvent<WithContacts<M>>],
) -> Vec<ContactState> {
    events.iter().map(|it| side(it.to)).collect()
}

impl<M: TwoSided> ContactSystem for Switch<M> {
    type Structure = ();
    type State = M::State;
    type Input = M::Input;
    const COORDS: usize = M::COORDS;

    fn contacts(&self) -> &[ContactSpec] {
        &self.contacts
    }

    fn gap(&self, (): (), _: usize, _: &M::State, _: &M::Input) -> GuardValue {
        unreachable!("a switch has no gap")
    }

    fn derivative(&self, (): (), _: ContactIndices, x: &M::State, u: &M::Input) -> M::State {
        self.sides.flow(-1.0, x, u).plus(1.0, &self.sides.flow(1.0, x, u)).times(0.5)
    }

    fn readout(
        &self,
        (): (),
        _: ContactIndices,
        forces: &FrictionForces,
        _: &M::State,
        _: &M::Input,
    ) -> f64 {
        -forces.at(0)
    }

    fn nature(&self, (): (), _: ContactSet) -> Nature {
        self.sides.nature()
    }
}

impl<M: TwoSided> CoupledFrictions for Switch<M> {}

impl<M: TwoSided> FrictionalContacts for Switch<M> {
    fn slip(&self, (): (), _: usize, x: &M::State, u: &M::Input) -> Surface<M::State> {
        self.sides.condition(x, u)
    }

    fn kept(&self, (): (), _: usize, x: &M::State, u: &M::Input) -> Option<Surface<M::State>> {
        self.sides.kept(x, u)
    }

    fn response(&self, (): (), _: usize, x: &M::State, u: &M::Input) -> M::State {
        self.sides.flow(-1.0, x, u).plus(-1.0, &self.sides.flow(1.0, x, u)).times(0.5)
    }

    fn friction(&self, (): (), _: usize, _: &M::State, _: &M::Input) -> FrictionLimits {
        FrictionLimits::coulomb(1.0)
    }
}

impl<M: TwoSided> GuardedContacts for Switch<M> {}
