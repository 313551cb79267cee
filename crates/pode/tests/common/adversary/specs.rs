//! Lists of guards, sound and not.

use pode::GuardSpec;

const A: GuardSpec = GuardSpec::new(0, "a");
const B: GuardSpec = GuardSpec::new(1, "b");
const C: GuardSpec = GuardSpec::new(2, "c");
const D: GuardSpec = GuardSpec::new(3, "d");
const E: GuardSpec = GuardSpec::new(4, "e");
const F: GuardSpec = GuardSpec::new(5, "f");
const G: GuardSpec = GuardSpec::new(6, "g");
const H: GuardSpec = GuardSpec::new(7, "h");

pub const LISTS: [&[GuardSpec]; 11] = [
    &[A],
    &[A.on_crossing()],
    &[A, B.on_crossing()],
    &[A, B, C, D],
    &[A.on_crossing(), B.on_crossing(), C.on_crossing(), D.on_crossing()],
    &[A, B.on_crossing(), C, D.on_crossing(), E, F.on_crossing(), G, H.on_crossing()],
    &[A.of_state(), B.of_state().on_crossing()],
    &[
        A.scaled(f64::NAN),
        B.scaled(f64::INFINITY),
        C.scaled(-1.0),
        D.scaled(0.0).on_crossing(),
        E.scaled(1e300),
        F.scaled(f64::NEG_INFINITY).on_crossing(),
    ],
    // Twins, and the last of all names.
    &[A, A.on_crossing(), B.with_priority(0), GuardSpec::new(255, "z")],
    &[],
    &[A, B, C, D, E, F, G, H, GuardSpec::new(8, "i")],
];
