//! Inputs that once broke the solver, found by `fuzz/` and by its twin.

use crate::common::no_input;
use pode::stepper::{Controlled, Dop853, Heun, Rk4};
use pode::{
    Advance, Bracket, Cap, Fault, GuardId, GuardSpec, GuardValue, Guarded, Limits, MAX_GUARDS,
    Model, Nature, Piece, Resets, Signal, Silent, Simulator, Stepper, Watch, locate,
};

#[derive(Clone, Copy, Debug)]
struct Careless {
    rate: f64,
    longest_step: f64,
    pinned: Option<f64>,
    guards: &'static [GuardSpec],
    guard: fn(f64) -> GuardValue,
}

const ONE: [GuardSpec; 1] = [GuardSpec::new(0, "g")];

const SOUND: Careless = Careless {
    rate: 1.0,
    longest_step: f64::INFINITY,
    pinned: None,
    guards: &ONE,
    guard: |_| GuardValue::new(1.0, 0.0),
};

impl Model for Careless {
    type Mode = ();
    type State = [f64; 1];
    type Input = ();
    const COORDS: usize = 1;

    fn derivative(&self, (): (), _: &[f64; 1], (): &()) -> [f64; 1] {
        [self.rate]
    }

    fn readout(&self, (): (), x: &[f64; 1], (): &()) -> f64 {
        x[0]
    }

    fn nature(&self, (): ()) -> Nature {
        Nature::default().with_longest_step(self.longest_step)
    }
}

impl Guarded for Careless {
    fn constrain(&self, (): (), x: &[f64; 1], (): &()) -> [f64; 1] {
        [self.pinned.unwrap_or(x[0])]
    }

    fn guards(&self, (): ()) -> &'static [GuardSpec] {
        self.guards
    }

    fn guard(&self, (): (), _: GuardId, x: &[f64; 1], (): &()) -> GuardValue {
        (self.guard)(x[0])
    }
}

impl Resets for Careless {}

fn start<T: Stepper>(model: Careless, stepper: T) -> Simulator<Careless, T> {
    Simulator::new(model, stepper, Limits::default(), (), [0.0])
}

fn end<T: Stepper>(model: Careless, stepper: T) -> Advance {
    start(model, stepper).advance(1.0, &no_input, &mut Silent).advance
}

#[test]
fn a_longest_step_that_is_no_length_takes_more_pieces_than_there_are() {
    for longest_step in [0.0, -0.0, -1.0, f64::NEG_INFINITY] {
        // A state that is put in place cannot show a NaN of the step.
        for pinned in [None, Some(0.5)] {
            let model = Careless { longest_step, pinned, ..SOUND };
            assert_eq!(end(model, Rk4), Advance::Capped(Cap::Pieces), "{longest_step}");
            let controlled = Controlled::<Dop853>::default();
            assert_eq!(end(model, controlled), Advance::Capped(Cap::Pieces), "{longest_step}");
        }
    }
}

#[test]
fn a_longest_step_that_nobody_gives_as_a_number_takes_more_pieces_than_there_are() {
    let limits = Limits { longest_step: f64::NAN, ..Limits::default() };
    for pinned in [None, Some(0.5)] {
        let model = Careless { longest_step: f64::NAN, pinned, ..SOUND };
        let mut simulator = Simulator::new(model, Rk4, limits, (), [0.0]);
        let tick = simulator.advance(1.0, &no_input, &mut Silent);
        assert_eq!(tick.advance, Advance::Capped(Cap::Pieces));
    }
}

#[test]
fn a_longest_step_that_one_side_gives_as_a_number_holds() {
    let tick = start(Careless { longest_step: f64::NAN, ..SOUND }, Rk4);
    let limits = Limits { longest_step: 0.25, ..Limits::default() };
    let mut simulator = Simulator::new(*tick.model(), Rk4, limits, (), [0.0]);
    assert_eq!(simulator.advance(1.0, &no_input, &mut Silent).work.pieces, 4);
}

#[test]
fn steps_that_were_refused_down_to_nothing_grow_again() {
    // So fast that even 1e-16 of the tick is refused, in ticks so short that the steps vanish.
    for h in [1.0, 1e-3, 1e-300, 5e-324] {
        let mut simulator =
            start(Careless { rate: f64::MAX, ..SOUND }, Controlled::<Dop853>::default());
        for _ in 0..4 {
            let _ = simulator.advance(h, &no_input, &mut Silent);
        }
        simulator.set_model(SOUND);
        simulator.place((), [0.0]);
        let tick = simulator.advance(1e-3, &no_input, &mut Silent);
        assert_eq!(tick.advance, Advance::Completed, "after ticks of {h:e}: {:?}", tick.work);
        assert!((simulator.state()[0] - 1e-3).abs() < 1e-15, "after ticks of {h:e}");
    }
}

#[test]
fn a_mode_with_too_many_guards_is_a_fault() {
    static MANY: [GuardSpec; MAX_GUARDS + 1] = [ONE[0]; MAX_GUARDS + 1];
    let too_many = Careless { guards: &MANY, ..SOUND };
    assert_eq!(end(too_many, Rk4), Advance::Faulty(Fault::Guard));
    let most = Careless { guards: &MANY[1..], ..SOUND };
    assert_eq!(end(most, Rk4), Advance::Completed);
}

#[test]
fn a_guard_that_is_not_a_number_where_only_a_look_finds_it_is_a_fault() {
    // Positive at both ends of the step; lowest, and NaN, between them.
    let dips = |x: f64| {
        let value = if (x - 0.5).abs() < 1e-3 { f64::NAN } else { 0.01 + (x - 0.5).powi(2) };
        GuardValue::new(value, 2.0 * (x - 0.5))
    };
    let model = Careless { guard: dips, ..SOUND };
    assert_eq!(end(model, Rk4), Advance::Faulty(Fault::Guard));
}

#[test]
fn the_last_of_all_ticks_is_followed_by_the_first() {
    let mut simulator = start(SOUND, Rk4).with_tick(u64::MAX);
    assert_eq!(simulator.advance(1.0, &no_input, &mut Silent).advance, Advance::Completed);
    assert_eq!(simulator.tick(), 0);
}

#[derive(Default)]
struct Seamless(f64);

impl Watch<Careless> for Seamless {
    fn piece<S: Signal<()>>(&mut self, _: &Careless, piece: &Piece<'_, Careless, S>) {
        assert_eq!(piece.theta.0.to_bits(), self.0.to_bits());
        self.0 = piece.theta_end();
        assert!(self.0 <= 1.0);
    }
}

#[test]
fn pieces_leave_no_gap_where_their_ends_are_rounded() {
    static ONCE: [GuardSpec; 1] = [ONE[0].on_crossing()];
    let falls = |x: f64| GuardValue::new(0.13 - x, -1.0);
    for n in 1..200 {
        // An event in the first of three steps; the rest of that step ends where the step would.
        let rate = 1.0 + f64::from(n) / 200.0;
        let model = Careless { guards: &ONCE, guard: falls, rate, ..SOUND };
        let model = Careless { longest_step: 1.0 / 3.0, ..model };
        let mut seamless = Seamless::default();
        let _ = start(model, Heun).advance(1.0, &no_input, &mut seamless);
        assert_eq!(seamless.0.to_bits(), 1.0_f64.to_bits(), "speed {n}");
    }
}

const ODD: [f64; 8] = [0.0, -0.0, 1.0, 0.5, -1.0, f64::NAN, f64::INFINITY, f64::NEG_INFINITY];

fn pairs() -> impl Iterator<Item = [f64; 2]> {
    ODD.into_iter().flat_map(|first| ODD.map(|second| [first, second]))
}

#[test]
fn a_bracket_that_is_none_is_given_back_after_a_few_looks() {
    for ([lo, hi], [at_lo, at_hi]) in pairs().flat_map(|ends| pairs().map(move |at| (ends, at))) {
        let bracket = Bracket { lo, at_lo, hi, at_hi };
        for tolerance in ODD {
            let located = locate(|tau| 0.3 - tau, bracket, Some((0.5, -1.0)), tolerance);
            assert!(located.evaluations <= 64, "{bracket:?} to {tolerance}: {located:?}");
        }
    }
}
