//! A session of eight ticks with a model, inputs and limits from arbitrary bytes, against every
//! promise of a tick. The twin of `tests/fuzzed.rs`, built from the same modules.
#![no_main]

#[path = "../../tests/common/adversary/mod.rs"]
mod adversary;
#[path = "../../tests/common/heap.rs"]
mod heap;

use adversary::promises::check;
use libfuzzer_sys::fuzz_target;
use pode::stepper::*;

macro_rules! sessions {
    ($($name:ident: $stepper:ty = $value:expr,)+) => {
        const SESSIONS: &[fn(&[u8])] = &[$(|bytes| {
            check::<$stepper>(bytes, $value, heap::calls);
        }),+];
    };
}

every_stepper!(sessions);

fuzz_target!(|bytes: &[u8]| {
    // The last byte selects the method, so that the others keep their meaning.
    let Some((method, bytes)) = bytes.split_last() else { return };
    SESSIONS[usize::from(*method) % SESSIONS.len()](bytes);
});
