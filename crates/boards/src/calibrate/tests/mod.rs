//! Measurements of computed keys, without boards or clocks.

use haptics::plant::{KeyRig, RigParameters};

use super::trip::Travelled;
use super::{Balance, CalibrationFault, Next, RestMeasurement, Rested, TripMeasurement};

/// Time between two exchanges (s).
const H: f64 = 1e-3;

const RESTED: Rested = Rested { position: 0.0, spread: 0.0 };

/// Lets `advance` push a key; `strength` is per commanded newton, `read` is the sensor.
fn work<T>(
    rig: RigParameters,
    strength: f64,
    read: impl Fn(f64) -> f64,
    mut advance: impl FnMut(f64, f64) -> Result<Next<T>, CalibrationFault>,
) -> Result<T, CalibrationFault> {
    let mut rig = KeyRig::new(rig);
    for tick in 0..100_000 {
        let t = f64::from(tick) * H;
        let push = match advance(t, read(f64::from(rig.counts()) * rig.quantum()))? {
            Next::Push(push) => push,
            Next::Done(done) => return Ok(done),
        };
        rig.advance(t, H, -push * strength, None);
    }
    panic!("it never ended");
}

fn travelled(rig: RigParameters, strength: f64) -> Result<Travelled, CalibrationFault> {
    let mut trip = TripMeasurement::new(&RESTED);
    work(rig, strength, |x| x, |t, x| trip.advance(t, x))
}

fn with(change: impl Fn(&mut RigParameters)) -> RigParameters {
    let mut rig = RigParameters::default();
    change(&mut rig);
    rig
}

#[test]
fn a_key_that_springs_back_by_itself_has_its_friction_and_not_its_spring() {
    let it = travelled(with(|rig| rig.key.weight = 0.5), 1.0).unwrap();
    assert!((it.friction - 0.12).abs() < 0.01 && (it.float - 0.5).abs() < 0.01, "{it:?}");
}

#[test]
fn a_soft_felt_does_not_pass_for_a_key_that_breaks_away() {
    let it = travelled(with(|rig| rig.key.bottom_stop.stiffness = 10e3), 1.0).unwrap();
    // At most 1.5 N on 10 kN/m.
    assert!((10.16e-3..10.31e-3).contains(&it.bottom), "{it:?}");
    assert!((it.friction - 0.12).abs() < 0.015, "{it:?}");
}

#[test]
fn a_key_that_cannot_be_measured_says_why() {
    let jam = with(|rig| rig.key.stiction = 3.0);
    assert!(matches!(travelled(jam, 1.0), Err(CalibrationFault::Stuck { .. })));
    let short = with(|rig| rig.key.bottom_stop.position = 4e-3);
    assert!(matches!(travelled(short, 1.0), Err(CalibrationFault::Short { .. })));
    let long = with(|rig| rig.key.bottom_stop.position = 25e-3);
    assert!(matches!(travelled(long, 1.0), Err(CalibrationFault::RunsAway { .. })));
    let lame = with(|rig| rig.key.weight = -0.3);
    let mut trip = TripMeasurement::new(&RESTED);
    let stuck = work(lame, 0.1, |x| x, |t, x| trip.advance(t, x));
    assert!(matches!(stuck, Err(CalibrationFault::Stays { .. })), "{stuck:?}");
}

#[test]
fn a_sensor_that_reads_wrongly_says_how() {
    let read = |read: fn(f64) -> f64| {
        let mut trip = TripMeasurement::new(&RESTED);
        work(RigParameters::default(), 1.0, read, |t, x| trip.advance(t, x)).unwrap_err()
    };
    assert!(matches!(read(|_| 1e-6), CalibrationFault::Stuck { .. }));
    assert!(matches!(read(|x| -x), CalibrationFault::Backwards { .. }));
    assert!(matches!(read(|x| 3.0 * x), CalibrationFault::RunsAway { .. }));
    assert!(matches!(
        read(|x| if 4e-3 < x { x + 8e-3 } else { x }),
        CalibrationFault::Jumps { .. }
    ));
    assert!(matches!(
        read(|x| if 4e-3 < x { f64::NAN } else { x }),
        CalibrationFault::RunsAway { .. }
    ));
}

#[test]
fn a_key_that_moved_in_a_pause_of_the_host_does_not_jump() {
    let mut trip = TripMeasurement::new(&RESTED);
    trip.advance(0.0, 0.0).unwrap();
    let mut paused = trip;
    assert_eq!(paused.advance(20.0 * H, 6e-3).unwrap_err(), CalibrationFault::Interrupted);
    assert!(matches!(trip.advance(H, 6e-3), Err(CalibrationFault::Jumps { .. })));
}

#[test]
fn a_motor_of_another_strength_is_known_by_the_weight_that_it_balances() {
    for (strength, spring) in [(1.0, 0.0), (0.8, 0.2), (1.25, 0.0)] {
        let empty = travelled(
            with(|rig| (rig.key.weight, rig.key.rest_stop.position) = (spring, 0.0)),
            strength,
        )
        .unwrap();
        // 50 g on the front: they move with it.
        let loaded = with(|rig| {
            rig.key.weight = spring - 0.05 * super::G;
            rig.key.rest_stop.position = 0.0;
            rig.key.mass += 0.05;
        });
        let mut balance = Balance::new(&RESTED, &empty, 0.05);
        let gain = work(loaded, strength, |x| x, |t, x| balance.advance(t, x)).unwrap();
        assert!((gain * strength - 1.0).abs() < 0.03, "{gain} at {strength}");
    }
}

#[test]
fn a_weight_that_is_not_there_is_missed() {
    let empty = travelled(RigParameters::default(), 1.0).unwrap();
    let mut balance = Balance::new(&RESTED, &empty, 0.05);
    let none = work(RigParameters::default(), 1.0, |x| x, |t, x| balance.advance(t, x));
    assert!(matches!(none, Err(CalibrationFault::Floats { .. })), "{none:?}");
}

#[test]
fn a_key_rests_at_the_mean_of_its_readings_unless_they_spread() {
    let rest = |noise: f64| {
        let mut rest = RestMeasurement::default();
        for tick in 0..1_000 {
            let sign = if tick % 2 == 0 { 1.0 } else { -1.0 };
            match rest.advance(f64::from(tick) * H, 1e-3 + sign * noise)? {
                Next::Push(push) => assert!(push.abs() <= 0.0),
                Next::Done(rested) => return Ok(rested),
            }
        }
        panic!("it never ended")
    };
    let rested = rest(5e-6).unwrap();
    assert!((rested.position - 1e-3).abs() < 0.1e-6, "{rested:?}");
    assert!((rested.spread - 10e-6).abs() < 1e-9, "{rested:?}");
    assert!(matches!(rest(60e-6), Err(CalibrationFault::Noisy { .. })));
}
