//! A method chosen at run time does the same as the method itself, to the last bit.

use pode::stepper::{
    Any, BogackiShampine, ByNeed, Controlled, Dop853, Exact, Rk4, Tolerance, Tsitouras5,
};
use pode::{Limits, Simulator, Stepper, Tick};

use crate::common::{Ball, BallMode, run};

fn ticks<T: Stepper>(stepper: T) -> (Vec<Tick>, Vec<u64>) {
    let ball = Ball { restitution: 0.8, mass: 1.0 };
    let start = Simulator::new(ball, stepper, Limits::default(), BallMode::Flight, [1.0, 0.0]);
    let (recorder, ticks) = run(&mut { start }, 7e-3, 1.0 / 3.0, 4.2);
    (ticks, recorder.times().iter().map(|t| t.to_bits()).collect())
}

#[track_caller]
fn check<T: Stepper>(stepper: T, any: Any) {
    assert_eq!(any.name(), T::NAME);
    let (alone, chosen) = (ticks(stepper), ticks(any));
    assert_eq!(alone.1, chosen.1, "{}: events", T::NAME);
    let odd = alone.0.iter().zip(&chosen.0).position(|(a, b)| a != b);
    assert_eq!(odd, None, "{}: {:?}", T::NAME, odd.map(|n| (alone.0[n], chosen.0[n])));
}

#[test]
fn chosen_by_name_a_method_is_itself_to_the_last_bit() {
    let named = |name| Any::named(name).expect("a method");
    check(Rk4, named("rk4"));
    check(BogackiShampine, named("bogacki-shampine"));
    check(Tsitouras5, named("tsitouras5"));
    check(Dop853, named("dop853"));
    check(Exact, named("exact"));
    check(ByNeed::default(), named("by-need"));
}

#[test]
fn with_a_tolerance_too() {
    let tolerance = Tolerance::both(1e-9);
    let named = |name| Any::named(name).and_then(|it| it.with_tolerance(1e-9, 7e-3));
    check(Controlled { method: Dop853, tolerance }, named("dop853").expect("it has one"));
    let method = BogackiShampine;
    check(Controlled { method, tolerance }, named("bogacki-shampine").expect("it has one"));
    check(ByNeed::new(1e-9, 7e-3), named("by-need").expect("it has one"));
    assert_eq!(named("heun"), None);
}
