//! The search in its short form, and its ability to fail.

use pode::stepper::Rk4;
use pode::{Limits, Motion, Silent, Simulator, Work};

use super::system::OscillatorSystem;
use super::*;

fn tried(bound_factor: f64) -> CertificateReport {
    let choice = CertificateChoice { seed: 1, first: 0, systems: 200, bound_factor };
    try_certificates(&choice)
}

#[test]
fn no_certain_step_hides_a_guard_that_was_negative() {
    let report = tried(1.0);
    assert_eq!(report.violations, 0, "{:#?}", report.described);
    assert!(report.certain > 500 && report.unknown > 500 && report.events > 100, "{report:?}");
}

#[test]
fn bounds_that_are_too_low_are_caught() {
    let report = tried(0.05);
    assert!(report.violations > 0, "{report:?}");
    assert!(!report.described.is_empty());
}

fn fast_wave(bound_factor: f64) -> (Work, f64) {
    let model = OscillatorSystem::fast_wave(bound_factor);
    let limits = Limits { pieces: 1, ..Limits::default() };
    let mut simulator = Simulator::new(model, Rk4, limits, (), model.start());
    let still = |_theta: f64| Motion::default();
    let work = simulator.advance(0.05, &still, &mut Silent).work;
    (work, simulator.state()[0])
}

#[test]
fn a_guard_faster_than_the_declared_rate_is_found_where_its_bound_is_right() {
    let (work, x) = fast_wave(1.0);
    assert_eq!((work.certain, work.unknown), (1, 0), "{work:?}");
    // The event resets the state to its start, or leaves it at the first root.
    let root = 0.999_f64.asin() / 200.0;
    assert!(work.events == 1 && (x == 0.0 || (x - root).abs() < 1e-12), "{work:?} {x}");
}

#[test]
fn a_guard_that_moves_more_than_its_bound_is_doubted() {
    // Over the tick the guard moves by 0.54; 0.15 of its right bound is 0.3.
    let (work, _) = fast_wave(0.15);
    assert_eq!((work.certain, work.unknown), (0, 1), "{work:?}");
}
