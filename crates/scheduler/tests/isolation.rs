//! A failing voice leaves the others unchanged, to the last bit.

use scheduler::motion::KEYS;
use scheduler::slot::Slot;

use crate::rig::{Failure, Rig, Spring, spring};

/// Ticks of a run; key 40 fails in the middle.
const TICKS: u64 = 200;

#[track_caller]
fn check_neighbours(disturb: impl FnOnce(&mut Rig)) {
    let (mut healthy, mut disturbed) = (Rig::new(), Rig::new());
    disturb(&mut disturbed);
    let mut differed = false;
    for tick in 0..TICKS {
        let (expected, forces) = (healthy.forces_of(tick), disturbed.forces_of(tick));
        for key in 0..KEYS {
            let same = expected[key].to_bits() == forces[key].to_bits();
            assert!(same || key == 40, "tick {tick}: key {key} noticed");
            differed |= !same;
        }
    }
    assert!(differed, "key 40 was not disturbed at all");
}

fn failing(failure: Failure) -> Slot<Spring> {
    Slot::new(40, Spring { fails: Some((60, 63, failure)), ..spring(40) })
}

#[test]
fn a_fault_stays_with_its_key_also_where_nobody_noticed_that_a_force_is_nan() {
    for failure in [Failure::Reported, Failure::Unnoticed] {
        check_neighbours(|rig| rig.slots[40] = failing(failure));
    }
}

#[test]
fn a_fault_is_counted_in_the_tick_in_which_it_happens() {
    let mut rig = Rig::new();
    rig.slots[40] = failing(Failure::Unnoticed);
    for tick in 0..TICKS {
        let faults = rig.poll_at(1000 * tick).unwrap().voices.faults;
        assert_eq!(faults, u32::from((60..63).contains(&tick)), "tick {tick}");
    }
}
