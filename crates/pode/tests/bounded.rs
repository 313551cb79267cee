//! A tick ends within its declared maxima.

use pode::stepper::Rk4;
use pode::{Advance, Cap, GuardId, GuardValue, Limits, Silent, Simulator, Work, WorkLimit};

use crate::common::{Ball, ONE, Timed, count, no_input};

/// A guard that is negative again after each reset, which goes back 1/64 s.
fn comes_back() -> Timed {
    fn back(_: GuardId, x: &mut [f64; 3]) -> bool {
        x[0] -= 1.0 / 64.0;
        false
    }
    Timed { guards: &ONE, guard: |_, t| GuardValue::new(0.25 - t, -1.0), effect: back }
}

#[test]
fn a_tick_with_exactly_the_most_events_completes_and_one_more_is_capped() {
    // Reaches 0.25 and then, from t = 0, every 1/64 s: 49 times in a tick of 1 s.
    for (events, advance) in
        [(50, Advance::Completed), (49, Advance::Completed), (48, Advance::Capped(Cap::Events))]
    {
        let limits = Limits { events, ..Limits::default() };
        let mut simulator = Simulator::new(comes_back(), Rk4, limits, true, [0.0; 3]);
        let tick = simulator.advance(1.0, &no_input, &mut Silent);
        assert_eq!((tick.advance, tick.work.events), (advance, events.min(49)));
    }
}

#[test]
fn a_tick_with_exactly_the_most_guards_completes_and_one_more_is_capped() {
    let far = Timed { guards: &ONE, guard: |_, _| GuardValue::new(1.0, 0.0), effect: count };
    for (guards, advance) in [(2, Advance::Completed), (1, Advance::Capped(Cap::Guards))] {
        let limits = Limits { guards, ..Limits::default() };
        let mut simulator = Simulator::new(far, Rk4, limits, true, [0.0; 3]);
        let tick = simulator.advance(1e-3, &no_input, &mut Silent);
        assert_eq!((tick.advance, tick.work.guards), (advance, guards));
    }
}

#[test]
fn a_tick_with_exactly_the_most_pieces_completes_and_one_more_is_capped() {
    let far = Timed { guards: &ONE, guard: |_, _| GuardValue::new(1.0, 0.0), effect: count };
    for (pieces, advance) in [(10, Advance::Completed), (9, Advance::Capped(Cap::Pieces))] {
        let limits = Limits { pieces, longest_step: 1e-4, ..Limits::default() };
        let mut simulator = Simulator::new(far, Rk4, limits, true, [0.0; 3]);
        let tick = simulator.advance(1e-3, &no_input, &mut Silent);
        assert_eq!((tick.advance, tick.work.pieces), (advance, pieces));
    }
}

#[test]
fn a_tick_with_exactly_the_most_work_completes_and_one_more_is_capped() {
    let far = Timed { guards: &ONE, guard: |_, _| GuardValue::new(1.0, 0.0), effect: count };
    let work = |limits| {
        let mut simulator = Simulator::new(far, Rk4, limits, true, [0.0; 3]);
        let tick = simulator.advance(1e-3, &no_input, &mut Silent);
        (tick.advance, tick.work.evaluations())
    };
    let whole = Limits { longest_step: 1e-4, ..Limits::default() };
    let (advance, needed) = work(whole);
    assert_eq!(advance, Advance::Completed);
    assert_eq!(work(Limits { work: WorkLimit::of(needed), ..whole }), (Advance::Completed, needed));
    for limit in 0..needed {
        let (advance, done) = work(Limits { work: WorkLimit::of(limit), ..whole });
        assert_eq!(advance, Advance::Capped(Cap::Work(limit)));
        assert!(done <= limit && limit < done + 6, "{done} of {limit}");
    }
    let early = |early| work(Limits { work: WorkLimit { early, most: needed }, ..whole }).0;
    assert_eq!([early(20), early(10)], [Advance::Completed, Advance::Capped(Cap::Work(10))]);
}

#[test]
fn work_of_typical_ticks() {
    let mut ball = Ball::dropped(0.8, 1.0, Limits::default());
    let mut next = || ball.advance(1e-3, &no_input, &mut Silent).work;
    let tick = |pieces, derivatives, guards, readouts, events| Work {
        pieces,
        derivatives,
        rates: 2 * derivatives,
        guards,
        readouts,
        events,
        unknown: pieces,
        ..Work::default()
    };
    assert_eq!(next(), tick(1, 4, 2, 3, 0), "first tick");
    let quiet = tick(1, 4, 1, 3, 0);
    for n in 1..451 {
        assert_eq!(next(), quiet, "tick {n}: no event");
    }
    // The end of the step, two evaluations that locate the impact, one after it, and the end again.
    assert_eq!(next(), tick(2, 8, 5, 6, 1), "one event");
    for n in 452..600 {
        assert_eq!(next(), quiet, "tick {n}: after it");
    }
}
