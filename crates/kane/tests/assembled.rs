//! Assembled programs, run through the simulator, against closed forms.
#![expect(clippy::float_cmp, reason = "a test fails aloud, and bits are what is compared")]

use equations::ModeNumber;
use pode::stepper::Rk4;
use pode::{
    Auditor, Energetic as _, EquationKind, Limits, Model as _, Motion, Part, RunRecorder, Simulator,
};

use crate::by_hand::{Described, ball, model, pendulum};

const STILL: fn(f64) -> Motion = |_| Motion::default();

#[test]
fn a_ball_bounces_at_the_times_of_the_closed_form_and_comes_to_rest() {
    let described: Described<2> = model(ball::program(), &[]);
    let (mode, x) = described.at_rest(&Motion::default());
    assert_eq!((mode, x), (ModeNumber(0), [1.0, 0.0]));
    let mut simulator = Simulator::new(described, Rk4, Limits::default(), mode, x);
    let mut recorder = RunRecorder::new(1e-3);
    assert!(simulator.run(5.0, 1e-3, STILL, &mut recorder).is_completed());
    let first = (2.0_f64 / 9.81).sqrt();
    let impact = |n: i32| first * (1.0 + 2.0 * (1..=n).map(|k| 0.8_f64.powi(k)).sum::<f64>());
    let floor = recorder.times_of("floor");
    assert!(floor.len() > 5, "{floor:?}");
    for (n, t) in (0..).zip(floor.iter().take(6)) {
        assert!((t - impact(n)).abs() < 1e-12, "impact {n} at {t}, not {}", impact(n));
    }
    // 2 e/(1 − e) = 8: the rest begins after nine times the first fall.
    let rest = recorder.events().iter().find(|event| event.to == ModeNumber(1)).unwrap();
    assert!((rest.t - 9.0 * first).abs() < 1e-9, "rest at {}, not {}", rest.t, 9.0 * first);
    assert_eq!(simulator.mode(), ModeNumber(1));
    assert_eq!(simulator.state(), &[0.0, 0.0]);
    assert!(
        (simulator.model().readout(ModeNumber(1), simulator.state(), &STILL(0.0)) - 9.81).abs()
            < 1e-15
    );
    // m √(2 g h) (1 + e)/(1 − e) of all impacts together.
    let impulse = (2.0_f64 * 9.81).sqrt() * 1.8 / 0.2;
    assert!((recorder.impulse() - impulse).abs() < 1e-9 * impulse, "{}", recorder.impulse());
}

#[test]
fn a_pendulum_swings_with_its_period_and_keeps_its_energy() {
    let described: Described<2> = model(pendulum::program(), &[]);
    let mode = ModeNumber(0);
    let energy = described.energy(mode, &[1.0, 0.0], &STILL(0.0));
    let mut simulator = Simulator::new(described, Rk4, Limits::default(), mode, [1.0, 0.0]);
    // T = 2π √(l/g)/AGM(1, cos θ0/2).
    let (mut a, mut b) = (1.0_f64, 0.5_f64.cos());
    for _ in 0..6 {
        (a, b) = (f64::midpoint(a, b), (a * b).sqrt());
    }
    let period = std::f64::consts::TAU * (0.5_f64 / 9.81).sqrt() / a;
    let mut audit: Auditor<Described<2>> = Auditor::default();
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
    let free: Described<2> = model(pendulum::program(), &[]);
    let nature = free.nature(swing);
    assert_eq!(nature.kind, EquationKind::Conservative, "nothing is lost without a damper");
    let rate = (9.81_f64 / 0.5).sqrt();
    assert!((nature.rate - rate).abs() < 1e-9 * rate, "{}", nature.rate);
    assert!((free.longest_step(swing) - 0.75 / rate).abs() < 1e-9);
    let damped: Described<2> = model(pendulum::program(), &[9.81, 0.5, 0.1]);
    assert_eq!(damped.nature(swing).kind, EquationKind::Smooth);
    let (_, [angle, rate]) = free.at_rest(&STILL(0.0));
    assert!(angle.abs() < 1e-30 && rate == 0.0, "it hangs: {angle:e} {rate}");
    let flying: Described<4> = model(ball::program(), &[]);
    assert_eq!(flying.nature(ModeNumber(0)).kind, EquationKind::Affine);
    assert_eq!(flying.parts(ModeNumber(0)), [Part::WHOLE.of_state()]);
    assert_eq!(flying.parts(ModeNumber(1)), []);
}
