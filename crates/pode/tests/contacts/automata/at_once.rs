//! Changes at one instant, and contacts that hold the same motion.

use pode::contacts::{
    ContactIndices, ContactSpec, ContactState, ContactSystem, CoupledFrictions, FrictionalContacts,
    GuardedContacts, WithContacts,
};
use pode::stepper::Rk4;
use pode::{Advance, Cap, GuardValue, Limits, Motion, Simulator};

use crate::common::block::{self, Block};
use crate::common::{G, all_completed, close, run};
use crate::driven::{root, run_driven};

/// A mass of 1 kg over equal springs that all touch at height 0.
#[derive(Debug)]
struct Springs {
    contacts: Vec<ContactSpec>,
    /// Total stiffness (N/m).
    k: f64,
}

impl ContactSystem for Springs {
    type Structure = ();
    type State = [f64; 2];
    type Input = ();
    const COORDS: usize = 1;

    fn contacts(&self) -> &[ContactSpec] {
        &self.contacts
    }

    fn gap(&self, (): (), _: usize, x: &[f64; 2], (): &()) -> GuardValue {
        GuardValue::new(x[0], x[1])
    }

    fn derivative(&self, (): (), closed: ContactIndices, x: &[f64; 2], (): &()) -> [f64; 2] {
        let each = self.k / self.contacts.len() as f64;
        [x[1], -(closed.len() as f64) * each * x[0] - G]
    }
}

impl CoupledFrictions for Springs {}

impl FrictionalContacts for Springs {}
impl GuardedContacts for Springs {}

const NAMES: [&str; 13] = ["a", "b", "c", "d", "e", "f", "g", "h", "i", "j", "k", "l", "m"];

fn springs(n: usize, cascade: u32) -> Simulator<WithContacts<Springs>, Rk4> {
    let contacts = NAMES[..n].iter().map(|name| ContactSpec::new(name, 1.0)).collect();
    let model = WithContacts::new(Springs { contacts, k: 4e3 }).unwrap();
    let (mode, x) = model.start((), &[0.02, 0.0], &());
    Simulator::new(model, Rk4, Limits { cascade, ..Limits::default() }, mode, x)
}

#[test]
fn thirteen_contacts_close_at_one_instant_in_the_order_of_their_numbers() {
    let (one, _) = run(&mut springs(1, 8), 1e-3, 0.3, 0.5);
    let mut it = springs(13, 13);
    let (all, ticks) = run(&mut it, 1e-3, 0.3, 0.5);
    all_completed(&ticks);
    assert!(one.events().len() >= 4, "{:?}", one.times());
    assert_eq!(all.events().len(), 13 * one.events().len());
    for (single, group) in one.events().iter().zip(all.events().chunks(13)) {
        let order: Vec<_> = group.iter().map(|seen| seen.name).collect();
        assert_eq!(order, NAMES);
        for seen in group {
            close(seen.name, seen.t, single.t, 1e-11);
        }
    }
}

#[test]
fn a_cascade_that_is_too_short_is_told() {
    let (_, ticks) = run(&mut springs(13, 12), 1e-3, 0.3, 0.1);
    assert!(ticks.iter().any(|tick| tick.advance == Advance::Capped(Cap::Cascade)));
}

/// Returns `n` contacts of 1 N together on 1 kg and 100 N/m; 1.5 times that can hold.
fn shared(n: usize, belt: Motion) -> Simulator<WithContacts<Block>, Rk4> {
    let contacts = NAMES[..n].iter().map(|name| block::belt(name, 0.1)).collect();
    let block = Block { contacts, ..Block::new(1.0, 100.0, [1.5, 1.0]) };
    block.start(Rk4, [0.0, belt.rate], &belt)
}

#[test]
fn contacts_that_hold_the_same_motion_share_it_and_let_go_together() {
    let belt = Motion { rate: 0.1, ..Motion::default() };
    // Carried to 1.5 N / (100 N/m) in 0.15 s.
    let mut three = shared(3, belt);
    let (before, ticks) = run_driven(&mut three, (1e-3, 0.0), 0.06, |_| belt);
    all_completed(&ticks);
    assert!(before.events().is_empty(), "{:?}", before.events());
    let forces = three.model().friction_forces(three.mode(), three.state(), &belt);
    for contact in 0..3 {
        close("a third each", forces.at(contact), 100.0 * 0.1 * 0.06 / 3.0, 1e-12);
    }
    let (all, ticks) = run_driven(&mut shared(3, belt), (1e-3, 0.0), 2.0, |_| belt);
    all_completed(&ticks);
    let (one, _) = run_driven(&mut shared(1, belt), (1e-3, 0.0), 2.0, |_| belt);
    assert!(one.events().len() >= 4, "{:?}", one.times());
    // Decided together: each stop and each slip is one change of all three.
    assert_eq!(all.events().len(), one.events().len(), "{:?}", all.times());
    for (single, seen) in one.events().iter().zip(all.events()) {
        let states = [0, 1, 2].map(|contact| seen.to.contacts.state(contact));
        assert_eq!(states, [single.to.contacts.state(0); 3]);
        close(format_args!("{states:?}"), seen.t, single.t, 1e-11);
    }
}

#[test]
fn a_stick_follows_a_small_jump_of_the_belt_and_is_torn_off_by_a_large_one() {
    // The slack is 1/64 of 0.1 m/s.
    for (jump, state) in [
        (1e-3, ContactState::Stick),
        (-1e-3, ContactState::Stick),
        (2e-3, ContactState::SlideDown),
        (-2e-3, ContactState::SlideUp),
    ] {
        let mut it = shared(1, Motion { rate: 0.01, ..Motion::default() });
        let belt = move |t: f64| {
            let rate = if t < 1e-3 { 0.01 } else { 0.01 + jump };
            Motion { rate, ..Motion::default() }
        };
        for n in 0..2 {
            let t = f64::from(n) * 1e-3;
            let tick = it.advance(1e-6, &|_| belt(t), &mut pode::Silent);
            assert_eq!(tick.advance, Advance::Completed);
        }
        assert_eq!(it.mode().contacts.state(0), state, "jump {jump}");
    }
}

#[test]
fn an_accelerated_belt_carries_a_mass_until_inertia_and_spring_take_its_friction() {
    // v = ½ β t²: the friction is β t + k β t³/6, up to 1.5 N.
    let beta = 2.0;
    let belt = |t: f64| Motion {
        position: beta * t * t * t / 6.0,
        rate: 0.5 * beta * t * t,
        acceleration: beta * t,
        jerk: beta,
    };
    let release = root(0.0, 1.0, |t| beta * t + 100.0 * beta * t * t * t / 6.0 - 1.5);
    for h in [1e-4, 1e-3, 7e-3] {
        let mut it = shared(2, belt(0.0));
        let (recorder, ticks) = run_driven(&mut it, (h, 0.3), release + 0.01, belt);
        all_completed(&ticks);
        assert_eq!(recorder.events().len(), 1, "{:?}", recorder.events());
        close(format_args!("release, h {h}"), recorder.events()[0].t, release, 1e-11);
        close("speed", recorder.events()[0].after[1], belt(release).rate, 1e-11);
        let slips = recorder.events()[0].to.contacts;
        assert_eq!([0, 1].map(|it| slips.state(it)), [ContactState::SlideDown; 2]);
    }
}
