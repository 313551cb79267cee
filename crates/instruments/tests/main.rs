//! The models of the program against what every model promises.
#![expect(unreachable_pub, reason = "modules of one program")]
#![expect(
    clippy::disallowed_macros,
    clippy::disallowed_methods,
    clippy::disallowed_types,
    reason = "a test has the heap"
)]
#![expect(clippy::expect_used, clippy::unwrap_used, clippy::panic, reason = "a test fails aloud")]
#![expect(clippy::excessive_nesting, reason = "loops over models, modes and their guards")]
#![expect(clippy::float_cmp, reason = "bits are what is compared")]

mod conformance;
mod drawing;
mod drawing_to_scale;
mod equations;
mod every_model;
mod random;
mod sketch;
mod stroke;
