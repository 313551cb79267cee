use super::hand::LINE;
use super::*;

fn experiment() -> Figure6 {
    figure6(Pace::PAPER).unwrap()
}

/// Lever of the finger (m): 3 inches for 45°.
const LEVER: f64 = 76.2e-3 / core::f64::consts::FRAC_PI_4;

/// Asserts the story of the paper's text: held still for 0.3 s, thrown, free, caught near 0.9 s,
/// thrown harder, on the string, landed near 1.5 s, bounced.
#[track_caller]
fn check_story(it: &ClosedLoop, bounces: usize) {
    let still = it.rig.iter().zip(&it.paper.rows).take_while(|(_, row)| row.t <= 0.3);
    assert!(still.clone().count() > 140);
    for (rig, row) in still {
        assert!(rig.angle.abs() < 0.5 * LINE / LEVER && row.s == 0.0, "{rig:?}");
    }
    let seen: Vec<_> = it.paper.events.iter().map(|event| (event.guard, event.t)).collect();
    let guards: Vec<_> = seen.iter().map(|it| it.0).collect();
    assert_eq!(guards[..5], ["release", "land", "release", "string", "land"], "{seen:?}");
    assert!((0.3..0.8).contains(&seen[0].1), "{seen:?}");
    assert!((seen[1].1 - 0.9).abs() < 0.02, "{seen:?}");
    assert!((seen[4].1 - 1.5).abs() < 0.04, "{seen:?}");
    let landed = guards[5..].iter().filter(|guard| **guard == "land").count();
    assert!(landed >= bounces, "{seen:?}");
    let high = |from: f64, to: f64| {
        let rows = it.paper.rows.iter().filter(|row| (from..to).contains(&row.t));
        rows.map(|row| row.hammer).fold(f64::NEG_INFINITY, f64::max)
    };
    assert!(high(0.6, 0.9) < 0.1 && high(1.2, 1.5) > 0.398);
}

#[test]
fn both_readings_tell_the_papers_story() {
    let figure = experiment();
    check_story(&figure.slow_motion, 3);
    check_story(&figure.real_time, 2);
}

#[test]
fn the_model_is_given_whole_lines_once_a_step_and_the_hand_pulls_too() {
    for it in [experiment().slow_motion, experiment().real_time] {
        assert_eq!((it.paper.rows.len(), it.rig.len()), (1501, 1501));
        for (row, rig) in it.paper.rows.iter().skip(1).zip(&it.rig) {
            let lines = row.s * LEVER / LINE;
            assert!((lines - lines.round()).abs() < 1e-9, "{lines} lines");
            // The sample is the position at the step's start, to half a line.
            let error = (row.s - rig.angle) * LEVER;
            assert!(error.abs() < (0.5 + 1e-9) * LINE, "{error} m");
        }
        for event in &it.paper.events {
            let steps = event.t / STEP;
            assert!((steps - steps.round()).abs() < 1e-9, "{event:?}");
        }
        let hands = || it.rig.iter().map(|rig| rig.hand);
        assert!(hands().any(|force| force > 5.0) && hands().any(|force| force < -5.0));
    }
}

#[test]
fn the_force_rises_by_a_line_of_the_encoder_at_a_time() {
    // At rest: 6.2 N·m/rad times a line, both at the lever.
    let it = experiment().slow_motion;
    let jump = it.paper.rows.windows(2).map(|pair| (pair[1].f_ku - pair[0].f_ku).abs());
    let expected = 6.2 * LINE / (LEVER * LEVER);
    let largest = jump.take(200).fold(0.0, f64::max);
    assert!((largest - expected).abs() < 0.01 * expected, "{largest} N, expected {expected} N");
}

#[test]
fn the_same_samples_with_located_events_are_within_two_steps_of_the_papers() {
    let it = experiment().slow_motion;
    assert_eq!(it.located.events.len(), it.paper.events.len());
    for (located, paper) in it.located.events.iter().zip(&it.paper.events) {
        assert!(located.guard == paper.guard && (located.t - paper.t).abs() < 2.0 * STEP);
    }
    assert!(it.paper.made > 1e3 * it.located.made, "{} J", it.paper.made);
}

#[test]
fn errors_are_those_that_an_independent_study_stated() {
    let figure = experiment();
    let stated = [
        // "Up to 7 ms", half a step, and the figures of extrapolation and of the true input.
        (StepKind::Paper, 7e-3, 0.5e-3),
        (StepKind::Held, 0.5 * STEP, 0.05e-3),
        (StepKind::Linear, 3.1e-4, 0.05e-4),
        (StepKind::Quadratic, 4.8e-6, 0.05e-6),
        (StepKind::Exact, 7.8e-8, 0.05e-8),
    ];
    for (it, (kind, error, digits)) in figure.errors.iter().zip(stated) {
        assert_eq!((it.kind, it.is_whole, it.events.len()), (kind, true, 12));
        assert!((it.event_largest - error).abs() < digits, "{kind:?}: {} s", it.event_largest);
    }
    let pairs = || figure.errors.windows(2);
    assert!(pairs().all(|it| it[1].force_largest < it[0].force_largest));
    assert!(pairs().all(|it| it[1].energy_largest < it[0].energy_largest));
    let [paper, located @ ..] = figure.errors.as_slice() else { panic!("no errors") };
    assert!(located.iter().all(|it| it.energy_made < 1e-3 * paper.energy_made));
}

/// Derivative of model B of the `paper` set, written out, with `k2` (N/m) between the two.
fn derivative(k2: f64, [h, k, hh, kk]: [f64; 4], s: f64) -> [f64; 4] {
    let d = k - h;
    let q4 = (0.4 * d.sin() - 0.05 * h.cos() + 0.1 * h.sin()) / d.cos();
    let q3 = (0.4 - 0.1 * k.cos() - 0.05 * k.sin()) / d.cos();
    let spring = k2 * q4;
    let hammer = -0.01 * 9.81 * h.cos() + spring * q3 / d.cos();
    let key = 6.2 * (s - k) - 6.5 * 9.81 * 0.002 * k.cos() - spring * (0.4 + q4 * d.tan());
    [hh, kk, hammer / 0.01, key / 0.01625]
}

#[test]
fn the_sampled_step_is_that_of_a_loop_written_from_the_equations() {
    let figure = experiment();
    let it = &figure.slow_motion.paper;
    let add = |x: [f64; 4], h: f64, k: [f64; 4]| core::array::from_fn(|i| x[i] + h * k[i]);
    // At rest, from the independent program.
    let mut x = [-0.278_754_077_512_648_9, -0.039_795_659_751_103_18, 0.0, 0.0];
    let (mut together, mut switches) = (true, Vec::new());
    for row in &it.rows[1..] {
        let k2 = if together { 15.0 } else { 0.0 };
        let f = |x| derivative(k2, x, row.s);
        let before = x[0];
        let k1 = f(x);
        let k2 = f(add(x, 0.5 * STEP, k1));
        let k3 = f(add(x, 0.5 * STEP, k2));
        let k4 = f(add(x, STEP, k3));
        let sum: [f64; 4] = core::array::from_fn(|i| k1[i] + 2.0 * (k2[i] + k3[i]) + k4[i]);
        x = add(x, STEP / 6.0, sum);
        let gap = 0.05 * x[0].cos() - 0.1 * x[0].sin() - 0.4 * (x[1] - x[0]).sin();
        if together == (gap > 0.0) {
            together = !together;
            switches.push(row.t);
        } else if before < 0.398 && x[0] > 0.398 {
            x[2] = -x[2];
        }
        // The start is right to 1e-16, and rounding grows by a hundred over bounces.
        assert!((x[0] - row.hammer).abs() + (x[1] - row.key).abs() < 1e-10, "at {} s", row.t);
        assert!((6.2 * (row.s - x[1]) / LEVER - row.f_ku).abs() < 1e-8);
    }
    let events = it.events.iter().filter(|event| event.guard != "string");
    assert_eq!(switches, events.map(|event| event.t).collect::<Vec<_>>());
}

#[test]
fn only_a_pace_that_the_rig_can_follow_is_one() {
    assert!(Pace::of(1.0).is_some() && Pace::of(STEP / SERVO) == Some(Pace::PAPER));
    for wrong in [0.0, 0.09, 1.01, -1.0, f64::NAN, f64::INFINITY] {
        assert_eq!(Pace::of(wrong), None, "{wrong}");
    }
    assert!((Pace::PAPER.servo() - 7e-3).abs() < 1e-15);
}

#[test]
fn the_picture_names_its_switches_and_curves() {
    let figure = experiment();
    let svg = picture::picture("the title", &figure.slow_motion.paper, figure.string).svg();
    let words = ["the title", "t₁", "t₁₁", "F_KU", "hammer θh", "gap [mm]", "B1", "B2", "string"];
    for word in words {
        assert!(svg.contains(word), "{word}");
    }
    assert!(!svg.contains("NaN") && !svg.contains("inf"), "a place is no number");
}
