//! The declared maxima of work per tick, with the default limits: for each there is a model that
//! reaches it exactly, tick after tick.

use crate::common::no_input;
use pode::stepper::{
    BogackiShampine, ByNeed, Controlled, Dop853, Exact, ExplicitEuler, Heun,
    LinearImplicitMidpoint, Rk4, Rodas3, SemiImplicitEuler, Tsitouras5, VelocityVerlet,
};
use pode::{
    Advance, Bracket, Cap, EquationKind, GuardSpec, GuardValue, Limits, Nature, Silent, Simulator,
    Stepper, Tick, WorkLimit, locate,
};

use crate::busy::{Busy, Stirred};

const LIMITS: Limits = Limits {
    events: 64,
    cascade: 32,
    followed: 6,
    guards: 8192,
    pieces: 1024,
    work: WorkLimit::NONE,
    longest_step: f64::INFINITY,
    stretch: 1.0,
    forecast: true,
    event_tolerance: 1.0 / (1_u64 << 40) as f64,
};

#[test]
fn the_default_limits_are_those_tested_here() {
    assert_eq!(Limits::default(), LIMITS);
}

fn ticks<T: Stepper>(model: Busy, stepper: T) -> [Tick; 4] {
    let mut simulator = Simulator::new(model, stepper, Limits::default(), false, [0.0; 3]);
    [0; 4].map(|_| simulator.advance(1.0, &no_input, &mut Silent))
}

const ONE: [GuardSpec; 1] = [GuardSpec::new(0, "g")];

const SAW: Busy = Busy {
    guards: &ONE,
    guard: |_, [t, n, _]| GuardValue::new((n + 1.0) / 200.0 - t, -1.0),
    ..Busy::IDLE
};

#[test]
fn a_guard_that_comes_back_reaches_the_most_events() {
    for tick in ticks(SAW, Rk4) {
        assert_eq!((tick.advance, tick.work.events), (Advance::Capped(Cap::Events), 64));
    }
}

#[test]
fn modes_that_send_each_other_away_reach_the_most_events_at_one_instant() {
    let ring = Busy { guards: &ONE, guard: |_, _| GuardValue::new(-1.0, 0.0), ..Busy::IDLE };
    for tick in ticks(Busy { goes_on: true, ..ring }, Rk4) {
        assert_eq!((tick.advance, tick.work.events), (Advance::Capped(Cap::Cascade), 32));
        assert_eq!(tick.work.pieces, 0, "no time has passed");
    }
}

#[test]
fn impacts_of_no_length_count_at_their_instant() {
    // Every reset is followed by a move over a sequence of no duration.
    let stuck = Busy { guards: &ONE, guard: |_, _| GuardValue::new(-1.0, 0.0), ..Busy::IDLE };
    for after in [0.0, -1.0, f64::NEG_INFINITY] {
        for tick in ticks(Busy { settles: Some(after), goes_on: true, ..stuck }, Rk4) {
            assert_eq!((tick.advance, tick.work.events), (Advance::Capped(Cap::Cascade), 32));
        }
    }
}

#[test]
fn eight_guards_over_short_steps_reach_the_most_guard_evaluations() {
    const EIGHT: [GuardSpec; 8] = [
        GuardSpec::new(0, "a"),
        GuardSpec::new(1, "b"),
        GuardSpec::new(2, "c"),
        GuardSpec::new(3, "d"),
        GuardSpec::new(4, "e"),
        GuardSpec::new(5, "f"),
        GuardSpec::new(6, "g"),
        GuardSpec::new(7, "h"),
    ];
    let far = Busy { guards: &EIGHT, longest_step: 1e-4, ..Busy::IDLE };
    for tick in ticks(far, Rk4) {
        assert_eq!((tick.advance, tick.work.guards), (Advance::Capped(Cap::Guards), 8192));
    }
}

/// Asserts that short steps of a mode of this `nature` reach the maxima of pieces and derivatives.
#[track_caller]
fn check_steps<T: Stepper>(stepper: T, nature: Nature) {
    let short = Busy { nature, longest_step: 1e-4, ..Busy::IDLE };
    let limits = Limits { longest_step: 1e-4, ..LIMITS };
    let mut simulator = Simulator::new(short, stepper, limits, false, [0.0; 3]);
    for _ in 0..4 {
        let tick = simulator.advance(1.0, &no_input, &mut Silent);
        assert_eq!((tick.advance, tick.work.pieces), (Advance::Capped(Cap::Pieces), 1024));
        let most = (limits.most_derivatives::<T>(), limits.most_jacobians::<T>());
        assert_eq!((tick.work.derivatives, tick.work.jacobians), most, "{}", T::NAME);
    }
}

#[test]
fn short_steps_reach_the_most_pieces_derivatives_and_jacobians() {
    let [smooth, linear, stiff] = [EquationKind::Smooth, EquationKind::Linear, EquationKind::Stiff]
        .map(|kind| Nature::new(kind, 0.0));
    check_steps(ExplicitEuler, smooth);
    check_steps(SemiImplicitEuler, smooth);
    check_steps(VelocityVerlet, smooth);
    check_steps(Heun, smooth);
    check_steps(Rk4, smooth);
    check_steps(Rodas3, stiff);
    check_steps(LinearImplicitMidpoint, stiff);
    check_steps(Exact, linear);
    check_steps(ByNeed::default(), stiff);
    assert_eq!(LIMITS.most_derivatives::<Rk4>(), 4096);
}

#[track_caller]
fn check_refused<T: Stepper>(stepper: T, derivatives: u32) {
    let limits = Limits::default();
    let mut simulator = Simulator::new(Stirred, stepper, limits, (), [0.0]);
    for _ in 0..4 {
        let tick = simulator.advance(1.0, &|theta| theta, &mut Silent);
        assert_eq!((tick.advance, tick.work.pieces), (Advance::Capped(Cap::Pieces), 1024));
        assert_eq!(tick.work.derivatives, derivatives, "{}", T::NAME);
        assert!(tick.work.derivatives <= limits.most_derivatives::<T>());
        assert!(simulator.state()[0].abs() < f64::MIN_POSITIVE);
    }
}

#[test]
fn refused_steps_reach_the_most_derivatives() {
    let [three, five] = [BogackiShampine::EVALUATIONS, Tsitouras5::EVALUATIONS];
    check_refused(Controlled::<BogackiShampine>::default(), 1024 * three);
    check_refused(Controlled::<Tsitouras5>::default(), 1024 * five);
    // It keeps the slope at the start, which belongs to the state and not to the step.
    check_refused(Controlled::<Dop853>::default(), 1024 * 12 + 1);
}

#[test]
fn events_with_moves_over_short_steps_reach_the_most_readouts() {
    // Thirty-two times an event and a move over a sequence too short to follow, and then steps.
    let moves = Busy {
        guard: |_, [t, n, _]| {
            GuardValue::new(if n < 32.0 { (n + 1.0) / 500.0 - t } else { 1.0 }, -1.0)
        },
        settles: Some(0.0),
        longest_step: 1e-4,
        ..SAW
    };
    let tick = ticks(moves, Rk4)[0];
    let work = tick.work;
    assert_eq!((tick.advance, work.events), (Advance::Capped(Cap::Pieces), 64));
    assert_eq!(work.readouts, LIMITS.most_readouts::<Rk4>());
    assert_eq!(work.readouts, 2 * 1024 + 64 + 32 + 2);
}

#[test]
fn a_guard_that_answers_by_malice_reaches_the_most_evaluations_of_a_search() {
    for halvings in [10, 20, 30, 40] {
        let tolerance = 1.0 / f64::from(2.0_f32).powi(halvings);
        let whole = Bracket { lo: 0.0, at_lo: 1e-9, hi: 1.0, at_hi: -1e9 };
        let (mut lo, mut hi, mut answers) = (0.0, 1.0, 0);
        let malice = |tau: f64| {
            answers += 1;
            // Leaves the longer part, and pretends that the root is at its very start. Once a zero,
            // so that the search must check the guard after it.
            let is_longer_after = hi - tau >= tau - lo;
            match (answers, is_longer_after) {
                (2, _) | (_, false) => hi = tau,
                (_, true) => lo = tau,
            }
            match (answers, is_longer_after) {
                (2, _) | (_, false) => -1e9,
                (3, true) => 0.0,
                (_, true) => 1e-9,
            }
        };
        let seed = Some((1e-12, -2e-9 / (1.0 - 2e-12)));
        let located = locate(malice, whole, seed, tolerance);
        assert_eq!(located.evaluations, halvings.unsigned_abs() + 4, "{located:?}");
    }
}
