//! One contact is the two modes that one would write by hand, and one bearing is Filippov's
//! surface.

use contacts::{
    ContactIndices, ContactMode, ContactSet, ContactSpec, ContactState, ContactSystem,
    FrictionLimits, FrictionSpec, WithContacts,
};
use pode::filippov::{Filippov, Surface};
use pode::stepper::Rk4;
use pode::{
    GuardId, GuardSpec, GuardValue, Guarded, Limits, Model, Nature, Reset, Resets, Simulator,
};

use crate::common::stick_slip::StickSlip;
use crate::common::{G, all_completed, close, each_step_and_phase, run};

/// A mass of 1 kg on a felt: height (m) and speed (m/s).
fn pressed(x: &[f64; 2]) -> [f64; 2] {
    let depth = -x[0];
    let elastic = 5e3 * depth * depth.abs().sqrt();
    [x[1], elastic * (1.0 - 0.4 * x[1]) - G]
}

/// The same above the felt.
fn falling(x: &[f64; 2]) -> [f64; 2] {
    [x[1], -G]
}

/// Two modes, written by hand: whether the felt is touched.
#[derive(Debug)]
struct ByHand;

impl Model for ByHand {
    type Mode = bool;
    type State = [f64; 2];
    type Input = ();
    const COORDS: usize = 1;

    fn derivative(&self, is_closed: bool, x: &[f64; 2], (): &()) -> [f64; 2] {
        if is_closed { pressed(x) } else { falling(x) }
    }

    fn readout(&self, _: bool, _: &[f64; 2], (): &()) -> f64 {
        0.0
    }
}

impl Guarded for ByHand {
    fn guards(&self, _: bool) -> &[GuardSpec] {
        const GAP: [GuardSpec; 1] = [GuardSpec::new(0, "felt")];
        &GAP
    }

    fn guard(&self, is_closed: bool, _: GuardId, x: &[f64; 2], (): &()) -> GuardValue {
        let gap = GuardValue::new(x[0], x[1]);
        if is_closed { -gap } else { gap }
    }
}

impl Resets for ByHand {
    fn reset(&self, is_closed: bool, _: GuardId, x: &[f64; 2], (): &()) -> Reset<Self> {
        Reset::to(!is_closed, *x)
    }
}

/// The same as a contact.
#[derive(Debug)]
struct OneFelt([ContactSpec; 1]);

impl ContactSystem for OneFelt {
    type Structure = ();
    type State = [f64; 2];
    type Input = ();
    const COORDS: usize = 1;

    fn contacts(&self) -> &[ContactSpec] {
        &self.0
    }

    fn gap(&self, (): (), _: usize, x: &[f64; 2], (): &()) -> GuardValue {
        GuardValue::new(x[0], x[1])
    }

    fn derivative(&self, (): (), closed: ContactIndices, x: &[f64; 2], (): &()) -> [f64; 2] {
        if closed.contains(0) { pressed(x) } else { falling(x) }
    }
}

#[test]
fn one_contact_is_the_model_with_two_modes_to_the_bit() {
    each_step_and_phase(|h, phase| {
        let start = [0.05, 0.0];
        let mut by_hand = Simulator::new(ByHand, Rk4, Limits::default(), false, start);
        let model = WithContacts::new(OneFelt([ContactSpec::new("felt", 1.0)])).unwrap();
        let (mode, x) = model.start((), &start, &());
        let mut contact = Simulator::new(model, Rk4, Limits::default(), mode, x);
        let (one, ticks) = run(&mut by_hand, h, phase, 1.5);
        all_completed(&ticks);
        let (other, same) = run(&mut contact, h, phase, 1.5);
        assert!(one.events().len() >= 5, "{:?}", one.times());
        assert_eq!(one.times(), other.times(), "h {h}, phase {phase}");
        assert_eq!((by_hand.state(), ticks), (contact.state(), same), "h {h}, phase {phase}");
        assert_eq!(contact.mode().contacts.is_closed(0), by_hand.mode());
    });
}

/// The mass on a belt of [`StickSlip`], with a bearing.
#[derive(Debug)]
struct OneBearing([ContactSpec; 1]);

impl ContactSystem for OneBearing {
    type Structure = ();
    type State = [f64; 2];
    type Input = ();
    const COORDS: usize = 1;

    fn contacts(&self) -> &[ContactSpec] {
        &self.0
    }

    fn gap(&self, (): (), _: usize, _: &[f64; 2], (): &()) -> GuardValue {
        unreachable!("a bearing has no gap")
    }

    fn derivative(&self, (): (), _: ContactIndices, x: &[f64; 2], (): &()) -> [f64; 2] {
        [x[1], -100.0 * x[0]]
    }

    fn slip(&self, (): (), _: usize, x: &[f64; 2], (): &()) -> Surface<[f64; 2]> {
        Surface { value: x[1] - 0.1, gradient: [0.0, 1.0], drift: 0.0 }
    }

    fn response(&self, (): (), _: usize, _: &[f64; 2], (): &()) -> [f64; 2] {
        [0.0, 1.0]
    }

    fn friction(&self, (): (), _: usize, _: &[f64; 2], (): &()) -> FrictionLimits {
        FrictionLimits { stiction: 1.5, kinetic: 1.0 }
    }
}

#[test]
fn one_bearing_is_filippov_s_surface() {
    let friction = FrictionSpec::new("belt", 1.0, 0.1);
    each_step_and_phase(|h, phase| {
        let start = [0.0, 0.1];
        let surface = Filippov(StickSlip { nature: Nature::default() });
        let (mode, x) = surface.start(&start, &());
        let mut filippov = Simulator::new(surface, Rk4, Limits::default(), mode, x);
        let model = WithContacts::new(OneBearing([ContactSpec::bearing("belt", friction)]));
        let model = model.unwrap();
        let (mode, x) = model.start((), &start, &());
        assert_eq!(mode.contacts.state(0), ContactState::Stick);
        let mut bearing = Simulator::new(model, Rk4, Limits::default(), mode, x);
        let (one, ticks) = run(&mut filippov, h, phase, 3.0);
        all_completed(&ticks);
        let (other, ticks) = run(&mut bearing, h, phase, 3.0);
        all_completed(&ticks);
        assert!(
            one.events().len() >= 8 && one.events().len() == other.events().len(),
            "{:?}",
            other.events()
        );
        // What rounding does to either; a dense output of the fourth order apart, where one is
        // located by the force and the other by its square.
        let tolerance = 1e-12 + h.powi(4) * 10.0;
        for (one, other) in one.events().iter().zip(other.events()) {
            close(format_args!("h {h}, phase {phase}"), other.t, one.t, tolerance);
            close("x", other.after[0], one.after[0], tolerance);
        }
    });
}

#[test]
fn a_mode_prints_what_is_not_open() {
    let contacts = ContactSet::OPEN.with(3, ContactState::SlideUp);
    let mode = ContactMode { structure: (), contacts };
    assert_eq!(format!("{mode:?}"), "ContactMode { structure: (), contacts: {3: SlideUp} }");
}
