//! Case C2: touches, and dips that are hardly deeper.
//!
//! Error model: the gap is a function of the time, known to rounding; a root is met with the slope
//! 20 √d and located to 2⁻⁴⁰ of the tick, far below that.

use pode::stepper::Rk4;
use pode::{Limits, Motion, Simulator};

use crate::common::{ON_CROSSING, ONE, Threshold, all_completed, close, each_step_and_phase};
use crate::driven::run_driven;

fn closes(at: (f64, f64), until: f64, gap: impl Fn(f64) -> [f64; 2]) -> Option<f64> {
    // A body at rest at 0 over a platform that moves: the gap is the platform's distance below.
    let [a, b] = [&ONE, &ON_CROSSING].map(|guards| {
        let platform = Threshold { guards, level: 0.0 };
        let mut it = Simulator::new(platform, Rk4, Limits::default(), true, [0.0]);
        let (recorder, ticks) = run_driven(&mut it, at, until, |t| {
            let [gap, rate] = gap(t);
            Motion { position: -gap, rate: -rate, ..Motion::default() }
        });
        all_completed(&ticks);
        recorder.events().first().map(|seen| seen.t)
    });
    assert_eq!(a.map(f64::to_bits), b.map(f64::to_bits), "at {at:?}");
    a
}

#[track_caller]
fn check(what: &str, gap: impl Fn(f64) -> [f64; 2], expected: Option<f64>, tolerance: f64) {
    check_until(what, 0.25, gap, expected, tolerance);
}

#[track_caller]
fn check_until(
    what: &str,
    until: f64,
    gap: impl Fn(f64) -> [f64; 2],
    expected: Option<f64>,
    tolerance: f64,
) {
    each_step_and_phase(|h, phase| {
        let found = closes((h, phase), until, &gap);
        assert_eq!(found.is_some(), expected.is_some(), "{what}, h {h}, phase {phase}: {found:?}");
        for (found, expected) in found.into_iter().zip(expected) {
            close(format_args!("{what}, h {h}, phase {phase}"), found, expected, tolerance);
        }
    });
}

const TOUCH: f64 = 0.123_456_789;

#[test]
fn c2_a_platform_that_grazes() {
    for (d, root) in [
        (-1e-2, None),
        (-1e-10, None),
        (0.0, None),
        (1e-4, Some(0.113_456_789)),
        (1e-6, Some(0.122_456_789)),
        (1e-8, Some(0.123_356_789)),
        (1e-10, Some(0.123_446_789)),
    ] {
        let gap = |t: f64| [10.0 * ((t - TOUCH) * (t - TOUCH) - d), 20.0 * (t - TOUCH)];
        check(&format!("d {d:e}"), gap, root, 2e-16);
    }
}

#[test]
fn a_dip_is_found_down_to_rounding() {
    for n in 3..14 {
        let d = 10.0_f64.powi(-n);
        for curvature in [0.1, 10.0, 1e3, 1e5] {
            let gap =
                |t: f64| [curvature * ((t - TOUCH).powi(2) - d), 2.0 * curvature * (t - TOUCH)];
            // A dip of less than 16 ε is none, and one of a few times that may be none.
            let depth = curvature * d;
            if depth > 1e-14 {
                check(&format!("d {d:e}, {curvature}"), gap, Some(TOUCH - d.sqrt()), 1e-15);
            }
        }
    }
}

#[test]
fn a_swinging_platform_grazes_as_precisely() {
    // gap = A (1 − d − cos ω(t − t*)), with ωh up to 0.7: its cubic misses the dip.
    for omega in [5.0, 20.0, 60.0, 100.0] {
        for d in [-1e-12_f64, 1e-3, 1e-6, 1e-9, 1e-12] {
            let gap = |t: f64| {
                let half = (0.5 * omega * (t - TOUCH)).sin();
                [2.0 * half * half - d, omega * (omega * (t - TOUCH)).sin()]
            };
            let half = 2.0 * (0.5 * d.max(0.0)).sqrt().asin() / omega;
            let root = (d > 0.0).then(|| (TOUCH - half).rem_euclid(std::f64::consts::TAU / omega));
            let until = TOUCH + 0.5 * std::f64::consts::PI / omega;
            // Rounding of the gap, 1e-16, over its slope, ω √(2d).
            let tolerance = 1e-15 + 1e-15 / (omega * (2.0 * d).sqrt());
            check_until(&format!("ω {omega}, d {d:e}"), until, gap, root, tolerance);
        }
    }
}

#[test]
fn a_touch_of_higher_order_is_none() {
    for power in [2, 4, 6] {
        let gap =
            |t: f64| [(t - TOUCH).powi(power), f64::from(power) * (t - TOUCH).powi(power - 1)];
        check(&format!("power {power}"), gap, None, 0.0);
    }
}

#[test]
fn a_gap_that_closes_flatly_closes_where_rounding_lets_it_be_seen() {
    for power in [3, 5] {
        let gap =
            |t: f64| [-(t - TOUCH).powi(power), -f64::from(power) * (t - TOUCH).powi(power - 1)];
        // Positive, zero within rounding, negative: within the band's root of that power.
        let band = (16.0 * f64::EPSILON).powf(1.0 / f64::from(power));
        check(&format!("power {power}"), gap, Some(TOUCH), band);
    }
}
