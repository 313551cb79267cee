//! The models of the program against what every model promises.
#![expect(unreachable_pub, reason = "modules of one program")]
#![expect(
    clippy::disallowed_macros,
    clippy::disallowed_methods,
    clippy::disallowed_types,
    clippy::needless_pass_by_value,
    reason = "a test has the heap, and is handed its models"
)]
#![expect(clippy::expect_used, clippy::unwrap_used, clippy::panic, reason = "a test fails aloud")]
#![expect(clippy::float_cmp, reason = "bits are what is compared")]

mod conformance;
mod drawing;
mod drawing_to_scale;
mod equations;
mod every_model;
mod random;
mod sketch;
mod stroke;
