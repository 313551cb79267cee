use instruments::equations::ModeNumber;
use pode::{EquationKind, Model as _, Motion, Part};

use crate::kane::by_hand::pendulum;
use crate::kane::runnable::{BALL, Runnable, runnable};

const STILL: fn(f64) -> Motion = |_| Motion::default();

#[test]
fn natures_follow_from_the_parameters() {
    let swing = ModeNumber(0);
    let free: Runnable<2> = runnable(pendulum::program(), &[]);
    let nature = free.nature(swing);
    assert_eq!(nature.kind, EquationKind::Conservative, "nothing is lost without a damper");
    let rate = (9.81_f64 / 0.5).sqrt();
    assert!((nature.rate - rate).abs() < 1e-9 * rate, "{}", nature.rate);
    assert!((nature.longest_step - 0.75 / rate).abs() < 1e-9);
    let damped: Runnable<2> = runnable(pendulum::program(), &[9.81, 0.5, 0.1]);
    assert_eq!(damped.nature(swing).kind, EquationKind::Smooth);
    let (_, [angle, rate]) = free.at_rest(&STILL(0.0));
    assert!(angle.abs() < 1e-30 && rate == 0.0, "it hangs: {angle:e} {rate}");
    let flying = BALL.model::<4>("default", 0, &[]);
    assert_eq!(flying.nature(ModeNumber(0)).kind, EquationKind::Affine);
    assert_eq!(flying.parts(ModeNumber(0)), [Part::WHOLE.of_state()]);
    assert_eq!(flying.parts(ModeNumber(1)), []);
}
