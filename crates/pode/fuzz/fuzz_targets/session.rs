//! A session of eight ticks with a model, inputs and limits out of arbitrary bytes, against
//! everything that a tick promises. The twin of `tests/fuzzed.rs`, of the same parts.
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
        /// One session for each method.
        const SESSIONS: &[fn(&[u8])] = &[$(|bytes| {
            check::<$stepper>(bytes, $value, heap::calls);
        }),+];
    };
}

every_stepper!(sessions);

fuzz_target!(|bytes: &[u8]| {
    // The last byte says which method, so that the others keep their meaning.
    let Some((method, bytes)) = bytes.split_last() else { return };
    SESSIONS[usize::from(*method) % SESSIONS.len()](bytes);
});
