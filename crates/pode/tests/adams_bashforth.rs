//! The Adams–Bashforth methods: steps of any length, and no memory across an event.

use pode::stepper::{AdamsBashforth2, AdamsBashforth3, Field, Memory};
use pode::{Advance, Dense as _, GuardValue, State, Step, Stepper};

use crate::common::{ONE, OneMode, no_input};
use crate::known::{PENDULUM, check_order, exact, global_error, largest_inside, step};

#[test]
fn steps_of_any_length_keep_the_order_and_that_of_the_dense_output() {
    fn check<T: Stepper>() {
        // Up to four times as long as the step before is still a multistep step.
        for parts in [[0.5, 0.5], [0.75, 0.25], [0.78, 0.22]] {
            let error = |h: f64| global_error::<T>(PENDULUM, &parts, h);
            check_order(T::NAME, f64::from(T::ORDER), error, 1.0 / 64.0);
        }
        let own = |h: f64| {
            let (mut memory, mut t) = (T::Memory::default(), 0.3);
            for part in [1.0, 0.7] {
                step::<T>(PENDULUM, (t, &exact(t)), &mut memory, part * h);
                t += part * h;
            }
            largest_inside(&step::<T>(PENDULUM, (t, &exact(t)), &mut memory, h), t, h)
        };
        check_order(T::NAME, f64::from(T::ORDER) + 1.0, own, 1.0 / 32.0);
    }
    check::<AdamsBashforth2>();
    check::<AdamsBashforth3>();
}

#[test]
fn the_next_step_is_a_first_one_after_a_restart_and_after_a_crumb() {
    fn check<T: Stepper>() {
        let ends = |before: &[f64], restarts: bool| {
            let mut memory = T::Memory::default();
            for h in before {
                // Memory from elsewhere would show in the next step.
                step::<T>(PENDULUM, (0.0, &[0.3, 0.2]), &mut memory, *h);
            }
            if restarts {
                memory.restart();
            }
            step::<T>(PENDULUM, (0.3, &exact(0.3)), &mut memory, 0.1).end().map(f64::to_bits)
        };
        let anew = ends(&[], false);
        assert_eq!(ends(&[0.1, 0.1], true), anew, "{}", T::NAME);
        assert_eq!(ends(&[0.1, 1e-12], false), anew, "{}", T::NAME);
        assert_ne!(ends(&[0.1, 0.1], false), anew, "{}", T::NAME);
    }
    check::<AdamsBashforth2>();
    check::<AdamsBashforth3>();
}

const WALL: f64 = 0.3;

/// x'' = −x above an elastic wall.
fn rebound() -> OneMode<(), 2> {
    OneMode {
        guards: &ONE,
        guard: |(), _, x| GuardValue::new(x[0] - WALL, x[1]),
        reset: |(), _, x| [WALL, -x[1]],
        ..OneMode::new((), |(), x| [x[1], -x[0]])
    }
}

fn rebound_error<T: Stepper>(steps: i32) -> f64 {
    // From the top to the wall, and three times up and down again.
    let exact = 7.0 * WALL.acos();
    let h = exact / f64::from(steps);
    let mut simulator = rebound().start(T::default(), [1.0, 0.0]);
    let mut recorder = pode::RunRecorder::new(h);
    while recorder.events().len() < 4 {
        assert_eq!(simulator.advance(h, &no_input, &mut recorder).advance, Advance::Completed);
    }
    (recorder.events()[3].t - exact).abs()
}

#[derive(Clone, Copy, Debug, Default, PartialEq)]
struct Stale<T>(T);

#[derive(Clone, Copy, Debug, Default, PartialEq)]
struct Kept<M>(M);

impl<M: Memory> Memory for Kept<M> {}

impl<T: Stepper> Stepper for Stale<T> {
    const ORDER: u32 = T::ORDER;
    const EVALUATIONS: u32 = T::EVALUATIONS;
    const NAME: &'static str = T::NAME;

    type Memory<S: State> = Kept<T::Memory<S>>;
    type Dense<S: State> = T::Dense<S>;

    fn step<S: State>(
        &self,
        field: &mut impl Field<S>,
        x0: &S,
        memory: &mut Self::Memory<S>,
        h: f64,
    ) -> Step<S, T::Dense<S>> {
        self.0.step(field, x0, &mut memory.0, h)
    }
}

#[test]
fn the_order_is_kept_across_events_by_starting_anew() {
    fn check<T: Stepper>() {
        let sum = |error: fn(i32) -> f64, m| (200..240).map(|n| error(m * n)).sum::<f64>();
        let observed = |error| (sum(error, 1) / sum(error, 2)).log2();
        let (kept, stale) = (observed(rebound_error::<T>), observed(rebound_error::<Stale<T>>));
        assert!((kept - f64::from(T::ORDER)).abs() < 0.2, "{}: observed order {kept:.3}", T::NAME);
        assert!(stale < 1.4, "{}: observed order {stale:.3} with a stale memory", T::NAME);
    }
    check::<AdamsBashforth2>();
    check::<AdamsBashforth3>();
}
