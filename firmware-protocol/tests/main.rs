//! The wire format against golden bytes, C, and other versions of itself.
#![expect(
    clippy::disallowed_macros,
    clippy::disallowed_methods,
    clippy::disallowed_types,
    clippy::expect_used,
    clippy::panic,
    reason = "tests run on the host, and their helpers fail aloud"
)]

mod any_bytes;
mod c_codec;
#[expect(dead_code, reason = "its main is for people")]
#[path = "../examples/c_header.rs"]
mod c_header;
mod document;
mod evolution;
#[path = "support/random.rs"]
mod random;
mod rig;
#[path = "support/rig.rs"]
mod rig_host;
#[path = "support/tools.rs"]
mod tools;
#[path = "support/vector.rs"]
mod vector;
mod vectors;
