//! Whatever the guards do, a tick ends within its declared maxima, with a finite state.

#![allow(clippy::disallowed_macros, reason = "a test may use the heap")]

mod common;

use common::{Ball, ONE, Timed, count};
use pode::stepper::{Rk4, Stepper as _};
use pode::{
    Advance, Cap, GuardId, GuardSpec, GuardValue, Guarded, Limits, Model, Reset, Resets, Settling,
    Silent, Simulator, Tick, Work,
};
use proptest::prelude::*;

/// A guard made to be difficult, as a function of the time.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Trouble {
    /// Jumps between −1 and 1 at this frequency [1/s].
    Chatters(f64),
    /// Always zero.
    Zero,
    /// −0.0, with a rate that lies.
    NegativeZero(f64),
    /// Falls by a jump at this time [s].
    Jumps(f64),
    /// Not a number from this time [s] on.
    NotANumber(f64),
    /// Many roots: cos ωt.
    Waves(f64),
    /// Flat roots: −(t − t0)⁹, with rate zero.
    Flat(f64),
    /// Steep roots: a square root with a sign.
    Steep(f64),
    /// Changes with each reset.
    Counts(f64),
    /// Beyond the largest number.
    Huge(f64),
}

impl Trouble {
    fn value(self, x: &[f64; 3]) -> GuardValue {
        let t = x[0];
        let (value, rate) = match self {
            Self::Chatters(f) => (if (t * f).fract() < 0.5 { 1.0 } else { -1.0 }, 0.0),
            Self::Zero => (0.0, 0.0),
            Self::NegativeZero(rate) => (-0.0, rate),
            Self::Jumps(t0) => (if t < t0 { 1.0 } else { -1.0 }, 0.0),
            Self::NotANumber(t0) => (if t < t0 { 1.0 } else { f64::NAN }, -1.0),
            Self::Waves(w) => ((w * t).cos(), -w * (w * t).sin()),
            Self::Flat(t0) => (-(t - t0).powi(9), 0.0),
            Self::Steep(t0) => ((t0 - t).abs().sqrt().copysign(t0 - t), -1e300),
            Self::Counts(w) => ((w * t + x[1]).sin(), w),
            Self::Huge(t0) => (f64::MAX * (t0 - t), f64::MIN),
        };
        GuardValue::new(value, rate)
    }
}

/// What a guard's reset map does.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Effect {
    Nothing,
    Counts,
    OtherMode,
    GoesBack,
    Settles,
    NotANumber,
}

const TROUBLES: usize = 4;

#[derive(Clone, Copy, Debug, PartialEq)]
struct Adversary {
    troubles: [Trouble; TROUBLES],
    effects: [Effect; TROUBLES],
    on_crossing: bool,
    longest_step: f64,
    /// Time from an impact to a Zeno sequence's end [s], and the ratio of its intervals.
    settling: [f64; 2],
}

impl Model for Adversary {
    type Mode = bool;
    type State = [f64; 3];
    type Input = ();
    const COORDS: usize = 1;

    fn derivative(&self, _: bool, x: &[f64; 3], (): &()) -> [f64; 3] {
        [1.0, 0.0, -x[2]]
    }

    fn readout(&self, _: bool, x: &[f64; 3], (): &()) -> f64 {
        x[2]
    }

    fn longest_step(&self, _: bool) -> f64 {
        self.longest_step
    }
}

impl Guarded for Adversary {
    fn guards(&self, _: bool) -> &'static [GuardSpec] {
        const WHILE: [GuardSpec; TROUBLES] = [
            GuardSpec::new(0, "a"),
            GuardSpec::new(1, "b"),
            GuardSpec::new(2, "c"),
            GuardSpec::new(3, "d"),
        ];
        const ON: [GuardSpec; TROUBLES] = [
            WHILE[0].on_crossing(),
            WHILE[1].on_crossing(),
            WHILE[2].on_crossing(),
            WHILE[3].on_crossing(),
        ];
        if self.on_crossing { &ON } else { &WHILE }
    }

    fn guard(&self, mode: bool, id: GuardId, x: &[f64; 3], (): &()) -> GuardValue {
        let it = self.troubles[usize::from(id.0)].value(x);
        if mode { it } else { GuardValue::new(-it.value, -it.rate) }
    }
}

impl Resets for Adversary {
    fn reset(&self, mode: bool, id: GuardId, x: &[f64; 3], (): &()) -> Reset<Self> {
        let [t, n, z] = *x;
        let [after, ratio] = self.settling;
        match self.effects[usize::from(id.0)] {
            Effect::Nothing => Reset::to(mode, *x),
            Effect::Counts => Reset::to(mode, [t, n + 1.0, z + 1.0]).with_impulse(1.0),
            Effect::OtherMode => Reset::to(!mode, *x),
            Effect::GoesBack => Reset::to(mode, [t - 1e-4, n, z]),
            Effect::Settles => {
                let settled = Settling { after, ratio, mode: !mode, state: *x, impulse: 1.0 };
                Reset::to(mode, *x).settling(settled)
            }
            Effect::NotANumber => Reset::to(mode, [t, f64::NAN, z]),
        }
    }
}

/// The most derivatives that `pieces` steps of RK4 take.
const DERIVATIVES: u32 = Rk4::EVALUATIONS;

#[track_caller]
fn check_within(tick: &Tick, limits: &Limits, x: &[f64; 3]) {
    let Work { pieces, derivatives, jacobians, guards, readouts, events, .. } = tick.work;
    let judged = tick.work.certified + tick.work.likely + tick.work.unknown;
    assert!(judged <= pieces, "{tick:?}");
    assert_eq!(jacobians, 0, "an explicit method needs none");
    assert!(pieces <= limits.pieces, "{tick:?}");
    assert!(derivatives <= DERIVATIVES * limits.pieces, "{tick:?}");
    assert!(guards <= limits.guards, "{tick:?}");
    assert!(events <= limits.events, "{tick:?}");
    assert!(readouts <= 3 * limits.pieces + 2 * limits.events, "{tick:?}");
    assert!(x.iter().all(|entry| entry.is_finite()), "{x:?} after {tick:?}");
}

fn trouble() -> impl Strategy<Value = Trouble> {
    prop_oneof![
        (1.0..1e6).prop_map(Trouble::Chatters),
        Just(Trouble::Zero),
        (-1e3..1e3).prop_map(Trouble::NegativeZero),
        (0.0..0.02).prop_map(Trouble::Jumps),
        (0.0..0.05).prop_map(Trouble::NotANumber),
        (1.0..1e7).prop_map(Trouble::Waves),
        (0.0..0.02).prop_map(Trouble::Flat),
        (0.0..0.02).prop_map(Trouble::Steep),
        (1.0..1e6).prop_map(Trouble::Counts),
        (0.0..0.02).prop_map(Trouble::Huge),
    ]
}

fn effect() -> impl Strategy<Value = Effect> {
    prop_oneof![
        Just(Effect::Nothing),
        Just(Effect::Counts),
        Just(Effect::OtherMode),
        Just(Effect::GoesBack),
        Just(Effect::Settles),
        Just(Effect::NotANumber),
    ]
}

/// Numbers of every kind that a careless model may declare.
fn odd(usual: std::ops::Range<f64>) -> impl Strategy<Value = f64> {
    prop_oneof![
        8 => usual,
        1 => prop_oneof![Just(0.0), Just(-1.0), Just(f64::NAN), Just(f64::INFINITY), Just(1e-300)],
    ]
}

prop_compose! {
    fn adversary()(
        troubles in prop::array::uniform4(trouble()),
        effects in prop::array::uniform4(effect()),
        on_crossing in any::<bool>(),
        longest_step in odd(1e-5..1e-2),
        after in odd(0.0..0.01),
        ratio in odd(0.0..1.0),
    ) -> Adversary {
        Adversary { troubles, effects, on_crossing, longest_step, settling: [after, ratio] }
    }
}

prop_compose! {
    fn limits()(
        events in 0_u32..20,
        cascade in 0_u32..6,
        followed in 0_u32..6,
        guards in 0_u32..600,
        pieces in 0_u32..40,
        longest_step in odd(1e-4..1.0),
        forecast in any::<bool>(),
        event_tolerance in odd(1e-15..0.1),
    ) -> Limits {
        Limits { events, cascade, followed, guards, pieces, longest_step, forecast, event_tolerance }
    }
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 2000, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn no_guard_can_exceed_the_limits(model in adversary(), limits in limits(), h in 1e-5..7e-3) {
        let mut simulator = Simulator::new(model, Rk4, limits, true, [0.0, 0.0, 1.0]);
        for _ in 0..8 {
            let tick = simulator.advance(h, &|_| (), &mut Silent);
            check_within(&tick, &limits, simulator.state());
        }
    }

    #[test]
    fn events_at_one_instant_never_exceed_the_cascade(model in adversary(), h in 1e-5..7e-3) {
        let limits = Limits::default();
        let mut simulator = Simulator::new(model, Rk4, limits, true, [0.0, 0.0, 1.0]);
        for _ in 0..8 {
            let mut instants = Instants::default();
            let _ = simulator.advance(h, &|_| (), &mut instants);
            prop_assert!(instants.most <= limits.cascade, "{} at one instant", instants.most);
        }
    }
}

/// Counts the guards that fire at one θ.
#[derive(Debug, Default)]
struct Instants {
    theta: Option<f64>,
    now: u32,
    most: u32,
}

impl<M: Model> pode::Watch<M> for Instants {
    fn event(&mut self, _: &M, event: &pode::Event<'_, M>) {
        if !matches!(event.cause, pode::Cause::Guard(_)) {
            return;
        }
        self.now = if self.theta == Some(event.theta) { self.now + 1 } else { 1 };
        self.theta = Some(event.theta);
        self.most = self.most.max(self.now);
    }
}

/// A guard that is negative again as soon as it has fired: each reset goes back 1/64 s.
fn comes_back() -> Timed {
    fn back(_: GuardId, x: &mut [f64; 3]) -> bool {
        x[0] -= 1.0 / 64.0;
        false
    }
    Timed { guards: &ONE, guard: |_, t| GuardValue::new(0.25 - t, -1.0), effect: back }
}

#[test]
fn a_tick_with_exactly_the_most_events_completes_and_one_more_is_capped() {
    // Comes to 0.25 and then, from t = 0 on, every 1/64 s: 49 times in a tick of 1 s.
    for (events, advance) in
        [(50, Advance::Completed), (49, Advance::Completed), (48, Advance::Capped(Cap::Events))]
    {
        let limits = Limits { events, ..Limits::default() };
        let mut simulator = Simulator::new(comes_back(), Rk4, limits, true, [0.0; 3]);
        let tick = simulator.advance(1.0, &|_| (), &mut Silent);
        assert_eq!((tick.advance, tick.work.events), (advance, events.min(49)));
    }
}

#[test]
fn a_tick_with_exactly_the_most_guards_completes_and_one_more_is_capped() {
    let far = Timed { guards: &ONE, guard: |_, _| GuardValue::new(1.0, 0.0), effect: count };
    for (guards, advance) in [(2, Advance::Completed), (1, Advance::Capped(Cap::Guards))] {
        let limits = Limits { guards, ..Limits::default() };
        let mut simulator = Simulator::new(far, Rk4, limits, true, [0.0; 3]);
        let tick = simulator.advance(1e-3, &|_| (), &mut Silent);
        // Once at the very start, and at the end of the step.
        assert_eq!((tick.advance, tick.work.guards), (advance, guards));
    }
}

#[test]
fn a_tick_with_exactly_the_most_pieces_completes_and_one_more_is_capped() {
    let far = Timed { guards: &ONE, guard: |_, _| GuardValue::new(1.0, 0.0), effect: count };
    for (pieces, advance) in [(10, Advance::Completed), (9, Advance::Capped(Cap::Pieces))] {
        let limits = Limits { pieces, longest_step: 1e-4, ..Limits::default() };
        let mut simulator = Simulator::new(far, Rk4, limits, true, [0.0; 3]);
        let tick = simulator.advance(1e-3, &|_| (), &mut Silent);
        assert_eq!((tick.advance, tick.work.pieces), (advance, pieces));
    }
}

#[test]
fn a_jump_of_a_guard_is_one_event() {
    for h in common::STEPS {
        let guard = |_: GuardId, t: f64| GuardValue::new(if t < 0.1 { 1.0 } else { -1.0 }, 0.0);
        let mut timed = Timed { guards: &ONE, guard, effect: count }.start();
        let (recorder, ticks) = common::run(&mut timed, h, 0.0, 0.2);
        common::all_completed(&ticks);
        assert_eq!(recorder.seen.len(), 1, "h {h}: {:?}", recorder.times());
        common::close("the jump", recorder.seen[0].t, 0.1, 1e-12 * h + 2e-14);
    }
}

#[test]
fn work_of_typical_ticks() {
    let mut ball = Ball::dropped(0.8, 1.0, Limits::default());
    let mut works = [Work::default(); 600];
    for work in &mut works {
        *work = ball.advance(1e-3, &|_| (), &mut Silent).work;
    }
    let tick = |pieces, derivatives, guards, readouts, events| Work {
        pieces,
        derivatives,
        guards,
        readouts,
        events,
        likely: pieces,
        ..Work::default()
    };
    // The first tick takes the guards; then a look at the end of each.
    assert_eq!(works[0], tick(1, 4, 2, 3, 0), "first tick");
    assert_eq!(works[1], tick(1, 4, 1, 3, 0), "no event");
    // The end of the step, two looks that locate the impact, one after it, and the end again.
    assert_eq!(works[451], tick(2, 8, 5, 6, 1), "one event");
    assert_eq!(works[452], works[1], "after it");
    let events: u32 = works.iter().map(|work| work.events).sum();
    assert_eq!(events, 1);
}
