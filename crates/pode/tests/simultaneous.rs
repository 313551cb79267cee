//! Case C4: several guards at one instant, and one on a tick's boundary.

use pode::{GuardId, GuardSpec, GuardValue, RunRecorder};

use crate::common::{
    ON_CROSSING, ONE, STEPS, Timed, all_completed, close, count, count_and_flip,
    each_step_and_phase, no_input, run,
};

const TWICE: [GuardSpec; 2] = [GuardSpec::new(0, "a"), GuardSpec::new(1, "b")];

fn falls_at_0_3(_: GuardId, t: f64) -> GuardValue {
    GuardValue::new(0.3 - t, -1.0)
}

#[test]
fn identical_guards_have_one_effect_each() {
    const ON_CROSSING: [GuardSpec; 2] = [TWICE[0].on_crossing(), TWICE[1].on_crossing()];
    for guards in [&TWICE, &ON_CROSSING] {
        each_step_and_phase(|h, phase| {
            let mut timed = Timed { guards, guard: falls_at_0_3, effect: count }.start();
            let (recorder, ticks) = run(&mut timed, h, phase, 0.5);
            all_completed(&ticks);
            let names: Vec<_> = recorder.events().iter().map(|seen| seen.name).collect();
            assert_eq!(names, ["a", "b"], "h {h}, phase {phase}");
        });
    }
}

#[test]
fn an_effect_that_cures_the_other_guard_is_the_only_one() {
    each_step_and_phase(|h, phase| {
        let timed = Timed { guards: &TWICE, guard: falls_at_0_3, effect: count_and_flip };
        let (recorder, _) = run(&mut timed.start(), h, phase, 0.5);
        assert_eq!(recorder.events().len(), 1, "h {h}, phase {phase}");
    });
}

fn shapes(id: GuardId, t: f64) -> GuardValue {
    let left = 0.3 - t;
    match id.0 {
        0 => GuardValue::new(left, -1.0),
        _ => GuardValue::new(left * (2.0 + t * t), -(2.0 + t * t) + 2.0 * t * left),
    }
}

fn double_or_add(id: GuardId, x: &mut [f64; 3]) -> bool {
    x[1] = if id.0 == 0 { 2.0 * x[1] } else { x[1] + 1.0 };
    false
}

#[test]
fn resets_that_do_not_commute_go_by_priority() {
    const DOUBLE: GuardSpec = GuardSpec::new(0, "double");
    const ADD: GuardSpec = GuardSpec::new(1, "add");
    const LATE: GuardSpec = DOUBLE.with_priority(9);
    static DOUBLE_FIRST: [[GuardSpec; 2]; 2] = [[DOUBLE, ADD], [ADD, DOUBLE]];
    static ADD_FIRST: [[GuardSpec; 2]; 2] = [[LATE, ADD], [ADD, LATE]];
    let check = |guards: &'static [GuardSpec], expected: f64| {
        each_step_and_phase(|h, phase| {
            let mut timed = Timed { guards, guard: shapes, effect: double_or_add }.start();
            let (recorder, _) = run(&mut timed, h, phase, 0.5);
            assert_eq!(recorder.events().len(), 2, "h {h}, phase {phase}");
            close(format_args!("h {h}, phase {phase}"), timed.state()[1], expected, 0.0);
        });
    };
    // From 0: double, then add is 1; add, then double is 2.
    for (double_first, add_first) in DOUBLE_FIRST.iter().zip(&ADD_FIRST) {
        check(double_first, 1.0);
        check(add_first, 2.0);
    }
}

#[test]
fn an_event_on_a_tick_boundary_happens_once() {
    for guards in [&ONE, &ON_CROSSING] {
        let falls = |_: GuardId, t: f64| GuardValue::new(0.5 - t, -1.0);
        let mut timed = Timed { guards, guard: falls, effect: count }.start();
        let (recorder, ticks) = run(&mut timed, 0.25, 0.0, 1.0);
        all_completed(&ticks);
        assert_eq!(recorder.times(), [0.5]);
    }
}

#[test]
fn a_boundary_that_rounding_has_moved_still_gives_one_event() {
    // 0.3 is a multiple of no step in binary; at 300 steps the sum is off by some ulps.
    for h in STEPS {
        let mut timed = Timed { guards: &ONE, guard: falls_at_0_3, effect: count }.start();
        let mut recorder = RunRecorder::new(h);
        for _ in 0..5000 {
            let _ = timed.advance(h, &no_input, &mut recorder);
        }
        assert_eq!(recorder.events().len(), 1, "h {h}");
    }
}
