//! Force on key 40 through the whole tick when its voice or its samples fail.

use scheduler::safety::FADE;
use scheduler::slot::Slot;
use scheduler::time::Period;

use crate::rig::{Failure, HZ, Rig, Spring, spring};

const FADE_TICKS: u32 = 20;

/// Ticks from the first that is held to the first without force.
const SILENT: usize = FADE_TICKS as usize;

#[test]
fn the_fade_of_these_tests_is_the_fade() {
    assert_eq!(Period::from_hz(HZ).unwrap().ticks_in(FADE), u64::from(FADE_TICKS));
}

/// Largest force of the springs (N): 10 mm of travel at the stiffest rate.
const LIMIT: f64 = 0.010 * 800.0;

/// Fastest change of a spring's force (N): the key moves at most 0.1 mm a tick.
const SLEW: f64 = 0.000_1 * 800.0;

/// Returns the force on key 40 in 200 ticks (N).
fn felt(mut rig: Rig) -> [f64; 200] {
    core::array::from_fn(|tick| rig.forces_of(tick as u64)[40])
}

#[track_caller]
fn check_steps(felt: &[f64]) {
    let allowed = 2.0 * SLEW + LIMIT / f64::from(FADE_TICKS);
    for (tick, pair) in felt.windows(2).enumerate() {
        let step = (pair[1] - pair[0]).abs();
        assert!(step <= allowed, "a step of {step} N after tick {tick}");
    }
}

fn failing(failure: Failure, until: u64) -> Rig {
    let mut rig = Rig::new();
    rig.slots[40] = Slot::new(40, Spring { fails: Some((60, until, failure)), ..spring(40) });
    rig
}

#[test]
fn a_voice_that_fails_is_silent_within_the_fade_and_comes_back_without_a_step() {
    for failure in [Failure::Reported, Failure::Unnoticed] {
        let felt = felt(failing(failure, 63));
        check_steps(&felt);
        assert!(felt[60].to_bits() == felt[59].to_bits(), "the first faulty tick holds");
        assert!(felt[60 + SILENT].abs() == 0.0, "the fault reaches zero before the voice returns");
        assert!(felt[120..].iter().any(|force| 0.1 < force.abs()), "the voice is back");
    }
}

#[test]
fn a_voice_that_keeps_failing_is_silent_for_good() {
    for failure in [Failure::Reported, Failure::Unnoticed] {
        let felt = felt(failing(failure, 64));
        check_steps(&felt);
        assert!(felt[60 + SILENT..].iter().all(|force| force.abs() == 0.0), "{failure:?}");
    }
}

#[test]
fn a_voice_that_is_back_is_felt_as_if_nothing_had_been() {
    let mut healthy = Rig::new();
    let mut disturbed = Rig::new();
    disturbed.bus.key_40_silent = 60..62;
    for tick in 0..200 {
        let (expected, forces) = (healthy.forces_of(tick), disturbed.forces_of(tick));
        // The spring's memory of two wrong samples fades by a tenth a tick.
        let back = (expected[40] - forces[40]).abs() < 1e-6;
        assert!(tick < 180 || back, "tick {tick}: {} N, {} N", expected[40], forces[40]);
    }
}

#[test]
fn a_skipped_tick_gives_no_force_step() {
    let mut rig = Rig::new();
    let mut last = 0.0;
    for tick in (0..200).filter(|tick| tick % 7 != 3) {
        let force = rig.forces_of(tick)[40];
        let allowed = 2.0 * (2.0 * SLEW) + LIMIT / f64::from(FADE_TICKS);
        assert!((force - last).abs() <= allowed, "tick {tick}: {last} N to {force} N");
        last = force;
    }
}
