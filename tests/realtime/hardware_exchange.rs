//! The exchange with the boards alone, on good and faulty wires.

use boards::links::faulty::{Chance, FaultPlan, LinkFault};
use firmware_protocol::key::BoardId;
use scheduler::motion::{KEYS, KeySample, KeySlope};
use scheduler::port::KeyBus as _;

use crate::stage::{keybed, play_all, scene};
use crate::tick::WATCHED;
use crate::trap;

#[track_caller]
fn check(plan: &FaultPlan) {
    let watch = trap::watch();
    let mut keybed = keybed(&scene("springs", &[]));
    play_all(&mut keybed, 4.0);
    for (board, seed) in BoardId::all().zip(1..) {
        keybed.disturb(board, FaultPlan { seed, ..plan.clone() });
    }
    let mut samples = Box::new([KeySample::default(); KEYS]);
    let mut deepest = 0.0_f64;
    trap::within(|| {
        for tick in 0..WATCHED.end {
            keybed.receive(tick, &mut samples);
            let forces = samples.map(|sample| 200.0 * sample.position);
            keybed.send(tick, &forces, &[KeySlope::HELD; KEYS]);
            deepest = samples.iter().fold(deepest, |most, sample| most.max(sample.position));
        }
    });
    assert_eq!(watch.caught(), (0, 0), "{plan:?}");
    assert!(5e-3 < deepest, "the keys were played");
}

#[test]
fn an_exchange_leaves_the_heap_alone() {
    check(&FaultPlan::default());
}

#[test]
fn an_exchange_on_a_bad_wire_leaves_the_heap_alone() {
    let faults = [
        LinkFault::Drop,
        LinkFault::Duplicate,
        LinkFault::FlipBit,
        LinkFault::Delay(7),
        LinkFault::Down,
    ];
    let chances = faults.map(|fault| Chance { probability: 0.05, fault }).to_vec();
    check(&FaultPlan { chances, ..FaultPlan::default() });
}
