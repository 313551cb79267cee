//! Assembled programs, run through the simulator, against closed forms.

use equations::ModeNumber;
use pode::stepper::Rk4;
use pode::{Auditor, Energetic as _, EquationKind, Limits, Model as _, Motion, Part, Simulator};

use crate::by_hand::pendulum;
use crate::runnable::{BALL, Runnable, runnable};

const STILL: fn(f64) -> Motion = |_| Motion::default();

#[test]
fn a_pendulum_swings_with_its_period_and_keeps_its_energy() {
    let described: Runnable<2> = runnable(pendulum::program(), &[]);
    let mode = ModeNumber(0);
    let energy = described.energy(mode, &[1.0, 0.0], &STILL(0.0));
    let mut simulator = Simulator::new(described, Rk4, Limits::default(), mode, [1.0, 0.0]);
    // T = 2π √(l/g)/AGM(1, cos θ0/2).
    let (mut a, mut b) = (1.0_f64, 0.5_f64.cos());
    for _ in 0..6 {
        (a, b) = (f64::midpoint(a, b), (a * b).sqrt());
    }
    let period = std::f64::consts::TAU * (0.5_f64 / 9.81).sqrt() / a;
    let mut audit: Auditor<Runnable<2>> = Auditor::default();
    assert!(simulator.run(period, period / 2048.0, STILL, &mut audit).is_completed());
    let [angle, rate] = *simulator.state();
    assert!((angle - 1.0).abs() < 1e-11 && rate.abs() < 1e-10, "{angle} {rate}");
    let left = simulator.model().energy(mode, simulator.state(), &STILL(0.0));
    assert!((left - energy).abs() < 1e-11);
    assert!(audit.sums.integration.abs() < 1e-11, "{:e}", audit.sums.integration);
}

#[test]
fn natures_follow_from_the_parameters() {
    let swing = ModeNumber(0);
    let free: Runnable<2> = runnable(pendulum::program(), &[]);
    let nature = free.nature(swing);
    assert_eq!(nature.kind, EquationKind::Conservative, "nothing is lost without a damper");
    let rate = (9.81_f64 / 0.5).sqrt();
    assert!((nature.rate - rate).abs() < 1e-9 * rate, "{}", nature.rate);
    assert!((free.longest_step(swing) - 0.75 / rate).abs() < 1e-9);
    let damped: Runnable<2> = runnable(pendulum::program(), &[9.81, 0.5, 0.1]);
    assert_eq!(damped.nature(swing).kind, EquationKind::Smooth);
    let (_, [angle, rate]) = free.at_rest(&STILL(0.0));
    assert!(angle.abs() < 1e-30 && rate == 0.0, "it hangs: {angle:e} {rate}");
    let flying = BALL.model::<4>("default", 0, &[]);
    assert_eq!(flying.nature(ModeNumber(0)).kind, EquationKind::Affine);
    assert_eq!(flying.parts(ModeNumber(0)), [Part::WHOLE.of_state()]);
    assert_eq!(flying.parts(ModeNumber(1)), []);
}
