//! Every tick keeps its promises for every model, input and limits.
//!
//! The twin of `fuzz/`, for seconds instead of hours: the same model of arbitrary bytes.
#![allow(clippy::disallowed_macros, reason = "a test may use the heap")]
#![allow(clippy::wildcard_imports, reason = "the list of methods is `every_stepper`")]

#[path = "common/adversary/mod.rs"]
mod adversary;
#[path = "common/heap.rs"]
mod heap;

use adversary::promises::check;
use pode::stepper::*;
use pode::{Advance, Cap, Fault};
use proptest::collection::vec;
use proptest::prelude::*;
use proptest::strategy::ValueTree as _;
use proptest::test_runner::TestRunner;

const SESSION: usize = 500;

macro_rules! sessions {
    ($($name:ident: $stepper:ty = $value:expr,)+) => {
        proptest! {
            #![proptest_config(ProptestConfig {
                cases: 1000,
                failure_persistence: None,
                ..ProptestConfig::default()
            })]
            $(
                #[test]
                fn $name(bytes in vec(any::<u8>(), SESSION)) {
                    check::<$stepper>(&bytes, $value, heap::calls);
                }
            )+
        }
    };
}

every_stepper!(sessions);

#[test]
fn sessions_end_in_every_way_that_there_is() {
    let mut ways = [
        (Advance::Completed, 0),
        (Advance::Capped(Cap::Events), 0),
        (Advance::Capped(Cap::Cascade), 0),
        (Advance::Capped(Cap::Guards), 0),
        (Advance::Capped(Cap::Pieces), 0),
        (Advance::Faulty(Fault::Period), 0),
        (Advance::Faulty(Fault::State), 0),
        (Advance::Faulty(Fault::Guard), 0),
        (Advance::Faulty(Fault::Readout), 0),
    ];
    let (mut moves, mut certain) = (0, 0);
    let mut runner = TestRunner::deterministic();
    for _ in 0..1000 {
        let bytes = vec(any::<u8>(), SESSION).new_tree(&mut runner).expect("bytes").current();
        for report in check::<Rk4>(&bytes, Rk4, heap::calls) {
            moves += report.moves;
            certain += report.tick.work.certain;
            ways.iter_mut().filter(|it| it.0 == report.tick.advance).for_each(|it| it.1 += 1);
        }
    }
    // A hundredth of 8000 ticks, or the sessions prove nothing.
    assert!(ways.iter().all(|(_, times)| *times > 80), "{ways:?}");
    assert!(moves > 80 && certain > 80, "{moves} moves, {certain} certain steps");
}
