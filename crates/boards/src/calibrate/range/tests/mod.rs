//! Ranges of simulated keys with known limits, in virtual time.

use haptics::{AnyEstimator, BackwardDifference, SampledWall, plant::RigParameters};
use scheduler::motion::KeySlope;

use super::super::{CalibrationFault, Next, Rested, Travelled};
use super::{MOST_FORCE, RangeEnd, RangeFound, RangeMeasurement, RangeTerms, RangedObject, STEP};
use crate::sim::key::SimulatedKey;

fn rig(damping: f64, delay_steps: usize) -> RigParameters {
    let mut rig = RigParameters::default();
    rig.key.damping = damping;
    rig.motor.delay_steps = delay_steps;
    rig.motor.bandwidth = f64::INFINITY;
    rig
}

fn measurement(object: RangedObject, rig: &RigParameters, period: f64) -> RangeMeasurement {
    let rested = Rested { position: 0.0, spread: 0.0 };
    let bottom = rig.key.bottom_stop.position;
    let travelled = Travelled { bottom, friction: rig.key.stiction, float: rig.key.weight };
    let estimator = AnyEstimator::BackwardDifference(BackwardDifference::new(period));
    let terms = RangeTerms { period, limit: MOST_FORCE, estimator };
    RangeMeasurement::new(object, terms, &rested, &travelled)
}

/// Measures `object` on a key, in ticks of `period` (s); asserts no force once it shakes.
fn range(object: RangedObject, rig: RigParameters, period: f64) -> RangeFound {
    let mut measurement = measurement(object, &rig, period);
    let mut key = SimulatedKey::new(period, rig).unwrap();
    let delay = rig.motor.delay_steps;
    let mut is_let_go = false;
    for tick in 0.. {
        let sample = key.receive(tick);
        if delay == 0 && is_let_go {
            assert!(key.rig().motor_force().abs() <= 0.0, "tick {tick}");
        }
        match measurement.advance(tick as f64 * period, sample.position).unwrap() {
            Next::Push(push) => key.send(-push, &KeySlope::HELD),
            Next::Done(found) => return found,
        }
        is_let_go = measurement.is_letting_go();
    }
    unreachable!()
}

/// Asserts the stiffest spring of the theory of a rig with this damping (N s/m), delay and encoder
/// at 1 kHz, within one step below and two above: friction counts as some damping.
#[track_caller]
fn check_spring(damping: f64, delay_steps: usize, quantum: f64) {
    let found =
        range(RangedObject::Spring, RigParameters { quantum, ..rig(damping, delay_steps) }, H);
    let delay = delay_steps as f64 * 50e-6;
    let wall = SampledWall { stiffness: 0.0, damping: 0.0, period: H, delay };
    let part = found.good.unwrap() / wall.linear_stiffness(damping);
    assert!((1.0 / STEP..STEP * STEP).contains(&part), "{found:?} is {part} of the theory");
    assert!(matches!(found.end, RangeEnd::Shook(_)), "{found:?}");
}

/// Time between two exchanges (s).
const H: f64 = 1e-3;

#[test]
fn the_stiffest_spring_is_that_of_the_theory() {
    check_spring(0.5, 0, 1e-6);
    check_spring(1.0, 0, 1e-6);
    check_spring(2.0, 0, 1e-5);
    check_spring(1.0, 20, 1e-5);
    check_spring(2.0, 20, 1e-6);
    check_spring(1.0, 40, 1e-6);
}

#[test]
fn without_delay_the_largest_dashpot_and_mass_are_those_of_a_free_mass() {
    // Of m s'' held over T, with backward differences, the characteristic polynomials are
    // z^2 + (k - 1) z + k with k = B T / 2 m, and z^2 + k z + k with k = M / 2 m: both leave the
    // unit circle at k = 1.
    let mass = rig(1.0, 0).key.mass;
    for (object, limit) in
        [(RangedObject::Dashpot, 2.0 * mass / H), (RangedObject::Mass, 2.0 * mass)]
    {
        let found = range(object, rig(1.0, 0), H);
        let part = found.good.unwrap() / limit;
        assert!((1.0 / STEP..STEP).contains(&part), "{found:?} is {part} of {limit}");
    }
}

#[test]
fn a_rig_with_more_delay_renders_less_of_everything() {
    for object in RangedObject::ALL {
        let good = [0, 20, 40].map(|delay| range(object, rig(1.0, delay), H).good.unwrap());
        assert!(good[0] > good[1] && good[1] > good[2], "{object:?}: {good:?}");
    }
}

#[test]
fn a_coarse_encoder_leaves_less_of_a_mass() {
    let fine = range(RangedObject::Mass, rig(1.0, 0), H).good.unwrap();
    let rig = RigParameters { quantum: 0.1e-3, ..rig(1.0, 0) };
    let coarse = range(RangedObject::Mass, rig, H).good.unwrap_or(0.0);
    assert!(coarse * STEP < fine, "{coarse} of {fine} kg");
}

#[test]
fn a_key_that_goes_where_no_key_goes_ends_it() {
    let mut measurement = measurement(RangedObject::Spring, &RigParameters::default(), H);
    assert!(matches!(measurement.advance(0.0, 0.0), Ok(Next::Push(_))));
    // A key moves far in a pause of the host, and not within a tick.
    let mut paused = measurement;
    let fault = paused.advance(20.0 * H, 6e-3).unwrap_err();
    assert_eq!(fault, CalibrationFault::Interrupted);
    let mut jumps = measurement;
    let fault = jumps.advance(H, 6e-3).unwrap_err();
    assert!(matches!(fault, CalibrationFault::Jumps { .. }), "{fault}");
    let fault = measurement.advance(H, f64::NAN).unwrap_err();
    assert!(matches!(fault, CalibrationFault::RunsAway { .. }), "{fault}");
}
