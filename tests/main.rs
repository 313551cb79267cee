//! Promises of no single crate.
#![expect(clippy::expect_used, clippy::panic, reason = "helpers of tests fail aloud")]

mod any_bytes;
mod architecture;
mod bad_boards;
mod bad_input;
mod configs;
mod daw;
mod descriptions;
mod faults;
mod fidelity;
mod figure6;
mod fit;
mod fuzz;
mod grand;
mod impedance;
mod late_samples;
#[path = "stage/letoff.rs"]
mod letoff;
mod overload;
mod passive;
mod pauses;
mod performance;
mod quiet;
mod readme;
mod references;
mod rooms;
mod sources;
mod stability;
mod stage;
mod trials;
mod watch;
mod ways_in;
mod window;
mod wording;
mod work;
