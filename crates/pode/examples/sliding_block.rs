//! A block on a belt, held by a spring: it sticks until the spring pulls it off, and slips back.
#![allow(clippy::disallowed_macros, clippy::print_stdout, reason = "an example prints")]
use pode::contacts::{
    ContactIndices, ContactSpec, ContactSystem, CoupledFrictions, FrictionLimits, FrictionSpec,
    FrictionalContacts, GuardedContacts, Surface, WithContacts,
};
use pode::{GuardValue, Limits, RunRecorder, Simulator, stepper::Rk4};

/// Place (m) and speed (m/s) of a block of 1 kg over the ground, on a spring of 100 N/m.
struct Block([ContactSpec; 1]);
impl ContactSystem for Block {
    type Structure = ();
    type State = [f64; 2];
    type Input = ();
    const COORDS: usize = 1;
    fn contacts(&self) -> &[ContactSpec] {
        &self.0
    }
    fn gap(&self, (): (), _: usize, _: &[f64; 2], (): &()) -> GuardValue {
        GuardValue::new(1.0, 0.0)
    }
    fn derivative(&self, (): (), _: ContactIndices, x: &[f64; 2], (): &()) -> [f64; 2] {
        [x[1], -100.0 * x[0]]
    }
}
impl CoupledFrictions for Block {}
impl FrictionalContacts for Block {
    fn slip(&self, (): (), _: usize, x: &[f64; 2], (): &()) -> Surface<[f64; 2]> {
        Surface { value: x[1] - 0.1, gradient: [0.0, 1.0], drift: 0.0 }
    }
    fn response(&self, (): (), _: usize, _: &[f64; 2], (): &()) -> [f64; 2] {
        [0.0, 1.0]
    }
    fn friction(&self, (): (), _: usize, _: &[f64; 2], (): &()) -> FrictionLimits {
        FrictionLimits { stiction: 2.0, kinetic: 1.0 }
    }
}
impl GuardedContacts for Block {}

fn main() {
    let belt = ContactSpec::bearing("belt", FrictionSpec::new("belt", 1.0, 0.1));
    let Ok(model) = WithContacts::new(Block([belt])) else { return };
    let (mode, state) = model.start((), &[0.0, 0.1], &());
    let mut simulator = Simulator::new(model, Rk4, Limits::default(), mode, state);
    let mut recorder = RunRecorder::new(1e-3);
    println!("{:?}", simulator.run(1.0, 1e-3, |_| (), &mut recorder));
    recorder.events().iter().for_each(|event| println!("{event}"));
}
