//! Case C12: broken models, broken periods and odd resets.

use pode::input::Cubic;
use pode::stepper::Rk4;
use pode::{
    Advance, Cap, Event, Fault, GuardId, GuardSpec, GuardValue, Guarded, Limits, Model, Motion,
    Reset, Resets, RunRecorder, Silent, Simulator, Watch,
};

use crate::common::{
    Ball, BallMode, ON_CROSSING, ONE, STEPS, Threshold, Timed, all_completed, close, count,
    count_and_flip, each_step_and_phase, no_input, run,
};

#[test]
fn a_nan_guard_is_a_fault_in_bounded_work_and_keeps_the_last_state() {
    const GUARDS: [fn(GuardId, f64) -> GuardValue; 3] = [
        |_, t| GuardValue::new(if t > 0.05 { f64::NAN } else { 1.0 }, 0.0),
        |_, t| GuardValue::new(1.0, if t > 0.05 { f64::NAN } else { 0.0 }),
        |_, t| {
            let left = 0.05 - t;
            GuardValue::new(if left.abs() < 1e-4 { f64::NAN } else { left }, -1.0)
        },
    ];
    for guard in GUARDS {
        let mut timed = Timed { guards: &ONE, guard, effect: count }.start();
        let mut before = *timed.state();
        for n in 0..20 {
            let tick = timed.advance(7e-3, &no_input, &mut Silent);
            assert!(tick.work.guards <= 60, "{:?}", tick.work);
            match tick.advance {
                Advance::Completed => before = *timed.state(),
                Advance::Capped(cap) => panic!("tick {n}: capped at {cap:?}"),
                Advance::Faulty(fault) => {
                    assert_eq!((fault, timed.state()), (Fault::Guard, &before), "tick {n}");
                    assert_eq!(n, 7, "0.05 s lie in the eighth tick of 7 ms");
                    break;
                }
            }
        }
        assert!((0.049 - before[0]).abs() < 1e-15, "the fault was not met: {before:?}");
    }
}

#[derive(Clone, Copy, Debug, PartialEq)]
struct Broken {
    derivative: f64,
    readout: f64,
    reset: f64,
    impulse: f64,
}

const SOUND: Broken = Broken { derivative: 1.0, readout: 1.0, reset: 0.0, impulse: 1.0 };

impl Model for Broken {
    type Mode = ();
    type State = [f64; 1];
    type Input = Motion;
    const COORDS: usize = 1;

    fn derivative(&self, (): (), _: &[f64; 1], _: &Motion) -> [f64; 1] {
        [self.derivative]
    }

    fn readout(&self, (): (), _: &[f64; 1], _: &Motion) -> f64 {
        self.readout
    }
}

impl Guarded for Broken {
    fn constrain(&self, (): (), x: &[f64; 1], input: &Motion) -> [f64; 1] {
        [x[0] + 0.0 * input.position]
    }

    fn guards(&self, (): ()) -> &'static [GuardSpec] {
        &ONE
    }

    fn guard(&self, (): (), _: GuardId, x: &[f64; 1], _: &Motion) -> GuardValue {
        GuardValue::new(0.5 - x[0], -1.0)
    }
}

impl Resets for Broken {
    fn reset(&self, (): (), _: GuardId, _: &[f64; 1], _: &Motion) -> Reset<Self> {
        Reset::to((), [self.reset]).with_impulse(self.impulse)
    }
}

fn start(model: Broken) -> Simulator<Broken, Rk4> {
    Simulator::new(model, Rk4, Limits::default(), (), [0.0])
}

fn still(_: f64) -> Motion {
    Motion::default()
}

#[test]
fn what_is_not_finite_is_a_fault_and_the_state_before_it_is_kept() {
    for (what, model, fault, state) in [
        ("derivative", Broken { derivative: f64::NAN, ..SOUND }, Fault::State, 0.0),
        ("derivative", Broken { derivative: f64::INFINITY, ..SOUND }, Fault::State, 0.0),
        ("reset map", Broken { reset: f64::NAN, ..SOUND }, Fault::State, 0.5),
        ("impulse of the reset map", Broken { impulse: f64::NAN, ..SOUND }, Fault::Readout, 0.5),
        // The motion itself is sound: 0.5 s up, back to 0, and 0.5 s up, where the guard is due.
        ("readout", Broken { readout: f64::NAN, ..SOUND }, Fault::Readout, 0.0),
    ] {
        let mut simulator = start(model);
        let tick = simulator.advance(1.0, &still, &mut Silent);
        assert_eq!(tick.advance, Advance::Faulty(fault), "{what}");
        close(what, simulator.state()[0], state, 1e-15);
    }
}

#[test]
fn an_input_that_is_not_finite_is_a_fault_and_does_not_reach_the_state() {
    let bad = |from: f64| {
        move |theta: f64| {
            let position = if theta >= from { f64::NAN } else { 0.0 };
            Motion { position, ..Motion::default() }
        }
    };
    for from in [0.0, 0.3, 1.0] {
        let mut simulator = start(SOUND);
        let tick = simulator.advance(0.1, &bad(from), &mut Silent);
        assert!(matches!(tick.advance, Advance::Faulty(_)), "from {from}: {:?}", tick.advance);
        assert!(simulator.state()[0].is_finite(), "from {from}: {:?}", simulator.state());
        let tick = simulator.advance(0.1, &still, &mut Silent);
        assert_eq!(tick.advance, Advance::Completed, "after a fault from {from}");
    }
}

#[test]
fn a_period_that_is_not_positive_and_finite_is_refused_without_work() {
    for h in [0.0, -0.0, -1e-3, f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        let mut simulator = start(SOUND);
        let tick = simulator.advance(h, &still, &mut Silent);
        assert_eq!(tick.advance, Advance::Faulty(Fault::Period), "h = {h}");
        let held = pode::Work { readouts: 1, ..pode::Work::default() };
        assert_eq!(tick.work, held, "h = {h}");
        close("the state", simulator.state()[0], 0.0, 0.0);
        close("the readout that was held", tick.mean_readout, 1.0, 0.0);
        assert_eq!(simulator.advance(0.1, &still, &mut Silent).advance, Advance::Completed);
    }
}

/// Returns a guard that falls to zero at 0.1, rests until 0.2, and then falls on or rises.
fn flat(t: f64, then: f64) -> GuardValue {
    if t < 0.1 {
        GuardValue::new(0.1 - t, -1.0)
    } else if t < 0.2 {
        GuardValue::default()
    } else {
        GuardValue::new(then * (t - 0.2), then)
    }
}

#[test]
fn a_guard_that_lies_flat_at_zero_fires_where_it_turns_negative_and_is_silent_where_it_rises() {
    const FALLS_ON: fn(GuardId, f64) -> GuardValue = |_, t| flat(t, -1.0);
    const RISES: fn(GuardId, f64) -> GuardValue = |_, t| flat(t, 1.0);
    for (guard, expected) in [(FALLS_ON, &[0.2][..]), (RISES, &[])] {
        let check = |h: f64, phase: f64| {
            let mut timed = Timed { guards: &ONE, guard, effect: count }.start();
            let (recorder, ticks) = run(&mut timed, h, phase, 0.4);
            all_completed(&ticks);
            let times = recorder.times();
            assert_eq!(times.len(), expected.len(), "h {h}, phase {phase}: {times:?}");
            for (t, expected) in times.iter().zip(expected) {
                // Located to 2⁻⁴⁰ of the tick where the guard has no derivative, and the band.
                close(format_args!("h {h}"), *t, *expected, 1e-12 * h + 2e-14);
            }
        };
        each_step_and_phase(check);
        for h in [0.03, 0.15, 0.4] {
            check(h, 0.0);
        }
    }
}

#[test]
fn a_reset_that_flips_the_sign_at_once_has_one_effect() {
    /// Jumps back to where the guard is 0.1, and in the other mode its negative.
    fn jump(id: GuardId, x: &mut [f64; 3]) -> bool {
        x[0] -= 0.1;
        count_and_flip(id, x)
    }
    // The other mode's guard, t − 0.3, is then negative and must be left at once, from where the
    // first mode's guard is positive.
    each_step_and_phase(|h, phase| {
        let guard = |_: GuardId, t: f64| GuardValue::new(0.3 - t, -1.0);
        let mut timed = Timed { guards: &ONE, guard, effect: jump }.start();
        let (recorder, ticks) = run(&mut timed, h, phase, 0.35);
        all_completed(&ticks);
        let modes: Vec<_> = recorder.events().iter().map(|seen| seen.to).collect();
        assert_eq!(modes, [false, true], "h {h}, phase {phase}");
        assert_eq!(
            recorder.events()[0].t.to_bits(),
            recorder.events()[1].t.to_bits(),
            "one instant"
        );
    });
}

#[derive(Clone, Copy, Debug, PartialEq)]
struct Chain {
    modes: u8,
    end: End,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum End {
    Stays,
    IsFrozen,
    LeadsToTheFirst,
}

impl Model for Chain {
    type Mode = u8;
    type State = [f64; 1];
    type Input = ();
    const COORDS: usize = 1;

    fn derivative(&self, mode: u8, _: &[f64; 1], (): &()) -> [f64; 1] {
        [f64::from(self.end != End::IsFrozen || mode + 1 < self.modes)]
    }

    fn readout(&self, mode: u8, _: &[f64; 1], (): &()) -> f64 {
        f64::from(mode)
    }
}

impl Guarded for Chain {
    fn guards(&self, mode: u8) -> &'static [GuardSpec] {
        if self.end == End::LeadsToTheFirst || mode + 1 < self.modes { &ONE } else { &[] }
    }

    fn guard(&self, _: u8, _: GuardId, x: &[f64; 1], (): &()) -> GuardValue {
        GuardValue::new(0.3 - x[0], -1.0)
    }
}

impl Resets for Chain {
    fn reset(&self, mode: u8, _: GuardId, x: &[f64; 1], (): &()) -> Reset<Self> {
        Reset::to((mode + 1) % self.modes, *x)
    }
}

fn chain(modes: u8, end: End) -> Simulator<Chain, Rk4> {
    Simulator::new(Chain { modes, end }, Rk4, Limits::default(), 0, [0.0])
}

#[test]
fn a_cascade_goes_through_all_its_modes_at_one_instant() {
    each_step_and_phase(|h, phase| {
        let (recorder, ticks) = run(&mut chain(3, End::Stays), h, phase, 0.5);
        all_completed(&ticks);
        let modes: Vec<_> = recorder.events().iter().map(|seen| seen.to).collect();
        assert_eq!(modes, [1, 2], "h {h}, phase {phase}");
        close("A to B", recorder.events()[0].t, 0.3, 1e-12);
        assert_eq!(
            recorder.events()[0].t.to_bits(),
            recorder.events()[1].t.to_bits(),
            "one instant"
        );
    });
}

#[test]
fn a_cycle_stops_at_the_cap_and_says_so_in_every_tick() {
    let cap = Limits::default().cascade;
    each_step_and_phase(|h, phase| {
        let mut cycle = chain(2, End::LeadsToTheFirst);
        let (recorder, ticks) = run(&mut cycle, h, phase, 0.32);
        let capped: Vec<_> = ticks.iter().filter(|it| it.advance != Advance::Completed).collect();
        assert!(!capped.is_empty(), "h {h}, phase {phase}");
        for tick in &capped {
            assert_eq!(tick.advance, Advance::Capped(Cap::Cascade));
            assert_eq!(tick.work.events, cap);
        }
        assert_eq!(recorder.events().len(), capped.len() * cap as usize);
        close("the coordinate", cycle.state()[0], 0.3, 1e-12);
    });
}

#[test]
fn a_mode_is_frozen_while_its_end_is_searched() {
    let check = |h: f64, phase: f64| {
        let mut ramp = chain(2, End::IsFrozen);
        let _ = run(&mut ramp, h, phase, 1.5);
        // The last step is a straight line: its end rounds once.
        close(format_args!("h {h}, phase {phase}"), ramp.state()[0], 0.3, 0.25 * f64::EPSILON);
    };
    each_step_and_phase(check);
    for h in [0.3, 0.7, 1.5] {
        check(h, 0.0);
    }
}

#[derive(Debug, Default)]
struct Thetas(Vec<(u64, f64)>);

impl<M: Model> Watch<M> for Thetas {
    fn event(&mut self, _: &M, event: &Event<'_, M>) {
        self.0.extend([(event.tick, event.theta)]);
    }
}

fn crossings(
    guards: &'static [GuardSpec],
    h: f64,
    ticks: impl IntoIterator<Item = [f64; 2]>,
) -> Vec<(u64, f64)> {
    let model = Threshold { guards, level: 1.0 };
    let mut simulator = Simulator::new(model, Rk4, Limits::default(), true, [0.0]);
    let mut thetas = Thetas::default();
    for [start, rise] in ticks {
        let tick = simulator.advance(h, &Cubic::new([start, rise, 0.0, 0.0], h), &mut thetas);
        assert_eq!(tick.advance, Advance::Completed);
    }
    thetas.0
}

#[test]
fn an_input_across_a_guard_is_an_event_at_the_start_of_the_tick_or_within_it() {
    for guards in [&ONE, &ON_CROSSING] {
        for h in STEPS {
            let jumps = crossings(guards, h, [0.0, 0.5, 1.5, 1.6].map(|held| [held, 0.0]));
            assert_eq!(jumps, [(2, 0.0)], "{guards:?}");
            // From 0 by 0.4 per tick, through 1 in the middle of tick 2.
            let moves = crossings(guards, h, [0.0, 0.4, 0.8, 1.2].map(|start| [start, 0.4]));
            assert_eq!((moves.len(), moves[0].0), (1, 2), "{guards:?}, h {h}");
            close("θ", moves[0].1, 0.5, 1e-12);
        }
    }
}

#[test]
fn a_guard_that_fires_on_crossings_is_not_bothered_by_an_entry_below_it() {
    let thetas = crossings(&ON_CROSSING, 1e-3, [1.5, 1.6, 0.5, 1.5].map(|held| [held, 0.0]));
    assert_eq!(thetas, [(3, 0.0)]);
}

#[test]
fn an_event_at_the_end_of_a_tick_is_not_undone_by_an_input_that_jumps_by_rounding() {
    for h in STEPS {
        // Reaches 1 at the very end of tick 0, and starts tick 1 short of it by less than the input
        // moves in the width to which the event was located.
        let thetas = crossings(&ONE, h, [0.0, 1.0 - 1e-13].map(|start| [start, 1.0]));
        assert_eq!(thetas, [(0, 1.0)], "h {h}");
    }
}

fn bounces_from(tick: u64, h: f64) -> Vec<(u64, u64, [u64; 2])> {
    #[derive(Default)]
    struct Log(Vec<(u64, u64, [u64; 2])>);
    impl Watch<Ball> for Log {
        fn event(&mut self, _: &Ball, event: &Event<'_, Ball>) {
            let state = event.after.1.map(f64::to_bits);
            self.0.extend([(event.tick, event.theta.to_bits(), state)]);
        }
    }
    let mut ball = Ball::dropped(0.8, 1.0, Limits::default()).with_tick(tick);
    let mut log = Log::default();
    while ball.mode() != BallMode::Rest {
        let _ = ball.advance(h, &no_input, &mut log);
    }
    log.0.iter_mut().for_each(|it| it.0 -= tick);
    log.0
}

#[test]
fn far_from_the_start_of_time_nothing_changes() {
    for h in STEPS {
        // 1e6 s are 1e9 ticks of 1 ms. Time is (tick, θ), so not a bit may differ.
        for tick in [10_000_000_000, 1_000_000_000, 142_857_142] {
            assert_eq!(bounces_from(0, h), bounces_from(tick, h), "h {h}, tick {tick}");
        }
    }
}

#[test]
fn shuffled_guards_give_the_same_bits() {
    const A: GuardSpec = GuardSpec::new(0, "a").on_crossing();
    const B: GuardSpec = GuardSpec::new(1, "b").on_crossing();
    const C: GuardSpec = GuardSpec::new(2, "c").on_crossing();
    static ORDERS: [[GuardSpec; 3]; 4] = [[A, B, C], [C, B, A], [B, C, A], [C, A, B]];
    fn waves(id: GuardId, t: f64) -> GuardValue {
        let omega = [50.0, 75.0, 100.0][usize::from(id.0)];
        GuardValue::new((omega * t).cos(), -omega * (omega * t).sin())
    }
    fn mix(id: GuardId, x: &mut [f64; 3]) -> bool {
        x[1] = 0.5 * x[1] + f64::from(id.0);
        x[2] = x[2].mul_add(0.9, x[1]);
        false
    }
    each_step_and_phase(|h, phase| {
        let bits = |guards: &'static [GuardSpec]| -> Vec<_> {
            let mut timed = Timed { guards, guard: waves, effect: mix }.start();
            let (recorder, _) = run(&mut timed, h, phase, 1.0);
            recorder.events().iter().map(|it| (it.name, it.t.to_bits(), it.after)).collect()
        };
        let first = bits(&ORDERS[0]);
        assert!(first.len() > 30, "too few events for a comparison: {}", first.len());
        for order in &ORDERS[1..] {
            assert_eq!(first, bits(order), "h {h}, phase {phase}");
        }
    });
}

#[test]
fn ten_short_ticks_and_a_long_one_have_the_same_events() {
    let events = |h: f64| {
        let mut ball = Ball::dropped(0.8, 1.0, Limits::default());
        let (recorder, _) = run(&mut ball, h, 0.0, 3.8);
        recorder.times()
    };
    let (long, short) = (events(1e-3), events(1e-4));
    assert!(long.len() > 10 && long.len() == short.len());
    for (long, short) in long.iter().zip(&short) {
        close("an event of 1 ms and of 10 × 0.1 ms", *long, *short, 1e-12);
    }
}

#[test]
fn a_model_that_was_changed_moves_as_changed_from_the_next_tick() {
    use pode::stepper::BogackiShampine;
    let mut simulator = Simulator::new(SOUND, BogackiShampine, Limits::default(), (), [0.0]);
    let _ = simulator.advance(0.1, &still, &mut Silent);

    simulator.set_model(Broken { derivative: 2.0, ..SOUND });
    let _ = simulator.advance(0.1, &still, &mut Silent);
    close("0.1 at speed 1 and 0.1 at speed 2", simulator.state()[0], 0.3, 1e-15);
}

#[test]
fn a_recorder_and_a_silent_watch_see_the_same_motion() {
    let mut watched = Ball::dropped(0.8, 1.0, Limits::default());
    let mut alone = watched;
    let mut recorder = RunRecorder::new(1e-3);
    for _ in 0..2000 {
        let with = watched.advance(1e-3, &no_input, &mut recorder);
        assert_eq!(with, alone.advance(1e-3, &no_input, &mut Silent));
    }
}
