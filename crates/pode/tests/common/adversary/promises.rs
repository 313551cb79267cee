//! Promises of a tick for every model.

use pode::{
    Advance, Event, EventCause, Fault, Guarded as _, Limits, Piece, Signal, Simulator, Stepper,
    Tick, Watch,
};

use super::plan::{Deed, Plan, TICKS};
use super::{Adversary, Calls, STATE};

type Place = (u8, [f64; STATE]);

/// Plays the session in `bytes`, and checks every promise at every tick; `allocated` counts this
/// thread's allocations.
///
/// # Panics
/// If a promise is broken.
pub fn check<T: Stepper>(bytes: &[u8], stepper: T, allocated: fn() -> u64) -> [Report; TICKS] {
    let calls = Calls::default();
    let plan = Plan::from_bytes(bytes, &calls);
    let (mode, state) = plan.start;
    let simulator = Simulator::new(plan.model, stepper, plan.limits, mode, state);
    let mut simulator = simulator.with_tick(plan.tick);
    if !plan.is_read {
        simulator = simulator.without_readout();
    }
    plan.deeds.map(|deed| {
        if let Some((mode, state)) = deed.placed {
            simulator.place(mode, state);
        }
        if deed.is_changed {
            simulator.set_model(simulator.model().turned());
        }
        calls.derivatives.set(0);
        calls.jacobians.set(0);
        calls.guards.set(0);
        calls.readouts.set(0);
        check_tick(&mut simulator, &deed, &plan.limits, &calls, allocated)
    })
}

#[derive(Clone, Copy, Debug)]
pub struct Report {
    pub tick: Tick,
    pub moves: u32,
}

fn check_tick<T: Stepper>(
    simulator: &mut Simulator<Adversary<'_>, T>,
    deed: &Deed,
    limits: &Limits,
    calls: &Calls,
    allocated: fn() -> u64,
) -> Report {
    let before = (simulator.mode(), *simulator.state());
    let number = simulator.tick();
    let mut witness = Witness::new(before);
    let heap = allocated();
    let tick = simulator.advance(deed.h, &deed.wave, &mut witness);
    assert_eq!(allocated(), heap, "memory was asked for");
    assert_eq!(simulator.tick(), number.wrapping_add(1), "the ticks go on");
    work_is_bounded::<T>(&tick, limits);
    work_is_what_was_done(&tick, calls);
    outcome_is_sound(&tick, deed, &witness, limits);
    state_is_the_last_good_one(simulator, &tick, deed, before, &witness);
    Report { tick, moves: witness.moves }
}

fn work_is_bounded<T: Stepper>(tick: &Tick, limits: &Limits) {
    let work = tick.work;
    assert!(work.pieces <= limits.pieces, "{tick:?}");
    assert!(work.guards <= limits.guards, "{tick:?}");
    assert!(work.events <= limits.events, "{tick:?}");
    assert!(work.derivatives <= limits.most_derivatives::<T>(), "{tick:?}");
    assert!(work.jacobians <= limits.most_jacobians::<T>(), "{tick:?}");
    assert!(work.readouts <= limits.most_readouts::<T>(), "{tick:?}");
    assert!(work.certain + work.unknown <= work.pieces, "{tick:?}");
}

fn work_is_what_was_done(tick: &Tick, calls: &Calls) {
    let work = tick.work;
    let counted = [work.derivatives, work.jacobians, work.guards, work.readouts];
    let done = [&calls.derivatives, &calls.jacobians, &calls.guards, &calls.readouts];
    assert_eq!(counted, done.map(std::cell::Cell::get), "{tick:?}");
}

fn outcome_is_sound(tick: &Tick, deed: &Deed, witness: &Witness, limits: &Limits) {
    let is_period = deed.h > 0.0 && deed.h.is_finite();
    assert_eq!(tick.advance == Advance::Faulty(Fault::Period), !is_period, "{tick:?}");
    assert!(witness.most_at_once <= limits.cascade, "{} at once", witness.most_at_once);
    assert_eq!(witness.events, tick.work.events, "{tick:?}");
    if tick.advance == Advance::Completed {
        assert_eq!(witness.theta.to_bits(), 1.0_f64.to_bits(), "{tick:?}");
    }
    if !matches!(tick.advance, Advance::Faulty(_)) {
        assert!(tick.mean_readout.is_finite() && tick.end_readout.is_finite(), "{tick:?}");
        assert!(tick.impulse.is_finite() && !tick.local_error.is_nan(), "{tick:?}");
    }
}

/// Checks that the last reached state is kept, with slaved entries in place; it is finite if the
/// state before the tick was.
fn state_is_the_last_good_one<T: Stepper>(
    simulator: &Simulator<Adversary<'_>, T>,
    tick: &Tick,
    deed: &Deed,
    before: Place,
    witness: &Witness,
) {
    let is_finite = |x: &[f64; STATE]| x.iter().all(|entry| entry.is_finite());
    let bits = |x: &[f64; STATE]| x.map(f64::to_bits);
    let (mode, state) = (simulator.mode(), *simulator.state());
    assert!(is_finite(&state) || !is_finite(&before.1), "{state:?} after {tick:?}");
    let (last_mode, last) = witness.last;
    assert_eq!(mode, last_mode, "{tick:?}");
    let put = |x: &[f64; STATE], theta| simulator.model().constrain(mode, x, &deed.wave.at(theta));
    let at_start = put(&last, 0.0);
    let kept = [last, put(&last, 1.0), at_start, put(&at_start, 1.0)];
    assert!(kept.iter().any(|it| bits(it) == bits(&state)), "{state:?} is not {last:?}: {tick:?}");
}

#[derive(Debug)]
struct Witness {
    theta: f64,
    last: Place,
    events: u32,
    moves: u32,
    at_once: u32,
    most_at_once: u32,
}

impl Witness {
    const fn new(last: Place) -> Self {
        Self { theta: 0.0, last, events: 0, moves: 0, at_once: 0, most_at_once: 0 }
    }

    fn pass(&mut self, theta: f64) {
        assert!((self.theta..=1.0).contains(&theta), "from {} to {theta}", self.theta);
        if theta > self.theta {
            self.at_once = 0;
        }
        self.theta = theta;
    }
}

impl Watch<Adversary<'_>> for Witness {
    fn piece<S: Signal<pode::Motion>>(
        &mut self,
        _: &Adversary<'_>,
        piece: &Piece<'_, Adversary<'_>, S>,
    ) {
        assert_eq!(piece.theta.0.to_bits(), self.theta.to_bits(), "pieces leave no gap");
        assert!(piece.h >= 0.0 && (0.0..=1.0).contains(&piece.tau));
        self.pass(piece.theta_end());
        self.last = (piece.mode, piece.end);
    }

    fn event(&mut self, _: &Adversary<'_>, event: &Event<'_, Adversary<'_>>) {
        self.pass(event.theta);
        self.events += 1;
        self.moves += u32::from(!matches!(event.cause, EventCause::Guard(_)));
        self.at_once += 1;
        self.most_at_once = self.most_at_once.max(self.at_once);
        self.last = event.after;
    }
}
